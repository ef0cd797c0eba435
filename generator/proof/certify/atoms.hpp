// SPDX-License-Identifier: GPL-2.0-or-later
// Atoms: the factors and terms into which results are expanded when their size is bounded, such as inputs, an atom
// times a sine, and products of atoms.
#pragma once

#include <deque>
#include <map>
#include <tuple>
#include <utility>

namespace flatdyn {

struct Atom {
  enum class Kind {
    one,
    given,    // an input or a sign: operation `a`
    result,   // the result of operation `a`, with its errors
    turned,   // the sine or cosine of a joint's angle, times atom `a`
    product,  // the product of atoms `a` and `b`
  };
  Kind kind = Kind::one;
  int a = -1, b = -1;
  int joint = -1;
  bool is_cosine = false;
  std::pair<int, int> rank = {-1, 0};  // the latest operation in it, and the number of its other factors
};

class Atoms {
 public:
  static constexpr int kOne = 0;

  Atoms() { numbered({}); }

  // Each of these returns the number of the atom, the same for equal atoms.
  int given(int operation) { return numbered({Atom::Kind::given, operation}); }
  int result(int operation) { return numbered({Atom::Kind::result, operation}); }
  int sine(int joint, bool is_cosine) { return numbered({Atom::Kind::turned, kOne, -1, joint, is_cosine}); }
  // The product of two atoms. Sines go in front: the product of s_1 x and y is s_1 (x y).
  int product(int a, int b);

  const Atom& operator[](int atom) const { return atoms_[static_cast<std::size_t>(atom)]; }
  // Whether the atom has only sines and cosines as factors: 1, s_1, s_1 c_2.
  bool is_purely_trigonometric(int atom) const;
  // Whether two products of sines have no joint in common.
  bool have_no_joint_in_common(int a, int b) const;
  // Whether atom a is later than b in an order in which every atom comes after those that it is made of.
  bool is_later(int a, int b) const { return std::pair(rank(a), a) > std::pair(rank(b), b); }

 private:
  int numbered(Atom atom);
  std::pair<int, int> rank(int atom) const { return (*this)[atom].rank; }

  std::deque<Atom> atoms_;
  std::map<std::tuple<Atom::Kind, int, int, int, bool>, int> number_;
};

}  // namespace flatdyn

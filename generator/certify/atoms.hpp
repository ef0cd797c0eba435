// SPDX-License-Identifier: GPL-2.0-or-later
// What the results of operations are sums of, when their size is bounded: inputs, sines times something, products.
#pragma once

#include <deque>
#include <map>
#include <tuple>
#include <utility>

namespace flatdyn {

struct Atom {
  enum class Kind {
    one,
    given,    // an input or a sign: of operation `a`
    result,   // of operation `a`, with its errors
    turned,   // sine or cosine of a joint's angle, times atom `a`
    product,  // of atoms `a` and `b`
  };
  Kind kind = Kind::one;
  int a = -1, b = -1;
  int joint = -1;
  bool is_cosine = false;
  std::pair<int, int> rank = {-1, 0};  // the latest operation in it, and how many factors it has besides
};

class Atoms {
 public:
  static constexpr int kOne = 0;

  Atoms() { numbered({}); }

  // Each returns the number of the atom; the same for the same one.
  int given(int operation) { return numbered({Atom::Kind::given, operation}); }
  int result(int operation) { return numbered({Atom::Kind::result, operation}); }
  int sine(int joint, bool is_cosine) { return numbered({Atom::Kind::turned, kOne, -1, joint, is_cosine}); }
  // Sines go in front: of s_1 x and y it is s_1 (x y).
  int product(int a, int b);

  const Atom& operator[](int atom) const { return atoms_[static_cast<std::size_t>(atom)]; }
  // Of sines and cosines only: 1, s_1, s_1 c_2.
  bool is_of_sines(int atom) const;
  // Products of sines that have no joint in common.
  bool are_apart(int a, int b) const;
  // What is later has been made of what is not, and never the other way round.
  bool is_later(int a, int b) const { return std::pair(rank(a), a) > std::pair(rank(b), b); }

 private:
  int numbered(Atom atom);
  std::pair<int, int> rank(int atom) const { return (*this)[atom].rank; }

  std::deque<Atom> atoms_;
  std::map<std::tuple<Atom::Kind, int, int, int, bool>, int> number_;
};

}  // namespace flatdyn

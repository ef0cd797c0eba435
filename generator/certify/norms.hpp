// SPDX-License-Identifier: GPL-2.0-or-later
// How large the intermediate results of a function become, proven from norms.
//
// Intervals alone lose a factor of up to 2 at every rotation: |c x + s y| ≤ |x| + |y|. But by Cauchy and Schwarz it is
// at most |(x, y)|, the norm of a vector; and a rotation keeps norms: |(c x - s y, s x + c y)| = |(x, y)|. So the bound
// of a scalar is sought as that of a vector, which grows and shrinks on its way down to the inputs:
//     a vector of sums of products is written out as far as sums go;
//     of the joint i whose sine or cosine is in the latest product, the vector is c_i A + s_i B + C: where an entry of
//     A or B is not zero, its C is split off (|x + y| ≤ |x| + |y|), and what is left is no longer than (A, B), a pair
//     of entries that turn into each other counting once; a product of two unknowns is split off, too: x (y_1, …) is at
//     most max|x| · |(y_1, …)|; at the end there are inputs only, and their limits.
// Roundings are part of it: an operation's result is its exact value and an error of at most half a unit of the last
// place, or any part of that error. So the bounds hold for exact values, for computed ones, and for all in between.
#pragma once

#include <functional>
#include <map>
#include <unordered_map>
#include <vector>

#include "certify/input_limits.hpp"
#include "certify/rounding.hpp"
#include "graph/rational.hpp"
#include "verify/straight_line.hpp"

namespace flatdyn {

// What is known of the errors that operations make.
struct RoundingModel {
  RoundingFormat format;
  double sine_error = 0;                         // of sines and cosines, absolute
  std::function<double(double)> constant_error;  // by literal: how far the scalar is from the model's exact number
};

class Norms {
 public:
  // The first `executed` operations of `lines` are rounded, those that are added to it later are exact.
  Norms(const StraightLine& lines, int executed, RoundingModel model, InputLimits limits);

  // Of operation k: its largest size; its size before it was rounded; and the error that it makes itself, which is that
  // of a sine, of a constant, or of a rounding. Throws Failure(unsupported) for divisions and roots.
  double largest(int k);
  double largest_before_rounding(int k) { return expansion(k).before_rounding; }
  double own_error(int k) { return expansion(k).own_error; }

 private:
  // A sum of coefficient · atom, by atom. Atoms are operations: inputs, sines and products; kOne: the number one.
  using Form = std::vector<std::pair<int, Rational>>;
  using Vector = std::vector<Form>;
  static constexpr int kOne = -1;

  struct Expansion {
    Form form;         // exact
    double slack = 0;  // and what errors add to it
    double before_rounding = 0, own_error = 0;
  };
  // A product of sin or cos of a joint's angle and of an operation (or kOne).
  struct Turned {
    int joint = 0;
    bool is_cosine = false;
    int factor = kOne;
  };
  // Entries of a vector without what is split off.
  struct Split {
    Vector kept, rest;
  };

  struct HashOfVector {
    std::size_t operator()(const Vector& v) const;
  };

  const Expansion& expansion(int k);
  Expansion unrounded(int k);
  Expansion product(int k);
  Expansion scaled(const Rational& c, double error_of_c, int k);
  bool is_rounded(int k) const;
  const Turned* turned(int atom) const;
  // Written out as far as sums go; what errors add goes to `slack`.
  Form written_out(const std::vector<std::pair<int, Rational>>& sum, double& slack);

  double norm(Vector v);
  double norm_of_canonical(const Vector& v);
  double norm_of_inputs(const Vector& v) const;
  double norm_by_rotation(const Vector& v, int joint);
  double norm_by_product(const Vector& v, int factor);

  const StraightLine& lines_;
  int executed_;
  RoundingModel model_;
  InputLimits limits_;
  std::map<int, Expansion> expansions_;
  std::map<int, Turned> turned_;
  std::map<int, double> largest_;
  std::unordered_map<Vector, double, HashOfVector> known_;
};

}  // namespace flatdyn

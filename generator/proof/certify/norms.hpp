// SPDX-License-Identifier: GPL-2.0-or-later
// Proven bounds of the intermediate results of a function, from norms.
//
// Intervals alone lose a factor of up to 2 at every rotation: |c x + s y| ≤ |x| + |y|. But by Cauchy and Schwarz it is
// at most |(x, y)|, the norm of a vector; and a rotation keeps norms: |(c x - s y, s x + c y)| = |(x, y)|. So a scalar
// is bounded by a vector M a, which is transformed on the path down to the inputs; its unknowns a are atoms. The latest
// atom is always replaced first:
//     if it contains the sine or cosine of joint i, the vector is c_i A + s_i B + C; A and B are replaced by a vector
//     without c_i, s_i that is at least as long, and not longer than necessary if A and B turn into each other;
//     a product is multiplied out if one of its factors is a sum, so that terms can cancel; or
//     Σ x_k y_k is no longer than |(x_1, ...)| · |(y_1, ...)|, and a quadratic form of the x_k no longer than its
//     largest eigenvalue times |(x_1, ...)|².
// Where only some rows contain the part that is replaced by x, and also other terms y, |x + y|² ≤ (1 + λ) |x|² + (1 +
// 1/λ) |y|² for any λ > 0. In the end only inputs are left, which have limits. Many results are motions of links, see
// motion_recogniser.hpp. The bounds of these do not depend on the formulation, and where they are smaller, the results
// stay atoms; those of one link are bounded together. Rounding errors are included: an operation's result is its exact
// value plus any part of an error of at most half a unit in the last place. So the bounds hold for exact values, for
// computed ones, and for all in between.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <map>
#include <unordered_map>
#include <vector>

#include "code/readback/straight_line.hpp"
#include "proof/certify/atoms.hpp"
#include "proof/certify/effort.hpp"
#include "proof/certify/input_limits.hpp"
#include "proof/certify/motion_recogniser.hpp"
#include "proof/certify/rounding.hpp"
#include "proof/certify/vector_bounds.hpp"

namespace flatdyn {

// The errors that operations make.
struct RoundingModel {
  RoundingFormat format;
  double sine_error = 0;                         // absolute error of sines and cosines
  std::function<double(double)> constant_error;  // by literal: the scalar's distance from the model's exact number
};

class Norms {
 public:
  // The first `executed` operations of `lines` round; operations that are added later are exact. `motions`, if given,
  // must have recognised every operation before it is used here.
  Norms(const StraightLine& lines, int executed, RoundingModel model, InputLimits limits,
        const MotionRecogniser* motions = nullptr, int effort = kUsualEffort);

  // Bounds of operation k: its size, its size before rounding, and its own error (of a sine, of a constant, or of a
  // rounding). Throws Failure(unsupported) for divisions and roots.
  double largest(int k) { return largest(k, INFINITY); }
  double largest(int k, double known);  // with a bound that is known already
  double largest_before_rounding(int k) { return expansion(k).before_rounding; }
  double own_error(int k) { return expansion(k).own_error; }

  // Smaller sizes other than 0 are raised to this one, so that products of sizes do not underflow.
  static constexpr double kLeastSize = 1e-140;

  // A bound of the length of the vector of several results; more effort makes it tighter.
  double largest_length(const std::vector<int>& operations) { return largest_length(operations, effort_); }
  double largest_length(const std::vector<int>& operations, int effort);

  // Whether both results may be components of one turning vector: their sums have terms with the same factor, turned by
  // the same joint.
  bool may_rotate_together(int j, int k);

 private:
  // A sum of coefficient · atom, by atom.
  using Form = std::vector<std::pair<int, double>>;
  struct Expansion {
    Form form;
    double slack = 0;  // bound of the errors added to the form, including those of coefficients
    double before_rounding = 0, own_error = 0;
    bool has_all_errors = false;  // the form is the result itself, with its errors
  };
  // A result as a factor of a product: a multiple of an atom.
  struct Factor {
    int atom = 0;
    double coefficient = 1;
  };
  // The vector of · φ, where φ_k is the atom divided by its largest size.
  struct Vector {
    std::vector<int> atoms;
    Eigen::MatrixXd of;
  };
  // A vector, and a bound of the errors' contribution to its length.
  struct BoundedVector {
    Vector vector;
    double slack = 0;
  };
  // A vector's rows, rotated so that as few as possible contain the chosen atoms.
  struct Chosen {
    std::vector<int> atoms, others;
    GatheredRows rows;
  };
  // A result's largest size, and its largest distance from the exact result.
  struct Deviation {
    double size = 0, error = 0;
  };
  struct HashOfKey {
    std::size_t operator()(const std::vector<int>& key) const;
  };
  struct Known {
    int effort = 0;
    double norm = 0;
  };

  // norms.cpp: operations.
  const Expansion& expansion(int k);
  Expansion unrounded(int k);
  Expansion product(int k);
  Expansion scaled(double c, double error_of_c, int k);
  void bound(int k, Expansion& expansion);
  double largest_by_operands(int k);
  double largest_of_motion(int k);
  const Deviation& deviation(int k);
  Deviation deviation_before_rounding(int k);
  Expansion distributed(const Expansion& sines, int k);
  Factor factor(int k);
  bool is_rounded(int k) const;
  bool is_purely_trigonometric(const Form& form) const;
  void add(Expansion& to, double c, const Form& form);
  double largest_of(int atom);

  // lengths.cpp: vectors of atoms within their sizes.
  double length(const Vector& v);
  double length_of_motion(const Vector& v);
  Vector part(const Vector& v, const std::vector<Eigen::Index>& places) const;

  // norms_of_results.cpp: vectors of results.
  double norm(const std::vector<Form>& rows, int effort);
  double norm(const Form& form) { return norm(std::vector<Form>{form}, effort_); }
  std::vector<int> turned_last(const Form& form) const;

  // norms_of_vectors.cpp: vectors of atoms. `effort`: how many alternatives may be tried.
  double norm(const Vector& v, int effort);
  double norm(const BoundedVector& v, int effort) { return norm(v.vector, effort) + v.slack; }
  double norm_of_unit(const Vector& v, int effort);
  double norm_by_rotation(const Vector& v, int joint, int effort);
  double norm_by_opening(const Vector& v, int factor, int effort);
  double norm_by_factors(const Vector& v, int left, int effort);
  double norm_by_squares(const Vector& v, bool in_units, int effort);
  double norm_of_sum(const Vector& x, const Chosen& chosen, int effort);
  Chosen chosen(const Vector& v, const std::function<bool(const Atom&)>& is_chosen) const;
  int latest(const Vector& v) const;
  int latest_factor(const Vector& v) const;
  BoundedVector substituted(const Vector& v);

  const StraightLine& lines_;
  int executed_;
  RoundingModel model_;
  InputLimits limits_;
  const MotionRecogniser* motions_;
  int effort_;
  Atoms atoms_;
  std::map<int, Expansion> expansions_;
  std::map<int, Deviation> deviations_;
  std::map<int, double> largest_, largest_of_atoms_;
  std::unordered_map<std::vector<int>, Known, HashOfKey> known_;
};

}  // namespace flatdyn

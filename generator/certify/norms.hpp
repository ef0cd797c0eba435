// SPDX-License-Identifier: GPL-2.0-or-later
// How large the intermediate results of a function become, proven from norms.
//
// Intervals alone lose a factor of up to 2 at every rotation: |c x + s y| ≤ |x| + |y|. But by Cauchy and Schwarz it is
// at most |(x, y)|, the norm of a vector; and a rotation keeps norms: |(c x - s y, s x + c y)| = |(x, y)|. So the bound
// of a scalar is sought as that of a vector M a, which changes on its way down to the inputs; its unknowns a are atoms.
// Always the latest one goes:
//     of the joint i whose sine or cosine is in it, the vector is c_i A + s_i B + C; A and B are replaced by a vector
//     without c_i, s_i that is at least as long, and no longer than need be if A and B turn into each other;
//     a product is multiplied out if one of its factors is a sum, so that what cancels is gone; or
//     Σ x_k y_k is no longer than |(x_1, ...)| · |(y_1, ...)|, and a quadratic form of the x_k no longer than its
//     largest eigenvalue times |(x_1, ...)|².
// Where only some rows have what is replaced, by x, and also others, y, |x + y|² ≤ (1 + λ) |x|² + (1 + 1/λ) |y|² for
// any λ > 0. At the end there are inputs only, and their limits.
// Many results are motions of links, see motions.hpp. What is known of these does not depend on the way to them, and
// where it is less they are atoms that are not replaced; those of one link are bounded together.
// Roundings are part of it: an operation's result is its exact value and an error of at most half a unit of the last
// place, or any part of that error. So the bounds hold for exact values, for computed ones, and for all in between.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <map>
#include <unordered_map>
#include <vector>

#include "certify/atoms.hpp"
#include "certify/effort.hpp"
#include "certify/input_limits.hpp"
#include "certify/motions.hpp"
#include "certify/rounding.hpp"
#include "certify/vector_bounds.hpp"
#include "readback/straight_line.hpp"

namespace flatdyn {

// What is known of the errors that operations make.
struct RoundingModel {
  RoundingFormat format;
  double sine_error = 0;                         // of sines and cosines, absolute
  std::function<double(double)> constant_error;  // by literal: how far the scalar is from the model's exact number
};

class Norms {
 public:
  // The first `executed` operations of `lines` are rounded, those that are added to it later are exact. `motions`, if
  // any, has to know of every operation before it is asked for here.
  Norms(const StraightLine& lines, int executed, RoundingModel model, InputLimits limits,
        const Motions* motions = nullptr, int effort = kUsualEffort);

  // Of operation k: its largest size; its size before it was rounded; and the error that it makes itself, which is that
  // of a sine, of a constant, or of a rounding. Throws Failure(unsupported) for divisions and roots.
  double largest(int k) { return largest(k, INFINITY); }
  double largest(int k, double known);  // where it is known to be no larger than that
  double largest_before_rounding(int k) { return expansion(k).before_rounding; }
  double own_error(int k) { return expansion(k).own_error; }

  // What is smaller, but not 0, counts as that large, so that products of sizes do not vanish.
  static constexpr double kLeastSize = 1e-140;

  // Of the vector of several results: its largest length, which the more effort brings nearer to what it is.
  double largest_length(const std::vector<int>& operations) { return largest_length(operations, effort_); }
  double largest_length(const std::vector<int>& operations, int effort);

  // That both may be components of one vector that turns: their sums have terms that one joint turns, of one factor.
  bool turn_together(int j, int k);

 private:
  // A sum of coefficient · atom, by atom.
  using Form = std::vector<std::pair<int, double>>;
  struct Expansion {
    Form form;
    double slack = 0;  // what errors add to it, those of coefficients included
    double before_rounding = 0, own_error = 0;
    bool has_all_errors = false;  // the form itself: it is the result
  };
  // Of a result that is read in a product: a multiple of an atom.
  struct Factor {
    int atom = 0;
    double coefficient = 1;
  };
  // of · φ, φ_k being the atom over its largest size.
  struct Vector {
    std::vector<int> atoms;
    Eigen::MatrixXd of;
  };
  // A vector, and what errors add to its length.
  struct Written {
    Vector vector;
    double slack = 0;
  };
  // A vector's rows, turned so that as few as possible have the chosen atoms.
  struct Chosen {
    std::vector<int> atoms, others;
    GatheredRows rows;
  };
  // Of a result: its largest size, and how far it may be from the exact one.
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
  bool is_of_sines(const Form& form) const;
  void add(Expansion& to, double c, const Form& form);
  double largest_of(int atom);

  // lengths.cpp: of atoms within their sizes.
  double length(const Vector& v);
  double length_of_motion(const Vector& v);
  Vector part(const Vector& v, const std::vector<Eigen::Index>& places) const;

  // norms_of_results.cpp.
  double norm(const std::vector<Form>& rows, int effort);
  double norm(const Form& form) { return norm(std::vector<Form>{form}, effort_); }
  std::vector<int> turned_last(const Form& form) const;

  // norms_of_vectors.cpp. Effort: how many ways may be tried where there are several.
  double norm(const Vector& v, int effort);
  double norm(const Written& v, int effort) { return norm(v.vector, effort) + v.slack; }
  double norm_of_unit(const Vector& v, int effort);
  double norm_by_rotation(const Vector& v, int joint, int effort);
  double norm_by_opening(const Vector& v, int factor, int effort);
  double norm_by_factors(const Vector& v, int left, int effort);
  double norm_by_squares(const Vector& v, bool in_units, int effort);
  double norm_of_sum(const Vector& x, const Chosen& chosen, int effort);
  Chosen chosen(const Vector& v, const std::function<bool(const Atom&)>& is_chosen) const;
  int latest(const Vector& v) const;
  int latest_factor(const Vector& v) const;
  Written written_out(const Vector& v);

  const StraightLine& lines_;
  int executed_;
  RoundingModel model_;
  InputLimits limits_;
  const Motions* motions_;
  int effort_;
  Atoms atoms_;
  std::map<int, Expansion> expansions_;
  std::map<int, Deviation> deviations_;
  std::map<int, double> largest_, largest_of_atoms_;
  std::unordered_map<std::vector<int>, Known, HashOfKey> known_;
};

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Decides from samples whether a quantity is a combination of others with constant coefficients, and finds them.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "graph/mod_p.hpp"

namespace flatdyn {

// The equation y = D c. Whether there is a c is decided in GF(p), where samples are exact; its value is computed from
// samples in double.
class Combinations {
 public:
  using F = ModP<kMersenne61>;
  // Relative error of the vector of all samples; they are right to about 1e-15.
  static constexpr double kSamples = 1e-13;

  // D has a row for each sample, and more rows than columns: with each further one, the probability that y is a
  // combination by chance is 1/p times smaller.
  Combinations(const std::vector<std::vector<F>>& D, const Eigen::MatrixXd& in_double);

  struct Found {
    Eigen::VectorXd coefficients;  // the shortest c
    double error_bound = 0;  // bound of its distance from an exact one, if samples in double are right to kSamples
  };
  std::optional<Found> of(const std::vector<F>& y, const Eigen::VectorXd& in_double) const;

 private:
  int eliminate(const std::vector<std::vector<F>>& D);

  std::vector<std::vector<F>> annihilators_;  // rows n with n D = 0
  Eigen::MatrixXd columns_, inverse_;         // empty: D is too close to a smaller rank
  double size_of_inverse_ = 0;
};

}  // namespace flatdyn

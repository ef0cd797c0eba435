// SPDX-License-Identifier: GPL-2.0-or-later
// Whether a quantity is a combination of others with constant coefficients, and which: from what they are at samples.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "graph/mod_p.hpp"

namespace flatdyn {

// y = D c. That there is a c is decided in GF(p), where samples are exact; what it is, from samples in double.
class Combinations {
 public:
  using F = ModP<kMersenne61>;
  static constexpr double kSamples = 1e-13;  // of the vector of all samples; they are right to some 1e-15

  // A row of D for each sample, which are more than columns: for each one more, chance makes y a combination with
  // probability 1/p.
  Combinations(const std::vector<std::vector<F>>& D, const Eigen::MatrixXd& in_double);

  struct Found {
    Eigen::VectorXd coefficients;  // the shortest c
    double doubt = 0;              // its distance from one that holds, if samples in double are right to kSamples
  };
  std::optional<Found> of(const std::vector<F>& y, const Eigen::VectorXd& in_double) const;

 private:
  int eliminate(const std::vector<std::vector<F>>& D);

  std::vector<std::vector<F>> annihilators_;  // rows n with n D = 0
  Eigen::MatrixXd columns_, inverse_;         // empty: too near to a smaller rank
  double size_of_inverse_ = 0;
};

}  // namespace flatdyn

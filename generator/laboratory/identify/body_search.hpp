// SPDX-License-Identifier: GPL-2.0-or-later
// Minimises |K bodies - target|² / 2 + μ divergence over physically consistent links, with μ small, by Ceres; the
// divergence is its barrier. The problem is convex in the parameters, so no step can lead into a corner.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laboratory/identify/link_shape.hpp"

namespace flatdyn {

class BodySearch {
 public:
  BodySearch(std::vector<LinkShape> links, const Eigen::MatrixXd& K, const Eigen::VectorXd& target);

  // Returns whether the search converged.
  bool run();

  // 13 n parameters, in the order of (7.77).
  Eigen::VectorXd bodies() const;
  // The sum of the links' divergences from the file, without what the file does not have.
  double divergence_from_file() const;

 private:
  bool improve(double weight);
  double divergence() const;
  Eigen::VectorXd shapes() const;
  Eigen::VectorXd residual() const { return K_ * shapes() - target_; }

  std::vector<LinkShape> links_;
  Eigen::VectorXd file_, target_;
  Eigen::MatrixXd K_;
};

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The least of |K bodies - target|² / 2 + μ divergence over links that a body can have, μ small: by Ceres, with the
// divergence as its barrier. It is convex in the parameters, so that no step can lead into a corner.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identify/link_shape.hpp"

namespace flatdyn {

class BodySearch {
 public:
  BodySearch(std::vector<LinkShape> links, const Eigen::MatrixXd& K, const Eigen::VectorXd& target);

  // Whether it came to the end.
  bool run();

  // 13 n, in the order of (7.77).
  Eigen::VectorXd bodies() const;
  double divergence() const;

 private:
  bool improve(double weight);
  Eigen::VectorXd shapes() const;
  Eigen::VectorXd residual() const { return K_ * shapes() - target_; }

  std::vector<LinkShape> links_;
  Eigen::VectorXd file_, target_;
  Eigen::MatrixXd K_;
};

}  // namespace flatdyn

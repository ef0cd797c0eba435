// SPDX-License-Identifier: GPL-2.0-or-later
// Joint positions along a straight line of the tip, and their derivatives by the way along it, analytically: with the
// line's unit vector u (and no turn, if the orientation is held) and the Jacobian J of what is held,
//   q' = J⁺ u,   q'' = −J⁺ J' q' + (I − J⁺ J) J'ᵀ J⁺ᵀ q',   J' = dJ/dq · q',
// J⁺ the pseudo-inverse. The second term is that of the derivative of J⁺ (Golub and Pereyra, 1973) which is left for a
// u that J reaches; it is zero without redundancy. A redundant arm takes the smallest rates, and so its positions
// follow from the start: q' is integrated, and what is left to the line removed.
#pragma once

#include "trajectory/tip_kinematics.hpp"

namespace flatdyn {

struct LinePoint {
  Eigen::VectorXd q, slope, curvature;  // q, q', q'': by metres along the line
};

class TipLine {
 public:
  // From where the tip is at q to `by` further; every place on the way is tried. The two-link arm keeps its posture.
  // `tip` must outlive the line. Throws Unreachable.
  TipLine(const TipKinematics& tip, const Eigen::VectorXd& q, const Eigen::Vector3d& by, bool hold_orientation);

  double length() const { return length_; }
  const Eigen::VectorXd& end() const { return nodes_.back(); }
  // 0 ≤ way ≤ length(). Throws Unreachable.
  LinePoint at(double way) const;

 private:
  int rows() const { return start_.R ? 6 : 3; }
  TipGoal goal(double way) const { return {start_.p + way * u_, start_.R}; }
  Eigen::VectorXd slope(const Eigen::VectorXd& q) const;
  Eigen::VectorXd stepped(const Eigen::VectorXd& q, double from, double to) const;
  double node(std::size_t k) const;

  const TipKinematics& tip_;
  std::optional<TwoLinkArm> arm_;
  TipGoal start_;
  Eigen::Vector3d u_;
  double length_;
  std::vector<Eigen::VectorXd> nodes_;  // q at even distances, ends included
};

}  // namespace flatdyn

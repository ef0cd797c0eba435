// SPDX-License-Identifier: GPL-2.0-or-later
// Joint positions along a straight line of the tip, and their derivatives by the arc length, analytically. With the
// line's unit vector u (with zero rotation, if the orientation is held) and the Jacobian J of the task,
//   q' = J⁺ u,   q'' = −J⁺ J' q' + (I − J⁺ J) J'ᵀ J⁺ᵀ q',   J' = dJ/dq · q',
// where J⁺ is the pseudo-inverse. The second term is the part of the derivative of J⁺ (Golub and Pereyra, 1973) that
// remains for a u in the range of J; it is zero without redundancy. A redundant arm takes the smallest rates, so its
// positions depend on the start: q' is integrated, and the deviation from the line removed.
#pragma once

#include "laboratory/trajectory/tip_kinematics.hpp"

namespace flatdyn {

struct LinePoint {
  Eigen::VectorXd q, slope, curvature;  // q, q', q'': derivatives by metres along the line
};

class TipLine {
 public:
  // The line from the tip's place at q to that plus `by`, m; every place on it is checked. A two-link arm keeps its
  // posture. `tip` must outlive the line. Throws Unreachable.
  TipLine(const TipKinematics& tip, const Eigen::VectorXd& q, const Eigen::Vector3d& by, bool hold_orientation);

  double length() const { return length_; }
  const Eigen::VectorXd& end() const { return nodes_.back(); }
  // The joint positions at arc length `way` in m, 0 ≤ way ≤ length(). Throws Unreachable.
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
  std::vector<Eigen::VectorXd> nodes_;  // q at equal distances, ends included
};

}  // namespace flatdyn

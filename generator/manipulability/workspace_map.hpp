// SPDX-License-Identifier: GPL-2.0-or-later
// Places of the tip on a square grid in a plane, with joint positions for each: what a map of the workspace is drawn
// from.
#pragma once

#include "model/mechanism.hpp"
#include "trajectory/tip_kinematics.hpp"

namespace flatdyn {

struct WorkspaceGrid {
  // 3 × 2: the directions of rows and columns of the grid, unit vectors of the base frame; places are multiples of
  // spacing away from the start.
  Eigen::Matrix<double, 3, 2> directions;
  double spacing = 0;              // m
  bool holds_orientation = false;  // the tip's is that at the start
};

// From the start, which comes first, to places beside ones that are reached, nearest first, each by damped least
// squares from its neighbour's joint positions: so the posture changes as little as it can, and what lies beyond a
// place that is not reached within the limits is found only round it. No further than kFarthestCell places from the
// start.
inline constexpr int kFarthestCell = 60;
std::vector<Eigen::VectorXd> map_workspace(const TipKinematics& tip, const Mechanism& mechanism,
                                           const Eigen::VectorXd& start, const WorkspaceGrid& grid);

// Whether q is within the limits of all joints.
bool is_within_limits(const Mechanism& mechanism, const Eigen::VectorXd& q);

}  // namespace flatdyn

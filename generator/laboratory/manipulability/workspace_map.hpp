// SPDX-License-Identifier: GPL-2.0-or-later
// Places of the tip on a square grid in a plane, with joint positions for each, for a map of the workspace.
#pragma once

#include "laboratory/trajectory/tip_kinematics.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

struct WorkspaceGrid {
  // 3 × 2: the directions of rows and columns of the grid as unit vectors of the base frame; distances from the start
  // are multiples of `spacing`.
  Eigen::Matrix<double, 3, 2> directions;
  double spacing = 0;              // m
  bool holds_orientation = false;  // the tip keeps its orientation at the start
};

// The places reached, the start first, then neighbours of reached places, nearest first. Each place's joint positions
// come by damped least squares from its neighbour's, so the posture changes as little as possible, and a place behind
// one that is not reached within the limits is found only by a way round it. No place is more than kFarthestCell cells
// from the start. q is that of the mechanism, with a quaternion for each spherical joint.
inline constexpr int kFarthestCell = 60;
std::vector<Eigen::VectorXd> map_workspace(const TipKinematics& tip, const Mechanism& mechanism,
                                           const Eigen::VectorXd& start, const WorkspaceGrid& grid);

// Whether q, rad or m, is within the limits of all joints. Spherical joints have none.
bool is_within_limits(const Mechanism& mechanism, const Eigen::VectorXd& q);

}  // namespace flatdyn

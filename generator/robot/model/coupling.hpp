// SPDX-License-Identifier: GPL-2.0-or-later
// The positions of a robot's moving joints as functions of its coordinates q, where joints are coupled.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// offset + Σ factor · coordinate; each coordinate is given by the joint that it belongs to (index in the robot).
struct LinearPosition {
  std::map<int, Number> factors;
  Number offset = 0;  // rad or m

  bool is_constant() const { return factors.empty(); }
};

// Reports joints that are named but do not exist, and joints that follow themselves through others. Returns whether
// there are neither.
bool validate_couplings(const Robot& robot, Diagnostics& diagnostics);

// Reports factors that are larger than numbers may be, or that would leave an angle too few digits (1e6 for revolute
// joints). The couplings must be valid.
void refuse_factors(const Robot& robot, Diagnostics& diagnostics);

// The factor of a joint's own coordinate in its position; 0 if it has none.
Number own_factor(const std::string& joint, const Coupled& coupled);

// The moving joints that have a coordinate, in depth-first file order: the order of q. The tree must be valid.
std::vector<int> joints_with_coordinates(const Robot& robot);

// Whether a moving joint is `coupled`: its position is a combination of coordinates.
bool has_coupled_joints(const Robot& robot);

// The position of every joint of the robot; a constant for joints that do not move. The couplings must be valid.
std::vector<LinearPosition> joint_positions(const Robot& robot);

}  // namespace flatdyn

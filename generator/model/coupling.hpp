// SPDX-License-Identifier: GPL-2.0-or-later
// How the positions of a robot's moving joints follow from its coordinates q, where joints are coupled.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "diagnostics/diagnostics.hpp"
#include "model/robot.hpp"

namespace flatdyn {

// offset + Σ factor · coordinate, the coordinates by the joints that they belong to (indices in the robot).
struct LinearPosition {
  std::map<int, Number> factors;
  Number offset = 0;  // rad or m

  bool is_constant() const { return factors.empty(); }
};

// Whether joints that are named exist, and no joint follows itself through others.
bool validate_couplings(const Robot& robot, Diagnostics& diagnostics);

// No factor is beyond what numbers may be, or what leaves an angle its digits: of joints that turn, 1e6. For couplings
// that are valid.
void refuse_factors(const Robot& robot, Diagnostics& diagnostics);

// By how much of a joint's own coordinate it moves; 0 if it has none.
Number own_factor(const std::string& joint, const Coupled& coupled);

// The moving joints that have a coordinate, in depth-first file order: the order of q. Defined for a valid tree.
std::vector<int> joints_with_coordinates(const Robot& robot);

bool has_coupled_joints(const Robot& robot);

// Of every joint of the robot, of those that do not move a constant. Defined for valid couplings.
std::vector<LinearPosition> joint_positions(const Robot& robot);

}  // namespace flatdyn

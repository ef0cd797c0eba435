// SPDX-License-Identifier: GPL-2.0-or-later
// How the positions of a robot's moving joints follow from its coordinates q, where joints are coupled.
#pragma once

#include <map>
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

// Sines and cosines are those of coordinates: of fractions of a coordinate they cannot be made of them. For couplings
// that are valid.
void refuse_fractions(const Robot& robot, Diagnostics& diagnostics);

// The moving joints that have a coordinate, in depth-first file order: the order of q. Defined for a valid tree.
std::vector<int> joints_with_coordinates(const Robot& robot);

bool has_coupled_joints(const Robot& robot);

// Of a moving joint. Defined for valid couplings.
LinearPosition position_of(const Robot& robot, int joint);

// Of the coordinate that belongs to a joint: the limits of all joints that follow it alone, this one among them if its
// position does; effort as that of its own drive.
Limits coordinate_limits(const Robot& robot, int owner);

// Coordinates move the joints independently, and limits leave them room. Limits that bound no single coordinate are
// noted.
void check_coordinates(const Robot& robot, Diagnostics& diagnostics);

}  // namespace flatdyn

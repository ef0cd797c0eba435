// SPDX-License-Identifier: GPL-2.0-or-later
// The bodies of a robot file in the frames of its mechanism, as part of the comparison in as_read_numbers.hpp.
#pragma once

#include <vector>

#include "truth/definition/as_read_numbers.hpp"

namespace flatdyn {

// A robot as written and as found, in numbers that were drawn for its symbols and coordinates.
struct BothSides {
  const Robot& robot;
  const Mechanism& mechanism;
  const RealNumbers& numbers;
  RealArithmetic<Digits100>& arithmetic;
  const MechanismOver<Digits100>& found;
  const std::vector<int>& moving;               // the moving joints of the robot
  const std::vector<std::size_t>& last_bodies;  // by moving joint: the body that it moves
  const Digits100& reach;                       // the sum of all lengths as written, m
};

// Compares the inertial parameters of the base, of all that each joint moves, and of each link: the form
// ½ (v, ω)ᵀ M (v, ω) of kinetic energy is the sum of those of the bodies and rotors as written.
void compare_bodies(const BothSides& sides, Differences& differences);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// q̈ by articulated bodies (Featherstone, "The calculation of robot dynamics using articulated-body inertias", 1983): in
// a number of operations that grows with the number of joints only, where factorising B grows with its cube.
#pragma once

#include "symbolic/dynamics/newton_euler.hpp"

namespace flatdyn {

struct ArticulatedSolution {
  std::vector<Number> qdd;
  std::vector<Number> pivots;  // inertia that each joint feels: all positive if and only if B is
};

// Every rotor must be on the link before its joint, or on the base.
bool has_articulated_form(const Mechanism& mechanism);

// q̈ of B q̈ + C q̇ + g + friction = τ. Throws Failure(unsupported) if a pivot is exactly zero.
ArticulatedSolution articulated_accelerations(Frames& frames, const Motion& motion, const std::vector<Number>& tau);

}  // namespace flatdyn

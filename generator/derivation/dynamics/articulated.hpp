// SPDX-License-Identifier: GPL-2.0-or-later
// Accelerations q̈ by articulated bodies (Featherstone, "The calculation of robot dynamics using articulated-body
// inertias", 1983). The number of operations grows linearly with the number of joints, whereas that of a factorisation
// of B grows with its cube.
#pragma once

#include "derivation/dynamics/newton_euler.hpp"

namespace flatdyn {

struct ArticulatedSolution {
  std::vector<Number> qdd;
  std::vector<Number> pivots;  // the inertia at each joint: all are positive if and only if B is positive definite
};

// Whether every rotor is on the link before its joint, or on the base, as the method requires.
bool has_articulated_form(const Mechanism& mechanism);

// The solution q̈ of B q̈ + C q̇ + g + friction = τ. Throws Failure(unsupported) if a pivot is exactly zero.
ArticulatedSolution articulated_accelerations(Frames& frames, const Motion& motion, const std::vector<Number>& tau);

}  // namespace flatdyn

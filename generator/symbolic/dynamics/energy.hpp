// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "symbolic/dynamics/newton_euler.hpp"

namespace flatdyn {

// T of (7.31), rotors included, J.
Number kinetic_energy(Frames& frames);

// U of (7.36), zero for a mass at the base frame's origin, J.
Number potential_energy(Frames& frames);

// g(q) of (7.39): the derivatives of U. What a joint carries has one first moment, so that no link's force is needed.
std::vector<Number> gravity_torques(Frames& frames);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "derivation/dynamics/newton_euler.hpp"

namespace flatdyn {

// The kinetic energy T of (7.31), rotors included, J.
Number kinetic_energy(Frames& frames);

// The potential energy U of (7.36), zero for a mass at the base frame's origin, J.
Number potential_energy(Frames& frames);

// The gravity torques g(q) of (7.39), the derivatives of U. Only the first moment of each composite body is needed, not
// the forces on links.
std::vector<Number> gravity_torques(Frames& frames);

}  // namespace flatdyn

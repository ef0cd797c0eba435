// SPDX-License-Identifier: GPL-2.0-or-later
// Momentum and centre of mass of a robot with a floating base, in base axes (Orin, Goswami and Lee, "Centroidal
// dynamics of a humanoid robot", 2013). They follow from the base's rows of B and of the bias, which are about the base
// frame's origin: the moment about the centre of mass, at r_G, is n - r_G × f. They are those of the links: the
// armature of a floating base is left out.
#pragma once

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

// A_G, 6 × (6 + n): momentum, then moment of momentum about the centre of mass, by v.
Function derive_centroidal_momentum_matrix(const Mechanism& mechanism, const Choices& choices);

// The rates of change of both, for an observer at rest, that v causes while its derivative is zero: Ȧ_G v.
Function derive_centroidal_bias(const Mechanism& mechanism, const Choices& choices);

// r_G, from the base frame's origin, and the Jacobian of its velocity, 3 × (6 + n).
Function derive_centre_of_mass(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn

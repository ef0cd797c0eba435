// SPDX-License-Identifier: GPL-2.0-or-later
// Joint torques as functions: inverse dynamics, gravity and the bias.
#pragma once

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

Function derive_inverse_dynamics(const Mechanism& mechanism, const Choices& choices);
// With the wrench h_e that the tip exerts on its environment.
Function derive_inverse_dynamics_tip_force(const Mechanism& mechanism, const Choices& choices);
// Jᵀ h_e of a wrench that a link exerts on its environment.
Function derive_external_torque(const Mechanism& mechanism, const LinkFrame& link);
Function derive_gravity(const Mechanism& mechanism, const Choices& choices);
Function derive_bias(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn

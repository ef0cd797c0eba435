// SPDX-License-Identifier: GPL-2.0-or-later
// Forward dynamics as a function, in three formulations, and inverse dynamics of a robot that nothing touches.
#pragma once

#include <optional>

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

Function derive_forward_dynamics(const Mechanism& mechanism, const Choices& choices);
// nullopt for robots for which the formulation does not exist, or if the choices guard pivots.
std::optional<Function> derive_forward_dynamics_by_articulated_bodies(const Mechanism& mechanism,
                                                                      const Choices& choices);
// nullopt for robots with prismatic joints or closed loops.
std::optional<Function> derive_forward_dynamics_by_composite_bodies(const Mechanism& mechanism, const Choices& choices);

// The acceleration of a floating base on which no force acts, and the torques for given accelerations of the joints.
Function derive_inverse_dynamics_floating(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn

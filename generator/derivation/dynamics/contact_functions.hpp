// SPDX-License-Identifier: GPL-2.0-or-later
// Functions of a robot whose links touch something that does not move, at the scene's contacts (contacts.hpp). Forces
// are those on the robot, in base axes, in the order of the contacts' rows; nothing keeps them from pulling.
#pragma once

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

// The contacts' positions and their Jacobian.
Function derive_contact_jacobian(const Mechanism& mechanism, const Choices& choices);

// The contacts' accelerations while q̈ is zero: J̇ q̇.
Function derive_contact_bias(const Mechanism& mechanism, const Choices& choices);

// q̈ and the contacts' forces for given joint torques, with contacts that are not accelerated.
Function derive_constrained_forward_dynamics(const Mechanism& mechanism, const Choices& choices);

// q̈ and the forces, and how they change with torques and with the contacts' drift (ContactSpace::Sensitivities).
Function derive_held_motion_and_sensitivities(const Mechanism& mechanism, const Choices& choices);

// Joint torques for a given motion of a robot with a floating base, and those forces at the contacts that are the
// smallest, Σ |f|² + |n|² in N and N m: the base's force and moment are distributed as if every contact were a point of
// the same mass.
Function derive_contact_inverse_dynamics(const Mechanism& mechanism, const Choices& choices);

// The velocity after an impact that stops all contacts at once, and the impulses.
Function derive_contact_impact(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn

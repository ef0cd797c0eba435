// SPDX-License-Identifier: GPL-2.0-or-later
// Dynamics by the recursive Newton–Euler reference.
#pragma once

#include "truth/reference/numeric_reference.hpp"

namespace flatdyn::references {

extern const NumericReference inverse_dynamics, inverse_dynamics_tip_force, inertia_matrix, christoffel,
    coriolis_matrix, gravity, bias, forward_dynamics, inverse_dynamics_floating, momentum, coriolis_transpose_qd,
    kinetic_energy, potential_energy, drive_torque, torque_from_drive;

}  // namespace flatdyn::references

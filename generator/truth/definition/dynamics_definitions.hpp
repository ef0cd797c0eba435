// SPDX-License-Identifier: GPL-2.0-or-later
// Dynamics by Lagrange's equations, whose numbers lagrangian.hpp cites.
#pragma once

#include "truth/definition/definition.hpp"

namespace flatdyn::definitions {

extern const Definition inverse_dynamics, inverse_dynamics_tip_force, inertia_matrix, christoffel, coriolis_matrix,
    gravity, bias, forward_dynamics, inverse_dynamics_floating, momentum, coriolis_transpose_qd, kinetic_energy,
    potential_energy, drive_torque, torque_from_drive;

}  // namespace flatdyn::definitions

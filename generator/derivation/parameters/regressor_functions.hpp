// SPDX-License-Identifier: GPL-2.0-or-later
// The functions of the table that are linear in the dynamic parameters. Columns of Y_b and entries of π_b are those of
// base_parameters(mechanism).
#pragma once

#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Y with all columns, from q, q̇, q̈.
Function derive_regressor(const Mechanism& mechanism);
// Y_b, the columns of Y for the base parameters.
Function derive_base_regressor(const Mechanism& mechanism);
Function derive_base_parameters(const Mechanism& mechanism);  // π_b, from the free symbols
// τ = Y_b π_b.
Function derive_inverse_dynamics_base(const Mechanism& mechanism);
// Y_b of the torques B q̈_r + C(q, q̇) q̇_r + g + friction at q̇_r.
Function derive_adaptive_regressor(const Mechanism& mechanism);

// Y_s with the torques k q - k q_0 of all joints' springs: two columns for each joint, for k and k q_0, whether the
// robot file gives it a spring or not.
Function derive_spring_regressor(const Mechanism& mechanism);

}  // namespace flatdyn

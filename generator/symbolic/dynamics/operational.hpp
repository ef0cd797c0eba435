// SPDX-License-Identifier: GPL-2.0-or-later
// Dynamics as the tip feels them, (7.133): B_A ẍ + C_A ẋ + g_A = γ - h, with ẋ the task's rows of J q̇, J the geometric
// Jacobian or, with Euler angles, the analytical one. With B = Lᵀ D L and Y = L^-T Jᵀ, which half a solution gives,
// B_A^-1 = J B^-1 Jᵀ = Yᵀ D^-1 Y: nothing is inverted but that matrix of the task's own size. With a damping λ it is
// J B^-1 Jᵀ + λ² 1 wherever these functions have the inverse of J B^-1 Jᵀ.
#pragma once

#include "symbolic/dynamics/workbench.hpp"

namespace flatdyn {

// B_A, (7.130), and the dynamically consistent inverse J̄ = B^-1 Jᵀ B_A, (7.138): J̄ᵀ τ is what joint torques τ exert at
// the tip, (7.140); and the condition of what was inverted, 0 to 1.
Function operational_inertia_function(Workbench& bench);

// C_A ẋ = B_A (J B^-1 C q̇ - J̇ q̇) and g_A = B_A J B^-1 g, (7.131), (7.132). Joint friction is left out.
Function operational_bias_function(Workbench& bench);

// (1 - Jᵀ J̄ᵀ) τ_0: what of τ_0 moves the arm and not the tip, (7.141). Throws Failure(unsupported) where the task takes
// all joints.
Function null_space_torque_function(Workbench& bench);

}  // namespace flatdyn

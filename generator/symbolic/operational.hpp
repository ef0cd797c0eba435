// SPDX-License-Identifier: GPL-2.0-or-later
// Dynamics as the tip feels them, (7.133): B_A ẍ + C_A ẋ + g_A = γ - h, with ẋ the task's rows of J q̇, J the geometric
// Jacobian. With B = Lᵀ D L and Y = L^-T Jᵀ, which half a solution gives, B_A^-1 = J B^-1 Jᵀ = Yᵀ D^-1 Y: nothing is
// inverted but that matrix of the task's own size.
#pragma once

#include <vector>

#include "symbolic/workbench.hpp"

namespace flatdyn {

// Rows of the Jacobian that make up the task, rising: 0 to 2 the velocity along x, y, z, 3 to 5 the rotation about
// them. Those that the scene names; else all that are independent at almost every position, the first ones where there
// is a choice (x and y of an arm in the plane). Throws Failure(unsupported) if those named depend on each other
// everywhere.
std::vector<int> task_rows(const Mechanism& mechanism);

// "x, y, z, rx, ry, rz", those of a task.
std::string task_text(const std::vector<int>& rows);

// B_A, (7.130), and the dynamically consistent inverse J̄ = B^-1 Jᵀ B_A, (7.138): J̄ᵀ τ is what joint torques τ exert at
// the tip, (7.140).
Function operational_inertia_function(Workbench& bench);

// C_A ẋ = B_A (J B^-1 C q̇ - J̇ q̇) and g_A = B_A J B^-1 g, (7.131), (7.132). Joint friction is left out.
Function operational_bias_function(Workbench& bench);

// (1 - Jᵀ J̄ᵀ) τ_0: what of τ_0 moves the arm and not the tip, (7.141). Throws Failure(unsupported) where the task takes
// all joints.
Function null_space_torque_function(Workbench& bench);

}  // namespace flatdyn

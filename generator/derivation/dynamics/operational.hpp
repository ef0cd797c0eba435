// SPDX-License-Identifier: GPL-2.0-or-later
// Operational-space dynamics, (7.133): B_A ẍ + C_A ẋ + g_A = γ - h, with ẋ the task's rows of J q̇, J the geometric
// Jacobian or, with Euler angles, the analytical one. With B = Lᵀ D L and Y = L^-T Jᵀ, the first half of a solution,
// B_A^-1 = J B^-1 Jᵀ = Yᵀ D^-1 Y: only that matrix of the task's own size is inverted. With a damping λ, J B^-1 Jᵀ + λ²
// 1 replaces J B^-1 Jᵀ wherever these functions invert it.
#pragma once

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

// B_A, (7.130), and the dynamically consistent inverse J̄ = B^-1 Jᵀ B_A, (7.138), where J̄ᵀ τ is the force of joint
// torques τ at the tip, (7.140); and the condition of the inverted matrix, 0 to 1.
Function derive_operational_inertia(const Mechanism& mechanism, const Choices& choices);

// C_A ẋ = B_A (J B^-1 C q̇ - J̇ q̇) and g_A = B_A J B^-1 g, (7.131), (7.132). Joint friction is left out.
Function derive_operational_bias(const Mechanism& mechanism, const Choices& choices);

// (1 - Jᵀ J̄ᵀ) τ_0: the part of τ_0 that moves the arm but not the tip, (7.141). Throws Failure(unsupported) if the
// task needs all joints.
Function derive_null_space_torque(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn

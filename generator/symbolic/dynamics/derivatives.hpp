// SPDX-License-Identifier: GPL-2.0-or-later
// ∂τ/∂q and ∂τ/∂q̇ from composite bodies, without symbolic differentiation.
//
// A unit change of q_k turns composite body k as one rigid body. Beside that turn, a point at r from the origin of
// frame k that moves with u relative to that origin gets the acceleration
//     e + y × r + 2 w × u,   e = p̈ × z,   y = U z,   w = ω × z,
// with z the axis, p̈ the acceleration of the origin less gravity, ω and U = S(ω̇) + S(ω)² of the parent's body. For a
// prismatic joint e = U z, y = w = 0. A unit change of q̇_k gives e = 0, y = 2 w, and z in the place of w (prismatic: e
// = 2 ω × z alone). Summed over all points of composite body k this is
//     force  M e + y × H + 2 w × P,   moment  H × e + I y + 2 (tr Q - Q) w,
// with the composite body's mass M, first moment H, inertia I, and P = Σ m u, Q = Σ m u rᵀ. Derived from ∂v/∂q_k = v_λ
// × S_k + S_k × v; the same sums in spatial vectors: Singh, Russell and Wensing, "Efficient analytical derivatives of
// rigid-body dynamics using spatial vector algebra", 2022.
#pragma once

#include <vector>

#include "symbolic/dynamics/newton_euler.hpp"

namespace flatdyn {

struct TorqueDerivatives {
  Rows dq, dqd;  // [i][k]: ∂τ_i/∂q_k, ∂τ_i/∂q̇_k
};

// The derivatives of torques() without tip force. Coulomb friction counts as constant: its slope at rest is left out.
TorqueDerivatives torque_derivatives(Frames& frames, const Motion& motion);

}  // namespace flatdyn

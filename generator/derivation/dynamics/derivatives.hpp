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
//
// With a floating base, the whole robot is the composite body of the base's six columns. Its origin is accelerated by
// p̈ = v̇ + ω × v - g_b, all in base axes. A unit change of v_j gives e = ω × e_j; one of ω_j gives e = e_j × v, y = ω ×
// e_j and e_j in the place of w. A turn of the base about e_j, with v and a held fixed, turns g_b the other way:
// e = e_j × g_b alone. A displacement changes nothing.
//
// The link of a spherical joint turns about an axis e of its own, R ← R exp(S(δ)), while w and ẇ are held fixed. In its
// axes the parent's motion, ω_r = Rᵀ ω_λ and ω̇_r = Rᵀ ω̇_λ, turns the other way: e = p̈ × e, w = ω_r × e and
// y = ω̇_r × e + ω_r × (ω_r × e). A unit change of w along e gives y = (ω + ω_r) × e, and e in the place of w; for 2 C
// it is y = 2 ω × e.
#pragma once

#include <vector>

#include "derivation/dynamics/newton_euler.hpp"

namespace flatdyn {

struct TorqueDerivatives {
  Rows dq, dqd;  // [i][k]: ∂τ_i/∂q_k, ∂τ_i/∂q̇_k
};

// The columns of a floating base.
enum class BaseColumns {
  derivatives,             // by its displacement and turn along and about its axes, and by v; v and a are held fixed
  at_origin_acceleration,  // the same with p̈ = v̇ + ω × v - g_b held fixed in the place of v̇
  coriolis,                // of v: 2 C, with the C of which Ḃ - 2 C is skew-symmetric; those of its position are zero
};

// The derivatives of torques() without tip force. Coulomb friction counts as constant: its slope at rest is left out.
TorqueDerivatives torque_derivatives(Frames& frames, const Motion& motion,
                                     BaseColumns base_columns = BaseColumns::derivatives);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The generalised momenta p = B(q) q̇, and C(q, q̇)ᵀ q̇, by which they change: ṗ = τ + Cᵀ q̇ - g - friction, since
// Ḃ = C + Cᵀ. Momentum observers need both (A. De Luca, A. Albu-Schäffer, S. Haddadin, G. Hirzinger, "Collision
// detection and safe reaction with the DLR-III lightweight robot arm", IROS 2006).
#pragma once

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

Function derive_momentum(const Mechanism& mechanism, const Choices& choices);

// From momenta alone, without C: with the momentum P and the moment of momentum L of all that joint i moves, about its
// origin, which has the velocity v, (Cᵀ q̇)_i = -z_i·(ω × L + v × P) for revolute joints and -z_i·(ω × P) for
// prismatic ones. It is ∂T/∂q_i where velocities are derivatives of coordinates.
Function derive_coriolis_transpose_qd(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Bias torques from composite bodies, for use where these are known anyway, as in forward dynamics.
//
// Joint i's composite body moves as if the joint were locked, and in addition, because of q̇_i, a point at r from the
// joint's origin has the acceleration (-β x, -β y, γ_x x + γ_y y), β = q̇ (q̇ + 2 ω_z), γ = 2 q̇ ω, with ω that of the
// parent's body. This field of accelerations requires a wrench on composite body i, which acts on all joints before i.
// At joint i itself the field acts only as the sum of all fields before it does: by one moment about its axis. All
// quantities are in axes that do not turn with the joint: there composite bodies are transformed to the parent anyway.
#pragma once

#include "derivation/dynamics/newton_euler.hpp"

namespace flatdyn {

// C q̇ + g + friction of a mechanism without prismatic joints: torques() with motion.qdd zero. `bodies`:
// composites(frames).
std::vector<Number> composite_bias_torques(Frames& frames, const Motion& motion,
                                           const std::vector<InertialParameters>& bodies);

}  // namespace flatdyn

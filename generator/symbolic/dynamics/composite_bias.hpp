// SPDX-License-Identifier: GPL-2.0-or-later
// Bias torques where the composite bodies are known anyway, as in forward dynamics.
//
// All behind joint i moves as it would if the joint were locked, and beside that, because of q̇_i, a point at r from the
// joint's origin is accelerated by (-β x, -β y, γ_x x + γ_y y), β = q̇ (q̇ + 2 ω_z), γ = 2 q̇ ω, with ω that of the
// parent's body. That field gives a wrench, of composite body i, to all joints before. Joint i itself feels of the
// field only what it feels of all fields before: one moment about its axis. All of it is taken in axes that do not turn
// with the joint: there composite bodies are on their way to the parent.
#pragma once

#include "symbolic/dynamics/newton_euler.hpp"

namespace flatdyn {

// C q̇ + g + friction of a mechanism without prismatic joints: torques() where motion.qdd is zero. `bodies`:
// composites(frames).
std::vector<Number> composite_bias_torques(Frames& frames, const Motion& motion,
                                           const std::vector<InertialParameters>& bodies);

}  // namespace flatdyn

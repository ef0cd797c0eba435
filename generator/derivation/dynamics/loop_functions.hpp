// SPDX-License-Identifier: GPL-2.0-or-later
// The functions that a user needs to close loops: positions, rates and accelerations of all joints.
#pragma once

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

// All of these throw Failure(unsupported) for a robot without closed loops.
Function derive_loop_closure(const Mechanism& mechanism);   // Φ(q)
Function derive_loop_jacobian(const Mechanism& mechanism);  // Φ_q
Function derive_loop_step(const Mechanism& mechanism);      // Newton's step towards Φ = 0
Function derive_loop_motion(const Mechanism& mechanism);    // q̇ and q̈ of all joints

}  // namespace flatdyn

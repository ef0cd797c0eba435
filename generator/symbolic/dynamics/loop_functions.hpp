// SPDX-License-Identifier: GPL-2.0-or-later
// The functions that a user needs to close loops: positions, rates and accelerations of all joints.
#pragma once

#include "symbolic/dynamics/workbench.hpp"

namespace flatdyn {

// All of these throw Failure(unsupported) for a robot without closed loops.
Function loop_closure_function(Workbench& bench);   // Φ(q)
Function loop_jacobian_function(Workbench& bench);  // Φ_q
Function loop_step_function(Workbench& bench);      // Newton's step towards Φ = 0
Function loop_motion_function(Workbench& bench);    // q̇ and q̈ of all joints

}  // namespace flatdyn

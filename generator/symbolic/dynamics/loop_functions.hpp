// SPDX-License-Identifier: GPL-2.0-or-later
// What closed loops are for those who have to close them: positions, rates and accelerations of all joints.
#pragma once

#include "symbolic/dynamics/workbench.hpp"

namespace flatdyn {

// All throw Failure(unsupported) for a robot without such loops.
Function loop_closure_function(Workbench& bench);   // Φ(q)
Function loop_jacobian_function(Workbench& bench);  // Φ_q
Function loop_step_function(Workbench& bench);      // Newton's step towards Φ = 0
Function loop_motion_function(Workbench& bench);    // q̇ and q̈ of all joints

}  // namespace flatdyn

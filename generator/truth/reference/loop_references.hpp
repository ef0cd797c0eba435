// SPDX-License-Identifier: GPL-2.0-or-later
// The functions of closed loops by the reference.
#pragma once

#include "truth/reference/numeric_reference.hpp"

namespace flatdyn::references {

extern const NumericReference loop_closure, loop_jacobian, loop_step, loop_motion;

}  // namespace flatdyn::references

// SPDX-License-Identifier: GPL-2.0-or-later
// The functions of closed loops by their definitions, from the gaps between the points that meet.
#pragma once

#include "truth/definition/definition.hpp"

namespace flatdyn::definitions {

extern const Definition loop_closure, loop_jacobian, loop_step, loop_motion;

}  // namespace flatdyn::definitions

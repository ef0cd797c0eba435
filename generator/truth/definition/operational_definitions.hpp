// SPDX-License-Identifier: GPL-2.0-or-later
// Operational-space dynamics, (7.130)–(7.141), computed as they are written.
#pragma once

#include "truth/definition/definition.hpp"

namespace flatdyn::definitions {

extern const Definition operational_inertia, operational_bias, null_space_torque;

}  // namespace flatdyn::definitions

// SPDX-License-Identifier: GPL-2.0-or-later
// The torques that accelerate the joints, from B by Lagrange's equations.
#pragma once

#include "truth/definition/definition.hpp"

namespace flatdyn::definitions {

extern const Definition inertial_torque;

}  // namespace flatdyn::definitions

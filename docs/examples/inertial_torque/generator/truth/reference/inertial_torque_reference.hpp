// SPDX-License-Identifier: GPL-2.0-or-later
// The torques that accelerate the joints, by the reference.
#pragma once

#include "truth/reference/numeric_reference.hpp"

namespace flatdyn::references {

extern const NumericReference inertial_torque;

}  // namespace flatdyn::references

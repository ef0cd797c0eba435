// SPDX-License-Identifier: GPL-2.0-or-later
// Operational-space dynamics by the reference.
#pragma once

#include "truth/reference/numeric_reference.hpp"

namespace flatdyn::references {

extern const NumericReference operational_inertia, operational_bias, null_space_torque;

}  // namespace flatdyn::references

// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "robot/input/sdf/tree.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// The link of a frame of that kind. What the file leaves out has SDF's defaults, 1 kg and 1 kg m^2, which is noted.
Link read_sdf_link(const SdfFrame& frame);

// Links on which gravity does not act: if these are all that have a mass, there is no gravity; if only some are, that
// is refused.
void apply_sdf_gravity_flags(const SdfTree& tree, Diagnostics& diagnostics, Robot& robot);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Joints that follow others.
#pragma once

#include <string>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// Couples a joint, unless it is coupled so already; an error if it is coupled otherwise. what: who says so.
void couple_joint(Joint& joint, const Coupled& coupled, const std::string& what, Diagnostics& diagnostics);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// The index of the joint of this name; -1 and an error if there is no such one. `what` says who refers to it. Links:
// find_link() of context.hpp.
int joint_called(const std::string& name, const Place& place, const std::string& what, const Robot& robot,
                 Diagnostics& diagnostics);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Names by which a file refers to its links and joints.
#pragma once

#include <string>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// The index of the link or joint of this name; -1 and an error if there is no such one. `what` says who refers to it.
int link_called(const std::string& name, const Place& place, const std::string& what, const Robot& robot,
                Diagnostics& diagnostics);
int joint_called(const std::string& name, const Place& place, const std::string& what, const Robot& robot,
                 Diagnostics& diagnostics);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Fixed tendons: lengths that are sums of joint positions. Their springs, friction and armature act on these joints,
// and equalities of their lengths couple them.
#pragma once

#include "robot/input/mjcf/model.hpp"

namespace flatdyn {

// Reads fixed tendons into model.tendons. Spatial tendons that pull are refused, and so is what bends.
void read_mjcf_tendons(MjcfModel& model);

// The tendon of this name; nullptr, and an error, if there is none. what: who names it.
MjcfTendon* mjcf_tendon(const FileAttribute& name, const std::string& what, MjcfModel& model);

// Adds tendons to the robot, whose tree must be as it stays. Those without a force have no effect.
void add_mjcf_tendons(const MjcfModel& model);

}  // namespace flatdyn

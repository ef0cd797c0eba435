// SPDX-License-Identifier: GPL-2.0-or-later
// Frames that a scene, or --frame, fixes to links of a robot that was read.
#pragma once

#include "robot/input/common/context.hpp"

namespace flatdyn {

// The reason why lists of functions and stamps of options could not hold the name; empty if they can.
std::string problem_of_frame_name(const std::string& name);

// Adds a link without mass for each of the scene's frames, held by a fixed joint: whatever takes the name of a link
// takes that of the frame, too. Findings if its link is unknown, or if a link has its name.
void add_frames(ReadContext& context, Robot& robot);

}  // namespace flatdyn

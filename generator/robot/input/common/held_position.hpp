// SPDX-License-Identifier: GPL-2.0-or-later
// Positions at which joints are to be held, in the units that they are written in.
#pragma once

#include <string>

#include "robot/input/common/context.hpp"

namespace flatdyn {

// The joint in messages: joint "elbow", held at 0.5.
std::string held_at(const JointPosition& lock);

// The units of a position that may say by itself that it is in degrees.
Units units_of(const HeldJoint& lock);

// An error where a position says that it is in degrees and cannot be.
void check_degrees(const HeldJoint& lock, bool slides, const Spot& spot, Diagnostics& diagnostics);

// The position in rad or m, for a joint of this type.
Number held_position(const HeldJoint& lock, JointType type, ReadContext& context);

}  // namespace flatdyn

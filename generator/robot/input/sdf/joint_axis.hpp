// SPDX-License-Identifier: GPL-2.0-or-later
// One axis of an SDF joint: its direction, friction, spring, limits, and the joint that it follows.
#pragma once

#include "robot/input/sdf/tree.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// The frame in which the axis is written: that of the joint, unless the file names one, or is so old that it is that of
// the model.
int frame_of_axis(const SdfTree& tree, int joint, const FileNode& axis, Diagnostics& diagnostics);

// Direction, friction, spring, limits, and the coupling to another joint; the joint's type and name are known.
void read_sdf_axis(const SdfTree& tree, const SdfFrame& frame, const FileNode& axis, ReadContext& context,
                   Joint& joint);

// Drake's rotor inertia and gear ratio, which count as armature, and its words for a coupling.
void read_drake_words(const SdfTree& tree, const SdfFrame& frame, Diagnostics& diagnostics, Joint& joint);

// The name of the joint that an axis becomes: NAME, or NAME.axis and NAME.axis2 of a joint with two.
bool has_two_axes(const SdfFrame& joint);
std::string name_of_axis(const SdfFrame& joint, const std::string& axis);

}  // namespace flatdyn

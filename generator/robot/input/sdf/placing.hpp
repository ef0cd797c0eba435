// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "robot/input/sdf/tree.hpp"

namespace flatdyn {

// Where each declared frame is, and what it moves with. False, and errors, if names of frames are not there, or if
// poses or attachments go round.
bool place_sdf_frames(Diagnostics& diagnostics, SdfTree& tree);

// The frame that a joint names as its parent or child; -1 and an error if there is none.
int frame_of_joint(const SdfTree& tree, const SdfFrame& joint, const char* tag, Diagnostics& diagnostics);

}  // namespace flatdyn

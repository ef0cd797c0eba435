// SPDX-License-Identifier: GPL-2.0-or-later
// The joints of a body of an MJCF file: several of them move it one after the other, each about its own point.
#pragma once

#include "robot/input/mjcf/model.hpp"

namespace flatdyn {

struct MjcfJoint {
  const FileNode* element = nullptr;
  std::string class_name;
  Pose frame;  // of the <frame> that holds it, in the body's frame
};

// Adds the body's link to the robot, with the joints between it and its parent's, and links without mass between these;
// without joints a fixed one.
void add_mjcf_joints(const std::vector<MjcfJoint>& joints, const std::string& body, int parent_link, MjcfModel& model,
                     MjcfBody& added);

// The first of the coefficients of a force by the powers of what it acts against; the others are refused unless they
// are 0.
Value mjcf_linear(const MjcfItem& item, const char* name, const MjcfValues& values);

// The magnitude of an effort limit that is given as a range; nullopt where there is none.
std::optional<Value> mjcf_effort(const MjcfItem& item, const char* range, const char* limited, const MjcfValues& values,
                                 const MjcfSettings& settings);

// Whether a range limits: it is said, or follows from the range.
bool mjcf_is_limited(const MjcfItem& item, const char* range, const char* limited, const MjcfValues& values,
                     const MjcfSettings& settings);

}  // namespace flatdyn

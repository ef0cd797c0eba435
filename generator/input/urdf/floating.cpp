// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/urdf/floating.hpp"

#include <algorithm>

namespace flatdyn {
namespace {

// Whether the joint is all that hangs on its parent link, a root without a body.
bool is_free_root(const Robot& robot, const Joint& joint) {
  const auto parent = static_cast<std::size_t>(joint.parent);
  const bool has_joints = std::any_of(robot.joints.begin(), robot.joints.end(), [&](const Joint& other) {
    return other.name != joint.name && (other.parent == joint.parent || other.child == joint.parent);
  });
  return !has_joints && robot.links[parent].inertials.empty();
}

// Leaves out a joint and the link that it hangs on.
void leave_out(int index, Robot& robot) {
  const int link = robot.joints[static_cast<std::size_t>(index)].parent;
  robot.joints.erase(robot.joints.begin() + index);
  robot.links.erase(robot.links.begin() + link);
  const auto close_gap = [link](int& other) { other -= other > link ? 1 : 0; };
  for (Joint& joint : robot.joints) {
    close_gap(joint.parent);
    close_gap(joint.child);
    if (joint.motor) close_gap(joint.motor->carrier);
  }
}

void note_pose(const Joint& joint, Diagnostics& diagnostics) {
  if (joint.origin.displacements.empty()) return;
  diagnostics.note(joint.place, "joint \"" + joint.name + "\": its origin has no effect, as the base floats",
                   "the pose of the base is part of the state");
}

}  // namespace

void take_floating_joints(const std::vector<int>& joints, Diagnostics& diagnostics, Robot& robot) {
  if (joints.size() == 1) {
    const Joint joint = robot.joints[static_cast<std::size_t>(joints.front())];
    if (joint.parent >= 0 && joint.child >= 0 && is_free_root(robot, joint)) {
      note_pose(joint, diagnostics);
      robot.floating_base = true;
      leave_out(joints.front(), robot);
      return;
    }
  }
  for (const int index : joints) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(index)];
    diagnostics.unsupported(joint.place,
                            "joint \"" + joint.name +
                                "\" moves freely: that is supported for one joint only, between a root without mass "
                                "and the robot",
                            "hold it still: give the option --fix " + joint.name);
  }
}

}  // namespace flatdyn

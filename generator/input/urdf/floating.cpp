// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/urdf/floating.hpp"

#include <algorithm>
#include <string>

#include "input/common/joint_parts.hpp"

namespace flatdyn {
namespace {

// Whether the joint is on a root without a body.
bool is_on_empty_root(const Robot& robot, const Joint& joint) {
  const bool is_moved = std::any_of(robot.joints.begin(), robot.joints.end(),
                                    [&](const Joint& other) { return other.child == joint.parent; });
  return !is_moved && robot.links[static_cast<std::size_t>(joint.parent)].inertials.empty();
}

// Whether the joint is all that hangs on its parent link, a root without a body.
bool is_free_root(const Robot& robot, const Joint& joint) {
  const bool has_others = std::any_of(robot.joints.begin(), robot.joints.end(), [&](const Joint& other) {
    return other.name != joint.name && other.parent == joint.parent;
  });
  return !has_others && is_on_empty_root(robot, joint);
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
                                "\" moves freely: on a root without mass that is supported for one joint only, which "
                                "carries the whole robot",
                            "hold it still: give the option --fix " + joint.name);
  }
}

bool floats_in_tree(const Robot& robot, const Joint& joint) {
  return joint.parent >= 0 && joint.child >= 0 && !is_on_empty_root(robot, joint);
}

void split_floating_joint(const std::string& name, Robot& robot) {
  const auto place = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&name](const Joint& joint) { return joint.name == name; });
  const Joint whole = *place;
  std::vector<Joint> parts;
  for (std::size_t k = 0; k < 3; ++k) {
    parts.push_back(part_of_joint(whole, std::string(".") + "xyz"[k], JointType::prismatic));
    parts.back().axis = zero_vector();
    parts.back().axis[k] = 1;
  }
  parts.push_back(part_of_joint(whole, ".turn", JointType::spherical));
  const auto next = robot.joints.erase(place);
  const std::vector<Joint> joined = joined_in_tree(whole, parts, robot);
  robot.joints.insert(next, joined.begin(), joined.end());
}

}  // namespace flatdyn

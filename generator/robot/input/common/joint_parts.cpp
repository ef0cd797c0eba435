// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/joint_parts.hpp"

#include "robot/input/common/turns.hpp"
#include "robot/model/pose_product.hpp"

namespace flatdyn {

Joint part_of_joint(const Joint& whole, const std::string& ending, JointType type) {
  Joint part;
  part.name = whole.name + ending;
  part.type = type;
  part.axis = whole.axis;
  part.place = part.origin.place = part.link_offset.place = whole.place;
  part.viscous.place = part.coulomb.place = part.armature.place = whole.place;
  return part;
}

std::vector<Joint> planar_parts(const Joint& whole, const std::string& what, ReadContext& context) {
  std::vector<Joint> parts = {part_of_joint(whole, ".x", JointType::prismatic),
                              part_of_joint(whole, ".y", JointType::prismatic),
                              part_of_joint(whole, ".turn", JointType::continuous)};
  parts[0].axis = {1, 0, 0};
  parts[1].axis = {0, 1, 0};
  parts[2].axis = {0, 0, 1};
  constexpr int kShownDigits = 17;
  std::string written;
  for (const Number& each : whole.axis) written += (written.empty() ? "" : " ") + to_decimal(each, kShownDigits);
  const Displacements turn = turn_from_z(whole.axis, {whole.place, what}, written, context);
  parts.front().origin.displacements = turn;
  parts.back().link_offset.displacements = inverse(turn);
  return parts;
}

std::vector<Joint> screw_parts(const Joint& whole, const Number& travel) {
  std::vector<Joint> parts = {part_of_joint(whole, "", JointType::revolute),
                              part_of_joint(whole, ".slide", JointType::prismatic)};
  parts[1].coupled = Coupled{{{{whole.name, whole.place}, travel}}, 0, whole.place};
  return parts;
}

std::vector<Joint> joined_in_tree(const Joint& whole, std::vector<Joint> parts, Robot& robot) {
  int parent = whole.parent;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    parts[k].parent = parent;
    if (k + 1 == parts.size()) {
      parts[k].child = whole.child;
      continue;
    }
    parent = parts[k].child = static_cast<int>(robot.links.size());
    robot.links.push_back({whole.name + ".between" + (k == 0 ? "" : std::to_string(k + 1)), {}, whole.place});
  }
  Displacements& first = parts.front().origin.displacements;
  first = product(whole.origin.displacements, first);
  Displacements& last = parts.back().link_offset.displacements;
  last = product(last, whole.link_offset.displacements);
  return parts;
}

void hold_parts(const std::string& whole, const std::vector<Joint>& parts, ReadContext& context) {
  std::vector<HeldJoint> held;
  for (const HeldJoint& each : context.held_joints) {
    if (each.joint != whole || !vanishes(each.position)) {
      held.push_back(each);
      continue;
    }
    for (const Joint& part : parts) {
      held.push_back(each);
      held.back().joint = part.name;
    }
  }
  context.held_joints = held;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/robot_builder.hpp"

#include <algorithm>

namespace flatdyn {

int RobotBuilder::add_link(Link link) {
  const int index = static_cast<int>(robot_.links.size());
  links_.emplace(link.name, index);
  robot_.links.push_back(std::move(link));
  return index;
}

int RobotBuilder::world(const Place& place) {
  if (world_ < 0) world_ = add_link({"world", {}, place});
  return world_;
}

int RobotBuilder::link(const Reference& name, const std::string& what, const std::string& kind) const {
  const auto found = links_.find(name.name);
  if (found != links_.end()) return found->second;
  return find_link(robot_, name, what, context_.diagnostics, kind).value_or(-1);
}

Joint RobotBuilder::new_joint(const std::string& name, const Place& place) {
  Joint joint;
  joint.name = name;
  joint.place = joint.viscous.place = joint.coulomb.place = joint.armature.place = place;
  return joint;
}

void RobotBuilder::set_type(JointType motion, Joint& joint) const {
  joint.type = is_held(joint.name, context_) ? JointType::fixed : motion;
  if (joint.type != motion) joint.held = Held{motion};
}

void RobotBuilder::fix_to_world(int link, const Displacements& pose, const Place& place) {
  Joint joint = new_joint("world to " + robot_.links[static_cast<std::size_t>(link)].name, place);
  joint.type = JointType::fixed;
  joint.parent = world(place);
  joint.child = link;
  joint.origin = {pose, place};
  add_joint(std::move(joint));
}

Joint* joint_in(Robot& robot, const std::string& name) {
  const auto found = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&name](const Joint& joint) { return joint.name == name; });
  return found == robot.joints.end() ? nullptr : &*found;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/tendon.hpp"

#include <algorithm>

namespace flatdyn {

namespace {

int root_of(const Robot& robot) {
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    const auto is_moved = [l](const Joint& joint) { return joint.child == static_cast<int>(l); };
    if (std::none_of(robot.joints.begin(), robot.joints.end(), is_moved)) return static_cast<int>(l);
  }
  return 0;
}

std::string unused_link_name(const std::string& wanted, const Robot& robot) {
  std::string name = wanted;
  const auto has_name = [&name](const Link& link) { return link.name == name; };
  for (int number = 2; std::any_of(robot.links.begin(), robot.links.end(), has_name); ++number) {
    name = wanted + "_" + std::to_string(number);
  }
  return name;
}

bool is_idle(const Joint& joint) {
  if (!joint.is_tendon) return false;
  const Value* const forces[] = {&joint.stiffness, &joint.viscous, &joint.coulomb, &joint.armature};
  if (joint.law.static_friction || joint.law.backward) return joint.type == JointType::fixed;
  return joint.type == JointType::fixed ||
         std::all_of(std::begin(forces), std::end(forces), [](const Value* force) { return vanishes(force->number); });
}

}  // namespace

void add_tendon(Joint tendon, Robot& robot) {
  if (robot.links.empty()) return;  // the robot could not be read: said there
  tendon.is_tendon = true;
  tendon.type = JointType::prismatic;
  tendon.origin.place = tendon.link_offset.place = tendon.place;
  tendon.parent = root_of(robot);
  tendon.child = static_cast<int>(robot.links.size());
  robot.links.push_back({unused_link_name(tendon.name, robot), {}, tendon.place});
  robot.joints.push_back(std::move(tendon));
}

bool is_of_tendon(const Robot& robot, int link) {
  return std::any_of(robot.joints.begin(), robot.joints.end(),
                     [link](const Joint& joint) { return joint.is_tendon && joint.child == link; });
}

void leave_out_idle_tendons(Robot& robot) {
  for (std::size_t j = robot.joints.size(); j-- > 0;) {
    if (!is_idle(robot.joints[j])) continue;
    const int link = robot.joints[j].child;
    robot.joints.erase(robot.joints.begin() + static_cast<std::ptrdiff_t>(j));
    robot.links.erase(robot.links.begin() + link);
    const auto close_gap = [link](int& index) { index -= index > link ? 1 : 0; };
    for (Joint& joint : robot.joints) {
      close_gap(joint.parent);
      close_gap(joint.child);
      if (joint.motor) close_gap(joint.motor->carrier);
    }
  }
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/robot.hpp"

namespace flatdyn {

namespace {

struct KindOfSnap {
  const char* name;
  const char* unit;
};

KindOfSnap words_for(Snap::Kind kind) {
  switch (kind) {
    case Snap::Kind::angle:
      return {"angle", "rad"};
    case Snap::Kind::axis:
      return {"axis", "1"};
    case Snap::Kind::length:
      return {"length", "m"};
    case Snap::Kind::product_of_inertia:
      return {"product of inertia", "kg m^2"};
    case Snap::Kind::first_moment:
      return {"first moment", "kg m"};
    case Snap::Kind::gravity:
      return {"gravity", "m/s^2"};
  }
  return {"", ""};
}

}  // namespace

const char* name_of(Snap::Kind kind) { return words_for(kind).name; }
const char* unit_of(Snap::Kind kind) { return words_for(kind).unit; }

std::vector<int> depth_first_joints(const Robot& robot) {
  std::vector<std::vector<int>> joints_of_link(robot.links.size());
  // Joints are pushed from the last to the first, so that the first in the file is on top of the stack.
  for (std::size_t j = robot.joints.size(); j-- > 0;) {
    joints_of_link[static_cast<std::size_t>(robot.joints[j].parent)].push_back(static_cast<int>(j));
  }
  std::vector<int> order;
  std::vector<int> stack = joints_of_link[static_cast<std::size_t>(robot.root)];
  while (!stack.empty()) {
    const int joint = stack.back();
    stack.pop_back();
    order.push_back(joint);
    const auto child = static_cast<std::size_t>(robot.joints[static_cast<std::size_t>(joint)].child);
    stack.insert(stack.end(), joints_of_link[child].begin(), joints_of_link[child].end());
  }
  return order;
}

std::vector<bool> moving_links(const Robot& robot) {
  std::vector<bool> moves(robot.links.size(), robot.floating_base);
  for (const int j : depth_first_joints(robot)) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(j)];
    moves[static_cast<std::size_t>(joint.child)] =
        joint.type != JointType::fixed || moves[static_cast<std::size_t>(joint.parent)];
  }
  return moves;
}

std::vector<int> moving_joints(const Robot& robot) {
  std::vector<int> order;
  for (const int joint : depth_first_joints(robot)) {
    if (robot.joints[static_cast<std::size_t>(joint)].type != JointType::fixed) order.push_back(joint);
  }
  return order;
}

std::string name_of(const Loop& loop) {
  return "loop " + (loop.name.empty() ? "" : "\"" + loop.name + "\" ") + "between \"" + loop.links[0].name +
         "\" and \"" + loop.links[1].name + "\"";
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Links and joints of a robot while it is read: by name, the world, what options hold still. What is done once all are
// there is the same for every format, and stands in robot/input/reader.cpp.
#pragma once

#include <map>
#include <string>

#include "robot/input/common/context.hpp"
#include "robot/model/pose_product.hpp"

namespace flatdyn {

class RobotBuilder {
 public:
  RobotBuilder(ReadContext& context, Robot& robot) : context_(context), robot_(robot) {}

  // The index of the new link. Of two with one name the first is found by it; the validation reports the other.
  int add_link(Link link);
  // The link that stands still under all others, called "world"; made where it is first asked for.
  int world(const Place& place);
  // The index of a link; -1 and an error if there is none. what: who names it, "joint "elbow": ... parent".
  int link(const Reference& name, const std::string& what, const std::string& kind = "link") const;
  bool has_link(const std::string& name) const { return links_.contains(name); }

  // A joint with its place, which its values have until they are read.
  static Joint new_joint(const std::string& name, const Place& place);
  // The joint's type, or a fixed one that keeps it where an option holds the joint.
  void set_type(JointType motion, Joint& joint) const;
  void add_joint(Joint joint) { robot_.joints.push_back(std::move(joint)); }
  // A link that stands still in the world.
  void fix_to_world(int link, const Displacements& pose, const Place& place);

 private:
  ReadContext& context_;
  Robot& robot_;
  std::map<std::string, int> links_;
  int world_ = -1;
};

// nullptr if the robot has no joint of this name.
Joint* joint_in(Robot& robot, const std::string& name);

}  // namespace flatdyn

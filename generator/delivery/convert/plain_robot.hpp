// SPDX-License-Identifier: GPL-2.0-or-later
// Robot → the same robot in the words that URDF and TOML files share: one pose of a joint in its parent link, which is
// that of the child link, and one body of a link. Links without mass are put in where a file needs one more frame.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/model/robot.hpp"

namespace flatdyn {

// A position, then Rz(yaw) Ry(pitch) Rx(roll).
struct PlainPose {
  Vec3 xyz = zero_vector();
  Vec3 rpy = zero_vector();
};

struct PlainBody {
  Number mass = 0;
  PlainPose pose;               // its centre of mass, and the axes of the tensor, in the frame of the link
  Mat3 tensor = zero_matrix();  // about the centre of mass
};

struct CleanLink {
  std::string name;
  std::optional<PlainBody> body;
};

struct PlainJoint {
  std::string name;
  const Joint* joint = nullptr;  // with its type, friction, limits; nullptr of a fixed one that was put in
  int parent = -1, child = -1;
  PlainPose origin;
  Vec3 axis = {0, 0, 1};  // in the frame of the child
};

struct CleanRobot {
  std::vector<CleanLink> links;
  std::vector<PlainJoint> joints;
};

// Where a body may be turned against its link, as in URDF, or not, as in TOML.
struct PlainForm {
  bool bodies_turn = true;
};

PlainPose plain_pose_of(const Pose& pose);

CleanRobot plain_robot(const Robot& robot, const PlainForm& form);

}  // namespace flatdyn

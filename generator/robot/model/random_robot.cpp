// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/random_robot.hpp"

namespace flatdyn {

Link random_link(RandomHundredths& draw, const std::string& name) {
  Inertial body;
  body.mass.number = draw.between(10, 99);
  body.centre_of_mass = draw.vector();
  for (int k = 0; k < 3; ++k) {
    const Number mass = draw.between(10, 99);
    body.tensor = body.tensor + steiner(mass, draw.vector());
  }
  return {name, {body}, {}};
}

Joint random_joint(RandomHundredths& draw, const std::string& name, int parent, int child) {
  Joint joint;
  joint.name = name;
  joint.type = JointType::revolute;
  joint.parent = parent;
  joint.child = child;
  const Number pitch = draw.any(), roll = draw.any();
  joint.origin.displacements = {{Displacement::Kind::translation, draw.vector(), 0},
                                {Displacement::Kind::rotation_y, zero_vector(), pitch},
                                {Displacement::Kind::rotation_x, zero_vector(), roll}};
  return joint;
}

Robot random_robot(bool chain, int joints, unsigned seed) {
  RandomHundredths draw(seed);
  Robot robot;
  robot.name = (chain ? "chain_" : "tree_") + std::to_string(joints);
  robot.root = 0;
  robot.links.push_back({"base", {}, {}});
  for (int i = 0; i < joints; ++i) {
    const std::string number = std::to_string(i + 1);
    robot.links.push_back(random_link(draw, "link_" + number));
    robot.joints.push_back(random_joint(draw, "joint_" + number, chain ? i : (i + 1) / 2, i + 1));
  }
  robot.tip = joints;
  return robot;
}

}  // namespace flatdyn

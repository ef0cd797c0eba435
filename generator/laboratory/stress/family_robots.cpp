// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "laboratory/stress/families.hpp"
#include "robot/model/random_robot.hpp"

namespace flatdyn {
namespace {

Number power_of_ten(int exponent) {
  const GiNaC::numeric ten(10);
  return ten.power(GiNaC::numeric(exponent));
}

std::string label_of(const std::string& what, int exponent) { return fmt::format("{} 1e{}", what, exponent); }

void scale(Link& link, const Number& by) {
  for (Inertial& body : link.inertials) {
    body.mass.number = body.mass.number * by;
    for (Vec3& row : body.tensor) row = by * row;
  }
}

// Robots with masses and inertias from 10^-e at one end to 10^e at the other.
std::vector<FamilyMember> inertia_ratios(const FamilySize& size) {
  std::vector<FamilyMember> members;
  for (int k = 0; k < size.robots; ++k) {
    const int most = 9 - 3 * (k / 2 % 3), sign = k % 2 == 0 ? 1 : -1;
    Robot robot = random_robot(true, size.joints, size.seed + static_cast<unsigned>(k));
    for (int i = 1; i <= size.joints; ++i) {
      const int exponent = static_cast<int>(std::lround(most * (2.0 * (i - 1) / (size.joints - 1) - 1)));
      scale(robot.links[static_cast<std::size_t>(i)], power_of_ten(sign * exponent));
    }
    members.push_back(
        {label_of(sign > 0 ? "tip heavier, to" : "base heavier, to", most), std::pow(10.0, most), std::move(robot)});
  }
  return members;
}

// Robots with rotors of 1e-12 to 1e-6 kg m², whose inertia at the joint is that times the square of the ratio.
std::vector<FamilyMember> gear_ratios(const FamilySize& size) {
  std::vector<FamilyMember> members;
  for (int k = 0; k < size.robots; ++k) {
    const int exponent = 5 - k % 5;
    Robot robot = random_robot(true, size.joints, size.seed + static_cast<unsigned>(k));
    RandomHundredths draw(size.seed + static_cast<unsigned>(k));
    for (Joint& joint : robot.joints) {
      Motor motor;
      motor.gear_ratio.number = power_of_ten(exponent) * draw.between(50, 100);
      motor.inertia_axial.number = power_of_ten(draw.integer(-12, -6));
      motor.inertia_transverse.number = motor.inertia_axial.number;
      motor.mass.number = draw.between(1, 5);
      motor.axis = {0, 0, 1};
      joint.motor = motor;
    }
    members.push_back({label_of("k_r up to", exponent), std::pow(10.0, exponent), std::move(robot)});
  }
  return members;
}

// Robots whose centres of mass are `parameter` metres from their joints.
std::vector<FamilyMember> far_centres(const FamilySize& size) {
  std::vector<FamilyMember> members;
  for (int k = 0; k < size.robots; ++k) {
    const int exponent = 4 - k % 4;
    Robot robot = random_robot(true, size.joints, size.seed + static_cast<unsigned>(k));
    for (Link& link : robot.links) {
      for (Inertial& body : link.inertials) body.centre_of_mass = power_of_ten(exponent) * body.centre_of_mass;
    }
    members.push_back({label_of("metres", exponent), std::pow(10.0, exponent), std::move(robot)});
  }
  return members;
}

// Robots with axes that are parallel up to `parameter` rad.
std::vector<FamilyMember> near_parallel(const FamilySize& size) {
  std::vector<FamilyMember> members;
  for (int k = 0; k < size.robots; ++k) {
    const int exponent = -3 - k % 10;
    Robot robot = random_robot(true, size.joints, size.seed + static_cast<unsigned>(k));
    for (Joint& joint : robot.joints) {
      for (Displacement& each : joint.origin.displacements) each.angle = each.angle * power_of_ten(exponent);
    }
    members.push_back({label_of("rad", exponent), std::pow(10.0, exponent), std::move(robot)});
  }
  return members;
}

// Robots with a last link of almost no mass, or of none; and with a light link between two joints about the same axis,
// where two rows of B are equal up to the last places.
std::vector<FamilyMember> light_links(const FamilySize& size) {
  constexpr int kExponents[] = {-6, -12, -18, -30, -100};
  std::vector<FamilyMember> members;
  for (int k = 0; k < size.robots; ++k) {
    const int exponent = kExponents[static_cast<std::size_t>(k / 2) % std::size(kExponents)];
    const bool is_tip = k % 2 == 0;
    Robot robot = random_robot(true, size.joints, size.seed + static_cast<unsigned>(k));
    scale(robot.links[static_cast<std::size_t>(is_tip ? size.joints : 2)], power_of_ten(exponent));
    if (!is_tip) robot.joints[2].origin = {};
    members.push_back(
        {label_of(is_tip ? "tip" : "between equal axes", exponent), std::pow(10.0, exponent), std::move(robot)});
  }
  Robot robot = random_robot(true, size.joints, size.seed);
  robot.links.back().inertials.clear();
  members.push_back({"tip without mass", 1e-300, std::move(robot)});
  return members;
}

std::vector<FamilyMember> chains(const FamilySize& size) {
  constexpr int kSizes[] = {2, 4, 8, 16, 32, 64, 100};
  std::vector<FamilyMember> members;
  for (int k = 0; k < size.robots && k < static_cast<int>(std::size(kSizes)); ++k) {
    members.push_back({fmt::format("{} joints", kSizes[k]), 1.0 * kSizes[k], random_robot(true, kSizes[k], size.seed)});
  }
  return members;
}

// A carrier of a motor: the joint's parent, or a link before it.
int random_carrier(const Robot& robot, int link, RandomHundredths& draw) {
  while (link != robot.root && draw.integer(0, 1) == 0) link = robot.joints[static_cast<std::size_t>(link - 1)].parent;
  return link;
}

Motor random_motor(const Robot& robot, int parent, RandomHundredths& draw) {
  Motor motor;
  motor.mass.number = draw.between(10, 99);
  motor.inertia_axial.number = draw.between(1, 99) / 1000;
  motor.inertia_transverse.number = motor.inertia_axial.number;
  motor.gear_ratio.number = draw.integer(-50, 120);
  motor.axis = {draw.any(), draw.any(), 1};
  motor.position = draw.vector();
  motor.carrier = random_carrier(robot, parent, draw);
  return motor;
}

// Trees with revolute and prismatic joints, some with motors on earlier links, some with friction.
std::vector<FamilyMember> trees(const FamilySize& size) {
  std::vector<FamilyMember> members;
  for (int k = 0; k < size.robots; ++k) {
    RandomHundredths draw(size.seed + static_cast<unsigned>(k));
    const int joints = draw.integer(2, size.joints + 2);
    Robot robot;
    robot.name = fmt::format("tree_{}", size.seed + static_cast<unsigned>(k));
    robot.root = 0;
    robot.links.push_back({"base", {}, {}});
    for (int i = 0; i < joints; ++i) {
      const int parent = draw.integer(std::max(0, i - 2), i);
      robot.links.push_back(random_link(draw, fmt::format("link_{}", i + 1)));
      Joint joint = random_joint(draw, fmt::format("joint_{}", i + 1), parent, i + 1);
      if (draw.integer(0, 2) == 0) joint.type = JointType::prismatic;
      if (draw.integer(0, 1) == 0) joint.viscous.number = draw.between(1, 99);
      if (draw.integer(0, 1) == 0) joint.motor = random_motor(robot, parent, draw);
      robot.joints.push_back(std::move(joint));
    }
    robot.tip = joints;
    members.push_back({robot.name, 1.0 * joints, std::move(robot)});
  }
  return members;
}

}  // namespace

const std::vector<FamilyEntry>& family_table() {
  static const std::vector<FamilyEntry> table = {
      {"inertia_ratios", "masses from 1e-9 to 1e9 along a chain", inertia_ratios},
      {"gear_ratios", "gear ratios to 1e5 with tiny rotors", gear_ratios},
      {"far_centres", "centres of mass kilometres from their joints", far_centres},
      {"near_parallel", "axes 1e-3 to 1e-12 rad from parallel", near_parallel},
      {"light_links", "links of next to no mass, at the tip and between equal axes", light_links},
      {"chains", "chains of 2 to 100 joints", chains},
      {"trees", "random trees with prismatic and revolute joints, motors and friction", trees},
  };
  return table;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Random robots with few digits, as a person might write them. Each is a robot file and can be simplified until little
// is left of it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace flatdyn {

using PlainVector = std::array<int, 3>;  // hundredths

inline constexpr PlainVector kNoVector = {0, 0, 0};

// A motor with an axis and a place of its own, in the carrier's frame.
struct PlainMotor {
  int mass = 0;      // kg/100
  int inertia = 0;   // I_m, kg m²/100,000
  int ratio = 1;     // k_r
  int carrier = -1;  // index of a link, as `parent`; -1: the joint's parent
  PlainVector axis = {0, 0, 100}, position = kNoVector;
  bool operator==(const PlainMotor&) const = default;
};

// One term of a joint position that follows another joint's coordinate.
struct PlainFollowing {
  int joint = 1;     // number of the other joint, from 1
  int factor = 100;  // hundredths
  bool operator==(const PlainFollowing&) const = default;
};

// A link and the joint that moves it. Its inertia is that of three particles, so it is physically consistent.
struct PlainLink {
  int parent = 0;  // 0: the base; k: link k
  bool is_prismatic = false;
  bool has_quarter_turns = false;  // rpy counts quarters of a turn
  PlainVector xyz = kNoVector, rpy = kNoVector, axis = {0, 0, 100};
  int mass = 0;  // kg/100
  PlainVector com = kNoVector;
  std::array<int, 3> particles = {0, 0, 0};  // kg/100, used for the inertia about the centre of mass only
  std::array<PlainVector, 3> arms = {};      // m/100
  int viscous = 0, coulomb = 0;              // hundredths
  std::vector<PlainFollowing> follows;       // the earlier joints that it follows
  bool has_coordinate = true;                // whether it has a coordinate of its own
  int offset = 0;                            // hundredths
  bool has_motor = false;
  PlainMotor motor;
  bool is_spherical = false;
  bool operator==(const PlainLink&) const = default;
};

struct PlainRobot {
  std::string name;
  std::vector<PlainLink> links;
  std::optional<PlainLink> base = {};  // of a floating base: its mass, centre and particles
};

// A random robot, mostly of 1 to 4 joints, some of up to 8: a chain or a tree of revolute and some prismatic joints,
// some along simple directions; half of the robots have motors, half friction, a third coupled joints. Of those without
// coupled joints, a third float, and a third have spherical joints. The same on every machine.
PlainRobot plain_robot(unsigned seed);

// The TOML robot file (docs/robot-format/toml.md); `comment`: lines for its top.
std::string robot_file(const PlainRobot& robot, const std::vector<std::string>& comment = {});

// Robots with one feature less: a link, a motor, friction, a direction, a digit. The largest simplifications come
// first.
std::vector<PlainRobot> simpler_robots(const PlainRobot& robot);

}  // namespace flatdyn

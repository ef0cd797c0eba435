// SPDX-License-Identifier: GPL-2.0-or-later
// Robots made in code, for tests of the stages after the readers.
#pragma once

#include <random>

#include "robot/model/robot.hpp"

namespace flatdyn::testing {

inline Displacement translation(const Vec3& t) { return {Displacement::Kind::translation, t, 0}; }
inline Displacement rotation(Displacement::Kind kind, const Number& angle) { return {kind, zero_vector(), angle}; }

// A link with all ten inertial parameters, about its centre of mass.
inline Link link(const std::string& name, const Number& mass, const Vec3& com, const Mat3& tensor) {
  Inertial inertial;
  inertial.mass.number = mass;
  inertial.centre_of_mass = com;
  inertial.tensor = tensor;
  return {name, {inertial}, {}};
}

inline Joint joint(const std::string& name, JointType type, int parent, int child, const Pose& origin,
                   const Vec3& axis) {
  Joint j;
  j.name = name;
  j.type = type;
  j.parent = parent;
  j.child = child;
  j.origin = origin;
  j.axis = axis;
  return j;
}

// Small exact random numbers, the same on every machine.
class Numbers {
 public:
  explicit Numbers(unsigned seed) : engine_(seed) {}

  int integer(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
  Number fraction() { return GiNaC::numeric(integer(-99, 99), 100); }
  Number positive() { return GiNaC::numeric(integer(10, 99), 100); }
  Vec3 vector() { return {fraction(), fraction(), fraction()}; }

 private:
  std::mt19937 engine_;
};

// The inertia tensor of a body of three point masses on skew arms, which is physically consistent.
inline Mat3 real_tensor(Numbers& numbers) {
  Mat3 tensor = zero_matrix();
  for (int k = 0; k < 3; ++k) tensor = tensor + steiner(numbers.positive(), numbers.vector());
  return tensor;
}

inline Motor motor(Numbers& numbers) {
  Motor m;
  m.mass.number = numbers.positive();
  m.inertia_axial.number = numbers.positive() / 1000;
  m.inertia_transverse.number = numbers.positive() / 1000;
  m.gear_ratio.number = numbers.integer(-50, 120);
  m.axis = {0, numbers.integer(0, 1), 1};
  m.position = numbers.vector();
  return m;
}

// A tree of revolute, prismatic and fixed joints in random directions, some of them simple, with motors and friction.
inline Robot random_tree(unsigned seed, int joints, bool chain = false) {
  Numbers numbers(seed);
  Robot robot;
  robot.name = "random_" + std::to_string(seed);
  robot.links.push_back({"base", {}, {}});
  robot.root = 0;
  static const JointType kTypes[] = {JointType::revolute, JointType::revolute, JointType::prismatic, JointType::fixed};
  for (int i = 0; i < joints; ++i) {
    const std::string n = std::to_string(i + 1);
    robot.links.push_back(link("link" + n, numbers.positive(), numbers.vector(), real_tensor(numbers)));
    const int parent = chain ? i : numbers.integer(std::max(0, i - 3), i);
    const bool nice = numbers.integer(0, 2) > 0;
    const Number roll = nice ? Number(GiNaC::Pi * numbers.integer(-2, 2) / 2) : numbers.fraction();
    const Number pitch = nice ? Number(0) : Number(numbers.fraction());
    const Pose origin{{translation(numbers.vector()), rotation(Displacement::Kind::rotation_y, pitch),
                       rotation(Displacement::Kind::rotation_x, roll)},
                      {}};
    const Vec3 axis =
        nice ? Vec3{0, 0, numbers.integer(0, 1) * 2 - 1} : Vec3{numbers.fraction(), numbers.fraction(), 1};
    Joint j = joint("joint" + n, kTypes[numbers.integer(0, i == 0 ? 2 : 3)], parent, i + 1, origin, axis);
    j.link_offset.displacements = {translation(numbers.vector()),
                                   rotation(Displacement::Kind::rotation_z, numbers.fraction())};
    j.viscous.number = numbers.positive();
    j.coulomb.number = numbers.positive();
    if (j.type != JointType::fixed && numbers.integer(0, 1) == 1) j.motor = motor(numbers);
    robot.joints.push_back(j);
  }
  robot.tip = joints;
  return robot;
}

}  // namespace flatdyn::testing

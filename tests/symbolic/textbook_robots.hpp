// SPDX-License-Identifier: GPL-2.0-or-later
// The textbook's robots with the textbook's symbols, made in code.
#pragma once

#include <string>

#include "support/robots.hpp"

namespace flatdyn::testing {

// The symbols of a robot by name, in the order of first use.
class Symbols {
 public:
  explicit Symbols(Robot& robot) : robot_(robot) {}

  Number operator()(const std::string& name) {
    for (const FreeSymbol& known : robot_.symbols) {
      if (known.name == name) return known.symbol;
    }
    robot_.symbols.push_back({GiNaC::symbol(name), name, {}});
    return robot_.symbols.back().symbol;
  }

 private:
  Robot& robot_;
};

// The value of a named symbol of the mechanism.
inline Number symbol(const Mechanism& mechanism, const std::string& name) {
  for (const FreeSymbol& known : mechanism.symbols) {
    if (known.name == name) return known.symbol;
  }
  throw std::invalid_argument(name);
}

inline Mat3 about_z(const Number& inertia) { return {Vec3{0, 0, 0}, Vec3{0, 0, 0}, Vec3{0, 0, inertia}}; }

inline Motor textbook_motor(Symbols& symbol, const std::string& i, bool with_mass) {
  Motor motor;
  motor.gear_ratio.number = symbol("k_r" + i);
  motor.inertia_axial.number = symbol("I_m" + i);
  if (with_mass) motor.mass.number = symbol("m_m" + i);
  return motor;
}

// 7.3.2, standard DH frames: frame i at the end of link i, centre of mass l_i from the joint. `shuffle` creates the
// symbols in another order, to test that it makes no difference.
inline Robot two_link_planar(bool shuffle = false) {
  Robot robot;
  robot.name = "two_link_planar";
  Symbols symbol(robot);
  if (shuffle) {
    for (const char* name : {"l_2", "m_l2", "g", "I_m2", "a_2", "m_m2", "I_l2", "k_r2", "l_1", "a_1", "m_l1"})
      symbol(name);
  }
  robot.links.push_back({"base", {}, {}});
  for (const std::string i : {"1", "2"}) {
    const int child = static_cast<int>(robot.links.size());
    robot.links.push_back(
        link("link" + i, symbol("m_l" + i), {symbol("l_" + i) - symbol("a_" + i), 0, 0}, about_z(symbol("I_l" + i))));
    Joint j = joint("joint" + i, JointType::revolute, child - 1, child, {}, {0, 0, 1});
    j.link_offset.displacements = {translation({symbol("a_" + i), 0, 0})};
    j.motor = textbook_motor(symbol, i, i == "2");
    robot.joints.push_back(j);
  }
  robot.root = 0;
  robot.tip = 2;
  robot.gravity = {0, -symbol("g"), 0};
  return robot;
}

// 7.3.1: d_1 upwards, d_2 to the side.
inline Robot two_link_cartesian() {
  Robot robot;
  robot.name = "two_link_cartesian";
  Symbols symbol(robot);
  robot.links.push_back({"base", {}, {}});
  for (const std::string i : {"1", "2"}) {
    const int child = static_cast<int>(robot.links.size());
    robot.links.push_back(link("link" + i, symbol("m_l" + i), {0, 0, symbol("l_" + i)}, about_z(symbol("I_l" + i))));
    const Pose origin{{rotation(Displacement::Kind::rotation_y, i == "1" ? Number(0) : Number(GiNaC::Pi / 2))}, {}};
    Joint j = joint("joint" + i, JointType::prismatic, child - 1, child, origin, {0, 0, 1});
    j.motor = textbook_motor(symbol, i, i == "2");
    j.motor->axis = i == "1" ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    robot.joints.push_back(j);
  }
  robot.root = 0;
  robot.tip = 2;
  robot.gravity = {0, 0, -symbol("g")};
  return robot;
}

// Example 7.1: q = 0 hangs down; I is about the axis.
inline Robot pendulum() {
  Robot robot;
  robot.name = "pendulum";
  Symbols symbol(robot);
  robot.links.push_back({"base", {}, {}});
  robot.links.push_back(
      link("rod", symbol("m"), {symbol("l"), 0, 0}, about_z(symbol("I") - symbol("m") * symbol("l") * symbol("l"))));
  Joint j = joint("hinge", JointType::revolute, 0, 1, {}, {0, 0, 1});
  j.motor = Motor{};
  j.motor->gear_ratio.number = symbol("k_r");
  j.motor->inertia_axial.number = symbol("I_m");
  j.viscous.number = symbol("F") + symbol("F_m") * symbol("k_r") * symbol("k_r");
  robot.joints.push_back(j);
  robot.root = 0;
  robot.tip = 1;
  robot.gravity = {symbol("g"), 0, 0};
  return robot;
}

}  // namespace flatdyn::testing

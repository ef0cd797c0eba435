// SPDX-License-Identifier: GPL-2.0-or-later
// Robots and states for tests of the numeric reference, made directly in its types, without files or the generator.
#pragma once

#include <random>

#include "flatdyn/reference/kinematics.hpp"
#include "flatdyn/reference/real50.hpp"

namespace flatdyn::testing {

using Digits50 = reference::Real50;

// Draws multiples of 1/128 below 1, which are the same in every scalar type, so that a robot exists in all of them.
template <class S>
class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  int integer(int low, int high) { return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1)); }
  S number() { return S(integer(-127, 127)) / S(128); }
  S positive() { return S(integer(13, 127)) / S(128); }
  reference::Vector3<S> vector() {
    const S x = number(), y = number(), z = number();
    return {x, y, z};
  }
  reference::Vector3<S> direction() {
    return reference::Vector3<S>(vector() + reference::Vector3<S>::UnitZ()).normalized();
  }
  reference::Matrix3<S> rotation() {
    const reference::Vector3<S> axis = direction();
    return reference::rotation_about(axis, S(3) * number());
  }
  reference::VectorX<S> vector(int n) {
    reference::VectorX<S> v(n);
    for (int k = 0; k < n; ++k) v[k] = number();
    return v;
  }

 private:
  std::mt19937 engine_;
};

struct RandomRobot {
  int joints = 5;
  bool chain = false;
  bool rotors = true;
  bool friction = true;
};

// A body of point masses, so its inertia is physically consistent.
template <class S>
reference::Inertial<S> random_body(Draw<S>& draw) {
  reference::Inertial<S> body;
  body.mass = draw.positive();
  body.r_C = draw.vector();
  for (int k = 0; k < 3; ++k) {
    const S m = draw.positive();
    const reference::Vector3<S> r = draw.vector();
    body.inertia += m * (r.dot(r) * reference::Matrix3<S>::Identity() - r * r.transpose());
  }
  return body;
}

// A chain or a tree of fixed, revolute and prismatic joints about any axes; the tip is the last link's frame,
// displaced. Rotors may be on any link that exists when their joint is made, not only on the joint's parent.
template <class S>
reference::Robot<S> random_reference_robot(unsigned seed, const RandomRobot& options = {}) {
  using reference::JointType;
  Draw<S> draw(seed);
  reference::Robot<S> robot;
  robot.gravity = S(10) * draw.vector();
  robot.links.resize(1);
  static constexpr JointType kTypes[] = {JointType::revolute, JointType::revolute, JointType::prismatic,
                                         JointType::fixed};
  int index = 0;
  for (int i = 0; i < options.joints; ++i) {
    reference::Joint<S> joint;
    joint.type = kTypes[draw.integer(0, i == 0 ? 2 : 3)];
    joint.parent = options.chain ? i : draw.integer(std::max(0, i - 2), i);
    joint.child = i + 1;
    joint.R_0 = draw.rotation();
    joint.R_1 = draw.rotation();
    joint.p_0 = draw.vector();
    joint.p_1 = draw.vector();
    joint.axis = draw.direction();
    if (joint.type != JointType::fixed) {
      joint.index = index++;
      joint.armature = draw.positive();
      if (options.friction) joint.viscous = draw.positive();
      if (options.friction) joint.coulomb = draw.positive();
      if (options.rotors) {
        joint.rotor = reference::Rotor<S>{draw.integer(0, i), S(draw.integer(-40, 60)), draw.positive() / S(64),
                                          draw.direction()};
      }
    }
    robot.joints.push_back(joint);
    robot.links.push_back({{random_body(draw)}});
  }
  robot.tip = options.joints;
  robot.R_tip = draw.rotation();
  robot.p_tip = draw.vector();
  return robot;
}

// A state of n joints with angles of some turns.
template <class S>
struct ReferenceState {
  ReferenceState(unsigned seed, int n) {
    Draw<S> draw(seed);
    q = S(3) * draw.vector(n);
    qd = S(4) * draw.vector(n);
    qdd = S(8) * draw.vector(n);
    tau = S(16) * draw.vector(n);
    h_e.f_e = S(32) * draw.vector();
    h_e.mu_e = S(32) * draw.vector();
  }
  reference::VectorX<S> q, qd, qdd, tau;
  reference::Environment<S> h_e;
};

}  // namespace flatdyn::testing

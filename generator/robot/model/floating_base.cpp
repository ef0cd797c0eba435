// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/floating_base.hpp"

#include <algorithm>

#include "robot/model/rational_rotation.hpp"

namespace flatdyn {
namespace {

constexpr int kDirections = 3;

// z of this frame is x of the parent's, x is y, and y is z.
constexpr int kCycled[3][3] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};

Body motion_of_base(int index, const std::string& link) {
  static const char* const kNames[] = {"base_x", "base_y", "base_z", "base_rx", "base_ry", "base_rz"};
  Mat3 cycled;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) cycled[i][j] = kCycled[i][j];
  }
  const ZxzAngles angles = zxz_angles(cycled);
  Body body;
  body.joint = kNames[index];
  body.link = link;
  body.parent = index - 1;
  body.prismatic = index < kDirections;
  body.continuous = !body.prismatic;
  body.beta = angles.beta;
  body.alpha = angles.alpha;
  body.theta = angles.theta;
  return body;
}

}  // namespace

bool Mechanism::has_base_gravity() const {
  return floating_base && !std::all_of(gravity.begin(), gravity.end(), vanishes);
}

Mechanism with_floating_base(Mechanism mechanism, const std::optional<BaseLimits>& limits) {
  constexpr int kBodies = 2 * kDirections;
  const auto shift = [](int& body) { body += kBodies; };  // the base, -1, becomes body 5
  for (Body& body : mechanism.bodies) {
    shift(body.parent);
    if (body.rotor) shift(body.rotor->carrier);
  }
  std::string base;
  for (WrittenLink& link : mechanism.links) {
    if (base.empty() && link.body < 0) base = link.link;
    shift(link.body);
  }
  shift(mechanism.tip.body);
  for (int& first : mechanism.spherical) shift(first);
  for (int& body : mechanism.coordinates) shift(body);
  if (mechanism.is_coupled()) {
    const std::vector<Number> nothing(mechanism.coordinates.size(), 0);
    mechanism.coupling.insert(mechanism.coupling.begin(), kBodies, nothing);
    mechanism.offsets.insert(mechanism.offsets.begin(), kBodies, 0);
  }
  for (LoopClosure& loop : mechanism.loops) {
    shift(loop.carrier);
    for (LoopClosure::End& end : loop.ends) shift(end.body);
  }
  for (Contact& contact : mechanism.contacts) shift(contact.frame.body);
  std::vector<Body> bodies;
  for (int k = 0; k < kBodies; ++k) {
    bodies.push_back(motion_of_base(k, base));
    if (limits) bodies.back().limits = k < kDirections ? limits->linear : limits->angular;
  }
  bodies.back().inertia = mechanism.base;
  mechanism.base = {};
  mechanism.bodies.insert(mechanism.bodies.begin(), bodies.begin(), bodies.end());
  mechanism.floating_base = true;
  return mechanism;
}

Mechanism with_base_joint(Mechanism mechanism, const BaseJoint& joint) {
  for (int k = 0; k < mechanism.base_bodies(); ++k) {
    Body& body = mechanism.bodies[static_cast<std::size_t>(k)];
    body.armature = rationalised(joint.armature.number);
    body.viscous = rationalised(joint.viscous.number);
    if (!body.prismatic) body.coulomb = rationalised(joint.coulomb.number);
  }
  return mechanism;
}

bool has_base_armature(const Mechanism& mechanism) {
  return mechanism.floating_base && !vanishes(mechanism.bodies.front().armature);
}

bool has_base_friction(const Mechanism& mechanism) {
  if (!mechanism.floating_base) return false;
  const Body& turning = mechanism.base_link();
  return !vanishes(turning.viscous) || !vanishes(turning.coulomb);
}

bool has_base_joint(const Mechanism& mechanism) { return has_base_armature(mechanism) || has_base_friction(mechanism); }

Mechanism without_base_joint(Mechanism mechanism) { return with_base_joint(std::move(mechanism), {}); }

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/mechanism.hpp"

#include <algorithm>

#include "model/rational_rotation.hpp"

namespace flatdyn {

Mat3 joint_axes(const Body& joint) {
  const Mat3 axes = rotation_z(joint.beta) * rotation_x(joint.alpha);
  return expanded(joint.prismatic ? axes * rotation_z(joint.theta) : axes);
}

std::vector<int> path_to(const Mechanism& mechanism, int body, int from) {
  std::vector<int> path;
  for (; body != from; body = mechanism.bodies[static_cast<std::size_t>(body)].parent) path.push_back(body);
  std::reverse(path.begin(), path.end());
  return path;
}

bool InertialParameters::is_zero() const {
  const auto all_vanish = [](const Vec3& v) { return std::all_of(v.begin(), v.end(), vanishes); };
  return vanishes(mass) && all_vanish(first_moment) && std::all_of(inertia.begin(), inertia.end(), all_vanish);
}

InertialParameters operator+(const InertialParameters& a, const InertialParameters& b) {
  return {(a.mass + b.mass).expand(), expanded(a.first_moment + b.first_moment), expanded(a.inertia + b.inertia)};
}

InertialParameters transformed(const InertialParameters& a, const Mat3& R, const Vec3& p) {
  const Vec3 h = R * a.first_moment;
  const Mat3 I = R * a.inertia * transpose(R);
  return {a.mass, expanded(h + a.mass * p), expanded(I + inertia_between(p, h) + steiner(a.mass, p))};
}

bool Mechanism::has_prismatic_joint() const {
  return std::any_of(bodies.begin(), bodies.end(), [](const Body& body) { return body.prismatic; });
}

Mat3 constant_rotation(const Body& body) {
  return expanded(rotation_z(body.beta) * rotation_x(body.alpha) * rotation_z(body.theta));
}

}  // namespace flatdyn

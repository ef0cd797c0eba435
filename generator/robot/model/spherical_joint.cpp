// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/spherical_joint.hpp"

#include "robot/model/rational_rotation.hpp"

namespace flatdyn {

std::array<Body, kSphericalBodies> bodies_of_spherical_joint(const Body& last) {
  static const char* const kNames[] = {".wx", ".wy", ".wz"};
  const ZxzAngles cycled = zxz_angles(with_columns_cycled(identity_matrix()));
  std::array<Body, kSphericalBodies> bodies;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    Body& body = bodies[k];
    body = last;
    body.joint += kNames[k];
    body.spherical = static_cast<int>(k) + 1;
    if (k + 1 < bodies.size()) body.inertia = {};
    if (k == 0) continue;
    body.p = zero_vector();
    body.beta = cycled.beta;
    body.alpha = cycled.alpha;
    body.theta = cycled.theta;
  }
  return bodies;
}

std::string spherical_joint_name(const std::string& body) { return body.substr(0, body.size() - 3); }

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The motion of the links of a tree of revolute joints over any field: (7.94)-(7.96), each in its own frame. The base
// is at rest, or its six bodies (robot/model/floating_base.hpp) all have its motion.
#pragma once

#include <vector>

#include "robot/model/body_poses.hpp"

namespace flatdyn {

template <class F>
struct FieldMotion {
  Vector3<F> omega, domega;  // angular velocity and acceleration
  Vector3<F> ddp;            // acceleration of the frame's origin less gravity
  F qd, qdd;                 // rate and acceleration of the joint that moves the link
};

// The motion of a base with this twist and its derivatives, in base axes.
template <class F>
FieldMotion<F> motion_of_base(const Vector3<F>& gravity, const std::vector<F>& twist, const std::vector<F>& rates) {
  const Vector3<F> v = {twist[0], twist[1], twist[2]}, omega = {twist[3], twist[4], twist[5]};
  const Vector3<F> dv = {rates[0], rates[1], rates[2]}, domega = {rates[3], rates[4], rates[5]};
  return {omega, domega, minus(plus(dv, cross(omega, v)), gravity), F(0), F(0)};
}

// The motions, by body. q, q̇ and q̈ are by body, too; those of the `base_bodies` first ones, none or six, are the base's
// twist and its derivatives.
template <class F>
std::vector<FieldMotion<F>> field_motions(const MechanismOver<F>& mechanism, const std::vector<JointPoint<F>>& q,
                                          const std::vector<F>& qd, const std::vector<F>& qdd, int base_bodies = 0) {
  const F zero = F(0);
  const Vector3<F> none = {zero, zero, zero};
  const FieldMotion<F> base = {none, none, minus(none, mechanism.gravity), zero, zero};
  std::vector<FieldMotion<F>> motions;
  if (base_bodies > 0) {
    motions.assign(static_cast<std::size_t>(base_bodies), motion_of_base(mechanism.gravity, qd, qdd));
  }
  for (std::size_t i = motions.size(); i < q.size(); ++i) {
    const FieldBody<F>& body = mechanism.bodies[i];
    const FieldMotion<F> before = body.parent < 0 ? base : motions[static_cast<std::size_t>(body.parent)];
    const auto in_link = [&](const Vector3<F>& v) {
      const Vector3<F> held = times(transposed(body.R), v);
      const F &c = q[i].c, &s = q[i].s;
      return Vector3<F>{c * held[0] + s * held[1], c * held[1] - s * held[0], held[2]};
    };
    const Vector3<F> carried = in_link(before.omega), rate = {zero, zero, qd[i]};
    const Vector3<F> lever = plus(cross(before.domega, body.p), cross(before.omega, cross(before.omega, body.p)));
    motions.push_back({plus(carried, rate),
                       plus(plus(in_link(before.domega), {zero, zero, qdd[i]}), cross(carried, rate)),
                       in_link(plus(before.ddp, lever)), qd[i], qdd[i]});
  }
  return motions;
}

}  // namespace flatdyn

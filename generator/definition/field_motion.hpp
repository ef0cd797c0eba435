// SPDX-License-Identifier: GPL-2.0-or-later
// The motion of the links of a tree of revolute joints over any field: (7.94)-(7.96), each in its own frame.
#pragma once

#include <vector>

#include "model/body_poses.hpp"

namespace flatdyn {

template <class F>
struct FieldMotion {
  Vector3<F> omega, domega;  // angular velocity and acceleration
  Vector3<F> ddp;            // acceleration of the frame's origin less gravity
  F qd, qdd;                 // rate and acceleration of the joint that moves the link
};

// The motions, by body.
template <class F>
std::vector<FieldMotion<F>> field_motions(const MechanismOver<F>& mechanism, const std::vector<JointPoint<F>>& q,
                                          const std::vector<F>& qd, const std::vector<F>& qdd) {
  const F zero = F(0);
  const Vector3<F> none = {zero, zero, zero};
  const FieldMotion<F> base = {none, none, minus(none, mechanism.gravity), zero, zero};
  std::vector<FieldMotion<F>> motions;
  for (std::size_t i = 0; i < q.size(); ++i) {
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

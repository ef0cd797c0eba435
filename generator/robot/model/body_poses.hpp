// SPDX-License-Identifier: GPL-2.0-or-later
// The positions of the joints of a tree, over any field, and the poses of the bodies that they move.
#pragma once

#include <vector>

#include "robot/model/field_mechanism.hpp"

namespace flatdyn {

// The position of joint i: its cosine c and sine s if it is revolute, its displacement d if it is prismatic. A revolute
// joint with a spring has its angle, too, as d.
template <class F>
struct JointPoint {
  F c = F(1), s = F(0), d = F(0);
};

// The position of a joint moving at a rate dq: dc = -s dq, ds = c dq.
template <class F>
JointPoint<Dual<F>> moving(const JointPoint<F>& q, const F& rate) {
  using D = Dual<F>;
  return {D(q.c, -q.s * rate), D(q.s, q.c * rate), D(q.d, rate)};
}

template <class F>
std::vector<JointPoint<Dual<F>>> moving(const std::vector<JointPoint<F>>& q, const std::vector<F>& rates) {
  std::vector<JointPoint<Dual<F>>> result;
  for (std::size_t i = 0; i < q.size(); ++i) result.push_back(moving(q[i], rates[i]));
  return result;
}

template <class F>
struct Pose3 {
  Matrix3<F> R;
  Vector3<F> p;
};

// The poses of all bodies in the base frame.
template <class S, class F>
std::vector<Pose3<S>> body_poses(const MechanismOver<F>& mechanism, const std::vector<JointPoint<S>>& q) {
  const S zero = S(F(0)), one = S(F(1));
  std::vector<Pose3<S>> poses;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const FieldBody<F>& body = mechanism.bodies[i];
    const Pose3<S> base{{{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}}, {zero, zero, zero}};
    const Pose3<S> parent = body.parent < 0 ? base : poses[static_cast<std::size_t>(body.parent)];
    Pose3<S> pose{times(parent.R, body.R), plus(parent.p, times(parent.R, body.p))};
    if (body.prismatic) {
      const Vector3<S> z = {pose.R[0][2], pose.R[1][2], pose.R[2][2]};
      pose.p = plus(pose.p, scaled(q[i].d, z));
    } else {
      for (Vector3<S>& row : pose.R)
        row = {row[0] * q[i].c + row[1] * q[i].s, row[1] * q[i].c - row[0] * q[i].s, row[2]};
    }
    poses.push_back(pose);
  }
  return poses;
}

}  // namespace flatdyn

// SPDX-License-Identifier: BSD-3-Clause
// Drives that lose a share c of the torque that they pass on: τ_d = τ + c |τ| s(q̇). For joints that are not coupled.
#pragma once

#include "flatdyn/reference/newton_euler_of_tree.hpp"

namespace flatdyn::reference {

namespace detail {

// By entry of q̇, c s.
template <class S>
VectorX<S> lost_shares(const Robot<S>& robot, const VectorX<S>& qd) {
  using std::tanh;
  VectorX<S> shares = VectorX<S>::Zero(qd.size());
  for (const Joint<S>& joint : robot.joints) {
    if (joint.index < 0 || joint.type == JointType::spherical) continue;
    const S& v = qd[joint.index];
    shares[joint.index] = joint.dry.load * (joint.dry.speed > S(0) ? S(tanh(v / joint.dry.speed)) : sign(v));
  }
  return shares;
}

}  // namespace detail

template <class S>
VectorX<S> drive_torque(const Robot<S>& robot, const VectorX<S>& qd, VectorX<S> tau) {
  const VectorX<S> shares = detail::lost_shares(robot, qd);
  for (Eigen::Index k = 0; k < tau.size(); ++k) tau[k] *= S(1) + shares[k] * detail::sign(tau[k]);
  return tau;
}

template <class S>
VectorX<S> torque_from_drive(const Robot<S>& robot, const VectorX<S>& qd, VectorX<S> tau_d) {
  const VectorX<S> shares = detail::lost_shares(robot, qd);
  for (Eigen::Index k = 0; k < tau_d.size(); ++k) tau_d[k] /= S(1) + shares[k] * detail::sign(tau_d[k]);
  return tau_d;
}

}  // namespace flatdyn::reference

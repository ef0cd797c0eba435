// SPDX-License-Identifier: BSD-3-Clause
// The dynamics by the recursive Newton–Euler algorithm, in the robot's coordinates. It shares no code with the
// generator; generated code is compared with it.
#pragma once

#include "flatdyn/reference/closed_loops.hpp"

namespace flatdyn::reference {

// The motion of every link for q, q̇ and q̈.
template <class S>
std::vector<LinkMotion<S>> link_motions(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd,
                                        const VectorX<S>& qdd, bool gravity) {
  VectorX<S> positions, rates, accelerations;
  return detail::motions_of_tree(robot, positions_of_joints(robot, q, positions), rates_of_joints(robot, q, qd, rates),
                                 accelerations_of_joints(robot, q, qd, qdd, accelerations), gravity);
}

// τ = B q̈ + C q̇ + F_v q̇ + F_s sgn(q̇) + g + k (q - q_0) + Jᵀ h_e, (7.42); N m, or N for prismatic joints.
template <class S>
VectorX<S> inverse_dynamics(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd, const VectorX<S>& qdd,
                            const Environment<S>& environment = {}) {
  VectorX<S> positions, rates, accelerations;
  return at_coordinates(
      robot, q,
      detail::torques_of_tree(robot, positions_of_joints(robot, q, positions), rates_of_joints(robot, q, qd, rates),
                              accelerations_of_joints(robot, q, qd, qdd, accelerations), environment));
}

// B, column by column, 7.6: torques for g_0 = 0, q̇ = 0, q̈ = e_i.
template <class S>
MatrixX<S> inertia_matrix(const Robot<S>& robot, const VectorX<S>& q) {
  const Eigen::Index n = robot.size();
  const VectorX<S> zero = VectorX<S>::Zero(n);
  MatrixX<S> B(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    VectorX<S> unit = zero;
    unit[i] = S(1);
    B.col(i) = inverse_dynamics(robot, q, zero, unit, {.gravity = false, .friction = false, .springs = false});
  }
  return B;
}

// C q̇ + F_v q̇ + F_s sgn(q̇) + g + k (q - q_0), 7.6: the torques for q̈ = 0.
template <class S>
VectorX<S> bias(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd) {
  return inverse_dynamics(robot, q, qd, VectorX<S>(VectorX<S>::Zero(robot.size())));
}

template <class S>
VectorX<S> gravity(const Robot<S>& robot, const VectorX<S>& q) {
  const VectorX<S> zero = VectorX<S>::Zero(robot.size());
  return inverse_dynamics(robot, q, zero, zero, {.springs = false});
}

// q̈ from B q̈ = τ - bias by Cholesky factorisation.
template <class S>
VectorX<S> forward_dynamics(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd, const VectorX<S>& tau) {
  const VectorX<S> rest = tau - bias(robot, q, qd);
  return inertia_matrix(robot, q).llt().solve(rest);
}

// c_ijk of (7.45) in row i and column k(k+1)/2 + j for j <= k. The velocity torque n(q̇) is a quadratic form, so c_ijj
// = n_i(e_j) and c_ijk = ½ (n_i(e_j + e_k) - n_i(e_j) - n_i(e_k)).
template <class S>
MatrixX<S> christoffel(const Robot<S>& robot, const VectorX<S>& q) {
  const Eigen::Index n = robot.size();
  const VectorX<S> zero = VectorX<S>::Zero(n);
  const auto velocity_torque = [&](const VectorX<S>& qd) {
    return inverse_dynamics(robot, q, qd, zero, {.gravity = false, .friction = false, .springs = false});
  };
  const auto column = [](Eigen::Index j, Eigen::Index k) { return k * (k + 1) / 2 + j; };
  MatrixX<S> c(n, n * (n + 1) / 2);
  for (Eigen::Index k = 0; k < n; ++k) c.col(column(k, k)) = velocity_torque(VectorX<S>::Unit(n, k));
  for (Eigen::Index k = 0; k < n; ++k) {
    for (Eigen::Index j = 0; j < k; ++j) {
      const VectorX<S> both = velocity_torque(VectorX<S>::Unit(n, j) + VectorX<S>::Unit(n, k));
      c.col(column(j, k)) = (both - c.col(column(j, j)) - c.col(column(k, k))) / S(2);
    }
  }
  return c;
}

// [ν, δ] of two twists of a floating base: (ω × δ_v - δ_ω × v, ω × δ_ω).
template <class S>
VectorX<S> bracket(const VectorX<S>& twist, const VectorX<S>& delta) {
  const Vector3<S> v = twist.template head<3>(), omega = twist.template segment<3>(3),
                   delta_v = delta.template head<3>(), delta_omega = delta.template segment<3>(3);
  VectorX<S> result(6);
  result << omega.cross(delta_v) - delta_omega.cross(v), omega.cross(delta_omega);
  return result;
}

// C of (7.44): c_ij = Σ_k c_ijk q̇_k. With a floating base or spherical joints, the part of C that is not symmetric in
// both velocities, ½ B [ν, ·], is added, so that Ḃ - 2 C is skew-symmetric there, too.
template <class S>
MatrixX<S> coriolis_matrix(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd) {
  const Eigen::Index n = robot.size();
  const MatrixX<S> c = christoffel(robot, q);
  MatrixX<S> C = MatrixX<S>::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index k = 0; k < n; ++k) {
      const Eigen::Index low = std::min(j, k), high = std::max(j, k);
      C.col(j) += c.col(high * (high + 1) / 2 + low) * qd[k];
    }
  }
  const bool all_are_rates = !robot.floating_base && !has_spherical_joints(robot);
  if (all_are_rates) return C;
  const MatrixX<S> B = inertia_matrix(robot, q);
  for (const Joint<S>& joint : robot.joints) {
    if (joint.type != JointType::spherical) continue;
    const Vector3<S> omega = qd.template segment<3>(joint.index);
    for (int j = 0; j < 3; ++j) {
      C.col(joint.index + j) +=
          B.template middleCols<3>(joint.index) * omega.cross(Vector3<S>(Vector3<S>::Unit(j))) / S(2);
    }
  }
  for (Eigen::Index j = 0; j < robot.base_size(); ++j) {
    const VectorX<S> unit = VectorX<S>::Unit(robot.base_size(), j);
    C.col(j) += B.leftCols(robot.base_size()) * bracket(VectorX<S>(qd.head(robot.base_size())), unit) / S(2);
  }
  return C;
}

}  // namespace flatdyn::reference

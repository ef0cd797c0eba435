// SPDX-License-Identifier: BSD-3-Clause
// The reference's dynamics in the operational space of the tip, (7.130)–(7.141), by inverting matrices as the textbook
// writes it: with the geometric Jacobian or, if the task has Euler angles, with the analytical one, (3.62).
#pragma once

#include "flatdyn/reference/euler_angles.hpp"

namespace flatdyn::reference {

// The task. rows: those of the Jacobian, 0 to 5. B_A is the inverse of J B^-1 Jᵀ + damping² 1.
template <class S>
struct Task {
  std::vector<int> rows;
  Angles angles = Angles::none;
  S damping = S(0);
};

template <class S>
struct OperationalSpace {
  MatrixX<S> J, B_inverse, B_A;  // r × n, n × n, r × r
};

template <class S>
MatrixX<S> task_jacobian(const Robot<S>& robot, const VectorX<S>& q, const Task<S>& task) {
  MatrixX<S> J = jacobian(robot, q);
  if (task.angles != Angles::none) {
    const Matrix3<S> T = rates_to_velocity(euler_angles(tip_pose(robot, q).R, task.angles), task.angles);
    J.template bottomRows<3>() = MatrixX<S>(T.inverse() * J.template bottomRows<3>());
  }
  return MatrixX<S>(J(task.rows, Eigen::all));
}

// J̇ q̇ of the same rows; for angles T^-1 (ω̇ - Ṫ φ̇).
template <class S>
VectorX<S> task_drift(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd, const Task<S>& task) {
  VectorX<S> drift = jacobian_dot_qd(robot, q, qd);
  if (task.angles != Angles::none) {
    const Vector3<S> angles = euler_angles(tip_pose(robot, q).R, task.angles);
    const Matrix3<S> inverse = rates_to_velocity(angles, task.angles).inverse();
    const Vector3<S> omega = jacobian(robot, q).template bottomRows<3>() * qd;
    const Vector3<S> rates = inverse * omega;
    const Vector3<S> turning = rates_to_velocity_dot(angles, rates, task.angles) * rates;
    drift.template tail<3>() = Vector3<S>(inverse * (drift.template tail<3>() - turning));
  }
  return VectorX<S>(drift(task.rows));
}

template <class S>
OperationalSpace<S> operational_space(const Robot<S>& robot, const VectorX<S>& q, const Task<S>& task) {
  OperationalSpace<S> space;
  space.J = task_jacobian(robot, q, task);
  space.B_inverse = inertia_matrix(robot, q).inverse();
  MatrixX<S> mobility = space.J * space.B_inverse * space.J.transpose();
  mobility.diagonal().array() += task.damping * task.damping;
  space.B_A = mobility.inverse();
  return space;
}

// J̄ = B^-1 Jᵀ B_A, n × r.
template <class S>
MatrixX<S> consistent_inverse(const OperationalSpace<S>& space) {
  return space.B_inverse * space.J.transpose() * space.B_A;
}

// The condition measure r² / (tr M tr M^-1) of the matrix M whose inverse is B_A.
template <class S>
S condition(const OperationalSpace<S>& space) {
  const MatrixX<S> M = space.B_A.inverse();
  return S(M.rows() * M.rows()) / (M.trace() * space.B_A.trace());
}

// C_A ẋ, without joint friction.
template <class S>
VectorX<S> operational_coriolis(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd, const Task<S>& task) {
  const OperationalSpace<S> space = operational_space(robot, q, task);
  const VectorX<S> zero = VectorX<S>::Zero(robot.size());
  const VectorX<S> c = inverse_dynamics(robot, q, qd, zero, {.gravity = false, .friction = false, .springs = false});
  return space.B_A * (space.J * space.B_inverse * c - task_drift(robot, q, qd, task));
}

template <class S>
VectorX<S> operational_gravity(const Robot<S>& robot, const VectorX<S>& q, const Task<S>& task) {
  const OperationalSpace<S> space = operational_space(robot, q, task);
  return space.B_A * space.J * space.B_inverse * gravity(robot, q);
}

// (1 − Jᵀ J̄ᵀ) τ, the torques in the null space.
template <class S>
VectorX<S> null_space_torque(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& tau, const Task<S>& task) {
  const OperationalSpace<S> space = operational_space(robot, q, task);
  return tau - space.J.transpose() * (consistent_inverse(space).transpose() * tau);
}

}  // namespace flatdyn::reference

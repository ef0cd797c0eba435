// SPDX-License-Identifier: BSD-3-Clause
// The reference's dynamics in the operational space of the tip, (7.130)–(7.141), by inverting matrices as the textbook
// writes it. task: rows of the geometric Jacobian, 0 to 5.
#pragma once

#include "flatdyn/reference/kinematics.hpp"

namespace flatdyn::reference {

template <class S>
struct OperationalSpace {
  MatrixX<S> J, B_inverse, B_A;  // r × n, n × n, r × r
};

template <class S>
OperationalSpace<S> operational_space(const Robot<S>& robot, const VectorX<S>& q, const std::vector<int>& task) {
  OperationalSpace<S> space;
  space.J = MatrixX<S>(jacobian(robot, q)(task, Eigen::all));
  space.B_inverse = inertia_matrix(robot, q).inverse();
  space.B_A = MatrixX<S>(space.J * space.B_inverse * space.J.transpose()).inverse();
  return space;
}

// J̄ = B^-1 Jᵀ B_A, n × r.
template <class S>
MatrixX<S> consistent_inverse(const OperationalSpace<S>& space) {
  return space.B_inverse * space.J.transpose() * space.B_A;
}

// C_A ẋ; joint friction is left out.
template <class S>
VectorX<S> operational_coriolis(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd,
                                const std::vector<int>& task) {
  const OperationalSpace<S> space = operational_space(robot, q, task);
  const VectorX<S> zero = VectorX<S>::Zero(q.size());
  const VectorX<S> c = inverse_dynamics(robot, q, qd, zero, {.gravity = false, .friction = false});
  return space.B_A * (space.J * space.B_inverse * c - VectorX<S>(jacobian_dot_qd(robot, q, qd)(task)));
}

template <class S>
VectorX<S> operational_gravity(const Robot<S>& robot, const VectorX<S>& q, const std::vector<int>& task) {
  const OperationalSpace<S> space = operational_space(robot, q, task);
  return space.B_A * space.J * space.B_inverse * gravity(robot, q);
}

// (1 − Jᵀ J̄ᵀ) τ.
template <class S>
VectorX<S> null_space_torque(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& tau,
                             const std::vector<int>& task) {
  const OperationalSpace<S> space = operational_space(robot, q, task);
  return tau - space.J.transpose() * (consistent_inverse(space).transpose() * tau);
}

}  // namespace flatdyn::reference

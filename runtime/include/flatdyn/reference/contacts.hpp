// SPDX-License-Identifier: BSD-3-Clause
// The reference's dynamics at contacts with something that does not move: B a + n = τ + Jᵀ f, J a + J̇ q̇ = 0. Forces f
// are those on the robot, in base axes; with damping, (J B^-1 Jᵀ + λ² 1) f = -(J a_free + J̇ q̇).
#pragma once

#include "flatdyn/reference/kinematics.hpp"

namespace flatdyn::reference {

// The robot with a contact's point as its tip.
template <class S>
Robot<S> with_tip_at(Robot<S> robot, const Contact<S>& contact) {
  robot.tip = contact.link;
  robot.R_tip.setIdentity();
  robot.p_tip = contact.point;
  return robot;
}

template <class S>
int contact_rows(const Robot<S>& robot) {
  int rows = 0;
  for (const Contact<S>& contact : robot.contacts) rows += contact.rows();
  return rows;
}

// Calls use(robot, first, rows) for each contact: the robot with its tip there, and the contact's rows.
template <class S, class Use>
void for_each_contact(const Robot<S>& robot, Use use) {
  Eigen::Index first = 0;
  for (const Contact<S>& contact : robot.contacts) {
    use(with_tip_at(robot, contact), first, static_cast<Eigen::Index>(contact.rows()));
    first += contact.rows();
  }
}

// The contacts' positions in the base frame, m.
template <class S>
VectorX<S> contact_positions(const Robot<S>& robot, const VectorX<S>& q) {
  VectorX<S> positions(3 * static_cast<Eigen::Index>(robot.contacts.size()));
  Eigen::Index next = 0;
  for_each_contact(robot, [&](const Robot<S>& there, Eigen::Index, Eigen::Index) {
    positions.template segment<3>(next) = tip_pose(there, q).p;
    next += 3;
  });
  return positions;
}

template <class S>
MatrixX<S> contact_jacobian(const Robot<S>& robot, const VectorX<S>& q) {
  MatrixX<S> J(contact_rows(robot), robot.size());
  for_each_contact(robot, [&](const Robot<S>& there, Eigen::Index first, Eigen::Index rows) {
    J.middleRows(first, rows) = jacobian(there, q).topRows(rows);
  });
  return J;
}

template <class S>
VectorX<S> contact_drift(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd) {
  VectorX<S> drift(contact_rows(robot));
  for_each_contact(robot, [&](const Robot<S>& there, Eigen::Index first, Eigen::Index rows) {
    drift.segment(first, rows) = jacobian_dot_qd(there, q, qd).head(rows);
  });
  return drift;
}

// Axes t_1, t_2, n with n against gravity: t_1 and t_2 are x and y of the base frame in the mirror that takes its z
// axis to n or to -n, whichever is farther away.
template <class S>
Matrix3<S> axes_against_gravity(const Robot<S>& robot) {
  const Vector3<S> n = -robot.gravity / robot.gravity.norm();
  const Vector3<S> v = n - (robot.gravity[2] < S(0) ? S(-1) : S(1)) * Vector3<S>::UnitZ();
  const Matrix3<S> mirror = Matrix3<S>::Identity() - S(2) / v.squaredNorm() * v * v.transpose();
  Matrix3<S> axes;
  axes << mirror.col(0), mirror.col(1), n;
  return axes;
}

// A with A f <= 0 where friction holds all contacts.
template <class S>
MatrixX<S> friction_cones(const Robot<S>& robot, const VectorX<S>& q) {
  Eigen::Index rows = 0, row = 0;
  for (const Contact<S>& contact : robot.contacts) rows += static_cast<Eigen::Index>(contact.cone.size());
  MatrixX<S> A = MatrixX<S>::Zero(rows, contact_rows(robot));
  std::size_t next = 0;
  for_each_contact(robot, [&](const Robot<S>& there, Eigen::Index first, Eigen::Index length) {
    const Contact<S>& contact = robot.contacts[next++];
    if (contact.cone.empty()) return;
    const Matrix3<S> axes = contact.is_against_gravity ? axes_against_gravity(robot) : Matrix3<S>(tip_pose(there, q).R);
    for (const std::array<S, 6>& condition : contact.cone) {
      for (Eigen::Index k = 0; k < length; k += 3) {
        const auto at = static_cast<std::size_t>(k);
        const Vector3<S> own(condition[at], condition[at + 1], condition[at + 2]);
        A.row(row).segment(first + k, 3) = (axes * own).transpose();
      }
      ++row;
    }
  });
  return A;
}

// J, B^-1 and M = J B^-1 Jᵀ + λ² 1.
template <class S>
struct ContactSpace {
  MatrixX<S> J, B_inverse, M;
};

template <class S>
ContactSpace<S> contact_space(const Robot<S>& robot, const VectorX<S>& q) {
  ContactSpace<S> space{contact_jacobian(robot, q), inertia_matrix(robot, q).inverse(), {}};
  space.M = space.J * space.B_inverse * space.J.transpose();
  space.M.diagonal().array() += robot.contact_damping * robot.contact_damping;
  return space;
}

// The motion, and the forces or impulses of the contacts.
template <class S>
struct Held {
  VectorX<S> motion, forces;
};

template <class S>
Held<S> constrained_forward_dynamics(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd,
                                     const VectorX<S>& tau) {
  const ContactSpace<S> space = contact_space(robot, q);
  const VectorX<S> free = forward_dynamics(robot, q, qd, tau);
  const VectorX<S> accelerations = space.J * free + contact_drift(robot, q, qd);
  const VectorX<S> forces = -(space.M.inverse() * accelerations);
  return {free + space.B_inverse * (space.J.transpose() * forces), forces};
}

// The velocity after an impact that stops the contacts, and the impulses, N s.
template <class S>
Held<S> contact_impact(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd) {
  const ContactSpace<S> space = contact_space(robot, q);
  const VectorX<S> impulses = -(space.M.inverse() * (space.J * qd));
  return {qd + space.B_inverse * (space.J.transpose() * impulses), impulses};
}

// The base's rows of Jᵀ: the force and moment on the base by the contacts' forces.
template <class S>
MatrixX<S> support_of_base(const Robot<S>& robot, const VectorX<S>& q) {
  return contact_jacobian(robot, q).template leftCols<6>().transpose();
}

// The torques for a motion of a robot with a floating base, whose first six are zero, and the smallest forces.
template <class S>
Held<S> contact_inverse_dynamics(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd,
                                 const VectorX<S>& qdd) {
  const MatrixX<S> A = support_of_base(robot, q);
  VectorX<S> tau = inverse_dynamics(robot, q, qd, qdd);
  const MatrixX<S> square = A * A.transpose();
  const VectorX<S> forces = A.transpose() * (square.inverse() * tau.template head<6>());
  tau -= contact_jacobian(robot, q).transpose() * forces;
  tau.template head<6>().setZero();
  return {tau, forces};
}

// r / Σ M_kk / d_k of M = Lᵀ D L: between 0, where a row follows from others, and 1, where none depends on another.
template <class S>
S pivot_condition(const MatrixX<S>& M) {
  S sum(0);
  for (Eigen::Index k = 0; k < M.rows(); ++k) {
    const Eigen::Index rest = M.rows() - k;
    const MatrixX<S> inverse = M.bottomRightCorner(rest, rest).inverse();
    sum += M(k, k) * inverse(0, 0);
  }
  return S(static_cast<int>(M.rows())) / sum;
}

// The moments of inertia of the contacts' points, as masses of 1, about their mean; those of surfaces are 1 in
// addition.
template <class S>
Matrix3<S> moments_of_support(const Robot<S>& robot, const VectorX<S>& q) {
  const MatrixX<S> A = support_of_base(robot, q), square = A * A.transpose();
  const Matrix3<S> coupled = square.template bottomLeftCorner<3, 3>();
  return square.template bottomRightCorner<3, 3>() - coupled * coupled.transpose() / square(0, 0);
}

}  // namespace flatdyn::reference

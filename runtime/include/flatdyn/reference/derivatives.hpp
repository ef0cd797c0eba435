// SPDX-License-Identifier: BSD-3-Clause
// Derivatives of the reference's functions by positions and velocities, computed one direction at a time.
#pragma once

#include "flatdyn/reference/newton_euler.hpp"
#include "flatdyn/reference/tangent.hpp"

namespace flatdyn::reference {

// Derivatives by q (per rad or m) and by q̇ (per rad/s or m/s): row i for entry i, column k for joint k. With a floating
// base, the first six columns by q are those of its displacement along its axes and of its turn about them, R ← R
// exp(S(δ)), with the components of velocities, accelerations and forces in its axes held fixed; so are the three
// columns of a spherical joint, which turn its child. With closed loops, columns are those of the independent joints,
// with which the others move along.
template <class S>
struct Derivatives {
  MatrixX<S> dq, dqd;
};

// Lets gravity in base axes change as the base turns about its axis j: g_b ← g_b + g_b × δ.
template <class S>
void turn_gravity(Robot<Tangent<S>>& robot, Eigen::Index j) {
  const Vector3<S> g(robot.gravity[0].value, robot.gravity[1].value, robot.gravity[2].value);
  const Vector3<S> along = g.cross(Vector3<S>::Unit(j));
  for (Eigen::Index i = 0; i < 3; ++i) robot.gravity[i].slope = along[i];
}

// Lets a spherical joint turn its child about axis a of the joint.
template <class S>
void turn_child(Joint<Tangent<S>>& joint, Eigen::Index a) {
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto entry = [&](Eigen::Index j) { return joint.orientation(i, j).value; };
    const Vector3<S> along = Vector3<S>(entry(0), entry(1), entry(2)).cross(Vector3<S>::Unit(a));
    for (Eigen::Index j = 0; j < 3; ++j) joint.orientation(i, j).slope = along[j];
  }
}

// The robot as entry k of q̇ moves its positions, apart from those that are in q.
template <class S>
Robot<Tangent<S>> turned_along(Robot<Tangent<S>> robot, Eigen::Index k) {
  if (robot.floating_base && 3 <= k && k < 6) turn_gravity(robot, k - 3);
  for (Joint<Tangent<S>>& joint : robot.joints) {
    const bool is_own = joint.type == JointType::spherical && joint.index <= k && k < joint.index + joint.size();
    if (is_own) turn_child(joint, k - joint.index);
  }
  return robot;
}

// The derivatives of inverse_dynamics; sgn counts as constant.
template <class S>
Derivatives<S> inverse_dynamics_derivatives(const Robot<S>& robot, const VectorX<S>& q, const VectorX<S>& qd,
                                            const VectorX<S>& qdd) {
  using T = Tangent<S>;
  const Robot<T> lifted = with_tangents(robot);
  const Eigen::Index n = robot.size(), base = robot.base_size();
  const auto slope = [n](const VectorX<T>& tau) {
    VectorX<S> column(n);
    for (Eigen::Index i = 0; i < n; ++i) column[i] = tau[i].slope;
    return column;
  };
  const auto constant = [](const VectorX<S>& x) {
    VectorX<T> result(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) result[i] = T(x[i]);
    return result;
  };
  VectorX<T> q_t = constant(q), qd_t = constant(qd);
  const VectorX<T> qdd_t = constant(qdd);
  const MatrixX<S> along =
      robot.loops.empty() ? MatrixX<S>(MatrixX<S>::Identity(q.size(), n - base)) : MatrixX<S>(loop_motion(robot, q));
  Derivatives<S> result{MatrixX<S>::Zero(n, n), MatrixX<S>(n, n)};
  for (Eigen::Index k = base / 2; k < n; ++k) {
    for (Eigen::Index p = 0; p < q.size(); ++p) q_t[p].slope = k < base ? S(0) : along(p, k - base);
    result.dq.col(k) = slope(inverse_dynamics(turned_along<S>(lifted, k), q_t, qd_t, qdd_t));
  }
  for (Eigen::Index p = 0; p < q.size(); ++p) q_t[p].slope = S(0);
  for (Eigen::Index k = 0; k < n; ++k) {
    qd_t[k].slope = S(1);
    result.dqd.col(k) = slope(inverse_dynamics(lifted, q_t, qd_t, qdd_t));
    qd_t[k].slope = S(0);
  }
  return result;
}

// The derivatives of forward_dynamics, from B q̈ + n(q, q̇) = τ: B ∂q̈ = -∂(B q̈ + n). B⁻¹ is the derivative by τ.
template <class S>
struct AccelerationDerivatives {
  MatrixX<S> dq, dqd, dtau;
};

template <class S>
AccelerationDerivatives<S> forward_dynamics_derivatives(const Robot<S>& robot, const VectorX<S>& q,
                                                        const VectorX<S>& qd, const VectorX<S>& tau) {
  const Eigen::Index n = robot.size();
  const VectorX<S> qdd = forward_dynamics(robot, q, qd, tau);
  const Derivatives<S> torques = inverse_dynamics_derivatives(robot, q, qd, qdd);
  const auto B = inertia_matrix(robot, q).llt();
  return {-B.solve(torques.dq), -B.solve(torques.dqd), B.solve(MatrixX<S>(MatrixX<S>::Identity(n, n)))};
}

}  // namespace flatdyn::reference

// SPDX-License-Identifier: GPL-2.0-or-later
// The derivatives of inverse and forward dynamics from the Lagrangian, over dual numbers of the field.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "robot/model/quasi_velocities.hpp"
#include "truth/definition/lagrangian.hpp"

namespace flatdyn {

// Arithmetic over dual numbers for the robot's own numbers, which are constant, but for a spherical joint that turns.
template <class Arithmetic>
struct ConstantArithmetic {
  using F = typename Arithmetic::Scalar;
  using Scalar = Dual<F>;
  Arithmetic& field;
  std::array<F, 4> rates{F(0), F(0), F(0), F(0)};  // of the joint's quaternion
  int quaternion = -1;                             // its first entry in q; -1: none turns

  Scalar constant(const Rational& value) const { return Scalar(field.constant(value)); }
  Scalar input(const Input& input) const {
    const int entry = input.index - quaternion;
    const bool turns = quaternion >= 0 && input.kind == InputKind::q && 0 <= entry && entry < 4;
    return Scalar(field.input(input), turns ? rates[static_cast<std::size_t>(entry)] : F(0));
  }
  Scalar divide(const Scalar& a, const Scalar& b) const { return Scalar(field.divide(a.value, b.value)); }
  Scalar sin(const Graph& graph, NodeId angle, const Scalar& value) const {
    return Scalar(field.sin(graph, angle, value.value));
  }
  Scalar cos(const Graph& graph, NodeId angle, const Scalar& value) const {
    return Scalar(field.cos(graph, angle, value.value));
  }
  Scalar tanh(const Scalar& x) const { return Scalar(tanh_in(field, x.value)); }
};

template <class F>
struct FieldState {
  std::vector<JointPoint<F>> q;
  std::vector<F> qd, qdd, sign_qd;  // sign_qd: by body's joint
  Vector3<F> gravity;               // in the axes of the base
};

// The derivative of gravity in base axes along column k: g_b × δ where it turns a floating base, R ← R exp(S(δ)).
template <class F>
Vector3<F> gravity_along(const Mechanism& mechanism, const Vector3<F>& gravity, int k) {
  Vector3<F> turn = {F(0), F(0), F(0)};
  if (mechanism.is_of_base(k) && k >= 3) turn[static_cast<std::size_t>(k - 3)] = F(1);
  return cross(gravity, turn);
}

// Arithmetic in which the spherical joint of body k turns about that body's axis, R ← R exp(S(δ)):
// q̇ = ½ q (0, e).
template <class Arithmetic>
ConstantArithmetic<Arithmetic> turning(const Mechanism& mechanism, Arithmetic& arithmetic, int k) {
  using F = typename Arithmetic::Scalar;
  ConstantArithmetic<Arithmetic> result{arithmetic};
  if (!mechanism.is_of_spherical(k)) return result;
  result.quaternion = mechanism.quaternion_of(k);
  const auto entry = [&](int i) { return arithmetic.input({InputKind::q, result.quaternion + i}); };
  const auto axis = static_cast<std::size_t>(mechanism.bodies[static_cast<std::size_t>(k)].spherical - 1);
  const Vector3<F> r = {entry(1), entry(2), entry(3)};
  Vector3<F> half = {F(0), F(0), F(0)};
  half[axis] = F(1) / F(2);
  const Vector3<F> across = cross(r, half);
  result.rates[0] = -(r[axis] * half[axis]);
  for (std::size_t i = 0; i < 3; ++i) result.rates[i + 1] = entry(0) * half[i] + across[i];
  return result;
}

// ∂τ/∂q, column by column: τ over dual numbers, with dc = -s dq, ds = c dq. A floating base's displacement changes
// nothing, and its turn changes gravity in its axes, while the components of velocities and accelerations are held; so
// are they where the link of a spherical joint turns. With closed loops, all joints move along with the independent
// ones.
template <class Arithmetic, class F = typename Arithmetic::Scalar>
Matrix<F> torques_by_position(const Mechanism& mechanism, Arithmetic& arithmetic, const FieldState<F>& state) {
  using D = Dual<F>;
  const auto constant = [](const std::vector<F>& values) { return std::vector<D>(values.begin(), values.end()); };
  const MechanismOver<F> constants = closed_at(mechanism_over(mechanism, arithmetic), state.q);
  Matrix<F> result(mechanism.size(), mechanism.size());
  for (int k = 0; k < mechanism.size(); ++k) {
    ConstantArithmetic<Arithmetic> over_duals = turning(mechanism, arithmetic, k);
    MechanismOver<D> field = mechanism_over(mechanism, over_duals);
    std::vector<F> direction(static_cast<std::size_t>(mechanism.size()), F(0));
    if (!mechanism.is_around_pose(k)) direction[static_cast<std::size_t>(k)] = F(1);
    const Vector3<F> turned = gravity_along(mechanism, state.gravity, k);
    for (std::size_t i = 0; i < 3; ++i) field.gravity[i] = D(state.gravity[i], turned[i]);
    const std::vector<F> rates = joint_values(constants, direction);
    std::vector<JointPoint<D>> q;
    for (const JointPoint<F>& point : state.q) {
      const F& rate = rates[q.size()];
      q.push_back({D(point.c, -point.s * rate), D(point.s, point.c * rate), D(point.d, rate)});
    }
    const std::vector<D> tau =
        Lagrangian<D>(field, q).inverse_dynamics(constant(state.qd), constant(state.qdd), constant(state.sign_qd));
    for (int i = 0; i < mechanism.size(); ++i) result(i, k) = tau[static_cast<std::size_t>(i)].derivative;
  }
  return result;
}

// ∂τ/∂q̇: C q̇ is a quadratic form with the coefficients c_ijk = c_ikj, so its derivative is 2 C. `sign_qd`: by body's
// joint.
template <class F>
Matrix<F> torques_by_rate(Lagrangian<F>& lagrangian, const std::vector<F>& qd, const std::vector<F>& sign_qd) {
  Matrix<F> result = lagrangian.coriolis_matrix(qd);
  for (int i = 0; i < result.rows(); ++i) {
    for (int k = 0; k < result.cols(); ++k) result(i, k) += result(i, k);
  }
  const MechanismOver<F>& mechanism = lagrangian.mechanism();
  Matrix<F> friction(mechanism.body_count(), mechanism.body_count());
  const std::vector<F> rates = joint_values(mechanism, qd);
  for (int i = 0; i < mechanism.body_count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const FieldBody<F>& body = mechanism.bodies[k];
    friction(i, i) = body.viscous + dry_friction_slope(body, rates[k], sign_qd[k]);
  }
  friction = at_coordinates(mechanism, friction);
  for (int i = 0; i < result.rows(); ++i) {
    for (int k = 0; k < result.cols(); ++k) result(i, k) += friction(i, k);
  }
  return result;
}

// The part of ∂τ/∂ν by which the accelerations of Lagrange's coordinates depend on the velocities ν of a floating base
// and of spherical joints: B ∂(-Ȧ ν)/∂ν.
template <class F>
void add_drift_by_rate(const Mechanism& mechanism, const Matrix<F>& B, const std::vector<F>& velocity,
                       Matrix<F>& result) {
  for (int j = 0; j < B.cols(); ++j) {
    if (!mechanism.is_around_pose(j)) continue;
    std::vector<Dual<F>> rates(velocity.begin(), velocity.end());
    rates[static_cast<std::size_t>(j)].derivative = F(1);
    const std::vector<Dual<F>> drift = velocity_drift(mechanism, rates);
    for (int i = 0; i < B.rows(); ++i) {
      for (int k = 0; k < B.cols(); ++k) result(i, j) += B(i, k) * drift[static_cast<std::size_t>(k)].derivative;
    }
  }
}

}  // namespace flatdyn

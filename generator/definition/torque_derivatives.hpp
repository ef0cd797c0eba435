// SPDX-License-Identifier: GPL-2.0-or-later
// The derivatives of inverse and forward dynamics from the Lagrangian, over dual numbers of the field.
#pragma once

#include <string>
#include <vector>

#include "definition/lagrangian.hpp"
#include "model/floating_base.hpp"

namespace flatdyn {

// Arithmetic over dual numbers for the robot's own numbers, which are constant.
template <class Arithmetic>
struct ConstantArithmetic {
  using Scalar = Dual<typename Arithmetic::Scalar>;
  Arithmetic& field;

  Scalar constant(const Rational& value) const { return Scalar(field.constant(value)); }
  Scalar input(const Input& input) const { return Scalar(field.input(input)); }
  Scalar divide(const Scalar& a, const Scalar& b) const { return Scalar(field.divide(a.value, b.value)); }
  Scalar sin(const Graph& graph, NodeId angle, const Scalar& value) const {
    return Scalar(field.sin(graph, angle, value.value));
  }
  Scalar cos(const Graph& graph, NodeId angle, const Scalar& value) const {
    return Scalar(field.cos(graph, angle, value.value));
  }
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

// ∂τ/∂q, column by column: τ over dual numbers, with dc = -s dq, ds = c dq. A floating base's displacement changes
// nothing, and its turn changes gravity in its axes, while the components of velocities and accelerations are held.
template <class Arithmetic, class F = typename Arithmetic::Scalar>
Matrix<F> torques_by_position(const Mechanism& mechanism, Arithmetic& arithmetic, const FieldState<F>& state) {
  using D = Dual<F>;
  const auto constant = [](const std::vector<F>& values) { return std::vector<D>(values.begin(), values.end()); };
  ConstantArithmetic<Arithmetic> over_duals{arithmetic};
  MechanismOver<D> field = mechanism_over(mechanism, over_duals);
  const MechanismOver<F> constants = mechanism_over(mechanism, arithmetic);
  Matrix<F> result(mechanism.size(), mechanism.size());
  for (int k = 0; k < mechanism.size(); ++k) {
    std::vector<F> direction(static_cast<std::size_t>(mechanism.size()), F(0));
    if (!mechanism.is_of_base(k)) direction[static_cast<std::size_t>(k)] = F(1);
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

// ∂τ/∂q̇: C q̇ is a quadratic form with the coefficients c_ijk = c_ikj, so its derivative is 2 C.
template <class F>
Matrix<F> torques_by_rate(Lagrangian<F>& lagrangian, const std::vector<F>& qd) {
  Matrix<F> result = lagrangian.coriolis_matrix(qd);
  for (int i = 0; i < result.rows(); ++i) {
    for (int k = 0; k < result.cols(); ++k) result(i, k) += result(i, k);
  }
  const MechanismOver<F>& mechanism = lagrangian.mechanism();
  Matrix<F> friction(mechanism.body_count(), mechanism.body_count());
  for (int i = 0; i < mechanism.body_count(); ++i) {
    friction(i, i) = mechanism.bodies[static_cast<std::size_t>(i)].viscous;
  }
  friction = at_coordinates(mechanism, friction);
  for (int i = 0; i < result.rows(); ++i) {
    for (int k = 0; k < result.cols(); ++k) result(i, k) += friction(i, k);
  }
  return result;
}

// The part of ∂τ/∂ν by which the accelerations of Lagrange's coordinates depend on a floating base's velocity:
// B ∂(-Ȧ ν)/∂ν.
template <class F>
void add_drift_by_rate(const Matrix<F>& B, const std::vector<F>& velocity, Matrix<F>& result) {
  constexpr int kTwist = 6;
  for (int j = 0; j < kTwist; ++j) {
    std::vector<Dual<F>> twist(velocity.begin(), velocity.begin() + kTwist);
    twist[static_cast<std::size_t>(j)].derivative = F(1);
    const std::vector<Dual<F>> drift = base_drift(twist);
    for (int i = 0; i < B.rows(); ++i) {
      for (int k = 0; k < kTwist; ++k) result(i, j) += B(i, k) * drift[static_cast<std::size_t>(k)].derivative;
    }
  }
}

}  // namespace flatdyn

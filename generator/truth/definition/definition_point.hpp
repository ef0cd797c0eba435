// SPDX-License-Identifier: GPL-2.0-or-later
// One point of a field at which a function is compared with its definition: the Lagrangian there, the values drawn for
// the arguments, and the function's own values.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "graph/function.hpp"
#include "graph/function_name.hpp"
#include "robot/model/joint_points.hpp"
#include "robot/model/quasi_velocities.hpp"
#include "truth/definition/joint_signs.hpp"
#include "truth/definition/lagrangian.hpp"

namespace flatdyn {

template <class Arithmetic>
class DefinitionPoint {
 public:
  using F = typename Arithmetic::Scalar;
  using Values = std::vector<F>;

  // `own_values`: the values of the function's nodes, from evaluate() with the same arithmetic. All arguments must
  // outlive this object.
  DefinitionPoint(const Mechanism& mechanism_in, const Function& function_in, Arithmetic& arithmetic_in,
                  const Values& own_values)
      : mechanism(mechanism_in),
        function(function_in),
        arithmetic(arithmetic_in),
        q(joint_points(mechanism, arithmetic)),
        lagrangian(mechanism_with_gravity(), q),
        own_values_(own_values) {}

  // The function's own values of an output.
  Values own(const Output& output) const {
    Values result;
    for (const NodeId entry : output.entries) result.push_back(own_values_[static_cast<std::size_t>(entry)]);
    return result;
  }

  // The values drawn for an argument: for every coordinate, or for `count` entries.
  Values drawn(InputKind kind) const { return drawn(kind, mechanism.size()); }
  Values drawn(InputKind kind, int count) const {
    Values result;
    for (int i = 0; i < count; ++i) {
      result.push_back(arithmetic.input({with_base(kind, mechanism.has_quasi_velocities()), i}));
    }
    return result;
  }
  Values qd() const { return drawn(InputKind::qd); }
  Values qdd() const { return drawn(InputKind::qdd); }
  Values signs() const { return joint_signs(mechanism, arithmetic, InputKind::qd); }

  // The frame that the function is about: the tip's, or that of the link in its name.
  const FieldFrame<F>& frame() const {
    const std::optional<std::string> link = parts_of_name(function.name).link;
    if (!link) return lagrangian.mechanism().tip;
    for (std::size_t k = 0; k < mechanism.links.size(); ++k) {
      if (mechanism.links[k].link == *link) return lagrangian.mechanism().links[k];
    }
    throw Failure(FailureKind::bug, "no link named \"" + *link + "\"");
  }

  Values inverse_dynamics() { return torques_at(qdd()); }

  // The accelerations of the coordinates in which Lagrange's equations hold, from those of the function's: ẍ = ν̇ - Ȧ ν
  // with a floating base or spherical joints (robot/model/quasi_velocities.hpp).
  Values accelerations_of_coordinates(Values accelerations) const {
    if (!mechanism.has_quasi_velocities()) return accelerations;
    const Values drift = velocity_drift(mechanism, qd());
    for (std::size_t k = 0; k < drift.size(); ++k) accelerations[k] += drift[k];
    return accelerations;
  }

  // Those of the reference motion: ẍ_r = ν̇_r - Ȧ ν_r, so that B ẍ_r + C_x ν_r = B ν̇_r + C ν_r.
  Values reference_accelerations() const {
    Values result = drawn(InputKind::qdd_r);
    const Values rates = drawn(InputKind::qd_r);
    for (const RateBlock<F>& A : rate_blocks(mechanism, qd())) {
      for (std::size_t j = 0; j < A.entries.size(); ++j) {
        const auto first = static_cast<std::size_t>(A.first);
        for (std::size_t k = 0; k < A.entries.size(); ++k) result[first + j] += -(A.entries[j][k] * rates[first + k]);
      }
    }
    return result;
  }

  // The torques without acceleration.
  Values bias() {
    return mechanism.has_quasi_velocities() ? torques_at(Values(qd().size(), F(0))) : lagrangian.bias(qd(), signs());
  }

  // C with C q̇ the Coriolis and centrifugal torques: that of the Christoffel symbols, (7.44), for joints; for other
  // velocities it is transformed as said in robot/model/quasi_velocities.hpp.
  Matrix<F> coriolis_matrix() {
    Matrix<F> C = lagrangian.coriolis_matrix(qd());
    const Matrix<F>& B = lagrangian.inertia();
    for (const RateBlock<F>& A : rate_blocks(mechanism, qd())) {
      for (int i = 0; i < C.rows(); ++i) {
        for (std::size_t j = 0; j < A.entries.size(); ++j) {
          for (std::size_t k = 0; k < A.entries.size(); ++k) {
            C(i, A.first + static_cast<int>(j)) += -(B(i, A.first + static_cast<int>(k)) * A.entries[k][j]);
          }
        }
      }
    }
    return C;
  }

  // The acceleration of a frame while q̈ = 0: the linear part, then the angular one.
  Values jacobian_dot_qd(const FieldFrame<F>& of_frame) {
    Values result = lagrangian.jacobian_dot_qd(of_frame, qd());
    if (!mechanism.has_quasi_velocities()) return result;
    const Matrix<F> J = lagrangian.jacobian(of_frame);
    const Values drift = velocity_drift(mechanism, qd());
    for (int i = 0; i < J.rows(); ++i) {
      for (std::size_t k = 0; k < drift.size(); ++k) {
        result[static_cast<std::size_t>(i)] += J(i, static_cast<int>(k)) * drift[k];
      }
    }
    return result;
  }

  // τ - n, the value that B q̈ must have.
  Values net_torques() {
    Values result = drawn(InputKind::tau);
    const Values n = bias();
    for (std::size_t i = 0; i < n.size(); ++i) result[i] += -n[i];
    return result;
  }

  const Mechanism& mechanism;
  const Function& function;
  Arithmetic& arithmetic;
  const std::vector<JointPoint<F>> q;  // by body: the position of its joint
  Lagrangian<F> lagrangian;

 private:
  Values torques_at(const Values& accelerations) {
    return lagrangian.inverse_dynamics(qd(), accelerations_of_coordinates(accelerations), signs());
  }

  // The mechanism over the field; gravity is g_b if the base floats and there is any.
  MechanismOver<F> mechanism_with_gravity() const {
    MechanismOver<F> field = mechanism_over(mechanism, arithmetic);
    if (mechanism.has_base_gravity()) {
      for (int k = 0; k < 3; ++k) field.gravity[static_cast<std::size_t>(k)] = arithmetic.input({InputKind::g_b, k});
    }
    return field;
  }

  const Values& own_values_;
};

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The values of a Function's outputs by the Lagrangian, at one point of a field, by the function's name.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "definition/derivative_outputs.hpp"
#include "definition/joint_signs.hpp"
#include "definition/loop_outputs.hpp"
#include "definition/regressor_outputs.hpp"
#include "definition/task_definition.hpp"
#include "graph/function.hpp"
#include "model/joint_points.hpp"

namespace flatdyn {

template <class Arithmetic>
class LagrangianOutputs {
 public:
  using F = typename Arithmetic::Scalar;
  using Values = std::vector<F>;

  // `values`: the values of the function's nodes, from evaluate() with the same arithmetic.
  LagrangianOutputs(const Mechanism& mechanism, const Function& function, Arithmetic& arithmetic, const Values& values)
      : mechanism_(mechanism),
        arithmetic_(arithmetic),
        values_(values),
        stem_(function.name.substr(0, function.name.find(':'))),
        link_(function.name == stem_ ? "" : function.name.substr(stem_.size() + 1)),
        function_(function),
        q_(joint_points(mechanism, arithmetic)),
        lagrangian_(mechanism_over(mechanism, arithmetic), q_) {
    if (is_regressor(stem_)) regressor_.emplace(mechanism, lagrangian_.mechanism(), stem_, arithmetic, q_);
  }

  // The function's own values in the form in which they are compared. forward_dynamics (if no entry is left out) and
  // its derivatives are multiplied by B, so that they have no denominators; a base regressor is expanded to all columns
  // of Y.
  Values found(const Output& output) {
    const Values result = own(output);
    if (regressor_) return regressor_->found(result);
    if (stem_ == "forward_dynamics" && output.left_out.empty()) return times(lagrangian_.inertia(), result);
    if (stem_ == "forward_dynamics_derivatives") {
      return times(lagrangian_.inertia(), Matrix<F>(output.cols, result)).entries();
    }
    return result;
  }

  // The values by the definition, to which found() must be equal.
  Values entries(const Output& output) {
    if (regressor_) return regressor_->entries();
    if (stem_ == "inverse_dynamics") return inverse_dynamics();
    if (stem_ == "inverse_dynamics_tip_force") return added(inverse_dynamics(), lagrangian_.tip_torques(tip_force()));
    if (stem_ == "inertia_matrix") return lagrangian_.inertia().entries();
    if (stem_ == "christoffel") return christoffel();
    if (stem_ == "coriolis_matrix") return lagrangian_.coriolis_matrix(rates()).entries();
    if (stem_ == "gravity") return lagrangian_.gravity();
    if (stem_ == "bias") return lagrangian_.bias(rates(), signs());
    if (stem_ == "forward_dynamics" && output.left_out.empty()) return net_torques();
    if (stem_ == "forward_dynamics") return solution(lagrangian_.inertia(), net_torques());
    if (stem_ == "inverse_dynamics_derivatives") {
      return torque_derivatives(output.name == "dtau_dq", qdd());
    }
    if (stem_ == "forward_dynamics_derivatives") return acceleration_derivatives(output);
    if (!function_.task.empty()) return operational(output.name);
    if (stem_ == "kinetic_energy") return {lagrangian_.kinetic_energy(rates())};
    if (stem_ == "potential_energy") return {lagrangian_.potential_energy()};
    if (stem_ == "forward_kinematics") return pose(output.name);
    if (stem_ == "jacobian") return lagrangian_.jacobian(frame()).entries();
    if (stem_ == "jacobian_dot_qd") return lagrangian_.jacobian_dot_qd(frame(), rates());
    if (mechanism_.has_loops()) return LoopOutputs<F>(lagrangian_.mechanism(), q_).entries(output.name, rates(), qdd());
    throw Failure(ExitCode::bug, "no definition to compare function \"" + stem_ + "\" with");
  }

 private:
  Values own(const Output& output) const {
    Values result;
    for (const NodeId entry : output.entries) result.push_back(values_[static_cast<std::size_t>(entry)]);
    return result;
  }

  Values drawn(InputKind kind, int count) const {
    Values result;
    for (int i = 0; i < count; ++i) result.push_back(arithmetic_.input({kind, i}));
    return result;
  }

  Values rates() const { return drawn(InputKind::qd, mechanism_.size()); }
  Values qdd() const { return drawn(InputKind::qdd, mechanism_.size()); }
  Values tip_force() const { return drawn(InputKind::h_e, 6); }

  Values signs() const { return joint_signs(mechanism_, arithmetic_, InputKind::qd); }

  static Values added(Values a, const Values& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
    return a;
  }

  Values inverse_dynamics() { return lagrangian_.inverse_dynamics(rates(), qdd(), signs()); }

  // τ - n, the value that B q̈ must have.
  Values net_torques() {
    Values result = drawn(InputKind::tau, mechanism_.size());
    const Values bias = lagrangian_.bias(rates(), signs());
    for (std::size_t i = 0; i < bias.size(); ++i) result[i] += -bias[i];
    return result;
  }

  // The solution x of A x = b by elimination. B is singular at few points of a field; then the division throws.
  static Values solution(Matrix<F> A, Values b) {
    const int n = A.rows();
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    for (int k = 0; k < n; ++k) {
      const F reciprocal = F(1) / A(k, k);
      for (int i = 0; i < n; ++i) {
        if (i == k) continue;
        const F factor = A(i, k) * reciprocal;
        for (int j = k; j < n; ++j) A(i, j) += -(factor * A(k, j));
        b[at(i)] += -(factor * b[at(k)]);
      }
    }
    for (int k = 0; k < n; ++k) b[at(k)] = b[at(k)] * (F(1) / A(k, k));
    return b;
  }

  // The solution X of A X = B, column by column.
  static Matrix<F> solution(const Matrix<F>& A, const Matrix<F>& B) {
    Matrix<F> X(B.rows(), B.cols());
    for (int j = 0; j < B.cols(); ++j) {
      Values column;
      for (int i = 0; i < B.rows(); ++i) column.push_back(B(i, j));
      column = solution(A, column);
      for (int i = 0; i < B.rows(); ++i) X(i, j) = column[static_cast<std::size_t>(i)];
    }
    return X;
  }

  Values task_rows(const Values& all) const {
    Values rows;
    for (const int row : function_.task.rows) rows.push_back(all[static_cast<std::size_t>(row)]);
    return rows;
  }

  TaskDefinition<F> task_definition() {
    const auto root = [this](const F& x) { return arithmetic_.sqrt(x); };
    return {function_.task, lagrangian_, frame(), root};
  }

  // J B^-1 Jᵀ plus the task's damping.
  Matrix<F> mobility(const Matrix<F>& J, const Matrix<F>& X) const {
    Matrix<F> M = times(J, X);
    const F damping = arithmetic_.constant(function_.task.damping);
    for (int i = 0; i < M.rows(); ++i) M(i, i) += damping * damping;
    return M;
  }

  static F trace(const Matrix<F>& A) {
    F sum(0);
    for (int i = 0; i < A.rows(); ++i) sum += A(i, i);
    return sum;
  }

  // (7.130)–(7.141), computed as they are written.
  Values operational(const std::string& output) {
    const TaskDefinition<F> task = task_definition();
    const Matrix<F> all = task.jacobian();
    const int n = mechanism_.size(), r = static_cast<int>(function_.task.rows.size());
    Matrix<F> J(r, n), Jt(n, r), unit(r, r);
    for (int i = 0; i < r; ++i) {
      unit(i, i) = F(1);
      for (int k = 0; k < n; ++k) J(i, k) = Jt(k, i) = all(function_.task.rows[static_cast<std::size_t>(i)], k);
    }
    const Matrix<F> X = solution(lagrangian_.inertia(), Jt);
    const Matrix<F> M = mobility(J, X), B_A = solution(M, unit);
    if (output == "B_A") return B_A.entries();
    if (output == "condition") return {F(static_cast<std::uint64_t>(r * r)) / (trace(M) * trace(B_A))};
    if (output == "J_bar") return times(X, B_A).entries();
    const auto acceleration = [&](const Values& b) { return times(J, solution(lagrangian_.inertia(), b)); };
    if (output == "g_A") return times(B_A, acceleration(lagrangian_.gravity()));
    if (output == "c_A") {
      Values c = acceleration(times(lagrangian_.coriolis_matrix(rates()), rates()));
      const Values change = task_rows(task.drift(rates()));
      for (std::size_t i = 0; i < c.size(); ++i) c[i] += -change[i];
      return times(B_A, c);
    }
    const Values tau = drawn(InputKind::tau, n);
    Values rest = times(Jt, times(B_A, acceleration(tau)));
    for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = tau[k] + -rest[k];
    return rest;
  }

  Values torque_derivatives(bool by_position, const Values& qdd) {
    if (!by_position) return torques_by_rate(lagrangian_, rates()).entries();
    return torques_by_position(mechanism_, arithmetic_, {joint_points(mechanism_, arithmetic_), rates(), qdd, signs()})
        .entries();
  }

  // The values that B times the derivatives must have. Where q̈ is needed, it is B⁻¹ (τ - n) with the function's own
  // B⁻¹, which is compared, too.
  Values acceleration_derivatives(const Output& output) {
    const int n = mechanism_.size();
    if (output.name == "dqdd_dtau") {
      Matrix<F> unit(n, n);
      for (int i = 0; i < n; ++i) unit(i, i) = F(1);
      return unit.entries();
    }
    const Matrix<F> inverse(n, own(function_.outputs.back()));
    Values result = torque_derivatives(output.name == "dqdd_dq", times(inverse, net_torques()));
    for (F& entry : result) entry = -entry;
    return result;
  }

  // The Christoffel symbols in the order of Layout::christoffel.
  Values christoffel() {
    Values result;
    for (int i = 0; i < mechanism_.size(); ++i) {
      for (int k = 0; k < mechanism_.size(); ++k) {
        for (int j = 0; j <= k; ++j) result.push_back(lagrangian_.christoffel(i, j, k));
      }
    }
    return result;
  }

  const FieldFrame<F>& frame() const {
    if (link_.empty()) return lagrangian_.mechanism().tip;
    for (std::size_t k = 0; k < mechanism_.links.size(); ++k) {
      if (mechanism_.links[k].link == link_) return lagrangian_.mechanism().links[k];
    }
    throw Failure(ExitCode::bug, "no link named \"" + link_ + "\"");
  }

  Values pose(const std::string& output) const {
    const Pose3<F> pose = lagrangian_.pose(frame());
    if (output == "p") return Values(pose.p.begin(), pose.p.end());
    Values result;
    for (const Vector3<F>& row : pose.R) result.insert(result.end(), row.begin(), row.end());
    return result;
  }

  const Mechanism& mechanism_;
  Arithmetic& arithmetic_;
  const Values& values_;
  std::string stem_, link_;
  const Function& function_;
  std::vector<JointPoint<F>> q_;  // by body: the position of its joint
  Lagrangian<F> lagrangian_;
  std::optional<RegressorOutputs<Arithmetic>> regressor_;
};

}  // namespace flatdyn

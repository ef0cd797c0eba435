// SPDX-License-Identifier: GPL-2.0-or-later
// The dynamic model by its definition, without symbols: Lagrange's equations over any field. Joint i is given by a
// point of the unit circle (cos q_i, sin q_i), or by d_i. B is (7.32), body by body, from Jacobians in the base frame;
// derivatives come from dual numbers over the field, with dc = -s dq and ds = c dq. It shares nothing with the
// recursive derivation. With coupled joints, B is Aᵀ B A of the tree's B, and its derivatives are those along the
// coordinates; with closed loops, A G replaces A, see field_loops.hpp.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "robot/model/field_loops.hpp"
#include "truth/definition/dry_friction.hpp"

namespace flatdyn {

// A column of a geometric Jacobian: (7.18), (7.19).
template <class F>
struct Column {
  Vector3<F> linear, angular;
};

template <class F>
class Lagrangian {
 public:
  using D = Dual<F>;
  using Values = std::vector<F>;

  // `q`: the position of every body's joint.
  Lagrangian(MechanismOver<F> mechanism, std::vector<JointPoint<F>> q)
      : mechanism_(closed_at(std::move(mechanism), q)), q_(std::move(q)), poses_(body_poses(mechanism_, q_)) {}

  int size() const { return mechanism_.size(); }
  const MechanismOver<F>& mechanism() const { return mechanism_; }

  // The inertia matrix B, (7.32).
  const Matrix<F>& inertia() {
    if (!inertia_) {
      inertia_ = Matrix<F>(body_count(), body_count());
      for (int i = 0; i < body_count(); ++i) add_body(poses_, i, *inertia_);
      inertia_ = at_coordinates(mechanism_, *inertia_);
    }
    return *inertia_;
  }

  // ∂b_ij/∂q_k.
  const F& inertia_derivative(int i, int j, int k) {
    if (derivatives_.empty()) {
      for (int direction = 0; direction < size(); ++direction) derivatives_.push_back(differentiate(direction));
    }
    return derivatives_[static_cast<std::size_t>(k)](i, j);
  }

  // The Christoffel symbol c_ijk, (7.45).
  F christoffel(int i, int j, int k) {
    return half_ * (inertia_derivative(i, j, k) + inertia_derivative(i, k, j) - inertia_derivative(j, k, i));
  }

  // The matrix C with C qd the Coriolis and centrifugal torques, (7.44).
  Matrix<F> coriolis_matrix(const Values& qd) {
    Matrix<F> C(size(), size());
    for (int i = 0; i < size(); ++i) {
      for (int j = 0; j < size(); ++j) {
        for (int k = 0; k < size(); ++k) C(i, j) += christoffel(i, j, k) * qd[static_cast<std::size_t>(k)];
      }
    }
    return C;
  }

  // The gravity torques g, (7.39): joint j moves all of its descendants against gravity.
  Values gravity() const {
    Values g(static_cast<std::size_t>(body_count()), F(0));
    for (int i = 0; i < body_count(); ++i) {
      const FieldInertia<F>& body = mechanism_.bodies[static_cast<std::size_t>(i)].inertia;
      const Pose3<F>& pose = poses_[static_cast<std::size_t>(i)];
      const Vector3<F> h = times(pose.R, body.first_moment);
      for (int j = i; j >= 0; j = parent(j)) {
        const Column<F> column = joint_column(poses_, j, pose.p);
        const Vector3<F> moved = plus(scaled(body.mass, column.linear), cross(column.angular, h));
        g[static_cast<std::size_t>(j)] += -dot(mechanism_.gravity, moved);
      }
    }
    return at_coordinates(mechanism_, g);
  }

  // The friction torques F_v qd + F_s sgn(qd), and what else friction has. The caller gives the signs of all joints'
  // rates, smooth ones where friction is smooth.
  Values friction(const Values& qd, const Values& sign_qd) const {
    Values result;
    for (const F& rate : joint_values(mechanism_, qd)) {
      const FieldBody<F>& body = mechanism_.bodies[result.size()];
      result.push_back(body.viscous * rate + dry_friction(body, rate, sign_qd[result.size()]));
    }
    return at_coordinates(mechanism_, result);
  }

  // The torques k (q - q_0) against the joints' springs.
  Values springs() const {
    Values result;
    for (const FieldBody<F>& body : mechanism_.bodies) result.push_back(body.stiffness * stretch(result.size()));
    return at_coordinates(mechanism_, result);
  }

  // The torques without acceleration: C qd + g + friction + springs.
  Values bias(const Values& qd, const Values& sign_qd) {
    return sum(times(coriolis_matrix(qd), qd), sum(sum(gravity(), springs()), friction(qd, sign_qd)));
  }

  // The torques (7.42) without tip force.
  Values inverse_dynamics(const Values& qd, const Values& qdd, const Values& sign_qd) {
    return sum(times(inertia(), qdd), bias(qd, sign_qd));
  }

  // Jᵀ h_e, where h_e is the force, then the moment about the tip, in the base frame, exerted on the environment.
  Values tip_torques(const Values& h_e) const { return torques_at(mechanism_.tip, h_e); }

  // The same for another frame.
  Values torques_at(const FieldFrame<F>& frame, const Values& h_e) const {
    const Matrix<F> J = jacobian(frame);
    Values result(static_cast<std::size_t>(size()), F(0));
    for (int j = 0; j < size(); ++j) {
      for (int row = 0; row < 6; ++row) {
        result[static_cast<std::size_t>(j)] += J(row, j) * h_e[static_cast<std::size_t>(row)];
      }
    }
    return result;
  }

  // The kinetic energy, (7.31).
  F kinetic_energy(const Values& qd) {
    const Values momentum = times(inertia(), qd);
    F twice = F(0);
    for (std::size_t i = 0; i < qd.size(); ++i) twice += qd[i] * momentum[i];
    return half_ * twice;
  }

  // The potential energy, (7.36), zero at the origin of the base frame, with ½ k (q - q_0)² of every spring.
  F potential_energy() const {
    F energy = -dot(mechanism_.gravity, mechanism_.base.first_moment);
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      const FieldInertia<F>& body = mechanism_.bodies[i].inertia;
      const Vector3<F> moment = plus(scaled(body.mass, poses_[i].p), times(poses_[i].R, body.first_moment));
      energy += -dot(mechanism_.gravity, moment);
      energy += half_ * mechanism_.bodies[i].stiffness * stretch(i) * stretch(i);
    }
    return energy;
  }

  Pose3<F> pose(const FieldFrame<F>& frame) const { return pose_of(poses_, frame); }

  // The geometric Jacobian of a frame, 6 x n: linear rows, then angular, in the base frame.
  Matrix<F> jacobian(const FieldFrame<F>& frame) const {
    Matrix<F> J(6, body_count());
    const Vector3<F> p = pose(frame).p;
    for (int j = frame.body; j >= 0; j = parent(j)) {
      const Column<F> column = joint_column(poses_, j, p);
      for (int row = 0; row < 3; ++row) {
        J(row, j) = column.linear[static_cast<std::size_t>(row)];
        J(row + 3, j) = column.angular[static_cast<std::size_t>(row)];
      }
    }
    return columns_at_coordinates(mechanism_, J);
  }

  // (dJ/dt) qd: the derivative of J along qd, times qd.
  Values jacobian_dot_qd(const FieldFrame<F>& frame, const Values& qd) const {
    const Values rates = joint_values(mechanism_, qd), drift = joint_drift(mechanism_, q_, rates, qd);
    const std::vector<Pose3<D>> poses = body_poses(mechanism_, moving(q_, rates));
    const Vector3<D> p = pose_of(poses, frame).p;
    Values result(6, F(0));
    for (int j = frame.body; j >= 0; j = parent(j)) {
      const Column<D> column = joint_column(poses, j, p);
      for (std::size_t row = 0; row < 3; ++row) {
        const auto k = static_cast<std::size_t>(j);
        result[row] += column.linear[row].derivative * rates[k] + column.linear[row].value * drift[k];
        result[row + 3] += column.angular[row].derivative * rates[k] + column.angular[row].value * drift[k];
      }
    }
    return result;
  }

 private:
  static Values sum(Values a, const Values& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
    return a;
  }

  // q - q_0 of body i's joint.
  F stretch(std::size_t i) const { return q_[i].d + -mechanism_.bodies[i].spring_reference; }

  int body_count() const { return mechanism_.body_count(); }
  int parent(int i) const { return mechanism_.bodies[static_cast<std::size_t>(i)].parent; }

  // Whether joint k moves body i.
  bool moves(int k, int i) const {
    while (i > k) i = parent(i);
    return i == k;
  }

  template <class S>
  static Pose3<S> pose_of(const std::vector<Pose3<S>>& poses, const FieldFrame<F>& frame) {
    if (frame.body < 0) {
      const auto lifted = [](const Vector3<F>& v) { return Vector3<S>{S(v[0]), S(v[1]), S(v[2])}; };
      return {{lifted(frame.R[0]), lifted(frame.R[1]), lifted(frame.R[2])}, lifted(frame.p)};
    }
    const Pose3<S>& body = poses[static_cast<std::size_t>(frame.body)];
    return {times(body.R, frame.R), plus(body.p, times(body.R, frame.p))};
  }

  // Joint j's column of the Jacobian of a point at p, (7.18), (7.19).
  template <class S>
  Column<S> joint_column(const std::vector<Pose3<S>>& poses, int j, const Vector3<S>& p) const {
    const Pose3<S>& pose = poses[static_cast<std::size_t>(j)];
    const Vector3<S> z = {pose.R[0][2], pose.R[1][2], pose.R[2][2]};
    const S zero = S(F(0));
    if (mechanism_.bodies[static_cast<std::size_t>(j)].prismatic) return {z, {zero, zero, zero}};
    return {cross(z, minus(p, pose.p)), z};
  }

  // Adds body i's contribution to (7.32), about the origin of its frame: h = m r_C, Î about that origin, in base axes.
  template <class S>
  void add_body(const std::vector<Pose3<S>>& poses, int i, Matrix<S>& B) const {
    const FieldBody<F>& body = mechanism_.bodies[static_cast<std::size_t>(i)];
    const Pose3<S>& pose = poses[static_cast<std::size_t>(i)];
    const Vector3<S> h = times(pose.R, body.inertia.first_moment);
    Matrix3<S> I = times(times(pose.R, body.inertia.inertia), transposed(pose.R));
    if (i + 1 == mechanism_.base_bodies) add_armature_of_turns(I);
    std::vector<std::pair<int, Column<S>>> columns;
    for (int j = i; j >= 0; j = parent(j)) columns.emplace_back(j, joint_column(poses, j, pose.p));
    for (const auto& [j, column] : columns) {
      const Vector3<S> linear = plus(scaled(body.inertia.mass, column.linear), cross(column.angular, h));
      const Vector3<S> angular = plus(times(I, column.angular), cross(h, column.linear));
      for (const auto& [k, other] : columns) {
        if (k > j) continue;
        const S b = dot(other.linear, linear) + dot(other.angular, angular);
        B(j, k) += b;
        if (k != j) B(k, j) += b;
      }
    }
    add_rotor(poses, i, B);
  }

  // A floating base's armature about its axes is that of ω, whose components are no rates of coordinates: its energy is
  // half of it times ω·ω.
  template <class S>
  void add_armature_of_turns(Matrix3<S>& I) const {
    const F& armature = mechanism_.bodies[static_cast<std::size_t>(mechanism_.base_bodies - 1)].armature;
    for (std::size_t k = 0; k < 3; ++k) I[k][k] += S(armature);
  }
  bool turns_base(int i) const { return i < mechanism_.base_bodies && i >= mechanism_.base_bodies / 2; }

  // Adds the contribution of joint i's spinning rotor, (7.29), (7.64), beyond the augmented link.
  template <class S>
  void add_rotor(const std::vector<Pose3<S>>& poses, int i, Matrix<S>& B) const {
    const FieldBody<F>& body = mechanism_.bodies[static_cast<std::size_t>(i)];
    if (!turns_base(i)) B(i, i) += S(body.armature);
    if (!body.rotor) return;
    const FieldRotor<F>& rotor = *body.rotor;
    const F spin = rotor.gear_ratio * rotor.inertia;
    B(i, i) += S(rotor.gear_ratio * spin);
    if (rotor.carrier < 0) return;
    const Pose3<S>& carrier = poses[static_cast<std::size_t>(rotor.carrier)];
    const Vector3<S> z_m = times(carrier.R, rotor.axis);
    for (int j = rotor.carrier; j >= 0; j = parent(j)) {
      const S b = spin * dot(z_m, joint_column(poses, j, carrier.p).angular);
      B(i, j) += b;
      B(j, i) += b;
    }
  }

  // The rate of body i's joint per rate of coordinate k.
  F rate(int i, int k) const {
    if (!mechanism_.is_coupled()) return i == k ? F(1) : F(0);
    return mechanism_.coupling[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  }

  // ∂B/∂q_k. If joints are not coupled, only bodies that joint k moves contribute.
  Matrix<F> differentiate(int k) const {
    Values rates;
    for (int i = 0; i < body_count(); ++i) rates.push_back(rate(i, k));
    const std::vector<JointPoint<D>> q = moving(q_, rates);
    const std::vector<Pose3<D>> poses = body_poses(mechanism_, q);
    Matrix<D> B(body_count(), body_count());
    for (int i = 0; i < body_count(); ++i) {
      if (mechanism_.is_coupled() || moves(k, i)) add_body(poses, i, B);
    }
    if (mechanism_.has_loops()) return derivative_of(between(closed_coupling(mechanism_, q), B));
    return at_coordinates(mechanism_, derivative_of(B));
  }

  static Matrix<F> derivative_of(const Matrix<D>& B) {
    Matrix<F> result(B.rows(), B.cols());
    for (int i = 0; i < B.rows(); ++i) {
      for (int j = 0; j < B.cols(); ++j) result(i, j) = B(i, j).derivative;
    }
    return result;
  }

  // Aᵀ B A.
  static Matrix<D> between(const std::vector<std::vector<D>>& rows, const Matrix<D>& B) {
    const int bodies = static_cast<int>(rows.size()), n = static_cast<int>(rows.front().size());
    Matrix<D> A(bodies, n), A_transposed(n, bodies);
    for (int i = 0; i < bodies; ++i) {
      for (int k = 0; k < n; ++k) {
        A(i, k) = A_transposed(k, i) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
      }
    }
    return times(A_transposed, times(B, A));
  }

  MechanismOver<F> mechanism_;
  std::vector<JointPoint<F>> q_;
  std::vector<Pose3<F>> poses_;
  F half_ = F(1) / (F(1) + F(1));
  std::optional<Matrix<F>> inertia_;
  std::vector<Matrix<F>> derivatives_;
};

}  // namespace flatdyn

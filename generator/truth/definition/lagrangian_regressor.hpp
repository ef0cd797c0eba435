// SPDX-License-Identifier: GPL-2.0-or-later
// The regressor by its definition (7.79), over any field: y_ij = d/dt ∂β_Tj/∂q̇_i - ∂β_Tj/∂q_i + ∂β_Uj/∂q_i, with β_Tj
// and β_Uj the energies of unit parameters of body j. Derivatives come from dual numbers; nothing is shared with the
// recursive derivation.
#pragma once

#include <utility>
#include <vector>

#include "truth/definition/lagrangian.hpp"

namespace flatdyn {

template <class F>
class LagrangianRegressor {
 public:
  using D = Dual<F>;
  using Values = std::vector<F>;
  static constexpr int kPerJoint = 13;  // the order of (7.77), then F_v and F_s
  static constexpr int kRotor = 10, kViscous = 11, kCoulomb = 12;

  // `q`: the position of every body's joint.
  LagrangianRegressor(const MechanismOver<F>& mechanism, std::vector<JointPoint<F>> q)
      : mechanism_(closed_at(mechanism, q)), q_(std::move(q)) {}

  int size() const { return mechanism_.size(); }

  // Y(q, q̇, q̈), n x 13 for every body. `sign`: the signs of the joints' rates, for friction.
  Matrix<F> regressor(const Values& qd, const Values& qdd, const Values& sign) const {
    const Values rates = joint_values(mechanism_, qd);
    Matrix<F> Y = without_friction(rates, accelerations(rates, qd, qdd), true);
    add_friction(rates, less_at_rest(sign), Y);
    return rows_at_coordinates(mechanism_, Y);
  }

  // The regressor of B q̈_r + C(q, q̇) q̇_r + g + F_v q̇_r + F_s sgn(q̇_r). C(q, a) b is the symmetric bilinear form
  // whose square is C(q, a) a, because c_ijk = c_ikj: ½ (C(q, a + b)(a + b) - C(q, a) a - C(q, b) b).
  Matrix<F> adaptive(const Values& qd, const Values& qd_r, const Values& qdd_r, const Values& sign_r) const {
    const Values rates = joint_values(mechanism_, qd), rates_r = joint_values(mechanism_, qd_r);
    const Values zero(rates.size(), F(0));
    Values both = rates;
    for (std::size_t i = 0; i < both.size(); ++i) both[i] += rates_r[i];
    Matrix<F> Y = without_friction(zero, accelerations(rates, qd_r, qdd_r), true);
    const Matrix<F> sum = without_friction(both, zero, false), first = without_friction(rates, zero, false),
                    second = without_friction(rates_r, zero, false);
    const F half = F(1) / (F(1) + F(1));
    for (int i = 0; i < Y.rows(); ++i) {
      for (int k = 0; k < Y.cols(); ++k) Y(i, k) += half * (sum(i, k) + -first(i, k) + -second(i, k));
    }
    add_friction(rates_r, less_at_rest(sign_r), Y);
    return rows_at_coordinates(mechanism_, Y);
  }

  // Y_s of the torques k q - k q_0 of springs, n x 2 for every body: the derivatives by q of ½ k q² - k q_0 q.
  Matrix<F> springs() const {
    Matrix<F> Y(body_count(), 2 * body_count());
    for (int i = 0; i < body_count(); ++i) {
      Y(i, 2 * i) = q_[static_cast<std::size_t>(i)].d;
      Y(i, 2 * i + 1) = -F(1);
    }
    return rows_at_coordinates(mechanism_, Y);
  }

 private:
  template <class S>
  struct Motion {
    std::vector<Pose3<S>> poses;
    std::vector<S> qd;
  };
  // Columns of the body's velocity, in its own axes, for unit motions of the joints, by joint.
  template <class S>
  using Columns = std::vector<std::pair<int, Column<S>>>;

  // The accelerations of the joints; with closed loops, a part of them comes from q̇.
  Values accelerations(const Values& joint_rates, const Values& qd, const Values& qdd) const {
    Values result = joint_values(mechanism_, qdd);
    const Values drift = joint_drift(mechanism_, q_, joint_rates, qd);
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += drift[i];
    return result;
  }

  // The motion at q and q̇ with its derivatives along (dq, dqd).
  Motion<D> motion(const Values& qd, const Values& dq, const Values& dqd) const {
    Motion<D> result;
    for (std::size_t i = 0; i < qd.size(); ++i) result.qd.emplace_back(qd[i], dqd[i]);
    result.poses = body_poses(mechanism_, moving(q_, dq));
    return result;
  }

  int body_count() const { return mechanism_.body_count(); }
  int parent(int i) const { return mechanism_.bodies[static_cast<std::size_t>(i)].parent; }

  Columns<D> columns(const Motion<D>& motion, int body) const {
    Columns<D> result;
    const Pose3<D>& here = motion.poses[static_cast<std::size_t>(body)];
    const Matrix3<D> axes = transposed(here.R);
    for (int k = body; k >= 0; k = parent(k)) {
      const Pose3<D>& pose = motion.poses[static_cast<std::size_t>(k)];
      const Vector3<D> z = {pose.R[0][2], pose.R[1][2], pose.R[2][2]};
      const D zero = D(F(0));
      const bool prismatic = mechanism_.bodies[static_cast<std::size_t>(k)].prismatic;
      const Vector3<D> linear = prismatic ? z : cross(z, minus(here.p, pose.p));
      const Vector3<D> angular = prismatic ? Vector3<D>{zero, zero, zero} : z;
      result.emplace_back(k, Column<D>{times(axes, linear), times(axes, angular)});
    }
    return result;
  }

  static Column<D> total(const Columns<D>& columns, const std::vector<D>& qd) {
    const D zero = D(F(0));
    Column<D> sum{{zero, zero, zero}, {zero, zero, zero}};
    for (const auto& [k, column] : columns) {
      const D& rate = qd[static_cast<std::size_t>(k)];
      sum.linear = plus(sum.linear, scaled(rate, column.linear));
      sum.angular = plus(sum.angular, scaled(rate, column.angular));
    }
    return sum;
  }

  // The symmetric bilinear form whose value for (a, a) is twice the kinetic energies of unit parameters, (7.70).
  static std::vector<D> kinetic(const Column<D>& a, const Column<D>& b) {
    const Vector3<D>&u = a.angular, &w = b.angular;
    const Vector3<D> h = plus(cross(a.linear, w), cross(b.linear, u));
    return {dot(a.linear, b.linear),
            h[0],
            h[1],
            h[2],
            u[0] * w[0],
            u[0] * w[1] + u[1] * w[0],
            u[0] * w[2] + u[2] * w[0],
            u[1] * w[1],
            u[1] * w[2] + u[2] * w[1],
            u[2] * w[2]};
  }

  // The potential energies of a unit mass and of unit first moments, (7.75).
  std::vector<D> potential(const Pose3<D>& pose) const {
    const Vector3<F>& g = mechanism_.gravity;
    const Vector3<D> h = times(transposed(pose.R), Vector3<D>{D(g[0]), D(g[1]), D(g[2])});
    return {-dot(pose.p, g), -h[0], -h[1], -h[2]};
  }

  Matrix<F> without_friction(const Values& qd, const Values& qdd, bool gravity) const {
    Matrix<F> Y(body_count(), kPerJoint * body_count());
    add_momentum_rates(motion(qd, qd, qdd), Y);
    const Values zero(qd.size(), F(0));
    for (int i = 0; i < body_count(); ++i) {
      Values direction = zero;
      direction[static_cast<std::size_t>(i)] = F(1);
      add_energy_derivatives(motion(qd, direction, zero), i, gravity, Y);
    }
    return Y;
  }

  // Adds d/dt ∂β_T/∂q̇_i.
  void add_momentum_rates(const Motion<D>& motion, Matrix<F>& Y) const {
    for (int j = 0; j < body_count(); ++j) {
      const Columns<D> own = columns(motion, j);
      const Column<D> velocity = total(own, motion.qd);
      for (const auto& [i, column] : own) {
        const std::vector<D> momentum = kinetic(column, velocity);
        for (int k = 0; k < kRotor; ++k) Y(i, kPerJoint * j + k) += momentum[static_cast<std::size_t>(k)].derivative;
      }
      add_rotor_momentum(motion, j, Y);
    }
  }

  // Adds the last two terms of (7.70) for I_m = 1: ½ k_r² q̇² + k_r q̇ z_m·ω; an armature has k_r = 1 and no second
  // term.
  void add_rotor_momentum(const Motion<D>& motion, int j, Matrix<F>& Y) const {
    const auto& rotor = mechanism_.bodies[static_cast<std::size_t>(j)].rotor;
    const F ratio = rotor ? rotor->gear_ratio : F(1);
    const D rate = motion.qd[static_cast<std::size_t>(j)];
    const int place = kPerJoint * j + kRotor;
    Y(j, place) += (rate * (ratio * ratio)).derivative;
    if (!rotor || rotor->carrier < 0) return;
    for (const auto& [i, column] : columns(motion, rotor->carrier)) {
      const D along = dot(column.angular, rotor->axis) * ratio;
      Y(i, place) += (along * rate).derivative;
      Y(j, place) += (along * motion.qd[static_cast<std::size_t>(i)]).derivative;
    }
  }

  bool moves(int i, int j) const {
    while (j > i) j = parent(j);
    return i == j;
  }

  // Adds -∂β_T/∂q_i + ∂β_U/∂q_i.
  void add_energy_derivatives(const Motion<D>& motion, int i, bool gravity, Matrix<F>& Y) const {
    const F half = F(1) / (F(1) + F(1));
    for (int j = i; j < body_count(); ++j) {
      add_rotor_derivative(motion, i, j, Y);
      if (!moves(i, j)) continue;
      const Column<D> velocity = total(columns(motion, j), motion.qd);
      const std::vector<D> twice = kinetic(velocity, velocity);
      for (int k = 0; k < kRotor; ++k) {
        Y(i, kPerJoint * j + k) += -(half * twice[static_cast<std::size_t>(k)].derivative);
      }
      if (!gravity) continue;
      const std::vector<D> U = potential(motion.poses[static_cast<std::size_t>(j)]);
      for (int k = 0; k < 4; ++k) Y(i, kPerJoint * j + k) += U[static_cast<std::size_t>(k)].derivative;
    }
  }

  void add_rotor_derivative(const Motion<D>& motion, int i, int j, Matrix<F>& Y) const {
    const auto& rotor = mechanism_.bodies[static_cast<std::size_t>(j)].rotor;
    if (!rotor || rotor->carrier < 0 || !moves(i, rotor->carrier)) return;
    const Column<D> velocity = total(columns(motion, rotor->carrier), motion.qd);
    const D energy = dot(velocity.angular, rotor->axis) * rotor->gear_ratio * motion.qd[static_cast<std::size_t>(j)];
    Y(i, kPerJoint * j + kRotor) += -energy.derivative;
  }

  // s - s_0, for friction that is F_s times it.
  Values less_at_rest(Values sign) const {
    for (std::size_t i = 0; i < sign.size(); ++i) sign[i] += -mechanism_.bodies[i].dry.at_rest;
    return sign;
  }

  static void add_friction(const Values& rate, const Values& sign, Matrix<F>& Y) {
    for (int i = 0; i < static_cast<int>(rate.size()); ++i) {
      Y(i, kPerJoint * i + kViscous) += rate[static_cast<std::size_t>(i)];
      Y(i, kPerJoint * i + kCoulomb) += sign[static_cast<std::size_t>(i)];
    }
  }

  MechanismOver<F> mechanism_;
  std::vector<JointPoint<F>> q_;
};

}  // namespace flatdyn

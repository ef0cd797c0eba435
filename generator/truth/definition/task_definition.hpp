// SPDX-License-Identifier: GPL-2.0-or-later
// The velocity of a task by its definition, at one point of a field: rows of the tip's geometric Jacobian, with the
// last three converted to rates of Euler angles if the task has some, φ̇ = T^-1 ω, (3.64).
#pragma once

#include <functional>
#include <vector>

#include "graph/task.hpp"
#include "truth/definition/lagrangian.hpp"

namespace flatdyn {

template <class F>
class TaskDefinition {
 public:
  using Values = std::vector<F>;

  // `root`: a function that returns the root of a square of the field.
  TaskDefinition(const Task& task, const Lagrangian<F>& lagrangian, const FieldFrame<F>& tip,
                 const std::function<F(const F&)>& root)
      : lagrangian_(lagrangian), tip_(tip), has_angles_(task.rates_are_of_angles()) {
    if (!has_angles_) return;
    const Matrix3<F> R = transposed(lagrangian.pose(tip).R);
    last_ = R[task.orientation == Orientation::zyz ? 2 : 0];
    const F reciprocal = F(1) / root(last_[0] * last_[0] + last_[1] * last_[1]);
    nodes_ = {-(last_[1] * reciprocal), last_[0] * reciprocal, F(0)};
  }

  // The task's Jacobian, all six rows.
  Matrix<F> jacobian() const {
    Matrix<F> J = lagrangian_.jacobian(tip_);
    for (int k = 0; k < J.cols() && has_angles_; ++k) {
      const Vector3<F> rates = angle_rates({J(3, k), J(4, k), J(5, k)});
      for (int i = 0; i < 3; ++i) J(i + 3, k) = rates[static_cast<std::size_t>(i)];
    }
    return J;
  }

  // J̇ q̇, all six rows, from the tip's acceleration while q̈ = 0. For angles it is T^-1 (ω̇ - Ṫ φ̇), where z is constant,
  // the line of nodes turns about z, and the last axis turns with the tip.
  Values drift(Values drift, const Values& qd) const {
    if (!has_angles_) return drift;
    const Values velocity = times(lagrangian_.jacobian(tip_), qd);
    const Vector3<F> omega = angular(velocity), rates = angle_rates(omega);
    const Vector3<F> turning =
        plus(scaled(rates[1], cross(scaled(rates[0], z_), nodes_)), scaled(rates[2], cross(omega, last_)));
    const Vector3<F> changes = angle_rates(minus(angular(drift), turning));
    for (std::size_t i = 0; i < 3; ++i) drift[i + 3] = changes[i];
    return drift;
  }

 private:
  static Vector3<F> angular(const Values& six) { return {six[3], six[4], six[5]}; }

  // φ̇ = T^-1 ω by Cramer's rule, with T = [z, line of nodes, last axis].
  Vector3<F> angle_rates(const Vector3<F>& omega) const {
    const Vector3<F> across = cross(nodes_, last_);
    const F reciprocal = F(1) / dot(z_, across);
    return scaled(reciprocal,
                  Vector3<F>{dot(across, omega), dot(cross(last_, z_), omega), dot(cross(z_, nodes_), omega)});
  }

  const Lagrangian<F>& lagrangian_;
  const FieldFrame<F>& tip_;
  bool has_angles_;
  Vector3<F> z_{F(0), F(0), F(1)}, nodes_{}, last_{};
};

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The operational-space functions: their values by the reference, and the magnitude of their rounding errors.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "flatdyn/reference/operational.hpp"
#include "graph/arithmetic.hpp"
#include "graph/function.hpp"
#include "graph/task.hpp"
#include "truth/reference/magnitude.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {

// The task in the reference's types.
template <class S>
reference::Task<S> reference_task(const Task& task) {
  using reference::Angles;
  const Angles angles = task.orientation == Orientation::zyz   ? Angles::zyz
                        : task.orientation == Orientation::rpy ? Angles::rpy
                                                               : Angles::none;
  return {task.rows, angles, to_real<S>(task.damping)};
}

// The entries, in the order of the function's outputs.
template <class S>
std::vector<S> operational_inertia_entries(const reference::Robot<S>& robot, const reference::VectorX<S>& q,
                                           const Task& of) {
  const reference::Task<S> task = reference_task<S>(of);
  const auto space = reference::operational_space(robot, q, task);
  std::vector<S> entries = row_by_row(space.B_A);
  const std::vector<S> more = row_by_row(reference::consistent_inverse(space));
  entries.insert(entries.end(), more.begin(), more.end());
  entries.push_back(reference::condition(space));
  return entries;
}

template <class S>
std::vector<S> operational_bias_entries(const reference::Robot<S>& robot, const reference::VectorX<S>& q,
                                        const reference::VectorX<S>& qd, const Task& of) {
  const reference::Task<S> task = reference_task<S>(of);
  std::vector<S> entries = row_by_row(reference::operational_coriolis(robot, q, qd, task));
  const std::vector<S> more = row_by_row(reference::operational_gravity(robot, q, task));
  entries.insert(entries.end(), more.begin(), more.end());
  return entries;
}

// J B^-1 Jᵀ, damped if the task is.
template <class S>
reference::MatrixX<S> mobility_of(const reference::OperationalSpace<S>& space, const reference::Task<S>& task) {
  reference::MatrixX<S> mobility = space.J * space.B_inverse * space.J.transpose();
  mobility.diagonal().array() += task.damping * task.damping;
  return mobility;
}

// Whether the inverse of J B^-1 Jᵀ means something in the scalar's arithmetic. With M_kk (M^-1)_kk, which has no unit
// and is 1 or more, an error in the last place of a diagonal entry grows.
template <class S>
bool has_inverse(const reference::Robot<S>& robot, const reference::VectorX<S>& q, const Task& of) {
  const reference::Task<S> task = reference_task<S>(of);
  const S lost = to_real<S>(kPivotSignificance) / std::numeric_limits<S>::epsilon();
  if (of.rates_are_of_angles()) {
    using std::abs;
    const reference::Vector3<S> angles = reference::euler_angles(reference::tip_pose(robot, q).R, task.angles);
    const S divisor = reference::rates_to_velocity(angles, task.angles).determinant();
    if (!(abs(divisor) * lost > 1)) return false;
  }
  const auto space = reference::operational_space(robot, q, task);
  const reference::VectorX<S> growth = mobility_of(space, task).diagonal().cwiseProduct(space.B_A.diagonal());
  return std::all_of(growth.begin(), growth.end(), [&lost](const S& x) { return x > 0 && x < lost; });
}

// Whether J B^-1 Jᵀ, damped if the task is, can be inverted in doubles with some digits left.
bool is_regular(const reference::Robot<double>& robot, const reference::VectorX<double>& q, const Task& task);

// The effect of an error in the last place of each term of B, J and the torques; inverses propagate it.
class OperationalMagnitude {
 public:
  OperationalMagnitude(const reference::Robot<double>& robot, const reference::VectorX<double>& q, const Task& task);

  std::vector<double> inertia() const;
  std::vector<double> bias(const reference::VectorX<double>& qd) const;
  std::vector<double> null_space(const reference::VectorX<double>& tau) const;

 private:
  using Vector = reference::VectorX<double>;
  using Matrix = reference::MatrixX<double>;

  // The sums of the absolute terms of the rows of J, and of J̇ q̇.
  Matrix jacobian_terms() const;
  Vector drift_terms(const Vector& qd) const;
  // 1 / s², where s is the sine or cosine in T's determinant: the factor by which errors of R grow.
  double growth() const;

  // The magnitude of B_A J B^-1 b. `terms`: the error of `b`.
  Vector force(const Vector& b, const Vector& terms) const;

  const reference::Robot<double>& robot_;
  const Vector& q_;
  reference::Task<double> task_;
  reference::OperationalSpace<double> space_;
  Matrix J_terms_, inverse_, inverse_terms_, B_A_, B_A_terms_;
};

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The operational space's functions: what the reference says they are, and how large rounding errors may be.
#pragma once

#include <vector>

#include "flatdyn/reference/magnitude.hpp"
#include "flatdyn/reference/operational.hpp"
#include "graph/arithmetic.hpp"
#include "graph/task.hpp"
#include "reference/reference_model.hpp"

namespace flatdyn {

template <class S>
reference::Task<S> reference_task(const Task& task) {
  using reference::Angles;
  const Angles angles = task.orientation == Orientation::zyz   ? Angles::zyz
                        : task.orientation == Orientation::rpy ? Angles::rpy
                                                               : Angles::none;
  return {task.rows, angles, to_real<S>(task.damping)};
}

// The entries in the order of the function's outputs.
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

// Whether J B^-1 Jᵀ, damped if the task is, can be inverted in doubles, with some digits left.
bool is_regular(const reference::Robot<double>& robot, const reference::VectorX<double>& q, const Task& task);

// What an error of the last place in each of the terms of B, J and the torques becomes: inverses pass it on.
class OperationalMagnitude {
 public:
  OperationalMagnitude(const reference::Robot<double>& robot, const reference::VectorX<double>& q, const Task& task);

  std::vector<double> inertia() const;
  std::vector<double> bias(const reference::VectorX<double>& qd) const;
  std::vector<double> null_space(const reference::VectorX<double>& tau) const;

 private:
  using Vector = reference::VectorX<double>;
  using Matrix = reference::MatrixX<double>;

  // Of the rows of J, and of J̇ q̇.
  Matrix jacobian_terms() const;
  Vector drift_terms(const Vector& qd) const;
  // 1 / s², s the sine or cosine that T has in its determinant: what it makes of an error of R.
  double growth() const;

  // Of B_A J B^-1 b: `b` and the error that it has.
  Vector force(const Vector& b, const Vector& terms) const;

  const reference::Robot<double>& robot_;
  const Vector& q_;
  reference::Task<double> task_;
  reference::OperationalSpace<double> space_;
  Matrix J_terms_, inverse_, inverse_terms_, B_A_, B_A_terms_;
};

}  // namespace flatdyn

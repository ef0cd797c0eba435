// SPDX-License-Identifier: GPL-2.0-or-later
// The operational space's functions: what the reference says they are, and how large rounding errors may be.
#pragma once

#include <vector>

#include "flatdyn/reference/magnitude.hpp"
#include "flatdyn/reference/operational.hpp"
#include "verify/reference_model.hpp"

namespace flatdyn {

// The entries in the order of the function's outputs.
template <class S>
std::vector<S> operational_inertia_entries(const reference::Robot<S>& robot, const reference::VectorX<S>& q,
                                           const std::vector<int>& task) {
  const auto space = reference::operational_space(robot, q, task);
  std::vector<S> entries = row_by_row(space.B_A);
  const std::vector<S> more = row_by_row(reference::consistent_inverse(space));
  entries.insert(entries.end(), more.begin(), more.end());
  return entries;
}

template <class S>
std::vector<S> operational_bias_entries(const reference::Robot<S>& robot, const reference::VectorX<S>& q,
                                        const reference::VectorX<S>& qd, const std::vector<int>& task) {
  std::vector<S> entries = row_by_row(reference::operational_coriolis(robot, q, qd, task));
  const std::vector<S> more = row_by_row(reference::operational_gravity(robot, q, task));
  entries.insert(entries.end(), more.begin(), more.end());
  return entries;
}

// Whether J B^-1 Jᵀ can be inverted in doubles, with some digits left.
bool is_regular(const reference::Robot<double>& robot, const reference::VectorX<double>& q,
                const std::vector<int>& task);

// What an error of the last place in each of the terms of B, J and the torques becomes: inverses pass it on.
class OperationalMagnitude {
 public:
  OperationalMagnitude(const reference::Robot<double>& robot, const reference::VectorX<double>& q,
                       const std::vector<int>& task);

  std::vector<double> inertia() const;
  std::vector<double> bias(const reference::VectorX<double>& qd) const;
  std::vector<double> null_space(const reference::VectorX<double>& tau) const;

 private:
  using Vector = reference::VectorX<double>;
  using Matrix = reference::MatrixX<double>;

  // Of B_A J B^-1 b: `b` and the error that it has.
  Vector force(const Vector& b, const Vector& terms) const;

  const reference::Robot<double>& robot_;
  const Vector& q_;
  const std::vector<int>& task_;
  reference::OperationalSpace<double> space_;
  Matrix J_terms_, inverse_, inverse_terms_, B_A_, B_A_terms_;
};

}  // namespace flatdyn

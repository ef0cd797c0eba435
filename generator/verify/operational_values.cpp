// SPDX-License-Identifier: GPL-2.0-or-later
#include "verify/operational_values.hpp"

namespace flatdyn {

bool is_regular(const reference::Robot<double>& robot, const reference::VectorX<double>& q,
                const std::vector<int>& task) {
  constexpr double kLeastReciprocalCondition = 1e-9;
  const auto space = reference::operational_space(robot, q, task);
  const reference::MatrixX<double> mobility = space.J * space.B_inverse * space.J.transpose();
  const reference::VectorX<double> sizes = mobility.selfadjointView<Eigen::Lower>().eigenvalues();
  return sizes.minCoeff() > kLeastReciprocalCondition * sizes.maxCoeff();
}

OperationalMagnitude::OperationalMagnitude(const reference::Robot<double>& robot, const Vector& q,
                                           const std::vector<int>& task)
    : robot_(robot), q_(q), task_(task), space_(reference::operational_space(robot, q, task)) {
  J_terms_ = Matrix(reference::jacobian_magnitude(robot, q)(task, Eigen::all));
  inverse_ = space_.B_inverse.cwiseAbs();
  inverse_terms_ = inverse_ * reference::inertia_magnitude(robot, q) * inverse_;
  B_A_ = space_.B_A.cwiseAbs();
  const Matrix mobility_terms = J_terms_ * (inverse_terms_ + inverse_) * J_terms_.transpose();
  B_A_terms_ = B_A_ * mobility_terms * B_A_;
}

std::vector<double> OperationalMagnitude::inertia() const {
  std::vector<double> entries = row_by_row(B_A_terms_);
  const Matrix J_bar =
      (inverse_terms_ + inverse_) * J_terms_.transpose() * B_A_ + inverse_ * J_terms_.transpose() * B_A_terms_;
  const std::vector<double> more = row_by_row(J_bar);
  entries.insert(entries.end(), more.begin(), more.end());
  return entries;
}

OperationalMagnitude::Vector OperationalMagnitude::force(const Vector& b, const Vector& terms) const {
  const Vector acceleration_terms = J_terms_ * (inverse_terms_ * b.cwiseAbs() + inverse_ * terms);
  return B_A_ * acceleration_terms + B_A_terms_ * (space_.J * space_.B_inverse * b).cwiseAbs();
}

std::vector<double> OperationalMagnitude::bias(const Vector& qd) const {
  const Vector zero = Vector::Zero(q_.size());
  const Vector c = reference::inverse_dynamics(robot_, q_, qd, zero, {.gravity = false, .friction = false});
  const Vector g = reference::gravity(robot_, q_);
  const Eigen::Vector2d drift = reference::tip_acceleration_magnitude(robot_, q_, qd);
  Vector drift_terms(static_cast<Eigen::Index>(task_.size()));
  for (std::size_t i = 0; i < task_.size(); ++i)
    drift_terms(static_cast<Eigen::Index>(i)) = drift(task_[i] < 3 ? 0 : 1);
  const Vector drift_now = Vector(reference::jacobian_dot_qd(robot_, q_, qd)(task_)).cwiseAbs();
  const Vector c_A =
      force(c, reference::torque_magnitude(robot_, q_, qd, zero)) + B_A_ * drift_terms + B_A_terms_ * drift_now;
  std::vector<double> entries = row_by_row(c_A);
  const std::vector<double> more = row_by_row(force(g, reference::torque_magnitude(robot_, q_, zero, zero)));
  entries.insert(entries.end(), more.begin(), more.end());
  return entries;
}

std::vector<double> OperationalMagnitude::null_space(const Vector& tau) const {
  const Vector size = tau.cwiseAbs();
  const Vector f = (space_.B_A * (space_.J * (space_.B_inverse * tau))).cwiseAbs();
  return row_by_row(Vector(size + J_terms_.transpose() * (f + force(tau, size))));
}

}  // namespace flatdyn

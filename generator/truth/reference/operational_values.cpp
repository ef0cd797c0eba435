// SPDX-License-Identifier: GPL-2.0-or-later
#include "truth/reference/operational_values.hpp"

namespace flatdyn {

bool is_regular(const reference::Robot<double>& robot, const reference::VectorX<double>& q, const Task& task) {
  constexpr double kLeastReciprocalCondition = 1e-9;
  const reference::Task<double> wanted = reference_task<double>(task);
  const auto mobility = mobility_of(reference::operational_space(robot, q, wanted), wanted);
  const reference::VectorX<double> sizes = mobility.selfadjointView<Eigen::Lower>().eigenvalues();
  return sizes.minCoeff() > kLeastReciprocalCondition * sizes.maxCoeff();
}

OperationalMagnitude::OperationalMagnitude(const reference::Robot<double>& robot, const Vector& q, const Task& task)
    : robot_(robot),
      q_(q),
      task_(reference_task<double>(task)),
      space_(reference::operational_space(robot, q, task_)),
      J_terms_(jacobian_terms()) {
  inverse_ = space_.B_inverse.cwiseAbs();
  inverse_terms_ = inverse_ * reference::inertia_magnitude(robot, q) * inverse_;
  B_A_ = space_.B_A.cwiseAbs();
  const Matrix mobility_terms = J_terms_ * (inverse_terms_ + inverse_) * J_terms_.transpose();
  B_A_terms_ = B_A_ * mobility_terms * B_A_;
}

double OperationalMagnitude::growth() const {
  const reference::Matrix3<double> R = reference::tip_pose(robot_, q_).R;
  const Eigen::Index column = task_.angles == reference::Angles::zyz ? 2 : 0;
  return 1 / R.col(column).head<2>().squaredNorm();
}

// With Euler angles, T^-1 J has the errors of J and those of T^-1 itself.
OperationalMagnitude::Matrix OperationalMagnitude::jacobian_terms() const {
  Matrix terms = reference::jacobian_magnitude(robot_, q_);
  if (task_.angles != reference::Angles::none) {
    const auto angles = reference::euler_angles(reference::tip_pose(robot_, q_).R, task_.angles);
    const Matrix inverse = reference::rates_to_velocity(angles, task_.angles).inverse().cwiseAbs();
    const Matrix turning = reference::jacobian(robot_, q_).bottomRows<3>().cwiseAbs();
    terms.bottomRows<3>() = Matrix(inverse * terms.bottomRows<3>() + Matrix::Constant(3, 3, growth()).eval() * turning);
  }
  return terms(task_.rows, Eigen::all);
}

// With Euler angles, T^-1 Ṫ φ̇ has additional terms of size (|ω| / s)², whose errors grow with 1 / s as those of T^-1
// do.
OperationalMagnitude::Vector OperationalMagnitude::drift_terms(const Vector& qd) const {
  const Eigen::Vector2d of_tip = reference::tip_acceleration_magnitude(robot_, q_, qd);
  Vector terms(6);
  terms << Eigen::Vector3d::Constant(of_tip[0]), Eigen::Vector3d::Constant(of_tip[1]);
  if (task_.angles != reference::Angles::none) {
    const double rate = (reference::jacobian(robot_, q_).bottomRows<3>().cwiseAbs() * qd.cwiseAbs()).sum();
    terms.tail<3>().setConstant(growth() * (3 * of_tip[1] + rate * rate * std::sqrt(growth())));
  }
  return terms(task_.rows);
}

std::vector<double> OperationalMagnitude::inertia() const {
  std::vector<double> entries = row_by_row(B_A_terms_);
  const Matrix J_bar =
      (inverse_terms_ + inverse_) * J_terms_.transpose() * B_A_ + inverse_ * J_terms_.transpose() * B_A_terms_;
  const std::vector<double> more = row_by_row(J_bar);
  entries.insert(entries.end(), more.begin(), more.end());
  const Matrix M = space_.B_A.inverse();
  const Matrix M_terms = J_terms_ * (inverse_terms_ + inverse_) * J_terms_.transpose();
  entries.push_back(reference::condition(space_) *
                    (1 + M_terms.trace() / M.trace() + B_A_terms_.trace() / space_.B_A.trace()));
  return entries;
}

OperationalMagnitude::Vector OperationalMagnitude::force(const Vector& b, const Vector& terms) const {
  const Vector acceleration_terms = J_terms_ * (inverse_terms_ * b.cwiseAbs() + inverse_ * terms);
  return B_A_ * acceleration_terms + B_A_terms_ * (space_.J * space_.B_inverse * b).cwiseAbs();
}

std::vector<double> OperationalMagnitude::bias(const Vector& qd) const {
  const Vector zero = Vector::Zero(robot_.size());
  const Vector c =
      reference::inverse_dynamics(robot_, q_, qd, zero, {.gravity = false, .friction = false, .springs = false});
  const Vector g = reference::gravity(robot_, q_);
  const Vector drift = reference::task_drift(robot_, q_, qd, task_).cwiseAbs();
  const Vector c_A = force(c, reference::torque_magnitude(robot_, q_, qd, zero, {.springs = false})) +
                     B_A_ * drift_terms(qd) + B_A_terms_ * drift;
  std::vector<double> entries = row_by_row(c_A);
  const std::vector<double> more =
      row_by_row(force(g, reference::torque_magnitude(robot_, q_, zero, zero, {.springs = false})));
  entries.insert(entries.end(), more.begin(), more.end());
  return entries;
}

std::vector<double> OperationalMagnitude::null_space(const Vector& tau) const {
  const Vector size = tau.cwiseAbs();
  const Vector f = (space_.B_A * (space_.J * (space_.B_inverse * tau))).cwiseAbs();
  return row_by_row(Vector(size + J_terms_.transpose() * (f + force(tau, size))));
}

}  // namespace flatdyn

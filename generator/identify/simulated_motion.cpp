// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/simulated_motion.hpp"

#include <Eigen/LU>
#include <numbers>

namespace flatdyn {

using Eigen::Index;
using Eigen::VectorXd;

SimulatedMotion::SimulatedMotion(const TorqueEquations& equations, const VectorXd& values)
    : equations_(equations),
      values_(values),
      entries_(static_cast<std::size_t>(equations.entries())),
      known_(static_cast<std::size_t>(equations.equations())) {}

void SimulatedMotion::evaluate(const VectorXd& q, const VectorXd& qd, const VectorXd& qdd, const double* friction_rates,
                               double* entries) const {
  equations_.evaluate({0, q.data(), qd.data(), qdd.data(), nullptr}, entries, known_.data());
  for (const FrictionEntry& each : equations_.friction()) entries[each.entry] = each.value(friction_rates[each.joint]);
}

VectorXd SimulatedMotion::torques(const double* entries) const {
  VectorXd tau = VectorXd::Zero(equations_.equations());
  for (Index i = 0; i < tau.size(); ++i) {
    for (const int column : equations_.columns()[static_cast<std::size_t>(i)]) tau[i] += *entries++ * values_[column];
  }
  return tau;
}

// q̈ follows from B q̈ + n = τ with the friction of the measured speeds, whose sign would otherwise chatter, and from
// slow feedback. One step of the semi-implicit Euler method is accurate enough: an instrument need not be exact.
void SimulatedMotion::step(const MeasuredMotion& motion, const double* measured, double dt, double* entries) {
  constexpr double kFeedback = 2 * std::numbers::pi * 1.0;  // rad/s
  const Index n = equations_.equations();
  const Eigen::Map<const VectorXd> q(motion.q, n), qd(motion.qd, n), tau(measured, n);
  if (!started_) {
    q_ = q;
    qd_ = qd;
    started_ = true;
  }
  const VectorXd zero = VectorXd::Zero(n);
  evaluate(q_, qd_, zero, motion.qd, entries_.data());
  const VectorXd rest = torques(entries_.data());
  Eigen::MatrixXd B(n, n);
  const EquationInstant here{.q = {q_.begin(), q_.end()}};
  const std::vector<Eigen::MatrixXd> rows = equations_.acceleration_rows()(here);
  for (Index j = 0; j < n; ++j) B.col(j) = rows[static_cast<std::size_t>(j)] * values_;
  const VectorXd feedback = kFeedback * kFeedback * (q - q_) + 2 * kFeedback * (qd - qd_);
  const VectorXd qdd = Eigen::PartialPivLU<Eigen::MatrixXd>(B).solve(tau - rest) + feedback;
  evaluate(q_, qd_, qdd, qd_.data(), entries);
  qd_ += dt * qdd;
  q_ += dt * qd_;
}

}  // namespace flatdyn

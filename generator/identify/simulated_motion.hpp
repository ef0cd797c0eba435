// SPDX-License-Identifier: GPL-2.0-or-later
// The motion of the identified model under the measured torques: the instrument of instrumental variables (Janot,
// Vandanjon, Gautier; IEEE Transactions on Control Systems Technology 22, 2014). It follows the real motion, and has no
// part in the noise of the measured positions but through slow feedback, without which it would drift away.
#pragma once

#include <Eigen/Core>

#include "identify/torque_equations.hpp"

namespace flatdyn {

class SimulatedMotion : public Instrument {
 public:
  // values: of all parameters of the equations.
  SimulatedMotion(const TorqueEquations& equations, const Eigen::VectorXd& values);

  void restart() override { started_ = false; }
  void step(const MeasuredMotion& motion, const double* measured, double dt, double* entries) override;

 private:
  // Writes the entries of Y at q, q̇, q̈, with friction at other speeds.
  void evaluate(const Eigen::VectorXd& q, const Eigen::VectorXd& qd, const Eigen::VectorXd& qdd,
                const double* friction_rates, double* entries) const;
  Eigen::VectorXd torques(const double* entries) const;

  const TorqueEquations& equations_;
  Eigen::VectorXd values_, q_, qd_;
  std::vector<double> entries_;
  mutable std::vector<double> known_;
  bool started_ = false;
};

}  // namespace flatdyn

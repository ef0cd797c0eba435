// SPDX-License-Identifier: GPL-2.0-or-later
// The torques that drive a simulated arm as a function of time and state.
#pragma once

#include "laboratory/simulate/joint_dynamics.hpp"
#include "laboratory/simulate/simulation.hpp"

namespace flatdyn {

class TorqueLaw {
 public:
  TorqueLaw(const Simulation& simulation, JointDynamics& dynamics);

  // The first time after t, in s, at which the torque may jump or bend; infinity if there is none.
  double next_knot(double t) const;
  // Must be called at the beginning and at each knot. A law with a period measures there and then keeps its torque
  // constant.
  void start(double t, const double* q, const double* qd);
  // The torques, N m (N); smooth from one knot to the next.
  const Eigen::VectorXd& at(double t, const double* q, const double* qd);

 private:
  void feedback(double t, const double* q, const double* qd);
  void sampled(double t);
  void saturate();

  const Simulation& simulation_;
  JointDynamics& dynamics_;
  Eigen::VectorXd constant_, kp_, kd_, position_, limits_;
  Eigen::VectorXd torque_;
  std::size_t sample_ = 0;  // the last sample not after the time of start()
  bool held_ = false;       // torque_ stays constant until the next knot
};

}  // namespace flatdyn

// SPDX-License-Identifier: BSD-3-Clause
// What runs every millisecond, in float, without heap or exceptions; arrays are in the order of arm::joint_names.
#pragma once

#include "arm.hpp"

constexpr int n = arm::joint_count;

struct JointState {
  float q[n], qd[n];  // rad, rad/s
};

struct Reference {
  float q[n], qd[n], qdd[n];
};

// Where joint `name` of a message is in our arrays; -1 if the arm has no such joint. Names are the URDF's.
int index_of(const char* name);

// tau = g(q) - K_D qd: the arm can be led by hand, and stays where it is left.
void gravity_compensation(const JointState& now, float* tau);

// Torques that others exert on the arm, without a sensor for them and without accelerations: since
// dp/dt = tau + C^T qd - g + tau_ext, the residual r = K_O (p(t) - p(0) - integral of tau + C^T qd - g + r) follows
// tau_ext with the time constant 1 / K_O (De Luca and others, IROS 2006). Friction that is not modelled counts as such
// a torque.
class MomentumObserver {
 public:
  explicit MomentumObserver(const JointState& start);
  // After a period (s) in which the torques tau were applied; returns r, N m.
  const float* update(const JointState& now, const float* tau, float period);

 private:
  float p_0_[n], integral_[n], r_[n];
};

// tau = B(q) (qdd_d + K_D (qd_d - qd) + K_P (q_d - q)) + C(q, qd) qd + g(q): computed torque, textbook chapter 8.
void computed_torque(const JointState& now, const Reference& wanted, float* tau);

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

// tau = B(q) (qdd_d + K_D (qd_d - qd) + K_P (q_d - q)) + C(q, qd) qd + g(q): computed torque, textbook chapter 8.
void computed_torque(const JointState& now, const Reference& wanted, float* tau);

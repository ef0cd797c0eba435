// SPDX-License-Identifier: BSD-3-Clause
// The control loop of every millisecond: the body follows a motion while the feet stand, without heap or exceptions.
#pragma once

#include "quadruped.hpp"

constexpr int kJoints = quadruped::joint_count, kVelocities = quadruped::velocity_count;
constexpr int kFeet = 4, kForces = 3 * kFeet;

// The base's pose and twist, and the joints, as measured or estimated.
struct State {
  double p[3];            // position of the base frame's origin, world, m
  double quaternion[4];   // w, x, y, z: from base axes to world axes, unit
  double q[kJoints];      // rad
  double v[kVelocities];  // velocity of the origin (m/s), angular velocity (rad/s), both in base axes; joints (rad/s)
};

// Where the base's origin is to be, in the world; its axes are to be those of the world.
struct Wanted {
  double p[3], dp[3], ddp[3];  // m, m/s, m/s^2
};

struct Command {
  double tau[kJoints];  // N m
  double f[kForces];    // of the ground on each foot, base axes, N: what the torques rely on
};

// Gravity in base axes, R^T g_0.
void gravity_in_base(const double* quaternion, double* g_b);

// A vector in base axes, as one in world axes.
void to_world(const double* quaternion, const double* in_base, double* in_world);

// The torques for the wanted motion with smallest forces at the feet; false if a leg is stretched, or the feet are on
// one line.
bool stand(const State& now, const Wanted& wanted, Command& command);

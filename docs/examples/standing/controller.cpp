// SPDX-License-Identifier: BSD-3-Clause
#include "controller.hpp"

#include <cmath>

namespace {

constexpr int kTwist = 6;
constexpr double kProportional = 100.0, kRate = 20.0;  // 1/s^2, 1/s: both poles at -10/s
constexpr double kGravity = 9.81;                      // m/s^2

void rotation_of(const double* quaternion, double (&R)[3][3]) {
  const double w = quaternion[0], x = quaternion[1], y = quaternion[2], z = quaternion[3];
  const double rows[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                             {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                             {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) R[i][k] = rows[i][k];
  }
}

void to_base(const double* quaternion, const double* in_world, double* in_base) {
  double R[3][3];
  rotation_of(quaternion, R);
  for (int k = 0; k < 3; ++k) in_base[k] = R[0][k] * in_world[0] + R[1][k] * in_world[1] + R[2][k] * in_world[2];
}

// The derivatives of the base's twist that bring it to the wanted pose.
void base_acceleration(const State& now, const Wanted& wanted, double* a) {
  const double *v = now.v, *omega = now.v + 3;
  double dp[3], ddp[3];
  to_world(now.quaternion, v, dp);
  for (int k = 0; k < 3; ++k) {
    ddp[k] = wanted.ddp[k] + kRate * (wanted.dp[k] - dp[k]) + kProportional * (wanted.p[k] - now.p[k]);
  }
  to_base(now.quaternion, ddp, a);
  // v is in axes that turn: its derivative lacks omega x v.
  a[0] -= omega[1] * v[2] - omega[2] * v[1];
  a[1] -= omega[2] * v[0] - omega[0] * v[2];
  a[2] -= omega[0] * v[1] - omega[1] * v[0];
  const double nearer = now.quaternion[0] < 0 ? -2.0 : 2.0;  // of the two quaternions of one rotation
  for (int k = 0; k < 3; ++k) a[3 + k] = -kRate * omega[k] - kProportional * nearer * now.quaternion[1 + k];
}

// Solves the three equations M x = b by Cramer's rule; false if M is singular.
bool solve(const double (&M)[3][3], const double* b, double* x) {
  const auto cross_dot = [](const double* a, const double* c, const double* d) {
    return a[0] * (c[1] * d[2] - c[2] * d[1]) + a[1] * (c[2] * d[0] - c[0] * d[2]) + a[2] * (c[0] * d[1] - c[1] * d[0]);
  };
  double columns[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) columns[k][i] = M[i][k];
  }
  const double determinant = cross_dot(columns[0], columns[1], columns[2]);
  constexpr double kStretched = 1e-5;  // m^3: a leg near its full length
  if (std::fabs(determinant) < kStretched) return false;
  x[0] = cross_dot(b, columns[1], columns[2]) / determinant;
  x[1] = cross_dot(columns[0], b, columns[2]) / determinant;
  x[2] = cross_dot(columns[0], columns[1], b) / determinant;
  return true;
}

// The accelerations of the joints with which feet that stand follow the base: J_c a + b_c = 0, leg by leg.
bool joint_accelerations(const State& now, double* a) {
  double p_c[kForces], J_c[kForces * kVelocities], b_c[kForces];
  quadruped::contact_jacobian(now.q, p_c, J_c);
  quadruped::contact_bias(now.q, now.v, b_c);
  for (int foot = 0; foot < kFeet; ++foot) {
    double M[3][3], b[3];
    for (int i = 0; i < 3; ++i) {
      const int row = 3 * foot + i;
      b[i] = -b_c[row];
      for (int k = 0; k < kTwist; ++k) b[i] -= J_c[row * kVelocities + k] * a[k];
      for (int k = 0; k < 3; ++k) M[i][k] = J_c[row * kVelocities + kTwist + 3 * foot + k];
    }
    if (!solve(M, b, a + kTwist + 3 * foot)) return false;
  }
  return true;
}

}  // namespace

void gravity_in_base(const double* quaternion, double* g_b) {
  const double g_0[3] = {0, 0, -kGravity};
  to_base(quaternion, g_0, g_b);
}

void to_world(const double* quaternion, const double* in_base, double* in_world) {
  double R[3][3];
  rotation_of(quaternion, R);
  for (int i = 0; i < 3; ++i) in_world[i] = R[i][0] * in_base[0] + R[i][1] * in_base[1] + R[i][2] * in_base[2];
}

bool stand(const State& now, const Wanted& wanted, Command& command) {
  double g_b[3], a[kVelocities], tau[kVelocities], condition[1];
  gravity_in_base(now.quaternion, g_b);
  base_acceleration(now, wanted, a);
  if (!joint_accelerations(now, a)) return false;
  if (!quadruped::contact_inverse_dynamics(now.q, g_b, now.v, a, tau, command.f, condition)) return false;
  for (int k = 0; k < kJoints; ++k) command.tau[k] = tau[kTwist + k];
  return true;
}

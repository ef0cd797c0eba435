// SPDX-License-Identifier: BSD-3-Clause
#include "controller.hpp"

#include <cstring>

namespace {

constexpr float kDamping = 2.0f;                        // N m s/rad
constexpr float kProportional = 400.0f, kRate = 40.0f;  // 1/s^2, 1/s: both poles at -20/s
constexpr float kObserver = 50.0f;                      // 1/s

}  // namespace

int index_of(const char* name) {
  for (int i = 0; i < n; ++i) {
    if (std::strcmp(name, arm::joint_names[i]) == 0) return i;
  }
  return -1;
}

void gravity_compensation(const JointState& now, float* tau) {
  arm::gravity(now.q, tau);
  for (int i = 0; i < n; ++i) tau[i] -= kDamping * now.qd[i];
}

MomentumObserver::MomentumObserver(const JointState& start) : p_0_{}, integral_{}, r_{} {
  arm::momentum(start.q, start.qd, p_0_);
}

const float* MomentumObserver::update(const JointState& now, const float* tau, float period) {
  float p[n], coriolis[n], g[n];
  arm::momentum(now.q, now.qd, p);
  arm::coriolis_transpose_qd(now.q, now.qd, coriolis);
  arm::gravity(now.q, g);
  for (int i = 0; i < n; ++i) {
    integral_[i] += period * (tau[i] + coriolis[i] - g[i] + r_[i]);
    r_[i] = kObserver * (p[i] - p_0_[i] - integral_[i]);
  }
  return r_;
}

void computed_torque(const JointState& now, const Reference& wanted, float* tau) {
  float qdd[n];
  for (int i = 0; i < n; ++i) {
    qdd[i] = wanted.qdd[i] + kRate * (wanted.qd[i] - now.qd[i]) + kProportional * (wanted.q[i] - now.q[i]);
  }
  arm::inverse_dynamics(now.q, now.qd, qdd, tau);
}

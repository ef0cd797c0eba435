// SPDX-License-Identifier: BSD-3-Clause
// A spherical joint on a fixed base: Pinocchio's convention has another order of its quaternion, and nothing else.
#include <array>
#include <cmath>
#include <cstdio>

#include "ball_wrist_pinocchio.hpp"
#include "ball_wrist_pose.hpp"

namespace {

constexpr int kWrist = 2;  // the first entry of the quaternion

template <std::size_t n>
using Numbers = std::array<double, n>;
using Positions = Numbers<ball_wrist::position_count>;
using Rates = Numbers<ball_wrist::joint_count>;

Positions scalar_last(Positions q) {
  const double w = q[kWrist];
  for (std::size_t k = kWrist; k < kWrist + 3; ++k) q[k] = q[k + 1];
  q[kWrist + 3] = w;
  return q;
}

int failed = 0;

void expect(bool holds, const char* what) {
  if (holds) return;
  ++failed;
  std::printf("%s\n", what);
}

}  // namespace

int main() {
  const Positions q = {0.3, -0.7, 0.5, -0.5, 0.5, 0.5, 1.1, 0.4}, q_last = scalar_last(q);
  const Rates v = {0.2, -1.1, 0.9, 0.4, -1.7, 0.6, 1.3}, a = {1, 2, -3, 0.5, 0.1, -0.2, 0.7};
  Rates tau, tau_last, back;
  ball_wrist::pose::inverse_dynamics(q.data(), v.data(), a.data(), tau.data());
  ball_wrist::pinocchio::inverse_dynamics(q_last.data(), v.data(), a.data(), tau_last.data());
  expect(tau == tau_last, "inverse_dynamics");

  Positions next, next_last;
  ball_wrist::pose::integrate(q.data(), v.data(), 0.3, next.data());
  ball_wrist::pinocchio::integrate(q_last.data(), v.data(), 0.3, next_last.data());
  expect(scalar_last(next) == next_last, "integrate");
  ball_wrist::pinocchio::difference(q_last.data(), next_last.data(), back.data());
  for (std::size_t k = 0; k < v.size(); ++k) expect(std::fabs(back[k] - 0.3 * v[k]) < 1e-15, "difference");

  // The wrist turns about the axis v of its child: w is cos(|v| dt / 2) where it starts from no turn.
  Positions still = q;
  for (std::size_t k = 0; k < 4; ++k) still[kWrist + k] = k == 0;
  ball_wrist::pose::integrate(still.data(), v.data(), 0.3, next.data());
  const double angle = 0.3 * std::sqrt(v[2] * v[2] + v[3] * v[3] + v[4] * v[4]);
  expect(std::fabs(next[kWrist] - std::cos(angle / 2)) < 1e-15, "turn");
  std::printf("%d do not hold\n", failed);
}

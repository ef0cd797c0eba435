// SPDX-License-Identifier: BSD-3-Clause
// A leg that is a closed loop, on a floating base, in two conventions: power and accelerations are the same, and a step
// closes the loop again.
#include <array>
#include <cmath>
#include <cstdio>

#include "five_bar_hopper.hpp"
#include "five_bar_hopper_mujoco.hpp"
#include "five_bar_hopper_pose.hpp"

namespace robot = five_bar_hopper;

namespace {

constexpr int kPose = 7;

using Positions = std::array<double, kPose + robot::position_count>;
using Rates = std::array<double, robot::velocity_count>;

int failed = 0;

void expect(bool holds, const char* what) {
  if (holds) return;
  ++failed;
  std::printf("%s\n", what);
}

double dot(const Rates& a, const Rates& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

double distance(const Rates& a, const Rates& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += std::fabs(a[k] - b[k]);
  return sum;
}

// The first three entries in axes of the world, by the base's quaternion (0.5, 0.5, 0.5, 0.5): x becomes y, y z, z x.
Rates in_world(Rates v) {
  const Rates from = v;
  for (std::size_t k = 0; k < 3; ++k) v[(k + 1) % 3] = from[k];
  return v;
}

}  // namespace

int main() {
  Positions q = {0.1, -0.2, 0.6, 0.5, 0.5, 0.5, 0.5, 0.7, 1.2, 2.5, -1.2};
  expect(robot::close_loops(&q[kPose], 1e-14), "close_loops");
  const Rates v = {0.4, -0.3, 0.2, 0.5, -0.6, 0.7, 1.1, -0.8}, tau = {1, 2, -3, 0.1, 0.2, -0.3, 0.04, -0.05};
  Rates a, a_mujoco, force, force_mujoco, back;
  const Rates v_mujoco = in_world(v), tau_mujoco = in_world(tau);
  expect(robot::pose::forward_dynamics(q.data(), v.data(), tau.data(), a.data()), "forward_dynamics");
  expect(robot::mujoco::forward_dynamics(q.data(), v_mujoco.data(), tau_mujoco.data(), a_mujoco.data()),
         "forward_dynamics of mujoco");
  for (std::size_t k = 3; k < a.size(); ++k) expect(std::fabs(a[k] - a_mujoco[k]) < 1e-10, "acceleration");
  expect(robot::pose::inverse_dynamics(q.data(), v.data(), a.data(), force.data()), "inverse_dynamics");
  expect(robot::mujoco::inverse_dynamics(q.data(), v_mujoco.data(), a_mujoco.data(), force_mujoco.data()),
         "inverse_dynamics of mujoco");
  expect(distance(force, tau) < 1e-12, "force");
  expect(std::fabs(dot(force, v) - dot(force_mujoco, v_mujoco)) < 1e-12, "power");

  // C v and gravity are the forces without acceleration.
  const Rates rest = {};
  std::array<double, robot::velocity_count * robot::velocity_count> C;
  expect(robot::mujoco::coriolis_matrix(q.data(), v_mujoco.data(), C.data()), "coriolis_matrix");
  expect(robot::mujoco::gravity(q.data(), back.data()), "gravity");
  for (std::size_t i = 0; i < v.size(); ++i) {
    for (std::size_t k = 0; k < v.size(); ++k) back[i] += C[i * v.size() + k] * v_mujoco[k];
  }
  expect(robot::mujoco::inverse_dynamics(q.data(), v_mujoco.data(), rest.data(), force_mujoco.data()), "bias");
  expect(distance(back, force_mujoco) < 1e-13, "C v and gravity");

  Positions next;
  robot::pose::integrate(q.data(), v.data(), 0.2, next.data());
  expect(next[kPose + 1] == q[kPose + 1], "joints that the loop moves stay");
  expect(robot::close_loops(&next[kPose], 1e-14), "close_loops after a step");
  expect(next[kPose + 1] != q[kPose + 1], "joints that the loop moves follow");
  robot::pose::difference(q.data(), next.data(), back.data());
  for (std::size_t k = 0; k < v.size(); ++k) expect(std::fabs(back[k] - 0.2 * v[k]) < 1e-14, "difference");
  std::printf("%d do not hold\n", failed);
}

// SPDX-License-Identifier: BSD-3-Clause
// The controller and the robot that it moves, a thousand times per second: the body goes round while four feet stand.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "controller.hpp"
#include "simulated.hpp"
#include "simulated_pose.hpp"

namespace {

constexpr double kPeriod = 1e-3, kDuration = 4.0;  // s
constexpr int kStepsPerPeriod = 4;                 // of the simulation

// Legs bent, forelegs and hind legs alike, and the feet on the ground, z = 0.
State at_rest() {
  State state = {};
  state.quaternion[0] = 1;
  for (int leg = 0; leg < kFeet; ++leg) {
    state.q[3 * leg + 1] = 0.6;
    state.q[3 * leg + 2] = -1.2;
  }
  double p_c[kForces], J_c[kForces * kVelocities];
  quadruped::contact_jacobian(state.q, p_c, J_c);
  state.p[2] = -p_c[2];
  return state;
}

// From rest, once round in two seconds: to the side by 2 cm, forwards by 3 cm, down by 4 cm.
Wanted wanted_at(double time, const State& start) {
  const double omega = 3.141592653589793, size[3] = {0.03, 0.02, -0.02};
  const double from_rest = 1 - std::exp(-2 * time * time), rate = 4 * time * (1 - from_rest);
  const double change = (4 - 16 * time * time) * (1 - from_rest);
  Wanted wanted;
  for (int k = 0; k < 3; ++k) {
    const double phase = omega * time + (k == 0 ? 0 : 1.5707963267948966);
    const double x = std::sin(phase) - (k == 0 ? 0 : 1), dx = omega * std::cos(phase),
                 ddx = -omega * omega * std::sin(phase);
    wanted.p[k] = start.p[k] + size[k] * from_rest * x;
    wanted.dp[k] = size[k] * (rate * x + from_rest * dx);
    wanted.ddp[k] = size[k] * (change * x + 2 * rate * dx + from_rest * ddx);
  }
  return wanted;
}

// One step of the simulated robot, the torques held; false if the feet do not determine their forces.
bool step(const Command& command, double time, State& state) {
  double g_b[3], tau[kVelocities] = {}, a[kVelocities], f[kForces], condition[1];
  std::copy_n(command.tau, kJoints, tau + 6);
  gravity_in_base(state.quaternion, g_b);
  if (!simulated::constrained_forward_dynamics(state.q, g_b, state.v, tau, a, f, condition)) return false;
  for (int k = 0; k < kVelocities; ++k) state.v[k] += time * a[k];
  // Stops what velocity of the feet rounding and the step's length have left.
  double stopped[kVelocities], impulse[kForces];
  if (!simulated::contact_impact(state.q, state.v, stopped, impulse, condition)) return false;
  std::copy_n(stopped, kVelocities, state.v);
  double pose[7 + kJoints], next[7 + kJoints];
  std::copy_n(state.p, 3, pose), std::copy_n(state.quaternion, 4, pose + 3), std::copy_n(state.q, kJoints, pose + 7);
  simulated::pose::integrate(pose, state.v, time, next);
  std::copy_n(next, 3, state.p), std::copy_n(next + 3, 4, state.quaternion), std::copy_n(next + 7, kJoints, state.q);
  return true;
}

// The largest distance of a foot from where it stood, m.
struct Feet {
  double at[kForces];

  explicit Feet(const State& state) {
    double p_c[kForces], J_c[kForces * kVelocities];
    quadruped::contact_jacobian(state.q, p_c, J_c);
    for (int foot = 0; foot < kFeet; ++foot) {
      to_world(state.quaternion, p_c + 3 * foot, at + 3 * foot);
      for (int k = 0; k < 3; ++k) at[3 * foot + k] += state.p[k];
    }
  }
  double distance_from(const Feet& other) const {
    double largest = 0;
    for (int k = 0; k < kForces; ++k) largest = std::fmax(largest, std::fabs(at[k] - other.at[k]));
    return largest;
  }
};

}  // namespace

int main() {
  const State start = at_rest();
  const Feet stood(start);
  State state = start;
  double off = 0, slipped = 0, least_weight = 1e9, steepest = 0, strongest = 0;
  for (int k = 0; k * kPeriod < kDuration; ++k) {
    const Wanted wanted = wanted_at(k * kPeriod, start);
    Command command;
    if (!stand(state, wanted, command)) return std::puts("the legs do not carry the body here"), 1;
    for (int foot = 0; foot < kFeet; ++foot) {
      double f[3];
      to_world(state.quaternion, command.f + 3 * foot, f);
      least_weight = std::fmin(least_weight, f[2]);
      steepest = std::fmax(steepest, std::hypot(f[0], f[1]) / f[2]);
    }
    for (double tau : command.tau) strongest = std::fmax(strongest, std::fabs(tau));
    for (int i = 0; i < kStepsPerPeriod; ++i) {
      if (!step(command, kPeriod / kStepsPerPeriod, state))
        return std::puts("the feet do not determine their forces"), 1;
    }
    slipped = std::fmax(slipped, Feet(state).distance_from(stood));
    for (int i = 0; i < 3; ++i) off = std::fmax(off, std::fabs(state.p[i] - wanted.p[i]));
  }
  std::printf("the body follows to %.2g mm, and the feet stay to %.2g mm\n", 1e3 * off, 1e3 * slipped);
  std::printf("each foot carries at least %.1f N, and needs friction of %.2f at most; torques stay below %.1f N m\n",
              least_weight, steepest, strongest);
  const bool stands = off < 1e-3 && slipped < 1e-4 && least_weight > 0 && steepest < 0.6;
  std::puts(stands ? "it stands" : "it does not stand");
  return stands ? 0 : 1;
}

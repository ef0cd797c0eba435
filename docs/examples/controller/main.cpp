// SPDX-License-Identifier: BSD-3-Clause
// The controller against a simulated arm, a thousand times per second, as one would try it before it moves metal.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "controller.hpp"
#include "simulated.hpp"

namespace {

constexpr double kPeriod = 1e-3;  // s

struct Arm {
  double q[n], qd[n];
};

// How fast the state changes under constant torques.
Arm rate_of(const Arm& state, const double* tau) {
  Arm rate;
  if (!simulated::forward_dynamics(state.q, state.qd, tau, rate.qd)) {
    std::fprintf(stderr, "the simulated arm has left the finite numbers\n");
    std::exit(1);
  }
  for (int i = 0; i < n; ++i) rate.q[i] = state.qd[i];
  return rate;
}

Arm moved(const Arm& state, const Arm& rate, double time) {
  Arm result = state;
  for (int i = 0; i < n; ++i) {
    result.q[i] += time * rate.q[i];
    result.qd[i] += time * rate.qd[i];
  }
  return result;
}

// One period by the classical Runge–Kutta method; the torques are held, as a controller's are. Somebody pushes a joint.
void step(Arm& arm, const float* tau, int pushed = 0, double push = 0) {
  double held[n];
  for (int i = 0; i < n; ++i) held[i] = static_cast<double>(tau[i]) + (i == pushed ? push : 0);
  const Arm a = rate_of(arm, held), b = rate_of(moved(arm, a, kPeriod / 2), held);
  const Arm c = rate_of(moved(arm, b, kPeriod / 2), held), d = rate_of(moved(arm, c, kPeriod), held);
  arm = moved(moved(moved(moved(arm, a, kPeriod / 6), b, kPeriod / 3), c, kPeriod / 3), d, kPeriod / 6);
}

// As a driver would deliver it: by name, here in the opposite order.
JointState measured(const Arm& arm) {
  JointState state = {};
  for (int i = n - 1; i >= 0; --i) {
    const int k = index_of(simulated::joint_names[i]);
    state.q[k] = static_cast<float>(arm.q[i]);
    state.qd[k] = static_cast<float>(arm.qd[i]);
  }
  return state;
}

// Every joint swings by 0.3 rad around its start, with a period of 4 s.
Reference reference_at(double time, const Arm& start) {
  const double omega = 1.5707963267948966, size = 0.3;
  Reference wanted;
  for (int i = 0; i < n; ++i) {
    wanted.q[i] = static_cast<float>(start.q[i] + size * std::sin(omega * time));
    wanted.qd[i] = static_cast<float>(size * omega * std::cos(omega * time));
    wanted.qdd[i] = static_cast<float>(-size * omega * omega * std::sin(omega * time));
  }
  return wanted;
}

double largest_difference(const double* a, const double* b) {
  double largest = 0;
  for (int i = 0; i < n; ++i) largest = std::fmax(largest, std::fabs(a[i] - b[i]));
  return largest;
}

double drift_under_gravity_compensation(const Arm& start) {
  Arm arm = start;
  float tau[n];
  for (int k = 0; k < 2000; ++k) {
    gravity_compensation(measured(arm), tau);
    step(arm, tau);
  }
  return largest_difference(arm.q, start.q);
}

// The largest error in the last of four seconds: the arm starts at rest, the reference does not.
double tracking_error(const Arm& start) {
  Arm arm = start;
  float tau[n];
  double largest = 0;
  for (int k = 0; k < 4000; ++k) {
    const Reference wanted = reference_at(k * kPeriod, start);
    if (k >= 3000) {
      for (int i = 0; i < n; ++i) {
        largest = std::fmax(largest, std::fabs(arm.q[i] - static_cast<double>(wanted.q[i])));
      }
    }
    computed_torque(measured(arm), wanted, tau);
    step(arm, tau);
  }
  return largest;
}

// The largest error of the observed torques while the arm swings, and from its second second on is pushed by 8 N m.
double observer_error(const Arm& start) {
  constexpr int kPushed = 3;
  constexpr double kPush = 8;  // N m
  Arm arm = start;
  MomentumObserver observer(measured(arm));
  float tau[n];
  double largest = 0;
  for (int k = 0; k < 2000; ++k) {
    const double push = k < 1000 ? 0 : kPush;
    computed_torque(measured(arm), reference_at(k * kPeriod, start), tau);
    step(arm, tau, kPushed, push);
    const float* r = observer.update(measured(arm), tau, static_cast<float>(kPeriod));
    if (k % 1000 < 500) continue;  // it is ten of its time constants behind a change
    for (int i = 0; i < n; ++i) {
      largest = std::fmax(largest, std::fabs(static_cast<double>(r[i]) - (i == kPushed ? push : 0)));
    }
  }
  return largest;
}

}  // namespace

int main() {
  Arm start = {};
  for (int i = 0; i < n; ++i) start.q[i] = i % 2 == 0 ? 0.3 : -0.6;
  const double drift = drift_under_gravity_compensation(start), error = tracking_error(start),
               observed = observer_error(start);
  std::printf("gravity compensation: moved by %.1e rad in 2 s\n", drift);
  std::printf("computed torque: follows to %.1e rad\n", error);
  std::printf("momentum observer: sees a push of 8 N m to %.1e N m\n", observed);
  return drift < 1e-3 && error < 1e-3 && observed < 0.1 ? 0 : 1;
}

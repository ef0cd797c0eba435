// SPDX-License-Identifier: BSD-3-Clause
// Uses the generated header as anyone would, and checks what must hold whatever the arm: B is symmetric with a positive
// diagonal, standing still needs gravity's torques and no others, and float agrees with double.
#include <cmath>
#include <cstdio>

#include "controller.hpp"
#include "panda.hpp"

namespace {

constexpr int n = panda::joint_count;

bool close(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

bool standing_still_needs_gravity_only(const double* q) {
  const double zero[n] = {};
  double tau[n], g[n];
  panda::inverse_dynamics(q, zero, zero, tau);
  panda::gravity(q, g);
  bool same = true;
  for (int i = 0; i < n; ++i) same = same && close(tau[i], g[i], 1e-10);
  return same;
}

bool inertia_is_symmetric_and_positive(const double* q) {
  double B[n * n];
  panda::inertia_matrix(q, B);
  bool good = true;
  for (int i = 0; i < n; ++i) {
    good = good && B[n * i + i] > 0.0;
    for (int j = 0; j < i; ++j) good = good && close(B[n * i + j], B[n * j + i], 0.0);
  }
  return good;
}

bool float_agrees_with_double(const double* q) {
  float q_float[n], tau_float[n];
  double tau[n];
  for (int i = 0; i < n; ++i) q_float[i] = static_cast<float>(q[i]);
  holding_torque(q_float, tau_float);
  panda::gravity(q, tau);
  bool same = true;
  for (int i = 0; i < n; ++i) same = same && close(static_cast<double>(tau_float[i]), tau[i], 1e-3);
  return same;
}

bool check(const char* what, bool holds) {
  std::printf("%s: %s\n", what, holds ? "yes" : "NO");
  return holds;
}

}  // namespace

int main() {
  double q[n];
  for (int i = 0; i < n; ++i) q[i] = 0.1 * (i + 1);
  const bool gravity = check("standing still needs gravity's torques only", standing_still_needs_gravity_only(q));
  const bool inertia = check("B is symmetric, its diagonal positive", inertia_is_symmetric_and_positive(q));
  const bool scalars = check("float agrees with double", float_agrees_with_double(q));
  const bool rounding = check("operations are rounded as they are written",
                              panda::rounding_is_as_written() && panda::rounding_is_as_written<float>());
  return gravity && inertia && scalars && rounding ? 0 : 1;
}

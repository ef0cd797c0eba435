// SPDX-License-Identifier: BSD-3-Clause
// Uses generated code as anyone would, and checks what holds for any arm: B is symmetric with a positive diagonal,
// standing still needs only gravity's torques, and float agrees with double. The Panda is a header; the planar arm, a
// header and a source, must give the bits that its header form gives.
#include <cmath>
#include <cstdio>

#include "controller.hpp"
#include "example_7_2_pair.hpp"
#include "panda.hpp"
#include "planar_2r_example_7_2.hpp"

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
  planar_holding_torque(q_float, tau_float);
  example_7_2_pair::gravity(q, tau);
  for (int i = 0; i < example_7_2_pair::joint_count; ++i) {
    same = same && close(static_cast<double>(tau_float[i]), tau[i], 1e-3);
  }
  return same;
}

bool pair_has_the_bits_of_the_header(const double* q) {
  constexpr int m = planar_2r_example_7_2::joint_count;
  const double qd[m] = {0.3, -0.2}, qdd[m] = {1.0, -3.0};
  double tau[m], tau_pair[m], s[m], c[m];
  for (int i = 0; i < m; ++i) s[i] = std::sin(q[i]), c[i] = std::cos(q[i]);
  planar_2r_example_7_2::inverse_dynamics(q, qd, qdd, tau);
  example_7_2_pair::inverse_dynamics(q, qd, qdd, tau_pair);
  bool same = true;
  for (int i = 0; i < m; ++i) same = same && close(tau[i], tau_pair[i], 0.0);
  example_7_2_pair::inverse_dynamics(q, qd, qdd, tau_pair, example_7_2_pair::GivenSinCos<double>{s, c});
  for (int i = 0; i < m; ++i) same = same && close(tau[i], tau_pair[i], 0.0);
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
                              panda::rounding_is_as_written() && panda::rounding_is_as_written<float>() &&
                                  example_7_2_pair::rounding_is_as_written());
  const bool pair = check("header and source have the bits of the header", pair_has_the_bits_of_the_header(q));
  return gravity && inertia && scalars && rounding && pair ? 0 : 1;
}

// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "planar_2r_example_7_2" as flat code: example_7_2_pair.hpp says how it is used.
// Made by flatdyn 0.1.0; to change it, make it again.
//
// Names count from 1 as in the textbook: q_1 is q[0], s_1 its sine, c_1 its cosine, s_2_3 the sine
// of the angle by which parallel joints 2 and 3 together turn. Of link i: omega_i and domega_i are
// its angular velocity and acceleration, ddp_i the acceleration of its frame's origin less gravity,
// f_i and mu_i the force and moment that it gets from the link before, hc_i and hu_i the first
// moment of all that its joint carries (in gravity() times the size of gravity); t1, t2, ... are
// parts of sums. A distance between joints may be the unit of length here, though not of arguments.

#include "example_7_2_pair.hpp"

namespace example_7_2_pair {

// tau = B(q) qdd + C(q, qd) qd + g(q) + friction (7.42).
template <class Scalar, class SinCos>
void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau,
    const SinCos& sin_cos) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar ddp_o_2_x = Scalar(9.81) * s_1 - qd_1 * qd_1;
  const Scalar ddp_o_2_y = Scalar(9.81) * c_1 + qdd_1;
  const Scalar domega_2_z = qdd_1 + qdd_2;
  const Scalar N_2_z = Scalar(22.5) * domega_2_z -
      Scalar(25.0) * (s_2 * ddp_o_2_x - c_2 * ddp_o_2_y);
  const Scalar omega_2_z = qd_1 + qd_2;
  const Scalar t1 = s_2 * omega_2_z * omega_2_z - c_2 * domega_2_z;
  tau[0] = qdd_2 + N_2_z - Scalar(25.0) * t1 + Scalar(784.8) * c_1 + Scalar(177.51) * qdd_1;
  tau[1] = qdd_1 + N_2_z + Scalar(100.0) * qdd_2;
}

// Gravity torques g(q) (7.39).
template <class Scalar, class SinCos>
void gravity(const Scalar* q, Scalar* g, const SinCos& sin_cos) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar hu_2_t_x = Scalar(-245.25) * (s_1 * s_2 - c_1 * c_2);
  g[1] = hu_2_t_x;
  g[0] = hu_2_t_x + Scalar(784.8) * c_1;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
template <class Scalar, class SinCos>
bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd,
    const SinCos& sin_cos) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar tau_1 = tau[0], tau_2 = tau[1];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar ddp_o_2_x = Scalar(9.81) * s_1 - qd_1 * qd_1;
  const Scalar t1 = Scalar(25.0) * s_2;
  const Scalar t2 = ddp_o_2_x * t1 - Scalar(245.25) * c_1 * c_2;
  const Scalar t3 = tau_2 + t2;
  const Scalar mu_2_1_z = Scalar(25.0) * c_2 + Scalar(23.5);
  const Scalar t4 = Scalar(0.00816326530612245) * mu_2_1_z;
  const Scalar omega_2_z = qd_1 + qd_2;
  const Scalar t5 = t4 * t3 - tau_1 - t2 - omega_2_z * omega_2_z * t1 + Scalar(784.8) * c_1;
  const Scalar b_2_1_1 = Scalar(50.0) * c_2 - mu_2_1_z * t4 + Scalar(200.01);
  const Scalar t6 = t5 / b_2_1_1;
  qdd[0] = -t6;
  qdd[1] = t4 * t6 + Scalar(0.00816326530612245) * t3;
  bool positive = b_2_1_1 > Scalar(0.0);
  return positive;
}

// What depends on positions only and is needed more than once.
//   q[2]  in  joint positions, rad or m
// Reads q[0..1]. Operations: 0 mul, 0 add, 4 sin/cos.
template <class Scalar, class SinCos>
Configuration<Scalar> at(const Scalar* q, const SinCos& sin_cos) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  Configuration<Scalar> stage;
  stage.c_1 = c_1;
  stage.s_1 = s_1;
  stage.c_2 = c_2;
  stage.s_2 = s_2;
  return stage;
}

// Gravity torques g(q) (7.39).
//   g[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads what is stored. Operations: 4 mul, 2 add.
template <class Scalar>
void Configuration<Scalar>::gravity(Scalar* g) const noexcept {
  const Scalar hu_2_t_x = Scalar(-245.25) * (s_1 * s_2 - c_1 * c_2);
  g[1] = hu_2_t_x;
  g[0] = hu_2_t_x + Scalar(784.8) * c_1;
}

// What depends on velocities, too, and is needed more than once.
//   qd[2]  in  joint velocities, rad/s or m/s
// Reads qd[0..1] and what is stored. Operations: 5 mul, 2 add.
template <class Scalar>
Motion<Scalar> Configuration<Scalar>::with(const Scalar* qd) const noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  Motion<Scalar> stage;
  stage.c_1 = c_1;
  stage.c_2 = c_2;
  const Scalar omega_2_z = qd_1 + qd_2;
  stage.v2 = s_2 * omega_2_z * omega_2_z;
  const Scalar ddp_o_2_x = Scalar(9.81) * s_1 - qd_1 * qd_1;
  stage.v1 = s_2 * ddp_o_2_x;
  return stage;
}

// tau = B(q) qdd + C(q, qd) qd + g(q) + friction (7.42).
//   qdd[2]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads qdd[0..1] and what is stored. Operations: 9 mul, 11 add.
template <class Scalar>
void Motion<Scalar>::inverse_dynamics(const Scalar* qdd, Scalar* tau) const noexcept {
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1];
  const Scalar ddp_o_2_y = qdd_1 + Scalar(9.81) * c_1;
  const Scalar domega_2_z = qdd_1 + qdd_2;
  const Scalar N_2_z = Scalar(22.5) * domega_2_z - Scalar(25.0) * (v1 - c_2 * ddp_o_2_y);
  tau[0] = qdd_2 + N_2_z - Scalar(25.0) * (v2 - c_2 * domega_2_z) + Scalar(784.8) * c_1 +
      Scalar(177.51) * qdd_1;
  tau[1] = qdd_1 + N_2_z + Scalar(100.0) * qdd_2;
}

template <class Scalar>
bool rounding_is_as_written() noexcept {
  constexpr bool is_float = sizeof(Scalar) == sizeof(float);
  const volatile Scalar a = Scalar(0.1), b = Scalar(0.7), one = Scalar(1.0), tiny = Scalar(1e-17),
      nine = Scalar(9.0), seven = Scalar(7.0), half = Scalar(0.5),
      half_a_place = is_float ? Scalar(0x1.001p-24) : Scalar(0x1.001p-53),  // and a little more
      smallest = is_float ? Scalar(0x1p-126) : Scalar(0x1p-1022);
  const volatile Scalar product = a * b, quotient = nine / seven, next = one + half_a_place;
  const Scalar x = one, y = tiny;
  const auto is_zero = [](Scalar r) { return !(r < Scalar(0.0)) && !(r > Scalar(0.0)); };
  return is_zero(a * b - product)                   // no fused multiply-add, no digits too many
         && next > one                              // no digits too few, rounded only once
         && is_zero((x + y) - x)                    // no other order, no rounding upward
         && is_zero((x - y) - x)                    // or downward
         && is_zero(nine / Scalar(7.0) - quotient)  // no reciprocal
         && smallest * half > Scalar(0.0);          // nothing is flushed to zero
}

// What example_7_2_pair.hpp lists.
template void inverse_dynamics(const double* q, const double* qd, const double* qdd, double* tau,
    const LibrarySinCos& sin_cos);
template void inverse_dynamics(const double* q, const double* qd, const double* qdd, double* tau,
    const GivenSinCos<double>& sin_cos);
template void inverse_dynamics(const float* q, const float* qd, const float* qdd, float* tau,
    const LibrarySinCos& sin_cos);
template void inverse_dynamics(const float* q, const float* qd, const float* qdd, float* tau,
    const GivenSinCos<float>& sin_cos);
template void gravity(const double* q, double* g, const LibrarySinCos& sin_cos);
template void gravity(const double* q, double* g, const GivenSinCos<double>& sin_cos);
template void gravity(const float* q, float* g, const LibrarySinCos& sin_cos);
template void gravity(const float* q, float* g, const GivenSinCos<float>& sin_cos);
template bool forward_dynamics(const double* q, const double* qd, const double* tau, double* qdd,
    const LibrarySinCos& sin_cos);
template bool forward_dynamics(const double* q, const double* qd, const double* tau, double* qdd,
    const GivenSinCos<double>& sin_cos);
template bool forward_dynamics(const float* q, const float* qd, const float* tau, float* qdd,
    const LibrarySinCos& sin_cos);
template bool forward_dynamics(const float* q, const float* qd, const float* tau, float* qdd,
    const GivenSinCos<float>& sin_cos);
template Configuration<double> at(const double* q, const LibrarySinCos& sin_cos);
template Configuration<double> at(const double* q, const GivenSinCos<double>& sin_cos);
template Configuration<float> at(const float* q, const LibrarySinCos& sin_cos);
template Configuration<float> at(const float* q, const GivenSinCos<float>& sin_cos);
template struct Configuration<double>;
template struct Motion<double>;
template struct Configuration<float>;
template struct Motion<float>;
template bool rounding_is_as_written<double>();
template bool rounding_is_as_written<float>();

}  // namespace example_7_2_pair

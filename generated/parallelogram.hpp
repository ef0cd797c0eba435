// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "parallelogram" as flat code: 2 joints.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Input: sha1:75ff637b4b68c3fd05c5017ad7330ca9c5539f47
//
//   index  joint     moves link  type      unit
//   0      theta_1   link_1      revolute  rad
//   1      theta_1b  link_1b     revolute  rad
//
// Gravity is (0, -g, 0) m/s^2 in the base frame. The tip belongs to link "link_3". Coupled joints,
// rad or m: theta_2 = -q[0] + q[1], theta_3 = q[0] - q[1] + pi; q, qd, qdd and tau are those of the
// joints above.
//
// Every function is a template over its scalar: float, double, or any type that is made from a
// double, has + - * / (also - of one), comparisons, and sin, cos where argument-dependent lookup
// finds them (or an argument that knows them, see LibrarySinCos). Arguments are plain arrays:
//
//   parallelogram::Parameters<> parameters = {};  // then set its members
//   double q[2] = {}, qd[2] = {}, qdd[2] = {}, tau[2];
//   parallelogram::inverse_dynamics(parameters, q, qd, qdd, tau);
//
// Entries come in the order of the table. Units are SI; "rad or m" goes by the type of the joint.
// Every entry of an output is written, zeros too. All inputs are read before anything is written:
// inputs may share memory with each other and with outputs, but outputs must not overlap each
// other. Nothing allocates, throws, or keeps state.
//
// Matrices come row by row. Eigen's lie column by column unless their type says Eigen::RowMajor:
// what is written to data() of others gets mixed up. flatdyn/eigen.hpp returns either kind.
//
// In the code, names count from 1 as in the textbook: q_1 is q[0], s_1 its sine, c_1 its cosine,
// s_2_3 the sine of the angle by which parallel joints 2 and 3 together turn. Of link i: omega_i
// and domega_i are its angular velocity and acceleration, ddp_i the acceleration of its frame's
// origin less gravity, f_i and mu_i the force and moment that it gets from the link before, hc_i
// and hu_i the first moment of all that its joint carries (in gravity() times the size of gravity);
// t1, t2, ... are parts of sums. A distance between joints may be the unit of length inside
// functions, though not of arguments.

#ifndef FLATDYN_PARALLELOGRAM_HPP_D0443AA5
#define FLATDYN_PARALLELOGRAM_HPP_D0443AA5

#include <cmath>

namespace parallelogram {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 2;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {"theta_1", "theta_1b"};

// What the robot file leaves open: an argument of every function. Units as in the file.
template <class Scalar = Real>
struct Parameters {
  Scalar g;  // m/s^2
  Scalar m_l1;  // kg
  Scalar l_1;  // m
  Scalar I_l1;  // kg m^2
  Scalar a_1;  // m
  Scalar m_l2;  // kg
  Scalar l_2;  // m
  Scalar I_l2;  // kg m^2
  Scalar a_1b;  // m
  Scalar m_l3;  // kg
  Scalar l_3;  // m
  Scalar I_l3;  // kg m^2
  Scalar m_l1b;  // kg
  Scalar l_1b;  // m
  Scalar I_l1b;  // kg m^2
};

namespace detail {

// Every function checks its scalar by these.
struct Interface {
  // Integers would cut off what follows the point. Classes know what they do.
  template <class Scalar>
  static constexpr bool has_fractions(int Scalar::*) noexcept {
    return true;
  }
  template <class Scalar>
  static constexpr bool has_fractions(...) noexcept {
    return Scalar(1.5) > Scalar(1.0);
  }
  // Scalars of flatdyn's runtime say which version of generated code they are for. Others fit.
  template <class Scalar>
  static constexpr bool fits(decltype(Scalar::flatdyn_interface)*) noexcept {
    return Scalar::flatdyn_interface == 1;
  }
  template <class Scalar>
  static constexpr bool fits(...) noexcept {
    return true;
  }
  template <class Scalar>
  static constexpr bool checked() noexcept {
    static_assert(has_fractions<Scalar>(nullptr),
        "integers cannot hold positions, velocities or torques: use arrays of double or float");
    static_assert(fits<Scalar>(nullptr),
        "this scalar is of another version of flatdyn's runtime than this generated code: generate "
        "it again, with the flatdyn that the runtime came with");
    return true;
  }
};

}  // namespace detail

// Joints by their indices.
template <int... joint>
struct Joints {
  static constexpr int flatdyn_interface = 1;  // flatdyn/trigonometry.hpp asks for it
};

// Where a function has its sines and cosines from: its last argument, called once with all joints
// that the function needs, to write s[joint] = sin(q[joint]) and c[joint] = cos(q[joint]).
// The default: sin and cos of <cmath>, or those that argument-dependent lookup finds.
struct LibrarySinCos {
  template <class Scalar, int... joint>
  void operator()(const Scalar* q, Joints<joint...>, Scalar* s, Scalar* c) const noexcept {
    using std::cos;
    using std::sin;
    ((s[joint] = sin(q[joint]), c[joint] = cos(q[joint])), ...);
  }
};

// Known to the caller (from resolvers, a CORDIC unit, a table): those of all joints, by index. The
// positions of these joints are not read then.
template <class Scalar>
struct GivenSinCos {
  const Scalar* sine;
  const Scalar* cosine;

  template <int... joint>
  void operator()(const Scalar*, Joints<joint...>, Scalar* s, Scalar* c) const noexcept {
    ((s[joint] = sine[joint], c[joint] = cosine[joint]), ...);
  }
};

// tau = B(q) qdd + C(q, qd) qd + g(q) + friction (7.42).
//   q[2]    in   joint positions, rad or m
//   qd[2]   in   joint velocities, rad/s or m/s
//   qdd[2]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..1], qd[0..1], qdd[0..1], parameters.g, parameters.m_l1, parameters.l_1,
// parameters.I_l1, parameters.a_1, parameters.m_l2, parameters.l_2, parameters.I_l2,
// parameters.a_1b, parameters.m_l3, parameters.l_3, parameters.I_l3, parameters.m_l1b,
// parameters.l_1b, parameters.I_l1b. Operations: 33 mul, 23 add, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics(const Parameters<Scalar>& parameters, const Scalar* q,
    const Scalar* qd, const Scalar* qdd, Scalar* tau, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1];
  const Scalar g = parameters.g, m_l1 = parameters.m_l1, l_1 = parameters.l_1,
      I_l1 = parameters.I_l1, a_1 = parameters.a_1, m_l2 = parameters.m_l2, l_2 = parameters.l_2,
      I_l2 = parameters.I_l2, a_1b = parameters.a_1b, m_l3 = parameters.m_l3, l_3 = parameters.l_3,
      I_l3 = parameters.I_l3, m_l1b = parameters.m_l1b, l_1b = parameters.l_1b,
      I_l1b = parameters.I_l1b;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = a_1b * m_l3;
  const Scalar t2 = m_l2 * l_2;
  const Scalar t3 = t1 + t2;
  const Scalar t4 = l_3 * t1 - a_1 * t3;
  const Scalar c_1m2 = s_1 * s_2 + c_1 * c_2;
  const Scalar t5 = c_1m2 * t4;
  const Scalar t6 = (s_1 * c_2 - c_1 * s_2) * t4;
  const Scalar t7 = m_l1b * l_1b;
  const Scalar b_2_2 = I_l2 + I_l1b + l_1b * t7 + a_1b * t1 + l_2 * t2;
  const Scalar t8 = g * c_2 * (t3 + t7);
  tau[1] = t8 - qdd_1 * t5 + qd_1 * qd_1 * t6 + qdd_2 * b_2_2;
  const Scalar t9 = a_1 * (m_l2 + m_l3);
  const Scalar t10 = m_l1 * l_1;
  const Scalar t11 = m_l3 * l_3;
  const Scalar t12 = (Scalar(2.0) * a_1 - l_3) * t11;
  const Scalar b_1_1 = I_l1 + I_l3 + l_1 * t10 + a_1 * t9 - t12;
  const Scalar t13 = g * c_1 * (t9 + (t10 - t11));
  tau[0] = t13 - qdd_2 * t5 - qd_2 * qd_2 * t6 + qdd_1 * b_1_1;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[2]    in   joint positions, rad or m
//   qd[2]   in   joint velocities, rad/s or m/s
//   qdd[2]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..1], qd[0..1], qdd[0..1], h_e[0..1], h_e[5], parameters.g, parameters.m_l1,
// parameters.l_1, parameters.I_l1, parameters.a_1, parameters.m_l2, parameters.l_2,
// parameters.I_l2, parameters.a_1b, parameters.m_l3, parameters.l_3, parameters.I_l3,
// parameters.m_l1b, parameters.l_1b, parameters.I_l1b. Operations: 62 mul, 39 add, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics_tip_force(const Parameters<Scalar>& parameters, const Scalar* q,
    const Scalar* qd, const Scalar* qdd, const Scalar* h_e, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1];
  const Scalar h_e_1 = h_e[0], h_e_2 = h_e[1], h_e_6 = h_e[5];
  const Scalar g = parameters.g, m_l1 = parameters.m_l1, l_1 = parameters.l_1,
      I_l1 = parameters.I_l1, a_1 = parameters.a_1, m_l2 = parameters.m_l2, l_2 = parameters.l_2,
      I_l2 = parameters.I_l2, a_1b = parameters.a_1b, m_l3 = parameters.m_l3, l_3 = parameters.l_3,
      I_l3 = parameters.I_l3, m_l1b = parameters.m_l1b, l_1b = parameters.l_1b,
      I_l1b = parameters.I_l1b;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = qd_1 * qd_1;
  const Scalar ddp_o_2_y = g - a_1 * (s_1 * t1 - c_1 * qdd_1);
  const Scalar t2 = qd_2 * qd_2;
  const Scalar t3 = s_2 * t2 - c_2 * qdd_2;
  const Scalar ddp_o_3_y = ddp_o_2_y - a_1b * t3;
  const Scalar t4 = s_2 * qdd_2 + c_2 * t2;
  const Scalar t5 = a_1 * (s_1 * qdd_1 + c_1 * t1);
  const Scalar t6 = a_1b * t4 + t5;
  const Scalar t7 = s_1 * t6 + c_1 * ddp_o_3_y;
  const Scalar t8 = s_1 * h_e_1 - c_1 * h_e_2 - m_l3 * (t7 - l_3 * qdd_1);
  const Scalar c_m1_2 = s_1 * s_2 + c_1 * c_2;
  const Scalar t9 = m_l3 * (s_1 * ddp_o_3_y - c_1 * t6 + l_3 * t1);
  const Scalar t10 = s_1 * h_e_2 + c_1 * h_e_1 + t9;
  const Scalar t11 = a_1b * ((s_1 * c_2 - c_1 * s_2) * t10 - c_m1_2 * t8);
  const Scalar t12 = m_l2 * l_2;
  const Scalar t13 = t12 * (s_2 * t5 + c_2 * ddp_o_2_y);
  const Scalar t14 = m_l1b * l_1b;
  const Scalar t15 = qdd_2 * (I_l2 + I_l1b + l_2 * t12 + l_1b * t14);
  tau[1] = g * c_2 * t14 + t13 + t11 + t15;
  const Scalar t16 = s_1 * (s_1 * t8 + c_1 * t10 - t4 * t12);
  const Scalar f_2_y = s_1 * t10 - c_1 * t8 - t3 * t12;
  const Scalar t17 = a_1 * (t16 - c_1 * f_2_y);
  const Scalar t18 = m_l3 * l_3;
  const Scalar t19 = a_1 * m_l2;
  const Scalar t20 = m_l1 * l_1;
  const Scalar I_1_zz = I_l1 + a_1 * t19 + l_1 * t20;
  const Scalar I_3_zz = I_l3 + l_3 * t18;
  const Scalar t21 = g * c_1 * (t19 + t20);
  tau[0] = t21 + h_e_6 - t7 * t18 - t17 + qdd_1 * (I_1_zz + I_3_zz);
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[4] = {
    1, 1,
    1, 1};

// Joint-space inertia matrix B(q) (7.32).
//   q[2]  in   joint positions, rad or m
//   B[4]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//              2 x 2, row by row: entry (i, j) is B[2 * i + j]
// Reads q[0..1], parameters.m_l1, parameters.l_1, parameters.I_l1, parameters.a_1, parameters.m_l2,
// parameters.l_2, parameters.I_l2, parameters.a_1b, parameters.m_l3, parameters.l_3,
// parameters.I_l3, parameters.m_l1b, parameters.l_1b, parameters.I_l1b. Operations: 18 mul, 13 add,
// 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inertia_matrix(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* B,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar m_l1 = parameters.m_l1, l_1 = parameters.l_1, I_l1 = parameters.I_l1,
      a_1 = parameters.a_1, m_l2 = parameters.m_l2, l_2 = parameters.l_2, I_l2 = parameters.I_l2,
      a_1b = parameters.a_1b, m_l3 = parameters.m_l3, l_3 = parameters.l_3, I_l3 = parameters.I_l3,
      m_l1b = parameters.m_l1b, l_1b = parameters.l_1b, I_l1b = parameters.I_l1b;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = m_l3 * l_3 * (Scalar(2.0) * a_1 - l_3);
  const Scalar t2 = a_1 * a_1 * (m_l2 + m_l3);
  B[0] = I_l1 + I_l3 + m_l1 * l_1 * l_1 + t2 - t1;
  const Scalar t3 = a_1b * m_l3;
  const Scalar t4 = m_l2 * l_2;
  B[3] = I_l2 + I_l1b + m_l1b * l_1b * l_1b + a_1b * t3 + l_2 * t4;
  const Scalar c_1m2 = s_1 * s_2 + c_1 * c_2;
  B[1] = B[2] = c_1m2 * (a_1 * t4 + (a_1 - l_3) * t3);
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[6] = {
    0, 0, 1,
    1, 0, 0};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[2]  in   joint positions, rad or m
//   c[6]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//              c_ijk = c_ikj is c[3 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads q[0..1], parameters.a_1, parameters.m_l2, parameters.l_2, parameters.a_1b, parameters.m_l3,
// parameters.l_3. Operations: 7 mul, 3 add, 4 sin/cos. Always zero: 4 of the 6 entries of c.
template <class Scalar, class SinCos = LibrarySinCos>
inline void christoffel(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* c,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar a_1 = parameters.a_1, m_l2 = parameters.m_l2, l_2 = parameters.l_2,
      a_1b = parameters.a_1b, m_l3 = parameters.m_l3, l_3 = parameters.l_3;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = a_1b * m_l3;
  const Scalar t2 = l_3 * t1 - a_1 * (t1 + m_l2 * l_2);
  const Scalar c_2_1_1 = (s_1 * c_2 - c_1 * s_2) * t2;
  c[3] = c_2_1_1;
  c[2] = -c_2_1_1;
  c[0] = c[1] = c[4] = c[5] = Scalar(0.0);
}

// The entries of C in coriolis_matrix that are not always zero.
inline constexpr bool coriolis_matrix_nonzero[4] = {
    0, 1,
    1, 0};

// C(q, qd) from the Christoffel symbols (7.44).
//   q[2]   in   joint positions, rad or m
//   qd[2]  in   joint velocities, rad/s or m/s
//   C[4]   out  c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric
//               2 x 2, row by row: entry (i, j) is C[2 * i + j]
// Reads q[0..1], qd[0..1], parameters.a_1, parameters.m_l2, parameters.l_2, parameters.a_1b,
// parameters.m_l3, parameters.l_3. Operations: 9 mul, 3 add, 4 sin/cos. Always zero: 2 of the 4
// entries of C.
template <class Scalar, class SinCos = LibrarySinCos>
inline void coriolis_matrix(const Parameters<Scalar>& parameters, const Scalar* q, const Scalar* qd,
    Scalar* C, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar a_1 = parameters.a_1, m_l2 = parameters.m_l2, l_2 = parameters.l_2,
      a_1b = parameters.a_1b, m_l3 = parameters.m_l3, l_3 = parameters.l_3;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = a_1b * m_l3;
  const Scalar t2 = l_3 * t1 - a_1 * (t1 + m_l2 * l_2);
  const Scalar t3 = (s_1 * c_2 - c_1 * s_2) * t2;
  C[2] = qd_1 * t3;
  C[1] = -qd_2 * t3;
  C[0] = C[3] = Scalar(0.0);
}

// Gravity torques g(q) (7.39).
//   q[2]  in   joint positions, rad or m
//   g[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..1], parameters.g, parameters.m_l1, parameters.l_1, parameters.a_1, parameters.m_l2,
// parameters.l_2, parameters.a_1b, parameters.m_l3, parameters.l_3, parameters.m_l1b,
// parameters.l_1b. Operations: 10 mul, 5 add, 2 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void gravity(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* g,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar g_2 = parameters.g, m_l1 = parameters.m_l1, l_1 = parameters.l_1,
      a_1 = parameters.a_1, m_l2 = parameters.m_l2, l_2 = parameters.l_2, a_1b = parameters.a_1b,
      m_l3 = parameters.m_l3, l_3 = parameters.l_3, m_l1b = parameters.m_l1b,
      l_1b = parameters.l_1b;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar c_1 = cosine[0], c_2 = cosine[1];
  g[1] = g_2 * c_2 * ((a_1b * m_l3 + m_l2 * l_2) + m_l1b * l_1b);
  const Scalar t1 = (m_l1 * l_1 + a_1 * (m_l2 + m_l3)) - m_l3 * l_3;
  g[0] = g_2 * c_1 * t1;
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[2]   in   joint positions, rad or m
//   qd[2]  in   joint velocities, rad/s or m/s
//   n[2]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..1], qd[0..1], parameters.g, parameters.m_l1, parameters.l_1, parameters.a_1,
// parameters.m_l2, parameters.l_2, parameters.a_1b, parameters.m_l3, parameters.l_3,
// parameters.m_l1b, parameters.l_1b. Operations: 19 mul, 9 add, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Parameters<Scalar>& parameters, const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar g = parameters.g, m_l1 = parameters.m_l1, l_1 = parameters.l_1, a_1 = parameters.a_1,
      m_l2 = parameters.m_l2, l_2 = parameters.l_2, a_1b = parameters.a_1b, m_l3 = parameters.m_l3,
      l_3 = parameters.l_3, m_l1b = parameters.m_l1b, l_1b = parameters.l_1b;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = a_1 * m_l2;
  const Scalar t2 = a_1 - l_3;
  const Scalar t3 = a_1b * m_l3;
  const Scalar t4 = (s_1 * c_2 - c_1 * s_2) * (l_2 * t1 + t2 * t3);
  const Scalar t5 = g * c_1 * ((t1 + m_l1 * l_1) + m_l3 * t2);
  n[0] = t5 + qd_2 * qd_2 * t4;
  const Scalar t6 = g * c_2 * ((t3 + m_l2 * l_2) + m_l1b * l_1b);
  n[1] = t6 - qd_1 * qd_1 * t4;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[2]    in   joint positions, rad or m
//   qd[2]   in   joint velocities, rad/s or m/s
//   tau[2]  in   joint torques or forces, N m or N
//   qdd[2]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[0..1], qd[0..1], tau[0..1], parameters.g, parameters.m_l1, parameters.l_1,
// parameters.I_l1, parameters.a_1, parameters.m_l2, parameters.l_2, parameters.I_l2,
// parameters.a_1b, parameters.m_l3, parameters.l_3, parameters.I_l3, parameters.m_l1b,
// parameters.l_1b, parameters.I_l1b. Operations: 54 mul, 38 add, 2 div, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Parameters<Scalar>& parameters, const Scalar* q,
    const Scalar* qd, const Scalar* tau, Scalar* qdd, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar tau_1 = tau[0], tau_2 = tau[1];
  const Scalar g = parameters.g, m_l1 = parameters.m_l1, l_1 = parameters.l_1,
      I_l1 = parameters.I_l1, a_1 = parameters.a_1, m_l2 = parameters.m_l2, l_2 = parameters.l_2,
      I_l2 = parameters.I_l2, a_1b = parameters.a_1b, m_l3 = parameters.m_l3, l_3 = parameters.l_3,
      I_l3 = parameters.I_l3, m_l1b = parameters.m_l1b, l_1b = parameters.l_1b,
      I_l1b = parameters.I_l1b;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = qd_1 * a_1 * qd_1;
  const Scalar ddp_o_2_y = g - s_1 * t1;
  const Scalar t2 = qd_2 * a_1b * qd_2;
  const Scalar ddp_o_3_y = ddp_o_2_y - s_2 * t2;
  const Scalar t3 = c_1 * t1;
  const Scalar t4 = m_l3 * l_3;
  const Scalar t5 = t4 * (c_1 * ddp_o_3_y + s_1 * (t3 + c_2 * t2));
  const Scalar t6 = m_l2 * l_2;
  const Scalar t7 = a_1b * m_l3;
  const Scalar t8 = t6 + t7;
  const Scalar t9 = c_1 * t4 - c_2 * t8;
  const Scalar t10 = s_1 * t4 - s_2 * t8;
  const Scalar qd_3 = qd_1 - qd_2;
  const Scalar beta_3_f = qd_1 + qd_2;
  const Scalar t11 = (s_1 * c_2 - c_1 * s_2) * qd_3 * beta_3_f;
  const Scalar t12 = a_1b * t4;
  const Scalar t13 = t12 * t11;
  const Scalar t14 = t9 * ddp_o_2_y + t10 * t3 - t13 - t5;
  const Scalar t15 = m_l1b * l_1b;
  const Scalar t16 = tau_2 - g * c_2 * t15 + t14;
  const Scalar c_m1_2 = c_1 * c_2 + s_1 * s_2;
  const Scalar t17 = a_1 * t4;
  const Scalar t18 = (c_m1_2 * t12 - t17) + a_1 * (s_1 * t10 + c_1 * t9);
  const Scalar b_2_2q = I_l2 + I_l1b + l_2 * t6 + a_1b * t7 + l_1b * t15;
  const Scalar d_2 = Scalar(1.0) / b_2_2q;
  const Scalar t19 = t18 * d_2;
  const Scalar t20 = a_1 * (m_l2 + m_l3);
  const Scalar t21 = m_l1 * l_1;
  const Scalar t22 = g * (t9 - c_1 * (t21 + t20));
  const Scalar t23 = t22 + tau_1 - t13 - t14 + t19 * t16 + a_1 * t8 * t11;
  const Scalar b_2_1_1 = I_l1 + I_l3 + l_3 * t4 + l_1 * t21 - t18 * t19 + a_1 * t20 -
      Scalar(2.0) * t17;
  const Scalar qdd_1 = t23 / b_2_1_1;
  qdd[0] = qdd_1;
  qdd[1] = d_2 * (t16 + t18 * qdd_1);
  bool positive = b_2_1_1 > Scalar(0.0);
  positive &= b_2_2q > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[2]   in  joint positions, rad or m
//   qd[2]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[0..1], qd[0..1], parameters.m_l1, parameters.l_1, parameters.I_l1, parameters.a_1,
// parameters.m_l2, parameters.l_2, parameters.I_l2, parameters.a_1b, parameters.m_l3,
// parameters.l_3, parameters.I_l3, parameters.m_l1b, parameters.l_1b, parameters.I_l1b. Operations:
// 25 mul, 15 add, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar kinetic_energy(const Parameters<Scalar>& parameters, const Scalar* q,
    const Scalar* qd, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar m_l1 = parameters.m_l1, l_1 = parameters.l_1, I_l1 = parameters.I_l1,
      a_1 = parameters.a_1, m_l2 = parameters.m_l2, l_2 = parameters.l_2, I_l2 = parameters.I_l2,
      a_1b = parameters.a_1b, m_l3 = parameters.m_l3, l_3 = parameters.l_3, I_l3 = parameters.I_l3,
      m_l1b = parameters.m_l1b, l_1b = parameters.l_1b, I_l1b = parameters.I_l1b;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = a_1b * m_l3;
  const Scalar t2 = m_l2 * l_2;
  const Scalar b_2_2 = I_l2 + I_l1b + m_l1b * l_1b * l_1b + a_1b * t1 + l_2 * t2;
  const Scalar c_1m2 = s_1 * s_2 + c_1 * c_2;
  const Scalar t3 = qd_1 * c_1m2 * (a_1 * t2 + (a_1 - l_3) * t1);
  const Scalar t4 = qd_2 * (Scalar(0.5) * qd_2 * b_2_2 + t3);
  const Scalar t5 = m_l3 * l_3 * (Scalar(2.0) * a_1 - l_3);
  const Scalar t6 = a_1 * a_1 * (m_l2 + m_l3);
  const Scalar b_1_1 = I_l1 + I_l3 + m_l1 * l_1 * l_1 + t6 - t5;
  return Scalar(0.5) * qd_1 * qd_1 * b_1_1 + t4;
}

// Potential energy of links and rotors (7.36).
//   q[2]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[0..1], parameters.g, parameters.m_l1, parameters.l_1, parameters.a_1, parameters.m_l2,
// parameters.l_2, parameters.a_1b, parameters.m_l3, parameters.l_3, parameters.m_l1b,
// parameters.l_1b. Operations: 10 mul, 6 add, 2 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar potential_energy(const Parameters<Scalar>& parameters, const Scalar* q,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar g = parameters.g, m_l1 = parameters.m_l1, l_1 = parameters.l_1, a_1 = parameters.a_1,
      m_l2 = parameters.m_l2, l_2 = parameters.l_2, a_1b = parameters.a_1b, m_l3 = parameters.m_l3,
      l_3 = parameters.l_3, m_l1b = parameters.m_l1b, l_1b = parameters.l_1b;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], s_2 = sine[1];
  const Scalar t1 = s_1 * (m_l1 * l_1 + m_l3 * (a_1 - l_3));
  const Scalar t2 = s_2 * (a_1b * m_l3 + m_l1b * l_1b);
  const Scalar hc_0_y = t2 + m_l2 * (a_1 * s_1 + l_2 * s_2) + t1;
  return g * hc_0_y;
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    1, 1, 0,
    1, 1, 0,
    0, 0, 1};

// Pose of the tip (2.50).
//   q[2]  in   joint positions, rad or m
//   R[9]  out  rotation matrix of the frame in the base frame
//              3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]  out  position of the frame's origin in the base frame, m
// Reads q[0..1], parameters.a_1, parameters.a_1b. Operations: 14 mul, 6 add, 4 sin/cos. Always
// zero: 4 of the 9 entries of R. Always zero: p[2].
template <class Scalar, class SinCos = LibrarySinCos>
inline void forward_kinematics(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* R,
    Scalar* p, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar a_1 = parameters.a_1, a_1b = parameters.a_1b;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = s_1 * c_2 - c_1 * s_2;
  const Scalar c_m1_2 = s_1 * s_2 + c_1 * c_2;
  const Scalar t2 = t1 * t1 + c_m1_2 * c_m1_2;
  const Scalar s_1_t_x = s_1 * t2;
  R[1] = s_1_t_x;
  R[0] = R[4] = -c_1 * t2;
  R[3] = -s_1_t_x;
  const Scalar p_2_x = a_1b * c_m1_2 + a_1;
  const Scalar t3 = a_1b * t1;
  p[0] = s_1 * t3 + c_1 * p_2_x;
  p[1] = s_1 * p_2_x - c_1 * t3;
  R[8] = Scalar(1.0);
  R[2] = R[5] = R[6] = R[7] = p[2] = Scalar(0.0);
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[12] = {
    1, 1,
    1, 1,
    0, 0,
    0, 0,
    0, 0,
    1, 0};

// Geometric Jacobian of the tip (7.14), (7.15).
//   q[2]   in   joint positions, rad or m
//   J[12]  out  geometric Jacobian in base axes: linear rows, then angular
//               6 x 2, row by row: entry (i, j) is J[2 * i + j]
// Reads q[0..1], parameters.a_1, parameters.a_1b. Operations: 12 mul, 4 add, 4 sin/cos. Always
// zero: 7 of the 12 entries of J.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* J,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar a_1 = parameters.a_1, a_1b = parameters.a_1b;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  J[2] = a_1 * c_1;
  J[0] = -a_1 * s_1;
  const Scalar t1 = s_1 * c_2 - c_1 * s_2;
  const Scalar c_m1_2 = s_1 * s_2 + c_1 * c_2;
  const Scalar R_20_x = s_1 * t1 + c_1 * c_m1_2;
  J[3] = a_1b * R_20_x;
  const Scalar R_21_x = s_1 * c_m1_2 - c_1 * t1;
  J[1] = -a_1b * R_21_x;
  J[10] = Scalar(1.0);
  J[4] = J[5] = J[6] = J[7] = J[8] = J[9] = J[11] = Scalar(0.0);
}

// (dJ/dt) qd of the tip.
//   q[2]   in   joint positions, rad or m
//   qd[2]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads q[0..1], qd[0..1], parameters.a_1, parameters.a_1b. Operations: 23 mul, 10 add, 4 sin/cos.
// Always zero: a[2], a[3], a[4], a[5].
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian_dot_qd(const Parameters<Scalar>& parameters, const Scalar* q, const Scalar* qd,
    Scalar* a, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar a_1 = parameters.a_1, a_1b = parameters.a_1b;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar c_m1_2 = s_1 * s_2 + c_1 * c_2;
  const Scalar t1 = qd_1 * a_1 * qd_1;
  const Scalar t2 = qd_2 * a_1b * qd_2;
  const Scalar t3 = s_1 * c_2 - c_1 * s_2;
  const Scalar t4 = t3 * t3;
  const Scalar ddp_3_x = t1 * t4 + c_m1_2 * (c_m1_2 * t1 + t2);
  const Scalar t5 = t2 * t4 + c_m1_2 * ddp_3_x;
  const Scalar t6 = ddp_3_x - c_m1_2 * t2;
  const Scalar t7 = t3 * (t5 - c_m1_2 * t6);
  const Scalar t8 = t4 * t6 + c_m1_2 * t5;
  a[0] = -s_1 * t7 - c_1 * t8;
  a[1] = c_1 * t7 - s_1 * t8;
  a[2] = a[3] = a[4] = a[5] = Scalar(0.0);
}

// The functions by type, with the shapes of their arguments: what adapters such as
// flatdyn/eigen.hpp are given.
namespace functions {

struct inverse_dynamics {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], const Scalar (&qd)[2],
      const Scalar (&qdd)[2], Scalar (&tau)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::parallelogram::inverse_dynamics(of...); }
};

struct inverse_dynamics_tip_force {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], const Scalar (&qd)[2],
      const Scalar (&qdd)[2], const Scalar (&h_e)[6], Scalar (&tau)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept {
    return ::parallelogram::inverse_dynamics_tip_force(of...);
  }
};

struct inertia_matrix {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], Scalar (&B)[2][2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::parallelogram::inertia_matrix(of...); }
};

struct christoffel {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], Scalar (&c)[2][3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::parallelogram::christoffel(of...); }
};

struct coriolis_matrix {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], const Scalar (&qd)[2],
      Scalar (&C)[2][2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::parallelogram::coriolis_matrix(of...); }
};

struct gravity {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], Scalar (&g)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::parallelogram::gravity(of...); }
};

struct bias {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], const Scalar (&qd)[2],
      Scalar (&n)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::parallelogram::bias(of...); }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[2], const Scalar (&qd)[2],
      const Scalar (&tau)[2], Scalar (&qdd)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::parallelogram::forward_dynamics(of...); }
};

struct kinetic_energy {
  template <class Scalar>
  using Shape = Scalar(const Parameters<Scalar>&, const Scalar (&q)[2], const Scalar (&qd)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::parallelogram::kinetic_energy(of...); }
};

struct potential_energy {
  template <class Scalar>
  using Shape = Scalar(const Parameters<Scalar>&, const Scalar (&q)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::parallelogram::potential_energy(of...); }
};

struct forward_kinematics {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], Scalar (&R)[3][3],
      Scalar (&p)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::parallelogram::forward_kinematics(of...); }
};

struct jacobian {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], Scalar (&J)[6][2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::parallelogram::jacobian(of...); }
};

struct jacobian_dot_qd {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], const Scalar (&qd)[2],
      Scalar (&a)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::parallelogram::jacobian_dot_qd(of...); }
};

}  // namespace functions

// Whether the build rounds every operation as it is written, to nearest: compilers fuse products
// into sums unless they are given -ffp-contract=off, and -ffast-math or x87 registers change more.
// What certificates say of rounding errors holds for builds in which this is true. It speaks of the
// file that calls it, for float and double.
template <class Scalar = Real>
static bool rounding_is_as_written() noexcept {
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

}  // namespace parallelogram

#endif  // FLATDYN_PARALLELOGRAM_HPP_D0443AA5

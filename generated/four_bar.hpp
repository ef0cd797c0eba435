// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "four_bar" as flat code: 3 joints, 1 of them independent.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Input: sha1:9eaeed02d17ac239f10df03efc02c062c8420ac9
//
//   q  qd  joint    moves link  type      unit
//   0  0   theta_1  crank       revolute  rad
//   1  -   theta_2  coupler     revolute  rad
//   2  -   theta_3  rocker      revolute  rad
//
// Gravity is (0, -g, 0) m/s^2 in the base frame. The tip belongs to link "coupler". Closed loops
// make theta_2, theta_3 follow from the other joints: q has the positions of all of them, qd, qdd
// and tau are those of the others. Functions hold where q closes the loops. Names with lk belong to
// loop k: R_lk, p_lk and r_lk to the way from its carrier to its two ends, Phi_lk to its closure's
// derivative by q, inv_lk is the reciprocal of the determinant that its joints are found with, and
// regular_lk is positive unless the loop is singular. A_i_j is how joint i moves with the joint of
// qd[j - 1], drift how it accelerates if that one does not.
//
// Every function is a template over its scalar: float, double, or any type that is made from a
// double, has + - * / (also - of one), comparisons, and sin, cos where argument-dependent lookup
// finds them (or an argument that knows them, see LibrarySinCos). Arguments are plain arrays:
//
//   four_bar::Parameters<> parameters = {};  // then set its members
//   double q[3] = {}, qd[1] = {}, qdd[1] = {}, tau[1];
//   const bool result = four_bar::inverse_dynamics(parameters, q, qd, qdd, tau);
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

#ifndef FLATDYN_FOUR_BAR_HPP_7D0B404B
#define FLATDYN_FOUR_BAR_HPP_7D0B404B

#include <cmath>

namespace four_bar {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 1;
inline constexpr int position_count = 3;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {"theta_1"};

// The joints of q.
inline constexpr const char* position_names[position_count] = {"theta_1", "theta_2", "theta_3"};

// The entries of q that qd, qdd and tau belong to.
inline constexpr int independent_positions[joint_count] = {0};

// What the robot file leaves open: an argument of every function. Units as in the file.
template <class Scalar = Real>
struct Parameters {
  Scalar g;  // m/s^2
  Scalar m_1;  // kg
  Scalar l_1;  // m
  Scalar I_1;  // kg m^2
  Scalar a;  // m
  Scalar m_2;  // kg
  Scalar l_2;  // m
  Scalar h_2;  // m
  Scalar I_2;  // kg m^2
  Scalar d;  // m
  Scalar m_3;  // kg
  Scalar l_3;  // m
  Scalar I_3;  // kg m^2
  Scalar b;  // m
  Scalar c;  // m
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
//   q[3]    in   joint positions, rad or m
//   qd[1]   in   joint velocities, rad/s or m/s
//   qdd[1]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[1]  out  joint torques, N m (forces, N, for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..2], qd[0], qdd[0], parameters.g, parameters.m_1, parameters.l_1, parameters.I_1,
// parameters.a, parameters.m_2, parameters.l_2, parameters.h_2, parameters.I_2, parameters.m_3,
// parameters.l_3, parameters.I_3, parameters.b, parameters.c. Operations: 72 mul, 34 add, 1 div, 6
// sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool inverse_dynamics(const Parameters<Scalar>& parameters, const Scalar* q,
    const Scalar* qd, const Scalar* qdd, Scalar* tau, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar qdd_1 = qdd[0];
  const Scalar g = parameters.g, m_1 = parameters.m_1, l_1 = parameters.l_1, I_1 = parameters.I_1,
      a = parameters.a, m_2 = parameters.m_2, l_2 = parameters.l_2, h_2 = parameters.h_2,
      I_2 = parameters.I_2, m_3 = parameters.m_3, l_3 = parameters.l_3, I_3 = parameters.I_3,
      b = parameters.b, c = parameters.c;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t1 = s_1 * s_2 - c_1 * c_2;
  const Scalar t2 = c_3 * R_l1a21_x + s_3 * t1;
  const Scalar t3 = b * c;
  const Scalar t4 = Scalar(1.0) / (t2 * t3);
  const Scalar t5 = b * t4;
  const Scalar t6 = b * R_l1a21_x;
  const Scalar t7 = a * s_1;
  const Scalar p_l1ae_y = t6 + t7;
  const Scalar t8 = b * t1;
  const Scalar t9 = a * c_1;
  const Scalar t10 = t8 - t9;
  const Scalar t11 = t1 * p_l1ae_y - R_l1a21_x * t10;
  const Scalar t12 = t11 * t5;
  const Scalar t13 = t12 * c * t12;
  const Scalar t14 = c * t4;
  const Scalar t15 = (c_3 * p_l1ae_y + s_3 * t10) * t14 - Scalar(1.0);
  const Scalar t16 = t15 * t15;
  const Scalar t17 = qd_1 * qd_1;
  const Scalar t18 = ((t9 - c_3 * t13) - t8 * t16) * t17;
  const Scalar t19 = ((t7 - s_3 * t13) + t6 * t16) * t17;
  const Scalar t20 = qdd_1 * t15 + t14 * (c_3 * t18 + s_3 * t19);
  const Scalar t21 = h_2 * s_2 - l_2 * c_2;
  const Scalar t22 = h_2 * c_2 + l_2 * s_2;
  const Scalar t23 = g * c_1;
  const Scalar ddp_o_2_y = t23 + a * qdd_1;
  const Scalar t24 = a * m_2 * (ddp_o_2_y - (t22 * t16 * t17 - t21 * t20));
  const Scalar I_2_zz = I_2 + m_2 * (l_2 * l_2 + h_2 * h_2);
  const Scalar t25 = m_2 * (t22 * (a * t17 - g * s_1) - t21 * ddp_o_2_y);
  const Scalar t26 = t15 * (I_2_zz * t20 - t25);
  const Scalar t27 = m_3 * l_3;
  const Scalar I_3_zz = I_3 + l_3 * t27;
  const Scalar t28 = I_3_zz * t5 * ((R_l1a21_x * t19 - t1 * t18) - t11 * qdd_1);
  const Scalar t29 = t12 * (t28 - g * c_3 * t27);
  const Scalar t30 = m_1 * l_1;
  const Scalar I_1_zz = I_1 + l_1 * t30;
  tau[0] = t23 * t30 + qdd_1 * I_1_zz + t24 - t29 + t26;
  bool positive = t3 * t3 * (t2 * t2 - Scalar(1e-12)) > Scalar(0.0);
  return positive;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[3]    in   joint positions, rad or m
//   qd[1]   in   joint velocities, rad/s or m/s
//   qdd[1]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[1]  out  joint torques, N m (forces, N, for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..2], qd[0], qdd[0], h_e[0..1], h_e[5], parameters.g, parameters.m_1, parameters.l_1,
// parameters.I_1, parameters.a, parameters.m_2, parameters.l_2, parameters.h_2, parameters.I_2,
// parameters.m_3, parameters.l_3, parameters.I_3, parameters.b, parameters.c. Operations: 81 mul,
// 46 add, 1 div, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool inverse_dynamics_tip_force(const Parameters<Scalar>& parameters, const Scalar* q,
    const Scalar* qd, const Scalar* qdd, const Scalar* h_e, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar qdd_1 = qdd[0];
  const Scalar h_e_1 = h_e[0], h_e_2 = h_e[1], h_e_6 = h_e[5];
  const Scalar g = parameters.g, m_1 = parameters.m_1, l_1 = parameters.l_1, I_1 = parameters.I_1,
      a = parameters.a, m_2 = parameters.m_2, l_2 = parameters.l_2, h_2 = parameters.h_2,
      I_2 = parameters.I_2, m_3 = parameters.m_3, l_3 = parameters.l_3, I_3 = parameters.I_3,
      b = parameters.b, c = parameters.c;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  const Scalar s_1_2 = s_1 * c_2 + c_1 * s_2;
  const Scalar t1 = b * s_1_2;
  const Scalar t2 = c * c_3;
  const Scalar t3 = s_1 * s_2 - c_1 * c_2;
  const Scalar t4 = b * t3;
  const Scalar t5 = c * s_3;
  const Scalar t6 = t1 * t2 + t4 * t5;
  const Scalar t7 = Scalar(1.0) / t6;
  const Scalar t8 = a * s_1;
  const Scalar p_l1ae_y = t1 + t8;
  const Scalar t9 = a * c_1;
  const Scalar t10 = t4 - t9;
  const Scalar t11 = t7 * (p_l1ae_y * t2 + t10 * t5);
  const Scalar omega_l2_z = qd_1 - qd_1 * t11;
  const Scalar t12 = omega_l2_z * omega_l2_z;
  const Scalar t13 = t7 * (t4 * p_l1ae_y - t10 * t1);
  const Scalar t14 = qd_1 * qd_1;
  const Scalar t15 = t13 * t13 * t14;
  const Scalar t16 = t8 * t14;
  const Scalar t17 = t5 * t15 - t16 - t1 * t12;
  const Scalar t18 = t9 * t14;
  const Scalar t19 = t2 * t15 - t18 + t4 * t12;
  const Scalar t20 = m_3 * l_3;
  const Scalar I_3_zz = I_3 + l_3 * t20;
  const Scalar t21 = (qdd_1 * t13 + t7 * (t1 * t17 - t4 * t19)) * I_3_zz;
  const Scalar t22 = t13 * (g * c_3 * t20 + t21);
  const Scalar domega_2_z = qdd_1 - qdd_1 * t11 + t7 * (t2 * t19 + t5 * t17);
  const Scalar t23 = m_2 * l_2;
  const Scalar t24 = m_2 * h_2;
  const Scalar I_2_zz = I_2 + l_2 * t23 + h_2 * t24;
  const Scalar t25 = t18 + t8 * qdd_1;
  const Scalar ddp_o_2_y = g - t16 + t9 * qdd_1;
  const Scalar ddp_2_y = s_1_2 * t25 - t3 * ddp_o_2_y;
  const Scalar t26 = s_1_2 * ddp_o_2_y + t3 * t25;
  const Scalar t27 = s_1_2 * h_e_1 + t3 * h_e_2;
  const Scalar mu_2_z = h_e_6 - b * t27 + ddp_2_y * t23 - t26 * t24 + domega_2_z * I_2_zz;
  const Scalar t28 = t3 * h_e_1 - s_1_2 * h_e_2 - m_2 * t26 + t12 * t23 + domega_2_z * t24;
  const Scalar t29 = t27 - m_2 * ddp_2_y + t12 * t24 - domega_2_z * t23;
  const Scalar t30 = m_1 * l_1;
  const Scalar I_1_zz = I_1 + l_1 * t30;
  tau[0] = g * c_1 * t30 + I_1_zz * qdd_1 - a * s_2 * t28 - a * c_2 * t29 + mu_2_z + t22 -
      t11 * mu_2_z;
  const Scalar t31 = b * c;
  bool positive = t6 * t6 - Scalar(1e-12) * t31 * t31 > Scalar(0.0);
  return positive;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[1] = {
    1};

// Joint-space inertia matrix B(q) (7.32).
//   q[3]  in   joint positions, rad or m
//   B[1]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//              1 x 1, row by row: entry (i, j) is B[1 * i + j]
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..2], parameters.m_1, parameters.l_1, parameters.I_1, parameters.a, parameters.m_2,
// parameters.l_2, parameters.h_2, parameters.I_2, parameters.m_3, parameters.l_3, parameters.I_3,
// parameters.b, parameters.c. Operations: 41 mul, 21 add, 1 div, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool inertia_matrix(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* B,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar m_1 = parameters.m_1, l_1 = parameters.l_1, I_1 = parameters.I_1, a = parameters.a,
      m_2 = parameters.m_2, l_2 = parameters.l_2, h_2 = parameters.h_2, I_2 = parameters.I_2,
      m_3 = parameters.m_3, l_3 = parameters.l_3, I_3 = parameters.I_3, b = parameters.b,
      c = parameters.c;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar p_l1ae_y = b * R_l1a21_x + a * s_1;
  const Scalar t1 = s_1 * s_2 - c_1 * c_2;
  const Scalar t2 = b * t1 - a * c_1;
  const Scalar t3 = c * (c_3 * p_l1ae_y + s_3 * t2);
  const Scalar t4 = b * c;
  const Scalar t5 = (c_3 * R_l1a21_x + s_3 * t1) * t4;
  const Scalar t6 = Scalar(1.0) / t5;
  const Scalar Ic_2_zz = I_2 + m_2 * (l_2 * l_2 + h_2 * h_2);
  const Scalar t7 = a * m_2;
  const Scalar t8 = (h_2 * s_2 - l_2 * c_2) * t7;
  const Scalar mu_2_1_z = Ic_2_zz - t8;
  const Scalar b_1_2h = mu_2_1_z - Ic_2_zz * t6 * t3;
  const Scalar t9 = b * (t1 * p_l1ae_y - R_l1a21_x * t2);
  const Scalar Ic_3_zz = I_3 + m_3 * l_3 * l_3;
  const Scalar t10 = t6 * (Ic_3_zz * t6 * t9 * t9 - t3 * (mu_2_1_z + b_1_2h));
  B[0] = I_1 + Ic_2_zz - Scalar(2.0) * t8 + a * t7 + m_1 * l_1 * l_1 + t10;
  bool positive = t5 * t5 - Scalar(1e-12) * t4 * t4 > Scalar(0.0);
  return positive;
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[1] = {
    1};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[3]  in   joint positions, rad or m
//   c[1]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//              c_ijk = c_ikj is c[1 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..2], parameters.a, parameters.m_2, parameters.l_2, parameters.h_2, parameters.I_2,
// parameters.m_3, parameters.l_3, parameters.I_3, parameters.b, parameters.c. Operations: 52 mul,
// 25 add, 1 div, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool christoffel(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* c,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar a = parameters.a, m_2 = parameters.m_2, l_2 = parameters.l_2, h_2 = parameters.h_2,
      I_2 = parameters.I_2, m_3 = parameters.m_3, l_3 = parameters.l_3, I_3 = parameters.I_3,
      b = parameters.b, c_2 = parameters.c;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  const Scalar t1 = b * (c_1 * c_2_2 - s_1 * s_2);
  const Scalar t2 = c_2 * s_3;
  const Scalar R_l1a21_x = c_1 * s_2 + s_1 * c_2_2;
  const Scalar t3 = b * R_l1a21_x;
  const Scalar t4 = c_2 * c_3;
  const Scalar t5 = t1 * t2 - t3 * t4;
  const Scalar t6 = Scalar(1.0) / t5;
  const Scalar t7 = a * c_1;
  const Scalar t8 = t7 + t1;
  const Scalar t9 = a * s_1;
  const Scalar p_l1ae_y = t9 + t3;
  const Scalar t10 = t6 * (t8 * t2 - p_l1ae_y * t4);
  const Scalar t11 = t10 - Scalar(1.0);
  const Scalar t12 = t11 * t11;
  const Scalar t13 = t6 * (t8 * t3 - t1 * p_l1ae_y);
  const Scalar t14 = t13 * t13;
  const Scalar H_1_1r1_2 = t9 - t2 * t14 + t3 * t12;
  const Scalar H_1_1r1_1 = t7 - t4 * t14 + t1 * t12;
  const Scalar t15 = m_2 * h_2;
  const Scalar t16 = m_2 * l_2;
  const Scalar I_2_zz = I_2 + h_2 * t15 + l_2 * t16;
  const Scalar mu_2_1_z = a * (c_2_2 * t16 - s_2 * t15) + I_2_zz;
  const Scalar b_1_2h = mu_2_1_z - I_2_zz * t10;
  const Scalar t17 = t6 * b_1_2h * (t2 * H_1_1r1_2 + t4 * H_1_1r1_1);
  const Scalar I_3_zz = I_3 + m_3 * l_3 * l_3;
  const Scalar t18 = I_3_zz * t6 * t13 * (t1 * H_1_1r1_1 + t3 * H_1_1r1_2);
  const Scalar mr_2_y = s_2 * t16 + c_2_2 * t15;
  const Scalar t19 = t10 * a * mr_2_y;
  c[0] = t19 - t10 * t19 - t18 + t17;
  const Scalar t20 = b * c_2;
  bool positive = t5 * t5 - Scalar(1e-12) * t20 * t20 > Scalar(0.0);
  return positive;
}

// The entries of C in coriolis_matrix that are not always zero.
inline constexpr bool coriolis_matrix_nonzero[1] = {
    1};

// C(q, qd) from the Christoffel symbols (7.44).
//   q[3]   in   joint positions, rad or m
//   qd[1]  in   joint velocities, rad/s or m/s
//   C[1]   out  c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric
//               1 x 1, row by row: entry (i, j) is C[1 * i + j]
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..2], qd[0], parameters.a, parameters.m_2, parameters.l_2, parameters.h_2,
// parameters.I_2, parameters.m_3, parameters.l_3, parameters.I_3, parameters.b, parameters.c.
// Operations: 53 mul, 25 add, 1 div, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool coriolis_matrix(const Parameters<Scalar>& parameters, const Scalar* q, const Scalar* qd,
    Scalar* C, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar a = parameters.a, m_2 = parameters.m_2, l_2 = parameters.l_2, h_2 = parameters.h_2,
      I_2 = parameters.I_2, m_3 = parameters.m_3, l_3 = parameters.l_3, I_3 = parameters.I_3,
      b = parameters.b, c = parameters.c;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  const Scalar t1 = b * (c_1 * c_2 - s_1 * s_2);
  const Scalar t2 = c * s_3;
  const Scalar R_l1a21_x = c_1 * s_2 + s_1 * c_2;
  const Scalar t3 = b * R_l1a21_x;
  const Scalar t4 = c * c_3;
  const Scalar t5 = t1 * t2 - t3 * t4;
  const Scalar t6 = Scalar(1.0) / t5;
  const Scalar t7 = a * c_1;
  const Scalar t8 = t7 + t1;
  const Scalar t9 = a * s_1;
  const Scalar p_l1ae_y = t9 + t3;
  const Scalar t10 = t6 * (t8 * t2 - p_l1ae_y * t4);
  const Scalar t11 = t10 - Scalar(1.0);
  const Scalar t12 = t11 * t11;
  const Scalar t13 = t6 * (t8 * t3 - t1 * p_l1ae_y);
  const Scalar t14 = t13 * t13;
  const Scalar H_1_1r1_2 = t9 - t2 * t14 + t3 * t12;
  const Scalar H_1_1r1_1 = t7 - t4 * t14 + t1 * t12;
  const Scalar t15 = m_2 * h_2;
  const Scalar t16 = m_2 * l_2;
  const Scalar I_2_zz = I_2 + h_2 * t15 + l_2 * t16;
  const Scalar mu_2_1_z = a * (c_2 * t16 - s_2 * t15) + I_2_zz;
  const Scalar b_1_2h = mu_2_1_z - I_2_zz * t10;
  const Scalar t17 = t6 * b_1_2h * (t2 * H_1_1r1_2 + t4 * H_1_1r1_1);
  const Scalar I_3_zz = I_3 + m_3 * l_3 * l_3;
  const Scalar t18 = I_3_zz * t6 * t13 * (t1 * H_1_1r1_1 + t3 * H_1_1r1_2);
  const Scalar mr_2_y = s_2 * t16 + c_2 * t15;
  const Scalar t19 = t10 * a * mr_2_y;
  C[0] = qd_1 * (t19 - t10 * t19 - t18 + t17);
  const Scalar t20 = b * c;
  bool positive = t5 * t5 - Scalar(1e-12) * t20 * t20 > Scalar(0.0);
  return positive;
}

// Gravity torques g(q) (7.39).
//   q[3]  in   joint positions, rad or m
//   g[1]  out  joint torques, N m (forces, N, for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..2], parameters.g, parameters.m_1, parameters.l_1, parameters.a, parameters.m_2,
// parameters.l_2, parameters.h_2, parameters.m_3, parameters.l_3, parameters.b, parameters.c.
// Operations: 32 mul, 13 add, 1 div, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool gravity(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* g,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar g_2 = parameters.g, m_1 = parameters.m_1, l_1 = parameters.l_1, a = parameters.a,
      m_2 = parameters.m_2, l_2 = parameters.l_2, h_2 = parameters.h_2, m_3 = parameters.m_3,
      l_3 = parameters.l_3, b = parameters.b, c = parameters.c;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  const Scalar s_1_2 = s_1 * c_2 + c_1 * s_2;
  const Scalar p_l1ae_y = b * s_1_2 + a * s_1;
  const Scalar t1 = s_1 * s_2 - c_1 * c_2;
  const Scalar p_l1ae_x = a * c_1 - b * t1;
  const Scalar t2 = m_2 * (h_2 * s_1_2 + l_2 * t1);
  const Scalar t3 = m_3 * l_3 * b * c_3 * (t1 * p_l1ae_y + s_1_2 * p_l1ae_x);
  const Scalar t4 = b * c;
  const Scalar t5 = (c_3 * s_1_2 + s_3 * t1) * t4;
  const Scalar t6 = (c * t2 * (c_3 * p_l1ae_y - s_3 * p_l1ae_x) + t3) / t5;
  g[0] = g_2 * ((c_1 * (a * m_2 + m_1 * l_1) - t2) + t6);
  bool positive = t5 * t5 - Scalar(1e-12) * t4 * t4 > Scalar(0.0);
  return positive;
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[3]   in   joint positions, rad or m
//   qd[1]  in   joint velocities, rad/s or m/s
//   n[1]   out  joint torques, N m (forces, N, for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..2], qd[0], parameters.g, parameters.m_1, parameters.l_1, parameters.a, parameters.m_2,
// parameters.l_2, parameters.h_2, parameters.I_2, parameters.m_3, parameters.l_3, parameters.I_3,
// parameters.b, parameters.c. Operations: 67 mul, 29 add, 1 div, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool bias(const Parameters<Scalar>& parameters, const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar g = parameters.g, m_1 = parameters.m_1, l_1 = parameters.l_1, a = parameters.a,
      m_2 = parameters.m_2, l_2 = parameters.l_2, h_2 = parameters.h_2, I_2 = parameters.I_2,
      m_3 = parameters.m_3, l_3 = parameters.l_3, I_3 = parameters.I_3, b = parameters.b,
      c = parameters.c;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t1 = s_1 * s_2 - c_1 * c_2;
  const Scalar t2 = c_3 * R_l1a21_x + s_3 * t1;
  const Scalar t3 = b * c;
  const Scalar t4 = Scalar(1.0) / (t2 * t3);
  const Scalar t5 = b * t4;
  const Scalar t6 = b * R_l1a21_x;
  const Scalar t7 = a * s_1;
  const Scalar p_l1ae_y = t6 + t7;
  const Scalar t8 = b * t1;
  const Scalar t9 = a * c_1;
  const Scalar t10 = t8 - t9;
  const Scalar t11 = (t1 * p_l1ae_y - R_l1a21_x * t10) * t5;
  const Scalar t12 = t11 * c * t11;
  const Scalar t13 = c * t4;
  const Scalar t14 = (c_3 * p_l1ae_y + s_3 * t10) * t13 - Scalar(1.0);
  const Scalar t15 = t14 * t14;
  const Scalar t16 = qd_1 * qd_1;
  const Scalar t17 = ((t9 - c_3 * t12) - t8 * t15) * t16;
  const Scalar t18 = ((t7 - s_3 * t12) + t6 * t15) * t16;
  const Scalar t19 = t13 * (c_3 * t17 + s_3 * t18);
  const Scalar t20 = h_2 * s_2 - l_2 * c_2;
  const Scalar t21 = h_2 * c_2 + l_2 * s_2;
  const Scalar t22 = g * c_1;
  const Scalar t23 = a * m_2 * ((t21 * t15 * t16 - t20 * t19) - t22);
  const Scalar I_2_zz = I_2 + m_2 * (l_2 * l_2 + h_2 * h_2);
  const Scalar t24 = m_2 * (t21 * (a * t16 - g * s_1) - t20 * t22);
  const Scalar t25 = t14 * (I_2_zz * t19 - t24);
  const Scalar t26 = m_3 * l_3;
  const Scalar I_3_zz = I_3 + l_3 * t26;
  const Scalar t27 = I_3_zz * t5 * (R_l1a21_x * t18 - t1 * t17);
  const Scalar t28 = t11 * (t27 - g * c_3 * t26);
  n[0] = m_1 * l_1 * t22 - t23 - t28 + t25;
  bool positive = t3 * t3 * (t2 * t2 - Scalar(1e-12)) > Scalar(0.0);
  return positive;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[3]    in   joint positions, rad or m
//   qd[1]   in   joint velocities, rad/s or m/s
//   tau[1]  in   joint torques or forces, N m or N
//   qdd[1]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular, or a pivot of B is not positive or not a number.
// Reads q[0..2], qd[0], tau[0], parameters.g, parameters.m_1, parameters.l_1, parameters.I_1,
// parameters.a, parameters.m_2, parameters.l_2, parameters.h_2, parameters.I_2, parameters.m_3,
// parameters.l_3, parameters.I_3, parameters.b, parameters.c. Operations: 75 mul, 40 add, 2 div, 6
// sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Parameters<Scalar>& parameters, const Scalar* q,
    const Scalar* qd, const Scalar* tau, Scalar* qdd, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar tau_1 = tau[0];
  const Scalar g = parameters.g, m_1 = parameters.m_1, l_1 = parameters.l_1, I_1 = parameters.I_1,
      a = parameters.a, m_2 = parameters.m_2, l_2 = parameters.l_2, h_2 = parameters.h_2,
      I_2 = parameters.I_2, m_3 = parameters.m_3, l_3 = parameters.l_3, I_3 = parameters.I_3,
      b = parameters.b, c = parameters.c;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t1 = b * R_l1a21_x;
  const Scalar t2 = c * c_3;
  const Scalar t3 = b * (s_1 * s_2 - c_1 * c_2);
  const Scalar t4 = c * s_3;
  const Scalar t5 = t1 * t2 + t3 * t4;
  const Scalar t6 = Scalar(1.0) / t5;
  const Scalar p_l1ae_y = t1 + a * s_1;
  const Scalar t7 = t3 - a * c_1;
  const Scalar t8 = t6 * (p_l1ae_y * t2 + t7 * t4);
  const Scalar omega_l2_z = qd_1 - t8 * qd_1;
  const Scalar t9 = omega_l2_z * omega_l2_z;
  const Scalar t10 = t6 * (t3 * p_l1ae_y - t7 * t1);
  const Scalar t11 = t10 * t10;
  const Scalar t12 = qd_1 * qd_1;
  const Scalar t13 = t11 * t12;
  const Scalar t14 = a * t12;
  const Scalar t15 = t2 * t13 - c_1 * t14 + t3 * t9;
  const Scalar t16 = t4 * t13 - s_1 * t14 - t1 * t9;
  const Scalar t17 = t6 * (t2 * t15 + t4 * t16);
  const Scalar t18 = m_2 * l_2;
  const Scalar t19 = m_2 * h_2;
  const Scalar I_2_zz = I_2 + l_2 * t18 + h_2 * t19;
  const Scalar mr_2_y = c_2 * t19 + s_2 * t18;
  const Scalar t20 = s_2 * t19 - c_2 * t18;
  const Scalar t21 = g * c_1;
  const Scalar N_2_z = mr_2_y * (t14 - g * s_1) - t20 * t21 + I_2_zz * t17;
  const Scalar t22 = a * (mr_2_y * t9 - m_2 * t21 + t20 * t17);
  const Scalar t23 = m_3 * l_3;
  const Scalar I_3_zz = I_3 + l_3 * t23;
  const Scalar t24 = I_3_zz * t6 * (t1 * t16 - t3 * t15);
  const Scalar N_3_z = g * c_3 * t23 + t24;
  const Scalar t25 = m_1 * l_1;
  const Scalar t26 = t25 * t21 - tau_1 + N_2_z - t22 + t10 * N_3_z - t8 * N_2_z;
  const Scalar t27 = a * t20;
  const Scalar mu_2_1_z = I_2_zz - t27;
  const Scalar b_1_2h = mu_2_1_z - I_2_zz * t8;
  const Scalar b_1_1q = I_1 + I_2_zz - Scalar(2.0) * t27 + a * a * m_2 + l_1 * t25 + I_3_zz * t11 -
      mu_2_1_z * t8 - t8 * b_1_2h;
  qdd[0] = -t26 / b_1_1q;
  const Scalar t28 = b * c;
  bool positive = b_1_1q > Scalar(0.0);
  positive &= t5 * t5 - Scalar(1e-12) * t28 * t28 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[3]   in   joint positions, rad or m
//   qd[1]  in   joint velocities, rad/s or m/s
//   T[1]   out  kinetic energy, J
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..2], qd[0], parameters.m_1, parameters.l_1, parameters.I_1, parameters.a,
// parameters.m_2, parameters.l_2, parameters.h_2, parameters.I_2, parameters.m_3, parameters.l_3,
// parameters.I_3, parameters.b, parameters.c. Operations: 45 mul, 18 add, 1 div, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool kinetic_energy(const Parameters<Scalar>& parameters, const Scalar* q, const Scalar* qd,
    Scalar* T, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar m_1 = parameters.m_1, l_1 = parameters.l_1, I_1 = parameters.I_1, a = parameters.a,
      m_2 = parameters.m_2, l_2 = parameters.l_2, h_2 = parameters.h_2, I_2 = parameters.I_2,
      m_3 = parameters.m_3, l_3 = parameters.l_3, I_3 = parameters.I_3, b = parameters.b,
      c = parameters.c;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t1 = s_1 * s_2 - c_1 * c_2;
  const Scalar t2 = b * c;
  const Scalar t3 = (c_3 * R_l1a21_x + s_3 * t1) * t2;
  const Scalar t4 = Scalar(1.0) / t3;
  const Scalar p_l1ae_y = b * R_l1a21_x + a * s_1;
  const Scalar t5 = b * t1 - a * c_1;
  const Scalar t6 = (t1 * p_l1ae_y - R_l1a21_x * t5) * b * t4;
  const Scalar I_3_zz = I_3 + m_3 * l_3 * l_3;
  const Scalar t7 = a * m_2;
  const Scalar I_1_zz = I_1 + m_1 * l_1 * l_1;
  const Scalar t8 = qd_1 * qd_1 * (I_1_zz + (a * t7 + I_3_zz * t6 * t6));
  const Scalar omega_2_z = qd_1 - c * qd_1 * t4 * (c_3 * p_l1ae_y + s_3 * t5);
  const Scalar I_2_zz = I_2 + m_2 * (l_2 * l_2 + h_2 * h_2);
  const Scalar t9 = (h_2 * s_2 - l_2 * c_2) * qd_1 * t7;
  T[0] = Scalar(-0.5) * (omega_2_z * (Scalar(2.0) * t9 - I_2_zz * omega_2_z) - t8);
  bool positive = t3 * t3 - Scalar(1e-12) * t2 * t2 > Scalar(0.0);
  return positive;
}

// Potential energy of links and rotors (7.36).
//   q[3]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[0..2], parameters.g, parameters.m_1, parameters.l_1, parameters.a, parameters.m_2,
// parameters.l_2, parameters.h_2, parameters.m_3, parameters.l_3. Operations: 12 mul, 6 add, 5
// sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar potential_energy(const Parameters<Scalar>& parameters, const Scalar* q,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar g = parameters.g, m_1 = parameters.m_1, l_1 = parameters.l_1, a = parameters.a,
      m_2 = parameters.m_2, l_2 = parameters.l_2, h_2 = parameters.h_2, m_3 = parameters.m_3,
      l_3 = parameters.l_3;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2];
  const Scalar hc_1_x = m_1 * l_1 + m_2 * (l_2 * c_2 + (a - h_2 * s_2));
  const Scalar t1 = m_2 * c_1 * (l_2 * s_2 + h_2 * c_2);
  const Scalar hc_0_y = t1 + m_3 * l_3 * s_3 + s_1 * hc_1_x;
  return g * hc_0_y;
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    1, 1, 0,
    1, 1, 0,
    0, 0, 1};

// Pose of the tip (2.50).
//   q[3]  in   joint positions, rad or m
//   R[9]  out  rotation matrix of the frame in the base frame
//              3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]  out  position of the frame's origin in the base frame, m
// Reads q[0..1], parameters.a, parameters.b. Operations: 9 mul, 5 add, 4 sin/cos. Always zero: 4 of
// the 9 entries of R. Always zero: p[2].
template <class Scalar, class SinCos = LibrarySinCos>
inline void forward_kinematics(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* R,
    Scalar* p, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar a = parameters.a, b = parameters.b;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = c_1 * s_2;
  const Scalar n_1_t_y = s_1 * c_2 + t1;
  R[3] = n_1_t_y;
  const Scalar t2 = s_1 * s_2;
  R[0] = R[4] = c_1 * c_2 - t2;
  R[1] = -n_1_t_y;
  const Scalar p_2_x = b * c_2 + a;
  p[1] = b * t1 + s_1 * p_2_x;
  p[0] = c_1 * p_2_x - b * t2;
  R[8] = Scalar(1.0);
  R[2] = R[5] = R[6] = R[7] = p[2] = Scalar(0.0);
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[6] = {
    1,
    1,
    0,
    0,
    0,
    1};

// Geometric Jacobian of the tip (7.14), (7.15).
//   q[3]  in   joint positions, rad or m
//   J[6]  out  geometric Jacobian in base axes: linear rows, then angular
//              6 x 1, row by row: entry (i, j) is J[1 * i + j]
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..2], parameters.a, parameters.b, parameters.c. Operations: 26 mul, 15 add, 1 div, 6
// sin/cos. Always zero: 3 of the 6 entries of J.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool jacobian(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* J,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar a = parameters.a, b = parameters.b, c = parameters.c;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  const Scalar R_21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t1 = a * s_1;
  const Scalar p_l1ae_y = t1 + b * R_21_x;
  const Scalar t2 = s_1 * s_2 - c_1 * c_2;
  const Scalar t3 = a * c_1;
  const Scalar p_l1ae_x = t3 - b * t2;
  const Scalar t4 = b * c;
  const Scalar t5 = (c_3 * R_21_x + s_3 * t2) * t4;
  const Scalar t6 = (c_3 * p_l1ae_y - s_3 * p_l1ae_x) * (c / t5);
  J[5] = Scalar(1.0) - t6;
  const Scalar p_2_x = b * c_2 + a;
  const Scalar t7 = b * s_2;
  const Scalar p_1u_t_y = c_1 * t7 + s_1 * p_2_x;
  const Scalar r_2_y = p_1u_t_y - t1;
  J[0] = r_2_y * t6 - p_1u_t_y;
  const Scalar t8 = s_1 * t7 - c_1 * p_2_x;
  J[1] = (t8 + t3) * t6 - t8;
  J[2] = J[3] = J[4] = Scalar(0.0);
  bool positive = t5 * t5 - Scalar(1e-12) * t4 * t4 > Scalar(0.0);
  return positive;
}

// (dJ/dt) qd of the tip.
//   q[3]   in   joint positions, rad or m
//   qd[1]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..2], qd[0], parameters.a, parameters.b, parameters.c. Operations: 49 mul, 20 add, 1
// div, 6 sin/cos. Always zero: a[2], a[3], a[4].
template <class Scalar, class SinCos = LibrarySinCos>
inline bool jacobian_dot_qd(const Parameters<Scalar>& parameters, const Scalar* q, const Scalar* qd,
    Scalar* a, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar a_2 = parameters.a, b = parameters.b, c = parameters.c;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t1 = b * R_l1a21_x;
  const Scalar t2 = c * c_3;
  const Scalar t3 = b * (s_1 * s_2 - c_1 * c_2);
  const Scalar t4 = c * s_3;
  const Scalar t5 = t1 * t2 + t3 * t4;
  const Scalar t6 = Scalar(1.0) / t5;
  const Scalar p_l1ae_y = t1 + a_2 * s_1;
  const Scalar t7 = t3 - a_2 * c_1;
  const Scalar t8 = t6 * (t3 * p_l1ae_y - t7 * t1);
  const Scalar t9 = qd_1 * qd_1;
  const Scalar t10 = t8 * t8 * t9;
  const Scalar omega_l2_z = qd_1 - qd_1 * t6 * (p_l1ae_y * t2 + t7 * t4);
  const Scalar t11 = omega_l2_z * omega_l2_z;
  const Scalar t12 = a_2 * t9;
  const Scalar t13 = t2 * (t2 * t10 - c_1 * t12 + t3 * t11);
  const Scalar t14 = t13 + t4 * (t4 * t10 - s_1 * t12 - t1 * t11);
  const Scalar a_6 = t6 * t14;
  a[5] = a_6;
  const Scalar ddp_e_y = s_2 * t12 + b * a_6;
  const Scalar t15 = c_2 * t12 + b * t11;
  const Scalar t16 = s_2 * t15 - c_2 * ddp_e_y;
  const Scalar t17 = s_2 * ddp_e_y + c_2 * t15;
  a[0] = s_1 * t16 - c_1 * t17;
  a[1] = -s_1 * t17 - c_1 * t16;
  a[2] = a[3] = a[4] = Scalar(0.0);
  const Scalar t18 = b * c;
  bool positive = t5 * t5 - Scalar(1e-12) * t18 * t18 > Scalar(0.0);
  return positive;
}

// Phi(q): what lies between the points where the loops are closed.
//   q[3]    in   joint positions, rad or m
//   phi[2]  out  loop by loop, m: what lies between the points that meet; 0 if closed
// Reads q[0..2], parameters.a, parameters.d, parameters.b, parameters.c. Operations: 10 mul, 7 add,
// 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void loop_closure(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* phi,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar a = parameters.a, d = parameters.d, b = parameters.b, c = parameters.c;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  const Scalar R_l1a20_x = c_1 * c_2 - s_1 * s_2;
  const Scalar p_l1ae_x = a * c_1 + b * R_l1a20_x;
  const Scalar p_l1be_x = c * c_3 + d;
  phi[0] = p_l1be_x - p_l1ae_x;
  const Scalar R_l1a21_x = c_1 * s_2 + s_1 * c_2;
  const Scalar p_l1ae_y = a * s_1 + b * R_l1a21_x;
  phi[1] = c * s_3 - p_l1ae_y;
}

// The entries of phi_q in loop_jacobian that are not always zero.
inline constexpr bool loop_jacobian_nonzero[6] = {
    1, 1, 1,
    1, 1, 1};

// Phi_q, the derivative of loop_closure.
//   q[3]      in   joint positions, rad or m
//   phi_q[6]  out  row i, column k: of phi[i] by q[k]
//                  2 x 3, row by row: entry (i, j) is phi_q[3 * i + j]
// Reads q[0..2], parameters.a, parameters.b, parameters.c. Operations: 10 mul, 4 add, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void loop_jacobian(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* phi_q,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar a = parameters.a, b = parameters.b, c = parameters.c;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  phi_q[5] = c * c_3;
  phi_q[2] = -c * s_3;
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar phi_q_12 = b * R_l1a21_x;
  phi_q[1] = phi_q_12;
  const Scalar Phi_l12_2 = b * (s_1 * s_2 - c_1 * c_2);
  phi_q[4] = Phi_l12_2;
  phi_q[0] = phi_q_12 + a * s_1;
  phi_q[3] = Phi_l12_2 - a * c_1;
}

// Newton's step of the dependent joints towards closed loops.
//   q[3]   in   joint positions, rad or m
//   dq[3]  out  to be added to q, again and again; 0 for independent joints, which stay
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..2], parameters.a, parameters.d, parameters.b, parameters.c. Operations: 24 mul, 11
// add, 1 div, 6 sin/cos. Always zero: dq[0].
template <class Scalar, class SinCos = LibrarySinCos>
inline bool loop_step(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* dq,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar a = parameters.a, d = parameters.d, b = parameters.b, c = parameters.c;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  const Scalar t1 = s_1 * s_2 - c_1 * c_2;
  const Scalar t2 = b * t1;
  const Scalar t3 = c * c_3;
  const Scalar t4 = t3 + t2 - a * c_1 + d;
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t5 = b * R_l1a21_x;
  const Scalar t6 = c * s_3;
  const Scalar t7 = t6 - t5 - a * s_1;
  const Scalar t8 = b * c;
  const Scalar t9 = c_3 * R_l1a21_x * t8 + s_3 * t1 * t8;
  const Scalar t10 = Scalar(1.0) / t9;
  dq[1] = -t10 * (t6 * t7 + t3 * t4);
  dq[2] = -t10 * (t5 * t7 - t2 * t4);
  dq[0] = Scalar(0.0);
  bool positive = t9 * t9 - Scalar(1e-12) * t8 * t8 > Scalar(0.0);
  return positive;
}

// Rates and accelerations of all joints of q, from those of the independent ones.
//   q[3]              in   joint positions, rad or m
//   qd[1]             in   joint velocities, rad/s or m/s
//   qdd[1]            in   joint accelerations, rad/s^2 or m/s^2
//   rates[3]          out  dq/dt of every entry of q
//   accelerations[3]  out  its derivative
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..2], qd[0], qdd[0], parameters.a, parameters.b, parameters.c. Operations: 41 mul, 17
// add, 1 div, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool loop_motion(const Parameters<Scalar>& parameters, const Scalar* q, const Scalar* qd,
    const Scalar* qdd, Scalar* rates, Scalar* accelerations, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar qdd_1 = qdd[0];
  const Scalar a = parameters.a, b = parameters.b, c = parameters.c;
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  rates[0] = qd_1;
  accelerations[0] = qdd_1;
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t1 = b * R_l1a21_x;
  const Scalar t2 = c * c_3;
  const Scalar t3 = b * (s_1 * s_2 - c_1 * c_2);
  const Scalar t4 = c * s_3;
  const Scalar t5 = t1 * t2 + t3 * t4;
  const Scalar t6 = Scalar(1.0) / t5;
  const Scalar t7 = t6 * qd_1;
  const Scalar t8 = a * s_1;
  const Scalar p_l1ae_y = t1 + t8;
  const Scalar t9 = a * c_1;
  const Scalar t10 = t3 - t9;
  const Scalar t11 = t3 * p_l1ae_y - t10 * t1;
  const Scalar rates_3 = t11 * t7;
  rates[2] = rates_3;
  const Scalar t12 = p_l1ae_y * t2 + t10 * t4;
  const Scalar t13 = t12 * t7;
  rates[1] = -t13;
  const Scalar omega_l2_z = qd_1 - t13;
  const Scalar t14 = omega_l2_z * omega_l2_z;
  const Scalar t15 = rates_3 * rates_3;
  const Scalar t16 = qd_1 * qd_1;
  const Scalar t17 = t4 * t15 - t8 * t16 - t1 * t14;
  const Scalar t18 = t2 * t15 - t9 * t16 + t3 * t14;
  const Scalar t19 = t6 * qdd_1;
  accelerations[2] = t11 * t19 + t6 * (t1 * t17 - t3 * t18);
  accelerations[1] = t6 * (t2 * t18 + t4 * t17) - t12 * t19;
  const Scalar t20 = b * c;
  bool positive = t5 * t5 - Scalar(1e-12) * t20 * t20 > Scalar(0.0);
  return positive;
}

// The functions by type, with the shapes of their arguments: what adapters such as
// flatdyn/eigen.hpp are given.
namespace functions {

struct inverse_dynamics {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[3], const Scalar (&qd)[1],
      const Scalar (&qdd)[1], Scalar (&tau)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::inverse_dynamics(of...); }
};

struct inverse_dynamics_tip_force {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[3], const Scalar (&qd)[1],
      const Scalar (&qdd)[1], const Scalar (&h_e)[6], Scalar (&tau)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept {
    return ::four_bar::inverse_dynamics_tip_force(of...);
  }
};

struct inertia_matrix {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[3], Scalar (&B)[1][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::inertia_matrix(of...); }
};

struct christoffel {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[3], Scalar (&c)[1][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::christoffel(of...); }
};

struct coriolis_matrix {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[3], const Scalar (&qd)[1],
      Scalar (&C)[1][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::coriolis_matrix(of...); }
};

struct gravity {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[3], Scalar (&g)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::gravity(of...); }
};

struct bias {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[3], const Scalar (&qd)[1],
      Scalar (&n)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::bias(of...); }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[3], const Scalar (&qd)[1],
      const Scalar (&tau)[1], Scalar (&qdd)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::forward_dynamics(of...); }
};

struct kinetic_energy {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[3], const Scalar (&qd)[1],
      Scalar (&T)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::kinetic_energy(of...); }
};

struct potential_energy {
  template <class Scalar>
  using Shape = Scalar(const Parameters<Scalar>&, const Scalar (&q)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::potential_energy(of...); }
};

struct forward_kinematics {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[3], Scalar (&R)[3][3],
      Scalar (&p)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::forward_kinematics(of...); }
};

struct jacobian {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[3], Scalar (&J)[6][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::jacobian(of...); }
};

struct jacobian_dot_qd {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[3], const Scalar (&qd)[1],
      Scalar (&a)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::jacobian_dot_qd(of...); }
};

struct loop_closure {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[3], Scalar (&phi)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::loop_closure(of...); }
};

struct loop_jacobian {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[3], Scalar (&phi_q)[2][3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::loop_jacobian(of...); }
};

struct loop_step {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[3], Scalar (&dq)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::loop_step(of...); }
};

struct loop_motion {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[3], const Scalar (&qd)[1],
      const Scalar (&qdd)[1], Scalar (&rates)[3], Scalar (&accelerations)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::four_bar::loop_motion(of...); }
};

}  // namespace functions

// Moves the dependent joints of q until the loops are closed, by Newton's method with halved steps
// where a full one does not lessen the gap. Returns false, and leaves q as it was, where the gap is
// larger than `tolerance` (m) after `most_steps`: the loops cannot be closed from there, or are
// singular. Which of several ways to close them is found depends on where q is.
template <class Scalar>
inline bool close_loops(const Parameters<Scalar>& parameters, Scalar* q,
    Scalar tolerance, int most_steps = 20) noexcept {
  Scalar here[position_count], next[position_count], dq[position_count], phi[2];
  const auto gap_at = [&](const Scalar* position) {
    loop_closure(parameters, position, phi);
    Scalar sum = Scalar(0.0);
    for (const Scalar& entry : phi) sum = sum + entry * entry;
    return sum;
  };
  for (int k = 0; k < position_count; ++k) here[k] = q[k];
  Scalar gap = gap_at(here);
  for (int step = 0; step < most_steps && gap > tolerance * tolerance; ++step) {
    if (!loop_step(parameters, here, dq)) return false;
    Scalar next_gap = gap, size = Scalar(1.0);
    for (int halving = 0; halving < 20 && !(next_gap < gap); ++halving, size = size * Scalar(0.5)) {
      for (int k = 0; k < position_count; ++k) next[k] = here[k] + size * dq[k];
      next_gap = gap_at(next);
    }
    if (!(next_gap < gap)) return false;
    for (int k = 0; k < position_count; ++k) here[k] = next[k];
    gap = next_gap;
  }
  if (!(gap <= tolerance * tolerance)) return false;
  for (int k = 0; k < position_count; ++k) q[k] = here[k];
  return true;
}

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

}  // namespace four_bar

#endif  // FLATDYN_FOUR_BAR_HPP_7D0B404B

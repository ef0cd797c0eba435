// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "scara" as flat code: 4 joints.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Input: sha1:f749c2f5bef3258630e09b2e88a499dd6c366754
//
//   index  joint    moves link  type       unit
//   0      theta_1  link1       revolute   rad
//   1      theta_2  link2       revolute   rad
//   2      d_3      link3       prismatic  m
//   3      theta_4  link4       revolute   rad
//
// Gravity is (0, 0, -g) m/s^2 in the base frame. The tip belongs to link "link4".
//
// Every function is a template over its scalar: float, double, or any type that is made from a
// double, has + - * / (also - of one), comparisons, and sin, cos where argument-dependent lookup
// finds them (or an argument that knows them, see LibrarySinCos). Arguments are plain arrays:
//
//   scara::Parameters<> parameters = {};  // then set its members
//   double q[4] = {}, qd[4] = {}, qdd[4] = {}, tau[4];
//   scara::inverse_dynamics(parameters, q, qd, qdd, tau);
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

#ifndef FLATDYN_SCARA_HPP_5DE29C7E
#define FLATDYN_SCARA_HPP_5DE29C7E

#include <cmath>

namespace scara {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 4;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {"theta_1", "theta_2", "d_3", "theta_4"};

// What the robot file leaves open: an argument of every function. Units as in the file.
template <class Scalar = Real>
struct Parameters {
  Scalar g;  // m/s^2
  Scalar a_1;  // m
  Scalar m_l1;  // kg
  Scalar l_1;  // m
  Scalar I_l1;  // kg m^2
  Scalar m_m1;  // kg
  Scalar I_m1;  // kg m^2
  Scalar k_r1;
  Scalar a_2;  // m
  Scalar m_l2;  // kg
  Scalar l_2;  // m
  Scalar I_l2;  // kg m^2
  Scalar m_m2;  // kg
  Scalar I_m2;  // kg m^2
  Scalar k_r2;
  Scalar m_l3;  // kg
  Scalar I_l3;  // kg m^2
  Scalar m_m3;  // kg
  Scalar I_m3;  // kg m^2
  Scalar k_r3;
  Scalar m_l4;  // kg
  Scalar I_l4;  // kg m^2
  Scalar m_m4;  // kg
  Scalar I_m4;  // kg m^2
  Scalar k_r4;
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
//   q[4]    in   joint positions, rad or m
//   qd[4]   in   joint velocities, rad/s or m/s
//   qdd[4]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[4]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1], qd[0..1], qdd[0..3], parameters.g, parameters.a_1, parameters.m_l1, parameters.l_1,
// parameters.I_l1, parameters.I_m1, parameters.k_r1, parameters.a_2, parameters.m_l2,
// parameters.l_2, parameters.I_l2, parameters.m_m2, parameters.I_m2, parameters.k_r2,
// parameters.m_l3, parameters.I_l3, parameters.m_m3, parameters.I_m3, parameters.k_r3,
// parameters.m_l4, parameters.I_l4, parameters.m_m4, parameters.I_m4, parameters.k_r4. Operations:
// 42 mul, 37 add, 2 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics(const Parameters<Scalar>& parameters, const Scalar* q,
    const Scalar* qd, const Scalar* qdd, Scalar* tau, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3];
  const Scalar g = parameters.g, a_1 = parameters.a_1, m_l1 = parameters.m_l1, l_1 = parameters.l_1,
      I_l1 = parameters.I_l1, I_m1 = parameters.I_m1, k_r1 = parameters.k_r1, a_2 = parameters.a_2,
      m_l2 = parameters.m_l2, l_2 = parameters.l_2, I_l2 = parameters.I_l2, m_m2 = parameters.m_m2,
      I_m2 = parameters.I_m2, k_r2 = parameters.k_r2, m_l3 = parameters.m_l3,
      I_l3 = parameters.I_l3, m_m3 = parameters.m_m3, I_m3 = parameters.I_m3,
      k_r3 = parameters.k_r3, m_l4 = parameters.m_l4, I_l4 = parameters.I_l4,
      m_m4 = parameters.m_m4, I_m4 = parameters.I_m4, k_r4 = parameters.k_r4;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1];
  const Scalar domega_2_z = qdd_1 + qdd_2;
  const Scalar t1 = I_m3 * k_r3;
  const Scalar ddp_s_3_z = g + qdd_3;
  const Scalar m_3 = m_l3 + m_l4 + m_m4;
  tau[2] = ddp_s_3_z * m_3 + t1 * (domega_2_z + k_r3 * qdd_3);
  const Scalar domega_4_z = qdd_4 + domega_2_z;
  const Scalar t2 = I_l4 * domega_4_z;
  const Scalar t3 = I_m4 * k_r4;
  tau[3] = t2 + t3 * (domega_2_z + k_r4 * qdd_4);
  const Scalar t4 = a_2 * (m_m3 + m_3);
  const Scalar t5 = m_l2 * l_2;
  const Scalar I_2_zz = I_l2 + I_l3 + I_m3 + I_m4 + l_2 * t5 + a_2 * t4;
  const Scalar t6 = t5 + t4;
  const Scalar t7 = qd_1 * qd_1;
  const Scalar t8 = s_2 * t7 + c_2 * qdd_1;
  const Scalar mu_2_z = qdd_4 * t3 + qdd_3 * t1 + t2 + a_1 * t8 * t6 + domega_2_z * I_2_zz;
  const Scalar t9 = I_m2 * k_r2;
  tau[1] = t9 * (qdd_1 + k_r2 * qdd_2) + mu_2_z;
  const Scalar omega_2_z = qd_1 + qd_2;
  const Scalar t10 = a_1 * m_3;
  const Scalar t11 = (s_2 * qdd_1 - c_2 * t7) * t10 - omega_2_z * omega_2_z * t6;
  const Scalar f_2_y = t8 * t10 + domega_2_z * t6;
  const Scalar f_u_2_t_y = s_2 * t11 + c_2 * f_2_y;
  const Scalar t12 = a_1 * a_1 * (m_l2 + m_m2 + m_m3);
  const Scalar t13 = I_l1 + I_m2 + m_l1 * l_1 * l_1 + t12 + I_m1 * k_r1 * k_r1;
  tau[0] = qdd_2 * t9 + qdd_1 * t13 + mu_2_z + a_1 * f_u_2_t_y;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[4]    in   joint positions, rad or m
//   qd[4]   in   joint velocities, rad/s or m/s
//   qdd[4]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[4]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..1], q[3], qd[0..1], qdd[0..3], h_e[0..2], h_e[5], parameters.g, parameters.a_1,
// parameters.m_l1, parameters.l_1, parameters.I_l1, parameters.I_m1, parameters.k_r1,
// parameters.a_2, parameters.m_l2, parameters.l_2, parameters.I_l2, parameters.m_m2,
// parameters.I_m2, parameters.k_r2, parameters.m_l3, parameters.I_l3, parameters.m_m3,
// parameters.I_m3, parameters.k_r3, parameters.m_l4, parameters.I_l4, parameters.m_m4,
// parameters.I_m4, parameters.k_r4. Operations: 59 mul, 50 add, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics_tip_force(const Parameters<Scalar>& parameters, const Scalar* q,
    const Scalar* qd, const Scalar* qdd, const Scalar* h_e, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3];
  const Scalar h_e_1 = h_e[0], h_e_2 = h_e[1], h_e_3 = h_e[2], h_e_6 = h_e[5];
  const Scalar g = parameters.g, a_1 = parameters.a_1, m_l1 = parameters.m_l1, l_1 = parameters.l_1,
      I_l1 = parameters.I_l1, I_m1 = parameters.I_m1, k_r1 = parameters.k_r1, a_2 = parameters.a_2,
      m_l2 = parameters.m_l2, l_2 = parameters.l_2, I_l2 = parameters.I_l2, m_m2 = parameters.m_m2,
      I_m2 = parameters.I_m2, k_r2 = parameters.k_r2, m_l3 = parameters.m_l3,
      I_l3 = parameters.I_l3, m_m3 = parameters.m_m3, I_m3 = parameters.I_m3,
      k_r3 = parameters.k_r3, m_l4 = parameters.m_l4, I_l4 = parameters.I_l4,
      m_m4 = parameters.m_m4, I_m4 = parameters.I_m4, k_r4 = parameters.k_r4;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_4 = sine[3],
      c_4 = cosine[3];
  const Scalar domega_2_z = qdd_1 + qdd_2;
  const Scalar t1 = I_m3 * k_r3;
  const Scalar ddp_s_3_z = g + qdd_3;
  const Scalar m_3 = m_l3 + m_l4 + m_m4;
  tau[2] = h_e_3 + ddp_s_3_z * m_3 + t1 * (domega_2_z + k_r3 * qdd_3);
  const Scalar domega_4_z = qdd_4 + domega_2_z;
  const Scalar mu_4_z = h_e_6 + I_l4 * domega_4_z;
  const Scalar t2 = I_m4 * k_r4;
  tau[3] = mu_4_z + t2 * (domega_2_z + k_r4 * qdd_4);
  const Scalar f_e1_x = s_1 * h_e_2 + c_1 * h_e_1;
  const Scalar t3 = s_1 * h_e_1 - c_1 * h_e_2;
  const Scalar t4 = s_2 * f_e1_x + c_2 * t3;
  const Scalar t5 = s_2 * t3 - c_2 * f_e1_x;
  const Scalar t6 = s_4 * t4 + c_4 * t5;
  const Scalar f_e4_y = s_4 * t5 - c_4 * t4;
  const Scalar t7 = s_4 * t6 - c_4 * f_e4_y;
  const Scalar t8 = a_2 * (m_m3 + m_3);
  const Scalar t9 = m_l2 * l_2;
  const Scalar I_2_zz = I_l2 + I_l3 + I_m3 + I_m4 + l_2 * t9 + a_2 * t8;
  const Scalar t10 = t9 + t8;
  const Scalar t11 = qd_1 * qd_1;
  const Scalar t12 = s_2 * t11 + c_2 * qdd_1;
  const Scalar mu_2_z = qdd_4 * t2 - a_2 * t7 + qdd_3 * t1 + mu_4_z + a_1 * t12 * t10 +
      domega_2_z * I_2_zz;
  const Scalar t13 = I_m2 * k_r2;
  tau[1] = t13 * (qdd_1 + k_r2 * qdd_2) + mu_2_z;
  const Scalar t14 = a_1 * m_3;
  const Scalar omega_2_z = qd_1 + qd_2;
  const Scalar t15 = (s_2 * qdd_1 - c_2 * t11) * t14;
  const Scalar t16 = s_4 * f_e4_y + c_4 * t6 - t15 + omega_2_z * omega_2_z * t10;
  const Scalar t17 = s_2 * t16 + c_2 * (t7 - t12 * t14 - domega_2_z * t10);
  const Scalar t18 = a_1 * a_1 * (m_l2 + m_m2 + m_m3);
  const Scalar t19 = I_l1 + I_m2 + m_l1 * l_1 * l_1 + t18 + I_m1 * k_r1 * k_r1;
  tau[0] = qdd_2 * t13 + qdd_1 * t19 + mu_2_z - a_1 * t17;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[16] = {
    1, 1, 1, 1,
    1, 1, 1, 1,
    1, 1, 1, 0,
    1, 1, 0, 1};

// Joint-space inertia matrix B(q) (7.32).
//   q[4]   in   joint positions, rad or m
//   B[16]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//               4 x 4, row by row: entry (i, j) is B[4 * i + j]
// Reads q[1], parameters.a_1, parameters.m_l1, parameters.l_1, parameters.I_l1, parameters.I_m1,
// parameters.k_r1, parameters.a_2, parameters.m_l2, parameters.l_2, parameters.I_l2,
// parameters.m_m2, parameters.I_m2, parameters.k_r2, parameters.m_l3, parameters.I_l3,
// parameters.m_m3, parameters.I_m3, parameters.k_r3, parameters.m_l4, parameters.I_l4,
// parameters.m_m4, parameters.I_m4, parameters.k_r4. Operations: 19 mul, 24 add, 1 sin/cos. Always
// zero: 2 of the 16 entries of B.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inertia_matrix(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* B,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar a_1 = parameters.a_1, m_l1 = parameters.m_l1, l_1 = parameters.l_1,
      I_l1 = parameters.I_l1, I_m1 = parameters.I_m1, k_r1 = parameters.k_r1, a_2 = parameters.a_2,
      m_l2 = parameters.m_l2, l_2 = parameters.l_2, I_l2 = parameters.I_l2, m_m2 = parameters.m_m2,
      I_m2 = parameters.I_m2, k_r2 = parameters.k_r2, m_l3 = parameters.m_l3,
      I_l3 = parameters.I_l3, m_m3 = parameters.m_m3, I_m3 = parameters.I_m3,
      k_r3 = parameters.k_r3, m_l4 = parameters.m_l4, I_l4 = parameters.I_l4,
      m_m4 = parameters.m_m4, I_m4 = parameters.I_m4, k_r4 = parameters.k_r4;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1>(), sine, cosine);
  const Scalar c_2 = cosine[1];
  const Scalar kI_3 = I_m3 * k_r3;
  B[2] = B[6] = B[8] = B[9] = kI_3;
  const Scalar t1 = I_m4 * k_r4;
  B[3] = B[7] = B[12] = B[13] = I_l4 + t1;
  const Scalar mc_3 = m_m4 + (m_l3 + m_l4);
  B[10] = mc_3 + k_r3 * kI_3;
  B[15] = I_l4 + k_r4 * t1;
  const Scalar t2 = m_m3 + mc_3;
  const Scalar t3 = a_2 * t2;
  const Scalar t4 = m_l2 * l_2;
  const Scalar Ic_2_zz = I_l2 + I_l3 + I_m3 + I_l4 + I_m4 + l_2 * t4 + a_2 * t3;
  const Scalar hc_2_x = t4 + t3;
  const Scalar t5 = hc_2_x * a_1 * c_2;
  const Scalar t6 = a_1 * a_1 * ((m_l2 + m_m2) + t2);
  B[0] = I_l1 + I_m2 + I_m1 * k_r1 * k_r1 + m_l1 * l_1 * l_1 + Ic_2_zz + Scalar(2.0) * t5 + t6;
  const Scalar t7 = I_m2 * k_r2;
  B[5] = k_r2 * t7 + Ic_2_zz;
  B[1] = B[4] = t5 + t7 + Ic_2_zz;
  B[11] = B[14] = Scalar(0.0);
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[40] = {
    0, 1, 1, 0, 0, 0, 0, 0, 0, 0,
    1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[4]   in   joint positions, rad or m
//   c[40]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//               c_ijk = c_ikj is c[10 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads q[1], parameters.a_1, parameters.a_2, parameters.m_l2, parameters.l_2, parameters.m_l3,
// parameters.m_m3, parameters.m_l4, parameters.m_m4. Operations: 4 mul, 4 add, 1 sin/cos. Always
// zero: 37 of the 40 entries of c.
template <class Scalar, class SinCos = LibrarySinCos>
inline void christoffel(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* c,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar a_1 = parameters.a_1, a_2 = parameters.a_2, m_l2 = parameters.m_l2,
      l_2 = parameters.l_2, m_l3 = parameters.m_l3, m_m3 = parameters.m_m3, m_l4 = parameters.m_l4,
      m_m4 = parameters.m_m4;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1>(), sine, cosine);
  const Scalar s_2 = sine[1];
  const Scalar hc_2_x = m_l2 * l_2 + a_2 * ((m_l3 + m_l4) + (m_m3 + m_m4));
  const Scalar c_2_1_1 = a_1 * s_2 * hc_2_x;
  c[10] = c_2_1_1;
  c[1] = c[2] = -c_2_1_1;
  c[0] = c[3] = c[4] = c[5] = c[6] = c[7] = c[8] = c[9] = Scalar(0.0);
  c[11] = c[12] = c[13] = c[14] = c[15] = c[16] = c[17] = c[18] = Scalar(0.0);
  c[19] = c[20] = c[21] = c[22] = c[23] = c[24] = c[25] = c[26] = Scalar(0.0);
  c[27] = c[28] = c[29] = c[30] = c[31] = c[32] = c[33] = c[34] = Scalar(0.0);
  c[35] = c[36] = c[37] = c[38] = c[39] = Scalar(0.0);
}

// The entries of C in coriolis_matrix that are not always zero.
inline constexpr bool coriolis_matrix_nonzero[16] = {
    1, 1, 0, 0,
    1, 0, 0, 0,
    0, 0, 0, 0,
    0, 0, 0, 0};

// C(q, qd) from the Christoffel symbols (7.44).
//   q[4]   in   joint positions, rad or m
//   qd[4]  in   joint velocities, rad/s or m/s
//   C[16]  out  c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric
//               4 x 4, row by row: entry (i, j) is C[4 * i + j]
// Reads q[1], qd[0..1], parameters.a_1, parameters.a_2, parameters.m_l2, parameters.l_2,
// parameters.m_l3, parameters.m_m3, parameters.m_l4, parameters.m_m4. Operations: 6 mul, 5 add, 1
// sin/cos. Always zero: 13 of the 16 entries of C.
template <class Scalar, class SinCos = LibrarySinCos>
inline void coriolis_matrix(const Parameters<Scalar>& parameters, const Scalar* q, const Scalar* qd,
    Scalar* C, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar a_1 = parameters.a_1, a_2 = parameters.a_2, m_l2 = parameters.m_l2,
      l_2 = parameters.l_2, m_l3 = parameters.m_l3, m_m3 = parameters.m_m3, m_l4 = parameters.m_l4,
      m_m4 = parameters.m_m4;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1>(), sine, cosine);
  const Scalar s_2 = sine[1];
  const Scalar hc_2_x = m_l2 * l_2 + a_2 * ((m_l3 + m_l4) + (m_m3 + m_m4));
  const Scalar t1 = hc_2_x * a_1 * s_2;
  const Scalar C_21 = qd_1 * t1;
  C[4] = C_21;
  const Scalar t2 = qd_2 * t1;
  C[0] = -t2;
  C[1] = -t2 - C_21;
  C[2] = C[3] = C[5] = C[6] = C[7] = C[8] = C[9] = C[10] = Scalar(0.0);
  C[11] = C[12] = C[13] = C[14] = C[15] = Scalar(0.0);
}

// Gravity torques g(q) (7.39).
//   q[4]  in   joint positions, rad or m
//   g[4]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads parameters.g, parameters.m_l3, parameters.m_l4, parameters.m_m4. Operations: 1 mul, 2 add.
// Always zero: g[0], g[1], g[3].
template <class Scalar>
inline void gravity(const Parameters<Scalar>& parameters, const Scalar* /* q */,
    Scalar* g) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar g_2 = parameters.g, m_l3 = parameters.m_l3, m_l4 = parameters.m_l4,
      m_m4 = parameters.m_m4;
  const Scalar mc_3 = m_l3 + m_l4 + m_m4;
  g[2] = g_2 * mc_3;
  g[0] = g[1] = g[3] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[4]   in   joint positions, rad or m
//   qd[4]  in   joint velocities, rad/s or m/s
//   n[4]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1], qd[0..1], parameters.g, parameters.a_1, parameters.a_2, parameters.m_l2,
// parameters.l_2, parameters.m_l3, parameters.m_m3, parameters.m_l4, parameters.m_m4. Operations: 9
// mul, 6 add, 1 sin/cos. Always zero: n[3].
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Parameters<Scalar>& parameters, const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar g = parameters.g, a_1 = parameters.a_1, a_2 = parameters.a_2, m_l2 = parameters.m_l2,
      l_2 = parameters.l_2, m_l3 = parameters.m_l3, m_m3 = parameters.m_m3, m_l4 = parameters.m_l4,
      m_m4 = parameters.m_m4;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1>(), sine, cosine);
  const Scalar s_2 = sine[1];
  const Scalar m_3 = m_l3 + m_l4 + m_m4;
  n[2] = g * m_3;
  const Scalar t1 = (m_l2 * l_2 + a_2 * (m_m3 + m_3)) * a_1 * s_2;
  const Scalar mu_2_z = qd_1 * qd_1 * t1;
  n[1] = mu_2_z;
  const Scalar omega_2_z = qd_1 + qd_2;
  n[0] = mu_2_z - omega_2_z * omega_2_z * t1;
  n[3] = Scalar(0.0);
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[4]    in   joint positions, rad or m
//   qd[4]   in   joint velocities, rad/s or m/s
//   tau[4]  in   joint torques or forces, N m or N
//   qdd[4]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[1], qd[0..1], tau[0..3], parameters.g, parameters.a_1, parameters.m_l1, parameters.l_1,
// parameters.I_l1, parameters.I_m1, parameters.k_r1, parameters.a_2, parameters.m_l2,
// parameters.l_2, parameters.I_l2, parameters.m_m2, parameters.I_m2, parameters.k_r2,
// parameters.m_l3, parameters.I_l3, parameters.m_m3, parameters.I_m3, parameters.k_r3,
// parameters.m_l4, parameters.I_l4, parameters.m_m4, parameters.I_m4, parameters.k_r4. Operations:
// 40 mul, 39 add, 4 div, 2 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Parameters<Scalar>& parameters, const Scalar* q,
    const Scalar* qd, const Scalar* tau, Scalar* qdd, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar tau_1 = tau[0], tau_2 = tau[1], tau_3 = tau[2], tau_4 = tau[3];
  const Scalar g = parameters.g, a_1 = parameters.a_1, m_l1 = parameters.m_l1, l_1 = parameters.l_1,
      I_l1 = parameters.I_l1, I_m1 = parameters.I_m1, k_r1 = parameters.k_r1, a_2 = parameters.a_2,
      m_l2 = parameters.m_l2, l_2 = parameters.l_2, I_l2 = parameters.I_l2, m_m2 = parameters.m_m2,
      I_m2 = parameters.I_m2, k_r2 = parameters.k_r2, m_l3 = parameters.m_l3,
      I_l3 = parameters.I_l3, m_m3 = parameters.m_m3, I_m3 = parameters.I_m3,
      k_r3 = parameters.k_r3, m_l4 = parameters.m_l4, I_l4 = parameters.I_l4,
      m_m4 = parameters.m_m4, I_m4 = parameters.I_m4, k_r4 = parameters.k_r4;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = I_m3 * k_r3;
  const Scalar mc_3 = m_l3 + m_l4 + m_m4;
  const Scalar b_3_3 = mc_3 + k_r3 * t1;
  const Scalar d_3 = Scalar(1.0) / b_3_3;
  const Scalar t2 = t1 * d_3;
  const Scalar t3 = I_m4 * k_r4;
  const Scalar b_4_4 = I_l4 + k_r4 * t3;
  const Scalar d_4 = Scalar(1.0) / b_4_4;
  const Scalar mu_4_3_z = I_l4 + t3;
  const Scalar t4 = mu_4_3_z * d_4;
  const Scalar t5 = m_m3 + mc_3;
  const Scalar t6 = a_2 * t5;
  const Scalar t7 = m_l2 * l_2;
  const Scalar t8 = I_l2 - t1 * t2 + I_l3 + I_m3 + I_l4 + I_m4 + l_2 * t7 + a_2 * t6 -
      mu_4_3_z * t4;
  const Scalar t9 = I_m2 * k_r2;
  const Scalar b_3_2_2 = k_r2 * t9 + t8;
  const Scalar d_2 = Scalar(1.0) / b_3_2_2;
  const Scalar hc_2_x = t7 + t6;
  const Scalar t10 = a_1 * hc_2_x;
  const Scalar t11 = c_2 * t10;
  const Scalar b_3_2_1 = t9 + t11 + t8;
  const Scalar t12 = b_3_2_1 * d_2;
  const Scalar t13 = a_1 * a_1 * (m_l2 + m_m2 + t5);
  const Scalar b_2_1_1 = I_l1 + I_m2 + I_m1 * k_r1 * k_r1 + m_l1 * l_1 * l_1 + t8 +
      Scalar(2.0) * t11 + t13 - b_3_2_1 * t12;
  const Scalar t14 = s_2 * t10;
  const Scalar t15 = tau_3 - g * mc_3;
  const Scalar t16 = t2 * t15 + t4 * tau_4 + qd_1 * qd_1 * t14;
  const Scalar t17 = tau_2 - t16;
  const Scalar omega_2_z = qd_1 + qd_2;
  const Scalar qdd_1 = (tau_1 - t16 - t12 * t17 + omega_2_z * omega_2_z * t14) / b_2_1_1;
  qdd[0] = qdd_1;
  const Scalar qdd_2 = d_2 * (t17 - b_3_2_1 * qdd_1);
  qdd[1] = qdd_2;
  const Scalar t18 = qdd_1 + qdd_2;
  qdd[2] = d_3 * (t15 - t1 * t18);
  qdd[3] = d_4 * (tau_4 - mu_4_3_z * t18);
  bool positive = b_2_1_1 > Scalar(0.0);
  positive &= b_3_2_2 > Scalar(0.0);
  positive &= b_3_3 > Scalar(0.0);
  positive &= b_4_4 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[4]   in  joint positions, rad or m
//   qd[4]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1], qd[0..3], parameters.a_1, parameters.m_l1, parameters.l_1, parameters.I_l1,
// parameters.I_m1, parameters.k_r1, parameters.a_2, parameters.m_l2, parameters.l_2,
// parameters.I_l2, parameters.m_m2, parameters.I_m2, parameters.k_r2, parameters.m_l3,
// parameters.I_l3, parameters.m_m3, parameters.I_m3, parameters.k_r3, parameters.m_l4,
// parameters.I_l4, parameters.m_m4, parameters.I_m4, parameters.k_r4. Operations: 35 mul, 28 add, 1
// sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar kinetic_energy(const Parameters<Scalar>& parameters, const Scalar* q,
    const Scalar* qd, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3];
  const Scalar a_1 = parameters.a_1, m_l1 = parameters.m_l1, l_1 = parameters.l_1,
      I_l1 = parameters.I_l1, I_m1 = parameters.I_m1, k_r1 = parameters.k_r1, a_2 = parameters.a_2,
      m_l2 = parameters.m_l2, l_2 = parameters.l_2, I_l2 = parameters.I_l2, m_m2 = parameters.m_m2,
      I_m2 = parameters.I_m2, k_r2 = parameters.k_r2, m_l3 = parameters.m_l3,
      I_l3 = parameters.I_l3, m_m3 = parameters.m_m3, I_m3 = parameters.I_m3,
      k_r3 = parameters.k_r3, m_l4 = parameters.m_l4, I_l4 = parameters.I_l4,
      m_m4 = parameters.m_m4, I_m4 = parameters.I_m4, k_r4 = parameters.k_r4;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1>(), sine, cosine);
  const Scalar c_2 = cosine[1];
  const Scalar m_3 = m_l3 + m_l4 + m_m4;
  const Scalar t1 = a_2 * (m_m3 + m_3);
  const Scalar t2 = m_l2 * l_2;
  const Scalar I_2_zz = I_l2 + I_l3 + I_m3 + I_m4 + a_2 * t1 + l_2 * t2;
  const Scalar omega_2_z = qd_1 + qd_2;
  const Scalar t3 = a_1 * qd_1;
  const Scalar t4 = omega_2_z * (Scalar(2.0) * c_2 * t3 * (t1 + t2) + omega_2_z * I_2_zz);
  const Scalar t5 = a_1 * a_1 * (m_l2 + m_m2 + m_m3);
  const Scalar t6 = I_l1 + I_m2 + I_m1 * k_r1 * k_r1 + t5 + m_l1 * l_1 * l_1;
  const Scalar t7 = Scalar(2.0) * omega_2_z;
  const Scalar t8 = k_r4 * qd_4;
  const Scalar t9 = I_m4 * t8 * (t8 + t7);
  const Scalar t10 = k_r3 * qd_3;
  const Scalar t11 = I_m3 * t10 * (t10 + t7);
  const Scalar v_v_3 = qd_3 * qd_3 + t3 * t3;
  const Scalar omega_4_z = qd_4 + omega_2_z;
  const Scalar t12 = k_r2 * qd_2;
  const Scalar t13 = I_m2 * t12 * (t12 + Scalar(2.0) * qd_1);
  const Scalar T_2 = qd_1 * qd_1 * t6 + t9 + I_l4 * omega_4_z * omega_4_z + t11 + m_3 * v_v_3 +
      t13 + t4;
  return Scalar(0.5) * T_2;
}

// Potential energy of links and rotors (7.36).
//   q[4]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[2], parameters.g, parameters.m_l3, parameters.m_l4, parameters.m_m4. Operations: 2 mul, 2
// add.
template <class Scalar>
inline Scalar potential_energy(const Parameters<Scalar>& parameters, const Scalar* q) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar q_3 = q[2];
  const Scalar g = parameters.g, m_l3 = parameters.m_l3, m_l4 = parameters.m_l4,
      m_m4 = parameters.m_m4;
  const Scalar mc_3 = m_l3 + m_l4 + m_m4;
  return g * q_3 * mc_3;
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    1, 1, 0,
    1, 1, 0,
    0, 0, 1};

// Pose of the tip (2.50).
//   q[4]  in   joint positions, rad or m
//   R[9]  out  rotation matrix of the frame in the base frame
//              3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]  out  position of the frame's origin in the base frame, m
// Reads q[0..3], parameters.a_1, parameters.a_2. Operations: 14 mul, 7 add, 6 sin/cos. Always zero:
// 4 of the 9 entries of R.
template <class Scalar, class SinCos = LibrarySinCos>
inline void forward_kinematics(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* R,
    Scalar* p, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar q_3 = q[2];
  const Scalar a_1 = parameters.a_1, a_2 = parameters.a_2;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_4 = sine[3],
      c_4 = cosine[3];
  p[2] = q_3;
  const Scalar t1 = s_2 * s_4 - c_2 * c_4;
  const Scalar n_2_t_y = s_2 * c_4 + c_2 * s_4;
  const Scalar R_12 = s_1 * t1 - c_1 * n_2_t_y;
  R[1] = R_12;
  const Scalar p_2_x = a_2 * c_2 + a_1;
  const Scalar t2 = a_2 * s_2;
  p[1] = c_1 * t2 + s_1 * p_2_x;
  R[0] = R[4] = -s_1 * n_2_t_y - c_1 * t1;
  R[3] = -R_12;
  p[0] = c_1 * p_2_x - s_1 * t2;
  R[8] = Scalar(1.0);
  R[2] = R[5] = R[6] = R[7] = Scalar(0.0);
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[24] = {
    1, 1, 0, 1,
    1, 1, 0, 1,
    0, 0, 1, 0,
    0, 0, 0, 0,
    0, 0, 0, 0,
    1, 1, 0, 1};

// Geometric Jacobian of the tip (7.14), (7.15).
//   q[4]   in   joint positions, rad or m
//   J[24]  out  geometric Jacobian in base axes: linear rows, then angular
//               6 x 4, row by row: entry (i, j) is J[4 * i + j]
// Reads q[0..1], parameters.a_1, parameters.a_2. Operations: 14 mul, 9 add, 4 sin/cos. Always zero:
// 14 of the 24 entries of J.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* J,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar a_1 = parameters.a_1, a_2 = parameters.a_2;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar p_2_x = a_2 * c_2 + a_1;
  const Scalar t1 = a_2 * s_2;
  const Scalar t2 = s_1 * t1 - c_1 * p_2_x;
  J[4] = -t2;
  const Scalar p_1u_t_y = c_1 * t1 + s_1 * p_2_x;
  J[0] = -p_1u_t_y;
  const Scalar t3 = t2 + a_1 * c_1;
  J[5] = -t3;
  const Scalar t4 = p_1u_t_y - a_1 * s_1;
  J[1] = -t4;
  J[7] = a_2 * (s_1 * s_2 - c_1 * c_2) - t3;
  const Scalar R_21_x = s_1 * c_2 + c_1 * s_2;
  J[3] = a_2 * R_21_x - t4;
  J[10] = J[20] = J[21] = J[23] = Scalar(1.0);
  J[2] = J[6] = J[8] = J[9] = J[11] = J[12] = J[13] = J[14] = Scalar(0.0);
  J[15] = J[16] = J[17] = J[18] = J[19] = J[22] = Scalar(0.0);
}

// (dJ/dt) qd of the tip.
//   q[4]   in   joint positions, rad or m
//   qd[4]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads q[0..1], q[3], qd[0..1], parameters.a_1, parameters.a_2. Operations: 22 mul, 10 add, 6
// sin/cos. Always zero: a[2], a[3], a[4], a[5].
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian_dot_qd(const Parameters<Scalar>& parameters, const Scalar* q, const Scalar* qd,
    Scalar* a, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar a_1 = parameters.a_1, a_2 = parameters.a_2;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_4 = sine[3],
      c_4 = cosine[3];
  const Scalar t1 = qd_1 * a_1 * qd_1;
  const Scalar omega_2_z = qd_1 + qd_2;
  const Scalar t2 = c_2 * t1 + a_2 * omega_2_z * omega_2_z;
  const Scalar t3 = s_2 * t1;
  const Scalar ddp_4_y = c_4 * t3 + s_4 * t2;
  const Scalar t4 = s_4 * t3 - c_4 * t2;
  const Scalar t5 = s_4 * ddp_4_y - c_4 * t4;
  const Scalar a_4_t_y = s_4 * t4 + c_4 * ddp_4_y;
  const Scalar t6 = s_2 * t5 - c_2 * a_4_t_y;
  const Scalar t7 = s_2 * a_4_t_y + c_2 * t5;
  a[0] = s_1 * t6 - c_1 * t7;
  a[1] = -s_1 * t7 - c_1 * t6;
  a[2] = a[3] = a[4] = a[5] = Scalar(0.0);
}

// The functions by type, with the shapes of their arguments: what adapters such as
// flatdyn/eigen.hpp are given.
namespace functions {

struct inverse_dynamics {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[4], const Scalar (&qd)[4],
      const Scalar (&qdd)[4], Scalar (&tau)[4]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::scara::inverse_dynamics(of...); }
};

struct inverse_dynamics_tip_force {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[4], const Scalar (&qd)[4],
      const Scalar (&qdd)[4], const Scalar (&h_e)[6], Scalar (&tau)[4]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::scara::inverse_dynamics_tip_force(of...); }
};

struct inertia_matrix {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[4], Scalar (&B)[4][4]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::scara::inertia_matrix(of...); }
};

struct christoffel {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[4], Scalar (&c)[4][10]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::scara::christoffel(of...); }
};

struct coriolis_matrix {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[4], const Scalar (&qd)[4],
      Scalar (&C)[4][4]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::scara::coriolis_matrix(of...); }
};

struct gravity {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[4], Scalar (&g)[4]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::scara::gravity(of...); }
};

struct bias {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[4], const Scalar (&qd)[4],
      Scalar (&n)[4]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::scara::bias(of...); }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[4], const Scalar (&qd)[4],
      const Scalar (&tau)[4], Scalar (&qdd)[4]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::scara::forward_dynamics(of...); }
};

struct kinetic_energy {
  template <class Scalar>
  using Shape = Scalar(const Parameters<Scalar>&, const Scalar (&q)[4], const Scalar (&qd)[4]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::scara::kinetic_energy(of...); }
};

struct potential_energy {
  template <class Scalar>
  using Shape = Scalar(const Parameters<Scalar>&, const Scalar (&q)[4]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::scara::potential_energy(of...); }
};

struct forward_kinematics {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[4], Scalar (&R)[3][3],
      Scalar (&p)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::scara::forward_kinematics(of...); }
};

struct jacobian {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[4], Scalar (&J)[6][4]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::scara::jacobian(of...); }
};

struct jacobian_dot_qd {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[4], const Scalar (&qd)[4],
      Scalar (&a)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::scara::jacobian_dot_qd(of...); }
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

}  // namespace scara

#endif  // FLATDYN_SCARA_HPP_5DE29C7E

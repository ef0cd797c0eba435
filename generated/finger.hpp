// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "finger" as flat code: 3 joints.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Input: sha1:c7fe660c158b2059dcb0dd7eba82acfca6ab87d7
//
//   index  joint   moves link  type      unit  lower  upper  speed  acceleration  effort
//   0      spread  knuckle     revolute  rad   -0.35  0.35   6      60            0.5
//   1      mcp     proximal    revolute  rad   -0.35  1.57   6      60            0.5
//   2      pip     middle      revolute  rad   0      1.9    6      60            0.3
//
// Gravity is (0, -9.81, 0) m/s^2 in the base frame. The tip belongs to link "distal". Coupled
// joints, rad or m: dip = 2/3 q[2]; q, qd, qdd and tau are those of the joints above.
//
// Every function is a template over its scalar: float, double, or any type that is made from a
// double, has + - * / (also - of one), comparisons, and sin, cos where argument-dependent lookup
// finds them (or an argument that knows them, see LibrarySinCos). Arguments are plain arrays:
//
//   double q[3] = {}, qd[3] = {}, qdd[3] = {}, tau[3];
//   finger::inverse_dynamics(q, qd, qdd, tau);
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

#ifndef FLATDYN_FINGER_HPP_D97471FE
#define FLATDYN_FINGER_HPP_D97471FE

#include <cmath>

namespace finger {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 3;

// Sines and cosines, by index, are those of so many angles: of q's entries, and then of 2/3 q[2],
// by which coupled joints turn.
inline constexpr int angle_count = 4;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {"spread", "mcp", "pip"};

// Smallest position, rad or m.
inline constexpr Real position_lower[joint_count] = {Real(-0.35), Real(-0.35), Real(0.0)};

// Largest position, rad or m.
inline constexpr Real position_upper[joint_count] = {Real(0.35), Real(1.57), Real(1.9)};

// Largest speed, rad/s or m/s.
inline constexpr Real velocity_limit[joint_count] = {Real(6.0), Real(6.0), Real(6.0)};

// Largest acceleration, rad/s^2 or m/s^2.
inline constexpr Real acceleration_limit[joint_count] = {Real(60.0), Real(60.0), Real(60.0)};

// Largest torque or force, N m or N.
inline constexpr Real effort_limit[joint_count] = {Real(0.5), Real(0.5), Real(0.3)};

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

namespace detail {

// What sines and cosines are asked of.
template <class Scalar>
void angles(const Scalar* q, Scalar* angle) noexcept {
  angle[0] = q[0];
  angle[1] = q[1];
  angle[2] = q[2];
  angle[3] = Scalar(0.6666666666666666) * q[2];
}

}  // namespace detail

// tau = B(q) qdd + C(q, qd) qd + g(q) + friction (7.42).
//   q[3]    in   joint positions, rad or m
//   qd[3]   in   joint velocities, rad/s or m/s
//   qdd[3]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[3]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..2], qd[0..2], qdd[0..2]. Operations: 83 mul, 55 add, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2];
  Scalar angle[angle_count], sine[angle_count], cosine[angle_count];
  detail::angles(q, angle);
  sin_cos(angle, Joints<1, 2, 3>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3];
  const Scalar t1 = s_2 * s_3 - c_2 * c_3;
  const Scalar t2 = c_2 * s_3 + s_2 * c_3;
  const Scalar t3 = s_4 * t1 - c_4 * t2;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_4_z = Scalar(0.6666666666666666) * qd_3 + omega_3_z;
  const Scalar t4 = Scalar(2.0) * qd_1;
  const Scalar t5 = s_4 * t2 + c_4 * t1;
  const Scalar t6 = t4 * t3 * omega_4_z - qdd_1 * t5;
  const Scalar t7 = qdd_1 * t1 + t4 * t2 * omega_3_z;
  const Scalar t8 = s_2 * qd_2 * t4 - c_2 * qdd_1;
  const Scalar t9 = t8 + Scalar(0.5555555555555556) * t7;
  const Scalar t10 = Scalar(1.2e-06) * t6 - Scalar(4.05e-06) * t9;
  const Scalar t11 = Scalar(4.05e-06) * t6 - Scalar(0.000018225) * t9;
  const Scalar t12 = Scalar(2.5e-06) * t7 - c_4 * t10 + Scalar(6.75e-06) * t8 -
      Scalar(0.5555555555555556) * t11;
  const Scalar t13 = s_4 * t10;
  const Scalar t14 = s_3 * t13 + Scalar(6.75e-06) * t7 + c_3 * t12 - t11 + Scalar(0.0000378) * t8;
  tau[0] = s_2 * (s_3 * t12 - c_3 * t13) - c_2 * t14;
  const Scalar t15 = qd_1 * qd_1;
  const Scalar t16 = s_2 * t15;
  const Scalar t17 = t15 + qd_2 * qd_2 - s_2 * (t16 + Scalar(218.0));
  const Scalar U_2_yx = c_2 * t16 + qdd_2;
  const Scalar ddp_o_3_y = U_2_yx + Scalar(218.0) * c_2;
  const Scalar t18 = s_3 * t17 + c_3 * ddp_o_3_y;
  const Scalar t19 = t15 * t2;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar U_3_yx = domega_3_z - t1 * t19;
  const Scalar ddp_o_4_y = Scalar(0.5555555555555556) * U_3_yx + t18;
  const Scalar t20 = t15 - t2 * t19 + omega_3_z * omega_3_z;
  const Scalar t21 = Scalar(0.5555555555555556) * t20 - s_3 * ddp_o_3_y + c_3 * t17;
  const Scalar t22 = t15 * t3;
  const Scalar t23 = t15 - t3 * t22 + omega_4_z * omega_4_z;
  const Scalar t24 = Scalar(4.05e-06) * t23 - Scalar(0.000018225) * (s_4 * ddp_o_4_y - c_4 * t21);
  const Scalar ddp_4_y = s_4 * t21 + c_4 * ddp_o_4_y;
  const Scalar U_4_yx = Scalar(0.6666666666666666) * qdd_3 + t5 * t22 + domega_3_z;
  const Scalar F_4_y = Scalar(4.05e-06) * U_4_yx + Scalar(0.000018225) * ddp_4_y;
  const Scalar t25 = s_4 * t24 - c_4 * F_4_y;
  const Scalar N_4_z = Scalar(1.2e-06) * U_4_yx + Scalar(4.05e-06) * ddp_4_y;
  const Scalar mu_3_z = Scalar(2.5e-06) * U_3_yx + N_4_z + Scalar(6.75e-06) * t18 -
      Scalar(0.5555555555555556) * t25;
  tau[2] = Scalar(0.6666666666666666) * N_4_z + mu_3_z;
  const Scalar f_3_y = Scalar(6.75e-06) * U_3_yx - t25;
  const Scalar t26 = s_3 * (Scalar(6.75e-06) * t20 + s_4 * F_4_y + c_4 * t24);
  tau[1] = Scalar(0.0000378) * U_2_yx + mu_3_z - t26 + c_3 * f_3_y + Scalar(0.0097119) * c_2;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[3]    in   joint positions, rad or m
//   qd[3]   in   joint velocities, rad/s or m/s
//   qdd[3]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[3]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..2], qd[0..2], qdd[0..2], h_e[0..5]. Operations: 112 mul, 73 add, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics_tip_force(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    const Scalar* h_e, Scalar* tau, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2];
  const Scalar h_e_1 = h_e[0], h_e_2 = h_e[1], h_e_3 = h_e[2], h_e_4 = h_e[3], h_e_5 = h_e[4],
      h_e_6 = h_e[5];
  Scalar angle[angle_count], sine[angle_count], cosine[angle_count];
  detail::angles(q, angle);
  sin_cos(angle, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  const Scalar t1 = s_2 * s_3 - c_2 * c_3;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t2 = s_4 * t1 - c_4 * s_2_3;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_4_z = Scalar(0.6666666666666666) * qd_3 + omega_3_z;
  const Scalar t3 = s_4 * s_2_3 + c_4 * t1;
  const Scalar t4 = Scalar(2.0) * t2 * qd_1 * omega_4_z - t3 * qdd_1;
  const Scalar t5 = Scalar(0.5) * t1 * qdd_1 + s_2_3 * qd_1 * omega_3_z;
  const Scalar t6 = Scalar(0.045) * c_2;
  const Scalar t7 = Scalar(0.09) * s_2 * qd_1 * qd_2 - qdd_1 * t6;
  const Scalar t8 = Scalar(0.05) * t5 + t7;
  const Scalar f_e2_a_z = s_1 * h_e_1 + c_1 * h_e_3;
  const Scalar f_4_z = Scalar(0.009) * t8 - Scalar(0.00009) * t4 + f_e2_a_z;
  const Scalar t9 = c_2 * (t7 + Scalar(53.57142857142857) * (Scalar(0.0003) * t5 + f_4_z));
  const Scalar t10 = t1 * (t5 + Scalar(30.0) * (t7 + Scalar(166.66666666666666) * f_4_z));
  const Scalar t11 = s_1 * h_e_6 - c_1 * h_e_4;
  const Scalar t12 = Scalar(0.00009) * t8 - Scalar(1.2e-06) * t4 + Scalar(0.02) * f_e2_a_z +
      t2 * t11 + t3 * h_e_5;
  const Scalar t13 = t2 * (t2 * h_e_5 - t3 * t11);
  tau[0] = Scalar(5e-06) * t10 - Scalar(0.00084) * t9 + t13 + t3 * t12;
  const Scalar t14 = qd_1 * qd_1;
  const Scalar t15 = t2 * t14;
  const Scalar t16 = t14 - t2 * t15 + omega_4_z * omega_4_z;
  const Scalar t17 = omega_3_z * omega_3_z;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar t18 = t1 * domega_3_z;
  const Scalar t19 = s_2_3 * t17 + t18;
  const Scalar t20 = qd_2 * qd_2;
  const Scalar t21 = c_2 * qdd_2;
  const Scalar t22 = Scalar(0.045) * (s_2 * t20 - t21) - Scalar(9.81);
  const Scalar t23 = Scalar(0.025) * t19 + t22;
  const Scalar t24 = s_2_3 * domega_3_z - t1 * (t14 + t17);
  const Scalar t25 = Scalar(0.045) * s_2 * qdd_2 + (t20 + t14) * t6;
  const Scalar t26 = Scalar(0.025) * t24 + t25;
  const Scalar t27 = t3 * t26 + t2 * t23;
  const Scalar t28 = s_1 * h_e_3 - c_1 * h_e_1;
  const Scalar t29 = Scalar(0.00009) * t16 - Scalar(0.009) * t27 + t2 * h_e_2 - t3 * t28;
  const Scalar U_4_yx = Scalar(0.6666666666666666) * qdd_3 + t3 * t15 + domega_3_z;
  const Scalar t30 = t2 * t26 - t3 * t23;
  const Scalar t31 = t2 * t28 + t3 * h_e_2;
  const Scalar t32 = Scalar(0.009) * t30 - Scalar(0.00009) * U_4_yx + t31;
  const Scalar t33 = s_4 * t29 + c_4 * t32;
  const Scalar t34 = Scalar(0.00009) * t30 - Scalar(1.2e-06) * U_4_yx + Scalar(0.02) * t31 -
      s_1 * h_e_4 - c_1 * h_e_6;
  const Scalar t35 = Scalar(-2.5e-06) * t1;
  const Scalar t36 = domega_3_z * (t1 * t35 + Scalar(2.5e-06));
  const Scalar t37 = s_2_3 * t25 + t1 * t22;
  const Scalar t38 = t35 * (t18 - s_2_3 * t14);
  const Scalar t39 = t38 - t36 - Scalar(0.00015) * t37 + Scalar(0.025) * t33 + t34;
  tau[2] = Scalar(-0.6666666666666666) * t34 - t39;
  const Scalar t40 = c_2 * ((Scalar(0.00015) * t19 - t2 * t29 - t3 * t32) - Scalar(0.21582));
  const Scalar t41 = s_2 * (Scalar(0.00015) * t24 + t2 * t32 - t3 * t29) - t40;
  const Scalar t42 = Scalar(0.0000378) * c_2;
  const Scalar t43 = qdd_2 * (c_2 * t42 - Scalar(0.0000378));
  tau[1] = t42 * (t21 + s_2 * t14) - t43 + Scalar(0.045) * t41 - t39;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[9] = {
    1, 0, 0,
    0, 1, 1,
    0, 1, 1};

// Joint-space inertia matrix B(q) (7.32).
//   q[3]  in   joint positions, rad or m
//   B[9]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//              3 x 3, row by row: entry (i, j) is B[3 * i + j]
// Reads q[1..2]. Operations: 30 mul, 18 add, 6 sin/cos. Always zero: 4 of the 9 entries of B.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inertia_matrix(const Scalar* q, Scalar* B, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar angle[angle_count], sine[angle_count], cosine[angle_count];
  detail::angles(q, angle);
  sin_cos(angle, Joints<1, 2, 3>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3];
  B[8] = Scalar(7.5e-06) * c_4 + Scalar(0.000011458333333333333);
  const Scalar t1 = c_2 * c_3 - s_2 * s_3;
  const Scalar s_2_3 = c_2 * s_3 + s_2 * c_3;
  const Scalar t2 = c_4 * t1 - s_4 * s_2_3;
  const Scalar t3 = c_2 * (Scalar(4.05e-06) * t2 + Scalar(0.000016875) * t1);
  const Scalar t4 = t1 * (Scalar(0.5538461538461539) * t2 + t1);
  B[0] = Scalar(1.2e-06) * t2 * t2 + Scalar(8.125e-06) * t4 + Scalar(0.000056025) * c_2 * c_2 +
      Scalar(2.0) * t3;
  const Scalar t5 = c_4 * s_2_3 + s_4 * t1;
  const Scalar hc_3_y = Scalar(4.05e-06) * t5 + Scalar(0.000016875) * s_2_3;
  const Scalar t6 = t3 + s_2 * hc_3_y;
  B[4] = Scalar(4.5e-06) * c_4 + Scalar(2.0) * t6 + Scalar(0.00006535);
  const Scalar t7 = c_2 * t2 + s_2 * t5;
  B[5] = B[7] = Scalar(2.7e-06) * t7 + Scalar(6e-06) * c_4 + t6 + Scalar(0.000010125);
  B[1] = B[2] = B[3] = B[6] = Scalar(0.0);
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[18] = {
    0, 1, 0, 1, 0, 0,
    1, 0, 0, 0, 1, 1,
    1, 0, 1, 0, 0, 1};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[3]   in   joint positions, rad or m
//   c[18]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//               c_ijk = c_ikj is c[6 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads q[1..2]. Operations: 41 mul, 24 add, 6 sin/cos. Always zero: 10 of the 18 entries of c.
template <class Scalar, class SinCos = LibrarySinCos>
inline void christoffel(const Scalar* q, Scalar* c, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar angle[angle_count], sine[angle_count], cosine[angle_count];
  detail::angles(q, angle);
  sin_cos(angle, Joints<1, 2, 3>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3];
  const Scalar s_2_3 = c_2 * s_3 + s_2 * c_3;
  const Scalar t1 = c_2 * c_3 - s_2 * s_3;
  const Scalar t2 = c_4 * s_2_3 + s_4 * t1;
  const Scalar t3 = t1 * t2;
  const Scalar t4 = c_4 * t1 - s_4 * s_2_3;
  const Scalar t5 = s_2_3 * t4;
  const Scalar t6 = t3 - t5;
  c[17] = Scalar(-2.5e-06) * t6;
  const Scalar t7 = t4 * t2;
  const Scalar t8 = Scalar(6e-07) * t7 + Scalar(1.125e-06) * (t3 + t5) +
      Scalar(4.0625e-06) * t1 * s_2_3;
  const Scalar hc_3_y = Scalar(2.025e-06) * t2 + Scalar(8.4375e-06) * s_2_3;
  const Scalar t9 = c_2 * hc_3_y;
  const Scalar t10 = t8 + t9;
  const Scalar v_o_2_4_y = Scalar(0.5555555555555556) * t1 + c_2;
  const Scalar t11 = t2 * v_o_2_4_y;
  const Scalar c_q3_1_1 = Scalar(8e-07) * t7 + Scalar(2.7e-06) * t11 + Scalar(2.0) * t10;
  c[12] = c_q3_1_1;
  const Scalar t12 = s_2 * (Scalar(2.025e-06) * t4 + Scalar(8.4375e-06) * t1);
  const Scalar t13 = Scalar(2.0) * (t9 - t12);
  const Scalar t14 = t11 - t4 * (Scalar(0.5555555555555556) * s_2_3 + s_2);
  const Scalar c_q3_2_2 = Scalar(2.7e-06) * t14 + t13;
  c[14] = c_q3_2_2;
  const Scalar t15 = t10 + t12 + Scalar(0.0000280125) * c_2 * s_2;
  c[1] = Scalar(-2.0) * t15;
  c[6] = Scalar(2.0) * t15;
  c[3] = -c_q3_1_1;
  c[10] = -c_q3_2_2;
  const Scalar t16 = c_2 * t2 - s_2 * t4;
  c[11] = Scalar(-1.5e-06) * t6 - Scalar(2.7e-06) * t16 - Scalar(4.5e-06) * t14 - t13;
  c[0] = c[2] = c[4] = c[5] = c[7] = c[8] = c[9] = c[13] = Scalar(0.0);
  c[15] = c[16] = Scalar(0.0);
}

// The entries of C in coriolis_matrix that are not always zero.
inline constexpr bool coriolis_matrix_nonzero[9] = {
    1, 1, 1,
    1, 1, 1,
    1, 1, 1};

// C(q, qd) from the Christoffel symbols (7.44).
//   q[3]   in   joint positions, rad or m
//   qd[3]  in   joint velocities, rad/s or m/s
//   C[9]   out  c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric
//               3 x 3, row by row: entry (i, j) is C[3 * i + j]
// Reads q[1..2], qd[0..2]. Operations: 48 mul, 26 add, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2];
  Scalar angle[angle_count], sine[angle_count], cosine[angle_count];
  detail::angles(q, angle);
  sin_cos(angle, Joints<1, 2, 3>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3];
  const Scalar s_2_3 = c_2 * s_3 + s_2 * c_3;
  const Scalar t1 = c_2 * c_3 - s_2 * s_3;
  const Scalar t2 = c_4 * s_2_3 + s_4 * t1;
  const Scalar t3 = t1 * t2;
  const Scalar t4 = c_4 * t1 - s_4 * s_2_3;
  const Scalar t5 = s_2_3 * t4;
  const Scalar t6 = t3 - t5;
  C[8] = Scalar(-2.5e-06) * qd_3 * t6;
  const Scalar hc_3_y = Scalar(2.025e-06) * t2 + Scalar(8.4375e-06) * s_2_3;
  const Scalar t7 = c_2 * hc_3_y;
  const Scalar t8 = s_2 * (Scalar(2.025e-06) * t4 + Scalar(8.4375e-06) * t1);
  const Scalar t9 = Scalar(2.0) * (t7 - t8);
  const Scalar v_o_2_4_y = Scalar(0.5555555555555556) * t1 + c_2;
  const Scalar t10 = t2 * v_o_2_4_y;
  const Scalar t11 = t10 - t4 * (Scalar(0.5555555555555556) * s_2_3 + s_2);
  const Scalar t12 = Scalar(2.7e-06) * t11 + t9;
  const Scalar C_32 = qd_2 * t12;
  C[7] = C_32;
  const Scalar t13 = t4 * t2;
  const Scalar t14 = Scalar(6e-07) * t13 + Scalar(1.125e-06) * (t3 + t5) +
      Scalar(4.0625e-06) * t1 * s_2_3;
  const Scalar t15 = Scalar(-2.0) * (t14 + t7);
  const Scalar t16 = Scalar(2.0) * t8 - t15 + Scalar(0.000056025) * c_2 * s_2;
  const Scalar C_21 = qd_1 * t16;
  C[3] = C_21;
  const Scalar c_q3_1_1 = Scalar(8e-07) * t13 + Scalar(2.7e-06) * t10 - t15;
  const Scalar C_31 = qd_1 * c_q3_1_1;
  C[6] = C_31;
  C[4] = -qd_3 * t12;
  C[1] = -C_21;
  C[2] = -C_31;
  const Scalar t17 = c_2 * t2 - s_2 * t4;
  const Scalar t18 = qd_3 * (Scalar(1.5e-06) * t6 + Scalar(2.7e-06) * t17 + Scalar(4.5e-06) * t11 +
      t9);
  C[5] = -C_32 - t18;
  C[0] = -qd_3 * c_q3_1_1 - qd_2 * t16;
}

// Gravity torques g(q) (7.39).
//   q[3]  in   joint positions, rad or m
//   g[3]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..2]. Operations: 11 mul, 6 add, 6 sin/cos. Always zero: g[0].
template <class Scalar, class SinCos = LibrarySinCos>
inline void gravity(const Scalar* q, Scalar* g, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar angle[angle_count], sine[angle_count], cosine[angle_count];
  detail::angles(q, angle);
  sin_cos(angle, Joints<1, 2, 3>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3];
  const Scalar c_2_3 = c_2 * c_3 - s_2 * s_3;
  const Scalar s_2_3 = c_2 * s_3 + s_2 * c_3;
  const Scalar c_2_3_4 = c_4 * c_2_3 - s_4 * s_2_3;
  const Scalar hc_3_x = Scalar(0.0008829) * c_2_3_4 + Scalar(0.00367875) * c_2_3;
  g[1] = hc_3_x + Scalar(0.01368495) * c_2;
  g[2] = Scalar(0.0005886) * c_2_3_4 + hc_3_x;
  g[0] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[3]   in   joint positions, rad or m
//   qd[3]  in   joint velocities, rad/s or m/s
//   n[3]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..2], qd[0..2]. Operations: 64 mul, 37 add, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2];
  Scalar angle[angle_count], sine[angle_count], cosine[angle_count];
  detail::angles(q, angle);
  sin_cos(angle, Joints<1, 2, 3>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3];
  const Scalar t1 = s_2 * s_3 - c_2 * c_3;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t2 = s_4 * t1 - c_4 * s_2_3;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_4_z = Scalar(0.6666666666666666) * qd_3 + omega_3_z;
  const Scalar t3 = t2 * omega_4_z;
  const Scalar t4 = qd_1 * t3;
  const Scalar t5 = s_2_3 * omega_3_z;
  const Scalar t6 = qd_1 * t5;
  const Scalar t7 = s_2 * qd_2;
  const Scalar t8 = qd_1 * t7;
  const Scalar ddp_o_4_z = Scalar(2.0) * t6 + Scalar(3.6) * t8;
  const Scalar F_4_z = Scalar(5.625e-06) * ddp_o_4_z - Scalar(4.5e-06) * t4;
  const Scalar f_3_z = Scalar(7.5e-06) * t6 + F_4_z;
  const Scalar t9 = t1 * (Scalar(0.0000135) * t8 + (Scalar(5e-06) * t6 + F_4_z));
  const Scalar t10 = s_4 * s_2_3 + c_4 * t1;
  const Scalar t11 = Scalar(-2.25e-06) * t10;
  const Scalar t12 = t11 * (ddp_o_4_z - Scalar(1.0666666666666667) * t4);
  n[0] = t9 - t12 - Scalar(0.0000756) * c_2 * (t8 + Scalar(23809.52380952381) * f_3_z);
  const Scalar t13 = omega_3_z * t5;
  const Scalar t14 = Scalar(1.8) * qd_2 * t7 - Scalar(392.4);
  const Scalar t15 = t13 + t14;
  const Scalar t16 = Scalar(5.625e-06) * t15 - Scalar(2.25e-06) * omega_4_z * t3;
  const Scalar t17 = qd_1 * qd_1;
  const Scalar t18 = t1 * (Scalar(3.75e-06) * t14 + (t16 - Scalar(2.5e-06) * s_2_3 * t17));
  const Scalar t19 = t1 * (t17 + omega_3_z * omega_3_z);
  const Scalar t20 = c_2 * (qd_2 * qd_2 + t17);
  const Scalar t21 = t19 - Scalar(1.8) * t20;
  const Scalar t22 = Scalar(5.625e-06) * t21 - (t17 + omega_4_z * omega_4_z) * t11;
  const Scalar t23 = t15 * t11 - Scalar(2.25e-06) * t2 *
      (Scalar(0.5333333333333333) * t10 * t17 + t21);
  const Scalar t24 = t23 - s_2_3 * (Scalar(6.75e-06) * t20 - t22) - t18;
  const Scalar t25 = s_2 * ((Scalar(3.75e-06) * t19 + t22) - Scalar(0.000021) * c_2 * t17);
  n[1] = -t24 - Scalar(1.8) * (t25 + c_2 * ((Scalar(3.75e-06) * t13 + t16) - Scalar(0.0053955)));
  n[2] = Scalar(-0.6666666666666666) * t23 - t24;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[3]    in   joint positions, rad or m
//   qd[3]   in   joint velocities, rad/s or m/s
//   tau[3]  in   joint torques or forces, N m or N
//   qdd[3]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[1..2], qd[0..2], tau[0..2]. Operations: 82 mul, 56 add, 3 div, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2];
  const Scalar tau_1 = tau[0], tau_2 = tau[1], tau_3 = tau[2];
  Scalar angle[angle_count], sine[angle_count], cosine[angle_count];
  detail::angles(q, angle);
  sin_cos(angle, Joints<1, 2, 3>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3];
  const Scalar s_2_3 = c_2 * s_3 + s_2 * c_3;
  const Scalar t1 = c_2 * c_3 - s_2 * s_3;
  const Scalar t2 = c_4 * s_2_3 + s_4 * t1;
  const Scalar t3 = t1 * t2;
  const Scalar t4 = c_4 * t1 - s_4 * s_2_3;
  const Scalar t5 = s_2_3 * t4;
  const Scalar t6 = Scalar(-1.2e-06) * t4;
  const Scalar t7 = Scalar(-8.125e-06) * t1;
  const Scalar t8 = Scalar(2.25e-06) * (t3 + t5) - t2 * t6 - s_2_3 * t7;
  const Scalar t9 = Scalar(8e-07) * t4 * t2 + t8;
  const Scalar t10 = qd_1 * qd_1;
  const Scalar t11 = Scalar(2.0) * qd_2;
  const Scalar beta_4_f = t11 + Scalar(2.6666666666666665) * qd_3;
  const Scalar t12 = Scalar(1.5e-06) * qd_3 * beta_4_f * (t3 - t5);
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t13 = omega_3_z * omega_3_z;
  const Scalar t14 = qd_2 * qd_2;
  const Scalar t15 = s_2 * t14 - Scalar(218.0);
  const Scalar t16 = c_2 * (t10 + t14);
  const Scalar t17 = t2 * (Scalar(0.5555555555555556) * t1 * (t10 + t13) + t16);
  const Scalar t18 = t4 * (Scalar(0.5555555555555556) * s_2_3 * t13 + t15) - t17;
  const Scalar t19 = Scalar(4.05e-06) * t4 + Scalar(0.000016875) * t1;
  const Scalar hc_3_y = Scalar(4.05e-06) * t2 + Scalar(0.000016875) * s_2_3;
  const Scalar y_3 = t12 - t10 * t9 - hc_3_y * t16 + Scalar(2.7e-06) * t18 + t19 * t15 + tau_3;
  const Scalar t20 = Scalar(-2.7e-06) * t2;
  const Scalar t21 = hc_3_y - t20;
  const Scalar t22 = Scalar(-2.7e-06) * t4;
  const Scalar b_3_2h = Scalar(6e-06) * c_4 + s_2 * t21 + c_2 * (t19 - t22) + Scalar(0.000010125);
  const Scalar b_3_3q = Scalar(7.5e-06) * c_4 + Scalar(0.000011458333333333333);
  const Scalar d_3 = Scalar(1.0) / b_3_3q;
  const Scalar t23 = b_3_2h * d_3;
  const Scalar beta_3_f = qd_3 + t11;
  const Scalar t24 = c_2 * (qd_3 * (t20 * beta_4_f - hc_3_y * beta_3_f) + Scalar(0.01368495));
  const Scalar t25 = t8 + s_2 * t19 + c_2 * (hc_3_y + Scalar(0.000056025) * s_2);
  const Scalar t26 = s_2 * qd_3 * (t22 * beta_4_f - t19 * beta_3_f);
  const Scalar t27 = -t12 - t26 + t25 * t10 + Scalar(218.0) * t19 + t24 - tau_2 + t23 * y_3;
  const Scalar t28 = c_2 * t19 + s_2 * hc_3_y;
  const Scalar b_3_2_2 = Scalar(4.5e-06) * c_4 + Scalar(2.0) * t28 - b_3_2h * t23 +
      Scalar(0.00006535);
  const Scalar t29 = t27 / b_3_2_2;
  qdd[1] = -t29;
  const Scalar t30 = qd_3 * (Scalar(1.5e-06) * t3 + t9 + c_2 * t21) + t25 * qd_2;
  const Scalar y_1 = Scalar(2.0) * qd_1 * t30 + tau_1;
  const Scalar t31 = t7 * (Scalar(0.5538461538461539) * t4 + t1);
  const Scalar t32 = t4 * t6 + t31 -
      Scalar(0.000056025) * c_2 * (Scalar(35698.348951361) * t19 + c_2);
  qdd[0] = -y_1 / t32;
  qdd[2] = d_3 * (b_3_2h * t29 + y_3);
  bool positive = -t32 > Scalar(0.0);
  positive &= b_3_2_2 > Scalar(0.0);
  positive &= b_3_3q > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[3]   in  joint positions, rad or m
//   qd[3]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1..2], qd[0..2]. Operations: 39 mul, 21 add, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar kinetic_energy(const Scalar* q, const Scalar* qd,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2];
  Scalar angle[angle_count], sine[angle_count], cosine[angle_count];
  detail::angles(q, angle);
  sin_cos(angle, Joints<1, 2, 3>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3];
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = s_2 * qd_1;
  const Scalar omega_r_3_x = s_3 * t1 + c_3 * t2;
  const Scalar t3 = s_3 * t2 - c_3 * t1;
  const Scalar t4 = s_4 * omega_r_3_x + c_4 * t3;
  const Scalar t5 = t1 - Scalar(0.5555555555555556) * t3;
  const Scalar L_4_y = Scalar(8.1e-06) * t5 - Scalar(1.2e-06) * t4;
  const Scalar t6 = c_3 * qd_2;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar v_o_4_y = Scalar(0.5555555555555556) * omega_3_z + t6;
  const Scalar t7 = s_3 * qd_2;
  const Scalar t8 = s_4 * t7 - c_4 * v_o_4_y;
  const Scalar v_r_4_x = c_4 * t7 + s_4 * v_o_4_y;
  const Scalar v_v_4 = t8 * t8 + v_r_4_x * v_r_4_x + t5 * t5;
  const Scalar omega_4_z = Scalar(0.6666666666666666) * qd_3 + omega_3_z;
  const Scalar t9 = omega_4_z * (Scalar(8.1e-06) * t8 - Scalar(1.2e-06) * omega_4_z);
  const Scalar L_3_y = Scalar(0.0000135) * t1 - Scalar(2.5e-06) * t3;
  const Scalar L_3_z = Scalar(2.5e-06) * omega_3_z + Scalar(0.0000135) * t6;
  const Scalar T_2 = -t4 * L_4_y - t3 * L_3_y - t9 + Scalar(0.000018225) * v_v_4 +
      omega_3_z * L_3_z + Scalar(0.0000378) * t1 * t1 + Scalar(0.0000378) * qd_2 * qd_2;
  return Scalar(0.5) * T_2;
}

// Potential energy of links and rotors (7.36).
//   q[3]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[1..2]. Operations: 10 mul, 5 add, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar potential_energy(const Scalar* q, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar angle[angle_count], sine[angle_count], cosine[angle_count];
  detail::angles(q, angle);
  sin_cos(angle, Joints<1, 2, 3>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3];
  const Scalar t1 = Scalar(0.00009) * s_4;
  const Scalar hc_3_x = Scalar(0.00009) * c_4 + Scalar(0.000375);
  const Scalar hu_3_t_y = c_3 * t1 + s_3 * hc_3_x;
  const Scalar t2 = s_2 * (s_3 * t1 - c_3 * hc_3_x - Scalar(0.001395)) - c_2 * hu_3_t_y;
  return Scalar(-9.81) * t2;
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    1, 1, 1,
    1, 1, 0,
    1, 1, 1};

// Pose of the tip (2.50).
//   q[3]  in   joint positions, rad or m
//   R[9]  out  rotation matrix of the frame in the base frame
//              3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]  out  position of the frame's origin in the base frame, m
// Reads q[0..2]. Operations: 24 mul, 10 add, 8 sin/cos. Always zero: 1 of the 9 entries of R.
template <class Scalar, class SinCos = LibrarySinCos>
inline void forward_kinematics(const Scalar* q, Scalar* R, Scalar* p,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar angle[angle_count], sine[angle_count], cosine[angle_count];
  detail::angles(q, angle);
  sin_cos(angle, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  R[8] = c_1;
  R[2] = s_1;
  const Scalar t1 = s_3 * s_4;
  const Scalar n_3_t_x = c_3 * c_4 - t1;
  const Scalar t2 = c_3 * s_4;
  const Scalar n_3_t_y = t2 + s_3 * c_4;
  const Scalar n_2_t_x = c_2 * n_3_t_x - s_2 * n_3_t_y;
  R[4] = n_2_t_x;
  const Scalar n_2_t_y = c_2 * n_3_t_y + s_2 * n_3_t_x;
  R[3] = n_2_t_y;
  R[0] = c_1 * n_2_t_x;
  R[7] = s_1 * n_2_t_y;
  R[6] = -s_1 * n_2_t_x;
  R[1] = -c_1 * n_2_t_y;
  const Scalar p_4_x = Scalar(0.02) * c_4 + Scalar(0.025);
  const Scalar t3 = (Scalar(0.02) * t1 - c_3 * p_4_x) - Scalar(0.045);
  const Scalar p_3u_t_y = Scalar(0.02) * t2 + s_3 * p_4_x;
  p[1] = c_2 * p_3u_t_y - s_2 * t3;
  const Scalar t4 = s_2 * p_3u_t_y + c_2 * t3;
  p[2] = s_1 * t4;
  p[0] = -c_1 * t4;
  R[5] = Scalar(0.0);
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[18] = {
    1, 1, 1,
    0, 1, 1,
    1, 1, 1,
    0, 1, 1,
    1, 0, 0,
    0, 1, 1};

// Geometric Jacobian of the tip (7.14), (7.15).
//   q[3]   in   joint positions, rad or m
//   J[18]  out  geometric Jacobian in base axes: linear rows, then angular
//               6 x 3, row by row: entry (i, j) is J[3 * i + j]
// Reads q[0..2]. Operations: 29 mul, 12 add, 8 sin/cos. Always zero: 5 of the 18 entries of J.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian(const Scalar* q, Scalar* J, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar angle[angle_count], sine[angle_count], cosine[angle_count];
  detail::angles(q, angle);
  sin_cos(angle, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  J[16] = c_1;
  J[10] = s_1;
  J[11] = Scalar(1.6666666666666667) * s_1;
  J[17] = Scalar(1.6666666666666667) * c_1;
  const Scalar p_4_x = Scalar(0.02) * c_4 + Scalar(0.025);
  const Scalar t1 = Scalar(0.02) * s_4;
  const Scalar p_3u_t_y = c_3 * t1 + s_3 * p_4_x;
  const Scalar t2 = s_3 * t1 - c_3 * p_4_x - Scalar(0.045);
  const Scalar t3 = s_2 * p_3u_t_y + c_2 * t2;
  J[4] = -t3;
  J[0] = s_1 * t3;
  J[6] = c_1 * t3;
  const Scalar t4 = s_2 * t2 - c_2 * p_3u_t_y;
  J[1] = c_1 * t4;
  J[7] = -s_1 * t4;
  const Scalar R_31_x = s_2 * c_3 + c_2 * s_3;
  const Scalar t5 = Scalar(0.016666666666666666) * R_31_x + Scalar(0.075) * s_2 +
      Scalar(1.6666666666666667) * t4;
  J[2] = c_1 * t5;
  const Scalar t6 = s_2 * s_3 - c_2 * c_3;
  J[5] = Scalar(0.016666666666666666) * t6 -
      Scalar(1.6666666666666667) * (Scalar(0.045) * c_2 + t3);
  J[8] = -s_1 * t5;
  J[12] = Scalar(1.0);
  J[3] = J[9] = J[13] = J[14] = J[15] = Scalar(0.0);
}

// (dJ/dt) qd of the tip.
//   q[3]   in   joint positions, rad or m
//   qd[3]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads q[0..2], qd[0..2]. Operations: 76 mul, 36 add, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2];
  Scalar angle[angle_count], sine[angle_count], cosine[angle_count];
  detail::angles(q, angle);
  sin_cos(angle, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  const Scalar t1 = c_2 * s_3;
  const Scalar t2 = t1 + s_2 * c_3;
  const Scalar t3 = c_2 * c_3;
  const Scalar t4 = s_2 * s_3 - t3;
  const Scalar t5 = s_4 * t2 + c_4 * t4;
  const Scalar t6 = s_4 * t4 - c_4 * t2;
  const Scalar t7 = s_4 * t5 - c_4 * t6;
  const Scalar omega_4_z = qd_2 + Scalar(1.6666666666666667) * qd_3;
  const Scalar t8 = qd_1 * omega_4_z;
  const Scalar t9 = s_3 * t8;
  const Scalar t10 = s_4 * t6 + c_4 * t5;
  const Scalar t11 = c_3 * t8;
  const Scalar domega_e_3_t_x = t7 * t9 - t10 * t11;
  const Scalar t12 = t10 * t9 + t7 * t11;
  a[4] = s_2 * domega_e_3_t_x - c_2 * t12;
  const Scalar domega_e_2_t_x = s_2 * t12 + c_2 * domega_e_3_t_x;
  a[3] = c_1 * domega_e_2_t_x;
  a[5] = -s_1 * domega_e_2_t_x;
  const Scalar t13 = qd_1 * qd_1;
  const Scalar t14 = t13 * t6;
  const Scalar t15 = t13 - t6 * t14 + omega_4_z * omega_4_z;
  const Scalar t16 = s_2 * t13;
  const Scalar t17 = qd_2 * qd_2 - s_2 * t16 + t13;
  const Scalar t18 = t13 * t2;
  const Scalar ddp_o_4_y = Scalar(0.045) * (t16 * t3 + s_3 * t17) - Scalar(0.025) * t4 * t18;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t19 = t13 - t2 * t18 + omega_3_z * omega_3_z;
  const Scalar t20 = Scalar(0.025) * t19 - Scalar(0.045) * (t16 * t1 - c_3 * t17);
  const Scalar t21 = c_4 * t20 - s_4 * ddp_o_4_y + Scalar(0.02) * t15;
  const Scalar ddp_e_y = Scalar(0.02) * t5 * t14 + s_4 * t20 + c_4 * ddp_o_4_y;
  const Scalar t22 = s_4 * t21 - c_4 * ddp_e_y;
  const Scalar t23 = s_4 * ddp_e_y + c_4 * t21;
  const Scalar t24 = s_3 * t22 - c_3 * t23;
  const Scalar t25 = s_3 * t23 + c_3 * t22;
  a[1] = s_2 * t24 - c_2 * t25;
  const Scalar t26 = s_2 * t25 + c_2 * t24;
  const Scalar t27 = Scalar(0.4444444444444444) * t6 * omega_4_z -
      Scalar(0.5555555555555556) * t2 * omega_3_z - s_2 * qd_2;
  const Scalar t28 = t27 * Scalar(0.09) * qd_1;
  a[0] = c_1 * t26 - s_1 * t28;
  a[2] = -s_1 * t26 - c_1 * t28;
}

// The functions by type, with the shapes of their arguments: what adapters such as
// flatdyn/eigen.hpp are given.
namespace functions {

struct inverse_dynamics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[3], const Scalar (&qd)[3], const Scalar (&qdd)[3],
      Scalar (&tau)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::finger::inverse_dynamics(of...); }
};

struct inverse_dynamics_tip_force {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[3], const Scalar (&qd)[3], const Scalar (&qdd)[3],
      const Scalar (&h_e)[6], Scalar (&tau)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::finger::inverse_dynamics_tip_force(of...); }
};

struct inertia_matrix {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[3], Scalar (&B)[3][3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::finger::inertia_matrix(of...); }
};

struct christoffel {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[3], Scalar (&c)[3][6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::finger::christoffel(of...); }
};

struct coriolis_matrix {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[3], const Scalar (&qd)[3], Scalar (&C)[3][3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::finger::coriolis_matrix(of...); }
};

struct gravity {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[3], Scalar (&g)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::finger::gravity(of...); }
};

struct bias {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[3], const Scalar (&qd)[3], Scalar (&n)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::finger::bias(of...); }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[3], const Scalar (&qd)[3], const Scalar (&tau)[3],
      Scalar (&qdd)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::finger::forward_dynamics(of...); }
};

struct kinetic_energy {
  template <class Scalar>
  using Shape = Scalar(const Scalar (&q)[3], const Scalar (&qd)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::finger::kinetic_energy(of...); }
};

struct potential_energy {
  template <class Scalar>
  using Shape = Scalar(const Scalar (&q)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::finger::potential_energy(of...); }
};

struct forward_kinematics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[3], Scalar (&R)[3][3], Scalar (&p)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::finger::forward_kinematics(of...); }
};

struct jacobian {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[3], Scalar (&J)[6][3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::finger::jacobian(of...); }
};

struct jacobian_dot_qd {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[3], const Scalar (&qd)[3], Scalar (&a)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::finger::jacobian_dot_qd(of...); }
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

}  // namespace finger

#endif  // FLATDYN_FINGER_HPP_D97471FE

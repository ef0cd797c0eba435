// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "rx90" as flat code: 6 joints.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Input: sha1:38df2b633a893c4f0d461ea5244797a89092df38
//
//   index  joint   moves link  type      unit
//   0      joint1  link1       revolute  rad
//   1      joint2  link2       revolute  rad
//   2      joint3  link3       revolute  rad
//   3      joint4  link4       revolute  rad
//   4      joint5  link5       revolute  rad
//   5      joint6  link6       revolute  rad
//
// Gravity is (0, 0, -9.81) m/s^2 in the base frame. The tip belongs to link "link6".
//
// Every function is a template over its scalar: float, double, or any type that is made from a
// double, has + - * / (also - of one), comparisons, and sin, cos where argument-dependent lookup
// finds them (or an argument that knows them, see LibrarySinCos). Arguments are plain arrays:
//
//   double q[6] = {}, qd[6] = {}, qdd[6] = {}, tau[6];
//   rx90::inverse_dynamics(q, qd, qdd, tau);
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

#ifndef FLATDYN_RX90_HPP_9CAE2EED
#define FLATDYN_RX90_HPP_9CAE2EED

#include <cmath>

namespace rx90 {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 6;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {
    "joint1", "joint2", "joint3", "joint4", "joint5", "joint6"};

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
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5], qd[0..5], qdd[0..5]. Operations: 210 mul, 193 add, 10 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = s_2_3 * qd_1;
  const Scalar t2 = s_2 * s_3 - c_2 * c_3;
  const Scalar t3 = t2 * qd_1;
  const Scalar t4 = t1 * t3;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar t5 = t4 + domega_3_z;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t6 = s_2_3 * qdd_1;
  const Scalar t7 = Scalar(2.0) * omega_3_z * t3 - t6;
  const Scalar t8 = s_4 * t5 + c_4 * t7;
  const Scalar omega_r_5_a_z = s_4 * t1 + c_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 - t3;
  const Scalar t9 = t8 + Scalar(2.0) * omega_r_5_a_z * omega_4_z;
  const Scalar t10 = omega_3_z * t1;
  const Scalar t11 = t2 * qdd_1;
  const Scalar t12 = t11 + t10;
  const Scalar domega_4_z = qdd_4 - t12;
  const Scalar t13 = s_4 * omega_3_z - c_4 * t1;
  const Scalar t14 = t13 * omega_r_5_a_z;
  const Scalar Uz_o_5_x = domega_4_z - t14;
  const Scalar Uz_5_x = c_5 * Uz_o_5_x + s_5 * t9;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t13;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t15 = omega_r_5_x * omega_5_z;
  const Scalar domega_5_y = Uz_5_x - t15;
  const Scalar domega_6_z = qdd_6 + domega_5_y;
  const Scalar t16 = t15 + domega_6_z;
  const Scalar t17 = Scalar(0.0009944) * c_6 - Scalar(0.000534) * s_6;
  const Scalar t18 = s_5 * Uz_o_5_x - c_5 * t9;
  const Scalar omega_r_5_y = s_5 * t13 + c_5 * omega_4_z;
  const Scalar t19 = Scalar(2.0) * omega_5_z;
  const Scalar U_5_zy = t18 + omega_r_5_y * t19;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t20 = U_5_zy - t19 * omega_6_z;
  const Scalar I_t6_g = Scalar(0.0002546) * c_6 - Scalar(0.000512) * s_6;
  const Scalar I_6_xy = s_6 * I_t6_g + Scalar(0.000256);
  const Scalar t21 = omega_6_z * omega_6_z;
  const Scalar t22 = omega_5_z * omega_5_z;
  const Scalar t23 = t22 + t21;
  const Scalar t24 = omega_r_5_x * omega_r_5_x;
  const Scalar t25 = t24 + t22;
  const Scalar I_6_xz = Scalar(0.000534) * c_6 + Scalar(0.0009944) * s_6;
  const Scalar t26 = s_4 * t7 - c_4 * t5;
  const Scalar t27 = t13 * omega_4_z;
  const Scalar t28 = t27 + t26;
  const Scalar domega_5_z = qdd_5 - t28;
  const Scalar t29 = omega_r_5_x * omega_r_5_y;
  const Scalar t30 = domega_5_z - t29;
  const Scalar U_6_zx = t30 + Scalar(2.0) * omega_r_5_x * omega_6_z;
  const Scalar t31 = c_6 * I_t6_g;
  const Scalar t32 = t31 - Scalar(0.0007896);
  const Scalar t33 = t22 - t24;
  const Scalar t34 = t13 * t13;
  const Scalar t35 = omega_4_z * omega_4_z;
  const Scalar Uz_o_5_y = t35 + t34;
  const Scalar t36 = Uz_o_5_y + t33;
  const Scalar t37 = Scalar(2.0) * qd_1;
  const Scalar t38 = s_2 * qd_2 * t37 - c_2 * qdd_1;
  const Scalar t39 = t7 - t38;
  const Scalar t40 = qd_2 * qd_2;
  const Scalar t41 = qd_1 * qd_1;
  const Scalar t42 = s_2 * qdd_2 + c_2 * (t40 + t41);
  const Scalar t43 = s_2 * t40 - c_2 * qdd_2 - Scalar(21.8);
  const Scalar t44 = s_2_3 * t43 - t2 * t42;
  const Scalar t45 = t5 + t44;
  const Scalar t46 = s_4 * t39 - c_4 * t45;
  const Scalar t47 = t1 * t1;
  const Scalar t48 = omega_3_z * omega_3_z;
  const Scalar t49 = t47 + t48;
  const Scalar ddp_3_y = s_2_3 * t42 + t2 * t43;
  const Scalar t50 = t49 - ddp_3_y;
  const Scalar t51 = s_5 * t46 + c_5 * t50;
  const Scalar t52 = Scalar(0.00315) * c_6 + Scalar(0.00504) * s_6;
  const Scalar U_5_yx = t29 + domega_5_z;
  const Scalar t53 = s_5 * t50 - c_5 * t46;
  const Scalar mu_5_z = I_6_xz * (t25 - t23) - Scalar(0.0007639) * t18 - t20 * I_6_xy + t16 * t17 +
      Scalar(0.0016163) * Uz_5_x - Scalar(0.0010857) * (t36 - t25) - U_6_zx * t32 +
      Scalar(0.0029421) * U_5_yx + t51 * (t52 - Scalar(0.009135)) + Scalar(0.0123285) * t30 +
      Scalar(0.014265) * t53;
  tau[4] = mu_5_z;
  const Scalar t54 = t15 - domega_6_z;
  const Scalar I_6_xx = t31 + Scalar(0.000535);
  const Scalar t55 = t24 + t21;
  const Scalar mr_6_y = Scalar(0.00504) * c_6 - Scalar(0.00315) * s_6;
  const Scalar t56 = s_4 * t45 + c_4 * t39;
  const Scalar t57 = I_6_xy * (t23 - t55) - t54 * t32 - t16 * I_6_xx - U_5_zy * I_6_xz - t30 * t17 -
      mr_6_y * t53 + t52 * t56;
  tau[5] = -t57;
  const Scalar U_5_zx = t15 - domega_5_y;
  const Scalar t58 = Scalar(0.0016163) * t30 - Scalar(0.0007639) * t33 +
      Scalar(0.0010857) * U_5_zy - Scalar(0.0029421) * U_5_zx + Scalar(0.009135) * t56 - t57;
  const Scalar U_6_yy_zz = t25 - t55;
  const Scalar U_5_yy_zz = Uz_o_5_y - t25;
  const Scalar t59 = U_6_zx * I_6_xy + Scalar(0.0007639) * U_5_yx + t17 * U_6_yy_zz + t54 * I_6_xz +
      Scalar(0.0010857) * U_5_zx - Scalar(0.0016163) * U_5_yy_zz - t20 * I_6_xx + mr_6_y * t51 +
      Scalar(0.014265) * t56 - Scalar(0.0123285) * U_5_zy;
  const Scalar t60 = t35 - t34;
  const Scalar t61 = t49 + t60;
  const Scalar U_4_yx = domega_4_z + t14;
  const Scalar tau_4 = Scalar(0.0009736) * (t61 - Uz_o_5_y) + Scalar(0.0110896) * t8 +
      Scalar(0.0123968) * U_4_yx + c_5 * t58 - s_5 * t59 + Scalar(0.0523608) * t26 +
      Scalar(0.0316473) * Uz_o_5_x - Scalar(0.05238) * t56 - Scalar(0.096525) * t46;
  tau[3] = tau_4;
  const Scalar t62 = mr_6_y * t16 - t52 * t23 + Scalar(0.009135) * t36 + Scalar(0.014265) * t30;
  const Scalar f_5_y = Scalar(0.009135) * U_5_yx + mr_6_y * t20 - t52 * U_6_zx -
      Scalar(0.014265) * t25;
  const Scalar f_4_x = -s_5 * f_5_y - c_5 * t62 + Scalar(0.05238) * t61 -
      Scalar(0.096525) * Uz_o_5_x + Scalar(1.72386) * t46;
  const Scalar t63 = mr_6_y * t55 - t52 * t54 + Scalar(0.009135) * U_5_zx +
      Scalar(0.05238) * U_4_yx + Scalar(0.014265) * U_5_zy + Scalar(0.096525) * Uz_o_5_y -
      Scalar(1.72386) * t56;
  const Scalar f_u_4_t_x = s_4 * t63 + c_4 * f_4_x;
  const Scalar t64 = t27 + t28;
  const Scalar U_4_yy_zz = t49 - Uz_o_5_y;
  const Scalar t65 = Scalar(0.0009736) * t64 + Scalar(0.0110896) * U_4_yx + s_5 * t58 + c_5 * t59 +
      Scalar(0.0316473) * t9 - Scalar(0.0523608) * U_4_yy_zz + Scalar(0.096525) * t50;
  const Scalar t66 = Scalar(0.0110896) * t60 - Scalar(0.0009736) * t9 - Scalar(0.0123968) * t64 -
      Scalar(0.0523608) * Uz_o_5_x + mu_5_z + Scalar(0.05238) * t50;
  const Scalar t67 = t48 - t47;
  const Scalar t68 = t41 + t67;
  const Scalar U_3_yx = domega_3_z - t4;
  const Scalar tau_3 = Scalar(0.016137) * t6 + Scalar(0.0408384) * t11 -
      Scalar(0.026176) * (t68 - t49) + Scalar(0.0741175) * U_3_yx + c_4 * t66 +
      Scalar(0.2414744) * t5 + Scalar(0.123525) * ddp_3_y + s_4 * t65 - f_u_4_t_x;
  tau[2] = tau_3;
  const Scalar t69 = s_3 * (Scalar(0.123525) * t68 - f_u_4_t_x + Scalar(7.18587) * t44);
  const Scalar f_3_y = c_5 * f_5_y - s_5 * t62 + Scalar(0.123525) * U_3_yx + Scalar(0.05238) * t64 -
      Scalar(0.096525) * t9 - Scalar(1.72386) * t49 + Scalar(8.90973) * ddp_3_y;
  const Scalar I_t2_g = Scalar(0.5095078) * c_2 - Scalar(0.1369896) * s_2;
  const Scalar I_2_xy = Scalar(0.0684948) + s_2 * I_t2_g;
  const Scalar I_2_yz = Scalar(0.0444376) * c_2 - Scalar(0.1098692) * s_2;
  tau[1] = qdd_1 * I_2_yz + Scalar(4.102542) * s_2 - Scalar(0.355289) * qdd_2 - t41 * I_2_xy +
      tau_3 - t69 + c_3 * f_3_y;
  const Scalar t70 = s_4 * f_4_x - c_4 * t63;
  const Scalar U_3_zx = t10 + t12;
  const Scalar f_3_z = Scalar(0.123525) * U_3_zx - t70 + Scalar(7.18587) * t38;
  const Scalar U_3_yy_zz = t41 - t49;
  const Scalar mu_3_x = Scalar(0.016137) * U_3_yx - Scalar(0.026176) * U_3_zx -
      Scalar(0.0408384) * U_3_yy_zz + s_4 * t66 - c_4 * t65 - Scalar(0.2414744) * t7 - t70;
  const Scalar t71 = Scalar(0.016137) * t67 - Scalar(0.026176) * t7 - Scalar(0.0408384) * t5 -
      Scalar(0.0741175) * U_3_zx - Scalar(0.123525) * t38 + tau_4;
  const Scalar t72 = qd_2 * (qd_2 * (Scalar(0.0444376) * s_2 + Scalar(0.1098692) * c_2) -
      t37 * I_2_xy);
  const Scalar t73 = qdd_1 * (c_2 * I_t2_g - Scalar(0.883057));
  const Scalar t74 = t2 * t71 - qdd_2 * I_2_yz + t72 + t73 - s_2_3 * mu_3_x + c_2 * f_3_z;
  tau[0] = -t74;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..5], qd[0..5], qdd[0..5], h_e[0..5]. Operations: 271 mul, 221 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics_tip_force(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    const Scalar* h_e, Scalar* tau, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5];
  const Scalar h_e_1 = h_e[0], h_e_2 = h_e[1], h_e_3 = h_e[2], h_e_4 = h_e[3], h_e_5 = h_e[4],
      h_e_6 = h_e[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5];
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = s_2_3 * qd_1;
  const Scalar t2 = s_2 * s_3 - c_2 * c_3;
  const Scalar t3 = t2 * qd_1;
  const Scalar t4 = t1 * t3;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar t5 = t4 + domega_3_z;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t6 = s_2_3 * qdd_1;
  const Scalar t7 = Scalar(2.0) * omega_3_z * t3 - t6;
  const Scalar t8 = s_4 * t5 + c_4 * t7;
  const Scalar omega_r_5_a_z = s_4 * t1 + c_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 - t3;
  const Scalar t9 = t8 + Scalar(2.0) * omega_r_5_a_z * omega_4_z;
  const Scalar t10 = omega_3_z * t1;
  const Scalar t11 = t2 * qdd_1;
  const Scalar t12 = t11 + t10;
  const Scalar domega_4_z = qdd_4 - t12;
  const Scalar t13 = s_4 * omega_3_z - c_4 * t1;
  const Scalar t14 = t13 * omega_r_5_a_z;
  const Scalar Uz_o_5_x = domega_4_z - t14;
  const Scalar t15 = s_5 * Uz_o_5_x - c_5 * t9;
  const Scalar omega_r_5_y = s_5 * t13 + c_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar U_5_zy = t15 + Scalar(2.0) * omega_r_5_y * omega_5_z;
  const Scalar t16 = s_4 * t7 - c_4 * t5;
  const Scalar t17 = t13 * omega_4_z;
  const Scalar t18 = t17 + t16;
  const Scalar domega_5_z = qdd_5 - t18;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t13;
  const Scalar t19 = omega_r_5_x * omega_r_5_y;
  const Scalar t20 = domega_5_z - t19;
  const Scalar t21 = s_6 * U_5_zy + c_6 * t20;
  const Scalar t22 = s_6 * t20 - c_6 * U_5_zy;
  const Scalar Uz_5_x = c_5 * Uz_o_5_x + s_5 * t9;
  const Scalar t23 = omega_r_5_x * omega_5_z;
  const Scalar domega_5_y = Uz_5_x - t23;
  const Scalar domega_6_z = qdd_6 + domega_5_y;
  const Scalar t24 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar t25 = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t26 = t24 * t25;
  const Scalar t27 = domega_6_z - t26;
  const Scalar U_6_yx = t26 + domega_6_z;
  const Scalar t28 = t24 * t24;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t29 = omega_6_z * omega_6_z;
  const Scalar t30 = t29 - t28;
  const Scalar t31 = omega_r_5_x * omega_r_5_x;
  const Scalar t32 = omega_5_z * omega_5_z;
  const Scalar t33 = t31 + t32;
  const Scalar t34 = t33 + t30;
  const Scalar t35 = t28 + t29;
  const Scalar t36 = Scalar(0.45) * c_2;
  const Scalar t37 = Scalar(0.9) * s_2 * qd_1 * qd_2 - qdd_1 * t36;
  const Scalar t38 = Scalar(0.45) * t7 - t37;
  const Scalar t39 = qd_2 * qd_2;
  const Scalar t40 = Scalar(0.45) * (s_2 * t39 - c_2 * qdd_2) - Scalar(9.81);
  const Scalar t41 = qd_1 * qd_1;
  const Scalar t42 = Scalar(0.45) * s_2 * qdd_2 + (t39 + t41) * t36;
  const Scalar t43 = s_2_3 * t40 - t2 * t42;
  const Scalar t44 = Scalar(0.45) * t5 + t43;
  const Scalar t45 = s_4 * t38 - c_4 * t44;
  const Scalar t46 = t1 * t1;
  const Scalar t47 = omega_3_z * omega_3_z;
  const Scalar t48 = t46 + t47;
  const Scalar ddp_3_y = s_2_3 * t42 + t2 * t40;
  const Scalar t49 = Scalar(0.45) * t48 - ddp_3_y;
  const Scalar t50 = s_5 * t49 - c_5 * t45;
  const Scalar t51 = s_4 * t44 + c_4 * t38;
  const Scalar t52 = s_6 * t51 - c_6 * t50;
  const Scalar t53 = s_6 * t50 + c_6 * t51;
  const Scalar mu_e1_x = s_1 * h_e_5 + c_1 * h_e_4;
  const Scalar mu_e3_x = s_2_3 * h_e_6 - t2 * mu_e1_x;
  const Scalar t54 = s_1 * h_e_4 - c_1 * h_e_5;
  const Scalar t55 = s_4 * t54 - c_4 * mu_e3_x;
  const Scalar t56 = s_2_3 * mu_e1_x + t2 * h_e_6;
  const Scalar mu_6_z = Scalar(0.0007896) * t27 - Scalar(0.000256) * (t34 - t35) -
      Scalar(0.000534) * t22 + Scalar(0.000535) * U_6_yx + Scalar(0.0009944) * t21 -
      Scalar(0.0112) * t52 - Scalar(0.007) * t53 + s_5 * t55 - c_5 * t56;
  tau[5] = mu_6_z;
  const Scalar t57 = Scalar(2.0) * omega_6_z;
  const Scalar U_6_zx = t21 - t24 * t57;
  const Scalar t58 = t22 + t25 * t57;
  const Scalar U_6_yy_zz = t33 - t35;
  const Scalar t59 = s_5 * t45 + c_5 * t49;
  const Scalar t60 = s_5 * t56 + c_5 * t55;
  const Scalar t61 = s_4 * mu_e3_x + c_4 * t54;
  const Scalar t62 = Scalar(0.000256) * U_6_zx - Scalar(0.000534) * U_6_yx +
      Scalar(0.0007896) * t58 + Scalar(0.0009944) * U_6_yy_zz + Scalar(0.0112) * t59 + s_6 * t61 +
      c_6 * t60;
  const Scalar t63 = Scalar(0.000256) * t58 - Scalar(0.000534) * t30 + Scalar(0.000535) * U_6_zx +
      Scalar(0.0009944) * t27 + Scalar(0.007) * t59 - s_6 * t60 + c_6 * t61;
  const Scalar t64 = t32 - t31;
  const Scalar t65 = t13 * t13;
  const Scalar t66 = omega_4_z * omega_4_z;
  const Scalar Uz_o_5_y = t66 + t65;
  const Scalar t67 = Uz_o_5_y + t64;
  const Scalar U_5_yx = t19 + domega_5_z;
  const Scalar mu_5_z = Scalar(0.0016163) * Uz_5_x - Scalar(0.0007639) * t15 -
      Scalar(0.0010857) * (t67 - t33) + Scalar(0.0029421) * U_5_yx - Scalar(0.0203) * t59 +
      Scalar(0.0123285) * t20 + Scalar(0.0317) * t50 + s_6 * t62 + c_6 * t63;
  tau[4] = mu_5_z;
  const Scalar U_5_zx = t23 - domega_5_y;
  const Scalar U_5_yy_zz = Uz_o_5_y - t33;
  const Scalar t68 = Scalar(0.0007639) * U_5_yx + Scalar(0.0010857) * U_5_zx -
      Scalar(0.0016163) * U_5_yy_zz + Scalar(0.0317) * t51 - Scalar(0.0123285) * U_5_zy -
      s_6 * t63 + c_6 * t62;
  const Scalar t69 = Scalar(0.0016163) * t20 - Scalar(0.0007639) * t64 +
      Scalar(0.0010857) * U_5_zy - Scalar(0.0029421) * U_5_zx + Scalar(0.0203) * t51 + mu_6_z;
  const Scalar t70 = t66 - t65;
  const Scalar t71 = t48 + t70;
  const Scalar U_4_yx = domega_4_z + t14;
  const Scalar tau_4 = Scalar(0.0009736) * (t71 - Uz_o_5_y) + Scalar(0.0110896) * t8 +
      Scalar(0.0123968) * U_4_yx + Scalar(0.0523608) * t16 + Scalar(0.0316473) * Uz_o_5_x -
      Scalar(0.1164) * t51 - Scalar(0.2145) * t45 - s_5 * t68 + c_5 * t69;
  tau[3] = tau_4;
  const Scalar f_e1_x = s_1 * h_e_2 + c_1 * h_e_1;
  const Scalar f_e3_x = s_2_3 * h_e_3 - t2 * f_e1_x;
  const Scalar t72 = s_1 * h_e_1 - c_1 * h_e_2;
  const Scalar t73 = s_4 * t72 - c_4 * f_e3_x;
  const Scalar t74 = s_2_3 * f_e1_x + t2 * h_e_3;
  const Scalar t75 = s_5 * t74 + c_5 * t73;
  const Scalar t76 = s_4 * f_e3_x + c_4 * t72;
  const Scalar t77 = Scalar(0.007) * U_6_yx + Scalar(0.0112) * t35 - s_6 * t75 + c_6 * t76;
  const Scalar f_6_x = Scalar(0.007) * t34 - Scalar(0.0112) * t27 - s_6 * t76 - c_6 * t75;
  const Scalar t78 = Scalar(0.0203) * t67 + Scalar(0.0317) * t20 - s_6 * t77 - c_6 * f_6_x;
  const Scalar f_5_y = Scalar(0.0203) * U_5_yx - Scalar(0.007) * U_6_zx - Scalar(0.0317) * t33 -
      Scalar(0.0112) * t58 + s_5 * t73 - c_5 * t74;
  const Scalar f_4_x = Scalar(0.1164) * t71 - Scalar(0.2145) * Uz_o_5_x - s_5 * f_5_y - c_5 * t78 +
      Scalar(8.512888888888888) * t45;
  const Scalar t79 = Scalar(0.0203) * U_5_zx + Scalar(0.0317) * U_5_zy + Scalar(0.1164) * U_4_yx +
      Scalar(0.2145) * Uz_o_5_y - s_6 * f_6_x + c_6 * t77 - Scalar(8.512888888888888) * t51;
  const Scalar f_u_4_t_x = s_4 * t79 + c_4 * f_4_x;
  const Scalar t80 = t17 + t18;
  const Scalar U_4_yy_zz = t48 - Uz_o_5_y;
  const Scalar t81 = Scalar(0.0009736) * t80 + Scalar(0.0110896) * U_4_yx + Scalar(0.0316473) * t9 -
      Scalar(0.0523608) * U_4_yy_zz + Scalar(0.2145) * t49 + s_5 * t69 + c_5 * t68;
  const Scalar t82 = Scalar(0.0110896) * t70 - Scalar(0.0009736) * t9 - Scalar(0.0123968) * t80 -
      Scalar(0.0523608) * Uz_o_5_x + Scalar(0.1164) * t49 + mu_5_z;
  const Scalar t83 = t47 - t46;
  const Scalar t84 = t41 + t83;
  const Scalar U_3_yx = domega_3_z - t4;
  const Scalar tau_3 = Scalar(0.016137) * t6 + Scalar(0.0408384) * t11 -
      Scalar(0.026176) * (t84 - t48) + Scalar(0.0741175) * U_3_yx + Scalar(0.2414744) * t5 +
      Scalar(0.2745) * ddp_3_y + s_4 * t81 + c_4 * t82 - Scalar(0.45) * f_u_4_t_x;
  tau[2] = tau_3;
  const Scalar f_3_y = Scalar(0.1164) * t80 + Scalar(0.2745) * U_3_yx - Scalar(0.2145) * t9 -
      s_5 * t78 + c_5 * f_5_y - Scalar(3.8308) * t48 + Scalar(43.998666666666665) * ddp_3_y;
  const Scalar t85 = s_3 * (Scalar(0.2745) * t84 - f_u_4_t_x + Scalar(35.48577777777778) * t43) -
      c_3 * f_3_y;
  const Scalar I_t2_g = Scalar(0.5095078) * c_2 - Scalar(0.1369896) * s_2;
  const Scalar I_2_xy = Scalar(0.0684948) + s_2 * I_t2_g;
  const Scalar I_2_yz = Scalar(0.0444376) * c_2 - Scalar(0.1098692) * s_2;
  tau[1] = qdd_1 * I_2_yz + Scalar(4.102542) * s_2 - Scalar(0.355289) * qdd_2 - t41 * I_2_xy +
      tau_3 - Scalar(0.45) * t85;
  const Scalar t86 = s_4 * f_4_x - c_4 * t79;
  const Scalar U_3_zx = t10 + t12;
  const Scalar f_3_z = Scalar(0.2745) * U_3_zx - t86 + Scalar(35.48577777777778) * t37;
  const Scalar U_3_yy_zz = t41 - t48;
  const Scalar mu_3_x = Scalar(0.016137) * U_3_yx - Scalar(0.026176) * U_3_zx -
      Scalar(0.0408384) * U_3_yy_zz - Scalar(0.2414744) * t7 + s_4 * t82 - c_4 * t81 -
      Scalar(0.45) * t86;
  const Scalar t87 = Scalar(0.016137) * t83 - Scalar(0.026176) * t7 - Scalar(0.0408384) * t5 -
      Scalar(0.0741175) * U_3_zx - Scalar(0.2745) * t37 + tau_4;
  const Scalar t88 = qd_2 * (Scalar(0.0444376) * s_2 + Scalar(0.1098692) * c_2) -
      Scalar(2.0) * qd_1 * I_2_xy;
  const Scalar t89 = qdd_1 * (c_2 * I_t2_g - Scalar(0.883057));
  const Scalar t90 = t2 * t87 - qdd_2 * I_2_yz + qd_2 * t88 + t89 - s_2_3 * mu_3_x + t36 * f_3_z;
  tau[0] = -t90;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[36] = {
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1};

// Joint-space inertia matrix B(q) (7.32).
//   q[6]   in   joint positions, rad or m
//   B[36]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//               6 x 6, row by row: entry (i, j) is B[6 * i + j]
// Reads q[1..5]. Operations: 94 mul, 86 add, 10 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inertia_matrix(const Scalar* q, Scalar* B, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar Iu_6_a_xy = Scalar(0.0009944) * c_6 - Scalar(0.000534) * s_6;
  B[29] = B[34] = Iu_6_a_xy;
  const Scalar Iu_6_t_xz = Scalar(0.000534) * c_6 + Scalar(0.0009944) * s_6;
  const Scalar mu_u_6_5_t_y = Scalar(0.0013246) * c_5 + s_5 * Iu_6_t_xz;
  B[23] = B[33] = mu_u_6_5_t_y;
  const Scalar Iu_6_t_g = Scalar(0.0002546) * c_6 - Scalar(0.000512) * s_6;
  const Scalar t1 = c_6 * Iu_6_t_g;
  const Scalar mu_u_5_5_a_y = t1 - Scalar(0.0160602);
  B[28] = -mu_u_5_5_a_y;
  const Scalar t2 = s_6 * Iu_6_t_g + Scalar(0.0010199);
  const Scalar Ic_5_yz = Iu_6_a_xy + Scalar(0.0016163);
  const Scalar t3 = s_5 * t2 - c_5 * Ic_5_yz;
  B[22] = B[27] = -t3;
  const Scalar hu_6_t_y = Scalar(0.00504) * c_6 - Scalar(0.00315) * s_6;
  const Scalar t4 = c_5 * hu_6_t_y;
  const Scalar f_u_6_6_a_z = Scalar(0.00315) * c_6 + Scalar(0.00504) * s_6;
  const Scalar t5 = s_4 * f_u_6_6_a_z - c_4 * t4;
  const Scalar t6 = Scalar(0.0013246) * s_5 - c_5 * Iu_6_t_xz;
  const Scalar t7 = -s_4 * t6 - c_4 * Iu_6_a_xy + t5;
  B[17] = B[32] = -t7;
  const Scalar Iu_5_t_d = t1 + Scalar(0.0085968);
  const Scalar Ic_5_xy = Iu_6_t_xz + Scalar(0.0010857);
  const Scalar t8 = Scalar(2.0) * s_5 * Ic_5_xy - c_5 * Iu_5_t_d;
  const Scalar t9 = c_5 * t8;
  const Scalar Ic_4_zz = t1 + t9 + Scalar(0.0569076);
  B[21] = Ic_4_zz;
  const Scalar Iu_5_a_xz = c_5 * t2 + s_5 * Ic_5_yz;
  const Scalar t10 = f_u_6_6_a_z - Scalar(0.009135);
  const Scalar hu_5_t_y = Scalar(0.014265) * c_5 - s_5 * t10;
  const Scalar t11 = mu_u_5_5_a_y - hu_5_t_y;
  const Scalar mu_5_3_z = s_4 * Iu_5_a_xz - c_4 * t11;
  B[16] = B[26] = mu_5_3_z;
  B[11] = B[31] = s_3 * t5 - t7 - c_3 * s_5 * hu_6_t_y;
  const Scalar t12 = c_5 * t10 + Scalar(0.014265) * s_5;
  B[10] = B[25] = mu_5_3_z - s_3 * c_4 * hu_5_t_y - c_3 * t12;
  const Scalar f_u_6_4_a_z = s_4 * t4 + c_4 * f_u_6_6_a_z;
  const Scalar mu_6_3_x = s_4 * Iu_6_a_xy - c_4 * t6 + f_u_6_4_a_z;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t13 = s_2 * s_3 - c_2 * c_3;
  B[5] = B[30] = s_2_3 * mu_6_3_x - t13 * mu_u_6_5_t_y - c_2 * f_u_6_4_a_z;
  const Scalar Ic_4_xz = Iu_6_t_xz - s_5 * t8 - Scalar(0.0100039);
  const Scalar t14 = t12 + Scalar(0.05238);
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.096525);
  const Scalar t15 = s_4 * t14 - c_4 * hc_4_y;
  const Scalar t16 = t3 + Scalar(0.0523608);
  const Scalar t17 = s_4 * Ic_4_xz + c_4 * t16 + t15;
  B[15] = B[20] = -t17;
  const Scalar t18 = s_2_3 * (c_4 * Iu_5_a_xz + s_4 * t11);
  B[4] = B[24] = t13 * t3 - c_2 * s_4 * hu_5_t_y - t18;
  B[9] = B[19] = s_3 * t15 - t17;
  const Scalar f_u_4_4_a_z = c_4 * t14 + s_4 * hc_4_y;
  const Scalar mu_4_3_x = c_4 * Ic_4_xz - s_4 * t16 + f_u_4_4_a_z;
  B[3] = B[18] = s_2_3 * mu_4_3_x - c_2 * f_u_4_4_a_z - t13 * Ic_4_zz;
  const Scalar t19 = t1 + Scalar(0.0163084);
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0009736);
  const Scalar t20 = Scalar(2.0) * s_4 * Ic_4_xy + c_4 * ((t9 + Scalar(0.0088514)) - t19);
  const Scalar t21 = c_4 * t20;
  const Scalar t22 = Scalar(2.0) * hu_5_t_y;
  const Scalar t23 = t9 - t21 - t22 - Scalar(2.0753659);
  B[14] = -t23;
  const Scalar t24 = f_u_4_4_a_z - Scalar(0.123525);
  const Scalar hc_3_y = hu_5_t_y + Scalar(1.72386);
  const Scalar t25 = c_3 * t24 + s_3 * hc_3_y;
  B[7] = -t23 - Scalar(2.0) * t25 + Scalar(8.554441);
  B[8] = B[13] = -t25 - t23;
  const Scalar t26 = s_2_3 * (Iu_5_a_xz - s_4 * t20 - Scalar(0.0171106)) -
      t13 * (Scalar(0.0408384) + t17);
  B[2] = B[12] = -t26;
  B[1] = B[6] = Scalar(0.0444376) * c_2 - t26 - s_2 * (t15 + Scalar(0.1098692));
  const Scalar t27 = t21 + t19 - t22;
  const Scalar Ic_3_xy = Scalar(0.026176) + mu_4_3_x;
  const Scalar t28 = t13 * (Scalar(2.0) * s_2_3 * Ic_3_xy -
      t13 * (t27 + Ic_4_zz - Scalar(1.9359823)));
  const Scalar t29 = s_2_3 * hc_3_y - t13 * t24;
  const Scalar t30 = c_2 * (Scalar(0.1369896) * s_2 - Scalar(2.0) * t29 + Scalar(8.4002222) * c_2);
  B[0] = -t27 - t28 + Scalar(2.8931568) + t30;
  B[35] = Scalar(0.0013246);
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[126] = {
    0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 0, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[6]    in   joint positions, rad or m
//   c[126]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//                c_ijk = c_ikj is c[21 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads q[1..5]. Operations: 297 mul, 249 add, 10 sin/cos. Always zero: 23 of the 126 entries of c.
template <class Scalar, class SinCos = LibrarySinCos>
inline void christoffel(const Scalar* q, Scalar* c, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar Ic_6_xz = Scalar(0.000267) * c_6 + Scalar(0.0004972) * s_6;
  c[104] = Scalar(-2.0) * Ic_6_xz;
  const Scalar Iu_6_a_xy = Scalar(0.0004972) * c_6 - Scalar(0.000267) * s_6;
  const Scalar t1 = s_5 * Iu_6_a_xy;
  c[83] = Scalar(2.0) * t1;
  const Scalar I_t6_g = Scalar(0.0001273) * c_6 - Scalar(0.000256) * s_6;
  const Scalar t2 = s_6 * I_t6_g;
  const Scalar Ic_6_xy = t2 + Scalar(0.000128);
  const Scalar dI_6_yy = Scalar(2.0) * Ic_6_xy;
  c[103] = dI_6_yy;
  c[119] = Scalar(-2.0) * Ic_6_xy;
  const Scalar t3 = s_4 * c_5;
  const Scalar t4 = Iu_6_a_xy * t3 + c_4 * Ic_6_xz;
  const Scalar mr_6_y = Scalar(0.00252) * c_6 - Scalar(0.001575) * s_6;
  const Scalar f_u_6_6_a_z = Scalar(0.001575) * c_6 + Scalar(0.00252) * s_6;
  const Scalar t5 = c_4 * c_5;
  const Scalar t6 = s_4 * mr_6_y + f_u_6_6_a_z * t5;
  const Scalar t7 = t4 + t6;
  c[62] = Scalar(-2.0) * t7;
  const Scalar t8 = t2 + Scalar(0.00050995);
  const Scalar Ic_5_yz = Iu_6_a_xy + Scalar(0.00080815);
  const Scalar Iu_5_a_xz = c_5 * t8 + s_5 * Ic_5_yz;
  c[77] = Scalar(-2.0) * Iu_5_a_xz;
  const Scalar t9 = c_6 * I_t6_g;
  const Scalar dI_6_xy = Scalar(2.0) * t9 - Scalar(0.0001273);
  const Scalar t10 = c_5 * Ic_6_xz;
  const Scalar dmu_4_6_y = s_5 * dI_6_xy + t10;
  const Scalar t11 = Scalar(0.0006623) * s_5 - t10;
  const Scalar c_5_4_6 = t11 - dmu_4_6_y;
  c[102] = c_5_4_6;
  const Scalar Iu_5_t_d = t9 + Scalar(0.0042984);
  const Scalar Ic_5_xy = Ic_6_xz + Scalar(0.00054285);
  const Scalar t12 = Scalar(2.0) * Ic_5_xy;
  const Scalar t13 = c_5 * Iu_5_t_d - s_5 * t12;
  const Scalar t14 = s_5 * t13;
  const Scalar dmu_4_5_y = c_5 * t12 + s_5 * Iu_5_t_d;
  const Scalar db_44_5r = t14 + c_5 * dmu_4_5_y;
  c[76] = db_44_5r;
  const Scalar s_2_3 = c_2 * s_3 + s_2 * c_3;
  const Scalar t15 = c_2 * c_3 - s_2 * s_3;
  const Scalar t16 = s_2_3 * t5 + s_5 * t15;
  const Scalar t17 = s_4 * s_2_3;
  const Scalar v_1_4_a_y = c_2 - s_2_3;
  const Scalar t18 = c_4 * mr_6_y - f_u_6_6_a_z * t3;
  const Scalar t19 = v_1_4_a_y * t18;
  const Scalar t20 = Ic_6_xz * t17 - Iu_6_a_xy * t16 + t19;
  c[20] = Scalar(-2.0) * t20;
  const Scalar t21 = c_4 * s_5;
  const Scalar t22 = c_5 * t15 - s_2_3 * t21;
  const Scalar t23 = Ic_6_xz * t22;
  const Scalar t24 = s_4 * s_5;
  const Scalar t25 = mr_6_y * v_1_4_a_y * t24;
  const Scalar t26 = Scalar(0.0006623) * t16 - t23 - t25;
  const Scalar db_15_6r = t17 * dI_6_yy - t23 - t16 * dI_6_xy + t25;
  const Scalar c_5_1_6 = t26 + db_15_6r;
  c[99] = c_5_1_6;
  c[82] = -dmu_4_6_y - t11;
  c[118] = -c_5_4_6;
  c[93] = -db_44_5r;
  const Scalar t27 = c_5 * Iu_6_a_xy;
  const Scalar t28 = t27 - s_5 * dI_6_yy;
  const Scalar db_44_6r = s_5 * (t27 + t28);
  c[81] = db_44_6r;
  const Scalar t29 = f_u_6_6_a_z - Scalar(0.0045675);
  const Scalar t30 = c_5 * t29 + Scalar(0.0071325) * s_5;
  const Scalar t31 = s_4 * t30;
  const Scalar t32 = v_1_4_a_y * t31;
  const Scalar t33 = t8 * t22 + Ic_5_yz * t16 - t32;
  c[14] = Scalar(-2.0) * t33;
  const Scalar t34 = c_5 * Ic_5_yz - s_5 * t8;
  const Scalar t35 = s_4 * t34;
  const Scalar t36 = t35 - c_4 * t30;
  c[56] = Scalar(2.0) * t36;
  const Scalar t37 = Iu_5_a_xz * t17;
  const Scalar hu_5_t_y = Scalar(0.0071325) * c_5 - s_5 * t29;
  const Scalar t38 = c_4 * v_1_4_a_y;
  const Scalar t39 = hu_5_t_y * t38;
  const Scalar mu_u_5_5_a_y = t9 - Scalar(0.0080301);
  const Scalar t40 = c_4 * s_2_3 * mu_u_5_5_a_y - t37 + t39;
  const Scalar t41 = t37 - t13 * t16 - t22 * dmu_4_5_y + t39;
  const Scalar c_4_1_5 = t40 - t41;
  c[73] = c_4_1_5;
  c[19] = db_15_6r - t26;
  c[115] = -c_5_1_6;
  c[114] = -db_44_6r;
  c[13] = -t40 - t41;
  c[90] = -c_4_1_5;
  const Scalar t42 = mr_6_y * t5 - s_4 * f_u_6_6_a_z;
  const Scalar t43 = v_1_4_a_y * t42;
  const Scalar t44 = t17 * dmu_4_6_y - t16 * t28 - t22 * t1 + t43;
  const Scalar t45 = t43 - s_2_3 * (c_4 * Iu_6_a_xy + s_4 * t11);
  const Scalar c_4_1_6 = t45 - t44;
  c[78] = c_4_1_6;
  const Scalar t46 = s_5 * Ic_6_xz;
  const Scalar t47 = c_4 * dI_6_yy - s_4 * (t46 - c_5 * dI_6_xy);
  const Scalar t48 = mr_6_y * t21;
  const Scalar dmu_3_6_y = t48 - t47;
  const Scalar mu_u_6_5_t_y = Scalar(0.0006623) * c_5 + t46;
  const Scalar t49 = s_4 * mu_u_6_5_t_y;
  const Scalar db_36_5 = t49 - t48;
  c[61] = db_36_5 - dmu_3_6_y;
  const Scalar c_6_3_5 = db_36_5 + dmu_3_6_y;
  c[117] = c_6_3_5;
  const Scalar t50 = t38 * (Scalar(0.0071325) * t22 - t29 * t16);
  const Scalar dmu_1_5_x = -Ic_5_yz * t17 - t12 * t16 + t29 * t38 + Iu_5_t_d * t22;
  const Scalar t51 = t8 * t17 - t12 * t22 - Iu_5_t_d * t16 + Scalar(0.0071325) * t38;
  const Scalar c_5_1_1 = t50 - t16 * dmu_1_5_x + t22 * t51 - t17 * (t32 - t33);
  c[84] = c_5_1_1;
  const Scalar t52 = s_5 * v_1_4_a_y;
  const Scalar t53 = s_4 * (f_u_6_6_a_z * t52 - s_2_3 * dI_6_xy);
  const Scalar t54 = t16 * (Iu_6_a_xy * t22 - t16 * dI_6_yy + t53);
  const Scalar t55 = s_4 * (s_2_3 * db_15_6r + (f_u_6_6_a_z * t16 + mr_6_y * t17) * t52);
  const Scalar db_11_6r = t54 + t55 - t22 * (t19 + t20);
  c[15] = db_11_6r;
  c[18] = -t45 - t44;
  c[111] = -c_4_1_6;
  const Scalar v_2_3_x = c_2 * s_2_3 - s_2 * t15;
  const Scalar v_o_2_4_x = v_2_3_x - Scalar(1.0);
  const Scalar v_2_3_y = c_2 * t15 + s_2 * s_2_3;
  const Scalar t56 = c_5 * v_2_3_y - v_o_2_4_x * t21;
  const Scalar t57 = mr_6_y * t56;
  const Scalar t58 = t57 - t49;
  const Scalar t59 = t57 - t47;
  const Scalar c_5_2_6 = t58 - t59;
  c[100] = c_5_2_6;
  const Scalar t60 = t3 * t28 + c_4 * dmu_4_6_y;
  const Scalar t61 = c_4 * f_u_6_6_a_z;
  const Scalar f_u_6_4_a_z = t61 + mr_6_y * t3;
  const Scalar t62 = t60 - t24 * t1 + f_u_6_4_a_z;
  const Scalar t63 = s_4 * Iu_6_a_xy;
  const Scalar t64 = c_4 * t11 - t63;
  const Scalar t65 = t64 - f_u_6_4_a_z;
  c[60] = t65 - t62;
  const Scalar c_6_3_4 = t65 + t62;
  c[113] = c_6_3_4;
  c[101] = -c_6_3_5;
  const Scalar t66 = t30 + Scalar(0.02619);
  const Scalar hc_4_y = mr_6_y + Scalar(0.0482625);
  const Scalar f_u_4_4_a_z = c_4 * t66 + s_4 * hc_4_y;
  const Scalar df_2_3_x = f_u_4_4_a_z - Scalar(0.0617625);
  const Scalar hc_3_y = hu_5_t_y + Scalar(0.86193);
  const Scalar t67 = df_2_3_x * v_2_3_x - hc_3_y * v_2_3_y;
  c[44] = Scalar(-2.0) * t67;
  c[25] = c[26] = Scalar(2.0) * t67;
  const Scalar t68 = c_5 * t13;
  const Scalar Iu_4_t_d = t9 + t68 + Scalar(0.0037285);
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0004868);
  const Scalar t69 = Scalar(2.0) * Ic_4_xy;
  const Scalar t70 = c_4 * Iu_4_t_d - s_4 * t69;
  const Scalar t71 = s_4 * t70;
  const Scalar t72 = c_4 * t69 + s_4 * Iu_4_t_d;
  const Scalar db_33_4r = t71 + c_4 * t72;
  c[49] = c[50] = db_33_4r;
  c[10] = -c_5_1_1;
  const Scalar Ic_4_xz = Ic_6_xz + t14 - Scalar(0.00500195);
  const Scalar t73 = t34 - Scalar(0.0261804);
  const Scalar t74 = c_4 * Ic_4_xz + s_4 * t73;
  const Scalar t75 = t74 - f_u_4_4_a_z * v_o_2_4_x;
  c[30] = Scalar(-2.0) * t75;
  const Scalar v_2_5_x = s_5 * v_2_3_y + v_o_2_4_x * t5;
  const Scalar t76 = Scalar(0.0071325) * t56 - t29 * v_2_5_x;
  const Scalar t77 = t76 - t35;
  c[35] = Scalar(-2.0) * t77;
  const Scalar t78 = s_4 * v_o_2_4_x;
  const Scalar t79 = f_u_6_6_a_z * v_2_5_x + mr_6_y * t78;
  const Scalar t80 = t4 - t79;
  c[41] = Scalar(-2.0) * t80;
  const Scalar mu_4_3_x = t74 + f_u_4_4_a_z;
  c[51] = Scalar(-2.0) * mu_4_3_x;
  c[105] = -db_11_6r;
  const Scalar t81 = c_4 * Iu_5_a_xz;
  const Scalar t82 = t81 + s_4 * mu_u_5_5_a_y;
  const Scalar t83 = s_4 * hu_5_t_y;
  const Scalar db_35_4 = t82 - t83;
  const Scalar t84 = s_2_3 * t34 + t15 * db_35_4;
  const Scalar t85 = c_4 * Ic_5_yz - s_4 * dmu_4_5_y;
  const Scalar t86 = t85 - s_4 * t29;
  const Scalar t87 = c_4 * t8 + s_4 * t13;
  const Scalar t88 = t87 + Scalar(0.0071325) * s_4;
  const Scalar t89 = t36 * t17 - t16 * t86 - t22 * t88;
  const Scalar c_3_1_5 = t84 + t89;
  c[52] = c_3_1_5;
  const Scalar t90 = c_4 * dI_6_xy - t3 * dI_6_yy;
  const Scalar t91 = t90 - s_5 * (t63 - t61);
  const Scalar t92 = t17 * dmu_3_6_y + t16 * t91 + t22 * t7;
  const Scalar t93 = s_2_3 * mu_u_6_5_t_y + t15 * t65;
  const Scalar c_3_1_6 = t93 - t92;
  c[57] = c_3_1_6;
  const Scalar t94 = t81 + s_4 * (t68 - s_5 * dmu_4_5_y);
  const Scalar t95 = hu_5_t_y * t78;
  const Scalar t96 = t95 - t94;
  const Scalar db_25_4 = t82 + t95;
  c[34] = db_25_4 + t96;
  const Scalar c_5_2_4 = db_25_4 - t96;
  c[91] = c_5_2_4;
  c[40] = -t58 - t59;
  c[116] = -c_5_2_6;
  const Scalar t97 = t94 + t83;
  c[55] = db_35_4 - t97;
  const Scalar c_5_3_4 = db_35_4 + t97;
  c[92] = c_5_3_4;
  c[80] = -c_6_3_4;
  const Scalar t98 = t72 - hc_4_y * v_2_3_y;
  const Scalar t99 = t70 + t66 * v_2_3_y;
  const Scalar t100 = c_4 * hc_4_y - s_4 * t66;
  const Scalar t101 = t100 * v_2_3_y;
  const Scalar c_4_2_2 = t101 - s_4 * t99 - c_4 * t98;
  c[65] = c_4_2_2;
  c[67] = c[68] = -db_33_4r;
  const Scalar t102 = t31 * t78 - c_4 * t76;
  const Scalar t103 = t85 + t29 * t78;
  const Scalar t104 = Scalar(0.0071325) * t78 - t87;
  const Scalar c_2_2_5 = t102 - c_4 * t77 + s_4 * (c_5 * t103 + s_5 * t104);
  c[32] = c_2_2_5;
  const Scalar t105 = c_4 * dmu_3_6_y - s_4 * (c_5 * t91 - s_5 * t7);
  const Scalar c_6_3_3 = t105 + s_5 * (c_4 * t18 + s_4 * t6);
  c[110] = c_6_3_3;
  const Scalar t106 = c_4 * t73 - s_4 * Ic_4_xz;
  const Scalar t107 = t100 * v_1_4_a_y;
  const Scalar t108 = t107 - s_2_3 * t106;
  c[9] = Scalar(-2.0) * t108;
  c[12] = t89 - t84;
  c[87] = -c_3_1_5;
  c[17] = -t93 - t92;
  c[108] = -c_3_1_6;
  c[74] = -c_5_2_4;
  const Scalar t109 = f_u_6_6_a_z * t56 - Iu_6_a_xy * t24;
  const Scalar t110 = t60 - c_5 * t79 + s_5 * t109;
  const Scalar t111 = t64 + v_o_2_4_x * f_u_6_4_a_z;
  c[39] = t111 - t110;
  const Scalar c_6_2_4 = t111 + t110;
  c[112] = c_6_2_4;
  c[75] = -c_5_3_4;
  c[28] = -c_4_2_2;
  c[86] = -c_2_2_5;
  const Scalar t112 = c_4 * t36 + s_4 * (c_5 * t86 - s_5 * t88);
  const Scalar c_5_3_3 = t30 - t112;
  c[89] = c_5_3_3;
  c[59] = -c_6_3_3;
  const Scalar t113 = t77 * t17 + t16 * t103 - t22 * t104;
  const Scalar t114 = t84 - s_2 * t83;
  const Scalar c_2_1_5 = t114 - t113;
  c[31] = c_2_1_5;
  const Scalar t115 = t90 + t109;
  const Scalar t116 = t17 * t59 + t16 * t115 + t22 * t80;
  const Scalar t117 = t93 - s_2 * f_u_6_4_a_z;
  const Scalar c_2_1_6 = t117 - t116;
  c[36] = c_2_1_6;
  c[29] = db_33_4r - Scalar(2.0) * t101;
  const Scalar t118 = t56 * t18 - t79 * t24;
  const Scalar t119 = t118 + t105;
  const Scalar db_26_3 = s_5 * mr_6_y * v_2_3_x - v_2_3_y * t42;
  c[38] = db_26_3 - t119;
  const Scalar c_6_2_3 = db_26_3 + t119;
  c[109] = c_6_2_3;
  c[79] = -c_6_2_4;
  c[54] = -c_5_3_3;
  const Scalar c_6_2_2 = t118 + c_4 * t59 - s_4 * (c_5 * t115 - s_5 * t80);
  c[107] = c_6_2_2;
  const Scalar t120 = t15 * (Iu_5_a_xz + t71 - Scalar(0.0085553)) +
      s_2_3 * (t106 - Scalar(0.0204192) + t100);
  c[4] = c[5] = Scalar(-2.0) * t120;
  c[11] = -t114 - t113;
  c[85] = -c_2_1_5;
  c[16] = -t117 - t116;
  c[106] = -c_2_1_6;
  const Scalar t121 = c_4 * t70;
  const Scalar t122 = t15 * mu_4_3_x;
  const Scalar t123 = s_2_3 * (t121 - s_4 * t72) + t122;
  const Scalar Ic_4_zz = t9 - t68 + Scalar(0.0284538);
  const Scalar t124 = t122 - s_2_3 * Ic_4_zz;
  c[8] = t124 - t123;
  const Scalar c_4_1_3 = t123 + t124;
  c[66] = c_4_1_3;
  const Scalar t125 = t102 + t112;
  const Scalar t126 = t30 * v_2_3_x - c_4 * hu_5_t_y * v_2_3_y;
  c[33] = t126 + t125;
  const Scalar c_5_2_3 = t126 - t125;
  c[88] = c_5_2_3;
  c[58] = -c_6_2_3;
  const Scalar t127 = c_4 * (t15 * t73 - s_2_3 * t72);
  const Scalar t128 = s_2_3 * (t127 - s_4 * (t15 * Ic_4_xz + s_2_3 * t70));
  const Scalar c_4_1_1 = t15 * (t107 + t108) - t128;
  c[63] = c_4_1_1;
  c[37] = -c_6_2_2;
  const Scalar Iu_2_a_xz = Scalar(0.0222188) * s_2 + t120 - c_2 * (t100 - Scalar(0.0549346));
  c[2] = Scalar(-2.0) * Iu_2_a_xz;
  const Scalar t129 = s_2_3 * (c_4 * t99 - s_4 * t98) + t15 * t75;
  const Scalar t130 = s_2 * f_u_4_4_a_z + t124;
  c[7] = t130 - t129;
  const Scalar c_4_1_2 = t130 + t129;
  c[64] = c_4_1_2;
  c[48] = -c_4_1_3;
  c[53] = -c_5_2_3;
  c[6] = -c_4_1_1;
  c[27] = -c_4_1_2;
  const Scalar Ic_3_xy = Scalar(0.013088) + mu_4_3_x;
  const Scalar t131 = Scalar(2.0) * Ic_3_xy;
  const Scalar t132 = t9 - t121 - Scalar(2.0) * hu_5_t_y + Ic_4_zz - Scalar(0.95983695);
  const Scalar t133 = s_2_3 * t131 + t15 * t132;
  const Scalar t134 = c_2 * (t15 * hc_3_y - s_2_3 * df_2_3_x);
  const Scalar t135 = Scalar(0.0684948) * s_2 - t15 * df_2_3_x - s_2_3 * hc_3_y +
      Scalar(4.2001111) * c_2;
  const Scalar Ic_2_xy = mu_4_3_x + Scalar(0.0473354) - s_2_3 * t133 - t134 - s_2 * t135;
  c[1] = Scalar(2.0) * Ic_2_xy;
  c[21] = Scalar(-2.0) * Ic_2_xy;
  const Scalar t136 = t15 * (c_2 * hc_3_y - t15 * t131 + s_2_3 * t132);
  const Scalar c_3_1_1 = t134 + s_2_3 * (t133 - c_2 * df_2_3_x) + t136;
  c[42] = c_3_1_1;
  c[3] = -c_3_1_1;
  c[0] = c[22] = c[23] = c[24] = c[43] = c[45] = c[46] = c[47] = Scalar(0.0);
  c[69] = c[70] = c[71] = c[72] = c[94] = c[95] = c[96] = c[97] = Scalar(0.0);
  c[98] = c[120] = c[121] = c[122] = c[123] = c[124] = c[125] = Scalar(0.0);
}

// The entries of C in coriolis_matrix that are not always zero.
inline constexpr bool coriolis_matrix_nonzero[36] = {
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 0};

// C(q, qd) from the Christoffel symbols (7.44).
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   C[36]  out  c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric
//               6 x 6, row by row: entry (i, j) is C[6 * i + j]
// Reads q[1..5], qd[0..5]. Operations: 425 mul, 369 add, 10 sin/cos. Always zero: 1 of the 36
// entries of C.
template <class Scalar, class SinCos = LibrarySinCos>
inline void coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar I_t6_g = Scalar(0.0001273) * c_6 - Scalar(0.000256) * s_6;
  const Scalar t1 = s_6 * I_t6_g;
  const Scalar Ic_6_xy = t1 + Scalar(0.000128);
  const Scalar t2 = Scalar(2.0) * Ic_6_xy;
  C[28] = qd_6 * t2;
  const Scalar Iu_6_a_xy = Scalar(0.0004972) * c_6 - Scalar(0.000267) * s_6;
  const Scalar t3 = c_5 * Iu_6_a_xy;
  const Scalar t4 = s_5 * t2 - t3;
  const Scalar t5 = s_5 * (t3 - t4);
  const Scalar Ic_6_xz = Scalar(0.000267) * c_6 + Scalar(0.0004972) * s_6;
  const Scalar Ic_5_xy = Ic_6_xz + Scalar(0.00054285);
  const Scalar t6 = Scalar(2.0) * Ic_5_xy;
  const Scalar t7 = c_6 * I_t6_g;
  const Scalar Iu_5_t_d = t7 + Scalar(0.0042984);
  const Scalar t8 = s_5 * t6 - c_5 * Iu_5_t_d;
  const Scalar t9 = s_5 * t8;
  const Scalar dmu_4_5_y = c_5 * t6 + s_5 * Iu_5_t_d;
  const Scalar t10 = t9 - c_5 * dmu_4_5_y;
  C[21] = qd_6 * t5 - qd_5 * t10;
  const Scalar t11 = s_2 * s_3 - c_2 * c_3;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar v_2_3_x = s_2 * t11 + c_2 * s_2_3;
  const Scalar v_o_2_4_x = v_2_3_x - Scalar(1.0);
  const Scalar t12 = c_4 * s_5;
  const Scalar v_2_3_y = s_2 * s_2_3 - c_2 * t11;
  const Scalar t13 = v_o_2_4_x * t12 - c_5 * v_2_3_y;
  const Scalar mr_6_y = Scalar(0.00252) * c_6 - Scalar(0.001575) * s_6;
  const Scalar t14 = mr_6_y * t13;
  const Scalar t15 = s_5 * Ic_6_xz;
  const Scalar mu_u_6_5_t_y = Scalar(0.0006623) * c_5 + t15;
  const Scalar t16 = s_4 * mu_u_6_5_t_y;
  const Scalar t17 = t16 + t14;
  const Scalar dI_6_xy = Scalar(2.0) * t7 - Scalar(0.0001273);
  const Scalar t18 = s_4 * (t15 - c_5 * dI_6_xy) - c_4 * t2;
  const Scalar t19 = t14 - t18;
  const Scalar t20 = t17 - t19;
  const Scalar t21 = mr_6_y * t12;
  const Scalar dmu_3_6_y = t18 + t21;
  const Scalar db_36_5 = t16 - t21;
  const Scalar c_6_3_5 = db_36_5 + dmu_3_6_y;
  const Scalar t22 = s_2_3 * t12 + c_5 * t11;
  const Scalar t23 = Ic_6_xz * t22;
  const Scalar t24 = c_4 * c_5;
  const Scalar t25 = s_5 * t11 - s_2_3 * t24;
  const Scalar v_1_4_a_y = c_2 - s_2_3;
  const Scalar t26 = s_4 * s_5;
  const Scalar t27 = mr_6_y * v_1_4_a_y * t26;
  const Scalar t28 = Scalar(0.0006623) * t25 - t23 + t27;
  const Scalar t29 = s_4 * s_2_3;
  const Scalar db_15_6r = t23 + t25 * dI_6_xy + t29 * t2 + t27;
  const Scalar t30 = t28 - db_15_6r;
  const Scalar t31 = c_5 * Ic_6_xz;
  const Scalar dmu_4_6_y = s_5 * dI_6_xy + t31;
  const Scalar t32 = Scalar(0.0006623) * s_5 - t31;
  const Scalar c_5_4_6 = t32 - dmu_4_6_y;
  const Scalar C_65 = -qd_4 * c_5_4_6 - qd_5 * t2 + qd_3 * c_6_3_5 + qd_2 * t20 + qd_1 * t30;
  C[34] = C_65;
  const Scalar t33 = c_5 * t8;
  const Scalar t34 = t1 + Scalar(0.00050995);
  const Scalar Ic_5_yz = Iu_6_a_xy + Scalar(0.00080815);
  const Scalar Iu_5_a_xz = c_5 * t34 + s_5 * Ic_5_yz;
  const Scalar t35 = c_4 * Iu_5_a_xz;
  const Scalar t36 = t35 - s_4 * (t33 + s_5 * dmu_4_5_y);
  const Scalar t37 = s_4 * v_o_2_4_x;
  const Scalar f_u_6_6_a_z = Scalar(0.001575) * c_6 + Scalar(0.00252) * s_6;
  const Scalar t38 = f_u_6_6_a_z - Scalar(0.0045675);
  const Scalar hu_5_t_y = Scalar(0.0071325) * c_5 - s_5 * t38;
  const Scalar t39 = hu_5_t_y * t37;
  const Scalar t40 = t39 - t36;
  const Scalar mu_u_5_5_a_y = t7 - Scalar(0.0080301);
  const Scalar t41 = t35 + s_4 * mu_u_5_5_a_y;
  const Scalar db_25_4 = t41 + t39;
  const Scalar c_5_2_4 = db_25_4 - t40;
  const Scalar t42 = s_4 * hu_5_t_y;
  const Scalar t43 = t36 + t42;
  const Scalar db_35_4 = t41 - t42;
  const Scalar c_5_3_4 = db_35_4 + t43;
  const Scalar t44 = Iu_5_a_xz * t29;
  const Scalar t45 = c_4 * v_1_4_a_y;
  const Scalar t46 = hu_5_t_y * t45;
  const Scalar t47 = t44 - c_4 * s_2_3 * mu_u_5_5_a_y - t46;
  const Scalar t48 = t44 + t22 * dmu_4_5_y - t8 * t25 + t46;
  const Scalar t49 = t47 + t48;
  const Scalar t50 = qd_4 * t10 + qd_2 * c_5_2_4 + qd_1 * t49 + qd_3 * c_5_3_4;
  C[27] = qd_6 * c_5_4_6 + t50;
  const Scalar t51 = Scalar(2.0) * qd_6;
  C[29] = -Ic_6_xz * t51 - C_65;
  const Scalar v_2_5_x = s_5 * v_2_3_y + v_o_2_4_x * t24;
  const Scalar t52 = t38 * v_2_5_x + Scalar(0.0071325) * t13;
  const Scalar t53 = s_5 * t34 - c_5 * Ic_5_yz;
  const Scalar t54 = s_4 * t53;
  const Scalar t55 = t52 - t54;
  const Scalar t56 = s_4 * t8 - c_4 * t34;
  const Scalar t57 = t56 + Scalar(0.0071325) * t37;
  const Scalar t58 = s_4 * dmu_4_5_y - c_4 * Ic_5_yz;
  const Scalar t59 = t58 - t38 * t37;
  const Scalar t60 = t22 * t57 + t25 * t59 - t55 * t29;
  const Scalar t61 = s_2_3 * t53 + t11 * db_35_4;
  const Scalar t62 = s_2 * t42 + t61;
  const Scalar t63 = t62 - t60;
  const Scalar t64 = Scalar(0.0071325) * s_4 - t56;
  const Scalar t65 = t58 + s_4 * t38;
  const Scalar t66 = c_5 * t38 + Scalar(0.0071325) * s_5;
  const Scalar t67 = t54 + c_4 * t66;
  const Scalar t68 = t22 * t64 - t25 * t65 - t67 * t29;
  const Scalar t69 = t61 + t68;
  const Scalar t70 = s_4 * t66;
  const Scalar t71 = v_1_4_a_y * t70;
  const Scalar t72 = t34 * t22 + Ic_5_yz * t25 + t71;
  const Scalar t73 = t34 * t29 + t6 * t22 + Iu_5_t_d * t25 + Scalar(0.0071325) * t45;
  const Scalar dmu_1_5_x = t6 * t25 - Ic_5_yz * t29 - Iu_5_t_d * t22 + t38 * t45;
  const Scalar t74 = t45 * (Scalar(0.0071325) * t22 - t38 * t25);
  const Scalar t75 = t29 * (t71 + t72) + t22 * t73 - t25 * dmu_1_5_x + t74;
  const Scalar t76 = qd_1 * t75;
  const Scalar t77 = t47 - t48;
  const Scalar t78 = t28 + db_15_6r;
  const Scalar t79 = Scalar(2.0) * qd_5;
  C[4] = qd_6 * t78 + t72 * t79 + qd_4 * t77 + qd_3 * t69 + qd_2 * t63 + t76;
  const Scalar t80 = mr_6_y * t37 + f_u_6_6_a_z * v_2_5_x;
  const Scalar t81 = s_4 * c_5;
  const Scalar t82 = Iu_6_a_xy * t81 + c_4 * Ic_6_xz;
  const Scalar t83 = t82 - t80;
  const Scalar t84 = Iu_6_a_xy * t26 + f_u_6_6_a_z * t13;
  const Scalar t85 = t81 * t2 - c_4 * dI_6_xy;
  const Scalar t86 = t85 + t84;
  const Scalar t87 = t29 * t19 - t25 * t86 + t22 * t83;
  const Scalar t88 = s_4 * Iu_6_a_xy;
  const Scalar t89 = t88 - c_4 * t32;
  const Scalar t90 = c_4 * f_u_6_6_a_z;
  const Scalar f_u_6_4_a_z = mr_6_y * t81 + t90;
  const Scalar t91 = t89 + f_u_6_4_a_z;
  const Scalar t92 = s_2_3 * mu_u_6_5_t_y + t11 * t91;
  const Scalar t93 = t92 - s_2 * f_u_6_4_a_z;
  const Scalar t94 = t93 - t87;
  const Scalar t95 = t85 + s_5 * (t88 - t90);
  const Scalar t96 = f_u_6_6_a_z * t24 + s_4 * mr_6_y;
  const Scalar t97 = t82 + t96;
  const Scalar t98 = -t25 * t95 - t29 * dmu_3_6_y + t22 * t97;
  const Scalar t99 = t92 - t98;
  const Scalar t100 = s_5 * v_1_4_a_y;
  const Scalar t101 = s_4 * (s_2_3 * db_15_6r + (mr_6_y * t29 - f_u_6_6_a_z * t25) * t100);
  const Scalar t102 = s_4 * (s_2_3 * dI_6_xy - f_u_6_6_a_z * t100);
  const Scalar t103 = t25 * (Iu_6_a_xy * t22 - t25 * t2 + t102);
  const Scalar t104 = f_u_6_6_a_z * t81 - c_4 * mr_6_y;
  const Scalar t105 = v_1_4_a_y * t104;
  const Scalar t106 = -Iu_6_a_xy * t25 - Ic_6_xz * t29 + t105;
  const Scalar db_11_6r = t101 + t103 - t22 * (t105 + t106);
  const Scalar t107 = qd_1 * db_11_6r;
  const Scalar t108 = s_5 * Iu_6_a_xy;
  const Scalar t109 = s_4 * f_u_6_6_a_z - mr_6_y * t24;
  const Scalar t110 = v_1_4_a_y * t109;
  const Scalar t111 = t25 * t4 - t22 * t108 - t29 * dmu_4_6_y + t110;
  const Scalar t112 = s_2_3 * (s_4 * t32 + c_4 * Iu_6_a_xy) + t110;
  const Scalar t113 = t112 + t111;
  C[5] = qd_5 * t78 + qd_4 * t113 - qd_3 * t99 + t107 + t106 * t51 - qd_2 * t94;
  const Scalar t114 = dmu_4_6_y + t32;
  C[22] = -qd_6 * t114 - Iu_5_a_xz * t79 - t50;
  const Scalar t115 = t81 * t4 - c_4 * dmu_4_6_y;
  const Scalar t116 = t115 + s_5 * t84 + c_5 * t80;
  const Scalar t117 = t89 - v_o_2_4_x * f_u_6_4_a_z;
  const Scalar t118 = t117 + t116;
  const Scalar t119 = -t26 * t108 - t115 + f_u_6_4_a_z;
  const Scalar t120 = t91 - t119;
  const Scalar t121 = t112 - t111;
  const Scalar t122 = qd_4 * t5 - qd_1 * t121 + qd_3 * t120 + qd_2 * t118;
  C[23] = t108 * t51 - qd_5 * t114 + t122;
  const Scalar t123 = t80 * t26 - t13 * t104;
  const Scalar t124 = t123 - s_4 * (s_5 * t83 + c_5 * t86) + c_4 * t19;
  const Scalar t125 = t70 * t37 + c_4 * t52;
  const Scalar t126 = t125 + s_4 * (s_5 * t57 - c_5 * t59) + c_4 * t55;
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0004868);
  const Scalar t127 = Scalar(2.0) * Ic_4_xy;
  const Scalar Iu_4_t_d = t7 - t33 + Scalar(0.0037285);
  const Scalar t128 = s_4 * t127 - c_4 * Iu_4_t_d;
  const Scalar t129 = t66 + Scalar(0.02619);
  const Scalar t130 = t128 - t129 * v_2_3_y;
  const Scalar t131 = c_4 * t127 + s_4 * Iu_4_t_d;
  const Scalar hc_4_y = mr_6_y + Scalar(0.0482625);
  const Scalar t132 = t131 - hc_4_y * v_2_3_y;
  const Scalar t133 = s_4 * t129 - c_4 * hc_4_y;
  const Scalar t134 = t133 * v_2_3_y;
  const Scalar c_4_2_2 = s_4 * t130 - c_4 * t132 - t134;
  const Scalar f_u_4_4_a_z = c_4 * t129 + s_4 * hc_4_y;
  const Scalar df_2_3_x = f_u_4_4_a_z - Scalar(0.0617625);
  const Scalar hc_3_y = hu_5_t_y + Scalar(0.86193);
  const Scalar t135 = Scalar(-2.0) * (hc_3_y * v_2_3_y - df_2_3_x * v_2_3_x);
  C[7] = qd_6 * t124 + qd_5 * t126 - qd_4 * c_4_2_2 + qd_3 * t135;
  const Scalar t136 = s_4 * (s_5 * t64 + c_5 * t65) + c_4 * t67;
  const Scalar t137 = t125 - t136;
  const Scalar t138 = c_4 * hu_5_t_y * v_2_3_y - t66 * v_2_3_x;
  const Scalar t139 = t138 - t137;
  const Scalar t140 = c_4 * dmu_3_6_y + s_4 * (c_5 * t95 + s_5 * t97);
  const Scalar t141 = t123 - t140;
  const Scalar db_26_3 = v_2_3_y * t109 + s_5 * mr_6_y * v_2_3_x;
  const Scalar c_2_3_6 = db_26_3 + t141;
  const Scalar t142 = s_4 * t128;
  const Scalar t143 = t142 - c_4 * t131;
  const Scalar t144 = Scalar(2.0) * t134 - t143;
  const Scalar t145 = qd_2 + qd_3;
  C[8] = qd_6 * c_2_3_6 - qd_5 * t139 + qd_4 * t144 + t145 * t135;
  const Scalar t146 = t62 + t60;
  const Scalar t147 = qd_2 * t126 - qd_1 * t146;
  const Scalar c_2_4_5 = db_25_4 + t40;
  const Scalar t148 = t17 + t19;
  C[10] = qd_6 * t148 + qd_4 * c_2_4_5 - qd_3 * t139 + t147 + t55 * t79;
  const Scalar t149 = t66 + t136;
  const Scalar c_6_3_3 = t140 + s_5 * (s_4 * t96 - c_4 * t104);
  const Scalar t150 = qd_4 * t143;
  C[14] = -qd_6 * c_6_3_3 - t150 - qd_5 * t149;
  const Scalar t151 = t61 - t68;
  const Scalar t152 = qd_6 * t30 + t76 - qd_4 * t49 - qd_3 * t151 - qd_2 * t146;
  C[24] = -t152;
  const Scalar t153 = t93 + t87;
  const Scalar t154 = t92 + t98;
  const Scalar t155 = t107 - qd_5 * t30 - qd_4 * t121 + qd_3 * t154 + qd_2 * t153;
  C[30] = -t155;
  const Scalar c_6_2_3 = db_26_3 - t141;
  const Scalar t156 = qd_3 * c_6_3_3 - qd_1 * t154 + qd_2 * c_6_2_3;
  C[32] = qd_5 * c_6_3_5 - qd_4 * t120 + t156;
  C[33] = -qd_5 * c_5_4_6 - t122;
  const Scalar Ic_4_xz = Ic_6_xz - t9 - Scalar(0.00500195);
  const Scalar t157 = t53 + Scalar(0.0261804);
  const Scalar t158 = s_4 * t157 - c_4 * Ic_4_xz;
  const Scalar t159 = t158 + f_u_4_4_a_z * v_o_2_4_x;
  const Scalar t160 = s_2_3 * (c_4 * t130 + s_4 * t132) - t11 * t159;
  const Scalar mu_4_3_x = f_u_4_4_a_z - t158;
  const Scalar t161 = t11 * mu_4_3_x;
  const Scalar Ic_4_zz = t7 + t33 + Scalar(0.0284538);
  const Scalar t162 = s_2_3 * Ic_4_zz + t161;
  const Scalar t163 = t162 - s_2 * f_u_4_4_a_z;
  const Scalar t164 = t163 - t160;
  const Scalar t165 = s_4 * (s_2_3 * t128 + t11 * Ic_4_xz);
  const Scalar t166 = s_2_3 * (t165 - c_4 * (s_2_3 * t131 - t11 * t157));
  const Scalar t167 = s_4 * Ic_4_xz + c_4 * t157;
  const Scalar t168 = t133 * v_1_4_a_y;
  const Scalar t169 = s_2_3 * t167 - t168;
  const Scalar t170 = t166 - t11 * (t168 - t169);
  const Scalar t171 = qd_1 * t170;
  const Scalar t172 = c_4 * t128;
  const Scalar t173 = s_2_3 * (t172 + s_4 * t131) + t161;
  const Scalar t174 = t162 - t173;
  const Scalar t175 = Scalar(2.0) * qd_4;
  C[3] = qd_6 * t113 + qd_5 * t77 + t171 - t169 * t175 - qd_3 * t174 - qd_2 * t164;
  const Scalar t176 = qd_2 * t124 + qd_1 * t153;
  const Scalar t177 = t117 - t116;
  C[11] = qd_5 * t148 + t176 - t83 * t51 - qd_4 * t177 + qd_3 * c_2_3_6;
  const Scalar t178 = t138 + t137;
  C[13] = -qd_6 * c_6_2_3 - t150 + qd_5 * t178 - qd_2 * t135;
  const Scalar t179 = t91 + t119;
  const Scalar c_3_5_6 = db_36_5 - dmu_3_6_y;
  C[17] = qd_5 * c_3_5_6 - qd_4 * t179 - t156 - t97 * t51;
  const Scalar t180 = t173 + t162;
  const Scalar t181 = t143 * t145 - qd_1 * t180;
  C[20] = qd_6 * t120 - qd_5 * c_5_3_4 + t181;
  C[25] = qd_4 * c_5_2_4 - qd_6 * t20 - qd_3 * t178 - t147;
  const Scalar t182 = qd_3 * t149 - qd_2 * t178 + qd_1 * t151;
  C[26] = qd_4 * c_5_3_4 - qd_6 * c_6_3_5 + t182;
  const Scalar c_3_4_5 = db_35_4 - t43;
  C[15] = qd_5 * c_3_4_5 - qd_6 * t179 - t181 - mu_4_3_x * t175;
  C[16] = qd_6 * c_3_5_6 - t67 * t79 + qd_4 * c_3_4_5 - t182;
  const Scalar t183 = t163 + t160;
  const Scalar t184 = qd_6 * t121 + qd_5 * t49 + t171 + qd_3 * t180 + qd_2 * t183;
  C[18] = -t184;
  const Scalar t185 = qd_2 * c_4_2_2 - qd_1 * t183;
  C[19] = qd_6 * t118 + qd_3 * t143 - qd_5 * c_5_2_4 + t185;
  C[31] = qd_5 * t20 - t176 - qd_4 * t118 + qd_3 * c_6_2_3;
  const Scalar Ic_3_xy = Scalar(0.013088) + mu_4_3_x;
  const Scalar t186 = Scalar(2.0) * Ic_3_xy;
  const Scalar t187 = t7 + t172 - Scalar(2.0) * hu_5_t_y + Ic_4_zz - Scalar(0.95983695);
  const Scalar t188 = s_2_3 * t186 - t11 * t187;
  const Scalar t189 = t11 * (t11 * t186 + s_2_3 * t187 + c_2 * hc_3_y);
  const Scalar t190 = c_2 * (s_2_3 * df_2_3_x + t11 * hc_3_y);
  const Scalar t191 = t190 - s_2_3 * (t188 - c_2 * df_2_3_x) + t189;
  const Scalar t192 = Scalar(0.0684948) * s_2 + t11 * df_2_3_x - s_2_3 * hc_3_y +
      Scalar(4.2001111) * c_2;
  const Scalar Ic_2_xy = mu_4_3_x + Scalar(0.0473354) + t190 - s_2_3 * t188 - s_2 * t192;
  const Scalar t193 = Scalar(2.0) * Ic_2_xy;
  C[0] = qd_6 * db_11_6r + qd_5 * t75 + qd_4 * t170 + qd_3 * t191 + qd_2 * t193;
  const Scalar t194 = t11 * (Iu_5_a_xz - t142 - Scalar(0.0085553)) +
      s_2_3 * (t167 + Scalar(0.0204192) + t133);
  const Scalar Iu_2_a_xz = Scalar(0.0222188) * s_2 - t194 + c_2 * (t133 + Scalar(0.0549346));
  const Scalar t195 = qd_3 * t194 - qd_2 * Iu_2_a_xz + qd_1 * Ic_2_xy;
  C[1] = qd_5 * t63 - qd_6 * t94 - qd_4 * t164 + Scalar(2.0) * t195;
  const Scalar t196 = qd_1 * t191;
  C[2] = qd_5 * t69 - qd_6 * t99 - qd_4 * t174 + Scalar(2.0) * t194 * t145 + t196;
  C[6] = qd_6 * t153 - qd_5 * t146 + qd_4 * t183 - qd_1 * t193;
  const Scalar t197 = qd_6 * t177 - qd_5 * c_2_4_5 + t185 - qd_3 * t144 - t159 * t175;
  C[9] = -t197;
  C[12] = qd_6 * t154 - qd_5 * t151 + qd_4 * t180 - t196;
  C[35] = Scalar(0.0);
}

// Gravity torques g(q) (7.39).
//   q[6]  in   joint positions, rad or m
//   g[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5]. Operations: 29 mul, 19 add, 10 sin/cos. Always zero: g[0].
template <class Scalar, class SinCos = LibrarySinCos>
inline void gravity(const Scalar* q, Scalar* g, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = Scalar(0.06867) * c_6 + Scalar(0.109872) * s_6;
  const Scalar t2 = t1 - Scalar(0.199143);
  const Scalar hu_5_t_y = Scalar(0.310977) * c_5 - s_5 * t2;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t3 = c_4 * s_2_3;
  const Scalar t4 = Scalar(0.310977) * s_5 + c_5 * t2;
  const Scalar t5 = s_2 * s_3 - c_2 * c_3;
  g[4] = t5 * t4 - hu_5_t_y * t3;
  const Scalar hu_6_t_y = Scalar(0.109872) * c_6 - Scalar(0.06867) * s_6;
  g[5] = hu_6_t_y * (s_5 * t5 - c_5 * t3) + s_4 * s_2_3 * t1;
  const Scalar t6 = t4 + Scalar(1.141884);
  const Scalar hc_4_y = hu_6_t_y + Scalar(2.104245);
  g[3] = s_2_3 * (s_4 * t6 - c_4 * hc_4_y);
  const Scalar hc_3_y = hu_5_t_y + Scalar(37.580148);
  const Scalar t7 = s_2_3 * hc_3_y - t5 * (c_4 * t6 + s_4 * hc_4_y - Scalar(2.692845));
  g[2] = -t7;
  g[1] = Scalar(4.102542) * s_2 - t7 + Scalar(194.232114) * c_2;
  g[0] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   n[6]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5], qd[0..5]. Operations: 194 mul, 168 add, 10 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = s_2_3 * qd_1;
  const Scalar t2 = c_4 * t1;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t3 = s_4 * omega_3_z - t2;
  const Scalar t4 = s_2 * s_3 - c_2 * c_3;
  const Scalar t5 = t4 * qd_1;
  const Scalar omega_4_z = qd_4 - t5;
  const Scalar omega_r_5_y = s_5 * t3 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t6 = omega_6_z * omega_6_z;
  const Scalar t7 = s_4 * t1;
  const Scalar omega_r_5_a_z = t7 + c_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t8 = omega_5_z * omega_5_z;
  const Scalar t9 = t8 + t6;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t3;
  const Scalar t10 = omega_r_5_x * omega_r_5_x;
  const Scalar t11 = t10 + t8;
  const Scalar I_6_xz = Scalar(0.000534) * c_6 + Scalar(0.0009944) * s_6;
  const Scalar t12 = t3 * omega_r_5_a_z;
  const Scalar t13 = omega_3_z * t1;
  const Scalar U_4_xy = t12 + t13;
  const Scalar t14 = Scalar(2.0) * omega_3_z;
  const Scalar t15 = (t7 + c_4 * t14) * t5;
  const Scalar t16 = t15 + Scalar(2.0) * omega_r_5_a_z * omega_4_z;
  const Scalar t17 = s_5 * U_4_xy + c_5 * t16;
  const Scalar t18 = Scalar(2.0) * omega_5_z;
  const Scalar t19 = t17 - omega_r_5_y * t18;
  const Scalar t20 = t19 + t18 * omega_6_z;
  const Scalar I_t6_g = Scalar(0.0002546) * c_6 - Scalar(0.000512) * s_6;
  const Scalar I_6_xy = s_6 * I_t6_g + Scalar(0.000256);
  const Scalar t21 = t8 - t10;
  const Scalar t22 = t3 * t3;
  const Scalar t23 = omega_4_z * omega_4_z;
  const Scalar Uz_o_5_y = t23 + t22;
  const Scalar t24 = Uz_o_5_y + t21;
  const Scalar t25 = omega_r_5_x * omega_r_5_y;
  const Scalar t26 = t3 * omega_4_z;
  const Scalar t27 = (t2 - s_4 * t14) * t5;
  const Scalar t28 = t26 - t27;
  const Scalar t29 = t25 + t28;
  const Scalar t30 = t29 - Scalar(2.0) * omega_r_5_x * omega_6_z;
  const Scalar t31 = c_6 * I_t6_g;
  const Scalar t32 = t31 - Scalar(0.0007896);
  const Scalar t33 = s_2 * qd_2;
  const Scalar t34 = qd_2 * t33 - Scalar(21.8);
  const Scalar t35 = qd_1 * qd_1;
  const Scalar t36 = c_2 * (qd_2 * qd_2 + t35);
  const Scalar t37 = s_2_3 * t34 - t4 * t36;
  const Scalar t38 = t1 * t5;
  const Scalar t39 = t38 + t37;
  const Scalar t40 = qd_1 * t33;
  const Scalar t41 = t14 * t5 - Scalar(2.0) * t40;
  const Scalar t42 = s_4 * t41 - c_4 * t39;
  const Scalar t43 = t1 * t1;
  const Scalar t44 = omega_3_z * omega_3_z;
  const Scalar t45 = t43 + t44;
  const Scalar t46 = s_2_3 * t36 + t4 * t34;
  const Scalar t47 = t45 - t46;
  const Scalar t48 = s_5 * t42 + c_5 * t47;
  const Scalar t49 = Scalar(0.00315) * c_6 + Scalar(0.00504) * s_6;
  const Scalar t50 = t49 - Scalar(0.009135);
  const Scalar t51 = s_5 * t47 - c_5 * t42;
  const Scalar t52 = s_5 * t16 - c_5 * U_4_xy;
  const Scalar t53 = Scalar(0.0009944) * c_6 - Scalar(0.000534) * s_6;
  const Scalar t54 = t28 - t25;
  const Scalar n_5 = Scalar(0.0007639) * t17 + I_6_xz * (t11 - t9) + t20 * I_6_xy -
      Scalar(0.0029421) * t54 - Scalar(0.0010857) * (t24 - t11) + t30 * t32 +
      t52 * (t53 + Scalar(0.0016163)) + t48 * t50 - Scalar(0.0123285) * t29 +
      Scalar(0.014265) * t51;
  n[4] = n_5;
  const Scalar t55 = t10 + t6;
  const Scalar t56 = t52 - omega_r_5_x * t18;
  const Scalar mr_6_y = Scalar(0.00504) * c_6 - Scalar(0.00315) * s_6;
  const Scalar I_6_xx = t31 + Scalar(0.000535);
  const Scalar t57 = s_4 * t39 + c_4 * t41;
  const Scalar t58 = I_6_xy * (t9 - t55) - t52 * I_6_xx + t19 * I_6_xz + t29 * t53 + t56 * t32 -
      mr_6_y * t51 + t49 * t57;
  n[5] = -t58;
  const Scalar t59 = Scalar(-0.0007639) * t21 - Scalar(0.0016163) * t29 - Scalar(0.0010857) * t19 +
      Scalar(0.0029421) * t56 + Scalar(0.009135) * t57 - t58;
  const Scalar U_6_yy_zz = t11 - t55;
  const Scalar U_5_yy_zz = Uz_o_5_y - t11;
  const Scalar t60 = t53 * U_6_yy_zz - t30 * I_6_xy - Scalar(0.0007639) * t54 -
      Scalar(0.0016163) * U_5_yy_zz + t20 * I_6_xx - t56 * (I_6_xz + Scalar(0.0010857)) +
      mr_6_y * t48 + Scalar(0.014265) * t57 + Scalar(0.0123285) * t19;
  const Scalar t61 = t23 - t22;
  const Scalar t62 = t45 + t61;
  const Scalar t63 = t12 - t13;
  const Scalar t64 = Scalar(-0.0009736) * (t62 - Uz_o_5_y) - Scalar(0.0123968) * t63 -
      Scalar(0.0110896) * t15 - c_5 * t59 + Scalar(0.0316473) * U_4_xy + s_5 * t60 +
      Scalar(0.0523608) * t27 + Scalar(0.096525) * t42 + Scalar(0.05238) * t57;
  n[3] = -t64;
  const Scalar t65 = Scalar(0.009135) * t54 + mr_6_y * t20 - t49 * t30 + Scalar(0.014265) * t11;
  const Scalar t66 = mr_6_y * t52 - t49 * t9 + Scalar(0.009135) * t24 - Scalar(0.014265) * t29;
  const Scalar f_4_x = s_5 * t65 - c_5 * t66 + Scalar(0.05238) * t62 + Scalar(0.096525) * U_4_xy +
      Scalar(1.72386) * t42;
  const Scalar t67 = mr_6_y * t55 + t56 * t50 + Scalar(0.05238) * t63 - Scalar(0.014265) * t19 +
      Scalar(0.096525) * Uz_o_5_y - Scalar(1.72386) * t57;
  const Scalar f_u_4_t_x = s_4 * t67 + c_4 * f_4_x;
  const Scalar t68 = t26 + t28;
  const Scalar U_4_yy_zz = t45 - Uz_o_5_y;
  const Scalar t69 = Scalar(0.0009736) * t68 + Scalar(0.0110896) * t63 + s_5 * t59 + c_5 * t60 +
      Scalar(0.0316473) * t16 - Scalar(0.0523608) * U_4_yy_zz + Scalar(0.096525) * t47;
  const Scalar t70 = Scalar(0.0110896) * t61 - Scalar(0.0009736) * t16 - Scalar(0.0123968) * t68 +
      n_5 + Scalar(0.0523608) * U_4_xy + Scalar(0.05238) * t47;
  const Scalar t71 = t44 - t43;
  const Scalar t72 = t35 + t71;
  const Scalar n_3 = Scalar(0.1673569) * t38 - Scalar(0.026176) * (t72 - t45) + c_4 * t70 +
      Scalar(0.123525) * t46 + s_4 * t69 - f_u_4_t_x;
  n[2] = n_3;
  const Scalar t73 = s_3 * (Scalar(0.123525) * t72 - f_u_4_t_x + Scalar(7.18587) * t37);
  const Scalar t74 = s_5 * t66 + c_5 * t65 + Scalar(0.123525) * t38 - Scalar(0.05238) * t68 +
      Scalar(0.096525) * t16 + Scalar(1.72386) * t45 - Scalar(8.90973) * t46;
  const Scalar I_t2_g = Scalar(0.5095078) * c_2 - Scalar(0.1369896) * s_2;
  const Scalar I_2_xy = Scalar(0.0684948) + s_2 * I_t2_g;
  n[1] = Scalar(4.102542) * s_2 - t35 * I_2_xy + n_3 - t73 - c_3 * t74;
  const Scalar f_u_4_t_y = s_4 * f_4_x - c_4 * t67;
  const Scalar f_3_z = Scalar(0.24705) * t13 - f_u_4_t_y + Scalar(14.37174) * t40;
  const Scalar U_3_yy_zz = t35 - t45;
  const Scalar t75 = omega_3_z * t5;
  const Scalar t76 = Scalar(0.016137) * t38 + Scalar(0.052352) * t13 +
      Scalar(0.0408384) * U_3_yy_zz - s_4 * t70 + c_4 * t69 + Scalar(0.4829488) * t75 + f_u_4_t_y;
  const Scalar t77 = Scalar(0.016137) * t71 - Scalar(0.0408384) * t38 - Scalar(0.052352) * t75 -
      Scalar(0.148235) * t13 - Scalar(0.24705) * t40 - t64;
  const Scalar t78 = qd_2 * (Scalar(0.0444376) * s_2 + Scalar(0.1098692) * c_2) -
      Scalar(2.0) * qd_1 * I_2_xy;
  n[0] = -t4 * t77 - qd_2 * t78 - s_2_3 * t76 - c_2 * f_3_z;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   tau[6]  in   joint torques or forces, N m or N
//   qdd[6]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[1..5], qd[0..5], tau[0..5]. Operations: 353 mul, 284 add, 5 div, 10 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar tau_1 = tau[0], tau_2 = tau[1], tau_3 = tau[2], tau_4 = tau[3], tau_5 = tau[4],
      tau_6 = tau[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar Iu_6_t_g = Scalar(0.0002546) * c_6 - Scalar(0.000512) * s_6;
  const Scalar t1 = c_6 * Iu_6_t_g;
  const Scalar Iu_6_t_xx = t1 - Scalar(0.0002546);
  const Scalar Iu_5_t_d = Iu_6_t_xx + Scalar(0.0088514);
  const Scalar Iu_6_t_xz = Scalar(0.000534) * c_6 + Scalar(0.0009944) * s_6;
  const Scalar Ic_5_xy = Iu_6_t_xz + Scalar(0.0010857);
  const Scalar t2 = Scalar(2.0) * s_5 * Ic_5_xy - c_5 * Iu_5_t_d;
  const Scalar t3 = c_5 * t2;
  const Scalar t4 = t3 + Scalar(0.0088514);
  const Scalar mu_u_5_5_a_y = t1 - Scalar(0.0160602);
  const Scalar t5 = mu_u_5_5_a_y + Scalar(0.0323686);
  const Scalar Iu_6_t_xy = s_6 * Iu_6_t_g + Scalar(0.000256);
  const Scalar t6 = Iu_6_t_xy + Scalar(0.0007639);
  const Scalar Iu_6_a_xy = Scalar(0.0009944) * c_6 - Scalar(0.000534) * s_6;
  const Scalar Ic_5_yz = Iu_6_a_xy + Scalar(0.0016163);
  const Scalar Iu_5_a_xz = c_5 * t6 + s_5 * Ic_5_yz;
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0009736);
  const Scalar t7 = Scalar(2.0) * s_4 * Ic_4_xy + c_4 * (t4 - t5);
  const Scalar t8 = c_4 * t7;
  const Scalar t9 = t8 + t5;
  const Scalar t10 = t4 - t8;
  const Scalar t11 = t9 - t10;
  const Scalar Iu_5_t_yy = Iu_6_t_xx + t3;
  const Scalar Ic_4_zz = Iu_5_t_yy + Scalar(0.0571622);
  const Scalar Iu_4_x = Ic_4_zz + t11;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t12 = s_2_3 * qd_1;
  const Scalar Iu_5_t_xy = Ic_5_xy - s_5 * t2;
  const Scalar Ic_4_xz = Iu_5_t_xy - Scalar(0.0110896);
  const Scalar t13 = s_5 * t6 - c_5 * Ic_5_yz;
  const Scalar t14 = t13 + Scalar(0.0523608);
  const Scalar t15 = s_4 * t14 - c_4 * Ic_4_xz;
  const Scalar t16 = s_2 * s_3 - c_2 * c_3;
  const Scalar t17 = Scalar(2.0) * qd_1;
  const Scalar beta_4_f = qd_4 - t16 * t17;
  const Scalar Iu_4_t_xy = Ic_4_xy - s_4 * t7;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t18 = Scalar(2.0) * omega_3_z;
  const Scalar t19 = qd_4 * ((t12 * Iu_4_x + t15 * beta_4_f) + Iu_4_t_xy * t18);
  const Scalar t20 = Iu_5_t_yy + t4;
  const Scalar t21 = t16 * qd_1;
  const Scalar omega_4_z = qd_4 - t21;
  const Scalar t22 = s_4 * t12;
  const Scalar omega_r_5_a_z = t22 + c_4 * omega_3_z;
  const Scalar t23 = Scalar(2.0) * omega_r_5_a_z;
  const Scalar beta_5_f = qd_5 + t23;
  const Scalar t24 = Scalar(2.0) * Iu_5_t_xy;
  const Scalar t25 = c_4 * t12;
  const Scalar t26 = s_4 * omega_3_z - t25;
  const Scalar t27 = qd_5 * ((omega_4_z * (t20 + mu_u_5_5_a_y) - t13 * beta_5_f) - t26 * t24);
  const Scalar omega_r_5_y = s_5 * t26 + c_5 * omega_4_z;
  const Scalar t28 = Scalar(2.0) * omega_r_5_y;
  const Scalar beta_6_f = qd_6 + t28;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar Iu_6_d = t1 + Iu_6_t_xx;
  const Scalar Iu_6_y = Iu_6_d + Scalar(0.0013246);
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t26;
  const Scalar t29 = Scalar(2.0) * Iu_6_t_xy;
  const Scalar t30 = omega_r_5_x * t29 + (omega_5_z * Iu_6_y - Iu_6_a_xy * beta_6_f);
  const Scalar t31 = c_5 * qd_6;
  const Scalar t32 = t30 * t31 + t27;
  const Scalar f_u_6_6_a_z = Scalar(0.00315) * c_6 + Scalar(0.00504) * s_6;
  const Scalar hu_6_t_y = Scalar(0.00504) * c_6 - Scalar(0.00315) * s_6;
  const Scalar t33 = Scalar(2.0) * (f_u_6_6_a_z * omega_r_5_x + hu_6_t_y * omega_5_z);
  const Scalar t34 = s_5 * qd_6;
  const Scalar t35 = f_u_6_6_a_z * beta_6_f;
  const Scalar t36 = qd_5 * beta_5_f;
  const Scalar t37 = f_u_6_6_a_z - Scalar(0.009135);
  const Scalar t38 = c_5 * t37 + Scalar(0.014265) * s_5;
  const Scalar f_a_5_x = t33 * t34 + t35 * t31 + t38 * t36;
  const Scalar hu_5_t_y = Scalar(0.014265) * c_5 - s_5 * t37;
  const Scalar t39 = qd_5 * (hu_5_t_y * omega_4_z + t38 * t26);
  const Scalar t40 = hu_6_t_y * qd_6 * beta_6_f + Scalar(2.0) * t39;
  const Scalar t41 = t38 + Scalar(0.05238);
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.096525);
  const Scalar f_u_4_4_a_z = c_4 * t41 + s_4 * hc_4_y;
  const Scalar t42 = qd_4 * beta_4_f;
  const Scalar f_a_4_x = c_4 * f_a_5_x + s_4 * t40 + f_u_4_4_a_z * t42;
  const Scalar t43 = qd_6 * ((omega_r_5_x * (Iu_6_d - Scalar(0.0013246)) + Iu_6_t_xz * beta_6_f) -
      omega_5_z * t29);
  const Scalar t44 = c_4 * t43 - s_4 * t32 - t19 + f_a_4_x;
  const Scalar t45 = s_4 * Ic_4_xz + c_4 * t14;
  const Scalar t46 = s_2_3 * omega_3_z * Iu_4_x + t16 * (t45 * t12 - t15 * t18);
  const Scalar t47 = qd_5 * ((Iu_5_a_xz * beta_5_f + t26 * (mu_u_5_5_a_y - t20)) - omega_4_z * t24);
  const Scalar t48 = t30 * t34 + t47;
  const Scalar t49 = t21 * (t22 + c_4 * t18) + omega_4_z * t23;
  const Scalar U_4_xy = t26 * omega_r_5_a_z + omega_3_z * t12;
  const Scalar U_5_zy = omega_5_z * t28 - s_5 * U_4_xy - c_5 * t49;
  const Scalar t50 = qd_1 * qd_1;
  const Scalar t51 = qd_2 * qd_2;
  const Scalar t52 = s_2 * t51 - Scalar(21.8);
  const Scalar t53 = c_2 * (t51 + t50);
  const Scalar t54 = t16 * t53 - s_2_3 * (t16 * t50 + t52);
  const Scalar t55 = (t16 * omega_3_z - s_2 * qd_2) * t17;
  const Scalar t56 = s_4 * t55 + c_4 * t54;
  const Scalar t57 = t12 * t12;
  const Scalar t58 = omega_3_z * omega_3_z;
  const Scalar t59 = -s_2_3 * t53 - t16 * t52 + (t57 + t58);
  const Scalar t60 = hu_6_t_y * (s_5 * t59 - c_5 * t56);
  const Scalar t61 = omega_r_5_x * omega_5_z;
  const Scalar t62 = t61 + c_5 * U_4_xy - s_5 * t49;
  const Scalar t63 = t26 * omega_4_z;
  const Scalar domega_4_y = t63 - t21 * (t25 - s_4 * t18);
  const Scalar U_5_xy = omega_r_5_x * omega_r_5_y + domega_4_y;
  const Scalar t64 = Iu_6_t_xy * (omega_5_z * omega_5_z - omega_r_5_x * omega_r_5_x);
  const Scalar t65 = f_u_6_6_a_z * (s_4 * t54 - c_4 * t55);
  const Scalar y_6 = t64 - t61 * Iu_6_d + Iu_6_a_xy * U_5_xy - Iu_6_t_xz * U_5_zy +
      Scalar(0.0013246) * t62 - t60 - t65 + tau_6;
  const Scalar t66 = Scalar(754.9448890231013) * Iu_6_a_xy;
  const Scalar t67 = Iu_5_t_xy * (omega_4_z * omega_4_z - t26 * t26);
  const Scalar t68 = t43 - t13 * U_4_xy - Iu_5_a_xz * t49 + t67 + t63 * t20 + hu_5_t_y * t56 -
      t38 * t59 - mu_u_5_5_a_y * domega_4_y - t66 * y_6 + tau_5;
  const Scalar mu_u_6_5_t_y = Scalar(0.0013246) * c_5 + s_5 * Iu_6_t_xz;
  const Scalar t69 = mu_u_6_5_t_y * t66 + t13;
  const Scalar t70 = Iu_6_a_xy * t66 + mu_u_5_5_a_y;
  const Scalar t71 = Scalar(1.0) / t70;
  const Scalar t72 = t69 * t71;
  const Scalar t73 = Scalar(754.9448890231013) * mu_u_6_5_t_y;
  const Scalar t74 = s_4 * t41 - c_4 * hc_4_y;
  const Scalar y_5_4 = t48 + Iu_4_t_xy * (t58 - t57) + qd_1 * t46 - t72 * t68 - t74 * t54 +
      f_u_4_4_a_z * t55 + tau_4 - t73 * y_6;
  const Scalar t75 = t45 + t74;
  const Scalar t76 = mu_u_5_5_a_y - hu_5_t_y;
  const Scalar t77 = s_4 * Iu_5_a_xz - c_4 * t76;
  const Scalar t78 = c_5 * hu_6_t_y;
  const Scalar t79 = s_4 * f_u_6_6_a_z - c_4 * t78;
  const Scalar t80 = Scalar(0.0013246) * s_5 - c_5 * Iu_6_t_xz;
  const Scalar t81 = -s_4 * t80 - c_4 * Iu_6_a_xy + t79;
  const Scalar t82 = t81 * t66 + t77;
  const Scalar t83 = t82 * t72 - t81 * t73 + t75;
  const Scalar b_5_4_4 = t69 * t72 - mu_u_6_5_t_y * t73 + Ic_4_zz;
  const Scalar d_4 = Scalar(1.0) / b_5_4_4;
  const Scalar t84 = t83 * d_4;
  const Scalar t85 = Scalar(2.0) * hu_5_t_y;
  const Scalar t86 = t9 - t85;
  const Scalar mu_4_3_x = f_u_4_4_a_z - t15;
  const Scalar Ic_3_xy = Scalar(0.026176) + mu_4_3_x;
  const Scalar t87 = Scalar(2.0) * s_2_3 * Ic_3_xy - t16 * (Ic_4_zz + t86 - Scalar(1.9359823));
  const Scalar Iu_3_t_xy = Ic_3_xy - s_2_3 * t87;
  const Scalar t88 = t82 * t71;
  const Scalar t89 = Scalar(-754.9448890231013) * t81;
  const Scalar t90 = f_u_4_4_a_z - Scalar(0.123525);
  const Scalar hc_3_y = hu_5_t_y + Scalar(1.72386);
  const Scalar t91 = s_2_3 * t90 + t16 * hc_3_y;
  const Scalar t92 = s_2_3 * hc_3_y - t16 * t90;
  const Scalar y_4_3 = t44 + tau_3 + t88 * t68 + Iu_3_t_xy * t50 + t91 * t53 + t84 * y_5_4 -
      t89 * y_6 - t92 * t52;
  const Scalar t93 = t10 - t85 - Scalar(2.0842173);
  const Scalar t94 = -t82 * t88 - t81 * t89 + t83 * t84 + t93;
  const Scalar t95 = Scalar(1.0) / t94;
  const Scalar t96 = t81 - s_3 * t79 + c_3 * s_5 * hu_6_t_y;
  const Scalar t97 = t96 * t66 - s_3 * c_4 * hu_5_t_y + t77 - c_3 * t38;
  const Scalar t98 = t97 * t72 - t96 * t73 - s_3 * t74 + t75;
  const Scalar t99 = c_3 * t90 + s_3 * hc_3_y;
  const Scalar t100 = -t96 * t89 - t97 * t88 + t98 * t84 + t99 + t93;
  const Scalar t101 = t100 * t95;
  const Scalar t102 = Scalar(0.1369896) * s_2 + Scalar(8.4002222) * c_2;
  const Scalar Ic_2_xy = Scalar(0.0684948) + Iu_3_t_xy + c_2 * t91 - s_2 * (t102 - t92);
  const Scalar t103 = t98 * d_4;
  const Scalar t104 = qd_4 * (t74 * omega_3_z - f_u_4_4_a_z * t12);
  const Scalar t105 = t33 * t31 - t34 * t35 + hu_5_t_y * t36 - Scalar(2.0) * t104;
  const Scalar beta_3_f = qd_3 + Scalar(2.0) * qd_2;
  const Scalar t106 = qd_3 * beta_3_f;
  const Scalar f_a_3_x = s_2_3 * t105 - t16 * f_a_4_x + t92 * t106;
  const Scalar t107 = c_2 * ((s_2_3 * f_a_4_x + t16 * t105 + t91 * t106) + Scalar(194.232114));
  const Scalar t108 = t97 * t71;
  const Scalar t109 = Scalar(-754.9448890231013) * t96;
  const Scalar t110 = t44 + tau_2 + t108 * t68 + Scalar(21.8) * t92 + t103 * y_5_4 +
      s_2 * (f_a_3_x - Scalar(4.102542)) - t101 * y_4_3 - t109 * y_6 + Ic_2_xy * t50 - t107;
  const Scalar t111 = -t97 * t108 - t96 * t109 + t98 * t103 + t93 + Scalar(2.0) * t99 -
      t100 * t101 - Scalar(8.554441);
  const Scalar t112 = Scalar(1.0) / t111;
  const Scalar t113 = Iu_4_t_xy - Scalar(0.016137);
  const Scalar t114 = Scalar(0.0408384) + t75;
  const Scalar t115 = s_2_3 * t113 - t16 * t114;
  const Scalar t116 = s_2_3 * (c_4 * Iu_5_a_xz + s_4 * t76);
  const Scalar f_u_6_4_a_z = s_4 * t78 + c_4 * f_u_6_6_a_z;
  const Scalar mu_6_3_x = s_4 * Iu_6_a_xy - c_4 * t80 + f_u_6_4_a_z;
  const Scalar t117 = t16 * mu_u_6_5_t_y + c_2 * f_u_6_4_a_z - s_2_3 * mu_6_3_x;
  const Scalar b_6_5_1 = t16 * t13 + t117 * t66 - c_2 * s_4 * hu_5_t_y - t116;
  const Scalar t118 = b_6_5_1 * t72 - t117 * t73 + c_2 * f_u_4_4_a_z - s_2_3 * mu_4_3_x +
      t16 * Ic_4_zz;
  const Scalar t119 = -b_6_5_1 * t88 - t117 * t89 + t115 + t118 * t84;
  const Scalar t120 = t74 + Scalar(0.1098692);
  const Scalar b_3_2_1 = b_6_5_1 * t108 + t117 * t109 + Scalar(0.0444376) * c_2 - t115 -
      s_2 * t120 + t119 * t101 - t118 * t103;
  const Scalar t121 = b_3_2_1 * t112;
  const Scalar t122 = t17 * (Iu_3_t_xy * qd_3 + Ic_2_xy * qd_2);
  const Scalar t123 = t119 * t95;
  const Scalar Iu_4_y = Ic_4_zz - t11;
  const Scalar t124 = qd_4 * (Scalar(2.0) * Iu_4_t_xy * t12 +
      (t45 * beta_4_f + omega_3_z * Iu_4_y));
  const Scalar t125 = s_4 * f_a_5_x - c_4 * t40 + t74 * t42;
  const Scalar t126 = s_2_3 * (s_4 * t43 + c_4 * t32 + t125 + t124);
  const Scalar t127 = t118 * d_4;
  const Scalar t128 = t16 * t113 + s_2_3 * t114;
  const Scalar Iu_2_a_xz = Scalar(0.0444376) * s_2 - t128 + c_2 * t120;
  const Scalar t129 = c_2 * (t125 + t91 * qd_3 * t17);
  const Scalar t130 = b_6_5_1 * t71;
  const Scalar t131 = Scalar(-754.9448890231013) * t117;
  const Scalar y_2_1 = Iu_2_a_xz * t51 - t16 * t48 - t128 * t106 + t126 - t123 * y_4_3 +
      t121 * t110 + tau_1 + t130 * t68 - t129 + t127 * y_5_4 - t131 * y_6 - t122;
  const Scalar t132 = c_2 * (t102 - Scalar(2.0) * t92);
  const Scalar t133 = -b_3_2_1 * t121 - t119 * t123 - b_6_5_1 * t130 - t117 * t131 + t86 +
      t118 * t127 + t16 * t87 - Scalar(2.8931568) - t132;
  const Scalar t134 = y_2_1 / t133;
  qdd[0] = -t134;
  const Scalar t135 = t112 * (b_3_2_1 * t134 + t110);
  qdd[1] = -t135;
  const Scalar t136 = t95 * (y_4_3 - (t119 * t134 + t100 * t135));
  qdd[2] = -t136;
  const Scalar qdd_4 = d_4 * ((y_5_4 - t83 * t136) - (t118 * t134 + t98 * t135));
  qdd[3] = qdd_4;
  const Scalar t137 = (b_6_5_1 * t134 + t97 * t135) + t68;
  const Scalar t138 = t71 * ((t82 * t136 + t69 * qdd_4) + t137);
  qdd[4] = -t138;
  const Scalar t139 = (t96 * t135 + t81 * t136) - (y_6 - t117 * t134);
  qdd[5] = Scalar(-754.9448890231013) * (mu_u_6_5_t_y * qdd_4 - Iu_6_a_xy * t138) -
      Scalar(754.9448890231013) * t139;
  bool positive = -t133 > Scalar(0.0);
  positive &= -t111 > Scalar(0.0);
  positive &= -t94 > Scalar(0.0);
  positive &= b_5_4_4 > Scalar(0.0);
  positive &= -t70 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[6]   in  joint positions, rad or m
//   qd[6]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1..5], qd[0..5]. Operations: 106 mul, 76 add, 10 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar kinetic_energy(const Scalar* q, const Scalar* qd,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = s_2 * qd_1;
  const Scalar omega_r_3_x = s_3 * t1 + c_3 * t2;
  const Scalar v_r_4_a_y = t1 - omega_r_3_x;
  const Scalar t3 = s_3 * qd_2;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t4 = omega_3_z - t3;
  const Scalar v_r_4_x = s_4 * v_r_4_a_y - c_4 * t4;
  const Scalar t5 = c_3 * qd_2;
  const Scalar v_r_5_x = s_5 * t5 + c_5 * v_r_4_x;
  const Scalar v_r_4_y = s_4 * t4 + c_4 * v_r_4_a_y;
  const Scalar v_r_6_x = s_6 * v_r_4_y + c_6 * v_r_5_x;
  const Scalar t6 = s_6 * v_r_5_x - c_6 * v_r_4_y;
  const Scalar t7 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar t8 = s_3 * t2 - c_3 * t1;
  const Scalar omega_4_z = qd_4 - t8;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t7;
  const Scalar omega_r_5_a_z = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t9 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar t10 = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar omega_r_5_y = s_5 * t7 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t11 = Scalar(0.000534) * t9 - Scalar(0.0009944) * t10 -
      Scalar(0.0013246) * omega_6_z - Scalar(0.0063) * t6 + Scalar(0.01008) * v_r_6_x;
  const Scalar t12 = s_5 * v_r_4_x - c_5 * t5;
  const Scalar t13 = t10 * (Scalar(0.000256) * t9 + Scalar(0.0009944) * omega_6_z +
      Scalar(0.0063) * t12);
  const Scalar t14 = Scalar(0.0002546) * t9 + Scalar(0.000256) * t10 -
      Scalar(0.000534) * omega_6_z + Scalar(0.01008) * t12;
  const Scalar t15 = Scalar(0.0007639) * omega_r_5_x - Scalar(0.0016163) * omega_r_5_y +
      Scalar(0.01827) * t12 + Scalar(0.02853) * v_r_5_x - Scalar(0.0158056) * omega_5_z;
  const Scalar L_5_y = Scalar(0.0010857) * omega_r_5_x + Scalar(0.0016163) * omega_5_z +
      Scalar(0.01827) * v_r_4_y;
  const Scalar t16 = Scalar(0.0007639) * omega_5_z - Scalar(0.0010857) * omega_r_5_y -
      Scalar(0.0099214) * omega_r_5_x + Scalar(0.02853) * v_r_4_y;
  const Scalar t17 = Scalar(0.0110896) * t7 - Scalar(0.0523608) * omega_r_5_a_z +
      Scalar(0.0469862) * omega_4_z - Scalar(0.10476) * v_r_4_y - Scalar(0.19305) * v_r_4_x;
  const Scalar L_4_y = Scalar(0.0009736) * t7 + Scalar(0.10476) * t5 +
      Scalar(0.0523608) * omega_4_z;
  const Scalar L_4_x = Scalar(0.0009736) * omega_r_5_a_z - Scalar(0.0110896) * omega_4_z -
      Scalar(0.0221926) * t7 + Scalar(0.19305) * t5;
  const Scalar L_3_z = Scalar(0.016137) * omega_r_3_x + Scalar(0.0408384) * t8 +
      Scalar(0.24705) * t5 - Scalar(3.44772) * t3 + Scalar(2.0518487) * omega_3_z;
  const Scalar L_3_y = Scalar(0.026176) * omega_r_3_x - Scalar(0.0408384) * omega_3_z +
      Scalar(0.24705) * t1;
  const Scalar t18 = Scalar(0.026176) * t8 - Scalar(0.016137) * omega_3_z -
      Scalar(1.9036137) * omega_r_3_x + Scalar(3.44772) * t1;
  const Scalar L_2_y = Scalar(0.0444376) * qd_2 + Scalar(0.0684948) * t2;
  const Scalar t19 = t2 * (Scalar(0.1098692) * qd_2 - Scalar(0.0684948) * t1 +
      Scalar(8.4002222) * t2);
  const Scalar L_2_z = Scalar(0.0444376) * t1 - Scalar(0.1098692) * t2 + Scalar(8.554441) * qd_2;
  const Scalar t20 = -t13 - t9 * t14 + omega_6_z * t11 - omega_r_5_y * L_5_y + omega_r_5_x * t16 -
      t1 * L_2_y + omega_5_z * t15 + omega_r_5_a_z * L_4_y + t7 * L_4_x + t8 * L_3_y -
      omega_4_z * t17 + omega_r_3_x * t18 - omega_3_z * L_3_z + t19 - qd_2 * L_2_z -
      Scalar(9.3573967) * qd_1 * qd_1;
  return Scalar(-0.5) * t20;
}

// Potential energy of links and rotors (7.36).
//   q[6]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[1..5]. Operations: 17 mul, 16 add, 10 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar potential_energy(const Scalar* q, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = (Scalar(0.007) * c_6 + Scalar(0.0112) * s_6) - Scalar(0.0203);
  const Scalar hu_6_t_y = Scalar(0.0112) * c_6 - Scalar(0.007) * s_6;
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.2145);
  const Scalar t2 = c_4 * ((c_5 * t1 + Scalar(0.0317) * s_5) + Scalar(0.1164)) + s_4 * hc_4_y;
  const Scalar t3 = t2 - Scalar(0.2745);
  const Scalar hu_5_t_y = Scalar(0.0317) * c_5 - s_5 * t1;
  const Scalar hc_3_y = hu_5_t_y + Scalar(3.8308);
  const Scalar hu_3_t_y = c_3 * hc_3_y - s_3 * t3;
  const Scalar hc_2_y = hu_3_t_y - Scalar(0.4182);
  const Scalar hu_2_t_y = c_2 * hc_2_y - s_2 * ((c_3 * t3 + s_3 * hc_3_y) - Scalar(19.7994));
  const Scalar hc_0_z = hu_2_t_y - Scalar(3.6816);
  return Scalar(9.81) * hc_0_z;
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    1, 1, 1,
    1, 1, 1,
    1, 1, 1};

// Pose of the tip (2.50).
//   q[6]  in   joint positions, rad or m
//   R[9]  out  rotation matrix of the frame in the base frame
//              3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]  out  position of the frame's origin in the base frame, m
// Reads q[0..5]. Operations: 56 mul, 25 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void forward_kinematics(const Scalar* q, Scalar* R, Scalar* p,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = Scalar(0.45) * s_3 - Scalar(0.45);
  const Scalar t2 = Scalar(0.45) * c_3;
  p[2] = c_2 * t2 - s_2 * t1;
  const Scalar t3 = s_2 * t2 + c_2 * t1;
  p[0] = -c_1 * t3;
  p[1] = -s_1 * t3;
  const Scalar t4 = c_3 * s_5;
  const Scalar t5 = s_3 * c_5 + c_4 * t4;
  const Scalar t6 = s_3 * s_5;
  const Scalar t7 = c_4 * t6 - c_3 * c_5;
  R[8] = -s_2 * t5 - c_2 * t7;
  const Scalar t8 = c_4 * c_5;
  const Scalar t9 = s_4 * c_6;
  const Scalar t10 = t9 + s_6 * t8;
  const Scalar t11 = s_6 * t6 - c_3 * t10;
  const Scalar t12 = s_3 * t10 + s_6 * t4;
  R[7] = s_2 * t11 - c_2 * t12;
  const Scalar t13 = s_2 * t7 - c_2 * t5;
  const Scalar t14 = s_4 * s_5;
  R[2] = s_1 * t14 + c_1 * t13;
  R[5] = s_1 * t13 - c_1 * t14;
  const Scalar t15 = s_4 * s_6;
  const Scalar t16 = t15 - c_6 * t8;
  const Scalar t17 = c_6 * t6 + c_3 * t16;
  const Scalar t18 = s_3 * t16 - c_6 * t4;
  R[6] = -s_2 * t17 - c_2 * t18;
  const Scalar n_2_t_x = s_2 * t18 - c_2 * t17;
  const Scalar n_4_t_y = c_5 * t9 + c_4 * s_6;
  R[3] = s_1 * n_2_t_x + c_1 * n_4_t_y;
  const Scalar t19 = s_2 * t12 + c_2 * t11;
  const Scalar t20 = c_5 * t15 - c_4 * c_6;
  R[1] = s_1 * t20 + c_1 * t19;
  R[4] = s_1 * t19 - c_1 * t20;
  R[0] = c_1 * n_2_t_x - s_1 * n_4_t_y;
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[36] = {
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    0, 1, 1, 0, 1, 1,
    0, 1, 1, 1, 1, 1,
    0, 1, 1, 1, 1, 1,
    1, 0, 0, 1, 1, 1};

// Geometric Jacobian of the tip (7.14), (7.15).
//   q[6]   in   joint positions, rad or m
//   J[36]  out  geometric Jacobian in base axes: linear rows, then angular
//               6 x 6, row by row: entry (i, j) is J[6 * i + j]
// Reads q[0..4]. Operations: 57 mul, 23 add, 10 sin/cos. Always zero: 6 of the 36 entries of J.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian(const Scalar* q, Scalar* J, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  J[19] = J[20] = s_1;
  J[25] = J[26] = -c_1;
  const Scalar t1 = s_2 * s_3 - c_2 * c_3;
  J[33] = -t1;
  const Scalar R_32_x = c_2 * s_3 + s_2 * c_3;
  J[34] = s_4 * R_32_x;
  const Scalar t2 = Scalar(0.45) * s_2;
  const Scalar t3 = Scalar(0.45) * s_3 - Scalar(0.45);
  const Scalar t4 = c_3 * t2 + c_2 * t3;
  J[0] = s_1 * t4;
  const Scalar t5 = Scalar(0.45) * c_2;
  const Scalar t6 = s_2 * t3 - c_3 * t5;
  J[1] = c_1 * t6;
  J[7] = s_1 * t6;
  J[13] = -t4;
  const Scalar t7 = c_1 * R_32_x;
  J[21] = -t7;
  const Scalar t8 = s_1 * R_32_x;
  J[27] = -t8;
  J[6] = -c_1 * t4;
  const Scalar t9 = t2 + t6;
  J[2] = c_1 * t9;
  J[8] = s_1 * t9;
  const Scalar t10 = t4 + t5;
  J[14] = -t10;
  const Scalar t11 = c_1 * s_4;
  const Scalar t12 = s_1 * c_4;
  const Scalar t13 = t1 * t11 - t12;
  J[22] = -t13;
  const Scalar t14 = s_1 * s_4;
  const Scalar t15 = c_1 * c_4;
  const Scalar t16 = t15 + t1 * t14;
  J[28] = -t16;
  const Scalar t17 = c_4 * s_5 * R_32_x + c_5 * t1;
  J[35] = -t17;
  const Scalar J_46 = s_5 * (t1 * t15 + t14) - c_5 * t7;
  J[23] = J_46;
  const Scalar t18 = t10 - Scalar(0.45) * R_32_x;
  J[16] = t18 * (s_1 * t13 - c_1 * t16);
  const Scalar t19 = s_5 * (t11 - t1 * t12) + c_5 * t8;
  J[29] = -t19;
  const Scalar t20 = t9 - Scalar(0.45) * t1;
  const Scalar t21 = t1 * t18 - R_32_x * t20;
  J[9] = c_1 * t21;
  const Scalar t22 = s_4 * t18;
  J[4] = t8 * t22 + t20 * t16;
  const Scalar t23 = t18 * t17;
  J[5] = t20 * t19 - s_1 * t23;
  J[11] = t20 * J_46 + c_1 * t23;
  J[3] = -s_1 * t21;
  J[10] = -t7 * t22 - t20 * t13;
  J[17] = -t18 * (s_1 * J_46 + c_1 * t19);
  J[30] = Scalar(1.0);
  J[12] = J[15] = J[18] = J[24] = J[31] = J[32] = Scalar(0.0);
}

// (dJ/dt) qd of the tip.
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads q[0..5], qd[0..5]. Operations: 116 mul, 59 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = c_2 * s_3;
  const Scalar t2 = s_2 * c_3;
  const Scalar t3 = qd_1 * (t1 + t2);
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t4 = s_4 * omega_3_z;
  const Scalar t5 = t4 - c_4 * t3;
  const Scalar t6 = s_2 * s_3 - c_2 * c_3;
  const Scalar t7 = qd_1 * t6;
  const Scalar omega_4_z = qd_4 - t7;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t5;
  const Scalar t8 = c_4 * omega_3_z;
  const Scalar omega_r_5_a_z = s_4 * t3 + t8;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t9 = qd_6 * (s_6 * omega_5_z - c_6 * omega_r_5_x);
  const Scalar omega_r_5_y = s_5 * t5 + c_5 * omega_4_z;
  const Scalar t10 = t8 * t7 + qd_4 * omega_r_5_a_z;
  const Scalar t11 = omega_3_z * t3;
  const Scalar domega_q_5_x = qd_5 * omega_r_5_y - s_5 * t11 - c_5 * t10;
  const Scalar t12 = t4 * t7 + qd_4 * t5;
  const Scalar t13 = t9 - s_6 * domega_q_5_x + c_6 * t12;
  const Scalar t14 = qd_6 * (s_6 * omega_r_5_x + c_6 * omega_5_z);
  const Scalar t15 = t14 - s_6 * t12 - c_6 * domega_q_5_x;
  const Scalar t16 = s_6 * t13 + c_6 * t15;
  const Scalar t17 = c_5 * t11 + qd_5 * omega_r_5_x - s_5 * t10;
  const Scalar domega_e_5_t_x = s_5 * t17 - c_5 * t16;
  const Scalar domega_e_6_a_z = s_6 * t15 - c_6 * t13;
  const Scalar domega_e_4_t_x = s_4 * domega_e_6_a_z + c_4 * domega_e_5_t_x;
  const Scalar t18 = s_5 * t16 + c_5 * t17;
  const Scalar domega_e_3_t_x = s_3 * t18 + c_3 * domega_e_4_t_x;
  const Scalar t19 = s_3 * domega_e_4_t_x - c_3 * t18;
  a[5] = s_2 * domega_e_3_t_x + c_2 * t19;
  const Scalar t20 = qd_1 * qd_1;
  const Scalar t21 = qd_2 * qd_2 - (s_2 * s_2 - Scalar(1.0)) * t20;
  const Scalar t22 = s_2 * t20 * t1 - c_3 * t21;
  const Scalar ddp_o_4_x = Scalar(0.45) * t22 - Scalar(0.45) * t3 * t7;
  const Scalar t23 = (t6 * omega_3_z - s_2 * qd_2) * Scalar(0.9) * qd_1;
  const Scalar ddp_4_x = c_4 * ddp_o_4_x + s_4 * t23;
  const Scalar t24 = t3 * t3 - s_3 * t21 + omega_3_z * omega_3_z;
  const Scalar t25 = Scalar(0.45) * t24 - Scalar(0.45) * c_2 * t20 * t2;
  const Scalar t26 = s_5 * t25 - c_5 * ddp_4_x;
  const Scalar t27 = s_4 * ddp_o_4_x - c_4 * t23;
  const Scalar t28 = s_6 * t26 - c_6 * t27;
  const Scalar t29 = s_6 * t27 + c_6 * t26;
  const Scalar t30 = s_6 * t28 + c_6 * t29;
  const Scalar t31 = s_5 * ddp_4_x + c_5 * t25;
  const Scalar a_5_t_x = s_5 * t31 - c_5 * t30;
  const Scalar t32 = s_6 * t29 - c_6 * t28;
  const Scalar a_4_t_x = s_4 * t32 + c_4 * a_5_t_x;
  const Scalar t33 = s_5 * t30 + c_5 * t31;
  const Scalar a_3_t_x = s_3 * t33 + c_3 * a_4_t_x;
  const Scalar t34 = s_3 * a_4_t_x - c_3 * t33;
  a[2] = s_2 * a_3_t_x + c_2 * t34;
  const Scalar t35 = s_2 * t19 - c_2 * domega_e_3_t_x;
  const Scalar t36 = s_4 * domega_e_5_t_x - c_4 * domega_e_6_a_z;
  a[3] = -s_1 * t36 - c_1 * t35;
  a[4] = c_1 * t36 - s_1 * t35;
  const Scalar t37 = s_2 * t34 - c_2 * a_3_t_x;
  const Scalar t38 = s_4 * a_5_t_x - c_4 * t32;
  a[0] = -s_1 * t38 - c_1 * t37;
  a[1] = c_1 * t38 - s_1 * t37;
}

// The functions by type, with the shapes of their arguments: what adapters such as
// flatdyn/eigen.hpp are given.
namespace functions {

struct inverse_dynamics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], const Scalar (&qd)[6], const Scalar (&qdd)[6],
      Scalar (&tau)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::rx90::inverse_dynamics(of...); }
};

struct inverse_dynamics_tip_force {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], const Scalar (&qd)[6], const Scalar (&qdd)[6],
      const Scalar (&h_e)[6], Scalar (&tau)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::rx90::inverse_dynamics_tip_force(of...); }
};

struct inertia_matrix {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], Scalar (&B)[6][6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::rx90::inertia_matrix(of...); }
};

struct christoffel {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], Scalar (&c)[6][21]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::rx90::christoffel(of...); }
};

struct coriolis_matrix {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], const Scalar (&qd)[6], Scalar (&C)[6][6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::rx90::coriolis_matrix(of...); }
};

struct gravity {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], Scalar (&g)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::rx90::gravity(of...); }
};

struct bias {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], const Scalar (&qd)[6], Scalar (&n)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::rx90::bias(of...); }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[6], const Scalar (&qd)[6], const Scalar (&tau)[6],
      Scalar (&qdd)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::rx90::forward_dynamics(of...); }
};

struct kinetic_energy {
  template <class Scalar>
  using Shape = Scalar(const Scalar (&q)[6], const Scalar (&qd)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::rx90::kinetic_energy(of...); }
};

struct potential_energy {
  template <class Scalar>
  using Shape = Scalar(const Scalar (&q)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::rx90::potential_energy(of...); }
};

struct forward_kinematics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], Scalar (&R)[3][3], Scalar (&p)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::rx90::forward_kinematics(of...); }
};

struct jacobian {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], Scalar (&J)[6][6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::rx90::jacobian(of...); }
};

struct jacobian_dot_qd {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], const Scalar (&qd)[6], Scalar (&a)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::rx90::jacobian_dot_qd(of...); }
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

}  // namespace rx90

#endif  // FLATDYN_RX90_HPP_9CAE2EED

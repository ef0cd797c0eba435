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
// an output may overlap an input, but outputs must not overlap each other. Nothing allocates,
// throws, or keeps state. In the code, names count from 1 as in the textbook: q_1 is q[0], s_1 its
// sine, c_1 its cosine. Of link i: omega_i and domega_i are its angular velocity and acceleration,
// ddp_i the acceleration of its frame's origin less gravity, f_i and mu_i the force and moment that
// it gets from the link before, hc_i and hu_i the first moment of all that its joint carries (in
// gravity() times the size of gravity); t1, t2, ... are parts of sums.

#ifndef FLATDYN_RX90_HPP
#define FLATDYN_RX90_HPP

#include <cmath>

namespace rx90 {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 6;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {
    "joint1", "joint2", "joint3", "joint4", "joint5", "joint6"};

// Joints by their indices.
template <int... joint>
struct Joints {};

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
// Reads q[1..5], qd[0..5], qdd[0..5]. Operations: 214 mul, 207 add, 10 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = c_2 * s_3 + s_2 * c_3;
  const Scalar t2 = qd_1 * t1;
  const Scalar t3 = s_2 * s_3 - c_2 * c_3;
  const Scalar t4 = qd_1 * t3;
  const Scalar t5 = t2 * t4;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar t6 = t5 + domega_3_z;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t7 = qdd_1 * t1;
  const Scalar t8 = Scalar(2.0) * omega_3_z * t4 - t7;
  const Scalar t9 = s_4 * t6 + c_4 * t8;
  const Scalar omega_r_5_a_z = s_4 * t2 + c_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 - t4;
  const Scalar t10 = t9 + Scalar(2.0) * omega_r_5_a_z * omega_4_z;
  const Scalar t11 = omega_3_z * t2;
  const Scalar t12 = qdd_1 * t3;
  const Scalar t13 = t12 + t11;
  const Scalar domega_4_z = qdd_4 - t13;
  const Scalar t14 = s_4 * omega_3_z - c_4 * t2;
  const Scalar t15 = t14 * omega_r_5_a_z;
  const Scalar Uz_o_5_x = domega_4_z - t15;
  const Scalar Uz_5_x = c_5 * Uz_o_5_x + s_5 * t10;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t14;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t16 = omega_r_5_x * omega_5_z;
  const Scalar domega_5_y = Uz_5_x - t16;
  const Scalar domega_6_z = qdd_6 + domega_5_y;
  const Scalar t17 = t16 + domega_6_z;
  const Scalar t18 = Scalar(0.0009944) * c_6 - Scalar(0.000534) * s_6;
  const Scalar t19 = s_5 * Uz_o_5_x - c_5 * t10;
  const Scalar omega_r_5_y = s_5 * t14 + c_5 * omega_4_z;
  const Scalar t20 = Scalar(2.0) * omega_5_z;
  const Scalar U_5_zy = t19 + omega_r_5_y * t20;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t21 = U_5_zy - t20 * omega_6_z;
  const Scalar I_t6_g = Scalar(0.0002546) * c_6 - Scalar(0.000512) * s_6;
  const Scalar I_6_xy = s_6 * I_t6_g + Scalar(0.000256);
  const Scalar t22 = omega_6_z * omega_6_z;
  const Scalar t23 = omega_5_z * omega_5_z;
  const Scalar t24 = t23 + t22;
  const Scalar t25 = omega_r_5_x * omega_r_5_x;
  const Scalar t26 = t25 + t23;
  const Scalar I_6_xz = Scalar(0.000534) * c_6 + Scalar(0.0009944) * s_6;
  const Scalar t27 = s_4 * t8 - c_4 * t6;
  const Scalar t28 = t14 * omega_4_z;
  const Scalar t29 = t28 + t27;
  const Scalar domega_5_z = qdd_5 - t29;
  const Scalar t30 = omega_r_5_x * omega_r_5_y;
  const Scalar t31 = domega_5_z - t30;
  const Scalar U_6_zx = t31 + Scalar(2.0) * omega_r_5_x * omega_6_z;
  const Scalar t32 = c_6 * I_t6_g;
  const Scalar t33 = t32 - Scalar(0.0007896);
  const Scalar t34 = s_2 * qd_1;
  const Scalar t35 = c_2 * qd_1;
  const Scalar t36 = t34 * t35;
  const Scalar U_2_yx = t36 + qdd_2;
  const Scalar ddp_o_3_y = Scalar(21.8) * c_2 + U_2_yx;
  const Scalar t37 = t34 * t34;
  const Scalar t38 = qd_2 * qd_2;
  const Scalar t39 = qd_1 * qd_1;
  const Scalar t40 = t38 - t37 + t39;
  const Scalar ddp_o_3_x = Scalar(21.8) * s_2 - t40;
  const Scalar ddp_3_x = s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar t41 = t6 - ddp_3_x;
  const Scalar t42 = Scalar(2.0) * qd_2;
  const Scalar t43 = c_2 * qdd_1;
  const Scalar t44 = t34 * t42 - t43;
  const Scalar t45 = t44 - t8;
  const Scalar t46 = s_4 * t45 + c_4 * t41;
  const Scalar t47 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t48 = t2 * t2;
  const Scalar t49 = omega_3_z * omega_3_z;
  const Scalar t50 = t48 + t49;
  const Scalar t51 = t50 + t47;
  const Scalar t52 = s_5 * t46 - c_5 * t51;
  const Scalar t53 = Scalar(0.00315) * c_6 + Scalar(0.00504) * s_6;
  const Scalar t54 = s_5 * t51 + c_5 * t46;
  const Scalar U_5_yx = t30 + domega_5_z;
  const Scalar t55 = t14 * t14;
  const Scalar t56 = omega_4_z * omega_4_z;
  const Scalar Uz_o_5_y = t56 + t55;
  const Scalar t57 = Uz_o_5_y - t25 + t23;
  const Scalar mu_5_z = I_6_xz * (t26 - t24) - Scalar(0.0007639) * t19 - t21 * I_6_xy + t17 * t18 +
      Scalar(0.0016163) * Uz_5_x - Scalar(0.0010857) * (t57 - t26) - U_6_zx * t33 +
      Scalar(0.0029421) * U_5_yx + Scalar(0.0123285) * t31 + Scalar(0.014265) * t54 -
      t52 * (t53 - Scalar(0.009135));
  tau[4] = mu_5_z;
  const Scalar t58 = t16 - domega_6_z;
  const Scalar I_6_xx = t32 + Scalar(0.000535);
  const Scalar t59 = t25 + t22;
  const Scalar mr_6_y = Scalar(0.00504) * c_6 - Scalar(0.00315) * s_6;
  const Scalar t60 = s_4 * t41 - c_4 * t45;
  const Scalar t61 = I_6_xy * (t24 - t59) - t58 * t33 - t17 * I_6_xx - U_5_zy * I_6_xz - t31 * t18 -
      mr_6_y * t54 + t53 * t60;
  tau[5] = -t61;
  const Scalar U_5_zx = t16 - domega_5_y;
  const Scalar t62 = Scalar(0.0007639) * (Uz_o_5_y - t57) + Scalar(0.0016163) * t31 +
      Scalar(0.0010857) * U_5_zy - Scalar(0.0029421) * U_5_zx + Scalar(0.009135) * t60 - t61;
  const Scalar U_6_yy_zz = t26 - t59;
  const Scalar U_5_yy_zz = Uz_o_5_y - t26;
  const Scalar t63 = U_6_zx * I_6_xy + Scalar(0.0007639) * U_5_yx + t18 * U_6_yy_zz + t58 * I_6_xz +
      Scalar(0.0010857) * U_5_zx - Scalar(0.0016163) * U_5_yy_zz - t21 * I_6_xx - mr_6_y * t52 +
      Scalar(0.014265) * t60 - Scalar(0.0123285) * U_5_zy;
  const Scalar t64 = t56 - t55 + t50;
  const Scalar U_4_yx = domega_4_z + t15;
  const Scalar tau_4 = Scalar(0.0009736) * (t64 - Uz_o_5_y) + Scalar(0.0110896) * t9 +
      Scalar(0.0123968) * U_4_yx + c_5 * t62 - s_5 * t63 + Scalar(0.0523608) * t27 +
      Scalar(0.0316473) * Uz_o_5_x - Scalar(0.05238) * t60 + Scalar(0.096525) * t46;
  tau[3] = tau_4;
  const Scalar t65 = mr_6_y * t17 - t53 * t24 + Scalar(0.009135) * t57 + Scalar(0.014265) * t31;
  const Scalar f_5_y = Scalar(0.009135) * U_5_yx + mr_6_y * t21 - t53 * U_6_zx -
      Scalar(0.014265) * t26;
  const Scalar f_4_x = -s_5 * f_5_y - c_5 * t65 + Scalar(0.05238) * t64 -
      Scalar(0.096525) * Uz_o_5_x;
  const Scalar t66 = mr_6_y * t59 - t53 * t58 + Scalar(0.009135) * U_5_zx +
      Scalar(0.05238) * U_4_yx + Scalar(0.014265) * U_5_zy + Scalar(0.096525) * Uz_o_5_y;
  const Scalar f_u_4_t_x = s_4 * t66 + c_4 * f_4_x;
  const Scalar t67 = t28 + t29;
  const Scalar U_4_yy_zz = t50 - Uz_o_5_y;
  const Scalar t68 = Scalar(0.0009736) * t67 + Scalar(0.0110896) * U_4_yx + s_5 * t62 + c_5 * t63 +
      Scalar(0.0316473) * t10 - Scalar(0.0523608) * U_4_yy_zz + Scalar(0.096525) * t51;
  const Scalar mu_4_y = Scalar(0.0009736) * t10 + Scalar(0.0123968) * t67 +
      Scalar(0.0110896) * (t50 - t64) + Scalar(0.0523608) * Uz_o_5_x - mu_5_z -
      Scalar(0.05238) * t51;
  const Scalar t69 = t39 - t48 + t49;
  const Scalar U_3_yx = domega_3_z - t5;
  const Scalar tau_3 = Scalar(0.016137) * t7 + Scalar(0.0408384) * t12 -
      Scalar(0.026176) * (t69 - t50) + Scalar(0.0741175) * U_3_yx - c_4 * mu_4_y -
      Scalar(0.123525) * t47 - f_u_4_t_x + s_4 * t68 + Scalar(1.9653344) * t6 -
      Scalar(1.72386) * ddp_3_x;
  tau[2] = tau_3;
  const Scalar t70 = s_3 * (Scalar(0.123525) * t69 - f_u_4_t_x + Scalar(1.72386) * t6);
  const Scalar f_3_y = c_5 * f_5_y - s_5 * t65 + Scalar(0.123525) * U_3_yx + Scalar(0.05238) * t67 -
      Scalar(0.096525) * t10 - Scalar(1.72386) * t50;
  const Scalar t71 = t37 + t38;
  const Scalar t72 = qdd_2 - t36;
  const Scalar t73 = s_2 * qdd_1;
  tau[1] = Scalar(0.0444376) * t43 + Scalar(0.0771094) * t72 - Scalar(0.1098692) * t73 -
      Scalar(0.0684948) * (t40 - t71) + Scalar(4.102542) * s_2 - t70 + c_3 * f_3_y + tau_3 +
      Scalar(8.4773316) * U_2_yx + Scalar(194.232114) * c_2;
  const Scalar t74 = s_4 * f_4_x - c_4 * t66;
  const Scalar U_3_zx = t11 + t13;
  const Scalar U_3_yy_zz = t39 - t50;
  const Scalar t75 = Scalar(0.016137) * U_3_yx - Scalar(0.026176) * U_3_zx -
      Scalar(0.0408384) * U_3_yy_zz - s_4 * mu_4_y - t74 - c_4 * t68 + Scalar(1.72386) * t44 -
      Scalar(1.9653344) * t8;
  const Scalar t76 = Scalar(0.026176) * t8 + Scalar(0.016137) * (t39 - t69) +
      Scalar(0.0408384) * t6 + Scalar(0.123525) * t44 + Scalar(0.0741175) * U_3_zx - tau_4;
  const Scalar U_2_yy_zz = t39 - t71;
  const Scalar U_2_zy = t73 + t35 * t42;
  const Scalar t77 = Scalar(0.0684948) * t44 - Scalar(0.0444376) * U_2_yy_zz +
      Scalar(0.1098692) * U_2_yx - Scalar(0.0771094) * U_2_zy - s_3 * t76 - c_3 * t75;
  const Scalar mu_2_y = Scalar(0.0444376) * t72 + Scalar(0.0684948) * U_2_zy -
      Scalar(0.123525) * U_3_zx + Scalar(0.1098692) * (t39 - t40) + t74 - c_3 * t76 + s_3 * t75 +
      Scalar(1.72386) * t8 - Scalar(8.4773316) * t44;
  tau[0] = Scalar(0.8059476) * qdd_1 - s_2 * t77 + c_2 * mu_2_y;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..5], qd[0..5], qdd[0..5], h_e[0..5]. Operations: 282 mul, 240 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics_tip_force(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    const Scalar* h_e, Scalar* tau, const SinCos& sin_cos = {}) noexcept {
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
  const Scalar t1 = c_2 * s_3 + s_2 * c_3;
  const Scalar t2 = qd_1 * t1;
  const Scalar t3 = s_2 * s_3 - c_2 * c_3;
  const Scalar t4 = qd_1 * t3;
  const Scalar t5 = t2 * t4;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar t6 = t5 + domega_3_z;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t7 = qdd_1 * t1;
  const Scalar t8 = Scalar(2.0) * omega_3_z * t4 - t7;
  const Scalar t9 = s_4 * t6 + c_4 * t8;
  const Scalar omega_r_5_a_z = s_4 * t2 + c_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 - t4;
  const Scalar t10 = t9 + Scalar(2.0) * omega_r_5_a_z * omega_4_z;
  const Scalar t11 = omega_3_z * t2;
  const Scalar t12 = qdd_1 * t3;
  const Scalar t13 = t12 + t11;
  const Scalar domega_4_z = qdd_4 - t13;
  const Scalar t14 = s_4 * omega_3_z - c_4 * t2;
  const Scalar t15 = t14 * omega_r_5_a_z;
  const Scalar Uz_o_5_x = domega_4_z - t15;
  const Scalar t16 = s_5 * Uz_o_5_x - c_5 * t10;
  const Scalar omega_r_5_y = s_5 * t14 + c_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar U_5_zy = t16 + Scalar(2.0) * omega_r_5_y * omega_5_z;
  const Scalar t17 = s_4 * t8 - c_4 * t6;
  const Scalar t18 = t14 * omega_4_z;
  const Scalar t19 = t18 + t17;
  const Scalar domega_5_z = qdd_5 - t19;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t14;
  const Scalar t20 = omega_r_5_x * omega_r_5_y;
  const Scalar t21 = domega_5_z - t20;
  const Scalar t22 = s_6 * U_5_zy + c_6 * t21;
  const Scalar t23 = s_6 * t21 - c_6 * U_5_zy;
  const Scalar Uz_5_x = c_5 * Uz_o_5_x + s_5 * t10;
  const Scalar t24 = omega_r_5_x * omega_5_z;
  const Scalar domega_5_y = Uz_5_x - t24;
  const Scalar domega_6_z = qdd_6 + domega_5_y;
  const Scalar t25 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar t26 = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t27 = t25 * t26;
  const Scalar t28 = domega_6_z - t27;
  const Scalar U_6_yx = t27 + domega_6_z;
  const Scalar t29 = s_2 * qd_1;
  const Scalar t30 = c_2 * qd_1;
  const Scalar t31 = t29 * t30;
  const Scalar U_2_yx = t31 + qdd_2;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 + Scalar(0.45) * U_2_yx;
  const Scalar t32 = t29 * t29;
  const Scalar t33 = qd_2 * qd_2;
  const Scalar t34 = qd_1 * qd_1;
  const Scalar t35 = t33 - t32 + t34;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 - Scalar(0.45) * t35;
  const Scalar ddp_3_x = s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar t36 = Scalar(0.45) * t6 - ddp_3_x;
  const Scalar t37 = Scalar(2.0) * qd_2;
  const Scalar t38 = c_2 * qdd_1;
  const Scalar t39 = t29 * t37 - t38;
  const Scalar t40 = Scalar(0.45) * t39 - Scalar(0.45) * t8;
  const Scalar t41 = s_4 * t40 + c_4 * t36;
  const Scalar t42 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t43 = t2 * t2;
  const Scalar t44 = omega_3_z * omega_3_z;
  const Scalar t45 = t43 + t44;
  const Scalar t46 = Scalar(0.45) * t45 + t42;
  const Scalar t47 = c_5 * t41 + s_5 * t46;
  const Scalar t48 = s_4 * t36 - c_4 * t40;
  const Scalar t49 = s_6 * t48 - c_6 * t47;
  const Scalar t50 = s_6 * t47 + c_6 * t48;
  const Scalar t51 = t25 * t25;
  const Scalar t52 = omega_r_5_x * omega_r_5_x;
  const Scalar t53 = omega_5_z * omega_5_z;
  const Scalar t54 = t52 + t53;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t55 = omega_6_z * omega_6_z;
  const Scalar t56 = t54 - t51 + t55;
  const Scalar t57 = t51 + t55;
  const Scalar mu_e1_x = s_1 * h_e_5 + c_1 * h_e_4;
  const Scalar t58 = s_2 * mu_e1_x - c_2 * h_e_6;
  const Scalar mu_e2_x = s_2 * h_e_6 + c_2 * mu_e1_x;
  const Scalar t59 = s_3 * t58 - c_3 * mu_e2_x;
  const Scalar t60 = s_1 * h_e_4 - c_1 * h_e_5;
  const Scalar t61 = s_4 * t60 + c_4 * t59;
  const Scalar t62 = s_3 * mu_e2_x + c_3 * t58;
  const Scalar mu_6_z = Scalar(0.0007896) * t28 - Scalar(0.000256) * (t56 - t57) -
      Scalar(0.000534) * t23 + Scalar(0.000535) * U_6_yx + Scalar(0.0009944) * t22 -
      Scalar(0.0112) * t49 - Scalar(0.007) * t50 + s_5 * t61 - c_5 * t62;
  tau[5] = mu_6_z;
  const Scalar t63 = Scalar(2.0) * omega_6_z;
  const Scalar U_6_zx = t22 - t25 * t63;
  const Scalar t64 = t23 + t26 * t63;
  const Scalar U_6_yy_zz = t54 - t57;
  const Scalar t65 = s_5 * t41 - c_5 * t46;
  const Scalar t66 = s_5 * t62 + c_5 * t61;
  const Scalar mu_e4_y = s_4 * t59 - c_4 * t60;
  const Scalar t67 = Scalar(0.000534) * U_6_yx - Scalar(0.000256) * U_6_zx -
      Scalar(0.0007896) * t64 - Scalar(0.0009944) * U_6_yy_zz + Scalar(0.0112) * t65 +
      s_6 * mu_e4_y - c_6 * t66;
  const Scalar t68 = Scalar(-0.000256) * t64 - Scalar(0.000535) * U_6_zx -
      Scalar(0.000534) * (t54 - t56) - Scalar(0.0009944) * t28 + Scalar(0.007) * t65 + s_6 * t66 +
      c_6 * mu_e4_y;
  const Scalar U_5_yx = t20 + domega_5_z;
  const Scalar t69 = t14 * t14;
  const Scalar t70 = omega_4_z * omega_4_z;
  const Scalar Uz_o_5_y = t70 + t69;
  const Scalar t71 = Uz_o_5_y - t52 + t53;
  const Scalar mu_5_z = Scalar(0.0016163) * Uz_5_x - Scalar(0.0007639) * t16 -
      Scalar(0.0010857) * (t71 - t54) + Scalar(0.0029421) * U_5_yx + Scalar(0.0203) * t65 +
      Scalar(0.0123285) * t21 + Scalar(0.0317) * t47 - s_6 * t67 - c_6 * t68;
  tau[4] = mu_5_z;
  const Scalar U_5_zx = t24 - domega_5_y;
  const Scalar U_5_yy_zz = Uz_o_5_y - t54;
  const Scalar t72 = Scalar(0.0007639) * U_5_yx + Scalar(0.0010857) * U_5_zx -
      Scalar(0.0016163) * U_5_yy_zz + Scalar(0.0317) * t48 - Scalar(0.0123285) * U_5_zy +
      s_6 * t68 - c_6 * t67;
  const Scalar t73 = Scalar(0.0007639) * (Uz_o_5_y - t71) + Scalar(0.0016163) * t21 +
      Scalar(0.0010857) * U_5_zy - Scalar(0.0029421) * U_5_zx + Scalar(0.0203) * t48 + mu_6_z;
  const Scalar t74 = t70 - t69 + t45;
  const Scalar U_4_yx = domega_4_z + t15;
  const Scalar tau_4 = Scalar(0.0009736) * (t74 - Uz_o_5_y) + Scalar(0.0110896) * t9 +
      Scalar(0.0123968) * U_4_yx + Scalar(0.0523608) * t17 + Scalar(0.0316473) * Uz_o_5_x -
      Scalar(0.1164) * t48 + Scalar(0.2145) * t41 - s_5 * t72 + c_5 * t73;
  tau[3] = tau_4;
  const Scalar f_e1_x = s_1 * h_e_2 + c_1 * h_e_1;
  const Scalar t75 = s_2 * f_e1_x - c_2 * h_e_3;
  const Scalar f_e2_x = s_2 * h_e_3 + c_2 * f_e1_x;
  const Scalar t76 = s_3 * t75 - c_3 * f_e2_x;
  const Scalar t77 = s_1 * h_e_1 - c_1 * h_e_2;
  const Scalar t78 = s_4 * t77 + c_4 * t76;
  const Scalar t79 = s_3 * f_e2_x + c_3 * t75;
  const Scalar t80 = s_5 * t79 + c_5 * t78;
  const Scalar f_e4_y = s_4 * t76 - c_4 * t77;
  const Scalar t81 = Scalar(0.007) * U_6_yx + Scalar(0.0112) * t57 - s_6 * t80 - c_6 * f_e4_y;
  const Scalar f_6_x = Scalar(0.007) * t56 - Scalar(0.0112) * t28 + s_6 * f_e4_y - c_6 * t80;
  const Scalar t82 = Scalar(0.0203) * t71 + Scalar(0.0317) * t21 - s_6 * t81 - c_6 * f_6_x;
  const Scalar f_5_y = Scalar(0.0203) * U_5_yx - Scalar(0.007) * U_6_zx - Scalar(0.0317) * t54 -
      Scalar(0.0112) * t64 + s_5 * t78 - c_5 * t79;
  const Scalar f_4_x = Scalar(0.1164) * t74 - Scalar(0.2145) * Uz_o_5_x - s_5 * f_5_y - c_5 * t82;
  const Scalar t83 = Scalar(0.0203) * U_5_zx + Scalar(0.0317) * U_5_zy + Scalar(0.1164) * U_4_yx +
      Scalar(0.2145) * Uz_o_5_y - s_6 * f_6_x + c_6 * t81;
  const Scalar f_u_4_t_x = s_4 * t83 + c_4 * f_4_x;
  const Scalar t84 = t18 + t19;
  const Scalar U_4_yy_zz = t45 - Uz_o_5_y;
  const Scalar t85 = Scalar(0.0009736) * t84 + Scalar(0.0110896) * U_4_yx +
      Scalar(0.0316473) * t10 - Scalar(0.0523608) * U_4_yy_zz + Scalar(0.2145) * t46 + s_5 * t73 +
      c_5 * t72;
  const Scalar mu_4_y = Scalar(0.0009736) * t10 + Scalar(0.0123968) * t84 +
      Scalar(0.0110896) * (t45 - t74) + Scalar(0.0523608) * Uz_o_5_x - Scalar(0.1164) * t46 -
      mu_5_z;
  const Scalar t86 = t34 - t43 + t44;
  const Scalar U_3_yx = domega_3_z - t5;
  const Scalar tau_3 = Scalar(0.016137) * t7 + Scalar(0.0408384) * t12 -
      Scalar(0.026176) * (t86 - t45) + Scalar(0.0741175) * U_3_yx - Scalar(0.2745) * t42 -
      Scalar(0.45) * f_u_4_t_x + s_4 * t85 - c_4 * mu_4_y + Scalar(1.9653344) * t6 -
      Scalar(3.8308) * ddp_3_x;
  tau[2] = tau_3;
  const Scalar f_3_y = Scalar(0.1164) * t84 + Scalar(0.2745) * U_3_yx - Scalar(0.2145) * t10 -
      s_5 * t82 + c_5 * f_5_y - Scalar(3.8308) * t45;
  const Scalar t87 = s_3 * (Scalar(0.2745) * t86 - f_u_4_t_x + Scalar(3.8308) * t6) - c_3 * f_3_y;
  const Scalar t88 = t32 + t33;
  const Scalar t89 = qdd_2 - t31;
  const Scalar t90 = s_2 * qdd_1;
  tau[1] = Scalar(0.0444376) * t38 + Scalar(0.0771094) * t89 - Scalar(0.1098692) * t90 -
      Scalar(0.0684948) * (t35 - t88) + Scalar(4.102542) * s_2 - Scalar(0.45) * t87 + tau_3 +
      Scalar(8.4773316) * U_2_yx + Scalar(194.232114) * c_2;
  const Scalar t91 = Scalar(-0.45) * (s_4 * f_4_x - c_4 * t83);
  const Scalar U_3_zx = t11 + t13;
  const Scalar U_3_yy_zz = t34 - t45;
  const Scalar t92 = Scalar(0.016137) * U_3_yx - Scalar(0.026176) * U_3_zx -
      Scalar(0.0408384) * U_3_yy_zz - s_4 * mu_4_y - c_4 * t85 + t91 + Scalar(1.72386) * t39 -
      Scalar(1.9653344) * t8;
  const Scalar t93 = Scalar(0.026176) * t8 + Scalar(0.016137) * (t34 - t86) +
      Scalar(0.0408384) * t6 + Scalar(0.123525) * t39 + Scalar(0.0741175) * U_3_zx - tau_4;
  const Scalar U_2_yy_zz = t34 - t88;
  const Scalar U_2_zy = t90 + t30 * t37;
  const Scalar t94 = Scalar(0.0684948) * t39 - Scalar(0.0444376) * U_2_yy_zz +
      Scalar(0.1098692) * U_2_yx - Scalar(0.0771094) * U_2_zy - s_3 * t93 - c_3 * t92;
  const Scalar mu_2_y = Scalar(0.0444376) * t89 + Scalar(0.0684948) * U_2_zy -
      Scalar(0.123525) * U_3_zx + Scalar(0.1098692) * (t34 - t35) - t91 - c_3 * t93 +
      Scalar(1.72386) * t8 + s_3 * t92 - Scalar(8.4773316) * t39;
  tau[0] = Scalar(0.8059476) * qdd_1 - s_2 * t94 + c_2 * mu_2_y;
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
// Reads q[1..5]. Operations: 103 mul, 100 add, 10 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inertia_matrix(const Scalar* q, Scalar* B, const SinCos& sin_cos = {}) noexcept {
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
  const Scalar Iu_5_a_xz = c_5 * t2 + s_5 * Ic_5_yz;
  const Scalar t8 = f_u_6_6_a_z - Scalar(0.009135);
  const Scalar hu_5_t_y = Scalar(0.014265) * c_5 - s_5 * t8;
  const Scalar t9 = mu_u_5_5_a_y - hu_5_t_y;
  const Scalar mu_5_3_z = s_4 * Iu_5_a_xz - c_4 * t9;
  B[16] = B[26] = mu_5_3_z;
  B[11] = B[31] = s_3 * t5 - t7 - c_3 * s_5 * hu_6_t_y;
  const Scalar Iu_6_t_xx = t1 - Scalar(0.0002546);
  const Scalar Iu_5_t_d = Iu_6_t_xx + Scalar(0.0088514);
  const Scalar Ic_5_xy = Iu_6_t_xz + Scalar(0.0010857);
  const Scalar t10 = Scalar(2.0) * s_5 * Ic_5_xy - c_5 * Iu_5_t_d;
  const Scalar t11 = c_5 * t10;
  const Scalar Ic_4_zz = Iu_6_t_xx + t11 + Scalar(0.0571622);
  B[21] = Ic_4_zz;
  const Scalar t12 = c_5 * t8 + Scalar(0.014265) * s_5;
  B[10] = B[25] = mu_5_3_z - s_3 * c_4 * hu_5_t_y - c_3 * t12;
  const Scalar f_u_6_4_a_z = s_4 * t4 + c_4 * f_u_6_6_a_z;
  const Scalar mu_6_3_x = s_4 * Iu_6_a_xy - c_4 * t6 + f_u_6_4_a_z;
  const Scalar t13 = c_2 * (f_u_6_4_a_z - c_3 * mu_u_6_5_t_y - s_3 * mu_6_3_x);
  B[5] = B[30] = -s_2 * (s_3 * mu_u_6_5_t_y - c_3 * mu_6_3_x) - t13;
  const Scalar t14 = c_4 * Iu_5_a_xz + s_4 * t9;
  const Scalar t15 = c_2 * (c_3 * t3 + s_4 * hu_5_t_y + s_3 * t14);
  B[4] = B[24] = s_2 * (s_3 * t3 - c_3 * t14) - t15;
  const Scalar Ic_4_xz = Ic_5_xy - s_5 * t10 - Scalar(0.0110896);
  const Scalar t16 = t3 + Scalar(0.0523608);
  const Scalar t17 = t12 + Scalar(0.05238);
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.096525);
  const Scalar t18 = s_4 * t17 - c_4 * hc_4_y;
  const Scalar t19 = (s_4 * Ic_4_xz + c_4 * t16) + t18;
  B[15] = B[20] = -t19;
  B[9] = B[19] = s_3 * t18 - t19;
  const Scalar t20 = t11 + Scalar(0.0088514);
  const Scalar t21 = mu_u_5_5_a_y + Scalar(0.0323686);
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0009736);
  const Scalar t22 = Scalar(2.0) * s_4 * Ic_4_xy + c_4 * (t20 - t21);
  const Scalar t23 = c_4 * t22;
  const Scalar t24 = Scalar(2.0) * hu_5_t_y;
  const Scalar t25 = t20 - t23 - t24 - Scalar(2.0842173);
  B[14] = -t25;
  const Scalar f_u_4_4_a_z = c_4 * t17 + s_4 * hc_4_y;
  const Scalar t26 = f_u_4_4_a_z - Scalar(0.123525);
  const Scalar hc_3_y = hu_5_t_y + Scalar(1.72386);
  const Scalar t27 = c_3 * t26 + s_3 * hc_3_y;
  const Scalar t28 = Scalar(2.0) * t27;
  B[7] = -t25 - t28 + Scalar(8.554441);
  B[8] = B[13] = -t27 - t25;
  const Scalar mu_4_3_x = f_u_4_4_a_z - (s_4 * t16 - c_4 * Ic_4_xz);
  const Scalar t29 = c_2 * (-s_3 * mu_4_3_x - c_3 * Ic_4_zz + f_u_4_4_a_z);
  B[3] = B[18] = -s_2 * (s_3 * Ic_4_zz - c_3 * mu_4_3_x) - t29;
  const Scalar t30 = Ic_4_xy - s_4 * t22 - Scalar(0.016137);
  const Scalar t31 = Scalar(0.0408384) + t19;
  const Scalar t32 = s_3 * t31 - c_3 * t30;
  const Scalar t33 = s_3 * t30 + c_3 * t31;
  B[2] = B[12] = s_2 * t32 - c_2 * t33;
  B[1] = B[6] = -c_2 * (t33 - Scalar(0.0444376)) - s_2 * (t18 - t32 + Scalar(0.1098692));
  const Scalar t34 = t23 - t24 + t21;
  const Scalar Ic_3_yy = Ic_4_zz - Scalar(1.9359823);
  const Scalar Ic_3_xy = Scalar(0.026176) + mu_4_3_x;
  const Scalar t35 = Scalar(2.0) * s_3 * Ic_3_xy + c_3 * (t34 + Ic_3_yy);
  const Scalar t36 = s_2 * (Ic_3_xy + Scalar(0.0684948) + s_3 * (t26 - t35) - c_3 * hc_3_y);
  const Scalar t37 = c_3 * t35;
  const Scalar Iu_3_t_xx = Ic_3_yy - t37;
  const Scalar t38 = Scalar(2.0) * t36 - c_2 * (t34 - t37 + Iu_3_t_xx + t28 - Scalar(8.4002222));
  B[0] = Iu_3_t_xx + Scalar(2.8931568) + c_2 * t38;
  B[35] = Scalar(0.0013246);
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[126] = {
    0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[6]    in   joint positions, rad or m
//   c[126]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//                c_ijk = c_ikj is c[21 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads q[1..5]. Operations: 317 mul, 269 add, 10 sin/cos. Always zero: 21 of the 126 entries of c.
template <class Scalar, class SinCos = LibrarySinCos>
inline void christoffel(const Scalar* q, Scalar* c, const SinCos& sin_cos = {}) noexcept {
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
  const Scalar Ic_6_xy = s_6 * I_t6_g + Scalar(0.000128);
  const Scalar dI_6_yy = Scalar(2.0) * Ic_6_xy;
  c[103] = dI_6_yy;
  c[119] = Scalar(-2.0) * Ic_6_xy;
  const Scalar t2 = s_4 * c_5;
  const Scalar t3 = Iu_6_a_xy * t2 + c_4 * Ic_6_xz;
  const Scalar mr_6_y = Scalar(0.00252) * c_6 - Scalar(0.001575) * s_6;
  const Scalar f_u_6_6_a_z = Scalar(0.001575) * c_6 + Scalar(0.00252) * s_6;
  const Scalar t4 = c_4 * c_5;
  const Scalar t5 = s_4 * mr_6_y + f_u_6_6_a_z * t4;
  const Scalar t6 = t3 + t5;
  c[62] = Scalar(-2.0) * t6;
  const Scalar w_1_3_x = c_2 * s_3 + s_2 * c_3;
  const Scalar t7 = c_2 * c_3 - s_2 * s_3;
  const Scalar t8 = w_1_3_x * t4 + s_5 * t7;
  const Scalar t9 = s_4 * w_1_3_x;
  const Scalar v_1_4_a_y = c_2 - w_1_3_x;
  const Scalar t10 = c_4 * mr_6_y - f_u_6_6_a_z * t2;
  const Scalar t11 = v_1_4_a_y * t10;
  const Scalar t12 = Ic_6_xz * t9 - Iu_6_a_xy * t8 + t11;
  c[20] = Scalar(-2.0) * t12;
  const Scalar v_o_2_4_x = s_3 - Scalar(1.0);
  const Scalar v_2_5_x = c_3 * s_5 + v_o_2_4_x * t4;
  const Scalar t13 = s_4 * v_o_2_4_x;
  const Scalar t14 = f_u_6_6_a_z * v_2_5_x + mr_6_y * t13;
  const Scalar t15 = t3 - t14;
  c[41] = Scalar(-2.0) * t15;
  const Scalar t16 = Ic_6_xy + Scalar(0.00038195);
  const Scalar Ic_5_yz = Iu_6_a_xy + Scalar(0.00080815);
  const Scalar Iu_5_a_xz = c_5 * t16 + s_5 * Ic_5_yz;
  c[77] = Scalar(-2.0) * Iu_5_a_xz;
  const Scalar t17 = c_4 * s_5;
  const Scalar t18 = c_5 * t7 - w_1_3_x * t17;
  const Scalar t19 = Ic_6_xz * t18;
  const Scalar t20 = s_4 * s_5;
  const Scalar t21 = mr_6_y * v_1_4_a_y * t20;
  const Scalar t22 = Scalar(0.0006623) * t8 - t19 - t21;
  const Scalar t23 = c_6 * I_t6_g;
  const Scalar Ic_6_xx = t23 - Scalar(0.0001273);
  const Scalar dI_6_xy = t23 + Ic_6_xx;
  const Scalar db_15_6r = t9 * dI_6_yy - t19 - t8 * dI_6_xy + t21;
  const Scalar c_5_1_6 = t22 + db_15_6r;
  c[99] = c_5_1_6;
  const Scalar t24 = c_5 * Ic_6_xz;
  const Scalar dmu_4_6_y = s_5 * dI_6_xy + t24;
  const Scalar t25 = Scalar(0.0006623) * s_5 - t24;
  const Scalar c_5_4_6 = t25 - dmu_4_6_y;
  c[102] = c_5_4_6;
  const Scalar Iu_5_t_d = Ic_6_xx + Scalar(0.0044257);
  const Scalar Ic_5_xy = Ic_6_xz + Scalar(0.00054285);
  const Scalar t26 = Scalar(2.0) * Ic_5_xy;
  const Scalar t27 = c_5 * Iu_5_t_d - s_5 * t26;
  const Scalar t28 = s_5 * t27;
  const Scalar dmu_4_5_y = c_5 * t26 + s_5 * Iu_5_t_d;
  const Scalar db_44_5r = t28 + c_5 * dmu_4_5_y;
  c[76] = db_44_5r;
  const Scalar t29 = c_5 * Iu_6_a_xy;
  const Scalar t30 = t29 - s_5 * dI_6_yy;
  const Scalar db_44_6r = s_5 * (t29 + t30);
  c[81] = db_44_6r;
  const Scalar t31 = f_u_6_6_a_z - Scalar(0.0045675);
  const Scalar t32 = c_5 * t31 + Scalar(0.0071325) * s_5;
  const Scalar t33 = s_4 * t32;
  const Scalar t34 = v_1_4_a_y * t33;
  const Scalar t35 = t16 * t18 + Ic_5_yz * t8 - t34;
  c[14] = Scalar(-2.0) * t35;
  c[19] = db_15_6r - t22;
  c[115] = -c_5_1_6;
  c[82] = -dmu_4_6_y - t25;
  c[118] = -c_5_4_6;
  c[93] = -db_44_5r;
  c[114] = -db_44_6r;
  const Scalar t36 = c_5 * Ic_5_yz - s_5 * t16;
  const Scalar t37 = s_4 * t36;
  const Scalar t38 = c_3 * c_5 - v_o_2_4_x * t17;
  const Scalar t39 = Scalar(0.0071325) * t38 - t31 * v_2_5_x;
  const Scalar t40 = t39 - t37;
  c[35] = Scalar(-2.0) * t40;
  const Scalar t41 = t37 - c_4 * t32;
  c[56] = Scalar(2.0) * t41;
  const Scalar t42 = Iu_5_a_xz * t9;
  const Scalar hu_5_t_y = Scalar(0.0071325) * c_5 - s_5 * t31;
  const Scalar t43 = c_4 * v_1_4_a_y;
  const Scalar t44 = hu_5_t_y * t43;
  const Scalar mu_u_5_5_a_y = t23 - Scalar(0.0080301);
  const Scalar t45 = c_4 * mu_u_5_5_a_y * w_1_3_x - t42 + t44;
  const Scalar t46 = t42 - t27 * t8 - t18 * dmu_4_5_y + t44;
  const Scalar c_4_1_5 = t45 - t46;
  c[73] = c_4_1_5;
  const Scalar t47 = mr_6_y * t4 - s_4 * f_u_6_6_a_z;
  const Scalar t48 = v_1_4_a_y * t47;
  const Scalar t49 = t9 * dmu_4_6_y - t8 * t30 - t18 * t1 + t48;
  const Scalar t50 = t48 - w_1_3_x * (c_4 * Iu_6_a_xy + s_4 * t25);
  const Scalar c_4_1_6 = t50 - t49;
  c[78] = c_4_1_6;
  const Scalar t51 = t43 * (Scalar(0.0071325) * t18 - t31 * t8);
  const Scalar dmu_1_5_x = -Ic_5_yz * t9 - t26 * t8 + t31 * t43 + Iu_5_t_d * t18;
  const Scalar t52 = t16 * t9 - t26 * t18 - Iu_5_t_d * t8 + Scalar(0.0071325) * t43;
  const Scalar c_5_1_1 = t51 - t8 * dmu_1_5_x + t18 * t52 - t9 * (t34 - t35);
  c[84] = c_5_1_1;
  const Scalar t53 = s_5 * v_1_4_a_y;
  const Scalar t54 = s_4 * (f_u_6_6_a_z * t53 - w_1_3_x * dI_6_xy);
  const Scalar t55 = t8 * (Iu_6_a_xy * t18 - t8 * dI_6_yy + t54);
  const Scalar t56 = s_4 * (w_1_3_x * db_15_6r + (f_u_6_6_a_z * t8 + mr_6_y * t9) * t53);
  const Scalar db_11_6r = t55 + t56 - t18 * (t11 + t12);
  c[15] = db_11_6r;
  c[13] = -t45 - t46;
  c[90] = -c_4_1_5;
  c[18] = -t50 - t49;
  c[111] = -c_4_1_6;
  const Scalar t57 = c_4 * dmu_4_6_y + t2 * t30;
  const Scalar t58 = f_u_6_6_a_z * t38 - Iu_6_a_xy * t20;
  const Scalar t59 = t57 - c_5 * t14 + s_5 * t58;
  const Scalar t60 = s_4 * Iu_6_a_xy;
  const Scalar t61 = c_4 * t25 - t60;
  const Scalar t62 = c_4 * f_u_6_6_a_z;
  const Scalar f_u_6_4_a_z = t62 + mr_6_y * t2;
  const Scalar t63 = t61 + v_o_2_4_x * f_u_6_4_a_z;
  c[39] = t63 - t59;
  const Scalar c_6_2_4 = t63 + t59;
  c[112] = c_6_2_4;
  const Scalar t64 = s_5 * Ic_6_xz;
  const Scalar t65 = c_4 * dI_6_yy - s_4 * (t64 - c_5 * dI_6_xy);
  const Scalar t66 = mr_6_y * t38;
  const Scalar t67 = t66 - t65;
  const Scalar mu_u_6_5_t_y = Scalar(0.0006623) * c_5 + t64;
  const Scalar t68 = s_4 * mu_u_6_5_t_y;
  const Scalar t69 = t66 - t68;
  const Scalar c_5_2_6 = t69 - t67;
  c[100] = c_5_2_6;
  const Scalar t70 = t57 - t20 * t1 + f_u_6_4_a_z;
  const Scalar t71 = t61 - f_u_6_4_a_z;
  c[60] = t71 - t70;
  const Scalar c_6_3_4 = t71 + t70;
  c[113] = c_6_3_4;
  const Scalar t72 = mr_6_y * t17;
  const Scalar dmu_3_6_y = t72 - t65;
  const Scalar db_36_5 = t68 - t72;
  c[61] = db_36_5 - dmu_3_6_y;
  const Scalar c_6_3_5 = db_36_5 + dmu_3_6_y;
  c[117] = c_6_3_5;
  const Scalar t73 = t32 + Scalar(0.02619);
  const Scalar hc_4_y = mr_6_y + Scalar(0.0482625);
  const Scalar f_u_4_4_a_z = c_4 * t73 + s_4 * hc_4_y;
  const Scalar df_2_3_x = f_u_4_4_a_z - Scalar(0.0617625);
  const Scalar hc_3_y = hu_5_t_y + Scalar(0.86193);
  const Scalar t74 = c_3 * hc_3_y - s_3 * df_2_3_x;
  c[25] = c[26] = Scalar(-2.0) * t74;
  c[44] = Scalar(2.0) * t74;
  c[10] = -c_5_1_1;
  const Scalar t75 = c_4 * dI_6_xy - t2 * dI_6_yy;
  const Scalar t76 = t75 + t58;
  const Scalar t77 = t38 * t10 - t14 * t20;
  const Scalar c_6_2_2 = t77 + c_4 * t67 - s_4 * (c_5 * t76 - s_5 * t15);
  c[107] = c_6_2_2;
  c[105] = -db_11_6r;
  c[79] = -c_6_2_4;
  c[40] = -t69 - t67;
  c[116] = -c_5_2_6;
  c[80] = -c_6_3_4;
  c[101] = -c_6_3_5;
  const Scalar t78 = c_5 * t27;
  const Scalar t79 = mu_u_5_5_a_y + Scalar(0.0161843);
  const Scalar Iu_4_t_d = t78 - Scalar(0.0044257) + t79;
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0004868);
  const Scalar t80 = Scalar(2.0) * Ic_4_xy;
  const Scalar t81 = c_4 * Iu_4_t_d - s_4 * t80;
  const Scalar t82 = s_4 * t81;
  const Scalar t83 = c_4 * t80 + s_4 * Iu_4_t_d;
  const Scalar db_33_4r = t82 + c_4 * t83;
  c[49] = c[50] = db_33_4r;
  c[37] = -c_6_2_2;
  const Scalar t84 = t75 - s_5 * (t60 - t62);
  const Scalar t85 = c_4 * dmu_3_6_y - s_4 * (c_5 * t84 - s_5 * t6);
  const Scalar c_6_3_3 = t85 + s_5 * (c_4 * t10 + s_4 * t5);
  c[110] = c_6_3_3;
  const Scalar Ic_4_xz = Ic_5_xy + t28 - Scalar(0.0055448);
  const Scalar t86 = t36 - Scalar(0.0261804);
  const Scalar t87 = c_4 * Ic_4_xz + s_4 * t86;
  const Scalar t88 = t87 - f_u_4_4_a_z * v_o_2_4_x;
  c[30] = Scalar(-2.0) * t88;
  const Scalar mu_4_3_x = t87 + f_u_4_4_a_z;
  c[51] = Scalar(-2.0) * mu_4_3_x;
  const Scalar t89 = t9 * t67 + t8 * t76 + t18 * t15;
  const Scalar t90 = s_2 * (f_u_6_4_a_z - c_3 * mu_u_6_5_t_y + s_3 * t71);
  const Scalar t91 = c_2 * (s_3 * mu_u_6_5_t_y + c_3 * t71) - t90;
  const Scalar c_2_1_6 = t91 - t89;
  c[36] = c_2_1_6;
  const Scalar t92 = c_4 * Iu_5_a_xz;
  const Scalar t93 = t92 + s_4 * mu_u_5_5_a_y;
  const Scalar t94 = s_4 * hu_5_t_y;
  const Scalar db_35_4 = t93 - t94;
  const Scalar t95 = t36 * w_1_3_x + t7 * db_35_4;
  const Scalar t96 = c_4 * Ic_5_yz - s_4 * dmu_4_5_y;
  const Scalar t97 = t96 - s_4 * t31;
  const Scalar t98 = c_4 * t16 + s_4 * t27;
  const Scalar t99 = t98 + Scalar(0.0071325) * s_4;
  const Scalar t100 = t41 * t9 - t8 * t97 - t18 * t99;
  const Scalar c_3_1_5 = t95 + t100;
  c[52] = c_3_1_5;
  const Scalar t101 = t9 * dmu_3_6_y + t8 * t84 + t18 * t6;
  const Scalar t102 = w_1_3_x * mu_u_6_5_t_y + t7 * t71;
  const Scalar c_3_1_6 = t102 - t101;
  c[57] = c_3_1_6;
  const Scalar t103 = t92 + s_4 * (t78 - s_5 * dmu_4_5_y);
  const Scalar t104 = hu_5_t_y * t13;
  const Scalar t105 = t104 - t103;
  const Scalar db_25_4 = t93 + t104;
  c[34] = db_25_4 + t105;
  const Scalar c_5_2_4 = db_25_4 - t105;
  c[91] = c_5_2_4;
  const Scalar t106 = t103 + t94;
  c[55] = db_35_4 - t106;
  const Scalar c_5_3_4 = db_35_4 + t106;
  c[92] = c_5_3_4;
  const Scalar t107 = t83 - c_3 * hc_4_y;
  const Scalar t108 = t81 + c_3 * t73;
  const Scalar t109 = c_4 * hc_4_y - s_4 * t73;
  const Scalar t110 = c_3 * t109;
  const Scalar c_4_2_2 = t110 - c_4 * t107 - s_4 * t108;
  c[65] = c_4_2_2;
  c[67] = c[68] = -db_33_4r;
  const Scalar t111 = t96 + t31 * t13;
  const Scalar t112 = Scalar(0.0071325) * t13 - t98;
  const Scalar t113 = t33 * t13 - c_4 * t39;
  const Scalar c_2_2_5 = t113 - c_4 * t40 + s_4 * (c_5 * t111 + s_5 * t112);
  c[32] = c_2_2_5;
  c[59] = -c_6_3_3;
  const Scalar t114 = c_4 * t86 - s_4 * Ic_4_xz;
  const Scalar t115 = t109 * v_1_4_a_y;
  const Scalar t116 = t115 - t114 * w_1_3_x;
  c[9] = Scalar(-2.0) * t116;
  c[16] = -t91 - t89;
  c[106] = -c_2_1_6;
  c[12] = t100 - t95;
  c[87] = -c_3_1_5;
  c[17] = -t102 - t101;
  c[108] = -c_3_1_6;
  const Scalar t117 = t77 + t85;
  const Scalar t118 = c_3 * t47 - s_3 * s_5 * mr_6_y;
  const Scalar c_3_2_6 = t118 - t117;
  c[58] = c_3_2_6;
  c[74] = -c_5_2_4;
  c[75] = -c_5_3_4;
  c[28] = -c_4_2_2;
  c[86] = -c_2_2_5;
  const Scalar t119 = c_4 * t41 + s_4 * (c_5 * t97 - s_5 * t99);
  const Scalar c_5_3_3 = t32 - t119;
  c[89] = c_5_3_3;
  const Scalar t120 = s_2 * (t94 - c_3 * t36 + s_3 * db_35_4);
  const Scalar t121 = c_2 * (s_3 * t36 + c_3 * db_35_4) - t120;
  const Scalar t122 = t40 * t9 + t8 * t111 - t18 * t112;
  const Scalar c_2_1_5 = t121 - t122;
  c[31] = c_2_1_5;
  c[38] = -t118 - t117;
  c[109] = -c_3_2_6;
  c[54] = -c_5_3_3;
  const Scalar t123 = Ic_4_xy + t82 - Scalar(0.0080685);
  const Scalar t124 = t114 - Scalar(0.0204192) + t109;
  const Scalar t125 = t123 * t7 + t124 * w_1_3_x;
  c[5] = Scalar(-2.0) * t125;
  c[11] = -t121 - t122;
  c[85] = -c_2_1_5;
  const Scalar t126 = c_4 * t81;
  const Scalar t127 = mu_4_3_x * t7;
  const Scalar t128 = w_1_3_x * (t126 - s_4 * t83) + t127;
  const Scalar Ic_4_zz = Ic_6_xx - t78 + Scalar(0.0285811);
  const Scalar t129 = Ic_4_zz * w_1_3_x - t127;
  const Scalar c_3_1_4 = t129 - t128;
  c[48] = c_3_1_4;
  c[29] = -t110 - (t110 - db_33_4r);
  const Scalar t130 = t113 + t119;
  const Scalar t131 = c_3 * c_4 * hu_5_t_y - s_3 * t32;
  const Scalar c_3_2_5 = t131 + t130;
  c[53] = c_3_2_5;
  const Scalar t132 = c_4 * (t86 * t7 - w_1_3_x * t83);
  const Scalar t133 = w_1_3_x * (t132 - s_4 * (Ic_4_xz * t7 + t81 * w_1_3_x));
  const Scalar c_4_1_1 = t7 * (t115 + t116) - t133;
  c[63] = c_4_1_1;
  const Scalar t134 = s_2 * (-c_3 * Ic_4_zz - s_3 * mu_4_3_x + f_u_4_4_a_z);
  const Scalar db_14_2 = c_2 * (c_3 * mu_4_3_x - s_3 * Ic_4_zz) + t134;
  const Scalar t135 = w_1_3_x * (c_4 * t108 - s_4 * t107) + t7 * t88;
  c[7] = db_14_2 - t135;
  const Scalar c_4_1_2 = db_14_2 + t135;
  c[64] = c_4_1_2;
  c[8] = -t128 - t129;
  c[66] = -c_3_1_4;
  c[33] = t130 - t131;
  c[88] = -c_3_2_5;
  const Scalar Ic_3_xy = Scalar(0.013088) + mu_4_3_x;
  const Scalar t136 = Scalar(2.0) * Ic_3_xy;
  const Scalar Iu_3_t_d = Scalar(2.0) * hu_5_t_y + t126 - t79 - Ic_4_zz + Scalar(0.96799115);
  const Scalar t137 = w_1_3_x * (c_2 * df_2_3_x - t136 * w_1_3_x + Iu_3_t_d * t7);
  const Scalar t138 = t7 * (c_2 * hc_3_y - t136 * t7 - Iu_3_t_d * w_1_3_x);
  const Scalar db_11_3r = c_2 * (df_2_3_x * w_1_3_x - hc_3_y * t7) + t137 - t138;
  c[3] = db_11_3r;
  c[6] = -c_4_1_1;
  const Scalar t139 = c_3 * t123 + s_3 * t124;
  const Scalar t140 = c_3 * t124 - s_3 * t123;
  const Scalar t141 = c_2 * t139 + s_2 * t140;
  const Scalar c_3_1_2 = t125 - t141;
  c[43] = c_3_1_2;
  c[27] = -c_4_1_2;
  const Scalar Iu_2_t_xz = c_2 * (t109 - t139 - Scalar(0.0549346)) -
      s_2 * (Scalar(0.0222188) + t140);
  c[2] = Scalar(2.0) * Iu_2_t_xz;
  c[42] = -db_11_3r;
  c[4] = -t125 - t141;
  c[24] = -c_3_1_2;
  const Scalar t142 = c_3 * Iu_3_t_d - s_3 * t136;
  const Scalar t143 = Iu_3_t_d - Scalar(2.0) * (c_3 * (df_2_3_x + t142) + s_3 * hc_3_y) +
      Scalar(4.2001111);
  const Scalar t144 = Scalar(2.0) * (Ic_3_xy + Scalar(0.0342474) + s_3 * t142 - t74);
  const Scalar t145 = s_2 * (s_2 * t144 + c_2 * t143);
  const Scalar c_2_1_1 = t145 - c_2 * (c_2 * t144 - s_2 * t143);
  c[21] = c_2_1_1;
  c[1] = -c_2_1_1;
  c[0] = c[22] = c[23] = c[45] = c[46] = c[47] = c[69] = c[70] = Scalar(0.0);
  c[71] = c[72] = c[94] = c[95] = c[96] = c[97] = c[98] = c[120] = Scalar(0.0);
  c[121] = c[122] = c[123] = c[124] = c[125] = Scalar(0.0);
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
// Reads q[1..5], qd[0..5]. Operations: 447 mul, 394 add, 10 sin/cos. Always zero: 1 of the 36
// entries of C.
template <class Scalar, class SinCos = LibrarySinCos>
inline void coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar I_t6_g = Scalar(0.0001273) * c_6 - Scalar(0.000256) * s_6;
  const Scalar Ic_6_xy = s_6 * I_t6_g + Scalar(0.000128);
  const Scalar t1 = Scalar(2.0) * Ic_6_xy;
  C[28] = qd_6 * t1;
  const Scalar Iu_6_a_xy = Scalar(0.0004972) * c_6 - Scalar(0.000267) * s_6;
  const Scalar t2 = c_5 * Iu_6_a_xy;
  const Scalar t3 = s_5 * t1 - t2;
  const Scalar t4 = s_5 * (t2 - t3);
  const Scalar t5 = c_6 * I_t6_g;
  const Scalar Ic_6_xx = t5 - Scalar(0.0001273);
  const Scalar Iu_5_t_d = Ic_6_xx + Scalar(0.0044257);
  const Scalar Ic_6_xz = Scalar(0.000267) * c_6 + Scalar(0.0004972) * s_6;
  const Scalar Ic_5_xy = Ic_6_xz + Scalar(0.00054285);
  const Scalar t6 = Scalar(2.0) * Ic_5_xy;
  const Scalar t7 = s_5 * t6 - c_5 * Iu_5_t_d;
  const Scalar t8 = s_5 * t7;
  const Scalar dmu_4_5_y = c_5 * t6 + s_5 * Iu_5_t_d;
  const Scalar t9 = t8 - c_5 * dmu_4_5_y;
  C[21] = qd_6 * t4 - qd_5 * t9;
  const Scalar dI_6_xy = t5 + Ic_6_xx;
  const Scalar t10 = s_5 * Ic_6_xz;
  const Scalar t11 = s_4 * (t10 - c_5 * dI_6_xy) - c_4 * t1;
  const Scalar mr_6_y = Scalar(0.00252) * c_6 - Scalar(0.001575) * s_6;
  const Scalar t12 = c_4 * s_5;
  const Scalar t13 = mr_6_y * t12;
  const Scalar dmu_3_6_y = t11 + t13;
  const Scalar mu_u_6_5_t_y = Scalar(0.0006623) * c_5 + t10;
  const Scalar t14 = s_4 * mu_u_6_5_t_y;
  const Scalar db_36_5 = t14 - t13;
  const Scalar c_6_3_5 = db_36_5 + dmu_3_6_y;
  const Scalar v_o_2_4_x = s_3 - Scalar(1.0);
  const Scalar t15 = v_o_2_4_x * t12 - c_3 * c_5;
  const Scalar t16 = mr_6_y * t15;
  const Scalar t17 = t16 - t11;
  const Scalar t18 = t14 + t16;
  const Scalar t19 = t18 - t17;
  const Scalar t20 = c_5 * Ic_6_xz;
  const Scalar dmu_4_6_y = s_5 * dI_6_xy + t20;
  const Scalar t21 = Scalar(0.0006623) * s_5 - t20;
  const Scalar c_5_4_6 = t21 - dmu_4_6_y;
  const Scalar w_1_3_x = s_2 * c_3 + c_2 * s_3;
  const Scalar t22 = s_2 * s_3 - c_2 * c_3;
  const Scalar t23 = w_1_3_x * t12 + c_5 * t22;
  const Scalar t24 = Ic_6_xz * t23;
  const Scalar t25 = c_4 * c_5;
  const Scalar t26 = s_5 * t22 - w_1_3_x * t25;
  const Scalar v_1_4_a_y = c_2 - w_1_3_x;
  const Scalar t27 = s_4 * s_5;
  const Scalar t28 = mr_6_y * v_1_4_a_y * t27;
  const Scalar t29 = Scalar(0.0006623) * t26 - t24 + t28;
  const Scalar t30 = s_4 * w_1_3_x;
  const Scalar db_15_6r = t24 + t26 * dI_6_xy + t30 * t1 + t28;
  const Scalar t31 = t29 - db_15_6r;
  const Scalar C_65 = -qd_4 * c_5_4_6 - qd_5 * t1 + qd_3 * c_6_3_5 + qd_2 * t19 + qd_1 * t31;
  C[34] = C_65;
  const Scalar t32 = s_4 * c_5;
  const Scalar t33 = t32 * t3 - c_4 * dmu_4_6_y;
  const Scalar f_u_6_6_a_z = Scalar(0.001575) * c_6 + Scalar(0.00252) * s_6;
  const Scalar t34 = Iu_6_a_xy * t27 + f_u_6_6_a_z * t15;
  const Scalar v_2_5_x = c_3 * s_5 + v_o_2_4_x * t25;
  const Scalar t35 = s_4 * v_o_2_4_x;
  const Scalar t36 = mr_6_y * t35 + f_u_6_6_a_z * v_2_5_x;
  const Scalar t37 = t33 + s_5 * t34 + c_5 * t36;
  const Scalar t38 = s_4 * Iu_6_a_xy;
  const Scalar t39 = t38 - c_4 * t21;
  const Scalar t40 = c_4 * f_u_6_6_a_z;
  const Scalar f_u_6_4_a_z = mr_6_y * t32 + t40;
  const Scalar t41 = t39 - v_o_2_4_x * f_u_6_4_a_z;
  const Scalar t42 = t41 + t37;
  const Scalar t43 = s_5 * Iu_6_a_xy;
  const Scalar t44 = -t27 * t43 - t33 + f_u_6_4_a_z;
  const Scalar t45 = t39 + f_u_6_4_a_z;
  const Scalar t46 = t45 - t44;
  const Scalar t47 = s_4 * f_u_6_6_a_z - mr_6_y * t25;
  const Scalar t48 = v_1_4_a_y * t47;
  const Scalar t49 = t26 * t3 - t23 * t43 - t30 * dmu_4_6_y + t48;
  const Scalar t50 = w_1_3_x * (s_4 * t21 + c_4 * Iu_6_a_xy) + t48;
  const Scalar t51 = t50 - t49;
  const Scalar t52 = qd_4 * t4 - qd_1 * t51 + qd_3 * t46 + qd_2 * t42;
  const Scalar t53 = dmu_4_6_y + t21;
  const Scalar t54 = Scalar(2.0) * qd_6;
  C[23] = t43 * t54 - qd_5 * t53 + t52;
  const Scalar t55 = t32 * t1 - c_4 * dI_6_xy;
  const Scalar t56 = t55 + s_5 * (t38 - t40);
  const Scalar t57 = Iu_6_a_xy * t32 + c_4 * Ic_6_xz;
  const Scalar t58 = f_u_6_6_a_z * t25 + s_4 * mr_6_y;
  const Scalar t59 = t57 + t58;
  const Scalar t60 = -t26 * t56 - t30 * dmu_3_6_y + t23 * t59;
  const Scalar t61 = w_1_3_x * mu_u_6_5_t_y + t22 * t45;
  const Scalar t62 = t61 - t60;
  const Scalar t63 = t55 + t34;
  const Scalar t64 = t57 - t36;
  const Scalar t65 = t30 * t17 - t26 * t63 + t23 * t64;
  const Scalar t66 = s_2 * (f_u_6_4_a_z - c_3 * mu_u_6_5_t_y - s_3 * t45);
  const Scalar t67 = t66 - c_2 * (s_3 * mu_u_6_5_t_y - c_3 * t45);
  const Scalar t68 = t67 + t65;
  const Scalar t69 = s_5 * v_1_4_a_y;
  const Scalar t70 = s_4 * (w_1_3_x * db_15_6r + (mr_6_y * t30 - f_u_6_6_a_z * t26) * t69);
  const Scalar t71 = s_4 * (w_1_3_x * dI_6_xy - f_u_6_6_a_z * t69);
  const Scalar t72 = t26 * (Iu_6_a_xy * t23 - t26 * t1 + t71);
  const Scalar t73 = f_u_6_6_a_z * t32 - c_4 * mr_6_y;
  const Scalar t74 = v_1_4_a_y * t73;
  const Scalar t75 = -Iu_6_a_xy * t26 - Ic_6_xz * t30 + t74;
  const Scalar db_11_6r = t70 + t72 - t23 * (t74 + t75);
  const Scalar t76 = qd_1 * db_11_6r;
  const Scalar t77 = t50 + t49;
  const Scalar t78 = t29 + db_15_6r;
  C[5] = qd_5 * t78 + qd_4 * t77 - qd_3 * t62 + t76 + t75 * t54 + qd_2 * t68;
  C[29] = -Ic_6_xz * t54 - C_65;
  C[33] = -qd_5 * c_5_4_6 - t52;
  const Scalar t79 = Ic_6_xy + Scalar(0.00038195);
  const Scalar t80 = s_4 * t7 - c_4 * t79;
  const Scalar t81 = t80 + Scalar(0.0071325) * t35;
  const Scalar Ic_5_yz = Iu_6_a_xy + Scalar(0.00080815);
  const Scalar t82 = s_4 * dmu_4_5_y - c_4 * Ic_5_yz;
  const Scalar t83 = f_u_6_6_a_z - Scalar(0.0045675);
  const Scalar t84 = t82 - t83 * t35;
  const Scalar t85 = s_5 * t79 - c_5 * Ic_5_yz;
  const Scalar t86 = s_4 * t85;
  const Scalar t87 = t83 * v_2_5_x + Scalar(0.0071325) * t15;
  const Scalar t88 = t87 - t86;
  const Scalar t89 = c_5 * t83 + Scalar(0.0071325) * s_5;
  const Scalar t90 = s_4 * t89;
  const Scalar t91 = t90 * t35 + c_4 * t87;
  const Scalar t92 = t91 + s_4 * (s_5 * t81 - c_5 * t84) + c_4 * t88;
  const Scalar Iu_5_a_xz = c_5 * t79 + s_5 * Ic_5_yz;
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0004868);
  const Scalar t93 = Scalar(2.0) * Ic_4_xy;
  const Scalar t94 = c_5 * t7;
  const Scalar mu_u_5_5_a_y = t5 - Scalar(0.0080301);
  const Scalar t95 = mu_u_5_5_a_y + Scalar(0.0161843);
  const Scalar Iu_4_t_d = -t94 - Scalar(0.0044257) + t95;
  const Scalar t96 = s_4 * t93 - c_4 * Iu_4_t_d;
  const Scalar t97 = t89 + Scalar(0.02619);
  const Scalar t98 = t96 - c_3 * t97;
  const Scalar t99 = c_4 * t93 + s_4 * Iu_4_t_d;
  const Scalar hc_4_y = mr_6_y + Scalar(0.0482625);
  const Scalar t100 = t99 - c_3 * hc_4_y;
  const Scalar t101 = s_4 * t97 - c_4 * hc_4_y;
  const Scalar t102 = c_3 * t101;
  const Scalar c_4_2_2 = s_4 * t98 - c_4 * t100 - t102;
  const Scalar t103 = t36 * t27 - t15 * t73;
  const Scalar t104 = t103 - s_4 * (s_5 * t64 + c_5 * t63) + c_4 * t17;
  const Scalar f_u_4_4_a_z = c_4 * t97 + s_4 * hc_4_y;
  const Scalar df_2_3_x = f_u_4_4_a_z - Scalar(0.0617625);
  const Scalar hu_5_t_y = Scalar(0.0071325) * c_5 - s_5 * t83;
  const Scalar hc_3_y = hu_5_t_y + Scalar(0.86193);
  const Scalar t105 = s_3 * df_2_3_x - c_3 * hc_3_y;
  const Scalar t106 = Scalar(2.0) * qd_3;
  const Scalar t107 = t105 * t106;
  C[7] = qd_6 * t104 + qd_5 * t92 - qd_4 * c_4_2_2 + t107;
  const Scalar t108 = t67 - t65;
  const Scalar t109 = qd_2 * t104 - qd_1 * t108;
  const Scalar t110 = c_4 * dmu_3_6_y + s_4 * (c_5 * t56 + s_5 * t59);
  const Scalar t111 = t103 - t110;
  const Scalar t112 = s_3 * s_5 * mr_6_y + c_3 * t47;
  const Scalar t113 = t112 + t111;
  const Scalar t114 = t18 + t17;
  const Scalar t115 = t41 - t37;
  C[11] = qd_5 * t114 + t109 - t64 * t54 - qd_4 * t115 + qd_3 * t113;
  const Scalar t116 = c_4 * Iu_5_a_xz;
  const Scalar t117 = t116 - s_4 * (t94 + s_5 * dmu_4_5_y);
  const Scalar t118 = hu_5_t_y * t35;
  const Scalar t119 = t118 - t117;
  const Scalar t120 = t116 + s_4 * mu_u_5_5_a_y;
  const Scalar db_25_4 = t120 + t118;
  const Scalar c_5_2_4 = db_25_4 - t119;
  const Scalar t121 = s_4 * hu_5_t_y;
  const Scalar t122 = t117 + t121;
  const Scalar db_35_4 = t120 - t121;
  const Scalar c_5_3_4 = db_35_4 + t122;
  const Scalar t123 = Iu_5_a_xz * t30;
  const Scalar t124 = c_4 * v_1_4_a_y;
  const Scalar t125 = hu_5_t_y * t124;
  const Scalar t126 = t123 - c_4 * mu_u_5_5_a_y * w_1_3_x - t125;
  const Scalar t127 = t123 + t23 * dmu_4_5_y - t7 * t26 + t125;
  const Scalar t128 = t126 + t127;
  const Scalar t129 = qd_4 * t9 + qd_2 * c_5_2_4 + qd_1 * t128 + qd_3 * c_5_3_4;
  C[27] = qd_6 * c_5_4_6 + t129;
  const Scalar c_3_1_6 = t61 + t60;
  const Scalar t130 = t76 - qd_5 * t31 - qd_4 * t51 + qd_3 * c_3_1_6 - qd_2 * t108;
  C[30] = -t130;
  const Scalar t131 = s_2 * (c_3 * t85 + t121 + s_3 * db_35_4);
  const Scalar t132 = c_2 * (s_3 * t85 - c_3 * db_35_4) + t131;
  const Scalar t133 = t23 * t81 + t26 * t84 - t88 * t30;
  const Scalar t134 = t132 - t133;
  const Scalar t135 = t85 * w_1_3_x + t22 * db_35_4;
  const Scalar t136 = Scalar(0.0071325) * s_4 - t80;
  const Scalar t137 = t82 + s_4 * t83;
  const Scalar t138 = t86 + c_4 * t89;
  const Scalar t139 = t23 * t136 - t26 * t137 - t138 * t30;
  const Scalar t140 = t135 + t139;
  const Scalar t141 = v_1_4_a_y * t90;
  const Scalar t142 = t79 * t23 + Ic_5_yz * t26 + t141;
  const Scalar t143 = t79 * t30 + t6 * t23 + Iu_5_t_d * t26 + Scalar(0.0071325) * t124;
  const Scalar dmu_1_5_x = t6 * t26 - Ic_5_yz * t30 - Iu_5_t_d * t23 + t83 * t124;
  const Scalar t144 = t124 * (Scalar(0.0071325) * t23 - t83 * t26);
  const Scalar t145 = t30 * (t141 + t142) + t23 * t143 - t26 * dmu_1_5_x + t144;
  const Scalar t146 = qd_1 * t145;
  const Scalar t147 = t126 - t127;
  const Scalar t148 = Scalar(2.0) * qd_5;
  C[4] = qd_6 * t78 + t142 * t148 + qd_4 * t147 + qd_3 * t140 + qd_2 * t134 + t146;
  C[22] = -qd_6 * t53 - Iu_5_a_xz * t148 - t129;
  const Scalar t149 = t112 - t111;
  C[31] = qd_5 * t19 - t109 - qd_4 * t42 + qd_3 * t149;
  const Scalar c_6_3_3 = t110 + s_5 * (s_4 * t58 - c_4 * t73);
  const Scalar t150 = qd_3 * c_6_3_3 - qd_1 * c_3_1_6 + qd_2 * t149;
  C[32] = qd_5 * c_6_3_5 - qd_4 * t46 + t150;
  const Scalar t151 = t132 + t133;
  const Scalar t152 = qd_2 * t92 - qd_1 * t151;
  const Scalar t153 = s_4 * (s_5 * t136 + c_5 * t137) + c_4 * t138;
  const Scalar t154 = t91 - t153;
  const Scalar t155 = s_3 * t89 - c_3 * c_4 * hu_5_t_y;
  const Scalar t156 = t155 + t154;
  const Scalar c_2_4_5 = db_25_4 + t119;
  C[10] = qd_6 * t114 + qd_4 * c_2_4_5 + qd_3 * t156 + t152 + t88 * t148;
  const Scalar t157 = t89 + t153;
  const Scalar t158 = s_4 * t96;
  const Scalar t159 = t158 - c_4 * t99;
  const Scalar t160 = qd_4 * t159;
  C[14] = -qd_6 * c_6_3_3 - qd_5 * t157 - t160;
  const Scalar c_3_5_6 = db_36_5 - dmu_3_6_y;
  const Scalar t161 = t45 + t44;
  C[17] = qd_5 * c_3_5_6 - qd_4 * t161 - t150 - t59 * t54;
  const Scalar t162 = t135 - t139;
  const Scalar t163 = qd_6 * t31 + t146 - qd_4 * t128 - qd_3 * t162 - qd_2 * t151;
  C[24] = -t163;
  const Scalar Ic_4_xz = Ic_5_xy - t8 - Scalar(0.0055448);
  const Scalar t164 = t85 + Scalar(0.0261804);
  const Scalar t165 = s_4 * t164 - c_4 * Ic_4_xz;
  const Scalar mu_4_3_x = f_u_4_4_a_z - t165;
  const Scalar Ic_4_zz = Ic_6_xx + t94 + Scalar(0.0285811);
  const Scalar t166 = s_2 * (-s_3 * mu_4_3_x - c_3 * Ic_4_zz + f_u_4_4_a_z);
  const Scalar db_14_2 = t166 - c_2 * (s_3 * Ic_4_zz - c_3 * mu_4_3_x);
  const Scalar t167 = t165 + f_u_4_4_a_z * v_o_2_4_x;
  const Scalar t168 = w_1_3_x * (s_4 * t100 + c_4 * t98) - t22 * t167;
  const Scalar c_1_2_4 = db_14_2 + t168;
  const Scalar t169 = s_4 * (Ic_4_xz * t22 + t96 * w_1_3_x);
  const Scalar t170 = w_1_3_x * (t169 - c_4 * (w_1_3_x * t99 - t164 * t22));
  const Scalar t171 = s_4 * Ic_4_xz + c_4 * t164;
  const Scalar t172 = t101 * v_1_4_a_y;
  const Scalar t173 = t171 * w_1_3_x - t172;
  const Scalar t174 = t170 - t22 * (t172 - t173);
  const Scalar t175 = qd_1 * t174;
  const Scalar t176 = c_4 * t96;
  const Scalar t177 = mu_4_3_x * t22;
  const Scalar t178 = w_1_3_x * (t176 + s_4 * t99) + t177;
  const Scalar t179 = t177 + Ic_4_zz * w_1_3_x;
  const Scalar t180 = t179 - t178;
  const Scalar t181 = Scalar(2.0) * qd_4;
  C[3] = qd_6 * t77 + qd_5 * t147 + t175 - t173 * t181 - qd_3 * t180 + qd_2 * c_1_2_4;
  const Scalar c_3_1_4 = t178 + t179;
  const Scalar t182 = qd_3 * t159;
  const Scalar t183 = t182 + qd_2 * t159 - qd_1 * c_3_1_4;
  C[20] = qd_6 * t46 - qd_5 * c_5_3_4 + t183;
  const Scalar t184 = t155 - t154;
  C[25] = qd_4 * c_5_2_4 - qd_6 * t19 + qd_3 * t184 - t152;
  const Scalar t185 = qd_3 * t157 + qd_2 * t184 + qd_1 * t162;
  C[26] = qd_4 * c_5_3_4 - qd_6 * c_6_3_5 + t185;
  const Scalar c_3_4_5 = db_35_4 - t122;
  C[15] = qd_5 * c_3_4_5 - qd_6 * t161 - t183 - mu_4_3_x * t181;
  C[16] = qd_6 * c_3_5_6 - t138 * t148 + qd_4 * c_3_4_5 - t185;
  const Scalar c_4_1_2 = db_14_2 - t168;
  const Scalar t186 = qd_6 * t51 + qd_5 * t128 + t175 + qd_3 * c_3_1_4 - qd_2 * c_4_1_2;
  C[18] = -t186;
  const Scalar t187 = qd_2 * c_4_2_2 + qd_1 * c_4_1_2;
  C[19] = qd_6 * t42 - qd_5 * c_5_2_4 + t182 + t187;
  const Scalar t188 = Ic_4_xy - t158 - Scalar(0.0080685);
  const Scalar t189 = t171 + Scalar(0.0204192) + t101;
  const Scalar t190 = s_3 * t188 + c_3 * t189;
  const Scalar t191 = s_3 * t189 - c_3 * t188;
  const Scalar t192 = s_2 * t190 + c_2 * t191;
  const Scalar t193 = t188 * t22 + t189 * w_1_3_x;
  const Scalar t194 = t193 + t192;
  const Scalar Ic_3_xy = Scalar(0.013088) + mu_4_3_x;
  const Scalar t195 = Scalar(2.0) * Ic_3_xy;
  const Scalar Iu_3_t_d = Scalar(2.0) * hu_5_t_y - t176 - t95 - Ic_4_zz + Scalar(0.96799115);
  const Scalar t196 = t22 * (t195 * t22 - Iu_3_t_d * w_1_3_x + c_2 * hc_3_y);
  const Scalar t197 = w_1_3_x * (t195 * w_1_3_x - c_2 * df_2_3_x + Iu_3_t_d * t22);
  const Scalar db_11_3r = c_2 * (df_2_3_x * w_1_3_x + hc_3_y * t22) - t197 + t196;
  const Scalar t198 = qd_1 * db_11_3r;
  const Scalar t199 = qd_6 * t62 - qd_5 * t140 + qd_4 * t180 - t193 * t106 - qd_2 * t194 - t198;
  C[2] = -t199;
  const Scalar t200 = t193 - t192;
  const Scalar t201 = Scalar(2.0) * qd_2;
  const Scalar t202 = qd_1 * t200 + t105 * t201;
  const Scalar t203 = t102 + (t102 - t159);
  C[8] = qd_6 * t113 + qd_5 * t156 + qd_4 * t203 + t107 + t202;
  const Scalar t204 = qd_6 * t115 - qd_5 * c_2_4_5 - qd_3 * t203 + t187 - t167 * t181;
  C[9] = -t204;
  const Scalar t205 = qd_5 * t162 - qd_6 * c_3_1_6 - qd_4 * c_3_1_4 + qd_2 * t200 + t198;
  C[12] = -t205;
  C[13] = -qd_6 * t149 - qd_5 * t184 - t160 - t202;
  const Scalar t206 = s_3 * t195 - c_3 * Iu_3_t_d;
  const Scalar t207 = Iu_3_t_d - Scalar(2.0) * (c_3 * (df_2_3_x - t206) + s_3 * hc_3_y) +
      Scalar(4.2001111);
  const Scalar t208 = Scalar(2.0) * (Ic_3_xy + Scalar(0.0342474) - s_3 * t206 + t105);
  const Scalar t209 = c_2 * (s_2 * t207 - c_2 * t208);
  const Scalar t210 = t209 + s_2 * (s_2 * t208 + c_2 * t207);
  C[0] = qd_6 * db_11_6r + qd_5 * t145 + qd_4 * t174 + qd_3 * db_11_3r - qd_2 * t210;
  const Scalar t211 = qd_1 * t210;
  const Scalar Iu_2_t_xz = s_2 * (t190 - Scalar(0.0222188)) -
      c_2 * (t101 - t191 + Scalar(0.0549346));
  C[1] = qd_6 * t68 + qd_5 * t134 + qd_4 * c_1_2_4 + qd_3 * t194 + Iu_2_t_xz * t201 - t211;
  C[6] = -qd_6 * t108 - qd_5 * t151 - qd_4 * c_4_1_2 + qd_3 * t200 + t211;
  C[35] = Scalar(0.0);
}

// Gravity torques g(q) (7.39).
//   q[6]  in   joint positions, rad or m
//   g[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5]. Operations: 33 mul, 22 add, 10 sin/cos. Always zero: g[0].
template <class Scalar, class SinCos = LibrarySinCos>
inline void gravity(const Scalar* q, Scalar* g, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = Scalar(0.06867) * c_6 + Scalar(0.109872) * s_6;
  const Scalar t2 = t1 - Scalar(0.199143);
  const Scalar hu_5_t_y = Scalar(0.310977) * c_5 - s_5 * t2;
  const Scalar t3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t4 = c_4 * t3;
  const Scalar t5 = Scalar(0.310977) * s_5 + c_5 * t2;
  const Scalar t6 = s_2 * s_3 - c_2 * c_3;
  g[4] = t5 * t6 - hu_5_t_y * t4;
  const Scalar hu_6_t_y = Scalar(0.109872) * c_6 - Scalar(0.06867) * s_6;
  g[5] = hu_6_t_y * (s_5 * t6 - c_5 * t4) + s_4 * t1 * t3;
  const Scalar t7 = t5 + Scalar(1.141884);
  const Scalar hc_4_y = hu_6_t_y + Scalar(2.104245);
  g[3] = (s_4 * t7 - c_4 * hc_4_y) * t3;
  const Scalar t8 = c_4 * t7 + s_4 * hc_4_y - Scalar(2.692845);
  const Scalar hc_3_y = hu_5_t_y + Scalar(37.580148);
  const Scalar t9 = s_3 * t8 - c_3 * hc_3_y;
  const Scalar t10 = c_3 * t8 + s_3 * hc_3_y;
  g[2] = s_2 * t9 - c_2 * t10;
  g[1] = s_2 * (Scalar(4.102542) + t9) - c_2 * (t10 - Scalar(194.232114));
  g[0] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   n[6]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5], qd[0..5]. Operations: 200 mul, 183 add, 10 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = qd_1 * (c_2 * s_3 + s_2 * c_3);
  const Scalar t2 = c_4 * t1;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t3 = s_4 * omega_3_z;
  const Scalar t4 = t3 - t2;
  const Scalar t5 = qd_1 * (s_2 * s_3 - c_2 * c_3);
  const Scalar omega_4_z = qd_4 - t5;
  const Scalar omega_r_5_y = s_5 * t4 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t6 = omega_6_z * omega_6_z;
  const Scalar t7 = s_4 * t1;
  const Scalar t8 = c_4 * omega_3_z;
  const Scalar omega_r_5_a_z = t7 + t8;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t9 = omega_5_z * omega_5_z;
  const Scalar t10 = t9 + t6;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t4;
  const Scalar t11 = omega_r_5_x * omega_r_5_x;
  const Scalar t12 = t11 + t9;
  const Scalar I_6_xz = Scalar(0.000534) * c_6 + Scalar(0.0009944) * s_6;
  const Scalar t13 = t4 * omega_r_5_a_z;
  const Scalar t14 = omega_3_z * t1;
  const Scalar U_4_xy = t13 + t14;
  const Scalar t15 = (t7 + Scalar(2.0) * t8) * t5;
  const Scalar t16 = t15 + Scalar(2.0) * omega_r_5_a_z * omega_4_z;
  const Scalar t17 = s_5 * U_4_xy + c_5 * t16;
  const Scalar t18 = Scalar(2.0) * omega_5_z;
  const Scalar t19 = t17 - omega_r_5_y * t18;
  const Scalar t20 = t19 + t18 * omega_6_z;
  const Scalar I_t6_g = Scalar(0.0002546) * c_6 - Scalar(0.000512) * s_6;
  const Scalar I_6_xy = s_6 * I_t6_g + Scalar(0.000256);
  const Scalar t21 = s_2 * qd_1;
  const Scalar t22 = t21 * t21;
  const Scalar t23 = qd_2 * qd_2;
  const Scalar t24 = qd_1 * qd_1;
  const Scalar t25 = t23 - t22 + t24;
  const Scalar ddp_o_3_x = Scalar(21.8) * s_2 - t25;
  const Scalar t26 = c_2 * qd_1;
  const Scalar t27 = t21 * t26;
  const Scalar ddp_o_3_y = t27 + Scalar(21.8) * c_2;
  const Scalar ddp_3_x = s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar t28 = t1 * t5;
  const Scalar ddp_o_4_x = ddp_3_x - t28;
  const Scalar t29 = omega_3_z * t5;
  const Scalar t30 = qd_2 * t21;
  const Scalar t31 = Scalar(2.0) * t29 - Scalar(2.0) * t30;
  const Scalar t32 = s_4 * t31 + c_4 * ddp_o_4_x;
  const Scalar t33 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t34 = t1 * t1;
  const Scalar t35 = omega_3_z * omega_3_z;
  const Scalar t36 = t34 + t35;
  const Scalar t37 = t36 + t33;
  const Scalar t38 = s_5 * t32 + c_5 * t37;
  const Scalar t39 = Scalar(0.00315) * c_6 + Scalar(0.00504) * s_6;
  const Scalar t40 = t39 - Scalar(0.009135);
  const Scalar t41 = s_5 * t37 - c_5 * t32;
  const Scalar t42 = omega_r_5_x * omega_r_5_y;
  const Scalar t43 = t4 * omega_4_z;
  const Scalar t44 = (Scalar(2.0) * t3 - t2) * t5;
  const Scalar t45 = t43 + t44;
  const Scalar t46 = t42 + t45;
  const Scalar t47 = t46 - Scalar(2.0) * omega_r_5_x * omega_6_z;
  const Scalar t48 = c_6 * I_t6_g;
  const Scalar t49 = t48 - Scalar(0.0007896);
  const Scalar t50 = t4 * t4;
  const Scalar t51 = omega_4_z * omega_4_z;
  const Scalar Uz_o_5_y = t51 + t50;
  const Scalar t52 = Uz_o_5_y - t11 + t9;
  const Scalar t53 = s_5 * t16 - c_5 * U_4_xy;
  const Scalar t54 = Scalar(0.0009944) * c_6 - Scalar(0.000534) * s_6;
  const Scalar t55 = t45 - t42;
  const Scalar n_5 = Scalar(0.0007639) * t17 + I_6_xz * (t12 - t10) + t20 * I_6_xy -
      Scalar(0.0029421) * t55 - Scalar(0.0010857) * (t52 - t12) + t47 * t49 +
      t53 * (t54 + Scalar(0.0016163)) + t38 * t40 - Scalar(0.0123285) * t46 +
      Scalar(0.014265) * t41;
  n[4] = n_5;
  const Scalar t56 = t11 + t6;
  const Scalar mr_6_y = Scalar(0.00504) * c_6 - Scalar(0.00315) * s_6;
  const Scalar t57 = t53 - omega_r_5_x * t18;
  const Scalar I_6_xx = t48 + Scalar(0.000535);
  const Scalar ddp_5_a_z = s_4 * ddp_o_4_x - c_4 * t31;
  const Scalar t58 = I_6_xy * (t10 - t56) - t53 * I_6_xx + t19 * I_6_xz + t46 * t54 + t57 * t49 -
      mr_6_y * t41 - t39 * ddp_5_a_z;
  n[5] = -t58;
  const Scalar t59 = Scalar(0.0016163) * t46 - Scalar(0.0007639) * (Uz_o_5_y - t52) +
      Scalar(0.0010857) * t19 - Scalar(0.0029421) * t57 + Scalar(0.009135) * ddp_5_a_z + t58;
  const Scalar U_6_yy_zz = t12 - t56;
  const Scalar U_5_yy_zz = Uz_o_5_y - t12;
  const Scalar mu_5_x = t47 * I_6_xy + Scalar(0.0007639) * t55 - t54 * U_6_yy_zz +
      Scalar(0.0016163) * U_5_yy_zz - t20 * I_6_xx + t57 * (I_6_xz + Scalar(0.0010857)) -
      mr_6_y * t38 + Scalar(0.014265) * ddp_5_a_z - Scalar(0.0123285) * t19;
  const Scalar t60 = t51 - t50 + t36;
  const Scalar t61 = t13 - t14;
  const Scalar mu_4_z = Scalar(0.0009736) * (t60 - Uz_o_5_y) + Scalar(0.0123968) * t61 +
      Scalar(0.0110896) * t15 - c_5 * t59 - Scalar(0.0316473) * U_4_xy + s_5 * mu_5_x +
      Scalar(0.0523608) * t44 - Scalar(0.096525) * t32 + Scalar(0.05238) * ddp_5_a_z;
  n[3] = mu_4_z;
  const Scalar t62 = Scalar(0.009135) * t55 + mr_6_y * t20 - t39 * t47 + Scalar(0.014265) * t12;
  const Scalar t63 = mr_6_y * t53 - t39 * t10 + Scalar(0.009135) * t52 - Scalar(0.014265) * t46;
  const Scalar f_4_x = s_5 * t62 - c_5 * t63 + Scalar(0.05238) * t60 + Scalar(0.096525) * U_4_xy;
  const Scalar t64 = mr_6_y * t56 + t57 * t40 + Scalar(0.05238) * t61 - Scalar(0.014265) * t19 +
      Scalar(0.096525) * Uz_o_5_y;
  const Scalar f_u_4_t_x = s_4 * t64 + c_4 * f_4_x;
  const Scalar t65 = t43 + t45;
  const Scalar U_4_yy_zz = t36 - Uz_o_5_y;
  const Scalar t66 = Scalar(0.0009736) * t65 + Scalar(0.0110896) * t61 - s_5 * t59 - c_5 * mu_5_x +
      Scalar(0.0316473) * t16 - Scalar(0.0523608) * U_4_yy_zz + Scalar(0.096525) * t37;
  const Scalar t67 = n_5 - Scalar(0.0009736) * t16 - Scalar(0.0123968) * t65 -
      Scalar(0.0110896) * (t36 - t60) + Scalar(0.0523608) * U_4_xy + Scalar(0.05238) * t37;
  const Scalar t68 = t24 - t34 + t35;
  const Scalar t69 = Scalar(0.026176) * (t68 - t36) + f_u_4_t_x - c_4 * t67 +
      Scalar(0.123525) * t33 - s_4 * t66 - Scalar(1.8912169) * t28 + Scalar(1.72386) * ddp_3_x;
  n[2] = -t69;
  const Scalar t70 = s_3 * (Scalar(0.123525) * t68 - f_u_4_t_x + Scalar(1.72386) * t28);
  const Scalar t71 = s_5 * t63 + c_5 * t62 + Scalar(0.123525) * t28 - Scalar(0.05238) * t65 +
      Scalar(0.096525) * t16 + Scalar(1.72386) * t36;
  const Scalar t72 = t22 + t23;
  n[1] = Scalar(4.102542) * s_2 - Scalar(0.0684948) * (t25 - t72) - t70 - c_3 * t71 +
      Scalar(8.4002222) * t27 - t69 + Scalar(194.232114) * c_2;
  const Scalar f_u_4_t_y = s_4 * f_4_x - c_4 * t64;
  const Scalar U_3_yy_zz = t24 - t36;
  const Scalar t73 = Scalar(0.016137) * t28 + Scalar(0.052352) * t14 +
      Scalar(0.0408384) * U_3_yy_zz + f_u_4_t_y - s_4 * t67 + c_4 * t66 - Scalar(3.44772) * t30 +
      Scalar(3.9306688) * t29;
  const Scalar t74 = Scalar(0.0408384) * t28 + Scalar(0.052352) * t29 +
      Scalar(0.016137) * (t24 - t68) + Scalar(0.148235) * t14 + Scalar(0.24705) * t30 - mu_4_z;
  const Scalar U_2_yy_zz = t24 - t72;
  const Scalar t75 = qd_2 * t26;
  const Scalar t76 = Scalar(0.1098692) * t27 + Scalar(0.1369896) * t30 -
      Scalar(0.0444376) * U_2_yy_zz - Scalar(0.1542188) * t75 - s_3 * t74 + c_3 * t73;
  const Scalar t77 = Scalar(0.0444376) * t27 - Scalar(0.1369896) * t75 -
      Scalar(0.1098692) * (t24 - t25) - f_u_4_t_y + Scalar(0.24705) * t14 + c_3 * t74 -
      Scalar(3.44772) * t29 + s_3 * t73 + Scalar(16.9546632) * t30;
  n[0] = -s_2 * t76 - c_2 * t77;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   tau[6]  in   joint torques or forces, N m or N
//   qdd[6]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[1..5], qd[0..5], tau[0..5]. Operations: 370 mul, 303 add, 5 div, 10 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd,
    const SinCos& sin_cos = {}) noexcept {
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
  const Scalar t2 = c_5 * Iu_5_t_d - Scalar(2.0) * s_5 * Ic_5_xy;
  const Scalar t3 = c_5 * t2;
  const Scalar t4 = t3 - Scalar(0.0088514);
  const Scalar mu_u_5_5_a_y = t1 - Scalar(0.0160602);
  const Scalar t5 = mu_u_5_5_a_y + Scalar(0.0323686);
  const Scalar Iu_6_t_xy = s_6 * Iu_6_t_g + Scalar(0.000256);
  const Scalar t6 = Iu_6_t_xy + Scalar(0.0007639);
  const Scalar Iu_6_a_xy = Scalar(0.0009944) * c_6 - Scalar(0.000534) * s_6;
  const Scalar Ic_5_yz = Iu_6_a_xy + Scalar(0.0016163);
  const Scalar Iu_5_a_xz = c_5 * t6 + s_5 * Ic_5_yz;
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0009736);
  const Scalar t7 = c_4 * (t4 + t5) - Scalar(2.0) * s_4 * Ic_4_xy;
  const Scalar t8 = c_4 * t7;
  const Scalar t9 = t5 - t8;
  const Scalar f_u_6_6_a_z = Scalar(0.00315) * c_6 + Scalar(0.00504) * s_6;
  const Scalar t10 = f_u_6_6_a_z - Scalar(0.009135);
  const Scalar hu_5_t_y = Scalar(0.014265) * c_5 - s_5 * t10;
  const Scalar t11 = Scalar(2.0) * hu_5_t_y;
  const Scalar t12 = t9 - t11;
  const Scalar Iu_5_t_yy = Iu_6_t_xx - t3;
  const Scalar Ic_4_zz = Iu_5_t_yy + Scalar(0.0571622);
  const Scalar Ic_3_yy = Ic_4_zz - Scalar(1.9359823);
  const Scalar Iu_5_t_xy = Ic_5_xy + s_5 * t2;
  const Scalar Ic_4_xz = Iu_5_t_xy - Scalar(0.0110896);
  const Scalar t13 = c_5 * Ic_5_yz - s_5 * t6;
  const Scalar t14 = t13 - Scalar(0.0523608);
  const Scalar t15 = c_4 * Ic_4_xz + s_4 * t14;
  const Scalar t16 = c_5 * t10 + Scalar(0.014265) * s_5;
  const Scalar t17 = t16 + Scalar(0.05238);
  const Scalar hu_6_t_y = Scalar(0.00504) * c_6 - Scalar(0.00315) * s_6;
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.096525);
  const Scalar f_u_4_4_a_z = c_4 * t17 + s_4 * hc_4_y;
  const Scalar mu_4_3_x = t15 + f_u_4_4_a_z;
  const Scalar Ic_3_xy = Scalar(0.026176) + mu_4_3_x;
  const Scalar t18 = Scalar(2.0) * s_3 * Ic_3_xy + c_3 * (t12 + Ic_3_yy);
  const Scalar t19 = c_3 * t18;
  const Scalar Iu_3_t_xx = Ic_3_yy - t19;
  const Scalar Iu_3_d = (t12 - t19) + Iu_3_t_xx;
  const Scalar t20 = t4 - t8;
  const Scalar t21 = t20 + t11 + Scalar(2.0842173);
  const Scalar t22 = f_u_4_4_a_z - Scalar(0.123525);
  const Scalar hc_3_y = hu_5_t_y + Scalar(1.72386);
  const Scalar t23 = c_3 * t22 + s_3 * hc_3_y;
  const Scalar t24 = Scalar(2.0) * t23;
  const Scalar Iu_3_t_xy = Ic_3_xy - s_3 * t18;
  const Scalar t25 = c_3 * hc_3_y - s_3 * t22;
  const Scalar t26 = t25 - Iu_3_t_xy;
  const Scalar t27 = qd_1 * (s_2 * (t24 - (t21 - Iu_3_d)) - Scalar(2.0) * c_2 * t26);
  const Scalar Iu_4_t_xy = Ic_4_xy + s_4 * t7;
  const Scalar t28 = Iu_4_t_xy - Scalar(0.016137);
  const Scalar t29 = c_4 * t14 - s_4 * Ic_4_xz;
  const Scalar t30 = c_4 * hc_4_y - s_4 * t17;
  const Scalar t31 = t29 + t30;
  const Scalar t32 = t31 - Scalar(0.0408384);
  const Scalar t33 = c_3 * t28 + s_3 * t32;
  const Scalar beta_3_f = qd_3 + Scalar(2.0) * qd_2;
  const Scalar t34 = qd_3 * (t27 - t33 * beta_3_f);
  const Scalar t35 = t20 + t9;
  const Scalar Iu_4_y = Ic_4_zz - t35;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t36 = qd_1 * (c_2 * c_3 - s_2 * s_3);
  const Scalar beta_4_f = qd_4 + Scalar(2.0) * t36;
  const Scalar t37 = qd_1 * (s_2 * c_3 + c_2 * s_3);
  const Scalar t38 = qd_4 * ((t29 * beta_4_f - omega_3_z * Iu_4_y) - Scalar(2.0) * Iu_4_t_xy * t37);
  const Scalar t39 = t4 - Iu_5_t_yy;
  const Scalar omega_4_z = qd_4 + t36;
  const Scalar t40 = s_4 * t37;
  const Scalar omega_r_5_a_z = t40 + c_4 * omega_3_z;
  const Scalar t41 = Scalar(2.0) * omega_r_5_a_z;
  const Scalar beta_5_f = qd_5 + t41;
  const Scalar t42 = Scalar(2.0) * Iu_5_t_xy;
  const Scalar t43 = c_4 * t37;
  const Scalar t44 = t43 - s_4 * omega_3_z;
  const Scalar t45 = qd_5 * (t44 * t42 + (t13 * beta_5_f + omega_4_z * (mu_u_5_5_a_y - t39)));
  const Scalar omega_r_5_y = c_5 * omega_4_z - s_5 * t44;
  const Scalar t46 = Scalar(2.0) * omega_r_5_y;
  const Scalar beta_6_f = qd_6 + t46;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar Iu_6_d = t1 + Iu_6_t_xx;
  const Scalar Iu_6_y = Iu_6_d + Scalar(0.0013246);
  const Scalar omega_r_5_x = c_5 * t44 + s_5 * omega_4_z;
  const Scalar t47 = Scalar(2.0) * Iu_6_t_xy;
  const Scalar t48 = (Iu_6_a_xy * beta_6_f - omega_5_z * Iu_6_y) - omega_r_5_x * t47;
  const Scalar t49 = c_5 * qd_6;
  const Scalar t50 = t45 - t48 * t49;
  const Scalar t51 = f_u_6_6_a_z * beta_6_f;
  const Scalar t52 = Scalar(2.0) * (f_u_6_6_a_z * omega_r_5_x + hu_6_t_y * omega_5_z);
  const Scalar t53 = s_5 * qd_6;
  const Scalar t54 = qd_5 * beta_5_f;
  const Scalar f_a_5_x = t51 * t49 + t52 * t53 + t16 * t54;
  const Scalar t55 = qd_5 * (t16 * t44 - hu_5_t_y * omega_4_z);
  const Scalar t56 = Scalar(2.0) * t55 - hu_6_t_y * qd_6 * beta_6_f;
  const Scalar t57 = qd_4 * beta_4_f;
  const Scalar t58 = s_4 * f_a_5_x + c_4 * t56 - t30 * t57;
  const Scalar t59 = qd_6 * ((Iu_6_t_xz * beta_6_f + omega_r_5_x * (Iu_6_d - Scalar(0.0013246))) -
      omega_5_z * t47);
  const Scalar t60 = s_4 * t59 + c_4 * t50 + t58 - t38;
  const Scalar t61 = qd_5 * ((Iu_5_a_xz * beta_5_f - t44 * (t39 + mu_u_5_5_a_y)) - omega_4_z * t42);
  const Scalar t62 = t61 - t48 * t53;
  const Scalar t63 = c_2 * (t58 - c_3 * t62 - s_3 * t60 + t34);
  const Scalar Iu_2_t_d = Iu_3_d + t24 - Scalar(8.4002222);
  const Scalar t64 = t26 - Scalar(0.0684948);
  const Scalar t65 = Scalar(2.0) * s_2;
  const Scalar t66 = t64 * t65 + c_2 * Iu_2_t_d;
  const Scalar t67 = t64 - s_2 * t66;
  const Scalar t68 = t30 - t33 - Scalar(0.1098692);
  const Scalar t69 = c_3 * t32 - s_3 * t28;
  const Scalar t70 = Scalar(0.0444376) + t69;
  const Scalar Iu_2_t_xz = c_2 * t68 - s_2 * t70;
  const Scalar t71 = qd_2 * (Scalar(2.0) * t67 * qd_1 - Iu_2_t_xz * qd_2);
  const Scalar t72 = t69 * beta_3_f + qd_1 * (Iu_3_t_xy * t65 - c_2 * (t21 + Iu_3_d));
  const Scalar t73 = s_2 * (c_3 * t60 - s_3 * t62 + qd_3 * t72);
  const Scalar t74 = qd_1 * qd_1;
  const Scalar t75 = s_2 * t74;
  const Scalar Iu_4_x = Ic_4_zz + t35;
  const Scalar t76 = Scalar(2.0) * omega_3_z;
  const Scalar t77 = qd_4 * ((t15 * beta_4_f - t37 * Iu_4_x) - Iu_4_t_xy * t76);
  const Scalar f_a_4_x = c_4 * f_a_5_x - s_4 * t56 + f_u_4_4_a_z * t57;
  const Scalar t78 = c_4 * t59 - s_4 * t50 + t77 + f_a_4_x;
  const Scalar t79 = s_2 * t75;
  const Scalar t80 = qd_2 * qd_2;
  const Scalar t81 = t74 - t79 + t80;
  const Scalar t82 = Iu_3_t_xy * (t79 + t80 - t81);
  const Scalar t83 = omega_3_z * t37;
  const Scalar ddp_o_3_x = Scalar(21.8) * s_2 - t81;
  const Scalar t84 = c_2 * (t75 + Scalar(21.8));
  const Scalar t85 = t37 * t36 + c_3 * ddp_o_3_x + s_3 * t84;
  const Scalar t86 = t65 * qd_1 * qd_2 + t36 * t76;
  const Scalar ddp_4_x = c_4 * t85 - s_4 * t86;
  const Scalar t87 = t37 * t37;
  const Scalar t88 = omega_3_z * omega_3_z;
  const Scalar t89 = s_3 * ddp_o_3_x - c_3 * t84 + (t87 + t88);
  const Scalar t90 = hu_6_t_y * (c_5 * ddp_4_x - s_5 * t89);
  const Scalar t91 = t36 * (t40 + c_4 * t76) - omega_4_z * t41;
  const Scalar U_4_xy = t83 - t44 * omega_r_5_a_z;
  const Scalar U_5_zy = c_5 * t91 - s_5 * U_4_xy + omega_5_z * t46;
  const Scalar t92 = omega_r_5_x * omega_5_z;
  const Scalar t93 = c_5 * U_4_xy + t92 + s_5 * t91;
  const Scalar t94 = Iu_6_t_xy * (omega_r_5_x * omega_r_5_x - omega_5_z * omega_5_z);
  const Scalar t95 = t44 * omega_4_z;
  const Scalar domega_4_y = t36 * (t43 - s_4 * t76) - t95;
  const Scalar U_5_xy = omega_r_5_x * omega_r_5_y + domega_4_y;
  const Scalar t96 = f_u_6_6_a_z * (c_4 * t86 + s_4 * t85);
  const Scalar y_6 = -t92 * Iu_6_d - t94 - Iu_6_t_xz * U_5_zy + Iu_6_a_xy * U_5_xy +
      Scalar(0.0013246) * t93 - t96 + t90 + tau_6;
  const Scalar t97 = Scalar(754.9448890231013) * Iu_6_a_xy;
  const Scalar t98 = Iu_5_t_xy * (t44 * t44 - omega_4_z * omega_4_z);
  const Scalar t99 = t59 + t13 * U_4_xy + Iu_5_a_xz * t91 - t98 + hu_5_t_y * ddp_4_x + t95 * t39 -
      mu_u_5_5_a_y * domega_4_y - t16 * t89 - t97 * y_6 + tau_5;
  const Scalar mu_u_6_5_t_y = Scalar(0.0013246) * c_5 + s_5 * Iu_6_t_xz;
  const Scalar t100 = t13 - mu_u_6_5_t_y * t97;
  const Scalar t101 = Iu_6_a_xy * t97 + mu_u_5_5_a_y;
  const Scalar t102 = Scalar(1.0) / t101;
  const Scalar t103 = t100 * t102;
  const Scalar t104 = t36 * (t15 * t76 - t29 * t37);
  const Scalar t105 = Scalar(754.9448890231013) * mu_u_6_5_t_y;
  const Scalar y_5_4 = t62 - Iu_4_t_xy * (t87 - t88) - t104 + t83 * Iu_4_x - f_u_4_4_a_z * t86 +
      t30 * t85 + t103 * t99 + tau_4 - t105 * y_6;
  const Scalar t106 = mu_u_5_5_a_y - hu_5_t_y;
  const Scalar t107 = c_4 * t106 - s_4 * Iu_5_a_xz;
  const Scalar t108 = c_5 * hu_6_t_y;
  const Scalar t109 = c_4 * t108 - s_4 * f_u_6_6_a_z;
  const Scalar t110 = Scalar(0.0013246) * s_5 - c_5 * Iu_6_t_xz;
  const Scalar t111 = c_4 * Iu_6_a_xy + s_4 * t110 + t109;
  const Scalar t112 = t111 * t97 + t107;
  const Scalar t113 = -t112 * t103 - t111 * t105 + t31;
  const Scalar b_5_4_4 = t100 * t103 - mu_u_6_5_t_y * t105 + Ic_4_zz;
  const Scalar d_4 = Scalar(1.0) / b_5_4_4;
  const Scalar t114 = t113 * d_4;
  const Scalar t115 = t112 * t102;
  const Scalar t116 = Scalar(-754.9448890231013) * t111;
  const Scalar y_4_3 = t78 + tau_3 + c_2 * Iu_3_d * t75 - t115 * t99 + t23 * t84 + t25 * ddp_o_3_x -
      t82 + t116 * y_6 - t114 * y_5_4;
  const Scalar b_4_3_3 = t111 * t116 + t112 * t115 - t113 * t114 + t21;
  const Scalar t117 = Scalar(1.0) / b_4_3_3;
  const Scalar t118 = t111 - c_3 * s_5 * hu_6_t_y - s_3 * t109;
  const Scalar t119 = t118 * t97 + s_3 * c_4 * hu_5_t_y + t107 + c_3 * t16;
  const Scalar t120 = -t119 * t103 - t118 * t105 - s_3 * t30 + t31;
  const Scalar t121 = t118 * t116 + t119 * t115 - t120 * t114 - t23 + t21;
  const Scalar t122 = t121 * t117;
  const Scalar t123 = t120 * d_4;
  const Scalar t124 = t119 * t102;
  const Scalar t125 = s_2 * (t25 - Scalar(0.18819)) + c_2 * (t23 - Scalar(8.90973));
  const Scalar t126 = qd_4 * (f_u_4_4_a_z * t37 + t30 * omega_3_z);
  const Scalar t127 = t49 * t52 - t51 * t53 + hu_5_t_y * t54 + Scalar(2.0) * t126;
  const Scalar t128 = Scalar(-754.9448890231013) * t118;
  const Scalar t129 = t78 - s_3 * f_a_4_x + c_3 * t127 + tau_2 - t124 * t99 +
      t25 * qd_3 * beta_3_f - t123 * y_5_4 - t67 * t74 + t128 * y_6 - t122 * y_4_3 +
      Scalar(21.8) * t125;
  const Scalar b_3_2_2 = t118 * t128 + t119 * t124 - t120 * t123 + t21 - t24 - t121 * t122 +
      Scalar(8.554441);
  const Scalar t130 = Scalar(1.0) / b_3_2_2;
  const Scalar t131 = c_2 * (-c_3 * Ic_4_zz - s_3 * mu_4_3_x + f_u_4_4_a_z);
  const Scalar t132 = s_2 * (c_3 * mu_4_3_x - s_3 * Ic_4_zz);
  const Scalar t133 = c_4 * Iu_5_a_xz + s_4 * t106;
  const Scalar t134 = c_2 * (c_3 * t13 - s_3 * t133 - s_4 * hu_5_t_y);
  const Scalar f_u_6_4_a_z = c_4 * f_u_6_6_a_z + s_4 * t108;
  const Scalar mu_6_3_x = s_4 * Iu_6_a_xy - c_4 * t110 + f_u_6_4_a_z;
  const Scalar t135 = c_2 * (f_u_6_4_a_z - c_3 * mu_u_6_5_t_y - s_3 * mu_6_3_x);
  const Scalar t136 = t135 - s_2 * (c_3 * mu_6_3_x - s_3 * mu_u_6_5_t_y);
  const Scalar t137 = t136 * t97 - s_2 * (s_3 * t13 + c_3 * t133) + t134;
  const Scalar t138 = -t137 * t103 - t136 * t105 - t132 + t131;
  const Scalar t139 = -t136 * t116 - t137 * t115 + c_2 * t69 - s_2 * t33 + t138 * t114;
  const Scalar b_3_2_1 = -t136 * t128 - t137 * t124 + c_2 * t70 + s_2 * t68 + t138 * t123 -
      t139 * t122;
  const Scalar t140 = b_3_2_1 * t130;
  const Scalar t141 = t139 * t117;
  const Scalar t142 = t138 * d_4;
  const Scalar t143 = t137 * t102;
  const Scalar t144 = Scalar(754.9448890231013) * t136;
  const Scalar y_2_1 = -t141 * y_4_3 - t140 * t129 + tau_1 + t143 * t99 - t63 + t73 + t144 * y_6 +
      t142 * y_5_4 + t71;
  const Scalar b_2_1_1 = t137 * t143 - b_3_2_1 * t140 - t136 * t144 - t139 * t141 - t138 * t142 +
      Iu_3_t_xx + Scalar(2.8931568) - c_2 * t66;
  const Scalar d_1 = Scalar(1.0) / b_2_1_1;
  const Scalar qdd_1 = d_1 * y_2_1;
  qdd[0] = qdd_1;
  const Scalar qdd_2 = t130 * (t129 - b_3_2_1 * qdd_1);
  qdd[1] = qdd_2;
  const Scalar qdd_3 = t117 * (y_4_3 - (t139 * qdd_1 + t121 * qdd_2));
  qdd[2] = qdd_3;
  const Scalar qdd_4 = d_4 * ((y_5_4 - t113 * qdd_3) - (t120 * qdd_2 - t138 * qdd_1));
  qdd[3] = qdd_4;
  const Scalar t145 = (t119 * qdd_2 - t137 * qdd_1) + t99;
  const Scalar t146 = t102 * (t145 - (t100 * qdd_4 - t112 * qdd_3));
  qdd[4] = -t146;
  const Scalar t147 = (t111 * qdd_3 + t118 * qdd_2) - (t136 * qdd_1 + y_6);
  qdd[5] = Scalar(-754.9448890231013) * (t147 - (Iu_6_a_xy * t146 - mu_u_6_5_t_y * qdd_4));
  bool positive = b_2_1_1 > Scalar(0.0);
  positive &= b_3_2_2 > Scalar(0.0);
  positive &= b_4_3_3 > Scalar(0.0);
  positive &= b_5_4_4 > Scalar(0.0);
  positive &= -t101 > Scalar(0.0);
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
  const Scalar t9 = t8 - qd_4;
  const Scalar t10 = s_5 * t9 + c_5 * t7;
  const Scalar omega_r_5_a_z = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar omega_5_z = omega_r_5_a_z + qd_5;
  const Scalar t11 = s_6 * omega_5_z + c_6 * t10;
  const Scalar t12 = s_6 * t10 - c_6 * omega_5_z;
  const Scalar omega_r_5_y = s_5 * t7 - c_5 * t9;
  const Scalar omega_6_z = omega_r_5_y + qd_6;
  const Scalar t13 = Scalar(0.000534) * t11 + Scalar(0.0009944) * t12 -
      Scalar(0.0013246) * omega_6_z - Scalar(0.0063) * t6 + Scalar(0.01008) * v_r_6_x;
  const Scalar t14 = s_5 * v_r_4_x - c_5 * t5;
  const Scalar t15 = t12 * (Scalar(0.000256) * t11 + Scalar(0.0009944) * omega_6_z +
      Scalar(0.0063) * t14);
  const Scalar t16 = Scalar(0.0002546) * t11 - Scalar(0.000256) * t12 -
      Scalar(0.000534) * omega_6_z + Scalar(0.01008) * t14;
  const Scalar t17 = Scalar(0.0007639) * t10 + Scalar(0.0016163) * omega_r_5_y -
      Scalar(0.01827) * t14 - Scalar(0.02853) * v_r_5_x + Scalar(0.0158056) * omega_5_z;
  const Scalar L_5_y = Scalar(0.0016163) * omega_5_z - Scalar(0.0010857) * t10 +
      Scalar(0.01827) * v_r_4_y;
  const Scalar t18 = Scalar(0.0007639) * omega_5_z - Scalar(0.0010857) * omega_r_5_y +
      Scalar(0.0099214) * t10 + Scalar(0.02853) * v_r_4_y;
  const Scalar t19 = Scalar(0.0110896) * t7 - Scalar(0.0523608) * omega_r_5_a_z -
      Scalar(0.0469862) * t9 - Scalar(0.10476) * v_r_4_y - Scalar(0.19305) * v_r_4_x;
  const Scalar L_4_y = Scalar(0.0009736) * t7 + Scalar(0.10476) * t5 - Scalar(0.0523608) * t9;
  const Scalar L_4_x = Scalar(0.0009736) * omega_r_5_a_z + Scalar(0.0110896) * t9 -
      Scalar(0.0221926) * t7 + Scalar(0.19305) * t5;
  const Scalar L_3_z = Scalar(0.016137) * omega_r_3_x + Scalar(0.0408384) * t8 +
      Scalar(0.24705) * t5 - Scalar(3.44772) * t3 + Scalar(2.0518487) * omega_3_z;
  const Scalar L_3_y = Scalar(0.026176) * omega_r_3_x - Scalar(0.0408384) * omega_3_z +
      Scalar(0.24705) * t1;
  const Scalar t20 = Scalar(0.026176) * t8 - Scalar(0.016137) * omega_3_z -
      Scalar(1.9036137) * omega_r_3_x + Scalar(3.44772) * t1;
  const Scalar L_2_y = Scalar(0.0444376) * qd_2 + Scalar(0.0684948) * t2;
  const Scalar t21 = t2 * (Scalar(0.1098692) * qd_2 - Scalar(0.0684948) * t1 +
      Scalar(8.4002222) * t2);
  const Scalar L_2_z = Scalar(0.0444376) * t1 - Scalar(0.1098692) * t2 + Scalar(8.554441) * qd_2;
  const Scalar t22 = t15 - t11 * t16 + omega_6_z * t13 - omega_r_5_y * L_5_y - t10 * t18 -
      t1 * L_2_y - omega_5_z * t17 + omega_r_5_a_z * L_4_y + t7 * L_4_x + t8 * L_3_y + t9 * t19 +
      omega_r_3_x * t20 - omega_3_z * L_3_z + t21 - qd_2 * L_2_z - Scalar(9.3573967) * qd_1 * qd_1;
  return Scalar(-0.5) * t22;
}

// Potential energy of links and rotors (7.36).
//   q[6]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[1..5]. Operations: 17 mul, 16 add, 10 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar potential_energy(const Scalar* q, const SinCos& sin_cos = {}) noexcept {
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
// Reads q[0..5], qd[0..5]. Operations: 118 mul, 64 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = s_2 * qd_1;
  const Scalar t3 = s_3 * t2;
  const Scalar t4 = c_3 * t1 - t3;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t5 = t4 * omega_3_z;
  const Scalar t6 = Scalar(-2.0) * t5;
  const Scalar t7 = c_3 * t2;
  const Scalar omega_r_3_x = t7 + s_3 * t1;
  const Scalar omega_r_5_a_z = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 + t4;
  const Scalar t8 = omega_r_3_x * t4;
  const Scalar t9 = c_4 * t6 - s_4 * t8 + Scalar(2.0) * omega_r_5_a_z * omega_4_z;
  const Scalar t10 = c_4 * omega_r_3_x - s_4 * omega_3_z;
  const Scalar U_4_xy = omega_r_3_x * omega_3_z - t10 * omega_r_5_a_z;
  const Scalar omega_r_5_y = c_5 * omega_4_z - s_5 * t10;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t11 = s_5 * U_4_xy + c_5 * t9 - Scalar(2.0) * omega_r_5_y * omega_5_z;
  const Scalar omega_r_5_x = c_5 * t10 + s_5 * omega_4_z;
  const Scalar U_5_xy = c_4 * t8 + s_4 * t6 - t10 * omega_4_z + omega_r_5_x * omega_r_5_y;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t12 = (c_6 * omega_5_z + s_6 * omega_r_5_x) * omega_6_z;
  const Scalar t13 = c_6 * t11 - s_6 * U_5_xy + t12;
  const Scalar t14 = (c_6 * omega_r_5_x - s_6 * omega_5_z) * omega_6_z;
  const Scalar domega_6_y = c_6 * U_5_xy + s_6 * t11 - t14;
  const Scalar t15 = c_6 * t13 + s_6 * domega_6_y;
  const Scalar t16 = c_5 * U_4_xy + omega_r_5_x * omega_5_z - s_5 * t9;
  const Scalar t17 = c_5 * t15 - s_5 * t16;
  const Scalar t18 = c_6 * domega_6_y - s_6 * t13;
  const Scalar t19 = c_4 * t17 + s_4 * t18;
  const Scalar t20 = c_5 * t16 + s_5 * t15;
  const Scalar t21 = c_3 * t20 + s_3 * t19;
  const Scalar t22 = c_3 * t19 - s_3 * t20;
  a[5] = -c_2 * t21 - s_2 * t22;
  const Scalar t23 = qd_1 * qd_1 - t2 * t2 + qd_2 * qd_2;
  const Scalar t24 = Scalar(-0.45) * (t1 * t3 + t8 - c_3 * t23);
  const Scalar t25 = Scalar(0.9) * t5 + Scalar(0.9) * qd_2 * t2;
  const Scalar t26 = c_4 * t24 + s_4 * t25;
  const Scalar t27 = -t7 * t1 - s_3 * t23 + (omega_r_3_x * omega_r_3_x + omega_3_z * omega_3_z);
  const Scalar t28 = Scalar(0.45) * t27;
  const Scalar t29 = c_5 * t26 + s_5 * t28;
  const Scalar t30 = c_4 * t25 - s_4 * t24;
  const Scalar t31 = c_6 * t29 + s_6 * t30;
  const Scalar t32 = c_6 * t30 - s_6 * t29;
  const Scalar t33 = c_6 * t31 - s_6 * t32;
  const Scalar t34 = c_5 * t28 - s_5 * t26;
  const Scalar t35 = c_5 * t33 - s_5 * t34;
  const Scalar t36 = c_6 * t32 + s_6 * t31;
  const Scalar t37 = c_4 * t35 - s_4 * t36;
  const Scalar t38 = c_5 * t34 + s_5 * t33;
  const Scalar t39 = c_3 * t38 + s_3 * t37;
  const Scalar t40 = c_3 * t37 - s_3 * t38;
  a[2] = -c_2 * t39 - s_2 * t40;
  const Scalar t41 = c_2 * t22 - s_2 * t21;
  const Scalar domega_e_4_t_y = c_4 * t18 - s_4 * t17;
  a[4] = c_1 * domega_e_4_t_y - s_1 * t41;
  a[3] = -c_1 * t41 - s_1 * domega_e_4_t_y;
  const Scalar t42 = c_2 * t40 - s_2 * t39;
  const Scalar t43 = c_4 * t36 + s_4 * t35;
  a[0] = s_1 * t43 - c_1 * t42;
  a[1] = -c_1 * t43 - s_1 * t42;
}

// Whether the build rounds every operation as it is written, to nearest: compilers fuse products
// into sums unless they are given -ffp-contract=off, and -ffast-math or x87 registers change more.
// What certificates say of rounding errors holds for builds in which this is true. It speaks of the
// file that calls it, for float and double.
template <class Scalar = Real>
static bool rounding_is_as_written() noexcept {
  const volatile Scalar a = Scalar(0.1), b = Scalar(0.7), one = Scalar(1.0), tiny = Scalar(1e-17),
      nine = Scalar(9.0), seven = Scalar(7.0), half = Scalar(0.5),
      smallest = sizeof(Scalar) == sizeof(float) ? Scalar(0x1p-126) : Scalar(0x1p-1022);
  const volatile Scalar product = a * b, quotient = nine / seven;
  const Scalar x = one, y = tiny;
  const auto is_zero = [](Scalar r) { return !(r < Scalar(0.0)) && !(r > Scalar(0.0)); };
  return is_zero(a * b - product)                   // no fused multiply-add, no digits too many
         && is_zero((x + y) - x)                    // no other order, no rounding upward
         && is_zero((x - y) - x)                    // or downward
         && is_zero(nine / Scalar(7.0) - quotient)  // no reciprocal
         && smallest * half > Scalar(0.0);          // nothing is flushed to zero
}

}  // namespace rx90

#endif  // FLATDYN_RX90_HPP

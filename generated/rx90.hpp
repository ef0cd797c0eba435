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
// Every function is a template over its scalar: float, double, or any type that has + - * / and
// sin, cos where argument-dependent lookup finds them. Arguments are plain arrays:
//
//   double q[6] = {}, qd[6] = {}, qdd[6] = {}, tau[6];
//   rx90::inverse_dynamics(q, qd, qdd, tau);
//
// Entries come in the order of the table. Units are SI; "rad or m" goes by the type of the joint.
// Every entry of an output is written, zeros too. All inputs are read before anything is written:
// an output may overlap an input, but outputs must not overlap each other. Nothing allocates,
// throws, or keeps state. In the code, names count from 1 as in the textbook: q_1 is q[0], s_1 its
// sine, c_1 its cosine, s_12 the sine of q_1 + q_2.

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

// tau = B(q) qdd + C(q, qd) qd + g(q) + friction (7.42).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5], qd[0..5], qdd[0..5]. Operations: 241 mul, 227 add, 10 sin/cos.
template <class Scalar>
inline void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    Scalar* tau) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar t1 = s_2 * qd_1;
  const Scalar t2 = c_2 * qd_1;
  const Scalar t3 = s_3 * t1 - c_3 * t2;
  const Scalar t4 = qd_2 * t1;
  const Scalar t5 = c_2 * qdd_1;
  const Scalar t6 = t4 - t5;
  const Scalar t7 = qd_2 * t2;
  const Scalar t8 = s_2 * qdd_1;
  const Scalar domega_2_x = t7 + t8;
  const Scalar t9 = qd_3 * t3 + s_3 * t6 - c_3 * domega_2_x;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t10 = t3 * omega_3_z;
  const Scalar t11 = t9 + t10;
  const Scalar U_2_zx = t4 + t6;
  const Scalar ddp_o_4_z = Scalar(0.45) * U_2_zx - Scalar(0.45) * t11;
  const Scalar t12 = t2 * t1;
  const Scalar U_2_yx = qdd_2 + t12;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 + Scalar(0.45) * U_2_yx;
  const Scalar t13 = t2 * t2;
  const Scalar t14 = qd_2 * qd_2;
  const Scalar U_2_xx = t14 + t13;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 - Scalar(0.45) * U_2_xx;
  const Scalar ddp_3_x = s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar omega_r_3_x = s_3 * t2 + c_3 * t1;
  const Scalar t15 = omega_r_3_x * t3;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar U_3_xy = domega_3_z + t15;
  const Scalar ddp_o_4_x = ddp_3_x - Scalar(0.45) * U_3_xy;
  const Scalar t16 = s_4 * ddp_o_4_z - c_4 * ddp_o_4_x;
  const Scalar t17 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t18 = omega_r_3_x * omega_r_3_x;
  const Scalar t19 = omega_3_z * omega_3_z;
  const Scalar U_3_yy = t19 + t18;
  const Scalar t20 = t17 + Scalar(0.45) * U_3_yy;
  const Scalar t21 = s_5 * t20 + c_5 * t16;
  const Scalar ddp_4_y = s_4 * ddp_o_4_x + c_4 * ddp_o_4_z;
  const Scalar t22 = s_6 * ddp_4_y + c_6 * t21;
  const Scalar t23 = s_6 * t21 - c_6 * ddp_4_y;
  const Scalar t24 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar omega_4_z = qd_4 - t3;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t24;
  const Scalar omega_r_4_y = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar t25 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar omega_r_5_y = s_5 * t24 + c_5 * omega_4_z;
  const Scalar t26 = qd_4 * omega_r_4_y + s_4 * domega_3_z + c_4 * t9;
  const Scalar t27 = qd_3 * omega_r_3_x + s_3 * domega_2_x + c_3 * t6;
  const Scalar domega_4_z = qdd_4 - t27;
  const Scalar domega_5_x = qd_5 * omega_r_5_y + s_5 * domega_4_z - c_5 * t26;
  const Scalar t28 = qd_4 * t24 + s_4 * t9 - c_4 * domega_3_z;
  const Scalar domega_5_z = qdd_5 - t28;
  const Scalar t29 = qd_6 * t25 - s_6 * domega_5_x - c_6 * domega_5_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t30 = t25 * omega_6_z;
  const Scalar omega_r_6_y = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t31 = qd_6 * omega_r_6_y + s_6 * domega_5_z - c_6 * domega_5_x;
  const Scalar t32 = omega_r_6_y * omega_6_z;
  const Scalar t33 = omega_r_6_y * omega_r_6_y;
  const Scalar t34 = omega_6_z * omega_6_z;
  const Scalar U_6_xx = t34 + t33;
  const Scalar t35 = t25 * t25;
  const Scalar U_6_yy = t34 + t35;
  const Scalar U_6_xx_yy = U_6_xx - U_6_yy;
  const Scalar t36 = qd_5 * omega_r_5_x - s_5 * t26 - c_5 * domega_4_z;
  const Scalar domega_6_z = qdd_6 - t36;
  const Scalar t37 = t25 * omega_r_6_y;
  const Scalar U_6_xy = domega_6_z - t37;
  const Scalar U_6_yx = domega_6_z + t37;
  const Scalar tau_6 = Scalar(0.0112) * t22 - Scalar(0.007) * t23 + Scalar(0.0007896) * U_6_xy -
      Scalar(0.0009944) * (t29 - t30) + Scalar(0.000535) * U_6_yx - Scalar(0.000534) * (t31 - t32) -
      Scalar(0.000256) * U_6_xx_yy;
  tau[5] = tau_6;
  const Scalar t38 = t29 + t30;
  const Scalar t39 = t31 + t32;
  const Scalar U_6_zz = t33 + t35;
  const Scalar U_6_yy_zz = U_6_yy - U_6_zz;
  const Scalar ddp_5_y = s_5 * t16 - c_5 * t20;
  const Scalar N_6_x = Scalar(0.0112) * ddp_5_y + Scalar(0.000534) * U_6_yx +
      Scalar(0.000256) * t38 - Scalar(0.0007896) * t39 + Scalar(0.0009944) * U_6_yy_zz;
  const Scalar U_6_zz_xx = U_6_xx - U_6_zz;
  const Scalar N_6_y = Scalar(0.007) * ddp_5_y - Scalar(0.0009944) * U_6_xy +
      Scalar(0.000535) * t38 - Scalar(0.000256) * t39 + Scalar(0.000534) * U_6_zz_xx;
  const Scalar t40 = omega_r_5_x * omega_5_z;
  const Scalar t41 = omega_r_5_y * omega_5_z;
  const Scalar U_5_yz = domega_5_x - t41;
  const Scalar t42 = omega_r_5_y * omega_r_5_y;
  const Scalar t43 = omega_5_z * omega_5_z;
  const Scalar U_5_xx = t43 + t42;
  const Scalar t44 = omega_r_5_x * omega_r_5_x;
  const Scalar U_5_yy = t43 + t44;
  const Scalar U_5_xx_yy = U_5_xx - U_5_yy;
  const Scalar t45 = omega_r_5_x * omega_r_5_y;
  const Scalar U_5_xy = domega_5_z - t45;
  const Scalar U_5_yx = domega_5_z + t45;
  const Scalar tau_5 = Scalar(0.0317) * t21 + Scalar(0.0203) * ddp_5_y +
      Scalar(0.0123285) * U_5_xy - Scalar(0.0016163) * (t36 - t40) + Scalar(0.0029421) * U_5_yx -
      Scalar(0.0007639) * U_5_yz - Scalar(0.0010857) * U_5_xx_yy - s_6 * N_6_x - c_6 * N_6_y;
  tau[4] = tau_5;
  const Scalar t46 = t36 + t40;
  const Scalar U_5_zy = domega_5_x + t41;
  const Scalar U_5_zz = t42 + t44;
  const Scalar U_5_yy_zz = U_5_yy - U_5_zz;
  const Scalar mu_5_x = Scalar(0.0317) * ddp_4_y - Scalar(0.0007639) * U_5_yx -
      Scalar(0.0010857) * t46 + Scalar(0.0123285) * U_5_zy - Scalar(0.0016163) * U_5_yy_zz -
      s_6 * N_6_y + c_6 * N_6_x;
  const Scalar U_5_zz_xx = U_5_xx - U_5_zz;
  const Scalar mu_5_y = Scalar(0.0203) * ddp_4_y - Scalar(0.0016163) * U_5_xy +
      Scalar(0.0029421) * t46 - Scalar(0.0010857) * U_5_zy + Scalar(0.0007639) * U_5_zz_xx - tau_6;
  const Scalar t47 = t24 * omega_4_z;
  const Scalar t48 = omega_r_4_y * omega_4_z;
  const Scalar t49 = omega_r_4_y * omega_r_4_y;
  const Scalar t50 = omega_4_z * omega_4_z;
  const Scalar U_4_xx = t50 + t49;
  const Scalar t51 = t24 * t24;
  const Scalar U_4_yy = t50 + t51;
  const Scalar U_4_xx_yy = U_4_xx - U_4_yy;
  const Scalar t52 = t24 * omega_r_4_y;
  const Scalar U_4_xy = domega_4_z - t52;
  const Scalar U_4_yx = domega_4_z + t52;
  const Scalar tau_4 = Scalar(0.2145) * t16 + Scalar(0.1164) * ddp_4_y +
      Scalar(0.0316473) * U_4_xy + Scalar(0.0523608) * (t28 - t47) + Scalar(0.0123968) * U_4_yx +
      Scalar(0.0110896) * (t26 - t48) + Scalar(0.0009736) * U_4_xx_yy + s_5 * mu_5_x - c_5 * mu_5_y;
  tau[3] = tau_4;
  const Scalar F_6_y = Scalar(0.007) * U_6_yx + Scalar(0.0112) * U_6_yy;
  const Scalar F_6_x = Scalar(0.007) * U_6_xx - Scalar(0.0112) * U_6_xy;
  const Scalar f_5_x = Scalar(0.0203) * U_5_xx + Scalar(0.0317) * U_5_xy - s_6 * F_6_y -
      c_6 * F_6_x;
  const Scalar f_5_y = Scalar(0.0203) * U_5_yx - Scalar(0.0317) * U_5_yy + Scalar(0.007) * t38 -
      Scalar(0.0112) * t39;
  const Scalar f_4_x = Scalar(0.1164) * U_4_xx - Scalar(0.2145) * U_4_xy - s_5 * f_5_y -
      c_5 * f_5_x;
  const Scalar f_4_y = Scalar(0.1164) * U_4_yx + Scalar(0.2145) * U_4_yy + Scalar(0.0203) * t46 +
      Scalar(0.0317) * U_5_zy - s_6 * F_6_x + c_6 * F_6_y;
  const Scalar f_u_4_t_x = s_4 * f_4_y + c_4 * f_4_x;
  const Scalar t53 = t28 + t47;
  const Scalar t54 = t26 + t48;
  const Scalar U_4_zz = t49 + t51;
  const Scalar U_4_yy_zz = U_4_yy - U_4_zz;
  const Scalar t55 = Scalar(0.2145) * t20 + Scalar(0.0110896) * U_4_yx + Scalar(0.0009736) * t53 +
      Scalar(0.0316473) * t54 + Scalar(0.0523608) * U_4_yy_zz - s_5 * mu_5_y - c_5 * mu_5_x;
  const Scalar U_4_zz_xx = U_4_xx - U_4_zz;
  const Scalar t56 = Scalar(0.1164) * t20 - Scalar(0.0523608) * U_4_xy - Scalar(0.0123968) * t53 -
      Scalar(0.0009736) * t54 + Scalar(0.0110896) * U_4_zz_xx + tau_5;
  const Scalar t57 = omega_r_3_x * omega_3_z;
  const Scalar t58 = t3 * t3;
  const Scalar U_3_xx = t19 + t58;
  const Scalar U_3_xx_yy = U_3_xx - U_3_yy;
  const Scalar U_3_yx = domega_3_z - t15;
  const Scalar mu_3_z = Scalar(3.8308) * ddp_3_x + Scalar(0.2745) * t17 -
      Scalar(1.9653344) * U_3_xy - Scalar(0.0408384) * (t27 - t57) - Scalar(0.0741175) * U_3_yx +
      Scalar(0.016137) * (t9 - t10) + Scalar(0.026176) * U_3_xx_yy + Scalar(0.45) * f_u_4_t_x -
      s_4 * t55 - c_4 * t56;
  tau[2] = -mu_3_z;
  const Scalar f_3_x = Scalar(0.2745) * U_3_xx + Scalar(3.8308) * U_3_xy - f_u_4_t_x;
  const Scalar f_3_y = Scalar(0.2745) * U_3_yx - Scalar(3.8308) * U_3_yy + Scalar(0.1164) * t53 -
      Scalar(0.2145) * t54 - s_5 * f_5_x + c_5 * f_5_y;
  const Scalar t59 = s_3 * f_3_x - c_3 * f_3_y;
  const Scalar t60 = t1 * t1;
  const Scalar U_2_yy = t14 + t60;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  const Scalar U_2_xy = qdd_2 - t12;
  tau[1] = Scalar(194.232114) * c_2 + Scalar(4.102542) * s_2 - Scalar(0.1098692) * t8 +
      Scalar(0.0444376) * t5 + Scalar(0.0771094) * U_2_xy + Scalar(8.4773316) * U_2_yx -
      Scalar(0.0684948) * U_2_xx_yy - mu_3_z - Scalar(0.45) * t59;
  const Scalar t61 = Scalar(-0.45) * (s_4 * f_4_x - c_4 * f_4_y);
  const Scalar t62 = t27 + t57;
  const Scalar U_3_zz = t58 + t18;
  const Scalar U_3_yy_zz = U_3_yy - U_3_zz;
  const Scalar mu_3_x = Scalar(1.72386) * U_2_zx + Scalar(0.016137) * U_3_yx -
      Scalar(0.026176) * t62 - Scalar(1.9653344) * t11 + Scalar(0.0408384) * U_3_yy_zz + s_4 * t56 -
      c_4 * t55 + t61;
  const Scalar U_3_zz_xx = U_3_xx - U_3_zz;
  const Scalar mu_3_y = Scalar(0.123525) * U_2_zx + Scalar(0.0408384) * U_3_xy +
      Scalar(0.0741175) * t62 + Scalar(0.026176) * t11 - Scalar(0.016137) * U_3_zz_xx - tau_4;
  const Scalar U_2_zy = t7 + domega_2_x;
  const Scalar U_2_zz = t13 + t60;
  const Scalar U_2_yy_zz = U_2_yy - U_2_zz;
  const Scalar mu_2_x = Scalar(0.1098692) * U_2_yx + Scalar(0.0684948) * U_2_zx -
      Scalar(0.0771094) * U_2_zy + Scalar(0.0444376) * U_2_yy_zz - s_3 * mu_3_y - c_3 * mu_3_x;
  const Scalar U_2_zz_xx = U_2_xx - U_2_zz;
  const Scalar mu_2_y = Scalar(0.0444376) * U_2_xy - Scalar(8.4773316) * U_2_zx +
      Scalar(0.0684948) * U_2_zy - Scalar(0.123525) * t62 + Scalar(1.72386) * t11 -
      Scalar(0.1098692) * U_2_zz_xx - t61 + s_3 * mu_3_x - c_3 * mu_3_y;
  tau[0] = Scalar(0.8059476) * qdd_1 - s_2 * mu_2_x + c_2 * mu_2_y;
}

// inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..5], qd[0..5], qdd[0..5], h_e[0..5]. Operations: 289 mul, 257 add, 12 sin/cos.
template <class Scalar>
inline void inverse_dynamics_tip_force(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    const Scalar* h_e, Scalar* tau) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5];
  const Scalar h_e_1 = h_e[0], h_e_2 = h_e[1], h_e_3 = h_e[2], h_e_4 = h_e[3], h_e_5 = h_e[4],
      h_e_6 = h_e[5];
  const Scalar s_1 = sin(q_1), c_1 = cos(q_1);
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar t1 = s_2 * qd_1;
  const Scalar t2 = c_2 * qd_1;
  const Scalar t3 = s_3 * t1 - c_3 * t2;
  const Scalar t4 = qd_2 * t1;
  const Scalar t5 = c_2 * qdd_1;
  const Scalar t6 = t4 - t5;
  const Scalar t7 = qd_2 * t2;
  const Scalar t8 = s_2 * qdd_1;
  const Scalar domega_2_x = t7 + t8;
  const Scalar t9 = qd_3 * t3 + s_3 * t6 - c_3 * domega_2_x;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t10 = t3 * omega_3_z;
  const Scalar t11 = t9 + t10;
  const Scalar U_2_zx = t4 + t6;
  const Scalar ddp_o_4_z = Scalar(0.45) * U_2_zx - Scalar(0.45) * t11;
  const Scalar t12 = t2 * t1;
  const Scalar U_2_yx = qdd_2 + t12;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 + Scalar(0.45) * U_2_yx;
  const Scalar t13 = t2 * t2;
  const Scalar t14 = qd_2 * qd_2;
  const Scalar U_2_xx = t14 + t13;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 - Scalar(0.45) * U_2_xx;
  const Scalar ddp_3_x = s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar omega_r_3_x = s_3 * t2 + c_3 * t1;
  const Scalar t15 = omega_r_3_x * t3;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar U_3_xy = domega_3_z + t15;
  const Scalar ddp_o_4_x = ddp_3_x - Scalar(0.45) * U_3_xy;
  const Scalar t16 = s_4 * ddp_o_4_z - c_4 * ddp_o_4_x;
  const Scalar t17 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t18 = omega_r_3_x * omega_r_3_x;
  const Scalar t19 = omega_3_z * omega_3_z;
  const Scalar U_3_yy = t19 + t18;
  const Scalar t20 = t17 + Scalar(0.45) * U_3_yy;
  const Scalar t21 = s_5 * t20 + c_5 * t16;
  const Scalar ddp_4_y = s_4 * ddp_o_4_x + c_4 * ddp_o_4_z;
  const Scalar t22 = s_6 * ddp_4_y + c_6 * t21;
  const Scalar t23 = s_6 * t21 - c_6 * ddp_4_y;
  const Scalar t24 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar omega_4_z = qd_4 - t3;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t24;
  const Scalar omega_r_4_y = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar t25 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar omega_r_5_y = s_5 * t24 + c_5 * omega_4_z;
  const Scalar t26 = qd_4 * omega_r_4_y + s_4 * domega_3_z + c_4 * t9;
  const Scalar t27 = qd_3 * omega_r_3_x + s_3 * domega_2_x + c_3 * t6;
  const Scalar domega_4_z = qdd_4 - t27;
  const Scalar domega_5_x = qd_5 * omega_r_5_y + s_5 * domega_4_z - c_5 * t26;
  const Scalar t28 = qd_4 * t24 + s_4 * t9 - c_4 * domega_3_z;
  const Scalar domega_5_z = qdd_5 - t28;
  const Scalar t29 = qd_6 * t25 - s_6 * domega_5_x - c_6 * domega_5_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t30 = t25 * omega_6_z;
  const Scalar omega_r_6_y = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t31 = qd_6 * omega_r_6_y + s_6 * domega_5_z - c_6 * domega_5_x;
  const Scalar t32 = omega_r_6_y * omega_6_z;
  const Scalar t33 = omega_r_6_y * omega_r_6_y;
  const Scalar t34 = omega_6_z * omega_6_z;
  const Scalar U_6_xx = t34 + t33;
  const Scalar t35 = t25 * t25;
  const Scalar U_6_yy = t34 + t35;
  const Scalar U_6_xx_yy = U_6_xx - U_6_yy;
  const Scalar t36 = qd_5 * omega_r_5_x - s_5 * t26 - c_5 * domega_4_z;
  const Scalar domega_6_z = qdd_6 - t36;
  const Scalar t37 = t25 * omega_r_6_y;
  const Scalar U_6_xy = domega_6_z - t37;
  const Scalar U_6_yx = domega_6_z + t37;
  const Scalar mu_e1_x = s_1 * h_e_5 + c_1 * h_e_4;
  const Scalar t38 = s_2 * mu_e1_x - c_2 * h_e_6;
  const Scalar mu_e2_x = s_2 * h_e_6 + c_2 * mu_e1_x;
  const Scalar t39 = s_3 * t38 - c_3 * mu_e2_x;
  const Scalar t40 = s_1 * h_e_4 - c_1 * h_e_5;
  const Scalar t41 = s_4 * t40 + c_4 * t39;
  const Scalar t42 = s_3 * mu_e2_x + c_3 * t38;
  const Scalar mu_6_z = Scalar(0.0112) * t22 - Scalar(0.007) * t23 + Scalar(0.0007896) * U_6_xy -
      Scalar(0.0009944) * (t29 - t30) + Scalar(0.000535) * U_6_yx - Scalar(0.000534) * (t31 - t32) -
      Scalar(0.000256) * U_6_xx_yy + s_5 * t41 - c_5 * t42;
  tau[5] = mu_6_z;
  const Scalar t43 = t29 + t30;
  const Scalar t44 = t31 + t32;
  const Scalar U_6_zz = t33 + t35;
  const Scalar U_6_yy_zz = U_6_yy - U_6_zz;
  const Scalar ddp_5_y = s_5 * t16 - c_5 * t20;
  const Scalar t45 = s_5 * t42 + c_5 * t41;
  const Scalar mu_e4_y = s_4 * t39 - c_4 * t40;
  const Scalar mu_6_x = Scalar(0.0112) * ddp_5_y + Scalar(0.000534) * U_6_yx +
      Scalar(0.000256) * t43 - Scalar(0.0007896) * t44 + Scalar(0.0009944) * U_6_yy_zz +
      s_6 * mu_e4_y - c_6 * t45;
  const Scalar U_6_zz_xx = U_6_xx - U_6_zz;
  const Scalar mu_6_y = Scalar(0.007) * ddp_5_y - Scalar(0.0009944) * U_6_xy +
      Scalar(0.000535) * t43 - Scalar(0.000256) * t44 + Scalar(0.000534) * U_6_zz_xx + s_6 * t45 +
      c_6 * mu_e4_y;
  const Scalar t46 = omega_r_5_x * omega_5_z;
  const Scalar t47 = omega_r_5_y * omega_5_z;
  const Scalar U_5_yz = domega_5_x - t47;
  const Scalar t48 = omega_r_5_y * omega_r_5_y;
  const Scalar t49 = omega_5_z * omega_5_z;
  const Scalar U_5_xx = t49 + t48;
  const Scalar t50 = omega_r_5_x * omega_r_5_x;
  const Scalar U_5_yy = t49 + t50;
  const Scalar U_5_xx_yy = U_5_xx - U_5_yy;
  const Scalar t51 = omega_r_5_x * omega_r_5_y;
  const Scalar U_5_xy = domega_5_z - t51;
  const Scalar U_5_yx = domega_5_z + t51;
  const Scalar tau_5 = Scalar(0.0317) * t21 + Scalar(0.0203) * ddp_5_y +
      Scalar(0.0123285) * U_5_xy - Scalar(0.0016163) * (t36 - t46) + Scalar(0.0029421) * U_5_yx -
      Scalar(0.0007639) * U_5_yz - Scalar(0.0010857) * U_5_xx_yy - s_6 * mu_6_x - c_6 * mu_6_y;
  tau[4] = tau_5;
  const Scalar t52 = t36 + t46;
  const Scalar U_5_zy = domega_5_x + t47;
  const Scalar U_5_zz = t48 + t50;
  const Scalar U_5_yy_zz = U_5_yy - U_5_zz;
  const Scalar mu_5_x = Scalar(0.0317) * ddp_4_y - Scalar(0.0007639) * U_5_yx -
      Scalar(0.0010857) * t52 + Scalar(0.0123285) * U_5_zy - Scalar(0.0016163) * U_5_yy_zz -
      s_6 * mu_6_y + c_6 * mu_6_x;
  const Scalar U_5_zz_xx = U_5_xx - U_5_zz;
  const Scalar mu_5_y = Scalar(0.0203) * ddp_4_y - Scalar(0.0016163) * U_5_xy +
      Scalar(0.0029421) * t52 - Scalar(0.0010857) * U_5_zy + Scalar(0.0007639) * U_5_zz_xx - mu_6_z;
  const Scalar t53 = t24 * omega_4_z;
  const Scalar t54 = omega_r_4_y * omega_4_z;
  const Scalar t55 = omega_r_4_y * omega_r_4_y;
  const Scalar t56 = omega_4_z * omega_4_z;
  const Scalar U_4_xx = t56 + t55;
  const Scalar t57 = t24 * t24;
  const Scalar U_4_yy = t56 + t57;
  const Scalar U_4_xx_yy = U_4_xx - U_4_yy;
  const Scalar t58 = t24 * omega_r_4_y;
  const Scalar U_4_xy = domega_4_z - t58;
  const Scalar U_4_yx = domega_4_z + t58;
  const Scalar tau_4 = Scalar(0.2145) * t16 + Scalar(0.1164) * ddp_4_y +
      Scalar(0.0316473) * U_4_xy + Scalar(0.0523608) * (t28 - t53) + Scalar(0.0123968) * U_4_yx +
      Scalar(0.0110896) * (t26 - t54) + Scalar(0.0009736) * U_4_xx_yy + s_5 * mu_5_x - c_5 * mu_5_y;
  tau[3] = tau_4;
  const Scalar f_e1_x = s_1 * h_e_2 + c_1 * h_e_1;
  const Scalar t59 = s_2 * f_e1_x - c_2 * h_e_3;
  const Scalar f_e2_x = s_2 * h_e_3 + c_2 * f_e1_x;
  const Scalar t60 = s_3 * t59 - c_3 * f_e2_x;
  const Scalar t61 = s_1 * h_e_1 - c_1 * h_e_2;
  const Scalar t62 = s_4 * t61 + c_4 * t60;
  const Scalar t63 = s_3 * f_e2_x + c_3 * t59;
  const Scalar t64 = s_5 * t63 + c_5 * t62;
  const Scalar f_e4_y = s_4 * t60 - c_4 * t61;
  const Scalar t65 = Scalar(0.007) * U_6_yx + Scalar(0.0112) * U_6_yy - s_6 * t64 - c_6 * f_e4_y;
  const Scalar f_6_x = Scalar(0.007) * U_6_xx - Scalar(0.0112) * U_6_xy + s_6 * f_e4_y - c_6 * t64;
  const Scalar f_5_x = Scalar(0.0203) * U_5_xx + Scalar(0.0317) * U_5_xy - s_6 * t65 - c_6 * f_6_x;
  const Scalar f_5_y = Scalar(0.0203) * U_5_yx - Scalar(0.0317) * U_5_yy + Scalar(0.007) * t43 -
      Scalar(0.0112) * t44 + s_5 * t62 - c_5 * t63;
  const Scalar f_4_x = Scalar(0.1164) * U_4_xx - Scalar(0.2145) * U_4_xy - s_5 * f_5_y -
      c_5 * f_5_x;
  const Scalar f_4_y = Scalar(0.1164) * U_4_yx + Scalar(0.2145) * U_4_yy + Scalar(0.0203) * t52 +
      Scalar(0.0317) * U_5_zy - s_6 * f_6_x + c_6 * t65;
  const Scalar f_u_4_t_x = s_4 * f_4_y + c_4 * f_4_x;
  const Scalar t66 = t28 + t53;
  const Scalar t67 = t26 + t54;
  const Scalar U_4_zz = t55 + t57;
  const Scalar U_4_yy_zz = U_4_yy - U_4_zz;
  const Scalar t68 = Scalar(0.2145) * t20 + Scalar(0.0110896) * U_4_yx + Scalar(0.0009736) * t66 +
      Scalar(0.0316473) * t67 + Scalar(0.0523608) * U_4_yy_zz - s_5 * mu_5_y - c_5 * mu_5_x;
  const Scalar U_4_zz_xx = U_4_xx - U_4_zz;
  const Scalar t69 = Scalar(0.1164) * t20 - Scalar(0.0523608) * U_4_xy - Scalar(0.0123968) * t66 -
      Scalar(0.0009736) * t67 + Scalar(0.0110896) * U_4_zz_xx + tau_5;
  const Scalar t70 = omega_r_3_x * omega_3_z;
  const Scalar t71 = t3 * t3;
  const Scalar U_3_xx = t19 + t71;
  const Scalar U_3_xx_yy = U_3_xx - U_3_yy;
  const Scalar U_3_yx = domega_3_z - t15;
  const Scalar mu_3_z = Scalar(3.8308) * ddp_3_x + Scalar(0.2745) * t17 -
      Scalar(1.9653344) * U_3_xy - Scalar(0.0408384) * (t27 - t70) - Scalar(0.0741175) * U_3_yx +
      Scalar(0.016137) * (t9 - t10) + Scalar(0.026176) * U_3_xx_yy + Scalar(0.45) * f_u_4_t_x -
      s_4 * t68 - c_4 * t69;
  tau[2] = -mu_3_z;
  const Scalar f_3_x = Scalar(0.2745) * U_3_xx + Scalar(3.8308) * U_3_xy - f_u_4_t_x;
  const Scalar f_3_y = Scalar(0.2745) * U_3_yx - Scalar(3.8308) * U_3_yy + Scalar(0.1164) * t66 -
      Scalar(0.2145) * t67 - s_5 * f_5_x + c_5 * f_5_y;
  const Scalar t72 = s_3 * f_3_x - c_3 * f_3_y;
  const Scalar t73 = t1 * t1;
  const Scalar U_2_yy = t14 + t73;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  const Scalar U_2_xy = qdd_2 - t12;
  tau[1] = Scalar(194.232114) * c_2 + Scalar(4.102542) * s_2 - Scalar(0.1098692) * t8 +
      Scalar(0.0444376) * t5 + Scalar(0.0771094) * U_2_xy + Scalar(8.4773316) * U_2_yx -
      Scalar(0.0684948) * U_2_xx_yy - mu_3_z - Scalar(0.45) * t72;
  const Scalar t74 = Scalar(-0.45) * (s_4 * f_4_x - c_4 * f_4_y);
  const Scalar t75 = t27 + t70;
  const Scalar U_3_zz = t71 + t18;
  const Scalar U_3_yy_zz = U_3_yy - U_3_zz;
  const Scalar mu_3_x = Scalar(1.72386) * U_2_zx + Scalar(0.016137) * U_3_yx -
      Scalar(0.026176) * t75 - Scalar(1.9653344) * t11 + Scalar(0.0408384) * U_3_yy_zz + s_4 * t69 -
      c_4 * t68 + t74;
  const Scalar U_3_zz_xx = U_3_xx - U_3_zz;
  const Scalar mu_3_y = Scalar(0.123525) * U_2_zx + Scalar(0.0408384) * U_3_xy +
      Scalar(0.0741175) * t75 + Scalar(0.026176) * t11 - Scalar(0.016137) * U_3_zz_xx - tau_4;
  const Scalar U_2_zy = t7 + domega_2_x;
  const Scalar U_2_zz = t13 + t73;
  const Scalar U_2_yy_zz = U_2_yy - U_2_zz;
  const Scalar mu_2_x = Scalar(0.1098692) * U_2_yx + Scalar(0.0684948) * U_2_zx -
      Scalar(0.0771094) * U_2_zy + Scalar(0.0444376) * U_2_yy_zz - s_3 * mu_3_y - c_3 * mu_3_x;
  const Scalar U_2_zz_xx = U_2_xx - U_2_zz;
  const Scalar mu_2_y = Scalar(0.0444376) * U_2_xy - Scalar(8.4773316) * U_2_zx +
      Scalar(0.0684948) * U_2_zy - Scalar(0.123525) * t75 + Scalar(1.72386) * t11 -
      Scalar(0.1098692) * U_2_zz_xx - t74 + s_3 * mu_3_x - c_3 * mu_3_y;
  tau[0] = Scalar(0.8059476) * qdd_1 - s_2 * mu_2_x + c_2 * mu_2_y;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[36] = {
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1};

// joint-space inertia matrix B(q) (7.32).
//   q[6]   in   joint positions, rad or m
//   B[36]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//               6 x 6, row by row: entry (i, j) is B[6 * i + j]
// Reads q[1..5]. Operations: 113 mul, 100 add, 10 sin/cos.
template <class Scalar>
inline void inertia_matrix(const Scalar* q, Scalar* B) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar Iu_6_t_yz = Scalar(0.0009944) * c_6 - Scalar(0.000534) * s_6;
  B[29] = B[34] = Iu_6_t_yz;
  const Scalar Iu_6_t_xz = Scalar(0.000534) * c_6 + Scalar(0.0009944) * s_6;
  const Scalar mu_u_6_5_t_y = Scalar(0.0013246) * c_5 + s_5 * Iu_6_t_xz;
  B[23] = B[33] = mu_u_6_5_t_y;
  const Scalar Iu_6_t_g = Scalar(0.0002546) * c_6 - Scalar(0.000512) * s_6;
  const Scalar t1 = c_6 * Iu_6_t_g;
  const Scalar Ic_5_zz = t1 - Scalar(0.0160602);
  B[28] = -Ic_5_zz;
  const Scalar Ic_5_xz = s_6 * Iu_6_t_g + Scalar(0.0010199);
  const Scalar Ic_5_yz = Iu_6_t_yz + Scalar(0.0016163);
  const Scalar t2 = s_5 * Ic_5_xz - c_5 * Ic_5_yz;
  B[22] = B[27] = -t2;
  const Scalar hu_6_t_y = Scalar(0.0112) * c_6 - Scalar(0.007) * s_6;
  const Scalar t3 = c_5 * hu_6_t_y;
  const Scalar hu_6_t_x = Scalar(0.007) * c_6 + Scalar(0.0112) * s_6;
  const Scalar t4 = s_4 * hu_6_t_x - c_4 * t3;
  const Scalar mu_u_6_5_t_x = Scalar(0.0013246) * s_5 - c_5 * Iu_6_t_xz;
  const Scalar t5 = Scalar(0.45) * t4 - s_4 * mu_u_6_5_t_x - c_4 * Iu_6_t_yz;
  B[17] = B[32] = -t5;
  const Scalar Iu_6_t_xx = t1 - Scalar(0.0002546);
  const Scalar Iu_5_t_d = Iu_6_t_xx + Scalar(0.0088514);
  const Scalar Ic_5_xy = Iu_6_t_xz + Scalar(0.0010857);
  const Scalar t6 = Scalar(2.0) * s_5 * Ic_5_xy - c_5 * Iu_5_t_d;
  const Scalar t7 = c_5 * t6;
  const Scalar Ic_4_zz = Iu_6_t_xx + t7 + Scalar(0.0571622);
  B[21] = Ic_4_zz;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.0203);
  const Scalar hu_5_t_y = Scalar(0.0317) * c_5 - s_5 * hc_5_x;
  const Scalar t8 = Scalar(0.45) * hu_5_t_y;
  const Scalar t9 = Ic_5_zz - t8;
  const Scalar Iu_5_t_xz = s_5 * Ic_5_yz + c_5 * Ic_5_xz;
  const Scalar mu_5_3_z = s_4 * Iu_5_t_xz - c_4 * t9;
  B[16] = B[26] = mu_5_3_z;
  B[11] = B[31] = Scalar(0.45) * (s_3 * t4 - c_3 * s_5 * hu_6_t_y) - t5;
  const Scalar hu_5_t_x = Scalar(0.0317) * s_5 + c_5 * hc_5_x;
  const Scalar f_u_5_3_t_y = s_3 * c_4 * hu_5_t_y + c_3 * hu_5_t_x;
  B[10] = B[25] = mu_5_3_z - Scalar(0.45) * f_u_5_3_t_y;
  const Scalar f_u_6_4_t_y = s_4 * t3 + c_4 * hu_6_t_x;
  const Scalar t10 = Scalar(0.45) * f_u_6_4_t_y;
  const Scalar mu_6_3_x = s_4 * Iu_6_t_yz - c_4 * mu_u_6_5_t_x + t10;
  const Scalar mu_6_2_y = t10 - s_3 * mu_6_3_x - c_3 * mu_u_6_5_t_y;
  B[5] = B[30] = -s_2 * (s_3 * mu_u_6_5_t_y - c_3 * mu_6_3_x) - c_2 * mu_6_2_y;
  const Scalar Ic_4_xz = Ic_5_xy - s_5 * t6 - Scalar(0.0110896);
  const Scalar t11 = t2 + Scalar(0.0523608);
  const Scalar hc_4_x = hu_5_t_x + Scalar(0.1164);
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.2145);
  const Scalar t12 = Scalar(-0.45) * (s_4 * hc_4_x - c_4 * hc_4_y);
  const Scalar t13 = (s_4 * Ic_4_xz + c_4 * t11) - t12;
  B[15] = B[20] = -t13;
  const Scalar t14 = c_4 * Iu_5_t_xz + s_4 * t9;
  const Scalar t15 = c_2 * (s_4 * t8 + s_3 * t14 + c_3 * t2);
  B[4] = B[24] = s_2 * (s_3 * t2 - c_3 * t14) - t15;
  B[9] = B[19] = -t13 - s_3 * t12;
  const Scalar t16 = t7 + Scalar(0.0088514);
  const Scalar Ic_4_yy = Ic_5_zz + Scalar(0.0323686);
  const Scalar Ic_4_xy = Iu_5_t_xz - Scalar(0.0009736);
  const Scalar t17 = Scalar(2.0) * s_4 * Ic_4_xy + c_4 * (t16 - Ic_4_yy);
  const Scalar t18 = c_4 * t17;
  const Scalar t19 = Scalar(0.9) * hu_5_t_y;
  const Scalar t20 = t16 - t18 - t19 - Scalar(2.0842173);
  B[14] = -t20;
  const Scalar hu_4_t_x = s_4 * hc_4_y + c_4 * hc_4_x;
  const Scalar hc_3_x = hu_4_t_x - Scalar(0.2745);
  const Scalar hc_3_y = hu_5_t_y + Scalar(3.8308);
  const Scalar hu_3_t_x = s_3 * hc_3_y + c_3 * hc_3_x;
  const Scalar t21 = Scalar(0.9) * hu_3_t_x;
  B[7] = Scalar(8.554441) - t20 - t21;
  B[8] = B[13] = -t20 - Scalar(0.45) * hu_3_t_x;
  const Scalar t22 = Scalar(0.45) * hu_4_t_x;
  const Scalar t23 = (s_4 * t11 - c_4 * Ic_4_xz) - t22;
  const Scalar mu_4_2_y = t22 + s_3 * t23 - c_3 * Ic_4_zz;
  B[3] = B[18] = -s_2 * (s_3 * Ic_4_zz + c_3 * t23) - c_2 * mu_4_2_y;
  const Scalar Ic_3_xz = Ic_4_xy - s_4 * t17 - Scalar(0.016137);
  const Scalar t24 = t13 + Scalar(0.0408384);
  const Scalar t25 = s_3 * t24 - c_3 * Ic_3_xz;
  const Scalar t26 = s_3 * Ic_3_xz + c_3 * t24;
  B[2] = B[12] = s_2 * t25 - c_2 * t26;
  B[1] = B[6] = s_2 * (t12 + t25 - Scalar(0.1098692)) - c_2 * (t26 - Scalar(0.0444376));
  const Scalar t27 = Ic_4_yy + t18 - t19;
  const Scalar Ic_3_yy = Ic_4_zz - Scalar(1.9359823);
  const Scalar t28 = t23 - Scalar(0.026176);
  const Scalar t29 = Scalar(2.0) * s_3 * t28 - c_3 * (t27 + Ic_3_yy);
  const Scalar t30 = c_3 * t29;
  const Scalar Iu_3_t_xx = Ic_3_yy + t30;
  const Scalar t31 = s_3 * hc_3_x - c_3 * hc_3_y;
  const Scalar t32 = s_2 * (t28 - Scalar(0.45) * t31 - s_3 * t29 - Scalar(0.0684948));
  const Scalar t33 = Scalar(2.0) * t32 + c_2 * (t27 + t30 + Iu_3_t_xx + t21 - Scalar(8.4002222));
  B[0] = Iu_3_t_xx - c_2 * t33 + Scalar(2.8931568);
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
// Reads q[1..5]. Operations: 361 mul, 285 add, 10 sin/cos. Always zero: 21 of the 126 entries of c.
template <class Scalar>
inline void christoffel(const Scalar* q, Scalar* c) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar Iu_6_t_xz = Scalar(0.000267) * c_6 + Scalar(0.0004972) * s_6;
  c[104] = Scalar(-2.0) * Iu_6_t_xz;
  const Scalar Iu_6_t_g = Scalar(0.0001273) * c_6 - Scalar(0.000256) * s_6;
  const Scalar t1 = s_6 * Iu_6_t_g;
  const Scalar dmu_5_6_y = Scalar(0.000256) * c_6 + Scalar(0.0001273) * s_6;
  const Scalar db_55_6r = t1 + c_6 * dmu_5_6_y;
  c[103] = db_55_6r;
  const Scalar Iu_6_t_yz = Scalar(0.0004972) * c_6 - Scalar(0.000267) * s_6;
  const Scalar t2 = s_5 * Iu_6_t_yz;
  c[83] = Scalar(2.0) * t2;
  c[119] = -db_55_6r;
  const Scalar dmu_4_6_x = Scalar(0.0004972) * c_5 - s_5 * dmu_5_6_y;
  const Scalar dmu_4_6_y = Scalar(0.000267) * c_5 + s_5 * Iu_6_t_g;
  const Scalar db_44_6r = s_5 * (c_6 * dmu_4_6_x - s_6 * dmu_4_6_y + c_5 * Iu_6_t_yz);
  c[81] = db_44_6r;
  const Scalar t3 = s_4 * c_5;
  const Scalar w_2_6_x = c_4 * s_6 + c_6 * t3;
  const Scalar t4 = c_4 * c_6 - s_6 * t3;
  const Scalar t5 = Scalar(0.0004972) * w_2_6_x + Scalar(0.000267) * t4;
  const Scalar hu_6_t_x = Scalar(0.0035) * c_6 + Scalar(0.0056) * s_6;
  const Scalar t6 = Scalar(0.45) * hu_6_t_x;
  const Scalar t7 = c_4 * c_5;
  const Scalar hu_6_t_y = Scalar(0.0056) * c_6 - Scalar(0.0035) * s_6;
  const Scalar t8 = Scalar(0.45) * s_4;
  const Scalar t9 = hu_6_t_y * t8 + t7 * t6;
  const Scalar db_36_6 = t5 + t9;
  c[62] = Scalar(-2.0) * db_36_6;
  const Scalar Ic_5_xz = t1 + Scalar(0.00050995);
  const Scalar Ic_5_yz = Iu_6_t_yz + Scalar(0.00080815);
  const Scalar Iu_5_t_xz = c_5 * Ic_5_xz + s_5 * Ic_5_yz;
  c[77] = Scalar(-2.0) * Iu_5_t_xz;
  const Scalar t10 = c_6 * Iu_6_t_g;
  const Scalar t11 = c_5 * Iu_6_t_xz;
  const Scalar db_45_6r = t11 + s_5 * (t10 - s_6 * dmu_5_6_y);
  const Scalar db_46_5 = Scalar(0.0006623) * s_5 - t11;
  const Scalar c_5_4_6 = db_46_5 - db_45_6r;
  c[102] = c_5_4_6;
  c[114] = -db_44_6r;
  const Scalar t12 = Scalar(0.45) * s_3;
  const Scalar v_o_2_4_x = t12 - Scalar(0.45);
  const Scalar t13 = c_4 * s_5;
  const Scalar t14 = Scalar(0.45) * c_3;
  const Scalar t15 = c_5 * t14 - v_o_2_4_x * t13;
  const Scalar t16 = hu_6_t_y * t15;
  const Scalar mu_u_6_5_t_y = Scalar(0.0006623) * c_5 + s_5 * Iu_6_t_xz;
  const Scalar t17 = s_4 * mu_u_6_5_t_y;
  const Scalar db_26_5 = t17 - t16;
  const Scalar t18 = s_4 * s_5;
  const Scalar t19 = Iu_6_t_g * w_2_6_x + t4 * dmu_5_6_y - Iu_6_t_xz * t18;
  const Scalar t20 = t16 - t19;
  c[40] = db_26_5 - t20;
  const Scalar c_5_2_6 = db_26_5 + t20;
  c[116] = c_5_2_6;
  const Scalar t21 = c_4 * db_46_5 - s_4 * Iu_6_t_yz;
  const Scalar f_u_6_4_t_y = c_4 * hu_6_t_x + hu_6_t_y * t3;
  const Scalar t22 = Scalar(0.45) * f_u_6_4_t_y;
  const Scalar t23 = t21 - t22;
  const Scalar t24 = w_2_6_x * dmu_4_6_x - t18 * t2 + t4 * dmu_4_6_y;
  const Scalar t25 = t24 + c_5 * t9 + s_5 * t13 * t6;
  c[60] = t23 - t25;
  const Scalar c_4_3_6 = t23 + t25;
  c[113] = c_4_3_6;
  const Scalar t26 = Scalar(0.45) * hu_6_t_y * t13;
  const Scalar db_35_6r = t26 - t19;
  const Scalar db_36_5 = t17 - t26;
  c[61] = db_36_5 - db_35_6r;
  const Scalar c_5_3_6 = db_36_5 + db_35_6r;
  c[117] = c_5_3_6;
  c[82] = -db_46_5 - db_45_6r;
  c[118] = -c_5_4_6;
  const Scalar Iu_6_t_xx = t10 - Scalar(0.0001273);
  const Scalar Iu_5_t_d = Iu_6_t_xx + Scalar(0.0044257);
  const Scalar Ic_5_xy = Scalar(2.0) * Iu_6_t_xz + Scalar(0.0010857);
  const Scalar t27 = c_5 * Iu_5_t_d - s_5 * Ic_5_xy;
  const Scalar t28 = s_5 * t27;
  const Scalar dmu_4_5_y = c_5 * Ic_5_xy + s_5 * Iu_5_t_d;
  const Scalar db_44_5r = t28 + c_5 * dmu_4_5_y;
  c[76] = db_44_5r;
  const Scalar t29 = Scalar(0.000256) * w_2_6_x - Scalar(0.0001273) * t4 + Scalar(0.0004972) * t18;
  const Scalar t30 = Scalar(0.001575) * t13 - t29;
  const Scalar t31 = Scalar(0.0001273) * w_2_6_x + Scalar(0.000256) * t4 - Scalar(0.000267) * t18;
  const Scalar t32 = Scalar(0.00252) * t13 - t31;
  const Scalar t33 = w_2_6_x * t30 - db_36_6 * t18 - t4 * t32;
  const Scalar t34 = Scalar(0.0035) * w_2_6_x - Scalar(0.0056) * t4;
  const Scalar t35 = Scalar(0.45) * c_4;
  const Scalar c_3_18 = t33 - s_5 * (s_4 * t9 - t35 * t34);
  c[59] = c_3_18;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.01015);
  const Scalar hu_5_t_x = Scalar(0.01585) * s_5 + c_5 * hc_5_x;
  const Scalar t36 = s_4 * hu_5_t_x;
  const Scalar w_1_3_x = c_2 * s_3 + s_2 * c_3;
  const Scalar t37 = Scalar(0.45) * c_2;
  const Scalar t38 = Scalar(0.45) * w_1_3_x - t37;
  const Scalar t39 = t38 * t36;
  const Scalar t40 = c_2 * c_3 - s_2 * s_3;
  const Scalar t41 = c_5 * t40 - w_1_3_x * t13;
  const Scalar t42 = w_1_3_x * t7 + s_5 * t40;
  const Scalar t43 = t39 + Ic_5_xz * t41 + Ic_5_yz * t42;
  c[14] = Scalar(-2.0) * t43;
  const Scalar t44 = s_4 * w_1_3_x;
  const Scalar t45 = c_6 * t42 - s_6 * t44;
  const Scalar t46 = c_6 * t44 + s_6 * t42;
  const Scalar t47 = t38 * t34;
  const Scalar t48 = Scalar(0.0004972) * t45 - Scalar(0.000267) * t46 - t47;
  c[20] = Scalar(2.0) * t48;
  const Scalar v_2_5_x = v_o_2_4_x * t7 + s_5 * t14;
  const Scalar t49 = Scalar(0.01585) * t15 - hc_5_x * v_2_5_x;
  const Scalar t50 = c_5 * Ic_5_yz - s_5 * Ic_5_xz;
  const Scalar t51 = s_4 * t50;
  const Scalar t52 = t49 - t51;
  c[35] = Scalar(-2.0) * t52;
  const Scalar t53 = t51 - hu_5_t_x * t35;
  c[56] = Scalar(2.0) * t53;
  c[100] = -c_5_2_6;
  c[80] = -c_4_3_6;
  c[101] = -c_5_3_6;
  c[93] = -db_44_5r;
  c[110] = -c_3_18;
  const Scalar t54 = s_4 * v_o_2_4_x;
  const Scalar v_2_6_y = c_6 * t54 + s_6 * v_2_5_x;
  const Scalar t55 = Scalar(0.0035) * (c_6 * v_2_5_x - s_6 * t54) + Scalar(0.0056) * v_2_6_y;
  const Scalar t56 = t5 - t55;
  c[41] = Scalar(-2.0) * t56;
  const Scalar db_16_3 = w_1_3_x * mu_u_6_5_t_y + t40 * t23;
  const Scalar t57 = t41 * db_36_6 + t45 * t30 + t46 * t32;
  const Scalar c_3_1_6 = db_16_3 - t57;
  c[57] = c_3_1_6;
  const Scalar t58 = Iu_5_t_xz * t44;
  const Scalar hu_5_t_y = Scalar(0.01585) * c_5 - s_5 * hc_5_x;
  const Scalar t59 = c_4 * t38;
  const Scalar t60 = hu_5_t_y * t59;
  const Scalar t61 = t60 - t58 + t27 * t42 + t41 * dmu_4_5_y;
  const Scalar Ic_5_zz = t10 - Scalar(0.0080301);
  const Scalar t62 = c_4 * Ic_5_zz * w_1_3_x - t60 - t58;
  const Scalar c_4_1_5 = t62 + t61;
  c[73] = c_4_1_5;
  const Scalar t63 = t38 * t18;
  const Scalar t64 = s_5 * (Iu_6_t_yz * t41 - hu_6_t_x * t63);
  const Scalar t65 = t64 - c_5 * t47 + t45 * dmu_4_6_x - t46 * dmu_4_6_y;
  const Scalar t66 = hu_6_t_y * t7 - s_4 * hu_6_t_x;
  const Scalar t67 = w_1_3_x * (c_4 * Iu_6_t_yz + s_4 * db_46_5) + t38 * t66;
  c[18] = t67 + t65;
  const Scalar c_4_1_6 = t67 - t65;
  c[111] = c_4_1_6;
  const Scalar t68 = hu_6_t_y * t63;
  const Scalar t69 = Iu_6_t_xz * t41;
  const Scalar t70 = t68 + t69 + Iu_6_t_g * t45 - t46 * dmu_5_6_y;
  const Scalar t71 = Scalar(0.0006623) * t42 + t68 - t69;
  const Scalar c_5_1_6 = t71 - t70;
  c[99] = c_5_1_6;
  const Scalar hc_4_x = hu_5_t_x + Scalar(0.0582);
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.10725);
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * hc_4_y;
  const Scalar hc_3_x = hu_4_t_x - Scalar(0.13725);
  const Scalar hc_3_y = hu_5_t_y + Scalar(1.9154);
  const Scalar t72 = Scalar(0.9) * c_3;
  const Scalar db_22_3r = hc_3_y * t72 - Scalar(0.9) * s_3 * hc_3_x;
  c[44] = db_22_3r;
  const Scalar t73 = t59 * (Scalar(0.01585) * t41 - hc_5_x * t42);
  const Scalar t74 = hc_5_x * t59 + Ic_5_yz * t44 - Iu_5_t_d * t41 + Ic_5_xy * t42;
  const Scalar t75 = Scalar(0.01585) * t59 - Ic_5_xz * t44 + Iu_5_t_d * t42 + Ic_5_xy * t41;
  const Scalar c_5_1 = t44 * (t39 + t43) - t73 + t42 * t74 - t41 * t75;
  c[84] = c_5_1;
  const Scalar t76 = t63 * (Scalar(0.0035) * t45 + Scalar(0.0056) * t46);
  const Scalar t77 = Scalar(0.0004972) * t41 - Scalar(0.000256) * t45 - Scalar(0.0001273) * t46 -
      Scalar(0.0035) * t63;
  const Scalar t78 = Scalar(0.000267) * t41 + Scalar(0.0001273) * t45 - Scalar(0.000256) * t46 +
      Scalar(0.0056) * t63;
  const Scalar c_6_1 = t41 * (t47 - t48) + t76 - t45 * t77 + t46 * t78;
  c[105] = c_6_1;
  const Scalar t79 = t55 * t18 + t15 * t34;
  const Scalar t80 = Scalar(0.0035) * t15 - t29;
  const Scalar t81 = Scalar(0.0056) * t15 - t31;
  const Scalar c_2_17 = t79 - t56 * t18 + w_2_6_x * t80 - t4 * t81;
  c[37] = c_2_17;
  c[17] = -db_16_3 - t57;
  c[108] = -c_3_1_6;
  c[13] = t61 - t62;
  c[90] = -c_4_1_5;
  c[78] = -c_4_1_6;
  c[19] = -t71 - t70;
  c[115] = -c_5_1_6;
  const Scalar t82 = t24 - c_5 * t55 + s_5 * hu_6_t_x * t15;
  const Scalar t83 = t21 + v_o_2_4_x * f_u_6_4_t_y;
  c[39] = t83 - t82;
  const Scalar c_4_2_6 = t83 + t82;
  c[112] = c_4_2_6;
  c[25] = c[26] = -db_22_3r;
  c[10] = -c_5_1;
  c[15] = -c_6_1;
  c[107] = -c_2_17;
  const Scalar mu_6_2_y = t22 - c_3 * mu_u_6_5_t_y + s_3 * t23;
  const Scalar t84 = c_2 * (c_3 * t23 + s_3 * mu_u_6_5_t_y) - s_2 * mu_6_2_y;
  const Scalar t85 = t41 * t56 + t45 * t80 + t46 * t81;
  const Scalar c_2_16 = t84 - t85;
  c[36] = c_2_16;
  const Scalar t86 = t79 + t33;
  const Scalar db_26_3 = s_5 * hu_6_t_y * t12 - t14 * t66;
  c[38] = db_26_3 + t86;
  const Scalar c_3_2_6 = db_26_3 - t86;
  c[109] = c_3_2_6;
  c[79] = -c_4_2_6;
  const Scalar t87 = c_5 * t27;
  const Scalar Ic_4_yy = Ic_5_zz + Scalar(0.0161843);
  const Scalar Iu_4_t_d = Ic_4_yy + t87 - Scalar(0.0044257);
  const Scalar Ic_4_xy = Iu_5_t_xz - Scalar(0.0004868);
  const Scalar t88 = Scalar(2.0) * Ic_4_xy;
  const Scalar t89 = c_4 * Iu_4_t_d - s_4 * t88;
  const Scalar t90 = s_4 * t89;
  const Scalar dmu_3_4_y = c_4 * t88 + s_4 * Iu_4_t_d;
  const Scalar db_33_4r = t90 + c_4 * dmu_3_4_y;
  c[49] = c[50] = db_33_4r;
  const Scalar Ic_4_xz = Iu_6_t_xz + t28 - Scalar(0.00500195);
  const Scalar t91 = t50 - Scalar(0.0261804);
  const Scalar t92 = c_4 * Ic_4_xz + s_4 * t91;
  const Scalar t93 = t92 - hu_4_t_x * v_o_2_4_x;
  c[30] = Scalar(-2.0) * t93;
  const Scalar t94 = Scalar(0.45) * hu_4_t_x;
  const Scalar t95 = t92 + t94;
  c[51] = Scalar(-2.0) * t95;
  c[16] = -t84 - t85;
  c[106] = -c_2_16;
  const Scalar t96 = s_4 * dmu_4_5_y - c_4 * Ic_5_yz;
  const Scalar t97 = t96 + hc_5_x * t8;
  const Scalar t98 = s_4 * t27 + c_4 * Ic_5_xz;
  const Scalar dmu_3_5_y = Scalar(0.0071325) * s_4 + t98;
  const Scalar t99 = t44 * t53 + t42 * t97 - t41 * dmu_3_5_y;
  const Scalar t100 = c_4 * Iu_5_t_xz;
  const Scalar t101 = t100 + s_4 * Ic_5_zz;
  const Scalar t102 = hu_5_t_y * t8;
  const Scalar db_35_4 = t101 - t102;
  const Scalar t103 = t50 * w_1_3_x + t40 * db_35_4;
  const Scalar c_3_1_5 = t103 + t99;
  c[52] = c_3_1_5;
  c[58] = -c_3_2_6;
  const Scalar t104 = t100 + s_4 * (t87 - s_5 * dmu_4_5_y);
  const Scalar t105 = hu_5_t_y * t54;
  const Scalar t106 = t105 - t104;
  const Scalar db_25_4 = t101 + t105;
  c[34] = db_25_4 + t106;
  const Scalar c_4_2_5 = db_25_4 - t106;
  c[91] = c_4_2_5;
  const Scalar db_34_5r = t102 + t104;
  c[55] = db_35_4 - db_34_5r;
  const Scalar c_4_3_5 = db_35_4 + db_34_5r;
  c[92] = c_4_3_5;
  const Scalar t107 = dmu_3_4_y - hc_4_y * t14;
  const Scalar t108 = t89 + hc_4_x * t14;
  const Scalar t109 = c_4 * hc_4_y - s_4 * hc_4_x;
  const Scalar db_22_4r = t109 * t14 - c_4 * t107 - s_4 * t108;
  c[65] = db_22_4r;
  c[67] = c[68] = -db_33_4r;
  const Scalar t110 = t96 - hc_5_x * t54;
  const Scalar t111 = Scalar(0.01585) * t54 - t98;
  const Scalar t112 = c_4 * t49 - t54 * t36;
  const Scalar db_22_5r = t112 + s_4 * (c_5 * t110 - s_5 * t111) + c_4 * t52;
  c[86] = db_22_5r;
  const Scalar t113 = c_4 * t91 - s_4 * Ic_4_xz;
  const Scalar t114 = t109 * t38;
  const Scalar t115 = t113 * w_1_3_x + t114;
  c[9] = Scalar(2.0) * t115;
  const Scalar mu_5_2_y = t102 - c_3 * t50 + s_3 * db_35_4;
  const Scalar t116 = c_2 * (c_3 * db_35_4 + s_3 * t50) - s_2 * mu_5_2_y;
  const Scalar t117 = t44 * t52 - t42 * t110 - t41 * t111;
  const Scalar c_2_11 = t116 - t117;
  c[31] = c_2_11;
  c[12] = t99 - t103;
  c[87] = -c_3_1_5;
  c[29] = db_33_4r - t109 * t72;
  c[74] = -c_4_2_5;
  c[75] = -c_4_3_5;
  c[28] = -db_22_4r;
  c[32] = -db_22_5r;
  const Scalar t118 = s_4 * (c_5 * t97 + s_5 * dmu_3_5_y) - c_4 * t53;
  const Scalar db_33_5r = Scalar(0.45) * hu_5_t_x + t118;
  c[89] = db_33_5r;
  c[11] = -t116 - t117;
  c[85] = -c_2_11;
  c[54] = -db_33_5r;
  const Scalar Ic_3_xz = Ic_4_xy + t90 - Scalar(0.0080685);
  const Scalar t119 = Scalar(-0.45) * t109;
  const Scalar t120 = t113 - t119 - Scalar(0.0204192);
  const Scalar t121 = Ic_3_xz * t40 + t120 * w_1_3_x;
  c[5] = Scalar(-2.0) * t121;
  const Scalar t122 = c_4 * t89;
  const Scalar t123 = t95 * t40;
  const Scalar t124 = t123 + w_1_3_x * (t122 - s_4 * dmu_3_4_y);
  const Scalar Ic_4_zz = Iu_6_t_xx - t87 + Scalar(0.0285811);
  const Scalar t125 = Ic_4_zz * w_1_3_x - t123;
  const Scalar c_3_1_4 = t125 - t124;
  c[48] = c_3_1_4;
  const Scalar t126 = t112 + t118;
  const Scalar t127 = hu_5_t_x * t12 - c_4 * hu_5_t_y * t14;
  c[33] = t127 - t126;
  const Scalar c_3_2_5 = t127 + t126;
  c[88] = c_3_2_5;
  const Scalar t128 = c_4 * (w_1_3_x * dmu_3_4_y - t91 * t40);
  const Scalar t129 = w_1_3_x * (t128 + s_4 * (t89 * w_1_3_x + Ic_4_xz * t40));
  const Scalar c_4_1 = t129 - t40 * (t114 + t115);
  c[63] = c_4_1;
  const Scalar mu_4_2_y = t94 - c_3 * Ic_4_zz - s_3 * t95;
  const Scalar db_14_2 = c_2 * (c_3 * t95 - s_3 * Ic_4_zz) + s_2 * mu_4_2_y;
  const Scalar db_12_4r = w_1_3_x * (c_4 * t108 - s_4 * t107) + t40 * t93;
  c[7] = db_14_2 - db_12_4r;
  const Scalar c_2_1_4 = db_14_2 + db_12_4r;
  c[64] = c_2_1_4;
  c[8] = -t125 - t124;
  c[66] = -c_3_1_4;
  c[53] = -c_3_2_5;
  const Scalar t130 = Scalar(2.0) * t95 + Scalar(0.026176);
  const Scalar Iu_3_t_d = Scalar(0.9) * hu_5_t_y - Ic_4_yy - Ic_4_zz + t122 + Scalar(0.96799115);
  const Scalar t131 = w_1_3_x * (hc_3_x * t37 + Iu_3_t_d * t40 - t130 * w_1_3_x);
  const Scalar dmu_1_3_y = hc_3_y * t37 - Iu_3_t_d * w_1_3_x - t130 * t40;
  const Scalar df_1_3_z = hc_3_x * w_1_3_x - hc_3_y * t40;
  const Scalar db_11_3r = t37 * df_1_3_z + t131 - t40 * dmu_1_3_y;
  c[3] = db_11_3r;
  c[6] = -c_4_1;
  const Scalar t132 = c_3 * Ic_3_xz + s_3 * t120;
  const Scalar t133 = c_3 * t120 - s_3 * Ic_3_xz;
  const Scalar t134 = c_2 * t132 + s_2 * t133;
  const Scalar c_2_1_3 = t121 - t134;
  c[43] = c_2_1_3;
  c[27] = -c_2_1_4;
  c[2] = Scalar(-2.0) * (c_2 * (t119 + t132 + Scalar(0.0549346)) +
      s_2 * (t133 + Scalar(0.0222188)));
  c[42] = -db_11_3r;
  c[4] = -t121 - t134;
  c[24] = -c_2_1_3;
  const Scalar t135 = Scalar(-2.0) * (c_3 * Iu_3_t_d - s_3 * t130);
  const Scalar hu_3_t_x = c_3 * hc_3_x + s_3 * hc_3_y;
  const Scalar t136 = Scalar(0.9) * hu_3_t_x - Iu_3_t_d - c_3 * t135 - Scalar(4.2001111);
  const Scalar t137 = t130 - db_22_3r - s_3 * t135 + Scalar(0.0684948);
  const Scalar t138 = s_2 * (c_2 * t136 - s_2 * t137);
  const Scalar db_11_2r = t138 + c_2 * (c_2 * t137 + s_2 * t136);
  c[1] = db_11_2r;
  c[21] = -db_11_2r;
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
// Reads q[1..5], qd[0..5]. Operations: 494 mul, 410 add, 10 sin/cos. Always zero: 1 of the 36
// entries of C.
template <class Scalar>
inline void coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar Iu_6_t_g = Scalar(0.0001273) * c_6 - Scalar(0.000256) * s_6;
  const Scalar t1 = s_6 * Iu_6_t_g;
  const Scalar dmu_5_6_y = Scalar(0.000256) * c_6 + Scalar(0.0001273) * s_6;
  const Scalar db_55_6r = t1 + c_6 * dmu_5_6_y;
  C[28] = qd_6 * db_55_6r;
  const Scalar t2 = c_6 * Iu_6_t_g;
  const Scalar Iu_6_t_xx = t2 - Scalar(0.0001273);
  const Scalar Iu_5_t_d = Iu_6_t_xx + Scalar(0.0044257);
  const Scalar Iu_6_t_xz = Scalar(0.000267) * c_6 + Scalar(0.0004972) * s_6;
  const Scalar Ic_5_xy = Scalar(2.0) * Iu_6_t_xz + Scalar(0.0010857);
  const Scalar t3 = c_5 * Iu_5_t_d - s_5 * Ic_5_xy;
  const Scalar t4 = s_5 * t3;
  const Scalar dmu_4_5_y = c_5 * Ic_5_xy + s_5 * Iu_5_t_d;
  const Scalar t5 = t4 + c_5 * dmu_4_5_y;
  const Scalar dmu_4_6_x = Scalar(0.0004972) * c_5 - s_5 * dmu_5_6_y;
  const Scalar dmu_4_6_y = Scalar(0.000267) * c_5 + s_5 * Iu_6_t_g;
  const Scalar Iu_6_t_yz = Scalar(0.0004972) * c_6 - Scalar(0.000267) * s_6;
  const Scalar t6 = s_5 * (c_6 * dmu_4_6_x - s_6 * dmu_4_6_y + c_5 * Iu_6_t_yz);
  C[21] = qd_5 * t5 + qd_6 * t6;
  const Scalar w_1_3_x = c_2 * s_3 + s_2 * c_3;
  const Scalar t7 = c_4 * c_5;
  const Scalar t8 = c_2 * c_3 - s_2 * s_3;
  const Scalar t9 = w_1_3_x * t7 + s_5 * t8;
  const Scalar t10 = s_4 * w_1_3_x;
  const Scalar t11 = c_6 * t9 - s_6 * t10;
  const Scalar t12 = c_6 * t10 + s_6 * t9;
  const Scalar t13 = Scalar(0.45) * c_2;
  const Scalar t14 = Scalar(0.45) * w_1_3_x - t13;
  const Scalar t15 = s_4 * s_5;
  const Scalar t16 = t14 * t15;
  const Scalar hu_6_t_y = Scalar(0.0056) * c_6 - Scalar(0.0035) * s_6;
  const Scalar t17 = hu_6_t_y * t16;
  const Scalar t18 = c_4 * s_5;
  const Scalar t19 = c_5 * t8 - w_1_3_x * t18;
  const Scalar t20 = Iu_6_t_xz * t19;
  const Scalar t21 = t17 + t20 + Iu_6_t_g * t11 - t12 * dmu_5_6_y;
  const Scalar t22 = Scalar(0.0006623) * t9 + t17 - t20;
  const Scalar t23 = t22 - t21;
  const Scalar t24 = Scalar(0.45) * s_3;
  const Scalar v_o_2_4_x = t24 - Scalar(0.45);
  const Scalar t25 = Scalar(0.45) * c_3;
  const Scalar t26 = c_5 * t25 - v_o_2_4_x * t18;
  const Scalar t27 = hu_6_t_y * t26;
  const Scalar mu_u_6_5_t_y = Scalar(0.0006623) * c_5 + s_5 * Iu_6_t_xz;
  const Scalar t28 = s_4 * mu_u_6_5_t_y;
  const Scalar db_26_5 = t28 - t27;
  const Scalar t29 = s_4 * c_5;
  const Scalar w_2_6_x = c_4 * s_6 + c_6 * t29;
  const Scalar t30 = c_4 * c_6 - s_6 * t29;
  const Scalar t31 = Iu_6_t_g * w_2_6_x + t30 * dmu_5_6_y - Iu_6_t_xz * t15;
  const Scalar t32 = t27 - t31;
  const Scalar c_5_2_6 = db_26_5 + t32;
  const Scalar t33 = Scalar(0.45) * hu_6_t_y * t18;
  const Scalar db_35_6r = t33 - t31;
  const Scalar db_36_5 = t28 - t33;
  const Scalar c_5_3_6 = db_36_5 + db_35_6r;
  const Scalar t34 = c_5 * Iu_6_t_xz;
  const Scalar db_45_6r = t34 + s_5 * (t2 - s_6 * dmu_5_6_y);
  const Scalar db_46_5 = Scalar(0.0006623) * s_5 - t34;
  const Scalar c_5_4_6 = db_46_5 - db_45_6r;
  const Scalar C_65 = qd_2 * c_5_2_6 + qd_3 * c_5_3_6 - qd_1 * t23 - qd_4 * c_5_4_6 -
      qd_5 * db_55_6r;
  C[34] = C_65;
  const Scalar t35 = Scalar(2.0) * qd_6;
  C[29] = -C_65 - Iu_6_t_xz * t35;
  const Scalar t36 = c_4 * db_46_5 - s_4 * Iu_6_t_yz;
  const Scalar hu_6_t_x = Scalar(0.0035) * c_6 + Scalar(0.0056) * s_6;
  const Scalar f_u_6_4_t_y = c_4 * hu_6_t_x + hu_6_t_y * t29;
  const Scalar t37 = Scalar(0.45) * f_u_6_4_t_y;
  const Scalar t38 = t36 - t37;
  const Scalar mu_6_2_y = t37 - c_3 * mu_u_6_5_t_y + s_3 * t38;
  const Scalar t39 = c_2 * (c_3 * t38 + s_3 * mu_u_6_5_t_y) - s_2 * mu_6_2_y;
  const Scalar v_2_5_x = v_o_2_4_x * t7 + s_5 * t25;
  const Scalar t40 = s_4 * v_o_2_4_x;
  const Scalar v_2_6_y = c_6 * t40 + s_6 * v_2_5_x;
  const Scalar t41 = Scalar(0.0035) * (c_6 * v_2_5_x - s_6 * t40) + Scalar(0.0056) * v_2_6_y;
  const Scalar t42 = Scalar(0.0004972) * w_2_6_x + Scalar(0.000267) * t30;
  const Scalar t43 = t42 - t41;
  const Scalar t44 = Scalar(0.000256) * w_2_6_x - Scalar(0.0001273) * t30 + Scalar(0.0004972) * t15;
  const Scalar t45 = Scalar(0.0035) * t26 - t44;
  const Scalar t46 = Scalar(0.0001273) * w_2_6_x + Scalar(0.000256) * t30 - Scalar(0.000267) * t15;
  const Scalar t47 = Scalar(0.0056) * t26 - t46;
  const Scalar t48 = t19 * t43 + t11 * t45 + t12 * t47;
  const Scalar t49 = t39 - t48;
  const Scalar t50 = Scalar(0.0035) * w_2_6_x - Scalar(0.0056) * t30;
  const Scalar t51 = t14 * t50;
  const Scalar t52 = Scalar(0.0004972) * t11 - Scalar(0.000267) * t12 - t51;
  const Scalar t53 = t16 * (Scalar(0.0035) * t11 + Scalar(0.0056) * t12);
  const Scalar t54 = Scalar(0.0004972) * t19 - Scalar(0.000256) * t11 - Scalar(0.0001273) * t12 -
      Scalar(0.0035) * t16;
  const Scalar t55 = Scalar(0.000267) * t19 + Scalar(0.0001273) * t11 - Scalar(0.000256) * t12 +
      Scalar(0.0056) * t16;
  const Scalar t56 = t19 * (t51 - t52) + t53 - t11 * t54 + t12 * t55;
  const Scalar t57 = qd_1 * t56;
  const Scalar db_16_3 = w_1_3_x * mu_u_6_5_t_y + t8 * t38;
  const Scalar t58 = Scalar(0.001575) * t18 - t44;
  const Scalar t59 = Scalar(0.00252) * t18 - t46;
  const Scalar t60 = Scalar(0.45) * hu_6_t_x;
  const Scalar t61 = Scalar(0.45) * s_4;
  const Scalar t62 = hu_6_t_y * t61 + t7 * t60;
  const Scalar db_36_6 = t42 + t62;
  const Scalar t63 = t19 * db_36_6 + t11 * t58 + t12 * t59;
  const Scalar c_3_1_6 = db_16_3 - t63;
  const Scalar t64 = s_5 * (Iu_6_t_yz * t19 - hu_6_t_x * t16);
  const Scalar t65 = t64 - c_5 * t51 + t11 * dmu_4_6_x - t12 * dmu_4_6_y;
  const Scalar t66 = hu_6_t_y * t7 - s_4 * hu_6_t_x;
  const Scalar t67 = w_1_3_x * (c_4 * Iu_6_t_yz + s_4 * db_46_5) + t14 * t66;
  const Scalar t68 = t67 - t65;
  C[30] = t57 - qd_2 * t49 - qd_3 * c_3_1_6 + qd_4 * t68 - qd_5 * t23;
  const Scalar t69 = s_5 * Iu_6_t_yz;
  const Scalar t70 = w_2_6_x * dmu_4_6_x - t15 * t69 + t30 * dmu_4_6_y;
  const Scalar t71 = t70 - c_5 * t41 + s_5 * hu_6_t_x * t26;
  const Scalar t72 = t36 + v_o_2_4_x * f_u_6_4_t_y;
  const Scalar t73 = t72 + t71;
  const Scalar t74 = t70 + c_5 * t62 + s_5 * t18 * t60;
  const Scalar t75 = t38 + t74;
  const Scalar t76 = qd_3 * t75 - qd_4 * t6 + qd_1 * t68 + qd_2 * t73;
  C[33] = t76 - qd_5 * c_5_4_6;
  const Scalar t77 = t39 + t48;
  const Scalar c_1_3_6 = db_16_3 + t63;
  const Scalar t78 = t67 + t65;
  const Scalar t79 = t22 + t21;
  const Scalar t80 = t57 + qd_2 * t77 + qd_3 * c_1_3_6 - qd_4 * t78 + qd_5 * t79 - t52 * t35;
  C[5] = -t80;
  const Scalar t81 = t41 * t15 + t26 * t50;
  const Scalar t82 = t81 - t43 * t15 + w_2_6_x * t45 - t30 * t47;
  const Scalar t83 = qd_1 * t49 + qd_2 * t82;
  const Scalar t84 = w_2_6_x * t58 - db_36_6 * t15 - t30 * t59;
  const Scalar t85 = t81 + t84;
  const Scalar db_26_3 = s_5 * hu_6_t_y * t24 - t25 * t66;
  const Scalar c_2_3_6 = db_26_3 + t85;
  const Scalar t86 = t72 - t71;
  const Scalar c_2_5_6 = db_26_5 - t32;
  C[11] = t83 + qd_3 * c_2_3_6 + qd_4 * t86 + qd_5 * c_2_5_6 - t43 * t35;
  const Scalar c_3_2_6 = db_26_3 - t85;
  const Scalar t87 = Scalar(0.45) * c_4;
  const Scalar t88 = t84 - s_5 * (s_4 * t62 - t87 * t50);
  const Scalar t89 = qd_1 * c_3_1_6 - qd_2 * c_3_2_6 + qd_3 * t88;
  const Scalar t90 = t38 - t74;
  const Scalar c_3_5_6 = db_36_5 - db_35_6r;
  C[17] = t89 + qd_4 * t90 + qd_5 * c_3_5_6 - db_36_6 * t35;
  const Scalar c_4_5_6 = db_46_5 + db_45_6r;
  C[23] = t69 * t35 - t76 - qd_5 * c_4_5_6;
  const Scalar Ic_5_xz = t1 + Scalar(0.00050995);
  const Scalar Ic_5_yz = Iu_6_t_yz + Scalar(0.00080815);
  const Scalar Iu_5_t_xz = c_5 * Ic_5_xz + s_5 * Ic_5_yz;
  const Scalar t91 = c_4 * Iu_5_t_xz;
  const Scalar Ic_5_zz = t2 - Scalar(0.0080301);
  const Scalar t92 = t91 + s_4 * Ic_5_zz;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.01015);
  const Scalar hu_5_t_y = Scalar(0.01585) * c_5 - s_5 * hc_5_x;
  const Scalar t93 = hu_5_t_y * t61;
  const Scalar db_35_4 = t92 - t93;
  const Scalar t94 = c_5 * Ic_5_yz - s_5 * Ic_5_xz;
  const Scalar mu_5_2_y = t93 - c_3 * t94 + s_3 * db_35_4;
  const Scalar t95 = c_2 * (c_3 * db_35_4 + s_3 * t94) - s_2 * mu_5_2_y;
  const Scalar t96 = s_4 * dmu_4_5_y - c_4 * Ic_5_yz;
  const Scalar t97 = t96 - hc_5_x * t40;
  const Scalar t98 = s_4 * t3 + c_4 * Ic_5_xz;
  const Scalar t99 = Scalar(0.01585) * t40 - t98;
  const Scalar t100 = Scalar(0.01585) * t26 - hc_5_x * v_2_5_x;
  const Scalar t101 = s_4 * t94;
  const Scalar t102 = t100 - t101;
  const Scalar t103 = t10 * t102 - t9 * t97 - t19 * t99;
  const Scalar t104 = t95 - t103;
  const Scalar t105 = t96 + hc_5_x * t61;
  const Scalar dmu_3_5_y = Scalar(0.0071325) * s_4 + t98;
  const Scalar hu_5_t_x = Scalar(0.01585) * s_5 + c_5 * hc_5_x;
  const Scalar t106 = t101 - hu_5_t_x * t87;
  const Scalar t107 = t10 * t106 + t9 * t105 - t19 * dmu_3_5_y;
  const Scalar t108 = t94 * w_1_3_x + t8 * db_35_4;
  const Scalar t109 = t108 + t107;
  const Scalar t110 = s_4 * hu_5_t_x;
  const Scalar t111 = t14 * t110;
  const Scalar t112 = t111 + Ic_5_xz * t19 + Ic_5_yz * t9;
  const Scalar t113 = c_4 * t14;
  const Scalar t114 = t113 * (Scalar(0.01585) * t19 - hc_5_x * t9);
  const Scalar t115 = hc_5_x * t113 + Ic_5_yz * t10 - Iu_5_t_d * t19 + Ic_5_xy * t9;
  const Scalar t116 = Scalar(0.01585) * t113 - Ic_5_xz * t10 + Iu_5_t_d * t9 + Ic_5_xy * t19;
  const Scalar t117 = t10 * (t111 + t112) - t114 + t9 * t115 - t19 * t116;
  const Scalar t118 = qd_1 * t117;
  const Scalar t119 = Iu_5_t_xz * t10;
  const Scalar t120 = hu_5_t_y * t113;
  const Scalar t121 = t120 - t119 + t3 * t9 + t19 * dmu_4_5_y;
  const Scalar t122 = c_4 * Ic_5_zz * w_1_3_x - t120 - t119;
  const Scalar t123 = t122 + t121;
  C[24] = t118 - qd_2 * t104 - qd_3 * t109 - qd_4 * t123 + qd_6 * t23;
  const Scalar t124 = c_5 * t3;
  const Scalar t125 = t91 + s_4 * (t124 - s_5 * dmu_4_5_y);
  const Scalar db_34_5r = t93 + t125;
  const Scalar c_4_3_5 = db_35_4 + db_34_5r;
  const Scalar t126 = hu_5_t_y * t40;
  const Scalar t127 = t126 - t125;
  const Scalar db_25_4 = t92 + t126;
  const Scalar c_4_2_5 = db_25_4 - t127;
  const Scalar t128 = qd_3 * c_4_3_5 - qd_4 * t5 - qd_1 * t123 + qd_2 * c_4_2_5;
  C[27] = t128 + qd_6 * c_5_4_6;
  C[31] = qd_3 * c_3_2_6 - t83 + qd_4 * t73 + qd_5 * c_5_2_6;
  C[32] = qd_4 * t75 - t89 + qd_5 * c_5_3_6;
  const Scalar t129 = t95 + t103;
  const Scalar t130 = t108 - t107;
  const Scalar t131 = t122 - t121;
  const Scalar t132 = Scalar(2.0) * qd_5;
  const Scalar t133 = t118 + qd_2 * t129 + qd_3 * t130 + qd_4 * t131 + t112 * t132 + qd_6 * t79;
  C[4] = -t133;
  const Scalar Ic_4_yy = Ic_5_zz + Scalar(0.0161843);
  const Scalar Iu_4_t_d = Ic_4_yy + t124 - Scalar(0.0044257);
  const Scalar Ic_4_xy = Iu_5_t_xz - Scalar(0.0004868);
  const Scalar t134 = Scalar(2.0) * Ic_4_xy;
  const Scalar dmu_3_4_y = c_4 * t134 + s_4 * Iu_4_t_d;
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.10725);
  const Scalar t135 = dmu_3_4_y - hc_4_y * t25;
  const Scalar t136 = c_4 * Iu_4_t_d - s_4 * t134;
  const Scalar hc_4_x = hu_5_t_x + Scalar(0.0582);
  const Scalar t137 = t136 + hc_4_x * t25;
  const Scalar t138 = c_4 * hc_4_y - s_4 * hc_4_x;
  const Scalar db_22_4r = t138 * t25 - c_4 * t135 - s_4 * t137;
  const Scalar t139 = c_4 * t100 - t40 * t110;
  const Scalar t140 = t139 + s_4 * (c_5 * t97 - s_5 * t99) + c_4 * t102;
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * hc_4_y;
  const Scalar hc_3_x = hu_4_t_x - Scalar(0.13725);
  const Scalar hc_3_y = hu_5_t_y + Scalar(1.9154);
  const Scalar t141 = Scalar(0.9) * c_3;
  const Scalar t142 = hc_3_y * t141 - Scalar(0.9) * s_3 * hc_3_x;
  const Scalar t143 = qd_3 * t142;
  C[7] = qd_6 * t82 - t143 - qd_4 * db_22_4r - qd_5 * t140;
  const Scalar t144 = s_4 * (c_5 * t105 + s_5 * dmu_3_5_y) - c_4 * t106;
  const Scalar t145 = Scalar(0.45) * hu_5_t_x + t144;
  const Scalar t146 = s_4 * t136;
  const Scalar t147 = t146 + c_4 * dmu_3_4_y;
  const Scalar t148 = qd_4 * t147;
  C[14] = t148 - qd_5 * t145 + qd_6 * t88;
  C[22] = -t128 - Iu_5_t_xz * t132 - qd_6 * c_4_5_6;
  const Scalar t149 = t139 + t144;
  const Scalar t150 = hu_5_t_x * t24 - c_4 * hu_5_t_y * t25;
  const Scalar t151 = t150 - t149;
  const Scalar t152 = qd_1 * t104 - qd_2 * t140;
  const Scalar c_2_4_5 = db_25_4 + t127;
  C[10] = t152 + qd_3 * t151 + qd_4 * c_2_4_5 - t102 * t132 + qd_6 * c_2_5_6;
  const Scalar t153 = c_4 * t136;
  const Scalar Ic_4_xz = Iu_6_t_xz + t4 - Scalar(0.00500195);
  const Scalar t154 = t94 - Scalar(0.0261804);
  const Scalar t155 = c_4 * Ic_4_xz + s_4 * t154;
  const Scalar t156 = Scalar(0.45) * hu_4_t_x;
  const Scalar t157 = t155 + t156;
  const Scalar t158 = t157 * t8;
  const Scalar t159 = t158 + w_1_3_x * (t153 - s_4 * dmu_3_4_y);
  const Scalar Ic_4_zz = Iu_6_t_xx - t124 + Scalar(0.0285811);
  const Scalar t160 = Ic_4_zz * w_1_3_x - t158;
  const Scalar t161 = t160 - t159;
  const Scalar t162 = qd_3 * t147;
  const Scalar t163 = qd_2 * t147 + qd_1 * t161 + t162;
  const Scalar c_3_4_5 = db_35_4 - db_34_5r;
  const Scalar t164 = Scalar(2.0) * qd_4;
  C[15] = t163 - t157 * t164 + qd_5 * c_3_4_5 + qd_6 * t90;
  const Scalar t165 = t150 + t149;
  const Scalar t166 = qd_1 * t109 - qd_2 * t165 - qd_3 * t145;
  C[16] = t166 + qd_4 * c_3_4_5 + t106 * t132 + qd_6 * c_3_5_6;
  const Scalar t167 = c_4 * (w_1_3_x * dmu_3_4_y - t154 * t8);
  const Scalar t168 = w_1_3_x * (t167 + s_4 * (t136 * w_1_3_x + Ic_4_xz * t8));
  const Scalar t169 = c_4 * t154 - s_4 * Ic_4_xz;
  const Scalar t170 = t138 * t14;
  const Scalar t171 = t169 * w_1_3_x + t170;
  const Scalar t172 = t168 - t8 * (t170 + t171);
  const Scalar t173 = qd_1 * t172;
  const Scalar mu_4_2_y = t156 - c_3 * Ic_4_zz - s_3 * t157;
  const Scalar db_14_2 = c_2 * (c_3 * t157 - s_3 * Ic_4_zz) + s_2 * mu_4_2_y;
  const Scalar t174 = t155 - hu_4_t_x * v_o_2_4_x;
  const Scalar db_12_4r = w_1_3_x * (c_4 * t137 - s_4 * t135) + t8 * t174;
  const Scalar c_2_1_4 = db_14_2 + db_12_4r;
  C[18] = t173 + qd_2 * c_2_1_4 - qd_3 * t161 + qd_5 * t123 - qd_6 * t68;
  C[25] = qd_3 * t165 - t152 + qd_4 * c_4_2_5 - qd_6 * c_5_2_6;
  const Scalar Ic_3_xz = Ic_4_xy + t146 - Scalar(0.0080685);
  const Scalar t175 = Scalar(-0.45) * t138;
  const Scalar t176 = t169 - t175 - Scalar(0.0204192);
  const Scalar t177 = c_3 * Ic_3_xz + s_3 * t176;
  const Scalar t178 = c_3 * t176 - s_3 * Ic_3_xz;
  const Scalar t179 = c_2 * t177 + s_2 * t178;
  const Scalar t180 = Ic_3_xz * t8 + t176 * w_1_3_x;
  const Scalar t181 = t180 + t179;
  const Scalar Iu_3_t_d = Scalar(0.9) * hu_5_t_y - Ic_4_yy - Ic_4_zz + t153 + Scalar(0.96799115);
  const Scalar t182 = Scalar(2.0) * t157 + Scalar(0.026176);
  const Scalar t183 = w_1_3_x * (hc_3_x * t13 + Iu_3_t_d * t8 - t182 * w_1_3_x);
  const Scalar t184 = t8 * (hc_3_y * t13 - Iu_3_t_d * w_1_3_x - t182 * t8);
  const Scalar df_1_3_z = hc_3_x * w_1_3_x - hc_3_y * t8;
  const Scalar t185 = t13 * df_1_3_z + t183 - t184;
  const Scalar t186 = qd_1 * t185;
  const Scalar t187 = t160 + t159;
  C[2] = t186 - qd_2 * t181 - Scalar(2.0) * qd_3 * t180 - qd_4 * t187 - qd_5 * t130 -
      qd_6 * c_1_3_6;
  const Scalar c_1_2_4 = db_14_2 - db_12_4r;
  const Scalar t188 = t173 - qd_2 * c_1_2_4 + qd_3 * t187 - t171 * t164 + qd_5 * t131 - qd_6 * t78;
  C[3] = -t188;
  const Scalar t189 = qd_1 * c_2_1_4 + qd_2 * db_22_4r;
  C[19] = t189 - t162 - qd_5 * c_4_2_5 - qd_6 * t73;
  C[20] = -t163 - qd_5 * c_4_3_5 - qd_6 * t75;
  C[26] = qd_4 * c_4_3_5 - t166 - qd_6 * c_5_3_6;
  const Scalar t190 = t147 - t138 * t141;
  const Scalar t191 = t189 - qd_3 * t190 + t174 * t164 - qd_5 * c_2_4_5 - qd_6 * t86;
  C[9] = -t191;
  const Scalar t192 = t180 - t179;
  const Scalar t193 = t186 - qd_2 * t192 - qd_4 * t161 - qd_5 * t109 - qd_6 * c_3_1_6;
  C[12] = -t193;
  const Scalar t194 = qd_1 * t192 + qd_2 * t142;
  C[13] = t194 + t148 - qd_5 * t165 - qd_6 * c_3_2_6;
  C[8] = qd_4 * t190 - t143 - t194 + qd_5 * t151 + qd_6 * c_2_3_6;
  const Scalar t195 = Scalar(-2.0) * (c_3 * Iu_3_t_d - s_3 * t182);
  const Scalar hu_3_t_x = c_3 * hc_3_x + s_3 * hc_3_y;
  const Scalar t196 = Scalar(0.9) * hu_3_t_x - Iu_3_t_d - c_3 * t195 - Scalar(4.2001111);
  const Scalar t197 = t182 - t142 - s_3 * t195 + Scalar(0.0684948);
  const Scalar t198 = s_2 * (c_2 * t196 - s_2 * t197);
  const Scalar t199 = t198 + c_2 * (c_2 * t197 + s_2 * t196);
  C[0] = qd_2 * t199 + qd_3 * t185 - qd_4 * t172 - qd_5 * t117 - qd_6 * t56;
  const Scalar t200 = qd_1 * t199;
  const Scalar t201 = qd_2 * (c_2 * (t175 + t177 + Scalar(0.0549346)) +
      s_2 * (t178 + Scalar(0.0222188)));
  C[1] = t200 - Scalar(2.0) * t201 - qd_3 * t181 + qd_4 * c_1_2_4 - qd_5 * t129 - qd_6 * t77;
  const Scalar t202 = t200 + qd_3 * t192 + qd_4 * c_2_1_4 - qd_5 * t104 - qd_6 * t49;
  C[6] = -t202;
  C[35] = Scalar(0.0);
}

// gravity torques g(q) (7.39).
//   q[6]  in   joint positions, rad or m
//   g[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5]. Operations: 50 mul, 28 add, 10 sin/cos.
template <class Scalar>
inline void gravity(const Scalar* q, Scalar* g) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar t1 = Scalar(9.81) * c_2;
  const Scalar t2 = Scalar(9.81) * s_2;
  const Scalar ddp_3_x = s_3 * t1 + c_3 * t2;
  const Scalar t3 = c_4 * ddp_3_x;
  const Scalar t4 = s_3 * t2 - c_3 * t1;
  const Scalar t5 = s_5 * t4 - c_5 * t3;
  const Scalar t6 = s_4 * ddp_3_x;
  const Scalar t7 = s_6 * t6 + c_6 * t5;
  const Scalar g_6 = Scalar(0.0112) * t7 - Scalar(0.007) * (s_6 * t5 - c_6 * t6);
  g[5] = g_6;
  const Scalar t8 = s_5 * t3 + c_5 * t4;
  const Scalar t9 = Scalar(-0.0112) * t8;
  const Scalar t10 = Scalar(-0.007) * t8;
  const Scalar g_5 = Scalar(0.0317) * t5 - Scalar(0.0203) * t8 - s_6 * t9 - c_6 * t10;
  g[4] = g_5;
  const Scalar mu_5_y = Scalar(0.0203) * t6 - g_6;
  const Scalar mu_5_x = Scalar(0.0317) * t6 - s_6 * t10 + c_6 * t9;
  const Scalar mu_4_z = Scalar(0.2145) * t3 - Scalar(0.1164) * t6 - s_5 * mu_5_x + c_5 * mu_5_y;
  g[3] = -mu_4_z;
  const Scalar t11 = Scalar(0.2145) * t4 - s_5 * mu_5_y - c_5 * mu_5_x;
  const Scalar t12 = Scalar(0.1164) * t4 + g_5;
  const Scalar mu_3_z = Scalar(3.8308) * ddp_3_x + Scalar(0.2745) * t4 - s_4 * t11 - c_4 * t12;
  g[2] = -mu_3_z;
  g[1] = Scalar(194.232114) * c_2 + Scalar(4.102542) * s_2 - mu_3_z;
  const Scalar mu_u_4_t_x = s_4 * t12 - c_4 * t11;
  const Scalar mu_u_3_t_x = s_3 * mu_4_z + c_3 * mu_u_4_t_x;
  g[0] = s_2 * mu_u_3_t_x + c_2 * (s_3 * mu_u_4_t_x - c_3 * mu_4_z);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   n[6]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5], qd[0..5]. Operations: 227 mul, 197 add, 10 sin/cos.
template <class Scalar>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = qd_2 * qd_2;
  const Scalar U_2_xx = t1 * t1 + t2;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 - Scalar(0.45) * U_2_xx;
  const Scalar t3 = s_2 * qd_1;
  const Scalar t4 = t1 * t3;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 + Scalar(0.45) * t4;
  const Scalar ddp_3_x = c_3 * ddp_o_3_x + s_3 * ddp_o_3_y;
  const Scalar t5 = qd_1 * (c_2 * c_3 - s_2 * s_3);
  const Scalar t6 = qd_1 * (s_2 * c_3 + c_2 * s_3);
  const Scalar t7 = t5 * t6;
  const Scalar ddp_o_4_x = ddp_3_x + Scalar(0.45) * t7;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t8 = omega_3_z * t5;
  const Scalar t9 = qd_2 * t3;
  const Scalar t10 = Scalar(0.9) * t9 + Scalar(0.9) * t8;
  const Scalar t11 = c_4 * ddp_o_4_x - s_4 * t10;
  const Scalar t12 = c_3 * ddp_o_3_y - s_3 * ddp_o_3_x;
  const Scalar t13 = t6 * t6;
  const Scalar t14 = omega_3_z * omega_3_z;
  const Scalar U_3_yy = t14 + t13;
  const Scalar t15 = t12 - Scalar(0.45) * U_3_yy;
  const Scalar t16 = c_5 * t11 + s_5 * t15;
  const Scalar ddp_4_y = c_4 * t10 + s_4 * ddp_o_4_x;
  const Scalar t17 = c_6 * t16 - s_6 * ddp_4_y;
  const Scalar t18 = c_6 * ddp_4_y + s_6 * t16;
  const Scalar omega_r_4_y = c_4 * omega_3_z + s_4 * t6;
  const Scalar t19 = c_4 * t8 - qd_4 * omega_r_4_y;
  const Scalar t20 = c_4 * t6 - s_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 + t5;
  const Scalar omega_r_5_y = c_5 * omega_4_z - s_5 * t20;
  const Scalar t21 = omega_3_z * t6;
  const Scalar domega_5_x = c_5 * t19 - s_5 * t21 + qd_5 * omega_r_5_y;
  const Scalar omega_r_5_x = c_5 * t20 + s_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar t22 = c_6 * omega_r_5_x - s_6 * omega_5_z;
  const Scalar t23 = s_4 * t8 + qd_4 * t20;
  const Scalar t24 = c_6 * t23 + s_6 * domega_5_x + qd_6 * t22;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t25 = t22 * omega_6_z;
  const Scalar omega_r_6_y = c_6 * omega_5_z + s_6 * omega_r_5_x;
  const Scalar t26 = c_6 * domega_5_x - s_6 * t23 - qd_6 * omega_r_6_y;
  const Scalar t27 = omega_r_6_y * omega_6_z;
  const Scalar t28 = omega_r_6_y * omega_r_6_y;
  const Scalar t29 = omega_6_z * omega_6_z;
  const Scalar U_6_xx = t28 + t29;
  const Scalar t30 = t22 * t22;
  const Scalar U_6_yy = t29 + t30;
  const Scalar U_6_xx_yy = U_6_xx - U_6_yy;
  const Scalar t31 = t22 * omega_r_6_y;
  const Scalar domega_5_y = c_5 * t21 + s_5 * t19 + qd_5 * omega_r_5_x;
  const Scalar U_6_xy = domega_5_y - t31;
  const Scalar U_6_yx = domega_5_y + t31;
  const Scalar t32 = Scalar(0.0112) * t17 - Scalar(0.007) * t18 + Scalar(0.0007896) * U_6_xy -
      Scalar(0.0009944) * (t24 - t25) + Scalar(0.000535) * U_6_yx - Scalar(0.000534) * (t26 + t27) +
      Scalar(0.000256) * U_6_xx_yy;
  n[5] = -t32;
  const Scalar t33 = t24 + t25;
  const Scalar t34 = t26 - t27;
  const Scalar U_6_zz = t28 + t30;
  const Scalar U_6_zz_xx = U_6_xx - U_6_zz;
  const Scalar t35 = c_5 * t15 - s_5 * t11;
  const Scalar t36 = Scalar(0.007) * t35 + Scalar(0.0009944) * U_6_xy - Scalar(0.000535) * t33 +
      Scalar(0.000256) * t34 + Scalar(0.000534) * U_6_zz_xx;
  const Scalar U_6_yy_zz = U_6_yy - U_6_zz;
  const Scalar t37 = Scalar(0.0112) * t35 - Scalar(0.000534) * U_6_yx - Scalar(0.000256) * t33 +
      Scalar(0.0007896) * t34 + Scalar(0.0009944) * U_6_yy_zz;
  const Scalar t38 = omega_r_5_x * omega_5_z;
  const Scalar U_5_xz = domega_5_y - t38;
  const Scalar t39 = omega_r_5_y * omega_5_z;
  const Scalar U_5_yz = domega_5_x - t39;
  const Scalar t40 = omega_r_5_y * omega_r_5_y;
  const Scalar t41 = omega_5_z * omega_5_z;
  const Scalar U_5_xx = t40 + t41;
  const Scalar t42 = omega_r_5_x * omega_r_5_x;
  const Scalar U_5_yy = t41 + t42;
  const Scalar U_5_xx_yy = U_5_xx - U_5_yy;
  const Scalar t43 = omega_r_5_x * omega_r_5_y;
  const Scalar t44 = t23 - t43;
  const Scalar t45 = t23 + t43;
  const Scalar t46 = Scalar(0.0317) * t16 - Scalar(0.0203) * t35 - Scalar(0.0123285) * t44 +
      Scalar(0.0016163) * U_5_xz - Scalar(0.0029421) * t45 + Scalar(0.0007639) * U_5_yz +
      Scalar(0.0010857) * U_5_xx_yy + c_6 * t36 + s_6 * t37;
  n[4] = -t46;
  const Scalar U_5_zx = domega_5_y + t38;
  const Scalar U_5_zy = domega_5_x + t39;
  const Scalar U_5_zz = t40 + t42;
  const Scalar U_5_zz_xx = U_5_xx - U_5_zz;
  const Scalar mu_5_y = Scalar(0.0203) * ddp_4_y - Scalar(0.0016163) * t44 +
      Scalar(0.0029421) * U_5_zx - Scalar(0.0010857) * U_5_zy + Scalar(0.0007639) * U_5_zz_xx + t32;
  const Scalar U_5_yy_zz = U_5_yy - U_5_zz;
  const Scalar mu_5_x = Scalar(0.0317) * ddp_4_y - Scalar(0.0007639) * t45 -
      Scalar(0.0010857) * U_5_zx + Scalar(0.0123285) * U_5_zy - Scalar(0.0016163) * U_5_yy_zz +
      c_6 * t37 - s_6 * t36;
  const Scalar t47 = t20 * omega_4_z;
  const Scalar t48 = omega_r_4_y * omega_4_z;
  const Scalar t49 = omega_r_4_y * omega_r_4_y;
  const Scalar t50 = omega_4_z * omega_4_z;
  const Scalar U_4_xx = t49 + t50;
  const Scalar t51 = t20 * t20;
  const Scalar U_4_yy = t50 + t51;
  const Scalar U_4_xx_yy = U_4_xx - U_4_yy;
  const Scalar t52 = t20 * omega_r_4_y;
  const Scalar t53 = t52 - t21;
  const Scalar U_4_yx = t52 + t21;
  const Scalar t54 = Scalar(0.2145) * t11 - Scalar(0.1164) * ddp_4_y - Scalar(0.0316473) * t53 +
      Scalar(0.0523608) * (t23 - t47) + Scalar(0.0123968) * U_4_yx +
      Scalar(0.0110896) * (t19 + t48) - Scalar(0.0009736) * U_4_xx_yy + c_5 * mu_5_y - s_5 * mu_5_x;
  n[3] = -t54;
  const Scalar F_6_x = Scalar(0.007) * U_6_xx + Scalar(0.0112) * U_6_xy;
  const Scalar F_6_y = Scalar(0.007) * U_6_yx - Scalar(0.0112) * U_6_yy;
  const Scalar f_5_x = Scalar(0.0203) * U_5_xx + Scalar(0.0317) * t44 - c_6 * F_6_x + s_6 * F_6_y;
  const Scalar t55 = Scalar(0.0203) * t45 - Scalar(0.0317) * U_5_yy - Scalar(0.007) * t33 +
      Scalar(0.0112) * t34;
  const Scalar f_4_x = Scalar(0.1164) * U_4_xx - Scalar(0.2145) * t53 - c_5 * f_5_x - s_5 * t55;
  const Scalar f_4_y = Scalar(0.1164) * U_4_yx - Scalar(0.2145) * U_4_yy - Scalar(0.0203) * U_5_zx -
      Scalar(0.0317) * U_5_zy + c_6 * F_6_y + s_6 * F_6_x;
  const Scalar t56 = c_4 * f_4_x - s_4 * f_4_y;
  const Scalar t57 = t23 + t47;
  const Scalar t58 = t19 - t48;
  const Scalar U_4_zz = t49 + t51;
  const Scalar U_4_yy_zz = U_4_yy - U_4_zz;
  const Scalar t59 = Scalar(0.2145) * t15 + Scalar(0.0110896) * U_4_yx + Scalar(0.0009736) * t57 +
      Scalar(0.0316473) * t58 - Scalar(0.0523608) * U_4_yy_zz + c_5 * mu_5_x + s_5 * mu_5_y;
  const Scalar U_4_zz_xx = U_4_xx - U_4_zz;
  const Scalar t60 = Scalar(0.1164) * t15 + Scalar(0.0523608) * t53 - Scalar(0.0123968) * t57 -
      Scalar(0.0009736) * t58 - Scalar(0.0110896) * U_4_zz_xx + t46;
  const Scalar t61 = t5 * t5;
  const Scalar U_3_xx = t61 + t14;
  const Scalar U_3_xx_yy = U_3_xx - U_3_yy;
  const Scalar mu_3_z = Scalar(3.8308) * ddp_3_x - Scalar(0.2745) * t12 + Scalar(1.8912169) * t7 +
      Scalar(0.026176) * U_3_xx_yy + Scalar(0.45) * t56 + c_4 * t60 + s_4 * t59;
  n[2] = -mu_3_z;
  const Scalar t62 = Scalar(3.8308) * U_3_yy - Scalar(0.2745) * t7 + Scalar(0.1164) * t57 -
      Scalar(0.2145) * t58 - c_5 * t55 + s_5 * f_5_x;
  const Scalar t63 = c_3 * t62 + s_3 * (Scalar(0.2745) * U_3_xx - Scalar(3.8308) * t7 - t56);
  const Scalar U_2_yy = t2 + t3 * t3;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  n[1] = Scalar(194.232114) * c_2 + Scalar(4.102542) * s_2 + Scalar(8.4002222) * t4 -
      Scalar(0.0684948) * U_2_xx_yy - mu_3_z - Scalar(0.45) * t63;
  const Scalar f_u_4_t_y = c_4 * f_4_y + s_4 * f_4_x;
  const Scalar t64 = Scalar(0.45) * f_u_4_t_y;
  const Scalar U_3_zz = t61 + t13;
  const Scalar U_3_yy_zz = U_3_yy - U_3_zz;
  const Scalar t65 = Scalar(0.016137) * t7 + Scalar(3.44772) * t9 + Scalar(3.9306688) * t8 -
      Scalar(0.052352) * t21 + Scalar(0.0408384) * U_3_yy_zz + c_4 * t59 - s_4 * t60 - t64;
  const Scalar U_3_zz_xx = U_3_xx - U_3_zz;
  const Scalar t66 = Scalar(0.0408384) * t7 - Scalar(0.24705) * t9 + Scalar(0.052352) * t8 -
      Scalar(0.148235) * t21 + Scalar(0.016137) * U_3_zz_xx - t54;
  const Scalar t67 = qd_1 * qd_1;
  const Scalar t68 = qd_2 * t1;
  const Scalar t69 = Scalar(0.0444376) * t4 + Scalar(16.9546632) * t9 + Scalar(3.44772) * t8 +
      Scalar(0.24705) * t21 + Scalar(0.1098692) * (U_2_xx - t67) - t64 - Scalar(0.1369896) * t68 -
      c_3 * t66 - s_3 * t65;
  const Scalar t70 = Scalar(0.1098692) * t4 + Scalar(0.1369896) * t9 +
      Scalar(0.0444376) * (U_2_yy - t67) - c_3 * t65 + s_3 * t66 - Scalar(0.1542188) * t68;
  n[0] = -c_2 * t69 - s_2 * t70;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   tau[6]  in   joint torques or forces, N m or N
//   qdd[6]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns true, or false if the result means nothing: a pivot was not positive, or an input not a
// number.
// Reads q[1..5], qd[0..5], tau[0..5]. Operations: 427 mul, 370 add, 5 div, 10 sin/cos.
template <class Scalar>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau,
    Scalar* qdd) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar tau_1 = tau[0], tau_2 = tau[1], tau_3 = tau[2], tau_4 = tau[3], tau_5 = tau[4],
      tau_6 = tau[5];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = qd_2 * qd_2;
  const Scalar U_2_xx = t1 * t1 + t2;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 - Scalar(0.45) * U_2_xx;
  const Scalar t3 = s_2 * qd_1;
  const Scalar t4 = t1 * t3;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 + Scalar(0.45) * t4;
  const Scalar ddp_3_x = c_3 * ddp_o_3_x + s_3 * ddp_o_3_y;
  const Scalar t5 = qd_1 * (c_2 * c_3 - s_2 * s_3);
  const Scalar t6 = qd_1 * (s_2 * c_3 + c_2 * s_3);
  const Scalar t7 = t5 * t6;
  const Scalar ddp_o_4_x = ddp_3_x + Scalar(0.45) * t7;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t8 = omega_3_z * t5;
  const Scalar t9 = qd_2 * t3;
  const Scalar t10 = Scalar(0.9) * t9 + Scalar(0.9) * t8;
  const Scalar t11 = c_4 * ddp_o_4_x - s_4 * t10;
  const Scalar t12 = c_3 * ddp_o_3_y - s_3 * ddp_o_3_x;
  const Scalar t13 = t6 * t6;
  const Scalar t14 = omega_3_z * omega_3_z;
  const Scalar U_3_yy = t14 + t13;
  const Scalar t15 = t12 - Scalar(0.45) * U_3_yy;
  const Scalar t16 = c_5 * t11 + s_5 * t15;
  const Scalar ddp_4_y = c_4 * t10 + s_4 * ddp_o_4_x;
  const Scalar t17 = c_6 * t16 - s_6 * ddp_4_y;
  const Scalar t18 = c_6 * ddp_4_y + s_6 * t16;
  const Scalar omega_r_4_y = c_4 * omega_3_z + s_4 * t6;
  const Scalar t19 = c_4 * t8 - qd_4 * omega_r_4_y;
  const Scalar t20 = c_4 * t6 - s_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 + t5;
  const Scalar omega_r_5_y = c_5 * omega_4_z - s_5 * t20;
  const Scalar t21 = omega_3_z * t6;
  const Scalar domega_5_x = c_5 * t19 - s_5 * t21 + qd_5 * omega_r_5_y;
  const Scalar omega_r_5_x = c_5 * t20 + s_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar t22 = c_6 * omega_r_5_x - s_6 * omega_5_z;
  const Scalar t23 = s_4 * t8 + qd_4 * t20;
  const Scalar t24 = c_6 * t23 + s_6 * domega_5_x + qd_6 * t22;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t25 = t22 * omega_6_z;
  const Scalar omega_r_6_y = c_6 * omega_5_z + s_6 * omega_r_5_x;
  const Scalar t26 = c_6 * domega_5_x - s_6 * t23 - qd_6 * omega_r_6_y;
  const Scalar t27 = omega_r_6_y * omega_6_z;
  const Scalar t28 = omega_r_6_y * omega_r_6_y;
  const Scalar t29 = omega_6_z * omega_6_z;
  const Scalar U_6_xx = t28 + t29;
  const Scalar t30 = t22 * t22;
  const Scalar U_6_yy = t29 + t30;
  const Scalar U_6_xx_yy = U_6_xx - U_6_yy;
  const Scalar t31 = t22 * omega_r_6_y;
  const Scalar domega_5_y = c_5 * t21 + s_5 * t19 + qd_5 * omega_r_5_x;
  const Scalar U_6_xy = domega_5_y - t31;
  const Scalar U_6_yx = domega_5_y + t31;
  const Scalar t32 = Scalar(0.0112) * t17 - Scalar(0.007) * t18 + Scalar(0.0007896) * U_6_xy -
      Scalar(0.0009944) * (t24 - t25) + Scalar(0.000535) * U_6_yx - Scalar(0.000534) * (t26 + t27) +
      Scalar(0.000256) * U_6_xx_yy;
  const Scalar y_6 = tau_6 + t32;
  const Scalar Iu_6_t_yz = Scalar(0.0009944) * c_6 - Scalar(0.000534) * s_6;
  const Scalar t33 = Scalar(754.9448890231013) * Iu_6_t_yz;
  const Scalar t34 = t24 + t25;
  const Scalar t35 = t26 - t27;
  const Scalar U_6_zz = t28 + t30;
  const Scalar U_6_zz_xx = U_6_xx - U_6_zz;
  const Scalar t36 = c_5 * t15 - s_5 * t11;
  const Scalar t37 = Scalar(0.007) * t36 + Scalar(0.0009944) * U_6_xy - Scalar(0.000535) * t34 +
      Scalar(0.000256) * t35 + Scalar(0.000534) * U_6_zz_xx;
  const Scalar U_6_yy_zz = U_6_yy - U_6_zz;
  const Scalar t38 = Scalar(0.0112) * t36 - Scalar(0.000534) * U_6_yx - Scalar(0.000256) * t34 +
      Scalar(0.0007896) * t35 + Scalar(0.0009944) * U_6_yy_zz;
  const Scalar t39 = omega_r_5_x * omega_5_z;
  const Scalar U_5_xz = domega_5_y - t39;
  const Scalar t40 = omega_r_5_y * omega_5_z;
  const Scalar U_5_yz = domega_5_x - t40;
  const Scalar t41 = omega_r_5_y * omega_r_5_y;
  const Scalar t42 = omega_5_z * omega_5_z;
  const Scalar U_5_xx = t41 + t42;
  const Scalar t43 = omega_r_5_x * omega_r_5_x;
  const Scalar U_5_yy = t42 + t43;
  const Scalar U_5_xx_yy = U_5_xx - U_5_yy;
  const Scalar t44 = omega_r_5_x * omega_r_5_y;
  const Scalar t45 = t23 - t44;
  const Scalar t46 = t23 + t44;
  const Scalar t47 = Scalar(0.0317) * t16 - Scalar(0.0203) * t36 - Scalar(0.0123285) * t45 +
      Scalar(0.0016163) * U_5_xz - Scalar(0.0029421) * t46 + Scalar(0.0007639) * U_5_yz +
      Scalar(0.0010857) * U_5_xx_yy + c_6 * t37 + s_6 * t38;
  const Scalar y_6_5 = tau_5 + t47 - y_6 * t33;
  const Scalar Iu_6_t_g = Scalar(0.0002546) * c_6 - Scalar(0.000512) * s_6;
  const Scalar Ic_5_xz = s_6 * Iu_6_t_g + Scalar(0.0010199);
  const Scalar Ic_5_yz = Iu_6_t_yz + Scalar(0.0016163);
  const Scalar t48 = c_5 * Ic_5_yz - s_5 * Ic_5_xz;
  const Scalar Iu_6_t_xz = Scalar(0.000534) * c_6 + Scalar(0.0009944) * s_6;
  const Scalar mu_u_6_5_t_y = Scalar(0.0013246) * c_5 + s_5 * Iu_6_t_xz;
  const Scalar t49 = t48 - mu_u_6_5_t_y * t33;
  const Scalar t50 = c_6 * Iu_6_t_g;
  const Scalar Ic_5_zz = t50 - Scalar(0.0160602);
  const Scalar b_6_5_5 = Ic_5_zz + Iu_6_t_yz * t33;
  const Scalar d_5 = Scalar(1.0) / b_6_5_5;
  const Scalar t51 = t49 * d_5;
  const Scalar U_5_zx = domega_5_y + t39;
  const Scalar U_5_zy = domega_5_x + t40;
  const Scalar U_5_zz = t41 + t43;
  const Scalar U_5_zz_xx = U_5_xx - U_5_zz;
  const Scalar mu_5_y = Scalar(0.0203) * ddp_4_y - Scalar(0.0016163) * t45 +
      Scalar(0.0029421) * U_5_zx - Scalar(0.0010857) * U_5_zy + Scalar(0.0007639) * U_5_zz_xx + t32;
  const Scalar U_5_yy_zz = U_5_yy - U_5_zz;
  const Scalar mu_5_x = Scalar(0.0317) * ddp_4_y - Scalar(0.0007639) * t46 -
      Scalar(0.0010857) * U_5_zx + Scalar(0.0123285) * U_5_zy - Scalar(0.0016163) * U_5_yy_zz +
      c_6 * t38 - s_6 * t37;
  const Scalar t52 = t20 * omega_4_z;
  const Scalar t53 = omega_r_4_y * omega_4_z;
  const Scalar t54 = omega_r_4_y * omega_r_4_y;
  const Scalar t55 = omega_4_z * omega_4_z;
  const Scalar U_4_xx = t54 + t55;
  const Scalar t56 = t20 * t20;
  const Scalar U_4_yy = t55 + t56;
  const Scalar U_4_xx_yy = U_4_xx - U_4_yy;
  const Scalar t57 = t20 * omega_r_4_y;
  const Scalar t58 = t57 - t21;
  const Scalar U_4_yx = t57 + t21;
  const Scalar t59 = Scalar(0.2145) * t11 - Scalar(0.1164) * ddp_4_y - Scalar(0.0316473) * t58 +
      Scalar(0.0523608) * (t23 - t52) + Scalar(0.0123968) * U_4_yx +
      Scalar(0.0110896) * (t19 + t53) - Scalar(0.0009736) * U_4_xx_yy + c_5 * mu_5_y - s_5 * mu_5_x;
  const Scalar t60 = Scalar(754.9448890231013) * mu_u_6_5_t_y;
  const Scalar y_5_4 = tau_4 + t59 - y_6 * t60 + t51 * y_6_5;
  const Scalar Ic_5_xx = t50 + Scalar(0.0128635);
  const Scalar Iu_5_t_d = Ic_5_xx - Scalar(0.0042667);
  const Scalar Ic_5_xy = Iu_6_t_xz + Scalar(0.0010857);
  const Scalar t61 = c_5 * Iu_5_t_d - Scalar(2.0) * s_5 * Ic_5_xy;
  const Scalar Ic_4_xz = Ic_5_xy + s_5 * t61 - Scalar(0.0110896);
  const Scalar hu_6_t_x = Scalar(0.007) * c_6 + Scalar(0.0112) * s_6;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.0203);
  const Scalar hu_5_t_x = Scalar(0.0317) * s_5 + c_5 * hc_5_x;
  const Scalar hc_4_x = hu_5_t_x + Scalar(0.1164);
  const Scalar hu_6_t_y = Scalar(0.0112) * c_6 - Scalar(0.007) * s_6;
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.2145);
  const Scalar t62 = Scalar(-0.45) * (c_4 * hc_4_y - s_4 * hc_4_x);
  const Scalar t63 = t48 - Scalar(0.0523608);
  const Scalar t64 = c_4 * t63 - s_4 * Ic_4_xz - t62;
  const Scalar hu_5_t_y = Scalar(0.0317) * c_5 - s_5 * hc_5_x;
  const Scalar t65 = Scalar(0.45) * hu_5_t_y;
  const Scalar t66 = Ic_5_zz - t65;
  const Scalar Iu_5_t_xz = c_5 * Ic_5_xz + s_5 * Ic_5_yz;
  const Scalar t67 = s_4 * Iu_5_t_xz - c_4 * t66;
  const Scalar t68 = c_5 * hu_6_t_y;
  const Scalar t69 = c_4 * t68 - s_4 * hu_6_t_x;
  const Scalar mu_u_6_5_t_x = Scalar(0.0013246) * s_5 - c_5 * Iu_6_t_xz;
  const Scalar t70 = Scalar(0.45) * t69 + c_4 * Iu_6_t_yz + s_4 * mu_u_6_5_t_x;
  const Scalar t71 = t67 - t70 * t33;
  const Scalar t72 = t64 - t70 * t60 + t71 * t51;
  const Scalar t73 = c_5 * t61;
  const Scalar Ic_4_zz = Ic_5_xx - t73 + Scalar(0.0440441);
  const Scalar b_5_4_4 = Ic_4_zz - mu_u_6_5_t_y * t60 + t49 * t51;
  const Scalar d_4 = Scalar(1.0) / b_5_4_4;
  const Scalar t74 = t72 * d_4;
  const Scalar F_6_x = Scalar(0.007) * U_6_xx + Scalar(0.0112) * U_6_xy;
  const Scalar F_6_y = Scalar(0.007) * U_6_yx - Scalar(0.0112) * U_6_yy;
  const Scalar f_5_x = Scalar(0.0203) * U_5_xx + Scalar(0.0317) * t45 - c_6 * F_6_x + s_6 * F_6_y;
  const Scalar t75 = Scalar(0.0203) * t46 - Scalar(0.0317) * U_5_yy - Scalar(0.007) * t34 +
      Scalar(0.0112) * t35;
  const Scalar f_4_x = Scalar(0.1164) * U_4_xx - Scalar(0.2145) * t58 - c_5 * f_5_x - s_5 * t75;
  const Scalar f_4_y = Scalar(0.1164) * U_4_yx - Scalar(0.2145) * U_4_yy - Scalar(0.0203) * U_5_zx -
      Scalar(0.0317) * U_5_zy + c_6 * F_6_y + s_6 * F_6_x;
  const Scalar t76 = c_4 * f_4_x - s_4 * f_4_y;
  const Scalar t77 = t23 + t52;
  const Scalar t78 = t19 - t53;
  const Scalar U_4_zz = t54 + t56;
  const Scalar U_4_yy_zz = U_4_yy - U_4_zz;
  const Scalar t79 = Scalar(0.2145) * t15 + Scalar(0.0110896) * U_4_yx + Scalar(0.0009736) * t77 +
      Scalar(0.0316473) * t78 - Scalar(0.0523608) * U_4_yy_zz + c_5 * mu_5_x + s_5 * mu_5_y;
  const Scalar U_4_zz_xx = U_4_xx - U_4_zz;
  const Scalar t80 = Scalar(0.1164) * t15 + Scalar(0.0523608) * t58 - Scalar(0.0123968) * t77 -
      Scalar(0.0009736) * t78 - Scalar(0.0110896) * U_4_zz_xx + t47;
  const Scalar t81 = t5 * t5;
  const Scalar U_3_xx = t81 + t14;
  const Scalar U_3_xx_yy = U_3_xx - U_3_yy;
  const Scalar mu_3_z = Scalar(3.8308) * ddp_3_x - Scalar(0.2745) * t12 + Scalar(1.8912169) * t7 +
      Scalar(0.026176) * U_3_xx_yy + Scalar(0.45) * t76 + c_4 * t80 + s_4 * t79;
  const Scalar t82 = t71 * d_5;
  const Scalar t83 = Scalar(-754.9448890231013) * t70;
  const Scalar y_4_3 = tau_3 + mu_3_z + y_6 * t83 + t82 * y_6_5 - t74 * y_5_4;
  const Scalar t84 = t73 + Scalar(0.035914);
  const Scalar Ic_4_yy = Ic_5_zz - Scalar(0.0123968);
  const Scalar Ic_4_xy = Iu_5_t_xz - Scalar(0.0009736);
  const Scalar t85 = c_4 * (t84 + Ic_4_yy) - Scalar(2.0) * s_4 * Ic_4_xy;
  const Scalar t86 = c_4 * t85;
  const Scalar t87 = Scalar(0.9) * hu_5_t_y;
  const Scalar t88 = t84 - t86 + t87 + Scalar(2.0394519);
  const Scalar b_4_3_3 = t88 + t70 * t83 + t71 * t82 - t72 * t74;
  const Scalar t89 = Scalar(1.0) / b_4_3_3;
  const Scalar t90 = t70 - Scalar(0.45) * (c_3 * s_5 * hu_6_t_y + s_3 * t69);
  const Scalar f_u_5_3_t_y = c_3 * hu_5_t_x + s_3 * c_4 * hu_5_t_y;
  const Scalar t91 = t67 - Scalar(0.45) * f_u_5_3_t_y - t90 * t33;
  const Scalar t92 = t64 + s_3 * t62 - t90 * t60 + t91 * t51;
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * hc_4_y;
  const Scalar hc_3_x = hu_4_t_x - Scalar(0.2745);
  const Scalar hc_3_y = hu_5_t_y + Scalar(3.8308);
  const Scalar hu_3_t_x = c_3 * hc_3_x + s_3 * hc_3_y;
  const Scalar t93 = t88 - Scalar(0.45) * hu_3_t_x + t90 * t83 + t91 * t82 - t92 * t74;
  const Scalar t94 = t93 * t89;
  const Scalar t95 = Scalar(3.8308) * U_3_yy - Scalar(0.2745) * t7 + Scalar(0.1164) * t77 -
      Scalar(0.2145) * t78 - c_5 * t75 + s_5 * f_5_x;
  const Scalar t96 = c_3 * t95 + s_3 * (Scalar(0.2745) * U_3_xx - Scalar(3.8308) * t7 - t76);
  const Scalar t97 = t92 * d_4;
  const Scalar t98 = t91 * d_5;
  const Scalar t99 = Scalar(-754.9448890231013) * t90;
  const Scalar U_2_yy = t2 + t3 * t3;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  const Scalar t100 = Scalar(194.232114) * c_2 + Scalar(4.102542) * s_2 - tau_2 +
      Scalar(8.4002222) * t4 - Scalar(0.0684948) * U_2_xx_yy - mu_3_z - Scalar(0.45) * t96 -
      y_6 * t99 - t98 * y_6_5 + t97 * y_5_4 + t94 * y_4_3;
  const Scalar Ic_3_xz = Ic_4_xy + s_4 * t85 - Scalar(0.016137);
  const Scalar t101 = t64 - Scalar(0.0408384);
  const Scalar t102 = c_3 * t101 - s_3 * Ic_3_xz;
  const Scalar t103 = c_3 * Ic_3_xz + s_3 * t101;
  const Scalar t104 = Scalar(0.45) * hu_4_t_x;
  const Scalar t105 = c_4 * Ic_4_xz + s_4 * t63 + t104;
  const Scalar mu_4_2_y = t104 - c_3 * Ic_4_zz - s_3 * t105;
  const Scalar t106 = s_2 * (c_3 * t105 - s_3 * Ic_4_zz);
  const Scalar t107 = c_4 * Iu_5_t_xz + s_4 * t66;
  const Scalar mu_5_2_y = s_4 * t65 - c_3 * t48 + s_3 * t107;
  const Scalar t108 = s_2 * (c_3 * t107 + s_3 * t48);
  const Scalar f_u_6_4_t_y = c_4 * hu_6_t_x + s_4 * t68;
  const Scalar t109 = Scalar(0.45) * f_u_6_4_t_y;
  const Scalar t110 = c_4 * mu_u_6_5_t_x - s_4 * Iu_6_t_yz - t109;
  const Scalar mu_6_2_y = t109 - c_3 * mu_u_6_5_t_y + s_3 * t110;
  const Scalar mu_u_6_2_t_y = c_2 * mu_6_2_y + s_2 * (c_3 * t110 + s_3 * mu_u_6_5_t_y);
  const Scalar t111 = c_2 * mu_5_2_y + t108 - mu_u_6_2_t_y * t33;
  const Scalar b_5_4_1 = c_2 * mu_4_2_y - t106 - mu_u_6_2_t_y * t60 + t111 * t51;
  const Scalar t112 = c_2 * t102 - s_2 * t103 - mu_u_6_2_t_y * t83 - t111 * t82 + b_5_4_1 * t74;
  const Scalar t113 = s_2 * (t62 + t103 + Scalar(0.1098692));
  const Scalar b_3_2_1 = c_2 * (t102 + Scalar(0.0444376)) - t113 - mu_u_6_2_t_y * t99 - t111 * t98 +
      b_5_4_1 * t97 - t112 * t94;
  const Scalar t114 = Scalar(0.9) * hu_3_t_x;
  const Scalar b_3_2_2 = t88 - t114 + t90 * t99 + t91 * t98 - t92 * t97 - t93 * t94 +
      Scalar(8.554441);
  const Scalar t115 = Scalar(1.0) / b_3_2_2;
  const Scalar t116 = b_3_2_1 * t115;
  const Scalar f_u_4_t_y = c_4 * f_4_y + s_4 * f_4_x;
  const Scalar t117 = Scalar(0.45) * f_u_4_t_y;
  const Scalar U_3_zz = t81 + t13;
  const Scalar U_3_yy_zz = U_3_yy - U_3_zz;
  const Scalar t118 = Scalar(0.016137) * t7 + Scalar(3.44772) * t9 + Scalar(3.9306688) * t8 -
      Scalar(0.052352) * t21 + Scalar(0.0408384) * U_3_yy_zz + c_4 * t79 - s_4 * t80 - t117;
  const Scalar U_3_zz_xx = U_3_xx - U_3_zz;
  const Scalar t119 = Scalar(0.0408384) * t7 - Scalar(0.24705) * t9 + Scalar(0.052352) * t8 -
      Scalar(0.148235) * t21 + Scalar(0.016137) * U_3_zz_xx - t59;
  const Scalar t120 = qd_1 * qd_1;
  const Scalar t121 = qd_2 * t1;
  const Scalar t122 = Scalar(0.0444376) * t4 + Scalar(16.9546632) * t9 + Scalar(3.44772) * t8 +
      Scalar(0.24705) * t21 + Scalar(0.1098692) * (U_2_xx - t120) - t117 -
      Scalar(0.1369896) * t121 - c_3 * t119 - s_3 * t118;
  const Scalar t123 = Scalar(0.1098692) * t4 + Scalar(0.1369896) * t9 +
      Scalar(0.0444376) * (U_2_yy - t120) - c_3 * t118 + s_3 * t119 - Scalar(0.1542188) * t121;
  const Scalar t124 = t112 * t89;
  const Scalar t125 = b_5_4_1 * d_4;
  const Scalar t126 = t111 * d_5;
  const Scalar t127 = Scalar(754.9448890231013) * mu_u_6_2_t_y;
  const Scalar y_2_1 = tau_1 + c_2 * t122 + s_2 * t123 + y_6 * t127 - t126 * y_6_5 + t125 * y_5_4 -
      t124 * y_4_3 + t116 * t100;
  const Scalar t128 = Ic_4_yy - t86 - t87 - Scalar(1.9653344);
  const Scalar Ic_3_yy = Ic_4_zz + Scalar(0.0741175);
  const Scalar t129 = t105 + Scalar(0.026176);
  const Scalar t130 = c_3 * (t128 + Ic_3_yy) + Scalar(2.0) * s_3 * t129;
  const Scalar t131 = c_3 * t130;
  const Scalar Ic_2_xx = Ic_3_yy - t131 + Scalar(0.0771094);
  const Scalar t132 = c_3 * hc_3_y - s_3 * hc_3_x;
  const Scalar t133 = s_2 * (t129 - Scalar(0.45) * t132 - s_3 * t130 + Scalar(0.0684948));
  const Scalar t134 = c_2 * (t128 - t131 + Ic_2_xx + t114 - Scalar(8.4773316)) - Scalar(2.0) * t133;
  const Scalar b_2_1_1 = Ic_2_xx - c_2 * t134 - mu_u_6_2_t_y * t127 + t111 * t126 - b_5_4_1 * t125 -
      t112 * t124 - b_3_2_1 * t116 + Scalar(0.8059476);
  const Scalar d_1 = Scalar(1.0) / b_2_1_1;
  const Scalar qdd_1 = d_1 * y_2_1;
  qdd[0] = qdd_1;
  const Scalar t135 = t115 * (t100 + b_3_2_1 * qdd_1);
  qdd[1] = -t135;
  const Scalar qdd_3 = t89 * (y_4_3 + t93 * t135 - t112 * qdd_1);
  qdd[2] = qdd_3;
  const Scalar qdd_4 = d_4 * (y_5_4 + t92 * t135 + b_5_4_1 * qdd_1 - t72 * qdd_3);
  qdd[3] = qdd_4;
  const Scalar t136 = y_6_5 - t49 * qdd_4 + t111 * qdd_1 - t71 * qdd_3 + t91 * t135;
  const Scalar t137 = d_5 * t136;
  qdd[4] = -t137;
  const Scalar t138 = y_6 - mu_u_6_5_t_y * qdd_4 - t70 * qdd_3 + Iu_6_t_yz * t137;
  qdd[5] = Scalar(754.9448890231013) * t138 +
      Scalar(754.9448890231013) * (t90 * t135 + mu_u_6_2_t_y * qdd_1);
  bool positive = b_2_1_1 > Scalar(0.0);
  positive &= b_3_2_2 > Scalar(0.0);
  positive &= b_4_3_3 > Scalar(0.0);
  positive &= b_5_4_4 > Scalar(0.0);
  positive &= -b_6_5_5 > Scalar(0.0);
  return positive;
}

// kinetic energy of links and rotors (7.31).
//   q[6]   in  joint positions, rad or m
//   qd[6]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1..5], qd[0..5]. Operations: 111 mul, 76 add, 10 sin/cos.
template <class Scalar>
inline Scalar kinetic_energy(const Scalar* q, const Scalar* qd) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = s_2 * qd_1;
  const Scalar omega_r_3_x = s_3 * t1 + c_3 * t2;
  const Scalar v_o_4_z = Scalar(0.45) * t1 - Scalar(0.45) * omega_r_3_x;
  const Scalar t3 = s_3 * qd_2;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t4 = Scalar(0.45) * omega_3_z - Scalar(0.45) * t3;
  const Scalar v_r_4_x = s_4 * v_o_4_z - c_4 * t4;
  const Scalar t5 = c_3 * qd_2;
  const Scalar t6 = Scalar(0.45) * t5;
  const Scalar v_r_5_x = s_5 * t6 + c_5 * v_r_4_x;
  const Scalar v_r_4_y = s_4 * t4 + c_4 * v_o_4_z;
  const Scalar v_r_6_x = s_6 * v_r_4_y + c_6 * v_r_5_x;
  const Scalar t7 = s_6 * v_r_5_x - c_6 * v_r_4_y;
  const Scalar t8 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar t9 = s_3 * t2 - c_3 * t1;
  const Scalar t10 = t9 - qd_4;
  const Scalar t11 = s_5 * t10 + c_5 * t8;
  const Scalar omega_r_4_y = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar omega_5_z = omega_r_4_y + qd_5;
  const Scalar t12 = s_6 * omega_5_z + c_6 * t11;
  const Scalar t13 = s_6 * t11 - c_6 * omega_5_z;
  const Scalar omega_r_5_y = s_5 * t8 - c_5 * t10;
  const Scalar omega_6_z = omega_r_5_y + qd_6;
  const Scalar t14 = Scalar(0.000534) * t12 + Scalar(0.0009944) * t13 + Scalar(0.0224) * v_r_6_x -
      Scalar(0.014) * t7 - Scalar(0.0013246) * omega_6_z;
  const Scalar t15 = s_5 * v_r_4_x - c_5 * t6;
  const Scalar t16 = t13 * (Scalar(0.014) * t15 + Scalar(0.000256) * t12 +
      Scalar(0.0009944) * omega_6_z);
  const Scalar t17 = Scalar(0.0224) * t15 + Scalar(0.0002546) * t12 - Scalar(0.000256) * t13 -
      Scalar(0.000534) * omega_6_z;
  const Scalar t18 = Scalar(0.0007639) * t11 + Scalar(0.0016163) * omega_r_5_y -
      Scalar(0.0634) * v_r_5_x - Scalar(0.0406) * t15 + Scalar(0.0158056) * omega_5_z;
  const Scalar L_5_y = Scalar(0.0406) * v_r_4_y - Scalar(0.0010857) * t11 +
      Scalar(0.0016163) * omega_5_z;
  const Scalar L_5_x = Scalar(0.0634) * v_r_4_y + Scalar(0.0099214) * t11 -
      Scalar(0.0010857) * omega_r_5_y + Scalar(0.0007639) * omega_5_z;
  const Scalar t19 = Scalar(0.0110896) * t8 - Scalar(0.0523608) * omega_r_4_y -
      Scalar(0.429) * v_r_4_x - Scalar(0.2328) * v_r_4_y - Scalar(0.0469862) * t10;
  const Scalar L_4_y = Scalar(0.10476) * t5 + Scalar(0.0009736) * t8 - Scalar(0.0523608) * t10;
  const Scalar L_4_x = Scalar(0.19305) * t5 - Scalar(0.0221926) * t8 +
      Scalar(0.0009736) * omega_r_4_y + Scalar(0.0110896) * t10;
  const Scalar L_3_z = Scalar(0.016137) * omega_r_3_x + Scalar(0.0408384) * t9 +
      Scalar(2.0518487) * omega_3_z + Scalar(0.24705) * t5 - Scalar(3.44772) * t3;
  const Scalar L_3_y = Scalar(0.24705) * t1 + Scalar(0.026176) * omega_r_3_x -
      Scalar(0.0408384) * omega_3_z;
  const Scalar L_3_x = Scalar(3.44772) * t1 - Scalar(1.9036137) * omega_r_3_x +
      Scalar(0.026176) * t9 - Scalar(0.016137) * omega_3_z;
  const Scalar L_2_y = Scalar(0.0444376) * qd_2 + Scalar(0.0684948) * t2;
  const Scalar L_2_x = Scalar(0.1098692) * qd_2 - Scalar(0.0684948) * t1 + Scalar(8.4002222) * t2;
  const Scalar L_2_z = Scalar(8.554441) * qd_2 + Scalar(0.0444376) * t1 - Scalar(0.1098692) * t2;
  const Scalar t20 = omega_6_z * t14 + t16 - t12 * t17 - omega_5_z * t18 - omega_r_5_y * L_5_y -
      t11 * L_5_x + t10 * t19 + omega_r_4_y * L_4_y + t8 * L_4_x - omega_3_z * L_3_z + t9 * L_3_y +
      omega_r_3_x * L_3_x - t1 * L_2_y + t2 * L_2_x - qd_2 * L_2_z -
      Scalar(9.3573967) * qd_1 * qd_1;
  return Scalar(-0.5) * t20;
}

// potential energy of links and rotors (7.36).
//   q[6]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[1..5]. Operations: 17 mul, 16 add, 10 sin/cos.
template <class Scalar>
inline Scalar potential_energy(const Scalar* q) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar hu_6_t_x = Scalar(0.007) * c_6 + Scalar(0.0112) * s_6;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.0203);
  const Scalar hu_5_t_x = Scalar(0.0317) * s_5 + c_5 * hc_5_x;
  const Scalar hc_4_x = hu_5_t_x + Scalar(0.1164);
  const Scalar hu_6_t_y = Scalar(0.0112) * c_6 - Scalar(0.007) * s_6;
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.2145);
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * hc_4_y;
  const Scalar hc_3_x = hu_4_t_x - Scalar(0.2745);
  const Scalar hu_5_t_y = Scalar(0.0317) * c_5 - s_5 * hc_5_x;
  const Scalar hc_3_y = hu_5_t_y + Scalar(3.8308);
  const Scalar hu_3_t_y = c_3 * hc_3_y - s_3 * hc_3_x;
  const Scalar hc_2_y = hu_3_t_y - Scalar(0.4182);
  const Scalar hu_3_t_x = c_3 * hc_3_x + s_3 * hc_3_y;
  const Scalar hc_2_x = hu_3_t_x - Scalar(19.7994);
  const Scalar hu_2_t_y = c_2 * hc_2_y - s_2 * hc_2_x;
  const Scalar hc_0_z = hu_2_t_y - Scalar(3.6816);
  return Scalar(9.81) * hc_0_z;
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    1, 1, 1,
    1, 1, 1,
    1, 1, 1};

// pose of the tip (2.50).
//   q[6]  in   joint positions, rad or m
//   R[9]  out  rotation matrix of the frame in the base frame
//              3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]  out  position of the frame's origin in the base frame, m
// Reads q[0..5]. Operations: 56 mul, 25 add, 12 sin/cos.
template <class Scalar>
inline void forward_kinematics(const Scalar* q, Scalar* R, Scalar* p) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5];
  const Scalar s_1 = sin(q_1), c_1 = cos(q_1);
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar p_3_x = Scalar(0.45) * s_3 - Scalar(0.45);
  const Scalar t1 = Scalar(0.45) * c_3;
  p[2] = c_2 * t1 - s_2 * p_3_x;
  const Scalar p_2u_t_x = s_2 * t1 + c_2 * p_3_x;
  p[0] = -c_1 * p_2u_t_x;
  p[1] = -s_1 * p_2u_t_x;
  const Scalar t2 = c_3 * s_5;
  const Scalar a_3_t_x = s_3 * c_5 + c_4 * t2;
  const Scalar t3 = s_3 * s_5;
  const Scalar t4 = c_4 * t3 - c_3 * c_5;
  R[8] = -s_2 * a_3_t_x - c_2 * t4;
  const Scalar t5 = c_4 * c_5;
  const Scalar t6 = s_4 * c_6;
  const Scalar s_4_t_x = t6 + s_6 * t5;
  const Scalar t7 = s_6 * t3 - c_3 * s_4_t_x;
  const Scalar s_3_t_y = s_3 * s_4_t_x + s_6 * t2;
  R[7] = s_2 * t7 - c_2 * s_3_t_y;
  const Scalar t8 = s_2 * t4 - c_2 * a_3_t_x;
  const Scalar t9 = s_4 * s_5;
  R[2] = s_1 * t9 + c_1 * t8;
  R[5] = s_1 * t8 - c_1 * t9;
  const Scalar t10 = s_4 * s_6;
  const Scalar t11 = t10 - c_6 * t5;
  const Scalar t12 = c_6 * t3 + c_3 * t11;
  const Scalar t13 = s_3 * t11 - c_6 * t2;
  R[6] = -s_2 * t12 - c_2 * t13;
  const Scalar n_2_t_x = s_2 * t13 - c_2 * t12;
  const Scalar n_4_t_y = c_5 * t6 + c_4 * s_6;
  R[3] = s_1 * n_2_t_x + c_1 * n_4_t_y;
  const Scalar t14 = s_2 * s_3_t_y + c_2 * t7;
  const Scalar t15 = c_5 * t10 - c_4 * c_6;
  R[1] = s_1 * t15 + c_1 * t14;
  R[4] = s_1 * t14 - c_1 * t15;
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

// geometric Jacobian of the tip (7.14), (7.15).
//   q[6]   in   joint positions, rad or m
//   J[36]  out  geometric Jacobian in base axes: linear rows, then angular
//               6 x 6, row by row: entry (i, j) is J[6 * i + j]
// Reads q[0..4]. Operations: 57 mul, 23 add, 10 sin/cos. Always zero: 6 of the 36 entries of J.
template <class Scalar>
inline void jacobian(const Scalar* q, Scalar* J) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4];
  const Scalar s_1 = sin(q_1), c_1 = cos(q_1);
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  J[19] = J[20] = s_1;
  J[25] = J[26] = -c_1;
  const Scalar t1 = s_2 * s_3 - c_2 * c_3;
  J[33] = -t1;
  const Scalar R_32_x = c_2 * s_3 + s_2 * c_3;
  J[34] = s_4 * R_32_x;
  const Scalar t2 = Scalar(0.45) * s_2;
  const Scalar p_3_x = Scalar(0.45) * s_3 - Scalar(0.45);
  const Scalar p_2u_t_x = c_3 * t2 + c_2 * p_3_x;
  J[0] = s_1 * p_2u_t_x;
  const Scalar t3 = Scalar(0.45) * c_2;
  const Scalar t4 = s_2 * p_3_x - c_3 * t3;
  J[1] = c_1 * t4;
  J[7] = s_1 * t4;
  J[13] = -p_2u_t_x;
  const Scalar t5 = c_1 * R_32_x;
  J[21] = -t5;
  const Scalar t6 = s_1 * R_32_x;
  J[27] = -t6;
  J[6] = -c_1 * p_2u_t_x;
  const Scalar r_3_z = t2 + t4;
  J[2] = c_1 * r_3_z;
  J[8] = s_1 * r_3_z;
  const Scalar t7 = p_2u_t_x + t3;
  J[14] = -t7;
  const Scalar t8 = c_1 * s_4;
  const Scalar t9 = s_1 * c_4;
  const Scalar t10 = t1 * t8 - t9;
  J[22] = -t10;
  const Scalar t11 = s_1 * s_4;
  const Scalar t12 = c_1 * c_4;
  const Scalar t13 = t12 + t1 * t11;
  J[28] = -t13;
  const Scalar t14 = c_4 * s_5 * R_32_x + c_5 * t1;
  J[35] = -t14;
  const Scalar J_46 = s_5 * (t1 * t12 + t11) - c_5 * t5;
  J[23] = J_46;
  const Scalar t15 = t7 - Scalar(0.45) * R_32_x;
  J[16] = t15 * (s_1 * t10 - c_1 * t13);
  const Scalar t16 = s_5 * (t8 - t1 * t9) + c_5 * t6;
  J[29] = -t16;
  const Scalar t17 = r_3_z - Scalar(0.45) * t1;
  const Scalar t18 = t1 * t15 - R_32_x * t17;
  J[9] = c_1 * t18;
  const Scalar t19 = s_4 * t15;
  J[4] = t17 * t13 + t6 * t19;
  const Scalar t20 = t15 * t14;
  J[5] = t17 * t16 - s_1 * t20;
  J[11] = t17 * J_46 + c_1 * t20;
  J[3] = -s_1 * t18;
  J[10] = -t17 * t10 - t5 * t19;
  J[17] = -t15 * (s_1 * J_46 + c_1 * t16);
  J[30] = Scalar(1.0);
  J[12] = J[15] = J[18] = J[24] = J[31] = J[32] = Scalar(0.0);
}

// (dJ/dt) qd of the tip.
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads q[0..5], qd[0..5]. Operations: 116 mul, 58 add, 12 sin/cos.
template <class Scalar>
inline void jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar s_1 = sin(q_1), c_1 = cos(q_1);
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar t1 = c_2 * s_3;
  const Scalar t2 = s_2 * c_3;
  const Scalar t3 = t1 + t2;
  const Scalar t4 = qd_1 * t3;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t5 = s_4 * omega_3_z - c_4 * t4;
  const Scalar t6 = s_2 * s_3 - c_2 * c_3;
  const Scalar t7 = qd_1 * t6;
  const Scalar omega_4_z = qd_4 - t7;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t5;
  const Scalar omega_r_4_y = s_4 * t4 + c_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar t8 = qd_6 * (s_6 * omega_5_z - c_6 * omega_r_5_x);
  const Scalar omega_r_5_y = s_5 * t5 + c_5 * omega_4_z;
  const Scalar t9 = omega_3_z * t7;
  const Scalar t10 = qd_4 * omega_r_4_y + c_4 * t9;
  const Scalar t11 = omega_3_z * t4;
  const Scalar domega_5_x = qd_5 * omega_r_5_y - s_5 * t11 - c_5 * t10;
  const Scalar t12 = qd_4 * t5 + s_4 * t9;
  const Scalar t13 = t8 - s_6 * domega_5_x + c_6 * t12;
  const Scalar omega_r_6_y = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t14 = qd_6 * omega_r_6_y - s_6 * t12 - c_6 * domega_5_x;
  const Scalar t15 = s_6 * t13 + c_6 * t14;
  const Scalar domega_5_y = qd_5 * omega_r_5_x - s_5 * t10 + c_5 * t11;
  const Scalar domega_e_5_t_x = s_5 * domega_5_y - c_5 * t15;
  const Scalar domega_e_6_t_y = s_6 * t14 - c_6 * t13;
  const Scalar domega_e_4_t_x = s_4 * domega_e_6_t_y + c_4 * domega_e_5_t_x;
  const Scalar domega_e_5_t_y = s_5 * t15 + c_5 * domega_5_y;
  const Scalar domega_e_3_t_x = s_3 * domega_e_5_t_y + c_3 * domega_e_4_t_x;
  const Scalar t16 = s_3 * domega_e_4_t_x - c_3 * domega_e_5_t_y;
  a[5] = s_2 * domega_e_3_t_x + c_2 * t16;
  const Scalar t17 = Scalar(0.45) * qd_1;
  const Scalar t18 = qd_1 * (t3 * t6 - s_2 * t1) * t17;
  const Scalar t19 = c_2 * qd_1;
  const Scalar U_2_xx = qd_2 * qd_2 + t19 * t19;
  const Scalar t20 = Scalar(0.45) * c_3 * U_2_xx + t18;
  const Scalar t21 = Scalar(0.9) * s_2 * qd_1 * qd_2 - Scalar(0.9) * t9;
  const Scalar t22 = s_4 * t21 + c_4 * t20;
  const Scalar t23 = omega_3_z * omega_3_z + t4 * t4 - s_3 * U_2_xx;
  const Scalar t24 = Scalar(0.45) * t23 - t19 * t2 * t17;
  const Scalar t25 = s_5 * t24 + c_5 * t22;
  const Scalar t26 = s_4 * t20 - c_4 * t21;
  const Scalar t27 = s_6 * t25 + c_6 * t26;
  const Scalar t28 = s_6 * t26 - c_6 * t25;
  const Scalar t29 = s_6 * t27 - c_6 * t28;
  const Scalar t30 = s_5 * t22 - c_5 * t24;
  const Scalar t31 = s_5 * t30 + c_5 * t29;
  const Scalar t32 = s_6 * t28 + c_6 * t27;
  const Scalar t33 = s_4 * t32 + c_4 * t31;
  const Scalar t34 = s_5 * t29 - c_5 * t30;
  const Scalar t35 = s_3 * t34 - c_3 * t33;
  const Scalar t36 = s_3 * t33 + c_3 * t34;
  a[2] = s_2 * t35 - c_2 * t36;
  const Scalar t37 = s_2 * t36 + c_2 * t35;
  const Scalar t38 = s_4 * t31 - c_4 * t32;
  a[0] = s_1 * t38 + c_1 * t37;
  a[1] = s_1 * t37 - c_1 * t38;
  const Scalar t39 = s_2 * t16 - c_2 * domega_e_3_t_x;
  const Scalar t40 = s_4 * domega_e_5_t_x - c_4 * domega_e_6_t_y;
  a[3] = -s_1 * t40 - c_1 * t39;
  a[4] = c_1 * t40 - s_1 * t39;
}

}  // namespace rx90

#endif  // FLATDYN_RX90_HPP

// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "quadruped12" as flat code: 12 joints.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Input: sha1:e2173ac6ded93ccd954eacf2a9e9318d33ff076c
//
//   index  joint   moves link    type      unit  lower  upper  speed  effort
//   0      FL_HAA  FL_SHOULDER   revolute  rad   -1.2   1.2    30     2.7
//   1      FL_HFE  FL_UPPER_LEG  revolute  rad   -1.7   1.7    30     2.7
//   2      FL_KFE  FL_LOWER_LEG  revolute  rad   -3.4   3.4    30     2.7
//   3      FR_HAA  FR_SHOULDER   revolute  rad   -1.2   1.2    30     2.7
//   4      FR_HFE  FR_UPPER_LEG  revolute  rad   -1.7   1.7    30     2.7
//   5      FR_KFE  FR_LOWER_LEG  revolute  rad   -3.4   3.4    30     2.7
//   6      HL_HAA  HL_SHOULDER   revolute  rad   -1.2   1.2    30     2.7
//   7      HL_HFE  HL_UPPER_LEG  revolute  rad   -1.7   1.7    30     2.7
//   8      HL_KFE  HL_LOWER_LEG  revolute  rad   -3.4   3.4    30     2.7
//   9      HR_HAA  HR_SHOULDER   revolute  rad   -1.2   1.2    30     2.7
//   10     HR_HFE  HR_UPPER_LEG  revolute  rad   -1.7   1.7    30     2.7
//   11     HR_KFE  HR_LOWER_LEG  revolute  rad   -3.4   3.4    30     2.7
//
// Gravity is (0, 0, -9.81) m/s^2 in the base frame. The tip belongs to link "HR_FOOT". Links
// without a joint of their own, part of those that carry them: FL_FOOT, FR_FOOT, HL_FOOT, HR_FOOT.
//
// Every function is a template over its scalar: float, double, or any type that has + - * / and
// sin, cos where argument-dependent lookup finds them. Arguments are plain arrays:
//
//   double q[12] = {}, qd[12] = {}, qdd[12] = {}, tau[12];
//   quadruped12::inverse_dynamics(q, qd, qdd, tau);
//
// Entries come in the order of the table. Units are SI; "rad or m" goes by the type of the joint.
// Every entry of an output is written, zeros too. All inputs are read before anything is written:
// an output may overlap an input, but outputs must not overlap each other. Nothing allocates,
// throws, or keeps state. In the code, names count from 1 as in the textbook: q_1 is q[0], s_1 its
// sine, c_1 its cosine, s_12 the sine of q_1 + q_2.

#ifndef FLATDYN_QUADRUPED12_HPP
#define FLATDYN_QUADRUPED12_HPP

#include <cmath>

namespace quadruped12 {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 12;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {
    "FL_HAA", "FL_HFE", "FL_KFE", "FR_HAA", "FR_HFE", "FR_KFE", "HL_HAA", "HL_HFE", "HL_KFE",
    "HR_HAA", "HR_HFE", "HR_KFE"};

// Smallest position, rad or m.
inline constexpr Real position_lower[joint_count] = {
    Real(-1.2), Real(-1.7), Real(-3.4), Real(-1.2), Real(-1.7), Real(-3.4), Real(-1.2), Real(-1.7),
    Real(-3.4), Real(-1.2), Real(-1.7), Real(-3.4)};

// Largest position, rad or m.
inline constexpr Real position_upper[joint_count] = {
    Real(1.2), Real(1.7), Real(3.4), Real(1.2), Real(1.7), Real(3.4), Real(1.2), Real(1.7),
    Real(3.4), Real(1.2), Real(1.7), Real(3.4)};

// Largest speed, rad/s or m/s.
inline constexpr Real velocity_limit[joint_count] = {
    Real(30.0), Real(30.0), Real(30.0), Real(30.0), Real(30.0), Real(30.0), Real(30.0), Real(30.0),
    Real(30.0), Real(30.0), Real(30.0), Real(30.0)};

// Largest torque or force, N m or N.
inline constexpr Real effort_limit[joint_count] = {
    Real(2.7), Real(2.7), Real(2.7), Real(2.7), Real(2.7), Real(2.7), Real(2.7), Real(2.7),
    Real(2.7), Real(2.7), Real(2.7), Real(2.7)};

// tau = B(q) qdd + C(q, qd) qd + g(q) + friction (7.42).
//   q[12]    in   joint positions, rad or m
//   qd[12]   in   joint velocities, rad/s or m/s
//   qdd[12]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[12]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11], qd[0..11], qdd[0..11]. Operations: 300 mul, 248 add, 24 sin/cos.
template <class Scalar>
inline void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    Scalar* tau) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6],
      q_8 = q[7], q_9 = q[8], q_10 = q[9], q_11 = q[10], q_12 = q[11];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5], qdd_7 = qdd[6], qdd_8 = qdd[7], qdd_9 = qdd[8], qdd_10 = qdd[9],
      qdd_11 = qdd[10], qdd_12 = qdd[11];
  const Scalar s_1 = sin(q_1), c_1 = cos(q_1);
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar s_8 = sin(q_8), c_8 = cos(q_8);
  const Scalar s_9 = sin(q_9), c_9 = cos(q_9);
  const Scalar s_10 = sin(q_10), c_10 = cos(q_10);
  const Scalar s_11 = sin(q_11), c_11 = cos(q_11);
  const Scalar s_12 = sin(q_12), c_12 = cos(q_12);
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = t1 * t1;
  const Scalar t3 = qd_2 * qd_2;
  const Scalar U_2_yy = t3 + t2;
  const Scalar t4 = Scalar(9.81) * c_1;
  const Scalar ddp_o_3_y = Scalar(0.16) * U_2_yy + c_2 * t4;
  const Scalar t5 = s_2 * qd_1;
  const Scalar t6 = t5 * t1;
  const Scalar U_2_xy = qdd_2 + t6;
  const Scalar ddp_o_3_x = Scalar(0.16) * U_2_xy + s_2 * t4;
  const Scalar ddp_3_x = s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar t7 = s_3 * t5 - c_3 * t1;
  const Scalar t8 = qd_2 * t5;
  const Scalar t9 = c_2 * qdd_1;
  const Scalar t10 = t8 - t9;
  const Scalar t11 = qd_2 * t1;
  const Scalar t12 = s_2 * qdd_1;
  const Scalar domega_2_y = t11 + t12;
  const Scalar t13 = qd_3 * t7 + s_3 * t10 - c_3 * domega_2_y;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t14 = t7 * omega_3_z;
  const Scalar omega_r_3_y = s_3 * t1 + c_3 * t5;
  const Scalar t15 = t7 * omega_r_3_y;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar U_3_xy = domega_3_z - t15;
  const Scalar U_3_yx = domega_3_z + t15;
  const Scalar N_3_z = Scalar(0.0038482516772413) * ddp_3_x +
      Scalar(0.0005411142213171667) * U_3_xy - Scalar(0.00023148988883634047) * (t13 - t14) +
      Scalar(1.505e-06) * U_3_yx;
  tau[2] = N_3_z;
  const Scalar t16 = c_5 * qd_4;
  const Scalar t17 = t16 * t16;
  const Scalar t18 = qd_5 * qd_5;
  const Scalar U_5_yy = t18 + t17;
  const Scalar t19 = Scalar(9.81) * c_4;
  const Scalar ddp_o_6_y = Scalar(0.16) * U_5_yy + c_5 * t19;
  const Scalar t20 = s_5 * qd_4;
  const Scalar t21 = t20 * t16;
  const Scalar U_5_xy = qdd_5 + t21;
  const Scalar ddp_o_6_x = Scalar(0.16) * U_5_xy + s_5 * t19;
  const Scalar ddp_6_x = s_6 * ddp_o_6_y + c_6 * ddp_o_6_x;
  const Scalar t22 = s_6 * t20 - c_6 * t16;
  const Scalar t23 = qd_5 * t20;
  const Scalar t24 = c_5 * qdd_4;
  const Scalar t25 = t23 - t24;
  const Scalar t26 = qd_5 * t16;
  const Scalar t27 = s_5 * qdd_4;
  const Scalar domega_5_y = t26 + t27;
  const Scalar t28 = qd_6 * t22 + s_6 * t25 - c_6 * domega_5_y;
  const Scalar omega_6_z = qd_5 + qd_6;
  const Scalar t29 = t22 * omega_6_z;
  const Scalar omega_r_6_y = s_6 * t16 + c_6 * t20;
  const Scalar t30 = t22 * omega_r_6_y;
  const Scalar domega_6_z = qdd_5 + qdd_6;
  const Scalar U_6_xy = domega_6_z - t30;
  const Scalar U_6_yx = domega_6_z + t30;
  const Scalar N_6_z = Scalar(0.0038482516772413) * ddp_6_x +
      Scalar(0.0005411142213171667) * U_6_xy + Scalar(0.00023148988883634047) * (t28 - t29) +
      Scalar(1.505e-06) * U_6_yx;
  tau[5] = N_6_z;
  const Scalar t31 = c_8 * qd_7;
  const Scalar t32 = t31 * t31;
  const Scalar t33 = qd_8 * qd_8;
  const Scalar U_8_yy = t33 + t32;
  const Scalar t34 = Scalar(9.81) * c_7;
  const Scalar ddp_o_9_y = Scalar(0.16) * U_8_yy + c_8 * t34;
  const Scalar t35 = s_8 * qd_7;
  const Scalar t36 = t35 * t31;
  const Scalar U_8_xy = qdd_8 + t36;
  const Scalar ddp_o_9_x = Scalar(0.16) * U_8_xy + s_8 * t34;
  const Scalar ddp_9_x = s_9 * ddp_o_9_y + c_9 * ddp_o_9_x;
  const Scalar t37 = s_9 * t35 - c_9 * t31;
  const Scalar t38 = qd_8 * t35;
  const Scalar t39 = c_8 * qdd_7;
  const Scalar t40 = t38 - t39;
  const Scalar t41 = qd_8 * t31;
  const Scalar t42 = s_8 * qdd_7;
  const Scalar domega_8_y = t41 + t42;
  const Scalar t43 = qd_9 * t37 + s_9 * t40 - c_9 * domega_8_y;
  const Scalar omega_9_z = qd_8 + qd_9;
  const Scalar t44 = t37 * omega_9_z;
  const Scalar omega_r_9_y = s_9 * t31 + c_9 * t35;
  const Scalar t45 = t37 * omega_r_9_y;
  const Scalar domega_9_z = qdd_8 + qdd_9;
  const Scalar U_9_xy = domega_9_z - t45;
  const Scalar U_9_yx = domega_9_z + t45;
  const Scalar N_9_z = Scalar(0.0038482516772413) * ddp_9_x +
      Scalar(0.0005411142213171667) * U_9_xy - Scalar(0.00023148988883634047) * (t43 - t44) +
      Scalar(1.505e-06) * U_9_yx;
  tau[8] = N_9_z;
  const Scalar t46 = c_11 * qd_10;
  const Scalar t47 = t46 * t46;
  const Scalar t48 = qd_11 * qd_11;
  const Scalar U_11_yy = t48 + t47;
  const Scalar t49 = Scalar(9.81) * c_10;
  const Scalar ddp_o_12_y = Scalar(0.16) * U_11_yy + c_11 * t49;
  const Scalar t50 = s_11 * qd_10;
  const Scalar t51 = t50 * t46;
  const Scalar U_11_xy = qdd_11 + t51;
  const Scalar ddp_o_12_x = Scalar(0.16) * U_11_xy + s_11 * t49;
  const Scalar ddp_12_x = s_12 * ddp_o_12_y + c_12 * ddp_o_12_x;
  const Scalar t52 = s_12 * t50 - c_12 * t46;
  const Scalar t53 = qd_11 * t50;
  const Scalar t54 = c_11 * qdd_10;
  const Scalar t55 = t53 - t54;
  const Scalar t56 = qd_11 * t46;
  const Scalar t57 = s_11 * qdd_10;
  const Scalar domega_11_y = t56 + t57;
  const Scalar t58 = qd_12 * t52 + s_12 * t55 - c_12 * domega_11_y;
  const Scalar omega_12_z = qd_11 + qd_12;
  const Scalar t59 = t52 * omega_12_z;
  const Scalar omega_r_12_y = s_12 * t46 + c_12 * t50;
  const Scalar t60 = t52 * omega_r_12_y;
  const Scalar domega_12_z = qdd_11 + qdd_12;
  const Scalar U_12_xy = domega_12_z - t60;
  const Scalar U_12_yx = domega_12_z + t60;
  const Scalar N_12_z = Scalar(0.0038482516772413) * ddp_12_x +
      Scalar(0.0005411142213171667) * U_12_xy + Scalar(0.00023148988883634047) * (t58 - t59) +
      Scalar(1.505e-06) * U_12_yx;
  tau[11] = N_12_z;
  const Scalar t61 = omega_12_z * omega_12_z;
  const Scalar U_12_yy = t61 + t52 * t52;
  const Scalar t62 = t50 * t50;
  const Scalar U_11_xx = t48 + t62;
  const Scalar U_11_xx_yy = U_11_xx - U_11_yy;
  const Scalar U_11_yx = qdd_11 - t51;
  const Scalar t63 = Scalar(6.823068516838894e-08) * t54 + Scalar(0.0007940924716883453) * t57 -
      Scalar(0.002280028171323094) * U_11_xy - Scalar(0.000015550028164806267) * U_11_yx +
      Scalar(1.609852873477455e-07) * U_11_xx_yy - N_12_z +
      Scalar(0.000615720268358608) * s_12 * U_12_yy -
      Scalar(0.000615720268358608) * c_12 * U_12_xy - Scalar(0.000020065123418265) * c_10 * c_11 -
      Scalar(0.1737624403145115) * c_10 * s_11;
  tau[10] = -t63;
  const Scalar t64 = omega_9_z * omega_9_z;
  const Scalar U_9_yy = t64 + t37 * t37;
  const Scalar t65 = t35 * t35;
  const Scalar U_8_xx = t33 + t65;
  const Scalar U_8_xx_yy = U_8_xx - U_8_yy;
  const Scalar U_8_yx = qdd_8 - t36;
  const Scalar t66 = Scalar(6.823068516838894e-08) * t39 - Scalar(0.0007940924716883453) * t42 -
      Scalar(0.002280028171323094) * U_8_xy - Scalar(0.000015550028164806267) * U_8_yx -
      Scalar(1.609852873477455e-07) * U_8_xx_yy - N_9_z +
      Scalar(0.000615720268358608) * s_9 * U_9_yy - Scalar(0.000615720268358608) * c_9 * U_9_xy +
      Scalar(0.000020065123418265) * c_7 * c_8 - Scalar(0.1737624403145115) * c_7 * s_8;
  tau[7] = -t66;
  const Scalar t67 = omega_6_z * omega_6_z;
  const Scalar U_6_yy = t67 + t22 * t22;
  const Scalar t68 = t20 * t20;
  const Scalar U_5_xx = t18 + t68;
  const Scalar U_5_xx_yy = U_5_xx - U_5_yy;
  const Scalar U_5_yx = qdd_5 - t21;
  const Scalar t69 = Scalar(6.823068516838894e-08) * t24 + Scalar(0.0007940924716883453) * t27 -
      Scalar(0.002280028171323094) * U_5_xy - Scalar(0.000015550028164806267) * U_5_yx +
      Scalar(1.609852873477455e-07) * U_5_xx_yy - N_6_z +
      Scalar(0.000615720268358608) * s_6 * U_6_yy - Scalar(0.000615720268358608) * c_6 * U_6_xy -
      Scalar(0.000020065123418265) * c_4 * c_5 - Scalar(0.1737624403145115) * c_4 * s_5;
  tau[4] = -t69;
  const Scalar t70 = omega_3_z * omega_3_z;
  const Scalar U_3_yy = t70 + t7 * t7;
  const Scalar t71 = t5 * t5;
  const Scalar U_2_xx = t3 + t71;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  const Scalar U_2_yx = qdd_2 - t6;
  const Scalar t72 = Scalar(6.823068516838894e-08) * t9 - Scalar(0.0007940924716883453) * t12 -
      Scalar(0.002280028171323094) * U_2_xy - Scalar(0.000015550028164806267) * U_2_yx -
      Scalar(1.609852873477455e-07) * U_2_xx_yy - N_3_z +
      Scalar(0.000615720268358608) * s_3 * U_3_yy - Scalar(0.000615720268358608) * c_3 * U_3_xy +
      Scalar(0.000020065123418265) * c_1 * c_2 - Scalar(0.1737624403145115) * c_1 * s_2;
  tau[1] = -t72;
  const Scalar N_9_y = Scalar(0.00023148988883634047) * U_9_xy - Scalar(1.505e-06) * (t43 + t44);
  const Scalar t73 = omega_r_9_y * omega_9_z + qd_9 * omega_r_9_y + s_9 * domega_8_y + c_9 * t40;
  const Scalar U_8_zy = t38 + t40;
  const Scalar N_9_x = Scalar(0.037751348953737156) * s_7 - Scalar(0.000615720268358608) * U_8_zy -
      Scalar(0.0005411142213171667) * t73 +
      Scalar(0.00023148988883634047) * (t64 - omega_r_9_y * omega_r_9_y);
  const Scalar U_8_zx = t41 + domega_8_y;
  const Scalar U_8_zz = t65 + t32;
  const Scalar U_8_zz_xx = U_8_xx - U_8_zz;
  const Scalar mu_8_y = Scalar(0.000020065123418265) * s_7 +
      Scalar(0.0007940924716883453) * U_8_xy + Scalar(0.000015550028164806267) * U_8_zx -
      Scalar(1.609852873477455e-07) * U_8_zy + Scalar(6.823068516838894e-08) * U_8_zz_xx -
      s_9 * N_9_x + c_9 * N_9_y;
  const Scalar U_8_yy_zz = U_8_yy - U_8_zz;
  const Scalar mu_8_x = Scalar(0.1737624403145115) * s_7 - Scalar(6.823068516838894e-08) * U_8_yx +
      Scalar(1.609852873477455e-07) * U_8_zx - Scalar(0.002280028171323094) * U_8_zy -
      Scalar(0.000615720268358608) * t73 + Scalar(0.0007940924716883453) * U_8_yy_zz + s_9 * N_9_y +
      c_9 * N_9_x;
  tau[6] = Scalar(0.08509272390476785) * c_7 + Scalar(0.00035882787553735663) * qdd_7 +
      s_8 * mu_8_y + c_8 * mu_8_x;
  const Scalar N_3_y = Scalar(0.00023148988883634047) * U_3_xy - Scalar(1.505e-06) * (t13 + t14);
  const Scalar t74 = omega_r_3_y * omega_3_z + qd_3 * omega_r_3_y + s_3 * domega_2_y + c_3 * t10;
  const Scalar U_2_zy = t8 + t10;
  const Scalar N_3_x = Scalar(0.037751348953737156) * s_1 - Scalar(0.000615720268358608) * U_2_zy -
      Scalar(0.0005411142213171667) * t74 +
      Scalar(0.00023148988883634047) * (t70 - omega_r_3_y * omega_r_3_y);
  const Scalar U_2_zx = t11 + domega_2_y;
  const Scalar U_2_zz = t71 + t2;
  const Scalar U_2_zz_xx = U_2_xx - U_2_zz;
  const Scalar mu_2_y = Scalar(0.000020065123418265) * s_1 +
      Scalar(0.0007940924716883453) * U_2_xy + Scalar(0.000015550028164806267) * U_2_zx -
      Scalar(1.609852873477455e-07) * U_2_zy + Scalar(6.823068516838894e-08) * U_2_zz_xx -
      s_3 * N_3_x + c_3 * N_3_y;
  const Scalar U_2_yy_zz = U_2_yy - U_2_zz;
  const Scalar mu_2_x = Scalar(0.1737624403145115) * s_1 - Scalar(6.823068516838894e-08) * U_2_yx +
      Scalar(1.609852873477455e-07) * U_2_zx - Scalar(0.002280028171323094) * U_2_zy -
      Scalar(0.000615720268358608) * t74 + Scalar(0.0007940924716883453) * U_2_yy_zz + s_3 * N_3_y +
      c_3 * N_3_x;
  tau[0] = Scalar(0.08509272390476785) * c_1 + Scalar(0.00035882787553735663) * qdd_1 +
      s_2 * mu_2_y + c_2 * mu_2_x;
  const Scalar N_12_y = Scalar(0.00023148988883634047) * U_12_xy + Scalar(1.505e-06) * (t58 + t59);
  const Scalar t75 = omega_r_12_y * omega_12_z + qd_12 * omega_r_12_y + s_12 * domega_11_y +
      c_12 * t55;
  const Scalar U_11_zy = t53 + t55;
  const Scalar N_12_x = Scalar(0.037751348953737156) * s_10 -
      Scalar(0.000615720268358608) * U_11_zy - Scalar(0.0005411142213171667) * t75 -
      Scalar(0.00023148988883634047) * (t61 - omega_r_12_y * omega_r_12_y);
  const Scalar U_11_zx = t56 + domega_11_y;
  const Scalar U_11_zz = t62 + t47;
  const Scalar U_11_zz_xx = U_11_xx - U_11_zz;
  const Scalar mu_11_y = Scalar(0.000020065123418265) * s_10 +
      Scalar(0.0007940924716883453) * U_11_xy - Scalar(0.000015550028164806267) * U_11_zx -
      Scalar(1.609852873477455e-07) * U_11_zy - Scalar(6.823068516838894e-08) * U_11_zz_xx +
      s_12 * N_12_x + c_12 * N_12_y;
  const Scalar U_11_yy_zz = U_11_yy - U_11_zz;
  const Scalar mu_11_x = Scalar(0.1737624403145115) * s_10 -
      Scalar(6.823068516838894e-08) * U_11_yx - Scalar(1.609852873477455e-07) * U_11_zx -
      Scalar(0.002280028171323094) * U_11_zy - Scalar(0.000615720268358608) * t75 -
      Scalar(0.0007940924716883453) * U_11_yy_zz - s_12 * N_12_y + c_12 * N_12_x;
  tau[9] = Scalar(0.00035882787553735663) * qdd_10 - Scalar(0.08509272390476785) * c_10 -
      s_11 * mu_11_y + c_11 * mu_11_x;
  const Scalar N_6_y = Scalar(0.00023148988883634047) * U_6_xy + Scalar(1.505e-06) * (t28 + t29);
  const Scalar t76 = omega_r_6_y * omega_6_z + qd_6 * omega_r_6_y + s_6 * domega_5_y + c_6 * t25;
  const Scalar U_5_zy = t23 + t25;
  const Scalar N_6_x = Scalar(0.037751348953737156) * s_4 - Scalar(0.000615720268358608) * U_5_zy -
      Scalar(0.0005411142213171667) * t76 -
      Scalar(0.00023148988883634047) * (t67 - omega_r_6_y * omega_r_6_y);
  const Scalar U_5_zx = t26 + domega_5_y;
  const Scalar U_5_zz = t68 + t17;
  const Scalar U_5_zz_xx = U_5_xx - U_5_zz;
  const Scalar mu_5_y = Scalar(0.000020065123418265) * s_4 +
      Scalar(0.0007940924716883453) * U_5_xy - Scalar(0.000015550028164806267) * U_5_zx -
      Scalar(1.609852873477455e-07) * U_5_zy - Scalar(6.823068516838894e-08) * U_5_zz_xx +
      s_6 * N_6_x + c_6 * N_6_y;
  const Scalar U_5_yy_zz = U_5_yy - U_5_zz;
  const Scalar mu_5_x = Scalar(0.1737624403145115) * s_4 - Scalar(6.823068516838894e-08) * U_5_yx -
      Scalar(1.609852873477455e-07) * U_5_zx - Scalar(0.002280028171323094) * U_5_zy -
      Scalar(0.000615720268358608) * t76 - Scalar(0.0007940924716883453) * U_5_yy_zz - s_6 * N_6_y +
      c_6 * N_6_x;
  tau[3] = Scalar(0.00035882787553735663) * qdd_4 - Scalar(0.08509272390476785) * c_4 -
      s_5 * mu_5_y + c_5 * mu_5_x;
}

// inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[12]    in   joint positions, rad or m
//   qd[12]   in   joint velocities, rad/s or m/s
//   qdd[12]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]   in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[12]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11], qd[0..11], qdd[0..11], h_e[0..5]. Operations: 329 mul, 270 add, 24 sin/cos.
template <class Scalar>
inline void inverse_dynamics_tip_force(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    const Scalar* h_e, Scalar* tau) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6],
      q_8 = q[7], q_9 = q[8], q_10 = q[9], q_11 = q[10], q_12 = q[11];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5], qdd_7 = qdd[6], qdd_8 = qdd[7], qdd_9 = qdd[8], qdd_10 = qdd[9],
      qdd_11 = qdd[10], qdd_12 = qdd[11];
  const Scalar h_e_1 = h_e[0], h_e_2 = h_e[1], h_e_3 = h_e[2], h_e_4 = h_e[3], h_e_5 = h_e[4],
      h_e_6 = h_e[5];
  const Scalar s_1 = sin(q_1), c_1 = cos(q_1);
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar s_8 = sin(q_8), c_8 = cos(q_8);
  const Scalar s_9 = sin(q_9), c_9 = cos(q_9);
  const Scalar s_10 = sin(q_10), c_10 = cos(q_10);
  const Scalar s_11 = sin(q_11), c_11 = cos(q_11);
  const Scalar s_12 = sin(q_12), c_12 = cos(q_12);
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = t1 * t1;
  const Scalar t3 = qd_2 * qd_2;
  const Scalar U_2_yy = t3 + t2;
  const Scalar t4 = Scalar(9.81) * c_1;
  const Scalar ddp_o_3_y = Scalar(0.16) * U_2_yy + c_2 * t4;
  const Scalar t5 = s_2 * qd_1;
  const Scalar t6 = t5 * t1;
  const Scalar U_2_xy = qdd_2 + t6;
  const Scalar ddp_o_3_x = Scalar(0.16) * U_2_xy + s_2 * t4;
  const Scalar ddp_3_x = s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar t7 = s_3 * t5 - c_3 * t1;
  const Scalar t8 = qd_2 * t5;
  const Scalar t9 = c_2 * qdd_1;
  const Scalar t10 = t8 - t9;
  const Scalar t11 = qd_2 * t1;
  const Scalar t12 = s_2 * qdd_1;
  const Scalar domega_2_y = t11 + t12;
  const Scalar t13 = qd_3 * t7 + s_3 * t10 - c_3 * domega_2_y;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t14 = t7 * omega_3_z;
  const Scalar omega_r_3_y = s_3 * t1 + c_3 * t5;
  const Scalar t15 = t7 * omega_r_3_y;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar U_3_xy = domega_3_z - t15;
  const Scalar U_3_yx = domega_3_z + t15;
  const Scalar N_3_z = Scalar(0.0038482516772413) * ddp_3_x +
      Scalar(0.0005411142213171667) * U_3_xy - Scalar(0.00023148988883634047) * (t13 - t14) +
      Scalar(1.505e-06) * U_3_yx;
  tau[2] = N_3_z;
  const Scalar t16 = c_5 * qd_4;
  const Scalar t17 = t16 * t16;
  const Scalar t18 = qd_5 * qd_5;
  const Scalar U_5_yy = t18 + t17;
  const Scalar t19 = Scalar(9.81) * c_4;
  const Scalar ddp_o_6_y = Scalar(0.16) * U_5_yy + c_5 * t19;
  const Scalar t20 = s_5 * qd_4;
  const Scalar t21 = t20 * t16;
  const Scalar U_5_xy = qdd_5 + t21;
  const Scalar ddp_o_6_x = Scalar(0.16) * U_5_xy + s_5 * t19;
  const Scalar ddp_6_x = s_6 * ddp_o_6_y + c_6 * ddp_o_6_x;
  const Scalar t22 = s_6 * t20 - c_6 * t16;
  const Scalar t23 = qd_5 * t20;
  const Scalar t24 = c_5 * qdd_4;
  const Scalar t25 = t23 - t24;
  const Scalar t26 = qd_5 * t16;
  const Scalar t27 = s_5 * qdd_4;
  const Scalar domega_5_y = t26 + t27;
  const Scalar t28 = qd_6 * t22 + s_6 * t25 - c_6 * domega_5_y;
  const Scalar omega_6_z = qd_5 + qd_6;
  const Scalar t29 = t22 * omega_6_z;
  const Scalar omega_r_6_y = s_6 * t16 + c_6 * t20;
  const Scalar t30 = t22 * omega_r_6_y;
  const Scalar domega_6_z = qdd_5 + qdd_6;
  const Scalar U_6_xy = domega_6_z - t30;
  const Scalar U_6_yx = domega_6_z + t30;
  const Scalar N_6_z = Scalar(0.0038482516772413) * ddp_6_x +
      Scalar(0.0005411142213171667) * U_6_xy + Scalar(0.00023148988883634047) * (t28 - t29) +
      Scalar(1.505e-06) * U_6_yx;
  tau[5] = N_6_z;
  const Scalar t31 = c_8 * qd_7;
  const Scalar t32 = t31 * t31;
  const Scalar t33 = qd_8 * qd_8;
  const Scalar U_8_yy = t33 + t32;
  const Scalar t34 = Scalar(9.81) * c_7;
  const Scalar ddp_o_9_y = Scalar(0.16) * U_8_yy + c_8 * t34;
  const Scalar t35 = s_8 * qd_7;
  const Scalar t36 = t35 * t31;
  const Scalar U_8_xy = qdd_8 + t36;
  const Scalar ddp_o_9_x = Scalar(0.16) * U_8_xy + s_8 * t34;
  const Scalar ddp_9_x = s_9 * ddp_o_9_y + c_9 * ddp_o_9_x;
  const Scalar t37 = s_9 * t35 - c_9 * t31;
  const Scalar t38 = qd_8 * t35;
  const Scalar t39 = c_8 * qdd_7;
  const Scalar t40 = t38 - t39;
  const Scalar t41 = qd_8 * t31;
  const Scalar t42 = s_8 * qdd_7;
  const Scalar domega_8_y = t41 + t42;
  const Scalar t43 = qd_9 * t37 + s_9 * t40 - c_9 * domega_8_y;
  const Scalar omega_9_z = qd_8 + qd_9;
  const Scalar t44 = t37 * omega_9_z;
  const Scalar omega_r_9_y = s_9 * t31 + c_9 * t35;
  const Scalar t45 = t37 * omega_r_9_y;
  const Scalar domega_9_z = qdd_8 + qdd_9;
  const Scalar U_9_xy = domega_9_z - t45;
  const Scalar U_9_yx = domega_9_z + t45;
  const Scalar N_9_z = Scalar(0.0038482516772413) * ddp_9_x +
      Scalar(0.0005411142213171667) * U_9_xy - Scalar(0.00023148988883634047) * (t43 - t44) +
      Scalar(1.505e-06) * U_9_yx;
  tau[8] = N_9_z;
  const Scalar t46 = s_10 * h_e_2 - c_10 * h_e_3;
  const Scalar f_e11_y = s_11 * h_e_1 - c_11 * t46;
  const Scalar f_e11_x = s_11 * t46 + c_11 * h_e_1;
  const Scalar t47 = s_12 * f_e11_y - c_12 * f_e11_x;
  const Scalar t48 = c_11 * qd_10;
  const Scalar t49 = t48 * t48;
  const Scalar t50 = qd_11 * qd_11;
  const Scalar U_11_yy = t50 + t49;
  const Scalar t51 = Scalar(9.81) * c_10;
  const Scalar ddp_o_12_y = Scalar(0.16) * U_11_yy + c_11 * t51;
  const Scalar t52 = s_11 * qd_10;
  const Scalar t53 = t52 * t48;
  const Scalar U_11_xy = qdd_11 + t53;
  const Scalar ddp_o_12_x = Scalar(0.16) * U_11_xy + s_11 * t51;
  const Scalar ddp_12_x = s_12 * ddp_o_12_y + c_12 * ddp_o_12_x;
  const Scalar t54 = s_12 * t52 - c_12 * t48;
  const Scalar t55 = qd_11 * t52;
  const Scalar t56 = c_11 * qdd_10;
  const Scalar t57 = t55 - t56;
  const Scalar t58 = qd_11 * t48;
  const Scalar t59 = s_11 * qdd_10;
  const Scalar domega_11_y = t58 + t59;
  const Scalar t60 = qd_12 * t54 + s_12 * t57 - c_12 * domega_11_y;
  const Scalar omega_12_z = qd_11 + qd_12;
  const Scalar t61 = t54 * omega_12_z;
  const Scalar omega_r_12_y = s_12 * t48 + c_12 * t52;
  const Scalar t62 = t54 * omega_r_12_y;
  const Scalar domega_12_z = qdd_11 + qdd_12;
  const Scalar U_12_xy = domega_12_z - t62;
  const Scalar U_12_yx = domega_12_z + t62;
  const Scalar mu_12_z = Scalar(0.16) * t47 + Scalar(0.0038482516772413) * ddp_12_x +
      Scalar(0.0005411142213171667) * U_12_xy + Scalar(0.00023148988883634047) * (t60 - t61) +
      Scalar(1.505e-06) * U_12_yx + s_10 * h_e_6 + c_10 * h_e_5;
  tau[11] = mu_12_z;
  const Scalar t63 = omega_9_z * omega_9_z;
  const Scalar U_9_yy = t63 + t37 * t37;
  const Scalar t64 = t35 * t35;
  const Scalar U_8_xx = t33 + t64;
  const Scalar U_8_xx_yy = U_8_xx - U_8_yy;
  const Scalar U_8_yx = qdd_8 - t36;
  const Scalar t65 = Scalar(6.823068516838894e-08) * t39 - Scalar(0.0007940924716883453) * t42 -
      Scalar(0.002280028171323094) * U_8_xy - Scalar(0.000015550028164806267) * U_8_yx -
      Scalar(1.609852873477455e-07) * U_8_xx_yy - N_9_z +
      Scalar(0.000615720268358608) * s_9 * U_9_yy - Scalar(0.000615720268358608) * c_9 * U_9_xy +
      Scalar(0.000020065123418265) * c_7 * c_8 - Scalar(0.1737624403145115) * c_7 * s_8;
  tau[7] = -t65;
  const Scalar t66 = omega_6_z * omega_6_z;
  const Scalar U_6_yy = t66 + t22 * t22;
  const Scalar t67 = t20 * t20;
  const Scalar U_5_xx = t18 + t67;
  const Scalar U_5_xx_yy = U_5_xx - U_5_yy;
  const Scalar U_5_yx = qdd_5 - t21;
  const Scalar t68 = Scalar(6.823068516838894e-08) * t24 + Scalar(0.0007940924716883453) * t27 -
      Scalar(0.002280028171323094) * U_5_xy - Scalar(0.000015550028164806267) * U_5_yx +
      Scalar(1.609852873477455e-07) * U_5_xx_yy - N_6_z +
      Scalar(0.000615720268358608) * s_6 * U_6_yy - Scalar(0.000615720268358608) * c_6 * U_6_xy -
      Scalar(0.000020065123418265) * c_4 * c_5 - Scalar(0.1737624403145115) * c_4 * s_5;
  tau[4] = -t68;
  const Scalar t69 = omega_3_z * omega_3_z;
  const Scalar U_3_yy = t69 + t7 * t7;
  const Scalar t70 = t5 * t5;
  const Scalar U_2_xx = t3 + t70;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  const Scalar U_2_yx = qdd_2 - t6;
  const Scalar t71 = Scalar(6.823068516838894e-08) * t9 - Scalar(0.0007940924716883453) * t12 -
      Scalar(0.002280028171323094) * U_2_xy - Scalar(0.000015550028164806267) * U_2_yx -
      Scalar(1.609852873477455e-07) * U_2_xx_yy - N_3_z +
      Scalar(0.000615720268358608) * s_3 * U_3_yy - Scalar(0.000615720268358608) * c_3 * U_3_xy +
      Scalar(0.000020065123418265) * c_1 * c_2 - Scalar(0.1737624403145115) * c_1 * s_2;
  tau[1] = -t71;
  const Scalar f_e12_y = s_12 * f_e11_x + c_12 * f_e11_y;
  const Scalar t72 = omega_12_z * omega_12_z;
  const Scalar U_12_yy = t72 + t54 * t54;
  const Scalar f_12_y = f_e12_y + Scalar(0.0038482516772413) * U_12_yy;
  const Scalar f_u_12_t_x = s_12 * f_12_y - c_12 * (t47 + Scalar(0.0038482516772413) * U_12_xy);
  const Scalar t73 = t52 * t52;
  const Scalar U_11_xx = t50 + t73;
  const Scalar U_11_xx_yy = U_11_xx - U_11_yy;
  const Scalar U_11_yx = qdd_11 - t53;
  const Scalar t74 = Scalar(6.823068516838894e-08) * t56 + Scalar(0.0007940924716883453) * t59 -
      Scalar(0.002280028171323094) * U_11_xy - Scalar(0.000015550028164806267) * U_11_yx +
      Scalar(1.609852873477455e-07) * U_11_xx_yy - mu_12_z + Scalar(0.16) * f_u_12_t_x -
      Scalar(0.000020065123418265) * c_10 * c_11 - Scalar(0.1737624403145115) * c_10 * s_11;
  tau[10] = -t74;
  const Scalar N_9_y = Scalar(0.00023148988883634047) * U_9_xy - Scalar(1.505e-06) * (t43 + t44);
  const Scalar t75 = omega_r_9_y * omega_9_z + qd_9 * omega_r_9_y + s_9 * domega_8_y + c_9 * t40;
  const Scalar U_8_zy = t38 + t40;
  const Scalar N_9_x = Scalar(0.037751348953737156) * s_7 - Scalar(0.000615720268358608) * U_8_zy -
      Scalar(0.0005411142213171667) * t75 +
      Scalar(0.00023148988883634047) * (t63 - omega_r_9_y * omega_r_9_y);
  const Scalar U_8_zx = t41 + domega_8_y;
  const Scalar U_8_zz = t64 + t32;
  const Scalar U_8_zz_xx = U_8_xx - U_8_zz;
  const Scalar mu_8_y = Scalar(0.000020065123418265) * s_7 +
      Scalar(0.0007940924716883453) * U_8_xy + Scalar(0.000015550028164806267) * U_8_zx -
      Scalar(1.609852873477455e-07) * U_8_zy + Scalar(6.823068516838894e-08) * U_8_zz_xx -
      s_9 * N_9_x + c_9 * N_9_y;
  const Scalar U_8_yy_zz = U_8_yy - U_8_zz;
  const Scalar mu_8_x = Scalar(0.1737624403145115) * s_7 - Scalar(6.823068516838894e-08) * U_8_yx +
      Scalar(1.609852873477455e-07) * U_8_zx - Scalar(0.002280028171323094) * U_8_zy -
      Scalar(0.000615720268358608) * t75 + Scalar(0.0007940924716883453) * U_8_yy_zz + s_9 * N_9_y +
      c_9 * N_9_x;
  tau[6] = Scalar(0.08509272390476785) * c_7 + Scalar(0.00035882787553735663) * qdd_7 +
      s_8 * mu_8_y + c_8 * mu_8_x;
  const Scalar N_3_y = Scalar(0.00023148988883634047) * U_3_xy - Scalar(1.505e-06) * (t13 + t14);
  const Scalar t76 = omega_r_3_y * omega_3_z + qd_3 * omega_r_3_y + s_3 * domega_2_y + c_3 * t10;
  const Scalar U_2_zy = t8 + t10;
  const Scalar N_3_x = Scalar(0.037751348953737156) * s_1 - Scalar(0.000615720268358608) * U_2_zy -
      Scalar(0.0005411142213171667) * t76 +
      Scalar(0.00023148988883634047) * (t69 - omega_r_3_y * omega_r_3_y);
  const Scalar U_2_zx = t11 + domega_2_y;
  const Scalar U_2_zz = t70 + t2;
  const Scalar U_2_zz_xx = U_2_xx - U_2_zz;
  const Scalar mu_2_y = Scalar(0.000020065123418265) * s_1 +
      Scalar(0.0007940924716883453) * U_2_xy + Scalar(0.000015550028164806267) * U_2_zx -
      Scalar(1.609852873477455e-07) * U_2_zy + Scalar(6.823068516838894e-08) * U_2_zz_xx -
      s_3 * N_3_x + c_3 * N_3_y;
  const Scalar U_2_yy_zz = U_2_yy - U_2_zz;
  const Scalar mu_2_x = Scalar(0.1737624403145115) * s_1 - Scalar(6.823068516838894e-08) * U_2_yx +
      Scalar(1.609852873477455e-07) * U_2_zx - Scalar(0.002280028171323094) * U_2_zy -
      Scalar(0.000615720268358608) * t76 + Scalar(0.0007940924716883453) * U_2_yy_zz + s_3 * N_3_y +
      c_3 * N_3_x;
  tau[0] = Scalar(0.08509272390476785) * c_1 + Scalar(0.00035882787553735663) * qdd_1 +
      s_2 * mu_2_y + c_2 * mu_2_x;
  const Scalar t77 = omega_r_12_y * omega_12_z + qd_12 * omega_r_12_y + s_12 * domega_11_y +
      c_12 * t57;
  const Scalar t78 = s_10 * h_e_5 - c_10 * h_e_6;
  const Scalar mu_e11_y = s_11 * h_e_4 - c_11 * t78;
  const Scalar mu_e11_x = s_11 * t78 + c_11 * h_e_4;
  const Scalar U_11_zy = t55 + t57;
  const Scalar f_e10_y = s_10 * h_e_3 + c_10 * h_e_2;
  const Scalar t79 = Scalar(0.16) * f_e10_y;
  const Scalar mu_12_x = Scalar(0.037751348953737156) * s_10 - Scalar(0.05945) * f_e12_y -
      Scalar(0.000615720268358608) * U_11_zy - Scalar(0.0005411142213171667) * t77 -
      Scalar(0.00023148988883634047) * (t72 - omega_r_12_y * omega_r_12_y) - s_12 * mu_e11_y +
      c_12 * mu_e11_x + t79;
  const Scalar t80 = Scalar(0.05945) * t47 + Scalar(0.00023148988883634047) * U_12_xy +
      Scalar(1.505e-06) * (t60 + t61) - s_12 * mu_e11_x - c_12 * mu_e11_y;
  const Scalar U_11_zx = t58 + domega_11_y;
  const Scalar U_11_zz = t73 + t49;
  const Scalar U_11_zz_xx = U_11_xx - U_11_zz;
  const Scalar mu_11_y = Scalar(0.000020065123418265) * s_10 +
      Scalar(0.0007940924716883453) * U_11_xy - Scalar(0.000015550028164806267) * U_11_zx -
      Scalar(1.609852873477455e-07) * U_11_zy - Scalar(6.823068516838894e-08) * U_11_zz_xx +
      s_12 * mu_12_x + c_12 * t80;
  const Scalar U_11_yy_zz = U_11_yy - U_11_zz;
  const Scalar mu_11_x = Scalar(0.1737624403145115) * s_10 -
      Scalar(6.823068516838894e-08) * U_11_yx - Scalar(1.609852873477455e-07) * U_11_zx -
      Scalar(0.002280028171323094) * U_11_zy - Scalar(0.000615720268358608) * t77 -
      Scalar(0.0007940924716883453) * U_11_yy_zz + t79 - s_12 * t80 + c_12 * mu_12_x;
  tau[9] = Scalar(0.00035882787553735663) * qdd_10 - Scalar(0.08509272390476785) * c_10 -
      s_11 * mu_11_y + c_11 * mu_11_x;
  const Scalar N_6_y = Scalar(0.00023148988883634047) * U_6_xy + Scalar(1.505e-06) * (t28 + t29);
  const Scalar t81 = omega_r_6_y * omega_6_z + qd_6 * omega_r_6_y + s_6 * domega_5_y + c_6 * t25;
  const Scalar U_5_zy = t23 + t25;
  const Scalar N_6_x = Scalar(0.037751348953737156) * s_4 - Scalar(0.000615720268358608) * U_5_zy -
      Scalar(0.0005411142213171667) * t81 -
      Scalar(0.00023148988883634047) * (t66 - omega_r_6_y * omega_r_6_y);
  const Scalar U_5_zx = t26 + domega_5_y;
  const Scalar U_5_zz = t67 + t17;
  const Scalar U_5_zz_xx = U_5_xx - U_5_zz;
  const Scalar mu_5_y = Scalar(0.000020065123418265) * s_4 +
      Scalar(0.0007940924716883453) * U_5_xy - Scalar(0.000015550028164806267) * U_5_zx -
      Scalar(1.609852873477455e-07) * U_5_zy - Scalar(6.823068516838894e-08) * U_5_zz_xx +
      s_6 * N_6_x + c_6 * N_6_y;
  const Scalar U_5_yy_zz = U_5_yy - U_5_zz;
  const Scalar mu_5_x = Scalar(0.1737624403145115) * s_4 - Scalar(6.823068516838894e-08) * U_5_yx -
      Scalar(1.609852873477455e-07) * U_5_zx - Scalar(0.002280028171323094) * U_5_zy -
      Scalar(0.000615720268358608) * t81 - Scalar(0.0007940924716883453) * U_5_yy_zz - s_6 * N_6_y +
      c_6 * N_6_x;
  tau[3] = Scalar(0.00035882787553735663) * qdd_4 - Scalar(0.08509272390476785) * c_4 -
      s_5 * mu_5_y + c_5 * mu_5_x;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[144] = {
    1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1};

// joint-space inertia matrix B(q) (7.32).
//   q[12]   in   joint positions, rad or m
//   B[144]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//                12 x 12, row by row: entry (i, j) is B[12 * i + j]
// Reads q[1..2], q[4..5], q[7..8], q[10..11]. Operations: 64 mul, 60 add, 16 sin/cos. Always zero:
// 108 of the 144 entries of B.
template <class Scalar>
inline void inertia_matrix(const Scalar* q, Scalar* B) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_5 = q[4], q_6 = q[5], q_8 = q[7], q_9 = q[8], q_11 = q[10],
      q_12 = q[11];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_8 = sin(q_8), c_8 = cos(q_8);
  const Scalar s_9 = sin(q_9), c_9 = cos(q_9);
  const Scalar s_11 = sin(q_11), c_11 = cos(q_11);
  const Scalar s_12 = sin(q_12), c_12 = cos(q_12);
  B[14] = B[25] = Scalar(0.000615720268358608) * c_3 + Scalar(0.0005426192213171668);
  B[53] = B[64] = Scalar(0.000615720268358608) * c_6 + Scalar(0.0005426192213171668);
  B[92] = B[103] = Scalar(0.000615720268358608) * c_9 + Scalar(0.0005426192213171668);
  B[131] = B[142] = Scalar(0.000615720268358608) * c_12 + Scalar(0.0005426192213171668);
  const Scalar t1 = Scalar(0.001231440536717216) * c_12;
  B[130] = t1 + Scalar(0.002838197420805067);
  const Scalar t2 = Scalar(0.001231440536717216) * c_9;
  B[91] = t2 + Scalar(0.002838197420805067);
  const Scalar t3 = Scalar(0.001231440536717216) * c_6;
  B[52] = t3 + Scalar(0.002838197420805067);
  const Scalar t4 = Scalar(0.001231440536717216) * c_3;
  B[13] = t4 + Scalar(0.002838197420805067);
  const Scalar t5 = Scalar(0.00023148988883634047) * c_3;
  const Scalar t6 = Scalar(0.00023148988883634047) * s_3;
  B[2] = B[24] = s_2 * t5 + c_2 * t6;
  const Scalar t7 = Scalar(0.00023148988883634047) * c_9;
  const Scalar t8 = Scalar(0.00023148988883634047) * s_9;
  B[80] = B[102] = s_8 * t7 + c_8 * t8;
  const Scalar Ic_8_yz = t7 + Scalar(0.0007940924716883453);
  const Scalar Ic_8_xz = t8 - Scalar(6.823068516838894e-08);
  B[79] = B[90] = s_8 * Ic_8_yz + c_8 * Ic_8_xz;
  const Scalar Ic_2_yz = t5 + Scalar(0.0007940924716883453);
  const Scalar Ic_2_xz = t6 - Scalar(6.823068516838894e-08);
  B[1] = B[12] = s_2 * Ic_2_yz + c_2 * Ic_2_xz;
  const Scalar t9 = Scalar(0.00023148988883634047) * c_6;
  const Scalar t10 = Scalar(0.00023148988883634047) * s_6;
  B[41] = B[63] = -s_5 * t9 - c_5 * t10;
  const Scalar t11 = Scalar(0.00023148988883634047) * c_12;
  const Scalar t12 = Scalar(0.00023148988883634047) * s_12;
  B[119] = B[141] = -s_11 * t11 - c_11 * t12;
  const Scalar Ic_11_yz = t11 + Scalar(0.0007940924716883453);
  const Scalar Ic_11_xz = t12 + Scalar(6.823068516838894e-08);
  B[118] = B[129] = -s_11 * Ic_11_yz - c_11 * Ic_11_xz;
  const Scalar Ic_5_yz = t9 + Scalar(0.0007940924716883453);
  const Scalar Ic_5_xz = t10 + Scalar(6.823068516838894e-08);
  B[40] = B[51] = -s_5 * Ic_5_yz - c_5 * Ic_5_xz;
  const Scalar t13 = Scalar(0.0005396092213171668) * c_12;
  const Scalar t14 = c_12 * t13;
  const Scalar Ic_11_xx = t14 + t1 + Scalar(0.0022644781431582876);
  const Scalar Iu_11_t_d = t14 + Ic_11_xx - Scalar(0.0005396092213171668);
  const Scalar Ic_11_xy = Scalar(0.000615720268358608) * s_12 + s_12 * t13 +
      Scalar(1.609852873477455e-07);
  const Scalar Iu_11_t_g = s_11 * Iu_11_t_d + Scalar(2.0) * c_11 * Ic_11_xy;
  B[117] = Ic_11_xx - s_11 * Iu_11_t_g + Scalar(0.00037588290370216287);
  const Scalar t15 = Scalar(0.0005396092213171668) * c_9;
  const Scalar t16 = c_9 * t15;
  const Scalar Ic_8_xx = t16 + t2 + Scalar(0.0022644781431582876);
  const Scalar Iu_8_t_d = t16 + Ic_8_xx - Scalar(0.0005396092213171668);
  const Scalar Ic_8_xy = Scalar(0.000615720268358608) * s_9 + s_9 * t15 -
      Scalar(1.609852873477455e-07);
  const Scalar Iu_8_t_g = s_8 * Iu_8_t_d + Scalar(2.0) * c_8 * Ic_8_xy;
  B[78] = Ic_8_xx - s_8 * Iu_8_t_g + Scalar(0.00037588290370216287);
  const Scalar t17 = Scalar(0.0005396092213171668) * c_6;
  const Scalar t18 = c_6 * t17;
  const Scalar Ic_5_xx = t18 + t3 + Scalar(0.0022644781431582876);
  const Scalar Iu_5_t_d = t18 + Ic_5_xx - Scalar(0.0005396092213171668);
  const Scalar Ic_5_xy = Scalar(0.000615720268358608) * s_6 + s_6 * t17 +
      Scalar(1.609852873477455e-07);
  const Scalar Iu_5_t_g = s_5 * Iu_5_t_d + Scalar(2.0) * c_5 * Ic_5_xy;
  B[39] = Ic_5_xx - s_5 * Iu_5_t_g + Scalar(0.00037588290370216287);
  const Scalar t19 = Scalar(0.0005396092213171668) * c_3;
  const Scalar t20 = c_3 * t19;
  const Scalar Ic_2_xx = t20 + t4 + Scalar(0.0022644781431582876);
  const Scalar Iu_2_t_d = t20 + Ic_2_xx - Scalar(0.0005396092213171668);
  const Scalar Ic_2_xy = Scalar(0.000615720268358608) * s_3 + s_3 * t19 -
      Scalar(1.609852873477455e-07);
  const Scalar Iu_2_t_g = s_2 * Iu_2_t_d + Scalar(2.0) * c_2 * Ic_2_xy;
  B[0] = Ic_2_xx - s_2 * Iu_2_t_g + Scalar(0.00037588290370216287);
  B[3] = B[4] = B[5] = B[6] = B[7] = B[8] = B[9] = B[10] = Scalar(0.0);
  B[11] = B[15] = B[16] = B[17] = B[18] = B[19] = B[20] = B[21] = Scalar(0.0);
  B[22] = B[23] = B[27] = B[28] = B[29] = B[30] = B[31] = B[32] = Scalar(0.0);
  B[33] = B[34] = B[35] = B[36] = B[37] = B[38] = B[42] = B[43] = Scalar(0.0);
  B[44] = B[45] = B[46] = B[47] = B[48] = B[49] = B[50] = B[54] = Scalar(0.0);
  B[55] = B[56] = B[57] = B[58] = B[59] = B[60] = B[61] = B[62] = Scalar(0.0);
  B[66] = B[67] = B[68] = B[69] = B[70] = B[71] = B[72] = B[73] = Scalar(0.0);
  B[74] = B[75] = B[76] = B[77] = B[81] = B[82] = B[83] = B[84] = Scalar(0.0);
  B[85] = B[86] = B[87] = B[88] = B[89] = B[93] = B[94] = B[95] = Scalar(0.0);
  B[96] = B[97] = B[98] = B[99] = B[100] = B[101] = B[105] = B[106] = Scalar(0.0);
  B[107] = B[108] = B[109] = B[110] = B[111] = B[112] = B[113] = B[114] = Scalar(0.0);
  B[115] = B[116] = B[120] = B[121] = B[122] = B[123] = B[124] = B[125] = Scalar(0.0);
  B[126] = B[127] = B[128] = B[132] = B[133] = B[134] = B[135] = B[136] = Scalar(0.0);
  B[137] = B[138] = B[139] = B[140] = Scalar(0.0);
  B[26] = B[65] = B[104] = B[143] = Scalar(0.0005426192213171668);
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[936] = {
    0, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0,
        0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[12]   in   joint positions, rad or m
//   c[936]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//                c_ijk = c_ikj is c[78 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads q[1..2], q[4..5], q[7..8], q[10..11]. Operations: 96 mul, 48 add, 16 sin/cos. Always zero:
// 896 of the 936 entries of c.
template <class Scalar>
inline void christoffel(const Scalar* q, Scalar* c) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_5 = q[4], q_6 = q[5], q_8 = q[7], q_9 = q[8], q_11 = q[10],
      q_12 = q[11];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_8 = sin(q_8), c_8 = cos(q_8);
  const Scalar s_9 = sin(q_9), c_9 = cos(q_9);
  const Scalar s_11 = sin(q_11), c_11 = cos(q_11);
  const Scalar s_12 = sin(q_12), c_12 = cos(q_12);
  c[158] = Scalar(0.000615720268358608) * s_3;
  c[82] = c[83] = Scalar(-0.000615720268358608) * s_3;
  c[404] = Scalar(0.000615720268358608) * s_6;
  c[331] = c[332] = Scalar(-0.000615720268358608) * s_6;
  c[659] = Scalar(0.000615720268358608) * s_9;
  c[589] = c[590] = Scalar(-0.000615720268358608) * s_9;
  c[923] = Scalar(0.000615720268358608) * s_12;
  c[856] = c[857] = Scalar(-0.000615720268358608) * s_12;
  const Scalar t1 = c_2 * c_3 - s_2 * s_3;
  c[4] = c[5] = Scalar(0.00023148988883634047) * t1;
  const Scalar t2 = c_5 * c_6 - s_5 * s_6;
  c[253] = c[254] = Scalar(-0.00023148988883634047) * t2;
  const Scalar t3 = c_8 * c_9 - s_8 * s_9;
  c[511] = c[512] = Scalar(0.00023148988883634047) * t3;
  const Scalar t4 = c_11 * c_12 - s_11 * s_12;
  c[778] = c[779] = Scalar(-0.00023148988883634047) * t4;
  const Scalar Ic_2_yz = Scalar(0.00011574494441817024) * c_3 + Scalar(0.00039704623584417266);
  const Scalar Ic_2_xz = Scalar(0.00011574494441817024) * s_3 - Scalar(3.411534258419447e-08);
  c[2] = Scalar(2.0) * (c_2 * Ic_2_yz - s_2 * Ic_2_xz);
  const Scalar dmu_1_3_y = Scalar(0.000615720268358608) * c_2 + Scalar(0.0005396092213171668) * t1;
  const Scalar w_1_3_y = c_2 * s_3 + s_2 * c_3;
  const Scalar db_11_3r = w_1_3_y * dmu_1_3_y;
  c[156] = db_11_3r;
  const Scalar Ic_5_yz = Scalar(0.00011574494441817024) * c_6 + Scalar(0.00039704623584417266);
  const Scalar Ic_5_xz = Scalar(0.00011574494441817024) * s_6 + Scalar(3.411534258419447e-08);
  c[248] = Scalar(-2.0) * (c_5 * Ic_5_yz - s_5 * Ic_5_xz);
  const Scalar dmu_4_6_y = Scalar(0.000615720268358608) * c_5 + Scalar(0.0005396092213171668) * t2;
  const Scalar w_4_6_y = c_5 * s_6 + s_5 * c_6;
  const Scalar db_44_6r = w_4_6_y * dmu_4_6_y;
  c[399] = db_44_6r;
  const Scalar Ic_8_yz = Scalar(0.00011574494441817024) * c_9 + Scalar(0.00039704623584417266);
  const Scalar Ic_8_xz = Scalar(0.00011574494441817024) * s_9 - Scalar(3.411534258419447e-08);
  c[503] = Scalar(2.0) * (c_8 * Ic_8_yz - s_8 * Ic_8_xz);
  const Scalar dmu_7_9_y = Scalar(0.000615720268358608) * c_8 + Scalar(0.0005396092213171668) * t3;
  const Scalar w_7_9_y = c_8 * s_9 + s_8 * c_9;
  const Scalar db_77_9r = w_7_9_y * dmu_7_9_y;
  c[651] = db_77_9r;
  const Scalar Ic_11_yz = Scalar(0.00011574494441817024) * c_12 + Scalar(0.00039704623584417266);
  const Scalar Ic_11_xz = Scalar(0.00011574494441817024) * s_12 + Scalar(3.411534258419447e-08);
  c[767] = Scalar(-2.0) * (c_11 * Ic_11_yz - s_11 * Ic_11_xz);
  const Scalar dmu_10_12_y = Scalar(0.000615720268358608) * c_11 +
      Scalar(0.0005396092213171668) * t4;
  const Scalar w_10_12_y = c_11 * s_12 + s_11 * c_12;
  const Scalar db_1010_12r = w_10_12_y * dmu_10_12_y;
  c[912] = db_1010_12r;
  c[3] = -db_11_3r;
  c[252] = -db_44_6r;
  c[510] = -db_77_9r;
  c[777] = -db_1010_12r;
  const Scalar t5 = Scalar(0.0005396092213171668) * c_3 + Scalar(0.000615720268358608);
  const Scalar Ic_2_xy = s_3 * t5 - Scalar(1.609852873477455e-07);
  const Scalar Iu_2_t_d = c_3 * t5 + Scalar(0.0008624344609205605);
  const Scalar Iu_2_t_g = c_2 * Ic_2_xy + s_2 * Iu_2_t_d;
  const Scalar db_11_2r = c_2 * Iu_2_t_g + s_2 * (c_2 * Iu_2_t_d - s_2 * Ic_2_xy);
  c[78] = db_11_2r;
  const Scalar t6 = Scalar(0.0005396092213171668) * c_6 + Scalar(0.000615720268358608);
  const Scalar Ic_5_xy = s_6 * t6 + Scalar(1.609852873477455e-07);
  const Scalar Iu_5_t_d = c_6 * t6 + Scalar(0.0008624344609205605);
  const Scalar Iu_5_t_g = c_5 * Ic_5_xy + s_5 * Iu_5_t_d;
  const Scalar db_44_5r = c_5 * Iu_5_t_g + s_5 * (c_5 * Iu_5_t_d - s_5 * Ic_5_xy);
  c[321] = db_44_5r;
  const Scalar t7 = Scalar(0.0005396092213171668) * c_9 + Scalar(0.000615720268358608);
  const Scalar Ic_8_xy = s_9 * t7 - Scalar(1.609852873477455e-07);
  const Scalar Iu_8_t_d = c_9 * t7 + Scalar(0.0008624344609205605);
  const Scalar Iu_8_t_g = c_8 * Ic_8_xy + s_8 * Iu_8_t_d;
  const Scalar db_77_8r = c_8 * Iu_8_t_g + s_8 * (c_8 * Iu_8_t_d - s_8 * Ic_8_xy);
  c[573] = db_77_8r;
  const Scalar t8 = Scalar(0.0005396092213171668) * c_12 + Scalar(0.000615720268358608);
  const Scalar Ic_11_xy = s_12 * t8 + Scalar(1.609852873477455e-07);
  const Scalar Iu_11_t_d = c_12 * t8 + Scalar(0.0008624344609205605);
  const Scalar Iu_11_t_g = c_11 * Ic_11_xy + s_11 * Iu_11_t_d;
  const Scalar db_1010_11r = c_11 * Iu_11_t_g + s_11 * (c_11 * Iu_11_t_d - s_11 * Ic_11_xy);
  c[834] = db_1010_11r;
  c[1] = -db_11_2r;
  c[247] = -db_44_5r;
  c[502] = -db_77_8r;
  c[766] = -db_1010_11r;
  c[0] = c[6] = c[7] = c[8] = c[9] = c[10] = c[11] = c[12] = Scalar(0.0);
  c[13] = c[14] = c[15] = c[16] = c[17] = c[18] = c[19] = c[20] = Scalar(0.0);
  c[21] = c[22] = c[23] = c[24] = c[25] = c[26] = c[27] = c[28] = Scalar(0.0);
  c[29] = c[30] = c[31] = c[32] = c[33] = c[34] = c[35] = c[36] = Scalar(0.0);
  c[37] = c[38] = c[39] = c[40] = c[41] = c[42] = c[43] = c[44] = Scalar(0.0);
  c[45] = c[46] = c[47] = c[48] = c[49] = c[50] = c[51] = c[52] = Scalar(0.0);
  c[53] = c[54] = c[55] = c[56] = c[57] = c[58] = c[59] = c[60] = Scalar(0.0);
  c[61] = c[62] = c[63] = c[64] = c[65] = c[66] = c[67] = c[68] = Scalar(0.0);
  c[69] = c[70] = c[71] = c[72] = c[73] = c[74] = c[75] = c[76] = Scalar(0.0);
  c[77] = c[79] = c[80] = c[81] = c[84] = c[85] = c[86] = c[87] = Scalar(0.0);
  c[88] = c[89] = c[90] = c[91] = c[92] = c[93] = c[94] = c[95] = Scalar(0.0);
  c[96] = c[97] = c[98] = c[99] = c[100] = c[101] = c[102] = c[103] = Scalar(0.0);
  c[104] = c[105] = c[106] = c[107] = c[108] = c[109] = c[110] = c[111] = Scalar(0.0);
  c[112] = c[113] = c[114] = c[115] = c[116] = c[117] = c[118] = c[119] = Scalar(0.0);
  c[120] = c[121] = c[122] = c[123] = c[124] = c[125] = c[126] = c[127] = Scalar(0.0);
  c[128] = c[129] = c[130] = c[131] = c[132] = c[133] = c[134] = c[135] = Scalar(0.0);
  c[136] = c[137] = c[138] = c[139] = c[140] = c[141] = c[142] = c[143] = Scalar(0.0);
  c[144] = c[145] = c[146] = c[147] = c[148] = c[149] = c[150] = c[151] = Scalar(0.0);
  c[152] = c[153] = c[154] = c[155] = c[157] = c[159] = c[160] = c[161] = Scalar(0.0);
  c[162] = c[163] = c[164] = c[165] = c[166] = c[167] = c[168] = c[169] = Scalar(0.0);
  c[170] = c[171] = c[172] = c[173] = c[174] = c[175] = c[176] = c[177] = Scalar(0.0);
  c[178] = c[179] = c[180] = c[181] = c[182] = c[183] = c[184] = c[185] = Scalar(0.0);
  c[186] = c[187] = c[188] = c[189] = c[190] = c[191] = c[192] = c[193] = Scalar(0.0);
  c[194] = c[195] = c[196] = c[197] = c[198] = c[199] = c[200] = c[201] = Scalar(0.0);
  c[202] = c[203] = c[204] = c[205] = c[206] = c[207] = c[208] = c[209] = Scalar(0.0);
  c[210] = c[211] = c[212] = c[213] = c[214] = c[215] = c[216] = c[217] = Scalar(0.0);
  c[218] = c[219] = c[220] = c[221] = c[222] = c[223] = c[224] = c[225] = Scalar(0.0);
  c[226] = c[227] = c[228] = c[229] = c[230] = c[231] = c[232] = c[233] = Scalar(0.0);
  c[234] = c[235] = c[236] = c[237] = c[238] = c[239] = c[240] = c[241] = Scalar(0.0);
  c[242] = c[243] = c[244] = c[245] = c[246] = c[249] = c[250] = c[251] = Scalar(0.0);
  c[255] = c[256] = c[257] = c[258] = c[259] = c[260] = c[261] = c[262] = Scalar(0.0);
  c[263] = c[264] = c[265] = c[266] = c[267] = c[268] = c[269] = c[270] = Scalar(0.0);
  c[271] = c[272] = c[273] = c[274] = c[275] = c[276] = c[277] = c[278] = Scalar(0.0);
  c[279] = c[280] = c[281] = c[282] = c[283] = c[284] = c[285] = c[286] = Scalar(0.0);
  c[287] = c[288] = c[289] = c[290] = c[291] = c[292] = c[293] = c[294] = Scalar(0.0);
  c[295] = c[296] = c[297] = c[298] = c[299] = c[300] = c[301] = c[302] = Scalar(0.0);
  c[303] = c[304] = c[305] = c[306] = c[307] = c[308] = c[309] = c[310] = Scalar(0.0);
  c[311] = c[312] = c[313] = c[314] = c[315] = c[316] = c[317] = c[318] = Scalar(0.0);
  c[319] = c[320] = c[322] = c[323] = c[324] = c[325] = c[326] = c[327] = Scalar(0.0);
  c[328] = c[329] = c[330] = c[333] = c[334] = c[335] = c[336] = c[337] = Scalar(0.0);
  c[338] = c[339] = c[340] = c[341] = c[342] = c[343] = c[344] = c[345] = Scalar(0.0);
  c[346] = c[347] = c[348] = c[349] = c[350] = c[351] = c[352] = c[353] = Scalar(0.0);
  c[354] = c[355] = c[356] = c[357] = c[358] = c[359] = c[360] = c[361] = Scalar(0.0);
  c[362] = c[363] = c[364] = c[365] = c[366] = c[367] = c[368] = c[369] = Scalar(0.0);
  c[370] = c[371] = c[372] = c[373] = c[374] = c[375] = c[376] = c[377] = Scalar(0.0);
  c[378] = c[379] = c[380] = c[381] = c[382] = c[383] = c[384] = c[385] = Scalar(0.0);
  c[386] = c[387] = c[388] = c[389] = c[390] = c[391] = c[392] = c[393] = Scalar(0.0);
  c[394] = c[395] = c[396] = c[397] = c[398] = c[400] = c[401] = c[402] = Scalar(0.0);
  c[403] = c[405] = c[406] = c[407] = c[408] = c[409] = c[410] = c[411] = Scalar(0.0);
  c[412] = c[413] = c[414] = c[415] = c[416] = c[417] = c[418] = c[419] = Scalar(0.0);
  c[420] = c[421] = c[422] = c[423] = c[424] = c[425] = c[426] = c[427] = Scalar(0.0);
  c[428] = c[429] = c[430] = c[431] = c[432] = c[433] = c[434] = c[435] = Scalar(0.0);
  c[436] = c[437] = c[438] = c[439] = c[440] = c[441] = c[442] = c[443] = Scalar(0.0);
  c[444] = c[445] = c[446] = c[447] = c[448] = c[449] = c[450] = c[451] = Scalar(0.0);
  c[452] = c[453] = c[454] = c[455] = c[456] = c[457] = c[458] = c[459] = Scalar(0.0);
  c[460] = c[461] = c[462] = c[463] = c[464] = c[465] = c[466] = c[467] = Scalar(0.0);
  c[468] = c[469] = c[470] = c[471] = c[472] = c[473] = c[474] = c[475] = Scalar(0.0);
  c[476] = c[477] = c[478] = c[479] = c[480] = c[481] = c[482] = c[483] = Scalar(0.0);
  c[484] = c[485] = c[486] = c[487] = c[488] = c[489] = c[490] = c[491] = Scalar(0.0);
  c[492] = c[493] = c[494] = c[495] = c[496] = c[497] = c[498] = c[499] = Scalar(0.0);
  c[500] = c[501] = c[504] = c[505] = c[506] = c[507] = c[508] = c[509] = Scalar(0.0);
  c[513] = c[514] = c[515] = c[516] = c[517] = c[518] = c[519] = c[520] = Scalar(0.0);
  c[521] = c[522] = c[523] = c[524] = c[525] = c[526] = c[527] = c[528] = Scalar(0.0);
  c[529] = c[530] = c[531] = c[532] = c[533] = c[534] = c[535] = c[536] = Scalar(0.0);
  c[537] = c[538] = c[539] = c[540] = c[541] = c[542] = c[543] = c[544] = Scalar(0.0);
  c[545] = c[546] = c[547] = c[548] = c[549] = c[550] = c[551] = c[552] = Scalar(0.0);
  c[553] = c[554] = c[555] = c[556] = c[557] = c[558] = c[559] = c[560] = Scalar(0.0);
  c[561] = c[562] = c[563] = c[564] = c[565] = c[566] = c[567] = c[568] = Scalar(0.0);
  c[569] = c[570] = c[571] = c[572] = c[574] = c[575] = c[576] = c[577] = Scalar(0.0);
  c[578] = c[579] = c[580] = c[581] = c[582] = c[583] = c[584] = c[585] = Scalar(0.0);
  c[586] = c[587] = c[588] = c[591] = c[592] = c[593] = c[594] = c[595] = Scalar(0.0);
  c[596] = c[597] = c[598] = c[599] = c[600] = c[601] = c[602] = c[603] = Scalar(0.0);
  c[604] = c[605] = c[606] = c[607] = c[608] = c[609] = c[610] = c[611] = Scalar(0.0);
  c[612] = c[613] = c[614] = c[615] = c[616] = c[617] = c[618] = c[619] = Scalar(0.0);
  c[620] = c[621] = c[622] = c[623] = c[624] = c[625] = c[626] = c[627] = Scalar(0.0);
  c[628] = c[629] = c[630] = c[631] = c[632] = c[633] = c[634] = c[635] = Scalar(0.0);
  c[636] = c[637] = c[638] = c[639] = c[640] = c[641] = c[642] = c[643] = Scalar(0.0);
  c[644] = c[645] = c[646] = c[647] = c[648] = c[649] = c[650] = c[652] = Scalar(0.0);
  c[653] = c[654] = c[655] = c[656] = c[657] = c[658] = c[660] = c[661] = Scalar(0.0);
  c[662] = c[663] = c[664] = c[665] = c[666] = c[667] = c[668] = c[669] = Scalar(0.0);
  c[670] = c[671] = c[672] = c[673] = c[674] = c[675] = c[676] = c[677] = Scalar(0.0);
  c[678] = c[679] = c[680] = c[681] = c[682] = c[683] = c[684] = c[685] = Scalar(0.0);
  c[686] = c[687] = c[688] = c[689] = c[690] = c[691] = c[692] = c[693] = Scalar(0.0);
  c[694] = c[695] = c[696] = c[697] = c[698] = c[699] = c[700] = c[701] = Scalar(0.0);
  c[702] = c[703] = c[704] = c[705] = c[706] = c[707] = c[708] = c[709] = Scalar(0.0);
  c[710] = c[711] = c[712] = c[713] = c[714] = c[715] = c[716] = c[717] = Scalar(0.0);
  c[718] = c[719] = c[720] = c[721] = c[722] = c[723] = c[724] = c[725] = Scalar(0.0);
  c[726] = c[727] = c[728] = c[729] = c[730] = c[731] = c[732] = c[733] = Scalar(0.0);
  c[734] = c[735] = c[736] = c[737] = c[738] = c[739] = c[740] = c[741] = Scalar(0.0);
  c[742] = c[743] = c[744] = c[745] = c[746] = c[747] = c[748] = c[749] = Scalar(0.0);
  c[750] = c[751] = c[752] = c[753] = c[754] = c[755] = c[756] = c[757] = Scalar(0.0);
  c[758] = c[759] = c[760] = c[761] = c[762] = c[763] = c[764] = c[765] = Scalar(0.0);
  c[768] = c[769] = c[770] = c[771] = c[772] = c[773] = c[774] = c[775] = Scalar(0.0);
  c[776] = c[780] = c[781] = c[782] = c[783] = c[784] = c[785] = c[786] = Scalar(0.0);
  c[787] = c[788] = c[789] = c[790] = c[791] = c[792] = c[793] = c[794] = Scalar(0.0);
  c[795] = c[796] = c[797] = c[798] = c[799] = c[800] = c[801] = c[802] = Scalar(0.0);
  c[803] = c[804] = c[805] = c[806] = c[807] = c[808] = c[809] = c[810] = Scalar(0.0);
  c[811] = c[812] = c[813] = c[814] = c[815] = c[816] = c[817] = c[818] = Scalar(0.0);
  c[819] = c[820] = c[821] = c[822] = c[823] = c[824] = c[825] = c[826] = Scalar(0.0);
  c[827] = c[828] = c[829] = c[830] = c[831] = c[832] = c[833] = c[835] = Scalar(0.0);
  c[836] = c[837] = c[838] = c[839] = c[840] = c[841] = c[842] = c[843] = Scalar(0.0);
  c[844] = c[845] = c[846] = c[847] = c[848] = c[849] = c[850] = c[851] = Scalar(0.0);
  c[852] = c[853] = c[854] = c[855] = c[858] = c[859] = c[860] = c[861] = Scalar(0.0);
  c[862] = c[863] = c[864] = c[865] = c[866] = c[867] = c[868] = c[869] = Scalar(0.0);
  c[870] = c[871] = c[872] = c[873] = c[874] = c[875] = c[876] = c[877] = Scalar(0.0);
  c[878] = c[879] = c[880] = c[881] = c[882] = c[883] = c[884] = c[885] = Scalar(0.0);
  c[886] = c[887] = c[888] = c[889] = c[890] = c[891] = c[892] = c[893] = Scalar(0.0);
  c[894] = c[895] = c[896] = c[897] = c[898] = c[899] = c[900] = c[901] = Scalar(0.0);
  c[902] = c[903] = c[904] = c[905] = c[906] = c[907] = c[908] = c[909] = Scalar(0.0);
  c[910] = c[911] = c[913] = c[914] = c[915] = c[916] = c[917] = c[918] = Scalar(0.0);
  c[919] = c[920] = c[921] = c[922] = c[924] = c[925] = c[926] = c[927] = Scalar(0.0);
  c[928] = c[929] = c[930] = c[931] = c[932] = c[933] = c[934] = c[935] = Scalar(0.0);
}

// The entries of C in coriolis_matrix that are not always zero.
inline constexpr bool coriolis_matrix_nonzero[144] = {
    1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0};

// C(q, qd) from the Christoffel symbols (7.44).
//   q[12]   in   joint positions, rad or m
//   qd[12]  in   joint velocities, rad/s or m/s
//   C[144]  out  c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric
//                12 x 12, row by row: entry (i, j) is C[12 * i + j]
// Reads q[1..2], q[4..5], q[7..8], q[10..11], qd[0..11]. Operations: 140 mul, 72 add, 16 sin/cos.
// Always zero: 112 of the 144 entries of C.
template <class Scalar>
inline void coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_5 = q[4], q_6 = q[5], q_8 = q[7], q_9 = q[8], q_11 = q[10],
      q_12 = q[11];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_8 = sin(q_8), c_8 = cos(q_8);
  const Scalar s_9 = sin(q_9), c_9 = cos(q_9);
  const Scalar s_11 = sin(q_11), c_11 = cos(q_11);
  const Scalar s_12 = sin(q_12), c_12 = cos(q_12);
  const Scalar t1 = Scalar(0.000615720268358608) * s_3;
  const Scalar C_3_2 = qd_2 * t1;
  C[25] = C_3_2;
  const Scalar t2 = Scalar(0.000615720268358608) * s_6;
  const Scalar C_6_5 = qd_5 * t2;
  C[64] = C_6_5;
  const Scalar t3 = Scalar(0.000615720268358608) * s_9;
  const Scalar C_9_8 = qd_8 * t3;
  C[103] = C_9_8;
  const Scalar t4 = Scalar(0.000615720268358608) * s_12;
  const Scalar C_12_11 = qd_11 * t4;
  C[142] = C_12_11;
  const Scalar t5 = qd_3 * t1;
  C[13] = -t5;
  const Scalar t6 = qd_6 * t2;
  C[52] = -t6;
  const Scalar t7 = qd_9 * t3;
  C[91] = -t7;
  const Scalar t8 = qd_12 * t4;
  C[130] = -t8;
  C[14] = -t5 - C_3_2;
  C[53] = -t6 - C_6_5;
  C[92] = -t7 - C_9_8;
  C[131] = -t8 - C_12_11;
  const Scalar t9 = s_2 * s_3 - c_2 * c_3;
  const Scalar dmu_1_3_y = Scalar(0.000307860134179304) * c_2 - Scalar(0.0002698046106585834) * t9;
  const Scalar w_1_3_y = s_2 * c_3 + c_2 * s_3;
  const Scalar t10 = dmu_1_3_y * Scalar(2.0) * w_1_3_y;
  const Scalar C_3_1 = qd_1 * t10;
  C[24] = C_3_1;
  const Scalar t11 = s_5 * s_6 - c_5 * c_6;
  const Scalar dmu_4_6_y = Scalar(0.000307860134179304) * c_5 - Scalar(0.0002698046106585834) * t11;
  const Scalar w_4_6_y = s_5 * c_6 + c_5 * s_6;
  const Scalar t12 = dmu_4_6_y * Scalar(2.0) * w_4_6_y;
  const Scalar C_6_4 = qd_4 * t12;
  C[63] = C_6_4;
  const Scalar t13 = s_8 * s_9 - c_8 * c_9;
  const Scalar dmu_7_9_y = Scalar(0.000307860134179304) * c_8 - Scalar(0.0002698046106585834) * t13;
  const Scalar w_7_9_y = s_8 * c_9 + c_8 * s_9;
  const Scalar t14 = dmu_7_9_y * Scalar(2.0) * w_7_9_y;
  const Scalar C_9_7 = qd_7 * t14;
  C[102] = C_9_7;
  const Scalar t15 = s_11 * s_12 - c_11 * c_12;
  const Scalar dmu_10_12_y = Scalar(0.000307860134179304) * c_11 -
      Scalar(0.0002698046106585834) * t15;
  const Scalar w_10_12_y = s_11 * c_12 + c_11 * s_12;
  const Scalar t16 = dmu_10_12_y * Scalar(2.0) * w_10_12_y;
  const Scalar C_12_10 = qd_10 * t16;
  C[141] = C_12_10;
  const Scalar t17 = Scalar(-0.00023148988883634047) * t9;
  const Scalar t18 = qd_3 * t17;
  C[2] = t18 - C_3_1 + qd_2 * t17;
  const Scalar t19 = Scalar(-0.00023148988883634047) * t13;
  const Scalar t20 = qd_9 * t19;
  C[80] = t20 - C_9_7 + qd_8 * t19;
  const Scalar t21 = Scalar(-0.00023148988883634047) * t11;
  const Scalar t22 = qd_6 * t21;
  C[41] = -t22 - C_6_4 - qd_5 * t21;
  const Scalar t23 = Scalar(-0.00023148988883634047) * t15;
  const Scalar t24 = qd_12 * t23;
  C[119] = -t24 - C_12_10 - qd_11 * t23;
  const Scalar t25 = c_3 + Scalar(1.1410484551313946);
  const Scalar Ic_2_xy = Scalar(0.0002698046106585834) * s_3 * t25 - Scalar(8.049264367387275e-08);
  const Scalar t26 = Scalar(2.0) * Ic_2_xy;
  const Scalar Iu_2_t_d = Scalar(0.0005396092213171668) * c_3 * t25 + Scalar(0.0008624344609205605);
  const Scalar Iu_2_t_g = s_2 * Iu_2_t_d + c_2 * t26;
  const Scalar t27 = s_2 * (s_2 * t26 - c_2 * Iu_2_t_d) - c_2 * Iu_2_t_g;
  const Scalar t28 = qd_1 * t27;
  C[12] = -t28;
  const Scalar Ic_2_xz = Scalar(0.00011574494441817024) * s_3 - Scalar(3.411534258419447e-08);
  const Scalar Ic_2_yz = Scalar(0.00011574494441817024) * c_3 + Scalar(0.00039704623584417266);
  C[1] = t28 + t18 - Scalar(2.0) * qd_2 * (s_2 * Ic_2_xz - c_2 * Ic_2_yz);
  const Scalar t29 = c_6 + Scalar(1.1410484551313946);
  const Scalar Ic_5_xy = Scalar(0.0002698046106585834) * s_6 * t29 + Scalar(8.049264367387275e-08);
  const Scalar t30 = Scalar(2.0) * Ic_5_xy;
  const Scalar Iu_5_t_d = Scalar(0.0005396092213171668) * c_6 * t29 + Scalar(0.0008624344609205605);
  const Scalar Iu_5_t_g = s_5 * Iu_5_t_d + c_5 * t30;
  const Scalar t31 = s_5 * (s_5 * t30 - c_5 * Iu_5_t_d) - c_5 * Iu_5_t_g;
  const Scalar t32 = qd_4 * t31;
  C[51] = -t32;
  const Scalar Ic_5_xz = Scalar(0.00011574494441817024) * s_6 + Scalar(3.411534258419447e-08);
  const Scalar Ic_5_yz = Scalar(0.00011574494441817024) * c_6 + Scalar(0.00039704623584417266);
  C[40] = t32 - t22 + Scalar(2.0) * qd_5 * (s_5 * Ic_5_xz - c_5 * Ic_5_yz);
  const Scalar t33 = c_9 + Scalar(1.1410484551313946);
  const Scalar Ic_8_xy = Scalar(0.0002698046106585834) * s_9 * t33 - Scalar(8.049264367387275e-08);
  const Scalar t34 = Scalar(2.0) * Ic_8_xy;
  const Scalar Iu_8_t_d = Scalar(0.0005396092213171668) * c_9 * t33 + Scalar(0.0008624344609205605);
  const Scalar Iu_8_t_g = s_8 * Iu_8_t_d + c_8 * t34;
  const Scalar t35 = s_8 * (s_8 * t34 - c_8 * Iu_8_t_d) - c_8 * Iu_8_t_g;
  const Scalar t36 = qd_7 * t35;
  C[90] = -t36;
  const Scalar Ic_8_xz = Scalar(0.00011574494441817024) * s_9 - Scalar(3.411534258419447e-08);
  const Scalar Ic_8_yz = Scalar(0.00011574494441817024) * c_9 + Scalar(0.00039704623584417266);
  C[79] = t36 + t20 - Scalar(2.0) * qd_8 * (s_8 * Ic_8_xz - c_8 * Ic_8_yz);
  const Scalar t37 = c_12 + Scalar(1.1410484551313946);
  const Scalar Ic_11_xy = Scalar(0.0002698046106585834) * s_12 * t37 +
      Scalar(8.049264367387275e-08);
  const Scalar t38 = Scalar(2.0) * Ic_11_xy;
  const Scalar Iu_11_t_d = Scalar(0.0005396092213171668) * c_12 * t37 +
      Scalar(0.0008624344609205605);
  const Scalar Iu_11_t_g = s_11 * Iu_11_t_d + c_11 * t38;
  const Scalar t39 = s_11 * (s_11 * t38 - c_11 * Iu_11_t_d) - c_11 * Iu_11_t_g;
  const Scalar t40 = qd_10 * t39;
  C[129] = -t40;
  const Scalar Ic_11_xz = Scalar(0.00011574494441817024) * s_12 + Scalar(3.411534258419447e-08);
  const Scalar Ic_11_yz = Scalar(0.00011574494441817024) * c_12 + Scalar(0.00039704623584417266);
  C[118] = t40 - t24 + Scalar(2.0) * qd_11 * (s_11 * Ic_11_xz - c_11 * Ic_11_yz);
  C[0] = qd_2 * t27 - qd_3 * t10;
  C[39] = qd_5 * t31 - qd_6 * t12;
  C[78] = qd_8 * t35 - qd_9 * t14;
  C[117] = qd_11 * t39 - qd_12 * t16;
  C[3] = C[4] = C[5] = C[6] = C[7] = C[8] = C[9] = C[10] = Scalar(0.0);
  C[11] = C[15] = C[16] = C[17] = C[18] = C[19] = C[20] = C[21] = Scalar(0.0);
  C[22] = C[23] = C[26] = C[27] = C[28] = C[29] = C[30] = C[31] = Scalar(0.0);
  C[32] = C[33] = C[34] = C[35] = C[36] = C[37] = C[38] = C[42] = Scalar(0.0);
  C[43] = C[44] = C[45] = C[46] = C[47] = C[48] = C[49] = C[50] = Scalar(0.0);
  C[54] = C[55] = C[56] = C[57] = C[58] = C[59] = C[60] = C[61] = Scalar(0.0);
  C[62] = C[65] = C[66] = C[67] = C[68] = C[69] = C[70] = C[71] = Scalar(0.0);
  C[72] = C[73] = C[74] = C[75] = C[76] = C[77] = C[81] = C[82] = Scalar(0.0);
  C[83] = C[84] = C[85] = C[86] = C[87] = C[88] = C[89] = C[93] = Scalar(0.0);
  C[94] = C[95] = C[96] = C[97] = C[98] = C[99] = C[100] = C[101] = Scalar(0.0);
  C[104] = C[105] = C[106] = C[107] = C[108] = C[109] = C[110] = C[111] = Scalar(0.0);
  C[112] = C[113] = C[114] = C[115] = C[116] = C[120] = C[121] = C[122] = Scalar(0.0);
  C[123] = C[124] = C[125] = C[126] = C[127] = C[128] = C[132] = C[133] = Scalar(0.0);
  C[134] = C[135] = C[136] = C[137] = C[138] = C[139] = C[140] = C[143] = Scalar(0.0);
}

// gravity torques g(q) (7.39).
//   q[12]  in   joint positions, rad or m
//   g[12]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11]. Operations: 48 mul, 28 add, 24 sin/cos.
template <class Scalar>
inline void gravity(const Scalar* q, Scalar* g) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6],
      q_8 = q[7], q_9 = q[8], q_10 = q[9], q_11 = q[10], q_12 = q[11];
  const Scalar s_1 = sin(q_1), c_1 = cos(q_1);
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar s_8 = sin(q_8), c_8 = cos(q_8);
  const Scalar s_9 = sin(q_9), c_9 = cos(q_9);
  const Scalar s_10 = sin(q_10), c_10 = cos(q_10);
  const Scalar s_11 = sin(q_11), c_11 = cos(q_11);
  const Scalar s_12 = sin(q_12), c_12 = cos(q_12);
  const Scalar N_3_z = Scalar(0.037751348953737156) * c_1 * (c_2 * s_3 + s_2 * c_3);
  g[2] = N_3_z;
  const Scalar N_6_z = Scalar(0.037751348953737156) * c_4 * (c_5 * s_6 + s_5 * c_6);
  g[5] = N_6_z;
  const Scalar N_9_z = Scalar(0.037751348953737156) * c_7 * (c_8 * s_9 + s_8 * c_9);
  g[8] = N_9_z;
  const Scalar N_12_z = Scalar(0.037751348953737156) * c_10 * (c_11 * s_12 + s_11 * c_12);
  g[11] = N_12_z;
  g[10] = N_12_z + Scalar(0.000020065123418265) * c_10 * (c_11 + Scalar(8659.923823660012) * s_11);
  g[7] = N_9_z - Scalar(0.000020065123418265) * c_7 * (c_8 - Scalar(8659.923823660012) * s_8);
  const Scalar t1 = s_7 * (s_8 * (s_9 - Scalar(0.0005315074553456102)) -
      c_8 * (c_9 + Scalar(4.60281407500036)));
  g[6] = Scalar(0.08509272390476785) * c_7 - Scalar(0.037751348953737156) * t1;
  g[4] = N_6_z + Scalar(0.000020065123418265) * c_4 * (c_5 + Scalar(8659.923823660012) * s_5);
  g[1] = N_3_z - Scalar(0.000020065123418265) * c_1 * (c_2 - Scalar(8659.923823660012) * s_2);
  const Scalar t2 = s_1 * (s_2 * (s_3 - Scalar(0.0005315074553456102)) -
      c_2 * (c_3 + Scalar(4.60281407500036)));
  g[0] = Scalar(0.08509272390476785) * c_1 - Scalar(0.037751348953737156) * t2;
  const Scalar t3 = s_10 * (s_11 * (s_12 + Scalar(0.0005315074553456102)) -
      c_11 * (c_12 + Scalar(4.60281407500036)));
  g[9] = Scalar(-0.08509272390476785) * c_10 - Scalar(0.037751348953737156) * t3;
  const Scalar t4 = s_4 * (s_5 * (s_6 + Scalar(0.0005315074553456102)) -
      c_5 * (c_6 + Scalar(4.60281407500036)));
  g[3] = Scalar(-0.08509272390476785) * c_4 - Scalar(0.037751348953737156) * t4;
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[12]   in   joint positions, rad or m
//   qd[12]  in   joint velocities, rad/s or m/s
//   n[12]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11], qd[0..11]. Operations: 252 mul, 160 add, 24 sin/cos.
template <class Scalar>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6],
      q_8 = q[7], q_9 = q[8], q_10 = q[9], q_11 = q[10], q_12 = q[11];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11];
  const Scalar s_1 = sin(q_1), c_1 = cos(q_1);
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar s_8 = sin(q_8), c_8 = cos(q_8);
  const Scalar s_9 = sin(q_9), c_9 = cos(q_9);
  const Scalar s_10 = sin(q_10), c_10 = cos(q_10);
  const Scalar s_11 = sin(q_11), c_11 = cos(q_11);
  const Scalar s_12 = sin(q_12), c_12 = cos(q_12);
  const Scalar t1 = qd_1 * qd_1;
  const Scalar t2 = c_2 * t1;
  const Scalar t3 = c_2 * t2;
  const Scalar t4 = qd_2 * qd_2;
  const Scalar U_2_yy = t3 + t4;
  const Scalar t5 = Scalar(9.81) * c_1;
  const Scalar ddp_o_3_y = Scalar(0.16) * U_2_yy + c_2 * t5;
  const Scalar t6 = s_2 * t2;
  const Scalar ddp_o_3_x = s_2 * t5 + Scalar(0.16) * t6;
  const Scalar ddp_3_x = c_3 * ddp_o_3_x + s_3 * ddp_o_3_y;
  const Scalar t7 = c_2 * c_3 - s_2 * s_3;
  const Scalar t8 = t1 * t7;
  const Scalar t9 = s_2 * c_3 + c_2 * s_3;
  const Scalar t10 = t9 * t8;
  const Scalar N_3_z = Scalar(0.0038482516772413) * ddp_3_x + Scalar(0.0005396092213171668) * t10;
  n[2] = N_3_z;
  const Scalar t11 = qd_4 * qd_4;
  const Scalar t12 = c_5 * t11;
  const Scalar t13 = c_5 * t12;
  const Scalar t14 = qd_5 * qd_5;
  const Scalar U_5_yy = t13 + t14;
  const Scalar t15 = Scalar(9.81) * c_4;
  const Scalar ddp_o_6_y = Scalar(0.16) * U_5_yy + c_5 * t15;
  const Scalar t16 = s_5 * t12;
  const Scalar ddp_o_6_x = s_5 * t15 + Scalar(0.16) * t16;
  const Scalar ddp_6_x = c_6 * ddp_o_6_x + s_6 * ddp_o_6_y;
  const Scalar t17 = c_5 * c_6 - s_5 * s_6;
  const Scalar t18 = t11 * t17;
  const Scalar t19 = s_5 * c_6 + c_5 * s_6;
  const Scalar t20 = t19 * t18;
  const Scalar N_6_z = Scalar(0.0038482516772413) * ddp_6_x + Scalar(0.0005396092213171668) * t20;
  n[5] = N_6_z;
  const Scalar t21 = qd_7 * qd_7;
  const Scalar t22 = c_8 * t21;
  const Scalar t23 = c_8 * t22;
  const Scalar t24 = qd_8 * qd_8;
  const Scalar U_8_yy = t23 + t24;
  const Scalar t25 = Scalar(9.81) * c_7;
  const Scalar ddp_o_9_y = Scalar(0.16) * U_8_yy + c_8 * t25;
  const Scalar t26 = s_8 * t22;
  const Scalar ddp_o_9_x = s_8 * t25 + Scalar(0.16) * t26;
  const Scalar ddp_9_x = c_9 * ddp_o_9_x + s_9 * ddp_o_9_y;
  const Scalar t27 = c_8 * c_9 - s_8 * s_9;
  const Scalar t28 = t21 * t27;
  const Scalar t29 = s_8 * c_9 + c_8 * s_9;
  const Scalar t30 = t29 * t28;
  const Scalar N_9_z = Scalar(0.0038482516772413) * ddp_9_x + Scalar(0.0005396092213171668) * t30;
  n[8] = N_9_z;
  const Scalar t31 = qd_10 * qd_10;
  const Scalar t32 = c_11 * t31;
  const Scalar t33 = c_11 * t32;
  const Scalar t34 = qd_11 * qd_11;
  const Scalar U_11_yy = t33 + t34;
  const Scalar t35 = Scalar(9.81) * c_10;
  const Scalar ddp_o_12_y = Scalar(0.16) * U_11_yy + c_11 * t35;
  const Scalar t36 = s_11 * t32;
  const Scalar ddp_o_12_x = s_11 * t35 + Scalar(0.16) * t36;
  const Scalar ddp_12_x = c_12 * ddp_o_12_x + s_12 * ddp_o_12_y;
  const Scalar t37 = c_11 * c_12 - s_11 * s_12;
  const Scalar t38 = t31 * t37;
  const Scalar t39 = s_11 * c_12 + c_11 * s_12;
  const Scalar t40 = t39 * t38;
  const Scalar N_12_z = Scalar(0.0038482516772413) * ddp_12_x + Scalar(0.0005396092213171668) * t40;
  n[11] = N_12_z;
  const Scalar omega_12_z = qd_11 + qd_12;
  const Scalar t41 = omega_12_z * omega_12_z;
  const Scalar U_12_yy = t37 * t38 + t41;
  const Scalar t42 = c_12 * t40 - s_12 * U_12_yy;
  const Scalar U_11_xx = t31 - t33 + t34;
  const Scalar U_11_xx_yy = U_11_xx - U_11_yy;
  n[10] = Scalar(0.0022644781431582876) * t36 - Scalar(1.609852873477455e-07) * U_11_xx_yy +
      N_12_z + Scalar(0.000615720268358608) * t42 + Scalar(0.000020065123418265) * c_10 * c_11 +
      Scalar(0.1737624403145115) * c_10 * s_11;
  const Scalar omega_9_z = qd_8 + qd_9;
  const Scalar t43 = omega_9_z * omega_9_z;
  const Scalar U_9_yy = t27 * t28 + t43;
  const Scalar t44 = c_9 * t30 - s_9 * U_9_yy;
  const Scalar U_8_xx = t21 - t23 + t24;
  const Scalar U_8_xx_yy = U_8_xx - U_8_yy;
  n[7] = Scalar(0.0022644781431582876) * t26 + Scalar(1.609852873477455e-07) * U_8_xx_yy + N_9_z +
      Scalar(0.000615720268358608) * t44 - Scalar(0.000020065123418265) * c_7 * c_8 +
      Scalar(0.1737624403145115) * c_7 * s_8;
  const Scalar omega_6_z = qd_5 + qd_6;
  const Scalar t45 = omega_6_z * omega_6_z;
  const Scalar U_6_yy = t17 * t18 + t45;
  const Scalar t46 = c_6 * t20 - s_6 * U_6_yy;
  const Scalar U_5_xx = t11 - t13 + t14;
  const Scalar U_5_xx_yy = U_5_xx - U_5_yy;
  n[4] = Scalar(0.0022644781431582876) * t16 - Scalar(1.609852873477455e-07) * U_5_xx_yy + N_6_z +
      Scalar(0.000615720268358608) * t46 + Scalar(0.000020065123418265) * c_4 * c_5 +
      Scalar(0.1737624403145115) * c_4 * s_5;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t47 = omega_3_z * omega_3_z;
  const Scalar U_3_yy = t7 * t8 + t47;
  const Scalar t48 = c_3 * t10 - s_3 * U_3_yy;
  const Scalar U_2_xx = t1 - t3 + t4;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  n[1] = Scalar(0.0022644781431582876) * t6 + Scalar(1.609852873477455e-07) * U_2_xx_yy + N_3_z +
      Scalar(0.000615720268358608) * t48 - Scalar(0.000020065123418265) * c_1 * c_2 +
      Scalar(0.1737624403145115) * c_1 * s_2;
  const Scalar t49 = t43 - t21 * t29 * t29;
  const Scalar t50 = qd_7 * omega_9_z;
  const Scalar t51 = t29 * t50;
  const Scalar t52 = qd_7 * qd_8;
  const Scalar t53 = s_8 * t52;
  const Scalar N_9_x = Scalar(0.037751348953737156) * s_7 + Scalar(0.00023148988883634047) * t49 -
      Scalar(0.001231440536717216) * t53 - Scalar(0.0010822284426343334) * t51;
  const Scalar t54 = Scalar(0.00023148988883634047) * t30 + Scalar(3.01e-06) * t27 * t50;
  const Scalar t55 = c_8 * t52;
  const Scalar t56 = Scalar(0.1737624403145115) * s_7 + Scalar(6.823068516838894e-08) * t26 -
      Scalar(0.0007940924716883453) * (t21 - U_8_yy) - Scalar(0.004560056342646188) * t53 -
      Scalar(0.001231440536717216) * t51 + c_9 * N_9_x + s_9 * t54 +
      Scalar(3.21970574695491e-07) * t55;
  const Scalar mu_8_y = Scalar(0.000020065123418265) * s_7 + Scalar(0.0007940924716883453) * t26 -
      Scalar(6.823068516838894e-08) * (t21 - U_8_xx) - Scalar(3.21970574695491e-07) * t53 +
      Scalar(0.000031100056329612534) * t55 + c_9 * t54 - s_9 * N_9_x;
  n[6] = Scalar(0.08509272390476785) * c_7 + c_8 * t56 + s_8 * mu_8_y;
  const Scalar t57 = t47 - t1 * t9 * t9;
  const Scalar t58 = qd_1 * omega_3_z;
  const Scalar t59 = t9 * t58;
  const Scalar t60 = qd_1 * qd_2;
  const Scalar t61 = s_2 * t60;
  const Scalar N_3_x = Scalar(0.037751348953737156) * s_1 + Scalar(0.00023148988883634047) * t57 -
      Scalar(0.001231440536717216) * t61 - Scalar(0.0010822284426343334) * t59;
  const Scalar t62 = Scalar(0.00023148988883634047) * t10 + Scalar(3.01e-06) * t7 * t58;
  const Scalar t63 = c_2 * t60;
  const Scalar t64 = Scalar(0.1737624403145115) * s_1 + Scalar(6.823068516838894e-08) * t6 -
      Scalar(0.0007940924716883453) * (t1 - U_2_yy) - Scalar(0.004560056342646188) * t61 -
      Scalar(0.001231440536717216) * t59 + c_3 * N_3_x + s_3 * t62 +
      Scalar(3.21970574695491e-07) * t63;
  const Scalar mu_2_y = Scalar(0.000020065123418265) * s_1 + Scalar(0.0007940924716883453) * t6 -
      Scalar(6.823068516838894e-08) * (t1 - U_2_xx) - Scalar(3.21970574695491e-07) * t61 +
      Scalar(0.000031100056329612534) * t63 + c_3 * t62 - s_3 * N_3_x;
  n[0] = Scalar(0.08509272390476785) * c_1 + c_2 * t64 + s_2 * mu_2_y;
  const Scalar t65 = t41 - t31 * t39 * t39;
  const Scalar t66 = qd_10 * omega_12_z;
  const Scalar t67 = t39 * t66;
  const Scalar t68 = qd_10 * qd_11;
  const Scalar t69 = s_11 * t68;
  const Scalar N_12_x = Scalar(0.037751348953737156) * s_10 - Scalar(0.00023148988883634047) * t65 -
      Scalar(0.001231440536717216) * t69 - Scalar(0.0010822284426343334) * t67;
  const Scalar t70 = Scalar(0.00023148988883634047) * t40 - Scalar(3.01e-06) * t37 * t66;
  const Scalar t71 = c_11 * t68;
  const Scalar t72 = Scalar(0.1737624403145115) * s_10 + Scalar(6.823068516838894e-08) * t36 +
      Scalar(0.0007940924716883453) * (t31 - U_11_yy) - Scalar(0.004560056342646188) * t69 -
      Scalar(0.001231440536717216) * t67 + c_12 * N_12_x - s_12 * t70 -
      Scalar(3.21970574695491e-07) * t71;
  const Scalar mu_11_y = Scalar(0.000020065123418265) * s_10 + Scalar(0.0007940924716883453) * t36 +
      Scalar(6.823068516838894e-08) * (t31 - U_11_xx) - Scalar(3.21970574695491e-07) * t69 -
      Scalar(0.000031100056329612534) * t71 + c_12 * t70 + s_12 * N_12_x;
  n[9] = c_11 * t72 - Scalar(0.08509272390476785) * c_10 - s_11 * mu_11_y;
  const Scalar t73 = t45 - t11 * t19 * t19;
  const Scalar t74 = qd_4 * omega_6_z;
  const Scalar t75 = t19 * t74;
  const Scalar t76 = qd_4 * qd_5;
  const Scalar t77 = s_5 * t76;
  const Scalar N_6_x = Scalar(0.037751348953737156) * s_4 - Scalar(0.00023148988883634047) * t73 -
      Scalar(0.001231440536717216) * t77 - Scalar(0.0010822284426343334) * t75;
  const Scalar t78 = Scalar(0.00023148988883634047) * t20 - Scalar(3.01e-06) * t17 * t74;
  const Scalar t79 = c_5 * t76;
  const Scalar t80 = Scalar(0.1737624403145115) * s_4 + Scalar(6.823068516838894e-08) * t16 +
      Scalar(0.0007940924716883453) * (t11 - U_5_yy) - Scalar(0.004560056342646188) * t77 -
      Scalar(0.001231440536717216) * t75 + c_6 * N_6_x - s_6 * t78 -
      Scalar(3.21970574695491e-07) * t79;
  const Scalar mu_5_y = Scalar(0.000020065123418265) * s_4 + Scalar(0.0007940924716883453) * t16 +
      Scalar(6.823068516838894e-08) * (t11 - U_5_xx) - Scalar(3.21970574695491e-07) * t77 -
      Scalar(0.000031100056329612534) * t79 + c_6 * t78 + s_6 * N_6_x;
  n[3] = c_5 * t80 - Scalar(0.08509272390476785) * c_4 - s_5 * mu_5_y;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[12]    in   joint positions, rad or m
//   qd[12]   in   joint velocities, rad/s or m/s
//   tau[12]  in   joint torques or forces, N m or N
//   qdd[12]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns true, or false if the result means nothing: a pivot was not positive, or an input not a
// number.
// Reads q[0..11], qd[0..11], tau[0..11]. Operations: 372 mul, 268 add, 8 div, 24 sin/cos.
template <class Scalar>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau,
    Scalar* qdd) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6],
      q_8 = q[7], q_9 = q[8], q_10 = q[9], q_11 = q[10], q_12 = q[11];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11];
  const Scalar tau_1 = tau[0], tau_2 = tau[1], tau_3 = tau[2], tau_4 = tau[3], tau_5 = tau[4],
      tau_6 = tau[5], tau_7 = tau[6], tau_8 = tau[7], tau_9 = tau[8], tau_10 = tau[9],
      tau_11 = tau[10], tau_12 = tau[11];
  const Scalar s_1 = sin(q_1), c_1 = cos(q_1);
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar s_8 = sin(q_8), c_8 = cos(q_8);
  const Scalar s_9 = sin(q_9), c_9 = cos(q_9);
  const Scalar s_10 = sin(q_10), c_10 = cos(q_10);
  const Scalar s_11 = sin(q_11), c_11 = cos(q_11);
  const Scalar s_12 = sin(q_12), c_12 = cos(q_12);
  const Scalar t1 = qd_4 * qd_4;
  const Scalar t2 = c_5 * t1;
  const Scalar t3 = c_5 * t2;
  const Scalar t4 = qd_5 * qd_5;
  const Scalar U_5_yy = t4 + t3;
  const Scalar t5 = Scalar(9.81) * c_4;
  const Scalar ddp_o_6_y = Scalar(0.16) * U_5_yy + c_5 * t5;
  const Scalar t6 = s_5 * t2;
  const Scalar ddp_o_6_x = Scalar(0.16) * t6 + s_5 * t5;
  const Scalar ddp_6_x = s_6 * ddp_o_6_y + c_6 * ddp_o_6_x;
  const Scalar t7 = Scalar(0.00023148988883634047) * c_6;
  const Scalar t8 = Scalar(0.00023148988883634047) * s_6;
  const Scalar mu_u_6_5_t_y = s_5 * t7 + c_5 * t8;
  const Scalar t9 = s_5 * s_6 - c_5 * c_6;
  const Scalar t10 = t1 * t9;
  const Scalar t11 = mu_u_6_5_t_y * t10;
  const Scalar N_6_z = Scalar(0.0038482516772413) * ddp_6_x - Scalar(2.3310271737123758) * t11;
  const Scalar y_6 = tau_6 - N_6_z;
  const Scalar mu_6_5_z = Scalar(0.000615720268358608) * c_6 + Scalar(0.0005426192213171668);
  const Scalar t12 = Scalar(1842.912968642313) * mu_6_5_z;
  const Scalar omega_6_z = qd_5 + qd_6;
  const Scalar t13 = omega_6_z * omega_6_z;
  const Scalar U_6_yy = t13 + t9 * t10;
  const Scalar U_5_xx = t4 + t1 - t3;
  const Scalar U_5_xx_yy = U_5_xx - U_5_yy;
  const Scalar y_6_5 = tau_5 - Scalar(0.0022644781431582876) * t6 +
      Scalar(1.609852873477455e-07) * U_5_xx_yy - N_6_z - y_6 * t12 +
      Scalar(0.000615720268358608) * s_6 * U_6_yy + Scalar(2.6598149554338075) * c_6 * t11 -
      Scalar(0.000020065123418265) * c_4 * c_5 - Scalar(0.1737624403145115) * c_4 * s_5;
  const Scalar t14 = Scalar(1842.912968642313) * mu_u_6_5_t_y;
  const Scalar Ic_5_yz = t7 + Scalar(0.0007940924716883453);
  const Scalar Ic_5_xz = t8 + Scalar(6.823068516838894e-08);
  const Scalar t15 = mu_6_5_z * t14 - s_5 * Ic_5_yz - c_5 * Ic_5_xz;
  const Scalar t16 = Scalar(0.001231440536717216) * c_6;
  const Scalar b_6_5_5 = t16 - mu_6_5_z * t12 + Scalar(0.002838197420805067);
  const Scalar d_5 = Scalar(1.0) / b_6_5_5;
  const Scalar t17 = t15 * d_5;
  const Scalar t18 = qd_4 * omega_6_z;
  const Scalar t19 = mu_u_6_5_t_y * t18;
  const Scalar t20 = qd_4 * qd_5;
  const Scalar t21 = s_5 * t20;
  const Scalar N_6_x = Scalar(0.037751348953737156) * s_4 - Scalar(0.00023148988883634047) * t13 -
      Scalar(4.675057075168632) * t19 - Scalar(0.001231440536717216) * t21 +
      Scalar(4319.843104279097) * t1 * mu_u_6_5_t_y * mu_u_6_5_t_y;
  const Scalar t22 = t11 - Scalar(3.01e-06) * t9 * t18;
  const Scalar t23 = c_5 * t20;
  const Scalar mu_5_y = Scalar(0.000020065123418265) * s_4 + Scalar(0.0007940924716883453) * t6 +
      Scalar(6.823068516838894e-08) * (t1 - U_5_xx) - Scalar(3.21970574695491e-07) * t21 -
      Scalar(0.000031100056329612534) * t23 + s_6 * N_6_x - c_6 * t22;
  const Scalar t24 = Scalar(0.1737624403145115) * s_4 + Scalar(6.823068516838894e-08) * t6 +
      Scalar(0.0007940924716883453) * (t1 - U_5_yy) - Scalar(5.319629910867615) * t19 -
      Scalar(0.004560056342646188) * t21 - Scalar(3.21970574695491e-07) * t23 + s_6 * t22 +
      c_6 * N_6_x;
  const Scalar y_5_4 = Scalar(0.08509272390476785) * c_4 + tau_4 - t17 * y_6_5 + y_6 * t14 +
      s_5 * mu_5_y - c_5 * t24;
  const Scalar t25 = Scalar(0.0005396092213171668) * c_6 * c_6;
  const Scalar Ic_5_xx = t25 + t16 + Scalar(0.0022644781431582876);
  const Scalar Iu_5_t_d = t25 + Ic_5_xx - Scalar(0.0005396092213171668);
  const Scalar Ic_5_xy = s_6 * (c_6 + Scalar(1.1410484551313946)) + Scalar(0.0002983367981643942);
  const Scalar Iu_5_t_g = s_5 * Iu_5_t_d + Scalar(0.0010792184426343335) * c_5 * Ic_5_xy;
  const Scalar b_5_4_4 = Ic_5_xx - t15 * t17 - mu_u_6_5_t_y * t14 - s_5 * Iu_5_t_g +
      Scalar(0.00037588290370216287);
  const Scalar d_4 = Scalar(1.0) / b_5_4_4;
  const Scalar qdd_4 = d_4 * y_5_4;
  qdd[3] = qdd_4;
  const Scalar t26 = qd_10 * qd_10;
  const Scalar t27 = c_11 * t26;
  const Scalar t28 = c_11 * t27;
  const Scalar t29 = qd_11 * qd_11;
  const Scalar U_11_yy = t29 + t28;
  const Scalar t30 = Scalar(9.81) * c_10;
  const Scalar ddp_o_12_y = Scalar(0.16) * U_11_yy + c_11 * t30;
  const Scalar t31 = s_11 * t27;
  const Scalar ddp_o_12_x = Scalar(0.16) * t31 + s_11 * t30;
  const Scalar ddp_12_x = s_12 * ddp_o_12_y + c_12 * ddp_o_12_x;
  const Scalar t32 = Scalar(0.00023148988883634047) * c_12;
  const Scalar t33 = Scalar(0.00023148988883634047) * s_12;
  const Scalar mu_u_12_11_t_y = s_11 * t32 + c_11 * t33;
  const Scalar t34 = s_11 * s_12 - c_11 * c_12;
  const Scalar t35 = t26 * t34;
  const Scalar t36 = mu_u_12_11_t_y * t35;
  const Scalar N_12_z = Scalar(0.0038482516772413) * ddp_12_x - Scalar(2.3310271737123758) * t36;
  const Scalar y_12 = tau_12 - N_12_z;
  const Scalar mu_12_11_z = Scalar(0.000615720268358608) * c_12 + Scalar(0.0005426192213171668);
  const Scalar t37 = Scalar(1842.912968642313) * mu_12_11_z;
  const Scalar omega_12_z = qd_11 + qd_12;
  const Scalar t38 = omega_12_z * omega_12_z;
  const Scalar U_12_yy = t38 + t34 * t35;
  const Scalar U_11_xx = t29 + t26 - t28;
  const Scalar U_11_xx_yy = U_11_xx - U_11_yy;
  const Scalar y_12_11 = tau_11 - Scalar(0.0022644781431582876) * t31 +
      Scalar(1.609852873477455e-07) * U_11_xx_yy - N_12_z - y_12 * t37 +
      Scalar(0.000615720268358608) * s_12 * U_12_yy + Scalar(2.6598149554338075) * c_12 * t36 -
      Scalar(0.000020065123418265) * c_10 * c_11 - Scalar(0.1737624403145115) * c_10 * s_11;
  const Scalar t39 = Scalar(1842.912968642313) * mu_u_12_11_t_y;
  const Scalar Ic_11_yz = t32 + Scalar(0.0007940924716883453);
  const Scalar Ic_11_xz = t33 + Scalar(6.823068516838894e-08);
  const Scalar t40 = mu_12_11_z * t39 - s_11 * Ic_11_yz - c_11 * Ic_11_xz;
  const Scalar t41 = Scalar(0.001231440536717216) * c_12;
  const Scalar b_12_11_11 = t41 - mu_12_11_z * t37 + Scalar(0.002838197420805067);
  const Scalar d_11 = Scalar(1.0) / b_12_11_11;
  const Scalar t42 = t40 * d_11;
  const Scalar t43 = qd_10 * omega_12_z;
  const Scalar t44 = mu_u_12_11_t_y * t43;
  const Scalar t45 = qd_10 * qd_11;
  const Scalar t46 = s_11 * t45;
  const Scalar N_12_x = Scalar(0.037751348953737156) * s_10 - Scalar(0.00023148988883634047) * t38 -
      Scalar(4.675057075168632) * t44 - Scalar(0.001231440536717216) * t46 +
      Scalar(4319.843104279097) * t26 * mu_u_12_11_t_y * mu_u_12_11_t_y;
  const Scalar t47 = t36 - Scalar(3.01e-06) * t34 * t43;
  const Scalar t48 = c_11 * t45;
  const Scalar mu_11_y = Scalar(0.000020065123418265) * s_10 + Scalar(0.0007940924716883453) * t31 +
      Scalar(6.823068516838894e-08) * (t26 - U_11_xx) - Scalar(3.21970574695491e-07) * t46 -
      Scalar(0.000031100056329612534) * t48 + s_12 * N_12_x - c_12 * t47;
  const Scalar t49 = Scalar(0.1737624403145115) * s_10 + Scalar(6.823068516838894e-08) * t31 +
      Scalar(0.0007940924716883453) * (t26 - U_11_yy) - Scalar(5.319629910867615) * t44 -
      Scalar(0.004560056342646188) * t46 - Scalar(3.21970574695491e-07) * t48 + s_12 * t47 +
      c_12 * N_12_x;
  const Scalar y_11_10 = Scalar(0.08509272390476785) * c_10 + tau_10 - t42 * y_12_11 + y_12 * t39 +
      s_11 * mu_11_y - c_11 * t49;
  const Scalar t50 = Scalar(0.0005396092213171668) * c_12 * c_12;
  const Scalar Ic_11_xx = t50 + t41 + Scalar(0.0022644781431582876);
  const Scalar Iu_11_t_d = t50 + Ic_11_xx - Scalar(0.0005396092213171668);
  const Scalar Ic_11_xy = s_12 * (c_12 + Scalar(1.1410484551313946)) +
      Scalar(0.0002983367981643942);
  const Scalar Iu_11_t_g = s_11 * Iu_11_t_d + Scalar(0.0010792184426343335) * c_11 * Ic_11_xy;
  const Scalar b_11_10_10 = Ic_11_xx - t40 * t42 - mu_u_12_11_t_y * t39 - s_11 * Iu_11_t_g +
      Scalar(0.00037588290370216287);
  const Scalar d_10 = Scalar(1.0) / b_11_10_10;
  const Scalar qdd_10 = d_10 * y_11_10;
  qdd[9] = qdd_10;
  const Scalar t51 = qd_1 * qd_1;
  const Scalar t52 = c_2 * t51;
  const Scalar t53 = c_2 * t52;
  const Scalar t54 = qd_2 * qd_2;
  const Scalar U_2_yy = t54 + t53;
  const Scalar t55 = Scalar(9.81) * c_1;
  const Scalar ddp_o_3_y = Scalar(0.16) * U_2_yy + c_2 * t55;
  const Scalar t56 = s_2 * t52;
  const Scalar ddp_o_3_x = Scalar(0.16) * t56 + s_2 * t55;
  const Scalar ddp_3_x = s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar t57 = Scalar(0.00023148988883634047) * c_3;
  const Scalar t58 = Scalar(0.00023148988883634047) * s_3;
  const Scalar mu_u_3_2_t_y = s_2 * t57 + c_2 * t58;
  const Scalar t59 = s_2 * s_3 - c_2 * c_3;
  const Scalar t60 = t51 * t59;
  const Scalar t61 = mu_u_3_2_t_y * t60;
  const Scalar N_3_z = Scalar(0.0038482516772413) * ddp_3_x - Scalar(2.3310271737123758) * t61;
  const Scalar y_3 = tau_3 - N_3_z;
  const Scalar mu_3_2_z = Scalar(0.000615720268358608) * c_3 + Scalar(0.0005426192213171668);
  const Scalar t62 = Scalar(1842.912968642313) * mu_3_2_z;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t63 = omega_3_z * omega_3_z;
  const Scalar U_3_yy = t63 + t59 * t60;
  const Scalar U_2_xx = t54 + t51 - t53;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  const Scalar y_3_2 = tau_2 - Scalar(0.0022644781431582876) * t56 -
      Scalar(1.609852873477455e-07) * U_2_xx_yy - N_3_z - y_3 * t62 +
      Scalar(0.000615720268358608) * s_3 * U_3_yy + Scalar(2.6598149554338075) * c_3 * t61 +
      Scalar(0.000020065123418265) * c_1 * c_2 - Scalar(0.1737624403145115) * c_1 * s_2;
  const Scalar t64 = Scalar(1842.912968642313) * mu_u_3_2_t_y;
  const Scalar Ic_2_yz = t57 + Scalar(0.0007940924716883453);
  const Scalar Ic_2_xz = t58 - Scalar(6.823068516838894e-08);
  const Scalar t65 = mu_3_2_z * t64 - s_2 * Ic_2_yz - c_2 * Ic_2_xz;
  const Scalar t66 = Scalar(0.001231440536717216) * c_3;
  const Scalar b_3_2_2 = t66 - mu_3_2_z * t62 + Scalar(0.002838197420805067);
  const Scalar d_2 = Scalar(1.0) / b_3_2_2;
  const Scalar t67 = t65 * d_2;
  const Scalar t68 = qd_1 * omega_3_z;
  const Scalar t69 = mu_u_3_2_t_y * t68;
  const Scalar t70 = qd_1 * qd_2;
  const Scalar t71 = s_2 * t70;
  const Scalar N_3_x = Scalar(0.037751348953737156) * s_1 + Scalar(0.00023148988883634047) * t63 -
      Scalar(4.675057075168632) * t69 - Scalar(0.001231440536717216) * t71 -
      Scalar(4319.843104279097) * t51 * mu_u_3_2_t_y * mu_u_3_2_t_y;
  const Scalar t72 = t61 + Scalar(3.01e-06) * t59 * t68;
  const Scalar t73 = c_2 * t70;
  const Scalar mu_2_y = Scalar(0.000020065123418265) * s_1 + Scalar(0.0007940924716883453) * t56 -
      Scalar(6.823068516838894e-08) * (t51 - U_2_xx) - Scalar(3.21970574695491e-07) * t71 +
      Scalar(0.000031100056329612534) * t73 - s_3 * N_3_x - c_3 * t72;
  const Scalar t74 = Scalar(0.1737624403145115) * s_1 + Scalar(6.823068516838894e-08) * t56 -
      Scalar(0.0007940924716883453) * (t51 - U_2_yy) - Scalar(5.319629910867615) * t69 -
      Scalar(0.004560056342646188) * t71 + Scalar(3.21970574695491e-07) * t73 - s_3 * t72 +
      c_3 * N_3_x;
  const Scalar t75 = Scalar(0.08509272390476785) * c_1 - tau_1 - t67 * y_3_2 + y_3 * t64 +
      s_2 * mu_2_y + c_2 * t74;
  const Scalar t76 = Scalar(0.0005396092213171668) * c_3 * c_3;
  const Scalar Ic_2_xx = t76 + t66 + Scalar(0.0022644781431582876);
  const Scalar Iu_2_t_d = t76 + Ic_2_xx - Scalar(0.0005396092213171668);
  const Scalar Ic_2_xy = s_3 * (c_3 + Scalar(1.1410484551313946)) - Scalar(0.0002983367981643942);
  const Scalar Iu_2_t_g = s_2 * Iu_2_t_d + Scalar(0.0010792184426343335) * c_2 * Ic_2_xy;
  const Scalar b_2_1_1 = Ic_2_xx - t65 * t67 - mu_u_3_2_t_y * t64 - s_2 * Iu_2_t_g +
      Scalar(0.00037588290370216287);
  const Scalar d_1 = Scalar(1.0) / b_2_1_1;
  const Scalar t77 = d_1 * t75;
  qdd[0] = -t77;
  const Scalar t78 = qd_7 * qd_7;
  const Scalar t79 = c_8 * t78;
  const Scalar t80 = c_8 * t79;
  const Scalar t81 = qd_8 * qd_8;
  const Scalar U_8_yy = t81 + t80;
  const Scalar t82 = Scalar(9.81) * c_7;
  const Scalar ddp_o_9_y = Scalar(0.16) * U_8_yy + c_8 * t82;
  const Scalar t83 = s_8 * t79;
  const Scalar ddp_o_9_x = Scalar(0.16) * t83 + s_8 * t82;
  const Scalar ddp_9_x = s_9 * ddp_o_9_y + c_9 * ddp_o_9_x;
  const Scalar t84 = Scalar(0.00023148988883634047) * c_9;
  const Scalar t85 = Scalar(0.00023148988883634047) * s_9;
  const Scalar mu_u_9_8_t_y = s_8 * t84 + c_8 * t85;
  const Scalar t86 = s_8 * s_9 - c_8 * c_9;
  const Scalar t87 = t78 * t86;
  const Scalar t88 = mu_u_9_8_t_y * t87;
  const Scalar N_9_z = Scalar(0.0038482516772413) * ddp_9_x - Scalar(2.3310271737123758) * t88;
  const Scalar y_9 = tau_9 - N_9_z;
  const Scalar mu_9_8_z = Scalar(0.000615720268358608) * c_9 + Scalar(0.0005426192213171668);
  const Scalar t89 = Scalar(1842.912968642313) * mu_9_8_z;
  const Scalar omega_9_z = qd_8 + qd_9;
  const Scalar t90 = omega_9_z * omega_9_z;
  const Scalar U_9_yy = t90 + t86 * t87;
  const Scalar U_8_xx = t81 + t78 - t80;
  const Scalar U_8_xx_yy = U_8_xx - U_8_yy;
  const Scalar y_9_8 = tau_8 - Scalar(0.0022644781431582876) * t83 -
      Scalar(1.609852873477455e-07) * U_8_xx_yy - N_9_z - y_9 * t89 +
      Scalar(0.000615720268358608) * s_9 * U_9_yy + Scalar(2.6598149554338075) * c_9 * t88 +
      Scalar(0.000020065123418265) * c_7 * c_8 - Scalar(0.1737624403145115) * c_7 * s_8;
  const Scalar t91 = Scalar(1842.912968642313) * mu_u_9_8_t_y;
  const Scalar Ic_8_yz = t84 + Scalar(0.0007940924716883453);
  const Scalar Ic_8_xz = t85 - Scalar(6.823068516838894e-08);
  const Scalar t92 = mu_9_8_z * t91 - s_8 * Ic_8_yz - c_8 * Ic_8_xz;
  const Scalar t93 = Scalar(0.001231440536717216) * c_9;
  const Scalar b_9_8_8 = t93 - mu_9_8_z * t89 + Scalar(0.002838197420805067);
  const Scalar d_8 = Scalar(1.0) / b_9_8_8;
  const Scalar t94 = t92 * d_8;
  const Scalar t95 = qd_7 * omega_9_z;
  const Scalar t96 = mu_u_9_8_t_y * t95;
  const Scalar t97 = qd_7 * qd_8;
  const Scalar t98 = s_8 * t97;
  const Scalar N_9_x = Scalar(0.037751348953737156) * s_7 + Scalar(0.00023148988883634047) * t90 -
      Scalar(4.675057075168632) * t96 - Scalar(0.001231440536717216) * t98 -
      Scalar(4319.843104279097) * t78 * mu_u_9_8_t_y * mu_u_9_8_t_y;
  const Scalar t99 = t88 + Scalar(3.01e-06) * t86 * t95;
  const Scalar t100 = c_8 * t97;
  const Scalar mu_8_y = Scalar(0.000020065123418265) * s_7 + Scalar(0.0007940924716883453) * t83 -
      Scalar(6.823068516838894e-08) * (t78 - U_8_xx) - Scalar(3.21970574695491e-07) * t98 +
      Scalar(0.000031100056329612534) * t100 - s_9 * N_9_x - c_9 * t99;
  const Scalar t101 = Scalar(0.1737624403145115) * s_7 + Scalar(6.823068516838894e-08) * t83 -
      Scalar(0.0007940924716883453) * (t78 - U_8_yy) - Scalar(5.319629910867615) * t96 -
      Scalar(0.004560056342646188) * t98 + Scalar(3.21970574695491e-07) * t100 - s_9 * t99 +
      c_9 * N_9_x;
  const Scalar t102 = Scalar(0.08509272390476785) * c_7 - tau_7 - t94 * y_9_8 + y_9 * t91 +
      s_8 * mu_8_y + c_8 * t101;
  const Scalar t103 = Scalar(0.0005396092213171668) * c_9 * c_9;
  const Scalar Ic_8_xx = t103 + t93 + Scalar(0.0022644781431582876);
  const Scalar Iu_8_t_d = t103 + Ic_8_xx - Scalar(0.0005396092213171668);
  const Scalar Ic_8_xy = s_9 * (c_9 + Scalar(1.1410484551313946)) - Scalar(0.0002983367981643942);
  const Scalar Iu_8_t_g = s_8 * Iu_8_t_d + Scalar(0.0010792184426343335) * c_8 * Ic_8_xy;
  const Scalar b_8_7_7 = Ic_8_xx - t92 * t94 - mu_u_9_8_t_y * t91 - s_8 * Iu_8_t_g +
      Scalar(0.00037588290370216287);
  const Scalar d_7 = Scalar(1.0) / b_8_7_7;
  const Scalar t104 = d_7 * t102;
  qdd[6] = -t104;
  const Scalar qdd_2 = d_2 * (y_3_2 - t65 * t77);
  qdd[1] = qdd_2;
  const Scalar qdd_5 = d_5 * (y_6_5 - t15 * qdd_4);
  qdd[4] = qdd_5;
  const Scalar qdd_8 = d_8 * (y_9_8 - t92 * t104);
  qdd[7] = qdd_8;
  const Scalar qdd_11 = d_11 * (y_12_11 - t40 * qdd_10);
  qdd[10] = qdd_11;
  qdd[2] = Scalar(1842.912968642313) * (y_3 - mu_3_2_z * qdd_2) + t64 * t77;
  qdd[5] = Scalar(1842.912968642313) * (y_6 - mu_6_5_z * qdd_5) + t14 * qdd_4;
  qdd[8] = Scalar(1842.912968642313) * (y_9 - mu_9_8_z * qdd_8) + t91 * t104;
  qdd[11] = Scalar(1842.912968642313) * (y_12 - mu_12_11_z * qdd_11) + t39 * qdd_10;
  bool positive = b_2_1_1 > Scalar(0.0);
  positive &= b_3_2_2 > Scalar(0.0);
  positive &= b_5_4_4 > Scalar(0.0);
  positive &= b_6_5_5 > Scalar(0.0);
  positive &= b_8_7_7 > Scalar(0.0);
  positive &= b_9_8_8 > Scalar(0.0);
  positive &= b_11_10_10 > Scalar(0.0);
  positive &= b_12_11_11 > Scalar(0.0);
  return positive;
}

// kinetic energy of links and rotors (7.31).
//   q[12]   in  joint positions, rad or m
//   qd[12]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1..2], q[4..5], q[7..8], q[10..11], qd[0..11]. Operations: 113 mul, 71 add, 16 sin/cos.
template <class Scalar>
inline Scalar kinetic_energy(const Scalar* q, const Scalar* qd) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_5 = q[4], q_6 = q[5], q_8 = q[7], q_9 = q[8], q_11 = q[10],
      q_12 = q[11];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_8 = sin(q_8), c_8 = cos(q_8);
  const Scalar s_9 = sin(q_9), c_9 = cos(q_9);
  const Scalar s_11 = sin(q_11), c_11 = cos(q_11);
  const Scalar s_12 = sin(q_12), c_12 = cos(q_12);
  const Scalar t1 = c_11 * qd_10;
  const Scalar t2 = s_11 * qd_10;
  const Scalar omega_r_12_y = s_12 * t1 + c_12 * t2;
  const Scalar t3 = Scalar(0.00023148988883634047) * omega_r_12_y;
  const Scalar omega_12_z = qd_11 + qd_12;
  const Scalar t4 = omega_12_z * (Scalar(0.0005426192213171668) * omega_12_z +
      Scalar(0.001231440536717216) * c_12 * qd_11 - t3);
  const Scalar t5 = c_8 * qd_7;
  const Scalar t6 = s_8 * qd_7;
  const Scalar omega_r_9_y = s_9 * t5 + c_9 * t6;
  const Scalar t7 = Scalar(0.00023148988883634047) * omega_r_9_y;
  const Scalar omega_9_z = qd_8 + qd_9;
  const Scalar L_9_z = Scalar(0.0005426192213171668) * omega_9_z +
      Scalar(0.001231440536717216) * c_9 * qd_8 + t7;
  const Scalar t8 = c_5 * qd_4;
  const Scalar t9 = s_5 * qd_4;
  const Scalar omega_r_6_y = s_6 * t8 + c_6 * t9;
  const Scalar t10 = Scalar(0.00023148988883634047) * omega_r_6_y;
  const Scalar omega_6_z = qd_5 + qd_6;
  const Scalar t11 = omega_6_z * (Scalar(0.0005426192213171668) * omega_6_z +
      Scalar(0.001231440536717216) * c_6 * qd_5 - t10);
  const Scalar t12 = c_2 * qd_1;
  const Scalar t13 = s_2 * qd_1;
  const Scalar omega_r_3_y = s_3 * t12 + c_3 * t13;
  const Scalar t14 = Scalar(0.00023148988883634047) * omega_r_3_y;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar L_3_z = Scalar(0.0005426192213171668) * omega_3_z +
      Scalar(0.001231440536717216) * c_3 * qd_2 + t14;
  const Scalar t15 = s_12 * t2 - c_12 * t1;
  const Scalar L_12_x = Scalar(0.001231440536717216) * t1 - Scalar(0.0005396092213171668) * t15;
  const Scalar t16 = s_9 * t6 - c_9 * t5;
  const Scalar L_9_x = Scalar(0.001231440536717216) * t5 - Scalar(0.0005396092213171668) * t16;
  const Scalar t17 = s_6 * t9 - c_6 * t8;
  const Scalar L_6_x = Scalar(0.001231440536717216) * t8 - Scalar(0.0005396092213171668) * t17;
  const Scalar t18 = s_3 * t13 - c_3 * t12;
  const Scalar L_3_x = Scalar(0.001231440536717216) * t12 - Scalar(0.0005396092213171668) * t18;
  const Scalar L_11_y = Scalar(0.0007940924716883453) * qd_11 + Scalar(1.609852873477455e-07) * t1;
  const Scalar L_11_x = Scalar(6.823068516838894e-08) * qd_11 + Scalar(1.609852873477455e-07) * t2 -
      Scalar(0.0022644781431582876) * t1;
  const Scalar L_11_z = Scalar(0.0022955781994879005) * qd_11 - Scalar(0.0007940924716883453) * t2 -
      Scalar(6.823068516838894e-08) * t1;
  const Scalar L_8_y = Scalar(0.0007940924716883453) * qd_8 + Scalar(1.609852873477455e-07) * t5;
  const Scalar L_8_x = Scalar(6.823068516838894e-08) * qd_8 - Scalar(1.609852873477455e-07) * t6 -
      Scalar(0.0022644781431582876) * t5;
  const Scalar L_8_z = Scalar(0.0022955781994879005) * qd_8 + Scalar(0.0007940924716883453) * t6 -
      Scalar(6.823068516838894e-08) * t5;
  const Scalar L_5_y = Scalar(0.0007940924716883453) * qd_5 + Scalar(1.609852873477455e-07) * t8;
  const Scalar L_5_x = Scalar(6.823068516838894e-08) * qd_5 + Scalar(1.609852873477455e-07) * t9 -
      Scalar(0.0022644781431582876) * t8;
  const Scalar L_5_z = Scalar(0.0022955781994879005) * qd_5 - Scalar(0.0007940924716883453) * t9 -
      Scalar(6.823068516838894e-08) * t8;
  const Scalar L_2_y = Scalar(0.0007940924716883453) * qd_2 + Scalar(1.609852873477455e-07) * t12;
  const Scalar L_2_x = Scalar(6.823068516838894e-08) * qd_2 - Scalar(1.609852873477455e-07) * t13 -
      Scalar(0.0022644781431582876) * t12;
  const Scalar L_2_z = Scalar(0.0022955781994879005) * qd_2 + Scalar(0.0007940924716883453) * t13 -
      Scalar(6.823068516838894e-08) * t12;
  const Scalar T_2 = t4 - omega_12_z * t3 - t15 * L_12_x - t2 * L_11_y - t1 * L_11_x +
      qd_11 * L_11_z + Scalar(0.00037588290370216287) * qd_10 * qd_10 + omega_9_z * L_9_z +
      omega_9_z * t7 - t16 * L_9_x + t6 * L_8_y - t5 * L_8_x + qd_8 * L_8_z +
      Scalar(0.00037588290370216287) * qd_7 * qd_7 + t11 - omega_6_z * t10 - t17 * L_6_x -
      t9 * L_5_y - t8 * L_5_x + qd_5 * L_5_z + Scalar(0.00037588290370216287) * qd_4 * qd_4 +
      omega_3_z * L_3_z + omega_3_z * t14 - t18 * L_3_x + t13 * L_2_y - t12 * L_2_x + qd_2 * L_2_z +
      Scalar(0.00037588290370216287) * qd_1 * qd_1;
  return Scalar(0.5) * T_2;
}

// potential energy of links and rotors (7.36).
//   q[12]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[0..11]. Operations: 22 mul, 19 add, 24 sin/cos.
template <class Scalar>
inline Scalar potential_energy(const Scalar* q) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6],
      q_8 = q[7], q_9 = q[8], q_10 = q[9], q_11 = q[10], q_12 = q[11];
  const Scalar s_1 = sin(q_1), c_1 = cos(q_1);
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar s_8 = sin(q_8), c_8 = cos(q_8);
  const Scalar s_9 = sin(q_9), c_9 = cos(q_9);
  const Scalar s_10 = sin(q_10), c_10 = cos(q_10);
  const Scalar s_11 = sin(q_11), c_11 = cos(q_11);
  const Scalar s_12 = sin(q_12), c_12 = cos(q_12);
  const Scalar hc_11_y = Scalar(0.0038482516772413) * c_12 + Scalar(0.01771278698415);
  const Scalar hc_11_x = Scalar(0.0038482516772413) * s_12 + Scalar(2.0453744565e-06);
  const Scalar t1 = c_10 * (c_11 * hc_11_y - s_11 * hc_11_x);
  const Scalar hc_8_y = Scalar(0.0038482516772413) * c_9 + Scalar(0.01771278698415);
  const Scalar hc_8_x = Scalar(0.0038482516772413) * s_9 - Scalar(2.0453744565e-06);
  const Scalar t2 = c_7 * (c_8 * hc_8_y - s_8 * hc_8_x);
  const Scalar hc_5_y = Scalar(0.0038482516772413) * c_6 + Scalar(0.01771278698415);
  const Scalar hc_5_x = Scalar(0.0038482516772413) * s_6 + Scalar(2.0453744565e-06);
  const Scalar t3 = c_4 * (c_5 * hc_5_y - s_5 * hc_5_x);
  const Scalar hc_2_y = Scalar(0.0038482516772413) * c_3 + Scalar(0.01771278698415);
  const Scalar hc_2_x = Scalar(0.0038482516772413) * s_3 - Scalar(2.0453744565e-06);
  const Scalar t4 = c_1 * (c_2 * hc_2_y - s_2 * hc_2_x);
  const Scalar t5 = (s_7 - s_10) + (s_1 - s_4);
  return Scalar(9.81) * (Scalar(0.0086740799087429) * t5 - t1 - t2 - t3 - t4);
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    1, 0, 1,
    1, 1, 1,
    1, 1, 1};

// pose of the tip (2.50).
//   q[12]  in   joint positions, rad or m
//   R[9]   out  rotation matrix of the frame in the base frame
//               3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]   out  position of the frame's origin in the base frame, m
// Reads q[9..11]. Operations: 17 mul, 9 add, 6 sin/cos. Always zero: 1 of the 9 entries of R.
template <class Scalar>
inline void forward_kinematics(const Scalar* q, Scalar* R, Scalar* p) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_10 = q[9], q_11 = q[10], q_12 = q[11];
  const Scalar s_10 = sin(q_10), c_10 = cos(q_10);
  const Scalar s_11 = sin(q_11), c_11 = cos(q_11);
  const Scalar s_12 = sin(q_12), c_12 = cos(q_12);
  R[4] = c_10;
  R[7] = s_10;
  const Scalar t1 = c_11 * s_12;
  const Scalar n_11_t_x = t1 + s_11 * c_12;
  R[2] = n_11_t_x;
  const Scalar t2 = s_11 * s_12;
  const Scalar n_11_t_y = c_11 * c_12 - t2;
  R[0] = n_11_t_y;
  R[3] = s_10 * n_11_t_x;
  R[8] = c_10 * n_11_t_y;
  R[6] = -c_10 * n_11_t_x;
  R[5] = -s_10 * n_11_t_y;
  const Scalar p_12_y = Scalar(0.16) * c_12 + Scalar(0.16);
  const Scalar p_11u_t_y = Scalar(0.16) * t1 + s_11 * p_12_y;
  const Scalar p_10_x = p_11u_t_y + Scalar(0.1946);
  p[0] = -p_10_x;
  const Scalar p_11u_t_x = Scalar(0.16) * t2 - c_11 * p_12_y;
  const Scalar p_10u_t_y = Scalar(0.05945) * s_10 - c_10 * p_11u_t_x;
  p[2] = -p_10u_t_y;
  const Scalar p_10u_t_x = Scalar(0.05945) * c_10 + s_10 * p_11u_t_x;
  const Scalar p_10_y = p_10u_t_x + Scalar(0.0875);
  p[1] = -p_10_y;
  R[1] = Scalar(0.0);
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[72] = {
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1};

// geometric Jacobian of the tip (7.14), (7.15).
//   q[12]  in   joint positions, rad or m
//   J[72]  out  geometric Jacobian in base axes: linear rows, then angular
//               6 x 12, row by row: entry (i, j) is J[12 * i + j]
// Reads q[9..11]. Operations: 21 mul, 10 add, 6 sin/cos. Always zero: 59 of the 72 entries of J.
template <class Scalar>
inline void jacobian(const Scalar* q, Scalar* J) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_10 = q[9], q_11 = q[10], q_12 = q[11];
  const Scalar s_10 = sin(q_10), c_10 = cos(q_10);
  const Scalar s_11 = sin(q_11), c_11 = cos(q_11);
  const Scalar s_12 = sin(q_12), c_12 = cos(q_12);
  J[58] = J[59] = c_10;
  J[70] = J[71] = s_10;
  const Scalar p_12_y = Scalar(0.16) * c_12 + Scalar(0.16);
  const Scalar t1 = Scalar(0.16) * c_11;
  const Scalar r_10_x = s_11 * p_12_y + s_12 * t1;
  J[34] = c_10 * r_10_x;
  const Scalar t2 = Scalar(0.16) * s_11;
  const Scalar t3 = s_12 * t2 - c_11 * p_12_y;
  const Scalar p_10u_t_y = Scalar(0.05945) * s_10 - c_10 * t3;
  J[21] = p_10u_t_y;
  J[22] = -s_10 * r_10_x;
  const Scalar t4 = t2 - r_10_x;
  J[23] = s_10 * t4;
  const Scalar r_10_y = Scalar(0.05945) * c_10 + s_10 * t3;
  J[33] = -r_10_y;
  J[35] = -c_10 * t4;
  J[10] = s_10 * r_10_y - c_10 * p_10u_t_y;
  const Scalar r_12_y = r_10_y + s_10 * t1;
  const Scalar r_12_z = p_10u_t_y - c_10 * t1;
  J[11] = s_10 * r_12_y - c_10 * r_12_z;
  J[0] = J[1] = J[2] = J[3] = J[4] = J[5] = J[6] = J[7] = Scalar(0.0);
  J[8] = J[9] = J[12] = J[13] = J[14] = J[15] = J[16] = J[17] = Scalar(0.0);
  J[18] = J[19] = J[20] = J[24] = J[25] = J[26] = J[27] = J[28] = Scalar(0.0);
  J[29] = J[30] = J[31] = J[32] = J[36] = J[37] = J[38] = J[39] = Scalar(0.0);
  J[40] = J[41] = J[42] = J[43] = J[44] = J[46] = J[47] = J[48] = Scalar(0.0);
  J[49] = J[50] = J[51] = J[52] = J[53] = J[54] = J[55] = J[56] = Scalar(0.0);
  J[57] = J[60] = J[61] = J[62] = J[63] = J[64] = J[65] = J[66] = Scalar(0.0);
  J[67] = J[68] = J[69] = Scalar(0.0);
  J[45] = Scalar(1.0);
}

// (dJ/dt) qd of the tip.
//   q[12]   in   joint positions, rad or m
//   qd[12]  in   joint velocities, rad/s or m/s
//   a[6]    out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads q[9..11], qd[9..11]. Operations: 51 mul, 22 add, 6 sin/cos.
template <class Scalar>
inline void jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_10 = q[9], q_11 = q[10], q_12 = q[11];
  const Scalar qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11];
  const Scalar s_10 = sin(q_10), c_10 = cos(q_10);
  const Scalar s_11 = sin(q_11), c_11 = cos(q_11);
  const Scalar s_12 = sin(q_12), c_12 = cos(q_12);
  const Scalar t1 = c_11 * s_12 + s_11 * c_12;
  const Scalar omega_12_z = qd_11 + qd_12;
  const Scalar t2 = qd_10 * omega_12_z;
  const Scalar t3 = t1 * t2;
  const Scalar t4 = s_11 * s_12;
  const Scalar t5 = c_11 * c_12;
  const Scalar t6 = t4 - t5;
  const Scalar t7 = t6 * t2;
  const Scalar domega_e_12_t_y = s_12 * t3 - c_12 * t7;
  const Scalar domega_e_12_t_x = s_12 * t7 + c_12 * t3;
  a[3] = s_11 * domega_e_12_t_y - c_11 * domega_e_12_t_x;
  const Scalar domega_e_11_t_x = s_11 * domega_e_12_t_x + c_11 * domega_e_12_t_y;
  a[5] = c_10 * domega_e_11_t_x;
  a[4] = -s_10 * domega_e_11_t_x;
  const Scalar t8 = qd_10 * qd_10;
  const Scalar t9 = c_11 * t8;
  const Scalar U_11_yy = qd_11 * qd_11 + c_11 * t9;
  const Scalar t10 = s_12 * U_11_yy - t8 * (t6 * t1 - s_11 * t5);
  const Scalar t11 = Scalar(0.16) * s_12;
  const Scalar t12 = t8 * t6 * t6;
  const Scalar t13 = t12 + omega_12_z * omega_12_z - t9 * t4 + c_12 * U_11_yy;
  const Scalar t14 = Scalar(0.16) * c_12;
  const Scalar a_12_t_y = t10 * t11 + t13 * t14;
  const Scalar t15 = t13 * t11 - t10 * t14;
  a[0] = s_11 * a_12_t_y + c_11 * t15;
  const Scalar t16 = s_11 * t15 - c_11 * a_12_t_y;
  const Scalar U_12_zz = t12 + t8 * t1 * t1;
  const Scalar t17 = Scalar(0.05945) * U_12_zz - Scalar(0.32) * s_11 * qd_10 * qd_11 -
      Scalar(0.32) * t3;
  a[1] = s_10 * t16 + c_10 * t17;
  a[2] = s_10 * t17 - c_10 * t16;
}

}  // namespace quadruped12

#endif  // FLATDYN_QUADRUPED12_HPP

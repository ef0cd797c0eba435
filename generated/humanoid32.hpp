// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "humanoid32" as flat code: 32 joints.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Options: --functions inverse_dynamics,inertia_matrix,gravity,bias,forward_dynamics,forward_kinematics,jacobian
// Input: sha1:df2c45fab13a46e2fdc1e9ab67d9ef5514029b24
//
//   index  joint         moves link      type      unit  lower            upper           speed     effort
//   0      R_HIP_P       R_HIP_P_S       revolute  rad   -2.09439510239   0.785398163397  12.56636  100
//   1      R_HIP_R       R_HIP_R_S       revolute  rad   -0.785398163397  0.349065850399  8.90117   100
//   2      R_HIP_Y       R_HIP_Y_S       revolute  rad   -0.523598775598  0.785398163397  8.90117   100
//   3      R_KNEE        R_KNEE_S        revolute  rad   0                2.61799387799   14.66075  100
//   4      R_ANKLE_R     R_ANKLE_R_S     revolute  rad   -0.610865238198  0.785398163397  15.18435  100
//   5      R_ANKLE_P     R_ANKLE_P_S     revolute  rad   -1.4835298642    0.959931088597  14.18435  100
//   6      L_HIP_P       L_HIP_P_S       revolute  rad   -2.09439510239   0.785398163397  12.56636  100
//   7      L_HIP_R       L_HIP_R_S       revolute  rad   -0.349065850399  0.785398163397  8.90117   100
//   8      L_HIP_Y       L_HIP_Y_S       revolute  rad   -0.785398163397  0.523598775598  8.90117   100
//   9      L_KNEE        L_KNEE_S        revolute  rad   0                2.61799387799   14.66075  100
//   10     L_ANKLE_R     L_ANKLE_R_S     revolute  rad   -0.785398163397  0.610865238198  15.18435  100
//   11     L_ANKLE_P     L_ANKLE_P_S     revolute  rad   -1.4835298642    0.959931088597  14.18435  100
//   12     WAIST_Y       WAIST_Y_S       revolute  rad   -0.785398163397  0.785398163397  8.90117   100
//   13     WAIST_P       WAIST_P_S       revolute  rad   -0.523598775598  1.0471975512    8.90117   100
//   14     WAIST_R       WAIST_R_S       revolute  rad   -0.872664625997  0.872664625997  9.42477   100
//   15     NECK_Y        NECK_Y_S        revolute  rad   -1.2217304764    1.2217304764    5.23598   100
//   16     NECK_R        NECK_R_S        revolute  rad   -0.872664625997  0.872664625997  5.75958   100
//   17     NECK_P        NECK_P_S        revolute  rad   -0.872664625997  1.0471975512    5.75958   100
//   18     R_SHOULDER_P  R_SHOULDER_P_S  revolute  rad   -3.14159265359   1.0471975512    8.90117   100
//   19     R_SHOULDER_R  R_SHOULDER_R_S  revolute  rad   -1.74532925199   0.174532925199  8.90117   100
//   20     R_SHOULDER_Y  R_SHOULDER_Y_S  revolute  rad   -1.57079632679   1.57079632679   4.18879   100
//   21     R_ELBOW_P     R_ELBOW_P_S     revolute  rad   -2.53072741539   0               9.42477   100
//   22     R_ELBOW_Y     R_ELBOW_Y_S     revolute  rad   -1.91986217719   1.91986217719   3.66519   100
//   23     R_WRIST_R     R_WRIST_R_S     revolute  rad   -1.91986217719   1.91986217719   5.75958   100
//   24     R_WRIST_Y     R_WRIST_Y_S     revolute  rad   -2.61799387799   2.61799387799   3.66519   100
//   25     L_SHOULDER_P  L_SHOULDER_P_S  revolute  rad   -3.14159265359   1.0471975512    8.90117   100
//   26     L_SHOULDER_R  L_SHOULDER_R_S  revolute  rad   -0.174532925199  1.74532925199   8.90117   100
//   27     L_SHOULDER_Y  L_SHOULDER_Y_S  revolute  rad   -1.57079632679   1.57079632679   4.18879   100
//   28     L_ELBOW_P     L_ELBOW_P_S     revolute  rad   -2.53072741539   0               9.42477   100
//   29     L_ELBOW_Y     L_ELBOW_Y_S     revolute  rad   -1.91986217719   1.91986217719   3.66519   100
//   30     L_WRIST_R     L_WRIST_R_S     revolute  rad   -1.91986217719   1.91986217719   5.75958   100
//   31     L_WRIST_Y     L_WRIST_Y_S     revolute  rad   -2.61799387799   2.61799387799   3.66519   100
//
// Gravity is (0, 0, -9.81) m/s^2 in the base frame. The tip belongs to link "L_LLITTLE_S". Links
// without a joint of their own, part of those that carry them: R_UTHUMB_S, R_LTHUMB_S, R_UINDEX_S,
// R_LINDEX_S, R_ULITTLE_S, R_LLITTLE_S, L_UTHUMB_S, L_LTHUMB_S, L_UINDEX_S, L_LINDEX_S,
// L_ULITTLE_S, L_LLITTLE_S.
//
// Every function is a template over its scalar: float, double, or any type that has + - * / and
// sin, cos where argument-dependent lookup finds them. Arguments are plain arrays:
//
//   double q[32] = {}, qd[32] = {}, qdd[32] = {}, tau[32];
//   humanoid32::inverse_dynamics(q, qd, qdd, tau);
//
// Entries come in the order of the table. Units are SI; "rad or m" goes by the type of the joint.
// Every entry of an output is written, zeros too. All inputs are read before anything is written:
// an output may overlap an input, but outputs must not overlap each other. Nothing allocates,
// throws, or keeps state. In the code, names count from 1 as in the textbook: q_1 is q[0], s_1 its
// sine, c_1 its cosine, s_12 the sine of q_1 + q_2.

#ifndef FLATDYN_HUMANOID32_HPP
#define FLATDYN_HUMANOID32_HPP

#include <cmath>

namespace humanoid32 {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 32;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {
    "R_HIP_P", "R_HIP_R", "R_HIP_Y", "R_KNEE", "R_ANKLE_R", "R_ANKLE_P", "L_HIP_P", "L_HIP_R",
    "L_HIP_Y", "L_KNEE", "L_ANKLE_R", "L_ANKLE_P", "WAIST_Y", "WAIST_P", "WAIST_R", "NECK_Y",
    "NECK_R", "NECK_P", "R_SHOULDER_P", "R_SHOULDER_R", "R_SHOULDER_Y", "R_ELBOW_P", "R_ELBOW_Y",
    "R_WRIST_R", "R_WRIST_Y", "L_SHOULDER_P", "L_SHOULDER_R", "L_SHOULDER_Y", "L_ELBOW_P",
    "L_ELBOW_Y", "L_WRIST_R", "L_WRIST_Y"};

// Smallest position, rad or m.
inline constexpr Real position_lower[joint_count] = {
    Real(-2.09439510239), Real(-0.785398163397), Real(-0.523598775598), Real(0.0),
    Real(-0.610865238198), Real(-1.4835298642), Real(-2.09439510239), Real(-0.349065850399),
    Real(-0.785398163397), Real(0.0), Real(-0.785398163397), Real(-1.4835298642),
    Real(-0.785398163397), Real(-0.523598775598), Real(-0.872664625997), Real(-1.2217304764),
    Real(-0.872664625997), Real(-0.872664625997), Real(-3.14159265359), Real(-1.74532925199),
    Real(-1.57079632679), Real(-2.53072741539), Real(-1.91986217719), Real(-1.91986217719),
    Real(-2.61799387799), Real(-3.14159265359), Real(-0.174532925199), Real(-1.57079632679),
    Real(-2.53072741539), Real(-1.91986217719), Real(-1.91986217719), Real(-2.61799387799)};

// Largest position, rad or m.
inline constexpr Real position_upper[joint_count] = {
    Real(0.785398163397), Real(0.349065850399), Real(0.785398163397), Real(2.61799387799),
    Real(0.785398163397), Real(0.959931088597), Real(0.785398163397), Real(0.785398163397),
    Real(0.523598775598), Real(2.61799387799), Real(0.610865238198), Real(0.959931088597),
    Real(0.785398163397), Real(1.0471975512), Real(0.872664625997), Real(1.2217304764),
    Real(0.872664625997), Real(1.0471975512), Real(1.0471975512), Real(0.174532925199),
    Real(1.57079632679), Real(0.0), Real(1.91986217719), Real(1.91986217719), Real(2.61799387799),
    Real(1.0471975512), Real(1.74532925199), Real(1.57079632679), Real(0.0), Real(1.91986217719),
    Real(1.91986217719), Real(2.61799387799)};

// Largest speed, rad/s or m/s.
inline constexpr Real velocity_limit[joint_count] = {
    Real(12.56636), Real(8.90117), Real(8.90117), Real(14.66075), Real(15.18435), Real(14.18435),
    Real(12.56636), Real(8.90117), Real(8.90117), Real(14.66075), Real(15.18435), Real(14.18435),
    Real(8.90117), Real(8.90117), Real(9.42477), Real(5.23598), Real(5.75958), Real(5.75958),
    Real(8.90117), Real(8.90117), Real(4.18879), Real(9.42477), Real(3.66519), Real(5.75958),
    Real(3.66519), Real(8.90117), Real(8.90117), Real(4.18879), Real(9.42477), Real(3.66519),
    Real(5.75958), Real(3.66519)};

// Largest torque or force, N m or N.
inline constexpr Real effort_limit[joint_count] = {
    Real(100.0), Real(100.0), Real(100.0), Real(100.0), Real(100.0), Real(100.0), Real(100.0),
    Real(100.0), Real(100.0), Real(100.0), Real(100.0), Real(100.0), Real(100.0), Real(100.0),
    Real(100.0), Real(100.0), Real(100.0), Real(100.0), Real(100.0), Real(100.0), Real(100.0),
    Real(100.0), Real(100.0), Real(100.0), Real(100.0), Real(100.0), Real(100.0), Real(100.0),
    Real(100.0), Real(100.0), Real(100.0), Real(100.0)};

// tau = B(q) qdd + C(q, qd) qd + g(q) + friction (7.42).
//   q[32]    in   joint positions, rad or m
//   qd[32]   in   joint velocities, rad/s or m/s
//   qdd[32]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[32]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11], q[13..31], qd[0..31], qdd[0..31]. Operations: 1143 mul, 868 add, 62 sin/cos.
template <class Scalar>
inline void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    Scalar* tau) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6],
      q_8 = q[7], q_9 = q[8], q_10 = q[9], q_11 = q[10], q_12 = q[11], q_14 = q[13], q_15 = q[14],
      q_16 = q[15], q_17 = q[16], q_18 = q[17], q_19 = q[18], q_20 = q[19], q_21 = q[20],
      q_22 = q[21], q_23 = q[22], q_24 = q[23], q_25 = q[24], q_26 = q[25], q_27 = q[26],
      q_28 = q[27], q_29 = q[28], q_30 = q[29], q_31 = q[30], q_32 = q[31];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11],
      qd_13 = qd[12], qd_14 = qd[13], qd_15 = qd[14], qd_16 = qd[15], qd_17 = qd[16],
      qd_18 = qd[17], qd_19 = qd[18], qd_20 = qd[19], qd_21 = qd[20], qd_22 = qd[21],
      qd_23 = qd[22], qd_24 = qd[23], qd_25 = qd[24], qd_26 = qd[25], qd_27 = qd[26],
      qd_28 = qd[27], qd_29 = qd[28], qd_30 = qd[29], qd_31 = qd[30], qd_32 = qd[31];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5], qdd_7 = qdd[6], qdd_8 = qdd[7], qdd_9 = qdd[8], qdd_10 = qdd[9],
      qdd_11 = qdd[10], qdd_12 = qdd[11], qdd_13 = qdd[12], qdd_14 = qdd[13], qdd_15 = qdd[14],
      qdd_16 = qdd[15], qdd_17 = qdd[16], qdd_18 = qdd[17], qdd_19 = qdd[18], qdd_20 = qdd[19],
      qdd_21 = qdd[20], qdd_22 = qdd[21], qdd_23 = qdd[22], qdd_24 = qdd[23], qdd_25 = qdd[24],
      qdd_26 = qdd[25], qdd_27 = qdd[26], qdd_28 = qdd[27], qdd_29 = qdd[28], qdd_30 = qdd[29],
      qdd_31 = qdd[30], qdd_32 = qdd[31];
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
  const Scalar s_14 = sin(q_14), c_14 = cos(q_14);
  const Scalar s_15 = sin(q_15), c_15 = cos(q_15);
  const Scalar s_16 = sin(q_16), c_16 = cos(q_16);
  const Scalar s_17 = sin(q_17), c_17 = cos(q_17);
  const Scalar s_18 = sin(q_18), c_18 = cos(q_18);
  const Scalar s_19 = sin(q_19), c_19 = cos(q_19);
  const Scalar s_20 = sin(q_20), c_20 = cos(q_20);
  const Scalar s_21 = sin(q_21), c_21 = cos(q_21);
  const Scalar s_22 = sin(q_22), c_22 = cos(q_22);
  const Scalar s_23 = sin(q_23), c_23 = cos(q_23);
  const Scalar s_24 = sin(q_24), c_24 = cos(q_24);
  const Scalar s_25 = sin(q_25), c_25 = cos(q_25);
  const Scalar s_26 = sin(q_26), c_26 = cos(q_26);
  const Scalar s_27 = sin(q_27), c_27 = cos(q_27);
  const Scalar s_28 = sin(q_28), c_28 = cos(q_28);
  const Scalar s_29 = sin(q_29), c_29 = cos(q_29);
  const Scalar s_30 = sin(q_30), c_30 = cos(q_30);
  const Scalar s_31 = sin(q_31), c_31 = cos(q_31);
  const Scalar s_32 = sin(q_32), c_32 = cos(q_32);
  const Scalar t1 = c_14 * qd_13;
  const Scalar t2 = s_15 * qd_14 - c_15 * t1;
  const Scalar t3 = s_14 * qd_13;
  const Scalar t4 = qd_14 * t3;
  const Scalar t5 = t4 - c_14 * qdd_13;
  const Scalar t6 = qd_15 * t2 + s_15 * t5 - c_15 * qdd_14;
  const Scalar omega_15_z = qd_15 - t3;
  const Scalar t7 = t2 * omega_15_z;
  const Scalar t8 = t6 + t7;
  const Scalar omega_r_15_y = s_15 * t1 + c_15 * qd_14;
  const Scalar t9 = omega_r_15_y * omega_r_15_y;
  const Scalar t10 = t2 * t2;
  const Scalar U_15_zz = t9 + t10;
  const Scalar t11 = Scalar(9.81) * s_14;
  const Scalar ddp_o_16_z = Scalar(0.453) * t8 - Scalar(0.003) * U_15_zz + t11;
  const Scalar t12 = qd_15 * omega_r_15_y + s_15 * qdd_14 + c_15 * t5;
  const Scalar t13 = omega_r_15_y * omega_15_z;
  const Scalar t14 = t12 - t13;
  const Scalar t15 = t2 * omega_r_15_y;
  const Scalar t16 = qd_14 * t1;
  const Scalar domega_15_z = qdd_15 - t16 - s_14 * qdd_13;
  const Scalar U_15_yx = domega_15_z + t15;
  const Scalar t17 = c_14 * s_15;
  const Scalar t18 = Scalar(9.81) * t17;
  const Scalar t19 = Scalar(0.453) * U_15_yx - Scalar(0.003) * t14 - t18;
  const Scalar t20 = s_16 * ddp_o_16_z - c_16 * t19;
  const Scalar t21 = omega_15_z * omega_15_z;
  const Scalar U_15_xx = t21 + t9;
  const Scalar t22 = Scalar(9.81) * c_14 * c_15;
  const Scalar t23 = Scalar(0.453) * U_15_xx + Scalar(0.003) * (t6 - t7) - t22;
  const Scalar t24 = s_17 * t20 + c_17 * t23;
  const Scalar ddp_16_y = s_16 * t19 + c_16 * ddp_o_16_z;
  const Scalar t25 = s_18 * t24 - c_18 * ddp_16_y;
  const Scalar t26 = s_18 * ddp_16_y + c_18 * t24;
  const Scalar t27 = s_16 * omega_15_z - c_16 * omega_r_15_y;
  const Scalar omega_16_z = qd_16 - t2;
  const Scalar omega_r_17_x = s_17 * t27 + c_17 * omega_16_z;
  const Scalar omega_r_16_y = s_16 * omega_r_15_y + c_16 * omega_15_z;
  const Scalar omega_17_z = qd_17 + omega_r_16_y;
  const Scalar omega_r_18_y = s_18 * omega_17_z + c_18 * omega_r_17_x;
  const Scalar omega_r_17_y = s_17 * omega_16_z - c_17 * t27;
  const Scalar omega_18_z = qd_18 + omega_r_17_y;
  const Scalar t28 = omega_18_z * omega_18_z;
  const Scalar U_18_xx = t28 + omega_r_18_y * omega_r_18_y;
  const Scalar t29 = s_18 * omega_r_17_x - c_18 * omega_17_z;
  const Scalar U_18_yy = t28 + t29 * t29;
  const Scalar U_18_xx_yy = U_18_xx - U_18_yy;
  const Scalar t30 = t29 * omega_r_18_y;
  const Scalar t31 = qd_16 * omega_r_16_y + s_16 * domega_15_z + c_16 * t6;
  const Scalar domega_16_z = qdd_16 - t12;
  const Scalar domega_18_z = qdd_18 + qd_17 * omega_r_17_x + s_17 * domega_16_z - c_17 * t31;
  const Scalar tau_18 = Scalar(0.22) * t25 + Scalar(0.02) * t26 + Scalar(0.03408) * domega_18_z -
      Scalar(0.024) * t30 - Scalar(0.0022) * U_18_xx_yy;
  tau[17] = tau_18;
  const Scalar t32 = s_2 * qd_1;
  const Scalar t33 = qd_2 * t32;
  const Scalar t34 = t33 - c_2 * qdd_1;
  const Scalar U_2_zy = t33 + t34;
  const Scalar ddp_o_3_z = Scalar(9.81) * s_1 - Scalar(0.389) * U_2_zy;
  const Scalar t35 = c_2 * qd_1;
  const Scalar t36 = t32 * t35;
  const Scalar U_2_xy = qdd_2 + t36;
  const Scalar t37 = Scalar(9.81) * c_1;
  const Scalar ddp_o_3_x = Scalar(0.389) * U_2_xy + s_2 * t37;
  const Scalar ddp_3_y = s_3 * ddp_o_3_z + c_3 * ddp_o_3_x;
  const Scalar omega_r_3_x = s_3 * t35 + c_3 * qd_2;
  const Scalar t38 = s_3 * qd_2 - c_3 * t35;
  const Scalar t39 = omega_r_3_x * t38;
  const Scalar t40 = qd_2 * t35;
  const Scalar domega_3_z = qdd_3 - t40 - s_2 * qdd_1;
  const Scalar U_3_yx = domega_3_z - t39;
  const Scalar ddp_o_4_y = ddp_3_y - Scalar(0.02) * U_3_yx;
  const Scalar omega_3_z = qd_3 - t32;
  const Scalar t41 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar t42 = qd_3 * t38 + s_3 * t34 - c_3 * qdd_2;
  const Scalar t43 = qd_4 * t41 + s_4 * t42 - c_4 * domega_3_z;
  const Scalar omega_4_z = qd_4 - t38;
  const Scalar t44 = t41 * omega_4_z;
  const Scalar t45 = t43 + t44;
  const Scalar t46 = ddp_o_4_y - Scalar(0.04) * t45;
  const Scalar omega_r_4_x = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar t47 = qd_4 * omega_r_4_x + s_4 * domega_3_z + c_4 * t42;
  const Scalar t48 = omega_r_4_x * omega_4_z;
  const Scalar t49 = t47 + t48;
  const Scalar t50 = Scalar(0.357) * t49 - t46;
  const Scalar t51 = omega_3_z * omega_3_z;
  const Scalar U_3_xx = t51 + t38 * t38;
  const Scalar t52 = Scalar(0.02) * U_3_xx + s_3 * ddp_o_3_x - c_3 * ddp_o_3_z;
  const Scalar t53 = qd_3 * omega_r_3_x + s_3 * qdd_2 + c_3 * t34;
  const Scalar t54 = omega_r_3_x * omega_3_z;
  const Scalar U_2_yy = qd_2 * qd_2 + t35 * t35;
  const Scalar ddp_o_3_y = Scalar(0.389) * U_2_yy + c_2 * t37;
  const Scalar ddp_o_4_z = ddp_o_3_y - Scalar(0.02) * (t53 + t54);
  const Scalar ddp_4_x = s_4 * t52 + c_4 * ddp_o_4_z;
  const Scalar t55 = omega_4_z * omega_4_z;
  const Scalar U_4_xx = t55 + t41 * t41;
  const Scalar domega_4_z = qdd_4 - t53;
  const Scalar t56 = omega_r_4_x * t41;
  const Scalar U_4_xy = domega_4_z + t56;
  const Scalar ddp_o_5_x = ddp_4_x + Scalar(0.357) * U_4_xx - Scalar(0.04) * U_4_xy;
  const Scalar t57 = s_5 * t50 + c_5 * ddp_o_5_x;
  const Scalar t58 = s_4 * ddp_o_4_z - c_4 * t52;
  const Scalar U_4_yx = domega_4_z - t56;
  const Scalar U_4_yy = t55 + omega_r_4_x * omega_r_4_x;
  const Scalar t59 = t58 + Scalar(0.357) * U_4_yx + Scalar(0.04) * U_4_yy;
  const Scalar t60 = s_6 * t57 + c_6 * t59;
  const Scalar t61 = s_6 * t59 - c_6 * t57;
  const Scalar t62 = s_5 * omega_4_z - c_5 * omega_r_4_x;
  const Scalar omega_5_z = qd_5 - t41;
  const Scalar omega_r_6_y = s_6 * omega_5_z - c_6 * t62;
  const Scalar omega_r_5_y = s_5 * omega_r_4_x + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t63 = omega_6_z * omega_6_z;
  const Scalar U_6_xx = t63 + omega_r_6_y * omega_r_6_y;
  const Scalar omega_r_6_x = s_6 * t62 + c_6 * omega_5_z;
  const Scalar U_6_yy = t63 + omega_r_6_x * omega_r_6_x;
  const Scalar U_6_xx_yy = U_6_xx - U_6_yy;
  const Scalar t64 = omega_r_6_x * omega_r_6_y;
  const Scalar domega_6_z = qdd_6 - qd_5 * t62 - s_5 * t43 + c_5 * domega_4_z;
  const Scalar N_6_z = Scalar(0.105) * t60 + Scalar(0.045) * t61 +
      Scalar(0.01431666666667) * domega_6_z + Scalar(0.0012) * t64 + Scalar(0.00315) * U_6_xx_yy;
  tau[5] = N_6_z;
  const Scalar t65 = s_8 * qd_7;
  const Scalar t66 = qd_8 * t65;
  const Scalar t67 = t66 - c_8 * qdd_7;
  const Scalar U_8_zy = t66 + t67;
  const Scalar ddp_o_9_z = Scalar(9.81) * s_7 - Scalar(0.389) * U_8_zy;
  const Scalar t68 = c_8 * qd_7;
  const Scalar t69 = t65 * t68;
  const Scalar U_8_xy = qdd_8 + t69;
  const Scalar t70 = Scalar(9.81) * c_7;
  const Scalar ddp_o_9_x = Scalar(0.389) * U_8_xy + s_8 * t70;
  const Scalar ddp_9_y = s_9 * ddp_o_9_z + c_9 * ddp_o_9_x;
  const Scalar omega_r_9_x = s_9 * t68 + c_9 * qd_8;
  const Scalar t71 = s_9 * qd_8 - c_9 * t68;
  const Scalar t72 = omega_r_9_x * t71;
  const Scalar t73 = qd_8 * t68;
  const Scalar domega_9_z = qdd_9 - t73 - s_8 * qdd_7;
  const Scalar U_9_yx = domega_9_z - t72;
  const Scalar ddp_o_10_y = ddp_9_y - Scalar(0.02) * U_9_yx;
  const Scalar omega_9_z = qd_9 - t65;
  const Scalar t74 = s_10 * omega_9_z - c_10 * omega_r_9_x;
  const Scalar t75 = qd_9 * t71 + s_9 * t67 - c_9 * qdd_8;
  const Scalar t76 = qd_10 * t74 + s_10 * t75 - c_10 * domega_9_z;
  const Scalar omega_10_z = qd_10 - t71;
  const Scalar t77 = t74 * omega_10_z;
  const Scalar t78 = t76 + t77;
  const Scalar t79 = ddp_o_10_y - Scalar(0.04) * t78;
  const Scalar omega_r_10_x = s_10 * omega_r_9_x + c_10 * omega_9_z;
  const Scalar t80 = qd_10 * omega_r_10_x + s_10 * domega_9_z + c_10 * t75;
  const Scalar t81 = omega_r_10_x * omega_10_z;
  const Scalar t82 = t80 + t81;
  const Scalar t83 = Scalar(0.357) * t82 - t79;
  const Scalar t84 = omega_9_z * omega_9_z;
  const Scalar U_9_xx = t84 + t71 * t71;
  const Scalar t85 = Scalar(0.02) * U_9_xx + s_9 * ddp_o_9_x - c_9 * ddp_o_9_z;
  const Scalar t86 = qd_9 * omega_r_9_x + s_9 * qdd_8 + c_9 * t67;
  const Scalar t87 = omega_r_9_x * omega_9_z;
  const Scalar U_8_yy = qd_8 * qd_8 + t68 * t68;
  const Scalar ddp_o_9_y = Scalar(0.389) * U_8_yy + c_8 * t70;
  const Scalar ddp_o_10_z = ddp_o_9_y - Scalar(0.02) * (t86 + t87);
  const Scalar ddp_10_x = s_10 * t85 + c_10 * ddp_o_10_z;
  const Scalar t88 = omega_10_z * omega_10_z;
  const Scalar U_10_xx = t88 + t74 * t74;
  const Scalar domega_10_z = qdd_10 - t86;
  const Scalar t89 = omega_r_10_x * t74;
  const Scalar U_10_xy = domega_10_z + t89;
  const Scalar ddp_o_11_x = ddp_10_x + Scalar(0.357) * U_10_xx - Scalar(0.04) * U_10_xy;
  const Scalar t90 = s_11 * t83 + c_11 * ddp_o_11_x;
  const Scalar t91 = s_10 * ddp_o_10_z - c_10 * t85;
  const Scalar U_10_yx = domega_10_z - t89;
  const Scalar U_10_yy = t88 + omega_r_10_x * omega_r_10_x;
  const Scalar t92 = t91 + Scalar(0.357) * U_10_yx + Scalar(0.04) * U_10_yy;
  const Scalar t93 = s_12 * t90 + c_12 * t92;
  const Scalar t94 = s_12 * t92 - c_12 * t90;
  const Scalar t95 = s_11 * omega_10_z - c_11 * omega_r_10_x;
  const Scalar omega_11_z = qd_11 - t74;
  const Scalar omega_r_12_y = s_12 * omega_11_z - c_12 * t95;
  const Scalar omega_r_11_y = s_11 * omega_r_10_x + c_11 * omega_10_z;
  const Scalar omega_12_z = qd_12 + omega_r_11_y;
  const Scalar t96 = omega_12_z * omega_12_z;
  const Scalar U_12_xx = t96 + omega_r_12_y * omega_r_12_y;
  const Scalar omega_r_12_x = s_12 * t95 + c_12 * omega_11_z;
  const Scalar U_12_yy = t96 + omega_r_12_x * omega_r_12_x;
  const Scalar U_12_xx_yy = U_12_xx - U_12_yy;
  const Scalar t97 = omega_r_12_x * omega_r_12_y;
  const Scalar domega_12_z = qdd_12 - qd_11 * t95 - s_11 * t76 + c_11 * domega_10_z;
  const Scalar N_12_z = Scalar(0.105) * t93 + Scalar(0.045) * t94 +
      Scalar(0.01431666666667) * domega_12_z + Scalar(0.0012) * t97 + Scalar(0.00315) * U_12_xx_yy;
  tau[11] = N_12_z;
  const Scalar t98 = qd_17 * omega_r_17_y - s_17 * t31 - c_17 * domega_16_z;
  const Scalar domega_17_z = qdd_17 - qd_16 * t27 - s_16 * t6 + c_16 * domega_15_z;
  const Scalar t99 = qd_18 * omega_r_18_y - s_18 * t98 - c_18 * domega_17_z;
  const Scalar t100 = omega_r_18_y * omega_18_z;
  const Scalar t101 = t99 + t100;
  const Scalar t102 = s_17 * t23 - c_17 * t20;
  const Scalar t103 = t29 * omega_18_z;
  const Scalar t104 = Scalar(0.02) * t102 + Scalar(0.01008) * t103 - Scalar(0.0022) * t101;
  const Scalar t105 = t103 + qd_18 * t29 - s_18 * domega_17_z + c_18 * t98;
  const Scalar t106 = Scalar(0.22) * t102 - Scalar(0.024) * t99 + Scalar(0.0022) * t105 -
      Scalar(0.03408) * t100;
  const Scalar mu_17_z = Scalar(0.01038) * domega_17_z - s_18 * t104 + c_18 * t106 +
      Scalar(0.00988) * omega_r_17_x * omega_r_17_y;
  tau[16] = mu_17_z;
  const Scalar ddp_11_y = s_11 * ddp_o_11_x - c_11 * t83;
  const Scalar t107 = qd_11 * omega_r_11_y + s_11 * domega_10_z + c_11 * t76;
  const Scalar domega_11_z = qdd_11 - t80;
  const Scalar t108 = qd_12 * omega_r_12_y - s_12 * t107 - c_12 * domega_11_z;
  const Scalar t109 = omega_r_12_y * omega_12_z;
  const Scalar t110 = t108 + t109;
  const Scalar t111 = omega_r_12_x * omega_12_z;
  const Scalar N_12_y = Scalar(0.045) * ddp_11_y + Scalar(0.01311666666667) * t111 -
      Scalar(0.00315) * t110;
  const Scalar U_12_zx = t111 + qd_12 * omega_r_12_x + s_12 * domega_11_z - c_12 * t107;
  const Scalar N_12_x = Scalar(0.105) * ddp_11_y - Scalar(0.0012) * t108 +
      Scalar(0.00315) * U_12_zx - Scalar(0.01431666666667) * t109;
  const Scalar mu_11_z = Scalar(0.00820666666667) * domega_11_z + s_12 * N_12_y + c_12 * N_12_x -
      Scalar(0.00756666666667) * t95 * omega_r_11_y;
  tau[10] = mu_11_z;
  const Scalar ddp_5_y = s_5 * ddp_o_5_x - c_5 * t50;
  const Scalar t112 = qd_5 * omega_r_5_y + s_5 * domega_4_z + c_5 * t43;
  const Scalar domega_5_z = qdd_5 - t47;
  const Scalar t113 = qd_6 * omega_r_6_y - s_6 * t112 - c_6 * domega_5_z;
  const Scalar t114 = omega_r_6_y * omega_6_z;
  const Scalar t115 = t113 + t114;
  const Scalar t116 = omega_r_6_x * omega_6_z;
  const Scalar N_6_y = Scalar(0.045) * ddp_5_y + Scalar(0.01311666666667) * t116 -
      Scalar(0.00315) * t115;
  const Scalar U_6_zx = t116 + qd_6 * omega_r_6_x + s_6 * domega_5_z - c_6 * t112;
  const Scalar N_6_x = Scalar(0.105) * ddp_5_y - Scalar(0.0012) * t113 + Scalar(0.00315) * U_6_zx -
      Scalar(0.01431666666667) * t114;
  const Scalar mu_5_z = Scalar(0.00820666666667) * domega_5_z + s_6 * N_6_y + c_6 * N_6_x -
      Scalar(0.00756666666667) * t62 * omega_r_5_y;
  tau[4] = mu_5_z;
  const Scalar t117 = tau_18 + Scalar(0.0005) * omega_r_17_x * omega_17_z;
  const Scalar t118 = Scalar(0.00988) * t98 + s_18 * t106 + c_18 * t104 +
      Scalar(0.01038) * omega_r_17_y * omega_17_z;
  const Scalar mu_16_z = Scalar(0.001125) * domega_16_z + s_17 * t117 - c_17 * t118 -
      Scalar(0.0005) * t27 * omega_r_16_y;
  tau[15] = mu_16_z;
  const Scalar t119 = N_12_z - Scalar(0.00064) * t95 * omega_11_z;
  const Scalar U_12_xy = domega_12_z + t97;
  const Scalar F_12_x = Scalar(0.045) * U_12_xx + Scalar(0.105) * U_12_xy;
  const Scalar U_12_yx = domega_12_z - t97;
  const Scalar F_12_y = Scalar(0.045) * U_12_yx - Scalar(0.105) * U_12_yy;
  const Scalar t120 = s_12 * F_12_x - c_12 * F_12_y;
  const Scalar F_12_z = Scalar(0.045) * U_12_zx - Scalar(0.105) * t110;
  const Scalar t121 = s_11 * F_12_z + c_11 * t120;
  const Scalar t122 = Scalar(0.00756666666667) * t107 + s_12 * N_12_x - c_12 * N_12_y +
      Scalar(0.00820666666667) * omega_r_11_y * omega_11_z;
  const Scalar f_u_12_t_y = s_12 * F_12_y + c_12 * F_12_x;
  const Scalar U_10_xx_yy = U_10_xx - U_10_yy;
  const Scalar mu_10_z = Scalar(0.22) * ddp_10_x - Scalar(1.3725) * t91 -
      Scalar(0.4393875) * domega_10_z + Scalar(0.4092575) * t89 + Scalar(0.0549) * U_10_xx_yy -
      Scalar(0.357) * f_u_12_t_y + Scalar(0.04) * t121 - s_11 * t122 - c_11 * t119;
  tau[9] = -mu_10_z;
  const Scalar t123 = N_6_z - Scalar(0.00064) * t62 * omega_5_z;
  const Scalar U_6_xy = domega_6_z + t64;
  const Scalar F_6_x = Scalar(0.045) * U_6_xx + Scalar(0.105) * U_6_xy;
  const Scalar U_6_yx = domega_6_z - t64;
  const Scalar F_6_y = Scalar(0.045) * U_6_yx - Scalar(0.105) * U_6_yy;
  const Scalar t124 = s_6 * F_6_x - c_6 * F_6_y;
  const Scalar F_6_z = Scalar(0.045) * U_6_zx - Scalar(0.105) * t115;
  const Scalar t125 = s_5 * F_6_z + c_5 * t124;
  const Scalar t126 = Scalar(0.00756666666667) * t112 + s_6 * N_6_x - c_6 * N_6_y +
      Scalar(0.00820666666667) * omega_r_5_y * omega_5_z;
  const Scalar f_u_6_t_y = s_6 * F_6_y + c_6 * F_6_x;
  const Scalar U_4_xx_yy = U_4_xx - U_4_yy;
  const Scalar mu_4_z = Scalar(0.22) * ddp_4_x - Scalar(1.3725) * t58 -
      Scalar(0.4393875) * domega_4_z + Scalar(0.4092575) * t56 + Scalar(0.0549) * U_4_xx_yy -
      Scalar(0.357) * f_u_6_t_y + Scalar(0.04) * t125 - s_5 * t126 - c_5 * t123;
  tau[3] = -mu_4_z;
  const Scalar t127 = s_11 * t120 - c_11 * F_12_z;
  const Scalar t128 = Scalar(1.3725) * t82 + t127;
  const Scalar mu_10_x = Scalar(0.22) * ddp_o_10_y + Scalar(0.4092575) * t76 -
      Scalar(0.4393875) * t77 - Scalar(0.04) * t128 + s_11 * t119 - c_11 * t122;
  const Scalar t129 = Scalar(0.22) * t78 + t128;
  const Scalar t130 = Scalar(0.848645) * t81 - Scalar(1.3725) * t79 - mu_11_z +
      Scalar(0.357) * t127;
  const Scalar t131 = t71 * omega_9_z;
  const Scalar mu_9_z = Scalar(0.08) * ddp_9_y - Scalar(0.4384975) * domega_9_z -
      Scalar(0.4222475) * t72 - Scalar(0.00507) * (t75 - t131) - Scalar(0.02) * t129 - s_10 * t130 -
      c_10 * mu_10_x;
  tau[8] = -mu_9_z;
  const Scalar t132 = s_5 * t124 - c_5 * F_6_z;
  const Scalar t133 = Scalar(1.3725) * t49 + t132;
  const Scalar mu_4_x = Scalar(0.22) * ddp_o_4_y + Scalar(0.4092575) * t43 -
      Scalar(0.4393875) * t44 - Scalar(0.04) * t133 + s_5 * t123 - c_5 * t126;
  const Scalar t134 = Scalar(0.22) * t45 + t133;
  const Scalar t135 = Scalar(0.848645) * t48 - Scalar(1.3725) * t46 - mu_5_z + Scalar(0.357) * t132;
  const Scalar t136 = t38 * omega_3_z;
  const Scalar mu_3_z = Scalar(0.08) * ddp_3_y - Scalar(0.4384975) * domega_3_z -
      Scalar(0.4222475) * t39 - Scalar(0.00507) * (t42 - t136) - Scalar(0.02) * t134 - s_4 * t135 -
      c_4 * mu_4_x;
  tau[2] = -mu_3_z;
  const Scalar f_10_x = Scalar(1.3725) * U_10_xx - Scalar(0.22) * U_10_xy + t121;
  const Scalar f_10_y = Scalar(1.3725) * U_10_yx + Scalar(0.22) * U_10_yy + f_u_12_t_y;
  const Scalar f_9_x = Scalar(0.08) * U_9_xx + s_10 * f_10_x - c_10 * f_10_y;
  const Scalar f_9_y = Scalar(0.08) * U_9_yx + t129;
  const Scalar t137 = s_9 * f_9_x - c_9 * f_9_y;
  const Scalar f_u_10_t_y = s_10 * f_10_y + c_10 * f_10_x;
  const Scalar mu_9_y = Scalar(0.08) * ddp_o_9_y - Scalar(0.01625) * t87 -
      Scalar(0.00507) * (t84 - omega_r_9_x * omega_r_9_x) - mu_10_z + Scalar(0.02) * f_u_10_t_y;
  const Scalar t138 = Scalar(0.4222475) * t75 + Scalar(0.00507) * U_9_yx +
      Scalar(0.4384975) * t131 - s_10 * mu_10_x + c_10 * t130;
  tau[7] = Scalar(1.0164505) * qdd_8 + Scalar(1.0144905) * t69 + Scalar(0.389) * t137 -
      s_9 * mu_9_y - c_9 * t138 + Scalar(27.463095) * c_7 * s_8;
  const Scalar f_4_x = Scalar(1.3725) * U_4_xx - Scalar(0.22) * U_4_xy + t125;
  const Scalar f_4_y = Scalar(1.3725) * U_4_yx + Scalar(0.22) * U_4_yy + f_u_6_t_y;
  const Scalar f_3_x = Scalar(0.08) * U_3_xx + s_4 * f_4_x - c_4 * f_4_y;
  const Scalar f_3_y = Scalar(0.08) * U_3_yx + t134;
  const Scalar t139 = s_3 * f_3_x - c_3 * f_3_y;
  const Scalar f_u_4_t_y = s_4 * f_4_y + c_4 * f_4_x;
  const Scalar mu_3_y = Scalar(0.08) * ddp_o_3_y - Scalar(0.01625) * t54 -
      Scalar(0.00507) * (t51 - omega_r_3_x * omega_r_3_x) - mu_4_z + Scalar(0.02) * f_u_4_t_y;
  const Scalar t140 = Scalar(0.4222475) * t42 + Scalar(0.00507) * U_3_yx +
      Scalar(0.4384975) * t136 - s_4 * mu_4_x + c_4 * t135;
  tau[1] = Scalar(1.0164505) * qdd_2 + Scalar(1.0144905) * t36 + Scalar(0.389) * t139 -
      s_3 * mu_3_y - c_3 * t140 + Scalar(27.463095) * c_1 * s_2;
  const Scalar f_u_9_t_y = s_9 * f_9_y + c_9 * f_9_x;
  const Scalar mu_8_x = Scalar(27.463095) * s_7 - Scalar(1.0164505) * t66 -
      Scalar(1.0144905) * t67 - Scalar(0.389) * f_u_9_t_y - s_9 * t138 + c_9 * mu_9_y;
  const Scalar mu_8_y = Scalar(0.00196) * t73 + mu_9_z;
  tau[6] = Scalar(0.00392) * qdd_7 + s_8 * mu_8_y + c_8 * mu_8_x;
  const Scalar f_u_3_t_y = s_3 * f_3_y + c_3 * f_3_x;
  const Scalar mu_2_x = Scalar(27.463095) * s_1 - Scalar(1.0164505) * t33 -
      Scalar(1.0144905) * t34 - Scalar(0.389) * f_u_3_t_y - s_3 * t140 + c_3 * mu_3_y;
  const Scalar mu_2_y = Scalar(0.00196) * t40 + mu_3_z;
  tau[0] = Scalar(0.00392) * qdd_1 + s_2 * mu_2_y + c_2 * mu_2_x;
  const Scalar t141 = Scalar(0.33) * t8 + t11;
  const Scalar t142 = Scalar(-0.24) * (t12 + t13);
  const Scalar t143 = t141 - t142;
  const Scalar t144 = Scalar(0.33) * U_15_xx - t22;
  const Scalar U_15_xy = domega_15_z - t15;
  const Scalar t145 = Scalar(0.24) * U_15_xy;
  const Scalar t146 = t144 + t145;
  const Scalar t147 = s_19 * t143 + c_19 * t146;
  const Scalar t148 = Scalar(0.33) * U_15_yx - t18;
  const Scalar U_15_yy = t21 + t10;
  const Scalar t149 = Scalar(0.24) * U_15_yy;
  const Scalar t150 = t148 - t149;
  const Scalar t151 = s_20 * t147 + c_20 * t150;
  const Scalar omega_r_19_x = s_19 * omega_15_z - c_19 * t2;
  const Scalar omega_19_z = qd_19 + omega_r_15_y;
  const Scalar omega_r_20_x = s_20 * omega_r_19_x + c_20 * omega_19_z;
  const Scalar t152 = s_20 * omega_19_z - c_20 * omega_r_19_x;
  const Scalar t153 = omega_r_20_x * t152;
  const Scalar domega_20_z = qdd_20 - qd_19 * omega_r_19_x + s_19 * t12 + c_19 * domega_15_z;
  const Scalar U_20_xy = domega_20_z + t153;
  const Scalar t154 = t151 - Scalar(0.305) * U_20_xy;
  const Scalar t155 = s_19 * t146 - c_19 * t143;
  const Scalar omega_r_19_y = s_19 * t2 + c_19 * omega_15_z;
  const Scalar domega_19_x = qd_19 * omega_r_19_y + s_19 * domega_15_z - c_19 * t12;
  const Scalar domega_19_z = qdd_19 - t6;
  const Scalar t156 = qd_20 * t152 - s_20 * domega_19_x - c_20 * domega_19_z;
  const Scalar omega_20_z = qd_20 + omega_r_19_y;
  const Scalar t157 = t152 * omega_20_z;
  const Scalar t158 = t156 + t157;
  const Scalar t159 = t155 + Scalar(0.305) * t158;
  const Scalar t160 = s_21 * omega_20_z - c_21 * omega_r_20_x;
  const Scalar omega_21_z = qd_21 - t152;
  const Scalar t161 = omega_21_z * omega_21_z;
  const Scalar U_21_xx = t161 + t160 * t160;
  const Scalar ddp_o_22_x = Scalar(0.004) * U_21_xx + s_21 * t154 - c_21 * t159;
  const Scalar U_20_yy = omega_20_z * omega_20_z + omega_r_20_x * omega_r_20_x;
  const Scalar ddp_o_21_y = Scalar(0.305) * U_20_yy + s_20 * t150 - c_20 * t147;
  const Scalar omega_r_21_x = s_21 * omega_r_20_x + c_21 * omega_20_z;
  const Scalar t162 = qd_21 * omega_r_21_x + s_21 * domega_20_z + c_21 * t156;
  const Scalar t163 = omega_r_21_x * omega_21_z;
  const Scalar t164 = t162 + t163;
  const Scalar ddp_o_22_z = ddp_o_21_y + Scalar(0.004) * t164;
  const Scalar ddp_22_x = s_22 * ddp_o_22_z + c_22 * ddp_o_22_x;
  const Scalar omega_r_22_y = s_22 * omega_r_21_x + c_22 * omega_21_z;
  const Scalar omega_22_z = qd_22 - t160;
  const Scalar t165 = omega_22_z * omega_22_z;
  const Scalar U_22_xx = t165 + omega_r_22_y * omega_r_22_y;
  const Scalar domega_22_z = qdd_22 - t162;
  const Scalar t166 = s_22 * omega_21_z - c_22 * omega_r_21_x;
  const Scalar t167 = t166 * omega_r_22_y;
  const Scalar U_22_xy = domega_22_z - t167;
  const Scalar ddp_o_23_x = ddp_22_x - Scalar(0.004) * U_22_xx + Scalar(0.239) * U_22_xy;
  const Scalar t168 = s_21 * t159 + c_21 * t154;
  const Scalar t169 = omega_r_21_x * t160;
  const Scalar domega_21_z = qdd_21 - qd_20 * omega_r_20_x - s_20 * domega_19_z +
      c_20 * domega_19_x;
  const Scalar U_21_yx = domega_21_z - t169;
  const Scalar t170 = t168 - Scalar(0.004) * U_21_yx;
  const Scalar t171 = qd_21 * t160 + s_21 * t156 - c_21 * domega_20_z;
  const Scalar t172 = qd_22 * t166 + s_22 * t171 - c_22 * domega_21_z;
  const Scalar t173 = t166 * omega_22_z;
  const Scalar t174 = t172 + t173;
  const Scalar t175 = qd_22 * omega_r_22_y + s_22 * domega_21_z + c_22 * t171;
  const Scalar t176 = omega_r_22_y * omega_22_z;
  const Scalar t177 = t175 + t176;
  const Scalar t178 = t170 - Scalar(0.004) * t174 + Scalar(0.239) * t177;
  const Scalar ddp_23_x = s_23 * ddp_o_23_x - c_23 * t178;
  const Scalar t179 = s_22 * ddp_o_22_x - c_22 * ddp_o_22_z;
  const Scalar U_22_yx = domega_22_z + t167;
  const Scalar U_22_yy = t165 + t166 * t166;
  const Scalar t180 = t179 - Scalar(0.004) * U_22_yx - Scalar(0.239) * U_22_yy;
  const Scalar t181 = s_24 * t180 - c_24 * ddp_23_x;
  const Scalar t182 = s_23 * t178 + c_23 * ddp_o_23_x;
  const Scalar ddp_25_x = s_25 * t181 + c_25 * t182;
  const Scalar omega_r_23_x = s_23 * t166 + c_23 * omega_22_z;
  const Scalar omega_23_z = qd_23 + omega_r_22_y;
  const Scalar omega_r_24_x = s_24 * omega_23_z + c_24 * omega_r_23_x;
  const Scalar omega_r_23_y = s_23 * omega_22_z - c_23 * t166;
  const Scalar omega_24_z = qd_24 + omega_r_23_y;
  const Scalar omega_r_25_x = s_25 * omega_r_24_x + c_25 * omega_24_z;
  const Scalar t183 = s_24 * omega_r_23_x - c_24 * omega_23_z;
  const Scalar omega_25_z = qd_25 - t183;
  const Scalar t184 = omega_r_25_x * omega_25_z;
  const Scalar t185 = qd_23 * omega_r_23_y - s_23 * t175 - c_23 * domega_22_z;
  const Scalar domega_23_z = qdd_23 - t172;
  const Scalar t186 = qd_24 * t183 - s_24 * domega_23_z + c_24 * t185;
  const Scalar domega_24_z = qdd_24 + qd_23 * omega_r_23_x + s_23 * domega_22_z - c_23 * t175;
  const Scalar U_25_xz = t184 - qd_25 * omega_r_25_x - s_25 * domega_24_z - c_25 * t186;
  const Scalar t187 = s_25 * omega_24_z - c_25 * omega_r_24_x;
  const Scalar t188 = omega_r_25_x * t187;
  const Scalar domega_25_z = qdd_25 - qd_24 * omega_r_24_x + s_24 * t185 + c_24 * domega_23_z;
  const Scalar N_25_z = Scalar(0.0094) * ddp_25_x + Scalar(0.0014129000000002) * domega_25_z -
      Scalar(0.0005096) * t188 + Scalar(0.0007482) * U_25_xz;
  tau[24] = N_25_z;
  const Scalar ddp_o_26_z = t141 + t142;
  const Scalar t189 = t144 - t145;
  const Scalar t190 = s_26 * ddp_o_26_z + c_26 * t189;
  const Scalar t191 = t148 + t149;
  const Scalar t192 = s_27 * t190 + c_27 * t191;
  const Scalar omega_r_26_x = s_26 * omega_15_z - c_26 * t2;
  const Scalar omega_26_z = qd_26 + omega_r_15_y;
  const Scalar omega_r_27_x = s_27 * omega_r_26_x + c_27 * omega_26_z;
  const Scalar t193 = s_27 * omega_26_z - c_27 * omega_r_26_x;
  const Scalar t194 = omega_r_27_x * t193;
  const Scalar domega_27_z = qdd_27 - qd_26 * omega_r_26_x + s_26 * t12 + c_26 * domega_15_z;
  const Scalar U_27_xy = domega_27_z + t194;
  const Scalar t195 = t192 - Scalar(0.305) * U_27_xy;
  const Scalar t196 = s_26 * t189 - c_26 * ddp_o_26_z;
  const Scalar omega_r_26_y = s_26 * t2 + c_26 * omega_15_z;
  const Scalar domega_26_x = qd_26 * omega_r_26_y + s_26 * domega_15_z - c_26 * t12;
  const Scalar domega_26_z = qdd_26 - t6;
  const Scalar t197 = qd_27 * t193 - s_27 * domega_26_x - c_27 * domega_26_z;
  const Scalar omega_27_z = qd_27 + omega_r_26_y;
  const Scalar t198 = t193 * omega_27_z;
  const Scalar t199 = t197 + t198;
  const Scalar t200 = t196 + Scalar(0.305) * t199;
  const Scalar t201 = s_28 * omega_27_z - c_28 * omega_r_27_x;
  const Scalar omega_28_z = qd_28 - t193;
  const Scalar t202 = omega_28_z * omega_28_z;
  const Scalar U_28_xx = t202 + t201 * t201;
  const Scalar ddp_o_29_x = Scalar(0.004) * U_28_xx + s_28 * t195 - c_28 * t200;
  const Scalar U_27_yy = omega_27_z * omega_27_z + omega_r_27_x * omega_r_27_x;
  const Scalar ddp_o_28_y = Scalar(0.305) * U_27_yy + s_27 * t191 - c_27 * t190;
  const Scalar omega_r_28_x = s_28 * omega_r_27_x + c_28 * omega_27_z;
  const Scalar t203 = qd_28 * omega_r_28_x + s_28 * domega_27_z + c_28 * t197;
  const Scalar t204 = omega_r_28_x * omega_28_z;
  const Scalar t205 = t203 + t204;
  const Scalar ddp_o_29_z = ddp_o_28_y + Scalar(0.004) * t205;
  const Scalar ddp_29_x = s_29 * ddp_o_29_z + c_29 * ddp_o_29_x;
  const Scalar omega_r_29_y = s_29 * omega_r_28_x + c_29 * omega_28_z;
  const Scalar omega_29_z = qd_29 - t201;
  const Scalar t206 = omega_29_z * omega_29_z;
  const Scalar U_29_xx = t206 + omega_r_29_y * omega_r_29_y;
  const Scalar domega_29_z = qdd_29 - t203;
  const Scalar t207 = s_29 * omega_28_z - c_29 * omega_r_28_x;
  const Scalar t208 = t207 * omega_r_29_y;
  const Scalar U_29_xy = domega_29_z - t208;
  const Scalar ddp_o_30_x = ddp_29_x - Scalar(0.004) * U_29_xx + Scalar(0.239) * U_29_xy;
  const Scalar t209 = s_28 * t200 + c_28 * t195;
  const Scalar t210 = omega_r_28_x * t201;
  const Scalar domega_28_z = qdd_28 - qd_27 * omega_r_27_x - s_27 * domega_26_z +
      c_27 * domega_26_x;
  const Scalar U_28_yx = domega_28_z - t210;
  const Scalar t211 = t209 - Scalar(0.004) * U_28_yx;
  const Scalar t212 = qd_28 * t201 + s_28 * t197 - c_28 * domega_27_z;
  const Scalar t213 = qd_29 * t207 + s_29 * t212 - c_29 * domega_28_z;
  const Scalar t214 = t207 * omega_29_z;
  const Scalar t215 = t213 + t214;
  const Scalar t216 = qd_29 * omega_r_29_y + s_29 * domega_28_z + c_29 * t212;
  const Scalar t217 = omega_r_29_y * omega_29_z;
  const Scalar t218 = t216 + t217;
  const Scalar t219 = t211 - Scalar(0.004) * t215 + Scalar(0.239) * t218;
  const Scalar t220 = s_30 * ddp_o_30_x - c_30 * t219;
  const Scalar t221 = s_29 * ddp_o_29_x - c_29 * ddp_o_29_z;
  const Scalar U_29_yx = domega_29_z + t208;
  const Scalar U_29_yy = t206 + t207 * t207;
  const Scalar t222 = t221 - Scalar(0.004) * U_29_yx - Scalar(0.239) * U_29_yy;
  const Scalar t223 = s_31 * t222 - c_31 * t220;
  const Scalar t224 = s_30 * t219 + c_30 * ddp_o_30_x;
  const Scalar ddp_32_x = s_32 * t223 + c_32 * t224;
  const Scalar omega_r_30_x = s_30 * t207 + c_30 * omega_29_z;
  const Scalar omega_30_z = qd_30 + omega_r_29_y;
  const Scalar omega_r_31_x = s_31 * omega_30_z + c_31 * omega_r_30_x;
  const Scalar omega_r_30_y = s_30 * omega_29_z - c_30 * t207;
  const Scalar omega_31_z = qd_31 + omega_r_30_y;
  const Scalar omega_r_32_x = s_32 * omega_r_31_x + c_32 * omega_31_z;
  const Scalar t225 = s_31 * omega_r_30_x - c_31 * omega_30_z;
  const Scalar omega_32_z = qd_32 - t225;
  const Scalar t226 = omega_r_32_x * omega_32_z;
  const Scalar t227 = qd_30 * omega_r_30_y - s_30 * t216 - c_30 * domega_29_z;
  const Scalar domega_30_z = qdd_30 - t213;
  const Scalar t228 = qd_31 * t225 - s_31 * domega_30_z + c_31 * t227;
  const Scalar domega_31_z = qdd_31 + qd_30 * omega_r_30_x + s_30 * domega_29_z - c_30 * t216;
  const Scalar U_32_xz = t226 - qd_32 * omega_r_32_x - s_32 * domega_31_z - c_32 * t228;
  const Scalar t229 = s_32 * omega_31_z - c_32 * omega_r_31_x;
  const Scalar t230 = omega_r_32_x * t229;
  const Scalar domega_32_z = qdd_32 - qd_31 * omega_r_31_x + s_31 * t227 + c_31 * domega_30_z;
  const Scalar N_32_z = Scalar(0.0094) * ddp_32_x - Scalar(0.0014129000000002) * domega_32_z +
      Scalar(0.0005096) * t230 + Scalar(0.0007482) * U_32_xz;
  tau[31] = -N_32_z;
  const Scalar t231 = s_31 * t220 + c_31 * t222;
  const Scalar t232 = qd_32 * t229 + s_32 * t228 - c_32 * domega_31_z;
  const Scalar t233 = omega_32_z * omega_32_z;
  const Scalar t234 = t229 * omega_32_z;
  const Scalar t235 = Scalar(0.0094) * t231 + Scalar(0.0005096) * t232 -
      Scalar(0.0014129000000002) * t234 + Scalar(0.0007482) * (t233 - t229 * t229);
  const Scalar U_32_xy = domega_32_z + t230;
  const Scalar N_32_y = Scalar(0.0007482) * U_32_xy + Scalar(0.0019225000000002) * t226;
  const Scalar t236 = omega_r_31_x * t225;
  const Scalar t237 = Scalar(0.1902) * t223 - Scalar(0.0258331000000002) * domega_31_z -
      Scalar(0.0255131000000002) * t236 - s_32 * N_32_y - c_32 * t235;
  tau[30] = -t237;
  const Scalar t238 = s_24 * ddp_23_x + c_24 * t180;
  const Scalar t239 = qd_25 * t187 + s_25 * t186 - c_25 * domega_24_z;
  const Scalar t240 = omega_25_z * omega_25_z;
  const Scalar t241 = t187 * omega_25_z;
  const Scalar t242 = Scalar(0.0094) * t238 - Scalar(0.0005096) * t239 +
      Scalar(0.0014129000000002) * t241 + Scalar(0.0007482) * (t240 - t187 * t187);
  const Scalar U_25_xy = domega_25_z + t188;
  const Scalar t243 = Scalar(0.0007482) * U_25_xy - Scalar(0.0019225000000002) * t184;
  const Scalar t244 = omega_r_24_x * t183;
  const Scalar t245 = Scalar(0.1902) * t181 - Scalar(0.0258331000000002) * domega_24_z -
      Scalar(0.0255131000000002) * t244 + s_25 * t243 + c_25 * t242;
  tau[23] = -t245;
  const Scalar mu_31_y = N_32_z + Scalar(0.00032) * omega_r_31_x * omega_31_z;
  const Scalar t246 = t225 * omega_31_z;
  const Scalar t247 = Scalar(0.1902) * t224 - Scalar(0.0255131000000002) * t228 -
      Scalar(0.0258331000000002) * t246 + s_32 * t235 - c_32 * N_32_y;
  const Scalar mu_30_z = Scalar(0.00096) * domega_30_z + s_31 * t247 - c_31 * mu_31_y +
      Scalar(0.00032) * omega_r_30_x * omega_r_30_y;
  tau[29] = mu_30_z;
  const Scalar t248 = N_25_z - Scalar(0.00032) * omega_r_24_x * omega_24_z;
  const Scalar t249 = t183 * omega_24_z;
  const Scalar t250 = Scalar(0.1902) * t182 - Scalar(0.0255131000000002) * t186 -
      Scalar(0.0258331000000002) * t249 - s_25 * t242 + c_25 * t243;
  const Scalar mu_23_z = Scalar(0.00096) * domega_23_z + s_24 * t250 + c_24 * t248 +
      Scalar(0.00032) * omega_r_23_x * omega_r_23_y;
  tau[22] = mu_23_z;
  const Scalar t251 = Scalar(0.00032) * t227 - s_31 * mu_31_y - c_31 * t247 +
      Scalar(0.00096) * omega_r_30_y * omega_30_z;
  const Scalar t252 = t237 - Scalar(0.00064) * omega_r_30_x * omega_30_z;
  const Scalar U_32_yy = t233 + omega_r_32_x * omega_r_32_x;
  const Scalar U_31_xy = domega_31_z + t236;
  const Scalar f_31_x = Scalar(0.1902) * U_31_xy +
      Scalar(0.0094) * (s_32 * U_32_xy + c_32 * U_32_yy);
  const Scalar U_31_yy = omega_31_z * omega_31_z + omega_r_31_x * omega_r_31_x;
  const Scalar f_31_y = Scalar(0.1902) * U_31_yy + Scalar(0.0094) * (t232 + t234);
  const Scalar t253 = s_31 * f_31_y - c_31 * f_31_x;
  const Scalar t254 = Scalar(0.1902) * (t228 + t246) -
      Scalar(0.0094) * (s_32 * U_32_yy - c_32 * U_32_xy);
  const Scalar t255 = s_30 * t253 + c_30 * t254;
  const Scalar f_u_31_t_y = s_31 * f_31_x + c_31 * f_31_y;
  const Scalar U_29_xx_yy = U_29_xx - U_29_yy;
  const Scalar mu_29_z = Scalar(0.8648) * ddp_29_x - Scalar(0.0328) * t221 +
      Scalar(0.2045534) * domega_29_z - Scalar(0.200951) * t208 - Scalar(0.0050592) * U_29_xx_yy +
      Scalar(0.004) * f_u_31_t_y - Scalar(0.239) * t255 - s_30 * t252 - c_30 * t251;
  tau[28] = mu_29_z;
  const Scalar t256 = Scalar(0.00032) * t185 + s_24 * t248 - c_24 * t250 +
      Scalar(0.00096) * omega_r_23_y * omega_23_z;
  const Scalar t257 = t245 - Scalar(0.00064) * omega_r_23_x * omega_23_z;
  const Scalar U_25_yy = t240 + omega_r_25_x * omega_r_25_x;
  const Scalar U_24_xy = domega_24_z + t244;
  const Scalar f_24_x = Scalar(0.1902) * U_24_xy -
      Scalar(0.0094) * (s_25 * U_25_xy + c_25 * U_25_yy);
  const Scalar U_24_yy = omega_24_z * omega_24_z + omega_r_24_x * omega_r_24_x;
  const Scalar f_24_y = Scalar(0.1902) * U_24_yy - Scalar(0.0094) * (t239 + t241);
  const Scalar t258 = s_24 * f_24_y - c_24 * f_24_x;
  const Scalar t259 = Scalar(0.1902) * (t186 + t249) +
      Scalar(0.0094) * (s_25 * U_25_yy - c_25 * U_25_xy);
  const Scalar t260 = s_23 * t258 + c_23 * t259;
  const Scalar f_u_24_t_y = s_24 * f_24_x + c_24 * f_24_y;
  const Scalar U_22_xx_yy = U_22_xx - U_22_yy;
  const Scalar mu_22_z = Scalar(0.8648) * ddp_22_x - Scalar(0.0328) * t179 +
      Scalar(0.2045534) * domega_22_z - Scalar(0.200951) * t167 - Scalar(0.0050592) * U_22_xx_yy +
      Scalar(0.004) * f_u_24_t_y - Scalar(0.239) * t260 - s_23 * t257 - c_23 * t256;
  tau[21] = mu_22_z;
  const Scalar f_u_30_t_y = s_30 * t254 - c_30 * t253;
  const Scalar t261 = Scalar(0.8648) * t211 + Scalar(0.200951) * t216 - Scalar(0.0050592) * t215 +
      Scalar(0.2045534) * t217 - Scalar(0.239) * f_u_30_t_y - s_30 * t251 + c_30 * t252;
  const Scalar t262 = Scalar(0.0328) * t211 - Scalar(0.0036024) * t214 + Scalar(0.0050592) * t218 +
      mu_30_z - Scalar(0.004) * f_u_30_t_y;
  const Scalar t263 = Scalar(0.0328) * t215 - Scalar(0.8648) * t218 + f_u_30_t_y;
  const Scalar t264 = t201 * omega_28_z;
  const Scalar tau_28 = Scalar(0.0032) * t209 + Scalar(0.0097684) * domega_28_z +
      Scalar(0.001934) * t210 - Scalar(0.0023) * (t212 - t264) + Scalar(0.004) * t263 +
      s_29 * t261 + c_29 * t262;
  tau[27] = tau_28;
  const Scalar f_u_23_t_y = s_23 * t259 - c_23 * t258;
  const Scalar t265 = Scalar(0.8648) * t170 + Scalar(0.200951) * t175 - Scalar(0.0050592) * t174 +
      Scalar(0.2045534) * t176 - Scalar(0.239) * f_u_23_t_y - s_23 * t256 + c_23 * t257;
  const Scalar t266 = Scalar(0.0328) * t170 - Scalar(0.0036024) * t173 + Scalar(0.0050592) * t177 +
      mu_23_z - Scalar(0.004) * f_u_23_t_y;
  const Scalar t267 = Scalar(0.0328) * t174 - Scalar(0.8648) * t177 + f_u_23_t_y;
  const Scalar t268 = t160 * omega_21_z;
  const Scalar tau_21 = Scalar(0.0032) * t168 + Scalar(0.0097684) * domega_21_z +
      Scalar(0.001934) * t169 - Scalar(0.0023) * (t171 - t268) + Scalar(0.004) * t267 +
      s_22 * t265 + c_22 * t266;
  tau[20] = tau_21;
  const Scalar t269 = Scalar(0.001934) * t212 - Scalar(0.0023) * U_28_yx +
      Scalar(0.0097684) * t264 - s_29 * t262 + c_29 * t261;
  const Scalar f_29_x = Scalar(0.0328) * U_29_xx - Scalar(0.8648) * U_29_xy + t255;
  const Scalar f_29_y = Scalar(0.0328) * U_29_yx + Scalar(0.8648) * U_29_yy + f_u_31_t_y;
  const Scalar t270 = s_29 * f_29_x - c_29 * f_29_y;
  const Scalar mu_28_y = Scalar(0.0032) * ddp_o_28_y - Scalar(0.0078344) * t204 +
      Scalar(0.0023) * (t202 - omega_r_28_x * omega_r_28_x) + mu_29_z + Scalar(0.004) * t270;
  const Scalar f_28_x = Scalar(0.0032) * U_28_xx + s_29 * f_29_y + c_29 * f_29_x;
  const Scalar f_28_y = Scalar(0.0032) * U_28_yx - t263;
  const Scalar t271 = s_28 * f_28_x - c_28 * f_28_y;
  const Scalar t272 = Scalar(1.661) * t192 - Scalar(0.4797322) * domega_27_z -
      Scalar(0.4777722) * t194 - Scalar(0.305) * t271 + s_28 * mu_28_y + c_28 * t269;
  tau[26] = -t272;
  const Scalar t273 = Scalar(0.001934) * t171 - Scalar(0.0023) * U_21_yx +
      Scalar(0.0097684) * t268 - s_22 * t266 + c_22 * t265;
  const Scalar f_22_x = Scalar(0.0328) * U_22_xx - Scalar(0.8648) * U_22_xy + t260;
  const Scalar f_22_y = Scalar(0.0328) * U_22_yx + Scalar(0.8648) * U_22_yy + f_u_24_t_y;
  const Scalar t274 = s_22 * f_22_x - c_22 * f_22_y;
  const Scalar mu_21_y = Scalar(0.0032) * ddp_o_21_y - Scalar(0.0078344) * t163 +
      Scalar(0.0023) * (t161 - omega_r_21_x * omega_r_21_x) + mu_22_z + Scalar(0.004) * t274;
  const Scalar f_21_x = Scalar(0.0032) * U_21_xx + s_22 * f_22_y + c_22 * f_22_x;
  const Scalar f_21_y = Scalar(0.0032) * U_21_yx - t267;
  const Scalar t275 = s_21 * f_21_x - c_21 * f_21_y;
  const Scalar t276 = Scalar(1.661) * t151 - Scalar(0.4797322) * domega_20_z -
      Scalar(0.4777722) * t153 - Scalar(0.305) * t275 + s_21 * mu_21_y + c_21 * t273;
  tau[19] = -t276;
  const Scalar f_u_28_t_y = s_28 * f_28_y + c_28 * f_28_x;
  const Scalar t277 = Scalar(1.661) * t196 + Scalar(0.4777722) * t197 + Scalar(0.4797322) * t198 +
      Scalar(0.305) * f_u_28_t_y + s_28 * t269 - c_28 * mu_28_y;
  const Scalar t278 = tau_28 - Scalar(0.00196) * omega_r_27_x * omega_27_z;
  const Scalar t279 = Scalar(0.00196) * omega_r_26_x;
  const Scalar mu_26_z = Scalar(0.00392) * domega_26_z - s_27 * t278 - c_27 * t277 -
      omega_r_26_y * t279;
  tau[25] = mu_26_z;
  const Scalar f_u_21_t_y = s_21 * f_21_y + c_21 * f_21_x;
  const Scalar t280 = Scalar(1.661) * t155 + Scalar(0.4777722) * t156 + Scalar(0.4797322) * t157 +
      Scalar(0.305) * f_u_21_t_y + s_21 * t273 - c_21 * mu_21_y;
  const Scalar t281 = tau_21 - Scalar(0.00196) * omega_r_20_x * omega_20_z;
  const Scalar t282 = Scalar(0.00196) * omega_r_19_x;
  const Scalar mu_19_z = Scalar(0.00392) * domega_19_z - s_20 * t281 - c_20 * t280 -
      omega_r_19_y * t282;
  tau[18] = mu_19_z;
  const Scalar f_27_x = Scalar(1.661) * U_27_xy + t271;
  const Scalar f_27_y = Scalar(1.661) * U_27_yy - Scalar(0.0032) * t205 - t270;
  const Scalar f_u_27_t_x = s_27 * f_27_x + c_27 * f_27_y;
  const Scalar t283 = Scalar(1.661) * t199 + f_u_28_t_y;
  const Scalar f_20_x = Scalar(1.661) * U_20_xy + t275;
  const Scalar f_20_y = Scalar(1.661) * U_20_yy - Scalar(0.0032) * t164 - t274;
  const Scalar f_u_20_t_x = s_20 * f_20_x + c_20 * f_20_y;
  const Scalar t284 = Scalar(1.661) * t158 + f_u_21_t_y;
  const Scalar t285 = (s_26 * t283 - c_26 * f_u_27_t_x) - (s_19 * t284 - c_19 * f_u_20_t_x);
  const Scalar mu_19_x = Scalar(0.00196) * domega_19_x - s_20 * t280 + c_20 * t281 +
      Scalar(0.00392) * omega_r_19_y * omega_19_z;
  const Scalar mu_26_x = Scalar(0.00196) * domega_26_x - s_27 * t277 + c_27 * t278 +
      Scalar(0.00392) * omega_r_26_y * omega_26_z;
  const Scalar t286 = t276 + omega_19_z * t282;
  const Scalar mu_26_y = t272 + omega_26_z * t279;
  const Scalar t287 = (s_27 * f_27_y - c_27 * f_27_x) + (s_20 * f_20_y - c_20 * f_20_x);
  const Scalar U_18_xy = domega_18_z - t30;
  const Scalar F_18_x = Scalar(0.02) * U_18_xx - Scalar(0.22) * U_18_xy;
  const Scalar U_18_yx = domega_18_z + t30;
  const Scalar F_18_y = Scalar(0.02) * U_18_yx + Scalar(0.22) * U_18_yy;
  const Scalar t288 = s_18 * F_18_x - c_18 * F_18_y;
  const Scalar t289 = Scalar(0.02) * t105 - Scalar(0.22) * t101;
  const Scalar t290 = s_17 * t288 + c_17 * t289;
  const Scalar f_u_18_t_y = s_18 * F_18_y + c_18 * F_18_x;
  const Scalar t291 = s_16 * f_u_18_t_y + c_16 * t290;
  const Scalar t292 = Scalar(0.0005) * t31 - s_17 * t118 - c_17 * t117 +
      Scalar(0.001125) * omega_r_16_y * omega_16_z;
  const Scalar mu_16_y = mu_17_z - Scalar(0.000625) * t27 * omega_16_z;
  const Scalar tau_15 = Scalar(4.062559499999667) * domega_15_z + Scalar(1.972772833332667) * t15 +
      Scalar(0.043998) * t14 - Scalar(89.72226) * t17 + Scalar(0.453) * t291 - Scalar(0.24) * t285 +
      Scalar(0.33) * t287 + s_16 * t292 + c_16 * mu_16_y + s_19 * mu_19_x - c_19 * t286 +
      s_26 * mu_26_x - c_26 * mu_26_y;
  tau[14] = tau_15;
  const Scalar t293 = s_26 * f_u_27_t_x + c_26 * t283;
  const Scalar t294 = s_19 * f_u_20_t_x + c_19 * t284;
  const Scalar t295 = Scalar(1.972772833332667) * t12 - Scalar(0.043998) * U_15_yx -
      Scalar(4.062559499999667) * t13 + mu_16_z + Scalar(0.003) * t291 -
      Scalar(0.24) * (t293 - t294) + s_19 * t286 + c_19 * mu_19_x + s_26 * mu_26_y + c_26 * mu_26_x;
  const Scalar t296 = s_16 * t290 - c_16 * f_u_18_t_y;
  const Scalar f_u_17_t_y = s_17 * t289 - c_17 * t288;
  const Scalar U_15_zz_xx = U_15_xx - U_15_zz;
  const Scalar mu_15_y = Scalar(89.72226) * s_14 + Scalar(6.035332333332334) * t7 -
      Scalar(0.043998) * U_15_zz_xx - mu_26_z - mu_19_z + Scalar(0.003) * f_u_17_t_y -
      Scalar(0.453) * t296 - Scalar(0.33) * (t293 + t294) - s_16 * mu_16_y + c_16 * t292;
  const Scalar t297 = c_14 * (qd_13 * t3 - Scalar(0.6119232795934959));
  tau[13] = Scalar(3.064451499999667) * qdd_14 - s_15 * t295 - c_15 * mu_15_y +
      Scalar(3.062001499999667) * t297;
  const Scalar mu_14_x = Scalar(3.064451499999667) * t4 + Scalar(3.062001499999667) * t5 +
      s_15 * mu_15_y - c_15 * t295;
  const Scalar mu_14_y = Scalar(0.00245) * t16 - tau_15;
  tau[12] = Scalar(0.00565) * qdd_13 + s_14 * mu_14_y - c_14 * mu_14_x;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[1024] = {
    1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 1, 1, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1};

// joint-space inertia matrix B(q) (7.32).
//   q[32]    in   joint positions, rad or m
//   B[1024]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//                 32 x 32, row by row: entry (i, j) is B[32 * i + j]
// Reads q[1..5], q[7..11], q[13..31]. Operations: 991 mul, 726 add, 58 sin/cos. Always zero: 740 of
// the 1024 entries of B.
template <class Scalar>
inline void inertia_matrix(const Scalar* q, Scalar* B) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_8 = q[7], q_9 = q[8],
      q_10 = q[9], q_11 = q[10], q_12 = q[11], q_14 = q[13], q_15 = q[14], q_16 = q[15],
      q_17 = q[16], q_18 = q[17], q_19 = q[18], q_20 = q[19], q_21 = q[20], q_22 = q[21],
      q_23 = q[22], q_24 = q[23], q_25 = q[24], q_26 = q[25], q_27 = q[26], q_28 = q[27],
      q_29 = q[28], q_30 = q[29], q_31 = q[30], q_32 = q[31];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_8 = sin(q_8), c_8 = cos(q_8);
  const Scalar s_9 = sin(q_9), c_9 = cos(q_9);
  const Scalar s_10 = sin(q_10), c_10 = cos(q_10);
  const Scalar s_11 = sin(q_11), c_11 = cos(q_11);
  const Scalar s_12 = sin(q_12), c_12 = cos(q_12);
  const Scalar s_14 = sin(q_14), c_14 = cos(q_14);
  const Scalar s_15 = sin(q_15), c_15 = cos(q_15);
  const Scalar s_16 = sin(q_16), c_16 = cos(q_16);
  const Scalar s_17 = sin(q_17), c_17 = cos(q_17);
  const Scalar s_18 = sin(q_18), c_18 = cos(q_18);
  const Scalar s_19 = sin(q_19), c_19 = cos(q_19);
  const Scalar s_20 = sin(q_20), c_20 = cos(q_20);
  const Scalar s_21 = sin(q_21), c_21 = cos(q_21);
  const Scalar s_22 = sin(q_22), c_22 = cos(q_22);
  const Scalar s_23 = sin(q_23), c_23 = cos(q_23);
  const Scalar s_24 = sin(q_24), c_24 = cos(q_24);
  const Scalar s_25 = sin(q_25), c_25 = cos(q_25);
  const Scalar s_26 = sin(q_26), c_26 = cos(q_26);
  const Scalar s_27 = sin(q_27), c_27 = cos(q_27);
  const Scalar s_28 = sin(q_28), c_28 = cos(q_28);
  const Scalar s_29 = sin(q_29), c_29 = cos(q_29);
  const Scalar s_30 = sin(q_30), c_30 = cos(q_30);
  const Scalar s_31 = sin(q_31), c_31 = cos(q_31);
  const Scalar s_32 = sin(q_32), c_32 = cos(q_32);
  const Scalar Iu_32_a_xy = Scalar(0.0007482) * s_32;
  B[991] = B[1022] = Iu_32_a_xy;
  B[760] = B[791] = Scalar(-0.0007482) * s_25;
  const Scalar mu_u_18_17_t_y = Scalar(0.03408) * s_17;
  B[497] = B[559] = mu_u_18_17_t_y;
  const Scalar t1 = s_24 * c_25;
  const Scalar mu_u_25_24_t_y = Scalar(0.0014129000000002) * c_24 + Scalar(0.0007482) * t1;
  B[728] = B[790] = mu_u_25_24_t_y;
  const Scalar t2 = s_31 * c_32;
  const Scalar mu_u_32_31_t_y = Scalar(0.0014129000000002) * c_31 - Scalar(0.0007482) * t2;
  B[959] = B[1021] = mu_u_32_31_t_y;
  const Scalar t3 = Scalar(0.0005096) * s_32 * s_32;
  const Scalar Ic_31_zz = t3 + Scalar(0.0253235000000002);
  B[990] = Ic_31_zz;
  const Scalar Iu_31_t_yz = Iu_32_a_xy * (c_31 - Scalar(0.6811013098102112) * t2);
  B[958] = B[989] = Iu_31_t_yz;
  const Scalar t4 = Scalar(0.0005096) * s_25 * s_25;
  const Scalar Ic_24_zz = t4 + Scalar(0.0253235000000002);
  B[759] = Ic_24_zz;
  const Scalar Iu_12_t_g = Scalar(0.0063) * c_12 - Scalar(0.0012) * s_12;
  const Scalar t5 = s_12 * Iu_12_t_g;
  const Scalar Ic_11_zz = t5 + Scalar(0.00940666666667);
  B[330] = Ic_11_zz;
  const Scalar Iu_6_t_g = Scalar(0.0063) * c_6 - Scalar(0.0012) * s_6;
  const Scalar t6 = s_6 * Iu_6_t_g;
  const Scalar Ic_5_zz = t6 + Scalar(0.00940666666667);
  B[132] = Ic_5_zz;
  const Scalar t7 = Scalar(0.0007482) * s_25;
  const Scalar t8 = t7 * (c_24 + Scalar(0.6811013098102112) * t1);
  B[727] = B[758] = -t8;
  const Scalar Iu_18_t_g = Scalar(0.0044) * c_18 + Scalar(0.024) * s_18;
  const Scalar t9 = s_18 * Iu_18_t_g;
  const Scalar Ic_17_zz = t9 - Scalar(0.03438);
  B[528] = -Ic_17_zz;
  const Scalar hu_6_t_y = Scalar(0.045) * c_6 - Scalar(0.105) * s_6;
  const Scalar t10 = Scalar(0.04) * hu_6_t_y + Scalar(0.01431666666667);
  const Scalar hu_6_t_x = Scalar(0.105) * c_6 + Scalar(0.045) * s_6;
  const Scalar t11 = Scalar(0.357) * hu_6_t_x;
  const Scalar mu_6_4_z = t11 + c_5 * t10;
  B[101] = B[163] = mu_6_4_z;
  const Scalar hu_12_t_y = Scalar(0.045) * c_12 - Scalar(0.105) * s_12;
  const Scalar t12 = Scalar(0.04) * hu_12_t_y + Scalar(0.01431666666667);
  const Scalar hu_12_t_x = Scalar(0.105) * c_12 + Scalar(0.045) * s_12;
  const Scalar t13 = Scalar(0.357) * hu_12_t_x;
  const Scalar mu_12_10_z = t13 + c_11 * t12;
  B[299] = B[361] = mu_12_10_z;
  const Scalar Iu_18_t_xy = c_18 * Iu_18_t_g - Scalar(0.0022);
  B[496] = B[527] = -c_17 * Iu_18_t_xy;
  const Scalar t14 = Scalar(0.04) * hu_6_t_x + c_6 * Iu_6_t_g - Scalar(0.00315);
  B[100] = B[131] = -s_5 * t14;
  const Scalar t15 = Scalar(0.357) * hu_6_t_y;
  const Scalar B_3_6 = s_5 * (c_4 * t10 - t15 * (s_4 + Scalar(0.056022408963585436)));
  B[69] = B[162] = B_3_6;
  const Scalar t16 = Scalar(0.04) * hu_12_t_x + c_12 * Iu_12_t_g - Scalar(0.00315);
  B[298] = B[329] = -s_11 * t16;
  const Scalar t17 = Scalar(0.357) * hu_12_t_y;
  const Scalar B_9_12 = s_11 * (c_10 * t12 - t17 * (s_10 + Scalar(0.056022408963585436)));
  B[267] = B[360] = B_9_12;
  const Scalar hu_18_t_x = Scalar(0.22) * c_18 - Scalar(0.02) * s_18;
  const Scalar hu_18_t_y = Scalar(0.02) * c_18 + Scalar(0.22) * s_18;
  const Scalar t18 = c_16 * s_17;
  const Scalar f_u_18_16_t_x = s_16 * hu_18_t_x + hu_18_t_y * t18;
  const Scalar t19 = Scalar(0.03408) * c_17;
  const Scalar mu_18_15_z = Scalar(0.453) * f_u_18_16_t_x + s_16 * t19;
  B[465] = B[558] = -mu_18_15_z;
  const Scalar t20 = Scalar(0.0094) * s_32;
  const Scalar t21 = s_30 * t20;
  const Scalar t22 = Scalar(0.0094) * c_32;
  const Scalar t23 = c_31 * t21 - c_30 * t22;
  const Scalar t24 = c_31 * c_32;
  const Scalar mu_u_32_31_t_x = Scalar(0.0014129000000002) * s_31 + Scalar(0.0007482) * t24;
  const Scalar mu_32_29_z = Scalar(0.239) * t23 + Scalar(0.0000376) * s_31 * s_32 -
      c_30 * mu_u_32_31_t_x + s_30 * Iu_32_a_xy;
  B[927] = B[1020] = mu_32_29_z;
  const Scalar Iu_18_t_xx = t9 - Scalar(0.024);
  const Scalar Iu_17_t_d = Iu_18_t_xx - Scalar(0.0002);
  const Scalar t25 = s_17 * s_17 * Iu_17_t_d;
  const Scalar Ic_16_zz = Iu_18_t_xx - t25 + Scalar(0.035005);
  B[495] = Ic_16_zz;
  const Scalar t26 = Scalar(0.0094) * c_25;
  const Scalar hu_24_t_y = Scalar(0.1902) * c_24 - s_24 * t26;
  const Scalar t27 = Ic_24_zz + Scalar(0.239) * hu_24_t_y;
  const Scalar t28 = c_24 * c_25;
  const Scalar t29 = s_24 - Scalar(0.6811013098102112) * t28;
  const Scalar t30 = t7 * t29;
  const Scalar hu_24_t_x = Scalar(0.1902) * s_24 + c_24 * t26;
  const Scalar mu_24_22_z = Scalar(0.004) * hu_24_t_x + s_23 * t27 + c_23 * t30;
  B[695] = B[757] = mu_24_22_z;
  const Scalar t31 = Scalar(0.0094) * s_25;
  const Scalar t32 = s_23 * t31;
  const Scalar t33 = c_24 * t32 - c_23 * t26;
  const Scalar mu_u_25_24_t_x = Scalar(0.0014129000000002) * s_24 - Scalar(0.0007482) * t28;
  const Scalar mu_25_22_z = Scalar(0.239) * t33 + Scalar(0.0000376) * s_24 * s_25 +
      c_23 * mu_u_25_24_t_x + s_23 * t7;
  B[696] = B[789] = -mu_25_22_z;
  const Scalar hu_31_t_y = Scalar(0.1902) * c_31 + s_31 * t22;
  const Scalar t34 = Ic_31_zz + Scalar(0.239) * hu_31_t_y;
  const Scalar t35 = s_31 + Scalar(0.6811013098102112) * t24;
  const Scalar t36 = Iu_32_a_xy * t35;
  const Scalar hu_31_t_x = Scalar(0.1902) * s_31 - c_31 * t22;
  const Scalar mu_31_29_z = Scalar(0.004) * hu_31_t_x + s_30 * t34 - c_30 * t36;
  B[926] = B[988] = mu_31_29_z;
  const Scalar t37 = c_17 * hu_18_t_x;
  const Scalar t38 = Ic_17_zz - Scalar(0.453) * t37;
  const Scalar t39 = s_16 * s_17;
  const Scalar t40 = Iu_18_t_xy * t39;
  const Scalar t41 = t40 + c_16 * t38;
  B[464] = B[526] = -t41;
  const Scalar mu_18_15_x = mu_u_18_17_t_y - Scalar(0.003) * f_u_18_16_t_x;
  const Scalar t42 = hu_18_t_y * t39 - c_16 * hu_18_t_x;
  const Scalar t43 = Scalar(0.453) * t42 - (c_16 - Scalar(0.0880281690140845) * hu_18_t_y) * t19;
  B[433] = B[557] = -s_15 * mu_18_15_x - c_15 * t43;
  const Scalar Iu_12_t_xx = t5 + Scalar(0.0012);
  const Scalar Iu_11_t_d = Iu_12_t_xx + Scalar(0.00555);
  const Scalar t44 = c_11 * Iu_11_t_d;
  const Scalar t45 = c_11 * t44;
  const Scalar t46 = c_11 * hu_12_t_x;
  const Scalar t47 = Scalar(0.714) * t46;
  const Scalar t48 = Scalar(0.08) * hu_12_t_y;
  const Scalar t49 = Iu_12_t_xx - t45 - t48 - t47 - Scalar(0.44815416666667);
  B[297] = -t49;
  const Scalar Iu_6_t_xx = t6 + Scalar(0.0012);
  const Scalar Iu_5_t_d = Iu_6_t_xx + Scalar(0.00555);
  const Scalar t50 = c_5 * Iu_5_t_d;
  const Scalar t51 = c_5 * t50;
  const Scalar t52 = c_5 * hu_6_t_x;
  const Scalar t53 = Scalar(0.714) * t52;
  const Scalar t54 = Scalar(0.08) * hu_6_t_y;
  const Scalar t55 = Iu_6_t_xx - t51 - t54 - t53 - Scalar(0.44815416666667);
  B[99] = -t55;
  const Scalar t56 = c_4 * t14;
  const Scalar t57 = Scalar(0.02) * hu_6_t_x;
  const Scalar mu_5_4_y = Ic_5_zz + Scalar(0.357) * t52;
  const Scalar mu_5_3_z = s_4 * mu_5_4_y - c_5 * (t56 - t57);
  B[68] = B[130] = -mu_5_3_z;
  const Scalar t58 = c_5 * t14;
  const Scalar mu_u_5_4_t_x = s_4 * t58 + c_4 * mu_5_4_y;
  const Scalar t59 = t14 - c_4 * t57;
  const Scalar t60 = s_3 * s_5;
  const Scalar t61 = Scalar(0.389) * hu_6_t_x;
  const Scalar t62 = (s_4 * t60 + c_3 * c_5) * t61;
  B[36] = B[129] = t60 * t59 + c_3 * mu_u_5_4_t_x + t62;
  const Scalar t63 = c_5 * hu_6_t_y;
  const Scalar f_u_6_4_t_x = s_4 * t63 + c_4 * hu_6_t_x;
  const Scalar t64 = c_3 * s_5;
  const Scalar t65 = s_3 * f_u_6_4_t_x - hu_6_t_y * t64;
  const Scalar mu_6_3_y = mu_6_4_z + Scalar(0.02) * (s_4 * hu_6_t_x - c_4 * t63);
  const Scalar t66 = s_4 * t10 + c_4 * t15;
  B[37] = B[161] = t64 * t66 - Scalar(0.389) * t65 - s_3 * mu_6_3_y;
  const Scalar t67 = c_10 * t16;
  const Scalar t68 = Scalar(0.02) * hu_12_t_x;
  const Scalar mu_11_10_y = Ic_11_zz + Scalar(0.357) * t46;
  const Scalar mu_11_9_z = s_10 * mu_11_10_y - c_11 * (t67 - t68);
  B[266] = B[328] = -mu_11_9_z;
  const Scalar t69 = c_11 * t16;
  const Scalar mu_u_11_10_t_x = s_10 * t69 + c_10 * mu_11_10_y;
  const Scalar t70 = t16 - c_10 * t68;
  const Scalar t71 = s_9 * s_11;
  const Scalar t72 = Scalar(0.389) * hu_12_t_x;
  const Scalar t73 = (s_10 * t71 + c_9 * c_11) * t72;
  B[234] = B[327] = t71 * t70 + c_9 * mu_u_11_10_t_x + t73;
  const Scalar t74 = c_11 * hu_12_t_y;
  const Scalar f_u_12_10_t_x = s_10 * t74 + c_10 * hu_12_t_x;
  const Scalar t75 = c_9 * s_11;
  const Scalar t76 = s_9 * f_u_12_10_t_x - hu_12_t_y * t75;
  const Scalar mu_12_9_y = mu_12_10_z + Scalar(0.02) * (s_10 * hu_12_t_x - c_10 * t74);
  const Scalar t77 = s_10 * t12 + c_10 * t17;
  B[235] = B[359] = t75 * t77 - Scalar(0.389) * t76 - s_9 * mu_12_9_y;
  B[401] = B[556] = s_14 * mu_18_15_z - c_14 * (s_15 * t43 - c_15 * mu_18_15_x);
  const Scalar t78 = s_23 * t30 - c_23 * t27;
  const Scalar t79 = c_23 * hu_24_t_y;
  const Scalar t80 = Scalar(0.004) * t79;
  const Scalar mu_24_22_y = t8 + t80;
  const Scalar mu_24_21_z = t80 + s_22 * t78 - c_22 * mu_24_22_y;
  B[663] = B[756] = mu_24_21_z;
  const Scalar mu_31_29_x = s_30 * t36 + c_30 * t34;
  const Scalar t81 = c_30 * hu_31_t_y;
  const Scalar t82 = Scalar(0.004) * t81;
  const Scalar t83 = Iu_31_t_yz - t82;
  const Scalar mu_31_28_z = t82 - s_29 * mu_31_29_x + c_29 * t83;
  B[894] = B[987] = mu_31_28_z;
  const Scalar t84 = c_30 * t20;
  const Scalar f_u_32_30_t_y = s_30 * t22 + c_31 * t84;
  const Scalar t85 = Scalar(0.004) * f_u_32_30_t_y;
  const Scalar mu_32_29_y = mu_u_32_31_t_y - t85;
  const Scalar mu_32_29_x = Scalar(0.239) * f_u_32_30_t_y + s_30 * mu_u_32_31_t_x +
      c_30 * Iu_32_a_xy;
  const Scalar mu_32_28_z = t85 - s_29 * mu_32_29_x + c_29 * mu_32_29_y;
  B[895] = B[1019] = mu_32_28_z;
  const Scalar Iu_32_t_xx = t3 - Scalar(0.0005096);
  const Scalar Iu_31_t_d = Iu_32_t_xx - Scalar(0.0235906);
  const Scalar t86 = c_31 * Iu_31_t_d - Scalar(0.0014964) * t2;
  const Scalar t87 = c_31 * t86;
  const Scalar Ic_30_zz = Iu_32_t_xx - t87 - Scalar(0.0259635000000002);
  B[957] = -Ic_30_zz;
  const Scalar Iu_25_t_xx = t4 - Scalar(0.0005096);
  const Scalar Iu_24_t_d = Iu_25_t_xx - Scalar(0.0235906);
  const Scalar Iu_24_t_g = c_24 * Iu_24_t_d + Scalar(0.0014964) * t1;
  const Scalar t88 = c_24 * Iu_24_t_g;
  const Scalar Ic_23_zz = Iu_25_t_xx - t88 - Scalar(0.0259635000000002);
  B[726] = -Ic_23_zz;
  const Scalar t89 = t44 + t13;
  const Scalar t90 = s_10 * t16 + c_10 * t89;
  const Scalar Iu_10_t_yz = s_11 * t90;
  B[265] = B[296] = Iu_10_t_yz;
  const Scalar t91 = t50 + t11;
  const Scalar t92 = s_4 * t14 + c_4 * t91;
  const Scalar Iu_4_t_yz = s_5 * t92;
  B[67] = B[98] = Iu_4_t_yz;
  const Scalar t93 = c_16 * Iu_18_t_xy;
  const Scalar hu_16_t_y = hu_18_t_x * t39 + c_16 * hu_18_t_y;
  const Scalar t94 = Scalar(0.453) * hu_16_t_y - c_17 * (Iu_17_t_d * t39 - t93);
  B[463] = B[494] = -t94;
  const Scalar t95 = Scalar(0.003) * hu_18_t_x;
  const Scalar mu_17_15_y = s_16 * t38 - s_17 * (t93 - t95);
  const Scalar t96 = c_17 * (Iu_18_t_xy - c_16 * t95);
  B[432] = B[525] = s_15 * t96 - c_15 * mu_17_15_y;
  const Scalar t97 = c_23 * t31;
  const Scalar f_u_25_23_t_y = s_23 * t26 + c_24 * t97;
  const Scalar t98 = Scalar(0.004) * f_u_25_23_t_y;
  const Scalar mu_25_22_y = mu_u_25_24_t_y + t98;
  const Scalar mu_25_22_x = Scalar(0.239) * f_u_25_23_t_y - s_23 * mu_u_25_24_t_x + c_23 * t7;
  const Scalar mu_25_21_z = t98 - s_22 * mu_25_22_x - c_22 * mu_25_22_y;
  B[664] = B[788] = -mu_25_21_z;
  const Scalar Iu_31_t_xy = Scalar(0.0007482) * c_32 + s_31 * t86;
  const Scalar hu_30_t_y = t21 + c_30 * hu_31_t_x;
  const Scalar Ic_29_yz = Scalar(0.239) * hu_30_t_y + s_30 * Iu_31_t_yz - c_30 * Iu_31_t_xy;
  B[925] = B[956] = Ic_29_yz;
  const Scalar t99 = s_4 * t91 - t56;
  const Scalar hc_4_x = t52 + Scalar(1.3725);
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.22);
  const Scalar t100 = s_4 * hc_4_x - c_4 * hc_4_y;
  const Scalar hu_4_t_y = s_4 * hc_4_y + c_4 * hc_4_x;
  const Scalar t101 = t55 - Scalar(0.02) * t100 - Scalar(0.389) * hu_4_t_y;
  B[35] = B[97] = t99 * t64 + s_3 * t101;
  const Scalar t102 = (s_3 * c_5 - s_4 * t64) * t61;
  B[4] = B[128] = s_2 * mu_5_3_z + c_2 * (s_3 * mu_u_5_4_t_x - t64 * t59 + t102);
  const Scalar f_u_6_3_t_y = hu_6_t_y * t60 + c_3 * f_u_6_4_t_x;
  const Scalar mu_6_2_x = Scalar(0.389) * f_u_6_3_t_y + t60 * t66 + c_3 * mu_6_3_y;
  B[5] = B[160] = c_2 * mu_6_2_x - s_2 * B_3_6;
  const Scalar t103 = s_10 * t89 - t67;
  const Scalar hc_10_x = t46 + Scalar(1.3725);
  const Scalar hc_10_y = hu_12_t_y + Scalar(0.22);
  const Scalar t104 = s_10 * hc_10_x - c_10 * hc_10_y;
  const Scalar hu_10_t_y = s_10 * hc_10_y + c_10 * hc_10_x;
  const Scalar t105 = t49 - Scalar(0.02) * t104 - Scalar(0.389) * hu_10_t_y;
  B[233] = B[295] = t103 * t75 + s_9 * t105;
  const Scalar t106 = (s_9 * c_11 - s_10 * t75) * t72;
  B[202] = B[326] = s_8 * mu_11_9_z + c_8 * (s_9 * mu_u_11_10_t_x - t75 * t70 + t106);
  const Scalar f_u_12_9_t_y = hu_12_t_y * t71 + c_9 * f_u_12_10_t_x;
  const Scalar mu_12_8_x = Scalar(0.389) * f_u_12_9_t_y + t71 * t77 + c_9 * mu_12_9_y;
  B[203] = B[358] = c_8 * mu_12_8_x - s_8 * B_9_12;
  const Scalar t107 = s_22 * mu_24_22_y + c_22 * t78;
  const Scalar t108 = s_23 * hu_24_t_y;
  const Scalar t109 = s_22 * hu_24_t_x - c_22 * t108;
  const Scalar f_u_24_21_t_x = s_21 * t109 + c_21 * t79;
  const Scalar f_u_24_22_t_y = s_22 * t108 + c_22 * hu_24_t_x;
  const Scalar mu_24_21_y = mu_24_22_z - Scalar(0.004) * f_u_24_22_t_y;
  const Scalar mu_24_20_z = Scalar(0.305) * f_u_24_21_t_x - s_21 * mu_24_21_y - c_21 * t107;
  B[631] = B[755] = mu_24_20_z;
  const Scalar t110 = s_29 * t83 + c_29 * mu_31_29_x;
  const Scalar t111 = s_30 * hu_31_t_y;
  const Scalar t112 = s_29 * hu_31_t_x - c_29 * t111;
  const Scalar f_u_31_28_t_x = s_28 * t112 + c_28 * t81;
  const Scalar f_u_31_29_t_y = s_29 * t111 + c_29 * hu_31_t_x;
  const Scalar mu_31_28_y = mu_31_29_z - Scalar(0.004) * f_u_31_29_t_y;
  const Scalar mu_31_27_z = Scalar(0.305) * f_u_31_28_t_x - s_28 * mu_31_28_y + c_28 * t110;
  B[862] = B[986] = mu_31_27_z;
  const Scalar mu_u_32_29_t_x = s_29 * mu_32_29_y + c_29 * mu_32_29_x;
  const Scalar t113 = s_31 * t20;
  const Scalar f_u_32_29_t_x = s_29 * t113 - c_29 * t23;
  const Scalar f_u_32_28_t_x = s_28 * f_u_32_29_t_x + c_28 * f_u_32_30_t_y;
  const Scalar f_u_32_29_t_y = s_29 * t23 + c_29 * t113;
  const Scalar mu_32_28_y = mu_32_29_z - Scalar(0.004) * f_u_32_29_t_y;
  const Scalar mu_32_27_z = Scalar(0.305) * f_u_32_28_t_x - s_28 * mu_32_28_y +
      c_28 * mu_u_32_29_t_x;
  B[863] = B[1018] = mu_32_27_z;
  const Scalar Iu_24_t_xy = Scalar(0.0007482) * c_25 - s_24 * Iu_24_t_g;
  const Scalar t114 = t32 - c_23 * hu_24_t_x;
  const Scalar t115 = Scalar(0.239) * t114 + s_23 * t8 - c_23 * Iu_24_t_xy;
  B[694] = B[725] = -t115;
  const Scalar t116 = s_16 * hu_18_t_y - hu_18_t_x * t18;
  const Scalar t117 = Scalar(0.453) * t116 + c_17 * (s_16 * Iu_18_t_xy + Iu_17_t_d * t18);
  const Scalar mu_16_15_x = Ic_16_zz - Scalar(0.003) * hu_16_t_y;
  B[431] = B[493] = -s_15 * mu_16_15_x - c_15 * t117;
  const Scalar mu_u_17_15_t_x = s_15 * mu_17_15_y + c_15 * t96;
  B[400] = B[524] = s_14 * t41 - c_14 * mu_u_17_15_t_x;
  const Scalar t118 = s_22 * mu_25_22_y - c_22 * mu_25_22_x;
  const Scalar t119 = s_24 * t31;
  const Scalar f_u_25_22_t_x = s_22 * t119 - c_22 * t33;
  const Scalar f_u_25_21_t_x = s_21 * f_u_25_22_t_x + c_21 * f_u_25_23_t_y;
  const Scalar f_u_25_22_t_y = s_22 * t33 + c_22 * t119;
  const Scalar mu_25_21_y = mu_25_22_z - Scalar(0.004) * f_u_25_22_t_y;
  const Scalar mu_25_20_z = Scalar(0.305) * f_u_25_21_t_x - s_21 * mu_25_21_y - c_21 * t118;
  B[632] = B[787] = -mu_25_20_z;
  B[399] = B[492] = s_14 * t94 - c_14 * (s_15 * t117 - c_15 * mu_16_15_x);
  const Scalar t120 = s_21 * f_u_25_23_t_y - c_21 * f_u_25_22_t_x;
  const Scalar t121 = Scalar(0.305) * t120 - s_21 * t118 + c_21 * mu_25_21_y;
  const Scalar mu_u_25_20_t_y = s_20 * mu_25_21_z - c_20 * t121;
  B[600] = B[786] = mu_u_25_20_t_y;
  const Scalar t122 = s_30 * hu_31_t_x - t84;
  const Scalar t123 = Scalar(0.239) * t122 - s_30 * Iu_31_t_xy - c_30 * Iu_31_t_yz;
  const Scalar t124 = Scalar(-0.004) * t122;
  const Scalar mu_30_29_y = Ic_30_zz + t124;
  const Scalar mu_30_28_z = t124 + s_29 * t123 - c_29 * mu_30_29_y;
  B[893] = B[955] = mu_30_28_z;
  const Scalar t125 = t45 - t48 - Scalar(0.00555);
  const Scalar Ic_10_yy = Ic_11_zz + t47 + Scalar(0.40049083333333);
  const Scalar Ic_10_xy = t69 + t17 + Scalar(0.0549);
  const Scalar t126 = s_10 * (t125 + Ic_10_yy) - Scalar(2.0) * c_10 * Ic_10_xy;
  const Scalar t127 = s_10 * t126;
  const Scalar t128 = Scalar(-0.04) * t104;
  const Scalar t129 = t125 - t127 + t128 - Scalar(0.03800666666667);
  B[264] = -t129;
  const Scalar t130 = t51 - t54 - Scalar(0.00555);
  const Scalar Ic_4_yy = Ic_5_zz + t53 + Scalar(0.40049083333333);
  const Scalar Ic_4_xy = t58 + t15 + Scalar(0.0549);
  const Scalar t131 = s_4 * (t130 + Ic_4_yy) - Scalar(2.0) * c_4 * Ic_4_xy;
  const Scalar t132 = s_4 * t131;
  const Scalar t133 = Scalar(-0.04) * t100;
  const Scalar t134 = t130 - t132 + t133 - Scalar(0.03800666666667);
  B[66] = -t134;
  const Scalar mu_4_2_x = t99 * t60 - c_3 * t101;
  B[3] = B[96] = c_2 * mu_4_2_x - s_2 * Iu_4_t_yz;
  const Scalar mu_10_8_x = t103 * t71 - c_9 * t105;
  B[201] = B[294] = c_8 * mu_10_8_x - s_8 * Iu_10_t_yz;
  const Scalar hu_23_t_x = s_23 * hu_24_t_x + t97;
  const Scalar mu_23_22_x = Scalar(0.239) * hu_23_t_x + s_23 * Iu_24_t_xy + c_23 * t8;
  const Scalar t135 = Scalar(0.004) * hu_23_t_x;
  const Scalar mu_23_22_y = Ic_23_zz - t135;
  const Scalar mu_23_21_z = t135 - s_22 * mu_23_22_x + c_22 * mu_23_22_y;
  B[662] = B[724] = -mu_23_21_z;
  const Scalar f_u_24_21_t_y = s_21 * t79 - c_21 * t109;
  const Scalar mu_24_20_x = Scalar(0.305) * f_u_24_21_t_y - s_21 * t107 + c_21 * mu_24_21_y;
  const Scalar t136 = s_20 * mu_24_21_z - c_20 * mu_24_20_x;
  B[599] = B[754] = -t136;
  const Scalar f_u_31_28_t_y = s_28 * t81 - c_28 * t112;
  const Scalar mu_31_27_x = Scalar(0.305) * f_u_31_28_t_y + s_28 * t110 + c_28 * mu_31_28_y;
  const Scalar t137 = s_27 * mu_31_28_z - c_27 * mu_31_27_x;
  B[830] = B[985] = -t137;
  const Scalar t138 = s_28 * f_u_32_30_t_y - c_28 * f_u_32_29_t_x;
  const Scalar t139 = Scalar(0.305) * t138 + s_28 * mu_u_32_29_t_x + c_28 * mu_32_28_y;
  const Scalar mu_u_32_27_t_y = s_27 * mu_32_28_z - c_27 * t139;
  B[831] = B[1017] = -mu_u_32_27_t_y;
  const Scalar t140 = t87 + Scalar(0.0235906);
  const Scalar Ic_30_yy = Ic_31_zz - Scalar(0.0253235000000002);
  const Scalar t141 = s_30 * (t140 + Ic_30_yy) - Scalar(0.0014964) * c_30 * s_32 * t35;
  const Scalar t142 = s_30 * t141;
  const Scalar t143 = Scalar(-0.008) * t122;
  const Scalar t144 = Scalar(0.478) * hu_31_t_y;
  const Scalar t145 = t140 - t142 - t144 + t143 - Scalar(0.2298769000000002);
  B[924] = -t145;
  const Scalar Iu_24_t_xx = t88 + Scalar(0.0235906);
  const Scalar Ic_23_yy = Ic_24_zz - Scalar(0.0253235000000002);
  const Scalar Iu_23_t_d = Iu_24_t_xx + Ic_23_yy;
  const Scalar t146 = s_23 * Iu_23_t_d + Scalar(0.0014964) * c_23 * s_25 * t29;
  const Scalar t147 = s_23 * t146;
  const Scalar t148 = Scalar(0.008) * hu_23_t_x;
  const Scalar t149 = Scalar(0.478) * hu_24_t_y;
  const Scalar t150 = Iu_24_t_xx - t147 - t149 - t148 - Scalar(0.2298769000000002);
  B[693] = -t150;
  const Scalar mu_u_23_22_t_x = s_22 * mu_23_22_y + c_22 * mu_23_22_x;
  const Scalar t151 = s_22 * t114;
  const Scalar t152 = t115 - Scalar(0.004) * t151;
  const Scalar t153 = s_21 * t114;
  const Scalar t154 = c_22 * t153 - c_21 * hu_23_t_x;
  const Scalar B_20_23 = Scalar(0.305) * t154 + s_21 * t152 - c_21 * mu_u_23_22_t_x;
  B[630] = B[723] = B_20_23;
  const Scalar mu_u_24_20_t_x = s_20 * mu_24_20_x + c_20 * mu_24_21_z;
  const Scalar f_u_24_20_t_x = s_20 * f_u_24_21_t_x + c_20 * f_u_24_22_t_y;
  const Scalar f_u_24_19_t_x = s_19 * f_u_24_21_t_y + c_19 * f_u_24_20_t_x;
  const Scalar t155 = s_20 * f_u_24_22_t_y - c_20 * f_u_24_21_t_x;
  const Scalar B_15_24 = Scalar(0.33) * t155 - Scalar(0.24) * f_u_24_19_t_x +
      s_19 * mu_u_24_20_t_x + c_19 * mu_24_20_z;
  B[471] = B[750] = B_15_24;
  const Scalar mu_u_31_27_t_x = s_27 * mu_31_27_x + c_27 * mu_31_28_z;
  const Scalar f_u_31_27_t_x = s_27 * f_u_31_28_t_x + c_27 * f_u_31_29_t_y;
  const Scalar f_u_31_26_t_x = s_26 * f_u_31_28_t_y + c_26 * f_u_31_27_t_x;
  const Scalar t156 = s_27 * f_u_31_29_t_y - c_27 * f_u_31_28_t_x;
  const Scalar B_15_31 = Scalar(0.33) * t156 + Scalar(0.24) * f_u_31_26_t_x +
      s_26 * mu_u_31_27_t_x + c_26 * mu_31_27_z;
  B[478] = B[974] = B_15_31;
  const Scalar mu_u_32_27_t_x = s_27 * t139 + c_27 * mu_32_28_z;
  const Scalar f_u_32_27_t_x = s_27 * f_u_32_28_t_x + c_27 * f_u_32_29_t_y;
  const Scalar f_u_32_26_t_x = s_26 * t138 + c_26 * f_u_32_27_t_x;
  const Scalar t157 = s_27 * f_u_32_29_t_y - c_27 * f_u_32_28_t_x;
  const Scalar B_15_32 = Scalar(0.33) * t157 + Scalar(0.24) * f_u_32_26_t_x +
      s_26 * mu_u_32_27_t_x + c_26 * mu_32_27_z;
  B[479] = B[1006] = B_15_32;
  const Scalar Ic_9_xz = Ic_10_xy + Scalar(0.02) * hu_10_t_y + c_10 * t126 + Scalar(0.00507);
  const Scalar t158 = t104 + Scalar(0.08);
  const Scalar t159 = hu_12_t_x * t71 + c_9 * t158;
  const Scalar t160 = Scalar(0.389) * t159 + t90 * t71 + c_9 * Ic_9_xz;
  B[232] = B[263] = -t160;
  const Scalar Ic_3_xz = Ic_4_xy + Scalar(0.02) * hu_4_t_y + c_4 * t131 + Scalar(0.00507);
  const Scalar t161 = t100 + Scalar(0.08);
  const Scalar t162 = hu_6_t_x * t60 + c_3 * t161;
  const Scalar t163 = Scalar(0.389) * t162 + t92 * t60 + c_3 * Ic_3_xz;
  B[34] = B[65] = -t163;
  const Scalar mu_u_25_20_t_x = s_20 * t121 + c_20 * mu_25_21_z;
  const Scalar f_u_25_20_t_x = s_20 * f_u_25_21_t_x + c_20 * f_u_25_22_t_y;
  const Scalar f_u_25_19_t_x = s_19 * t120 + c_19 * f_u_25_20_t_x;
  const Scalar t164 = s_20 * f_u_25_22_t_y - c_20 * f_u_25_21_t_x;
  const Scalar t165 = Scalar(0.33) * t164 - Scalar(0.24) * f_u_25_19_t_x + s_19 * mu_u_25_20_t_x +
      c_19 * mu_25_20_z;
  B[472] = B[782] = -t165;
  const Scalar t166 = s_29 * mu_30_29_y + c_29 * t123;
  const Scalar t167 = s_29 * hu_30_t_y;
  const Scalar mu_30_28_y = Ic_29_yz - Scalar(0.004) * t167;
  const Scalar t168 = s_28 * hu_30_t_y;
  const Scalar t169 = c_29 * t168 + c_28 * t122;
  const Scalar t170 = Scalar(0.305) * t169 + s_28 * mu_30_28_y + c_28 * t166;
  B[861] = B[954] = -t170;
  const Scalar t171 = Scalar(0.004) * hu_30_t_y;
  const Scalar Ic_29_xz = c_30 * t141 + t36 + t171;
  const Scalar t172 = s_29 * Ic_29_xz - c_29 * Ic_29_yz;
  B[892] = B[923] = -t172;
  const Scalar t173 = Scalar(-0.004) * t114;
  const Scalar t174 = c_23 * t146 - t30 + t173;
  const Scalar t175 = s_22 * t174 + c_22 * t115;
  B[661] = B[692] = -t175;
  const Scalar t176 = c_21 * t114;
  const Scalar t177 = s_21 * hu_23_t_x + c_22 * t176;
  const Scalar t178 = Scalar(0.305) * t177 + s_21 * mu_u_23_22_t_x + c_21 * t152;
  const Scalar mu_u_23_20_t_y = s_20 * mu_23_21_z - c_20 * t178;
  B[598] = B[722] = mu_u_23_20_t_y;
  const Scalar f_u_25_19_t_y = s_19 * f_u_25_20_t_x - c_19 * t120;
  const Scalar mu_25_15_x = Scalar(0.24) * f_u_25_19_t_y - s_19 * mu_25_20_z +
      c_19 * mu_u_25_20_t_x;
  const Scalar mu_25_15_y = mu_u_25_20_t_y - Scalar(0.33) * f_u_25_19_t_y;
  B[440] = B[781] = s_15 * mu_25_15_x + c_15 * mu_25_15_y;
  const Scalar t179 = s_26 * f_u_31_27_t_x - c_26 * f_u_31_28_t_y;
  const Scalar t180 = Scalar(0.24) * t179 + s_26 * mu_31_27_z - c_26 * mu_u_31_27_t_x;
  const Scalar t181 = t137 - Scalar(0.33) * t179;
  B[446] = B[973] = s_15 * t180 - c_15 * t181;
  const Scalar f_u_32_26_t_y = s_26 * f_u_32_27_t_x - c_26 * t138;
  const Scalar mu_32_15_x = Scalar(0.24) * f_u_32_26_t_y + s_26 * mu_32_27_z -
      c_26 * mu_u_32_27_t_x;
  const Scalar mu_32_15_y = mu_u_32_27_t_y - Scalar(0.33) * f_u_32_26_t_y;
  B[447] = B[1005] = s_15 * mu_32_15_x - c_15 * mu_32_15_y;
  const Scalar Iu_10_t_xx = Ic_10_yy - t127;
  const Scalar t182 = t49 + t128 + Scalar(0.02175666666667);
  const Scalar Iu_9_t_d = Iu_10_t_xx + t182;
  const Scalar t183 = t103 + t68;
  const Scalar t184 = s_9 * Iu_9_t_d + Scalar(2.0) * t183 * t75;
  const Scalar t185 = s_9 * t184;
  const Scalar t186 = Scalar(0.778) * hu_10_t_y;
  B[231] = Iu_10_t_xx - t185 + t186 + Scalar(1.03820716666667);
  const Scalar Iu_4_t_xx = Ic_4_yy - t132;
  const Scalar t187 = t55 + t133 + Scalar(0.02175666666667);
  const Scalar Iu_3_t_d = Iu_4_t_xx + t187;
  const Scalar t188 = t99 + t57;
  const Scalar t189 = s_3 * Iu_3_t_d + Scalar(2.0) * t188 * t64;
  const Scalar t190 = s_3 * t189;
  const Scalar t191 = Scalar(0.778) * hu_4_t_y;
  B[33] = Iu_4_t_xx - t190 + t191 + Scalar(1.03820716666667);
  const Scalar t192 = s_3 * t161 - hu_6_t_x * t64;
  const Scalar t193 = c_2 * (Scalar(0.389) * t192 + s_3 * Ic_3_xz - t92 * t64);
  B[2] = B[64] = s_2 * t134 - t193;
  const Scalar t194 = s_9 * t158 - hu_12_t_x * t75;
  const Scalar t195 = c_8 * (Scalar(0.389) * t194 + s_9 * Ic_9_xz - t90 * t75);
  B[200] = B[262] = s_8 * t129 - t195;
  const Scalar t196 = s_19 * f_u_24_20_t_x - c_19 * f_u_24_21_t_y;
  const Scalar t197 = Scalar(0.24) * t196 - s_19 * mu_24_20_z + c_19 * mu_u_24_20_t_x;
  const Scalar t198 = t136 - Scalar(0.33) * t196;
  B[439] = B[749] = -s_15 * t197 - c_15 * t198;
  const Scalar Iu_29_t_xz = s_29 * Ic_29_yz + c_29 * Ic_29_xz;
  const Scalar t199 = t122 + Scalar(0.0328);
  const Scalar hc_29_y = hu_31_t_y + Scalar(0.8648);
  const Scalar t200 = s_29 * hc_29_y + c_29 * t199;
  const Scalar t201 = s_29 * t199 - c_29 * hc_29_y;
  const Scalar t202 = t145 + Scalar(0.004) * t200 + Scalar(0.305) * t201;
  const Scalar B_27_29 = c_28 * Iu_29_t_xz + s_28 * t202;
  B[860] = B[922] = B_27_29;
  const Scalar t203 = c_28 * hu_30_t_y;
  const Scalar t204 = s_28 * t122 - c_29 * t203;
  const Scalar t205 = Scalar(0.305) * t204 + s_28 * t166 - c_28 * mu_30_28_y;
  const Scalar t206 = s_27 * mu_30_28_z + c_27 * t205;
  B[829] = B[953] = -t206;
  const Scalar Ic_29_xx = Ic_30_yy - t142 + t144;
  const Scalar Ic_29_yy = Ic_30_zz + t143 + Scalar(0.2262745000000002);
  const Scalar Iu_29_t_d = Ic_29_xx + Ic_29_yy;
  const Scalar Ic_29_xy = Scalar(0.004) * hu_31_t_y + t123 + Scalar(0.0050592);
  const Scalar t207 = Scalar(2.0) * s_29 * Ic_29_xy - c_29 * Iu_29_t_d;
  const Scalar t208 = c_29 * t207;
  const Scalar t209 = Scalar(-0.008) * t200;
  const Scalar Ic_28_zz = Ic_29_xx + t208 + t209 + Scalar(0.2360429000000002);
  B[891] = Ic_28_zz;
  const Scalar Ic_22_xx = Ic_23_yy - t147 + t149;
  const Scalar Ic_22_yy = Ic_23_zz - t148 + Scalar(0.2262745000000002);
  const Scalar Iu_22_t_d = Ic_22_xx + Ic_22_yy;
  const Scalar Ic_22_xy = Scalar(0.004) * hu_24_t_y + mu_23_22_x + Scalar(0.0050592);
  const Scalar t210 = Scalar(2.0) * s_22 * Ic_22_xy - c_22 * Iu_22_t_d;
  const Scalar t211 = c_22 * t210;
  const Scalar hc_22_x = hu_23_t_x + Scalar(0.0328);
  const Scalar hc_22_y = hu_24_t_y + Scalar(0.8648);
  const Scalar hu_22_t_x = s_22 * hc_22_y + c_22 * hc_22_x;
  const Scalar t212 = Scalar(0.008) * hu_22_t_x;
  const Scalar B_21_21 = Ic_22_xx + t211 - t212 + Scalar(0.2360429000000002);
  B[660] = B_21_21;
  const Scalar t213 = s_22 * t115 - c_22 * t174;
  const Scalar t214 = s_22 * hc_22_x - c_22 * hc_22_y;
  const Scalar t215 = t150 + Scalar(0.004) * hu_22_t_x + Scalar(0.305) * t214;
  const Scalar t216 = c_21 * t213 - s_21 * t215;
  B[629] = B[691] = -t216;
  B[408] = B[780] = s_14 * t165 + c_14 * (s_15 * mu_25_15_y - c_15 * mu_25_15_x);
  const Scalar t217 = s_27 * t205 - c_27 * mu_30_28_z;
  const Scalar t218 = s_27 * t169 - c_27 * t167;
  const Scalar t219 = s_26 * t204 + c_26 * t218;
  const Scalar t220 = s_27 * t167 + c_27 * t169;
  const Scalar B_15_30 = Scalar(0.33) * t220 - Scalar(0.24) * t219 - s_26 * t217 - c_26 * t170;
  B[477] = B[942] = B_15_30;
  B[199] = B[230] = s_8 * t160 + c_8 * (c_9 * t184 - s_11 * t183);
  B[1] = B[32] = s_2 * t163 + c_2 * (c_3 * t189 - s_5 * t188);
  const Scalar t221 = s_21 * t213 + c_21 * t215;
  const Scalar mu_u_22_20_t_y = s_20 * t175 - c_20 * t221;
  B[597] = B[690] = mu_u_22_20_t_y;
  const Scalar mu_u_23_20_t_x = s_20 * t178 + c_20 * mu_23_21_z;
  const Scalar f_u_23_20_t_x = s_20 * t154 - c_20 * t151;
  const Scalar t222 = s_19 * t177 - c_19 * f_u_23_20_t_x;
  const Scalar t223 = s_20 * t151 + c_20 * t154;
  const Scalar t224 = Scalar(0.33) * t223 - Scalar(0.24) * t222 + s_19 * mu_u_23_20_t_x -
      c_19 * B_20_23;
  B[470] = B[718] = -t224;
  const Scalar mu_u_24_15_t_x = s_15 * t198 - c_15 * t197;
  B[407] = B[748] = -s_14 * B_15_24 - c_14 * mu_u_24_15_t_x;
  const Scalar mu_29_27_x = s_28 * Iu_29_t_xz - c_28 * t202;
  const Scalar mu_u_29_27_t_y = s_27 * t172 + c_27 * mu_29_27_x;
  B[828] = B[921] = mu_u_29_27_t_y;
  B[414] = B[972] = -s_14 * B_15_31 - c_14 * (s_15 * t181 + c_15 * t180);
  const Scalar mu_u_32_15_t_x = s_15 * mu_32_15_y + c_15 * mu_32_15_x;
  B[415] = B[1004] = -s_14 * B_15_32 - c_14 * mu_u_32_15_t_x;
  const Scalar t225 = Ic_22_xy + Scalar(0.004) * t214 - s_22 * t210 - Scalar(0.0023);
  const Scalar hc_21_x = hu_22_t_x + Scalar(0.0032);
  const Scalar t226 = t153 - c_21 * hc_21_x;
  const Scalar B_20_21 = Scalar(0.305) * t226 + s_21 * t175 - c_21 * t225;
  B[628] = B[659] = B_20_21;
  const Scalar t227 = Ic_29_xy + Scalar(0.004) * t201 - s_29 * t207 - Scalar(0.0023);
  const Scalar t228 = t200 + Scalar(0.0032);
  const Scalar t229 = t168 + c_28 * t228;
  const Scalar t230 = Scalar(0.305) * t229 - s_28 * t172 + c_28 * t227;
  B[859] = B[890] = -t230;
  const Scalar t231 = s_20 * t221 + c_20 * t175;
  const Scalar t232 = s_21 * t214;
  const Scalar f_u_22_20_t_x = s_20 * t232 + c_20 * hu_22_t_x;
  const Scalar t233 = c_21 * t214;
  const Scalar t234 = s_19 * t233 - c_19 * f_u_22_20_t_x;
  const Scalar f_u_22_20_t_y = s_20 * hu_22_t_x - c_20 * t232;
  const Scalar mu_22_15_z = Scalar(0.33) * f_u_22_20_t_y + Scalar(0.24) * t234 - s_19 * t231 -
      c_19 * t216;
  B[469] = B[686] = mu_22_15_z;
  const Scalar t235 = s_19 * f_u_23_20_t_x + c_19 * t177;
  const Scalar t236 = Scalar(0.24) * t235 - s_19 * B_20_23 - c_19 * mu_u_23_20_t_x;
  const Scalar mu_23_15_y = mu_u_23_20_t_y + Scalar(0.33) * t235;
  B[438] = B[717] = c_15 * mu_23_15_y - s_15 * t236;
  const Scalar mu_u_29_27_t_x = s_27 * mu_29_27_x - c_27 * t172;
  const Scalar t237 = s_28 * t201;
  const Scalar t238 = s_27 * t237 + c_27 * t200;
  const Scalar t239 = c_28 * t201;
  const Scalar f_u_29_26_t_x = s_26 * t239 - c_26 * t238;
  const Scalar f_u_29_27_t_y = s_27 * t200 - c_27 * t237;
  const Scalar mu_29_15_z = Scalar(0.33) * f_u_29_27_t_y - Scalar(0.24) * f_u_29_26_t_x +
      s_26 * mu_u_29_27_t_x + c_26 * B_27_29;
  B[476] = B[910] = mu_29_15_z;
  const Scalar f_u_30_26_t_y = s_26 * t218 - c_26 * t204;
  const Scalar mu_30_15_x = Scalar(0.24) * f_u_30_26_t_y + s_26 * t170 - c_26 * t217;
  const Scalar t240 = t206 + Scalar(0.33) * f_u_30_26_t_y;
  B[445] = B[941] = -s_15 * mu_30_15_x - c_15 * t240;
  B[406] = B[716] = s_14 * t224 + c_14 * (s_15 * mu_23_15_y + c_15 * t236);
  const Scalar t241 = t182 - t185 - t186;
  const Scalar t242 = s_8 * (s_8 * (t129 - t241 + Scalar(1.03624716666667)) - Scalar(2.0) * t195);
  B[198] = Scalar(1.04016716666667) - t241 - t242;
  const Scalar t243 = t187 - t190 - t191;
  const Scalar t244 = s_2 * (s_2 * (t134 - t243 + Scalar(1.03624716666667)) - Scalar(2.0) * t193);
  B[0] = Scalar(1.04016716666667) - t243 - t244;
  const Scalar t245 = s_21 * hc_21_x + t176;
  const Scalar t246 = Scalar(0.305) * t245 + s_21 * t225 + c_21 * t175;
  const Scalar t247 = c_20 * t246;
  const Scalar t248 = t247 + s_20 * B_21_21;
  B[596] = B[658] = -t248;
  const Scalar t249 = s_28 * t228 - t203;
  const Scalar t250 = Scalar(0.305) * t249 + s_28 * t227 + c_28 * t172;
  const Scalar t251 = c_27 * t250;
  const Scalar t252 = t251 + s_27 * Ic_28_zz;
  B[827] = B[889] = -t252;
  const Scalar t253 = s_26 * t238 + c_26 * t239;
  const Scalar t254 = Scalar(0.24) * t253 + s_26 * B_27_29 - c_26 * mu_u_29_27_t_x;
  const Scalar mu_29_15_y = mu_u_29_27_t_y + Scalar(0.33) * t253;
  B[444] = B[909] = s_15 * t254 + c_15 * mu_29_15_y;
  B[413] = B[940] = -s_14 * B_15_30 - c_14 * (s_15 * t240 - c_15 * mu_30_15_x);
  const Scalar Iu_29_t_xx = Ic_29_yy + t208;
  const Scalar t255 = t145 - t209 + Scalar(0.2282085000000002);
  const Scalar Iu_28_t_d = Iu_29_t_xx - t255;
  const Scalar Ic_28_xy = t171 - Iu_29_t_xz;
  const Scalar Iu_28_t_g = s_28 * Iu_28_t_d + Scalar(2.0) * c_28 * Ic_28_xy;
  const Scalar t256 = s_28 * Iu_28_t_g;
  const Scalar t257 = Scalar(-0.61) * t201;
  const Scalar t258 = Iu_29_t_xx - t256 - t257 - Scalar(0.7079407000000002);
  B[858] = -t258;
  const Scalar Iu_22_t_xx = Ic_22_yy + t211;
  const Scalar t259 = t150 + t212 + Scalar(0.2282085000000002);
  const Scalar Iu_21_t_d = Iu_22_t_xx - t259;
  const Scalar t260 = t173 + t213;
  const Scalar Iu_21_t_g = s_21 * Iu_21_t_d + Scalar(2.0) * c_21 * t260;
  const Scalar t261 = s_21 * Iu_21_t_g;
  const Scalar t262 = Scalar(-0.61) * t214;
  const Scalar t263 = Iu_22_t_xx - t261 - t262 - Scalar(0.7079407000000002);
  B[627] = -t263;
  const Scalar t264 = s_20 * t246 - c_20 * B_21_21;
  const Scalar t265 = c_19 * t226;
  const Scalar f_u_21_19_t_x = s_19 * t245 - s_20 * t265;
  const Scalar mu_21_15_z = Scalar(0.24) * f_u_21_19_t_x - s_19 * t264 + c_19 * B_20_21 -
      Scalar(0.33) * c_20 * t226;
  B[468] = B[654] = mu_21_15_z;
  const Scalar t266 = s_19 * f_u_22_20_t_x + c_19 * t233;
  const Scalar t267 = Scalar(0.24) * t266 + s_19 * t216 - c_19 * t231;
  const Scalar t268 = mu_u_22_20_t_y + Scalar(0.33) * t266;
  B[437] = B[685] = c_15 * t268 - s_15 * t267;
  const Scalar Iu_28_t_xy = Ic_28_xy - c_28 * Iu_28_t_g;
  const Scalar Iu_27_t_yz = s_27 * t230 + c_27 * Iu_28_t_xy;
  B[826] = B[857] = Iu_27_t_yz;
  const Scalar t269 = s_27 * t250 - c_27 * Ic_28_zz;
  const Scalar t270 = c_26 * t229;
  const Scalar t271 = s_26 * t249 + s_27 * t270;
  const Scalar t272 = Scalar(0.24) * t271 + s_26 * t269 + c_26 * t230 - Scalar(0.33) * c_27 * t229;
  B[475] = B[878] = -t272;
  const Scalar t273 = t260 - c_21 * Iu_21_t_g;
  const Scalar t274 = s_20 * B_20_21 - c_20 * t273;
  B[595] = B[626] = -t274;
  B[405] = B[684] = c_14 * (s_15 * t268 + c_15 * t267) - s_14 * mu_22_15_z;
  const Scalar mu_u_29_15_t_x = s_15 * mu_29_15_y - c_15 * t254;
  B[412] = B[908] = c_14 * mu_u_29_15_t_x - s_14 * mu_29_15_z;
  const Scalar t275 = s_19 * t226;
  const Scalar t276 = s_20 * t275 + c_19 * t245;
  const Scalar t277 = Scalar(0.24) * t276 - s_19 * B_20_21 - c_19 * t264;
  const Scalar t278 = t248 - Scalar(0.33) * t276;
  B[436] = B[653] = -s_15 * t277 - c_15 * t278;
  const Scalar t279 = s_26 * t229;
  const Scalar f_u_28_26_t_y = s_27 * t279 - c_26 * t249;
  const Scalar mu_28_15_x = Scalar(0.24) * f_u_28_26_t_y + s_26 * t230 - c_26 * t269;
  const Scalar t280 = t252 + Scalar(0.33) * f_u_28_26_t_y;
  B[443] = B[877] = -s_15 * mu_28_15_x - c_15 * t280;
  const Scalar t281 = s_20 * t273 + c_20 * B_20_21;
  const Scalar t282 = s_19 * t281;
  const Scalar t283 = t214 - Scalar(1.661);
  const Scalar t284 = s_20 * t283 + c_20 * t245;
  const Scalar t285 = t263 - Scalar(0.24) * t284;
  const Scalar hu_20_t_x = s_20 * t245 - c_20 * t283;
  const Scalar mu_20_15_z = Scalar(0.33) * hu_20_t_x - t282 + c_19 * t285;
  B[467] = B[622] = -mu_20_15_z;
  const Scalar Iu_27_t_xz = s_27 * Iu_28_t_xy - c_27 * t230;
  const Scalar t286 = s_26 * Iu_27_t_xz;
  const Scalar t287 = t201 - Scalar(1.661);
  const Scalar t288 = s_27 * t287 + c_27 * t249;
  const Scalar t289 = t258 + Scalar(0.24) * t288;
  const Scalar hu_27_t_x = s_27 * t249 - c_27 * t287;
  const Scalar mu_27_15_z = Scalar(0.33) * hu_27_t_x - t286 + c_26 * t289;
  B[474] = B[846] = -mu_27_15_z;
  B[411] = B[876] = s_14 * t272 - c_14 * (s_15 * t280 - c_15 * mu_28_15_x);
  const Scalar t290 = t255 + t256 - t257;
  const Scalar Ic_27_yy = Ic_28_zz - Scalar(0.7059807000000002);
  const Scalar t291 = s_27 * (t290 + Ic_27_yy) + Scalar(2.0) * t251;
  const Scalar t292 = s_27 * t291;
  const Scalar t293 = t290 - t292 - Scalar(0.7099007000000002);
  B[825] = -t293;
  const Scalar t294 = t259 + t261 - t262;
  const Scalar t295 = B_21_21 - Scalar(0.7059807000000002);
  const Scalar t296 = s_20 * (t294 + t295) + Scalar(2.0) * t247;
  const Scalar t297 = s_20 * t296;
  const Scalar t298 = t294 - t297 - Scalar(0.7099007000000002);
  B[594] = -t298;
  const Scalar mu_u_21_15_t_x = s_15 * t278 - c_15 * t277;
  B[404] = B[652] = -s_14 * mu_21_15_z - c_14 * mu_u_21_15_t_x;
  const Scalar t299 = t250 - c_27 * t291;
  const Scalar t300 = s_26 * hu_27_t_x + t270;
  const Scalar B_15_26 = Scalar(0.24) * t300 + s_26 * t299 + c_26 * Iu_27_t_yz;
  B[473] = B[814] = B_15_26;
  const Scalar t301 = c_19 * t281 + s_19 * t285;
  const Scalar t302 = t274 + Scalar(0.33) * s_19 * t284;
  B[435] = B[621] = -s_15 * t301 - c_15 * t302;
  const Scalar t303 = c_26 * Iu_27_t_xz + s_26 * t289;
  const Scalar mu_27_15_y = Iu_27_t_yz - Scalar(0.33) * s_26 * t288;
  B[442] = B[845] = c_15 * mu_27_15_y - s_15 * t303;
  const Scalar t304 = t246 - c_20 * t296;
  const Scalar hu_19_t_y = s_19 * hu_20_t_x - t265;
  const Scalar t305 = Scalar(0.24) * hu_19_t_y - s_19 * t304 + c_19 * t274;
  B[466] = B[590] = -t305;
  B[403] = B[620] = s_14 * mu_20_15_z - c_14 * (s_15 * t302 - c_15 * t301);
  B[410] = B[844] = s_14 * mu_27_15_z + c_14 * (s_15 * mu_27_15_y + c_15 * t303);
  const Scalar hu_19_t_x = t275 + c_19 * hu_20_t_x;
  const Scalar t306 = Scalar(0.24) * hu_19_t_x - s_19 * t274 - c_19 * t304;
  const Scalar t307 = t298 + Scalar(0.33) * hu_19_t_x;
  B[434] = B[589] = s_15 * t306 - c_15 * t307;
  const Scalar t308 = t279 - c_26 * hu_27_t_x;
  const Scalar t309 = Scalar(0.24) * t308 + s_26 * Iu_27_t_yz - c_26 * t299;
  const Scalar t310 = t293 - Scalar(0.33) * t308;
  B[441] = B[813] = s_15 * t309 - c_15 * t310;
  const Scalar t311 = t295 - t297;
  const Scalar t312 = t263 + Scalar(0.7079407000000002);
  const Scalar t313 = Scalar(2.0) * t282 - c_19 * (t311 + t312);
  const Scalar Iu_27_t_xx = Ic_27_yy - t292;
  const Scalar t314 = t258 + Scalar(0.7079407000000002);
  const Scalar Iu_26_t_d = Iu_27_t_xx + t314;
  const Scalar t315 = Scalar(2.0) * t286 - c_26 * Iu_26_t_d;
  const Scalar t316 = c_19 * t313 + c_26 * t315;
  const Scalar t317 = Scalar(0.66) * (t308 - hu_19_t_x) + Scalar(0.906) * t37;
  const Scalar t318 = Scalar(-0.48) * (t288 - t284);
  const Scalar Iu_17_t_xx = t25 + Scalar(0.0002);
  const Scalar Iu_16_t_d = t9 + Iu_17_t_xx;
  const Scalar Iu_16_t_g = Scalar(2.0) * t40 + c_16 * Iu_16_t_d;
  const Scalar t319 = c_16 * Iu_16_t_g;
  const Scalar Ic_15_zz = Iu_27_t_xx + t311 + Iu_17_t_xx + t316 + t318 + t317 - t319 +
      Scalar(5.512820899999667);
  B[462] = Ic_15_zz;
  const Scalar mu_u_19_15_t_x = s_15 * t307 + c_15 * t306;
  B[402] = B[588] = s_14 * t305 - c_14 * mu_u_19_15_t_x;
  B[409] = B[812] = -s_14 * B_15_26 - c_14 * (s_15 * t310 + c_15 * t309);
  const Scalar t320 = Iu_27_t_xz + t281 + Scalar(0.33) * (t300 + hu_19_t_y) - t94 + c_17 * t95 -
      s_19 * t313 - s_26 * t315 - Scalar(0.043998);
  const Scalar t321 = Scalar(0.003) * t116 - t305 + B_15_26 - s_16 * Iu_16_t_g + s_17 * Iu_18_t_xy;
  const Scalar Iu_15_t_yz = s_15 * t320 - c_15 * t321;
  B[430] = B[461] = -Iu_15_t_yz;
  const Scalar t322 = c_14 * (s_15 * t321 + c_15 * t320);
  B[398] = B[460] = t322 - s_14 * Ic_15_zz;
  const Scalar t323 = Scalar(0.006) * hu_16_t_y;
  const Scalar t324 = t314 + t312 - Ic_16_zz + t316 - t318 + t323;
  const Scalar t325 = t293 + t298 + t9 + t323 - t317 - t319 - Scalar(0.5912714333326666);
  const Scalar t326 = Scalar(0.33) * (t288 + t284) - t117 - t306 - t309;
  const Scalar t327 = Scalar(2.0) * s_15 * t326 - c_15 * (t324 - t325);
  const Scalar t328 = c_15 * t327;
  B[429] = Scalar(2.5075600666670006) - t324 - t328;
  B[397] = B[428] = s_14 * Iu_15_t_yz + c_14 * (t326 - s_15 * t327);
  const Scalar t329 = t325 - t328;
  const Scalar t330 = s_14 * (s_14 * (Ic_15_zz + t329 - Scalar(2.5051100666670005)) -
      Scalar(2.0) * t322);
  B[396] = t330 - t329 + Scalar(2.5107600666670002);
  B[6] = B[7] = B[8] = B[9] = B[10] = B[11] = B[12] = B[13] = Scalar(0.0);
  B[14] = B[15] = B[16] = B[17] = B[18] = B[19] = B[20] = B[21] = Scalar(0.0);
  B[22] = B[23] = B[24] = B[25] = B[26] = B[27] = B[28] = B[29] = Scalar(0.0);
  B[30] = B[31] = B[38] = B[39] = B[40] = B[41] = B[42] = B[43] = Scalar(0.0);
  B[44] = B[45] = B[46] = B[47] = B[48] = B[49] = B[50] = B[51] = Scalar(0.0);
  B[52] = B[53] = B[54] = B[55] = B[56] = B[57] = B[58] = B[59] = Scalar(0.0);
  B[60] = B[61] = B[62] = B[63] = B[70] = B[71] = B[72] = B[73] = Scalar(0.0);
  B[74] = B[75] = B[76] = B[77] = B[78] = B[79] = B[80] = B[81] = Scalar(0.0);
  B[82] = B[83] = B[84] = B[85] = B[86] = B[87] = B[88] = B[89] = Scalar(0.0);
  B[90] = B[91] = B[92] = B[93] = B[94] = B[95] = B[102] = B[103] = Scalar(0.0);
  B[104] = B[105] = B[106] = B[107] = B[108] = B[109] = B[110] = B[111] = Scalar(0.0);
  B[112] = B[113] = B[114] = B[115] = B[116] = B[117] = B[118] = B[119] = Scalar(0.0);
  B[120] = B[121] = B[122] = B[123] = B[124] = B[125] = B[126] = B[127] = Scalar(0.0);
  B[133] = B[134] = B[135] = B[136] = B[137] = B[138] = B[139] = B[140] = Scalar(0.0);
  B[141] = B[142] = B[143] = B[144] = B[145] = B[146] = B[147] = B[148] = Scalar(0.0);
  B[149] = B[150] = B[151] = B[152] = B[153] = B[154] = B[155] = B[156] = Scalar(0.0);
  B[157] = B[158] = B[159] = B[164] = B[166] = B[167] = B[168] = B[169] = Scalar(0.0);
  B[170] = B[171] = B[172] = B[173] = B[174] = B[175] = B[176] = B[177] = Scalar(0.0);
  B[178] = B[179] = B[180] = B[181] = B[182] = B[183] = B[184] = B[185] = Scalar(0.0);
  B[186] = B[187] = B[188] = B[189] = B[190] = B[191] = B[192] = B[193] = Scalar(0.0);
  B[194] = B[195] = B[196] = B[197] = B[204] = B[205] = B[206] = B[207] = Scalar(0.0);
  B[208] = B[209] = B[210] = B[211] = B[212] = B[213] = B[214] = B[215] = Scalar(0.0);
  B[216] = B[217] = B[218] = B[219] = B[220] = B[221] = B[222] = B[223] = Scalar(0.0);
  B[224] = B[225] = B[226] = B[227] = B[228] = B[229] = B[236] = B[237] = Scalar(0.0);
  B[238] = B[239] = B[240] = B[241] = B[242] = B[243] = B[244] = B[245] = Scalar(0.0);
  B[246] = B[247] = B[248] = B[249] = B[250] = B[251] = B[252] = B[253] = Scalar(0.0);
  B[254] = B[255] = B[256] = B[257] = B[258] = B[259] = B[260] = B[261] = Scalar(0.0);
  B[268] = B[269] = B[270] = B[271] = B[272] = B[273] = B[274] = B[275] = Scalar(0.0);
  B[276] = B[277] = B[278] = B[279] = B[280] = B[281] = B[282] = B[283] = Scalar(0.0);
  B[284] = B[285] = B[286] = B[287] = B[288] = B[289] = B[290] = B[291] = Scalar(0.0);
  B[292] = B[293] = B[300] = B[301] = B[302] = B[303] = B[304] = B[305] = Scalar(0.0);
  B[306] = B[307] = B[308] = B[309] = B[310] = B[311] = B[312] = B[313] = Scalar(0.0);
  B[314] = B[315] = B[316] = B[317] = B[318] = B[319] = B[320] = B[321] = Scalar(0.0);
  B[322] = B[323] = B[324] = B[325] = B[331] = B[332] = B[333] = B[334] = Scalar(0.0);
  B[335] = B[336] = B[337] = B[338] = B[339] = B[340] = B[341] = B[342] = Scalar(0.0);
  B[343] = B[344] = B[345] = B[346] = B[347] = B[348] = B[349] = B[350] = Scalar(0.0);
  B[351] = B[352] = B[353] = B[354] = B[355] = B[356] = B[357] = B[362] = Scalar(0.0);
  B[364] = B[365] = B[366] = B[367] = B[368] = B[369] = B[370] = B[371] = Scalar(0.0);
  B[372] = B[373] = B[374] = B[375] = B[376] = B[377] = B[378] = B[379] = Scalar(0.0);
  B[380] = B[381] = B[382] = B[383] = B[384] = B[385] = B[386] = B[387] = Scalar(0.0);
  B[388] = B[389] = B[390] = B[391] = B[392] = B[393] = B[394] = B[395] = Scalar(0.0);
  B[416] = B[417] = B[418] = B[419] = B[420] = B[421] = B[422] = B[423] = Scalar(0.0);
  B[424] = B[425] = B[426] = B[427] = B[448] = B[449] = B[450] = B[451] = Scalar(0.0);
  B[452] = B[453] = B[454] = B[455] = B[456] = B[457] = B[458] = B[459] = Scalar(0.0);
  B[480] = B[481] = B[482] = B[483] = B[484] = B[485] = B[486] = B[487] = Scalar(0.0);
  B[488] = B[489] = B[490] = B[491] = B[498] = B[499] = B[500] = B[501] = Scalar(0.0);
  B[502] = B[503] = B[504] = B[505] = B[506] = B[507] = B[508] = B[509] = Scalar(0.0);
  B[510] = B[511] = B[512] = B[513] = B[514] = B[515] = B[516] = B[517] = Scalar(0.0);
  B[518] = B[519] = B[520] = B[521] = B[522] = B[523] = B[529] = B[530] = Scalar(0.0);
  B[531] = B[532] = B[533] = B[534] = B[535] = B[536] = B[537] = B[538] = Scalar(0.0);
  B[539] = B[540] = B[541] = B[542] = B[543] = B[544] = B[545] = B[546] = Scalar(0.0);
  B[547] = B[548] = B[549] = B[550] = B[551] = B[552] = B[553] = B[554] = Scalar(0.0);
  B[555] = B[560] = B[562] = B[563] = B[564] = B[565] = B[566] = B[567] = Scalar(0.0);
  B[568] = B[569] = B[570] = B[571] = B[572] = B[573] = B[574] = B[575] = Scalar(0.0);
  B[576] = B[577] = B[578] = B[579] = B[580] = B[581] = B[582] = B[583] = Scalar(0.0);
  B[584] = B[585] = B[586] = B[587] = B[591] = B[592] = B[593] = B[601] = Scalar(0.0);
  B[602] = B[603] = B[604] = B[605] = B[606] = B[607] = B[608] = B[609] = Scalar(0.0);
  B[610] = B[611] = B[612] = B[613] = B[614] = B[615] = B[616] = B[617] = Scalar(0.0);
  B[618] = B[619] = B[623] = B[624] = B[625] = B[633] = B[634] = B[635] = Scalar(0.0);
  B[636] = B[637] = B[638] = B[639] = B[640] = B[641] = B[642] = B[643] = Scalar(0.0);
  B[644] = B[645] = B[646] = B[647] = B[648] = B[649] = B[650] = B[651] = Scalar(0.0);
  B[655] = B[656] = B[657] = B[665] = B[666] = B[667] = B[668] = B[669] = Scalar(0.0);
  B[670] = B[671] = B[672] = B[673] = B[674] = B[675] = B[676] = B[677] = Scalar(0.0);
  B[678] = B[679] = B[680] = B[681] = B[682] = B[683] = B[687] = B[688] = Scalar(0.0);
  B[689] = B[697] = B[698] = B[699] = B[700] = B[701] = B[702] = B[703] = Scalar(0.0);
  B[704] = B[705] = B[706] = B[707] = B[708] = B[709] = B[710] = B[711] = Scalar(0.0);
  B[712] = B[713] = B[714] = B[715] = B[719] = B[720] = B[721] = B[729] = Scalar(0.0);
  B[730] = B[731] = B[732] = B[733] = B[734] = B[735] = B[736] = B[737] = Scalar(0.0);
  B[738] = B[739] = B[740] = B[741] = B[742] = B[743] = B[744] = B[745] = Scalar(0.0);
  B[746] = B[747] = B[751] = B[752] = B[753] = B[761] = B[762] = B[763] = Scalar(0.0);
  B[764] = B[765] = B[766] = B[767] = B[768] = B[769] = B[770] = B[771] = Scalar(0.0);
  B[772] = B[773] = B[774] = B[775] = B[776] = B[777] = B[778] = B[779] = Scalar(0.0);
  B[783] = B[784] = B[785] = B[793] = B[794] = B[795] = B[796] = B[797] = Scalar(0.0);
  B[798] = B[799] = B[800] = B[801] = B[802] = B[803] = B[804] = B[805] = Scalar(0.0);
  B[806] = B[807] = B[808] = B[809] = B[810] = B[811] = B[815] = B[816] = Scalar(0.0);
  B[817] = B[818] = B[819] = B[820] = B[821] = B[822] = B[823] = B[824] = Scalar(0.0);
  B[832] = B[833] = B[834] = B[835] = B[836] = B[837] = B[838] = B[839] = Scalar(0.0);
  B[840] = B[841] = B[842] = B[843] = B[847] = B[848] = B[849] = B[850] = Scalar(0.0);
  B[851] = B[852] = B[853] = B[854] = B[855] = B[856] = B[864] = B[865] = Scalar(0.0);
  B[866] = B[867] = B[868] = B[869] = B[870] = B[871] = B[872] = B[873] = Scalar(0.0);
  B[874] = B[875] = B[879] = B[880] = B[881] = B[882] = B[883] = B[884] = Scalar(0.0);
  B[885] = B[886] = B[887] = B[888] = B[896] = B[897] = B[898] = B[899] = Scalar(0.0);
  B[900] = B[901] = B[902] = B[903] = B[904] = B[905] = B[906] = B[907] = Scalar(0.0);
  B[911] = B[912] = B[913] = B[914] = B[915] = B[916] = B[917] = B[918] = Scalar(0.0);
  B[919] = B[920] = B[928] = B[929] = B[930] = B[931] = B[932] = B[933] = Scalar(0.0);
  B[934] = B[935] = B[936] = B[937] = B[938] = B[939] = B[943] = B[944] = Scalar(0.0);
  B[945] = B[946] = B[947] = B[948] = B[949] = B[950] = B[951] = B[952] = Scalar(0.0);
  B[960] = B[961] = B[962] = B[963] = B[964] = B[965] = B[966] = B[967] = Scalar(0.0);
  B[968] = B[969] = B[970] = B[971] = B[975] = B[976] = B[977] = B[978] = Scalar(0.0);
  B[979] = B[980] = B[981] = B[982] = B[983] = B[984] = B[992] = B[993] = Scalar(0.0);
  B[994] = B[995] = B[996] = B[997] = B[998] = B[999] = B[1000] = B[1001] = Scalar(0.0);
  B[1002] = B[1003] = B[1007] = B[1008] = B[1009] = B[1010] = B[1011] = B[1012] = Scalar(0.0);
  B[1013] = B[1014] = B[1015] = B[1016] = Scalar(0.0);
  B[792] = B[1023] = Scalar(0.0014129000000002);
  B[561] = Scalar(0.03408);
  B[165] = B[363] = Scalar(0.01431666666667);
}

// gravity torques g(q) (7.39).
//   q[32]  in   joint positions, rad or m
//   g[32]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11], q[13..31]. Operations: 275 mul, 147 add, 62 sin/cos.
template <class Scalar>
inline void gravity(const Scalar* q, Scalar* g) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6],
      q_8 = q[7], q_9 = q[8], q_10 = q[9], q_11 = q[10], q_12 = q[11], q_14 = q[13], q_15 = q[14],
      q_16 = q[15], q_17 = q[16], q_18 = q[17], q_19 = q[18], q_20 = q[19], q_21 = q[20],
      q_22 = q[21], q_23 = q[22], q_24 = q[23], q_25 = q[24], q_26 = q[25], q_27 = q[26],
      q_28 = q[27], q_29 = q[28], q_30 = q[29], q_31 = q[30], q_32 = q[31];
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
  const Scalar s_14 = sin(q_14), c_14 = cos(q_14);
  const Scalar s_15 = sin(q_15), c_15 = cos(q_15);
  const Scalar s_16 = sin(q_16), c_16 = cos(q_16);
  const Scalar s_17 = sin(q_17), c_17 = cos(q_17);
  const Scalar s_18 = sin(q_18), c_18 = cos(q_18);
  const Scalar s_19 = sin(q_19), c_19 = cos(q_19);
  const Scalar s_20 = sin(q_20), c_20 = cos(q_20);
  const Scalar s_21 = sin(q_21), c_21 = cos(q_21);
  const Scalar s_22 = sin(q_22), c_22 = cos(q_22);
  const Scalar s_23 = sin(q_23), c_23 = cos(q_23);
  const Scalar s_24 = sin(q_24), c_24 = cos(q_24);
  const Scalar s_25 = sin(q_25), c_25 = cos(q_25);
  const Scalar s_26 = sin(q_26), c_26 = cos(q_26);
  const Scalar s_27 = sin(q_27), c_27 = cos(q_27);
  const Scalar s_28 = sin(q_28), c_28 = cos(q_28);
  const Scalar s_29 = sin(q_29), c_29 = cos(q_29);
  const Scalar s_30 = sin(q_30), c_30 = cos(q_30);
  const Scalar s_31 = sin(q_31), c_31 = cos(q_31);
  const Scalar s_32 = sin(q_32), c_32 = cos(q_32);
  const Scalar t1 = Scalar(9.81) * c_14;
  const Scalar t2 = s_15 * t1;
  const Scalar t3 = Scalar(9.81) * s_14;
  const Scalar ddp_16_x = s_16 * t3 + c_16 * t2;
  const Scalar t4 = c_15 * t1;
  const Scalar t5 = s_17 * ddp_16_x - c_17 * t4;
  const Scalar t6 = s_16 * t2 - c_16 * t3;
  const Scalar ddp_18_y = s_18 * t6 - c_18 * t5;
  const Scalar g_18 = Scalar(0.22) * (s_18 * t5 + c_18 * t6) - Scalar(0.02) * ddp_18_y;
  g[17] = g_18;
  const Scalar ddp_17_y = s_17 * t4 + c_17 * ddp_16_x;
  const Scalar t7 = Scalar(0.02) * ddp_17_y;
  const Scalar t8 = Scalar(0.22) * ddp_17_y;
  const Scalar g_17 = s_18 * t7 - c_18 * t8;
  g[16] = g_17;
  const Scalar mu_u_18_t_x = s_18 * t8 + c_18 * t7;
  const Scalar mu_u_17_t_y = s_17 * g_18 + c_17 * mu_u_18_t_x;
  g[15] = mu_u_17_t_y;
  const Scalar t9 = Scalar(9.81) * c_7;
  const Scalar t10 = s_8 * t9;
  const Scalar t11 = Scalar(9.81) * s_7;
  const Scalar t12 = s_9 * t10 - c_9 * t11;
  const Scalar t13 = c_8 * t9;
  const Scalar ddp_10_x = s_10 * t12 + c_10 * t13;
  const Scalar ddp_9_y = s_9 * t11 + c_9 * t10;
  const Scalar ddp_11_y = s_11 * ddp_10_x + c_11 * ddp_9_y;
  const Scalar t14 = Scalar(0.045) * ddp_11_y;
  const Scalar t15 = Scalar(0.105) * ddp_11_y;
  const Scalar mu_u_12_t_y = s_12 * t14 + c_12 * t15;
  g[10] = mu_u_12_t_y;
  const Scalar t16 = Scalar(9.81) * c_1;
  const Scalar t17 = s_2 * t16;
  const Scalar t18 = Scalar(9.81) * s_1;
  const Scalar t19 = s_3 * t17 - c_3 * t18;
  const Scalar t20 = c_2 * t16;
  const Scalar ddp_4_x = s_4 * t19 + c_4 * t20;
  const Scalar ddp_3_y = s_3 * t18 + c_3 * t17;
  const Scalar ddp_5_y = s_5 * ddp_4_x + c_5 * ddp_3_y;
  const Scalar t21 = Scalar(0.045) * ddp_5_y;
  const Scalar t22 = Scalar(0.105) * ddp_5_y;
  const Scalar mu_u_6_t_y = s_6 * t21 + c_6 * t22;
  g[4] = mu_u_6_t_y;
  const Scalar t23 = s_5 * ddp_3_y - c_5 * ddp_4_x;
  const Scalar ddp_4_y = s_4 * t20 - c_4 * t19;
  const Scalar t24 = s_6 * t23 - c_6 * ddp_4_y;
  const Scalar t25 = Scalar(0.105) * t24 - Scalar(0.045) * (s_6 * ddp_4_y + c_6 * t23);
  g[5] = -t25;
  const Scalar t26 = s_11 * ddp_9_y - c_11 * ddp_10_x;
  const Scalar ddp_10_y = s_10 * t13 - c_10 * t12;
  const Scalar t27 = s_12 * t26 - c_12 * ddp_10_y;
  const Scalar t28 = Scalar(0.105) * t27 - Scalar(0.045) * (s_12 * ddp_10_y + c_12 * t26);
  g[11] = -t28;
  const Scalar t29 = s_12 * t15 - c_12 * t14;
  const Scalar mu_10_z = Scalar(0.22) * ddp_10_x - Scalar(1.3725) * ddp_10_y - s_11 * t29 +
      c_11 * t28;
  g[9] = -mu_10_z;
  const Scalar t30 = s_6 * t22 - c_6 * t21;
  const Scalar mu_4_z = Scalar(0.22) * ddp_4_x - Scalar(1.3725) * ddp_4_y - s_5 * t30 + c_5 * t25;
  g[3] = -mu_4_z;
  const Scalar mu_10_x = Scalar(0.22) * ddp_9_y - s_11 * t28 - c_11 * t29;
  const Scalar mu_10_y = Scalar(1.3725) * ddp_9_y + mu_u_12_t_y;
  const Scalar mu_9_z = Scalar(0.08) * ddp_9_y + s_10 * mu_10_y - c_10 * mu_10_x;
  g[8] = -mu_9_z;
  const Scalar mu_4_x = Scalar(0.22) * ddp_3_y - s_5 * t25 - c_5 * t30;
  const Scalar mu_4_y = Scalar(1.3725) * ddp_3_y + mu_u_6_t_y;
  const Scalar mu_3_z = Scalar(0.08) * ddp_3_y + s_4 * mu_4_y - c_4 * mu_4_x;
  g[2] = -mu_3_z;
  const Scalar t31 = s_19 * t3 - c_19 * t4;
  const Scalar t32 = s_20 * t31 - c_20 * t2;
  const Scalar ddp_19_y = s_19 * t4 + c_19 * t3;
  const Scalar ddp_21_x = s_21 * t32 + c_21 * ddp_19_y;
  const Scalar t33 = s_20 * t2 + c_20 * t31;
  const Scalar t34 = s_22 * t33 - c_22 * ddp_21_x;
  const Scalar ddp_21_y = s_21 * ddp_19_y - c_21 * t32;
  const Scalar t35 = s_23 * t34 - c_23 * ddp_21_y;
  const Scalar t36 = s_22 * ddp_21_x + c_22 * t33;
  const Scalar t37 = s_24 * t36 + c_24 * t35;
  const Scalar t38 = s_23 * ddp_21_y + c_23 * t34;
  const Scalar ddp_25_x = s_25 * t37 - c_25 * t38;
  const Scalar N_25_z = Scalar(0.0094) * ddp_25_x;
  g[24] = N_25_z;
  const Scalar t39 = s_26 * t3 - c_26 * t4;
  const Scalar t40 = s_27 * t39 - c_27 * t2;
  const Scalar ddp_26_y = s_26 * t4 + c_26 * t3;
  const Scalar ddp_28_x = s_28 * t40 + c_28 * ddp_26_y;
  const Scalar t41 = s_27 * t2 + c_27 * t39;
  const Scalar t42 = s_29 * t41 - c_29 * ddp_28_x;
  const Scalar ddp_28_y = s_28 * ddp_26_y - c_28 * t40;
  const Scalar t43 = s_30 * t42 - c_30 * ddp_28_y;
  const Scalar t44 = s_29 * ddp_28_x + c_29 * t41;
  const Scalar t45 = s_31 * t44 + c_31 * t43;
  const Scalar t46 = s_30 * ddp_28_y + c_30 * t42;
  const Scalar ddp_32_x = s_32 * t45 - c_32 * t46;
  g[31] = Scalar(-0.0094) * ddp_32_x;
  const Scalar mu_u_10_t_x = s_10 * mu_10_x + c_10 * mu_10_y;
  const Scalar t47 = mu_10_z - Scalar(0.7848) * c_7 * c_8;
  g[7] = s_9 * t47 + c_9 * mu_u_10_t_x + Scalar(27.463095) * c_7 * s_8;
  const Scalar mu_u_4_t_x = s_4 * mu_4_x + c_4 * mu_4_y;
  const Scalar t48 = mu_4_z - Scalar(0.7848) * c_1 * c_2;
  g[1] = s_3 * t48 + c_3 * mu_u_4_t_x + Scalar(27.463095) * c_1 * s_2;
  const Scalar ddp_31_y = s_31 * t43 - c_31 * t44;
  const Scalar t49 = Scalar(0.0094) * ddp_31_y;
  const Scalar t50 = Scalar(0.1902) * t45 + c_32 * t49;
  g[30] = -t50;
  const Scalar ddp_24_y = s_24 * t35 - c_24 * t36;
  const Scalar t51 = Scalar(0.0094) * ddp_24_y;
  const Scalar t52 = Scalar(0.1902) * t37 - c_25 * t51;
  g[23] = -t52;
  const Scalar mu_8_x = Scalar(27.463095) * s_7 + s_9 * mu_u_10_t_x - c_9 * t47;
  g[6] = s_8 * mu_9_z + c_8 * mu_8_x;
  const Scalar mu_2_x = Scalar(27.463095) * s_1 + s_3 * mu_u_4_t_x - c_3 * t48;
  g[0] = s_2 * mu_3_z + c_2 * mu_2_x;
  const Scalar t53 = Scalar(0.1902) * t46 + s_32 * t49;
  const Scalar t54 = Scalar(0.0094) * ddp_32_x;
  const Scalar mu_u_31_t_y = s_31 * t53 + c_31 * t54;
  g[29] = -mu_u_31_t_y;
  const Scalar t55 = Scalar(0.1902) * t38 - s_25 * t51;
  const Scalar t56 = s_24 * t55 - c_24 * N_25_z;
  g[22] = -t56;
  const Scalar mu_u_31_t_x = s_31 * t54 - c_31 * t53;
  const Scalar t57 = Scalar(0.8648) * t42 + Scalar(0.0328) * t44 + s_30 * t50 - c_30 * mu_u_31_t_x;
  g[28] = -t57;
  const Scalar t58 = s_24 * N_25_z + c_24 * t55;
  const Scalar t59 = Scalar(0.8648) * t34 + Scalar(0.0328) * t36 + s_23 * t52 + c_23 * t58;
  g[21] = -t59;
  const Scalar mu_29_x = Scalar(0.8648) * ddp_28_y - s_30 * mu_u_31_t_x - c_30 * t50;
  const Scalar mu_29_y = Scalar(0.0328) * ddp_28_y + mu_u_31_t_y;
  const Scalar mu_28_z = Scalar(0.0032) * ddp_28_y + s_29 * mu_29_x + c_29 * mu_29_y;
  g[27] = -mu_28_z;
  const Scalar mu_22_x = Scalar(0.8648) * ddp_21_y + s_23 * t58 - c_23 * t52;
  const Scalar mu_22_y = Scalar(0.0328) * ddp_21_y + t56;
  const Scalar mu_21_z = Scalar(0.0032) * ddp_21_y + s_22 * mu_22_x + c_22 * mu_22_y;
  g[20] = -mu_21_z;
  const Scalar t60 = s_29 * mu_29_y - c_29 * mu_29_x;
  const Scalar t61 = Scalar(0.0032) * t41 + t57;
  const Scalar t62 = Scalar(1.661) * t40 - s_28 * t61 + c_28 * t60;
  g[26] = -t62;
  const Scalar t63 = s_22 * mu_22_y - c_22 * mu_22_x;
  const Scalar t64 = Scalar(0.0032) * t33 + t59;
  const Scalar t65 = Scalar(1.661) * t32 - s_21 * t64 + c_21 * t63;
  g[19] = -t65;
  const Scalar mu_27_x = Scalar(1.661) * ddp_26_y - s_28 * t60 - c_28 * t61;
  const Scalar mu_u_27_t_y = s_27 * mu_28_z + c_27 * mu_27_x;
  g[25] = mu_u_27_t_y;
  const Scalar mu_20_x = Scalar(1.661) * ddp_19_y - s_21 * t63 - c_21 * t64;
  const Scalar mu_u_20_t_y = s_20 * mu_21_z + c_20 * mu_20_x;
  g[18] = mu_u_20_t_y;
  const Scalar t66 = s_20 * mu_20_x - c_20 * mu_21_z;
  const Scalar t67 = s_27 * mu_27_x - c_27 * mu_28_z;
  const Scalar mu_u_17_t_x = s_17 * mu_u_18_t_x - c_17 * g_18;
  const Scalar g_15 = s_16 * mu_u_17_t_x + c_16 * g_17 + s_19 * t66 - c_19 * t65 + s_26 * t67 -
      c_26 * t62 - Scalar(89.72226) * c_14 * s_15;
  g[14] = g_15;
  const Scalar t68 = mu_u_17_t_y + s_19 * t65 + c_19 * t66 + s_26 * t62 + c_26 * t67;
  const Scalar mu_15_y = Scalar(89.72226) * s_14 - mu_u_27_t_y - mu_u_20_t_y - s_16 * g_17 +
      c_16 * mu_u_17_t_x;
  g[13] = Scalar(-1.87371) * c_14 - s_15 * t68 - c_15 * mu_15_y;
  const Scalar mu_u_15_t_x = s_15 * mu_15_y - c_15 * t68;
  g[12] = -s_14 * g_15 - c_14 * mu_u_15_t_x;
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[32]   in   joint positions, rad or m
//   qd[32]  in   joint velocities, rad/s or m/s
//   n[32]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11], q[13..31], qd[0..31]. Operations: 1121 mul, 817 add, 62 sin/cos.
template <class Scalar>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6],
      q_8 = q[7], q_9 = q[8], q_10 = q[9], q_11 = q[10], q_12 = q[11], q_14 = q[13], q_15 = q[14],
      q_16 = q[15], q_17 = q[16], q_18 = q[17], q_19 = q[18], q_20 = q[19], q_21 = q[20],
      q_22 = q[21], q_23 = q[22], q_24 = q[23], q_25 = q[24], q_26 = q[25], q_27 = q[26],
      q_28 = q[27], q_29 = q[28], q_30 = q[29], q_31 = q[30], q_32 = q[31];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11],
      qd_13 = qd[12], qd_14 = qd[13], qd_15 = qd[14], qd_16 = qd[15], qd_17 = qd[16],
      qd_18 = qd[17], qd_19 = qd[18], qd_20 = qd[19], qd_21 = qd[20], qd_22 = qd[21],
      qd_23 = qd[22], qd_24 = qd[23], qd_25 = qd[24], qd_26 = qd[25], qd_27 = qd[26],
      qd_28 = qd[27], qd_29 = qd[28], qd_30 = qd[29], qd_31 = qd[30], qd_32 = qd[31];
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
  const Scalar s_14 = sin(q_14), c_14 = cos(q_14);
  const Scalar s_15 = sin(q_15), c_15 = cos(q_15);
  const Scalar s_16 = sin(q_16), c_16 = cos(q_16);
  const Scalar s_17 = sin(q_17), c_17 = cos(q_17);
  const Scalar s_18 = sin(q_18), c_18 = cos(q_18);
  const Scalar s_19 = sin(q_19), c_19 = cos(q_19);
  const Scalar s_20 = sin(q_20), c_20 = cos(q_20);
  const Scalar s_21 = sin(q_21), c_21 = cos(q_21);
  const Scalar s_22 = sin(q_22), c_22 = cos(q_22);
  const Scalar s_23 = sin(q_23), c_23 = cos(q_23);
  const Scalar s_24 = sin(q_24), c_24 = cos(q_24);
  const Scalar s_25 = sin(q_25), c_25 = cos(q_25);
  const Scalar s_26 = sin(q_26), c_26 = cos(q_26);
  const Scalar s_27 = sin(q_27), c_27 = cos(q_27);
  const Scalar s_28 = sin(q_28), c_28 = cos(q_28);
  const Scalar s_29 = sin(q_29), c_29 = cos(q_29);
  const Scalar s_30 = sin(q_30), c_30 = cos(q_30);
  const Scalar s_31 = sin(q_31), c_31 = cos(q_31);
  const Scalar s_32 = sin(q_32), c_32 = cos(q_32);
  const Scalar t1 = c_14 * c_15;
  const Scalar t2 = s_15 * qd_14 - qd_13 * t1;
  const Scalar t3 = qd_13 * qd_14;
  const Scalar t4 = s_14 * t3;
  const Scalar domega_15_y = qd_15 * t2 + s_15 * t4;
  const Scalar t5 = s_14 * qd_13;
  const Scalar omega_15_z = qd_15 - t5;
  const Scalar t6 = t2 * omega_15_z;
  const Scalar U_15_zx = domega_15_y + t6;
  const Scalar t7 = c_14 * s_15;
  const Scalar omega_r_15_y = qd_13 * t7 + c_15 * qd_14;
  const Scalar t8 = omega_r_15_y * omega_r_15_y;
  const Scalar t9 = t2 * t2;
  const Scalar U_15_zz = t8 + t9;
  const Scalar t10 = Scalar(9.81) * s_14;
  const Scalar ddp_o_16_z = Scalar(0.453) * U_15_zx - Scalar(0.003) * U_15_zz + t10;
  const Scalar domega_15_x = qd_15 * omega_r_15_y + c_15 * t4;
  const Scalar t11 = omega_r_15_y * omega_15_z;
  const Scalar U_15_yz = domega_15_x - t11;
  const Scalar t12 = t2 * omega_r_15_y;
  const Scalar t13 = c_14 * t3;
  const Scalar t14 = t12 - t13;
  const Scalar t15 = Scalar(9.81) * t7;
  const Scalar t16 = Scalar(0.453) * t14 - Scalar(0.003) * U_15_yz - t15;
  const Scalar ddp_16_x = s_16 * ddp_o_16_z - c_16 * t16;
  const Scalar U_15_xz = domega_15_y - t6;
  const Scalar t17 = omega_15_z * omega_15_z;
  const Scalar U_15_xx = t17 + t8;
  const Scalar t18 = Scalar(9.81) * t1;
  const Scalar t19 = Scalar(0.453) * U_15_xx + Scalar(0.003) * U_15_xz - t18;
  const Scalar t20 = s_17 * ddp_16_x + c_17 * t19;
  const Scalar ddp_16_y = s_16 * t16 + c_16 * ddp_o_16_z;
  const Scalar t21 = s_18 * t20 - c_18 * ddp_16_y;
  const Scalar t22 = s_18 * ddp_16_y + c_18 * t20;
  const Scalar t23 = s_16 * omega_15_z - c_16 * omega_r_15_y;
  const Scalar omega_16_z = qd_16 - t2;
  const Scalar omega_r_17_x = s_17 * t23 + c_17 * omega_16_z;
  const Scalar omega_r_16_y = s_16 * omega_r_15_y + c_16 * omega_15_z;
  const Scalar omega_17_z = qd_17 + omega_r_16_y;
  const Scalar omega_r_18_y = s_18 * omega_17_z + c_18 * omega_r_17_x;
  const Scalar omega_r_17_y = s_17 * omega_16_z - c_17 * t23;
  const Scalar omega_18_z = qd_18 + omega_r_17_y;
  const Scalar t24 = omega_18_z * omega_18_z;
  const Scalar U_18_xx = t24 + omega_r_18_y * omega_r_18_y;
  const Scalar t25 = s_18 * omega_r_17_x - c_18 * omega_17_z;
  const Scalar U_18_yy = t24 + t25 * t25;
  const Scalar U_18_xx_yy = U_18_xx - U_18_yy;
  const Scalar t26 = t25 * omega_r_18_y;
  const Scalar domega_16_x = qd_16 * omega_r_16_y - s_16 * t13 + c_16 * domega_15_y;
  const Scalar t27 = qd_17 * omega_r_17_x - s_17 * domega_15_x - c_17 * domega_16_x;
  const Scalar n_18 = Scalar(0.03408) * t27 + Scalar(0.22) * t21 + Scalar(0.02) * t22 -
      Scalar(0.024) * t26 - Scalar(0.0022) * U_18_xx_yy;
  n[17] = n_18;
  const Scalar t28 = c_2 * qd_1;
  const Scalar omega_r_3_x = s_3 * t28 + c_3 * qd_2;
  const Scalar t29 = s_2 * qd_1;
  const Scalar omega_3_z = qd_3 - t29;
  const Scalar t30 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar t31 = s_3 * qd_2 - c_3 * t28;
  const Scalar t32 = qd_2 * t29;
  const Scalar domega_3_x = qd_3 * t31 + s_3 * t32;
  const Scalar t33 = qd_2 * t28;
  const Scalar domega_4_x = qd_4 * t30 + s_4 * domega_3_x + c_4 * t33;
  const Scalar omega_4_z = qd_4 - t31;
  const Scalar t34 = t30 * omega_4_z;
  const Scalar U_4_zy = domega_4_x + t34;
  const Scalar ddp_o_3_z = Scalar(9.81) * s_1 - Scalar(0.778) * t32;
  const Scalar t35 = t28 * t29;
  const Scalar t36 = Scalar(9.81) * c_1;
  const Scalar ddp_o_3_x = Scalar(0.389) * t35 + s_2 * t36;
  const Scalar ddp_3_y = s_3 * ddp_o_3_z + c_3 * ddp_o_3_x;
  const Scalar t37 = omega_r_3_x * t31;
  const Scalar U_3_yx = t37 + t33;
  const Scalar ddp_o_4_y = ddp_3_y + Scalar(0.02) * U_3_yx;
  const Scalar t38 = ddp_o_4_y - Scalar(0.04) * U_4_zy;
  const Scalar omega_r_4_x = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar domega_4_y = qd_4 * omega_r_4_x - s_4 * t33 + c_4 * domega_3_x;
  const Scalar t39 = omega_r_4_x * omega_4_z;
  const Scalar U_4_zx = domega_4_y + t39;
  const Scalar t40 = Scalar(0.357) * U_4_zx - t38;
  const Scalar domega_3_y = qd_3 * omega_r_3_x + c_3 * t32;
  const Scalar t41 = omega_r_3_x * omega_3_z;
  const Scalar U_3_zx = domega_3_y + t41;
  const Scalar U_2_yy = qd_2 * qd_2 + t28 * t28;
  const Scalar ddp_o_3_y = Scalar(0.389) * U_2_yy + c_2 * t36;
  const Scalar ddp_o_4_z = ddp_o_3_y - Scalar(0.02) * U_3_zx;
  const Scalar t42 = omega_3_z * omega_3_z;
  const Scalar U_3_xx = t42 + t31 * t31;
  const Scalar t43 = Scalar(0.02) * U_3_xx + s_3 * ddp_o_3_x - c_3 * ddp_o_3_z;
  const Scalar ddp_4_x = s_4 * t43 + c_4 * ddp_o_4_z;
  const Scalar t44 = omega_4_z * omega_4_z;
  const Scalar U_4_xx = t44 + t30 * t30;
  const Scalar t45 = omega_r_4_x * t30;
  const Scalar U_4_xy = domega_3_y - t45;
  const Scalar ddp_o_5_x = ddp_4_x + Scalar(0.357) * U_4_xx + Scalar(0.04) * U_4_xy;
  const Scalar t46 = s_5 * t40 + c_5 * ddp_o_5_x;
  const Scalar t47 = s_4 * ddp_o_4_z - c_4 * t43;
  const Scalar U_4_yx = domega_3_y + t45;
  const Scalar U_4_yy = t44 + omega_r_4_x * omega_r_4_x;
  const Scalar t48 = t47 - Scalar(0.357) * U_4_yx + Scalar(0.04) * U_4_yy;
  const Scalar t49 = s_6 * t46 + c_6 * t48;
  const Scalar t50 = s_6 * t48 - c_6 * t46;
  const Scalar t51 = s_5 * omega_4_z - c_5 * omega_r_4_x;
  const Scalar omega_5_z = qd_5 - t30;
  const Scalar omega_r_6_y = s_6 * omega_5_z - c_6 * t51;
  const Scalar omega_r_5_y = s_5 * omega_r_4_x + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t52 = omega_6_z * omega_6_z;
  const Scalar U_6_xx = t52 + omega_r_6_y * omega_r_6_y;
  const Scalar omega_r_6_x = s_6 * t51 + c_6 * omega_5_z;
  const Scalar U_6_yy = t52 + omega_r_6_x * omega_r_6_x;
  const Scalar U_6_xx_yy = U_6_xx - U_6_yy;
  const Scalar t53 = omega_r_6_x * omega_r_6_y;
  const Scalar domega_5_y = qd_5 * t51 + s_5 * domega_4_x + c_5 * domega_3_y;
  const Scalar N_6_z = Scalar(0.01431666666667) * domega_5_y - Scalar(0.105) * t49 -
      Scalar(0.045) * t50 - Scalar(0.0012) * t53 - Scalar(0.00315) * U_6_xx_yy;
  n[5] = -N_6_z;
  const Scalar t54 = c_8 * qd_7;
  const Scalar omega_r_9_x = s_9 * t54 + c_9 * qd_8;
  const Scalar t55 = s_8 * qd_7;
  const Scalar omega_9_z = qd_9 - t55;
  const Scalar t56 = s_10 * omega_9_z - c_10 * omega_r_9_x;
  const Scalar t57 = s_9 * qd_8 - c_9 * t54;
  const Scalar t58 = qd_8 * t55;
  const Scalar domega_9_x = qd_9 * t57 + s_9 * t58;
  const Scalar t59 = qd_8 * t54;
  const Scalar domega_10_x = qd_10 * t56 + s_10 * domega_9_x + c_10 * t59;
  const Scalar omega_10_z = qd_10 - t57;
  const Scalar t60 = t56 * omega_10_z;
  const Scalar U_10_zy = domega_10_x + t60;
  const Scalar ddp_o_9_z = Scalar(9.81) * s_7 - Scalar(0.778) * t58;
  const Scalar t61 = t54 * t55;
  const Scalar t62 = Scalar(9.81) * c_7;
  const Scalar ddp_o_9_x = Scalar(0.389) * t61 + s_8 * t62;
  const Scalar ddp_9_y = s_9 * ddp_o_9_z + c_9 * ddp_o_9_x;
  const Scalar t63 = omega_r_9_x * t57;
  const Scalar U_9_yx = t63 + t59;
  const Scalar ddp_o_10_y = ddp_9_y + Scalar(0.02) * U_9_yx;
  const Scalar t64 = ddp_o_10_y - Scalar(0.04) * U_10_zy;
  const Scalar omega_r_10_x = s_10 * omega_r_9_x + c_10 * omega_9_z;
  const Scalar domega_10_y = qd_10 * omega_r_10_x - s_10 * t59 + c_10 * domega_9_x;
  const Scalar t65 = omega_r_10_x * omega_10_z;
  const Scalar U_10_zx = domega_10_y + t65;
  const Scalar t66 = Scalar(0.357) * U_10_zx - t64;
  const Scalar domega_9_y = qd_9 * omega_r_9_x + c_9 * t58;
  const Scalar t67 = omega_r_9_x * omega_9_z;
  const Scalar U_9_zx = domega_9_y + t67;
  const Scalar U_8_yy = qd_8 * qd_8 + t54 * t54;
  const Scalar ddp_o_9_y = Scalar(0.389) * U_8_yy + c_8 * t62;
  const Scalar ddp_o_10_z = ddp_o_9_y - Scalar(0.02) * U_9_zx;
  const Scalar t68 = omega_9_z * omega_9_z;
  const Scalar U_9_xx = t68 + t57 * t57;
  const Scalar t69 = Scalar(0.02) * U_9_xx + s_9 * ddp_o_9_x - c_9 * ddp_o_9_z;
  const Scalar ddp_10_x = s_10 * t69 + c_10 * ddp_o_10_z;
  const Scalar t70 = omega_10_z * omega_10_z;
  const Scalar U_10_xx = t70 + t56 * t56;
  const Scalar t71 = omega_r_10_x * t56;
  const Scalar U_10_xy = domega_9_y - t71;
  const Scalar ddp_o_11_x = ddp_10_x + Scalar(0.357) * U_10_xx + Scalar(0.04) * U_10_xy;
  const Scalar t72 = s_11 * t66 + c_11 * ddp_o_11_x;
  const Scalar t73 = s_10 * ddp_o_10_z - c_10 * t69;
  const Scalar U_10_yx = domega_9_y + t71;
  const Scalar U_10_yy = t70 + omega_r_10_x * omega_r_10_x;
  const Scalar t74 = t73 - Scalar(0.357) * U_10_yx + Scalar(0.04) * U_10_yy;
  const Scalar t75 = s_12 * t72 + c_12 * t74;
  const Scalar t76 = s_12 * t74 - c_12 * t72;
  const Scalar t77 = s_11 * omega_10_z - c_11 * omega_r_10_x;
  const Scalar omega_11_z = qd_11 - t56;
  const Scalar omega_r_12_y = s_12 * omega_11_z - c_12 * t77;
  const Scalar omega_r_11_y = s_11 * omega_r_10_x + c_11 * omega_10_z;
  const Scalar omega_12_z = qd_12 + omega_r_11_y;
  const Scalar t78 = omega_12_z * omega_12_z;
  const Scalar U_12_xx = t78 + omega_r_12_y * omega_r_12_y;
  const Scalar omega_r_12_x = s_12 * t77 + c_12 * omega_11_z;
  const Scalar U_12_yy = t78 + omega_r_12_x * omega_r_12_x;
  const Scalar U_12_xx_yy = U_12_xx - U_12_yy;
  const Scalar t79 = omega_r_12_x * omega_r_12_y;
  const Scalar domega_11_y = qd_11 * t77 + s_11 * domega_10_x + c_11 * domega_9_y;
  const Scalar N_12_z = Scalar(0.01431666666667) * domega_11_y - Scalar(0.105) * t75 -
      Scalar(0.045) * t76 - Scalar(0.0012) * t79 - Scalar(0.00315) * U_12_xx_yy;
  n[11] = -N_12_z;
  const Scalar domega_17_x = qd_17 * omega_r_17_y - s_17 * domega_16_x + c_17 * domega_15_x;
  const Scalar domega_16_y = qd_16 * t23 + s_16 * domega_15_y + c_16 * t13;
  const Scalar domega_18_x = qd_18 * omega_r_18_y - s_18 * domega_17_x + c_18 * domega_16_y;
  const Scalar t80 = omega_r_18_y * omega_18_z;
  const Scalar U_18_zy = domega_18_x + t80;
  const Scalar t81 = s_17 * t19 - c_17 * ddp_16_x;
  const Scalar t82 = t25 * omega_18_z;
  const Scalar t83 = Scalar(0.02) * t81 + Scalar(0.01008) * t82 - Scalar(0.0022) * U_18_zy;
  const Scalar U_18_zx = t82 + qd_18 * t25 + s_18 * domega_16_y + c_18 * domega_17_x;
  const Scalar t84 = Scalar(0.22) * t81 - Scalar(0.024) * domega_18_x + Scalar(0.0022) * U_18_zx -
      Scalar(0.03408) * t80;
  const Scalar mu_17_z = Scalar(0.01038) * domega_16_y + s_18 * t83 - c_18 * t84 -
      Scalar(0.00988) * omega_r_17_x * omega_r_17_y;
  n[16] = -mu_17_z;
  const Scalar t85 = s_11 * ddp_o_11_x - c_11 * t66;
  const Scalar domega_11_x = qd_11 * omega_r_11_y - s_11 * domega_9_y + c_11 * domega_10_x;
  const Scalar domega_12_x = qd_12 * omega_r_12_y - s_12 * domega_11_x + c_12 * domega_10_y;
  const Scalar t86 = omega_r_12_y * omega_12_z;
  const Scalar U_12_zy = domega_12_x + t86;
  const Scalar t87 = omega_r_12_x * omega_12_z;
  const Scalar t88 = Scalar(0.045) * t85 + Scalar(0.01311666666667) * t87 -
      Scalar(0.00315) * U_12_zy;
  const Scalar t89 = t87 + qd_12 * omega_r_12_x - s_12 * domega_10_y - c_12 * domega_11_x;
  const Scalar t90 = Scalar(0.105) * t85 - Scalar(0.0012) * domega_12_x + Scalar(0.00315) * t89 -
      Scalar(0.01431666666667) * t86;
  const Scalar mu_11_z = Scalar(0.00820666666667) * domega_10_y - s_12 * t88 - c_12 * t90 +
      Scalar(0.00756666666667) * t77 * omega_r_11_y;
  n[10] = -mu_11_z;
  const Scalar t91 = s_5 * ddp_o_5_x - c_5 * t40;
  const Scalar domega_5_x = qd_5 * omega_r_5_y - s_5 * domega_3_y + c_5 * domega_4_x;
  const Scalar domega_6_x = qd_6 * omega_r_6_y - s_6 * domega_5_x + c_6 * domega_4_y;
  const Scalar t92 = omega_r_6_y * omega_6_z;
  const Scalar U_6_zy = domega_6_x + t92;
  const Scalar t93 = omega_r_6_x * omega_6_z;
  const Scalar t94 = Scalar(0.045) * t91 + Scalar(0.01311666666667) * t93 -
      Scalar(0.00315) * U_6_zy;
  const Scalar t95 = t93 + qd_6 * omega_r_6_x - s_6 * domega_4_y - c_6 * domega_5_x;
  const Scalar t96 = Scalar(0.105) * t91 - Scalar(0.0012) * domega_6_x + Scalar(0.00315) * t95 -
      Scalar(0.01431666666667) * t92;
  const Scalar mu_5_z = Scalar(0.00820666666667) * domega_4_y - s_6 * t94 - c_6 * t96 +
      Scalar(0.00756666666667) * t51 * omega_r_5_y;
  n[4] = -mu_5_z;
  const Scalar t97 = n_18 + Scalar(0.0005) * omega_r_17_x * omega_17_z;
  const Scalar mu_17_x = Scalar(0.00988) * domega_17_x + s_18 * t84 + c_18 * t83 +
      Scalar(0.01038) * omega_r_17_y * omega_17_z;
  const Scalar mu_16_z = Scalar(0.001125) * domega_15_x - s_17 * t97 + c_17 * mu_17_x +
      Scalar(0.0005) * t23 * omega_r_16_y;
  n[15] = -mu_16_z;
  const Scalar t98 = N_12_z + Scalar(0.00064) * t77 * omega_11_z;
  const Scalar U_12_xy = domega_11_y - t79;
  const Scalar F_12_x = Scalar(0.045) * U_12_xx - Scalar(0.105) * U_12_xy;
  const Scalar U_12_yx = domega_11_y + t79;
  const Scalar F_12_y = Scalar(0.045) * U_12_yx + Scalar(0.105) * U_12_yy;
  const Scalar f_u_12_t_x = s_12 * F_12_x + c_12 * F_12_y;
  const Scalar t99 = Scalar(0.045) * t89 - Scalar(0.105) * U_12_zy;
  const Scalar f_u_11_t_x = s_11 * t99 + c_11 * f_u_12_t_x;
  const Scalar mu_11_x = Scalar(0.00756666666667) * domega_11_x + s_12 * t90 - c_12 * t88 +
      Scalar(0.00820666666667) * omega_r_11_y * omega_11_z;
  const Scalar t100 = s_12 * F_12_y - c_12 * F_12_x;
  const Scalar U_10_xx_yy = U_10_xx - U_10_yy;
  const Scalar mu_10_z = Scalar(0.4393875) * domega_9_y + Scalar(0.22) * ddp_10_x -
      Scalar(1.3725) * t73 + Scalar(0.4092575) * t71 + Scalar(0.0549) * U_10_xx_yy +
      Scalar(0.357) * t100 + Scalar(0.04) * f_u_11_t_x - s_11 * mu_11_x + c_11 * t98;
  n[9] = -mu_10_z;
  const Scalar t101 = N_6_z + Scalar(0.00064) * t51 * omega_5_z;
  const Scalar U_6_xy = domega_5_y - t53;
  const Scalar F_6_x = Scalar(0.045) * U_6_xx - Scalar(0.105) * U_6_xy;
  const Scalar U_6_yx = domega_5_y + t53;
  const Scalar F_6_y = Scalar(0.045) * U_6_yx + Scalar(0.105) * U_6_yy;
  const Scalar f_u_6_t_x = s_6 * F_6_x + c_6 * F_6_y;
  const Scalar t102 = Scalar(0.045) * t95 - Scalar(0.105) * U_6_zy;
  const Scalar f_u_5_t_x = s_5 * t102 + c_5 * f_u_6_t_x;
  const Scalar mu_5_x = Scalar(0.00756666666667) * domega_5_x + s_6 * t96 - c_6 * t94 +
      Scalar(0.00820666666667) * omega_r_5_y * omega_5_z;
  const Scalar t103 = s_6 * F_6_y - c_6 * F_6_x;
  const Scalar U_4_xx_yy = U_4_xx - U_4_yy;
  const Scalar mu_4_z = Scalar(0.4393875) * domega_3_y + Scalar(0.22) * ddp_4_x -
      Scalar(1.3725) * t47 + Scalar(0.4092575) * t45 + Scalar(0.0549) * U_4_xx_yy +
      Scalar(0.357) * t103 + Scalar(0.04) * f_u_5_t_x - s_5 * mu_5_x + c_5 * t101;
  n[3] = -mu_4_z;
  const Scalar f_u_11_t_y = s_11 * f_u_12_t_x - c_11 * t99;
  const Scalar t104 = Scalar(1.3725) * U_10_zx + f_u_11_t_y;
  const Scalar mu_10_x = Scalar(0.22) * ddp_o_10_y + Scalar(0.4092575) * domega_10_x -
      Scalar(0.4393875) * t60 - Scalar(0.04) * t104 - s_11 * t98 - c_11 * mu_11_x;
  const Scalar f_10_z = Scalar(0.22) * U_10_zy + t104;
  const Scalar t105 = Scalar(0.848645) * t65 - Scalar(1.3725) * t64 + mu_11_z +
      Scalar(0.357) * f_u_11_t_y;
  const Scalar t106 = t57 * omega_9_z;
  const Scalar U_9_yz = domega_9_x - t106;
  const Scalar mu_9_z = Scalar(0.08) * ddp_9_y - Scalar(0.4222475) * t63 + Scalar(0.4384975) * t59 -
      Scalar(0.00507) * U_9_yz - Scalar(0.02) * f_10_z - s_10 * t105 - c_10 * mu_10_x;
  n[8] = -mu_9_z;
  const Scalar f_u_5_t_y = s_5 * f_u_6_t_x - c_5 * t102;
  const Scalar t107 = Scalar(1.3725) * U_4_zx + f_u_5_t_y;
  const Scalar mu_4_x = Scalar(0.22) * ddp_o_4_y + Scalar(0.4092575) * domega_4_x -
      Scalar(0.4393875) * t34 - Scalar(0.04) * t107 - s_5 * t101 - c_5 * mu_5_x;
  const Scalar f_4_z = Scalar(0.22) * U_4_zy + t107;
  const Scalar t108 = Scalar(0.848645) * t39 - Scalar(1.3725) * t38 + mu_5_z +
      Scalar(0.357) * f_u_5_t_y;
  const Scalar t109 = t31 * omega_3_z;
  const Scalar U_3_yz = domega_3_x - t109;
  const Scalar mu_3_z = Scalar(0.08) * ddp_3_y - Scalar(0.4222475) * t37 + Scalar(0.4384975) * t33 -
      Scalar(0.00507) * U_3_yz - Scalar(0.02) * f_4_z - s_4 * t108 - c_4 * mu_4_x;
  n[2] = -mu_3_z;
  const Scalar f_10_x = Scalar(1.3725) * U_10_xx + Scalar(0.22) * U_10_xy + f_u_11_t_x;
  const Scalar f_10_y = Scalar(1.3725) * U_10_yx - Scalar(0.22) * U_10_yy + t100;
  const Scalar f_9_x = Scalar(0.08) * U_9_xx + s_10 * f_10_x + c_10 * f_10_y;
  const Scalar f_9_y = Scalar(0.08) * U_9_yx - f_10_z;
  const Scalar f_u_9_t_x = s_9 * f_9_x + c_9 * f_9_y;
  const Scalar t110 = s_10 * f_10_y - c_10 * f_10_x;
  const Scalar mu_9_y = Scalar(0.08) * ddp_o_9_y - Scalar(0.01625) * t67 -
      Scalar(0.00507) * (t68 - omega_r_9_x * omega_r_9_x) - mu_10_z - Scalar(0.02) * t110;
  const Scalar mu_9_x = Scalar(0.4222475) * domega_9_x - Scalar(0.00507) * U_9_yx +
      Scalar(0.4384975) * t106 - s_10 * mu_10_x + c_10 * t105;
  n[7] = Scalar(1.0144905) * t61 + Scalar(0.389) * f_u_9_t_x - s_9 * mu_9_y - c_9 * mu_9_x +
      Scalar(27.463095) * c_7 * s_8;
  const Scalar f_4_x = Scalar(1.3725) * U_4_xx + Scalar(0.22) * U_4_xy + f_u_5_t_x;
  const Scalar f_4_y = Scalar(1.3725) * U_4_yx - Scalar(0.22) * U_4_yy + t103;
  const Scalar f_3_x = Scalar(0.08) * U_3_xx + s_4 * f_4_x + c_4 * f_4_y;
  const Scalar f_3_y = Scalar(0.08) * U_3_yx - f_4_z;
  const Scalar f_u_3_t_x = s_3 * f_3_x + c_3 * f_3_y;
  const Scalar t111 = s_4 * f_4_y - c_4 * f_4_x;
  const Scalar mu_3_y = Scalar(0.08) * ddp_o_3_y - Scalar(0.01625) * t41 -
      Scalar(0.00507) * (t42 - omega_r_3_x * omega_r_3_x) - mu_4_z - Scalar(0.02) * t111;
  const Scalar mu_3_x = Scalar(0.4222475) * domega_3_x - Scalar(0.00507) * U_3_yx +
      Scalar(0.4384975) * t109 - s_4 * mu_4_x + c_4 * t108;
  n[1] = Scalar(1.0144905) * t35 + Scalar(0.389) * f_u_3_t_x - s_3 * mu_3_y - c_3 * mu_3_x +
      Scalar(27.463095) * c_1 * s_2;
  const Scalar t112 = s_9 * f_9_y - c_9 * f_9_x;
  const Scalar mu_8_x = Scalar(27.463095) * s_7 - Scalar(2.030941) * t58 + Scalar(0.389) * t112 -
      s_9 * mu_9_x + c_9 * mu_9_y;
  const Scalar mu_8_y = Scalar(0.00196) * t59 + mu_9_z;
  n[6] = s_8 * mu_8_y + c_8 * mu_8_x;
  const Scalar t113 = s_3 * f_3_y - c_3 * f_3_x;
  const Scalar mu_2_x = Scalar(27.463095) * s_1 - Scalar(2.030941) * t32 + Scalar(0.389) * t113 -
      s_3 * mu_3_x + c_3 * mu_3_y;
  const Scalar mu_2_y = Scalar(0.00196) * t33 + mu_3_z;
  n[0] = s_2 * mu_2_y + c_2 * mu_2_x;
  const Scalar t114 = Scalar(0.33) * U_15_zx + t10;
  const Scalar U_15_zy = domega_15_x + t11;
  const Scalar t115 = Scalar(0.24) * U_15_zy;
  const Scalar t116 = t114 - t115;
  const Scalar t117 = Scalar(0.33) * U_15_xx - t18;
  const Scalar U_15_xy = t12 + t13;
  const Scalar t118 = Scalar(0.24) * U_15_xy;
  const Scalar t119 = t117 + t118;
  const Scalar t120 = s_26 * t116 + c_26 * t119;
  const Scalar t121 = Scalar(0.33) * t14 - t15;
  const Scalar U_15_yy = t17 + t9;
  const Scalar t122 = Scalar(0.24) * U_15_yy;
  const Scalar t123 = t121 + t122;
  const Scalar t124 = s_27 * t120 + c_27 * t123;
  const Scalar omega_r_26_x = s_26 * omega_15_z - c_26 * t2;
  const Scalar omega_26_z = qd_26 + omega_r_15_y;
  const Scalar omega_r_27_x = s_27 * omega_r_26_x + c_27 * omega_26_z;
  const Scalar t125 = s_27 * omega_26_z - c_27 * omega_r_26_x;
  const Scalar t126 = omega_r_27_x * t125;
  const Scalar domega_26_y = qd_26 * omega_r_26_x - s_26 * domega_15_x + c_26 * t13;
  const Scalar U_27_xy = domega_26_y - t126;
  const Scalar t127 = t124 + Scalar(0.305) * U_27_xy;
  const Scalar t128 = s_26 * t119 - c_26 * t116;
  const Scalar omega_r_26_y = s_26 * t2 + c_26 * omega_15_z;
  const Scalar t129 = qd_26 * omega_r_26_y - s_26 * t13 - c_26 * domega_15_x;
  const Scalar domega_27_x = qd_27 * t125 - s_27 * t129 + c_27 * domega_15_y;
  const Scalar omega_27_z = qd_27 + omega_r_26_y;
  const Scalar t130 = t125 * omega_27_z;
  const Scalar U_27_zy = domega_27_x + t130;
  const Scalar t131 = t128 + Scalar(0.305) * U_27_zy;
  const Scalar t132 = s_28 * omega_27_z - c_28 * omega_r_27_x;
  const Scalar omega_28_z = qd_28 - t125;
  const Scalar t133 = omega_28_z * omega_28_z;
  const Scalar U_28_xx = t133 + t132 * t132;
  const Scalar ddp_o_29_x = Scalar(0.004) * U_28_xx + s_28 * t127 - c_28 * t131;
  const Scalar U_27_yy = omega_27_z * omega_27_z + omega_r_27_x * omega_r_27_x;
  const Scalar ddp_o_28_y = Scalar(0.305) * U_27_yy + s_27 * t123 - c_27 * t120;
  const Scalar omega_r_28_x = s_28 * omega_r_27_x + c_28 * omega_27_z;
  const Scalar domega_28_y = qd_28 * omega_r_28_x - s_28 * domega_26_y + c_28 * domega_27_x;
  const Scalar t134 = omega_r_28_x * omega_28_z;
  const Scalar U_28_zx = domega_28_y + t134;
  const Scalar ddp_o_29_z = ddp_o_28_y + Scalar(0.004) * U_28_zx;
  const Scalar ddp_29_x = s_29 * ddp_o_29_z + c_29 * ddp_o_29_x;
  const Scalar omega_r_29_y = s_29 * omega_r_28_x + c_29 * omega_28_z;
  const Scalar omega_29_z = qd_29 - t132;
  const Scalar t135 = omega_29_z * omega_29_z;
  const Scalar U_29_xx = t135 + omega_r_29_y * omega_r_29_y;
  const Scalar t136 = s_29 * omega_28_z - c_29 * omega_r_28_x;
  const Scalar t137 = t136 * omega_r_29_y;
  const Scalar U_29_xy = domega_28_y + t137;
  const Scalar ddp_o_30_x = ddp_29_x - Scalar(0.004) * U_29_xx - Scalar(0.239) * U_29_xy;
  const Scalar t138 = s_28 * t131 + c_28 * t127;
  const Scalar t139 = omega_r_28_x * t132;
  const Scalar domega_27_y = qd_27 * omega_r_27_x - s_27 * domega_15_y - c_27 * t129;
  const Scalar U_28_yx = domega_27_y + t139;
  const Scalar t140 = t138 + Scalar(0.004) * U_28_yx;
  const Scalar domega_28_x = qd_28 * t132 + s_28 * domega_27_x + c_28 * domega_26_y;
  const Scalar domega_29_y = qd_29 * t136 + s_29 * domega_28_x + c_29 * domega_27_y;
  const Scalar t141 = t136 * omega_29_z;
  const Scalar U_29_zx = domega_29_y + t141;
  const Scalar domega_29_x = qd_29 * omega_r_29_y - s_29 * domega_27_y + c_29 * domega_28_x;
  const Scalar t142 = omega_r_29_y * omega_29_z;
  const Scalar U_29_zy = domega_29_x + t142;
  const Scalar t143 = t140 - Scalar(0.004) * U_29_zx + Scalar(0.239) * U_29_zy;
  const Scalar t144 = s_30 * ddp_o_30_x - c_30 * t143;
  const Scalar t145 = s_29 * ddp_o_29_x - c_29 * ddp_o_29_z;
  const Scalar U_29_yx = domega_28_y - t137;
  const Scalar U_29_yy = t135 + t136 * t136;
  const Scalar t146 = t145 + Scalar(0.004) * U_29_yx - Scalar(0.239) * U_29_yy;
  const Scalar t147 = s_31 * t144 + c_31 * t146;
  const Scalar omega_r_30_x = s_30 * t136 + c_30 * omega_29_z;
  const Scalar omega_30_z = qd_30 + omega_r_29_y;
  const Scalar omega_r_31_x = s_31 * omega_30_z + c_31 * omega_r_30_x;
  const Scalar omega_r_30_y = s_30 * omega_29_z - c_30 * t136;
  const Scalar omega_31_z = qd_31 + omega_r_30_y;
  const Scalar t148 = s_32 * omega_31_z - c_32 * omega_r_31_x;
  const Scalar t149 = s_31 * omega_r_30_x - c_31 * omega_30_z;
  const Scalar domega_30_x = qd_30 * omega_r_30_y - s_30 * domega_29_x + c_30 * domega_28_y;
  const Scalar domega_31_x = qd_31 * t149 + s_31 * domega_29_y + c_31 * domega_30_x;
  const Scalar t150 = qd_30 * omega_r_30_x - s_30 * domega_28_y - c_30 * domega_29_x;
  const Scalar domega_32_x = qd_32 * t148 + s_32 * domega_31_x - c_32 * t150;
  const Scalar omega_32_z = qd_32 - t149;
  const Scalar t151 = omega_32_z * omega_32_z;
  const Scalar t152 = t148 * omega_32_z;
  const Scalar t153 = Scalar(0.0094) * t147 + Scalar(0.0005096) * domega_32_x -
      Scalar(0.0014129000000002) * t152 + Scalar(0.0007482) * (t151 - t148 * t148);
  const Scalar t154 = s_31 * t146 - c_31 * t144;
  const Scalar omega_r_32_x = s_32 * omega_r_31_x + c_32 * omega_31_z;
  const Scalar t155 = omega_r_32_x * t148;
  const Scalar domega_31_y = qd_31 * omega_r_31_x - s_31 * domega_30_x + c_31 * domega_29_y;
  const Scalar U_32_xy = domega_31_y - t155;
  const Scalar t156 = omega_r_32_x * omega_32_z;
  const Scalar t157 = Scalar(0.0007482) * U_32_xy - Scalar(0.0019225000000002) * t156;
  const Scalar t158 = omega_r_31_x * t149;
  const Scalar n_31 = Scalar(0.0258331000000002) * t150 - Scalar(0.1902) * t154 +
      Scalar(0.0255131000000002) * t158 - s_32 * t157 + c_32 * t153;
  n[30] = n_31;
  const Scalar ddp_o_19_z = t114 + t115;
  const Scalar t159 = t117 - t118;
  const Scalar t160 = s_19 * ddp_o_19_z + c_19 * t159;
  const Scalar t161 = t121 - t122;
  const Scalar t162 = s_20 * t160 + c_20 * t161;
  const Scalar omega_r_19_x = s_19 * omega_15_z - c_19 * t2;
  const Scalar omega_19_z = qd_19 + omega_r_15_y;
  const Scalar omega_r_20_x = s_20 * omega_r_19_x + c_20 * omega_19_z;
  const Scalar t163 = s_20 * omega_19_z - c_20 * omega_r_19_x;
  const Scalar t164 = omega_r_20_x * t163;
  const Scalar domega_19_y = qd_19 * omega_r_19_x - s_19 * domega_15_x + c_19 * t13;
  const Scalar U_20_xy = domega_19_y - t164;
  const Scalar t165 = t162 + Scalar(0.305) * U_20_xy;
  const Scalar t166 = s_19 * t159 - c_19 * ddp_o_19_z;
  const Scalar omega_r_19_y = s_19 * t2 + c_19 * omega_15_z;
  const Scalar t167 = qd_19 * omega_r_19_y - s_19 * t13 - c_19 * domega_15_x;
  const Scalar domega_20_x = qd_20 * t163 - s_20 * t167 + c_20 * domega_15_y;
  const Scalar omega_20_z = qd_20 + omega_r_19_y;
  const Scalar t168 = t163 * omega_20_z;
  const Scalar U_20_zy = domega_20_x + t168;
  const Scalar t169 = t166 + Scalar(0.305) * U_20_zy;
  const Scalar t170 = s_21 * omega_20_z - c_21 * omega_r_20_x;
  const Scalar omega_21_z = qd_21 - t163;
  const Scalar t171 = omega_21_z * omega_21_z;
  const Scalar U_21_xx = t171 + t170 * t170;
  const Scalar ddp_o_22_x = Scalar(0.004) * U_21_xx + s_21 * t165 - c_21 * t169;
  const Scalar U_20_yy = omega_20_z * omega_20_z + omega_r_20_x * omega_r_20_x;
  const Scalar ddp_o_21_y = Scalar(0.305) * U_20_yy + s_20 * t161 - c_20 * t160;
  const Scalar omega_r_21_x = s_21 * omega_r_20_x + c_21 * omega_20_z;
  const Scalar domega_21_y = qd_21 * omega_r_21_x - s_21 * domega_19_y + c_21 * domega_20_x;
  const Scalar t172 = omega_r_21_x * omega_21_z;
  const Scalar U_21_zx = domega_21_y + t172;
  const Scalar ddp_o_22_z = ddp_o_21_y + Scalar(0.004) * U_21_zx;
  const Scalar ddp_22_x = s_22 * ddp_o_22_z + c_22 * ddp_o_22_x;
  const Scalar omega_r_22_y = s_22 * omega_r_21_x + c_22 * omega_21_z;
  const Scalar omega_22_z = qd_22 - t170;
  const Scalar t173 = omega_22_z * omega_22_z;
  const Scalar U_22_xx = t173 + omega_r_22_y * omega_r_22_y;
  const Scalar t174 = s_22 * omega_21_z - c_22 * omega_r_21_x;
  const Scalar t175 = t174 * omega_r_22_y;
  const Scalar U_22_xy = domega_21_y + t175;
  const Scalar ddp_o_23_x = ddp_22_x - Scalar(0.004) * U_22_xx - Scalar(0.239) * U_22_xy;
  const Scalar t176 = s_21 * t169 + c_21 * t165;
  const Scalar t177 = omega_r_21_x * t170;
  const Scalar domega_20_y = qd_20 * omega_r_20_x - s_20 * domega_15_y - c_20 * t167;
  const Scalar U_21_yx = domega_20_y + t177;
  const Scalar t178 = t176 + Scalar(0.004) * U_21_yx;
  const Scalar domega_21_x = qd_21 * t170 + s_21 * domega_20_x + c_21 * domega_19_y;
  const Scalar domega_22_y = qd_22 * t174 + s_22 * domega_21_x + c_22 * domega_20_y;
  const Scalar t179 = t174 * omega_22_z;
  const Scalar U_22_zx = domega_22_y + t179;
  const Scalar domega_22_x = qd_22 * omega_r_22_y - s_22 * domega_20_y + c_22 * domega_21_x;
  const Scalar t180 = omega_r_22_y * omega_22_z;
  const Scalar U_22_zy = domega_22_x + t180;
  const Scalar t181 = t178 - Scalar(0.004) * U_22_zx + Scalar(0.239) * U_22_zy;
  const Scalar ddp_23_x = s_23 * ddp_o_23_x - c_23 * t181;
  const Scalar t182 = s_22 * ddp_o_22_x - c_22 * ddp_o_22_z;
  const Scalar U_22_yx = domega_21_y - t175;
  const Scalar U_22_yy = t173 + t174 * t174;
  const Scalar t183 = t182 + Scalar(0.004) * U_22_yx - Scalar(0.239) * U_22_yy;
  const Scalar t184 = s_24 * ddp_23_x + c_24 * t183;
  const Scalar omega_r_23_x = s_23 * t174 + c_23 * omega_22_z;
  const Scalar omega_23_z = qd_23 + omega_r_22_y;
  const Scalar omega_r_24_x = s_24 * omega_23_z + c_24 * omega_r_23_x;
  const Scalar omega_r_23_y = s_23 * omega_22_z - c_23 * t174;
  const Scalar omega_24_z = qd_24 + omega_r_23_y;
  const Scalar t185 = s_25 * omega_24_z - c_25 * omega_r_24_x;
  const Scalar t186 = s_24 * omega_r_23_x - c_24 * omega_23_z;
  const Scalar domega_23_x = qd_23 * omega_r_23_y - s_23 * domega_22_x + c_23 * domega_21_y;
  const Scalar domega_24_x = qd_24 * t186 + s_24 * domega_22_y + c_24 * domega_23_x;
  const Scalar t187 = qd_23 * omega_r_23_x - s_23 * domega_21_y - c_23 * domega_22_x;
  const Scalar domega_25_x = qd_25 * t185 + s_25 * domega_24_x - c_25 * t187;
  const Scalar omega_25_z = qd_25 - t186;
  const Scalar t188 = omega_25_z * omega_25_z;
  const Scalar t189 = t185 * omega_25_z;
  const Scalar t190 = Scalar(0.0094) * t184 - Scalar(0.0005096) * domega_25_x +
      Scalar(0.0014129000000002) * t189 + Scalar(0.0007482) * (t188 - t185 * t185);
  const Scalar t191 = s_24 * t183 - c_24 * ddp_23_x;
  const Scalar omega_r_25_x = s_25 * omega_r_24_x + c_25 * omega_24_z;
  const Scalar t192 = omega_r_25_x * t185;
  const Scalar domega_24_y = qd_24 * omega_r_24_x - s_24 * domega_23_x + c_24 * domega_22_y;
  const Scalar U_25_xy = domega_24_y - t192;
  const Scalar t193 = omega_r_25_x * omega_25_z;
  const Scalar N_25_y = Scalar(0.0007482) * U_25_xy + Scalar(0.0019225000000002) * t193;
  const Scalar t194 = omega_r_24_x * t186;
  const Scalar n_24 = Scalar(0.0258331000000002) * t187 - Scalar(0.1902) * t191 +
      Scalar(0.0255131000000002) * t194 + s_25 * N_25_y - c_25 * t190;
  n[23] = n_24;
  const Scalar t195 = s_23 * t181 + c_23 * ddp_o_23_x;
  const Scalar ddp_25_x = s_25 * t191 + c_25 * t195;
  const Scalar t196 = t193 - qd_25 * omega_r_25_x - s_25 * t187 - c_25 * domega_24_x;
  const Scalar N_25_z = Scalar(0.0014129000000002) * domega_24_y - Scalar(0.0094) * ddp_25_x +
      Scalar(0.0005096) * t192 - Scalar(0.0007482) * t196;
  n[24] = -N_25_z;
  const Scalar t197 = s_30 * t143 + c_30 * ddp_o_30_x;
  const Scalar ddp_32_x = s_32 * t154 + c_32 * t197;
  const Scalar t198 = t156 - qd_32 * omega_r_32_x - s_32 * t150 - c_32 * domega_31_x;
  const Scalar N_32_z = Scalar(0.0014129000000002) * domega_31_y + Scalar(0.0094) * ddp_32_x +
      Scalar(0.0005096) * t155 + Scalar(0.0007482) * t198;
  n[31] = -N_32_z;
  const Scalar mu_31_y = N_32_z + Scalar(0.00032) * omega_r_31_x * omega_31_z;
  const Scalar t199 = t149 * omega_31_z;
  const Scalar t200 = Scalar(0.1902) * t197 - Scalar(0.0255131000000002) * domega_31_x -
      Scalar(0.0258331000000002) * t199 + s_32 * t153 + c_32 * t157;
  const Scalar mu_30_z = Scalar(0.00096) * domega_29_y - s_31 * t200 + c_31 * mu_31_y -
      Scalar(0.00032) * omega_r_30_x * omega_r_30_y;
  n[29] = -mu_30_z;
  const Scalar mu_24_y = N_25_z + Scalar(0.00032) * omega_r_24_x * omega_24_z;
  const Scalar t201 = t186 * omega_24_z;
  const Scalar t202 = Scalar(0.1902) * t195 - Scalar(0.0255131000000002) * domega_24_x -
      Scalar(0.0258331000000002) * t201 - s_25 * t190 - c_25 * N_25_y;
  const Scalar mu_23_z = Scalar(0.00096) * domega_22_y - s_24 * t202 + c_24 * mu_24_y -
      Scalar(0.00032) * omega_r_23_x * omega_r_23_y;
  n[22] = -mu_23_z;
  const Scalar mu_30_x = Scalar(0.00032) * domega_30_x - s_31 * mu_31_y - c_31 * t200 +
      Scalar(0.00096) * omega_r_30_y * omega_30_z;
  const Scalar t203 = n_31 + Scalar(0.00064) * omega_r_30_x * omega_30_z;
  const Scalar U_32_yy = t151 + omega_r_32_x * omega_r_32_x;
  const Scalar t204 = Scalar(0.1902) * (t150 + t158) -
      Scalar(0.0094) * (s_32 * U_32_xy - c_32 * U_32_yy);
  const Scalar U_32_zy = domega_32_x + t152;
  const Scalar U_31_yy = omega_31_z * omega_31_z + omega_r_31_x * omega_r_31_x;
  const Scalar f_31_y = Scalar(0.1902) * U_31_yy + Scalar(0.0094) * U_32_zy;
  const Scalar f_u_31_t_x = s_31 * f_31_y - c_31 * t204;
  const Scalar U_31_zy = domega_31_x + t199;
  const Scalar f_31_z = Scalar(0.1902) * U_31_zy -
      Scalar(0.0094) * (s_32 * U_32_yy + c_32 * U_32_xy);
  const Scalar f_u_30_t_x = s_30 * f_u_31_t_x + c_30 * f_31_z;
  const Scalar f_u_31_t_y = s_31 * t204 + c_31 * f_31_y;
  const Scalar U_29_xx_yy = U_29_xx - U_29_yy;
  const Scalar mu_29_z = Scalar(0.2045534) * domega_28_y - Scalar(0.8648) * ddp_29_x +
      Scalar(0.0328) * t145 + Scalar(0.200951) * t137 + Scalar(0.0050592) * U_29_xx_yy -
      Scalar(0.004) * f_u_31_t_y + Scalar(0.239) * f_u_30_t_x - s_30 * t203 + c_30 * mu_30_x;
  n[28] = -mu_29_z;
  const Scalar mu_23_x = Scalar(0.00032) * domega_23_x - s_24 * mu_24_y - c_24 * t202 +
      Scalar(0.00096) * omega_r_23_y * omega_23_z;
  const Scalar t205 = n_24 + Scalar(0.00064) * omega_r_23_x * omega_23_z;
  const Scalar U_25_yy = t188 + omega_r_25_x * omega_r_25_x;
  const Scalar t206 = Scalar(0.1902) * (t187 + t194) +
      Scalar(0.0094) * (s_25 * U_25_xy - c_25 * U_25_yy);
  const Scalar U_25_zy = domega_25_x + t189;
  const Scalar U_24_yy = omega_24_z * omega_24_z + omega_r_24_x * omega_r_24_x;
  const Scalar f_24_y = Scalar(0.1902) * U_24_yy - Scalar(0.0094) * U_25_zy;
  const Scalar f_u_24_t_x = s_24 * f_24_y - c_24 * t206;
  const Scalar U_24_zy = domega_24_x + t201;
  const Scalar f_24_z = Scalar(0.1902) * U_24_zy +
      Scalar(0.0094) * (s_25 * U_25_yy + c_25 * U_25_xy);
  const Scalar f_u_23_t_x = s_23 * f_u_24_t_x + c_23 * f_24_z;
  const Scalar f_u_24_t_y = s_24 * t206 + c_24 * f_24_y;
  const Scalar U_22_xx_yy = U_22_xx - U_22_yy;
  const Scalar mu_22_z = Scalar(0.2045534) * domega_21_y - Scalar(0.8648) * ddp_22_x +
      Scalar(0.0328) * t182 + Scalar(0.200951) * t175 + Scalar(0.0050592) * U_22_xx_yy -
      Scalar(0.004) * f_u_24_t_y + Scalar(0.239) * f_u_23_t_x - s_23 * t205 + c_23 * mu_23_x;
  n[21] = -mu_22_z;
  const Scalar t207 = s_30 * f_31_z - c_30 * f_u_31_t_x;
  const Scalar t208 = Scalar(0.8648) * t140 + Scalar(0.200951) * domega_29_x -
      Scalar(0.0050592) * U_29_zx + Scalar(0.2045534) * t142 - Scalar(0.239) * t207 -
      s_30 * mu_30_x - c_30 * t203;
  const Scalar t209 = Scalar(0.0328) * t140 - Scalar(0.0036024) * t141 +
      Scalar(0.0050592) * U_29_zy - mu_30_z - Scalar(0.004) * t207;
  const Scalar f_29_z = Scalar(0.0328) * U_29_zx - Scalar(0.8648) * U_29_zy + t207;
  const Scalar t210 = t132 * omega_28_z;
  const Scalar U_28_yz = domega_28_x - t210;
  const Scalar mu_28_z = Scalar(0.0097684) * domega_27_y - Scalar(0.0032) * t138 -
      Scalar(0.001934) * t139 + Scalar(0.0023) * U_28_yz - Scalar(0.004) * f_29_z - s_29 * t208 -
      c_29 * t209;
  n[27] = -mu_28_z;
  const Scalar t211 = s_23 * f_24_z - c_23 * f_u_24_t_x;
  const Scalar t212 = Scalar(0.8648) * t178 + Scalar(0.200951) * domega_22_x -
      Scalar(0.0050592) * U_22_zx + Scalar(0.2045534) * t180 - Scalar(0.239) * t211 -
      s_23 * mu_23_x - c_23 * t205;
  const Scalar t213 = Scalar(0.0328) * t178 - Scalar(0.0036024) * t179 +
      Scalar(0.0050592) * U_22_zy - mu_23_z - Scalar(0.004) * t211;
  const Scalar f_22_z = Scalar(0.0328) * U_22_zx - Scalar(0.8648) * U_22_zy + t211;
  const Scalar t214 = t170 * omega_21_z;
  const Scalar U_21_yz = domega_21_x - t214;
  const Scalar mu_21_z = Scalar(0.0097684) * domega_20_y - Scalar(0.0032) * t176 -
      Scalar(0.001934) * t177 + Scalar(0.0023) * U_21_yz - Scalar(0.004) * f_22_z - s_22 * t212 -
      c_22 * t213;
  n[20] = -mu_21_z;
  const Scalar mu_28_x = Scalar(0.001934) * domega_28_x + Scalar(0.0023) * U_28_yx +
      Scalar(0.0097684) * t210 - s_29 * t209 + c_29 * t208;
  const Scalar f_29_x = Scalar(0.0328) * U_29_xx + Scalar(0.8648) * U_29_xy + f_u_30_t_x;
  const Scalar f_29_y = Scalar(0.0328) * U_29_yx - Scalar(0.8648) * U_29_yy - f_u_31_t_y;
  const Scalar f_u_29_t_y = s_29 * f_29_x + c_29 * f_29_y;
  const Scalar mu_28_y = Scalar(0.0032) * ddp_o_28_y - Scalar(0.0078344) * t134 +
      Scalar(0.0023) * (t133 - omega_r_28_x * omega_r_28_x) - mu_29_z + Scalar(0.004) * f_u_29_t_y;
  const Scalar f_28_x = Scalar(0.0032) * U_28_xx - s_29 * f_29_y + c_29 * f_29_x;
  const Scalar f_28_y = Scalar(0.0032) * U_28_yx + f_29_z;
  const Scalar f_u_28_t_x = s_28 * f_28_x + c_28 * f_28_y;
  const Scalar mu_27_z = Scalar(0.4797322) * domega_26_y + Scalar(1.661) * t124 -
      Scalar(0.4777722) * t126 - Scalar(0.305) * f_u_28_t_x + s_28 * mu_28_y + c_28 * mu_28_x;
  n[26] = -mu_27_z;
  const Scalar mu_21_x = Scalar(0.001934) * domega_21_x + Scalar(0.0023) * U_21_yx +
      Scalar(0.0097684) * t214 - s_22 * t213 + c_22 * t212;
  const Scalar f_22_x = Scalar(0.0328) * U_22_xx + Scalar(0.8648) * U_22_xy + f_u_23_t_x;
  const Scalar f_22_y = Scalar(0.0328) * U_22_yx - Scalar(0.8648) * U_22_yy - f_u_24_t_y;
  const Scalar f_u_22_t_y = s_22 * f_22_x + c_22 * f_22_y;
  const Scalar mu_21_y = Scalar(0.0032) * ddp_o_21_y - Scalar(0.0078344) * t172 +
      Scalar(0.0023) * (t171 - omega_r_21_x * omega_r_21_x) - mu_22_z + Scalar(0.004) * f_u_22_t_y;
  const Scalar f_21_x = Scalar(0.0032) * U_21_xx - s_22 * f_22_y + c_22 * f_22_x;
  const Scalar f_21_y = Scalar(0.0032) * U_21_yx + f_22_z;
  const Scalar f_u_21_t_x = s_21 * f_21_x + c_21 * f_21_y;
  const Scalar mu_20_z = Scalar(0.4797322) * domega_19_y + Scalar(1.661) * t162 -
      Scalar(0.4777722) * t164 - Scalar(0.305) * f_u_21_t_x + s_21 * mu_21_y + c_21 * mu_21_x;
  n[19] = -mu_20_z;
  const Scalar t215 = s_28 * f_28_y - c_28 * f_28_x;
  const Scalar t216 = Scalar(1.661) * t128 + Scalar(0.4777722) * domega_27_x +
      Scalar(0.4797322) * t130 - Scalar(0.305) * t215 + s_28 * mu_28_x - c_28 * mu_28_y;
  const Scalar mu_27_y = mu_28_z + Scalar(0.00196) * omega_r_27_x * omega_27_z;
  const Scalar t217 = Scalar(0.00196) * omega_r_26_x;
  const Scalar t218 = Scalar(0.00392) * domega_15_y;
  const Scalar n_26 = s_27 * mu_27_y - c_27 * t216 - omega_r_26_y * t217 - t218;
  n[25] = n_26;
  const Scalar t219 = s_21 * f_21_y - c_21 * f_21_x;
  const Scalar t220 = Scalar(1.661) * t166 + Scalar(0.4777722) * domega_20_x +
      Scalar(0.4797322) * t168 - Scalar(0.305) * t219 + s_21 * mu_21_x - c_21 * mu_21_y;
  const Scalar mu_20_y = mu_21_z + Scalar(0.00196) * omega_r_20_x * omega_20_z;
  const Scalar t221 = Scalar(0.00196) * omega_r_19_x;
  const Scalar mu_19_z = t218 - s_20 * mu_20_y + c_20 * t220 + omega_r_19_y * t221;
  n[18] = -mu_19_z;
  const Scalar f_27_x = Scalar(1.661) * U_27_xy - f_u_28_t_x;
  const Scalar f_27_y = Scalar(1.661) * U_27_yy - Scalar(0.0032) * U_28_zx - f_u_29_t_y;
  const Scalar t222 = s_27 * f_27_x - c_27 * f_27_y;
  const Scalar f_27_z = Scalar(1.661) * U_27_zy - t215;
  const Scalar f_20_x = Scalar(1.661) * U_20_xy - f_u_21_t_x;
  const Scalar f_20_y = Scalar(1.661) * U_20_yy - Scalar(0.0032) * U_21_zx - f_u_22_t_y;
  const Scalar t223 = s_20 * f_20_x - c_20 * f_20_y;
  const Scalar f_20_z = Scalar(1.661) * U_20_zy - t219;
  const Scalar t224 = (s_26 * f_27_z + c_26 * t222) - (s_19 * f_20_z + c_19 * t223);
  const Scalar t225 = Scalar(0.00196) * t167 - s_20 * t220 - c_20 * mu_20_y +
      Scalar(0.00392) * omega_r_19_y * omega_19_z;
  const Scalar t226 = Scalar(0.00196) * t129 - s_27 * t216 - c_27 * mu_27_y +
      Scalar(0.00392) * omega_r_26_y * omega_26_z;
  const Scalar mu_19_y = mu_20_z + omega_19_z * t221;
  const Scalar mu_26_y = mu_27_z + omega_26_z * t217;
  const Scalar f_u_27_t_y = s_27 * f_27_y + c_27 * f_27_x;
  const Scalar f_u_20_t_y = s_20 * f_20_y + c_20 * f_20_x;
  const Scalar F_18_x = Scalar(0.02) * U_18_xx - Scalar(0.22) * (t27 - t26);
  const Scalar t227 = Scalar(0.02) * (t27 + t26) + Scalar(0.22) * U_18_yy;
  const Scalar f_u_18_t_x = s_18 * F_18_x - c_18 * t227;
  const Scalar F_18_z = Scalar(0.02) * U_18_zx - Scalar(0.22) * U_18_zy;
  const Scalar f_u_17_t_x = s_17 * f_u_18_t_x + c_17 * F_18_z;
  const Scalar f_u_18_t_y = s_18 * t227 + c_18 * F_18_x;
  const Scalar f_u_16_t_x = s_16 * f_u_18_t_y + c_16 * f_u_17_t_x;
  const Scalar mu_16_x = Scalar(0.0005) * domega_16_x - s_17 * mu_17_x - c_17 * t97 +
      Scalar(0.001125) * omega_r_16_y * omega_16_z;
  const Scalar t228 = mu_17_z + Scalar(0.000625) * t23 * omega_16_z;
  const Scalar t229 = Scalar(89.72226) * t7 - Scalar(1.972772833332667) * t12 +
      Scalar(4.062559499999667) * t13 - Scalar(0.043998) * U_15_yz - Scalar(0.453) * f_u_16_t_x +
      Scalar(0.24) * t224 - Scalar(0.33) * (f_u_27_t_y + f_u_20_t_y) - s_16 * mu_16_x +
      c_16 * t228 - s_19 * t225 + c_19 * mu_19_y - s_26 * t226 + c_26 * mu_26_y;
  n[14] = -t229;
  const Scalar t230 = s_26 * t222 - c_26 * f_27_z;
  const Scalar t231 = s_19 * t223 - c_19 * f_20_z;
  const Scalar mu_15_x = Scalar(1.972772833332667) * domega_15_x - Scalar(0.043998) * t14 -
      Scalar(4.062559499999667) * t11 - mu_16_z + Scalar(0.003) * f_u_16_t_x +
      Scalar(0.24) * (t230 - t231) + s_19 * mu_19_y + c_19 * t225 + s_26 * mu_26_y + c_26 * t226;
  const Scalar t232 = s_16 * f_u_17_t_x - c_16 * f_u_18_t_y;
  const Scalar t233 = s_17 * F_18_z - c_17 * f_u_18_t_x;
  const Scalar U_15_zz_xx = U_15_xx - U_15_zz;
  const Scalar mu_15_y = Scalar(89.72226) * s_14 + Scalar(6.035332333332334) * t6 -
      Scalar(0.043998) * U_15_zz_xx - n_26 + mu_19_z + Scalar(0.003) * t233 - Scalar(0.453) * t232 +
      Scalar(0.33) * (t230 + t231) + s_16 * t228 + c_16 * mu_16_x;
  const Scalar t234 = c_14 * (qd_13 * t5 - Scalar(0.6119232795934959));
  n[13] = Scalar(3.062001499999667) * t234 - s_15 * mu_15_x - c_15 * mu_15_y;
  const Scalar t235 = c_14 * (Scalar(6.126452999999334) * t4 + s_15 * mu_15_y - c_15 * mu_15_x);
  const Scalar mu_14_y = Scalar(0.00245) * t13 + t229;
  n[12] = s_14 * mu_14_y - t235;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[32]    in   joint positions, rad or m
//   qd[32]   in   joint velocities, rad/s or m/s
//   tau[32]  in   joint torques or forces, N m or N
//   qdd[32]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns true, or false if the result means nothing: a pivot was not positive, or an input not a
// number.
// Reads q[0..11], q[13..31], qd[0..31], tau[0..31]. Operations: 2939 mul, 2240 add, 27 div, 62
// sin/cos.
template <class Scalar>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau,
    Scalar* qdd) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6],
      q_8 = q[7], q_9 = q[8], q_10 = q[9], q_11 = q[10], q_12 = q[11], q_14 = q[13], q_15 = q[14],
      q_16 = q[15], q_17 = q[16], q_18 = q[17], q_19 = q[18], q_20 = q[19], q_21 = q[20],
      q_22 = q[21], q_23 = q[22], q_24 = q[23], q_25 = q[24], q_26 = q[25], q_27 = q[26],
      q_28 = q[27], q_29 = q[28], q_30 = q[29], q_31 = q[30], q_32 = q[31];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11],
      qd_13 = qd[12], qd_14 = qd[13], qd_15 = qd[14], qd_16 = qd[15], qd_17 = qd[16],
      qd_18 = qd[17], qd_19 = qd[18], qd_20 = qd[19], qd_21 = qd[20], qd_22 = qd[21],
      qd_23 = qd[22], qd_24 = qd[23], qd_25 = qd[24], qd_26 = qd[25], qd_27 = qd[26],
      qd_28 = qd[27], qd_29 = qd[28], qd_30 = qd[29], qd_31 = qd[30], qd_32 = qd[31];
  const Scalar tau_1 = tau[0], tau_2 = tau[1], tau_3 = tau[2], tau_4 = tau[3], tau_5 = tau[4],
      tau_6 = tau[5], tau_7 = tau[6], tau_8 = tau[7], tau_9 = tau[8], tau_10 = tau[9],
      tau_11 = tau[10], tau_12 = tau[11], tau_13 = tau[12], tau_14 = tau[13], tau_15 = tau[14],
      tau_16 = tau[15], tau_17 = tau[16], tau_18 = tau[17], tau_19 = tau[18], tau_20 = tau[19],
      tau_21 = tau[20], tau_22 = tau[21], tau_23 = tau[22], tau_24 = tau[23], tau_25 = tau[24],
      tau_26 = tau[25], tau_27 = tau[26], tau_28 = tau[27], tau_29 = tau[28], tau_30 = tau[29],
      tau_31 = tau[30], tau_32 = tau[31];
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
  const Scalar s_14 = sin(q_14), c_14 = cos(q_14);
  const Scalar s_15 = sin(q_15), c_15 = cos(q_15);
  const Scalar s_16 = sin(q_16), c_16 = cos(q_16);
  const Scalar s_17 = sin(q_17), c_17 = cos(q_17);
  const Scalar s_18 = sin(q_18), c_18 = cos(q_18);
  const Scalar s_19 = sin(q_19), c_19 = cos(q_19);
  const Scalar s_20 = sin(q_20), c_20 = cos(q_20);
  const Scalar s_21 = sin(q_21), c_21 = cos(q_21);
  const Scalar s_22 = sin(q_22), c_22 = cos(q_22);
  const Scalar s_23 = sin(q_23), c_23 = cos(q_23);
  const Scalar s_24 = sin(q_24), c_24 = cos(q_24);
  const Scalar s_25 = sin(q_25), c_25 = cos(q_25);
  const Scalar s_26 = sin(q_26), c_26 = cos(q_26);
  const Scalar s_27 = sin(q_27), c_27 = cos(q_27);
  const Scalar s_28 = sin(q_28), c_28 = cos(q_28);
  const Scalar s_29 = sin(q_29), c_29 = cos(q_29);
  const Scalar s_30 = sin(q_30), c_30 = cos(q_30);
  const Scalar s_31 = sin(q_31), c_31 = cos(q_31);
  const Scalar s_32 = sin(q_32), c_32 = cos(q_32);
  const Scalar t1 = c_2 * qd_1;
  const Scalar omega_r_3_x = c_3 * qd_2 + s_3 * t1;
  const Scalar t2 = s_2 * qd_1;
  const Scalar omega_3_z = qd_3 - t2;
  const Scalar omega_r_4_x = c_4 * omega_3_z + s_4 * omega_r_3_x;
  const Scalar t3 = c_3 * t1 - s_3 * qd_2;
  const Scalar omega_4_z = qd_4 + t3;
  const Scalar t4 = c_5 * omega_r_4_x - s_5 * omega_4_z;
  const Scalar t5 = c_4 * omega_r_3_x - s_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 + t5;
  const Scalar omega_r_6_x = c_6 * omega_5_z - s_6 * t4;
  const Scalar omega_r_6_y = c_6 * t4 + s_6 * omega_5_z;
  const Scalar t6 = omega_r_6_x * omega_r_6_y;
  const Scalar t7 = qd_2 * t2;
  const Scalar domega_3_x = s_3 * t7 - qd_3 * t3;
  const Scalar t8 = qd_2 * t1;
  const Scalar domega_4_x = c_4 * t8 + s_4 * domega_3_x - qd_4 * t5;
  const Scalar domega_3_y = c_3 * t7 + qd_3 * omega_r_3_x;
  const Scalar domega_5_y = c_5 * domega_3_y + s_5 * domega_4_x - qd_5 * t4;
  const Scalar U_6_yx = domega_5_y + t6;
  const Scalar omega_r_5_y = c_5 * omega_4_z + s_5 * omega_r_4_x;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t9 = omega_6_z * omega_6_z;
  const Scalar U_6_yy = t9 + omega_r_6_x * omega_r_6_x;
  const Scalar F_6_y = Scalar(0.045) * U_6_yx + Scalar(0.105) * U_6_yy;
  const Scalar U_6_xx = omega_r_6_y * omega_r_6_y + t9;
  const Scalar U_6_xy = domega_5_y - t6;
  const Scalar F_6_x = Scalar(0.045) * U_6_xx - Scalar(0.105) * U_6_xy;
  const Scalar f_u_6_t_x = c_6 * F_6_y + s_6 * F_6_x;
  const Scalar domega_5_x = c_5 * domega_4_x - s_5 * domega_3_y + qd_5 * omega_r_5_y;
  const Scalar domega_4_y = c_4 * domega_3_x - s_4 * t8 + qd_4 * omega_r_4_x;
  const Scalar t10 = c_6 * domega_5_x + s_6 * domega_4_y - qd_6 * omega_r_6_x;
  const Scalar t11 = omega_r_6_x * omega_6_z;
  const Scalar t12 = t10 - t11;
  const Scalar U_6_zy = c_6 * domega_4_y - s_6 * domega_5_x + omega_r_6_y * (qd_6 + omega_6_z);
  const Scalar t13 = Scalar(0.045) * t12 + Scalar(0.105) * U_6_zy;
  const Scalar f_u_5_t_y = c_5 * t13 + s_5 * f_u_6_t_x;
  const Scalar t14 = omega_r_4_x * omega_4_z;
  const Scalar U_4_zx = domega_4_y + t14;
  const Scalar t15 = Scalar(1.3725) * U_4_zx + f_u_5_t_y;
  const Scalar t16 = omega_r_3_x * omega_3_z;
  const Scalar U_3_zx = domega_3_y + t16;
  const Scalar U_2_yy = t1 * t1 + qd_2 * qd_2;
  const Scalar t17 = Scalar(9.81) * c_1;
  const Scalar ddp_o_3_y = Scalar(0.389) * U_2_yy + c_2 * t17;
  const Scalar ddp_o_4_z = ddp_o_3_y - Scalar(0.02) * U_3_zx;
  const Scalar t18 = omega_3_z * omega_3_z;
  const Scalar U_3_xx = t3 * t3 + t18;
  const Scalar ddp_o_3_z = Scalar(9.81) * s_1 - Scalar(0.778) * t7;
  const Scalar t19 = t1 * t2;
  const Scalar ddp_o_3_x = s_2 * t17 + Scalar(0.389) * t19;
  const Scalar t20 = Scalar(0.02) * U_3_xx - c_3 * ddp_o_3_z + s_3 * ddp_o_3_x;
  const Scalar ddp_4_x = c_4 * ddp_o_4_z + s_4 * t20;
  const Scalar t21 = omega_4_z * omega_4_z;
  const Scalar U_4_xx = t5 * t5 + t21;
  const Scalar t22 = omega_r_4_x * t5;
  const Scalar U_4_xy = domega_3_y + t22;
  const Scalar ddp_o_5_x = ddp_4_x + Scalar(0.357) * U_4_xx + Scalar(0.04) * U_4_xy;
  const Scalar t23 = t5 * omega_4_z;
  const Scalar U_4_zy = domega_4_x - t23;
  const Scalar ddp_3_y = c_3 * ddp_o_3_x + s_3 * ddp_o_3_z;
  const Scalar t24 = omega_r_3_x * t3;
  const Scalar U_3_yx = t8 - t24;
  const Scalar ddp_o_4_y = ddp_3_y + Scalar(0.02) * U_3_yx;
  const Scalar t25 = ddp_o_4_y - Scalar(0.04) * U_4_zy;
  const Scalar t26 = Scalar(0.357) * U_4_zx - t25;
  const Scalar t27 = c_5 * ddp_o_5_x + s_5 * t26;
  const Scalar t28 = c_4 * t20 - s_4 * ddp_o_4_z;
  const Scalar U_4_yx = domega_3_y - t22;
  const Scalar U_4_yy = t21 + omega_r_4_x * omega_r_4_x;
  const Scalar t29 = t28 + Scalar(0.357) * U_4_yx - Scalar(0.04) * U_4_yy;
  const Scalar t30 = c_6 * t29 - s_6 * t27;
  const Scalar t31 = c_6 * t27 + s_6 * t29;
  const Scalar U_6_xx_yy = U_6_xx - U_6_yy;
  const Scalar N_6_z = Scalar(0.01431666666667) * domega_5_y + Scalar(0.105) * t30 +
      Scalar(0.045) * t31 - Scalar(0.0012) * t6 - Scalar(0.00315) * U_6_xx_yy;
  const Scalar mu_5_y = Scalar(0.00876666666667) * domega_5_y - N_6_z +
      Scalar(0.00940666666667) * t4 * omega_5_z;
  const Scalar t32 = c_5 * t26 - s_5 * ddp_o_5_x;
  const Scalar t33 = Scalar(0.045) * t32 - Scalar(0.0012) * t10 - Scalar(0.01431666666667) * t11 +
      Scalar(0.00315) * U_6_zy;
  const Scalar t34 = Scalar(0.105) * t32 + Scalar(0.00315) * t12 +
      Scalar(0.01551666666667) * omega_r_6_y * omega_6_z;
  const Scalar mu_5_x = Scalar(0.01817333333334) * omega_r_5_y * omega_5_z + c_6 * t33 - s_6 * t34;
  const Scalar mu_4_x = Scalar(0.22) * ddp_o_4_y + Scalar(0.04766333333334) * t23 -
      Scalar(0.04) * t15 - c_5 * mu_5_x + s_5 * mu_5_y;
  const Scalar f_4_z = Scalar(0.22) * U_4_zy + t15;
  const Scalar mu_5_z = Scalar(0.00940666666667) * domega_4_y -
      Scalar(0.00876666666667) * t4 * omega_r_5_y + c_6 * t34 + s_6 * t33;
  const Scalar t35 = Scalar(0.40049083333333) * domega_4_y + Scalar(0.44815416666667) * t14 -
      Scalar(1.3725) * t25 + mu_5_z + Scalar(0.357) * f_u_5_t_y;
  const Scalar t36 = t3 * omega_3_z;
  const Scalar U_3_yz = domega_3_x + t36;
  const Scalar mu_3_z = Scalar(0.08) * ddp_3_y + Scalar(0.03800666666667) * t8 +
      Scalar(0.02175666666667) * t24 - Scalar(0.00507) * U_3_yz - Scalar(0.02) * f_4_z -
      c_4 * mu_4_x - s_4 * t35;
  const Scalar f_u_5_t_x = c_5 * f_u_6_t_x - s_5 * t13;
  const Scalar t37 = c_6 * F_6_x - s_6 * F_6_y;
  const Scalar U_4_xx_yy = U_4_xx - U_4_yy;
  const Scalar mu_4_z = Scalar(0.44815416666667) * domega_3_y + Scalar(0.22) * ddp_4_x +
      Scalar(1.3725) * t28 - Scalar(0.40049083333333) * t22 + Scalar(0.0549) * U_4_xx_yy -
      Scalar(0.357) * t37 + Scalar(0.04) * f_u_5_t_x - c_5 * mu_5_y - s_5 * mu_5_x;
  const Scalar y_6 = tau_6 + N_6_z;
  const Scalar hu_6_t_y = Scalar(0.045) * c_6 - Scalar(0.105) * s_6;
  const Scalar t38 = Scalar(0.04) * hu_6_t_y + Scalar(0.01431666666667);
  const Scalar hu_6_t_x = Scalar(0.105) * c_6 + Scalar(0.045) * s_6;
  const Scalar t39 = Scalar(0.357) * hu_6_t_x;
  const Scalar mu_6_4_z = t39 + c_5 * t38;
  const Scalar t40 = Scalar(69.84866123397676) * mu_6_4_z;
  const Scalar y_5 = tau_5 + mu_5_z;
  const Scalar Iu_6_t_g = Scalar(0.0063) * c_6 - Scalar(0.0012) * s_6;
  const Scalar t41 = s_6 * Iu_6_t_g;
  const Scalar Ic_5_zz = t41 + Scalar(0.00940666666667);
  const Scalar d_5 = Scalar(1.0) / Ic_5_zz;
  const Scalar t42 = Scalar(0.04) * hu_6_t_x + c_6 * Iu_6_t_g - Scalar(0.00315);
  const Scalar t43 = s_5 * t42;
  const Scalar t44 = d_5 * t43;
  const Scalar y_5_4 = tau_4 + mu_4_z - y_6 * t40 + y_5 * t44;
  const Scalar Iu_6_t_xx = t41 + Scalar(0.0012);
  const Scalar Iu_5_t_d = Iu_6_t_xx + Scalar(0.00555);
  const Scalar t45 = c_5 * Iu_5_t_d;
  const Scalar t46 = t45 + t39;
  const Scalar t47 = c_4 * t46 + s_4 * t42;
  const Scalar t48 = s_5 * t47;
  const Scalar t49 = c_5 * t42;
  const Scalar t50 = c_5 * hu_6_t_x;
  const Scalar mu_5_4_y = Ic_5_zz + Scalar(0.357) * t50;
  const Scalar mu_5_3_z = Scalar(0.02) * t50 - c_4 * t49 + s_4 * mu_5_4_y;
  const Scalar t51 = mu_5_3_z * d_5;
  const Scalar t52 = Scalar(0.357) * hu_6_t_y;
  const Scalar t53 = s_5 * (c_4 * t38 - t52 * (s_4 + Scalar(0.056022408963585436)));
  const Scalar t54 = t53 * t40 + t43 * t51 - t48;
  const Scalar t55 = c_5 * t45;
  const Scalar t56 = Scalar(0.714) * t50;
  const Scalar t57 = Scalar(0.08) * hu_6_t_y;
  const Scalar t58 = Iu_6_t_xx - t55 - t57 - t56 - Scalar(0.44815416666667);
  const Scalar t59 = t58 + mu_6_4_z * t40 + t43 * t44;
  const Scalar t60 = Scalar(1.0) / t59;
  const Scalar t61 = t54 * t60;
  const Scalar t62 = Scalar(-69.84866123397676) * t53;
  const Scalar y_4_3 = tau_3 + mu_3_z + y_6 * t62 + y_5 * t51 - t61 * y_5_4;
  const Scalar t63 = t55 - t57 - Scalar(0.00555);
  const Scalar Ic_4_yy = Ic_5_zz + t56 + Scalar(0.40049083333333);
  const Scalar Ic_4_xy = t49 + t52 + Scalar(0.0549);
  const Scalar t64 = Scalar(2.0) * c_4 * Ic_4_xy - s_4 * (t63 + Ic_4_yy);
  const Scalar hc_4_x = t50 + Scalar(1.3725);
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.22);
  const Scalar hu_4_t_y = c_4 * hc_4_x + s_4 * hc_4_y;
  const Scalar Ic_3_xz = Ic_4_xy + Scalar(0.02) * hu_4_t_y - c_4 * t64 + Scalar(0.00507);
  const Scalar t65 = s_3 * s_5;
  const Scalar t66 = c_4 * hc_4_y - s_4 * hc_4_x;
  const Scalar t67 = t66 - Scalar(0.08);
  const Scalar t68 = c_3 * t67 - hu_6_t_x * t65;
  const Scalar t69 = Scalar(0.389) * t68 - c_3 * Ic_3_xz - t47 * t65;
  const Scalar mu_u_5_4_t_x = c_4 * mu_5_4_y + s_4 * t49;
  const Scalar t70 = Scalar(0.02) * hu_6_t_x;
  const Scalar t71 = t42 - c_4 * t70;
  const Scalar t72 = Scalar(0.389) * hu_6_t_x;
  const Scalar t73 = (c_3 * c_5 + s_4 * t65) * t72;
  const Scalar mu_5_2_z = c_3 * mu_u_5_4_t_x + t65 * t71 + t73;
  const Scalar t74 = mu_5_2_z * d_5;
  const Scalar t75 = c_4 * t42 - s_4 * t46;
  const Scalar t76 = c_3 * s_5;
  const Scalar t77 = t58 + Scalar(0.02) * t66 - Scalar(0.389) * hu_4_t_y;
  const Scalar t78 = c_5 * hu_6_t_y;
  const Scalar f_u_6_4_t_x = s_4 * t78 + c_4 * hu_6_t_x;
  const Scalar t79 = hu_6_t_y * t76 - s_3 * f_u_6_4_t_x;
  const Scalar mu_6_3_y = mu_6_4_z - Scalar(0.02) * (c_4 * t78 - s_4 * hu_6_t_x);
  const Scalar t80 = c_4 * t52 + s_4 * t38;
  const Scalar t81 = Scalar(0.389) * t79 + t76 * t80 - s_3 * mu_6_3_y;
  const Scalar t82 = t75 * t76 + t81 * t40 - t43 * t74 - s_3 * t77;
  const Scalar t83 = Scalar(-69.84866123397676) * t81;
  const Scalar t84 = t69 + t53 * t83 + mu_5_2_z * t51 + t82 * t61;
  const Scalar t85 = s_4 * t64;
  const Scalar t86 = Scalar(-0.04) * t66;
  const Scalar t87 = t63 + t85 - t86 - Scalar(0.03800666666667);
  const Scalar t88 = t87 - t53 * t62 + mu_5_3_z * t51 - t54 * t61;
  const Scalar t89 = Scalar(1.0) / t88;
  const Scalar t90 = t84 * t89;
  const Scalar f_3_y = Scalar(0.08) * U_3_yx - f_4_z;
  const Scalar f_4_x = Scalar(1.3725) * U_4_xx + Scalar(0.22) * U_4_xy + f_u_5_t_x;
  const Scalar f_4_y = Scalar(1.3725) * U_4_yx - Scalar(0.22) * U_4_yy - t37;
  const Scalar f_3_x = Scalar(0.08) * U_3_xx + c_4 * f_4_y + s_4 * f_4_x;
  const Scalar f_u_3_t_x = c_3 * f_3_y + s_3 * f_3_x;
  const Scalar mu_3_x = Scalar(0.00507) * U_3_yx + Scalar(0.05976333333334) * t36 - c_4 * t35 +
      s_4 * mu_4_x;
  const Scalar t91 = c_4 * f_4_x - s_4 * f_4_y;
  const Scalar mu_3_y = Scalar(0.08) * ddp_o_3_y + Scalar(0.02175666666667) * domega_3_y -
      Scalar(0.03800666666667) * t16 - Scalar(0.00507) * (t18 - omega_r_3_x * omega_r_3_x) -
      mu_4_z + Scalar(0.02) * t91;
  const Scalar t92 = t82 * t60;
  const Scalar y_3_2 = tau_2 - Scalar(1.03624716666667) * t19 - Scalar(0.389) * f_u_3_t_x -
      c_3 * mu_3_x + s_3 * mu_3_y + y_6 * t83 - y_5 * t74 - t92 * y_5_4 + t90 * y_4_3 -
      Scalar(27.463095) * c_1 * s_2;
  const Scalar Iu_4_t_xx = Ic_4_yy + t85;
  const Scalar t93 = t58 - t86 + Scalar(0.02175666666667);
  const Scalar Iu_3_t_d = Iu_4_t_xx + t93;
  const Scalar t94 = s_5 * t70 - s_5 * t75;
  const Scalar t95 = Scalar(2.0) * c_3 * t94 + s_3 * Iu_3_t_d;
  const Scalar t96 = c_2 * (t94 - c_3 * t95);
  const Scalar t97 = hu_6_t_x * t76 + s_3 * t67;
  const Scalar t98 = c_2 * (Scalar(0.389) * t97 + t47 * t76 - s_3 * Ic_3_xz);
  const Scalar t99 = (s_4 * t76 - s_3 * c_5) * t72;
  const Scalar t100 = c_2 * (t76 * t71 - s_3 * mu_u_5_4_t_x + t99) - s_2 * mu_5_3_z;
  const Scalar t101 = t100 * d_5;
  const Scalar t102 = c_2 * (t75 * t65 + c_3 * t77);
  const Scalar f_u_6_3_t_y = c_3 * f_u_6_4_t_x + hu_6_t_y * t65;
  const Scalar mu_6_2_x = Scalar(0.389) * f_u_6_3_t_y + c_3 * mu_6_3_y + t65 * t80;
  const Scalar mu_u_6_2_t_y = c_2 * mu_6_2_x - s_2 * t53;
  const Scalar t103 = t102 + s_2 * t48 + mu_u_6_2_t_y * t40 + t43 * t101;
  const Scalar t104 = Scalar(69.84866123397676) * mu_u_6_2_t_y;
  const Scalar t105 = t98 + s_2 * t87 - t53 * t104 - t100 * t51 + t103 * t61;
  const Scalar t106 = t96 + s_2 * t69 - mu_u_6_2_t_y * t83 - t100 * t74 - t103 * t92 - t105 * t90;
  const Scalar t107 = s_3 * t95;
  const Scalar t108 = Scalar(0.778) * hu_4_t_y;
  const Scalar b_3_2_2 = Iu_4_t_xx - t107 + t108 + t81 * t83 - mu_5_2_z * t74 + t82 * t92 +
      t84 * t90 + Scalar(1.03820716666667);
  const Scalar d_2 = Scalar(1.0) / b_3_2_2;
  const Scalar t109 = t106 * d_2;
  const Scalar t110 = c_3 * f_3_x - s_3 * f_3_y;
  const Scalar mu_2_x = Scalar(27.463095) * s_1 - Scalar(2.07445433333334) * t7 -
      Scalar(0.389) * t110 + c_3 * mu_3_y + s_3 * mu_3_x;
  const Scalar mu_2_y = Scalar(0.00196) * t8 + mu_3_z;
  const Scalar t111 = t105 * t89;
  const Scalar t112 = t103 * t60;
  const Scalar y_2_1 = tau_1 - c_2 * mu_2_x - s_2 * mu_2_y - y_6 * t104 + y_5 * t101 -
      t112 * y_5_4 + t111 * y_4_3 + t109 * y_3_2;
  const Scalar t113 = t93 - t107 - t108;
  const Scalar t114 = s_2 * (Scalar(2.0) * t98 + s_2 * (t87 - t113 + Scalar(1.03624716666667)));
  const Scalar t115 = t113 + t114 + mu_u_6_2_t_y * t104 + t100 * t101 - t103 * t112 - t105 * t111 +
      t106 * t109 - Scalar(1.04016716666667);
  const Scalar t116 = (Scalar(1.0) / t115) * y_2_1;
  qdd[0] = -t116;
  const Scalar t117 = c_8 * qd_7;
  const Scalar omega_r_9_x = c_9 * qd_8 + s_9 * t117;
  const Scalar t118 = s_8 * qd_7;
  const Scalar omega_9_z = qd_9 - t118;
  const Scalar omega_r_10_x = c_10 * omega_9_z + s_10 * omega_r_9_x;
  const Scalar t119 = c_9 * t117 - s_9 * qd_8;
  const Scalar omega_10_z = qd_10 + t119;
  const Scalar t120 = c_11 * omega_r_10_x - s_11 * omega_10_z;
  const Scalar t121 = c_10 * omega_r_9_x - s_10 * omega_9_z;
  const Scalar omega_11_z = qd_11 + t121;
  const Scalar omega_r_12_x = c_12 * omega_11_z - s_12 * t120;
  const Scalar omega_r_12_y = c_12 * t120 + s_12 * omega_11_z;
  const Scalar t122 = omega_r_12_x * omega_r_12_y;
  const Scalar t123 = qd_8 * t118;
  const Scalar domega_9_x = s_9 * t123 - qd_9 * t119;
  const Scalar t124 = qd_8 * t117;
  const Scalar domega_10_x = c_10 * t124 + s_10 * domega_9_x - qd_10 * t121;
  const Scalar domega_9_y = c_9 * t123 + qd_9 * omega_r_9_x;
  const Scalar domega_11_y = c_11 * domega_9_y + s_11 * domega_10_x - qd_11 * t120;
  const Scalar U_12_yx = domega_11_y + t122;
  const Scalar omega_r_11_y = c_11 * omega_10_z + s_11 * omega_r_10_x;
  const Scalar omega_12_z = qd_12 + omega_r_11_y;
  const Scalar t125 = omega_12_z * omega_12_z;
  const Scalar U_12_yy = t125 + omega_r_12_x * omega_r_12_x;
  const Scalar F_12_y = Scalar(0.045) * U_12_yx + Scalar(0.105) * U_12_yy;
  const Scalar U_12_xx = omega_r_12_y * omega_r_12_y + t125;
  const Scalar U_12_xy = domega_11_y - t122;
  const Scalar F_12_x = Scalar(0.045) * U_12_xx - Scalar(0.105) * U_12_xy;
  const Scalar f_u_12_t_x = c_12 * F_12_y + s_12 * F_12_x;
  const Scalar domega_11_x = c_11 * domega_10_x - s_11 * domega_9_y + qd_11 * omega_r_11_y;
  const Scalar domega_10_y = c_10 * domega_9_x - s_10 * t124 + qd_10 * omega_r_10_x;
  const Scalar t126 = c_12 * domega_11_x + s_12 * domega_10_y - qd_12 * omega_r_12_x;
  const Scalar t127 = omega_r_12_x * omega_12_z;
  const Scalar t128 = t126 - t127;
  const Scalar U_12_zy = c_12 * domega_10_y - s_12 * domega_11_x +
      omega_r_12_y * (qd_12 + omega_12_z);
  const Scalar t129 = Scalar(0.045) * t128 + Scalar(0.105) * U_12_zy;
  const Scalar f_u_11_t_y = c_11 * t129 + s_11 * f_u_12_t_x;
  const Scalar t130 = omega_r_10_x * omega_10_z;
  const Scalar U_10_zx = domega_10_y + t130;
  const Scalar t131 = Scalar(1.3725) * U_10_zx + f_u_11_t_y;
  const Scalar t132 = omega_r_9_x * omega_9_z;
  const Scalar U_9_zx = domega_9_y + t132;
  const Scalar U_8_yy = t117 * t117 + qd_8 * qd_8;
  const Scalar t133 = Scalar(9.81) * c_7;
  const Scalar ddp_o_9_y = Scalar(0.389) * U_8_yy + c_8 * t133;
  const Scalar ddp_o_10_z = ddp_o_9_y - Scalar(0.02) * U_9_zx;
  const Scalar t134 = omega_9_z * omega_9_z;
  const Scalar U_9_xx = t119 * t119 + t134;
  const Scalar ddp_o_9_z = Scalar(9.81) * s_7 - Scalar(0.778) * t123;
  const Scalar t135 = t117 * t118;
  const Scalar ddp_o_9_x = s_8 * t133 + Scalar(0.389) * t135;
  const Scalar t136 = Scalar(0.02) * U_9_xx - c_9 * ddp_o_9_z + s_9 * ddp_o_9_x;
  const Scalar ddp_10_x = c_10 * ddp_o_10_z + s_10 * t136;
  const Scalar t137 = omega_10_z * omega_10_z;
  const Scalar U_10_xx = t121 * t121 + t137;
  const Scalar t138 = omega_r_10_x * t121;
  const Scalar U_10_xy = domega_9_y + t138;
  const Scalar ddp_o_11_x = ddp_10_x + Scalar(0.357) * U_10_xx + Scalar(0.04) * U_10_xy;
  const Scalar t139 = t121 * omega_10_z;
  const Scalar U_10_zy = domega_10_x - t139;
  const Scalar ddp_9_y = c_9 * ddp_o_9_x + s_9 * ddp_o_9_z;
  const Scalar t140 = omega_r_9_x * t119;
  const Scalar U_9_yx = t124 - t140;
  const Scalar ddp_o_10_y = ddp_9_y + Scalar(0.02) * U_9_yx;
  const Scalar t141 = ddp_o_10_y - Scalar(0.04) * U_10_zy;
  const Scalar t142 = Scalar(0.357) * U_10_zx - t141;
  const Scalar t143 = c_11 * ddp_o_11_x + s_11 * t142;
  const Scalar t144 = c_10 * t136 - s_10 * ddp_o_10_z;
  const Scalar U_10_yx = domega_9_y - t138;
  const Scalar U_10_yy = t137 + omega_r_10_x * omega_r_10_x;
  const Scalar t145 = t144 + Scalar(0.357) * U_10_yx - Scalar(0.04) * U_10_yy;
  const Scalar t146 = c_12 * t145 - s_12 * t143;
  const Scalar t147 = c_12 * t143 + s_12 * t145;
  const Scalar U_12_xx_yy = U_12_xx - U_12_yy;
  const Scalar N_12_z = Scalar(0.01431666666667) * domega_11_y + Scalar(0.105) * t146 +
      Scalar(0.045) * t147 - Scalar(0.0012) * t122 - Scalar(0.00315) * U_12_xx_yy;
  const Scalar mu_11_y = Scalar(0.00876666666667) * domega_11_y - N_12_z +
      Scalar(0.00940666666667) * t120 * omega_11_z;
  const Scalar t148 = c_11 * t142 - s_11 * ddp_o_11_x;
  const Scalar t149 = Scalar(0.045) * t148 - Scalar(0.0012) * t126 -
      Scalar(0.01431666666667) * t127 + Scalar(0.00315) * U_12_zy;
  const Scalar t150 = Scalar(0.105) * t148 + Scalar(0.00315) * t128 +
      Scalar(0.01551666666667) * omega_r_12_y * omega_12_z;
  const Scalar mu_11_x = Scalar(0.01817333333334) * omega_r_11_y * omega_11_z + c_12 * t149 -
      s_12 * t150;
  const Scalar mu_10_x = Scalar(0.22) * ddp_o_10_y + Scalar(0.04766333333334) * t139 -
      Scalar(0.04) * t131 - c_11 * mu_11_x + s_11 * mu_11_y;
  const Scalar f_10_z = Scalar(0.22) * U_10_zy + t131;
  const Scalar mu_11_z = Scalar(0.00940666666667) * domega_10_y -
      Scalar(0.00876666666667) * t120 * omega_r_11_y + c_12 * t150 + s_12 * t149;
  const Scalar t151 = Scalar(0.40049083333333) * domega_10_y + Scalar(0.44815416666667) * t130 -
      Scalar(1.3725) * t141 + mu_11_z + Scalar(0.357) * f_u_11_t_y;
  const Scalar t152 = t119 * omega_9_z;
  const Scalar U_9_yz = domega_9_x + t152;
  const Scalar mu_9_z = Scalar(0.08) * ddp_9_y + Scalar(0.03800666666667) * t124 +
      Scalar(0.02175666666667) * t140 - Scalar(0.00507) * U_9_yz - Scalar(0.02) * f_10_z -
      c_10 * mu_10_x - s_10 * t151;
  const Scalar f_u_11_t_x = c_11 * f_u_12_t_x - s_11 * t129;
  const Scalar t153 = c_12 * F_12_x - s_12 * F_12_y;
  const Scalar U_10_xx_yy = U_10_xx - U_10_yy;
  const Scalar mu_10_z = Scalar(0.44815416666667) * domega_9_y + Scalar(0.22) * ddp_10_x +
      Scalar(1.3725) * t144 - Scalar(0.40049083333333) * t138 + Scalar(0.0549) * U_10_xx_yy -
      Scalar(0.357) * t153 + Scalar(0.04) * f_u_11_t_x - c_11 * mu_11_y - s_11 * mu_11_x;
  const Scalar y_12 = tau_12 + N_12_z;
  const Scalar hu_12_t_y = Scalar(0.045) * c_12 - Scalar(0.105) * s_12;
  const Scalar t154 = Scalar(0.04) * hu_12_t_y + Scalar(0.01431666666667);
  const Scalar hu_12_t_x = Scalar(0.105) * c_12 + Scalar(0.045) * s_12;
  const Scalar t155 = Scalar(0.357) * hu_12_t_x;
  const Scalar mu_12_10_z = t155 + c_11 * t154;
  const Scalar t156 = Scalar(69.84866123397676) * mu_12_10_z;
  const Scalar y_11 = tau_11 + mu_11_z;
  const Scalar Iu_12_t_g = Scalar(0.0063) * c_12 - Scalar(0.0012) * s_12;
  const Scalar t157 = s_12 * Iu_12_t_g;
  const Scalar Ic_11_zz = t157 + Scalar(0.00940666666667);
  const Scalar d_11 = Scalar(1.0) / Ic_11_zz;
  const Scalar t158 = Scalar(0.04) * hu_12_t_x + c_12 * Iu_12_t_g - Scalar(0.00315);
  const Scalar t159 = s_11 * t158;
  const Scalar t160 = d_11 * t159;
  const Scalar y_11_10 = tau_10 + mu_10_z - y_12 * t156 + y_11 * t160;
  const Scalar Iu_12_t_xx = t157 + Scalar(0.0012);
  const Scalar Iu_11_t_d = Iu_12_t_xx + Scalar(0.00555);
  const Scalar t161 = c_11 * Iu_11_t_d;
  const Scalar t162 = t161 + t155;
  const Scalar t163 = c_10 * t162 + s_10 * t158;
  const Scalar t164 = s_11 * t163;
  const Scalar t165 = c_11 * t158;
  const Scalar t166 = c_11 * hu_12_t_x;
  const Scalar mu_11_10_y = Ic_11_zz + Scalar(0.357) * t166;
  const Scalar mu_11_9_z = Scalar(0.02) * t166 - c_10 * t165 + s_10 * mu_11_10_y;
  const Scalar t167 = mu_11_9_z * d_11;
  const Scalar t168 = Scalar(0.357) * hu_12_t_y;
  const Scalar t169 = s_11 * (c_10 * t154 - t168 * (s_10 + Scalar(0.056022408963585436)));
  const Scalar t170 = t169 * t156 + t159 * t167 - t164;
  const Scalar t171 = c_11 * t161;
  const Scalar t172 = Scalar(0.714) * t166;
  const Scalar t173 = Scalar(0.08) * hu_12_t_y;
  const Scalar t174 = Iu_12_t_xx - t171 - t173 - t172 - Scalar(0.44815416666667);
  const Scalar t175 = t174 + mu_12_10_z * t156 + t159 * t160;
  const Scalar t176 = Scalar(1.0) / t175;
  const Scalar t177 = t170 * t176;
  const Scalar t178 = Scalar(-69.84866123397676) * t169;
  const Scalar y_10_9 = tau_9 + mu_9_z + y_12 * t178 + y_11 * t167 - t177 * y_11_10;
  const Scalar t179 = t171 - t173 - Scalar(0.00555);
  const Scalar Ic_10_yy = Ic_11_zz + t172 + Scalar(0.40049083333333);
  const Scalar Ic_10_xy = t165 + t168 + Scalar(0.0549);
  const Scalar t180 = Scalar(2.0) * c_10 * Ic_10_xy - s_10 * (t179 + Ic_10_yy);
  const Scalar hc_10_x = t166 + Scalar(1.3725);
  const Scalar hc_10_y = hu_12_t_y + Scalar(0.22);
  const Scalar hu_10_t_y = c_10 * hc_10_x + s_10 * hc_10_y;
  const Scalar Ic_9_xz = Ic_10_xy + Scalar(0.02) * hu_10_t_y - c_10 * t180 + Scalar(0.00507);
  const Scalar t181 = s_9 * s_11;
  const Scalar t182 = c_10 * hc_10_y - s_10 * hc_10_x;
  const Scalar t183 = t182 - Scalar(0.08);
  const Scalar t184 = c_9 * t183 - hu_12_t_x * t181;
  const Scalar t185 = Scalar(0.389) * t184 - c_9 * Ic_9_xz - t163 * t181;
  const Scalar mu_u_11_10_t_x = c_10 * mu_11_10_y + s_10 * t165;
  const Scalar t186 = Scalar(0.02) * hu_12_t_x;
  const Scalar t187 = t158 - c_10 * t186;
  const Scalar t188 = Scalar(0.389) * hu_12_t_x;
  const Scalar t189 = (c_9 * c_11 + s_10 * t181) * t188;
  const Scalar mu_11_8_z = c_9 * mu_u_11_10_t_x + t181 * t187 + t189;
  const Scalar t190 = mu_11_8_z * d_11;
  const Scalar t191 = c_10 * t158 - s_10 * t162;
  const Scalar t192 = c_9 * s_11;
  const Scalar t193 = t174 + Scalar(0.02) * t182 - Scalar(0.389) * hu_10_t_y;
  const Scalar t194 = c_11 * hu_12_t_y;
  const Scalar f_u_12_10_t_x = s_10 * t194 + c_10 * hu_12_t_x;
  const Scalar t195 = hu_12_t_y * t192 - s_9 * f_u_12_10_t_x;
  const Scalar mu_12_9_y = mu_12_10_z - Scalar(0.02) * (c_10 * t194 - s_10 * hu_12_t_x);
  const Scalar t196 = c_10 * t168 + s_10 * t154;
  const Scalar t197 = Scalar(0.389) * t195 + t192 * t196 - s_9 * mu_12_9_y;
  const Scalar t198 = t191 * t192 + t197 * t156 - t159 * t190 - s_9 * t193;
  const Scalar t199 = Scalar(-69.84866123397676) * t197;
  const Scalar t200 = t185 + t169 * t199 + mu_11_8_z * t167 + t198 * t177;
  const Scalar t201 = s_10 * t180;
  const Scalar t202 = Scalar(-0.04) * t182;
  const Scalar t203 = t179 + t201 - t202 - Scalar(0.03800666666667);
  const Scalar t204 = t203 - t169 * t178 + mu_11_9_z * t167 - t170 * t177;
  const Scalar t205 = Scalar(1.0) / t204;
  const Scalar t206 = t200 * t205;
  const Scalar f_9_y = Scalar(0.08) * U_9_yx - f_10_z;
  const Scalar f_10_x = Scalar(1.3725) * U_10_xx + Scalar(0.22) * U_10_xy + f_u_11_t_x;
  const Scalar f_10_y = Scalar(1.3725) * U_10_yx - Scalar(0.22) * U_10_yy - t153;
  const Scalar f_9_x = Scalar(0.08) * U_9_xx + c_10 * f_10_y + s_10 * f_10_x;
  const Scalar f_u_9_t_x = c_9 * f_9_y + s_9 * f_9_x;
  const Scalar mu_9_x = Scalar(0.00507) * U_9_yx + Scalar(0.05976333333334) * t152 - c_10 * t151 +
      s_10 * mu_10_x;
  const Scalar t207 = c_10 * f_10_x - s_10 * f_10_y;
  const Scalar mu_9_y = Scalar(0.08) * ddp_o_9_y + Scalar(0.02175666666667) * domega_9_y -
      Scalar(0.03800666666667) * t132 - Scalar(0.00507) * (t134 - omega_r_9_x * omega_r_9_x) -
      mu_10_z + Scalar(0.02) * t207;
  const Scalar t208 = t198 * t176;
  const Scalar y_9_8 = tau_8 - Scalar(1.03624716666667) * t135 - Scalar(0.389) * f_u_9_t_x -
      c_9 * mu_9_x + s_9 * mu_9_y + y_12 * t199 - y_11 * t190 - t208 * y_11_10 + t206 * y_10_9 -
      Scalar(27.463095) * c_7 * s_8;
  const Scalar Iu_10_t_xx = Ic_10_yy + t201;
  const Scalar t209 = t174 - t202 + Scalar(0.02175666666667);
  const Scalar Iu_9_t_d = Iu_10_t_xx + t209;
  const Scalar t210 = s_11 * t186 - s_11 * t191;
  const Scalar t211 = Scalar(2.0) * c_9 * t210 + s_9 * Iu_9_t_d;
  const Scalar t212 = c_8 * (t210 - c_9 * t211);
  const Scalar t213 = hu_12_t_x * t192 + s_9 * t183;
  const Scalar t214 = c_8 * (Scalar(0.389) * t213 + t163 * t192 - s_9 * Ic_9_xz);
  const Scalar t215 = (s_10 * t192 - s_9 * c_11) * t188;
  const Scalar t216 = c_8 * (t192 * t187 - s_9 * mu_u_11_10_t_x + t215) - s_8 * mu_11_9_z;
  const Scalar t217 = t216 * d_11;
  const Scalar t218 = c_8 * (t191 * t181 + c_9 * t193);
  const Scalar f_u_12_9_t_y = c_9 * f_u_12_10_t_x + hu_12_t_y * t181;
  const Scalar mu_12_8_x = Scalar(0.389) * f_u_12_9_t_y + c_9 * mu_12_9_y + t181 * t196;
  const Scalar mu_u_12_8_t_y = c_8 * mu_12_8_x - s_8 * t169;
  const Scalar t219 = t218 + s_8 * t164 + mu_u_12_8_t_y * t156 + t159 * t217;
  const Scalar t220 = Scalar(69.84866123397676) * mu_u_12_8_t_y;
  const Scalar t221 = t214 + s_8 * t203 - t169 * t220 - t216 * t167 + t219 * t177;
  const Scalar t222 = t212 + s_8 * t185 - mu_u_12_8_t_y * t199 - t216 * t190 - t219 * t208 -
      t221 * t206;
  const Scalar t223 = s_9 * t211;
  const Scalar t224 = Scalar(0.778) * hu_10_t_y;
  const Scalar b_9_8_8 = Iu_10_t_xx - t223 + t224 + t197 * t199 - mu_11_8_z * t190 + t198 * t208 +
      t200 * t206 + Scalar(1.03820716666667);
  const Scalar d_8 = Scalar(1.0) / b_9_8_8;
  const Scalar t225 = t222 * d_8;
  const Scalar t226 = c_9 * f_9_x - s_9 * f_9_y;
  const Scalar mu_8_x = Scalar(27.463095) * s_7 - Scalar(2.07445433333334) * t123 -
      Scalar(0.389) * t226 + c_9 * mu_9_y + s_9 * mu_9_x;
  const Scalar mu_8_y = Scalar(0.00196) * t124 + mu_9_z;
  const Scalar t227 = t221 * t205;
  const Scalar t228 = t219 * t176;
  const Scalar y_8_7 = tau_7 - c_8 * mu_8_x - s_8 * mu_8_y - y_12 * t220 + y_11 * t217 -
      t228 * y_11_10 + t227 * y_10_9 + t225 * y_9_8;
  const Scalar t229 = t209 - t223 - t224;
  const Scalar t230 = s_8 * (Scalar(2.0) * t214 + s_8 * (t203 - t229 + Scalar(1.03624716666667)));
  const Scalar t231 = t229 + t230 + mu_u_12_8_t_y * t220 + t216 * t217 - t219 * t228 - t221 * t227 +
      t222 * t225 - Scalar(1.04016716666667);
  const Scalar t232 = (Scalar(1.0) / t231) * y_8_7;
  qdd[6] = -t232;
  const Scalar qdd_2 = d_2 * (y_3_2 - t106 * t116);
  qdd[1] = qdd_2;
  const Scalar qdd_8 = d_8 * (y_9_8 - t222 * t232);
  qdd[7] = qdd_8;
  const Scalar t233 = t89 * (y_4_3 - t84 * qdd_2 + t105 * t116);
  qdd[2] = -t233;
  const Scalar t234 = t205 * (y_10_9 - t200 * qdd_8 + t221 * t232);
  qdd[8] = -t234;
  const Scalar t235 = t60 * (y_5_4 + t82 * qdd_2 - t103 * t116 - t54 * t233);
  qdd[3] = -t235;
  const Scalar t236 = t176 * (y_11_10 + t198 * qdd_8 - t219 * t232 - t170 * t234);
  qdd[9] = -t236;
  const Scalar t237 = y_5 - t43 * t235 - t100 * t116 - mu_5_3_z * t233 - mu_5_2_z * qdd_2;
  qdd[4] = d_5 * t237;
  const Scalar t238 = y_6 + mu_6_4_z * t235 + mu_u_6_2_t_y * t116;
  qdd[5] = Scalar(69.84866123397676) * t238 +
      Scalar(69.84866123397676) * (t53 * t233 - t81 * qdd_2);
  const Scalar t239 = y_11 - t159 * t236 - t216 * t232 - mu_11_9_z * t234 - mu_11_8_z * qdd_8;
  qdd[10] = d_11 * t239;
  const Scalar t240 = y_12 + mu_12_10_z * t236 + mu_u_12_8_t_y * t232;
  qdd[11] = Scalar(69.84866123397676) * t240 +
      Scalar(69.84866123397676) * (t169 * t234 - t197 * qdd_8);
  const Scalar t241 = s_32 * s_32;
  const Scalar t242 = Scalar(0.0005096) * t241;
  const Scalar Iu_32_t_xx = t242 - Scalar(0.0005096);
  const Scalar Iu_31_t_d = Iu_32_t_xx - Scalar(0.0235906);
  const Scalar t243 = s_31 * c_32;
  const Scalar t244 = c_31 * Iu_31_t_d - Scalar(0.0014964) * t243;
  const Scalar t245 = c_31 * t244;
  const Scalar t246 = t245 + Scalar(0.0235906);
  const Scalar Ic_31_zz = t242 + Scalar(0.0253235000000002);
  const Scalar Ic_30_yy = Ic_31_zz - Scalar(0.0253235000000002);
  const Scalar t247 = c_31 * c_32;
  const Scalar t248 = s_31 + Scalar(0.6811013098102112) * t247;
  const Scalar t249 = Scalar(0.0014964) * c_30 * s_32 * t248 - s_30 * (t246 + Ic_30_yy);
  const Scalar t250 = s_30 * t249;
  const Scalar t251 = Scalar(0.0094) * c_32;
  const Scalar hu_31_t_y = Scalar(0.1902) * c_31 + s_31 * t251;
  const Scalar t252 = Scalar(0.478) * hu_31_t_y;
  const Scalar Ic_29_xx = Ic_30_yy + t250 + t252;
  const Scalar Ic_30_zz = Iu_32_t_xx - t245 - Scalar(0.0259635000000002);
  const Scalar hu_31_t_x = Scalar(0.1902) * s_31 - c_31 * t251;
  const Scalar t253 = Scalar(0.0094) * s_32;
  const Scalar t254 = c_30 * t253;
  const Scalar t255 = t254 - s_30 * hu_31_t_x;
  const Scalar t256 = Scalar(-0.008) * t255;
  const Scalar Ic_29_yy = Ic_30_zz - t256 + Scalar(0.2262745000000002);
  const Scalar Iu_29_t_d = Ic_29_xx + Ic_29_yy;
  const Scalar Iu_31_t_xy = Scalar(0.0007482) * c_32 + s_31 * t244;
  const Scalar t257 = c_31 - Scalar(0.6811013098102112) * t243;
  const Scalar t258 = Scalar(0.0007482) * s_32;
  const Scalar t259 = c_30 * t258;
  const Scalar t260 = Scalar(0.239) * t255 + t257 * t259 + s_30 * Iu_31_t_xy;
  const Scalar Ic_29_xy = Scalar(0.004) * hu_31_t_y - t260 + Scalar(0.0050592);
  const Scalar t261 = c_29 * Iu_29_t_d - Scalar(2.0) * s_29 * Ic_29_xy;
  const Scalar t262 = c_29 * t261;
  const Scalar Iu_29_t_xx = Ic_29_yy - t262;
  const Scalar t263 = t246 + t250 - t252 - t256 - Scalar(0.2298769000000002);
  const Scalar t264 = t255 - Scalar(0.0328);
  const Scalar hc_29_y = hu_31_t_y + Scalar(0.8648);
  const Scalar t265 = c_29 * t264 - s_29 * hc_29_y;
  const Scalar t266 = Scalar(-0.008) * t265;
  const Scalar t267 = t263 + t266 + Scalar(0.2282085000000002);
  const Scalar Iu_28_t_d = Iu_29_t_xx - t267;
  const Scalar t268 = s_30 * t253;
  const Scalar hu_30_t_y = c_30 * hu_31_t_x + t268;
  const Scalar t269 = Scalar(0.004) * hu_30_t_y;
  const Scalar t270 = c_30 * t249 - t248 * t258 - t269;
  const Scalar t271 = s_30 * t258;
  const Scalar Ic_29_yz = Scalar(0.239) * hu_30_t_y - c_30 * Iu_31_t_xy + t257 * t271;
  const Scalar t272 = c_29 * t270 - s_29 * Ic_29_yz;
  const Scalar Ic_28_xy = t269 + t272;
  const Scalar Iu_28_t_g = Scalar(2.0) * c_28 * Ic_28_xy + s_28 * Iu_28_t_d;
  const Scalar t273 = s_28 * Iu_28_t_g;
  const Scalar t274 = c_29 * hc_29_y + s_29 * t264;
  const Scalar t275 = Scalar(-0.61) * t274;
  const Scalar t276 = t267 + t273 + t275;
  const Scalar Ic_28_zz = Ic_29_xx - t262 - t266 + Scalar(0.2360429000000002);
  const Scalar Ic_27_yy = Ic_28_zz - Scalar(0.7059807000000002);
  const Scalar t277 = Ic_29_xy - Scalar(0.004) * t274 + s_29 * t261 - Scalar(0.0023);
  const Scalar t278 = c_29 * Ic_29_yz + s_29 * t270;
  const Scalar t279 = t265 - Scalar(0.0032);
  const Scalar t280 = c_28 * hu_30_t_y;
  const Scalar t281 = t280 + s_28 * t279;
  const Scalar t282 = Scalar(0.305) * t281 + c_28 * t278 - s_28 * t277;
  const Scalar t283 = c_27 * t282;
  const Scalar t284 = Scalar(2.0) * t283 - s_27 * (t276 + Ic_27_yy);
  const Scalar t285 = s_27 * t284;
  const Scalar Iu_27_t_xx = Ic_27_yy + t285;
  const Scalar t286 = Iu_29_t_xx - t273 + t275 - Scalar(0.7079407000000002);
  const Scalar t287 = t286 + Scalar(0.7079407000000002);
  const Scalar Iu_26_t_d = Iu_27_t_xx + t287;
  const Scalar Iu_28_t_xy = Ic_28_xy - c_28 * Iu_28_t_g;
  const Scalar t288 = s_28 * hu_30_t_y;
  const Scalar t289 = c_28 * t279 - t288;
  const Scalar t290 = Scalar(0.305) * t289 - c_28 * t277 - s_28 * t278;
  const Scalar Iu_27_t_xz = c_27 * t290 + s_27 * Iu_28_t_xy;
  const Scalar t291 = s_26 * Iu_27_t_xz;
  const Scalar t292 = c_26 * Iu_26_t_d - Scalar(2.0) * t291;
  const Scalar t293 = s_25 * s_25;
  const Scalar t294 = Scalar(0.0005096) * t293;
  const Scalar Iu_25_t_xx = t294 - Scalar(0.0005096);
  const Scalar Iu_24_t_d = Iu_25_t_xx - Scalar(0.0235906);
  const Scalar t295 = s_24 * c_25;
  const Scalar Iu_24_t_g = c_24 * Iu_24_t_d + Scalar(0.0014964) * t295;
  const Scalar t296 = c_24 * Iu_24_t_g;
  const Scalar Iu_24_t_xx = t296 + Scalar(0.0235906);
  const Scalar Ic_24_zz = t294 + Scalar(0.0253235000000002);
  const Scalar Ic_23_yy = Ic_24_zz - Scalar(0.0253235000000002);
  const Scalar Iu_23_t_d = Iu_24_t_xx + Ic_23_yy;
  const Scalar t297 = c_24 * c_25;
  const Scalar t298 = s_24 - Scalar(0.6811013098102112) * t297;
  const Scalar t299 = Scalar(0.0014964) * c_23 * s_25 * t298 + s_23 * Iu_23_t_d;
  const Scalar t300 = s_23 * t299;
  const Scalar t301 = Scalar(0.0094) * c_25;
  const Scalar hu_24_t_y = Scalar(0.1902) * c_24 - s_24 * t301;
  const Scalar t302 = Scalar(0.478) * hu_24_t_y;
  const Scalar Ic_22_xx = Ic_23_yy - t300 + t302;
  const Scalar Ic_23_zz = Iu_25_t_xx - t296 - Scalar(0.0259635000000002);
  const Scalar hu_24_t_x = Scalar(0.1902) * s_24 + c_24 * t301;
  const Scalar t303 = Scalar(0.0094) * s_25;
  const Scalar t304 = c_23 * t303;
  const Scalar hu_23_t_x = t304 + s_23 * hu_24_t_x;
  const Scalar t305 = Scalar(0.008) * hu_23_t_x;
  const Scalar Ic_22_yy = Ic_23_zz - t305 + Scalar(0.2262745000000002);
  const Scalar Iu_22_t_d = Ic_22_xx + Ic_22_yy;
  const Scalar Iu_24_t_xy = Scalar(0.0007482) * c_25 - s_24 * Iu_24_t_g;
  const Scalar t306 = c_24 + Scalar(0.6811013098102112) * t295;
  const Scalar t307 = Scalar(0.0007482) * s_25;
  const Scalar t308 = c_23 * t307;
  const Scalar mu_23_22_x = Scalar(0.239) * hu_23_t_x + t306 * t308 + s_23 * Iu_24_t_xy;
  const Scalar Ic_22_xy = Scalar(0.004) * hu_24_t_y + mu_23_22_x + Scalar(0.0050592);
  const Scalar t309 = c_22 * Iu_22_t_d - Scalar(2.0) * s_22 * Ic_22_xy;
  const Scalar t310 = c_22 * t309;
  const Scalar Iu_22_t_xx = Ic_22_yy - t310;
  const Scalar t311 = Iu_24_t_xx - t300 - t302 - t305 - Scalar(0.2298769000000002);
  const Scalar hc_22_x = hu_23_t_x + Scalar(0.0328);
  const Scalar hc_22_y = hu_24_t_y + Scalar(0.8648);
  const Scalar hu_22_t_x = c_22 * hc_22_x + s_22 * hc_22_y;
  const Scalar t312 = Scalar(0.008) * hu_22_t_x;
  const Scalar t313 = t311 + t312 + Scalar(0.2282085000000002);
  const Scalar Iu_21_t_d = Iu_22_t_xx - t313;
  const Scalar t314 = s_23 * t303;
  const Scalar t315 = c_23 * hu_24_t_x - t314;
  const Scalar t316 = Scalar(-0.004) * t315;
  const Scalar t317 = c_23 * t299 - t298 * t307 - t316;
  const Scalar t318 = s_23 * t307;
  const Scalar t319 = Scalar(0.239) * t315 + c_23 * Iu_24_t_xy - t306 * t318;
  const Scalar t320 = c_22 * t317 + s_22 * t319;
  const Scalar t321 = t316 + t320;
  const Scalar t322 = Scalar(2.0) * c_21 * t321 - s_21 * Iu_21_t_d;
  const Scalar t323 = s_21 * t322;
  const Scalar t324 = c_22 * hc_22_y - s_22 * hc_22_x;
  const Scalar t325 = Scalar(-0.61) * t324;
  const Scalar t326 = t313 - t323 + t325;
  const Scalar t327 = Ic_22_xx - t310 - t312 + Scalar(0.2360429000000002);
  const Scalar t328 = t327 - Scalar(0.7059807000000002);
  const Scalar t329 = Ic_22_xy - Scalar(0.004) * t324 + s_22 * t309 - Scalar(0.0023);
  const Scalar t330 = c_22 * t319 - s_22 * t317;
  const Scalar hc_21_x = hu_22_t_x + Scalar(0.0032);
  const Scalar t331 = c_21 * t315;
  const Scalar t332 = t331 - s_21 * hc_21_x;
  const Scalar t333 = Scalar(0.305) * t332 + c_21 * t330 - s_21 * t329;
  const Scalar t334 = c_20 * t333;
  const Scalar t335 = Scalar(2.0) * t334 - s_20 * (t326 + t328);
  const Scalar t336 = s_20 * t335;
  const Scalar t337 = t328 + t336;
  const Scalar t338 = Iu_22_t_xx + t323 + t325 - Scalar(0.7079407000000002);
  const Scalar t339 = t338 + Scalar(0.7079407000000002);
  const Scalar t340 = t321 - c_21 * t322;
  const Scalar t341 = s_21 * t315;
  const Scalar t342 = c_21 * hc_21_x + t341;
  const Scalar t343 = Scalar(0.305) * t342 + c_21 * t329 + s_21 * t330;
  const Scalar t344 = c_20 * t343 + s_20 * t340;
  const Scalar t345 = s_19 * t344;
  const Scalar t346 = c_19 * (t337 + t339) + Scalar(2.0) * t345;
  const Scalar t347 = c_26 * t292 + c_19 * t346;
  const Scalar t348 = t274 + Scalar(1.661);
  const Scalar t349 = c_27 * t281 + s_27 * t348;
  const Scalar t350 = t324 + Scalar(1.661);
  const Scalar t351 = c_20 * t332 + s_20 * t350;
  const Scalar t352 = Scalar(-0.48) * (t349 - t351);
  const Scalar Iu_18_t_g = Scalar(0.0044) * c_18 + Scalar(0.024) * s_18;
  const Scalar t353 = s_18 * Iu_18_t_g;
  const Scalar Iu_18_t_xx = t353 - Scalar(0.024);
  const Scalar Iu_17_t_d = Iu_18_t_xx - Scalar(0.0002);
  const Scalar t354 = s_17 * s_17;
  const Scalar t355 = Iu_17_t_d * t354;
  const Scalar Ic_16_zz = Iu_18_t_xx - t355 + Scalar(0.035005);
  const Scalar hu_18_t_y = Scalar(0.02) * c_18 + Scalar(0.22) * s_18;
  const Scalar hu_18_t_x = Scalar(0.22) * c_18 - Scalar(0.02) * s_18;
  const Scalar t356 = s_16 * s_17;
  const Scalar hu_16_t_y = c_16 * hu_18_t_y + hu_18_t_x * t356;
  const Scalar t357 = Scalar(0.006) * hu_16_t_y;
  const Scalar t358 = t287 + t339 - Ic_16_zz - t347 + t352 + t357;
  const Scalar t359 = t276 + t285 - Scalar(0.7099007000000002);
  const Scalar t360 = t326 + t336 - Scalar(0.7099007000000002);
  const Scalar hu_27_t_x = c_27 * t348 - s_27 * t281;
  const Scalar t361 = s_26 * t289;
  const Scalar t362 = c_26 * hu_27_t_x + t361;
  const Scalar hu_20_t_x = c_20 * t350 - s_20 * t332;
  const Scalar t363 = s_19 * t342;
  const Scalar hu_19_t_x = c_19 * hu_20_t_x - t363;
  const Scalar t364 = c_17 * hu_18_t_x;
  const Scalar t365 = Scalar(0.66) * (t362 + hu_19_t_x) - Scalar(0.906) * t364;
  const Scalar Iu_17_t_xx = t355 + Scalar(0.0002);
  const Scalar Iu_16_t_d = t353 + Iu_17_t_xx;
  const Scalar Iu_18_t_xy = c_18 * Iu_18_t_g - Scalar(0.0022);
  const Scalar t366 = Iu_18_t_xy * t356;
  const Scalar Iu_16_t_g = c_16 * Iu_16_t_d + Scalar(2.0) * t366;
  const Scalar t367 = c_16 * Iu_16_t_g;
  const Scalar t368 = t359 + t360 + t353 + t357 + t365 - t367 - Scalar(0.5912714333326666);
  const Scalar t369 = t333 - c_20 * t335;
  const Scalar t370 = c_20 * t340 - s_20 * t343;
  const Scalar t371 = Scalar(0.24) * hu_19_t_x + c_19 * t369 - s_19 * t370;
  const Scalar t372 = t282 - c_27 * t284;
  const Scalar Iu_27_t_yz = c_27 * Iu_28_t_xy - s_27 * t290;
  const Scalar t373 = Scalar(0.24) * t362 - c_26 * t372 - s_26 * Iu_27_t_yz;
  const Scalar t374 = c_16 * s_17;
  const Scalar t375 = hu_18_t_x * t374 - s_16 * hu_18_t_y;
  const Scalar t376 = Scalar(0.453) * t375 - c_17 * (Iu_17_t_d * t374 + s_16 * Iu_18_t_xy);
  const Scalar t377 = Scalar(0.33) * (t349 + t351) - t376 + t371 - t373;
  const Scalar t378 = c_15 * (t358 - t368) + Scalar(2.0) * s_15 * t377;
  const Scalar t379 = c_15 * t378;
  const Scalar t380 = t368 + t379;
  const Scalar t381 = Iu_27_t_xx + t337 + Iu_17_t_xx - t347 - t352 - t365 - t367 +
      Scalar(5.512820899999667);
  const Scalar t382 = c_26 * t289;
  const Scalar t383 = t382 - s_26 * hu_27_t_x;
  const Scalar t384 = c_19 * t342;
  const Scalar hu_19_t_y = t384 + s_19 * hu_20_t_x;
  const Scalar t385 = c_16 * Iu_18_t_xy;
  const Scalar t386 = Scalar(0.453) * hu_16_t_y + c_17 * (t385 - Iu_17_t_d * t356);
  const Scalar t387 = Scalar(0.003) * hu_18_t_x;
  const Scalar t388 = Iu_27_t_xz - t344 - Scalar(0.33) * (t383 - hu_19_t_y) - t386 + s_26 * t292 +
      s_19 * t346 + c_17 * t387 - Scalar(0.043998);
  const Scalar t389 = Scalar(0.24) * hu_19_t_y + c_19 * t370 + s_19 * t369;
  const Scalar t390 = Scalar(0.24) * t383 - c_26 * Iu_27_t_yz + s_26 * t372;
  const Scalar t391 = Scalar(0.003) * t375 + t389 + t390 - s_17 * Iu_18_t_xy + s_16 * Iu_16_t_g;
  const Scalar t392 = c_14 * (c_15 * t388 - s_15 * t391);
  const Scalar t393 = s_14 * (Scalar(2.0) * t392 -
      s_14 * (t381 + t380 - Scalar(2.5051100666670005)));
  const Scalar t394 = c_14 * (t377 - s_15 * t378);
  const Scalar t395 = t359 + Scalar(0.33) * t362;
  const Scalar t396 = c_14 * (c_15 * t373 - s_15 * t395);
  const Scalar t397 = t286 - Scalar(0.24) * t349;
  const Scalar t398 = c_26 * Iu_27_t_xz + s_26 * t397;
  const Scalar mu_27_15_y = Iu_27_t_yz + Scalar(0.33) * s_26 * t349;
  const Scalar t399 = c_14 * (c_15 * t398 + s_15 * mu_27_15_y);
  const Scalar t400 = c_27 * Ic_28_zz + s_27 * t282;
  const Scalar f_u_28_26_t_y = c_26 * t281 - s_27 * t361;
  const Scalar mu_28_15_x = Scalar(0.24) * f_u_28_26_t_y + c_26 * t400 - s_26 * t290;
  const Scalar t401 = t283 - s_27 * Ic_28_zz;
  const Scalar t402 = t401 - Scalar(0.33) * f_u_28_26_t_y;
  const Scalar t403 = c_14 * (c_15 * mu_28_15_x + s_15 * t402);
  const Scalar t404 = t263 - Scalar(0.004) * t265 - Scalar(0.305) * t274;
  const Scalar t405 = s_28 * t272 + c_28 * t404;
  const Scalar t406 = c_27 * t278 - s_27 * t405;
  const Scalar t407 = c_28 * t272 - s_28 * t404;
  const Scalar t408 = s_28 * t274;
  const Scalar t409 = c_27 * t265 + s_27 * t408;
  const Scalar t410 = c_28 * t274;
  const Scalar t411 = c_26 * t410 + s_26 * t409;
  const Scalar t412 = Scalar(0.24) * t411 + c_26 * t406 + s_26 * t407;
  const Scalar t413 = c_27 * t405 + s_27 * t278;
  const Scalar t414 = t413 + Scalar(0.33) * t411;
  const Scalar mu_u_29_15_t_x = c_15 * t412 - s_15 * t414;
  const Scalar t415 = Scalar(-0.004) * t255;
  const Scalar mu_30_29_y = Ic_30_zz - t415;
  const Scalar t416 = c_29 * t260 - s_29 * mu_30_29_y;
  const Scalar t417 = s_29 * hu_30_t_y;
  const Scalar mu_30_28_y = Ic_29_yz - Scalar(0.004) * t417;
  const Scalar t418 = c_29 * t280 + s_28 * t255;
  const Scalar t419 = Scalar(0.305) * t418 + c_28 * mu_30_28_y + s_28 * t416;
  const Scalar t420 = t415 + c_29 * mu_30_29_y + s_29 * t260;
  const Scalar t421 = c_27 * t420 - s_27 * t419;
  const Scalar t422 = c_28 * t255 - c_29 * t288;
  const Scalar t423 = Scalar(0.305) * t422 + c_28 * t416 - s_28 * mu_30_28_y;
  const Scalar t424 = c_27 * t417 + s_27 * t422;
  const Scalar f_u_30_26_t_y = c_26 * t418 - s_26 * t424;
  const Scalar mu_30_15_x = Scalar(0.24) * f_u_30_26_t_y - c_26 * t421 - s_26 * t423;
  const Scalar t425 = c_27 * t419 + s_27 * t420;
  const Scalar t426 = t425 - Scalar(0.33) * f_u_30_26_t_y;
  const Scalar t427 = c_14 * (c_15 * mu_30_15_x + s_15 * t426);
  const Scalar f_u_32_30_t_y = c_31 * t254 + s_30 * t251;
  const Scalar t428 = Scalar(0.004) * f_u_32_30_t_y;
  const Scalar mu_u_32_31_t_y = Scalar(0.0014129000000002) * c_31 - Scalar(0.0007482) * t243;
  const Scalar mu_32_29_y = mu_u_32_31_t_y - t428;
  const Scalar mu_u_32_31_t_x = Scalar(0.0014129000000002) * s_31 + Scalar(0.0007482) * t247;
  const Scalar mu_32_29_x = t259 + Scalar(0.239) * f_u_32_30_t_y + s_30 * mu_u_32_31_t_x;
  const Scalar mu_u_32_29_t_x = c_29 * mu_32_29_x + s_29 * mu_32_29_y;
  const Scalar t429 = c_30 * t251 - c_31 * t268;
  const Scalar t430 = s_31 * t253;
  const Scalar f_u_32_29_t_x = c_29 * t429 + s_29 * t430;
  const Scalar t431 = c_28 * f_u_32_29_t_x - s_28 * f_u_32_30_t_y;
  const Scalar f_u_32_29_t_y = c_29 * t430 - s_29 * t429;
  const Scalar mu_32_29_z = t271 - Scalar(0.239) * t429 + Scalar(0.0000376) * s_31 * s_32 -
      c_30 * mu_u_32_31_t_x;
  const Scalar mu_32_28_y = mu_32_29_z - Scalar(0.004) * f_u_32_29_t_y;
  const Scalar t432 = Scalar(0.305) * t431 - c_28 * mu_32_28_y - s_28 * mu_u_32_29_t_x;
  const Scalar mu_32_28_z = t428 + c_29 * mu_32_29_y - s_29 * mu_32_29_x;
  const Scalar mu_u_32_27_t_x = c_27 * mu_32_28_z - s_27 * t432;
  const Scalar f_u_32_28_t_x = c_28 * f_u_32_30_t_y + s_28 * f_u_32_29_t_x;
  const Scalar f_u_32_27_t_x = c_27 * f_u_32_29_t_y + s_27 * f_u_32_28_t_x;
  const Scalar f_u_32_26_t_y = c_26 * t431 + s_26 * f_u_32_27_t_x;
  const Scalar mu_32_27_z = Scalar(0.305) * f_u_32_28_t_x + c_28 * mu_u_32_29_t_x -
      s_28 * mu_32_28_y;
  const Scalar mu_32_15_x = Scalar(0.24) * f_u_32_26_t_y - c_26 * mu_u_32_27_t_x +
      s_26 * mu_32_27_z;
  const Scalar mu_u_32_27_t_y = c_27 * t432 + s_27 * mu_32_28_z;
  const Scalar mu_32_15_y = mu_u_32_27_t_y - Scalar(0.33) * f_u_32_26_t_y;
  const Scalar mu_u_32_15_t_x = c_15 * mu_32_15_x + s_15 * mu_32_15_y;
  const Scalar f_u_32_26_t_x = c_26 * f_u_32_27_t_x - s_26 * t431;
  const Scalar t433 = c_27 * f_u_32_28_t_x - s_27 * f_u_32_29_t_y;
  const Scalar t434 = Scalar(0.33) * t433 - Scalar(0.24) * f_u_32_26_t_x - c_26 * mu_32_27_z -
      s_26 * mu_u_32_27_t_x;
  const Scalar mu_u_32_14_t_y = c_14 * mu_u_32_15_t_x - s_14 * t434;
  const Scalar t435 = Scalar(0.5295491542217383) * s_32;
  const Scalar t436 = Ic_31_zz + Scalar(0.239) * hu_31_t_y;
  const Scalar mu_31_29_x = t248 * t271 + c_30 * t436;
  const Scalar t437 = c_30 * hu_31_t_y;
  const Scalar t438 = Scalar(0.004) * t437;
  const Scalar t439 = t257 * t258;
  const Scalar t440 = t438 - t439;
  const Scalar t441 = c_29 * mu_31_29_x - s_29 * t440;
  const Scalar t442 = s_30 * hu_31_t_y;
  const Scalar t443 = c_29 * t442 - s_29 * hu_31_t_x;
  const Scalar f_u_31_28_t_y = c_28 * t443 + s_28 * t437;
  const Scalar mu_31_29_z = Scalar(0.004) * hu_31_t_x + s_30 * t436 - t248 * t259;
  const Scalar f_u_31_29_t_y = c_29 * hu_31_t_x + s_29 * t442;
  const Scalar mu_31_28_y = mu_31_29_z - Scalar(0.004) * f_u_31_29_t_y;
  const Scalar mu_31_27_x = Scalar(0.305) * f_u_31_28_t_y + c_28 * mu_31_28_y + s_28 * t441;
  const Scalar mu_31_28_z = t438 - c_29 * t440 - s_29 * mu_31_29_x;
  const Scalar mu_u_31_27_t_x = c_27 * mu_31_28_z + s_27 * mu_31_27_x;
  const Scalar f_u_31_28_t_x = c_28 * t437 - s_28 * t443;
  const Scalar f_u_31_27_t_x = c_27 * f_u_31_29_t_y + s_27 * f_u_31_28_t_x;
  const Scalar t444 = c_26 * f_u_31_28_t_y - s_26 * f_u_31_27_t_x;
  const Scalar mu_31_27_z = Scalar(0.305) * f_u_31_28_t_x + c_28 * t441 - s_28 * mu_31_28_y;
  const Scalar t445 = Scalar(0.24) * t444 + c_26 * mu_u_31_27_t_x - s_26 * mu_31_27_z;
  const Scalar t446 = c_27 * mu_31_27_x - s_27 * mu_31_28_z;
  const Scalar t447 = t446 - Scalar(0.33) * t444;
  const Scalar t448 = c_14 * (c_15 * t445 + s_15 * t447);
  const Scalar f_u_31_26_t_x = c_26 * f_u_31_27_t_x + s_26 * f_u_31_28_t_y;
  const Scalar t449 = c_27 * f_u_31_28_t_x - s_27 * f_u_31_29_t_y;
  const Scalar t450 = Scalar(0.33) * t449 - Scalar(0.24) * f_u_31_26_t_x - c_26 * mu_31_27_z -
      s_26 * mu_u_31_27_t_x;
  const Scalar b_32_31_13 = t448 + s_14 * t450 + mu_u_32_14_t_y * t435;
  const Scalar t451 = Scalar(0.00039620867718870463) * t241 - Ic_31_zz;
  const Scalar t452 = Scalar(1.0) / t451;
  const Scalar t453 = t439 - mu_u_32_31_t_y * t435;
  const Scalar t454 = t453 * t452;
  const Scalar t455 = c_26 * t424 + s_26 * t418;
  const Scalar t456 = c_27 * t422 - s_27 * t417;
  const Scalar t457 = Scalar(0.33) * t456 - Scalar(0.24) * t455 - c_26 * t423 + s_26 * t421;
  const Scalar t458 = Scalar(707.7641729774637) * mu_u_32_31_t_y;
  const Scalar t459 = t427 + s_14 * t457 + mu_u_32_14_t_y * t458 + b_32_31_13 * t454;
  const Scalar b_32_31_29 = mu_31_29_z - mu_32_29_z * t435;
  const Scalar b_31_30_29 = Ic_29_yz - mu_32_29_z * t458 + b_32_31_29 * t454;
  const Scalar b_31_30_30 = Ic_30_zz + mu_u_32_31_t_y * t458 - t453 * t454;
  const Scalar d_30 = Scalar(1.0) / b_31_30_30;
  const Scalar t460 = b_31_30_29 * d_30;
  const Scalar f_u_29_26_t_x = c_26 * t409 - s_26 * t410;
  const Scalar f_u_29_27_t_y = c_27 * t408 - s_27 * t265;
  const Scalar mu_29_15_z = Scalar(0.33) * f_u_29_27_t_y - Scalar(0.24) * f_u_29_26_t_x -
      c_26 * t407 + s_26 * t406;
  const Scalar t461 = b_32_31_29 * t452;
  const Scalar t462 = Scalar(707.7641729774637) * mu_32_29_z;
  const Scalar t463 = c_14 * mu_u_29_15_t_x - s_14 * mu_29_15_z + mu_u_32_14_t_y * t462 +
      b_32_31_13 * t461 + t459 * t460;
  const Scalar b_32_31_28 = mu_31_28_z - mu_32_28_z * t435;
  const Scalar t464 = t420 + mu_32_28_z * t458 - b_32_31_28 * t454;
  const Scalar t465 = t278 - mu_32_28_z * t462 + b_32_31_28 * t461 - t464 * t460;
  const Scalar t466 = t263 + mu_32_29_z * t462 - b_32_31_29 * t461 - b_31_30_29 * t460;
  const Scalar t467 = Scalar(1.0) / t466;
  const Scalar t468 = t465 * t467;
  const Scalar t469 = s_27 * t382 + s_26 * t281;
  const Scalar t470 = Scalar(0.24) * t469 - Scalar(0.33) * c_27 * t289 + c_26 * t290 + s_26 * t400;
  const Scalar t471 = t464 * d_30;
  const Scalar t472 = b_32_31_28 * t452;
  const Scalar t473 = Scalar(707.7641729774637) * mu_32_28_z;
  const Scalar t474 = t403 - s_14 * t470 + mu_u_32_14_t_y * t473 + b_32_31_13 * t472 - t459 * t471 +
      t463 * t468;
  const Scalar b_32_31_27 = mu_31_27_z - mu_32_27_z * t435;
  const Scalar t475 = t423 - mu_32_27_z * t458 + b_32_31_27 * t454;
  const Scalar t476 = t407 + mu_32_27_z * t462 - b_32_31_27 * t461 - t475 * t460;
  const Scalar t477 = t290 - mu_32_27_z * t473 + b_32_31_27 * t472 - t475 * t471 - t476 * t468;
  const Scalar b_29_28_28 = Ic_28_zz - mu_32_28_z * t473 + b_32_31_28 * t472 + t464 * t471 +
      t465 * t468;
  const Scalar d_28 = Scalar(1.0) / b_29_28_28;
  const Scalar t478 = t477 * d_28;
  const Scalar mu_27_15_z = Scalar(0.33) * hu_27_t_x - t291 + c_26 * t397;
  const Scalar t479 = t476 * t467;
  const Scalar t480 = t475 * d_30;
  const Scalar t481 = b_32_31_27 * t452;
  const Scalar t482 = Scalar(707.7641729774637) * mu_32_27_z;
  const Scalar t483 = t399 + s_14 * mu_27_15_z + mu_u_32_14_t_y * t482 + b_32_31_13 * t481 +
      t459 * t480 - t463 * t479 - t474 * t478;
  const Scalar t484 = t446 + mu_u_32_27_t_y * t435;
  const Scalar t485 = t425 + mu_u_32_27_t_y * t458 + t484 * t454;
  const Scalar t486 = t413 - mu_u_32_27_t_y * t462 - t484 * t461 - t485 * t460;
  const Scalar t487 = t401 + mu_u_32_27_t_y * t473 + t484 * t472 - t485 * t471 - t486 * t468;
  const Scalar b_28_27_26 = Iu_27_t_yz + mu_u_32_27_t_y * t482 + t484 * t481 + t485 * t480 +
      t486 * t479 - t487 * t478;
  const Scalar t488 = t286 + mu_32_27_z * t482 - b_32_31_27 * t481 - t475 * t480 - t476 * t479 +
      t477 * t478;
  const Scalar t489 = Scalar(1.0) / t488;
  const Scalar t490 = b_28_27_26 * t489;
  const Scalar t491 = t487 * d_28;
  const Scalar t492 = t486 * t467;
  const Scalar t493 = t485 * d_30;
  const Scalar t494 = t484 * t452;
  const Scalar t495 = Scalar(707.7641729774637) * mu_u_32_27_t_y;
  const Scalar t496 = t396 + s_14 * t390 - mu_u_32_14_t_y * t495 + b_32_31_13 * t494 + t459 * t493 -
      t463 * t492 - t474 * t491 + t483 * t490;
  const Scalar t497 = t450 - t434 * t435;
  const Scalar t498 = t457 - t434 * t458 + t497 * t454;
  const Scalar b_30_29_15 = mu_29_15_z + t434 * t462 - t497 * t461 - t498 * t460;
  const Scalar t499 = t470 + t434 * t473 - t497 * t472 + t498 * t471 + b_30_29_15 * t468;
  const Scalar b_28_27_15 = mu_27_15_z - t434 * t482 + t497 * t481 + t498 * t480 +
      b_30_29_15 * t479 + t499 * t478;
  const Scalar t500 = t390 + t434 * t495 + t497 * t494 + t498 * t493 + b_30_29_15 * t492 +
      t499 * t491 + b_28_27_15 * t490;
  const Scalar t501 = t359 + mu_u_32_27_t_y * t495 - t484 * t494 - t485 * t493 - t486 * t492 +
      t487 * t491 - b_28_27_26 * t490;
  const Scalar t502 = Scalar(1.0) / t501;
  const Scalar t503 = t500 * t502;
  const Scalar t504 = t360 + Scalar(0.33) * hu_19_t_x;
  const Scalar mu_u_19_15_t_x = c_15 * t371 + s_15 * t504;
  const Scalar t505 = t338 + Scalar(0.24) * t351;
  const Scalar t506 = c_19 * t344 - s_19 * t505;
  const Scalar t507 = t370 - Scalar(0.33) * s_19 * t351;
  const Scalar t508 = c_14 * (c_15 * t506 + s_15 * t507);
  const Scalar t509 = c_20 * t327 + s_20 * t333;
  const Scalar t510 = c_19 * t332 + s_20 * t363;
  const Scalar t511 = Scalar(0.24) * t510 - c_19 * t509 - s_19 * t343;
  const Scalar t512 = t334 - s_20 * t327;
  const Scalar t513 = t512 - Scalar(0.33) * t510;
  const Scalar mu_u_21_15_t_x = c_15 * t511 - s_15 * t513;
  const Scalar t514 = t311 + Scalar(0.004) * hu_22_t_x - Scalar(0.305) * t324;
  const Scalar t515 = s_21 * t320 - c_21 * t514;
  const Scalar t516 = c_20 * t330 + s_20 * t515;
  const Scalar t517 = c_21 * t320 + s_21 * t514;
  const Scalar t518 = s_21 * t324;
  const Scalar f_u_22_20_t_x = c_20 * hu_22_t_x - s_20 * t518;
  const Scalar t519 = c_21 * t324;
  const Scalar t520 = c_19 * t519 - s_19 * f_u_22_20_t_x;
  const Scalar t521 = Scalar(0.24) * t520 - c_19 * t516 + s_19 * t517;
  const Scalar t522 = c_20 * t515 - s_20 * t330;
  const Scalar t523 = t522 - Scalar(0.33) * t520;
  const Scalar t524 = c_14 * (c_15 * t521 - s_15 * t523);
  const Scalar t525 = Scalar(0.004) * hu_23_t_x;
  const Scalar mu_23_22_y = Ic_23_zz - t525;
  const Scalar mu_u_23_22_t_x = c_22 * mu_23_22_x + s_22 * mu_23_22_y;
  const Scalar t526 = s_22 * t315;
  const Scalar t527 = t319 - Scalar(0.004) * t526;
  const Scalar t528 = c_22 * t331 - s_21 * hu_23_t_x;
  const Scalar t529 = Scalar(0.305) * t528 + c_21 * t527 - s_21 * mu_u_23_22_t_x;
  const Scalar mu_23_21_z = t525 + c_22 * mu_23_22_y - s_22 * mu_23_22_x;
  const Scalar mu_u_23_20_t_x = c_20 * mu_23_21_z - s_20 * t529;
  const Scalar t530 = c_21 * hu_23_t_x + c_22 * t341;
  const Scalar t531 = Scalar(0.305) * t530 + c_21 * mu_u_23_22_t_x + s_21 * t527;
  const Scalar f_u_23_20_t_x = c_20 * t526 - s_20 * t530;
  const Scalar t532 = c_19 * t528 - s_19 * f_u_23_20_t_x;
  const Scalar t533 = Scalar(0.24) * t532 + c_19 * mu_u_23_20_t_x - s_19 * t531;
  const Scalar mu_u_23_20_t_y = c_20 * t529 + s_20 * mu_23_21_z;
  const Scalar mu_23_15_y = mu_u_23_20_t_y - Scalar(0.33) * t532;
  const Scalar t534 = c_14 * (c_15 * t533 - s_15 * mu_23_15_y);
  const Scalar f_u_25_23_t_y = c_24 * t304 + s_23 * t301;
  const Scalar t535 = Scalar(0.004) * f_u_25_23_t_y;
  const Scalar mu_u_25_24_t_y = Scalar(0.0014129000000002) * c_24 + Scalar(0.0007482) * t295;
  const Scalar mu_25_22_y = mu_u_25_24_t_y + t535;
  const Scalar mu_u_25_24_t_x = Scalar(0.0014129000000002) * s_24 - Scalar(0.0007482) * t297;
  const Scalar mu_25_22_x = t308 + Scalar(0.239) * f_u_25_23_t_y - s_23 * mu_u_25_24_t_x;
  const Scalar t536 = c_22 * mu_25_22_x - s_22 * mu_25_22_y;
  const Scalar t537 = c_23 * t301 - c_24 * t314;
  const Scalar t538 = s_24 * t303;
  const Scalar f_u_25_22_t_x = c_22 * t537 + s_22 * t538;
  const Scalar t539 = c_21 * f_u_25_22_t_x - s_21 * f_u_25_23_t_y;
  const Scalar f_u_25_22_t_y = c_22 * t538 - s_22 * t537;
  const Scalar mu_25_22_z = t318 - Scalar(0.239) * t537 + Scalar(0.0000376) * s_24 * s_25 +
      c_23 * mu_u_25_24_t_x;
  const Scalar mu_25_21_y = mu_25_22_z - Scalar(0.004) * f_u_25_22_t_y;
  const Scalar t540 = Scalar(0.305) * t539 - c_21 * mu_25_21_y - s_21 * t536;
  const Scalar mu_25_21_z = t535 - c_22 * mu_25_22_y - s_22 * mu_25_22_x;
  const Scalar mu_u_25_20_t_x = c_20 * mu_25_21_z - s_20 * t540;
  const Scalar f_u_25_21_t_x = c_21 * f_u_25_23_t_y + s_21 * f_u_25_22_t_x;
  const Scalar f_u_25_20_t_x = c_20 * f_u_25_22_t_y + s_20 * f_u_25_21_t_x;
  const Scalar f_u_25_19_t_y = c_19 * t539 + s_19 * f_u_25_20_t_x;
  const Scalar mu_25_20_z = Scalar(0.305) * f_u_25_21_t_x + c_21 * t536 - s_21 * mu_25_21_y;
  const Scalar mu_25_15_x = Scalar(0.24) * f_u_25_19_t_y + c_19 * mu_u_25_20_t_x -
      s_19 * mu_25_20_z;
  const Scalar mu_u_25_20_t_y = c_20 * t540 + s_20 * mu_25_21_z;
  const Scalar mu_25_15_y = mu_u_25_20_t_y - Scalar(0.33) * f_u_25_19_t_y;
  const Scalar f_u_25_19_t_x = c_19 * f_u_25_20_t_x - s_19 * t539;
  const Scalar t541 = c_20 * f_u_25_21_t_x - s_20 * f_u_25_22_t_y;
  const Scalar t542 = Scalar(0.33) * t541 + Scalar(0.24) * f_u_25_19_t_x - c_19 * mu_25_20_z -
      s_19 * mu_u_25_20_t_x;
  const Scalar t543 = c_14 * (c_15 * mu_25_15_x - s_15 * mu_25_15_y) + s_14 * t542;
  const Scalar t544 = Scalar(0.5295491542217383) * s_25;
  const Scalar t545 = Ic_24_zz + Scalar(0.239) * hu_24_t_y;
  const Scalar t546 = t298 * t318 - c_23 * t545;
  const Scalar t547 = c_23 * hu_24_t_y;
  const Scalar t548 = Scalar(0.004) * t547;
  const Scalar t549 = t306 * t307;
  const Scalar mu_24_22_y = t548 + t549;
  const Scalar t550 = c_22 * t546 + s_22 * mu_24_22_y;
  const Scalar t551 = s_23 * hu_24_t_y;
  const Scalar t552 = c_22 * t551 - s_22 * hu_24_t_x;
  const Scalar f_u_24_21_t_y = c_21 * t552 + s_21 * t547;
  const Scalar mu_24_22_z = Scalar(0.004) * hu_24_t_x + s_23 * t545 + t298 * t308;
  const Scalar f_u_24_22_t_y = c_22 * hu_24_t_x + s_22 * t551;
  const Scalar mu_24_21_y = mu_24_22_z - Scalar(0.004) * f_u_24_22_t_y;
  const Scalar mu_24_20_x = Scalar(0.305) * f_u_24_21_t_y + c_21 * mu_24_21_y - s_21 * t550;
  const Scalar mu_24_21_z = t548 - c_22 * mu_24_22_y + s_22 * t546;
  const Scalar mu_u_24_20_t_x = c_20 * mu_24_21_z + s_20 * mu_24_20_x;
  const Scalar f_u_24_21_t_x = c_21 * t547 - s_21 * t552;
  const Scalar f_u_24_20_t_x = c_20 * f_u_24_22_t_y + s_20 * f_u_24_21_t_x;
  const Scalar t553 = c_19 * f_u_24_21_t_y - s_19 * f_u_24_20_t_x;
  const Scalar mu_24_20_z = Scalar(0.305) * f_u_24_21_t_x - c_21 * t550 - s_21 * mu_24_21_y;
  const Scalar t554 = Scalar(0.24) * t553 - c_19 * mu_u_24_20_t_x + s_19 * mu_24_20_z;
  const Scalar t555 = c_20 * mu_24_20_x - s_20 * mu_24_21_z;
  const Scalar t556 = t555 - Scalar(0.33) * t553;
  const Scalar mu_u_24_15_t_x = c_15 * t554 - s_15 * t556;
  const Scalar f_u_24_19_t_x = c_19 * f_u_24_20_t_x + s_19 * f_u_24_21_t_y;
  const Scalar t557 = c_20 * f_u_24_21_t_x - s_20 * f_u_24_22_t_y;
  const Scalar t558 = Scalar(0.33) * t557 + Scalar(0.24) * f_u_24_19_t_x - c_19 * mu_24_20_z -
      s_19 * mu_u_24_20_t_x;
  const Scalar t559 = c_14 * mu_u_24_15_t_x - s_14 * t558 + t543 * t544;
  const Scalar t560 = Scalar(0.00039620867718870463) * t293 - Ic_24_zz;
  const Scalar t561 = Scalar(1.0) / t560;
  const Scalar b_25_24_23 = t549 - mu_u_25_24_t_y * t544;
  const Scalar t562 = b_25_24_23 * t561;
  const Scalar t563 = c_19 * f_u_23_20_t_x + s_19 * t528;
  const Scalar t564 = c_20 * t530 + s_20 * t526;
  const Scalar t565 = Scalar(0.33) * t564 - Scalar(0.24) * t563 - c_19 * t531 -
      s_19 * mu_u_23_20_t_x;
  const Scalar t566 = Scalar(707.7641729774637) * mu_u_25_24_t_y;
  const Scalar t567 = t534 + s_14 * t565 - t543 * t566 - t559 * t562;
  const Scalar b_25_24_22 = mu_24_22_z - mu_25_22_z * t544;
  const Scalar t568 = t319 + mu_25_22_z * t566 - b_25_24_22 * t562;
  const Scalar b_24_23_23 = Ic_23_zz + mu_u_25_24_t_y * t566 - b_25_24_23 * t562;
  const Scalar d_23 = Scalar(1.0) / b_24_23_23;
  const Scalar t569 = t568 * d_23;
  const Scalar t570 = c_19 * f_u_22_20_t_x + s_19 * t519;
  const Scalar f_u_22_20_t_y = c_20 * t518 + s_20 * hu_22_t_x;
  const Scalar mu_22_15_z = Scalar(0.33) * f_u_22_20_t_y - Scalar(0.24) * t570 + c_19 * t517 +
      s_19 * t516;
  const Scalar t571 = b_25_24_22 * t561;
  const Scalar t572 = Scalar(707.7641729774637) * mu_25_22_z;
  const Scalar t573 = t524 + s_14 * mu_22_15_z + t543 * t572 + t559 * t571 + t567 * t569;
  const Scalar b_25_24_21 = mu_24_21_z - mu_25_21_z * t544;
  const Scalar b_24_23_21 = mu_23_21_z - mu_25_21_z * t566 + b_25_24_21 * t562;
  const Scalar t574 = t330 - mu_25_21_z * t572 + b_25_24_21 * t571 - b_24_23_21 * t569;
  const Scalar t575 = t311 + mu_25_22_z * t572 - b_25_24_22 * t571 - t568 * t569;
  const Scalar t576 = Scalar(1.0) / t575;
  const Scalar t577 = t574 * t576;
  const Scalar f_u_21_19_t_x = s_20 * t384 - s_19 * t332;
  const Scalar mu_21_15_z = Scalar(0.24) * f_u_21_19_t_x + Scalar(0.33) * c_20 * t342 -
      c_19 * t343 + s_19 * t509;
  const Scalar t578 = b_24_23_21 * d_23;
  const Scalar t579 = b_25_24_21 * t561;
  const Scalar t580 = Scalar(707.7641729774637) * mu_25_21_z;
  const Scalar t581 = c_14 * mu_u_21_15_t_x + s_14 * mu_21_15_z + t543 * t580 + t559 * t579 -
      t567 * t578 + t573 * t577;
  const Scalar b_25_24_20 = mu_24_20_z - mu_25_20_z * t544;
  const Scalar t582 = t531 - mu_25_20_z * t566 + b_25_24_20 * t562;
  const Scalar t583 = t517 - mu_25_20_z * t572 + b_25_24_20 * t571 - t582 * t569;
  const Scalar t584 = t343 + mu_25_20_z * t580 - b_25_24_20 * t579 - t582 * t578 - t583 * t577;
  const Scalar t585 = t327 - mu_25_21_z * t580 + b_25_24_21 * t579 + b_24_23_21 * t578 +
      t574 * t577;
  const Scalar t586 = Scalar(1.0) / t585;
  const Scalar t587 = t584 * t586;
  const Scalar mu_20_15_z = Scalar(0.33) * hu_20_t_x + t345 + c_19 * t505;
  const Scalar t588 = t583 * t576;
  const Scalar t589 = t582 * d_23;
  const Scalar t590 = b_25_24_20 * t561;
  const Scalar t591 = Scalar(707.7641729774637) * mu_25_20_z;
  const Scalar t592 = t508 - s_14 * mu_20_15_z + t543 * t591 + t559 * t590 - t567 * t589 +
      t573 * t588 + t581 * t587;
  const Scalar t593 = t555 + mu_u_25_20_t_y * t544;
  const Scalar b_24_23_19 = mu_u_23_20_t_y - mu_u_25_20_t_y * t566 - t593 * t562;
  const Scalar t594 = t522 + mu_u_25_20_t_y * t572 + t593 * t571 + b_24_23_19 * t569;
  const Scalar t595 = t512 + mu_u_25_20_t_y * t580 + t593 * t579 - b_24_23_19 * t578 + t594 * t577;
  const Scalar t596 = t370 - mu_u_25_20_t_y * t591 - t593 * t590 + b_24_23_19 * t589 - t594 * t588 -
      t595 * t587;
  const Scalar t597 = t338 + mu_25_20_z * t591 - b_25_24_20 * t590 - t582 * t589 - t583 * t588 +
      t584 * t587;
  const Scalar t598 = Scalar(1.0) / t597;
  const Scalar t599 = t596 * t598;
  const Scalar t600 = t595 * t586;
  const Scalar t601 = t594 * t576;
  const Scalar t602 = b_24_23_19 * d_23;
  const Scalar t603 = t593 * t561;
  const Scalar t604 = Scalar(707.7641729774637) * mu_u_25_20_t_y;
  const Scalar t605 = c_14 * mu_u_19_15_t_x - s_14 * t389 - t543 * t604 + t559 * t603 +
      t567 * t602 + t573 * t601 - t581 * t600 - t592 * t599;
  const Scalar t606 = t558 - t542 * t544;
  const Scalar t607 = t565 - t542 * t566 + t606 * t562;
  const Scalar b_23_22_15 = mu_22_15_z + t542 * t572 - t606 * t571 + t607 * t569;
  const Scalar b_22_21_15 = mu_21_15_z + t542 * t580 - t606 * t579 - t607 * t578 +
      b_23_22_15 * t577;
  const Scalar b_21_20_15 = mu_20_15_z - t542 * t591 + t606 * t590 + t607 * t589 -
      b_23_22_15 * t588 - b_22_21_15 * t587;
  const Scalar t608 = t389 + t542 * t604 + t606 * t603 - t607 * t602 - b_23_22_15 * t601 +
      b_22_21_15 * t600 - b_21_20_15 * t599;
  const Scalar t609 = t360 + mu_u_25_20_t_y * t604 - t593 * t603 - b_24_23_19 * t602 - t594 * t601 +
      t595 * t600 - t596 * t599;
  const Scalar t610 = Scalar(1.0) / t609;
  const Scalar t611 = t608 * t610;
  const Scalar t612 = b_28_27_15 * t489;
  const Scalar t613 = b_21_20_15 * t598;
  const Scalar t614 = t499 * d_28;
  const Scalar t615 = b_22_21_15 * t586;
  const Scalar t616 = b_30_29_15 * t467;
  const Scalar t617 = b_23_22_15 * t576;
  const Scalar t618 = t498 * d_30;
  const Scalar t619 = t607 * d_23;
  const Scalar t620 = t497 * t452;
  const Scalar t621 = t606 * t561;
  const Scalar t622 = t434 * mu_u_32_14_t_y - t542 * t543;
  const Scalar Ic_17_zz = t353 - Scalar(0.03438);
  const Scalar t623 = Ic_17_zz - Scalar(0.453) * t364;
  const Scalar mu_17_15_y = s_16 * t623 - s_17 * (t385 - t387);
  const Scalar t624 = c_17 * (Iu_18_t_xy - c_16 * t387);
  const Scalar t625 = t366 + c_16 * t623;
  const Scalar t626 = c_14 * (c_15 * t624 + s_15 * mu_17_15_y) - s_14 * t625;
  const Scalar d_17 = Scalar(1.0) / Ic_17_zz;
  const Scalar t627 = Iu_18_t_xy * d_17;
  const Scalar t628 = c_17 * t627;
  const Scalar mu_16_15_x = Ic_16_zz - Scalar(0.003) * hu_16_t_y;
  const Scalar t629 = c_14 * (c_15 * mu_16_15_x + s_15 * t376);
  const Scalar f_u_18_16_t_x = hu_18_t_y * t374 + s_16 * hu_18_t_x;
  const Scalar mu_18_15_x = Scalar(0.03408) * s_17 - Scalar(0.003) * f_u_18_16_t_x;
  const Scalar t630 = hu_18_t_y * t356 - c_16 * hu_18_t_x;
  const Scalar t631 = Scalar(0.03408) * c_17;
  const Scalar t632 = Scalar(0.453) * t630 - (c_16 - Scalar(0.0880281690140845) * hu_18_t_y) * t631;
  const Scalar mu_18_15_z = Scalar(0.453) * f_u_18_16_t_x + s_16 * t631;
  const Scalar mu_u_18_14_t_y = c_14 * (c_15 * mu_18_15_x - s_15 * t632) + s_14 * mu_18_15_z;
  const Scalar t633 = t629 + s_14 * t386 - s_17 * mu_u_18_14_t_y + t626 * t628;
  const Scalar t634 = Iu_18_t_xy * t627;
  const Scalar b_17_16_16 = Ic_16_zz + t634 - t354 * (t634 + Scalar(0.03408));
  const Scalar t635 = Scalar(1.0) / b_17_16_16;
  const Scalar t636 = t386 - s_17 * mu_18_15_z - t625 * t628;
  const Scalar t637 = t636 * t635;
  const Scalar t638 = t625 * d_17;
  const Scalar t639 = Scalar(29.342723004694836) * mu_18_15_z;
  const Scalar t640 = t392 - Scalar(707.7641729774637) * t622 - s_14 * t381 - b_32_31_13 * t620 -
      t459 * t618 + t463 * t616 - t474 * t614 - t483 * t612 - t496 * t503 + t559 * t621 -
      t567 * t619 - t573 * t617 + t581 * t615 + t592 * t613 + t605 * t611 + mu_u_18_14_t_y * t639 +
      t626 * t638 + t633 * t637;
  const Scalar Iu_15_t_yz = c_15 * t391 + s_15 * t388;
  const Scalar t641 = c_15 * mu_32_15_y - s_15 * mu_32_15_x;
  const Scalar t642 = c_15 * t447 - s_15 * t445 + t641 * t435;
  const Scalar t643 = c_15 * t426 - s_15 * mu_30_15_x + t641 * t458 + t642 * t454;
  const Scalar t644 = c_15 * t414 + s_15 * t412 - t641 * t462 - t642 * t461 - t643 * t460;
  const Scalar t645 = c_15 * t402 - s_15 * mu_28_15_x + t641 * t473 + t642 * t472 - t643 * t471 -
      t644 * t468;
  const Scalar t646 = c_15 * mu_27_15_y - s_15 * t398 + t641 * t482 + t642 * t481 + t643 * t480 +
      t644 * t479 - t645 * t478;
  const Scalar t647 = c_15 * t395 + s_15 * t373 + t641 * t495 - t642 * t494 - t643 * t493 -
      t644 * t492 + t645 * t491 - t646 * t490;
  const Scalar mu_u_25_15_t_y = c_15 * mu_25_15_y + s_15 * mu_25_15_x;
  const Scalar b_25_24_14 = c_15 * t556 + s_15 * t554 + mu_u_25_15_t_y * t544;
  const Scalar t648 = c_15 * mu_23_15_y + s_15 * t533 - mu_u_25_15_t_y * t566 - b_25_24_14 * t562;
  const Scalar t649 = c_15 * t523 + s_15 * t521 + mu_u_25_15_t_y * t572 + b_25_24_14 * t571 +
      t648 * t569;
  const Scalar t650 = c_15 * t513 + s_15 * t511 + mu_u_25_15_t_y * t580 + b_25_24_14 * t579 -
      t648 * t578 + t649 * t577;
  const Scalar t651 = c_15 * t507 - s_15 * t506 - mu_u_25_15_t_y * t591 - b_25_24_14 * t590 +
      t648 * t589 - t649 * t588 - t650 * t587;
  const Scalar t652 = c_15 * t504 - s_15 * t371 + mu_u_25_15_t_y * t604 - b_25_24_14 * t603 -
      t648 * t602 - t649 * t601 + t650 * t600 - t651 * t599;
  const Scalar t653 = t434 * t641 + t542 * mu_u_25_15_t_y;
  const Scalar t654 = c_15 * mu_17_15_y - s_15 * t624;
  const Scalar t655 = c_15 * t632 + s_15 * mu_18_15_x;
  const Scalar t656 = c_15 * t376 - s_15 * mu_16_15_x + s_17 * t655 + t654 * t628;
  const Scalar b_16_15_14 = Iu_15_t_yz + Scalar(707.7641729774637) * t653 + t642 * t620 +
      t643 * t618 + t644 * t616 + t645 * t614 + t646 * t612 - t647 * t503 + b_25_24_14 * t621 -
      t648 * t619 - t649 * t617 + t650 * t615 - t651 * t613 - t652 * t611 + t655 * t639 -
      t654 * t638 - t656 * t637;
  const Scalar t657 = t434 * t434 + t542 * t542;
  const Scalar b_16_15_15 = t381 - Scalar(707.7641729774637) * t657 + t497 * t620 + t498 * t618 +
      b_30_29_15 * t616 - t499 * t614 + b_28_27_15 * t612 + t500 * t503 + t606 * t621 +
      t607 * t619 + b_23_22_15 * t617 - b_22_21_15 * t615 + b_21_20_15 * t613 + t608 * t611 -
      mu_18_15_z * t639 + t625 * t638 - t636 * t637;
  const Scalar t658 = Scalar(1.0) / b_16_15_15;
  const Scalar t659 = b_16_15_14 * t658;
  const Scalar t660 = t647 * t502;
  const Scalar t661 = t652 * t610;
  const Scalar t662 = t646 * t489;
  const Scalar t663 = t651 * t598;
  const Scalar t664 = t645 * d_28;
  const Scalar t665 = t650 * t586;
  const Scalar t666 = t644 * t467;
  const Scalar t667 = t649 * t576;
  const Scalar t668 = t643 * d_30;
  const Scalar t669 = t648 * d_23;
  const Scalar t670 = t642 * t452;
  const Scalar t671 = b_25_24_14 * t561;
  const Scalar t672 = t641 * mu_u_32_14_t_y - mu_u_25_15_t_y * t543;
  const Scalar t673 = t656 * t635;
  const Scalar t674 = t654 * d_17;
  const Scalar t675 = Scalar(29.342723004694836) * t655;
  const Scalar t676 = Scalar(707.7641729774637) * t672 + t394 - s_14 * Iu_15_t_yz -
      b_32_31_13 * t670 - t459 * t668 + t463 * t666 + t474 * t664 - t483 * t662 + t496 * t660 +
      t559 * t671 + t567 * t669 + t573 * t667 - t581 * t665 - t592 * t663 - t605 * t661 -
      mu_u_18_14_t_y * t675 - t626 * t674 + t633 * t673 - t640 * t659;
  const Scalar t677 = t641 * t641 + mu_u_25_15_t_y * mu_u_25_15_t_y;
  const Scalar t678 = t358 - t379 + Scalar(707.7641729774637) * t677 - t642 * t670 - t643 * t668 -
      t644 * t666 + t645 * t664 - t646 * t662 - t647 * t660 - b_25_24_14 * t671 - t648 * t669 -
      t649 * t667 + t650 * t665 - t651 * t663 - t652 * t661 + t655 * t675 - t654 * t674 +
      t656 * t673 + b_16_15_14 * t659 - Scalar(2.5075600666670006);
  const Scalar t679 = Scalar(1.0) / t678;
  const Scalar t680 = t676 * t679;
  const Scalar t681 = t640 * t658;
  const Scalar t682 = t496 * t502;
  const Scalar t683 = t605 * t610;
  const Scalar t684 = t483 * t489;
  const Scalar t685 = t592 * t598;
  const Scalar t686 = t474 * d_28;
  const Scalar t687 = t581 * t586;
  const Scalar t688 = t463 * t467;
  const Scalar t689 = t573 * t576;
  const Scalar t690 = t459 * d_30;
  const Scalar t691 = t567 * d_23;
  const Scalar t692 = b_32_31_13 * t452;
  const Scalar t693 = t559 * t561;
  const Scalar t694 = mu_u_32_14_t_y * mu_u_32_14_t_y + t543 * t543;
  const Scalar t695 = t633 * t635;
  const Scalar t696 = t626 * d_17;
  const Scalar t697 = Scalar(29.342723004694836) * mu_u_18_14_t_y;
  const Scalar t698 = t380 + Scalar(707.7641729774637) * t694 + t393 - b_32_31_13 * t692 -
      t459 * t690 - t463 * t688 + t474 * t686 - t483 * t684 - t496 * t682 - t559 * t693 -
      t567 * t691 - t573 * t689 + t581 * t687 - t592 * t685 - t605 * t683 + mu_u_18_14_t_y * t697 -
      t626 * t696 + t633 * t695 + t640 * t681 - t676 * t680 - Scalar(2.5107600666670002);
  const Scalar t699 = c_14 * c_15;
  const Scalar t700 = qd_13 * t699 - s_15 * qd_14;
  const Scalar t701 = qd_13 * qd_14;
  const Scalar t702 = s_14 * t701;
  const Scalar domega_15_y = s_15 * t702 - qd_15 * t700;
  const Scalar t703 = s_14 * qd_13;
  const Scalar omega_15_z = qd_15 - t703;
  const Scalar t704 = t700 * omega_15_z;
  const Scalar U_15_zx = domega_15_y - t704;
  const Scalar t705 = Scalar(9.81) * s_14;
  const Scalar t706 = Scalar(0.33) * U_15_zx + t705;
  const Scalar t707 = c_14 * s_15;
  const Scalar omega_r_15_y = c_15 * qd_14 + qd_13 * t707;
  const Scalar domega_15_x = c_15 * t702 + qd_15 * omega_r_15_y;
  const Scalar t708 = omega_r_15_y * omega_15_z;
  const Scalar U_15_zy = domega_15_x + t708;
  const Scalar t709 = Scalar(0.24) * U_15_zy;
  const Scalar t710 = t706 - t709;
  const Scalar t711 = omega_r_15_y * omega_r_15_y;
  const Scalar t712 = omega_15_z * omega_15_z;
  const Scalar U_15_xx = t711 + t712;
  const Scalar t713 = Scalar(9.81) * t699;
  const Scalar t714 = Scalar(0.33) * U_15_xx - t713;
  const Scalar t715 = t700 * omega_r_15_y;
  const Scalar t716 = c_14 * t701;
  const Scalar U_15_xy = t716 - t715;
  const Scalar t717 = Scalar(0.24) * U_15_xy;
  const Scalar t718 = t714 + t717;
  const Scalar t719 = c_26 * t718 + s_26 * t710;
  const Scalar t720 = t716 + t715;
  const Scalar t721 = Scalar(9.81) * t707;
  const Scalar t722 = Scalar(0.33) * t720 + t721;
  const Scalar t723 = t700 * t700;
  const Scalar U_15_yy = t712 + t723;
  const Scalar t724 = Scalar(0.24) * U_15_yy;
  const Scalar t725 = t722 - t724;
  const Scalar t726 = c_27 * t725 - s_27 * t719;
  const Scalar omega_r_26_x = c_26 * t700 + s_26 * omega_15_z;
  const Scalar omega_26_z = qd_26 + omega_r_15_y;
  const Scalar omega_r_27_x = c_27 * omega_26_z + s_27 * omega_r_26_x;
  const Scalar t727 = c_27 * omega_r_26_x - s_27 * omega_26_z;
  const Scalar t728 = omega_r_27_x * t727;
  const Scalar domega_26_y = c_26 * t716 - s_26 * domega_15_x + qd_26 * omega_r_26_x;
  const Scalar U_27_xy = domega_26_y + t728;
  const Scalar t729 = t726 - Scalar(0.305) * U_27_xy;
  const Scalar t730 = c_26 * t710 - s_26 * t718;
  const Scalar omega_r_26_y = c_26 * omega_15_z - s_26 * t700;
  const Scalar t731 = c_26 * domega_15_x + s_26 * t716 - qd_26 * omega_r_26_y;
  const Scalar domega_27_x = c_27 * domega_15_y + s_27 * t731 - qd_27 * t727;
  const Scalar omega_27_z = qd_27 + omega_r_26_y;
  const Scalar t732 = t727 * omega_27_z;
  const Scalar U_27_zy = domega_27_x - t732;
  const Scalar t733 = t730 - Scalar(0.305) * U_27_zy;
  const Scalar t734 = c_28 * omega_r_27_x - s_28 * omega_27_z;
  const Scalar omega_28_z = qd_28 + t727;
  const Scalar t735 = omega_28_z * omega_28_z;
  const Scalar U_28_xx = t734 * t734 + t735;
  const Scalar ddp_o_29_x = Scalar(0.004) * U_28_xx + c_28 * t733 - s_28 * t729;
  const Scalar U_27_yy = omega_r_27_x * omega_r_27_x + omega_27_z * omega_27_z;
  const Scalar ddp_o_28_y = Scalar(0.305) * U_27_yy - c_27 * t719 - s_27 * t725;
  const Scalar omega_r_28_x = c_28 * omega_27_z + s_28 * omega_r_27_x;
  const Scalar domega_28_y = c_28 * domega_27_x - s_28 * domega_26_y + qd_28 * omega_r_28_x;
  const Scalar t736 = omega_r_28_x * omega_28_z;
  const Scalar U_28_zx = domega_28_y + t736;
  const Scalar ddp_o_29_z = ddp_o_28_y + Scalar(0.004) * U_28_zx;
  const Scalar ddp_29_x = c_29 * ddp_o_29_x + s_29 * ddp_o_29_z;
  const Scalar omega_r_29_y = c_29 * omega_28_z + s_29 * omega_r_28_x;
  const Scalar omega_29_z = qd_29 + t734;
  const Scalar t737 = omega_29_z * omega_29_z;
  const Scalar U_29_xx = omega_r_29_y * omega_r_29_y + t737;
  const Scalar t738 = c_29 * omega_r_28_x - s_29 * omega_28_z;
  const Scalar t739 = t738 * omega_r_29_y;
  const Scalar U_29_xy = domega_28_y - t739;
  const Scalar ddp_o_30_x = ddp_29_x - Scalar(0.004) * U_29_xx - Scalar(0.239) * U_29_xy;
  const Scalar t740 = c_28 * t729 + s_28 * t733;
  const Scalar t741 = omega_r_28_x * t734;
  const Scalar domega_27_y = c_27 * t731 - s_27 * domega_15_y + qd_27 * omega_r_27_x;
  const Scalar U_28_yx = domega_27_y - t741;
  const Scalar t742 = t740 - Scalar(0.004) * U_28_yx;
  const Scalar domega_28_x = c_28 * domega_26_y + s_28 * domega_27_x - qd_28 * t734;
  const Scalar domega_29_y = c_29 * domega_27_y + s_29 * domega_28_x - qd_29 * t738;
  const Scalar t743 = t738 * omega_29_z;
  const Scalar U_29_zx = domega_29_y - t743;
  const Scalar domega_29_x = c_29 * domega_28_x - s_29 * domega_27_y + qd_29 * omega_r_29_y;
  const Scalar t744 = omega_r_29_y * omega_29_z;
  const Scalar U_29_zy = domega_29_x + t744;
  const Scalar t745 = t742 + Scalar(0.004) * U_29_zx - Scalar(0.239) * U_29_zy;
  const Scalar t746 = c_30 * t745 + s_30 * ddp_o_30_x;
  const Scalar t747 = c_29 * ddp_o_29_z - s_29 * ddp_o_29_x;
  const Scalar U_29_yx = domega_28_y + t739;
  const Scalar U_29_yy = t737 + t738 * t738;
  const Scalar t748 = t747 - Scalar(0.004) * U_29_yx + Scalar(0.239) * U_29_yy;
  const Scalar t749 = c_31 * t746 + s_31 * t748;
  const Scalar t750 = c_30 * ddp_o_30_x - s_30 * t745;
  const Scalar ddp_32_x = c_32 * t750 - s_32 * t749;
  const Scalar omega_r_30_y = c_30 * t738 + s_30 * omega_29_z;
  const Scalar domega_30_x = c_30 * domega_28_y - s_30 * domega_29_x + qd_30 * omega_r_30_y;
  const Scalar omega_r_30_x = c_30 * omega_29_z - s_30 * t738;
  const Scalar omega_30_z = qd_30 + omega_r_29_y;
  const Scalar t751 = c_31 * omega_30_z - s_31 * omega_r_30_x;
  const Scalar domega_31_x = c_31 * domega_30_x + s_31 * domega_29_y - qd_31 * t751;
  const Scalar omega_r_31_x = c_31 * omega_r_30_x + s_31 * omega_30_z;
  const Scalar omega_31_z = qd_31 + omega_r_30_y;
  const Scalar omega_r_32_x = c_32 * omega_31_z + s_32 * omega_r_31_x;
  const Scalar t752 = c_30 * domega_29_x + s_30 * domega_28_y - qd_30 * omega_r_30_x;
  const Scalar domega_32_y = c_32 * domega_31_x - s_32 * t752 + qd_32 * omega_r_32_x;
  const Scalar omega_32_z = qd_32 + t751;
  const Scalar t753 = omega_r_32_x * omega_32_z;
  const Scalar U_32_xz = domega_32_y - t753;
  const Scalar t754 = c_32 * omega_r_31_x - s_32 * omega_31_z;
  const Scalar t755 = omega_r_32_x * t754;
  const Scalar domega_31_y = c_31 * domega_29_y - s_31 * domega_30_x + qd_31 * omega_r_31_x;
  const Scalar N_32_z = Scalar(0.0014129000000002) * domega_31_y + Scalar(0.0094) * ddp_32_x -
      Scalar(0.0005096) * t755 - Scalar(0.0007482) * U_32_xz;
  const Scalar y_32 = tau_32 + N_32_z;
  const Scalar t756 = c_31 * t748 - s_31 * t746;
  const Scalar t757 = omega_32_z * omega_32_z;
  const Scalar t758 = Scalar(0.0094) * t756 - Scalar(0.0007482) * (t757 - t754 * t754) -
      Scalar(0.0009033000000002) * t754 * omega_32_z;
  const Scalar U_32_xy = domega_31_y + t755;
  const Scalar N_32_y = Scalar(0.0005096) * domega_32_y - Scalar(0.0007482) * U_32_xy +
      Scalar(0.0014129000000002) * t753;
  const Scalar t759 = omega_r_31_x * t751;
  const Scalar t760 = Scalar(-0.0253235000000002) * t752;
  const Scalar t761 = Scalar(0.1902) * t749 - Scalar(0.0250035000000002) * t759 - c_32 * t758 +
      s_32 * N_32_y + t760;
  const Scalar y_32_31 = tau_31 - t761 - y_32 * t435;
  const Scalar mu_31_y = Scalar(0.0250035000000002) * domega_31_y - N_32_z -
      Scalar(0.0253235000000002) * omega_r_31_x * omega_31_z;
  const Scalar t762 = t751 * omega_31_z;
  const Scalar t763 = Scalar(0.1902) * t750 + Scalar(0.0503270000000004) * t762 - c_32 * N_32_y -
      s_32 * t758;
  const Scalar mu_30_z = Scalar(0.0259635000000002) * domega_29_y -
      Scalar(0.0253235000000002) * omega_r_30_x * omega_r_30_y - c_31 * mu_31_y - s_31 * t763;
  const Scalar y_31_30 = tau_30 + mu_30_z - y_32 * t458 + t454 * y_32_31;
  const Scalar mu_30_x = Scalar(0.0512870000000004) * omega_r_30_y * omega_30_z - c_31 * t763 +
      s_31 * mu_31_y;
  const Scalar t764 = t760 - t761 - Scalar(0.0259635000000002) * omega_r_30_x * omega_30_z;
  const Scalar U_32_yy = omega_r_32_x * omega_r_32_x + t757;
  const Scalar t765 = Scalar(0.1902) * (t752 + t759) -
      Scalar(0.0094) * (c_32 * U_32_yy - s_32 * U_32_xy);
  const Scalar U_32_zy = c_32 * t752 + s_32 * domega_31_x - t754 * (qd_32 + omega_32_z);
  const Scalar U_31_yy = omega_r_31_x * omega_r_31_x + omega_31_z * omega_31_z;
  const Scalar f_31_y = Scalar(0.1902) * U_31_yy + Scalar(0.0094) * U_32_zy;
  const Scalar f_u_31_t_x = c_31 * t765 + s_31 * f_31_y;
  const Scalar U_31_zy = domega_31_x - t762;
  const Scalar f_31_z = Scalar(0.1902) * U_31_zy -
      Scalar(0.0094) * (c_32 * U_32_xy + s_32 * U_32_yy);
  const Scalar f_u_30_t_x = c_30 * f_31_z + s_30 * f_u_31_t_x;
  const Scalar f_u_31_t_y = c_31 * f_31_y - s_31 * t765;
  const Scalar U_29_xx_yy = U_29_xx - U_29_yy;
  const Scalar mu_29_z = Scalar(0.2298769000000002) * domega_28_y - Scalar(0.8648) * ddp_29_x -
      Scalar(0.0328) * t747 - Scalar(0.2262745000000002) * t739 + Scalar(0.0050592) * U_29_xx_yy -
      Scalar(0.004) * f_u_31_t_y + Scalar(0.239) * f_u_30_t_x + c_30 * mu_30_x + s_30 * t764;
  const Scalar y_30_29 = tau_29 + mu_29_z - y_32 * t462 + t461 * y_32_31 + t460 * y_31_30;
  const Scalar t766 = c_30 * f_u_31_t_x - s_30 * f_31_z;
  const Scalar t767 = Scalar(0.8648) * t742 + Scalar(0.0050592) * U_29_zx -
      Scalar(0.4561514000000004) * t744 - Scalar(0.239) * t766 - c_30 * t764 + s_30 * mu_30_x;
  const Scalar t768 = Scalar(0.0328) * t742 - Scalar(0.2262745000000002) * domega_29_y -
      Scalar(0.2298769000000002) * t743 - Scalar(0.0050592) * U_29_zy + mu_30_z -
      Scalar(0.004) * t766;
  const Scalar f_29_z = Scalar(0.0328) * U_29_zx - Scalar(0.8648) * U_29_zy - t766;
  const Scalar t769 = t734 * omega_28_z;
  const Scalar U_28_yz = domega_28_x + t769;
  const Scalar mu_28_z = Scalar(0.2360429000000002) * domega_27_y + Scalar(0.0032) * t740 +
      Scalar(0.2282085000000002) * t741 + Scalar(0.0023) * U_28_yz - Scalar(0.004) * f_29_z +
      c_29 * t768 + s_29 * t767;
  const Scalar y_29_28 = tau_28 + mu_28_z - y_32 * t473 + t472 * y_32_31 - t471 * y_31_30 +
      t468 * y_30_29;
  const Scalar t770 = Scalar(0.0023) * U_28_yx - Scalar(0.4642514000000004) * t769 - c_29 * t767 +
      s_29 * t768;
  const Scalar f_29_x = Scalar(0.0328) * U_29_xx + Scalar(0.8648) * U_29_xy + f_u_30_t_x;
  const Scalar f_29_y = Scalar(0.0328) * U_29_yx - Scalar(0.8648) * U_29_yy - f_u_31_t_y;
  const Scalar f_u_29_t_y = c_29 * f_29_y + s_29 * f_29_x;
  const Scalar mu_28_y = Scalar(0.0032) * ddp_o_28_y + Scalar(0.2282085000000002) * domega_28_y -
      Scalar(0.2360429000000002) * t736 + Scalar(0.0023) * (t735 - omega_r_28_x * omega_r_28_x) -
      mu_29_z + Scalar(0.004) * f_u_29_t_y;
  const Scalar f_28_x = Scalar(0.0032) * U_28_xx + c_29 * f_29_x - s_29 * f_29_y;
  const Scalar f_28_y = Scalar(0.0032) * U_28_yx + f_29_z;
  const Scalar f_u_28_t_x = c_28 * f_28_y + s_28 * f_28_x;
  const Scalar t771 = Scalar(0.7079407000000002) * domega_26_y;
  const Scalar t772 = Scalar(1.661) * t726 - Scalar(0.7059807000000002) * t728 +
      Scalar(0.305) * f_u_28_t_x - c_28 * t770 - s_28 * mu_28_y - t771;
  const Scalar y_28_27 = tau_27 - t772 - y_32 * t482 + t481 * y_32_31 + t480 * y_31_30 -
      t479 * y_30_29 - t478 * y_29_28;
  const Scalar t773 = c_28 * f_28_x - s_28 * f_28_y;
  const Scalar t774 = Scalar(1.661) * t730 + Scalar(1.4139214000000004) * t732 -
      Scalar(0.305) * t773 + c_28 * mu_28_y - s_28 * t770;
  const Scalar mu_27_y = Scalar(0.7059807000000002) * domega_27_y - mu_28_z -
      Scalar(0.7079407000000002) * omega_r_27_x * omega_27_z;
  const Scalar t775 = Scalar(0.7099007000000002) * domega_15_y;
  const Scalar mu_26_z = Scalar(0.7079407000000002) * omega_r_26_x * omega_r_26_y - c_27 * t774 +
      s_27 * mu_27_y + t775;
  const Scalar y_27_26 = tau_26 + mu_26_z + y_32 * t495 + t494 * y_32_31 + t493 * y_31_30 -
      t492 * y_30_29 - t491 * y_29_28 + t490 * y_28_27;
  const Scalar ddp_o_19_z = t706 + t709;
  const Scalar t776 = t714 - t717;
  const Scalar t777 = c_19 * t776 + s_19 * ddp_o_19_z;
  const Scalar t778 = t722 + t724;
  const Scalar t779 = c_20 * t778 - s_20 * t777;
  const Scalar omega_r_19_x = c_19 * t700 + s_19 * omega_15_z;
  const Scalar omega_19_z = qd_19 + omega_r_15_y;
  const Scalar omega_r_20_x = c_20 * omega_19_z + s_20 * omega_r_19_x;
  const Scalar t780 = c_20 * omega_r_19_x - s_20 * omega_19_z;
  const Scalar t781 = omega_r_20_x * t780;
  const Scalar domega_19_y = c_19 * t716 - s_19 * domega_15_x + qd_19 * omega_r_19_x;
  const Scalar U_20_xy = domega_19_y + t781;
  const Scalar t782 = t779 - Scalar(0.305) * U_20_xy;
  const Scalar t783 = c_19 * ddp_o_19_z - s_19 * t776;
  const Scalar omega_r_19_y = c_19 * omega_15_z - s_19 * t700;
  const Scalar t784 = c_19 * domega_15_x + s_19 * t716 - qd_19 * omega_r_19_y;
  const Scalar domega_20_x = c_20 * domega_15_y + s_20 * t784 - qd_20 * t780;
  const Scalar omega_20_z = qd_20 + omega_r_19_y;
  const Scalar t785 = t780 * omega_20_z;
  const Scalar U_20_zy = domega_20_x - t785;
  const Scalar t786 = t783 - Scalar(0.305) * U_20_zy;
  const Scalar t787 = c_21 * omega_r_20_x - s_21 * omega_20_z;
  const Scalar omega_21_z = qd_21 + t780;
  const Scalar t788 = omega_21_z * omega_21_z;
  const Scalar U_21_xx = t787 * t787 + t788;
  const Scalar ddp_o_22_x = Scalar(0.004) * U_21_xx + c_21 * t786 - s_21 * t782;
  const Scalar U_20_yy = omega_r_20_x * omega_r_20_x + omega_20_z * omega_20_z;
  const Scalar ddp_o_21_y = Scalar(0.305) * U_20_yy - c_20 * t777 - s_20 * t778;
  const Scalar omega_r_21_x = c_21 * omega_20_z + s_21 * omega_r_20_x;
  const Scalar domega_21_y = c_21 * domega_20_x - s_21 * domega_19_y + qd_21 * omega_r_21_x;
  const Scalar t789 = omega_r_21_x * omega_21_z;
  const Scalar U_21_zx = domega_21_y + t789;
  const Scalar ddp_o_22_z = ddp_o_21_y + Scalar(0.004) * U_21_zx;
  const Scalar ddp_22_x = c_22 * ddp_o_22_x + s_22 * ddp_o_22_z;
  const Scalar omega_r_22_y = c_22 * omega_21_z + s_22 * omega_r_21_x;
  const Scalar omega_22_z = qd_22 + t787;
  const Scalar t790 = omega_22_z * omega_22_z;
  const Scalar U_22_xx = omega_r_22_y * omega_r_22_y + t790;
  const Scalar t791 = c_22 * omega_r_21_x - s_22 * omega_21_z;
  const Scalar t792 = t791 * omega_r_22_y;
  const Scalar U_22_xy = domega_21_y - t792;
  const Scalar ddp_o_23_x = ddp_22_x - Scalar(0.004) * U_22_xx - Scalar(0.239) * U_22_xy;
  const Scalar t793 = c_21 * t782 + s_21 * t786;
  const Scalar t794 = omega_r_21_x * t787;
  const Scalar domega_20_y = c_20 * t784 - s_20 * domega_15_y + qd_20 * omega_r_20_x;
  const Scalar U_21_yx = domega_20_y - t794;
  const Scalar t795 = t793 - Scalar(0.004) * U_21_yx;
  const Scalar domega_21_x = c_21 * domega_19_y + s_21 * domega_20_x - qd_21 * t787;
  const Scalar domega_22_y = c_22 * domega_20_y + s_22 * domega_21_x - qd_22 * t791;
  const Scalar t796 = t791 * omega_22_z;
  const Scalar U_22_zx = domega_22_y - t796;
  const Scalar domega_22_x = c_22 * domega_21_x - s_22 * domega_20_y + qd_22 * omega_r_22_y;
  const Scalar t797 = omega_r_22_y * omega_22_z;
  const Scalar U_22_zy = domega_22_x + t797;
  const Scalar t798 = t795 + Scalar(0.004) * U_22_zx - Scalar(0.239) * U_22_zy;
  const Scalar ddp_23_x = c_23 * t798 + s_23 * ddp_o_23_x;
  const Scalar t799 = c_22 * ddp_o_22_z - s_22 * ddp_o_22_x;
  const Scalar U_22_yx = domega_21_y + t792;
  const Scalar U_22_yy = t790 + t791 * t791;
  const Scalar t800 = t799 - Scalar(0.004) * U_22_yx + Scalar(0.239) * U_22_yy;
  const Scalar t801 = c_24 * ddp_23_x + s_24 * t800;
  const Scalar t802 = c_23 * ddp_o_23_x - s_23 * t798;
  const Scalar ddp_25_x = c_25 * t802 - s_25 * t801;
  const Scalar omega_r_23_y = c_23 * t791 + s_23 * omega_22_z;
  const Scalar domega_23_x = c_23 * domega_21_y - s_23 * domega_22_x + qd_23 * omega_r_23_y;
  const Scalar omega_r_23_x = c_23 * omega_22_z - s_23 * t791;
  const Scalar omega_23_z = qd_23 + omega_r_22_y;
  const Scalar t803 = c_24 * omega_23_z - s_24 * omega_r_23_x;
  const Scalar domega_24_x = c_24 * domega_23_x + s_24 * domega_22_y - qd_24 * t803;
  const Scalar omega_r_24_x = c_24 * omega_r_23_x + s_24 * omega_23_z;
  const Scalar omega_24_z = qd_24 + omega_r_23_y;
  const Scalar omega_r_25_x = c_25 * omega_24_z + s_25 * omega_r_24_x;
  const Scalar t804 = c_23 * domega_22_x + s_23 * domega_21_y - qd_23 * omega_r_23_x;
  const Scalar domega_25_y = c_25 * domega_24_x - s_25 * t804 + qd_25 * omega_r_25_x;
  const Scalar omega_25_z = qd_25 + t803;
  const Scalar t805 = omega_r_25_x * omega_25_z;
  const Scalar U_25_xz = domega_25_y - t805;
  const Scalar t806 = c_25 * omega_r_24_x - s_25 * omega_24_z;
  const Scalar t807 = omega_r_25_x * t806;
  const Scalar domega_24_y = c_24 * domega_22_y - s_24 * domega_23_x + qd_24 * omega_r_24_x;
  const Scalar N_25_z = Scalar(0.0014129000000002) * domega_24_y - Scalar(0.0094) * ddp_25_x -
      Scalar(0.0005096) * t807 + Scalar(0.0007482) * U_25_xz;
  const Scalar y_25 = tau_25 + N_25_z;
  const Scalar t808 = c_24 * t800 - s_24 * ddp_23_x;
  const Scalar t809 = omega_25_z * omega_25_z;
  const Scalar t810 = Scalar(0.0094) * t808 - Scalar(0.0007482) * (t809 - t806 * t806) +
      Scalar(0.0009033000000002) * t806 * omega_25_z;
  const Scalar U_25_xy = domega_24_y + t807;
  const Scalar N_25_y = Scalar(0.0005096) * domega_25_y + Scalar(0.0007482) * U_25_xy +
      Scalar(0.0014129000000002) * t805;
  const Scalar t811 = omega_r_24_x * t803;
  const Scalar t812 = Scalar(-0.0253235000000002) * t804;
  const Scalar t813 = Scalar(0.1902) * t801 - Scalar(0.0250035000000002) * t811 + c_25 * t810 +
      s_25 * N_25_y + t812;
  const Scalar y_25_24 = tau_24 - t813 + y_25 * t544;
  const Scalar mu_24_y = Scalar(0.0250035000000002) * domega_24_y - N_25_z -
      Scalar(0.0253235000000002) * omega_r_24_x * omega_24_z;
  const Scalar t814 = t803 * omega_24_z;
  const Scalar t815 = Scalar(0.1902) * t802 + Scalar(0.0503270000000004) * t814 - c_25 * N_25_y +
      s_25 * t810;
  const Scalar mu_23_z = Scalar(0.0259635000000002) * domega_22_y -
      Scalar(0.0253235000000002) * omega_r_23_x * omega_r_23_y - c_24 * mu_24_y - s_24 * t815;
  const Scalar y_24_23 = tau_23 + mu_23_z - y_25 * t566 - t562 * y_25_24;
  const Scalar mu_23_x = Scalar(0.0512870000000004) * omega_r_23_y * omega_23_z - c_24 * t815 +
      s_24 * mu_24_y;
  const Scalar t816 = t812 - t813 - Scalar(0.0259635000000002) * omega_r_23_x * omega_23_z;
  const Scalar U_25_yy = omega_r_25_x * omega_r_25_x + t809;
  const Scalar t817 = Scalar(0.1902) * (t804 + t811) +
      Scalar(0.0094) * (c_25 * U_25_yy - s_25 * U_25_xy);
  const Scalar U_25_zy = c_25 * t804 + s_25 * domega_24_x - t806 * (qd_25 + omega_25_z);
  const Scalar U_24_yy = omega_r_24_x * omega_r_24_x + omega_24_z * omega_24_z;
  const Scalar f_24_y = Scalar(0.1902) * U_24_yy - Scalar(0.0094) * U_25_zy;
  const Scalar f_u_24_t_x = c_24 * t817 + s_24 * f_24_y;
  const Scalar U_24_zy = domega_24_x - t814;
  const Scalar f_24_z = Scalar(0.1902) * U_24_zy +
      Scalar(0.0094) * (c_25 * U_25_xy + s_25 * U_25_yy);
  const Scalar f_u_23_t_x = c_23 * f_24_z + s_23 * f_u_24_t_x;
  const Scalar f_u_24_t_y = c_24 * f_24_y - s_24 * t817;
  const Scalar U_22_xx_yy = U_22_xx - U_22_yy;
  const Scalar mu_22_z = Scalar(0.2298769000000002) * domega_21_y - Scalar(0.8648) * ddp_22_x -
      Scalar(0.0328) * t799 - Scalar(0.2262745000000002) * t792 + Scalar(0.0050592) * U_22_xx_yy -
      Scalar(0.004) * f_u_24_t_y + Scalar(0.239) * f_u_23_t_x + c_23 * mu_23_x + s_23 * t816;
  const Scalar y_23_22 = tau_22 + mu_22_z + y_25 * t572 + t571 * y_25_24 + t569 * y_24_23;
  const Scalar t818 = c_23 * f_u_24_t_x - s_23 * f_24_z;
  const Scalar t819 = Scalar(0.8648) * t795 + Scalar(0.0050592) * U_22_zx -
      Scalar(0.4561514000000004) * t797 - Scalar(0.239) * t818 - c_23 * t816 + s_23 * mu_23_x;
  const Scalar t820 = Scalar(0.0328) * t795 - Scalar(0.2262745000000002) * domega_22_y -
      Scalar(0.2298769000000002) * t796 - Scalar(0.0050592) * U_22_zy + mu_23_z -
      Scalar(0.004) * t818;
  const Scalar f_22_z = Scalar(0.0328) * U_22_zx - Scalar(0.8648) * U_22_zy - t818;
  const Scalar t821 = t787 * omega_21_z;
  const Scalar U_21_yz = domega_21_x + t821;
  const Scalar mu_21_z = Scalar(0.2360429000000002) * domega_20_y + Scalar(0.0032) * t793 +
      Scalar(0.2282085000000002) * t794 + Scalar(0.0023) * U_21_yz - Scalar(0.004) * f_22_z +
      c_22 * t820 + s_22 * t819;
  const Scalar y_22_21 = tau_21 + mu_21_z + y_25 * t580 + t579 * y_25_24 - t578 * y_24_23 +
      t577 * y_23_22;
  const Scalar t822 = Scalar(0.0023) * U_21_yx - Scalar(0.4642514000000004) * t821 - c_22 * t819 +
      s_22 * t820;
  const Scalar f_22_x = Scalar(0.0328) * U_22_xx + Scalar(0.8648) * U_22_xy + f_u_23_t_x;
  const Scalar f_22_y = Scalar(0.0328) * U_22_yx - Scalar(0.8648) * U_22_yy - f_u_24_t_y;
  const Scalar f_u_22_t_y = c_22 * f_22_y + s_22 * f_22_x;
  const Scalar mu_21_y = Scalar(0.0032) * ddp_o_21_y + Scalar(0.2282085000000002) * domega_21_y -
      Scalar(0.2360429000000002) * t789 + Scalar(0.0023) * (t788 - omega_r_21_x * omega_r_21_x) -
      mu_22_z + Scalar(0.004) * f_u_22_t_y;
  const Scalar f_21_x = Scalar(0.0032) * U_21_xx + c_22 * f_22_x - s_22 * f_22_y;
  const Scalar f_21_y = Scalar(0.0032) * U_21_yx + f_22_z;
  const Scalar f_u_21_t_x = c_21 * f_21_y + s_21 * f_21_x;
  const Scalar t823 = Scalar(0.7079407000000002) * domega_19_y;
  const Scalar t824 = Scalar(1.661) * t779 - Scalar(0.7059807000000002) * t781 +
      Scalar(0.305) * f_u_21_t_x - c_21 * t822 - s_21 * mu_21_y - t823;
  const Scalar y_21_20 = tau_20 - t824 + y_25 * t591 + t590 * y_25_24 - t589 * y_24_23 +
      t588 * y_23_22 + t587 * y_22_21;
  const Scalar t825 = c_21 * f_21_x - s_21 * f_21_y;
  const Scalar t826 = Scalar(1.661) * t783 + Scalar(1.4139214000000004) * t785 -
      Scalar(0.305) * t825 + c_21 * mu_21_y - s_21 * t822;
  const Scalar mu_20_y = Scalar(0.7059807000000002) * domega_20_y - mu_21_z -
      Scalar(0.7079407000000002) * omega_r_20_x * omega_20_z;
  const Scalar mu_19_z = t775 + Scalar(0.7079407000000002) * omega_r_19_x * omega_r_19_y -
      c_20 * t826 + s_20 * mu_20_y;
  const Scalar y_20_19 = tau_19 + mu_19_z - y_25 * t604 + t603 * y_25_24 + t602 * y_24_23 +
      t601 * y_23_22 - t600 * y_22_21 - t599 * y_21_20;
  const Scalar t827 = Scalar(1.4178414000000004) * omega_r_26_y * omega_26_z + c_27 * mu_27_y +
      s_27 * t774;
  const Scalar t828 = Scalar(1.4178414000000004) * omega_r_19_y * omega_19_z + c_20 * mu_20_y +
      s_20 * t826;
  const Scalar f_27_x = Scalar(1.661) * U_27_xy - f_u_28_t_x;
  const Scalar f_27_y = Scalar(1.661) * U_27_yy - Scalar(0.0032) * U_28_zx - f_u_29_t_y;
  const Scalar t829 = c_27 * f_27_y - s_27 * f_27_x;
  const Scalar f_20_x = Scalar(1.661) * U_20_xy - f_u_21_t_x;
  const Scalar f_20_y = Scalar(1.661) * U_20_yy - Scalar(0.0032) * U_21_zx - f_u_22_t_y;
  const Scalar t830 = c_20 * f_20_y - s_20 * f_20_x;
  const Scalar f_27_z = Scalar(1.661) * U_27_zy + t773;
  const Scalar f_20_z = Scalar(1.661) * U_20_zy + t825;
  const Scalar t831 = c_26 * t829 - s_26 * f_27_z - c_19 * t830 + s_19 * f_20_z;
  const Scalar mu_26_y = t771 + t772 - Scalar(0.7099007000000002) * omega_r_26_x * omega_26_z;
  const Scalar mu_19_y = t823 + t824 - Scalar(0.7099007000000002) * omega_r_19_x * omega_19_z;
  const Scalar t832 = c_27 * f_27_x + s_27 * f_27_y + c_20 * f_20_x + s_20 * f_20_y;
  const Scalar t833 = c_16 * omega_r_15_y - s_16 * omega_15_z;
  const Scalar omega_16_z = qd_16 + t700;
  const Scalar omega_r_17_x = c_17 * omega_16_z - s_17 * t833;
  const Scalar omega_r_16_y = c_16 * omega_15_z + s_16 * omega_r_15_y;
  const Scalar omega_17_z = qd_17 + omega_r_16_y;
  const Scalar t834 = c_18 * omega_17_z - s_18 * omega_r_17_x;
  const Scalar omega_r_18_y = c_18 * omega_r_17_x + s_18 * omega_17_z;
  const Scalar t835 = t834 * omega_r_18_y;
  const Scalar domega_16_x = c_16 * domega_15_y - s_16 * t716 + qd_16 * omega_r_16_y;
  const Scalar t836 = c_17 * domega_16_x + s_17 * domega_15_x - qd_17 * omega_r_17_x;
  const Scalar omega_r_17_y = c_17 * t833 + s_17 * omega_16_z;
  const Scalar omega_18_z = qd_18 + omega_r_17_y;
  const Scalar t837 = omega_18_z * omega_18_z;
  const Scalar U_18_yy = t837 + t834 * t834;
  const Scalar t838 = Scalar(0.02) * (t836 + t835) - Scalar(0.22) * U_18_yy;
  const Scalar U_18_xx = omega_r_18_y * omega_r_18_y + t837;
  const Scalar F_18_x = Scalar(0.02) * U_18_xx + Scalar(0.22) * (t836 - t835);
  const Scalar f_u_18_t_x = c_18 * t838 + s_18 * F_18_x;
  const Scalar domega_17_x = c_17 * domega_15_x - s_17 * domega_16_x + qd_17 * omega_r_17_y;
  const Scalar domega_16_y = c_16 * t716 + s_16 * domega_15_y - qd_16 * t833;
  const Scalar domega_18_y = c_18 * domega_17_x + s_18 * domega_16_y - qd_18 * t834;
  const Scalar t839 = t834 * omega_18_z;
  const Scalar U_18_zx = domega_18_y - t839;
  const Scalar U_18_zy = c_18 * domega_16_y - s_18 * domega_17_x +
      omega_r_18_y * (qd_18 + omega_18_z);
  const Scalar F_18_z = Scalar(0.02) * U_18_zx - Scalar(0.22) * U_18_zy;
  const Scalar f_u_17_t_x = c_17 * F_18_z + s_17 * f_u_18_t_x;
  const Scalar f_u_18_t_y = c_18 * F_18_x - s_18 * t838;
  const Scalar f_u_16_t_x = c_16 * f_u_17_t_x + s_16 * f_u_18_t_y;
  const Scalar U_15_yz = domega_15_x - t708;
  const Scalar t840 = Scalar(0.453) * t720 + Scalar(0.003) * U_15_yz + t721;
  const Scalar U_15_zz = t711 + t723;
  const Scalar ddp_o_16_z = Scalar(0.453) * U_15_zx - Scalar(0.003) * U_15_zz + t705;
  const Scalar ddp_16_x = c_16 * t840 + s_16 * ddp_o_16_z;
  const Scalar U_15_xz = domega_15_y + t704;
  const Scalar t841 = Scalar(0.453) * U_15_xx + Scalar(0.003) * U_15_xz - t713;
  const Scalar t842 = c_17 * t841 + s_17 * ddp_16_x;
  const Scalar ddp_16_y = c_16 * ddp_o_16_z - s_16 * t840;
  const Scalar t843 = c_18 * ddp_16_y - s_18 * t842;
  const Scalar t844 = c_18 * t842 + s_18 * ddp_16_y;
  const Scalar U_18_xx_yy = U_18_xx - U_18_yy;
  const Scalar t845 = Scalar(0.03408) * t836 + Scalar(0.22) * t843 - Scalar(0.02) * t844 -
      Scalar(0.024) * t835 + Scalar(0.0022) * U_18_xx_yy;
  const Scalar t846 = Scalar(0.03388) * t836 - t845 + Scalar(0.03438) * omega_r_17_x * omega_17_z;
  const Scalar t847 = c_17 * ddp_16_x - s_17 * t841;
  const Scalar t848 = Scalar(0.22) * t847 - Scalar(0.0022) * U_18_zx +
      Scalar(0.05808) * omega_r_18_y * omega_18_z;
  const Scalar t849 = Scalar(0.02) * t847 + Scalar(0.024) * domega_18_y + Scalar(0.03408) * t839 +
      Scalar(0.0022) * U_18_zy;
  const Scalar mu_17_x = Scalar(0.06826) * omega_r_17_y * omega_17_z - c_18 * t849 - s_18 * t848;
  const Scalar t850 = Scalar(0.069385) * omega_r_16_y * omega_16_z - c_17 * t846 - s_17 * mu_17_x;
  const Scalar t851 = Scalar(0.03438) * domega_16_y;
  const Scalar t852 = Scalar(0.03388) * omega_r_17_x * omega_r_17_y - c_18 * t848 + s_18 * t849 -
      t851;
  const Scalar mu_16_y = t851 + t852 + Scalar(0.035005) * t833 * omega_16_z;
  const Scalar t853 = Scalar(89.72226) * t707 + Scalar(5.512820899999667) * t716 +
      Scalar(0.5912714333326666) * t715 - Scalar(0.043998) * U_15_yz - Scalar(0.453) * f_u_16_t_x -
      Scalar(0.24) * t831 - Scalar(0.33) * t832 - c_26 * mu_26_y - s_26 * t827 - c_19 * mu_19_y -
      s_19 * t828 - c_16 * mu_16_y - s_16 * t850;
  const Scalar t854 = y_32 * t434 - y_25 * t542;
  const Scalar mu_16_z = Scalar(0.035005) * domega_15_x - Scalar(0.03438) * t833 * omega_r_16_y +
      c_17 * mu_17_x - s_17 * t846;
  const Scalar y_17 = tau_17 - t852;
  const Scalar y_18 = tau_18 + t845;
  const Scalar y_17_16 = tau_16 + mu_16_z - s_17 * y_18 - y_17 * t628;
  const Scalar y_16_15 = tau_15 + t853 + Scalar(707.7641729774637) * t854 - t620 * y_32_31 -
      t618 * y_31_30 + t616 * y_30_29 - t614 * y_29_28 - t612 * y_28_27 - t503 * y_27_26 -
      t621 * y_25_24 + t619 * y_24_23 + t617 * y_23_22 - t615 * y_22_21 - t613 * y_21_20 -
      t611 * y_20_19 + y_18 * t639 - y_17 * t638 + t637 * y_17_16;
  const Scalar t855 = c_26 * f_27_z + s_26 * t829;
  const Scalar t856 = c_19 * f_20_z + s_19 * t830;
  const Scalar t857 = c_16 * f_u_18_t_y - s_16 * f_u_17_t_x;
  const Scalar t858 = c_17 * f_u_18_t_x - s_17 * F_18_z;
  const Scalar U_15_zz_xx = U_15_xx - U_15_zz;
  const Scalar mu_15_y = Scalar(89.72226) * s_14 + Scalar(0.5912714333326666) * domega_15_y -
      Scalar(5.512820899999667) * t704 - Scalar(0.043998) * U_15_zz_xx + mu_26_z + mu_19_z -
      Scalar(0.003) * t858 + Scalar(0.453) * t857 - Scalar(0.33) * (t855 + t856) + c_16 * t850 -
      s_16 * mu_16_y;
  const Scalar t859 = Scalar(0.043998) * t720 - Scalar(4.921549466667001) * t708 - mu_16_z +
      Scalar(0.003) * f_u_16_t_x - Scalar(0.24) * (t855 - t856) + c_26 * t827 - s_26 * mu_26_y +
      c_19 * t828 - s_19 * mu_19_y;
  const Scalar t860 = y_32 * t641 - y_25 * mu_u_25_15_t_y;
  const Scalar t861 = c_14 * (qd_13 * t703 - Scalar(0.7479551597079861));
  const Scalar y_15_14 = tau_14 + Scalar(707.7641729774637) * t860 + c_15 * mu_15_y + s_15 * t859 +
      t670 * y_32_31 + t668 * y_31_30 - t666 * y_30_29 - t664 * y_29_28 + t662 * y_28_27 -
      t660 * y_27_26 + t671 * y_25_24 + t669 * y_24_23 + t667 * y_23_22 - t665 * y_22_21 -
      t663 * y_21_20 - t661 * y_20_19 + y_18 * t675 - y_17 * t674 - t673 * y_17_16 +
      t659 * y_16_15 - Scalar(2.5051100666670005) * t861;
  const Scalar t862 = c_14 * (Scalar(5.012670133334001) * t702 - c_15 * t859 + s_15 * mu_15_y);
  const Scalar mu_14_y = Scalar(0.00245) * t716 + t853;
  const Scalar t863 = y_32 * mu_u_32_14_t_y + y_25 * t543;
  const Scalar y_14_13 = tau_13 + Scalar(707.7641729774637) * t863 + t862 - s_14 * mu_14_y +
      t692 * y_32_31 + t690 * y_31_30 + t688 * y_30_29 - t686 * y_29_28 + t684 * y_28_27 +
      t682 * y_27_26 - t693 * y_25_24 - t691 * y_24_23 - t689 * y_23_22 + t687 * y_22_21 -
      t685 * y_21_20 - t683 * y_20_19 - y_18 * t697 - y_17 * t696 - t695 * y_17_16 -
      t681 * y_16_15 - t680 * y_15_14;
  const Scalar t864 = (Scalar(1.0) / t698) * y_14_13;
  qdd[12] = -t864;
  const Scalar t865 = t679 * (y_15_14 - t676 * t864);
  qdd[13] = -t865;
  const Scalar qdd_15 = t658 * (y_16_15 - b_16_15_14 * t865 + t640 * t864);
  qdd[14] = qdd_15;
  const Scalar qdd_16 = t635 * (y_17_16 + t656 * t865 + t633 * t864 + t636 * qdd_15);
  qdd[15] = qdd_16;
  const Scalar t866 = t610 * (y_20_19 - t652 * t865 - t605 * t864 + t608 * qdd_15);
  qdd[18] = -t866;
  const Scalar t867 = t502 * (y_27_26 - t647 * t865 + t496 * t864 + t500 * qdd_15);
  qdd[25] = -t867;
  const Scalar t868 = y_18 - t655 * t865 + mu_u_18_14_t_y * t864 + mu_18_15_z * qdd_15;
  qdd[17] = Scalar(29.342723004694836) * t868 - s_17 * qdd_16;
  const Scalar t869 = y_17 + c_17 * Iu_18_t_xy * qdd_16 - t626 * t864 + t625 * qdd_15 - t654 * t865;
  qdd[16] = -d_17 * t869;
  const Scalar t870 = y_21_20 - t596 * t866 - t592 * t864 + b_21_20_15 * qdd_15 - t651 * t865;
  const Scalar t871 = t598 * t870;
  qdd[19] = -t871;
  const Scalar t872 = y_28_27 + b_28_27_26 * t867 + t483 * t864 + b_28_27_15 * qdd_15 + t646 * t865;
  const Scalar t873 = t489 * t872;
  qdd[26] = -t873;
  const Scalar t874 = y_22_21 + t595 * t866 - b_22_21_15 * qdd_15 - t584 * t871 + t650 * t865 -
      t581 * t864;
  const Scalar qdd_21 = t586 * t874;
  qdd[20] = qdd_21;
  const Scalar t875 = y_29_28 + t487 * t867 - t499 * qdd_15 + t477 * t873 + t645 * t865 +
      t474 * t864;
  const Scalar qdd_28 = d_28 * t875;
  qdd[27] = qdd_28;
  const Scalar t876 = y_23_22 - b_23_22_15 * qdd_15 + t649 * t865 + t583 * t871 + t594 * t866 -
      t574 * qdd_21 - t573 * t864;
  const Scalar t877 = t576 * t876;
  qdd[21] = -t877;
  const Scalar t878 = y_30_29 - b_30_29_15 * qdd_15 - t644 * t865 - t476 * t873 - t486 * t867 -
      t465 * qdd_28 + t463 * t864;
  const Scalar t879 = t467 * t878;
  qdd[28] = -t879;
  const Scalar t880 = y_24_23 + t648 * t865 - t567 * t864 + b_24_23_19 * t866 - t607 * qdd_15 +
      b_24_23_21 * qdd_21 - t582 * t871 + t568 * t877;
  const Scalar t881 = d_23 * t880;
  qdd[22] = -t881;
  const Scalar t882 = y_31_30 + t643 * t865 + t459 * t864 + t485 * t867 + t498 * qdd_15 +
      t464 * qdd_28 + t475 * t873 + b_31_30_29 * t879;
  const Scalar t883 = d_30 * t882;
  qdd[29] = -t883;
  const Scalar t884 = y_25_24 - b_25_24_23 * t881 - t559 * t864 + t606 * qdd_15 +
      b_25_24_14 * t865 + b_25_24_20 * t871 + t593 * t866 + b_25_24_22 * t877 - b_25_24_21 * qdd_21;
  const Scalar t885 = t561 * t884;
  qdd[23] = -t885;
  const Scalar t886 = y_32_31 + t453 * t883 + b_32_31_13 * t864 + t497 * qdd_15 + t642 * t865 +
      b_32_31_27 * t873 + t484 * t867 + b_32_31_29 * t879 - b_32_31_28 * qdd_28;
  const Scalar t887 = t452 * t886;
  qdd[30] = -t887;
  const Scalar t888 = y_25 + mu_u_25_24_t_y * t881 - t543 * t864 - t542 * qdd_15 +
      mu_u_25_15_t_y * t865 - mu_25_20_z * t871 + mu_u_25_20_t_y * t866 - mu_25_22_z * t877 +
      mu_25_21_z * qdd_21;
  qdd[24] = Scalar(707.7641729774637) * t888 - t544 * t885;
  const Scalar t889 = y_32 + mu_u_32_31_t_y * t883 - mu_u_32_14_t_y * t864 + t434 * qdd_15 -
      t641 * t865 + mu_32_27_z * t873 - mu_u_32_27_t_y * t867 + mu_32_29_z * t879 -
      mu_32_28_z * qdd_28;
  qdd[31] = Scalar(707.7641729774637) * t889 + t435 * t887;
  bool positive = -t115 > Scalar(0.0);
  positive &= b_3_2_2 > Scalar(0.0);
  positive &= -t88 > Scalar(0.0);
  positive &= -t59 > Scalar(0.0);
  positive &= Ic_5_zz > Scalar(0.0);
  positive &= -t231 > Scalar(0.0);
  positive &= b_9_8_8 > Scalar(0.0);
  positive &= -t204 > Scalar(0.0);
  positive &= -t175 > Scalar(0.0);
  positive &= Ic_11_zz > Scalar(0.0);
  positive &= -t698 > Scalar(0.0);
  positive &= -t678 > Scalar(0.0);
  positive &= b_16_15_15 > Scalar(0.0);
  positive &= b_17_16_16 > Scalar(0.0);
  positive &= -Ic_17_zz > Scalar(0.0);
  positive &= -t609 > Scalar(0.0);
  positive &= -t597 > Scalar(0.0);
  positive &= t585 > Scalar(0.0);
  positive &= -t575 > Scalar(0.0);
  positive &= -b_24_23_23 > Scalar(0.0);
  positive &= -t560 > Scalar(0.0);
  positive &= -t501 > Scalar(0.0);
  positive &= -t488 > Scalar(0.0);
  positive &= b_29_28_28 > Scalar(0.0);
  positive &= -t466 > Scalar(0.0);
  positive &= -b_31_30_30 > Scalar(0.0);
  positive &= -t451 > Scalar(0.0);
  return positive;
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    1, 1, 1,
    1, 1, 1,
    1, 1, 1};

// pose of the tip (2.50).
//   q[32]  in   joint positions, rad or m
//   R[9]   out  rotation matrix of the frame in the base frame
//               3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]   out  position of the frame's origin in the base frame, m
// Reads q[12..14], q[25..31]. Operations: 136 mul, 73 add, 20 sin/cos.
template <class Scalar>
inline void forward_kinematics(const Scalar* q, Scalar* R, Scalar* p) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_13 = q[12], q_14 = q[13], q_15 = q[14], q_26 = q[25], q_27 = q[26], q_28 = q[27],
      q_29 = q[28], q_30 = q[29], q_31 = q[30], q_32 = q[31];
  const Scalar s_13 = sin(q_13), c_13 = cos(q_13);
  const Scalar s_14 = sin(q_14), c_14 = cos(q_14);
  const Scalar s_15 = sin(q_15), c_15 = cos(q_15);
  const Scalar s_26 = sin(q_26), c_26 = cos(q_26);
  const Scalar s_27 = sin(q_27), c_27 = cos(q_27);
  const Scalar s_28 = sin(q_28), c_28 = cos(q_28);
  const Scalar s_29 = sin(q_29), c_29 = cos(q_29);
  const Scalar s_30 = sin(q_30), c_30 = cos(q_30);
  const Scalar s_31 = sin(q_31), c_31 = cos(q_31);
  const Scalar s_32 = sin(q_32), c_32 = cos(q_32);
  const Scalar t1 = c_29 * s_31;
  const Scalar a_29_t_x = s_29 * c_31 + s_30 * t1;
  const Scalar t2 = c_30 * s_31;
  const Scalar t3 = s_28 * a_29_t_x - c_28 * t2;
  const Scalar t4 = s_29 * s_31;
  const Scalar t5 = s_30 * t4 - c_29 * c_31;
  const Scalar a_27_t_x = s_27 * t3 - c_27 * t5;
  const Scalar a_28_t_y = s_28 * t2 + c_28 * a_29_t_x;
  const Scalar t6 = s_26 * a_28_t_y - c_26 * a_27_t_x;
  const Scalar t7 = s_27 * t5 + c_27 * t3;
  const Scalar a_15_t_x = s_15 * t7 - c_15 * t6;
  const Scalar a_26_t_y = s_26 * a_27_t_x + c_26 * a_28_t_y;
  R[8] = c_14 * a_15_t_x - s_14 * a_26_t_y;
  const Scalar a_14_t_x = s_14 * a_15_t_x + c_14 * a_26_t_y;
  const Scalar t8 = s_15 * t6 + c_15 * t7;
  R[5] = s_13 * a_14_t_x + c_13 * t8;
  const Scalar t9 = s_30 * c_31;
  const Scalar t10 = c_30 * c_32;
  const Scalar t11 = s_32 * t9 - t10;
  const Scalar n_29_t_x = s_32 * t4 - c_29 * t11;
  const Scalar t12 = c_30 * s_32;
  const Scalar n_30_t_y = s_30 * c_32 + c_31 * t12;
  const Scalar n_28_t_x = s_28 * n_29_t_x + c_28 * n_30_t_y;
  const Scalar n_29_t_y = s_29 * t11 + s_32 * t1;
  const Scalar n_27_t_x = s_27 * n_28_t_x + c_27 * n_29_t_y;
  const Scalar t13 = s_28 * n_30_t_y - c_28 * n_29_t_x;
  const Scalar n_26_t_x = s_26 * t13 + c_26 * n_27_t_x;
  const Scalar t14 = s_27 * n_29_t_y - c_27 * n_28_t_x;
  const Scalar t15 = s_15 * t14 - c_15 * n_26_t_x;
  const Scalar n_26_t_y = s_26 * n_27_t_x - c_26 * t13;
  R[6] = -s_14 * n_26_t_y - c_14 * t15;
  const Scalar s_30_t_x = t12 + c_32 * t9;
  const Scalar t16 = c_32 * t4 - c_29 * s_30_t_x;
  const Scalar t17 = s_30 * s_32 - c_31 * t10;
  const Scalar s_28_t_x = s_28 * t16 - c_28 * t17;
  const Scalar s_29_t_y = s_29 * s_30_t_x + c_32 * t1;
  const Scalar s_27_t_x = s_27 * s_28_t_x + c_27 * s_29_t_y;
  const Scalar t18 = s_28 * t17 + c_28 * t16;
  const Scalar t19 = s_26 * t18 - c_26 * s_27_t_x;
  const Scalar t20 = s_27 * s_29_t_y - c_27 * s_28_t_x;
  const Scalar t21 = s_15 * t20 + c_15 * t19;
  const Scalar t22 = s_26 * s_27_t_x + c_26 * t18;
  R[7] = -s_14 * t22 - c_14 * t21;
  R[2] = c_13 * a_14_t_x - s_13 * t8;
  const Scalar t23 = s_14 * t15 - c_14 * n_26_t_y;
  const Scalar t24 = s_15 * n_26_t_x + c_15 * t14;
  R[0] = s_13 * t24 - c_13 * t23;
  const Scalar p_32u_t_x = Scalar(0.006) * c_32 - Scalar(0.025) * s_32;
  const Scalar p_31u_t_x = Scalar(0.147) * s_31 + c_31 * p_32u_t_x;
  const Scalar p_32u_t_y = Scalar(0.025) * c_32 + Scalar(0.006) * s_32;
  const Scalar p_30_x = s_30 * p_31u_t_x + c_30 * p_32u_t_y + Scalar(0.004);
  const Scalar p_30_y = Scalar(0.147) * c_31 - s_31 * p_32u_t_x + Scalar(0.239);
  const Scalar p_29_x = s_29 * p_30_y + c_29 * p_30_x - Scalar(0.004);
  const Scalar t25 = s_30 * p_32u_t_y - c_30 * p_31u_t_x;
  const Scalar t26 = s_28 * p_29_x + c_28 * t25;
  const Scalar t27 = s_29 * p_30_x - c_29 * p_30_y - Scalar(0.305);
  const Scalar p_27u_t_x = s_27 * t26 - c_27 * t27;
  const Scalar t28 = s_28 * t25 - c_28 * p_29_x;
  const Scalar p_26_x = s_26 * t28 + c_26 * p_27u_t_x - Scalar(0.33);
  const Scalar t29 = s_27 * t27 + c_27 * t26 - Scalar(0.24);
  const Scalar p_15u_t_x = s_15 * t29 + c_15 * p_26_x;
  const Scalar p_26u_t_y = s_26 * p_27u_t_x - c_26 * t28;
  p[2] = s_14 * p_26u_t_y - c_14 * p_15u_t_x + Scalar(0.192);
  R[3] = -s_13 * t23 - c_13 * t24;
  const Scalar s_14_t_x = s_14 * t21 - c_14 * t22;
  const Scalar s_15_t_y = s_15 * t19 - c_15 * t20;
  R[1] = -s_13 * s_15_t_y - c_13 * s_14_t_x;
  R[4] = c_13 * s_15_t_y - s_13 * s_14_t_x;
  const Scalar p_14u_t_x = s_14 * p_15u_t_x + c_14 * p_26u_t_y;
  const Scalar p_15u_t_y = s_15 * p_26_x - c_15 * t29;
  p[0] = -s_13 * p_15u_t_y - c_13 * p_14u_t_x;
  p[1] = c_13 * p_15u_t_y - s_13 * p_14u_t_x;
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[192] = {
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1};

// geometric Jacobian of the tip (7.14), (7.15).
//   q[32]   in   joint positions, rad or m
//   J[192]  out  geometric Jacobian in base axes: linear rows, then angular
//                6 x 32, row by row: entry (i, j) is J[32 * i + j]
// Reads q[12..14], q[25..31]. Operations: 190 mul, 106 add, 20 sin/cos. Always zero: 136 of the 192
// entries of J.
template <class Scalar>
inline void jacobian(const Scalar* q, Scalar* J) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_13 = q[12], q_14 = q[13], q_15 = q[14], q_26 = q[25], q_27 = q[26], q_28 = q[27],
      q_29 = q[28], q_30 = q[29], q_31 = q[30], q_32 = q[31];
  const Scalar s_13 = sin(q_13), c_13 = cos(q_13);
  const Scalar s_14 = sin(q_14), c_14 = cos(q_14);
  const Scalar s_15 = sin(q_15), c_15 = cos(q_15);
  const Scalar s_26 = sin(q_26), c_26 = cos(q_26);
  const Scalar s_27 = sin(q_27), c_27 = cos(q_27);
  const Scalar s_28 = sin(q_28), c_28 = cos(q_28);
  const Scalar s_29 = sin(q_29), c_29 = cos(q_29);
  const Scalar s_30 = sin(q_30), c_30 = cos(q_30);
  const Scalar s_31 = sin(q_31), c_31 = cos(q_31);
  const Scalar s_32 = sin(q_32), c_32 = cos(q_32);
  J[141] = c_13;
  J[174] = -s_14;
  J[109] = -s_13;
  const Scalar R_140_y = c_13 * c_14;
  J[110] = R_140_y;
  const Scalar R_141_y = s_13 * c_14;
  J[142] = R_141_y;
  const Scalar R_152_y = c_14 * s_15;
  J[185] = R_152_y;
  const Scalar t1 = s_13 * s_15;
  const Scalar R_151_y = c_13 * c_15 + s_14 * t1;
  J[153] = R_151_y;
  const Scalar t2 = c_13 * s_14;
  const Scalar t3 = s_13 * c_15;
  const Scalar t4 = t3 - s_15 * t2;
  J[121] = -t4;
  const Scalar t5 = c_14 * c_15;
  const Scalar R_262_y = s_14 * c_26 + s_26 * t5;
  J[186] = -R_262_y;
  const Scalar R_150_x = t1 + c_15 * t2;
  const Scalar R_260_y = c_26 * R_140_y - s_26 * R_150_x;
  J[122] = R_260_y;
  const Scalar t6 = c_13 * s_15 - s_14 * t3;
  const Scalar R_261_y = c_26 * R_141_y + s_26 * t6;
  J[154] = R_261_y;
  const Scalar t7 = s_14 * s_26 - c_26 * t5;
  const Scalar R_272_y = c_27 * t7 + s_27 * R_152_y;
  J[187] = -R_272_y;
  const Scalar R_260_x = c_26 * R_150_x + s_26 * R_140_y;
  const Scalar R_270_y = c_27 * R_260_x + s_27 * t4;
  J[123] = R_270_y;
  const Scalar R_272_x = c_27 * R_152_y - s_27 * t7;
  const Scalar R_282_y = c_28 * R_272_x + s_28 * R_262_y;
  J[188] = R_282_y;
  const Scalar t8 = c_26 * t6 - s_26 * R_141_y;
  const Scalar R_271_y = c_27 * t8 + s_27 * R_151_y;
  J[155] = -R_271_y;
  const Scalar R_271_x = c_27 * R_151_y - s_27 * t8;
  const Scalar R_281_y = c_28 * R_271_x - s_28 * R_261_y;
  J[156] = R_281_y;
  const Scalar t9 = c_27 * t4 - s_27 * R_260_x;
  const Scalar t10 = c_28 * t9 + s_28 * R_260_y;
  J[124] = -t10;
  const Scalar t11 = c_28 * R_262_y - s_28 * R_272_x;
  const Scalar t12 = c_29 * R_272_y + s_29 * t11;
  J[189] = -t12;
  const Scalar R_280_x = c_28 * R_260_y - s_28 * t9;
  const Scalar R_290_y = c_29 * R_270_y + s_29 * R_280_x;
  J[125] = R_290_y;
  const Scalar R_281_x = c_28 * R_261_y + s_28 * R_271_x;
  const Scalar t13 = c_29 * R_271_y - s_29 * R_281_x;
  J[157] = -t13;
  const Scalar t14 = c_29 * t11 - s_29 * R_272_y;
  const Scalar t15 = c_30 * t14 - s_30 * R_282_y;
  J[190] = -t15;
  const Scalar R_290_x = c_29 * R_280_x - s_29 * R_270_y;
  const Scalar R_300_y = c_30 * R_290_x - s_30 * t10;
  J[126] = R_300_y;
  const Scalar R_291_x = c_29 * R_281_x + s_29 * R_271_y;
  const Scalar R_301_y = c_30 * R_291_x + s_30 * R_281_y;
  J[158] = R_301_y;
  const Scalar t16 = c_31 * t12 + s_31 * (c_30 * R_282_y + s_30 * t14);
  J[191] = -t16;
  const Scalar R_300_x = c_30 * t10 + s_30 * R_290_x;
  const Scalar R_310_y = c_31 * R_290_y + s_31 * R_300_x;
  J[127] = R_310_y;
  const Scalar t17 = c_31 * t13 + s_31 * (c_30 * R_281_y - s_30 * R_291_x);
  J[159] = -t17;
  const Scalar p_32u_t_x = Scalar(0.006) * c_32 - Scalar(0.025) * s_32;
  const Scalar p_31u_t_x = Scalar(0.147) * s_31 + c_31 * p_32u_t_x;
  const Scalar p_32u_t_y = Scalar(0.025) * c_32 + Scalar(0.006) * s_32;
  const Scalar p_30_x = c_30 * p_32u_t_y + s_30 * p_31u_t_x + Scalar(0.004);
  const Scalar p_30_y = Scalar(0.147) * c_31 - s_31 * p_32u_t_x + Scalar(0.239);
  const Scalar p_29_x = c_29 * p_30_x + s_29 * p_30_y - Scalar(0.004);
  const Scalar t18 = c_30 * p_31u_t_x - s_30 * p_32u_t_y;
  const Scalar t19 = c_28 * t18 - s_28 * p_29_x;
  const Scalar t20 = c_29 * p_30_y - s_29 * p_30_x + Scalar(0.305);
  const Scalar p_27u_t_x = c_27 * t20 - s_27 * t19;
  const Scalar t21 = c_28 * p_29_x + s_28 * t18;
  const Scalar p_26_x = c_26 * p_27u_t_x - s_26 * t21 - Scalar(0.33);
  const Scalar t22 = c_27 * t19 + s_27 * t20 + Scalar(0.24);
  const Scalar p_15u_t_x = c_15 * p_26_x - s_15 * t22;
  const Scalar p_26u_t_y = c_26 * t21 + s_26 * p_27u_t_x;
  const Scalar t23 = c_14 * p_15u_t_x - s_14 * p_26u_t_y;
  J[13] = -c_13 * t23;
  J[45] = -s_13 * t23;
  const Scalar p_14u_t_x = c_14 * p_26u_t_y + s_14 * p_15u_t_x;
  const Scalar p_15u_t_y = c_15 * t22 + s_15 * p_26_x;
  const Scalar p_13u_t_x = c_13 * p_14u_t_x + s_13 * p_15u_t_y;
  J[44] = -p_13u_t_x;
  const Scalar t24 = c_13 * p_15u_t_y - s_13 * p_14u_t_x;
  J[12] = -t24;
  J[77] = c_13 * p_13u_t_x - s_13 * t24;
  J[14] = s_14 * t24 - t23 * R_141_y;
  J[46] = s_14 * p_13u_t_x + t23 * R_140_y;
  J[78] = c_14 * (s_13 * p_13u_t_x + c_13 * t24);
  const Scalar t25 = t24 + Scalar(0.33) * t6 - Scalar(0.24) * R_151_y;
  const Scalar t26 = t23 + Scalar(0.24) * R_152_y + Scalar(0.33) * t5;
  J[26] = t25 * R_262_y - t26 * R_261_y;
  const Scalar r_26_x = p_13u_t_x + Scalar(0.33) * R_150_x - Scalar(0.24) * t4;
  J[58] = r_26_x * R_262_y + t26 * R_260_y;
  J[90] = r_26_x * R_261_y + t25 * R_260_y;
  J[25] = -R_151_y * t26 - R_152_y * t25;
  J[57] = -t4 * t26 - R_152_y * r_26_x;
  J[89] = R_151_y * r_26_x - t4 * t25;
  const Scalar t27 = t25 - Scalar(0.305) * R_271_y;
  const Scalar t28 = t26 + Scalar(0.305) * R_272_y;
  J[27] = R_271_y * t28 + R_272_y * t27;
  const Scalar r_28_x = r_26_x - Scalar(0.305) * R_270_y;
  J[59] = R_270_y * t28 + R_272_y * r_28_x;
  J[91] = R_270_y * t27 - R_271_y * r_28_x;
  const Scalar t29 = t27 - Scalar(0.004) * R_281_x;
  const Scalar t30 = t28 - Scalar(0.004) * t11;
  J[28] = -R_281_y * t30 - R_282_y * t29;
  const Scalar r_29_x = r_28_x + Scalar(0.004) * R_280_x;
  J[60] = -t10 * t30 - R_282_y * r_29_x;
  J[92] = R_281_y * r_29_x - t10 * t29;
  const Scalar t31 = t29 + Scalar(0.004) * R_291_x - Scalar(0.239) * t13;
  const Scalar t32 = t30 + Scalar(0.004) * t14 + Scalar(0.239) * t12;
  J[29] = t13 * t32 + t12 * t31;
  const Scalar r_30_x = r_29_x - Scalar(0.004) * R_290_x - Scalar(0.239) * R_290_y;
  J[61] = R_290_y * t32 + t12 * r_30_x;
  J[93] = R_290_y * t31 - t13 * r_30_x;
  J[30] = t31 * t15 - t32 * R_301_y;
  J[62] = r_30_x * t15 + t32 * R_300_y;
  J[94] = r_30_x * R_301_y + t31 * R_300_y;
  J[31] = t31 * t16 + t32 * t17;
  J[63] = r_30_x * t16 + t32 * R_310_y;
  J[95] = t31 * R_310_y - r_30_x * t17;
  J[172] = Scalar(1.0);
  J[0] = J[1] = J[2] = J[3] = J[4] = J[5] = J[6] = J[7] = Scalar(0.0);
  J[8] = J[9] = J[10] = J[11] = J[15] = J[16] = J[17] = J[18] = Scalar(0.0);
  J[19] = J[20] = J[21] = J[22] = J[23] = J[24] = J[32] = J[33] = Scalar(0.0);
  J[34] = J[35] = J[36] = J[37] = J[38] = J[39] = J[40] = J[41] = Scalar(0.0);
  J[42] = J[43] = J[47] = J[48] = J[49] = J[50] = J[51] = J[52] = Scalar(0.0);
  J[53] = J[54] = J[55] = J[56] = J[64] = J[65] = J[66] = J[67] = Scalar(0.0);
  J[68] = J[69] = J[70] = J[71] = J[72] = J[73] = J[74] = J[75] = Scalar(0.0);
  J[76] = J[79] = J[80] = J[81] = J[82] = J[83] = J[84] = J[85] = Scalar(0.0);
  J[86] = J[87] = J[88] = J[96] = J[97] = J[98] = J[99] = J[100] = Scalar(0.0);
  J[101] = J[102] = J[103] = J[104] = J[105] = J[106] = J[107] = J[108] = Scalar(0.0);
  J[111] = J[112] = J[113] = J[114] = J[115] = J[116] = J[117] = J[118] = Scalar(0.0);
  J[119] = J[120] = J[128] = J[129] = J[130] = J[131] = J[132] = J[133] = Scalar(0.0);
  J[134] = J[135] = J[136] = J[137] = J[138] = J[139] = J[140] = J[143] = Scalar(0.0);
  J[144] = J[145] = J[146] = J[147] = J[148] = J[149] = J[150] = J[151] = Scalar(0.0);
  J[152] = J[160] = J[161] = J[162] = J[163] = J[164] = J[165] = J[166] = Scalar(0.0);
  J[167] = J[168] = J[169] = J[170] = J[171] = J[173] = J[175] = J[176] = Scalar(0.0);
  J[177] = J[178] = J[179] = J[180] = J[181] = J[182] = J[183] = J[184] = Scalar(0.0);
}

}  // namespace humanoid32

#endif  // FLATDYN_HUMANOID32_HPP

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
// Reads q[0..11], q[13..31], qd[0..31], qdd[0..31]. Operations: 1145 mul, 868 add, 62 sin/cos.
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
  const Scalar U_2_yy = qd_2 * qd_2 + c_2 * qd_1 * t35;
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
  const Scalar U_8_yy = qd_8 * qd_8 + c_8 * qd_7 * t68;
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
// Reads q[0..11], q[13..31], qd[0..31]. Operations: 1123 mul, 817 add, 62 sin/cos.
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
  const Scalar U_2_yy = qd_2 * qd_2 + c_2 * qd_1 * t28;
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
  const Scalar U_8_yy = qd_8 * qd_8 + c_8 * qd_7 * t54;
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
// Reads q[0..11], q[13..31], qd[0..31], tau[0..31]. Operations: 2944 mul, 2240 add, 27 div, 62
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
  const Scalar U_2_yy = c_2 * qd_1 * t1 + qd_2 * qd_2;
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
  const Scalar Iu_6_t_xy = c_6 * Iu_6_t_g - Scalar(0.00315);
  const Scalar t41 = Scalar(0.04) * hu_6_t_x + Iu_6_t_xy;
  const Scalar t42 = s_5 * t41;
  const Scalar t43 = s_6 * Iu_6_t_g;
  const Scalar Ic_5_zz = t43 + Scalar(0.00940666666667);
  const Scalar d_5 = Scalar(1.0) / Ic_5_zz;
  const Scalar t44 = t42 * d_5;
  const Scalar y_5_4 = tau_4 + mu_4_z - y_6 * t40 + y_5 * t44;
  const Scalar t45 = c_5 * t41;
  const Scalar t46 = c_5 * hu_6_t_x;
  const Scalar mu_5_4_y = Ic_5_zz + Scalar(0.357) * t46;
  const Scalar mu_5_3_z = Scalar(0.02) * t46 - c_4 * t45 + s_4 * mu_5_4_y;
  const Scalar t47 = mu_5_3_z * d_5;
  const Scalar Iu_6_t_xx = t43 + Scalar(0.0012);
  const Scalar Iu_5_t_d = Iu_6_t_xx + Scalar(0.00555);
  const Scalar t48 = c_5 * Iu_5_t_d;
  const Scalar t49 = t48 + t39;
  const Scalar t50 = c_4 * s_5;
  const Scalar Iu_4_t_yz = t49 * t50 + s_4 * t42;
  const Scalar t51 = Scalar(0.357) * hu_6_t_y;
  const Scalar t52 = t50 * t38 - s_5 * t51 * (s_4 + Scalar(0.056022408963585436));
  const Scalar b_5_4_3 = Iu_4_t_yz - t52 * t40 - t42 * t47;
  const Scalar t53 = c_5 * t48;
  const Scalar t54 = Scalar(0.714) * t46;
  const Scalar t55 = Scalar(0.08) * hu_6_t_y;
  const Scalar t56 = Iu_6_t_xx - t53 - t55 - t54 - Scalar(0.44815416666667);
  const Scalar t57 = t56 + mu_6_4_z * t40 + s_5 * t41 * t44;
  const Scalar t58 = Scalar(1.0) / t57;
  const Scalar t59 = b_5_4_3 * t58;
  const Scalar t60 = Scalar(-69.84866123397676) * t52;
  const Scalar y_4_3 = tau_3 + mu_3_z + y_6 * t60 + y_5 * t47 + t59 * y_5_4;
  const Scalar t61 = t53 - t55 - Scalar(0.00555);
  const Scalar Ic_4_yy = Ic_5_zz + t54 + Scalar(0.40049083333333);
  const Scalar Ic_4_xy = t45 + t51 + Scalar(0.0549);
  const Scalar t62 = Scalar(2.0) * c_4 * Ic_4_xy - s_4 * (t61 + Ic_4_yy);
  const Scalar hc_4_x = t46 + Scalar(1.3725);
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.22);
  const Scalar hu_4_t_y = c_4 * hc_4_x + s_4 * hc_4_y;
  const Scalar Ic_3_xz = Ic_4_xy + Scalar(0.02) * hu_4_t_y - c_4 * t62 + Scalar(0.00507);
  const Scalar t63 = c_4 * hc_4_y - s_4 * hc_4_x;
  const Scalar t64 = t63 - Scalar(0.08);
  const Scalar t65 = s_5 * hu_6_t_x;
  const Scalar t66 = c_3 * t64 - s_3 * t65;
  const Scalar t67 = Scalar(0.389) * t66 - c_3 * Ic_3_xz - s_3 * Iu_4_t_yz;
  const Scalar mu_u_5_4_t_x = c_4 * mu_5_4_y + s_4 * t45;
  const Scalar mu_5_3_y = t42 - Scalar(0.02) * hu_6_t_x * t50;
  const Scalar t68 = s_4 * s_5;
  const Scalar t69 = Scalar(0.389) * hu_6_t_x;
  const Scalar t70 = (c_3 * c_5 + s_3 * t68) * t69;
  const Scalar mu_5_2_z = c_3 * mu_u_5_4_t_x + s_3 * mu_5_3_y + t70;
  const Scalar t71 = mu_5_2_z * d_5;
  const Scalar t72 = Scalar(0.389) * hu_4_t_y - (t56 + Scalar(0.02) * t63);
  const Scalar t73 = c_4 * t42 - t49 * t68;
  const Scalar t74 = c_5 * hu_6_t_y;
  const Scalar f_u_6_4_t_x = c_4 * hu_6_t_x + s_4 * t74;
  const Scalar t75 = s_5 * hu_6_t_y;
  const Scalar t76 = c_3 * t75 - s_3 * f_u_6_4_t_x;
  const Scalar mu_6_3_y = mu_6_4_z - Scalar(0.02) * (c_4 * t74 - s_4 * hu_6_t_x);
  const Scalar mu_u_6_4_t_x = t51 * t50 + t68 * t38;
  const Scalar t77 = Scalar(0.389) * t76 + c_3 * mu_u_6_4_t_x - s_3 * mu_6_3_y;
  const Scalar t78 = c_3 * t73 + t77 * t40 - t42 * t71 + s_3 * t72;
  const Scalar t79 = t67 + t77 * t60 + mu_5_2_z * t47 - t78 * t59;
  const Scalar t80 = s_4 * t62;
  const Scalar t81 = Scalar(-0.04) * t63;
  const Scalar t82 = t61 + t80 - t81 - Scalar(0.03800666666667);
  const Scalar t83 = t82 - t52 * t60 + mu_5_3_z * t47 - b_5_4_3 * t59;
  const Scalar t84 = Scalar(1.0) / t83;
  const Scalar t85 = t79 * t84;
  const Scalar f_3_y = Scalar(0.08) * U_3_yx - f_4_z;
  const Scalar f_4_x = Scalar(1.3725) * U_4_xx + Scalar(0.22) * U_4_xy + f_u_5_t_x;
  const Scalar f_4_y = Scalar(1.3725) * U_4_yx - Scalar(0.22) * U_4_yy - t37;
  const Scalar f_3_x = Scalar(0.08) * U_3_xx + c_4 * f_4_y + s_4 * f_4_x;
  const Scalar f_u_3_t_x = c_3 * f_3_y + s_3 * f_3_x;
  const Scalar mu_3_x = Scalar(0.00507) * U_3_yx + Scalar(0.05976333333334) * t36 - c_4 * t35 +
      s_4 * mu_4_x;
  const Scalar t86 = c_4 * f_4_x - s_4 * f_4_y;
  const Scalar mu_3_y = Scalar(0.08) * ddp_o_3_y + Scalar(0.02175666666667) * domega_3_y -
      Scalar(0.03800666666667) * t16 - Scalar(0.00507) * (t18 - omega_r_3_x * omega_r_3_x) -
      mu_4_z + Scalar(0.02) * t86;
  const Scalar t87 = t78 * t58;
  const Scalar t88 = Scalar(-69.84866123397676) * t77;
  const Scalar y_3_2 = tau_2 - Scalar(1.03624716666667) * t19 - Scalar(0.389) * f_u_3_t_x -
      c_3 * mu_3_x + s_3 * mu_3_y + y_6 * t88 - y_5 * t71 - t87 * y_5_4 + t85 * y_4_3 -
      Scalar(27.463095) * c_1 * s_2;
  const Scalar Iu_4_t_xx = Ic_4_yy + t80;
  const Scalar t89 = t56 - t81 + Scalar(0.02175666666667);
  const Scalar Iu_3_t_d = Iu_4_t_xx + t89;
  const Scalar t90 = t73 - Scalar(0.02) * t65;
  const Scalar t91 = Scalar(2.0) * c_3 * t90 - s_3 * Iu_3_t_d;
  const Scalar t92 = c_2 * (t90 - c_3 * t91);
  const Scalar t93 = c_3 * t65 + s_3 * t64;
  const Scalar t94 = c_2 * (Scalar(0.389) * t93 + c_3 * Iu_4_t_yz - s_3 * Ic_3_xz);
  const Scalar t95 = (c_3 * t68 - s_3 * c_5) * t69;
  const Scalar t96 = c_2 * (c_3 * mu_5_3_y - s_3 * mu_u_5_4_t_x + t95) - s_2 * mu_5_3_z;
  const Scalar t97 = t96 * d_5;
  const Scalar t98 = c_2 * (s_3 * t73 - c_3 * t72);
  const Scalar f_u_6_3_t_y = c_3 * f_u_6_4_t_x + s_3 * t75;
  const Scalar mu_6_2_x = Scalar(0.389) * f_u_6_3_t_y + c_3 * mu_6_3_y + s_3 * mu_u_6_4_t_x;
  const Scalar mu_u_6_2_t_y = c_2 * mu_6_2_x - s_2 * t52;
  const Scalar t99 = t98 + s_2 * Iu_4_t_yz + mu_u_6_2_t_y * t40 + t42 * t97;
  const Scalar t100 = t94 + s_2 * t82 + mu_u_6_2_t_y * t60 - t96 * t47 - t99 * t59;
  const Scalar t101 = t92 - s_2 * t67 + mu_u_6_2_t_y * t88 + t96 * t71 + t99 * t87 + t100 * t85;
  const Scalar t102 = s_3 * t91;
  const Scalar t103 = Scalar(0.778) * hu_4_t_y;
  const Scalar b_3_2_2 = Iu_4_t_xx + t102 + t103 + t77 * t88 - mu_5_2_z * t71 + t78 * t87 +
      t79 * t85 + Scalar(1.03820716666667);
  const Scalar d_2 = Scalar(1.0) / b_3_2_2;
  const Scalar t104 = t101 * d_2;
  const Scalar t105 = c_3 * f_3_x - s_3 * f_3_y;
  const Scalar mu_2_x = Scalar(27.463095) * s_1 - Scalar(2.07445433333334) * t7 -
      Scalar(0.389) * t105 + c_3 * mu_3_y + s_3 * mu_3_x;
  const Scalar mu_2_y = Scalar(0.00196) * t8 + mu_3_z;
  const Scalar t106 = t100 * t84;
  const Scalar t107 = t99 * t58;
  const Scalar t108 = Scalar(69.84866123397676) * mu_u_6_2_t_y;
  const Scalar y_2_1 = tau_1 - c_2 * mu_2_x - s_2 * mu_2_y - y_6 * t108 + y_5 * t97 - t107 * y_5_4 +
      t106 * y_4_3 - t104 * y_3_2;
  const Scalar t109 = t89 + t102 - t103;
  const Scalar t110 = s_2 * (Scalar(2.0) * t94 + s_2 * (t82 - t109 + Scalar(1.03624716666667)));
  const Scalar t111 = t109 + t110 + mu_u_6_2_t_y * t108 + t96 * t97 - t99 * t107 - t100 * t106 +
      t101 * t104 - Scalar(1.04016716666667);
  const Scalar t112 = (Scalar(1.0) / t111) * y_2_1;
  qdd[0] = -t112;
  const Scalar t113 = c_8 * qd_7;
  const Scalar omega_r_9_x = c_9 * qd_8 + s_9 * t113;
  const Scalar t114 = s_8 * qd_7;
  const Scalar omega_9_z = qd_9 - t114;
  const Scalar omega_r_10_x = c_10 * omega_9_z + s_10 * omega_r_9_x;
  const Scalar t115 = c_9 * t113 - s_9 * qd_8;
  const Scalar omega_10_z = qd_10 + t115;
  const Scalar t116 = c_11 * omega_r_10_x - s_11 * omega_10_z;
  const Scalar t117 = c_10 * omega_r_9_x - s_10 * omega_9_z;
  const Scalar omega_11_z = qd_11 + t117;
  const Scalar omega_r_12_x = c_12 * omega_11_z - s_12 * t116;
  const Scalar omega_r_12_y = c_12 * t116 + s_12 * omega_11_z;
  const Scalar t118 = omega_r_12_x * omega_r_12_y;
  const Scalar t119 = qd_8 * t114;
  const Scalar domega_9_x = s_9 * t119 - qd_9 * t115;
  const Scalar t120 = qd_8 * t113;
  const Scalar domega_10_x = c_10 * t120 + s_10 * domega_9_x - qd_10 * t117;
  const Scalar domega_9_y = c_9 * t119 + qd_9 * omega_r_9_x;
  const Scalar domega_11_y = c_11 * domega_9_y + s_11 * domega_10_x - qd_11 * t116;
  const Scalar U_12_yx = domega_11_y + t118;
  const Scalar omega_r_11_y = c_11 * omega_10_z + s_11 * omega_r_10_x;
  const Scalar omega_12_z = qd_12 + omega_r_11_y;
  const Scalar t121 = omega_12_z * omega_12_z;
  const Scalar U_12_yy = t121 + omega_r_12_x * omega_r_12_x;
  const Scalar F_12_y = Scalar(0.045) * U_12_yx + Scalar(0.105) * U_12_yy;
  const Scalar U_12_xx = omega_r_12_y * omega_r_12_y + t121;
  const Scalar U_12_xy = domega_11_y - t118;
  const Scalar F_12_x = Scalar(0.045) * U_12_xx - Scalar(0.105) * U_12_xy;
  const Scalar f_u_12_t_x = c_12 * F_12_y + s_12 * F_12_x;
  const Scalar domega_11_x = c_11 * domega_10_x - s_11 * domega_9_y + qd_11 * omega_r_11_y;
  const Scalar domega_10_y = c_10 * domega_9_x - s_10 * t120 + qd_10 * omega_r_10_x;
  const Scalar t122 = c_12 * domega_11_x + s_12 * domega_10_y - qd_12 * omega_r_12_x;
  const Scalar t123 = omega_r_12_x * omega_12_z;
  const Scalar t124 = t122 - t123;
  const Scalar U_12_zy = c_12 * domega_10_y - s_12 * domega_11_x +
      omega_r_12_y * (qd_12 + omega_12_z);
  const Scalar t125 = Scalar(0.045) * t124 + Scalar(0.105) * U_12_zy;
  const Scalar f_u_11_t_y = c_11 * t125 + s_11 * f_u_12_t_x;
  const Scalar t126 = omega_r_10_x * omega_10_z;
  const Scalar U_10_zx = domega_10_y + t126;
  const Scalar t127 = Scalar(1.3725) * U_10_zx + f_u_11_t_y;
  const Scalar t128 = omega_r_9_x * omega_9_z;
  const Scalar U_9_zx = domega_9_y + t128;
  const Scalar U_8_yy = c_8 * qd_7 * t113 + qd_8 * qd_8;
  const Scalar t129 = Scalar(9.81) * c_7;
  const Scalar ddp_o_9_y = Scalar(0.389) * U_8_yy + c_8 * t129;
  const Scalar ddp_o_10_z = ddp_o_9_y - Scalar(0.02) * U_9_zx;
  const Scalar t130 = omega_9_z * omega_9_z;
  const Scalar U_9_xx = t115 * t115 + t130;
  const Scalar ddp_o_9_z = Scalar(9.81) * s_7 - Scalar(0.778) * t119;
  const Scalar t131 = t113 * t114;
  const Scalar ddp_o_9_x = s_8 * t129 + Scalar(0.389) * t131;
  const Scalar t132 = Scalar(0.02) * U_9_xx - c_9 * ddp_o_9_z + s_9 * ddp_o_9_x;
  const Scalar ddp_10_x = c_10 * ddp_o_10_z + s_10 * t132;
  const Scalar t133 = omega_10_z * omega_10_z;
  const Scalar U_10_xx = t117 * t117 + t133;
  const Scalar t134 = omega_r_10_x * t117;
  const Scalar U_10_xy = domega_9_y + t134;
  const Scalar ddp_o_11_x = ddp_10_x + Scalar(0.357) * U_10_xx + Scalar(0.04) * U_10_xy;
  const Scalar t135 = t117 * omega_10_z;
  const Scalar U_10_zy = domega_10_x - t135;
  const Scalar ddp_9_y = c_9 * ddp_o_9_x + s_9 * ddp_o_9_z;
  const Scalar t136 = omega_r_9_x * t115;
  const Scalar U_9_yx = t120 - t136;
  const Scalar ddp_o_10_y = ddp_9_y + Scalar(0.02) * U_9_yx;
  const Scalar t137 = ddp_o_10_y - Scalar(0.04) * U_10_zy;
  const Scalar t138 = Scalar(0.357) * U_10_zx - t137;
  const Scalar t139 = c_11 * ddp_o_11_x + s_11 * t138;
  const Scalar t140 = c_10 * t132 - s_10 * ddp_o_10_z;
  const Scalar U_10_yx = domega_9_y - t134;
  const Scalar U_10_yy = t133 + omega_r_10_x * omega_r_10_x;
  const Scalar t141 = t140 + Scalar(0.357) * U_10_yx - Scalar(0.04) * U_10_yy;
  const Scalar t142 = c_12 * t141 - s_12 * t139;
  const Scalar t143 = c_12 * t139 + s_12 * t141;
  const Scalar U_12_xx_yy = U_12_xx - U_12_yy;
  const Scalar N_12_z = Scalar(0.01431666666667) * domega_11_y + Scalar(0.105) * t142 +
      Scalar(0.045) * t143 - Scalar(0.0012) * t118 - Scalar(0.00315) * U_12_xx_yy;
  const Scalar mu_11_y = Scalar(0.00876666666667) * domega_11_y - N_12_z +
      Scalar(0.00940666666667) * t116 * omega_11_z;
  const Scalar t144 = c_11 * t138 - s_11 * ddp_o_11_x;
  const Scalar t145 = Scalar(0.045) * t144 - Scalar(0.0012) * t122 -
      Scalar(0.01431666666667) * t123 + Scalar(0.00315) * U_12_zy;
  const Scalar t146 = Scalar(0.105) * t144 + Scalar(0.00315) * t124 +
      Scalar(0.01551666666667) * omega_r_12_y * omega_12_z;
  const Scalar mu_11_x = Scalar(0.01817333333334) * omega_r_11_y * omega_11_z + c_12 * t145 -
      s_12 * t146;
  const Scalar mu_10_x = Scalar(0.22) * ddp_o_10_y + Scalar(0.04766333333334) * t135 -
      Scalar(0.04) * t127 - c_11 * mu_11_x + s_11 * mu_11_y;
  const Scalar f_10_z = Scalar(0.22) * U_10_zy + t127;
  const Scalar mu_11_z = Scalar(0.00940666666667) * domega_10_y -
      Scalar(0.00876666666667) * t116 * omega_r_11_y + c_12 * t146 + s_12 * t145;
  const Scalar t147 = Scalar(0.40049083333333) * domega_10_y + Scalar(0.44815416666667) * t126 -
      Scalar(1.3725) * t137 + mu_11_z + Scalar(0.357) * f_u_11_t_y;
  const Scalar t148 = t115 * omega_9_z;
  const Scalar U_9_yz = domega_9_x + t148;
  const Scalar mu_9_z = Scalar(0.08) * ddp_9_y + Scalar(0.03800666666667) * t120 +
      Scalar(0.02175666666667) * t136 - Scalar(0.00507) * U_9_yz - Scalar(0.02) * f_10_z -
      c_10 * mu_10_x - s_10 * t147;
  const Scalar f_u_11_t_x = c_11 * f_u_12_t_x - s_11 * t125;
  const Scalar t149 = c_12 * F_12_x - s_12 * F_12_y;
  const Scalar U_10_xx_yy = U_10_xx - U_10_yy;
  const Scalar mu_10_z = Scalar(0.44815416666667) * domega_9_y + Scalar(0.22) * ddp_10_x +
      Scalar(1.3725) * t140 - Scalar(0.40049083333333) * t134 + Scalar(0.0549) * U_10_xx_yy -
      Scalar(0.357) * t149 + Scalar(0.04) * f_u_11_t_x - c_11 * mu_11_y - s_11 * mu_11_x;
  const Scalar y_12 = tau_12 + N_12_z;
  const Scalar hu_12_t_y = Scalar(0.045) * c_12 - Scalar(0.105) * s_12;
  const Scalar t150 = Scalar(0.04) * hu_12_t_y + Scalar(0.01431666666667);
  const Scalar hu_12_t_x = Scalar(0.105) * c_12 + Scalar(0.045) * s_12;
  const Scalar t151 = Scalar(0.357) * hu_12_t_x;
  const Scalar mu_12_10_z = t151 + c_11 * t150;
  const Scalar t152 = Scalar(69.84866123397676) * mu_12_10_z;
  const Scalar y_11 = tau_11 + mu_11_z;
  const Scalar Iu_12_t_g = Scalar(0.0063) * c_12 - Scalar(0.0012) * s_12;
  const Scalar Iu_12_t_xy = c_12 * Iu_12_t_g - Scalar(0.00315);
  const Scalar t153 = Scalar(0.04) * hu_12_t_x + Iu_12_t_xy;
  const Scalar t154 = s_11 * t153;
  const Scalar t155 = s_12 * Iu_12_t_g;
  const Scalar Ic_11_zz = t155 + Scalar(0.00940666666667);
  const Scalar d_11 = Scalar(1.0) / Ic_11_zz;
  const Scalar t156 = t154 * d_11;
  const Scalar y_11_10 = tau_10 + mu_10_z - y_12 * t152 + y_11 * t156;
  const Scalar t157 = c_11 * t153;
  const Scalar t158 = c_11 * hu_12_t_x;
  const Scalar mu_11_10_y = Ic_11_zz + Scalar(0.357) * t158;
  const Scalar mu_11_9_z = Scalar(0.02) * t158 - c_10 * t157 + s_10 * mu_11_10_y;
  const Scalar t159 = mu_11_9_z * d_11;
  const Scalar Iu_12_t_xx = t155 + Scalar(0.0012);
  const Scalar Iu_11_t_d = Iu_12_t_xx + Scalar(0.00555);
  const Scalar t160 = c_11 * Iu_11_t_d;
  const Scalar t161 = t160 + t151;
  const Scalar t162 = c_10 * s_11;
  const Scalar Iu_10_t_yz = t161 * t162 + s_10 * t154;
  const Scalar t163 = Scalar(0.357) * hu_12_t_y;
  const Scalar t164 = t162 * t150 - s_11 * t163 * (s_10 + Scalar(0.056022408963585436));
  const Scalar b_11_10_9 = Iu_10_t_yz - t164 * t152 - t154 * t159;
  const Scalar t165 = c_11 * t160;
  const Scalar t166 = Scalar(0.714) * t158;
  const Scalar t167 = Scalar(0.08) * hu_12_t_y;
  const Scalar t168 = Iu_12_t_xx - t165 - t167 - t166 - Scalar(0.44815416666667);
  const Scalar t169 = t168 + mu_12_10_z * t152 + s_11 * t153 * t156;
  const Scalar t170 = Scalar(1.0) / t169;
  const Scalar t171 = b_11_10_9 * t170;
  const Scalar t172 = Scalar(-69.84866123397676) * t164;
  const Scalar y_10_9 = tau_9 + mu_9_z + y_12 * t172 + y_11 * t159 + t171 * y_11_10;
  const Scalar t173 = t165 - t167 - Scalar(0.00555);
  const Scalar Ic_10_yy = Ic_11_zz + t166 + Scalar(0.40049083333333);
  const Scalar Ic_10_xy = t157 + t163 + Scalar(0.0549);
  const Scalar t174 = Scalar(2.0) * c_10 * Ic_10_xy - s_10 * (t173 + Ic_10_yy);
  const Scalar hc_10_x = t158 + Scalar(1.3725);
  const Scalar hc_10_y = hu_12_t_y + Scalar(0.22);
  const Scalar hu_10_t_y = c_10 * hc_10_x + s_10 * hc_10_y;
  const Scalar Ic_9_xz = Ic_10_xy + Scalar(0.02) * hu_10_t_y - c_10 * t174 + Scalar(0.00507);
  const Scalar t175 = c_10 * hc_10_y - s_10 * hc_10_x;
  const Scalar t176 = t175 - Scalar(0.08);
  const Scalar t177 = s_11 * hu_12_t_x;
  const Scalar t178 = c_9 * t176 - s_9 * t177;
  const Scalar t179 = Scalar(0.389) * t178 - c_9 * Ic_9_xz - s_9 * Iu_10_t_yz;
  const Scalar mu_u_11_10_t_x = c_10 * mu_11_10_y + s_10 * t157;
  const Scalar mu_11_9_y = t154 - Scalar(0.02) * hu_12_t_x * t162;
  const Scalar t180 = s_10 * s_11;
  const Scalar t181 = Scalar(0.389) * hu_12_t_x;
  const Scalar t182 = (c_9 * c_11 + s_9 * t180) * t181;
  const Scalar mu_11_8_z = c_9 * mu_u_11_10_t_x + s_9 * mu_11_9_y + t182;
  const Scalar t183 = mu_11_8_z * d_11;
  const Scalar t184 = Scalar(0.389) * hu_10_t_y - (t168 + Scalar(0.02) * t175);
  const Scalar t185 = c_10 * t154 - t161 * t180;
  const Scalar t186 = c_11 * hu_12_t_y;
  const Scalar f_u_12_10_t_x = c_10 * hu_12_t_x + s_10 * t186;
  const Scalar t187 = s_11 * hu_12_t_y;
  const Scalar t188 = c_9 * t187 - s_9 * f_u_12_10_t_x;
  const Scalar mu_12_9_y = mu_12_10_z - Scalar(0.02) * (c_10 * t186 - s_10 * hu_12_t_x);
  const Scalar mu_u_12_10_t_x = t163 * t162 + t180 * t150;
  const Scalar t189 = Scalar(0.389) * t188 + c_9 * mu_u_12_10_t_x - s_9 * mu_12_9_y;
  const Scalar t190 = c_9 * t185 + t189 * t152 - t154 * t183 + s_9 * t184;
  const Scalar t191 = t179 + t189 * t172 + mu_11_8_z * t159 - t190 * t171;
  const Scalar t192 = s_10 * t174;
  const Scalar t193 = Scalar(-0.04) * t175;
  const Scalar t194 = t173 + t192 - t193 - Scalar(0.03800666666667);
  const Scalar t195 = t194 - t164 * t172 + mu_11_9_z * t159 - b_11_10_9 * t171;
  const Scalar t196 = Scalar(1.0) / t195;
  const Scalar t197 = t191 * t196;
  const Scalar f_9_y = Scalar(0.08) * U_9_yx - f_10_z;
  const Scalar f_10_x = Scalar(1.3725) * U_10_xx + Scalar(0.22) * U_10_xy + f_u_11_t_x;
  const Scalar f_10_y = Scalar(1.3725) * U_10_yx - Scalar(0.22) * U_10_yy - t149;
  const Scalar f_9_x = Scalar(0.08) * U_9_xx + c_10 * f_10_y + s_10 * f_10_x;
  const Scalar f_u_9_t_x = c_9 * f_9_y + s_9 * f_9_x;
  const Scalar mu_9_x = Scalar(0.00507) * U_9_yx + Scalar(0.05976333333334) * t148 - c_10 * t147 +
      s_10 * mu_10_x;
  const Scalar t198 = c_10 * f_10_x - s_10 * f_10_y;
  const Scalar mu_9_y = Scalar(0.08) * ddp_o_9_y + Scalar(0.02175666666667) * domega_9_y -
      Scalar(0.03800666666667) * t128 - Scalar(0.00507) * (t130 - omega_r_9_x * omega_r_9_x) -
      mu_10_z + Scalar(0.02) * t198;
  const Scalar t199 = t190 * t170;
  const Scalar t200 = Scalar(-69.84866123397676) * t189;
  const Scalar y_9_8 = tau_8 - Scalar(1.03624716666667) * t131 - Scalar(0.389) * f_u_9_t_x -
      c_9 * mu_9_x + s_9 * mu_9_y + y_12 * t200 - y_11 * t183 - t199 * y_11_10 + t197 * y_10_9 -
      Scalar(27.463095) * c_7 * s_8;
  const Scalar Iu_10_t_xx = Ic_10_yy + t192;
  const Scalar t201 = t168 - t193 + Scalar(0.02175666666667);
  const Scalar Iu_9_t_d = Iu_10_t_xx + t201;
  const Scalar t202 = t185 - Scalar(0.02) * t177;
  const Scalar t203 = Scalar(2.0) * c_9 * t202 - s_9 * Iu_9_t_d;
  const Scalar t204 = c_8 * (t202 - c_9 * t203);
  const Scalar t205 = c_9 * t177 + s_9 * t176;
  const Scalar t206 = c_8 * (Scalar(0.389) * t205 + c_9 * Iu_10_t_yz - s_9 * Ic_9_xz);
  const Scalar t207 = (c_9 * t180 - s_9 * c_11) * t181;
  const Scalar t208 = c_8 * (c_9 * mu_11_9_y - s_9 * mu_u_11_10_t_x + t207) - s_8 * mu_11_9_z;
  const Scalar t209 = t208 * d_11;
  const Scalar t210 = c_8 * (s_9 * t185 - c_9 * t184);
  const Scalar f_u_12_9_t_y = c_9 * f_u_12_10_t_x + s_9 * t187;
  const Scalar mu_12_8_x = Scalar(0.389) * f_u_12_9_t_y + c_9 * mu_12_9_y + s_9 * mu_u_12_10_t_x;
  const Scalar mu_u_12_8_t_y = c_8 * mu_12_8_x - s_8 * t164;
  const Scalar t211 = t210 + s_8 * Iu_10_t_yz + mu_u_12_8_t_y * t152 + t154 * t209;
  const Scalar t212 = t206 + s_8 * t194 + mu_u_12_8_t_y * t172 - t208 * t159 - t211 * t171;
  const Scalar t213 = t204 - s_8 * t179 + mu_u_12_8_t_y * t200 + t208 * t183 + t211 * t199 +
      t212 * t197;
  const Scalar t214 = s_9 * t203;
  const Scalar t215 = Scalar(0.778) * hu_10_t_y;
  const Scalar b_9_8_8 = Iu_10_t_xx + t214 + t215 + t189 * t200 - mu_11_8_z * t183 + t190 * t199 +
      t191 * t197 + Scalar(1.03820716666667);
  const Scalar d_8 = Scalar(1.0) / b_9_8_8;
  const Scalar t216 = t213 * d_8;
  const Scalar t217 = c_9 * f_9_x - s_9 * f_9_y;
  const Scalar mu_8_x = Scalar(27.463095) * s_7 - Scalar(2.07445433333334) * t119 -
      Scalar(0.389) * t217 + c_9 * mu_9_y + s_9 * mu_9_x;
  const Scalar mu_8_y = Scalar(0.00196) * t120 + mu_9_z;
  const Scalar t218 = t212 * t196;
  const Scalar t219 = t211 * t170;
  const Scalar t220 = Scalar(69.84866123397676) * mu_u_12_8_t_y;
  const Scalar y_8_7 = tau_7 - c_8 * mu_8_x - s_8 * mu_8_y - y_12 * t220 + y_11 * t209 -
      t219 * y_11_10 + t218 * y_10_9 - t216 * y_9_8;
  const Scalar t221 = t201 + t214 - t215;
  const Scalar t222 = s_8 * (Scalar(2.0) * t206 + s_8 * (t194 - t221 + Scalar(1.03624716666667)));
  const Scalar t223 = t221 + t222 + mu_u_12_8_t_y * t220 + t208 * t209 - t211 * t219 - t212 * t218 +
      t213 * t216 - Scalar(1.04016716666667);
  const Scalar t224 = (Scalar(1.0) / t223) * y_8_7;
  qdd[6] = -t224;
  const Scalar qdd_2 = d_2 * (y_3_2 + t101 * t112);
  qdd[1] = qdd_2;
  const Scalar qdd_8 = d_8 * (y_9_8 + t213 * t224);
  qdd[7] = qdd_8;
  const Scalar t225 = t84 * ((y_4_3 - t79 * qdd_2) + t100 * t112);
  qdd[2] = -t225;
  const Scalar t226 = t196 * ((y_10_9 - t191 * qdd_8) + t212 * t224);
  qdd[8] = -t226;
  const Scalar t227 = t58 * ((t78 * qdd_2 - t99 * t112) + (y_5_4 + b_5_4_3 * t225));
  qdd[3] = -t227;
  const Scalar t228 = t170 * ((t190 * qdd_8 - t211 * t224) + (y_11_10 + b_11_10_9 * t226));
  qdd[9] = -t228;
  const Scalar t229 = (y_6 + mu_6_4_z * t227) + mu_u_6_2_t_y * t112;
  qdd[5] = Scalar(69.84866123397676) * t229 +
      Scalar(69.84866123397676) * (t52 * t225 - t77 * qdd_2);
  const Scalar t230 = (y_12 + mu_12_10_z * t228) + mu_u_12_8_t_y * t224;
  qdd[11] = Scalar(69.84866123397676) * t230 +
      Scalar(69.84866123397676) * (t164 * t226 - t189 * qdd_8);
  const Scalar t231 = (y_5 - t42 * t227) - t96 * t112;
  qdd[4] = d_5 * (t231 - (mu_5_3_z * t225 + mu_5_2_z * qdd_2));
  const Scalar t232 = (y_11 - t154 * t228) - t208 * t224;
  qdd[10] = d_11 * (t232 - (mu_11_9_z * t226 + mu_11_8_z * qdd_8));
  const Scalar t233 = s_32 * s_32;
  const Scalar t234 = Scalar(0.0005096) * t233;
  const Scalar Iu_32_t_xx = t234 - Scalar(0.0005096);
  const Scalar Iu_31_t_d = Iu_32_t_xx - Scalar(0.0235906);
  const Scalar t235 = s_31 * c_32;
  const Scalar t236 = c_31 * Iu_31_t_d - Scalar(0.0014964) * t235;
  const Scalar t237 = c_31 * t236;
  const Scalar t238 = t237 + Scalar(0.0235906);
  const Scalar Ic_31_zz = t234 + Scalar(0.0253235000000002);
  const Scalar Ic_30_yy = Ic_31_zz - Scalar(0.0253235000000002);
  const Scalar t239 = c_31 * c_32;
  const Scalar t240 = s_31 + Scalar(0.6811013098102112) * t239;
  const Scalar t241 = Scalar(0.0014964) * c_30 * s_32 * t240 - s_30 * (t238 + Ic_30_yy);
  const Scalar t242 = s_30 * t241;
  const Scalar t243 = Scalar(0.0094) * c_32;
  const Scalar hu_31_t_y = Scalar(0.1902) * c_31 + s_31 * t243;
  const Scalar t244 = Scalar(0.478) * hu_31_t_y;
  const Scalar Ic_29_xx = Ic_30_yy + t242 + t244;
  const Scalar Ic_30_zz = Iu_32_t_xx - t237 - Scalar(0.0259635000000002);
  const Scalar hu_31_t_x = Scalar(0.1902) * s_31 - c_31 * t243;
  const Scalar t245 = Scalar(0.0094) * s_32;
  const Scalar t246 = c_30 * t245;
  const Scalar t247 = t246 - s_30 * hu_31_t_x;
  const Scalar t248 = Scalar(-0.008) * t247;
  const Scalar Ic_29_yy = Ic_30_zz - t248 + Scalar(0.2262745000000002);
  const Scalar Iu_29_t_d = Ic_29_xx + Ic_29_yy;
  const Scalar Iu_31_t_xy = Scalar(0.0007482) * c_32 + s_31 * t236;
  const Scalar t249 = c_31 - Scalar(0.6811013098102112) * t235;
  const Scalar t250 = Scalar(0.0007482) * s_32;
  const Scalar t251 = c_30 * t250;
  const Scalar Iu_30_t_xz = t249 * t251 + s_30 * Iu_31_t_xy;
  const Scalar t252 = Scalar(0.239) * t247 + Iu_30_t_xz;
  const Scalar Ic_29_xy = Scalar(0.004) * hu_31_t_y - t252 + Scalar(0.0050592);
  const Scalar t253 = c_29 * Iu_29_t_d - Scalar(2.0) * s_29 * Ic_29_xy;
  const Scalar t254 = c_29 * t253;
  const Scalar Iu_29_t_xx = Ic_29_yy - t254;
  const Scalar t255 = t238 + t242 - t244 - t248 - Scalar(0.2298769000000002);
  const Scalar t256 = t247 - Scalar(0.0328);
  const Scalar hc_29_y = hu_31_t_y + Scalar(0.8648);
  const Scalar t257 = c_29 * t256 - s_29 * hc_29_y;
  const Scalar t258 = Scalar(-0.008) * t257;
  const Scalar t259 = t255 + t258 + Scalar(0.2282085000000002);
  const Scalar Iu_28_t_d = Iu_29_t_xx - t259;
  const Scalar t260 = s_30 * t245;
  const Scalar hu_30_t_y = c_30 * hu_31_t_x + t260;
  const Scalar t261 = Scalar(0.004) * hu_30_t_y;
  const Scalar t262 = c_30 * t241 - t261 - t240 * t250;
  const Scalar t263 = s_30 * t250;
  const Scalar Ic_29_yz = Scalar(0.239) * hu_30_t_y - c_30 * Iu_31_t_xy + t249 * t263;
  const Scalar t264 = c_29 * t262 - s_29 * Ic_29_yz;
  const Scalar Ic_28_xy = t261 + t264;
  const Scalar Iu_28_t_g = Scalar(2.0) * c_28 * Ic_28_xy + s_28 * Iu_28_t_d;
  const Scalar t265 = s_28 * Iu_28_t_g;
  const Scalar t266 = c_29 * hc_29_y + s_29 * t256;
  const Scalar t267 = Scalar(-0.61) * t266;
  const Scalar t268 = t259 + t265 + t267;
  const Scalar Ic_28_zz = Ic_29_xx - t254 - t258 + Scalar(0.2360429000000002);
  const Scalar Ic_27_yy = Ic_28_zz - Scalar(0.7059807000000002);
  const Scalar t269 = Ic_29_xy - Scalar(0.004) * t266 + s_29 * t253 - Scalar(0.0023);
  const Scalar t270 = c_29 * Ic_29_yz + s_29 * t262;
  const Scalar t271 = t257 - Scalar(0.0032);
  const Scalar t272 = c_28 * hu_30_t_y;
  const Scalar t273 = t272 + s_28 * t271;
  const Scalar t274 = Scalar(0.305) * t273 + c_28 * t270 - s_28 * t269;
  const Scalar t275 = c_27 * t274;
  const Scalar t276 = Scalar(2.0) * t275 - s_27 * (t268 + Ic_27_yy);
  const Scalar t277 = s_27 * t276;
  const Scalar Iu_27_t_xx = Ic_27_yy + t277;
  const Scalar t278 = Iu_29_t_xx - t265 + t267 - Scalar(0.7079407000000002);
  const Scalar t279 = t278 + Scalar(0.7079407000000002);
  const Scalar Iu_26_t_d = Iu_27_t_xx + t279;
  const Scalar Iu_28_t_xy = Ic_28_xy - c_28 * Iu_28_t_g;
  const Scalar t280 = s_28 * hu_30_t_y;
  const Scalar t281 = c_28 * t271 - t280;
  const Scalar t282 = Scalar(0.305) * t281 - c_28 * t269 - s_28 * t270;
  const Scalar Iu_27_t_xz = c_27 * t282 + s_27 * Iu_28_t_xy;
  const Scalar t283 = s_26 * Iu_27_t_xz;
  const Scalar t284 = c_26 * Iu_26_t_d - Scalar(2.0) * t283;
  const Scalar t285 = s_25 * s_25;
  const Scalar t286 = Scalar(0.0005096) * t285;
  const Scalar Iu_25_t_xx = t286 - Scalar(0.0005096);
  const Scalar Iu_24_t_d = Iu_25_t_xx - Scalar(0.0235906);
  const Scalar t287 = s_24 * c_25;
  const Scalar Iu_24_t_g = c_24 * Iu_24_t_d + Scalar(0.0014964) * t287;
  const Scalar t288 = c_24 * Iu_24_t_g;
  const Scalar Iu_24_t_xx = t288 + Scalar(0.0235906);
  const Scalar Ic_24_zz = t286 + Scalar(0.0253235000000002);
  const Scalar Ic_23_yy = Ic_24_zz - Scalar(0.0253235000000002);
  const Scalar Iu_23_t_d = Iu_24_t_xx + Ic_23_yy;
  const Scalar t289 = c_24 * c_25;
  const Scalar t290 = s_24 - Scalar(0.6811013098102112) * t289;
  const Scalar t291 = Scalar(0.0014964) * c_23 * s_25 * t290 + s_23 * Iu_23_t_d;
  const Scalar t292 = s_23 * t291;
  const Scalar t293 = Scalar(0.0094) * c_25;
  const Scalar hu_24_t_y = Scalar(0.1902) * c_24 - s_24 * t293;
  const Scalar t294 = Scalar(0.478) * hu_24_t_y;
  const Scalar Ic_22_xx = Ic_23_yy - t292 + t294;
  const Scalar Ic_23_zz = Iu_25_t_xx - t288 - Scalar(0.0259635000000002);
  const Scalar hu_24_t_x = Scalar(0.1902) * s_24 + c_24 * t293;
  const Scalar t295 = Scalar(0.0094) * s_25;
  const Scalar t296 = c_23 * t295;
  const Scalar hu_23_t_x = t296 + s_23 * hu_24_t_x;
  const Scalar t297 = Scalar(0.008) * hu_23_t_x;
  const Scalar Ic_22_yy = Ic_23_zz - t297 + Scalar(0.2262745000000002);
  const Scalar Iu_22_t_d = Ic_22_xx + Ic_22_yy;
  const Scalar Iu_24_t_xy = Scalar(0.0007482) * c_25 - s_24 * Iu_24_t_g;
  const Scalar t298 = c_24 + Scalar(0.6811013098102112) * t287;
  const Scalar t299 = Scalar(0.0007482) * s_25;
  const Scalar t300 = c_23 * t299;
  const Scalar Iu_23_t_xz = t298 * t300 + s_23 * Iu_24_t_xy;
  const Scalar mu_23_22_x = Scalar(0.239) * hu_23_t_x + Iu_23_t_xz;
  const Scalar Ic_22_xy = Scalar(0.004) * hu_24_t_y + mu_23_22_x + Scalar(0.0050592);
  const Scalar t301 = c_22 * Iu_22_t_d - Scalar(2.0) * s_22 * Ic_22_xy;
  const Scalar t302 = c_22 * t301;
  const Scalar Iu_22_t_xx = Ic_22_yy - t302;
  const Scalar t303 = Iu_24_t_xx - t292 - t294 - t297 - Scalar(0.2298769000000002);
  const Scalar hc_22_x = hu_23_t_x + Scalar(0.0328);
  const Scalar hc_22_y = hu_24_t_y + Scalar(0.8648);
  const Scalar hu_22_t_x = c_22 * hc_22_x + s_22 * hc_22_y;
  const Scalar t304 = Scalar(0.008) * hu_22_t_x;
  const Scalar t305 = t303 + t304 + Scalar(0.2282085000000002);
  const Scalar Iu_21_t_d = Iu_22_t_xx - t305;
  const Scalar t306 = s_23 * t295;
  const Scalar t307 = c_23 * hu_24_t_x - t306;
  const Scalar t308 = Scalar(-0.004) * t307;
  const Scalar t309 = c_23 * t291 - t308 - t290 * t299;
  const Scalar t310 = s_23 * t299;
  const Scalar t311 = Scalar(0.239) * t307 + c_23 * Iu_24_t_xy - t298 * t310;
  const Scalar t312 = c_22 * t309 + s_22 * t311;
  const Scalar t313 = t308 + t312;
  const Scalar t314 = Scalar(2.0) * c_21 * t313 - s_21 * Iu_21_t_d;
  const Scalar t315 = s_21 * t314;
  const Scalar t316 = c_22 * hc_22_y - s_22 * hc_22_x;
  const Scalar t317 = Scalar(-0.61) * t316;
  const Scalar t318 = t305 - t315 + t317;
  const Scalar t319 = Ic_22_xx - t302 - t304 + Scalar(0.2360429000000002);
  const Scalar t320 = t319 - Scalar(0.7059807000000002);
  const Scalar t321 = Ic_22_xy - Scalar(0.004) * t316 + s_22 * t301 - Scalar(0.0023);
  const Scalar t322 = c_22 * t311 - s_22 * t309;
  const Scalar hc_21_x = hu_22_t_x + Scalar(0.0032);
  const Scalar t323 = c_21 * t307;
  const Scalar t324 = t323 - s_21 * hc_21_x;
  const Scalar t325 = Scalar(0.305) * t324 + c_21 * t322 - s_21 * t321;
  const Scalar t326 = c_20 * t325;
  const Scalar t327 = Scalar(2.0) * t326 - s_20 * (t318 + t320);
  const Scalar t328 = s_20 * t327;
  const Scalar t329 = t320 + t328;
  const Scalar t330 = Iu_22_t_xx + t315 + t317 - Scalar(0.7079407000000002);
  const Scalar t331 = t330 + Scalar(0.7079407000000002);
  const Scalar t332 = t313 - c_21 * t314;
  const Scalar t333 = s_21 * t307;
  const Scalar t334 = c_21 * hc_21_x + t333;
  const Scalar t335 = Scalar(0.305) * t334 + c_21 * t321 + s_21 * t322;
  const Scalar t336 = c_20 * t335 + s_20 * t332;
  const Scalar t337 = s_19 * t336;
  const Scalar t338 = c_19 * (t329 + t331) + Scalar(2.0) * t337;
  const Scalar t339 = c_26 * t284 + c_19 * t338;
  const Scalar t340 = t266 + Scalar(1.661);
  const Scalar t341 = c_27 * t273 + s_27 * t340;
  const Scalar t342 = t316 + Scalar(1.661);
  const Scalar t343 = c_20 * t324 + s_20 * t342;
  const Scalar t344 = Scalar(-0.48) * (t341 - t343);
  const Scalar Iu_18_t_g = Scalar(0.0044) * c_18 + Scalar(0.024) * s_18;
  const Scalar t345 = s_18 * Iu_18_t_g;
  const Scalar Iu_18_t_xx = t345 - Scalar(0.024);
  const Scalar Iu_17_t_d = Iu_18_t_xx - Scalar(0.0002);
  const Scalar t346 = s_17 * s_17;
  const Scalar t347 = Iu_17_t_d * t346;
  const Scalar Ic_16_zz = Iu_18_t_xx - t347 + Scalar(0.035005);
  const Scalar hu_18_t_y = Scalar(0.02) * c_18 + Scalar(0.22) * s_18;
  const Scalar hu_18_t_x = Scalar(0.22) * c_18 - Scalar(0.02) * s_18;
  const Scalar t348 = s_16 * s_17;
  const Scalar hu_16_t_y = c_16 * hu_18_t_y + hu_18_t_x * t348;
  const Scalar t349 = Scalar(0.006) * hu_16_t_y;
  const Scalar t350 = t279 + t331 - Ic_16_zz - t339 + t344 + t349;
  const Scalar t351 = t268 + t277 - Scalar(0.7099007000000002);
  const Scalar t352 = t318 + t328 - Scalar(0.7099007000000002);
  const Scalar hu_27_t_x = c_27 * t340 - s_27 * t273;
  const Scalar t353 = s_26 * t281;
  const Scalar t354 = c_26 * hu_27_t_x + t353;
  const Scalar t355 = c_17 * hu_18_t_x;
  const Scalar hu_20_t_x = c_20 * t342 - s_20 * t324;
  const Scalar t356 = s_19 * t334;
  const Scalar hu_19_t_x = c_19 * hu_20_t_x - t356;
  const Scalar t357 = Scalar(0.66) * hu_19_t_x + (Scalar(0.66) * t354 - Scalar(0.906) * t355);
  const Scalar Iu_17_t_xx = t347 + Scalar(0.0002);
  const Scalar Iu_16_t_d = t345 + Iu_17_t_xx;
  const Scalar Iu_18_t_xy = c_18 * Iu_18_t_g - Scalar(0.0022);
  const Scalar t358 = Iu_18_t_xy * t348;
  const Scalar Iu_16_t_g = c_16 * Iu_16_t_d + Scalar(2.0) * t358;
  const Scalar t359 = c_16 * Iu_16_t_g;
  const Scalar t360 = t351 + t352 + t345 + t349 + t357 - t359 - Scalar(0.5912714333326666);
  const Scalar t361 = t325 - c_20 * t327;
  const Scalar t362 = c_20 * t332 - s_20 * t335;
  const Scalar t363 = Scalar(0.24) * hu_19_t_x + (c_19 * t361 - s_19 * t362);
  const Scalar t364 = t274 - c_27 * t276;
  const Scalar Iu_27_t_yz = c_27 * Iu_28_t_xy - s_27 * t282;
  const Scalar Iu_26_t_xz = c_26 * t364 + s_26 * Iu_27_t_yz;
  const Scalar t365 = Scalar(0.24) * t354 - Iu_26_t_xz;
  const Scalar t366 = c_16 * s_17;
  const Scalar t367 = hu_18_t_x * t366 - s_16 * hu_18_t_y;
  const Scalar t368 = Scalar(0.453) * t367 - c_17 * (Iu_17_t_d * t366 + s_16 * Iu_18_t_xy);
  const Scalar t369 = Scalar(0.33) * (t341 + t343) - t368 + t363 - t365;
  const Scalar t370 = c_15 * (t350 - t360) + Scalar(2.0) * s_15 * t369;
  const Scalar t371 = c_15 * t370;
  const Scalar t372 = t360 + t371;
  const Scalar t373 = Iu_27_t_xx + t329 + Iu_17_t_xx - t339 - t344 - t357 - t359 +
      Scalar(5.512820899999667);
  const Scalar t374 = c_26 * t281;
  const Scalar t375 = t374 - s_26 * hu_27_t_x;
  const Scalar t376 = c_19 * t334;
  const Scalar hu_19_t_y = t376 + s_19 * hu_20_t_x;
  const Scalar t377 = c_16 * Iu_18_t_xy;
  const Scalar t378 = Scalar(0.453) * hu_16_t_y + c_17 * (t377 - Iu_17_t_d * t348);
  const Scalar t379 = Scalar(0.003) * hu_18_t_x;
  const Scalar t380 = Iu_27_t_xz - t336 - Scalar(0.33) * (t375 - hu_19_t_y) - t378 + s_26 * t284 +
      s_19 * t338 + c_17 * t379 - Scalar(0.043998);
  const Scalar t381 = Scalar(0.24) * hu_19_t_y + (c_19 * t362 + s_19 * t361);
  const Scalar Iu_26_t_yz = c_26 * Iu_27_t_yz - s_26 * t364;
  const Scalar t382 = Scalar(0.24) * t375 - Iu_26_t_yz;
  const Scalar t383 = Scalar(0.003) * t367 + t381 + t382 - s_17 * Iu_18_t_xy + s_16 * Iu_16_t_g;
  const Scalar t384 = c_14 * (c_15 * t380 - s_15 * t383);
  const Scalar t385 = s_14 * (Scalar(2.0) * t384 -
      s_14 * (t373 + t372 - Scalar(2.5051100666670005)));
  const Scalar t386 = c_14 * (t369 - s_15 * t370);
  const Scalar t387 = t351 + Scalar(0.33) * t354;
  const Scalar t388 = c_14 * (c_15 * t365 - s_15 * t387);
  const Scalar t389 = t278 - Scalar(0.24) * t341;
  const Scalar t390 = c_26 * Iu_27_t_xz + s_26 * t389;
  const Scalar mu_27_15_y = Iu_27_t_yz + Scalar(0.33) * s_26 * t341;
  const Scalar t391 = c_14 * (c_15 * t390 + s_15 * mu_27_15_y);
  const Scalar t392 = c_27 * Ic_28_zz + s_27 * t274;
  const Scalar f_u_28_26_t_y = c_26 * t273 - s_27 * t353;
  const Scalar mu_28_15_x = Scalar(0.24) * f_u_28_26_t_y + c_26 * t392 - s_26 * t282;
  const Scalar t393 = t275 - s_27 * Ic_28_zz;
  const Scalar t394 = t393 - Scalar(0.33) * f_u_28_26_t_y;
  const Scalar t395 = c_14 * (c_15 * mu_28_15_x + s_15 * t394);
  const Scalar t396 = Scalar(0.305) * t266 - (t255 - Scalar(0.004) * t257);
  const Scalar t397 = s_28 * t264 - c_28 * t396;
  const Scalar t398 = c_27 * t270 - s_27 * t397;
  const Scalar t399 = c_28 * t264 + s_28 * t396;
  const Scalar t400 = s_28 * t266;
  const Scalar t401 = c_27 * t257 + s_27 * t400;
  const Scalar t402 = c_28 * t266;
  const Scalar t403 = c_26 * t402 + s_26 * t401;
  const Scalar t404 = Scalar(0.24) * t403 + c_26 * t398 + s_26 * t399;
  const Scalar t405 = c_27 * t397 + s_27 * t270;
  const Scalar t406 = t405 + Scalar(0.33) * t403;
  const Scalar mu_u_29_15_t_x = c_15 * t404 - s_15 * t406;
  const Scalar t407 = Scalar(-0.004) * t247;
  const Scalar mu_30_29_y = Ic_30_zz - t407;
  const Scalar t408 = c_29 * t252 - s_29 * mu_30_29_y;
  const Scalar t409 = s_29 * hu_30_t_y;
  const Scalar mu_30_28_y = Ic_29_yz - Scalar(0.004) * t409;
  const Scalar t410 = c_29 * t272 + s_28 * t247;
  const Scalar t411 = Scalar(0.305) * t410 + c_28 * mu_30_28_y + s_28 * t408;
  const Scalar t412 = t407 + c_29 * mu_30_29_y + s_29 * t252;
  const Scalar t413 = c_27 * t412 - s_27 * t411;
  const Scalar t414 = c_28 * t247 - c_29 * t280;
  const Scalar t415 = Scalar(0.305) * t414 + c_28 * t408 - s_28 * mu_30_28_y;
  const Scalar t416 = c_27 * t409 + s_27 * t414;
  const Scalar f_u_30_26_t_y = c_26 * t410 - s_26 * t416;
  const Scalar mu_30_15_x = Scalar(0.24) * f_u_30_26_t_y - c_26 * t413 - s_26 * t415;
  const Scalar t417 = c_27 * t411 + s_27 * t412;
  const Scalar t418 = t417 - Scalar(0.33) * f_u_30_26_t_y;
  const Scalar t419 = c_14 * (c_15 * mu_30_15_x + s_15 * t418);
  const Scalar f_u_32_30_t_y = c_31 * t246 + s_30 * t243;
  const Scalar t420 = Scalar(0.004) * f_u_32_30_t_y;
  const Scalar mu_u_32_31_t_y = Scalar(0.0014129000000002) * c_31 - Scalar(0.0007482) * t235;
  const Scalar mu_32_29_y = mu_u_32_31_t_y - t420;
  const Scalar mu_u_32_31_t_x = Scalar(0.0014129000000002) * s_31 + Scalar(0.0007482) * t239;
  const Scalar mu_32_29_x = t251 + Scalar(0.239) * f_u_32_30_t_y + s_30 * mu_u_32_31_t_x;
  const Scalar mu_u_32_29_t_x = c_29 * mu_32_29_x + s_29 * mu_32_29_y;
  const Scalar t421 = c_30 * t243 - c_31 * t260;
  const Scalar t422 = s_31 * t245;
  const Scalar f_u_32_29_t_x = c_29 * t421 + s_29 * t422;
  const Scalar t423 = c_28 * f_u_32_29_t_x - s_28 * f_u_32_30_t_y;
  const Scalar f_u_32_29_t_y = c_29 * t422 - s_29 * t421;
  const Scalar mu_32_29_z = t263 - Scalar(0.239) * t421 + Scalar(0.0000376) * s_31 * s_32 -
      c_30 * mu_u_32_31_t_x;
  const Scalar mu_32_28_y = mu_32_29_z - Scalar(0.004) * f_u_32_29_t_y;
  const Scalar t424 = Scalar(0.305) * t423 - c_28 * mu_32_28_y - s_28 * mu_u_32_29_t_x;
  const Scalar mu_32_28_z = t420 + c_29 * mu_32_29_y - s_29 * mu_32_29_x;
  const Scalar mu_u_32_27_t_x = c_27 * mu_32_28_z - s_27 * t424;
  const Scalar f_u_32_28_t_x = c_28 * f_u_32_30_t_y + s_28 * f_u_32_29_t_x;
  const Scalar f_u_32_27_t_x = c_27 * f_u_32_29_t_y + s_27 * f_u_32_28_t_x;
  const Scalar f_u_32_26_t_y = c_26 * t423 + s_26 * f_u_32_27_t_x;
  const Scalar mu_32_27_z = Scalar(0.305) * f_u_32_28_t_x + c_28 * mu_u_32_29_t_x -
      s_28 * mu_32_28_y;
  const Scalar mu_32_15_x = Scalar(0.24) * f_u_32_26_t_y - c_26 * mu_u_32_27_t_x +
      s_26 * mu_32_27_z;
  const Scalar mu_u_32_27_t_y = c_27 * t424 + s_27 * mu_32_28_z;
  const Scalar mu_32_15_y = mu_u_32_27_t_y - Scalar(0.33) * f_u_32_26_t_y;
  const Scalar mu_u_32_15_t_x = c_15 * mu_32_15_x + s_15 * mu_32_15_y;
  const Scalar f_u_32_26_t_x = c_26 * f_u_32_27_t_x - s_26 * t423;
  const Scalar t425 = c_27 * f_u_32_28_t_x - s_27 * f_u_32_29_t_y;
  const Scalar t426 = Scalar(0.33) * t425 - Scalar(0.24) * f_u_32_26_t_x - c_26 * mu_32_27_z -
      s_26 * mu_u_32_27_t_x;
  const Scalar mu_u_32_14_t_y = c_14 * mu_u_32_15_t_x - s_14 * t426;
  const Scalar t427 = Scalar(0.5295491542217383) * s_32;
  const Scalar t428 = Ic_31_zz + Scalar(0.239) * hu_31_t_y;
  const Scalar mu_31_29_x = t240 * t263 + c_30 * t428;
  const Scalar t429 = c_30 * hu_31_t_y;
  const Scalar t430 = Scalar(0.004) * t429;
  const Scalar t431 = t249 * t250;
  const Scalar t432 = t430 - t431;
  const Scalar t433 = c_29 * mu_31_29_x - s_29 * t432;
  const Scalar t434 = s_30 * hu_31_t_y;
  const Scalar t435 = c_29 * t434 - s_29 * hu_31_t_x;
  const Scalar f_u_31_28_t_y = c_28 * t435 + s_28 * t429;
  const Scalar mu_31_29_z = Scalar(0.004) * hu_31_t_x + s_30 * t428 - t240 * t251;
  const Scalar f_u_31_29_t_y = c_29 * hu_31_t_x + s_29 * t434;
  const Scalar mu_31_28_y = mu_31_29_z - Scalar(0.004) * f_u_31_29_t_y;
  const Scalar mu_31_27_x = Scalar(0.305) * f_u_31_28_t_y + c_28 * mu_31_28_y + s_28 * t433;
  const Scalar mu_31_28_z = t430 - c_29 * t432 - s_29 * mu_31_29_x;
  const Scalar mu_u_31_27_t_x = c_27 * mu_31_28_z + s_27 * mu_31_27_x;
  const Scalar f_u_31_28_t_x = c_28 * t429 - s_28 * t435;
  const Scalar f_u_31_27_t_x = c_27 * f_u_31_29_t_y + s_27 * f_u_31_28_t_x;
  const Scalar t436 = c_26 * f_u_31_28_t_y - s_26 * f_u_31_27_t_x;
  const Scalar mu_31_27_z = Scalar(0.305) * f_u_31_28_t_x + c_28 * t433 - s_28 * mu_31_28_y;
  const Scalar t437 = Scalar(0.24) * t436 + c_26 * mu_u_31_27_t_x - s_26 * mu_31_27_z;
  const Scalar t438 = c_27 * mu_31_27_x - s_27 * mu_31_28_z;
  const Scalar t439 = t438 - Scalar(0.33) * t436;
  const Scalar t440 = c_14 * (c_15 * t437 + s_15 * t439);
  const Scalar f_u_31_26_t_x = c_26 * f_u_31_27_t_x + s_26 * f_u_31_28_t_y;
  const Scalar t441 = c_27 * f_u_31_28_t_x - s_27 * f_u_31_29_t_y;
  const Scalar t442 = Scalar(0.33) * t441 - Scalar(0.24) * f_u_31_26_t_x - c_26 * mu_31_27_z -
      s_26 * mu_u_31_27_t_x;
  const Scalar b_32_31_13 = t440 + s_14 * t442 + mu_u_32_14_t_y * t427;
  const Scalar t443 = Scalar(0.00039620867718870463) * t233 - Ic_31_zz;
  const Scalar t444 = Scalar(1.0) / t443;
  const Scalar t445 = t431 - mu_u_32_31_t_y * t427;
  const Scalar t446 = t445 * t444;
  const Scalar t447 = c_26 * t416 + s_26 * t410;
  const Scalar t448 = c_27 * t414 - s_27 * t409;
  const Scalar t449 = Scalar(0.33) * t448 - Scalar(0.24) * t447 - c_26 * t415 + s_26 * t413;
  const Scalar t450 = Scalar(707.7641729774637) * mu_u_32_31_t_y;
  const Scalar t451 = t419 + s_14 * t449 + mu_u_32_14_t_y * t450 + b_32_31_13 * t446;
  const Scalar b_32_31_29 = mu_31_29_z - mu_32_29_z * t427;
  const Scalar b_31_30_29 = Ic_29_yz - mu_32_29_z * t450 + b_32_31_29 * t446;
  const Scalar b_31_30_30 = Ic_30_zz + mu_u_32_31_t_y * t450 - t445 * t446;
  const Scalar d_30 = Scalar(1.0) / b_31_30_30;
  const Scalar t452 = b_31_30_29 * d_30;
  const Scalar f_u_29_26_t_x = c_26 * t401 - s_26 * t402;
  const Scalar f_u_29_27_t_y = c_27 * t400 - s_27 * t257;
  const Scalar mu_29_15_z = Scalar(0.33) * f_u_29_27_t_y - Scalar(0.24) * f_u_29_26_t_x -
      c_26 * t399 + s_26 * t398;
  const Scalar t453 = b_32_31_29 * t444;
  const Scalar t454 = Scalar(707.7641729774637) * mu_32_29_z;
  const Scalar t455 = c_14 * mu_u_29_15_t_x - s_14 * mu_29_15_z + mu_u_32_14_t_y * t454 +
      b_32_31_13 * t453 + t451 * t452;
  const Scalar b_32_31_28 = mu_31_28_z - mu_32_28_z * t427;
  const Scalar t456 = t412 + mu_32_28_z * t450 - b_32_31_28 * t446;
  const Scalar t457 = t270 - mu_32_28_z * t454 + b_32_31_28 * t453 - t456 * t452;
  const Scalar t458 = t255 + mu_32_29_z * t454 - b_32_31_29 * t453 - b_31_30_29 * t452;
  const Scalar t459 = Scalar(1.0) / t458;
  const Scalar t460 = t457 * t459;
  const Scalar t461 = s_27 * t374 + s_26 * t273;
  const Scalar t462 = Scalar(0.24) * t461 - Scalar(0.33) * c_27 * t281 + c_26 * t282 + s_26 * t392;
  const Scalar t463 = t456 * d_30;
  const Scalar t464 = b_32_31_28 * t444;
  const Scalar t465 = Scalar(707.7641729774637) * mu_32_28_z;
  const Scalar t466 = t395 - s_14 * t462 + mu_u_32_14_t_y * t465 + b_32_31_13 * t464 - t451 * t463 +
      t455 * t460;
  const Scalar b_32_31_27 = mu_31_27_z - mu_32_27_z * t427;
  const Scalar t467 = t415 - mu_32_27_z * t450 + b_32_31_27 * t446;
  const Scalar t468 = t399 + mu_32_27_z * t454 - b_32_31_27 * t453 - t467 * t452;
  const Scalar t469 = t282 - mu_32_27_z * t465 + b_32_31_27 * t464 - t467 * t463 - t468 * t460;
  const Scalar b_29_28_28 = Ic_28_zz - mu_32_28_z * t465 + b_32_31_28 * t464 + t456 * t463 +
      t457 * t460;
  const Scalar d_28 = Scalar(1.0) / b_29_28_28;
  const Scalar t470 = t469 * d_28;
  const Scalar mu_27_15_z = Scalar(0.33) * hu_27_t_x - t283 + c_26 * t389;
  const Scalar t471 = t468 * t459;
  const Scalar t472 = t467 * d_30;
  const Scalar t473 = b_32_31_27 * t444;
  const Scalar t474 = Scalar(707.7641729774637) * mu_32_27_z;
  const Scalar t475 = t391 + s_14 * mu_27_15_z + mu_u_32_14_t_y * t474 + b_32_31_13 * t473 +
      t451 * t472 - t455 * t471 - t466 * t470;
  const Scalar t476 = t438 + mu_u_32_27_t_y * t427;
  const Scalar t477 = t417 + mu_u_32_27_t_y * t450 + t476 * t446;
  const Scalar t478 = t405 - mu_u_32_27_t_y * t454 - t476 * t453 - t477 * t452;
  const Scalar t479 = t393 + mu_u_32_27_t_y * t465 + t476 * t464 - t477 * t463 - t478 * t460;
  const Scalar b_28_27_26 = Iu_27_t_yz + mu_u_32_27_t_y * t474 + t476 * t473 + t477 * t472 +
      t478 * t471 - t479 * t470;
  const Scalar t480 = t278 + mu_32_27_z * t474 - b_32_31_27 * t473 - t467 * t472 - t468 * t471 +
      t469 * t470;
  const Scalar t481 = Scalar(1.0) / t480;
  const Scalar t482 = b_28_27_26 * t481;
  const Scalar t483 = t479 * d_28;
  const Scalar t484 = t478 * t459;
  const Scalar t485 = t477 * d_30;
  const Scalar t486 = t476 * t444;
  const Scalar t487 = Scalar(707.7641729774637) * mu_u_32_27_t_y;
  const Scalar t488 = t388 + s_14 * t382 - mu_u_32_14_t_y * t487 + b_32_31_13 * t486 + t451 * t485 -
      t455 * t484 - t466 * t483 + t475 * t482;
  const Scalar t489 = t442 - t426 * t427;
  const Scalar t490 = t449 - t426 * t450 + t489 * t446;
  const Scalar b_30_29_15 = mu_29_15_z + t426 * t454 - t489 * t453 - t490 * t452;
  const Scalar t491 = t462 + t426 * t465 - t489 * t464 + t490 * t463 + b_30_29_15 * t460;
  const Scalar b_28_27_15 = mu_27_15_z - t426 * t474 + t489 * t473 + t490 * t472 +
      b_30_29_15 * t471 + t491 * t470;
  const Scalar t492 = t382 + t426 * t487 + t489 * t486 + t490 * t485 + b_30_29_15 * t484 +
      t491 * t483 + b_28_27_15 * t482;
  const Scalar t493 = t351 + mu_u_32_27_t_y * t487 - t476 * t486 - t477 * t485 - t478 * t484 +
      t479 * t483 - b_28_27_26 * t482;
  const Scalar t494 = Scalar(1.0) / t493;
  const Scalar t495 = t492 * t494;
  const Scalar t496 = t352 + Scalar(0.33) * hu_19_t_x;
  const Scalar mu_u_19_15_t_x = c_15 * t363 + s_15 * t496;
  const Scalar t497 = t330 + Scalar(0.24) * t343;
  const Scalar t498 = c_19 * t336 - s_19 * t497;
  const Scalar t499 = t362 - Scalar(0.33) * s_19 * t343;
  const Scalar t500 = c_14 * (c_15 * t498 + s_15 * t499);
  const Scalar t501 = c_20 * t319 + s_20 * t325;
  const Scalar t502 = c_19 * t324 + s_20 * t356;
  const Scalar t503 = Scalar(0.24) * t502 - c_19 * t501 - s_19 * t335;
  const Scalar t504 = t326 - s_20 * t319;
  const Scalar t505 = t504 - Scalar(0.33) * t502;
  const Scalar mu_u_21_15_t_x = c_15 * t503 - s_15 * t505;
  const Scalar t506 = Scalar(0.305) * t316 - (t303 + Scalar(0.004) * hu_22_t_x);
  const Scalar t507 = s_21 * t312 + c_21 * t506;
  const Scalar t508 = c_20 * t322 + s_20 * t507;
  const Scalar t509 = c_21 * t312 - s_21 * t506;
  const Scalar t510 = s_21 * t316;
  const Scalar f_u_22_20_t_x = c_20 * hu_22_t_x - s_20 * t510;
  const Scalar t511 = c_21 * t316;
  const Scalar t512 = c_19 * t511 - s_19 * f_u_22_20_t_x;
  const Scalar t513 = Scalar(0.24) * t512 - c_19 * t508 + s_19 * t509;
  const Scalar t514 = c_20 * t507 - s_20 * t322;
  const Scalar t515 = t514 - Scalar(0.33) * t512;
  const Scalar t516 = c_14 * (c_15 * t513 - s_15 * t515);
  const Scalar t517 = Scalar(0.004) * hu_23_t_x;
  const Scalar mu_23_22_y = Ic_23_zz - t517;
  const Scalar mu_u_23_22_t_x = c_22 * mu_23_22_x + s_22 * mu_23_22_y;
  const Scalar t518 = s_22 * t307;
  const Scalar t519 = t311 - Scalar(0.004) * t518;
  const Scalar t520 = c_22 * t323 - s_21 * hu_23_t_x;
  const Scalar t521 = Scalar(0.305) * t520 + c_21 * t519 - s_21 * mu_u_23_22_t_x;
  const Scalar mu_23_21_z = t517 + c_22 * mu_23_22_y - s_22 * mu_23_22_x;
  const Scalar mu_u_23_20_t_x = c_20 * mu_23_21_z - s_20 * t521;
  const Scalar t522 = c_21 * hu_23_t_x + c_22 * t333;
  const Scalar t523 = Scalar(0.305) * t522 + c_21 * mu_u_23_22_t_x + s_21 * t519;
  const Scalar f_u_23_20_t_x = c_20 * t518 - s_20 * t522;
  const Scalar t524 = c_19 * t520 - s_19 * f_u_23_20_t_x;
  const Scalar t525 = Scalar(0.24) * t524 + c_19 * mu_u_23_20_t_x - s_19 * t523;
  const Scalar mu_u_23_20_t_y = c_20 * t521 + s_20 * mu_23_21_z;
  const Scalar mu_23_15_y = mu_u_23_20_t_y - Scalar(0.33) * t524;
  const Scalar t526 = c_14 * (c_15 * t525 - s_15 * mu_23_15_y);
  const Scalar f_u_25_23_t_y = c_24 * t296 + s_23 * t293;
  const Scalar t527 = Scalar(0.004) * f_u_25_23_t_y;
  const Scalar mu_u_25_24_t_y = Scalar(0.0014129000000002) * c_24 + Scalar(0.0007482) * t287;
  const Scalar mu_25_22_y = mu_u_25_24_t_y + t527;
  const Scalar mu_u_25_24_t_x = Scalar(0.0014129000000002) * s_24 - Scalar(0.0007482) * t289;
  const Scalar mu_25_22_x = t300 + Scalar(0.239) * f_u_25_23_t_y - s_23 * mu_u_25_24_t_x;
  const Scalar t528 = c_22 * mu_25_22_x - s_22 * mu_25_22_y;
  const Scalar t529 = c_23 * t293 - c_24 * t306;
  const Scalar t530 = s_24 * t295;
  const Scalar f_u_25_22_t_x = c_22 * t529 + s_22 * t530;
  const Scalar t531 = c_21 * f_u_25_22_t_x - s_21 * f_u_25_23_t_y;
  const Scalar f_u_25_22_t_y = c_22 * t530 - s_22 * t529;
  const Scalar mu_25_22_z = t310 - Scalar(0.239) * t529 + Scalar(0.0000376) * s_24 * s_25 +
      c_23 * mu_u_25_24_t_x;
  const Scalar mu_25_21_y = mu_25_22_z - Scalar(0.004) * f_u_25_22_t_y;
  const Scalar t532 = Scalar(0.305) * t531 - c_21 * mu_25_21_y - s_21 * t528;
  const Scalar mu_25_21_z = t527 - c_22 * mu_25_22_y - s_22 * mu_25_22_x;
  const Scalar mu_u_25_20_t_x = c_20 * mu_25_21_z - s_20 * t532;
  const Scalar f_u_25_21_t_x = c_21 * f_u_25_23_t_y + s_21 * f_u_25_22_t_x;
  const Scalar f_u_25_20_t_x = c_20 * f_u_25_22_t_y + s_20 * f_u_25_21_t_x;
  const Scalar f_u_25_19_t_y = c_19 * t531 + s_19 * f_u_25_20_t_x;
  const Scalar mu_25_20_z = Scalar(0.305) * f_u_25_21_t_x + c_21 * t528 - s_21 * mu_25_21_y;
  const Scalar mu_25_15_x = Scalar(0.24) * f_u_25_19_t_y + c_19 * mu_u_25_20_t_x -
      s_19 * mu_25_20_z;
  const Scalar mu_u_25_20_t_y = c_20 * t532 + s_20 * mu_25_21_z;
  const Scalar mu_25_15_y = mu_u_25_20_t_y - Scalar(0.33) * f_u_25_19_t_y;
  const Scalar f_u_25_19_t_x = c_19 * f_u_25_20_t_x - s_19 * t531;
  const Scalar t533 = c_20 * f_u_25_21_t_x - s_20 * f_u_25_22_t_y;
  const Scalar t534 = Scalar(0.33) * t533 + Scalar(0.24) * f_u_25_19_t_x - c_19 * mu_25_20_z -
      s_19 * mu_u_25_20_t_x;
  const Scalar t535 = c_14 * (c_15 * mu_25_15_x - s_15 * mu_25_15_y) + s_14 * t534;
  const Scalar t536 = Scalar(0.5295491542217383) * s_25;
  const Scalar t537 = Ic_24_zz + Scalar(0.239) * hu_24_t_y;
  const Scalar t538 = t290 * t310 - c_23 * t537;
  const Scalar t539 = c_23 * hu_24_t_y;
  const Scalar t540 = Scalar(0.004) * t539;
  const Scalar t541 = t298 * t299;
  const Scalar mu_24_22_y = t540 + t541;
  const Scalar t542 = c_22 * t538 + s_22 * mu_24_22_y;
  const Scalar t543 = s_23 * hu_24_t_y;
  const Scalar t544 = c_22 * t543 - s_22 * hu_24_t_x;
  const Scalar f_u_24_21_t_y = c_21 * t544 + s_21 * t539;
  const Scalar mu_24_22_z = Scalar(0.004) * hu_24_t_x + s_23 * t537 + t290 * t300;
  const Scalar f_u_24_22_t_y = c_22 * hu_24_t_x + s_22 * t543;
  const Scalar mu_24_21_y = mu_24_22_z - Scalar(0.004) * f_u_24_22_t_y;
  const Scalar mu_24_20_x = Scalar(0.305) * f_u_24_21_t_y + c_21 * mu_24_21_y - s_21 * t542;
  const Scalar mu_24_21_z = t540 - c_22 * mu_24_22_y + s_22 * t538;
  const Scalar mu_u_24_20_t_x = c_20 * mu_24_21_z + s_20 * mu_24_20_x;
  const Scalar f_u_24_21_t_x = c_21 * t539 - s_21 * t544;
  const Scalar f_u_24_20_t_x = c_20 * f_u_24_22_t_y + s_20 * f_u_24_21_t_x;
  const Scalar t545 = c_19 * f_u_24_21_t_y - s_19 * f_u_24_20_t_x;
  const Scalar mu_24_20_z = Scalar(0.305) * f_u_24_21_t_x - c_21 * t542 - s_21 * mu_24_21_y;
  const Scalar t546 = Scalar(0.24) * t545 - c_19 * mu_u_24_20_t_x + s_19 * mu_24_20_z;
  const Scalar t547 = c_20 * mu_24_20_x - s_20 * mu_24_21_z;
  const Scalar t548 = t547 - Scalar(0.33) * t545;
  const Scalar mu_u_24_15_t_x = c_15 * t546 - s_15 * t548;
  const Scalar f_u_24_19_t_x = c_19 * f_u_24_20_t_x + s_19 * f_u_24_21_t_y;
  const Scalar t549 = c_20 * f_u_24_21_t_x - s_20 * f_u_24_22_t_y;
  const Scalar t550 = Scalar(0.33) * t549 + Scalar(0.24) * f_u_24_19_t_x - c_19 * mu_24_20_z -
      s_19 * mu_u_24_20_t_x;
  const Scalar t551 = c_14 * mu_u_24_15_t_x - s_14 * t550 + t535 * t536;
  const Scalar t552 = Scalar(0.00039620867718870463) * t285 - Ic_24_zz;
  const Scalar t553 = Scalar(1.0) / t552;
  const Scalar b_25_24_23 = t541 - mu_u_25_24_t_y * t536;
  const Scalar t554 = b_25_24_23 * t553;
  const Scalar t555 = c_19 * f_u_23_20_t_x + s_19 * t520;
  const Scalar t556 = c_20 * t522 + s_20 * t518;
  const Scalar t557 = Scalar(0.33) * t556 - Scalar(0.24) * t555 - c_19 * t523 -
      s_19 * mu_u_23_20_t_x;
  const Scalar t558 = Scalar(707.7641729774637) * mu_u_25_24_t_y;
  const Scalar t559 = t526 + s_14 * t557 - t535 * t558 - t551 * t554;
  const Scalar b_25_24_22 = mu_24_22_z - mu_25_22_z * t536;
  const Scalar t560 = t311 + mu_25_22_z * t558 - b_25_24_22 * t554;
  const Scalar b_24_23_23 = Ic_23_zz + mu_u_25_24_t_y * t558 - b_25_24_23 * t554;
  const Scalar d_23 = Scalar(1.0) / b_24_23_23;
  const Scalar t561 = t560 * d_23;
  const Scalar t562 = c_19 * f_u_22_20_t_x + s_19 * t511;
  const Scalar f_u_22_20_t_y = c_20 * t510 + s_20 * hu_22_t_x;
  const Scalar mu_22_15_z = Scalar(0.33) * f_u_22_20_t_y - Scalar(0.24) * t562 + c_19 * t509 +
      s_19 * t508;
  const Scalar t563 = b_25_24_22 * t553;
  const Scalar t564 = Scalar(707.7641729774637) * mu_25_22_z;
  const Scalar t565 = t516 + s_14 * mu_22_15_z + t535 * t564 + t551 * t563 + t559 * t561;
  const Scalar b_25_24_21 = mu_24_21_z - mu_25_21_z * t536;
  const Scalar b_24_23_21 = mu_23_21_z - mu_25_21_z * t558 + b_25_24_21 * t554;
  const Scalar t566 = t322 - mu_25_21_z * t564 + b_25_24_21 * t563 - b_24_23_21 * t561;
  const Scalar t567 = t303 + mu_25_22_z * t564 - b_25_24_22 * t563 - t560 * t561;
  const Scalar t568 = Scalar(1.0) / t567;
  const Scalar t569 = t566 * t568;
  const Scalar f_u_21_19_t_x = s_20 * t376 - s_19 * t324;
  const Scalar mu_21_15_z = Scalar(0.24) * f_u_21_19_t_x + Scalar(0.33) * c_20 * t334 -
      c_19 * t335 + s_19 * t501;
  const Scalar t570 = b_24_23_21 * d_23;
  const Scalar t571 = b_25_24_21 * t553;
  const Scalar t572 = Scalar(707.7641729774637) * mu_25_21_z;
  const Scalar t573 = c_14 * mu_u_21_15_t_x + s_14 * mu_21_15_z + t535 * t572 + t551 * t571 -
      t559 * t570 + t565 * t569;
  const Scalar b_25_24_20 = mu_24_20_z - mu_25_20_z * t536;
  const Scalar t574 = t523 - mu_25_20_z * t558 + b_25_24_20 * t554;
  const Scalar t575 = t509 - mu_25_20_z * t564 + b_25_24_20 * t563 - t574 * t561;
  const Scalar t576 = t335 + mu_25_20_z * t572 - b_25_24_20 * t571 - t574 * t570 - t575 * t569;
  const Scalar t577 = t319 - mu_25_21_z * t572 + b_25_24_21 * t571 + b_24_23_21 * t570 +
      t566 * t569;
  const Scalar t578 = Scalar(1.0) / t577;
  const Scalar t579 = t576 * t578;
  const Scalar mu_20_15_z = Scalar(0.33) * hu_20_t_x + t337 + c_19 * t497;
  const Scalar t580 = t575 * t568;
  const Scalar t581 = t574 * d_23;
  const Scalar t582 = b_25_24_20 * t553;
  const Scalar t583 = Scalar(707.7641729774637) * mu_25_20_z;
  const Scalar t584 = t500 - s_14 * mu_20_15_z + t535 * t583 + t551 * t582 - t559 * t581 +
      t565 * t580 + t573 * t579;
  const Scalar t585 = t547 + mu_u_25_20_t_y * t536;
  const Scalar b_24_23_19 = mu_u_23_20_t_y - mu_u_25_20_t_y * t558 - t585 * t554;
  const Scalar t586 = t514 + mu_u_25_20_t_y * t564 + t585 * t563 + b_24_23_19 * t561;
  const Scalar t587 = t504 + mu_u_25_20_t_y * t572 + t585 * t571 - b_24_23_19 * t570 + t586 * t569;
  const Scalar t588 = t362 - mu_u_25_20_t_y * t583 - t585 * t582 + b_24_23_19 * t581 - t586 * t580 -
      t587 * t579;
  const Scalar t589 = t330 + mu_25_20_z * t583 - b_25_24_20 * t582 - t574 * t581 - t575 * t580 +
      t576 * t579;
  const Scalar t590 = Scalar(1.0) / t589;
  const Scalar t591 = t588 * t590;
  const Scalar t592 = t587 * t578;
  const Scalar t593 = t586 * t568;
  const Scalar t594 = b_24_23_19 * d_23;
  const Scalar t595 = t585 * t553;
  const Scalar t596 = Scalar(707.7641729774637) * mu_u_25_20_t_y;
  const Scalar t597 = c_14 * mu_u_19_15_t_x - s_14 * t381 - t535 * t596 + t551 * t595 +
      t559 * t594 + t565 * t593 - t573 * t592 - t584 * t591;
  const Scalar t598 = t550 - t534 * t536;
  const Scalar t599 = t557 - t534 * t558 + t598 * t554;
  const Scalar b_23_22_15 = mu_22_15_z + t534 * t564 - t598 * t563 + t599 * t561;
  const Scalar b_22_21_15 = mu_21_15_z + t534 * t572 - t598 * t571 - t599 * t570 +
      b_23_22_15 * t569;
  const Scalar b_21_20_15 = mu_20_15_z - t534 * t583 + t598 * t582 + t599 * t581 -
      b_23_22_15 * t580 - b_22_21_15 * t579;
  const Scalar t600 = t381 + t534 * t596 + t598 * t595 - t599 * t594 - b_23_22_15 * t593 +
      b_22_21_15 * t592 - b_21_20_15 * t591;
  const Scalar t601 = t352 + mu_u_25_20_t_y * t596 - t585 * t595 - b_24_23_19 * t594 - t586 * t593 +
      t587 * t592 - t588 * t591;
  const Scalar t602 = Scalar(1.0) / t601;
  const Scalar t603 = t600 * t602;
  const Scalar t604 = b_28_27_15 * t481;
  const Scalar t605 = b_21_20_15 * t590;
  const Scalar t606 = t491 * d_28;
  const Scalar t607 = b_22_21_15 * t578;
  const Scalar t608 = b_30_29_15 * t459;
  const Scalar t609 = b_23_22_15 * t568;
  const Scalar t610 = t490 * d_30;
  const Scalar t611 = t599 * d_23;
  const Scalar t612 = t489 * t444;
  const Scalar t613 = t598 * t553;
  const Scalar t614 = t426 * mu_u_32_14_t_y - t534 * t535;
  const Scalar Ic_17_zz = t345 - Scalar(0.03438);
  const Scalar t615 = Ic_17_zz - Scalar(0.453) * t355;
  const Scalar mu_17_15_y = s_16 * t615 - s_17 * (t377 - t379);
  const Scalar t616 = c_17 * (Iu_18_t_xy - c_16 * t379);
  const Scalar t617 = t358 + c_16 * t615;
  const Scalar t618 = c_14 * (c_15 * t616 + s_15 * mu_17_15_y) - s_14 * t617;
  const Scalar d_17 = Scalar(1.0) / Ic_17_zz;
  const Scalar t619 = Iu_18_t_xy * d_17;
  const Scalar t620 = c_17 * t619;
  const Scalar mu_16_15_x = Ic_16_zz - Scalar(0.003) * hu_16_t_y;
  const Scalar t621 = c_14 * (c_15 * mu_16_15_x + s_15 * t368);
  const Scalar f_u_18_16_t_x = hu_18_t_y * t366 + s_16 * hu_18_t_x;
  const Scalar mu_18_15_x = Scalar(0.03408) * s_17 - Scalar(0.003) * f_u_18_16_t_x;
  const Scalar t622 = hu_18_t_y * t348 - c_16 * hu_18_t_x;
  const Scalar t623 = Scalar(0.03408) * c_17;
  const Scalar t624 = Scalar(0.453) * t622 - (c_16 - Scalar(0.0880281690140845) * hu_18_t_y) * t623;
  const Scalar mu_18_15_z = Scalar(0.453) * f_u_18_16_t_x + s_16 * t623;
  const Scalar mu_u_18_14_t_y = c_14 * (c_15 * mu_18_15_x - s_15 * t624) + s_14 * mu_18_15_z;
  const Scalar t625 = t621 + s_14 * t378 - s_17 * mu_u_18_14_t_y + t618 * t620;
  const Scalar t626 = Iu_18_t_xy * t619;
  const Scalar b_17_16_16 = Ic_16_zz + t626 - t346 * (t626 + Scalar(0.03408));
  const Scalar t627 = Scalar(1.0) / b_17_16_16;
  const Scalar t628 = t378 - s_17 * mu_18_15_z - t617 * t620;
  const Scalar t629 = t628 * t627;
  const Scalar t630 = t617 * d_17;
  const Scalar t631 = Scalar(29.342723004694836) * mu_18_15_z;
  const Scalar t632 = t384 - Scalar(707.7641729774637) * t614 - s_14 * t373 - b_32_31_13 * t612 -
      t451 * t610 + t455 * t608 - t466 * t606 - t475 * t604 - t488 * t495 + t551 * t613 -
      t559 * t611 - t565 * t609 + t573 * t607 + t584 * t605 + t597 * t603 + mu_u_18_14_t_y * t631 +
      t618 * t630 + t625 * t629;
  const Scalar Iu_15_t_yz = c_15 * t383 + s_15 * t380;
  const Scalar t633 = c_15 * mu_32_15_y - s_15 * mu_32_15_x;
  const Scalar t634 = c_15 * t439 - s_15 * t437 + t633 * t427;
  const Scalar t635 = c_15 * t418 - s_15 * mu_30_15_x + t633 * t450 + t634 * t446;
  const Scalar t636 = c_15 * t406 + s_15 * t404 - t633 * t454 - t634 * t453 - t635 * t452;
  const Scalar t637 = c_15 * t394 - s_15 * mu_28_15_x + t633 * t465 + t634 * t464 - t635 * t463 -
      t636 * t460;
  const Scalar t638 = c_15 * mu_27_15_y - s_15 * t390 + t633 * t474 + t634 * t473 + t635 * t472 +
      t636 * t471 - t637 * t470;
  const Scalar t639 = c_15 * t387 + s_15 * t365 + t633 * t487 - t634 * t486 - t635 * t485 -
      t636 * t484 + t637 * t483 - t638 * t482;
  const Scalar mu_u_25_15_t_y = c_15 * mu_25_15_y + s_15 * mu_25_15_x;
  const Scalar b_25_24_14 = c_15 * t548 + s_15 * t546 + mu_u_25_15_t_y * t536;
  const Scalar t640 = c_15 * mu_23_15_y + s_15 * t525 - mu_u_25_15_t_y * t558 - b_25_24_14 * t554;
  const Scalar t641 = c_15 * t515 + s_15 * t513 + mu_u_25_15_t_y * t564 + b_25_24_14 * t563 +
      t640 * t561;
  const Scalar t642 = c_15 * t505 + s_15 * t503 + mu_u_25_15_t_y * t572 + b_25_24_14 * t571 -
      t640 * t570 + t641 * t569;
  const Scalar t643 = c_15 * t499 - s_15 * t498 - mu_u_25_15_t_y * t583 - b_25_24_14 * t582 +
      t640 * t581 - t641 * t580 - t642 * t579;
  const Scalar t644 = c_15 * t496 - s_15 * t363 + mu_u_25_15_t_y * t596 - b_25_24_14 * t595 -
      t640 * t594 - t641 * t593 + t642 * t592 - t643 * t591;
  const Scalar t645 = t426 * t633 + t534 * mu_u_25_15_t_y;
  const Scalar t646 = c_15 * mu_17_15_y - s_15 * t616;
  const Scalar t647 = c_15 * t624 + s_15 * mu_18_15_x;
  const Scalar t648 = c_15 * t368 - s_15 * mu_16_15_x + s_17 * t647 + t646 * t620;
  const Scalar b_16_15_14 = Iu_15_t_yz + Scalar(707.7641729774637) * t645 + t634 * t612 +
      t635 * t610 + t636 * t608 + t637 * t606 + t638 * t604 - t639 * t495 + b_25_24_14 * t613 -
      t640 * t611 - t641 * t609 + t642 * t607 - t643 * t605 - t644 * t603 + t647 * t631 -
      t646 * t630 - t648 * t629;
  const Scalar t649 = t426 * t426 + t534 * t534;
  const Scalar b_16_15_15 = t373 - Scalar(707.7641729774637) * t649 + t489 * t612 + t490 * t610 +
      b_30_29_15 * t608 - t491 * t606 + b_28_27_15 * t604 + t492 * t495 + t598 * t613 +
      t599 * t611 + b_23_22_15 * t609 - b_22_21_15 * t607 + b_21_20_15 * t605 + t600 * t603 -
      mu_18_15_z * t631 + t617 * t630 - t628 * t629;
  const Scalar t650 = Scalar(1.0) / b_16_15_15;
  const Scalar t651 = b_16_15_14 * t650;
  const Scalar t652 = t639 * t494;
  const Scalar t653 = t644 * t602;
  const Scalar t654 = t638 * t481;
  const Scalar t655 = t643 * t590;
  const Scalar t656 = t637 * d_28;
  const Scalar t657 = t642 * t578;
  const Scalar t658 = t636 * t459;
  const Scalar t659 = t641 * t568;
  const Scalar t660 = t635 * d_30;
  const Scalar t661 = t640 * d_23;
  const Scalar t662 = t634 * t444;
  const Scalar t663 = b_25_24_14 * t553;
  const Scalar t664 = t633 * mu_u_32_14_t_y - mu_u_25_15_t_y * t535;
  const Scalar t665 = t648 * t627;
  const Scalar t666 = t646 * d_17;
  const Scalar t667 = Scalar(29.342723004694836) * t647;
  const Scalar t668 = Scalar(707.7641729774637) * t664 + t386 - s_14 * Iu_15_t_yz -
      b_32_31_13 * t662 - t451 * t660 + t455 * t658 + t466 * t656 - t475 * t654 + t488 * t652 +
      t551 * t663 + t559 * t661 + t565 * t659 - t573 * t657 - t584 * t655 - t597 * t653 -
      mu_u_18_14_t_y * t667 - t618 * t666 + t625 * t665 - t632 * t651;
  const Scalar t669 = t633 * t633 + mu_u_25_15_t_y * mu_u_25_15_t_y;
  const Scalar t670 = t350 - t371 + Scalar(707.7641729774637) * t669 - t634 * t662 - t635 * t660 -
      t636 * t658 + t637 * t656 - t638 * t654 - t639 * t652 - b_25_24_14 * t663 - t640 * t661 -
      t641 * t659 + t642 * t657 - t643 * t655 - t644 * t653 + t647 * t667 - t646 * t666 +
      t648 * t665 + b_16_15_14 * t651 - Scalar(2.5075600666670006);
  const Scalar t671 = Scalar(1.0) / t670;
  const Scalar t672 = t668 * t671;
  const Scalar t673 = t632 * t650;
  const Scalar t674 = t488 * t494;
  const Scalar t675 = t597 * t602;
  const Scalar t676 = t475 * t481;
  const Scalar t677 = t584 * t590;
  const Scalar t678 = t466 * d_28;
  const Scalar t679 = t573 * t578;
  const Scalar t680 = t455 * t459;
  const Scalar t681 = t565 * t568;
  const Scalar t682 = t451 * d_30;
  const Scalar t683 = t559 * d_23;
  const Scalar t684 = b_32_31_13 * t444;
  const Scalar t685 = t551 * t553;
  const Scalar t686 = mu_u_32_14_t_y * mu_u_32_14_t_y + t535 * t535;
  const Scalar t687 = t625 * t627;
  const Scalar t688 = t618 * d_17;
  const Scalar t689 = Scalar(29.342723004694836) * mu_u_18_14_t_y;
  const Scalar t690 = t372 + Scalar(707.7641729774637) * t686 + t385 - b_32_31_13 * t684 -
      t451 * t682 - t455 * t680 + t466 * t678 - t475 * t676 - t488 * t674 - t551 * t685 -
      t559 * t683 - t565 * t681 + t573 * t679 - t584 * t677 - t597 * t675 + mu_u_18_14_t_y * t689 -
      t618 * t688 + t625 * t687 + t632 * t673 - t668 * t672 - Scalar(2.5107600666670002);
  const Scalar t691 = c_14 * c_15;
  const Scalar t692 = qd_13 * t691 - s_15 * qd_14;
  const Scalar t693 = qd_13 * qd_14;
  const Scalar t694 = s_14 * t693;
  const Scalar domega_15_y = s_15 * t694 - qd_15 * t692;
  const Scalar t695 = s_14 * qd_13;
  const Scalar omega_15_z = qd_15 - t695;
  const Scalar t696 = t692 * omega_15_z;
  const Scalar U_15_zx = domega_15_y - t696;
  const Scalar t697 = Scalar(9.81) * s_14;
  const Scalar t698 = Scalar(0.33) * U_15_zx + t697;
  const Scalar t699 = c_14 * s_15;
  const Scalar omega_r_15_y = c_15 * qd_14 + qd_13 * t699;
  const Scalar domega_15_x = c_15 * t694 + qd_15 * omega_r_15_y;
  const Scalar t700 = omega_r_15_y * omega_15_z;
  const Scalar U_15_zy = domega_15_x + t700;
  const Scalar t701 = Scalar(0.24) * U_15_zy;
  const Scalar t702 = t698 - t701;
  const Scalar t703 = omega_r_15_y * omega_r_15_y;
  const Scalar t704 = omega_15_z * omega_15_z;
  const Scalar U_15_xx = t703 + t704;
  const Scalar t705 = Scalar(9.81) * t691;
  const Scalar t706 = Scalar(0.33) * U_15_xx - t705;
  const Scalar t707 = t692 * omega_r_15_y;
  const Scalar t708 = c_14 * t693;
  const Scalar U_15_xy = t708 - t707;
  const Scalar t709 = Scalar(0.24) * U_15_xy;
  const Scalar t710 = t706 + t709;
  const Scalar t711 = c_26 * t710 + s_26 * t702;
  const Scalar t712 = t708 + t707;
  const Scalar t713 = Scalar(9.81) * t699;
  const Scalar t714 = Scalar(0.33) * t712 + t713;
  const Scalar t715 = t692 * t692;
  const Scalar U_15_yy = t704 + t715;
  const Scalar t716 = Scalar(0.24) * U_15_yy;
  const Scalar t717 = t714 - t716;
  const Scalar t718 = c_27 * t717 - s_27 * t711;
  const Scalar omega_r_26_x = c_26 * t692 + s_26 * omega_15_z;
  const Scalar omega_26_z = qd_26 + omega_r_15_y;
  const Scalar omega_r_27_x = c_27 * omega_26_z + s_27 * omega_r_26_x;
  const Scalar t719 = c_27 * omega_r_26_x - s_27 * omega_26_z;
  const Scalar t720 = omega_r_27_x * t719;
  const Scalar domega_26_y = c_26 * t708 - s_26 * domega_15_x + qd_26 * omega_r_26_x;
  const Scalar U_27_xy = domega_26_y + t720;
  const Scalar t721 = t718 - Scalar(0.305) * U_27_xy;
  const Scalar t722 = c_26 * t702 - s_26 * t710;
  const Scalar omega_r_26_y = c_26 * omega_15_z - s_26 * t692;
  const Scalar t723 = c_26 * domega_15_x + s_26 * t708 - qd_26 * omega_r_26_y;
  const Scalar domega_27_x = c_27 * domega_15_y + s_27 * t723 - qd_27 * t719;
  const Scalar omega_27_z = qd_27 + omega_r_26_y;
  const Scalar t724 = t719 * omega_27_z;
  const Scalar U_27_zy = domega_27_x - t724;
  const Scalar t725 = t722 - Scalar(0.305) * U_27_zy;
  const Scalar t726 = c_28 * omega_r_27_x - s_28 * omega_27_z;
  const Scalar omega_28_z = qd_28 + t719;
  const Scalar t727 = omega_28_z * omega_28_z;
  const Scalar U_28_xx = t726 * t726 + t727;
  const Scalar ddp_o_29_x = Scalar(0.004) * U_28_xx + c_28 * t725 - s_28 * t721;
  const Scalar U_27_yy = omega_r_27_x * omega_r_27_x + omega_27_z * omega_27_z;
  const Scalar ddp_o_28_y = Scalar(0.305) * U_27_yy - c_27 * t711 - s_27 * t717;
  const Scalar omega_r_28_x = c_28 * omega_27_z + s_28 * omega_r_27_x;
  const Scalar domega_28_y = c_28 * domega_27_x - s_28 * domega_26_y + qd_28 * omega_r_28_x;
  const Scalar t728 = omega_r_28_x * omega_28_z;
  const Scalar U_28_zx = domega_28_y + t728;
  const Scalar ddp_o_29_z = ddp_o_28_y + Scalar(0.004) * U_28_zx;
  const Scalar ddp_29_x = c_29 * ddp_o_29_x + s_29 * ddp_o_29_z;
  const Scalar omega_r_29_y = c_29 * omega_28_z + s_29 * omega_r_28_x;
  const Scalar omega_29_z = qd_29 + t726;
  const Scalar t729 = omega_29_z * omega_29_z;
  const Scalar U_29_xx = omega_r_29_y * omega_r_29_y + t729;
  const Scalar t730 = c_29 * omega_r_28_x - s_29 * omega_28_z;
  const Scalar t731 = t730 * omega_r_29_y;
  const Scalar U_29_xy = domega_28_y - t731;
  const Scalar ddp_o_30_x = ddp_29_x - Scalar(0.004) * U_29_xx - Scalar(0.239) * U_29_xy;
  const Scalar t732 = c_28 * t721 + s_28 * t725;
  const Scalar t733 = omega_r_28_x * t726;
  const Scalar domega_27_y = c_27 * t723 - s_27 * domega_15_y + qd_27 * omega_r_27_x;
  const Scalar U_28_yx = domega_27_y - t733;
  const Scalar t734 = t732 - Scalar(0.004) * U_28_yx;
  const Scalar domega_28_x = c_28 * domega_26_y + s_28 * domega_27_x - qd_28 * t726;
  const Scalar domega_29_y = c_29 * domega_27_y + s_29 * domega_28_x - qd_29 * t730;
  const Scalar t735 = t730 * omega_29_z;
  const Scalar U_29_zx = domega_29_y - t735;
  const Scalar domega_29_x = c_29 * domega_28_x - s_29 * domega_27_y + qd_29 * omega_r_29_y;
  const Scalar t736 = omega_r_29_y * omega_29_z;
  const Scalar U_29_zy = domega_29_x + t736;
  const Scalar t737 = t734 + Scalar(0.004) * U_29_zx - Scalar(0.239) * U_29_zy;
  const Scalar ddp_30_x = c_30 * t737 + s_30 * ddp_o_30_x;
  const Scalar t738 = c_29 * ddp_o_29_z - s_29 * ddp_o_29_x;
  const Scalar U_29_yx = domega_28_y + t731;
  const Scalar U_29_yy = t729 + t730 * t730;
  const Scalar t739 = t738 - Scalar(0.004) * U_29_yx + Scalar(0.239) * U_29_yy;
  const Scalar t740 = c_31 * ddp_30_x + s_31 * t739;
  const Scalar t741 = c_30 * ddp_o_30_x - s_30 * t737;
  const Scalar ddp_32_x = c_32 * t741 - s_32 * t740;
  const Scalar omega_r_30_y = c_30 * t730 + s_30 * omega_29_z;
  const Scalar domega_30_x = c_30 * domega_28_y - s_30 * domega_29_x + qd_30 * omega_r_30_y;
  const Scalar omega_r_30_x = c_30 * omega_29_z - s_30 * t730;
  const Scalar omega_30_z = qd_30 + omega_r_29_y;
  const Scalar t742 = c_31 * omega_30_z - s_31 * omega_r_30_x;
  const Scalar domega_31_x = c_31 * domega_30_x + s_31 * domega_29_y - qd_31 * t742;
  const Scalar omega_r_31_x = c_31 * omega_r_30_x + s_31 * omega_30_z;
  const Scalar omega_31_z = qd_31 + omega_r_30_y;
  const Scalar omega_r_32_x = c_32 * omega_31_z + s_32 * omega_r_31_x;
  const Scalar t743 = c_30 * domega_29_x + s_30 * domega_28_y - qd_30 * omega_r_30_x;
  const Scalar domega_32_y = c_32 * domega_31_x - s_32 * t743 + qd_32 * omega_r_32_x;
  const Scalar omega_32_z = qd_32 + t742;
  const Scalar t744 = omega_r_32_x * omega_32_z;
  const Scalar U_32_xz = domega_32_y - t744;
  const Scalar t745 = c_32 * omega_r_31_x - s_32 * omega_31_z;
  const Scalar t746 = omega_r_32_x * t745;
  const Scalar domega_31_y = c_31 * domega_29_y - s_31 * domega_30_x + qd_31 * omega_r_31_x;
  const Scalar N_32_z = Scalar(0.0014129000000002) * domega_31_y + Scalar(0.0094) * ddp_32_x -
      Scalar(0.0005096) * t746 - Scalar(0.0007482) * U_32_xz;
  const Scalar y_32 = tau_32 + N_32_z;
  const Scalar t747 = c_31 * t739 - s_31 * ddp_30_x;
  const Scalar t748 = omega_32_z * omega_32_z;
  const Scalar t749 = Scalar(0.0094) * t747 - Scalar(0.0007482) * (t748 - t745 * t745) -
      Scalar(0.0009033000000002) * t745 * omega_32_z;
  const Scalar U_32_xy = domega_31_y + t746;
  const Scalar N_32_y = Scalar(0.0005096) * domega_32_y - Scalar(0.0007482) * U_32_xy +
      Scalar(0.0014129000000002) * t744;
  const Scalar t750 = omega_r_31_x * t742;
  const Scalar t751 = Scalar(-0.0253235000000002) * t743;
  const Scalar t752 = Scalar(0.1902) * t740 - Scalar(0.0250035000000002) * t750 - c_32 * t749 +
      s_32 * N_32_y + t751;
  const Scalar y_32_31 = tau_31 - t752 - y_32 * t427;
  const Scalar mu_31_y = Scalar(0.0250035000000002) * domega_31_y - N_32_z -
      Scalar(0.0253235000000002) * omega_r_31_x * omega_31_z;
  const Scalar t753 = t742 * omega_31_z;
  const Scalar t754 = Scalar(0.1902) * t741 + Scalar(0.0503270000000004) * t753 - c_32 * N_32_y -
      s_32 * t749;
  const Scalar mu_30_z = Scalar(0.0259635000000002) * domega_29_y -
      Scalar(0.0253235000000002) * omega_r_30_x * omega_r_30_y - c_31 * mu_31_y - s_31 * t754;
  const Scalar y_31_30 = tau_30 + mu_30_z - y_32 * t450 + t446 * y_32_31;
  const Scalar mu_30_x = Scalar(0.0512870000000004) * omega_r_30_y * omega_30_z - c_31 * t754 +
      s_31 * mu_31_y;
  const Scalar t755 = t751 - t752 - Scalar(0.0259635000000002) * omega_r_30_x * omega_30_z;
  const Scalar U_32_yy = omega_r_32_x * omega_r_32_x + t748;
  const Scalar t756 = Scalar(0.1902) * (t743 + t750) -
      Scalar(0.0094) * (c_32 * U_32_yy - s_32 * U_32_xy);
  const Scalar U_32_zy = c_32 * t743 + s_32 * domega_31_x - t745 * (qd_32 + omega_32_z);
  const Scalar U_31_yy = omega_r_31_x * omega_r_31_x + omega_31_z * omega_31_z;
  const Scalar f_31_y = Scalar(0.1902) * U_31_yy + Scalar(0.0094) * U_32_zy;
  const Scalar f_u_31_t_x = c_31 * t756 + s_31 * f_31_y;
  const Scalar U_31_zy = domega_31_x - t753;
  const Scalar f_31_z = Scalar(0.1902) * U_31_zy -
      Scalar(0.0094) * (c_32 * U_32_xy + s_32 * U_32_yy);
  const Scalar f_u_30_t_x = c_30 * f_31_z + s_30 * f_u_31_t_x;
  const Scalar f_u_31_t_y = c_31 * f_31_y - s_31 * t756;
  const Scalar U_29_xx_yy = U_29_xx - U_29_yy;
  const Scalar mu_29_z = Scalar(0.2298769000000002) * domega_28_y - Scalar(0.8648) * ddp_29_x -
      Scalar(0.0328) * t738 - Scalar(0.2262745000000002) * t731 + Scalar(0.0050592) * U_29_xx_yy -
      Scalar(0.004) * f_u_31_t_y + Scalar(0.239) * f_u_30_t_x + c_30 * mu_30_x + s_30 * t755;
  const Scalar y_30_29 = tau_29 + mu_29_z - y_32 * t454 + t453 * y_32_31 + t452 * y_31_30;
  const Scalar t757 = c_30 * f_u_31_t_x - s_30 * f_31_z;
  const Scalar t758 = Scalar(0.8648) * t734 + Scalar(0.0050592) * U_29_zx -
      Scalar(0.4561514000000004) * t736 - Scalar(0.239) * t757 - c_30 * t755 + s_30 * mu_30_x;
  const Scalar t759 = Scalar(0.0328) * t734 - Scalar(0.2262745000000002) * domega_29_y -
      Scalar(0.2298769000000002) * t735 - Scalar(0.0050592) * U_29_zy + mu_30_z -
      Scalar(0.004) * t757;
  const Scalar f_29_z = Scalar(0.0328) * U_29_zx - Scalar(0.8648) * U_29_zy - t757;
  const Scalar t760 = t726 * omega_28_z;
  const Scalar U_28_yz = domega_28_x + t760;
  const Scalar mu_28_z = Scalar(0.2360429000000002) * domega_27_y + Scalar(0.0032) * t732 +
      Scalar(0.2282085000000002) * t733 + Scalar(0.0023) * U_28_yz - Scalar(0.004) * f_29_z +
      c_29 * t759 + s_29 * t758;
  const Scalar y_29_28 = tau_28 + mu_28_z - y_32 * t465 + t464 * y_32_31 - t463 * y_31_30 +
      t460 * y_30_29;
  const Scalar t761 = Scalar(0.0023) * U_28_yx - Scalar(0.4642514000000004) * t760 - c_29 * t758 +
      s_29 * t759;
  const Scalar f_29_x = Scalar(0.0328) * U_29_xx + Scalar(0.8648) * U_29_xy + f_u_30_t_x;
  const Scalar f_29_y = Scalar(0.0328) * U_29_yx - Scalar(0.8648) * U_29_yy - f_u_31_t_y;
  const Scalar f_u_29_t_y = c_29 * f_29_y + s_29 * f_29_x;
  const Scalar mu_28_y = Scalar(0.0032) * ddp_o_28_y + Scalar(0.2282085000000002) * domega_28_y -
      Scalar(0.2360429000000002) * t728 + Scalar(0.0023) * (t727 - omega_r_28_x * omega_r_28_x) -
      mu_29_z + Scalar(0.004) * f_u_29_t_y;
  const Scalar f_28_x = Scalar(0.0032) * U_28_xx + c_29 * f_29_x - s_29 * f_29_y;
  const Scalar f_28_y = Scalar(0.0032) * U_28_yx + f_29_z;
  const Scalar f_u_28_t_x = c_28 * f_28_y + s_28 * f_28_x;
  const Scalar t762 = Scalar(0.7079407000000002) * domega_26_y;
  const Scalar t763 = Scalar(1.661) * t718 - Scalar(0.7059807000000002) * t720 +
      Scalar(0.305) * f_u_28_t_x - c_28 * t761 - s_28 * mu_28_y - t762;
  const Scalar y_28_27 = tau_27 - t763 - y_32 * t474 + t473 * y_32_31 + t472 * y_31_30 -
      t471 * y_30_29 - t470 * y_29_28;
  const Scalar t764 = c_28 * f_28_x - s_28 * f_28_y;
  const Scalar t765 = Scalar(1.661) * t722 + Scalar(1.4139214000000004) * t724 -
      Scalar(0.305) * t764 + c_28 * mu_28_y - s_28 * t761;
  const Scalar mu_27_y = Scalar(0.7059807000000002) * domega_27_y - mu_28_z -
      Scalar(0.7079407000000002) * omega_r_27_x * omega_27_z;
  const Scalar t766 = Scalar(0.7099007000000002) * domega_15_y;
  const Scalar mu_26_z = Scalar(0.7079407000000002) * omega_r_26_x * omega_r_26_y - c_27 * t765 +
      s_27 * mu_27_y + t766;
  const Scalar y_27_26 = tau_26 + mu_26_z + y_32 * t487 + t486 * y_32_31 + t485 * y_31_30 -
      t484 * y_30_29 - t483 * y_29_28 + t482 * y_28_27;
  const Scalar ddp_o_19_z = t698 + t701;
  const Scalar t767 = t706 - t709;
  const Scalar t768 = c_19 * t767 + s_19 * ddp_o_19_z;
  const Scalar t769 = t714 + t716;
  const Scalar t770 = c_20 * t769 - s_20 * t768;
  const Scalar omega_r_19_x = c_19 * t692 + s_19 * omega_15_z;
  const Scalar omega_19_z = qd_19 + omega_r_15_y;
  const Scalar omega_r_20_x = c_20 * omega_19_z + s_20 * omega_r_19_x;
  const Scalar t771 = c_20 * omega_r_19_x - s_20 * omega_19_z;
  const Scalar t772 = omega_r_20_x * t771;
  const Scalar domega_19_y = c_19 * t708 - s_19 * domega_15_x + qd_19 * omega_r_19_x;
  const Scalar U_20_xy = domega_19_y + t772;
  const Scalar t773 = t770 - Scalar(0.305) * U_20_xy;
  const Scalar t774 = c_19 * ddp_o_19_z - s_19 * t767;
  const Scalar omega_r_19_y = c_19 * omega_15_z - s_19 * t692;
  const Scalar t775 = c_19 * domega_15_x + s_19 * t708 - qd_19 * omega_r_19_y;
  const Scalar domega_20_x = c_20 * domega_15_y + s_20 * t775 - qd_20 * t771;
  const Scalar omega_20_z = qd_20 + omega_r_19_y;
  const Scalar t776 = t771 * omega_20_z;
  const Scalar U_20_zy = domega_20_x - t776;
  const Scalar t777 = t774 - Scalar(0.305) * U_20_zy;
  const Scalar t778 = c_21 * omega_r_20_x - s_21 * omega_20_z;
  const Scalar omega_21_z = qd_21 + t771;
  const Scalar t779 = omega_21_z * omega_21_z;
  const Scalar U_21_xx = t778 * t778 + t779;
  const Scalar ddp_o_22_x = Scalar(0.004) * U_21_xx + c_21 * t777 - s_21 * t773;
  const Scalar U_20_yy = omega_r_20_x * omega_r_20_x + omega_20_z * omega_20_z;
  const Scalar ddp_o_21_y = Scalar(0.305) * U_20_yy - c_20 * t768 - s_20 * t769;
  const Scalar omega_r_21_x = c_21 * omega_20_z + s_21 * omega_r_20_x;
  const Scalar domega_21_y = c_21 * domega_20_x - s_21 * domega_19_y + qd_21 * omega_r_21_x;
  const Scalar t780 = omega_r_21_x * omega_21_z;
  const Scalar U_21_zx = domega_21_y + t780;
  const Scalar ddp_o_22_z = ddp_o_21_y + Scalar(0.004) * U_21_zx;
  const Scalar ddp_22_x = c_22 * ddp_o_22_x + s_22 * ddp_o_22_z;
  const Scalar omega_r_22_y = c_22 * omega_21_z + s_22 * omega_r_21_x;
  const Scalar omega_22_z = qd_22 + t778;
  const Scalar t781 = omega_22_z * omega_22_z;
  const Scalar U_22_xx = omega_r_22_y * omega_r_22_y + t781;
  const Scalar t782 = c_22 * omega_r_21_x - s_22 * omega_21_z;
  const Scalar t783 = t782 * omega_r_22_y;
  const Scalar U_22_xy = domega_21_y - t783;
  const Scalar ddp_o_23_x = ddp_22_x - Scalar(0.004) * U_22_xx - Scalar(0.239) * U_22_xy;
  const Scalar t784 = c_21 * t773 + s_21 * t777;
  const Scalar t785 = omega_r_21_x * t778;
  const Scalar domega_20_y = c_20 * t775 - s_20 * domega_15_y + qd_20 * omega_r_20_x;
  const Scalar U_21_yx = domega_20_y - t785;
  const Scalar t786 = t784 - Scalar(0.004) * U_21_yx;
  const Scalar domega_21_x = c_21 * domega_19_y + s_21 * domega_20_x - qd_21 * t778;
  const Scalar domega_22_y = c_22 * domega_20_y + s_22 * domega_21_x - qd_22 * t782;
  const Scalar t787 = t782 * omega_22_z;
  const Scalar U_22_zx = domega_22_y - t787;
  const Scalar domega_22_x = c_22 * domega_21_x - s_22 * domega_20_y + qd_22 * omega_r_22_y;
  const Scalar t788 = omega_r_22_y * omega_22_z;
  const Scalar U_22_zy = domega_22_x + t788;
  const Scalar t789 = t786 + Scalar(0.004) * U_22_zx - Scalar(0.239) * U_22_zy;
  const Scalar ddp_23_x = c_23 * t789 + s_23 * ddp_o_23_x;
  const Scalar t790 = c_22 * ddp_o_22_z - s_22 * ddp_o_22_x;
  const Scalar U_22_yx = domega_21_y + t783;
  const Scalar U_22_yy = t781 + t782 * t782;
  const Scalar t791 = t790 - Scalar(0.004) * U_22_yx + Scalar(0.239) * U_22_yy;
  const Scalar t792 = c_24 * ddp_23_x + s_24 * t791;
  const Scalar t793 = c_23 * ddp_o_23_x - s_23 * t789;
  const Scalar ddp_25_x = c_25 * t793 - s_25 * t792;
  const Scalar omega_r_23_y = c_23 * t782 + s_23 * omega_22_z;
  const Scalar domega_23_x = c_23 * domega_21_y - s_23 * domega_22_x + qd_23 * omega_r_23_y;
  const Scalar omega_r_23_x = c_23 * omega_22_z - s_23 * t782;
  const Scalar omega_23_z = qd_23 + omega_r_22_y;
  const Scalar t794 = c_24 * omega_23_z - s_24 * omega_r_23_x;
  const Scalar domega_24_x = c_24 * domega_23_x + s_24 * domega_22_y - qd_24 * t794;
  const Scalar omega_r_24_x = c_24 * omega_r_23_x + s_24 * omega_23_z;
  const Scalar omega_24_z = qd_24 + omega_r_23_y;
  const Scalar omega_r_25_x = c_25 * omega_24_z + s_25 * omega_r_24_x;
  const Scalar t795 = c_23 * domega_22_x + s_23 * domega_21_y - qd_23 * omega_r_23_x;
  const Scalar domega_25_y = c_25 * domega_24_x - s_25 * t795 + qd_25 * omega_r_25_x;
  const Scalar omega_25_z = qd_25 + t794;
  const Scalar t796 = omega_r_25_x * omega_25_z;
  const Scalar U_25_xz = domega_25_y - t796;
  const Scalar t797 = c_25 * omega_r_24_x - s_25 * omega_24_z;
  const Scalar t798 = omega_r_25_x * t797;
  const Scalar domega_24_y = c_24 * domega_22_y - s_24 * domega_23_x + qd_24 * omega_r_24_x;
  const Scalar N_25_z = Scalar(0.0014129000000002) * domega_24_y - Scalar(0.0094) * ddp_25_x -
      Scalar(0.0005096) * t798 + Scalar(0.0007482) * U_25_xz;
  const Scalar y_25 = tau_25 + N_25_z;
  const Scalar t799 = c_24 * t791 - s_24 * ddp_23_x;
  const Scalar t800 = omega_25_z * omega_25_z;
  const Scalar t801 = Scalar(0.0094) * t799 - Scalar(0.0007482) * (t800 - t797 * t797) +
      Scalar(0.0009033000000002) * t797 * omega_25_z;
  const Scalar U_25_xy = domega_24_y + t798;
  const Scalar N_25_y = Scalar(0.0005096) * domega_25_y + Scalar(0.0007482) * U_25_xy +
      Scalar(0.0014129000000002) * t796;
  const Scalar t802 = omega_r_24_x * t794;
  const Scalar t803 = Scalar(-0.0253235000000002) * t795;
  const Scalar t804 = Scalar(0.1902) * t792 - Scalar(0.0250035000000002) * t802 + c_25 * t801 +
      s_25 * N_25_y + t803;
  const Scalar y_25_24 = tau_24 - t804 + y_25 * t536;
  const Scalar mu_24_y = Scalar(0.0250035000000002) * domega_24_y - N_25_z -
      Scalar(0.0253235000000002) * omega_r_24_x * omega_24_z;
  const Scalar t805 = t794 * omega_24_z;
  const Scalar t806 = Scalar(0.1902) * t793 + Scalar(0.0503270000000004) * t805 - c_25 * N_25_y +
      s_25 * t801;
  const Scalar mu_23_z = Scalar(0.0259635000000002) * domega_22_y -
      Scalar(0.0253235000000002) * omega_r_23_x * omega_r_23_y - c_24 * mu_24_y - s_24 * t806;
  const Scalar y_24_23 = tau_23 + mu_23_z - y_25 * t558 - t554 * y_25_24;
  const Scalar mu_23_x = Scalar(0.0512870000000004) * omega_r_23_y * omega_23_z - c_24 * t806 +
      s_24 * mu_24_y;
  const Scalar t807 = t803 - t804 - Scalar(0.0259635000000002) * omega_r_23_x * omega_23_z;
  const Scalar U_25_yy = omega_r_25_x * omega_r_25_x + t800;
  const Scalar t808 = Scalar(0.1902) * (t795 + t802) +
      Scalar(0.0094) * (c_25 * U_25_yy - s_25 * U_25_xy);
  const Scalar U_25_zy = c_25 * t795 + s_25 * domega_24_x - t797 * (qd_25 + omega_25_z);
  const Scalar U_24_yy = omega_r_24_x * omega_r_24_x + omega_24_z * omega_24_z;
  const Scalar f_24_y = Scalar(0.1902) * U_24_yy - Scalar(0.0094) * U_25_zy;
  const Scalar f_u_24_t_x = c_24 * t808 + s_24 * f_24_y;
  const Scalar U_24_zy = domega_24_x - t805;
  const Scalar f_24_z = Scalar(0.1902) * U_24_zy +
      Scalar(0.0094) * (c_25 * U_25_xy + s_25 * U_25_yy);
  const Scalar f_u_23_t_x = c_23 * f_24_z + s_23 * f_u_24_t_x;
  const Scalar f_u_24_t_y = c_24 * f_24_y - s_24 * t808;
  const Scalar U_22_xx_yy = U_22_xx - U_22_yy;
  const Scalar mu_22_z = Scalar(0.2298769000000002) * domega_21_y - Scalar(0.8648) * ddp_22_x -
      Scalar(0.0328) * t790 - Scalar(0.2262745000000002) * t783 + Scalar(0.0050592) * U_22_xx_yy -
      Scalar(0.004) * f_u_24_t_y + Scalar(0.239) * f_u_23_t_x + c_23 * mu_23_x + s_23 * t807;
  const Scalar y_23_22 = tau_22 + mu_22_z + y_25 * t564 + t563 * y_25_24 + t561 * y_24_23;
  const Scalar t809 = c_23 * f_u_24_t_x - s_23 * f_24_z;
  const Scalar t810 = Scalar(0.8648) * t786 + Scalar(0.0050592) * U_22_zx -
      Scalar(0.4561514000000004) * t788 - Scalar(0.239) * t809 - c_23 * t807 + s_23 * mu_23_x;
  const Scalar t811 = Scalar(0.0328) * t786 - Scalar(0.2262745000000002) * domega_22_y -
      Scalar(0.2298769000000002) * t787 - Scalar(0.0050592) * U_22_zy + mu_23_z -
      Scalar(0.004) * t809;
  const Scalar f_22_z = Scalar(0.0328) * U_22_zx - Scalar(0.8648) * U_22_zy - t809;
  const Scalar t812 = t778 * omega_21_z;
  const Scalar U_21_yz = domega_21_x + t812;
  const Scalar mu_21_z = Scalar(0.2360429000000002) * domega_20_y + Scalar(0.0032) * t784 +
      Scalar(0.2282085000000002) * t785 + Scalar(0.0023) * U_21_yz - Scalar(0.004) * f_22_z +
      c_22 * t811 + s_22 * t810;
  const Scalar y_22_21 = tau_21 + mu_21_z + y_25 * t572 + t571 * y_25_24 - t570 * y_24_23 +
      t569 * y_23_22;
  const Scalar t813 = Scalar(0.0023) * U_21_yx - Scalar(0.4642514000000004) * t812 - c_22 * t810 +
      s_22 * t811;
  const Scalar f_22_x = Scalar(0.0328) * U_22_xx + Scalar(0.8648) * U_22_xy + f_u_23_t_x;
  const Scalar f_22_y = Scalar(0.0328) * U_22_yx - Scalar(0.8648) * U_22_yy - f_u_24_t_y;
  const Scalar f_u_22_t_y = c_22 * f_22_y + s_22 * f_22_x;
  const Scalar mu_21_y = Scalar(0.0032) * ddp_o_21_y + Scalar(0.2282085000000002) * domega_21_y -
      Scalar(0.2360429000000002) * t780 + Scalar(0.0023) * (t779 - omega_r_21_x * omega_r_21_x) -
      mu_22_z + Scalar(0.004) * f_u_22_t_y;
  const Scalar f_21_x = Scalar(0.0032) * U_21_xx + c_22 * f_22_x - s_22 * f_22_y;
  const Scalar f_21_y = Scalar(0.0032) * U_21_yx + f_22_z;
  const Scalar f_u_21_t_x = c_21 * f_21_y + s_21 * f_21_x;
  const Scalar t814 = Scalar(0.7079407000000002) * domega_19_y;
  const Scalar t815 = Scalar(1.661) * t770 - Scalar(0.7059807000000002) * t772 +
      Scalar(0.305) * f_u_21_t_x - c_21 * t813 - s_21 * mu_21_y - t814;
  const Scalar y_21_20 = tau_20 - t815 + y_25 * t583 + t582 * y_25_24 - t581 * y_24_23 +
      t580 * y_23_22 + t579 * y_22_21;
  const Scalar t816 = c_21 * f_21_x - s_21 * f_21_y;
  const Scalar t817 = Scalar(1.661) * t774 + Scalar(1.4139214000000004) * t776 -
      Scalar(0.305) * t816 + c_21 * mu_21_y - s_21 * t813;
  const Scalar mu_20_y = Scalar(0.7059807000000002) * domega_20_y - mu_21_z -
      Scalar(0.7079407000000002) * omega_r_20_x * omega_20_z;
  const Scalar mu_19_z = t766 + Scalar(0.7079407000000002) * omega_r_19_x * omega_r_19_y -
      c_20 * t817 + s_20 * mu_20_y;
  const Scalar y_20_19 = tau_19 + mu_19_z - y_25 * t596 + t595 * y_25_24 + t594 * y_24_23 +
      t593 * y_23_22 - t592 * y_22_21 - t591 * y_21_20;
  const Scalar f_27_x = Scalar(1.661) * U_27_xy - f_u_28_t_x;
  const Scalar f_27_y = Scalar(1.661) * U_27_yy - Scalar(0.0032) * U_28_zx - f_u_29_t_y;
  const Scalar t818 = c_27 * f_27_y - s_27 * f_27_x;
  const Scalar f_27_z = Scalar(1.661) * U_27_zy + t764;
  const Scalar f_20_x = Scalar(1.661) * U_20_xy - f_u_21_t_x;
  const Scalar f_20_y = Scalar(1.661) * U_20_yy - Scalar(0.0032) * U_21_zx - f_u_22_t_y;
  const Scalar t819 = c_20 * f_20_y - s_20 * f_20_x;
  const Scalar f_20_z = Scalar(1.661) * U_20_zy + t816;
  const Scalar t820 = (c_26 * t818 - s_26 * f_27_z) - (c_19 * t819 - s_19 * f_20_z);
  const Scalar t821 = Scalar(1.4178414000000004) * omega_r_26_y * omega_26_z + c_27 * mu_27_y +
      s_27 * t765;
  const Scalar t822 = Scalar(1.4178414000000004) * omega_r_19_y * omega_19_z + c_20 * mu_20_y +
      s_20 * t817;
  const Scalar mu_26_y = t762 + t763 - Scalar(0.7099007000000002) * omega_r_26_x * omega_26_z;
  const Scalar mu_19_y = t814 + t815 - Scalar(0.7099007000000002) * omega_r_19_x * omega_19_z;
  const Scalar f_u_27_t_y = c_27 * f_27_x + s_27 * f_27_y;
  const Scalar f_u_20_t_y = c_20 * f_20_x + s_20 * f_20_y;
  const Scalar t823 = c_16 * omega_r_15_y - s_16 * omega_15_z;
  const Scalar omega_16_z = qd_16 + t692;
  const Scalar omega_r_17_x = c_17 * omega_16_z - s_17 * t823;
  const Scalar omega_r_16_y = c_16 * omega_15_z + s_16 * omega_r_15_y;
  const Scalar omega_17_z = qd_17 + omega_r_16_y;
  const Scalar t824 = c_18 * omega_17_z - s_18 * omega_r_17_x;
  const Scalar omega_r_18_y = c_18 * omega_r_17_x + s_18 * omega_17_z;
  const Scalar t825 = t824 * omega_r_18_y;
  const Scalar domega_16_x = c_16 * domega_15_y - s_16 * t708 + qd_16 * omega_r_16_y;
  const Scalar t826 = c_17 * domega_16_x + s_17 * domega_15_x - qd_17 * omega_r_17_x;
  const Scalar omega_r_17_y = c_17 * t823 + s_17 * omega_16_z;
  const Scalar omega_18_z = qd_18 + omega_r_17_y;
  const Scalar t827 = omega_18_z * omega_18_z;
  const Scalar U_18_yy = t827 + t824 * t824;
  const Scalar t828 = Scalar(0.02) * (t826 + t825) - Scalar(0.22) * U_18_yy;
  const Scalar U_18_xx = omega_r_18_y * omega_r_18_y + t827;
  const Scalar F_18_x = Scalar(0.02) * U_18_xx + Scalar(0.22) * (t826 - t825);
  const Scalar f_u_18_t_x = c_18 * t828 + s_18 * F_18_x;
  const Scalar domega_17_x = c_17 * domega_15_x - s_17 * domega_16_x + qd_17 * omega_r_17_y;
  const Scalar domega_16_y = c_16 * t708 + s_16 * domega_15_y - qd_16 * t823;
  const Scalar domega_18_y = c_18 * domega_17_x + s_18 * domega_16_y - qd_18 * t824;
  const Scalar t829 = t824 * omega_18_z;
  const Scalar U_18_zx = domega_18_y - t829;
  const Scalar U_18_zy = c_18 * domega_16_y - s_18 * domega_17_x +
      omega_r_18_y * (qd_18 + omega_18_z);
  const Scalar F_18_z = Scalar(0.02) * U_18_zx - Scalar(0.22) * U_18_zy;
  const Scalar f_u_17_t_x = c_17 * F_18_z + s_17 * f_u_18_t_x;
  const Scalar f_u_18_t_y = c_18 * F_18_x - s_18 * t828;
  const Scalar f_u_16_t_x = c_16 * f_u_17_t_x + s_16 * f_u_18_t_y;
  const Scalar U_15_yz = domega_15_x - t700;
  const Scalar t830 = Scalar(0.453) * t712 + Scalar(0.003) * U_15_yz + t713;
  const Scalar U_15_zz = t703 + t715;
  const Scalar ddp_o_16_z = Scalar(0.453) * U_15_zx - Scalar(0.003) * U_15_zz + t697;
  const Scalar ddp_16_x = c_16 * t830 + s_16 * ddp_o_16_z;
  const Scalar U_15_xz = domega_15_y + t696;
  const Scalar t831 = Scalar(0.453) * U_15_xx + Scalar(0.003) * U_15_xz - t705;
  const Scalar t832 = c_17 * t831 + s_17 * ddp_16_x;
  const Scalar ddp_16_y = c_16 * ddp_o_16_z - s_16 * t830;
  const Scalar t833 = c_18 * ddp_16_y - s_18 * t832;
  const Scalar t834 = c_18 * t832 + s_18 * ddp_16_y;
  const Scalar U_18_xx_yy = U_18_xx - U_18_yy;
  const Scalar t835 = Scalar(0.03408) * t826 + Scalar(0.22) * t833 - Scalar(0.02) * t834 -
      Scalar(0.024) * t825 + Scalar(0.0022) * U_18_xx_yy;
  const Scalar t836 = Scalar(0.03388) * t826 - t835 + Scalar(0.03438) * omega_r_17_x * omega_17_z;
  const Scalar t837 = c_17 * ddp_16_x - s_17 * t831;
  const Scalar t838 = Scalar(0.22) * t837 - Scalar(0.0022) * U_18_zx +
      Scalar(0.05808) * omega_r_18_y * omega_18_z;
  const Scalar t839 = Scalar(0.02) * t837 + Scalar(0.024) * domega_18_y + Scalar(0.03408) * t829 +
      Scalar(0.0022) * U_18_zy;
  const Scalar mu_17_x = Scalar(0.06826) * omega_r_17_y * omega_17_z - c_18 * t839 - s_18 * t838;
  const Scalar t840 = Scalar(0.069385) * omega_r_16_y * omega_16_z - c_17 * t836 - s_17 * mu_17_x;
  const Scalar t841 = Scalar(0.03438) * domega_16_y;
  const Scalar t842 = Scalar(0.03388) * omega_r_17_x * omega_r_17_y - c_18 * t838 + s_18 * t839 -
      t841;
  const Scalar mu_16_y = t841 + t842 + Scalar(0.035005) * t823 * omega_16_z;
  const Scalar t843 = Scalar(89.72226) * t699 + Scalar(5.512820899999667) * t708 +
      Scalar(0.5912714333326666) * t707 - Scalar(0.043998) * U_15_yz - Scalar(0.453) * f_u_16_t_x -
      Scalar(0.24) * t820 - Scalar(0.33) * (f_u_27_t_y + f_u_20_t_y) - c_26 * mu_26_y -
      s_26 * t821 - c_19 * mu_19_y - s_19 * t822 - c_16 * mu_16_y - s_16 * t840;
  const Scalar t844 = y_32 * t426 - y_25 * t534;
  const Scalar mu_16_z = Scalar(0.035005) * domega_15_x - Scalar(0.03438) * t823 * omega_r_16_y +
      c_17 * mu_17_x - s_17 * t836;
  const Scalar y_17 = tau_17 - t842;
  const Scalar y_18 = tau_18 + t835;
  const Scalar y_17_16 = tau_16 + mu_16_z - s_17 * y_18 - y_17 * t620;
  const Scalar y_16_15 = tau_15 + t843 + Scalar(707.7641729774637) * t844 - t612 * y_32_31 -
      t610 * y_31_30 + t608 * y_30_29 - t606 * y_29_28 - t604 * y_28_27 - t495 * y_27_26 -
      t613 * y_25_24 + t611 * y_24_23 + t609 * y_23_22 - t607 * y_22_21 - t605 * y_21_20 -
      t603 * y_20_19 + y_18 * t631 - y_17 * t630 + t629 * y_17_16;
  const Scalar t845 = c_26 * f_27_z + s_26 * t818;
  const Scalar t846 = c_19 * f_20_z + s_19 * t819;
  const Scalar t847 = c_16 * f_u_18_t_y - s_16 * f_u_17_t_x;
  const Scalar t848 = c_17 * f_u_18_t_x - s_17 * F_18_z;
  const Scalar U_15_zz_xx = U_15_xx - U_15_zz;
  const Scalar mu_15_y = Scalar(89.72226) * s_14 + Scalar(0.5912714333326666) * domega_15_y -
      Scalar(5.512820899999667) * t696 - Scalar(0.043998) * U_15_zz_xx + mu_26_z + mu_19_z -
      Scalar(0.003) * t848 + Scalar(0.453) * t847 - Scalar(0.33) * (t845 + t846) + c_16 * t840 -
      s_16 * mu_16_y;
  const Scalar t849 = Scalar(0.043998) * t712 - Scalar(4.921549466667001) * t700 - mu_16_z +
      Scalar(0.003) * f_u_16_t_x - Scalar(0.24) * (t845 - t846) + c_26 * t821 - s_26 * mu_26_y +
      c_19 * t822 - s_19 * mu_19_y;
  const Scalar t850 = y_32 * t633 - y_25 * mu_u_25_15_t_y;
  const Scalar t851 = c_14 * (qd_13 * t695 - Scalar(0.7479551597079861));
  const Scalar y_15_14 = tau_14 + Scalar(707.7641729774637) * t850 + c_15 * mu_15_y + s_15 * t849 +
      t662 * y_32_31 + t660 * y_31_30 - t658 * y_30_29 - t656 * y_29_28 + t654 * y_28_27 -
      t652 * y_27_26 + t663 * y_25_24 + t661 * y_24_23 + t659 * y_23_22 - t657 * y_22_21 -
      t655 * y_21_20 - t653 * y_20_19 + y_18 * t667 - y_17 * t666 - t665 * y_17_16 +
      t651 * y_16_15 - Scalar(2.5051100666670005) * t851;
  const Scalar t852 = c_14 * (Scalar(5.012670133334001) * t694 - c_15 * t849 + s_15 * mu_15_y);
  const Scalar mu_14_y = Scalar(0.00245) * t708 + t843;
  const Scalar t853 = y_32 * mu_u_32_14_t_y + y_25 * t535;
  const Scalar y_14_13 = tau_13 + Scalar(707.7641729774637) * t853 + t852 - s_14 * mu_14_y +
      t684 * y_32_31 + t682 * y_31_30 + t680 * y_30_29 - t678 * y_29_28 + t676 * y_28_27 +
      t674 * y_27_26 - t685 * y_25_24 - t683 * y_24_23 - t681 * y_23_22 + t679 * y_22_21 -
      t677 * y_21_20 - t675 * y_20_19 - y_18 * t689 - y_17 * t688 - t687 * y_17_16 -
      t673 * y_16_15 - t672 * y_15_14;
  const Scalar t854 = (Scalar(1.0) / t690) * y_14_13;
  qdd[12] = -t854;
  const Scalar t855 = t671 * (y_15_14 - t668 * t854);
  qdd[13] = -t855;
  const Scalar qdd_15 = t650 * ((y_16_15 - b_16_15_14 * t855) + t632 * t854);
  qdd[14] = qdd_15;
  const Scalar qdd_16 = t627 * ((t648 * t855 + t625 * t854) + (y_17_16 + t628 * qdd_15));
  qdd[15] = qdd_16;
  const Scalar qdd_19 = t602 * ((t644 * t855 + t597 * t854) - (y_20_19 + t600 * qdd_15));
  qdd[18] = qdd_19;
  const Scalar qdd_26 = t494 * ((t639 * t855 - t488 * t854) - (y_27_26 + t492 * qdd_15));
  qdd[25] = qdd_26;
  const Scalar t856 = (t647 * t855 - mu_u_18_14_t_y * t854) - (y_18 + mu_18_15_z * qdd_15);
  qdd[17] = Scalar(-29.342723004694836) * t856 - s_17 * qdd_16;
  const Scalar t857 = (y_17 + c_17 * Iu_18_t_xy * qdd_16) - t618 * t854;
  qdd[16] = -d_17 * (t857 + (t617 * qdd_15 - t646 * t855));
  const Scalar t858 = (y_21_20 + t588 * qdd_19) - t584 * t854;
  const Scalar t859 = t590 * (t858 + (b_21_20_15 * qdd_15 - t643 * t855));
  qdd[19] = -t859;
  const Scalar t860 = (y_28_27 - b_28_27_26 * qdd_26) + t475 * t854;
  const Scalar t861 = t481 * (t860 + (b_28_27_15 * qdd_15 + t638 * t855));
  qdd[26] = -t861;
  const Scalar t862 = (t587 * qdd_19 + b_22_21_15 * qdd_15) - (y_22_21 - t576 * t859);
  const Scalar t863 = t578 * (t862 - (t642 * t855 - t573 * t854));
  qdd[20] = -t863;
  const Scalar t864 = (t479 * qdd_26 + t491 * qdd_15) - (y_29_28 + t469 * t861);
  const Scalar t865 = d_28 * (t864 - (t637 * t855 + t466 * t854));
  qdd[27] = -t865;
  const Scalar t866 = (b_23_22_15 * qdd_15 - t641 * t855) - (t575 * t859 - t586 * qdd_19);
  const Scalar qdd_22 = t568 * (t866 - ((y_23_22 + t566 * t863) - t565 * t854));
  qdd[21] = qdd_22;
  const Scalar t867 = (b_30_29_15 * qdd_15 + t636 * t855) + (t468 * t861 - t478 * qdd_26);
  const Scalar qdd_29 = t459 * (t867 - ((y_30_29 + t457 * t865) + t455 * t854));
  qdd[28] = qdd_29;
  const Scalar t868 = (t640 * t855 - t559 * t854) - (b_24_23_19 * qdd_19 + t599 * qdd_15);
  const Scalar t869 = t868 - ((b_24_23_21 * t863 + t574 * t859) - (y_24_23 - t560 * qdd_22));
  const Scalar t870 = d_23 * t869;
  qdd[22] = -t870;
  const Scalar t871 = (t635 * t855 + t451 * t854) - (t477 * qdd_26 - t490 * qdd_15);
  const Scalar t872 = t871 - ((t456 * t865 - t467 * t861) - (y_31_30 - b_31_30_29 * qdd_29));
  const Scalar t873 = d_30 * t872;
  qdd[29] = -t873;
  const Scalar t874 = (y_25_24 - b_25_24_23 * t870) - t551 * t854;
  const Scalar t875 = (b_25_24_20 * t859 - t585 * qdd_19) -
      (b_25_24_22 * qdd_22 - b_25_24_21 * t863);
  const Scalar t876 = t553 * ((t874 + (t598 * qdd_15 + b_25_24_14 * t855)) + t875);
  qdd[23] = -t876;
  const Scalar t877 = (y_32_31 + t445 * t873) + b_32_31_13 * t854;
  const Scalar t878 = (b_32_31_27 * t861 - t476 * qdd_26) -
      (b_32_31_29 * qdd_29 - b_32_31_28 * t865);
  const Scalar t879 = t444 * ((t877 + (t489 * qdd_15 + t634 * t855)) + t878);
  qdd[30] = -t879;
  const Scalar t880 = (y_25 + mu_u_25_24_t_y * t870) - t535 * t854;
  const Scalar t881 = (mu_25_20_z * t859 + mu_u_25_20_t_y * qdd_19) -
      (mu_25_22_z * qdd_22 - mu_25_21_z * t863);
  const Scalar t882 = (t880 - (t534 * qdd_15 - mu_u_25_15_t_y * t855)) - t881;
  qdd[24] = Scalar(707.7641729774637) * t882 - t536 * t876;
  const Scalar t883 = (y_32 + mu_u_32_31_t_y * t873) - mu_u_32_14_t_y * t854;
  const Scalar t884 = (mu_32_27_z * t861 + mu_u_32_27_t_y * qdd_26) -
      (mu_32_29_z * qdd_29 - mu_32_28_z * t865);
  const Scalar t885 = (t883 + (t426 * qdd_15 - t633 * t855)) + t884;
  qdd[31] = Scalar(707.7641729774637) * t885 + t427 * t879;
  bool positive = -t111 > Scalar(0.0);
  positive &= b_3_2_2 > Scalar(0.0);
  positive &= -t83 > Scalar(0.0);
  positive &= -t57 > Scalar(0.0);
  positive &= Ic_5_zz > Scalar(0.0);
  positive &= -t223 > Scalar(0.0);
  positive &= b_9_8_8 > Scalar(0.0);
  positive &= -t195 > Scalar(0.0);
  positive &= -t169 > Scalar(0.0);
  positive &= Ic_11_zz > Scalar(0.0);
  positive &= -t690 > Scalar(0.0);
  positive &= -t670 > Scalar(0.0);
  positive &= b_16_15_15 > Scalar(0.0);
  positive &= b_17_16_16 > Scalar(0.0);
  positive &= -Ic_17_zz > Scalar(0.0);
  positive &= -t601 > Scalar(0.0);
  positive &= -t589 > Scalar(0.0);
  positive &= t577 > Scalar(0.0);
  positive &= -t567 > Scalar(0.0);
  positive &= -b_24_23_23 > Scalar(0.0);
  positive &= -t552 > Scalar(0.0);
  positive &= -t493 > Scalar(0.0);
  positive &= -t480 > Scalar(0.0);
  positive &= b_29_28_28 > Scalar(0.0);
  positive &= -t458 > Scalar(0.0);
  positive &= -b_31_30_30 > Scalar(0.0);
  positive &= -t443 > Scalar(0.0);
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

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
// Every function is a template over its scalar: float, double, or any type that is made from a
// double, has + - * / (also - of one), comparisons, and sin, cos where argument-dependent lookup
// finds them (or an argument that knows them, see LibrarySinCos). Arguments are plain arrays:
//
//   double q[32] = {}, qd[32] = {}, qdd[32] = {}, tau[32];
//   humanoid32::inverse_dynamics(q, qd, qdd, tau);
//
// Entries come in the order of the table. Units are SI; "rad or m" goes by the type of the joint.
// Every entry of an output is written, zeros too. All inputs are read before anything is written:
// an output may overlap an input, but outputs must not overlap each other. Nothing allocates,
// throws, or keeps state. In the code, names count from 1 as in the textbook: q_1 is q[0], s_1 its
// sine, c_1 its cosine. Of link i: omega_i and domega_i are its angular velocity and acceleration,
// ddp_i the acceleration of its frame's origin less gravity, f_i and mu_i the force and moment that
// it gets from the link before, hc_i and hu_i the first moment of all that its joint carries (in
// gravity() times the size of gravity); t1, t2, ... are parts of sums.

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
//   q[32]    in   joint positions, rad or m
//   qd[32]   in   joint velocities, rad/s or m/s
//   qdd[32]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[32]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11], q[13..31], qd[0..31], qdd[0..31]. Operations: 1143 mul, 868 add, 62 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
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
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6], s_8 = sine[7],
      c_8 = cosine[7], s_9 = sine[8], c_9 = cosine[8], s_10 = sine[9], c_10 = cosine[9],
      s_11 = sine[10], c_11 = cosine[10], s_12 = sine[11], c_12 = cosine[11], s_14 = sine[13],
      c_14 = cosine[13], s_15 = sine[14], c_15 = cosine[14], s_16 = sine[15], c_16 = cosine[15],
      s_17 = sine[16], c_17 = cosine[16], s_18 = sine[17], c_18 = cosine[17], s_19 = sine[18],
      c_19 = cosine[18], s_20 = sine[19], c_20 = cosine[19], s_21 = sine[20], c_21 = cosine[20],
      s_22 = sine[21], c_22 = cosine[21], s_23 = sine[22], c_23 = cosine[22], s_24 = sine[23],
      c_24 = cosine[23], s_25 = sine[24], c_25 = cosine[24], s_26 = sine[25], c_26 = cosine[25],
      s_27 = sine[26], c_27 = cosine[26], s_28 = sine[27], c_28 = cosine[27], s_29 = sine[28],
      c_29 = cosine[28], s_30 = sine[29], c_30 = cosine[29], s_31 = sine[30], c_31 = cosine[30],
      s_32 = sine[31], c_32 = cosine[31];
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
  const Scalar t11 = t9 + t10;
  const Scalar t12 = Scalar(9.81) * s_14;
  const Scalar ddp_16_a_y = Scalar(0.453) * t8 - Scalar(0.003) * t11 + t12;
  const Scalar t13 = qd_15 * omega_r_15_y + s_15 * qdd_14 + c_15 * t5;
  const Scalar t14 = omega_r_15_y * omega_15_z;
  const Scalar t15 = t13 - t14;
  const Scalar t16 = t2 * omega_r_15_y;
  const Scalar t17 = qd_14 * t1;
  const Scalar domega_15_z = -t17 - s_14 * qdd_13 + qdd_15;
  const Scalar U_15_yx = t16 + domega_15_z;
  const Scalar t18 = c_14 * s_15;
  const Scalar t19 = Scalar(9.81) * t18;
  const Scalar t20 = Scalar(0.453) * U_15_yx - Scalar(0.003) * t15 - t19;
  const Scalar t21 = s_16 * ddp_16_a_y - c_16 * t20;
  const Scalar t22 = omega_15_z * omega_15_z;
  const Scalar t23 = t9 + t22;
  const Scalar t24 = Scalar(9.81) * c_14 * c_15;
  const Scalar t25 = Scalar(0.003) * (t6 - t7) + Scalar(0.453) * t23 - t24;
  const Scalar t26 = s_17 * t21 + c_17 * t25;
  const Scalar ddp_16_y = s_16 * t20 + c_16 * ddp_16_a_y;
  const Scalar t27 = s_18 * t26 - c_18 * ddp_16_y;
  const Scalar t28 = s_18 * ddp_16_y + c_18 * t26;
  const Scalar t29 = s_16 * omega_15_z - c_16 * omega_r_15_y;
  const Scalar omega_16_z = qd_16 - t2;
  const Scalar t30 = s_17 * t29 + c_17 * omega_16_z;
  const Scalar omega_r_17_a_z = s_16 * omega_r_15_y + c_16 * omega_15_z;
  const Scalar omega_17_z = qd_17 + omega_r_17_a_z;
  const Scalar t31 = s_18 * omega_17_z + c_18 * t30;
  const Scalar omega_r_17_y = s_17 * omega_16_z - c_17 * t29;
  const Scalar omega_18_z = qd_18 + omega_r_17_y;
  const Scalar t32 = omega_18_z * omega_18_z;
  const Scalar t33 = t31 * t31 + t32;
  const Scalar t34 = s_18 * t30 - c_18 * omega_17_z;
  const Scalar t35 = t34 * t34 + t32;
  const Scalar t36 = t34 * t31;
  const Scalar t37 = qd_16 * omega_r_17_a_z + s_16 * domega_15_z + c_16 * t6;
  const Scalar domega_16_z = qdd_16 - t13;
  const Scalar domega_18_z = qdd_18 + qd_17 * t30 + s_17 * domega_16_z - c_17 * t37;
  const Scalar tau_18 = Scalar(0.02) * t28 - Scalar(0.0022) * (t33 - t35) - Scalar(0.024) * t36 +
      Scalar(0.03408) * domega_18_z + Scalar(0.22) * t27;
  tau[17] = tau_18;
  const Scalar t38 = s_2 * qd_1;
  const Scalar t39 = qd_2 * t38;
  const Scalar t40 = t39 - c_2 * qdd_1;
  const Scalar ddp_3_a_y = Scalar(9.81) * s_1 - Scalar(0.389) * (t39 + t40);
  const Scalar t41 = c_2 * qd_1;
  const Scalar t42 = t38 * t41;
  const Scalar t43 = Scalar(9.81) * c_1;
  const Scalar ddp_o_3_x = Scalar(0.389) * (t42 + qdd_2) + s_2 * t43;
  const Scalar ddp_3_y = s_3 * ddp_3_a_y + c_3 * ddp_o_3_x;
  const Scalar omega_r_3_x = s_3 * t41 + c_3 * qd_2;
  const Scalar t44 = s_3 * qd_2 - c_3 * t41;
  const Scalar t45 = omega_r_3_x * t44;
  const Scalar t46 = qd_2 * t41;
  const Scalar domega_3_z = -t46 - s_2 * qdd_1 + qdd_3;
  const Scalar U_3_yx = domega_3_z - t45;
  const Scalar ddp_o_4_y = ddp_3_y - Scalar(0.02) * U_3_yx;
  const Scalar omega_3_z = qd_3 - t38;
  const Scalar t47 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar t48 = qd_3 * t44 + s_3 * t40 - c_3 * qdd_2;
  const Scalar t49 = qd_4 * t47 + s_4 * t48 - c_4 * domega_3_z;
  const Scalar omega_4_z = qd_4 - t44;
  const Scalar t50 = t47 * omega_4_z;
  const Scalar t51 = t49 + t50;
  const Scalar t52 = ddp_o_4_y - Scalar(0.04) * t51;
  const Scalar t53 = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar t54 = qd_4 * t53 + s_4 * domega_3_z + c_4 * t48;
  const Scalar t55 = t53 * omega_4_z;
  const Scalar t56 = t54 + t55;
  const Scalar t57 = Scalar(0.357) * t56 - t52;
  const Scalar t58 = omega_3_z * omega_3_z;
  const Scalar t59 = t44 * t44 + t58;
  const Scalar t60 = Scalar(0.02) * t59 + s_3 * ddp_o_3_x - c_3 * ddp_3_a_y;
  const Scalar t61 = qd_3 * omega_r_3_x + s_3 * qdd_2 + c_3 * t40;
  const Scalar t62 = omega_r_3_x * omega_3_z;
  const Scalar ddp_o_3_y = Scalar(0.389) * (t41 * t41 + qd_2 * qd_2) + c_2 * t43;
  const Scalar ddp_o_4_z = ddp_o_3_y - Scalar(0.02) * (t61 + t62);
  const Scalar t63 = s_4 * t60 + c_4 * ddp_o_4_z;
  const Scalar t64 = omega_4_z * omega_4_z;
  const Scalar t65 = t64 + t47 * t47;
  const Scalar domega_4_z = qdd_4 - t61;
  const Scalar t66 = t53 * t47;
  const Scalar t67 = domega_4_z + t66;
  const Scalar t68 = t63 - Scalar(0.04) * t67 + Scalar(0.357) * t65;
  const Scalar t69 = s_5 * t57 + c_5 * t68;
  const Scalar t70 = s_4 * ddp_o_4_z - c_4 * t60;
  const Scalar U_4_yx = domega_4_z - t66;
  const Scalar t71 = t64 + t53 * t53;
  const Scalar t72 = Scalar(0.04) * t71 + t70 + Scalar(0.357) * U_4_yx;
  const Scalar t73 = s_6 * t69 + c_6 * t72;
  const Scalar t74 = s_6 * t72 - c_6 * t69;
  const Scalar t75 = s_5 * omega_4_z - c_5 * t53;
  const Scalar omega_5_z = qd_5 - t47;
  const Scalar t76 = s_6 * omega_5_z - c_6 * t75;
  const Scalar omega_r_5_y = s_5 * t53 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t77 = omega_6_z * omega_6_z;
  const Scalar t78 = t76 * t76 + t77;
  const Scalar omega_r_6_x = s_6 * t75 + c_6 * omega_5_z;
  const Scalar t79 = omega_r_6_x * omega_r_6_x + t77;
  const Scalar t80 = omega_r_6_x * t76;
  const Scalar domega_6_z = qdd_6 - qd_5 * t75 - s_5 * t49 + c_5 * domega_4_z;
  const Scalar N_6_z = Scalar(0.0012) * t80 + Scalar(0.00315) * (t78 - t79) + Scalar(0.045) * t74 +
      Scalar(0.01431666666667) * domega_6_z + Scalar(0.105) * t73;
  tau[5] = N_6_z;
  const Scalar t81 = s_8 * qd_7;
  const Scalar t82 = qd_8 * t81;
  const Scalar t83 = t82 - c_8 * qdd_7;
  const Scalar ddp_9_a_y = Scalar(9.81) * s_7 - Scalar(0.389) * (t82 + t83);
  const Scalar t84 = c_8 * qd_7;
  const Scalar t85 = t81 * t84;
  const Scalar t86 = Scalar(9.81) * c_7;
  const Scalar ddp_o_9_x = Scalar(0.389) * (t85 + qdd_8) + s_8 * t86;
  const Scalar ddp_9_y = s_9 * ddp_9_a_y + c_9 * ddp_o_9_x;
  const Scalar omega_r_9_x = s_9 * t84 + c_9 * qd_8;
  const Scalar t87 = s_9 * qd_8 - c_9 * t84;
  const Scalar t88 = omega_r_9_x * t87;
  const Scalar t89 = qd_8 * t84;
  const Scalar domega_9_z = -t89 - s_8 * qdd_7 + qdd_9;
  const Scalar U_9_yx = domega_9_z - t88;
  const Scalar ddp_o_10_y = ddp_9_y - Scalar(0.02) * U_9_yx;
  const Scalar omega_9_z = qd_9 - t81;
  const Scalar t90 = s_10 * omega_9_z - c_10 * omega_r_9_x;
  const Scalar t91 = qd_9 * t87 + s_9 * t83 - c_9 * qdd_8;
  const Scalar t92 = qd_10 * t90 + s_10 * t91 - c_10 * domega_9_z;
  const Scalar omega_10_z = qd_10 - t87;
  const Scalar t93 = t90 * omega_10_z;
  const Scalar t94 = t92 + t93;
  const Scalar t95 = ddp_o_10_y - Scalar(0.04) * t94;
  const Scalar t96 = s_10 * omega_r_9_x + c_10 * omega_9_z;
  const Scalar t97 = qd_10 * t96 + s_10 * domega_9_z + c_10 * t91;
  const Scalar t98 = t96 * omega_10_z;
  const Scalar t99 = t97 + t98;
  const Scalar t100 = Scalar(0.357) * t99 - t95;
  const Scalar t101 = omega_9_z * omega_9_z;
  const Scalar t102 = t87 * t87 + t101;
  const Scalar t103 = Scalar(0.02) * t102 + s_9 * ddp_o_9_x - c_9 * ddp_9_a_y;
  const Scalar t104 = qd_9 * omega_r_9_x + s_9 * qdd_8 + c_9 * t83;
  const Scalar t105 = omega_r_9_x * omega_9_z;
  const Scalar ddp_o_9_y = Scalar(0.389) * (t84 * t84 + qd_8 * qd_8) + c_8 * t86;
  const Scalar ddp_o_10_z = ddp_o_9_y - Scalar(0.02) * (t104 + t105);
  const Scalar t106 = s_10 * t103 + c_10 * ddp_o_10_z;
  const Scalar t107 = omega_10_z * omega_10_z;
  const Scalar t108 = t107 + t90 * t90;
  const Scalar domega_10_z = qdd_10 - t104;
  const Scalar t109 = t96 * t90;
  const Scalar t110 = domega_10_z + t109;
  const Scalar t111 = t106 - Scalar(0.04) * t110 + Scalar(0.357) * t108;
  const Scalar t112 = s_11 * t100 + c_11 * t111;
  const Scalar t113 = s_10 * ddp_o_10_z - c_10 * t103;
  const Scalar U_10_yx = domega_10_z - t109;
  const Scalar t114 = t107 + t96 * t96;
  const Scalar t115 = Scalar(0.04) * t114 + t113 + Scalar(0.357) * U_10_yx;
  const Scalar t116 = s_12 * t112 + c_12 * t115;
  const Scalar t117 = s_12 * t115 - c_12 * t112;
  const Scalar t118 = s_11 * omega_10_z - c_11 * t96;
  const Scalar omega_11_z = qd_11 - t90;
  const Scalar t119 = s_12 * omega_11_z - c_12 * t118;
  const Scalar omega_r_11_y = s_11 * t96 + c_11 * omega_10_z;
  const Scalar omega_12_z = qd_12 + omega_r_11_y;
  const Scalar t120 = omega_12_z * omega_12_z;
  const Scalar t121 = t119 * t119 + t120;
  const Scalar omega_r_12_x = s_12 * t118 + c_12 * omega_11_z;
  const Scalar t122 = omega_r_12_x * omega_r_12_x + t120;
  const Scalar t123 = omega_r_12_x * t119;
  const Scalar domega_12_z = qdd_12 - qd_11 * t118 - s_11 * t92 + c_11 * domega_10_z;
  const Scalar N_12_z = Scalar(0.0012) * t123 + Scalar(0.00315) * (t121 - t122) +
      Scalar(0.045) * t117 + Scalar(0.01431666666667) * domega_12_z + Scalar(0.105) * t116;
  tau[11] = N_12_z;
  const Scalar t124 = qd_17 * omega_r_17_y - s_17 * t37 - c_17 * domega_16_z;
  const Scalar domega_17_z = qdd_17 - qd_16 * t29 - s_16 * t6 + c_16 * domega_15_z;
  const Scalar t125 = qd_18 * t31 - s_18 * t124 - c_18 * domega_17_z;
  const Scalar t126 = t31 * omega_18_z;
  const Scalar t127 = t125 + t126;
  const Scalar t128 = s_17 * t25 - c_17 * t21;
  const Scalar t129 = t34 * omega_18_z;
  const Scalar t130 = Scalar(0.02) * t128 - Scalar(0.0022) * t127 + Scalar(0.01008) * t129;
  const Scalar t131 = qd_18 * t34 - s_18 * domega_17_z + c_18 * t124 + t129;
  const Scalar t132 = Scalar(0.0022) * t131 - Scalar(0.024) * t125 - Scalar(0.03408) * t126 +
      Scalar(0.22) * t128;
  const Scalar mu_17_z = Scalar(0.00988) * t30 * omega_r_17_y + Scalar(0.01038) * domega_17_z -
      s_18 * t130 + c_18 * t132;
  tau[16] = mu_17_z;
  const Scalar ddp_11_y = s_11 * t111 - c_11 * t100;
  const Scalar t133 = qd_11 * omega_r_11_y + s_11 * domega_10_z + c_11 * t92;
  const Scalar domega_11_z = qdd_11 - t97;
  const Scalar t134 = qd_12 * t119 - s_12 * t133 - c_12 * domega_11_z;
  const Scalar t135 = t119 * omega_12_z;
  const Scalar t136 = t134 + t135;
  const Scalar t137 = omega_r_12_x * omega_12_z;
  const Scalar t138 = Scalar(0.01311666666667) * t137 - Scalar(0.00315) * t136 +
      Scalar(0.045) * ddp_11_y;
  const Scalar U_12_zx = qd_12 * omega_r_12_x + s_12 * domega_11_z - c_12 * t133 + t137;
  const Scalar N_12_x = Scalar(0.00315) * U_12_zx - Scalar(0.0012) * t134 -
      Scalar(0.01431666666667) * t135 + Scalar(0.105) * ddp_11_y;
  const Scalar mu_11_z = Scalar(0.00820666666667) * domega_11_z -
      Scalar(0.00756666666667) * t118 * omega_r_11_y + s_12 * t138 + c_12 * N_12_x;
  tau[10] = mu_11_z;
  const Scalar ddp_5_y = s_5 * t68 - c_5 * t57;
  const Scalar t139 = qd_5 * omega_r_5_y + s_5 * domega_4_z + c_5 * t49;
  const Scalar domega_5_z = qdd_5 - t54;
  const Scalar t140 = qd_6 * t76 - s_6 * t139 - c_6 * domega_5_z;
  const Scalar t141 = t76 * omega_6_z;
  const Scalar t142 = t140 + t141;
  const Scalar t143 = omega_r_6_x * omega_6_z;
  const Scalar t144 = Scalar(0.01311666666667) * t143 - Scalar(0.00315) * t142 +
      Scalar(0.045) * ddp_5_y;
  const Scalar U_6_zx = qd_6 * omega_r_6_x + s_6 * domega_5_z - c_6 * t139 + t143;
  const Scalar N_6_x = Scalar(0.00315) * U_6_zx - Scalar(0.0012) * t140 -
      Scalar(0.01431666666667) * t141 + Scalar(0.105) * ddp_5_y;
  const Scalar mu_5_z = Scalar(0.00820666666667) * domega_5_z -
      Scalar(0.00756666666667) * t75 * omega_r_5_y + s_6 * t144 + c_6 * N_6_x;
  tau[4] = mu_5_z;
  const Scalar t145 = Scalar(0.0005) * t30 * omega_17_z + tau_18;
  const Scalar t146 = Scalar(0.00988) * t124 + c_18 * t130 +
      Scalar(0.01038) * omega_r_17_y * omega_17_z + s_18 * t132;
  const Scalar mu_16_z = Scalar(0.001125) * domega_16_z - Scalar(0.0005) * t29 * omega_r_17_a_z +
      s_17 * t145 - c_17 * t146;
  tau[15] = mu_16_z;
  const Scalar t147 = N_12_z - Scalar(0.00064) * t118 * omega_11_z;
  const Scalar t148 = Scalar(0.045) * t121 + Scalar(0.105) * (t123 + domega_12_z);
  const Scalar U_12_yx = domega_12_z - t123;
  const Scalar F_12_y = Scalar(0.045) * U_12_yx - Scalar(0.105) * t122;
  const Scalar t149 = s_12 * t148 - c_12 * F_12_y;
  const Scalar F_12_z = Scalar(0.045) * U_12_zx - Scalar(0.105) * t136;
  const Scalar t150 = s_11 * F_12_z + c_11 * t149;
  const Scalar t151 = Scalar(0.00756666666667) * t133 +
      Scalar(0.00820666666667) * omega_r_11_y * omega_11_z - c_12 * t138 + s_12 * N_12_x;
  const Scalar f_u_12_t_y = s_12 * F_12_y + c_12 * t148;
  const Scalar t152 = Scalar(0.04) * t150 - s_11 * t151 - c_11 * t147 + Scalar(0.22) * t106 +
      Scalar(0.0549) * (t108 - t114) - Scalar(0.357) * f_u_12_t_y -
      Scalar(0.4393875) * domega_10_z + Scalar(0.4092575) * t109 - Scalar(1.3725) * t113;
  tau[9] = -t152;
  const Scalar t153 = N_6_z - Scalar(0.00064) * t75 * omega_5_z;
  const Scalar t154 = Scalar(0.045) * t78 + Scalar(0.105) * (t80 + domega_6_z);
  const Scalar U_6_yx = domega_6_z - t80;
  const Scalar F_6_y = Scalar(0.045) * U_6_yx - Scalar(0.105) * t79;
  const Scalar t155 = s_6 * t154 - c_6 * F_6_y;
  const Scalar F_6_z = Scalar(0.045) * U_6_zx - Scalar(0.105) * t142;
  const Scalar t156 = s_5 * F_6_z + c_5 * t155;
  const Scalar t157 = Scalar(0.00756666666667) * t139 +
      Scalar(0.00820666666667) * omega_r_5_y * omega_5_z - c_6 * t144 + s_6 * N_6_x;
  const Scalar f_u_6_t_y = s_6 * F_6_y + c_6 * t154;
  const Scalar t158 = Scalar(0.04) * t156 - s_5 * t157 - c_5 * t153 + Scalar(0.22) * t63 +
      Scalar(0.0549) * (t65 - t71) - Scalar(0.357) * f_u_6_t_y - Scalar(0.4393875) * domega_4_z +
      Scalar(0.4092575) * t66 - Scalar(1.3725) * t70;
  tau[3] = -t158;
  const Scalar t159 = s_11 * t149 - c_11 * F_12_z;
  const Scalar t160 = t159 + Scalar(1.3725) * t99;
  const Scalar t161 = s_11 * t147 - c_11 * t151 + Scalar(0.22) * ddp_o_10_y - Scalar(0.04) * t160 +
      Scalar(0.4092575) * t92 - Scalar(0.4393875) * t93;
  const Scalar t162 = Scalar(0.22) * t94 + t160;
  const Scalar t163 = Scalar(0.357) * t159 - mu_11_z + Scalar(0.848645) * t98 -
      Scalar(1.3725) * t95;
  const Scalar t164 = t87 * omega_9_z;
  const Scalar t165 = Scalar(0.08) * ddp_9_y - Scalar(0.00507) * (t91 - t164) -
      Scalar(0.02) * t162 - Scalar(0.4222475) * t88 - Scalar(0.4384975) * domega_9_z - c_10 * t161 -
      s_10 * t163;
  tau[8] = -t165;
  const Scalar t166 = s_5 * t155 - c_5 * F_6_z;
  const Scalar t167 = t166 + Scalar(1.3725) * t56;
  const Scalar t168 = s_5 * t153 - c_5 * t157 + Scalar(0.22) * ddp_o_4_y - Scalar(0.04) * t167 +
      Scalar(0.4092575) * t49 - Scalar(0.4393875) * t50;
  const Scalar t169 = Scalar(0.22) * t51 + t167;
  const Scalar t170 = Scalar(0.357) * t166 - mu_5_z + Scalar(0.848645) * t55 - Scalar(1.3725) * t52;
  const Scalar t171 = t44 * omega_3_z;
  const Scalar t172 = Scalar(0.08) * ddp_3_y - Scalar(0.00507) * (t48 - t171) -
      Scalar(0.02) * t169 - Scalar(0.4222475) * t45 - Scalar(0.4384975) * domega_3_z - c_4 * t168 -
      s_4 * t170;
  tau[2] = -t172;
  const Scalar t173 = t150 - Scalar(0.22) * t110 + Scalar(1.3725) * t108;
  const Scalar f_10_y = f_u_12_t_y + Scalar(0.22) * t114 + Scalar(1.3725) * U_10_yx;
  const Scalar f_9_x = Scalar(0.08) * t102 + s_10 * t173 - c_10 * f_10_y;
  const Scalar t174 = Scalar(0.08) * U_9_yx + t162;
  const Scalar t175 = s_9 * f_9_x - c_9 * t174;
  const Scalar f_u_10_a_z = s_10 * f_10_y + c_10 * t173;
  const Scalar mu_9_y = Scalar(-0.00507) * (t101 - omega_r_9_x * omega_r_9_x) -
      Scalar(0.01625) * t105 + Scalar(0.08) * ddp_o_9_y + Scalar(0.02) * f_u_10_a_z - t152;
  const Scalar t176 = Scalar(0.00507) * U_9_yx + Scalar(0.4222475) * t91 +
      Scalar(0.4384975) * t164 - s_10 * t161 + c_10 * t163;
  tau[7] = Scalar(1.0144905) * t85 + Scalar(1.0164505) * qdd_8 + Scalar(0.389) * t175 -
      s_9 * mu_9_y - c_9 * t176 + Scalar(27.463095) * c_7 * s_8;
  const Scalar t177 = t156 - Scalar(0.22) * t67 + Scalar(1.3725) * t65;
  const Scalar f_4_y = f_u_6_t_y + Scalar(0.22) * t71 + Scalar(1.3725) * U_4_yx;
  const Scalar f_3_x = Scalar(0.08) * t59 + s_4 * t177 - c_4 * f_4_y;
  const Scalar t178 = Scalar(0.08) * U_3_yx + t169;
  const Scalar t179 = s_3 * f_3_x - c_3 * t178;
  const Scalar f_u_4_a_z = s_4 * f_4_y + c_4 * t177;
  const Scalar mu_3_y = Scalar(-0.00507) * (t58 - omega_r_3_x * omega_r_3_x) -
      Scalar(0.01625) * t62 + Scalar(0.08) * ddp_o_3_y + Scalar(0.02) * f_u_4_a_z - t158;
  const Scalar t180 = Scalar(0.00507) * U_3_yx + Scalar(0.4222475) * t48 +
      Scalar(0.4384975) * t171 - s_4 * t168 + c_4 * t170;
  tau[1] = Scalar(1.0144905) * t42 + Scalar(1.0164505) * qdd_2 + Scalar(0.389) * t179 -
      s_3 * mu_3_y - c_3 * t180 + Scalar(27.463095) * c_1 * s_2;
  const Scalar f_u_9_a_z = s_9 * t174 + c_9 * f_9_x;
  const Scalar mu_8_x = c_9 * mu_9_y - Scalar(1.0164505) * t82 - Scalar(1.0144905) * t83 -
      Scalar(0.389) * f_u_9_a_z - s_9 * t176 + Scalar(27.463095) * s_7;
  tau[6] = Scalar(0.00392) * qdd_7 + s_8 * (Scalar(0.00196) * t89 + t165) + c_8 * mu_8_x;
  const Scalar f_u_3_a_z = s_3 * t178 + c_3 * f_3_x;
  const Scalar mu_2_x = c_3 * mu_3_y - Scalar(1.0164505) * t39 - Scalar(1.0144905) * t40 -
      Scalar(0.389) * f_u_3_a_z - s_3 * t180 + Scalar(27.463095) * s_1;
  tau[0] = Scalar(0.00392) * qdd_1 + s_2 * (Scalar(0.00196) * t46 + t172) + c_2 * mu_2_x;
  const Scalar t181 = Scalar(0.33) * t8 + t12;
  const Scalar t182 = Scalar(-0.24) * (t13 + t14);
  const Scalar t183 = t181 - t182;
  const Scalar t184 = Scalar(0.33) * t23 - t24;
  const Scalar t185 = Scalar(0.24) * (domega_15_z - t16);
  const Scalar t186 = t185 + t184;
  const Scalar t187 = s_19 * t183 + c_19 * t186;
  const Scalar t188 = Scalar(0.33) * U_15_yx - t19;
  const Scalar t189 = Scalar(0.24) * (t10 + t22);
  const Scalar t190 = t188 - t189;
  const Scalar t191 = s_20 * t187 + c_20 * t190;
  const Scalar t192 = s_19 * omega_15_z - c_19 * t2;
  const Scalar omega_19_z = qd_19 + omega_r_15_y;
  const Scalar omega_r_20_x = s_20 * t192 + c_20 * omega_19_z;
  const Scalar t193 = s_20 * omega_19_z - c_20 * t192;
  const Scalar t194 = omega_r_20_x * t193;
  const Scalar domega_20_z = qdd_20 - qd_19 * t192 + s_19 * t13 + c_19 * domega_15_z;
  const Scalar t195 = t194 + domega_20_z;
  const Scalar t196 = t191 - Scalar(0.305) * t195;
  const Scalar t197 = s_19 * t186 - c_19 * t183;
  const Scalar omega_r_20_a_z = s_19 * t2 + c_19 * omega_15_z;
  const Scalar t198 = qd_19 * omega_r_20_a_z + s_19 * domega_15_z - c_19 * t13;
  const Scalar domega_19_z = qdd_19 - t6;
  const Scalar t199 = qd_20 * t193 - s_20 * t198 - c_20 * domega_19_z;
  const Scalar omega_20_z = qd_20 + omega_r_20_a_z;
  const Scalar t200 = t193 * omega_20_z;
  const Scalar t201 = t200 + t199;
  const Scalar t202 = Scalar(0.305) * t201 + t197;
  const Scalar t203 = s_21 * omega_20_z - c_21 * omega_r_20_x;
  const Scalar omega_21_z = qd_21 - t193;
  const Scalar t204 = omega_21_z * omega_21_z;
  const Scalar t205 = t203 * t203 + t204;
  const Scalar t206 = Scalar(0.004) * t205 + s_21 * t196 - c_21 * t202;
  const Scalar t207 = omega_r_20_x * omega_r_20_x + omega_20_z * omega_20_z;
  const Scalar ddp_o_21_y = Scalar(0.305) * t207 + s_20 * t190 - c_20 * t187;
  const Scalar omega_r_21_x = s_21 * omega_r_20_x + c_21 * omega_20_z;
  const Scalar t208 = qd_21 * omega_r_21_x + s_21 * domega_20_z + c_21 * t199;
  const Scalar t209 = omega_r_21_x * omega_21_z;
  const Scalar t210 = t208 + t209;
  const Scalar ddp_o_22_z = Scalar(0.004) * t210 + ddp_o_21_y;
  const Scalar t211 = s_22 * ddp_o_22_z + c_22 * t206;
  const Scalar omega_r_23_a_z = s_22 * omega_r_21_x + c_22 * omega_21_z;
  const Scalar omega_22_z = qd_22 - t203;
  const Scalar t212 = omega_22_z * omega_22_z;
  const Scalar t213 = t212 + omega_r_23_a_z * omega_r_23_a_z;
  const Scalar domega_22_z = qdd_22 - t208;
  const Scalar t214 = s_22 * omega_21_z - c_22 * omega_r_21_x;
  const Scalar t215 = t214 * omega_r_23_a_z;
  const Scalar t216 = domega_22_z - t215;
  const Scalar t217 = Scalar(0.239) * t216 - Scalar(0.004) * t213 + t211;
  const Scalar t218 = s_21 * t202 + c_21 * t196;
  const Scalar t219 = omega_r_21_x * t203;
  const Scalar domega_21_z = qdd_21 - qd_20 * omega_r_20_x - s_20 * domega_19_z + c_20 * t198;
  const Scalar U_21_yx = domega_21_z - t219;
  const Scalar t220 = t218 - Scalar(0.004) * U_21_yx;
  const Scalar t221 = qd_21 * t203 + s_21 * t199 - c_21 * domega_20_z;
  const Scalar t222 = qd_22 * t214 + s_22 * t221 - c_22 * domega_21_z;
  const Scalar t223 = t214 * omega_22_z;
  const Scalar t224 = t222 + t223;
  const Scalar t225 = qd_22 * omega_r_23_a_z + s_22 * domega_21_z + c_22 * t221;
  const Scalar t226 = omega_r_23_a_z * omega_22_z;
  const Scalar t227 = t225 + t226;
  const Scalar t228 = Scalar(0.239) * t227 - Scalar(0.004) * t224 + t220;
  const Scalar ddp_23_x = s_23 * t217 - c_23 * t228;
  const Scalar t229 = s_22 * t206 - c_22 * ddp_o_22_z;
  const Scalar U_22_yx = domega_22_z + t215;
  const Scalar t230 = t212 + t214 * t214;
  const Scalar t231 = Scalar(-0.004) * U_22_yx - Scalar(0.239) * t230 + t229;
  const Scalar t232 = s_24 * t231 - c_24 * ddp_23_x;
  const Scalar t233 = s_23 * t228 + c_23 * t217;
  const Scalar t234 = s_25 * t232 + c_25 * t233;
  const Scalar omega_r_23_x = s_23 * t214 + c_23 * omega_22_z;
  const Scalar omega_23_z = qd_23 + omega_r_23_a_z;
  const Scalar omega_r_24_x = s_24 * omega_23_z + c_24 * omega_r_23_x;
  const Scalar omega_r_24_a_z = s_23 * omega_22_z - c_23 * t214;
  const Scalar omega_24_z = qd_24 + omega_r_24_a_z;
  const Scalar omega_r_25_x = s_25 * omega_r_24_x + c_25 * omega_24_z;
  const Scalar t235 = s_24 * omega_r_23_x - c_24 * omega_23_z;
  const Scalar omega_25_z = qd_25 - t235;
  const Scalar t236 = omega_r_25_x * omega_25_z;
  const Scalar t237 = qd_23 * omega_r_24_a_z - s_23 * t225 - c_23 * domega_22_z;
  const Scalar domega_23_z = qdd_23 - t222;
  const Scalar t238 = qd_24 * t235 - s_24 * domega_23_z + c_24 * t237;
  const Scalar domega_24_z = qdd_24 + qd_23 * omega_r_23_x + s_23 * domega_22_z - c_23 * t225;
  const Scalar U_25_xz = t236 - qd_25 * omega_r_25_x - s_25 * domega_24_z - c_25 * t238;
  const Scalar t239 = s_25 * omega_24_z - c_25 * omega_r_24_x;
  const Scalar t240 = omega_r_25_x * t239;
  const Scalar domega_25_z = qdd_25 - qd_24 * omega_r_24_x + s_24 * t237 + c_24 * domega_23_z;
  const Scalar N_25_z = Scalar(0.0014129000000002) * domega_25_z - Scalar(0.0005096) * t240 +
      Scalar(0.0007482) * U_25_xz + Scalar(0.0094) * t234;
  tau[24] = N_25_z;
  const Scalar ddp_26_a_y = t182 + t181;
  const Scalar t241 = t184 - t185;
  const Scalar t242 = s_26 * ddp_26_a_y + c_26 * t241;
  const Scalar t243 = t189 + t188;
  const Scalar t244 = s_27 * t242 + c_27 * t243;
  const Scalar t245 = s_26 * omega_15_z - c_26 * t2;
  const Scalar omega_26_z = qd_26 + omega_r_15_y;
  const Scalar omega_r_27_x = s_27 * t245 + c_27 * omega_26_z;
  const Scalar t246 = s_27 * omega_26_z - c_27 * t245;
  const Scalar t247 = omega_r_27_x * t246;
  const Scalar domega_27_z = qdd_27 - qd_26 * t245 + s_26 * t13 + c_26 * domega_15_z;
  const Scalar t248 = t247 + domega_27_z;
  const Scalar t249 = t244 - Scalar(0.305) * t248;
  const Scalar t250 = s_26 * t241 - c_26 * ddp_26_a_y;
  const Scalar omega_r_27_a_z = s_26 * t2 + c_26 * omega_15_z;
  const Scalar t251 = qd_26 * omega_r_27_a_z + s_26 * domega_15_z - c_26 * t13;
  const Scalar domega_26_z = qdd_26 - t6;
  const Scalar t252 = qd_27 * t246 - s_27 * t251 - c_27 * domega_26_z;
  const Scalar omega_27_z = qd_27 + omega_r_27_a_z;
  const Scalar t253 = t246 * omega_27_z;
  const Scalar t254 = t253 + t252;
  const Scalar t255 = Scalar(0.305) * t254 + t250;
  const Scalar t256 = s_28 * omega_27_z - c_28 * omega_r_27_x;
  const Scalar omega_28_z = qd_28 - t246;
  const Scalar t257 = omega_28_z * omega_28_z;
  const Scalar t258 = t256 * t256 + t257;
  const Scalar t259 = Scalar(0.004) * t258 + s_28 * t249 - c_28 * t255;
  const Scalar t260 = omega_r_27_x * omega_r_27_x + omega_27_z * omega_27_z;
  const Scalar ddp_o_28_y = Scalar(0.305) * t260 + s_27 * t243 - c_27 * t242;
  const Scalar omega_r_28_x = s_28 * omega_r_27_x + c_28 * omega_27_z;
  const Scalar t261 = qd_28 * omega_r_28_x + s_28 * domega_27_z + c_28 * t252;
  const Scalar t262 = omega_r_28_x * omega_28_z;
  const Scalar t263 = t261 + t262;
  const Scalar ddp_o_29_z = Scalar(0.004) * t263 + ddp_o_28_y;
  const Scalar t264 = s_29 * ddp_o_29_z + c_29 * t259;
  const Scalar omega_r_30_a_z = s_29 * omega_r_28_x + c_29 * omega_28_z;
  const Scalar omega_29_z = qd_29 - t256;
  const Scalar t265 = omega_29_z * omega_29_z;
  const Scalar t266 = t265 + omega_r_30_a_z * omega_r_30_a_z;
  const Scalar domega_29_z = qdd_29 - t261;
  const Scalar t267 = s_29 * omega_28_z - c_29 * omega_r_28_x;
  const Scalar t268 = t267 * omega_r_30_a_z;
  const Scalar t269 = domega_29_z - t268;
  const Scalar t270 = Scalar(0.239) * t269 - Scalar(0.004) * t266 + t264;
  const Scalar t271 = s_28 * t255 + c_28 * t249;
  const Scalar t272 = omega_r_28_x * t256;
  const Scalar domega_28_z = qdd_28 - qd_27 * omega_r_27_x - s_27 * domega_26_z + c_27 * t251;
  const Scalar U_28_yx = domega_28_z - t272;
  const Scalar t273 = t271 - Scalar(0.004) * U_28_yx;
  const Scalar t274 = qd_28 * t256 + s_28 * t252 - c_28 * domega_27_z;
  const Scalar t275 = qd_29 * t267 + s_29 * t274 - c_29 * domega_28_z;
  const Scalar t276 = t267 * omega_29_z;
  const Scalar t277 = t275 + t276;
  const Scalar t278 = qd_29 * omega_r_30_a_z + s_29 * domega_28_z + c_29 * t274;
  const Scalar t279 = omega_r_30_a_z * omega_29_z;
  const Scalar t280 = t278 + t279;
  const Scalar t281 = Scalar(0.239) * t280 - Scalar(0.004) * t277 + t273;
  const Scalar t282 = s_30 * t270 - c_30 * t281;
  const Scalar t283 = s_29 * t259 - c_29 * ddp_o_29_z;
  const Scalar U_29_yx = domega_29_z + t268;
  const Scalar t284 = t265 + t267 * t267;
  const Scalar t285 = Scalar(-0.004) * U_29_yx - Scalar(0.239) * t284 + t283;
  const Scalar t286 = s_31 * t285 - c_31 * t282;
  const Scalar t287 = s_30 * t281 + c_30 * t270;
  const Scalar t288 = s_32 * t286 + c_32 * t287;
  const Scalar omega_r_30_x = s_30 * t267 + c_30 * omega_29_z;
  const Scalar omega_30_z = qd_30 + omega_r_30_a_z;
  const Scalar omega_r_31_x = s_31 * omega_30_z + c_31 * omega_r_30_x;
  const Scalar omega_r_31_a_z = s_30 * omega_29_z - c_30 * t267;
  const Scalar omega_31_z = qd_31 + omega_r_31_a_z;
  const Scalar omega_r_32_x = s_32 * omega_r_31_x + c_32 * omega_31_z;
  const Scalar t289 = s_31 * omega_r_30_x - c_31 * omega_30_z;
  const Scalar omega_32_z = qd_32 - t289;
  const Scalar t290 = omega_r_32_x * omega_32_z;
  const Scalar t291 = qd_30 * omega_r_31_a_z - s_30 * t278 - c_30 * domega_29_z;
  const Scalar domega_30_z = qdd_30 - t275;
  const Scalar t292 = qd_31 * t289 - s_31 * domega_30_z + c_31 * t291;
  const Scalar domega_31_z = qdd_31 + qd_30 * omega_r_30_x + s_30 * domega_29_z - c_30 * t278;
  const Scalar U_32_xz = t290 - qd_32 * omega_r_32_x - s_32 * domega_31_z - c_32 * t292;
  const Scalar t293 = s_32 * omega_31_z - c_32 * omega_r_31_x;
  const Scalar t294 = omega_r_32_x * t293;
  const Scalar domega_32_z = qdd_32 - qd_31 * omega_r_31_x + s_31 * t291 + c_31 * domega_30_z;
  const Scalar t295 = Scalar(0.0005096) * t294 - Scalar(0.0014129000000002) * domega_32_z +
      Scalar(0.0007482) * U_32_xz + Scalar(0.0094) * t288;
  tau[31] = -t295;
  const Scalar t296 = s_31 * t282 + c_31 * t285;
  const Scalar t297 = qd_32 * t293 + s_32 * t292 - c_32 * domega_31_z;
  const Scalar t298 = omega_32_z * omega_32_z;
  const Scalar t299 = t293 * omega_32_z;
  const Scalar t300 = Scalar(0.0005096) * t297 + Scalar(0.0007482) * (t298 - t293 * t293) -
      Scalar(0.0014129000000002) * t299 + Scalar(0.0094) * t296;
  const Scalar t301 = t294 + domega_32_z;
  const Scalar t302 = Scalar(0.0007482) * t301 + Scalar(0.0019225000000002) * t290;
  const Scalar t303 = omega_r_31_x * t289;
  const Scalar t304 = -s_32 * t302 - c_32 * t300 - Scalar(0.0258331000000002) * domega_31_z -
      Scalar(0.0255131000000002) * t303 + Scalar(0.1902) * t286;
  tau[30] = -t304;
  const Scalar t305 = s_24 * ddp_23_x + c_24 * t231;
  const Scalar t306 = qd_25 * t239 + s_25 * t238 - c_25 * domega_24_z;
  const Scalar t307 = omega_25_z * omega_25_z;
  const Scalar t308 = t239 * omega_25_z;
  const Scalar t309 = Scalar(0.0007482) * (t307 - t239 * t239) - Scalar(0.0005096) * t306 +
      Scalar(0.0014129000000002) * t308 + Scalar(0.0094) * t305;
  const Scalar t310 = t240 + domega_25_z;
  const Scalar t311 = Scalar(0.0007482) * t310 - Scalar(0.0019225000000002) * t236;
  const Scalar t312 = omega_r_24_x * t235;
  const Scalar t313 = s_25 * t311 + c_25 * t309 - Scalar(0.0258331000000002) * domega_24_z -
      Scalar(0.0255131000000002) * t312 + Scalar(0.1902) * t232;
  tau[23] = -t313;
  const Scalar t314 = Scalar(0.00032) * omega_r_31_x * omega_31_z + t295;
  const Scalar t315 = t289 * omega_31_z;
  const Scalar t316 = s_32 * t300 - c_32 * t302 - Scalar(0.0255131000000002) * t292 -
      Scalar(0.0258331000000002) * t315 + Scalar(0.1902) * t287;
  const Scalar mu_30_z = Scalar(0.00032) * omega_r_30_x * omega_r_31_a_z +
      Scalar(0.00096) * domega_30_z - c_31 * t314 + s_31 * t316;
  tau[29] = mu_30_z;
  const Scalar t317 = N_25_z - Scalar(0.00032) * omega_r_24_x * omega_24_z;
  const Scalar t318 = t235 * omega_24_z;
  const Scalar t319 = c_25 * t311 - s_25 * t309 - Scalar(0.0255131000000002) * t238 -
      Scalar(0.0258331000000002) * t318 + Scalar(0.1902) * t233;
  const Scalar mu_23_z = Scalar(0.00032) * omega_r_23_x * omega_r_24_a_z +
      Scalar(0.00096) * domega_23_z + c_24 * t317 + s_24 * t319;
  tau[22] = mu_23_z;
  const Scalar t320 = Scalar(0.00032) * t291 + Scalar(0.00096) * omega_r_31_a_z * omega_30_z -
      s_31 * t314 - c_31 * t316;
  const Scalar t321 = t304 - Scalar(0.00064) * omega_r_30_x * omega_30_z;
  const Scalar t322 = omega_r_32_x * omega_r_32_x + t298;
  const Scalar f_31_x = Scalar(0.0094) * (s_32 * t301 + c_32 * t322) +
      Scalar(0.1902) * (domega_31_z + t303);
  const Scalar f_31_y = Scalar(0.0094) * (t299 + t297) +
      Scalar(0.1902) * (omega_31_z * omega_31_z + omega_r_31_x * omega_r_31_x);
  const Scalar t323 = s_31 * f_31_y - c_31 * f_31_x;
  const Scalar t324 = Scalar(0.1902) * (t292 + t315) - Scalar(0.0094) * (s_32 * t322 - c_32 * t301);
  const Scalar t325 = s_30 * t323 + c_30 * t324;
  const Scalar f_u_31_t_y = s_31 * f_31_x + c_31 * f_31_y;
  const Scalar mu_29_z = Scalar(0.004) * f_u_31_t_y - Scalar(0.0050592) * (t266 - t284) -
      Scalar(0.0328) * t283 - Scalar(0.239) * t325 - s_30 * t321 - c_30 * t320 -
      Scalar(0.200951) * t268 + Scalar(0.2045534) * domega_29_z + Scalar(0.8648) * t264;
  tau[28] = mu_29_z;
  const Scalar t326 = Scalar(0.00032) * t237 + Scalar(0.00096) * omega_r_24_a_z * omega_23_z +
      s_24 * t317 - c_24 * t319;
  const Scalar t327 = t313 - Scalar(0.00064) * omega_r_23_x * omega_23_z;
  const Scalar t328 = omega_r_25_x * omega_r_25_x + t307;
  const Scalar f_24_x = Scalar(0.1902) * (domega_24_z + t312) -
      Scalar(0.0094) * (s_25 * t310 + c_25 * t328);
  const Scalar f_24_y = Scalar(0.1902) * (omega_24_z * omega_24_z + omega_r_24_x * omega_r_24_x) -
      Scalar(0.0094) * (t308 + t306);
  const Scalar t329 = s_24 * f_24_y - c_24 * f_24_x;
  const Scalar t330 = Scalar(0.0094) * (s_25 * t328 - c_25 * t310) + Scalar(0.1902) * (t238 + t318);
  const Scalar t331 = s_23 * t329 + c_23 * t330;
  const Scalar f_u_24_t_y = s_24 * f_24_x + c_24 * f_24_y;
  const Scalar mu_22_z = Scalar(0.004) * f_u_24_t_y - Scalar(0.0050592) * (t213 - t230) -
      Scalar(0.0328) * t229 - Scalar(0.239) * t331 - s_23 * t327 - c_23 * t326 -
      Scalar(0.200951) * t215 + Scalar(0.2045534) * domega_22_z + Scalar(0.8648) * t211;
  tau[21] = mu_22_z;
  const Scalar f_u_30_t_y = s_30 * t324 - c_30 * t323;
  const Scalar t332 = c_30 * t321 - Scalar(0.0050592) * t277 - Scalar(0.239) * f_u_30_t_y -
      s_30 * t320 + Scalar(0.200951) * t278 + Scalar(0.2045534) * t279 + Scalar(0.8648) * t273;
  const Scalar t333 = Scalar(-0.004) * f_u_30_t_y - Scalar(0.0036024) * t276 +
      Scalar(0.0050592) * t280 + Scalar(0.0328) * t273 + mu_30_z;
  const Scalar t334 = Scalar(0.0328) * t277 + f_u_30_t_y - Scalar(0.8648) * t280;
  const Scalar t335 = t256 * omega_28_z;
  const Scalar tau_28 = Scalar(0.001934) * t272 + Scalar(0.0032) * t271 -
      Scalar(0.0023) * (t274 - t335) + Scalar(0.004) * t334 + Scalar(0.0097684) * domega_28_z +
      c_29 * t333 + s_29 * t332;
  tau[27] = tau_28;
  const Scalar f_u_23_t_y = s_23 * t330 - c_23 * t329;
  const Scalar t336 = c_23 * t327 - Scalar(0.0050592) * t224 - Scalar(0.239) * f_u_23_t_y -
      s_23 * t326 + Scalar(0.200951) * t225 + Scalar(0.2045534) * t226 + Scalar(0.8648) * t220;
  const Scalar t337 = Scalar(-0.004) * f_u_23_t_y - Scalar(0.0036024) * t223 +
      Scalar(0.0050592) * t227 + Scalar(0.0328) * t220 + mu_23_z;
  const Scalar t338 = Scalar(0.0328) * t224 + f_u_23_t_y - Scalar(0.8648) * t227;
  const Scalar t339 = t203 * omega_21_z;
  const Scalar tau_21 = Scalar(0.001934) * t219 + Scalar(0.0032) * t218 -
      Scalar(0.0023) * (t221 - t339) + Scalar(0.004) * t338 + Scalar(0.0097684) * domega_21_z +
      c_22 * t337 + s_22 * t336;
  tau[20] = tau_21;
  const Scalar t340 = Scalar(0.001934) * t274 - Scalar(0.0023) * U_28_yx +
      Scalar(0.0097684) * t335 - s_29 * t333 + c_29 * t332;
  const Scalar f_29_x = Scalar(0.0328) * t266 + t325 - Scalar(0.8648) * t269;
  const Scalar t341 = Scalar(0.0328) * U_29_yx + f_u_31_t_y + Scalar(0.8648) * t284;
  const Scalar t342 = s_29 * f_29_x - c_29 * t341;
  const Scalar mu_28_y = Scalar(0.0032) * ddp_o_28_y +
      Scalar(0.0023) * (t257 - omega_r_28_x * omega_r_28_x) + Scalar(0.004) * t342 -
      Scalar(0.0078344) * t262 + mu_29_z;
  const Scalar f_28_x = Scalar(0.0032) * t258 + s_29 * t341 + c_29 * f_29_x;
  const Scalar t343 = Scalar(0.0032) * U_28_yx - t334;
  const Scalar t344 = s_28 * f_28_x - c_28 * t343;
  const Scalar t345 = s_28 * mu_28_y - Scalar(0.4777722) * t247 + c_28 * t340 +
      Scalar(1.661) * t244 - Scalar(0.4797322) * domega_27_z - Scalar(0.305) * t344;
  tau[26] = -t345;
  const Scalar t346 = Scalar(0.001934) * t221 - Scalar(0.0023) * U_21_yx +
      Scalar(0.0097684) * t339 - s_22 * t337 + c_22 * t336;
  const Scalar f_22_x = Scalar(0.0328) * t213 + t331 - Scalar(0.8648) * t216;
  const Scalar t347 = Scalar(0.0328) * U_22_yx + f_u_24_t_y + Scalar(0.8648) * t230;
  const Scalar t348 = s_22 * f_22_x - c_22 * t347;
  const Scalar mu_21_y = Scalar(0.0032) * ddp_o_21_y +
      Scalar(0.0023) * (t204 - omega_r_21_x * omega_r_21_x) + Scalar(0.004) * t348 -
      Scalar(0.0078344) * t209 + mu_22_z;
  const Scalar f_21_x = Scalar(0.0032) * t205 + s_22 * t347 + c_22 * f_22_x;
  const Scalar t349 = Scalar(0.0032) * U_21_yx - t338;
  const Scalar t350 = s_21 * f_21_x - c_21 * t349;
  const Scalar t351 = s_21 * mu_21_y - Scalar(0.4777722) * t194 + c_21 * t346 +
      Scalar(1.661) * t191 - Scalar(0.4797322) * domega_20_z - Scalar(0.305) * t350;
  tau[19] = -t351;
  const Scalar f_u_28_a_z = s_28 * t343 + c_28 * f_28_x;
  const Scalar t352 = Scalar(0.4797322) * t253 + s_28 * t340 - c_28 * mu_28_y +
      Scalar(1.661) * t250 + Scalar(0.4777722) * t252 + Scalar(0.305) * f_u_28_a_z;
  const Scalar t353 = tau_28 - Scalar(0.00196) * omega_r_27_x * omega_27_z;
  const Scalar t354 = Scalar(0.00196) * t245;
  const Scalar mu_26_z = Scalar(0.00392) * domega_26_z - omega_r_27_a_z * t354 - s_27 * t353 -
      c_27 * t352;
  tau[25] = mu_26_z;
  const Scalar f_u_21_a_z = s_21 * t349 + c_21 * f_21_x;
  const Scalar t355 = Scalar(0.4797322) * t200 + s_21 * t346 - c_21 * mu_21_y +
      Scalar(1.661) * t197 + Scalar(0.4777722) * t199 + Scalar(0.305) * f_u_21_a_z;
  const Scalar t356 = tau_21 - Scalar(0.00196) * omega_r_20_x * omega_20_z;
  const Scalar t357 = Scalar(0.00196) * t192;
  const Scalar mu_19_z = Scalar(0.00392) * domega_19_z - omega_r_20_a_z * t357 - s_20 * t356 -
      c_20 * t355;
  tau[18] = mu_19_z;
  const Scalar f_27_x = t344 + Scalar(1.661) * t248;
  const Scalar f_27_y = Scalar(-0.0032) * t263 - t342 + Scalar(1.661) * t260;
  const Scalar t358 = s_27 * f_27_x + c_27 * f_27_y;
  const Scalar t359 = f_u_28_a_z + Scalar(1.661) * t254;
  const Scalar f_20_x = t350 + Scalar(1.661) * t195;
  const Scalar f_20_y = Scalar(-0.0032) * t210 - t348 + Scalar(1.661) * t207;
  const Scalar t360 = s_20 * f_20_x + c_20 * f_20_y;
  const Scalar t361 = f_u_21_a_z + Scalar(1.661) * t201;
  const Scalar t362 = (s_26 * t359 - c_26 * t358) - (s_19 * t361 - c_19 * t360);
  const Scalar t363 = Scalar(0.00196) * t198 + Scalar(0.00392) * omega_r_20_a_z * omega_19_z +
      c_20 * t356 - s_20 * t355;
  const Scalar t364 = Scalar(0.00196) * t251 + Scalar(0.00392) * omega_r_27_a_z * omega_26_z +
      c_27 * t353 - s_27 * t352;
  const Scalar t365 = omega_19_z * t357 + t351;
  const Scalar mu_26_y = omega_26_z * t354 + t345;
  const Scalar t366 = (s_27 * f_27_y - c_27 * f_27_x) + (s_20 * f_20_y - c_20 * f_20_x);
  const Scalar t367 = Scalar(0.02) * t33 - Scalar(0.22) * (domega_18_z - t36);
  const Scalar U_18_yx = t36 + domega_18_z;
  const Scalar F_18_y = Scalar(0.02) * U_18_yx + Scalar(0.22) * t35;
  const Scalar t368 = s_18 * t367 - c_18 * F_18_y;
  const Scalar t369 = Scalar(0.02) * t131 - Scalar(0.22) * t127;
  const Scalar t370 = s_17 * t368 + c_17 * t369;
  const Scalar f_u_18_t_y = s_18 * F_18_y + c_18 * t367;
  const Scalar t371 = s_16 * f_u_18_t_y + c_16 * t370;
  const Scalar t372 = Scalar(0.0005) * t37 + Scalar(0.001125) * omega_r_17_a_z * omega_16_z -
      s_17 * t146 - c_17 * t145;
  const Scalar t373 = mu_17_z - Scalar(0.000625) * t29 * omega_16_z;
  const Scalar tau_15 = Scalar(0.043998) * t15 + s_16 * t372 + c_16 * t373 + Scalar(0.453) * t371 +
      Scalar(1.972772833332667) * t16 - Scalar(0.24) * t362 + s_19 * t363 - c_19 * t365 +
      s_26 * t364 - c_26 * mu_26_y + Scalar(0.33) * t366 + Scalar(4.062559499999667) * domega_15_z -
      Scalar(89.72226) * t18;
  tau[14] = tau_15;
  const Scalar t374 = s_26 * t358 + c_26 * t359;
  const Scalar t375 = s_19 * t360 + c_19 * t361;
  const Scalar t376 = Scalar(0.003) * t371 - Scalar(0.043998) * U_15_yx + mu_16_z -
      Scalar(0.24) * (t374 - t375) + s_19 * t365 + c_19 * t363 + s_26 * mu_26_y + c_26 * t364 +
      Scalar(1.972772833332667) * t13 - Scalar(4.062559499999667) * t14;
  const Scalar t377 = s_16 * t370 - c_16 * f_u_18_t_y;
  const Scalar f_u_16_x = s_17 * t369 - c_17 * t368;
  const Scalar U_15_zz_xx = t23 - t11;
  const Scalar t378 = Scalar(0.003) * f_u_16_x - Scalar(0.043998) * U_15_zz_xx - s_16 * t373 +
      c_16 * t372 - Scalar(0.453) * t377 - mu_26_z - mu_19_z - Scalar(0.33) * (t374 + t375) +
      Scalar(89.72226) * s_14 + Scalar(6.035332333332334) * t7;
  const Scalar t379 = c_14 * (qd_13 * t3 - Scalar(0.6119232795934959));
  tau[13] = Scalar(3.062001499999667) * t379 + Scalar(3.064451499999667) * qdd_14 - s_15 * t376 -
      c_15 * t378;
  const Scalar mu_14_x = Scalar(3.064451499999667) * t4 + Scalar(3.062001499999667) * t5 +
      s_15 * t378 - c_15 * t376;
  const Scalar mu_14_y = Scalar(0.00245) * t17 - tau_15;
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

// Joint-space inertia matrix B(q) (7.32).
//   q[32]    in   joint positions, rad or m
//   B[1024]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//                 32 x 32, row by row: entry (i, j) is B[32 * i + j]
// Reads q[1..5], q[7..11], q[13..31]. Operations: 991 mul, 726 add, 58 sin/cos. Always zero: 740 of
// the 1024 entries of B.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inertia_matrix(const Scalar* q, Scalar* B, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5, 7, 8, 9, 10, 11, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5],
      s_8 = sine[7], c_8 = cosine[7], s_9 = sine[8], c_9 = cosine[8], s_10 = sine[9],
      c_10 = cosine[9], s_11 = sine[10], c_11 = cosine[10], s_12 = sine[11], c_12 = cosine[11],
      s_14 = sine[13], c_14 = cosine[13], s_15 = sine[14], c_15 = cosine[14], s_16 = sine[15],
      c_16 = cosine[15], s_17 = sine[16], c_17 = cosine[16], s_18 = sine[17], c_18 = cosine[17],
      s_19 = sine[18], c_19 = cosine[18], s_20 = sine[19], c_20 = cosine[19], s_21 = sine[20],
      c_21 = cosine[20], s_22 = sine[21], c_22 = cosine[21], s_23 = sine[22], c_23 = cosine[22],
      s_24 = sine[23], c_24 = cosine[23], s_25 = sine[24], c_25 = cosine[24], s_26 = sine[25],
      c_26 = cosine[25], s_27 = sine[26], c_27 = cosine[26], s_28 = sine[27], c_28 = cosine[27],
      s_29 = sine[28], c_29 = cosine[28], s_30 = sine[29], c_30 = cosine[29], s_31 = sine[30],
      c_31 = cosine[30], s_32 = sine[31], c_32 = cosine[31];
  const Scalar Iu_32_a_xy = Scalar(0.0007482) * s_32;
  B[991] = B[1022] = Iu_32_a_xy;
  B[760] = B[791] = Scalar(-0.0007482) * s_25;
  const Scalar mu_u_18_17_t_y = Scalar(0.03408) * s_17;
  B[497] = B[559] = mu_u_18_17_t_y;
  const Scalar t1 = s_24 * c_25;
  const Scalar mu_u_25_24_t_y = Scalar(0.0007482) * t1 + Scalar(0.0014129000000002) * c_24;
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
  const Scalar t5 = Scalar(0.0063) * c_12 - Scalar(0.0012) * s_12;
  const Scalar t6 = s_12 * t5;
  const Scalar Ic_11_zz = t6 + Scalar(0.00940666666667);
  B[330] = Ic_11_zz;
  const Scalar t7 = Scalar(0.0063) * c_6 - Scalar(0.0012) * s_6;
  const Scalar t8 = s_6 * t7;
  const Scalar Ic_5_zz = t8 + Scalar(0.00940666666667);
  B[132] = Ic_5_zz;
  const Scalar t9 = Scalar(0.0007482) * s_25;
  const Scalar t10 = t9 * (Scalar(0.6811013098102112) * t1 + c_24);
  B[727] = B[758] = -t10;
  const Scalar Iu_18_t_g = Scalar(0.0044) * c_18 + Scalar(0.024) * s_18;
  const Scalar t11 = s_18 * Iu_18_t_g;
  const Scalar mu_u_17_17_a_y = t11 - Scalar(0.03438);
  B[528] = -mu_u_17_17_a_y;
  const Scalar hu_6_a_z = Scalar(0.045) * c_6 - Scalar(0.105) * s_6;
  const Scalar t12 = Scalar(0.04) * hu_6_a_z + Scalar(0.01431666666667);
  const Scalar hu_6_t_x = Scalar(0.045) * s_6 + Scalar(0.105) * c_6;
  const Scalar t13 = Scalar(0.357) * hu_6_t_x;
  const Scalar mu_6_4_z = c_5 * t12 + t13;
  B[101] = B[163] = mu_6_4_z;
  const Scalar hu_12_a_z = Scalar(0.045) * c_12 - Scalar(0.105) * s_12;
  const Scalar t14 = Scalar(0.04) * hu_12_a_z + Scalar(0.01431666666667);
  const Scalar hu_12_t_x = Scalar(0.045) * s_12 + Scalar(0.105) * c_12;
  const Scalar t15 = Scalar(0.357) * hu_12_t_x;
  const Scalar mu_12_10_z = c_11 * t14 + t15;
  B[299] = B[361] = mu_12_10_z;
  const Scalar Iu_18_a_yz = c_18 * Iu_18_t_g - Scalar(0.0022);
  B[496] = B[527] = -c_17 * Iu_18_a_yz;
  const Scalar t16 = Scalar(0.04) * hu_6_t_x + c_6 * t7 - Scalar(0.00315);
  B[100] = B[131] = -s_5 * t16;
  const Scalar t17 = Scalar(0.357) * hu_6_a_z;
  const Scalar B_3_6 = s_5 * (c_4 * t12 - t17 * (Scalar(0.056022408963585436) + s_4));
  B[69] = B[162] = B_3_6;
  const Scalar t18 = Scalar(0.04) * hu_12_t_x + c_12 * t5 - Scalar(0.00315);
  B[298] = B[329] = -s_11 * t18;
  const Scalar t19 = Scalar(0.357) * hu_12_a_z;
  const Scalar B_9_12 = s_11 * (c_10 * t14 - t19 * (Scalar(0.056022408963585436) + s_10));
  B[267] = B[360] = B_9_12;
  const Scalar f_u_18_18_a_z = Scalar(0.22) * c_18 - Scalar(0.02) * s_18;
  const Scalar hu_18_a_z = Scalar(0.02) * c_18 + Scalar(0.22) * s_18;
  const Scalar t20 = c_16 * s_17;
  const Scalar f_u_18_16_t_x = s_16 * f_u_18_18_a_z + hu_18_a_z * t20;
  const Scalar t21 = Scalar(0.03408) * c_17;
  const Scalar mu_u_18_15_a_y = s_16 * t21 + Scalar(0.453) * f_u_18_16_t_x;
  B[465] = B[558] = -mu_u_18_15_a_y;
  const Scalar t22 = Scalar(0.0094) * s_32;
  const Scalar t23 = s_30 * t22;
  const Scalar t24 = Scalar(0.0094) * c_32;
  const Scalar t25 = c_31 * t23 - c_30 * t24;
  const Scalar t26 = c_31 * c_32;
  const Scalar t27 = Scalar(0.0007482) * t26 + Scalar(0.0014129000000002) * s_31;
  const Scalar mu_32_29_z = Scalar(0.0000376) * s_31 * s_32 + s_30 * Iu_32_a_xy - c_30 * t27 +
      Scalar(0.239) * t25;
  B[927] = B[1020] = mu_32_29_z;
  const Scalar Iu_18_t_xx = t11 - Scalar(0.024);
  const Scalar Iu_17_t_d = Iu_18_t_xx - Scalar(0.0002);
  const Scalar t28 = s_17 * s_17 * Iu_17_t_d;
  const Scalar Ic_16_zz = Iu_18_t_xx - t28 + Scalar(0.035005);
  B[495] = Ic_16_zz;
  const Scalar t29 = Scalar(0.0094) * c_25;
  const Scalar hu_23_a_y = Scalar(0.1902) * c_24 - s_24 * t29;
  const Scalar t30 = Ic_24_zz + Scalar(0.239) * hu_23_a_y;
  const Scalar t31 = c_24 * c_25;
  const Scalar t32 = s_24 - Scalar(0.6811013098102112) * t31;
  const Scalar t33 = t9 * t32;
  const Scalar hu_24_t_x = c_24 * t29 + Scalar(0.1902) * s_24;
  const Scalar mu_24_22_z = c_23 * t33 + Scalar(0.004) * hu_24_t_x + s_23 * t30;
  B[695] = B[757] = mu_24_22_z;
  const Scalar t34 = Scalar(0.0094) * s_25;
  const Scalar t35 = s_23 * t34;
  const Scalar t36 = c_24 * t35 - c_23 * t29;
  const Scalar t37 = Scalar(0.0014129000000002) * s_24 - Scalar(0.0007482) * t31;
  const Scalar t38 = Scalar(0.0000376) * s_24 * s_25 + s_23 * t9 + c_23 * t37 + Scalar(0.239) * t36;
  B[696] = B[789] = -t38;
  const Scalar hu_30_a_y = s_31 * t24 + Scalar(0.1902) * c_31;
  const Scalar t39 = Ic_31_zz + Scalar(0.239) * hu_30_a_y;
  const Scalar t40 = Scalar(0.6811013098102112) * t26 + s_31;
  const Scalar t41 = Iu_32_a_xy * t40;
  const Scalar hu_31_t_x = Scalar(0.1902) * s_31 - c_31 * t24;
  const Scalar mu_31_29_z = Scalar(0.004) * hu_31_t_x - c_30 * t41 + s_30 * t39;
  B[926] = B[988] = mu_31_29_z;
  const Scalar t42 = c_17 * f_u_18_18_a_z;
  const Scalar t43 = mu_u_17_17_a_y - Scalar(0.453) * t42;
  const Scalar t44 = s_16 * s_17;
  const Scalar t45 = Iu_18_a_yz * t44;
  const Scalar t46 = t45 + c_16 * t43;
  B[464] = B[526] = -t46;
  const Scalar t47 = mu_u_18_17_t_y - Scalar(0.003) * f_u_18_16_t_x;
  const Scalar t48 = hu_18_a_z * t44 - c_16 * f_u_18_18_a_z;
  const Scalar t49 = Scalar(0.453) * t48 - (c_16 - Scalar(0.0880281690140845) * hu_18_a_z) * t21;
  B[433] = B[557] = -s_15 * t47 - c_15 * t49;
  const Scalar t50 = Scalar(0.0012) + t6;
  const Scalar t51 = c_11 * (t50 + Scalar(0.00555));
  const Scalar t52 = c_11 * t51;
  const Scalar t53 = c_11 * hu_12_t_x;
  const Scalar t54 = Scalar(0.714) * t53;
  const Scalar t55 = Scalar(0.08) * hu_12_a_z;
  const Scalar t56 = t50 - t52 - t55 - t54 - Scalar(0.44815416666667);
  B[297] = -t56;
  const Scalar t57 = Scalar(0.0012) + t8;
  const Scalar t58 = c_5 * (t57 + Scalar(0.00555));
  const Scalar t59 = c_5 * t58;
  const Scalar t60 = c_5 * hu_6_t_x;
  const Scalar t61 = Scalar(0.714) * t60;
  const Scalar t62 = Scalar(0.08) * hu_6_a_z;
  const Scalar t63 = t57 - t59 - t62 - t61 - Scalar(0.44815416666667);
  B[99] = -t63;
  const Scalar t64 = c_4 * t16;
  const Scalar t65 = Scalar(0.02) * hu_6_t_x;
  const Scalar t66 = Ic_5_zz + Scalar(0.357) * t60;
  const Scalar t67 = s_4 * t66 - c_5 * (t64 - t65);
  B[68] = B[130] = -t67;
  const Scalar t68 = c_5 * t16;
  const Scalar mu_u_5_4_t_x = s_4 * t68 + c_4 * t66;
  const Scalar t69 = t16 - c_4 * t65;
  const Scalar t70 = s_3 * s_5;
  const Scalar t71 = Scalar(0.389) * hu_6_t_x;
  const Scalar t72 = (s_4 * t70 + c_3 * c_5) * t71;
  B[36] = B[129] = t70 * t69 + c_3 * mu_u_5_4_t_x + t72;
  const Scalar t73 = c_5 * hu_6_a_z;
  const Scalar t74 = s_4 * t73 + c_4 * hu_6_t_x;
  const Scalar t75 = c_3 * s_5;
  const Scalar t76 = s_3 * t74 - hu_6_a_z * t75;
  const Scalar mu_6_3_y = Scalar(0.02) * (s_4 * hu_6_t_x - c_4 * t73) + mu_6_4_z;
  const Scalar t77 = s_4 * t12 + c_4 * t17;
  B[37] = B[161] = t75 * t77 - Scalar(0.389) * t76 - s_3 * mu_6_3_y;
  const Scalar t78 = c_10 * t18;
  const Scalar t79 = Scalar(0.02) * hu_12_t_x;
  const Scalar t80 = Ic_11_zz + Scalar(0.357) * t53;
  const Scalar t81 = s_10 * t80 - c_11 * (t78 - t79);
  B[266] = B[328] = -t81;
  const Scalar t82 = c_11 * t18;
  const Scalar mu_u_11_10_t_x = s_10 * t82 + c_10 * t80;
  const Scalar t83 = t18 - c_10 * t79;
  const Scalar t84 = s_9 * s_11;
  const Scalar t85 = Scalar(0.389) * hu_12_t_x;
  const Scalar t86 = (s_10 * t84 + c_9 * c_11) * t85;
  B[234] = B[327] = t84 * t83 + c_9 * mu_u_11_10_t_x + t86;
  const Scalar t87 = c_11 * hu_12_a_z;
  const Scalar t88 = s_10 * t87 + c_10 * hu_12_t_x;
  const Scalar t89 = c_9 * s_11;
  const Scalar t90 = s_9 * t88 - hu_12_a_z * t89;
  const Scalar mu_12_9_y = Scalar(0.02) * (s_10 * hu_12_t_x - c_10 * t87) + mu_12_10_z;
  const Scalar t91 = s_10 * t14 + c_10 * t19;
  B[235] = B[359] = t89 * t91 - Scalar(0.389) * t90 - s_9 * mu_12_9_y;
  B[401] = B[556] = s_14 * mu_u_18_15_a_y - c_14 * (s_15 * t49 - c_15 * t47);
  const Scalar t92 = s_23 * t33 - c_23 * t30;
  const Scalar t93 = c_23 * hu_23_a_y;
  const Scalar t94 = Scalar(0.004) * t93;
  const Scalar mu_24_22_y = t10 + t94;
  const Scalar mu_24_21_z = t94 - c_22 * mu_24_22_y + s_22 * t92;
  B[663] = B[756] = mu_24_21_z;
  const Scalar mu_31_29_x = s_30 * t41 + c_30 * t39;
  const Scalar t95 = c_30 * hu_30_a_y;
  const Scalar t96 = Scalar(0.004) * t95;
  const Scalar t97 = Iu_31_t_yz - t96;
  const Scalar mu_31_28_z = t96 + c_29 * t97 - s_29 * mu_31_29_x;
  B[894] = B[987] = mu_31_28_z;
  const Scalar t98 = c_30 * t22;
  const Scalar f_u_32_30_t_y = c_31 * t98 + s_30 * t24;
  const Scalar t99 = Scalar(0.004) * f_u_32_30_t_y;
  const Scalar t100 = mu_u_32_31_t_y - t99;
  const Scalar mu_32_29_x = c_30 * Iu_32_a_xy + s_30 * t27 + Scalar(0.239) * f_u_32_30_t_y;
  const Scalar mu_32_28_z = t99 + c_29 * t100 - s_29 * mu_32_29_x;
  B[895] = B[1019] = mu_32_28_z;
  const Scalar t101 = t3 - Scalar(0.0005096);
  const Scalar t102 = c_31 * (t101 - Scalar(0.0235906)) - Scalar(0.0014964) * t2;
  const Scalar t103 = c_31 * t102;
  const Scalar mu_u_30_30_a_y = t101 - t103 - Scalar(0.0259635000000002);
  B[957] = -mu_u_30_30_a_y;
  const Scalar t104 = t4 - Scalar(0.0005096);
  const Scalar t105 = Scalar(0.0014964) * t1 + c_24 * (t104 - Scalar(0.0235906));
  const Scalar t106 = c_24 * t105;
  const Scalar mu_u_23_23_a_y = t104 - t106 - Scalar(0.0259635000000002);
  B[726] = -mu_u_23_23_a_y;
  const Scalar t107 = t51 + t15;
  const Scalar t108 = s_10 * t18 + c_10 * t107;
  const Scalar Iu_10_a_xy = s_11 * t108;
  B[265] = B[296] = Iu_10_a_xy;
  const Scalar t109 = t58 + t13;
  const Scalar t110 = s_4 * t16 + c_4 * t109;
  const Scalar Iu_4_a_xy = s_5 * t110;
  B[67] = B[98] = Iu_4_a_xy;
  const Scalar t111 = c_16 * Iu_18_a_yz;
  const Scalar hu_16_a_z = f_u_18_18_a_z * t44 + c_16 * hu_18_a_z;
  const Scalar t112 = Scalar(0.453) * hu_16_a_z - c_17 * (Iu_17_t_d * t44 - t111);
  B[463] = B[494] = -t112;
  const Scalar t113 = Scalar(0.003) * f_u_18_18_a_z;
  const Scalar t114 = s_16 * t43 - s_17 * (t111 - t113);
  const Scalar t115 = c_17 * (Iu_18_a_yz - c_16 * t113);
  B[432] = B[525] = s_15 * t115 - c_15 * t114;
  const Scalar t116 = c_23 * t34;
  const Scalar t117 = c_24 * t116 + s_23 * t29;
  const Scalar t118 = Scalar(0.004) * t117;
  const Scalar t119 = t118 + mu_u_25_24_t_y;
  const Scalar t120 = c_23 * t9 - s_23 * t37 + Scalar(0.239) * t117;
  const Scalar t121 = t118 - c_22 * t119 - s_22 * t120;
  B[664] = B[788] = -t121;
  const Scalar t122 = Scalar(0.0007482) * c_32 + s_31 * t102;
  const Scalar hu_30_t_y = t23 + c_30 * hu_31_t_x;
  const Scalar mu_30_29_z = s_30 * Iu_31_t_yz - c_30 * t122 + Scalar(0.239) * hu_30_t_y;
  B[925] = B[956] = mu_30_29_z;
  const Scalar t123 = s_4 * t109 - t64;
  const Scalar hc_4_x = t60 + Scalar(1.3725);
  const Scalar f_4_4_x = hu_6_a_z + Scalar(0.22);
  const Scalar t124 = s_4 * hc_4_x - c_4 * f_4_4_x;
  const Scalar hu_4_t_y = s_4 * f_4_4_x + c_4 * hc_4_x;
  const Scalar t125 = t63 - Scalar(0.02) * t124 - Scalar(0.389) * hu_4_t_y;
  B[35] = B[97] = t123 * t75 + s_3 * t125;
  const Scalar t126 = (s_3 * c_5 - s_4 * t75) * t71;
  B[4] = B[128] = s_2 * t67 + c_2 * (s_3 * mu_u_5_4_t_x - t75 * t69 + t126);
  const Scalar f_u_6_3_t_y = hu_6_a_z * t70 + c_3 * t74;
  const Scalar mu_6_2_x = t70 * t77 + Scalar(0.389) * f_u_6_3_t_y + c_3 * mu_6_3_y;
  B[5] = B[160] = c_2 * mu_6_2_x - s_2 * B_3_6;
  const Scalar t127 = s_10 * t107 - t78;
  const Scalar hc_10_x = t53 + Scalar(1.3725);
  const Scalar f_10_10_x = hu_12_a_z + Scalar(0.22);
  const Scalar t128 = s_10 * hc_10_x - c_10 * f_10_10_x;
  const Scalar hu_10_t_y = s_10 * f_10_10_x + c_10 * hc_10_x;
  const Scalar t129 = t56 - Scalar(0.02) * t128 - Scalar(0.389) * hu_10_t_y;
  B[233] = B[295] = t127 * t89 + s_9 * t129;
  const Scalar t130 = (s_9 * c_11 - s_10 * t89) * t85;
  B[202] = B[326] = s_8 * t81 + c_8 * (s_9 * mu_u_11_10_t_x - t89 * t83 + t130);
  const Scalar f_u_12_9_t_y = hu_12_a_z * t84 + c_9 * t88;
  const Scalar mu_12_8_x = t84 * t91 + Scalar(0.389) * f_u_12_9_t_y + c_9 * mu_12_9_y;
  B[203] = B[358] = c_8 * mu_12_8_x - s_8 * B_9_12;
  const Scalar t131 = s_22 * mu_24_22_y + c_22 * t92;
  const Scalar t132 = s_23 * hu_23_a_y;
  const Scalar t133 = s_22 * hu_24_t_x - c_22 * t132;
  const Scalar f_u_24_21_t_x = s_21 * t133 + c_21 * t93;
  const Scalar f_u_24_22_a_z = s_22 * t132 + c_22 * hu_24_t_x;
  const Scalar mu_24_21_y = mu_24_22_z - Scalar(0.004) * f_u_24_22_a_z;
  const Scalar mu_24_20_z = -c_21 * t131 - s_21 * mu_24_21_y + Scalar(0.305) * f_u_24_21_t_x;
  B[631] = B[755] = mu_24_20_z;
  const Scalar t134 = s_29 * t97 + c_29 * mu_31_29_x;
  const Scalar t135 = s_30 * hu_30_a_y;
  const Scalar t136 = s_29 * hu_31_t_x - c_29 * t135;
  const Scalar f_u_31_28_t_x = s_28 * t136 + c_28 * t95;
  const Scalar f_u_31_29_a_z = s_29 * t135 + c_29 * hu_31_t_x;
  const Scalar mu_31_28_y = mu_31_29_z - Scalar(0.004) * f_u_31_29_a_z;
  const Scalar mu_31_27_z = c_28 * t134 - s_28 * mu_31_28_y + Scalar(0.305) * f_u_31_28_t_x;
  B[862] = B[986] = mu_31_27_z;
  const Scalar mu_u_32_29_t_x = s_29 * t100 + c_29 * mu_32_29_x;
  const Scalar t137 = s_31 * t22;
  const Scalar f_u_32_29_t_x = s_29 * t137 - c_29 * t25;
  const Scalar f_u_32_28_t_x = s_28 * f_u_32_29_t_x + c_28 * f_u_32_30_t_y;
  const Scalar f_u_32_29_a_z = c_29 * t137 + s_29 * t25;
  const Scalar mu_32_28_y = mu_32_29_z - Scalar(0.004) * f_u_32_29_a_z;
  const Scalar mu_32_27_z = c_28 * mu_u_32_29_t_x + Scalar(0.305) * f_u_32_28_t_x -
      s_28 * mu_32_28_y;
  B[863] = B[1018] = mu_32_27_z;
  const Scalar Iu_24_t_xy = Scalar(0.0007482) * c_25 - s_24 * t105;
  const Scalar t138 = t35 - c_23 * hu_24_t_x;
  const Scalar t139 = s_23 * t10 - c_23 * Iu_24_t_xy + Scalar(0.239) * t138;
  B[694] = B[725] = -t139;
  const Scalar t140 = s_16 * hu_18_a_z - f_u_18_18_a_z * t20;
  const Scalar t141 = c_17 * (s_16 * Iu_18_a_yz + Iu_17_t_d * t20) + Scalar(0.453) * t140;
  const Scalar t142 = Ic_16_zz - Scalar(0.003) * hu_16_a_z;
  B[431] = B[493] = -s_15 * t142 - c_15 * t141;
  const Scalar mu_u_17_15_t_x = c_15 * t115 + s_15 * t114;
  B[400] = B[524] = s_14 * t46 - c_14 * mu_u_17_15_t_x;
  const Scalar t143 = s_22 * t119 - c_22 * t120;
  const Scalar t144 = s_24 * t34;
  const Scalar t145 = s_22 * t144 - c_22 * t36;
  const Scalar t146 = s_21 * t145 + c_21 * t117;
  const Scalar f_u_25_22_t_y = c_22 * t144 + s_22 * t36;
  const Scalar t147 = t38 - Scalar(0.004) * f_u_25_22_t_y;
  const Scalar mu_u_25_20_a_y = Scalar(0.305) * t146 - c_21 * t143 - s_21 * t147;
  B[632] = B[787] = -mu_u_25_20_a_y;
  B[399] = B[492] = s_14 * t112 - c_14 * (s_15 * t141 - c_15 * t142);
  const Scalar t148 = s_21 * t117 - c_21 * t145;
  const Scalar t149 = Scalar(0.305) * t148 - s_21 * t143 + c_21 * t147;
  const Scalar mu_u_25_20_t_y = s_20 * t121 - c_20 * t149;
  B[600] = B[786] = mu_u_25_20_t_y;
  const Scalar t150 = s_30 * hu_31_t_x - t98;
  const Scalar t151 = -c_30 * Iu_31_t_yz - s_30 * t122 + Scalar(0.239) * t150;
  const Scalar t152 = Scalar(-0.004) * t150;
  const Scalar mu_30_29_y = t152 + mu_u_30_30_a_y;
  const Scalar mu_30_28_z = t152 + s_29 * t151 - c_29 * mu_30_29_y;
  B[893] = B[955] = mu_30_28_z;
  const Scalar t153 = t52 - t55 - Scalar(0.00555);
  const Scalar Ic_10_yy = Ic_11_zz + t54 + Scalar(0.40049083333333);
  const Scalar Ic_10_xy = t82 + t19 + Scalar(0.0549);
  const Scalar t154 = s_10 * (t153 + Ic_10_yy) - Scalar(2.0) * c_10 * Ic_10_xy;
  const Scalar t155 = s_10 * t154;
  const Scalar t156 = Scalar(-0.04) * t128;
  const Scalar t157 = t153 + t156 - Scalar(0.03800666666667) - t155;
  B[264] = -t157;
  const Scalar t158 = t59 - t62 - Scalar(0.00555);
  const Scalar Ic_4_yy = Ic_5_zz + t61 + Scalar(0.40049083333333);
  const Scalar Ic_4_xy = t68 + t17 + Scalar(0.0549);
  const Scalar t159 = s_4 * (t158 + Ic_4_yy) - Scalar(2.0) * c_4 * Ic_4_xy;
  const Scalar t160 = s_4 * t159;
  const Scalar t161 = Scalar(-0.04) * t124;
  const Scalar t162 = t158 + t161 - Scalar(0.03800666666667) - t160;
  B[66] = -t162;
  const Scalar mu_4_2_x = t123 * t70 - c_3 * t125;
  B[3] = B[96] = c_2 * mu_4_2_x - s_2 * Iu_4_a_xy;
  const Scalar mu_10_8_x = t127 * t84 - c_9 * t129;
  B[201] = B[294] = c_8 * mu_10_8_x - s_8 * Iu_10_a_xy;
  const Scalar t163 = t116 + s_23 * hu_24_t_x;
  const Scalar t164 = c_23 * t10 + s_23 * Iu_24_t_xy + Scalar(0.239) * t163;
  const Scalar t165 = Scalar(0.004) * t163;
  const Scalar mu_23_22_y = mu_u_23_23_a_y - t165;
  const Scalar t166 = t165 - s_22 * t164 + c_22 * mu_23_22_y;
  B[662] = B[724] = -t166;
  const Scalar f_u_24_21_t_y = s_21 * t93 - c_21 * t133;
  const Scalar mu_24_20_x = c_21 * mu_24_21_y - s_21 * t131 + Scalar(0.305) * f_u_24_21_t_y;
  const Scalar t167 = s_20 * mu_24_21_z - c_20 * mu_24_20_x;
  B[599] = B[754] = -t167;
  const Scalar f_u_31_28_t_y = s_28 * t95 - c_28 * t136;
  const Scalar mu_31_27_x = s_28 * t134 + c_28 * mu_31_28_y + Scalar(0.305) * f_u_31_28_t_y;
  const Scalar t168 = s_27 * mu_31_28_z - c_27 * mu_31_27_x;
  B[830] = B[985] = -t168;
  const Scalar t169 = s_28 * f_u_32_30_t_y - c_28 * f_u_32_29_t_x;
  const Scalar t170 = s_28 * mu_u_32_29_t_x + Scalar(0.305) * t169 + c_28 * mu_32_28_y;
  const Scalar t171 = s_27 * mu_32_28_z - c_27 * t170;
  B[831] = B[1017] = -t171;
  const Scalar t172 = t103 + Scalar(0.0235906);
  const Scalar Ic_30_yy = Ic_31_zz - Scalar(0.0253235000000002);
  const Scalar t173 = s_30 * (t172 + Ic_30_yy) - Scalar(0.0014964) * c_30 * s_32 * t40;
  const Scalar t174 = s_30 * t173;
  const Scalar t175 = Scalar(-0.008) * t150;
  const Scalar t176 = Scalar(0.478) * hu_30_a_y;
  const Scalar t177 = t175 + t172 - t174 - t176 - Scalar(0.2298769000000002);
  B[924] = -t177;
  const Scalar t178 = t106 + Scalar(0.0235906);
  const Scalar Ic_23_yy = Ic_24_zz - Scalar(0.0253235000000002);
  const Scalar t179 = Scalar(0.0014964) * c_23 * s_25 * t32 + s_23 * (t178 + Ic_23_yy);
  const Scalar t180 = s_23 * t179;
  const Scalar t181 = Scalar(0.008) * t163;
  const Scalar t182 = Scalar(0.478) * hu_23_a_y;
  const Scalar t183 = t178 - t181 - t180 - t182 - Scalar(0.2298769000000002);
  B[693] = -t183;
  const Scalar t184 = s_22 * mu_23_22_y + c_22 * t164;
  const Scalar t185 = s_22 * t138;
  const Scalar t186 = t139 - Scalar(0.004) * t185;
  const Scalar t187 = s_21 * t138;
  const Scalar t188 = c_22 * t187 - c_21 * t163;
  const Scalar B_20_23 = Scalar(0.305) * t188 + s_21 * t186 - c_21 * t184;
  B[630] = B[723] = B_20_23;
  const Scalar t189 = c_20 * mu_24_21_z + s_20 * mu_24_20_x;
  const Scalar t190 = s_20 * f_u_24_21_t_x + c_20 * f_u_24_22_a_z;
  const Scalar t191 = s_19 * f_u_24_21_t_y + c_19 * t190;
  const Scalar t192 = s_20 * f_u_24_22_a_z - c_20 * f_u_24_21_t_x;
  const Scalar B_15_24 = s_19 * t189 - Scalar(0.24) * t191 + c_19 * mu_24_20_z +
      Scalar(0.33) * t192;
  B[471] = B[750] = B_15_24;
  const Scalar t193 = c_27 * mu_31_28_z + s_27 * mu_31_27_x;
  const Scalar t194 = s_27 * f_u_31_28_t_x + c_27 * f_u_31_29_a_z;
  const Scalar t195 = s_26 * f_u_31_28_t_y + c_26 * t194;
  const Scalar t196 = s_27 * f_u_31_29_a_z - c_27 * f_u_31_28_t_x;
  const Scalar B_15_31 = Scalar(0.24) * t195 + s_26 * t193 + c_26 * mu_31_27_z +
      Scalar(0.33) * t196;
  B[478] = B[974] = B_15_31;
  const Scalar t197 = c_27 * mu_32_28_z + s_27 * t170;
  const Scalar t198 = s_27 * f_u_32_28_t_x + c_27 * f_u_32_29_a_z;
  const Scalar t199 = s_26 * t169 + c_26 * t198;
  const Scalar t200 = s_27 * f_u_32_29_a_z - c_27 * f_u_32_28_t_x;
  const Scalar B_15_32 = Scalar(0.33) * t200 + Scalar(0.24) * t199 + s_26 * t197 +
      c_26 * mu_32_27_z;
  B[479] = B[1006] = B_15_32;
  const Scalar t201 = Scalar(0.00507) + Scalar(0.02) * hu_10_t_y + Ic_10_xy + c_10 * t154;
  const Scalar t202 = Scalar(0.08) + t128;
  const Scalar t203 = hu_12_t_x * t84 + c_9 * t202;
  const Scalar t204 = t108 * t84 + c_9 * t201 + Scalar(0.389) * t203;
  B[232] = B[263] = -t204;
  const Scalar t205 = Scalar(0.00507) + Scalar(0.02) * hu_4_t_y + Ic_4_xy + c_4 * t159;
  const Scalar t206 = Scalar(0.08) + t124;
  const Scalar t207 = hu_6_t_x * t70 + c_3 * t206;
  const Scalar t208 = t110 * t70 + c_3 * t205 + Scalar(0.389) * t207;
  B[34] = B[65] = -t208;
  const Scalar mu_u_25_20_t_x = c_20 * t121 + s_20 * t149;
  const Scalar f_u_25_20_t_x = s_20 * t146 + c_20 * f_u_25_22_t_y;
  const Scalar f_u_25_19_t_x = s_19 * t148 + c_19 * f_u_25_20_t_x;
  const Scalar t209 = s_20 * f_u_25_22_t_y - c_20 * t146;
  const Scalar t210 = Scalar(0.33) * t209 - Scalar(0.24) * f_u_25_19_t_x + s_19 * mu_u_25_20_t_x +
      c_19 * mu_u_25_20_a_y;
  B[472] = B[782] = -t210;
  const Scalar t211 = s_29 * mu_30_29_y + c_29 * t151;
  const Scalar t212 = s_29 * hu_30_t_y;
  const Scalar mu_30_28_y = mu_30_29_z - Scalar(0.004) * t212;
  const Scalar t213 = s_28 * hu_30_t_y;
  const Scalar t214 = c_29 * t213 + c_28 * t150;
  const Scalar t215 = Scalar(0.305) * t214 + s_28 * mu_30_28_y + c_28 * t211;
  B[861] = B[954] = -t215;
  const Scalar t216 = Scalar(0.004) * hu_30_t_y;
  const Scalar Ic_29_xz = t41 + t216 + c_30 * t173;
  const Scalar t217 = s_29 * Ic_29_xz - c_29 * mu_30_29_z;
  B[892] = B[923] = -t217;
  const Scalar t218 = Scalar(-0.004) * t138;
  const Scalar t219 = t218 - t33 + c_23 * t179;
  const Scalar t220 = s_22 * t219 + c_22 * t139;
  B[661] = B[692] = -t220;
  const Scalar t221 = c_21 * t138;
  const Scalar t222 = c_22 * t221 + s_21 * t163;
  const Scalar t223 = Scalar(0.305) * t222 + s_21 * t184 + c_21 * t186;
  const Scalar mu_u_23_20_t_y = s_20 * t166 - c_20 * t223;
  B[598] = B[722] = mu_u_23_20_t_y;
  const Scalar f_u_25_19_t_y = s_19 * f_u_25_20_t_x - c_19 * t148;
  const Scalar mu_25_15_x = Scalar(0.24) * f_u_25_19_t_y - s_19 * mu_u_25_20_a_y +
      c_19 * mu_u_25_20_t_x;
  const Scalar mu_25_15_y = mu_u_25_20_t_y - Scalar(0.33) * f_u_25_19_t_y;
  B[440] = B[781] = s_15 * mu_25_15_x + c_15 * mu_25_15_y;
  const Scalar t224 = s_26 * t194 - c_26 * f_u_31_28_t_y;
  const Scalar t225 = Scalar(0.24) * t224 + s_26 * mu_31_27_z - c_26 * t193;
  const Scalar t226 = t168 - Scalar(0.33) * t224;
  B[446] = B[973] = s_15 * t225 - c_15 * t226;
  const Scalar f_u_32_26_a_z = s_26 * t198 - c_26 * t169;
  const Scalar mu_32_15_x = Scalar(0.24) * f_u_32_26_a_z + s_26 * mu_32_27_z - c_26 * t197;
  const Scalar t227 = t171 - Scalar(0.33) * f_u_32_26_a_z;
  B[447] = B[1005] = s_15 * mu_32_15_x - c_15 * t227;
  const Scalar Iu_10_t_xx = Ic_10_yy - t155;
  const Scalar t228 = Scalar(0.02175666666667) + t156 + t56;
  const Scalar Iu_9_t_d = Iu_10_t_xx + t228;
  const Scalar t229 = t79 + t127;
  const Scalar t230 = Scalar(2.0) * t229 * t89 + s_9 * Iu_9_t_d;
  const Scalar t231 = s_9 * t230;
  const Scalar t232 = Scalar(0.778) * hu_10_t_y;
  B[231] = Iu_10_t_xx - t231 + t232 + Scalar(1.03820716666667);
  const Scalar Iu_4_t_xx = Ic_4_yy - t160;
  const Scalar t233 = Scalar(0.02175666666667) + t161 + t63;
  const Scalar Iu_3_t_d = Iu_4_t_xx + t233;
  const Scalar t234 = t65 + t123;
  const Scalar t235 = Scalar(2.0) * t234 * t75 + s_3 * Iu_3_t_d;
  const Scalar t236 = s_3 * t235;
  const Scalar t237 = Scalar(0.778) * hu_4_t_y;
  B[33] = Iu_4_t_xx - t236 + t237 + Scalar(1.03820716666667);
  const Scalar t238 = s_3 * t206 - hu_6_t_x * t75;
  const Scalar t239 = c_2 * (s_3 * t205 - t110 * t75 + Scalar(0.389) * t238);
  B[2] = B[64] = s_2 * t162 - t239;
  const Scalar t240 = s_9 * t202 - hu_12_t_x * t89;
  const Scalar t241 = c_8 * (s_9 * t201 - t108 * t89 + Scalar(0.389) * t240);
  B[200] = B[262] = s_8 * t157 - t241;
  const Scalar t242 = s_19 * t190 - c_19 * f_u_24_21_t_y;
  const Scalar t243 = Scalar(0.24) * t242 - s_19 * mu_24_20_z + c_19 * t189;
  const Scalar t244 = t167 - Scalar(0.33) * t242;
  B[439] = B[749] = -s_15 * t243 - c_15 * t244;
  const Scalar Iu_29_t_xz = c_29 * Ic_29_xz + s_29 * mu_30_29_z;
  const Scalar t245 = Scalar(0.0328) + t150;
  const Scalar hc_29_y = hu_30_a_y + Scalar(0.8648);
  const Scalar t246 = c_29 * t245 + s_29 * hc_29_y;
  const Scalar t247 = s_29 * t245 - c_29 * hc_29_y;
  const Scalar t248 = Scalar(0.004) * t246 + t177 + Scalar(0.305) * t247;
  const Scalar B_27_29 = c_28 * Iu_29_t_xz + s_28 * t248;
  B[860] = B[922] = B_27_29;
  const Scalar t249 = c_28 * hu_30_t_y;
  const Scalar t250 = s_28 * t150 - c_29 * t249;
  const Scalar t251 = Scalar(0.305) * t250 + s_28 * t211 - c_28 * mu_30_28_y;
  const Scalar t252 = s_27 * mu_30_28_z + c_27 * t251;
  B[829] = B[953] = -t252;
  const Scalar Ic_29_xx = Ic_30_yy - t174 + t176;
  const Scalar t253 = t175 + mu_u_30_30_a_y + Scalar(0.2262745000000002);
  const Scalar Iu_29_t_d = Ic_29_xx + t253;
  const Scalar Ic_29_xy = Scalar(0.004) * hu_30_a_y + Scalar(0.0050592) + t151;
  const Scalar t254 = Scalar(2.0) * s_29 * Ic_29_xy - c_29 * Iu_29_t_d;
  const Scalar t255 = c_29 * t254;
  const Scalar t256 = Scalar(-0.008) * t246;
  const Scalar Ic_28_zz = t256 + Ic_29_xx + t255 + Scalar(0.2360429000000002);
  B[891] = Ic_28_zz;
  const Scalar Ic_22_xx = Ic_23_yy - t180 + t182;
  const Scalar t257 = mu_u_23_23_a_y - t181 + Scalar(0.2262745000000002);
  const Scalar Iu_22_t_d = Ic_22_xx + t257;
  const Scalar Ic_22_xy = Scalar(0.004) * hu_23_a_y + Scalar(0.0050592) + t164;
  const Scalar t258 = Scalar(2.0) * s_22 * Ic_22_xy - c_22 * Iu_22_t_d;
  const Scalar t259 = c_22 * t258;
  const Scalar t260 = Scalar(0.0328) + t163;
  const Scalar hc_22_y = hu_23_a_y + Scalar(0.8648);
  const Scalar f_u_22_22_a_z = c_22 * t260 + s_22 * hc_22_y;
  const Scalar t261 = Scalar(0.008) * f_u_22_22_a_z;
  const Scalar B_21_21 = Ic_22_xx - t261 + t259 + Scalar(0.2360429000000002);
  B[660] = B_21_21;
  const Scalar t262 = s_22 * t139 - c_22 * t219;
  const Scalar t263 = s_22 * t260 - c_22 * hc_22_y;
  const Scalar t264 = Scalar(0.004) * f_u_22_22_a_z + t183 + Scalar(0.305) * t263;
  const Scalar t265 = c_21 * t262 - s_21 * t264;
  B[629] = B[691] = -t265;
  B[408] = B[780] = c_14 * (s_15 * mu_25_15_y - c_15 * mu_25_15_x) + s_14 * t210;
  const Scalar t266 = s_27 * t251 - c_27 * mu_30_28_z;
  const Scalar t267 = s_27 * t214 - c_27 * t212;
  const Scalar t268 = s_26 * t250 + c_26 * t267;
  const Scalar t269 = s_27 * t212 + c_27 * t214;
  const Scalar B_15_30 = Scalar(0.33) * t269 - Scalar(0.24) * t268 - s_26 * t266 - c_26 * t215;
  B[477] = B[942] = B_15_30;
  B[199] = B[230] = s_8 * t204 + c_8 * (c_9 * t230 - s_11 * t229);
  B[1] = B[32] = s_2 * t208 + c_2 * (c_3 * t235 - s_5 * t234);
  const Scalar t270 = s_21 * t262 + c_21 * t264;
  const Scalar mu_u_22_20_t_y = s_20 * t220 - c_20 * t270;
  B[597] = B[690] = mu_u_22_20_t_y;
  const Scalar mu_u_23_20_t_x = s_20 * t223 + c_20 * t166;
  const Scalar t271 = s_20 * t188 - c_20 * t185;
  const Scalar t272 = s_19 * t222 - c_19 * t271;
  const Scalar t273 = s_20 * t185 + c_20 * t188;
  const Scalar t274 = Scalar(0.33) * t273 - Scalar(0.24) * t272 + s_19 * mu_u_23_20_t_x -
      c_19 * B_20_23;
  B[470] = B[718] = -t274;
  const Scalar mu_u_24_15_t_x = s_15 * t244 - c_15 * t243;
  B[407] = B[748] = -c_14 * mu_u_24_15_t_x - s_14 * B_15_24;
  const Scalar mu_29_27_x = s_28 * Iu_29_t_xz - c_28 * t248;
  const Scalar mu_u_29_27_t_y = s_27 * t217 + c_27 * mu_29_27_x;
  B[828] = B[921] = mu_u_29_27_t_y;
  B[414] = B[972] = -c_14 * (c_15 * t225 + s_15 * t226) - s_14 * B_15_31;
  const Scalar mu_u_32_15_t_x = s_15 * t227 + c_15 * mu_32_15_x;
  B[415] = B[1004] = -c_14 * mu_u_32_15_t_x - s_14 * B_15_32;
  const Scalar t275 = Scalar(0.004) * t263 - Scalar(0.0023) + Ic_22_xy - s_22 * t258;
  const Scalar t276 = Scalar(0.0032) + f_u_22_22_a_z;
  const Scalar t277 = t187 - c_21 * t276;
  const Scalar B_20_21 = s_21 * t220 - c_21 * t275 + Scalar(0.305) * t277;
  B[628] = B[659] = B_20_21;
  const Scalar t278 = Scalar(0.004) * t247 - Scalar(0.0023) + Ic_29_xy - s_29 * t254;
  const Scalar t279 = Scalar(0.0032) + t246;
  const Scalar t280 = t213 + c_28 * t279;
  const Scalar t281 = c_28 * t278 - s_28 * t217 + Scalar(0.305) * t280;
  B[859] = B[890] = -t281;
  const Scalar t282 = c_20 * t220 + s_20 * t270;
  const Scalar t283 = s_21 * t263;
  const Scalar t284 = s_20 * t283 + c_20 * f_u_22_22_a_z;
  const Scalar t285 = c_21 * t263;
  const Scalar t286 = s_19 * t285 - c_19 * t284;
  const Scalar t287 = s_20 * f_u_22_22_a_z - c_20 * t283;
  const Scalar mu_22_15_z = Scalar(0.24) * t286 - s_19 * t282 + Scalar(0.33) * t287 - c_19 * t265;
  B[469] = B[686] = mu_22_15_z;
  const Scalar t288 = s_19 * t271 + c_19 * t222;
  const Scalar t289 = Scalar(0.24) * t288 - s_19 * B_20_23 - c_19 * mu_u_23_20_t_x;
  const Scalar mu_23_15_y = mu_u_23_20_t_y + Scalar(0.33) * t288;
  B[438] = B[717] = c_15 * mu_23_15_y - s_15 * t289;
  const Scalar t290 = s_27 * mu_29_27_x - c_27 * t217;
  const Scalar t291 = s_28 * t247;
  const Scalar t292 = s_27 * t291 + c_27 * t246;
  const Scalar t293 = c_28 * t247;
  const Scalar f_u_29_26_t_x = s_26 * t293 - c_26 * t292;
  const Scalar t294 = s_27 * t246 - c_27 * t291;
  const Scalar mu_29_15_z = s_26 * t290 - Scalar(0.24) * f_u_29_26_t_x + Scalar(0.33) * t294 +
      c_26 * B_27_29;
  B[476] = B[910] = mu_29_15_z;
  const Scalar f_u_30_26_t_y = s_26 * t267 - c_26 * t250;
  const Scalar t295 = Scalar(0.24) * f_u_30_26_t_y + s_26 * t215 - c_26 * t266;
  const Scalar t296 = t252 + Scalar(0.33) * f_u_30_26_t_y;
  B[445] = B[941] = -s_15 * t295 - c_15 * t296;
  B[406] = B[716] = s_14 * t274 + c_14 * (s_15 * mu_23_15_y + c_15 * t289);
  const Scalar t297 = t228 - t231 - t232;
  const Scalar t298 = s_8 * (s_8 * (t157 - t297 + Scalar(1.03624716666667)) - Scalar(2.0) * t241);
  B[198] = -t297 - t298 + Scalar(1.04016716666667);
  const Scalar t299 = t233 - t236 - t237;
  const Scalar t300 = s_2 * (s_2 * (t162 - t299 + Scalar(1.03624716666667)) - Scalar(2.0) * t239);
  B[0] = -t299 - t300 + Scalar(1.04016716666667);
  const Scalar t301 = t221 + s_21 * t276;
  const Scalar t302 = c_21 * t220 + s_21 * t275 + Scalar(0.305) * t301;
  const Scalar t303 = c_20 * t302;
  const Scalar t304 = t303 + s_20 * B_21_21;
  B[596] = B[658] = -t304;
  const Scalar t305 = s_28 * t279 - t249;
  const Scalar t306 = c_28 * t217 + s_28 * t278 + Scalar(0.305) * t305;
  const Scalar t307 = c_27 * t306;
  const Scalar t308 = t307 + s_27 * Ic_28_zz;
  B[827] = B[889] = -t308;
  const Scalar t309 = s_26 * t292 + c_26 * t293;
  const Scalar t310 = Scalar(0.24) * t309 - c_26 * t290 + s_26 * B_27_29;
  const Scalar mu_29_15_y = mu_u_29_27_t_y + Scalar(0.33) * t309;
  B[444] = B[909] = s_15 * t310 + c_15 * mu_29_15_y;
  B[413] = B[940] = -s_14 * B_15_30 - c_14 * (s_15 * t296 - c_15 * t295);
  const Scalar t311 = t255 + t253;
  const Scalar t312 = t177 - t256 + Scalar(0.2282085000000002);
  const Scalar t313 = t216 - Iu_29_t_xz;
  const Scalar t314 = Scalar(2.0) * c_28 * t313 + s_28 * (t311 - t312);
  const Scalar t315 = s_28 * t314;
  const Scalar t316 = Scalar(-0.61) * t247;
  const Scalar t317 = t311 - t315 - t316 - Scalar(0.7079407000000002);
  B[858] = -t317;
  const Scalar t318 = t259 + t257;
  const Scalar t319 = t261 + t183 + Scalar(0.2282085000000002);
  const Scalar t320 = t218 + t262;
  const Scalar t321 = Scalar(2.0) * c_21 * t320 + s_21 * (t318 - t319);
  const Scalar t322 = s_21 * t321;
  const Scalar t323 = Scalar(-0.61) * t263;
  const Scalar t324 = t318 - t322 - t323 - Scalar(0.7079407000000002);
  B[627] = -t324;
  const Scalar t325 = s_20 * t302 - c_20 * B_21_21;
  const Scalar t326 = c_19 * t277;
  const Scalar f_u_21_19_t_x = s_19 * t301 - s_20 * t326;
  const Scalar mu_21_15_z = Scalar(0.24) * f_u_21_19_t_x + c_19 * B_20_21 -
      Scalar(0.33) * c_20 * t277 - s_19 * t325;
  B[468] = B[654] = mu_21_15_z;
  const Scalar t327 = s_19 * t284 + c_19 * t285;
  const Scalar t328 = Scalar(0.24) * t327 - c_19 * t282 + s_19 * t265;
  const Scalar t329 = mu_u_22_20_t_y + Scalar(0.33) * t327;
  B[437] = B[685] = c_15 * t329 - s_15 * t328;
  const Scalar Iu_28_a_yz = t313 - c_28 * t314;
  const Scalar Iu_27_t_yz = s_27 * t281 + c_27 * Iu_28_a_yz;
  B[826] = B[857] = Iu_27_t_yz;
  const Scalar t330 = s_27 * t306 - c_27 * Ic_28_zz;
  const Scalar t331 = c_26 * t280;
  const Scalar t332 = s_27 * t331 + s_26 * t305;
  const Scalar t333 = Scalar(0.24) * t332 + c_26 * t281 - Scalar(0.33) * c_27 * t280 + s_26 * t330;
  B[475] = B[878] = -t333;
  const Scalar t334 = t320 - c_21 * t321;
  const Scalar t335 = s_20 * B_20_21 - c_20 * t334;
  B[595] = B[626] = -t335;
  B[405] = B[684] = c_14 * (s_15 * t329 + c_15 * t328) - s_14 * mu_22_15_z;
  B[412] = B[908] = c_14 * (s_15 * mu_29_15_y - c_15 * t310) - s_14 * mu_29_15_z;
  const Scalar t336 = s_19 * t277;
  const Scalar t337 = s_20 * t336 + c_19 * t301;
  const Scalar t338 = Scalar(0.24) * t337 - s_19 * B_20_21 - c_19 * t325;
  const Scalar t339 = t304 - Scalar(0.33) * t337;
  B[436] = B[653] = -s_15 * t338 - c_15 * t339;
  const Scalar t340 = s_26 * t280;
  const Scalar f_u_28_26_t_y = s_27 * t340 - c_26 * t305;
  const Scalar t341 = Scalar(0.24) * f_u_28_26_t_y + s_26 * t281 - c_26 * t330;
  const Scalar t342 = Scalar(0.33) * f_u_28_26_t_y + t308;
  B[443] = B[877] = -s_15 * t341 - c_15 * t342;
  const Scalar t343 = c_20 * B_20_21 + s_20 * t334;
  const Scalar t344 = s_19 * t343;
  const Scalar t345 = t263 - Scalar(1.661);
  const Scalar t346 = c_20 * t301 + s_20 * t345;
  const Scalar t347 = t324 - Scalar(0.24) * t346;
  const Scalar hu_20_t_x = s_20 * t301 - c_20 * t345;
  const Scalar mu_u_20_15_a_y = Scalar(0.33) * hu_20_t_x - t344 + c_19 * t347;
  B[467] = B[622] = -mu_u_20_15_a_y;
  const Scalar Iu_27_a_xz = s_27 * Iu_28_a_yz - c_27 * t281;
  const Scalar t348 = s_26 * Iu_27_a_xz;
  const Scalar t349 = t247 - Scalar(1.661);
  const Scalar t350 = c_27 * t305 + s_27 * t349;
  const Scalar t351 = Scalar(0.24) * t350 + t317;
  const Scalar hu_27_t_x = s_27 * t305 - c_27 * t349;
  const Scalar mu_u_27_15_a_y = Scalar(0.33) * hu_27_t_x - t348 + c_26 * t351;
  B[474] = B[846] = -mu_u_27_15_a_y;
  B[411] = B[876] = s_14 * t333 - c_14 * (s_15 * t342 - c_15 * t341);
  const Scalar t352 = t315 + t312 - t316;
  const Scalar Ic_27_yy = Ic_28_zz - Scalar(0.7059807000000002);
  const Scalar t353 = Scalar(2.0) * t307 + s_27 * (t352 + Ic_27_yy);
  const Scalar t354 = s_27 * t353;
  const Scalar t355 = t352 - t354 - Scalar(0.7099007000000002);
  B[825] = -t355;
  const Scalar t356 = t322 + t319 - t323;
  const Scalar t357 = B_21_21 - Scalar(0.7059807000000002);
  const Scalar t358 = Scalar(2.0) * t303 + s_20 * (t356 + t357);
  const Scalar t359 = s_20 * t358;
  const Scalar t360 = t356 - t359 - Scalar(0.7099007000000002);
  B[594] = -t360;
  const Scalar mu_u_21_15_t_x = s_15 * t339 - c_15 * t338;
  B[404] = B[652] = -s_14 * mu_21_15_z - c_14 * mu_u_21_15_t_x;
  const Scalar t361 = t306 - c_27 * t353;
  const Scalar t362 = t331 + s_26 * hu_27_t_x;
  const Scalar B_15_26 = Scalar(0.24) * t362 + c_26 * Iu_27_t_yz + s_26 * t361;
  B[473] = B[814] = B_15_26;
  const Scalar t363 = c_19 * t343 + s_19 * t347;
  const Scalar t364 = t335 + Scalar(0.33) * s_19 * t346;
  B[435] = B[621] = -c_15 * t364 - s_15 * t363;
  const Scalar t365 = c_26 * Iu_27_a_xz + s_26 * t351;
  const Scalar mu_27_15_y = Iu_27_t_yz - Scalar(0.33) * s_26 * t350;
  B[442] = B[845] = c_15 * mu_27_15_y - s_15 * t365;
  const Scalar t366 = t302 - c_20 * t358;
  const Scalar hu_19_t_y = s_19 * hu_20_t_x - t326;
  const Scalar t367 = Scalar(0.24) * hu_19_t_y + c_19 * t335 - s_19 * t366;
  B[466] = B[590] = -t367;
  B[403] = B[620] = s_14 * mu_u_20_15_a_y - c_14 * (s_15 * t364 - c_15 * t363);
  B[410] = B[844] = c_14 * (s_15 * mu_27_15_y + c_15 * t365) + s_14 * mu_u_27_15_a_y;
  const Scalar hu_19_t_x = t336 + c_19 * hu_20_t_x;
  const Scalar t368 = Scalar(0.24) * hu_19_t_x - s_19 * t335 - c_19 * t366;
  const Scalar t369 = Scalar(0.33) * hu_19_t_x + t360;
  B[434] = B[589] = s_15 * t368 - c_15 * t369;
  const Scalar t370 = t340 - c_26 * hu_27_t_x;
  const Scalar t371 = Scalar(0.24) * t370 + s_26 * Iu_27_t_yz - c_26 * t361;
  const Scalar t372 = t355 - Scalar(0.33) * t370;
  B[441] = B[813] = s_15 * t371 - c_15 * t372;
  const Scalar t373 = t357 - t359;
  const Scalar t374 = t324 + Scalar(0.7079407000000002);
  const Scalar t375 = Scalar(2.0) * t344 - c_19 * (t373 + t374);
  const Scalar Iu_27_t_xx = Ic_27_yy - t354;
  const Scalar t376 = t317 + Scalar(0.7079407000000002);
  const Scalar Iu_26_t_d = Iu_27_t_xx + t376;
  const Scalar t377 = Scalar(2.0) * t348 - c_26 * Iu_26_t_d;
  const Scalar t378 = c_19 * t375 + c_26 * t377;
  const Scalar t379 = Scalar(0.906) * t42 + Scalar(0.66) * (t370 - hu_19_t_x);
  const Scalar t380 = Scalar(-0.48) * (t350 - t346);
  const Scalar Iu_17_t_xx = Scalar(0.0002) + t28;
  const Scalar Iu_16_t_d = t11 + Iu_17_t_xx;
  const Scalar Iu_16_t_g = Scalar(2.0) * t45 + c_16 * Iu_16_t_d;
  const Scalar t381 = c_16 * Iu_16_t_g;
  const Scalar Ic_15_zz = Iu_17_t_xx - t381 + Iu_27_t_xx + t373 + t380 + t379 + t378 +
      Scalar(5.512820899999667);
  B[462] = Ic_15_zz;
  const Scalar mu_u_19_15_t_x = c_15 * t368 + s_15 * t369;
  B[402] = B[588] = s_14 * t367 - c_14 * mu_u_19_15_t_x;
  B[409] = B[812] = -s_14 * B_15_26 - c_14 * (c_15 * t371 + s_15 * t372);
  const Scalar t382 = c_17 * t113 - t112 - Scalar(0.043998) + Iu_27_a_xz + t343 +
      Scalar(0.33) * (t362 + hu_19_t_y) - s_19 * t375 - s_26 * t377;
  const Scalar t383 = Scalar(0.003) * t140 - s_16 * Iu_16_t_g + s_17 * Iu_18_a_yz - t367 + B_15_26;
  const Scalar Iu_15_a_xy = s_15 * t382 - c_15 * t383;
  B[430] = B[461] = -Iu_15_a_xy;
  const Scalar t384 = c_14 * (s_15 * t383 + c_15 * t382);
  B[398] = B[460] = t384 - s_14 * Ic_15_zz;
  const Scalar t385 = Scalar(0.006) * hu_16_a_z;
  const Scalar t386 = t385 - Ic_16_zz - t380 + t376 + t374 + t378;
  const Scalar t387 = t385 + t11 - t381 - t379 - Scalar(0.5912714333326666) + t355 + t360;
  const Scalar t388 = -t141 - t368 - t371 + Scalar(0.33) * (t350 + t346);
  const Scalar t389 = Scalar(2.0) * s_15 * t388 - c_15 * (t386 - t387);
  const Scalar t390 = c_15 * t389;
  B[429] = Scalar(2.5075600666670006) - t390 - t386;
  B[397] = B[428] = s_14 * Iu_15_a_xy + c_14 * (t388 - s_15 * t389);
  const Scalar t391 = t387 - t390;
  const Scalar t392 = s_14 * (s_14 * (t391 - Scalar(2.5051100666670005) + Ic_15_zz) -
      Scalar(2.0) * t384);
  B[396] = t392 - t391 + Scalar(2.5107600666670002);
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

// Gravity torques g(q) (7.39).
//   q[32]  in   joint positions, rad or m
//   g[32]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11], q[13..31]. Operations: 237 mul, 133 add, 62 sin/cos. Always zero: g[12].
template <class Scalar, class SinCos = LibrarySinCos>
inline void gravity(const Scalar* q, Scalar* g, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6], s_8 = sine[7],
      c_8 = cosine[7], s_9 = sine[8], c_9 = cosine[8], s_10 = sine[9], c_10 = cosine[9],
      s_11 = sine[10], c_11 = cosine[10], s_12 = sine[11], c_12 = cosine[11], s_14 = sine[13],
      c_14 = cosine[13], s_15 = sine[14], c_15 = cosine[14], s_16 = sine[15], c_16 = cosine[15],
      s_17 = sine[16], c_17 = cosine[16], s_18 = sine[17], c_18 = cosine[17], s_19 = sine[18],
      c_19 = cosine[18], s_20 = sine[19], c_20 = cosine[19], s_21 = sine[20], c_21 = cosine[20],
      s_22 = sine[21], c_22 = cosine[21], s_23 = sine[22], c_23 = cosine[22], s_24 = sine[23],
      c_24 = cosine[23], s_25 = sine[24], c_25 = cosine[24], s_26 = sine[25], c_26 = cosine[25],
      s_27 = sine[26], c_27 = cosine[26], s_28 = sine[27], c_28 = cosine[27], s_29 = sine[28],
      c_29 = cosine[28], s_30 = sine[29], c_30 = cosine[29], s_31 = sine[30], c_31 = cosine[30],
      s_32 = sine[31], c_32 = cosine[31];
  const Scalar t1 = Scalar(2.1582) * c_18 - Scalar(0.1962) * s_18;
  const Scalar t2 = s_17 * t1;
  const Scalar hu_18_a_z = Scalar(0.1962) * c_18 + Scalar(2.1582) * s_18;
  const Scalar hu_16_a_z = s_16 * t2 + c_16 * hu_18_a_z;
  const Scalar t3 = c_14 * s_15;
  const Scalar t4 = s_16 * hu_18_a_z - c_16 * t2;
  g[15] = hu_16_a_z * t3 + s_14 * t4;
  const Scalar t5 = c_16 * t3 + s_14 * s_16;
  const Scalar t6 = c_17 * t1;
  const Scalar t7 = c_14 * c_15;
  g[16] = -t6 * t5 - t2 * t7;
  const Scalar t8 = c_1 * s_2;
  const Scalar t9 = s_3 * t8 - s_1 * c_3;
  const Scalar t10 = c_1 * c_2;
  const Scalar g_4_x = s_4 * t9 + c_4 * t10;
  const Scalar hu_6_t_x = Scalar(0.44145) * s_6 + Scalar(1.03005) * c_6;
  const Scalar t11 = s_5 * hu_6_t_x;
  const Scalar t12 = c_3 * t8 + s_1 * s_3;
  const Scalar t13 = c_5 * hu_6_t_x;
  g[4] = t11 * g_4_x + t13 * t12;
  const Scalar t14 = c_7 * s_8;
  const Scalar t15 = s_9 * t14 - s_7 * c_9;
  const Scalar t16 = c_7 * c_8;
  const Scalar g_10_x = s_10 * t15 + c_10 * t16;
  const Scalar hu_12_t_x = Scalar(0.44145) * s_12 + Scalar(1.03005) * c_12;
  const Scalar t17 = s_11 * hu_12_t_x;
  const Scalar t18 = c_9 * t14 + s_7 * s_9;
  const Scalar t19 = c_11 * hu_12_t_x;
  g[10] = t17 * g_10_x + t19 * t18;
  const Scalar t20 = hu_18_a_z * (s_17 * t5 - c_17 * t7);
  g[17] = t20 + t1 * (s_16 * t3 - s_14 * c_16);
  const Scalar hc_4_x = t13 + Scalar(13.464225);
  const Scalar hu_6_a_z = Scalar(0.44145) * c_6 - Scalar(1.03005) * s_6;
  const Scalar t21 = hu_6_a_z + Scalar(2.1582);
  const Scalar hu_4_t_y = s_4 * t21 + c_4 * hc_4_x;
  const Scalar t22 = s_4 * hc_4_x - c_4 * t21;
  g[3] = t22 * t10 - hu_4_t_y * t9;
  const Scalar hc_10_x = t19 + Scalar(13.464225);
  const Scalar hu_12_a_z = Scalar(0.44145) * c_12 - Scalar(1.03005) * s_12;
  const Scalar t23 = hu_12_a_z + Scalar(2.1582);
  const Scalar hu_10_t_y = s_10 * t23 + c_10 * hc_10_x;
  const Scalar t24 = s_10 * hc_10_x - c_10 * t23;
  g[9] = t24 * t16 - hu_10_t_y * t15;
  const Scalar g_5_a_z = s_4 * t10 - c_4 * t9;
  g[5] = hu_6_a_z * (s_5 * t12 - c_5 * g_4_x) + hu_6_t_x * g_5_a_z;
  const Scalar g_11_a_z = s_10 * t16 - c_10 * t15;
  g[11] = hu_12_a_z * (s_11 * t18 - c_11 * g_10_x) + hu_12_t_x * g_11_a_z;
  const Scalar t25 = Scalar(0.092214) * c_25;
  const Scalar hu_24_t_x = c_24 * t25 + Scalar(1.865862) * s_24;
  const Scalar t26 = Scalar(0.092214) * s_25;
  const Scalar t27 = c_23 * t26 + s_23 * hu_24_t_x;
  const Scalar t28 = Scalar(0.321768) + t27;
  const Scalar hu_23_a_y = Scalar(1.865862) * c_24 - s_24 * t25;
  const Scalar hc_22_y = hu_23_a_y + Scalar(8.483688);
  const Scalar t29 = s_22 * t28 - c_22 * hc_22_y;
  const Scalar t30 = c_19 * t7 - s_14 * s_19;
  const Scalar t31 = s_20 * t30 + c_20 * t3;
  const Scalar g_20_a_z = s_19 * t7 + s_14 * c_19;
  const Scalar t32 = s_21 * t31 - c_21 * g_20_a_z;
  const Scalar t33 = c_22 * t28 + s_22 * hc_22_y;
  const Scalar g_20_y = s_20 * t3 - c_20 * t30;
  g[21] = t29 * t32 - t33 * g_20_y;
  const Scalar t34 = Scalar(0.092214) * c_32;
  const Scalar hu_31_t_x = Scalar(1.865862) * s_31 - c_31 * t34;
  const Scalar t35 = Scalar(0.092214) * s_32;
  const Scalar t36 = s_30 * hu_31_t_x - c_30 * t35;
  const Scalar t37 = Scalar(0.321768) + t36;
  const Scalar hu_30_a_y = s_31 * t34 + Scalar(1.865862) * c_31;
  const Scalar hc_29_y = hu_30_a_y + Scalar(8.483688);
  const Scalar t38 = s_29 * t37 - c_29 * hc_29_y;
  const Scalar t39 = c_26 * t7 - s_14 * s_26;
  const Scalar t40 = s_27 * t39 + c_27 * t3;
  const Scalar g_27_a_z = s_26 * t7 + s_14 * c_26;
  const Scalar t41 = s_28 * t40 - c_28 * g_27_a_z;
  const Scalar t42 = c_29 * t37 + s_29 * hc_29_y;
  const Scalar g_27_y = s_27 * t3 - c_27 * t39;
  g[28] = t38 * t41 - t42 * g_27_y;
  const Scalar t43 = Scalar(0.7848) + t22;
  const Scalar t44 = s_3 * t43 - c_3 * t11;
  const Scalar t45 = hu_4_t_y + Scalar(27.463095);
  const Scalar hu_2_t_y = s_2 * t45 - c_2 * t44;
  g[1] = c_1 * hu_2_t_y;
  const Scalar t46 = s_3 * t11 + c_3 * t43;
  g[2] = -t46 * t8 - s_1 * t44;
  const Scalar t47 = Scalar(0.7848) + t24;
  const Scalar t48 = s_9 * t47 - c_9 * t17;
  const Scalar t49 = hu_10_t_y + Scalar(27.463095);
  const Scalar hu_8_t_y = s_8 * t49 - c_8 * t48;
  g[7] = c_7 * hu_8_t_y;
  const Scalar t50 = s_9 * t17 + c_9 * t47;
  g[8] = -t50 * t14 - s_7 * t48;
  const Scalar t51 = s_22 * g_20_y + c_22 * t32;
  const Scalar t52 = s_23 * t26 - c_23 * hu_24_t_x;
  const Scalar t53 = s_21 * g_20_a_z + c_21 * t31;
  g[22] = t52 * t51 - t27 * t53;
  const Scalar hu_2_t_x = s_2 * t44 + c_2 * t45;
  g[0] = c_1 * t46 + s_1 * hu_2_t_x;
  const Scalar hu_8_t_x = s_8 * t48 + c_8 * t49;
  g[6] = c_7 * t50 + s_7 * hu_8_t_x;
  const Scalar t54 = s_29 * g_27_y + c_29 * t41;
  const Scalar hu_30_t_y = s_30 * t35 + c_30 * hu_31_t_x;
  const Scalar t55 = s_28 * g_27_a_z + c_28 * t40;
  g[29] = -hu_30_t_y * t54 - t36 * t55;
  const Scalar t56 = Scalar(0.031392) + t33;
  const Scalar t57 = s_21 * t52 - c_21 * t56;
  const Scalar t58 = c_21 * t52 + s_21 * t56;
  g[20] = t57 * t31 - t58 * g_20_a_z;
  const Scalar t59 = s_23 * t51 - c_23 * t53;
  const Scalar t60 = s_22 * t32 - c_22 * g_20_y;
  g[23] = hu_24_t_x * t60 - hu_23_a_y * t59;
  const Scalar t61 = Scalar(0.031392) + t42;
  const Scalar t62 = s_28 * hu_30_t_y + c_28 * t61;
  const Scalar t63 = s_28 * t61 - c_28 * hu_30_t_y;
  g[27] = -t62 * t40 - t63 * g_27_a_z;
  const Scalar t64 = s_30 * t54 - c_30 * t55;
  const Scalar t65 = s_29 * t41 - c_29 * g_27_y;
  g[30] = hu_31_t_x * t65 - hu_30_a_y * t64;
  const Scalar t66 = t35 * (s_31 * t65 - c_31 * t64);
  g[31] = t66 + t34 * (s_30 * t55 + c_30 * t54);
  const Scalar t67 = t29 - Scalar(16.29441);
  const Scalar t68 = c_20 * t58 + s_20 * t67;
  const Scalar hu_20_t_x = s_20 * t58 - c_20 * t67;
  g[19] = hu_20_t_x * t3 - t68 * t30;
  const Scalar t69 = t26 * (s_24 * t60 - c_24 * t59);
  g[24] = -t69 - t25 * (s_23 * t53 + c_23 * t51);
  const Scalar t70 = t38 - Scalar(16.29441);
  const Scalar t71 = c_27 * t63 + s_27 * t70;
  const Scalar hu_27_t_x = s_27 * t63 - c_27 * t70;
  g[26] = hu_27_t_x * t3 - t71 * t39;
  const Scalar hu_19_t_y = s_19 * hu_20_t_x - c_19 * t57;
  const Scalar hu_19_t_x = s_19 * t57 + c_19 * hu_20_t_x;
  g[18] = hu_19_t_y * t7 + s_14 * hu_19_t_x;
  const Scalar t72 = c_26 * t62 + s_26 * hu_27_t_x;
  const Scalar t73 = s_26 * t62 - c_26 * hu_27_t_x;
  g[25] = t72 * t7 - s_14 * t73;
  const Scalar t74 = t6 + t73 - hu_19_t_x + Scalar(89.72226);
  const Scalar t75 = t71 - t4 + t68;
  const Scalar hu_15_t_x = s_15 * t75 - c_15 * t74;
  g[13] = c_14 * (-hu_16_a_z - Scalar(1.87371) + t72 + hu_19_t_y) + s_14 * hu_15_t_x;
  g[14] = -c_14 * (c_15 * t75 + s_15 * t74);
  g[12] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[32]   in   joint positions, rad or m
//   qd[32]  in   joint velocities, rad/s or m/s
//   n[32]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11], q[13..31], qd[0..31]. Operations: 1121 mul, 817 add, 62 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11],
      qd_13 = qd[12], qd_14 = qd[13], qd_15 = qd[14], qd_16 = qd[15], qd_17 = qd[16],
      qd_18 = qd[17], qd_19 = qd[18], qd_20 = qd[19], qd_21 = qd[20], qd_22 = qd[21],
      qd_23 = qd[22], qd_24 = qd[23], qd_25 = qd[24], qd_26 = qd[25], qd_27 = qd[26],
      qd_28 = qd[27], qd_29 = qd[28], qd_30 = qd[29], qd_31 = qd[30], qd_32 = qd[31];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6], s_8 = sine[7],
      c_8 = cosine[7], s_9 = sine[8], c_9 = cosine[8], s_10 = sine[9], c_10 = cosine[9],
      s_11 = sine[10], c_11 = cosine[10], s_12 = sine[11], c_12 = cosine[11], s_14 = sine[13],
      c_14 = cosine[13], s_15 = sine[14], c_15 = cosine[14], s_16 = sine[15], c_16 = cosine[15],
      s_17 = sine[16], c_17 = cosine[16], s_18 = sine[17], c_18 = cosine[17], s_19 = sine[18],
      c_19 = cosine[18], s_20 = sine[19], c_20 = cosine[19], s_21 = sine[20], c_21 = cosine[20],
      s_22 = sine[21], c_22 = cosine[21], s_23 = sine[22], c_23 = cosine[22], s_24 = sine[23],
      c_24 = cosine[23], s_25 = sine[24], c_25 = cosine[24], s_26 = sine[25], c_26 = cosine[25],
      s_27 = sine[26], c_27 = cosine[26], s_28 = sine[27], c_28 = cosine[27], s_29 = sine[28],
      c_29 = cosine[28], s_30 = sine[29], c_30 = cosine[29], s_31 = sine[30], c_31 = cosine[30],
      s_32 = sine[31], c_32 = cosine[31];
  const Scalar t1 = c_14 * c_15;
  const Scalar t2 = s_15 * qd_14 - qd_13 * t1;
  const Scalar t3 = qd_13 * qd_14;
  const Scalar t4 = s_14 * t3;
  const Scalar t5 = qd_15 * t2 + s_15 * t4;
  const Scalar t6 = s_14 * qd_13;
  const Scalar omega_15_z = qd_15 - t6;
  const Scalar t7 = t2 * omega_15_z;
  const Scalar U_15_zx = t5 + t7;
  const Scalar t8 = c_14 * s_15;
  const Scalar omega_r_15_y = qd_13 * t8 + c_15 * qd_14;
  const Scalar t9 = omega_r_15_y * omega_r_15_y;
  const Scalar t10 = t2 * t2;
  const Scalar t11 = t9 + t10;
  const Scalar t12 = Scalar(9.81) * s_14;
  const Scalar ddp_16_a_y = Scalar(0.453) * U_15_zx - Scalar(0.003) * t11 + t12;
  const Scalar domega_15_x = qd_15 * omega_r_15_y + c_15 * t4;
  const Scalar t13 = omega_r_15_y * omega_15_z;
  const Scalar t14 = domega_15_x - t13;
  const Scalar t15 = t2 * omega_r_15_y;
  const Scalar t16 = c_14 * t3;
  const Scalar t17 = t15 - t16;
  const Scalar t18 = Scalar(9.81) * t8;
  const Scalar t19 = Scalar(0.453) * t17 - Scalar(0.003) * t14 - t18;
  const Scalar ddp_16_x = s_16 * ddp_16_a_y - c_16 * t19;
  const Scalar t20 = omega_15_z * omega_15_z;
  const Scalar t21 = t9 + t20;
  const Scalar t22 = Scalar(9.81) * t1;
  const Scalar t23 = Scalar(0.003) * (t5 - t7) + Scalar(0.453) * t21 - t22;
  const Scalar t24 = s_17 * ddp_16_x + c_17 * t23;
  const Scalar ddp_16_y = s_16 * t19 + c_16 * ddp_16_a_y;
  const Scalar t25 = s_18 * t24 - c_18 * ddp_16_y;
  const Scalar t26 = s_18 * ddp_16_y + c_18 * t24;
  const Scalar t27 = s_16 * omega_15_z - c_16 * omega_r_15_y;
  const Scalar omega_16_z = qd_16 - t2;
  const Scalar t28 = s_17 * t27 + c_17 * omega_16_z;
  const Scalar omega_r_17_a_z = s_16 * omega_r_15_y + c_16 * omega_15_z;
  const Scalar omega_17_z = qd_17 + omega_r_17_a_z;
  const Scalar t29 = s_18 * omega_17_z + c_18 * t28;
  const Scalar omega_r_17_y = s_17 * omega_16_z - c_17 * t27;
  const Scalar omega_18_z = qd_18 + omega_r_17_y;
  const Scalar t30 = omega_18_z * omega_18_z;
  const Scalar t31 = t29 * t29 + t30;
  const Scalar t32 = s_18 * t28 - c_18 * omega_17_z;
  const Scalar t33 = t32 * t32 + t30;
  const Scalar t34 = t32 * t29;
  const Scalar t35 = c_16 * t5 - s_16 * t16 + qd_16 * omega_r_17_a_z;
  const Scalar t36 = qd_17 * t28 - s_17 * domega_15_x - c_17 * t35;
  const Scalar n_18 = Scalar(0.02) * t26 - Scalar(0.0022) * (t31 - t33) - Scalar(0.024) * t34 +
      Scalar(0.03408) * t36 + Scalar(0.22) * t25;
  n[17] = n_18;
  const Scalar t37 = c_2 * qd_1;
  const Scalar omega_r_3_x = s_3 * t37 + c_3 * qd_2;
  const Scalar t38 = s_2 * qd_1;
  const Scalar omega_3_z = qd_3 - t38;
  const Scalar t39 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar t40 = s_3 * qd_2 - c_3 * t37;
  const Scalar t41 = qd_2 * t38;
  const Scalar t42 = qd_3 * t40 + s_3 * t41;
  const Scalar t43 = qd_2 * t37;
  const Scalar domega_4_x = s_4 * t42 + c_4 * t43 + qd_4 * t39;
  const Scalar omega_4_z = qd_4 - t40;
  const Scalar t44 = t39 * omega_4_z;
  const Scalar U_4_zy = domega_4_x + t44;
  const Scalar ddp_3_a_y = Scalar(9.81) * s_1 - Scalar(0.778) * t41;
  const Scalar t45 = t37 * t38;
  const Scalar t46 = Scalar(9.81) * c_1;
  const Scalar ddp_o_3_x = Scalar(0.389) * t45 + s_2 * t46;
  const Scalar ddp_3_y = c_3 * ddp_o_3_x + s_3 * ddp_3_a_y;
  const Scalar t47 = omega_r_3_x * t40;
  const Scalar t48 = t47 + t43;
  const Scalar ddp_o_4_y = Scalar(0.02) * t48 + ddp_3_y;
  const Scalar t49 = ddp_o_4_y - Scalar(0.04) * U_4_zy;
  const Scalar t50 = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar domega_4_y = c_4 * t42 - s_4 * t43 + qd_4 * t50;
  const Scalar t51 = t50 * omega_4_z;
  const Scalar t52 = domega_4_y + t51;
  const Scalar t53 = Scalar(0.357) * t52 - t49;
  const Scalar t54 = qd_3 * omega_r_3_x + c_3 * t41;
  const Scalar t55 = omega_r_3_x * omega_3_z;
  const Scalar U_3_zx = t54 + t55;
  const Scalar ddp_o_3_y = Scalar(0.389) * (t37 * t37 + qd_2 * qd_2) + c_2 * t46;
  const Scalar ddp_o_4_z = ddp_o_3_y - Scalar(0.02) * U_3_zx;
  const Scalar t56 = omega_3_z * omega_3_z;
  const Scalar t57 = t40 * t40 + t56;
  const Scalar t58 = Scalar(0.02) * t57 + s_3 * ddp_o_3_x - c_3 * ddp_3_a_y;
  const Scalar t59 = s_4 * t58 + c_4 * ddp_o_4_z;
  const Scalar t60 = omega_4_z * omega_4_z;
  const Scalar t61 = t60 + t39 * t39;
  const Scalar t62 = t50 * t39;
  const Scalar U_4_xy = t54 - t62;
  const Scalar t63 = Scalar(0.04) * U_4_xy + t59 + Scalar(0.357) * t61;
  const Scalar t64 = s_5 * t53 + c_5 * t63;
  const Scalar t65 = s_4 * ddp_o_4_z - c_4 * t58;
  const Scalar t66 = t54 + t62;
  const Scalar t67 = t60 + t50 * t50;
  const Scalar t68 = Scalar(0.04) * t67 + t65 - Scalar(0.357) * t66;
  const Scalar t69 = s_6 * t64 + c_6 * t68;
  const Scalar t70 = s_6 * t68 - c_6 * t64;
  const Scalar t71 = s_5 * omega_4_z - c_5 * t50;
  const Scalar omega_5_z = qd_5 - t39;
  const Scalar t72 = s_6 * omega_5_z - c_6 * t71;
  const Scalar omega_r_5_y = s_5 * t50 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t73 = omega_6_z * omega_6_z;
  const Scalar t74 = t72 * t72 + t73;
  const Scalar omega_r_6_x = s_6 * t71 + c_6 * omega_5_z;
  const Scalar t75 = omega_r_6_x * omega_r_6_x + t73;
  const Scalar t76 = omega_r_6_x * t72;
  const Scalar t77 = c_5 * t54 + qd_5 * t71 + s_5 * domega_4_x;
  const Scalar t78 = Scalar(-0.0012) * t76 - Scalar(0.00315) * (t74 - t75) +
      Scalar(0.01431666666667) * t77 - Scalar(0.045) * t70 - Scalar(0.105) * t69;
  n[5] = -t78;
  const Scalar t79 = c_8 * qd_7;
  const Scalar omega_r_9_x = s_9 * t79 + c_9 * qd_8;
  const Scalar t80 = s_8 * qd_7;
  const Scalar omega_9_z = qd_9 - t80;
  const Scalar t81 = s_10 * omega_9_z - c_10 * omega_r_9_x;
  const Scalar t82 = s_9 * qd_8 - c_9 * t79;
  const Scalar t83 = qd_8 * t80;
  const Scalar t84 = qd_9 * t82 + s_9 * t83;
  const Scalar t85 = qd_8 * t79;
  const Scalar domega_10_x = s_10 * t84 + c_10 * t85 + qd_10 * t81;
  const Scalar omega_10_z = qd_10 - t82;
  const Scalar t86 = t81 * omega_10_z;
  const Scalar U_10_zy = domega_10_x + t86;
  const Scalar ddp_9_a_y = Scalar(9.81) * s_7 - Scalar(0.778) * t83;
  const Scalar t87 = t79 * t80;
  const Scalar t88 = Scalar(9.81) * c_7;
  const Scalar ddp_o_9_x = Scalar(0.389) * t87 + s_8 * t88;
  const Scalar ddp_9_y = c_9 * ddp_o_9_x + s_9 * ddp_9_a_y;
  const Scalar t89 = omega_r_9_x * t82;
  const Scalar t90 = t89 + t85;
  const Scalar ddp_o_10_y = Scalar(0.02) * t90 + ddp_9_y;
  const Scalar t91 = ddp_o_10_y - Scalar(0.04) * U_10_zy;
  const Scalar t92 = s_10 * omega_r_9_x + c_10 * omega_9_z;
  const Scalar domega_10_y = c_10 * t84 - s_10 * t85 + qd_10 * t92;
  const Scalar t93 = t92 * omega_10_z;
  const Scalar t94 = domega_10_y + t93;
  const Scalar t95 = Scalar(0.357) * t94 - t91;
  const Scalar t96 = qd_9 * omega_r_9_x + c_9 * t83;
  const Scalar t97 = omega_r_9_x * omega_9_z;
  const Scalar U_9_zx = t96 + t97;
  const Scalar ddp_o_9_y = Scalar(0.389) * (t79 * t79 + qd_8 * qd_8) + c_8 * t88;
  const Scalar ddp_o_10_z = ddp_o_9_y - Scalar(0.02) * U_9_zx;
  const Scalar t98 = omega_9_z * omega_9_z;
  const Scalar t99 = t82 * t82 + t98;
  const Scalar t100 = Scalar(0.02) * t99 + s_9 * ddp_o_9_x - c_9 * ddp_9_a_y;
  const Scalar t101 = s_10 * t100 + c_10 * ddp_o_10_z;
  const Scalar t102 = omega_10_z * omega_10_z;
  const Scalar t103 = t102 + t81 * t81;
  const Scalar t104 = t92 * t81;
  const Scalar U_10_xy = t96 - t104;
  const Scalar t105 = Scalar(0.04) * U_10_xy + t101 + Scalar(0.357) * t103;
  const Scalar t106 = s_11 * t95 + c_11 * t105;
  const Scalar t107 = s_10 * ddp_o_10_z - c_10 * t100;
  const Scalar t108 = t96 + t104;
  const Scalar t109 = t102 + t92 * t92;
  const Scalar t110 = Scalar(0.04) * t109 + t107 - Scalar(0.357) * t108;
  const Scalar t111 = s_12 * t106 + c_12 * t110;
  const Scalar t112 = s_12 * t110 - c_12 * t106;
  const Scalar t113 = s_11 * omega_10_z - c_11 * t92;
  const Scalar omega_11_z = qd_11 - t81;
  const Scalar t114 = s_12 * omega_11_z - c_12 * t113;
  const Scalar omega_r_11_y = s_11 * t92 + c_11 * omega_10_z;
  const Scalar omega_12_z = qd_12 + omega_r_11_y;
  const Scalar t115 = omega_12_z * omega_12_z;
  const Scalar t116 = t114 * t114 + t115;
  const Scalar omega_r_12_x = s_12 * t113 + c_12 * omega_11_z;
  const Scalar t117 = omega_r_12_x * omega_r_12_x + t115;
  const Scalar t118 = omega_r_12_x * t114;
  const Scalar t119 = c_11 * t96 + qd_11 * t113 + s_11 * domega_10_x;
  const Scalar t120 = Scalar(-0.0012) * t118 - Scalar(0.00315) * (t116 - t117) +
      Scalar(0.01431666666667) * t119 - Scalar(0.045) * t112 - Scalar(0.105) * t111;
  n[11] = -t120;
  const Scalar domega_17_x = c_17 * domega_15_x + qd_17 * omega_r_17_y - s_17 * t35;
  const Scalar domega_16_y = s_16 * t5 + c_16 * t16 + qd_16 * t27;
  const Scalar t121 = qd_18 * t29 - s_18 * domega_17_x + c_18 * domega_16_y;
  const Scalar t122 = t29 * omega_18_z;
  const Scalar t123 = t121 + t122;
  const Scalar t124 = s_17 * t23 - c_17 * ddp_16_x;
  const Scalar t125 = t32 * omega_18_z;
  const Scalar t126 = Scalar(0.02) * t124 - Scalar(0.0022) * t123 + Scalar(0.01008) * t125;
  const Scalar t127 = qd_18 * t32 + s_18 * domega_16_y + c_18 * domega_17_x + t125;
  const Scalar t128 = Scalar(0.0022) * t127 - Scalar(0.024) * t121 - Scalar(0.03408) * t122 +
      Scalar(0.22) * t124;
  const Scalar mu_u_17_a_y = Scalar(0.01038) * domega_16_y - Scalar(0.00988) * t28 * omega_r_17_y +
      s_18 * t126 - c_18 * t128;
  n[16] = -mu_u_17_a_y;
  const Scalar t129 = s_11 * t105 - c_11 * t95;
  const Scalar domega_11_x = qd_11 * omega_r_11_y - s_11 * t96 + c_11 * domega_10_x;
  const Scalar t130 = qd_12 * t114 - s_12 * domega_11_x + c_12 * domega_10_y;
  const Scalar t131 = t114 * omega_12_z;
  const Scalar t132 = t130 + t131;
  const Scalar t133 = omega_r_12_x * omega_12_z;
  const Scalar t134 = Scalar(0.01311666666667) * t133 - Scalar(0.00315) * t132 +
      Scalar(0.045) * t129;
  const Scalar t135 = qd_12 * omega_r_12_x - s_12 * domega_10_y - c_12 * domega_11_x + t133;
  const Scalar t136 = Scalar(0.00315) * t135 - Scalar(0.0012) * t130 -
      Scalar(0.01431666666667) * t131 + Scalar(0.105) * t129;
  const Scalar mu_u_11_a_y = Scalar(0.00820666666667) * domega_10_y +
      Scalar(0.00756666666667) * t113 * omega_r_11_y - s_12 * t134 - c_12 * t136;
  n[10] = -mu_u_11_a_y;
  const Scalar t137 = s_5 * t63 - c_5 * t53;
  const Scalar domega_5_x = qd_5 * omega_r_5_y - s_5 * t54 + c_5 * domega_4_x;
  const Scalar t138 = qd_6 * t72 - s_6 * domega_5_x + c_6 * domega_4_y;
  const Scalar t139 = t72 * omega_6_z;
  const Scalar t140 = t138 + t139;
  const Scalar t141 = omega_r_6_x * omega_6_z;
  const Scalar t142 = Scalar(0.01311666666667) * t141 - Scalar(0.00315) * t140 +
      Scalar(0.045) * t137;
  const Scalar t143 = qd_6 * omega_r_6_x - s_6 * domega_4_y - c_6 * domega_5_x + t141;
  const Scalar t144 = Scalar(0.00315) * t143 - Scalar(0.0012) * t138 -
      Scalar(0.01431666666667) * t139 + Scalar(0.105) * t137;
  const Scalar mu_u_5_a_y = Scalar(0.00820666666667) * domega_4_y +
      Scalar(0.00756666666667) * t71 * omega_r_5_y - s_6 * t142 - c_6 * t144;
  n[4] = -mu_u_5_a_y;
  const Scalar t145 = Scalar(0.0005) * t28 * omega_17_z + n_18;
  const Scalar mu_17_x = Scalar(0.00988) * domega_17_x + c_18 * t126 +
      Scalar(0.01038) * omega_r_17_y * omega_17_z + s_18 * t128;
  const Scalar mu_u_16_x = Scalar(0.0005) * t27 * omega_r_17_a_z + Scalar(0.001125) * domega_15_x +
      c_17 * mu_17_x - s_17 * t145;
  n[15] = -mu_u_16_x;
  const Scalar t146 = Scalar(0.00064) * t113 * omega_11_z + t120;
  const Scalar U_12_xy = t119 - t118;
  const Scalar t147 = Scalar(0.045) * t116 - Scalar(0.105) * U_12_xy;
  const Scalar t148 = Scalar(0.045) * (t119 + t118) + Scalar(0.105) * t117;
  const Scalar t149 = s_12 * t147 + c_12 * t148;
  const Scalar t150 = Scalar(0.045) * t135 - Scalar(0.105) * t132;
  const Scalar t151 = c_11 * t149 + s_11 * t150;
  const Scalar mu_11_x = Scalar(0.00756666666667) * domega_11_x +
      Scalar(0.00820666666667) * omega_r_11_y * omega_11_z - c_12 * t134 + s_12 * t136;
  const Scalar t152 = s_12 * t148 - c_12 * t147;
  const Scalar t153 = Scalar(0.04) * t151 + Scalar(0.357) * t152 - s_11 * mu_11_x + c_11 * t146 +
      Scalar(0.22) * t101 + Scalar(0.0549) * (t103 - t109) + Scalar(0.4393875) * t96 +
      Scalar(0.4092575) * t104 - Scalar(1.3725) * t107;
  n[9] = -t153;
  const Scalar t154 = Scalar(0.00064) * t71 * omega_5_z + t78;
  const Scalar U_6_xy = t77 - t76;
  const Scalar t155 = Scalar(0.045) * t74 - Scalar(0.105) * U_6_xy;
  const Scalar t156 = Scalar(0.045) * (t77 + t76) + Scalar(0.105) * t75;
  const Scalar t157 = s_6 * t155 + c_6 * t156;
  const Scalar t158 = Scalar(0.045) * t143 - Scalar(0.105) * t140;
  const Scalar t159 = c_5 * t157 + s_5 * t158;
  const Scalar mu_5_x = Scalar(0.00756666666667) * domega_5_x +
      Scalar(0.00820666666667) * omega_r_5_y * omega_5_z - c_6 * t142 + s_6 * t144;
  const Scalar t160 = s_6 * t156 - c_6 * t155;
  const Scalar t161 = Scalar(0.04) * t159 + Scalar(0.357) * t160 - s_5 * mu_5_x + c_5 * t154 +
      Scalar(0.22) * t59 + Scalar(0.0549) * (t61 - t67) + Scalar(0.4393875) * t54 +
      Scalar(0.4092575) * t62 - Scalar(1.3725) * t65;
  n[3] = -t161;
  const Scalar t162 = s_11 * t149 - c_11 * t150;
  const Scalar t163 = t162 + Scalar(1.3725) * t94;
  const Scalar t164 = Scalar(-0.04) * t163 - s_11 * t146 - c_11 * mu_11_x +
      Scalar(0.22) * ddp_o_10_y + Scalar(0.4092575) * domega_10_x - Scalar(0.4393875) * t86;
  const Scalar t165 = Scalar(0.22) * U_10_zy + t163;
  const Scalar t166 = mu_u_11_a_y + Scalar(0.357) * t162 + Scalar(0.848645) * t93 -
      Scalar(1.3725) * t91;
  const Scalar t167 = t82 * omega_9_z;
  const Scalar U_9_yz = t84 - t167;
  const Scalar t168 = Scalar(-0.00507) * U_9_yz - Scalar(0.02) * t165 + Scalar(0.08) * ddp_9_y -
      Scalar(0.4222475) * t89 + Scalar(0.4384975) * t85 - c_10 * t164 - s_10 * t166;
  n[8] = -t168;
  const Scalar t169 = s_5 * t157 - c_5 * t158;
  const Scalar t170 = t169 + Scalar(1.3725) * t52;
  const Scalar t171 = Scalar(-0.04) * t170 - s_5 * t154 - c_5 * mu_5_x + Scalar(0.22) * ddp_o_4_y +
      Scalar(0.4092575) * domega_4_x - Scalar(0.4393875) * t44;
  const Scalar t172 = Scalar(0.22) * U_4_zy + t170;
  const Scalar t173 = mu_u_5_a_y + Scalar(0.357) * t169 + Scalar(0.848645) * t51 -
      Scalar(1.3725) * t49;
  const Scalar t174 = t40 * omega_3_z;
  const Scalar U_3_yz = t42 - t174;
  const Scalar t175 = Scalar(-0.00507) * U_3_yz - Scalar(0.02) * t172 + Scalar(0.08) * ddp_3_y -
      Scalar(0.4222475) * t47 + Scalar(0.4384975) * t43 - c_4 * t171 - s_4 * t173;
  n[2] = -t175;
  const Scalar t176 = Scalar(0.22) * U_10_xy + t151 + Scalar(1.3725) * t103;
  const Scalar t177 = t152 - Scalar(0.22) * t109 + Scalar(1.3725) * t108;
  const Scalar f_9_x = Scalar(0.08) * t99 + c_10 * t177 + s_10 * t176;
  const Scalar f_9_y = Scalar(0.08) * t90 - t165;
  const Scalar f_u_9_t_x = s_9 * f_9_x + c_9 * f_9_y;
  const Scalar t178 = s_10 * t177 - c_10 * t176;
  const Scalar mu_9_y = Scalar(-0.00507) * (t98 - omega_r_9_x * omega_r_9_x) -
      Scalar(0.01625) * t97 + Scalar(0.08) * ddp_o_9_y - Scalar(0.02) * t178 - t153;
  const Scalar t179 = Scalar(0.4222475) * t84 - Scalar(0.00507) * t90 + Scalar(0.4384975) * t167 -
      s_10 * t164 + c_10 * t166;
  n[7] = Scalar(1.0144905) * t87 - s_9 * mu_9_y + Scalar(0.389) * f_u_9_t_x - c_9 * t179 +
      Scalar(27.463095) * c_7 * s_8;
  const Scalar t180 = Scalar(0.22) * U_4_xy + t159 + Scalar(1.3725) * t61;
  const Scalar t181 = t160 - Scalar(0.22) * t67 + Scalar(1.3725) * t66;
  const Scalar f_3_x = Scalar(0.08) * t57 + c_4 * t181 + s_4 * t180;
  const Scalar f_3_y = Scalar(0.08) * t48 - t172;
  const Scalar f_u_3_t_x = s_3 * f_3_x + c_3 * f_3_y;
  const Scalar t182 = s_4 * t181 - c_4 * t180;
  const Scalar mu_3_y = Scalar(-0.00507) * (t56 - omega_r_3_x * omega_r_3_x) -
      Scalar(0.01625) * t55 + Scalar(0.08) * ddp_o_3_y - Scalar(0.02) * t182 - t161;
  const Scalar t183 = Scalar(0.4222475) * t42 - Scalar(0.00507) * t48 + Scalar(0.4384975) * t174 -
      s_4 * t171 + c_4 * t173;
  n[1] = Scalar(1.0144905) * t45 - s_3 * mu_3_y + Scalar(0.389) * f_u_3_t_x - c_3 * t183 +
      Scalar(27.463095) * c_1 * s_2;
  const Scalar t184 = s_9 * f_9_y - c_9 * f_9_x;
  const Scalar mu_8_x = c_9 * mu_9_y - Scalar(2.030941) * t83 + Scalar(0.389) * t184 - s_9 * t179 +
      Scalar(27.463095) * s_7;
  n[6] = s_8 * (Scalar(0.00196) * t85 + t168) + c_8 * mu_8_x;
  const Scalar t185 = s_3 * f_3_y - c_3 * f_3_x;
  const Scalar mu_2_x = c_3 * mu_3_y - Scalar(2.030941) * t41 + Scalar(0.389) * t185 - s_3 * t183 +
      Scalar(27.463095) * s_1;
  n[0] = s_2 * (Scalar(0.00196) * t43 + t175) + c_2 * mu_2_x;
  const Scalar t186 = Scalar(0.33) * U_15_zx + t12;
  const Scalar U_15_zy = domega_15_x + t13;
  const Scalar t187 = Scalar(0.24) * U_15_zy;
  const Scalar t188 = t186 - t187;
  const Scalar t189 = Scalar(0.33) * t21 - t22;
  const Scalar U_15_xy = t15 + t16;
  const Scalar t190 = Scalar(0.24) * U_15_xy;
  const Scalar t191 = t190 + t189;
  const Scalar t192 = s_26 * t188 + c_26 * t191;
  const Scalar t193 = Scalar(0.33) * t17 - t18;
  const Scalar t194 = Scalar(0.24) * (t10 + t20);
  const Scalar t195 = t194 + t193;
  const Scalar t196 = s_27 * t192 + c_27 * t195;
  const Scalar t197 = s_26 * omega_15_z - c_26 * t2;
  const Scalar omega_26_z = qd_26 + omega_r_15_y;
  const Scalar omega_r_27_x = s_27 * t197 + c_27 * omega_26_z;
  const Scalar t198 = s_27 * omega_26_z - c_27 * t197;
  const Scalar t199 = omega_r_27_x * t198;
  const Scalar domega_26_y = c_26 * t16 - s_26 * domega_15_x + qd_26 * t197;
  const Scalar U_27_xy = domega_26_y - t199;
  const Scalar t200 = t196 + Scalar(0.305) * U_27_xy;
  const Scalar t201 = s_26 * t191 - c_26 * t188;
  const Scalar omega_r_27_a_z = s_26 * t2 + c_26 * omega_15_z;
  const Scalar t202 = -s_26 * t16 - c_26 * domega_15_x + qd_26 * omega_r_27_a_z;
  const Scalar t203 = c_27 * t5 + qd_27 * t198 - s_27 * t202;
  const Scalar omega_27_z = qd_27 + omega_r_27_a_z;
  const Scalar t204 = t198 * omega_27_z;
  const Scalar t205 = t203 + t204;
  const Scalar t206 = t201 + Scalar(0.305) * t205;
  const Scalar t207 = s_28 * omega_27_z - c_28 * omega_r_27_x;
  const Scalar omega_28_z = qd_28 - t198;
  const Scalar t208 = omega_28_z * omega_28_z;
  const Scalar t209 = t207 * t207 + t208;
  const Scalar t210 = Scalar(0.004) * t209 + s_28 * t200 - c_28 * t206;
  const Scalar t211 = omega_r_27_x * omega_r_27_x + omega_27_z * omega_27_z;
  const Scalar ddp_o_28_y = Scalar(0.305) * t211 + s_27 * t195 - c_27 * t192;
  const Scalar omega_r_28_x = s_28 * omega_r_27_x + c_28 * omega_27_z;
  const Scalar t212 = qd_28 * omega_r_28_x - s_28 * domega_26_y + c_28 * t203;
  const Scalar t213 = omega_r_28_x * omega_28_z;
  const Scalar U_28_zx = t212 + t213;
  const Scalar ddp_o_29_z = Scalar(0.004) * U_28_zx + ddp_o_28_y;
  const Scalar t214 = s_29 * ddp_o_29_z + c_29 * t210;
  const Scalar omega_r_30_a_z = s_29 * omega_r_28_x + c_29 * omega_28_z;
  const Scalar omega_29_z = qd_29 - t207;
  const Scalar t215 = omega_29_z * omega_29_z;
  const Scalar t216 = t215 + omega_r_30_a_z * omega_r_30_a_z;
  const Scalar t217 = s_29 * omega_28_z - c_29 * omega_r_28_x;
  const Scalar t218 = t217 * omega_r_30_a_z;
  const Scalar U_29_xy = t212 + t218;
  const Scalar t219 = Scalar(-0.004) * t216 - Scalar(0.239) * U_29_xy + t214;
  const Scalar t220 = s_28 * t206 + c_28 * t200;
  const Scalar t221 = omega_r_28_x * t207;
  const Scalar domega_r_29_a_y = qd_27 * omega_r_27_x - s_27 * t5 - c_27 * t202;
  const Scalar t222 = domega_r_29_a_y + t221;
  const Scalar t223 = Scalar(0.004) * t222 + t220;
  const Scalar t224 = qd_28 * t207 + s_28 * t203 + c_28 * domega_26_y;
  const Scalar domega_29_y = qd_29 * t217 + s_29 * t224 + c_29 * domega_r_29_a_y;
  const Scalar t225 = t217 * omega_29_z;
  const Scalar t226 = domega_29_y + t225;
  const Scalar t227 = qd_29 * omega_r_30_a_z - s_29 * domega_r_29_a_y + c_29 * t224;
  const Scalar t228 = omega_r_30_a_z * omega_29_z;
  const Scalar t229 = t227 + t228;
  const Scalar t230 = Scalar(0.239) * t229 - Scalar(0.004) * t226 + t223;
  const Scalar t231 = s_30 * t219 - c_30 * t230;
  const Scalar t232 = s_29 * t210 - c_29 * ddp_o_29_z;
  const Scalar t233 = t212 - t218;
  const Scalar t234 = t215 + t217 * t217;
  const Scalar t235 = Scalar(0.004) * t233 - Scalar(0.239) * t234 + t232;
  const Scalar t236 = s_31 * t231 + c_31 * t235;
  const Scalar omega_r_30_x = s_30 * t217 + c_30 * omega_29_z;
  const Scalar omega_30_z = qd_30 + omega_r_30_a_z;
  const Scalar omega_r_31_x = s_31 * omega_30_z + c_31 * omega_r_30_x;
  const Scalar omega_r_31_a_z = s_30 * omega_29_z - c_30 * t217;
  const Scalar omega_31_z = qd_31 + omega_r_31_a_z;
  const Scalar t237 = s_32 * omega_31_z - c_32 * omega_r_31_x;
  const Scalar t238 = s_31 * omega_r_30_x - c_31 * omega_30_z;
  const Scalar t239 = qd_30 * omega_r_31_a_z - s_30 * t227 + c_30 * t212;
  const Scalar t240 = qd_31 * t238 + s_31 * domega_29_y + c_31 * t239;
  const Scalar t241 = qd_30 * omega_r_30_x - s_30 * t212 - c_30 * t227;
  const Scalar t242 = qd_32 * t237 + s_32 * t240 - c_32 * t241;
  const Scalar omega_32_z = qd_32 - t238;
  const Scalar t243 = omega_32_z * omega_32_z;
  const Scalar t244 = t237 * omega_32_z;
  const Scalar t245 = Scalar(0.0005096) * t242 + Scalar(0.0007482) * (t243 - t237 * t237) -
      Scalar(0.0014129000000002) * t244 + Scalar(0.0094) * t236;
  const Scalar t246 = s_31 * t235 - c_31 * t231;
  const Scalar omega_r_32_x = s_32 * omega_r_31_x + c_32 * omega_31_z;
  const Scalar t247 = omega_r_32_x * t237;
  const Scalar t248 = qd_31 * omega_r_31_x + c_31 * domega_29_y - s_31 * t239;
  const Scalar U_32_xy = t248 - t247;
  const Scalar t249 = omega_r_32_x * omega_32_z;
  const Scalar t250 = Scalar(0.0007482) * U_32_xy - Scalar(0.0019225000000002) * t249;
  const Scalar t251 = omega_r_31_x * t238;
  const Scalar n_31 = c_32 * t245 - s_32 * t250 + Scalar(0.0258331000000002) * t241 +
      Scalar(0.0255131000000002) * t251 - Scalar(0.1902) * t246;
  n[30] = n_31;
  const Scalar ddp_19_a_y = t187 + t186;
  const Scalar t252 = t189 - t190;
  const Scalar t253 = s_19 * ddp_19_a_y + c_19 * t252;
  const Scalar t254 = t193 - t194;
  const Scalar t255 = s_20 * t253 + c_20 * t254;
  const Scalar t256 = s_19 * omega_15_z - c_19 * t2;
  const Scalar omega_19_z = qd_19 + omega_r_15_y;
  const Scalar omega_r_20_x = s_20 * t256 + c_20 * omega_19_z;
  const Scalar t257 = s_20 * omega_19_z - c_20 * t256;
  const Scalar t258 = omega_r_20_x * t257;
  const Scalar domega_19_y = c_19 * t16 - s_19 * domega_15_x + qd_19 * t256;
  const Scalar U_20_xy = domega_19_y - t258;
  const Scalar t259 = t255 + Scalar(0.305) * U_20_xy;
  const Scalar t260 = s_19 * t252 - c_19 * ddp_19_a_y;
  const Scalar omega_r_20_a_z = s_19 * t2 + c_19 * omega_15_z;
  const Scalar t261 = -s_19 * t16 - c_19 * domega_15_x + qd_19 * omega_r_20_a_z;
  const Scalar t262 = c_20 * t5 + qd_20 * t257 - s_20 * t261;
  const Scalar omega_20_z = qd_20 + omega_r_20_a_z;
  const Scalar t263 = t257 * omega_20_z;
  const Scalar t264 = t262 + t263;
  const Scalar t265 = t260 + Scalar(0.305) * t264;
  const Scalar t266 = s_21 * omega_20_z - c_21 * omega_r_20_x;
  const Scalar omega_21_z = qd_21 - t257;
  const Scalar t267 = omega_21_z * omega_21_z;
  const Scalar t268 = t266 * t266 + t267;
  const Scalar t269 = Scalar(0.004) * t268 + s_21 * t259 - c_21 * t265;
  const Scalar t270 = omega_r_20_x * omega_r_20_x + omega_20_z * omega_20_z;
  const Scalar ddp_o_21_y = Scalar(0.305) * t270 + s_20 * t254 - c_20 * t253;
  const Scalar omega_r_21_x = s_21 * omega_r_20_x + c_21 * omega_20_z;
  const Scalar t271 = qd_21 * omega_r_21_x - s_21 * domega_19_y + c_21 * t262;
  const Scalar t272 = omega_r_21_x * omega_21_z;
  const Scalar U_21_zx = t271 + t272;
  const Scalar ddp_o_22_z = Scalar(0.004) * U_21_zx + ddp_o_21_y;
  const Scalar t273 = s_22 * ddp_o_22_z + c_22 * t269;
  const Scalar omega_r_23_a_z = s_22 * omega_r_21_x + c_22 * omega_21_z;
  const Scalar omega_22_z = qd_22 - t266;
  const Scalar t274 = omega_22_z * omega_22_z;
  const Scalar t275 = t274 + omega_r_23_a_z * omega_r_23_a_z;
  const Scalar t276 = s_22 * omega_21_z - c_22 * omega_r_21_x;
  const Scalar t277 = t276 * omega_r_23_a_z;
  const Scalar U_22_xy = t271 + t277;
  const Scalar t278 = Scalar(-0.004) * t275 - Scalar(0.239) * U_22_xy + t273;
  const Scalar t279 = s_21 * t265 + c_21 * t259;
  const Scalar t280 = omega_r_21_x * t266;
  const Scalar domega_r_22_a_y = qd_20 * omega_r_20_x - s_20 * t5 - c_20 * t261;
  const Scalar t281 = domega_r_22_a_y + t280;
  const Scalar t282 = Scalar(0.004) * t281 + t279;
  const Scalar t283 = qd_21 * t266 + s_21 * t262 + c_21 * domega_19_y;
  const Scalar domega_22_y = qd_22 * t276 + s_22 * t283 + c_22 * domega_r_22_a_y;
  const Scalar t284 = t276 * omega_22_z;
  const Scalar t285 = domega_22_y + t284;
  const Scalar t286 = qd_22 * omega_r_23_a_z - s_22 * domega_r_22_a_y + c_22 * t283;
  const Scalar t287 = omega_r_23_a_z * omega_22_z;
  const Scalar t288 = t286 + t287;
  const Scalar t289 = Scalar(0.239) * t288 - Scalar(0.004) * t285 + t282;
  const Scalar ddp_23_x = s_23 * t278 - c_23 * t289;
  const Scalar t290 = s_22 * t269 - c_22 * ddp_o_22_z;
  const Scalar t291 = t271 - t277;
  const Scalar t292 = t274 + t276 * t276;
  const Scalar t293 = Scalar(0.004) * t291 - Scalar(0.239) * t292 + t290;
  const Scalar t294 = s_24 * ddp_23_x + c_24 * t293;
  const Scalar omega_r_23_x = s_23 * t276 + c_23 * omega_22_z;
  const Scalar omega_23_z = qd_23 + omega_r_23_a_z;
  const Scalar omega_r_24_x = s_24 * omega_23_z + c_24 * omega_r_23_x;
  const Scalar omega_r_24_a_z = s_23 * omega_22_z - c_23 * t276;
  const Scalar omega_24_z = qd_24 + omega_r_24_a_z;
  const Scalar t295 = s_25 * omega_24_z - c_25 * omega_r_24_x;
  const Scalar t296 = s_24 * omega_r_23_x - c_24 * omega_23_z;
  const Scalar t297 = qd_23 * omega_r_24_a_z - s_23 * t286 + c_23 * t271;
  const Scalar t298 = qd_24 * t296 + s_24 * domega_22_y + c_24 * t297;
  const Scalar t299 = qd_23 * omega_r_23_x - s_23 * t271 - c_23 * t286;
  const Scalar t300 = qd_25 * t295 + s_25 * t298 - c_25 * t299;
  const Scalar omega_25_z = qd_25 - t296;
  const Scalar t301 = omega_25_z * omega_25_z;
  const Scalar t302 = t295 * omega_25_z;
  const Scalar t303 = Scalar(0.0007482) * (t301 - t295 * t295) - Scalar(0.0005096) * t300 +
      Scalar(0.0014129000000002) * t302 + Scalar(0.0094) * t294;
  const Scalar t304 = s_24 * t293 - c_24 * ddp_23_x;
  const Scalar omega_r_25_x = s_25 * omega_r_24_x + c_25 * omega_24_z;
  const Scalar t305 = omega_r_25_x * t295;
  const Scalar t306 = qd_24 * omega_r_24_x + c_24 * domega_22_y - s_24 * t297;
  const Scalar U_25_xy = t306 - t305;
  const Scalar t307 = omega_r_25_x * omega_25_z;
  const Scalar t308 = Scalar(0.0007482) * U_25_xy + Scalar(0.0019225000000002) * t307;
  const Scalar t309 = omega_r_24_x * t296;
  const Scalar n_24 = s_25 * t308 - c_25 * t303 + Scalar(0.0258331000000002) * t299 +
      Scalar(0.0255131000000002) * t309 - Scalar(0.1902) * t304;
  n[23] = n_24;
  const Scalar t310 = c_23 * t278 + s_23 * t289;
  const Scalar t311 = s_25 * t304 + c_25 * t310;
  const Scalar t312 = t307 - qd_25 * omega_r_25_x - s_25 * t299 - c_25 * t298;
  const Scalar t313 = Scalar(0.0005096) * t305 - Scalar(0.0007482) * t312 +
      Scalar(0.0014129000000002) * t306 - Scalar(0.0094) * t311;
  n[24] = -t313;
  const Scalar t314 = c_30 * t219 + s_30 * t230;
  const Scalar t315 = s_32 * t246 + c_32 * t314;
  const Scalar t316 = t249 - qd_32 * omega_r_32_x - s_32 * t241 - c_32 * t240;
  const Scalar t317 = Scalar(0.0005096) * t247 + Scalar(0.0007482) * t316 +
      Scalar(0.0014129000000002) * t248 + Scalar(0.0094) * t315;
  n[31] = -t317;
  const Scalar t318 = Scalar(0.00032) * omega_r_31_x * omega_31_z + t317;
  const Scalar t319 = t238 * omega_31_z;
  const Scalar t320 = c_32 * t250 + s_32 * t245 - Scalar(0.0255131000000002) * t240 -
      Scalar(0.0258331000000002) * t319 + Scalar(0.1902) * t314;
  const Scalar mu_u_30_a_y = Scalar(0.00096) * domega_29_y -
      Scalar(0.00032) * omega_r_30_x * omega_r_31_a_z + c_31 * t318 - s_31 * t320;
  n[29] = -mu_u_30_a_y;
  const Scalar t321 = Scalar(0.00032) * omega_r_24_x * omega_24_z + t313;
  const Scalar t322 = t296 * omega_24_z;
  const Scalar t323 = -c_25 * t308 - s_25 * t303 - Scalar(0.0255131000000002) * t298 -
      Scalar(0.0258331000000002) * t322 + Scalar(0.1902) * t310;
  const Scalar mu_u_23_a_y = Scalar(0.00096) * domega_22_y -
      Scalar(0.00032) * omega_r_23_x * omega_r_24_a_z + c_24 * t321 - s_24 * t323;
  n[22] = -mu_u_23_a_y;
  const Scalar t324 = Scalar(0.00032) * t239 + Scalar(0.00096) * omega_r_31_a_z * omega_30_z -
      s_31 * t318 - c_31 * t320;
  const Scalar t325 = Scalar(0.00064) * omega_r_30_x * omega_30_z + n_31;
  const Scalar t326 = omega_r_32_x * omega_r_32_x + t243;
  const Scalar t327 = Scalar(0.1902) * (t241 + t251) -
      Scalar(0.0094) * (s_32 * U_32_xy - c_32 * t326);
  const Scalar f_31_y = Scalar(0.0094) * (t242 + t244) +
      Scalar(0.1902) * (omega_31_z * omega_31_z + omega_r_31_x * omega_r_31_x);
  const Scalar t328 = s_31 * f_31_y - c_31 * t327;
  const Scalar f_31_z = Scalar(0.1902) * (t240 + t319) -
      Scalar(0.0094) * (s_32 * t326 + c_32 * U_32_xy);
  const Scalar f_u_30_t_x = s_30 * t328 + c_30 * f_31_z;
  const Scalar f_u_31_t_y = s_31 * t327 + c_31 * f_31_y;
  const Scalar t329 = Scalar(0.0050592) * (t216 - t234) - Scalar(0.004) * f_u_31_t_y +
      Scalar(0.0328) * t232 + Scalar(0.239) * f_u_30_t_x - s_30 * t325 + c_30 * t324 +
      Scalar(0.2045534) * t212 + Scalar(0.200951) * t218 - Scalar(0.8648) * t214;
  n[28] = -t329;
  const Scalar t330 = Scalar(0.00032) * t297 + Scalar(0.00096) * omega_r_24_a_z * omega_23_z -
      s_24 * t321 - c_24 * t323;
  const Scalar t331 = Scalar(0.00064) * omega_r_23_x * omega_23_z + n_24;
  const Scalar t332 = omega_r_25_x * omega_r_25_x + t301;
  const Scalar t333 = Scalar(0.0094) * (s_25 * U_25_xy - c_25 * t332) +
      Scalar(0.1902) * (t299 + t309);
  const Scalar f_24_y = Scalar(0.1902) * (omega_24_z * omega_24_z + omega_r_24_x * omega_r_24_x) -
      Scalar(0.0094) * (t300 + t302);
  const Scalar t334 = s_24 * f_24_y - c_24 * t333;
  const Scalar f_24_z = Scalar(0.0094) * (s_25 * t332 + c_25 * U_25_xy) +
      Scalar(0.1902) * (t298 + t322);
  const Scalar f_u_23_t_x = s_23 * t334 + c_23 * f_24_z;
  const Scalar f_u_24_t_y = s_24 * t333 + c_24 * f_24_y;
  const Scalar t335 = Scalar(0.0050592) * (t275 - t292) - Scalar(0.004) * f_u_24_t_y +
      Scalar(0.0328) * t290 + Scalar(0.239) * f_u_23_t_x - s_23 * t331 + c_23 * t330 +
      Scalar(0.2045534) * t271 + Scalar(0.200951) * t277 - Scalar(0.8648) * t273;
  n[21] = -t335;
  const Scalar t336 = s_30 * f_31_z - c_30 * t328;
  const Scalar t337 = Scalar(-0.0050592) * t226 - Scalar(0.239) * t336 - s_30 * t324 - c_30 * t325 +
      Scalar(0.200951) * t227 + Scalar(0.2045534) * t228 + Scalar(0.8648) * t223;
  const Scalar t338 = Scalar(-0.004) * t336 - Scalar(0.0036024) * t225 + Scalar(0.0050592) * t229 +
      Scalar(0.0328) * t223 - mu_u_30_a_y;
  const Scalar f_29_z = Scalar(0.0328) * t226 + t336 - Scalar(0.8648) * t229;
  const Scalar t339 = t207 * omega_28_z;
  const Scalar U_28_yz = t224 - t339;
  const Scalar t340 = Scalar(-0.0032) * t220 - Scalar(0.001934) * t221 + Scalar(0.0023) * U_28_yz -
      Scalar(0.004) * f_29_z + Scalar(0.0097684) * domega_r_29_a_y - c_29 * t338 - s_29 * t337;
  n[27] = -t340;
  const Scalar t341 = s_23 * f_24_z - c_23 * t334;
  const Scalar t342 = Scalar(-0.0050592) * t285 - Scalar(0.239) * t341 - s_23 * t330 - c_23 * t331 +
      Scalar(0.200951) * t286 + Scalar(0.2045534) * t287 + Scalar(0.8648) * t282;
  const Scalar t343 = Scalar(-0.004) * t341 - Scalar(0.0036024) * t284 + Scalar(0.0050592) * t288 +
      Scalar(0.0328) * t282 - mu_u_23_a_y;
  const Scalar f_22_z = Scalar(0.0328) * t285 + t341 - Scalar(0.8648) * t288;
  const Scalar t344 = t266 * omega_21_z;
  const Scalar U_21_yz = t283 - t344;
  const Scalar t345 = Scalar(-0.0032) * t279 - Scalar(0.001934) * t280 + Scalar(0.0023) * U_21_yz -
      Scalar(0.004) * f_22_z + Scalar(0.0097684) * domega_r_22_a_y - c_22 * t343 - s_22 * t342;
  n[20] = -t345;
  const Scalar t346 = Scalar(0.001934) * t224 + Scalar(0.0023) * t222 + Scalar(0.0097684) * t339 -
      s_29 * t338 + c_29 * t337;
  const Scalar f_29_x = Scalar(0.0328) * t216 + f_u_30_t_x + Scalar(0.8648) * U_29_xy;
  const Scalar f_29_y = Scalar(0.0328) * t233 - f_u_31_t_y - Scalar(0.8648) * t234;
  const Scalar f_u_29_t_y = s_29 * f_29_x + c_29 * f_29_y;
  const Scalar mu_28_y = Scalar(0.0032) * ddp_o_28_y +
      Scalar(0.0023) * (t208 - omega_r_28_x * omega_r_28_x) + Scalar(0.004) * f_u_29_t_y -
      Scalar(0.0078344) * t213 - t329;
  const Scalar f_28_x = Scalar(0.0032) * t209 - s_29 * f_29_y + c_29 * f_29_x;
  const Scalar f_28_y = Scalar(0.0032) * t222 + f_29_z;
  const Scalar f_u_28_t_x = s_28 * f_28_x + c_28 * f_28_y;
  const Scalar mu_u_27_a_y = Scalar(0.4797322) * domega_26_y - Scalar(0.4777722) * t199 -
      Scalar(0.305) * f_u_28_t_x + s_28 * mu_28_y + c_28 * t346 + Scalar(1.661) * t196;
  n[26] = -mu_u_27_a_y;
  const Scalar t347 = Scalar(0.001934) * t283 + Scalar(0.0023) * t281 + Scalar(0.0097684) * t344 -
      s_22 * t343 + c_22 * t342;
  const Scalar f_22_x = Scalar(0.0328) * t275 + f_u_23_t_x + Scalar(0.8648) * U_22_xy;
  const Scalar f_22_y = Scalar(0.0328) * t291 - f_u_24_t_y - Scalar(0.8648) * t292;
  const Scalar f_u_22_t_y = s_22 * f_22_x + c_22 * f_22_y;
  const Scalar mu_21_y = Scalar(0.0032) * ddp_o_21_y +
      Scalar(0.0023) * (t267 - omega_r_21_x * omega_r_21_x) + Scalar(0.004) * f_u_22_t_y -
      Scalar(0.0078344) * t272 - t335;
  const Scalar f_21_x = Scalar(0.0032) * t268 - s_22 * f_22_y + c_22 * f_22_x;
  const Scalar f_21_y = Scalar(0.0032) * t281 + f_22_z;
  const Scalar f_u_21_t_x = s_21 * f_21_x + c_21 * f_21_y;
  const Scalar mu_u_20_a_y = Scalar(0.4797322) * domega_19_y - Scalar(0.4777722) * t258 -
      Scalar(0.305) * f_u_21_t_x + s_21 * mu_21_y + c_21 * t347 + Scalar(1.661) * t255;
  n[19] = -mu_u_20_a_y;
  const Scalar t348 = s_28 * f_28_y - c_28 * f_28_x;
  const Scalar t349 = Scalar(0.4777722) * t203 + Scalar(0.4797322) * t204 - Scalar(0.305) * t348 +
      s_28 * t346 - c_28 * mu_28_y + Scalar(1.661) * t201;
  const Scalar t350 = Scalar(0.00196) * omega_r_27_x * omega_27_z + t340;
  const Scalar t351 = Scalar(0.00196) * t197;
  const Scalar t352 = Scalar(0.00392) * t5;
  const Scalar n_26 = -omega_r_27_a_z * t351 - t352 + s_27 * t350 - c_27 * t349;
  n[25] = n_26;
  const Scalar t353 = s_21 * f_21_y - c_21 * f_21_x;
  const Scalar t354 = Scalar(0.4777722) * t262 + Scalar(0.4797322) * t263 - Scalar(0.305) * t353 +
      s_21 * t347 - c_21 * mu_21_y + Scalar(1.661) * t260;
  const Scalar t355 = Scalar(0.00196) * omega_r_20_x * omega_20_z + t345;
  const Scalar t356 = Scalar(0.00196) * t256;
  const Scalar t357 = omega_r_20_a_z * t356 + t352 - s_20 * t355 + c_20 * t354;
  n[18] = -t357;
  const Scalar t358 = Scalar(1.661) * U_27_xy - f_u_28_t_x;
  const Scalar f_27_y = Scalar(-0.0032) * U_28_zx - f_u_29_t_y + Scalar(1.661) * t211;
  const Scalar t359 = s_27 * t358 - c_27 * f_27_y;
  const Scalar f_27_z = Scalar(1.661) * t205 - t348;
  const Scalar t360 = Scalar(1.661) * U_20_xy - f_u_21_t_x;
  const Scalar f_20_y = Scalar(-0.0032) * U_21_zx - f_u_22_t_y + Scalar(1.661) * t270;
  const Scalar t361 = s_20 * t360 - c_20 * f_20_y;
  const Scalar f_20_z = Scalar(1.661) * t264 - t353;
  const Scalar t362 = (s_26 * f_27_z + c_26 * t359) - (s_19 * f_20_z + c_19 * t361);
  const Scalar t363 = Scalar(0.00196) * t261 + Scalar(0.00392) * omega_r_20_a_z * omega_19_z -
      c_20 * t355 - s_20 * t354;
  const Scalar t364 = Scalar(0.00196) * t202 + Scalar(0.00392) * omega_r_27_a_z * omega_26_z -
      c_27 * t350 - s_27 * t349;
  const Scalar mu_19_y = omega_19_z * t356 + mu_u_20_a_y;
  const Scalar mu_26_y = omega_26_z * t351 + mu_u_27_a_y;
  const Scalar t365 = (s_27 * f_27_y + c_27 * t358) + (s_20 * f_20_y + c_20 * t360);
  const Scalar t366 = Scalar(0.02) * t31 - Scalar(0.22) * (t36 - t34);
  const Scalar t367 = Scalar(0.02) * (t36 + t34) + Scalar(0.22) * t33;
  const Scalar t368 = s_18 * t366 - c_18 * t367;
  const Scalar t369 = Scalar(0.02) * t127 - Scalar(0.22) * t123;
  const Scalar t370 = s_17 * t368 + c_17 * t369;
  const Scalar f_u_18_t_y = c_18 * t366 + s_18 * t367;
  const Scalar t371 = s_16 * f_u_18_t_y + c_16 * t370;
  const Scalar t372 = Scalar(0.0005) * t35 + Scalar(0.001125) * omega_r_17_a_z * omega_16_z -
      s_17 * mu_17_x - c_17 * t145;
  const Scalar t373 = Scalar(0.000625) * t27 * omega_16_z + mu_u_17_a_y;
  const Scalar t374 = c_16 * t373 - Scalar(0.043998) * t14 - s_16 * t372 - Scalar(0.453) * t371 -
      Scalar(1.972772833332667) * t15 + Scalar(0.24) * t362 - s_19 * t363 + c_19 * mu_19_y -
      s_26 * t364 + c_26 * mu_26_y + Scalar(4.062559499999667) * t16 - Scalar(0.33) * t365 +
      Scalar(89.72226) * t8;
  n[14] = -t374;
  const Scalar t375 = s_26 * t359 - c_26 * f_27_z;
  const Scalar t376 = s_19 * t361 - c_19 * f_20_z;
  const Scalar t377 = Scalar(0.003) * t371 - Scalar(0.043998) * t17 - mu_u_16_x +
      Scalar(0.24) * (t375 - t376) + s_19 * mu_19_y + c_19 * t363 + s_26 * mu_26_y + c_26 * t364 +
      Scalar(1.972772833332667) * domega_15_x - Scalar(4.062559499999667) * t13;
  const Scalar t378 = s_16 * t370 - c_16 * f_u_18_t_y;
  const Scalar t379 = s_17 * t369 - c_17 * t368;
  const Scalar U_15_zz_xx = t21 - t11;
  const Scalar t380 = Scalar(0.003) * t379 - Scalar(0.043998) * U_15_zz_xx + s_16 * t373 +
      c_16 * t372 - Scalar(0.453) * t378 - n_26 + t357 + Scalar(0.33) * (t375 + t376) +
      Scalar(89.72226) * s_14 + Scalar(6.035332333332334) * t7;
  const Scalar t381 = c_14 * (qd_13 * t6 - Scalar(0.6119232795934959));
  n[13] = Scalar(3.062001499999667) * t381 - s_15 * t377 - c_15 * t380;
  const Scalar t382 = c_14 * (Scalar(6.126452999999334) * t4 + s_15 * t380 - c_15 * t377);
  const Scalar mu_14_y = Scalar(0.00245) * t16 + t374;
  n[12] = s_14 * mu_14_y - t382;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[32]    in   joint positions, rad or m
//   qd[32]   in   joint velocities, rad/s or m/s
//   tau[32]  in   joint torques or forces, N m or N
//   qdd[32]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[0..11], q[13..31], qd[0..31], tau[0..31]. Operations: 2939 mul, 2240 add, 27 div, 62
// sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd,
    const SinCos& sin_cos = {}) noexcept {
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
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6], s_8 = sine[7],
      c_8 = cosine[7], s_9 = sine[8], c_9 = cosine[8], s_10 = sine[9], c_10 = cosine[9],
      s_11 = sine[10], c_11 = cosine[10], s_12 = sine[11], c_12 = cosine[11], s_14 = sine[13],
      c_14 = cosine[13], s_15 = sine[14], c_15 = cosine[14], s_16 = sine[15], c_16 = cosine[15],
      s_17 = sine[16], c_17 = cosine[16], s_18 = sine[17], c_18 = cosine[17], s_19 = sine[18],
      c_19 = cosine[18], s_20 = sine[19], c_20 = cosine[19], s_21 = sine[20], c_21 = cosine[20],
      s_22 = sine[21], c_22 = cosine[21], s_23 = sine[22], c_23 = cosine[22], s_24 = sine[23],
      c_24 = cosine[23], s_25 = sine[24], c_25 = cosine[24], s_26 = sine[25], c_26 = cosine[25],
      s_27 = sine[26], c_27 = cosine[26], s_28 = sine[27], c_28 = cosine[27], s_29 = sine[28],
      c_29 = cosine[28], s_30 = sine[29], c_30 = cosine[29], s_31 = sine[30], c_31 = cosine[30],
      s_32 = sine[31], c_32 = cosine[31];
  const Scalar t1 = c_2 * qd_1;
  const Scalar omega_r_3_x = s_3 * t1 + c_3 * qd_2;
  const Scalar t2 = s_2 * qd_1;
  const Scalar omega_3_z = qd_3 - t2;
  const Scalar t3 = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar t4 = c_3 * t1 - s_3 * qd_2;
  const Scalar omega_4_z = qd_4 + t4;
  const Scalar t5 = c_5 * t3 - s_5 * omega_4_z;
  const Scalar t6 = c_4 * omega_r_3_x - s_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 + t6;
  const Scalar omega_r_6_x = c_6 * omega_5_z - s_6 * t5;
  const Scalar t7 = c_6 * t5 + s_6 * omega_5_z;
  const Scalar t8 = omega_r_6_x * t7;
  const Scalar t9 = qd_2 * t2;
  const Scalar t10 = s_3 * t9 - qd_3 * t4;
  const Scalar t11 = qd_2 * t1;
  const Scalar domega_4_x = c_4 * t11 + s_4 * t10 - qd_4 * t6;
  const Scalar t12 = c_3 * t9 + qd_3 * omega_r_3_x;
  const Scalar t13 = c_5 * t12 + s_5 * domega_4_x - qd_5 * t5;
  const Scalar omega_r_5_y = c_5 * omega_4_z + s_5 * t3;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t14 = omega_6_z * omega_6_z;
  const Scalar t15 = omega_r_6_x * omega_r_6_x + t14;
  const Scalar t16 = Scalar(0.045) * (t13 + t8) + Scalar(0.105) * t15;
  const Scalar t17 = t7 * t7 + t14;
  const Scalar U_6_xy = t13 - t8;
  const Scalar t18 = Scalar(0.045) * t17 - Scalar(0.105) * U_6_xy;
  const Scalar t19 = s_6 * t18 + c_6 * t16;
  const Scalar domega_5_x = c_5 * domega_4_x - s_5 * t12 + qd_5 * omega_r_5_y;
  const Scalar domega_4_y = c_4 * t10 - s_4 * t11 + qd_4 * t3;
  const Scalar t20 = c_6 * domega_5_x + s_6 * domega_4_y - qd_6 * omega_r_6_x;
  const Scalar t21 = omega_r_6_x * omega_6_z;
  const Scalar t22 = t20 - t21;
  const Scalar t23 = c_6 * domega_4_y - s_6 * domega_5_x + t7 * (qd_6 + omega_6_z);
  const Scalar t24 = Scalar(0.045) * t22 + Scalar(0.105) * t23;
  const Scalar t25 = s_5 * t19 + c_5 * t24;
  const Scalar t26 = t3 * omega_4_z;
  const Scalar t27 = domega_4_y + t26;
  const Scalar t28 = t25 + Scalar(1.3725) * t27;
  const Scalar t29 = omega_r_3_x * omega_3_z;
  const Scalar U_3_zx = t12 + t29;
  const Scalar t30 = Scalar(9.81) * c_1;
  const Scalar ddp_o_3_y = Scalar(0.389) * (t1 * t1 + qd_2 * qd_2) + c_2 * t30;
  const Scalar ddp_o_4_z = ddp_o_3_y - Scalar(0.02) * U_3_zx;
  const Scalar t31 = omega_3_z * omega_3_z;
  const Scalar t32 = t4 * t4 + t31;
  const Scalar ddp_3_a_y = Scalar(9.81) * s_1 - Scalar(0.778) * t9;
  const Scalar t33 = t1 * t2;
  const Scalar ddp_o_3_x = Scalar(0.389) * t33 + s_2 * t30;
  const Scalar t34 = Scalar(0.02) * t32 + s_3 * ddp_o_3_x - c_3 * ddp_3_a_y;
  const Scalar t35 = c_4 * ddp_o_4_z + s_4 * t34;
  const Scalar t36 = omega_4_z * omega_4_z;
  const Scalar t37 = t6 * t6 + t36;
  const Scalar t38 = t3 * t6;
  const Scalar U_4_xy = t12 + t38;
  const Scalar t39 = Scalar(0.04) * U_4_xy + t35 + Scalar(0.357) * t37;
  const Scalar t40 = t6 * omega_4_z;
  const Scalar U_4_zy = domega_4_x - t40;
  const Scalar ddp_3_y = c_3 * ddp_o_3_x + s_3 * ddp_3_a_y;
  const Scalar t41 = omega_r_3_x * t4;
  const Scalar t42 = t11 - t41;
  const Scalar ddp_o_4_y = Scalar(0.02) * t42 + ddp_3_y;
  const Scalar t43 = ddp_o_4_y - Scalar(0.04) * U_4_zy;
  const Scalar t44 = Scalar(0.357) * t27 - t43;
  const Scalar t45 = c_5 * t39 + s_5 * t44;
  const Scalar t46 = c_4 * t34 - s_4 * ddp_o_4_z;
  const Scalar t47 = t12 - t38;
  const Scalar t48 = t36 + t3 * t3;
  const Scalar t49 = t46 - Scalar(0.04) * t48 + Scalar(0.357) * t47;
  const Scalar t50 = c_6 * t49 - s_6 * t45;
  const Scalar t51 = c_6 * t45 + s_6 * t49;
  const Scalar t52 = Scalar(-0.0012) * t8 - Scalar(0.00315) * (t17 - t15) +
      Scalar(0.01431666666667) * t13 + Scalar(0.045) * t51 + Scalar(0.105) * t50;
  const Scalar mu_5_y = Scalar(0.00876666666667) * t13 + Scalar(0.00940666666667) * t5 * omega_5_z -
      t52;
  const Scalar t53 = c_5 * t44 - s_5 * t39;
  const Scalar t54 = Scalar(0.00315) * t23 - Scalar(0.0012) * t20 + Scalar(0.045) * t53 -
      Scalar(0.01431666666667) * t21;
  const Scalar t55 = Scalar(0.00315) * t22 + Scalar(0.01551666666667) * t7 * omega_6_z +
      Scalar(0.105) * t53;
  const Scalar mu_5_x = Scalar(0.01817333333334) * omega_r_5_y * omega_5_z + c_6 * t54 - s_6 * t55;
  const Scalar t56 = Scalar(0.04766333333334) * t40 - Scalar(0.04) * t28 - c_5 * mu_5_x +
      s_5 * mu_5_y + Scalar(0.22) * ddp_o_4_y;
  const Scalar t57 = Scalar(0.22) * U_4_zy + t28;
  const Scalar mu_u_5_a_y = Scalar(0.00940666666667) * domega_4_y -
      Scalar(0.00876666666667) * t5 * omega_r_5_y + s_6 * t54 + c_6 * t55;
  const Scalar t58 = mu_u_5_a_y + Scalar(0.357) * t25 + Scalar(0.40049083333333) * domega_4_y +
      Scalar(0.44815416666667) * t26 - Scalar(1.3725) * t43;
  const Scalar t59 = t4 * omega_3_z;
  const Scalar U_3_yz = t10 + t59;
  const Scalar t60 = Scalar(0.03800666666667) * t11 - Scalar(0.00507) * U_3_yz +
      Scalar(0.02175666666667) * t41 - Scalar(0.02) * t57 + Scalar(0.08) * ddp_3_y - c_4 * t56 -
      s_4 * t58;
  const Scalar t61 = c_5 * t19 - s_5 * t24;
  const Scalar t62 = c_6 * t18 - s_6 * t16;
  const Scalar t63 = Scalar(0.04) * t61 - Scalar(0.357) * t62 - c_5 * mu_5_y - s_5 * mu_5_x +
      Scalar(0.22) * t35 + Scalar(0.0549) * (t37 - t48) + Scalar(0.44815416666667) * t12 -
      Scalar(0.40049083333333) * t38 + Scalar(1.3725) * t46;
  const Scalar y_6 = t52 + tau_6;
  const Scalar hu_6_a_z = Scalar(0.045) * c_6 - Scalar(0.105) * s_6;
  const Scalar t64 = Scalar(0.04) * hu_6_a_z + Scalar(0.01431666666667);
  const Scalar hu_6_t_x = Scalar(0.045) * s_6 + Scalar(0.105) * c_6;
  const Scalar t65 = Scalar(0.357) * hu_6_t_x;
  const Scalar mu_6_4_z = c_5 * t64 + t65;
  const Scalar t66 = Scalar(69.84866123397676) * mu_6_4_z;
  const Scalar y_5 = mu_u_5_a_y + tau_5;
  const Scalar t67 = Scalar(0.0063) * c_6 - Scalar(0.0012) * s_6;
  const Scalar t68 = s_6 * t67;
  const Scalar Ic_5_zz = t68 + Scalar(0.00940666666667);
  const Scalar d_5 = Scalar(1.0) / Ic_5_zz;
  const Scalar t69 = Scalar(0.04) * hu_6_t_x + c_6 * t67 - Scalar(0.00315);
  const Scalar t70 = s_5 * t69;
  const Scalar t71 = d_5 * t70;
  const Scalar y_5_4 = t71 * y_5 + tau_4 + t63 - t66 * y_6;
  const Scalar t72 = Scalar(0.0012) + t68;
  const Scalar t73 = c_5 * (t72 + Scalar(0.00555));
  const Scalar t74 = t73 + t65;
  const Scalar t75 = s_4 * t69 + c_4 * t74;
  const Scalar t76 = s_5 * t75;
  const Scalar t77 = c_5 * t69;
  const Scalar t78 = c_5 * hu_6_t_x;
  const Scalar t79 = Ic_5_zz + Scalar(0.357) * t78;
  const Scalar t80 = Scalar(0.02) * t78 - c_4 * t77 + s_4 * t79;
  const Scalar t81 = t80 * d_5;
  const Scalar t82 = Scalar(0.357) * hu_6_a_z;
  const Scalar t83 = s_5 * (c_4 * t64 - t82 * (Scalar(0.056022408963585436) + s_4));
  const Scalar t84 = t70 * t81 - t76 + t83 * t66;
  const Scalar t85 = c_5 * t73;
  const Scalar t86 = Scalar(0.714) * t78;
  const Scalar t87 = Scalar(0.08) * hu_6_a_z;
  const Scalar t88 = t72 - t85 - t87 - t86 - Scalar(0.44815416666667);
  const Scalar t89 = t70 * t71 + mu_6_4_z * t66 + t88;
  const Scalar t90 = Scalar(1.0) / t89;
  const Scalar t91 = t84 * t90;
  const Scalar t92 = Scalar(-69.84866123397676) * t83;
  const Scalar y_4_3 = tau_3 - t91 * y_5_4 + t60 + t92 * y_6 + t81 * y_5;
  const Scalar t93 = t85 - t87 - Scalar(0.00555);
  const Scalar Ic_4_yy = Ic_5_zz + t86 + Scalar(0.40049083333333);
  const Scalar Ic_4_xy = t77 + t82 + Scalar(0.0549);
  const Scalar t94 = Scalar(2.0) * c_4 * Ic_4_xy - s_4 * (t93 + Ic_4_yy);
  const Scalar hc_4_x = t78 + Scalar(1.3725);
  const Scalar f_4_4_x = hu_6_a_z + Scalar(0.22);
  const Scalar hu_4_t_y = s_4 * f_4_4_x + c_4 * hc_4_x;
  const Scalar t95 = Scalar(0.00507) + Scalar(0.02) * hu_4_t_y + Ic_4_xy - c_4 * t94;
  const Scalar t96 = s_3 * s_5;
  const Scalar t97 = c_4 * f_4_4_x - s_4 * hc_4_x;
  const Scalar t98 = t97 - Scalar(0.08);
  const Scalar t99 = c_3 * t98 - hu_6_t_x * t96;
  const Scalar t100 = -t75 * t96 - c_3 * t95 + Scalar(0.389) * t99;
  const Scalar mu_u_5_4_t_x = s_4 * t77 + c_4 * t79;
  const Scalar t101 = Scalar(0.02) * hu_6_t_x;
  const Scalar t102 = t69 - c_4 * t101;
  const Scalar t103 = Scalar(0.389) * hu_6_t_x;
  const Scalar t104 = (c_3 * c_5 + s_4 * t96) * t103;
  const Scalar mu_5_2_z = t96 * t102 + c_3 * mu_u_5_4_t_x + t104;
  const Scalar t105 = mu_5_2_z * d_5;
  const Scalar t106 = c_4 * t69 - s_4 * t74;
  const Scalar t107 = c_3 * s_5;
  const Scalar t108 = Scalar(0.02) * t97 + t88 - Scalar(0.389) * hu_4_t_y;
  const Scalar t109 = c_5 * hu_6_a_z;
  const Scalar t110 = s_4 * t109 + c_4 * hu_6_t_x;
  const Scalar t111 = hu_6_a_z * t107 - s_3 * t110;
  const Scalar mu_6_3_y = mu_6_4_z - Scalar(0.02) * (c_4 * t109 - s_4 * hu_6_t_x);
  const Scalar t112 = s_4 * t64 + c_4 * t82;
  const Scalar t113 = t107 * t112 + Scalar(0.389) * t111 - s_3 * mu_6_3_y;
  const Scalar t114 = t106 * t107 - t70 * t105 + t113 * t66 - s_3 * t108;
  const Scalar t115 = Scalar(-69.84866123397676) * t113;
  const Scalar t116 = t83 * t115 + mu_5_2_z * t81 + t114 * t91 + t100;
  const Scalar t117 = s_4 * t94;
  const Scalar t118 = Scalar(-0.04) * t97;
  const Scalar t119 = t93 - t118 - Scalar(0.03800666666667) + t117;
  const Scalar t120 = t80 * t81 - t84 * t91 - t83 * t92 + t119;
  const Scalar t121 = Scalar(1.0) / t120;
  const Scalar t122 = t116 * t121;
  const Scalar f_3_y = Scalar(0.08) * t42 - t57;
  const Scalar t123 = Scalar(0.22) * U_4_xy + t61 + Scalar(1.3725) * t37;
  const Scalar t124 = -t62 - Scalar(0.22) * t48 + Scalar(1.3725) * t47;
  const Scalar f_3_x = Scalar(0.08) * t32 + c_4 * t124 + s_4 * t123;
  const Scalar f_u_3_t_x = s_3 * f_3_x + c_3 * f_3_y;
  const Scalar mu_3_x = Scalar(0.00507) * t42 + Scalar(0.05976333333334) * t59 + s_4 * t56 -
      c_4 * t58;
  const Scalar t125 = c_4 * t123 - s_4 * t124;
  const Scalar mu_3_y = Scalar(0.02175666666667) * t12 -
      Scalar(0.00507) * (t31 - omega_r_3_x * omega_r_3_x) + Scalar(0.08) * ddp_o_3_y -
      Scalar(0.03800666666667) * t29 + Scalar(0.02) * t125 - t63;
  const Scalar t126 = t114 * t90;
  const Scalar y_3_2 = s_3 * mu_3_y - Scalar(1.03624716666667) * t33 - c_3 * mu_3_x + tau_2 -
      Scalar(0.389) * f_u_3_t_x - Scalar(27.463095) * c_1 * s_2 + t115 * y_6 - t105 * y_5 -
      t126 * y_5_4 + t122 * y_4_3;
  const Scalar Iu_4_t_xx = t117 + Ic_4_yy;
  const Scalar t127 = Scalar(0.02175666666667) - t118 + t88;
  const Scalar Iu_3_t_d = Iu_4_t_xx + t127;
  const Scalar t128 = s_5 * t101 - s_5 * t106;
  const Scalar t129 = Scalar(2.0) * c_3 * t128 + s_3 * Iu_3_t_d;
  const Scalar t130 = c_2 * (t128 - c_3 * t129);
  const Scalar t131 = hu_6_t_x * t107 + s_3 * t98;
  const Scalar t132 = c_2 * (t75 * t107 - s_3 * t95 + Scalar(0.389) * t131);
  const Scalar t133 = (s_4 * t107 - s_3 * c_5) * t103;
  const Scalar t134 = c_2 * (t107 * t102 - s_3 * mu_u_5_4_t_x + t133) - s_2 * t80;
  const Scalar t135 = t134 * d_5;
  const Scalar t136 = c_2 * (t106 * t96 + c_3 * t108);
  const Scalar f_u_6_3_t_y = c_3 * t110 + hu_6_a_z * t96;
  const Scalar mu_6_2_x = t96 * t112 + Scalar(0.389) * f_u_6_3_t_y + c_3 * mu_6_3_y;
  const Scalar mu_u_6_2_t_y = c_2 * mu_6_2_x - s_2 * t83;
  const Scalar t137 = t70 * t135 + s_2 * t76 + mu_u_6_2_t_y * t66 + t136;
  const Scalar t138 = Scalar(69.84866123397676) * mu_u_6_2_t_y;
  const Scalar t139 = t137 * t91 - t83 * t138 - t134 * t81 + t132 + s_2 * t119;
  const Scalar t140 = -mu_u_6_2_t_y * t115 - t134 * t105 + t130 + s_2 * t100 - t137 * t126 -
      t139 * t122;
  const Scalar t141 = s_3 * t129;
  const Scalar t142 = Scalar(0.778) * hu_4_t_y;
  const Scalar b_3_2_2 = t113 * t115 - mu_5_2_z * t105 + Iu_4_t_xx - t141 + t114 * t126 +
      t116 * t122 + t142 + Scalar(1.03820716666667);
  const Scalar d_2 = Scalar(1.0) / b_3_2_2;
  const Scalar t143 = t140 * d_2;
  const Scalar t144 = c_3 * f_3_x - s_3 * f_3_y;
  const Scalar mu_2_x = c_3 * mu_3_y + s_3 * mu_3_x - Scalar(2.07445433333334) * t9 -
      Scalar(0.389) * t144 + Scalar(27.463095) * s_1;
  const Scalar t145 = s_2 * (Scalar(0.00196) * t11 + t60);
  const Scalar t146 = t139 * t121;
  const Scalar t147 = t137 * t90;
  const Scalar y_2_1 = tau_1 - t145 - c_2 * mu_2_x - t138 * y_6 + t135 * y_5 - t147 * y_5_4 +
      t146 * y_4_3 + t143 * y_3_2;
  const Scalar t148 = t127 - t141 - t142;
  const Scalar t149 = s_2 * (Scalar(2.0) * t132 + s_2 * (t119 - t148 + Scalar(1.03624716666667)));
  const Scalar t150 = mu_u_6_2_t_y * t138 + t134 * t135 - t137 * t147 + t140 * t143 - t139 * t146 +
      t148 + t149 - Scalar(1.04016716666667);
  const Scalar t151 = (Scalar(1.0) / t150) * y_2_1;
  qdd[0] = -t151;
  const Scalar t152 = c_8 * qd_7;
  const Scalar omega_r_9_x = s_9 * t152 + c_9 * qd_8;
  const Scalar t153 = s_8 * qd_7;
  const Scalar omega_9_z = qd_9 - t153;
  const Scalar t154 = s_10 * omega_r_9_x + c_10 * omega_9_z;
  const Scalar t155 = c_9 * t152 - s_9 * qd_8;
  const Scalar omega_10_z = qd_10 + t155;
  const Scalar t156 = c_11 * t154 - s_11 * omega_10_z;
  const Scalar t157 = c_10 * omega_r_9_x - s_10 * omega_9_z;
  const Scalar omega_11_z = qd_11 + t157;
  const Scalar omega_r_12_x = c_12 * omega_11_z - s_12 * t156;
  const Scalar t158 = c_12 * t156 + s_12 * omega_11_z;
  const Scalar t159 = omega_r_12_x * t158;
  const Scalar t160 = qd_8 * t153;
  const Scalar t161 = s_9 * t160 - qd_9 * t155;
  const Scalar t162 = qd_8 * t152;
  const Scalar domega_10_x = c_10 * t162 + s_10 * t161 - qd_10 * t157;
  const Scalar t163 = c_9 * t160 + qd_9 * omega_r_9_x;
  const Scalar t164 = c_11 * t163 + s_11 * domega_10_x - qd_11 * t156;
  const Scalar omega_r_11_y = c_11 * omega_10_z + s_11 * t154;
  const Scalar omega_12_z = qd_12 + omega_r_11_y;
  const Scalar t165 = omega_12_z * omega_12_z;
  const Scalar t166 = omega_r_12_x * omega_r_12_x + t165;
  const Scalar t167 = Scalar(0.045) * (t164 + t159) + Scalar(0.105) * t166;
  const Scalar t168 = t158 * t158 + t165;
  const Scalar U_12_xy = t164 - t159;
  const Scalar t169 = Scalar(0.045) * t168 - Scalar(0.105) * U_12_xy;
  const Scalar t170 = s_12 * t169 + c_12 * t167;
  const Scalar domega_11_x = c_11 * domega_10_x - s_11 * t163 + qd_11 * omega_r_11_y;
  const Scalar domega_10_y = c_10 * t161 - s_10 * t162 + qd_10 * t154;
  const Scalar t171 = c_12 * domega_11_x + s_12 * domega_10_y - qd_12 * omega_r_12_x;
  const Scalar t172 = omega_r_12_x * omega_12_z;
  const Scalar t173 = t171 - t172;
  const Scalar t174 = c_12 * domega_10_y - s_12 * domega_11_x + t158 * (qd_12 + omega_12_z);
  const Scalar t175 = Scalar(0.045) * t173 + Scalar(0.105) * t174;
  const Scalar t176 = s_11 * t170 + c_11 * t175;
  const Scalar t177 = t154 * omega_10_z;
  const Scalar t178 = domega_10_y + t177;
  const Scalar t179 = t176 + Scalar(1.3725) * t178;
  const Scalar t180 = omega_r_9_x * omega_9_z;
  const Scalar U_9_zx = t163 + t180;
  const Scalar t181 = Scalar(9.81) * c_7;
  const Scalar ddp_o_9_y = Scalar(0.389) * (t152 * t152 + qd_8 * qd_8) + c_8 * t181;
  const Scalar ddp_o_10_z = ddp_o_9_y - Scalar(0.02) * U_9_zx;
  const Scalar t182 = omega_9_z * omega_9_z;
  const Scalar t183 = t155 * t155 + t182;
  const Scalar ddp_9_a_y = Scalar(9.81) * s_7 - Scalar(0.778) * t160;
  const Scalar t184 = t152 * t153;
  const Scalar ddp_o_9_x = Scalar(0.389) * t184 + s_8 * t181;
  const Scalar t185 = Scalar(0.02) * t183 + s_9 * ddp_o_9_x - c_9 * ddp_9_a_y;
  const Scalar t186 = c_10 * ddp_o_10_z + s_10 * t185;
  const Scalar t187 = omega_10_z * omega_10_z;
  const Scalar t188 = t157 * t157 + t187;
  const Scalar t189 = t154 * t157;
  const Scalar U_10_xy = t163 + t189;
  const Scalar t190 = Scalar(0.04) * U_10_xy + t186 + Scalar(0.357) * t188;
  const Scalar t191 = t157 * omega_10_z;
  const Scalar U_10_zy = domega_10_x - t191;
  const Scalar ddp_9_y = c_9 * ddp_o_9_x + s_9 * ddp_9_a_y;
  const Scalar t192 = omega_r_9_x * t155;
  const Scalar t193 = t162 - t192;
  const Scalar ddp_o_10_y = Scalar(0.02) * t193 + ddp_9_y;
  const Scalar t194 = ddp_o_10_y - Scalar(0.04) * U_10_zy;
  const Scalar t195 = Scalar(0.357) * t178 - t194;
  const Scalar t196 = c_11 * t190 + s_11 * t195;
  const Scalar t197 = c_10 * t185 - s_10 * ddp_o_10_z;
  const Scalar t198 = t163 - t189;
  const Scalar t199 = t187 + t154 * t154;
  const Scalar t200 = t197 - Scalar(0.04) * t199 + Scalar(0.357) * t198;
  const Scalar t201 = c_12 * t200 - s_12 * t196;
  const Scalar t202 = c_12 * t196 + s_12 * t200;
  const Scalar t203 = Scalar(-0.0012) * t159 - Scalar(0.00315) * (t168 - t166) +
      Scalar(0.01431666666667) * t164 + Scalar(0.045) * t202 + Scalar(0.105) * t201;
  const Scalar mu_11_y = Scalar(0.00876666666667) * t164 +
      Scalar(0.00940666666667) * t156 * omega_11_z - t203;
  const Scalar t204 = c_11 * t195 - s_11 * t190;
  const Scalar t205 = Scalar(0.00315) * t174 - Scalar(0.0012) * t171 + Scalar(0.045) * t204 -
      Scalar(0.01431666666667) * t172;
  const Scalar t206 = Scalar(0.00315) * t173 + Scalar(0.01551666666667) * t158 * omega_12_z +
      Scalar(0.105) * t204;
  const Scalar mu_11_x = Scalar(0.01817333333334) * omega_r_11_y * omega_11_z + c_12 * t205 -
      s_12 * t206;
  const Scalar t207 = Scalar(0.04766333333334) * t191 - Scalar(0.04) * t179 - c_11 * mu_11_x +
      s_11 * mu_11_y + Scalar(0.22) * ddp_o_10_y;
  const Scalar t208 = Scalar(0.22) * U_10_zy + t179;
  const Scalar mu_u_11_a_y = Scalar(0.00940666666667) * domega_10_y -
      Scalar(0.00876666666667) * t156 * omega_r_11_y + s_12 * t205 + c_12 * t206;
  const Scalar t209 = mu_u_11_a_y + Scalar(0.357) * t176 + Scalar(0.40049083333333) * domega_10_y +
      Scalar(0.44815416666667) * t177 - Scalar(1.3725) * t194;
  const Scalar t210 = t155 * omega_9_z;
  const Scalar U_9_yz = t161 + t210;
  const Scalar t211 = Scalar(0.03800666666667) * t162 - Scalar(0.00507) * U_9_yz +
      Scalar(0.02175666666667) * t192 - Scalar(0.02) * t208 + Scalar(0.08) * ddp_9_y - c_10 * t207 -
      s_10 * t209;
  const Scalar t212 = c_11 * t170 - s_11 * t175;
  const Scalar t213 = c_12 * t169 - s_12 * t167;
  const Scalar t214 = Scalar(0.04) * t212 - Scalar(0.357) * t213 - c_11 * mu_11_y - s_11 * mu_11_x +
      Scalar(0.22) * t186 + Scalar(0.0549) * (t188 - t199) + Scalar(0.44815416666667) * t163 -
      Scalar(0.40049083333333) * t189 + Scalar(1.3725) * t197;
  const Scalar y_12 = t203 + tau_12;
  const Scalar hu_12_a_z = Scalar(0.045) * c_12 - Scalar(0.105) * s_12;
  const Scalar t215 = Scalar(0.04) * hu_12_a_z + Scalar(0.01431666666667);
  const Scalar hu_12_t_x = Scalar(0.045) * s_12 + Scalar(0.105) * c_12;
  const Scalar t216 = Scalar(0.357) * hu_12_t_x;
  const Scalar mu_12_10_z = c_11 * t215 + t216;
  const Scalar t217 = Scalar(69.84866123397676) * mu_12_10_z;
  const Scalar y_11 = mu_u_11_a_y + tau_11;
  const Scalar t218 = Scalar(0.0063) * c_12 - Scalar(0.0012) * s_12;
  const Scalar t219 = s_12 * t218;
  const Scalar Ic_11_zz = t219 + Scalar(0.00940666666667);
  const Scalar d_11 = Scalar(1.0) / Ic_11_zz;
  const Scalar t220 = Scalar(0.04) * hu_12_t_x + c_12 * t218 - Scalar(0.00315);
  const Scalar t221 = s_11 * t220;
  const Scalar t222 = d_11 * t221;
  const Scalar y_11_10 = t222 * y_11 + tau_10 + t214 - t217 * y_12;
  const Scalar t223 = Scalar(0.0012) + t219;
  const Scalar t224 = c_11 * (t223 + Scalar(0.00555));
  const Scalar t225 = t224 + t216;
  const Scalar t226 = s_10 * t220 + c_10 * t225;
  const Scalar t227 = s_11 * t226;
  const Scalar t228 = c_11 * t220;
  const Scalar t229 = c_11 * hu_12_t_x;
  const Scalar t230 = Ic_11_zz + Scalar(0.357) * t229;
  const Scalar t231 = Scalar(0.02) * t229 - c_10 * t228 + s_10 * t230;
  const Scalar t232 = t231 * d_11;
  const Scalar t233 = Scalar(0.357) * hu_12_a_z;
  const Scalar t234 = s_11 * (c_10 * t215 - t233 * (Scalar(0.056022408963585436) + s_10));
  const Scalar t235 = t221 * t232 - t227 + t234 * t217;
  const Scalar t236 = c_11 * t224;
  const Scalar t237 = Scalar(0.714) * t229;
  const Scalar t238 = Scalar(0.08) * hu_12_a_z;
  const Scalar t239 = t223 - t236 - t238 - t237 - Scalar(0.44815416666667);
  const Scalar t240 = t221 * t222 + mu_12_10_z * t217 + t239;
  const Scalar t241 = Scalar(1.0) / t240;
  const Scalar t242 = t235 * t241;
  const Scalar t243 = Scalar(-69.84866123397676) * t234;
  const Scalar y_10_9 = tau_9 - t242 * y_11_10 + t211 + t243 * y_12 + t232 * y_11;
  const Scalar t244 = t236 - t238 - Scalar(0.00555);
  const Scalar Ic_10_yy = Ic_11_zz + t237 + Scalar(0.40049083333333);
  const Scalar Ic_10_xy = t228 + t233 + Scalar(0.0549);
  const Scalar t245 = Scalar(2.0) * c_10 * Ic_10_xy - s_10 * (t244 + Ic_10_yy);
  const Scalar hc_10_x = t229 + Scalar(1.3725);
  const Scalar f_10_10_x = hu_12_a_z + Scalar(0.22);
  const Scalar hu_10_t_y = s_10 * f_10_10_x + c_10 * hc_10_x;
  const Scalar t246 = Scalar(0.00507) + Scalar(0.02) * hu_10_t_y + Ic_10_xy - c_10 * t245;
  const Scalar t247 = s_9 * s_11;
  const Scalar t248 = c_10 * f_10_10_x - s_10 * hc_10_x;
  const Scalar t249 = t248 - Scalar(0.08);
  const Scalar t250 = c_9 * t249 - hu_12_t_x * t247;
  const Scalar t251 = -t226 * t247 - c_9 * t246 + Scalar(0.389) * t250;
  const Scalar mu_u_11_10_t_x = s_10 * t228 + c_10 * t230;
  const Scalar t252 = Scalar(0.02) * hu_12_t_x;
  const Scalar t253 = t220 - c_10 * t252;
  const Scalar t254 = Scalar(0.389) * hu_12_t_x;
  const Scalar t255 = (c_9 * c_11 + s_10 * t247) * t254;
  const Scalar mu_11_8_z = t247 * t253 + c_9 * mu_u_11_10_t_x + t255;
  const Scalar t256 = mu_11_8_z * d_11;
  const Scalar t257 = c_10 * t220 - s_10 * t225;
  const Scalar t258 = c_9 * s_11;
  const Scalar t259 = Scalar(0.02) * t248 + t239 - Scalar(0.389) * hu_10_t_y;
  const Scalar t260 = c_11 * hu_12_a_z;
  const Scalar t261 = s_10 * t260 + c_10 * hu_12_t_x;
  const Scalar t262 = hu_12_a_z * t258 - s_9 * t261;
  const Scalar mu_12_9_y = mu_12_10_z - Scalar(0.02) * (c_10 * t260 - s_10 * hu_12_t_x);
  const Scalar t263 = s_10 * t215 + c_10 * t233;
  const Scalar t264 = t258 * t263 + Scalar(0.389) * t262 - s_9 * mu_12_9_y;
  const Scalar t265 = t257 * t258 - t221 * t256 + t264 * t217 - s_9 * t259;
  const Scalar t266 = Scalar(-69.84866123397676) * t264;
  const Scalar t267 = t234 * t266 + mu_11_8_z * t232 + t265 * t242 + t251;
  const Scalar t268 = s_10 * t245;
  const Scalar t269 = Scalar(-0.04) * t248;
  const Scalar t270 = t244 - t269 - Scalar(0.03800666666667) + t268;
  const Scalar t271 = t231 * t232 - t235 * t242 - t234 * t243 + t270;
  const Scalar t272 = Scalar(1.0) / t271;
  const Scalar t273 = t267 * t272;
  const Scalar f_9_y = Scalar(0.08) * t193 - t208;
  const Scalar t274 = Scalar(0.22) * U_10_xy + t212 + Scalar(1.3725) * t188;
  const Scalar t275 = -t213 - Scalar(0.22) * t199 + Scalar(1.3725) * t198;
  const Scalar f_9_x = Scalar(0.08) * t183 + c_10 * t275 + s_10 * t274;
  const Scalar f_u_9_t_x = s_9 * f_9_x + c_9 * f_9_y;
  const Scalar mu_9_x = Scalar(0.00507) * t193 + Scalar(0.05976333333334) * t210 + s_10 * t207 -
      c_10 * t209;
  const Scalar t276 = c_10 * t274 - s_10 * t275;
  const Scalar mu_9_y = Scalar(0.02175666666667) * t163 -
      Scalar(0.00507) * (t182 - omega_r_9_x * omega_r_9_x) + Scalar(0.08) * ddp_o_9_y -
      Scalar(0.03800666666667) * t180 + Scalar(0.02) * t276 - t214;
  const Scalar t277 = t265 * t241;
  const Scalar y_9_8 = s_9 * mu_9_y - Scalar(1.03624716666667) * t184 - c_9 * mu_9_x + tau_8 -
      Scalar(0.389) * f_u_9_t_x - Scalar(27.463095) * c_7 * s_8 + t266 * y_12 - t256 * y_11 -
      t277 * y_11_10 + t273 * y_10_9;
  const Scalar Iu_10_t_xx = t268 + Ic_10_yy;
  const Scalar t278 = Scalar(0.02175666666667) - t269 + t239;
  const Scalar Iu_9_t_d = Iu_10_t_xx + t278;
  const Scalar t279 = s_11 * t252 - s_11 * t257;
  const Scalar t280 = Scalar(2.0) * c_9 * t279 + s_9 * Iu_9_t_d;
  const Scalar t281 = c_8 * (t279 - c_9 * t280);
  const Scalar t282 = hu_12_t_x * t258 + s_9 * t249;
  const Scalar t283 = c_8 * (t226 * t258 - s_9 * t246 + Scalar(0.389) * t282);
  const Scalar t284 = (s_10 * t258 - s_9 * c_11) * t254;
  const Scalar t285 = c_8 * (t258 * t253 - s_9 * mu_u_11_10_t_x + t284) - s_8 * t231;
  const Scalar t286 = t285 * d_11;
  const Scalar t287 = c_8 * (t257 * t247 + c_9 * t259);
  const Scalar f_u_12_9_t_y = c_9 * t261 + hu_12_a_z * t247;
  const Scalar mu_12_8_x = t247 * t263 + Scalar(0.389) * f_u_12_9_t_y + c_9 * mu_12_9_y;
  const Scalar mu_u_12_8_t_y = c_8 * mu_12_8_x - s_8 * t234;
  const Scalar t288 = t221 * t286 + s_8 * t227 + mu_u_12_8_t_y * t217 + t287;
  const Scalar t289 = Scalar(69.84866123397676) * mu_u_12_8_t_y;
  const Scalar t290 = t288 * t242 - t234 * t289 - t285 * t232 + t283 + s_8 * t270;
  const Scalar t291 = -mu_u_12_8_t_y * t266 - t285 * t256 + t281 + s_8 * t251 - t288 * t277 -
      t290 * t273;
  const Scalar t292 = s_9 * t280;
  const Scalar t293 = Scalar(0.778) * hu_10_t_y;
  const Scalar b_9_8_8 = t264 * t266 - mu_11_8_z * t256 + Iu_10_t_xx - t292 + t265 * t277 +
      t267 * t273 + t293 + Scalar(1.03820716666667);
  const Scalar d_8 = Scalar(1.0) / b_9_8_8;
  const Scalar t294 = t291 * d_8;
  const Scalar t295 = c_9 * f_9_x - s_9 * f_9_y;
  const Scalar mu_8_x = c_9 * mu_9_y + s_9 * mu_9_x - Scalar(2.07445433333334) * t160 -
      Scalar(0.389) * t295 + Scalar(27.463095) * s_7;
  const Scalar t296 = s_8 * (Scalar(0.00196) * t162 + t211);
  const Scalar t297 = t290 * t272;
  const Scalar t298 = t288 * t241;
  const Scalar y_8_7 = tau_7 - t296 - c_8 * mu_8_x - t289 * y_12 + t286 * y_11 - t298 * y_11_10 +
      t297 * y_10_9 + t294 * y_9_8;
  const Scalar t299 = t278 - t292 - t293;
  const Scalar t300 = s_8 * (Scalar(2.0) * t283 + s_8 * (t270 - t299 + Scalar(1.03624716666667)));
  const Scalar t301 = mu_u_12_8_t_y * t289 + t285 * t286 - t288 * t298 + t291 * t294 - t290 * t297 +
      t299 + t300 - Scalar(1.04016716666667);
  const Scalar t302 = (Scalar(1.0) / t301) * y_8_7;
  qdd[6] = -t302;
  const Scalar qdd_2 = d_2 * (y_3_2 - t140 * t151);
  qdd[1] = qdd_2;
  const Scalar qdd_8 = d_8 * (y_9_8 - t291 * t302);
  qdd[7] = qdd_8;
  const Scalar t303 = t121 * (t139 * t151 - t116 * qdd_2 + y_4_3);
  qdd[2] = -t303;
  const Scalar t304 = t272 * (t290 * t302 - t267 * qdd_8 + y_10_9);
  qdd[8] = -t304;
  const Scalar t305 = t90 * (-t84 * t303 - t137 * t151 + y_5_4 + t114 * qdd_2);
  qdd[3] = -t305;
  const Scalar t306 = t241 * (-t235 * t304 - t288 * t302 + y_11_10 + t265 * qdd_8);
  qdd[9] = -t306;
  const Scalar t307 = -t70 * t305 - t134 * t151 - mu_5_2_z * qdd_2 - t80 * t303 + y_5;
  qdd[4] = d_5 * t307;
  const Scalar t308 = mu_u_6_2_t_y * t151 + mu_6_4_z * t305 + y_6;
  qdd[5] = Scalar(69.84866123397676) * (t83 * t303 - t113 * qdd_2) +
      Scalar(69.84866123397676) * t308;
  const Scalar t309 = -t221 * t306 - t285 * t302 - mu_11_8_z * qdd_8 - t231 * t304 + y_11;
  qdd[10] = d_11 * t309;
  const Scalar t310 = mu_u_12_8_t_y * t302 + mu_12_10_z * t306 + y_12;
  qdd[11] = Scalar(69.84866123397676) * (t234 * t304 - t264 * qdd_8) +
      Scalar(69.84866123397676) * t310;
  const Scalar t311 = s_32 * s_32;
  const Scalar t312 = Scalar(0.0005096) * t311;
  const Scalar t313 = t312 - Scalar(0.0005096);
  const Scalar t314 = s_31 * c_32;
  const Scalar t315 = c_31 * (t313 - Scalar(0.0235906)) - Scalar(0.0014964) * t314;
  const Scalar t316 = c_31 * t315;
  const Scalar t317 = t316 + Scalar(0.0235906);
  const Scalar Ic_31_zz = t312 + Scalar(0.0253235000000002);
  const Scalar Ic_30_yy = Ic_31_zz - Scalar(0.0253235000000002);
  const Scalar t318 = c_31 * c_32;
  const Scalar t319 = Scalar(0.6811013098102112) * t318 + s_31;
  const Scalar t320 = Scalar(0.0014964) * c_30 * s_32 * t319 - s_30 * (t317 + Ic_30_yy);
  const Scalar t321 = s_30 * t320;
  const Scalar t322 = Scalar(0.0094) * c_32;
  const Scalar hu_30_a_y = s_31 * t322 + Scalar(0.1902) * c_31;
  const Scalar t323 = Scalar(0.478) * hu_30_a_y;
  const Scalar Ic_29_xx = t321 + Ic_30_yy + t323;
  const Scalar mu_u_30_30_a_y = t313 - t316 - Scalar(0.0259635000000002);
  const Scalar hu_31_t_x = Scalar(0.1902) * s_31 - c_31 * t322;
  const Scalar t324 = Scalar(0.0094) * s_32;
  const Scalar t325 = c_30 * t324;
  const Scalar t326 = t325 - s_30 * hu_31_t_x;
  const Scalar t327 = Scalar(-0.008) * t326;
  const Scalar t328 = mu_u_30_30_a_y - t327 + Scalar(0.2262745000000002);
  const Scalar Iu_29_t_d = Ic_29_xx + t328;
  const Scalar t329 = Scalar(0.0007482) * c_32 + s_31 * t315;
  const Scalar t330 = c_31 - Scalar(0.6811013098102112) * t314;
  const Scalar t331 = Scalar(0.0007482) * s_32;
  const Scalar t332 = c_30 * t331;
  const Scalar t333 = t330 * t332 + s_30 * t329 + Scalar(0.239) * t326;
  const Scalar Ic_29_xy = Scalar(0.004) * hu_30_a_y + Scalar(0.0050592) - t333;
  const Scalar t334 = c_29 * Iu_29_t_d - Scalar(2.0) * s_29 * Ic_29_xy;
  const Scalar t335 = c_29 * t334;
  const Scalar t336 = t328 - t335;
  const Scalar t337 = t317 - t327 + t321 - t323 - Scalar(0.2298769000000002);
  const Scalar t338 = t326 - Scalar(0.0328);
  const Scalar hc_29_y = hu_30_a_y + Scalar(0.8648);
  const Scalar t339 = c_29 * t338 - s_29 * hc_29_y;
  const Scalar t340 = Scalar(-0.008) * t339;
  const Scalar t341 = t340 + t337 + Scalar(0.2282085000000002);
  const Scalar t342 = s_30 * t324;
  const Scalar hu_30_t_y = t342 + c_30 * hu_31_t_x;
  const Scalar t343 = Scalar(0.004) * hu_30_t_y;
  const Scalar t344 = -t319 * t331 - t343 + c_30 * t320;
  const Scalar t345 = s_30 * t331;
  const Scalar mu_30_29_z = t330 * t345 - c_30 * t329 + Scalar(0.239) * hu_30_t_y;
  const Scalar t346 = c_29 * t344 - s_29 * mu_30_29_z;
  const Scalar t347 = t343 + t346;
  const Scalar t348 = Scalar(2.0) * c_28 * t347 + s_28 * (t336 - t341);
  const Scalar t349 = s_28 * t348;
  const Scalar t350 = s_29 * t338 + c_29 * hc_29_y;
  const Scalar t351 = Scalar(-0.61) * t350;
  const Scalar t352 = t349 + t341 + t351;
  const Scalar Ic_28_zz = Ic_29_xx - t340 - t335 + Scalar(0.2360429000000002);
  const Scalar Ic_27_yy = Ic_28_zz - Scalar(0.7059807000000002);
  const Scalar t353 = Scalar(-0.004) * t350 - Scalar(0.0023) + Ic_29_xy + s_29 * t334;
  const Scalar t354 = s_29 * t344 + c_29 * mu_30_29_z;
  const Scalar t355 = t339 - Scalar(0.0032);
  const Scalar t356 = c_28 * hu_30_t_y;
  const Scalar t357 = t356 + s_28 * t355;
  const Scalar t358 = c_28 * t354 - s_28 * t353 + Scalar(0.305) * t357;
  const Scalar t359 = c_27 * t358;
  const Scalar t360 = Scalar(2.0) * t359 - s_27 * (t352 + Ic_27_yy);
  const Scalar t361 = s_27 * t360;
  const Scalar Iu_27_t_xx = t361 + Ic_27_yy;
  const Scalar t362 = t336 - t349 + t351 - Scalar(0.7079407000000002);
  const Scalar t363 = t362 + Scalar(0.7079407000000002);
  const Scalar Iu_26_t_d = Iu_27_t_xx + t363;
  const Scalar Iu_28_a_yz = t347 - c_28 * t348;
  const Scalar t364 = s_28 * hu_30_t_y;
  const Scalar t365 = c_28 * t355 - t364;
  const Scalar t366 = -s_28 * t354 - c_28 * t353 + Scalar(0.305) * t365;
  const Scalar Iu_27_a_xz = c_27 * t366 + s_27 * Iu_28_a_yz;
  const Scalar t367 = s_26 * Iu_27_a_xz;
  const Scalar t368 = c_26 * Iu_26_t_d - Scalar(2.0) * t367;
  const Scalar t369 = s_25 * s_25;
  const Scalar t370 = Scalar(0.0005096) * t369;
  const Scalar t371 = t370 - Scalar(0.0005096);
  const Scalar t372 = s_24 * c_25;
  const Scalar t373 = Scalar(0.0014964) * t372 + c_24 * (t371 - Scalar(0.0235906));
  const Scalar t374 = c_24 * t373;
  const Scalar t375 = t374 + Scalar(0.0235906);
  const Scalar Ic_24_zz = t370 + Scalar(0.0253235000000002);
  const Scalar Ic_23_yy = Ic_24_zz - Scalar(0.0253235000000002);
  const Scalar t376 = c_24 * c_25;
  const Scalar t377 = s_24 - Scalar(0.6811013098102112) * t376;
  const Scalar t378 = Scalar(0.0014964) * c_23 * s_25 * t377 + s_23 * (t375 + Ic_23_yy);
  const Scalar t379 = s_23 * t378;
  const Scalar t380 = Scalar(0.0094) * c_25;
  const Scalar hu_23_a_y = Scalar(0.1902) * c_24 - s_24 * t380;
  const Scalar t381 = Scalar(0.478) * hu_23_a_y;
  const Scalar Ic_22_xx = Ic_23_yy - t379 + t381;
  const Scalar mu_u_23_23_a_y = t371 - t374 - Scalar(0.0259635000000002);
  const Scalar hu_24_t_x = c_24 * t380 + Scalar(0.1902) * s_24;
  const Scalar t382 = Scalar(0.0094) * s_25;
  const Scalar t383 = c_23 * t382;
  const Scalar t384 = t383 + s_23 * hu_24_t_x;
  const Scalar t385 = Scalar(0.008) * t384;
  const Scalar t386 = mu_u_23_23_a_y - t385 + Scalar(0.2262745000000002);
  const Scalar Iu_22_t_d = Ic_22_xx + t386;
  const Scalar Iu_24_t_xy = Scalar(0.0007482) * c_25 - s_24 * t373;
  const Scalar t387 = Scalar(0.6811013098102112) * t372 + c_24;
  const Scalar t388 = Scalar(0.0007482) * s_25;
  const Scalar t389 = c_23 * t388;
  const Scalar t390 = t387 * t389 + s_23 * Iu_24_t_xy + Scalar(0.239) * t384;
  const Scalar Ic_22_xy = Scalar(0.004) * hu_23_a_y + Scalar(0.0050592) + t390;
  const Scalar t391 = c_22 * Iu_22_t_d - Scalar(2.0) * s_22 * Ic_22_xy;
  const Scalar t392 = c_22 * t391;
  const Scalar t393 = t386 - t392;
  const Scalar t394 = t375 - t385 - t379 - t381 - Scalar(0.2298769000000002);
  const Scalar t395 = Scalar(0.0328) + t384;
  const Scalar hc_22_y = hu_23_a_y + Scalar(0.8648);
  const Scalar f_u_22_22_a_z = c_22 * t395 + s_22 * hc_22_y;
  const Scalar t396 = Scalar(0.008) * f_u_22_22_a_z;
  const Scalar t397 = t396 + t394 + Scalar(0.2282085000000002);
  const Scalar t398 = s_23 * t382;
  const Scalar t399 = c_23 * hu_24_t_x - t398;
  const Scalar t400 = Scalar(-0.004) * t399;
  const Scalar t401 = -t377 * t388 - t400 + c_23 * t378;
  const Scalar t402 = s_23 * t388;
  const Scalar t403 = c_23 * Iu_24_t_xy - t387 * t402 + Scalar(0.239) * t399;
  const Scalar t404 = c_22 * t401 + s_22 * t403;
  const Scalar t405 = t400 + t404;
  const Scalar t406 = Scalar(2.0) * c_21 * t405 - s_21 * (t393 - t397);
  const Scalar t407 = s_21 * t406;
  const Scalar t408 = c_22 * hc_22_y - s_22 * t395;
  const Scalar t409 = Scalar(-0.61) * t408;
  const Scalar t410 = t397 - t407 + t409;
  const Scalar t411 = Ic_22_xx - t396 - t392 + Scalar(0.2360429000000002);
  const Scalar t412 = t411 - Scalar(0.7059807000000002);
  const Scalar t413 = Scalar(-0.004) * t408 - Scalar(0.0023) + Ic_22_xy + s_22 * t391;
  const Scalar t414 = c_22 * t403 - s_22 * t401;
  const Scalar t415 = Scalar(0.0032) + f_u_22_22_a_z;
  const Scalar t416 = c_21 * t399;
  const Scalar t417 = t416 - s_21 * t415;
  const Scalar t418 = c_21 * t414 - s_21 * t413 + Scalar(0.305) * t417;
  const Scalar t419 = c_20 * t418;
  const Scalar t420 = Scalar(2.0) * t419 - s_20 * (t410 + t412);
  const Scalar t421 = s_20 * t420;
  const Scalar t422 = t421 + t412;
  const Scalar t423 = t407 + t393 + t409 - Scalar(0.7079407000000002);
  const Scalar t424 = t423 + Scalar(0.7079407000000002);
  const Scalar t425 = t405 - c_21 * t406;
  const Scalar t426 = s_21 * t399;
  const Scalar t427 = t426 + c_21 * t415;
  const Scalar t428 = s_21 * t414 + c_21 * t413 + Scalar(0.305) * t427;
  const Scalar t429 = c_20 * t428 + s_20 * t425;
  const Scalar t430 = s_19 * t429;
  const Scalar t431 = Scalar(2.0) * t430 + c_19 * (t422 + t424);
  const Scalar t432 = c_26 * t368 + c_19 * t431;
  const Scalar t433 = t350 + Scalar(1.661);
  const Scalar t434 = c_27 * t357 + s_27 * t433;
  const Scalar t435 = t408 + Scalar(1.661);
  const Scalar t436 = c_20 * t417 + s_20 * t435;
  const Scalar t437 = Scalar(-0.48) * (t434 - t436);
  const Scalar Iu_18_t_g = Scalar(0.0044) * c_18 + Scalar(0.024) * s_18;
  const Scalar t438 = s_18 * Iu_18_t_g;
  const Scalar Iu_18_t_xx = t438 - Scalar(0.024);
  const Scalar Iu_17_t_d = Iu_18_t_xx - Scalar(0.0002);
  const Scalar t439 = s_17 * s_17;
  const Scalar t440 = Iu_17_t_d * t439;
  const Scalar Ic_16_zz = Iu_18_t_xx - t440 + Scalar(0.035005);
  const Scalar hu_18_a_z = Scalar(0.02) * c_18 + Scalar(0.22) * s_18;
  const Scalar f_u_18_18_a_z = Scalar(0.22) * c_18 - Scalar(0.02) * s_18;
  const Scalar t441 = s_16 * s_17;
  const Scalar hu_16_a_z = c_16 * hu_18_a_z + f_u_18_18_a_z * t441;
  const Scalar t442 = Scalar(0.006) * hu_16_a_z;
  const Scalar t443 = t442 - Ic_16_zz + t437 + t363 + t424 - t432;
  const Scalar t444 = t361 + t352 - Scalar(0.7099007000000002);
  const Scalar t445 = t421 + t410 - Scalar(0.7099007000000002);
  const Scalar hu_27_t_x = c_27 * t433 - s_27 * t357;
  const Scalar t446 = s_26 * t365;
  const Scalar t447 = t446 + c_26 * hu_27_t_x;
  const Scalar hu_20_t_x = c_20 * t435 - s_20 * t417;
  const Scalar t448 = s_19 * t427;
  const Scalar hu_19_t_x = c_19 * hu_20_t_x - t448;
  const Scalar t449 = c_17 * f_u_18_18_a_z;
  const Scalar t450 = Scalar(0.66) * (t447 + hu_19_t_x) - Scalar(0.906) * t449;
  const Scalar Iu_17_t_xx = Scalar(0.0002) + t440;
  const Scalar Iu_16_t_d = t438 + Iu_17_t_xx;
  const Scalar Iu_18_a_yz = c_18 * Iu_18_t_g - Scalar(0.0022);
  const Scalar t451 = Iu_18_a_yz * t441;
  const Scalar Iu_16_t_g = c_16 * Iu_16_t_d + Scalar(2.0) * t451;
  const Scalar t452 = c_16 * Iu_16_t_g;
  const Scalar t453 = t442 + t438 - t452 + t450 - Scalar(0.5912714333326666) + t444 + t445;
  const Scalar t454 = t418 - c_20 * t420;
  const Scalar t455 = c_20 * t425 - s_20 * t428;
  const Scalar t456 = Scalar(0.24) * hu_19_t_x - s_19 * t455 + c_19 * t454;
  const Scalar t457 = t358 - c_27 * t360;
  const Scalar Iu_27_t_yz = c_27 * Iu_28_a_yz - s_27 * t366;
  const Scalar t458 = Scalar(0.24) * t447 - s_26 * Iu_27_t_yz - c_26 * t457;
  const Scalar t459 = c_16 * s_17;
  const Scalar t460 = f_u_18_18_a_z * t459 - s_16 * hu_18_a_z;
  const Scalar t461 = Scalar(0.453) * t460 - c_17 * (Iu_17_t_d * t459 + s_16 * Iu_18_a_yz);
  const Scalar t462 = t456 - t461 - t458 + Scalar(0.33) * (t434 + t436);
  const Scalar t463 = c_15 * (t443 - t453) + Scalar(2.0) * s_15 * t462;
  const Scalar t464 = c_15 * t463;
  const Scalar t465 = t453 + t464;
  const Scalar t466 = Iu_17_t_xx - t452 + Iu_27_t_xx + t422 - t437 - t450 - t432 +
      Scalar(5.512820899999667);
  const Scalar t467 = c_26 * t365;
  const Scalar t468 = t467 - s_26 * hu_27_t_x;
  const Scalar t469 = c_19 * t427;
  const Scalar hu_19_t_y = t469 + s_19 * hu_20_t_x;
  const Scalar t470 = c_16 * Iu_18_a_yz;
  const Scalar t471 = c_17 * (t470 - Iu_17_t_d * t441) + Scalar(0.453) * hu_16_a_z;
  const Scalar t472 = Scalar(0.003) * f_u_18_18_a_z;
  const Scalar t473 = c_17 * t472 - t471 - Scalar(0.043998) + Iu_27_a_xz - t429 -
      Scalar(0.33) * (t468 - hu_19_t_y) + s_26 * t368 + s_19 * t431;
  const Scalar t474 = Scalar(0.24) * hu_19_t_y + c_19 * t455 + s_19 * t454;
  const Scalar t475 = Scalar(0.24) * t468 - c_26 * Iu_27_t_yz + s_26 * t457;
  const Scalar t476 = Scalar(0.003) * t460 - s_17 * Iu_18_a_yz + s_16 * Iu_16_t_g + t474 + t475;
  const Scalar t477 = c_14 * (c_15 * t473 - s_15 * t476);
  const Scalar t478 = s_14 * (Scalar(2.0) * t477 -
      s_14 * (t465 - Scalar(2.5051100666670005) + t466));
  const Scalar t479 = c_14 * (t462 - s_15 * t463);
  const Scalar t480 = Scalar(0.33) * t447 + t444;
  const Scalar t481 = c_14 * (c_15 * t458 - s_15 * t480);
  const Scalar t482 = t362 - Scalar(0.24) * t434;
  const Scalar t483 = c_26 * Iu_27_a_xz + s_26 * t482;
  const Scalar mu_27_15_y = Iu_27_t_yz + Scalar(0.33) * s_26 * t434;
  const Scalar t484 = c_14 * (s_15 * mu_27_15_y + c_15 * t483);
  const Scalar t485 = s_27 * t358 + c_27 * Ic_28_zz;
  const Scalar f_u_28_26_t_y = c_26 * t357 - s_27 * t446;
  const Scalar t486 = Scalar(0.24) * f_u_28_26_t_y - s_26 * t366 + c_26 * t485;
  const Scalar t487 = t359 - s_27 * Ic_28_zz;
  const Scalar t488 = t487 - Scalar(0.33) * f_u_28_26_t_y;
  const Scalar t489 = c_14 * (c_15 * t486 + s_15 * t488);
  const Scalar t490 = t337 - Scalar(0.004) * t339 - Scalar(0.305) * t350;
  const Scalar t491 = s_28 * t346 + c_28 * t490;
  const Scalar t492 = c_27 * t354 - s_27 * t491;
  const Scalar t493 = c_28 * t346 - s_28 * t490;
  const Scalar t494 = s_28 * t350;
  const Scalar t495 = c_27 * t339 + s_27 * t494;
  const Scalar t496 = c_28 * t350;
  const Scalar t497 = c_26 * t496 + s_26 * t495;
  const Scalar t498 = Scalar(0.24) * t497 + c_26 * t492 + s_26 * t493;
  const Scalar t499 = s_27 * t354 + c_27 * t491;
  const Scalar t500 = t499 + Scalar(0.33) * t497;
  const Scalar t501 = c_14 * (c_15 * t498 - s_15 * t500);
  const Scalar t502 = Scalar(-0.004) * t326;
  const Scalar mu_30_29_y = mu_u_30_30_a_y - t502;
  const Scalar t503 = c_29 * t333 - s_29 * mu_30_29_y;
  const Scalar t504 = s_29 * hu_30_t_y;
  const Scalar mu_30_28_y = mu_30_29_z - Scalar(0.004) * t504;
  const Scalar t505 = c_29 * t356 + s_28 * t326;
  const Scalar t506 = Scalar(0.305) * t505 + c_28 * mu_30_28_y + s_28 * t503;
  const Scalar t507 = t502 + c_29 * mu_30_29_y + s_29 * t333;
  const Scalar t508 = c_27 * t507 - s_27 * t506;
  const Scalar t509 = c_28 * t326 - c_29 * t364;
  const Scalar t510 = Scalar(0.305) * t509 + c_28 * t503 - s_28 * mu_30_28_y;
  const Scalar t511 = c_27 * t504 + s_27 * t509;
  const Scalar f_u_30_26_t_y = c_26 * t505 - s_26 * t511;
  const Scalar t512 = Scalar(0.24) * f_u_30_26_t_y - c_26 * t508 - s_26 * t510;
  const Scalar t513 = c_27 * t506 + s_27 * t507;
  const Scalar t514 = t513 - Scalar(0.33) * f_u_30_26_t_y;
  const Scalar t515 = c_14 * (c_15 * t512 + s_15 * t514);
  const Scalar f_u_32_30_t_y = c_31 * t325 + s_30 * t322;
  const Scalar t516 = Scalar(0.004) * f_u_32_30_t_y;
  const Scalar mu_u_32_31_t_y = Scalar(0.0014129000000002) * c_31 - Scalar(0.0007482) * t314;
  const Scalar t517 = mu_u_32_31_t_y - t516;
  const Scalar t518 = Scalar(0.0007482) * t318 + Scalar(0.0014129000000002) * s_31;
  const Scalar mu_32_29_x = t332 + s_30 * t518 + Scalar(0.239) * f_u_32_30_t_y;
  const Scalar mu_u_32_29_t_x = s_29 * t517 + c_29 * mu_32_29_x;
  const Scalar t519 = c_30 * t322 - c_31 * t342;
  const Scalar t520 = s_31 * t324;
  const Scalar f_u_32_29_t_x = s_29 * t520 + c_29 * t519;
  const Scalar t521 = c_28 * f_u_32_29_t_x - s_28 * f_u_32_30_t_y;
  const Scalar f_u_32_29_a_z = c_29 * t520 - s_29 * t519;
  const Scalar mu_32_29_z = Scalar(0.0000376) * s_31 * s_32 + t345 - c_30 * t518 -
      Scalar(0.239) * t519;
  const Scalar mu_32_28_y = mu_32_29_z - Scalar(0.004) * f_u_32_29_a_z;
  const Scalar t522 = Scalar(0.305) * t521 - s_28 * mu_u_32_29_t_x - c_28 * mu_32_28_y;
  const Scalar mu_32_28_z = t516 + c_29 * t517 - s_29 * mu_32_29_x;
  const Scalar t523 = c_27 * mu_32_28_z - s_27 * t522;
  const Scalar f_u_32_28_t_x = s_28 * f_u_32_29_t_x + c_28 * f_u_32_30_t_y;
  const Scalar t524 = c_27 * f_u_32_29_a_z + s_27 * f_u_32_28_t_x;
  const Scalar f_u_32_26_a_z = c_26 * t521 + s_26 * t524;
  const Scalar mu_32_27_z = c_28 * mu_u_32_29_t_x + Scalar(0.305) * f_u_32_28_t_x -
      s_28 * mu_32_28_y;
  const Scalar mu_32_15_x = Scalar(0.24) * f_u_32_26_a_z - c_26 * t523 + s_26 * mu_32_27_z;
  const Scalar t525 = s_27 * mu_32_28_z + c_27 * t522;
  const Scalar t526 = t525 - Scalar(0.33) * f_u_32_26_a_z;
  const Scalar mu_u_32_15_t_x = c_15 * mu_32_15_x + s_15 * t526;
  const Scalar t527 = c_26 * t524 - s_26 * t521;
  const Scalar t528 = c_27 * f_u_32_28_t_x - s_27 * f_u_32_29_a_z;
  const Scalar t529 = Scalar(0.33) * t528 - Scalar(0.24) * t527 - c_26 * mu_32_27_z - s_26 * t523;
  const Scalar mu_u_32_14_t_y = c_14 * mu_u_32_15_t_x - s_14 * t529;
  const Scalar t530 = Scalar(0.5295491542217383) * s_32;
  const Scalar t531 = Ic_31_zz + Scalar(0.239) * hu_30_a_y;
  const Scalar mu_31_29_x = t319 * t345 + c_30 * t531;
  const Scalar t532 = c_30 * hu_30_a_y;
  const Scalar t533 = Scalar(0.004) * t532;
  const Scalar t534 = t330 * t331;
  const Scalar t535 = t533 - t534;
  const Scalar t536 = c_29 * mu_31_29_x - s_29 * t535;
  const Scalar t537 = s_30 * hu_30_a_y;
  const Scalar t538 = c_29 * t537 - s_29 * hu_31_t_x;
  const Scalar f_u_31_28_t_y = c_28 * t538 + s_28 * t532;
  const Scalar mu_31_29_z = Scalar(0.004) * hu_31_t_x - t319 * t332 + s_30 * t531;
  const Scalar f_u_31_29_a_z = c_29 * hu_31_t_x + s_29 * t537;
  const Scalar mu_31_28_y = mu_31_29_z - Scalar(0.004) * f_u_31_29_a_z;
  const Scalar mu_31_27_x = s_28 * t536 + c_28 * mu_31_28_y + Scalar(0.305) * f_u_31_28_t_y;
  const Scalar mu_31_28_z = t533 - c_29 * t535 - s_29 * mu_31_29_x;
  const Scalar t539 = c_27 * mu_31_28_z + s_27 * mu_31_27_x;
  const Scalar f_u_31_28_t_x = c_28 * t532 - s_28 * t538;
  const Scalar t540 = c_27 * f_u_31_29_a_z + s_27 * f_u_31_28_t_x;
  const Scalar t541 = c_26 * f_u_31_28_t_y - s_26 * t540;
  const Scalar mu_31_27_z = c_28 * t536 - s_28 * mu_31_28_y + Scalar(0.305) * f_u_31_28_t_x;
  const Scalar t542 = Scalar(0.24) * t541 + c_26 * t539 - s_26 * mu_31_27_z;
  const Scalar t543 = c_27 * mu_31_27_x - s_27 * mu_31_28_z;
  const Scalar t544 = t543 - Scalar(0.33) * t541;
  const Scalar t545 = c_14 * (c_15 * t542 + s_15 * t544);
  const Scalar t546 = c_26 * t540 + s_26 * f_u_31_28_t_y;
  const Scalar t547 = c_27 * f_u_31_28_t_x - s_27 * f_u_31_29_a_z;
  const Scalar t548 = Scalar(-0.24) * t546 - c_26 * mu_31_27_z - s_26 * t539 + Scalar(0.33) * t547;
  const Scalar b_32_31_13 = mu_u_32_14_t_y * t530 + t545 + s_14 * t548;
  const Scalar t549 = Scalar(0.00039620867718870463) * t311 - Ic_31_zz;
  const Scalar t550 = Scalar(1.0) / t549;
  const Scalar t551 = t534 - mu_u_32_31_t_y * t530;
  const Scalar t552 = t551 * t550;
  const Scalar t553 = c_26 * t511 + s_26 * t505;
  const Scalar t554 = c_27 * t509 - s_27 * t504;
  const Scalar t555 = Scalar(0.33) * t554 - Scalar(0.24) * t553 - c_26 * t510 + s_26 * t508;
  const Scalar t556 = Scalar(707.7641729774637) * mu_u_32_31_t_y;
  const Scalar t557 = mu_u_32_14_t_y * t556 + b_32_31_13 * t552 + t515 + s_14 * t555;
  const Scalar b_32_31_29 = mu_31_29_z - mu_32_29_z * t530;
  const Scalar b_31_30_29 = b_32_31_29 * t552 - mu_32_29_z * t556 + mu_30_29_z;
  const Scalar t558 = mu_u_32_31_t_y * t556 - t551 * t552 + mu_u_30_30_a_y;
  const Scalar t559 = Scalar(1.0) / t558;
  const Scalar t560 = b_31_30_29 * t559;
  const Scalar f_u_29_26_t_x = c_26 * t495 - s_26 * t496;
  const Scalar t561 = c_27 * t494 - s_27 * t339;
  const Scalar mu_29_15_z = s_26 * t492 - Scalar(0.24) * f_u_29_26_t_x + Scalar(0.33) * t561 -
      c_26 * t493;
  const Scalar t562 = b_32_31_29 * t550;
  const Scalar t563 = Scalar(707.7641729774637) * mu_32_29_z;
  const Scalar t564 = mu_u_32_14_t_y * t563 + b_32_31_13 * t562 + t557 * t560 + t501 -
      s_14 * mu_29_15_z;
  const Scalar b_32_31_28 = mu_31_28_z - mu_32_28_z * t530;
  const Scalar t565 = mu_32_28_z * t556 - b_32_31_28 * t552 + t507;
  const Scalar t566 = t354 - mu_32_28_z * t563 + b_32_31_28 * t562 - t565 * t560;
  const Scalar t567 = mu_32_29_z * t563 - b_31_30_29 * t560 - b_32_31_29 * t562 + t337;
  const Scalar t568 = Scalar(1.0) / t567;
  const Scalar t569 = t566 * t568;
  const Scalar t570 = s_27 * t467 + s_26 * t357;
  const Scalar t571 = Scalar(0.24) * t570 - Scalar(0.33) * c_27 * t365 + c_26 * t366 + s_26 * t485;
  const Scalar t572 = t565 * t559;
  const Scalar t573 = b_32_31_28 * t550;
  const Scalar t574 = Scalar(707.7641729774637) * mu_32_28_z;
  const Scalar t575 = mu_u_32_14_t_y * t574 + b_32_31_13 * t573 - t557 * t572 + t564 * t569 + t489 -
      s_14 * t571;
  const Scalar b_32_31_27 = mu_31_27_z - mu_32_27_z * t530;
  const Scalar t576 = b_32_31_27 * t552 - mu_32_27_z * t556 + t510;
  const Scalar t577 = mu_32_27_z * t563 - t576 * t560 - b_32_31_27 * t562 + t493;
  const Scalar t578 = b_32_31_27 * t573 - mu_32_27_z * t574 - t576 * t572 - t577 * t569 + t366;
  const Scalar b_29_28_28 = t566 * t569 - mu_32_28_z * t574 + b_32_31_28 * t573 + t565 * t572 +
      Ic_28_zz;
  const Scalar d_28 = Scalar(1.0) / b_29_28_28;
  const Scalar t579 = t578 * d_28;
  const Scalar mu_u_27_15_a_y = Scalar(0.33) * hu_27_t_x - t367 + c_26 * t482;
  const Scalar t580 = t577 * t568;
  const Scalar t581 = t576 * t559;
  const Scalar t582 = b_32_31_27 * t550;
  const Scalar t583 = Scalar(707.7641729774637) * mu_32_27_z;
  const Scalar t584 = mu_u_32_14_t_y * t583 + t557 * t581 + b_32_31_13 * t582 - t564 * t580 -
      t575 * t579 + t484 + s_14 * mu_u_27_15_a_y;
  const Scalar t585 = t525 * t530 + t543;
  const Scalar t586 = t585 * t552 + t525 * t556 + t513;
  const Scalar t587 = -t525 * t563 - t586 * t560 - t585 * t562 + t499;
  const Scalar t588 = t525 * t574 + t585 * t573 - t586 * t572 - t587 * t569 + t487;
  const Scalar b_28_27_26 = t525 * t583 + t585 * t582 + t586 * t581 + Iu_27_t_yz + t587 * t580 -
      t588 * t579;
  const Scalar t589 = mu_32_27_z * t583 - b_32_31_27 * t582 - t576 * t581 + t578 * t579 -
      t577 * t580 + t362;
  const Scalar t590 = Scalar(1.0) / t589;
  const Scalar t591 = b_28_27_26 * t590;
  const Scalar t592 = t588 * d_28;
  const Scalar t593 = t587 * t568;
  const Scalar t594 = t586 * t559;
  const Scalar t595 = t585 * t550;
  const Scalar t596 = Scalar(707.7641729774637) * t525;
  const Scalar t597 = b_32_31_13 * t595 - mu_u_32_14_t_y * t596 + t557 * t594 - t564 * t593 -
      t575 * t592 + t584 * t591 + s_14 * t475 + t481;
  const Scalar t598 = t548 - t529 * t530;
  const Scalar t599 = t598 * t552 - t529 * t556 + t555;
  const Scalar b_30_29_15 = t529 * t563 - t599 * t560 - t598 * t562 + mu_29_15_z;
  const Scalar t600 = t529 * t574 - t598 * t573 + t599 * t572 + b_30_29_15 * t569 + t571;
  const Scalar t601 = t599 * t581 - t529 * t583 + t598 * t582 + t600 * t579 + b_30_29_15 * t580 +
      mu_u_27_15_a_y;
  const Scalar t602 = t529 * t596 + t599 * t594 + t598 * t595 + b_30_29_15 * t593 + t600 * t592 +
      t475 + t601 * t591;
  const Scalar t603 = t525 * t596 - t585 * t595 - t586 * t594 - t587 * t593 - b_28_27_26 * t591 +
      t588 * t592 + t444;
  const Scalar t604 = Scalar(1.0) / t603;
  const Scalar t605 = t602 * t604;
  const Scalar t606 = Scalar(0.33) * hu_19_t_x + t445;
  const Scalar mu_u_19_15_t_x = c_15 * t456 + s_15 * t606;
  const Scalar t607 = Scalar(0.24) * t436 + t423;
  const Scalar t608 = c_19 * t429 - s_19 * t607;
  const Scalar t609 = t455 - Scalar(0.33) * s_19 * t436;
  const Scalar t610 = c_14 * (s_15 * t609 + c_15 * t608);
  const Scalar t611 = s_20 * t418 + c_20 * t411;
  const Scalar t612 = s_20 * t448 + c_19 * t417;
  const Scalar t613 = Scalar(0.24) * t612 - s_19 * t428 - c_19 * t611;
  const Scalar t614 = t419 - s_20 * t411;
  const Scalar t615 = t614 - Scalar(0.33) * t612;
  const Scalar mu_u_21_15_t_x = c_15 * t613 - s_15 * t615;
  const Scalar t616 = Scalar(0.004) * f_u_22_22_a_z + t394 - Scalar(0.305) * t408;
  const Scalar t617 = s_21 * t404 - c_21 * t616;
  const Scalar t618 = c_20 * t414 + s_20 * t617;
  const Scalar t619 = c_21 * t404 + s_21 * t616;
  const Scalar t620 = s_21 * t408;
  const Scalar t621 = c_20 * f_u_22_22_a_z - s_20 * t620;
  const Scalar t622 = c_21 * t408;
  const Scalar t623 = c_19 * t622 - s_19 * t621;
  const Scalar t624 = Scalar(0.24) * t623 - c_19 * t618 + s_19 * t619;
  const Scalar t625 = c_20 * t617 - s_20 * t414;
  const Scalar t626 = t625 - Scalar(0.33) * t623;
  const Scalar t627 = c_14 * (c_15 * t624 - s_15 * t626);
  const Scalar t628 = Scalar(0.004) * t384;
  const Scalar mu_23_22_y = mu_u_23_23_a_y - t628;
  const Scalar t629 = c_22 * t390 + s_22 * mu_23_22_y;
  const Scalar t630 = s_22 * t399;
  const Scalar t631 = t403 - Scalar(0.004) * t630;
  const Scalar t632 = c_22 * t416 - s_21 * t384;
  const Scalar t633 = Scalar(0.305) * t632 + c_21 * t631 - s_21 * t629;
  const Scalar t634 = t628 + c_22 * mu_23_22_y - s_22 * t390;
  const Scalar mu_u_23_20_t_x = c_20 * t634 - s_20 * t633;
  const Scalar t635 = c_22 * t426 + c_21 * t384;
  const Scalar t636 = Scalar(0.305) * t635 + c_21 * t629 + s_21 * t631;
  const Scalar t637 = c_20 * t630 - s_20 * t635;
  const Scalar t638 = c_19 * t632 - s_19 * t637;
  const Scalar t639 = Scalar(0.24) * t638 + c_19 * mu_u_23_20_t_x - s_19 * t636;
  const Scalar mu_u_23_20_t_y = c_20 * t633 + s_20 * t634;
  const Scalar mu_23_15_y = mu_u_23_20_t_y - Scalar(0.33) * t638;
  const Scalar t640 = c_14 * (c_15 * t639 - s_15 * mu_23_15_y);
  const Scalar t641 = c_24 * t383 + s_23 * t380;
  const Scalar t642 = Scalar(0.004) * t641;
  const Scalar mu_u_25_24_t_y = Scalar(0.0007482) * t372 + Scalar(0.0014129000000002) * c_24;
  const Scalar t643 = t642 + mu_u_25_24_t_y;
  const Scalar t644 = Scalar(0.0014129000000002) * s_24 - Scalar(0.0007482) * t376;
  const Scalar t645 = t389 - s_23 * t644 + Scalar(0.239) * t641;
  const Scalar t646 = c_22 * t645 - s_22 * t643;
  const Scalar t647 = c_23 * t380 - c_24 * t398;
  const Scalar t648 = s_24 * t382;
  const Scalar t649 = s_22 * t648 + c_22 * t647;
  const Scalar t650 = c_21 * t649 - s_21 * t641;
  const Scalar f_u_25_22_t_y = c_22 * t648 - s_22 * t647;
  const Scalar t651 = Scalar(0.0000376) * s_24 * s_25 + t402 + c_23 * t644 - Scalar(0.239) * t647;
  const Scalar t652 = t651 - Scalar(0.004) * f_u_25_22_t_y;
  const Scalar t653 = Scalar(0.305) * t650 - s_21 * t646 - c_21 * t652;
  const Scalar t654 = t642 - c_22 * t643 - s_22 * t645;
  const Scalar mu_u_25_20_t_x = c_20 * t654 - s_20 * t653;
  const Scalar t655 = s_21 * t649 + c_21 * t641;
  const Scalar f_u_25_20_t_x = c_20 * f_u_25_22_t_y + s_20 * t655;
  const Scalar f_u_25_19_t_y = c_19 * t650 + s_19 * f_u_25_20_t_x;
  const Scalar mu_u_25_20_a_y = c_21 * t646 + Scalar(0.305) * t655 - s_21 * t652;
  const Scalar mu_25_15_x = Scalar(0.24) * f_u_25_19_t_y + c_19 * mu_u_25_20_t_x -
      s_19 * mu_u_25_20_a_y;
  const Scalar mu_u_25_20_t_y = s_20 * t654 + c_20 * t653;
  const Scalar mu_25_15_y = mu_u_25_20_t_y - Scalar(0.33) * f_u_25_19_t_y;
  const Scalar f_u_25_19_t_x = c_19 * f_u_25_20_t_x - s_19 * t650;
  const Scalar t656 = c_20 * t655 - s_20 * f_u_25_22_t_y;
  const Scalar t657 = Scalar(0.33) * t656 + Scalar(0.24) * f_u_25_19_t_x - c_19 * mu_u_25_20_a_y -
      s_19 * mu_u_25_20_t_x;
  const Scalar t658 = c_14 * (c_15 * mu_25_15_x - s_15 * mu_25_15_y) + s_14 * t657;
  const Scalar t659 = Scalar(0.5295491542217383) * s_25;
  const Scalar t660 = Ic_24_zz + Scalar(0.239) * hu_23_a_y;
  const Scalar t661 = t377 * t402 - c_23 * t660;
  const Scalar t662 = c_23 * hu_23_a_y;
  const Scalar t663 = Scalar(0.004) * t662;
  const Scalar t664 = t387 * t388;
  const Scalar mu_24_22_y = t663 + t664;
  const Scalar t665 = s_22 * mu_24_22_y + c_22 * t661;
  const Scalar t666 = s_23 * hu_23_a_y;
  const Scalar t667 = c_22 * t666 - s_22 * hu_24_t_x;
  const Scalar f_u_24_21_t_y = c_21 * t667 + s_21 * t662;
  const Scalar mu_24_22_z = t377 * t389 + Scalar(0.004) * hu_24_t_x + s_23 * t660;
  const Scalar f_u_24_22_a_z = c_22 * hu_24_t_x + s_22 * t666;
  const Scalar mu_24_21_y = mu_24_22_z - Scalar(0.004) * f_u_24_22_a_z;
  const Scalar mu_24_20_x = c_21 * mu_24_21_y - s_21 * t665 + Scalar(0.305) * f_u_24_21_t_y;
  const Scalar mu_24_21_z = t663 - c_22 * mu_24_22_y + s_22 * t661;
  const Scalar t668 = c_20 * mu_24_21_z + s_20 * mu_24_20_x;
  const Scalar f_u_24_21_t_x = c_21 * t662 - s_21 * t667;
  const Scalar t669 = c_20 * f_u_24_22_a_z + s_20 * f_u_24_21_t_x;
  const Scalar t670 = c_19 * f_u_24_21_t_y - s_19 * t669;
  const Scalar mu_24_20_z = -c_21 * t665 - s_21 * mu_24_21_y + Scalar(0.305) * f_u_24_21_t_x;
  const Scalar t671 = Scalar(0.24) * t670 - c_19 * t668 + s_19 * mu_24_20_z;
  const Scalar t672 = c_20 * mu_24_20_x - s_20 * mu_24_21_z;
  const Scalar t673 = t672 - Scalar(0.33) * t670;
  const Scalar mu_u_24_15_t_x = c_15 * t671 - s_15 * t673;
  const Scalar t674 = c_19 * t669 + s_19 * f_u_24_21_t_y;
  const Scalar t675 = c_20 * f_u_24_21_t_x - s_20 * f_u_24_22_a_z;
  const Scalar t676 = Scalar(0.24) * t674 - c_19 * mu_24_20_z - s_19 * t668 + Scalar(0.33) * t675;
  const Scalar t677 = t658 * t659 + c_14 * mu_u_24_15_t_x - s_14 * t676;
  const Scalar t678 = Scalar(0.00039620867718870463) * t369 - Ic_24_zz;
  const Scalar t679 = Scalar(1.0) / t678;
  const Scalar t680 = t664 - mu_u_25_24_t_y * t659;
  const Scalar t681 = t680 * t679;
  const Scalar t682 = c_19 * t637 + s_19 * t632;
  const Scalar t683 = c_20 * t635 + s_20 * t630;
  const Scalar t684 = Scalar(0.33) * t683 - Scalar(0.24) * t682 - c_19 * t636 -
      s_19 * mu_u_23_20_t_x;
  const Scalar t685 = Scalar(707.7641729774637) * mu_u_25_24_t_y;
  const Scalar t686 = -t658 * t685 - t677 * t681 + t640 + s_14 * t684;
  const Scalar b_25_24_22 = mu_24_22_z - t651 * t659;
  const Scalar t687 = t651 * t685 - b_25_24_22 * t681 + t403;
  const Scalar t688 = mu_u_25_24_t_y * t685 - t680 * t681 + mu_u_23_23_a_y;
  const Scalar t689 = Scalar(1.0) / t688;
  const Scalar t690 = t687 * t689;
  const Scalar t691 = c_19 * t621 + s_19 * t622;
  const Scalar t692 = c_20 * t620 + s_20 * f_u_22_22_a_z;
  const Scalar mu_22_15_z = s_19 * t618 - Scalar(0.24) * t691 + Scalar(0.33) * t692 + c_19 * t619;
  const Scalar t693 = b_25_24_22 * t679;
  const Scalar t694 = Scalar(707.7641729774637) * t651;
  const Scalar t695 = t658 * t694 + t677 * t693 + t686 * t690 + t627 + s_14 * mu_22_15_z;
  const Scalar b_25_24_21 = mu_24_21_z - t654 * t659;
  const Scalar t696 = b_25_24_21 * t681 - t654 * t685 + t634;
  const Scalar t697 = t414 - t654 * t694 + b_25_24_21 * t693 - t696 * t690;
  const Scalar t698 = t651 * t694 - t687 * t690 - b_25_24_22 * t693 + t394;
  const Scalar t699 = Scalar(1.0) / t698;
  const Scalar t700 = t697 * t699;
  const Scalar f_u_21_19_t_x = s_20 * t469 - s_19 * t417;
  const Scalar mu_21_15_z = Scalar(0.24) * f_u_21_19_t_x + Scalar(0.33) * c_20 * t427 -
      c_19 * t428 + s_19 * t611;
  const Scalar t701 = t696 * t689;
  const Scalar t702 = b_25_24_21 * t679;
  const Scalar t703 = Scalar(707.7641729774637) * t654;
  const Scalar t704 = t658 * t703 + t677 * t702 - t686 * t701 + t695 * t700 +
      c_14 * mu_u_21_15_t_x + s_14 * mu_21_15_z;
  const Scalar b_25_24_20 = mu_24_20_z - mu_u_25_20_a_y * t659;
  const Scalar t705 = b_25_24_20 * t681 - mu_u_25_20_a_y * t685 + t636;
  const Scalar t706 = -mu_u_25_20_a_y * t694 - t705 * t690 + b_25_24_20 * t693 + t619;
  const Scalar t707 = mu_u_25_20_a_y * t703 - b_25_24_20 * t702 - t705 * t701 - t706 * t700 + t428;
  const Scalar t708 = t697 * t700 - t654 * t703 + b_25_24_21 * t702 + t696 * t701 + t411;
  const Scalar t709 = Scalar(1.0) / t708;
  const Scalar t710 = t707 * t709;
  const Scalar mu_u_20_15_a_y = t430 + Scalar(0.33) * hu_20_t_x + c_19 * t607;
  const Scalar t711 = t706 * t699;
  const Scalar t712 = t705 * t689;
  const Scalar t713 = b_25_24_20 * t679;
  const Scalar t714 = Scalar(707.7641729774637) * mu_u_25_20_a_y;
  const Scalar t715 = t658 * t714 - t686 * t712 + t677 * t713 + t695 * t711 + t704 * t710 + t610 -
      s_14 * mu_u_20_15_a_y;
  const Scalar t716 = mu_u_25_20_t_y * t659 + t672;
  const Scalar b_24_23_19 = -t716 * t681 - mu_u_25_20_t_y * t685 + mu_u_23_20_t_y;
  const Scalar t717 = mu_u_25_20_t_y * t694 + b_24_23_19 * t690 + t716 * t693 + t625;
  const Scalar t718 = mu_u_25_20_t_y * t703 + t716 * t702 - b_24_23_19 * t701 + t717 * t700 + t614;
  const Scalar t719 = b_24_23_19 * t712 - mu_u_25_20_t_y * t714 - t716 * t713 + t455 - t717 * t711 -
      t718 * t710;
  const Scalar t720 = mu_u_25_20_a_y * t714 - b_25_24_20 * t713 - t705 * t712 + t707 * t710 -
      t706 * t711 + t423;
  const Scalar t721 = Scalar(1.0) / t720;
  const Scalar t722 = t719 * t721;
  const Scalar t723 = t718 * t709;
  const Scalar t724 = t717 * t699;
  const Scalar t725 = b_24_23_19 * t689;
  const Scalar t726 = t716 * t679;
  const Scalar t727 = Scalar(707.7641729774637) * mu_u_25_20_t_y;
  const Scalar t728 = t677 * t726 - t658 * t727 + t686 * t725 + t695 * t724 - t704 * t723 -
      t715 * t722 - s_14 * t474 + c_14 * mu_u_19_15_t_x;
  const Scalar t729 = t676 - t657 * t659;
  const Scalar t730 = t729 * t681 - t657 * t685 + t684;
  const Scalar b_23_22_15 = t657 * t694 + t730 * t690 - t729 * t693 + mu_22_15_z;
  const Scalar b_22_21_15 = t657 * t703 - t729 * t702 - t730 * t701 + b_23_22_15 * t700 +
      mu_21_15_z;
  const Scalar t731 = t730 * t712 - t657 * t714 + t729 * t713 - b_22_21_15 * t710 -
      b_23_22_15 * t711 + mu_u_20_15_a_y;
  const Scalar t732 = t657 * t727 - t730 * t725 + t729 * t726 - b_23_22_15 * t724 +
      b_22_21_15 * t723 + t474 - t731 * t722;
  const Scalar t733 = mu_u_25_20_t_y * t727 - t716 * t726 - b_24_23_19 * t725 - t717 * t724 -
      t719 * t722 + t718 * t723 + t445;
  const Scalar t734 = Scalar(1.0) / t733;
  const Scalar t735 = t732 * t734;
  const Scalar t736 = t601 * t590;
  const Scalar t737 = t731 * t721;
  const Scalar t738 = t600 * d_28;
  const Scalar t739 = b_22_21_15 * t709;
  const Scalar t740 = b_30_29_15 * t568;
  const Scalar t741 = b_23_22_15 * t699;
  const Scalar t742 = t599 * t559;
  const Scalar t743 = t730 * t689;
  const Scalar t744 = t598 * t550;
  const Scalar t745 = t729 * t679;
  const Scalar t746 = t529 * mu_u_32_14_t_y - t657 * t658;
  const Scalar mu_u_17_17_a_y = t438 - Scalar(0.03438);
  const Scalar t747 = mu_u_17_17_a_y - Scalar(0.453) * t449;
  const Scalar t748 = s_16 * t747 - s_17 * (t470 - t472);
  const Scalar t749 = c_17 * (Iu_18_a_yz - c_16 * t472);
  const Scalar t750 = t451 + c_16 * t747;
  const Scalar t751 = c_14 * (c_15 * t749 + s_15 * t748) - s_14 * t750;
  const Scalar t752 = Scalar(1.0) / mu_u_17_17_a_y;
  const Scalar t753 = Iu_18_a_yz * t752;
  const Scalar t754 = c_17 * t753;
  const Scalar t755 = Ic_16_zz - Scalar(0.003) * hu_16_a_z;
  const Scalar t756 = c_14 * (c_15 * t755 + s_15 * t461);
  const Scalar f_u_18_16_t_x = hu_18_a_z * t459 + s_16 * f_u_18_18_a_z;
  const Scalar t757 = Scalar(0.03408) * s_17 - Scalar(0.003) * f_u_18_16_t_x;
  const Scalar t758 = hu_18_a_z * t441 - c_16 * f_u_18_18_a_z;
  const Scalar t759 = Scalar(0.03408) * c_17;
  const Scalar t760 = Scalar(0.453) * t758 - (c_16 - Scalar(0.0880281690140845) * hu_18_a_z) * t759;
  const Scalar mu_u_18_15_a_y = s_16 * t759 + Scalar(0.453) * f_u_18_16_t_x;
  const Scalar mu_u_18_14_a_z = c_14 * (c_15 * t757 - s_15 * t760) + s_14 * mu_u_18_15_a_y;
  const Scalar t761 = t751 * t754 + t756 + s_14 * t471 - s_17 * mu_u_18_14_a_z;
  const Scalar t762 = Iu_18_a_yz * t753;
  const Scalar b_17_16_16 = t762 - t439 * (t762 + Scalar(0.03408)) + Ic_16_zz;
  const Scalar t763 = Scalar(1.0) / b_17_16_16;
  const Scalar t764 = t471 - t750 * t754 - s_17 * mu_u_18_15_a_y;
  const Scalar t765 = t764 * t763;
  const Scalar t766 = t750 * t752;
  const Scalar t767 = Scalar(29.342723004694836) * mu_u_18_15_a_y;
  const Scalar t768 = t751 * t766 - Scalar(707.7641729774637) * t746 - b_32_31_13 * t744 -
      t557 * t742 + t677 * t745 - t686 * t743 + mu_u_18_14_a_z * t767 + t761 * t765 - t575 * t738 +
      t704 * t739 + t564 * t740 - t597 * t605 - t695 * t741 + t728 * t735 + t477 - t584 * t736 +
      t715 * t737 - s_14 * t466;
  const Scalar Iu_15_a_xy = c_15 * t476 + s_15 * t473;
  const Scalar t769 = c_15 * t526 - s_15 * mu_32_15_x;
  const Scalar t770 = t769 * t530 - s_15 * t542 + c_15 * t544;
  const Scalar t771 = t769 * t556 + t770 * t552 + c_15 * t514 - s_15 * t512;
  const Scalar t772 = -t769 * t563 - t770 * t562 - t771 * t560 + c_15 * t500 + s_15 * t498;
  const Scalar t773 = t769 * t574 + t770 * t573 - t771 * t572 - t772 * t569 + c_15 * t488 -
      s_15 * t486;
  const Scalar t774 = t769 * t583 + t771 * t581 + t770 * t582 + c_15 * mu_27_15_y + t772 * t580 -
      t773 * t579 - s_15 * t483;
  const Scalar t775 = t769 * t596 - t770 * t595 - t771 * t594 - t772 * t593 + t773 * t592 -
      t774 * t591 + s_15 * t458 + c_15 * t480;
  const Scalar mu_u_25_15_t_y = c_15 * mu_25_15_y + s_15 * mu_25_15_x;
  const Scalar b_25_24_14 = mu_u_25_15_t_y * t659 + s_15 * t671 + c_15 * t673;
  const Scalar t776 = -mu_u_25_15_t_y * t685 - b_25_24_14 * t681 + c_15 * mu_23_15_y + s_15 * t639;
  const Scalar t777 = mu_u_25_15_t_y * t694 + b_25_24_14 * t693 + t776 * t690 + c_15 * t626 +
      s_15 * t624;
  const Scalar t778 = mu_u_25_15_t_y * t703 + b_25_24_14 * t702 - t776 * t701 + t777 * t700 +
      c_15 * t615 + s_15 * t613;
  const Scalar t779 = t776 * t712 - mu_u_25_15_t_y * t714 - b_25_24_14 * t713 + c_15 * t609 -
      t777 * t711 - t778 * t710 - s_15 * t608;
  const Scalar t780 = mu_u_25_15_t_y * t727 - b_25_24_14 * t726 - t776 * t725 - t777 * t724 +
      t778 * t723 - t779 * t722 - s_15 * t456 + c_15 * t606;
  const Scalar t781 = t529 * t769 + t657 * mu_u_25_15_t_y;
  const Scalar t782 = c_15 * t748 - s_15 * t749;
  const Scalar t783 = s_15 * t757 + c_15 * t760;
  const Scalar t784 = t782 * t754 + c_15 * t461 - s_15 * t755 + s_17 * t783;
  const Scalar t785 = Scalar(707.7641729774637) * t781 + t771 * t742 - t776 * t743 - t782 * t766 +
      t770 * t744 + b_25_24_14 * t745 + t783 * t767 - t784 * t765 + t773 * t738 + t778 * t739 +
      t772 * t740 - t775 * t605 - t777 * t741 - t780 * t735 + Iu_15_a_xy + t774 * t736 -
      t779 * t737;
  const Scalar t786 = t529 * t529 + t657 * t657;
  const Scalar b_16_15_15 = t750 * t766 - Scalar(707.7641729774637) * t786 + t598 * t744 +
      t599 * t742 + t729 * t745 + t730 * t743 - mu_u_18_15_a_y * t767 - t764 * t765 - t600 * t738 -
      b_22_21_15 * t739 + b_30_29_15 * t740 + t602 * t605 + b_23_22_15 * t741 + t732 * t735 +
      t601 * t736 + t731 * t737 + t466;
  const Scalar t787 = Scalar(1.0) / b_16_15_15;
  const Scalar t788 = t785 * t787;
  const Scalar t789 = t775 * t604;
  const Scalar t790 = t780 * t734;
  const Scalar t791 = t774 * t590;
  const Scalar t792 = t779 * t721;
  const Scalar t793 = t773 * d_28;
  const Scalar t794 = t778 * t709;
  const Scalar t795 = t772 * t568;
  const Scalar t796 = t777 * t699;
  const Scalar t797 = t771 * t559;
  const Scalar t798 = t776 * t689;
  const Scalar t799 = t770 * t550;
  const Scalar t800 = b_25_24_14 * t679;
  const Scalar t801 = t769 * mu_u_32_14_t_y - mu_u_25_15_t_y * t658;
  const Scalar t802 = t784 * t763;
  const Scalar t803 = t782 * t752;
  const Scalar t804 = Scalar(29.342723004694836) * t783;
  const Scalar t805 = Scalar(707.7641729774637) * t801 - t557 * t797 + t686 * t798 - t751 * t803 -
      b_32_31_13 * t799 + t677 * t800 - mu_u_18_14_a_z * t804 + t761 * t802 + t564 * t795 +
      t575 * t793 + t695 * t796 - t704 * t794 - t584 * t791 - t715 * t792 - s_14 * Iu_15_a_xy +
      t597 * t789 - t728 * t790 + t479 - t768 * t788;
  const Scalar t806 = t769 * t769 + mu_u_25_15_t_y * mu_u_25_15_t_y;
  const Scalar t807 = Scalar(707.7641729774637) * t806 - t782 * t803 - t771 * t797 - t776 * t798 -
      t770 * t799 - b_25_24_14 * t800 + t783 * t804 + t784 * t802 - t772 * t795 + t773 * t793 -
      t777 * t796 + t778 * t794 - t774 * t791 - t779 * t792 + t785 * t788 - t775 * t789 -
      t780 * t790 - t464 + t443 - Scalar(2.5075600666670006);
  const Scalar t808 = Scalar(1.0) / t807;
  const Scalar t809 = t805 * t808;
  const Scalar t810 = t768 * t787;
  const Scalar t811 = t597 * t604;
  const Scalar t812 = t728 * t734;
  const Scalar t813 = t584 * t590;
  const Scalar t814 = t715 * t721;
  const Scalar t815 = t575 * d_28;
  const Scalar t816 = t704 * t709;
  const Scalar t817 = t564 * t568;
  const Scalar t818 = t695 * t699;
  const Scalar t819 = t557 * t559;
  const Scalar t820 = t686 * t689;
  const Scalar t821 = b_32_31_13 * t550;
  const Scalar t822 = t677 * t679;
  const Scalar t823 = mu_u_32_14_t_y * mu_u_32_14_t_y + t658 * t658;
  const Scalar t824 = t761 * t763;
  const Scalar t825 = t751 * t752;
  const Scalar t826 = Scalar(29.342723004694836) * mu_u_18_14_a_z;
  const Scalar t827 = Scalar(707.7641729774637) * t823 - t557 * t819 - t686 * t820 - t751 * t825 -
      b_32_31_13 * t821 - t677 * t822 + mu_u_18_14_a_z * t826 + t761 * t824 + t575 * t815 +
      t704 * t816 - t564 * t817 - t695 * t818 - t584 * t813 - t597 * t811 - t715 * t814 -
      t728 * t812 - t805 * t809 + t465 + t478 + t768 * t810 - Scalar(2.5107600666670002);
  const Scalar t828 = c_14 * c_15;
  const Scalar t829 = qd_13 * t828 - s_15 * qd_14;
  const Scalar t830 = qd_13 * qd_14;
  const Scalar t831 = s_14 * t830;
  const Scalar t832 = s_15 * t831 - qd_15 * t829;
  const Scalar t833 = s_14 * qd_13;
  const Scalar omega_15_z = qd_15 - t833;
  const Scalar t834 = t829 * omega_15_z;
  const Scalar U_15_zx = t832 - t834;
  const Scalar t835 = Scalar(9.81) * s_14;
  const Scalar t836 = Scalar(0.33) * U_15_zx + t835;
  const Scalar t837 = c_14 * s_15;
  const Scalar omega_r_15_y = qd_13 * t837 + c_15 * qd_14;
  const Scalar domega_15_x = c_15 * t831 + qd_15 * omega_r_15_y;
  const Scalar t838 = omega_r_15_y * omega_15_z;
  const Scalar U_15_zy = domega_15_x + t838;
  const Scalar t839 = Scalar(0.24) * U_15_zy;
  const Scalar t840 = t836 - t839;
  const Scalar t841 = omega_r_15_y * omega_r_15_y;
  const Scalar t842 = omega_15_z * omega_15_z;
  const Scalar t843 = t841 + t842;
  const Scalar t844 = Scalar(9.81) * t828;
  const Scalar t845 = Scalar(0.33) * t843 - t844;
  const Scalar t846 = t829 * omega_r_15_y;
  const Scalar t847 = c_14 * t830;
  const Scalar U_15_xy = t847 - t846;
  const Scalar t848 = Scalar(0.24) * U_15_xy;
  const Scalar t849 = t848 + t845;
  const Scalar t850 = c_26 * t849 + s_26 * t840;
  const Scalar t851 = t847 + t846;
  const Scalar t852 = Scalar(9.81) * t837;
  const Scalar t853 = Scalar(0.33) * t851 + t852;
  const Scalar t854 = t829 * t829;
  const Scalar t855 = Scalar(0.24) * (t854 + t842);
  const Scalar t856 = t853 - t855;
  const Scalar t857 = c_27 * t856 - s_27 * t850;
  const Scalar t858 = c_26 * t829 + s_26 * omega_15_z;
  const Scalar omega_26_z = qd_26 + omega_r_15_y;
  const Scalar omega_r_27_x = c_27 * omega_26_z + s_27 * t858;
  const Scalar t859 = c_27 * t858 - s_27 * omega_26_z;
  const Scalar t860 = omega_r_27_x * t859;
  const Scalar domega_26_y = c_26 * t847 - s_26 * domega_15_x + qd_26 * t858;
  const Scalar U_27_xy = domega_26_y + t860;
  const Scalar t861 = t857 - Scalar(0.305) * U_27_xy;
  const Scalar t862 = c_26 * t840 - s_26 * t849;
  const Scalar omega_r_27_a_z = c_26 * omega_15_z - s_26 * t829;
  const Scalar t863 = c_26 * domega_15_x + s_26 * t847 - qd_26 * omega_r_27_a_z;
  const Scalar t864 = c_27 * t832 + s_27 * t863 - qd_27 * t859;
  const Scalar omega_27_z = qd_27 + omega_r_27_a_z;
  const Scalar t865 = t859 * omega_27_z;
  const Scalar t866 = t864 - t865;
  const Scalar t867 = t862 - Scalar(0.305) * t866;
  const Scalar t868 = c_28 * omega_r_27_x - s_28 * omega_27_z;
  const Scalar omega_28_z = qd_28 + t859;
  const Scalar t869 = omega_28_z * omega_28_z;
  const Scalar t870 = t868 * t868 + t869;
  const Scalar t871 = Scalar(0.004) * t870 + c_28 * t867 - s_28 * t861;
  const Scalar t872 = omega_r_27_x * omega_r_27_x + omega_27_z * omega_27_z;
  const Scalar ddp_o_28_y = Scalar(0.305) * t872 - c_27 * t850 - s_27 * t856;
  const Scalar omega_r_28_x = c_28 * omega_27_z + s_28 * omega_r_27_x;
  const Scalar t873 = c_28 * t864 - s_28 * domega_26_y + qd_28 * omega_r_28_x;
  const Scalar t874 = omega_r_28_x * omega_28_z;
  const Scalar U_28_zx = t873 + t874;
  const Scalar ddp_o_29_z = Scalar(0.004) * U_28_zx + ddp_o_28_y;
  const Scalar t875 = c_29 * t871 + s_29 * ddp_o_29_z;
  const Scalar omega_r_30_a_z = c_29 * omega_28_z + s_29 * omega_r_28_x;
  const Scalar omega_29_z = qd_29 + t868;
  const Scalar t876 = omega_29_z * omega_29_z;
  const Scalar t877 = omega_r_30_a_z * omega_r_30_a_z + t876;
  const Scalar t878 = c_29 * omega_r_28_x - s_29 * omega_28_z;
  const Scalar t879 = t878 * omega_r_30_a_z;
  const Scalar U_29_xy = t873 - t879;
  const Scalar t880 = Scalar(-0.004) * t877 - Scalar(0.239) * U_29_xy + t875;
  const Scalar t881 = c_28 * t861 + s_28 * t867;
  const Scalar t882 = omega_r_28_x * t868;
  const Scalar domega_r_29_a_y = c_27 * t863 - s_27 * t832 + qd_27 * omega_r_27_x;
  const Scalar t883 = domega_r_29_a_y - t882;
  const Scalar t884 = t881 - Scalar(0.004) * t883;
  const Scalar t885 = c_28 * domega_26_y + s_28 * t864 - qd_28 * t868;
  const Scalar domega_29_y = c_29 * domega_r_29_a_y + s_29 * t885 - qd_29 * t878;
  const Scalar t886 = t878 * omega_29_z;
  const Scalar t887 = domega_29_y - t886;
  const Scalar t888 = c_29 * t885 - s_29 * domega_r_29_a_y + qd_29 * omega_r_30_a_z;
  const Scalar t889 = omega_r_30_a_z * omega_29_z;
  const Scalar t890 = t888 + t889;
  const Scalar t891 = Scalar(0.004) * t887 - Scalar(0.239) * t890 + t884;
  const Scalar t892 = s_30 * t880 + c_30 * t891;
  const Scalar t893 = c_29 * ddp_o_29_z - s_29 * t871;
  const Scalar t894 = t873 + t879;
  const Scalar t895 = t876 + t878 * t878;
  const Scalar t896 = Scalar(0.239) * t895 - Scalar(0.004) * t894 + t893;
  const Scalar t897 = c_31 * t892 + s_31 * t896;
  const Scalar t898 = c_30 * t880 - s_30 * t891;
  const Scalar t899 = c_32 * t898 - s_32 * t897;
  const Scalar omega_r_31_a_z = c_30 * t878 + s_30 * omega_29_z;
  const Scalar t900 = c_30 * t873 - s_30 * t888 + qd_30 * omega_r_31_a_z;
  const Scalar omega_r_30_x = c_30 * omega_29_z - s_30 * t878;
  const Scalar omega_30_z = qd_30 + omega_r_30_a_z;
  const Scalar t901 = c_31 * omega_30_z - s_31 * omega_r_30_x;
  const Scalar t902 = s_31 * domega_29_y - qd_31 * t901 + c_31 * t900;
  const Scalar omega_r_31_x = c_31 * omega_r_30_x + s_31 * omega_30_z;
  const Scalar omega_31_z = qd_31 + omega_r_31_a_z;
  const Scalar omega_r_32_x = c_32 * omega_31_z + s_32 * omega_r_31_x;
  const Scalar t903 = c_30 * t888 + s_30 * t873 - qd_30 * omega_r_30_x;
  const Scalar t904 = qd_32 * omega_r_32_x + c_32 * t902 - s_32 * t903;
  const Scalar omega_32_z = qd_32 + t901;
  const Scalar t905 = omega_r_32_x * omega_32_z;
  const Scalar t906 = c_32 * omega_r_31_x - s_32 * omega_31_z;
  const Scalar t907 = omega_r_32_x * t906;
  const Scalar t908 = c_31 * domega_29_y + qd_31 * omega_r_31_x - s_31 * t900;
  const Scalar t909 = Scalar(-0.0005096) * t907 - Scalar(0.0007482) * (t904 - t905) +
      Scalar(0.0014129000000002) * t908 + Scalar(0.0094) * t899;
  const Scalar y_32 = t909 + tau_32;
  const Scalar t910 = c_31 * t896 - s_31 * t892;
  const Scalar t911 = omega_32_z * omega_32_z;
  const Scalar t912 = Scalar(-0.0007482) * (t911 - t906 * t906) -
      Scalar(0.0009033000000002) * t906 * omega_32_z + Scalar(0.0094) * t910;
  const Scalar U_32_xy = t908 + t907;
  const Scalar t913 = Scalar(0.0005096) * t904 - Scalar(0.0007482) * U_32_xy +
      Scalar(0.0014129000000002) * t905;
  const Scalar t914 = omega_r_31_x * t901;
  const Scalar t915 = Scalar(-0.0253235000000002) * t903;
  const Scalar t916 = s_32 * t913 - c_32 * t912 - Scalar(0.0250035000000002) * t914 + t915 +
      Scalar(0.1902) * t897;
  const Scalar y_32_31 = -t916 - t530 * y_32 + tau_31;
  const Scalar mu_31_y = Scalar(0.0250035000000002) * t908 - t909 -
      Scalar(0.0253235000000002) * omega_r_31_x * omega_31_z;
  const Scalar t917 = t901 * omega_31_z;
  const Scalar t918 = -c_32 * t913 - s_32 * t912 + Scalar(0.0503270000000004) * t917 +
      Scalar(0.1902) * t898;
  const Scalar mu_u_30_a_y = Scalar(0.0259635000000002) * domega_29_y -
      Scalar(0.0253235000000002) * omega_r_30_x * omega_r_31_a_z - c_31 * mu_31_y - s_31 * t918;
  const Scalar y_31_30 = t552 * y_32_31 + mu_u_30_a_y - t556 * y_32 + tau_30;
  const Scalar t919 = s_31 * mu_31_y + Scalar(0.0512870000000004) * omega_r_31_a_z * omega_30_z -
      c_31 * t918;
  const Scalar t920 = t915 - Scalar(0.0259635000000002) * omega_r_30_x * omega_30_z - t916;
  const Scalar t921 = omega_r_32_x * omega_r_32_x + t911;
  const Scalar t922 = Scalar(0.1902) * (t903 + t914) -
      Scalar(0.0094) * (c_32 * t921 - s_32 * U_32_xy);
  const Scalar t923 = c_32 * t903 + s_32 * t902 - t906 * (qd_32 + omega_32_z);
  const Scalar f_31_y = Scalar(0.0094) * t923 +
      Scalar(0.1902) * (omega_r_31_x * omega_r_31_x + omega_31_z * omega_31_z);
  const Scalar t924 = c_31 * t922 + s_31 * f_31_y;
  const Scalar f_31_z = Scalar(0.1902) * (t902 - t917) -
      Scalar(0.0094) * (c_32 * U_32_xy + s_32 * t921);
  const Scalar f_u_30_t_x = c_30 * f_31_z + s_30 * t924;
  const Scalar f_u_31_t_y = c_31 * f_31_y - s_31 * t922;
  const Scalar t925 = Scalar(0.0050592) * (t877 - t895) - Scalar(0.004) * f_u_31_t_y -
      Scalar(0.0328) * t893 + Scalar(0.239) * f_u_30_t_x + c_30 * t919 + s_30 * t920 +
      Scalar(0.2298769000000002) * t873 - Scalar(0.2262745000000002) * t879 - Scalar(0.8648) * t875;
  const Scalar y_30_29 = tau_29 + t925 - t563 * y_32 + t562 * y_32_31 + t560 * y_31_30;
  const Scalar t926 = c_30 * t924 - s_30 * f_31_z;
  const Scalar t927 = Scalar(0.0050592) * t887 - Scalar(0.239) * t926 - c_30 * t920 + s_30 * t919 +
      Scalar(0.8648) * t884 - Scalar(0.4561514000000004) * t889;
  const Scalar t928 = Scalar(-0.004) * t926 - Scalar(0.0050592) * t890 + Scalar(0.0328) * t884 +
      mu_u_30_a_y - Scalar(0.2262745000000002) * domega_29_y - Scalar(0.2298769000000002) * t886;
  const Scalar f_29_z = Scalar(0.0328) * t887 - t926 - Scalar(0.8648) * t890;
  const Scalar t929 = t868 * omega_28_z;
  const Scalar U_28_yz = t885 + t929;
  const Scalar t930 = Scalar(0.0032) * t881 + Scalar(0.0023) * U_28_yz - Scalar(0.004) * f_29_z +
      Scalar(0.2360429000000002) * domega_r_29_a_y + Scalar(0.2282085000000002) * t882 +
      c_29 * t928 + s_29 * t927;
  const Scalar y_29_28 = t569 * y_30_29 + tau_28 + t930 - t574 * y_32 + t573 * y_32_31 -
      t572 * y_31_30;
  const Scalar t931 = Scalar(0.0023) * t883 + s_29 * t928 - Scalar(0.4642514000000004) * t929 -
      c_29 * t927;
  const Scalar f_29_x = Scalar(0.0328) * t877 + f_u_30_t_x + Scalar(0.8648) * U_29_xy;
  const Scalar f_29_y = Scalar(0.0328) * t894 - f_u_31_t_y - Scalar(0.8648) * t895;
  const Scalar f_u_29_t_y = c_29 * f_29_y + s_29 * f_29_x;
  const Scalar mu_28_y = Scalar(0.0032) * ddp_o_28_y +
      Scalar(0.0023) * (t869 - omega_r_28_x * omega_r_28_x) + Scalar(0.004) * f_u_29_t_y +
      Scalar(0.2282085000000002) * t873 - Scalar(0.2360429000000002) * t874 - t925;
  const Scalar f_28_x = Scalar(0.0032) * t870 + c_29 * f_29_x - s_29 * f_29_y;
  const Scalar f_28_y = Scalar(0.0032) * t883 + f_29_z;
  const Scalar f_u_28_t_x = c_28 * f_28_y + s_28 * f_28_x;
  const Scalar t932 = Scalar(0.7079407000000002) * domega_26_y;
  const Scalar t933 = Scalar(0.305) * f_u_28_t_x + Scalar(1.661) * t857 -
      Scalar(0.7059807000000002) * t860 - c_28 * t931 - s_28 * mu_28_y - t932;
  const Scalar y_28_27 = tau_27 - t583 * y_32 + t581 * y_31_30 - t579 * y_29_28 - t933 +
      t582 * y_32_31 - t580 * y_30_29;
  const Scalar t934 = c_28 * f_28_x - s_28 * f_28_y;
  const Scalar t935 = Scalar(1.661) * t862 - Scalar(0.305) * t934 + c_28 * mu_28_y - s_28 * t931 +
      Scalar(1.4139214000000004) * t865;
  const Scalar mu_27_y = Scalar(0.7059807000000002) * domega_r_29_a_y - t930 -
      Scalar(0.7079407000000002) * omega_r_27_x * omega_27_z;
  const Scalar t936 = Scalar(0.7099007000000002) * t832;
  const Scalar t937 = Scalar(0.7079407000000002) * t858 * omega_r_27_a_z + t936 + s_27 * mu_27_y -
      c_27 * t935;
  const Scalar y_27_26 = tau_26 + t596 * y_32 + t595 * y_32_31 + t594 * y_31_30 - t593 * y_30_29 +
      t591 * y_28_27 + t937 - t592 * y_29_28;
  const Scalar ddp_19_a_y = t839 + t836;
  const Scalar t938 = t845 - t848;
  const Scalar t939 = c_19 * t938 + s_19 * ddp_19_a_y;
  const Scalar t940 = t855 + t853;
  const Scalar t941 = c_20 * t940 - s_20 * t939;
  const Scalar t942 = c_19 * t829 + s_19 * omega_15_z;
  const Scalar omega_19_z = qd_19 + omega_r_15_y;
  const Scalar omega_r_20_x = c_20 * omega_19_z + s_20 * t942;
  const Scalar t943 = c_20 * t942 - s_20 * omega_19_z;
  const Scalar t944 = omega_r_20_x * t943;
  const Scalar domega_19_y = c_19 * t847 - s_19 * domega_15_x + qd_19 * t942;
  const Scalar U_20_xy = domega_19_y + t944;
  const Scalar t945 = t941 - Scalar(0.305) * U_20_xy;
  const Scalar t946 = c_19 * ddp_19_a_y - s_19 * t938;
  const Scalar omega_r_20_a_z = c_19 * omega_15_z - s_19 * t829;
  const Scalar t947 = c_19 * domega_15_x + s_19 * t847 - qd_19 * omega_r_20_a_z;
  const Scalar t948 = c_20 * t832 + s_20 * t947 - qd_20 * t943;
  const Scalar omega_20_z = qd_20 + omega_r_20_a_z;
  const Scalar t949 = t943 * omega_20_z;
  const Scalar t950 = t948 - t949;
  const Scalar t951 = t946 - Scalar(0.305) * t950;
  const Scalar t952 = c_21 * omega_r_20_x - s_21 * omega_20_z;
  const Scalar omega_21_z = qd_21 + t943;
  const Scalar t953 = omega_21_z * omega_21_z;
  const Scalar t954 = t952 * t952 + t953;
  const Scalar t955 = Scalar(0.004) * t954 + c_21 * t951 - s_21 * t945;
  const Scalar t956 = omega_r_20_x * omega_r_20_x + omega_20_z * omega_20_z;
  const Scalar ddp_o_21_y = Scalar(0.305) * t956 - c_20 * t939 - s_20 * t940;
  const Scalar omega_r_21_x = c_21 * omega_20_z + s_21 * omega_r_20_x;
  const Scalar t957 = c_21 * t948 - s_21 * domega_19_y + qd_21 * omega_r_21_x;
  const Scalar t958 = omega_r_21_x * omega_21_z;
  const Scalar U_21_zx = t957 + t958;
  const Scalar ddp_o_22_z = Scalar(0.004) * U_21_zx + ddp_o_21_y;
  const Scalar t959 = c_22 * t955 + s_22 * ddp_o_22_z;
  const Scalar omega_r_23_a_z = c_22 * omega_21_z + s_22 * omega_r_21_x;
  const Scalar omega_22_z = qd_22 + t952;
  const Scalar t960 = omega_22_z * omega_22_z;
  const Scalar t961 = omega_r_23_a_z * omega_r_23_a_z + t960;
  const Scalar t962 = c_22 * omega_r_21_x - s_22 * omega_21_z;
  const Scalar t963 = t962 * omega_r_23_a_z;
  const Scalar U_22_xy = t957 - t963;
  const Scalar t964 = Scalar(-0.004) * t961 - Scalar(0.239) * U_22_xy + t959;
  const Scalar t965 = c_21 * t945 + s_21 * t951;
  const Scalar t966 = omega_r_21_x * t952;
  const Scalar domega_r_22_a_y = c_20 * t947 - s_20 * t832 + qd_20 * omega_r_20_x;
  const Scalar t967 = domega_r_22_a_y - t966;
  const Scalar t968 = t965 - Scalar(0.004) * t967;
  const Scalar t969 = c_21 * domega_19_y + s_21 * t948 - qd_21 * t952;
  const Scalar domega_22_y = c_22 * domega_r_22_a_y + s_22 * t969 - qd_22 * t962;
  const Scalar t970 = t962 * omega_22_z;
  const Scalar t971 = domega_22_y - t970;
  const Scalar t972 = c_22 * t969 - s_22 * domega_r_22_a_y + qd_22 * omega_r_23_a_z;
  const Scalar t973 = omega_r_23_a_z * omega_22_z;
  const Scalar t974 = t972 + t973;
  const Scalar t975 = Scalar(0.004) * t971 - Scalar(0.239) * t974 + t968;
  const Scalar ddp_23_x = s_23 * t964 + c_23 * t975;
  const Scalar t976 = c_22 * ddp_o_22_z - s_22 * t955;
  const Scalar t977 = t957 + t963;
  const Scalar t978 = t960 + t962 * t962;
  const Scalar t979 = Scalar(0.239) * t978 - Scalar(0.004) * t977 + t976;
  const Scalar t980 = c_24 * ddp_23_x + s_24 * t979;
  const Scalar t981 = c_23 * t964 - s_23 * t975;
  const Scalar t982 = c_25 * t981 - s_25 * t980;
  const Scalar omega_r_24_a_z = c_23 * t962 + s_23 * omega_22_z;
  const Scalar t983 = c_23 * t957 - s_23 * t972 + qd_23 * omega_r_24_a_z;
  const Scalar omega_r_23_x = c_23 * omega_22_z - s_23 * t962;
  const Scalar omega_23_z = qd_23 + omega_r_23_a_z;
  const Scalar t984 = c_24 * omega_23_z - s_24 * omega_r_23_x;
  const Scalar t985 = s_24 * domega_22_y - qd_24 * t984 + c_24 * t983;
  const Scalar omega_r_24_x = c_24 * omega_r_23_x + s_24 * omega_23_z;
  const Scalar omega_24_z = qd_24 + omega_r_24_a_z;
  const Scalar omega_r_25_x = c_25 * omega_24_z + s_25 * omega_r_24_x;
  const Scalar t986 = c_23 * t972 + s_23 * t957 - qd_23 * omega_r_23_x;
  const Scalar t987 = qd_25 * omega_r_25_x + c_25 * t985 - s_25 * t986;
  const Scalar omega_25_z = qd_25 + t984;
  const Scalar t988 = omega_r_25_x * omega_25_z;
  const Scalar t989 = c_25 * omega_r_24_x - s_25 * omega_24_z;
  const Scalar t990 = omega_r_25_x * t989;
  const Scalar t991 = c_24 * domega_22_y + qd_24 * omega_r_24_x - s_24 * t983;
  const Scalar t992 = Scalar(0.0007482) * (t987 - t988) - Scalar(0.0005096) * t990 +
      Scalar(0.0014129000000002) * t991 - Scalar(0.0094) * t982;
  const Scalar y_25 = t992 + tau_25;
  const Scalar t993 = c_24 * t979 - s_24 * ddp_23_x;
  const Scalar t994 = omega_25_z * omega_25_z;
  const Scalar t995 = Scalar(0.0009033000000002) * t989 * omega_25_z -
      Scalar(0.0007482) * (t994 - t989 * t989) + Scalar(0.0094) * t993;
  const Scalar U_25_xy = t991 + t990;
  const Scalar t996 = Scalar(0.0005096) * t987 + Scalar(0.0007482) * U_25_xy +
      Scalar(0.0014129000000002) * t988;
  const Scalar t997 = omega_r_24_x * t984;
  const Scalar t998 = Scalar(-0.0253235000000002) * t986;
  const Scalar t999 = s_25 * t996 + c_25 * t995 - Scalar(0.0250035000000002) * t997 + t998 +
      Scalar(0.1902) * t980;
  const Scalar y_25_24 = t659 * y_25 - t999 + tau_24;
  const Scalar mu_24_y = Scalar(0.0250035000000002) * t991 - t992 -
      Scalar(0.0253235000000002) * omega_r_24_x * omega_24_z;
  const Scalar t1000 = t984 * omega_24_z;
  const Scalar t1001 = s_25 * t995 - c_25 * t996 + Scalar(0.0503270000000004) * t1000 +
      Scalar(0.1902) * t981;
  const Scalar mu_u_23_a_y = Scalar(0.0259635000000002) * domega_22_y -
      Scalar(0.0253235000000002) * omega_r_23_x * omega_r_24_a_z - c_24 * mu_24_y - s_24 * t1001;
  const Scalar y_24_23 = mu_u_23_a_y - t681 * y_25_24 - t685 * y_25 + tau_23;
  const Scalar t1002 = s_24 * mu_24_y + Scalar(0.0512870000000004) * omega_r_24_a_z * omega_23_z -
      c_24 * t1001;
  const Scalar t1003 = t998 - Scalar(0.0259635000000002) * omega_r_23_x * omega_23_z - t999;
  const Scalar t1004 = omega_r_25_x * omega_r_25_x + t994;
  const Scalar t1005 = Scalar(0.0094) * (c_25 * t1004 - s_25 * U_25_xy) +
      Scalar(0.1902) * (t986 + t997);
  const Scalar t1006 = c_25 * t986 + s_25 * t985 - t989 * (qd_25 + omega_25_z);
  const Scalar f_24_y = Scalar(0.1902) * (omega_r_24_x * omega_r_24_x + omega_24_z * omega_24_z) -
      Scalar(0.0094) * t1006;
  const Scalar t1007 = c_24 * t1005 + s_24 * f_24_y;
  const Scalar f_24_z = Scalar(0.0094) * (c_25 * U_25_xy + s_25 * t1004) +
      Scalar(0.1902) * (t985 - t1000);
  const Scalar f_u_23_t_x = c_23 * f_24_z + s_23 * t1007;
  const Scalar f_u_24_t_y = c_24 * f_24_y - s_24 * t1005;
  const Scalar t1008 = Scalar(0.0050592) * (t961 - t978) - Scalar(0.004) * f_u_24_t_y -
      Scalar(0.0328) * t976 + Scalar(0.239) * f_u_23_t_x + c_23 * t1002 + s_23 * t1003 +
      Scalar(0.2298769000000002) * t957 - Scalar(0.2262745000000002) * t963 - Scalar(0.8648) * t959;
  const Scalar y_23_22 = tau_22 + t1008 + t694 * y_25 + t693 * y_25_24 + t690 * y_24_23;
  const Scalar t1009 = c_23 * t1007 - s_23 * f_24_z;
  const Scalar t1010 = Scalar(0.0050592) * t971 - Scalar(0.239) * t1009 - c_23 * t1003 +
      s_23 * t1002 + Scalar(0.8648) * t968 - Scalar(0.4561514000000004) * t973;
  const Scalar t1011 = Scalar(-0.004) * t1009 - Scalar(0.0050592) * t974 + Scalar(0.0328) * t968 +
      mu_u_23_a_y - Scalar(0.2262745000000002) * domega_22_y - Scalar(0.2298769000000002) * t970;
  const Scalar f_22_z = Scalar(0.0328) * t971 - t1009 - Scalar(0.8648) * t974;
  const Scalar t1012 = t952 * omega_21_z;
  const Scalar U_21_yz = t969 + t1012;
  const Scalar t1013 = Scalar(0.0032) * t965 + Scalar(0.0023) * U_21_yz - Scalar(0.004) * f_22_z +
      Scalar(0.2360429000000002) * domega_r_22_a_y + Scalar(0.2282085000000002) * t966 +
      c_22 * t1011 + s_22 * t1010;
  const Scalar y_22_21 = t700 * y_23_22 + tau_21 + t1013 + t703 * y_25 + t702 * y_25_24 -
      t701 * y_24_23;
  const Scalar t1014 = Scalar(0.0023) * t967 + s_22 * t1011 - Scalar(0.4642514000000004) * t1012 -
      c_22 * t1010;
  const Scalar f_22_x = Scalar(0.0328) * t961 + f_u_23_t_x + Scalar(0.8648) * U_22_xy;
  const Scalar f_22_y = Scalar(0.0328) * t977 - f_u_24_t_y - Scalar(0.8648) * t978;
  const Scalar f_u_22_t_y = c_22 * f_22_y + s_22 * f_22_x;
  const Scalar mu_21_y = Scalar(0.0032) * ddp_o_21_y +
      Scalar(0.0023) * (t953 - omega_r_21_x * omega_r_21_x) + Scalar(0.004) * f_u_22_t_y +
      Scalar(0.2282085000000002) * t957 - Scalar(0.2360429000000002) * t958 - t1008;
  const Scalar f_21_x = Scalar(0.0032) * t954 + c_22 * f_22_x - s_22 * f_22_y;
  const Scalar f_21_y = Scalar(0.0032) * t967 + f_22_z;
  const Scalar f_u_21_t_x = c_21 * f_21_y + s_21 * f_21_x;
  const Scalar t1015 = Scalar(0.7079407000000002) * domega_19_y;
  const Scalar t1016 = Scalar(0.305) * f_u_21_t_x + Scalar(1.661) * t941 -
      Scalar(0.7059807000000002) * t944 - c_21 * t1014 - s_21 * mu_21_y - t1015;
  const Scalar y_21_20 = tau_20 + t714 * y_25 - t712 * y_24_23 + t710 * y_22_21 - t1016 +
      t713 * y_25_24 + t711 * y_23_22;
  const Scalar t1017 = c_21 * f_21_x - s_21 * f_21_y;
  const Scalar t1018 = Scalar(1.661) * t946 - Scalar(0.305) * t1017 + c_21 * mu_21_y -
      s_21 * t1014 + Scalar(1.4139214000000004) * t949;
  const Scalar mu_20_y = Scalar(0.7059807000000002) * domega_r_22_a_y - t1013 -
      Scalar(0.7079407000000002) * omega_r_20_x * omega_20_z;
  const Scalar t1019 = t936 + Scalar(0.7079407000000002) * t942 * omega_r_20_a_z + s_20 * mu_20_y -
      c_20 * t1018;
  const Scalar y_20_19 = tau_19 - t727 * y_25 + t726 * y_25_24 + t725 * y_24_23 + t724 * y_23_22 -
      t722 * y_21_20 + t1019 - t723 * y_22_21;
  const Scalar t1020 = c_27 * mu_27_y + Scalar(1.4178414000000004) * omega_r_27_a_z * omega_26_z +
      s_27 * t935;
  const Scalar t1021 = c_20 * mu_20_y + Scalar(1.4178414000000004) * omega_r_20_a_z * omega_19_z +
      s_20 * t1018;
  const Scalar t1022 = Scalar(1.661) * U_27_xy - f_u_28_t_x;
  const Scalar f_27_y = Scalar(-0.0032) * U_28_zx - f_u_29_t_y + Scalar(1.661) * t872;
  const Scalar t1023 = c_27 * f_27_y - s_27 * t1022;
  const Scalar t1024 = Scalar(1.661) * U_20_xy - f_u_21_t_x;
  const Scalar f_20_y = Scalar(-0.0032) * U_21_zx - f_u_22_t_y + Scalar(1.661) * t956;
  const Scalar t1025 = c_20 * f_20_y - s_20 * t1024;
  const Scalar f_27_z = t934 + Scalar(1.661) * t866;
  const Scalar f_20_z = t1017 + Scalar(1.661) * t950;
  const Scalar t1026 = c_26 * t1023 - s_26 * f_27_z - c_19 * t1025 + s_19 * f_20_z;
  const Scalar t1027 = t932 - Scalar(0.7099007000000002) * t858 * omega_26_z + t933;
  const Scalar t1028 = t1015 - Scalar(0.7099007000000002) * t942 * omega_19_z + t1016;
  const Scalar t1029 = c_27 * t1022 + s_27 * f_27_y + c_20 * t1024 + s_20 * f_20_y;
  const Scalar t1030 = c_16 * omega_r_15_y - s_16 * omega_15_z;
  const Scalar omega_16_z = qd_16 + t829;
  const Scalar t1031 = c_17 * omega_16_z - s_17 * t1030;
  const Scalar omega_r_17_a_z = s_16 * omega_r_15_y + c_16 * omega_15_z;
  const Scalar omega_17_z = qd_17 + omega_r_17_a_z;
  const Scalar t1032 = c_18 * omega_17_z - s_18 * t1031;
  const Scalar t1033 = c_18 * t1031 + s_18 * omega_17_z;
  const Scalar t1034 = t1032 * t1033;
  const Scalar t1035 = c_16 * t832 - s_16 * t847 + qd_16 * omega_r_17_a_z;
  const Scalar t1036 = s_17 * domega_15_x + c_17 * t1035 - qd_17 * t1031;
  const Scalar omega_r_17_y = c_17 * t1030 + s_17 * omega_16_z;
  const Scalar omega_18_z = qd_18 + omega_r_17_y;
  const Scalar t1037 = omega_18_z * omega_18_z;
  const Scalar t1038 = t1032 * t1032 + t1037;
  const Scalar t1039 = Scalar(0.02) * (t1036 + t1034) - Scalar(0.22) * t1038;
  const Scalar t1040 = t1033 * t1033 + t1037;
  const Scalar t1041 = Scalar(0.02) * t1040 + Scalar(0.22) * (t1036 - t1034);
  const Scalar t1042 = s_18 * t1041 + c_18 * t1039;
  const Scalar domega_17_x = c_17 * domega_15_x - s_17 * t1035 + qd_17 * omega_r_17_y;
  const Scalar domega_16_y = c_16 * t847 + s_16 * t832 - qd_16 * t1030;
  const Scalar domega_18_y = c_18 * domega_17_x + s_18 * domega_16_y - qd_18 * t1032;
  const Scalar t1043 = t1032 * omega_18_z;
  const Scalar t1044 = domega_18_y - t1043;
  const Scalar t1045 = c_18 * domega_16_y - s_18 * domega_17_x + t1033 * (qd_18 + omega_18_z);
  const Scalar t1046 = Scalar(0.02) * t1044 - Scalar(0.22) * t1045;
  const Scalar t1047 = c_17 * t1046 + s_17 * t1042;
  const Scalar f_u_18_t_y = c_18 * t1041 - s_18 * t1039;
  const Scalar t1048 = c_16 * t1047 + s_16 * f_u_18_t_y;
  const Scalar t1049 = domega_15_x - t838;
  const Scalar t1050 = Scalar(0.003) * t1049 + Scalar(0.453) * t851 + t852;
  const Scalar t1051 = t841 + t854;
  const Scalar ddp_16_a_y = Scalar(0.453) * U_15_zx - Scalar(0.003) * t1051 + t835;
  const Scalar ddp_16_x = c_16 * t1050 + s_16 * ddp_16_a_y;
  const Scalar t1052 = Scalar(0.003) * (t832 + t834) + Scalar(0.453) * t843 - t844;
  const Scalar t1053 = c_17 * t1052 + s_17 * ddp_16_x;
  const Scalar ddp_16_y = c_16 * ddp_16_a_y - s_16 * t1050;
  const Scalar t1054 = c_18 * ddp_16_y - s_18 * t1053;
  const Scalar t1055 = c_18 * t1053 + s_18 * ddp_16_y;
  const Scalar t1056 = Scalar(0.0022) * (t1040 - t1038) - Scalar(0.02) * t1055 -
      Scalar(0.024) * t1034 + Scalar(0.03408) * t1036 + Scalar(0.22) * t1054;
  const Scalar t1057 = Scalar(0.03388) * t1036 + Scalar(0.03438) * t1031 * omega_17_z - t1056;
  const Scalar t1058 = c_17 * ddp_16_x - s_17 * t1052;
  const Scalar t1059 = Scalar(0.22) * t1058 - Scalar(0.0022) * t1044 +
      Scalar(0.05808) * t1033 * omega_18_z;
  const Scalar t1060 = Scalar(0.0022) * t1045 + Scalar(0.02) * t1058 + Scalar(0.024) * domega_18_y +
      Scalar(0.03408) * t1043;
  const Scalar mu_17_x = Scalar(0.06826) * omega_r_17_y * omega_17_z - c_18 * t1060 - s_18 * t1059;
  const Scalar t1061 = Scalar(0.069385) * omega_r_17_a_z * omega_16_z - c_17 * t1057 -
      s_17 * mu_17_x;
  const Scalar t1062 = Scalar(0.03438) * domega_16_y;
  const Scalar t1063 = Scalar(0.03388) * t1031 * omega_r_17_y - t1062 + s_18 * t1060 - c_18 * t1059;
  const Scalar t1064 = t1062 + Scalar(0.035005) * t1030 * omega_16_z + t1063;
  const Scalar t1065 = Scalar(-0.043998) * t1049 - c_16 * t1064 - s_16 * t1061 +
      Scalar(0.5912714333326666) * t846 - Scalar(0.453) * t1048 - Scalar(0.24) * t1026 -
      Scalar(0.33) * t1029 - c_26 * t1027 - s_26 * t1020 - c_19 * t1028 - s_19 * t1021 +
      Scalar(89.72226) * t837 + Scalar(5.512820899999667) * t847;
  const Scalar t1066 = t529 * y_32 - t657 * y_25;
  const Scalar mu_u_16_x = Scalar(0.035005) * domega_15_x -
      Scalar(0.03438) * t1030 * omega_r_17_a_z + c_17 * mu_17_x - s_17 * t1057;
  const Scalar y_17 = tau_17 - t1063;
  const Scalar y_18 = t1056 + tau_18;
  const Scalar y_17_16 = mu_u_16_x - t754 * y_17 - s_17 * y_18 + tau_16;
  const Scalar y_16_15 = tau_15 - t766 * y_17 + Scalar(707.7641729774637) * t1066 - t744 * y_32_31 -
      t742 * y_31_30 + t740 * y_30_29 - t738 * y_29_28 - t605 * y_27_26 - t745 * y_25_24 +
      t743 * y_24_23 + t741 * y_23_22 - t739 * y_22_21 - t735 * y_20_19 + t767 * y_18 +
      t765 * y_17_16 - t736 * y_28_27 - t737 * y_21_20 + t1065;
  const Scalar t1067 = c_26 * f_27_z + s_26 * t1023;
  const Scalar t1068 = c_19 * f_20_z + s_19 * t1025;
  const Scalar t1069 = c_16 * f_u_18_t_y - s_16 * t1047;
  const Scalar t1070 = c_17 * t1042 - s_17 * t1046;
  const Scalar U_15_zz_xx = t843 - t1051;
  const Scalar t1071 = Scalar(-0.003) * t1070 - Scalar(0.043998) * U_15_zz_xx + c_16 * t1061 -
      s_16 * t1064 + Scalar(0.453) * t1069 + Scalar(0.5912714333326666) * t832 + t937 + t1019 -
      Scalar(0.33) * (t1067 + t1068) + Scalar(89.72226) * s_14 - Scalar(5.512820899999667) * t834;
  const Scalar t1072 = Scalar(0.003) * t1048 + Scalar(0.043998) * t851 - mu_u_16_x -
      Scalar(0.24) * (t1067 - t1068) + c_26 * t1020 - s_26 * t1027 + c_19 * t1021 - s_19 * t1028 -
      Scalar(4.921549466667001) * t838;
  const Scalar t1073 = t769 * y_32 - mu_u_25_15_t_y * y_25;
  const Scalar t1074 = c_14 * (qd_13 * t833 - Scalar(0.7479551597079861));
  const Scalar y_15_14 = tau_14 + t804 * y_18 - t803 * y_17 - Scalar(2.5051100666670005) * t1074 +
      Scalar(707.7641729774637) * t1073 + t799 * y_32_31 + t797 * y_31_30 - t795 * y_30_29 -
      t793 * y_29_28 + t791 * y_28_27 + t800 * y_25_24 + t798 * y_24_23 + t796 * y_23_22 -
      t794 * y_22_21 - t792 * y_21_20 - t802 * y_17_16 + t788 * y_16_15 + s_15 * t1072 -
      t789 * y_27_26 - t790 * y_20_19 + c_15 * t1071;
  const Scalar t1075 = c_14 * (Scalar(5.012670133334001) * t831 - c_15 * t1072 + s_15 * t1071);
  const Scalar mu_14_y = Scalar(0.00245) * t847 + t1065;
  const Scalar t1076 = mu_u_32_14_t_y * y_32 + t658 * y_25;
  const Scalar y_14_13 = tau_13 - t825 * y_17 + Scalar(707.7641729774637) * t1076 + t821 * y_32_31 +
      t819 * y_31_30 + t817 * y_30_29 - t815 * y_29_28 - t822 * y_25_24 - t820 * y_24_23 -
      t818 * y_23_22 + t816 * y_22_21 - t826 * y_18 - t824 * y_17_16 + t1075 - s_14 * mu_14_y +
      t813 * y_28_27 + t811 * y_27_26 - t814 * y_21_20 - t812 * y_20_19 - t810 * y_16_15 -
      t809 * y_15_14;
  const Scalar t1077 = (Scalar(1.0) / t827) * y_14_13;
  qdd[12] = -t1077;
  const Scalar t1078 = t808 * (y_15_14 - t805 * t1077);
  qdd[13] = -t1078;
  const Scalar qdd_15 = t787 * (t768 * t1077 - t785 * t1078 + y_16_15);
  qdd[14] = qdd_15;
  const Scalar qdd_16 = t763 * (t761 * t1077 + t784 * t1078 + t764 * qdd_15 + y_17_16);
  qdd[15] = qdd_16;
  const Scalar t1079 = t734 * (t732 * qdd_15 - t780 * t1078 - t728 * t1077 + y_20_19);
  qdd[18] = -t1079;
  const Scalar t1080 = t604 * (t597 * t1077 - t775 * t1078 + t602 * qdd_15 + y_27_26);
  qdd[25] = -t1080;
  const Scalar t1081 = mu_u_18_14_a_z * t1077 - t783 * t1078 + mu_u_18_15_a_y * qdd_15 + y_18;
  qdd[17] = Scalar(29.342723004694836) * t1081 - s_17 * qdd_16;
  const Scalar t1082 = t750 * qdd_15 - t751 * t1077 - t782 * t1078 + c_17 * Iu_18_a_yz * qdd_16 +
      y_17;
  qdd[16] = -t752 * t1082;
  const Scalar t1083 = t731 * qdd_15 - t719 * t1079 - t715 * t1077 - t779 * t1078 + y_21_20;
  const Scalar t1084 = t721 * t1083;
  qdd[19] = -t1084;
  const Scalar t1085 = b_28_27_26 * t1080 + t584 * t1077 + t601 * qdd_15 + t774 * t1078 + y_28_27;
  const Scalar t1086 = t590 * t1085;
  qdd[26] = -t1086;
  const Scalar t1087 = -b_22_21_15 * qdd_15 - t704 * t1077 + t718 * t1079 - t707 * t1084 +
      t778 * t1078 + y_22_21;
  const Scalar qdd_21 = t709 * t1087;
  qdd[20] = qdd_21;
  const Scalar t1088 = t575 * t1077 - t600 * qdd_15 + t588 * t1080 + t578 * t1086 + t773 * t1078 +
      y_29_28;
  const Scalar qdd_28 = d_28 * t1088;
  qdd[27] = qdd_28;
  const Scalar t1089 = -t697 * qdd_21 - t695 * t1077 - b_23_22_15 * qdd_15 + t777 * t1078 +
      t706 * t1084 + t717 * t1079 + y_23_22;
  const Scalar t1090 = t699 * t1089;
  qdd[21] = -t1090;
  const Scalar t1091 = t564 * t1077 - t566 * qdd_28 - b_30_29_15 * qdd_15 - t772 * t1078 -
      t577 * t1086 - t587 * t1080 + y_30_29;
  const Scalar t1092 = t568 * t1091;
  qdd[28] = -t1092;
  const Scalar t1093 = t776 * t1078 - t686 * t1077 + b_24_23_19 * t1079 - t730 * qdd_15 +
      t696 * qdd_21 - t705 * t1084 + t687 * t1090 + y_24_23;
  const Scalar t1094 = t689 * t1093;
  qdd[22] = -t1094;
  const Scalar t1095 = t771 * t1078 + t557 * t1077 + t586 * t1080 + t599 * qdd_15 + t565 * qdd_28 +
      t576 * t1086 + b_31_30_29 * t1092 + y_31_30;
  const Scalar t1096 = t559 * t1095;
  qdd[29] = -t1096;
  const Scalar t1097 = t729 * qdd_15 - t680 * t1094 - t677 * t1077 + b_25_24_14 * t1078 +
      t716 * t1079 + b_25_24_20 * t1084 + b_25_24_22 * t1090 - b_25_24_21 * qdd_21 + y_25_24;
  const Scalar t1098 = t679 * t1097;
  qdd[23] = -t1098;
  const Scalar t1099 = t551 * t1096 + b_32_31_13 * t1077 + t598 * qdd_15 + t770 * t1078 +
      t585 * t1080 + b_32_31_27 * t1086 + b_32_31_29 * t1092 - b_32_31_28 * qdd_28 + y_32_31;
  const Scalar t1100 = t550 * t1099;
  qdd[30] = -t1100;
  const Scalar t1101 = mu_u_25_15_t_y * t1078 - t658 * t1077 - t657 * qdd_15 +
      mu_u_25_20_t_y * t1079 - mu_u_25_20_a_y * t1084 - t651 * t1090 + t654 * qdd_21 +
      mu_u_25_24_t_y * t1094 + y_25;
  qdd[24] = Scalar(707.7641729774637) * t1101 - t659 * t1098;
  const Scalar t1102 = t529 * qdd_15 - mu_u_32_14_t_y * t1077 - t769 * t1078 - t525 * t1080 +
      mu_32_27_z * t1086 + mu_32_29_z * t1092 - mu_32_28_z * qdd_28 + mu_u_32_31_t_y * t1096 + y_32;
  qdd[31] = t530 * t1100 + Scalar(707.7641729774637) * t1102;
  bool positive = -t150 > Scalar(0.0);
  positive &= b_3_2_2 > Scalar(0.0);
  positive &= -t120 > Scalar(0.0);
  positive &= -t89 > Scalar(0.0);
  positive &= Ic_5_zz > Scalar(0.0);
  positive &= -t301 > Scalar(0.0);
  positive &= b_9_8_8 > Scalar(0.0);
  positive &= -t271 > Scalar(0.0);
  positive &= -t240 > Scalar(0.0);
  positive &= Ic_11_zz > Scalar(0.0);
  positive &= -t827 > Scalar(0.0);
  positive &= -t807 > Scalar(0.0);
  positive &= b_16_15_15 > Scalar(0.0);
  positive &= b_17_16_16 > Scalar(0.0);
  positive &= -mu_u_17_17_a_y > Scalar(0.0);
  positive &= -t733 > Scalar(0.0);
  positive &= -t720 > Scalar(0.0);
  positive &= t708 > Scalar(0.0);
  positive &= -t698 > Scalar(0.0);
  positive &= -t688 > Scalar(0.0);
  positive &= -t678 > Scalar(0.0);
  positive &= -t603 > Scalar(0.0);
  positive &= -t589 > Scalar(0.0);
  positive &= b_29_28_28 > Scalar(0.0);
  positive &= -t567 > Scalar(0.0);
  positive &= -t558 > Scalar(0.0);
  positive &= -t549 > Scalar(0.0);
  return positive;
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    1, 1, 1,
    1, 1, 1,
    1, 1, 1};

// Pose of the tip (2.50).
//   q[32]  in   joint positions, rad or m
//   R[9]   out  rotation matrix of the frame in the base frame
//               3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]   out  position of the frame's origin in the base frame, m
// Reads q[12..14], q[25..31]. Operations: 136 mul, 73 add, 20 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void forward_kinematics(const Scalar* q, Scalar* R, Scalar* p,
    const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<12, 13, 14, 25, 26, 27, 28, 29, 30, 31>(), sine, cosine);
  const Scalar s_13 = sine[12], c_13 = cosine[12], s_14 = sine[13], c_14 = cosine[13],
      s_15 = sine[14], c_15 = cosine[14], s_26 = sine[25], c_26 = cosine[25], s_27 = sine[26],
      c_27 = cosine[26], s_28 = sine[27], c_28 = cosine[27], s_29 = sine[28], c_29 = cosine[28],
      s_30 = sine[29], c_30 = cosine[29], s_31 = sine[30], c_31 = cosine[30], s_32 = sine[31],
      c_32 = cosine[31];
  const Scalar t1 = c_29 * s_31;
  const Scalar a_29_t_x = s_29 * c_31 + s_30 * t1;
  const Scalar t2 = c_30 * s_31;
  const Scalar t3 = s_28 * a_29_t_x - c_28 * t2;
  const Scalar t4 = s_29 * s_31;
  const Scalar t5 = s_30 * t4 - c_29 * c_31;
  const Scalar t6 = s_27 * t3 - c_27 * t5;
  const Scalar a_28_a_z = s_28 * t2 + c_28 * a_29_t_x;
  const Scalar t7 = s_26 * a_28_a_z - c_26 * t6;
  const Scalar t8 = s_27 * t5 + c_27 * t3;
  const Scalar t9 = s_15 * t8 - c_15 * t7;
  const Scalar a_26_a_z = s_26 * t6 + c_26 * a_28_a_z;
  R[8] = c_14 * t9 - s_14 * a_26_a_z;
  const Scalar a_14_t_x = s_14 * t9 + c_14 * a_26_a_z;
  const Scalar t10 = s_15 * t7 + c_15 * t8;
  R[5] = s_13 * a_14_t_x + c_13 * t10;
  const Scalar t11 = s_30 * c_31;
  const Scalar t12 = c_30 * c_32;
  const Scalar t13 = s_32 * t11 - t12;
  const Scalar n_29_t_x = s_32 * t4 - c_29 * t13;
  const Scalar t14 = c_30 * s_32;
  const Scalar n_30_t_y = s_30 * c_32 + c_31 * t14;
  const Scalar n_28_t_x = s_28 * n_29_t_x + c_28 * n_30_t_y;
  const Scalar n_29_a_z = s_29 * t13 + s_32 * t1;
  const Scalar t15 = s_27 * n_28_t_x + c_27 * n_29_a_z;
  const Scalar t16 = s_28 * n_30_t_y - c_28 * n_29_t_x;
  const Scalar t17 = s_26 * t16 + c_26 * t15;
  const Scalar t18 = s_27 * n_29_a_z - c_27 * n_28_t_x;
  const Scalar t19 = s_15 * t18 - c_15 * t17;
  const Scalar n_26_a_z = s_26 * t15 - c_26 * t16;
  R[6] = -s_14 * n_26_a_z - c_14 * t19;
  const Scalar t20 = t14 + c_32 * t11;
  const Scalar t21 = c_32 * t4 - c_29 * t20;
  const Scalar t22 = s_30 * s_32 - c_31 * t12;
  const Scalar s_28_t_x = s_28 * t21 - c_28 * t22;
  const Scalar s_29_a_z = s_29 * t20 + c_32 * t1;
  const Scalar t23 = s_27 * s_28_t_x + c_27 * s_29_a_z;
  const Scalar t24 = s_28 * t22 + c_28 * t21;
  const Scalar t25 = s_26 * t24 - c_26 * t23;
  const Scalar t26 = s_27 * s_29_a_z - c_27 * s_28_t_x;
  const Scalar t27 = s_15 * t26 + c_15 * t25;
  const Scalar t28 = s_26 * t23 + c_26 * t24;
  R[7] = -s_14 * t28 - c_14 * t27;
  R[2] = c_13 * a_14_t_x - s_13 * t10;
  const Scalar t29 = s_14 * t19 - c_14 * n_26_a_z;
  const Scalar t30 = s_15 * t17 + c_15 * t18;
  R[0] = s_13 * t30 - c_13 * t29;
  const Scalar p_32u_t_x = Scalar(0.006) * c_32 - Scalar(0.025) * s_32;
  const Scalar p_31u_t_x = c_31 * p_32u_t_x + Scalar(0.147) * s_31;
  const Scalar p_32u_t_y = Scalar(0.006) * s_32 + Scalar(0.025) * c_32;
  const Scalar t31 = Scalar(0.004) + c_30 * p_32u_t_y + s_30 * p_31u_t_x;
  const Scalar p_30_y = Scalar(0.147) * c_31 - s_31 * p_32u_t_x + Scalar(0.239);
  const Scalar t32 = c_29 * t31 - Scalar(0.004) + s_29 * p_30_y;
  const Scalar t33 = s_30 * p_32u_t_y - c_30 * p_31u_t_x;
  const Scalar t34 = c_28 * t33 + s_28 * t32;
  const Scalar t35 = s_29 * t31 - c_29 * p_30_y - Scalar(0.305);
  const Scalar p_27u_t_x = s_27 * t34 - c_27 * t35;
  const Scalar t36 = s_28 * t33 - c_28 * t32;
  const Scalar p_26_x = s_26 * t36 + c_26 * p_27u_t_x - Scalar(0.33);
  const Scalar t37 = c_27 * t34 - Scalar(0.24) + s_27 * t35;
  const Scalar p_15u_t_x = s_15 * t37 + c_15 * p_26_x;
  const Scalar p_26u_t_y = s_26 * p_27u_t_x - c_26 * t36;
  p[2] = s_14 * p_26u_t_y + Scalar(0.192) - c_14 * p_15u_t_x;
  R[3] = -s_13 * t29 - c_13 * t30;
  const Scalar t38 = s_14 * t27 - c_14 * t28;
  const Scalar s_15_t_y = s_15 * t25 - c_15 * t26;
  R[1] = -s_13 * s_15_t_y - c_13 * t38;
  R[4] = c_13 * s_15_t_y - s_13 * t38;
  const Scalar t39 = c_14 * p_26u_t_y + s_14 * p_15u_t_x;
  const Scalar p_15u_t_y = s_15 * p_26_x - c_15 * t37;
  p[0] = -c_13 * t39 - s_13 * p_15u_t_y;
  p[1] = c_13 * p_15u_t_y - s_13 * t39;
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[192] = {
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1};

// Geometric Jacobian of the tip (7.14), (7.15).
//   q[32]   in   joint positions, rad or m
//   J[192]  out  geometric Jacobian in base axes: linear rows, then angular
//                6 x 32, row by row: entry (i, j) is J[32 * i + j]
// Reads q[12..14], q[25..31]. Operations: 190 mul, 106 add, 20 sin/cos. Always zero: 136 of the 192
// entries of J.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian(const Scalar* q, Scalar* J, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<12, 13, 14, 25, 26, 27, 28, 29, 30, 31>(), sine, cosine);
  const Scalar s_13 = sine[12], c_13 = cosine[12], s_14 = sine[13], c_14 = cosine[13],
      s_15 = sine[14], c_15 = cosine[14], s_26 = sine[25], c_26 = cosine[25], s_27 = sine[26],
      c_27 = cosine[26], s_28 = sine[27], c_28 = cosine[27], s_29 = sine[28], c_29 = cosine[28],
      s_30 = sine[29], c_30 = cosine[29], s_31 = sine[30], c_31 = cosine[30], s_32 = sine[31],
      c_32 = cosine[31];
  J[141] = c_13;
  J[174] = -s_14;
  J[109] = -s_13;
  const Scalar z_15_x = c_13 * c_14;
  J[110] = z_15_x;
  const Scalar z_15_y = s_13 * c_14;
  J[142] = z_15_y;
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
  const Scalar t6 = t1 + c_15 * t2;
  const Scalar z_27_x = c_26 * z_15_x - s_26 * t6;
  J[122] = z_27_x;
  const Scalar t7 = c_13 * s_15 - s_14 * t3;
  const Scalar z_27_y = c_26 * z_15_y + s_26 * t7;
  J[154] = z_27_y;
  const Scalar t8 = s_14 * s_26 - c_26 * t5;
  const Scalar R_292_a_y = c_27 * t8 + s_27 * R_152_y;
  J[187] = -R_292_a_y;
  const Scalar t9 = c_26 * t6 + s_26 * z_15_x;
  const Scalar R_270_y = c_27 * t9 + s_27 * t4;
  J[123] = R_270_y;
  const Scalar R_272_x = c_27 * R_152_y - s_27 * t8;
  const Scalar R_282_y = c_28 * R_272_x + s_28 * R_262_y;
  J[188] = R_282_y;
  const Scalar t10 = c_26 * t7 - s_26 * z_15_y;
  const Scalar R_291_a_y = c_27 * t10 + s_27 * R_151_y;
  J[155] = -R_291_a_y;
  const Scalar R_271_x = c_27 * R_151_y - s_27 * t10;
  const Scalar R_281_y = c_28 * R_271_x - s_28 * z_27_y;
  J[156] = R_281_y;
  const Scalar t11 = c_27 * t4 - s_27 * t9;
  const Scalar t12 = c_28 * t11 + s_28 * z_27_x;
  J[124] = -t12;
  const Scalar t13 = c_28 * R_262_y - s_28 * R_272_x;
  const Scalar t14 = c_29 * R_292_a_y + s_29 * t13;
  J[189] = -t14;
  const Scalar R_280_x = c_28 * z_27_x - s_28 * t11;
  const Scalar z_30_x = c_29 * R_270_y + s_29 * R_280_x;
  J[125] = z_30_x;
  const Scalar R_281_x = c_28 * z_27_y + s_28 * R_271_x;
  const Scalar t15 = c_29 * R_291_a_y - s_29 * R_281_x;
  J[157] = -t15;
  const Scalar t16 = c_29 * t13 - s_29 * R_292_a_y;
  const Scalar t17 = c_30 * t16 - s_30 * R_282_y;
  J[190] = -t17;
  const Scalar R_290_x = c_29 * R_280_x - s_29 * R_270_y;
  const Scalar z_31_x = c_30 * R_290_x - s_30 * t12;
  J[126] = z_31_x;
  const Scalar R_291_x = c_29 * R_281_x + s_29 * R_291_a_y;
  const Scalar z_31_y = c_30 * R_291_x + s_30 * R_281_y;
  J[158] = z_31_y;
  const Scalar t18 = c_31 * t14 + s_31 * (c_30 * R_282_y + s_30 * t16);
  J[191] = -t18;
  const Scalar R_310_y = c_31 * z_30_x + s_31 * (c_30 * t12 + s_30 * R_290_x);
  J[127] = R_310_y;
  const Scalar t19 = c_31 * t15 + s_31 * (c_30 * R_281_y - s_30 * R_291_x);
  J[159] = -t19;
  const Scalar p_32u_t_x = Scalar(0.006) * c_32 - Scalar(0.025) * s_32;
  const Scalar p_31u_t_x = c_31 * p_32u_t_x + Scalar(0.147) * s_31;
  const Scalar p_32u_t_y = Scalar(0.006) * s_32 + Scalar(0.025) * c_32;
  const Scalar t20 = Scalar(0.004) + c_30 * p_32u_t_y + s_30 * p_31u_t_x;
  const Scalar p_30_y = Scalar(0.147) * c_31 - s_31 * p_32u_t_x + Scalar(0.239);
  const Scalar t21 = c_29 * t20 - Scalar(0.004) + s_29 * p_30_y;
  const Scalar t22 = c_30 * p_31u_t_x - s_30 * p_32u_t_y;
  const Scalar t23 = c_28 * t22 - s_28 * t21;
  const Scalar t24 = c_29 * p_30_y - s_29 * t20 + Scalar(0.305);
  const Scalar p_27u_t_x = c_27 * t24 - s_27 * t23;
  const Scalar t25 = s_28 * t22 + c_28 * t21;
  const Scalar p_26_x = c_26 * p_27u_t_x - s_26 * t25 - Scalar(0.33);
  const Scalar t26 = c_27 * t23 + Scalar(0.24) + s_27 * t24;
  const Scalar p_15u_t_x = c_15 * p_26_x - s_15 * t26;
  const Scalar p_26u_t_y = c_26 * t25 + s_26 * p_27u_t_x;
  const Scalar t27 = c_14 * p_15u_t_x - s_14 * p_26u_t_y;
  J[13] = -c_13 * t27;
  J[45] = -s_13 * t27;
  const Scalar t28 = c_14 * p_26u_t_y + s_14 * p_15u_t_x;
  const Scalar p_15u_t_y = c_15 * t26 + s_15 * p_26_x;
  const Scalar t29 = c_13 * t28 + s_13 * p_15u_t_y;
  J[44] = -t29;
  const Scalar t30 = c_13 * p_15u_t_y - s_13 * t28;
  J[12] = -t30;
  J[77] = c_13 * t29 - s_13 * t30;
  J[14] = s_14 * t30 - t27 * z_15_y;
  J[46] = s_14 * t29 + t27 * z_15_x;
  J[78] = c_14 * (s_13 * t29 + c_13 * t30);
  const Scalar t31 = Scalar(0.33) * t7 - Scalar(0.24) * R_151_y + t30;
  const Scalar t32 = Scalar(0.24) * R_152_y + Scalar(0.33) * t5 + t27;
  J[26] = t31 * R_262_y - t32 * z_27_y;
  const Scalar t33 = Scalar(0.33) * t6 - Scalar(0.24) * t4 + t29;
  J[58] = t33 * R_262_y + t32 * z_27_x;
  J[90] = t33 * z_27_y + t31 * z_27_x;
  J[25] = -R_151_y * t32 - R_152_y * t31;
  J[57] = -t4 * t32 - R_152_y * t33;
  J[89] = R_151_y * t33 - t4 * t31;
  const Scalar t34 = t31 - Scalar(0.305) * R_291_a_y;
  const Scalar t35 = Scalar(0.305) * R_292_a_y + t32;
  J[27] = R_291_a_y * t35 + R_292_a_y * t34;
  const Scalar t36 = t33 - Scalar(0.305) * R_270_y;
  J[59] = R_270_y * t35 + R_292_a_y * t36;
  J[91] = R_270_y * t34 - R_291_a_y * t36;
  const Scalar t37 = t34 - Scalar(0.004) * R_281_x;
  const Scalar t38 = t35 - Scalar(0.004) * t13;
  J[28] = -R_281_y * t38 - R_282_y * t37;
  const Scalar t39 = Scalar(0.004) * R_280_x + t36;
  J[60] = -t12 * t38 - R_282_y * t39;
  J[92] = R_281_y * t39 - t12 * t37;
  const Scalar t40 = Scalar(0.004) * R_291_x - Scalar(0.239) * t15 + t37;
  const Scalar t41 = Scalar(0.004) * t16 + Scalar(0.239) * t14 + t38;
  J[29] = t15 * t41 + t14 * t40;
  const Scalar t42 = Scalar(-0.004) * R_290_x - Scalar(0.239) * z_30_x + t39;
  J[61] = z_30_x * t41 + t14 * t42;
  J[93] = z_30_x * t40 - t15 * t42;
  J[30] = t40 * t17 - t41 * z_31_y;
  J[62] = t41 * z_31_x + t42 * t17;
  J[94] = t42 * z_31_y + t40 * z_31_x;
  J[31] = t41 * t19 + t40 * t18;
  J[63] = t41 * R_310_y + t42 * t18;
  J[95] = t40 * R_310_y - t42 * t19;
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

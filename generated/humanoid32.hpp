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
// sine, c_1 its cosine, s_2_3 the sine of the angle by which parallel joints 2 and 3 together turn.
// Of link i: omega_i and domega_i are its angular velocity and acceleration, ddp_i the acceleration
// of its frame's origin less gravity, f_i and mu_i the force and moment that it gets from the link
// before, hc_i and hu_i the first moment of all that its joint carries (in gravity() times the size
// of gravity); t1, t2, ... are parts of sums.

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

namespace detail {

// Scalars of flatdyn's runtime say which version of generated code they are for. Others fit.
struct Interface {
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
    static_assert(detail::Interface::checked<Scalar>());
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
    static_assert(detail::Interface::checked<Scalar>());
    ((s[joint] = sine[joint], c[joint] = cosine[joint]), ...);
  }
};

// tau = B(q) qdd + C(q, qd) qd + g(q) + friction (7.42).
//   q[32]    in   joint positions, rad or m
//   qd[32]   in   joint velocities, rad/s or m/s
//   qdd[32]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[32]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11], q[13..31], qd[0..31], qdd[0..31]. Operations: 1013 mul, 863 add, 62 sin/cos.
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
  const Scalar t1 = s_14 * qd_13;
  const Scalar t2 = Scalar(2.0) * qd_14 * t1 - c_14 * qdd_13;
  const Scalar t3 = c_14 * qd_13;
  const Scalar t4 = t3 * t1;
  const Scalar Uz_o_15_x = t4 + qdd_14;
  const Scalar t5 = s_15 * t2 - c_15 * Uz_o_15_x;
  const Scalar t6 = s_15 * qd_14 - c_15 * t3;
  const Scalar omega_15_z = qd_15 - t1;
  const Scalar t7 = t6 * omega_15_z;
  const Scalar t8 = t5 + t7;
  const Scalar t9 = t7 + t8;
  const Scalar omega_r_15_y = s_15 * t3 + c_15 * qd_14;
  const Scalar omega_r_17_a_z = s_16 * omega_r_15_y + c_16 * omega_15_z;
  const Scalar omega_16_z = qd_16 - t6;
  const Scalar t10 = qd_14 * t3;
  const Scalar domega_14_y = t10 + s_14 * qdd_13;
  const Scalar domega_15_z = qdd_15 - domega_14_y;
  const Scalar t11 = t6 * omega_r_15_y;
  const Scalar U_15_yx = t11 + domega_15_z;
  const Scalar t12 = s_16 * U_15_yx + c_16 * t9 + Scalar(2.0) * omega_r_17_a_z * omega_16_z;
  const Scalar t13 = s_15 * Uz_o_15_x + c_15 * t2;
  const Scalar t14 = omega_r_15_y * omega_15_z;
  const Scalar t15 = t13 + t14;
  const Scalar domega_16_z = qdd_16 - t15;
  const Scalar t16 = s_16 * omega_15_z - c_16 * omega_r_15_y;
  const Scalar t17 = t16 * omega_r_17_a_z;
  const Scalar Uz_o_17_x = domega_16_z - t17;
  const Scalar omega_r_17_y = s_17 * omega_16_z - c_17 * t16;
  const Scalar omega_17_z = qd_17 + omega_r_17_a_z;
  const Scalar t18 = Scalar(2.0) * omega_17_z;
  const Scalar t19 = omega_r_17_y * t18 - c_17 * Uz_o_17_x - s_17 * t12;
  const Scalar omega_18_z = qd_18 + omega_r_17_y;
  const Scalar t20 = t19 - t18 * omega_18_z;
  const Scalar I_t18_g = Scalar(0.0044) * c_18 + Scalar(0.024) * s_18;
  const Scalar t21 = c_18 * I_t18_g - Scalar(0.0022);
  const Scalar t22 = t16 * omega_16_z;
  const Scalar t23 = t22 + s_16 * t9 - c_16 * U_15_yx;
  const Scalar domega_17_z = qdd_17 - t23;
  const Scalar t24 = s_17 * t16 + c_17 * omega_16_z;
  const Scalar t25 = t24 * omega_r_17_y;
  const Scalar t26 = t25 + domega_17_z;
  const Scalar t27 = t26 - Scalar(2.0) * t24 * omega_18_z;
  const Scalar t28 = s_18 * I_t18_g;
  const Scalar t29 = t28 - Scalar(0.02904);
  const Scalar Uz_o_15_y = t3 * t3 + qd_14 * qd_14;
  const Scalar t30 = Scalar(2452.5) * s_14;
  const Scalar t31 = Scalar(0.75) * Uz_o_15_y - t30 - Scalar(113.25) * t9;
  const Scalar t32 = Scalar(2452.5) * c_14 * s_15;
  const Scalar t33 = Scalar(0.75) * t13 - Scalar(113.25) * U_15_yx + t32;
  const Scalar t34 = s_16 * t31 - c_16 * t33;
  const Scalar t35 = t6 * t6;
  const Scalar t36 = omega_15_z * omega_15_z;
  const Scalar Uz_o_16_x = Uz_o_15_y - t35 + t36;
  const Scalar t37 = c_14 * c_15;
  const Scalar t38 = Scalar(2452.5) * t37;
  const Scalar t39 = Scalar(0.75) * t5 + Scalar(113.25) * Uz_o_16_x - t38;
  const Scalar t40 = s_17 * t39 + c_17 * t34;
  const Scalar t41 = Scalar(0.00088) * c_18 - Scalar(0.00008) * s_18;
  const Scalar U_17_yx = domega_17_z - t25;
  const Scalar mu_17_z = Scalar(0.00025) * U_17_yx + Scalar(0.00509) * t26 + t20 * t21 - t27 * t29 +
      t41 * t40;
  tau[16] = mu_17_z;
  const Scalar t42 = c_8 * qd_7;
  const Scalar t43 = s_8 * qd_7;
  const Scalar t44 = t42 * t43;
  const Scalar t45 = t44 + qdd_8;
  const Scalar t46 = Scalar(2452.5) * c_7;
  const Scalar ddp_o_9_x = Scalar(97.25) * t45 + s_8 * t46;
  const Scalar t47 = Scalar(2.0) * qd_8 * t43 - c_8 * qdd_7;
  const Scalar ddp_9_a_y = Scalar(2452.5) * s_7 - Scalar(97.25) * t47;
  const Scalar t48 = s_9 * ddp_o_9_x - c_9 * ddp_9_a_y;
  const Scalar omega_r_9_x = s_9 * t42 + c_9 * qd_8;
  const Scalar t49 = omega_r_9_x * omega_r_9_x;
  const Scalar t50 = t42 * t42 + qd_8 * qd_8;
  const Scalar omega_9_z = qd_9 - t43;
  const Scalar t51 = omega_9_z * omega_9_z;
  const Scalar t52 = t50 - t49 + t51;
  const Scalar ddp_o_10_x = Scalar(5.0) * t52 + t48;
  const Scalar t53 = omega_r_9_x * omega_9_z;
  const Scalar t54 = s_9 * t45 + t53 + c_9 * t47;
  const Scalar U_9_zx = t53 + t54;
  const Scalar t55 = Scalar(97.25) * t50 - Scalar(5.0) * U_9_zx + c_8 * t46;
  const Scalar t56 = s_10 * ddp_o_10_x + c_10 * t55;
  const Scalar t57 = s_10 * omega_r_9_x + c_10 * omega_9_z;
  const Scalar t58 = t57 * t57;
  const Scalar t59 = s_9 * qd_8 - c_9 * t42;
  const Scalar omega_10_z = qd_10 - t59;
  const Scalar t60 = omega_10_z * omega_10_z;
  const Scalar domega_10_z = qdd_10 - t54;
  const Scalar t61 = s_10 * omega_9_z - c_10 * omega_r_9_x;
  const Scalar t62 = t57 * t61;
  const Scalar Uz_o_11_x = t62 + domega_10_z;
  const Scalar t63 = t56 - Scalar(10.0) * Uz_o_11_x + Scalar(89.25) * (t49 + t51 + t60 - t58);
  const Scalar t64 = s_9 * t47 - c_9 * t45;
  const Scalar t65 = t64 + Scalar(2.0) * t59 * omega_9_z;
  const Scalar t66 = t57 * omega_10_z;
  const Scalar t67 = qd_8 * t42;
  const Scalar t68 = t67 + s_8 * qdd_7;
  const Scalar domega_9_z = qdd_9 - t68;
  const Scalar t69 = omega_r_9_x * t59;
  const Scalar t70 = t69 + domega_9_z;
  const Scalar t71 = t66 + s_10 * t70 + c_10 * t65;
  const Scalar t72 = t66 + t71;
  const Scalar t73 = s_10 * t65 - c_10 * t70 + Scalar(2.0) * t61 * omega_10_z;
  const Scalar ddp_9_y = s_9 * ddp_9_a_y + c_9 * ddp_o_9_x;
  const Scalar U_9_yx = domega_9_z - t69;
  const Scalar t74 = Scalar(5.0) * U_9_yx - ddp_9_y;
  const Scalar t75 = Scalar(10.0) * t73 + t74 + Scalar(89.25) * t72;
  const Scalar t76 = s_11 * t63 - c_11 * t75;
  const Scalar mr_12_x = Scalar(0.00018) * s_12 + Scalar(0.00042) * c_12;
  const Scalar omega_r_11_y = s_11 * t57 + c_11 * omega_10_z;
  const Scalar omega_11_z = qd_11 - t61;
  const Scalar t77 = Scalar(2.0) * omega_11_z;
  const Scalar t78 = s_11 * Uz_o_11_x + omega_r_11_y * t77 + c_11 * t73;
  const Scalar omega_12_z = qd_12 + omega_r_11_y;
  const Scalar t79 = t78 - t77 * omega_12_z;
  const Scalar t80 = Scalar(0.0063) * c_12 - Scalar(0.0012) * s_12;
  const Scalar I_12_xy = c_12 * t80 - Scalar(0.00315);
  const Scalar domega_11_z = qdd_11 - t71;
  const Scalar t81 = s_11 * omega_10_z - c_11 * t57;
  const Scalar t82 = t81 * omega_r_11_y;
  const Scalar t83 = domega_11_z - t82;
  const Scalar t84 = t83 + Scalar(2.0) * t81 * omega_12_z;
  const Scalar t85 = s_12 * t80;
  const Scalar I_12_yy = t85 + Scalar(0.007758333333335);
  const Scalar U_11_yx = t82 + domega_11_z;
  const Scalar mu_11_z = Scalar(0.00032) * U_11_yx + Scalar(0.001328333333335) * t83 -
      t79 * I_12_xy + t84 * I_12_yy + mr_12_x * t76;
  tau[10] = mu_11_z;
  const Scalar t86 = c_2 * qd_1;
  const Scalar t87 = s_2 * qd_1;
  const Scalar t88 = t86 * t87;
  const Scalar t89 = t88 + qdd_2;
  const Scalar t90 = Scalar(2452.5) * c_1;
  const Scalar ddp_o_3_x = Scalar(97.25) * t89 + s_2 * t90;
  const Scalar t91 = Scalar(2.0) * qd_2 * t87 - c_2 * qdd_1;
  const Scalar ddp_3_a_y = Scalar(2452.5) * s_1 - Scalar(97.25) * t91;
  const Scalar t92 = s_3 * ddp_o_3_x - c_3 * ddp_3_a_y;
  const Scalar omega_r_3_x = s_3 * t86 + c_3 * qd_2;
  const Scalar t93 = omega_r_3_x * omega_r_3_x;
  const Scalar t94 = t86 * t86 + qd_2 * qd_2;
  const Scalar omega_3_z = qd_3 - t87;
  const Scalar t95 = omega_3_z * omega_3_z;
  const Scalar t96 = t94 - t93 + t95;
  const Scalar ddp_o_4_x = Scalar(5.0) * t96 + t92;
  const Scalar t97 = omega_r_3_x * omega_3_z;
  const Scalar t98 = s_3 * t89 + t97 + c_3 * t91;
  const Scalar U_3_zx = t97 + t98;
  const Scalar t99 = Scalar(97.25) * t94 - Scalar(5.0) * U_3_zx + c_2 * t90;
  const Scalar t100 = s_4 * ddp_o_4_x + c_4 * t99;
  const Scalar t101 = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar t102 = t101 * t101;
  const Scalar t103 = s_3 * qd_2 - c_3 * t86;
  const Scalar omega_4_z = qd_4 - t103;
  const Scalar t104 = omega_4_z * omega_4_z;
  const Scalar domega_4_z = qdd_4 - t98;
  const Scalar t105 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar t106 = t101 * t105;
  const Scalar Uz_o_5_x = t106 + domega_4_z;
  const Scalar t107 = t100 - Scalar(10.0) * Uz_o_5_x + Scalar(89.25) * (t93 + t95 + t104 - t102);
  const Scalar t108 = s_3 * t91 - c_3 * t89;
  const Scalar t109 = t108 + Scalar(2.0) * t103 * omega_3_z;
  const Scalar t110 = t101 * omega_4_z;
  const Scalar t111 = qd_2 * t86;
  const Scalar t112 = t111 + s_2 * qdd_1;
  const Scalar domega_3_z = qdd_3 - t112;
  const Scalar t113 = omega_r_3_x * t103;
  const Scalar t114 = t113 + domega_3_z;
  const Scalar t115 = t110 + s_4 * t114 + c_4 * t109;
  const Scalar t116 = t110 + t115;
  const Scalar t117 = s_4 * t109 - c_4 * t114 + Scalar(2.0) * t105 * omega_4_z;
  const Scalar ddp_3_y = s_3 * ddp_3_a_y + c_3 * ddp_o_3_x;
  const Scalar U_3_yx = domega_3_z - t113;
  const Scalar t118 = Scalar(5.0) * U_3_yx - ddp_3_y;
  const Scalar t119 = Scalar(10.0) * t117 + t118 + Scalar(89.25) * t116;
  const Scalar t120 = s_5 * t107 - c_5 * t119;
  const Scalar mr_6_x = Scalar(0.00018) * s_6 + Scalar(0.00042) * c_6;
  const Scalar omega_r_5_y = s_5 * t101 + c_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 - t105;
  const Scalar t121 = Scalar(2.0) * omega_5_z;
  const Scalar t122 = s_5 * Uz_o_5_x + omega_r_5_y * t121 + c_5 * t117;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t123 = t122 - t121 * omega_6_z;
  const Scalar t124 = Scalar(0.0063) * c_6 - Scalar(0.0012) * s_6;
  const Scalar I_6_xy = c_6 * t124 - Scalar(0.00315);
  const Scalar domega_5_z = qdd_5 - t115;
  const Scalar t125 = s_5 * omega_4_z - c_5 * t101;
  const Scalar t126 = t125 * omega_r_5_y;
  const Scalar t127 = domega_5_z - t126;
  const Scalar t128 = t127 + Scalar(2.0) * t125 * omega_6_z;
  const Scalar t129 = s_6 * t124;
  const Scalar I_6_yy = t129 + Scalar(0.007758333333335);
  const Scalar U_5_yx = t126 + domega_5_z;
  const Scalar mu_5_z = Scalar(0.00032) * U_5_yx + Scalar(0.001328333333335) * t127 -
      t123 * I_6_xy + t128 * I_6_yy + mr_6_x * t120;
  tau[4] = mu_5_z;
  const Scalar t130 = t125 * omega_5_z;
  const Scalar t131 = t130 - c_5 * Uz_o_5_x + s_5 * t117;
  const Scalar domega_6_z = qdd_6 - t131;
  const Scalar t132 = t130 - domega_6_z;
  const Scalar t133 = t130 + domega_6_z;
  const Scalar t134 = t129 - Scalar(0.006558333333335);
  const Scalar t135 = c_5 * t107 + s_5 * t119;
  const Scalar t136 = Scalar(0.00018) * c_6 - Scalar(0.00042) * s_6;
  const Scalar t137 = omega_6_z * omega_6_z;
  const Scalar t138 = t137 + omega_5_z * omega_5_z;
  const Scalar t139 = t125 * t125 + t137;
  const Scalar t140 = s_4 * t99 - c_4 * ddp_o_4_x;
  const Scalar U_4_yx = domega_4_z - t106;
  const Scalar Uz_o_5_y = t104 + t102;
  const Scalar ddp_o_5_y = Scalar(10.0) * Uz_o_5_y + Scalar(89.25) * U_4_yx + t140;
  const Scalar t141 = I_6_xy * (t138 - t139) + t132 * I_6_yy + t133 * t134 + t136 * t135 -
      mr_6_x * ddp_o_5_y;
  tau[5] = -t141;
  const Scalar t142 = t81 * omega_11_z;
  const Scalar t143 = t142 - c_11 * Uz_o_11_x + s_11 * t73;
  const Scalar domega_12_z = qdd_12 - t143;
  const Scalar t144 = t142 - domega_12_z;
  const Scalar t145 = t142 + domega_12_z;
  const Scalar t146 = t85 - Scalar(0.006558333333335);
  const Scalar t147 = c_11 * t63 + s_11 * t75;
  const Scalar t148 = Scalar(0.00018) * c_12 - Scalar(0.00042) * s_12;
  const Scalar t149 = omega_12_z * omega_12_z;
  const Scalar t150 = t149 + omega_11_z * omega_11_z;
  const Scalar t151 = t81 * t81 + t149;
  const Scalar t152 = s_10 * t55 - c_10 * ddp_o_10_x;
  const Scalar U_10_yx = domega_10_z - t62;
  const Scalar Uz_o_11_y = t60 + t58;
  const Scalar ddp_o_11_y = Scalar(10.0) * Uz_o_11_y + Scalar(89.25) * U_10_yx + t152;
  const Scalar t153 = I_12_xy * (t150 - t151) + t144 * I_12_yy + t145 * t146 + t148 * t147 -
      mr_12_x * ddp_o_11_y;
  tau[11] = -t153;
  const Scalar t154 = t24 * omega_17_z;
  const Scalar t155 = t154 + s_17 * Uz_o_17_x - c_17 * t12;
  const Scalar domega_18_z = qdd_18 + t155;
  const Scalar U_18_yx = t154 + domega_18_z;
  const Scalar U_18_xy = t154 - domega_18_z;
  const Scalar I_18_xx = Scalar(0.00504) + t28;
  const Scalar t156 = Scalar(0.00008) * c_18 + Scalar(0.00088) * s_18;
  const Scalar t157 = t156 * (s_17 * t34 - c_17 * t39);
  const Scalar t158 = omega_18_z * omega_18_z;
  const Scalar t159 = t158 + omega_17_z * omega_17_z;
  const Scalar t160 = t24 * t24 + t158;
  const Scalar t161 = s_16 * t33 + c_16 * t31;
  const Scalar tau_18 = t21 * (t159 - t160) - U_18_xy * I_18_xx - U_18_yx * t29 - t157 + t41 * t161;
  tau[17] = tau_18;
  const Scalar t162 = mr_12_x * t150 - t148 * t145 + Scalar(0.0000615126050420168) * t147;
  const Scalar t163 = mr_12_x * t84 - t148 * t79 + Scalar(0.0000615126050420168) * t76;
  const Scalar t164 = s_11 * t163 + c_11 * t162;
  const Scalar t165 = Scalar(0.00032) * (t142 + t143) + t153;
  const Scalar t166 = Scalar(0.001328333333335) * t78 - t84 * I_12_xy - t79 * t146 - t148 * t76;
  const Scalar f_u_11_a_y = t148 * t151 - mr_12_x * t144 +
      Scalar(0.0000615126050420168) * ddp_o_11_y;
  const Scalar mu_10_z = Scalar(0.008593739495798319) * Uz_o_11_x -
      Scalar(0.0002648739495798319) * t56 + s_11 * t166 - c_11 * t165 - Scalar(0.06566) * U_10_yx -
      Scalar(10.0) * t164 + Scalar(89.25) * f_u_11_a_y;
  tau[9] = mu_10_z;
  const Scalar t167 = mr_6_x * t138 - t136 * t133 + Scalar(0.0000615126050420168) * t135;
  const Scalar t168 = mr_6_x * t128 - t136 * t123 + Scalar(0.0000615126050420168) * t120;
  const Scalar t169 = s_5 * t168 + c_5 * t167;
  const Scalar t170 = Scalar(0.00032) * (t130 + t131) + t141;
  const Scalar t171 = Scalar(0.001328333333335) * t122 - t128 * I_6_xy - t123 * t134 - t136 * t120;
  const Scalar f_u_5_a_y = t136 * t139 - mr_6_x * t132 + Scalar(0.0000615126050420168) * ddp_o_5_y;
  const Scalar mu_4_z = Scalar(0.008593739495798319) * Uz_o_5_x -
      Scalar(0.0002648739495798319) * t100 + s_5 * t171 - c_5 * t170 - Scalar(0.06566) * U_4_yx -
      Scalar(10.0) * t169 + Scalar(89.25) * f_u_5_a_y;
  tau[3] = mu_4_z;
  const Scalar mu_17_y = Scalar(0.00025) * (t154 + t155) + tau_18;
  const Scalar t172 = Scalar(0.00509) * t19 + t20 * I_18_xx + t27 * t21 + t156 * t40;
  const Scalar U_16_yx = t17 + domega_16_z;
  const Scalar mu_16_z = Scalar(0.0003125) * U_16_yx + Scalar(0.0005625) * Uz_o_17_x +
      s_17 * mu_17_y - c_17 * t172;
  tau[15] = mu_16_z;
  const Scalar t173 = s_11 * t162 - c_11 * t163;
  const Scalar t174 = Scalar(0.06566) * t72 + mu_11_z - Scalar(89.25) * t173;
  const Scalar t175 = Scalar(0.008593739495798319) * t73 + Scalar(0.0002648739495798319) * t74 +
      s_11 * t165 + c_11 * t166 + Scalar(10.0) * t173;
  const Scalar t176 = Scalar(2.4873949579831934e-06) * t74 + Scalar(0.0002648739495798319) * t73 +
      t173;
  const Scalar tau_9 = Scalar(0.00507) * t64 + Scalar(0.00605) * t70 + Scalar(0.006525) * U_9_yx +
      Scalar(5.0) * t176 - c_10 * t175 - s_10 * t174;
  tau[8] = tau_9;
  const Scalar t177 = s_5 * t167 - c_5 * t168;
  const Scalar t178 = Scalar(0.06566) * t116 + mu_5_z - Scalar(89.25) * t177;
  const Scalar t179 = Scalar(0.008593739495798319) * t117 + Scalar(0.0002648739495798319) * t118 +
      s_5 * t170 + c_5 * t171 + Scalar(10.0) * t177;
  const Scalar t180 = Scalar(2.4873949579831934e-06) * t118 + Scalar(0.0002648739495798319) * t117 +
      t177;
  const Scalar tau_3 = Scalar(0.00507) * t108 + Scalar(0.00605) * t114 + Scalar(0.006525) * U_3_yx +
      Scalar(5.0) * t180 - c_4 * t179 - s_4 * t178;
  tau[2] = tau_3;
  const Scalar f_10_x = Scalar(0.0002648739495798319) * Uz_o_11_x -
      Scalar(2.4873949579831934e-06) * t56 - t164;
  const Scalar f_10_y = Scalar(0.0002648739495798319) * Uz_o_11_y +
      Scalar(2.4873949579831934e-06) * t152 + f_u_11_a_y;
  const Scalar t181 = Scalar(0.000051146529562982) * t48 - s_10 * f_10_x - c_10 * f_10_y;
  const Scalar f_9_y = Scalar(0.000051146529562982) * ddp_9_y - t176;
  const Scalar f_u_9_t_x = s_9 * t181 + c_9 * f_9_y;
  const Scalar t182 = s_10 * f_10_y - c_10 * f_10_x;
  const Scalar t183 = Scalar(0.006525) * U_9_zx - Scalar(0.00507) * (t50 - t52) -
      Scalar(5.0) * t182 - mu_10_z;
  const Scalar t184 = Scalar(0.00507) * U_9_yx + Scalar(0.00605) * t65 + s_10 * t175 - c_10 * t174;
  const Scalar U_8_yx = qdd_8 - t44;
  const Scalar t185 = Scalar(0.08166) * t45 - Scalar(0.00098) * U_8_yx + c_9 * t184 - s_9 * t183 -
      Scalar(97.25) * f_u_9_t_x;
  tau[7] = -t185;
  const Scalar f_4_x = Scalar(0.0002648739495798319) * Uz_o_5_x -
      Scalar(2.4873949579831934e-06) * t100 - t169;
  const Scalar f_4_y = Scalar(0.0002648739495798319) * Uz_o_5_y +
      Scalar(2.4873949579831934e-06) * t140 + f_u_5_a_y;
  const Scalar t186 = Scalar(0.000051146529562982) * t92 - s_4 * f_4_x - c_4 * f_4_y;
  const Scalar f_3_y = Scalar(0.000051146529562982) * ddp_3_y - t180;
  const Scalar f_u_3_t_x = s_3 * t186 + c_3 * f_3_y;
  const Scalar t187 = s_4 * f_4_y - c_4 * f_4_x;
  const Scalar t188 = Scalar(0.006525) * U_3_zx - Scalar(0.00507) * (t94 - t96) -
      Scalar(5.0) * t187 - mu_4_z;
  const Scalar t189 = Scalar(0.00507) * U_3_yx + Scalar(0.00605) * t109 + s_4 * t179 - c_4 * t178;
  const Scalar U_2_yx = qdd_2 - t88;
  const Scalar t190 = Scalar(0.08166) * t89 - Scalar(0.00098) * U_2_yx + c_3 * t189 - s_3 * t188 -
      Scalar(97.25) * f_u_3_t_x;
  tau[1] = -t190;
  const Scalar f_u_9_t_y = s_9 * f_9_y - c_9 * t181;
  const Scalar t191 = Scalar(0.08166) * t47 - s_9 * t184 - c_9 * t183 + Scalar(97.25) * f_u_9_t_y;
  const Scalar U_8_zx = t67 + t68;
  tau[6] = Scalar(0.00294) * qdd_7 + s_8 * (Scalar(0.00098) * U_8_zx - tau_9) + c_8 * t191;
  const Scalar f_u_3_t_y = s_3 * f_3_y - c_3 * t186;
  const Scalar t192 = Scalar(0.08166) * t91 - s_3 * t189 - c_3 * t188 + Scalar(97.25) * f_u_3_t_y;
  const Scalar U_2_zx = t111 + t112;
  tau[0] = Scalar(0.00294) * qdd_1 + s_2 * (Scalar(0.00098) * U_2_zx - tau_3) + c_2 * t192;
  const Scalar t193 = Scalar(82.5) * t9 + t30;
  const Scalar U_15_zy = t14 + t15;
  const Scalar t194 = Scalar(60.0) * U_15_zy;
  const Scalar t195 = t193 - t194;
  const Scalar t196 = Scalar(82.5) * Uz_o_16_x - t38;
  const Scalar t197 = domega_15_z - t11;
  const Scalar t198 = Scalar(60.0) * t197;
  const Scalar t199 = t196 - t198;
  const Scalar t200 = s_26 * t195 + c_26 * t199;
  const Scalar t201 = s_26 * omega_15_z - c_26 * t6;
  const Scalar omega_26_z = qd_26 + omega_r_15_y;
  const Scalar t202 = t201 * omega_26_z;
  const Scalar t203 = t202 - s_26 * U_15_zy - c_26 * t197;
  const Scalar domega_27_z = qdd_27 - t203;
  const Scalar omega_r_27_x = s_27 * t201 + c_27 * omega_26_z;
  const Scalar t204 = s_27 * omega_26_z - c_27 * t201;
  const Scalar t205 = omega_r_27_x * t204;
  const Scalar t206 = t205 + domega_27_z;
  const Scalar t207 = Scalar(82.5) * U_15_yx - t32;
  const Scalar t208 = t35 + t36;
  const Scalar t209 = Scalar(60.0) * t208;
  const Scalar t210 = t209 + t207;
  const Scalar ddp_o_28_x = Scalar(76.25) * t206 - s_27 * t200 - c_27 * t210;
  const Scalar t211 = s_26 * t199 - c_26 * t195;
  const Scalar omega_r_27_a_z = s_26 * t6 + c_26 * omega_15_z;
  const Scalar t212 = s_26 * t197 - c_26 * U_15_zy + Scalar(2.0) * omega_r_27_a_z * omega_26_z;
  const Scalar domega_26_z = qdd_26 - t8;
  const Scalar t213 = t201 * omega_r_27_a_z;
  const Scalar Uz_o_27_x = domega_26_z - t213;
  const Scalar omega_27_z = qd_27 + omega_r_27_a_z;
  const Scalar t214 = Scalar(2.0) * t204 * omega_27_z - c_27 * Uz_o_27_x - s_27 * t212;
  const Scalar t215 = t211 + Scalar(76.25) * t214;
  const Scalar t216 = s_28 * ddp_o_28_x + c_28 * t215;
  const Scalar omega_r_28_x = s_28 * omega_r_27_x + c_28 * omega_27_z;
  const Scalar t217 = omega_r_28_x * omega_r_28_x;
  const Scalar t218 = omega_r_27_x * omega_r_27_x + omega_27_z * omega_27_z;
  const Scalar omega_28_z = qd_28 - t204;
  const Scalar t219 = omega_28_z * omega_28_z;
  const Scalar t220 = t218 - t217 + t219;
  const Scalar t221 = t220 - t216;
  const Scalar t222 = omega_r_28_x * omega_28_z;
  const Scalar t223 = t222 + s_28 * t206 + c_28 * t214;
  const Scalar U_28_zx = t222 + t223;
  const Scalar ddp_o_28_y = Scalar(76.25) * t218 + s_27 * t210 - c_27 * t200;
  const Scalar ddp_o_29_z = U_28_zx + ddp_o_28_y;
  const Scalar t224 = s_29 * ddp_o_29_z + c_29 * t221;
  const Scalar domega_29_z = qdd_29 - t223;
  const Scalar t225 = s_29 * omega_28_z - c_29 * omega_r_28_x;
  const Scalar omega_r_30_a_z = s_29 * omega_r_28_x + c_29 * omega_28_z;
  const Scalar t226 = t225 * omega_r_30_a_z;
  const Scalar Uz_o_30_x = domega_29_z - t226;
  const Scalar t227 = t225 * t225;
  const Scalar t228 = s_28 * omega_27_z - c_28 * omega_r_27_x;
  const Scalar omega_29_z = qd_29 - t228;
  const Scalar t229 = omega_29_z * omega_29_z;
  const Scalar t230 = t217 + t219 + t229 - t227;
  const Scalar ddp_o_30_x = t230 - Scalar(59.75) * Uz_o_30_x - t224;
  const Scalar t231 = s_28 * t214 - c_28 * t206;
  const Scalar t232 = t231 + Scalar(2.0) * t228 * omega_28_z;
  const Scalar t233 = omega_r_27_x * omega_27_z;
  const Scalar t234 = t233 + s_27 * Uz_o_27_x - c_27 * t212;
  const Scalar domega_28_z = qdd_28 - t234;
  const Scalar t235 = omega_r_28_x * t228;
  const Scalar t236 = t235 + domega_28_z;
  const Scalar t237 = t225 * omega_29_z;
  const Scalar t238 = t237 - c_29 * t236 + s_29 * t232;
  const Scalar t239 = t237 + t238;
  const Scalar t240 = s_29 * t236 + Scalar(2.0) * omega_r_30_a_z * omega_29_z + c_29 * t232;
  const Scalar t241 = s_28 * t215 - c_28 * ddp_o_28_x;
  const Scalar U_28_yx = domega_28_z - t235;
  const Scalar ddp_o_29_y = U_28_yx - t241;
  const Scalar t242 = t239 - Scalar(59.75) * t240 + ddp_o_29_y;
  const Scalar t243 = s_30 * ddp_o_30_x - c_30 * t242;
  const Scalar t244 = s_29 * t221 - c_29 * ddp_o_29_z;
  const Scalar U_29_yx = t226 + domega_29_z;
  const Scalar Uz_o_30_y = t229 + t227;
  const Scalar ddp_30_a_z = U_29_yx + Scalar(59.75) * Uz_o_30_y - t244;
  const Scalar ddp_31_y = s_31 * t243 + c_31 * ddp_30_a_z;
  const Scalar domega_30_z = qdd_30 - t238;
  const Scalar omega_r_30_x = s_30 * t225 + c_30 * omega_29_z;
  const Scalar omega_r_31_a_z = s_30 * omega_29_z - c_30 * t225;
  const Scalar t245 = omega_r_30_x * omega_r_31_a_z;
  const Scalar Uz_o_31_x = t245 + domega_30_z;
  const Scalar omega_30_z = qd_30 + omega_r_30_a_z;
  const Scalar t246 = Scalar(2.0) * omega_r_31_a_z * omega_30_z - c_30 * Uz_o_30_x - s_30 * t240;
  const Scalar t247 = s_31 * omega_r_30_x - c_31 * omega_30_z;
  const Scalar omega_31_z = qd_31 + omega_r_31_a_z;
  const Scalar t248 = Scalar(2.0) * omega_31_z;
  const Scalar t249 = t247 * t248 - s_31 * Uz_o_31_x + c_31 * t246;
  const Scalar omega_32_z = qd_32 - t247;
  const Scalar t250 = t248 * omega_32_z + t249;
  const Scalar t251 = s_32 * t250;
  const Scalar t252 = omega_32_z * omega_32_z;
  const Scalar t253 = omega_31_z * omega_31_z;
  const Scalar t254 = t253 + t252;
  const Scalar omega_r_31_x = s_31 * omega_30_z + c_31 * omega_r_30_x;
  const Scalar t255 = omega_r_31_x * omega_r_31_x;
  const Scalar t256 = t253 + t255;
  const Scalar t257 = Scalar(0.0000376) * c_32;
  const Scalar t258 = t257 * (Scalar(13.553191489361701) *
      (Scalar(1.468210361067504) * (t256 - t254) - t251) + ddp_31_y);
  const Scalar t259 = s_31 * ddp_30_a_z - c_31 * t243;
  const Scalar t260 = omega_r_31_x * omega_31_z;
  const Scalar t261 = t260 - s_31 * t246 - c_31 * Uz_o_31_x;
  const Scalar domega_32_z = qdd_32 - t261;
  const Scalar t262 = t260 + domega_32_z;
  const Scalar t263 = Scalar(0.0007482) * s_32;
  const Scalar t264 = omega_r_30_x * omega_30_z;
  const Scalar t265 = t264 + s_30 * Uz_o_30_x - c_30 * t240;
  const Scalar domega_31_z = qdd_31 + t265;
  const Scalar t266 = omega_r_31_x * t247;
  const Scalar t267 = t266 + domega_31_z;
  const Scalar U_32_zx = t267 + Scalar(2.0) * omega_r_31_x * omega_32_z;
  const Scalar t268 = Scalar(0.0005096) * s_32 * s_32;
  const Scalar I_32_yy = t268 + Scalar(0.0004516500000001);
  const Scalar U_31_yx = domega_31_z - t266;
  const Scalar mu_31_z = Scalar(0.00016) * U_31_yx + U_32_zx * I_32_yy + t262 * t263 - t258 +
      Scalar(0.0247118500000001) * t267 + Scalar(0.0007608) * t259;
  tau[30] = mu_31_z;
  const Scalar ddp_19_a_y = t194 + t193;
  const Scalar t269 = t198 + t196;
  const Scalar ddp_19_x = s_19 * ddp_19_a_y + c_19 * t269;
  const Scalar t270 = s_19 * omega_15_z - c_19 * t6;
  const Scalar omega_19_z = qd_19 + omega_r_15_y;
  const Scalar t271 = t270 * omega_19_z;
  const Scalar t272 = t271 - s_19 * U_15_zy - c_19 * t197;
  const Scalar domega_20_z = qdd_20 - t272;
  const Scalar omega_r_20_x = s_20 * t270 + c_20 * omega_19_z;
  const Scalar t273 = s_20 * omega_19_z - c_20 * t270;
  const Scalar t274 = omega_r_20_x * t273;
  const Scalar t275 = t274 + domega_20_z;
  const Scalar t276 = t207 - t209;
  const Scalar ddp_o_21_x = Scalar(76.25) * t275 - s_20 * ddp_19_x - c_20 * t276;
  const Scalar t277 = s_19 * t269 - c_19 * ddp_19_a_y;
  const Scalar omega_r_20_a_z = s_19 * t6 + c_19 * omega_15_z;
  const Scalar t278 = s_19 * t197 - c_19 * U_15_zy + Scalar(2.0) * omega_r_20_a_z * omega_19_z;
  const Scalar domega_19_z = qdd_19 - t8;
  const Scalar t279 = t270 * omega_r_20_a_z;
  const Scalar Uz_o_20_x = domega_19_z - t279;
  const Scalar omega_20_z = qd_20 + omega_r_20_a_z;
  const Scalar t280 = Scalar(2.0) * t273 * omega_20_z - c_20 * Uz_o_20_x - s_20 * t278;
  const Scalar t281 = t277 + Scalar(76.25) * t280;
  const Scalar t282 = s_21 * ddp_o_21_x + c_21 * t281;
  const Scalar omega_r_21_x = s_21 * omega_r_20_x + c_21 * omega_20_z;
  const Scalar t283 = omega_r_21_x * omega_r_21_x;
  const Scalar t284 = omega_r_20_x * omega_r_20_x + omega_20_z * omega_20_z;
  const Scalar omega_21_z = qd_21 - t273;
  const Scalar t285 = omega_21_z * omega_21_z;
  const Scalar t286 = t284 - t283 + t285;
  const Scalar t287 = t286 - t282;
  const Scalar t288 = omega_r_21_x * omega_21_z;
  const Scalar t289 = t288 + s_21 * t275 + c_21 * t280;
  const Scalar U_21_zx = t288 + t289;
  const Scalar ddp_o_21_y = Scalar(76.25) * t284 + s_20 * t276 - c_20 * ddp_19_x;
  const Scalar ddp_o_22_z = U_21_zx + ddp_o_21_y;
  const Scalar t290 = s_22 * ddp_o_22_z + c_22 * t287;
  const Scalar domega_22_z = qdd_22 - t289;
  const Scalar t291 = s_22 * omega_21_z - c_22 * omega_r_21_x;
  const Scalar omega_r_23_a_z = s_22 * omega_r_21_x + c_22 * omega_21_z;
  const Scalar t292 = t291 * omega_r_23_a_z;
  const Scalar Uz_o_23_x = domega_22_z - t292;
  const Scalar t293 = t291 * t291;
  const Scalar t294 = s_21 * omega_20_z - c_21 * omega_r_20_x;
  const Scalar omega_22_z = qd_22 - t294;
  const Scalar t295 = omega_22_z * omega_22_z;
  const Scalar t296 = t283 + t285 + t295 - t293;
  const Scalar ddp_o_23_x = t296 - Scalar(59.75) * Uz_o_23_x - t290;
  const Scalar t297 = s_21 * t280 - c_21 * t275;
  const Scalar t298 = t297 + Scalar(2.0) * t294 * omega_21_z;
  const Scalar t299 = omega_r_20_x * omega_20_z;
  const Scalar t300 = t299 + s_20 * Uz_o_20_x - c_20 * t278;
  const Scalar domega_21_z = qdd_21 - t300;
  const Scalar t301 = omega_r_21_x * t294;
  const Scalar t302 = t301 + domega_21_z;
  const Scalar t303 = t291 * omega_22_z;
  const Scalar t304 = t303 - c_22 * t302 + s_22 * t298;
  const Scalar t305 = t303 + t304;
  const Scalar t306 = s_22 * t302 + Scalar(2.0) * omega_r_23_a_z * omega_22_z + c_22 * t298;
  const Scalar t307 = s_21 * t281 - c_21 * ddp_o_21_x;
  const Scalar U_21_yx = domega_21_z - t301;
  const Scalar ddp_o_22_y = U_21_yx - t307;
  const Scalar t308 = t305 - Scalar(59.75) * t306 + ddp_o_22_y;
  const Scalar t309 = s_23 * ddp_o_23_x - c_23 * t308;
  const Scalar t310 = s_22 * t287 - c_22 * ddp_o_22_z;
  const Scalar U_22_yx = t292 + domega_22_z;
  const Scalar Uz_o_23_y = t295 + t293;
  const Scalar ddp_23_a_z = U_22_yx + Scalar(59.75) * Uz_o_23_y - t310;
  const Scalar ddp_24_y = s_24 * t309 + c_24 * ddp_23_a_z;
  const Scalar domega_23_z = qdd_23 - t304;
  const Scalar omega_r_23_x = s_23 * t291 + c_23 * omega_22_z;
  const Scalar omega_r_24_a_z = s_23 * omega_22_z - c_23 * t291;
  const Scalar t311 = omega_r_23_x * omega_r_24_a_z;
  const Scalar Uz_o_24_x = t311 + domega_23_z;
  const Scalar omega_23_z = qd_23 + omega_r_23_a_z;
  const Scalar t312 = Scalar(2.0) * omega_r_24_a_z * omega_23_z - c_23 * Uz_o_23_x - s_23 * t306;
  const Scalar t313 = s_24 * omega_r_23_x - c_24 * omega_23_z;
  const Scalar omega_24_z = qd_24 + omega_r_24_a_z;
  const Scalar t314 = Scalar(2.0) * omega_24_z;
  const Scalar t315 = t313 * t314 - s_24 * Uz_o_24_x + c_24 * t312;
  const Scalar omega_25_z = qd_25 - t313;
  const Scalar t316 = t314 * omega_25_z + t315;
  const Scalar t317 = s_25 * t316;
  const Scalar t318 = omega_25_z * omega_25_z;
  const Scalar t319 = omega_24_z * omega_24_z;
  const Scalar t320 = t319 + t318;
  const Scalar omega_r_24_x = s_24 * omega_23_z + c_24 * omega_r_23_x;
  const Scalar t321 = omega_r_24_x * omega_r_24_x;
  const Scalar t322 = t319 + t321;
  const Scalar t323 = Scalar(0.0000376) * c_25;
  const Scalar t324 = t323 * (Scalar(13.553191489361701) *
      (Scalar(1.468210361067504) * (t322 - t320) + t317) + ddp_24_y);
  const Scalar t325 = s_24 * ddp_23_a_z - c_24 * t309;
  const Scalar t326 = omega_r_24_x * omega_24_z;
  const Scalar t327 = t326 - s_24 * t312 - c_24 * Uz_o_24_x;
  const Scalar domega_25_z = qdd_25 - t327;
  const Scalar t328 = t326 + domega_25_z;
  const Scalar t329 = Scalar(0.0007482) * s_25;
  const Scalar t330 = omega_r_23_x * omega_23_z;
  const Scalar t331 = t330 + s_23 * Uz_o_23_x - c_23 * t306;
  const Scalar domega_24_z = qdd_24 + t331;
  const Scalar t332 = omega_r_24_x * t313;
  const Scalar t333 = t332 + domega_24_z;
  const Scalar U_25_zx = t333 + Scalar(2.0) * omega_r_24_x * omega_25_z;
  const Scalar t334 = Scalar(0.0005096) * s_25 * s_25;
  const Scalar I_25_yy = t334 + Scalar(0.0004516500000001);
  const Scalar U_24_yx = domega_24_z - t332;
  const Scalar mu_24_z = Scalar(0.00016) * U_24_yx + U_25_zx * I_25_yy - t328 * t329 + t324 +
      Scalar(0.0247118500000001) * t333 + Scalar(0.0007608) * t325;
  tau[23] = mu_24_z;
  const Scalar t335 = (t333 + Scalar(0.05025394279604384) * t325) * t329;
  const Scalar t336 = t326 - domega_25_z;
  const Scalar t337 = t334 - Scalar(0.0009612500000001);
  const Scalar ddp_24_a_z = s_23 * t308 + c_23 * ddp_o_23_x;
  const Scalar t338 = t321 + t318;
  const Scalar t339 = (Scalar(19.898936170212767) *
      (Scalar(0.6811013098102112) * s_25 * (t320 - t338) + t315) + ddp_24_a_z) * t323;
  const Scalar t340 = t336 * I_25_yy + t328 * t337 + t335 + t339;
  tau[24] = -t340;
  const Scalar t341 = (t267 + Scalar(0.05025394279604384) * t259) * t263;
  const Scalar t342 = t260 - domega_32_z;
  const Scalar t343 = t268 - Scalar(0.0009612500000001);
  const Scalar ddp_31_a_z = s_30 * t242 + c_30 * ddp_o_30_x;
  const Scalar t344 = t255 + t252;
  const Scalar t345 = (Scalar(19.898936170212767) *
      (t249 - Scalar(0.6811013098102112) * s_32 * (t254 - t344)) + ddp_31_a_z) * t257;
  const Scalar t346 = t342 * I_32_yy + t262 * t343 - t341 - t345;
  tau[31] = -t346;
  const Scalar U_31_zx = t260 + t261;
  const Scalar t347 = Scalar(0.00016) * U_31_zx + t346;
  const Scalar t348 = c_32 * U_32_zx;
  const Scalar U_32_yy_zz = t256 - t344;
  const Scalar t349 = s_32 * (Scalar(13.553191489361701) *
      (t348 + Scalar(1.468210361067504) * U_32_yy_zz) + ddp_31_y);
  const Scalar t350 = c_32 * t342;
  const Scalar t351 = Scalar(0.0000376) * t349 - Scalar(0.0007482) * t350 - t250 * t343 +
      Scalar(0.0247118500000001) * t249 + Scalar(0.0007608) * ddp_31_a_z;
  const Scalar U_30_yx = domega_30_z - t245;
  const Scalar mu_30_z = Scalar(0.00048) * Uz_o_31_x + Scalar(0.00032) * U_30_yx - c_31 * t347 -
      s_31 * t351;
  tau[29] = mu_30_z;
  const Scalar U_24_zx = t326 + t327;
  const Scalar t352 = Scalar(0.00016) * U_24_zx + t340;
  const Scalar t353 = c_25 * U_25_zx;
  const Scalar U_25_yy_zz = t322 - t338;
  const Scalar t354 = s_25 * (Scalar(13.553191489361701) *
      (Scalar(1.468210361067504) * U_25_yy_zz - t353) + ddp_24_y);
  const Scalar t355 = c_25 * t336;
  const Scalar t356 = Scalar(0.0007482) * t355 - t316 * t337 - Scalar(0.0000376) * t354 +
      Scalar(0.0247118500000001) * t315 + Scalar(0.0007608) * ddp_24_a_z;
  const Scalar U_23_yx = domega_23_z - t311;
  const Scalar mu_23_z = Scalar(0.00048) * Uz_o_24_x + Scalar(0.00032) * U_23_yx - c_24 * t352 -
      s_24 * t356;
  tau[22] = mu_23_z;
  const Scalar t357 = Scalar(0.00048) * t246 - s_31 * t347 + c_31 * t351;
  const Scalar f_31_x = Scalar(0.0000376) * (c_32 * t254 + s_32 * t262) + Scalar(0.0007608) * t267;
  const Scalar f_31_y = Scalar(0.0000376) * (t251 - t348) + Scalar(0.0007608) * t256;
  const Scalar t358 = s_31 * f_31_y - c_31 * f_31_x + Scalar(0.0001312) * t243;
  const Scalar t359 = Scalar(0.0007608) * t249 - Scalar(0.0000376) * (s_32 * t344 + t350) +
      Scalar(0.0001312) * ddp_31_a_z;
  const Scalar f_u_30_t_x = s_30 * t358 + c_30 * t359;
  const Scalar U_30_zx = t264 + t265;
  const Scalar t360 = Scalar(0.00032) * U_30_zx + mu_31_z;
  const Scalar f_30_z = c_31 * f_31_y + s_31 * f_31_x + Scalar(0.0001312) * ddp_30_a_z;
  const Scalar t361 = Scalar(-0.00167) * U_29_yx - Scalar(0.00278) * (t230 - Uz_o_30_y) - f_30_z +
      c_30 * t357 - s_30 * t360 + Scalar(0.26596) * Uz_o_30_x + Scalar(0.00438) * t224 +
      Scalar(59.75) * f_u_30_t_x;
  tau[28] = -t361;
  const Scalar t362 = Scalar(0.00048) * t312 - s_24 * t352 + c_24 * t356;
  const Scalar f_24_x = Scalar(0.0007608) * t333 - Scalar(0.0000376) * (c_25 * t320 + s_25 * t328);
  const Scalar f_24_y = Scalar(0.0007608) * t322 - Scalar(0.0000376) * (t317 - t353);
  const Scalar t363 = s_24 * f_24_y - c_24 * f_24_x + Scalar(0.0001312) * t309;
  const Scalar t364 = Scalar(0.0000376) * (s_25 * t338 + t355) + Scalar(0.0007608) * t315 +
      Scalar(0.0001312) * ddp_24_a_z;
  const Scalar f_u_23_t_x = s_23 * t363 + c_23 * t364;
  const Scalar U_23_zx = t330 + t331;
  const Scalar t365 = Scalar(0.00032) * U_23_zx + mu_24_z;
  const Scalar f_23_z = c_24 * f_24_y + s_24 * f_24_x + Scalar(0.0001312) * ddp_23_a_z;
  const Scalar t366 = Scalar(-0.00167) * U_22_yx - Scalar(0.00278) * (t296 - Uz_o_23_y) - f_23_z +
      c_23 * t362 - s_23 * t365 + Scalar(0.26596) * Uz_o_23_x + Scalar(0.00438) * t290 +
      Scalar(59.75) * f_u_23_t_x;
  tau[21] = -t366;
  const Scalar t367 = s_30 * t359 - c_30 * t358;
  const Scalar t368 = Scalar(0.00278) * t239 - s_30 * t357 - c_30 * t360 - Scalar(0.26596) * t240 +
      Scalar(0.00438) * ddp_o_29_y - Scalar(59.75) * t367;
  const Scalar t369 = Scalar(0.00167) * t239 + Scalar(0.00278) * t240 + t367 - mu_30_z;
  const Scalar t370 = Scalar(0.00438) * t240 - Scalar(0.000144) * ddp_o_29_y + t367;
  const Scalar t371 = Scalar(0.0023) * t231 - Scalar(0.00405) * t236 - Scalar(0.00393) * U_28_yx -
      t370 + c_29 * t369 - s_29 * t368;
  tau[27] = -t371;
  const Scalar t372 = s_23 * t364 - c_23 * t363;
  const Scalar t373 = Scalar(0.00278) * t305 - s_23 * t362 - c_23 * t365 - Scalar(0.26596) * t306 +
      Scalar(0.00438) * ddp_o_22_y - Scalar(59.75) * t372;
  const Scalar t374 = Scalar(0.00167) * t305 + Scalar(0.00278) * t306 + t372 - mu_23_z;
  const Scalar t375 = Scalar(0.00438) * t306 - Scalar(0.000144) * ddp_o_22_y + t372;
  const Scalar t376 = Scalar(0.0023) * t297 - Scalar(0.00405) * t302 - Scalar(0.00393) * U_21_yx -
      t375 + c_22 * t374 - s_22 * t373;
  tau[20] = -t376;
  const Scalar f_29_x = Scalar(0.00438) * Uz_o_30_x + Scalar(0.000144) * t224 + f_u_30_t_x;
  const Scalar f_29_y = Scalar(0.00438) * Uz_o_30_y - Scalar(0.000144) * t244 - f_30_z;
  const Scalar t377 = Scalar(0.0000999344262295082) * t216 - s_29 * f_29_y + c_29 * f_29_x;
  const Scalar t378 = Scalar(0.0000999344262295082) * t241 - t370;
  const Scalar f_u_28_t_x = s_28 * t377 - c_28 * t378;
  const Scalar f_u_29_t_y = c_29 * f_29_y + s_29 * f_29_x;
  const Scalar t379 = Scalar(0.0023) * (t218 - t220) + Scalar(0.00393) * U_28_zx - f_u_29_t_y +
      t361;
  const Scalar mu_28_x = Scalar(0.0023) * U_28_yx - Scalar(0.00405) * t232 - s_29 * t369 -
      c_29 * t368;
  const Scalar U_27_yx = domega_27_z - t205;
  const Scalar mu_u_27_a_y = Scalar(0.03177) * t206 - Scalar(0.00098) * U_27_yx - s_28 * t379 -
      c_28 * mu_28_x - Scalar(76.25) * f_u_28_t_x;
  tau[26] = -mu_u_27_a_y;
  const Scalar f_22_x = Scalar(0.00438) * Uz_o_23_x + Scalar(0.000144) * t290 + f_u_23_t_x;
  const Scalar f_22_y = Scalar(0.00438) * Uz_o_23_y - Scalar(0.000144) * t310 - f_23_z;
  const Scalar t380 = Scalar(0.0000999344262295082) * t282 - s_22 * f_22_y + c_22 * f_22_x;
  const Scalar t381 = Scalar(0.0000999344262295082) * t307 - t375;
  const Scalar f_u_21_t_x = s_21 * t380 - c_21 * t381;
  const Scalar f_u_22_t_y = c_22 * f_22_y + s_22 * f_22_x;
  const Scalar t382 = Scalar(0.0023) * (t284 - t286) + Scalar(0.00393) * U_21_zx - f_u_22_t_y +
      t366;
  const Scalar mu_21_x = Scalar(0.0023) * U_21_yx - Scalar(0.00405) * t298 - s_22 * t374 -
      c_22 * t373;
  const Scalar U_20_yx = domega_20_z - t274;
  const Scalar mu_u_20_a_y = Scalar(0.03177) * t275 - Scalar(0.00098) * U_20_yx - s_21 * t382 -
      c_21 * mu_21_x - Scalar(76.25) * f_u_21_t_x;
  tau[19] = -mu_u_20_a_y;
  const Scalar t383 = s_28 * t378 + c_28 * t377;
  const Scalar t384 = Scalar(0.03177) * t214 + s_28 * mu_28_x - c_28 * t379 - Scalar(76.25) * t383;
  const Scalar U_27_zx = t233 + t234;
  const Scalar t385 = Scalar(0.00098) * U_27_zx + t371;
  const Scalar U_26_yx = t213 + domega_26_z;
  const Scalar mu_26_z = Scalar(0.00098) * U_26_yx + Scalar(0.00196) * Uz_o_27_x + s_27 * t385 +
      c_27 * t384;
  tau[25] = mu_26_z;
  const Scalar t386 = s_21 * t381 + c_21 * t380;
  const Scalar t387 = Scalar(0.03177) * t280 + s_21 * mu_21_x - c_21 * t382 - Scalar(76.25) * t386;
  const Scalar U_20_zx = t299 + t300;
  const Scalar t388 = Scalar(0.00098) * U_20_zx + t376;
  const Scalar U_19_yx = t279 + domega_19_z;
  const Scalar mu_19_z = Scalar(0.00098) * U_19_yx + Scalar(0.00196) * Uz_o_20_x + s_20 * t388 +
      c_20 * t387;
  tau[18] = mu_19_z;
  const Scalar f_28_z = Scalar(0.0000999344262295082) * ddp_o_28_y - f_u_29_t_y;
  const Scalar t389 = Scalar(0.00016042921013412816) * t200 - s_27 * f_u_28_t_x - c_27 * f_28_z;
  const Scalar t390 = Scalar(0.00016042921013412816) * t211 + t383;
  const Scalar f_21_z = Scalar(0.0000999344262295082) * ddp_o_21_y - f_u_22_t_y;
  const Scalar f_19_x = Scalar(0.000044065573770491804) * ddp_19_x - s_20 * f_u_21_t_x -
      c_20 * f_21_z;
  const Scalar t391 = Scalar(0.000044065573770491804) * t277 + t386;
  const Scalar t392 = (s_26 * t390 + c_26 * t389) - (s_19 * t391 + c_19 * f_19_x);
  const Scalar t393 = Scalar(0.00196) * t278 - c_20 * t388 + s_20 * t387;
  const Scalar t394 = Scalar(0.00196) * t212 - c_27 * t385 + s_27 * t384;
  const Scalar t395 = Scalar(0.00016042921013412816) * t210 + s_27 * f_28_z - c_27 * f_u_28_t_x;
  const Scalar t396 = t395 + (Scalar(0.000044065573770491804) * t276 + s_20 * f_21_z -
      c_20 * f_u_21_t_x);
  const Scalar mu_19_y = Scalar(0.00098) * (t271 + t272) + mu_u_20_a_y;
  const Scalar mu_26_y = Scalar(0.00098) * (t202 + t203) + mu_u_27_a_y;
  const Scalar t397 = t156 * U_18_xy - t41 * t159;
  const Scalar t398 = t41 * t27 + t156 * t20;
  const Scalar t399 = s_17 * t397 + c_17 * t398 + Scalar(0.00004711699779249448) * t34;
  const Scalar t400 = t41 * U_18_yx - t156 * t160 + Scalar(0.00004711699779249448) * t161;
  const Scalar t401 = s_16 * t400 - c_16 * t399;
  const Scalar t402 = Scalar(0.0005625) * t12 - s_17 * t172 - c_17 * mu_17_y;
  const Scalar t403 = Scalar(0.0003125) * (t22 + t23) - mu_17_z;
  const Scalar mu_15_z = Scalar(0.048) * t13 + s_16 * t402 - c_16 * t403 -
      Scalar(0.164908333333833) * U_15_yx - Scalar(0.3206157575755909) * t197 -
      Scalar(17.12290909090909) * t37 + Scalar(0.576) * (Uz_o_16_x - t208) - Scalar(113.25) * t401 +
      s_19 * t393 - c_19 * mu_19_y + s_26 * t394 - c_26 * mu_26_y - Scalar(60.0) * t392 +
      Scalar(82.5) * t396;
  tau[14] = mu_15_z;
  const Scalar t404 = s_26 * t389 - c_26 * t390;
  const Scalar f_u_19_t_y = s_19 * f_19_x - c_19 * t391;
  const Scalar mu_15_x = Scalar(0.75) * t401 + Scalar(0.048) * U_15_yx - mu_16_z -
      Scalar(0.3206157575755909) * U_15_zy + Scalar(0.006981818181818182) * t193 - s_19 * mu_19_y -
      c_19 * t393 - s_26 * mu_26_y - c_26 * t394 - Scalar(60.0) * (t404 - f_u_19_t_y);
  const Scalar t405 = s_16 * t399 + c_16 * t400;
  const Scalar t406 = s_17 * t398 - c_17 * t397 + Scalar(0.00004711699779249448) * t39;
  const Scalar t407 = Scalar(-0.75) * t406 - Scalar(0.048) * (Uz_o_15_y - Uz_o_16_x) - s_16 * t403 -
      c_16 * t402 + Scalar(0.164908333333833) * t9 - Scalar(0.576) * U_15_zy +
      Scalar(113.25) * t405 + mu_26_z + mu_19_z - Scalar(82.5) * (t404 + f_u_19_t_y);
  const Scalar U_14_yx = qdd_14 - t4;
  const Scalar t408 = Scalar(-0.001225) * U_14_yx - Scalar(0.04553383002224172) * Uz_o_15_x +
      Scalar(1.9603758278145695) * c_14 - s_15 * mu_15_x - c_15 * t407;
  tau[13] = -t408;
  const Scalar t409 = c_14 * (Scalar(0.04553383002224172) * t2 - s_15 * t407 + c_15 * mu_15_x);
  const Scalar mu_14_y = Scalar(0.001225) * (t10 + domega_14_y) - mu_15_z;
  tau[12] = Scalar(0.004425) * qdd_13 + s_14 * mu_14_y - t409;
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
// Reads q[1..5], q[7..11], q[13..31]. Operations: 965 mul, 726 add, 58 sin/cos. Always zero: 740 of
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
  const Scalar hu_6_a_z = Scalar(0.00018) * c_6 - Scalar(0.00042) * s_6;
  const Scalar t12 = Scalar(10.0) * hu_6_a_z + Scalar(0.01431666666667);
  const Scalar hu_6_t_x = Scalar(0.00018) * s_6 + Scalar(0.00042) * c_6;
  const Scalar t13 = Scalar(89.25) * hu_6_t_x;
  const Scalar mu_6_4_z = c_5 * t12 + t13;
  B[101] = B[163] = mu_6_4_z;
  const Scalar hu_12_a_z = Scalar(0.00018) * c_12 - Scalar(0.00042) * s_12;
  const Scalar t14 = Scalar(10.0) * hu_12_a_z + Scalar(0.01431666666667);
  const Scalar hu_12_t_x = Scalar(0.00018) * s_12 + Scalar(0.00042) * c_12;
  const Scalar t15 = Scalar(89.25) * hu_12_t_x;
  const Scalar mu_12_10_z = c_11 * t14 + t15;
  B[299] = B[361] = mu_12_10_z;
  const Scalar Iu_18_a_yz = c_18 * Iu_18_t_g - Scalar(0.0022);
  B[496] = B[527] = -c_17 * Iu_18_a_yz;
  const Scalar t16 = Scalar(10.0) * hu_6_t_x + c_6 * t7 - Scalar(0.00315);
  B[100] = B[131] = -s_5 * t16;
  const Scalar t17 = Scalar(89.25) * hu_6_a_z;
  const Scalar B_3_6 = s_5 * (c_4 * t12 - t17 * (Scalar(0.056022408963585436) + s_4));
  B[69] = B[162] = B_3_6;
  const Scalar t18 = Scalar(10.0) * hu_12_t_x + c_12 * t5 - Scalar(0.00315);
  B[298] = B[329] = -s_11 * t18;
  const Scalar t19 = Scalar(89.25) * hu_12_a_z;
  const Scalar B_9_12 = s_11 * (c_10 * t14 - t19 * (Scalar(0.056022408963585436) + s_10));
  B[267] = B[360] = B_9_12;
  const Scalar f_u_18_18_a_z = Scalar(0.00088) * c_18 - Scalar(0.00008) * s_18;
  const Scalar hu_18_a_z = Scalar(0.00008) * c_18 + Scalar(0.00088) * s_18;
  const Scalar t20 = c_16 * s_17;
  const Scalar f_u_18_16_t_x = s_16 * f_u_18_18_a_z + hu_18_a_z * t20;
  const Scalar t21 = Scalar(0.03408) * c_17;
  const Scalar mu_u_18_15_a_y = s_16 * t21 + Scalar(113.25) * f_u_18_16_t_x;
  B[465] = B[558] = -mu_u_18_15_a_y;
  const Scalar t22 = Scalar(0.0000376) * s_32;
  const Scalar t23 = s_30 * t22;
  const Scalar t24 = Scalar(0.0000376) * c_32;
  const Scalar t25 = c_31 * t23 - c_30 * t24;
  const Scalar t26 = c_31 * c_32;
  const Scalar t27 = Scalar(0.0007482) * t26 + Scalar(0.0014129000000002) * s_31;
  const Scalar t28 = s_31 * t22;
  const Scalar mu_32_29_z = t28 + s_30 * Iu_32_a_xy - c_30 * t27 + Scalar(59.75) * t25;
  B[927] = B[1020] = mu_32_29_z;
  const Scalar Iu_18_t_xx = t11 - Scalar(0.024);
  const Scalar Iu_17_t_d = Iu_18_t_xx - Scalar(0.0002);
  const Scalar t29 = s_17 * s_17 * Iu_17_t_d;
  const Scalar Ic_16_zz = Iu_18_t_xx - t29 + Scalar(0.035005);
  B[495] = Ic_16_zz;
  const Scalar t30 = Scalar(0.0000376) * c_25;
  const Scalar hu_23_a_y = Scalar(0.0007608) * c_24 - s_24 * t30;
  const Scalar t31 = Ic_24_zz + Scalar(59.75) * hu_23_a_y;
  const Scalar t32 = c_24 * c_25;
  const Scalar t33 = s_24 - Scalar(0.6811013098102112) * t32;
  const Scalar t34 = t9 * t33;
  const Scalar hu_24_t_x = c_24 * t30 + Scalar(0.0007608) * s_24;
  const Scalar mu_24_22_z = c_23 * t34 + hu_24_t_x + s_23 * t31;
  B[695] = B[757] = mu_24_22_z;
  const Scalar t35 = Scalar(0.0000376) * s_25;
  const Scalar t36 = s_23 * t35;
  const Scalar t37 = c_24 * t36 - c_23 * t30;
  const Scalar t38 = Scalar(0.0014129000000002) * s_24 - Scalar(0.0007482) * t32;
  const Scalar t39 = s_24 * t35;
  const Scalar t40 = t39 + s_23 * t9 + c_23 * t38 + Scalar(59.75) * t37;
  B[696] = B[789] = -t40;
  const Scalar hu_30_a_y = s_31 * t24 + Scalar(0.0007608) * c_31;
  const Scalar t41 = Ic_31_zz + Scalar(59.75) * hu_30_a_y;
  const Scalar t42 = Scalar(0.6811013098102112) * t26 + s_31;
  const Scalar t43 = Iu_32_a_xy * t42;
  const Scalar hu_31_t_x = Scalar(0.0007608) * s_31 - c_31 * t24;
  const Scalar mu_31_29_z = hu_31_t_x - c_30 * t43 + s_30 * t41;
  B[926] = B[988] = mu_31_29_z;
  const Scalar t44 = c_17 * f_u_18_18_a_z;
  const Scalar t45 = mu_u_17_17_a_y - Scalar(113.25) * t44;
  const Scalar t46 = s_16 * s_17;
  const Scalar t47 = Iu_18_a_yz * t46;
  const Scalar t48 = t47 + c_16 * t45;
  B[464] = B[526] = -t48;
  const Scalar t49 = mu_u_18_17_t_y - Scalar(0.75) * f_u_18_16_t_x;
  const Scalar t50 = hu_18_a_z * t46 - c_16 * f_u_18_18_a_z;
  const Scalar t51 = Scalar(113.25) * t50 - (c_16 - Scalar(22.007042253521128) * hu_18_a_z) * t21;
  B[433] = B[557] = -s_15 * t49 - c_15 * t51;
  const Scalar t52 = c_30 * t22;
  const Scalar f_u_32_30_t_y = c_31 * t52 + s_30 * t24;
  const Scalar mu_32_29_x = c_30 * Iu_32_a_xy + s_30 * t27 + Scalar(59.75) * f_u_32_30_t_y;
  const Scalar t53 = mu_u_32_31_t_y - f_u_32_30_t_y;
  const Scalar mu_32_28_z = f_u_32_30_t_y + c_29 * t53 - s_29 * mu_32_29_x;
  B[895] = B[1019] = mu_32_28_z;
  const Scalar t54 = Scalar(0.0012) + t6;
  const Scalar t55 = c_11 * (t54 + Scalar(0.00555));
  const Scalar t56 = c_11 * t55;
  const Scalar t57 = c_11 * hu_12_t_x;
  const Scalar t58 = Scalar(178.5) * t57;
  const Scalar t59 = Scalar(20.0) * hu_12_a_z;
  const Scalar t60 = t54 - t56 - t59 - t58 - Scalar(0.44815416666667);
  B[297] = -t60;
  const Scalar t61 = Scalar(0.0012) + t8;
  const Scalar t62 = c_5 * (t61 + Scalar(0.00555));
  const Scalar t63 = c_5 * t62;
  const Scalar t64 = c_5 * hu_6_t_x;
  const Scalar t65 = Scalar(178.5) * t64;
  const Scalar t66 = Scalar(20.0) * hu_6_a_z;
  const Scalar t67 = t61 - t63 - t66 - t65 - Scalar(0.44815416666667);
  B[99] = -t67;
  const Scalar t68 = c_4 * t16;
  const Scalar t69 = Scalar(5.0) * hu_6_t_x;
  const Scalar t70 = Ic_5_zz + Scalar(89.25) * t64;
  const Scalar t71 = s_4 * t70 - c_5 * (t68 - t69);
  B[68] = B[130] = -t71;
  const Scalar t72 = c_5 * t16;
  const Scalar mu_u_5_4_t_x = s_4 * t72 + c_4 * t70;
  const Scalar t73 = t16 - c_4 * t69;
  const Scalar t74 = s_3 * s_5;
  const Scalar t75 = Scalar(97.25) * hu_6_t_x;
  const Scalar t76 = (s_4 * t74 + c_3 * c_5) * t75;
  B[36] = B[129] = t74 * t73 + c_3 * mu_u_5_4_t_x + t76;
  const Scalar t77 = c_5 * hu_6_a_z;
  const Scalar t78 = s_4 * t77 + c_4 * hu_6_t_x;
  const Scalar t79 = c_3 * s_5;
  const Scalar t80 = s_3 * t78 - hu_6_a_z * t79;
  const Scalar mu_6_3_y = Scalar(5.0) * (s_4 * hu_6_t_x - c_4 * t77) + mu_6_4_z;
  const Scalar t81 = s_4 * t12 + c_4 * t17;
  B[37] = B[161] = t79 * t81 - Scalar(97.25) * t80 - s_3 * mu_6_3_y;
  const Scalar t82 = c_10 * t18;
  const Scalar t83 = Scalar(5.0) * hu_12_t_x;
  const Scalar t84 = Ic_11_zz + Scalar(89.25) * t57;
  const Scalar t85 = s_10 * t84 - c_11 * (t82 - t83);
  B[266] = B[328] = -t85;
  const Scalar t86 = c_11 * t18;
  const Scalar mu_u_11_10_t_x = s_10 * t86 + c_10 * t84;
  const Scalar t87 = t18 - c_10 * t83;
  const Scalar t88 = s_9 * s_11;
  const Scalar t89 = Scalar(97.25) * hu_12_t_x;
  const Scalar t90 = (s_10 * t88 + c_9 * c_11) * t89;
  B[234] = B[327] = t88 * t87 + c_9 * mu_u_11_10_t_x + t90;
  const Scalar t91 = c_11 * hu_12_a_z;
  const Scalar t92 = s_10 * t91 + c_10 * hu_12_t_x;
  const Scalar t93 = c_9 * s_11;
  const Scalar t94 = s_9 * t92 - hu_12_a_z * t93;
  const Scalar mu_12_9_y = Scalar(5.0) * (s_10 * hu_12_t_x - c_10 * t91) + mu_12_10_z;
  const Scalar t95 = s_10 * t14 + c_10 * t19;
  B[235] = B[359] = t93 * t95 - Scalar(97.25) * t94 - s_9 * mu_12_9_y;
  B[401] = B[556] = s_14 * mu_u_18_15_a_y - c_14 * (s_15 * t51 - c_15 * t49);
  const Scalar t96 = s_23 * t34 - c_23 * t31;
  const Scalar t97 = c_23 * hu_23_a_y;
  const Scalar mu_24_22_y = t10 + t97;
  const Scalar mu_24_21_z = t97 - c_22 * mu_24_22_y + s_22 * t96;
  B[663] = B[756] = mu_24_21_z;
  const Scalar t98 = c_23 * t35;
  const Scalar t99 = c_24 * t98 + s_23 * t30;
  const Scalar t100 = c_23 * t9 - s_23 * t38 + Scalar(59.75) * t99;
  const Scalar t101 = t99 + mu_u_25_24_t_y;
  const Scalar t102 = t99 - c_22 * t101 - s_22 * t100;
  B[664] = B[788] = -t102;
  const Scalar mu_31_29_x = s_30 * t43 + c_30 * t41;
  const Scalar t103 = c_30 * hu_30_a_y;
  const Scalar t104 = Iu_31_t_yz - t103;
  const Scalar mu_31_28_z = t103 + c_29 * t104 - s_29 * mu_31_29_x;
  B[894] = B[987] = mu_31_28_z;
  const Scalar t105 = t3 - Scalar(0.0005096);
  const Scalar t106 = c_31 * (t105 - Scalar(0.0235906)) - Scalar(0.0014964) * t2;
  const Scalar t107 = c_31 * t106;
  const Scalar mu_u_30_30_a_y = t105 - t107 - Scalar(0.0259635000000002);
  B[957] = -mu_u_30_30_a_y;
  const Scalar t108 = t4 - Scalar(0.0005096);
  const Scalar t109 = Scalar(0.0014964) * t1 + c_24 * (t108 - Scalar(0.0235906));
  const Scalar t110 = c_24 * t109;
  const Scalar mu_u_23_23_a_y = t108 - t110 - Scalar(0.0259635000000002);
  B[726] = -mu_u_23_23_a_y;
  const Scalar t111 = t55 + t15;
  const Scalar t112 = s_10 * t18 + c_10 * t111;
  const Scalar Iu_10_a_xy = s_11 * t112;
  B[265] = B[296] = Iu_10_a_xy;
  const Scalar t113 = t62 + t13;
  const Scalar t114 = s_4 * t16 + c_4 * t113;
  const Scalar Iu_4_a_xy = s_5 * t114;
  B[67] = B[98] = Iu_4_a_xy;
  const Scalar t115 = c_16 * Iu_18_a_yz;
  const Scalar hu_16_a_z = f_u_18_18_a_z * t46 + c_16 * hu_18_a_z;
  const Scalar t116 = Scalar(113.25) * hu_16_a_z - c_17 * (Iu_17_t_d * t46 - t115);
  B[463] = B[494] = -t116;
  const Scalar t117 = Scalar(0.75) * f_u_18_18_a_z;
  const Scalar t118 = s_16 * t45 - s_17 * (t115 - t117);
  const Scalar t119 = c_17 * (Iu_18_a_yz - c_16 * t117);
  B[432] = B[525] = s_15 * t119 - c_15 * t118;
  const Scalar f_u_32_29_t_x = s_29 * t28 - c_29 * t25;
  const Scalar f_u_32_28_t_x = s_28 * f_u_32_29_t_x + c_28 * f_u_32_30_t_y;
  const Scalar f_u_32_29_a_z = c_29 * t28 + s_29 * t25;
  const Scalar mu_32_28_y = mu_32_29_z - f_u_32_29_a_z;
  const Scalar mu_u_32_29_t_x = s_29 * t53 + c_29 * mu_32_29_x;
  const Scalar mu_32_27_z = c_28 * mu_u_32_29_t_x + Scalar(76.25) * f_u_32_28_t_x -
      s_28 * mu_32_28_y;
  B[863] = B[1018] = mu_32_27_z;
  const Scalar t120 = Scalar(0.0007482) * c_32 + s_31 * t106;
  const Scalar hu_30_t_y = t23 + c_30 * hu_31_t_x;
  const Scalar mu_30_29_z = s_30 * Iu_31_t_yz - c_30 * t120 + Scalar(59.75) * hu_30_t_y;
  B[925] = B[956] = mu_30_29_z;
  const Scalar t121 = s_4 * t113 - t68;
  const Scalar hc_4_x = t64 + Scalar(0.00549);
  const Scalar f_4_4_x = hu_6_a_z + Scalar(0.00088);
  const Scalar t122 = s_4 * hc_4_x - c_4 * f_4_4_x;
  const Scalar hu_4_t_y = s_4 * f_4_4_x + c_4 * hc_4_x;
  const Scalar t123 = t67 - Scalar(5.0) * t122 - Scalar(97.25) * hu_4_t_y;
  B[35] = B[97] = t121 * t79 + s_3 * t123;
  const Scalar t124 = (s_3 * c_5 - s_4 * t79) * t75;
  B[4] = B[128] = s_2 * t71 + c_2 * (s_3 * mu_u_5_4_t_x - t79 * t73 + t124);
  const Scalar f_u_6_3_t_y = hu_6_a_z * t74 + c_3 * t78;
  const Scalar mu_6_2_x = t74 * t81 + Scalar(97.25) * f_u_6_3_t_y + c_3 * mu_6_3_y;
  B[5] = B[160] = c_2 * mu_6_2_x - s_2 * B_3_6;
  const Scalar t125 = s_10 * t111 - t82;
  const Scalar hc_10_x = t57 + Scalar(0.00549);
  const Scalar f_10_10_x = hu_12_a_z + Scalar(0.00088);
  const Scalar t126 = s_10 * hc_10_x - c_10 * f_10_10_x;
  const Scalar hu_10_t_y = s_10 * f_10_10_x + c_10 * hc_10_x;
  const Scalar t127 = t60 - Scalar(5.0) * t126 - Scalar(97.25) * hu_10_t_y;
  B[233] = B[295] = t125 * t93 + s_9 * t127;
  const Scalar t128 = (s_9 * c_11 - s_10 * t93) * t89;
  B[202] = B[326] = s_8 * t85 + c_8 * (s_9 * mu_u_11_10_t_x - t93 * t87 + t128);
  const Scalar f_u_12_9_t_y = hu_12_a_z * t88 + c_9 * t92;
  const Scalar mu_12_8_x = t88 * t95 + Scalar(97.25) * f_u_12_9_t_y + c_9 * mu_12_9_y;
  B[203] = B[358] = c_8 * mu_12_8_x - s_8 * B_9_12;
  const Scalar t129 = s_22 * mu_24_22_y + c_22 * t96;
  const Scalar t130 = s_23 * hu_23_a_y;
  const Scalar t131 = s_22 * hu_24_t_x - c_22 * t130;
  const Scalar f_u_24_21_t_x = s_21 * t131 + c_21 * t97;
  const Scalar f_u_24_22_a_z = s_22 * t130 + c_22 * hu_24_t_x;
  const Scalar mu_24_21_y = mu_24_22_z - f_u_24_22_a_z;
  const Scalar mu_24_20_z = -c_21 * t129 - s_21 * mu_24_21_y + Scalar(76.25) * f_u_24_21_t_x;
  B[631] = B[755] = mu_24_20_z;
  const Scalar t132 = s_22 * t39 - c_22 * t37;
  const Scalar t133 = s_21 * t132 + c_21 * t99;
  const Scalar f_u_25_22_t_y = c_22 * t39 + s_22 * t37;
  const Scalar t134 = t40 - f_u_25_22_t_y;
  const Scalar t135 = s_22 * t101 - c_22 * t100;
  const Scalar mu_u_25_20_a_y = Scalar(76.25) * t133 - c_21 * t135 - s_21 * t134;
  B[632] = B[787] = -mu_u_25_20_a_y;
  const Scalar t136 = s_29 * t104 + c_29 * mu_31_29_x;
  const Scalar t137 = s_30 * hu_30_a_y;
  const Scalar t138 = s_29 * hu_31_t_x - c_29 * t137;
  const Scalar f_u_31_28_t_x = s_28 * t138 + c_28 * t103;
  const Scalar f_u_31_29_a_z = s_29 * t137 + c_29 * hu_31_t_x;
  const Scalar mu_31_28_y = mu_31_29_z - f_u_31_29_a_z;
  const Scalar mu_31_27_z = c_28 * t136 - s_28 * mu_31_28_y + Scalar(76.25) * f_u_31_28_t_x;
  B[862] = B[986] = mu_31_27_z;
  const Scalar Iu_24_t_xy = Scalar(0.0007482) * c_25 - s_24 * t109;
  const Scalar t139 = t36 - c_23 * hu_24_t_x;
  const Scalar t140 = s_23 * t10 - c_23 * Iu_24_t_xy + Scalar(59.75) * t139;
  B[694] = B[725] = -t140;
  const Scalar t141 = s_16 * hu_18_a_z - f_u_18_18_a_z * t20;
  const Scalar t142 = c_17 * (s_16 * Iu_18_a_yz + Iu_17_t_d * t20) + Scalar(113.25) * t141;
  const Scalar t143 = Ic_16_zz - Scalar(0.75) * hu_16_a_z;
  B[431] = B[493] = -s_15 * t143 - c_15 * t142;
  const Scalar mu_u_17_15_t_x = c_15 * t119 + s_15 * t118;
  B[400] = B[524] = s_14 * t48 - c_14 * mu_u_17_15_t_x;
  const Scalar t144 = s_21 * t99 - c_21 * t132;
  const Scalar t145 = Scalar(76.25) * t144 - s_21 * t135 + c_21 * t134;
  const Scalar mu_u_25_20_t_y = s_20 * t102 - c_20 * t145;
  B[600] = B[786] = mu_u_25_20_t_y;
  B[399] = B[492] = s_14 * t116 - c_14 * (s_15 * t142 - c_15 * t143);
  const Scalar t146 = s_28 * f_u_32_30_t_y - c_28 * f_u_32_29_t_x;
  const Scalar t147 = s_28 * mu_u_32_29_t_x + Scalar(76.25) * t146 + c_28 * mu_32_28_y;
  const Scalar t148 = s_27 * mu_32_28_z - c_27 * t147;
  B[831] = B[1017] = -t148;
  const Scalar t149 = t56 - t59 - Scalar(0.00555);
  const Scalar Ic_10_yy = Ic_11_zz + t58 + Scalar(0.40049083333333);
  const Scalar Ic_10_xy = t86 + t19 + Scalar(0.0549);
  const Scalar t150 = s_10 * (t149 + Ic_10_yy) - Scalar(2.0) * c_10 * Ic_10_xy;
  const Scalar t151 = s_10 * t150;
  const Scalar t152 = Scalar(-10.0) * t126;
  const Scalar t153 = t149 + t152 - Scalar(0.03800666666667) - t151;
  B[264] = -t153;
  const Scalar t154 = t63 - t66 - Scalar(0.00555);
  const Scalar Ic_4_yy = Ic_5_zz + t65 + Scalar(0.40049083333333);
  const Scalar Ic_4_xy = t72 + t17 + Scalar(0.0549);
  const Scalar t155 = s_4 * (t154 + Ic_4_yy) - Scalar(2.0) * c_4 * Ic_4_xy;
  const Scalar t156 = s_4 * t155;
  const Scalar t157 = Scalar(-10.0) * t122;
  const Scalar t158 = t154 + t157 - Scalar(0.03800666666667) - t156;
  B[66] = -t158;
  const Scalar mu_4_2_x = t121 * t74 - c_3 * t123;
  B[3] = B[96] = c_2 * mu_4_2_x - s_2 * Iu_4_a_xy;
  const Scalar mu_10_8_x = t125 * t88 - c_9 * t127;
  B[201] = B[294] = c_8 * mu_10_8_x - s_8 * Iu_10_a_xy;
  const Scalar t159 = t98 + s_23 * hu_24_t_x;
  const Scalar t160 = c_23 * t10 + s_23 * Iu_24_t_xy + Scalar(59.75) * t159;
  const Scalar mu_23_22_y = mu_u_23_23_a_y - t159;
  const Scalar t161 = t159 - s_22 * t160 + c_22 * mu_23_22_y;
  B[662] = B[724] = -t161;
  const Scalar f_u_24_21_t_y = s_21 * t97 - c_21 * t131;
  const Scalar mu_24_20_x = c_21 * mu_24_21_y - s_21 * t129 + Scalar(76.25) * f_u_24_21_t_y;
  const Scalar t162 = s_20 * mu_24_21_z - c_20 * mu_24_20_x;
  B[599] = B[754] = -t162;
  const Scalar t163 = s_30 * hu_31_t_x - t52;
  const Scalar t164 = -c_30 * Iu_31_t_yz - s_30 * t120 + Scalar(59.75) * t163;
  const Scalar mu_30_29_y = mu_u_30_30_a_y - t163;
  const Scalar t165 = t163 - s_29 * t164 + c_29 * mu_30_29_y;
  B[893] = B[955] = -t165;
  const Scalar f_u_31_28_t_y = s_28 * t103 - c_28 * t138;
  const Scalar mu_31_27_x = s_28 * t136 + c_28 * mu_31_28_y + Scalar(76.25) * f_u_31_28_t_y;
  const Scalar t166 = s_27 * mu_31_28_z - c_27 * mu_31_27_x;
  B[830] = B[985] = -t166;
  const Scalar t167 = s_27 * f_u_32_28_t_x + c_27 * f_u_32_29_a_z;
  const Scalar t168 = s_26 * t146 + c_26 * t167;
  const Scalar t169 = c_27 * mu_32_28_z + s_27 * t147;
  const Scalar t170 = s_27 * f_u_32_29_a_z - c_27 * f_u_32_28_t_x;
  const Scalar B_15_32 = Scalar(82.5) * t170 + Scalar(60.0) * t168 + s_26 * t169 +
      c_26 * mu_32_27_z;
  B[479] = B[1006] = B_15_32;
  const Scalar t171 = t107 + Scalar(0.0235906);
  const Scalar Ic_30_yy = Ic_31_zz - Scalar(0.0253235000000002);
  const Scalar t172 = s_30 * (t171 + Ic_30_yy) - Scalar(0.0014964) * c_30 * s_32 * t42;
  const Scalar t173 = s_30 * t172;
  const Scalar t174 = Scalar(-2.0) * t163;
  const Scalar t175 = Scalar(119.5) * hu_30_a_y;
  const Scalar t176 = t174 + t171 - t173 - t175 - Scalar(0.2298769000000002);
  B[924] = -t176;
  const Scalar t177 = t110 + Scalar(0.0235906);
  const Scalar Ic_23_yy = Ic_24_zz - Scalar(0.0253235000000002);
  const Scalar t178 = Scalar(0.0014964) * c_23 * s_25 * t33 + s_23 * (t177 + Ic_23_yy);
  const Scalar t179 = s_23 * t178;
  const Scalar t180 = Scalar(2.0) * t159;
  const Scalar t181 = Scalar(119.5) * hu_23_a_y;
  const Scalar t182 = t177 - t180 - t179 - t181 - Scalar(0.2298769000000002);
  B[693] = -t182;
  const Scalar t183 = s_22 * mu_23_22_y + c_22 * t160;
  const Scalar t184 = s_22 * t139;
  const Scalar t185 = t140 - t184;
  const Scalar t186 = s_21 * t139;
  const Scalar t187 = c_22 * t186 - c_21 * t159;
  const Scalar B_20_23 = Scalar(76.25) * t187 + s_21 * t185 - c_21 * t183;
  B[630] = B[723] = B_20_23;
  const Scalar t188 = c_20 * mu_24_21_z + s_20 * mu_24_20_x;
  const Scalar t189 = s_20 * f_u_24_21_t_x + c_20 * f_u_24_22_a_z;
  const Scalar t190 = s_19 * f_u_24_21_t_y + c_19 * t189;
  const Scalar t191 = s_20 * f_u_24_22_a_z - c_20 * f_u_24_21_t_x;
  const Scalar B_15_24 = s_19 * t188 - Scalar(60.0) * t190 + c_19 * mu_24_20_z +
      Scalar(82.5) * t191;
  B[471] = B[750] = B_15_24;
  const Scalar f_u_25_20_t_x = s_20 * t133 + c_20 * f_u_25_22_t_y;
  const Scalar f_u_25_19_t_x = s_19 * t144 + c_19 * f_u_25_20_t_x;
  const Scalar mu_u_25_20_t_x = c_20 * t102 + s_20 * t145;
  const Scalar t192 = s_20 * f_u_25_22_t_y - c_20 * t133;
  const Scalar t193 = Scalar(82.5) * t192 - Scalar(60.0) * f_u_25_19_t_x + s_19 * mu_u_25_20_t_x +
      c_19 * mu_u_25_20_a_y;
  B[472] = B[782] = -t193;
  const Scalar t194 = c_27 * mu_31_28_z + s_27 * mu_31_27_x;
  const Scalar t195 = s_27 * f_u_31_28_t_x + c_27 * f_u_31_29_a_z;
  const Scalar t196 = s_26 * f_u_31_28_t_y + c_26 * t195;
  const Scalar t197 = s_27 * f_u_31_29_a_z - c_27 * f_u_31_28_t_x;
  const Scalar B_15_31 = Scalar(60.0) * t196 + s_26 * t194 + c_26 * mu_31_27_z +
      Scalar(82.5) * t197;
  B[478] = B[974] = B_15_31;
  const Scalar t198 = t139 + t34 - c_23 * t178;
  const Scalar Iu_22_a_xy = s_22 * t198 - c_22 * t140;
  B[661] = B[692] = Iu_22_a_xy;
  const Scalar t199 = Scalar(0.00507) + Scalar(5.0) * hu_10_t_y + Ic_10_xy + c_10 * t150;
  const Scalar t200 = Scalar(0.00032) + t126;
  const Scalar t201 = hu_12_t_x * t88 + c_9 * t200;
  const Scalar t202 = t112 * t88 + c_9 * t199 + Scalar(97.25) * t201;
  B[232] = B[263] = -t202;
  const Scalar t203 = Scalar(0.00507) + Scalar(5.0) * hu_4_t_y + Ic_4_xy + c_4 * t155;
  const Scalar t204 = Scalar(0.00032) + t122;
  const Scalar t205 = hu_6_t_x * t74 + c_3 * t204;
  const Scalar t206 = t114 * t74 + c_3 * t203 + Scalar(97.25) * t205;
  B[34] = B[65] = -t206;
  const Scalar f_u_25_19_t_y = s_19 * f_u_25_20_t_x - c_19 * t144;
  const Scalar mu_25_15_x = Scalar(60.0) * f_u_25_19_t_y - s_19 * mu_u_25_20_a_y +
      c_19 * mu_u_25_20_t_x;
  const Scalar mu_25_15_y = mu_u_25_20_t_y - Scalar(82.5) * f_u_25_19_t_y;
  B[440] = B[781] = s_15 * mu_25_15_x + c_15 * mu_25_15_y;
  const Scalar t207 = s_29 * mu_30_29_y + c_29 * t164;
  const Scalar t208 = s_29 * hu_30_t_y;
  const Scalar mu_30_28_y = mu_30_29_z - t208;
  const Scalar t209 = s_28 * hu_30_t_y;
  const Scalar t210 = c_29 * t209 + c_28 * t163;
  const Scalar t211 = Scalar(76.25) * t210 + s_28 * mu_30_28_y + c_28 * t207;
  B[861] = B[954] = -t211;
  const Scalar f_u_32_26_a_z = s_26 * t167 - c_26 * t146;
  const Scalar mu_32_15_x = Scalar(60.0) * f_u_32_26_a_z + s_26 * mu_32_27_z - c_26 * t169;
  const Scalar t212 = t148 - Scalar(82.5) * f_u_32_26_a_z;
  B[447] = B[1005] = s_15 * mu_32_15_x - c_15 * t212;
  const Scalar Ic_29_xz = hu_30_t_y + t43 + c_30 * t172;
  const Scalar t213 = s_29 * Ic_29_xz - c_29 * mu_30_29_z;
  B[892] = B[923] = -t213;
  const Scalar t214 = c_21 * t139;
  const Scalar t215 = c_22 * t214 + s_21 * t159;
  const Scalar t216 = Scalar(76.25) * t215 + s_21 * t183 + c_21 * t185;
  const Scalar mu_u_23_20_t_y = s_20 * t161 - c_20 * t216;
  B[598] = B[722] = mu_u_23_20_t_y;
  const Scalar t217 = c_28 * hu_30_t_y;
  const Scalar t218 = s_28 * t163 - c_29 * t217;
  const Scalar t219 = Scalar(76.25) * t218 + s_28 * t207 - c_28 * mu_30_28_y;
  const Scalar mu_u_30_27_t_y = s_27 * t165 - c_27 * t219;
  B[829] = B[953] = mu_u_30_27_t_y;
  const Scalar t220 = s_26 * t195 - c_26 * f_u_31_28_t_y;
  const Scalar t221 = Scalar(60.0) * t220 + s_26 * mu_31_27_z - c_26 * t194;
  const Scalar t222 = t166 - Scalar(82.5) * t220;
  B[446] = B[973] = s_15 * t221 - c_15 * t222;
  const Scalar Iu_10_t_xx = Ic_10_yy - t151;
  const Scalar t223 = Scalar(0.02175666666667) + t152 + t60;
  const Scalar Iu_9_t_d = Iu_10_t_xx + t223;
  const Scalar t224 = t83 + t125;
  const Scalar t225 = Scalar(2.0) * t224 * t93 + s_9 * Iu_9_t_d;
  const Scalar t226 = s_9 * t225;
  const Scalar t227 = Scalar(194.5) * hu_10_t_y;
  B[231] = Iu_10_t_xx - t226 + t227 + Scalar(1.03820716666667);
  const Scalar Iu_4_t_xx = Ic_4_yy - t156;
  const Scalar t228 = Scalar(0.02175666666667) + t157 + t67;
  const Scalar Iu_3_t_d = Iu_4_t_xx + t228;
  const Scalar t229 = t69 + t121;
  const Scalar t230 = Scalar(2.0) * t229 * t79 + s_3 * Iu_3_t_d;
  const Scalar t231 = s_3 * t230;
  const Scalar t232 = Scalar(194.5) * hu_4_t_y;
  B[33] = Iu_4_t_xx - t231 + t232 + Scalar(1.03820716666667);
  const Scalar t233 = s_3 * t204 - hu_6_t_x * t79;
  const Scalar t234 = c_2 * (s_3 * t203 - t114 * t79 + Scalar(97.25) * t233);
  B[2] = B[64] = s_2 * t158 - t234;
  const Scalar t235 = s_9 * t200 - hu_12_t_x * t93;
  const Scalar t236 = c_8 * (s_9 * t199 - t112 * t93 + Scalar(97.25) * t235);
  B[200] = B[262] = s_8 * t153 - t236;
  const Scalar t237 = s_19 * t189 - c_19 * f_u_24_21_t_y;
  const Scalar t238 = Scalar(60.0) * t237 - s_19 * mu_24_20_z + c_19 * t188;
  const Scalar t239 = t162 - Scalar(82.5) * t237;
  B[439] = B[749] = -s_15 * t238 - c_15 * t239;
  B[408] = B[780] = c_14 * (s_15 * mu_25_15_y - c_15 * mu_25_15_x) + s_14 * t193;
  const Scalar Iu_29_t_xz = c_29 * Ic_29_xz + s_29 * mu_30_29_z;
  const Scalar t240 = Scalar(0.0001312) + t163;
  const Scalar hc_29_y = hu_30_a_y + Scalar(0.0034592);
  const Scalar t241 = c_29 * t240 + s_29 * hc_29_y;
  const Scalar t242 = s_29 * t240 - c_29 * hc_29_y;
  const Scalar t243 = t241 + t176 + Scalar(76.25) * t242;
  const Scalar B_27_29 = c_28 * Iu_29_t_xz + s_28 * t243;
  B[860] = B[922] = B_27_29;
  const Scalar Ic_29_xx = Ic_30_yy - t173 + t175;
  const Scalar t244 = t174 + mu_u_30_30_a_y + Scalar(0.2262745000000002);
  const Scalar Iu_29_t_d = Ic_29_xx + t244;
  const Scalar Ic_29_xy = hu_30_a_y + Scalar(0.0050592) + t164;
  const Scalar t245 = Scalar(2.0) * s_29 * Ic_29_xy - c_29 * Iu_29_t_d;
  const Scalar t246 = c_29 * t245;
  const Scalar t247 = Scalar(-2.0) * t241;
  const Scalar Ic_28_zz = t247 + Ic_29_xx + t246 + Scalar(0.2360429000000002);
  B[891] = Ic_28_zz;
  const Scalar Ic_22_xx = Ic_23_yy - t179 + t181;
  const Scalar t248 = mu_u_23_23_a_y - t180 + Scalar(0.2262745000000002);
  const Scalar Iu_22_t_d = Ic_22_xx + t248;
  const Scalar Ic_22_xy = hu_23_a_y + Scalar(0.0050592) + t160;
  const Scalar t249 = Scalar(2.0) * s_22 * Ic_22_xy - c_22 * Iu_22_t_d;
  const Scalar t250 = c_22 * t249;
  const Scalar t251 = Scalar(0.0001312) + t159;
  const Scalar hc_22_y = hu_23_a_y + Scalar(0.0034592);
  const Scalar f_u_22_22_a_z = c_22 * t251 + s_22 * hc_22_y;
  const Scalar t252 = Scalar(2.0) * f_u_22_22_a_z;
  const Scalar B_21_21 = Ic_22_xx - t252 + t250 + Scalar(0.2360429000000002);
  B[660] = B_21_21;
  const Scalar t253 = c_22 * t198 + s_22 * t140;
  const Scalar t254 = s_22 * t251 - c_22 * hc_22_y;
  const Scalar t255 = f_u_22_22_a_z + t182 + Scalar(76.25) * t254;
  const Scalar t256 = c_21 * t253 - s_21 * t255;
  B[629] = B[691] = -t256;
  const Scalar t257 = s_27 * t219 + c_27 * t165;
  const Scalar t258 = s_27 * t210 - c_27 * t208;
  const Scalar t259 = s_26 * t218 + c_26 * t258;
  const Scalar t260 = s_27 * t208 + c_27 * t210;
  const Scalar B_15_30 = Scalar(82.5) * t260 - Scalar(60.0) * t259 - s_26 * t257 - c_26 * t211;
  B[477] = B[942] = B_15_30;
  const Scalar mu_u_32_15_t_x = s_15 * t212 + c_15 * mu_32_15_x;
  B[415] = B[1004] = -c_14 * mu_u_32_15_t_x - s_14 * B_15_32;
  B[199] = B[230] = s_8 * t202 + c_8 * (c_9 * t225 - s_11 * t224);
  B[1] = B[32] = s_2 * t206 + c_2 * (c_3 * t230 - s_5 * t229);
  const Scalar mu_u_23_20_t_x = s_20 * t216 + c_20 * t161;
  const Scalar t261 = s_20 * t187 - c_20 * t184;
  const Scalar t262 = s_19 * t215 - c_19 * t261;
  const Scalar t263 = s_20 * t184 + c_20 * t187;
  const Scalar t264 = Scalar(82.5) * t263 - Scalar(60.0) * t262 + s_19 * mu_u_23_20_t_x -
      c_19 * B_20_23;
  B[470] = B[718] = -t264;
  const Scalar mu_u_24_15_t_x = s_15 * t239 - c_15 * t238;
  B[407] = B[748] = -c_14 * mu_u_24_15_t_x - s_14 * B_15_24;
  const Scalar mu_29_27_x = s_28 * Iu_29_t_xz - c_28 * t243;
  const Scalar mu_u_29_27_t_y = s_27 * t213 + c_27 * mu_29_27_x;
  B[828] = B[921] = mu_u_29_27_t_y;
  B[414] = B[972] = -c_14 * (c_15 * t221 + s_15 * t222) - s_14 * B_15_31;
  const Scalar t265 = t254 - Scalar(0.0023) + Ic_22_xy - s_22 * t249;
  const Scalar t266 = Scalar(0.0000128) + f_u_22_22_a_z;
  const Scalar t267 = t186 - c_21 * t266;
  const Scalar B_20_21 = -s_21 * Iu_22_a_xy - c_21 * t265 + Scalar(76.25) * t267;
  B[628] = B[659] = B_20_21;
  const Scalar t268 = s_21 * t253 + c_21 * t255;
  const Scalar t269 = s_20 * Iu_22_a_xy + c_20 * t268;
  B[597] = B[690] = -t269;
  const Scalar t270 = t242 - Scalar(0.0023) + Ic_29_xy - s_29 * t245;
  const Scalar t271 = Scalar(0.0000128) + t241;
  const Scalar t272 = t209 + c_28 * t271;
  const Scalar t273 = c_28 * t270 - s_28 * t213 + Scalar(76.25) * t272;
  B[859] = B[890] = -t273;
  const Scalar t274 = s_20 * t268 - c_20 * Iu_22_a_xy;
  const Scalar t275 = s_21 * t254;
  const Scalar t276 = s_20 * t275 + c_20 * f_u_22_22_a_z;
  const Scalar t277 = c_21 * t254;
  const Scalar t278 = s_19 * t277 - c_19 * t276;
  const Scalar t279 = s_20 * f_u_22_22_a_z - c_20 * t275;
  const Scalar mu_22_15_z = Scalar(60.0) * t278 - s_19 * t274 + Scalar(82.5) * t279 - c_19 * t256;
  B[469] = B[686] = mu_22_15_z;
  const Scalar t280 = s_19 * t261 + c_19 * t215;
  const Scalar t281 = Scalar(60.0) * t280 - s_19 * B_20_23 - c_19 * mu_u_23_20_t_x;
  const Scalar mu_23_15_y = mu_u_23_20_t_y + Scalar(82.5) * t280;
  B[438] = B[717] = c_15 * mu_23_15_y - s_15 * t281;
  const Scalar t282 = s_27 * mu_29_27_x - c_27 * t213;
  const Scalar t283 = s_28 * t242;
  const Scalar t284 = s_27 * t283 + c_27 * t241;
  const Scalar t285 = c_28 * t242;
  const Scalar f_u_29_26_t_x = s_26 * t285 - c_26 * t284;
  const Scalar t286 = s_27 * t241 - c_27 * t283;
  const Scalar mu_29_15_z = s_26 * t282 - Scalar(60.0) * f_u_29_26_t_x + Scalar(82.5) * t286 +
      c_26 * B_27_29;
  B[476] = B[910] = mu_29_15_z;
  const Scalar f_u_30_26_t_y = s_26 * t258 - c_26 * t218;
  const Scalar t287 = Scalar(60.0) * f_u_30_26_t_y + s_26 * t211 - c_26 * t257;
  const Scalar mu_30_15_y = mu_u_30_27_t_y - Scalar(82.5) * f_u_30_26_t_y;
  B[445] = B[941] = c_15 * mu_30_15_y - s_15 * t287;
  B[406] = B[716] = s_14 * t264 + c_14 * (s_15 * mu_23_15_y + c_15 * t281);
  const Scalar t288 = t223 - t226 - t227;
  const Scalar t289 = s_8 * (s_8 * (t153 - t288 + Scalar(1.03624716666667)) - Scalar(2.0) * t236);
  B[198] = -t288 - t289 + Scalar(1.04016716666667);
  const Scalar t290 = t228 - t231 - t232;
  const Scalar t291 = s_2 * (s_2 * (t158 - t290 + Scalar(1.03624716666667)) - Scalar(2.0) * t234);
  B[0] = -t290 - t291 + Scalar(1.04016716666667);
  const Scalar t292 = t214 + s_21 * t266;
  const Scalar t293 = s_21 * t265 - c_21 * Iu_22_a_xy + Scalar(76.25) * t292;
  const Scalar t294 = c_20 * t293;
  const Scalar t295 = t294 + s_20 * B_21_21;
  B[596] = B[658] = -t295;
  const Scalar t296 = s_28 * t271 - t217;
  const Scalar t297 = c_28 * t213 + s_28 * t270 + Scalar(76.25) * t296;
  const Scalar t298 = c_27 * t297;
  const Scalar t299 = t298 + s_27 * Ic_28_zz;
  B[827] = B[889] = -t299;
  const Scalar t300 = s_26 * t284 + c_26 * t285;
  const Scalar t301 = Scalar(60.0) * t300 - c_26 * t282 + s_26 * B_27_29;
  const Scalar mu_29_15_y = mu_u_29_27_t_y + Scalar(82.5) * t300;
  B[444] = B[909] = s_15 * t301 + c_15 * mu_29_15_y;
  B[413] = B[940] = c_14 * (s_15 * mu_30_15_y + c_15 * t287) - s_14 * B_15_30;
  const Scalar t302 = t246 + t244;
  const Scalar t303 = t176 - t247 + Scalar(0.2282085000000002);
  const Scalar t304 = hu_30_t_y - Iu_29_t_xz;
  const Scalar t305 = Scalar(2.0) * c_28 * t304 + s_28 * (t302 - t303);
  const Scalar t306 = s_28 * t305;
  const Scalar t307 = Scalar(-152.5) * t242;
  const Scalar t308 = t302 - t306 - t307 - Scalar(0.7079407000000002);
  B[858] = -t308;
  const Scalar t309 = t250 + t248;
  const Scalar t310 = t252 + t182 + Scalar(0.2282085000000002);
  const Scalar t311 = t139 - t253;
  const Scalar t312 = s_21 * (t309 - t310) - Scalar(2.0) * c_21 * t311;
  const Scalar t313 = s_21 * t312;
  const Scalar t314 = Scalar(-152.5) * t254;
  const Scalar t315 = t309 - t313 - t314 - Scalar(0.7079407000000002);
  B[627] = -t315;
  const Scalar t316 = s_20 * t293 - c_20 * B_21_21;
  const Scalar t317 = c_19 * t267;
  const Scalar f_u_21_19_t_x = s_19 * t292 - s_20 * t317;
  const Scalar mu_21_15_z = Scalar(60.0) * f_u_21_19_t_x + c_19 * B_20_21 -
      Scalar(82.5) * c_20 * t267 - s_19 * t316;
  B[468] = B[654] = mu_21_15_z;
  const Scalar t318 = s_19 * t276 + c_19 * t277;
  const Scalar t319 = Scalar(60.0) * t318 - c_19 * t274 + s_19 * t256;
  const Scalar t320 = t269 - Scalar(82.5) * t318;
  B[437] = B[685] = -s_15 * t319 - c_15 * t320;
  const Scalar Iu_28_a_yz = t304 - c_28 * t305;
  const Scalar Iu_27_t_yz = s_27 * t273 + c_27 * Iu_28_a_yz;
  B[826] = B[857] = Iu_27_t_yz;
  const Scalar t321 = s_27 * t297 - c_27 * Ic_28_zz;
  const Scalar t322 = c_26 * t272;
  const Scalar t323 = s_27 * t322 + s_26 * t296;
  const Scalar t324 = Scalar(60.0) * t323 + c_26 * t273 - Scalar(82.5) * c_27 * t272 + s_26 * t321;
  B[475] = B[878] = -t324;
  const Scalar t325 = t311 + c_21 * t312;
  const Scalar t326 = s_20 * B_20_21 + c_20 * t325;
  B[595] = B[626] = -t326;
  const Scalar mu_u_22_15_t_x = s_15 * t320 - c_15 * t319;
  B[405] = B[684] = -s_14 * mu_22_15_z - c_14 * mu_u_22_15_t_x;
  B[412] = B[908] = c_14 * (s_15 * mu_29_15_y - c_15 * t301) - s_14 * mu_29_15_z;
  const Scalar t327 = s_19 * t267;
  const Scalar t328 = s_20 * t327 + c_19 * t292;
  const Scalar t329 = Scalar(60.0) * t328 - s_19 * B_20_21 - c_19 * t316;
  const Scalar t330 = t295 - Scalar(82.5) * t328;
  B[436] = B[653] = -s_15 * t329 - c_15 * t330;
  const Scalar t331 = s_26 * t272;
  const Scalar f_u_28_26_t_y = s_27 * t331 - c_26 * t296;
  const Scalar t332 = Scalar(60.0) * f_u_28_26_t_y + s_26 * t273 - c_26 * t321;
  const Scalar t333 = Scalar(82.5) * f_u_28_26_t_y + t299;
  B[443] = B[877] = -s_15 * t332 - c_15 * t333;
  const Scalar Iu_20_t_xz = s_20 * t325 - c_20 * B_20_21;
  const Scalar t334 = s_19 * Iu_20_t_xz;
  const Scalar t335 = t254 - Scalar(0.006644);
  const Scalar t336 = c_20 * t292 + s_20 * t335;
  const Scalar t337 = t315 - Scalar(60.0) * t336;
  const Scalar hu_20_t_x = s_20 * t292 - c_20 * t335;
  const Scalar mu_u_20_15_a_y = t334 + Scalar(82.5) * hu_20_t_x + c_19 * t337;
  B[467] = B[622] = -mu_u_20_15_a_y;
  const Scalar Iu_27_a_xz = s_27 * Iu_28_a_yz - c_27 * t273;
  const Scalar t338 = s_26 * Iu_27_a_xz;
  const Scalar t339 = t242 - Scalar(0.006644);
  const Scalar t340 = c_27 * t296 + s_27 * t339;
  const Scalar t341 = Scalar(60.0) * t340 + t308;
  const Scalar hu_27_t_x = s_27 * t296 - c_27 * t339;
  const Scalar mu_u_27_15_a_y = Scalar(82.5) * hu_27_t_x - t338 + c_26 * t341;
  B[474] = B[846] = -mu_u_27_15_a_y;
  B[411] = B[876] = s_14 * t324 - c_14 * (s_15 * t333 - c_15 * t332);
  const Scalar t342 = t306 + t303 - t307;
  const Scalar Ic_27_yy = Ic_28_zz - Scalar(0.7059807000000002);
  const Scalar t343 = Scalar(2.0) * t298 + s_27 * (t342 + Ic_27_yy);
  const Scalar t344 = s_27 * t343;
  const Scalar t345 = t342 - t344 - Scalar(0.7099007000000002);
  B[825] = -t345;
  const Scalar t346 = t313 + t310 - t314;
  const Scalar t347 = B_21_21 - Scalar(0.7059807000000002);
  const Scalar t348 = Scalar(2.0) * t294 + s_20 * (t346 + t347);
  const Scalar t349 = s_20 * t348;
  const Scalar t350 = t346 - t349 - Scalar(0.7099007000000002);
  B[594] = -t350;
  const Scalar t351 = c_19 * Iu_20_t_xz - s_19 * t337;
  const Scalar t352 = t326 + Scalar(82.5) * s_19 * t336;
  B[435] = B[621] = s_15 * t351 - c_15 * t352;
  const Scalar mu_u_21_15_t_x = s_15 * t330 - c_15 * t329;
  B[404] = B[652] = -s_14 * mu_21_15_z - c_14 * mu_u_21_15_t_x;
  const Scalar t353 = t297 - c_27 * t343;
  const Scalar t354 = t322 + s_26 * hu_27_t_x;
  const Scalar B_15_26 = Scalar(60.0) * t354 + c_26 * Iu_27_t_yz + s_26 * t353;
  B[473] = B[814] = B_15_26;
  const Scalar t355 = c_26 * Iu_27_a_xz + s_26 * t341;
  const Scalar mu_27_15_y = Iu_27_t_yz - Scalar(82.5) * s_26 * t340;
  B[442] = B[845] = c_15 * mu_27_15_y - s_15 * t355;
  const Scalar t356 = t293 - c_20 * t348;
  const Scalar hu_19_t_y = s_19 * hu_20_t_x - t317;
  const Scalar t357 = Scalar(60.0) * hu_19_t_y + c_19 * t326 - s_19 * t356;
  B[466] = B[590] = -t357;
  B[403] = B[620] = s_14 * mu_u_20_15_a_y - c_14 * (s_15 * t352 + c_15 * t351);
  B[410] = B[844] = c_14 * (s_15 * mu_27_15_y + c_15 * t355) + s_14 * mu_u_27_15_a_y;
  const Scalar hu_19_t_x = t327 + c_19 * hu_20_t_x;
  const Scalar t358 = Scalar(60.0) * hu_19_t_x - s_19 * t326 - c_19 * t356;
  const Scalar t359 = Scalar(82.5) * hu_19_t_x + t350;
  B[434] = B[589] = s_15 * t358 - c_15 * t359;
  const Scalar t360 = t331 - c_26 * hu_27_t_x;
  const Scalar t361 = Scalar(60.0) * t360 + s_26 * Iu_27_t_yz - c_26 * t353;
  const Scalar t362 = t345 - Scalar(82.5) * t360;
  B[441] = B[813] = s_15 * t361 - c_15 * t362;
  const Scalar t363 = t347 - t349;
  const Scalar t364 = t315 + Scalar(0.7079407000000002);
  const Scalar t365 = Scalar(2.0) * t334 + c_19 * (t363 + t364);
  const Scalar Iu_27_t_xx = Ic_27_yy - t344;
  const Scalar t366 = t308 + Scalar(0.7079407000000002);
  const Scalar Iu_26_t_d = Iu_27_t_xx + t366;
  const Scalar t367 = Scalar(2.0) * t338 - c_26 * Iu_26_t_d;
  const Scalar t368 = c_19 * t365 - c_26 * t367;
  const Scalar t369 = Scalar(226.5) * t44 + Scalar(165.0) * (t360 - hu_19_t_x);
  const Scalar t370 = Scalar(-120.0) * (t340 - t336);
  const Scalar Iu_17_t_xx = Scalar(0.0002) + t29;
  const Scalar Iu_16_t_d = t11 + Iu_17_t_xx;
  const Scalar Iu_16_t_g = Scalar(2.0) * t47 + c_16 * Iu_16_t_d;
  const Scalar t371 = c_16 * Iu_16_t_g;
  const Scalar Ic_15_zz = Iu_17_t_xx - t371 + Iu_27_t_xx + t363 + t370 + t369 - t368 +
      Scalar(5.512820899999667);
  B[462] = Ic_15_zz;
  const Scalar mu_u_19_15_t_x = c_15 * t358 + s_15 * t359;
  B[402] = B[588] = s_14 * t357 - c_14 * mu_u_19_15_t_x;
  B[409] = B[812] = -s_14 * B_15_26 - c_14 * (c_15 * t361 + s_15 * t362);
  const Scalar t372 = c_17 * t117 - t116 - Scalar(0.043998) + Iu_27_a_xz - Iu_20_t_xz +
      Scalar(82.5) * (t354 + hu_19_t_y) + s_19 * t365 - s_26 * t367;
  const Scalar t373 = Scalar(0.75) * t141 - s_16 * Iu_16_t_g + s_17 * Iu_18_a_yz - t357 + B_15_26;
  const Scalar Iu_15_a_xy = s_15 * t372 - c_15 * t373;
  B[430] = B[461] = -Iu_15_a_xy;
  const Scalar t374 = c_14 * (s_15 * t373 + c_15 * t372);
  B[398] = B[460] = t374 - s_14 * Ic_15_zz;
  const Scalar t375 = Scalar(1.5) * hu_16_a_z;
  const Scalar t376 = t375 - Ic_16_zz - t370 + t366 + t364 - t368;
  const Scalar t377 = t375 + t11 - t371 - t369 - Scalar(0.5912714333326666) + t345 + t350;
  const Scalar t378 = -t142 - t358 - t361 + Scalar(82.5) * (t340 + t336);
  const Scalar t379 = Scalar(2.0) * s_15 * t378 - c_15 * (t376 - t377);
  const Scalar t380 = c_15 * t379;
  B[429] = Scalar(2.5075600666670006) - t380 - t376;
  B[397] = B[428] = s_14 * Iu_15_a_xy + c_14 * (t378 - s_15 * t379);
  const Scalar t381 = t377 - t380;
  const Scalar t382 = s_14 * (s_14 * (t381 - Scalar(2.5051100666670005) + Ic_15_zz) -
      Scalar(2.0) * t374);
  B[396] = t382 - t381 + Scalar(2.5107600666670002);
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
// Reads q[0..11], q[13..31], qd[0..31]. Operations: 998 mul, 811 add, 62 sin/cos.
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
  const Scalar t1 = c_14 * qd_13;
  const Scalar t2 = s_15 * t1;
  const Scalar t3 = c_15 * qd_14;
  const Scalar omega_r_15_y = t2 + t3;
  const Scalar t4 = s_14 * qd_13;
  const Scalar omega_15_z = qd_15 - t4;
  const Scalar t5 = s_16 * omega_15_z - c_16 * omega_r_15_y;
  const Scalar t6 = c_15 * t1;
  const Scalar t7 = s_15 * qd_14;
  const Scalar t8 = t7 - t6;
  const Scalar omega_16_z = qd_16 - t8;
  const Scalar omega_r_17_y = s_17 * omega_16_z - c_17 * t5;
  const Scalar omega_18_z = qd_18 + omega_r_17_y;
  const Scalar t9 = omega_18_z * omega_18_z;
  const Scalar omega_r_17_a_z = s_16 * omega_r_15_y + c_16 * omega_15_z;
  const Scalar omega_17_z = qd_17 + omega_r_17_a_z;
  const Scalar t10 = t9 + omega_17_z * omega_17_z;
  const Scalar t11 = s_17 * t5 + c_17 * omega_16_z;
  const Scalar t12 = t11 * t11 + t9;
  const Scalar I_t18_g = Scalar(0.0044) * c_18 + Scalar(0.024) * s_18;
  const Scalar t13 = c_18 * I_t18_g - Scalar(0.0022);
  const Scalar t14 = t8 * omega_15_z;
  const Scalar t15 = (Scalar(2.0) * t7 - t6) * t4;
  const Scalar t16 = t14 + t15;
  const Scalar t17 = t14 + t16;
  const Scalar t18 = t8 * omega_r_15_y;
  const Scalar t19 = qd_14 * t1;
  const Scalar t20 = t18 - t19;
  const Scalar t21 = s_16 * t20 + c_16 * t17 + Scalar(2.0) * omega_r_17_a_z * omega_16_z;
  const Scalar t22 = t11 * omega_17_z;
  const Scalar t23 = t5 * omega_r_17_a_z;
  const Scalar t24 = omega_r_15_y * omega_15_z;
  const Scalar t25 = (t2 + Scalar(2.0) * t3) * t4;
  const Scalar domega_15_x = t24 + t25;
  const Scalar U_16_xy = domega_15_x + t23;
  const Scalar t26 = t22 - s_17 * U_16_xy - c_17 * t21;
  const Scalar U_18_xy = t22 - t26;
  const Scalar t27 = s_18 * I_t18_g;
  const Scalar I_18_xx = Scalar(0.00504) + t27;
  const Scalar U_18_yx = t22 + t26;
  const Scalar t28 = t27 - Scalar(0.02904);
  const Scalar Uz_o_15_y = t1 * t1 + qd_14 * qd_14;
  const Scalar t29 = Scalar(2452.5) * s_14;
  const Scalar t30 = Scalar(0.75) * Uz_o_15_y - Scalar(113.25) * t17 - t29;
  const Scalar t31 = Scalar(2452.5) * c_14 * s_15;
  const Scalar ddp_o_16_y = Scalar(0.75) * t25 - Scalar(113.25) * t20 + t31;
  const Scalar t32 = s_16 * t30 - c_16 * ddp_o_16_y;
  const Scalar t33 = t8 * t8;
  const Scalar t34 = omega_15_z * omega_15_z;
  const Scalar Uz_o_16_x = Uz_o_15_y - t33 + t34;
  const Scalar t35 = c_14 * c_15;
  const Scalar t36 = Scalar(2452.5) * t35;
  const Scalar t37 = Scalar(0.75) * t15 + Scalar(113.25) * Uz_o_16_x - t36;
  const Scalar t38 = Scalar(0.00008) * c_18 + Scalar(0.00088) * s_18;
  const Scalar t39 = t38 * (s_17 * t32 - c_17 * t37);
  const Scalar t40 = s_16 * ddp_o_16_y + c_16 * t30;
  const Scalar t41 = Scalar(0.00088) * c_18 - Scalar(0.00008) * s_18;
  const Scalar n_18 = t13 * (t10 - t12) - U_18_xy * I_18_xx - U_18_yx * t28 - t39 + t41 * t40;
  n[17] = n_18;
  const Scalar t42 = Scalar(2.0) * omega_17_z;
  const Scalar U_17_zy = c_17 * U_16_xy + omega_r_17_y * t42 - s_17 * t21;
  const Scalar t43 = U_17_zy - t42 * omega_18_z;
  const Scalar t44 = s_17 * t37 + c_17 * t32;
  const Scalar t45 = t5 * omega_16_z;
  const Scalar domega_16_y = t45 - c_16 * t20 + s_16 * t17;
  const Scalar t46 = t11 * omega_r_17_y;
  const Scalar U_17_xy = domega_16_y - t46;
  const Scalar t47 = U_17_xy + Scalar(2.0) * t11 * omega_18_z;
  const Scalar mu_u_17_a_y = Scalar(0.00025) * (t46 + domega_16_y) + Scalar(0.00509) * U_17_xy -
      t43 * t13 - t47 * t28 - t41 * t44;
  n[16] = -mu_u_17_a_y;
  const Scalar t48 = c_2 * qd_1;
  const Scalar t49 = s_3 * t48;
  const Scalar t50 = c_3 * qd_2;
  const Scalar omega_r_3_x = t49 + t50;
  const Scalar t51 = s_2 * qd_1;
  const Scalar omega_3_z = qd_3 - t51;
  const Scalar t52 = omega_r_3_x * omega_3_z;
  const Scalar t53 = t52 + t51 * (t49 + Scalar(2.0) * t50);
  const Scalar U_3_zx = t52 + t53;
  const Scalar t54 = t48 * t48 + qd_2 * qd_2;
  const Scalar t55 = Scalar(2452.5) * c_1;
  const Scalar t56 = Scalar(97.25) * t54 - Scalar(5.0) * U_3_zx + c_2 * t55;
  const Scalar t57 = omega_r_3_x * omega_r_3_x;
  const Scalar t58 = omega_3_z * omega_3_z;
  const Scalar t59 = t54 - t57 + t58;
  const Scalar t60 = t48 * t51;
  const Scalar ddp_o_3_x = Scalar(97.25) * t60 + s_2 * t55;
  const Scalar t61 = qd_2 * t51;
  const Scalar ddp_3_a_y = Scalar(2452.5) * s_1 - Scalar(194.5) * t61;
  const Scalar t62 = s_3 * ddp_o_3_x - c_3 * ddp_3_a_y;
  const Scalar ddp_o_4_x = Scalar(5.0) * t59 + t62;
  const Scalar t63 = s_4 * ddp_o_4_x + c_4 * t56;
  const Scalar t64 = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar t65 = t64 * t64;
  const Scalar t66 = c_3 * t48;
  const Scalar t67 = s_3 * qd_2;
  const Scalar t68 = t67 - t66;
  const Scalar omega_4_z = qd_4 - t68;
  const Scalar t69 = omega_4_z * omega_4_z;
  const Scalar t70 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar t71 = t64 * t70;
  const Scalar U_4_xy = t53 - t71;
  const Scalar t72 = Scalar(10.0) * U_4_xy + t63 + Scalar(89.25) * (t57 + t58 + t69 - t65);
  const Scalar t73 = t64 * omega_4_z;
  const Scalar t74 = omega_r_3_x * t68;
  const Scalar t75 = qd_2 * t48;
  const Scalar t76 = t74 - t75;
  const Scalar t77 = (Scalar(2.0) * t67 - t66) * t51;
  const Scalar t78 = t77 + Scalar(2.0) * t68 * omega_3_z;
  const Scalar t79 = s_4 * t76 + t73 + c_4 * t78;
  const Scalar t80 = t73 + t79;
  const Scalar t81 = s_4 * t78 - c_4 * t76 + Scalar(2.0) * t70 * omega_4_z;
  const Scalar t82 = t74 + t75;
  const Scalar ddp_3_y = c_3 * ddp_o_3_x + s_3 * ddp_3_a_y;
  const Scalar ddp_o_4_y = Scalar(5.0) * t82 + ddp_3_y;
  const Scalar t83 = Scalar(10.0) * t81 - ddp_o_4_y + Scalar(89.25) * t80;
  const Scalar t84 = s_5 * t83 + c_5 * t72;
  const Scalar t85 = Scalar(0.00018) * c_6 - Scalar(0.00042) * s_6;
  const Scalar omega_r_5_y = s_5 * t64 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t86 = omega_6_z * omega_6_z;
  const Scalar omega_5_z = qd_5 - t70;
  const Scalar t87 = t86 + omega_5_z * omega_5_z;
  const Scalar t88 = s_5 * omega_4_z - c_5 * t64;
  const Scalar t89 = t88 * t88 + t86;
  const Scalar t90 = Scalar(0.0063) * c_6 - Scalar(0.0012) * s_6;
  const Scalar I_6_xy = c_6 * t90 - Scalar(0.00315);
  const Scalar t91 = t88 * omega_5_z;
  const Scalar t92 = t91 + c_5 * U_4_xy + s_5 * t81;
  const Scalar t93 = t91 - t92;
  const Scalar t94 = s_6 * t90;
  const Scalar t95 = t94 - Scalar(0.006558333333335);
  const Scalar t96 = t91 + t92;
  const Scalar I_6_yy = t94 + Scalar(0.007758333333335);
  const Scalar t97 = s_4 * t56 - c_4 * ddp_o_4_x;
  const Scalar t98 = t53 + t71;
  const Scalar Uz_o_5_y = t69 + t65;
  const Scalar ddp_5_a_z = Scalar(89.25) * t98 - Scalar(10.0) * Uz_o_5_y - t97;
  const Scalar mr_6_x = Scalar(0.00018) * s_6 + Scalar(0.00042) * c_6;
  const Scalar t99 = I_6_xy * (t87 - t89) + t93 * t95 + t96 * I_6_yy + t85 * t84 +
      mr_6_x * ddp_5_a_z;
  n[5] = -t99;
  const Scalar t100 = c_8 * qd_7;
  const Scalar t101 = s_9 * t100;
  const Scalar t102 = c_9 * qd_8;
  const Scalar omega_r_9_x = t101 + t102;
  const Scalar t103 = s_8 * qd_7;
  const Scalar omega_9_z = qd_9 - t103;
  const Scalar t104 = omega_r_9_x * omega_9_z;
  const Scalar t105 = t104 + t103 * (t101 + Scalar(2.0) * t102);
  const Scalar U_9_zx = t104 + t105;
  const Scalar t106 = t100 * t100 + qd_8 * qd_8;
  const Scalar t107 = Scalar(2452.5) * c_7;
  const Scalar t108 = Scalar(97.25) * t106 - Scalar(5.0) * U_9_zx + c_8 * t107;
  const Scalar t109 = omega_r_9_x * omega_r_9_x;
  const Scalar t110 = omega_9_z * omega_9_z;
  const Scalar t111 = t106 - t109 + t110;
  const Scalar t112 = t100 * t103;
  const Scalar ddp_o_9_x = Scalar(97.25) * t112 + s_8 * t107;
  const Scalar t113 = qd_8 * t103;
  const Scalar ddp_9_a_y = Scalar(2452.5) * s_7 - Scalar(194.5) * t113;
  const Scalar t114 = s_9 * ddp_o_9_x - c_9 * ddp_9_a_y;
  const Scalar ddp_o_10_x = Scalar(5.0) * t111 + t114;
  const Scalar t115 = s_10 * ddp_o_10_x + c_10 * t108;
  const Scalar t116 = s_10 * omega_r_9_x + c_10 * omega_9_z;
  const Scalar t117 = t116 * t116;
  const Scalar t118 = c_9 * t100;
  const Scalar t119 = s_9 * qd_8;
  const Scalar t120 = t119 - t118;
  const Scalar omega_10_z = qd_10 - t120;
  const Scalar t121 = omega_10_z * omega_10_z;
  const Scalar t122 = s_10 * omega_9_z - c_10 * omega_r_9_x;
  const Scalar t123 = t116 * t122;
  const Scalar U_10_xy = t105 - t123;
  const Scalar t124 = Scalar(10.0) * U_10_xy + t115 + Scalar(89.25) * (t109 + t110 + t121 - t117);
  const Scalar t125 = t116 * omega_10_z;
  const Scalar t126 = omega_r_9_x * t120;
  const Scalar t127 = qd_8 * t100;
  const Scalar t128 = t126 - t127;
  const Scalar t129 = (Scalar(2.0) * t119 - t118) * t103;
  const Scalar t130 = t129 + Scalar(2.0) * t120 * omega_9_z;
  const Scalar t131 = s_10 * t128 + t125 + c_10 * t130;
  const Scalar t132 = t125 + t131;
  const Scalar t133 = s_10 * t130 - c_10 * t128 + Scalar(2.0) * t122 * omega_10_z;
  const Scalar t134 = t126 + t127;
  const Scalar ddp_9_y = c_9 * ddp_o_9_x + s_9 * ddp_9_a_y;
  const Scalar ddp_o_10_y = Scalar(5.0) * t134 + ddp_9_y;
  const Scalar t135 = Scalar(10.0) * t133 - ddp_o_10_y + Scalar(89.25) * t132;
  const Scalar t136 = s_11 * t135 + c_11 * t124;
  const Scalar t137 = Scalar(0.00018) * c_12 - Scalar(0.00042) * s_12;
  const Scalar omega_r_11_y = s_11 * t116 + c_11 * omega_10_z;
  const Scalar omega_12_z = qd_12 + omega_r_11_y;
  const Scalar t138 = omega_12_z * omega_12_z;
  const Scalar omega_11_z = qd_11 - t122;
  const Scalar t139 = t138 + omega_11_z * omega_11_z;
  const Scalar t140 = s_11 * omega_10_z - c_11 * t116;
  const Scalar t141 = t140 * t140 + t138;
  const Scalar t142 = Scalar(0.0063) * c_12 - Scalar(0.0012) * s_12;
  const Scalar I_12_xy = c_12 * t142 - Scalar(0.00315);
  const Scalar t143 = t140 * omega_11_z;
  const Scalar t144 = t143 + c_11 * U_10_xy + s_11 * t133;
  const Scalar t145 = t143 - t144;
  const Scalar t146 = s_12 * t142;
  const Scalar t147 = t146 - Scalar(0.006558333333335);
  const Scalar t148 = t143 + t144;
  const Scalar I_12_yy = t146 + Scalar(0.007758333333335);
  const Scalar t149 = s_10 * t108 - c_10 * ddp_o_10_x;
  const Scalar t150 = t105 + t123;
  const Scalar Uz_o_11_y = t121 + t117;
  const Scalar ddp_11_a_z = Scalar(89.25) * t150 - Scalar(10.0) * Uz_o_11_y - t149;
  const Scalar mr_12_x = Scalar(0.00018) * s_12 + Scalar(0.00042) * c_12;
  const Scalar t151 = I_12_xy * (t139 - t141) + t145 * t147 + t148 * I_12_yy + t137 * t136 +
      mr_12_x * ddp_11_a_z;
  n[11] = -t151;
  const Scalar t152 = s_11 * t124 - c_11 * t135;
  const Scalar t153 = Scalar(2.0) * omega_11_z;
  const Scalar U_11_zy = omega_r_11_y * t153 - s_11 * U_10_xy + c_11 * t133;
  const Scalar t154 = U_11_zy - t153 * omega_12_z;
  const Scalar t155 = t140 * omega_r_11_y;
  const Scalar t156 = t155 + t131;
  const Scalar t157 = t156 - Scalar(2.0) * t140 * omega_12_z;
  const Scalar t158 = Scalar(0.00032) * (t131 - t155) + Scalar(0.001328333333335) * t156 +
      t154 * I_12_xy + t157 * I_12_yy - mr_12_x * t152;
  n[10] = -t158;
  const Scalar t159 = s_5 * t72 - c_5 * t83;
  const Scalar t160 = Scalar(2.0) * omega_5_z;
  const Scalar U_5_zy = omega_r_5_y * t160 - s_5 * U_4_xy + c_5 * t81;
  const Scalar t161 = U_5_zy - t160 * omega_6_z;
  const Scalar t162 = t88 * omega_r_5_y;
  const Scalar t163 = t162 + t79;
  const Scalar t164 = t163 - Scalar(2.0) * t88 * omega_6_z;
  const Scalar t165 = Scalar(0.00032) * (t79 - t162) + Scalar(0.001328333333335) * t163 +
      t161 * I_6_xy + t164 * I_6_yy - mr_6_x * t159;
  n[4] = -t165;
  const Scalar mu_17_y = Scalar(0.00025) * U_18_yx + n_18;
  const Scalar mu_17_x = Scalar(0.00509) * U_17_zy - t47 * t13 + t43 * I_18_xx + t38 * t44;
  const Scalar mu_u_16_x = Scalar(0.0003125) * (domega_15_x - t23) + Scalar(0.0005625) * U_16_xy -
      s_17 * mu_17_y + c_17 * mu_17_x;
  n[15] = -mu_u_16_x;
  const Scalar t166 = Scalar(0.00032) * t148 + t151;
  const Scalar t167 = -mr_12_x * t157 - t137 * t154 + Scalar(0.0000615126050420168) * t152;
  const Scalar t168 = mr_12_x * t139 - t137 * t145 + Scalar(0.0000615126050420168) * t136;
  const Scalar t169 = s_11 * t167 + c_11 * t168;
  const Scalar mu_11_x = Scalar(0.001328333333335) * U_11_zy + t157 * I_12_xy - t154 * t147 -
      t137 * t152;
  const Scalar f_11_z = mr_12_x * t148 - t137 * t141 + Scalar(0.0000615126050420168) * ddp_11_a_z;
  const Scalar t170 = Scalar(0.008593739495798319) * U_10_xy +
      Scalar(0.0002648739495798319) * t115 - s_11 * mu_11_x + c_11 * t166 - Scalar(0.06566) * t150 +
      Scalar(10.0) * t169 + Scalar(89.25) * f_11_z;
  n[9] = -t170;
  const Scalar t171 = Scalar(0.00032) * t96 + t99;
  const Scalar t172 = -mr_6_x * t164 - t85 * t161 + Scalar(0.0000615126050420168) * t159;
  const Scalar t173 = mr_6_x * t87 - t85 * t93 + Scalar(0.0000615126050420168) * t84;
  const Scalar t174 = s_5 * t172 + c_5 * t173;
  const Scalar mu_5_x = Scalar(0.001328333333335) * U_5_zy + t164 * I_6_xy - t161 * t95 -
      t85 * t159;
  const Scalar f_5_z = mr_6_x * t96 - t85 * t89 + Scalar(0.0000615126050420168) * ddp_5_a_z;
  const Scalar t175 = Scalar(0.008593739495798319) * U_4_xy + Scalar(0.0002648739495798319) * t63 -
      s_5 * mu_5_x + c_5 * t171 - Scalar(0.06566) * t98 + Scalar(10.0) * t174 +
      Scalar(89.25) * f_5_z;
  n[3] = -t175;
  const Scalar t176 = s_11 * t168 - c_11 * t167;
  const Scalar t177 = Scalar(0.008593739495798319) * t133 -
      Scalar(0.0002648739495798319) * ddp_o_10_y + s_11 * t166 + c_11 * mu_11_x +
      Scalar(10.0) * t176;
  const Scalar t178 = Scalar(0.06566) * t132 - t158 - Scalar(89.25) * t176;
  const Scalar t179 = Scalar(0.0002648739495798319) * t133 -
      Scalar(2.4873949579831934e-06) * ddp_o_10_y + t176;
  const Scalar n_9 = Scalar(0.00605) * t128 - Scalar(0.006525) * t134 + Scalar(0.00507) * t129 +
      Scalar(5.0) * t179 - c_10 * t177 - s_10 * t178;
  n[8] = n_9;
  const Scalar t180 = s_5 * t173 - c_5 * t172;
  const Scalar t181 = Scalar(0.008593739495798319) * t81 -
      Scalar(0.0002648739495798319) * ddp_o_4_y + s_5 * t171 + c_5 * mu_5_x + Scalar(10.0) * t180;
  const Scalar t182 = Scalar(0.06566) * t80 - t165 - Scalar(89.25) * t180;
  const Scalar t183 = Scalar(0.0002648739495798319) * t81 -
      Scalar(2.4873949579831934e-06) * ddp_o_4_y + t180;
  const Scalar n_3 = Scalar(0.00605) * t76 - Scalar(0.006525) * t82 + Scalar(0.00507) * t77 +
      Scalar(5.0) * t183 - c_4 * t181 - s_4 * t182;
  n[2] = n_3;
  const Scalar t184 = Scalar(0.0002648739495798319) * U_10_xy +
      Scalar(2.4873949579831934e-06) * t115 + t169;
  const Scalar f_10_y = Scalar(0.0002648739495798319) * Uz_o_11_y +
      Scalar(2.4873949579831934e-06) * t149 - f_11_z;
  const Scalar t185 = Scalar(0.000051146529562982) * t114 + s_10 * t184 - c_10 * f_10_y;
  const Scalar f_9_y = Scalar(0.000051146529562982) * ddp_9_y - t179;
  const Scalar f_u_9_t_x = s_9 * t185 + c_9 * f_9_y;
  const Scalar f_u_10_a_z = s_10 * f_10_y + c_10 * t184;
  const Scalar t186 = Scalar(0.006525) * U_9_zx - Scalar(0.00507) * (t106 - t111) -
      Scalar(5.0) * f_u_10_a_z + t170;
  const Scalar mu_9_x = Scalar(0.00507) * t134 - Scalar(0.00605) * t130 - s_10 * t177 + c_10 * t178;
  n[7] = c_9 * mu_9_x - Scalar(0.08264) * t112 + s_9 * t186 + Scalar(97.25) * f_u_9_t_x;
  const Scalar t187 = Scalar(0.0002648739495798319) * U_4_xy +
      Scalar(2.4873949579831934e-06) * t63 + t174;
  const Scalar f_4_y = Scalar(0.0002648739495798319) * Uz_o_5_y +
      Scalar(2.4873949579831934e-06) * t97 - f_5_z;
  const Scalar t188 = Scalar(0.000051146529562982) * t62 + s_4 * t187 - c_4 * f_4_y;
  const Scalar f_3_y = Scalar(0.000051146529562982) * ddp_3_y - t183;
  const Scalar f_u_3_t_x = s_3 * t188 + c_3 * f_3_y;
  const Scalar f_u_4_a_z = s_4 * f_4_y + c_4 * t187;
  const Scalar t189 = Scalar(0.006525) * U_3_zx - Scalar(0.00507) * (t54 - t59) -
      Scalar(5.0) * f_u_4_a_z + t175;
  const Scalar mu_3_x = Scalar(0.00507) * t82 - Scalar(0.00605) * t78 - s_4 * t181 + c_4 * t182;
  n[1] = c_3 * mu_3_x - Scalar(0.08264) * t60 + s_3 * t189 + Scalar(97.25) * f_u_3_t_x;
  const Scalar f_u_9_t_y = s_9 * f_9_y - c_9 * t185;
  const Scalar mu_8_x = Scalar(0.16332) * t113 + s_9 * mu_9_x - c_9 * t186 +
      Scalar(97.25) * f_u_9_t_y;
  n[6] = s_8 * (Scalar(0.00196) * t127 - n_9) + c_8 * mu_8_x;
  const Scalar f_u_3_t_y = s_3 * f_3_y - c_3 * t188;
  const Scalar mu_2_x = Scalar(0.16332) * t61 + s_3 * mu_3_x - c_3 * t189 +
      Scalar(97.25) * f_u_3_t_y;
  n[0] = s_2 * (Scalar(0.00196) * t75 - n_3) + c_2 * mu_2_x;
  const Scalar t190 = Scalar(82.5) * t17 + t29;
  const Scalar U_15_zy = t24 + domega_15_x;
  const Scalar t191 = Scalar(60.0) * U_15_zy;
  const Scalar t192 = t190 - t191;
  const Scalar t193 = Scalar(82.5) * Uz_o_16_x - t36;
  const Scalar U_15_xy = t18 + t19;
  const Scalar t194 = Scalar(60.0) * U_15_xy;
  const Scalar t195 = t194 + t193;
  const Scalar ddp_26_x = s_26 * t192 + c_26 * t195;
  const Scalar t196 = s_26 * omega_15_z - c_26 * t8;
  const Scalar omega_26_z = qd_26 + omega_r_15_y;
  const Scalar t197 = t196 * omega_26_z;
  const Scalar domega_26_y = c_26 * U_15_xy + t197 - s_26 * U_15_zy;
  const Scalar omega_r_27_x = s_27 * t196 + c_27 * omega_26_z;
  const Scalar t198 = s_27 * omega_26_z - c_27 * t196;
  const Scalar t199 = omega_r_27_x * t198;
  const Scalar U_27_xy = domega_26_y - t199;
  const Scalar t200 = Scalar(82.5) * t20 - t31;
  const Scalar t201 = t33 + t34;
  const Scalar t202 = Scalar(60.0) * t201;
  const Scalar t203 = t202 + t200;
  const Scalar t204 = Scalar(76.25) * U_27_xy + s_27 * ddp_26_x + c_27 * t203;
  const Scalar t205 = s_26 * t195 - c_26 * t192;
  const Scalar omega_r_27_a_z = s_26 * t8 + c_26 * omega_15_z;
  const Scalar t206 = -s_26 * U_15_xy - c_26 * U_15_zy + Scalar(2.0) * omega_r_27_a_z * omega_26_z;
  const Scalar omega_27_z = qd_27 + omega_r_27_a_z;
  const Scalar t207 = t196 * omega_r_27_a_z;
  const Scalar t208 = t16 + t207;
  const Scalar t209 = c_27 * t208 + Scalar(2.0) * t198 * omega_27_z - s_27 * t206;
  const Scalar t210 = t205 + Scalar(76.25) * t209;
  const Scalar t211 = s_28 * t204 - c_28 * t210;
  const Scalar omega_r_28_x = s_28 * omega_r_27_x + c_28 * omega_27_z;
  const Scalar t212 = omega_r_28_x * omega_r_28_x;
  const Scalar t213 = omega_r_27_x * omega_r_27_x + omega_27_z * omega_27_z;
  const Scalar omega_28_z = qd_28 - t198;
  const Scalar t214 = omega_28_z * omega_28_z;
  const Scalar t215 = t213 - t212 + t214;
  const Scalar t216 = t215 + t211;
  const Scalar t217 = omega_r_28_x * omega_28_z;
  const Scalar t218 = t217 - s_28 * U_27_xy + c_28 * t209;
  const Scalar U_28_zx = t217 + t218;
  const Scalar ddp_o_28_y = Scalar(76.25) * t213 + s_27 * t203 - c_27 * ddp_26_x;
  const Scalar ddp_o_29_z = U_28_zx + ddp_o_28_y;
  const Scalar t219 = s_29 * ddp_o_29_z + c_29 * t216;
  const Scalar t220 = s_29 * omega_28_z - c_29 * omega_r_28_x;
  const Scalar t221 = t220 * t220;
  const Scalar t222 = s_28 * omega_27_z - c_28 * omega_r_27_x;
  const Scalar omega_29_z = qd_29 - t222;
  const Scalar t223 = omega_29_z * omega_29_z;
  const Scalar t224 = t212 + t214 + t223 - t221;
  const Scalar omega_r_30_a_z = s_29 * omega_r_28_x + c_29 * omega_28_z;
  const Scalar t225 = t220 * omega_r_30_a_z;
  const Scalar t226 = t225 + t218;
  const Scalar ddp_o_30_x = t224 + Scalar(59.75) * t226 - t219;
  const Scalar Uz_28_y = c_28 * U_27_xy + s_28 * t209;
  const Scalar t227 = Uz_28_y + Scalar(2.0) * t222 * omega_28_z;
  const Scalar t228 = t220 * omega_29_z;
  const Scalar t229 = omega_r_27_x * omega_27_z;
  const Scalar t230 = t229 - s_27 * t208 - c_27 * t206;
  const Scalar t231 = omega_r_28_x * t222;
  const Scalar t232 = t230 - t231;
  const Scalar t233 = t228 + c_29 * t232 + s_29 * t227;
  const Scalar t234 = t228 + t233;
  const Scalar Uz_o_30_z = Scalar(2.0) * omega_r_30_a_z * omega_29_z - s_29 * t232 + c_29 * t227;
  const Scalar t235 = c_28 * t204 + s_28 * t210;
  const Scalar t236 = t231 + t230;
  const Scalar t237 = t236 + t235;
  const Scalar t238 = t234 - Scalar(59.75) * Uz_o_30_z - t237;
  const Scalar t239 = s_30 * ddp_o_30_x - c_30 * t238;
  const Scalar t240 = s_29 * t216 - c_29 * ddp_o_29_z;
  const Scalar t241 = t218 - t225;
  const Scalar Uz_o_30_y = t223 + t221;
  const Scalar t242 = t241 - Scalar(59.75) * Uz_o_30_y + t240;
  const Scalar ddp_31_y = s_31 * t239 - c_31 * t242;
  const Scalar omega_r_31_a_z = s_30 * omega_29_z - c_30 * t220;
  const Scalar omega_30_z = qd_30 + omega_r_30_a_z;
  const Scalar t243 = c_30 * t226 + Scalar(2.0) * omega_r_31_a_z * omega_30_z - s_30 * Uz_o_30_z;
  const Scalar omega_r_30_x = s_30 * t220 + c_30 * omega_29_z;
  const Scalar t244 = omega_r_30_x * omega_r_31_a_z;
  const Scalar t245 = t233 - t244;
  const Scalar t246 = s_31 * omega_r_30_x - c_31 * omega_30_z;
  const Scalar omega_31_z = qd_31 + omega_r_31_a_z;
  const Scalar t247 = Scalar(2.0) * omega_31_z;
  const Scalar t248 = t246 * t247 + s_31 * t245 + c_31 * t243;
  const Scalar omega_32_z = qd_32 - t246;
  const Scalar t249 = t247 * omega_32_z + t248;
  const Scalar t250 = s_32 * t249;
  const Scalar t251 = omega_32_z * omega_32_z;
  const Scalar t252 = omega_31_z * omega_31_z;
  const Scalar t253 = t252 + t251;
  const Scalar omega_r_31_x = s_31 * omega_30_z + c_31 * omega_r_30_x;
  const Scalar t254 = omega_r_31_x * omega_r_31_x;
  const Scalar t255 = t252 + t254;
  const Scalar t256 = Scalar(0.0000376) * c_32;
  const Scalar t257 = t256 * (Scalar(13.553191489361701) *
      (Scalar(1.468210361067504) * (t255 - t253) - t250) + ddp_31_y);
  const Scalar t258 = s_31 * t242 + c_31 * t239;
  const Scalar t259 = omega_r_31_x * omega_31_z;
  const Scalar t260 = t259 - s_31 * t243 + c_31 * t245;
  const Scalar t261 = t259 - t260;
  const Scalar t262 = Scalar(0.0007482) * s_32;
  const Scalar t263 = omega_r_30_x * omega_30_z;
  const Scalar t264 = t263 - s_30 * t226 - c_30 * Uz_o_30_z;
  const Scalar t265 = omega_r_31_x * t246;
  const Scalar t266 = t265 + t264;
  const Scalar t267 = t266 + Scalar(2.0) * omega_r_31_x * omega_32_z;
  const Scalar t268 = Scalar(0.0005096) * s_32 * s_32;
  const Scalar I_32_yy = t268 + Scalar(0.0004516500000001);
  const Scalar n_31 = Scalar(0.00016) * (t264 - t265) + t267 * I_32_yy + t261 * t262 - t257 +
      Scalar(0.0247118500000001) * t266 - Scalar(0.0007608) * t258;
  n[30] = n_31;
  const Scalar ddp_19_a_y = t191 + t190;
  const Scalar t269 = t193 - t194;
  const Scalar t270 = s_19 * ddp_19_a_y + c_19 * t269;
  const Scalar t271 = s_19 * omega_15_z - c_19 * t8;
  const Scalar omega_19_z = qd_19 + omega_r_15_y;
  const Scalar t272 = t271 * omega_19_z;
  const Scalar domega_19_y = c_19 * U_15_xy + t272 - s_19 * U_15_zy;
  const Scalar omega_r_20_x = s_20 * t271 + c_20 * omega_19_z;
  const Scalar t273 = s_20 * omega_19_z - c_20 * t271;
  const Scalar t274 = omega_r_20_x * t273;
  const Scalar U_20_xy = domega_19_y - t274;
  const Scalar t275 = t200 - t202;
  const Scalar t276 = Scalar(76.25) * U_20_xy + s_20 * t270 + c_20 * t275;
  const Scalar t277 = s_19 * t269 - c_19 * ddp_19_a_y;
  const Scalar omega_r_20_a_z = s_19 * t8 + c_19 * omega_15_z;
  const Scalar t278 = -s_19 * U_15_xy - c_19 * U_15_zy + Scalar(2.0) * omega_r_20_a_z * omega_19_z;
  const Scalar omega_20_z = qd_20 + omega_r_20_a_z;
  const Scalar t279 = t271 * omega_r_20_a_z;
  const Scalar t280 = t16 + t279;
  const Scalar t281 = c_20 * t280 + Scalar(2.0) * t273 * omega_20_z - s_20 * t278;
  const Scalar t282 = t277 + Scalar(76.25) * t281;
  const Scalar t283 = s_21 * t276 - c_21 * t282;
  const Scalar omega_r_21_x = s_21 * omega_r_20_x + c_21 * omega_20_z;
  const Scalar t284 = omega_r_21_x * omega_r_21_x;
  const Scalar t285 = omega_r_20_x * omega_r_20_x + omega_20_z * omega_20_z;
  const Scalar omega_21_z = qd_21 - t273;
  const Scalar t286 = omega_21_z * omega_21_z;
  const Scalar t287 = t285 - t284 + t286;
  const Scalar t288 = t287 + t283;
  const Scalar t289 = omega_r_21_x * omega_21_z;
  const Scalar t290 = t289 - s_21 * U_20_xy + c_21 * t281;
  const Scalar U_21_zx = t289 + t290;
  const Scalar ddp_o_21_y = Scalar(76.25) * t285 + s_20 * t275 - c_20 * t270;
  const Scalar ddp_o_22_z = U_21_zx + ddp_o_21_y;
  const Scalar t291 = s_22 * ddp_o_22_z + c_22 * t288;
  const Scalar t292 = s_22 * omega_21_z - c_22 * omega_r_21_x;
  const Scalar t293 = t292 * t292;
  const Scalar t294 = s_21 * omega_20_z - c_21 * omega_r_20_x;
  const Scalar omega_22_z = qd_22 - t294;
  const Scalar t295 = omega_22_z * omega_22_z;
  const Scalar t296 = t284 + t286 + t295 - t293;
  const Scalar omega_r_23_a_z = s_22 * omega_r_21_x + c_22 * omega_21_z;
  const Scalar t297 = t292 * omega_r_23_a_z;
  const Scalar t298 = t297 + t290;
  const Scalar ddp_o_23_x = t296 + Scalar(59.75) * t298 - t291;
  const Scalar Uz_21_y = c_21 * U_20_xy + s_21 * t281;
  const Scalar t299 = Uz_21_y + Scalar(2.0) * t294 * omega_21_z;
  const Scalar t300 = t292 * omega_22_z;
  const Scalar t301 = omega_r_20_x * omega_20_z;
  const Scalar t302 = t301 - s_20 * t280 - c_20 * t278;
  const Scalar t303 = omega_r_21_x * t294;
  const Scalar t304 = t302 - t303;
  const Scalar t305 = t300 + c_22 * t304 + s_22 * t299;
  const Scalar t306 = t300 + t305;
  const Scalar Uz_o_23_z = Scalar(2.0) * omega_r_23_a_z * omega_22_z - s_22 * t304 + c_22 * t299;
  const Scalar t307 = c_21 * t276 + s_21 * t282;
  const Scalar t308 = t303 + t302;
  const Scalar t309 = t308 + t307;
  const Scalar t310 = t306 - Scalar(59.75) * Uz_o_23_z - t309;
  const Scalar t311 = s_23 * ddp_o_23_x - c_23 * t310;
  const Scalar t312 = s_22 * t288 - c_22 * ddp_o_22_z;
  const Scalar t313 = t290 - t297;
  const Scalar Uz_o_23_y = t295 + t293;
  const Scalar t314 = t313 - Scalar(59.75) * Uz_o_23_y + t312;
  const Scalar ddp_24_y = s_24 * t311 - c_24 * t314;
  const Scalar omega_r_24_a_z = s_23 * omega_22_z - c_23 * t292;
  const Scalar omega_23_z = qd_23 + omega_r_23_a_z;
  const Scalar t315 = c_23 * t298 + Scalar(2.0) * omega_r_24_a_z * omega_23_z - s_23 * Uz_o_23_z;
  const Scalar omega_r_23_x = s_23 * t292 + c_23 * omega_22_z;
  const Scalar t316 = omega_r_23_x * omega_r_24_a_z;
  const Scalar t317 = t305 - t316;
  const Scalar t318 = s_24 * omega_r_23_x - c_24 * omega_23_z;
  const Scalar omega_24_z = qd_24 + omega_r_24_a_z;
  const Scalar t319 = Scalar(2.0) * omega_24_z;
  const Scalar t320 = t318 * t319 + s_24 * t317 + c_24 * t315;
  const Scalar omega_25_z = qd_25 - t318;
  const Scalar t321 = t319 * omega_25_z + t320;
  const Scalar t322 = s_25 * t321;
  const Scalar t323 = omega_25_z * omega_25_z;
  const Scalar t324 = omega_24_z * omega_24_z;
  const Scalar t325 = t324 + t323;
  const Scalar omega_r_24_x = s_24 * omega_23_z + c_24 * omega_r_23_x;
  const Scalar t326 = omega_r_24_x * omega_r_24_x;
  const Scalar t327 = t324 + t326;
  const Scalar t328 = Scalar(0.0000376) * c_25;
  const Scalar t329 = t328 * (Scalar(13.553191489361701) *
      (Scalar(1.468210361067504) * (t327 - t325) + t322) + ddp_24_y);
  const Scalar t330 = s_24 * t314 + c_24 * t311;
  const Scalar t331 = omega_r_24_x * omega_24_z;
  const Scalar t332 = t331 - s_24 * t315 + c_24 * t317;
  const Scalar t333 = t331 - t332;
  const Scalar t334 = Scalar(0.0007482) * s_25;
  const Scalar t335 = omega_r_23_x * omega_23_z;
  const Scalar t336 = t335 - s_23 * t298 - c_23 * Uz_o_23_z;
  const Scalar t337 = omega_r_24_x * t318;
  const Scalar t338 = t337 + t336;
  const Scalar t339 = t338 + Scalar(2.0) * omega_r_24_x * omega_25_z;
  const Scalar t340 = Scalar(0.0005096) * s_25 * s_25;
  const Scalar I_25_yy = t340 + Scalar(0.0004516500000001);
  const Scalar n_24 = Scalar(0.00016) * (t336 - t337) + t339 * I_25_yy - t333 * t334 + t329 +
      Scalar(0.0247118500000001) * t338 - Scalar(0.0007608) * t330;
  n[23] = n_24;
  const Scalar t341 = (t338 - Scalar(0.05025394279604384) * t330) * t334;
  const Scalar t342 = t326 + t323;
  const Scalar ddp_24_a_z = s_23 * t310 + c_23 * ddp_o_23_x;
  const Scalar t343 = (Scalar(19.898936170212767) *
      (Scalar(0.6811013098102112) * s_25 * (t325 - t342) + t320) + ddp_24_a_z) * t328;
  const Scalar t344 = t340 - Scalar(0.0009612500000001);
  const Scalar U_24_zx = t331 + t332;
  const Scalar t345 = U_24_zx * I_25_yy + t333 * t344 + t341 + t343;
  n[24] = -t345;
  const Scalar t346 = (t266 - Scalar(0.05025394279604384) * t258) * t262;
  const Scalar t347 = t254 + t251;
  const Scalar ddp_31_a_z = s_30 * t238 + c_30 * ddp_o_30_x;
  const Scalar t348 = (Scalar(19.898936170212767) *
      (t248 - Scalar(0.6811013098102112) * s_32 * (t253 - t347)) + ddp_31_a_z) * t256;
  const Scalar t349 = t268 - Scalar(0.0009612500000001);
  const Scalar U_31_zx = t259 + t260;
  const Scalar t350 = U_31_zx * I_32_yy + t261 * t349 - t346 - t348;
  n[31] = -t350;
  const Scalar t351 = Scalar(0.00016) * U_31_zx + t350;
  const Scalar t352 = c_32 * t267;
  const Scalar U_32_yy_zz = t255 - t347;
  const Scalar t353 = s_32 * (Scalar(13.553191489361701) *
      (t352 + Scalar(1.468210361067504) * U_32_yy_zz) + ddp_31_y);
  const Scalar t354 = c_32 * U_31_zx;
  const Scalar t355 = Scalar(0.0000376) * t353 - Scalar(0.0007482) * t354 - t249 * t349 +
      Scalar(0.0247118500000001) * t248 + Scalar(0.0007608) * ddp_31_a_z;
  const Scalar t356 = Scalar(0.00048) * t245 + Scalar(0.00032) * (t244 + t233) + c_31 * t351 +
      s_31 * t355;
  n[29] = -t356;
  const Scalar t357 = Scalar(0.00016) * U_24_zx + t345;
  const Scalar t358 = c_25 * t339;
  const Scalar U_25_yy_zz = t327 - t342;
  const Scalar t359 = s_25 * (Scalar(13.553191489361701) *
      (Scalar(1.468210361067504) * U_25_yy_zz - t358) + ddp_24_y);
  const Scalar t360 = c_25 * U_24_zx;
  const Scalar t361 = Scalar(0.0007482) * t360 - t321 * t344 - Scalar(0.0000376) * t359 +
      Scalar(0.0247118500000001) * t320 + Scalar(0.0007608) * ddp_24_a_z;
  const Scalar t362 = Scalar(0.00048) * t317 + Scalar(0.00032) * (t316 + t305) + c_24 * t357 +
      s_24 * t361;
  n[22] = -t362;
  const Scalar t363 = Scalar(0.00048) * t243 - s_31 * t351 + c_31 * t355;
  const Scalar f_31_y = Scalar(0.0000376) * (t250 - t352) + Scalar(0.0007608) * t255;
  const Scalar t364 = Scalar(0.0000376) * (c_32 * t253 + s_32 * t261) + Scalar(0.0007608) * t266;
  const Scalar t365 = s_31 * f_31_y - c_31 * t364 + Scalar(0.0001312) * t239;
  const Scalar t366 = Scalar(0.0007608) * t248 - Scalar(0.0000376) * (s_32 * t347 + t354) +
      Scalar(0.0001312) * ddp_31_a_z;
  const Scalar f_u_30_t_x = s_30 * t365 + c_30 * t366;
  const Scalar U_30_zx = t263 + t264;
  const Scalar t367 = Scalar(0.00032) * U_30_zx + n_31;
  const Scalar t368 = -c_31 * f_31_y - s_31 * t364 + Scalar(0.0001312) * t242;
  const Scalar n_29 = Scalar(0.00278) * (t224 - Uz_o_30_y) - Scalar(0.00167) * t241 - t368 -
      c_30 * t363 + s_30 * t367 + Scalar(0.26596) * t226 - Scalar(0.00438) * t219 -
      Scalar(59.75) * f_u_30_t_x;
  n[28] = n_29;
  const Scalar t369 = Scalar(0.00048) * t315 - s_24 * t357 + c_24 * t361;
  const Scalar f_24_y = Scalar(0.0007608) * t327 - Scalar(0.0000376) * (t322 - t358);
  const Scalar t370 = Scalar(0.0007608) * t338 - Scalar(0.0000376) * (c_25 * t325 + s_25 * t333);
  const Scalar t371 = s_24 * f_24_y - c_24 * t370 + Scalar(0.0001312) * t311;
  const Scalar t372 = Scalar(0.0000376) * (s_25 * t342 + t360) + Scalar(0.0007608) * t320 +
      Scalar(0.0001312) * ddp_24_a_z;
  const Scalar f_u_23_t_x = s_23 * t371 + c_23 * t372;
  const Scalar U_23_zx = t335 + t336;
  const Scalar t373 = Scalar(0.00032) * U_23_zx + n_24;
  const Scalar t374 = -c_24 * f_24_y - s_24 * t370 + Scalar(0.0001312) * t314;
  const Scalar n_22 = Scalar(0.00278) * (t296 - Uz_o_23_y) - Scalar(0.00167) * t313 - t374 -
      c_23 * t369 + s_23 * t373 + Scalar(0.26596) * t298 - Scalar(0.00438) * t291 -
      Scalar(59.75) * f_u_23_t_x;
  n[21] = n_22;
  const Scalar t375 = s_30 * t366 - c_30 * t365;
  const Scalar t376 = Scalar(0.00278) * t234 - s_30 * t363 - c_30 * t367 -
      Scalar(0.26596) * Uz_o_30_z - Scalar(0.00438) * t237 - Scalar(59.75) * t375;
  const Scalar t377 = Scalar(0.00167) * t234 + Scalar(0.00278) * Uz_o_30_z + t375 + t356;
  const Scalar f_29_z = Scalar(0.00438) * Uz_o_30_z + Scalar(0.000144) * t237 + t375;
  const Scalar t378 = Scalar(0.0023) * Uz_28_y + Scalar(0.00393) * t236 + Scalar(0.00405) * t232 -
      f_29_z + c_29 * t377 - s_29 * t376;
  n[27] = -t378;
  const Scalar t379 = s_23 * t372 - c_23 * t371;
  const Scalar t380 = Scalar(0.00278) * t306 - s_23 * t369 - c_23 * t373 -
      Scalar(0.26596) * Uz_o_23_z - Scalar(0.00438) * t309 - Scalar(59.75) * t379;
  const Scalar t381 = Scalar(0.00167) * t306 + Scalar(0.00278) * Uz_o_23_z + t379 + t362;
  const Scalar f_22_z = Scalar(0.00438) * Uz_o_23_z + Scalar(0.000144) * t309 + t379;
  const Scalar t382 = Scalar(0.0023) * Uz_21_y + Scalar(0.00393) * t308 + Scalar(0.00405) * t304 -
      f_22_z + c_22 * t381 - s_22 * t380;
  n[20] = -t382;
  const Scalar t383 = Scalar(0.0023) * t236 + Scalar(0.00405) * t227 + s_29 * t377 + c_29 * t376;
  const Scalar t384 = Scalar(0.00438) * t226 - Scalar(0.000144) * t219 - f_u_30_t_x;
  const Scalar f_29_y = Scalar(0.00438) * Uz_o_30_y - Scalar(0.000144) * t240 + t368;
  const Scalar t385 = Scalar(0.0000999344262295082) * t211 + s_29 * f_29_y + c_29 * t384;
  const Scalar t386 = Scalar(0.0000999344262295082) * t235 - f_29_z;
  const Scalar t387 = s_28 * t385 + c_28 * t386;
  const Scalar t388 = s_29 * t384 - c_29 * f_29_y;
  const Scalar t389 = Scalar(0.0023) * (t213 - t215) + Scalar(0.00393) * U_28_zx + t388 - n_29;
  const Scalar mu_27_z = Scalar(0.03177) * U_27_xy - Scalar(0.00098) * (t199 + domega_26_y) +
      s_28 * t389 - c_28 * t383 - Scalar(76.25) * t387;
  n[26] = mu_27_z;
  const Scalar t390 = Scalar(0.0023) * t308 + Scalar(0.00405) * t299 + s_22 * t381 + c_22 * t380;
  const Scalar t391 = Scalar(0.00438) * t298 - Scalar(0.000144) * t291 - f_u_23_t_x;
  const Scalar f_22_y = Scalar(0.00438) * Uz_o_23_y - Scalar(0.000144) * t312 + t374;
  const Scalar t392 = Scalar(0.0000999344262295082) * t283 + s_22 * f_22_y + c_22 * t391;
  const Scalar t393 = Scalar(0.0000999344262295082) * t307 - f_22_z;
  const Scalar t394 = s_21 * t392 + c_21 * t393;
  const Scalar t395 = s_22 * t391 - c_22 * f_22_y;
  const Scalar t396 = Scalar(0.0023) * (t285 - t287) + Scalar(0.00393) * U_21_zx + t395 - n_22;
  const Scalar mu_20_z = Scalar(0.03177) * U_20_xy - Scalar(0.00098) * (t274 + domega_19_y) +
      s_21 * t396 - c_21 * t390 - Scalar(76.25) * t394;
  n[19] = mu_20_z;
  const Scalar t397 = s_28 * t386 - c_28 * t385;
  const Scalar t398 = Scalar(0.03177) * t209 - s_28 * t383 - c_28 * t389 - Scalar(76.25) * t397;
  const Scalar U_27_zx = t229 + t230;
  const Scalar t399 = Scalar(0.00098) * U_27_zx + t378;
  const Scalar t400 = Scalar(0.00098) * (t16 - t207) + Scalar(0.00196) * t208 - s_27 * t399 -
      c_27 * t398;
  n[25] = -t400;
  const Scalar t401 = s_21 * t393 - c_21 * t392;
  const Scalar t402 = Scalar(0.03177) * t281 - s_21 * t390 - c_21 * t396 - Scalar(76.25) * t401;
  const Scalar U_20_zx = t301 + t302;
  const Scalar t403 = Scalar(0.00098) * U_20_zx + t382;
  const Scalar t404 = Scalar(0.00098) * (t16 - t279) + Scalar(0.00196) * t280 - s_20 * t403 -
      c_20 * t402;
  n[18] = -t404;
  const Scalar f_28_z = Scalar(0.0000999344262295082) * ddp_o_28_y + t388;
  const Scalar f_26_x = Scalar(0.00016042921013412816) * ddp_26_x - c_27 * f_28_z + s_27 * t387;
  const Scalar t405 = Scalar(0.00016042921013412816) * t205 + t397;
  const Scalar f_21_z = Scalar(0.0000999344262295082) * ddp_o_21_y + t395;
  const Scalar t406 = Scalar(0.000044065573770491804) * t270 - c_20 * f_21_z + s_20 * t394;
  const Scalar t407 = Scalar(0.000044065573770491804) * t277 + t401;
  const Scalar t408 = (s_26 * t405 + c_26 * f_26_x) - (s_19 * t407 + c_19 * t406);
  const Scalar t409 = Scalar(0.00196) * t278 - c_20 * t403 + s_20 * t402;
  const Scalar t410 = Scalar(0.00196) * t206 - c_27 * t399 + s_27 * t398;
  const Scalar mu_19_y = Scalar(0.00098) * (t272 + domega_19_y) - mu_20_z;
  const Scalar mu_26_y = Scalar(0.00098) * (t197 + domega_26_y) - mu_27_z;
  const Scalar t411 = Scalar(0.00016042921013412816) * t203 + s_27 * f_28_z + c_27 * t387;
  const Scalar t412 = t411 + (Scalar(0.000044065573770491804) * t275 + s_20 * f_21_z + c_20 * t394);
  const Scalar t413 = t38 * U_18_xy - t41 * t10;
  const Scalar t414 = t38 * t43 - t41 * t47;
  const Scalar t415 = s_17 * t413 + c_17 * t414 + Scalar(0.00004711699779249448) * t32;
  const Scalar t416 = t41 * U_18_yx - t38 * t12 + Scalar(0.00004711699779249448) * t40;
  const Scalar f_u_16_t_x = s_16 * t416 - c_16 * t415;
  const Scalar t417 = Scalar(0.0005625) * t21 - s_17 * mu_17_x - c_17 * mu_17_y;
  const Scalar t418 = Scalar(0.0003125) * (t45 + domega_16_y) + mu_u_17_a_y;
  const Scalar mu_15_z = Scalar(0.048) * t25 - Scalar(0.164908333333833) * t20 + s_16 * t417 -
      c_16 * t418 + Scalar(0.3206157575755909) * U_15_xy - Scalar(17.12290909090909) * t35 +
      Scalar(0.576) * (Uz_o_16_x - t201) - Scalar(113.25) * f_u_16_t_x + s_19 * t409 -
      c_19 * mu_19_y + s_26 * t410 - c_26 * mu_26_y - Scalar(60.0) * t408 + Scalar(82.5) * t412;
  n[14] = mu_15_z;
  const Scalar t419 = s_26 * f_26_x - c_26 * t405;
  const Scalar f_u_19_t_y = s_19 * t406 - c_19 * t407;
  const Scalar t420 = Scalar(0.75) * f_u_16_t_x + Scalar(0.048) * t20 + mu_u_16_x -
      Scalar(0.3206157575755909) * U_15_zy + Scalar(0.006981818181818182) * t190 - s_19 * mu_19_y -
      c_19 * t409 - s_26 * mu_26_y - c_26 * t410 - Scalar(60.0) * (t419 - f_u_19_t_y);
  const Scalar t421 = s_16 * t415 + c_16 * t416;
  const Scalar t422 = s_17 * t414 - c_17 * t413 + Scalar(0.00004711699779249448) * t37;
  const Scalar t423 = Scalar(-0.75) * t422 - Scalar(0.048) * (Uz_o_15_y - Uz_o_16_x) - s_16 * t418 -
      c_16 * t417 + Scalar(0.164908333333833) * t17 - Scalar(0.576) * U_15_zy +
      Scalar(113.25) * t421 - t400 - t404 - Scalar(82.5) * (t419 + f_u_19_t_y);
  const Scalar t424 = c_14 * (qd_13 * t4 - Scalar(44.243457270943935));
  n[13] = Scalar(0.04430883002224172) * t424 + s_15 * t420 + c_15 * t423;
  const Scalar t425 = c_14 * (Scalar(0.09106766004448344) * qd_14 * t4 - s_15 * t423 + c_15 * t420);
  const Scalar mu_14_y = Scalar(0.00245) * t19 - mu_15_z;
  n[12] = s_14 * mu_14_y - t425;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[32]    in   joint positions, rad or m
//   qd[32]   in   joint velocities, rad/s or m/s
//   tau[32]  in   joint torques or forces, N m or N
//   qdd[32]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[0..11], q[13..31], qd[0..31], tau[0..31]. Operations: 2855 mul, 2251 add, 27 div, 62
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
  const Scalar t2 = s_3 * t1;
  const Scalar omega_r_3_x = t2 + c_3 * qd_2;
  const Scalar t3 = s_2 * qd_1;
  const Scalar omega_3_z = qd_3 - t3;
  const Scalar t4 = omega_r_3_x * omega_3_z;
  const Scalar t5 = Scalar(2.0) * c_3;
  const Scalar t6 = t4 + t3 * (t2 + t5 * qd_2);
  const Scalar U_3_zx = t4 + t6;
  const Scalar t7 = t1 * t1 + qd_2 * qd_2;
  const Scalar t8 = Scalar(2452.5) * c_1;
  const Scalar t9 = Scalar(97.25) * t7 - Scalar(5.0) * U_3_zx + c_2 * t8;
  const Scalar t10 = omega_r_3_x * omega_r_3_x;
  const Scalar t11 = omega_3_z * omega_3_z;
  const Scalar t12 = t7 - t10 + t11;
  const Scalar t13 = qd_2 * t3;
  const Scalar ddp_3_a_y = Scalar(2452.5) * s_1 - Scalar(194.5) * t13;
  const Scalar t14 = t1 * t3;
  const Scalar ddp_o_3_x = Scalar(97.25) * t14 + s_2 * t8;
  const Scalar t15 = c_3 * ddp_3_a_y - s_3 * ddp_o_3_x;
  const Scalar ddp_o_4_x = Scalar(5.0) * t12 - t15;
  const Scalar t16 = c_4 * t9 + s_4 * ddp_o_4_x;
  const Scalar t17 = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar t18 = t17 * t17;
  const Scalar t19 = c_3 * t1;
  const Scalar t20 = s_3 * qd_2;
  const Scalar t21 = t19 - t20;
  const Scalar omega_4_z = qd_4 + t21;
  const Scalar t22 = omega_4_z * omega_4_z;
  const Scalar t23 = c_4 * omega_r_3_x - s_4 * omega_3_z;
  const Scalar t24 = t17 * t23;
  const Scalar U_4_xy = t6 + t24;
  const Scalar t25 = Scalar(10.0) * U_4_xy + t16 + Scalar(89.25) * (t10 + t11 - t18 + t22);
  const Scalar t26 = t21 * omega_3_z;
  const Scalar t27 = (t19 - Scalar(2.0) * t20) * t3;
  const Scalar t28 = t27 + Scalar(2.0) * t26;
  const Scalar t29 = omega_r_3_x * t21;
  const Scalar t30 = qd_2 * t1;
  const Scalar t31 = t30 + t29;
  const Scalar t32 = t17 * omega_4_z;
  const Scalar t33 = s_4 * t31 + c_4 * t28 - t32;
  const Scalar t34 = t23 * omega_4_z;
  const Scalar t35 = c_4 * t31 - s_4 * t28 - Scalar(2.0) * t34;
  const Scalar t36 = t30 - t29;
  const Scalar ddp_3_y = c_3 * ddp_o_3_x + s_3 * ddp_3_a_y;
  const Scalar ddp_o_4_y = Scalar(5.0) * t36 + ddp_3_y;
  const Scalar t37 = Scalar(10.0) * t35 - ddp_o_4_y + Scalar(89.25) * (t32 - t33);
  const Scalar t38 = c_5 * t25 + s_5 * t37;
  const Scalar t39 = c_4 * ddp_o_4_x - s_4 * t9;
  const Scalar Uz_o_5_y = t18 + t22;
  const Scalar ddp_5_a_z = Scalar(89.25) * (t6 - t24) - Scalar(10.0) * Uz_o_5_y + t39;
  const Scalar t40 = c_6 * ddp_5_a_z - s_6 * t38;
  const Scalar t41 = c_6 * t38 + s_6 * ddp_5_a_z;
  const Scalar t42 = c_5 * t17 - s_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 + t23;
  const Scalar omega_r_6_x = c_6 * omega_5_z - s_6 * t42;
  const Scalar t43 = omega_r_6_x * omega_r_6_x;
  const Scalar omega_r_5_y = c_5 * omega_4_z + s_5 * t17;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t44 = omega_6_z * omega_6_z;
  const Scalar t45 = t42 * t42 - t43 + omega_5_z * omega_5_z + t44;
  const Scalar t46 = t43 + t44;
  const Scalar t47 = c_6 * t42 + s_6 * omega_5_z;
  const Scalar t48 = omega_r_6_x * t47;
  const Scalar t49 = t42 * omega_5_z;
  const Scalar t50 = c_5 * U_4_xy - t49 + s_5 * t35;
  const Scalar t51 = Scalar(-0.0012) * t48 - Scalar(0.00315) * (t45 - t46) +
      Scalar(0.01431666666667) * t50 + Scalar(0.00018) * t41 + Scalar(0.00042) * t40;
  const Scalar t52 = Scalar(0.00940666666667) * t49 + Scalar(0.00876666666667) * t50 - t51;
  const Scalar t53 = Scalar(0.00018) * (t48 + t50) + Scalar(0.00042) * t46;
  const Scalar U_6_xy = t50 - t48;
  const Scalar t54 = Scalar(0.00018) * t45 - Scalar(0.00042) * U_6_xy;
  const Scalar t55 = c_6 * t53 + s_6 * t54 + Scalar(0.0000615126050420168) * t38;
  const Scalar t56 = c_5 * t37 - s_5 * t25;
  const Scalar t57 = omega_r_5_y * omega_5_z;
  const Scalar U_5_zy = c_5 * t35 - s_5 * U_4_xy + Scalar(2.0) * t57;
  const Scalar t58 = t42 * omega_r_5_y;
  const Scalar t59 = t58 + t33;
  const Scalar t60 = omega_r_6_x * omega_6_z;
  const Scalar t61 = c_6 * U_5_zy - s_6 * t59 - t60;
  const Scalar U_6_zx = t60 - t61;
  const Scalar t62 = t47 * omega_6_z;
  const Scalar t63 = c_6 * t59 + s_6 * U_5_zy - Scalar(2.0) * t62;
  const Scalar t64 = Scalar(-0.00018) * U_6_zx - Scalar(0.00042) * t63 +
      Scalar(0.0000615126050420168) * t56;
  const Scalar t65 = c_5 * t64 + s_5 * t55;
  const Scalar t66 = Scalar(-0.0012) * t61 - Scalar(0.00315) * t63 + Scalar(0.00018) * t56 -
      Scalar(0.01431666666667) * t60;
  const Scalar t67 = Scalar(0.01551666666667) * t62 - Scalar(0.00315) * U_6_zx +
      Scalar(0.00042) * t56;
  const Scalar mu_5_x = Scalar(0.01817333333334) * t57 + c_6 * t66 - s_6 * t67;
  const Scalar t68 = Scalar(0.03536081232493664) * t34 + Scalar(0.0002648739495798319) * ddp_o_4_y -
      c_5 * mu_5_x + s_5 * t52 - Scalar(10.0) * t65;
  const Scalar t69 = Scalar(0.00876666666667) * t58 + Scalar(0.00940666666667) * t33 - s_6 * t66 -
      c_6 * t67;
  const Scalar t70 = Scalar(0.047979593837531684) * t32 + t69 - Scalar(0.08334040616246832) * t33 -
      Scalar(89.25) * t65;
  const Scalar t71 = Scalar(0.0002648739495798319) * t35 -
      Scalar(2.4873949579831934e-06) * ddp_o_4_y + t65;
  const Scalar t72 = Scalar(0.00507) * t27 + Scalar(0.01720540616246832) * t29 +
      Scalar(0.03025540616246832) * t30 - Scalar(5.0) * t71 - c_4 * t68 + s_4 * t70;
  const Scalar t73 = c_5 * t55 - s_5 * t64;
  const Scalar f_5_z = s_6 * t53 - c_6 * t54 + Scalar(0.0000615126050420168) * ddp_5_a_z;
  const Scalar mu_4_z = Scalar(0.047979593837531684) * t6 - Scalar(0.0002648739495798319) * t16 -
      Scalar(0.08334040616246832) * t24 + c_5 * t52 + s_5 * mu_5_x - Scalar(10.0) * t73 -
      Scalar(89.25) * f_5_z;
  const Scalar y_6 = t51 + tau_6;
  const Scalar hu_6_a_z = Scalar(0.00018) * c_6 - Scalar(0.00042) * s_6;
  const Scalar t74 = Scalar(10.0) * hu_6_a_z + Scalar(0.01431666666667);
  const Scalar hu_6_t_x = Scalar(0.00018) * s_6 + Scalar(0.00042) * c_6;
  const Scalar t75 = Scalar(89.25) * hu_6_t_x;
  const Scalar mu_6_4_z = c_5 * t74 + t75;
  const Scalar t76 = Scalar(69.84866123397676) * mu_6_4_z;
  const Scalar t77 = t69 - tau_5;
  const Scalar t78 = Scalar(0.0063) * c_6 - Scalar(0.0012) * s_6;
  const Scalar t79 = s_6 * t78;
  const Scalar Ic_5_zz = t79 + Scalar(0.00940666666667);
  const Scalar d_5 = Scalar(1.0) / Ic_5_zz;
  const Scalar t80 = Scalar(10.0) * hu_6_t_x + c_6 * t78 - Scalar(0.00315);
  const Scalar t81 = s_5 * t80;
  const Scalar t82 = d_5 * t81;
  const Scalar t83 = t82 * t77 + mu_4_z - tau_4 + t76 * y_6;
  const Scalar t84 = Scalar(0.0012) + t79;
  const Scalar t85 = c_5 * (t84 + Scalar(0.00555));
  const Scalar t86 = t85 + t75;
  const Scalar t87 = s_4 * t80 + c_4 * t86;
  const Scalar t88 = s_5 * t87;
  const Scalar t89 = c_5 * t80;
  const Scalar t90 = c_5 * hu_6_t_x;
  const Scalar t91 = Ic_5_zz + Scalar(89.25) * t90;
  const Scalar t92 = Scalar(5.0) * t90 - c_4 * t89 + s_4 * t91;
  const Scalar t93 = t92 * d_5;
  const Scalar t94 = Scalar(89.25) * hu_6_a_z;
  const Scalar t95 = s_5 * (c_4 * t74 - t94 * (Scalar(0.056022408963585436) + s_4));
  const Scalar t96 = t81 * t93 - t88 + t95 * t76;
  const Scalar t97 = c_5 * t85;
  const Scalar t98 = Scalar(178.5) * t90;
  const Scalar t99 = Scalar(20.0) * hu_6_a_z;
  const Scalar t100 = t84 - t97 - t99 - t98 - Scalar(0.44815416666667);
  const Scalar t101 = t81 * t82 + mu_6_4_z * t76 + t100;
  const Scalar t102 = Scalar(1.0) / t101;
  const Scalar t103 = t96 * t102;
  const Scalar t104 = Scalar(-69.84866123397676) * t95;
  const Scalar t105 = t103 * t83 + t72 + tau_3 + t104 * y_6 - t93 * t77;
  const Scalar t106 = t97 - t99 - Scalar(0.01170126050420168);
  const Scalar Ic_4_yy = Ic_5_zz + t98 + Scalar(0.4066420938375317);
  const Scalar Ic_4_xy = t89 + t94 + Scalar(0.0549);
  const Scalar t107 = Scalar(2.0) * c_4 * Ic_4_xy - s_4 * (t106 + Ic_4_yy);
  const Scalar hc_4_x = t90 + Scalar(0.00549);
  const Scalar f_4_4_x = hu_6_a_z + Scalar(0.00088);
  const Scalar hu_4_t_y = s_4 * f_4_4_x + c_4 * hc_4_x;
  const Scalar t108 = Scalar(0.00507) + Scalar(5.0) * hu_4_t_y + Ic_4_xy - c_4 * t107;
  const Scalar t109 = s_3 * s_5;
  const Scalar t110 = c_4 * f_4_4_x - s_4 * hc_4_x;
  const Scalar t111 = t110 - Scalar(0.00032);
  const Scalar t112 = c_3 * t111 - hu_6_t_x * t109;
  const Scalar t113 = -t87 * t109 - c_3 * t108 + Scalar(97.25) * t112;
  const Scalar mu_u_5_4_t_x = s_4 * t89 + c_4 * t91;
  const Scalar t114 = Scalar(5.0) * hu_6_t_x;
  const Scalar t115 = t80 - c_4 * t114;
  const Scalar t116 = Scalar(97.25) * hu_6_t_x;
  const Scalar t117 = (c_3 * c_5 + s_4 * t109) * t116;
  const Scalar mu_5_2_z = t109 * t115 + c_3 * mu_u_5_4_t_x + t117;
  const Scalar t118 = mu_5_2_z * d_5;
  const Scalar t119 = c_4 * t80 - s_4 * t86;
  const Scalar t120 = c_3 * s_5;
  const Scalar t121 = Scalar(5.0) * t110 + t100 - Scalar(97.25) * hu_4_t_y;
  const Scalar t122 = c_5 * hu_6_a_z;
  const Scalar t123 = s_4 * t122 + c_4 * hu_6_t_x;
  const Scalar t124 = hu_6_a_z * t120 - s_3 * t123;
  const Scalar mu_6_3_y = mu_6_4_z - Scalar(5.0) * (c_4 * t122 - s_4 * hu_6_t_x);
  const Scalar t125 = s_4 * t74 + c_4 * t94;
  const Scalar t126 = t120 * t125 + Scalar(97.25) * t124 - s_3 * mu_6_3_y;
  const Scalar t127 = t119 * t120 - t81 * t118 + t126 * t76 - s_3 * t121;
  const Scalar t128 = Scalar(-69.84866123397676) * t126;
  const Scalar t129 = t95 * t128 + mu_5_2_z * t93 + t127 * t103 + t113;
  const Scalar t130 = s_4 * t107;
  const Scalar t131 = Scalar(-10.0) * t110;
  const Scalar t132 = t106 - t131 - Scalar(0.03185540616246832) + t130;
  const Scalar t133 = t92 * t93 - t96 * t103 - t95 * t104 + t132;
  const Scalar t134 = Scalar(1.0) / t133;
  const Scalar t135 = t129 * t134;
  const Scalar t136 = Scalar(0.0002648739495798319) * U_4_xy +
      Scalar(2.4873949579831934e-06) * t16 + t73;
  const Scalar f_4_y = Scalar(0.0002648739495798319) * Uz_o_5_y -
      Scalar(2.4873949579831934e-06) * t39 - f_5_z;
  const Scalar t137 = Scalar(0.000051146529562982) * t15 + c_4 * f_4_y - s_4 * t136;
  const Scalar f_3_y = Scalar(0.000051146529562982) * ddp_3_y - t71;
  const Scalar f_u_3_t_x = c_3 * f_3_y - s_3 * t137;
  const Scalar mu_3_x = Scalar(0.00507) * t36 + Scalar(0.04746081232493664) * t26 + s_4 * t68 +
      c_4 * t70;
  const Scalar f_u_4_a_z = c_4 * t136 + s_4 * f_4_y;
  const Scalar t138 = Scalar(-0.00507) * (t7 - t12) - Scalar(0.01720540616246832) * t6 +
      Scalar(0.03025540616246832) * t4 - Scalar(5.0) * f_u_4_a_z - mu_4_z;
  const Scalar t139 = t127 * t102;
  const Scalar y_3_2 = Scalar(0.05890959383753168) * t14 - c_3 * mu_3_x + tau_2 - s_3 * t138 -
      Scalar(97.25) * f_u_3_t_x + t128 * y_6 + t118 * t77 + t139 * t83 + t135 * t105;
  const Scalar Iu_4_t_xx = t130 + Ic_4_yy;
  const Scalar t140 = Scalar(0.015605406162468319) - t131 + t100;
  const Scalar Iu_3_t_d = Iu_4_t_xx + t140;
  const Scalar t141 = s_5 * t114 - s_5 * t119;
  const Scalar t142 = t141 * t5 + s_3 * Iu_3_t_d;
  const Scalar t143 = c_2 * (t141 - c_3 * t142);
  const Scalar t144 = hu_6_t_x * t120 + s_3 * t111;
  const Scalar t145 = c_2 * (t87 * t120 - s_3 * t108 + Scalar(97.25) * t144);
  const Scalar t146 = (s_4 * t120 - s_3 * c_5) * t116;
  const Scalar t147 = c_2 * (t120 * t115 - s_3 * mu_u_5_4_t_x + t146) - s_2 * t92;
  const Scalar t148 = t147 * d_5;
  const Scalar t149 = c_2 * (t119 * t109 + c_3 * t121);
  const Scalar f_u_6_3_t_y = c_3 * t123 + hu_6_a_z * t109;
  const Scalar mu_6_2_x = t109 * t125 + Scalar(97.25) * f_u_6_3_t_y + c_3 * mu_6_3_y;
  const Scalar mu_u_6_2_t_y = c_2 * mu_6_2_x - s_2 * t95;
  const Scalar t150 = t81 * t148 + s_2 * t88 + mu_u_6_2_t_y * t76 + t149;
  const Scalar t151 = Scalar(69.84866123397676) * mu_u_6_2_t_y;
  const Scalar t152 = t150 * t103 - t95 * t151 - t147 * t93 + t145 + s_2 * t132;
  const Scalar t153 = -mu_u_6_2_t_y * t128 - t147 * t118 + t143 + s_2 * t113 - t150 * t139 -
      t152 * t135;
  const Scalar t154 = s_3 * t142;
  const Scalar t155 = Scalar(194.5) * hu_4_t_y;
  const Scalar b_3_2_2 = t126 * t128 - mu_5_2_z * t118 + Iu_4_t_xx - t154 + t127 * t139 +
      t129 * t135 + t155 + Scalar(1.0320559061624683);
  const Scalar d_2 = Scalar(1.0) / b_3_2_2;
  const Scalar t156 = t153 * d_2;
  const Scalar f_u_3_t_y = c_3 * t137 + s_3 * f_3_y;
  const Scalar mu_2_x = Scalar(0.11585918767506335) * t13 + s_3 * mu_3_x - c_3 * t138 +
      Scalar(97.25) * f_u_3_t_y;
  const Scalar t157 = s_2 * (Scalar(0.00196) * t30 + t72);
  const Scalar t158 = t152 * t134;
  const Scalar t159 = t150 * t102;
  const Scalar t160 = tau_1 - t157 - c_2 * mu_2_x - t151 * y_6 - t148 * t77 + t159 * t83 +
      t158 * t105 + t156 * y_3_2;
  const Scalar t161 = t140 - t154 - t155 - Scalar(1.0890055);
  const Scalar t162 = s_2 * (Scalar(2.0) * t145 +
      s_2 * (t132 - Scalar(0.05890959383753168) - t161));
  const Scalar t163 = mu_u_6_2_t_y * t151 + t147 * t148 + Scalar(0.05498959383753168) -
      t150 * t159 + t153 * t156 - t152 * t158 + t162 + t161;
  const Scalar t164 = (Scalar(1.0) / t163) * t160;
  qdd[0] = -t164;
  const Scalar t165 = c_8 * qd_7;
  const Scalar t166 = s_9 * t165;
  const Scalar omega_r_9_x = t166 + c_9 * qd_8;
  const Scalar t167 = s_8 * qd_7;
  const Scalar omega_9_z = qd_9 - t167;
  const Scalar t168 = omega_r_9_x * omega_9_z;
  const Scalar t169 = Scalar(2.0) * c_9;
  const Scalar t170 = t168 + t167 * (t166 + t169 * qd_8);
  const Scalar U_9_zx = t168 + t170;
  const Scalar t171 = t165 * t165 + qd_8 * qd_8;
  const Scalar t172 = Scalar(2452.5) * c_7;
  const Scalar t173 = Scalar(97.25) * t171 - Scalar(5.0) * U_9_zx + c_8 * t172;
  const Scalar t174 = omega_r_9_x * omega_r_9_x;
  const Scalar t175 = omega_9_z * omega_9_z;
  const Scalar t176 = t171 - t174 + t175;
  const Scalar t177 = qd_8 * t167;
  const Scalar ddp_9_a_y = Scalar(2452.5) * s_7 - Scalar(194.5) * t177;
  const Scalar t178 = t165 * t167;
  const Scalar ddp_o_9_x = Scalar(97.25) * t178 + s_8 * t172;
  const Scalar t179 = c_9 * ddp_9_a_y - s_9 * ddp_o_9_x;
  const Scalar ddp_o_10_x = Scalar(5.0) * t176 - t179;
  const Scalar t180 = c_10 * t173 + s_10 * ddp_o_10_x;
  const Scalar t181 = s_10 * omega_r_9_x + c_10 * omega_9_z;
  const Scalar t182 = t181 * t181;
  const Scalar t183 = c_9 * t165;
  const Scalar t184 = s_9 * qd_8;
  const Scalar t185 = t183 - t184;
  const Scalar omega_10_z = qd_10 + t185;
  const Scalar t186 = omega_10_z * omega_10_z;
  const Scalar t187 = c_10 * omega_r_9_x - s_10 * omega_9_z;
  const Scalar t188 = t181 * t187;
  const Scalar U_10_xy = t170 + t188;
  const Scalar t189 = Scalar(10.0) * U_10_xy + t180 + Scalar(89.25) * (t174 + t175 - t182 + t186);
  const Scalar t190 = t185 * omega_9_z;
  const Scalar t191 = (t183 - Scalar(2.0) * t184) * t167;
  const Scalar t192 = t191 + Scalar(2.0) * t190;
  const Scalar t193 = omega_r_9_x * t185;
  const Scalar t194 = qd_8 * t165;
  const Scalar t195 = t194 + t193;
  const Scalar t196 = t181 * omega_10_z;
  const Scalar t197 = s_10 * t195 + c_10 * t192 - t196;
  const Scalar t198 = t187 * omega_10_z;
  const Scalar t199 = c_10 * t195 - s_10 * t192 - Scalar(2.0) * t198;
  const Scalar t200 = t194 - t193;
  const Scalar ddp_9_y = c_9 * ddp_o_9_x + s_9 * ddp_9_a_y;
  const Scalar ddp_o_10_y = Scalar(5.0) * t200 + ddp_9_y;
  const Scalar t201 = Scalar(10.0) * t199 - ddp_o_10_y + Scalar(89.25) * (t196 - t197);
  const Scalar t202 = c_11 * t189 + s_11 * t201;
  const Scalar t203 = c_10 * ddp_o_10_x - s_10 * t173;
  const Scalar Uz_o_11_y = t182 + t186;
  const Scalar ddp_11_a_z = Scalar(89.25) * (t170 - t188) - Scalar(10.0) * Uz_o_11_y + t203;
  const Scalar t204 = c_12 * ddp_11_a_z - s_12 * t202;
  const Scalar t205 = c_12 * t202 + s_12 * ddp_11_a_z;
  const Scalar t206 = c_11 * t181 - s_11 * omega_10_z;
  const Scalar omega_11_z = qd_11 + t187;
  const Scalar omega_r_12_x = c_12 * omega_11_z - s_12 * t206;
  const Scalar t207 = omega_r_12_x * omega_r_12_x;
  const Scalar omega_r_11_y = c_11 * omega_10_z + s_11 * t181;
  const Scalar omega_12_z = qd_12 + omega_r_11_y;
  const Scalar t208 = omega_12_z * omega_12_z;
  const Scalar t209 = t206 * t206 - t207 + omega_11_z * omega_11_z + t208;
  const Scalar t210 = t207 + t208;
  const Scalar t211 = c_12 * t206 + s_12 * omega_11_z;
  const Scalar t212 = omega_r_12_x * t211;
  const Scalar t213 = t206 * omega_11_z;
  const Scalar t214 = c_11 * U_10_xy - t213 + s_11 * t199;
  const Scalar t215 = Scalar(-0.0012) * t212 - Scalar(0.00315) * (t209 - t210) +
      Scalar(0.01431666666667) * t214 + Scalar(0.00018) * t205 + Scalar(0.00042) * t204;
  const Scalar t216 = Scalar(0.00940666666667) * t213 + Scalar(0.00876666666667) * t214 - t215;
  const Scalar t217 = Scalar(0.00018) * (t212 + t214) + Scalar(0.00042) * t210;
  const Scalar U_12_xy = t214 - t212;
  const Scalar t218 = Scalar(0.00018) * t209 - Scalar(0.00042) * U_12_xy;
  const Scalar t219 = c_12 * t217 + s_12 * t218 + Scalar(0.0000615126050420168) * t202;
  const Scalar t220 = c_11 * t201 - s_11 * t189;
  const Scalar t221 = omega_r_11_y * omega_11_z;
  const Scalar U_11_zy = c_11 * t199 - s_11 * U_10_xy + Scalar(2.0) * t221;
  const Scalar t222 = t206 * omega_r_11_y;
  const Scalar t223 = t222 + t197;
  const Scalar t224 = omega_r_12_x * omega_12_z;
  const Scalar t225 = c_12 * U_11_zy - s_12 * t223 - t224;
  const Scalar U_12_zx = t224 - t225;
  const Scalar t226 = t211 * omega_12_z;
  const Scalar t227 = c_12 * t223 + s_12 * U_11_zy - Scalar(2.0) * t226;
  const Scalar t228 = Scalar(-0.00018) * U_12_zx - Scalar(0.00042) * t227 +
      Scalar(0.0000615126050420168) * t220;
  const Scalar t229 = c_11 * t228 + s_11 * t219;
  const Scalar t230 = Scalar(-0.0012) * t225 - Scalar(0.00315) * t227 + Scalar(0.00018) * t220 -
      Scalar(0.01431666666667) * t224;
  const Scalar t231 = Scalar(0.01551666666667) * t226 - Scalar(0.00315) * U_12_zx +
      Scalar(0.00042) * t220;
  const Scalar mu_11_x = Scalar(0.01817333333334) * t221 + c_12 * t230 - s_12 * t231;
  const Scalar t232 = Scalar(0.03536081232493664) * t198 +
      Scalar(0.0002648739495798319) * ddp_o_10_y - c_11 * mu_11_x + s_11 * t216 -
      Scalar(10.0) * t229;
  const Scalar t233 = Scalar(0.00876666666667) * t222 + Scalar(0.00940666666667) * t197 -
      s_12 * t230 - c_12 * t231;
  const Scalar t234 = Scalar(0.047979593837531684) * t196 + t233 -
      Scalar(0.08334040616246832) * t197 - Scalar(89.25) * t229;
  const Scalar t235 = Scalar(0.0002648739495798319) * t199 -
      Scalar(2.4873949579831934e-06) * ddp_o_10_y + t229;
  const Scalar t236 = Scalar(0.00507) * t191 + Scalar(0.01720540616246832) * t193 +
      Scalar(0.03025540616246832) * t194 - Scalar(5.0) * t235 - c_10 * t232 + s_10 * t234;
  const Scalar t237 = c_11 * t219 - s_11 * t228;
  const Scalar f_11_z = s_12 * t217 - c_12 * t218 + Scalar(0.0000615126050420168) * ddp_11_a_z;
  const Scalar mu_10_z = Scalar(0.047979593837531684) * t170 -
      Scalar(0.0002648739495798319) * t180 - Scalar(0.08334040616246832) * t188 + c_11 * t216 +
      s_11 * mu_11_x - Scalar(10.0) * t237 - Scalar(89.25) * f_11_z;
  const Scalar y_12 = t215 + tau_12;
  const Scalar hu_12_a_z = Scalar(0.00018) * c_12 - Scalar(0.00042) * s_12;
  const Scalar t238 = Scalar(10.0) * hu_12_a_z + Scalar(0.01431666666667);
  const Scalar hu_12_t_x = Scalar(0.00018) * s_12 + Scalar(0.00042) * c_12;
  const Scalar t239 = Scalar(89.25) * hu_12_t_x;
  const Scalar mu_12_10_z = c_11 * t238 + t239;
  const Scalar t240 = Scalar(69.84866123397676) * mu_12_10_z;
  const Scalar t241 = t233 - tau_11;
  const Scalar t242 = Scalar(0.0063) * c_12 - Scalar(0.0012) * s_12;
  const Scalar t243 = s_12 * t242;
  const Scalar Ic_11_zz = t243 + Scalar(0.00940666666667);
  const Scalar d_11 = Scalar(1.0) / Ic_11_zz;
  const Scalar t244 = Scalar(10.0) * hu_12_t_x + c_12 * t242 - Scalar(0.00315);
  const Scalar t245 = s_11 * t244;
  const Scalar t246 = d_11 * t245;
  const Scalar t247 = t246 * t241 + mu_10_z - tau_10 + t240 * y_12;
  const Scalar t248 = Scalar(0.0012) + t243;
  const Scalar t249 = c_11 * (t248 + Scalar(0.00555));
  const Scalar t250 = t249 + t239;
  const Scalar t251 = s_10 * t244 + c_10 * t250;
  const Scalar t252 = s_11 * t251;
  const Scalar t253 = c_11 * t244;
  const Scalar t254 = c_11 * hu_12_t_x;
  const Scalar t255 = Ic_11_zz + Scalar(89.25) * t254;
  const Scalar t256 = Scalar(5.0) * t254 - c_10 * t253 + s_10 * t255;
  const Scalar t257 = t256 * d_11;
  const Scalar t258 = Scalar(89.25) * hu_12_a_z;
  const Scalar t259 = s_11 * (c_10 * t238 - t258 * (Scalar(0.056022408963585436) + s_10));
  const Scalar t260 = t245 * t257 - t252 + t259 * t240;
  const Scalar t261 = c_11 * t249;
  const Scalar t262 = Scalar(178.5) * t254;
  const Scalar t263 = Scalar(20.0) * hu_12_a_z;
  const Scalar t264 = t248 - t261 - t263 - t262 - Scalar(0.44815416666667);
  const Scalar t265 = t245 * t246 + mu_12_10_z * t240 + t264;
  const Scalar t266 = Scalar(1.0) / t265;
  const Scalar t267 = t260 * t266;
  const Scalar t268 = Scalar(-69.84866123397676) * t259;
  const Scalar t269 = t267 * t247 + t236 + tau_9 + t268 * y_12 - t257 * t241;
  const Scalar t270 = t261 - t263 - Scalar(0.01170126050420168);
  const Scalar Ic_10_yy = Ic_11_zz + t262 + Scalar(0.4066420938375317);
  const Scalar Ic_10_xy = t253 + t258 + Scalar(0.0549);
  const Scalar t271 = Scalar(2.0) * c_10 * Ic_10_xy - s_10 * (t270 + Ic_10_yy);
  const Scalar hc_10_x = t254 + Scalar(0.00549);
  const Scalar f_10_10_x = hu_12_a_z + Scalar(0.00088);
  const Scalar hu_10_t_y = s_10 * f_10_10_x + c_10 * hc_10_x;
  const Scalar t272 = Scalar(0.00507) + Scalar(5.0) * hu_10_t_y + Ic_10_xy - c_10 * t271;
  const Scalar t273 = s_9 * s_11;
  const Scalar t274 = c_10 * f_10_10_x - s_10 * hc_10_x;
  const Scalar t275 = t274 - Scalar(0.00032);
  const Scalar t276 = c_9 * t275 - hu_12_t_x * t273;
  const Scalar t277 = -t251 * t273 - c_9 * t272 + Scalar(97.25) * t276;
  const Scalar mu_u_11_10_t_x = s_10 * t253 + c_10 * t255;
  const Scalar t278 = Scalar(5.0) * hu_12_t_x;
  const Scalar t279 = t244 - c_10 * t278;
  const Scalar t280 = Scalar(97.25) * hu_12_t_x;
  const Scalar t281 = (c_9 * c_11 + s_10 * t273) * t280;
  const Scalar mu_11_8_z = t273 * t279 + c_9 * mu_u_11_10_t_x + t281;
  const Scalar t282 = mu_11_8_z * d_11;
  const Scalar t283 = c_10 * t244 - s_10 * t250;
  const Scalar t284 = c_9 * s_11;
  const Scalar t285 = Scalar(5.0) * t274 + t264 - Scalar(97.25) * hu_10_t_y;
  const Scalar t286 = c_11 * hu_12_a_z;
  const Scalar t287 = s_10 * t286 + c_10 * hu_12_t_x;
  const Scalar t288 = hu_12_a_z * t284 - s_9 * t287;
  const Scalar mu_12_9_y = mu_12_10_z - Scalar(5.0) * (c_10 * t286 - s_10 * hu_12_t_x);
  const Scalar t289 = s_10 * t238 + c_10 * t258;
  const Scalar t290 = t284 * t289 + Scalar(97.25) * t288 - s_9 * mu_12_9_y;
  const Scalar t291 = t283 * t284 - t245 * t282 + t290 * t240 - s_9 * t285;
  const Scalar t292 = Scalar(-69.84866123397676) * t290;
  const Scalar t293 = t259 * t292 + mu_11_8_z * t257 + t291 * t267 + t277;
  const Scalar t294 = s_10 * t271;
  const Scalar t295 = Scalar(-10.0) * t274;
  const Scalar t296 = t270 - t295 - Scalar(0.03185540616246832) + t294;
  const Scalar t297 = t256 * t257 - t260 * t267 - t259 * t268 + t296;
  const Scalar t298 = Scalar(1.0) / t297;
  const Scalar t299 = t293 * t298;
  const Scalar t300 = Scalar(0.0002648739495798319) * U_10_xy +
      Scalar(2.4873949579831934e-06) * t180 + t237;
  const Scalar f_10_y = Scalar(0.0002648739495798319) * Uz_o_11_y -
      Scalar(2.4873949579831934e-06) * t203 - f_11_z;
  const Scalar t301 = Scalar(0.000051146529562982) * t179 + c_10 * f_10_y - s_10 * t300;
  const Scalar f_9_y = Scalar(0.000051146529562982) * ddp_9_y - t235;
  const Scalar f_u_9_t_x = c_9 * f_9_y - s_9 * t301;
  const Scalar mu_9_x = Scalar(0.00507) * t200 + Scalar(0.04746081232493664) * t190 + s_10 * t232 +
      c_10 * t234;
  const Scalar f_u_10_a_z = c_10 * t300 + s_10 * f_10_y;
  const Scalar t302 = Scalar(-0.00507) * (t171 - t176) - Scalar(0.01720540616246832) * t170 +
      Scalar(0.03025540616246832) * t168 - Scalar(5.0) * f_u_10_a_z - mu_10_z;
  const Scalar t303 = t291 * t266;
  const Scalar y_9_8 = Scalar(0.05890959383753168) * t178 - c_9 * mu_9_x + tau_8 - s_9 * t302 -
      Scalar(97.25) * f_u_9_t_x + t292 * y_12 + t282 * t241 + t303 * t247 + t299 * t269;
  const Scalar Iu_10_t_xx = t294 + Ic_10_yy;
  const Scalar t304 = Scalar(0.015605406162468319) - t295 + t264;
  const Scalar Iu_9_t_d = Iu_10_t_xx + t304;
  const Scalar t305 = s_11 * t278 - s_11 * t283;
  const Scalar t306 = t305 * t169 + s_9 * Iu_9_t_d;
  const Scalar t307 = c_8 * (t305 - c_9 * t306);
  const Scalar t308 = hu_12_t_x * t284 + s_9 * t275;
  const Scalar t309 = c_8 * (t251 * t284 - s_9 * t272 + Scalar(97.25) * t308);
  const Scalar t310 = (s_10 * t284 - s_9 * c_11) * t280;
  const Scalar t311 = c_8 * (t284 * t279 - s_9 * mu_u_11_10_t_x + t310) - s_8 * t256;
  const Scalar t312 = t311 * d_11;
  const Scalar t313 = c_8 * (t283 * t273 + c_9 * t285);
  const Scalar f_u_12_9_t_y = c_9 * t287 + hu_12_a_z * t273;
  const Scalar mu_12_8_x = t273 * t289 + Scalar(97.25) * f_u_12_9_t_y + c_9 * mu_12_9_y;
  const Scalar mu_u_12_8_t_y = c_8 * mu_12_8_x - s_8 * t259;
  const Scalar t314 = t245 * t312 + s_8 * t252 + mu_u_12_8_t_y * t240 + t313;
  const Scalar t315 = Scalar(69.84866123397676) * mu_u_12_8_t_y;
  const Scalar t316 = t314 * t267 - t259 * t315 - t311 * t257 + t309 + s_8 * t296;
  const Scalar t317 = -mu_u_12_8_t_y * t292 - t311 * t282 + t307 + s_8 * t277 - t314 * t303 -
      t316 * t299;
  const Scalar t318 = s_9 * t306;
  const Scalar t319 = Scalar(194.5) * hu_10_t_y;
  const Scalar b_9_8_8 = t290 * t292 - mu_11_8_z * t282 + Iu_10_t_xx - t318 + t291 * t303 +
      t293 * t299 + t319 + Scalar(1.0320559061624683);
  const Scalar d_8 = Scalar(1.0) / b_9_8_8;
  const Scalar t320 = t317 * d_8;
  const Scalar f_u_9_t_y = c_9 * t301 + s_9 * f_9_y;
  const Scalar mu_8_x = Scalar(0.11585918767506335) * t177 + s_9 * mu_9_x - c_9 * t302 +
      Scalar(97.25) * f_u_9_t_y;
  const Scalar t321 = s_8 * (Scalar(0.00196) * t194 + t236);
  const Scalar t322 = t316 * t298;
  const Scalar t323 = t314 * t266;
  const Scalar t324 = tau_7 - t321 - c_8 * mu_8_x - t315 * y_12 - t312 * t241 + t323 * t247 +
      t322 * t269 + t320 * y_9_8;
  const Scalar t325 = t304 - t318 - t319 - Scalar(1.0890055);
  const Scalar t326 = s_8 * (Scalar(2.0) * t309 +
      s_8 * (t296 - Scalar(0.05890959383753168) - t325));
  const Scalar t327 = mu_u_12_8_t_y * t315 + t311 * t312 + Scalar(0.05498959383753168) -
      t314 * t323 + t317 * t320 - t316 * t322 + t326 + t325;
  const Scalar t328 = (Scalar(1.0) / t327) * t324;
  qdd[6] = -t328;
  const Scalar qdd_2 = d_2 * (y_3_2 - t153 * t164);
  qdd[1] = qdd_2;
  const Scalar qdd_8 = d_8 * (y_9_8 - t317 * t328);
  qdd[7] = qdd_8;
  const Scalar t329 = t134 * (t152 * t164 - t129 * qdd_2 + t105);
  qdd[2] = -t329;
  const Scalar t330 = t298 * (t316 * t328 - t293 * qdd_8 + t269);
  qdd[8] = -t330;
  const Scalar qdd_4 = t102 * (t96 * t329 + t150 * t164 + t83 - t127 * qdd_2);
  qdd[3] = qdd_4;
  const Scalar qdd_10 = t266 * (t260 * t330 + t314 * t328 + t247 - t291 * qdd_8);
  qdd[9] = qdd_10;
  const Scalar t331 = mu_u_6_2_t_y * t164 - mu_6_4_z * qdd_4 + y_6;
  qdd[5] = Scalar(69.84866123397676) * (t95 * t329 - t126 * qdd_2) +
      Scalar(69.84866123397676) * t331;
  const Scalar t332 = mu_u_12_8_t_y * t328 - mu_12_10_z * qdd_10 + y_12;
  qdd[11] = Scalar(69.84866123397676) * (t259 * t330 - t290 * qdd_8) +
      Scalar(69.84866123397676) * t332;
  const Scalar t333 = t147 * t164 - t81 * qdd_4 + mu_5_2_z * qdd_2 + t92 * t329 + t77;
  qdd[4] = -d_5 * t333;
  const Scalar t334 = t311 * t328 - t245 * qdd_10 + mu_11_8_z * qdd_8 + t256 * t330 + t241;
  qdd[10] = -d_11 * t334;
  const Scalar t335 = s_32 * s_32;
  const Scalar t336 = Scalar(0.0005096) * t335;
  const Scalar t337 = t336 - Scalar(0.0005096);
  const Scalar t338 = s_31 * c_32;
  const Scalar t339 = c_31 * (t337 - Scalar(0.0235906)) - Scalar(0.0014964) * t338;
  const Scalar t340 = c_31 * t339;
  const Scalar t341 = t340 + Scalar(0.0235906);
  const Scalar Ic_31_zz = t336 + Scalar(0.0253235000000002);
  const Scalar Ic_30_yy = Ic_31_zz - Scalar(0.0253235000000002);
  const Scalar t342 = c_31 * c_32;
  const Scalar t343 = Scalar(0.6811013098102112) * t342 + s_31;
  const Scalar t344 = Scalar(0.0014964) * c_30 * s_32 * t343 - s_30 * (t341 + Ic_30_yy);
  const Scalar t345 = s_30 * t344;
  const Scalar t346 = Scalar(0.0000376) * c_32;
  const Scalar hu_30_a_y = s_31 * t346 + Scalar(0.0007608) * c_31;
  const Scalar t347 = Scalar(119.5) * hu_30_a_y;
  const Scalar Ic_29_xx = t345 + Ic_30_yy + t347 + Scalar(0.4683922);
  const Scalar mu_u_30_30_a_y = t337 - t340 - Scalar(0.0259635000000002);
  const Scalar hu_31_t_x = Scalar(0.0007608) * s_31 - c_31 * t346;
  const Scalar t348 = Scalar(0.0000376) * s_32;
  const Scalar t349 = c_30 * t348;
  const Scalar t350 = t349 - s_30 * hu_31_t_x;
  const Scalar t351 = Scalar(-2.0) * t350;
  const Scalar t352 = mu_u_30_30_a_y - t351 - Scalar(0.2421176999999998);
  const Scalar Iu_29_t_d = t352 + Ic_29_xx;
  const Scalar t353 = Scalar(0.0007482) * c_32 + s_31 * t339;
  const Scalar t354 = c_31 - Scalar(0.6811013098102112) * t338;
  const Scalar t355 = Scalar(0.0007482) * s_32;
  const Scalar t356 = c_30 * t355;
  const Scalar t357 = t354 * t356 + s_30 * t353 + Scalar(59.75) * t350;
  const Scalar Ic_29_xy = hu_30_a_y + Scalar(0.0050592) - t357;
  const Scalar t358 = c_29 * Iu_29_t_d - Scalar(2.0) * s_29 * Ic_29_xy;
  const Scalar t359 = c_29 * t358;
  const Scalar t360 = t352 - t359;
  const Scalar t361 = t341 - t351 + t345 - t347 - Scalar(0.2298769000000002);
  const Scalar t362 = t350 - Scalar(0.0001312);
  const Scalar hc_29_y = hu_30_a_y + Scalar(0.0034592);
  const Scalar t363 = c_29 * t362 - s_29 * hc_29_y;
  const Scalar t364 = Scalar(-2.0) * t363;
  const Scalar t365 = t364 + t361 - Scalar(0.2401836999999998);
  const Scalar t366 = s_30 * t348;
  const Scalar hu_30_t_y = t366 + c_30 * hu_31_t_x;
  const Scalar Ic_29_xz = hu_30_t_y + t343 * t355 - c_30 * t344;
  const Scalar t367 = s_30 * t355;
  const Scalar mu_30_29_z = t354 * t367 - c_30 * t353 + Scalar(59.75) * hu_30_t_y;
  const Scalar Iu_29_t_xz = c_29 * Ic_29_xz + s_29 * mu_30_29_z;
  const Scalar t368 = hu_30_t_y - Iu_29_t_xz;
  const Scalar t369 = Scalar(2.0) * c_28 * t368 + s_28 * (t360 - t365);
  const Scalar t370 = s_28 * t369;
  const Scalar t371 = s_29 * t362 + c_29 * hc_29_y;
  const Scalar t372 = Scalar(-152.5) * t371;
  const Scalar t373 = t370 + t365 + t372 - Scalar(0.506605);
  const Scalar Ic_28_zz = -t364 - Scalar(0.2323492999999998) + Ic_29_xx - t359;
  const Scalar Ic_27_yy = Scalar(0.2690164999999998) + Ic_28_zz;
  const Scalar t374 = -t371 - Scalar(0.0023) + Ic_29_xy + s_29 * t358;
  const Scalar t375 = c_29 * mu_30_29_z - s_29 * Ic_29_xz;
  const Scalar t376 = t363 - Scalar(0.0000128);
  const Scalar t377 = c_28 * hu_30_t_y;
  const Scalar t378 = t377 + s_28 * t376;
  const Scalar t379 = c_28 * t375 + Scalar(76.25) * t378 - s_28 * t374;
  const Scalar t380 = c_27 * t379;
  const Scalar t381 = Scalar(2.0) * t380 - s_27 * (t373 + Ic_27_yy);
  const Scalar t382 = s_27 * t381;
  const Scalar Iu_27_t_xx = Ic_27_yy + t382;
  const Scalar t383 = -t370 - Scalar(0.2395485000000002) + t360 + t372;
  const Scalar t384 = t383 - Scalar(0.2670564999999998);
  const Scalar Iu_26_t_d = Iu_27_t_xx + t384;
  const Scalar Iu_28_a_yz = t368 - c_28 * t369;
  const Scalar t385 = s_28 * hu_30_t_y;
  const Scalar t386 = c_28 * t376 - t385;
  const Scalar t387 = Scalar(76.25) * t386 - s_28 * t375 - c_28 * t374;
  const Scalar Iu_27_a_xz = c_27 * t387 + s_27 * Iu_28_a_yz;
  const Scalar t388 = s_26 * Iu_27_a_xz;
  const Scalar t389 = c_26 * Iu_26_t_d - Scalar(2.0) * t388;
  const Scalar t390 = s_25 * s_25;
  const Scalar t391 = Scalar(0.0005096) * t390;
  const Scalar t392 = t391 - Scalar(0.0005096);
  const Scalar t393 = s_24 * c_25;
  const Scalar t394 = Scalar(0.0014964) * t393 + c_24 * (t392 - Scalar(0.0235906));
  const Scalar t395 = c_24 * t394;
  const Scalar t396 = t395 + Scalar(0.0235906);
  const Scalar Ic_24_zz = t391 + Scalar(0.0253235000000002);
  const Scalar Ic_23_yy = Ic_24_zz - Scalar(0.0253235000000002);
  const Scalar t397 = c_24 * c_25;
  const Scalar t398 = s_24 - Scalar(0.6811013098102112) * t397;
  const Scalar t399 = Scalar(0.0014964) * c_23 * s_25 * t398 + s_23 * (t396 + Ic_23_yy);
  const Scalar t400 = s_23 * t399;
  const Scalar t401 = Scalar(0.0000376) * c_25;
  const Scalar hu_23_a_y = Scalar(0.0007608) * c_24 - s_24 * t401;
  const Scalar t402 = Scalar(119.5) * hu_23_a_y;
  const Scalar Ic_22_xx = Ic_23_yy - t400 + t402 + Scalar(0.4683922);
  const Scalar mu_u_23_23_a_y = t392 - t395 - Scalar(0.0259635000000002);
  const Scalar hu_24_t_x = c_24 * t401 + Scalar(0.0007608) * s_24;
  const Scalar t403 = Scalar(0.0000376) * s_25;
  const Scalar t404 = c_23 * t403;
  const Scalar t405 = t404 + s_23 * hu_24_t_x;
  const Scalar t406 = Scalar(2.0) * t405;
  const Scalar t407 = mu_u_23_23_a_y - t406 - Scalar(0.2421176999999998);
  const Scalar Iu_22_t_d = t407 + Ic_22_xx;
  const Scalar Iu_24_t_xy = Scalar(0.0007482) * c_25 - s_24 * t394;
  const Scalar t408 = Scalar(0.6811013098102112) * t393 + c_24;
  const Scalar t409 = Scalar(0.0007482) * s_25;
  const Scalar t410 = c_23 * t409;
  const Scalar t411 = t408 * t410 + s_23 * Iu_24_t_xy + Scalar(59.75) * t405;
  const Scalar Ic_22_xy = hu_23_a_y + Scalar(0.0050592) + t411;
  const Scalar t412 = c_22 * Iu_22_t_d - Scalar(2.0) * s_22 * Ic_22_xy;
  const Scalar t413 = c_22 * t412;
  const Scalar t414 = t407 - t413;
  const Scalar t415 = t396 - t406 - t400 - t402 - Scalar(0.2298769000000002);
  const Scalar t416 = Scalar(0.0001312) + t405;
  const Scalar hc_22_y = hu_23_a_y + Scalar(0.0034592);
  const Scalar f_u_22_22_a_z = c_22 * t416 + s_22 * hc_22_y;
  const Scalar t417 = Scalar(2.0) * f_u_22_22_a_z;
  const Scalar t418 = t417 + t415 - Scalar(0.2401836999999998);
  const Scalar t419 = s_23 * t403;
  const Scalar t420 = c_23 * hu_24_t_x - t419;
  const Scalar t421 = t420 - t398 * t409 + c_23 * t399;
  const Scalar t422 = s_23 * t409;
  const Scalar t423 = c_23 * Iu_24_t_xy - t408 * t422 + Scalar(59.75) * t420;
  const Scalar t424 = c_22 * t421 + s_22 * t423;
  const Scalar t425 = t420 - t424;
  const Scalar t426 = Scalar(2.0) * c_21 * t425 + s_21 * (t414 - t418);
  const Scalar t427 = s_21 * t426;
  const Scalar t428 = c_22 * hc_22_y - s_22 * t416;
  const Scalar t429 = Scalar(-152.5) * t428;
  const Scalar t430 = t427 + t418 + t429 - Scalar(0.506605);
  const Scalar t431 = -t417 - Scalar(0.2323492999999998) + Ic_22_xx - t413;
  const Scalar t432 = Scalar(0.2690164999999998) + t431;
  const Scalar t433 = -t428 - Scalar(0.0023) + Ic_22_xy + s_22 * t412;
  const Scalar t434 = c_22 * t423 - s_22 * t421;
  const Scalar t435 = Scalar(0.0000128) + f_u_22_22_a_z;
  const Scalar t436 = c_21 * t420;
  const Scalar t437 = t436 - s_21 * t435;
  const Scalar t438 = c_21 * t434 + Scalar(76.25) * t437 - s_21 * t433;
  const Scalar t439 = c_20 * t438;
  const Scalar t440 = Scalar(2.0) * t439 - s_20 * (t430 + t432);
  const Scalar t441 = s_20 * t440;
  const Scalar t442 = t432 + t441;
  const Scalar t443 = -t427 - Scalar(0.2395485000000002) + t414 + t429;
  const Scalar t444 = t443 - Scalar(0.2670564999999998);
  const Scalar t445 = t425 - c_21 * t426;
  const Scalar t446 = s_21 * t420;
  const Scalar t447 = t446 + c_21 * t435;
  const Scalar t448 = s_21 * t434 + Scalar(76.25) * t447 + c_21 * t433;
  const Scalar Iu_20_t_xz = c_20 * t448 - s_20 * t445;
  const Scalar t449 = s_19 * Iu_20_t_xz;
  const Scalar t450 = Scalar(2.0) * t449 + c_19 * (t442 + t444);
  const Scalar t451 = c_26 * t389 + c_19 * t450;
  const Scalar t452 = t371 + Scalar(0.006644);
  const Scalar t453 = c_27 * t378 + s_27 * t452;
  const Scalar t454 = t428 + Scalar(0.006644);
  const Scalar t455 = c_20 * t437 + s_20 * t454;
  const Scalar t456 = Scalar(-120.0) * (t453 - t455);
  const Scalar Iu_18_t_g = Scalar(0.0044) * c_18 + Scalar(0.024) * s_18;
  const Scalar t457 = s_18 * Iu_18_t_g;
  const Scalar Iu_18_t_xx = t457 - Scalar(0.024);
  const Scalar Iu_17_t_d = Iu_18_t_xx - Scalar(0.0002);
  const Scalar t458 = s_17 * s_17;
  const Scalar t459 = Iu_17_t_d * t458;
  const Scalar Ic_16_zz = Iu_18_t_xx - t459 + Scalar(0.035005);
  const Scalar hu_18_a_z = Scalar(0.00008) * c_18 + Scalar(0.00088) * s_18;
  const Scalar f_u_18_18_a_z = Scalar(0.00088) * c_18 - Scalar(0.00008) * s_18;
  const Scalar t460 = s_16 * s_17;
  const Scalar hu_16_a_z = c_16 * hu_18_a_z + f_u_18_18_a_z * t460;
  const Scalar t461 = Scalar(1.5) * hu_16_a_z;
  const Scalar t462 = t461 - Ic_16_zz + t384 + t444 - t451 + t456 - Scalar(1.3635755942203491);
  const Scalar t463 = Scalar(0.2650964999999998) + t373 + t382;
  const Scalar t464 = Scalar(0.2650964999999998) + t430 + t441;
  const Scalar hu_27_t_x = c_27 * t452 - s_27 * t378;
  const Scalar t465 = s_26 * t386;
  const Scalar t466 = t465 + c_26 * hu_27_t_x;
  const Scalar hu_20_t_x = c_20 * t454 - s_20 * t437;
  const Scalar t467 = s_19 * t447;
  const Scalar hu_19_t_x = c_19 * hu_20_t_x - t467;
  const Scalar t468 = c_17 * f_u_18_18_a_z;
  const Scalar t469 = Scalar(165.0) * (t466 + hu_19_t_x) - Scalar(226.5) * t468;
  const Scalar Iu_17_t_xx = Scalar(0.0002) + t459;
  const Scalar Iu_16_t_d = t457 + Iu_17_t_xx;
  const Scalar Iu_18_a_yz = c_18 * Iu_18_t_g - Scalar(0.0022);
  const Scalar t470 = Iu_18_a_yz * t460;
  const Scalar Iu_16_t_g = c_16 * Iu_16_t_d + Scalar(2.0) * t470;
  const Scalar t471 = c_16 * Iu_16_t_g;
  const Scalar t472 = t461 + t457 - t471 + t463 + t464 + t469 - Scalar(3.904841427553016);
  const Scalar t473 = t438 - c_20 * t440;
  const Scalar t474 = c_20 * t445 + s_20 * t448;
  const Scalar t475 = Scalar(60.0) * hu_19_t_x + s_19 * t474 + c_19 * t473;
  const Scalar t476 = t379 - c_27 * t381;
  const Scalar Iu_27_t_yz = c_27 * Iu_28_a_yz - s_27 * t387;
  const Scalar t477 = Scalar(60.0) * t466 - s_26 * Iu_27_t_yz - c_26 * t476;
  const Scalar t478 = c_16 * s_17;
  const Scalar t479 = f_u_18_18_a_z * t478 - s_16 * hu_18_a_z;
  const Scalar t480 = Scalar(113.25) * t479 - c_17 * (Iu_17_t_d * t478 + s_16 * Iu_18_a_yz);
  const Scalar t481 = t475 - t480 - t477 + Scalar(82.5) * (t453 + t455);
  const Scalar t482 = Scalar(2.0) * s_15;
  const Scalar t483 = t481 * t482 + c_15 * (t462 - t472);
  const Scalar t484 = c_15 * t483;
  const Scalar t485 = t484 + t472;
  const Scalar t486 = Iu_17_t_xx - t471 + Iu_27_t_xx + t442 - t451 - t456 - t469 +
      Scalar(3.5628264999996673);
  const Scalar t487 = c_26 * t386;
  const Scalar t488 = t487 - s_26 * hu_27_t_x;
  const Scalar t489 = c_19 * t447;
  const Scalar hu_19_t_y = t489 + s_19 * hu_20_t_x;
  const Scalar t490 = c_16 * Iu_18_a_yz;
  const Scalar t491 = c_17 * (t490 - Iu_17_t_d * t460) + Scalar(113.25) * hu_16_a_z;
  const Scalar t492 = Scalar(0.75) * f_u_18_18_a_z;
  const Scalar t493 = c_17 * t492 - t491 - Scalar(0.043998) + Iu_27_a_xz - Iu_20_t_xz -
      Scalar(82.5) * (t488 - hu_19_t_y) + s_26 * t389 + s_19 * t450;
  const Scalar t494 = Scalar(60.0) * hu_19_t_y - c_19 * t474 + s_19 * t473;
  const Scalar t495 = Scalar(60.0) * t488 - c_26 * Iu_27_t_yz + s_26 * t476;
  const Scalar t496 = Scalar(0.75) * t479 - s_17 * Iu_18_a_yz + s_16 * Iu_16_t_g + t494 + t495;
  const Scalar t497 = c_14 * (c_15 * t493 - s_15 * t496);
  const Scalar t498 = s_14 * (Scalar(2.0) * t497 -
      s_14 * (Scalar(0.8084599275533488) + t486 + t485));
  const Scalar t499 = c_14 * (t481 - s_15 * t483);
  const Scalar t500 = Scalar(82.5) * t466 + t463;
  const Scalar t501 = c_14 * (c_15 * t477 - s_15 * t500);
  const Scalar t502 = t383 - Scalar(60.0) * t453;
  const Scalar t503 = c_26 * Iu_27_a_xz + s_26 * t502;
  const Scalar mu_27_15_y = Iu_27_t_yz + Scalar(82.5) * s_26 * t453;
  const Scalar t504 = c_14 * (c_15 * t503 + s_15 * mu_27_15_y);
  const Scalar t505 = s_27 * t379 + c_27 * Ic_28_zz;
  const Scalar f_u_28_26_t_y = c_26 * t378 - s_27 * t465;
  const Scalar t506 = Scalar(60.0) * f_u_28_26_t_y - s_26 * t387 + c_26 * t505;
  const Scalar t507 = t380 - s_27 * Ic_28_zz;
  const Scalar t508 = t507 - Scalar(82.5) * f_u_28_26_t_y;
  const Scalar t509 = c_14 * (c_15 * t506 + s_15 * t508);
  const Scalar t510 = t361 - t363 - Scalar(76.25) * t371;
  const Scalar t511 = s_28 * Iu_29_t_xz - c_28 * t510;
  const Scalar t512 = c_27 * t375 + s_27 * t511;
  const Scalar t513 = c_28 * Iu_29_t_xz + s_28 * t510;
  const Scalar t514 = s_28 * t371;
  const Scalar t515 = c_27 * t363 + s_27 * t514;
  const Scalar t516 = c_28 * t371;
  const Scalar t517 = c_26 * t516 + s_26 * t515;
  const Scalar t518 = Scalar(60.0) * t517 + c_26 * t512 - s_26 * t513;
  const Scalar mu_u_29_27_t_y = c_27 * t511 - s_27 * t375;
  const Scalar mu_29_15_y = mu_u_29_27_t_y - Scalar(82.5) * t517;
  const Scalar t519 = c_14 * (c_15 * t518 + s_15 * mu_29_15_y);
  const Scalar mu_30_29_y = t350 + mu_u_30_30_a_y;
  const Scalar t520 = c_29 * t357 - s_29 * mu_30_29_y;
  const Scalar t521 = s_29 * hu_30_t_y;
  const Scalar mu_30_28_y = mu_30_29_z - t521;
  const Scalar t522 = c_29 * t377 + s_28 * t350;
  const Scalar t523 = Scalar(76.25) * t522 + c_28 * mu_30_28_y + s_28 * t520;
  const Scalar t524 = t350 - c_29 * mu_30_29_y - s_29 * t357;
  const Scalar t525 = c_27 * t524 + s_27 * t523;
  const Scalar t526 = c_28 * t350 - c_29 * t385;
  const Scalar t527 = Scalar(76.25) * t526 + c_28 * t520 - s_28 * mu_30_28_y;
  const Scalar t528 = c_27 * t521 + s_27 * t526;
  const Scalar f_u_30_26_t_y = c_26 * t522 - s_26 * t528;
  const Scalar t529 = Scalar(60.0) * f_u_30_26_t_y + c_26 * t525 - s_26 * t527;
  const Scalar mu_u_30_27_t_y = c_27 * t523 - s_27 * t524;
  const Scalar mu_30_15_y = mu_u_30_27_t_y - Scalar(82.5) * f_u_30_26_t_y;
  const Scalar t530 = c_14 * (c_15 * t529 + s_15 * mu_30_15_y);
  const Scalar t531 = c_30 * t346 - c_31 * t366;
  const Scalar t532 = s_31 * t348;
  const Scalar f_u_32_29_t_x = s_29 * t532 + c_29 * t531;
  const Scalar f_u_32_30_t_y = c_31 * t349 + s_30 * t346;
  const Scalar f_u_32_28_t_x = s_28 * f_u_32_29_t_x + c_28 * f_u_32_30_t_y;
  const Scalar f_u_32_29_a_z = c_29 * t532 - s_29 * t531;
  const Scalar t533 = c_27 * f_u_32_29_a_z + s_27 * f_u_32_28_t_x;
  const Scalar t534 = c_28 * f_u_32_29_t_x - s_28 * f_u_32_30_t_y;
  const Scalar f_u_32_26_a_z = c_26 * t534 + s_26 * t533;
  const Scalar t535 = Scalar(0.0007482) * t342 + Scalar(0.0014129000000002) * s_31;
  const Scalar mu_32_29_z = t532 + t367 - c_30 * t535 - Scalar(59.75) * t531;
  const Scalar mu_32_28_y = mu_32_29_z - f_u_32_29_a_z;
  const Scalar mu_32_29_x = t356 + s_30 * t535 + Scalar(59.75) * f_u_32_30_t_y;
  const Scalar mu_u_32_31_t_y = Scalar(0.0014129000000002) * c_31 - Scalar(0.0007482) * t338;
  const Scalar t536 = mu_u_32_31_t_y - f_u_32_30_t_y;
  const Scalar mu_u_32_29_t_x = s_29 * t536 + c_29 * mu_32_29_x;
  const Scalar t537 = Scalar(76.25) * t534 - s_28 * mu_u_32_29_t_x - c_28 * mu_32_28_y;
  const Scalar mu_32_28_z = f_u_32_30_t_y + c_29 * t536 - s_29 * mu_32_29_x;
  const Scalar t538 = c_27 * mu_32_28_z - s_27 * t537;
  const Scalar mu_32_27_z = c_28 * mu_u_32_29_t_x + Scalar(76.25) * f_u_32_28_t_x -
      s_28 * mu_32_28_y;
  const Scalar mu_32_15_x = Scalar(60.0) * f_u_32_26_a_z - c_26 * t538 + s_26 * mu_32_27_z;
  const Scalar t539 = s_27 * mu_32_28_z + c_27 * t537;
  const Scalar t540 = t539 - Scalar(82.5) * f_u_32_26_a_z;
  const Scalar mu_u_32_15_t_x = c_15 * mu_32_15_x + s_15 * t540;
  const Scalar t541 = c_26 * t533 - s_26 * t534;
  const Scalar t542 = c_27 * f_u_32_28_t_x - s_27 * f_u_32_29_a_z;
  const Scalar t543 = Scalar(82.5) * t542 - Scalar(60.0) * t541 - c_26 * mu_32_27_z - s_26 * t538;
  const Scalar mu_u_32_14_t_y = c_14 * mu_u_32_15_t_x - s_14 * t543;
  const Scalar t544 = Scalar(0.5295491542217383) * s_32;
  const Scalar t545 = Ic_31_zz + Scalar(59.75) * hu_30_a_y;
  const Scalar mu_31_29_x = t343 * t367 + c_30 * t545;
  const Scalar t546 = c_30 * hu_30_a_y;
  const Scalar t547 = t354 * t355;
  const Scalar t548 = t546 - t547;
  const Scalar t549 = c_29 * mu_31_29_x - s_29 * t548;
  const Scalar t550 = s_30 * hu_30_a_y;
  const Scalar t551 = c_29 * t550 - s_29 * hu_31_t_x;
  const Scalar f_u_31_28_t_y = c_28 * t551 + s_28 * t546;
  const Scalar mu_31_29_z = hu_31_t_x - t343 * t356 + s_30 * t545;
  const Scalar f_u_31_29_a_z = c_29 * hu_31_t_x + s_29 * t550;
  const Scalar mu_31_28_y = mu_31_29_z - f_u_31_29_a_z;
  const Scalar mu_31_27_x = s_28 * t549 + c_28 * mu_31_28_y + Scalar(76.25) * f_u_31_28_t_y;
  const Scalar mu_31_28_z = t546 - c_29 * t548 - s_29 * mu_31_29_x;
  const Scalar t552 = c_27 * mu_31_28_z + s_27 * mu_31_27_x;
  const Scalar f_u_31_28_t_x = c_28 * t546 - s_28 * t551;
  const Scalar t553 = c_27 * f_u_31_29_a_z + s_27 * f_u_31_28_t_x;
  const Scalar t554 = c_26 * f_u_31_28_t_y - s_26 * t553;
  const Scalar mu_31_27_z = c_28 * t549 - s_28 * mu_31_28_y + Scalar(76.25) * f_u_31_28_t_x;
  const Scalar t555 = Scalar(60.0) * t554 + c_26 * t552 - s_26 * mu_31_27_z;
  const Scalar t556 = c_27 * mu_31_27_x - s_27 * mu_31_28_z;
  const Scalar t557 = t556 - Scalar(82.5) * t554;
  const Scalar t558 = c_14 * (c_15 * t555 + s_15 * t557);
  const Scalar t559 = c_26 * t553 + s_26 * f_u_31_28_t_y;
  const Scalar t560 = c_27 * f_u_31_28_t_x - s_27 * f_u_31_29_a_z;
  const Scalar t561 = Scalar(-60.0) * t559 - c_26 * mu_31_27_z - s_26 * t552 + Scalar(82.5) * t560;
  const Scalar b_32_31_13 = mu_u_32_14_t_y * t544 + t558 + s_14 * t561;
  const Scalar t562 = Scalar(0.00039620867718870463) * t335 - Ic_31_zz;
  const Scalar t563 = Scalar(1.0) / t562;
  const Scalar t564 = t547 - mu_u_32_31_t_y * t544;
  const Scalar t565 = t564 * t563;
  const Scalar t566 = c_26 * t528 + s_26 * t522;
  const Scalar t567 = c_27 * t526 - s_27 * t521;
  const Scalar t568 = Scalar(82.5) * t567 - Scalar(60.0) * t566 - c_26 * t527 - s_26 * t525;
  const Scalar t569 = Scalar(707.7641729774637) * mu_u_32_31_t_y;
  const Scalar t570 = mu_u_32_14_t_y * t569 + b_32_31_13 * t565 + t530 + s_14 * t568;
  const Scalar b_32_31_29 = mu_31_29_z - mu_32_29_z * t544;
  const Scalar b_31_30_29 = b_32_31_29 * t565 - mu_32_29_z * t569 + mu_30_29_z;
  const Scalar t571 = mu_u_32_31_t_y * t569 - t564 * t565 + mu_u_30_30_a_y;
  const Scalar t572 = Scalar(1.0) / t571;
  const Scalar t573 = b_31_30_29 * t572;
  const Scalar f_u_29_26_t_x = c_26 * t515 - s_26 * t516;
  const Scalar t574 = c_27 * t514 - s_27 * t363;
  const Scalar mu_29_15_z = s_26 * t512 - Scalar(60.0) * f_u_29_26_t_x + Scalar(82.5) * t574 +
      c_26 * t513;
  const Scalar t575 = b_32_31_29 * t563;
  const Scalar t576 = Scalar(707.7641729774637) * mu_32_29_z;
  const Scalar t577 = mu_u_32_14_t_y * t576 + b_32_31_13 * t575 + t570 * t573 + t519 -
      s_14 * mu_29_15_z;
  const Scalar b_32_31_28 = mu_31_28_z - mu_32_28_z * t544;
  const Scalar t578 = b_32_31_28 * t565 - mu_32_28_z * t569 + t524;
  const Scalar t579 = t375 - mu_32_28_z * t576 + b_32_31_28 * t575 + t578 * t573;
  const Scalar t580 = mu_32_29_z * t576 - b_31_30_29 * t573 - b_32_31_29 * t575 + t361;
  const Scalar t581 = Scalar(1.0) / t580;
  const Scalar t582 = t579 * t581;
  const Scalar t583 = s_27 * t487 + s_26 * t378;
  const Scalar t584 = Scalar(60.0) * t583 - Scalar(82.5) * c_27 * t386 + c_26 * t387 + s_26 * t505;
  const Scalar t585 = t578 * t572;
  const Scalar t586 = b_32_31_28 * t563;
  const Scalar t587 = Scalar(707.7641729774637) * mu_32_28_z;
  const Scalar t588 = mu_u_32_14_t_y * t587 + b_32_31_13 * t586 + t570 * t585 + t577 * t582 + t509 -
      s_14 * t584;
  const Scalar b_32_31_27 = mu_31_27_z - mu_32_27_z * t544;
  const Scalar t589 = b_32_31_27 * t565 - mu_32_27_z * t569 + t527;
  const Scalar t590 = t589 * t573 - mu_32_27_z * t576 + b_32_31_27 * t575 + t513;
  const Scalar t591 = b_32_31_27 * t586 - mu_32_27_z * t587 + t589 * t585 + t590 * t582 + t387;
  const Scalar b_29_28_28 = t579 * t582 - mu_32_28_z * t587 + b_32_31_28 * t586 + t578 * t585 +
      Ic_28_zz;
  const Scalar d_28 = Scalar(1.0) / b_29_28_28;
  const Scalar t592 = t591 * d_28;
  const Scalar mu_u_27_15_a_y = Scalar(82.5) * hu_27_t_x - t388 + c_26 * t502;
  const Scalar t593 = t590 * t581;
  const Scalar t594 = t589 * t572;
  const Scalar t595 = b_32_31_27 * t563;
  const Scalar t596 = Scalar(707.7641729774637) * mu_32_27_z;
  const Scalar t597 = mu_u_32_14_t_y * t596 + t570 * t594 + b_32_31_13 * t595 + t577 * t593 -
      t588 * t592 + t504 + s_14 * mu_u_27_15_a_y;
  const Scalar t598 = t539 * t544 + t556;
  const Scalar b_31_30_26 = t598 * t565 + t539 * t569 + mu_u_30_27_t_y;
  const Scalar b_30_29_26 = t539 * t576 + b_31_30_26 * t573 + t598 * t575 + mu_u_29_27_t_y;
  const Scalar t599 = t539 * t587 + t598 * t586 + b_31_30_26 * t585 + b_30_29_26 * t582 + t507;
  const Scalar b_28_27_26 = t539 * t596 + t598 * t595 + b_31_30_26 * t594 + Iu_27_t_yz +
      b_30_29_26 * t593 - t599 * t592;
  const Scalar t600 = mu_32_27_z * t596 - b_32_31_27 * t595 - t589 * t594 + t591 * t592 -
      t590 * t593 + t383;
  const Scalar t601 = Scalar(1.0) / t600;
  const Scalar t602 = b_28_27_26 * t601;
  const Scalar t603 = t599 * d_28;
  const Scalar t604 = b_30_29_26 * t581;
  const Scalar t605 = b_31_30_26 * t572;
  const Scalar t606 = t598 * t563;
  const Scalar t607 = Scalar(707.7641729774637) * t539;
  const Scalar t608 = b_32_31_13 * t606 - mu_u_32_14_t_y * t607 + t570 * t605 + t577 * t604 +
      s_14 * t495 - t588 * t603 + t597 * t602 + t501;
  const Scalar t609 = t561 - t543 * t544;
  const Scalar t610 = t609 * t565 - t543 * t569 + t568;
  const Scalar b_30_29_15 = t543 * t576 - t610 * t573 - t609 * t575 + mu_29_15_z;
  const Scalar t611 = t543 * t587 - t609 * t586 - t610 * t585 + b_30_29_15 * t582 + t584;
  const Scalar t612 = t610 * t594 - t543 * t596 + t609 * t595 + t611 * t592 - b_30_29_15 * t593 +
      mu_u_27_15_a_y;
  const Scalar t613 = t543 * t607 + t610 * t605 + t609 * t606 - b_30_29_15 * t604 + t495 +
      t611 * t603 + t612 * t602;
  const Scalar t614 = t539 * t607 - t598 * t606 - b_31_30_26 * t605 - b_30_29_26 * t604 -
      b_28_27_26 * t602 + t599 * t603 + t463;
  const Scalar t615 = Scalar(1.0) / t614;
  const Scalar t616 = t613 * t615;
  const Scalar t617 = Scalar(82.5) * hu_19_t_x + t464;
  const Scalar mu_u_19_15_t_x = c_15 * t475 + s_15 * t617;
  const Scalar t618 = Scalar(60.0) * t455 + t443;
  const Scalar t619 = c_19 * Iu_20_t_xz - s_19 * t618;
  const Scalar t620 = t474 + Scalar(82.5) * s_19 * t455;
  const Scalar t621 = c_14 * (c_15 * t619 - s_15 * t620);
  const Scalar t622 = s_20 * t438 + c_20 * t431;
  const Scalar t623 = s_20 * t467 + c_19 * t437;
  const Scalar t624 = Scalar(60.0) * t623 - s_19 * t448 - c_19 * t622;
  const Scalar t625 = t439 - s_20 * t431;
  const Scalar t626 = t625 - Scalar(82.5) * t623;
  const Scalar mu_u_21_15_t_x = c_15 * t624 - s_15 * t626;
  const Scalar t627 = f_u_22_22_a_z + t415 - Scalar(76.25) * t428;
  const Scalar t628 = s_21 * t424 - c_21 * t627;
  const Scalar t629 = c_20 * t434 + s_20 * t628;
  const Scalar t630 = c_21 * t424 + s_21 * t627;
  const Scalar t631 = s_21 * t428;
  const Scalar t632 = c_20 * f_u_22_22_a_z - s_20 * t631;
  const Scalar t633 = c_21 * t428;
  const Scalar t634 = c_19 * t633 - s_19 * t632;
  const Scalar t635 = Scalar(60.0) * t634 - c_19 * t629 + s_19 * t630;
  const Scalar t636 = c_20 * t628 - s_20 * t434;
  const Scalar t637 = t636 - Scalar(82.5) * t634;
  const Scalar t638 = c_14 * (c_15 * t635 - s_15 * t637);
  const Scalar mu_23_22_y = mu_u_23_23_a_y - t405;
  const Scalar t639 = c_22 * t411 + s_22 * mu_23_22_y;
  const Scalar t640 = s_22 * t420;
  const Scalar t641 = t423 - t640;
  const Scalar t642 = c_22 * t436 - s_21 * t405;
  const Scalar t643 = Scalar(76.25) * t642 + c_21 * t641 - s_21 * t639;
  const Scalar t644 = t405 + c_22 * mu_23_22_y - s_22 * t411;
  const Scalar mu_u_23_20_t_x = c_20 * t644 - s_20 * t643;
  const Scalar t645 = c_22 * t446 + c_21 * t405;
  const Scalar t646 = Scalar(76.25) * t645 + c_21 * t639 + s_21 * t641;
  const Scalar t647 = c_20 * t640 - s_20 * t645;
  const Scalar t648 = c_19 * t642 - s_19 * t647;
  const Scalar t649 = Scalar(60.0) * t648 + c_19 * mu_u_23_20_t_x - s_19 * t646;
  const Scalar mu_u_23_20_t_y = c_20 * t643 + s_20 * t644;
  const Scalar mu_23_15_y = mu_u_23_20_t_y - Scalar(82.5) * t648;
  const Scalar t650 = c_14 * (c_15 * t649 - s_15 * mu_23_15_y);
  const Scalar t651 = c_23 * t401 - c_24 * t419;
  const Scalar t652 = s_24 * t403;
  const Scalar t653 = s_22 * t652 + c_22 * t651;
  const Scalar t654 = c_24 * t404 + s_23 * t401;
  const Scalar t655 = s_21 * t653 + c_21 * t654;
  const Scalar f_u_25_22_t_y = c_22 * t652 - s_22 * t651;
  const Scalar f_u_25_20_t_x = c_20 * f_u_25_22_t_y + s_20 * t655;
  const Scalar t656 = c_21 * t653 - s_21 * t654;
  const Scalar f_u_25_19_t_y = c_19 * t656 + s_19 * f_u_25_20_t_x;
  const Scalar t657 = Scalar(0.0014129000000002) * s_24 - Scalar(0.0007482) * t397;
  const Scalar t658 = t652 + t422 + c_23 * t657 - Scalar(59.75) * t651;
  const Scalar t659 = t658 - f_u_25_22_t_y;
  const Scalar t660 = t410 - s_23 * t657 + Scalar(59.75) * t654;
  const Scalar mu_u_25_24_t_y = Scalar(0.0007482) * t393 + Scalar(0.0014129000000002) * c_24;
  const Scalar t661 = t654 + mu_u_25_24_t_y;
  const Scalar t662 = c_22 * t660 - s_22 * t661;
  const Scalar t663 = Scalar(76.25) * t656 - s_21 * t662 - c_21 * t659;
  const Scalar t664 = t654 - c_22 * t661 - s_22 * t660;
  const Scalar mu_u_25_20_t_x = c_20 * t664 - s_20 * t663;
  const Scalar mu_u_25_20_a_y = c_21 * t662 + Scalar(76.25) * t655 - s_21 * t659;
  const Scalar mu_25_15_x = Scalar(60.0) * f_u_25_19_t_y + c_19 * mu_u_25_20_t_x -
      s_19 * mu_u_25_20_a_y;
  const Scalar mu_u_25_20_t_y = s_20 * t664 + c_20 * t663;
  const Scalar mu_25_15_y = mu_u_25_20_t_y - Scalar(82.5) * f_u_25_19_t_y;
  const Scalar f_u_25_19_t_x = c_19 * f_u_25_20_t_x - s_19 * t656;
  const Scalar t665 = c_20 * t655 - s_20 * f_u_25_22_t_y;
  const Scalar t666 = Scalar(82.5) * t665 + Scalar(60.0) * f_u_25_19_t_x - c_19 * mu_u_25_20_a_y -
      s_19 * mu_u_25_20_t_x;
  const Scalar t667 = c_14 * (c_15 * mu_25_15_x - s_15 * mu_25_15_y) + s_14 * t666;
  const Scalar t668 = Scalar(0.5295491542217383) * s_25;
  const Scalar t669 = Ic_24_zz + Scalar(59.75) * hu_23_a_y;
  const Scalar t670 = t398 * t422 - c_23 * t669;
  const Scalar t671 = c_23 * hu_23_a_y;
  const Scalar t672 = t408 * t409;
  const Scalar mu_24_22_y = t671 + t672;
  const Scalar t673 = s_22 * mu_24_22_y + c_22 * t670;
  const Scalar t674 = s_23 * hu_23_a_y;
  const Scalar t675 = c_22 * t674 - s_22 * hu_24_t_x;
  const Scalar f_u_24_21_t_y = c_21 * t675 + s_21 * t671;
  const Scalar mu_24_22_z = t398 * t410 + hu_24_t_x + s_23 * t669;
  const Scalar f_u_24_22_a_z = c_22 * hu_24_t_x + s_22 * t674;
  const Scalar mu_24_21_y = mu_24_22_z - f_u_24_22_a_z;
  const Scalar mu_24_20_x = c_21 * mu_24_21_y - s_21 * t673 + Scalar(76.25) * f_u_24_21_t_y;
  const Scalar mu_24_21_z = t671 - c_22 * mu_24_22_y + s_22 * t670;
  const Scalar t676 = c_20 * mu_24_21_z + s_20 * mu_24_20_x;
  const Scalar f_u_24_21_t_x = c_21 * t671 - s_21 * t675;
  const Scalar t677 = c_20 * f_u_24_22_a_z + s_20 * f_u_24_21_t_x;
  const Scalar t678 = c_19 * f_u_24_21_t_y - s_19 * t677;
  const Scalar mu_24_20_z = -c_21 * t673 - s_21 * mu_24_21_y + Scalar(76.25) * f_u_24_21_t_x;
  const Scalar t679 = Scalar(60.0) * t678 - c_19 * t676 + s_19 * mu_24_20_z;
  const Scalar t680 = c_20 * mu_24_20_x - s_20 * mu_24_21_z;
  const Scalar t681 = t680 - Scalar(82.5) * t678;
  const Scalar mu_u_24_15_t_x = c_15 * t679 - s_15 * t681;
  const Scalar t682 = c_19 * t677 + s_19 * f_u_24_21_t_y;
  const Scalar t683 = c_20 * f_u_24_21_t_x - s_20 * f_u_24_22_a_z;
  const Scalar t684 = Scalar(60.0) * t682 - c_19 * mu_24_20_z - s_19 * t676 + Scalar(82.5) * t683;
  const Scalar t685 = t667 * t668 + c_14 * mu_u_24_15_t_x - s_14 * t684;
  const Scalar t686 = Scalar(0.00039620867718870463) * t390 - Ic_24_zz;
  const Scalar t687 = Scalar(1.0) / t686;
  const Scalar t688 = t672 - mu_u_25_24_t_y * t668;
  const Scalar t689 = t688 * t687;
  const Scalar t690 = c_19 * t647 + s_19 * t642;
  const Scalar t691 = c_20 * t645 + s_20 * t640;
  const Scalar t692 = Scalar(82.5) * t691 - Scalar(60.0) * t690 - c_19 * t646 -
      s_19 * mu_u_23_20_t_x;
  const Scalar t693 = Scalar(707.7641729774637) * mu_u_25_24_t_y;
  const Scalar t694 = -t667 * t693 - t685 * t689 + t650 + s_14 * t692;
  const Scalar b_25_24_22 = mu_24_22_z - t658 * t668;
  const Scalar t695 = t658 * t693 - b_25_24_22 * t689 + t423;
  const Scalar t696 = mu_u_25_24_t_y * t693 - t688 * t689 + mu_u_23_23_a_y;
  const Scalar t697 = Scalar(1.0) / t696;
  const Scalar t698 = t695 * t697;
  const Scalar t699 = c_19 * t632 + s_19 * t633;
  const Scalar t700 = c_20 * t631 + s_20 * f_u_22_22_a_z;
  const Scalar mu_22_15_z = s_19 * t629 - Scalar(60.0) * t699 + Scalar(82.5) * t700 + c_19 * t630;
  const Scalar t701 = b_25_24_22 * t687;
  const Scalar t702 = Scalar(707.7641729774637) * t658;
  const Scalar t703 = t667 * t702 + t685 * t701 + t694 * t698 + t638 + s_14 * mu_22_15_z;
  const Scalar b_25_24_21 = mu_24_21_z - t664 * t668;
  const Scalar t704 = b_25_24_21 * t689 - t664 * t693 + t644;
  const Scalar t705 = t434 - t664 * t702 + b_25_24_21 * t701 - t704 * t698;
  const Scalar t706 = t658 * t702 - t695 * t698 - b_25_24_22 * t701 + t415;
  const Scalar t707 = Scalar(1.0) / t706;
  const Scalar t708 = t705 * t707;
  const Scalar f_u_21_19_t_x = s_20 * t489 - s_19 * t437;
  const Scalar mu_21_15_z = Scalar(60.0) * f_u_21_19_t_x + Scalar(82.5) * c_20 * t447 -
      c_19 * t448 + s_19 * t622;
  const Scalar t709 = t704 * t697;
  const Scalar t710 = b_25_24_21 * t687;
  const Scalar t711 = Scalar(707.7641729774637) * t664;
  const Scalar t712 = t667 * t711 + t685 * t710 - t694 * t709 + t703 * t708 +
      c_14 * mu_u_21_15_t_x + s_14 * mu_21_15_z;
  const Scalar b_25_24_20 = mu_24_20_z - mu_u_25_20_a_y * t668;
  const Scalar t713 = b_25_24_20 * t689 - mu_u_25_20_a_y * t693 + t646;
  const Scalar t714 = -mu_u_25_20_a_y * t702 - t713 * t698 + b_25_24_20 * t701 + t630;
  const Scalar t715 = mu_u_25_20_a_y * t711 - b_25_24_20 * t710 - t713 * t709 - t714 * t708 + t448;
  const Scalar t716 = t705 * t708 - t664 * t711 + b_25_24_21 * t710 + t704 * t709 + t431;
  const Scalar t717 = Scalar(1.0) / t716;
  const Scalar t718 = t715 * t717;
  const Scalar mu_u_20_15_a_y = t449 + Scalar(82.5) * hu_20_t_x + c_19 * t618;
  const Scalar t719 = t714 * t707;
  const Scalar t720 = t713 * t697;
  const Scalar t721 = b_25_24_20 * t687;
  const Scalar t722 = Scalar(707.7641729774637) * mu_u_25_20_a_y;
  const Scalar t723 = t667 * t722 - t694 * t720 + t685 * t721 + t703 * t719 + t712 * t718 + t621 -
      s_14 * mu_u_20_15_a_y;
  const Scalar t724 = mu_u_25_20_t_y * t668 + t680;
  const Scalar b_24_23_19 = -t724 * t689 - mu_u_25_20_t_y * t693 + mu_u_23_20_t_y;
  const Scalar t725 = mu_u_25_20_t_y * t702 + b_24_23_19 * t698 + t724 * t701 + t636;
  const Scalar t726 = mu_u_25_20_t_y * t711 + t724 * t710 - b_24_23_19 * t709 + t725 * t708 + t625;
  const Scalar t727 = mu_u_25_20_t_y * t722 + t724 * t721 - b_24_23_19 * t720 + t474 + t725 * t719 +
      t726 * t718;
  const Scalar t728 = mu_u_25_20_a_y * t722 - b_25_24_20 * t721 - t713 * t720 + t715 * t718 -
      t714 * t719 + t443;
  const Scalar t729 = Scalar(1.0) / t728;
  const Scalar t730 = t727 * t729;
  const Scalar t731 = t726 * t717;
  const Scalar t732 = t725 * t707;
  const Scalar t733 = b_24_23_19 * t697;
  const Scalar t734 = t724 * t687;
  const Scalar t735 = Scalar(707.7641729774637) * mu_u_25_20_t_y;
  const Scalar t736 = t685 * t734 - t667 * t735 + t694 * t733 + t703 * t732 - s_14 * t494 -
      t712 * t731 + t723 * t730 + c_14 * mu_u_19_15_t_x;
  const Scalar t737 = t684 - t666 * t668;
  const Scalar t738 = t737 * t689 - t666 * t693 + t692;
  const Scalar b_23_22_15 = t666 * t702 + t738 * t698 - t737 * t701 + mu_22_15_z;
  const Scalar b_22_21_15 = t666 * t711 - t737 * t710 - t738 * t709 + b_23_22_15 * t708 +
      mu_21_15_z;
  const Scalar t739 = t738 * t720 - t666 * t722 + t737 * t721 - b_22_21_15 * t718 -
      b_23_22_15 * t719 + mu_u_20_15_a_y;
  const Scalar t740 = t666 * t735 - t738 * t733 + t737 * t734 - b_23_22_15 * t732 + t494 +
      b_22_21_15 * t731 + t739 * t730;
  const Scalar t741 = mu_u_25_20_t_y * t735 - t724 * t734 - b_24_23_19 * t733 - t725 * t732 -
      t727 * t730 + t726 * t731 + t464;
  const Scalar t742 = Scalar(1.0) / t741;
  const Scalar t743 = t740 * t742;
  const Scalar t744 = t612 * t601;
  const Scalar t745 = t739 * t729;
  const Scalar t746 = t611 * d_28;
  const Scalar t747 = b_22_21_15 * t717;
  const Scalar t748 = b_30_29_15 * t581;
  const Scalar t749 = b_23_22_15 * t707;
  const Scalar t750 = t610 * t572;
  const Scalar t751 = t738 * t697;
  const Scalar t752 = t609 * t563;
  const Scalar t753 = t737 * t687;
  const Scalar t754 = t543 * mu_u_32_14_t_y - t666 * t667;
  const Scalar mu_u_17_17_a_y = t457 - Scalar(0.03438);
  const Scalar t755 = mu_u_17_17_a_y - Scalar(113.25) * t468;
  const Scalar t756 = s_16 * t755 - s_17 * (t490 - t492);
  const Scalar t757 = c_17 * (Iu_18_a_yz - c_16 * t492);
  const Scalar t758 = t470 + c_16 * t755;
  const Scalar t759 = c_14 * (c_15 * t757 + s_15 * t756) - s_14 * t758;
  const Scalar t760 = Scalar(1.0) / mu_u_17_17_a_y;
  const Scalar t761 = Iu_18_a_yz * t760;
  const Scalar t762 = c_17 * t761;
  const Scalar t763 = Ic_16_zz - Scalar(0.75) * hu_16_a_z;
  const Scalar t764 = c_14 * (c_15 * t763 + s_15 * t480);
  const Scalar f_u_18_16_t_x = hu_18_a_z * t478 + s_16 * f_u_18_18_a_z;
  const Scalar t765 = Scalar(0.03408) * s_17 - Scalar(0.75) * f_u_18_16_t_x;
  const Scalar t766 = hu_18_a_z * t460 - c_16 * f_u_18_18_a_z;
  const Scalar t767 = Scalar(0.03408) * c_17;
  const Scalar t768 = Scalar(113.25) * t766 -
      (c_16 - Scalar(22.007042253521128) * hu_18_a_z) * t767;
  const Scalar mu_u_18_15_a_y = s_16 * t767 + Scalar(113.25) * f_u_18_16_t_x;
  const Scalar mu_u_18_14_a_z = c_14 * (c_15 * t765 - s_15 * t768) + s_14 * mu_u_18_15_a_y;
  const Scalar t769 = t759 * t762 + t764 + s_14 * t491 - s_17 * mu_u_18_14_a_z;
  const Scalar t770 = Iu_18_a_yz * t761;
  const Scalar b_17_16_16 = t770 - t458 * (t770 + Scalar(0.03408)) + Ic_16_zz;
  const Scalar t771 = Scalar(1.0) / b_17_16_16;
  const Scalar t772 = t491 - t758 * t762 - s_17 * mu_u_18_15_a_y;
  const Scalar t773 = t772 * t771;
  const Scalar t774 = t758 * t760;
  const Scalar t775 = Scalar(29.342723004694836) * mu_u_18_15_a_y;
  const Scalar t776 = t759 * t774 - Scalar(707.7641729774637) * t754 - b_32_31_13 * t752 -
      t570 * t750 + t685 * t753 - t694 * t751 + mu_u_18_14_a_z * t775 + t769 * t773 + t577 * t748 -
      t588 * t746 - t703 * t749 + t712 * t747 + t497 - t597 * t744 - t608 * t616 + t723 * t745 +
      t736 * t743 - s_14 * t486;
  const Scalar Iu_15_a_xy = c_15 * t496 + s_15 * t493;
  const Scalar t777 = c_15 * t540 - s_15 * mu_32_15_x;
  const Scalar t778 = t777 * t544 - s_15 * t555 + c_15 * t557;
  const Scalar t779 = t777 * t569 + t778 * t565 + c_15 * mu_30_15_y - s_15 * t529;
  const Scalar t780 = t777 * t576 + t778 * t575 + t779 * t573 + c_15 * mu_29_15_y - s_15 * t518;
  const Scalar t781 = t777 * t587 + t778 * t586 + t779 * t585 + t780 * t582 + c_15 * t508 -
      s_15 * t506;
  const Scalar t782 = t777 * t596 + t779 * t594 + t778 * t595 + t780 * t593 - t781 * t592 +
      c_15 * mu_27_15_y - s_15 * t503;
  const Scalar t783 = t777 * t607 - t778 * t606 - t779 * t605 - t780 * t604 + s_15 * t477 +
      t781 * t603 - t782 * t602 + c_15 * t500;
  const Scalar mu_u_25_15_t_y = c_15 * mu_25_15_y + s_15 * mu_25_15_x;
  const Scalar b_25_24_14 = mu_u_25_15_t_y * t668 + s_15 * t679 + c_15 * t681;
  const Scalar t784 = -mu_u_25_15_t_y * t693 - b_25_24_14 * t689 + c_15 * mu_23_15_y + s_15 * t649;
  const Scalar t785 = mu_u_25_15_t_y * t702 + b_25_24_14 * t701 + t784 * t698 + c_15 * t637 +
      s_15 * t635;
  const Scalar t786 = mu_u_25_15_t_y * t711 + b_25_24_14 * t710 - t784 * t709 + t785 * t708 +
      c_15 * t626 + s_15 * t624;
  const Scalar t787 = mu_u_25_15_t_y * t722 - t784 * t720 + b_25_24_14 * t721 + t785 * t719 +
      t786 * t718 + c_15 * t620 + s_15 * t619;
  const Scalar t788 = mu_u_25_15_t_y * t735 - b_25_24_14 * t734 - t784 * t733 - t785 * t732 -
      s_15 * t475 + t786 * t731 - t787 * t730 + c_15 * t617;
  const Scalar t789 = t543 * t777 + t666 * mu_u_25_15_t_y;
  const Scalar t790 = c_15 * t756 - s_15 * t757;
  const Scalar t791 = s_15 * t765 + c_15 * t768;
  const Scalar t792 = t790 * t762 + c_15 * t480 - s_15 * t763 + s_17 * t791;
  const Scalar t793 = Scalar(707.7641729774637) * t789 + t779 * t750 - t784 * t751 - t790 * t774 +
      t778 * t752 + b_25_24_14 * t753 + t791 * t775 - t792 * t773 - t780 * t748 + t781 * t746 -
      t785 * t749 + t786 * t747 + Iu_15_a_xy + t782 * t744 - t783 * t616 + t787 * t745 -
      t788 * t743;
  const Scalar t794 = t543 * t543 + t666 * t666;
  const Scalar b_16_15_15 = t758 * t774 - Scalar(707.7641729774637) * t794 + t609 * t752 +
      t610 * t750 + t737 * t753 + t738 * t751 - mu_u_18_15_a_y * t775 - t772 * t773 - t611 * t746 -
      b_22_21_15 * t747 + b_30_29_15 * t748 + t613 * t616 + b_23_22_15 * t749 + t740 * t743 +
      t612 * t744 + t739 * t745 + t486;
  const Scalar t795 = Scalar(1.0) / b_16_15_15;
  const Scalar t796 = t793 * t795;
  const Scalar t797 = t783 * t615;
  const Scalar t798 = t788 * t742;
  const Scalar t799 = t782 * t601;
  const Scalar t800 = t787 * t729;
  const Scalar t801 = t781 * d_28;
  const Scalar t802 = t786 * t717;
  const Scalar t803 = t780 * t581;
  const Scalar t804 = t785 * t707;
  const Scalar t805 = t779 * t572;
  const Scalar t806 = t784 * t697;
  const Scalar t807 = t778 * t563;
  const Scalar t808 = b_25_24_14 * t687;
  const Scalar t809 = t777 * mu_u_32_14_t_y - mu_u_25_15_t_y * t667;
  const Scalar t810 = t792 * t771;
  const Scalar t811 = t790 * t760;
  const Scalar t812 = Scalar(29.342723004694836) * t791;
  const Scalar t813 = Scalar(707.7641729774637) * t809 - t570 * t805 + t694 * t806 - t759 * t811 -
      b_32_31_13 * t807 + t685 * t808 - mu_u_18_14_a_z * t812 + t769 * t810 - t577 * t803 +
      t703 * t804 + t588 * t801 - t597 * t799 - t712 * t802 + t723 * t800 - s_14 * Iu_15_a_xy +
      t608 * t797 - t736 * t798 + t499 - t776 * t796;
  const Scalar t814 = t777 * t777 + mu_u_25_15_t_y * mu_u_25_15_t_y;
  const Scalar t815 = Scalar(707.7641729774637) * t814 - t790 * t811 - t779 * t805 - t784 * t806 -
      t778 * t807 - b_25_24_14 * t808 + t791 * t812 + t792 * t810 - t780 * t803 - t785 * t804 +
      t781 * t801 - t782 * t799 + t786 * t802 - t787 * t800 - t783 * t797 - t788 * t798 +
      t793 * t796 + Scalar(0.8060099275533488) + t462 - t484;
  const Scalar t816 = Scalar(1.0) / t815;
  const Scalar t817 = t813 * t816;
  const Scalar t818 = t776 * t795;
  const Scalar t819 = t608 * t615;
  const Scalar t820 = t736 * t742;
  const Scalar t821 = t597 * t601;
  const Scalar t822 = t723 * t729;
  const Scalar t823 = t588 * d_28;
  const Scalar t824 = t712 * t717;
  const Scalar t825 = t577 * t581;
  const Scalar t826 = t703 * t707;
  const Scalar t827 = t570 * t572;
  const Scalar t828 = t694 * t697;
  const Scalar t829 = b_32_31_13 * t563;
  const Scalar t830 = t685 * t687;
  const Scalar t831 = mu_u_32_14_t_y * mu_u_32_14_t_y + t667 * t667;
  const Scalar t832 = t769 * t771;
  const Scalar t833 = t759 * t760;
  const Scalar t834 = Scalar(29.342723004694836) * mu_u_18_14_a_z;
  const Scalar t835 = Scalar(707.7641729774637) * t831 - t570 * t827 - t694 * t828 - t759 * t833 -
      b_32_31_13 * t829 - t685 * t830 + mu_u_18_14_a_z * t834 + t769 * t832 - t577 * t825 +
      t588 * t823 - t703 * t826 + t712 * t824 - t597 * t821 - t608 * t819 - t723 * t822 -
      t736 * t820 + Scalar(0.8028099275533488) - t813 * t817 + t498 + t776 * t818 + t485;
  const Scalar t836 = c_14 * qd_13;
  const Scalar t837 = c_15 * t836;
  const Scalar t838 = t837 - s_15 * qd_14;
  const Scalar t839 = s_14 * qd_13;
  const Scalar omega_15_z = qd_15 - t839;
  const Scalar t840 = t838 * omega_15_z;
  const Scalar t841 = (t837 - t482 * qd_14) * t839;
  const Scalar t842 = t840 + t841;
  const Scalar t843 = t840 + t842;
  const Scalar t844 = Scalar(2452.5) * s_14;
  const Scalar t845 = Scalar(82.5) * t843 - t844;
  const Scalar t846 = s_15 * t836;
  const Scalar t847 = c_15 * qd_14;
  const Scalar omega_r_15_y = t846 + t847;
  const Scalar t848 = omega_r_15_y * omega_15_z;
  const Scalar t849 = (t846 + Scalar(2.0) * t847) * t839;
  const Scalar domega_15_x = t848 + t849;
  const Scalar U_15_zy = t848 + domega_15_x;
  const Scalar t850 = Scalar(60.0) * U_15_zy;
  const Scalar t851 = t850 + t845;
  const Scalar t852 = t838 * t838;
  const Scalar Uz_o_15_y = t836 * t836 + qd_14 * qd_14;
  const Scalar t853 = omega_15_z * omega_15_z;
  const Scalar Uz_o_16_x = Uz_o_15_y - t852 + t853;
  const Scalar t854 = c_14 * c_15;
  const Scalar t855 = Scalar(2452.5) * t854;
  const Scalar t856 = Scalar(82.5) * Uz_o_16_x - t855;
  const Scalar t857 = t838 * omega_r_15_y;
  const Scalar t858 = qd_14 * t836;
  const Scalar U_15_xy = t858 - t857;
  const Scalar t859 = Scalar(60.0) * U_15_xy;
  const Scalar t860 = t859 + t856;
  const Scalar t861 = c_26 * t860 - s_26 * t851;
  const Scalar t862 = c_26 * t838 + s_26 * omega_15_z;
  const Scalar omega_26_z = qd_26 + omega_r_15_y;
  const Scalar t863 = t862 * omega_26_z;
  const Scalar domega_26_y = c_26 * U_15_xy - s_26 * U_15_zy + t863;
  const Scalar omega_r_27_x = c_27 * omega_26_z + s_27 * t862;
  const Scalar t864 = c_27 * t862 - s_27 * omega_26_z;
  const Scalar t865 = omega_r_27_x * t864;
  const Scalar U_27_xy = t865 + domega_26_y;
  const Scalar t866 = t858 + t857;
  const Scalar t867 = Scalar(2452.5) * c_14 * s_15;
  const Scalar t868 = Scalar(82.5) * t866 + t867;
  const Scalar t869 = t852 + t853;
  const Scalar t870 = Scalar(60.0) * t869;
  const Scalar t871 = t868 - t870;
  const Scalar t872 = Scalar(76.25) * U_27_xy - c_27 * t871 + s_27 * t861;
  const Scalar t873 = c_26 * t851 + s_26 * t860;
  const Scalar omega_r_27_a_z = c_26 * omega_15_z - s_26 * t838;
  const Scalar t874 = omega_r_27_a_z * omega_26_z;
  const Scalar t875 = s_26 * U_15_xy + c_26 * U_15_zy - Scalar(2.0) * t874;
  const Scalar t876 = t862 * omega_r_27_a_z;
  const Scalar t877 = t842 - t876;
  const Scalar omega_27_z = qd_27 + omega_r_27_a_z;
  const Scalar t878 = t864 * omega_27_z;
  const Scalar t879 = c_27 * t877 - s_27 * t875 + Scalar(2.0) * t878;
  const Scalar t880 = t873 - Scalar(76.25) * t879;
  const Scalar t881 = c_28 * t880 - s_28 * t872;
  const Scalar omega_r_28_x = c_28 * omega_27_z + s_28 * omega_r_27_x;
  const Scalar t882 = omega_r_28_x * omega_r_28_x;
  const Scalar t883 = omega_r_27_x * omega_r_27_x + omega_27_z * omega_27_z;
  const Scalar omega_28_z = qd_28 + t864;
  const Scalar t884 = omega_28_z * omega_28_z;
  const Scalar t885 = t883 - t882 + t884;
  const Scalar t886 = t885 - t881;
  const Scalar t887 = omega_r_28_x * omega_28_z;
  const Scalar t888 = s_28 * U_27_xy + c_28 * t879 - t887;
  const Scalar ddp_o_28_y = Scalar(76.25) * t883 - c_27 * t861 - s_27 * t871;
  const Scalar ddp_o_29_z = t887 - t888 + ddp_o_28_y;
  const Scalar t889 = s_29 * ddp_o_29_z + c_29 * t886;
  const Scalar t890 = c_29 * omega_r_28_x - s_29 * omega_28_z;
  const Scalar t891 = t890 * t890;
  const Scalar t892 = c_28 * omega_r_27_x - s_28 * omega_27_z;
  const Scalar omega_29_z = qd_29 + t892;
  const Scalar t893 = omega_29_z * omega_29_z;
  const Scalar t894 = t882 + t884 - t891 + t893;
  const Scalar omega_r_30_a_z = c_29 * omega_28_z + s_29 * omega_r_28_x;
  const Scalar t895 = t890 * omega_r_30_a_z;
  const Scalar t896 = t895 + t888;
  const Scalar ddp_o_30_x = t894 - Scalar(59.75) * t896 - t889;
  const Scalar Uz_28_y = c_28 * U_27_xy - s_28 * t879;
  const Scalar t897 = t892 * omega_28_z;
  const Scalar t898 = Uz_28_y - Scalar(2.0) * t897;
  const Scalar t899 = omega_r_27_x * omega_27_z;
  const Scalar t900 = s_27 * t877 + t899 + c_27 * t875;
  const Scalar t901 = omega_r_28_x * t892;
  const Scalar t902 = t901 + t900;
  const Scalar t903 = t890 * omega_29_z;
  const Scalar t904 = c_29 * t902 - t903 + s_29 * t898;
  const Scalar t905 = t903 - t904;
  const Scalar t906 = omega_r_30_a_z * omega_29_z;
  const Scalar Uz_o_30_z = c_29 * t898 - s_29 * t902 + Scalar(2.0) * t906;
  const Scalar t907 = c_28 * t872 + s_28 * t880;
  const Scalar t908 = t900 - t901;
  const Scalar t909 = t908 + t907;
  const Scalar t910 = t905 + Scalar(59.75) * Uz_o_30_z + t909;
  const Scalar t911 = c_30 * t910 + s_30 * ddp_o_30_x;
  const Scalar t912 = c_29 * ddp_o_29_z - s_29 * t886;
  const Scalar Uz_o_30_y = t891 + t893;
  const Scalar t913 = t888 - t895 + Scalar(59.75) * Uz_o_30_y + t912;
  const Scalar t914 = c_31 * t911 - s_31 * t913;
  const Scalar ddp_31_a_z = c_30 * ddp_o_30_x - s_30 * t910;
  const Scalar t915 = c_32 * ddp_31_a_z - s_32 * t914;
  const Scalar omega_r_31_a_z = c_30 * t890 + s_30 * omega_29_z;
  const Scalar omega_30_z = qd_30 + omega_r_30_a_z;
  const Scalar t916 = omega_r_31_a_z * omega_30_z;
  const Scalar t917 = c_30 * t896 + s_30 * Uz_o_30_z - Scalar(2.0) * t916;
  const Scalar omega_r_30_x = c_30 * omega_29_z - s_30 * t890;
  const Scalar t918 = omega_r_30_x * omega_r_31_a_z;
  const Scalar t919 = t904 - t918;
  const Scalar t920 = c_31 * omega_30_z - s_31 * omega_r_30_x;
  const Scalar omega_31_z = qd_31 + omega_r_31_a_z;
  const Scalar t921 = t920 * omega_31_z;
  const Scalar t922 = c_31 * t917 - s_31 * t919 + Scalar(2.0) * t921;
  const Scalar t923 = omega_r_30_x * omega_30_z;
  const Scalar t924 = -s_30 * t896 - t923 + c_30 * Uz_o_30_z;
  const Scalar omega_r_31_x = c_31 * omega_r_30_x + s_31 * omega_30_z;
  const Scalar t925 = omega_r_31_x * t920;
  const Scalar t926 = t925 + t924;
  const Scalar t927 = c_32 * t922 + s_32 * t926;
  const Scalar t928 = omega_r_31_x * omega_31_z;
  const Scalar t929 = t928 + c_31 * t919 + s_31 * t917;
  const Scalar omega_r_32_x = c_32 * omega_31_z + s_32 * omega_r_31_x;
  const Scalar t930 = c_32 * omega_r_31_x - s_32 * omega_31_z;
  const Scalar t931 = omega_r_32_x * t930;
  const Scalar t932 = Scalar(0.0007482) * t927 - Scalar(0.0005096) * t931 +
      Scalar(0.0014129000000002) * t929 - Scalar(0.0000376) * t915;
  const Scalar t933 = t932 + tau_32;
  const Scalar ddp_31_y = c_31 * t913 + s_31 * t911;
  const Scalar omega_32_z = qd_32 + t920;
  const Scalar t934 = omega_r_32_x * omega_r_32_x + omega_32_z * omega_32_z;
  const Scalar t935 = omega_r_31_x * omega_r_31_x + omega_31_z * omega_31_z;
  const Scalar U_32_yy_zz = t935 - t934;
  const Scalar t936 = t930 * omega_32_z;
  const Scalar t937 = Scalar(0.0007482) * U_32_yy_zz - Scalar(0.0009033000000002) * t936 +
      Scalar(0.0000376) * ddp_31_y;
  const Scalar t938 = t931 + t929;
  const Scalar t939 = Scalar(0.0005096) * t927 + Scalar(0.0007482) * t938 -
      Scalar(0.0019225000000002) * omega_r_32_x * omega_32_z;
  const Scalar t940 = Scalar(-0.0253235000000002) * t924;
  const Scalar t941 = s_32 * t939 + c_32 * t937 + Scalar(0.0250035000000002) * t925 - t940 +
      Scalar(0.0007608) * t914;
  const Scalar t942 = t941 - t544 * t933 + tau_31;
  const Scalar t943 = t932 + Scalar(0.0253235000000002) * t928 - Scalar(0.0250035000000002) * t929;
  const Scalar t944 = s_32 * t937 - c_32 * t939 - Scalar(0.0503270000000004) * t921 +
      Scalar(0.0007608) * ddp_31_a_z;
  const Scalar t945 = Scalar(0.0259635000000002) * t904 - Scalar(0.0253235000000002) * t918 +
      c_31 * t943 + s_31 * t944;
  const Scalar t946 = t565 * t942 + t945 - t569 * t933 + tau_30;
  const Scalar t947 = Scalar(0.0512870000000004) * t916 - s_31 * t943 + c_31 * t944;
  const Scalar t948 = Scalar(0.0007608) * t926 - Scalar(0.0000376) * (c_32 * t934 - s_32 * t938);
  const Scalar t949 = c_32 * t926 - s_32 * t922 - Scalar(2.0) * t936;
  const Scalar f_31_y = Scalar(0.0000376) * t949 + Scalar(0.0007608) * t935;
  const Scalar t950 = s_31 * f_31_y + c_31 * t948 + Scalar(0.0001312) * t911;
  const Scalar t951 = s_32 * t934 + c_32 * t938;
  const Scalar t952 = Scalar(-0.0000376) * t951 - Scalar(0.0007608) * t922 +
      Scalar(0.0001312) * ddp_31_a_z;
  const Scalar f_u_30_t_x = c_30 * t952 + s_30 * t950;
  const Scalar t953 = Scalar(0.0259635000000002) * t923 - t940 - t941;
  const Scalar t954 = c_31 * f_31_y - s_31 * t948 + Scalar(0.0001312) * t913;
  const Scalar t955 = Scalar(-0.00278) * (t894 - Uz_o_30_y) - t954 + c_30 * t947 - s_30 * t953 +
      Scalar(0.2419864999999998) * t895 + Scalar(0.2386464999999998) * t888 +
      Scalar(0.00438) * t889 + Scalar(59.75) * f_u_30_t_x;
  const Scalar t956 = tau_29 - t576 * t933 + t575 * t942 + t573 * t946 + t955;
  const Scalar t957 = c_30 * t950 - s_30 * t952;
  const Scalar t958 = Scalar(0.00278) * t905 + c_30 * t953 + s_30 * t947 +
      Scalar(0.4806329999999996) * t906 + Scalar(0.00438) * t909 - Scalar(59.75) * t957;
  const Scalar t959 = Scalar(0.00278) * Uz_o_30_z - t957 + t945 +
      Scalar(0.2386464999999998) * t903 + Scalar(0.2419864999999998) * t904;
  const Scalar f_29_z = Scalar(0.00438) * Uz_o_30_z + Scalar(0.000144) * t909 - t957;
  const Scalar t960 = f_29_z - Scalar(0.0023) * Uz_28_y + Scalar(0.2401964999999998) * t901 +
      Scalar(0.2323364999999998) * t900 - c_29 * t959 - s_29 * t958;
  const Scalar t961 = t587 * t933 - t582 * t956 - tau_28 - t586 * t942 - t585 * t946 + t960;
  const Scalar t962 = Scalar(0.0023) * t908 + Scalar(0.4725329999999996) * t897 + s_29 * t959 -
      c_29 * t958;
  const Scalar t963 = Scalar(0.00438) * t896 + Scalar(0.000144) * t889 + f_u_30_t_x;
  const Scalar f_29_y = Scalar(0.00438) * Uz_o_30_y + Scalar(0.000144) * t912 - t954;
  const Scalar t964 = Scalar(0.0000999344262295082) * t881 + c_29 * t963 - s_29 * f_29_y;
  const Scalar t965 = Scalar(0.0000999344262295082) * t907 - f_29_z;
  const Scalar t966 = c_28 * t965 - s_28 * t964;
  const Scalar t967 = c_29 * f_29_y + s_29 * t963;
  const Scalar mu_28_y = t967 - Scalar(0.0023) * (t883 - t885) + Scalar(0.2323364999999998) * t887 +
      Scalar(0.2401964999999998) * t888 - t955;
  const Scalar t968 = Scalar(0.2670564999999998) * domega_26_y;
  const Scalar t969 = Scalar(0.2690164999999998) * t865 + t968 - c_28 * t962 - s_28 * mu_28_y -
      Scalar(76.25) * t966;
  const Scalar t970 = t596 * t933 - tau_27 - t594 * t946 - t592 * t961 - t595 * t942 - t593 * t956 +
      t969;
  const Scalar t971 = c_28 * t964 + s_28 * t965;
  const Scalar t972 = Scalar(0.5360729999999996) * t878 - c_28 * mu_28_y + s_28 * t962 +
      Scalar(76.25) * t971;
  const Scalar mu_27_y = Scalar(0.2670564999999998) * t899 - Scalar(0.2690164999999998) * t900 +
      t960;
  const Scalar t973 = Scalar(-0.2650964999999998) * t842;
  const Scalar t974 = Scalar(0.2670564999999998) * t876 + t973 - s_27 * mu_27_y - c_27 * t972;
  const Scalar t975 = -tau_26 - t607 * t933 - t606 * t942 - t605 * t946 - t604 * t956 -
      t603 * t961 + t974 + t602 * t970;
  const Scalar t976 = t845 - t850;
  const Scalar t977 = t856 - t859;
  const Scalar t978 = c_19 * t977 - s_19 * t976;
  const Scalar t979 = c_19 * t838 + s_19 * omega_15_z;
  const Scalar omega_19_z = qd_19 + omega_r_15_y;
  const Scalar t980 = t979 * omega_19_z;
  const Scalar domega_19_y = c_19 * U_15_xy - s_19 * U_15_zy + t980;
  const Scalar omega_r_20_x = c_20 * omega_19_z + s_20 * t979;
  const Scalar t981 = c_20 * t979 - s_20 * omega_19_z;
  const Scalar t982 = omega_r_20_x * t981;
  const Scalar U_20_xy = t982 + domega_19_y;
  const Scalar t983 = t870 + t868;
  const Scalar t984 = Scalar(76.25) * U_20_xy - c_20 * t983 + s_20 * t978;
  const Scalar t985 = c_19 * t976 + s_19 * t977;
  const Scalar omega_r_20_a_z = c_19 * omega_15_z - s_19 * t838;
  const Scalar t986 = omega_r_20_a_z * omega_19_z;
  const Scalar t987 = s_19 * U_15_xy + c_19 * U_15_zy - Scalar(2.0) * t986;
  const Scalar t988 = t979 * omega_r_20_a_z;
  const Scalar t989 = t842 - t988;
  const Scalar omega_20_z = qd_20 + omega_r_20_a_z;
  const Scalar t990 = t981 * omega_20_z;
  const Scalar t991 = c_20 * t989 - s_20 * t987 + Scalar(2.0) * t990;
  const Scalar t992 = t985 - Scalar(76.25) * t991;
  const Scalar t993 = c_21 * t992 - s_21 * t984;
  const Scalar omega_r_21_x = c_21 * omega_20_z + s_21 * omega_r_20_x;
  const Scalar t994 = omega_r_21_x * omega_r_21_x;
  const Scalar t995 = omega_r_20_x * omega_r_20_x + omega_20_z * omega_20_z;
  const Scalar omega_21_z = qd_21 + t981;
  const Scalar t996 = omega_21_z * omega_21_z;
  const Scalar t997 = t995 - t994 + t996;
  const Scalar t998 = t997 - t993;
  const Scalar t999 = omega_r_21_x * omega_21_z;
  const Scalar t1000 = s_21 * U_20_xy + c_21 * t991 - t999;
  const Scalar ddp_o_21_y = Scalar(76.25) * t995 - c_20 * t978 - s_20 * t983;
  const Scalar ddp_o_22_z = t999 - t1000 + ddp_o_21_y;
  const Scalar t1001 = s_22 * ddp_o_22_z + c_22 * t998;
  const Scalar t1002 = c_22 * omega_r_21_x - s_22 * omega_21_z;
  const Scalar t1003 = t1002 * t1002;
  const Scalar t1004 = c_21 * omega_r_20_x - s_21 * omega_20_z;
  const Scalar omega_22_z = qd_22 + t1004;
  const Scalar t1005 = omega_22_z * omega_22_z;
  const Scalar t1006 = t994 + t996 - t1003 + t1005;
  const Scalar omega_r_23_a_z = c_22 * omega_21_z + s_22 * omega_r_21_x;
  const Scalar t1007 = t1002 * omega_r_23_a_z;
  const Scalar t1008 = t1007 + t1000;
  const Scalar ddp_o_23_x = t1006 - Scalar(59.75) * t1008 - t1001;
  const Scalar Uz_21_y = c_21 * U_20_xy - s_21 * t991;
  const Scalar t1009 = t1004 * omega_21_z;
  const Scalar t1010 = Uz_21_y - Scalar(2.0) * t1009;
  const Scalar t1011 = omega_r_20_x * omega_20_z;
  const Scalar t1012 = s_20 * t989 + t1011 + c_20 * t987;
  const Scalar t1013 = omega_r_21_x * t1004;
  const Scalar t1014 = t1013 + t1012;
  const Scalar t1015 = t1002 * omega_22_z;
  const Scalar t1016 = c_22 * t1014 - t1015 + s_22 * t1010;
  const Scalar t1017 = t1015 - t1016;
  const Scalar t1018 = omega_r_23_a_z * omega_22_z;
  const Scalar Uz_o_23_z = c_22 * t1010 - s_22 * t1014 + Scalar(2.0) * t1018;
  const Scalar t1019 = c_21 * t984 + s_21 * t992;
  const Scalar t1020 = t1012 - t1013;
  const Scalar t1021 = t1020 + t1019;
  const Scalar t1022 = t1017 + Scalar(59.75) * Uz_o_23_z + t1021;
  const Scalar t1023 = c_23 * t1022 + s_23 * ddp_o_23_x;
  const Scalar t1024 = c_22 * ddp_o_22_z - s_22 * t998;
  const Scalar Uz_o_23_y = t1003 + t1005;
  const Scalar t1025 = t1000 - t1007 + Scalar(59.75) * Uz_o_23_y + t1024;
  const Scalar t1026 = c_24 * t1023 - s_24 * t1025;
  const Scalar ddp_24_a_z = c_23 * ddp_o_23_x - s_23 * t1022;
  const Scalar t1027 = c_25 * ddp_24_a_z - s_25 * t1026;
  const Scalar omega_r_24_a_z = c_23 * t1002 + s_23 * omega_22_z;
  const Scalar omega_23_z = qd_23 + omega_r_23_a_z;
  const Scalar t1028 = omega_r_24_a_z * omega_23_z;
  const Scalar t1029 = c_23 * t1008 + s_23 * Uz_o_23_z - Scalar(2.0) * t1028;
  const Scalar omega_r_23_x = c_23 * omega_22_z - s_23 * t1002;
  const Scalar t1030 = omega_r_23_x * omega_r_24_a_z;
  const Scalar t1031 = t1016 - t1030;
  const Scalar t1032 = c_24 * omega_23_z - s_24 * omega_r_23_x;
  const Scalar omega_24_z = qd_24 + omega_r_24_a_z;
  const Scalar t1033 = t1032 * omega_24_z;
  const Scalar t1034 = c_24 * t1029 - s_24 * t1031 + Scalar(2.0) * t1033;
  const Scalar t1035 = omega_r_23_x * omega_23_z;
  const Scalar t1036 = -s_23 * t1008 - t1035 + c_23 * Uz_o_23_z;
  const Scalar omega_r_24_x = c_24 * omega_r_23_x + s_24 * omega_23_z;
  const Scalar t1037 = omega_r_24_x * t1032;
  const Scalar t1038 = t1037 + t1036;
  const Scalar t1039 = c_25 * t1034 + s_25 * t1038;
  const Scalar t1040 = omega_r_24_x * omega_24_z;
  const Scalar t1041 = t1040 + c_24 * t1031 + s_24 * t1029;
  const Scalar omega_r_25_x = c_25 * omega_24_z + s_25 * omega_r_24_x;
  const Scalar t1042 = c_25 * omega_r_24_x - s_25 * omega_24_z;
  const Scalar t1043 = omega_r_25_x * t1042;
  const Scalar t1044 = Scalar(-0.0005096) * t1043 - Scalar(0.0007482) * t1039 +
      Scalar(0.0014129000000002) * t1041 + Scalar(0.0000376) * t1027;
  const Scalar t1045 = t1044 + tau_25;
  const Scalar ddp_24_y = c_24 * t1025 + s_24 * t1023;
  const Scalar omega_25_z = qd_25 + t1032;
  const Scalar t1046 = omega_r_25_x * omega_r_25_x + omega_25_z * omega_25_z;
  const Scalar t1047 = omega_r_24_x * omega_r_24_x + omega_24_z * omega_24_z;
  const Scalar U_25_yy_zz = t1047 - t1046;
  const Scalar t1048 = t1042 * omega_25_z;
  const Scalar N_25_x = Scalar(0.0009033000000002) * t1048 + Scalar(0.0007482) * U_25_yy_zz +
      Scalar(0.0000376) * ddp_24_y;
  const Scalar t1049 = t1043 + t1041;
  const Scalar t1050 = Scalar(0.0005096) * t1039 - Scalar(0.0007482) * t1049 -
      Scalar(0.0019225000000002) * omega_r_25_x * omega_25_z;
  const Scalar t1051 = Scalar(-0.0253235000000002) * t1036;
  const Scalar t1052 = s_25 * t1050 - c_25 * N_25_x + Scalar(0.0250035000000002) * t1037 - t1051 +
      Scalar(0.0007608) * t1026;
  const Scalar t1053 = t1052 + t668 * t1045 + tau_24;
  const Scalar t1054 = t1044 + Scalar(0.0253235000000002) * t1040 -
      Scalar(0.0250035000000002) * t1041;
  const Scalar t1055 = -c_25 * t1050 - s_25 * N_25_x - Scalar(0.0503270000000004) * t1033 +
      Scalar(0.0007608) * ddp_24_a_z;
  const Scalar t1056 = Scalar(0.0259635000000002) * t1016 - Scalar(0.0253235000000002) * t1030 +
      c_24 * t1054 + s_24 * t1055;
  const Scalar t1057 = t1056 - t689 * t1053 - t693 * t1045 + tau_23;
  const Scalar t1058 = Scalar(0.0512870000000004) * t1028 - s_24 * t1054 + c_24 * t1055;
  const Scalar t1059 = Scalar(0.0000376) * (c_25 * t1046 - s_25 * t1049) +
      Scalar(0.0007608) * t1038;
  const Scalar t1060 = c_25 * t1038 - s_25 * t1034 - Scalar(2.0) * t1048;
  const Scalar f_24_y = Scalar(0.0007608) * t1047 - Scalar(0.0000376) * t1060;
  const Scalar t1061 = s_24 * f_24_y + c_24 * t1059 + Scalar(0.0001312) * t1023;
  const Scalar t1062 = s_25 * t1046 + c_25 * t1049;
  const Scalar t1063 = Scalar(0.0000376) * t1062 - Scalar(0.0007608) * t1034 +
      Scalar(0.0001312) * ddp_24_a_z;
  const Scalar f_u_23_t_x = c_23 * t1063 + s_23 * t1061;
  const Scalar t1064 = Scalar(0.0259635000000002) * t1035 - t1051 - t1052;
  const Scalar t1065 = c_24 * f_24_y - s_24 * t1059 + Scalar(0.0001312) * t1025;
  const Scalar t1066 = Scalar(-0.00278) * (t1006 - Uz_o_23_y) - t1065 + c_23 * t1058 -
      s_23 * t1064 + Scalar(0.2419864999999998) * t1007 + Scalar(0.2386464999999998) * t1000 +
      Scalar(0.00438) * t1001 + Scalar(59.75) * f_u_23_t_x;
  const Scalar t1067 = tau_22 + t702 * t1045 + t701 * t1053 + t698 * t1057 + t1066;
  const Scalar t1068 = c_23 * t1061 - s_23 * t1063;
  const Scalar t1069 = Scalar(0.00278) * t1017 + c_23 * t1064 + s_23 * t1058 +
      Scalar(0.4806329999999996) * t1018 + Scalar(0.00438) * t1021 - Scalar(59.75) * t1068;
  const Scalar t1070 = Scalar(0.00278) * Uz_o_23_z - t1068 + t1056 +
      Scalar(0.2386464999999998) * t1015 + Scalar(0.2419864999999998) * t1016;
  const Scalar f_22_z = Scalar(0.00438) * Uz_o_23_z + Scalar(0.000144) * t1021 - t1068;
  const Scalar t1071 = f_22_z - Scalar(0.0023) * Uz_21_y + Scalar(0.2401964999999998) * t1013 +
      Scalar(0.2323364999999998) * t1012 - c_22 * t1070 - s_22 * t1069;
  const Scalar t1072 = t709 * t1057 - t708 * t1067 - tau_21 - t711 * t1045 - t710 * t1053 + t1071;
  const Scalar t1073 = Scalar(0.0023) * t1020 + Scalar(0.4725329999999996) * t1009 + s_22 * t1070 -
      c_22 * t1069;
  const Scalar t1074 = Scalar(0.00438) * t1008 + Scalar(0.000144) * t1001 + f_u_23_t_x;
  const Scalar f_22_y = Scalar(0.00438) * Uz_o_23_y + Scalar(0.000144) * t1024 - t1065;
  const Scalar t1075 = Scalar(0.0000999344262295082) * t993 + c_22 * t1074 - s_22 * f_22_y;
  const Scalar t1076 = Scalar(0.0000999344262295082) * t1019 - f_22_z;
  const Scalar t1077 = c_21 * t1076 - s_21 * t1075;
  const Scalar t1078 = c_22 * f_22_y + s_22 * t1074;
  const Scalar mu_21_y = t1078 - Scalar(0.0023) * (t995 - t997) +
      Scalar(0.2323364999999998) * t999 + Scalar(0.2401964999999998) * t1000 - t1066;
  const Scalar t1079 = Scalar(0.2670564999999998) * domega_19_y;
  const Scalar t1080 = Scalar(0.2690164999999998) * t982 + t1079 - c_21 * t1073 - s_21 * mu_21_y -
      Scalar(76.25) * t1077;
  const Scalar t1081 = t720 * t1057 - tau_20 - t722 * t1045 + t718 * t1072 - t721 * t1053 -
      t719 * t1067 + t1080;
  const Scalar t1082 = c_21 * t1075 + s_21 * t1076;
  const Scalar t1083 = Scalar(0.5360729999999996) * t990 - c_21 * mu_21_y + s_21 * t1073 +
      Scalar(76.25) * t1082;
  const Scalar mu_20_y = Scalar(0.2670564999999998) * t1011 - Scalar(0.2690164999999998) * t1012 +
      t1071;
  const Scalar t1084 = Scalar(0.2670564999999998) * t988 + t973 - s_20 * mu_20_y - c_20 * t1083;
  const Scalar t1085 = t735 * t1045 - tau_19 - t734 * t1053 - t733 * t1057 - t732 * t1067 -
      t731 * t1072 + t1084 + t730 * t1081;
  const Scalar mu_26_x = Scalar(0.5321529999999997) * t874 - c_27 * mu_27_y + s_27 * t972;
  const Scalar mu_19_x = Scalar(0.5321529999999997) * t986 - c_20 * mu_20_y + s_20 * t1083;
  const Scalar f_28_z = Scalar(0.0000999344262295082) * ddp_o_28_y - t967;
  const Scalar t1086 = Scalar(0.00016042921013412816) * t861 - c_27 * f_28_z + s_27 * t966;
  const Scalar f_21_z = Scalar(0.0000999344262295082) * ddp_o_21_y - t1078;
  const Scalar t1087 = Scalar(0.000044065573770491804) * t978 - c_20 * f_21_z + s_20 * t1077;
  const Scalar t1088 = Scalar(0.00016042921013412816) * t873 + t971;
  const Scalar t1089 = Scalar(0.000044065573770491804) * t985 + t1082;
  const Scalar t1090 = c_26 * t1086 + s_26 * t1088 - c_19 * t1087 - s_19 * t1089;
  const Scalar t1091 = Scalar(0.2650964999999998) * t863 - t968 + t969;
  const Scalar t1092 = Scalar(0.2650964999999998) * t980 - t1079 + t1080;
  const Scalar t1093 = Scalar(0.000044065573770491804) * t983 +
      Scalar(0.00016042921013412816) * t871 - s_27 * f_28_z - s_20 * f_21_z - c_27 * t966 -
      c_20 * t1077;
  const Scalar omega_r_17_a_z = s_16 * omega_r_15_y + c_16 * omega_15_z;
  const Scalar omega_16_z = qd_16 + t838;
  const Scalar t1094 = omega_r_17_a_z * omega_16_z;
  const Scalar t1095 = s_16 * t866 + c_16 * t843 - Scalar(2.0) * t1094;
  const Scalar t1096 = c_16 * omega_r_15_y - s_16 * omega_15_z;
  const Scalar t1097 = t1096 * omega_r_17_a_z;
  const Scalar U_16_xy = domega_15_x - t1097;
  const Scalar omega_r_17_y = c_17 * t1096 + s_17 * omega_16_z;
  const Scalar omega_17_z = qd_17 + omega_r_17_a_z;
  const Scalar t1098 = omega_r_17_y * omega_17_z;
  const Scalar U_17_zy = c_17 * U_16_xy + s_17 * t1095 + Scalar(2.0) * t1098;
  const Scalar t1099 = t1096 * omega_16_z;
  const Scalar domega_16_y = c_16 * t866 - s_16 * t843 - t1099;
  const Scalar t1100 = c_17 * omega_16_z - s_17 * t1096;
  const Scalar t1101 = t1100 * omega_r_17_y;
  const Scalar U_17_xy = domega_16_y - t1101;
  const Scalar t1102 = c_18 * omega_17_z - s_18 * t1100;
  const Scalar omega_18_z = qd_18 + omega_r_17_y;
  const Scalar t1103 = t1102 * omega_18_z;
  const Scalar domega_18_y = s_18 * U_17_xy + c_18 * U_17_zy - t1103;
  const Scalar t1104 = t1103 - domega_18_y;
  const Scalar t1105 = Scalar(0.75) * Uz_o_15_y + Scalar(113.25) * t843 - t844;
  const Scalar ddp_o_16_y = Scalar(0.75) * t849 + Scalar(113.25) * t866 + t867;
  const Scalar t1106 = c_16 * ddp_o_16_y - s_16 * t1105;
  const Scalar t1107 = Scalar(0.75) * t841 - Scalar(113.25) * Uz_o_16_x + t855;
  const Scalar t1108 = c_17 * t1106 + s_17 * t1107;
  const Scalar t1109 = c_18 * t1100 + s_18 * omega_17_z;
  const Scalar t1110 = t1109 * omega_18_z;
  const Scalar t1111 = Scalar(0.0022) * t1104 + Scalar(0.00088) * t1108 + Scalar(0.05808) * t1110;
  const Scalar t1112 = c_18 * U_17_xy - s_18 * U_17_zy + Scalar(2.0) * t1110;
  const Scalar t1113 = Scalar(0.0022) * t1112 + Scalar(0.00008) * t1108 + Scalar(0.03408) * t1103 +
      Scalar(0.024) * domega_18_y;
  const Scalar mu_17_x = Scalar(0.06826) * t1098 - c_18 * t1113 - s_18 * t1111;
  const Scalar t1114 = c_17 * t1107 - s_17 * t1106;
  const Scalar t1115 = c_16 * t1105 + s_16 * ddp_o_16_y;
  const Scalar t1116 = c_18 * t1115 - s_18 * t1114;
  const Scalar t1117 = c_18 * t1114 + s_18 * t1115;
  const Scalar t1118 = t1102 * t1102;
  const Scalar t1119 = omega_18_z * omega_18_z;
  const Scalar t1120 = t1100 * t1100 - t1118 + omega_17_z * omega_17_z + t1119;
  const Scalar t1121 = t1118 + t1119;
  const Scalar t1122 = t1100 * omega_17_z;
  const Scalar t1123 = t1122 - s_17 * U_16_xy + c_17 * t1095;
  const Scalar t1124 = t1102 * t1109;
  const Scalar t1125 = Scalar(-0.0022) * (t1120 - t1121) - Scalar(0.00008) * t1117 +
      Scalar(0.024) * t1124 + Scalar(0.03408) * t1123 + Scalar(0.00088) * t1116;
  const Scalar mu_17_y = Scalar(0.03438) * t1122 - Scalar(0.03388) * t1123 + t1125;
  const Scalar t1126 = Scalar(0.069385) * t1094 - c_17 * mu_17_y - s_17 * mu_17_x;
  const Scalar t1127 = Scalar(0.00008) * t1104 + Scalar(0.00088) * t1112;
  const Scalar t1128 = Scalar(0.00008) * (t1123 - t1124) + Scalar(0.00088) * t1121;
  const Scalar t1129 = Scalar(0.00008) * t1120 - Scalar(0.00088) * (t1124 + t1123);
  const Scalar t1130 = c_18 * t1128 - s_18 * t1129;
  const Scalar t1131 = c_17 * t1127 + s_17 * t1130 + Scalar(0.00004711699779249448) * t1106;
  const Scalar t1132 = -c_18 * t1129 - s_18 * t1128 + Scalar(0.00004711699779249448) * t1115;
  const Scalar f_u_16_t_x = c_16 * t1131 + s_16 * t1132;
  const Scalar t1133 = Scalar(0.03438) * domega_16_y;
  const Scalar t1134 = Scalar(0.03388) * t1101 + s_18 * t1113 - t1133 - c_18 * t1111;
  const Scalar t1135 = Scalar(0.035005) * t1099 + t1133 + t1134;
  const Scalar mu_15_z = Scalar(0.048) * t849 + c_16 * t1135 + s_16 * t1126 +
      Scalar(0.9829845909094235) * t858 - Scalar(0.7225529242417575) * t857 -
      Scalar(17.12290909090909) * t854 + Scalar(0.576) * (Uz_o_16_x - t869) -
      Scalar(113.25) * f_u_16_t_x + c_26 * t1091 - s_26 * mu_26_x + c_19 * t1092 - s_19 * mu_19_x -
      Scalar(60.0) * t1090 - Scalar(82.5) * t1093;
  const Scalar t1136 = t543 * t933 - t666 * t1045;
  const Scalar mu_u_16_x = Scalar(0.035005) * domega_15_x - Scalar(0.03438) * t1097 +
      c_17 * mu_17_x - s_17 * mu_17_y;
  const Scalar t1137 = t1134 - tau_17;
  const Scalar t1138 = t1125 - tau_18;
  const Scalar y_17_16 = mu_u_16_x + t762 * t1137 + s_17 * t1138 + tau_16;
  const Scalar t1139 = -tau_15 - t774 * t1137 - Scalar(707.7641729774637) * t1136 + t752 * t942 +
      t750 * t946 - t746 * t961 + t753 * t1053 - t751 * t1057 - t747 * t1072 + t775 * t1138 -
      t773 * y_17_16 - t748 * t956 - t616 * t975 - t749 * t1067 - t743 * t1085 - t744 * t970 -
      t745 * t1081 + mu_15_z;
  const Scalar t1140 = c_26 * t1088 - s_26 * t1086;
  const Scalar t1141 = c_19 * t1089 - s_19 * t1087;
  const Scalar t1142 = c_16 * t1132 - s_16 * t1131;
  const Scalar t1143 = s_17 * t1127 - c_17 * t1130 + Scalar(0.00004711699779249448) * t1107;
  const Scalar t1144 = Scalar(0.048) * (Uz_o_15_y - Uz_o_16_x) - Scalar(0.75) * t1143 +
      c_16 * t1126 - s_16 * t1135 + Scalar(0.9829845909094235) * t840 -
      Scalar(0.7225529242417575) * t842 + Scalar(0.576) * U_15_zy - Scalar(113.25) * t1142 - t974 -
      t1084 - Scalar(82.5) * (t1140 + t1141);
  const Scalar t1145 = Scalar(0.048) * t866 - Scalar(0.75) * f_u_16_t_x - mu_u_16_x +
      Scalar(0.006981818181818182) * t845 + Scalar(1.7055375151511811) * t848 - c_26 * mu_26_x -
      s_26 * t1091 - c_19 * mu_19_x - s_19 * t1092 - Scalar(60.0) * (t1140 - t1141);
  const Scalar t1146 = t777 * t933 - mu_u_25_15_t_y * t1045;
  const Scalar t1147 = c_14 * (Scalar(2.424827454030129) + qd_13 * t839);
  const Scalar y_15_14 = Scalar(0.8084599275533488) * t1147 + tau_14 - t812 * t1138 + t811 * t1137 +
      Scalar(707.7641729774637) * t1146 + t807 * t942 + t805 * t946 + t801 * t961 + t808 * t1053 +
      t806 * t1057 + t802 * t1072 - t810 * y_17_16 + t803 * t956 + t804 * t1067 + c_15 * t1144 +
      s_15 * t1145 - t799 * t970 + t797 * t975 - t800 * t1081 + t798 * t1085 - t796 * t1139;
  const Scalar t1148 = c_14 * (Scalar(1.6144698551066976) * qd_14 * t839 + c_15 * t1145 -
      s_15 * t1144);
  const Scalar mu_14_y = Scalar(0.00245) * t858 - mu_15_z;
  const Scalar t1149 = mu_u_32_14_t_y * t933 + t667 * t1045;
  const Scalar t1150 = tau_13 + t833 * t1137 + Scalar(707.7641729774637) * t1149 + t829 * t942 +
      t827 * t946 + t823 * t961 - t830 * t1053 - t828 * t1057 - t824 * t1072 + t834 * t1138 -
      t832 * y_17_16 + t825 * t956 - t819 * t975 - t826 * t1067 + t820 * t1085 - t1148 -
      s_14 * mu_14_y - t821 * t970 + t822 * t1081 + t818 * t1139 - t817 * y_15_14;
  const Scalar t1151 = (Scalar(1.0) / t835) * t1150;
  qdd[12] = -t1151;
  const Scalar t1152 = t816 * (y_15_14 - t813 * t1151);
  qdd[13] = -t1152;
  const Scalar t1153 = t795 * (t793 * t1152 + t1139 - t776 * t1151);
  qdd[14] = -t1153;
  const Scalar qdd_16 = t771 * (t769 * t1151 + t792 * t1152 - t772 * t1153 + y_17_16);
  qdd[15] = qdd_16;
  const Scalar qdd_19 = t742 * (t788 * t1152 + t736 * t1151 + t740 * t1153 + t1085);
  qdd[18] = qdd_19;
  const Scalar qdd_26 = t615 * (t783 * t1152 - t608 * t1151 + t613 * t1153 + t975);
  qdd[25] = qdd_26;
  const Scalar t1154 = t759 * t1151 - c_17 * Iu_18_a_yz * qdd_16 + t758 * t1153 + t790 * t1152 +
      t1137;
  qdd[16] = t760 * t1154;
  const Scalar t1155 = t791 * t1152 - mu_u_18_14_a_z * t1151 + mu_u_18_15_a_y * t1153 + t1138;
  qdd[17] = -s_17 * qdd_16 - Scalar(29.342723004694836) * t1155;
  const Scalar t1156 = t723 * t1151 + t727 * qdd_19 + t739 * t1153 - t787 * t1152 + t1081;
  const Scalar qdd_20 = t729 * t1156;
  qdd[19] = qdd_20;
  const Scalar t1157 = b_28_27_26 * qdd_26 - t597 * t1151 + t612 * t1153 - t782 * t1152 + t970;
  const Scalar qdd_27 = t601 * t1157;
  qdd[26] = qdd_27;
  const Scalar t1158 = t712 * t1151 - b_22_21_15 * t1153 - t786 * t1152 + t1072 + t726 * qdd_19 -
      t715 * qdd_20;
  const Scalar t1159 = t717 * t1158;
  qdd[20] = -t1159;
  const Scalar t1160 = -t611 * t1153 - t781 * t1152 - t588 * t1151 + t961 + t599 * qdd_26 +
      t591 * qdd_27;
  const Scalar t1161 = d_28 * t1160;
  qdd[27] = -t1161;
  const Scalar t1162 = t705 * t1159 + t785 * t1152 - t703 * t1151 + b_23_22_15 * t1153 -
      t725 * qdd_19 + t1067 - t714 * qdd_20;
  const Scalar t1163 = t707 * t1162;
  qdd[21] = -t1163;
  const Scalar t1164 = t579 * t1161 + t780 * t1152 + t577 * t1151 + b_30_29_15 * t1153 -
      b_30_29_26 * qdd_26 + t956 - t590 * qdd_27;
  const Scalar t1165 = t581 * t1164;
  qdd[28] = -t1165;
  const Scalar t1166 = t784 * t1152 - t694 * t1151 - b_24_23_19 * qdd_19 + t738 * t1153 -
      t704 * t1159 + t713 * qdd_20 + t695 * t1163 + t1057;
  const Scalar t1167 = t697 * t1166;
  qdd[22] = -t1167;
  const Scalar t1168 = t570 * t1151 + t779 * t1152 - b_31_30_26 * qdd_26 - t610 * t1153 +
      t578 * t1161 - t589 * qdd_27 + b_31_30_29 * t1165 + t946;
  const Scalar t1169 = t572 * t1168;
  qdd[29] = -t1169;
  const Scalar t1170 = b_25_24_14 * t1152 - t688 * t1167 - t685 * t1151 - t737 * t1153 -
      t724 * qdd_19 + b_25_24_21 * t1159 - b_25_24_20 * qdd_20 + b_25_24_22 * t1163 + t1053;
  const Scalar t1171 = t687 * t1170;
  qdd[23] = -t1171;
  const Scalar t1172 = t564 * t1169 + b_32_31_13 * t1151 - t609 * t1153 + t778 * t1152 -
      t598 * qdd_26 + b_32_31_28 * t1161 - b_32_31_27 * qdd_27 + b_32_31_29 * t1165 + t942;
  const Scalar t1173 = t563 * t1172;
  qdd[30] = -t1173;
  const Scalar t1174 = t666 * t1153 - t667 * t1151 + mu_u_25_15_t_y * t1152 -
      mu_u_25_20_t_y * qdd_19 - t664 * t1159 + mu_u_25_20_a_y * qdd_20 - t658 * t1163 +
      mu_u_25_24_t_y * t1167 + t1045;
  qdd[24] = Scalar(707.7641729774637) * t1174 - t668 * t1171;
  const Scalar t1175 = t539 * qdd_26 - mu_u_32_14_t_y * t1151 - t543 * t1153 - t777 * t1152 +
      mu_32_28_z * t1161 - mu_32_27_z * qdd_27 + mu_32_29_z * t1165 + mu_u_32_31_t_y * t1169 + t933;
  qdd[31] = t544 * t1173 + Scalar(707.7641729774637) * t1175;
  bool positive = -t163 > Scalar(0.0);
  positive &= b_3_2_2 > Scalar(0.0);
  positive &= -t133 > Scalar(0.0);
  positive &= -t101 > Scalar(0.0);
  positive &= Ic_5_zz > Scalar(0.0);
  positive &= -t327 > Scalar(0.0);
  positive &= b_9_8_8 > Scalar(0.0);
  positive &= -t297 > Scalar(0.0);
  positive &= -t265 > Scalar(0.0);
  positive &= Ic_11_zz > Scalar(0.0);
  positive &= -t835 > Scalar(0.0);
  positive &= -t815 > Scalar(0.0);
  positive &= b_16_15_15 > Scalar(0.0);
  positive &= b_17_16_16 > Scalar(0.0);
  positive &= -mu_u_17_17_a_y > Scalar(0.0);
  positive &= -t741 > Scalar(0.0);
  positive &= -t728 > Scalar(0.0);
  positive &= t716 > Scalar(0.0);
  positive &= -t706 > Scalar(0.0);
  positive &= -t696 > Scalar(0.0);
  positive &= -t686 > Scalar(0.0);
  positive &= -t614 > Scalar(0.0);
  positive &= -t600 > Scalar(0.0);
  positive &= b_29_28_28 > Scalar(0.0);
  positive &= -t580 > Scalar(0.0);
  positive &= -t571 > Scalar(0.0);
  positive &= -t562 > Scalar(0.0);
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

}  // namespace humanoid32

#endif  // FLATDYN_HUMANOID32_HPP

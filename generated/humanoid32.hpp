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

#ifndef FLATDYN_HUMANOID32_HPP_34C4636E
#define FLATDYN_HUMANOID32_HPP_34C4636E

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
//   q[32]    in   joint positions, rad or m
//   qd[32]   in   joint velocities, rad/s or m/s
//   qdd[32]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[32]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11], q[13..31], qd[0..31], qdd[0..31]. Operations: 1013 mul, 858 add, 62 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
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
  const Scalar t37 = t36 - t35;
  const Scalar Uz_o_16_x = Uz_o_15_y + t37;
  const Scalar t38 = c_14 * c_15;
  const Scalar t39 = Scalar(2452.5) * t38;
  const Scalar t40 = Scalar(0.75) * t5 + Scalar(113.25) * Uz_o_16_x - t39;
  const Scalar t41 = s_17 * t40 + c_17 * t34;
  const Scalar t42 = Scalar(0.00088) * c_18 - Scalar(0.00008) * s_18;
  const Scalar U_17_yx = domega_17_z - t25;
  const Scalar mu_17_z = Scalar(0.00025) * U_17_yx + Scalar(0.00509) * t26 + t20 * t21 - t27 * t29 +
      t42 * t41;
  tau[16] = mu_17_z;
  const Scalar t43 = c_8 * qd_7;
  const Scalar omega_r_9_x = s_9 * t43 + c_9 * qd_8;
  const Scalar t44 = omega_r_9_x * omega_r_9_x;
  const Scalar t45 = s_8 * qd_7;
  const Scalar omega_9_z = qd_9 - t45;
  const Scalar t46 = omega_9_z * omega_9_z;
  const Scalar t47 = t46 - t44;
  const Scalar t48 = t43 * t43 + qd_8 * qd_8;
  const Scalar t49 = t43 * t45;
  const Scalar t50 = t49 + qdd_8;
  const Scalar t51 = Scalar(2452.5) * c_7;
  const Scalar ddp_o_9_x = Scalar(97.25) * t50 + s_8 * t51;
  const Scalar t52 = Scalar(2.0) * qd_8 * t45 - c_8 * qdd_7;
  const Scalar ddp_9_a_y = Scalar(2452.5) * s_7 - Scalar(97.25) * t52;
  const Scalar t53 = s_9 * ddp_o_9_x - c_9 * ddp_9_a_y;
  const Scalar ddp_o_10_x = Scalar(5.0) * (t48 + t47) + t53;
  const Scalar t54 = omega_r_9_x * omega_9_z;
  const Scalar t55 = s_9 * t50 + t54 + c_9 * t52;
  const Scalar U_9_zx = t54 + t55;
  const Scalar t56 = Scalar(97.25) * t48 - Scalar(5.0) * U_9_zx + c_8 * t51;
  const Scalar t57 = s_10 * ddp_o_10_x + c_10 * t56;
  const Scalar t58 = s_10 * omega_r_9_x + c_10 * omega_9_z;
  const Scalar t59 = t58 * t58;
  const Scalar t60 = s_9 * qd_8 - c_9 * t43;
  const Scalar omega_10_z = qd_10 - t60;
  const Scalar t61 = omega_10_z * omega_10_z;
  const Scalar domega_10_z = qdd_10 - t55;
  const Scalar t62 = s_10 * omega_9_z - c_10 * omega_r_9_x;
  const Scalar t63 = t58 * t62;
  const Scalar Uz_o_11_x = t63 + domega_10_z;
  const Scalar t64 = t57 - Scalar(10.0) * Uz_o_11_x + Scalar(89.25) * (t44 + t46 + t61 - t59);
  const Scalar t65 = s_9 * t52 - c_9 * t50;
  const Scalar t66 = t65 + Scalar(2.0) * t60 * omega_9_z;
  const Scalar t67 = t58 * omega_10_z;
  const Scalar t68 = qd_8 * t43;
  const Scalar t69 = t68 + s_8 * qdd_7;
  const Scalar domega_9_z = qdd_9 - t69;
  const Scalar t70 = omega_r_9_x * t60;
  const Scalar t71 = t70 + domega_9_z;
  const Scalar t72 = t67 + s_10 * t71 + c_10 * t66;
  const Scalar t73 = t67 + t72;
  const Scalar t74 = s_10 * t66 - c_10 * t71 + Scalar(2.0) * t62 * omega_10_z;
  const Scalar ddp_9_y = s_9 * ddp_9_a_y + c_9 * ddp_o_9_x;
  const Scalar U_9_yx = domega_9_z - t70;
  const Scalar t75 = Scalar(5.0) * U_9_yx - ddp_9_y;
  const Scalar t76 = Scalar(10.0) * t74 + t75 + Scalar(89.25) * t73;
  const Scalar t77 = s_11 * t64 - c_11 * t76;
  const Scalar mr_12_x = Scalar(0.00018) * s_12 + Scalar(0.00042) * c_12;
  const Scalar omega_r_11_y = s_11 * t58 + c_11 * omega_10_z;
  const Scalar omega_11_z = qd_11 - t62;
  const Scalar t78 = Scalar(2.0) * omega_11_z;
  const Scalar t79 = s_11 * Uz_o_11_x + omega_r_11_y * t78 + c_11 * t74;
  const Scalar omega_12_z = qd_12 + omega_r_11_y;
  const Scalar t80 = t79 - t78 * omega_12_z;
  const Scalar t81 = Scalar(0.0063) * c_12 - Scalar(0.0012) * s_12;
  const Scalar I_12_xy = c_12 * t81 - Scalar(0.00315);
  const Scalar domega_11_z = qdd_11 - t72;
  const Scalar t82 = s_11 * omega_10_z - c_11 * t58;
  const Scalar t83 = t82 * omega_r_11_y;
  const Scalar t84 = domega_11_z - t83;
  const Scalar t85 = t84 + Scalar(2.0) * t82 * omega_12_z;
  const Scalar t86 = s_12 * t81;
  const Scalar I_12_yy = t86 + Scalar(0.007758333333335);
  const Scalar U_11_yx = t83 + domega_11_z;
  const Scalar mu_11_z = Scalar(0.00032) * U_11_yx + Scalar(0.001328333333335) * t84 -
      t80 * I_12_xy + t85 * I_12_yy + mr_12_x * t77;
  tau[10] = mu_11_z;
  const Scalar t87 = c_2 * qd_1;
  const Scalar omega_r_3_x = s_3 * t87 + c_3 * qd_2;
  const Scalar t88 = omega_r_3_x * omega_r_3_x;
  const Scalar t89 = s_2 * qd_1;
  const Scalar omega_3_z = qd_3 - t89;
  const Scalar t90 = omega_3_z * omega_3_z;
  const Scalar t91 = t90 - t88;
  const Scalar t92 = t87 * t87 + qd_2 * qd_2;
  const Scalar t93 = t87 * t89;
  const Scalar t94 = t93 + qdd_2;
  const Scalar t95 = Scalar(2452.5) * c_1;
  const Scalar ddp_o_3_x = Scalar(97.25) * t94 + s_2 * t95;
  const Scalar t96 = Scalar(2.0) * qd_2 * t89 - c_2 * qdd_1;
  const Scalar ddp_3_a_y = Scalar(2452.5) * s_1 - Scalar(97.25) * t96;
  const Scalar t97 = s_3 * ddp_o_3_x - c_3 * ddp_3_a_y;
  const Scalar ddp_o_4_x = Scalar(5.0) * (t92 + t91) + t97;
  const Scalar t98 = omega_r_3_x * omega_3_z;
  const Scalar t99 = s_3 * t94 + t98 + c_3 * t96;
  const Scalar U_3_zx = t98 + t99;
  const Scalar t100 = Scalar(97.25) * t92 - Scalar(5.0) * U_3_zx + c_2 * t95;
  const Scalar t101 = s_4 * ddp_o_4_x + c_4 * t100;
  const Scalar t102 = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar t103 = t102 * t102;
  const Scalar t104 = s_3 * qd_2 - c_3 * t87;
  const Scalar omega_4_z = qd_4 - t104;
  const Scalar t105 = omega_4_z * omega_4_z;
  const Scalar domega_4_z = qdd_4 - t99;
  const Scalar t106 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar t107 = t102 * t106;
  const Scalar Uz_o_5_x = t107 + domega_4_z;
  const Scalar t108 = t101 - Scalar(10.0) * Uz_o_5_x + Scalar(89.25) * (t88 + t90 + t105 - t103);
  const Scalar t109 = s_3 * t96 - c_3 * t94;
  const Scalar t110 = t109 + Scalar(2.0) * t104 * omega_3_z;
  const Scalar t111 = t102 * omega_4_z;
  const Scalar t112 = qd_2 * t87;
  const Scalar t113 = t112 + s_2 * qdd_1;
  const Scalar domega_3_z = qdd_3 - t113;
  const Scalar t114 = omega_r_3_x * t104;
  const Scalar t115 = t114 + domega_3_z;
  const Scalar t116 = t111 + s_4 * t115 + c_4 * t110;
  const Scalar t117 = t111 + t116;
  const Scalar t118 = s_4 * t110 - c_4 * t115 + Scalar(2.0) * t106 * omega_4_z;
  const Scalar ddp_3_y = s_3 * ddp_3_a_y + c_3 * ddp_o_3_x;
  const Scalar U_3_yx = domega_3_z - t114;
  const Scalar t119 = Scalar(5.0) * U_3_yx - ddp_3_y;
  const Scalar t120 = Scalar(10.0) * t118 + t119 + Scalar(89.25) * t117;
  const Scalar t121 = s_5 * t108 - c_5 * t120;
  const Scalar mr_6_x = Scalar(0.00018) * s_6 + Scalar(0.00042) * c_6;
  const Scalar omega_r_5_y = s_5 * t102 + c_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 - t106;
  const Scalar t122 = Scalar(2.0) * omega_5_z;
  const Scalar t123 = s_5 * Uz_o_5_x + omega_r_5_y * t122 + c_5 * t118;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t124 = t123 - t122 * omega_6_z;
  const Scalar t125 = Scalar(0.0063) * c_6 - Scalar(0.0012) * s_6;
  const Scalar I_6_xy = c_6 * t125 - Scalar(0.00315);
  const Scalar domega_5_z = qdd_5 - t116;
  const Scalar t126 = s_5 * omega_4_z - c_5 * t102;
  const Scalar t127 = t126 * omega_r_5_y;
  const Scalar t128 = domega_5_z - t127;
  const Scalar t129 = t128 + Scalar(2.0) * t126 * omega_6_z;
  const Scalar t130 = s_6 * t125;
  const Scalar I_6_yy = t130 + Scalar(0.007758333333335);
  const Scalar U_5_yx = t127 + domega_5_z;
  const Scalar mu_5_z = Scalar(0.00032) * U_5_yx + Scalar(0.001328333333335) * t128 -
      t124 * I_6_xy + t129 * I_6_yy + mr_6_x * t121;
  tau[4] = mu_5_z;
  const Scalar t131 = t126 * omega_5_z;
  const Scalar t132 = t131 - c_5 * Uz_o_5_x + s_5 * t118;
  const Scalar domega_6_z = qdd_6 - t132;
  const Scalar t133 = t131 - domega_6_z;
  const Scalar t134 = t131 + domega_6_z;
  const Scalar t135 = t130 - Scalar(0.006558333333335);
  const Scalar t136 = c_5 * t108 + s_5 * t120;
  const Scalar t137 = Scalar(0.00018) * c_6 - Scalar(0.00042) * s_6;
  const Scalar t138 = omega_6_z * omega_6_z;
  const Scalar t139 = t138 + omega_5_z * omega_5_z;
  const Scalar t140 = t126 * t126 + t138;
  const Scalar t141 = s_4 * t100 - c_4 * ddp_o_4_x;
  const Scalar U_4_yx = domega_4_z - t107;
  const Scalar Uz_o_5_y = t105 + t103;
  const Scalar ddp_o_5_y = Scalar(10.0) * Uz_o_5_y + Scalar(89.25) * U_4_yx + t141;
  const Scalar t142 = I_6_xy * (t139 - t140) + t133 * I_6_yy + t134 * t135 + t137 * t136 -
      mr_6_x * ddp_o_5_y;
  tau[5] = -t142;
  const Scalar t143 = t82 * omega_11_z;
  const Scalar t144 = t143 - c_11 * Uz_o_11_x + s_11 * t74;
  const Scalar domega_12_z = qdd_12 - t144;
  const Scalar t145 = t143 - domega_12_z;
  const Scalar t146 = t143 + domega_12_z;
  const Scalar t147 = t86 - Scalar(0.006558333333335);
  const Scalar t148 = c_11 * t64 + s_11 * t76;
  const Scalar t149 = Scalar(0.00018) * c_12 - Scalar(0.00042) * s_12;
  const Scalar t150 = omega_12_z * omega_12_z;
  const Scalar t151 = t150 + omega_11_z * omega_11_z;
  const Scalar t152 = t82 * t82 + t150;
  const Scalar t153 = s_10 * t56 - c_10 * ddp_o_10_x;
  const Scalar U_10_yx = domega_10_z - t63;
  const Scalar Uz_o_11_y = t61 + t59;
  const Scalar ddp_o_11_y = Scalar(10.0) * Uz_o_11_y + Scalar(89.25) * U_10_yx + t153;
  const Scalar t154 = I_12_xy * (t151 - t152) + t145 * I_12_yy + t146 * t147 + t149 * t148 -
      mr_12_x * ddp_o_11_y;
  tau[11] = -t154;
  const Scalar t155 = t24 * omega_17_z;
  const Scalar t156 = t155 + s_17 * Uz_o_17_x - c_17 * t12;
  const Scalar domega_18_z = qdd_18 + t156;
  const Scalar U_18_yx = t155 + domega_18_z;
  const Scalar U_18_xy = t155 - domega_18_z;
  const Scalar I_18_xx = Scalar(0.00504) + t28;
  const Scalar t157 = Scalar(0.00008) * c_18 + Scalar(0.00088) * s_18;
  const Scalar t158 = t157 * (s_17 * t34 - c_17 * t40);
  const Scalar t159 = omega_18_z * omega_18_z;
  const Scalar t160 = t159 + omega_17_z * omega_17_z;
  const Scalar t161 = t24 * t24 + t159;
  const Scalar t162 = s_16 * t33 + c_16 * t31;
  const Scalar tau_18 = t21 * (t160 - t161) - U_18_xy * I_18_xx - U_18_yx * t29 - t158 + t42 * t162;
  tau[17] = tau_18;
  const Scalar t163 = mr_12_x * t151 - t149 * t146 + Scalar(0.0000615126050420168) * t148;
  const Scalar t164 = mr_12_x * t85 - t149 * t80 + Scalar(0.0000615126050420168) * t77;
  const Scalar t165 = s_11 * t164 + c_11 * t163;
  const Scalar t166 = Scalar(0.00032) * (t143 + t144) + t154;
  const Scalar t167 = Scalar(0.001328333333335) * t79 - t85 * I_12_xy - t80 * t147 - t149 * t77;
  const Scalar f_u_11_a_y = t149 * t152 - mr_12_x * t145 +
      Scalar(0.0000615126050420168) * ddp_o_11_y;
  const Scalar mu_10_z = Scalar(0.008593739495798319) * Uz_o_11_x -
      Scalar(0.0002648739495798319) * t57 + s_11 * t167 - c_11 * t166 - Scalar(0.06566) * U_10_yx -
      Scalar(10.0) * t165 + Scalar(89.25) * f_u_11_a_y;
  tau[9] = mu_10_z;
  const Scalar t168 = mr_6_x * t139 - t137 * t134 + Scalar(0.0000615126050420168) * t136;
  const Scalar t169 = mr_6_x * t129 - t137 * t124 + Scalar(0.0000615126050420168) * t121;
  const Scalar t170 = s_5 * t169 + c_5 * t168;
  const Scalar t171 = Scalar(0.00032) * (t131 + t132) + t142;
  const Scalar t172 = Scalar(0.001328333333335) * t123 - t129 * I_6_xy - t124 * t135 - t137 * t121;
  const Scalar f_u_5_a_y = t137 * t140 - mr_6_x * t133 + Scalar(0.0000615126050420168) * ddp_o_5_y;
  const Scalar mu_4_z = Scalar(0.008593739495798319) * Uz_o_5_x -
      Scalar(0.0002648739495798319) * t101 + s_5 * t172 - c_5 * t171 - Scalar(0.06566) * U_4_yx -
      Scalar(10.0) * t170 + Scalar(89.25) * f_u_5_a_y;
  tau[3] = mu_4_z;
  const Scalar mu_17_y = Scalar(0.00025) * (t155 + t156) + tau_18;
  const Scalar t173 = Scalar(0.00509) * t19 + t20 * I_18_xx + t27 * t21 + t157 * t41;
  const Scalar U_16_yx = t17 + domega_16_z;
  const Scalar mu_16_z = Scalar(0.0003125) * U_16_yx + Scalar(0.0005625) * Uz_o_17_x +
      s_17 * mu_17_y - c_17 * t173;
  tau[15] = mu_16_z;
  const Scalar t174 = s_11 * t163 - c_11 * t164;
  const Scalar t175 = Scalar(0.06566) * t73 + mu_11_z - Scalar(89.25) * t174;
  const Scalar t176 = Scalar(0.008593739495798319) * t74 + Scalar(0.0002648739495798319) * t75 +
      s_11 * t166 + c_11 * t167 + Scalar(10.0) * t174;
  const Scalar t177 = Scalar(2.4873949579831934e-06) * t75 + Scalar(0.0002648739495798319) * t74 +
      t174;
  const Scalar tau_9 = Scalar(0.00507) * t65 + Scalar(0.00605) * t71 + Scalar(0.006525) * U_9_yx +
      Scalar(5.0) * t177 - c_10 * t176 - s_10 * t175;
  tau[8] = tau_9;
  const Scalar t178 = s_5 * t168 - c_5 * t169;
  const Scalar t179 = Scalar(0.06566) * t117 + mu_5_z - Scalar(89.25) * t178;
  const Scalar t180 = Scalar(0.008593739495798319) * t118 + Scalar(0.0002648739495798319) * t119 +
      s_5 * t171 + c_5 * t172 + Scalar(10.0) * t178;
  const Scalar t181 = Scalar(2.4873949579831934e-06) * t119 + Scalar(0.0002648739495798319) * t118 +
      t178;
  const Scalar tau_3 = Scalar(0.00507) * t109 + Scalar(0.00605) * t115 + Scalar(0.006525) * U_3_yx +
      Scalar(5.0) * t181 - c_4 * t180 - s_4 * t179;
  tau[2] = tau_3;
  const Scalar f_10_x = Scalar(0.0002648739495798319) * Uz_o_11_x -
      Scalar(2.4873949579831934e-06) * t57 - t165;
  const Scalar f_10_y = Scalar(0.0002648739495798319) * Uz_o_11_y +
      Scalar(2.4873949579831934e-06) * t153 + f_u_11_a_y;
  const Scalar t182 = Scalar(0.000051146529562982) * t53 - s_10 * f_10_x - c_10 * f_10_y;
  const Scalar f_9_y = Scalar(0.000051146529562982) * ddp_9_y - t177;
  const Scalar f_u_9_t_x = s_9 * t182 + c_9 * f_9_y;
  const Scalar t183 = s_10 * f_10_y - c_10 * f_10_x;
  const Scalar t184 = Scalar(0.00507) * t47 + Scalar(0.006525) * U_9_zx - Scalar(5.0) * t183 -
      mu_10_z;
  const Scalar t185 = Scalar(0.00507) * U_9_yx + Scalar(0.00605) * t66 + s_10 * t176 - c_10 * t175;
  const Scalar U_8_yx = qdd_8 - t49;
  const Scalar t186 = Scalar(0.08166) * t50 - Scalar(0.00098) * U_8_yx + c_9 * t185 - s_9 * t184 -
      Scalar(97.25) * f_u_9_t_x;
  tau[7] = -t186;
  const Scalar f_4_x = Scalar(0.0002648739495798319) * Uz_o_5_x -
      Scalar(2.4873949579831934e-06) * t101 - t170;
  const Scalar f_4_y = Scalar(0.0002648739495798319) * Uz_o_5_y +
      Scalar(2.4873949579831934e-06) * t141 + f_u_5_a_y;
  const Scalar t187 = Scalar(0.000051146529562982) * t97 - s_4 * f_4_x - c_4 * f_4_y;
  const Scalar f_3_y = Scalar(0.000051146529562982) * ddp_3_y - t181;
  const Scalar f_u_3_t_x = s_3 * t187 + c_3 * f_3_y;
  const Scalar t188 = s_4 * f_4_y - c_4 * f_4_x;
  const Scalar t189 = Scalar(0.00507) * t91 + Scalar(0.006525) * U_3_zx - Scalar(5.0) * t188 -
      mu_4_z;
  const Scalar t190 = Scalar(0.00507) * U_3_yx + Scalar(0.00605) * t110 + s_4 * t180 - c_4 * t179;
  const Scalar U_2_yx = qdd_2 - t93;
  const Scalar t191 = Scalar(0.08166) * t94 - Scalar(0.00098) * U_2_yx + c_3 * t190 - s_3 * t189 -
      Scalar(97.25) * f_u_3_t_x;
  tau[1] = -t191;
  const Scalar f_u_9_t_y = s_9 * f_9_y - c_9 * t182;
  const Scalar t192 = Scalar(0.08166) * t52 - s_9 * t185 - c_9 * t184 + Scalar(97.25) * f_u_9_t_y;
  const Scalar U_8_zx = t68 + t69;
  tau[6] = Scalar(0.00294) * qdd_7 + s_8 * (Scalar(0.00098) * U_8_zx - tau_9) + c_8 * t192;
  const Scalar f_u_3_t_y = s_3 * f_3_y - c_3 * t187;
  const Scalar t193 = Scalar(0.08166) * t96 - s_3 * t190 - c_3 * t189 + Scalar(97.25) * f_u_3_t_y;
  const Scalar U_2_zx = t112 + t113;
  tau[0] = Scalar(0.00294) * qdd_1 + s_2 * (Scalar(0.00098) * U_2_zx - tau_3) + c_2 * t193;
  const Scalar t194 = Scalar(82.5) * t9 + t30;
  const Scalar U_15_zy = t14 + t15;
  const Scalar t195 = Scalar(60.0) * U_15_zy;
  const Scalar t196 = t194 - t195;
  const Scalar t197 = Scalar(82.5) * Uz_o_16_x - t39;
  const Scalar t198 = domega_15_z - t11;
  const Scalar t199 = Scalar(60.0) * t198;
  const Scalar t200 = t197 - t199;
  const Scalar t201 = s_26 * t196 + c_26 * t200;
  const Scalar t202 = s_26 * omega_15_z - c_26 * t6;
  const Scalar omega_26_z = qd_26 + omega_r_15_y;
  const Scalar t203 = t202 * omega_26_z;
  const Scalar t204 = t203 - s_26 * U_15_zy - c_26 * t198;
  const Scalar domega_27_z = qdd_27 - t204;
  const Scalar omega_r_27_x = s_27 * t202 + c_27 * omega_26_z;
  const Scalar t205 = s_27 * omega_26_z - c_27 * t202;
  const Scalar t206 = omega_r_27_x * t205;
  const Scalar t207 = t206 + domega_27_z;
  const Scalar t208 = Scalar(82.5) * U_15_yx - t32;
  const Scalar t209 = t35 + t36;
  const Scalar t210 = Scalar(60.0) * t209;
  const Scalar t211 = t210 + t208;
  const Scalar ddp_o_28_x = Scalar(76.25) * t207 - s_27 * t201 - c_27 * t211;
  const Scalar t212 = s_26 * t200 - c_26 * t196;
  const Scalar omega_r_27_a_z = s_26 * t6 + c_26 * omega_15_z;
  const Scalar t213 = s_26 * t198 - c_26 * U_15_zy + Scalar(2.0) * omega_r_27_a_z * omega_26_z;
  const Scalar domega_26_z = qdd_26 - t8;
  const Scalar t214 = t202 * omega_r_27_a_z;
  const Scalar Uz_o_27_x = domega_26_z - t214;
  const Scalar omega_27_z = qd_27 + omega_r_27_a_z;
  const Scalar t215 = Scalar(2.0) * t205 * omega_27_z - c_27 * Uz_o_27_x - s_27 * t213;
  const Scalar t216 = t212 + Scalar(76.25) * t215;
  const Scalar t217 = s_28 * ddp_o_28_x + c_28 * t216;
  const Scalar omega_r_28_x = s_28 * omega_r_27_x + c_28 * omega_27_z;
  const Scalar t218 = omega_r_28_x * omega_r_28_x;
  const Scalar omega_28_z = qd_28 - t205;
  const Scalar t219 = omega_28_z * omega_28_z;
  const Scalar t220 = t219 - t218;
  const Scalar t221 = omega_r_27_x * omega_r_27_x + omega_27_z * omega_27_z;
  const Scalar t222 = (t221 + t220) - t217;
  const Scalar t223 = omega_r_28_x * omega_28_z;
  const Scalar t224 = t223 + s_28 * t207 + c_28 * t215;
  const Scalar U_28_zx = t223 + t224;
  const Scalar ddp_o_28_y = Scalar(76.25) * t221 + s_27 * t211 - c_27 * t201;
  const Scalar ddp_o_29_z = U_28_zx + ddp_o_28_y;
  const Scalar t225 = s_29 * ddp_o_29_z + c_29 * t222;
  const Scalar domega_29_z = qdd_29 - t224;
  const Scalar t226 = s_29 * omega_28_z - c_29 * omega_r_28_x;
  const Scalar omega_r_30_a_z = s_29 * omega_r_28_x + c_29 * omega_28_z;
  const Scalar t227 = t226 * omega_r_30_a_z;
  const Scalar Uz_o_30_x = domega_29_z - t227;
  const Scalar t228 = t226 * t226;
  const Scalar t229 = s_28 * omega_27_z - c_28 * omega_r_27_x;
  const Scalar omega_29_z = qd_29 - t229;
  const Scalar t230 = omega_29_z * omega_29_z;
  const Scalar t231 = t218 + t219 + t230 - t228;
  const Scalar ddp_o_30_x = t231 - Scalar(59.75) * Uz_o_30_x - t225;
  const Scalar t232 = s_28 * t215 - c_28 * t207;
  const Scalar t233 = t232 + Scalar(2.0) * t229 * omega_28_z;
  const Scalar t234 = omega_r_27_x * omega_27_z;
  const Scalar t235 = t234 + s_27 * Uz_o_27_x - c_27 * t213;
  const Scalar domega_28_z = qdd_28 - t235;
  const Scalar t236 = omega_r_28_x * t229;
  const Scalar t237 = t236 + domega_28_z;
  const Scalar t238 = t226 * omega_29_z;
  const Scalar t239 = t238 - c_29 * t237 + s_29 * t233;
  const Scalar t240 = t238 + t239;
  const Scalar t241 = s_29 * t237 + Scalar(2.0) * omega_r_30_a_z * omega_29_z + c_29 * t233;
  const Scalar t242 = s_28 * t216 - c_28 * ddp_o_28_x;
  const Scalar U_28_yx = domega_28_z - t236;
  const Scalar ddp_o_29_y = U_28_yx - t242;
  const Scalar t243 = t240 - Scalar(59.75) * t241 + ddp_o_29_y;
  const Scalar t244 = s_30 * ddp_o_30_x - c_30 * t243;
  const Scalar t245 = s_29 * t222 - c_29 * ddp_o_29_z;
  const Scalar U_29_yx = t227 + domega_29_z;
  const Scalar Uz_o_30_y = t230 + t228;
  const Scalar ddp_30_a_z = U_29_yx + Scalar(59.75) * Uz_o_30_y - t245;
  const Scalar ddp_31_y = s_31 * t244 + c_31 * ddp_30_a_z;
  const Scalar domega_30_z = qdd_30 - t239;
  const Scalar omega_r_30_x = s_30 * t226 + c_30 * omega_29_z;
  const Scalar omega_r_31_a_z = s_30 * omega_29_z - c_30 * t226;
  const Scalar t246 = omega_r_30_x * omega_r_31_a_z;
  const Scalar Uz_o_31_x = t246 + domega_30_z;
  const Scalar omega_30_z = qd_30 + omega_r_30_a_z;
  const Scalar t247 = Scalar(2.0) * omega_r_31_a_z * omega_30_z - c_30 * Uz_o_30_x - s_30 * t241;
  const Scalar t248 = s_31 * omega_r_30_x - c_31 * omega_30_z;
  const Scalar omega_31_z = qd_31 + omega_r_31_a_z;
  const Scalar t249 = Scalar(2.0) * omega_31_z;
  const Scalar t250 = t248 * t249 - s_31 * Uz_o_31_x + c_31 * t247;
  const Scalar omega_32_z = qd_32 - t248;
  const Scalar t251 = t249 * omega_32_z + t250;
  const Scalar t252 = Scalar(13.553191489361701) * s_32;
  const Scalar t253 = omega_32_z * omega_32_z;
  const Scalar t254 = omega_31_z * omega_31_z;
  const Scalar t255 = t254 + t253;
  const Scalar omega_r_31_x = s_31 * omega_30_z + c_31 * omega_r_30_x;
  const Scalar t256 = omega_r_31_x * omega_r_31_x;
  const Scalar t257 = t254 + t256;
  const Scalar t258 = Scalar(0.0000376) * c_32;
  const Scalar t259 = t258 * (Scalar(19.898936170212767) * (t257 - t255) - t251 * t252 + ddp_31_y);
  const Scalar t260 = s_31 * ddp_30_a_z - c_31 * t244;
  const Scalar t261 = omega_r_31_x * omega_31_z;
  const Scalar t262 = t261 - s_31 * t247 - c_31 * Uz_o_31_x;
  const Scalar domega_32_z = qdd_32 - t262;
  const Scalar t263 = t261 + domega_32_z;
  const Scalar t264 = Scalar(0.0007482) * s_32;
  const Scalar t265 = omega_r_30_x * omega_30_z;
  const Scalar t266 = t265 + s_30 * Uz_o_30_x - c_30 * t241;
  const Scalar domega_31_z = qdd_31 + t266;
  const Scalar t267 = omega_r_31_x * t248;
  const Scalar t268 = t267 + domega_31_z;
  const Scalar U_32_zx = t268 + Scalar(2.0) * omega_r_31_x * omega_32_z;
  const Scalar t269 = Scalar(0.0005096) * s_32 * s_32;
  const Scalar I_32_yy = t269 + Scalar(0.0004516500000001);
  const Scalar U_31_yx = domega_31_z - t267;
  const Scalar mu_31_z = Scalar(0.00016) * U_31_yx + U_32_zx * I_32_yy + t263 * t264 - t259 +
      Scalar(0.0247118500000001) * t268 + Scalar(0.0007608) * t260;
  tau[30] = mu_31_z;
  const Scalar ddp_19_a_y = t195 + t194;
  const Scalar t270 = t199 + t197;
  const Scalar ddp_19_x = s_19 * ddp_19_a_y + c_19 * t270;
  const Scalar t271 = s_19 * omega_15_z - c_19 * t6;
  const Scalar omega_19_z = qd_19 + omega_r_15_y;
  const Scalar t272 = t271 * omega_19_z;
  const Scalar t273 = t272 - s_19 * U_15_zy - c_19 * t198;
  const Scalar domega_20_z = qdd_20 - t273;
  const Scalar omega_r_20_x = s_20 * t271 + c_20 * omega_19_z;
  const Scalar t274 = s_20 * omega_19_z - c_20 * t271;
  const Scalar t275 = omega_r_20_x * t274;
  const Scalar t276 = t275 + domega_20_z;
  const Scalar t277 = t208 - t210;
  const Scalar ddp_o_21_x = Scalar(76.25) * t276 - s_20 * ddp_19_x - c_20 * t277;
  const Scalar t278 = s_19 * t270 - c_19 * ddp_19_a_y;
  const Scalar omega_r_20_a_z = s_19 * t6 + c_19 * omega_15_z;
  const Scalar t279 = s_19 * t198 - c_19 * U_15_zy + Scalar(2.0) * omega_r_20_a_z * omega_19_z;
  const Scalar domega_19_z = qdd_19 - t8;
  const Scalar t280 = t271 * omega_r_20_a_z;
  const Scalar Uz_o_20_x = domega_19_z - t280;
  const Scalar omega_20_z = qd_20 + omega_r_20_a_z;
  const Scalar t281 = Scalar(2.0) * t274 * omega_20_z - c_20 * Uz_o_20_x - s_20 * t279;
  const Scalar t282 = t278 + Scalar(76.25) * t281;
  const Scalar t283 = s_21 * ddp_o_21_x + c_21 * t282;
  const Scalar omega_r_21_x = s_21 * omega_r_20_x + c_21 * omega_20_z;
  const Scalar t284 = omega_r_21_x * omega_r_21_x;
  const Scalar omega_21_z = qd_21 - t274;
  const Scalar t285 = omega_21_z * omega_21_z;
  const Scalar t286 = t285 - t284;
  const Scalar t287 = omega_r_20_x * omega_r_20_x + omega_20_z * omega_20_z;
  const Scalar t288 = (t287 + t286) - t283;
  const Scalar t289 = omega_r_21_x * omega_21_z;
  const Scalar t290 = t289 + s_21 * t276 + c_21 * t281;
  const Scalar U_21_zx = t289 + t290;
  const Scalar ddp_o_21_y = Scalar(76.25) * t287 + s_20 * t277 - c_20 * ddp_19_x;
  const Scalar ddp_o_22_z = U_21_zx + ddp_o_21_y;
  const Scalar t291 = s_22 * ddp_o_22_z + c_22 * t288;
  const Scalar domega_22_z = qdd_22 - t290;
  const Scalar t292 = s_22 * omega_21_z - c_22 * omega_r_21_x;
  const Scalar omega_r_23_a_z = s_22 * omega_r_21_x + c_22 * omega_21_z;
  const Scalar t293 = t292 * omega_r_23_a_z;
  const Scalar Uz_o_23_x = domega_22_z - t293;
  const Scalar t294 = t292 * t292;
  const Scalar t295 = s_21 * omega_20_z - c_21 * omega_r_20_x;
  const Scalar omega_22_z = qd_22 - t295;
  const Scalar t296 = omega_22_z * omega_22_z;
  const Scalar t297 = t284 + t285 + t296 - t294;
  const Scalar ddp_o_23_x = t297 - Scalar(59.75) * Uz_o_23_x - t291;
  const Scalar t298 = s_21 * t281 - c_21 * t276;
  const Scalar t299 = t298 + Scalar(2.0) * t295 * omega_21_z;
  const Scalar t300 = omega_r_20_x * omega_20_z;
  const Scalar t301 = t300 + s_20 * Uz_o_20_x - c_20 * t279;
  const Scalar domega_21_z = qdd_21 - t301;
  const Scalar t302 = omega_r_21_x * t295;
  const Scalar t303 = t302 + domega_21_z;
  const Scalar t304 = t292 * omega_22_z;
  const Scalar t305 = t304 - c_22 * t303 + s_22 * t299;
  const Scalar t306 = t304 + t305;
  const Scalar t307 = s_22 * t303 + Scalar(2.0) * omega_r_23_a_z * omega_22_z + c_22 * t299;
  const Scalar t308 = s_21 * t282 - c_21 * ddp_o_21_x;
  const Scalar U_21_yx = domega_21_z - t302;
  const Scalar ddp_o_22_y = U_21_yx - t308;
  const Scalar t309 = t306 - Scalar(59.75) * t307 + ddp_o_22_y;
  const Scalar t310 = s_23 * ddp_o_23_x - c_23 * t309;
  const Scalar t311 = s_22 * t288 - c_22 * ddp_o_22_z;
  const Scalar U_22_yx = t293 + domega_22_z;
  const Scalar Uz_o_23_y = t296 + t294;
  const Scalar ddp_23_a_z = U_22_yx + Scalar(59.75) * Uz_o_23_y - t311;
  const Scalar ddp_24_y = s_24 * t310 + c_24 * ddp_23_a_z;
  const Scalar domega_23_z = qdd_23 - t305;
  const Scalar omega_r_23_x = s_23 * t292 + c_23 * omega_22_z;
  const Scalar omega_r_24_a_z = s_23 * omega_22_z - c_23 * t292;
  const Scalar t312 = omega_r_23_x * omega_r_24_a_z;
  const Scalar Uz_o_24_x = t312 + domega_23_z;
  const Scalar omega_23_z = qd_23 + omega_r_23_a_z;
  const Scalar t313 = Scalar(2.0) * omega_r_24_a_z * omega_23_z - c_23 * Uz_o_23_x - s_23 * t307;
  const Scalar t314 = s_24 * omega_r_23_x - c_24 * omega_23_z;
  const Scalar omega_24_z = qd_24 + omega_r_24_a_z;
  const Scalar t315 = Scalar(2.0) * omega_24_z;
  const Scalar t316 = t314 * t315 - s_24 * Uz_o_24_x + c_24 * t313;
  const Scalar omega_25_z = qd_25 - t314;
  const Scalar t317 = t315 * omega_25_z + t316;
  const Scalar t318 = Scalar(13.553191489361701) * s_25;
  const Scalar t319 = omega_25_z * omega_25_z;
  const Scalar t320 = omega_24_z * omega_24_z;
  const Scalar t321 = t320 + t319;
  const Scalar omega_r_24_x = s_24 * omega_23_z + c_24 * omega_r_23_x;
  const Scalar t322 = omega_r_24_x * omega_r_24_x;
  const Scalar t323 = t320 + t322;
  const Scalar t324 = Scalar(0.0000376) * c_25;
  const Scalar t325 = t324 * (t317 * t318 + Scalar(19.898936170212767) * (t323 - t321) + ddp_24_y);
  const Scalar t326 = s_24 * ddp_23_a_z - c_24 * t310;
  const Scalar t327 = omega_r_24_x * omega_24_z;
  const Scalar t328 = t327 - s_24 * t313 - c_24 * Uz_o_24_x;
  const Scalar domega_25_z = qdd_25 - t328;
  const Scalar t329 = t327 + domega_25_z;
  const Scalar t330 = Scalar(0.0007482) * s_25;
  const Scalar t331 = omega_r_23_x * omega_23_z;
  const Scalar t332 = t331 + s_23 * Uz_o_23_x - c_23 * t307;
  const Scalar domega_24_z = qdd_24 + t332;
  const Scalar t333 = omega_r_24_x * t314;
  const Scalar t334 = t333 + domega_24_z;
  const Scalar U_25_zx = t334 + Scalar(2.0) * omega_r_24_x * omega_25_z;
  const Scalar t335 = Scalar(0.0005096) * s_25 * s_25;
  const Scalar I_25_yy = t335 + Scalar(0.0004516500000001);
  const Scalar U_24_yx = domega_24_z - t333;
  const Scalar mu_24_z = Scalar(0.00016) * U_24_yx + U_25_zx * I_25_yy - t329 * t330 + t325 +
      Scalar(0.0247118500000001) * t334 + Scalar(0.0007608) * t326;
  tau[23] = mu_24_z;
  const Scalar t336 = (t334 + Scalar(0.05025394279604384) * t326) * t330;
  const Scalar t337 = t327 - domega_25_z;
  const Scalar t338 = t335 - Scalar(0.0009612500000001);
  const Scalar ddp_24_a_z = s_23 * t309 + c_23 * ddp_o_23_x;
  const Scalar t339 = t322 + t319;
  const Scalar t340 = ((t321 - t339) * t318 + Scalar(19.898936170212767) * t316 + ddp_24_a_z) *
      t324;
  const Scalar t341 = t337 * I_25_yy + t329 * t338 + t336 + t340;
  tau[24] = -t341;
  const Scalar t342 = (t268 + Scalar(0.05025394279604384) * t260) * t264;
  const Scalar t343 = t261 - domega_32_z;
  const Scalar t344 = t269 - Scalar(0.0009612500000001);
  const Scalar ddp_31_a_z = s_30 * t243 + c_30 * ddp_o_30_x;
  const Scalar t345 = t256 + t253;
  const Scalar t346 = (Scalar(19.898936170212767) * t250 - (t255 - t345) * t252 + ddp_31_a_z) *
      t258;
  const Scalar t347 = t343 * I_32_yy + t263 * t344 - t342 - t346;
  tau[31] = -t347;
  const Scalar U_31_zx = t261 + t262;
  const Scalar t348 = Scalar(0.00016) * U_31_zx + t347;
  const Scalar t349 = c_32 * U_32_zx;
  const Scalar U_32_yy_zz = t257 - t345;
  const Scalar t350 = s_32 * (Scalar(13.553191489361701) * t349 +
      Scalar(19.898936170212767) * U_32_yy_zz + ddp_31_y);
  const Scalar t351 = c_32 * t343;
  const Scalar t352 = Scalar(0.0000376) * t350 - Scalar(0.0007482) * t351 - t251 * t344 +
      Scalar(0.0247118500000001) * t250 + Scalar(0.0007608) * ddp_31_a_z;
  const Scalar U_30_yx = domega_30_z - t246;
  const Scalar mu_30_z = Scalar(0.00048) * Uz_o_31_x + Scalar(0.00032) * U_30_yx - c_31 * t348 -
      s_31 * t352;
  tau[29] = mu_30_z;
  const Scalar U_24_zx = t327 + t328;
  const Scalar t353 = Scalar(0.00016) * U_24_zx + t341;
  const Scalar t354 = c_25 * U_25_zx;
  const Scalar U_25_yy_zz = t323 - t339;
  const Scalar t355 = s_25 * (Scalar(19.898936170212767) * U_25_yy_zz -
      Scalar(13.553191489361701) * t354 + ddp_24_y);
  const Scalar t356 = c_25 * t337;
  const Scalar t357 = Scalar(0.0007482) * t356 - t317 * t338 - Scalar(0.0000376) * t355 +
      Scalar(0.0247118500000001) * t316 + Scalar(0.0007608) * ddp_24_a_z;
  const Scalar U_23_yx = domega_23_z - t312;
  const Scalar mu_23_z = Scalar(0.00048) * Uz_o_24_x + Scalar(0.00032) * U_23_yx - c_24 * t353 -
      s_24 * t357;
  tau[22] = mu_23_z;
  const Scalar t358 = Scalar(0.00048) * t247 - s_31 * t348 + c_31 * t352;
  const Scalar f_31_x = Scalar(0.0000376) * (c_32 * t255 + s_32 * t263) + Scalar(0.0007608) * t268;
  const Scalar f_31_y = Scalar(0.0000376) * (s_32 * t251 - t349) + Scalar(0.0007608) * t257;
  const Scalar t359 = s_31 * f_31_y - c_31 * f_31_x + Scalar(0.0001312) * t244;
  const Scalar t360 = Scalar(0.0007608) * t250 - Scalar(0.0000376) * (s_32 * t345 + t351) +
      Scalar(0.0001312) * ddp_31_a_z;
  const Scalar f_u_30_t_x = s_30 * t359 + c_30 * t360;
  const Scalar U_30_zx = t265 + t266;
  const Scalar t361 = Scalar(0.00032) * U_30_zx + mu_31_z;
  const Scalar f_30_z = c_31 * f_31_y + s_31 * f_31_x + Scalar(0.0001312) * ddp_30_a_z;
  const Scalar t362 = Scalar(-0.00167) * U_29_yx - Scalar(0.00278) * (t231 - Uz_o_30_y) - f_30_z +
      c_30 * t358 - s_30 * t361 + Scalar(0.26596) * Uz_o_30_x + Scalar(0.00438) * t225 +
      Scalar(59.75) * f_u_30_t_x;
  tau[28] = -t362;
  const Scalar t363 = Scalar(0.00048) * t313 - s_24 * t353 + c_24 * t357;
  const Scalar f_24_x = Scalar(0.0007608) * t334 - Scalar(0.0000376) * (c_25 * t321 + s_25 * t329);
  const Scalar f_24_y = Scalar(0.0007608) * t323 - Scalar(0.0000376) * (s_25 * t317 - t354);
  const Scalar t364 = s_24 * f_24_y - c_24 * f_24_x + Scalar(0.0001312) * t310;
  const Scalar t365 = Scalar(0.0000376) * (s_25 * t339 + t356) + Scalar(0.0007608) * t316 +
      Scalar(0.0001312) * ddp_24_a_z;
  const Scalar f_u_23_t_x = s_23 * t364 + c_23 * t365;
  const Scalar U_23_zx = t331 + t332;
  const Scalar t366 = Scalar(0.00032) * U_23_zx + mu_24_z;
  const Scalar f_23_z = c_24 * f_24_y + s_24 * f_24_x + Scalar(0.0001312) * ddp_23_a_z;
  const Scalar t367 = Scalar(-0.00167) * U_22_yx - Scalar(0.00278) * (t297 - Uz_o_23_y) - f_23_z +
      c_23 * t363 - s_23 * t366 + Scalar(0.26596) * Uz_o_23_x + Scalar(0.00438) * t291 +
      Scalar(59.75) * f_u_23_t_x;
  tau[21] = -t367;
  const Scalar t368 = s_30 * t360 - c_30 * t359;
  const Scalar t369 = Scalar(0.00278) * t240 - s_30 * t358 - c_30 * t361 - Scalar(0.26596) * t241 +
      Scalar(0.00438) * ddp_o_29_y - Scalar(59.75) * t368;
  const Scalar t370 = Scalar(0.00167) * t240 + Scalar(0.00278) * t241 + t368 - mu_30_z;
  const Scalar t371 = Scalar(0.00438) * t241 - Scalar(0.000144) * ddp_o_29_y + t368;
  const Scalar t372 = Scalar(0.0023) * t232 - Scalar(0.00405) * t237 - Scalar(0.00393) * U_28_yx -
      t371 + c_29 * t370 - s_29 * t369;
  tau[27] = -t372;
  const Scalar t373 = s_23 * t365 - c_23 * t364;
  const Scalar t374 = Scalar(0.00278) * t306 - s_23 * t363 - c_23 * t366 - Scalar(0.26596) * t307 +
      Scalar(0.00438) * ddp_o_22_y - Scalar(59.75) * t373;
  const Scalar t375 = Scalar(0.00167) * t306 + Scalar(0.00278) * t307 + t373 - mu_23_z;
  const Scalar t376 = Scalar(0.00438) * t307 - Scalar(0.000144) * ddp_o_22_y + t373;
  const Scalar t377 = Scalar(0.0023) * t298 - Scalar(0.00405) * t303 - Scalar(0.00393) * U_21_yx -
      t376 + c_22 * t375 - s_22 * t374;
  tau[20] = -t377;
  const Scalar f_29_x = Scalar(0.00438) * Uz_o_30_x + Scalar(0.000144) * t225 + f_u_30_t_x;
  const Scalar f_29_y = Scalar(0.00438) * Uz_o_30_y - Scalar(0.000144) * t245 - f_30_z;
  const Scalar t378 = Scalar(0.0000999344262295082) * t217 - s_29 * f_29_y + c_29 * f_29_x;
  const Scalar t379 = Scalar(0.0000999344262295082) * t242 - t371;
  const Scalar f_u_28_t_x = s_28 * t378 - c_28 * t379;
  const Scalar f_u_29_t_y = c_29 * f_29_y + s_29 * f_29_x;
  const Scalar t380 = Scalar(0.0023) * t220 - Scalar(0.00393) * U_28_zx + f_u_29_t_y - t362;
  const Scalar mu_28_x = Scalar(0.0023) * U_28_yx - Scalar(0.00405) * t233 - s_29 * t370 -
      c_29 * t369;
  const Scalar U_27_yx = domega_27_z - t206;
  const Scalar mu_u_27_a_y = Scalar(0.03177) * t207 - Scalar(0.00098) * U_27_yx + s_28 * t380 -
      c_28 * mu_28_x - Scalar(76.25) * f_u_28_t_x;
  tau[26] = -mu_u_27_a_y;
  const Scalar f_22_x = Scalar(0.00438) * Uz_o_23_x + Scalar(0.000144) * t291 + f_u_23_t_x;
  const Scalar f_22_y = Scalar(0.00438) * Uz_o_23_y - Scalar(0.000144) * t311 - f_23_z;
  const Scalar t381 = Scalar(0.0000999344262295082) * t283 - s_22 * f_22_y + c_22 * f_22_x;
  const Scalar t382 = Scalar(0.0000999344262295082) * t308 - t376;
  const Scalar f_u_21_t_x = s_21 * t381 - c_21 * t382;
  const Scalar f_u_22_t_y = c_22 * f_22_y + s_22 * f_22_x;
  const Scalar t383 = Scalar(0.0023) * t286 - Scalar(0.00393) * U_21_zx + f_u_22_t_y - t367;
  const Scalar mu_21_x = Scalar(0.0023) * U_21_yx - Scalar(0.00405) * t299 - s_22 * t375 -
      c_22 * t374;
  const Scalar U_20_yx = domega_20_z - t275;
  const Scalar mu_u_20_a_y = Scalar(0.03177) * t276 - Scalar(0.00098) * U_20_yx + s_21 * t383 -
      c_21 * mu_21_x - Scalar(76.25) * f_u_21_t_x;
  tau[19] = -mu_u_20_a_y;
  const Scalar t384 = s_28 * t379 + c_28 * t378;
  const Scalar t385 = Scalar(0.03177) * t215 + s_28 * mu_28_x + c_28 * t380 - Scalar(76.25) * t384;
  const Scalar U_27_zx = t234 + t235;
  const Scalar t386 = Scalar(0.00098) * U_27_zx + t372;
  const Scalar U_26_yx = t214 + domega_26_z;
  const Scalar mu_26_z = Scalar(0.00098) * U_26_yx + Scalar(0.00196) * Uz_o_27_x + s_27 * t386 +
      c_27 * t385;
  tau[25] = mu_26_z;
  const Scalar t387 = s_21 * t382 + c_21 * t381;
  const Scalar t388 = Scalar(0.03177) * t281 + s_21 * mu_21_x + c_21 * t383 - Scalar(76.25) * t387;
  const Scalar U_20_zx = t300 + t301;
  const Scalar t389 = Scalar(0.00098) * U_20_zx + t377;
  const Scalar U_19_yx = t280 + domega_19_z;
  const Scalar mu_19_z = Scalar(0.00098) * U_19_yx + Scalar(0.00196) * Uz_o_20_x + s_20 * t389 +
      c_20 * t388;
  tau[18] = mu_19_z;
  const Scalar f_28_z = Scalar(0.0000999344262295082) * ddp_o_28_y - f_u_29_t_y;
  const Scalar t390 = Scalar(0.00016042921013412816) * t201 - s_27 * f_u_28_t_x - c_27 * f_28_z;
  const Scalar f_21_z = Scalar(0.0000999344262295082) * ddp_o_21_y - f_u_22_t_y;
  const Scalar f_19_x = Scalar(0.000044065573770491804) * ddp_19_x - s_20 * f_u_21_t_x -
      c_20 * f_21_z;
  const Scalar t391 = Scalar(0.00016042921013412816) * t212 + t384;
  const Scalar t392 = Scalar(0.000044065573770491804) * t278 + t387;
  const Scalar t393 = s_26 * t391 + c_26 * t390 - s_19 * t392 - c_19 * f_19_x;
  const Scalar t394 = Scalar(0.00196) * t279 - c_20 * t389 + s_20 * t388;
  const Scalar t395 = Scalar(0.00196) * t213 - c_27 * t386 + s_27 * t385;
  const Scalar mu_19_y = Scalar(0.00098) * (t272 + t273) + mu_u_20_a_y;
  const Scalar mu_26_y = Scalar(0.00098) * (t203 + t204) + mu_u_27_a_y;
  const Scalar t396 = Scalar(0.000044065573770491804) * t277 +
      Scalar(0.00016042921013412816) * t211 + s_27 * f_28_z - c_27 * f_u_28_t_x + s_20 * f_21_z -
      c_20 * f_u_21_t_x;
  const Scalar t397 = t157 * U_18_xy - t42 * t160;
  const Scalar t398 = t42 * t27 + t157 * t20;
  const Scalar t399 = s_17 * t397 + c_17 * t398 + Scalar(0.00004711699779249448) * t34;
  const Scalar t400 = t42 * U_18_yx - t157 * t161 + Scalar(0.00004711699779249448) * t162;
  const Scalar t401 = s_16 * t400 - c_16 * t399;
  const Scalar t402 = Scalar(0.0005625) * t12 - s_17 * t173 - c_17 * mu_17_y;
  const Scalar t403 = Scalar(0.0003125) * (t22 + t23) - mu_17_z;
  const Scalar mu_15_z = Scalar(0.048) * t13 + s_16 * t402 - c_16 * t403 -
      Scalar(0.164908333333833) * U_15_yx - Scalar(0.3206157575755909) * t198 -
      Scalar(17.12290909090909) * t38 + Scalar(0.576) * (Uz_o_16_x - t209) - Scalar(113.25) * t401 +
      s_19 * t394 - c_19 * mu_19_y + s_26 * t395 - c_26 * mu_26_y - Scalar(60.0) * t393 +
      Scalar(82.5) * t396;
  tau[14] = mu_15_z;
  const Scalar t404 = s_26 * t390 - c_26 * t391;
  const Scalar f_u_19_t_y = s_19 * f_19_x - c_19 * t392;
  const Scalar mu_15_x = Scalar(0.75) * t401 + Scalar(0.048) * U_15_yx - mu_16_z -
      Scalar(0.3206157575755909) * U_15_zy + Scalar(0.006981818181818182) * t194 - s_19 * mu_19_y -
      c_19 * t394 - s_26 * mu_26_y - c_26 * t395 - Scalar(60.0) * (t404 - f_u_19_t_y);
  const Scalar t405 = s_16 * t399 + c_16 * t400;
  const Scalar t406 = s_17 * t398 - c_17 * t397 + Scalar(0.00004711699779249448) * t40;
  const Scalar t407 = Scalar(0.048) * t37 - Scalar(0.75) * t406 - s_16 * t403 - c_16 * t402 +
      Scalar(0.164908333333833) * t9 - Scalar(0.576) * U_15_zy + Scalar(113.25) * t405 + mu_26_z +
      mu_19_z - Scalar(82.5) * (t404 + f_u_19_t_y);
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
// Reads q[1..5], q[7..11], q[13..31]. Operations: 965 mul, 721 add, 58 sin/cos. Always zero: 740 of
// the 1024 entries of B.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inertia_matrix(const Scalar* q, Scalar* B, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
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
  const Scalar Iu_17_t_d = t11 - Scalar(0.0242);
  const Scalar t16 = s_17 * s_17 * Iu_17_t_d;
  const Scalar Ic_16_zz = t11 - t16 + Scalar(0.011005);
  B[495] = Ic_16_zz;
  const Scalar t17 = Scalar(10.0) * hu_6_t_x + c_6 * t7 - Scalar(0.00315);
  B[100] = B[131] = -s_5 * t17;
  const Scalar t18 = Scalar(89.25) * hu_6_a_z;
  const Scalar B_3_6 = s_5 * (c_4 * t12 - t18 * (Scalar(0.056022408963585436) + s_4));
  B[69] = B[162] = B_3_6;
  const Scalar t19 = Scalar(10.0) * hu_12_t_x + c_12 * t5 - Scalar(0.00315);
  B[298] = B[329] = -s_11 * t19;
  const Scalar t20 = Scalar(89.25) * hu_12_a_z;
  const Scalar B_9_12 = s_11 * (c_10 * t14 - t20 * (Scalar(0.056022408963585436) + s_10));
  B[267] = B[360] = B_9_12;
  const Scalar f_u_18_18_a_z = Scalar(0.00088) * c_18 - Scalar(0.00008) * s_18;
  const Scalar hu_18_a_z = Scalar(0.00008) * c_18 + Scalar(0.00088) * s_18;
  const Scalar t21 = c_16 * s_17;
  const Scalar f_u_18_16_t_x = s_16 * f_u_18_18_a_z + hu_18_a_z * t21;
  const Scalar t22 = Scalar(0.03408) * c_17;
  const Scalar mu_u_18_15_a_y = s_16 * t22 + Scalar(113.25) * f_u_18_16_t_x;
  B[465] = B[558] = -mu_u_18_15_a_y;
  const Scalar t23 = Scalar(0.0000376) * s_32;
  const Scalar t24 = s_30 * t23;
  const Scalar t25 = Scalar(0.0000376) * c_32;
  const Scalar t26 = c_31 * t24 - c_30 * t25;
  const Scalar t27 = c_31 * c_32;
  const Scalar t28 = Scalar(0.0007482) * t27 + Scalar(0.0014129000000002) * s_31;
  const Scalar t29 = s_31 * t23;
  const Scalar mu_32_29_z = t29 + s_30 * Iu_32_a_xy - c_30 * t28 + Scalar(59.75) * t26;
  B[927] = B[1020] = mu_32_29_z;
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
  const Scalar hu_30_a_y = s_31 * t25 + Scalar(0.0007608) * c_31;
  const Scalar t41 = Ic_31_zz + Scalar(59.75) * hu_30_a_y;
  const Scalar t42 = Scalar(0.6811013098102112) * t27 + s_31;
  const Scalar t43 = Iu_32_a_xy * t42;
  const Scalar hu_31_t_x = Scalar(0.0007608) * s_31 - c_31 * t25;
  const Scalar mu_31_29_z = hu_31_t_x - c_30 * t43 + s_30 * t41;
  B[926] = B[988] = mu_31_29_z;
  const Scalar t44 = c_11 * (t6 + Scalar(0.00675));
  const Scalar t45 = c_11 * t44;
  const Scalar t46 = c_11 * hu_12_t_x;
  const Scalar t47 = Scalar(178.5) * t46;
  const Scalar t48 = Scalar(20.0) * hu_12_a_z;
  const Scalar t49 = t6 - t45 - t48 - t47 - Scalar(0.44695416666667);
  B[297] = -t49;
  const Scalar t50 = c_5 * (t8 + Scalar(0.00675));
  const Scalar t51 = c_5 * t50;
  const Scalar t52 = c_5 * hu_6_t_x;
  const Scalar t53 = Scalar(178.5) * t52;
  const Scalar t54 = Scalar(20.0) * hu_6_a_z;
  const Scalar t55 = t8 - t51 - t54 - t53 - Scalar(0.44695416666667);
  B[99] = -t55;
  const Scalar t56 = c_17 * f_u_18_18_a_z;
  const Scalar t57 = mu_u_17_17_a_y - Scalar(113.25) * t56;
  const Scalar t58 = s_16 * s_17;
  const Scalar t59 = Iu_18_a_yz * t58;
  const Scalar t60 = t59 + c_16 * t57;
  B[464] = B[526] = -t60;
  const Scalar t61 = mu_u_18_17_t_y - Scalar(0.75) * f_u_18_16_t_x;
  const Scalar t62 = hu_18_a_z * t58 - c_16 * f_u_18_18_a_z;
  const Scalar t63 = Scalar(113.25) * t62 - (c_16 - Scalar(22.007042253521128) * hu_18_a_z) * t22;
  B[433] = B[557] = -s_15 * t61 - c_15 * t63;
  const Scalar t64 = c_30 * t23;
  const Scalar f_u_32_30_t_y = c_31 * t64 + s_30 * t25;
  const Scalar mu_32_29_x = c_30 * Iu_32_a_xy + s_30 * t28 + Scalar(59.75) * f_u_32_30_t_y;
  const Scalar t65 = mu_u_32_31_t_y - f_u_32_30_t_y;
  const Scalar mu_32_28_z = f_u_32_30_t_y + c_29 * t65 - s_29 * mu_32_29_x;
  B[895] = B[1019] = mu_32_28_z;
  const Scalar t66 = t44 + t15;
  const Scalar t67 = s_10 * t19 + c_10 * t66;
  const Scalar Iu_10_a_xy = s_11 * t67;
  B[265] = B[296] = Iu_10_a_xy;
  const Scalar t68 = t50 + t13;
  const Scalar t69 = s_4 * t17 + c_4 * t68;
  const Scalar Iu_4_a_xy = s_5 * t69;
  B[67] = B[98] = Iu_4_a_xy;
  const Scalar t70 = c_4 * t17;
  const Scalar t71 = Scalar(5.0) * hu_6_t_x;
  const Scalar t72 = Ic_5_zz + Scalar(89.25) * t52;
  const Scalar t73 = s_4 * t72 - c_5 * (t70 - t71);
  B[68] = B[130] = -t73;
  const Scalar t74 = c_5 * t17;
  const Scalar mu_u_5_4_t_x = s_4 * t74 + c_4 * t72;
  const Scalar t75 = t17 - c_4 * t71;
  const Scalar t76 = s_3 * s_5;
  const Scalar t77 = Scalar(97.25) * hu_6_t_x;
  const Scalar t78 = (s_4 * t76 + c_3 * c_5) * t77;
  B[36] = B[129] = t76 * t75 + c_3 * mu_u_5_4_t_x + t78;
  const Scalar t79 = c_5 * hu_6_a_z;
  const Scalar t80 = s_4 * t79 + c_4 * hu_6_t_x;
  const Scalar t81 = c_3 * s_5;
  const Scalar t82 = s_3 * t80 - hu_6_a_z * t81;
  const Scalar mu_6_3_y = Scalar(5.0) * (s_4 * hu_6_t_x - c_4 * t79) + mu_6_4_z;
  const Scalar t83 = s_4 * t12 + c_4 * t18;
  B[37] = B[161] = t81 * t83 - Scalar(97.25) * t82 - s_3 * mu_6_3_y;
  const Scalar t84 = c_10 * t19;
  const Scalar t85 = Scalar(5.0) * hu_12_t_x;
  const Scalar t86 = Ic_11_zz + Scalar(89.25) * t46;
  const Scalar t87 = s_10 * t86 - c_11 * (t84 - t85);
  B[266] = B[328] = -t87;
  const Scalar t88 = c_11 * t19;
  const Scalar mu_u_11_10_t_x = s_10 * t88 + c_10 * t86;
  const Scalar t89 = t19 - c_10 * t85;
  const Scalar t90 = s_9 * s_11;
  const Scalar t91 = Scalar(97.25) * hu_12_t_x;
  const Scalar t92 = (s_10 * t90 + c_9 * c_11) * t91;
  B[234] = B[327] = t90 * t89 + c_9 * mu_u_11_10_t_x + t92;
  const Scalar t93 = c_11 * hu_12_a_z;
  const Scalar t94 = s_10 * t93 + c_10 * hu_12_t_x;
  const Scalar t95 = c_9 * s_11;
  const Scalar t96 = s_9 * t94 - hu_12_a_z * t95;
  const Scalar mu_12_9_y = Scalar(5.0) * (s_10 * hu_12_t_x - c_10 * t93) + mu_12_10_z;
  const Scalar t97 = s_10 * t14 + c_10 * t20;
  B[235] = B[359] = t95 * t97 - Scalar(97.25) * t96 - s_9 * mu_12_9_y;
  const Scalar t98 = c_16 * Iu_18_a_yz;
  const Scalar hu_16_a_z = f_u_18_18_a_z * t58 + c_16 * hu_18_a_z;
  const Scalar t99 = Scalar(113.25) * hu_16_a_z - c_17 * (Iu_17_t_d * t58 - t98);
  B[463] = B[494] = -t99;
  B[401] = B[556] = s_14 * mu_u_18_15_a_y - c_14 * (s_15 * t63 - c_15 * t61);
  const Scalar t100 = s_23 * t34 - c_23 * t31;
  const Scalar t101 = c_23 * hu_23_a_y;
  const Scalar mu_24_22_y = t10 + t101;
  const Scalar mu_24_21_z = t101 - c_22 * mu_24_22_y + s_22 * t100;
  B[663] = B[756] = mu_24_21_z;
  const Scalar t102 = c_23 * t35;
  const Scalar t103 = c_24 * t102 + s_23 * t30;
  const Scalar t104 = c_23 * t9 - s_23 * t38 + Scalar(59.75) * t103;
  const Scalar t105 = t103 + mu_u_25_24_t_y;
  const Scalar t106 = t103 - c_22 * t105 - s_22 * t104;
  B[664] = B[788] = -t106;
  const Scalar mu_31_29_x = s_30 * t43 + c_30 * t41;
  const Scalar t107 = c_30 * hu_30_a_y;
  const Scalar t108 = Iu_31_t_yz - t107;
  const Scalar mu_31_28_z = t107 + c_29 * t108 - s_29 * mu_31_29_x;
  B[894] = B[987] = mu_31_28_z;
  const Scalar t109 = t3 - Scalar(0.0005096);
  const Scalar t110 = c_31 * (t109 - Scalar(0.0235906)) - Scalar(0.0014964) * t2;
  const Scalar t111 = c_31 * t110;
  const Scalar mu_u_30_30_a_y = t109 - t111 - Scalar(0.0259635000000002);
  B[957] = -mu_u_30_30_a_y;
  const Scalar t112 = t4 - Scalar(0.0005096);
  const Scalar t113 = Scalar(0.0014964) * t1 + c_24 * (t112 - Scalar(0.0235906));
  const Scalar t114 = c_24 * t113;
  const Scalar mu_u_23_23_a_y = t112 - t114 - Scalar(0.0259635000000002);
  B[726] = -mu_u_23_23_a_y;
  const Scalar t115 = s_4 * t68 - t70;
  const Scalar hc_4_x = t52 + Scalar(0.00549);
  const Scalar f_4_4_x = hu_6_a_z + Scalar(0.00088);
  const Scalar t116 = s_4 * hc_4_x - c_4 * f_4_4_x;
  const Scalar hu_4_t_y = s_4 * f_4_4_x + c_4 * hc_4_x;
  const Scalar t117 = t55 - Scalar(5.0) * t116 - Scalar(97.25) * hu_4_t_y;
  B[35] = B[97] = t115 * t81 + s_3 * t117;
  const Scalar t118 = s_10 * t66 - t84;
  const Scalar hc_10_x = t46 + Scalar(0.00549);
  const Scalar f_10_10_x = hu_12_a_z + Scalar(0.00088);
  const Scalar t119 = s_10 * hc_10_x - c_10 * f_10_10_x;
  const Scalar hu_10_t_y = s_10 * f_10_10_x + c_10 * hc_10_x;
  const Scalar t120 = t49 - Scalar(5.0) * t119 - Scalar(97.25) * hu_10_t_y;
  B[233] = B[295] = t118 * t95 + s_9 * t120;
  const Scalar t121 = Scalar(0.75) * f_u_18_18_a_z;
  const Scalar t122 = s_16 * t57 - s_17 * (t98 - t121);
  const Scalar t123 = c_17 * (Iu_18_a_yz - c_16 * t121);
  B[432] = B[525] = s_15 * t123 - c_15 * t122;
  const Scalar f_u_32_29_t_x = s_29 * t29 - c_29 * t26;
  const Scalar f_u_32_28_t_x = s_28 * f_u_32_29_t_x + c_28 * f_u_32_30_t_y;
  const Scalar f_u_32_29_a_z = c_29 * t29 + s_29 * t26;
  const Scalar mu_32_28_y = mu_32_29_z - f_u_32_29_a_z;
  const Scalar mu_u_32_29_t_x = s_29 * t65 + c_29 * mu_32_29_x;
  const Scalar mu_32_27_z = c_28 * mu_u_32_29_t_x + Scalar(76.25) * f_u_32_28_t_x -
      s_28 * mu_32_28_y;
  B[863] = B[1018] = mu_32_27_z;
  const Scalar t124 = Scalar(0.0007482) * c_32 + s_31 * t110;
  const Scalar hu_30_t_y = t24 + c_30 * hu_31_t_x;
  const Scalar mu_30_29_z = s_30 * Iu_31_t_yz - c_30 * t124 + Scalar(59.75) * hu_30_t_y;
  B[925] = B[956] = mu_30_29_z;
  const Scalar t125 = (s_3 * c_5 - s_4 * t81) * t77;
  B[4] = B[128] = s_2 * t73 + c_2 * (s_3 * mu_u_5_4_t_x - t81 * t75 + t125);
  const Scalar f_u_6_3_t_y = hu_6_a_z * t76 + c_3 * t80;
  const Scalar mu_6_2_x = t76 * t83 + Scalar(97.25) * f_u_6_3_t_y + c_3 * mu_6_3_y;
  B[5] = B[160] = c_2 * mu_6_2_x - s_2 * B_3_6;
  const Scalar t126 = (s_9 * c_11 - s_10 * t95) * t91;
  B[202] = B[326] = s_8 * t87 + c_8 * (s_9 * mu_u_11_10_t_x - t95 * t89 + t126);
  const Scalar f_u_12_9_t_y = hu_12_a_z * t90 + c_9 * t94;
  const Scalar mu_12_8_x = t90 * t97 + Scalar(97.25) * f_u_12_9_t_y + c_9 * mu_12_9_y;
  B[203] = B[358] = c_8 * mu_12_8_x - s_8 * B_9_12;
  const Scalar t127 = s_16 * hu_18_a_z - f_u_18_18_a_z * t21;
  const Scalar t128 = c_17 * (s_16 * Iu_18_a_yz + Iu_17_t_d * t21) + Scalar(113.25) * t127;
  const Scalar t129 = Ic_16_zz - Scalar(0.75) * hu_16_a_z;
  B[431] = B[493] = -s_15 * t129 - c_15 * t128;
  const Scalar t130 = s_22 * mu_24_22_y + c_22 * t100;
  const Scalar t131 = s_23 * hu_23_a_y;
  const Scalar t132 = s_22 * hu_24_t_x - c_22 * t131;
  const Scalar f_u_24_21_t_x = s_21 * t132 + c_21 * t101;
  const Scalar f_u_24_22_a_z = s_22 * t131 + c_22 * hu_24_t_x;
  const Scalar mu_24_21_y = mu_24_22_z - f_u_24_22_a_z;
  const Scalar mu_24_20_z = -c_21 * t130 - s_21 * mu_24_21_y + Scalar(76.25) * f_u_24_21_t_x;
  B[631] = B[755] = mu_24_20_z;
  const Scalar t133 = s_22 * t39 - c_22 * t37;
  const Scalar t134 = s_21 * t133 + c_21 * t103;
  const Scalar f_u_25_22_t_y = c_22 * t39 + s_22 * t37;
  const Scalar t135 = t40 - f_u_25_22_t_y;
  const Scalar t136 = s_22 * t105 - c_22 * t104;
  const Scalar mu_u_25_20_a_y = Scalar(76.25) * t134 - c_21 * t136 - s_21 * t135;
  B[632] = B[787] = -mu_u_25_20_a_y;
  const Scalar t137 = s_29 * t108 + c_29 * mu_31_29_x;
  const Scalar t138 = s_30 * hu_30_a_y;
  const Scalar t139 = s_29 * hu_31_t_x - c_29 * t138;
  const Scalar f_u_31_28_t_x = s_28 * t139 + c_28 * t107;
  const Scalar f_u_31_29_a_z = s_29 * t138 + c_29 * hu_31_t_x;
  const Scalar mu_31_28_y = mu_31_29_z - f_u_31_29_a_z;
  const Scalar mu_31_27_z = c_28 * t137 - s_28 * mu_31_28_y + Scalar(76.25) * f_u_31_28_t_x;
  B[862] = B[986] = mu_31_27_z;
  const Scalar Iu_24_t_xy = Scalar(0.0007482) * c_25 - s_24 * t113;
  const Scalar t140 = t36 - c_23 * hu_24_t_x;
  const Scalar t141 = s_23 * t10 - c_23 * Iu_24_t_xy + Scalar(59.75) * t140;
  B[694] = B[725] = -t141;
  B[399] = B[492] = s_14 * t99 - c_14 * (s_15 * t128 - c_15 * t129);
  const Scalar mu_u_17_15_t_x = c_15 * t123 + s_15 * t122;
  B[400] = B[524] = s_14 * t60 - c_14 * mu_u_17_15_t_x;
  const Scalar t142 = s_21 * t103 - c_21 * t133;
  const Scalar t143 = Scalar(76.25) * t142 - s_21 * t136 + c_21 * t135;
  const Scalar mu_u_25_20_t_y = s_20 * t106 - c_20 * t143;
  B[600] = B[786] = mu_u_25_20_t_y;
  const Scalar t144 = t45 - t48 - Scalar(0.00555);
  const Scalar Ic_10_yy = t6 + t47 + Scalar(0.4098975);
  const Scalar Ic_10_xy = t88 + t20 + Scalar(0.0549);
  const Scalar t145 = s_10 * (t144 + Ic_10_yy) - Scalar(2.0) * c_10 * Ic_10_xy;
  const Scalar t146 = s_10 * t145;
  const Scalar t147 = Scalar(-10.0) * t119;
  const Scalar t148 = t144 + t147 - Scalar(0.03800666666667) - t146;
  B[264] = -t148;
  const Scalar t149 = t51 - t54 - Scalar(0.00555);
  const Scalar Ic_4_yy = t8 + t53 + Scalar(0.4098975);
  const Scalar Ic_4_xy = t74 + t18 + Scalar(0.0549);
  const Scalar t150 = s_4 * (t149 + Ic_4_yy) - Scalar(2.0) * c_4 * Ic_4_xy;
  const Scalar t151 = s_4 * t150;
  const Scalar t152 = Scalar(-10.0) * t116;
  const Scalar t153 = t149 + t152 - Scalar(0.03800666666667) - t151;
  B[66] = -t153;
  const Scalar mu_4_2_x = t115 * t76 - c_3 * t117;
  B[3] = B[96] = c_2 * mu_4_2_x - s_2 * Iu_4_a_xy;
  const Scalar mu_10_8_x = t118 * t90 - c_9 * t120;
  B[201] = B[294] = c_8 * mu_10_8_x - s_8 * Iu_10_a_xy;
  const Scalar t154 = s_28 * f_u_32_30_t_y - c_28 * f_u_32_29_t_x;
  const Scalar t155 = s_28 * mu_u_32_29_t_x + Scalar(76.25) * t154 + c_28 * mu_32_28_y;
  const Scalar t156 = s_27 * mu_32_28_z - c_27 * t155;
  B[831] = B[1017] = -t156;
  const Scalar t157 = t102 + s_23 * hu_24_t_x;
  const Scalar t158 = c_23 * t10 + s_23 * Iu_24_t_xy + Scalar(59.75) * t157;
  const Scalar mu_23_22_y = mu_u_23_23_a_y - t157;
  const Scalar t159 = t157 - s_22 * t158 + c_22 * mu_23_22_y;
  B[662] = B[724] = -t159;
  const Scalar f_u_24_21_t_y = s_21 * t101 - c_21 * t132;
  const Scalar mu_24_20_x = c_21 * mu_24_21_y - s_21 * t130 + Scalar(76.25) * f_u_24_21_t_y;
  const Scalar t160 = s_20 * mu_24_21_z - c_20 * mu_24_20_x;
  B[599] = B[754] = -t160;
  const Scalar t161 = s_30 * hu_31_t_x - t64;
  const Scalar t162 = -c_30 * Iu_31_t_yz - s_30 * t124 + Scalar(59.75) * t161;
  const Scalar mu_30_29_y = mu_u_30_30_a_y - t161;
  const Scalar t163 = t161 - s_29 * t162 + c_29 * mu_30_29_y;
  B[893] = B[955] = -t163;
  const Scalar f_u_31_28_t_y = s_28 * t107 - c_28 * t139;
  const Scalar mu_31_27_x = s_28 * t137 + c_28 * mu_31_28_y + Scalar(76.25) * f_u_31_28_t_y;
  const Scalar t164 = s_27 * mu_31_28_z - c_27 * mu_31_27_x;
  B[830] = B[985] = -t164;
  const Scalar t165 = s_27 * f_u_32_28_t_x + c_27 * f_u_32_29_a_z;
  const Scalar t166 = s_26 * t154 + c_26 * t165;
  const Scalar t167 = c_27 * mu_32_28_z + s_27 * t155;
  const Scalar t168 = s_27 * f_u_32_29_a_z - c_27 * f_u_32_28_t_x;
  const Scalar B_15_32 = Scalar(82.5) * t168 + Scalar(60.0) * t166 + s_26 * t167 +
      c_26 * mu_32_27_z;
  B[479] = B[1006] = B_15_32;
  const Scalar t169 = s_30 * (t3 + (t111 + Scalar(0.0235906))) -
      Scalar(0.0014964) * c_30 * s_32 * t42;
  const Scalar t170 = s_30 * t169;
  const Scalar t171 = Scalar(-2.0) * t161;
  const Scalar t172 = Scalar(119.5) * hu_30_a_y;
  const Scalar t173 = t171 + t111 - t170 - t172 - Scalar(0.2062863000000002);
  B[924] = -t173;
  const Scalar t174 = Scalar(0.0014964) * c_23 * s_25 * t33 +
      s_23 * (t4 + (t114 + Scalar(0.0235906)));
  const Scalar t175 = s_23 * t174;
  const Scalar t176 = Scalar(2.0) * t157;
  const Scalar t177 = Scalar(119.5) * hu_23_a_y;
  const Scalar t178 = t114 - t176 - t175 - t177 - Scalar(0.2062863000000002);
  B[693] = -t178;
  const Scalar t179 = Scalar(0.00507) + Scalar(5.0) * hu_10_t_y + Ic_10_xy + c_10 * t145;
  const Scalar t180 = Scalar(0.00032) + t119;
  const Scalar t181 = hu_12_t_x * t90 + c_9 * t180;
  const Scalar t182 = t67 * t90 + c_9 * t179 + Scalar(97.25) * t181;
  B[232] = B[263] = -t182;
  const Scalar t183 = Scalar(0.00507) + Scalar(5.0) * hu_4_t_y + Ic_4_xy + c_4 * t150;
  const Scalar t184 = Scalar(0.00032) + t116;
  const Scalar t185 = hu_6_t_x * t76 + c_3 * t184;
  const Scalar t186 = t69 * t76 + c_3 * t183 + Scalar(97.25) * t185;
  B[34] = B[65] = -t186;
  const Scalar t187 = s_22 * mu_23_22_y + c_22 * t158;
  const Scalar t188 = s_22 * t140;
  const Scalar t189 = t141 - t188;
  const Scalar t190 = s_21 * t140;
  const Scalar t191 = c_22 * t190 - c_21 * t157;
  const Scalar B_20_23 = Scalar(76.25) * t191 + s_21 * t189 - c_21 * t187;
  B[630] = B[723] = B_20_23;
  const Scalar t192 = c_20 * mu_24_21_z + s_20 * mu_24_20_x;
  const Scalar t193 = s_20 * f_u_24_21_t_x + c_20 * f_u_24_22_a_z;
  const Scalar t194 = s_19 * f_u_24_21_t_y + c_19 * t193;
  const Scalar t195 = s_20 * f_u_24_22_a_z - c_20 * f_u_24_21_t_x;
  const Scalar B_15_24 = s_19 * t192 - Scalar(60.0) * t194 + c_19 * mu_24_20_z +
      Scalar(82.5) * t195;
  B[471] = B[750] = B_15_24;
  const Scalar f_u_25_20_t_x = s_20 * t134 + c_20 * f_u_25_22_t_y;
  const Scalar f_u_25_19_t_x = s_19 * t142 + c_19 * f_u_25_20_t_x;
  const Scalar mu_u_25_20_t_x = c_20 * t106 + s_20 * t143;
  const Scalar t196 = s_20 * f_u_25_22_t_y - c_20 * t134;
  const Scalar t197 = Scalar(82.5) * t196 - Scalar(60.0) * f_u_25_19_t_x + s_19 * mu_u_25_20_t_x +
      c_19 * mu_u_25_20_a_y;
  B[472] = B[782] = -t197;
  const Scalar t198 = c_27 * mu_31_28_z + s_27 * mu_31_27_x;
  const Scalar t199 = s_27 * f_u_31_28_t_x + c_27 * f_u_31_29_a_z;
  const Scalar t200 = s_26 * f_u_31_28_t_y + c_26 * t199;
  const Scalar t201 = s_27 * f_u_31_29_a_z - c_27 * f_u_31_28_t_x;
  const Scalar B_15_31 = Scalar(60.0) * t200 + s_26 * t198 + c_26 * mu_31_27_z +
      Scalar(82.5) * t201;
  B[478] = B[974] = B_15_31;
  const Scalar t202 = t140 + t34 - c_23 * t174;
  const Scalar Iu_22_a_xy = s_22 * t202 - c_22 * t141;
  B[661] = B[692] = Iu_22_a_xy;
  const Scalar f_u_25_19_t_y = s_19 * f_u_25_20_t_x - c_19 * t142;
  const Scalar mu_25_15_x = Scalar(60.0) * f_u_25_19_t_y - s_19 * mu_u_25_20_a_y +
      c_19 * mu_u_25_20_t_x;
  const Scalar mu_25_15_y = mu_u_25_20_t_y - Scalar(82.5) * f_u_25_19_t_y;
  B[440] = B[781] = s_15 * mu_25_15_x + c_15 * mu_25_15_y;
  const Scalar t203 = s_29 * mu_30_29_y + c_29 * t162;
  const Scalar t204 = s_29 * hu_30_t_y;
  const Scalar mu_30_28_y = mu_30_29_z - t204;
  const Scalar t205 = s_28 * hu_30_t_y;
  const Scalar t206 = c_29 * t205 + c_28 * t161;
  const Scalar t207 = Scalar(76.25) * t206 + s_28 * mu_30_28_y + c_28 * t203;
  B[861] = B[954] = -t207;
  const Scalar f_u_32_26_a_z = s_26 * t165 - c_26 * t154;
  const Scalar mu_32_15_x = Scalar(60.0) * f_u_32_26_a_z + s_26 * mu_32_27_z - c_26 * t167;
  const Scalar t208 = t156 - Scalar(82.5) * f_u_32_26_a_z;
  B[447] = B[1005] = s_15 * mu_32_15_x - c_15 * t208;
  const Scalar Ic_29_xz = hu_30_t_y + t43 + c_30 * t169;
  const Scalar t209 = s_29 * Ic_29_xz - c_29 * mu_30_29_z;
  B[892] = B[923] = -t209;
  const Scalar Iu_10_t_xx = Ic_10_yy - t146;
  const Scalar t210 = Scalar(0.02175666666667) + t147 + t49;
  const Scalar Iu_9_t_d = Iu_10_t_xx + t210;
  const Scalar t211 = t85 + t118;
  const Scalar t212 = Scalar(2.0) * t211 * t95 + s_9 * Iu_9_t_d;
  const Scalar t213 = s_9 * t212;
  const Scalar t214 = Scalar(194.5) * hu_10_t_y;
  B[231] = Iu_10_t_xx - t213 + t214 + Scalar(1.03820716666667);
  const Scalar Iu_4_t_xx = Ic_4_yy - t151;
  const Scalar t215 = Scalar(0.02175666666667) + t152 + t55;
  const Scalar Iu_3_t_d = Iu_4_t_xx + t215;
  const Scalar t216 = t71 + t115;
  const Scalar t217 = Scalar(2.0) * t216 * t81 + s_3 * Iu_3_t_d;
  const Scalar t218 = s_3 * t217;
  const Scalar t219 = Scalar(194.5) * hu_4_t_y;
  B[33] = Iu_4_t_xx - t218 + t219 + Scalar(1.03820716666667);
  const Scalar t220 = s_3 * t184 - hu_6_t_x * t81;
  const Scalar t221 = c_2 * (s_3 * t183 - t69 * t81 + Scalar(97.25) * t220);
  B[2] = B[64] = s_2 * t153 - t221;
  const Scalar t222 = s_9 * t180 - hu_12_t_x * t95;
  const Scalar t223 = c_8 * (s_9 * t179 - t67 * t95 + Scalar(97.25) * t222);
  B[200] = B[262] = s_8 * t148 - t223;
  const Scalar t224 = c_21 * t140;
  const Scalar t225 = c_22 * t224 + s_21 * t157;
  const Scalar t226 = Scalar(76.25) * t225 + s_21 * t187 + c_21 * t189;
  const Scalar mu_u_23_20_t_y = s_20 * t159 - c_20 * t226;
  B[598] = B[722] = mu_u_23_20_t_y;
  const Scalar t227 = c_28 * hu_30_t_y;
  const Scalar t228 = s_28 * t161 - c_29 * t227;
  const Scalar t229 = Scalar(76.25) * t228 + s_28 * t203 - c_28 * mu_30_28_y;
  const Scalar mu_u_30_27_t_y = s_27 * t163 - c_27 * t229;
  B[829] = B[953] = mu_u_30_27_t_y;
  const Scalar t230 = s_26 * t199 - c_26 * f_u_31_28_t_y;
  const Scalar t231 = Scalar(60.0) * t230 + s_26 * mu_31_27_z - c_26 * t198;
  const Scalar t232 = t164 - Scalar(82.5) * t230;
  B[446] = B[973] = s_15 * t231 - c_15 * t232;
  const Scalar t233 = s_19 * t193 - c_19 * f_u_24_21_t_y;
  const Scalar t234 = Scalar(60.0) * t233 - s_19 * mu_24_20_z + c_19 * t192;
  const Scalar t235 = t160 - Scalar(82.5) * t233;
  B[439] = B[749] = -s_15 * t234 - c_15 * t235;
  B[408] = B[780] = c_14 * (s_15 * mu_25_15_y - c_15 * mu_25_15_x) + s_14 * t197;
  const Scalar Iu_29_t_xz = c_29 * Ic_29_xz + s_29 * mu_30_29_z;
  const Scalar t236 = Scalar(0.0001312) + t161;
  const Scalar hc_29_y = hu_30_a_y + Scalar(0.0034592);
  const Scalar t237 = c_29 * t236 + s_29 * hc_29_y;
  const Scalar t238 = s_29 * t236 - c_29 * hc_29_y;
  const Scalar t239 = t237 + t173 + Scalar(76.25) * t238;
  const Scalar B_27_29 = c_28 * Iu_29_t_xz + s_28 * t239;
  B[860] = B[922] = B_27_29;
  const Scalar Ic_29_xx = t3 - t170 + t172;
  const Scalar t240 = t171 + mu_u_30_30_a_y + Scalar(0.2262745000000002);
  const Scalar Iu_29_t_d = Ic_29_xx + t240;
  const Scalar Ic_29_xy = hu_30_a_y + Scalar(0.0050592) + t162;
  const Scalar t241 = Scalar(2.0) * s_29 * Ic_29_xy - c_29 * Iu_29_t_d;
  const Scalar t242 = c_29 * t241;
  const Scalar t243 = Scalar(-2.0) * t237;
  const Scalar Ic_28_zz = t243 + Ic_29_xx + t242 + Scalar(0.2360429000000002);
  B[891] = Ic_28_zz;
  const Scalar Ic_22_xx = t4 - t175 + t177;
  const Scalar t244 = mu_u_23_23_a_y - t176 + Scalar(0.2262745000000002);
  const Scalar Iu_22_t_d = Ic_22_xx + t244;
  const Scalar Ic_22_xy = hu_23_a_y + Scalar(0.0050592) + t158;
  const Scalar t245 = Scalar(2.0) * s_22 * Ic_22_xy - c_22 * Iu_22_t_d;
  const Scalar t246 = c_22 * t245;
  const Scalar t247 = Scalar(0.0001312) + t157;
  const Scalar hc_22_y = hu_23_a_y + Scalar(0.0034592);
  const Scalar f_u_22_22_a_z = c_22 * t247 + s_22 * hc_22_y;
  const Scalar t248 = Scalar(2.0) * f_u_22_22_a_z;
  const Scalar B_21_21 = Ic_22_xx - t248 + t246 + Scalar(0.2360429000000002);
  B[660] = B_21_21;
  B[199] = B[230] = s_8 * t182 + c_8 * (c_9 * t212 - s_11 * t211);
  B[1] = B[32] = s_2 * t186 + c_2 * (c_3 * t217 - s_5 * t216);
  const Scalar t249 = c_22 * t202 + s_22 * t141;
  const Scalar t250 = s_22 * t247 - c_22 * hc_22_y;
  const Scalar t251 = f_u_22_22_a_z + t178 + Scalar(76.25) * t250;
  const Scalar t252 = c_21 * t249 - s_21 * t251;
  B[629] = B[691] = -t252;
  const Scalar t253 = s_27 * t229 + c_27 * t163;
  const Scalar t254 = s_27 * t206 - c_27 * t204;
  const Scalar t255 = s_26 * t228 + c_26 * t254;
  const Scalar t256 = s_27 * t204 + c_27 * t206;
  const Scalar B_15_30 = Scalar(82.5) * t256 - Scalar(60.0) * t255 - s_26 * t253 - c_26 * t207;
  B[477] = B[942] = B_15_30;
  const Scalar mu_u_32_15_t_x = s_15 * t208 + c_15 * mu_32_15_x;
  B[415] = B[1004] = -c_14 * mu_u_32_15_t_x - s_14 * B_15_32;
  const Scalar mu_u_23_20_t_x = s_20 * t226 + c_20 * t159;
  const Scalar t257 = s_20 * t191 - c_20 * t188;
  const Scalar t258 = s_19 * t225 - c_19 * t257;
  const Scalar t259 = s_20 * t188 + c_20 * t191;
  const Scalar t260 = Scalar(82.5) * t259 - Scalar(60.0) * t258 + s_19 * mu_u_23_20_t_x -
      c_19 * B_20_23;
  B[470] = B[718] = -t260;
  const Scalar mu_u_24_15_t_x = s_15 * t235 - c_15 * t234;
  B[407] = B[748] = -c_14 * mu_u_24_15_t_x - s_14 * B_15_24;
  const Scalar mu_29_27_x = s_28 * Iu_29_t_xz - c_28 * t239;
  const Scalar mu_u_29_27_t_y = s_27 * t209 + c_27 * mu_29_27_x;
  B[828] = B[921] = mu_u_29_27_t_y;
  B[414] = B[972] = -c_14 * (c_15 * t231 + s_15 * t232) - s_14 * B_15_31;
  const Scalar t261 = t250 - Scalar(0.0023) + Ic_22_xy - s_22 * t245;
  const Scalar t262 = Scalar(0.0000128) + f_u_22_22_a_z;
  const Scalar t263 = t190 - c_21 * t262;
  const Scalar B_20_21 = -s_21 * Iu_22_a_xy - c_21 * t261 + Scalar(76.25) * t263;
  B[628] = B[659] = B_20_21;
  const Scalar t264 = s_21 * t249 + c_21 * t251;
  const Scalar t265 = s_20 * Iu_22_a_xy + c_20 * t264;
  B[597] = B[690] = -t265;
  const Scalar t266 = t238 - Scalar(0.0023) + Ic_29_xy - s_29 * t241;
  const Scalar t267 = Scalar(0.0000128) + t237;
  const Scalar t268 = t205 + c_28 * t267;
  const Scalar t269 = c_28 * t266 - s_28 * t209 + Scalar(76.25) * t268;
  B[859] = B[890] = -t269;
  const Scalar t270 = s_20 * t264 - c_20 * Iu_22_a_xy;
  const Scalar t271 = s_21 * t250;
  const Scalar t272 = s_20 * t271 + c_20 * f_u_22_22_a_z;
  const Scalar t273 = c_21 * t250;
  const Scalar t274 = s_19 * t273 - c_19 * t272;
  const Scalar t275 = s_20 * f_u_22_22_a_z - c_20 * t271;
  const Scalar mu_22_15_z = Scalar(60.0) * t274 - s_19 * t270 + Scalar(82.5) * t275 - c_19 * t252;
  B[469] = B[686] = mu_22_15_z;
  const Scalar t276 = s_19 * t257 + c_19 * t225;
  const Scalar t277 = Scalar(60.0) * t276 - s_19 * B_20_23 - c_19 * mu_u_23_20_t_x;
  const Scalar mu_23_15_y = mu_u_23_20_t_y + Scalar(82.5) * t276;
  B[438] = B[717] = c_15 * mu_23_15_y - s_15 * t277;
  const Scalar t278 = s_27 * mu_29_27_x - c_27 * t209;
  const Scalar t279 = s_28 * t238;
  const Scalar t280 = s_27 * t279 + c_27 * t237;
  const Scalar t281 = c_28 * t238;
  const Scalar f_u_29_26_t_x = s_26 * t281 - c_26 * t280;
  const Scalar t282 = s_27 * t237 - c_27 * t279;
  const Scalar mu_29_15_z = s_26 * t278 - Scalar(60.0) * f_u_29_26_t_x + Scalar(82.5) * t282 +
      c_26 * B_27_29;
  B[476] = B[910] = mu_29_15_z;
  const Scalar f_u_30_26_t_y = s_26 * t254 - c_26 * t228;
  const Scalar t283 = Scalar(60.0) * f_u_30_26_t_y + s_26 * t207 - c_26 * t253;
  const Scalar mu_30_15_y = mu_u_30_27_t_y - Scalar(82.5) * f_u_30_26_t_y;
  B[445] = B[941] = c_15 * mu_30_15_y - s_15 * t283;
  const Scalar t284 = t210 - t213 - t214;
  const Scalar t285 = s_8 * (s_8 * (t148 - t284 + Scalar(1.03624716666667)) - Scalar(2.0) * t223);
  B[198] = -t284 - t285 + Scalar(1.04016716666667);
  const Scalar t286 = t215 - t218 - t219;
  const Scalar t287 = s_2 * (s_2 * (t153 - t286 + Scalar(1.03624716666667)) - Scalar(2.0) * t221);
  B[0] = -t286 - t287 + Scalar(1.04016716666667);
  B[406] = B[716] = s_14 * t260 + c_14 * (s_15 * mu_23_15_y + c_15 * t277);
  const Scalar t288 = t224 + s_21 * t262;
  const Scalar t289 = s_21 * t261 - c_21 * Iu_22_a_xy + Scalar(76.25) * t288;
  const Scalar t290 = c_20 * t289;
  const Scalar t291 = t290 + s_20 * B_21_21;
  B[596] = B[658] = -t291;
  const Scalar t292 = s_28 * t267 - t227;
  const Scalar t293 = c_28 * t209 + s_28 * t266 + Scalar(76.25) * t292;
  const Scalar t294 = c_27 * t293;
  const Scalar t295 = t294 + s_27 * Ic_28_zz;
  B[827] = B[889] = -t295;
  const Scalar t296 = s_26 * t280 + c_26 * t281;
  const Scalar t297 = Scalar(60.0) * t296 - c_26 * t278 + s_26 * B_27_29;
  const Scalar mu_29_15_y = mu_u_29_27_t_y + Scalar(82.5) * t296;
  B[444] = B[909] = s_15 * t297 + c_15 * mu_29_15_y;
  B[413] = B[940] = c_14 * (s_15 * mu_30_15_y + c_15 * t283) - s_14 * B_15_30;
  const Scalar t298 = t242 + t240;
  const Scalar t299 = t173 - t243 + Scalar(0.2282085000000002);
  const Scalar t300 = hu_30_t_y - Iu_29_t_xz;
  const Scalar t301 = Scalar(2.0) * c_28 * t300 + s_28 * (t298 - t299);
  const Scalar t302 = s_28 * t301;
  const Scalar t303 = Scalar(-152.5) * t238;
  const Scalar t304 = t298 - t302 - t303 - Scalar(0.7079407000000002);
  B[858] = -t304;
  const Scalar t305 = t246 + t244;
  const Scalar t306 = t248 + t178 + Scalar(0.2282085000000002);
  const Scalar t307 = t140 - t249;
  const Scalar t308 = s_21 * (t305 - t306) - Scalar(2.0) * c_21 * t307;
  const Scalar t309 = s_21 * t308;
  const Scalar t310 = Scalar(-152.5) * t250;
  const Scalar t311 = t305 - t309 - t310 - Scalar(0.7079407000000002);
  B[627] = -t311;
  const Scalar t312 = s_20 * t289 - c_20 * B_21_21;
  const Scalar t313 = c_19 * t263;
  const Scalar f_u_21_19_t_x = s_19 * t288 - s_20 * t313;
  const Scalar mu_21_15_z = Scalar(60.0) * f_u_21_19_t_x + c_19 * B_20_21 -
      Scalar(82.5) * c_20 * t263 - s_19 * t312;
  B[468] = B[654] = mu_21_15_z;
  const Scalar t314 = s_19 * t272 + c_19 * t273;
  const Scalar t315 = Scalar(60.0) * t314 - c_19 * t270 + s_19 * t252;
  const Scalar t316 = t265 - Scalar(82.5) * t314;
  B[437] = B[685] = -s_15 * t315 - c_15 * t316;
  const Scalar Iu_28_a_yz = t300 - c_28 * t301;
  const Scalar Iu_27_t_yz = s_27 * t269 + c_27 * Iu_28_a_yz;
  B[826] = B[857] = Iu_27_t_yz;
  const Scalar t317 = s_27 * t293 - c_27 * Ic_28_zz;
  const Scalar t318 = c_26 * t268;
  const Scalar t319 = s_27 * t318 + s_26 * t292;
  const Scalar t320 = Scalar(60.0) * t319 + c_26 * t269 - Scalar(82.5) * c_27 * t268 + s_26 * t317;
  B[475] = B[878] = -t320;
  const Scalar t321 = t307 + c_21 * t308;
  const Scalar t322 = s_20 * B_20_21 + c_20 * t321;
  B[595] = B[626] = -t322;
  const Scalar mu_u_22_15_t_x = s_15 * t316 - c_15 * t315;
  B[405] = B[684] = -s_14 * mu_22_15_z - c_14 * mu_u_22_15_t_x;
  B[412] = B[908] = c_14 * (s_15 * mu_29_15_y - c_15 * t297) - s_14 * mu_29_15_z;
  const Scalar t323 = s_19 * t263;
  const Scalar t324 = s_20 * t323 + c_19 * t288;
  const Scalar t325 = Scalar(60.0) * t324 - s_19 * B_20_21 - c_19 * t312;
  const Scalar t326 = t291 - Scalar(82.5) * t324;
  B[436] = B[653] = -s_15 * t325 - c_15 * t326;
  const Scalar t327 = s_26 * t268;
  const Scalar f_u_28_26_t_y = s_27 * t327 - c_26 * t292;
  const Scalar t328 = Scalar(60.0) * f_u_28_26_t_y + s_26 * t269 - c_26 * t317;
  const Scalar t329 = Scalar(82.5) * f_u_28_26_t_y + t295;
  B[443] = B[877] = -s_15 * t328 - c_15 * t329;
  const Scalar Iu_20_t_xz = s_20 * t321 - c_20 * B_20_21;
  const Scalar t330 = s_19 * Iu_20_t_xz;
  const Scalar t331 = t250 - Scalar(0.006644);
  const Scalar t332 = c_20 * t288 + s_20 * t331;
  const Scalar t333 = t311 - Scalar(60.0) * t332;
  const Scalar hu_20_t_x = s_20 * t288 - c_20 * t331;
  const Scalar mu_u_20_15_a_y = t330 + Scalar(82.5) * hu_20_t_x + c_19 * t333;
  B[467] = B[622] = -mu_u_20_15_a_y;
  const Scalar Iu_27_a_xz = s_27 * Iu_28_a_yz - c_27 * t269;
  const Scalar t334 = s_26 * Iu_27_a_xz;
  const Scalar t335 = t238 - Scalar(0.006644);
  const Scalar t336 = c_27 * t292 + s_27 * t335;
  const Scalar t337 = Scalar(60.0) * t336 + t304;
  const Scalar hu_27_t_x = s_27 * t292 - c_27 * t335;
  const Scalar mu_u_27_15_a_y = Scalar(82.5) * hu_27_t_x - t334 + c_26 * t337;
  B[474] = B[846] = -mu_u_27_15_a_y;
  B[411] = B[876] = s_14 * t320 - c_14 * (s_15 * t329 - c_15 * t328);
  const Scalar t338 = t302 + t299 - t303;
  const Scalar Ic_27_yy = Ic_28_zz - Scalar(0.7059807000000002);
  const Scalar t339 = Scalar(2.0) * t294 + s_27 * (t338 + Ic_27_yy);
  const Scalar t340 = s_27 * t339;
  const Scalar t341 = t338 - t340 - Scalar(0.7099007000000002);
  B[825] = -t341;
  const Scalar t342 = t309 + t306 - t310;
  const Scalar t343 = B_21_21 - Scalar(0.7059807000000002);
  const Scalar t344 = Scalar(2.0) * t290 + s_20 * (t342 + t343);
  const Scalar t345 = s_20 * t344;
  const Scalar t346 = t342 - t345 - Scalar(0.7099007000000002);
  B[594] = -t346;
  const Scalar t347 = c_19 * Iu_20_t_xz - s_19 * t333;
  const Scalar t348 = t322 + Scalar(82.5) * s_19 * t332;
  B[435] = B[621] = s_15 * t347 - c_15 * t348;
  const Scalar mu_u_21_15_t_x = s_15 * t326 - c_15 * t325;
  B[404] = B[652] = -s_14 * mu_21_15_z - c_14 * mu_u_21_15_t_x;
  const Scalar t349 = t293 - c_27 * t339;
  const Scalar t350 = t318 + s_26 * hu_27_t_x;
  const Scalar B_15_26 = Scalar(60.0) * t350 + c_26 * Iu_27_t_yz + s_26 * t349;
  B[473] = B[814] = B_15_26;
  const Scalar t351 = c_26 * Iu_27_a_xz + s_26 * t337;
  const Scalar mu_27_15_y = Iu_27_t_yz - Scalar(82.5) * s_26 * t336;
  B[442] = B[845] = c_15 * mu_27_15_y - s_15 * t351;
  const Scalar t352 = t289 - c_20 * t344;
  const Scalar hu_19_t_y = s_19 * hu_20_t_x - t313;
  const Scalar t353 = Scalar(60.0) * hu_19_t_y + c_19 * t322 - s_19 * t352;
  B[466] = B[590] = -t353;
  B[403] = B[620] = s_14 * mu_u_20_15_a_y - c_14 * (s_15 * t348 + c_15 * t347);
  B[410] = B[844] = c_14 * (s_15 * mu_27_15_y + c_15 * t351) + s_14 * mu_u_27_15_a_y;
  const Scalar hu_19_t_x = t323 + c_19 * hu_20_t_x;
  const Scalar t354 = Scalar(60.0) * hu_19_t_x - s_19 * t322 - c_19 * t352;
  const Scalar t355 = Scalar(82.5) * hu_19_t_x + t346;
  B[434] = B[589] = s_15 * t354 - c_15 * t355;
  const Scalar t356 = t327 - c_26 * hu_27_t_x;
  const Scalar t357 = Scalar(60.0) * t356 + s_26 * Iu_27_t_yz - c_26 * t349;
  const Scalar t358 = t341 - Scalar(82.5) * t356;
  B[441] = B[813] = s_15 * t357 - c_15 * t358;
  const Scalar t359 = t343 - t345;
  const Scalar t360 = t311 + Scalar(0.7079407000000002);
  const Scalar t361 = Scalar(2.0) * t330 + c_19 * (t359 + t360);
  const Scalar Iu_27_t_xx = Ic_27_yy - t340;
  const Scalar t362 = t304 + Scalar(0.7079407000000002);
  const Scalar Iu_26_t_d = Iu_27_t_xx + t362;
  const Scalar t363 = Scalar(2.0) * t334 - c_26 * Iu_26_t_d;
  const Scalar t364 = c_19 * t361 - c_26 * t363;
  const Scalar t365 = Scalar(226.5) * t56 + Scalar(165.0) * (t356 - hu_19_t_x);
  const Scalar t366 = Scalar(-120.0) * (t336 - t332);
  const Scalar Iu_17_t_xx = Scalar(0.0002) + t16;
  const Scalar Iu_16_t_d = t11 + Iu_17_t_xx;
  const Scalar Iu_16_t_g = Scalar(2.0) * t59 + c_16 * Iu_16_t_d;
  const Scalar t367 = c_16 * Iu_16_t_g;
  const Scalar Ic_15_zz = t16 - t367 + Iu_27_t_xx + t359 + t366 + t365 - t364 +
      Scalar(5.513020899999668);
  B[462] = Ic_15_zz;
  const Scalar mu_u_19_15_t_x = c_15 * t354 + s_15 * t355;
  B[402] = B[588] = s_14 * t353 - c_14 * mu_u_19_15_t_x;
  B[409] = B[812] = -s_14 * B_15_26 - c_14 * (c_15 * t357 + s_15 * t358);
  const Scalar t368 = c_17 * t121 - t99 - Scalar(0.043998) + Iu_27_a_xz - Iu_20_t_xz +
      Scalar(82.5) * (t350 + hu_19_t_y) + s_19 * t361 - s_26 * t363;
  const Scalar t369 = Scalar(0.75) * t127 - s_16 * Iu_16_t_g + s_17 * Iu_18_a_yz - t353 + B_15_26;
  const Scalar Iu_15_a_xy = s_15 * t368 - c_15 * t369;
  B[430] = B[461] = -Iu_15_a_xy;
  const Scalar t370 = c_14 * (s_15 * t369 + c_15 * t368);
  B[398] = B[460] = t370 - s_14 * Ic_15_zz;
  const Scalar t371 = Scalar(1.5) * hu_16_a_z;
  const Scalar t372 = t371 - Ic_16_zz - t366 + t362 + t360 - t364;
  const Scalar t373 = t371 + t11 - t367 - t365 - Scalar(0.5912714333326666) + t341 + t346;
  const Scalar t374 = -t128 - t354 - t357 + Scalar(82.5) * (t336 + t332);
  const Scalar t375 = Scalar(2.0) * s_15 * t374 - c_15 * (t372 - t373);
  const Scalar t376 = c_15 * t375;
  B[429] = Scalar(2.5075600666670006) - t376 - t372;
  B[397] = B[428] = s_14 * Iu_15_a_xy + c_14 * (t374 - s_15 * t375);
  const Scalar t377 = t373 - t376;
  const Scalar t378 = s_14 * (s_14 * (t377 - Scalar(2.5051100666670005) + Ic_15_zz) -
      Scalar(2.0) * t370);
  B[396] = t378 - t377 + Scalar(2.5107600666670002);
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
  static_assert(detail::Interface::checked<Scalar>());
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
// Reads q[0..11], q[13..31], qd[0..31]. Operations: 998 mul, 796 add, 62 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
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
  const Scalar t22 = t5 * omega_r_17_a_z;
  const Scalar t23 = omega_r_15_y * omega_15_z;
  const Scalar t24 = (t2 + Scalar(2.0) * t3) * t4;
  const Scalar domega_15_x = t23 + t24;
  const Scalar U_16_xy = domega_15_x + t22;
  const Scalar t25 = s_17 * U_16_xy + c_17 * t21;
  const Scalar t26 = Scalar(2.0) * omega_17_z;
  const Scalar t27 = t25 - t11 * t26;
  const Scalar t28 = s_18 * I_t18_g;
  const Scalar t29 = t28 - Scalar(0.02904);
  const Scalar Uz_o_15_y = t1 * t1 + qd_14 * qd_14;
  const Scalar t30 = Scalar(2452.5) * s_14;
  const Scalar t31 = Scalar(0.75) * Uz_o_15_y - Scalar(113.25) * t17 - t30;
  const Scalar t32 = Scalar(2452.5) * c_14 * s_15;
  const Scalar ddp_o_16_y = Scalar(0.75) * t24 - Scalar(113.25) * t20 + t32;
  const Scalar t33 = s_16 * t31 - c_16 * ddp_o_16_y;
  const Scalar t34 = t8 * t8;
  const Scalar t35 = omega_15_z * omega_15_z;
  const Scalar t36 = t35 - t34;
  const Scalar Uz_o_16_x = Uz_o_15_y + t36;
  const Scalar t37 = c_14 * c_15;
  const Scalar t38 = Scalar(2452.5) * t37;
  const Scalar t39 = Scalar(0.75) * t15 + Scalar(113.25) * Uz_o_16_x - t38;
  const Scalar t40 = Scalar(0.00008) * c_18 + Scalar(0.00088) * s_18;
  const Scalar t41 = t40 * (s_17 * t33 - c_17 * t39);
  const Scalar I_18_xx = Scalar(0.00504) + t28;
  const Scalar t42 = s_16 * ddp_o_16_y + c_16 * t31;
  const Scalar t43 = Scalar(0.00088) * c_18 - Scalar(0.00008) * s_18;
  const Scalar n_18 = t13 * (t10 - t12) - t25 * I_18_xx + t27 * t29 - t41 + t43 * t42;
  n[17] = n_18;
  const Scalar U_17_zy = c_17 * U_16_xy + omega_r_17_y * t26 - s_17 * t21;
  const Scalar t44 = U_17_zy - t26 * omega_18_z;
  const Scalar t45 = s_17 * t39 + c_17 * t33;
  const Scalar t46 = t5 * omega_16_z;
  const Scalar domega_16_y = t46 - c_16 * t20 + s_16 * t17;
  const Scalar t47 = t11 * omega_r_17_y;
  const Scalar U_17_xy = domega_16_y - t47;
  const Scalar t48 = U_17_xy + Scalar(2.0) * t11 * omega_18_z;
  const Scalar mu_u_17_a_y = Scalar(0.00025) * (t47 + domega_16_y) + Scalar(0.00509) * U_17_xy -
      t44 * t13 - t48 * t29 - t43 * t45;
  n[16] = -mu_u_17_a_y;
  const Scalar t49 = c_2 * qd_1;
  const Scalar t50 = s_3 * t49;
  const Scalar t51 = c_3 * qd_2;
  const Scalar omega_r_3_x = t50 + t51;
  const Scalar t52 = omega_r_3_x * omega_r_3_x;
  const Scalar t53 = s_2 * qd_1;
  const Scalar omega_3_z = qd_3 - t53;
  const Scalar t54 = omega_3_z * omega_3_z;
  const Scalar t55 = t54 - t52;
  const Scalar t56 = t49 * t49 + qd_2 * qd_2;
  const Scalar t57 = t49 * t53;
  const Scalar t58 = Scalar(2452.5) * c_1;
  const Scalar ddp_o_3_x = Scalar(97.25) * t57 + s_2 * t58;
  const Scalar t59 = qd_2 * t53;
  const Scalar ddp_3_a_y = Scalar(2452.5) * s_1 - Scalar(194.5) * t59;
  const Scalar t60 = s_3 * ddp_o_3_x - c_3 * ddp_3_a_y;
  const Scalar ddp_o_4_x = Scalar(5.0) * (t56 + t55) + t60;
  const Scalar t61 = omega_r_3_x * omega_3_z;
  const Scalar t62 = t61 + t53 * (t50 + Scalar(2.0) * t51);
  const Scalar U_3_zx = t61 + t62;
  const Scalar t63 = Scalar(97.25) * t56 - Scalar(5.0) * U_3_zx + c_2 * t58;
  const Scalar t64 = s_4 * ddp_o_4_x + c_4 * t63;
  const Scalar t65 = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar t66 = t65 * t65;
  const Scalar t67 = c_3 * t49;
  const Scalar t68 = s_3 * qd_2;
  const Scalar t69 = t68 - t67;
  const Scalar omega_4_z = qd_4 - t69;
  const Scalar t70 = omega_4_z * omega_4_z;
  const Scalar t71 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar t72 = t65 * t71;
  const Scalar U_4_xy = t62 - t72;
  const Scalar t73 = Scalar(10.0) * U_4_xy + t64 + Scalar(89.25) * (t52 + t54 + t70 - t66);
  const Scalar t74 = t65 * omega_4_z;
  const Scalar t75 = omega_r_3_x * t69;
  const Scalar t76 = qd_2 * t49;
  const Scalar t77 = t75 - t76;
  const Scalar t78 = (Scalar(2.0) * t68 - t67) * t53;
  const Scalar t79 = t78 + Scalar(2.0) * t69 * omega_3_z;
  const Scalar t80 = s_4 * t77 + t74 + c_4 * t79;
  const Scalar t81 = t74 + t80;
  const Scalar t82 = s_4 * t79 - c_4 * t77 + Scalar(2.0) * t71 * omega_4_z;
  const Scalar t83 = t75 + t76;
  const Scalar ddp_3_y = c_3 * ddp_o_3_x + s_3 * ddp_3_a_y;
  const Scalar ddp_o_4_y = Scalar(5.0) * t83 + ddp_3_y;
  const Scalar t84 = Scalar(10.0) * t82 - ddp_o_4_y + Scalar(89.25) * t81;
  const Scalar t85 = s_5 * t84 + c_5 * t73;
  const Scalar t86 = Scalar(0.00018) * c_6 - Scalar(0.00042) * s_6;
  const Scalar omega_r_5_y = s_5 * t65 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t87 = omega_6_z * omega_6_z;
  const Scalar omega_5_z = qd_5 - t71;
  const Scalar t88 = t87 + omega_5_z * omega_5_z;
  const Scalar t89 = s_5 * omega_4_z - c_5 * t65;
  const Scalar t90 = t89 * t89 + t87;
  const Scalar t91 = Scalar(0.0063) * c_6 - Scalar(0.0012) * s_6;
  const Scalar I_6_xy = c_6 * t91 - Scalar(0.00315);
  const Scalar t92 = c_5 * U_4_xy + s_5 * t82;
  const Scalar t93 = Scalar(2.0) * omega_5_z;
  const Scalar t94 = t92 + t89 * t93;
  const Scalar t95 = s_6 * t91;
  const Scalar I_6_yy = t95 + Scalar(0.007758333333335);
  const Scalar t96 = s_4 * t63 - c_4 * ddp_o_4_x;
  const Scalar t97 = t62 + t72;
  const Scalar Uz_o_5_y = t70 + t66;
  const Scalar ddp_5_a_z = Scalar(89.25) * t97 - Scalar(10.0) * Uz_o_5_y - t96;
  const Scalar mr_6_x = Scalar(0.00018) * s_6 + Scalar(0.00042) * c_6;
  const Scalar t98 = t95 - Scalar(0.006558333333335);
  const Scalar t99 = I_6_xy * (t88 - t90) - t92 * t98 + t94 * I_6_yy + t86 * t85 +
      mr_6_x * ddp_5_a_z;
  n[5] = -t99;
  const Scalar t100 = c_8 * qd_7;
  const Scalar t101 = s_9 * t100;
  const Scalar t102 = c_9 * qd_8;
  const Scalar omega_r_9_x = t101 + t102;
  const Scalar t103 = omega_r_9_x * omega_r_9_x;
  const Scalar t104 = s_8 * qd_7;
  const Scalar omega_9_z = qd_9 - t104;
  const Scalar t105 = omega_9_z * omega_9_z;
  const Scalar t106 = t105 - t103;
  const Scalar t107 = t100 * t100 + qd_8 * qd_8;
  const Scalar t108 = t100 * t104;
  const Scalar t109 = Scalar(2452.5) * c_7;
  const Scalar ddp_o_9_x = Scalar(97.25) * t108 + s_8 * t109;
  const Scalar t110 = qd_8 * t104;
  const Scalar ddp_9_a_y = Scalar(2452.5) * s_7 - Scalar(194.5) * t110;
  const Scalar t111 = s_9 * ddp_o_9_x - c_9 * ddp_9_a_y;
  const Scalar ddp_o_10_x = Scalar(5.0) * (t107 + t106) + t111;
  const Scalar t112 = omega_r_9_x * omega_9_z;
  const Scalar t113 = t112 + t104 * (t101 + Scalar(2.0) * t102);
  const Scalar U_9_zx = t112 + t113;
  const Scalar t114 = Scalar(97.25) * t107 - Scalar(5.0) * U_9_zx + c_8 * t109;
  const Scalar t115 = s_10 * ddp_o_10_x + c_10 * t114;
  const Scalar t116 = s_10 * omega_r_9_x + c_10 * omega_9_z;
  const Scalar t117 = t116 * t116;
  const Scalar t118 = c_9 * t100;
  const Scalar t119 = s_9 * qd_8;
  const Scalar t120 = t119 - t118;
  const Scalar omega_10_z = qd_10 - t120;
  const Scalar t121 = omega_10_z * omega_10_z;
  const Scalar t122 = s_10 * omega_9_z - c_10 * omega_r_9_x;
  const Scalar t123 = t116 * t122;
  const Scalar U_10_xy = t113 - t123;
  const Scalar t124 = Scalar(10.0) * U_10_xy + t115 + Scalar(89.25) * (t103 + t105 + t121 - t117);
  const Scalar t125 = t116 * omega_10_z;
  const Scalar t126 = omega_r_9_x * t120;
  const Scalar t127 = qd_8 * t100;
  const Scalar t128 = t126 - t127;
  const Scalar t129 = (Scalar(2.0) * t119 - t118) * t104;
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
  const Scalar t143 = c_11 * U_10_xy + s_11 * t133;
  const Scalar t144 = Scalar(2.0) * omega_11_z;
  const Scalar t145 = t143 + t140 * t144;
  const Scalar t146 = s_12 * t142;
  const Scalar I_12_yy = t146 + Scalar(0.007758333333335);
  const Scalar t147 = s_10 * t114 - c_10 * ddp_o_10_x;
  const Scalar t148 = t113 + t123;
  const Scalar Uz_o_11_y = t121 + t117;
  const Scalar ddp_11_a_z = Scalar(89.25) * t148 - Scalar(10.0) * Uz_o_11_y - t147;
  const Scalar mr_12_x = Scalar(0.00018) * s_12 + Scalar(0.00042) * c_12;
  const Scalar t149 = t146 - Scalar(0.006558333333335);
  const Scalar t150 = I_12_xy * (t139 - t141) - t143 * t149 + t145 * I_12_yy + t137 * t136 +
      mr_12_x * ddp_11_a_z;
  n[11] = -t150;
  const Scalar t151 = s_11 * t124 - c_11 * t135;
  const Scalar U_11_zy = omega_r_11_y * t144 - s_11 * U_10_xy + c_11 * t133;
  const Scalar t152 = U_11_zy - t144 * omega_12_z;
  const Scalar t153 = t140 * omega_r_11_y;
  const Scalar t154 = t153 + t131;
  const Scalar t155 = t154 - Scalar(2.0) * t140 * omega_12_z;
  const Scalar t156 = Scalar(0.00032) * (t131 - t153) + Scalar(0.001328333333335) * t154 +
      t152 * I_12_xy + t155 * I_12_yy - mr_12_x * t151;
  n[10] = -t156;
  const Scalar t157 = s_5 * t73 - c_5 * t84;
  const Scalar U_5_zy = omega_r_5_y * t93 - s_5 * U_4_xy + c_5 * t82;
  const Scalar t158 = U_5_zy - t93 * omega_6_z;
  const Scalar t159 = t89 * omega_r_5_y;
  const Scalar t160 = t159 + t80;
  const Scalar t161 = t160 - Scalar(2.0) * t89 * omega_6_z;
  const Scalar t162 = Scalar(0.00032) * (t80 - t159) + Scalar(0.001328333333335) * t160 +
      t158 * I_6_xy + t161 * I_6_yy - mr_6_x * t157;
  n[4] = -t162;
  const Scalar t163 = Scalar(0.00025) * t27 - n_18;
  const Scalar mu_17_x = Scalar(0.00509) * U_17_zy - t48 * t13 + t44 * I_18_xx + t40 * t45;
  const Scalar mu_u_16_x = Scalar(0.0003125) * (domega_15_x - t22) + Scalar(0.0005625) * U_16_xy +
      s_17 * t163 + c_17 * mu_17_x;
  n[15] = -mu_u_16_x;
  const Scalar t164 = Scalar(0.00032) * t145 + t150;
  const Scalar t165 = -mr_12_x * t155 - t137 * t152 + Scalar(0.0000615126050420168) * t151;
  const Scalar t166 = t137 * t143 + mr_12_x * t139 + Scalar(0.0000615126050420168) * t136;
  const Scalar t167 = s_11 * t165 + c_11 * t166;
  const Scalar mu_11_x = Scalar(0.001328333333335) * U_11_zy + t155 * I_12_xy - t152 * t149 -
      t137 * t151;
  const Scalar f_11_z = mr_12_x * t145 - t137 * t141 + Scalar(0.0000615126050420168) * ddp_11_a_z;
  const Scalar t168 = Scalar(0.008593739495798319) * U_10_xy +
      Scalar(0.0002648739495798319) * t115 - s_11 * mu_11_x + c_11 * t164 - Scalar(0.06566) * t148 +
      Scalar(10.0) * t167 + Scalar(89.25) * f_11_z;
  n[9] = -t168;
  const Scalar t169 = Scalar(0.00032) * t94 + t99;
  const Scalar t170 = -mr_6_x * t161 - t86 * t158 + Scalar(0.0000615126050420168) * t157;
  const Scalar t171 = t86 * t92 + mr_6_x * t88 + Scalar(0.0000615126050420168) * t85;
  const Scalar t172 = s_5 * t170 + c_5 * t171;
  const Scalar mu_5_x = Scalar(0.001328333333335) * U_5_zy + t161 * I_6_xy - t158 * t98 -
      t86 * t157;
  const Scalar f_5_z = mr_6_x * t94 - t86 * t90 + Scalar(0.0000615126050420168) * ddp_5_a_z;
  const Scalar t173 = Scalar(0.008593739495798319) * U_4_xy + Scalar(0.0002648739495798319) * t64 -
      s_5 * mu_5_x + c_5 * t169 - Scalar(0.06566) * t97 + Scalar(10.0) * t172 +
      Scalar(89.25) * f_5_z;
  n[3] = -t173;
  const Scalar t174 = s_11 * t166 - c_11 * t165;
  const Scalar t175 = Scalar(0.008593739495798319) * t133 -
      Scalar(0.0002648739495798319) * ddp_o_10_y + s_11 * t164 + c_11 * mu_11_x +
      Scalar(10.0) * t174;
  const Scalar t176 = Scalar(0.06566) * t132 - t156 - Scalar(89.25) * t174;
  const Scalar t177 = Scalar(0.0002648739495798319) * t133 -
      Scalar(2.4873949579831934e-06) * ddp_o_10_y + t174;
  const Scalar n_9 = Scalar(0.00605) * t128 - Scalar(0.006525) * t134 + Scalar(0.00507) * t129 +
      Scalar(5.0) * t177 - c_10 * t175 - s_10 * t176;
  n[8] = n_9;
  const Scalar t178 = s_5 * t171 - c_5 * t170;
  const Scalar t179 = Scalar(0.008593739495798319) * t82 -
      Scalar(0.0002648739495798319) * ddp_o_4_y + s_5 * t169 + c_5 * mu_5_x + Scalar(10.0) * t178;
  const Scalar t180 = Scalar(0.06566) * t81 - t162 - Scalar(89.25) * t178;
  const Scalar t181 = Scalar(0.0002648739495798319) * t82 -
      Scalar(2.4873949579831934e-06) * ddp_o_4_y + t178;
  const Scalar n_3 = Scalar(0.00605) * t77 - Scalar(0.006525) * t83 + Scalar(0.00507) * t78 +
      Scalar(5.0) * t181 - c_4 * t179 - s_4 * t180;
  n[2] = n_3;
  const Scalar t182 = Scalar(0.0002648739495798319) * U_10_xy +
      Scalar(2.4873949579831934e-06) * t115 + t167;
  const Scalar f_10_y = Scalar(0.0002648739495798319) * Uz_o_11_y +
      Scalar(2.4873949579831934e-06) * t147 - f_11_z;
  const Scalar t183 = Scalar(0.000051146529562982) * t111 + s_10 * t182 - c_10 * f_10_y;
  const Scalar f_9_y = Scalar(0.000051146529562982) * ddp_9_y - t177;
  const Scalar f_u_9_t_x = s_9 * t183 + c_9 * f_9_y;
  const Scalar f_u_10_a_z = s_10 * f_10_y + c_10 * t182;
  const Scalar t184 = Scalar(0.00507) * t106 + Scalar(0.006525) * U_9_zx -
      Scalar(5.0) * f_u_10_a_z + t168;
  const Scalar mu_9_x = Scalar(0.00507) * t134 - Scalar(0.00605) * t130 - s_10 * t175 + c_10 * t176;
  n[7] = c_9 * mu_9_x - Scalar(0.08264) * t108 + s_9 * t184 + Scalar(97.25) * f_u_9_t_x;
  const Scalar t185 = Scalar(0.0002648739495798319) * U_4_xy +
      Scalar(2.4873949579831934e-06) * t64 + t172;
  const Scalar f_4_y = Scalar(0.0002648739495798319) * Uz_o_5_y +
      Scalar(2.4873949579831934e-06) * t96 - f_5_z;
  const Scalar t186 = Scalar(0.000051146529562982) * t60 + s_4 * t185 - c_4 * f_4_y;
  const Scalar f_3_y = Scalar(0.000051146529562982) * ddp_3_y - t181;
  const Scalar f_u_3_t_x = s_3 * t186 + c_3 * f_3_y;
  const Scalar f_u_4_a_z = s_4 * f_4_y + c_4 * t185;
  const Scalar t187 = Scalar(0.00507) * t55 + Scalar(0.006525) * U_3_zx - Scalar(5.0) * f_u_4_a_z +
      t173;
  const Scalar mu_3_x = Scalar(0.00507) * t83 - Scalar(0.00605) * t79 - s_4 * t179 + c_4 * t180;
  n[1] = c_3 * mu_3_x - Scalar(0.08264) * t57 + s_3 * t187 + Scalar(97.25) * f_u_3_t_x;
  const Scalar f_u_9_t_y = s_9 * f_9_y - c_9 * t183;
  const Scalar mu_8_x = Scalar(0.16332) * t110 + s_9 * mu_9_x - c_9 * t184 +
      Scalar(97.25) * f_u_9_t_y;
  n[6] = s_8 * (Scalar(0.00196) * t127 - n_9) + c_8 * mu_8_x;
  const Scalar f_u_3_t_y = s_3 * f_3_y - c_3 * t186;
  const Scalar mu_2_x = Scalar(0.16332) * t59 + s_3 * mu_3_x - c_3 * t187 +
      Scalar(97.25) * f_u_3_t_y;
  n[0] = s_2 * (Scalar(0.00196) * t76 - n_3) + c_2 * mu_2_x;
  const Scalar t188 = Scalar(82.5) * t17 + t30;
  const Scalar U_15_zy = t23 + domega_15_x;
  const Scalar t189 = Scalar(60.0) * U_15_zy;
  const Scalar t190 = t188 - t189;
  const Scalar t191 = Scalar(82.5) * Uz_o_16_x - t38;
  const Scalar U_15_xy = t18 + t19;
  const Scalar t192 = Scalar(60.0) * U_15_xy;
  const Scalar t193 = t192 + t191;
  const Scalar t194 = s_26 * t190 + c_26 * t193;
  const Scalar t195 = s_26 * omega_15_z - c_26 * t8;
  const Scalar omega_26_z = qd_26 + omega_r_15_y;
  const Scalar t196 = t195 * omega_26_z;
  const Scalar domega_26_y = c_26 * U_15_xy + t196 - s_26 * U_15_zy;
  const Scalar omega_r_27_x = s_27 * t195 + c_27 * omega_26_z;
  const Scalar t197 = s_27 * omega_26_z - c_27 * t195;
  const Scalar t198 = omega_r_27_x * t197;
  const Scalar U_27_xy = domega_26_y - t198;
  const Scalar t199 = Scalar(82.5) * t20 - t32;
  const Scalar t200 = t34 + t35;
  const Scalar t201 = Scalar(60.0) * t200;
  const Scalar t202 = t201 + t199;
  const Scalar t203 = Scalar(76.25) * U_27_xy + s_27 * t194 + c_27 * t202;
  const Scalar t204 = s_26 * t193 - c_26 * t190;
  const Scalar omega_r_27_a_z = s_26 * t8 + c_26 * omega_15_z;
  const Scalar t205 = -s_26 * U_15_xy - c_26 * U_15_zy + Scalar(2.0) * omega_r_27_a_z * omega_26_z;
  const Scalar omega_27_z = qd_27 + omega_r_27_a_z;
  const Scalar t206 = t195 * omega_r_27_a_z;
  const Scalar t207 = t16 + t206;
  const Scalar t208 = c_27 * t207 + Scalar(2.0) * t197 * omega_27_z - s_27 * t205;
  const Scalar t209 = t204 + Scalar(76.25) * t208;
  const Scalar t210 = s_28 * t203 - c_28 * t209;
  const Scalar omega_r_28_x = s_28 * omega_r_27_x + c_28 * omega_27_z;
  const Scalar t211 = omega_r_28_x * omega_r_28_x;
  const Scalar omega_28_z = qd_28 - t197;
  const Scalar t212 = omega_28_z * omega_28_z;
  const Scalar t213 = t212 - t211;
  const Scalar t214 = omega_r_27_x * omega_r_27_x + omega_27_z * omega_27_z;
  const Scalar t215 = t214 + t213 + t210;
  const Scalar t216 = omega_r_28_x * omega_28_z;
  const Scalar t217 = t216 - s_28 * U_27_xy + c_28 * t208;
  const Scalar U_28_zx = t216 + t217;
  const Scalar ddp_o_28_y = Scalar(76.25) * t214 + s_27 * t202 - c_27 * t194;
  const Scalar ddp_o_29_z = U_28_zx + ddp_o_28_y;
  const Scalar t218 = s_29 * ddp_o_29_z + c_29 * t215;
  const Scalar t219 = s_29 * omega_28_z - c_29 * omega_r_28_x;
  const Scalar t220 = t219 * t219;
  const Scalar t221 = s_28 * omega_27_z - c_28 * omega_r_27_x;
  const Scalar omega_29_z = qd_29 - t221;
  const Scalar t222 = omega_29_z * omega_29_z;
  const Scalar t223 = t211 + t212 + t222 - t220;
  const Scalar omega_r_30_a_z = s_29 * omega_r_28_x + c_29 * omega_28_z;
  const Scalar t224 = t219 * omega_r_30_a_z;
  const Scalar t225 = t224 + t217;
  const Scalar ddp_o_30_x = t223 + Scalar(59.75) * t225 - t218;
  const Scalar Uz_28_y = c_28 * U_27_xy + s_28 * t208;
  const Scalar t226 = Uz_28_y + Scalar(2.0) * t221 * omega_28_z;
  const Scalar t227 = t219 * omega_29_z;
  const Scalar t228 = omega_r_27_x * omega_27_z;
  const Scalar t229 = t228 - s_27 * t207 - c_27 * t205;
  const Scalar t230 = omega_r_28_x * t221;
  const Scalar t231 = t229 - t230;
  const Scalar t232 = t227 + c_29 * t231 + s_29 * t226;
  const Scalar t233 = t227 + t232;
  const Scalar Uz_o_30_z = Scalar(2.0) * omega_r_30_a_z * omega_29_z - s_29 * t231 + c_29 * t226;
  const Scalar t234 = c_28 * t203 + s_28 * t209;
  const Scalar t235 = t230 + t229;
  const Scalar t236 = t235 + t234;
  const Scalar t237 = t233 - Scalar(59.75) * Uz_o_30_z - t236;
  const Scalar t238 = s_30 * ddp_o_30_x - c_30 * t237;
  const Scalar t239 = s_29 * t215 - c_29 * ddp_o_29_z;
  const Scalar t240 = t217 - t224;
  const Scalar Uz_o_30_y = t222 + t220;
  const Scalar t241 = t240 - Scalar(59.75) * Uz_o_30_y + t239;
  const Scalar ddp_31_y = s_31 * t238 - c_31 * t241;
  const Scalar omega_r_31_a_z = s_30 * omega_29_z - c_30 * t219;
  const Scalar omega_30_z = qd_30 + omega_r_30_a_z;
  const Scalar t242 = c_30 * t225 + Scalar(2.0) * omega_r_31_a_z * omega_30_z - s_30 * Uz_o_30_z;
  const Scalar omega_r_30_x = s_30 * t219 + c_30 * omega_29_z;
  const Scalar t243 = omega_r_30_x * omega_r_31_a_z;
  const Scalar t244 = t232 - t243;
  const Scalar t245 = s_31 * omega_r_30_x - c_31 * omega_30_z;
  const Scalar omega_31_z = qd_31 + omega_r_31_a_z;
  const Scalar t246 = Scalar(2.0) * omega_31_z;
  const Scalar t247 = t245 * t246 + s_31 * t244 + c_31 * t242;
  const Scalar omega_32_z = qd_32 - t245;
  const Scalar t248 = t246 * omega_32_z + t247;
  const Scalar t249 = Scalar(13.553191489361701) * s_32;
  const Scalar t250 = omega_32_z * omega_32_z;
  const Scalar t251 = omega_31_z * omega_31_z;
  const Scalar t252 = t251 + t250;
  const Scalar omega_r_31_x = s_31 * omega_30_z + c_31 * omega_r_30_x;
  const Scalar t253 = omega_r_31_x * omega_r_31_x;
  const Scalar t254 = t251 + t253;
  const Scalar t255 = Scalar(0.0000376) * c_32;
  const Scalar t256 = t255 * (Scalar(19.898936170212767) * (t254 - t252) - t248 * t249 + ddp_31_y);
  const Scalar t257 = s_31 * t241 + c_31 * t238;
  const Scalar t258 = omega_r_30_x * omega_30_z;
  const Scalar t259 = t258 - s_30 * t225 - c_30 * Uz_o_30_z;
  const Scalar t260 = omega_r_31_x * t245;
  const Scalar t261 = t260 + t259;
  const Scalar t262 = t261 + Scalar(2.0) * omega_r_31_x * omega_32_z;
  const Scalar t263 = Scalar(0.0005096) * s_32 * s_32;
  const Scalar I_32_yy = t263 + Scalar(0.0004516500000001);
  const Scalar t264 = s_31 * t242 - c_31 * t244;
  const Scalar t265 = Scalar(0.0007482) * s_32;
  const Scalar n_31 = Scalar(0.00016) * (t259 - t260) + t264 * t265 + t262 * I_32_yy - t256 +
      Scalar(0.0247118500000001) * t261 - Scalar(0.0007608) * t257;
  n[30] = n_31;
  const Scalar ddp_19_a_y = t189 + t188;
  const Scalar t266 = t191 - t192;
  const Scalar t267 = s_19 * ddp_19_a_y + c_19 * t266;
  const Scalar t268 = s_19 * omega_15_z - c_19 * t8;
  const Scalar omega_19_z = qd_19 + omega_r_15_y;
  const Scalar t269 = t268 * omega_19_z;
  const Scalar domega_19_y = c_19 * U_15_xy + t269 - s_19 * U_15_zy;
  const Scalar omega_r_20_x = s_20 * t268 + c_20 * omega_19_z;
  const Scalar t270 = s_20 * omega_19_z - c_20 * t268;
  const Scalar t271 = omega_r_20_x * t270;
  const Scalar U_20_xy = domega_19_y - t271;
  const Scalar t272 = t199 - t201;
  const Scalar t273 = Scalar(76.25) * U_20_xy + s_20 * t267 + c_20 * t272;
  const Scalar t274 = s_19 * t266 - c_19 * ddp_19_a_y;
  const Scalar omega_r_20_a_z = s_19 * t8 + c_19 * omega_15_z;
  const Scalar t275 = -s_19 * U_15_xy - c_19 * U_15_zy + Scalar(2.0) * omega_r_20_a_z * omega_19_z;
  const Scalar omega_20_z = qd_20 + omega_r_20_a_z;
  const Scalar t276 = t268 * omega_r_20_a_z;
  const Scalar t277 = t16 + t276;
  const Scalar t278 = c_20 * t277 + Scalar(2.0) * t270 * omega_20_z - s_20 * t275;
  const Scalar t279 = t274 + Scalar(76.25) * t278;
  const Scalar t280 = s_21 * t273 - c_21 * t279;
  const Scalar omega_r_21_x = s_21 * omega_r_20_x + c_21 * omega_20_z;
  const Scalar t281 = omega_r_21_x * omega_r_21_x;
  const Scalar omega_21_z = qd_21 - t270;
  const Scalar t282 = omega_21_z * omega_21_z;
  const Scalar t283 = t282 - t281;
  const Scalar t284 = omega_r_20_x * omega_r_20_x + omega_20_z * omega_20_z;
  const Scalar t285 = t284 + t283 + t280;
  const Scalar t286 = omega_r_21_x * omega_21_z;
  const Scalar t287 = t286 - s_21 * U_20_xy + c_21 * t278;
  const Scalar U_21_zx = t286 + t287;
  const Scalar ddp_o_21_y = Scalar(76.25) * t284 + s_20 * t272 - c_20 * t267;
  const Scalar ddp_o_22_z = U_21_zx + ddp_o_21_y;
  const Scalar t288 = s_22 * ddp_o_22_z + c_22 * t285;
  const Scalar t289 = s_22 * omega_21_z - c_22 * omega_r_21_x;
  const Scalar t290 = t289 * t289;
  const Scalar t291 = s_21 * omega_20_z - c_21 * omega_r_20_x;
  const Scalar omega_22_z = qd_22 - t291;
  const Scalar t292 = omega_22_z * omega_22_z;
  const Scalar t293 = t281 + t282 + t292 - t290;
  const Scalar omega_r_23_a_z = s_22 * omega_r_21_x + c_22 * omega_21_z;
  const Scalar t294 = t289 * omega_r_23_a_z;
  const Scalar t295 = t294 + t287;
  const Scalar ddp_o_23_x = t293 + Scalar(59.75) * t295 - t288;
  const Scalar Uz_21_y = c_21 * U_20_xy + s_21 * t278;
  const Scalar t296 = Uz_21_y + Scalar(2.0) * t291 * omega_21_z;
  const Scalar t297 = t289 * omega_22_z;
  const Scalar t298 = omega_r_20_x * omega_20_z;
  const Scalar t299 = t298 - s_20 * t277 - c_20 * t275;
  const Scalar t300 = omega_r_21_x * t291;
  const Scalar t301 = t299 - t300;
  const Scalar t302 = t297 + c_22 * t301 + s_22 * t296;
  const Scalar t303 = t297 + t302;
  const Scalar Uz_o_23_z = Scalar(2.0) * omega_r_23_a_z * omega_22_z - s_22 * t301 + c_22 * t296;
  const Scalar t304 = c_21 * t273 + s_21 * t279;
  const Scalar t305 = t300 + t299;
  const Scalar t306 = t305 + t304;
  const Scalar t307 = t303 - Scalar(59.75) * Uz_o_23_z - t306;
  const Scalar t308 = s_23 * ddp_o_23_x - c_23 * t307;
  const Scalar t309 = s_22 * t285 - c_22 * ddp_o_22_z;
  const Scalar t310 = t287 - t294;
  const Scalar Uz_o_23_y = t292 + t290;
  const Scalar t311 = t310 - Scalar(59.75) * Uz_o_23_y + t309;
  const Scalar ddp_24_y = s_24 * t308 - c_24 * t311;
  const Scalar omega_r_24_a_z = s_23 * omega_22_z - c_23 * t289;
  const Scalar omega_23_z = qd_23 + omega_r_23_a_z;
  const Scalar t312 = c_23 * t295 + Scalar(2.0) * omega_r_24_a_z * omega_23_z - s_23 * Uz_o_23_z;
  const Scalar omega_r_23_x = s_23 * t289 + c_23 * omega_22_z;
  const Scalar t313 = omega_r_23_x * omega_r_24_a_z;
  const Scalar t314 = t302 - t313;
  const Scalar t315 = s_24 * omega_r_23_x - c_24 * omega_23_z;
  const Scalar omega_24_z = qd_24 + omega_r_24_a_z;
  const Scalar t316 = Scalar(2.0) * omega_24_z;
  const Scalar t317 = t315 * t316 + s_24 * t314 + c_24 * t312;
  const Scalar omega_25_z = qd_25 - t315;
  const Scalar t318 = t316 * omega_25_z + t317;
  const Scalar t319 = Scalar(13.553191489361701) * s_25;
  const Scalar t320 = omega_25_z * omega_25_z;
  const Scalar t321 = omega_24_z * omega_24_z;
  const Scalar t322 = t321 + t320;
  const Scalar omega_r_24_x = s_24 * omega_23_z + c_24 * omega_r_23_x;
  const Scalar t323 = omega_r_24_x * omega_r_24_x;
  const Scalar t324 = t321 + t323;
  const Scalar t325 = Scalar(0.0000376) * c_25;
  const Scalar t326 = t325 * (t318 * t319 + Scalar(19.898936170212767) * (t324 - t322) + ddp_24_y);
  const Scalar t327 = s_24 * t311 + c_24 * t308;
  const Scalar t328 = omega_r_23_x * omega_23_z;
  const Scalar t329 = t328 - s_23 * t295 - c_23 * Uz_o_23_z;
  const Scalar t330 = omega_r_24_x * t315;
  const Scalar t331 = t330 + t329;
  const Scalar t332 = t331 + Scalar(2.0) * omega_r_24_x * omega_25_z;
  const Scalar t333 = Scalar(0.0005096) * s_25 * s_25;
  const Scalar I_25_yy = t333 + Scalar(0.0004516500000001);
  const Scalar t334 = s_24 * t312 - c_24 * t314;
  const Scalar t335 = Scalar(0.0007482) * s_25;
  const Scalar n_24 = Scalar(0.00016) * (t329 - t330) - t334 * t335 + t332 * I_25_yy + t326 +
      Scalar(0.0247118500000001) * t331 - Scalar(0.0007608) * t327;
  n[23] = n_24;
  const Scalar t336 = (t331 - Scalar(0.05025394279604384) * t327) * t335;
  const Scalar ddp_24_a_z = s_23 * t307 + c_23 * ddp_o_23_x;
  const Scalar t337 = t323 + t320;
  const Scalar t338 = ((t322 - t337) * t319 + Scalar(19.898936170212767) * t317 + ddp_24_a_z) *
      t325;
  const Scalar t339 = t334 - omega_r_24_x * t316;
  const Scalar t340 = t333 - Scalar(0.0009612500000001);
  const Scalar t341 = t334 * t340 - t339 * I_25_yy + t336 + t338;
  n[24] = -t341;
  const Scalar t342 = (t261 - Scalar(0.05025394279604384) * t257) * t265;
  const Scalar ddp_31_a_z = s_30 * t237 + c_30 * ddp_o_30_x;
  const Scalar t343 = t253 + t250;
  const Scalar t344 = (Scalar(19.898936170212767) * t247 - (t252 - t343) * t249 + ddp_31_a_z) *
      t255;
  const Scalar t345 = t264 - omega_r_31_x * t246;
  const Scalar t346 = t263 - Scalar(0.0009612500000001);
  const Scalar t347 = t264 * t346 - t345 * I_32_yy - t342 - t344;
  n[31] = -t347;
  const Scalar t348 = Scalar(0.00016) * t345 - t347;
  const Scalar t349 = c_32 * t262;
  const Scalar U_32_yy_zz = t254 - t343;
  const Scalar t350 = s_32 * (Scalar(13.553191489361701) * t349 +
      Scalar(19.898936170212767) * U_32_yy_zz + ddp_31_y);
  const Scalar t351 = c_32 * t345;
  const Scalar t352 = Scalar(0.0007482) * t351 - t248 * t346 + Scalar(0.0000376) * t350 +
      Scalar(0.0247118500000001) * t247 + Scalar(0.0007608) * ddp_31_a_z;
  const Scalar t353 = Scalar(0.00048) * t244 + Scalar(0.00032) * (t243 + t232) - c_31 * t348 +
      s_31 * t352;
  n[29] = -t353;
  const Scalar t354 = Scalar(0.00016) * t339 - t341;
  const Scalar t355 = c_25 * t332;
  const Scalar U_25_yy_zz = t324 - t337;
  const Scalar t356 = s_25 * (Scalar(19.898936170212767) * U_25_yy_zz -
      Scalar(13.553191489361701) * t355 + ddp_24_y);
  const Scalar t357 = c_25 * t339;
  const Scalar t358 = Scalar(-0.0007482) * t357 - t318 * t340 - Scalar(0.0000376) * t356 +
      Scalar(0.0247118500000001) * t317 + Scalar(0.0007608) * ddp_24_a_z;
  const Scalar t359 = Scalar(0.00048) * t314 + Scalar(0.00032) * (t313 + t302) - c_24 * t354 +
      s_24 * t358;
  n[22] = -t359;
  const Scalar t360 = Scalar(0.00048) * t242 + s_31 * t348 + c_31 * t352;
  const Scalar f_31_y = Scalar(0.0000376) * (s_32 * t248 - t349) + Scalar(0.0007608) * t254;
  const Scalar t361 = Scalar(0.0000376) * (c_32 * t252 + s_32 * t264) + Scalar(0.0007608) * t261;
  const Scalar t362 = s_31 * f_31_y - c_31 * t361 + Scalar(0.0001312) * t238;
  const Scalar t363 = Scalar(0.0000376) * (t351 - s_32 * t343) + Scalar(0.0007608) * t247 +
      Scalar(0.0001312) * ddp_31_a_z;
  const Scalar f_u_30_t_x = s_30 * t362 + c_30 * t363;
  const Scalar U_30_zx = t258 + t259;
  const Scalar t364 = Scalar(0.00032) * U_30_zx + n_31;
  const Scalar t365 = -c_31 * f_31_y - s_31 * t361 + Scalar(0.0001312) * t241;
  const Scalar n_29 = Scalar(0.00278) * (t223 - Uz_o_30_y) - Scalar(0.00167) * t240 - t365 -
      c_30 * t360 + s_30 * t364 + Scalar(0.26596) * t225 - Scalar(0.00438) * t218 -
      Scalar(59.75) * f_u_30_t_x;
  n[28] = n_29;
  const Scalar t366 = Scalar(0.00048) * t312 + s_24 * t354 + c_24 * t358;
  const Scalar f_24_y = Scalar(0.0007608) * t324 - Scalar(0.0000376) * (s_25 * t318 - t355);
  const Scalar t367 = Scalar(0.0007608) * t331 - Scalar(0.0000376) * (c_25 * t322 + s_25 * t334);
  const Scalar t368 = s_24 * f_24_y - c_24 * t367 + Scalar(0.0001312) * t308;
  const Scalar t369 = Scalar(0.0007608) * t317 - Scalar(0.0000376) * (t357 - s_25 * t337) +
      Scalar(0.0001312) * ddp_24_a_z;
  const Scalar f_u_23_t_x = s_23 * t368 + c_23 * t369;
  const Scalar U_23_zx = t328 + t329;
  const Scalar t370 = Scalar(0.00032) * U_23_zx + n_24;
  const Scalar t371 = -c_24 * f_24_y - s_24 * t367 + Scalar(0.0001312) * t311;
  const Scalar n_22 = Scalar(0.00278) * (t293 - Uz_o_23_y) - Scalar(0.00167) * t310 - t371 -
      c_23 * t366 + s_23 * t370 + Scalar(0.26596) * t295 - Scalar(0.00438) * t288 -
      Scalar(59.75) * f_u_23_t_x;
  n[21] = n_22;
  const Scalar t372 = s_30 * t363 - c_30 * t362;
  const Scalar t373 = Scalar(0.00278) * t233 - s_30 * t360 - c_30 * t364 -
      Scalar(0.26596) * Uz_o_30_z - Scalar(0.00438) * t236 - Scalar(59.75) * t372;
  const Scalar t374 = Scalar(0.00167) * t233 + Scalar(0.00278) * Uz_o_30_z + t372 + t353;
  const Scalar f_29_z = Scalar(0.00438) * Uz_o_30_z + Scalar(0.000144) * t236 + t372;
  const Scalar t375 = Scalar(0.0023) * Uz_28_y + Scalar(0.00393) * t235 + Scalar(0.00405) * t231 -
      f_29_z + c_29 * t374 - s_29 * t373;
  n[27] = -t375;
  const Scalar t376 = s_23 * t369 - c_23 * t368;
  const Scalar t377 = Scalar(0.00278) * t303 - s_23 * t366 - c_23 * t370 -
      Scalar(0.26596) * Uz_o_23_z - Scalar(0.00438) * t306 - Scalar(59.75) * t376;
  const Scalar t378 = Scalar(0.00167) * t303 + Scalar(0.00278) * Uz_o_23_z + t376 + t359;
  const Scalar f_22_z = Scalar(0.00438) * Uz_o_23_z + Scalar(0.000144) * t306 + t376;
  const Scalar t379 = Scalar(0.0023) * Uz_21_y + Scalar(0.00393) * t305 + Scalar(0.00405) * t301 -
      f_22_z + c_22 * t378 - s_22 * t377;
  n[20] = -t379;
  const Scalar t380 = Scalar(0.0023) * t235 + Scalar(0.00405) * t226 + s_29 * t374 + c_29 * t373;
  const Scalar t381 = Scalar(0.00438) * t225 - Scalar(0.000144) * t218 - f_u_30_t_x;
  const Scalar f_29_y = Scalar(0.00438) * Uz_o_30_y - Scalar(0.000144) * t239 + t365;
  const Scalar t382 = Scalar(0.0000999344262295082) * t210 + s_29 * f_29_y + c_29 * t381;
  const Scalar t383 = Scalar(0.0000999344262295082) * t234 - f_29_z;
  const Scalar t384 = s_28 * t382 + c_28 * t383;
  const Scalar t385 = s_29 * t381 - c_29 * f_29_y;
  const Scalar t386 = Scalar(0.0023) * t213 - Scalar(0.00393) * U_28_zx - t385 + n_29;
  const Scalar mu_27_z = Scalar(0.03177) * U_27_xy - Scalar(0.00098) * (t198 + domega_26_y) -
      s_28 * t386 - c_28 * t380 - Scalar(76.25) * t384;
  n[26] = mu_27_z;
  const Scalar t387 = Scalar(0.0023) * t305 + Scalar(0.00405) * t296 + s_22 * t378 + c_22 * t377;
  const Scalar t388 = Scalar(0.00438) * t295 - Scalar(0.000144) * t288 - f_u_23_t_x;
  const Scalar f_22_y = Scalar(0.00438) * Uz_o_23_y - Scalar(0.000144) * t309 + t371;
  const Scalar t389 = Scalar(0.0000999344262295082) * t280 + s_22 * f_22_y + c_22 * t388;
  const Scalar t390 = Scalar(0.0000999344262295082) * t304 - f_22_z;
  const Scalar t391 = s_21 * t389 + c_21 * t390;
  const Scalar t392 = s_22 * t388 - c_22 * f_22_y;
  const Scalar t393 = Scalar(0.0023) * t283 - Scalar(0.00393) * U_21_zx - t392 + n_22;
  const Scalar mu_20_z = Scalar(0.03177) * U_20_xy - Scalar(0.00098) * (t271 + domega_19_y) -
      s_21 * t393 - c_21 * t387 - Scalar(76.25) * t391;
  n[19] = mu_20_z;
  const Scalar t394 = s_28 * t383 - c_28 * t382;
  const Scalar t395 = Scalar(0.03177) * t208 - s_28 * t380 + c_28 * t386 - Scalar(76.25) * t394;
  const Scalar U_27_zx = t228 + t229;
  const Scalar t396 = Scalar(0.00098) * U_27_zx + t375;
  const Scalar t397 = Scalar(0.00098) * (t16 - t206) + Scalar(0.00196) * t207 - s_27 * t396 -
      c_27 * t395;
  n[25] = -t397;
  const Scalar t398 = s_21 * t390 - c_21 * t389;
  const Scalar t399 = Scalar(0.03177) * t278 - s_21 * t387 + c_21 * t393 - Scalar(76.25) * t398;
  const Scalar U_20_zx = t298 + t299;
  const Scalar t400 = Scalar(0.00098) * U_20_zx + t379;
  const Scalar t401 = Scalar(0.00098) * (t16 - t276) + Scalar(0.00196) * t277 - s_20 * t400 -
      c_20 * t399;
  n[18] = -t401;
  const Scalar t402 = Scalar(0.00196) * t275 - c_20 * t400 + s_20 * t399;
  const Scalar t403 = Scalar(0.00196) * t205 - c_27 * t396 + s_27 * t395;
  const Scalar f_28_z = Scalar(0.0000999344262295082) * ddp_o_28_y + t385;
  const Scalar t404 = Scalar(0.00016042921013412816) * t194 - c_27 * f_28_z + s_27 * t384;
  const Scalar f_21_z = Scalar(0.0000999344262295082) * ddp_o_21_y + t392;
  const Scalar t405 = Scalar(0.000044065573770491804) * t267 - c_20 * f_21_z + s_20 * t391;
  const Scalar t406 = Scalar(0.00016042921013412816) * t204 + t394;
  const Scalar t407 = Scalar(0.000044065573770491804) * t274 + t398;
  const Scalar t408 = s_26 * t406 + c_26 * t404 - s_19 * t407 - c_19 * t405;
  const Scalar mu_19_y = Scalar(0.00098) * (t269 + domega_19_y) - mu_20_z;
  const Scalar mu_26_y = Scalar(0.00098) * (t196 + domega_26_y) - mu_27_z;
  const Scalar t409 = Scalar(0.000044065573770491804) * t272 +
      Scalar(0.00016042921013412816) * t202 + s_27 * f_28_z + s_20 * f_21_z + c_27 * t384 +
      c_20 * t391;
  const Scalar t410 = t40 * t44 - t43 * t48;
  const Scalar t411 = t40 * t25 - t43 * t10;
  const Scalar t412 = s_17 * t411 + c_17 * t410 + Scalar(0.00004711699779249448) * t33;
  const Scalar t413 = -t40 * t12 - t43 * t27 + Scalar(0.00004711699779249448) * t42;
  const Scalar f_u_16_t_x = s_16 * t413 - c_16 * t412;
  const Scalar t414 = Scalar(0.0005625) * t21 - s_17 * mu_17_x + c_17 * t163;
  const Scalar t415 = Scalar(0.0003125) * (t46 + domega_16_y) + mu_u_17_a_y;
  const Scalar mu_15_z = Scalar(0.048) * t24 - Scalar(0.164908333333833) * t20 + s_16 * t414 -
      c_16 * t415 + Scalar(0.3206157575755909) * U_15_xy - Scalar(17.12290909090909) * t37 +
      Scalar(0.576) * (Uz_o_16_x - t200) - Scalar(113.25) * f_u_16_t_x + s_19 * t402 -
      c_19 * mu_19_y + s_26 * t403 - c_26 * mu_26_y - Scalar(60.0) * t408 + Scalar(82.5) * t409;
  n[14] = mu_15_z;
  const Scalar t416 = s_26 * t404 - c_26 * t406;
  const Scalar f_u_19_t_y = s_19 * t405 - c_19 * t407;
  const Scalar t417 = Scalar(0.75) * f_u_16_t_x + Scalar(0.048) * t20 + mu_u_16_x -
      Scalar(0.3206157575755909) * U_15_zy + Scalar(0.006981818181818182) * t188 - s_19 * mu_19_y -
      c_19 * t402 - s_26 * mu_26_y - c_26 * t403 - Scalar(60.0) * (t416 - f_u_19_t_y);
  const Scalar t418 = s_16 * t412 + c_16 * t413;
  const Scalar t419 = s_17 * t410 - c_17 * t411 + Scalar(0.00004711699779249448) * t39;
  const Scalar t420 = Scalar(0.048) * t36 - Scalar(0.75) * t419 - s_16 * t415 - c_16 * t414 +
      Scalar(0.164908333333833) * t17 - Scalar(0.576) * U_15_zy + Scalar(113.25) * t418 - t397 -
      t401 - Scalar(82.5) * (t416 + f_u_19_t_y);
  const Scalar t421 = c_14 * (qd_13 * t4 - Scalar(44.243457270943935));
  n[13] = Scalar(0.04430883002224172) * t421 + s_15 * t417 + c_15 * t420;
  const Scalar t422 = c_14 * (Scalar(0.09106766004448344) * qd_14 * t4 - s_15 * t420 + c_15 * t417);
  const Scalar mu_14_y = Scalar(0.00245) * t19 - mu_15_z;
  n[12] = s_14 * mu_14_y - t422;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[32]    in   joint positions, rad or m
//   qd[32]   in   joint velocities, rad/s or m/s
//   tau[32]  in   joint torques or forces, N m or N
//   qdd[32]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[0..11], q[13..31], qd[0..31], tau[0..31]. Operations: 2854 mul, 2241 add, 27 div, 62
// sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
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
  const Scalar t3 = c_3 * qd_2;
  const Scalar omega_r_3_x = t2 + t3;
  const Scalar t4 = s_2 * qd_1;
  const Scalar omega_3_z = qd_3 - t4;
  const Scalar t5 = omega_r_3_x * omega_3_z;
  const Scalar t6 = t4 * (t2 + Scalar(2.0) * t3);
  const Scalar t7 = t5 + t6;
  const Scalar U_3_zx = t5 + t7;
  const Scalar t8 = t1 * t1 + qd_2 * qd_2;
  const Scalar t9 = Scalar(2452.5) * c_1;
  const Scalar t10 = Scalar(97.25) * t8 - Scalar(5.0) * U_3_zx + c_2 * t9;
  const Scalar t11 = omega_r_3_x * omega_r_3_x;
  const Scalar t12 = omega_3_z * omega_3_z;
  const Scalar t13 = t11 - t12;
  const Scalar t14 = qd_2 * t4;
  const Scalar ddp_3_a_y = Scalar(2452.5) * s_1 - Scalar(194.5) * t14;
  const Scalar t15 = t1 * t4;
  const Scalar ddp_o_3_x = Scalar(97.25) * t15 + s_2 * t9;
  const Scalar t16 = c_3 * ddp_3_a_y - s_3 * ddp_o_3_x;
  const Scalar ddp_o_4_x = Scalar(5.0) * (t8 - t13) - t16;
  const Scalar t17 = c_4 * t10 + s_4 * ddp_o_4_x;
  const Scalar t18 = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar t19 = t18 * t18;
  const Scalar t20 = c_3 * t1;
  const Scalar t21 = s_3 * qd_2;
  const Scalar t22 = t20 - t21;
  const Scalar omega_4_z = qd_4 + t22;
  const Scalar t23 = omega_4_z * omega_4_z;
  const Scalar t24 = c_4 * omega_r_3_x - s_4 * omega_3_z;
  const Scalar t25 = t18 * t24;
  const Scalar U_4_xy = t7 + t25;
  const Scalar t26 = Scalar(10.0) * U_4_xy + t17 + Scalar(89.25) * (t11 + t12 - t19 + t23);
  const Scalar t27 = t22 * omega_3_z;
  const Scalar t28 = (t20 - Scalar(2.0) * t21) * t4;
  const Scalar t29 = t28 + Scalar(2.0) * t27;
  const Scalar t30 = omega_r_3_x * t22;
  const Scalar t31 = qd_2 * t1;
  const Scalar t32 = t31 + t30;
  const Scalar t33 = t18 * omega_4_z;
  const Scalar t34 = s_4 * t32 + c_4 * t29 - t33;
  const Scalar t35 = t24 * omega_4_z;
  const Scalar t36 = c_4 * t32 - s_4 * t29 - Scalar(2.0) * t35;
  const Scalar t37 = t31 - t30;
  const Scalar ddp_3_y = c_3 * ddp_o_3_x + s_3 * ddp_3_a_y;
  const Scalar ddp_o_4_y = Scalar(5.0) * t37 + ddp_3_y;
  const Scalar t38 = Scalar(10.0) * t36 - ddp_o_4_y + Scalar(89.25) * (t33 - t34);
  const Scalar t39 = c_5 * t26 + s_5 * t38;
  const Scalar t40 = c_4 * ddp_o_4_x - s_4 * t10;
  const Scalar Uz_o_5_y = t19 + t23;
  const Scalar ddp_5_a_z = Scalar(89.25) * (t7 - t25) - Scalar(10.0) * Uz_o_5_y + t40;
  const Scalar t41 = c_6 * ddp_5_a_z - s_6 * t39;
  const Scalar t42 = c_6 * t39 + s_6 * ddp_5_a_z;
  const Scalar t43 = c_5 * t18 - s_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 + t24;
  const Scalar omega_r_6_x = c_6 * omega_5_z - s_6 * t43;
  const Scalar t44 = omega_r_6_x * omega_r_6_x;
  const Scalar omega_r_5_y = c_5 * omega_4_z + s_5 * t18;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t45 = omega_6_z * omega_6_z;
  const Scalar t46 = t43 * t43 - t44 + omega_5_z * omega_5_z + t45;
  const Scalar t47 = t44 + t45;
  const Scalar t48 = c_6 * t43 + s_6 * omega_5_z;
  const Scalar t49 = omega_r_6_x * t48;
  const Scalar t50 = t43 * omega_5_z;
  const Scalar t51 = c_5 * U_4_xy - t50 + s_5 * t36;
  const Scalar t52 = Scalar(-0.0012) * t49 - Scalar(0.00315) * (t46 - t47) +
      Scalar(0.01431666666667) * t51 + Scalar(0.00018) * t42 + Scalar(0.00042) * t41;
  const Scalar t53 = Scalar(0.00940666666667) * t50 + Scalar(0.00876666666667) * t51 - t52;
  const Scalar t54 = Scalar(0.00018) * (t49 + t51) + Scalar(0.00042) * t47;
  const Scalar U_6_xy = t51 - t49;
  const Scalar t55 = Scalar(0.00018) * t46 - Scalar(0.00042) * U_6_xy;
  const Scalar t56 = c_6 * t54 + s_6 * t55 + Scalar(0.0000615126050420168) * t39;
  const Scalar t57 = c_5 * t38 - s_5 * t26;
  const Scalar t58 = omega_r_5_y * omega_5_z;
  const Scalar U_5_zy = c_5 * t36 - s_5 * U_4_xy + Scalar(2.0) * t58;
  const Scalar t59 = t43 * omega_r_5_y;
  const Scalar t60 = t59 + t34;
  const Scalar t61 = omega_r_6_x * omega_6_z;
  const Scalar t62 = c_6 * U_5_zy - s_6 * t60 - t61;
  const Scalar U_6_zx = t61 - t62;
  const Scalar t63 = t48 * omega_6_z;
  const Scalar t64 = c_6 * t60 + s_6 * U_5_zy - Scalar(2.0) * t63;
  const Scalar t65 = Scalar(-0.00018) * U_6_zx - Scalar(0.00042) * t64 +
      Scalar(0.0000615126050420168) * t57;
  const Scalar t66 = c_5 * t65 + s_5 * t56;
  const Scalar t67 = Scalar(-0.0012) * t62 - Scalar(0.00315) * t64 + Scalar(0.00018) * t57 -
      Scalar(0.01431666666667) * t61;
  const Scalar t68 = Scalar(0.01551666666667) * t63 - Scalar(0.00315) * U_6_zx +
      Scalar(0.00042) * t57;
  const Scalar mu_5_x = Scalar(0.01817333333334) * t58 + c_6 * t67 - s_6 * t68;
  const Scalar t69 = Scalar(0.03536081232493664) * t35 + Scalar(0.0002648739495798319) * ddp_o_4_y -
      c_5 * mu_5_x + s_5 * t53 - Scalar(10.0) * t66;
  const Scalar t70 = Scalar(0.00876666666667) * t59 + Scalar(0.00940666666667) * t34 - s_6 * t67 -
      c_6 * t68;
  const Scalar t71 = Scalar(0.047979593837531684) * t33 + t70 - Scalar(0.08334040616246832) * t34 -
      Scalar(89.25) * t66;
  const Scalar t72 = Scalar(0.0002648739495798319) * t36 -
      Scalar(2.4873949579831934e-06) * ddp_o_4_y + t66;
  const Scalar t73 = Scalar(0.00507) * t28 + Scalar(0.01720540616246832) * t30 +
      Scalar(0.03025540616246832) * t31 - Scalar(5.0) * t72 - c_4 * t69 + s_4 * t71;
  const Scalar t74 = c_5 * t56 - s_5 * t65;
  const Scalar f_5_z = s_6 * t54 - c_6 * t55 + Scalar(0.0000615126050420168) * ddp_5_a_z;
  const Scalar mu_4_z = Scalar(0.047979593837531684) * t7 - Scalar(0.0002648739495798319) * t17 -
      Scalar(0.08334040616246832) * t25 + c_5 * t53 + s_5 * mu_5_x - Scalar(10.0) * t74 -
      Scalar(89.25) * f_5_z;
  const Scalar y_6 = t52 + tau_6;
  const Scalar hu_6_a_z = Scalar(0.00018) * c_6 - Scalar(0.00042) * s_6;
  const Scalar t75 = Scalar(10.0) * hu_6_a_z + Scalar(0.01431666666667);
  const Scalar hu_6_t_x = Scalar(0.00018) * s_6 + Scalar(0.00042) * c_6;
  const Scalar t76 = Scalar(89.25) * hu_6_t_x;
  const Scalar mu_6_4_z = c_5 * t75 + t76;
  const Scalar t77 = Scalar(69.84866123397676) * mu_6_4_z;
  const Scalar t78 = t70 - tau_5;
  const Scalar t79 = Scalar(0.0063) * c_6 - Scalar(0.0012) * s_6;
  const Scalar t80 = s_6 * t79;
  const Scalar Ic_5_zz = t80 + Scalar(0.00940666666667);
  const Scalar d_5 = Scalar(1.0) / Ic_5_zz;
  const Scalar t81 = Scalar(10.0) * hu_6_t_x + c_6 * t79 - Scalar(0.00315);
  const Scalar t82 = t81 * d_5;
  const Scalar t83 = s_5 * t82;
  const Scalar t84 = t83 * t78 + mu_4_z - tau_4 + t77 * y_6;
  const Scalar t85 = c_4 * t81;
  const Scalar t86 = Scalar(5.0) * hu_6_t_x;
  const Scalar t87 = c_5 * hu_6_t_x;
  const Scalar t88 = Ic_5_zz + Scalar(89.25) * t87;
  const Scalar t89 = s_4 * t88 - c_5 * (t85 - t86);
  const Scalar t90 = Scalar(89.25) * hu_6_a_z;
  const Scalar t91 = c_4 * t75 - t90 * (Scalar(0.056022408963585436) + s_4);
  const Scalar t92 = c_5 * (t80 + Scalar(0.00675));
  const Scalar t93 = t92 + t76;
  const Scalar t94 = s_4 * t81 + c_4 * t93;
  const Scalar t95 = s_5 * (t94 - (t89 * t82 + t91 * t77));
  const Scalar t96 = s_5 * t81;
  const Scalar t97 = c_5 * t92;
  const Scalar t98 = Scalar(178.5) * t87;
  const Scalar t99 = Scalar(20.0) * hu_6_a_z;
  const Scalar t100 = t80 - t97 - t99 - t98 - Scalar(0.44695416666667);
  const Scalar t101 = t83 * t96 + mu_6_4_z * t77 + t100;
  const Scalar t102 = Scalar(1.0) / t101;
  const Scalar t103 = t102 * t95;
  const Scalar t104 = s_5 * t91;
  const Scalar t105 = Scalar(-69.84866123397676) * t104;
  const Scalar t106 = t89 * d_5;
  const Scalar t107 = t73 - t103 * t84 + tau_3 + t105 * y_6 - t106 * t78;
  const Scalar t108 = c_5 * t81;
  const Scalar mu_u_5_4_t_x = s_4 * t108 + c_4 * t88;
  const Scalar t109 = t81 - c_4 * t86;
  const Scalar t110 = s_3 * s_5;
  const Scalar t111 = Scalar(97.25) * hu_6_t_x;
  const Scalar t112 = (c_3 * c_5 + s_4 * t110) * t111;
  const Scalar mu_5_2_z = t110 * t109 + c_3 * mu_u_5_4_t_x + t112;
  const Scalar t113 = t85 - s_4 * t93;
  const Scalar t114 = s_5 * (c_3 * t113 - mu_5_2_z * t82);
  const Scalar t115 = c_5 * hu_6_a_z;
  const Scalar t116 = s_4 * t115 + c_4 * hu_6_t_x;
  const Scalar t117 = c_3 * s_5;
  const Scalar t118 = hu_6_a_z * t117 - s_3 * t116;
  const Scalar mu_6_3_y = mu_6_4_z - Scalar(5.0) * (c_4 * t115 - s_4 * hu_6_t_x);
  const Scalar t119 = s_4 * t75 + c_4 * t90;
  const Scalar t120 = t117 * t119 + Scalar(97.25) * t118 - s_3 * mu_6_3_y;
  const Scalar hc_4_x = t87 + Scalar(0.00549);
  const Scalar f_4_4_x = hu_6_a_z + Scalar(0.00088);
  const Scalar t121 = c_4 * f_4_4_x - s_4 * hc_4_x;
  const Scalar hu_4_t_y = s_4 * f_4_4_x + c_4 * hc_4_x;
  const Scalar t122 = Scalar(5.0) * t121 + t100 - Scalar(97.25) * hu_4_t_y;
  const Scalar t123 = t114 + t120 * t77 - s_3 * t122;
  const Scalar t124 = t123 * t102;
  const Scalar t125 = t97 - t99 - Scalar(0.01170126050420168);
  const Scalar Ic_4_yy = t80 + t98 + Scalar(0.4160487605042017);
  const Scalar Ic_4_xy = t108 + t90 + Scalar(0.0549);
  const Scalar t126 = Scalar(2.0) * c_4 * Ic_4_xy - s_4 * (t125 + Ic_4_yy);
  const Scalar t127 = Scalar(0.00507) + Scalar(5.0) * hu_4_t_y + Ic_4_xy - c_4 * t126;
  const Scalar t128 = t121 - Scalar(0.00032);
  const Scalar t129 = c_3 * t128 - hu_6_t_x * t110;
  const Scalar t130 = -t94 * t110 - c_3 * t127 + Scalar(97.25) * t129;
  const Scalar t131 = Scalar(-69.84866123397676) * t120;
  const Scalar t132 = t104 * t131 + mu_5_2_z * t106 - t95 * t124 + t130;
  const Scalar t133 = s_4 * t126;
  const Scalar t134 = Scalar(-10.0) * t121;
  const Scalar t135 = t125 - t134 - Scalar(0.03185540616246832) + t133;
  const Scalar t136 = t89 * t106 - t95 * t103 - t104 * t105 + t135;
  const Scalar t137 = Scalar(1.0) / t136;
  const Scalar t138 = t132 * t137;
  const Scalar t139 = Scalar(0.0002648739495798319) * U_4_xy +
      Scalar(2.4873949579831934e-06) * t17 + t74;
  const Scalar f_4_y = Scalar(0.0002648739495798319) * Uz_o_5_y -
      Scalar(2.4873949579831934e-06) * t40 - f_5_z;
  const Scalar t140 = Scalar(0.000051146529562982) * t16 + c_4 * f_4_y - s_4 * t139;
  const Scalar f_3_y = Scalar(0.000051146529562982) * ddp_3_y - t72;
  const Scalar f_u_3_t_x = c_3 * f_3_y - s_3 * t140;
  const Scalar mu_3_x = Scalar(0.00507) * t37 + Scalar(0.04746081232493664) * t27 + s_4 * t69 +
      c_4 * t71;
  const Scalar f_u_4_a_z = c_4 * t139 + s_4 * f_4_y;
  const Scalar t141 = Scalar(0.01305) * t5 - Scalar(0.00507) * t13 -
      Scalar(0.01720540616246832) * t6 - Scalar(5.0) * f_u_4_a_z - mu_4_z;
  const Scalar t142 = mu_5_2_z * d_5;
  const Scalar y_3_2 = Scalar(0.05890959383753168) * t15 - c_3 * mu_3_x + tau_2 - s_3 * t141 -
      Scalar(97.25) * f_u_3_t_x + t131 * y_6 + t142 * t78 + t124 * t84 + t138 * t107;
  const Scalar t143 = (s_4 * t117 - s_3 * c_5) * t111;
  const Scalar t144 = c_2 * (t117 * t109 - s_3 * mu_u_5_4_t_x + t143) - s_2 * t89;
  const Scalar t145 = c_2 * (t113 * t110 + c_3 * t122);
  const Scalar f_u_6_3_t_y = c_3 * t116 + hu_6_a_z * t110;
  const Scalar mu_6_2_x = t110 * t119 + Scalar(97.25) * f_u_6_3_t_y + c_3 * mu_6_3_y;
  const Scalar mu_u_6_2_t_y = c_2 * mu_6_2_x - s_2 * t104;
  const Scalar t146 = s_5 * (s_2 * t94 + t144 * t82) + mu_u_6_2_t_y * t77 + t145;
  const Scalar t147 = t146 * t102;
  const Scalar t148 = hu_6_t_x * t117 + s_3 * t128;
  const Scalar t149 = c_2 * (t94 * t117 - s_3 * t127 + Scalar(97.25) * t148);
  const Scalar t150 = Scalar(69.84866123397676) * mu_u_6_2_t_y;
  const Scalar t151 = -t104 * t150 - t144 * t106 - t95 * t147 + t149 + s_2 * t135;
  const Scalar Iu_4_t_xx = t133 + Ic_4_yy;
  const Scalar t152 = Scalar(0.015605406162468319) - t134 + t100;
  const Scalar Iu_3_t_d = Iu_4_t_xx + t152;
  const Scalar t153 = t113 - t86;
  const Scalar t154 = Scalar(2.0) * t153 * t117 - s_3 * Iu_3_t_d;
  const Scalar t155 = c_2 * (c_3 * t154 - s_5 * t153);
  const Scalar t156 = -mu_u_6_2_t_y * t131 - t144 * t142 + t155 + s_2 * t130 - t146 * t124 -
      t151 * t138;
  const Scalar t157 = s_3 * t154;
  const Scalar t158 = Scalar(194.5) * hu_4_t_y;
  const Scalar b_3_2_2 = t120 * t131 - mu_5_2_z * t142 + Iu_4_t_xx + t157 + t123 * t124 +
      t132 * t138 + t158 + Scalar(1.0320559061624683);
  const Scalar d_2 = Scalar(1.0) / b_3_2_2;
  const Scalar t159 = t156 * d_2;
  const Scalar f_u_3_t_y = c_3 * t140 + s_3 * f_3_y;
  const Scalar mu_2_x = Scalar(0.11585918767506335) * t14 + s_3 * mu_3_x - c_3 * t141 +
      Scalar(97.25) * f_u_3_t_y;
  const Scalar t160 = s_2 * (Scalar(0.00196) * t31 + t73);
  const Scalar t161 = t151 * t137;
  const Scalar t162 = t144 * d_5;
  const Scalar t163 = tau_1 - t160 - c_2 * mu_2_x - t150 * y_6 - t162 * t78 + t147 * t84 +
      t161 * t107 + t159 * y_3_2;
  const Scalar t164 = t152 + t157 - t158 - Scalar(1.0890055);
  const Scalar t165 = s_2 * (Scalar(2.0) * t149 +
      s_2 * (t135 - Scalar(0.05890959383753168) - t164));
  const Scalar t166 = mu_u_6_2_t_y * t150 + t144 * t162 + Scalar(0.05498959383753168) -
      t146 * t147 + t156 * t159 - t151 * t161 + t165 + t164;
  const Scalar t167 = t163 / t166;
  qdd[0] = -t167;
  const Scalar t168 = c_8 * qd_7;
  const Scalar t169 = s_9 * t168;
  const Scalar t170 = c_9 * qd_8;
  const Scalar omega_r_9_x = t169 + t170;
  const Scalar t171 = s_8 * qd_7;
  const Scalar omega_9_z = qd_9 - t171;
  const Scalar t172 = omega_r_9_x * omega_9_z;
  const Scalar t173 = t171 * (t169 + Scalar(2.0) * t170);
  const Scalar t174 = t172 + t173;
  const Scalar U_9_zx = t172 + t174;
  const Scalar t175 = t168 * t168 + qd_8 * qd_8;
  const Scalar t176 = Scalar(2452.5) * c_7;
  const Scalar t177 = Scalar(97.25) * t175 - Scalar(5.0) * U_9_zx + c_8 * t176;
  const Scalar t178 = omega_r_9_x * omega_r_9_x;
  const Scalar t179 = omega_9_z * omega_9_z;
  const Scalar t180 = t178 - t179;
  const Scalar t181 = qd_8 * t171;
  const Scalar ddp_9_a_y = Scalar(2452.5) * s_7 - Scalar(194.5) * t181;
  const Scalar t182 = t168 * t171;
  const Scalar ddp_o_9_x = Scalar(97.25) * t182 + s_8 * t176;
  const Scalar t183 = c_9 * ddp_9_a_y - s_9 * ddp_o_9_x;
  const Scalar ddp_o_10_x = Scalar(5.0) * (t175 - t180) - t183;
  const Scalar t184 = c_10 * t177 + s_10 * ddp_o_10_x;
  const Scalar t185 = s_10 * omega_r_9_x + c_10 * omega_9_z;
  const Scalar t186 = t185 * t185;
  const Scalar t187 = c_9 * t168;
  const Scalar t188 = s_9 * qd_8;
  const Scalar t189 = t187 - t188;
  const Scalar omega_10_z = qd_10 + t189;
  const Scalar t190 = omega_10_z * omega_10_z;
  const Scalar t191 = c_10 * omega_r_9_x - s_10 * omega_9_z;
  const Scalar t192 = t185 * t191;
  const Scalar U_10_xy = t174 + t192;
  const Scalar t193 = Scalar(10.0) * U_10_xy + t184 + Scalar(89.25) * (t178 + t179 - t186 + t190);
  const Scalar t194 = t189 * omega_9_z;
  const Scalar t195 = (t187 - Scalar(2.0) * t188) * t171;
  const Scalar t196 = t195 + Scalar(2.0) * t194;
  const Scalar t197 = omega_r_9_x * t189;
  const Scalar t198 = qd_8 * t168;
  const Scalar t199 = t198 + t197;
  const Scalar t200 = t185 * omega_10_z;
  const Scalar t201 = s_10 * t199 + c_10 * t196 - t200;
  const Scalar t202 = t191 * omega_10_z;
  const Scalar t203 = c_10 * t199 - s_10 * t196 - Scalar(2.0) * t202;
  const Scalar t204 = t198 - t197;
  const Scalar ddp_9_y = c_9 * ddp_o_9_x + s_9 * ddp_9_a_y;
  const Scalar ddp_o_10_y = Scalar(5.0) * t204 + ddp_9_y;
  const Scalar t205 = Scalar(10.0) * t203 - ddp_o_10_y + Scalar(89.25) * (t200 - t201);
  const Scalar t206 = c_11 * t193 + s_11 * t205;
  const Scalar t207 = c_10 * ddp_o_10_x - s_10 * t177;
  const Scalar Uz_o_11_y = t186 + t190;
  const Scalar ddp_11_a_z = Scalar(89.25) * (t174 - t192) - Scalar(10.0) * Uz_o_11_y + t207;
  const Scalar t208 = c_12 * ddp_11_a_z - s_12 * t206;
  const Scalar t209 = c_12 * t206 + s_12 * ddp_11_a_z;
  const Scalar t210 = c_11 * t185 - s_11 * omega_10_z;
  const Scalar omega_11_z = qd_11 + t191;
  const Scalar omega_r_12_x = c_12 * omega_11_z - s_12 * t210;
  const Scalar t211 = omega_r_12_x * omega_r_12_x;
  const Scalar omega_r_11_y = c_11 * omega_10_z + s_11 * t185;
  const Scalar omega_12_z = qd_12 + omega_r_11_y;
  const Scalar t212 = omega_12_z * omega_12_z;
  const Scalar t213 = t210 * t210 - t211 + omega_11_z * omega_11_z + t212;
  const Scalar t214 = t211 + t212;
  const Scalar t215 = c_12 * t210 + s_12 * omega_11_z;
  const Scalar t216 = omega_r_12_x * t215;
  const Scalar t217 = t210 * omega_11_z;
  const Scalar t218 = c_11 * U_10_xy - t217 + s_11 * t203;
  const Scalar t219 = Scalar(-0.0012) * t216 - Scalar(0.00315) * (t213 - t214) +
      Scalar(0.01431666666667) * t218 + Scalar(0.00018) * t209 + Scalar(0.00042) * t208;
  const Scalar t220 = Scalar(0.00940666666667) * t217 + Scalar(0.00876666666667) * t218 - t219;
  const Scalar t221 = Scalar(0.00018) * (t216 + t218) + Scalar(0.00042) * t214;
  const Scalar U_12_xy = t218 - t216;
  const Scalar t222 = Scalar(0.00018) * t213 - Scalar(0.00042) * U_12_xy;
  const Scalar t223 = c_12 * t221 + s_12 * t222 + Scalar(0.0000615126050420168) * t206;
  const Scalar t224 = c_11 * t205 - s_11 * t193;
  const Scalar t225 = omega_r_11_y * omega_11_z;
  const Scalar U_11_zy = c_11 * t203 - s_11 * U_10_xy + Scalar(2.0) * t225;
  const Scalar t226 = t210 * omega_r_11_y;
  const Scalar t227 = t226 + t201;
  const Scalar t228 = omega_r_12_x * omega_12_z;
  const Scalar t229 = c_12 * U_11_zy - s_12 * t227 - t228;
  const Scalar U_12_zx = t228 - t229;
  const Scalar t230 = t215 * omega_12_z;
  const Scalar t231 = c_12 * t227 + s_12 * U_11_zy - Scalar(2.0) * t230;
  const Scalar t232 = Scalar(-0.00018) * U_12_zx - Scalar(0.00042) * t231 +
      Scalar(0.0000615126050420168) * t224;
  const Scalar t233 = c_11 * t232 + s_11 * t223;
  const Scalar t234 = Scalar(-0.0012) * t229 - Scalar(0.00315) * t231 + Scalar(0.00018) * t224 -
      Scalar(0.01431666666667) * t228;
  const Scalar t235 = Scalar(0.01551666666667) * t230 - Scalar(0.00315) * U_12_zx +
      Scalar(0.00042) * t224;
  const Scalar mu_11_x = Scalar(0.01817333333334) * t225 + c_12 * t234 - s_12 * t235;
  const Scalar t236 = Scalar(0.03536081232493664) * t202 +
      Scalar(0.0002648739495798319) * ddp_o_10_y - c_11 * mu_11_x + s_11 * t220 -
      Scalar(10.0) * t233;
  const Scalar t237 = Scalar(0.00876666666667) * t226 + Scalar(0.00940666666667) * t201 -
      s_12 * t234 - c_12 * t235;
  const Scalar t238 = Scalar(0.047979593837531684) * t200 + t237 -
      Scalar(0.08334040616246832) * t201 - Scalar(89.25) * t233;
  const Scalar t239 = Scalar(0.0002648739495798319) * t203 -
      Scalar(2.4873949579831934e-06) * ddp_o_10_y + t233;
  const Scalar t240 = Scalar(0.00507) * t195 + Scalar(0.01720540616246832) * t197 +
      Scalar(0.03025540616246832) * t198 - Scalar(5.0) * t239 - c_10 * t236 + s_10 * t238;
  const Scalar t241 = c_11 * t223 - s_11 * t232;
  const Scalar f_11_z = s_12 * t221 - c_12 * t222 + Scalar(0.0000615126050420168) * ddp_11_a_z;
  const Scalar mu_10_z = Scalar(0.047979593837531684) * t174 -
      Scalar(0.0002648739495798319) * t184 - Scalar(0.08334040616246832) * t192 + c_11 * t220 +
      s_11 * mu_11_x - Scalar(10.0) * t241 - Scalar(89.25) * f_11_z;
  const Scalar y_12 = t219 + tau_12;
  const Scalar hu_12_a_z = Scalar(0.00018) * c_12 - Scalar(0.00042) * s_12;
  const Scalar t242 = Scalar(10.0) * hu_12_a_z + Scalar(0.01431666666667);
  const Scalar hu_12_t_x = Scalar(0.00018) * s_12 + Scalar(0.00042) * c_12;
  const Scalar t243 = Scalar(89.25) * hu_12_t_x;
  const Scalar mu_12_10_z = c_11 * t242 + t243;
  const Scalar t244 = Scalar(69.84866123397676) * mu_12_10_z;
  const Scalar t245 = t237 - tau_11;
  const Scalar t246 = Scalar(0.0063) * c_12 - Scalar(0.0012) * s_12;
  const Scalar t247 = s_12 * t246;
  const Scalar Ic_11_zz = t247 + Scalar(0.00940666666667);
  const Scalar d_11 = Scalar(1.0) / Ic_11_zz;
  const Scalar t248 = Scalar(10.0) * hu_12_t_x + c_12 * t246 - Scalar(0.00315);
  const Scalar t249 = t248 * d_11;
  const Scalar t250 = s_11 * t249;
  const Scalar t251 = t250 * t245 + mu_10_z - tau_10 + t244 * y_12;
  const Scalar t252 = c_10 * t248;
  const Scalar t253 = Scalar(5.0) * hu_12_t_x;
  const Scalar t254 = c_11 * hu_12_t_x;
  const Scalar t255 = Ic_11_zz + Scalar(89.25) * t254;
  const Scalar t256 = s_10 * t255 - c_11 * (t252 - t253);
  const Scalar t257 = Scalar(89.25) * hu_12_a_z;
  const Scalar t258 = c_10 * t242 - t257 * (Scalar(0.056022408963585436) + s_10);
  const Scalar t259 = c_11 * (t247 + Scalar(0.00675));
  const Scalar t260 = t259 + t243;
  const Scalar t261 = s_10 * t248 + c_10 * t260;
  const Scalar t262 = s_11 * (t261 - (t256 * t249 + t258 * t244));
  const Scalar t263 = s_11 * t248;
  const Scalar t264 = c_11 * t259;
  const Scalar t265 = Scalar(178.5) * t254;
  const Scalar t266 = Scalar(20.0) * hu_12_a_z;
  const Scalar t267 = t247 - t264 - t266 - t265 - Scalar(0.44695416666667);
  const Scalar t268 = t250 * t263 + mu_12_10_z * t244 + t267;
  const Scalar t269 = Scalar(1.0) / t268;
  const Scalar t270 = t269 * t262;
  const Scalar t271 = s_11 * t258;
  const Scalar t272 = Scalar(-69.84866123397676) * t271;
  const Scalar t273 = t256 * d_11;
  const Scalar t274 = t240 - t270 * t251 + tau_9 + t272 * y_12 - t273 * t245;
  const Scalar t275 = c_11 * t248;
  const Scalar mu_u_11_10_t_x = s_10 * t275 + c_10 * t255;
  const Scalar t276 = t248 - c_10 * t253;
  const Scalar t277 = s_9 * s_11;
  const Scalar t278 = Scalar(97.25) * hu_12_t_x;
  const Scalar t279 = (c_9 * c_11 + s_10 * t277) * t278;
  const Scalar mu_11_8_z = t277 * t276 + c_9 * mu_u_11_10_t_x + t279;
  const Scalar t280 = t252 - s_10 * t260;
  const Scalar t281 = s_11 * (c_9 * t280 - mu_11_8_z * t249);
  const Scalar t282 = c_11 * hu_12_a_z;
  const Scalar t283 = s_10 * t282 + c_10 * hu_12_t_x;
  const Scalar t284 = c_9 * s_11;
  const Scalar t285 = hu_12_a_z * t284 - s_9 * t283;
  const Scalar mu_12_9_y = mu_12_10_z - Scalar(5.0) * (c_10 * t282 - s_10 * hu_12_t_x);
  const Scalar t286 = s_10 * t242 + c_10 * t257;
  const Scalar t287 = t284 * t286 + Scalar(97.25) * t285 - s_9 * mu_12_9_y;
  const Scalar hc_10_x = t254 + Scalar(0.00549);
  const Scalar f_10_10_x = hu_12_a_z + Scalar(0.00088);
  const Scalar t288 = c_10 * f_10_10_x - s_10 * hc_10_x;
  const Scalar hu_10_t_y = s_10 * f_10_10_x + c_10 * hc_10_x;
  const Scalar t289 = Scalar(5.0) * t288 + t267 - Scalar(97.25) * hu_10_t_y;
  const Scalar t290 = t281 + t287 * t244 - s_9 * t289;
  const Scalar t291 = t290 * t269;
  const Scalar t292 = t264 - t266 - Scalar(0.01170126050420168);
  const Scalar Ic_10_yy = t247 + t265 + Scalar(0.4160487605042017);
  const Scalar Ic_10_xy = t275 + t257 + Scalar(0.0549);
  const Scalar t293 = Scalar(2.0) * c_10 * Ic_10_xy - s_10 * (t292 + Ic_10_yy);
  const Scalar t294 = Scalar(0.00507) + Scalar(5.0) * hu_10_t_y + Ic_10_xy - c_10 * t293;
  const Scalar t295 = t288 - Scalar(0.00032);
  const Scalar t296 = c_9 * t295 - hu_12_t_x * t277;
  const Scalar t297 = -t261 * t277 - c_9 * t294 + Scalar(97.25) * t296;
  const Scalar t298 = Scalar(-69.84866123397676) * t287;
  const Scalar t299 = t271 * t298 + mu_11_8_z * t273 - t262 * t291 + t297;
  const Scalar t300 = s_10 * t293;
  const Scalar t301 = Scalar(-10.0) * t288;
  const Scalar t302 = t292 - t301 - Scalar(0.03185540616246832) + t300;
  const Scalar t303 = t256 * t273 - t262 * t270 - t271 * t272 + t302;
  const Scalar t304 = Scalar(1.0) / t303;
  const Scalar t305 = t299 * t304;
  const Scalar t306 = Scalar(0.0002648739495798319) * U_10_xy +
      Scalar(2.4873949579831934e-06) * t184 + t241;
  const Scalar f_10_y = Scalar(0.0002648739495798319) * Uz_o_11_y -
      Scalar(2.4873949579831934e-06) * t207 - f_11_z;
  const Scalar t307 = Scalar(0.000051146529562982) * t183 + c_10 * f_10_y - s_10 * t306;
  const Scalar f_9_y = Scalar(0.000051146529562982) * ddp_9_y - t239;
  const Scalar f_u_9_t_x = c_9 * f_9_y - s_9 * t307;
  const Scalar mu_9_x = Scalar(0.00507) * t204 + Scalar(0.04746081232493664) * t194 + s_10 * t236 +
      c_10 * t238;
  const Scalar f_u_10_a_z = c_10 * t306 + s_10 * f_10_y;
  const Scalar t308 = Scalar(0.01305) * t172 - Scalar(0.00507) * t180 -
      Scalar(0.01720540616246832) * t173 - Scalar(5.0) * f_u_10_a_z - mu_10_z;
  const Scalar t309 = mu_11_8_z * d_11;
  const Scalar y_9_8 = Scalar(0.05890959383753168) * t182 - c_9 * mu_9_x + tau_8 - s_9 * t308 -
      Scalar(97.25) * f_u_9_t_x + t298 * y_12 + t309 * t245 + t291 * t251 + t305 * t274;
  const Scalar t310 = (s_10 * t284 - s_9 * c_11) * t278;
  const Scalar t311 = c_8 * (t284 * t276 - s_9 * mu_u_11_10_t_x + t310) - s_8 * t256;
  const Scalar t312 = c_8 * (t280 * t277 + c_9 * t289);
  const Scalar f_u_12_9_t_y = c_9 * t283 + hu_12_a_z * t277;
  const Scalar mu_12_8_x = t277 * t286 + Scalar(97.25) * f_u_12_9_t_y + c_9 * mu_12_9_y;
  const Scalar mu_u_12_8_t_y = c_8 * mu_12_8_x - s_8 * t271;
  const Scalar t313 = s_11 * (s_8 * t261 + t311 * t249) + mu_u_12_8_t_y * t244 + t312;
  const Scalar t314 = t313 * t269;
  const Scalar t315 = hu_12_t_x * t284 + s_9 * t295;
  const Scalar t316 = c_8 * (t261 * t284 - s_9 * t294 + Scalar(97.25) * t315);
  const Scalar t317 = Scalar(69.84866123397676) * mu_u_12_8_t_y;
  const Scalar t318 = -t271 * t317 - t311 * t273 - t262 * t314 + t316 + s_8 * t302;
  const Scalar Iu_10_t_xx = t300 + Ic_10_yy;
  const Scalar t319 = Scalar(0.015605406162468319) - t301 + t267;
  const Scalar Iu_9_t_d = Iu_10_t_xx + t319;
  const Scalar t320 = t280 - t253;
  const Scalar t321 = Scalar(2.0) * t320 * t284 - s_9 * Iu_9_t_d;
  const Scalar t322 = c_8 * (c_9 * t321 - s_11 * t320);
  const Scalar t323 = -mu_u_12_8_t_y * t298 - t311 * t309 + t322 + s_8 * t297 - t313 * t291 -
      t318 * t305;
  const Scalar t324 = s_9 * t321;
  const Scalar t325 = Scalar(194.5) * hu_10_t_y;
  const Scalar b_9_8_8 = t287 * t298 - mu_11_8_z * t309 + Iu_10_t_xx + t324 + t290 * t291 +
      t299 * t305 + t325 + Scalar(1.0320559061624683);
  const Scalar d_8 = Scalar(1.0) / b_9_8_8;
  const Scalar t326 = t323 * d_8;
  const Scalar f_u_9_t_y = c_9 * t307 + s_9 * f_9_y;
  const Scalar mu_8_x = Scalar(0.11585918767506335) * t181 + s_9 * mu_9_x - c_9 * t308 +
      Scalar(97.25) * f_u_9_t_y;
  const Scalar t327 = s_8 * (Scalar(0.00196) * t198 + t240);
  const Scalar t328 = t318 * t304;
  const Scalar t329 = t311 * d_11;
  const Scalar t330 = tau_7 - t327 - c_8 * mu_8_x - t317 * y_12 - t329 * t245 + t314 * t251 +
      t328 * t274 + t326 * y_9_8;
  const Scalar t331 = t319 + t324 - t325 - Scalar(1.0890055);
  const Scalar t332 = s_8 * (Scalar(2.0) * t316 +
      s_8 * (t302 - Scalar(0.05890959383753168) - t331));
  const Scalar t333 = mu_u_12_8_t_y * t317 + t311 * t329 + Scalar(0.05498959383753168) -
      t313 * t314 + t323 * t326 - t318 * t328 + t332 + t331;
  const Scalar t334 = t330 / t333;
  qdd[6] = -t334;
  const Scalar qdd_2 = d_2 * (y_3_2 - t156 * t167);
  qdd[1] = qdd_2;
  const Scalar qdd_8 = d_8 * (y_9_8 - t323 * t334);
  qdd[7] = qdd_8;
  const Scalar t335 = t137 * (t151 * t167 - t132 * qdd_2 + t107);
  qdd[2] = -t335;
  const Scalar t336 = t304 * (t318 * t334 - t299 * qdd_8 + t274);
  qdd[8] = -t336;
  const Scalar qdd_4 = t102 * (t146 * t167 - t95 * t335 + t84 - t123 * qdd_2);
  qdd[3] = qdd_4;
  const Scalar qdd_10 = t269 * (t313 * t334 - t262 * t336 + t251 - t290 * qdd_8);
  qdd[9] = qdd_10;
  const Scalar t337 = mu_u_6_2_t_y * t167 - mu_6_4_z * qdd_4 + y_6;
  qdd[5] = Scalar(69.84866123397676) * (t104 * t335 - t120 * qdd_2) +
      Scalar(69.84866123397676) * t337;
  const Scalar t338 = mu_u_12_8_t_y * t334 - mu_12_10_z * qdd_10 + y_12;
  qdd[11] = Scalar(69.84866123397676) * (t271 * t336 - t287 * qdd_8) +
      Scalar(69.84866123397676) * t338;
  const Scalar t339 = t144 * t167 - t96 * qdd_4 + mu_5_2_z * qdd_2 + t89 * t335 + t78;
  qdd[4] = -d_5 * t339;
  const Scalar t340 = t311 * t334 - t263 * qdd_10 + mu_11_8_z * qdd_8 + t256 * t336 + t245;
  qdd[10] = -d_11 * t340;
  const Scalar t341 = s_32 * s_32;
  const Scalar t342 = Scalar(0.0005096) * t341;
  const Scalar t343 = t342 - Scalar(0.0005096);
  const Scalar t344 = s_31 * c_32;
  const Scalar t345 = c_31 * (t343 - Scalar(0.0235906)) - Scalar(0.0014964) * t344;
  const Scalar t346 = c_31 * t345;
  const Scalar t347 = c_31 * c_32;
  const Scalar t348 = Scalar(0.6811013098102112) * t347 + s_31;
  const Scalar t349 = Scalar(0.0014964) * c_30 * s_32 * t348 -
      s_30 * (t342 + (t346 + Scalar(0.0235906)));
  const Scalar t350 = s_30 * t349;
  const Scalar t351 = Scalar(0.0000376) * c_32;
  const Scalar hu_30_a_y = s_31 * t351 + Scalar(0.0007608) * c_31;
  const Scalar t352 = Scalar(119.5) * hu_30_a_y;
  const Scalar Ic_29_xx = t342 + t350 + t352 + Scalar(0.4683922);
  const Scalar mu_u_30_30_a_y = t343 - t346 - Scalar(0.0259635000000002);
  const Scalar hu_31_t_x = Scalar(0.0007608) * s_31 - c_31 * t351;
  const Scalar t353 = Scalar(0.0000376) * s_32;
  const Scalar t354 = c_30 * t353;
  const Scalar t355 = t354 - s_30 * hu_31_t_x;
  const Scalar t356 = Scalar(-2.0) * t355;
  const Scalar t357 = mu_u_30_30_a_y - t356 - Scalar(0.2421176999999998);
  const Scalar Iu_29_t_d = t357 + Ic_29_xx;
  const Scalar t358 = Scalar(0.0007482) * c_32 + s_31 * t345;
  const Scalar t359 = c_31 - Scalar(0.6811013098102112) * t344;
  const Scalar t360 = Scalar(0.0007482) * s_32;
  const Scalar t361 = c_30 * t360;
  const Scalar t362 = t359 * t361 + s_30 * t358 + Scalar(59.75) * t355;
  const Scalar Ic_29_xy = hu_30_a_y + Scalar(0.0050592) - t362;
  const Scalar t363 = c_29 * Iu_29_t_d - Scalar(2.0) * s_29 * Ic_29_xy;
  const Scalar t364 = c_29 * t363;
  const Scalar t365 = t357 - t364;
  const Scalar t366 = t346 - t356 + t350 - t352 - Scalar(0.2062863000000002);
  const Scalar t367 = t355 - Scalar(0.0001312);
  const Scalar hc_29_y = hu_30_a_y + Scalar(0.0034592);
  const Scalar t368 = c_29 * t367 - s_29 * hc_29_y;
  const Scalar t369 = Scalar(-2.0) * t368;
  const Scalar t370 = t369 + t366 - Scalar(0.2401836999999998);
  const Scalar t371 = s_30 * t353;
  const Scalar hu_30_t_y = t371 + c_30 * hu_31_t_x;
  const Scalar Ic_29_xz = hu_30_t_y + t348 * t360 - c_30 * t349;
  const Scalar t372 = s_30 * t360;
  const Scalar mu_30_29_z = t359 * t372 - c_30 * t358 + Scalar(59.75) * hu_30_t_y;
  const Scalar Iu_29_t_xz = c_29 * Ic_29_xz + s_29 * mu_30_29_z;
  const Scalar t373 = hu_30_t_y - Iu_29_t_xz;
  const Scalar t374 = Scalar(2.0) * c_28 * t373 + s_28 * (t365 - t370);
  const Scalar t375 = s_28 * t374;
  const Scalar t376 = s_29 * t367 + c_29 * hc_29_y;
  const Scalar t377 = Scalar(-152.5) * t376;
  const Scalar t378 = t375 + t370 + t377 - Scalar(0.506605);
  const Scalar Ic_28_zz = -t369 - Scalar(0.2323492999999998) + Ic_29_xx - t364;
  const Scalar Ic_27_yy = Scalar(0.2690164999999998) + Ic_28_zz;
  const Scalar t379 = -t376 - Scalar(0.0023) + Ic_29_xy + s_29 * t363;
  const Scalar t380 = c_29 * mu_30_29_z - s_29 * Ic_29_xz;
  const Scalar t381 = t368 - Scalar(0.0000128);
  const Scalar t382 = c_28 * hu_30_t_y;
  const Scalar t383 = t382 + s_28 * t381;
  const Scalar t384 = c_28 * t380 + Scalar(76.25) * t383 - s_28 * t379;
  const Scalar t385 = c_27 * t384;
  const Scalar t386 = Scalar(2.0) * t385 - s_27 * (t378 + Ic_27_yy);
  const Scalar t387 = s_27 * t386;
  const Scalar Iu_27_t_xx = Ic_27_yy + t387;
  const Scalar t388 = -t375 - Scalar(0.2395485000000002) + t365 + t377;
  const Scalar Iu_26_t_d = Iu_27_t_xx + (t388 - Scalar(0.2670564999999998));
  const Scalar Iu_28_a_yz = t373 - c_28 * t374;
  const Scalar t389 = s_28 * hu_30_t_y;
  const Scalar t390 = c_28 * t381 - t389;
  const Scalar t391 = Scalar(76.25) * t390 - s_28 * t380 - c_28 * t379;
  const Scalar Iu_27_a_xz = c_27 * t391 + s_27 * Iu_28_a_yz;
  const Scalar t392 = s_26 * Iu_27_a_xz;
  const Scalar t393 = c_26 * Iu_26_t_d - Scalar(2.0) * t392;
  const Scalar t394 = s_25 * s_25;
  const Scalar t395 = Scalar(0.0005096) * t394;
  const Scalar t396 = t395 - Scalar(0.0005096);
  const Scalar t397 = s_24 * c_25;
  const Scalar t398 = Scalar(0.0014964) * t397 + c_24 * (t396 - Scalar(0.0235906));
  const Scalar t399 = c_24 * t398;
  const Scalar t400 = c_24 * c_25;
  const Scalar t401 = s_24 - Scalar(0.6811013098102112) * t400;
  const Scalar t402 = Scalar(0.0014964) * c_23 * s_25 * t401 +
      s_23 * (t395 + (t399 + Scalar(0.0235906)));
  const Scalar t403 = s_23 * t402;
  const Scalar t404 = Scalar(0.0000376) * c_25;
  const Scalar hu_23_a_y = Scalar(0.0007608) * c_24 - s_24 * t404;
  const Scalar t405 = Scalar(119.5) * hu_23_a_y;
  const Scalar Ic_22_xx = t395 - t403 + t405 + Scalar(0.4683922);
  const Scalar mu_u_23_23_a_y = t396 - t399 - Scalar(0.0259635000000002);
  const Scalar hu_24_t_x = c_24 * t404 + Scalar(0.0007608) * s_24;
  const Scalar t406 = Scalar(0.0000376) * s_25;
  const Scalar t407 = c_23 * t406;
  const Scalar t408 = t407 + s_23 * hu_24_t_x;
  const Scalar t409 = Scalar(2.0) * t408;
  const Scalar t410 = mu_u_23_23_a_y - t409 - Scalar(0.2421176999999998);
  const Scalar Iu_22_t_d = t410 + Ic_22_xx;
  const Scalar Iu_24_t_xy = Scalar(0.0007482) * c_25 - s_24 * t398;
  const Scalar t411 = Scalar(0.6811013098102112) * t397 + c_24;
  const Scalar t412 = Scalar(0.0007482) * s_25;
  const Scalar t413 = c_23 * t412;
  const Scalar t414 = t411 * t413 + s_23 * Iu_24_t_xy + Scalar(59.75) * t408;
  const Scalar Ic_22_xy = hu_23_a_y + Scalar(0.0050592) + t414;
  const Scalar t415 = c_22 * Iu_22_t_d - Scalar(2.0) * s_22 * Ic_22_xy;
  const Scalar t416 = c_22 * t415;
  const Scalar t417 = t410 - t416;
  const Scalar t418 = t399 - t409 - t403 - t405 - Scalar(0.2062863000000002);
  const Scalar t419 = Scalar(0.0001312) + t408;
  const Scalar hc_22_y = hu_23_a_y + Scalar(0.0034592);
  const Scalar f_u_22_22_a_z = c_22 * t419 + s_22 * hc_22_y;
  const Scalar t420 = Scalar(2.0) * f_u_22_22_a_z;
  const Scalar t421 = t420 + t418 - Scalar(0.2401836999999998);
  const Scalar t422 = s_23 * t406;
  const Scalar t423 = c_23 * hu_24_t_x - t422;
  const Scalar t424 = t423 - t401 * t412 + c_23 * t402;
  const Scalar t425 = s_23 * t412;
  const Scalar t426 = c_23 * Iu_24_t_xy - t411 * t425 + Scalar(59.75) * t423;
  const Scalar t427 = c_22 * t424 + s_22 * t426;
  const Scalar t428 = t423 - t427;
  const Scalar t429 = Scalar(2.0) * c_21 * t428 + s_21 * (t417 - t421);
  const Scalar t430 = s_21 * t429;
  const Scalar t431 = c_22 * hc_22_y - s_22 * t419;
  const Scalar t432 = Scalar(-152.5) * t431;
  const Scalar t433 = t430 + t421 + t432 - Scalar(0.506605);
  const Scalar t434 = -t420 - Scalar(0.2323492999999998) + Ic_22_xx - t416;
  const Scalar t435 = Scalar(0.2690164999999998) + t434;
  const Scalar t436 = -t431 - Scalar(0.0023) + Ic_22_xy + s_22 * t415;
  const Scalar t437 = c_22 * t426 - s_22 * t424;
  const Scalar t438 = Scalar(0.0000128) + f_u_22_22_a_z;
  const Scalar t439 = c_21 * t423;
  const Scalar t440 = t439 - s_21 * t438;
  const Scalar t441 = c_21 * t437 + Scalar(76.25) * t440 - s_21 * t436;
  const Scalar t442 = c_20 * t441;
  const Scalar t443 = Scalar(2.0) * t442 - s_20 * (t433 + t435);
  const Scalar t444 = s_20 * t443;
  const Scalar t445 = t435 + t444;
  const Scalar t446 = -t430 - Scalar(0.2395485000000002) + t417 + t432;
  const Scalar t447 = t428 - c_21 * t429;
  const Scalar t448 = s_21 * t423;
  const Scalar t449 = t448 + c_21 * t438;
  const Scalar t450 = s_21 * t437 + Scalar(76.25) * t449 + c_21 * t436;
  const Scalar Iu_20_t_xz = c_20 * t450 - s_20 * t447;
  const Scalar t451 = s_19 * Iu_20_t_xz;
  const Scalar t452 = Scalar(2.0) * t451 + c_19 * (t445 + (t446 - Scalar(0.2670564999999998)));
  const Scalar t453 = c_26 * t393 + c_19 * t452;
  const Scalar t454 = t376 + Scalar(0.006644);
  const Scalar t455 = c_27 * t383 + s_27 * t454;
  const Scalar t456 = t431 + Scalar(0.006644);
  const Scalar t457 = c_20 * t440 + s_20 * t456;
  const Scalar t458 = Scalar(-120.0) * (t455 - t457);
  const Scalar Iu_18_t_g = Scalar(0.0044) * c_18 + Scalar(0.024) * s_18;
  const Scalar t459 = s_18 * Iu_18_t_g;
  const Scalar Iu_17_t_d = t459 - Scalar(0.0242);
  const Scalar t460 = s_17 * s_17;
  const Scalar t461 = Iu_17_t_d * t460;
  const Scalar Ic_16_zz = t459 - t461 + Scalar(0.011005);
  const Scalar hu_18_a_z = Scalar(0.00008) * c_18 + Scalar(0.00088) * s_18;
  const Scalar f_u_18_18_a_z = Scalar(0.00088) * c_18 - Scalar(0.00008) * s_18;
  const Scalar t462 = s_16 * s_17;
  const Scalar hu_16_a_z = c_16 * hu_18_a_z + f_u_18_18_a_z * t462;
  const Scalar t463 = Scalar(1.5) * hu_16_a_z;
  const Scalar t464 = t463 - Ic_16_zz + t388 + t446 - t453 + t458 - Scalar(1.8976885942203487);
  const Scalar t465 = Scalar(0.2650964999999998) + t378 + t387;
  const Scalar t466 = Scalar(0.2650964999999998) + t433 + t444;
  const Scalar hu_27_t_x = c_27 * t454 - s_27 * t383;
  const Scalar t467 = s_26 * t390;
  const Scalar t468 = t467 + c_26 * hu_27_t_x;
  const Scalar hu_20_t_x = c_20 * t456 - s_20 * t440;
  const Scalar t469 = s_19 * t449;
  const Scalar hu_19_t_x = c_19 * hu_20_t_x - t469;
  const Scalar t470 = c_17 * f_u_18_18_a_z;
  const Scalar t471 = Scalar(165.0) * (t468 + hu_19_t_x) - Scalar(226.5) * t470;
  const Scalar Iu_17_t_xx = Scalar(0.0002) + t461;
  const Scalar Iu_16_t_d = t459 + Iu_17_t_xx;
  const Scalar Iu_18_a_yz = c_18 * Iu_18_t_g - Scalar(0.0022);
  const Scalar t472 = Iu_18_a_yz * t462;
  const Scalar Iu_16_t_g = c_16 * Iu_16_t_d + Scalar(2.0) * t472;
  const Scalar t473 = c_16 * Iu_16_t_g;
  const Scalar t474 = t463 + t459 - t473 + t465 + t466 + t471 - Scalar(3.904841427553016);
  const Scalar t475 = t441 - c_20 * t443;
  const Scalar t476 = c_20 * t447 + s_20 * t450;
  const Scalar t477 = Scalar(60.0) * hu_19_t_x + s_19 * t476 + c_19 * t475;
  const Scalar t478 = t384 - c_27 * t386;
  const Scalar Iu_27_t_yz = c_27 * Iu_28_a_yz - s_27 * t391;
  const Scalar t479 = Scalar(60.0) * t468 - s_26 * Iu_27_t_yz - c_26 * t478;
  const Scalar t480 = c_16 * s_17;
  const Scalar t481 = f_u_18_18_a_z * t480 - s_16 * hu_18_a_z;
  const Scalar t482 = Scalar(113.25) * t481 - c_17 * (Iu_17_t_d * t480 + s_16 * Iu_18_a_yz);
  const Scalar t483 = t477 - t482 - t479 + Scalar(82.5) * (t455 + t457);
  const Scalar t484 = Scalar(2.0) * s_15;
  const Scalar t485 = t483 * t484 + c_15 * (t464 - t474);
  const Scalar t486 = c_15 * t485;
  const Scalar t487 = t486 + t474;
  const Scalar t488 = t461 - t473 + Iu_27_t_xx + t445 - t453 - t458 - t471 +
      Scalar(3.5630264999996673);
  const Scalar t489 = c_26 * t390;
  const Scalar t490 = t489 - s_26 * hu_27_t_x;
  const Scalar t491 = c_19 * t449;
  const Scalar hu_19_t_y = t491 + s_19 * hu_20_t_x;
  const Scalar t492 = c_16 * Iu_18_a_yz;
  const Scalar t493 = c_17 * (t492 - Iu_17_t_d * t462) + Scalar(113.25) * hu_16_a_z;
  const Scalar t494 = Scalar(0.75) * f_u_18_18_a_z;
  const Scalar t495 = c_17 * t494 - t493 - Scalar(0.043998) + Iu_27_a_xz - Iu_20_t_xz -
      Scalar(82.5) * (t490 - hu_19_t_y) + s_26 * t393 + s_19 * t452;
  const Scalar t496 = Scalar(60.0) * hu_19_t_y - c_19 * t476 + s_19 * t475;
  const Scalar t497 = Scalar(60.0) * t490 - c_26 * Iu_27_t_yz + s_26 * t478;
  const Scalar t498 = Scalar(0.75) * t481 - s_17 * Iu_18_a_yz + s_16 * Iu_16_t_g + t496 + t497;
  const Scalar t499 = c_14 * (c_15 * t495 - s_15 * t498);
  const Scalar t500 = s_14 * (Scalar(2.0) * t499 -
      s_14 * (Scalar(0.8084599275533488) + t488 + t487));
  const Scalar t501 = c_14 * (t483 - s_15 * t485);
  const Scalar t502 = Scalar(82.5) * t468 + t465;
  const Scalar t503 = c_14 * (c_15 * t479 - s_15 * t502);
  const Scalar t504 = t388 - Scalar(60.0) * t455;
  const Scalar t505 = c_26 * Iu_27_a_xz + s_26 * t504;
  const Scalar mu_27_15_y = Iu_27_t_yz + Scalar(82.5) * s_26 * t455;
  const Scalar t506 = c_14 * (c_15 * t505 + s_15 * mu_27_15_y);
  const Scalar t507 = s_27 * t384 + c_27 * Ic_28_zz;
  const Scalar f_u_28_26_t_y = c_26 * t383 - s_27 * t467;
  const Scalar t508 = Scalar(60.0) * f_u_28_26_t_y - s_26 * t391 + c_26 * t507;
  const Scalar t509 = t385 - s_27 * Ic_28_zz;
  const Scalar t510 = t509 - Scalar(82.5) * f_u_28_26_t_y;
  const Scalar t511 = c_14 * (c_15 * t508 + s_15 * t510);
  const Scalar t512 = t366 - t368 - Scalar(76.25) * t376;
  const Scalar t513 = s_28 * Iu_29_t_xz - c_28 * t512;
  const Scalar t514 = c_27 * t380 + s_27 * t513;
  const Scalar t515 = c_28 * Iu_29_t_xz + s_28 * t512;
  const Scalar t516 = s_28 * t376;
  const Scalar t517 = c_27 * t368 + s_27 * t516;
  const Scalar t518 = c_28 * t376;
  const Scalar t519 = c_26 * t518 + s_26 * t517;
  const Scalar t520 = Scalar(60.0) * t519 + c_26 * t514 - s_26 * t515;
  const Scalar mu_u_29_27_t_y = c_27 * t513 - s_27 * t380;
  const Scalar mu_29_15_y = mu_u_29_27_t_y - Scalar(82.5) * t519;
  const Scalar t521 = c_14 * (c_15 * t520 + s_15 * mu_29_15_y);
  const Scalar mu_30_29_y = t355 + mu_u_30_30_a_y;
  const Scalar t522 = c_29 * t362 - s_29 * mu_30_29_y;
  const Scalar t523 = s_29 * hu_30_t_y;
  const Scalar mu_30_28_y = mu_30_29_z - t523;
  const Scalar t524 = c_29 * t382 + s_28 * t355;
  const Scalar t525 = Scalar(76.25) * t524 + c_28 * mu_30_28_y + s_28 * t522;
  const Scalar t526 = t355 - c_29 * mu_30_29_y - s_29 * t362;
  const Scalar t527 = c_27 * t526 + s_27 * t525;
  const Scalar t528 = c_28 * t355 - c_29 * t389;
  const Scalar t529 = Scalar(76.25) * t528 + c_28 * t522 - s_28 * mu_30_28_y;
  const Scalar t530 = c_27 * t523 + s_27 * t528;
  const Scalar f_u_30_26_t_y = c_26 * t524 - s_26 * t530;
  const Scalar t531 = Scalar(60.0) * f_u_30_26_t_y + c_26 * t527 - s_26 * t529;
  const Scalar mu_u_30_27_t_y = c_27 * t525 - s_27 * t526;
  const Scalar mu_30_15_y = mu_u_30_27_t_y - Scalar(82.5) * f_u_30_26_t_y;
  const Scalar t532 = c_14 * (c_15 * t531 + s_15 * mu_30_15_y);
  const Scalar t533 = c_30 * t351 - c_31 * t371;
  const Scalar t534 = s_31 * t353;
  const Scalar f_u_32_29_t_x = s_29 * t534 + c_29 * t533;
  const Scalar f_u_32_30_t_y = c_31 * t354 + s_30 * t351;
  const Scalar f_u_32_28_t_x = s_28 * f_u_32_29_t_x + c_28 * f_u_32_30_t_y;
  const Scalar f_u_32_29_a_z = c_29 * t534 - s_29 * t533;
  const Scalar t535 = c_27 * f_u_32_29_a_z + s_27 * f_u_32_28_t_x;
  const Scalar t536 = c_28 * f_u_32_29_t_x - s_28 * f_u_32_30_t_y;
  const Scalar f_u_32_26_a_z = c_26 * t536 + s_26 * t535;
  const Scalar t537 = Scalar(0.0007482) * t347 + Scalar(0.0014129000000002) * s_31;
  const Scalar mu_32_29_z = t534 + t372 - c_30 * t537 - Scalar(59.75) * t533;
  const Scalar mu_32_28_y = mu_32_29_z - f_u_32_29_a_z;
  const Scalar mu_32_29_x = t361 + s_30 * t537 + Scalar(59.75) * f_u_32_30_t_y;
  const Scalar mu_u_32_31_t_y = Scalar(0.0014129000000002) * c_31 - Scalar(0.0007482) * t344;
  const Scalar t538 = mu_u_32_31_t_y - f_u_32_30_t_y;
  const Scalar mu_u_32_29_t_x = s_29 * t538 + c_29 * mu_32_29_x;
  const Scalar t539 = Scalar(76.25) * t536 - s_28 * mu_u_32_29_t_x - c_28 * mu_32_28_y;
  const Scalar mu_32_28_z = f_u_32_30_t_y + c_29 * t538 - s_29 * mu_32_29_x;
  const Scalar t540 = c_27 * mu_32_28_z - s_27 * t539;
  const Scalar mu_32_27_z = c_28 * mu_u_32_29_t_x + Scalar(76.25) * f_u_32_28_t_x -
      s_28 * mu_32_28_y;
  const Scalar mu_32_15_x = Scalar(60.0) * f_u_32_26_a_z - c_26 * t540 + s_26 * mu_32_27_z;
  const Scalar t541 = s_27 * mu_32_28_z + c_27 * t539;
  const Scalar t542 = t541 - Scalar(82.5) * f_u_32_26_a_z;
  const Scalar mu_u_32_15_t_x = c_15 * mu_32_15_x + s_15 * t542;
  const Scalar t543 = c_26 * t535 - s_26 * t536;
  const Scalar t544 = c_27 * f_u_32_28_t_x - s_27 * f_u_32_29_a_z;
  const Scalar t545 = Scalar(82.5) * t544 - Scalar(60.0) * t543 - c_26 * mu_32_27_z - s_26 * t540;
  const Scalar mu_u_32_14_t_y = c_14 * mu_u_32_15_t_x - s_14 * t545;
  const Scalar t546 = Scalar(0.5295491542217383) * s_32;
  const Scalar Ic_31_zz = t342 + Scalar(0.0253235000000002);
  const Scalar t547 = Ic_31_zz + Scalar(59.75) * hu_30_a_y;
  const Scalar mu_31_29_x = t348 * t372 + c_30 * t547;
  const Scalar t548 = c_30 * hu_30_a_y;
  const Scalar t549 = t359 * t360;
  const Scalar t550 = t548 - t549;
  const Scalar t551 = c_29 * mu_31_29_x - s_29 * t550;
  const Scalar t552 = s_30 * hu_30_a_y;
  const Scalar t553 = c_29 * t552 - s_29 * hu_31_t_x;
  const Scalar f_u_31_28_t_y = c_28 * t553 + s_28 * t548;
  const Scalar mu_31_29_z = hu_31_t_x - t348 * t361 + s_30 * t547;
  const Scalar f_u_31_29_a_z = c_29 * hu_31_t_x + s_29 * t552;
  const Scalar mu_31_28_y = mu_31_29_z - f_u_31_29_a_z;
  const Scalar mu_31_27_x = s_28 * t551 + c_28 * mu_31_28_y + Scalar(76.25) * f_u_31_28_t_y;
  const Scalar mu_31_28_z = t548 - c_29 * t550 - s_29 * mu_31_29_x;
  const Scalar t554 = c_27 * mu_31_28_z + s_27 * mu_31_27_x;
  const Scalar f_u_31_28_t_x = c_28 * t548 - s_28 * t553;
  const Scalar t555 = c_27 * f_u_31_29_a_z + s_27 * f_u_31_28_t_x;
  const Scalar t556 = c_26 * f_u_31_28_t_y - s_26 * t555;
  const Scalar mu_31_27_z = c_28 * t551 - s_28 * mu_31_28_y + Scalar(76.25) * f_u_31_28_t_x;
  const Scalar t557 = Scalar(60.0) * t556 + c_26 * t554 - s_26 * mu_31_27_z;
  const Scalar t558 = c_27 * mu_31_27_x - s_27 * mu_31_28_z;
  const Scalar t559 = t558 - Scalar(82.5) * t556;
  const Scalar t560 = c_14 * (c_15 * t557 + s_15 * t559);
  const Scalar t561 = c_26 * t555 + s_26 * f_u_31_28_t_y;
  const Scalar t562 = c_27 * f_u_31_28_t_x - s_27 * f_u_31_29_a_z;
  const Scalar t563 = Scalar(-60.0) * t561 - c_26 * mu_31_27_z - s_26 * t554 + Scalar(82.5) * t562;
  const Scalar b_32_31_13 = mu_u_32_14_t_y * t546 + t560 + s_14 * t563;
  const Scalar t564 = t549 - mu_u_32_31_t_y * t546;
  const Scalar t565 = Scalar(0.00011339132281129538) * t341 + Scalar(0.0253235000000002);
  const Scalar t566 = Scalar(1.0) / t565;
  const Scalar t567 = t564 * t566;
  const Scalar t568 = c_26 * t530 + s_26 * t524;
  const Scalar t569 = c_27 * t528 - s_27 * t523;
  const Scalar t570 = Scalar(82.5) * t569 - Scalar(60.0) * t568 - c_26 * t529 - s_26 * t527;
  const Scalar t571 = Scalar(707.7641729774637) * mu_u_32_31_t_y;
  const Scalar t572 = mu_u_32_14_t_y * t571 - b_32_31_13 * t567 + t532 + s_14 * t570;
  const Scalar b_32_31_29 = mu_31_29_z - mu_32_29_z * t546;
  const Scalar b_31_30_29 = -b_32_31_29 * t567 - mu_32_29_z * t571 + mu_30_29_z;
  const Scalar t573 = t564 * t567 + mu_u_32_31_t_y * t571 + mu_u_30_30_a_y;
  const Scalar t574 = Scalar(1.0) / t573;
  const Scalar t575 = b_31_30_29 * t574;
  const Scalar f_u_29_26_t_x = c_26 * t517 - s_26 * t518;
  const Scalar t576 = c_27 * t516 - s_27 * t368;
  const Scalar mu_29_15_z = s_26 * t514 - Scalar(60.0) * f_u_29_26_t_x + Scalar(82.5) * t576 +
      c_26 * t515;
  const Scalar t577 = b_32_31_29 * t566;
  const Scalar t578 = Scalar(707.7641729774637) * mu_32_29_z;
  const Scalar t579 = mu_u_32_14_t_y * t578 - b_32_31_13 * t577 + t572 * t575 + t521 -
      s_14 * mu_29_15_z;
  const Scalar b_32_31_28 = mu_31_28_z - mu_32_28_z * t546;
  const Scalar t580 = -b_32_31_28 * t567 - mu_32_28_z * t571 + t526;
  const Scalar t581 = t380 - mu_32_28_z * t578 - b_32_31_28 * t577 + t580 * t575;
  const Scalar t582 = mu_32_29_z * t578 - b_31_30_29 * t575 + b_32_31_29 * t577 + t366;
  const Scalar t583 = Scalar(1.0) / t582;
  const Scalar t584 = t581 * t583;
  const Scalar t585 = s_27 * t489 + s_26 * t383;
  const Scalar t586 = Scalar(60.0) * t585 - Scalar(82.5) * c_27 * t390 + c_26 * t391 + s_26 * t507;
  const Scalar t587 = t580 * t574;
  const Scalar t588 = b_32_31_28 * t566;
  const Scalar t589 = Scalar(707.7641729774637) * mu_32_28_z;
  const Scalar t590 = mu_u_32_14_t_y * t589 - b_32_31_13 * t588 + t572 * t587 + t579 * t584 + t511 -
      s_14 * t586;
  const Scalar b_32_31_27 = mu_31_27_z - mu_32_27_z * t546;
  const Scalar t591 = -b_32_31_27 * t567 - mu_32_27_z * t571 + t529;
  const Scalar t592 = t591 * t575 - mu_32_27_z * t578 - b_32_31_27 * t577 + t515;
  const Scalar t593 = t591 * t587 - mu_32_27_z * t589 - b_32_31_27 * t588 + t592 * t584 + t391;
  const Scalar b_29_28_28 = t581 * t584 - mu_32_28_z * t589 - b_32_31_28 * t588 + t580 * t587 +
      Ic_28_zz;
  const Scalar d_28 = Scalar(1.0) / b_29_28_28;
  const Scalar t594 = t593 * d_28;
  const Scalar mu_u_27_15_a_y = Scalar(82.5) * hu_27_t_x - t392 + c_26 * t504;
  const Scalar t595 = t592 * t583;
  const Scalar t596 = t591 * t574;
  const Scalar t597 = b_32_31_27 * t566;
  const Scalar t598 = Scalar(707.7641729774637) * mu_32_27_z;
  const Scalar t599 = mu_u_32_14_t_y * t598 + t572 * t596 - b_32_31_13 * t597 + t579 * t595 -
      t590 * t594 + t506 + s_14 * mu_u_27_15_a_y;
  const Scalar t600 = t541 * t546 + t558;
  const Scalar b_31_30_26 = t541 * t571 - t600 * t567 + mu_u_30_27_t_y;
  const Scalar b_30_29_26 = t541 * t578 + b_31_30_26 * t575 - t600 * t577 + mu_u_29_27_t_y;
  const Scalar t601 = t541 * t589 - t600 * t588 + b_31_30_26 * t587 + b_30_29_26 * t584 + t509;
  const Scalar b_28_27_26 = t541 * t598 - t600 * t597 + b_31_30_26 * t596 + Iu_27_t_yz +
      b_30_29_26 * t595 - t601 * t594;
  const Scalar t602 = mu_32_27_z * t598 + b_32_31_27 * t597 - t591 * t596 + t593 * t594 -
      t592 * t595 + t388;
  const Scalar t603 = Scalar(1.0) / t602;
  const Scalar t604 = b_28_27_26 * t603;
  const Scalar t605 = t601 * d_28;
  const Scalar t606 = b_30_29_26 * t583;
  const Scalar t607 = b_31_30_26 * t574;
  const Scalar t608 = t600 * t566;
  const Scalar t609 = Scalar(707.7641729774637) * t541;
  const Scalar t610 = t572 * t607 - mu_u_32_14_t_y * t609 - b_32_31_13 * t608 + t579 * t606 +
      s_14 * t497 - t590 * t605 + t599 * t604 + t503;
  const Scalar t611 = t563 - t545 * t546;
  const Scalar t612 = -t611 * t567 - t545 * t571 + t570;
  const Scalar b_30_29_15 = t545 * t578 - t612 * t575 + t611 * t577 + mu_29_15_z;
  const Scalar t613 = t545 * t589 + t611 * t588 - t612 * t587 + b_30_29_15 * t584 + t586;
  const Scalar t614 = t612 * t596 - t545 * t598 - t611 * t597 + t613 * t594 - b_30_29_15 * t595 +
      mu_u_27_15_a_y;
  const Scalar t615 = t545 * t609 + t612 * t607 - t611 * t608 - b_30_29_15 * t606 + t497 +
      t613 * t605 + t614 * t604;
  const Scalar t616 = t541 * t609 + t600 * t608 - b_31_30_26 * t607 - b_30_29_26 * t606 -
      b_28_27_26 * t604 + t601 * t605 + t465;
  const Scalar t617 = Scalar(1.0) / t616;
  const Scalar t618 = t615 * t617;
  const Scalar t619 = Scalar(82.5) * hu_19_t_x + t466;
  const Scalar mu_u_19_15_t_x = c_15 * t477 + s_15 * t619;
  const Scalar t620 = Scalar(60.0) * t457 + t446;
  const Scalar t621 = c_19 * Iu_20_t_xz - s_19 * t620;
  const Scalar t622 = t476 + Scalar(82.5) * s_19 * t457;
  const Scalar t623 = c_14 * (c_15 * t621 - s_15 * t622);
  const Scalar t624 = s_20 * t441 + c_20 * t434;
  const Scalar t625 = s_20 * t469 + c_19 * t440;
  const Scalar t626 = Scalar(60.0) * t625 - s_19 * t450 - c_19 * t624;
  const Scalar t627 = t442 - s_20 * t434;
  const Scalar t628 = t627 - Scalar(82.5) * t625;
  const Scalar mu_u_21_15_t_x = c_15 * t626 - s_15 * t628;
  const Scalar t629 = f_u_22_22_a_z + t418 - Scalar(76.25) * t431;
  const Scalar t630 = s_21 * t427 - c_21 * t629;
  const Scalar t631 = c_20 * t437 + s_20 * t630;
  const Scalar t632 = c_21 * t427 + s_21 * t629;
  const Scalar t633 = s_21 * t431;
  const Scalar t634 = c_20 * f_u_22_22_a_z - s_20 * t633;
  const Scalar t635 = c_21 * t431;
  const Scalar t636 = c_19 * t635 - s_19 * t634;
  const Scalar t637 = Scalar(60.0) * t636 - c_19 * t631 + s_19 * t632;
  const Scalar t638 = c_20 * t630 - s_20 * t437;
  const Scalar t639 = t638 - Scalar(82.5) * t636;
  const Scalar t640 = c_14 * (c_15 * t637 - s_15 * t639);
  const Scalar mu_23_22_y = mu_u_23_23_a_y - t408;
  const Scalar t641 = c_22 * t414 + s_22 * mu_23_22_y;
  const Scalar t642 = s_22 * t423;
  const Scalar t643 = t426 - t642;
  const Scalar t644 = c_22 * t439 - s_21 * t408;
  const Scalar t645 = Scalar(76.25) * t644 + c_21 * t643 - s_21 * t641;
  const Scalar t646 = t408 + c_22 * mu_23_22_y - s_22 * t414;
  const Scalar mu_u_23_20_t_x = c_20 * t646 - s_20 * t645;
  const Scalar t647 = c_22 * t448 + c_21 * t408;
  const Scalar t648 = Scalar(76.25) * t647 + c_21 * t641 + s_21 * t643;
  const Scalar t649 = c_20 * t642 - s_20 * t647;
  const Scalar t650 = c_19 * t644 - s_19 * t649;
  const Scalar t651 = Scalar(60.0) * t650 + c_19 * mu_u_23_20_t_x - s_19 * t648;
  const Scalar mu_u_23_20_t_y = c_20 * t645 + s_20 * t646;
  const Scalar mu_23_15_y = mu_u_23_20_t_y - Scalar(82.5) * t650;
  const Scalar t652 = c_14 * (c_15 * t651 - s_15 * mu_23_15_y);
  const Scalar t653 = c_23 * t404 - c_24 * t422;
  const Scalar t654 = s_24 * t406;
  const Scalar t655 = s_22 * t654 + c_22 * t653;
  const Scalar t656 = c_24 * t407 + s_23 * t404;
  const Scalar t657 = s_21 * t655 + c_21 * t656;
  const Scalar f_u_25_22_t_y = c_22 * t654 - s_22 * t653;
  const Scalar f_u_25_20_t_x = c_20 * f_u_25_22_t_y + s_20 * t657;
  const Scalar t658 = c_21 * t655 - s_21 * t656;
  const Scalar f_u_25_19_t_y = c_19 * t658 + s_19 * f_u_25_20_t_x;
  const Scalar t659 = Scalar(0.0014129000000002) * s_24 - Scalar(0.0007482) * t400;
  const Scalar t660 = t654 + t425 + c_23 * t659 - Scalar(59.75) * t653;
  const Scalar t661 = t660 - f_u_25_22_t_y;
  const Scalar t662 = t413 - s_23 * t659 + Scalar(59.75) * t656;
  const Scalar mu_u_25_24_t_y = Scalar(0.0007482) * t397 + Scalar(0.0014129000000002) * c_24;
  const Scalar t663 = t656 + mu_u_25_24_t_y;
  const Scalar t664 = c_22 * t662 - s_22 * t663;
  const Scalar t665 = Scalar(76.25) * t658 - s_21 * t664 - c_21 * t661;
  const Scalar t666 = t656 - c_22 * t663 - s_22 * t662;
  const Scalar mu_u_25_20_t_x = c_20 * t666 - s_20 * t665;
  const Scalar mu_u_25_20_a_y = c_21 * t664 + Scalar(76.25) * t657 - s_21 * t661;
  const Scalar mu_25_15_x = Scalar(60.0) * f_u_25_19_t_y + c_19 * mu_u_25_20_t_x -
      s_19 * mu_u_25_20_a_y;
  const Scalar mu_u_25_20_t_y = s_20 * t666 + c_20 * t665;
  const Scalar mu_25_15_y = mu_u_25_20_t_y - Scalar(82.5) * f_u_25_19_t_y;
  const Scalar f_u_25_19_t_x = c_19 * f_u_25_20_t_x - s_19 * t658;
  const Scalar t667 = c_20 * t657 - s_20 * f_u_25_22_t_y;
  const Scalar t668 = Scalar(82.5) * t667 + Scalar(60.0) * f_u_25_19_t_x - c_19 * mu_u_25_20_a_y -
      s_19 * mu_u_25_20_t_x;
  const Scalar t669 = c_14 * (c_15 * mu_25_15_x - s_15 * mu_25_15_y) + s_14 * t668;
  const Scalar t670 = Scalar(0.5295491542217383) * s_25;
  const Scalar Ic_24_zz = t395 + Scalar(0.0253235000000002);
  const Scalar t671 = Ic_24_zz + Scalar(59.75) * hu_23_a_y;
  const Scalar t672 = t401 * t425 - c_23 * t671;
  const Scalar t673 = c_23 * hu_23_a_y;
  const Scalar t674 = t411 * t412;
  const Scalar mu_24_22_y = t673 + t674;
  const Scalar t675 = s_22 * mu_24_22_y + c_22 * t672;
  const Scalar t676 = s_23 * hu_23_a_y;
  const Scalar t677 = c_22 * t676 - s_22 * hu_24_t_x;
  const Scalar f_u_24_21_t_y = c_21 * t677 + s_21 * t673;
  const Scalar mu_24_22_z = t401 * t413 + hu_24_t_x + s_23 * t671;
  const Scalar f_u_24_22_a_z = c_22 * hu_24_t_x + s_22 * t676;
  const Scalar mu_24_21_y = mu_24_22_z - f_u_24_22_a_z;
  const Scalar mu_24_20_x = c_21 * mu_24_21_y - s_21 * t675 + Scalar(76.25) * f_u_24_21_t_y;
  const Scalar mu_24_21_z = t673 - c_22 * mu_24_22_y + s_22 * t672;
  const Scalar t678 = c_20 * mu_24_21_z + s_20 * mu_24_20_x;
  const Scalar f_u_24_21_t_x = c_21 * t673 - s_21 * t677;
  const Scalar t679 = c_20 * f_u_24_22_a_z + s_20 * f_u_24_21_t_x;
  const Scalar t680 = c_19 * f_u_24_21_t_y - s_19 * t679;
  const Scalar mu_24_20_z = -c_21 * t675 - s_21 * mu_24_21_y + Scalar(76.25) * f_u_24_21_t_x;
  const Scalar t681 = Scalar(60.0) * t680 - c_19 * t678 + s_19 * mu_24_20_z;
  const Scalar t682 = c_20 * mu_24_20_x - s_20 * mu_24_21_z;
  const Scalar t683 = t682 - Scalar(82.5) * t680;
  const Scalar mu_u_24_15_t_x = c_15 * t681 - s_15 * t683;
  const Scalar t684 = c_19 * t679 + s_19 * f_u_24_21_t_y;
  const Scalar t685 = c_20 * f_u_24_21_t_x - s_20 * f_u_24_22_a_z;
  const Scalar t686 = Scalar(60.0) * t684 - c_19 * mu_24_20_z - s_19 * t678 + Scalar(82.5) * t685;
  const Scalar t687 = t669 * t670 + c_14 * mu_u_24_15_t_x - s_14 * t686;
  const Scalar t688 = t674 - mu_u_25_24_t_y * t670;
  const Scalar t689 = Scalar(0.00011339132281129538) * t394 + Scalar(0.0253235000000002);
  const Scalar t690 = Scalar(1.0) / t689;
  const Scalar t691 = t688 * t690;
  const Scalar t692 = c_19 * t649 + s_19 * t644;
  const Scalar t693 = c_20 * t647 + s_20 * t642;
  const Scalar t694 = Scalar(82.5) * t693 - Scalar(60.0) * t692 - c_19 * t648 -
      s_19 * mu_u_23_20_t_x;
  const Scalar t695 = Scalar(707.7641729774637) * mu_u_25_24_t_y;
  const Scalar t696 = t687 * t691 - t669 * t695 + t652 + s_14 * t694;
  const Scalar b_25_24_22 = mu_24_22_z - t660 * t670;
  const Scalar t697 = b_25_24_22 * t691 + t660 * t695 + t426;
  const Scalar t698 = t688 * t691 + mu_u_25_24_t_y * t695 + mu_u_23_23_a_y;
  const Scalar t699 = Scalar(1.0) / t698;
  const Scalar t700 = t697 * t699;
  const Scalar t701 = c_19 * t634 + s_19 * t635;
  const Scalar t702 = c_20 * t633 + s_20 * f_u_22_22_a_z;
  const Scalar mu_22_15_z = s_19 * t631 - Scalar(60.0) * t701 + Scalar(82.5) * t702 + c_19 * t632;
  const Scalar t703 = b_25_24_22 * t690;
  const Scalar t704 = Scalar(707.7641729774637) * t660;
  const Scalar t705 = t669 * t704 - t687 * t703 + t696 * t700 + t640 + s_14 * mu_22_15_z;
  const Scalar b_25_24_21 = mu_24_21_z - t666 * t670;
  const Scalar t706 = -b_25_24_21 * t691 - t666 * t695 + t646;
  const Scalar t707 = t437 - t666 * t704 - b_25_24_21 * t703 - t706 * t700;
  const Scalar t708 = t660 * t704 - t697 * t700 + b_25_24_22 * t703 + t418;
  const Scalar t709 = Scalar(1.0) / t708;
  const Scalar t710 = t707 * t709;
  const Scalar f_u_21_19_t_x = s_20 * t491 - s_19 * t440;
  const Scalar mu_21_15_z = Scalar(60.0) * f_u_21_19_t_x + Scalar(82.5) * c_20 * t449 -
      c_19 * t450 + s_19 * t624;
  const Scalar t711 = t706 * t699;
  const Scalar t712 = b_25_24_21 * t690;
  const Scalar t713 = Scalar(707.7641729774637) * t666;
  const Scalar t714 = t669 * t713 - t687 * t712 - t696 * t711 + t705 * t710 +
      c_14 * mu_u_21_15_t_x + s_14 * mu_21_15_z;
  const Scalar b_25_24_20 = mu_24_20_z - mu_u_25_20_a_y * t670;
  const Scalar t715 = -b_25_24_20 * t691 - mu_u_25_20_a_y * t695 + t648;
  const Scalar t716 = -mu_u_25_20_a_y * t704 - t715 * t700 - b_25_24_20 * t703 + t632;
  const Scalar t717 = mu_u_25_20_a_y * t713 + b_25_24_20 * t712 - t715 * t711 - t716 * t710 + t450;
  const Scalar t718 = t707 * t710 - t666 * t713 - b_25_24_21 * t712 + t706 * t711 + t434;
  const Scalar t719 = Scalar(1.0) / t718;
  const Scalar t720 = t717 * t719;
  const Scalar mu_u_20_15_a_y = t451 + Scalar(82.5) * hu_20_t_x + c_19 * t620;
  const Scalar t721 = t716 * t709;
  const Scalar t722 = t715 * t699;
  const Scalar t723 = b_25_24_20 * t690;
  const Scalar t724 = Scalar(707.7641729774637) * mu_u_25_20_a_y;
  const Scalar t725 = t669 * t724 - t696 * t722 - t687 * t723 + t705 * t721 + t714 * t720 + t623 -
      s_14 * mu_u_20_15_a_y;
  const Scalar t726 = mu_u_25_20_t_y * t670 + t682;
  const Scalar b_24_23_19 = t726 * t691 - mu_u_25_20_t_y * t695 + mu_u_23_20_t_y;
  const Scalar t727 = mu_u_25_20_t_y * t704 + b_24_23_19 * t700 - t726 * t703 + t638;
  const Scalar t728 = mu_u_25_20_t_y * t713 - t726 * t712 - b_24_23_19 * t711 + t727 * t710 + t627;
  const Scalar t729 = mu_u_25_20_t_y * t724 - t726 * t723 - b_24_23_19 * t722 + t476 + t727 * t721 +
      t728 * t720;
  const Scalar t730 = mu_u_25_20_a_y * t724 + b_25_24_20 * t723 - t715 * t722 + t717 * t720 -
      t716 * t721 + t446;
  const Scalar t731 = Scalar(1.0) / t730;
  const Scalar t732 = t729 * t731;
  const Scalar t733 = t728 * t719;
  const Scalar t734 = t727 * t709;
  const Scalar t735 = b_24_23_19 * t699;
  const Scalar t736 = t726 * t690;
  const Scalar t737 = Scalar(707.7641729774637) * mu_u_25_20_t_y;
  const Scalar t738 = t696 * t735 - t669 * t737 - t687 * t736 + t705 * t734 - s_14 * t496 -
      t714 * t733 + t725 * t732 + c_14 * mu_u_19_15_t_x;
  const Scalar t739 = t686 - t668 * t670;
  const Scalar t740 = -t739 * t691 - t668 * t695 + t694;
  const Scalar b_23_22_15 = t668 * t704 + t740 * t700 + t739 * t703 + mu_22_15_z;
  const Scalar b_22_21_15 = t668 * t713 + t739 * t712 - t740 * t711 + b_23_22_15 * t710 +
      mu_21_15_z;
  const Scalar t741 = t740 * t722 - t668 * t724 - t739 * t723 - b_22_21_15 * t720 -
      b_23_22_15 * t721 + mu_u_20_15_a_y;
  const Scalar t742 = t668 * t737 - t740 * t735 - t739 * t736 - b_23_22_15 * t734 + t496 +
      b_22_21_15 * t733 + t741 * t732;
  const Scalar t743 = mu_u_25_20_t_y * t737 + t726 * t736 - b_24_23_19 * t735 - t727 * t734 -
      t729 * t732 + t728 * t733 + t466;
  const Scalar t744 = Scalar(1.0) / t743;
  const Scalar t745 = t742 * t744;
  const Scalar t746 = t614 * t603;
  const Scalar t747 = t741 * t731;
  const Scalar t748 = t613 * d_28;
  const Scalar t749 = b_22_21_15 * t719;
  const Scalar t750 = b_30_29_15 * t583;
  const Scalar t751 = b_23_22_15 * t709;
  const Scalar t752 = t612 * t574;
  const Scalar t753 = t740 * t699;
  const Scalar t754 = t611 * t566;
  const Scalar t755 = t739 * t690;
  const Scalar t756 = t545 * mu_u_32_14_t_y - t668 * t669;
  const Scalar mu_u_17_17_a_y = t459 - Scalar(0.03438);
  const Scalar t757 = mu_u_17_17_a_y - Scalar(113.25) * t470;
  const Scalar t758 = s_16 * t757 - s_17 * (t492 - t494);
  const Scalar t759 = c_17 * (Iu_18_a_yz - c_16 * t494);
  const Scalar t760 = t472 + c_16 * t757;
  const Scalar t761 = c_14 * (c_15 * t759 + s_15 * t758) - s_14 * t760;
  const Scalar t762 = Scalar(1.0) / mu_u_17_17_a_y;
  const Scalar t763 = Iu_18_a_yz * t762;
  const Scalar t764 = c_17 * t763;
  const Scalar t765 = Ic_16_zz - Scalar(0.75) * hu_16_a_z;
  const Scalar t766 = c_14 * (c_15 * t765 + s_15 * t482);
  const Scalar f_u_18_16_t_x = hu_18_a_z * t480 + s_16 * f_u_18_18_a_z;
  const Scalar t767 = Scalar(0.03408) * s_17 - Scalar(0.75) * f_u_18_16_t_x;
  const Scalar t768 = hu_18_a_z * t462 - c_16 * f_u_18_18_a_z;
  const Scalar t769 = Scalar(0.03408) * c_17;
  const Scalar t770 = Scalar(113.25) * t768 -
      (c_16 - Scalar(22.007042253521128) * hu_18_a_z) * t769;
  const Scalar mu_u_18_15_a_y = s_16 * t769 + Scalar(113.25) * f_u_18_16_t_x;
  const Scalar mu_u_18_14_a_z = c_14 * (c_15 * t767 - s_15 * t770) + s_14 * mu_u_18_15_a_y;
  const Scalar t771 = t761 * t764 + t766 + s_14 * t493 - s_17 * mu_u_18_14_a_z;
  const Scalar t772 = Iu_18_a_yz * t763;
  const Scalar b_17_16_16 = t772 + Ic_16_zz - t460 * (t772 + Scalar(0.03408));
  const Scalar t773 = Scalar(1.0) / b_17_16_16;
  const Scalar t774 = t493 - t760 * t764 - s_17 * mu_u_18_15_a_y;
  const Scalar t775 = t774 * t773;
  const Scalar t776 = t760 * t762;
  const Scalar t777 = Scalar(29.342723004694836) * mu_u_18_15_a_y;
  const Scalar t778 = t761 * t776 - Scalar(707.7641729774637) * t756 + b_32_31_13 * t754 -
      t572 * t752 - t687 * t755 - t696 * t753 + mu_u_18_14_a_z * t777 + t771 * t775 + t579 * t750 -
      t590 * t748 - t705 * t751 + t714 * t749 + t499 - t599 * t746 - t610 * t618 + t725 * t747 +
      t738 * t745 - s_14 * t488;
  const Scalar Iu_15_a_xy = c_15 * t498 + s_15 * t495;
  const Scalar t779 = c_15 * t542 - s_15 * mu_32_15_x;
  const Scalar t780 = t779 * t546 - s_15 * t557 + c_15 * t559;
  const Scalar t781 = t779 * t571 - t780 * t567 + c_15 * mu_30_15_y - s_15 * t531;
  const Scalar t782 = t779 * t578 - t780 * t577 + t781 * t575 + c_15 * mu_29_15_y - s_15 * t520;
  const Scalar t783 = t779 * t589 - t780 * t588 + t781 * t587 + t782 * t584 + c_15 * t510 -
      s_15 * t508;
  const Scalar t784 = t779 * t598 + t781 * t596 - t780 * t597 + t782 * t595 - t783 * t594 +
      c_15 * mu_27_15_y - s_15 * t505;
  const Scalar t785 = t779 * t609 + t780 * t608 - t781 * t607 - t782 * t606 + s_15 * t479 +
      t783 * t605 - t784 * t604 + c_15 * t502;
  const Scalar mu_u_25_15_t_y = c_15 * mu_25_15_y + s_15 * mu_25_15_x;
  const Scalar b_25_24_14 = mu_u_25_15_t_y * t670 + s_15 * t681 + c_15 * t683;
  const Scalar t786 = b_25_24_14 * t691 - mu_u_25_15_t_y * t695 + c_15 * mu_23_15_y + s_15 * t651;
  const Scalar t787 = mu_u_25_15_t_y * t704 - b_25_24_14 * t703 + t786 * t700 + c_15 * t639 +
      s_15 * t637;
  const Scalar t788 = mu_u_25_15_t_y * t713 - b_25_24_14 * t712 - t786 * t711 + t787 * t710 +
      c_15 * t628 + s_15 * t626;
  const Scalar t789 = mu_u_25_15_t_y * t724 - t786 * t722 - b_25_24_14 * t723 + t787 * t721 +
      t788 * t720 + c_15 * t622 + s_15 * t621;
  const Scalar t790 = mu_u_25_15_t_y * t737 + b_25_24_14 * t736 - t786 * t735 - t787 * t734 -
      s_15 * t477 + t788 * t733 - t789 * t732 + c_15 * t619;
  const Scalar t791 = t545 * t779 + t668 * mu_u_25_15_t_y;
  const Scalar t792 = c_15 * t758 - s_15 * t759;
  const Scalar t793 = s_15 * t767 + c_15 * t770;
  const Scalar t794 = t792 * t764 - s_15 * t765 + c_15 * t482 + s_17 * t793;
  const Scalar t795 = Scalar(707.7641729774637) * t791 + t781 * t752 - t786 * t753 - t792 * t776 -
      t780 * t754 - b_25_24_14 * t755 + t793 * t777 - t794 * t775 - t782 * t750 + t783 * t748 -
      t787 * t751 + t788 * t749 + Iu_15_a_xy + t784 * t746 - t785 * t618 + t789 * t747 -
      t790 * t745;
  const Scalar t796 = t545 * t545 + t668 * t668;
  const Scalar b_16_15_15 = t760 * t776 - Scalar(707.7641729774637) * t796 - t611 * t754 +
      t612 * t752 - t739 * t755 + t740 * t753 - mu_u_18_15_a_y * t777 - t613 * t748 -
      b_22_21_15 * t749 - t774 * t775 + b_30_29_15 * t750 + t615 * t618 + b_23_22_15 * t751 +
      t742 * t745 + t614 * t746 + t741 * t747 + t488;
  const Scalar t797 = Scalar(1.0) / b_16_15_15;
  const Scalar t798 = t795 * t797;
  const Scalar t799 = t785 * t617;
  const Scalar t800 = t790 * t744;
  const Scalar t801 = t784 * t603;
  const Scalar t802 = t789 * t731;
  const Scalar t803 = t783 * d_28;
  const Scalar t804 = t788 * t719;
  const Scalar t805 = t782 * t583;
  const Scalar t806 = t787 * t709;
  const Scalar t807 = t781 * t574;
  const Scalar t808 = t786 * t699;
  const Scalar t809 = t780 * t566;
  const Scalar t810 = b_25_24_14 * t690;
  const Scalar t811 = t779 * mu_u_32_14_t_y - mu_u_25_15_t_y * t669;
  const Scalar t812 = t794 * t773;
  const Scalar t813 = t792 * t762;
  const Scalar t814 = Scalar(29.342723004694836) * t793;
  const Scalar t815 = Scalar(707.7641729774637) * t811 - t572 * t807 + t696 * t808 - t761 * t813 +
      b_32_31_13 * t809 - t687 * t810 - mu_u_18_14_a_z * t814 - t579 * t805 + t705 * t806 +
      t771 * t812 + t590 * t803 - t599 * t801 - t714 * t804 + t725 * t802 - s_14 * Iu_15_a_xy +
      t610 * t799 - t738 * t800 + t501 - t778 * t798;
  const Scalar t816 = t779 * t779 + mu_u_25_15_t_y * mu_u_25_15_t_y;
  const Scalar t817 = Scalar(707.7641729774637) * t816 - t792 * t813 - t781 * t807 - t786 * t808 +
      t780 * t809 + b_25_24_14 * t810 + t793 * t814 + t794 * t812 - t782 * t805 - t787 * t806 +
      t783 * t803 - t784 * t801 + t788 * t804 - t789 * t802 - t785 * t799 - t790 * t800 +
      t795 * t798 + Scalar(0.8060099275533488) + t464 - t486;
  const Scalar t818 = Scalar(1.0) / t817;
  const Scalar t819 = t815 * t818;
  const Scalar t820 = t778 * t797;
  const Scalar t821 = t610 * t617;
  const Scalar t822 = t738 * t744;
  const Scalar t823 = t599 * t603;
  const Scalar t824 = t725 * t731;
  const Scalar t825 = t590 * d_28;
  const Scalar t826 = t714 * t719;
  const Scalar t827 = t579 * t583;
  const Scalar t828 = t705 * t709;
  const Scalar t829 = t572 * t574;
  const Scalar t830 = t696 * t699;
  const Scalar t831 = b_32_31_13 * t566;
  const Scalar t832 = t687 * t690;
  const Scalar t833 = mu_u_32_14_t_y * mu_u_32_14_t_y + t669 * t669;
  const Scalar t834 = t771 * t773;
  const Scalar t835 = t761 * t762;
  const Scalar t836 = Scalar(29.342723004694836) * mu_u_18_14_a_z;
  const Scalar t837 = Scalar(707.7641729774637) * t833 - t572 * t829 - t696 * t830 - t761 * t835 +
      b_32_31_13 * t831 + t687 * t832 + mu_u_18_14_a_z * t836 + t771 * t834 - t579 * t827 +
      t590 * t825 - t705 * t828 + t714 * t826 - t599 * t823 - t610 * t821 - t725 * t824 -
      t738 * t822 + Scalar(0.8028099275533488) - t815 * t819 + t500 + t778 * t820 + t487;
  const Scalar t838 = c_14 * qd_13;
  const Scalar t839 = c_15 * t838;
  const Scalar t840 = t839 - s_15 * qd_14;
  const Scalar t841 = t840 * t840;
  const Scalar t842 = s_14 * qd_13;
  const Scalar omega_15_z = qd_15 - t842;
  const Scalar t843 = omega_15_z * omega_15_z;
  const Scalar t844 = t841 - t843;
  const Scalar Uz_o_15_y = t838 * t838 + qd_14 * qd_14;
  const Scalar Uz_o_16_x = Uz_o_15_y - t844;
  const Scalar t845 = c_14 * c_15;
  const Scalar t846 = Scalar(2452.5) * t845;
  const Scalar t847 = Scalar(82.5) * Uz_o_16_x - t846;
  const Scalar t848 = s_15 * t838;
  const Scalar t849 = c_15 * qd_14;
  const Scalar omega_r_15_y = t848 + t849;
  const Scalar t850 = t840 * omega_r_15_y;
  const Scalar t851 = qd_14 * t838;
  const Scalar U_15_xy = t851 - t850;
  const Scalar t852 = Scalar(60.0) * U_15_xy;
  const Scalar t853 = t852 + t847;
  const Scalar t854 = t840 * omega_15_z;
  const Scalar t855 = (t839 - t484 * qd_14) * t842;
  const Scalar t856 = t854 + t855;
  const Scalar t857 = t854 + t856;
  const Scalar t858 = Scalar(2452.5) * s_14;
  const Scalar t859 = Scalar(82.5) * t857 - t858;
  const Scalar t860 = omega_r_15_y * omega_15_z;
  const Scalar t861 = (t848 + Scalar(2.0) * t849) * t842;
  const Scalar domega_15_x = t860 + t861;
  const Scalar U_15_zy = t860 + domega_15_x;
  const Scalar t862 = Scalar(60.0) * U_15_zy;
  const Scalar t863 = t862 + t859;
  const Scalar t864 = c_26 * t853 - s_26 * t863;
  const Scalar t865 = c_26 * t840 + s_26 * omega_15_z;
  const Scalar omega_26_z = qd_26 + omega_r_15_y;
  const Scalar t866 = t865 * omega_26_z;
  const Scalar domega_26_y = c_26 * U_15_xy - s_26 * U_15_zy + t866;
  const Scalar omega_r_27_x = c_27 * omega_26_z + s_27 * t865;
  const Scalar t867 = c_27 * t865 - s_27 * omega_26_z;
  const Scalar t868 = omega_r_27_x * t867;
  const Scalar U_27_xy = t868 + domega_26_y;
  const Scalar t869 = t851 + t850;
  const Scalar t870 = Scalar(2452.5) * c_14 * s_15;
  const Scalar t871 = Scalar(82.5) * t869 + t870;
  const Scalar t872 = t841 + t843;
  const Scalar t873 = Scalar(60.0) * t872;
  const Scalar t874 = t871 - t873;
  const Scalar t875 = Scalar(76.25) * U_27_xy - c_27 * t874 + s_27 * t864;
  const Scalar t876 = c_26 * t863 + s_26 * t853;
  const Scalar omega_r_27_a_z = c_26 * omega_15_z - s_26 * t840;
  const Scalar t877 = omega_r_27_a_z * omega_26_z;
  const Scalar t878 = s_26 * U_15_xy + c_26 * U_15_zy - Scalar(2.0) * t877;
  const Scalar t879 = t865 * omega_r_27_a_z;
  const Scalar t880 = t856 - t879;
  const Scalar omega_27_z = qd_27 + omega_r_27_a_z;
  const Scalar t881 = t867 * omega_27_z;
  const Scalar t882 = c_27 * t880 - s_27 * t878 + Scalar(2.0) * t881;
  const Scalar t883 = t876 - Scalar(76.25) * t882;
  const Scalar t884 = c_28 * t883 - s_28 * t875;
  const Scalar omega_r_28_x = c_28 * omega_27_z + s_28 * omega_r_27_x;
  const Scalar t885 = omega_r_28_x * omega_r_28_x;
  const Scalar omega_28_z = qd_28 + t867;
  const Scalar t886 = omega_28_z * omega_28_z;
  const Scalar t887 = t885 - t886;
  const Scalar t888 = omega_r_27_x * omega_r_27_x + omega_27_z * omega_27_z;
  const Scalar t889 = (t888 - t887) - t884;
  const Scalar t890 = omega_r_28_x * omega_28_z;
  const Scalar t891 = s_28 * U_27_xy + c_28 * t882 - t890;
  const Scalar ddp_o_28_y = Scalar(76.25) * t888 - c_27 * t864 - s_27 * t874;
  const Scalar ddp_o_29_z = t890 - t891 + ddp_o_28_y;
  const Scalar t892 = s_29 * ddp_o_29_z + c_29 * t889;
  const Scalar t893 = c_29 * omega_r_28_x - s_29 * omega_28_z;
  const Scalar t894 = t893 * t893;
  const Scalar t895 = c_28 * omega_r_27_x - s_28 * omega_27_z;
  const Scalar omega_29_z = qd_29 + t895;
  const Scalar t896 = omega_29_z * omega_29_z;
  const Scalar t897 = t885 + t886 - t894 + t896;
  const Scalar omega_r_30_a_z = c_29 * omega_28_z + s_29 * omega_r_28_x;
  const Scalar t898 = t893 * omega_r_30_a_z;
  const Scalar t899 = t898 + t891;
  const Scalar ddp_o_30_x = t897 - Scalar(59.75) * t899 - t892;
  const Scalar Uz_28_y = c_28 * U_27_xy - s_28 * t882;
  const Scalar t900 = t895 * omega_28_z;
  const Scalar t901 = Uz_28_y - Scalar(2.0) * t900;
  const Scalar t902 = omega_r_27_x * omega_27_z;
  const Scalar t903 = s_27 * t880 + t902 + c_27 * t878;
  const Scalar t904 = omega_r_28_x * t895;
  const Scalar t905 = t904 + t903;
  const Scalar t906 = t893 * omega_29_z;
  const Scalar t907 = c_29 * t905 - t906 + s_29 * t901;
  const Scalar t908 = t906 - t907;
  const Scalar t909 = omega_r_30_a_z * omega_29_z;
  const Scalar Uz_o_30_z = c_29 * t901 - s_29 * t905 + Scalar(2.0) * t909;
  const Scalar t910 = c_28 * t875 + s_28 * t883;
  const Scalar t911 = t903 - t904;
  const Scalar t912 = t911 + t910;
  const Scalar t913 = t908 + Scalar(59.75) * Uz_o_30_z + t912;
  const Scalar t914 = c_30 * t913 + s_30 * ddp_o_30_x;
  const Scalar t915 = c_29 * ddp_o_29_z - s_29 * t889;
  const Scalar Uz_o_30_y = t894 + t896;
  const Scalar t916 = t891 - t898 + Scalar(59.75) * Uz_o_30_y + t915;
  const Scalar t917 = c_31 * t914 - s_31 * t916;
  const Scalar ddp_31_a_z = c_30 * ddp_o_30_x - s_30 * t913;
  const Scalar t918 = c_32 * ddp_31_a_z - s_32 * t917;
  const Scalar omega_r_31_a_z = c_30 * t893 + s_30 * omega_29_z;
  const Scalar omega_30_z = qd_30 + omega_r_30_a_z;
  const Scalar t919 = omega_r_31_a_z * omega_30_z;
  const Scalar t920 = c_30 * t899 + s_30 * Uz_o_30_z - Scalar(2.0) * t919;
  const Scalar omega_r_30_x = c_30 * omega_29_z - s_30 * t893;
  const Scalar t921 = omega_r_30_x * omega_r_31_a_z;
  const Scalar t922 = t907 - t921;
  const Scalar t923 = c_31 * omega_30_z - s_31 * omega_r_30_x;
  const Scalar omega_31_z = qd_31 + omega_r_31_a_z;
  const Scalar t924 = t923 * omega_31_z;
  const Scalar t925 = c_31 * t920 - s_31 * t922 + Scalar(2.0) * t924;
  const Scalar t926 = omega_r_30_x * omega_30_z;
  const Scalar t927 = -s_30 * t899 - t926 + c_30 * Uz_o_30_z;
  const Scalar omega_r_31_x = c_31 * omega_r_30_x + s_31 * omega_30_z;
  const Scalar t928 = omega_r_31_x * t923;
  const Scalar t929 = t928 + t927;
  const Scalar t930 = c_32 * t925 + s_32 * t929;
  const Scalar t931 = omega_r_31_x * omega_31_z;
  const Scalar t932 = t931 + c_31 * t922 + s_31 * t920;
  const Scalar omega_r_32_x = c_32 * omega_31_z + s_32 * omega_r_31_x;
  const Scalar t933 = c_32 * omega_r_31_x - s_32 * omega_31_z;
  const Scalar t934 = omega_r_32_x * t933;
  const Scalar t935 = Scalar(0.0007482) * t930 - Scalar(0.0005096) * t934 +
      Scalar(0.0014129000000002) * t932 - Scalar(0.0000376) * t918;
  const Scalar t936 = t935 + tau_32;
  const Scalar ddp_31_y = c_31 * t916 + s_31 * t914;
  const Scalar omega_32_z = qd_32 + t923;
  const Scalar t937 = omega_r_32_x * omega_r_32_x + omega_32_z * omega_32_z;
  const Scalar t938 = omega_r_31_x * omega_r_31_x + omega_31_z * omega_31_z;
  const Scalar U_32_yy_zz = t938 - t937;
  const Scalar t939 = t933 * omega_32_z;
  const Scalar t940 = Scalar(0.0007482) * U_32_yy_zz - Scalar(0.0009033000000002) * t939 +
      Scalar(0.0000376) * ddp_31_y;
  const Scalar t941 = t934 + t932;
  const Scalar t942 = Scalar(0.0005096) * t930 + Scalar(0.0007482) * t941 -
      Scalar(0.0019225000000002) * omega_r_32_x * omega_32_z;
  const Scalar t943 = Scalar(-0.0253235000000002) * t927;
  const Scalar t944 = s_32 * t942 + c_32 * t940 + Scalar(0.0250035000000002) * t928 - t943 +
      Scalar(0.0007608) * t917;
  const Scalar t945 = t944 - t546 * t936 + tau_31;
  const Scalar t946 = t935 + Scalar(0.0253235000000002) * t931 - Scalar(0.0250035000000002) * t932;
  const Scalar t947 = s_32 * t940 - c_32 * t942 - Scalar(0.0503270000000004) * t924 +
      Scalar(0.0007608) * ddp_31_a_z;
  const Scalar t948 = Scalar(0.0259635000000002) * t907 - Scalar(0.0253235000000002) * t921 +
      c_31 * t946 + s_31 * t947;
  const Scalar t949 = t948 - t567 * t945 - t571 * t936 + tau_30;
  const Scalar t950 = Scalar(0.0512870000000004) * t919 - s_31 * t946 + c_31 * t947;
  const Scalar t951 = Scalar(0.0007608) * t929 - Scalar(0.0000376) * (c_32 * t937 - s_32 * t941);
  const Scalar t952 = c_32 * t929 - s_32 * t925 - Scalar(2.0) * t939;
  const Scalar f_31_y = Scalar(0.0000376) * t952 + Scalar(0.0007608) * t938;
  const Scalar t953 = s_31 * f_31_y + c_31 * t951 + Scalar(0.0001312) * t914;
  const Scalar t954 = s_32 * t937 + c_32 * t941;
  const Scalar t955 = Scalar(-0.0000376) * t954 - Scalar(0.0007608) * t925 +
      Scalar(0.0001312) * ddp_31_a_z;
  const Scalar f_u_30_t_x = c_30 * t955 + s_30 * t953;
  const Scalar t956 = Scalar(0.0259635000000002) * t926 - t943 - t944;
  const Scalar t957 = c_31 * f_31_y - s_31 * t951 + Scalar(0.0001312) * t916;
  const Scalar t958 = Scalar(-0.00278) * (t897 - Uz_o_30_y) - t957 + c_30 * t950 - s_30 * t956 +
      Scalar(0.2419864999999998) * t898 + Scalar(0.2386464999999998) * t891 +
      Scalar(0.00438) * t892 + Scalar(59.75) * f_u_30_t_x;
  const Scalar t959 = tau_29 - t578 * t936 - t577 * t945 + t575 * t949 + t958;
  const Scalar t960 = c_30 * t953 - s_30 * t955;
  const Scalar t961 = Scalar(0.00278) * t908 + c_30 * t956 + s_30 * t950 +
      Scalar(0.4806329999999996) * t909 + Scalar(0.00438) * t912 - Scalar(59.75) * t960;
  const Scalar t962 = Scalar(0.00278) * Uz_o_30_z - t960 + t948 +
      Scalar(0.2386464999999998) * t906 + Scalar(0.2419864999999998) * t907;
  const Scalar f_29_z = Scalar(0.00438) * Uz_o_30_z + Scalar(0.000144) * t912 - t960;
  const Scalar t963 = f_29_z - Scalar(0.0023) * Uz_28_y + Scalar(0.2401964999999998) * t904 +
      Scalar(0.2323364999999998) * t903 - c_29 * t962 - s_29 * t961;
  const Scalar t964 = t589 * t936 - t584 * t959 - tau_28 + t588 * t945 - t587 * t949 + t963;
  const Scalar t965 = Scalar(0.0023) * t911 + Scalar(0.4725329999999996) * t900 + s_29 * t962 -
      c_29 * t961;
  const Scalar t966 = Scalar(0.00438) * t899 + Scalar(0.000144) * t892 + f_u_30_t_x;
  const Scalar f_29_y = Scalar(0.00438) * Uz_o_30_y + Scalar(0.000144) * t915 - t957;
  const Scalar t967 = Scalar(0.0000999344262295082) * t884 + c_29 * t966 - s_29 * f_29_y;
  const Scalar t968 = Scalar(0.0000999344262295082) * t910 - f_29_z;
  const Scalar t969 = c_28 * t968 - s_28 * t967;
  const Scalar t970 = c_29 * f_29_y + s_29 * t966;
  const Scalar mu_28_y = t970 - Scalar(0.0023) * t887 + Scalar(0.2323364999999998) * t890 +
      Scalar(0.2401964999999998) * t891 - t958;
  const Scalar t971 = Scalar(0.2670564999999998) * domega_26_y;
  const Scalar t972 = Scalar(0.2690164999999998) * t868 + t971 - c_28 * t965 - s_28 * mu_28_y -
      Scalar(76.25) * t969;
  const Scalar t973 = t598 * t936 - tau_27 - t596 * t949 - t594 * t964 + t597 * t945 - t595 * t959 +
      t972;
  const Scalar t974 = c_28 * t967 + s_28 * t968;
  const Scalar t975 = Scalar(0.5360729999999996) * t881 - c_28 * mu_28_y + s_28 * t965 +
      Scalar(76.25) * t974;
  const Scalar mu_27_y = Scalar(0.2670564999999998) * t902 - Scalar(0.2690164999999998) * t903 +
      t963;
  const Scalar t976 = Scalar(-0.2650964999999998) * t856;
  const Scalar t977 = Scalar(0.2670564999999998) * t879 + t976 - s_27 * mu_27_y - c_27 * t975;
  const Scalar t978 = t608 * t945 - tau_26 - t609 * t936 - t607 * t949 - t606 * t959 - t605 * t964 +
      t977 + t604 * t973;
  const Scalar t979 = t847 - t852;
  const Scalar t980 = t859 - t862;
  const Scalar t981 = c_19 * t979 - s_19 * t980;
  const Scalar t982 = c_19 * t840 + s_19 * omega_15_z;
  const Scalar omega_19_z = qd_19 + omega_r_15_y;
  const Scalar t983 = t982 * omega_19_z;
  const Scalar domega_19_y = c_19 * U_15_xy - s_19 * U_15_zy + t983;
  const Scalar omega_r_20_x = c_20 * omega_19_z + s_20 * t982;
  const Scalar t984 = c_20 * t982 - s_20 * omega_19_z;
  const Scalar t985 = omega_r_20_x * t984;
  const Scalar U_20_xy = t985 + domega_19_y;
  const Scalar t986 = t873 + t871;
  const Scalar t987 = Scalar(76.25) * U_20_xy - c_20 * t986 + s_20 * t981;
  const Scalar t988 = c_19 * t980 + s_19 * t979;
  const Scalar omega_r_20_a_z = c_19 * omega_15_z - s_19 * t840;
  const Scalar t989 = omega_r_20_a_z * omega_19_z;
  const Scalar t990 = s_19 * U_15_xy + c_19 * U_15_zy - Scalar(2.0) * t989;
  const Scalar t991 = t982 * omega_r_20_a_z;
  const Scalar t992 = t856 - t991;
  const Scalar omega_20_z = qd_20 + omega_r_20_a_z;
  const Scalar t993 = t984 * omega_20_z;
  const Scalar t994 = c_20 * t992 - s_20 * t990 + Scalar(2.0) * t993;
  const Scalar t995 = t988 - Scalar(76.25) * t994;
  const Scalar t996 = c_21 * t995 - s_21 * t987;
  const Scalar omega_r_21_x = c_21 * omega_20_z + s_21 * omega_r_20_x;
  const Scalar t997 = omega_r_21_x * omega_r_21_x;
  const Scalar omega_21_z = qd_21 + t984;
  const Scalar t998 = omega_21_z * omega_21_z;
  const Scalar t999 = t997 - t998;
  const Scalar t1000 = omega_r_20_x * omega_r_20_x + omega_20_z * omega_20_z;
  const Scalar t1001 = (t1000 - t999) - t996;
  const Scalar t1002 = omega_r_21_x * omega_21_z;
  const Scalar t1003 = s_21 * U_20_xy + c_21 * t994 - t1002;
  const Scalar ddp_o_21_y = Scalar(76.25) * t1000 - c_20 * t981 - s_20 * t986;
  const Scalar ddp_o_22_z = t1002 - t1003 + ddp_o_21_y;
  const Scalar t1004 = s_22 * ddp_o_22_z + c_22 * t1001;
  const Scalar t1005 = c_22 * omega_r_21_x - s_22 * omega_21_z;
  const Scalar t1006 = t1005 * t1005;
  const Scalar t1007 = c_21 * omega_r_20_x - s_21 * omega_20_z;
  const Scalar omega_22_z = qd_22 + t1007;
  const Scalar t1008 = omega_22_z * omega_22_z;
  const Scalar t1009 = t997 + t998 - t1006 + t1008;
  const Scalar omega_r_23_a_z = c_22 * omega_21_z + s_22 * omega_r_21_x;
  const Scalar t1010 = t1005 * omega_r_23_a_z;
  const Scalar t1011 = t1010 + t1003;
  const Scalar ddp_o_23_x = t1009 - Scalar(59.75) * t1011 - t1004;
  const Scalar Uz_21_y = c_21 * U_20_xy - s_21 * t994;
  const Scalar t1012 = t1007 * omega_21_z;
  const Scalar t1013 = Uz_21_y - Scalar(2.0) * t1012;
  const Scalar t1014 = omega_r_20_x * omega_20_z;
  const Scalar t1015 = s_20 * t992 + t1014 + c_20 * t990;
  const Scalar t1016 = omega_r_21_x * t1007;
  const Scalar t1017 = t1016 + t1015;
  const Scalar t1018 = t1005 * omega_22_z;
  const Scalar t1019 = c_22 * t1017 - t1018 + s_22 * t1013;
  const Scalar t1020 = t1018 - t1019;
  const Scalar t1021 = omega_r_23_a_z * omega_22_z;
  const Scalar Uz_o_23_z = c_22 * t1013 - s_22 * t1017 + Scalar(2.0) * t1021;
  const Scalar t1022 = c_21 * t987 + s_21 * t995;
  const Scalar t1023 = t1015 - t1016;
  const Scalar t1024 = t1023 + t1022;
  const Scalar t1025 = t1020 + Scalar(59.75) * Uz_o_23_z + t1024;
  const Scalar t1026 = c_23 * t1025 + s_23 * ddp_o_23_x;
  const Scalar t1027 = c_22 * ddp_o_22_z - s_22 * t1001;
  const Scalar Uz_o_23_y = t1006 + t1008;
  const Scalar t1028 = t1003 - t1010 + Scalar(59.75) * Uz_o_23_y + t1027;
  const Scalar t1029 = c_24 * t1026 - s_24 * t1028;
  const Scalar ddp_24_a_z = c_23 * ddp_o_23_x - s_23 * t1025;
  const Scalar t1030 = c_25 * ddp_24_a_z - s_25 * t1029;
  const Scalar omega_r_24_a_z = c_23 * t1005 + s_23 * omega_22_z;
  const Scalar omega_23_z = qd_23 + omega_r_23_a_z;
  const Scalar t1031 = omega_r_24_a_z * omega_23_z;
  const Scalar t1032 = c_23 * t1011 + s_23 * Uz_o_23_z - Scalar(2.0) * t1031;
  const Scalar omega_r_23_x = c_23 * omega_22_z - s_23 * t1005;
  const Scalar t1033 = omega_r_23_x * omega_r_24_a_z;
  const Scalar t1034 = t1019 - t1033;
  const Scalar t1035 = c_24 * omega_23_z - s_24 * omega_r_23_x;
  const Scalar omega_24_z = qd_24 + omega_r_24_a_z;
  const Scalar t1036 = t1035 * omega_24_z;
  const Scalar t1037 = c_24 * t1032 - s_24 * t1034 + Scalar(2.0) * t1036;
  const Scalar t1038 = omega_r_23_x * omega_23_z;
  const Scalar t1039 = -s_23 * t1011 - t1038 + c_23 * Uz_o_23_z;
  const Scalar omega_r_24_x = c_24 * omega_r_23_x + s_24 * omega_23_z;
  const Scalar t1040 = omega_r_24_x * t1035;
  const Scalar t1041 = t1040 + t1039;
  const Scalar t1042 = c_25 * t1037 + s_25 * t1041;
  const Scalar t1043 = omega_r_24_x * omega_24_z;
  const Scalar t1044 = t1043 + c_24 * t1034 + s_24 * t1032;
  const Scalar omega_r_25_x = c_25 * omega_24_z + s_25 * omega_r_24_x;
  const Scalar t1045 = c_25 * omega_r_24_x - s_25 * omega_24_z;
  const Scalar t1046 = omega_r_25_x * t1045;
  const Scalar t1047 = Scalar(-0.0005096) * t1046 - Scalar(0.0007482) * t1042 +
      Scalar(0.0014129000000002) * t1044 + Scalar(0.0000376) * t1030;
  const Scalar t1048 = t1047 + tau_25;
  const Scalar ddp_24_y = c_24 * t1028 + s_24 * t1026;
  const Scalar omega_25_z = qd_25 + t1035;
  const Scalar t1049 = omega_r_25_x * omega_r_25_x + omega_25_z * omega_25_z;
  const Scalar t1050 = omega_r_24_x * omega_r_24_x + omega_24_z * omega_24_z;
  const Scalar U_25_yy_zz = t1050 - t1049;
  const Scalar t1051 = t1045 * omega_25_z;
  const Scalar N_25_x = Scalar(0.0009033000000002) * t1051 + Scalar(0.0007482) * U_25_yy_zz +
      Scalar(0.0000376) * ddp_24_y;
  const Scalar t1052 = t1046 + t1044;
  const Scalar t1053 = Scalar(0.0005096) * t1042 - Scalar(0.0007482) * t1052 -
      Scalar(0.0019225000000002) * omega_r_25_x * omega_25_z;
  const Scalar t1054 = Scalar(-0.0253235000000002) * t1039;
  const Scalar t1055 = s_25 * t1053 - c_25 * N_25_x + Scalar(0.0250035000000002) * t1040 - t1054 +
      Scalar(0.0007608) * t1029;
  const Scalar t1056 = t1055 + t670 * t1048 + tau_24;
  const Scalar t1057 = t1047 + Scalar(0.0253235000000002) * t1043 -
      Scalar(0.0250035000000002) * t1044;
  const Scalar t1058 = -c_25 * t1053 - s_25 * N_25_x - Scalar(0.0503270000000004) * t1036 +
      Scalar(0.0007608) * ddp_24_a_z;
  const Scalar t1059 = Scalar(0.0259635000000002) * t1019 - Scalar(0.0253235000000002) * t1033 +
      c_24 * t1057 + s_24 * t1058;
  const Scalar t1060 = t691 * t1056 + t1059 - t695 * t1048 + tau_23;
  const Scalar t1061 = Scalar(0.0512870000000004) * t1031 - s_24 * t1057 + c_24 * t1058;
  const Scalar t1062 = Scalar(0.0000376) * (c_25 * t1049 - s_25 * t1052) +
      Scalar(0.0007608) * t1041;
  const Scalar t1063 = c_25 * t1041 - s_25 * t1037 - Scalar(2.0) * t1051;
  const Scalar f_24_y = Scalar(0.0007608) * t1050 - Scalar(0.0000376) * t1063;
  const Scalar t1064 = s_24 * f_24_y + c_24 * t1062 + Scalar(0.0001312) * t1026;
  const Scalar t1065 = s_25 * t1049 + c_25 * t1052;
  const Scalar t1066 = Scalar(0.0000376) * t1065 - Scalar(0.0007608) * t1037 +
      Scalar(0.0001312) * ddp_24_a_z;
  const Scalar f_u_23_t_x = c_23 * t1066 + s_23 * t1064;
  const Scalar t1067 = Scalar(0.0259635000000002) * t1038 - t1054 - t1055;
  const Scalar t1068 = c_24 * f_24_y - s_24 * t1062 + Scalar(0.0001312) * t1028;
  const Scalar t1069 = Scalar(-0.00278) * (t1009 - Uz_o_23_y) - t1068 + c_23 * t1061 -
      s_23 * t1067 + Scalar(0.2419864999999998) * t1010 + Scalar(0.2386464999999998) * t1003 +
      Scalar(0.00438) * t1004 + Scalar(59.75) * f_u_23_t_x;
  const Scalar t1070 = tau_22 + t704 * t1048 - t703 * t1056 + t700 * t1060 + t1069;
  const Scalar t1071 = c_23 * t1064 - s_23 * t1066;
  const Scalar t1072 = Scalar(0.00278) * t1020 + c_23 * t1067 + s_23 * t1061 +
      Scalar(0.4806329999999996) * t1021 + Scalar(0.00438) * t1024 - Scalar(59.75) * t1071;
  const Scalar t1073 = Scalar(0.00278) * Uz_o_23_z - t1071 + t1059 +
      Scalar(0.2386464999999998) * t1018 + Scalar(0.2419864999999998) * t1019;
  const Scalar f_22_z = Scalar(0.00438) * Uz_o_23_z + Scalar(0.000144) * t1024 - t1071;
  const Scalar t1074 = f_22_z - Scalar(0.0023) * Uz_21_y + Scalar(0.2401964999999998) * t1016 +
      Scalar(0.2323364999999998) * t1015 - c_22 * t1073 - s_22 * t1072;
  const Scalar t1075 = t712 * t1056 - t710 * t1070 - tau_21 - t713 * t1048 + t711 * t1060 + t1074;
  const Scalar t1076 = Scalar(0.0023) * t1023 + Scalar(0.4725329999999996) * t1012 + s_22 * t1073 -
      c_22 * t1072;
  const Scalar t1077 = Scalar(0.00438) * t1011 + Scalar(0.000144) * t1004 + f_u_23_t_x;
  const Scalar f_22_y = Scalar(0.00438) * Uz_o_23_y + Scalar(0.000144) * t1027 - t1068;
  const Scalar t1078 = Scalar(0.0000999344262295082) * t996 + c_22 * t1077 - s_22 * f_22_y;
  const Scalar t1079 = Scalar(0.0000999344262295082) * t1022 - f_22_z;
  const Scalar t1080 = c_21 * t1079 - s_21 * t1078;
  const Scalar t1081 = c_22 * f_22_y + s_22 * t1077;
  const Scalar mu_21_y = t1081 - Scalar(0.0023) * t999 + Scalar(0.2323364999999998) * t1002 +
      Scalar(0.2401964999999998) * t1003 - t1069;
  const Scalar t1082 = Scalar(0.2670564999999998) * domega_19_y;
  const Scalar t1083 = Scalar(0.2690164999999998) * t985 + t1082 - c_21 * t1076 - s_21 * mu_21_y -
      Scalar(76.25) * t1080;
  const Scalar t1084 = t722 * t1060 - tau_20 - t724 * t1048 + t720 * t1075 + t723 * t1056 -
      t721 * t1070 + t1083;
  const Scalar t1085 = c_21 * t1078 + s_21 * t1079;
  const Scalar t1086 = Scalar(0.5360729999999996) * t993 - c_21 * mu_21_y + s_21 * t1076 +
      Scalar(76.25) * t1085;
  const Scalar mu_20_y = Scalar(0.2670564999999998) * t1014 - Scalar(0.2690164999999998) * t1015 +
      t1074;
  const Scalar t1087 = Scalar(0.2670564999999998) * t991 + t976 - s_20 * mu_20_y - c_20 * t1086;
  const Scalar t1088 = t737 * t1048 - tau_19 + t736 * t1056 - t735 * t1060 - t734 * t1070 -
      t733 * t1075 + t1087 + t732 * t1084;
  const Scalar mu_26_x = Scalar(0.5321529999999997) * t877 - c_27 * mu_27_y + s_27 * t975;
  const Scalar mu_19_x = Scalar(0.5321529999999997) * t989 - c_20 * mu_20_y + s_20 * t1086;
  const Scalar f_28_z = Scalar(0.0000999344262295082) * ddp_o_28_y - t970;
  const Scalar t1089 = Scalar(0.00016042921013412816) * t864 - c_27 * f_28_z + s_27 * t969;
  const Scalar f_21_z = Scalar(0.0000999344262295082) * ddp_o_21_y - t1081;
  const Scalar t1090 = Scalar(0.000044065573770491804) * t981 - c_20 * f_21_z + s_20 * t1080;
  const Scalar t1091 = Scalar(0.00016042921013412816) * t876 + t974;
  const Scalar t1092 = Scalar(0.000044065573770491804) * t988 + t1085;
  const Scalar t1093 = c_26 * t1089 + s_26 * t1091 - c_19 * t1090 - s_19 * t1092;
  const Scalar t1094 = Scalar(0.2650964999999998) * t866 - t971 + t972;
  const Scalar t1095 = Scalar(0.2650964999999998) * t983 - t1082 + t1083;
  const Scalar t1096 = Scalar(0.000044065573770491804) * t986 +
      Scalar(0.00016042921013412816) * t874 - s_27 * f_28_z - s_20 * f_21_z - c_27 * t969 -
      c_20 * t1080;
  const Scalar omega_r_17_a_z = s_16 * omega_r_15_y + c_16 * omega_15_z;
  const Scalar omega_16_z = qd_16 + t840;
  const Scalar t1097 = omega_r_17_a_z * omega_16_z;
  const Scalar t1098 = s_16 * t869 + c_16 * t857 - Scalar(2.0) * t1097;
  const Scalar t1099 = c_16 * omega_r_15_y - s_16 * omega_15_z;
  const Scalar t1100 = t1099 * omega_r_17_a_z;
  const Scalar U_16_xy = domega_15_x - t1100;
  const Scalar omega_r_17_y = c_17 * t1099 + s_17 * omega_16_z;
  const Scalar omega_17_z = qd_17 + omega_r_17_a_z;
  const Scalar t1101 = omega_r_17_y * omega_17_z;
  const Scalar U_17_zy = c_17 * U_16_xy + s_17 * t1098 + Scalar(2.0) * t1101;
  const Scalar t1102 = t1099 * omega_16_z;
  const Scalar domega_16_y = c_16 * t869 - s_16 * t857 - t1102;
  const Scalar t1103 = c_17 * omega_16_z - s_17 * t1099;
  const Scalar t1104 = t1103 * omega_r_17_y;
  const Scalar U_17_xy = domega_16_y - t1104;
  const Scalar t1105 = c_18 * omega_17_z - s_18 * t1103;
  const Scalar omega_18_z = qd_18 + omega_r_17_y;
  const Scalar t1106 = t1105 * omega_18_z;
  const Scalar domega_18_y = s_18 * U_17_xy + c_18 * U_17_zy - t1106;
  const Scalar t1107 = t1106 - domega_18_y;
  const Scalar t1108 = Scalar(0.75) * Uz_o_15_y + Scalar(113.25) * t857 - t858;
  const Scalar ddp_o_16_y = Scalar(0.75) * t861 + Scalar(113.25) * t869 + t870;
  const Scalar t1109 = c_16 * ddp_o_16_y - s_16 * t1108;
  const Scalar t1110 = Scalar(0.75) * t855 - Scalar(113.25) * Uz_o_16_x + t846;
  const Scalar t1111 = c_17 * t1109 + s_17 * t1110;
  const Scalar t1112 = c_18 * t1103 + s_18 * omega_17_z;
  const Scalar t1113 = t1112 * omega_18_z;
  const Scalar t1114 = Scalar(0.0022) * t1107 + Scalar(0.00088) * t1111 + Scalar(0.05808) * t1113;
  const Scalar t1115 = c_18 * U_17_xy - s_18 * U_17_zy + Scalar(2.0) * t1113;
  const Scalar t1116 = Scalar(0.0022) * t1115 + Scalar(0.00008) * t1111 + Scalar(0.03408) * t1106 +
      Scalar(0.024) * domega_18_y;
  const Scalar mu_17_x = Scalar(0.06826) * t1101 - c_18 * t1116 - s_18 * t1114;
  const Scalar t1117 = c_17 * t1110 - s_17 * t1109;
  const Scalar t1118 = c_16 * t1108 + s_16 * ddp_o_16_y;
  const Scalar t1119 = c_18 * t1118 - s_18 * t1117;
  const Scalar t1120 = c_18 * t1117 + s_18 * t1118;
  const Scalar t1121 = t1105 * t1105;
  const Scalar t1122 = omega_18_z * omega_18_z;
  const Scalar t1123 = t1103 * t1103 - t1121 + omega_17_z * omega_17_z + t1122;
  const Scalar t1124 = t1121 + t1122;
  const Scalar t1125 = t1103 * omega_17_z;
  const Scalar t1126 = t1125 - s_17 * U_16_xy + c_17 * t1098;
  const Scalar t1127 = t1105 * t1112;
  const Scalar t1128 = Scalar(-0.0022) * (t1123 - t1124) - Scalar(0.00008) * t1120 +
      Scalar(0.024) * t1127 + Scalar(0.03408) * t1126 + Scalar(0.00088) * t1119;
  const Scalar mu_17_y = Scalar(0.03438) * t1125 - Scalar(0.03388) * t1126 + t1128;
  const Scalar t1129 = Scalar(0.069385) * t1097 - c_17 * mu_17_y - s_17 * mu_17_x;
  const Scalar t1130 = Scalar(0.00008) * t1107 + Scalar(0.00088) * t1115;
  const Scalar t1131 = Scalar(0.00008) * (t1126 - t1127) + Scalar(0.00088) * t1124;
  const Scalar t1132 = Scalar(0.00008) * t1123 - Scalar(0.00088) * (t1127 + t1126);
  const Scalar t1133 = c_18 * t1131 - s_18 * t1132;
  const Scalar t1134 = c_17 * t1130 + s_17 * t1133 + Scalar(0.00004711699779249448) * t1109;
  const Scalar t1135 = -c_18 * t1132 - s_18 * t1131 + Scalar(0.00004711699779249448) * t1118;
  const Scalar f_u_16_t_x = c_16 * t1134 + s_16 * t1135;
  const Scalar t1136 = Scalar(0.03438) * domega_16_y;
  const Scalar t1137 = Scalar(0.03388) * t1104 + s_18 * t1116 - t1136 - c_18 * t1114;
  const Scalar t1138 = Scalar(0.035005) * t1102 + t1136 + t1137;
  const Scalar mu_15_z = Scalar(0.048) * t861 + c_16 * t1138 + s_16 * t1129 +
      Scalar(0.9829845909094235) * t851 - Scalar(0.7225529242417575) * t850 -
      Scalar(17.12290909090909) * t845 + Scalar(0.576) * (Uz_o_16_x - t872) -
      Scalar(113.25) * f_u_16_t_x + c_26 * t1094 - s_26 * mu_26_x + c_19 * t1095 - s_19 * mu_19_x -
      Scalar(60.0) * t1093 - Scalar(82.5) * t1096;
  const Scalar t1139 = t545 * t936 - t668 * t1048;
  const Scalar mu_u_16_x = Scalar(0.035005) * domega_15_x - Scalar(0.03438) * t1100 +
      c_17 * mu_17_x - s_17 * mu_17_y;
  const Scalar t1140 = t1137 - tau_17;
  const Scalar t1141 = t1128 - tau_18;
  const Scalar y_17_16 = mu_u_16_x + t764 * t1140 + s_17 * t1141 + tau_16;
  const Scalar t1142 = -tau_15 - t776 * t1140 - Scalar(707.7641729774637) * t1139 - t754 * t945 +
      t752 * t949 - t748 * t964 - t755 * t1056 - t753 * t1060 - t749 * t1075 + t777 * t1141 -
      t750 * t959 - t618 * t978 - t751 * t1070 - t745 * t1088 - t775 * y_17_16 - t746 * t973 -
      t747 * t1084 + mu_15_z;
  const Scalar t1143 = c_26 * t1091 - s_26 * t1089;
  const Scalar t1144 = c_19 * t1092 - s_19 * t1090;
  const Scalar t1145 = c_16 * t1135 - s_16 * t1134;
  const Scalar t1146 = s_17 * t1130 - c_17 * t1133 + Scalar(0.00004711699779249448) * t1110;
  const Scalar t1147 = Scalar(0.048) * t844 - Scalar(0.75) * t1146 + c_16 * t1129 - s_16 * t1138 +
      Scalar(0.260431666667666) * t854 - Scalar(0.7225529242417575) * t855 +
      Scalar(0.576) * U_15_zy - Scalar(113.25) * t1145 - t977 - t1087 -
      Scalar(82.5) * (t1143 + t1144);
  const Scalar t1148 = Scalar(0.048) * t869 - Scalar(0.75) * f_u_16_t_x - mu_u_16_x +
      Scalar(0.006981818181818182) * t859 + Scalar(1.7055375151511811) * t860 - c_26 * mu_26_x -
      s_26 * t1094 - c_19 * mu_19_x - s_19 * t1095 - Scalar(60.0) * (t1143 - t1144);
  const Scalar t1149 = t779 * t936 - mu_u_25_15_t_y * t1048;
  const Scalar t1150 = c_14 * (Scalar(2.424827454030129) + qd_13 * t842);
  const Scalar y_15_14 = Scalar(0.8084599275533488) * t1150 + tau_14 - t814 * t1141 + t813 * t1140 +
      Scalar(707.7641729774637) * t1149 - t809 * t945 + t807 * t949 + t803 * t964 - t810 * t1056 +
      t808 * t1060 + t804 * t1075 - t812 * y_17_16 + t805 * t959 + t806 * t1070 + c_15 * t1147 +
      s_15 * t1148 - t801 * t973 + t799 * t978 - t802 * t1084 + t800 * t1088 - t798 * t1142;
  const Scalar t1151 = c_14 * (Scalar(1.6144698551066976) * qd_14 * t842 + c_15 * t1148 -
      s_15 * t1147);
  const Scalar mu_14_y = Scalar(0.00245) * t851 - mu_15_z;
  const Scalar t1152 = mu_u_32_14_t_y * t936 + t669 * t1048;
  const Scalar t1153 = tau_13 + t835 * t1140 + Scalar(707.7641729774637) * t1152 - t831 * t945 +
      t829 * t949 + t825 * t964 + t832 * t1056 - t830 * t1060 - t826 * t1075 + t836 * t1141 -
      t834 * y_17_16 + t827 * t959 - t821 * t978 - t828 * t1070 + t822 * t1088 - t1151 -
      s_14 * mu_14_y - t823 * t973 + t824 * t1084 + t820 * t1142 - t819 * y_15_14;
  const Scalar t1154 = t1153 / t837;
  qdd[12] = -t1154;
  const Scalar t1155 = t818 * (y_15_14 - t815 * t1154);
  qdd[13] = -t1155;
  const Scalar t1156 = t797 * (t795 * t1155 + t1142 - t778 * t1154);
  qdd[14] = -t1156;
  const Scalar qdd_16 = t773 * (t794 * t1155 + t771 * t1154 - t774 * t1156 + y_17_16);
  qdd[15] = qdd_16;
  const Scalar qdd_19 = t744 * (t790 * t1155 + t738 * t1154 + t742 * t1156 + t1088);
  qdd[18] = qdd_19;
  const Scalar qdd_26 = t617 * (t785 * t1155 - t610 * t1154 + t615 * t1156 + t978);
  qdd[25] = qdd_26;
  const Scalar t1157 = t761 * t1154 + t792 * t1155 + t760 * t1156 - c_17 * Iu_18_a_yz * qdd_16 +
      t1140;
  qdd[16] = t762 * t1157;
  const Scalar t1158 = t793 * t1155 - mu_u_18_14_a_z * t1154 + mu_u_18_15_a_y * t1156 + t1141;
  qdd[17] = Scalar(-29.342723004694836) * t1158 - s_17 * qdd_16;
  const Scalar t1159 = t725 * t1154 + t729 * qdd_19 + t741 * t1156 - t789 * t1155 + t1084;
  const Scalar qdd_20 = t731 * t1159;
  qdd[19] = qdd_20;
  const Scalar t1160 = b_28_27_26 * qdd_26 - t599 * t1154 + t614 * t1156 - t784 * t1155 + t973;
  const Scalar qdd_27 = t603 * t1160;
  qdd[26] = qdd_27;
  const Scalar t1161 = t714 * t1154 - b_22_21_15 * t1156 - t788 * t1155 + t1075 + t728 * qdd_19 -
      t717 * qdd_20;
  const Scalar t1162 = t719 * t1161;
  qdd[20] = -t1162;
  const Scalar t1163 = -t613 * t1156 - t783 * t1155 - t590 * t1154 + t964 + t601 * qdd_26 +
      t593 * qdd_27;
  const Scalar t1164 = d_28 * t1163;
  qdd[27] = -t1164;
  const Scalar t1165 = t707 * t1162 + t787 * t1155 - t705 * t1154 + b_23_22_15 * t1156 -
      t727 * qdd_19 + t1070 - t716 * qdd_20;
  const Scalar t1166 = t709 * t1165;
  qdd[21] = -t1166;
  const Scalar t1167 = t581 * t1164 + t782 * t1155 + t579 * t1154 + b_30_29_15 * t1156 -
      b_30_29_26 * qdd_26 + t959 - t592 * qdd_27;
  const Scalar t1168 = t583 * t1167;
  qdd[28] = -t1168;
  const Scalar t1169 = t786 * t1155 - t696 * t1154 - b_24_23_19 * qdd_19 + t740 * t1156 -
      t706 * t1162 + t715 * qdd_20 + t697 * t1166 + t1060;
  const Scalar t1170 = t699 * t1169;
  qdd[22] = -t1170;
  const Scalar t1171 = t572 * t1154 + t781 * t1155 - b_31_30_26 * qdd_26 - t612 * t1156 +
      t580 * t1164 - t591 * qdd_27 + b_31_30_29 * t1168 + t949;
  const Scalar t1172 = t574 * t1171;
  qdd[29] = -t1172;
  const Scalar t1173 = b_25_24_14 * t1155 - t688 * t1170 - t687 * t1154 - t739 * t1156 -
      t726 * qdd_19 + b_25_24_21 * t1162 - b_25_24_20 * qdd_20 + t1056 + b_25_24_22 * t1166;
  const Scalar qdd_24 = t690 * t1173;
  qdd[23] = qdd_24;
  const Scalar t1174 = t564 * t1172 + b_32_31_13 * t1154 - t611 * t1156 + t780 * t1155 -
      t600 * qdd_26 + b_32_31_28 * t1164 - b_32_31_27 * qdd_27 + t945 + b_32_31_29 * t1168;
  const Scalar qdd_31 = t566 * t1174;
  qdd[30] = qdd_31;
  const Scalar t1175 = t668 * t1156 - t669 * t1154 + mu_u_25_15_t_y * t1155 -
      mu_u_25_20_t_y * qdd_19 - t666 * t1162 + mu_u_25_20_a_y * qdd_20 - t660 * t1166 +
      mu_u_25_24_t_y * t1170 + t1048;
  qdd[24] = t670 * qdd_24 + Scalar(707.7641729774637) * t1175;
  const Scalar t1176 = t541 * qdd_26 - mu_u_32_14_t_y * t1154 - t545 * t1156 - t779 * t1155 +
      mu_32_28_z * t1164 - mu_32_27_z * qdd_27 + mu_32_29_z * t1168 + mu_u_32_31_t_y * t1172 + t936;
  qdd[31] = Scalar(707.7641729774637) * t1176 - t546 * qdd_31;
  bool positive = -t166 > Scalar(0.0);
  positive &= b_3_2_2 > Scalar(0.0);
  positive &= -t136 > Scalar(0.0);
  positive &= -t101 > Scalar(0.0);
  positive &= Ic_5_zz > Scalar(0.0);
  positive &= -t333 > Scalar(0.0);
  positive &= b_9_8_8 > Scalar(0.0);
  positive &= -t303 > Scalar(0.0);
  positive &= -t268 > Scalar(0.0);
  positive &= Ic_11_zz > Scalar(0.0);
  positive &= -t837 > Scalar(0.0);
  positive &= -t817 > Scalar(0.0);
  positive &= b_16_15_15 > Scalar(0.0);
  positive &= b_17_16_16 > Scalar(0.0);
  positive &= -mu_u_17_17_a_y > Scalar(0.0);
  positive &= -t743 > Scalar(0.0);
  positive &= -t730 > Scalar(0.0);
  positive &= t718 > Scalar(0.0);
  positive &= -t708 > Scalar(0.0);
  positive &= -t698 > Scalar(0.0);
  positive &= t689 > Scalar(0.0);
  positive &= -t616 > Scalar(0.0);
  positive &= -t602 > Scalar(0.0);
  positive &= b_29_28_28 > Scalar(0.0);
  positive &= -t582 > Scalar(0.0);
  positive &= -t573 > Scalar(0.0);
  positive &= t565 > Scalar(0.0);
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
  static_assert(detail::Interface::checked<Scalar>());
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
  static_assert(detail::Interface::checked<Scalar>());
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
  const Scalar t1 = c_13 * s_14;
  const Scalar t2 = s_13 * c_15;
  const Scalar J_4_26 = s_15 * t1 - t2;
  J[121] = J_4_26;
  const Scalar t3 = s_13 * s_15;
  const Scalar R_151_y = s_14 * t3 + c_13 * c_15;
  J[153] = R_151_y;
  const Scalar t4 = c_14 * c_15;
  const Scalar R_262_y = s_26 * t4 + s_14 * c_26;
  J[186] = -R_262_y;
  const Scalar t5 = c_15 * t1 + t3;
  const Scalar t6 = s_26 * t5 - c_26 * z_15_x;
  J[122] = -t6;
  const Scalar t7 = s_14 * t2 - c_13 * s_15;
  const Scalar t8 = s_26 * t7 - c_26 * z_15_y;
  J[154] = -t8;
  const Scalar t9 = c_26 * t4 - s_14 * s_26;
  const Scalar R_292_a_y = s_27 * R_152_y - c_27 * t9;
  J[187] = -R_292_a_y;
  const Scalar R_272_x = s_27 * t9 + c_27 * R_152_y;
  const Scalar R_282_y = s_28 * R_262_y + c_28 * R_272_x;
  J[188] = R_282_y;
  const Scalar t10 = s_26 * z_15_x + c_26 * t5;
  const Scalar t11 = s_27 * J_4_26 - c_27 * t10;
  J[123] = -t11;
  const Scalar t12 = s_26 * z_15_y + c_26 * t7;
  const Scalar R_291_a_y = s_27 * R_151_y - c_27 * t12;
  J[155] = -R_291_a_y;
  const Scalar t13 = s_27 * t10 + c_27 * J_4_26;
  const Scalar J_4_29 = s_28 * t6 + c_28 * t13;
  J[124] = J_4_29;
  const Scalar R_271_x = s_27 * t12 + c_27 * R_151_y;
  const Scalar R_281_y = s_28 * t8 + c_28 * R_271_x;
  J[156] = R_281_y;
  const Scalar t14 = s_28 * R_272_x - c_28 * R_262_y;
  const Scalar J_6_30 = s_29 * t14 - c_29 * R_292_a_y;
  J[189] = J_6_30;
  const Scalar R_280_x = s_28 * t13 - c_28 * t6;
  const Scalar z_30_x = s_29 * R_280_x - c_29 * t11;
  J[125] = z_30_x;
  const Scalar R_281_x = s_28 * R_271_x - c_28 * t8;
  const Scalar J_5_30 = s_29 * R_281_x - c_29 * R_291_a_y;
  J[157] = J_5_30;
  const Scalar t15 = s_29 * R_292_a_y + c_29 * t14;
  const Scalar J_6_31 = s_30 * R_282_y + c_30 * t15;
  J[190] = J_6_31;
  const Scalar R_290_x = s_29 * t11 + c_29 * R_280_x;
  const Scalar z_31_x = s_30 * J_4_29 + c_30 * R_290_x;
  J[126] = z_31_x;
  const Scalar R_291_x = s_29 * R_291_a_y + c_29 * R_281_x;
  const Scalar z_31_y = s_30 * R_281_y + c_30 * R_291_x;
  J[158] = z_31_y;
  const Scalar J_6_32 = s_31 * (s_30 * t15 - c_30 * R_282_y) + c_31 * J_6_30;
  J[191] = J_6_32;
  const Scalar R_310_y = s_31 * (s_30 * R_290_x - c_30 * J_4_29) + c_31 * z_30_x;
  J[127] = R_310_y;
  const Scalar J_5_32 = s_31 * (s_30 * R_291_x - c_30 * R_281_y) + c_31 * J_5_30;
  J[159] = J_5_32;
  const Scalar p_32u_t_x = Scalar(0.006) * c_32 - Scalar(0.025) * s_32;
  const Scalar p_31u_t_x = c_31 * p_32u_t_x + Scalar(0.147) * s_31;
  const Scalar p_32u_t_y = Scalar(0.006) * s_32 + Scalar(0.025) * c_32;
  const Scalar t16 = Scalar(0.004) + c_30 * p_32u_t_y + s_30 * p_31u_t_x;
  const Scalar p_30_y = Scalar(0.147) * c_31 - s_31 * p_32u_t_x + Scalar(0.239);
  const Scalar t17 = c_29 * t16 - Scalar(0.004) + s_29 * p_30_y;
  const Scalar t18 = s_30 * p_32u_t_y - c_30 * p_31u_t_x;
  const Scalar t19 = c_28 * t18 + s_28 * t17;
  const Scalar t20 = s_29 * t16 - c_29 * p_30_y - Scalar(0.305);
  const Scalar p_27u_t_x = s_27 * t19 - c_27 * t20;
  const Scalar t21 = s_28 * t18 - c_28 * t17;
  const Scalar p_26_x = s_26 * t21 + c_26 * p_27u_t_x - Scalar(0.33);
  const Scalar t22 = c_27 * t19 - Scalar(0.24) + s_27 * t20;
  const Scalar p_15u_t_x = s_15 * t22 + c_15 * p_26_x;
  const Scalar p_26u_t_y = s_26 * p_27u_t_x - c_26 * t21;
  const Scalar t23 = s_14 * p_26u_t_y - c_14 * p_15u_t_x;
  J[13] = c_13 * t23;
  J[45] = s_13 * t23;
  const Scalar t24 = c_14 * p_26u_t_y + s_14 * p_15u_t_x;
  const Scalar p_15u_t_y = s_15 * p_26_x - c_15 * t22;
  const Scalar J_1_13 = s_13 * t24 - c_13 * p_15u_t_y;
  J[12] = J_1_13;
  const Scalar t25 = c_13 * t24 + s_13 * p_15u_t_y;
  J[44] = -t25;
  J[77] = s_13 * J_1_13 + c_13 * t25;
  J[14] = t23 * z_15_y - s_14 * J_1_13;
  J[46] = s_14 * t25 - t23 * z_15_x;
  const Scalar t26 = Scalar(0.33) * t7 + Scalar(0.24) * R_151_y + J_1_13;
  const Scalar t27 = Scalar(-0.24) * R_152_y - Scalar(0.33) * t4 + t23;
  J[25] = R_152_y * t26 + R_151_y * t27;
  const Scalar t28 = Scalar(0.33) * t5 + Scalar(0.24) * J_4_26 + t25;
  J[89] = R_151_y * t28 - J_4_26 * t26;
  J[58] = t27 * t6 + t28 * R_262_y;
  J[90] = t26 * t6 - t28 * t8;
  J[78] = -c_14 * (c_13 * J_1_13 - s_13 * t25);
  J[57] = -R_152_y * t28 - J_4_26 * t27;
  J[26] = -t27 * t8 - t26 * R_262_y;
  const Scalar t29 = Scalar(0.305) * t11 + t28;
  const Scalar t30 = t27 - Scalar(0.305) * R_292_a_y;
  J[59] = R_292_a_y * t29 + t11 * t30;
  const Scalar t31 = Scalar(0.305) * R_291_a_y + t26;
  J[27] = -R_292_a_y * t31 - R_291_a_y * t30;
  J[91] = t11 * t31 - R_291_a_y * t29;
  const Scalar t32 = Scalar(0.004) * R_281_x + t31;
  const Scalar t33 = t30 - Scalar(0.004) * t14;
  J[28] = R_281_y * t33 + R_282_y * t32;
  const Scalar t34 = Scalar(0.004) * R_280_x + t29;
  J[92] = R_281_y * t34 - J_4_29 * t32;
  J[60] = -J_4_29 * t33 - R_282_y * t34;
  const Scalar t35 = Scalar(-0.004) * R_291_x - Scalar(0.239) * J_5_30 + t32;
  const Scalar t36 = Scalar(0.004) * t15 + Scalar(0.239) * J_6_30 + t33;
  J[29] = J_5_30 * t36 + J_6_30 * t35;
  const Scalar t37 = Scalar(-0.004) * R_290_x - Scalar(0.239) * z_30_x + t34;
  J[93] = J_5_30 * t37 - z_30_x * t35;
  J[30] = t36 * z_31_y + t35 * J_6_31;
  J[31] = t36 * J_5_32 + t35 * J_6_32;
  J[61] = -z_30_x * t36 - J_6_30 * t37;
  J[62] = -t36 * z_31_x - t37 * J_6_31;
  J[94] = t37 * z_31_y - t35 * z_31_x;
  J[63] = -t36 * R_310_y - t37 * J_6_32;
  J[95] = t37 * J_5_32 - t35 * R_310_y;
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

// The functions by type, with the shapes of their arguments: what adapters such as
// flatdyn/eigen.hpp are given.
namespace functions {

struct inverse_dynamics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[32], const Scalar (&qd)[32], const Scalar (&qdd)[32],
      Scalar (&tau)[32]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::humanoid32::inverse_dynamics(of...); }
};

struct inertia_matrix {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[32], Scalar (&B)[32][32]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::humanoid32::inertia_matrix(of...); }
};

struct gravity {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[32], Scalar (&g)[32]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::humanoid32::gravity(of...); }
};

struct bias {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[32], const Scalar (&qd)[32], Scalar (&n)[32]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::humanoid32::bias(of...); }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[32], const Scalar (&qd)[32], const Scalar (&tau)[32],
      Scalar (&qdd)[32]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::humanoid32::forward_dynamics(of...); }
};

struct forward_kinematics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[32], Scalar (&R)[3][3], Scalar (&p)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::humanoid32::forward_kinematics(of...); }
};

struct jacobian {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[32], Scalar (&J)[6][32]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::humanoid32::jacobian(of...); }
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

}  // namespace humanoid32

#endif  // FLATDYN_HUMANOID32_HPP_34C4636E

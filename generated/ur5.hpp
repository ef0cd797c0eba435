// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "ur5" as flat code: 6 joints.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Input: sha1:5067c3e245d749817586d21214d85a29a03c56b2
//
//   index  joint                moves link      type      unit  lower               upper              speed              effort
//   0      shoulder_pan_joint   shoulder_link   revolute  rad   -6.283185307179586  6.283185307179586  3.141592653589793  150
//   1      shoulder_lift_joint  upper_arm_link  revolute  rad   -6.283185307179586  6.283185307179586  3.141592653589793  150
//   2      elbow_joint          forearm_link    revolute  rad   -3.141592653589793  3.141592653589793  3.141592653589793  150
//   3      wrist_1_joint        wrist_1_link    revolute  rad   -6.283185307179586  6.283185307179586  3.141592653589793  28
//   4      wrist_2_joint        wrist_2_link    revolute  rad   -6.283185307179586  6.283185307179586  3.141592653589793  28
//   5      wrist_3_joint        wrist_3_link    revolute  rad   -6.283185307179586  6.283185307179586  3.141592653589793  28
//
// Gravity is (0, 0, -9.81) m/s^2 in the base frame. The tip belongs to link "wrist_3_link".
//
// Every function is a template over its scalar: float, double, or any type that is made from a
// double, has + - * / (also - of one), comparisons, and sin, cos where argument-dependent lookup
// finds them (or an argument that knows them, see LibrarySinCos). Arguments are plain arrays:
//
//   double q[6] = {}, qd[6] = {}, qdd[6] = {}, tau[6];
//   ur5::inverse_dynamics(q, qd, qdd, tau);
//
// Entries come in the order of the table. Units are SI; "rad or m" goes by the type of the joint.
// Every entry of an output is written, zeros too. All inputs are read before anything is written:
// an output may overlap an input, but outputs must not overlap each other. Nothing allocates,
// throws, or keeps state. In the code, names count from 1 as in the textbook: q_1 is q[0], s_1 its
// sine, c_1 its cosine. Of link i: omega_i and domega_i are its angular velocity and acceleration,
// ddp_i the acceleration of its frame's origin less gravity, f_i and mu_i the force and moment that
// it gets from the link before, hc_i and hu_i the first moment of all that its joint carries (in
// gravity() times the size of gravity); t1, t2, ... are parts of sums.

#ifndef FLATDYN_UR5_HPP
#define FLATDYN_UR5_HPP

#include <cmath>

namespace ur5 {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 6;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {
    "shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint",
    "wrist_3_joint"};

// Smallest position, rad or m.
inline constexpr Real position_lower[joint_count] = {
    Real(-6.283185307179586), Real(-6.283185307179586), Real(-3.141592653589793),
    Real(-6.283185307179586), Real(-6.283185307179586), Real(-6.283185307179586)};

// Largest position, rad or m.
inline constexpr Real position_upper[joint_count] = {
    Real(6.283185307179586), Real(6.283185307179586), Real(3.141592653589793),
    Real(6.283185307179586), Real(6.283185307179586), Real(6.283185307179586)};

// Largest speed, rad/s or m/s.
inline constexpr Real velocity_limit[joint_count] = {
    Real(3.141592653589793), Real(3.141592653589793), Real(3.141592653589793),
    Real(3.141592653589793), Real(3.141592653589793), Real(3.141592653589793)};

// Largest torque or force, N m or N.
inline constexpr Real effort_limit[joint_count] = {
    Real(150.0), Real(150.0), Real(150.0), Real(28.0), Real(28.0), Real(28.0)};

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
// Reads q[1..5], qd[0..5], qdd[0..5]. Operations: 175 mul, 135 add, 10 sin/cos.
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
  const Scalar t1 = s_2 * qd_1;
  const Scalar t2 = c_2 * qd_1;
  const Scalar t3 = s_3 * t1 - c_3 * t2;
  const Scalar omega_r_3_x = s_3 * t2 + c_3 * t1;
  const Scalar t4 = s_4 * t3 - c_4 * omega_r_3_x;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t4;
  const Scalar t5 = s_4 * omega_r_3_x + c_4 * t3;
  const Scalar t6 = qd_2 * t2;
  const Scalar t7 = s_2 * qdd_1;
  const Scalar domega_2_x = t6 + t7;
  const Scalar t8 = qd_2 * t1;
  const Scalar t9 = t8 - c_2 * qdd_1;
  const Scalar t10 = qd_3 * omega_r_3_x + s_3 * domega_2_x + c_3 * t9;
  const Scalar t11 = qd_3 * t3 + s_3 * t9 - c_3 * domega_2_x;
  const Scalar t12 = qd_4 * t5 + s_4 * t10 + c_4 * t11;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar domega_4_z = qdd_4 + domega_3_z;
  const Scalar t13 = qd_5 * omega_r_5_x - s_5 * t12 - c_5 * domega_4_z;
  const Scalar domega_6_z = qdd_6 - t13;
  const Scalar N_6_z = Scalar(0.0001321171875) * domega_6_z;
  tau[5] = N_6_z;
  const Scalar t14 = qd_2 * qd_2;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 + Scalar(0.425) * (t2 * t2 + t14);
  const Scalar t15 = t2 * t1;
  const Scalar U_2_yx = t15 + qdd_2;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.425) * U_2_yx;
  const Scalar t16 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t17 = t3 * omega_3_z;
  const Scalar t18 = t11 - t17;
  const Scalar t19 = omega_r_3_x * t3;
  const Scalar U_3_yx = domega_3_z - t19;
  const Scalar t20 = Scalar(0.39225) * U_3_yx - Scalar(0.10915) * t18 + t16;
  const Scalar t21 = omega_r_3_x * omega_3_z;
  const Scalar t22 = t3 * t3;
  const Scalar t23 = t22 + omega_3_z * omega_3_z;
  const Scalar ddp_o_4_x = Scalar(0.39225) * t23 - Scalar(0.10915) * (t10 - t21) + s_3 * ddp_o_3_y +
      c_3 * ddp_o_3_x;
  const Scalar t24 = s_4 * t20 - c_4 * ddp_o_4_x;
  const Scalar t25 = t4 * t5;
  const Scalar t26 = domega_4_z - t25;
  const Scalar t27 = t5 * omega_4_z;
  const Scalar t28 = t12 + t27;
  const Scalar t29 = t10 + t21;
  const Scalar t30 = t22 + omega_r_3_x * omega_r_3_x;
  const Scalar U_2_zx = t8 + t9;
  const Scalar t31 = Scalar(0.10915) * t30 + Scalar(0.425) * U_2_zx + Scalar(0.39225) * t29;
  const Scalar t32 = s_5 * (t31 - Scalar(0.09465) * t28) + c_5 * (t24 - Scalar(0.09465) * t26);
  const Scalar omega_r_5_y = s_5 * t4 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t33 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar t34 = s_6 * t33;
  const Scalar omega_5_z = qd_5 + t5;
  const Scalar t35 = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t36 = c_6 * t33;
  const Scalar t37 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar t38 = omega_r_5_x * omega_5_z;
  const Scalar domega_4_y = qd_4 * t4 + s_4 * t11 - c_4 * t10;
  const Scalar domega_5_z = qdd_5 - domega_4_y;
  const Scalar t39 = omega_r_5_x * omega_r_5_y;
  const Scalar tau_5 = t35 * t34 - Scalar(0.000035853228) * (t13 - t38) - t37 * t36 -
      Scalar(0.0016432000421699) * t39 + Scalar(0.0038374000421699) * domega_5_z +
      Scalar(0.0351648539) * t32;
  tau[4] = tau_5;
  const Scalar t40 = omega_4_z * omega_4_z;
  const Scalar t41 = t4 * t4 + t40;
  const Scalar ddp_o_5_y = Scalar(0.09465) * t41 - s_4 * ddp_o_4_x - c_4 * t20;
  const Scalar domega_5_x = qd_5 * omega_r_5_y + s_5 * domega_4_z - c_5 * t12;
  const Scalar t42 = omega_5_z * omega_5_z;
  const Scalar t43 = omega_r_5_y * omega_5_z;
  const Scalar t44 = Scalar(0.000035853228) * (t42 - omega_r_5_y * omega_r_5_y) + t37 * t34 +
      t35 * t36 - Scalar(0.0016432000421699) * domega_5_x - Scalar(0.0038374000421699) * t43 +
      Scalar(0.0351648539) * ddp_o_5_y;
  const Scalar t45 = domega_5_z - t39;
  const Scalar t46 = Scalar(0.000035853228) * t45 + N_6_z - Scalar(0.0021942) * t38;
  const Scalar t47 = t42 + omega_r_5_x * omega_r_5_x;
  const Scalar t48 = Scalar(0.0351648539) * s_5;
  const Scalar t49 = Scalar(0.0351648539) * c_5;
  const Scalar t50 = t47 * t48 - t45 * t49;
  const Scalar t51 = t4 * omega_4_z;
  const Scalar U_4_xz = domega_4_y - t51;
  const Scalar t52 = Scalar(0.000035853228) * U_4_xz - c_5 * t46 + Scalar(0.01434898073165) * t25 -
      Scalar(0.09465) * t50 - Scalar(0.01654318073165) * domega_4_z + s_5 * t44 +
      Scalar(0.150887345) * t24;
  tau[3] = -t52;
  const Scalar f_4_x = t50 + Scalar(0.150887345) * t26;
  const Scalar U_5_zy = t43 + domega_5_x;
  const Scalar f_4_y = Scalar(0.150887345) * t41 - Scalar(0.0351648539) * U_5_zy;
  const Scalar f_u_4_t_y = s_4 * f_4_x + c_4 * f_4_y;
  const Scalar tau_3 = Scalar(-0.12652256366625) * t18 - t52 - Scalar(0.39225) * f_u_4_t_y -
      Scalar(0.56787913724375) * t19 + Scalar(1.594451775) * t16 +
      Scalar(0.57197413724375) * domega_3_z;
  tau[2] = tau_3;
  const Scalar t53 = s_4 * f_4_y - c_4 * f_4_x;
  const Scalar f_3_x = Scalar(1.594451775) * t23 - t53;
  const Scalar t54 = s_3 * f_3_x - c_3 * (Scalar(1.594451775) * U_3_yx - f_u_4_t_y);
  const Scalar t55 = Scalar(-0.349300285625) * t7 - Scalar(1.39293427915) * t15 -
      Scalar(1.40804167915) * qdd_2 - tau_3 + Scalar(0.425) * t54 + Scalar(38.1586437) * c_2;
  tau[1] = -t55;
  const Scalar t56 = t47 * t49 + t45 * t48;
  const Scalar mu_4_x = Scalar(0.000035853228) * (t40 - t5 * t5) - s_5 * t46 +
      Scalar(0.09465) * t56 - Scalar(0.01434898073165) * t12 - Scalar(0.01654318073165) * t27 -
      c_5 * t44 + Scalar(0.150887345) * t31;
  const Scalar t57 = Scalar(0.000035853228) * t26 - Scalar(0.0021942) * t51 + tau_5;
  const Scalar t58 = Scalar(0.150887345) * t28 - t56;
  const Scalar U_3_zz_xx = t23 - t30;
  const Scalar t59 = c_4 * t57 + Scalar(0.10915) * t53 - s_4 * mu_4_x - Scalar(0.39225) * t58 -
      Scalar(0.12652256366625) * U_3_zz_xx + Scalar(0.677642004375) * U_2_zx +
      Scalar(1.1398532744875) * t21;
  const Scalar t60 = s_4 * t57 - Scalar(0.10915) * f_u_4_t_y + c_4 * mu_4_x +
      Scalar(0.12652256366625) * U_3_yx + Scalar(0.56787913724375) * t11 -
      Scalar(0.57197413724375) * t17;
  const Scalar mu_2_x = Scalar(0.349300285625) * U_2_yx + c_3 * t60 + Scalar(1.40804167915) * t6 -
      Scalar(1.39293427915) * domega_2_x + s_3 * t59;
  const Scalar t61 = Scalar(-0.425) * t58 - Scalar(0.349300285625) * (t14 - t1 * t1) - s_3 * t60 +
      Scalar(0.677642004375) * t29 + c_3 * t59 + Scalar(2.8009759583) * t8;
  tau[0] = s_2 * mu_2_x + Scalar(2.1327493394493) * qdd_1 - c_2 * t61;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..5], qd[0..5], qdd[0..5], h_e[0..5]. Operations: 229 mul, 169 add, 12 sin/cos.
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
  const Scalar t1 = s_2 * qd_1;
  const Scalar t2 = c_2 * qd_1;
  const Scalar t3 = s_3 * t1 - c_3 * t2;
  const Scalar omega_r_3_x = s_3 * t2 + c_3 * t1;
  const Scalar t4 = s_4 * t3 - c_4 * omega_r_3_x;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t4;
  const Scalar t5 = s_4 * omega_r_3_x + c_4 * t3;
  const Scalar t6 = qd_2 * t2;
  const Scalar t7 = s_2 * qdd_1;
  const Scalar domega_2_x = t6 + t7;
  const Scalar t8 = qd_2 * t1;
  const Scalar t9 = t8 - c_2 * qdd_1;
  const Scalar t10 = qd_3 * omega_r_3_x + s_3 * domega_2_x + c_3 * t9;
  const Scalar t11 = qd_3 * t3 + s_3 * t9 - c_3 * domega_2_x;
  const Scalar t12 = qd_4 * t5 + s_4 * t10 + c_4 * t11;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar domega_4_z = qdd_4 + domega_3_z;
  const Scalar t13 = qd_5 * omega_r_5_x - s_5 * t12 - c_5 * domega_4_z;
  const Scalar domega_6_z = qdd_6 - t13;
  const Scalar mu_e1_x = s_1 * h_e_5 + c_1 * h_e_4;
  const Scalar mu_e2_x = s_2 * h_e_6 + c_2 * mu_e1_x;
  const Scalar t14 = s_2 * mu_e1_x - c_2 * h_e_6;
  const Scalar t15 = s_3 * mu_e2_x + c_3 * t14;
  const Scalar t16 = s_3 * t14 - c_3 * mu_e2_x;
  const Scalar t17 = s_4 * t15 + c_4 * t16;
  const Scalar t18 = s_1 * h_e_4 - c_1 * h_e_5;
  const Scalar tau_6 = Scalar(0.0001321171875) * domega_6_z + s_5 * t17 + c_5 * t18;
  tau[5] = tau_6;
  const Scalar f_e1_x = s_1 * h_e_2 + c_1 * h_e_1;
  const Scalar f_e2_x = s_2 * h_e_3 + c_2 * f_e1_x;
  const Scalar t19 = s_2 * f_e1_x - c_2 * h_e_3;
  const Scalar t20 = s_3 * f_e2_x + c_3 * t19;
  const Scalar t21 = s_3 * t19 - c_3 * f_e2_x;
  const Scalar t22 = s_4 * t20 + c_4 * t21;
  const Scalar t23 = s_1 * h_e_1 - c_1 * h_e_2;
  const Scalar f_e5_x = s_5 * t23 - c_5 * t22;
  const Scalar f_e4_y = s_4 * t21 - c_4 * t20;
  const Scalar t24 = s_6 * f_e5_x - c_6 * f_e4_y;
  const Scalar mu_e5_x = s_5 * t18 - c_5 * t17;
  const Scalar omega_5_z = qd_5 + t5;
  const Scalar omega_r_5_y = s_5 * t4 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t25 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar t26 = (s_6 * omega_r_5_x + c_6 * omega_5_z) * t25;
  const Scalar mu_e4_y = s_4 * t16 - c_4 * t15;
  const Scalar t27 = Scalar(0.0823) * t24 - t26 + s_6 * mu_e4_y + c_6 * mu_e5_x;
  const Scalar f_e6_x = s_6 * f_e4_y + c_6 * f_e5_x;
  const Scalar t28 = (s_6 * omega_5_z - c_6 * omega_r_5_x) * t25;
  const Scalar mu_6_y = t28 + Scalar(0.0823) * f_e6_x - s_6 * mu_e5_x + c_6 * mu_e4_y;
  const Scalar t29 = qd_2 * qd_2;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 + Scalar(0.425) * (t2 * t2 + t29);
  const Scalar t30 = t2 * t1;
  const Scalar U_2_yx = t30 + qdd_2;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.425) * U_2_yx;
  const Scalar t31 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t32 = t3 * omega_3_z;
  const Scalar t33 = t11 - t32;
  const Scalar t34 = omega_r_3_x * t3;
  const Scalar U_3_yx = domega_3_z - t34;
  const Scalar t35 = Scalar(0.39225) * U_3_yx - Scalar(0.10915) * t33 + t31;
  const Scalar t36 = omega_r_3_x * omega_3_z;
  const Scalar t37 = t3 * t3;
  const Scalar t38 = t37 + omega_3_z * omega_3_z;
  const Scalar ddp_o_4_x = Scalar(0.39225) * t38 - Scalar(0.10915) * (t10 - t36) + s_3 * ddp_o_3_y +
      c_3 * ddp_o_3_x;
  const Scalar t39 = s_4 * t35 - c_4 * ddp_o_4_x;
  const Scalar t40 = t4 * t5;
  const Scalar t41 = domega_4_z - t40;
  const Scalar t42 = t5 * omega_4_z;
  const Scalar t43 = t12 + t42;
  const Scalar t44 = t10 + t36;
  const Scalar t45 = t37 + omega_r_3_x * omega_r_3_x;
  const Scalar U_2_zx = t8 + t9;
  const Scalar t46 = Scalar(0.10915) * t45 + Scalar(0.425) * U_2_zx + Scalar(0.39225) * t44;
  const Scalar t47 = s_5 * (t46 - Scalar(0.09465) * t43) + c_5 * (t39 - Scalar(0.09465) * t41);
  const Scalar t48 = omega_r_5_x * omega_5_z;
  const Scalar domega_4_y = qd_4 * t4 + s_4 * t11 - c_4 * t10;
  const Scalar domega_5_z = qdd_5 - domega_4_y;
  const Scalar t49 = omega_r_5_x * omega_r_5_y;
  const Scalar tau_5 = Scalar(-0.000035853228) * (t13 - t48) - Scalar(0.0016432000421699) * t49 +
      Scalar(0.0038374000421699) * domega_5_z + Scalar(0.0351648539) * t47 - s_6 * t27 -
      c_6 * mu_6_y;
  tau[4] = tau_5;
  const Scalar t50 = domega_5_z - t49;
  const Scalar t51 = Scalar(0.0351648539) * t50 - s_6 * t24 - c_6 * f_e6_x;
  const Scalar t52 = omega_5_z * omega_5_z;
  const Scalar t53 = Scalar(0.0351648539) * (t52 + omega_r_5_x * omega_r_5_x) - s_5 * t22 -
      c_5 * t23;
  const Scalar t54 = s_5 * t53 - c_5 * t51;
  const Scalar t55 = omega_4_z * omega_4_z;
  const Scalar t56 = t4 * t4 + t55;
  const Scalar ddp_o_5_y = Scalar(0.09465) * t56 - s_4 * ddp_o_4_x - c_4 * t35;
  const Scalar domega_5_x = qd_5 * omega_r_5_y + s_5 * domega_4_z - c_5 * t12;
  const Scalar t57 = omega_r_5_y * omega_5_z;
  const Scalar t58 = Scalar(0.000035853228) * (t52 - omega_r_5_y * omega_r_5_y) -
      Scalar(0.0016432000421699) * domega_5_x - Scalar(0.0038374000421699) * t57 +
      Scalar(0.0351648539) * ddp_o_5_y + s_6 * mu_6_y - c_6 * t27;
  const Scalar t59 = Scalar(0.000035853228) * t50 - Scalar(0.0021942) * t48 + tau_6;
  const Scalar t60 = t4 * omega_4_z;
  const Scalar U_4_xz = domega_4_y - t60;
  const Scalar t61 = Scalar(0.000035853228) * U_4_xz + Scalar(0.01434898073165) * t40 -
      Scalar(0.01654318073165) * domega_4_z - Scalar(0.09465) * t54 + Scalar(0.150887345) * t39 +
      s_5 * t58 - c_5 * t59;
  tau[3] = -t61;
  const Scalar f_4_x = Scalar(0.150887345) * t41 + t54;
  const Scalar U_5_zy = t57 + domega_5_x;
  const Scalar f_4_y = Scalar(0.150887345) * t56 - Scalar(0.0351648539) * U_5_zy + s_6 * f_e6_x -
      c_6 * t24;
  const Scalar f_u_4_t_y = s_4 * f_4_x + c_4 * f_4_y;
  const Scalar tau_3 = Scalar(-0.12652256366625) * t33 - Scalar(0.56787913724375) * t34 -
      Scalar(0.39225) * f_u_4_t_y + Scalar(1.594451775) * t31 +
      Scalar(0.57197413724375) * domega_3_z - t61;
  tau[2] = tau_3;
  const Scalar t62 = s_4 * f_4_y - c_4 * f_4_x;
  const Scalar f_3_x = Scalar(1.594451775) * t38 - t62;
  const Scalar t63 = s_3 * f_3_x - c_3 * (Scalar(1.594451775) * U_3_yx - f_u_4_t_y);
  const Scalar t64 = Scalar(-0.349300285625) * t7 - Scalar(1.39293427915) * t30 -
      Scalar(1.40804167915) * qdd_2 + Scalar(0.425) * t63 + Scalar(38.1586437) * c_2 - tau_3;
  tau[1] = -t64;
  const Scalar t65 = s_5 * t51 + c_5 * t53;
  const Scalar mu_4_x = Scalar(0.000035853228) * (t55 - t5 * t5) - Scalar(0.01434898073165) * t12 -
      Scalar(0.01654318073165) * t42 + Scalar(0.09465) * t65 + Scalar(0.150887345) * t46 -
      s_5 * t59 - c_5 * t58;
  const Scalar t66 = Scalar(0.150887345) * t43 - t65;
  const Scalar t67 = Scalar(0.000035853228) * t41 - Scalar(0.0021942) * t60 + tau_5;
  const Scalar U_3_zz_xx = t38 - t45;
  const Scalar t68 = Scalar(0.10915) * t62 - Scalar(0.12652256366625) * U_3_zz_xx -
      Scalar(0.39225) * t66 + Scalar(0.677642004375) * U_2_zx - s_4 * mu_4_x + c_4 * t67 +
      Scalar(1.1398532744875) * t36;
  const Scalar t69 = Scalar(0.12652256366625) * U_3_yx - Scalar(0.10915) * f_u_4_t_y +
      Scalar(0.56787913724375) * t11 - Scalar(0.57197413724375) * t32 + s_4 * t67 + c_4 * mu_4_x;
  const Scalar mu_2_x = Scalar(0.349300285625) * U_2_yx + Scalar(1.40804167915) * t6 -
      Scalar(1.39293427915) * domega_2_x + s_3 * t68 + c_3 * t69;
  const Scalar t70 = Scalar(-0.349300285625) * (t29 - t1 * t1) - Scalar(0.425) * t66 +
      Scalar(0.677642004375) * t44 - s_3 * t69 + c_3 * t68 + Scalar(2.8009759583) * t8;
  tau[0] = s_2 * mu_2_x + Scalar(2.1327493394493) * qdd_1 - c_2 * t70;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[36] = {
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 0,
    1, 1, 1, 1, 0, 1};

// Joint-space inertia matrix B(q) (7.32).
//   q[6]   in   joint positions, rad or m
//   B[36]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//               6 x 6, row by row: entry (i, j) is B[6 * i + j]
// Reads q[1..4]. Operations: 79 mul, 66 add, 8 sin/cos. Always zero: 2 of the 36 entries of B.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inertia_matrix(const Scalar* q, Scalar* B, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  B[22] = B[27] = Scalar(-0.003292500193635) * c_5;
  B[11] = B[17] = B[23] = B[31] = B[32] = B[33] = Scalar(0.0001321171875) * c_5;
  const Scalar t1 = Scalar(0.013793413942275) * c_5;
  const Scalar B_35 = t1 * (s_4 - Scalar(0.23870089068696182));
  B[16] = B[26] = B_35;
  const Scalar t2 = Scalar(0.0015110828546699) * c_5;
  const Scalar t3 = c_5 * t2;
  const Scalar t4 = t3 - Scalar(0.0181863807738199);
  B[21] = -t4;
  const Scalar t5 = s_3 * c_4 + c_3 * s_4;
  const Scalar t6 = Scalar(0.0149450629075) * c_5;
  B[10] = B[25] = B_35 + t6 * t5;
  const Scalar t7 = c_4 * s_5;
  const Scalar hu_4_t_x = Scalar(0.150887345) * s_4 - Scalar(0.0351648539) * t7;
  const Scalar t8 = Scalar(0.7845) * hu_4_t_x;
  const Scalar t9 = t4 + t8 - Scalar(0.57197413724375);
  B[14] = -t9;
  const Scalar t10 = t4 + Scalar(0.39225) * hu_4_t_x;
  B[15] = B[20] = -t10;
  const Scalar t11 = s_4 * s_5;
  const Scalar f_3_3_x = Scalar(0.0351648539) * t11 + Scalar(0.150887345) * c_4;
  const Scalar t12 = s_3 * f_3_3_x;
  const Scalar f_u_4_3_t_y = t12 + c_3 * hu_4_t_x;
  B[9] = B[19] = -t10 - Scalar(0.425) * f_u_4_3_t_y;
  const Scalar t13 = s_5 * (s_2 * (s_3 * s_4 - c_3 * c_4) - c_2 * t5);
  B[5] = B[30] = Scalar(0.0001321171875) * t13;
  const Scalar hc_3_x = hu_4_t_x - Scalar(1.594451775);
  const Scalar hu_3_t_x = t12 + c_3 * hc_3_x;
  B[8] = B[13] = Scalar(-0.425) * hu_3_t_x - t9;
  const Scalar t14 = Scalar(0.003838243803185) * c_5 + Scalar(0.0038374000421699);
  const Scalar t15 = Scalar(0.003292500193635) * s_5;
  const Scalar t16 = c_4 * t14 - t15 * (s_4 - Scalar(4.189343395921486));
  const Scalar mu_5_3_x = Scalar(0.003292500193635) * t7 + s_4 * t14;
  const Scalar mu_u_5_3_t_x = c_3 * mu_5_3_x + s_3 * t16;
  const Scalar t17 = c_2 * (c_3 * t16 - s_3 * mu_5_3_x + Scalar(0.0149450629075) * s_5);
  B[4] = B[24] = s_2 * mu_u_5_3_t_x - t17;
  const Scalar t18 = Scalar(0.85) * hu_3_t_x;
  B[7] = -t9 - t18 + Scalar(1.40804167915);
  const Scalar Ic_4_yz = Scalar(0.003292500193635) * c_5 - Scalar(0.000035853228);
  const Scalar Ic_3_yz = t2 * t11 + c_4 * Ic_4_yz + Scalar(0.10915) * f_3_3_x;
  const Scalar t19 = s_3 * Ic_3_yz;
  const Scalar t20 = s_4 * Ic_4_yz - t2 * t7 + Scalar(0.10915) * hu_4_t_x;
  const Scalar t21 = c_3 * Ic_3_yz;
  const Scalar mu_u_4_3_t_y = t21 - s_3 * t20;
  B[3] = B[18] = c_2 * mu_u_4_3_t_y - s_2 * (t19 + c_3 * t20);
  const Scalar t22 = t20 - t1 - Scalar(0.12652256366625);
  const Scalar t23 = c_2 * (s_3 * t22 - t21);
  const Scalar t24 = t19 + c_3 * t22;
  B[2] = B[12] = -t23 - s_2 * t24;
  B[1] = B[6] = -t23 - s_2 * (t24 - t6 - Scalar(0.349300285625));
  const Scalar Iu_5_t_xx = t3 - Scalar(0.0015110828546699);
  const Scalar Iu_4_t_d = Iu_5_t_xx + Scalar(0.01215478073165);
  const Scalar Iu_4_t_g = Scalar(0.00658500038727) * t11 + c_4 * Iu_4_t_d;
  const Scalar t25 = c_4 * Iu_4_t_g;
  const Scalar t26 = Scalar(0.00767648760637) * c_5;
  const Scalar Ic_3_xx = t25 + t26 - Scalar(0.01215478073165);
  const Scalar Ic_3_yy = Iu_5_t_xx - t25 + t26 - t8 + Scalar(0.56787913724375);
  const Scalar Iu_3_t_d = Ic_3_xx - Ic_3_yy;
  const Scalar t27 = t15 - s_4 * Iu_4_t_g + Scalar(0.39225) * f_3_3_x;
  const Scalar Iu_3_t_g = Scalar(2.0) * s_3 * t27 + c_3 * Iu_3_t_d;
  const Scalar t28 = c_3 * Iu_3_t_g;
  const Scalar Iu_3_t_xx = t28 + Ic_3_yy;
  const Scalar t29 = c_2 * (Ic_3_xx - t28 - Iu_3_t_xx - t18 + Scalar(1.39293427915));
  const Scalar t30 = t27 - Scalar(0.425) * (s_3 * hc_3_x - c_3 * f_3_3_x) - s_3 * Iu_3_t_g;
  B[0] = Scalar(0.1879281038293699) + Iu_3_t_xx - c_2 * (Scalar(2.0) * s_2 * t30 - t29);
  B[29] = B[34] = Scalar(0.0);
  B[35] = Scalar(0.0001321171875);
  B[28] = Scalar(0.0038374000421699);
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[126] = {
    0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 1, 1, 0,
    1, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 1, 0,
    1, 1, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 1, 0,
    1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 1, 0,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0,
    0, 1, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[6]    in   joint positions, rad or m
//   c[126]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//                c_ijk = c_ikj is c[21 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads q[1..4]. Operations: 181 mul, 117 add, 8 sin/cos. Always zero: 45 of the 126 entries of c.
template <class Scalar, class SinCos = LibrarySinCos>
inline void christoffel(const Scalar* q, Scalar* c, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar dI_4_xx = Scalar(0.003292500193635) * s_5;
  c[77] = dI_4_xx;
  const Scalar c_5_2_6 = Scalar(0.00006605859375) * s_5;
  c[100] = c[101] = c[102] = c_5_2_6;
  c[40] = c[61] = c[82] = c[116] = c[117] = c[118] = Scalar(-0.00006605859375) * s_5;
  const Scalar t1 = s_4 * s_5;
  const Scalar f_3_3_x = Scalar(0.013793413942275) * t1 + Scalar(0.05918556107625) * c_4;
  c[68] = f_3_3_x;
  const Scalar t2 = c_5 * s_5;
  c[74] = c[75] = c[76] = Scalar(0.0015110828546699) * t2;
  c[91] = c[92] = c[93] = Scalar(-0.0015110828546699) * t2;
  c[50] = c[51] = -f_3_3_x;
  const Scalar t3 = Scalar(0.00075554142733495) * s_5;
  const Scalar dmu_3_5_y = t3 + Scalar(0.0068967069711375) * c_4;
  const Scalar t4 = Scalar(2.0) * c_5;
  const Scalar db_33_5r = t4 * dmu_3_5_y;
  c[54] = c[55] = db_33_5r;
  const Scalar t5 = s_4 - Scalar(0.23870089068696182);
  c[56] = Scalar(-0.013793413942275) * s_5 * t5;
  c[89] = -db_33_5r;
  const Scalar t6 = Scalar(0.425) * s_3;
  const Scalar t7 = Scalar(0.425) * c_3 + Scalar(0.39225);
  const Scalar t8 = c_4 * t6 + s_4 * t7;
  const Scalar t9 = Scalar(0.0351648539) * s_5;
  const Scalar t10 = c_4 * t7 - s_4 * t6;
  const Scalar c_4_2_2 = t8 * t9 + Scalar(0.150887345) * t10;
  c[65] = c_4_2_2;
  const Scalar t11 = t3 + Scalar(0.01758242695) * t10;
  const Scalar db_22_5r = t11 * t4;
  c[32] = c[34] = db_22_5r;
  const Scalar t12 = c_3 * c_4 - s_3 * s_4;
  const Scalar c_2_1_6 = c_5_2_6 * (c_2 * t12 - s_2 * (c_3 * s_4 + s_3 * c_4));
  c[36] = c_2_1_6;
  c[28] = c[30] = -c_4_2_2;
  c[86] = -db_22_5r;
  const Scalar w_1_3_x = c_2 * s_3 + s_2 * c_3;
  const Scalar t13 = c_2 * c_3 - s_2 * s_3;
  const Scalar t14 = c_4 * w_1_3_x + s_4 * t13;
  const Scalar t15 = c_5 * t14;
  c[19] = c[115] = Scalar(-0.00006605859375) * t15;
  c[99] = Scalar(0.00006605859375) * t15;
  const Scalar t16 = c_4 * t13 - s_4 * w_1_3_x;
  const Scalar t17 = s_5 * t16;
  c[17] = c[18] = c[108] = c[111] = Scalar(-0.00006605859375) * t17;
  c[57] = c[78] = Scalar(0.00006605859375) * t17;
  c[16] = c[106] = -c_2_1_6;
  const Scalar t18 = t8 - Scalar(0.09363042437196077);
  c[35] = -t9 * t18;
  const Scalar t19 = Scalar(0.01758242695) * s_5;
  const Scalar hu_4_t_x = Scalar(0.0754436725) * s_4 - c_4 * t19;
  const Scalar hc_3_x = hu_4_t_x - Scalar(0.7972258875);
  const Scalar t20 = Scalar(0.85) * hc_3_x;
  const Scalar t21 = Scalar(1.0834926704907584) * f_3_3_x;
  const Scalar c_3_2_2 = c_3 * t21 - s_3 * t20;
  c[44] = c_3_2_2;
  const Scalar t22 = Scalar(0.5) * f_3_3_x + Scalar(0.5) * c_4_2_2;
  const Scalar t23 = Scalar(0.5417463352453792) * f_3_3_x;
  const Scalar t24 = hu_4_t_x * t6 - c_3 * t23;
  c[29] = t24 - t22;
  const Scalar c_4_2_3 = t24 + t22;
  c[67] = c_4_2_3;
  const Scalar t25 = c_5 * dmu_3_5_y + c_5 * t11;
  const Scalar t26 = Scalar(0.00747253145375) * c_5;
  const Scalar t27 = t26 * t12;
  c[33] = t27 + t25;
  const Scalar c_3_2_5 = t25 - t27;
  c[53] = c_3_2_5;
  c[25] = c[26] = -c_3_2_2;
  const Scalar t28 = Scalar(0.00075554142733495) * c_5;
  const Scalar t29 = c_4 * s_5;
  const Scalar Ic_4_yz = Scalar(0.0016462500968175) * c_5 - Scalar(0.000017926614);
  const Scalar t30 = s_4 * Ic_4_yz - t28 * t29 + Scalar(0.10915) * hu_4_t_x;
  const Scalar t31 = Scalar(0.0068967069711375) * c_5 - t30 + Scalar(0.063261281833125);
  const Scalar Ic_3_yz = t28 * t1 + c_4 * Ic_4_yz + Scalar(0.1391332058636074) * f_3_3_x;
  const Scalar t32 = Ic_3_yz * w_1_3_x;
  const Scalar t33 = t31 * t13 - t32;
  c[5] = Scalar(2.0) * t33;
  const Scalar t34 = t28 + Scalar(0.0019191219015925);
  const Scalar t35 = t17 * t34 - t14 * (Ic_4_yz + Scalar(0.008234676853375));
  c[9] = Scalar(2.0) * t35;
  const Scalar t36 = t32 + t30 * t13;
  c[8] = t35 - t36;
  const Scalar c_3_1_4 = t35 + t36;
  c[48] = c_3_1_4;
  const Scalar t37 = Scalar(-0.0016462500968175) * t17;
  const Scalar t38 = Scalar(0.0019191219015925) * c_5 + Scalar(0.00191870002108495);
  const Scalar t39 = t14 * t38 - t37;
  const Scalar t40 = Scalar(-0.0019191219015925) * t14;
  const Scalar t41 = t37 - t40 * (Scalar(0.7873824239179353) * c_5 * c_5 -
      Scalar(0.39369121195896767) + c_5);
  c[13] = t39 + t41;
  const Scalar c_5_1_4 = t39 - t41;
  c[90] = c_5_1_4;
  c[49] = -c_4_2_3;
  c[88] = -c_3_2_5;
  const Scalar t42 = Scalar(0.425) * c_2;
  const Scalar t43 = Scalar(0.39225) * t13 + t42;
  const Scalar Iu_5_t_xx = c_5 * t28 - Scalar(0.00075554142733495);
  const Scalar Iu_4_t_d = Iu_5_t_xx + Scalar(0.006077390365825);
  const Scalar t44 = t14 * (Iu_4_t_d * t16 - t19 * (t43 - Scalar(0.18726084874392154) * t14));
  const Scalar t45 = t16 * (Scalar(0.003292500193635) * t17 - Iu_4_t_d * t14 +
      Scalar(0.0754436725) * t43);
  const Scalar c_4_1_1 = t43 * (t19 * t14 + Scalar(0.0754436725) * t16) - t44 + t45;
  c[63] = c_4_1_1;
  const Scalar t46 = Scalar(0.01758242695) * c_5 * (t43 - Scalar(0.09465) * t14) -
      Scalar(0.0019191219015925) * t17;
  const Scalar t47 = Scalar(0.000017926614) * t15 + t46;
  c[14] = Scalar(-2.0) * t47;
  const Scalar t48 = s_3 * Ic_3_yz;
  const Scalar t49 = c_3 * Ic_3_yz;
  const Scalar mu_u_4_3_t_y = t49 - s_3 * t30;
  const Scalar t50 = c_2 * (t48 + c_3 * t30) + s_2 * mu_u_4_3_t_y;
  c[7] = t35 - t50;
  const Scalar c_2_1_4 = t35 + t50;
  c[27] = c_2_1_4;
  const Scalar t51 = t34 * t15;
  const Scalar t52 = t51 + s_5 * (Scalar(0.01758242695) * t16 * t18 - t14 * t11);
  const Scalar mu_5_3_x = Scalar(0.0016462500968175) * t29 + s_4 * t38;
  const Scalar t53 = c_4 * t38 - Scalar(0.0016462500968175) * s_5 *
      (s_4 - Scalar(4.189343395921486));
  const Scalar t54 = s_2 * (c_3 * t53 - s_3 * mu_5_3_x + Scalar(0.00747253145375) * s_5);
  const Scalar db_15_2 = c_2 * (c_3 * mu_5_3_x + s_3 * t53) + t54;
  c[11] = db_15_2 + t52;
  const Scalar c_5_1_2 = db_15_2 - t52;
  c[85] = c_5_1_2;
  c[66] = -c_3_1_4;
  const Scalar t55 = t51 + s_5 * (Scalar(0.0068967069711375) * t16 * t5 - t14 * dmu_3_5_y);
  const Scalar t56 = t13 * mu_5_3_x + w_1_3_x * t53;
  c[12] = t56 + t55;
  const Scalar c_5_1_3 = t56 - t55;
  c[87] = c_5_1_3;
  c[73] = -c_5_1_4;
  c[6] = -c_4_1_1;
  const Scalar Iu_3_t_yz = t49 + s_3 * t31;
  const Scalar t57 = s_2 * Iu_3_t_yz;
  const Scalar t58 = c_3 * t31 - t48;
  const Scalar t59 = t57 - c_2 * t58;
  c[4] = t33 - t59;
  const Scalar c_2_1_3 = t33 + t59;
  c[24] = c_2_1_3;
  c[64] = -c_2_1_4;
  c[31] = -c_5_1_2;
  c[52] = -c_5_1_3;
  c[2] = Scalar(2.0) * (c_2 * (t26 + t58 + Scalar(0.1746501428125)) - t57);
  const Scalar t60 = c_5 * (Scalar(0.000017926614) * t16 - t14 * t3);
  const Scalar t61 = t14 * (t60 - s_5 * (t14 * t34 - t40));
  const Scalar db_11_5r = t61 + t16 * (t46 + t47);
  c[10] = db_11_5r;
  c[43] = -c_2_1_3;
  const Scalar Iu_4_t_g = Scalar(0.00658500038727) * t1 + Scalar(2.0) * c_4 * Iu_4_t_d;
  const Scalar t62 = Iu_5_t_xx - c_4 * Iu_4_t_g - Scalar(0.7845) * hu_4_t_x +
      Scalar(0.2900169589877);
  const Scalar t63 = dI_4_xx - s_4 * Iu_4_t_g + f_3_3_x;
  const Scalar dmu_1_3_x = t63 * w_1_3_x + hc_3_x * t42 - t62 * t13;
  const Scalar t64 = t13 * (c_2 * t23 + t63 * t13 + t62 * w_1_3_x);
  const Scalar t65 = t42 * (Scalar(1.2746972594008923) * f_3_3_x * t13 - hc_3_x * w_1_3_x);
  const Scalar c_3_1_1 = t65 - w_1_3_x * dmu_1_3_x + t64;
  c[42] = c_3_1_1;
  c[84] = -db_11_5r;
  c[3] = -c_3_1_1;
  const Scalar t66 = Scalar(-2.0) * (c_3 * t62 - s_3 * t63);
  const Scalar t67 = s_3 * t21 + t62 + c_3 * t66 + c_3 * t20 - Scalar(0.696467139575);
  const Scalar t68 = t63 + c_3_2_2 - s_3 * t66;
  const Scalar t69 = s_2 * (s_2 * t68 + c_2 * t67);
  const Scalar db_11_2r = t69 - c_2 * (c_2 * t68 - s_2 * t67);
  c[1] = db_11_2r;
  c[21] = -db_11_2r;
  c[0] = c[15] = c[20] = c[22] = c[23] = c[37] = c[38] = c[39] = Scalar(0.0);
  c[41] = c[45] = c[46] = c[47] = c[58] = c[59] = c[60] = c[62] = Scalar(0.0);
  c[69] = c[70] = c[71] = c[72] = c[79] = c[80] = c[81] = c[83] = Scalar(0.0);
  c[94] = c[95] = c[96] = c[97] = c[98] = c[103] = c[104] = c[105] = Scalar(0.0);
  c[107] = c[109] = c[110] = c[112] = c[113] = c[114] = c[119] = c[120] = Scalar(0.0);
  c[121] = c[122] = c[123] = c[124] = c[125] = Scalar(0.0);
}

// The entries of C in coriolis_matrix that are not always zero.
inline constexpr bool coriolis_matrix_nonzero[36] = {
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 0, 1,
    1, 1, 1, 1, 1, 0};

// C(q, qd) from the Christoffel symbols (7.44).
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   C[36]  out  c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric
//               6 x 6, row by row: entry (i, j) is C[6 * i + j]
// Reads q[1..4], qd[0..5]. Operations: 260 mul, 195 add, 8 sin/cos. Always zero: 2 of the 36
// entries of C.
template <class Scalar, class SinCos = LibrarySinCos>
inline void coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar t1 = c_5 * s_5;
  const Scalar t2 = Scalar(0.0015110828546699) * t1;
  const Scalar C_44 = qd_5 * t2;
  C[21] = C_44;
  const Scalar t3 = Scalar(0.01758242695) * s_5;
  const Scalar f_3_3_x = s_4 * t3 + Scalar(0.0754436725) * c_4;
  const Scalar t4 = Scalar(0.7845) * f_3_3_x;
  const Scalar t5 = Scalar(0.00075554142733495) * s_5;
  const Scalar dmu_3_5_y = t5 + Scalar(0.0068967069711375) * c_4;
  const Scalar t6 = Scalar(2.0) * c_5;
  const Scalar t7 = dmu_3_5_y * t6;
  const Scalar t8 = qd_4 * t4 - qd_5 * t7;
  C[14] = -t8;
  const Scalar t9 = c_2 * c_3 - s_2 * s_3;
  const Scalar w_1_3_x = c_2 * s_3 + s_2 * c_3;
  const Scalar t10 = c_4 * t9 - s_4 * w_1_3_x;
  const Scalar t11 = Scalar(0.00006605859375) * s_5;
  const Scalar t12 = qd_1 * t10 * t11;
  const Scalar t13 = qd_5 * t11;
  C[17] = C[23] = t12 - t13;
  C[32] = C[33] = -t12 - t13;
  const Scalar t14 = c_3 * c_4 - s_3 * s_4;
  const Scalar t15 = c_2 * t14 - s_2 * (c_3 * s_4 + s_3 * c_4);
  const Scalar t16 = t15 * t11;
  const Scalar t17 = qd_1 * t16;
  C[11] = t17 - t13;
  const Scalar t18 = c_4 * w_1_3_x + s_4 * t9;
  const Scalar t19 = c_5 * t18;
  const Scalar t20 = Scalar(-0.00006605859375) * t19;
  const Scalar t21 = qd_3 + qd_4;
  const Scalar t22 = qd_2 + t21;
  const Scalar C_65 = qd_1 * t20 - t11 * t22;
  C[34] = C_65;
  C[31] = -t17 - t13;
  const Scalar t23 = s_5 * t10;
  C[5] = C[30] = -qd_2 * t16 - Scalar(0.00006605859375) * (qd_5 * t19 + t23 * t21);
  const Scalar hu_4_t_x = Scalar(0.0754436725) * s_4 - c_4 * t3;
  const Scalar hc_3_x = hu_4_t_x - Scalar(0.7972258875);
  const Scalar t24 = c_3 * f_3_3_x;
  const Scalar t25 = t24 - s_3 * hc_3_x;
  const Scalar t26 = Scalar(-0.85) * t25;
  const Scalar t27 = qd_3 * t26;
  const Scalar t28 = Scalar(0.425) * s_3;
  const Scalar t29 = Scalar(0.425) * c_3 + Scalar(0.39225);
  const Scalar t30 = c_4 * t28 + s_4 * t29;
  const Scalar t31 = c_4 * t29 - s_4 * t28;
  const Scalar t32 = t3 * t30 + Scalar(0.0754436725) * t31;
  const Scalar t33 = t5 + Scalar(0.01758242695) * t31;
  const Scalar t34 = Scalar(-2.0) * (qd_4 * t32 - c_5 * qd_5 * t33);
  C[7] = t34 + t27;
  C[29] = -C_65;
  const Scalar t35 = Scalar(-0.0016462500968175) * t23;
  const Scalar t36 = Scalar(0.0019191219015925) * c_5 + Scalar(0.00191870002108495);
  const Scalar t37 = t18 * t36 - t35;
  const Scalar t38 = Scalar(0.0019191219015925) * t19 + t35 +
      Scalar(0.0015110828546699) * t18 * (c_5 * c_5 - Scalar(0.5));
  const Scalar t39 = t37 - t38;
  const Scalar t40 = qd_6 * t11;
  const Scalar C_54 = t40 - t2 * t22 + qd_1 * t39;
  C[27] = C_54;
  const Scalar t41 = Scalar(0.425) * c_2;
  const Scalar t42 = Scalar(0.39225) * t9 + t41;
  const Scalar t43 = Scalar(0.00075554142733495) * c_5;
  const Scalar Iu_5_t_xx = c_5 * t43 - Scalar(0.00075554142733495);
  const Scalar Iu_4_t_d = Iu_5_t_xx + Scalar(0.006077390365825);
  const Scalar t44 = Scalar(0.003292500193635) * s_5;
  const Scalar t45 = t18 * (t3 * t42 - t44 * t18 - Iu_4_t_d * t10);
  const Scalar t46 = t10 * (Scalar(0.003292500193635) * t23 - Iu_4_t_d * t18 +
      Scalar(0.0754436725) * t42);
  const Scalar t47 = t45 + t42 * (t3 * t18 + Scalar(0.0754436725) * t10) + t46;
  const Scalar t48 = t10 * t40;
  const Scalar t49 = t48 + qd_1 * t47;
  const Scalar t50 = Scalar(0.00075554142733495) * t1;
  const Scalar Ic_4_yz = Scalar(0.0016462500968175) * c_5 - Scalar(0.000017926614);
  const Scalar Ic_3_yz = s_4 * t50 + c_4 * Ic_4_yz + Scalar(0.10915) * f_3_3_x;
  const Scalar t51 = s_3 * Ic_3_yz;
  const Scalar t52 = s_4 * Ic_4_yz - c_4 * t50 + Scalar(0.10915) * hu_4_t_x;
  const Scalar t53 = c_3 * Ic_3_yz;
  const Scalar mu_u_4_3_t_y = t53 - s_3 * t52;
  const Scalar t54 = c_2 * (t51 + c_3 * t52) + s_2 * mu_u_4_3_t_y;
  const Scalar t55 = t43 + Scalar(0.0019191219015925);
  const Scalar t56 = t23 * t55 - t18 * (Ic_4_yz + Scalar(0.008234676853375));
  const Scalar t57 = t56 + t54;
  const Scalar t58 = Ic_3_yz * w_1_3_x;
  const Scalar t59 = t58 + t52 * t9;
  const Scalar t60 = t56 + t59;
  C[18] = -qd_5 * t39 - qd_2 * t57 - qd_3 * t60 + t49;
  const Scalar t61 = t56 - t54;
  const Scalar t62 = t56 - t59;
  const Scalar t63 = t37 + t38;
  const Scalar t64 = -qd_5 * t63 - qd_2 * t61 - qd_3 * t62 - Scalar(2.0) * qd_4 * t56 + t49;
  C[3] = -t64;
  const Scalar t65 = Scalar(2.0) * qd_2;
  const Scalar t66 = qd_1 * t57 - t32 * t65;
  const Scalar t67 = Scalar(0.39225) * f_3_3_x;
  const Scalar t68 = t67 + t32;
  const Scalar t69 = Scalar(0.425) * t24 - hu_4_t_x * t28;
  const Scalar t70 = t69 + t68;
  C[9] = t34 + t66 - qd_3 * t70;
  const Scalar c_3_2_4 = t69 - t68;
  const Scalar t71 = qd_1 * t60 + qd_2 * c_3_2_4 - qd_3 * t4;
  C[15] = t71 - t8;
  C[20] = C_44 - t71;
  C[22] = qd_5 * t44 - C_54;
  const Scalar t72 = Scalar(0.0068967069711375) * c_5 - t52 + Scalar(0.063261281833125);
  const Scalar Iu_3_t_yz = t53 + s_3 * t72;
  const Scalar t73 = s_2 * Iu_3_t_yz;
  const Scalar t74 = c_3 * t72 - t51;
  const Scalar t75 = t73 - c_2 * t74;
  const Scalar t76 = t72 * t9 - t58;
  const Scalar t77 = t76 + t75;
  const Scalar t78 = qd_1 * t77 + qd_2 * t26;
  const Scalar t79 = c_5 * (t33 + dmu_3_5_y);
  const Scalar t80 = Scalar(0.00747253145375) * c_5;
  const Scalar t81 = t80 * t14;
  const Scalar t82 = t81 + t79;
  C[8] = qd_5 * t82 - qd_4 * t70 + t27 + t78;
  C[19] = C_44 - t66 - qd_3 * c_3_2_4;
  const Scalar t83 = Scalar(-0.01758242695) * t10;
  const Scalar t84 = t30 - Scalar(0.09363042437196077);
  const Scalar t85 = t55 * t19;
  const Scalar t86 = t85 - s_5 * (t84 * t83 + t18 * t33);
  const Scalar t87 = Scalar(0.0016462500968175) * s_5;
  const Scalar mu_5_3_x = c_4 * t87 + s_4 * t36;
  const Scalar t88 = c_4 * t36 - s_4 * t87 + Scalar(0.0068967069711375) * s_5;
  const Scalar mu_u_5_3_t_x = c_3 * mu_5_3_x + s_3 * t88;
  const Scalar t89 = s_2 * (c_3 * t88 - s_3 * mu_5_3_x + Scalar(0.00747253145375) * s_5);
  const Scalar db_15_2 = c_2 * mu_u_5_3_t_x + t89;
  const Scalar c_5_1_2 = db_15_2 - t86;
  const Scalar t90 = t33 * t6;
  const Scalar t91 = t40 + qd_1 * c_5_1_2 - qd_2 * t90;
  const Scalar t92 = t81 - t79;
  const Scalar t93 = qd_4 * t2;
  C[25] = qd_3 * t92 - t93 + t91;
  const Scalar t94 = Scalar(0.39225) * s_4 - Scalar(0.09363042437196077);
  const Scalar t95 = t85 - s_5 * (t94 * t83 + t18 * dmu_3_5_y);
  const Scalar t96 = t9 * mu_5_3_x + w_1_3_x * t88;
  const Scalar t97 = t96 - t95;
  const Scalar t98 = t40 + qd_1 * t97 + qd_2 * t92 - qd_3 * t7;
  C[26] = t98 - t93;
  const Scalar t99 = qd_5 * Scalar(0.0351648539) * s_5;
  C[10] = qd_3 * t82 + qd_4 * t90 - t84 * t99 - t91;
  C[13] = qd_4 * c_3_2_4 - qd_5 * t92 - t78;
  C[16] = qd_4 * t7 - t94 * t99 - t98;
  const Scalar t100 = Scalar(0.01758242695) *
      (c_5 * (t42 - Scalar(0.09465) * t18) - Scalar(0.10915) * t23);
  const Scalar t101 = Scalar(0.000017926614) * t19 + t100;
  const Scalar t102 = c_5 * (Scalar(0.000017926614) * t10 - t18 * t5);
  const Scalar t103 = t18 * (t102 - s_5 * t18 * (Scalar(0.0019191219015925) + t55));
  const Scalar t104 = t103 + t10 * (t100 + t101);
  const Scalar t105 = qd_6 * t20 + qd_1 * t104;
  const Scalar c_1_2_5 = db_15_2 + t86;
  const Scalar t106 = t96 + t95;
  C[4] = qd_4 * t63 + t105 + qd_3 * t106 + qd_2 * c_1_2_5 - Scalar(2.0) * qd_5 * t101;
  const Scalar Iu_4_t_g = s_4 * t44 + c_4 * Iu_4_t_d;
  const Scalar t107 = s_4 * Iu_4_t_g - t87 - t67;
  const Scalar t108 = Scalar(-2.0) * t107;
  const Scalar t109 = Iu_5_t_xx - Scalar(2.0) * c_4 * Iu_4_t_g - Scalar(0.7845) * hu_4_t_x +
      Scalar(0.2900169589877);
  const Scalar dmu_1_3_x = t108 * w_1_3_x + hc_3_x * t41 - t109 * t9;
  const Scalar t110 = t9 * (f_3_3_x * t41 + t108 * t9 + t109 * w_1_3_x);
  const Scalar c_3_1_1 = t41 * (f_3_3_x * t9 - hc_3_x * w_1_3_x) - w_1_3_x * dmu_1_3_x + t110;
  const Scalar t111 = t48 + qd_1 * c_3_1_1;
  C[12] = qd_4 * t60 - qd_5 * t97 - qd_2 * t77 + t111;
  C[24] = qd_4 * t39 - t105 + qd_3 * t97 + qd_2 * c_5_1_2;
  const Scalar t112 = t76 - t75;
  const Scalar t113 = -qd_5 * t106 - qd_4 * t62 - qd_2 * t112 - Scalar(2.0) * qd_3 * t76 + t111;
  C[2] = -t113;
  const Scalar t114 = c_3 * t109 - s_3 * t108;
  const Scalar t115 = Scalar(-2.0) * (t107 - Scalar(0.425) * t25 - s_3 * t114);
  const Scalar hu_3_t_x = s_3 * f_3_3_x + c_3 * hc_3_x;
  const Scalar t116 = Scalar(0.85) * hu_3_t_x + t109 - Scalar(2.0) * c_3 * t114 -
      Scalar(0.696467139575);
  const Scalar t117 = s_2 * (s_2 * t115 + c_2 * t116);
  const Scalar t118 = t117 - c_2 * (c_2 * t115 - s_2 * t116);
  C[0] = qd_5 * t104 - qd_4 * t47 - qd_3 * c_3_1_1 + qd_2 * t118;
  const Scalar t119 = qd_1 * t118 - t15 * t40;
  const Scalar t120 = (c_2 * (t80 + t74 + Scalar(0.1746501428125)) - t73) * t65;
  C[1] = qd_4 * t61 + qd_5 * c_1_2_5 + qd_3 * t112 + t120 + t119;
  C[6] = qd_4 * t57 - qd_5 * c_5_1_2 + qd_3 * t77 - t119;
  C[28] = C[35] = Scalar(0.0);
}

// Gravity torques g(q) (7.39).
//   q[6]  in   joint positions, rad or m
//   g[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..4]. Operations: 22 mul, 12 add, 8 sin/cos. Always zero: g[0], g[5].
template <class Scalar, class SinCos = LibrarySinCos>
inline void gravity(const Scalar* q, Scalar* g, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar t1 = Scalar(0.344967216759) * s_5;
  const Scalar t2 = s_4 * t1 + Scalar(1.48020485445) * c_4;
  const Scalar t3 = s_2 * c_3 + c_2 * s_3;
  const Scalar hu_4_t_x = Scalar(1.48020485445) * s_4 - c_4 * t1;
  const Scalar t4 = s_2 * s_3 - c_2 * c_3;
  g[3] = t2 * t3 - hu_4_t_x * t4;
  g[4] = Scalar(0.344967216759) * c_5 * (s_4 * t4 - c_4 * t3);
  const Scalar hc_3_x = hu_4_t_x - Scalar(15.64157191275);
  const Scalar t5 = s_2 * (s_3 * hc_3_x - c_3 * t2);
  const Scalar hu_3_t_x = s_3 * t2 + c_3 * hc_3_x;
  g[2] = c_2 * hu_3_t_x - t5;
  const Scalar hc_2_x = hu_3_t_x - Scalar(38.1586437);
  g[1] = c_2 * hc_2_x - t5;
  g[0] = g[5] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   n[6]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5], qd[0..5]. Operations: 155 mul, 98 add, 10 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = s_2 * s_3 - c_2 * c_3;
  const Scalar t2 = c_2 * s_3 + s_2 * c_3;
  const Scalar t3 = s_4 * t1 - c_4 * t2;
  const Scalar t4 = qd_1 * t3;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t4;
  const Scalar t5 = s_4 * t2 + c_4 * t1;
  const Scalar t6 = qd_1 * omega_4_z;
  const Scalar t7 = t5 * t6;
  const Scalar t8 = qd_5 * omega_r_5_x - s_5 * t7;
  n[5] = Scalar(-0.0001321171875) * t8;
  const Scalar t9 = qd_1 * qd_1;
  const Scalar t10 = c_2 * t9;
  const Scalar t11 = c_2 * t10 + qd_2 * qd_2;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 + Scalar(0.425) * t11;
  const Scalar t12 = s_2 * t10;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.425) * t12;
  const Scalar t13 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t14 = t9 * t1;
  const Scalar t15 = t2 * t14;
  const Scalar t16 = t13 - Scalar(0.39225) * t15;
  const Scalar t17 = t1 * t14;
  const Scalar t18 = t17 + omega_3_z * omega_3_z;
  const Scalar ddp_o_4_x = Scalar(0.39225) * t18 + s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar t19 = s_4 * t16 - c_4 * ddp_o_4_x;
  const Scalar t20 = t9 * t3;
  const Scalar t21 = t5 * t20;
  const Scalar t22 = t17 + t9 * t2 * t2;
  const Scalar t23 = qd_1 * omega_3_z;
  const Scalar t24 = t2 * t23;
  const Scalar t25 = qd_1 * qd_2;
  const Scalar t26 = s_2 * t25;
  const Scalar t27 = Scalar(0.10915) * t22 + Scalar(0.7845) * t24 + Scalar(0.85) * t26;
  const Scalar t28 = s_5 * (t27 - Scalar(0.1893) * t7) + c_5 * (Scalar(0.09465) * t21 + t19);
  const Scalar omega_5_z = qd_5 + qd_1 * t5;
  const Scalar t29 = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t30 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar omega_r_5_y = s_5 * t4 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t31 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar t32 = t31 * (s_6 * t29 - c_6 * t30);
  const Scalar t33 = omega_r_5_x * omega_5_z;
  const Scalar t34 = omega_r_5_x * omega_r_5_y;
  const Scalar t35 = t3 * t6;
  const Scalar mu_5_z = t32 - Scalar(0.000035853228) * (t8 - t33) -
      Scalar(0.0016432000421699) * t34 - Scalar(0.0038374000421699) * t35 +
      Scalar(0.0351648539) * t28;
  n[4] = mu_5_z;
  const Scalar t36 = (s_6 * t30 + c_6 * t29) * t31;
  const Scalar t37 = omega_4_z * omega_4_z;
  const Scalar t38 = t3 * t20 + t37;
  const Scalar ddp_o_5_y = Scalar(0.09465) * t38 - s_4 * ddp_o_4_x - c_4 * t16;
  const Scalar domega_5_x = qd_5 * omega_r_5_y - c_5 * t7;
  const Scalar t39 = omega_5_z * omega_5_z;
  const Scalar t40 = omega_r_5_y * omega_5_z;
  const Scalar t41 = Scalar(0.000035853228) * (t39 - omega_r_5_y * omega_r_5_y) + t36 -
      Scalar(0.0016432000421699) * domega_5_x - Scalar(0.0038374000421699) * t40 +
      Scalar(0.0351648539) * ddp_o_5_y;
  const Scalar t42 = t35 + t34;
  const Scalar t43 = Scalar(0.000035853228) * t42 + Scalar(0.0001321171875) * t8 +
      Scalar(0.0021942) * t33;
  const Scalar t44 = t39 + omega_r_5_x * omega_r_5_x;
  const Scalar t45 = s_5 * t44 + c_5 * t42;
  const Scalar t46 = c_5 * t43 + Scalar(0.01434898073165) * t21 - Scalar(0.003328353421635) * t45 +
      s_5 * t41 + Scalar(0.150887345) * t19;
  n[3] = -t46;
  const Scalar t47 = Scalar(0.150887345) * t21 - Scalar(0.0351648539) * t45;
  const Scalar U_5_zy = domega_5_x + t40;
  const Scalar f_4_y = Scalar(0.150887345) * t38 - Scalar(0.0351648539) * U_5_zy;
  const Scalar t48 = s_4 * t47 - c_4 * f_4_y;
  const Scalar n_3 = Scalar(0.39225) * t48 - t46 - Scalar(0.56787913724375) * t15 +
      Scalar(1.594451775) * t13;
  n[2] = n_3;
  const Scalar t49 = c_4 * t47 + s_4 * f_4_y;
  const Scalar f_3_x = Scalar(1.594451775) * t18 - t49;
  const Scalar t50 = c_3 * (Scalar(1.594451775) * t15 - t48) + s_3 * f_3_x;
  n[1] = Scalar(1.39293427915) * t12 + n_3 - Scalar(0.425) * t50 - Scalar(38.1586437) * c_2;
  const Scalar t51 = s_5 * t42 - c_5 * t44;
  const Scalar t52 = t37 - t9 * t5 * t5;
  const Scalar mu_4_x = Scalar(0.000035853228) * t52 + s_5 * t43 - Scalar(0.003328353421635) * t51 -
      c_5 * t41 - Scalar(0.0308921614633) * t7 + Scalar(0.150887345) * t27;
  const Scalar t53 = Scalar(0.000035853228) * t21 + Scalar(0.0021942) * t35 - mu_5_z;
  const Scalar t54 = Scalar(0.11652684955123307) * t51 + t7;
  const Scalar U_3_zz_xx = t18 - t22;
  const Scalar t55 = Scalar(0.10915) * t49 - c_4 * t53 - s_4 * mu_4_x -
      Scalar(0.1183711221525) * t54 - Scalar(0.12652256366625) * U_3_zz_xx +
      Scalar(1.1398532744875) * t24 + Scalar(1.35528400875) * t26;
  const Scalar t56 = Scalar(0.004095) * t1 * t23 + s_4 * t53 - Scalar(0.10915) * t48 +
      Scalar(0.12652256366625) * t15 - c_4 * mu_4_x;
  const Scalar mu_2_x = Scalar(0.0151074) * c_2 * t25 - c_3 * t56 + Scalar(0.349300285625) * t12 +
      s_3 * t55;
  const Scalar t57 = s_3 * t56 - Scalar(0.12825424325) * t54 + Scalar(0.349300285625) * (t9 - t11) +
      Scalar(1.35528400875) * t24 + c_3 * t55 + Scalar(2.8009759583) * t26;
  n[0] = s_2 * mu_2_x - c_2 * t57;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   tau[6]  in   joint torques or forces, N m or N
//   qdd[6]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[1..5], qd[0..5], tau[0..5]. Operations: 303 mul, 219 add, 4 div, 10 sin/cos.
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
  const Scalar t1 = s_2 * s_3 - c_2 * c_3;
  const Scalar t2 = c_2 * s_3 + s_2 * c_3;
  const Scalar t3 = s_4 * t1 - c_4 * t2;
  const Scalar t4 = qd_1 * t3;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t4;
  const Scalar t5 = s_4 * t2 + c_4 * t1;
  const Scalar omega_5_z = qd_5 + qd_1 * t5;
  const Scalar t6 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar t7 = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar omega_r_5_y = s_5 * t4 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t8 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar t9 = (s_6 * t6 + c_6 * t7) * t8;
  const Scalar t10 = qd_1 * qd_1;
  const Scalar t11 = c_2 * t10;
  const Scalar t12 = c_2 * t11 + qd_2 * qd_2;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 + Scalar(0.425) * t12;
  const Scalar t13 = s_2 * t11;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.425) * t13;
  const Scalar t14 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t15 = t10 * t1;
  const Scalar t16 = t2 * t15;
  const Scalar t17 = t14 - Scalar(0.39225) * t16;
  const Scalar t18 = t10 * t3;
  const Scalar t19 = omega_4_z * omega_4_z;
  const Scalar t20 = t3 * t18 + t19;
  const Scalar t21 = t1 * t15 + omega_3_z * omega_3_z;
  const Scalar ddp_o_4_x = Scalar(0.39225) * t21 + s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar ddp_o_5_y = Scalar(0.09465) * t20 - s_4 * ddp_o_4_x - c_4 * t17;
  const Scalar t22 = omega_5_z * omega_5_z;
  const Scalar t23 = Scalar(0.000035853228) * (t22 - omega_r_5_y * omega_r_5_y) + t9 -
      Scalar(0.0054806000843398) * omega_r_5_y * omega_5_z + Scalar(0.0351648539) * ddp_o_5_y;
  const Scalar t24 = qd_1 * omega_4_z;
  const Scalar t25 = t5 * t24;
  const Scalar t26 = qd_5 * omega_r_5_x - s_5 * t25;
  const Scalar t27 = omega_r_5_x * omega_r_5_y;
  const Scalar t28 = t3 * t24;
  const Scalar t29 = t28 + t27;
  const Scalar t30 = omega_r_5_x * omega_5_z;
  const Scalar t31 = Scalar(0.0015110828546699) * t26 - Scalar(0.000035853228) * t29 -
      Scalar(0.0038374000421699) * t30;
  const Scalar y_6 = Scalar(0.0001321171875) * t26 + tau_6;
  const Scalar t32 = t22 + omega_r_5_x * omega_r_5_x;
  const Scalar t33 = s_5 * t32 + c_5 * t29;
  const Scalar t34 = s_4 * t17 - c_4 * ddp_o_4_x;
  const Scalar t35 = t5 * t18;
  const Scalar t36 = Scalar(0.0159921807738199) * t35 - Scalar(0.003328353421635) * t33 +
      s_5 * t23 + Scalar(0.150887345) * t34 - c_5 * (t31 + y_6);
  const Scalar t37 = t10 * (t2 * t2 + t1 * t1);
  const Scalar t38 = qd_1 * omega_3_z;
  const Scalar t39 = t2 * t38;
  const Scalar t40 = qd_1 * qd_2;
  const Scalar t41 = s_2 * t40;
  const Scalar t42 = Scalar(0.10915) * t37 + Scalar(0.7845) * t39 + Scalar(0.85) * t41;
  const Scalar t43 = s_5 * (t42 - Scalar(0.1893) * t25) + c_5 * (Scalar(0.09465) * t35 + t34);
  const Scalar t44 = t8 * (s_6 * t7 - c_6 * t6);
  const Scalar t45 = t44 - Scalar(0.000035853228) * (t26 - t30) - Scalar(0.0016432000421699) * t27 -
      Scalar(0.0038374000421699) * t28 + Scalar(0.0351648539) * t43;
  const Scalar y_5 = tau_5 - t45;
  const Scalar t46 = Scalar(0.8580028554367816) * c_5;
  const Scalar y_5_4 = t36 + t46 * y_5 + tau_4;
  const Scalar t47 = c_5 * c_5;
  const Scalar t48 = Scalar(0.0015110828546699) * t47;
  const Scalar t49 = t48 - Scalar(0.0181863807738199);
  const Scalar t50 = c_4 * s_5;
  const Scalar hu_4_t_x = Scalar(0.150887345) * s_4 - Scalar(0.0351648539) * t50;
  const Scalar t51 = Scalar(0.0001321171875) * t47 + t49 + Scalar(0.39225) * hu_4_t_x;
  const Scalar t52 = s_4 - Scalar(0.23870089068696182);
  const Scalar t53 = t47 * t52;
  const Scalar t54 = t51 - Scalar(0.011834788548693463) * t53;
  const Scalar t55 = Scalar(0.002957091755164986) * t47 + t49;
  const Scalar t56 = Scalar(1.0) / t55;
  const Scalar t57 = t54 * t56;
  const Scalar t58 = Scalar(0.150887345) * t35 - Scalar(0.0351648539) * t33;
  const Scalar U_5_zy = omega_r_5_y * (qd_5 + omega_5_z) - c_5 * t25;
  const Scalar f_4_y = Scalar(0.150887345) * t20 - Scalar(0.0351648539) * U_5_zy;
  const Scalar t59 = s_4 * t58 - c_4 * f_4_y;
  const Scalar t60 = Scalar(0.39225) * t59 - Scalar(0.56787913724375) * t16 - t36 +
      Scalar(1.594451775) * t14;
  const Scalar t61 = Scalar(3.594468596105858) * c_5 * t52;
  const Scalar y_4_3 = tau_3 - t60 - t61 * y_5 - t57 * y_5_4;
  const Scalar t62 = Scalar(0.7845) * hu_4_t_x;
  const Scalar t63 = Scalar(0.0016432000421699) * t47 + t62 - Scalar(0.5901605180175699);
  const Scalar t64 = Scalar(0.04957999324859619) * t52 * t53 - t54 * t57 + t63;
  const Scalar t65 = Scalar(1.0) / t64;
  const Scalar t66 = s_4 * s_5;
  const Scalar f_3_3_x = Scalar(0.0351648539) * t66 + Scalar(0.150887345) * c_4;
  const Scalar t67 = s_3 * f_3_3_x;
  const Scalar f_u_4_3_t_y = t67 + c_3 * hu_4_t_x;
  const Scalar t68 = s_3 * c_4 + c_3 * s_4;
  const Scalar t69 = Scalar(0.9229411764705883) * t52;
  const Scalar t70 = t68 + t69;
  const Scalar t71 = t47 * t70;
  const Scalar t72 = Scalar(0.425) * f_u_4_3_t_y - Scalar(0.012822906649317328) * t71 + t51;
  const Scalar hc_3_x = hu_4_t_x - Scalar(1.594451775);
  const Scalar hu_3_t_x = t67 + c_3 * hc_3_x;
  const Scalar t73 = Scalar(0.053719559287835256) * t70 * t53 - t72 * t57 +
      Scalar(0.425) * hu_3_t_x + t63;
  const Scalar t74 = t73 * t65;
  const Scalar t75 = c_4 * t58 + s_4 * f_4_y;
  const Scalar f_3_x = Scalar(1.594451775) * t21 - t75;
  const Scalar t76 = c_3 * (Scalar(1.594451775) * t16 - t59) + s_3 * f_3_x;
  const Scalar t77 = t72 * t56;
  const Scalar t78 = Scalar(3.8945803781899033) * c_5 * t70;
  const Scalar y_3_2 = tau_2 - Scalar(1.39293427915) * t13 + Scalar(0.425) * t76 - t60 +
      Scalar(38.1586437) * c_2 - t78 * y_5 - t74 * y_4_3 - t77 * y_5_4;
  const Scalar t79 = Scalar(0.003292500193635) * s_5;
  const Scalar t80 = Scalar(0.003838243803185) * c_5 + Scalar(0.0038374000421699);
  const Scalar t81 = t79 * (s_4 - Scalar(4.189343395921486)) - c_4 * t80;
  const Scalar mu_5_3_x = Scalar(0.003292500193635) * t50 + s_4 * t80;
  const Scalar t82 = c_2 * (-s_3 * mu_5_3_x - c_3 * t81 + Scalar(0.0149450629075) * s_5);
  const Scalar t83 = s_2 * (s_3 * t81 - c_3 * mu_5_3_x) + t82;
  const Scalar t84 = s_5 * (s_2 * (s_3 * s_4 - c_3 * c_4) - c_2 * t68);
  const Scalar t85 = Scalar(-0.0001321171875) * t84;
  const Scalar t86 = c_5 * t85;
  const Scalar t87 = Scalar(0.0015110828546699) * c_5;
  const Scalar Ic_4_yz = Scalar(0.003292500193635) * c_5 - Scalar(0.000035853228);
  const Scalar Ic_3_yz = t66 * t87 + c_4 * Ic_4_yz + Scalar(0.10915) * f_3_3_x;
  const Scalar t88 = s_3 * Ic_3_yz;
  const Scalar t89 = s_4 * Ic_4_yz - t50 * t87 + Scalar(0.10915) * hu_4_t_x;
  const Scalar t90 = s_2 * (t88 + c_3 * t89);
  const Scalar t91 = c_3 * Ic_3_yz;
  const Scalar mu_u_4_3_t_y = t91 - s_3 * t89;
  const Scalar t92 = t83 * t46 - t86 + t90 - c_2 * mu_u_4_3_t_y;
  const Scalar t93 = Scalar(0.013793413942275) * c_5 - t89 + Scalar(0.12652256366625);
  const Scalar Iu_3_t_yz = t91 + s_3 * t93;
  const Scalar t94 = t86 + c_2 * Iu_3_t_yz;
  const Scalar t95 = t88 - c_3 * t93;
  const Scalar t96 = t83 * t61 + t92 * t57 + t94 - s_2 * t95;
  const Scalar t97 = Scalar(0.0149450629075) * c_5;
  const Scalar t98 = s_2 * (t95 - t97 - Scalar(0.349300285625));
  const Scalar t99 = t83 * t78 + t92 * t77 + t94 - t96 * t74 - t98;
  const Scalar t100 = Scalar(0.85) * hu_3_t_x;
  const Scalar t101 = Scalar(0.058204748750363244) * t70 * t71 - t72 * t77 + t100 + t63 -
      t73 * t74 - Scalar(1.40804167915);
  const Scalar t102 = Scalar(1.0) / t101;
  const Scalar t103 = t99 * t102;
  const Scalar t104 = s_5 * t29 - c_5 * t32;
  const Scalar t105 = t19 - t10 * t5 * t5;
  const Scalar mu_4_x = Scalar(0.000035853228) * t105 - s_5 * t31 -
      Scalar(0.003328353421635) * t104 - c_5 * t23 - Scalar(0.0341785615476398) * t25 +
      Scalar(0.150887345) * t42;
  const Scalar t106 = Scalar(0.000035853228) * t35 + Scalar(0.0021942) * t28 - t45;
  const Scalar t107 = Scalar(0.11652684955123307) * t104 + t25;
  const Scalar U_3_zz_xx = t21 - t37;
  const Scalar t108 = Scalar(0.10915) * t75 - c_4 * t106 - s_4 * mu_4_x -
      Scalar(0.1183711221525) * t107 - Scalar(0.12652256366625) * U_3_zz_xx +
      Scalar(1.1398532744875) * t39 + Scalar(1.35528400875) * t41;
  const Scalar t109 = Scalar(0.004095) * t1 * t38 + s_4 * t106 - Scalar(0.10915) * t59 +
      Scalar(0.12652256366625) * t16 - c_4 * mu_4_x;
  const Scalar mu_2_x = Scalar(0.0151074) * c_2 * t40 - c_3 * t109 + Scalar(0.349300285625) * t13 +
      s_3 * t108;
  const Scalar t110 = s_3 * t109 - Scalar(0.12825424325) * t107 +
      Scalar(0.349300285625) * (t10 - t12) + Scalar(1.35528400875) * t39 + c_3 * t108 +
      Scalar(2.8009759583) * t41;
  const Scalar t111 = t96 * t65;
  const Scalar t112 = t92 * t56;
  const Scalar t113 = Scalar(260.5931070544678) * t83;
  const Scalar y_2_1 = t111 * y_4_3 - t84 * y_6 - s_2 * mu_2_x + tau_1 + t103 * y_3_2 -
      t112 * y_5_4 + t113 * y_5 + c_2 * t110;
  const Scalar Iu_5_t_xx = t48 - Scalar(0.0015110828546699);
  const Scalar Iu_4_t_d = Iu_5_t_xx + Scalar(0.01215478073165);
  const Scalar Iu_4_t_g = Scalar(0.00658500038727) * t66 + c_4 * Iu_4_t_d;
  const Scalar t114 = c_4 * Iu_4_t_g;
  const Scalar t115 = Scalar(0.00767648760637) * c_5;
  const Scalar Ic_3_xx = t114 + t115 - Scalar(0.01215478073165);
  const Scalar Ic_3_yy = Iu_5_t_xx - t114 + t115 - t62 + Scalar(0.56787913724375);
  const Scalar Iu_3_t_d = Ic_3_xx - Ic_3_yy;
  const Scalar t116 = t79 - s_4 * Iu_4_t_g + Scalar(0.39225) * f_3_3_x;
  const Scalar Iu_3_t_g = Scalar(2.0) * s_3 * t116 + c_3 * Iu_3_t_d;
  const Scalar t117 = c_3 * Iu_3_t_g;
  const Scalar Iu_3_t_xx = t117 + Ic_3_yy;
  const Scalar t118 = c_2 * (Ic_3_xx - t117 - Iu_3_t_xx - t100 + Scalar(1.39293427915));
  const Scalar t119 = t116 - Scalar(0.425) * (s_3 * hc_3_x - c_3 * f_3_3_x) - s_3 * Iu_3_t_g;
  const Scalar t120 = c_2 * (Scalar(2.0) * s_2 * t119 - t118);
  const Scalar b_2_1_1 = t84 * t85 + t96 * t111 + t92 * t112 - t83 * t113 + t99 * t103 +
      Scalar(0.1879281038293699) + Iu_3_t_xx - t120;
  const Scalar d_1 = Scalar(1.0) / b_2_1_1;
  const Scalar qdd_1 = d_1 * y_2_1;
  qdd[0] = qdd_1;
  const Scalar t121 = t102 * (y_3_2 - t99 * qdd_1);
  qdd[1] = -t121;
  const Scalar t122 = t65 * (y_4_3 - t96 * qdd_1 - t73 * t121);
  qdd[2] = -t122;
  const Scalar t123 = t56 * (t92 * qdd_1 - t72 * t121 - t54 * t122 + y_5_4);
  qdd[3] = -t123;
  const Scalar t124 = t83 * qdd_1 + t97 * (t69 * t122 + t70 * t121) + y_5;
  qdd[4] = Scalar(260.5931070544678) * t124 - t46 * t123;
  qdd[5] = c_5 * (t121 + t122 + t123) - t84 * qdd_1 + Scalar(7569.03790432263) * y_6;
  bool positive = b_2_1_1 > Scalar(0.0);
  positive &= -t101 > Scalar(0.0);
  positive &= -t64 > Scalar(0.0);
  positive &= -t55 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[6]   in  joint positions, rad or m
//   qd[6]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1..4], qd[0..5]. Operations: 67 mul, 42 add, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar kinetic_energy(const Scalar* q, const Scalar* qd,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = s_2 * qd_1;
  const Scalar omega_r_3_x = s_3 * t1 + c_3 * t2;
  const Scalar t3 = c_3 * qd_2;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t4 = Scalar(0.10915) * omega_r_3_x + Scalar(0.425) * t3 +
      Scalar(0.39225) * omega_3_z;
  const Scalar t5 = s_3 * t2 - c_3 * t1;
  const Scalar t6 = Scalar(0.10915) * t5 + Scalar(0.425) * s_3 * qd_2;
  const Scalar t7 = c_4 * t6 + s_4 * t4;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar t8 = s_4 * t5 - c_4 * omega_r_3_x;
  const Scalar v_o_4_z = Scalar(0.425) * t1 - Scalar(0.39225) * t5;
  const Scalar v_o_5_z = Scalar(0.09465) * t8 + v_o_4_z;
  const Scalar v_r_5_x = s_5 * v_o_5_z - c_5 * (t7 - Scalar(0.09465) * omega_4_z);
  const Scalar omega_r_5_y = s_5 * t8 + c_5 * omega_4_z;
  const Scalar t9 = Scalar(0.000035853228) * omega_r_5_y;
  const Scalar t10 = s_4 * omega_r_3_x + c_4 * t5;
  const Scalar t11 = t10 + qd_5;
  const Scalar t12 = t11 * (-t9 - Scalar(0.0038374000421699) * t11 +
      Scalar(0.0703297078) * v_r_5_x);
  const Scalar omega_6_z = omega_r_5_y + qd_6;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t8;
  const Scalar t13 = omega_r_5_x *
      (Scalar(0.0703297078) * (s_4 * t6 - c_4 * t4) - Scalar(0.0016432000421699) * omega_r_5_x);
  const Scalar t14 = Scalar(-0.000035853228) * t10;
  const Scalar t15 = omega_4_z * (t14 - Scalar(0.01654318073165) * omega_4_z +
      Scalar(0.30177469) * t7);
  const Scalar t16 = t8 * (Scalar(0.01434898073165) * t8 + Scalar(0.30177469) * v_o_4_z);
  const Scalar L_3_z = Scalar(0.12652256366625) * omega_r_3_x +
      Scalar(0.57197413724375) * omega_3_z + Scalar(1.35528400875) * t3;
  const Scalar t17 = omega_r_3_x *
      (Scalar(0.56787913724375) * omega_r_3_x - Scalar(0.12652256366625) * omega_3_z);
  const Scalar L_2_x = Scalar(0.349300285625) * qd_2 - Scalar(1.39293427915) * t2;
  const Scalar L_2_z = Scalar(0.349300285625) * t2 + Scalar(1.40804167915) * qd_2;
  const Scalar T_2 = t11 * t9 - omega_4_z * t14 + Scalar(0.0001321171875) * omega_6_z * omega_6_z -
      t12 - t13 + t16 - t15 - t17 - Scalar(1.35528400875) * t1 * t5 + t2 * L_2_x +
      omega_3_z * L_3_z + qd_2 * L_2_z + Scalar(2.1327493394493) * qd_1 * qd_1;
  return Scalar(0.5) * T_2;
}

// Potential energy of links and rotors (7.36).
//   q[6]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[1..4]. Operations: 12 mul, 8 add, 7 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar potential_energy(const Scalar* q, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4];
  const Scalar t1 = Scalar(0.0351648539) * s_5;
  const Scalar t2 = s_4 * t1 + Scalar(0.150887345) * c_4;
  const Scalar hc_3_x = Scalar(0.150887345) * s_4 - c_4 * t1 - Scalar(1.594451775);
  const Scalar hc_2_x = s_3 * t2 + c_3 * hc_3_x - Scalar(3.88977);
  const Scalar t3 = c_2 * (s_3 * hc_3_x - c_3 * t2) + Scalar(1.4253058751) + s_2 * hc_2_x;
  return Scalar(9.81) * t3;
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
// Reads q[0..5]. Operations: 66 mul, 34 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void forward_kinematics(const Scalar* q, Scalar* R, Scalar* p,
    const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = s_4 * s_5;
  const Scalar t2 = c_4 * s_5;
  const Scalar t3 = s_3 * t1 - c_3 * t2;
  const Scalar t4 = s_3 * t2 + c_3 * t1;
  R[8] = s_2 * t3 - c_2 * t4;
  const Scalar t5 = Scalar(0.0823) * t1 + Scalar(0.09465) * c_4;
  const Scalar p_4_x = Scalar(0.09465) * s_4 - Scalar(0.0823) * t2 - Scalar(0.39225);
  const Scalar p_3_x = s_3 * t5 + c_3 * p_4_x - Scalar(0.425);
  const Scalar t6 = s_3 * p_4_x - c_3 * t5;
  p[2] = Scalar(0.089159) + c_2 * t6 + s_2 * p_3_x;
  const Scalar t7 = s_4 * s_6;
  const Scalar t8 = c_5 * t7 - c_4 * c_6;
  const Scalar t9 = c_4 * c_5;
  const Scalar t10 = s_4 * c_6;
  const Scalar t11 = t10 + s_6 * t9;
  const Scalar t12 = s_3 * t8 - c_3 * t11;
  const Scalar t13 = s_3 * t11 + c_3 * t8;
  R[7] = s_2 * t12 - c_2 * t13;
  const Scalar t14 = s_2 * t4 + c_2 * t3;
  R[2] = s_1 * c_5 + c_1 * t14;
  R[5] = s_1 * t14 - c_1 * c_5;
  const Scalar n_4_t_y = c_5 * t10 + c_4 * s_6;
  const Scalar t15 = t7 - c_6 * t9;
  const Scalar t16 = s_3 * n_4_t_y + c_3 * t15;
  const Scalar t17 = s_3 * t15 - c_3 * n_4_t_y;
  R[6] = -s_2 * t16 - c_2 * t17;
  const Scalar t18 = s_2 * t6 - c_2 * p_3_x;
  const Scalar p_4_z = Scalar(0.0823) * c_5 + Scalar(0.10915);
  p[0] = s_1 * p_4_z - c_1 * t18;
  const Scalar n_2_t_x = s_2 * t17 - c_2 * t16;
  const Scalar t19 = s_1 * s_5;
  R[0] = c_6 * t19 + c_1 * n_2_t_x;
  const Scalar t20 = c_1 * s_5;
  R[3] = s_1 * n_2_t_x - c_6 * t20;
  const Scalar t21 = s_2 * t13 + c_2 * t12;
  R[4] = s_1 * t21 + s_6 * t20;
  p[1] = -c_1 * p_4_z - s_1 * t18;
  R[1] = c_1 * t21 - s_6 * t19;
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[36] = {
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    0, 1, 1, 1, 1, 1,
    0, 1, 1, 1, 1, 1,
    0, 1, 1, 1, 1, 1,
    1, 0, 0, 0, 1, 1};

// Geometric Jacobian of the tip (7.14), (7.15).
//   q[6]   in   joint positions, rad or m
//   J[36]  out  geometric Jacobian in base axes: linear rows, then angular
//               6 x 6, row by row: entry (i, j) is J[6 * i + j]
// Reads q[0..4]. Operations: 72 mul, 37 add, 10 sin/cos. Always zero: 6 of the 36 entries of J.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian(const Scalar* q, Scalar* J, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  J[19] = J[20] = J[21] = s_1;
  J[25] = J[26] = J[27] = -c_1;
  const Scalar R_32_x = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = s_2 * s_3 - c_2 * c_3;
  const Scalar J_65 = s_4 * R_32_x + c_4 * t1;
  J[34] = J_65;
  const Scalar t2 = c_4 * R_32_x - s_4 * t1;
  const Scalar z_5_x = c_1 * t2;
  J[22] = z_5_x;
  const Scalar z_5_y = s_1 * t2;
  J[28] = z_5_y;
  const Scalar t3 = s_5 * t2;
  J[35] = -t3;
  const Scalar t4 = s_5 * J_65;
  const Scalar R_50_y = c_1 * t4 + s_1 * c_5;
  J[23] = R_50_y;
  const Scalar J_56 = s_1 * t4 - c_1 * c_5;
  J[29] = J_56;
  const Scalar t5 = Scalar(0.0823) * s_5;
  const Scalar p_4_x = Scalar(0.09465) * s_4 - c_4 * t5 - Scalar(0.39225);
  const Scalar t6 = s_4 * t5 + Scalar(0.09465) * c_4;
  const Scalar t7 = s_3 * p_4_x - c_3 * t6;
  const Scalar p_3_x = s_3 * t6 + c_3 * p_4_x - Scalar(0.425);
  const Scalar t8 = s_2 * t7 - c_2 * p_3_x;
  const Scalar p_4_z = Scalar(0.0823) * c_5 + Scalar(0.10915);
  const Scalar p_1u_t_x = s_1 * p_4_z - c_1 * t8;
  J[6] = p_1u_t_x;
  const Scalar J_P1_x = c_1 * p_4_z + s_1 * t8;
  J[0] = J_P1_x;
  const Scalar t9 = c_2 * t7 + s_2 * p_3_x;
  J[1] = -c_1 * t9;
  J[7] = -s_1 * t9;
  const Scalar t10 = Scalar(0.425) * s_2 + t9;
  J[2] = -c_1 * t10;
  J[8] = -s_1 * t10;
  const Scalar t11 = Scalar(0.39225) * R_32_x + t10;
  J[3] = -c_1 * t11;
  J[9] = -s_1 * t11;
  J[13] = c_1 * p_1u_t_x - s_1 * J_P1_x;
  const Scalar t12 = Scalar(0.425) * c_2;
  const Scalar t13 = J_P1_x - s_1 * t12;
  const Scalar r_3_x = c_1 * t12 + p_1u_t_x;
  J[14] = c_1 * r_3_x - s_1 * t13;
  const Scalar t14 = Scalar(-0.39225) * t1;
  const Scalar t15 = Scalar(0.10915) * c_1 + s_1 * t14 - t13;
  const Scalar t16 = Scalar(0.10915) * s_1 - c_1 * t14 - r_3_x;
  J[15] = s_1 * t15 - c_1 * t16;
  const Scalar t17 = t15 - Scalar(0.09465) * z_5_y;
  const Scalar t18 = t11 - Scalar(0.09465) * J_65;
  J[5] = t17 * t3 + t18 * J_56;
  const Scalar t19 = Scalar(0.09465) * z_5_x + t16;
  J[17] = t17 * R_50_y + t19 * J_56;
  J[4] = z_5_y * t18 - J_65 * t17;
  J[10] = -J_65 * t19 - z_5_x * t18;
  J[16] = t2 * (s_1 * t19 + c_1 * t17);
  J[11] = t19 * t3 - t18 * R_50_y;
  J[30] = Scalar(1.0);
  J[12] = J[18] = J[24] = J[31] = J[32] = J[33] = Scalar(0.0);
}

// (dJ/dt) qd of the tip.
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads q[0..5], qd[0..5]. Operations: 128 mul, 67 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = s_2 * s_3;
  const Scalar t2 = t1 - c_2 * c_3;
  const Scalar t3 = s_2 * c_3;
  const Scalar t4 = c_2 * s_3 + t3;
  const Scalar t5 = s_4 * t2 - c_4 * t4;
  const Scalar t6 = qd_1 * t5;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar t7 = s_5 * omega_4_z;
  const Scalar omega_r_5_x = t7 - c_5 * t6;
  const Scalar t8 = s_4 * t4 + c_4 * t2;
  const Scalar t9 = qd_1 * t8;
  const Scalar omega_5_z = qd_5 + t9;
  const Scalar t10 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar t11 = c_5 * omega_4_z;
  const Scalar omega_r_5_y = s_5 * t6 + t11;
  const Scalar domega_5_x = qd_5 * omega_r_5_y - t11 * t9;
  const Scalar t12 = omega_4_z * t6;
  const Scalar t13 = c_6 * t12 + qd_6 * t10 - s_6 * domega_5_x;
  const Scalar t14 = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t15 = qd_6 * t14 - s_6 * t12 - c_6 * domega_5_x;
  const Scalar t16 = s_6 * t13 + c_6 * t15;
  const Scalar t17 = qd_5 * omega_r_5_x - t7 * t9;
  const Scalar domega_e_5_t_x = s_5 * t17 - c_5 * t16;
  const Scalar domega_e_6_a_z = s_6 * t15 - c_6 * t13;
  const Scalar t18 = s_4 * domega_e_5_t_x - c_4 * domega_e_6_a_z;
  const Scalar domega_e_4_t_x = s_4 * domega_e_6_a_z + c_4 * domega_e_5_t_x;
  const Scalar t19 = s_3 * t18 - c_3 * domega_e_4_t_x;
  const Scalar t20 = s_3 * domega_e_4_t_x + c_3 * t18;
  a[5] = c_2 * t20 - s_2 * t19;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t21 = (t4 * omega_3_z + Scalar(1.0834926704907584) * s_2 * qd_2) -
      Scalar(0.2413001912045889) * t8 * omega_4_z;
  const Scalar t22 = qd_1 * qd_1;
  const Scalar t23 = t22 * t2;
  const Scalar t24 = t2 * t23;
  const Scalar t25 = Scalar(0.10915) * (t24 + t22 * t4 * t4) + Scalar(0.7845) * qd_1 * t21;
  const Scalar t26 = c_2 * t22;
  const Scalar t27 = c_2 * t26 + qd_2 * qd_2;
  const Scalar t28 = Scalar(0.425) * (t26 * t3 + s_3 * t27) - Scalar(0.39225) * t4 * t23;
  const Scalar t29 = t26 * t1 - c_3 * t27;
  const Scalar ddp_o_4_x = Scalar(0.39225) * (t24 + omega_3_z * omega_3_z) - Scalar(0.425) * t29;
  const Scalar t30 = t22 * t5;
  const Scalar t31 = Scalar(0.09465) * t8 * t30 + s_4 * t28 - c_4 * ddp_o_4_x;
  const Scalar t32 = s_5 * t25 + c_5 * t31;
  const Scalar t33 = t5 * t30 + omega_4_z * omega_4_z;
  const Scalar t34 = Scalar(0.09465) * t33 - c_4 * t28 - s_4 * ddp_o_4_x;
  const Scalar t35 = Scalar(0.0823) * (t15 - t14 * omega_6_z) + s_6 * t32 + c_6 * t34;
  const Scalar t36 = Scalar(0.0823) * (t13 - t10 * omega_6_z) + s_6 * t34 - c_6 * t32;
  const Scalar t37 = s_6 * t35 - c_6 * t36;
  const Scalar t38 = t14 * t14 + t10 * t10;
  const Scalar t39 = Scalar(0.0823) * t38 - s_5 * t31 + c_5 * t25;
  const Scalar t40 = s_5 * t39 - c_5 * t37;
  const Scalar t41 = s_6 * t36 + c_6 * t35;
  const Scalar t42 = s_4 * t40 + c_4 * t41;
  const Scalar t43 = s_4 * t41 - c_4 * t40;
  const Scalar t44 = s_3 * t42 + c_3 * t43;
  const Scalar t45 = s_3 * t43 - c_3 * t42;
  a[2] = -s_2 * t44 - c_2 * t45;
  const Scalar t46 = s_2 * t20 + c_2 * t19;
  const Scalar domega_e_2_a_y = s_5 * t16 + c_5 * t17;
  a[3] = -s_1 * domega_e_2_a_y - c_1 * t46;
  a[4] = c_1 * domega_e_2_a_y - s_1 * t46;
  const Scalar t47 = s_2 * t45 - c_2 * t44;
  const Scalar a_2_a_y = s_5 * t37 + c_5 * t39;
  a[1] = s_1 * t47 + c_1 * a_2_a_y;
  a[0] = c_1 * t47 - s_1 * a_2_a_y;
}

}  // namespace ur5

#endif  // FLATDYN_UR5_HPP

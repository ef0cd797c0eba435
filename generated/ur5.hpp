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
// Every function is a template over its scalar: float, double, or any type that has + - * / and
// sin, cos where argument-dependent lookup finds them. Arguments are plain arrays:
//
//   double q[6] = {}, qd[6] = {}, qdd[6] = {}, tau[6];
//   ur5::inverse_dynamics(q, qd, qdd, tau);
//
// Entries come in the order of the table. Units are SI; "rad or m" goes by the type of the joint.
// Every entry of an output is written, zeros too. All inputs are read before anything is written:
// an output may overlap an input, but outputs must not overlap each other. Nothing allocates,
// throws, or keeps state. In the code, names count from 1 as in the textbook: q_1 is q[0], s_1 its
// sine, c_1 its cosine, s_12 the sine of q_1 + q_2.

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

// tau = B(q) qdd + C(q, qd) qd + g(q) + friction (7.42).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5], qd[0..5], qdd[0..5]. Operations: 175 mul, 135 add, 10 sin/cos.
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
  const Scalar U_2_xx = t14 + t2 * t2;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 + Scalar(0.425) * U_2_xx;
  const Scalar t15 = t2 * t1;
  const Scalar U_2_yx = qdd_2 + t15;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.425) * U_2_yx;
  const Scalar t16 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t17 = t3 * omega_3_z;
  const Scalar t18 = t11 - t17;
  const Scalar t19 = omega_r_3_x * t3;
  const Scalar U_3_yx = domega_3_z - t19;
  const Scalar t20 = t16 + Scalar(0.39225) * U_3_yx - Scalar(0.10915) * t18;
  const Scalar t21 = omega_r_3_x * omega_3_z;
  const Scalar t22 = t3 * t3;
  const Scalar U_3_xx = omega_3_z * omega_3_z + t22;
  const Scalar ddp_o_4_x = Scalar(0.39225) * U_3_xx - Scalar(0.10915) * (t10 - t21) +
      s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar t23 = s_4 * t20 - c_4 * ddp_o_4_x;
  const Scalar t24 = t4 * t5;
  const Scalar U_4_xy = domega_4_z - t24;
  const Scalar t25 = t5 * omega_4_z;
  const Scalar t26 = t12 + t25;
  const Scalar t27 = t10 + t21;
  const Scalar U_3_zz = t22 + omega_r_3_x * omega_r_3_x;
  const Scalar U_2_zx = t8 + t9;
  const Scalar ddp_o_4_z = Scalar(0.425) * U_2_zx + Scalar(0.39225) * t27 +
      Scalar(0.10915) * U_3_zz;
  const Scalar ddp_o_5_z = ddp_o_4_z - Scalar(0.09465) * t26;
  const Scalar t28 = s_5 * ddp_o_5_z + c_5 * (t23 - Scalar(0.09465) * U_4_xy);
  const Scalar omega_r_5_y = s_5 * t4 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t29 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar t30 = s_6 * t29;
  const Scalar omega_5_z = qd_5 + t5;
  const Scalar omega_r_6_y = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t31 = c_6 * t29;
  const Scalar t32 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar t33 = omega_r_5_x * omega_5_z;
  const Scalar domega_4_y = qd_4 * t4 + s_4 * t11 - c_4 * t10;
  const Scalar domega_5_z = qdd_5 - domega_4_y;
  const Scalar t34 = omega_r_5_x * omega_r_5_y;
  const Scalar tau_5 = Scalar(0.0351648539) * t28 + Scalar(0.0038374000421699) * domega_5_z -
      Scalar(0.0016432000421699) * t34 - Scalar(0.000035853228) * (t13 - t33) + omega_r_6_y * t30 -
      t32 * t31;
  tau[4] = tau_5;
  const Scalar t35 = omega_4_z * omega_4_z;
  const Scalar U_4_yy = t35 + t4 * t4;
  const Scalar ddp_o_5_y = Scalar(0.09465) * U_4_yy - s_4 * ddp_o_4_x - c_4 * t20;
  const Scalar domega_5_x = qd_5 * omega_r_5_y + s_5 * domega_4_z - c_5 * t12;
  const Scalar t36 = omega_5_z * omega_5_z;
  const Scalar t37 = omega_r_5_y * omega_5_z;
  const Scalar mu_5_x = Scalar(0.0351648539) * ddp_o_5_y - Scalar(0.0016432000421699) * domega_5_x -
      Scalar(0.0038374000421699) * t37 +
      Scalar(0.000035853228) * (t36 - omega_r_5_y * omega_r_5_y) + t32 * t30 + omega_r_6_y * t31;
  const Scalar U_5_xy = domega_5_z - t34;
  const Scalar t38 = Scalar(0.000035853228) * U_5_xy - Scalar(0.0021942) * t33 + N_6_z;
  const Scalar U_5_yy = t36 + omega_r_5_x * omega_r_5_x;
  const Scalar t39 = Scalar(0.0351648539) * s_5;
  const Scalar t40 = Scalar(0.0351648539) * c_5;
  const Scalar t41 = U_5_yy * t39 - U_5_xy * t40;
  const Scalar t42 = t4 * omega_4_z;
  const Scalar U_4_xz = domega_4_y - t42;
  const Scalar t43 = Scalar(0.150887345) * t23 - Scalar(0.01654318073165) * domega_4_z +
      Scalar(0.01434898073165) * t24 + Scalar(0.000035853228) * U_4_xz - Scalar(0.09465) * t41 +
      s_5 * mu_5_x - c_5 * t38;
  tau[3] = -t43;
  const Scalar f_4_x = Scalar(0.150887345) * U_4_xy + t41;
  const Scalar U_5_zy = domega_5_x + t37;
  const Scalar f_4_y = Scalar(0.150887345) * U_4_yy - Scalar(0.0351648539) * U_5_zy;
  const Scalar f_u_4_t_y = s_4 * f_4_x + c_4 * f_4_y;
  const Scalar tau_3 = Scalar(1.594451775) * t16 + Scalar(0.57197413724375) * domega_3_z -
      Scalar(0.56787913724375) * t19 - Scalar(0.12652256366625) * t18 - t43 -
      Scalar(0.39225) * f_u_4_t_y;
  tau[2] = tau_3;
  const Scalar t44 = s_4 * f_4_y - c_4 * f_4_x;
  const Scalar f_3_x = Scalar(1.594451775) * U_3_xx - t44;
  const Scalar f_3_y = Scalar(1.594451775) * U_3_yx - f_u_4_t_y;
  const Scalar t45 = s_3 * f_3_x - c_3 * f_3_y;
  const Scalar t46 = Scalar(38.1586437) * c_2 - Scalar(1.40804167915) * qdd_2 -
      Scalar(0.349300285625) * t7 - Scalar(1.39293427915) * t15 - tau_3 + Scalar(0.425) * t45;
  tau[1] = -t46;
  const Scalar f_u_5_t_y = U_5_xy * t39 + U_5_yy * t40;
  const Scalar mu_4_x = Scalar(0.150887345) * ddp_o_4_z - Scalar(0.01434898073165) * t12 -
      Scalar(0.01654318073165) * t25 + Scalar(0.000035853228) * (t35 - t5 * t5) +
      Scalar(0.09465) * f_u_5_t_y - s_5 * t38 - c_5 * mu_5_x;
  const Scalar mu_4_y = Scalar(0.000035853228) * U_4_xy - Scalar(0.0021942) * t42 + tau_5;
  const Scalar t47 = Scalar(0.150887345) * t26 - f_u_5_t_y;
  const Scalar U_3_zz_xx = U_3_xx - U_3_zz;
  const Scalar mu_3_y = Scalar(0.677642004375) * U_2_zx + Scalar(1.1398532744875) * t21 -
      Scalar(0.12652256366625) * U_3_zz_xx - Scalar(0.39225) * t47 + Scalar(0.10915) * t44 -
      s_4 * mu_4_x + c_4 * mu_4_y;
  const Scalar t48 = Scalar(0.56787913724375) * t11 + Scalar(0.12652256366625) * U_3_yx -
      Scalar(0.57197413724375) * t17 - Scalar(0.10915) * f_u_4_t_y + s_4 * mu_4_y + c_4 * mu_4_x;
  const Scalar mu_2_x = Scalar(1.40804167915) * t6 - Scalar(1.39293427915) * domega_2_x +
      Scalar(0.349300285625) * U_2_yx + s_3 * mu_3_y + c_3 * t48;
  const Scalar mu_2_y = Scalar(2.8009759583) * t8 + Scalar(0.677642004375) * t27 -
      Scalar(0.349300285625) * (t14 - t1 * t1) - Scalar(0.425) * t47 - s_3 * t48 + c_3 * mu_3_y;
  tau[0] = Scalar(2.1327493394493) * qdd_1 + s_2 * mu_2_x - c_2 * mu_2_y;
}

// inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..5], qd[0..5], qdd[0..5], h_e[0..5]. Operations: 229 mul, 169 add, 12 sin/cos.
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
  const Scalar omega_r_6_y = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar omega_r_5_y = s_5 * t4 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t25 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar mu_e4_y = s_4 * t16 - c_4 * t15;
  const Scalar t26 = Scalar(0.0823) * t24 - omega_r_6_y * t25 + s_6 * mu_e4_y + c_6 * mu_e5_x;
  const Scalar f_e6_x = s_6 * f_e4_y + c_6 * f_e5_x;
  const Scalar t27 = (s_6 * omega_5_z - c_6 * omega_r_5_x) * t25;
  const Scalar mu_6_y = Scalar(0.0823) * f_e6_x + t27 - s_6 * mu_e5_x + c_6 * mu_e4_y;
  const Scalar t28 = qd_2 * qd_2;
  const Scalar U_2_xx = t28 + t2 * t2;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 + Scalar(0.425) * U_2_xx;
  const Scalar t29 = t2 * t1;
  const Scalar U_2_yx = qdd_2 + t29;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.425) * U_2_yx;
  const Scalar t30 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t31 = t3 * omega_3_z;
  const Scalar t32 = t11 - t31;
  const Scalar t33 = omega_r_3_x * t3;
  const Scalar U_3_yx = domega_3_z - t33;
  const Scalar t34 = t30 + Scalar(0.39225) * U_3_yx - Scalar(0.10915) * t32;
  const Scalar t35 = omega_r_3_x * omega_3_z;
  const Scalar t36 = t3 * t3;
  const Scalar U_3_xx = omega_3_z * omega_3_z + t36;
  const Scalar ddp_o_4_x = Scalar(0.39225) * U_3_xx - Scalar(0.10915) * (t10 - t35) +
      s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar t37 = s_4 * t34 - c_4 * ddp_o_4_x;
  const Scalar t38 = t4 * t5;
  const Scalar U_4_xy = domega_4_z - t38;
  const Scalar t39 = t5 * omega_4_z;
  const Scalar t40 = t12 + t39;
  const Scalar t41 = t10 + t35;
  const Scalar U_3_zz = t36 + omega_r_3_x * omega_r_3_x;
  const Scalar U_2_zx = t8 + t9;
  const Scalar ddp_o_4_z = Scalar(0.425) * U_2_zx + Scalar(0.39225) * t41 +
      Scalar(0.10915) * U_3_zz;
  const Scalar ddp_o_5_z = ddp_o_4_z - Scalar(0.09465) * t40;
  const Scalar t42 = s_5 * ddp_o_5_z + c_5 * (t37 - Scalar(0.09465) * U_4_xy);
  const Scalar t43 = omega_r_5_x * omega_5_z;
  const Scalar domega_4_y = qd_4 * t4 + s_4 * t11 - c_4 * t10;
  const Scalar domega_5_z = qdd_5 - domega_4_y;
  const Scalar t44 = omega_r_5_x * omega_r_5_y;
  const Scalar tau_5 = Scalar(0.0351648539) * t42 + Scalar(0.0038374000421699) * domega_5_z -
      Scalar(0.0016432000421699) * t44 - Scalar(0.000035853228) * (t13 - t43) - s_6 * t26 -
      c_6 * mu_6_y;
  tau[4] = tau_5;
  const Scalar U_5_xy = domega_5_z - t44;
  const Scalar f_5_x = Scalar(0.0351648539) * U_5_xy - s_6 * t24 - c_6 * f_e6_x;
  const Scalar t45 = omega_5_z * omega_5_z;
  const Scalar U_5_yy = t45 + omega_r_5_x * omega_r_5_x;
  const Scalar f_5_y = Scalar(0.0351648539) * U_5_yy - s_5 * t22 - c_5 * t23;
  const Scalar t46 = s_5 * f_5_y - c_5 * f_5_x;
  const Scalar t47 = omega_4_z * omega_4_z;
  const Scalar U_4_yy = t47 + t4 * t4;
  const Scalar ddp_o_5_y = Scalar(0.09465) * U_4_yy - s_4 * ddp_o_4_x - c_4 * t34;
  const Scalar domega_5_x = qd_5 * omega_r_5_y + s_5 * domega_4_z - c_5 * t12;
  const Scalar t48 = omega_r_5_y * omega_5_z;
  const Scalar mu_5_x = Scalar(0.0351648539) * ddp_o_5_y - Scalar(0.0016432000421699) * domega_5_x -
      Scalar(0.0038374000421699) * t48 +
      Scalar(0.000035853228) * (t45 - omega_r_5_y * omega_r_5_y) + s_6 * mu_6_y - c_6 * t26;
  const Scalar t49 = Scalar(0.000035853228) * U_5_xy - Scalar(0.0021942) * t43 + tau_6;
  const Scalar t50 = t4 * omega_4_z;
  const Scalar U_4_xz = domega_4_y - t50;
  const Scalar t51 = Scalar(0.150887345) * t37 - Scalar(0.01654318073165) * domega_4_z +
      Scalar(0.01434898073165) * t38 + Scalar(0.000035853228) * U_4_xz - Scalar(0.09465) * t46 +
      s_5 * mu_5_x - c_5 * t49;
  tau[3] = -t51;
  const Scalar f_4_x = Scalar(0.150887345) * U_4_xy + t46;
  const Scalar U_5_zy = domega_5_x + t48;
  const Scalar f_4_y = Scalar(0.150887345) * U_4_yy - Scalar(0.0351648539) * U_5_zy + s_6 * f_e6_x -
      c_6 * t24;
  const Scalar f_u_4_t_y = s_4 * f_4_x + c_4 * f_4_y;
  const Scalar tau_3 = Scalar(1.594451775) * t30 + Scalar(0.57197413724375) * domega_3_z -
      Scalar(0.56787913724375) * t33 - Scalar(0.12652256366625) * t32 - t51 -
      Scalar(0.39225) * f_u_4_t_y;
  tau[2] = tau_3;
  const Scalar t52 = s_4 * f_4_y - c_4 * f_4_x;
  const Scalar f_3_x = Scalar(1.594451775) * U_3_xx - t52;
  const Scalar f_3_y = Scalar(1.594451775) * U_3_yx - f_u_4_t_y;
  const Scalar t53 = s_3 * f_3_x - c_3 * f_3_y;
  const Scalar t54 = Scalar(38.1586437) * c_2 - Scalar(1.40804167915) * qdd_2 -
      Scalar(0.349300285625) * t7 - Scalar(1.39293427915) * t29 - tau_3 + Scalar(0.425) * t53;
  tau[1] = -t54;
  const Scalar f_u_5_t_y = s_5 * f_5_x + c_5 * f_5_y;
  const Scalar mu_4_x = Scalar(0.150887345) * ddp_o_4_z - Scalar(0.01434898073165) * t12 -
      Scalar(0.01654318073165) * t39 + Scalar(0.000035853228) * (t47 - t5 * t5) +
      Scalar(0.09465) * f_u_5_t_y - s_5 * t49 - c_5 * mu_5_x;
  const Scalar t55 = Scalar(0.150887345) * t40 - f_u_5_t_y;
  const Scalar mu_4_y = Scalar(0.000035853228) * U_4_xy - Scalar(0.0021942) * t50 + tau_5;
  const Scalar U_3_zz_xx = U_3_xx - U_3_zz;
  const Scalar mu_3_y = Scalar(0.677642004375) * U_2_zx + Scalar(1.1398532744875) * t35 -
      Scalar(0.12652256366625) * U_3_zz_xx - Scalar(0.39225) * t55 + Scalar(0.10915) * t52 -
      s_4 * mu_4_x + c_4 * mu_4_y;
  const Scalar t56 = Scalar(0.56787913724375) * t11 + Scalar(0.12652256366625) * U_3_yx -
      Scalar(0.57197413724375) * t31 - Scalar(0.10915) * f_u_4_t_y + s_4 * mu_4_y + c_4 * mu_4_x;
  const Scalar mu_2_x = Scalar(1.40804167915) * t6 - Scalar(1.39293427915) * domega_2_x +
      Scalar(0.349300285625) * U_2_yx + s_3 * mu_3_y + c_3 * t56;
  const Scalar mu_2_y = Scalar(2.8009759583) * t8 + Scalar(0.677642004375) * t41 -
      Scalar(0.349300285625) * (t28 - t1 * t1) - Scalar(0.425) * t55 - s_3 * t56 + c_3 * mu_3_y;
  tau[0] = Scalar(2.1327493394493) * qdd_1 + s_2 * mu_2_x - c_2 * mu_2_y;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[36] = {
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 0,
    1, 1, 1, 1, 0, 1};

// joint-space inertia matrix B(q) (7.32).
//   q[6]   in   joint positions, rad or m
//   B[36]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//               6 x 6, row by row: entry (i, j) is B[6 * i + j]
// Reads q[1..4]. Operations: 79 mul, 66 add, 8 sin/cos. Always zero: 2 of the 36 entries of B.
template <class Scalar>
inline void inertia_matrix(const Scalar* q, Scalar* B) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  B[22] = B[27] = Scalar(-0.003292500193635) * c_5;
  B[11] = B[17] = B[23] = B[31] = B[32] = B[33] = Scalar(0.0001321171875) * c_5;
  const Scalar t1 = Scalar(0.013793413942275) * c_5;
  const Scalar B_35 = t1 * (s_4 - Scalar(0.23870089068696182));
  B[16] = B[26] = B_35;
  const Scalar t2 = Scalar(0.0015110828546699) * c_5;
  const Scalar t3 = c_5 * t2;
  const Scalar Ic_4_zz = t3 - Scalar(0.0181863807738199);
  B[21] = -Ic_4_zz;
  const Scalar t4 = s_3 * c_4 + c_3 * s_4;
  const Scalar t5 = Scalar(0.0149450629075) * c_5;
  B[10] = B[25] = B_35 + t5 * t4;
  const Scalar t6 = c_4 * s_5;
  const Scalar hu_4_t_x = Scalar(0.150887345) * s_4 - Scalar(0.0351648539) * t6;
  const Scalar t7 = Scalar(0.7845) * hu_4_t_x;
  const Scalar Ic_3_zz = Ic_4_zz + t7 - Scalar(0.57197413724375);
  B[14] = -Ic_3_zz;
  const Scalar mu_4_3_z = Ic_4_zz + Scalar(0.39225) * hu_4_t_x;
  B[15] = B[20] = -mu_4_3_z;
  const Scalar t8 = s_4 * s_5;
  const Scalar hu_4_t_y = Scalar(0.150887345) * c_4 + Scalar(0.0351648539) * t8;
  const Scalar t9 = s_3 * hu_4_t_y;
  const Scalar f_u_4_3_t_y = t9 + c_3 * hu_4_t_x;
  B[9] = B[19] = -mu_4_3_z - Scalar(0.425) * f_u_4_3_t_y;
  const Scalar t10 = s_5 * (s_2 * (s_3 * s_4 - c_3 * c_4) - c_2 * t4);
  B[5] = B[30] = Scalar(0.0001321171875) * t10;
  const Scalar hc_3_x = hu_4_t_x - Scalar(1.594451775);
  const Scalar hu_3_t_x = t9 + c_3 * hc_3_x;
  B[8] = B[13] = -Ic_3_zz - Scalar(0.425) * hu_3_t_x;
  const Scalar t11 = Scalar(0.003838243803185) * c_5 + Scalar(0.0038374000421699);
  const Scalar t12 = Scalar(0.003292500193635) * s_5;
  const Scalar t13 = c_4 * t11 - t12 * (s_4 - Scalar(4.189343395921486));
  const Scalar mu_5_3_x = Scalar(0.003292500193635) * t6 + s_4 * t11;
  const Scalar mu_u_5_3_t_x = s_3 * t13 + c_3 * mu_5_3_x;
  const Scalar mu_5_2_y = Scalar(0.0149450629075) * s_5 - s_3 * mu_5_3_x + c_3 * t13;
  B[4] = B[24] = s_2 * mu_u_5_3_t_x - c_2 * mu_5_2_y;
  const Scalar t14 = Scalar(0.85) * hu_3_t_x;
  B[7] = Scalar(1.40804167915) - Ic_3_zz - t14;
  const Scalar Ic_4_yz = Scalar(0.003292500193635) * c_5 - Scalar(0.000035853228);
  const Scalar Ic_3_yz = Scalar(0.10915) * hu_4_t_y + t2 * t8 + c_4 * Ic_4_yz;
  const Scalar t15 = s_3 * Ic_3_yz;
  const Scalar mu_4_3_x = Scalar(0.10915) * hu_4_t_x + s_4 * Ic_4_yz - t2 * t6;
  const Scalar mu_u_4_3_t_x = t15 + c_3 * mu_4_3_x;
  const Scalar t16 = c_3 * Ic_3_yz;
  const Scalar mu_u_4_3_t_y = t16 - s_3 * mu_4_3_x;
  B[3] = B[18] = c_2 * mu_u_4_3_t_y - s_2 * mu_u_4_3_t_x;
  const Scalar t17 = mu_4_3_x - t1 - Scalar(0.12652256366625);
  const Scalar t18 = c_2 * (s_3 * t17 - t16);
  const Scalar t19 = t15 + c_3 * t17;
  B[2] = B[12] = -t18 - s_2 * t19;
  B[1] = B[6] = -s_2 * (t19 - t5 - Scalar(0.349300285625)) - t18;
  const Scalar Iu_5_t_xx = t3 - Scalar(0.0015110828546699);
  const Scalar Iu_4_t_d = Iu_5_t_xx + Scalar(0.01215478073165);
  const Scalar Iu_4_t_g = Scalar(0.00658500038727) * t8 + c_4 * Iu_4_t_d;
  const Scalar t20 = c_4 * Iu_4_t_g;
  const Scalar t21 = Scalar(0.00767648760637) * c_5;
  const Scalar Ic_3_xx = t20 + t21 - Scalar(0.01215478073165);
  const Scalar Ic_3_yy = Iu_5_t_xx - t20 + t21 - t7 + Scalar(0.56787913724375);
  const Scalar Iu_3_t_d = Ic_3_xx - Ic_3_yy;
  const Scalar Ic_3_xy = Scalar(0.39225) * hu_4_t_y - s_4 * Iu_4_t_g + t12;
  const Scalar Iu_3_t_g = Scalar(2.0) * s_3 * Ic_3_xy + c_3 * Iu_3_t_d;
  const Scalar t22 = c_3 * Iu_3_t_g;
  const Scalar Iu_3_t_xx = Ic_3_yy + t22;
  const Scalar t23 = c_2 * (Ic_3_xx - t22 - Iu_3_t_xx - t14 + Scalar(1.39293427915));
  const Scalar Ic_2_xy = Ic_3_xy - Scalar(0.425) * (s_3 * hc_3_x - c_3 * hu_4_t_y) - s_3 * Iu_3_t_g;
  B[0] = Iu_3_t_xx - c_2 * (Scalar(2.0) * s_2 * Ic_2_xy - t23) + Scalar(0.1879281038293699);
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
template <class Scalar>
inline void christoffel(const Scalar* q, Scalar* c) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar dI_4_xx = Scalar(0.003292500193635) * s_5;
  c[77] = dI_4_xx;
  const Scalar c_5_2_6 = Scalar(0.00006605859375) * s_5;
  c[100] = c[101] = c[102] = c_5_2_6;
  c[40] = c[61] = c[82] = c[116] = c[117] = c[118] = Scalar(-0.00006605859375) * s_5;
  const Scalar t1 = s_4 * s_5;
  const Scalar hu_4_t_y = Scalar(0.05918556107625) * c_4 + Scalar(0.013793413942275) * t1;
  c[68] = hu_4_t_y;
  const Scalar t2 = c_5 * s_5;
  c[74] = c[75] = c[76] = Scalar(0.0015110828546699) * t2;
  c[91] = c[92] = c[93] = Scalar(-0.0015110828546699) * t2;
  c[50] = c[51] = -hu_4_t_y;
  const Scalar t3 = Scalar(0.00075554142733495) * s_5;
  const Scalar dmu_3_5_y = Scalar(0.0068967069711375) * c_4 + t3;
  const Scalar t4 = Scalar(2.0) * c_5;
  const Scalar db_33_5r = t4 * dmu_3_5_y;
  c[54] = c[55] = db_33_5r;
  const Scalar t5 = s_4 - Scalar(0.23870089068696182);
  c[56] = Scalar(-0.013793413942275) * s_5 * t5;
  c[89] = -db_33_5r;
  const Scalar t6 = Scalar(0.425) * s_3;
  const Scalar v_o_2_4_y = Scalar(0.425) * c_3 + Scalar(0.39225);
  const Scalar v_2_4_x = c_4 * t6 + s_4 * v_o_2_4_y;
  const Scalar t7 = Scalar(0.0351648539) * s_5;
  const Scalar t8 = c_4 * v_o_2_4_y - s_4 * t6;
  const Scalar db_22_4r = Scalar(0.150887345) * t8 + v_2_4_x * t7;
  c[65] = db_22_4r;
  const Scalar t9 = Scalar(0.01758242695) * t8 + t3;
  const Scalar db_22_5r = t9 * t4;
  c[32] = c[34] = db_22_5r;
  const Scalar t10 = c_3 * c_4 - s_3 * s_4;
  const Scalar db_16_2 = c_5_2_6 * (c_2 * t10 - s_2 * (c_3 * s_4 + s_3 * c_4));
  c[36] = db_16_2;
  c[28] = c[30] = -db_22_4r;
  c[86] = -db_22_5r;
  const Scalar w_1_3_x = c_2 * s_3 + s_2 * c_3;
  const Scalar t11 = c_2 * c_3 - s_2 * s_3;
  const Scalar t12 = c_4 * w_1_3_x + s_4 * t11;
  const Scalar t13 = c_5 * t12;
  c[19] = c[115] = Scalar(-0.00006605859375) * t13;
  c[99] = Scalar(0.00006605859375) * t13;
  const Scalar t14 = c_4 * t11 - s_4 * w_1_3_x;
  const Scalar t15 = s_5 * t14;
  c[17] = c[18] = c[108] = c[111] = Scalar(-0.00006605859375) * t15;
  c[57] = c[78] = Scalar(0.00006605859375) * t15;
  c[16] = c[106] = -db_16_2;
  const Scalar t16 = v_2_4_x - Scalar(0.09363042437196077);
  c[35] = -t7 * t16;
  const Scalar t17 = Scalar(0.01758242695) * s_5;
  const Scalar hu_4_t_x = Scalar(0.0754436725) * s_4 - c_4 * t17;
  const Scalar hc_3_x = hu_4_t_x - Scalar(0.7972258875);
  const Scalar t18 = Scalar(0.85) * hc_3_x;
  const Scalar t19 = Scalar(1.0834926704907584) * hu_4_t_y;
  const Scalar db_22_3r = c_3 * t19 - s_3 * t18;
  c[44] = db_22_3r;
  const Scalar t20 = Scalar(0.5) * hu_4_t_y + Scalar(0.5) * db_22_4r;
  const Scalar t21 = Scalar(0.5417463352453792) * hu_4_t_y;
  const Scalar t22 = hu_4_t_x * t6 - c_3 * t21;
  c[29] = t22 - t20;
  const Scalar c_4_5 = t22 + t20;
  c[67] = c_4_5;
  const Scalar t23 = c_5 * dmu_3_5_y + c_5 * t9;
  const Scalar t24 = Scalar(0.00747253145375) * c_5;
  const Scalar t25 = t24 * t10;
  c[33] = t23 + t25;
  const Scalar c_3_2_5 = t23 - t25;
  c[53] = c_3_2_5;
  c[25] = c[26] = -db_22_3r;
  const Scalar t26 = Scalar(0.00075554142733495) * c_5;
  const Scalar t27 = c_4 * s_5;
  const Scalar Ic_4_yz = Scalar(0.0016462500968175) * c_5 - Scalar(0.000017926614);
  const Scalar mu_4_3_x = Scalar(0.10915) * hu_4_t_x - t26 * t27 + s_4 * Ic_4_yz;
  const Scalar t28 = Scalar(0.0068967069711375) * c_5 - mu_4_3_x + Scalar(0.063261281833125);
  const Scalar Ic_3_yz = Scalar(0.1391332058636074) * hu_4_t_y + c_4 * Ic_4_yz + t26 * t1;
  const Scalar t29 = Ic_3_yz * w_1_3_x;
  const Scalar t30 = t28 * t11 - t29;
  c[5] = Scalar(2.0) * t30;
  const Scalar t31 = t26 + Scalar(0.0019191219015925);
  const Scalar t32 = t15 * t31 - t12 * (Ic_4_yz + Scalar(0.008234676853375));
  c[9] = Scalar(2.0) * t32;
  const Scalar db_14_3 = t29 + mu_4_3_x * t11;
  c[8] = t32 - db_14_3;
  const Scalar c_3_7 = t32 + db_14_3;
  c[48] = c_3_7;
  const Scalar t33 = Scalar(-0.0016462500968175) * t15;
  const Scalar t34 = Scalar(0.0019191219015925) * c_5 + Scalar(0.00191870002108495);
  const Scalar t35 = t12 * t34 - t33;
  const Scalar t36 = Scalar(-0.0019191219015925) * t12;
  const Scalar t37 = t33 - t36 * (c_5 + Scalar(0.7873824239179353) * c_5 * c_5 -
      Scalar(0.39369121195896767));
  c[13] = t35 + t37;
  const Scalar c_4_1_5 = t35 - t37;
  c[90] = c_4_1_5;
  c[49] = -c_4_5;
  c[88] = -c_3_2_5;
  const Scalar t38 = Scalar(0.425) * c_2;
  const Scalar t39 = Scalar(0.39225) * t11 + t38;
  const Scalar Iu_5_t_xx = c_5 * t26 - Scalar(0.00075554142733495);
  const Scalar Iu_4_t_d = Iu_5_t_xx + Scalar(0.006077390365825);
  const Scalar t40 = t12 * (Iu_4_t_d * t14 - t17 * (t39 - Scalar(0.18726084874392154) * t12));
  const Scalar t41 = t14 * (Scalar(0.0754436725) * t39 + Scalar(0.003292500193635) * t15 -
      Iu_4_t_d * t12);
  const Scalar db_11_4r = t39 * (Scalar(0.0754436725) * t14 + t17 * t12) - t40 + t41;
  c[63] = db_11_4r;
  const Scalar t42 = Scalar(0.01758242695) * c_5 * (t39 - Scalar(0.09465) * t12) -
      Scalar(0.0019191219015925) * t15;
  const Scalar t43 = t42 + Scalar(0.000017926614) * t13;
  c[14] = Scalar(-2.0) * t43;
  const Scalar t44 = s_3 * Ic_3_yz;
  const Scalar mu_u_4_3_t_x = t44 + c_3 * mu_4_3_x;
  const Scalar t45 = c_3 * Ic_3_yz;
  const Scalar mu_u_4_3_t_y = t45 - s_3 * mu_4_3_x;
  const Scalar db_14_2 = c_2 * mu_u_4_3_t_x + s_2 * mu_u_4_3_t_y;
  c[7] = t32 - db_14_2;
  const Scalar c_2_7 = t32 + db_14_2;
  c[27] = c_2_7;
  const Scalar t46 = t31 * t13;
  const Scalar t47 = t46 + s_5 * (Scalar(0.01758242695) * t14 * t16 - t12 * t9);
  const Scalar mu_5_3_x = Scalar(0.0016462500968175) * t27 + s_4 * t34;
  const Scalar t48 = c_4 * t34 - Scalar(0.0016462500968175) * s_5 *
      (s_4 - Scalar(4.189343395921486));
  const Scalar mu_5_2_y = Scalar(0.00747253145375) * s_5 + c_3 * t48 - s_3 * mu_5_3_x;
  const Scalar db_15_2 = c_2 * (c_3 * mu_5_3_x + s_3 * t48) + s_2 * mu_5_2_y;
  c[11] = db_15_2 + t47;
  const Scalar c_2_1_5 = db_15_2 - t47;
  c[85] = c_2_1_5;
  c[66] = -c_3_7;
  const Scalar t49 = t46 + s_5 * (Scalar(0.0068967069711375) * t14 * t5 - t12 * dmu_3_5_y);
  const Scalar t50 = w_1_3_x * t48 + t11 * mu_5_3_x;
  c[12] = t50 + t49;
  const Scalar c_3_1_5 = t50 - t49;
  c[87] = c_3_1_5;
  c[73] = -c_4_1_5;
  c[6] = -db_11_4r;
  const Scalar Iu_3_t_yz = t45 + s_3 * t28;
  const Scalar t51 = s_2 * Iu_3_t_yz;
  const Scalar t52 = c_3 * t28 - t44;
  const Scalar db_13_2 = t51 - c_2 * t52;
  c[4] = t30 - db_13_2;
  const Scalar c_2_1_3 = t30 + db_13_2;
  c[24] = c_2_1_3;
  c[64] = -c_2_7;
  c[31] = -c_2_1_5;
  c[52] = -c_3_1_5;
  c[2] = Scalar(2.0) * (c_2 * (t52 + t24 + Scalar(0.1746501428125)) - t51);
  const Scalar t53 = c_5 * (Scalar(0.000017926614) * t14 - t12 * t3);
  const Scalar t54 = t12 * (t53 - s_5 * (t12 * t31 - t36));
  const Scalar db_11_5r = t14 * (t42 + t43) + t54;
  c[10] = db_11_5r;
  c[43] = -c_2_1_3;
  const Scalar Iu_4_t_g = Scalar(0.00658500038727) * t1 + Scalar(2.0) * c_4 * Iu_4_t_d;
  const Scalar t55 = Iu_5_t_xx - Scalar(0.7845) * hu_4_t_x - c_4 * Iu_4_t_g +
      Scalar(0.2900169589877);
  const Scalar t56 = hu_4_t_y + dI_4_xx - s_4 * Iu_4_t_g;
  const Scalar dmu_1_3_x = hc_3_x * t38 - t55 * t11 + t56 * w_1_3_x;
  const Scalar t57 = t11 * (c_2 * t21 + t55 * w_1_3_x + t56 * t11);
  const Scalar t58 = t38 * (Scalar(1.2746972594008923) * hu_4_t_y * t11 - hc_3_x * w_1_3_x);
  const Scalar db_11_3r = t58 - w_1_3_x * dmu_1_3_x + t57;
  c[42] = db_11_3r;
  c[84] = -db_11_5r;
  c[3] = -db_11_3r;
  const Scalar t59 = Scalar(-2.0) * (c_3 * t55 - s_3 * t56);
  const Scalar t60 = t55 + c_3 * t59 + c_3 * t18 + s_3 * t19 - Scalar(0.696467139575);
  const Scalar t61 = t56 + db_22_3r - s_3 * t59;
  const Scalar t62 = s_2 * (c_2 * t60 + s_2 * t61);
  const Scalar db_11_2r = t62 - c_2 * (c_2 * t61 - s_2 * t60);
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
template <class Scalar>
inline void coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar t1 = c_5 * s_5;
  const Scalar t2 = Scalar(0.0015110828546699) * t1;
  const Scalar C_44 = qd_5 * t2;
  C[21] = C_44;
  const Scalar t3 = Scalar(0.01758242695) * s_5;
  const Scalar hu_4_t_y = Scalar(0.0754436725) * c_4 + s_4 * t3;
  const Scalar t4 = Scalar(0.7845) * hu_4_t_y;
  const Scalar t5 = Scalar(0.00075554142733495) * s_5;
  const Scalar dmu_3_5_y = Scalar(0.0068967069711375) * c_4 + t5;
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
  C[32] = C[33] = -t13 - t12;
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
  C[31] = -t13 - t17;
  const Scalar t23 = s_5 * t10;
  C[5] = C[30] = Scalar(-0.00006605859375) * (qd_5 * t19 + t23 * t21) - qd_2 * t16;
  const Scalar hu_4_t_x = Scalar(0.0754436725) * s_4 - c_4 * t3;
  const Scalar hc_3_x = hu_4_t_x - Scalar(0.7972258875);
  const Scalar t24 = c_3 * hu_4_t_y;
  const Scalar t25 = t24 - s_3 * hc_3_x;
  const Scalar t26 = Scalar(-0.85) * t25;
  const Scalar t27 = qd_3 * t26;
  const Scalar t28 = Scalar(0.425) * s_3;
  const Scalar v_o_2_4_y = Scalar(0.425) * c_3 + Scalar(0.39225);
  const Scalar v_2_4_x = c_4 * t28 + s_4 * v_o_2_4_y;
  const Scalar t29 = c_4 * v_o_2_4_y - s_4 * t28;
  const Scalar t30 = Scalar(0.0754436725) * t29 + t3 * v_2_4_x;
  const Scalar t31 = Scalar(0.01758242695) * t29 + t5;
  const Scalar t32 = Scalar(-2.0) * (qd_4 * t30 - c_5 * qd_5 * t31);
  C[7] = t27 + t32;
  C[29] = -C_65;
  const Scalar t33 = Scalar(-0.0016462500968175) * t23;
  const Scalar t34 = Scalar(0.0019191219015925) * c_5 + Scalar(0.00191870002108495);
  const Scalar t35 = t18 * t34 - t33;
  const Scalar t36 = Scalar(0.0019191219015925) * t19 + t33 +
      Scalar(0.0015110828546699) * t18 * (c_5 * c_5 - Scalar(0.5));
  const Scalar t37 = t35 - t36;
  const Scalar t38 = qd_6 * t11;
  const Scalar C_54 = t38 + qd_1 * t37 - t2 * t22;
  C[27] = C_54;
  const Scalar t39 = Scalar(0.425) * c_2;
  const Scalar t40 = Scalar(0.39225) * t9 + t39;
  const Scalar t41 = Scalar(0.00075554142733495) * c_5;
  const Scalar Iu_5_t_xx = c_5 * t41 - Scalar(0.00075554142733495);
  const Scalar Iu_4_t_d = Iu_5_t_xx + Scalar(0.006077390365825);
  const Scalar t42 = Scalar(0.003292500193635) * s_5;
  const Scalar t43 = t18 * (t3 * t40 - Iu_4_t_d * t10 - t42 * t18);
  const Scalar t44 = t10 * (Scalar(0.0754436725) * t40 + Scalar(0.003292500193635) * t23 -
      Iu_4_t_d * t18);
  const Scalar t45 = t40 * (Scalar(0.0754436725) * t10 + t3 * t18) + t43 + t44;
  const Scalar t46 = t10 * t38;
  const Scalar t47 = t46 + qd_1 * t45;
  const Scalar t48 = Scalar(0.00075554142733495) * t1;
  const Scalar Ic_4_yz = Scalar(0.0016462500968175) * c_5 - Scalar(0.000017926614);
  const Scalar Ic_3_yz = Scalar(0.10915) * hu_4_t_y + c_4 * Ic_4_yz + s_4 * t48;
  const Scalar t49 = s_3 * Ic_3_yz;
  const Scalar mu_4_3_x = Scalar(0.10915) * hu_4_t_x - c_4 * t48 + s_4 * Ic_4_yz;
  const Scalar mu_u_4_3_t_x = t49 + c_3 * mu_4_3_x;
  const Scalar t50 = c_3 * Ic_3_yz;
  const Scalar mu_u_4_3_t_y = t50 - s_3 * mu_4_3_x;
  const Scalar db_14_2 = c_2 * mu_u_4_3_t_x + s_2 * mu_u_4_3_t_y;
  const Scalar t51 = t41 + Scalar(0.0019191219015925);
  const Scalar t52 = t23 * t51 - t18 * (Ic_4_yz + Scalar(0.008234676853375));
  const Scalar t53 = t52 + db_14_2;
  const Scalar t54 = Ic_3_yz * w_1_3_x;
  const Scalar db_14_3 = t54 + mu_4_3_x * t9;
  const Scalar t55 = t52 + db_14_3;
  C[18] = t47 - qd_2 * t53 - qd_3 * t55 - qd_5 * t37;
  const Scalar t56 = t52 - db_14_2;
  const Scalar t57 = t52 - db_14_3;
  const Scalar t58 = t35 + t36;
  const Scalar t59 = t47 - qd_2 * t56 - qd_3 * t57 - Scalar(2.0) * qd_4 * t52 - qd_5 * t58;
  C[3] = -t59;
  const Scalar t60 = Scalar(2.0) * qd_2;
  const Scalar t61 = qd_1 * t53 - t30 * t60;
  const Scalar t62 = Scalar(0.39225) * hu_4_t_y;
  const Scalar t63 = t62 + t30;
  const Scalar db_24_3 = Scalar(0.425) * t24 - hu_4_t_x * t28;
  const Scalar c_2_3_4 = db_24_3 + t63;
  C[9] = t32 + t61 - qd_3 * c_2_3_4;
  const Scalar c_3_2_4 = db_24_3 - t63;
  const Scalar t64 = qd_1 * t55 + qd_2 * c_3_2_4 - qd_3 * t4;
  C[15] = t64 - t8;
  C[20] = C_44 - t64;
  C[22] = qd_5 * t42 - C_54;
  const Scalar t65 = Scalar(0.0068967069711375) * c_5 - mu_4_3_x + Scalar(0.063261281833125);
  const Scalar Iu_3_t_yz = t50 + s_3 * t65;
  const Scalar t66 = s_2 * Iu_3_t_yz;
  const Scalar t67 = c_3 * t65 - t49;
  const Scalar db_13_2 = t66 - c_2 * t67;
  const Scalar t68 = t65 * t9 - t54;
  const Scalar t69 = t68 + db_13_2;
  const Scalar t70 = qd_1 * t69 + qd_2 * t26;
  const Scalar t71 = c_5 * (t31 + dmu_3_5_y);
  const Scalar t72 = Scalar(0.00747253145375) * c_5;
  const Scalar t73 = t72 * t14;
  const Scalar t74 = t73 + t71;
  C[8] = t27 + t70 - qd_4 * c_2_3_4 + qd_5 * t74;
  C[19] = C_44 - t61 - qd_3 * c_3_2_4;
  const Scalar t75 = Scalar(-0.01758242695) * t10;
  const Scalar t76 = v_2_4_x - Scalar(0.09363042437196077);
  const Scalar t77 = t51 * t19;
  const Scalar t78 = t77 - s_5 * (t76 * t75 + t18 * t31);
  const Scalar t79 = Scalar(0.0016462500968175) * s_5;
  const Scalar mu_5_3_x = s_4 * t34 + c_4 * t79;
  const Scalar mu_5_3_y = Scalar(0.0068967069711375) * s_5 + c_4 * t34 - s_4 * t79;
  const Scalar mu_u_5_3_t_x = c_3 * mu_5_3_x + s_3 * mu_5_3_y;
  const Scalar mu_5_2_y = Scalar(0.00747253145375) * s_5 + c_3 * mu_5_3_y - s_3 * mu_5_3_x;
  const Scalar db_15_2 = c_2 * mu_u_5_3_t_x + s_2 * mu_5_2_y;
  const Scalar c_2_1_5 = db_15_2 - t78;
  const Scalar t80 = t31 * t6;
  const Scalar t81 = t38 + qd_1 * c_2_1_5 - qd_2 * t80;
  const Scalar t82 = t73 - t71;
  const Scalar t83 = qd_4 * t2;
  C[25] = t81 - t83 + qd_3 * t82;
  const Scalar t84 = Scalar(0.39225) * s_4 - Scalar(0.09363042437196077);
  const Scalar t85 = t77 - s_5 * (t84 * t75 + t18 * dmu_3_5_y);
  const Scalar t86 = w_1_3_x * mu_5_3_y + t9 * mu_5_3_x;
  const Scalar t87 = t86 - t85;
  const Scalar t88 = t38 + qd_2 * t82 - qd_3 * t7 + qd_1 * t87;
  C[26] = t88 - t83;
  const Scalar t89 = qd_5 * Scalar(0.0351648539) * s_5;
  C[10] = qd_3 * t74 - t81 + qd_4 * t80 - t76 * t89;
  C[13] = qd_4 * c_3_2_4 - t70 - qd_5 * t82;
  C[16] = qd_4 * t7 - t88 - t84 * t89;
  const Scalar t90 = Scalar(0.01758242695) *
      (c_5 * (t40 - Scalar(0.09465) * t18) - Scalar(0.10915) * t23);
  const Scalar t91 = Scalar(0.000017926614) * t19 + t90;
  const Scalar t92 = c_5 * (Scalar(0.000017926614) * t10 - t18 * t5);
  const Scalar t93 = t18 * (t92 - s_5 * t18 * (t51 + Scalar(0.0019191219015925)));
  const Scalar t94 = t10 * (t90 + t91) + t93;
  const Scalar t95 = qd_1 * t94 + qd_6 * t20;
  const Scalar c_1_2_5 = db_15_2 + t78;
  const Scalar t96 = t86 + t85;
  C[4] = t95 + qd_2 * c_1_2_5 + qd_3 * t96 + qd_4 * t58 - Scalar(2.0) * qd_5 * t91;
  const Scalar Iu_4_t_g = c_4 * Iu_4_t_d + s_4 * t42;
  const Scalar t97 = s_4 * Iu_4_t_g - t62 - t79;
  const Scalar t98 = Scalar(-2.0) * t97;
  const Scalar t99 = Iu_5_t_xx - Scalar(0.7845) * hu_4_t_x - Scalar(2.0) * c_4 * Iu_4_t_g +
      Scalar(0.2900169589877);
  const Scalar dmu_1_3_x = hc_3_x * t39 - t99 * t9 + t98 * w_1_3_x;
  const Scalar t100 = t9 * (hu_4_t_y * t39 + t99 * w_1_3_x + t98 * t9);
  const Scalar db_11_3r = t39 * (hu_4_t_y * t9 - hc_3_x * w_1_3_x) - w_1_3_x * dmu_1_3_x + t100;
  const Scalar t101 = qd_1 * db_11_3r + t46;
  C[12] = t101 - qd_2 * t69 + qd_4 * t55 - qd_5 * t87;
  C[24] = qd_2 * c_2_1_5 - t95 + qd_3 * t87 + qd_4 * t37;
  const Scalar t102 = t68 - db_13_2;
  const Scalar t103 = t101 - qd_2 * t102 - Scalar(2.0) * qd_3 * t68 - qd_4 * t57 - qd_5 * t96;
  C[2] = -t103;
  const Scalar t104 = c_3 * t99 - s_3 * t98;
  const Scalar t105 = Scalar(-2.0) * (t97 - Scalar(0.425) * t25 - s_3 * t104);
  const Scalar hu_3_t_x = c_3 * hc_3_x + s_3 * hu_4_t_y;
  const Scalar t106 = Scalar(0.85) * hu_3_t_x + t99 - Scalar(2.0) * c_3 * t104 -
      Scalar(0.696467139575);
  const Scalar t107 = s_2 * (c_2 * t106 + s_2 * t105);
  const Scalar t108 = t107 - c_2 * (c_2 * t105 - s_2 * t106);
  C[0] = qd_2 * t108 - qd_3 * db_11_3r - qd_4 * t45 + qd_5 * t94;
  const Scalar t109 = qd_1 * t108 - t15 * t38;
  const Scalar t110 = (c_2 * (t67 + t72 + Scalar(0.1746501428125)) - t66) * t60;
  C[1] = t109 + t110 + qd_3 * t102 + qd_4 * t56 + qd_5 * c_1_2_5;
  C[6] = qd_3 * t69 - t109 + qd_4 * t53 - qd_5 * c_2_1_5;
  C[28] = C[35] = Scalar(0.0);
}

// gravity torques g(q) (7.39).
//   q[6]  in   joint positions, rad or m
//   g[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..4]. Operations: 26 mul, 12 add, 8 sin/cos. Always zero: g[5].
template <class Scalar>
inline void gravity(const Scalar* q, Scalar* g) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar ddp_3_x = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = Scalar(0.344967216759) * c_4;
  const Scalar t2 = c_2 * c_3 - s_2 * s_3;
  const Scalar t3 = Scalar(0.344967216759) * s_4;
  const Scalar t4 = ddp_3_x * t1 + t2 * t3;
  const Scalar t5 = c_5 * t4;
  g[4] = -t5;
  const Scalar t6 = t2 * t1 - ddp_3_x * t3;
  const Scalar mu_4_z = Scalar(4.290856587349563) * t4 - s_5 * t6;
  g[3] = mu_4_z;
  const Scalar t7 = Scalar(15.64157191275) * t2 - mu_4_z;
  g[2] = -t7;
  g[1] = Scalar(-38.1586437) * c_2 - t7;
  const Scalar t8 = c_5 * t6;
  const Scalar mu_u_4_t_y = c_4 * t5 - s_4 * t8;
  const Scalar t9 = c_4 * t8 + s_4 * t5;
  const Scalar mu_u_3_t_y = c_3 * mu_u_4_t_y - s_3 * t9;
  const Scalar mu_u_3_t_x = c_3 * t9 + s_3 * mu_u_4_t_y;
  g[0] = c_2 * mu_u_3_t_y - s_2 * mu_u_3_t_x;
  g[5] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   n[6]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5], qd[0..5]. Operations: 155 mul, 98 add, 10 sin/cos.
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
  const Scalar domega_5_y = qd_5 * omega_r_5_x - s_5 * t7;
  n[5] = Scalar(-0.0001321171875) * domega_5_y;
  const Scalar t8 = qd_1 * qd_1;
  const Scalar t9 = c_2 * t8;
  const Scalar U_2_xx = qd_2 * qd_2 + c_2 * t9;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 + Scalar(0.425) * U_2_xx;
  const Scalar t10 = s_2 * t9;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.425) * t10;
  const Scalar t11 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t12 = t8 * t1;
  const Scalar t13 = t2 * t12;
  const Scalar t14 = t11 - Scalar(0.39225) * t13;
  const Scalar t15 = t1 * t12;
  const Scalar U_3_xx = omega_3_z * omega_3_z + t15;
  const Scalar ddp_o_4_x = Scalar(0.39225) * U_3_xx + s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar t16 = s_4 * t14 - c_4 * ddp_o_4_x;
  const Scalar t17 = t8 * t3;
  const Scalar t18 = t5 * t17;
  const Scalar U_3_zz = t15 + t8 * t2 * t2;
  const Scalar t19 = qd_1 * omega_3_z;
  const Scalar t20 = t2 * t19;
  const Scalar t21 = qd_1 * qd_2;
  const Scalar t22 = s_2 * t21;
  const Scalar ddp_o_4_z = Scalar(0.10915) * U_3_zz + Scalar(0.7845) * t20 + Scalar(0.85) * t22;
  const Scalar ddp_o_5_z = ddp_o_4_z - Scalar(0.1893) * t7;
  const Scalar t23 = s_5 * ddp_o_5_z + c_5 * (t16 + Scalar(0.09465) * t18);
  const Scalar omega_5_z = qd_5 + qd_1 * t5;
  const Scalar omega_r_6_y = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t24 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar omega_r_5_y = s_5 * t4 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t25 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar t26 = t25 * (s_6 * omega_r_6_y - c_6 * t24);
  const Scalar t27 = omega_r_5_x * omega_5_z;
  const Scalar U_5_xz = domega_5_y - t27;
  const Scalar t28 = omega_r_5_x * omega_r_5_y;
  const Scalar t29 = t3 * t6;
  const Scalar mu_5_z = Scalar(0.0351648539) * t23 - Scalar(0.0038374000421699) * t29 -
      Scalar(0.0016432000421699) * t28 - Scalar(0.000035853228) * U_5_xz + t26;
  n[4] = mu_5_z;
  const Scalar t30 = (s_6 * t24 + c_6 * omega_r_6_y) * t25;
  const Scalar t31 = omega_4_z * omega_4_z;
  const Scalar U_4_yy = t31 + t3 * t17;
  const Scalar ddp_o_5_y = Scalar(0.09465) * U_4_yy - s_4 * ddp_o_4_x - c_4 * t14;
  const Scalar domega_5_x = qd_5 * omega_r_5_y - c_5 * t7;
  const Scalar t32 = omega_5_z * omega_5_z;
  const Scalar t33 = omega_r_5_y * omega_5_z;
  const Scalar mu_5_x = Scalar(0.0351648539) * ddp_o_5_y - Scalar(0.0016432000421699) * domega_5_x -
      Scalar(0.0038374000421699) * t33 +
      Scalar(0.000035853228) * (t32 - omega_r_5_y * omega_r_5_y) + t30;
  const Scalar t34 = t29 + t28;
  const Scalar t35 = Scalar(0.000035853228) * t34 + Scalar(0.0021942) * t27 +
      Scalar(0.0001321171875) * domega_5_y;
  const Scalar U_5_yy = t32 + omega_r_5_x * omega_r_5_x;
  const Scalar t36 = s_5 * U_5_yy + c_5 * t34;
  const Scalar t37 = Scalar(0.150887345) * t16 + Scalar(0.01434898073165) * t18 -
      Scalar(0.003328353421635) * t36 + s_5 * mu_5_x + c_5 * t35;
  n[3] = -t37;
  const Scalar f_4_x = Scalar(0.150887345) * t18 - Scalar(0.0351648539) * t36;
  const Scalar U_5_zy = domega_5_x + t33;
  const Scalar f_4_y = Scalar(0.150887345) * U_4_yy - Scalar(0.0351648539) * U_5_zy;
  const Scalar t38 = s_4 * f_4_x - c_4 * f_4_y;
  const Scalar n_3 = Scalar(1.594451775) * t11 - Scalar(0.56787913724375) * t13 - t37 +
      Scalar(0.39225) * t38;
  n[2] = n_3;
  const Scalar f_u_4_t_x = s_4 * f_4_y + c_4 * f_4_x;
  const Scalar f_3_x = Scalar(1.594451775) * U_3_xx - f_u_4_t_x;
  const Scalar t39 = s_3 * f_3_x + c_3 * (Scalar(1.594451775) * t13 - t38);
  n[1] = Scalar(1.39293427915) * t10 - Scalar(38.1586437) * c_2 + n_3 - Scalar(0.425) * t39;
  const Scalar t40 = s_5 * t34 - c_5 * U_5_yy;
  const Scalar t41 = t31 - t8 * t5 * t5;
  const Scalar mu_4_x = Scalar(0.150887345) * ddp_o_4_z - Scalar(0.0308921614633) * t7 +
      Scalar(0.000035853228) * t41 - Scalar(0.003328353421635) * t40 + s_5 * t35 - c_5 * mu_5_x;
  const Scalar t42 = Scalar(0.000035853228) * t18 + Scalar(0.0021942) * t29 - mu_5_z;
  const Scalar t43 = t7 + Scalar(0.11652684955123307) * t40;
  const Scalar U_3_zz_xx = U_3_xx - U_3_zz;
  const Scalar mu_3_y = Scalar(1.1398532744875) * t20 + Scalar(1.35528400875) * t22 -
      Scalar(0.12652256366625) * U_3_zz_xx - Scalar(0.1183711221525) * t43 +
      Scalar(0.10915) * f_u_4_t_x - s_4 * mu_4_x - c_4 * t42;
  const Scalar t44 = Scalar(0.12652256366625) * t13 - Scalar(0.10915) * t38 + s_4 * t42 -
      c_4 * mu_4_x + Scalar(0.004095) * t1 * t19;
  const Scalar mu_2_x = Scalar(0.349300285625) * t10 + Scalar(0.0151074) * c_2 * t21 +
      s_3 * mu_3_y - c_3 * t44;
  const Scalar mu_2_y = Scalar(1.35528400875) * t20 + Scalar(2.8009759583) * t22 +
      Scalar(0.349300285625) * (t8 - U_2_xx) - Scalar(0.12825424325) * t43 + s_3 * t44 +
      c_3 * mu_3_y;
  n[0] = s_2 * mu_2_x - c_2 * mu_2_y;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   tau[6]  in   joint torques or forces, N m or N
//   qdd[6]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns true, or false if the result means nothing: a pivot was not positive, or an input not a
// number.
// Reads q[1..5], qd[0..5], tau[0..5]. Operations: 303 mul, 219 add, 4 div, 10 sin/cos.
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
  const Scalar omega_r_6_y = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar omega_r_5_y = s_5 * t4 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t7 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar t8 = (s_6 * t6 + c_6 * omega_r_6_y) * t7;
  const Scalar t9 = qd_1 * qd_1;
  const Scalar t10 = c_2 * t9;
  const Scalar U_2_xx = qd_2 * qd_2 + c_2 * t10;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 + Scalar(0.425) * U_2_xx;
  const Scalar t11 = s_2 * t10;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.425) * t11;
  const Scalar t12 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t13 = t9 * t1;
  const Scalar t14 = t2 * t13;
  const Scalar t15 = t12 - Scalar(0.39225) * t14;
  const Scalar t16 = t9 * t3;
  const Scalar t17 = omega_4_z * omega_4_z;
  const Scalar U_4_yy = t17 + t3 * t16;
  const Scalar U_3_xx = omega_3_z * omega_3_z + t1 * t13;
  const Scalar ddp_o_4_x = Scalar(0.39225) * U_3_xx + s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar ddp_o_5_y = Scalar(0.09465) * U_4_yy - s_4 * ddp_o_4_x - c_4 * t15;
  const Scalar t18 = omega_5_z * omega_5_z;
  const Scalar mu_5_x = Scalar(0.0351648539) * ddp_o_5_y +
      Scalar(0.000035853228) * (t18 - omega_r_5_y * omega_r_5_y) + t8 -
      Scalar(0.0054806000843398) * omega_r_5_y * omega_5_z;
  const Scalar t19 = qd_1 * omega_4_z;
  const Scalar t20 = t5 * t19;
  const Scalar domega_5_y = qd_5 * omega_r_5_x - s_5 * t20;
  const Scalar t21 = omega_r_5_x * omega_r_5_y;
  const Scalar t22 = t3 * t19;
  const Scalar t23 = t22 + t21;
  const Scalar t24 = omega_r_5_x * omega_5_z;
  const Scalar t25 = Scalar(0.0015110828546699) * domega_5_y - Scalar(0.000035853228) * t23 -
      Scalar(0.0038374000421699) * t24;
  const Scalar y_6 = tau_6 + Scalar(0.0001321171875) * domega_5_y;
  const Scalar U_5_yy = t18 + omega_r_5_x * omega_r_5_x;
  const Scalar t26 = s_5 * U_5_yy + c_5 * t23;
  const Scalar t27 = s_4 * t15 - c_4 * ddp_o_4_x;
  const Scalar t28 = t5 * t16;
  const Scalar t29 = Scalar(0.150887345) * t27 + Scalar(0.0159921807738199) * t28 -
      Scalar(0.003328353421635) * t26 - c_5 * (t25 + y_6) + s_5 * mu_5_x;
  const Scalar t30 = t9 * (t2 * t2 + t1 * t1);
  const Scalar t31 = qd_1 * omega_3_z;
  const Scalar t32 = t2 * t31;
  const Scalar t33 = qd_1 * qd_2;
  const Scalar t34 = s_2 * t33;
  const Scalar ddp_o_4_z = Scalar(0.10915) * t30 + Scalar(0.7845) * t32 + Scalar(0.85) * t34;
  const Scalar ddp_o_5_z = ddp_o_4_z - Scalar(0.1893) * t20;
  const Scalar t35 = s_5 * ddp_o_5_z + c_5 * (t27 + Scalar(0.09465) * t28);
  const Scalar t36 = t7 * (s_6 * omega_r_6_y - c_6 * t6);
  const Scalar U_5_xz = domega_5_y - t24;
  const Scalar t37 = Scalar(0.0351648539) * t35 - Scalar(0.0038374000421699) * t22 -
      Scalar(0.0016432000421699) * t21 - Scalar(0.000035853228) * U_5_xz + t36;
  const Scalar y_5 = tau_5 - t37;
  const Scalar t38 = Scalar(0.8580028554367816) * c_5;
  const Scalar y_5_4 = tau_4 + t29 + y_5 * t38;
  const Scalar t39 = c_5 * c_5;
  const Scalar t40 = Scalar(0.0015110828546699) * t39;
  const Scalar Ic_4_zz = t40 - Scalar(0.0181863807738199);
  const Scalar t41 = c_4 * s_5;
  const Scalar hu_4_t_x = Scalar(0.150887345) * s_4 - Scalar(0.0351648539) * t41;
  const Scalar t42 = Scalar(0.0001321171875) * t39 + Ic_4_zz + Scalar(0.39225) * hu_4_t_x;
  const Scalar t43 = s_4 - Scalar(0.23870089068696182);
  const Scalar t44 = t39 * t43;
  const Scalar b_5_4_3 = t42 - Scalar(0.011834788548693463) * t44;
  const Scalar b_5_4_4 = Scalar(0.002957091755164986) * t39 + Ic_4_zz;
  const Scalar d_4 = Scalar(1.0) / b_5_4_4;
  const Scalar t45 = b_5_4_3 * d_4;
  const Scalar f_4_x = Scalar(0.150887345) * t28 - Scalar(0.0351648539) * t26;
  const Scalar U_5_zy = omega_r_5_y * (qd_5 + omega_5_z) - c_5 * t20;
  const Scalar f_4_y = Scalar(0.150887345) * U_4_yy - Scalar(0.0351648539) * U_5_zy;
  const Scalar t46 = s_4 * f_4_x - c_4 * f_4_y;
  const Scalar t47 = Scalar(1.594451775) * t12 - Scalar(0.56787913724375) * t14 +
      Scalar(0.39225) * t46 - t29;
  const Scalar t48 = Scalar(3.594468596105858) * c_5 * t43;
  const Scalar y_4_3 = tau_3 - t47 - t45 * y_5_4 - y_5 * t48;
  const Scalar t49 = Scalar(0.7845) * hu_4_t_x;
  const Scalar t50 = Scalar(0.0016432000421699) * t39 + t49 - Scalar(0.5901605180175699);
  const Scalar b_4_3_3 = t50 - b_5_4_3 * t45 + Scalar(0.04957999324859619) * t43 * t44;
  const Scalar d_3 = Scalar(1.0) / b_4_3_3;
  const Scalar t51 = s_4 * s_5;
  const Scalar hu_4_t_y = Scalar(0.150887345) * c_4 + Scalar(0.0351648539) * t51;
  const Scalar t52 = s_3 * hu_4_t_y;
  const Scalar f_u_4_3_t_y = t52 + c_3 * hu_4_t_x;
  const Scalar t53 = s_3 * c_4 + c_3 * s_4;
  const Scalar t54 = Scalar(0.9229411764705883) * t43;
  const Scalar t55 = t53 + t54;
  const Scalar t56 = t39 * t55;
  const Scalar b_5_4_2 = Scalar(0.425) * f_u_4_3_t_y + t42 - Scalar(0.012822906649317328) * t56;
  const Scalar hc_3_x = hu_4_t_x - Scalar(1.594451775);
  const Scalar hu_3_t_x = t52 + c_3 * hc_3_x;
  const Scalar b_4_3_2 = Scalar(0.425) * hu_3_t_x + t50 - b_5_4_2 * t45 +
      Scalar(0.053719559287835256) * t55 * t44;
  const Scalar t57 = b_4_3_2 * d_3;
  const Scalar f_u_4_t_x = s_4 * f_4_y + c_4 * f_4_x;
  const Scalar f_3_x = Scalar(1.594451775) * U_3_xx - f_u_4_t_x;
  const Scalar t58 = s_3 * f_3_x + c_3 * (Scalar(1.594451775) * t14 - t46);
  const Scalar t59 = b_5_4_2 * d_4;
  const Scalar t60 = Scalar(3.8945803781899033) * c_5 * t55;
  const Scalar y_3_2 = Scalar(38.1586437) * c_2 + tau_2 - Scalar(1.39293427915) * t11 +
      Scalar(0.425) * t58 - t47 - t57 * y_4_3 - t59 * y_5_4 - y_5 * t60;
  const Scalar t61 = Scalar(0.003292500193635) * s_5;
  const Scalar t62 = Scalar(0.003838243803185) * c_5 + Scalar(0.0038374000421699);
  const Scalar t63 = t61 * (s_4 - Scalar(4.189343395921486)) - c_4 * t62;
  const Scalar mu_5_3_x = Scalar(0.003292500193635) * t41 + s_4 * t62;
  const Scalar mu_5_2_y = Scalar(0.0149450629075) * s_5 - s_3 * mu_5_3_x - c_3 * t63;
  const Scalar t64 = s_2 * (s_3 * t63 - c_3 * mu_5_3_x) + c_2 * mu_5_2_y;
  const Scalar t65 = s_5 * (s_2 * (s_3 * s_4 - c_3 * c_4) - c_2 * t53);
  const Scalar t66 = Scalar(-0.0001321171875) * t65;
  const Scalar t67 = c_5 * t66;
  const Scalar t68 = Scalar(0.0015110828546699) * c_5;
  const Scalar Ic_4_yz = Scalar(0.003292500193635) * c_5 - Scalar(0.000035853228);
  const Scalar Ic_3_yz = Scalar(0.10915) * hu_4_t_y + t51 * t68 + c_4 * Ic_4_yz;
  const Scalar t69 = s_3 * Ic_3_yz;
  const Scalar mu_4_3_x = Scalar(0.10915) * hu_4_t_x + s_4 * Ic_4_yz - t41 * t68;
  const Scalar mu_u_4_3_t_x = t69 + c_3 * mu_4_3_x;
  const Scalar t70 = c_3 * Ic_3_yz;
  const Scalar mu_u_4_3_t_y = t70 - s_3 * mu_4_3_x;
  const Scalar t71 = t64 * t38 - t67 + s_2 * mu_u_4_3_t_x - c_2 * mu_u_4_3_t_y;
  const Scalar t72 = Scalar(0.013793413942275) * c_5 - mu_4_3_x + Scalar(0.12652256366625);
  const Scalar Iu_3_t_yz = s_3 * t72 + t70;
  const Scalar t73 = t67 + c_2 * Iu_3_t_yz;
  const Scalar t74 = t69 - c_3 * t72;
  const Scalar t75 = t73 + t71 * t45 + t64 * t48 - s_2 * t74;
  const Scalar t76 = Scalar(0.0149450629075) * c_5;
  const Scalar t77 = s_2 * (t74 - t76 - Scalar(0.349300285625));
  const Scalar t78 = t73 - t75 * t57 + t71 * t59 + t64 * t60 - t77;
  const Scalar t79 = Scalar(0.85) * hu_3_t_x;
  const Scalar b_3_2_2 = t79 + t50 - b_4_3_2 * t57 - b_5_4_2 * t59 +
      Scalar(0.058204748750363244) * t55 * t56 - Scalar(1.40804167915);
  const Scalar d_2 = Scalar(1.0) / b_3_2_2;
  const Scalar t80 = t78 * d_2;
  const Scalar t81 = s_5 * t23 - c_5 * U_5_yy;
  const Scalar t82 = t17 - t9 * t5 * t5;
  const Scalar mu_4_x = Scalar(0.150887345) * ddp_o_4_z - Scalar(0.0341785615476398) * t20 +
      Scalar(0.000035853228) * t82 - Scalar(0.003328353421635) * t81 - s_5 * t25 - c_5 * mu_5_x;
  const Scalar t83 = Scalar(0.000035853228) * t28 + Scalar(0.0021942) * t22 - t37;
  const Scalar t84 = t20 + Scalar(0.11652684955123307) * t81;
  const Scalar U_3_zz_xx = U_3_xx - t30;
  const Scalar mu_3_y = Scalar(1.1398532744875) * t32 + Scalar(1.35528400875) * t34 -
      Scalar(0.12652256366625) * U_3_zz_xx - Scalar(0.1183711221525) * t84 +
      Scalar(0.10915) * f_u_4_t_x - s_4 * mu_4_x - c_4 * t83;
  const Scalar t85 = Scalar(0.12652256366625) * t14 - Scalar(0.10915) * t46 + s_4 * t83 -
      c_4 * mu_4_x + Scalar(0.004095) * t1 * t31;
  const Scalar mu_2_x = Scalar(0.349300285625) * t11 + Scalar(0.0151074) * c_2 * t33 +
      s_3 * mu_3_y - c_3 * t85;
  const Scalar mu_2_y = Scalar(1.35528400875) * t32 + Scalar(2.8009759583) * t34 +
      Scalar(0.349300285625) * (t9 - U_2_xx) - Scalar(0.12825424325) * t84 + s_3 * t85 +
      c_3 * mu_3_y;
  const Scalar t86 = t75 * d_3;
  const Scalar t87 = t71 * d_4;
  const Scalar t88 = Scalar(260.5931070544678) * t64;
  const Scalar y_2_1 = tau_1 + t80 * y_3_2 + t86 * y_4_3 - t87 * y_5_4 + y_5 * t88 - y_6 * t65 -
      s_2 * mu_2_x + c_2 * mu_2_y;
  const Scalar Iu_5_t_xx = t40 - Scalar(0.0015110828546699);
  const Scalar Iu_4_t_d = Iu_5_t_xx + Scalar(0.01215478073165);
  const Scalar Iu_4_t_g = Scalar(0.00658500038727) * t51 + c_4 * Iu_4_t_d;
  const Scalar t89 = c_4 * Iu_4_t_g;
  const Scalar t90 = Scalar(0.00767648760637) * c_5;
  const Scalar Ic_3_xx = t89 + t90 - Scalar(0.01215478073165);
  const Scalar Ic_3_yy = Iu_5_t_xx - t89 + t90 - t49 + Scalar(0.56787913724375);
  const Scalar Iu_3_t_d = Ic_3_xx - Ic_3_yy;
  const Scalar Ic_3_xy = Scalar(0.39225) * hu_4_t_y - s_4 * Iu_4_t_g + t61;
  const Scalar Iu_3_t_g = Scalar(2.0) * s_3 * Ic_3_xy + c_3 * Iu_3_t_d;
  const Scalar t91 = c_3 * Iu_3_t_g;
  const Scalar Iu_3_t_xx = Ic_3_yy + t91;
  const Scalar t92 = c_2 * (Ic_3_xx - t91 - Iu_3_t_xx - t79 + Scalar(1.39293427915));
  const Scalar Ic_2_xy = Ic_3_xy - Scalar(0.425) * (s_3 * hc_3_x - c_3 * hu_4_t_y) - s_3 * Iu_3_t_g;
  const Scalar t93 = c_2 * (Scalar(2.0) * s_2 * Ic_2_xy - t92);
  const Scalar b_2_1_1 = Iu_3_t_xx + t78 * t80 + t75 * t86 + t71 * t87 - t64 * t88 + t65 * t66 -
      t93 + Scalar(0.1879281038293699);
  const Scalar d_1 = Scalar(1.0) / b_2_1_1;
  const Scalar qdd_1 = d_1 * y_2_1;
  qdd[0] = qdd_1;
  const Scalar t94 = d_2 * (y_3_2 - t78 * qdd_1);
  qdd[1] = -t94;
  const Scalar t95 = d_3 * (y_4_3 - t75 * qdd_1 - b_4_3_2 * t94);
  qdd[2] = -t95;
  const Scalar t96 = d_4 * (y_5_4 - b_5_4_3 * t95 + t71 * qdd_1 - b_5_4_2 * t94);
  qdd[3] = -t96;
  const Scalar t97 = y_5 + t76 * (t54 * t95 + t55 * t94) + t64 * qdd_1;
  qdd[4] = Scalar(260.5931070544678) * t97 - t38 * t96;
  qdd[5] = Scalar(7569.03790432263) * y_6 + c_5 * (t94 + t95 + t96) - t65 * qdd_1;
  bool positive = b_2_1_1 > Scalar(0.0);
  positive &= -b_3_2_2 > Scalar(0.0);
  positive &= -b_4_3_3 > Scalar(0.0);
  positive &= -b_5_4_4 > Scalar(0.0);
  return positive;
}

// kinetic energy of links and rotors (7.31).
//   q[6]   in  joint positions, rad or m
//   qd[6]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1..4], qd[0..5]. Operations: 67 mul, 42 add, 8 sin/cos.
template <class Scalar>
inline Scalar kinetic_energy(const Scalar* q, const Scalar* qd) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = s_2 * qd_1;
  const Scalar omega_r_3_x = s_3 * t1 + c_3 * t2;
  const Scalar t3 = c_3 * qd_2;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar v_o_4_y = Scalar(0.10915) * omega_r_3_x + Scalar(0.39225) * omega_3_z +
      Scalar(0.425) * t3;
  const Scalar t4 = s_3 * t2 - c_3 * t1;
  const Scalar t5 = Scalar(0.10915) * t4 + Scalar(0.425) * s_3 * qd_2;
  const Scalar t6 = s_4 * v_o_4_y + c_4 * t5;
  const Scalar omega_4_z = omega_3_z + qd_4;
  const Scalar t7 = s_4 * t4 - c_4 * omega_r_3_x;
  const Scalar v_o_4_z = Scalar(0.425) * t1 - Scalar(0.39225) * t4;
  const Scalar v_o_5_z = v_o_4_z + Scalar(0.09465) * t7;
  const Scalar v_r_5_x = s_5 * v_o_5_z - c_5 * (t6 - Scalar(0.09465) * omega_4_z);
  const Scalar omega_r_5_y = s_5 * t7 + c_5 * omega_4_z;
  const Scalar t8 = Scalar(0.000035853228) * omega_r_5_y;
  const Scalar t9 = s_4 * omega_r_3_x + c_4 * t4;
  const Scalar t10 = t9 + qd_5;
  const Scalar t11 = t10 * (Scalar(0.0703297078) * v_r_5_x - Scalar(0.0038374000421699) * t10 - t8);
  const Scalar omega_6_z = omega_r_5_y + qd_6;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t7;
  const Scalar t12 = omega_r_5_x *
      (Scalar(0.0703297078) * (s_4 * t5 - c_4 * v_o_4_y) -
      Scalar(0.0016432000421699) * omega_r_5_x);
  const Scalar t13 = Scalar(-0.000035853228) * t9;
  const Scalar L_4_z = Scalar(0.30177469) * t6 - Scalar(0.01654318073165) * omega_4_z + t13;
  const Scalar L_4_x = Scalar(0.30177469) * v_o_4_z + Scalar(0.01434898073165) * t7;
  const Scalar L_3_z = Scalar(0.12652256366625) * omega_r_3_x +
      Scalar(0.57197413724375) * omega_3_z + Scalar(1.35528400875) * t3;
  const Scalar L_3_x = Scalar(0.56787913724375) * omega_r_3_x -
      Scalar(0.12652256366625) * omega_3_z;
  const Scalar L_2_x = Scalar(0.349300285625) * qd_2 - Scalar(1.39293427915) * t2;
  const Scalar L_2_z = Scalar(1.40804167915) * qd_2 + Scalar(0.349300285625) * t2;
  const Scalar T_2 = Scalar(0.0001321171875) * omega_6_z * omega_6_z - t11 + t10 * t8 - t12 -
      omega_4_z * L_4_z - omega_4_z * t13 + t7 * L_4_x + omega_3_z * L_3_z -
      Scalar(1.35528400875) * t1 * t4 - omega_r_3_x * L_3_x + t2 * L_2_x + qd_2 * L_2_z +
      Scalar(2.1327493394493) * qd_1 * qd_1;
  return Scalar(0.5) * T_2;
}

// potential energy of links and rotors (7.36).
//   q[6]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[1..4]. Operations: 12 mul, 8 add, 7 sin/cos.
template <class Scalar>
inline Scalar potential_energy(const Scalar* q) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5);
  const Scalar t1 = Scalar(0.0351648539) * s_5;
  const Scalar hu_4_t_y = Scalar(0.150887345) * c_4 + s_4 * t1;
  const Scalar hc_3_x = Scalar(0.150887345) * s_4 - c_4 * t1 - Scalar(1.594451775);
  const Scalar hc_2_x = s_3 * hu_4_t_y + c_3 * hc_3_x - Scalar(3.88977);
  const Scalar t2 = s_2 * hc_2_x + c_2 * (s_3 * hc_3_x - c_3 * hu_4_t_y) + Scalar(1.4253058751);
  return Scalar(9.81) * t2;
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
// Reads q[0..5]. Operations: 66 mul, 34 add, 12 sin/cos.
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
  const Scalar t1 = s_4 * s_5;
  const Scalar t2 = c_4 * s_5;
  const Scalar t3 = s_3 * t1 - c_3 * t2;
  const Scalar a_3_t_y = s_3 * t2 + c_3 * t1;
  R[8] = s_2 * t3 - c_2 * a_3_t_y;
  const Scalar p_4u_t_y = Scalar(0.09465) * c_4 + Scalar(0.0823) * t1;
  const Scalar p_4_x = Scalar(0.09465) * s_4 - Scalar(0.0823) * t2 - Scalar(0.39225);
  const Scalar p_3_x = s_3 * p_4u_t_y + c_3 * p_4_x - Scalar(0.425);
  const Scalar t4 = s_3 * p_4_x - c_3 * p_4u_t_y;
  p[2] = s_2 * p_3_x + c_2 * t4 + Scalar(0.089159);
  const Scalar t5 = s_4 * s_6;
  const Scalar t6 = c_5 * t5 - c_4 * c_6;
  const Scalar t7 = c_4 * c_5;
  const Scalar t8 = s_4 * c_6;
  const Scalar s_4_t_x = t8 + s_6 * t7;
  const Scalar t9 = s_3 * t6 - c_3 * s_4_t_x;
  const Scalar t10 = s_3 * s_4_t_x + c_3 * t6;
  R[7] = s_2 * t9 - c_2 * t10;
  const Scalar t11 = s_2 * a_3_t_y + c_2 * t3;
  R[2] = s_1 * c_5 + c_1 * t11;
  R[5] = s_1 * t11 - c_1 * c_5;
  const Scalar n_4_t_y = c_5 * t8 + c_4 * s_6;
  const Scalar t12 = t5 - c_6 * t7;
  const Scalar t13 = s_3 * n_4_t_y + c_3 * t12;
  const Scalar t14 = s_3 * t12 - c_3 * n_4_t_y;
  R[6] = -s_2 * t13 - c_2 * t14;
  const Scalar t15 = s_2 * t4 - c_2 * p_3_x;
  const Scalar p_4_z = Scalar(0.0823) * c_5 + Scalar(0.10915);
  p[0] = s_1 * p_4_z - c_1 * t15;
  const Scalar n_2_t_x = s_2 * t14 - c_2 * t13;
  const Scalar t16 = s_1 * s_5;
  R[0] = c_6 * t16 + c_1 * n_2_t_x;
  const Scalar t17 = c_1 * s_5;
  R[3] = s_1 * n_2_t_x - c_6 * t17;
  const Scalar t18 = s_2 * t10 + c_2 * t9;
  R[4] = s_1 * t18 + s_6 * t17;
  p[1] = -s_1 * t15 - c_1 * p_4_z;
  R[1] = c_1 * t18 - s_6 * t16;
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[36] = {
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    0, 1, 1, 1, 1, 1,
    0, 1, 1, 1, 1, 1,
    0, 1, 1, 1, 1, 1,
    1, 0, 0, 0, 1, 1};

// geometric Jacobian of the tip (7.14), (7.15).
//   q[6]   in   joint positions, rad or m
//   J[36]  out  geometric Jacobian in base axes: linear rows, then angular
//               6 x 6, row by row: entry (i, j) is J[6 * i + j]
// Reads q[0..4]. Operations: 72 mul, 37 add, 10 sin/cos. Always zero: 6 of the 36 entries of J.
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
  J[19] = J[20] = J[21] = s_1;
  J[25] = J[26] = J[27] = -c_1;
  const Scalar R_32_x = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = s_2 * s_3 - c_2 * c_3;
  const Scalar J_65 = s_4 * R_32_x + c_4 * t1;
  J[34] = J_65;
  const Scalar t2 = c_4 * R_32_x - s_4 * t1;
  const Scalar R_40_y = c_1 * t2;
  J[22] = R_40_y;
  const Scalar R_41_y = s_1 * t2;
  J[28] = R_41_y;
  const Scalar t3 = s_5 * t2;
  J[35] = -t3;
  const Scalar t4 = s_5 * J_65;
  const Scalar R_50_y = c_1 * t4 + s_1 * c_5;
  J[23] = R_50_y;
  const Scalar J_56 = s_1 * t4 - c_1 * c_5;
  J[29] = J_56;
  const Scalar t5 = Scalar(0.0823) * s_5;
  const Scalar p_4_x = Scalar(0.09465) * s_4 - c_4 * t5 - Scalar(0.39225);
  const Scalar p_4u_t_y = Scalar(0.09465) * c_4 + s_4 * t5;
  const Scalar t6 = s_3 * p_4_x - c_3 * p_4u_t_y;
  const Scalar p_3_x = s_3 * p_4u_t_y + c_3 * p_4_x - Scalar(0.425);
  const Scalar t7 = s_2 * t6 - c_2 * p_3_x;
  const Scalar p_4_z = Scalar(0.0823) * c_5 + Scalar(0.10915);
  const Scalar p_1u_t_x = s_1 * p_4_z - c_1 * t7;
  J[6] = p_1u_t_x;
  const Scalar p_1u_t_y = s_1 * t7 + c_1 * p_4_z;
  J[0] = p_1u_t_y;
  const Scalar t8 = s_2 * p_3_x + c_2 * t6;
  J[1] = -c_1 * t8;
  J[7] = -s_1 * t8;
  const Scalar t9 = Scalar(0.425) * s_2 + t8;
  J[2] = -c_1 * t9;
  J[8] = -s_1 * t9;
  const Scalar t10 = t9 + Scalar(0.39225) * R_32_x;
  J[3] = -c_1 * t10;
  J[9] = -s_1 * t10;
  J[13] = c_1 * p_1u_t_x - s_1 * p_1u_t_y;
  const Scalar t11 = Scalar(0.425) * c_2;
  const Scalar r_3_y = p_1u_t_y - s_1 * t11;
  const Scalar r_3_x = p_1u_t_x + c_1 * t11;
  J[14] = c_1 * r_3_x - s_1 * r_3_y;
  const Scalar t12 = Scalar(-0.39225) * t1;
  const Scalar t13 = Scalar(0.10915) * c_1 - r_3_y + s_1 * t12;
  const Scalar t14 = Scalar(0.10915) * s_1 - r_3_x - c_1 * t12;
  J[15] = s_1 * t13 - c_1 * t14;
  const Scalar t15 = t13 - Scalar(0.09465) * R_41_y;
  const Scalar t16 = t10 - Scalar(0.09465) * J_65;
  J[5] = t16 * J_56 + t15 * t3;
  const Scalar t17 = t14 + Scalar(0.09465) * R_40_y;
  J[17] = t15 * R_50_y + t17 * J_56;
  J[4] = R_41_y * t16 - J_65 * t15;
  J[10] = -J_65 * t17 - R_40_y * t16;
  J[16] = t2 * (s_1 * t17 + c_1 * t15);
  J[11] = t17 * t3 - t16 * R_50_y;
  J[30] = Scalar(1.0);
  J[12] = J[18] = J[24] = J[31] = J[32] = J[33] = Scalar(0.0);
}

// (dJ/dt) qd of the tip.
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads q[0..5], qd[0..5]. Operations: 128 mul, 67 add, 12 sin/cos.
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
  const Scalar t13 = qd_6 * t10 - s_6 * domega_5_x + c_6 * t12;
  const Scalar omega_r_6_y = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t14 = qd_6 * omega_r_6_y - s_6 * t12 - c_6 * domega_5_x;
  const Scalar t15 = s_6 * t13 + c_6 * t14;
  const Scalar domega_5_y = qd_5 * omega_r_5_x - t7 * t9;
  const Scalar domega_e_5_t_x = s_5 * domega_5_y - c_5 * t15;
  const Scalar domega_e_6_t_y = s_6 * t14 - c_6 * t13;
  const Scalar t16 = s_4 * domega_e_5_t_x - c_4 * domega_e_6_t_y;
  const Scalar domega_e_4_t_x = s_4 * domega_e_6_t_y + c_4 * domega_e_5_t_x;
  const Scalar t17 = s_3 * t16 - c_3 * domega_e_4_t_x;
  const Scalar t18 = s_3 * domega_e_4_t_x + c_3 * t16;
  a[5] = c_2 * t18 - s_2 * t17;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t19 = (t4 * omega_3_z + Scalar(1.0834926704907584) * s_2 * qd_2) -
      Scalar(0.2413001912045889) * t8 * omega_4_z;
  const Scalar t20 = qd_1 * qd_1;
  const Scalar t21 = t20 * t2;
  const Scalar t22 = t2 * t21;
  const Scalar U_3_zz = t22 + t20 * t4 * t4;
  const Scalar ddp_o_5_z = Scalar(0.10915) * U_3_zz + Scalar(0.7845) * qd_1 * t19;
  const Scalar t23 = c_2 * t20;
  const Scalar U_2_xx = qd_2 * qd_2 + c_2 * t23;
  const Scalar t24 = Scalar(0.425) * (s_3 * U_2_xx + t23 * t3) - Scalar(0.39225) * t4 * t21;
  const Scalar U_3_xx = omega_3_z * omega_3_z + t22;
  const Scalar ddp_o_4_x = Scalar(0.39225) * U_3_xx - Scalar(0.425) * (t23 * t1 - c_3 * U_2_xx);
  const Scalar t25 = t20 * t5;
  const Scalar t26 = Scalar(0.09465) * t8 * t25 + s_4 * t24 - c_4 * ddp_o_4_x;
  const Scalar t27 = s_5 * ddp_o_5_z + c_5 * t26;
  const Scalar U_4_yy = omega_4_z * omega_4_z + t5 * t25;
  const Scalar t28 = Scalar(0.09465) * U_4_yy - s_4 * ddp_o_4_x - c_4 * t24;
  const Scalar t29 = Scalar(0.0823) * (t14 - omega_r_6_y * omega_6_z) + s_6 * t27 + c_6 * t28;
  const Scalar t30 = Scalar(0.0823) * (t13 - t10 * omega_6_z) + s_6 * t28 - c_6 * t27;
  const Scalar t31 = s_6 * t29 - c_6 * t30;
  const Scalar U_6_zz = omega_r_6_y * omega_r_6_y + t10 * t10;
  const Scalar ddp_e_z = Scalar(0.0823) * U_6_zz - s_5 * t26 + c_5 * ddp_o_5_z;
  const Scalar t32 = s_5 * ddp_e_z - c_5 * t31;
  const Scalar t33 = s_6 * t30 + c_6 * t29;
  const Scalar t34 = s_4 * t32 + c_4 * t33;
  const Scalar t35 = s_4 * t33 - c_4 * t32;
  const Scalar t36 = s_3 * t34 + c_3 * t35;
  const Scalar a_3_t_y = s_3 * t35 - c_3 * t34;
  a[2] = -s_2 * t36 - c_2 * a_3_t_y;
  const Scalar t37 = s_2 * t18 + c_2 * t17;
  const Scalar domega_e_5_t_y = s_5 * t15 + c_5 * domega_5_y;
  a[3] = -s_1 * domega_e_5_t_y - c_1 * t37;
  a[4] = c_1 * domega_e_5_t_y - s_1 * t37;
  const Scalar t38 = s_2 * a_3_t_y - c_2 * t36;
  const Scalar a_5_t_y = s_5 * t31 + c_5 * ddp_e_z;
  a[1] = s_1 * t38 + c_1 * a_5_t_y;
  a[0] = c_1 * t38 - s_1 * a_5_t_y;
}

}  // namespace ur5

#endif  // FLATDYN_UR5_HPP

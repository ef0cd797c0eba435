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
// Reads q[1..5], qd[0..5], qdd[0..5]. Operations: 241 mul, 227 add, 10 sin/cos.
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
  const Scalar U_2_yx = t12 + qdd_2;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 + Scalar(0.45) * U_2_yx;
  const Scalar t13 = t2 * t2;
  const Scalar t14 = qd_2 * qd_2;
  const Scalar t15 = t13 + t14;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 - Scalar(0.45) * t15;
  const Scalar ddp_3_x = s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar omega_r_3_x = s_3 * t2 + c_3 * t1;
  const Scalar t16 = omega_r_3_x * t3;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar t17 = t16 + domega_3_z;
  const Scalar ddp_o_4_x = ddp_3_x - Scalar(0.45) * t17;
  const Scalar t18 = s_4 * ddp_o_4_z - c_4 * ddp_o_4_x;
  const Scalar t19 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t20 = omega_r_3_x * omega_r_3_x;
  const Scalar t21 = omega_3_z * omega_3_z;
  const Scalar t22 = t20 + t21;
  const Scalar t23 = t19 + Scalar(0.45) * t22;
  const Scalar t24 = c_5 * t18 + s_5 * t23;
  const Scalar ddp_5_a_z = s_4 * ddp_o_4_x + c_4 * ddp_o_4_z;
  const Scalar t25 = s_6 * ddp_5_a_z + c_6 * t24;
  const Scalar t26 = s_6 * t24 - c_6 * ddp_5_a_z;
  const Scalar t27 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar omega_4_z = qd_4 - t3;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t27;
  const Scalar omega_r_5_a_z = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t28 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar omega_r_5_y = s_5 * t27 + c_5 * omega_4_z;
  const Scalar t29 = c_4 * t9 + qd_4 * omega_r_5_a_z + s_4 * domega_3_z;
  const Scalar t30 = qd_3 * omega_r_3_x + s_3 * domega_2_x + c_3 * t6;
  const Scalar domega_4_z = qdd_4 - t30;
  const Scalar domega_5_x = qd_5 * omega_r_5_y + s_5 * domega_4_z - c_5 * t29;
  const Scalar t31 = s_4 * t9 + qd_4 * t27 - c_4 * domega_3_z;
  const Scalar domega_5_z = qdd_5 - t31;
  const Scalar t32 = qd_6 * t28 - s_6 * domega_5_x - c_6 * domega_5_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t33 = t28 * omega_6_z;
  const Scalar t34 = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t35 = qd_6 * t34 + s_6 * domega_5_z - c_6 * domega_5_x;
  const Scalar t36 = t34 * omega_6_z;
  const Scalar t37 = t34 * t34;
  const Scalar t38 = omega_6_z * omega_6_z;
  const Scalar t39 = t37 + t38;
  const Scalar t40 = t28 * t28;
  const Scalar t41 = t40 + t38;
  const Scalar t42 = qd_5 * omega_r_5_x - s_5 * t29 - c_5 * domega_4_z;
  const Scalar domega_6_z = qdd_6 - t42;
  const Scalar t43 = t28 * t34;
  const Scalar t44 = domega_6_z - t43;
  const Scalar U_6_yx = t43 + domega_6_z;
  const Scalar tau_6 = Scalar(0.000535) * U_6_yx - Scalar(0.000534) * (t35 - t36) -
      Scalar(0.000256) * (t39 - t41) + Scalar(0.0007896) * t44 - Scalar(0.0009944) * (t32 - t33) +
      Scalar(0.0112) * t25 - Scalar(0.007) * t26;
  tau[5] = tau_6;
  const Scalar t45 = t32 + t33;
  const Scalar t46 = t35 + t36;
  const Scalar t47 = t37 + t40;
  const Scalar ddp_5_y = s_5 * t18 - c_5 * t23;
  const Scalar N_6_x = Scalar(0.000256) * t45 + Scalar(0.000534) * U_6_yx -
      Scalar(0.0007896) * t46 + Scalar(0.0009944) * (t41 - t47) + Scalar(0.0112) * ddp_5_y;
  const Scalar U_6_zz_xx = t39 - t47;
  const Scalar N_6_y = Scalar(0.000535) * t45 - Scalar(0.000256) * t46 - Scalar(0.0009944) * t44 +
      Scalar(0.000534) * U_6_zz_xx + Scalar(0.007) * ddp_5_y;
  const Scalar t48 = omega_r_5_x * omega_5_z;
  const Scalar t49 = omega_r_5_y * omega_5_z;
  const Scalar t50 = omega_r_5_y * omega_r_5_y;
  const Scalar t51 = omega_5_z * omega_5_z;
  const Scalar t52 = t50 + t51;
  const Scalar t53 = omega_r_5_x * omega_r_5_x;
  const Scalar t54 = t53 + t51;
  const Scalar t55 = omega_r_5_x * omega_r_5_y;
  const Scalar t56 = domega_5_z - t55;
  const Scalar U_5_yx = t55 + domega_5_z;
  const Scalar tau_5 = Scalar(-0.0007639) * (domega_5_x - t49) - Scalar(0.0016163) * (t42 - t48) -
      Scalar(0.0010857) * (t52 - t54) - c_6 * N_6_y + Scalar(0.0029421) * U_5_yx - s_6 * N_6_x +
      Scalar(0.0203) * ddp_5_y + Scalar(0.0317) * t24 + Scalar(0.0123285) * t56;
  tau[4] = tau_5;
  const Scalar t57 = t48 + t42;
  const Scalar U_5_zy = t49 + domega_5_x;
  const Scalar t58 = t50 + t53;
  const Scalar mu_5_x = Scalar(-0.0007639) * U_5_yx - Scalar(0.0010857) * t57 -
      Scalar(0.0016163) * (t54 - t58) - s_6 * N_6_y + c_6 * N_6_x + Scalar(0.0317) * ddp_5_a_z +
      Scalar(0.0123285) * U_5_zy;
  const Scalar U_5_zz_xx = t52 - t58;
  const Scalar t59 = Scalar(0.0007639) * U_5_zz_xx - Scalar(0.0010857) * U_5_zy -
      Scalar(0.0016163) * t56 + Scalar(0.0029421) * t57 + Scalar(0.0203) * ddp_5_a_z - tau_6;
  const Scalar t60 = t27 * omega_4_z;
  const Scalar t61 = omega_r_5_a_z * omega_4_z;
  const Scalar t62 = omega_r_5_a_z * omega_r_5_a_z;
  const Scalar t63 = omega_4_z * omega_4_z;
  const Scalar t64 = t63 + t62;
  const Scalar t65 = t27 * t27;
  const Scalar t66 = t63 + t65;
  const Scalar t67 = t27 * omega_r_5_a_z;
  const Scalar t68 = domega_4_z - t67;
  const Scalar U_4_yx = domega_4_z + t67;
  const Scalar tau_4 = Scalar(0.0009736) * (t64 - t66) + Scalar(0.0123968) * U_4_yx +
      Scalar(0.0110896) * (t29 - t61) - c_5 * t59 + s_5 * mu_5_x + Scalar(0.0316473) * t68 +
      Scalar(0.1164) * ddp_5_a_z + Scalar(0.0523608) * (t31 - t60) + Scalar(0.2145) * t18;
  tau[3] = tau_4;
  const Scalar t69 = Scalar(0.007) * U_6_yx + Scalar(0.0112) * t41;
  const Scalar F_6_x = Scalar(0.007) * t39 - Scalar(0.0112) * t44;
  const Scalar t70 = -s_6 * t69 - c_6 * F_6_x + Scalar(0.0203) * t52 + Scalar(0.0317) * t56;
  const Scalar f_5_y = Scalar(0.007) * t45 + Scalar(0.0203) * U_5_yx - Scalar(0.0112) * t46 -
      Scalar(0.0317) * t54;
  const Scalar f_4_x = -s_5 * f_5_y - c_5 * t70 + Scalar(0.1164) * t64 - Scalar(0.2145) * t68;
  const Scalar t71 = c_6 * t69 - s_6 * F_6_x + Scalar(0.0203) * t57 + Scalar(0.0317) * U_5_zy +
      Scalar(0.1164) * U_4_yx + Scalar(0.2145) * t66;
  const Scalar f_u_4_t_x = s_4 * t71 + c_4 * f_4_x;
  const Scalar t72 = t60 + t31;
  const Scalar t73 = t61 + t29;
  const Scalar t74 = t62 + t65;
  const Scalar t75 = Scalar(0.0009736) * t72 + Scalar(0.0110896) * U_4_yx - s_5 * t59 -
      c_5 * mu_5_x + Scalar(0.0316473) * t73 + Scalar(0.0523608) * (t66 - t74) +
      Scalar(0.2145) * t23;
  const Scalar U_4_zz_xx = t64 - t74;
  const Scalar t76 = Scalar(-0.0009736) * t73 - Scalar(0.0123968) * t72 +
      Scalar(0.0110896) * U_4_zz_xx - Scalar(0.0523608) * t68 + tau_5 + Scalar(0.1164) * t23;
  const Scalar t77 = omega_r_3_x * omega_3_z;
  const Scalar t78 = t3 * t3;
  const Scalar t79 = t78 + t21;
  const Scalar U_3_yx = domega_3_z - t16;
  const Scalar t80 = Scalar(0.016137) * (t9 - t10) - Scalar(0.0408384) * (t30 - t77) +
      Scalar(0.026176) * (t79 - t22) - Scalar(0.0741175) * U_3_yx + Scalar(0.45) * f_u_4_t_x -
      c_4 * t76 + Scalar(0.2745) * t19 - s_4 * t75 + Scalar(3.8308) * ddp_3_x -
      Scalar(1.9653344) * t17;
  tau[2] = -t80;
  const Scalar f_3_y = c_5 * f_5_y - s_5 * t70 + Scalar(0.1164) * t72 + Scalar(0.2745) * U_3_yx -
      Scalar(0.2145) * t73 - Scalar(3.8308) * t22;
  const Scalar t81 = s_3 * (Scalar(0.2745) * t79 - f_u_4_t_x + Scalar(3.8308) * t17) - c_3 * f_3_y;
  const Scalar t82 = t1 * t1;
  const Scalar t83 = t82 + t14;
  const Scalar t84 = qdd_2 - t12;
  tau[1] = Scalar(0.0444376) * t5 - Scalar(0.1098692) * t8 + Scalar(0.0771094) * t84 -
      Scalar(0.0684948) * (t15 - t83) + Scalar(4.102542) * s_2 - Scalar(0.45) * t81 - t80 +
      Scalar(8.4773316) * U_2_yx + Scalar(194.232114) * c_2;
  const Scalar t85 = Scalar(-0.45) * (s_4 * f_4_x - c_4 * t71);
  const Scalar t86 = t30 + t77;
  const Scalar t87 = t78 + t20;
  const Scalar mu_3_x = Scalar(0.016137) * U_3_yx - Scalar(0.026176) * t86 +
      Scalar(0.0408384) * (t22 - t87) + s_4 * t76 + t85 - c_4 * t75 + Scalar(1.72386) * U_2_zx -
      Scalar(1.9653344) * t11;
  const Scalar U_3_zz_xx = t79 - t87;
  const Scalar t88 = Scalar(0.026176) * t11 - Scalar(0.016137) * U_3_zz_xx +
      Scalar(0.0408384) * t17 + Scalar(0.123525) * U_2_zx + Scalar(0.0741175) * t86 - tau_4;
  const Scalar U_2_zy = t7 + domega_2_x;
  const Scalar t89 = t13 + t82;
  const Scalar t90 = Scalar(0.0684948) * U_2_zx - Scalar(0.0771094) * U_2_zy +
      Scalar(0.0444376) * (t83 - t89) + Scalar(0.1098692) * U_2_yx - s_3 * t88 - c_3 * mu_3_x;
  const Scalar U_2_zz_xx = t15 - t89;
  const Scalar mu_2_y = Scalar(0.0444376) * t84 + Scalar(0.0684948) * U_2_zy -
      Scalar(0.123525) * t86 - Scalar(0.1098692) * U_2_zz_xx - t85 - c_3 * t88 +
      Scalar(1.72386) * t11 + s_3 * mu_3_x - Scalar(8.4773316) * U_2_zx;
  tau[0] = Scalar(0.8059476) * qdd_1 - s_2 * t90 + c_2 * mu_2_y;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..5], qd[0..5], qdd[0..5], h_e[0..5]. Operations: 289 mul, 257 add, 12 sin/cos.
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
  const Scalar U_2_yx = t12 + qdd_2;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 + Scalar(0.45) * U_2_yx;
  const Scalar t13 = t2 * t2;
  const Scalar t14 = qd_2 * qd_2;
  const Scalar t15 = t13 + t14;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 - Scalar(0.45) * t15;
  const Scalar ddp_3_x = s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar omega_r_3_x = s_3 * t2 + c_3 * t1;
  const Scalar t16 = omega_r_3_x * t3;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar t17 = t16 + domega_3_z;
  const Scalar ddp_o_4_x = ddp_3_x - Scalar(0.45) * t17;
  const Scalar t18 = s_4 * ddp_o_4_z - c_4 * ddp_o_4_x;
  const Scalar t19 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t20 = omega_r_3_x * omega_r_3_x;
  const Scalar t21 = omega_3_z * omega_3_z;
  const Scalar t22 = t20 + t21;
  const Scalar t23 = t19 + Scalar(0.45) * t22;
  const Scalar t24 = c_5 * t18 + s_5 * t23;
  const Scalar ddp_5_a_z = s_4 * ddp_o_4_x + c_4 * ddp_o_4_z;
  const Scalar t25 = s_6 * ddp_5_a_z + c_6 * t24;
  const Scalar t26 = s_6 * t24 - c_6 * ddp_5_a_z;
  const Scalar t27 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar omega_4_z = qd_4 - t3;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t27;
  const Scalar omega_r_5_a_z = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t28 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar omega_r_5_y = s_5 * t27 + c_5 * omega_4_z;
  const Scalar t29 = c_4 * t9 + qd_4 * omega_r_5_a_z + s_4 * domega_3_z;
  const Scalar t30 = qd_3 * omega_r_3_x + s_3 * domega_2_x + c_3 * t6;
  const Scalar domega_4_z = qdd_4 - t30;
  const Scalar domega_5_x = qd_5 * omega_r_5_y + s_5 * domega_4_z - c_5 * t29;
  const Scalar t31 = s_4 * t9 + qd_4 * t27 - c_4 * domega_3_z;
  const Scalar domega_5_z = qdd_5 - t31;
  const Scalar t32 = qd_6 * t28 - s_6 * domega_5_x - c_6 * domega_5_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t33 = t28 * omega_6_z;
  const Scalar t34 = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t35 = qd_6 * t34 + s_6 * domega_5_z - c_6 * domega_5_x;
  const Scalar t36 = t34 * omega_6_z;
  const Scalar t37 = t34 * t34;
  const Scalar t38 = omega_6_z * omega_6_z;
  const Scalar t39 = t37 + t38;
  const Scalar t40 = t28 * t28;
  const Scalar t41 = t40 + t38;
  const Scalar t42 = qd_5 * omega_r_5_x - s_5 * t29 - c_5 * domega_4_z;
  const Scalar domega_6_z = qdd_6 - t42;
  const Scalar t43 = t28 * t34;
  const Scalar t44 = domega_6_z - t43;
  const Scalar U_6_yx = t43 + domega_6_z;
  const Scalar mu_e1_x = s_1 * h_e_5 + c_1 * h_e_4;
  const Scalar t45 = s_2 * mu_e1_x - c_2 * h_e_6;
  const Scalar mu_e2_x = s_2 * h_e_6 + c_2 * mu_e1_x;
  const Scalar t46 = s_3 * t45 - c_3 * mu_e2_x;
  const Scalar t47 = s_1 * h_e_4 - c_1 * h_e_5;
  const Scalar t48 = s_4 * t47 + c_4 * t46;
  const Scalar t49 = s_3 * mu_e2_x + c_3 * t45;
  const Scalar mu_6_z = Scalar(0.000535) * U_6_yx - Scalar(0.000534) * (t35 - t36) -
      Scalar(0.000256) * (t39 - t41) + Scalar(0.0007896) * t44 - Scalar(0.0009944) * (t32 - t33) +
      Scalar(0.0112) * t25 - Scalar(0.007) * t26 + s_5 * t48 - c_5 * t49;
  tau[5] = mu_6_z;
  const Scalar t50 = t32 + t33;
  const Scalar t51 = t35 + t36;
  const Scalar t52 = t37 + t40;
  const Scalar ddp_5_y = s_5 * t18 - c_5 * t23;
  const Scalar t53 = s_5 * t49 + c_5 * t48;
  const Scalar mu_e4_y = s_4 * t46 - c_4 * t47;
  const Scalar mu_6_x = Scalar(0.000256) * t50 + Scalar(0.000534) * U_6_yx -
      Scalar(0.0007896) * t51 + Scalar(0.0009944) * (t41 - t52) + Scalar(0.0112) * ddp_5_y +
      s_6 * mu_e4_y - c_6 * t53;
  const Scalar U_6_zz_xx = t39 - t52;
  const Scalar mu_6_y = Scalar(0.000535) * t50 - Scalar(0.000256) * t51 - Scalar(0.0009944) * t44 +
      Scalar(0.000534) * U_6_zz_xx + Scalar(0.007) * ddp_5_y + s_6 * t53 + c_6 * mu_e4_y;
  const Scalar t54 = omega_r_5_x * omega_5_z;
  const Scalar t55 = omega_r_5_y * omega_5_z;
  const Scalar t56 = omega_r_5_y * omega_r_5_y;
  const Scalar t57 = omega_5_z * omega_5_z;
  const Scalar t58 = t56 + t57;
  const Scalar t59 = omega_r_5_x * omega_r_5_x;
  const Scalar t60 = t59 + t57;
  const Scalar t61 = omega_r_5_x * omega_r_5_y;
  const Scalar t62 = domega_5_z - t61;
  const Scalar U_5_yx = t61 + domega_5_z;
  const Scalar tau_5 = Scalar(-0.0007639) * (domega_5_x - t55) - Scalar(0.0016163) * (t42 - t54) -
      Scalar(0.0010857) * (t58 - t60) + Scalar(0.0029421) * U_5_yx + Scalar(0.0203) * ddp_5_y +
      Scalar(0.0317) * t24 + Scalar(0.0123285) * t62 - s_6 * mu_6_x - c_6 * mu_6_y;
  tau[4] = tau_5;
  const Scalar t63 = t54 + t42;
  const Scalar U_5_zy = t55 + domega_5_x;
  const Scalar t64 = t56 + t59;
  const Scalar mu_5_x = Scalar(-0.0007639) * U_5_yx - Scalar(0.0010857) * t63 -
      Scalar(0.0016163) * (t60 - t64) + Scalar(0.0317) * ddp_5_a_z + Scalar(0.0123285) * U_5_zy -
      s_6 * mu_6_y + c_6 * mu_6_x;
  const Scalar U_5_zz_xx = t58 - t64;
  const Scalar t65 = Scalar(0.0007639) * U_5_zz_xx - Scalar(0.0010857) * U_5_zy -
      Scalar(0.0016163) * t62 + Scalar(0.0029421) * t63 + Scalar(0.0203) * ddp_5_a_z - mu_6_z;
  const Scalar t66 = t27 * omega_4_z;
  const Scalar t67 = omega_r_5_a_z * omega_4_z;
  const Scalar t68 = omega_r_5_a_z * omega_r_5_a_z;
  const Scalar t69 = omega_4_z * omega_4_z;
  const Scalar t70 = t69 + t68;
  const Scalar t71 = t27 * t27;
  const Scalar t72 = t69 + t71;
  const Scalar t73 = t27 * omega_r_5_a_z;
  const Scalar t74 = domega_4_z - t73;
  const Scalar U_4_yx = domega_4_z + t73;
  const Scalar tau_4 = Scalar(0.0009736) * (t70 - t72) + Scalar(0.0123968) * U_4_yx +
      Scalar(0.0110896) * (t29 - t67) + Scalar(0.0316473) * t74 + Scalar(0.1164) * ddp_5_a_z +
      Scalar(0.0523608) * (t31 - t66) + Scalar(0.2145) * t18 + s_5 * mu_5_x - c_5 * t65;
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
  const Scalar t81 = Scalar(0.007) * U_6_yx + Scalar(0.0112) * t41 - s_6 * t80 - c_6 * f_e4_y;
  const Scalar f_6_x = Scalar(0.007) * t39 - Scalar(0.0112) * t44 + s_6 * f_e4_y - c_6 * t80;
  const Scalar t82 = Scalar(0.0203) * t58 + Scalar(0.0317) * t62 - s_6 * t81 - c_6 * f_6_x;
  const Scalar f_5_y = Scalar(0.007) * t50 + Scalar(0.0203) * U_5_yx - Scalar(0.0112) * t51 -
      Scalar(0.0317) * t60 + s_5 * t78 - c_5 * t79;
  const Scalar f_4_x = Scalar(0.1164) * t70 - Scalar(0.2145) * t74 - s_5 * f_5_y - c_5 * t82;
  const Scalar t83 = Scalar(0.0203) * t63 + Scalar(0.0317) * U_5_zy + Scalar(0.1164) * U_4_yx +
      Scalar(0.2145) * t72 - s_6 * f_6_x + c_6 * t81;
  const Scalar f_u_4_t_x = s_4 * t83 + c_4 * f_4_x;
  const Scalar t84 = t66 + t31;
  const Scalar t85 = t67 + t29;
  const Scalar t86 = t68 + t71;
  const Scalar t87 = Scalar(0.0009736) * t84 + Scalar(0.0110896) * U_4_yx +
      Scalar(0.0316473) * t85 + Scalar(0.0523608) * (t72 - t86) + Scalar(0.2145) * t23 - s_5 * t65 -
      c_5 * mu_5_x;
  const Scalar U_4_zz_xx = t70 - t86;
  const Scalar t88 = Scalar(-0.0009736) * t85 - Scalar(0.0123968) * t84 +
      Scalar(0.0110896) * U_4_zz_xx - Scalar(0.0523608) * t74 + Scalar(0.1164) * t23 + tau_5;
  const Scalar t89 = omega_r_3_x * omega_3_z;
  const Scalar t90 = t3 * t3;
  const Scalar t91 = t90 + t21;
  const Scalar U_3_yx = domega_3_z - t16;
  const Scalar t92 = Scalar(0.016137) * (t9 - t10) - Scalar(0.0408384) * (t30 - t89) +
      Scalar(0.026176) * (t91 - t22) - Scalar(0.0741175) * U_3_yx + Scalar(0.2745) * t19 +
      Scalar(0.45) * f_u_4_t_x - s_4 * t87 - c_4 * t88 + Scalar(3.8308) * ddp_3_x -
      Scalar(1.9653344) * t17;
  tau[2] = -t92;
  const Scalar f_3_y = Scalar(0.1164) * t84 + Scalar(0.2745) * U_3_yx - Scalar(0.2145) * t85 -
      s_5 * t82 + c_5 * f_5_y - Scalar(3.8308) * t22;
  const Scalar t93 = s_3 * (Scalar(0.2745) * t91 - f_u_4_t_x + Scalar(3.8308) * t17) - c_3 * f_3_y;
  const Scalar t94 = t1 * t1;
  const Scalar t95 = t94 + t14;
  const Scalar t96 = qdd_2 - t12;
  tau[1] = Scalar(0.0444376) * t5 - Scalar(0.1098692) * t8 + Scalar(0.0771094) * t96 -
      Scalar(0.0684948) * (t15 - t95) + Scalar(4.102542) * s_2 - Scalar(0.45) * t93 - t92 +
      Scalar(8.4773316) * U_2_yx + Scalar(194.232114) * c_2;
  const Scalar t97 = Scalar(-0.45) * (s_4 * f_4_x - c_4 * t83);
  const Scalar t98 = t30 + t89;
  const Scalar t99 = t90 + t20;
  const Scalar mu_3_x = Scalar(0.016137) * U_3_yx - Scalar(0.026176) * t98 +
      Scalar(0.0408384) * (t22 - t99) + s_4 * t88 - c_4 * t87 + t97 + Scalar(1.72386) * U_2_zx -
      Scalar(1.9653344) * t11;
  const Scalar U_3_zz_xx = t91 - t99;
  const Scalar t100 = Scalar(0.026176) * t11 - Scalar(0.016137) * U_3_zz_xx +
      Scalar(0.0408384) * t17 + Scalar(0.123525) * U_2_zx + Scalar(0.0741175) * t98 - tau_4;
  const Scalar U_2_zy = t7 + domega_2_x;
  const Scalar t101 = t13 + t94;
  const Scalar t102 = Scalar(0.0684948) * U_2_zx - Scalar(0.0771094) * U_2_zy +
      Scalar(0.0444376) * (t95 - t101) + Scalar(0.1098692) * U_2_yx - s_3 * t100 - c_3 * mu_3_x;
  const Scalar U_2_zz_xx = t15 - t101;
  const Scalar mu_2_y = Scalar(0.0444376) * t96 + Scalar(0.0684948) * U_2_zy -
      Scalar(0.123525) * t98 - Scalar(0.1098692) * U_2_zz_xx - t97 - c_3 * t100 +
      Scalar(1.72386) * t11 + s_3 * mu_3_x - Scalar(8.4773316) * U_2_zx;
  tau[0] = Scalar(0.8059476) * qdd_1 - s_2 * t102 + c_2 * mu_2_y;
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
// Reads q[1..5]. Operations: 113 mul, 100 add, 10 sin/cos.
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
  const Scalar hu_6_t_y = Scalar(0.0112) * c_6 - Scalar(0.007) * s_6;
  const Scalar t4 = c_5 * hu_6_t_y;
  const Scalar f_u_6_6_a_z = Scalar(0.007) * c_6 + Scalar(0.0112) * s_6;
  const Scalar t5 = s_4 * f_u_6_6_a_z - c_4 * t4;
  const Scalar t6 = Scalar(0.0013246) * s_5 - c_5 * Iu_6_t_xz;
  const Scalar t7 = -s_4 * t6 - c_4 * Iu_6_a_xy + Scalar(0.45) * t5;
  B[17] = B[32] = -t7;
  const Scalar Iu_6_t_xx = t1 - Scalar(0.0002546);
  const Scalar Iu_5_t_d = Iu_6_t_xx + Scalar(0.0088514);
  const Scalar Ic_5_xy = Iu_6_t_xz + Scalar(0.0010857);
  const Scalar t8 = Scalar(2.0) * s_5 * Ic_5_xy - c_5 * Iu_5_t_d;
  const Scalar t9 = c_5 * t8;
  const Scalar Ic_4_zz = Iu_6_t_xx + t9 + Scalar(0.0571622);
  B[21] = Ic_4_zz;
  const Scalar t10 = f_u_6_6_a_z - Scalar(0.0203);
  const Scalar hu_5_t_y = Scalar(0.0317) * c_5 - s_5 * t10;
  const Scalar t11 = Scalar(0.45) * hu_5_t_y;
  const Scalar t12 = mu_u_5_5_a_y - t11;
  const Scalar Iu_5_a_xz = c_5 * t2 + s_5 * Ic_5_yz;
  const Scalar mu_5_3_z = s_4 * Iu_5_a_xz - c_4 * t12;
  B[16] = B[26] = mu_5_3_z;
  B[11] = B[31] = Scalar(0.45) * (s_3 * t5 - c_3 * s_5 * hu_6_t_y) - t7;
  const Scalar t13 = c_5 * t10 + Scalar(0.0317) * s_5;
  B[10] = B[25] = mu_5_3_z - Scalar(0.45) * (s_3 * c_4 * hu_5_t_y + c_3 * t13);
  const Scalar f_u_6_4_a_z = s_4 * t4 + c_4 * f_u_6_6_a_z;
  const Scalar t14 = Scalar(0.45) * f_u_6_4_a_z;
  const Scalar mu_6_3_x = s_4 * Iu_6_a_xy - c_4 * t6 + t14;
  const Scalar t15 = c_2 * (t14 - c_3 * mu_u_6_5_t_y - s_3 * mu_6_3_x);
  B[5] = B[30] = -s_2 * (s_3 * mu_u_6_5_t_y - c_3 * mu_6_3_x) - t15;
  const Scalar Ic_4_xz = Ic_5_xy - s_5 * t8 - Scalar(0.0110896);
  const Scalar t16 = t3 + Scalar(0.0523608);
  const Scalar t17 = t13 + Scalar(0.1164);
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.2145);
  const Scalar t18 = Scalar(-0.45) * (s_4 * t17 - c_4 * hc_4_y);
  const Scalar t19 = (s_4 * Ic_4_xz + c_4 * t16) - t18;
  B[15] = B[20] = -t19;
  const Scalar t20 = c_4 * Iu_5_a_xz + s_4 * t12;
  const Scalar t21 = c_2 * (c_3 * t3 + s_4 * t11 + s_3 * t20);
  B[4] = B[24] = s_2 * (s_3 * t3 - c_3 * t20) - t21;
  B[9] = B[19] = -s_3 * t18 - t19;
  const Scalar t22 = t9 + Scalar(0.0088514);
  const Scalar t23 = mu_u_5_5_a_y + Scalar(0.0323686);
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0009736);
  const Scalar t24 = Scalar(2.0) * s_4 * Ic_4_xy + c_4 * (t22 - t23);
  const Scalar t25 = c_4 * t24;
  const Scalar t26 = Scalar(0.9) * hu_5_t_y;
  const Scalar t27 = t22 - t25 - t26 - Scalar(2.0842173);
  B[14] = -t27;
  const Scalar f_u_4_4_a_z = c_4 * t17 + s_4 * hc_4_y;
  const Scalar t28 = f_u_4_4_a_z - Scalar(0.2745);
  const Scalar hc_3_y = hu_5_t_y + Scalar(3.8308);
  const Scalar t29 = c_3 * t28 + s_3 * hc_3_y;
  const Scalar t30 = Scalar(0.9) * t29;
  B[7] = -t27 - t30 + Scalar(8.554441);
  B[8] = B[13] = Scalar(-0.45) * t29 - t27;
  const Scalar t31 = Scalar(0.45) * f_u_4_4_a_z;
  const Scalar t32 = (s_4 * t16 - c_4 * Ic_4_xz) - t31;
  const Scalar t33 = c_2 * (s_3 * t32 - c_3 * Ic_4_zz + t31);
  B[3] = B[18] = -s_2 * (s_3 * Ic_4_zz + c_3 * t32) - t33;
  const Scalar t34 = Ic_4_xy - s_4 * t24 - Scalar(0.016137);
  const Scalar t35 = Scalar(0.0408384) + t19;
  const Scalar t36 = s_3 * t35 - c_3 * t34;
  const Scalar t37 = s_3 * t34 + c_3 * t35;
  B[2] = B[12] = s_2 * t36 - c_2 * t37;
  B[1] = B[6] = s_2 * (t18 + t36 - Scalar(0.1098692)) - c_2 * (t37 - Scalar(0.0444376));
  const Scalar t38 = t25 - t26 + t23;
  const Scalar Ic_3_yy = Ic_4_zz - Scalar(1.9359823);
  const Scalar t39 = t32 - Scalar(0.026176);
  const Scalar t40 = Scalar(2.0) * s_3 * t39 - c_3 * (t38 + Ic_3_yy);
  const Scalar t41 = c_3 * t40;
  const Scalar Iu_3_t_xx = t41 + Ic_3_yy;
  const Scalar t42 = s_3 * t28 - c_3 * hc_3_y;
  const Scalar t43 = s_2 * (t39 - Scalar(0.0684948) - s_3 * t40 - Scalar(0.45) * t42);
  const Scalar t44 = Scalar(2.0) * t43 + c_2 * (t38 + t41 + Iu_3_t_xx + t30 - Scalar(8.4002222));
  B[0] = Iu_3_t_xx + Scalar(2.8931568) - c_2 * t44;
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
template <class Scalar, class SinCos = LibrarySinCos>
inline void christoffel(const Scalar* q, Scalar* c, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar Iu_6_t_xz = Scalar(0.000267) * c_6 + Scalar(0.0004972) * s_6;
  c[104] = Scalar(-2.0) * Iu_6_t_xz;
  const Scalar Iu_6_t_g = Scalar(0.0001273) * c_6 - Scalar(0.000256) * s_6;
  const Scalar t1 = s_6 * Iu_6_t_g;
  const Scalar t2 = Scalar(0.0001273) * s_6 + Scalar(0.000256) * c_6;
  const Scalar db_55_6r = t1 + c_6 * t2;
  c[103] = db_55_6r;
  const Scalar Iu_6_a_xy = Scalar(0.0004972) * c_6 - Scalar(0.000267) * s_6;
  const Scalar t3 = s_5 * Iu_6_a_xy;
  c[83] = Scalar(2.0) * t3;
  c[119] = -db_55_6r;
  const Scalar dmu_4_6_x = Scalar(0.0004972) * c_5 - s_5 * t2;
  const Scalar dmu_4_6_y = Scalar(0.000267) * c_5 + s_5 * Iu_6_t_g;
  const Scalar db_44_6r = s_5 * (c_6 * dmu_4_6_x - s_6 * dmu_4_6_y + c_5 * Iu_6_a_xy);
  c[81] = db_44_6r;
  const Scalar t4 = s_4 * c_5;
  const Scalar t5 = c_4 * s_6 + c_6 * t4;
  const Scalar t6 = c_4 * c_6 - s_6 * t4;
  const Scalar t7 = Scalar(0.000267) * t6 + Scalar(0.0004972) * t5;
  const Scalar f_u_6_6_a_z = Scalar(0.0035) * c_6 + Scalar(0.0056) * s_6;
  const Scalar t8 = Scalar(0.45) * f_u_6_6_a_z;
  const Scalar t9 = c_4 * c_5;
  const Scalar hu_6_t_y = Scalar(0.0056) * c_6 - Scalar(0.0035) * s_6;
  const Scalar t10 = Scalar(0.45) * s_4;
  const Scalar t11 = hu_6_t_y * t10 + t9 * t8;
  const Scalar t12 = t7 + t11;
  c[62] = Scalar(-2.0) * t12;
  const Scalar t13 = t1 + Scalar(0.00050995);
  const Scalar Ic_5_yz = Iu_6_a_xy + Scalar(0.00080815);
  const Scalar Iu_5_a_xz = c_5 * t13 + s_5 * Ic_5_yz;
  c[77] = Scalar(-2.0) * Iu_5_a_xz;
  const Scalar t14 = c_6 * Iu_6_t_g;
  const Scalar t15 = c_5 * Iu_6_t_xz;
  const Scalar t16 = s_5 * (t14 - s_6 * t2) + t15;
  const Scalar t17 = Scalar(0.0006623) * s_5 - t15;
  const Scalar c_5_4_6 = t17 - t16;
  c[102] = c_5_4_6;
  c[114] = -db_44_6r;
  const Scalar t18 = Scalar(0.45) * s_3;
  const Scalar v_o_2_4_x = t18 - Scalar(0.45);
  const Scalar t19 = c_4 * s_5;
  const Scalar t20 = Scalar(0.45) * c_3;
  const Scalar t21 = c_5 * t20 - v_o_2_4_x * t19;
  const Scalar t22 = hu_6_t_y * t21;
  const Scalar mu_u_6_5_t_y = Scalar(0.0006623) * c_5 + s_5 * Iu_6_t_xz;
  const Scalar t23 = s_4 * mu_u_6_5_t_y;
  const Scalar db_26_5 = t23 - t22;
  const Scalar t24 = s_4 * s_5;
  const Scalar t25 = Iu_6_t_g * t5 + t6 * t2 - Iu_6_t_xz * t24;
  const Scalar t26 = t22 - t25;
  c[40] = db_26_5 - t26;
  const Scalar c_6_2_5 = db_26_5 + t26;
  c[116] = c_6_2_5;
  const Scalar t27 = c_4 * t17 - s_4 * Iu_6_a_xy;
  const Scalar f_u_6_4_a_z = c_4 * f_u_6_6_a_z + hu_6_t_y * t4;
  const Scalar t28 = Scalar(0.45) * f_u_6_4_a_z;
  const Scalar t29 = t27 - t28;
  const Scalar t30 = t5 * dmu_4_6_x - t24 * t3 + t6 * dmu_4_6_y;
  const Scalar t31 = t30 + s_5 * t19 * t8 + c_5 * t11;
  c[60] = t29 - t31;
  const Scalar c_6_3_4 = t29 + t31;
  c[113] = c_6_3_4;
  const Scalar t32 = Scalar(0.45) * hu_6_t_y * t19;
  const Scalar t33 = t32 - t25;
  const Scalar db_36_5 = t23 - t32;
  c[61] = db_36_5 - t33;
  const Scalar c_6_3_5 = db_36_5 + t33;
  c[117] = c_6_3_5;
  c[82] = -t16 - t17;
  c[118] = -c_5_4_6;
  const Scalar Iu_6_t_xx = t14 - Scalar(0.0001273);
  const Scalar Iu_5_t_d = Iu_6_t_xx + Scalar(0.0044257);
  const Scalar Ic_5_xy = Scalar(2.0) * Iu_6_t_xz + Scalar(0.0010857);
  const Scalar t34 = c_5 * Iu_5_t_d - s_5 * Ic_5_xy;
  const Scalar t35 = s_5 * t34;
  const Scalar dmu_4_5_y = c_5 * Ic_5_xy + s_5 * Iu_5_t_d;
  const Scalar db_44_5r = t35 + c_5 * dmu_4_5_y;
  c[76] = db_44_5r;
  const Scalar t36 = Scalar(0.000256) * t5 - Scalar(0.0001273) * t6 + Scalar(0.0004972) * t24;
  const Scalar t37 = Scalar(0.001575) * t19 - t36;
  const Scalar t38 = Scalar(0.0001273) * t5 + Scalar(0.000256) * t6 - Scalar(0.000267) * t24;
  const Scalar t39 = Scalar(0.00252) * t19 - t38;
  const Scalar t40 = t5 * t37 - t12 * t24 - t6 * t39;
  const Scalar t41 = Scalar(0.0035) * t5 - Scalar(0.0056) * t6;
  const Scalar t42 = Scalar(0.45) * c_4;
  const Scalar c_3_3_6 = t40 - s_5 * (s_4 * t11 - t42 * t41);
  c[59] = c_3_3_6;
  const Scalar t43 = f_u_6_6_a_z - Scalar(0.01015);
  const Scalar t44 = c_5 * t43 + Scalar(0.01585) * s_5;
  const Scalar t45 = s_4 * t44;
  const Scalar w_1_3_x = c_2 * s_3 + s_2 * c_3;
  const Scalar t46 = Scalar(0.45) * c_2;
  const Scalar t47 = Scalar(0.45) * w_1_3_x - t46;
  const Scalar t48 = t47 * t45;
  const Scalar t49 = c_2 * c_3 - s_2 * s_3;
  const Scalar t50 = c_5 * t49 - w_1_3_x * t19;
  const Scalar t51 = w_1_3_x * t9 + s_5 * t49;
  const Scalar t52 = t13 * t50 + Ic_5_yz * t51 + t48;
  c[14] = Scalar(-2.0) * t52;
  const Scalar t53 = s_4 * w_1_3_x;
  const Scalar t54 = c_6 * t51 - s_6 * t53;
  const Scalar t55 = c_6 * t53 + s_6 * t51;
  const Scalar t56 = t47 * t41;
  const Scalar t57 = Scalar(0.0004972) * t54 - Scalar(0.000267) * t55 - t56;
  c[20] = Scalar(2.0) * t57;
  const Scalar v_2_5_x = s_5 * t20 + v_o_2_4_x * t9;
  const Scalar t58 = Scalar(0.01585) * t21 - t43 * v_2_5_x;
  const Scalar t59 = c_5 * Ic_5_yz - s_5 * t13;
  const Scalar t60 = s_4 * t59;
  const Scalar t61 = t58 - t60;
  c[35] = Scalar(-2.0) * t61;
  const Scalar t62 = t60 - t44 * t42;
  c[56] = Scalar(2.0) * t62;
  c[100] = -c_6_2_5;
  c[80] = -c_6_3_4;
  c[101] = -c_6_3_5;
  c[93] = -db_44_5r;
  c[110] = -c_3_3_6;
  const Scalar t63 = s_4 * v_o_2_4_x;
  const Scalar t64 = c_6 * v_2_5_x - s_6 * t63;
  const Scalar t65 = Scalar(0.0035) * t64 + Scalar(0.0056) * (s_6 * v_2_5_x + c_6 * t63);
  const Scalar t66 = t7 - t65;
  c[41] = Scalar(-2.0) * t66;
  const Scalar t67 = w_1_3_x * mu_u_6_5_t_y + t49 * t29;
  const Scalar t68 = t54 * t37 + t55 * t39 + t50 * t12;
  const Scalar c_3_1_6 = t67 - t68;
  c[57] = c_3_1_6;
  const Scalar t69 = Iu_5_a_xz * t53;
  const Scalar hu_5_t_y = Scalar(0.01585) * c_5 - s_5 * t43;
  const Scalar t70 = c_4 * t47;
  const Scalar t71 = hu_5_t_y * t70;
  const Scalar t72 = t34 * t51 - t69 + t50 * dmu_4_5_y + t71;
  const Scalar mu_u_5_5_a_y = t14 - Scalar(0.0080301);
  const Scalar t73 = c_4 * mu_u_5_5_a_y * w_1_3_x - t69 - t71;
  const Scalar c_4_1_5 = t73 + t72;
  c[73] = c_4_1_5;
  const Scalar t74 = t47 * t24;
  const Scalar t75 = s_5 * (Iu_6_a_xy * t50 - f_u_6_6_a_z * t74);
  const Scalar t76 = t54 * dmu_4_6_x - t55 * dmu_4_6_y + t75 - c_5 * t56;
  const Scalar t77 = hu_6_t_y * t9 - s_4 * f_u_6_6_a_z;
  const Scalar t78 = w_1_3_x * (c_4 * Iu_6_a_xy + s_4 * t17) + t47 * t77;
  c[18] = t78 + t76;
  const Scalar c_6_1_4 = t78 - t76;
  c[111] = c_6_1_4;
  const Scalar t79 = hu_6_t_y * t74;
  const Scalar t80 = Iu_6_t_xz * t50;
  const Scalar t81 = Iu_6_t_g * t54 - t55 * t2 + t80 + t79;
  const Scalar t82 = Scalar(0.0006623) * t51 - t80 + t79;
  const Scalar c_5_1_6 = t82 - t81;
  c[99] = c_5_1_6;
  const Scalar t83 = t44 + Scalar(0.0582);
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.10725);
  const Scalar f_u_4_4_a_z = c_4 * t83 + s_4 * hc_4_y;
  const Scalar df_2_3_x = f_u_4_4_a_z - Scalar(0.13725);
  const Scalar hc_3_y = hu_5_t_y + Scalar(1.9154);
  const Scalar t84 = Scalar(0.9) * c_3;
  const Scalar c_3_2_2 = hc_3_y * t84 - Scalar(0.9) * s_3 * df_2_3_x;
  c[44] = c_3_2_2;
  const Scalar t85 = t70 * (Scalar(0.01585) * t50 - t43 * t51);
  const Scalar t86 = Ic_5_yz * t53 + Ic_5_xy * t51 + t43 * t70 - Iu_5_t_d * t50;
  const Scalar t87 = Ic_5_xy * t50 - t13 * t53 + Iu_5_t_d * t51 + Scalar(0.01585) * t70;
  const Scalar c_5_1_1 = t53 * (t48 + t52) - t85 + t51 * t86 - t50 * t87;
  c[84] = c_5_1_1;
  const Scalar t88 = t74 * (Scalar(0.0035) * t54 + Scalar(0.0056) * t55);
  const Scalar t89 = Scalar(-0.0001273) * t55 - Scalar(0.000256) * t54 + Scalar(0.0004972) * t50 -
      Scalar(0.0035) * t74;
  const Scalar t90 = Scalar(0.0001273) * t54 + Scalar(0.000267) * t50 - Scalar(0.000256) * t55 +
      Scalar(0.0056) * t74;
  const Scalar c_6_1_1 = t88 - t54 * t89 + t55 * t90 + t50 * (t56 - t57);
  c[105] = c_6_1_1;
  const Scalar t91 = t65 * t24 + t21 * t41;
  const Scalar t92 = Scalar(0.0035) * t21 - t36;
  const Scalar t93 = Scalar(0.0056) * t21 - t38;
  const Scalar c_2_2_6 = t5 * t92 + t91 - t66 * t24 - t6 * t93;
  c[37] = c_2_2_6;
  c[17] = -t67 - t68;
  c[108] = -c_3_1_6;
  c[13] = t72 - t73;
  c[90] = -c_4_1_5;
  c[78] = -c_6_1_4;
  c[19] = -t82 - t81;
  c[115] = -c_5_1_6;
  const Scalar t94 = t30 - c_5 * t65 + s_5 * f_u_6_6_a_z * t21;
  const Scalar t95 = t27 + v_o_2_4_x * f_u_6_4_a_z;
  c[39] = t95 - t94;
  const Scalar c_6_2_4 = t95 + t94;
  c[112] = c_6_2_4;
  c[25] = c[26] = -c_3_2_2;
  c[10] = -c_5_1_1;
  c[15] = -c_6_1_1;
  c[107] = -c_2_2_6;
  const Scalar t96 = s_2 * (t28 - c_3 * mu_u_6_5_t_y + s_3 * t29);
  const Scalar t97 = c_2 * (s_3 * mu_u_6_5_t_y + c_3 * t29) - t96;
  const Scalar t98 = t54 * t92 + t50 * t66 + t55 * t93;
  const Scalar c_2_1_6 = t97 - t98;
  c[36] = c_2_1_6;
  const Scalar t99 = t91 + t40;
  const Scalar db_26_3 = s_5 * hu_6_t_y * t18 - t20 * t77;
  c[38] = db_26_3 + t99;
  const Scalar c_6_2_3 = db_26_3 - t99;
  c[109] = c_6_2_3;
  c[79] = -c_6_2_4;
  const Scalar t100 = c_5 * t34;
  const Scalar t101 = mu_u_5_5_a_y + Scalar(0.0161843);
  const Scalar Iu_4_t_d = t100 - Scalar(0.0044257) + t101;
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0004868);
  const Scalar t102 = Scalar(2.0) * Ic_4_xy;
  const Scalar t103 = c_4 * Iu_4_t_d - s_4 * t102;
  const Scalar t104 = s_4 * t103;
  const Scalar t105 = c_4 * t102 + s_4 * Iu_4_t_d;
  const Scalar db_33_4r = t104 + c_4 * t105;
  c[49] = c[50] = db_33_4r;
  const Scalar Ic_4_xz = Iu_6_t_xz + t35 - Scalar(0.00500195);
  const Scalar t106 = t59 - Scalar(0.0261804);
  const Scalar t107 = c_4 * Ic_4_xz + s_4 * t106;
  const Scalar t108 = t107 - f_u_4_4_a_z * v_o_2_4_x;
  c[30] = Scalar(-2.0) * t108;
  const Scalar t109 = Scalar(0.45) * f_u_4_4_a_z;
  const Scalar t110 = t107 + t109;
  c[51] = Scalar(-2.0) * t110;
  c[16] = -t97 - t98;
  c[106] = -c_2_1_6;
  const Scalar t111 = s_4 * dmu_4_5_y - c_4 * Ic_5_yz;
  const Scalar t112 = t111 + t43 * t10;
  const Scalar t113 = c_4 * t13 + s_4 * t34;
  const Scalar t114 = t113 + Scalar(0.0071325) * s_4;
  const Scalar t115 = t53 * t62 + t51 * t112 - t50 * t114;
  const Scalar t116 = c_4 * Iu_5_a_xz;
  const Scalar t117 = t116 + s_4 * mu_u_5_5_a_y;
  const Scalar t118 = hu_5_t_y * t10;
  const Scalar db_35_4 = t117 - t118;
  const Scalar t119 = t59 * w_1_3_x + t49 * db_35_4;
  const Scalar c_3_1_5 = t119 + t115;
  c[52] = c_3_1_5;
  c[58] = -c_6_2_3;
  const Scalar t120 = t116 + s_4 * (t100 - s_5 * dmu_4_5_y);
  const Scalar t121 = hu_5_t_y * t63;
  const Scalar t122 = t121 - t120;
  const Scalar db_25_4 = t117 + t121;
  c[34] = db_25_4 + t122;
  const Scalar c_5_2_4 = db_25_4 - t122;
  c[91] = c_5_2_4;
  const Scalar t123 = t120 + t118;
  c[55] = db_35_4 - t123;
  const Scalar c_5_3_4 = db_35_4 + t123;
  c[92] = c_5_3_4;
  const Scalar t124 = t105 - hc_4_y * t20;
  const Scalar t125 = t103 + t83 * t20;
  const Scalar t126 = c_4 * hc_4_y - s_4 * t83;
  const Scalar c_4_2_2 = t126 * t20 - c_4 * t124 - s_4 * t125;
  c[65] = c_4_2_2;
  c[67] = c[68] = -db_33_4r;
  const Scalar t127 = t111 - t43 * t63;
  const Scalar t128 = Scalar(0.01585) * t63 - t113;
  const Scalar t129 = c_4 * t58 - t63 * t45;
  const Scalar c_5_2_2 = t129 + s_4 * (c_5 * t127 - s_5 * t128) + c_4 * t61;
  c[86] = c_5_2_2;
  const Scalar t130 = c_4 * t106 - s_4 * Ic_4_xz;
  const Scalar t131 = t126 * t47;
  const Scalar t132 = t130 * w_1_3_x + t131;
  c[9] = Scalar(2.0) * t132;
  const Scalar t133 = s_2 * (t118 - c_3 * t59 + s_3 * db_35_4);
  const Scalar t134 = c_2 * (s_3 * t59 + c_3 * db_35_4) - t133;
  const Scalar t135 = t53 * t61 - t51 * t127 - t50 * t128;
  const Scalar c_2_1_5 = t134 - t135;
  c[31] = c_2_1_5;
  c[12] = t115 - t119;
  c[87] = -c_3_1_5;
  c[29] = db_33_4r - t126 * t84;
  c[74] = -c_5_2_4;
  c[75] = -c_5_3_4;
  c[28] = -c_4_2_2;
  c[32] = -c_5_2_2;
  const Scalar t136 = s_4 * (c_5 * t112 + s_5 * t114) - c_4 * t62;
  const Scalar c_5_3_3 = Scalar(0.45) * t44 + t136;
  c[89] = c_5_3_3;
  c[11] = -t134 - t135;
  c[85] = -c_2_1_5;
  c[54] = -c_5_3_3;
  const Scalar t137 = Ic_4_xy + t104 - Scalar(0.0080685);
  const Scalar t138 = Scalar(-0.45) * t126;
  const Scalar t139 = t130 - Scalar(0.0204192) - t138;
  const Scalar t140 = t137 * t49 + t139 * w_1_3_x;
  c[5] = Scalar(-2.0) * t140;
  const Scalar t141 = c_4 * t103;
  const Scalar t142 = t110 * t49;
  const Scalar t143 = w_1_3_x * (t141 - s_4 * t105) + t142;
  const Scalar Ic_4_zz = Iu_6_t_xx - t100 + Scalar(0.0285811);
  const Scalar t144 = Ic_4_zz * w_1_3_x - t142;
  const Scalar c_3_1_4 = t144 - t143;
  c[48] = c_3_1_4;
  const Scalar t145 = t129 + t136;
  const Scalar t146 = t44 * t18 - c_4 * hu_5_t_y * t20;
  c[33] = t146 - t145;
  const Scalar c_5_2_3 = t146 + t145;
  c[88] = c_5_2_3;
  const Scalar t147 = c_4 * (w_1_3_x * t105 - t106 * t49);
  const Scalar t148 = w_1_3_x * (s_4 * (Ic_4_xz * t49 + t103 * w_1_3_x) + t147);
  const Scalar c_4_1_1 = t148 - t49 * (t131 + t132);
  c[63] = c_4_1_1;
  const Scalar t149 = s_2 * (-c_3 * Ic_4_zz - s_3 * t110 + t109);
  const Scalar db_14_2 = c_2 * (c_3 * t110 - s_3 * Ic_4_zz) + t149;
  const Scalar t150 = w_1_3_x * (c_4 * t125 - s_4 * t124) + t49 * t108;
  c[7] = db_14_2 - t150;
  const Scalar c_4_1_2 = db_14_2 + t150;
  c[64] = c_4_1_2;
  c[8] = -t143 - t144;
  c[66] = -c_3_1_4;
  c[53] = -c_5_2_3;
  const Scalar t151 = Scalar(0.026176) + Scalar(2.0) * t110;
  const Scalar Iu_3_t_d = Scalar(0.9) * hu_5_t_y + t141 - t101 - Ic_4_zz + Scalar(0.96799115);
  const Scalar t152 = w_1_3_x * (df_2_3_x * t46 - t151 * w_1_3_x + Iu_3_t_d * t49);
  const Scalar t153 = t49 * (hc_3_y * t46 - t151 * t49 - Iu_3_t_d * w_1_3_x);
  const Scalar db_11_3r = t46 * (df_2_3_x * w_1_3_x - hc_3_y * t49) + t152 - t153;
  c[3] = db_11_3r;
  c[6] = -c_4_1_1;
  const Scalar t154 = c_3 * t137 + s_3 * t139;
  const Scalar t155 = c_3 * t139 - s_3 * t137;
  const Scalar t156 = c_2 * t154 + s_2 * t155;
  const Scalar c_3_1_2 = t140 - t156;
  c[43] = c_3_1_2;
  c[27] = -c_4_1_2;
  c[2] = Scalar(-2.0) * (s_2 * (Scalar(0.0222188) + t155) +
      c_2 * (t138 + t154 + Scalar(0.0549346)));
  c[42] = -db_11_3r;
  c[4] = -t140 - t156;
  c[24] = -c_3_1_2;
  const Scalar t157 = Scalar(-2.0) * (c_3 * Iu_3_t_d - s_3 * t151);
  const Scalar t158 = c_3 * df_2_3_x + s_3 * hc_3_y;
  const Scalar t159 = -Iu_3_t_d - c_3 * t157 + Scalar(0.9) * t158 - Scalar(4.2001111);
  const Scalar t160 = t151 + Scalar(0.0684948) - s_3 * t157 - c_3_2_2;
  const Scalar t161 = s_2 * (c_2 * t159 - s_2 * t160);
  const Scalar db_11_2r = t161 + c_2 * (c_2 * t160 + s_2 * t159);
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
template <class Scalar, class SinCos = LibrarySinCos>
inline void coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar Iu_6_t_g = Scalar(0.0001273) * c_6 - Scalar(0.000256) * s_6;
  const Scalar t1 = s_6 * Iu_6_t_g;
  const Scalar t2 = Scalar(0.0001273) * s_6 + Scalar(0.000256) * c_6;
  const Scalar db_55_6r = t1 + c_6 * t2;
  C[28] = qd_6 * db_55_6r;
  const Scalar t3 = c_6 * Iu_6_t_g;
  const Scalar Iu_6_t_xx = t3 - Scalar(0.0001273);
  const Scalar Iu_5_t_d = Iu_6_t_xx + Scalar(0.0044257);
  const Scalar Iu_6_t_xz = Scalar(0.000267) * c_6 + Scalar(0.0004972) * s_6;
  const Scalar Ic_5_xy = Scalar(2.0) * Iu_6_t_xz + Scalar(0.0010857);
  const Scalar t4 = c_5 * Iu_5_t_d - s_5 * Ic_5_xy;
  const Scalar t5 = s_5 * t4;
  const Scalar dmu_4_5_y = c_5 * Ic_5_xy + s_5 * Iu_5_t_d;
  const Scalar t6 = t5 + c_5 * dmu_4_5_y;
  const Scalar dmu_4_6_x = Scalar(0.0004972) * c_5 - s_5 * t2;
  const Scalar dmu_4_6_y = Scalar(0.000267) * c_5 + s_5 * Iu_6_t_g;
  const Scalar Iu_6_a_xy = Scalar(0.0004972) * c_6 - Scalar(0.000267) * s_6;
  const Scalar t7 = s_5 * (c_6 * dmu_4_6_x - s_6 * dmu_4_6_y + c_5 * Iu_6_a_xy);
  C[21] = qd_6 * t7 + qd_5 * t6;
  const Scalar w_1_3_x = c_2 * s_3 + s_2 * c_3;
  const Scalar t8 = c_4 * c_5;
  const Scalar t9 = c_2 * c_3 - s_2 * s_3;
  const Scalar t10 = w_1_3_x * t8 + s_5 * t9;
  const Scalar t11 = s_4 * w_1_3_x;
  const Scalar t12 = c_6 * t10 - s_6 * t11;
  const Scalar t13 = c_6 * t11 + s_6 * t10;
  const Scalar t14 = Scalar(0.45) * c_2;
  const Scalar t15 = Scalar(0.45) * w_1_3_x - t14;
  const Scalar t16 = s_4 * s_5;
  const Scalar t17 = t15 * t16;
  const Scalar hu_6_t_y = Scalar(0.0056) * c_6 - Scalar(0.0035) * s_6;
  const Scalar t18 = hu_6_t_y * t17;
  const Scalar t19 = c_4 * s_5;
  const Scalar t20 = c_5 * t9 - w_1_3_x * t19;
  const Scalar t21 = Iu_6_t_xz * t20;
  const Scalar t22 = Iu_6_t_g * t12 - t13 * t2 + t21 + t18;
  const Scalar t23 = Scalar(0.0006623) * t10 - t21 + t18;
  const Scalar t24 = t23 - t22;
  const Scalar t25 = Scalar(0.45) * s_3;
  const Scalar v_o_2_4_x = t25 - Scalar(0.45);
  const Scalar t26 = Scalar(0.45) * c_3;
  const Scalar t27 = c_5 * t26 - v_o_2_4_x * t19;
  const Scalar t28 = hu_6_t_y * t27;
  const Scalar mu_u_6_5_t_y = Scalar(0.0006623) * c_5 + s_5 * Iu_6_t_xz;
  const Scalar t29 = s_4 * mu_u_6_5_t_y;
  const Scalar db_26_5 = t29 - t28;
  const Scalar t30 = s_4 * c_5;
  const Scalar t31 = c_4 * s_6 + c_6 * t30;
  const Scalar t32 = c_4 * c_6 - s_6 * t30;
  const Scalar t33 = Iu_6_t_g * t31 + t32 * t2 - Iu_6_t_xz * t16;
  const Scalar t34 = t28 - t33;
  const Scalar c_6_2_5 = db_26_5 + t34;
  const Scalar t35 = Scalar(0.45) * hu_6_t_y * t19;
  const Scalar t36 = t35 - t33;
  const Scalar db_36_5 = t29 - t35;
  const Scalar c_6_3_5 = db_36_5 + t36;
  const Scalar t37 = c_5 * Iu_6_t_xz;
  const Scalar t38 = s_5 * (t3 - s_6 * t2) + t37;
  const Scalar t39 = Scalar(0.0006623) * s_5 - t37;
  const Scalar c_5_4_6 = t39 - t38;
  const Scalar C_65 = -qd_5 * db_55_6r - qd_4 * c_5_4_6 + qd_2 * c_6_2_5 + qd_3 * c_6_3_5 -
      qd_1 * t24;
  C[34] = C_65;
  const Scalar t40 = Scalar(2.0) * qd_6;
  C[29] = -Iu_6_t_xz * t40 - C_65;
  const Scalar t41 = c_4 * t39 - s_4 * Iu_6_a_xy;
  const Scalar f_u_6_6_a_z = Scalar(0.0035) * c_6 + Scalar(0.0056) * s_6;
  const Scalar f_u_6_4_a_z = c_4 * f_u_6_6_a_z + hu_6_t_y * t30;
  const Scalar t42 = Scalar(0.45) * f_u_6_4_a_z;
  const Scalar t43 = t41 - t42;
  const Scalar t44 = s_2 * (t42 - c_3 * mu_u_6_5_t_y + s_3 * t43);
  const Scalar t45 = c_2 * (s_3 * mu_u_6_5_t_y + c_3 * t43) - t44;
  const Scalar v_2_5_x = s_5 * t26 + v_o_2_4_x * t8;
  const Scalar t46 = s_4 * v_o_2_4_x;
  const Scalar t47 = c_6 * v_2_5_x - s_6 * t46;
  const Scalar t48 = Scalar(0.0035) * t47 + Scalar(0.0056) * (s_6 * v_2_5_x + c_6 * t46);
  const Scalar t49 = Scalar(0.000267) * t32 + Scalar(0.0004972) * t31;
  const Scalar t50 = t49 - t48;
  const Scalar t51 = Scalar(0.000256) * t31 - Scalar(0.0001273) * t32 + Scalar(0.0004972) * t16;
  const Scalar t52 = Scalar(0.0035) * t27 - t51;
  const Scalar t53 = Scalar(0.0001273) * t31 + Scalar(0.000256) * t32 - Scalar(0.000267) * t16;
  const Scalar t54 = Scalar(0.0056) * t27 - t53;
  const Scalar t55 = t12 * t52 + t20 * t50 + t13 * t54;
  const Scalar t56 = t45 - t55;
  const Scalar t57 = Scalar(0.0035) * t31 - Scalar(0.0056) * t32;
  const Scalar t58 = t15 * t57;
  const Scalar t59 = Scalar(0.0004972) * t12 - Scalar(0.000267) * t13 - t58;
  const Scalar t60 = t17 * (Scalar(0.0035) * t12 + Scalar(0.0056) * t13);
  const Scalar t61 = Scalar(-0.0001273) * t13 - Scalar(0.000256) * t12 + Scalar(0.0004972) * t20 -
      Scalar(0.0035) * t17;
  const Scalar t62 = Scalar(0.0001273) * t12 + Scalar(0.000267) * t20 - Scalar(0.000256) * t13 +
      Scalar(0.0056) * t17;
  const Scalar t63 = t60 - t12 * t61 + t13 * t62 + t20 * (t58 - t59);
  const Scalar t64 = qd_1 * t63;
  const Scalar t65 = w_1_3_x * mu_u_6_5_t_y + t9 * t43;
  const Scalar t66 = Scalar(0.001575) * t19 - t51;
  const Scalar t67 = Scalar(0.00252) * t19 - t53;
  const Scalar t68 = Scalar(0.45) * f_u_6_6_a_z;
  const Scalar t69 = Scalar(0.45) * s_4;
  const Scalar t70 = hu_6_t_y * t69 + t8 * t68;
  const Scalar t71 = t49 + t70;
  const Scalar t72 = t12 * t66 + t13 * t67 + t20 * t71;
  const Scalar c_3_1_6 = t65 - t72;
  const Scalar t73 = s_5 * (Iu_6_a_xy * t20 - f_u_6_6_a_z * t17);
  const Scalar t74 = t12 * dmu_4_6_x - t13 * dmu_4_6_y + t73 - c_5 * t58;
  const Scalar t75 = hu_6_t_y * t8 - s_4 * f_u_6_6_a_z;
  const Scalar t76 = w_1_3_x * (c_4 * Iu_6_a_xy + s_4 * t39) + t15 * t75;
  const Scalar t77 = t76 - t74;
  C[30] = t64 - qd_3 * c_3_1_6 + qd_4 * t77 - qd_5 * t24 - qd_2 * t56;
  const Scalar t78 = s_5 * Iu_6_a_xy;
  const Scalar t79 = t31 * dmu_4_6_x - t16 * t78 + t32 * dmu_4_6_y;
  const Scalar t80 = t79 - c_5 * t48 + s_5 * f_u_6_6_a_z * t27;
  const Scalar t81 = t41 + v_o_2_4_x * f_u_6_4_a_z;
  const Scalar t82 = t81 + t80;
  const Scalar t83 = t79 + s_5 * t19 * t68 + c_5 * t70;
  const Scalar t84 = t43 + t83;
  const Scalar t85 = qd_3 * t84 - qd_4 * t7 + qd_1 * t77 + qd_2 * t82;
  C[33] = t85 - qd_5 * c_5_4_6;
  const Scalar t86 = t45 + t55;
  const Scalar t87 = t65 + t72;
  const Scalar t88 = t76 + t74;
  const Scalar t89 = t23 + t22;
  const Scalar t90 = t64 + qd_3 * t87 - qd_4 * t88 + qd_5 * t89 + qd_2 * t86 - t59 * t40;
  C[5] = -t90;
  const Scalar t91 = t48 * t16 + t27 * t57;
  const Scalar t92 = t31 * t52 + t91 - t50 * t16 - t32 * t54;
  const Scalar t93 = qd_2 * t92 + qd_1 * t56;
  const Scalar t94 = t31 * t66 - t71 * t16 - t32 * t67;
  const Scalar t95 = t91 + t94;
  const Scalar db_26_3 = s_5 * hu_6_t_y * t25 - t26 * t75;
  const Scalar c_2_3_6 = db_26_3 + t95;
  const Scalar t96 = t81 - t80;
  const Scalar c_2_5_6 = db_26_5 - t34;
  C[11] = qd_5 * c_2_5_6 + t93 + qd_3 * c_2_3_6 + qd_4 * t96 - t50 * t40;
  const Scalar c_6_2_3 = db_26_3 - t95;
  const Scalar t97 = Scalar(0.45) * c_4;
  const Scalar t98 = t94 - s_5 * (s_4 * t70 - t97 * t57);
  const Scalar t99 = qd_1 * c_3_1_6 + qd_3 * t98 - qd_2 * c_6_2_3;
  const Scalar t100 = t43 - t83;
  const Scalar c_3_5_6 = db_36_5 - t36;
  C[17] = qd_4 * t100 + qd_5 * c_3_5_6 + t99 - t71 * t40;
  const Scalar t101 = t38 + t39;
  C[23] = t78 * t40 - qd_5 * t101 - t85;
  const Scalar t102 = t1 + Scalar(0.00050995);
  const Scalar Ic_5_yz = Iu_6_a_xy + Scalar(0.00080815);
  const Scalar Iu_5_a_xz = c_5 * t102 + s_5 * Ic_5_yz;
  const Scalar t103 = c_4 * Iu_5_a_xz;
  const Scalar mu_u_5_5_a_y = t3 - Scalar(0.0080301);
  const Scalar t104 = t103 + s_4 * mu_u_5_5_a_y;
  const Scalar t105 = f_u_6_6_a_z - Scalar(0.01015);
  const Scalar hu_5_t_y = Scalar(0.01585) * c_5 - s_5 * t105;
  const Scalar t106 = hu_5_t_y * t69;
  const Scalar db_35_4 = t104 - t106;
  const Scalar t107 = c_5 * Ic_5_yz - s_5 * t102;
  const Scalar t108 = s_2 * (t106 - c_3 * t107 + s_3 * db_35_4);
  const Scalar t109 = c_2 * (s_3 * t107 + c_3 * db_35_4) - t108;
  const Scalar t110 = s_4 * dmu_4_5_y - c_4 * Ic_5_yz;
  const Scalar t111 = t110 - t105 * t46;
  const Scalar t112 = c_4 * t102 + s_4 * t4;
  const Scalar t113 = Scalar(0.01585) * t46 - t112;
  const Scalar t114 = Scalar(0.01585) * t27 - t105 * v_2_5_x;
  const Scalar t115 = s_4 * t107;
  const Scalar t116 = t114 - t115;
  const Scalar t117 = t11 * t116 - t10 * t111 - t20 * t113;
  const Scalar t118 = t109 - t117;
  const Scalar t119 = t110 + t105 * t69;
  const Scalar t120 = t112 + Scalar(0.0071325) * s_4;
  const Scalar t121 = c_5 * t105 + Scalar(0.01585) * s_5;
  const Scalar t122 = t115 - t121 * t97;
  const Scalar t123 = t11 * t122 + t10 * t119 - t20 * t120;
  const Scalar t124 = t107 * w_1_3_x + t9 * db_35_4;
  const Scalar t125 = t124 + t123;
  const Scalar t126 = s_4 * t121;
  const Scalar t127 = t15 * t126;
  const Scalar t128 = t102 * t20 + Ic_5_yz * t10 + t127;
  const Scalar t129 = c_4 * t15;
  const Scalar t130 = t129 * (Scalar(0.01585) * t20 - t105 * t10);
  const Scalar t131 = Ic_5_yz * t11 + Ic_5_xy * t10 + t105 * t129 - Iu_5_t_d * t20;
  const Scalar t132 = Ic_5_xy * t20 - t102 * t11 + Iu_5_t_d * t10 + Scalar(0.01585) * t129;
  const Scalar t133 = t11 * (t127 + t128) - t130 + t10 * t131 - t20 * t132;
  const Scalar t134 = qd_1 * t133;
  const Scalar t135 = Iu_5_a_xz * t11;
  const Scalar t136 = hu_5_t_y * t129;
  const Scalar t137 = t4 * t10 - t135 + t20 * dmu_4_5_y + t136;
  const Scalar t138 = c_4 * mu_u_5_5_a_y * w_1_3_x - t135 - t136;
  const Scalar t139 = t138 + t137;
  C[24] = qd_6 * t24 + t134 - qd_2 * t118 - qd_3 * t125 - qd_4 * t139;
  const Scalar t140 = c_5 * t4;
  const Scalar t141 = t103 + s_4 * (t140 - s_5 * dmu_4_5_y);
  const Scalar t142 = t141 + t106;
  const Scalar c_5_3_4 = db_35_4 + t142;
  const Scalar t143 = hu_5_t_y * t46;
  const Scalar t144 = t143 - t141;
  const Scalar db_25_4 = t104 + t143;
  const Scalar c_5_2_4 = db_25_4 - t144;
  const Scalar t145 = qd_3 * c_5_3_4 - qd_4 * t6 - qd_1 * t139 + qd_2 * c_5_2_4;
  C[27] = qd_6 * c_5_4_6 + t145;
  C[31] = qd_5 * c_6_2_5 - t93 + qd_3 * c_6_2_3 + qd_4 * t82;
  C[32] = qd_4 * t84 + qd_5 * c_6_3_5 - t99;
  const Scalar t146 = t109 + t117;
  const Scalar t147 = t124 - t123;
  const Scalar t148 = t138 - t137;
  const Scalar t149 = Scalar(2.0) * qd_5;
  const Scalar t150 = qd_6 * t89 + t134 + qd_2 * t146 + qd_3 * t147 + qd_4 * t148 + t128 * t149;
  C[4] = -t150;
  const Scalar t151 = mu_u_5_5_a_y + Scalar(0.0161843);
  const Scalar Iu_4_t_d = t140 - Scalar(0.0044257) + t151;
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0004868);
  const Scalar t152 = Scalar(2.0) * Ic_4_xy;
  const Scalar t153 = c_4 * t152 + s_4 * Iu_4_t_d;
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.10725);
  const Scalar t154 = t153 - hc_4_y * t26;
  const Scalar t155 = c_4 * Iu_4_t_d - s_4 * t152;
  const Scalar t156 = t121 + Scalar(0.0582);
  const Scalar t157 = t155 + t156 * t26;
  const Scalar t158 = c_4 * hc_4_y - s_4 * t156;
  const Scalar c_4_2_2 = t158 * t26 - c_4 * t154 - s_4 * t157;
  const Scalar t159 = c_4 * t114 - t46 * t126;
  const Scalar t160 = t159 + s_4 * (c_5 * t111 - s_5 * t113) + c_4 * t116;
  const Scalar f_u_4_4_a_z = c_4 * t156 + s_4 * hc_4_y;
  const Scalar df_2_3_x = f_u_4_4_a_z - Scalar(0.13725);
  const Scalar hc_3_y = hu_5_t_y + Scalar(1.9154);
  const Scalar t161 = Scalar(0.9) * c_3;
  const Scalar t162 = hc_3_y * t161 - Scalar(0.9) * s_3 * df_2_3_x;
  const Scalar t163 = qd_3 * t162;
  C[7] = qd_6 * t92 - qd_5 * t160 - qd_4 * c_4_2_2 - t163;
  const Scalar t164 = s_4 * (c_5 * t119 + s_5 * t120) - c_4 * t122;
  const Scalar t165 = Scalar(0.45) * t121 + t164;
  const Scalar t166 = s_4 * t155;
  const Scalar t167 = t166 + c_4 * t153;
  const Scalar t168 = qd_4 * t167;
  C[14] = qd_6 * t98 - qd_5 * t165 + t168;
  C[22] = -qd_6 * t101 - Iu_5_a_xz * t149 - t145;
  const Scalar t169 = t159 + t164;
  const Scalar t170 = t121 * t25 - c_4 * hu_5_t_y * t26;
  const Scalar t171 = t170 - t169;
  const Scalar t172 = qd_1 * t118 - qd_2 * t160;
  const Scalar c_2_4_5 = db_25_4 + t144;
  C[10] = qd_6 * c_2_5_6 + qd_3 * t171 + qd_4 * c_2_4_5 + t172 - t116 * t149;
  const Scalar t173 = c_4 * t155;
  const Scalar Ic_4_xz = Iu_6_t_xz + t5 - Scalar(0.00500195);
  const Scalar t174 = t107 - Scalar(0.0261804);
  const Scalar t175 = c_4 * Ic_4_xz + s_4 * t174;
  const Scalar t176 = Scalar(0.45) * f_u_4_4_a_z;
  const Scalar t177 = t175 + t176;
  const Scalar t178 = t177 * t9;
  const Scalar t179 = w_1_3_x * (t173 - s_4 * t153) + t178;
  const Scalar Ic_4_zz = Iu_6_t_xx - t140 + Scalar(0.0285811);
  const Scalar t180 = Ic_4_zz * w_1_3_x - t178;
  const Scalar t181 = t180 - t179;
  const Scalar t182 = qd_3 * t167;
  const Scalar t183 = qd_2 * t167 + t182 + qd_1 * t181;
  const Scalar c_3_4_5 = db_35_4 - t142;
  const Scalar t184 = Scalar(2.0) * qd_4;
  C[15] = qd_6 * t100 + qd_5 * c_3_4_5 + t183 - t177 * t184;
  const Scalar t185 = t170 + t169;
  const Scalar t186 = qd_1 * t125 - qd_2 * t185 - qd_3 * t165;
  C[16] = qd_6 * c_3_5_6 + qd_4 * c_3_4_5 + t122 * t149 + t186;
  const Scalar t187 = c_4 * (w_1_3_x * t153 - t174 * t9);
  const Scalar t188 = w_1_3_x * (s_4 * (Ic_4_xz * t9 + t155 * w_1_3_x) + t187);
  const Scalar t189 = c_4 * t174 - s_4 * Ic_4_xz;
  const Scalar t190 = t158 * t15;
  const Scalar t191 = t189 * w_1_3_x + t190;
  const Scalar t192 = t188 - t9 * (t190 + t191);
  const Scalar t193 = qd_1 * t192;
  const Scalar t194 = s_2 * (-c_3 * Ic_4_zz - s_3 * t177 + t176);
  const Scalar db_14_2 = c_2 * (c_3 * t177 - s_3 * Ic_4_zz) + t194;
  const Scalar t195 = t175 - f_u_4_4_a_z * v_o_2_4_x;
  const Scalar t196 = w_1_3_x * (c_4 * t157 - s_4 * t154) + t9 * t195;
  const Scalar c_4_1_2 = db_14_2 + t196;
  C[18] = qd_5 * t139 - qd_6 * t77 + t193 + qd_2 * c_4_1_2 - qd_3 * t181;
  C[25] = qd_3 * t185 - qd_6 * c_6_2_5 + qd_4 * c_5_2_4 - t172;
  const Scalar t197 = Ic_4_xy + t166 - Scalar(0.0080685);
  const Scalar t198 = Scalar(-0.45) * t158;
  const Scalar t199 = t189 - Scalar(0.0204192) - t198;
  const Scalar t200 = c_3 * t197 + s_3 * t199;
  const Scalar t201 = c_3 * t199 - s_3 * t197;
  const Scalar t202 = c_2 * t200 + s_2 * t201;
  const Scalar t203 = t197 * t9 + t199 * w_1_3_x;
  const Scalar t204 = t203 + t202;
  const Scalar Iu_3_t_d = Scalar(0.9) * hu_5_t_y + t173 - t151 - Ic_4_zz + Scalar(0.96799115);
  const Scalar t205 = Scalar(0.026176) + Scalar(2.0) * t177;
  const Scalar t206 = w_1_3_x * (df_2_3_x * t14 - t205 * w_1_3_x + Iu_3_t_d * t9);
  const Scalar t207 = t9 * (hc_3_y * t14 - t205 * t9 - Iu_3_t_d * w_1_3_x);
  const Scalar t208 = t14 * (df_2_3_x * w_1_3_x - hc_3_y * t9) + t206 - t207;
  const Scalar t209 = qd_1 * t208;
  const Scalar t210 = t179 + t180;
  C[2] = -qd_6 * t87 - qd_5 * t147 - qd_2 * t204 - Scalar(2.0) * qd_3 * t203 - qd_4 * t210 + t209;
  const Scalar c_1_2_4 = db_14_2 - t196;
  const Scalar t211 = qd_5 * t148 - qd_6 * t88 + t193 - qd_2 * c_1_2_4 + qd_3 * t210 - t191 * t184;
  C[3] = -t211;
  const Scalar t212 = qd_2 * c_4_2_2 + qd_1 * c_4_1_2;
  C[19] = -qd_6 * t82 - qd_5 * c_5_2_4 - t182 + t212;
  C[20] = -qd_6 * t84 - qd_5 * c_5_3_4 - t183;
  C[26] = qd_4 * c_5_3_4 - qd_6 * c_6_3_5 - t186;
  const Scalar t213 = t167 - t158 * t161;
  const Scalar t214 = -qd_6 * t96 - qd_5 * c_2_4_5 + t212 - qd_3 * t213 + t195 * t184;
  C[9] = -t214;
  const Scalar t215 = t203 - t202;
  const Scalar t216 = -qd_6 * c_3_1_6 - qd_5 * t125 - qd_2 * t215 - qd_4 * t181 + t209;
  C[12] = -t216;
  const Scalar t217 = qd_1 * t215 + qd_2 * t162;
  C[13] = -qd_6 * c_6_2_3 - qd_5 * t185 + t168 + t217;
  C[8] = qd_6 * c_2_3_6 + qd_5 * t171 + qd_4 * t213 - t163 - t217;
  const Scalar t218 = Scalar(-2.0) * (c_3 * Iu_3_t_d - s_3 * t205);
  const Scalar t219 = c_3 * df_2_3_x + s_3 * hc_3_y;
  const Scalar t220 = -Iu_3_t_d - c_3 * t218 + Scalar(0.9) * t219 - Scalar(4.2001111);
  const Scalar t221 = t205 + Scalar(0.0684948) - s_3 * t218 - t162;
  const Scalar t222 = s_2 * (c_2 * t220 - s_2 * t221);
  const Scalar t223 = t222 + c_2 * (c_2 * t221 + s_2 * t220);
  C[0] = -qd_6 * t63 - qd_5 * t133 - qd_4 * t192 + qd_3 * t208 + qd_2 * t223;
  const Scalar t224 = qd_1 * t223;
  const Scalar t225 = qd_2 * (s_2 * (Scalar(0.0222188) + t201) +
      c_2 * (t198 + t200 + Scalar(0.0549346)));
  C[1] = -qd_6 * t86 - qd_5 * t146 - qd_3 * t204 + qd_4 * c_1_2_4 - Scalar(2.0) * t225 + t224;
  const Scalar t226 = -qd_6 * t56 - qd_5 * t118 + qd_3 * t215 + qd_4 * c_4_1_2 + t224;
  C[6] = -t226;
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
// Reads q[1..5], qd[0..5]. Operations: 227 mul, 197 add, 10 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = qd_2 * qd_2;
  const Scalar t3 = t1 * t1 + t2;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 - Scalar(0.45) * t3;
  const Scalar t4 = s_2 * qd_1;
  const Scalar t5 = t1 * t4;
  const Scalar ddp_o_3_y = Scalar(0.45) * t5 + Scalar(9.81) * c_2;
  const Scalar ddp_3_x = c_3 * ddp_o_3_x + s_3 * ddp_o_3_y;
  const Scalar t6 = qd_1 * (c_2 * c_3 - s_2 * s_3);
  const Scalar t7 = qd_1 * (s_2 * c_3 + c_2 * s_3);
  const Scalar t8 = t6 * t7;
  const Scalar ddp_o_4_x = Scalar(0.45) * t8 + ddp_3_x;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t9 = omega_3_z * t6;
  const Scalar t10 = qd_2 * t4;
  const Scalar t11 = Scalar(0.9) * t10 + Scalar(0.9) * t9;
  const Scalar t12 = c_4 * ddp_o_4_x - s_4 * t11;
  const Scalar t13 = c_3 * ddp_o_3_y - s_3 * ddp_o_3_x;
  const Scalar t14 = t7 * t7;
  const Scalar t15 = omega_3_z * omega_3_z;
  const Scalar t16 = t14 + t15;
  const Scalar t17 = t13 - Scalar(0.45) * t16;
  const Scalar t18 = c_5 * t12 + s_5 * t17;
  const Scalar ddp_5_a_z = c_4 * t11 + s_4 * ddp_o_4_x;
  const Scalar t19 = c_6 * t18 - s_6 * ddp_5_a_z;
  const Scalar t20 = c_6 * ddp_5_a_z + s_6 * t18;
  const Scalar omega_r_5_a_z = s_4 * t7 + c_4 * omega_3_z;
  const Scalar t21 = c_4 * t9 - qd_4 * omega_r_5_a_z;
  const Scalar t22 = c_4 * t7 - s_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 + t6;
  const Scalar omega_r_5_y = c_5 * omega_4_z - s_5 * t22;
  const Scalar t23 = omega_3_z * t7;
  const Scalar domega_5_x = c_5 * t21 - s_5 * t23 + qd_5 * omega_r_5_y;
  const Scalar omega_r_5_x = c_5 * t22 + s_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t24 = c_6 * omega_r_5_x - s_6 * omega_5_z;
  const Scalar t25 = s_4 * t9 + qd_4 * t22;
  const Scalar t26 = c_6 * t25 + s_6 * domega_5_x + qd_6 * t24;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t27 = t24 * omega_6_z;
  const Scalar t28 = c_6 * omega_5_z + s_6 * omega_r_5_x;
  const Scalar t29 = c_6 * domega_5_x - s_6 * t25 - qd_6 * t28;
  const Scalar t30 = t28 * omega_6_z;
  const Scalar t31 = t28 * t28;
  const Scalar t32 = omega_6_z * omega_6_z;
  const Scalar t33 = t31 + t32;
  const Scalar t34 = t24 * t24;
  const Scalar t35 = t34 + t32;
  const Scalar t36 = t24 * t28;
  const Scalar t37 = c_5 * t23 + s_5 * t21 + qd_5 * omega_r_5_x;
  const Scalar U_6_xy = t37 - t36;
  const Scalar t38 = t37 + t36;
  const Scalar t39 = Scalar(0.000535) * t38 - Scalar(0.000534) * (t29 + t30) +
      Scalar(0.000256) * (t33 - t35) + Scalar(0.0007896) * U_6_xy -
      Scalar(0.0009944) * (t26 - t27) + Scalar(0.0112) * t19 - Scalar(0.007) * t20;
  n[5] = -t39;
  const Scalar t40 = t26 + t27;
  const Scalar t41 = t29 - t30;
  const Scalar t42 = t31 + t34;
  const Scalar U_6_zz_xx = t33 - t42;
  const Scalar t43 = c_5 * t17 - s_5 * t12;
  const Scalar t44 = Scalar(0.000256) * t41 - Scalar(0.000535) * t40 + Scalar(0.0009944) * U_6_xy +
      Scalar(0.000534) * U_6_zz_xx + Scalar(0.007) * t43;
  const Scalar t45 = Scalar(-0.000256) * t40 - Scalar(0.000534) * t38 + Scalar(0.0007896) * t41 +
      Scalar(0.0009944) * (t35 - t42) + Scalar(0.0112) * t43;
  const Scalar t46 = omega_r_5_x * omega_5_z;
  const Scalar t47 = omega_r_5_y * omega_5_z;
  const Scalar t48 = omega_r_5_y * omega_r_5_y;
  const Scalar t49 = omega_5_z * omega_5_z;
  const Scalar t50 = t48 + t49;
  const Scalar t51 = omega_r_5_x * omega_r_5_x;
  const Scalar t52 = t51 + t49;
  const Scalar t53 = omega_r_5_x * omega_r_5_y;
  const Scalar t54 = t25 - t53;
  const Scalar t55 = t25 + t53;
  const Scalar t56 = Scalar(0.0007639) * (domega_5_x - t47) + Scalar(0.0016163) * (t37 - t46) -
      Scalar(0.0029421) * t55 + Scalar(0.0010857) * (t50 - t52) + c_6 * t44 + s_6 * t45 -
      Scalar(0.0203) * t43 - Scalar(0.0123285) * t54 + Scalar(0.0317) * t18;
  n[4] = -t56;
  const Scalar U_5_zx = t37 + t46;
  const Scalar U_5_zy = domega_5_x + t47;
  const Scalar t57 = t48 + t51;
  const Scalar U_5_zz_xx = t50 - t57;
  const Scalar t58 = Scalar(0.0007639) * U_5_zz_xx - Scalar(0.0016163) * t54 -
      Scalar(0.0010857) * U_5_zy + Scalar(0.0029421) * U_5_zx + Scalar(0.0203) * ddp_5_a_z + t39;
  const Scalar mu_5_x = Scalar(-0.0007639) * t55 - Scalar(0.0010857) * U_5_zx -
      Scalar(0.0016163) * (t52 - t57) - s_6 * t44 + c_6 * t45 + Scalar(0.0317) * ddp_5_a_z +
      Scalar(0.0123285) * U_5_zy;
  const Scalar t59 = t22 * omega_4_z;
  const Scalar t60 = omega_r_5_a_z * omega_4_z;
  const Scalar t61 = omega_r_5_a_z * omega_r_5_a_z;
  const Scalar t62 = omega_4_z * omega_4_z;
  const Scalar t63 = t61 + t62;
  const Scalar t64 = t22 * t22;
  const Scalar t65 = t62 + t64;
  const Scalar t66 = t22 * omega_r_5_a_z;
  const Scalar t67 = t66 - t23;
  const Scalar t68 = t66 + t23;
  const Scalar t69 = Scalar(0.0123968) * t68 - Scalar(0.0009736) * (t63 - t65) +
      Scalar(0.0110896) * (t21 + t60) + c_5 * t58 - Scalar(0.0316473) * t67 - s_5 * mu_5_x +
      Scalar(0.0523608) * (t25 - t59) + Scalar(0.2145) * t12 - Scalar(0.1164) * ddp_5_a_z;
  n[3] = -t69;
  const Scalar F_6_x = Scalar(0.007) * t33 + Scalar(0.0112) * U_6_xy;
  const Scalar F_6_y = Scalar(0.007) * t38 - Scalar(0.0112) * t35;
  const Scalar t70 = s_6 * F_6_y - c_6 * F_6_x + Scalar(0.0203) * t50 + Scalar(0.0317) * t54;
  const Scalar t71 = Scalar(0.0203) * t55 - Scalar(0.007) * t40 + Scalar(0.0112) * t41 -
      Scalar(0.0317) * t52;
  const Scalar f_4_x = -c_5 * t70 - s_5 * t71 + Scalar(0.1164) * t63 - Scalar(0.2145) * t67;
  const Scalar f_4_y = c_6 * F_6_y + s_6 * F_6_x - Scalar(0.0203) * U_5_zx -
      Scalar(0.0317) * U_5_zy + Scalar(0.1164) * t68 - Scalar(0.2145) * t65;
  const Scalar t72 = c_4 * f_4_x - s_4 * f_4_y;
  const Scalar t73 = t25 + t59;
  const Scalar t74 = t21 - t60;
  const Scalar t75 = t61 + t64;
  const Scalar t76 = Scalar(0.0009736) * t73 + Scalar(0.0110896) * t68 + s_5 * t58 + c_5 * mu_5_x +
      Scalar(0.0316473) * t74 - Scalar(0.0523608) * (t65 - t75) + Scalar(0.2145) * t17;
  const Scalar U_4_zz_xx = t63 - t75;
  const Scalar t77 = Scalar(-0.0009736) * t74 - Scalar(0.0123968) * t73 -
      Scalar(0.0110896) * U_4_zz_xx + t56 + Scalar(0.0523608) * t67 + Scalar(0.1164) * t17;
  const Scalar t78 = t6 * t6;
  const Scalar t79 = t78 + t15;
  const Scalar t80 = Scalar(0.026176) * (t79 - t16) + Scalar(0.45) * t72 + c_4 * t77 + s_4 * t76 -
      Scalar(0.2745) * t13 + Scalar(1.8912169) * t8 + Scalar(3.8308) * ddp_3_x;
  n[2] = -t80;
  const Scalar t81 = s_5 * t70 - c_5 * t71 - Scalar(0.2745) * t8 + Scalar(0.1164) * t73 -
      Scalar(0.2145) * t74 + Scalar(3.8308) * t16;
  const Scalar t82 = s_3 * (Scalar(0.2745) * t79 - t72 - Scalar(3.8308) * t8) + c_3 * t81;
  const Scalar t83 = t4 * t4 + t2;
  n[1] = Scalar(4.102542) * s_2 - Scalar(0.0684948) * (t3 - t83) - t80 - Scalar(0.45) * t82 +
      Scalar(8.4002222) * t5 + Scalar(194.232114) * c_2;
  const Scalar f_u_4_t_y = c_4 * f_4_y + s_4 * f_4_x;
  const Scalar t84 = Scalar(0.45) * f_u_4_t_y;
  const Scalar t85 = t78 + t14;
  const Scalar t86 = Scalar(0.016137) * t8 - Scalar(0.052352) * t23 +
      Scalar(0.0408384) * (t16 - t85) + c_4 * t76 - s_4 * t77 - t84 + Scalar(3.44772) * t10 +
      Scalar(3.9306688) * t9;
  const Scalar U_3_zz_xx = t79 - t85;
  const Scalar t87 = Scalar(0.0408384) * t8 + Scalar(0.052352) * t9 + Scalar(0.016137) * U_3_zz_xx -
      Scalar(0.24705) * t10 - Scalar(0.148235) * t23 - t69;
  const Scalar t88 = qd_1 * qd_1;
  const Scalar t89 = qd_2 * t1;
  const Scalar t90 = Scalar(0.0444376) * t5 - Scalar(0.1369896) * t89 +
      Scalar(0.1098692) * (t3 - t88) - t84 + Scalar(0.24705) * t23 - c_3 * t87 +
      Scalar(3.44772) * t9 - s_3 * t86 + Scalar(16.9546632) * t10;
  const Scalar t91 = Scalar(0.1098692) * t5 + Scalar(0.1369896) * t10 +
      Scalar(0.0444376) * (t83 - t88) - Scalar(0.1542188) * t89 + s_3 * t87 - c_3 * t86;
  n[0] = -s_2 * t91 - c_2 * t90;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   tau[6]  in   joint torques or forces, N m or N
//   qdd[6]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[1..5], qd[0..5], tau[0..5]. Operations: 427 mul, 370 add, 5 div, 10 sin/cos.
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
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = qd_2 * qd_2;
  const Scalar t3 = t1 * t1 + t2;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 - Scalar(0.45) * t3;
  const Scalar t4 = s_2 * qd_1;
  const Scalar t5 = t1 * t4;
  const Scalar ddp_o_3_y = Scalar(0.45) * t5 + Scalar(9.81) * c_2;
  const Scalar ddp_3_x = c_3 * ddp_o_3_x + s_3 * ddp_o_3_y;
  const Scalar t6 = qd_1 * (c_2 * c_3 - s_2 * s_3);
  const Scalar t7 = qd_1 * (s_2 * c_3 + c_2 * s_3);
  const Scalar t8 = t6 * t7;
  const Scalar ddp_o_4_x = Scalar(0.45) * t8 + ddp_3_x;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t9 = omega_3_z * t6;
  const Scalar t10 = qd_2 * t4;
  const Scalar t11 = Scalar(0.9) * t10 + Scalar(0.9) * t9;
  const Scalar t12 = c_4 * ddp_o_4_x - s_4 * t11;
  const Scalar t13 = c_3 * ddp_o_3_y - s_3 * ddp_o_3_x;
  const Scalar t14 = t7 * t7;
  const Scalar t15 = omega_3_z * omega_3_z;
  const Scalar t16 = t14 + t15;
  const Scalar t17 = t13 - Scalar(0.45) * t16;
  const Scalar t18 = c_5 * t12 + s_5 * t17;
  const Scalar ddp_5_a_z = c_4 * t11 + s_4 * ddp_o_4_x;
  const Scalar t19 = c_6 * t18 - s_6 * ddp_5_a_z;
  const Scalar t20 = c_6 * ddp_5_a_z + s_6 * t18;
  const Scalar omega_r_5_a_z = s_4 * t7 + c_4 * omega_3_z;
  const Scalar t21 = c_4 * t9 - qd_4 * omega_r_5_a_z;
  const Scalar t22 = c_4 * t7 - s_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 + t6;
  const Scalar omega_r_5_y = c_5 * omega_4_z - s_5 * t22;
  const Scalar t23 = omega_3_z * t7;
  const Scalar domega_5_x = c_5 * t21 - s_5 * t23 + qd_5 * omega_r_5_y;
  const Scalar omega_r_5_x = c_5 * t22 + s_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t24 = c_6 * omega_r_5_x - s_6 * omega_5_z;
  const Scalar t25 = s_4 * t9 + qd_4 * t22;
  const Scalar t26 = c_6 * t25 + s_6 * domega_5_x + qd_6 * t24;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t27 = t24 * omega_6_z;
  const Scalar t28 = c_6 * omega_5_z + s_6 * omega_r_5_x;
  const Scalar t29 = c_6 * domega_5_x - s_6 * t25 - qd_6 * t28;
  const Scalar t30 = t28 * omega_6_z;
  const Scalar t31 = t28 * t28;
  const Scalar t32 = omega_6_z * omega_6_z;
  const Scalar t33 = t31 + t32;
  const Scalar t34 = t24 * t24;
  const Scalar t35 = t34 + t32;
  const Scalar t36 = t24 * t28;
  const Scalar t37 = c_5 * t23 + s_5 * t21 + qd_5 * omega_r_5_x;
  const Scalar U_6_xy = t37 - t36;
  const Scalar t38 = t37 + t36;
  const Scalar t39 = Scalar(0.000535) * t38 - Scalar(0.000534) * (t29 + t30) +
      Scalar(0.000256) * (t33 - t35) + Scalar(0.0007896) * U_6_xy -
      Scalar(0.0009944) * (t26 - t27) + Scalar(0.0112) * t19 - Scalar(0.007) * t20;
  const Scalar y_6 = t39 + tau_6;
  const Scalar Iu_6_a_xy = Scalar(0.0009944) * c_6 - Scalar(0.000534) * s_6;
  const Scalar t40 = Scalar(754.9448890231013) * Iu_6_a_xy;
  const Scalar t41 = t26 + t27;
  const Scalar t42 = t29 - t30;
  const Scalar t43 = t31 + t34;
  const Scalar U_6_zz_xx = t33 - t43;
  const Scalar t44 = c_5 * t17 - s_5 * t12;
  const Scalar t45 = Scalar(0.000256) * t42 - Scalar(0.000535) * t41 + Scalar(0.0009944) * U_6_xy +
      Scalar(0.000534) * U_6_zz_xx + Scalar(0.007) * t44;
  const Scalar t46 = Scalar(-0.000256) * t41 - Scalar(0.000534) * t38 + Scalar(0.0007896) * t42 +
      Scalar(0.0009944) * (t35 - t43) + Scalar(0.0112) * t44;
  const Scalar t47 = omega_r_5_x * omega_5_z;
  const Scalar t48 = omega_r_5_y * omega_5_z;
  const Scalar t49 = omega_r_5_y * omega_r_5_y;
  const Scalar t50 = omega_5_z * omega_5_z;
  const Scalar t51 = t49 + t50;
  const Scalar t52 = omega_r_5_x * omega_r_5_x;
  const Scalar t53 = t52 + t50;
  const Scalar t54 = omega_r_5_x * omega_r_5_y;
  const Scalar t55 = t25 - t54;
  const Scalar t56 = t25 + t54;
  const Scalar t57 = Scalar(0.0007639) * (domega_5_x - t48) + Scalar(0.0016163) * (t37 - t47) -
      Scalar(0.0029421) * t56 + Scalar(0.0010857) * (t51 - t53) + c_6 * t45 + s_6 * t46 -
      Scalar(0.0203) * t44 - Scalar(0.0123285) * t55 + Scalar(0.0317) * t18;
  const Scalar y_6_5 = t57 - t40 * y_6 + tau_5;
  const Scalar Iu_6_t_g = Scalar(0.0002546) * c_6 - Scalar(0.000512) * s_6;
  const Scalar t58 = s_6 * Iu_6_t_g + Scalar(0.0010199);
  const Scalar Ic_5_yz = Iu_6_a_xy + Scalar(0.0016163);
  const Scalar t59 = c_5 * Ic_5_yz - s_5 * t58;
  const Scalar Iu_6_t_xz = Scalar(0.000534) * c_6 + Scalar(0.0009944) * s_6;
  const Scalar mu_u_6_5_t_y = Scalar(0.0013246) * c_5 + s_5 * Iu_6_t_xz;
  const Scalar t60 = t59 - mu_u_6_5_t_y * t40;
  const Scalar t61 = c_6 * Iu_6_t_g;
  const Scalar mu_u_5_5_a_y = t61 - Scalar(0.0160602);
  const Scalar t62 = Iu_6_a_xy * t40 + mu_u_5_5_a_y;
  const Scalar t63 = Scalar(1.0) / t62;
  const Scalar t64 = t60 * t63;
  const Scalar U_5_zx = t37 + t47;
  const Scalar U_5_zy = domega_5_x + t48;
  const Scalar t65 = t49 + t52;
  const Scalar U_5_zz_xx = t51 - t65;
  const Scalar t66 = Scalar(0.0007639) * U_5_zz_xx - Scalar(0.0016163) * t55 -
      Scalar(0.0010857) * U_5_zy + Scalar(0.0029421) * U_5_zx + Scalar(0.0203) * ddp_5_a_z + t39;
  const Scalar mu_5_x = Scalar(-0.0007639) * t56 - Scalar(0.0010857) * U_5_zx -
      Scalar(0.0016163) * (t53 - t65) - s_6 * t45 + c_6 * t46 + Scalar(0.0317) * ddp_5_a_z +
      Scalar(0.0123285) * U_5_zy;
  const Scalar t67 = t22 * omega_4_z;
  const Scalar t68 = omega_r_5_a_z * omega_4_z;
  const Scalar t69 = omega_r_5_a_z * omega_r_5_a_z;
  const Scalar t70 = omega_4_z * omega_4_z;
  const Scalar t71 = t69 + t70;
  const Scalar t72 = t22 * t22;
  const Scalar t73 = t70 + t72;
  const Scalar t74 = t22 * omega_r_5_a_z;
  const Scalar t75 = t74 - t23;
  const Scalar t76 = t74 + t23;
  const Scalar t77 = Scalar(0.0123968) * t76 - Scalar(0.0009736) * (t71 - t73) +
      Scalar(0.0110896) * (t21 + t68) + c_5 * t66 - Scalar(0.0316473) * t75 - s_5 * mu_5_x +
      Scalar(0.0523608) * (t25 - t67) + Scalar(0.2145) * t12 - Scalar(0.1164) * ddp_5_a_z;
  const Scalar t78 = Scalar(754.9448890231013) * mu_u_6_5_t_y;
  const Scalar y_5_4 = t64 * y_6_5 + t77 + tau_4 - t78 * y_6;
  const Scalar Ic_5_xx = t61 + Scalar(0.0128635);
  const Scalar Iu_5_t_d = Ic_5_xx - Scalar(0.0042667);
  const Scalar Ic_5_xy = Iu_6_t_xz + Scalar(0.0010857);
  const Scalar t79 = c_5 * Iu_5_t_d - Scalar(2.0) * s_5 * Ic_5_xy;
  const Scalar Ic_4_xz = Ic_5_xy + s_5 * t79 - Scalar(0.0110896);
  const Scalar f_u_6_6_a_z = Scalar(0.007) * c_6 + Scalar(0.0112) * s_6;
  const Scalar t80 = f_u_6_6_a_z - Scalar(0.0203);
  const Scalar t81 = c_5 * t80 + Scalar(0.0317) * s_5;
  const Scalar t82 = t81 + Scalar(0.1164);
  const Scalar hu_6_t_y = Scalar(0.0112) * c_6 - Scalar(0.007) * s_6;
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.2145);
  const Scalar t83 = Scalar(-0.45) * (c_4 * hc_4_y - s_4 * t82);
  const Scalar t84 = t59 - Scalar(0.0523608);
  const Scalar t85 = c_4 * t84 - s_4 * Ic_4_xz - t83;
  const Scalar hu_5_t_y = Scalar(0.0317) * c_5 - s_5 * t80;
  const Scalar t86 = Scalar(0.45) * hu_5_t_y;
  const Scalar t87 = mu_u_5_5_a_y - t86;
  const Scalar Iu_5_a_xz = c_5 * t58 + s_5 * Ic_5_yz;
  const Scalar t88 = s_4 * Iu_5_a_xz - c_4 * t87;
  const Scalar t89 = c_5 * hu_6_t_y;
  const Scalar t90 = c_4 * t89 - s_4 * f_u_6_6_a_z;
  const Scalar t91 = Scalar(0.0013246) * s_5 - c_5 * Iu_6_t_xz;
  const Scalar t92 = c_4 * Iu_6_a_xy + s_4 * t91 + Scalar(0.45) * t90;
  const Scalar t93 = t88 - t92 * t40;
  const Scalar t94 = t93 * t64 - t92 * t78 + t85;
  const Scalar t95 = c_5 * t79;
  const Scalar Ic_4_zz = Ic_5_xx - t95 + Scalar(0.0440441);
  const Scalar b_5_4_4 = t60 * t64 - mu_u_6_5_t_y * t78 + Ic_4_zz;
  const Scalar d_4 = Scalar(1.0) / b_5_4_4;
  const Scalar t96 = t94 * d_4;
  const Scalar F_6_x = Scalar(0.007) * t33 + Scalar(0.0112) * U_6_xy;
  const Scalar F_6_y = Scalar(0.007) * t38 - Scalar(0.0112) * t35;
  const Scalar t97 = s_6 * F_6_y - c_6 * F_6_x + Scalar(0.0203) * t51 + Scalar(0.0317) * t55;
  const Scalar t98 = Scalar(0.0203) * t56 - Scalar(0.007) * t41 + Scalar(0.0112) * t42 -
      Scalar(0.0317) * t53;
  const Scalar f_4_x = -c_5 * t97 - s_5 * t98 + Scalar(0.1164) * t71 - Scalar(0.2145) * t75;
  const Scalar f_4_y = c_6 * F_6_y + s_6 * F_6_x - Scalar(0.0203) * U_5_zx -
      Scalar(0.0317) * U_5_zy + Scalar(0.1164) * t76 - Scalar(0.2145) * t73;
  const Scalar t99 = c_4 * f_4_x - s_4 * f_4_y;
  const Scalar t100 = t25 + t67;
  const Scalar t101 = t21 - t68;
  const Scalar t102 = t69 + t72;
  const Scalar t103 = Scalar(0.0009736) * t100 + Scalar(0.0110896) * t76 + s_5 * t66 +
      c_5 * mu_5_x + Scalar(0.0316473) * t101 - Scalar(0.0523608) * (t73 - t102) +
      Scalar(0.2145) * t17;
  const Scalar U_4_zz_xx = t71 - t102;
  const Scalar t104 = Scalar(-0.0009736) * t101 - Scalar(0.0123968) * t100 -
      Scalar(0.0110896) * U_4_zz_xx + t57 + Scalar(0.0523608) * t75 + Scalar(0.1164) * t17;
  const Scalar t105 = t6 * t6;
  const Scalar t106 = t105 + t15;
  const Scalar t107 = Scalar(0.026176) * (t106 - t16) + Scalar(0.45) * t99 + c_4 * t104 +
      s_4 * t103 - Scalar(0.2745) * t13 + Scalar(1.8912169) * t8 + Scalar(3.8308) * ddp_3_x;
  const Scalar t108 = t93 * t63;
  const Scalar t109 = Scalar(-754.9448890231013) * t92;
  const Scalar y_4_3 = tau_3 + t108 * y_6_5 + t107 + t109 * y_6 - t96 * y_5_4;
  const Scalar t110 = t95 + Scalar(0.035914);
  const Scalar t111 = mu_u_5_5_a_y - Scalar(0.0123968);
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0009736);
  const Scalar t112 = c_4 * (t111 + t110) - Scalar(2.0) * s_4 * Ic_4_xy;
  const Scalar t113 = c_4 * t112;
  const Scalar t114 = Scalar(0.9) * hu_5_t_y;
  const Scalar t115 = t114 - t113 + t110 + Scalar(2.0394519);
  const Scalar b_4_3_3 = t92 * t109 + t93 * t108 - t94 * t96 + t115;
  const Scalar t116 = Scalar(1.0) / b_4_3_3;
  const Scalar t117 = t92 - Scalar(0.45) * (c_3 * s_5 * hu_6_t_y + s_3 * t90);
  const Scalar t118 = s_3 * c_4 * hu_5_t_y + c_3 * t81;
  const Scalar t119 = t88 - t117 * t40 - Scalar(0.45) * t118;
  const Scalar t120 = t119 * t64 - t117 * t78 + s_3 * t83 + t85;
  const Scalar f_u_4_4_a_z = c_4 * t82 + s_4 * hc_4_y;
  const Scalar t121 = f_u_4_4_a_z - Scalar(0.2745);
  const Scalar hc_3_y = hu_5_t_y + Scalar(3.8308);
  const Scalar t122 = c_3 * t121 + s_3 * hc_3_y;
  const Scalar t123 = t117 * t109 + t119 * t108 - t120 * t96 - Scalar(0.45) * t122 + t115;
  const Scalar t124 = t123 * t116;
  const Scalar t125 = s_5 * t97 - c_5 * t98 - Scalar(0.2745) * t8 + Scalar(0.1164) * t100 -
      Scalar(0.2145) * t101 + Scalar(3.8308) * t16;
  const Scalar t126 = s_3 * (Scalar(0.2745) * t106 - t99 - Scalar(3.8308) * t8) + c_3 * t125;
  const Scalar t127 = t120 * d_4;
  const Scalar t128 = t119 * t63;
  const Scalar t129 = Scalar(-754.9448890231013) * t117;
  const Scalar t130 = t4 * t4 + t2;
  const Scalar t131 = Scalar(4.102542) * s_2 - Scalar(0.0684948) * (t3 - t130) - tau_2 -
      t128 * y_6_5 - t107 - Scalar(0.45) * t126 + t127 * y_5_4 + Scalar(8.4002222) * t5 -
      t129 * y_6 + t124 * y_4_3 + Scalar(194.232114) * c_2;
  const Scalar t132 = Ic_4_xy + s_4 * t112 - Scalar(0.016137);
  const Scalar t133 = t85 - Scalar(0.0408384);
  const Scalar t134 = c_3 * t133 - s_3 * t132;
  const Scalar t135 = c_3 * t132 + s_3 * t133;
  const Scalar t136 = Scalar(0.45) * f_u_4_4_a_z;
  const Scalar t137 = c_4 * Ic_4_xz + s_4 * t84 + t136;
  const Scalar t138 = c_2 * (-c_3 * Ic_4_zz - s_3 * t137 + t136);
  const Scalar t139 = s_2 * (c_3 * t137 - s_3 * Ic_4_zz);
  const Scalar t140 = c_4 * Iu_5_a_xz + s_4 * t87;
  const Scalar t141 = c_2 * (s_4 * t86 - c_3 * t59 + s_3 * t140);
  const Scalar f_u_6_4_a_z = c_4 * f_u_6_6_a_z + s_4 * t89;
  const Scalar t142 = Scalar(0.45) * f_u_6_4_a_z;
  const Scalar t143 = c_4 * t91 - s_4 * Iu_6_a_xy - t142;
  const Scalar t144 = c_2 * (t142 - c_3 * mu_u_6_5_t_y + s_3 * t143);
  const Scalar t145 = s_2 * (s_3 * mu_u_6_5_t_y + c_3 * t143) + t144;
  const Scalar t146 = s_2 * (s_3 * t59 + c_3 * t140) - t145 * t40 + t141;
  const Scalar t147 = t146 * t64 - t145 * t78 - t139 + t138;
  const Scalar t148 = -t145 * t109 - t146 * t108 + c_2 * t134 - s_2 * t135 + t147 * t96;
  const Scalar t149 = s_2 * (t83 + t135 + Scalar(0.1098692));
  const Scalar b_3_2_1 = -t145 * t129 - t146 * t128 + c_2 * (Scalar(0.0444376) + t134) - t149 +
      t147 * t127 - t148 * t124;
  const Scalar t150 = Scalar(0.9) * t122;
  const Scalar b_3_2_2 = t117 * t129 + t119 * t128 - t120 * t127 + t115 - t150 - t123 * t124 +
      Scalar(8.554441);
  const Scalar t151 = Scalar(1.0) / b_3_2_2;
  const Scalar t152 = b_3_2_1 * t151;
  const Scalar f_u_4_t_y = c_4 * f_4_y + s_4 * f_4_x;
  const Scalar t153 = Scalar(0.45) * f_u_4_t_y;
  const Scalar t154 = t105 + t14;
  const Scalar t155 = Scalar(0.016137) * t8 - Scalar(0.052352) * t23 +
      Scalar(0.0408384) * (t16 - t154) + c_4 * t103 - s_4 * t104 - t153 + Scalar(3.44772) * t10 +
      Scalar(3.9306688) * t9;
  const Scalar U_3_zz_xx = t106 - t154;
  const Scalar t156 = Scalar(0.0408384) * t8 + Scalar(0.052352) * t9 +
      Scalar(0.016137) * U_3_zz_xx - Scalar(0.24705) * t10 - Scalar(0.148235) * t23 - t77;
  const Scalar t157 = qd_1 * qd_1;
  const Scalar t158 = qd_2 * t1;
  const Scalar t159 = Scalar(0.0444376) * t5 - Scalar(0.1369896) * t158 +
      Scalar(0.1098692) * (t3 - t157) - t153 + Scalar(0.24705) * t23 - c_3 * t156 +
      Scalar(3.44772) * t9 - s_3 * t155 + Scalar(16.9546632) * t10;
  const Scalar t160 = Scalar(0.1098692) * t5 + Scalar(0.1369896) * t10 +
      Scalar(0.0444376) * (t130 - t157) - Scalar(0.1542188) * t158 + s_3 * t156 - c_3 * t155;
  const Scalar t161 = t148 * t116;
  const Scalar t162 = t147 * d_4;
  const Scalar t163 = t146 * t63;
  const Scalar t164 = Scalar(754.9448890231013) * t145;
  const Scalar y_2_1 = t152 * t131 - t161 * y_4_3 + tau_1 - t163 * y_6_5 + s_2 * t160 + t164 * y_6 +
      t162 * y_5_4 + c_2 * t159;
  const Scalar t165 = t111 - t113 - t114 - Scalar(1.9653344);
  const Scalar Ic_3_yy = Ic_4_zz + Scalar(0.0741175);
  const Scalar t166 = Scalar(0.026176) + t137;
  const Scalar t167 = Scalar(2.0) * s_3 * t166 + c_3 * (Ic_3_yy + t165);
  const Scalar t168 = c_3 * t167;
  const Scalar Ic_2_xx = Ic_3_yy + Scalar(0.0771094) - t168;
  const Scalar t169 = c_3 * hc_3_y - s_3 * t121;
  const Scalar t170 = s_2 * (t166 + Scalar(0.0684948) - s_3 * t167 - Scalar(0.45) * t169);
  const Scalar t171 = c_2 * (Ic_2_xx - t168 + t165 + t150 - Scalar(8.4773316)) - Scalar(2.0) * t170;
  const Scalar b_2_1_1 = t146 * t163 - t145 * t164 - t148 * t161 - b_3_2_1 * t152 - t147 * t162 +
      Ic_2_xx + Scalar(0.8059476) - c_2 * t171;
  const Scalar d_1 = Scalar(1.0) / b_2_1_1;
  const Scalar qdd_1 = d_1 * y_2_1;
  qdd[0] = qdd_1;
  const Scalar t172 = t151 * (b_3_2_1 * qdd_1 + t131);
  qdd[1] = -t172;
  const Scalar qdd_3 = t116 * (y_4_3 - t148 * qdd_1 + t123 * t172);
  qdd[2] = qdd_3;
  const Scalar qdd_4 = d_4 * (t120 * t172 + t147 * qdd_1 - t94 * qdd_3 + y_5_4);
  qdd[3] = qdd_4;
  const Scalar t173 = t146 * qdd_1 - t60 * qdd_4 - t93 * qdd_3 + t119 * t172 + y_6_5;
  const Scalar t174 = t63 * t173;
  qdd[4] = -t174;
  const Scalar t175 = -t92 * qdd_3 - mu_u_6_5_t_y * qdd_4 + Iu_6_a_xy * t174 + y_6;
  qdd[5] = Scalar(754.9448890231013) * (t117 * t172 + t145 * qdd_1) +
      Scalar(754.9448890231013) * t175;
  bool positive = b_2_1_1 > Scalar(0.0);
  positive &= b_3_2_2 > Scalar(0.0);
  positive &= b_4_3_3 > Scalar(0.0);
  positive &= b_5_4_4 > Scalar(0.0);
  positive &= -t62 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[6]   in  joint positions, rad or m
//   qd[6]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1..5], qd[0..5]. Operations: 111 mul, 76 add, 10 sin/cos.
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
  const Scalar v_r_4_a_y = Scalar(0.45) * t1 - Scalar(0.45) * omega_r_3_x;
  const Scalar t3 = s_3 * qd_2;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t4 = Scalar(0.45) * omega_3_z - Scalar(0.45) * t3;
  const Scalar v_r_4_x = s_4 * v_r_4_a_y - c_4 * t4;
  const Scalar t5 = c_3 * qd_2;
  const Scalar t6 = Scalar(0.45) * t5;
  const Scalar v_r_5_x = s_5 * t6 + c_5 * v_r_4_x;
  const Scalar v_r_4_y = c_4 * v_r_4_a_y + s_4 * t4;
  const Scalar v_r_6_x = c_6 * v_r_5_x + s_6 * v_r_4_y;
  const Scalar t7 = s_6 * v_r_5_x - c_6 * v_r_4_y;
  const Scalar t8 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar t9 = s_3 * t2 - c_3 * t1;
  const Scalar t10 = t9 - qd_4;
  const Scalar t11 = s_5 * t10 + c_5 * t8;
  const Scalar omega_r_5_a_z = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar omega_5_z = omega_r_5_a_z + qd_5;
  const Scalar t12 = s_6 * omega_5_z + c_6 * t11;
  const Scalar t13 = s_6 * t11 - c_6 * omega_5_z;
  const Scalar omega_r_5_y = s_5 * t8 - c_5 * t10;
  const Scalar omega_6_z = omega_r_5_y + qd_6;
  const Scalar t14 = Scalar(0.000534) * t12 + Scalar(0.0009944) * t13 -
      Scalar(0.0013246) * omega_6_z - Scalar(0.014) * t7 + Scalar(0.0224) * v_r_6_x;
  const Scalar t15 = s_5 * v_r_4_x - c_5 * t6;
  const Scalar t16 = t13 * (Scalar(0.000256) * t12 + Scalar(0.0009944) * omega_6_z +
      Scalar(0.014) * t15);
  const Scalar t17 = Scalar(0.0002546) * t12 - Scalar(0.000256) * t13 -
      Scalar(0.000534) * omega_6_z + Scalar(0.0224) * t15;
  const Scalar t18 = Scalar(0.0007639) * t11 + Scalar(0.0016163) * omega_r_5_y -
      Scalar(0.0406) * t15 - Scalar(0.0634) * v_r_5_x + Scalar(0.0158056) * omega_5_z;
  const Scalar L_5_y = Scalar(0.0016163) * omega_5_z - Scalar(0.0010857) * t11 +
      Scalar(0.0406) * v_r_4_y;
  const Scalar t19 = Scalar(0.0007639) * omega_5_z - Scalar(0.0010857) * omega_r_5_y +
      Scalar(0.0099214) * t11 + Scalar(0.0634) * v_r_4_y;
  const Scalar t20 = Scalar(0.0110896) * t8 - Scalar(0.0523608) * omega_r_5_a_z -
      Scalar(0.0469862) * t10 - Scalar(0.2328) * v_r_4_y - Scalar(0.429) * v_r_4_x;
  const Scalar L_4_y = Scalar(0.0009736) * t8 + Scalar(0.10476) * t5 - Scalar(0.0523608) * t10;
  const Scalar L_4_x = Scalar(0.0009736) * omega_r_5_a_z + Scalar(0.0110896) * t10 -
      Scalar(0.0221926) * t8 + Scalar(0.19305) * t5;
  const Scalar L_3_z = Scalar(0.016137) * omega_r_3_x + Scalar(0.0408384) * t9 +
      Scalar(0.24705) * t5 - Scalar(3.44772) * t3 + Scalar(2.0518487) * omega_3_z;
  const Scalar L_3_y = Scalar(0.026176) * omega_r_3_x - Scalar(0.0408384) * omega_3_z +
      Scalar(0.24705) * t1;
  const Scalar t21 = Scalar(0.026176) * t9 - Scalar(0.016137) * omega_3_z -
      Scalar(1.9036137) * omega_r_3_x + Scalar(3.44772) * t1;
  const Scalar L_2_y = Scalar(0.0444376) * qd_2 + Scalar(0.0684948) * t2;
  const Scalar t22 = t2 * (Scalar(0.1098692) * qd_2 - Scalar(0.0684948) * t1 +
      Scalar(8.4002222) * t2);
  const Scalar L_2_z = Scalar(0.0444376) * t1 - Scalar(0.1098692) * t2 + Scalar(8.554441) * qd_2;
  const Scalar t23 = t16 - t12 * t17 + omega_6_z * t14 - omega_r_5_y * L_5_y - t11 * t19 -
      t1 * L_2_y - omega_5_z * t18 + omega_r_5_a_z * L_4_y + t8 * L_4_x + t9 * L_3_y + t10 * t20 +
      omega_r_3_x * t21 - omega_3_z * L_3_z + t22 - qd_2 * L_2_z - Scalar(9.3573967) * qd_1 * qd_1;
  return Scalar(-0.5) * t23;
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
// Reads q[0..5], qd[0..5]. Operations: 116 mul, 58 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5];
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
  const Scalar omega_r_5_a_z = s_4 * t4 + c_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t8 = qd_6 * (s_6 * omega_5_z - c_6 * omega_r_5_x);
  const Scalar omega_r_5_y = s_5 * t5 + c_5 * omega_4_z;
  const Scalar t9 = omega_3_z * t7;
  const Scalar t10 = c_4 * t9 + qd_4 * omega_r_5_a_z;
  const Scalar t11 = omega_3_z * t4;
  const Scalar domega_5_x = qd_5 * omega_r_5_y - s_5 * t11 - c_5 * t10;
  const Scalar t12 = s_4 * t9 + qd_4 * t5;
  const Scalar t13 = t8 - s_6 * domega_5_x + c_6 * t12;
  const Scalar t14 = qd_6 * (s_6 * omega_r_5_x + c_6 * omega_5_z);
  const Scalar t15 = t14 - s_6 * t12 - c_6 * domega_5_x;
  const Scalar t16 = s_6 * t13 + c_6 * t15;
  const Scalar t17 = c_5 * t11 + qd_5 * omega_r_5_x - s_5 * t10;
  const Scalar domega_e_5_t_x = s_5 * t17 - c_5 * t16;
  const Scalar domega_e_6_a_z = s_6 * t15 - c_6 * t13;
  const Scalar domega_e_4_t_x = s_4 * domega_e_6_a_z + c_4 * domega_e_5_t_x;
  const Scalar t18 = s_5 * t16 + c_5 * t17;
  const Scalar domega_e_3_t_x = s_3 * t18 + c_3 * domega_e_4_t_x;
  const Scalar t19 = s_3 * domega_e_4_t_x - c_3 * t18;
  a[5] = s_2 * domega_e_3_t_x + c_2 * t19;
  const Scalar t20 = Scalar(0.45) * qd_1;
  const Scalar t21 = qd_1 * (t3 * t6 - s_2 * t1) * t20;
  const Scalar t22 = c_2 * qd_1;
  const Scalar t23 = t22 * t22 + qd_2 * qd_2;
  const Scalar t24 = Scalar(0.45) * c_3 * t23 + t21;
  const Scalar t25 = Scalar(0.9) * s_2 * qd_1 * qd_2 - Scalar(0.9) * t9;
  const Scalar t26 = c_4 * t24 + s_4 * t25;
  const Scalar t27 = t4 * t4 - s_3 * t23 + omega_3_z * omega_3_z;
  const Scalar t28 = Scalar(0.45) * t27 - t22 * t2 * t20;
  const Scalar t29 = s_5 * t28 + c_5 * t26;
  const Scalar t30 = s_4 * t24 - c_4 * t25;
  const Scalar t31 = s_6 * t29 + c_6 * t30;
  const Scalar t32 = s_6 * t30 - c_6 * t29;
  const Scalar t33 = s_6 * t31 - c_6 * t32;
  const Scalar t34 = s_5 * t26 - c_5 * t28;
  const Scalar t35 = s_5 * t34 + c_5 * t33;
  const Scalar t36 = s_6 * t32 + c_6 * t31;
  const Scalar t37 = s_4 * t36 + c_4 * t35;
  const Scalar t38 = s_5 * t33 - c_5 * t34;
  const Scalar t39 = s_3 * t38 - c_3 * t37;
  const Scalar t40 = s_3 * t37 + c_3 * t38;
  a[2] = s_2 * t39 - c_2 * t40;
  const Scalar t41 = s_2 * t40 + c_2 * t39;
  const Scalar t42 = s_4 * t35 - c_4 * t36;
  a[0] = s_1 * t42 + c_1 * t41;
  a[1] = s_1 * t41 - c_1 * t42;
  const Scalar t43 = s_2 * t19 - c_2 * domega_e_3_t_x;
  const Scalar t44 = s_4 * domega_e_5_t_x - c_4 * domega_e_6_a_z;
  a[3] = -s_1 * t44 - c_1 * t43;
  a[4] = c_1 * t44 - s_1 * t43;
}

}  // namespace rx90

#endif  // FLATDYN_RX90_HPP

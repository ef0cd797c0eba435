// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "panda" as flat code: 7 joints.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Input: sha1:e40066afdeac3df565bacb6b4983a1f390ea1232
//
//   index  joint         moves link   type      unit  lower    upper    speed  acceleration  effort
//   0      panda_joint1  panda_link1  revolute  rad   -2.8973  2.8973   2.175  15            87
//   1      panda_joint2  panda_link2  revolute  rad   -1.7628  1.7628   2.175  7.5           87
//   2      panda_joint3  panda_link3  revolute  rad   -2.8973  2.8973   2.175  10            87
//   3      panda_joint4  panda_link4  revolute  rad   -3.0718  -0.0698  2.175  12.5          87
//   4      panda_joint5  panda_link5  revolute  rad   -2.8973  2.8973   2.61   15            12
//   5      panda_joint6  panda_link6  revolute  rad   -0.0175  3.7525   2.61   20            12
//   6      panda_joint7  panda_link7  revolute  rad   -2.8973  2.8973   2.61   20            12
//
// Gravity is (0, 0, -9.81) m/s^2 in the base frame. The tip belongs to link "panda_hand_tcp". Links
// without a joint of their own, part of those that carry them: panda_hand, panda_leftfinger,
// panda_rightfinger, panda_hand_tcp.
//
// Every function is a template over its scalar: float, double, or any type that is made from a
// double, has + - * / (also - of one), comparisons, and sin, cos where argument-dependent lookup
// finds them (or an argument that knows them, see LibrarySinCos). Arguments are plain arrays:
//
//   double q[7] = {}, qd[7] = {}, qdd[7] = {}, tau[7];
//   panda::inverse_dynamics(q, qd, qdd, tau);
//
// Entries come in the order of the table. Units are SI; "rad or m" goes by the type of the joint.
// Every entry of an output is written, zeros too. All inputs are read before anything is written:
// an output may overlap an input, but outputs must not overlap each other. Nothing allocates,
// throws, or keeps state. In the code, names count from 1 as in the textbook: q_1 is q[0], s_1 its
// sine, c_1 its cosine. Of link i: omega_i and domega_i are its angular velocity and acceleration,
// ddp_i the acceleration of its frame's origin less gravity, f_i and mu_i the force and moment that
// it gets from the link before, hc_i and hu_i the first moment of all that its joint carries (in
// gravity() times the size of gravity); t1, t2, ... are parts of sums.

#ifndef FLATDYN_PANDA_HPP
#define FLATDYN_PANDA_HPP

#include <cmath>

namespace panda {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 7;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {
    "panda_joint1", "panda_joint2", "panda_joint3", "panda_joint4", "panda_joint5", "panda_joint6",
    "panda_joint7"};

// Smallest position, rad or m.
inline constexpr Real position_lower[joint_count] = {
    Real(-2.8973), Real(-1.7628), Real(-2.8973), Real(-3.0718), Real(-2.8973), Real(-0.0175),
    Real(-2.8973)};

// Largest position, rad or m.
inline constexpr Real position_upper[joint_count] = {
    Real(2.8973), Real(1.7628), Real(2.8973), Real(-0.0698), Real(2.8973), Real(3.7525),
    Real(2.8973)};

// Largest speed, rad/s or m/s.
inline constexpr Real velocity_limit[joint_count] = {
    Real(2.175), Real(2.175), Real(2.175), Real(2.175), Real(2.61), Real(2.61), Real(2.61)};

// Largest acceleration, rad/s^2 or m/s^2.
inline constexpr Real acceleration_limit[joint_count] = {
    Real(15.0), Real(7.5), Real(10.0), Real(12.5), Real(15.0), Real(20.0), Real(20.0)};

// Largest torque or force, N m or N.
inline constexpr Real effort_limit[joint_count] = {
    Real(87.0), Real(87.0), Real(87.0), Real(87.0), Real(12.0), Real(12.0), Real(12.0)};

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
//   q[7]    in   joint positions, rad or m
//   qd[7]   in   joint velocities, rad/s or m/s
//   qdd[7]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[7]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..6], qd[0..6], qdd[0..6]. Operations: 308 mul, 290 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5], qdd_7 = qdd[6];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5],
      s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = qd_2 * t1;
  const Scalar t3 = s_2 * qdd_1;
  const Scalar t4 = t2 + t3;
  const Scalar t5 = t2 + t4;
  const Scalar t6 = Scalar(0.316) * t5;
  const Scalar t7 = s_2 * qd_1;
  const Scalar t8 = t1 * t7;
  const Scalar t9 = qdd_2 - t8;
  const Scalar t10 = Scalar(9.81) * s_2 - Scalar(0.316) * t9;
  const Scalar t11 = s_3 * t6 - c_3 * t10;
  const Scalar omega_r_3_y = s_3 * t7 + c_3 * qd_2;
  const Scalar t12 = omega_r_3_y * omega_r_3_y;
  const Scalar omega_3_z = qd_3 + t1;
  const Scalar t13 = omega_3_z * omega_3_z;
  const Scalar t14 = t12 + t13;
  const Scalar t15 = t11 - Scalar(0.0825) * t14;
  const Scalar t16 = s_3 * qd_2 - c_3 * t7;
  const Scalar t17 = qd_3 * t16 - s_3 * t4 - c_3 * qdd_2;
  const Scalar t18 = t16 * omega_3_z;
  const Scalar t19 = t17 + t18;
  const Scalar t20 = t7 * t7;
  const Scalar t21 = qd_2 * qd_2;
  const Scalar t22 = t20 + t21;
  const Scalar ddp_3_a_z = Scalar(9.81) * c_2 - Scalar(0.316) * t22;
  const Scalar ddp_o_4_z = Scalar(0.0825) * t19 + ddp_3_a_z;
  const Scalar t23 = s_4 * ddp_o_4_z + c_4 * t15;
  const Scalar t24 = s_4 * t16 - c_4 * omega_3_z;
  const Scalar t25 = t24 * t24;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar t26 = omega_4_z * omega_4_z;
  const Scalar t27 = t26 + t25;
  const Scalar domega_4_z = qdd_4 + t17;
  const Scalar t28 = c_4 * t16 + s_4 * omega_3_z;
  const Scalar t29 = t28 * t24;
  const Scalar t30 = domega_4_z + t29;
  const Scalar t31 = Scalar(0.0825) * t27 + t23 - Scalar(0.384) * t30;
  const Scalar ddp_3_y = c_3 * t6 + s_3 * t10;
  const Scalar t32 = qd_2 * t7;
  const Scalar t33 = c_2 * qdd_1;
  const Scalar t34 = t32 - t33;
  const Scalar domega_3_z = qdd_3 - t34;
  const Scalar t35 = t16 * omega_r_3_y;
  const Scalar U_3_yx = t35 + domega_3_z;
  const Scalar ddp_o_4_y = Scalar(0.0825) * U_3_yx + ddp_3_y;
  const Scalar t36 = qd_3 * omega_r_3_y + s_3 * qdd_2 - c_3 * t4;
  const Scalar t37 = qd_4 * t28 + s_4 * t36 - c_4 * domega_3_z;
  const Scalar t38 = t28 * omega_4_z;
  const Scalar t39 = t37 + t38;
  const Scalar t40 = qd_4 * t24 - s_4 * domega_3_z - c_4 * t36;
  const Scalar t41 = t24 * omega_4_z;
  const Scalar t42 = t40 + t41;
  const Scalar ddp_5_a_y = Scalar(0.0825) * t39 + ddp_o_4_y + Scalar(0.384) * t42;
  const Scalar t43 = s_5 * ddp_5_a_y + c_5 * t31;
  const Scalar t44 = s_4 * t15 - c_4 * ddp_o_4_z;
  const Scalar U_4_yx = domega_4_z - t29;
  const Scalar t45 = t28 * t28;
  const Scalar t46 = t26 + t45;
  const Scalar t47 = Scalar(0.0825) * U_4_yx + t44 + Scalar(0.384) * t46;
  const Scalar t48 = s_6 * t47 - c_6 * t43;
  const Scalar t49 = s_5 * omega_4_z - c_5 * t28;
  const Scalar omega_5_z = qd_5 - t24;
  const Scalar omega_r_6_y = s_6 * t49 + c_6 * omega_5_z;
  const Scalar t50 = omega_r_6_y * omega_r_6_y;
  const Scalar omega_r_6_a_z = s_5 * t28 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t51 = omega_6_z * omega_6_z;
  const Scalar t52 = t50 + t51;
  const Scalar t53 = Scalar(0.088) * t52 + t48;
  const Scalar t54 = s_5 * t31 - c_5 * ddp_5_a_y;
  const Scalar t55 = s_6 * omega_5_z - c_6 * t49;
  const Scalar t56 = qd_5 * omega_r_6_a_z + s_5 * domega_4_z + c_5 * t40;
  const Scalar domega_5_z = qdd_5 - t37;
  const Scalar t57 = qd_6 * t55 - s_6 * t56 - c_6 * domega_5_z;
  const Scalar t58 = t55 * omega_6_z;
  const Scalar t59 = t57 + t58;
  const Scalar t60 = Scalar(0.088) * t59 + t54;
  const Scalar t61 = s_7 * t60 - c_7 * t53;
  const Scalar t62 = s_7 * t53 + c_7 * t60;
  const Scalar t63 = s_7 * omega_6_z + c_7 * t55;
  const Scalar t64 = qd_6 * omega_r_6_y + s_6 * domega_5_z - c_6 * t56;
  const Scalar t65 = qd_5 * t49 + s_5 * t40 - c_5 * domega_4_z;
  const Scalar domega_6_z = qdd_6 - t65;
  const Scalar t66 = qd_7 * t63 + s_7 * t64 - c_7 * domega_6_z;
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar t67 = t63 * omega_7_z;
  const Scalar t68 = s_7 * t55 - c_7 * omega_6_z;
  const Scalar t69 = qd_7 * t68 - s_7 * domega_6_z - c_7 * t64;
  const Scalar t70 = t68 * omega_7_z;
  const Scalar U_7_yz = t69 - t70;
  const Scalar t71 = t68 * t68;
  const Scalar t72 = omega_7_z * omega_7_z;
  const Scalar t73 = t72 + t71;
  const Scalar t74 = t63 * t63;
  const Scalar t75 = t72 + t74;
  const Scalar domega_7_z = qdd_7 + t57;
  const Scalar t76 = t63 * t68;
  const Scalar t77 = domega_7_z + t76;
  const Scalar U_7_yx = domega_7_z - t76;
  const Scalar t78 = Scalar(0.002034439958661797) * t61 - Scalar(0.002573605371338203) * t62 +
      Scalar(0.000391391281684248) * (t73 - t75) - Scalar(0.0012555365982728983) * (t66 - t67) -
      Scalar(0.0009653051699191118) * U_7_yz - Scalar(0.002131604094419858) * U_7_yx -
      Scalar(0.004552547872941088) * t77;
  tau[6] = -t78;
  const Scalar t79 = s_6 * t43 + c_6 * t47;
  const Scalar t80 = t55 * omega_r_6_y;
  const Scalar U_6_yx = t80 + domega_6_z;
  const Scalar t81 = t79 - Scalar(0.088) * U_6_yx;
  const Scalar t82 = t66 + t67;
  const Scalar t83 = t69 + t70;
  const Scalar t84 = t71 + t74;
  const Scalar t85 = Scalar(0.002034439958661797) * t81 - Scalar(0.000391391281684248) * t82 -
      Scalar(0.0009653051699191118) * U_7_yx + Scalar(0.0012555365982728983) * (t75 - t84) -
      Scalar(0.004552547872941088) * t83;
  const Scalar U_7_zz_xx = t73 - t84;
  const Scalar t86 = Scalar(0.000391391281684248) * t83 + Scalar(0.002573605371338203) * t81 +
      Scalar(0.0012555365982728983) * t77 + Scalar(0.0009653051699191118) * U_7_zz_xx +
      Scalar(0.002131604094419858) * t82;
  const Scalar t87 = Scalar(0.002573605371338203) * t82 - Scalar(0.002034439958661797) * t83;
  const Scalar t88 = omega_r_6_y * omega_6_z;
  const Scalar t89 = t55 * t55;
  const Scalar t90 = t89 + t51;
  const Scalar t91 = domega_6_z - t80;
  const Scalar mu_u_6_a_y = Scalar(0.000093569097314605) * (t57 - t58) +
      Scalar(0.000103758917218685) * (t64 - t88) + Scalar(0.088) * t87 - s_7 * t85 + c_7 * t86 -
      Scalar(0.028934422545659894) * t91 - Scalar(0.021522255370587554) * U_6_yx +
      Scalar(0.014748570382675316) * (t52 - t90) + Scalar(0.173804705569) * t48 +
      Scalar(0.231847552695) * t79;
  tau[5] = -mu_u_6_a_y;
  const Scalar t92 = Scalar(0.002034439958661797) * t77 + Scalar(0.002573605371338203) * t73;
  const Scalar F_7_y = Scalar(0.002573605371338203) * U_7_yx - Scalar(0.002034439958661797) * t75;
  const Scalar t93 = s_7 * t92 - c_7 * F_7_y;
  const Scalar t94 = t64 + t88;
  const Scalar t95 = t50 + t89;
  const Scalar U_6_zz_xx = t52 - t95;
  const Scalar t96 = Scalar(0.000103758917218685) * U_6_zz_xx - Scalar(0.000093569097314605) * t91 -
      Scalar(0.088) * t93 - t78 - Scalar(0.014748570382675316) * t94 +
      Scalar(0.021522255370587554) * t59 + Scalar(0.231847552695) * t54;
  const Scalar t97 = Scalar(0.000103758917218685) * U_6_yx +
      Scalar(0.000093569097314605) * (t90 - t95) - s_7 * t86 - c_7 * t85 +
      Scalar(0.014748570382675316) * t59 - Scalar(0.028934422545659894) * t94 +
      Scalar(0.173804705569) * t54;
  const Scalar t98 = t49 * omega_5_z;
  const Scalar t99 = omega_r_6_a_z * omega_5_z;
  const Scalar U_5_yz = t56 - t99;
  const Scalar t100 = omega_r_6_a_z * omega_r_6_a_z;
  const Scalar t101 = omega_5_z * omega_5_z;
  const Scalar t102 = t100 + t101;
  const Scalar t103 = t49 * t49;
  const Scalar t104 = t103 + t101;
  const Scalar t105 = t49 * omega_r_6_a_z;
  const Scalar t106 = domega_5_z - t105;
  const Scalar U_5_yx = t105 + domega_5_z;
  const Scalar t107 = Scalar(-0.00216405205209813) * (t65 - t98) -
      Scalar(0.001451156065026714) * U_5_yx - Scalar(0.00151524447332703) * (t102 - t104) -
      Scalar(0.004600245517563106) * U_5_yz - Scalar(0.014653732538) * t54 -
      Scalar(0.010045187828321245) * t106 + Scalar(0.067870631425) * t43 + s_6 * t97 + c_6 * t96;
  tau[4] = -t107;
  const Scalar t108 = t98 + t65;
  const Scalar t109 = t99 + t56;
  const Scalar t110 = t100 + t103;
  const Scalar t111 = Scalar(0.00151524447332703) * t108 +
      Scalar(0.00216405205209813) * (t104 - t110) + Scalar(0.004600245517563106) * U_5_yx +
      Scalar(0.010045187828321245) * t109 + Scalar(0.067870631425) * t47 - s_6 * t96 + c_6 * t97;
  const Scalar U_5_zz_xx = t102 - t110;
  const Scalar t112 = Scalar(-0.00216405205209813) * t106 - Scalar(0.001451156065026714) * t108 -
      Scalar(0.00151524447332703) * t109 + Scalar(0.014653732538) * t47 +
      Scalar(0.004600245517563106) * U_5_zz_xx - mu_u_6_a_y;
  const Scalar f_6_y = Scalar(0.231847552695) * U_6_yx - t87 + Scalar(0.173804705569) * t90;
  const Scalar t113 = s_7 * F_7_y + c_7 * t92 + Scalar(0.231847552695) * t52 -
      Scalar(0.173804705569) * t91;
  const Scalar f_5_x = Scalar(0.014653732538) * t102 - Scalar(0.067870631425) * t106 - s_6 * f_6_y -
      c_6 * t113;
  const Scalar t114 = Scalar(0.014653732538) * U_5_yx - t93 + Scalar(0.067870631425) * t104 +
      Scalar(0.231847552695) * t59 - Scalar(0.173804705569) * t94;
  const Scalar f_u_5_t_x = s_5 * t114 + c_5 * f_5_x;
  const Scalar t115 = Scalar(0.014653732538) * t108 - Scalar(0.067870631425) * t109 - s_6 * t113 +
      c_6 * f_6_y;
  const Scalar U_4_yz = t40 - t41;
  const Scalar t116 = Scalar(0.0039053550262761) * U_4_yz -
      Scalar(0.00164448757736927) * (t37 - t38) - Scalar(0.0510201361568155) * U_4_yx +
      Scalar(0.0825) * t115 - s_5 * t111 - Scalar(0.55278027465) * t44 + Scalar(0.384) * f_u_5_t_x -
      c_5 * t112 + Scalar(0.16284087268546085) * (t27 - t46) + Scalar(2.012523553603) * t23 -
      Scalar(0.6972920750309718) * t30;
  tau[3] = -t116;
  const Scalar t117 = s_5 * f_5_x - c_5 * t114;
  const Scalar t118 = t25 + t45;
  const Scalar t119 = Scalar(-0.00164448757736927) * (t46 - t118) -
      Scalar(0.0039053550262761) * U_4_yx + c_5 * t111 + Scalar(0.16284087268546085) * t39 +
      Scalar(0.384) * t117 - s_5 * t112 + Scalar(2.012523553603) * ddp_o_4_y +
      Scalar(0.6972920750309718) * t42;
  const Scalar U_4_zz_xx = t27 - t118;
  const Scalar t120 = Scalar(0.00164448757736927) * t30 - Scalar(0.0039053550262761) * U_4_zz_xx +
      Scalar(0.0825) * t117 + Scalar(0.0510201361568155) * t39 + Scalar(0.55278027465) * ddp_o_4_y +
      Scalar(0.16284087268546085) * t42 + t107;
  const Scalar t121 = t117 + Scalar(0.55278027465) * t39 + Scalar(2.012523553603) * t42;
  const Scalar t122 = omega_r_3_y * omega_3_z;
  const Scalar t123 = t16 * t16;
  const Scalar t124 = t123 + t13;
  const Scalar t125 = domega_3_z - t35;
  const Scalar t126 = Scalar(0.005487648106562256) * (t36 - t122) -
      Scalar(0.000121912420950744) * (t14 - t124) - Scalar(0.004377257121839584) * (t17 - t18) +
      Scalar(0.028227094878) * t11 - Scalar(0.022178148964878235) * t125 -
      Scalar(0.061602421026527694) * U_3_yx - Scalar(0.0825) * t121 + c_4 * t120 -
      Scalar(0.746857959872) * ddp_3_y + s_4 * t119;
  tau[2] = -t126;
  const Scalar t127 = t36 + t122;
  const Scalar t128 = t12 + t123;
  const Scalar mu_3_x = Scalar(0.000121912420950744) * t19 - Scalar(0.005487648106562256) * U_3_yx +
      Scalar(0.004377257121839584) * (t124 - t128) + Scalar(0.028227094878) * ddp_3_a_z +
      Scalar(0.022178148964878235) * t127 + s_4 * t120 - c_4 * t119;
  const Scalar f_4_x = f_u_5_t_x + Scalar(0.55278027465) * t27 - Scalar(2.012523553603) * t30;
  const Scalar t129 = Scalar(0.55278027465) * U_4_yx - t115 + Scalar(2.012523553603) * t46;
  const Scalar t130 = s_4 * f_4_x - c_4 * t129;
  const Scalar U_3_zz_xx = t14 - t128;
  const Scalar t131 = Scalar(0.000121912420950744) * t127 + Scalar(0.004377257121839584) * t125 +
      Scalar(0.005487648106562256) * U_3_zz_xx + Scalar(0.061602421026527694) * t19 +
      Scalar(0.0825) * t130 + Scalar(0.746857959872) * ddp_3_a_z - t116;
  const Scalar t132 = Scalar(0.028227094878) * t125 + Scalar(0.746857959872) * t14 - s_4 * t129 -
      c_4 * f_4_x;
  const Scalar f_3_y = Scalar(0.746857959872) * U_3_yx - Scalar(0.028227094878) * t124 + t121;
  const Scalar t133 = s_3 * f_3_y + c_3 * t132;
  const Scalar t134 = t1 * t1;
  const Scalar t135 = t134 + t21;
  const Scalar U_2_yx = t8 + qdd_2;
  tau[1] = Scalar(0.01993386669246) * c_2 - Scalar(0.0007689361029464) * t33 +
      Scalar(0.00398335888393552) * (t135 - t22) - Scalar(0.01026110182100817) * t3 +
      Scalar(0.023077882494931805) * U_2_yx + Scalar(1.032162061231881) * t9 -
      Scalar(0.316) * t133 + s_3 * mu_3_x - c_3 * t131 - Scalar(32.80954542685272) * s_2;
  const Scalar t136 = s_3 * t132 - c_3 * f_3_y;
  const Scalar t137 = t32 + t34;
  const Scalar t138 = t134 + t20;
  const Scalar mu_2_x = Scalar(-0.0007689361029464) * (t22 - t138) -
      Scalar(0.00398335888393552) * t137 + Scalar(0.01026110182100817) * U_2_yx -
      Scalar(1.032162061231881) * t5 + Scalar(0.316) * t136 + s_3 * t131 + c_3 * mu_3_x;
  const Scalar U_2_zz_xx = t135 - t138;
  const Scalar mu_2_y = Scalar(0.0007689361029464) * t9 + Scalar(0.00398335888393552) * t5 +
      Scalar(0.01026110182100817) * U_2_zz_xx + Scalar(0.023077882494931805) * t137 + t126;
  tau[0] = Scalar(0.014259565994474374) * qdd_1 - c_2 * mu_2_y - s_2 * mu_2_x;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[7]    in   joint positions, rad or m
//   qd[7]   in   joint velocities, rad/s or m/s
//   qdd[7]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[7]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..6], qd[0..6], qdd[0..6], h_e[0..5]. Operations: 366 mul, 326 add, 14 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics_tip_force(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    const Scalar* h_e, Scalar* tau, const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5], qdd_7 = qdd[6];
  const Scalar h_e_1 = h_e[0], h_e_2 = h_e[1], h_e_3 = h_e[2], h_e_4 = h_e[3], h_e_5 = h_e[4],
      h_e_6 = h_e[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = qd_2 * t1;
  const Scalar t3 = s_2 * qdd_1;
  const Scalar t4 = t2 + t3;
  const Scalar t5 = t2 + t4;
  const Scalar t6 = Scalar(0.316) * t5;
  const Scalar t7 = s_2 * qd_1;
  const Scalar t8 = t1 * t7;
  const Scalar t9 = qdd_2 - t8;
  const Scalar t10 = Scalar(9.81) * s_2 - Scalar(0.316) * t9;
  const Scalar t11 = s_3 * t6 - c_3 * t10;
  const Scalar omega_r_3_y = s_3 * t7 + c_3 * qd_2;
  const Scalar t12 = omega_r_3_y * omega_r_3_y;
  const Scalar omega_3_z = qd_3 + t1;
  const Scalar t13 = omega_3_z * omega_3_z;
  const Scalar t14 = t12 + t13;
  const Scalar t15 = t11 - Scalar(0.0825) * t14;
  const Scalar t16 = s_3 * qd_2 - c_3 * t7;
  const Scalar t17 = qd_3 * t16 - s_3 * t4 - c_3 * qdd_2;
  const Scalar t18 = t16 * omega_3_z;
  const Scalar t19 = t17 + t18;
  const Scalar t20 = t7 * t7;
  const Scalar t21 = qd_2 * qd_2;
  const Scalar t22 = t20 + t21;
  const Scalar ddp_3_a_z = Scalar(9.81) * c_2 - Scalar(0.316) * t22;
  const Scalar ddp_o_4_z = Scalar(0.0825) * t19 + ddp_3_a_z;
  const Scalar t23 = s_4 * ddp_o_4_z + c_4 * t15;
  const Scalar t24 = s_4 * t16 - c_4 * omega_3_z;
  const Scalar t25 = t24 * t24;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar t26 = omega_4_z * omega_4_z;
  const Scalar t27 = t26 + t25;
  const Scalar domega_4_z = qdd_4 + t17;
  const Scalar t28 = c_4 * t16 + s_4 * omega_3_z;
  const Scalar t29 = t28 * t24;
  const Scalar t30 = domega_4_z + t29;
  const Scalar t31 = Scalar(0.0825) * t27 + t23 - Scalar(0.384) * t30;
  const Scalar ddp_3_y = c_3 * t6 + s_3 * t10;
  const Scalar t32 = qd_2 * t7;
  const Scalar t33 = c_2 * qdd_1;
  const Scalar t34 = t32 - t33;
  const Scalar domega_3_z = qdd_3 - t34;
  const Scalar t35 = t16 * omega_r_3_y;
  const Scalar U_3_yx = t35 + domega_3_z;
  const Scalar ddp_o_4_y = Scalar(0.0825) * U_3_yx + ddp_3_y;
  const Scalar t36 = qd_3 * omega_r_3_y + s_3 * qdd_2 - c_3 * t4;
  const Scalar t37 = qd_4 * t28 + s_4 * t36 - c_4 * domega_3_z;
  const Scalar t38 = t28 * omega_4_z;
  const Scalar t39 = t37 + t38;
  const Scalar t40 = qd_4 * t24 - s_4 * domega_3_z - c_4 * t36;
  const Scalar t41 = t24 * omega_4_z;
  const Scalar t42 = t40 + t41;
  const Scalar ddp_5_a_y = Scalar(0.0825) * t39 + ddp_o_4_y + Scalar(0.384) * t42;
  const Scalar t43 = s_5 * ddp_5_a_y + c_5 * t31;
  const Scalar t44 = s_4 * t15 - c_4 * ddp_o_4_z;
  const Scalar U_4_yx = domega_4_z - t29;
  const Scalar t45 = t28 * t28;
  const Scalar t46 = t26 + t45;
  const Scalar t47 = Scalar(0.0825) * U_4_yx + t44 + Scalar(0.384) * t46;
  const Scalar t48 = s_6 * t47 - c_6 * t43;
  const Scalar t49 = s_5 * omega_4_z - c_5 * t28;
  const Scalar omega_5_z = qd_5 - t24;
  const Scalar omega_r_6_y = s_6 * t49 + c_6 * omega_5_z;
  const Scalar t50 = omega_r_6_y * omega_r_6_y;
  const Scalar omega_r_6_a_z = s_5 * t28 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t51 = omega_6_z * omega_6_z;
  const Scalar t52 = t50 + t51;
  const Scalar t53 = Scalar(0.088) * t52 + t48;
  const Scalar t54 = s_5 * t31 - c_5 * ddp_5_a_y;
  const Scalar t55 = s_6 * omega_5_z - c_6 * t49;
  const Scalar t56 = qd_5 * omega_r_6_a_z + s_5 * domega_4_z + c_5 * t40;
  const Scalar domega_5_z = qdd_5 - t37;
  const Scalar t57 = qd_6 * t55 - s_6 * t56 - c_6 * domega_5_z;
  const Scalar t58 = t55 * omega_6_z;
  const Scalar t59 = t57 + t58;
  const Scalar t60 = Scalar(0.088) * t59 + t54;
  const Scalar t61 = s_7 * t60 - c_7 * t53;
  const Scalar t62 = s_7 * t53 + c_7 * t60;
  const Scalar t63 = s_7 * omega_6_z + c_7 * t55;
  const Scalar t64 = qd_6 * omega_r_6_y + s_6 * domega_5_z - c_6 * t56;
  const Scalar t65 = qd_5 * t49 + s_5 * t40 - c_5 * domega_4_z;
  const Scalar domega_6_z = qdd_6 - t65;
  const Scalar t66 = qd_7 * t63 + s_7 * t64 - c_7 * domega_6_z;
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar t67 = t63 * omega_7_z;
  const Scalar t68 = s_7 * t55 - c_7 * omega_6_z;
  const Scalar t69 = qd_7 * t68 - s_7 * domega_6_z - c_7 * t64;
  const Scalar t70 = t68 * omega_7_z;
  const Scalar U_7_yz = t69 - t70;
  const Scalar t71 = t68 * t68;
  const Scalar t72 = omega_7_z * omega_7_z;
  const Scalar t73 = t72 + t71;
  const Scalar t74 = t63 * t63;
  const Scalar t75 = t72 + t74;
  const Scalar domega_7_z = qdd_7 + t57;
  const Scalar t76 = t63 * t68;
  const Scalar t77 = domega_7_z + t76;
  const Scalar U_7_yx = domega_7_z - t76;
  const Scalar mu_e1_x = s_1 * h_e_5 + c_1 * h_e_4;
  const Scalar t78 = s_2 * h_e_6 - c_2 * mu_e1_x;
  const Scalar t79 = s_1 * h_e_4 - c_1 * h_e_5;
  const Scalar t80 = s_3 * t79 + c_3 * t78;
  const Scalar mu_e3_a_z = s_2 * mu_e1_x + c_2 * h_e_6;
  const Scalar mu_e4_x = s_4 * mu_e3_a_z - c_4 * t80;
  const Scalar mu_e3_y = s_3 * t78 - c_3 * t79;
  const Scalar mu_e5_x = s_5 * mu_e3_y + c_5 * mu_e4_x;
  const Scalar mu_e4_y = s_4 * t80 + c_4 * mu_e3_a_z;
  const Scalar mu_u_7_a_y = Scalar(0.002034439958661797) * t61 -
      Scalar(0.002573605371338203) * t62 + Scalar(0.000391391281684248) * (t73 - t75) -
      Scalar(0.0012555365982728983) * (t66 - t67) - Scalar(0.0009653051699191118) * U_7_yz -
      Scalar(0.002131604094419858) * U_7_yx - Scalar(0.004552547872941088) * t77 - s_6 * mu_e5_x +
      c_6 * mu_e4_y;
  tau[6] = -mu_u_7_a_y;
  const Scalar t81 = s_6 * t43 + c_6 * t47;
  const Scalar t82 = t55 * omega_r_6_y;
  const Scalar U_6_yx = t82 + domega_6_z;
  const Scalar t83 = t81 - Scalar(0.088) * U_6_yx;
  const Scalar f_e1_x = s_1 * h_e_2 + c_1 * h_e_1;
  const Scalar t84 = s_2 * h_e_3 - c_2 * f_e1_x;
  const Scalar t85 = s_1 * h_e_1 - c_1 * h_e_2;
  const Scalar t86 = s_3 * t85 + c_3 * t84;
  const Scalar f_e3_a_z = s_2 * f_e1_x + c_2 * h_e_3;
  const Scalar f_e4_x = s_4 * f_e3_a_z - c_4 * t86;
  const Scalar f_e3_y = s_3 * t84 - c_3 * t85;
  const Scalar f_e5_x = s_5 * f_e3_y + c_5 * f_e4_x;
  const Scalar f_e4_y = s_4 * t86 + c_4 * f_e3_a_z;
  const Scalar f_e6_x = s_6 * f_e4_y + c_6 * f_e5_x;
  const Scalar t87 = s_5 * f_e4_x - c_5 * f_e3_y;
  const Scalar t88 = s_7 * f_e6_x - c_7 * t87;
  const Scalar t89 = t66 + t67;
  const Scalar t90 = t69 + t70;
  const Scalar t91 = t71 + t74;
  const Scalar mu_e6_x = s_6 * mu_e4_y + c_6 * mu_e5_x;
  const Scalar t92 = s_5 * mu_e4_x - c_5 * mu_e3_y;
  const Scalar mu_7_x = Scalar(0.002034439958661797) * t83 - Scalar(0.000391391281684248) * t89 -
      Scalar(0.0009653051699191118) * U_7_yx + Scalar(0.0012555365982728983) * (t75 - t91) -
      Scalar(0.004552547872941088) * t90 + Scalar(0.2104) * t88 + s_7 * t92 + c_7 * mu_e6_x;
  const Scalar f_e7_x = s_7 * t87 + c_7 * f_e6_x;
  const Scalar U_7_zz_xx = t73 - t91;
  const Scalar mu_7_y = Scalar(-0.000391391281684248) * t90 - Scalar(0.002573605371338203) * t83 -
      Scalar(0.0012555365982728983) * t77 - Scalar(0.0009653051699191118) * U_7_zz_xx -
      Scalar(0.002131604094419858) * t89 + Scalar(0.2104) * f_e7_x - s_7 * mu_e6_x + c_7 * t92;
  const Scalar t93 = Scalar(0.002573605371338203) * t89 - Scalar(0.002034439958661797) * t90 +
      s_6 * f_e5_x - c_6 * f_e4_y;
  const Scalar t94 = omega_r_6_y * omega_6_z;
  const Scalar t95 = t55 * t55;
  const Scalar t96 = t95 + t51;
  const Scalar t97 = domega_6_z - t82;
  const Scalar mu_u_6_a_y = Scalar(0.000093569097314605) * (t57 - t58) +
      Scalar(0.000103758917218685) * (t64 - t94) - Scalar(0.028934422545659894) * t97 -
      Scalar(0.021522255370587554) * U_6_yx + Scalar(0.014748570382675316) * (t52 - t96) +
      Scalar(0.088) * t93 + Scalar(0.173804705569) * t48 + Scalar(0.231847552695) * t81 -
      s_7 * mu_7_x - c_7 * mu_7_y;
  tau[5] = -mu_u_6_a_y;
  const Scalar f_7_x = Scalar(-0.002034439958661797) * t77 - Scalar(0.002573605371338203) * t73 +
      f_e7_x;
  const Scalar t98 = Scalar(0.002034439958661797) * t75 - Scalar(0.002573605371338203) * U_7_yx +
      t88;
  const Scalar t99 = s_7 * f_7_x - c_7 * t98;
  const Scalar t100 = t64 + t94;
  const Scalar t101 = t50 + t95;
  const Scalar U_6_zz_xx = t52 - t101;
  const Scalar t102 = Scalar(0.000103758917218685) * U_6_zz_xx -
      Scalar(0.000093569097314605) * t97 - Scalar(0.014748570382675316) * t100 +
      Scalar(0.021522255370587554) * t59 + Scalar(0.088) * t99 + Scalar(0.231847552695) * t54 -
      mu_u_7_a_y;
  const Scalar t103 = Scalar(0.000103758917218685) * U_6_yx +
      Scalar(0.000093569097314605) * (t96 - t101) + Scalar(0.014748570382675316) * t59 -
      Scalar(0.028934422545659894) * t100 + Scalar(0.173804705569) * t54 + s_7 * mu_7_y -
      c_7 * mu_7_x;
  const Scalar t104 = t49 * omega_5_z;
  const Scalar t105 = omega_r_6_a_z * omega_5_z;
  const Scalar U_5_yz = t56 - t105;
  const Scalar t106 = omega_r_6_a_z * omega_r_6_a_z;
  const Scalar t107 = omega_5_z * omega_5_z;
  const Scalar t108 = t106 + t107;
  const Scalar t109 = t49 * t49;
  const Scalar t110 = t109 + t107;
  const Scalar t111 = t49 * omega_r_6_a_z;
  const Scalar t112 = domega_5_z - t111;
  const Scalar U_5_yx = t111 + domega_5_z;
  const Scalar t113 = Scalar(-0.00216405205209813) * (t65 - t104) -
      Scalar(0.001451156065026714) * U_5_yx - Scalar(0.00151524447332703) * (t108 - t110) -
      Scalar(0.004600245517563106) * U_5_yz - Scalar(0.014653732538) * t54 -
      Scalar(0.010045187828321245) * t112 + Scalar(0.067870631425) * t43 + s_6 * t103 + c_6 * t102;
  tau[4] = -t113;
  const Scalar t114 = t104 + t65;
  const Scalar t115 = t105 + t56;
  const Scalar t116 = t106 + t109;
  const Scalar t117 = Scalar(0.00151524447332703) * t114 +
      Scalar(0.00216405205209813) * (t110 - t116) + Scalar(0.004600245517563106) * U_5_yx +
      Scalar(0.010045187828321245) * t115 + Scalar(0.067870631425) * t47 - s_6 * t102 + c_6 * t103;
  const Scalar t118 = Scalar(0.231847552695) * t52 - Scalar(0.173804705569) * t97 - s_7 * t98 -
      c_7 * f_7_x;
  const Scalar f_6_y = Scalar(0.231847552695) * U_6_yx + Scalar(0.173804705569) * t96 - t93;
  const Scalar f_5_x = Scalar(0.014653732538) * t108 - Scalar(0.067870631425) * t112 - s_6 * f_6_y -
      c_6 * t118;
  const Scalar t119 = Scalar(0.014653732538) * U_5_yx + Scalar(0.067870631425) * t110 +
      Scalar(0.231847552695) * t59 - Scalar(0.173804705569) * t100 + t99;
  const Scalar f_u_5_t_x = s_5 * t119 + c_5 * f_5_x;
  const Scalar U_5_zz_xx = t108 - t116;
  const Scalar t120 = Scalar(-0.00216405205209813) * t112 - Scalar(0.001451156065026714) * t114 -
      Scalar(0.00151524447332703) * t115 + Scalar(0.014653732538) * t47 +
      Scalar(0.004600245517563106) * U_5_zz_xx - mu_u_6_a_y;
  const Scalar t121 = Scalar(0.014653732538) * t114 - Scalar(0.067870631425) * t115 - s_6 * t118 +
      c_6 * f_6_y;
  const Scalar U_4_yz = t40 - t41;
  const Scalar t122 = Scalar(0.0039053550262761) * U_4_yz -
      Scalar(0.00164448757736927) * (t37 - t38) - Scalar(0.0510201361568155) * U_4_yx +
      Scalar(0.0825) * t121 - Scalar(0.55278027465) * t44 +
      Scalar(0.16284087268546085) * (t27 - t46) + Scalar(0.384) * f_u_5_t_x - s_5 * t117 -
      c_5 * t120 + Scalar(2.012523553603) * t23 - Scalar(0.6972920750309718) * t30;
  tau[3] = -t122;
  const Scalar t123 = s_5 * f_5_x - c_5 * t119;
  const Scalar t124 = t25 + t45;
  const Scalar t125 = Scalar(-0.00164448757736927) * (t46 - t124) -
      Scalar(0.0039053550262761) * U_4_yx + Scalar(0.16284087268546085) * t39 +
      Scalar(0.384) * t123 - s_5 * t120 + c_5 * t117 + Scalar(2.012523553603) * ddp_o_4_y +
      Scalar(0.6972920750309718) * t42;
  const Scalar U_4_zz_xx = t27 - t124;
  const Scalar t126 = Scalar(0.00164448757736927) * t30 - Scalar(0.0039053550262761) * U_4_zz_xx +
      Scalar(0.0510201361568155) * t39 + Scalar(0.0825) * t123 + Scalar(0.55278027465) * ddp_o_4_y +
      Scalar(0.16284087268546085) * t42 + t113;
  const Scalar t127 = Scalar(0.55278027465) * t39 + t123 + Scalar(2.012523553603) * t42;
  const Scalar t128 = omega_r_3_y * omega_3_z;
  const Scalar t129 = t16 * t16;
  const Scalar t130 = t129 + t13;
  const Scalar t131 = domega_3_z - t35;
  const Scalar t132 = Scalar(0.005487648106562256) * (t36 - t128) -
      Scalar(0.000121912420950744) * (t14 - t130) - Scalar(0.004377257121839584) * (t17 - t18) +
      Scalar(0.028227094878) * t11 - Scalar(0.022178148964878235) * t131 -
      Scalar(0.061602421026527694) * U_3_yx - Scalar(0.0825) * t127 -
      Scalar(0.746857959872) * ddp_3_y + c_4 * t126 + s_4 * t125;
  tau[2] = -t132;
  const Scalar t133 = t36 + t128;
  const Scalar t134 = t12 + t129;
  const Scalar mu_3_x = Scalar(0.000121912420950744) * t19 - Scalar(0.005487648106562256) * U_3_yx +
      Scalar(0.004377257121839584) * (t130 - t134) + Scalar(0.028227094878) * ddp_3_a_z +
      Scalar(0.022178148964878235) * t133 + s_4 * t126 - c_4 * t125;
  const Scalar f_4_x = Scalar(0.55278027465) * t27 + f_u_5_t_x - Scalar(2.012523553603) * t30;
  const Scalar t135 = Scalar(0.55278027465) * U_4_yx - t121 + Scalar(2.012523553603) * t46;
  const Scalar t136 = Scalar(0.028227094878) * t131 + Scalar(0.746857959872) * t14 - s_4 * t135 -
      c_4 * f_4_x;
  const Scalar f_3_y = Scalar(0.746857959872) * U_3_yx - Scalar(0.028227094878) * t130 + t127;
  const Scalar t137 = s_3 * f_3_y + c_3 * t136;
  const Scalar t138 = s_4 * f_4_x - c_4 * t135;
  const Scalar U_3_zz_xx = t14 - t134;
  const Scalar t139 = Scalar(0.000121912420950744) * t133 + Scalar(0.004377257121839584) * t131 +
      Scalar(0.005487648106562256) * U_3_zz_xx + Scalar(0.061602421026527694) * t19 +
      Scalar(0.0825) * t138 + Scalar(0.746857959872) * ddp_3_a_z - t122;
  const Scalar t140 = t1 * t1;
  const Scalar t141 = t140 + t21;
  const Scalar U_2_yx = t8 + qdd_2;
  tau[1] = Scalar(0.01993386669246) * c_2 - Scalar(0.0007689361029464) * t33 +
      Scalar(0.00398335888393552) * (t141 - t22) - Scalar(0.01026110182100817) * t3 +
      Scalar(0.023077882494931805) * U_2_yx + Scalar(1.032162061231881) * t9 -
      Scalar(0.316) * t137 + s_3 * mu_3_x - Scalar(32.80954542685272) * s_2 - c_3 * t139;
  const Scalar t142 = s_3 * t136 - c_3 * f_3_y;
  const Scalar t143 = t32 + t34;
  const Scalar t144 = t140 + t20;
  const Scalar mu_2_x = Scalar(-0.0007689361029464) * (t22 - t144) -
      Scalar(0.00398335888393552) * t143 + Scalar(0.01026110182100817) * U_2_yx -
      Scalar(1.032162061231881) * t5 + Scalar(0.316) * t142 + c_3 * mu_3_x + s_3 * t139;
  const Scalar U_2_zz_xx = t141 - t144;
  const Scalar mu_2_y = Scalar(0.0007689361029464) * t9 + Scalar(0.00398335888393552) * t5 +
      Scalar(0.01026110182100817) * U_2_zz_xx + Scalar(0.023077882494931805) * t143 + t132;
  tau[0] = Scalar(0.014259565994474374) * qdd_1 - c_2 * mu_2_y - s_2 * mu_2_x;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[49] = {
    1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1};

// Joint-space inertia matrix B(q) (7.32).
//   q[7]   in   joint positions, rad or m
//   B[49]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//               7 x 7, row by row: entry (i, j) is B[7 * i + j]
// Reads q[1..6]. Operations: 182 mul, 157 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inertia_matrix(const Scalar* q, Scalar* B, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5],
      s_7 = sine[6], c_7 = cosine[6];
  const Scalar Iu_7_a_xy = Scalar(0.0012555365982728983) * c_7 +
      Scalar(0.0009653051699191118) * s_7;
  B[41] = B[47] = -Iu_7_a_xy;
  const Scalar Iu_7_t_g = Scalar(0.00242094377852123) * c_7 - Scalar(0.000782782563368496) * s_7;
  const Scalar t1 = c_7 * Iu_7_t_g;
  const Scalar hu_7_t_x = Scalar(0.002573605371338203) * c_7 - Scalar(0.002034439958661797) * s_7;
  const Scalar t2 = Scalar(0.176) * hu_7_t_x;
  const Scalar t3 = t1 - t2 - Scalar(0.055009225789188536);
  B[40] = -t3;
  const Scalar t4 = Scalar(0.088) * hu_7_t_x + Scalar(0.006684151967360946);
  const Scalar Iu_7_a_xz = Scalar(0.0009653051699191118) * c_7 -
      Scalar(0.0012555365982728983) * s_7;
  const Scalar t5 = s_6 * Iu_7_a_xz + c_6 * t4;
  B[34] = B[46] = -t5;
  const Scalar hu_7_t_y = Scalar(0.002034439958661797) * c_7 + Scalar(0.002573605371338203) * s_7;
  const Scalar t6 = Scalar(0.088) * hu_7_t_y - Scalar(0.000287632364465563) - s_7 * Iu_7_t_g;
  const Scalar Ic_6_yz = Scalar(0.000093569097314605) + Iu_7_a_xy;
  const Scalar t7 = s_6 * t6 - c_6 * Ic_6_yz;
  B[33] = B[39] = -t7;
  const Scalar t8 = s_6 * t4 - c_6 * Iu_7_a_xz;
  const Scalar t9 = c_6 * hu_7_t_y;
  const Scalar t10 = s_5 * hu_7_t_x - c_5 * t9;
  const Scalar t11 = s_6 * hu_7_t_y;
  const Scalar t12 = Scalar(0.384) * t10 - Scalar(0.0825) * t11 + c_5 * Iu_7_a_xy + s_5 * t8;
  B[27] = B[45] = -t12;
  const Scalar Iu_7_t_xx = t1 - Scalar(0.00242094377852123);
  const Scalar Ic_6_yy = t2 - Scalar(0.00528056308065248);
  const Scalar Iu_6_t_d = Iu_7_t_xx - Ic_6_yy;
  const Scalar Ic_6_xy = Iu_7_a_xz + Scalar(0.014748570382675316);
  const Scalar t13 = Scalar(2.0) * s_6 * Ic_6_xy - c_6 * Iu_6_t_d;
  const Scalar t14 = c_6 * t13;
  const Scalar Ic_5_zz = Iu_7_t_xx + t14 + Scalar(0.04498331431194894);
  B[32] = Ic_5_zz;
  const Scalar Iu_6_a_xz = s_6 * Ic_6_yz + c_6 * t6;
  const Scalar hc_6_x = hu_7_t_x + Scalar(0.231847552695);
  const Scalar f_u_6_6_t_x = Scalar(0.173804705569) * c_6 - s_6 * hc_6_x;
  const Scalar t15 = t3 + Scalar(0.384) * f_u_6_6_t_x;
  const Scalar hu_6_t_x = Scalar(0.173804705569) * s_6 + c_6 * hc_6_x;
  const Scalar mu_u_6_4_a_y = Scalar(0.0825) * hu_6_t_x - s_5 * Iu_6_a_xz + c_5 * t15;
  B[26] = B[38] = -mu_u_6_4_a_y;
  const Scalar t16 = c_5 * Iu_6_a_xz + s_5 * t15;
  const Scalar t17 = s_5 * f_u_6_6_t_x;
  const Scalar t18 = Scalar(0.0825) * t17;
  const Scalar t19 = t7 + t18;
  const Scalar mu_6_3_z = t18 - c_4 * t19 - s_4 * t16;
  B[19] = B[37] = mu_6_3_z;
  const Scalar f_u_7_5_a_z = s_5 * t9 + c_5 * hu_7_t_x;
  const Scalar mu_7_4_x = Scalar(0.384) * f_u_7_5_a_z - s_5 * Iu_7_a_xy + c_5 * t8;
  const Scalar t20 = Scalar(0.0825) * f_u_7_5_a_z;
  const Scalar t21 = t5 - t20;
  const Scalar mu_u_7_3_a_y = t20 - s_4 * mu_7_4_x + c_4 * t21;
  B[20] = B[44] = -mu_u_7_3_a_y;
  const Scalar mu_u_7_4_t_x = s_4 * t21 + c_4 * mu_7_4_x;
  const Scalar t22 = s_4 * t11 + c_4 * t10;
  const Scalar t23 = s_3 * f_u_7_5_a_z + c_3 * t22;
  const Scalar t24 = t12 - Scalar(0.0825) * (s_4 * t10 - c_4 * t11);
  B[13] = B[43] = Scalar(0.316) * t23 + s_3 * mu_u_7_4_t_x + c_3 * t24;
  const Scalar Ic_5_xz = Ic_6_xy - Scalar(0.004600245517563106) - s_6 * t13;
  const Scalar t25 = t7 + Scalar(0.00216405205209813);
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.014653732538);
  const Scalar f_5_5_x = hu_7_t_y - Scalar(0.067870631425);
  const Scalar t26 = s_5 * hc_5_x - c_5 * f_5_5_x;
  const Scalar B_45 = Scalar(0.384) * t26 - (c_5 * t25 + s_5 * Ic_5_xz);
  B[25] = B[31] = B_45;
  const Scalar t27 = s_4 * t19 - c_4 * t16;
  const Scalar t28 = c_5 * f_u_6_6_t_x;
  const Scalar t29 = s_4 * hu_6_t_x - c_4 * t28;
  const Scalar t30 = s_3 * t17 + c_3 * t29;
  const Scalar f_u_6_4_t_y = s_4 * t28 + c_4 * hu_6_t_x;
  const Scalar mu_6_3_y = mu_u_6_4_a_y - Scalar(0.0825) * f_u_6_4_t_y;
  B[12] = B[36] = s_3 * t27 - Scalar(0.316) * t30 + c_3 * mu_6_3_y;
  const Scalar t31 = s_3 * t22 - c_3 * f_u_7_5_a_z;
  const Scalar t32 = s_2 * (Scalar(0.316) * t31 + s_3 * t24 - c_3 * mu_u_7_4_t_x);
  B[6] = B[42] = t32 - c_2 * mu_u_7_3_a_y;
  const Scalar Iu_6_t_xx = Ic_6_yy - t14;
  const Scalar t33 = t3 + Scalar(0.04208100218189551);
  const Scalar Iu_5_t_d = Iu_6_t_xx + t33;
  const Scalar Ic_5_xy = Iu_6_a_xz - Scalar(0.00151524447332703);
  const Scalar t34 = Scalar(2.0) * s_5 * Ic_5_xy - c_5 * Iu_5_t_d;
  const Scalar t35 = c_5 * t34;
  const Scalar hu_5_t_x = s_5 * f_5_5_x + c_5 * hc_5_x;
  const Scalar t36 = Scalar(0.165) * hu_5_t_x;
  const Scalar t37 = Scalar(0.768) * f_u_6_6_t_x;
  const Scalar B_44 = Iu_6_t_xx - t36 + t35 - t37 + Scalar(0.7918443694347095);
  B[24] = B_44;
  const Scalar t38 = (s_5 * t25 - c_5 * Ic_5_xz) + Scalar(0.384) * hu_5_t_x;
  const Scalar t39 = Scalar(0.0825) * hu_5_t_x;
  const Scalar mu_5_4_y = Ic_5_zz - t39;
  const Scalar mu_5_3_z = t39 - s_4 * t38 + c_4 * mu_5_4_y;
  B[18] = B[30] = mu_5_3_z;
  const Scalar t40 = s_3 * t29 - c_3 * t17;
  const Scalar t41 = s_2 * (Scalar(0.316) * t40 - s_3 * mu_6_3_y + c_3 * t27);
  B[5] = B[35] = c_2 * mu_6_3_z - t41;
  const Scalar t42 = Scalar(-0.0825) * t26;
  const Scalar t43 = Ic_5_xy - Scalar(0.0039053550262761) - t42 - s_5 * t34;
  const Scalar t44 = B_45 - Scalar(0.00164448757736927);
  const Scalar Iu_4_a_xy = s_4 * t43 - c_4 * t44;
  B[17] = B[23] = -Iu_4_a_xy;
  const Scalar t45 = s_4 * mu_5_4_y + c_4 * t38;
  const Scalar t46 = s_4 * t42 + B_45;
  const Scalar t47 = c_4 * t26;
  const Scalar t48 = s_3 * hu_5_t_x + c_3 * t47;
  B[11] = B[29] = Scalar(-0.316) * t48 - s_3 * t45 - c_3 * t46;
  const Scalar t49 = c_4 * t43 + s_4 * t44;
  const Scalar hc_4_x = hu_5_t_x - Scalar(0.55278027465);
  const Scalar f_4_4_x = f_u_6_6_t_x - Scalar(2.012523553603);
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * f_4_4_x;
  const Scalar t50 = s_4 * hc_4_x - c_4 * f_4_4_x;
  const Scalar t51 = Scalar(0.316) * t50 + (Scalar(0.0825) * hu_4_t_x + B_44);
  B[10] = B[22] = -s_3 * t49 - c_3 * t51;
  const Scalar t52 = s_3 * t47 - c_3 * hu_5_t_x;
  const Scalar t53 = s_2 * (Scalar(0.316) * t52 + s_3 * t46 - c_3 * t45);
  B[4] = B[28] = c_2 * mu_5_3_z - t53;
  const Scalar t54 = t35 + t33 + t37;
  const Scalar Ic_4_yy = Ic_5_zz - t36 - Scalar(0.6898040971210785);
  const Scalar t55 = Scalar(0.0825) * f_u_6_6_t_x + t38 - Scalar(0.16284087268546085);
  const Scalar t56 = Scalar(2.0) * s_4 * t55 - c_4 * (t54 + Ic_4_yy);
  const Scalar t57 = c_4 * t56;
  const Scalar t58 = Scalar(0.165) * hu_4_t_x;
  const Scalar t59 = t54 - t58 + t57 - Scalar(0.8246048032693);
  B[16] = -t59;
  B[3] = B[21] = s_2 * (c_3 * t49 - s_3 * t51) - c_2 * Iu_4_a_xy;
  const Scalar t60 = Scalar(0.005487648106562256) + Scalar(0.0825) * t50 + t55 - s_4 * t56;
  const Scalar Ic_3_yz = Iu_4_a_xy - Scalar(0.004377257121839584);
  const Scalar hc_3_x = Scalar(0.746857959872) + hu_4_t_x;
  const Scalar t61 = Scalar(0.028227094878) + t26;
  const Scalar t62 = c_3 * t61 + s_3 * hc_3_x;
  const Scalar t63 = Scalar(0.316) * t62 + (s_3 * t60 - c_3 * Ic_3_yz);
  B[9] = B[15] = -t63;
  const Scalar Iu_4_t_xx = t57 + Ic_4_yy;
  const Scalar t64 = t58 + B_44 - Scalar(0.7013999612162445);
  const Scalar Iu_3_t_d = Iu_4_t_xx - t64;
  const Scalar t65 = t42 - Scalar(0.000121912420950744) + t49;
  const Scalar t66 = Scalar(2.0) * s_3 * t65 - c_3 * Iu_3_t_d;
  const Scalar t67 = c_3 * t66;
  const Scalar t68 = Scalar(-0.632) * t50;
  B[8] = Iu_4_t_xx + t67 - t68 + Scalar(1.8182423259695848);
  const Scalar t69 = s_3 * t61 - c_3 * hc_3_x;
  const Scalar t70 = Scalar(0.316) * t69 - (s_3 * Ic_3_yz + c_3 * t60);
  B[2] = B[14] = -s_2 * t70 - c_2 * t59;
  B[1] = B[7] = -s_2 * (Scalar(0.01026110182100817) + t65 - s_3 * t66) -
      c_2 * (Scalar(0.0007689361029464) + t63);
  const Scalar t71 = -t67 - t68 + t64;
  const Scalar t72 = Scalar(2.0) * s_2 * (Scalar(0.00398335888393552) + t70) +
      c_2 * (t59 + t71 + Scalar(1.7720865609797212));
  B[0] = t71 - c_2 * t72 + Scalar(1.8094240094691274);
  B[48] = Scalar(0.006684151967360946);
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[196] = {
    0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[7]    in   joint positions, rad or m
//   c[196]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//                c_ijk = c_ikj is c[28 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads q[1..6]. Operations: 770 mul, 622 add, 12 sin/cos. Always zero: 28 of the 196 entries of c.
template <class Scalar, class SinCos = LibrarySinCos>
inline void christoffel(const Scalar* q, Scalar* c, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5],
      s_7 = sine[6], c_7 = cosine[6];
  const Scalar Iu_7_a_xz = Scalar(0.0004826525849595559) * c_7 -
      Scalar(0.0006277682991364491) * s_7;
  c[167] = Scalar(-2.0) * Iu_7_a_xz;
  const Scalar t1 = Scalar(0.000391391281684248) * c_7 + Scalar(0.001210471889260615) * s_7;
  const Scalar dmu_6_7_y = t1 - Scalar(0.00008951535818111907);
  const Scalar t2 = Scalar(0.001210471889260615) * c_7 - Scalar(0.000391391281684248) * s_7;
  const Scalar t3 = t2 - Scalar(0.00011323863633888094);
  const Scalar hu_7_t_y = Scalar(0.0010172199793308985) * c_7 + Scalar(0.0012868026856691014) * s_7;
  const Scalar t4 = Scalar(0.088) * hu_7_t_y;
  const Scalar c_7_6_6 = t4 - c_7 * dmu_6_7_y - s_7 * t3;
  c[188] = c_7_6_6;
  c[166] = -c_7_6_6;
  const Scalar t5 = c_6 * hu_7_t_y;
  const Scalar t6 = Scalar(0.088) * t5;
  const Scalar Iu_7_a_xy = Scalar(0.0006277682991364491) * c_7 +
      Scalar(0.0004826525849595559) * s_7;
  const Scalar db_57_7 = t6 + s_6 * Iu_7_a_xy;
  c[139] = Scalar(2.0) * db_57_7;
  const Scalar t7 = Scalar(0.0001438161822327815) - t4 + s_7 * t2;
  const Scalar Ic_6_yz = Scalar(0.0000467845486573025) + Iu_7_a_xy;
  const Scalar t8 = c_6 * t7 - s_6 * Ic_6_yz;
  c[132] = Scalar(2.0) * t8;
  const Scalar t9 = Scalar(0.0006277682991364491) * c_6 + s_6 * t1;
  const Scalar dmu_5_7_y = Scalar(0.0004826525849595559) * c_6 + s_6 * t2;
  const Scalar c_7_5_5 = c_6 * (t6 + db_57_7) + s_6 * (c_7 * t9 + s_7 * dmu_5_7_y);
  c[182] = c_7_5_5;
  const Scalar t10 = Scalar(0.384) * c_5;
  const Scalar t11 = Scalar(0.0825) * s_6 + c_6 * t10;
  const Scalar t12 = Scalar(0.0012868026856691014) * c_7 - Scalar(0.0010172199793308985) * s_7;
  const Scalar t13 = t12 * t11 + s_5 * t4 * (s_6 + Scalar(4.363636363636363));
  const Scalar t14 = s_5 * c_6;
  const Scalar t15 = c_7 * t14;
  const Scalar t16 = t15 - c_5 * s_7;
  const Scalar t17 = s_7 * t14;
  const Scalar w_4_7_y = t17 + c_5 * c_7;
  const Scalar t18 = Scalar(0.0006277682991364491) * t16 + Scalar(0.0004826525849595559) * w_4_7_y -
      t13;
  c[111] = Scalar(-2.0) * t18;
  const Scalar t19 = Scalar(0.088) * t12 + Scalar(0.003342075983680473);
  const Scalar t20 = s_6 * Iu_7_a_xz + c_6 * t19;
  const Scalar t21 = Scalar(0.0825) * c_6 - s_6 * t10;
  const Scalar t22 = s_5 * t20 - hu_7_t_y * t21;
  const Scalar v_o_4_7_y = Scalar(0.088) * c_5 - t21;
  const Scalar t23 = s_5 * s_6;
  const Scalar t24 = hu_7_t_y * v_o_4_7_y - Iu_7_a_xz * t23 + t16 * t3 - w_4_7_y * dmu_6_7_y;
  const Scalar c_6_4_7 = t22 - t24;
  c[164] = c_6_4_7;
  const Scalar t25 = c_6 * Iu_7_a_xz;
  const Scalar db_56_7r = t25 + s_6 * (c_7 * t3 - s_7 * dmu_6_7_y);
  const Scalar t26 = t25 - s_6 * t19;
  const Scalar c_6_5_7 = db_56_7r + t26;
  c[165] = c_6_5_7;
  const Scalar t27 = c_7 * t2;
  const Scalar t28 = t27 - Scalar(0.001210471889260615);
  const Scalar t29 = Scalar(0.176) * t12;
  const Scalar Ic_6_yy = t29 - Scalar(0.00264028154032624);
  const Scalar t30 = t28 - Ic_6_yy;
  const Scalar Ic_6_xy = Iu_7_a_xz + Scalar(0.007374285191337658);
  const Scalar t31 = Scalar(2.0) * Ic_6_xy;
  const Scalar t32 = c_6 * t30 - s_6 * t31;
  const Scalar t33 = s_6 * t32;
  const Scalar t34 = s_6 * t30 + c_6 * t31;
  const Scalar db_55_6r = t33 + c_6 * t34;
  c[131] = db_55_6r;
  c[137] = -c_7_5_5;
  const Scalar t35 = t12 + Scalar(0.1159237763475);
  const Scalar hu_6_t_x = Scalar(0.0869023527845) * s_6 + c_6 * t35;
  const Scalar t36 = s_5 * hu_6_t_x;
  const Scalar t37 = c_4 - Scalar(1.0);
  const Scalar v_o_3_5_z = Scalar(0.0825) * t37 + Scalar(0.384) * s_4;
  const Scalar t38 = v_o_3_5_z * t36;
  const Scalar t39 = s_4 * c_5;
  const Scalar t40 = c_4 * c_6 - s_6 * t39;
  const Scalar w_3_6_x = c_4 * s_6 + c_6 * t39;
  const Scalar t41 = t7 * t40 - Ic_6_yz * w_3_6_x + t38;
  c[76] = Scalar(2.0) * t41;
  const Scalar t42 = c_6 * Ic_6_yz + s_6 * t7;
  const Scalar t43 = Scalar(0.0869023527845) * t21 - t35 * t11;
  const Scalar t44 = t43 - s_5 * t42;
  c[104] = Scalar(-2.0) * t44;
  const Scalar t45 = Scalar(0.088) * s_4 + s_6 * v_o_3_5_z;
  const Scalar t46 = s_5 * t45;
  const Scalar t47 = s_4 * s_5;
  const Scalar w_3_7_x = c_7 * w_3_6_x + s_7 * t47;
  const Scalar t48 = c_7 * t47 - s_7 * w_3_6_x;
  const Scalar t49 = Iu_7_a_xz * t40;
  const Scalar t50 = t49 - hu_7_t_y * t46 + w_3_7_x * t3 + t48 * dmu_6_7_y;
  const Scalar t51 = hu_7_t_y * v_o_3_5_z * t23 + t49 - w_3_6_x * t19;
  const Scalar c_6_3_7 = t50 + t51;
  c[163] = c_6_3_7;
  c[110] = -t24 - t22;
  c[186] = -c_6_4_7;
  c[138] = db_56_7r - t26;
  c[187] = -c_6_5_7;
  c[154] = -db_55_6r;
  const Scalar t52 = Scalar(0.0012868026856691014) * v_o_4_7_y -
      Scalar(0.000391391281684248) * t16 + Scalar(0.0006277682991364491) * t23 -
      Scalar(0.001210471889260615) * w_4_7_y;
  const Scalar t53 = Scalar(0.0010172199793308985) * v_o_4_7_y -
      Scalar(0.000391391281684248) * w_4_7_y - Scalar(0.0004826525849595559) * t23 +
      Scalar(0.001210471889260615) * t16;
  const Scalar t54 = Scalar(0.0012868026856691014) * t16 - Scalar(0.0010172199793308985) * w_4_7_y;
  const Scalar c_7_4_4 = t23 * (t13 - t18) - v_o_4_7_y * t54 - t16 * t52 + w_4_7_y * t53;
  c[177] = c_7_4_4;
  const Scalar t55 = c_5 * v_o_3_5_z;
  const Scalar t56 = Scalar(0.088) * t40 - t55;
  const Scalar t57 = v_o_3_5_z * t15 + s_7 * t56;
  const Scalar t58 = Scalar(0.0012868026856691014) * t57 +
      Scalar(0.0010172199793308985) * (c_7 * t56 - v_o_3_5_z * t17);
  const Scalar db_37_7 = Scalar(0.0006277682991364491) * w_3_7_x -
      Scalar(0.0004826525849595559) * t48 + t58;
  c[83] = Scalar(2.0) * db_37_7;
  const Scalar t59 = s_3 * c_4;
  const Scalar t60 = c_3 * s_5;
  const Scalar w_2_5_x = t60 + c_5 * t59;
  const Scalar t61 = s_3 * s_4;
  const Scalar t62 = c_6 * w_2_5_x - s_6 * t61;
  const Scalar w_2_7_a_z = c_6 * t61 + s_6 * w_2_5_x;
  const Scalar t63 = Scalar(0.316) * c_4;
  const Scalar t64 = Scalar(0.0825) * s_4 - t63;
  const Scalar t65 = t64 - Scalar(0.384);
  const Scalar t66 = s_3 * (c_4 - Scalar(0.21484375) * s_4 + Scalar(0.8229166666666666));
  const Scalar v_2_6_a_z = t66 * t10 - t65 * t60;
  const Scalar f_u_6_6_t_x = Scalar(0.0869023527845) * c_6 - s_6 * t35;
  const Scalar t67 = f_u_6_6_t_x * v_2_6_a_z;
  const Scalar t68 = c_3 * c_5 - s_5 * t59;
  const Scalar t69 = t8 * t68;
  const Scalar t70 = t69 - t32 * t62 + w_2_7_a_z * t34 + t67;
  const Scalar t71 = t27 - t29 - Scalar(0.027504612894594268);
  const Scalar t72 = t71 * w_2_5_x - t69 + t67;
  const Scalar c_5_2_6 = t72 - t70;
  c[128] = c_5_2_6;
  c[82] = t50 - t51;
  c[185] = -c_6_3_7;
  const Scalar t73 = s_6 * (t12 * v_o_4_7_y + s_5 * db_57_7);
  const Scalar t74 = t73 + c_6 * t13 - t16 * t9 - w_4_7_y * dmu_5_7_y;
  const Scalar t75 = c_5 * t12 + hu_7_t_y * t14;
  const Scalar t76 = Scalar(0.384) * t75 - s_5 * Iu_7_a_xy - c_5 * t26;
  const Scalar c_5_4_7 = t76 - t74;
  c[136] = c_5_4_7;
  const Scalar t77 = t30 * t40 - Ic_6_yz * t47 - t31 * w_3_6_x + t35 * t55;
  const Scalar t78 = -t7 * t47 - t30 * w_3_6_x - t31 * t40 + Scalar(0.0869023527845) * t55;
  const Scalar t79 = Scalar(0.0869023527845) * t40 - t35 * w_3_6_x;
  const Scalar db_33_6r = t47 * (t38 + t41) + w_3_6_x * t77 - t40 * t78 - t55 * t79;
  c[73] = db_33_6r;
  c[108] = -c_7_4_4;
  const Scalar t80 = s_2 * c_3;
  const Scalar t81 = c_2 * s_4 - c_4 * t80;
  const Scalar t82 = s_2 * s_3;
  const Scalar t83 = s_5 * t82;
  const Scalar w_1_5_x = c_5 * t81 + t83;
  const Scalar w_1_4_y = c_2 * c_4 + s_4 * t80;
  const Scalar w_1_6_x = c_6 * w_1_5_x + s_6 * w_1_4_y;
  const Scalar t84 = c_6 * w_1_4_y - s_6 * w_1_5_x;
  const Scalar v_o_1_4_y = Scalar(0.0825) * c_2 + Scalar(0.316) * t80;
  const Scalar v_1_5_a_y = v_o_1_4_y - Scalar(0.0825) * w_1_4_y - Scalar(0.384) * t81;
  const Scalar t85 = c_5 * v_1_5_a_y + t65 * t83;
  const Scalar t86 = f_u_6_6_t_x * t85;
  const Scalar w_1_5_y = c_5 * t82 - s_5 * t81;
  const Scalar t87 = t8 * w_1_5_y;
  const Scalar db_15_6r = t32 * w_1_6_x - t87 + t84 * t34 + t86;
  const Scalar t88 = t71 * w_1_5_x - t87 - t86;
  const Scalar c_5_1_6 = t88 + db_15_6r;
  c[127] = c_5_1_6;
  c[47] = -t72 - t70;
  c[151] = -c_5_2_6;
  const Scalar t89 = s_5 * t8 + c_5 * t71;
  const Scalar t90 = f_u_6_6_t_x * t55;
  const Scalar t91 = s_4 * t89 + t90;
  const Scalar t92 = -t8 * t47 - t32 * w_3_6_x - t40 * t34 + t90;
  const Scalar c_5_3_6 = t91 - t92;
  c[129] = c_5_3_6;
  const Scalar t93 = t12 * t45 * t23 + c_6 * t58 + t40 * db_57_7 + w_3_7_x * t9 - t48 * dmu_5_7_y;
  const Scalar t94 = c_5 * Iu_7_a_xy - s_5 * t26;
  const Scalar t95 = c_5 * t5 - s_5 * t12;
  const Scalar t96 = s_4 * t94 - v_o_3_5_z * t95;
  const Scalar c_5_3_7 = t96 - t93;
  c[135] = c_5_3_7;
  c[109] = -t74 - t76;
  c[181] = -c_5_4_7;
  const Scalar df_3_7_z = Scalar(0.0012868026856691014) * w_3_7_x +
      Scalar(0.0010172199793308985) * t48;
  const Scalar t97 = Scalar(0.000391391281684248) * w_3_7_x + Scalar(0.0012868026856691014) * t46 +
      Scalar(0.0006277682991364491) * t40 - Scalar(0.001210471889260615) * t48;
  const Scalar t98 = Scalar(0.000391391281684248) * t48 - Scalar(0.0010172199793308985) * t46 +
      Scalar(0.0004826525849595559) * t40 + Scalar(0.001210471889260615) * w_3_7_x;
  const Scalar c_7_3_3 = df_3_7_z * t46 + t40 * (t58 + db_37_7) + w_3_7_x * t97 - t48 * t98;
  c[173] = c_7_3_3;
  const Scalar Ic_5_xz = Ic_6_xy - Scalar(0.002300122758781553) + t33;
  const Scalar t99 = c_5 * t65;
  const Scalar t100 = t82 * t99 - s_5 * v_1_5_a_y;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.007326866269);
  const Scalar f_5_5_x = hu_7_t_y - Scalar(0.0339353157125);
  const Scalar t101 = f_5_5_x * t85 + hc_5_x * t100;
  const Scalar t102 = t42 - Scalar(0.001082026026049065);
  const Scalar t103 = t102 * w_1_5_x + Ic_5_xz * w_1_5_y + t101;
  c[14] = Scalar(2.0) * t103;
  const Scalar t104 = c_3 * t99 + Scalar(0.384) * s_5 * t66;
  const Scalar t105 = hc_5_x * t104 - f_5_5_x * v_2_6_a_z;
  const Scalar t106 = t102 * w_2_5_x + Ic_5_xz * t68 + t105;
  c[42] = Scalar(2.0) * t106;
  const Scalar hu_5_t_x = s_5 * f_5_5_x + c_5 * hc_5_x;
  const Scalar db_45_5 = -s_5 * t102 - c_5 * Ic_5_xz + Scalar(0.384) * hu_5_t_x;
  c[98] = Scalar(2.0) * db_45_5;
  c[19] = db_15_6r - t88;
  c[150] = -c_5_1_6;
  c[145] = -db_33_6r;
  c[75] = -t91 - t92;
  c[152] = -c_5_3_6;
  c[81] = -t93 - t96;
  c[180] = -c_5_3_7;
  const Scalar t107 = c_6 * t32;
  const Scalar t108 = Scalar(0.384) * f_u_6_6_t_x;
  const Scalar t109 = c_5 * t8;
  const Scalar t110 = t109 - s_5 * (t107 - s_6 * t34 - t108);
  const Scalar t111 = s_5 * (t71 + t108) - t109;
  c[103] = t110 + t111;
  const Scalar c_6_4_5 = t111 - t110;
  c[153] = c_6_4_5;
  c[79] = -c_7_3_3;
  const Scalar t112 = Scalar(0.0825) * c_4 + Scalar(0.316) * s_4;
  const Scalar t113 = t112 - Scalar(0.0825);
  const Scalar t114 = t113 * t82;
  const Scalar t115 = s_6 * t114 + c_6 * t100;
  const Scalar t116 = c_6 * t114 - s_6 * t100;
  const Scalar t117 = Scalar(0.0869023527845) * t116 - t35 * t115;
  const Scalar t118 = Ic_6_yz * w_1_6_x - t7 * t84 + t117;
  c[20] = Scalar(-2.0) * t118;
  const Scalar t119 = c_3 * t113;
  const Scalar t120 = s_6 * t119 + c_6 * t104;
  const Scalar t121 = c_6 * t119 - s_6 * t104;
  const Scalar t122 = Scalar(0.0869023527845) * t121 - t35 * t120;
  const Scalar t123 = t7 * w_2_7_a_z + Ic_6_yz * t62 + t122;
  c[48] = Scalar(-2.0) * t123;
  const Scalar v_1_7_a_z = Scalar(0.088) * w_1_5_y + t116;
  const Scalar t124 = c_7 * w_1_6_x - s_7 * w_1_5_y;
  const Scalar t125 = c_7 * w_1_5_y + s_7 * w_1_6_x;
  const Scalar t126 = Iu_7_a_xz * t84;
  const Scalar t127 = hu_7_t_y * v_1_7_a_z + t126 + t124 * t3 - t125 * dmu_6_7_y;
  const Scalar t128 = hu_7_t_y * t116 - t126 + w_1_6_x * t19;
  c[26] = t127 + t128;
  const Scalar c_7_1_6 = t128 - t127;
  c[183] = c_7_1_6;
  const Scalar t129 = Scalar(0.088) * t68 + t121;
  const Scalar w_2_7_x = c_7 * t62 - s_7 * t68;
  const Scalar t130 = c_7 * t68 + s_7 * t62;
  const Scalar t131 = Iu_7_a_xz * w_2_7_a_z;
  const Scalar t132 = t131 - hu_7_t_y * t129 - w_2_7_x * t3 + t130 * dmu_6_7_y;
  const Scalar t133 = hu_7_t_y * t121 + t131 + t62 * t19;
  c[54] = t133 - t132;
  const Scalar c_7_2_6 = t132 + t133;
  c[184] = c_7_2_6;
  const Scalar t134 = c_5 * Ic_6_yz + s_5 * (Scalar(0.384) * t35 - t34);
  const Scalar t135 = s_5 * (t32 - Scalar(0.033370503469248)) - c_5 * t7;
  const Scalar t136 = t47 * t44 + t40 * t135 + w_3_6_x * t134;
  const Scalar t137 = Scalar(0.0825) * f_u_6_6_t_x;
  const Scalar t138 = s_5 * t137;
  const Scalar t139 = t42 - t138;
  const Scalar t140 = s_4 * t139 + c_4 * t111;
  const Scalar c_4_3_6 = t140 - t136;
  c[101] = c_4_3_6;
  const Scalar t141 = s_5 * (s_6 * t58 - t45 * t54);
  const Scalar t142 = t40 * t18 - t141 - w_3_7_x * t52 - t48 * t53;
  const Scalar t143 = Scalar(0.0825) * t75;
  const Scalar t144 = t20 - t143;
  const Scalar t145 = c_4 * t76 + s_4 * t144;
  c[80] = t142 + t145;
  const Scalar c_7_3_4 = t145 - t142;
  c[176] = c_7_3_4;
  c[130] = -c_6_4_5;
  const Scalar Iu_6_t_xx = Ic_6_yy + t107;
  const Scalar t146 = t71 + Scalar(0.021040501090947756);
  const Scalar Iu_5_t_d = Iu_6_t_xx + t146;
  const Scalar t147 = t8 + Scalar(0.000757622236663515);
  const Scalar t148 = Scalar(-2.0) * t147;
  const Scalar t149 = t148 * w_1_5_x - t102 * w_1_4_y + hc_5_x * t114 - Iu_5_t_d * w_1_5_y;
  const Scalar t150 = t148 * w_1_5_y + f_5_5_x * t114 + Ic_5_xz * w_1_4_y + Iu_5_t_d * w_1_5_x;
  const Scalar t151 = t114 * (hc_5_x * w_1_5_x - f_5_5_x * w_1_5_y);
  const Scalar c_1_1_5 = w_1_5_y * t150 - t151 - w_1_5_x * t149 + w_1_4_y * (t101 + t103);
  c[10] = c_1_1_5;
  const Scalar t152 = t102 * t61 + t148 * w_2_5_x + hc_5_x * t119 - Iu_5_t_d * t68;
  const Scalar t153 = t148 * t68 + f_5_5_x * t119 - Ic_5_xz * t61 + Iu_5_t_d * w_2_5_x;
  const Scalar df_2_5_z = hc_5_x * w_2_5_x - f_5_5_x * t68;
  const Scalar c_5_2_2 = t119 * df_2_5_z - t68 * t153 + t61 * (t105 + t106) + w_2_5_x * t152;
  c[114] = c_5_2_2;
  const Scalar t154 = s_5 * (Scalar(0.384) * t36 + c_6 * t134 - s_6 * t135);
  const Scalar c_4_4_6 = t154 - c_5 * (t43 + t44);
  c[102] = c_4_4_6;
  const Scalar t155 = Scalar(0.088) * t84 + t85;
  const Scalar t156 = c_7 * t115 + s_7 * t155;
  const Scalar t157 = Scalar(0.0010172199793308985) * (c_7 * t155 - s_7 * t115) +
      Scalar(0.0012868026856691014) * t156;
  const Scalar t158 = Scalar(0.0006277682991364491) * t124 + Scalar(0.0004826525849595559) * t125 +
      t157;
  c[27] = Scalar(2.0) * t158;
  const Scalar v_o_2_7_z = Scalar(0.088) * w_2_7_a_z + v_2_6_a_z;
  const Scalar t159 = c_7 * t120 - s_7 * v_o_2_7_z;
  const Scalar t160 = Scalar(0.0012868026856691014) * t159 -
      Scalar(0.0010172199793308985) * (c_7 * v_o_2_7_z + s_7 * t120);
  const Scalar db_27_7 = Scalar(0.0006277682991364491) * w_2_7_x +
      Scalar(0.0004826525849595559) * t130 + t160;
  c[55] = Scalar(2.0) * db_27_7;
  const Scalar t161 = c_5 * t102 - s_5 * Ic_5_xz;
  const Scalar t162 = c_5 * f_5_5_x - s_5 * hc_5_x;
  const Scalar t163 = t162 * v_o_3_5_z;
  const Scalar t164 = s_4 * t161 - t163;
  c[70] = Scalar(2.0) * t164;
  const Scalar t165 = t84 * t135 - w_1_5_y * t44 + c_5 * t117 - t85 * t36 + w_1_6_x * t134;
  const Scalar t166 = c_5 * f_u_6_6_t_x;
  const Scalar t167 = hu_6_t_x * t64 - t112 * t166;
  const Scalar t168 = t81 * t139 - t82 * t167 + w_1_4_y * t111;
  const Scalar c_4_1_6 = t168 - t165;
  c[99] = c_4_1_6;
  c[161] = -c_7_1_6;
  const Scalar t169 = c_4 * t166 - s_4 * hu_6_t_x;
  const Scalar t170 = f_u_6_6_t_x * t60 + s_3 * t169;
  const Scalar t171 = t89 - Scalar(0.0825) * (f_u_6_6_t_x * t39 + hu_6_t_x * t37) +
      f_u_6_6_t_x * t10;
  const Scalar t172 = Scalar(0.316) * t170 + c_3 * t140 + s_3 * t171;
  const Scalar t173 = t68 * t41 - t62 * t77 - w_2_7_a_z * t78 + t47 * t122 + v_2_6_a_z * t79;
  const Scalar c_3_2_6 = t172 - t173;
  c[72] = c_3_2_6;
  const Scalar t174 = c_4 * t139 - s_4 * t111;
  const Scalar t175 = s_3 * t174 - c_3 * t167;
  const Scalar t176 = c_5 * t122 - w_2_7_a_z * t135 - t68 * t44 + v_2_6_a_z * t36 + t62 * t134;
  const Scalar c_4_2_6 = t175 - t176;
  c[100] = c_4_2_6;
  c[162] = -c_7_2_6;
  c[74] = -t140 - t136;
  c[148] = -c_4_3_6;
  c[107] = -c_7_3_4;
  c[112] = -c_1_1_5;
  c[39] = -c_5_2_2;
  const Scalar t177 = c_5 * t148 + s_5 * Iu_5_t_d;
  const Scalar dmu_4_5_y = Scalar(0.0825) * f_5_5_x - t177;
  const Scalar t178 = c_5 * Iu_5_t_d - s_5 * t148;
  const Scalar t179 = Scalar(0.0825) * hc_5_x + t178;
  const Scalar t180 = Scalar(-0.0825) * t162;
  const Scalar c_4_4_5 = t180 - c_5 * dmu_4_5_y + s_5 * t179;
  c[97] = c_4_4_5;
  const Scalar t181 = t85 * (Scalar(0.0869023527845) * t84 - t35 * w_1_6_x);
  const Scalar t182 = -Ic_6_yz * w_1_5_y - t30 * t84 + t31 * w_1_6_x + t35 * t85;
  const Scalar t183 = t30 * w_1_6_x - t7 * w_1_5_y + t31 * t84 + Scalar(0.0869023527845) * t85;
  const Scalar c_1_1_6 = t84 * t183 + w_1_5_y * (t117 + t118) + t181 - w_1_6_x * t182;
  c[15] = c_1_1_6;
  const Scalar df_2_6_z = Scalar(0.0869023527845) * w_2_7_a_z + t35 * t62;
  const Scalar t184 = Ic_6_yz * t68 - t30 * w_2_7_a_z - t31 * t62 + t35 * v_2_6_a_z;
  const Scalar t185 = t7 * t68 - t30 * t62 + t31 * w_2_7_a_z + Scalar(0.0869023527845) * v_2_6_a_z;
  const Scalar c_2_2_6 = w_2_7_a_z * t185 + t68 * (t122 + t123) + v_2_6_a_z * df_2_6_z + t62 * t184;
  c[44] = c_2_2_6;
  c[149] = -c_4_4_6;
  const Scalar t186 = t40 * t157 - v_1_7_a_z * df_3_7_z + t84 * db_37_7 + t124 * t97 + t125 * t98;
  const Scalar t187 = s_6 * hu_7_t_y;
  const Scalar t188 = c_4 * t95 - s_4 * t187;
  const Scalar t189 = s_3 * t75 - c_3 * t188;
  const Scalar t190 = Scalar(0.0825) * (s_4 * t95 + t37 * t187) - Scalar(0.384) * t95 + t94;
  const Scalar t191 = s_2 * (Scalar(0.316) * t189 + c_3 * t190 + s_3 * t145);
  const Scalar c_7_1_3 = t186 + t191;
  c[171] = c_7_1_3;
  c[18] = -t168 - t165;
  c[146] = -c_4_1_6;
  const Scalar t192 = t157 * t23 + v_1_7_a_z * t54 - t84 * t18 + t124 * t52 - t125 * t53;
  const Scalar t193 = t64 * t187 - t112 * t95;
  const Scalar t194 = t81 * t144 - t82 * t193 + w_1_4_y * t76;
  c[24] = t194 - t192;
  const Scalar c_7_1_4 = t192 + t194;
  c[174] = c_7_1_4;
  const Scalar t195 = s_6 * t12;
  const Scalar t196 = t84 * db_57_7 - v_1_7_a_z * t195 + c_6 * t157 + t124 * t9 + t125 * dmu_5_7_y;
  const Scalar t197 = t85 * t5 + t12 * t100 + Iu_7_a_xy * w_1_5_x + w_1_5_y * t26;
  const Scalar c_5_1_7 = t197 - t196;
  c[133] = c_5_1_7;
  c[45] = -t172 - t173;
  c[144] = -c_3_2_6;
  const Scalar t198 = t40 * t160 - t129 * df_3_7_z - w_2_7_a_z * db_37_7 + w_2_7_x * t97 +
      t130 * t98;
  const Scalar t199 = c_3 * t75 + s_3 * t188;
  const Scalar t200 = Scalar(0.316) * t199 + c_3 * t145 - s_3 * t190;
  c[51] = t200 - t198;
  const Scalar c_7_2_3 = t198 + t200;
  c[172] = c_7_2_3;
  c[46] = -t175 - t176;
  c[147] = -c_4_2_6;
  const Scalar t201 = t160 * t23 + t129 * t54 + w_2_7_a_z * t18 + w_2_7_x * t52 - t130 * t53;
  const Scalar t202 = c_4 * t144 - s_4 * t76;
  const Scalar t203 = s_3 * t202 - c_3 * t193;
  c[52] = t203 - t201;
  const Scalar c_7_2_4 = t201 + t203;
  c[175] = c_7_2_4;
  const Scalar t204 = -w_2_7_a_z * db_57_7 - t129 * t195 + c_6 * t160 + w_2_7_x * t9 +
      t130 * dmu_5_7_y;
  const Scalar t205 = t12 * t104 - v_2_6_a_z * t5 + Iu_7_a_xy * w_2_5_x + t68 * t26;
  const Scalar c_5_2_7 = t205 - t204;
  c[134] = c_5_2_7;
  c[121] = -c_4_4_5;
  c[140] = -c_1_1_6;
  c[142] = -c_2_2_6;
  const Scalar t206 = v_1_7_a_z * (Scalar(0.0012868026856691014) * t124 -
      Scalar(0.0010172199793308985) * t125);
  const Scalar t207 = Scalar(0.000391391281684248) * t124 + Scalar(0.0006277682991364491) * t84 -
      Scalar(0.0012868026856691014) * v_1_7_a_z + Scalar(0.001210471889260615) * t125;
  const Scalar t208 = Scalar(0.0010172199793308985) * v_1_7_a_z -
      Scalar(0.000391391281684248) * t125 + Scalar(0.0004826525849595559) * t84 +
      Scalar(0.001210471889260615) * t124;
  const Scalar c_7_1_1 = t84 * (t157 + t158) - t206 + t124 * t207 + t125 * t208;
  c[168] = c_7_1_1;
  const Scalar dmu_2_7_x = Scalar(0.0006277682991364491) * w_2_7_a_z -
      Scalar(0.000391391281684248) * w_2_7_x + Scalar(0.0012868026856691014) * t129 -
      Scalar(0.001210471889260615) * t130;
  const Scalar t209 = Scalar(0.000391391281684248) * t130 +
      Scalar(0.0004826525849595559) * w_2_7_a_z - Scalar(0.0010172199793308985) * t129 -
      Scalar(0.001210471889260615) * w_2_7_x;
  const Scalar df_2_7_z = Scalar(0.0012868026856691014) * w_2_7_x -
      Scalar(0.0010172199793308985) * t130;
  const Scalar db_22_7r = t129 * df_2_7_z + w_2_7_a_z * (t160 + db_27_7) + w_2_7_x * dmu_2_7_x +
      t130 * t209;
  c[50] = db_22_7r;
  const Scalar mu_6_3_z = t138 + t174;
  const Scalar t210 = c_2 * t172 - s_2 * mu_6_3_z;
  const Scalar t211 = t68 * t117 - t84 * t185 + w_1_5_y * t123 - t85 * df_2_6_z + w_1_6_x * t184;
  c[16] = t210 + t211;
  const Scalar c_6_1_2 = t210 - t211;
  c[141] = c_6_1_2;
  const Scalar t212 = w_2_7_a_z * t157 + v_1_7_a_z * df_2_7_z - t84 * db_27_7 + t124 * dmu_2_7_x +
      t125 * t209;
  const Scalar mu_u_7_3_a_y = t143 + t202;
  const Scalar t213 = c_2 * t200 - s_2 * mu_u_7_3_a_y;
  const Scalar c_2_1_7 = t212 + t213;
  c[49] = c_2_1_7;
  const Scalar t214 = s_3 * (t140 + Scalar(0.316) * s_5 * f_u_6_6_t_x);
  const Scalar t215 = s_2 * (c_3 * (Scalar(0.316) * t169 + t171) - t214);
  const Scalar t216 = t47 * t117 + w_1_5_y * t41 - w_1_6_x * t77 + t84 * t78 - t85 * t79;
  const Scalar c_6_1_3 = t215 + t216;
  c[143] = c_6_1_3;
  c[23] = t191 - t186;
  c[77] = -c_7_1_3;
  const Scalar t217 = db_45_5 * w_1_4_y;
  const Scalar db_14_5r = w_1_5_y * dmu_4_5_y - t162 * t114 - w_1_5_x * t179 + t217;
  const Scalar t218 = t28 - t107 + Scalar(0.02249165715597447);
  const Scalar t219 = Scalar(0.0825) * hu_5_t_x;
  const Scalar t220 = t218 - t219;
  const Scalar t221 = t162 * t112;
  const Scalar t222 = t82 * t221 + t81 * t220 + t217;
  const Scalar c_4_1_5 = t222 + db_14_5r;
  c[94] = c_4_1_5;
  c[105] = -c_7_1_4;
  c[25] = -t196 - t197;
  c[178] = -c_5_1_7;
  c[78] = -c_7_2_3;
  const Scalar t223 = c_4 * t220 - s_4 * db_45_5;
  const Scalar t224 = c_3 * t221 + s_3 * t223;
  const Scalar t225 = t162 * t119 + db_45_5 * t61 - t68 * dmu_4_5_y + w_2_5_x * t179;
  const Scalar c_4_2_5 = t224 - t225;
  c[95] = c_4_2_5;
  c[106] = -c_7_2_4;
  c[53] = -t204 - t205;
  c[179] = -c_5_2_7;
  c[21] = -c_7_1_1;
  c[170] = -db_22_7r;
  const Scalar t226 = t147 + Scalar(0.00195267751313805) - t180 - s_5 * t178;
  const Scalar t227 = Scalar(0.384) * t162 - t161;
  const Scalar t228 = Scalar(0.000822243788684635) + t227;
  const Scalar hc_4_x = hu_5_t_x - Scalar(0.276390137325);
  const Scalar f_4_4_x = f_u_6_6_t_x - Scalar(1.0062617768015);
  const Scalar t229 = hc_4_x * t64 - f_4_4_x * t112;
  const Scalar t230 = t82 * t229;
  const Scalar t231 = t226 * w_1_4_y + t228 * t81 + t230;
  c[9] = Scalar(2.0) * t231;
  const Scalar t232 = c_4 * t226 + s_4 * t228;
  c[65] = Scalar(2.0) * t232;
  c[43] = -c_6_1_2;
  c[22] = t212 - t213;
  c[169] = -c_2_1_7;
  c[17] = t215 - t216;
  c[71] = -c_6_1_3;
  c[13] = db_14_5r - t222;
  c[118] = -c_4_1_5;
  c[41] = -t224 - t225;
  c[119] = -c_4_2_5;
  const Scalar t233 = s_4 * t177 - c_4 * t102;
  const Scalar t234 = c_4 * Ic_5_xz + s_4 * t178;
  const Scalar c_5_3_3 = s_4 * (c_5 * t233 + s_5 * t234) + c_4 * (t163 - t164);
  c[117] = c_5_3_3;
  const Scalar t235 = c_4 * db_45_5;
  const Scalar t236 = t235 + s_4 * t220;
  const Scalar t237 = s_4 * t180 + t227;
  const Scalar t238 = c_3 * hu_5_t_x + t162 * t59;
  const Scalar t239 = Scalar(0.316) * t238 + c_3 * t236 + s_3 * t237;
  const Scalar mu_5_3_z = t219 + t223;
  const Scalar t240 = c_2 * t239 - s_2 * mu_5_3_z;
  const Scalar t241 = t114 * df_2_5_z + t61 * t101 + w_1_5_x * t152 - w_1_5_y * t153 -
      w_1_4_y * t106;
  c[11] = t240 - t241;
  const Scalar c_5_1_2 = t240 + t241;
  c[113] = c_5_1_2;
  const Scalar t242 = s_3 * (Scalar(0.316) * hu_5_t_x + t236) - c_3 * (t237 + t162 * t63);
  const Scalar t243 = s_2 * t242;
  const Scalar t244 = w_1_4_y * t164 - s_4 * hu_5_t_x * t114 - w_1_5_x * t233 + w_1_5_y * t234 +
      c_4 * t101;
  c[12] = t244 - t243;
  const Scalar c_3_1_5 = t244 + t243;
  c[66] = c_3_1_5;
  const Scalar t245 = s_4 * (s_3 * t164 + hu_5_t_x * t119);
  const Scalar t246 = t245 + w_2_5_x * t233 - t68 * t234 - c_4 * t105;
  const Scalar c_3_2_5 = t239 - t246;
  c[67] = c_3_2_5;
  const Scalar t247 = t235 - s_4 * (c_5 * t179 + s_5 * dmu_4_5_y);
  const Scalar c_4_3_5 = t236 + t247;
  c[96] = c_4_3_5;
  const Scalar t248 = c_5 * t178;
  const Scalar t249 = Scalar(0.768) * f_u_6_6_t_x;
  const Scalar t250 = t146 - t248 + t249;
  const Scalar t251 = Scalar(0.165) * hu_5_t_x;
  const Scalar t252 = t218 - t251 - Scalar(0.34490204856053924);
  const Scalar t253 = t250 + t252;
  const Scalar t254 = t137 + db_45_5 - Scalar(0.08142043634273043);
  const Scalar t255 = Scalar(2.0) * t254;
  const Scalar t256 = t228 * t82 + hc_4_x * v_o_1_4_y - t255 * t81 + t253 * w_1_4_y;
  const Scalar t257 = -t226 * t82 - t255 * w_1_4_y + f_4_4_x * v_o_1_4_y - t253 * t81;
  const Scalar t258 = v_o_1_4_y * (hc_4_x * t81 - f_4_4_x * w_1_4_y);
  const Scalar c_4_1_1 = t82 * (t230 + t231) + t258 + t81 * t256 - w_1_4_y * t257;
  c[84] = c_4_1_1;
  c[68] = -c_5_3_3;
  const Scalar Iu_4_a_xy = c_4 * t228 - s_4 * t226;
  const Scalar t259 = c_3 * t229;
  const Scalar t260 = s_3 * Iu_4_a_xy + t259;
  c[37] = Scalar(2.0) * t260;
  c[38] = -c_5_1_2;
  c[115] = -c_3_1_5;
  c[40] = -t246 - t239;
  c[116] = -c_3_2_5;
  c[69] = t247 - t236;
  c[120] = -c_4_3_5;
  c[6] = -c_4_1_1;
  const Scalar t261 = c_4 * t255 + s_4 * t253;
  const Scalar dmu_3_4_y = Scalar(0.0825) * f_4_4_x - t261;
  const Scalar t262 = c_4 * t253 - s_4 * t255;
  const Scalar t263 = Scalar(0.0825) * hc_4_x + t262;
  const Scalar t264 = c_4 * f_4_4_x - s_4 * hc_4_x;
  const Scalar t265 = Scalar(-0.0825) * t264;
  const Scalar c_4_3_3 = t265 - c_4 * dmu_3_4_y + s_4 * t263;
  c[89] = c_4_3_3;
  c[64] = -c_4_3_3;
  const Scalar t266 = t232 * t82;
  const Scalar t267 = t266 - t264 * v_o_1_4_y + t81 * t263 - w_1_4_y * dmu_3_4_y;
  const Scalar t268 = Iu_6_t_xx - t251 - t248 - t249 + Scalar(0.39592218471735474);
  const Scalar t269 = Scalar(-0.316) * t264;
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * f_4_4_x;
  const Scalar t270 = Scalar(0.0825) * hu_4_t_x + t269 + t268;
  const Scalar t271 = t80 * t270 - t266;
  const Scalar c_3_1_4 = t271 - t267;
  c[62] = c_3_1_4;
  const Scalar t272 = Scalar(0.002743824053281128) + t265 + t254 + s_4 * t262;
  const Scalar Ic_3_yz = Iu_4_a_xy - Scalar(0.002188628560919792);
  const Scalar hc_3_x = Scalar(0.373428979936) + hu_4_t_x;
  const Scalar t273 = t162 - Scalar(0.014113547439);
  const Scalar t274 = Scalar(-0.316) * (c_3 * t273 - s_3 * hc_3_x);
  const Scalar t275 = c_3 * Ic_3_yz - s_3 * t272 - t274;
  const Scalar t276 = Scalar(2.0) * s_2;
  c[5] = t275 * t276;
  const Scalar t277 = s_3 * t273 + c_3 * hc_3_x;
  const Scalar t278 = s_3 * Ic_3_yz + Scalar(0.316) * t277 + c_3 * t272;
  c[33] = Scalar(-2.0) * t278;
  c[8] = -t271 - t267;
  c[87] = -c_3_1_4;
  const Scalar t279 = c_4 * t262;
  const Scalar t280 = Scalar(0.165) * hu_4_t_x;
  const Scalar t281 = t280 + t268 - Scalar(0.35069998060812224);
  const Scalar t282 = t252 - t279 - t281;
  const Scalar t283 = Scalar(0.000060956210475372) + t180 + t232;
  const Scalar t284 = Scalar(2.0) * t283;
  const Scalar t285 = s_3 * t284 + c_3 * t282;
  const Scalar t286 = s_3 * t285;
  const Scalar t287 = c_3 * t284 - s_3 * t282;
  const Scalar db_22_3r = t286 - c_3 * t287;
  c[32] = db_22_3r;
  const Scalar t288 = s_3 * (s_2 * t260 + hu_4_t_x * v_o_1_4_y);
  const Scalar t289 = s_3 * (Scalar(0.316) * hc_4_x + t261) - c_3 * t228;
  const Scalar t290 = c_3 * t226 + s_3 * (Scalar(0.316) * f_4_4_x + t262);
  const Scalar t291 = t288 + t82 * t259 - t81 * t289 + w_1_4_y * t290;
  const Scalar t292 = c_3 * t232;
  const Scalar t293 = t292 + s_3 * t270;
  const Scalar t294 = c_2 * t293 - s_2 * Iu_4_a_xy;
  const Scalar c_2_1_4 = t294 - t291;
  c[34] = c_2_1_4;
  const Scalar t295 = t292 - s_3 * (t269 - c_4 * t263 - s_4 * dmu_3_4_y);
  c[36] = t293 - t295;
  const Scalar c_4_2_3 = t293 + t295;
  c[88] = c_4_2_3;
  c[58] = -db_22_3r;
  const Scalar t296 = s_3 * (c_4 * t289 + s_4 * t290 + Scalar(0.316) * s_3 * hu_4_t_x);
  const Scalar db_22_4r = t296 - c_3 * (t259 + t260);
  c[35] = db_22_4r;
  c[7] = -t294 - t291;
  c[85] = -c_2_1_4;
  c[63] = -c_4_2_3;
  c[86] = -db_22_4r;
  c[2] = Scalar(2.0) * (c_2 * (t283 - Scalar(0.005130550910504085) - t286) -
      s_2 * (t275 - Scalar(0.0003844680514732)));
  const Scalar t297 = c_3 * t285;
  const Scalar t298 = c_2 * t278;
  const Scalar t299 = t298 + s_2 * (t297 + s_3 * t287);
  const Scalar t300 = t250 - t280 - t279 - Scalar(0.41230240163465);
  const Scalar t301 = t298 + s_2 * t300;
  c[4] = t301 - t299;
  const Scalar c_3_1_2 = t301 + t299;
  c[57] = c_3_1_2;
  const Scalar t302 = Scalar(0.632) * t264 - t300 - t297 - t281 - Scalar(0.8860432804898606);
  const Scalar t303 = t278 - Scalar(0.00199167944196776);
  const Scalar t304 = c_2 * (Scalar(2.0) * c_2 * t303 - s_2 * t302);
  const Scalar c_2_1_1 = s_2 * (t303 * t276 + c_2 * t302) - t304;
  c[28] = c_2_1_1;
  const Scalar t305 = c_3 * (c_2 * Ic_3_yz + s_2 * t287);
  const Scalar t306 = t305 - s_3 * (c_2 * t272 + s_2 * t285);
  const Scalar c_1_1_3 = s_2 * (t306 - c_2 * (t274 - t275));
  c[3] = c_1_1_3;
  c[31] = -c_3_1_2;
  c[1] = -c_2_1_1;
  c[56] = -c_1_1_3;
  c[0] = c[29] = c[30] = c[59] = c[60] = c[61] = c[90] = c[91] = Scalar(0.0);
  c[92] = c[93] = c[122] = c[123] = c[124] = c[125] = c[126] = c[155] = Scalar(0.0);
  c[156] = c[157] = c[158] = c[159] = c[160] = c[189] = c[190] = c[191] = Scalar(0.0);
  c[192] = c[193] = c[194] = c[195] = Scalar(0.0);
}

// The entries of C in coriolis_matrix that are not always zero.
inline constexpr bool coriolis_matrix_nonzero[49] = {
    1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 0};

// C(q, qd) from the Christoffel symbols (7.44).
//   q[7]   in   joint positions, rad or m
//   qd[7]  in   joint velocities, rad/s or m/s
//   C[49]  out  c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric
//               7 x 7, row by row: entry (i, j) is C[7 * i + j]
// Reads q[1..6], qd[0..6]. Operations: 808 mul, 667 add, 12 sin/cos. Always zero: 1 of the 49
// entries of C.
template <class Scalar, class SinCos = LibrarySinCos>
inline void coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5],
      s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = s_2 * qd_1;
  const Scalar t2 = c_3 * t1 - s_3 * qd_2;
  const Scalar t3 = c_2 * qd_1;
  const Scalar omega_3_z = qd_3 + t3;
  const Scalar t4 = c_4 * t2 - s_4 * omega_3_z;
  const Scalar omega_r_3_y = s_3 * t1 + c_3 * qd_2;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar t5 = c_5 * t4 + s_5 * omega_4_z;
  const Scalar t6 = s_4 * t2 + c_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 + t6;
  const Scalar t7 = c_6 * t5 - s_6 * omega_5_z;
  const Scalar omega_r_6_a_z = c_5 * omega_4_z - s_5 * t4;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t8 = c_7 * omega_6_z + s_7 * t7;
  const Scalar t9 = Scalar(-0.000195695640842124) * t8;
  const Scalar t10 = c_7 * t7 - s_7 * omega_6_z;
  const Scalar omega_r_6_y = c_6 * omega_5_z + s_6 * t5;
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar t11 = Scalar(0.0004826525849595559) * omega_7_z;
  const Scalar t12 = t9 + t11 + Scalar(0.001210471889260615) * t10;
  const Scalar t13 = t9 - t11 + Scalar(0.003342075983680473) * t10;
  const Scalar t14 = Scalar(0.000391391281684248) * t8 - t12 + t13;
  const Scalar t15 = Scalar(-0.000195695640842124) * t10;
  const Scalar t16 = Scalar(0.0006277682991364491) * omega_7_z;
  const Scalar t17 = t16 - t15;
  const Scalar t18 = t15 + t16 + Scalar(0.002131604094419858) * t8;
  const Scalar t19 = Scalar(0.000391391281684248) * t10 + t17 + Scalar(0.00242094377852123) * t8 +
      t18;
  const Scalar t20 = Scalar(0.002573605371338203) * t10 - Scalar(0.002034439958661797) * t8;
  const Scalar dtau_qd6_7 = Scalar(0.088) * t20 + c_7 * t14 + s_7 * t19;
  C[41] = dtau_qd6_7;
  const Scalar t21 = t12 + t13;
  const Scalar t22 = t17 - t18;
  const Scalar hu_7_t_y = Scalar(0.0010172199793308985) * c_7 + Scalar(0.0012868026856691014) * s_7;
  const Scalar t23 = Scalar(0.176) * hu_7_t_y;
  const Scalar t24 = omega_6_z * t23 - s_7 * t22 + c_7 * t21;
  const Scalar Iu_7_a_xz = Scalar(0.0004826525849595559) * c_7 -
      Scalar(0.0006277682991364491) * s_7;
  const Scalar hu_7_t_x = Scalar(0.0012868026856691014) * c_7 - Scalar(0.0010172199793308985) * s_7;
  const Scalar t25 = Scalar(0.088) * hu_7_t_x;
  const Scalar t26 = t25 + Scalar(0.003342075983680473);
  C[47] = t24 - Scalar(2.0) * (omega_r_6_y * Iu_7_a_xz + t7 * t26);
  const Scalar mu_u_qd7_7_t_x = c_7 * t19 - s_7 * t14;
  const Scalar t27 = omega_7_z * hu_7_t_y;
  const Scalar t28 = Scalar(0.176) * t27;
  const Scalar mu_u_qd7_6_t_y = c_6 * t28 + s_6 * mu_u_qd7_7_t_x;
  C[34] = mu_u_qd7_6_t_y;
  const Scalar t29 = Scalar(-0.0009653051699191118) * t8;
  const Scalar t30 = Scalar(0.000391391281684248) * omega_7_z;
  const Scalar t31 = t30 - t29;
  const Scalar t32 = Scalar(-0.0012555365982728983) * t10;
  const Scalar t33 = t30 + t32;
  const Scalar t34 = Scalar(-0.0006277682991364491) * t8;
  const Scalar t35 = Scalar(-0.0004826525849595559) * t10;
  const Scalar t36 = t34 + t35 + Scalar(0.001210471889260615) * omega_7_z;
  const Scalar t37 = c_7 * (t31 + t33) + Scalar(2.0) * s_7 * t36;
  const Scalar t38 = c_7 * t37;
  const Scalar t39 = Scalar(-0.000093569097314605) * t7;
  const Scalar t40 = Scalar(0.000103758917218685) * omega_r_6_y + t39 - t28 - t31 + t38;
  const Scalar Iu_7_t_g = Scalar(0.001210471889260615) * c_7 - Scalar(0.000391391281684248) * s_7;
  const Scalar t41 = Scalar(0.088) * hu_7_t_y;
  const Scalar t42 = Scalar(0.0001438161822327815) - t41 + s_7 * Iu_7_t_g;
  const Scalar Iu_7_a_xy = Scalar(0.0006277682991364491) * c_7 +
      Scalar(0.0004826525849595559) * s_7;
  const Scalar Ic_6_yz = Scalar(0.0000467845486573025) + Iu_7_a_xy;
  const Scalar C_66 = Scalar(2.0) * (omega_r_6_y * t42 + t7 * Ic_6_yz) + t40;
  C[40] = C_66;
  const Scalar t43 = Scalar(0.176) * hu_7_t_x;
  const Scalar t44 = c_7 * t22 - omega_6_z * t43 + s_7 * t21;
  const Scalar t45 = omega_r_6_y * t23 + (t29 + t32);
  const Scalar t46 = c_6 * t45 - s_6 * t44;
  const Scalar t47 = c_6 * Iu_7_a_xz - s_6 * t26;
  C[46] = t46 + Scalar(2.0) * (t5 * Iu_7_a_xy + omega_r_6_a_z * t47);
  const Scalar t48 = c_6 * mu_u_qd7_7_t_x - s_6 * t28;
  const Scalar t49 = omega_7_z * hu_7_t_x;
  const Scalar t50 = Scalar(2.0) * c_6 * t49 + s_6 * t20;
  const Scalar t51 = Scalar(2.0) * s_5;
  const Scalar t52 = c_5 * t50 + t51 * t27;
  const Scalar t53 = Scalar(2.0) * s_6;
  const Scalar t54 = c_6 * t20 - t53 * t49;
  const Scalar t55 = Scalar(0.0825) * t54 - Scalar(0.384) * t52 + s_5 * t48 - c_5 * dtau_qd6_7;
  C[27] = -t55;
  const Scalar t56 = omega_7_z * t25 + (Scalar(0.007374285191337658) * t7 - omega_r_6_y * t25);
  const Scalar t57 = Scalar(0.0000467845486573025) * omega_6_z;
  const Scalar t58 = t36 - t57 - s_7 * t37 - t56 + Scalar(0.021522255370587554) * omega_r_6_y;
  const Scalar t59 = t34 - t57 - t35 + Scalar(0.003342075983680473) * omega_7_z + t56;
  const Scalar t60 = t59 - t58;
  const Scalar t61 = Scalar(0.007374285191337658) * omega_r_6_y;
  const Scalar t62 = Scalar(0.0000518794586093425) + t41;
  const Scalar t63 = omega_6_z * t62;
  const Scalar t64 = t63 - s_7 * t17 + c_7 * t12 + Scalar(0.004771885634746098) * t7 - t61;
  const Scalar t65 = -t63 - s_7 * t18 - c_7 * t13 - t61 + Scalar(0.026294141005333654) * t7;
  const Scalar t66 = t64 + t65;
  const Scalar t67 = c_6 * t66 - s_6 * t60;
  const Scalar t68 = c_7 * Iu_7_t_g;
  const Scalar t69 = t68 - t43 - Scalar(0.027504612894594268);
  const Scalar t70 = t5 * t69;
  const Scalar t71 = c_6 * t42 - s_6 * Ic_6_yz;
  C[39] = t67 + Scalar(2.0) * (t70 - omega_r_6_a_z * t71);
  const Scalar Ic_6_xx = t68 + Scalar(0.004771885634746098);
  const Scalar Ic_6_xy = Iu_7_a_xz + Scalar(0.007374285191337658);
  const Scalar t72 = t59 + t58 + Scalar(2.0) * (omega_r_6_y * Ic_6_xx + t7 * Ic_6_xy);
  const Scalar Ic_6_yy = t43 + Scalar(0.003342075983680473);
  const Scalar t73 = t64 - t65 - Scalar(2.0) * (t7 * Ic_6_yy + omega_r_6_y * Ic_6_xy);
  const Scalar t74 = c_6 * t73 - s_6 * t72;
  C[33] = -t74;
  const Scalar t75 = s_6 * t45 + c_6 * t44;
  const Scalar t76 = Scalar(0.165) * omega_4_z;
  const Scalar t77 = c_6 * hu_7_t_y;
  const Scalar t78 = c_5 * t77 - s_5 * hu_7_t_x;
  const Scalar t79 = s_6 * hu_7_t_y;
  const Scalar t80 = t76 * (t78 - Scalar(4.654545454545454) * t79) - s_5 * t75 - c_5 * t24;
  const Scalar f_u_7_4k_a_z = c_5 * hu_7_t_x + s_5 * t77;
  const Scalar mu_7_4_x = Scalar(0.384) * f_u_7_4k_a_z - s_5 * Iu_7_a_xy - c_5 * t47;
  const Scalar t81 = Scalar(0.0825) * f_u_7_4k_a_z;
  const Scalar t82 = s_6 * Iu_7_a_xz - t81 + c_6 * t26;
  C[45] = Scalar(2.0) * (t6 * mu_7_4_x - t4 * t82) - t80;
  const Scalar f_u_qd7_5_t_y = Scalar(2.0) * c_5 * t27 - s_5 * t50;
  const Scalar t83 = Scalar(0.384) * f_u_qd7_5_t_y - c_5 * t48 - s_5 * dtau_qd6_7;
  const Scalar t84 = Scalar(0.0825) * f_u_qd7_5_t_y;
  const Scalar dmu_qd7_4_y = mu_u_qd7_6_t_y - t84;
  const Scalar dtau_qd3_7 = t84 + c_4 * dmu_qd7_4_y - s_4 * t83;
  C[20] = dtau_qd3_7;
  const Scalar t85 = Scalar(0.768) * t4 - Scalar(0.165) * t6;
  const Scalar t86 = t76 * f_u_7_4k_a_z + t85 * t79 + c_5 * t75 - s_5 * t24;
  const Scalar t87 = Scalar(0.768) * omega_4_z;
  const Scalar t88 = t85 * t78 + t87 * f_u_7_4k_a_z + t46;
  const Scalar t89 = c_4 * t78 - s_4 * t79;
  const Scalar t90 = Scalar(0.165) * omega_3_z;
  const Scalar t91 = t90 * t89 + c_4 * t88 - s_4 * t86;
  const Scalar t92 = c_4 * mu_7_4_x + s_4 * t82;
  const Scalar t93 = c_4 * t79 + s_4 * t78;
  const Scalar t94 = Scalar(0.0825) * (t79 - t93) + Scalar(0.384) * t78 - c_5 * Iu_7_a_xy +
      s_5 * t47;
  C[44] = t91 + Scalar(2.0) * (omega_r_3_y * t92 - t2 * t94);
  const Scalar t95 = c_6 * t60 + s_6 * t66;
  const Scalar hc_6_x = hu_7_t_x + Scalar(0.1159237763475);
  const Scalar f_u_6_5k_t_x = Scalar(0.0869023527845) * c_6 - s_6 * hc_6_x;
  const Scalar t96 = f_u_6_5k_t_x * t76;
  const Scalar t97 = t40 + t96;
  const Scalar hu_6_t_x = Scalar(0.0869023527845) * s_6 + c_6 * hc_6_x;
  const Scalar t98 = c_5 * t97 + s_5 * t95 - hu_6_t_x * t87;
  const Scalar t99 = Scalar(0.384) * f_u_6_5k_t_x;
  const Scalar t100 = t69 + t99;
  const Scalar t101 = s_5 * t100 - c_5 * t71;
  const Scalar t102 = s_5 * f_u_6_5k_t_x;
  const Scalar t103 = Scalar(0.0825) * t102;
  const Scalar t104 = c_6 * Ic_6_yz + s_6 * t42;
  const Scalar t105 = t104 - t103;
  C[38] = t98 - Scalar(2.0) * (t6 * t101 - t4 * t105);
  const Scalar t106 = c_6 * t72 + s_6 * t73;
  const Scalar t107 = Scalar(0.0010172199793308985) * t10 + Scalar(0.0012868026856691014) * t8;
  const Scalar P_6_y = t107 + Scalar(0.1159237763475) * omega_6_z;
  const Scalar t108 = Scalar(-2.0) * t7;
  const Scalar t109 = hu_7_t_y * t108 + Scalar(2.0) * P_6_y;
  const Scalar P_6_x = Scalar(0.0869023527845) * omega_6_z - t27;
  const Scalar t110 = Scalar(2.0) * omega_r_6_y;
  const Scalar df_qd6_6_y = Scalar(2.0) * P_6_x - hu_7_t_y * t110;
  const Scalar t111 = c_6 * t109 + s_6 * df_qd6_6_y;
  const Scalar f_u_qd6_6_a_y = Scalar(0.173804705569) * omega_r_6_y - hc_6_x * t108;
  const Scalar t112 = c_5 * t111 + s_5 * f_u_qd6_6_a_y;
  const Scalar t113 = c_6 * df_qd6_6_y - s_6 * t109;
  const Scalar t114 = Scalar(0.0825) * t113 - c_5 * C_66 + s_5 * t106 - Scalar(0.384) * t112;
  C[26] = -t114;
  const Scalar t115 = Scalar(0.014748570382675316) * omega_6_z;
  const Scalar t116 = t33 - t62 * t110 - t38 - t115;
  const Scalar t117 = -t39 - t28 - t45 + t115;
  const Scalar t118 = Scalar(0.088) * t107 + (Scalar(0.0000518794586093425) * t7 + omega_6_z * t25);
  const Scalar t119 = Scalar(0.0000467845486573025) * omega_r_6_y;
  const Scalar t120 = t119 - t118 - c_7 * t18 + s_7 * t13 +
      Scalar(0.004771885634746098) * omega_6_z;
  const Scalar t121 = c_6 * (t116 - t117) - t53 * t120;
  const Scalar t122 = Scalar(0.004600245517563106) * omega_r_6_a_z + c_6 * t121;
  const Scalar t123 = Scalar(0.00216405205209813) * t5;
  const Scalar t124 = -t123 - t122 + t116;
  const Scalar Iu_6_t_d = Ic_6_xx - Ic_6_yy;
  const Scalar t125 = c_6 * Iu_6_t_d - Ic_6_xy * t53;
  const Scalar Ic_5_xz = Ic_6_xy - Scalar(0.002300122758781553) + s_6 * t125;
  const Scalar t126 = t104 - Scalar(0.001082026026049065);
  const Scalar C_55 = t124 - Scalar(2.0) * (t5 * t126 + omega_r_6_a_z * Ic_5_xz);
  C[32] = C_55;
  const Scalar t127 = omega_3_z * t93 + omega_r_3_y * f_u_7_4k_a_z;
  const Scalar t128 = Scalar(0.165) * t127 + s_4 * t88 + c_4 * t86;
  const Scalar t129 = Scalar(0.165) * omega_r_3_y;
  const Scalar t130 = t129 * t89 + t80;
  const Scalar t131 = c_3 * f_u_7_4k_a_z + s_3 * t89;
  const Scalar t132 = c_2 * (Scalar(0.316) * t131 + c_3 * t92 + s_3 * t94);
  const Scalar mu_u_7_2k_a_y = t81 + c_4 * t82 - s_4 * mu_7_4_x;
  const Scalar t133 = Scalar(2.0) * qd_1;
  const Scalar t134 = t133 * (t132 - s_2 * mu_u_7_2k_a_y);
  const Scalar t135 = Scalar(0.632) * qd_2;
  C[43] = t135 * t93 - t134 + c_3 * t130 - s_3 * t128;
  const Scalar t136 = s_4 * dmu_qd7_4_y + c_4 * t83;
  const Scalar t137 = t55 - Scalar(0.0825) * (c_4 * t54 - s_4 * t52);
  const Scalar t138 = c_4 * t52 + s_4 * t54;
  const Scalar t139 = c_3 * t138 + s_3 * f_u_qd7_5_t_y;
  C[13] = c_3 * t137 - Scalar(0.316) * t139 - s_3 * t136;
  const Scalar t140 = Scalar(0.000757622236663515) * t5;
  const Scalar t141 = Scalar(0.001082026026049065) * omega_5_z;
  const Scalar t142 = Scalar(0.001451156065026714) * omega_r_6_a_z - t140 + t141 - t120 -
      s_6 * t121;
  const Scalar t143 = t119 + t118 - c_7 * t17 - t140 - s_7 * t12 - t141 +
      Scalar(0.026294141005333654) * omega_6_z;
  const Scalar t144 = c_6 * t125;
  const Scalar Ic_5_xx = Ic_6_yy + t144 + Scalar(0.015058143566941042);
  const Scalar t145 = t71 + Scalar(0.000757622236663515);
  const Scalar t146 = t143 - t142 - Scalar(2.0) * (t5 * t145 + omega_r_6_a_z * Ic_5_xx);
  const Scalar t147 = Scalar(0.000757622236663515) * omega_r_6_a_z;
  const Scalar t148 = Scalar(0.002300122758781553) * omega_5_z;
  const Scalar dI_5_yz = -t147 - t148 + Scalar(0.016509299631967757) * t5 - c_6 * t65 - s_6 * t58;
  const Scalar t149 = t148 - t147 + c_6 * t64 - s_6 * t59 + Scalar(0.015058143566941042) * t5;
  const Scalar t150 = t149 - dI_5_yz + Scalar(2.0) * (t70 - omega_r_6_a_z * t145);
  const Scalar t151 = Scalar(0.0339353157125) * omega_5_z - c_6 * P_6_x + s_6 * P_6_y;
  const Scalar t152 = Scalar(2.0) * omega_r_6_a_z;
  const Scalar t153 = Scalar(2.0) * t151 + f_u_6_5k_t_x * t152;
  const Scalar t154 = t49 + Scalar(0.007326866269) * omega_5_z + Scalar(0.0869023527845) * t7 -
      Scalar(0.1159237763475) * omega_r_6_y;
  const Scalar t155 = Scalar(2.0) * t5;
  const Scalar df_qd5_5_x = Scalar(2.0) * t154 - f_u_6_5k_t_x * t155;
  const Scalar f_u_qd5_5_t_x = c_5 * df_qd5_5_x + s_5 * t153;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.007326866269);
  const Scalar f_5_5_x = hu_7_t_y - Scalar(0.0339353157125);
  const Scalar t156 = hc_5_x * t155 - f_5_5_x * t152;
  const Scalar dtau_qd4_5 = Scalar(0.0825) * t156 + c_5 * t150 - s_5 * t146 -
      Scalar(0.384) * f_u_qd5_5_t_x;
  C[25] = dtau_qd4_5;
  const Scalar t157 = s_5 * t97 - c_5 * t95 + hu_6_t_x * t85;
  const Scalar t158 = c_5 * f_u_6_5k_t_x;
  const Scalar t159 = t67 - t85 * t158 - t87 * t102;
  const Scalar t160 = c_4 * t158 - s_4 * hu_6_t_x;
  const Scalar kappa_6_3_z = c_4 * t159 - t90 * t160 + s_4 * t157;
  const Scalar t161 = s_4 * t105 + c_4 * t101;
  const Scalar f_u_6_3k_t_y = s_4 * t158 + c_4 * hu_6_t_x;
  const Scalar mu_6_3_y = s_5 * t71 + Scalar(0.0825) * (hu_6_t_x - f_u_6_3k_t_y) + c_5 * t100;
  C[37] = kappa_6_3_z - Scalar(2.0) * (omega_r_3_y * t161 - t2 * mu_6_3_y);
  const Scalar t162 = c_5 * f_u_qd6_6_a_y - s_5 * t111;
  const Scalar t163 = -s_5 * C_66 - c_5 * t106 + Scalar(0.384) * t162;
  const Scalar t164 = Scalar(-0.0825) * t162;
  const Scalar t165 = t74 - t164;
  const Scalar t166 = t164 + c_4 * t165 + s_4 * t163;
  C[19] = -t166;
  const Scalar t167 = Scalar(0.632) * t1;
  const Scalar t168 = s_2 * (t167 * t93 + c_3 * t128 + s_3 * t130);
  const Scalar t169 = qd_2 * t131 - t1 * (c_3 * t89 - s_3 * f_u_7_4k_a_z);
  C[42] = c_2 * (t91 - Scalar(0.632) * t169) + t168;
  const Scalar t170 = c_3 * f_u_qd7_5_t_y - s_3 * t138;
  const Scalar t171 = s_2 * (Scalar(0.316) * t170 + c_3 * t136 + s_3 * t137);
  C[6] = c_2 * dtau_qd3_7 + t171;
  const Scalar t172 = omega_r_3_y * t102 + omega_3_z * f_u_6_3k_t_y;
  const Scalar t173 = Scalar(0.165) * t172 + c_4 * t157 - s_4 * t159;
  const Scalar t174 = t129 * t160 + t98;
  const Scalar t175 = c_3 * t102 + s_3 * t160;
  const Scalar t176 = c_2 * (Scalar(0.316) * t175 + c_3 * t161 + s_3 * mu_6_3_y);
  const Scalar mu_6_3_z = t103 + c_4 * t105 - s_4 * t101;
  const Scalar t177 = t133 * (t176 - s_2 * mu_6_3_z);
  C[36] = t177 - c_3 * t174 + s_3 * t173 - t135 * f_u_6_3k_t_y;
  const Scalar t178 = t142 + t143;
  const Scalar kappa_5_5_y = t149 + dI_5_yz;
  const Scalar t179 = c_5 * f_5_5_x - s_5 * hc_5_x;
  const Scalar t180 = c_5 * kappa_5_5_y - t179 * t76 - s_5 * t178;
  const Scalar hu_5_t_x = s_5 * f_5_5_x + c_5 * hc_5_x;
  const Scalar t181 = Scalar(0.384) * hu_5_t_x - (s_5 * t126 + c_5 * Ic_5_xz);
  const Scalar Ic_5_zz = Ic_6_xx - t144 + Scalar(0.016509299631967757);
  const Scalar t182 = Scalar(0.0825) * hu_5_t_x;
  const Scalar mu_5_4_y = Ic_5_zz - t182;
  C[31] = -t180 - Scalar(2.0) * (t6 * t181 - t4 * mu_5_4_y);
  const Scalar t183 = c_5 * t153 - s_5 * df_qd5_5_x;
  const Scalar t184 = Scalar(-0.0825) * t183;
  const Scalar t185 = C_55 - t184;
  const Scalar t186 = c_5 * t146 + s_5 * t150 + Scalar(0.384) * t183;
  const Scalar C_35 = t184 + c_4 * t185 + s_4 * t186;
  C[18] = C_35;
  const Scalar t187 = c_4 * t163 - s_4 * t165;
  const Scalar t188 = t114 - Scalar(0.0825) * (c_4 * t113 - s_4 * t112);
  const Scalar t189 = c_4 * t112 + s_4 * t113;
  const Scalar t190 = c_3 * t189 + s_3 * t162;
  C[12] = c_3 * t188 - s_3 * t187 - Scalar(0.316) * t190;
  const Scalar t191 = t179 * t85;
  const Scalar t192 = hu_5_t_x * t87;
  const Scalar t193 = t124 - (t191 + t192);
  const Scalar t194 = t193 - t179 * t90;
  const Scalar t195 = c_5 * t178 - hu_5_t_x * t76 + s_5 * kappa_5_5_y;
  const Scalar t196 = c_4 * t194 - s_4 * t195;
  const Scalar t197 = s_4 * mu_5_4_y + c_4 * t181;
  const Scalar t198 = c_5 * t126 - s_5 * Ic_5_xz;
  const Scalar t199 = Scalar(-0.0825) * t179;
  const Scalar t200 = t198 - t199 * (s_4 - Scalar(4.654545454545454));
  C[30] = t196 - Scalar(2.0) * (omega_r_3_y * t197 + t2 * t200);
  const Scalar t201 = s_2 * (t167 * f_u_6_3k_t_y + c_3 * t173 + s_3 * t174);
  const Scalar t202 = qd_2 * t175 - t1 * (c_3 * t160 - s_3 * t102);
  C[35] = c_2 * (Scalar(0.632) * t202 + kappa_6_3_z) - t201;
  const Scalar t203 = c_4 * t195 - hu_5_t_x * t129 + s_4 * t194;
  const Scalar t204 = c_4 * t179;
  const Scalar t205 = t180 - t129 * t204;
  const Scalar t206 = c_3 * hu_5_t_x + s_3 * t204;
  const Scalar t207 = c_2 * (Scalar(0.316) * t206 + c_3 * t197 - s_3 * t200);
  const Scalar mu_5_3_z = t182 + c_4 * mu_5_4_y - s_4 * t181;
  const Scalar t208 = t133 * (t207 - s_2 * mu_5_3_z);
  const Scalar t209 = s_4 * t179;
  C[29] = c_3 * t205 - t135 * t209 + t208 - s_3 * t203;
  const Scalar t210 = c_4 * t186 - s_4 * t185;
  const Scalar t211 = dtau_qd4_5 - Scalar(0.0825) * (c_4 * t156 - s_4 * f_u_qd5_5_t_x);
  const Scalar t212 = c_4 * f_u_qd5_5_t_x + s_4 * t156;
  const Scalar t213 = c_3 * t212 + s_3 * t183;
  C[11] = Scalar(0.316) * t213 - c_3 * t211 + s_3 * t210;
  const Scalar f_u_qd6_3_t_y = c_3 * t162 - s_3 * t189;
  const Scalar t214 = s_2 * (c_3 * t187 + Scalar(0.316) * f_u_qd6_3_t_y + s_3 * t188);
  C[5] = t214 - c_2 * t166;
  const Scalar t215 = Scalar(0.00151524447332703) * omega_5_z;
  const Scalar dI_5_xx = t215 + t122 + t117;
  const Scalar t216 = t123 - t215 + t40;
  const Scalar dI_u5_t_d = dI_5_xx - t216;
  const Scalar t217 = Scalar(0.001082026026049065) * omega_r_6_a_z;
  const Scalar t218 = Scalar(0.002300122758781553) * t5;
  const Scalar t219 = -t217 - t218 + Scalar(0.015058143566941042) * omega_5_z - c_6 * t58 +
      s_6 * t65;
  const Scalar t220 = c_5 * dI_u5_t_d - t51 * t219;
  const Scalar t221 = Scalar(0.0039053550262761) * t6 + c_5 * t220;
  const Scalar t222 = c_5 * t151 - s_5 * t154;
  const Scalar t223 = Scalar(-0.165) * t222;
  const Scalar t224 = Scalar(0.007326866269) * omega_r_6_a_z + Scalar(0.0339353157125) * t5 -
      c_6 * P_6_y - s_6 * P_6_x;
  const Scalar t225 = Scalar(0.768) * t224 - t96;
  const Scalar t226 = Scalar(-0.00164448757736927) * t4;
  const Scalar t227 = dI_5_xx - t226 - t221 - t223 - t192 - t225;
  const Scalar t228 = t145 * t51 + c_5 * (t69 + Ic_5_xx);
  const Scalar t229 = t199 - Scalar(0.00195267751313805);
  const Scalar t230 = t145 - t229 - s_5 * t228;
  const Scalar t231 = Scalar(0.000822243788684635) + Scalar(0.384) * t179;
  const Scalar t232 = t198 - t231;
  const Scalar dtaud_4_4 = Scalar(2.0) * (t6 * t230 + t4 * t232) + t227;
  C[24] = dtaud_4_4;
  const Scalar t233 = s_2 * (s_3 * t205 - t167 * t209 + c_3 * t203);
  const Scalar t234 = qd_2 * t206 - t1 * (c_3 * t204 - s_3 * hu_5_t_x);
  C[28] = c_2 * (t196 + Scalar(0.632) * t234) + t233;
  const Scalar t235 = c_3 * t183 - s_3 * t212;
  const Scalar dmu_qd5_2_x = Scalar(0.316) * t235 + c_3 * t210 + s_3 * t211;
  C[4] = c_2 * C_35 - s_2 * dmu_qd5_2_x;
  const Scalar P_u5_a_z = c_5 * t154 + s_5 * t151;
  const Scalar t236 = Scalar(-0.5) * t85;
  const Scalar t237 = hu_5_t_x * t236 +
      (Scalar(0.08142043634273043) * t4 - Scalar(0.0825) * P_u5_a_z);
  const Scalar t238 = omega_4_z * t231;
  const Scalar t239 = t238 - t219 - s_5 * t220 + Scalar(0.0510201361568155) * t6 - t237;
  const Scalar t240 = t218 - t217 - c_6 * t59 - s_6 * t64 +
      Scalar(0.016509299631967757) * omega_5_z - t238 - t237;
  const Scalar t241 = t240 + t239;
  const Scalar t242 = (Scalar(0.384) * P_u5_a_z + Scalar(0.08142043634273043) * t6) -
      f_u_6_5k_t_x * t236;
  const Scalar t243 = omega_4_z * t229;
  const Scalar t244 = s_5 * t142 - t243 - c_5 * dI_5_yz - t242 + Scalar(0.374881683626407) * t4;
  const Scalar t245 = t243 + c_5 * t149 - s_5 * t143 - t242 + Scalar(0.3238615474695915) * t4;
  const Scalar t246 = t245 + t244;
  const Scalar hc_4_x = hu_5_t_x - Scalar(0.276390137325);
  const Scalar f_4_4_x = f_u_6_5k_t_x - Scalar(1.0062617768015);
  const Scalar t247 = c_4 * f_4_4_x - s_4 * hc_4_x;
  const Scalar t248 = s_4 * t241 - t247 * t90 + c_4 * t246;
  const Scalar t249 = c_4 * t230 - s_4 * t232;
  const Scalar t250 = c_5 * t228;
  const Scalar t251 = Scalar(0.165) * hu_5_t_x;
  const Scalar t252 = Scalar(0.768) * f_u_6_5k_t_x;
  const Scalar t253 = Ic_5_xx - t251 - t250 - t252 + Scalar(0.374881683626407);
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * f_4_4_x;
  const Scalar t254 = Scalar(0.0825) * hu_4_t_x;
  const Scalar t255 = t254 + t253;
  C[23] = t248 + Scalar(2.0) * (omega_r_3_y * t249 - t2 * t255);
  const Scalar t256 = t69 - t250 + t252 - Scalar(0.3238615474695915);
  const Scalar t257 = Scalar(0.0825) * f_u_6_5k_t_x + t181 - Scalar(0.08142043634273043);
  const Scalar t258 = t240 - t239 + Scalar(2.0) * (t4 * t257 + t6 * t256);
  const Scalar Ic_4_yy = Ic_5_zz - t251;
  const Scalar t259 = Scalar(2.0) * (t6 * t257 - t4 * Ic_4_yy) + t245 - t244;
  const Scalar t260 = Scalar(-2.0) * t4;
  const Scalar t261 = Scalar(-2.0) * t6;
  const Scalar t262 = hc_4_x * t260 + f_4_4_x * t261;
  const Scalar t263 = Scalar(0.0825) * t262 + c_4 * t259 + s_4 * t258;
  C[17] = -t263;
  const Scalar t264 = t222 + Scalar(1.0062617768015) * omega_4_z;
  const Scalar t265 = Scalar(2.0) * t264 - t179 * t261;
  const Scalar t266 = t224 + Scalar(0.276390137325) * omega_4_z;
  const Scalar df_qd4_4_x = Scalar(2.0) * t266 - t179 * t260;
  const Scalar t267 = dtaud_4_4 - Scalar(0.0825) * (c_4 * t265 - s_4 * df_qd4_4_x);
  const Scalar t268 = c_4 * t258 - s_4 * t259;
  const Scalar f_u_qd4_4_t_x = c_4 * df_qd4_4_x + s_4 * t265;
  const Scalar t269 = c_3 * f_u_qd4_4_t_x + s_3 * t262;
  C[10] = Scalar(0.316) * t269 - c_3 * t267 - s_3 * t268;
  const Scalar kappa_4_3_x = c_4 * t241 + hu_4_t_x * t90 - s_4 * t246;
  const Scalar t270 = t227 + t247 * t129;
  const Scalar t271 = c_2 * (s_3 * (Scalar(0.316) * t247 - t255) - c_3 * t249);
  const Scalar t272 = s_4 * t230 + c_4 * t232;
  const Scalar t273 = t133 * (s_2 * t272 - t271);
  C[22] = s_3 * kappa_4_3_x - c_3 * t270 - t273 - hu_4_t_x * t135;
  const Scalar t274 = Scalar(0.16284087268546085) * omega_4_z;
  const Scalar t275 = t216 + t221 - t191 - t225 - t274;
  const Scalar t276 = t226 - t223 + t193 + t274;
  const Scalar t277 = Scalar(0.384) * t222 - (Scalar(0.000822243788684635) * t6 + omega_4_z * t99);
  const Scalar t278 = Scalar(0.0825) * t224 - (Scalar(0.00195267751313805) * t4 + omega_4_z * t182);
  const Scalar t279 = -t278 - c_5 * t142 - s_5 * dI_5_yz + t277 +
      Scalar(0.3238615474695915) * omega_4_z;
  const Scalar t280 = Scalar(2.0) * s_4;
  const Scalar t281 = c_4 * (t275 - t276) - t280 * t279;
  const Scalar t282 = c_4 * t281;
  const Scalar t283 = c_4 * t264 - s_4 * t266;
  const Scalar t284 = Scalar(-0.004377257121839584) * t2;
  const Scalar t285 = Scalar(0.005487648106562256) * omega_r_3_y - t284 -
      Scalar(0.165) * (omega_3_z * t179 + t283) + t275 - t282;
  const Scalar t286 = c_4 * (Ic_4_yy + t256) - t257 * t280;
  const Scalar t287 = Scalar(0.0825) * t247 - Scalar(0.002743824053281128);
  const Scalar t288 = t257 - t287 + s_4 * t286;
  const Scalar t289 = Scalar(0.002188628560919792) + t272;
  const Scalar dtaud_3_3 = t285 - Scalar(2.0) * (t2 * t289 + omega_r_3_y * t288);
  C[16] = dtaud_3_3;
  const Scalar kappa_4_2_x = s_3 * t270 + c_3 * kappa_4_3_x + hu_4_t_x * t167;
  const Scalar t290 = Scalar(-0.632) * t247;
  C[21] = c_2 * (t248 + t2 * t290) - s_2 * kappa_4_2_x;
  const Scalar t291 = c_3 * t262 - s_3 * f_u_qd4_4_t_x;
  const Scalar t292 = s_2 * (s_3 * t267 + Scalar(0.316) * t291 - c_3 * t268);
  C[3] = -c_2 * t263 - t292;
  const Scalar t293 = c_4 * t266 + s_4 * t264;
  const Scalar t294 = Scalar(0.0825) * t293 +
      (Scalar(0.000060956210475372) * t2 + omega_r_3_y * t254);
  const Scalar t295 = Scalar(0.002188628560919792) * omega_3_z;
  const Scalar t296 = t295 + Scalar(0.061602421026527694) * omega_r_3_y + t294 + t279 + s_4 * t281;
  const Scalar t297 = t295 + t278 + s_5 * t149 + c_5 * t143 + t277 - t294 +
      Scalar(0.374881683626407) * omega_4_z;
  const Scalar t298 = t297 - t296;
  const Scalar t299 = omega_3_z * t287;
  const Scalar t300 = Scalar(0.000060956210475372) + t199;
  const Scalar t301 = omega_r_3_y * t300;
  const Scalar t302 = t301 + Scalar(0.06740035307411071) * t2 + t299 - s_4 * t239 - c_4 * t244;
  const Scalar t303 = Scalar(0.00579793204758302) * t2 + t301 - t299 + s_4 * t240 + c_4 * t245;
  const Scalar t304 = t303 + t302;
  const Scalar hc_3_x = Scalar(0.373428979936) + hu_4_t_x;
  const Scalar t305 = t179 - Scalar(0.014113547439);
  const Scalar t306 = s_3 * t305 + c_3 * hc_3_x;
  const Scalar t307 = Scalar(-0.316) * t306;
  const Scalar t308 = (c_3 * t288 - s_3 * t289) - t307;
  const Scalar t309 = c_2 * t133;
  const Scalar t310 = c_4 * t286;
  const Scalar t311 = Scalar(0.165) * hu_4_t_x;
  const Scalar t312 = Scalar(-2.0) * t1 * (-t311 - Scalar(0.06740035307411071) - t310 + t256);
  C[15] = c_3 * t304 + t308 * t309 - t312 - s_3 * t298;
  const Scalar Ic_3_xx = Scalar(0.00579793204758302) + Ic_4_yy - t310;
  const Scalar t313 = t300 + t249;
  const Scalar t314 = Scalar(2.0) * (omega_r_3_y * Ic_3_xx - t2 * t313) + t297 + t296;
  const Scalar t315 = t311 + t253;
  const Scalar t316 = t303 - t302 + Scalar(2.0) * (omega_r_3_y * t313 - t2 * t315);
  const Scalar t317 = Scalar(0.014113547439) * omega_3_z + t283;
  const Scalar t318 = Scalar(-2.0) * t247;
  const Scalar t319 = omega_r_3_y * t318 + Scalar(2.0) * t317;
  const Scalar t320 = Scalar(-0.276390137325) * t6 - P_u5_a_z + Scalar(1.0062617768015) * t4;
  const Scalar P_3_y = Scalar(0.373428979936) * omega_3_z + t320;
  const Scalar t321 = Scalar(2.0) * P_3_y - t2 * t318;
  const Scalar t322 = c_3 * t321 - s_3 * t319;
  C[9] = s_3 * t314 - c_3 * t316 - Scalar(0.316) * t322;
  const Scalar t323 = c_3 * t305 - s_3 * hc_3_x;
  const Scalar t324 = t1 * t323;
  const Scalar t325 = qd_2 * t306;
  const Scalar t326 = t285 - Scalar(0.632) * (t324 - t325);
  C[14] = c_2 * t326 + s_2 * (s_3 * t304 + c_3 * t298);
  const Scalar t327 = c_3 * t319 + s_3 * t321;
  const Scalar dmu_qd3_2_x = c_3 * t314 + s_3 * t316 + Scalar(0.316) * t327;
  C[2] = c_2 * dtaud_3_3 - s_2 * dmu_qd3_2_x;
  const Scalar t328 = Scalar(2.0) * (omega_3_z * t300 + omega_r_3_y * t287) + t276 + t282;
  const Scalar t329 = Scalar(0.000121912420950744) * omega_3_z - t284 + Scalar(0.165) * t283 - t270;
  const Scalar t330 = (Scalar(0.002743824053281128) * t2 + omega_3_z * t254) +
      Scalar(0.0825) * t320;
  const Scalar t331 = Scalar(0.002188628560919792) * omega_r_3_y;
  const Scalar t332 = Scalar(0.00579793204758302) * omega_3_z - t331 - t330 - c_4 * t239 +
      s_4 * t244;
  const Scalar t333 = Scalar(2.0) * s_3;
  const Scalar t334 = c_3 * (t329 + t328) - t333 * t332;
  const Scalar t335 = Scalar(0.01026110182100817) * t3 - c_3 * t334;
  const Scalar Iu_3_t_d = Ic_3_xx - t315;
  const Scalar t336 = t313 * t333 + c_3 * Iu_3_t_d;
  const Scalar t337 = Scalar(0.316) * t323 - Scalar(0.0003844680514732);
  const Scalar t338 = s_2 * (t337 - c_3 * t289 - s_3 * t288);
  const Scalar t339 = (c_2 * (t313 - Scalar(0.005130550910504085) - s_3 * t336) - t338) * t133;
  const Scalar t340 = Scalar(0.014113547439) * t2 + Scalar(0.373428979936) * omega_r_3_y + t293;
  const Scalar t341 = Scalar(0.0007689361029464) * t1;
  C[8] = t328 - t341 + t335 + t339 - Scalar(0.632) * (t340 - t325);
  const Scalar t342 = qd_2 * t337;
  const Scalar t343 = t1 * t307;
  const Scalar t344 = Scalar(0.00199167944196776) * t1;
  const Scalar t345 = Scalar(0.023077882494931805) * t3 - t344 - t343 - t332 - t342 - s_3 * t334;
  const Scalar t346 = t308 - Scalar(0.00199167944196776);
  const Scalar t347 = c_2 * (c_3 * t336 + t315 + t290 + Scalar(0.5353432998817383)) - s_2 * t346;
  const Scalar t348 = -t331 - t344 + Scalar(0.06740035307411071) * omega_3_z + c_4 * t240 + t330 -
      t343 + t342 - s_4 * t245;
  const Scalar t349 = (c_3 * P_3_y - s_3 * t317) - t1 * t247;
  const Scalar t350 = Scalar(0.00199167944196776) * t3 - Scalar(0.316) * t349;
  const Scalar t351 = Scalar(0.005130550910504085) * qd_2;
  const Scalar dI_2_yz = t351 - c_3 * t302 + Scalar(0.5584211823766702) * t1 - t350 - s_3 * t296;
  const Scalar t352 = c_3 * t303 - t351 + Scalar(0.5353432998817383) * t1 - t350 - s_3 * t297;
  const Scalar t353 = c_2 * (t346 * t309 - t312 + t352 - dI_2_yz);
  C[1] = t353 - s_2 * (t348 - t345 - t133 * t347);
  C[7] = s_2 * (t348 + t345) - c_2 * (t352 + dI_2_yz);
  const Scalar t354 = Scalar(0.00398335888393552) * qd_2;
  const Scalar t355 = t329 - t354 + t335 + Scalar(0.632) * (t324 + t340);
  const Scalar dI_u2_t_d = t354 - t341 - t355 - t326;
  const Scalar t356 = (c_3 * t317 + s_3 * P_3_y) + qd_2 * (t247 - Scalar(1.694124366714362));
  const Scalar t357 = Scalar(0.005130550910504085) * t1 - Scalar(0.0003844680514732) * t3 +
      s_3 * t302 - c_3 * t296 - Scalar(0.316) * t356;
  C[0] = -t355 - c_2 * (c_2 * dI_u2_t_d - Scalar(2.0) * s_2 * t357);
  C[48] = Scalar(0.0);
}

// Gravity torques g(q) (7.39).
//   q[7]  in   joint positions, rad or m
//   g[7]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..6]. Operations: 43 mul, 29 add, 12 sin/cos. Always zero: g[0].
template <class Scalar, class SinCos = LibrarySinCos>
inline void gravity(const Scalar* q, Scalar* g, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5],
      s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = s_2 * c_3;
  const Scalar t2 = c_4 * t1 - c_2 * s_4;
  const Scalar t3 = s_2 * s_3;
  const Scalar t4 = s_5 * t3 - c_5 * t2;
  const Scalar hu_7_t_x = Scalar(0.025247068692827772) * c_7 - Scalar(0.019957855994472227) * s_7;
  const Scalar hc_6_x = hu_7_t_x + Scalar(2.27442449193795);
  const Scalar t5 = Scalar(1.70502416163189) * c_6 - s_6 * hc_6_x;
  const Scalar hu_6_t_x = Scalar(1.70502416163189) * s_6 + c_6 * hc_6_x;
  const Scalar t6 = s_4 * t1 + c_2 * c_4;
  g[5] = t5 * t4 + hu_6_t_x * t6;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.14375311619778);
  const Scalar hu_7_t_y = Scalar(0.019957855994472227) * c_7 + Scalar(0.025247068692827772) * s_7;
  const Scalar t7 = hu_7_t_y - Scalar(0.66581089427925);
  const Scalar t8 = s_5 * hc_5_x - c_5 * t7;
  const Scalar hu_5_t_x = s_5 * t7 + c_5 * hc_5_x;
  g[4] = t8 * t2 + hu_5_t_x * t3;
  const Scalar g_6_a_z = s_5 * t2 + c_5 * t3;
  g[6] = -hu_7_t_y * (s_6 * t6 + c_6 * t4) - hu_7_t_x * g_6_a_z;
  const Scalar hc_4_x = hu_5_t_x - Scalar(5.4227744943165);
  const Scalar t9 = t5 - Scalar(19.74285606084543);
  const Scalar t10 = s_4 * hc_4_x - c_4 * t9;
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * t9;
  g[3] = t10 * t1 + c_2 * hu_4_t_x;
  const Scalar hc_3_x = Scalar(7.32667658634432) + hu_4_t_x;
  const Scalar t11 = Scalar(0.27690780075318) + t8;
  g[2] = s_2 * (c_3 * t11 + s_3 * hc_3_x);
  const Scalar t12 = c_2 * (Scalar(0.01993386669246) + s_3 * t11 - c_3 * hc_3_x);
  g[1] = t12 - s_2 * (t10 + Scalar(32.80954542685272));
  g[0] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[7]   in   joint positions, rad or m
//   qd[7]  in   joint velocities, rad/s or m/s
//   n[7]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..6], qd[0..6]. Operations: 300 mul, 273 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5],
      s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = s_2 * qd_1;
  const Scalar t2 = s_3 * qd_2 - c_3 * t1;
  const Scalar t3 = c_2 * qd_1;
  const Scalar t4 = qd_2 * t3;
  const Scalar t5 = qd_3 * t2 - s_3 * t4;
  const Scalar omega_3_z = qd_3 + t3;
  const Scalar t6 = t2 * omega_3_z;
  const Scalar t7 = t5 + t6;
  const Scalar t8 = t1 * t1;
  const Scalar t9 = qd_2 * qd_2;
  const Scalar t10 = t8 + t9;
  const Scalar ddp_3_a_z = Scalar(9.81) * c_2 - Scalar(0.316) * t10;
  const Scalar ddp_o_4_z = Scalar(0.0825) * t7 + ddp_3_a_z;
  const Scalar t11 = t3 * t1;
  const Scalar t12 = Scalar(0.316) * t11 + Scalar(9.81) * s_2;
  const Scalar t13 = Scalar(0.632) * t4;
  const Scalar t14 = c_3 * t12 - s_3 * t13;
  const Scalar omega_r_3_y = s_3 * t1 + c_3 * qd_2;
  const Scalar t15 = omega_r_3_y * omega_r_3_y;
  const Scalar t16 = omega_3_z * omega_3_z;
  const Scalar t17 = t15 + t16;
  const Scalar t18 = Scalar(0.0825) * t17 + t14;
  const Scalar ddp_4_x = s_4 * ddp_o_4_z - c_4 * t18;
  const Scalar t19 = s_4 * t2 - c_4 * omega_3_z;
  const Scalar t20 = t19 * t19;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar t21 = omega_4_z * omega_4_z;
  const Scalar t22 = t21 + t20;
  const Scalar t23 = c_4 * t2 + s_4 * omega_3_z;
  const Scalar t24 = t23 * t19;
  const Scalar t25 = t5 + t24;
  const Scalar ddp_o_5_x = Scalar(0.0825) * t22 + ddp_4_x - Scalar(0.384) * t25;
  const Scalar t26 = qd_3 * omega_r_3_y - c_3 * t4;
  const Scalar t27 = qd_2 * t1;
  const Scalar t28 = s_4 * t26 + c_4 * t27 + qd_4 * t23;
  const Scalar t29 = t23 * omega_4_z;
  const Scalar U_4_zx = t28 + t29;
  const Scalar t30 = s_4 * t27 - c_4 * t26 + qd_4 * t19;
  const Scalar t31 = t19 * omega_4_z;
  const Scalar t32 = t30 + t31;
  const Scalar ddp_3_y = c_3 * t13 + s_3 * t12;
  const Scalar t33 = t2 * omega_r_3_y;
  const Scalar t34 = t33 - t27;
  const Scalar ddp_o_4_y = Scalar(0.0825) * t34 + ddp_3_y;
  const Scalar ddp_5_a_y = Scalar(0.0825) * U_4_zx + ddp_o_4_y + Scalar(0.384) * t32;
  const Scalar ddp_5_x = s_5 * ddp_5_a_y + c_5 * ddp_o_5_x;
  const Scalar ddp_4_y = s_4 * t18 + c_4 * ddp_o_4_z;
  const Scalar t35 = t5 - t24;
  const Scalar t36 = t23 * t23;
  const Scalar t37 = t21 + t36;
  const Scalar ddp_o_5_y = ddp_4_y - Scalar(0.0825) * t35 - Scalar(0.384) * t37;
  const Scalar t38 = s_6 * ddp_5_x - c_6 * ddp_o_5_y;
  const Scalar t39 = s_5 * omega_4_z - c_5 * t23;
  const Scalar omega_5_z = qd_5 - t19;
  const Scalar t40 = s_6 * omega_5_z - c_6 * t39;
  const Scalar omega_r_6_y = s_6 * t39 + c_6 * omega_5_z;
  const Scalar t41 = t40 * omega_r_6_y;
  const Scalar domega_5_y = qd_5 * t39 - c_5 * t5 + s_5 * t30;
  const Scalar t42 = domega_5_y - t41;
  const Scalar t43 = Scalar(0.088) * t42 + t38;
  const Scalar omega_r_6_a_z = s_5 * t23 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t44 = s_7 * omega_6_z + c_7 * t40;
  const Scalar t45 = s_5 * t5 + qd_5 * omega_r_6_a_z + c_5 * t30;
  const Scalar t46 = qd_6 * omega_r_6_y - s_6 * t28 - c_6 * t45;
  const Scalar t47 = qd_7 * t44 + s_7 * t46 + c_7 * domega_5_y;
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar t48 = t44 * omega_7_z;
  const Scalar U_7_zx = t47 + t48;
  const Scalar t49 = s_7 * t40 - c_7 * omega_6_z;
  const Scalar t50 = qd_7 * t49 + s_7 * domega_5_y - c_7 * t46;
  const Scalar t51 = t49 * omega_7_z;
  const Scalar t52 = t50 + t51;
  const Scalar t53 = t44 * t44;
  const Scalar t54 = omega_7_z * omega_7_z;
  const Scalar t55 = t54 + t53;
  const Scalar t56 = t49 * t49;
  const Scalar t57 = t56 + t53;
  const Scalar t58 = t44 * t49;
  const Scalar domega_r_7_a_z = qd_6 * t40 - s_6 * t45 + c_6 * t28;
  const Scalar U_7_yx = domega_r_7_a_z - t58;
  const Scalar t59 = Scalar(0.002034439958661797) * t43 - Scalar(0.000391391281684248) * U_7_zx -
      Scalar(0.0009653051699191118) * U_7_yx + Scalar(0.0012555365982728983) * (t55 - t57) -
      Scalar(0.004552547872941088) * t52;
  const Scalar t60 = t54 + t56;
  const Scalar U_7_zz_xx = t60 - t57;
  const Scalar t61 = domega_r_7_a_z + t58;
  const Scalar t62 = Scalar(0.000391391281684248) * t52 + Scalar(0.002573605371338203) * t43 +
      Scalar(0.0012555365982728983) * t61 + Scalar(0.0009653051699191118) * U_7_zz_xx +
      Scalar(0.002131604094419858) * U_7_zx;
  const Scalar F_7_z = Scalar(0.002573605371338203) * U_7_zx - Scalar(0.002034439958661797) * t52;
  const Scalar ddp_6_x = s_6 * ddp_o_5_y + c_6 * ddp_5_x;
  const Scalar t63 = t40 * omega_6_z;
  const Scalar t64 = omega_r_6_y * omega_6_z;
  const Scalar t65 = omega_r_6_y * omega_r_6_y;
  const Scalar t66 = omega_6_z * omega_6_z;
  const Scalar t67 = t65 + t66;
  const Scalar t68 = t40 * t40;
  const Scalar t69 = t68 + t66;
  const Scalar U_6_xy = domega_5_y + t41;
  const Scalar mu_6_z = Scalar(-0.000093569097314605) * (domega_r_7_a_z - t63) -
      Scalar(0.000103758917218685) * (t46 - t64) - Scalar(0.088) * F_7_z - c_7 * t62 + s_7 * t59 -
      Scalar(0.021522255370587554) * t42 - Scalar(0.028934422545659894) * U_6_xy -
      Scalar(0.014748570382675316) * (t67 - t69) + Scalar(0.173804705569) * ddp_6_x -
      Scalar(0.231847552695) * t38;
  n[5] = mu_6_z;
  const Scalar ddp_o_7_x = ddp_6_x - Scalar(0.088) * t67;
  const Scalar t70 = s_5 * ddp_o_5_x - c_5 * ddp_5_a_y;
  const Scalar U_6_zx = domega_r_7_a_z + t63;
  const Scalar t71 = Scalar(0.088) * U_6_zx + t70;
  const Scalar ddp_7_x = s_7 * t71 + c_7 * ddp_o_7_x;
  const Scalar t72 = s_7 * ddp_o_7_x - c_7 * t71;
  const Scalar U_7_yz = t50 - t51;
  const Scalar mu_u_7_a_y = Scalar(0.002034439958661797) * ddp_7_x +
      Scalar(0.002573605371338203) * t72 - Scalar(0.0009653051699191118) * U_7_yz +
      Scalar(0.000391391281684248) * (t60 - t55) - Scalar(0.0012555365982728983) * (t47 - t48) -
      Scalar(0.002131604094419858) * U_7_yx - Scalar(0.004552547872941088) * t61;
  n[6] = -mu_u_7_a_y;
  const Scalar t73 = Scalar(0.002034439958661797) * t61 + Scalar(0.002573605371338203) * t60;
  const Scalar F_7_y = Scalar(0.002573605371338203) * U_7_yx - Scalar(0.002034439958661797) * t55;
  const Scalar t74 = s_7 * t73 - c_7 * F_7_y;
  const Scalar t75 = t46 + t64;
  const Scalar t76 = t65 + t68;
  const Scalar U_6_zz_xx = t67 - t76;
  const Scalar t77 = Scalar(0.000093569097314605) * U_6_xy +
      Scalar(0.000103758917218685) * U_6_zz_xx - Scalar(0.088) * t74 - mu_u_7_a_y -
      Scalar(0.014748570382675316) * t75 + Scalar(0.021522255370587554) * U_6_zx +
      Scalar(0.231847552695) * t70;
  const Scalar t78 = Scalar(0.000093569097314605) * (t69 - t76) -
      Scalar(0.000103758917218685) * t42 - s_7 * t62 - c_7 * t59 +
      Scalar(0.014748570382675316) * U_6_zx - Scalar(0.028934422545659894) * t75 +
      Scalar(0.173804705569) * t70;
  const Scalar t79 = t39 * omega_5_z;
  const Scalar U_5_xz = domega_5_y - t79;
  const Scalar t80 = omega_r_6_a_z * omega_5_z;
  const Scalar U_5_yz = t45 - t80;
  const Scalar t81 = omega_r_6_a_z * omega_r_6_a_z;
  const Scalar t82 = omega_5_z * omega_5_z;
  const Scalar t83 = t81 + t82;
  const Scalar t84 = t39 * t39;
  const Scalar t85 = t84 + t82;
  const Scalar t86 = t39 * omega_r_6_a_z;
  const Scalar U_5_xy = t28 + t86;
  const Scalar t87 = t28 - t86;
  const Scalar t88 = Scalar(0.001451156065026714) * t87 - Scalar(0.00216405205209813) * U_5_xz -
      Scalar(0.00151524447332703) * (t83 - t85) - Scalar(0.004600245517563106) * U_5_yz -
      Scalar(0.014653732538) * t70 + Scalar(0.010045187828321245) * U_5_xy +
      Scalar(0.067870631425) * ddp_5_x + s_6 * t78 + c_6 * t77;
  n[4] = -t88;
  const Scalar t89 = domega_5_y + t79;
  const Scalar t90 = t45 + t80;
  const Scalar t91 = t81 + t84;
  const Scalar mu_5_x = Scalar(-0.00151524447332703) * t89 -
      Scalar(0.00216405205209813) * (t85 - t91) + Scalar(0.004600245517563106) * t87 -
      Scalar(0.010045187828321245) * t90 + Scalar(0.067870631425) * ddp_o_5_y + s_6 * t77 -
      c_6 * t78;
  const Scalar t92 = F_7_z + Scalar(0.231847552695) * t42 - Scalar(0.173804705569) * t69;
  const Scalar t93 = s_7 * F_7_y + c_7 * t73 + Scalar(0.173804705569) * U_6_xy +
      Scalar(0.231847552695) * t67;
  const Scalar f_5_x = Scalar(0.014653732538) * t83 + Scalar(0.067870631425) * U_5_xy + s_6 * t92 -
      c_6 * t93;
  const Scalar f_5_y = t74 + Scalar(0.014653732538) * t87 - Scalar(0.067870631425) * t85 -
      Scalar(0.231847552695) * U_6_zx + Scalar(0.173804705569) * t75;
  const Scalar t94 = s_5 * f_5_y - c_5 * f_5_x;
  const Scalar U_5_zz_xx = t83 - t91;
  const Scalar mu_5_y = Scalar(0.001451156065026714) * t89 - Scalar(0.00216405205209813) * U_5_xy +
      Scalar(0.00151524447332703) * t90 + Scalar(0.014653732538) * ddp_o_5_y -
      Scalar(0.004600245517563106) * U_5_zz_xx - mu_6_z;
  const Scalar f_5_z = Scalar(0.014653732538) * t89 - Scalar(0.067870631425) * t90 - s_6 * t93 -
      c_6 * t92;
  const Scalar U_4_yz = t30 - t31;
  const Scalar mu_u_4_a_y = Scalar(0.0039053550262761) * U_4_yz -
      Scalar(0.00164448757736927) * (t28 - t29) - Scalar(0.0510201361568155) * t35 +
      Scalar(0.0825) * f_5_z + s_5 * mu_5_x + c_5 * mu_5_y + Scalar(0.55278027465) * ddp_4_y -
      Scalar(0.384) * t94 + Scalar(0.16284087268546085) * (t22 - t37) +
      Scalar(2.012523553603) * ddp_4_x - Scalar(0.6972920750309718) * t25;
  n[3] = -mu_u_4_a_y;
  const Scalar f_u_5_t_y = s_5 * f_5_x + c_5 * f_5_y;
  const Scalar t95 = t20 + t36;
  const Scalar t96 = Scalar(-0.0039053550262761) * t35 - Scalar(0.00164448757736927) * (t37 - t95) +
      s_5 * mu_5_y - c_5 * mu_5_x + Scalar(0.16284087268546085) * U_4_zx +
      Scalar(0.384) * f_u_5_t_y + Scalar(2.012523553603) * ddp_o_4_y +
      Scalar(0.6972920750309718) * t32;
  const Scalar U_4_zz_xx = t22 - t95;
  const Scalar t97 = Scalar(0.00164448757736927) * t25 - Scalar(0.0039053550262761) * U_4_zz_xx +
      Scalar(0.0510201361568155) * U_4_zx + Scalar(0.0825) * f_u_5_t_y +
      Scalar(0.55278027465) * ddp_o_4_y + Scalar(0.16284087268546085) * t32 + t88;
  const Scalar f_u_4_a_y = f_u_5_t_y + Scalar(0.55278027465) * U_4_zx +
      Scalar(2.012523553603) * t32;
  const Scalar t98 = omega_r_3_y * omega_3_z;
  const Scalar t99 = t2 * t2;
  const Scalar t100 = t99 + t16;
  const Scalar U_3_xy = t33 + t27;
  const Scalar n_3 = Scalar(0.000121912420950744) * (t17 - t100) +
      Scalar(0.004377257121839584) * (t5 - t6) - Scalar(0.005487648106562256) * (t26 - t98) +
      Scalar(0.028227094878) * t14 - Scalar(0.022178148964878235) * U_3_xy +
      Scalar(0.061602421026527694) * t34 + Scalar(0.0825) * f_u_4_a_y - c_4 * t97 +
      Scalar(0.746857959872) * ddp_3_y - s_4 * t96;
  n[2] = n_3;
  const Scalar t101 = t26 + t98;
  const Scalar t102 = t15 + t99;
  const Scalar mu_3_x = Scalar(0.000121912420950744) * t7 - Scalar(0.005487648106562256) * t34 +
      Scalar(0.004377257121839584) * (t100 - t102) + Scalar(0.028227094878) * ddp_3_a_z +
      Scalar(0.022178148964878235) * t101 + s_4 * t97 - c_4 * t96;
  const Scalar f_4_x = Scalar(0.55278027465) * t22 - t94 - Scalar(2.012523553603) * t25;
  const Scalar t103 = Scalar(0.55278027465) * t35 - f_5_z + Scalar(2.012523553603) * t37;
  const Scalar t104 = Scalar(0.746857959872) * t17 - Scalar(0.028227094878) * U_3_xy - s_4 * t103 -
      c_4 * f_4_x;
  const Scalar t105 = Scalar(0.746857959872) * t34 - Scalar(0.028227094878) * t100 + f_u_4_a_y;
  const Scalar t106 = s_3 * t105 + c_3 * t104;
  const Scalar f_u_4_t_y = s_4 * f_4_x - c_4 * t103;
  const Scalar U_3_zz_xx = t17 - t102;
  const Scalar t107 = Scalar(0.000121912420950744) * t101 - Scalar(0.004377257121839584) * U_3_xy +
      Scalar(0.005487648106562256) * U_3_zz_xx + Scalar(0.061602421026527694) * t7 +
      Scalar(0.0825) * f_u_4_t_y + Scalar(0.746857959872) * ddp_3_a_z - mu_u_4_a_y;
  const Scalar t108 = t3 * t3;
  const Scalar t109 = t108 + t9;
  n[1] = Scalar(0.01993386669246) * c_2 + Scalar(0.00398335888393552) * (t109 - t10) -
      Scalar(1.0090841787369491) * t11 - Scalar(0.316) * t106 + s_3 * mu_3_x - c_3 * t107 -
      Scalar(32.80954542685272) * s_2;
  const Scalar t110 = s_3 * t104 - c_3 * t105;
  const Scalar t111 = t108 + t8;
  const Scalar t112 = Scalar(0.01026110182100817) * t11 -
      Scalar(0.0007689361029464) * (t10 - t111) - Scalar(0.00796671776787104) * t27 -
      Scalar(2.064324122463762) * t4 + Scalar(0.316) * t110 + s_3 * t107 + c_3 * mu_3_x;
  const Scalar U_2_zz_xx = t109 - t111;
  const Scalar t113 = Scalar(0.0007689361029464) * t11 - Scalar(0.00796671776787104) * t4 -
      Scalar(0.01026110182100817) * U_2_zz_xx - Scalar(0.04615576498986361) * t27 + n_3;
  n[0] = c_2 * t113 - s_2 * t112;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[7]    in   joint positions, rad or m
//   qd[7]   in   joint velocities, rad/s or m/s
//   tau[7]  in   joint torques or forces, N m or N
//   qdd[7]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[1..6], qd[0..6], tau[0..6]. Operations: 610 mul, 538 add, 6 div, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  const Scalar tau_1 = tau[0], tau_2 = tau[1], tau_3 = tau[2], tau_4 = tau[3], tau_5 = tau[4],
      tau_6 = tau[5], tau_7 = tau[6];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5],
      s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = s_2 * qd_1;
  const Scalar t2 = c_3 * t1 - s_3 * qd_2;
  const Scalar t3 = c_2 * qd_1;
  const Scalar t4 = qd_2 * t3;
  const Scalar t5 = qd_3 * t2 + s_3 * t4;
  const Scalar omega_3_z = qd_3 + t3;
  const Scalar t6 = t2 * omega_3_z;
  const Scalar t7 = t5 + t6;
  const Scalar t8 = qd_2 * qd_2;
  const Scalar t9 = t1 * t1 + t8;
  const Scalar ddp_3_a_z = Scalar(9.81) * c_2 - Scalar(0.316) * t9;
  const Scalar ddp_o_4_z = ddp_3_a_z - Scalar(0.0825) * t7;
  const Scalar t10 = Scalar(0.632) * t4;
  const Scalar t11 = t3 * t1;
  const Scalar t12 = Scalar(0.316) * t11 + Scalar(9.81) * s_2;
  const Scalar t13 = s_3 * t10 - c_3 * t12;
  const Scalar omega_r_3_y = s_3 * t1 + c_3 * qd_2;
  const Scalar t14 = omega_r_3_y * omega_r_3_y;
  const Scalar t15 = omega_3_z * omega_3_z;
  const Scalar t16 = t14 + t15;
  const Scalar t17 = t13 - Scalar(0.0825) * t16;
  const Scalar ddp_4_x = c_4 * t17 + s_4 * ddp_o_4_z;
  const Scalar t18 = s_4 * t2 + c_4 * omega_3_z;
  const Scalar t19 = t18 * t18;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar t20 = omega_4_z * omega_4_z;
  const Scalar t21 = t19 + t20;
  const Scalar t22 = c_4 * t2 - s_4 * omega_3_z;
  const Scalar t23 = t22 * t18;
  const Scalar t24 = t5 - t23;
  const Scalar ddp_o_5_x = Scalar(0.0825) * t21 + ddp_4_x + Scalar(0.384) * t24;
  const Scalar t25 = qd_3 * omega_r_3_y - c_3 * t4;
  const Scalar t26 = qd_2 * t1;
  const Scalar t27 = c_4 * t26 + s_4 * t25 - qd_4 * t22;
  const Scalar t28 = t22 * omega_4_z;
  const Scalar U_4_zx = t27 - t28;
  const Scalar t29 = c_4 * t25 - s_4 * t26 + qd_4 * t18;
  const Scalar t30 = t18 * omega_4_z;
  const Scalar t31 = t29 + t30;
  const Scalar ddp_3_y = c_3 * t10 + s_3 * t12;
  const Scalar t32 = t2 * omega_r_3_y;
  const Scalar t33 = t26 + t32;
  const Scalar ddp_o_4_y = ddp_3_y - Scalar(0.0825) * t33;
  const Scalar ddp_5_a_y = Scalar(0.0825) * U_4_zx + ddp_o_4_y - Scalar(0.384) * t31;
  const Scalar ddp_5_x = c_5 * ddp_o_5_x + s_5 * ddp_5_a_y;
  const Scalar ddp_4_y = c_4 * ddp_o_4_z - s_4 * t17;
  const Scalar t34 = t5 + t23;
  const Scalar t35 = t22 * t22;
  const Scalar t36 = t20 + t35;
  const Scalar ddp_o_5_y = Scalar(0.0825) * t34 + ddp_4_y - Scalar(0.384) * t36;
  const Scalar ddp_6_x = c_6 * ddp_5_x + s_6 * ddp_o_5_y;
  const Scalar t37 = c_5 * t22 + s_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 + t18;
  const Scalar omega_r_6_y = c_6 * omega_5_z + s_6 * t37;
  const Scalar t38 = omega_r_6_y * omega_r_6_y;
  const Scalar omega_r_6_a_z = c_5 * omega_4_z - s_5 * t22;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t39 = omega_6_z * omega_6_z;
  const Scalar t40 = t38 + t39;
  const Scalar ddp_o_7_x = ddp_6_x - Scalar(0.088) * t40;
  const Scalar t41 = c_5 * ddp_5_a_y - s_5 * ddp_o_5_x;
  const Scalar t42 = s_5 * t5 + c_5 * t29 - qd_5 * omega_r_6_a_z;
  const Scalar t43 = c_6 * t37 - s_6 * omega_5_z;
  const Scalar domega_r_7_a_z = c_6 * t27 + s_6 * t42 - qd_6 * t43;
  const Scalar t44 = t43 * omega_6_z;
  const Scalar U_6_zx = domega_r_7_a_z - t44;
  const Scalar t45 = t41 - Scalar(0.088) * U_6_zx;
  const Scalar ddp_7_x = c_7 * ddp_o_7_x - s_7 * t45;
  const Scalar t46 = c_7 * t45 + s_7 * ddp_o_7_x;
  const Scalar t47 = c_6 * t42 - s_6 * t27 + qd_6 * omega_r_6_y;
  const Scalar t48 = c_7 * t43 - s_7 * omega_6_z;
  const Scalar domega_5_y = c_5 * t5 - s_5 * t29 + qd_5 * t37;
  const Scalar t49 = c_7 * domega_5_y + s_7 * t47 - qd_7 * t48;
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar t50 = t48 * omega_7_z;
  const Scalar t51 = c_7 * omega_6_z + s_7 * t43;
  const Scalar t52 = c_7 * t47 - s_7 * domega_5_y + qd_7 * t51;
  const Scalar t53 = t51 * omega_7_z;
  const Scalar t54 = t51 * t51;
  const Scalar t55 = omega_7_z * omega_7_z;
  const Scalar t56 = t54 + t55;
  const Scalar t57 = t48 * t48;
  const Scalar t58 = t55 + t57;
  const Scalar t59 = t48 * t51;
  const Scalar t60 = domega_r_7_a_z + t59;
  const Scalar U_7_yx = domega_r_7_a_z - t59;
  const Scalar mu_u_7_a_y = Scalar(0.002034439958661797) * ddp_7_x +
      Scalar(0.002573605371338203) * t46 + Scalar(0.0009653051699191118) * (t52 - t53) +
      Scalar(0.000391391281684248) * (t56 - t58) - Scalar(0.0012555365982728983) * (t49 + t50) -
      Scalar(0.002131604094419858) * U_7_yx - Scalar(0.004552547872941088) * t60;
  const Scalar y_7 = mu_u_7_a_y + tau_7;
  const Scalar Iu_7_a_xy = Scalar(0.0012555365982728983) * c_7 +
      Scalar(0.0009653051699191118) * s_7;
  const Scalar t61 = Scalar(149.60760989322966) * Iu_7_a_xy;
  const Scalar t62 = c_6 * ddp_o_5_y - s_6 * ddp_5_x;
  const Scalar t63 = t43 * omega_r_6_y;
  const Scalar t64 = domega_5_y + t63;
  const Scalar t65 = t62 - Scalar(0.088) * t64;
  const Scalar U_7_zx = t49 - t50;
  const Scalar t66 = t52 + t53;
  const Scalar t67 = t54 + t57;
  const Scalar U_7_zz_xx = t56 - t67;
  const Scalar t68 = Scalar(0.000391391281684248) * t66 + Scalar(0.002573605371338203) * t65 -
      Scalar(0.0012555365982728983) * t60 - Scalar(0.0009653051699191118) * U_7_zz_xx -
      Scalar(0.002131604094419858) * U_7_zx;
  const Scalar t69 = Scalar(0.000391391281684248) * U_7_zx + Scalar(0.002034439958661797) * t65 +
      Scalar(0.0009653051699191118) * U_7_yx - Scalar(0.0012555365982728983) * (t58 - t67) -
      Scalar(0.004552547872941088) * t66;
  const Scalar F_7_z = Scalar(0.002034439958661797) * t66 + Scalar(0.002573605371338203) * U_7_zx;
  const Scalar t70 = omega_r_6_y * omega_6_z;
  const Scalar t71 = t43 * t43;
  const Scalar t72 = t71 + t39;
  const Scalar U_6_xy = domega_5_y - t63;
  const Scalar mu_6_z = Scalar(-0.000093569097314605) * (domega_r_7_a_z + t44) -
      Scalar(0.000103758917218685) * (t47 - t70) - Scalar(0.088) * F_7_z + c_7 * t68 - s_7 * t69 -
      Scalar(0.021522255370587554) * t64 - Scalar(0.028934422545659894) * U_6_xy -
      Scalar(0.014748570382675316) * (t40 - t72) + Scalar(0.173804705569) * ddp_6_x +
      Scalar(0.231847552695) * t62;
  const Scalar y_7_6 = t61 * y_7 - mu_6_z + tau_6;
  const Scalar Iu_7_t_g = Scalar(0.00242094377852123) * c_7 - Scalar(0.000782782563368496) * s_7;
  const Scalar hu_7_t_y = Scalar(0.002034439958661797) * c_7 + Scalar(0.002573605371338203) * s_7;
  const Scalar t73 = Scalar(0.088) * hu_7_t_y - Scalar(0.000287632364465563) - s_7 * Iu_7_t_g;
  const Scalar Ic_6_yz = Scalar(0.000093569097314605) + Iu_7_a_xy;
  const Scalar t74 = c_6 * Ic_6_yz - s_6 * t73;
  const Scalar hu_7_t_x = Scalar(0.002573605371338203) * c_7 - Scalar(0.002034439958661797) * s_7;
  const Scalar t75 = Scalar(0.088) * hu_7_t_x + Scalar(0.006684151967360946);
  const Scalar Iu_7_a_xz = Scalar(0.0009653051699191118) * c_7 -
      Scalar(0.0012555365982728983) * s_7;
  const Scalar t76 = s_6 * Iu_7_a_xz + c_6 * t75;
  const Scalar t77 = t74 - t76 * t61;
  const Scalar t78 = c_7 * Iu_7_t_g;
  const Scalar t79 = Scalar(0.176) * hu_7_t_x;
  const Scalar t80 = t78 - t79 - Scalar(0.055009225789188536);
  const Scalar t81 = Iu_7_a_xy * t61 + t80;
  const Scalar t82 = Scalar(1.0) / t81;
  const Scalar t83 = t77 * t82;
  const Scalar F_7_y = Scalar(0.002573605371338203) * U_7_yx - Scalar(0.002034439958661797) * t58;
  const Scalar t84 = Scalar(0.002034439958661797) * t60 + Scalar(0.002573605371338203) * t56;
  const Scalar t85 = c_7 * F_7_y - s_7 * t84;
  const Scalar t86 = t47 + t70;
  const Scalar t87 = t38 + t71;
  const Scalar U_6_zz_xx = t40 - t87;
  const Scalar t88 = Scalar(-0.000093569097314605) * U_6_xy -
      Scalar(0.000103758917218685) * U_6_zz_xx - Scalar(0.088) * t85 + mu_u_7_a_y +
      Scalar(0.014748570382675316) * t86 - Scalar(0.021522255370587554) * U_6_zx +
      Scalar(0.231847552695) * t41;
  const Scalar t89 = Scalar(0.000103758917218685) * t64 -
      Scalar(0.000093569097314605) * (t72 - t87) - s_7 * t68 - c_7 * t69 -
      Scalar(0.014748570382675316) * U_6_zx + Scalar(0.028934422545659894) * t86 +
      Scalar(0.173804705569) * t41;
  const Scalar t90 = t37 * omega_5_z;
  const Scalar U_5_xz = domega_5_y - t90;
  const Scalar t91 = omega_r_6_a_z * omega_5_z;
  const Scalar t92 = omega_r_6_a_z * omega_r_6_a_z;
  const Scalar t93 = omega_5_z * omega_5_z;
  const Scalar t94 = t92 + t93;
  const Scalar t95 = t37 * t37;
  const Scalar t96 = t95 + t93;
  const Scalar t97 = t37 * omega_r_6_a_z;
  const Scalar U_5_xy = t27 + t97;
  const Scalar t98 = t27 - t97;
  const Scalar t99 = Scalar(0.001451156065026714) * t98 - Scalar(0.00216405205209813) * U_5_xz -
      Scalar(0.00151524447332703) * (t94 - t96) + Scalar(0.004600245517563106) * (t42 + t91) +
      Scalar(0.014653732538) * t41 + Scalar(0.010045187828321245) * U_5_xy +
      Scalar(0.067870631425) * ddp_5_x - c_6 * t88 - s_6 * t89;
  const Scalar t100 = Scalar(149.60760989322966) * t76;
  const Scalar y_6_5 = t83 * y_7_6 + t99 + t100 * y_7 + tau_5;
  const Scalar Ic_6_xx = t78 + Scalar(0.03106602664007975);
  const Scalar Ic_6_yy = t79 + Scalar(0.028206407337948502);
  const Scalar Iu_6_t_d = Ic_6_xx - Ic_6_yy;
  const Scalar Ic_6_xy = Iu_7_a_xz + Scalar(0.014748570382675316);
  const Scalar t101 = c_6 * Iu_6_t_d - Scalar(2.0) * s_6 * Ic_6_xy;
  const Scalar Ic_5_xz = Ic_6_xy - Scalar(0.004600245517563106) + s_6 * t101;
  const Scalar t102 = t74 - Scalar(0.00216405205209813);
  const Scalar hc_6_x = hu_7_t_x + Scalar(0.231847552695);
  const Scalar hu_6_t_x = Scalar(0.173804705569) * s_6 + c_6 * hc_6_x;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.014653732538);
  const Scalar f_5_5_x = hu_7_t_y - Scalar(0.067870631425);
  const Scalar t103 = c_5 * f_5_5_x - s_5 * hc_5_x;
  const Scalar t104 = Scalar(0.384) * t103 - (c_5 * t102 - s_5 * Ic_5_xz);
  const Scalar Iu_6_a_xz = c_6 * t73 + s_6 * Ic_6_yz;
  const Scalar f_u_6_6_t_x = Scalar(0.173804705569) * c_6 - s_6 * hc_6_x;
  const Scalar t105 = t80 + Scalar(0.384) * f_u_6_6_t_x;
  const Scalar mu_u_6_4_a_y = Scalar(0.0825) * hu_6_t_x - s_5 * Iu_6_a_xz + c_5 * t105;
  const Scalar t106 = c_6 * Iu_7_a_xz - s_6 * t75;
  const Scalar t107 = c_6 * hu_7_t_y;
  const Scalar t108 = c_5 * t107 - s_5 * hu_7_t_x;
  const Scalar t109 = s_6 * hu_7_t_y;
  const Scalar t110 = Scalar(0.0825) * t109 + Scalar(0.384) * t108 - c_5 * Iu_7_a_xy + s_5 * t106;
  const Scalar t111 = mu_u_6_4_a_y - t110 * t61;
  const Scalar t112 = t111 * t83 - t110 * t100 + t104;
  const Scalar t113 = c_6 * t101;
  const Scalar Ic_5_zz = Scalar(0.011496343893347959) + Ic_6_xx - t113;
  const Scalar b_6_5_5 = t77 * t83 - t76 * t100 + Ic_5_zz;
  const Scalar d_5 = Scalar(1.0) / b_6_5_5;
  const Scalar t114 = t112 * d_5;
  const Scalar t115 = domega_5_y + t90;
  const Scalar t116 = t42 - t91;
  const Scalar t117 = t92 + t95;
  const Scalar mu_5_x = Scalar(-0.00151524447332703) * t115 -
      Scalar(0.00216405205209813) * (t96 - t117) + Scalar(0.004600245517563106) * t98 +
      Scalar(0.010045187828321245) * t116 + Scalar(0.067870631425) * ddp_o_5_y + c_6 * t89 -
      s_6 * t88;
  const Scalar t118 = c_7 * t84 + s_7 * F_7_y + Scalar(0.173804705569) * U_6_xy +
      Scalar(0.231847552695) * t40;
  const Scalar t119 = F_7_z + Scalar(0.231847552695) * t64 - Scalar(0.173804705569) * t72;
  const Scalar f_5_x = Scalar(0.014653732538) * t94 + Scalar(0.067870631425) * U_5_xy - c_6 * t118 +
      s_6 * t119;
  const Scalar f_5_y = Scalar(0.014653732538) * t98 - t85 - Scalar(0.067870631425) * t96 -
      Scalar(0.231847552695) * U_6_zx + Scalar(0.173804705569) * t86;
  const Scalar t120 = c_5 * f_5_x - s_5 * f_5_y;
  const Scalar U_5_zz_xx = t94 - t117;
  const Scalar mu_5_y = Scalar(0.001451156065026714) * t115 - Scalar(0.00216405205209813) * U_5_xy -
      Scalar(0.00151524447332703) * t116 + Scalar(0.014653732538) * ddp_o_5_y -
      Scalar(0.004600245517563106) * U_5_zz_xx - mu_6_z;
  const Scalar f_5_z = Scalar(0.014653732538) * t115 + Scalar(0.067870631425) * t116 - c_6 * t119 -
      s_6 * t118;
  const Scalar mu_u_4_a_y = Scalar(-0.00164448757736927) * (t27 + t28) -
      Scalar(0.0039053550262761) * (t29 - t30) + Scalar(0.0510201361568155) * t34 +
      Scalar(0.0825) * f_5_z + c_5 * mu_5_y + s_5 * mu_5_x + Scalar(0.55278027465) * ddp_4_y +
      Scalar(0.384) * t120 + Scalar(0.16284087268546085) * (t21 - t36) +
      Scalar(2.012523553603) * ddp_4_x + Scalar(0.6972920750309718) * t24;
  const Scalar t121 = t111 * t82;
  const Scalar t122 = Scalar(-149.60760989322966) * t110;
  const Scalar y_5_4 = t122 * y_7 + tau_4 - t121 * y_7_6 + mu_u_4_a_y + t114 * y_6_5;
  const Scalar Ic_5_xx = Scalar(0.010045187828321245) + Ic_6_yy + t113;
  const Scalar t123 = t80 - Scalar(0.001451156065026714);
  const Scalar Iu_5_t_d = Ic_5_xx + t123;
  const Scalar Ic_5_xy = Iu_6_a_xz - Scalar(0.00151524447332703);
  const Scalar t124 = c_5 * Iu_5_t_d - Scalar(2.0) * s_5 * Ic_5_xy;
  const Scalar t125 = Scalar(-0.0825) * t103;
  const Scalar t126 = Ic_5_xy - Scalar(0.0039053550262761) + t125 + s_5 * t124;
  const Scalar t127 = Scalar(0.00164448757736927) + t104;
  const Scalar Iu_4_a_xy = s_4 * t126 + c_4 * t127;
  const Scalar hu_5_t_x = s_5 * f_5_5_x + c_5 * hc_5_x;
  const Scalar t128 = Scalar(0.384) * hu_5_t_x - (s_5 * t102 + c_5 * Ic_5_xz);
  const Scalar t129 = Scalar(0.0825) * hu_5_t_x;
  const Scalar mu_5_4_y = Ic_5_zz - t129;
  const Scalar mu_5_3_z = t129 + c_4 * mu_5_4_y - s_4 * t128;
  const Scalar t130 = s_5 * f_u_6_6_t_x;
  const Scalar t131 = Scalar(0.0825) * t130;
  const Scalar t132 = t74 - t131;
  const Scalar t133 = c_5 * Iu_6_a_xz + s_5 * t105;
  const Scalar mu_6_3_z = t131 + c_4 * t132 - s_4 * t133;
  const Scalar f_u_7_5_a_z = c_5 * hu_7_t_x + s_5 * t107;
  const Scalar t134 = Scalar(0.0825) * f_u_7_5_a_z;
  const Scalar t135 = t76 - t134;
  const Scalar mu_7_4_x = Scalar(0.384) * f_u_7_5_a_z - s_5 * Iu_7_a_xy - c_5 * t106;
  const Scalar mu_u_7_3_a_y = t134 + c_4 * t135 - s_4 * mu_7_4_x;
  const Scalar b_7_6_3 = mu_6_3_z - mu_u_7_3_a_y * t61;
  const Scalar b_6_5_3 = b_7_6_3 * t83 - mu_u_7_3_a_y * t100 + mu_5_3_z;
  const Scalar t136 = mu_u_7_3_a_y * t122 + Iu_4_a_xy + b_7_6_3 * t121 - b_6_5_3 * t114;
  const Scalar t137 = c_5 * t124;
  const Scalar t138 = Scalar(0.165) * hu_5_t_x;
  const Scalar t139 = Scalar(0.768) * f_u_6_6_t_x;
  const Scalar t140 = Ic_5_xx - t138 - t137 - t139 + Scalar(0.7483122111877872);
  const Scalar t141 = t110 * t122 + t111 * t121 - t112 * t114 + t140;
  const Scalar t142 = Scalar(1.0) / t141;
  const Scalar t143 = t136 * t142;
  const Scalar f_u_5_t_y = c_5 * f_5_y + s_5 * f_5_x;
  const Scalar t144 = t19 + t35;
  const Scalar t145 = Scalar(0.0039053550262761) * t34 -
      Scalar(0.00164448757736927) * (t36 - t144) - c_5 * mu_5_x + s_5 * mu_5_y +
      Scalar(0.16284087268546085) * U_4_zx + Scalar(0.384) * f_u_5_t_y +
      Scalar(2.012523553603) * ddp_o_4_y - Scalar(0.6972920750309718) * t31;
  const Scalar U_4_zz_xx = t21 - t144;
  const Scalar t146 = Scalar(-0.00164448757736927) * t24 - Scalar(0.0039053550262761) * U_4_zz_xx +
      Scalar(0.0510201361568155) * U_4_zx + Scalar(0.0825) * f_u_5_t_y +
      Scalar(0.55278027465) * ddp_o_4_y - Scalar(0.16284087268546085) * t31 + t99;
  const Scalar f_u_4_a_y = f_u_5_t_y + Scalar(0.55278027465) * U_4_zx -
      Scalar(2.012523553603) * t31;
  const Scalar t147 = omega_r_3_y * omega_3_z;
  const Scalar t148 = t2 * t2;
  const Scalar t149 = t148 + t15;
  const Scalar U_3_xy = t26 - t32;
  const Scalar t150 = Scalar(0.004377257121839584) * (t5 - t6) -
      Scalar(0.000121912420950744) * (t16 - t149) + Scalar(0.005487648106562256) * (t25 - t147) +
      Scalar(0.028227094878) * t13 + Scalar(0.022178148964878235) * U_3_xy +
      Scalar(0.061602421026527694) * t33 - Scalar(0.0825) * f_u_4_a_y + c_4 * t146 -
      Scalar(0.746857959872) * ddp_3_y + s_4 * t145;
  const Scalar t151 = b_6_5_3 * d_5;
  const Scalar t152 = b_7_6_3 * t82;
  const Scalar t153 = Scalar(149.60760989322966) * mu_u_7_3_a_y;
  const Scalar y_4_3 = t153 * y_7 + t143 * y_5_4 + tau_3 + t150 + t152 * y_7_6 - t151 * y_6_5;
  const Scalar t154 = t123 - t137 + t139 - Scalar(0.6972920750309718);
  const Scalar Ic_4_yy = Ic_5_zz - t138 + Scalar(0.0510201361568155);
  const Scalar t155 = Scalar(0.0825) * f_u_6_6_t_x + t128 - Scalar(0.16284087268546085);
  const Scalar t156 = c_4 * (Ic_4_yy + t154) - Scalar(2.0) * s_4 * t155;
  const Scalar hc_4_x = hu_5_t_x - Scalar(0.55278027465);
  const Scalar f_4_4_x = f_u_6_6_t_x - Scalar(2.012523553603);
  const Scalar t157 = c_4 * f_4_4_x - s_4 * hc_4_x;
  const Scalar t158 = Scalar(0.005487648106562256) - Scalar(0.0825) * t157 + t155 + s_4 * t156;
  const Scalar Ic_3_yz = Iu_4_a_xy - Scalar(0.004377257121839584);
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * f_4_4_x;
  const Scalar hc_3_x = Scalar(0.746857959872) + hu_4_t_x;
  const Scalar t159 = t103 - Scalar(0.028227094878);
  const Scalar t160 = c_3 * t159 - s_3 * hc_3_x;
  const Scalar t161 = Scalar(0.316) * t160 + (c_3 * Ic_3_yz - s_3 * t158);
  const Scalar t162 = c_4 * t126 - s_4 * t127;
  const Scalar t163 = s_4 * mu_5_4_y + c_4 * t128;
  const Scalar t164 = s_4 * t125 + t104;
  const Scalar mu_u_7_4_t_x = c_4 * mu_7_4_x + s_4 * t135;
  const Scalar t165 = c_4 * t108 - s_4 * t109;
  const Scalar t166 = c_3 * t165 - s_3 * f_u_7_5_a_z;
  const Scalar t167 = t110 - Scalar(0.0825) * (c_4 * t109 + s_4 * t108);
  const Scalar t168 = Scalar(0.316) * t166 + c_3 * t167 - s_3 * mu_u_7_4_t_x;
  const Scalar t169 = s_4 * t132 + c_4 * t133;
  const Scalar t170 = c_5 * f_u_6_6_t_x;
  const Scalar t171 = c_4 * t170 - s_4 * hu_6_t_x;
  const Scalar t172 = c_3 * t171 - s_3 * t130;
  const Scalar f_u_6_4_t_y = s_4 * t170 + c_4 * hu_6_t_x;
  const Scalar mu_6_3_y = mu_u_6_4_a_y - Scalar(0.0825) * f_u_6_4_t_y;
  const Scalar t173 = Scalar(0.316) * t172 - t168 * t61 + c_3 * mu_6_3_y - s_3 * t169;
  const Scalar t174 = c_4 * t103;
  const Scalar t175 = c_3 * t174 - s_3 * hu_5_t_x;
  const Scalar t176 = t173 * t83 - t168 * t100 + Scalar(0.316) * t175 + c_3 * t164 - s_3 * t163;
  const Scalar t177 = Scalar(0.316) * t157 - (Scalar(0.0825) * hu_4_t_x + t140);
  const Scalar t178 = t168 * t122 + s_3 * t162 + t173 * t121 - t176 * t114 - c_3 * t177;
  const Scalar t179 = t173 * t152 - t168 * t153 - t176 * t151 - t178 * t143 + t161;
  const Scalar t180 = c_4 * t156;
  const Scalar t181 = Scalar(0.165) * hu_4_t_x;
  const Scalar t182 = Scalar(-0.08378056999140593) - t181 - t180 + t154;
  const Scalar t183 = mu_u_7_3_a_y * t153 + t136 * t143 - b_7_6_3 * t152 + b_6_5_3 * t151 + t182;
  const Scalar t184 = Scalar(1.0) / t183;
  const Scalar t185 = t179 * t184;
  const Scalar t186 = t25 + t147;
  const Scalar t187 = t14 + t148;
  const Scalar mu_3_x = Scalar(0.005487648106562256) * t33 - Scalar(0.000121912420950744) * t7 +
      Scalar(0.004377257121839584) * (t149 - t187) + Scalar(0.028227094878) * ddp_3_a_z +
      Scalar(0.022178148964878235) * t186 + s_4 * t146 - c_4 * t145;
  const Scalar t188 = t178 * t142;
  const Scalar f_4_x = t120 + Scalar(0.55278027465) * t21 + Scalar(2.012523553603) * t24;
  const Scalar t189 = Scalar(0.55278027465) * t34 + f_5_z - Scalar(2.012523553603) * t36;
  const Scalar t190 = Scalar(0.746857959872) * t16 - Scalar(0.028227094878) * U_3_xy - c_4 * f_4_x +
      s_4 * t189;
  const Scalar t191 = Scalar(0.028227094878) * t149 + Scalar(0.746857959872) * t33 - f_u_4_a_y;
  const Scalar t192 = c_3 * t190 - s_3 * t191;
  const Scalar f_u_4_t_y = c_4 * t189 + s_4 * f_4_x;
  const Scalar U_3_zz_xx = t16 - t187;
  const Scalar t193 = Scalar(0.000121912420950744) * t186 - Scalar(0.004377257121839584) * U_3_xy +
      Scalar(0.005487648106562256) * U_3_zz_xx - Scalar(0.061602421026527694) * t7 +
      Scalar(0.0825) * f_u_4_t_y + Scalar(0.746857959872) * ddp_3_a_z - mu_u_4_a_y;
  const Scalar t194 = t176 * d_5;
  const Scalar t195 = t173 * t82;
  const Scalar t196 = Scalar(-149.60760989322966) * t168;
  const Scalar t197 = t3 * t3 + t8;
  const Scalar t198 = Scalar(0.01993386669246) * c_2 + Scalar(0.00398335888393552) * (t197 - t9) -
      Scalar(1.0090841787369491) * t11 + t196 * y_7 - tau_2 - Scalar(0.316) * t192 - c_3 * t193 +
      s_3 * mu_3_x - t195 * y_7_6 - t185 * y_4_3 - Scalar(32.80954542685272) * s_2 + t194 * y_6_5 -
      t188 * y_5_4;
  const Scalar Ic_3_xx = Scalar(0.022178148964878235) + Ic_4_yy - t180;
  const Scalar t199 = Scalar(0.061602421026527694) + t181 + t140;
  const Scalar Iu_3_t_d = Ic_3_xx - t199;
  const Scalar t200 = Scalar(0.000121912420950744) + t125 - t162;
  const Scalar t201 = Scalar(2.0) * s_3 * t200 + c_3 * Iu_3_t_d;
  const Scalar t202 = c_3 * t201;
  const Scalar t203 = Scalar(-0.632) * t157;
  const Scalar t204 = t168 * t196 + t173 * t195 - t176 * t194 + Ic_3_xx - t202 + t179 * t185 +
      t203 - t178 * t188 + Scalar(1.0552399437268125);
  const Scalar t205 = Scalar(1.0) / t204;
  const Scalar t206 = s_2 * (t200 - Scalar(0.01026110182100817) - s_3 * t201);
  const Scalar t207 = s_3 * t159 + c_3 * hc_3_x;
  const Scalar t208 = Scalar(0.316) * t207 + (s_3 * Ic_3_yz + c_3 * t158);
  const Scalar t209 = s_2 * (c_3 * t162 + s_3 * t177);
  const Scalar t210 = c_3 * hu_5_t_x + s_3 * t174;
  const Scalar t211 = s_2 * (Scalar(0.316) * t210 + c_3 * t163 + s_3 * t164);
  const Scalar t212 = c_3 * f_u_7_5_a_z + s_3 * t165;
  const Scalar t213 = s_2 * (Scalar(0.316) * t212 + c_3 * mu_u_7_4_t_x + s_3 * t167);
  const Scalar t214 = c_2 * mu_u_7_3_a_y + t213;
  const Scalar t215 = c_3 * t130 + s_3 * t171;
  const Scalar t216 = s_2 * (Scalar(0.316) * t215 + c_3 * t169 + s_3 * mu_6_3_y);
  const Scalar b_7_6_1 = c_2 * mu_6_3_z - t214 * t61 + t216;
  const Scalar t217 = b_7_6_1 * t83 - t214 * t100 + c_2 * mu_5_3_z + t211;
  const Scalar t218 = t214 * t122 + c_2 * Iu_4_a_xy + b_7_6_1 * t121 - t217 * t114 - t209;
  const Scalar t219 = t214 * t153 - b_7_6_1 * t152 + t217 * t151 + t218 * t143 - s_2 * t208 +
      c_2 * t182;
  const Scalar t220 = t214 * t196 + b_7_6_1 * t195 - t217 * t194 +
      c_2 * (t161 - Scalar(0.0007689361029464)) + t206 - t218 * t188 - t219 * t185;
  const Scalar t221 = t220 * t205;
  const Scalar t222 = c_3 * t191 + s_3 * t190;
  const Scalar t223 = qd_1 * qd_1;
  const Scalar t224 = Scalar(0.01026110182100817) * t11 - Scalar(0.0007689361029464) * (t9 - t223) -
      Scalar(0.00796671776787104) * t26 - Scalar(2.064324122463762) * t4 + Scalar(0.316) * t222 +
      c_3 * mu_3_x + s_3 * t193;
  const Scalar t225 = t219 * t184;
  const Scalar U_2_zz_xx = t197 - t223;
  const Scalar t226 = Scalar(0.0007689361029464) * t11 - Scalar(0.00796671776787104) * t4 -
      Scalar(0.01026110182100817) * U_2_zz_xx - Scalar(0.04615576498986361) * t26 - t150;
  const Scalar t227 = t218 * t142;
  const Scalar t228 = t217 * d_5;
  const Scalar t229 = b_7_6_1 * t82;
  const Scalar t230 = Scalar(-149.60760989322966) * t214;
  const Scalar y_2_1 = tau_1 - t230 * y_7 - c_2 * t226 + t229 * y_7_6 + s_2 * t224 - t228 * y_6_5 +
      t227 * y_5_4 - t225 * y_4_3 + t221 * t198;
  const Scalar t231 = t202 + t199 + t203 + Scalar(1.032162061231881);
  const Scalar t232 = c_2 * (t182 - Scalar(0.023077882494931805) + t231) -
      Scalar(2.0) * s_2 * (t208 - Scalar(0.00398335888393552));
  const Scalar t233 = t214 * t230 + Scalar(0.014259565994474374) + b_7_6_1 * t229 - t217 * t228 -
      t218 * t227 - t220 * t221 + t219 * t225 + t231 - c_2 * t232;
  const Scalar qdd_1 = (Scalar(1.0) / t233) * y_2_1;
  qdd[0] = qdd_1;
  const Scalar t234 = t205 * (t220 * qdd_1 + t198);
  qdd[1] = -t234;
  const Scalar t235 = t184 * ((y_4_3 + t179 * t234) + t219 * qdd_1);
  qdd[2] = -t235;
  const Scalar t236 = t142 * ((t178 * t234 - t218 * qdd_1) - (y_5_4 - t136 * t235));
  qdd[3] = -t236;
  const Scalar t237 = (y_6_5 - t112 * t236) - t217 * qdd_1;
  const Scalar qdd_5 = d_5 * ((b_6_5_3 * t235 + t176 * t234) + t237);
  qdd[4] = qdd_5;
  const Scalar t238 = (t111 * t236 - b_7_6_3 * t235) - (y_7_6 - t77 * qdd_5);
  const Scalar qdd_6 = t82 * (t238 - (t173 * t234 - b_7_6_1 * qdd_1));
  qdd[5] = qdd_6;
  const Scalar t239 = (t168 * t234 + mu_u_7_3_a_y * t235) - (t110 * t236 + t76 * qdd_5);
  qdd[6] = Scalar(149.60760989322966) * (t214 * qdd_1 + (Iu_7_a_xy * qdd_6 + y_7)) -
      Scalar(149.60760989322966) * t239;
  bool positive = t233 > Scalar(0.0);
  positive &= t204 > Scalar(0.0);
  positive &= -t183 > Scalar(0.0);
  positive &= t141 > Scalar(0.0);
  positive &= b_6_5_5 > Scalar(0.0);
  positive &= -t81 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[7]   in  joint positions, rad or m
//   qd[7]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1..6], qd[0..6]. Operations: 133 mul, 94 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar kinetic_energy(const Scalar* q, const Scalar* qd,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5],
      s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = s_2 * qd_1;
  const Scalar omega_r_3_y = s_3 * t1 + c_3 * qd_2;
  const Scalar t2 = Scalar(0.0825) * omega_r_3_y;
  const Scalar t3 = Scalar(0.316) * omega_r_3_y;
  const Scalar t4 = s_4 * t2 - c_4 * t3;
  const Scalar omega_r_5_a_y = omega_r_3_y - qd_4;
  const Scalar t5 = t4 - Scalar(0.384) * omega_r_5_a_y;
  const Scalar t6 = s_3 * qd_2 - c_3 * t1;
  const Scalar t7 = c_2 * qd_1;
  const Scalar omega_3_z = t7 + qd_3;
  const Scalar t8 = c_4 * t6 + s_4 * omega_3_z;
  const Scalar t9 = s_4 * t6 - c_4 * omega_3_z;
  const Scalar t10 = Scalar(0.316) * t6 - Scalar(0.0825) * omega_3_z;
  const Scalar t11 = t10 - Scalar(0.0825) * t9 + Scalar(0.384) * t8;
  const Scalar t12 = s_5 * t11 + c_5 * t5;
  const Scalar t13 = c_4 * t2 + s_4 * t3;
  const Scalar t14 = t13 - Scalar(0.0825) * omega_r_5_a_y;
  const Scalar t15 = s_6 * t14 + c_6 * t12;
  const Scalar t16 = s_5 * t5 - c_5 * t11;
  const Scalar t17 = s_5 * omega_r_5_a_y + c_5 * t8;
  const Scalar t18 = t9 - qd_5;
  const Scalar t19 = s_6 * t17 + c_6 * t18;
  const Scalar t20 = t16 - Scalar(0.088) * t19;
  const Scalar t21 = c_7 * t15 + s_7 * t20;
  const Scalar t22 = s_7 * t15 - c_7 * t20;
  const Scalar t23 = s_6 * t18 - c_6 * t17;
  const Scalar t24 = s_5 * t8 - c_5 * omega_r_5_a_y;
  const Scalar t25 = t24 + qd_6;
  const Scalar t26 = s_7 * t25 - c_7 * t23;
  const Scalar t27 = s_7 * t23 + c_7 * t25;
  const Scalar t28 = t19 + qd_7;
  const Scalar t29 = Scalar(0.0009653051699191118) * t26 + Scalar(0.0012555365982728983) * t27 -
      Scalar(0.004068879917323594) * t21 - Scalar(0.005147210742676406) * t22 -
      Scalar(0.006684151967360946) * t28;
  const Scalar t30 = s_6 * t12 - c_6 * t14;
  const Scalar t31 = Scalar(0.088) * t25 + t30;
  const Scalar t32 = t27 * (Scalar(0.000391391281684248) * t26 +
      Scalar(0.005147210742676406) * t31 - Scalar(0.0012555365982728983) * t28);
  const Scalar t33 = Scalar(0.004068879917323594) * t31 - Scalar(0.000391391281684248) * t27 +
      Scalar(0.0009653051699191118) * t28 - Scalar(0.00242094377852123) * t26;
  const Scalar L_6_z = Scalar(0.000103758917218685) * t23 - Scalar(0.000093569097314605) * t19 +
      Scalar(0.05258828201066731) * t25 - Scalar(0.347609411138) * t15 +
      Scalar(0.46369510539) * t30;
  const Scalar t34 = t19 * (Scalar(0.000093569097314605) * t25 -
      Scalar(0.014748570382675316) * t23 + Scalar(0.46369510539) * t16);
  const Scalar t35 = Scalar(-0.000103758917218685) * t25 - Scalar(0.009543771269492195) * t23 -
      Scalar(0.014748570382675316) * t19 + Scalar(0.347609411138) * t16;
  const Scalar t36 = Scalar(0.00216405205209813) * t24 + Scalar(0.004600245517563106) * t17 +
      Scalar(0.029307465076) * t16 - Scalar(0.13574126285) * t12 +
      Scalar(0.033018599263935515) * t18;
  const Scalar t37 = t24 * (Scalar(0.00151524447332703) * t17 + Scalar(0.00216405205209813) * t18 +
      Scalar(0.029307465076) * t14);
  const Scalar t38 = Scalar(-0.00151524447332703) * t24 - Scalar(0.004600245517563106) * t18 +
      Scalar(0.13574126285) * t14 - Scalar(0.030116287133882085) * t17;
  const Scalar t39 = Scalar(0.00164448757736927) * t9 + Scalar(0.0039053550262761) * t8 +
      Scalar(1.1055605493) * t13 + Scalar(4.025047107206) * t4 -
      Scalar(0.749763367252814) * omega_r_5_a_y;
  const Scalar t40 = t9 * (Scalar(0.00164448757736927) * omega_r_5_a_y +
      Scalar(1.1055605493) * t10 + Scalar(0.16284087268546085) * t8);
  const Scalar t41 = Scalar(-0.0039053550262761) * omega_r_5_a_y -
      Scalar(0.16284087268546085) * t9 + Scalar(4.025047107206) * t10 +
      Scalar(0.647723094939183) * t8;
  const Scalar L_2_y = Scalar(0.0007689361029464) * qd_2 + Scalar(0.00398335888393552) * t1;
  const Scalar L_2_x = Scalar(0.00398335888393552) * t7 + Scalar(0.01026110182100817) * qd_2 -
      Scalar(1.0706865997634767) * t1;
  const Scalar t42 = qd_1 * (Scalar(0.03733744848940618) * qd_1 - (c_2 * L_2_y + s_2 * L_2_x));
  const Scalar t43 = omega_3_z * (Scalar(0.022216781084735585) * omega_r_3_y -
      Scalar(0.13480070614822143) * omega_3_z + Scalar(0.47750187874566624) * t6);
  const Scalar t44 = omega_r_3_y *
      (Scalar(0.000121912420950744) * t6 + Scalar(0.004377257121839584) * omega_3_z);
  const Scalar t45 = t6 * (Scalar(0.01159586409516604) * t6 -
      Scalar(0.000121912420950744) * omega_r_3_y - Scalar(0.005487648106562256) * omega_3_z);
  const Scalar L_2_z = Scalar(-0.0007689361029464) * t7 - Scalar(0.01026110182100817) * t1 +
      Scalar(1.1168423647533403) * qd_2;
  const Scalar t46 = t26 * t33 - t32 + t44 - t37 - t45 + t28 * t29 + t17 * t38 - t18 * t36 -
      t25 * L_6_z + t34 + t23 * t35 + t40 + t43 - t42 + omega_r_5_a_y * t39 - t8 * t41 -
      qd_2 * L_2_z;
  return Scalar(-0.5) * t46;
}

// Potential energy of links and rotors (7.36).
//   q[7]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[1..6]. Operations: 21 mul, 20 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar potential_energy(const Scalar* q, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5],
      s_7 = sine[6], c_7 = cosine[6];
  const Scalar hu_7_t_x = Scalar(0.002573605371338203) * c_7 - Scalar(0.002034439958661797) * s_7;
  const Scalar hc_6_x = hu_7_t_x + Scalar(0.231847552695);
  const Scalar hu_6_t_x = Scalar(0.173804705569) * s_6 + c_6 * hc_6_x;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.014653732538);
  const Scalar hu_7_t_y = Scalar(0.002034439958661797) * c_7 + Scalar(0.002573605371338203) * s_7;
  const Scalar t1 = hu_7_t_y - Scalar(0.067870631425);
  const Scalar hu_5_t_x = s_5 * t1 + c_5 * hc_5_x;
  const Scalar hc_4_x = hu_5_t_x - Scalar(0.55278027465);
  const Scalar t2 = (Scalar(0.173804705569) * c_6 - s_6 * hc_6_x) - Scalar(2.012523553603);
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * t2;
  const Scalar hc_3_x = Scalar(0.746857959872) + hu_4_t_x;
  const Scalar hu_5_a_z = c_5 * t1 - s_5 * hc_5_x;
  const Scalar hu_3_t_x = s_3 * (hu_5_a_z - Scalar(0.028227094878)) + c_3 * hc_3_x;
  const Scalar hc_2_x = hu_3_t_x - Scalar(0.002031994566);
  const Scalar hu_3_a_y = c_4 * t2 - s_4 * hc_4_x;
  const Scalar hc_2_y = hu_3_a_y - Scalar(3.344500043512);
  const Scalar hu_2_t_y = s_2 * hc_2_x + c_2 * hc_2_y;
  return Scalar(-9.81) * (hu_2_t_y - Scalar(5.396538059926));
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    1, 1, 1,
    1, 1, 1,
    1, 1, 1};

// Pose of the tip (2.50).
//   q[7]  in   joint positions, rad or m
//   R[9]  out  rotation matrix of the frame in the base frame
//              3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]  out  position of the frame's origin in the base frame, m
// Reads q[0..6]. Operations: 86 mul, 45 add, 14 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void forward_kinematics(const Scalar* q, Scalar* R, Scalar* p,
    const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = c_4 * s_6;
  const Scalar a_4_t_x = s_4 * c_6 + c_5 * t1;
  const Scalar t2 = s_3 * s_5;
  const Scalar t3 = s_6 * t2 - c_3 * a_4_t_x;
  const Scalar t4 = s_4 * s_6;
  const Scalar t5 = c_5 * t4 - c_4 * c_6;
  R[8] = s_2 * t3 + c_2 * t5;
  const Scalar n_6_a_y = Scalar(0.7071067811865476) * c_7 - Scalar(0.7071067811865476) * s_7;
  const Scalar t6 = s_5 * n_6_a_y;
  const Scalar n_7_t_x = Scalar(0.7071067811865476) * c_7 + Scalar(0.7071067811865476) * s_7;
  const Scalar t7 = c_5 * c_6;
  const Scalar t8 = t6 - n_7_t_x * t7;
  const Scalar t9 = n_7_t_x * t4 + c_4 * t8;
  const Scalar t10 = s_5 * n_7_t_x;
  const Scalar n_5_t_y = c_6 * t10 + c_5 * n_6_a_y;
  const Scalar t11 = s_3 * n_5_t_y + c_3 * t9;
  const Scalar t12 = s_4 * t8 - n_7_t_x * t1;
  R[6] = s_2 * t11 - c_2 * t12;
  const Scalar s_5_t_x = t10 + n_6_a_y * t7;
  const Scalar t13 = n_6_a_y * t4 - c_4 * s_5_t_x;
  const Scalar t14 = c_6 * t6 - c_5 * n_7_t_x;
  const Scalar t15 = s_3 * t14 + c_3 * t13;
  const Scalar s_4_t_y = s_4 * s_5_t_x + n_6_a_y * t1;
  R[7] = s_2 * t15 + c_2 * s_4_t_y;
  const Scalar a_2_t_x = s_2 * t5 - c_2 * t3;
  const Scalar t16 = c_3 * s_5;
  const Scalar a_3_t_y = s_3 * a_4_t_x + s_6 * t16;
  R[5] = s_1 * a_2_t_x + c_1 * a_3_t_y;
  const Scalar p_6u_t_x = Scalar(0.088) * c_6 + Scalar(0.2104) * s_6;
  const Scalar p_5_x = c_5 * p_6u_t_x - Scalar(0.0825);
  const Scalar t17 = Scalar(0.2104) * c_6 - Scalar(0.088) * s_6 - Scalar(0.384);
  const Scalar p_4_x = c_4 * p_5_x + Scalar(0.0825) + s_4 * t17;
  const Scalar t18 = t2 * p_6u_t_x - c_3 * p_4_x;
  const Scalar t19 = s_4 * p_5_x - c_4 * t17 + Scalar(0.316);
  p[2] = s_2 * t18 + c_2 * t19 + Scalar(0.333);
  R[2] = c_1 * a_2_t_x - s_1 * a_3_t_y;
  const Scalar t20 = s_2 * t12 + c_2 * t11;
  const Scalar t21 = s_3 * t9 - c_3 * n_5_t_y;
  R[0] = s_1 * t21 - c_1 * t20;
  const Scalar s_2_t_x = s_2 * s_4_t_y - c_2 * t15;
  const Scalar t22 = s_3 * t13 - c_3 * t14;
  R[1] = s_1 * t22 + c_1 * s_2_t_x;
  R[4] = s_1 * s_2_t_x - c_1 * t22;
  const Scalar p_2u_t_x = s_2 * t19 - c_2 * t18;
  const Scalar p_3u_t_y = t16 * p_6u_t_x + s_3 * p_4_x;
  p[1] = s_1 * p_2u_t_x + c_1 * p_3u_t_y;
  R[3] = -s_1 * t20 - c_1 * t21;
  p[0] = c_1 * p_2u_t_x - s_1 * p_3u_t_y;
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[42] = {
    1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1,
    0, 1, 1, 1, 1, 1, 1,
    0, 1, 1, 1, 1, 1, 1,
    0, 1, 1, 1, 1, 1, 1,
    1, 0, 1, 1, 1, 1, 1};

// Geometric Jacobian of the tip (7.14), (7.15).
//   q[7]   in   joint positions, rad or m
//   J[42]  out  geometric Jacobian in base axes: linear rows, then angular
//               6 x 7, row by row: entry (i, j) is J[7 * i + j]
// Reads q[0..5]. Operations: 121 mul, 67 add, 12 sin/cos. Always zero: 4 of the 42 entries of J.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian(const Scalar* q, Scalar* J, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5];
  J[29] = c_1;
  J[37] = c_2;
  J[22] = -s_1;
  const Scalar z_3_x = c_1 * s_2;
  J[23] = z_3_x;
  const Scalar z_3_y = s_1 * s_2;
  J[30] = z_3_y;
  const Scalar t1 = s_2 * s_3;
  J[38] = -t1;
  const Scalar t2 = c_1 * c_2;
  const Scalar t3 = s_1 * c_3;
  const Scalar z_4_x = t3 + s_3 * t2;
  J[24] = z_4_x;
  const Scalar t4 = s_2 * c_3;
  const Scalar R_42_y = c_2 * c_4 + s_4 * t4;
  J[39] = R_42_y;
  const Scalar t5 = s_1 * s_3;
  const Scalar t6 = c_1 * c_3 - c_2 * t5;
  J[31] = -t6;
  const Scalar t7 = t5 - c_3 * t2;
  const Scalar R_40_y = c_4 * z_3_x + s_4 * t7;
  J[25] = R_40_y;
  const Scalar R_31_x = c_1 * s_3 + c_2 * t3;
  const Scalar R_41_y = c_4 * z_3_y - s_4 * R_31_x;
  J[32] = R_41_y;
  const Scalar t8 = c_2 * s_4 - c_4 * t4;
  const Scalar R_52_y = c_5 * t1 - s_5 * t8;
  J[40] = -R_52_y;
  const Scalar t9 = c_4 * t7 - s_4 * z_3_x;
  const Scalar z_6_x = c_5 * z_4_x - s_5 * t9;
  J[26] = z_6_x;
  const Scalar R_41_x = c_4 * R_31_x + s_4 * z_3_y;
  const Scalar t10 = c_5 * t6 - s_5 * R_41_x;
  J[33] = -t10;
  const Scalar R_52_x = c_5 * t8 + s_5 * t1;
  const Scalar t11 = c_6 * R_42_y - s_6 * R_52_x;
  J[41] = -t11;
  const Scalar t12 = c_5 * t9 + s_5 * z_4_x;
  const Scalar R_60_y = c_6 * R_40_y + s_6 * t12;
  J[27] = -R_60_y;
  const Scalar t13 = c_5 * R_41_x + s_5 * t6;
  const Scalar R_61_y = c_6 * R_41_y - s_6 * t13;
  J[34] = -R_61_y;
  const Scalar p_6u_t_x = Scalar(0.088) * c_6 + Scalar(0.2104) * s_6;
  const Scalar p_5_x = c_5 * p_6u_t_x - Scalar(0.0825);
  const Scalar t14 = Scalar(0.2104) * c_6 - Scalar(0.088) * s_6 - Scalar(0.384);
  const Scalar p_4_x = c_4 * p_5_x + Scalar(0.0825) + s_4 * t14;
  const Scalar t15 = s_5 * p_6u_t_x;
  const Scalar t16 = c_3 * p_4_x - s_3 * t15;
  const Scalar t17 = c_4 * t14 - s_4 * p_5_x - Scalar(0.316);
  const Scalar p_2u_t_x = c_2 * t16 - s_2 * t17;
  const Scalar p_3u_t_y = c_3 * t15 + s_3 * p_4_x;
  const Scalar p_1u_t_x = c_1 * p_2u_t_x - s_1 * p_3u_t_y;
  J[7] = p_1u_t_x;
  const Scalar t18 = s_2 * t16 + c_2 * t17;
  J[1] = -c_1 * t18;
  J[8] = -s_1 * t18;
  const Scalar p_1u_t_y = c_1 * p_3u_t_y + s_1 * p_2u_t_x;
  J[0] = -p_1u_t_y;
  J[15] = -c_1 * p_1u_t_x - s_1 * p_1u_t_y;
  const Scalar t19 = p_1u_t_x - Scalar(0.316) * z_3_x;
  const Scalar t20 = Scalar(0.316) * c_2 + t18;
  J[9] = c_2 * t19 + z_3_x * t20;
  const Scalar r_3_y = p_1u_t_y - Scalar(0.316) * z_3_y;
  J[2] = -c_2 * r_3_y - z_3_y * t20;
  J[16] = s_2 * (c_1 * r_3_y - s_1 * t19);
  const Scalar r_4_y = r_3_y - Scalar(0.0825) * R_31_x;
  const Scalar t21 = t20 - Scalar(0.0825) * t4;
  J[3] = t6 * t21 + t1 * r_4_y;
  const Scalar t22 = Scalar(0.0825) * t7 + t19;
  J[10] = z_4_x * t21 - t1 * t22;
  J[17] = z_4_x * r_4_y + t6 * t22;
  const Scalar t23 = Scalar(-0.0825) * t9 - Scalar(0.384) * R_40_y + t22;
  const Scalar t24 = Scalar(0.384) * R_42_y - Scalar(0.0825) * t8 + t21;
  J[11] = R_42_y * t23 + R_40_y * t24;
  const Scalar r_5_y = Scalar(0.0825) * R_41_x - Scalar(0.384) * R_41_y + r_4_y;
  J[18] = R_40_y * r_5_y - R_41_y * t23;
  J[5] = r_5_y * R_52_y + t24 * t10;
  J[19] = t23 * t10 + r_5_y * z_6_x;
  J[4] = -R_42_y * r_5_y - R_41_y * t24;
  J[12] = t24 * z_6_x - t23 * R_52_y;
  const Scalar r_7_y = r_5_y - Scalar(0.088) * (c_6 * t13 + s_6 * R_41_y);
  const Scalar R_62_x = c_6 * R_52_x + s_6 * R_42_y;
  const Scalar t25 = Scalar(0.088) * R_62_x + t24;
  J[6] = t11 * r_7_y + R_61_y * t25;
  const Scalar t26 = Scalar(0.088) * (c_6 * t12 - s_6 * R_40_y) + t23;
  J[13] = -t11 * t26 - R_60_y * t25;
  J[20] = R_61_y * t26 - R_60_y * r_7_y;
  J[35] = Scalar(1.0);
  J[14] = J[21] = J[28] = J[36] = Scalar(0.0);
}

// (dJ/dt) qd of the tip.
//   q[7]   in   joint positions, rad or m
//   qd[7]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads q[0..6], qd[0..6]. Operations: 164 mul, 102 add, 14 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = s_2 * qd_1;
  const Scalar t2 = c_3 * t1;
  const Scalar t3 = s_3 * qd_2;
  const Scalar t4 = t3 - t2;
  const Scalar t5 = c_2 * qd_1;
  const Scalar omega_3_z = qd_3 + t5;
  const Scalar t6 = c_4 * t4 + s_4 * omega_3_z;
  const Scalar t7 = s_3 * t1;
  const Scalar t8 = c_3 * qd_2;
  const Scalar omega_r_3_y = t7 + t8;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar t9 = s_5 * omega_4_z - c_5 * t6;
  const Scalar t10 = s_4 * t4 - c_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 - t10;
  const Scalar t11 = s_6 * omega_5_z - c_6 * t9;
  const Scalar omega_r_6_a_z = s_5 * t6 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t12 = s_7 * omega_6_z + c_7 * t11;
  const Scalar omega_r_6_y = s_6 * t9 + c_6 * omega_5_z;
  const Scalar t13 = qd_3 * omega_r_3_y - t8 * t5;
  const Scalar t14 = qd_2 * t1;
  const Scalar t15 = s_4 * t14 - c_4 * t13 + qd_4 * t10;
  const Scalar t16 = qd_3 * t4 - t3 * t5;
  const Scalar t17 = s_5 * t16 + qd_5 * omega_r_6_a_z + c_5 * t15;
  const Scalar t18 = s_4 * t13 + c_4 * t14 + qd_4 * t6;
  const Scalar t19 = qd_6 * omega_r_6_y - s_6 * t18 - c_6 * t17;
  const Scalar domega_5_y = qd_5 * t9 - c_5 * t16 + s_5 * t15;
  const Scalar t20 = qd_7 * t12 + s_7 * t19 + c_7 * domega_5_y;
  const Scalar t21 = s_7 * t11 - c_7 * omega_6_z;
  const Scalar t22 = qd_7 * t21 + s_7 * domega_5_y - c_7 * t19;
  const Scalar t23 = s_7 * t20 - c_7 * t22;
  const Scalar domega_r_7_a_z = qd_6 * t11 - s_6 * t17 + c_6 * t18;
  const Scalar t24 = s_6 * domega_r_7_a_z + c_6 * t23;
  const Scalar domega_e_6_a_y = s_7 * t22 + c_7 * t20;
  const Scalar t25 = s_5 * domega_e_6_a_y - c_5 * t24;
  const Scalar t26 = s_6 * t23 - c_6 * domega_r_7_a_z;
  const Scalar t27 = s_4 * t26 + c_4 * t25;
  const Scalar domega_e_5_t_y = s_5 * t24 + c_5 * domega_e_6_a_y;
  const Scalar t28 = s_3 * domega_e_5_t_y + c_3 * t27;
  const Scalar domega_e_3_a_y = s_4 * t25 - c_4 * t26;
  a[5] = s_2 * t28 - c_2 * domega_e_3_a_y;
  const Scalar t29 = s_2 * domega_e_3_a_y + c_2 * t28;
  const Scalar t30 = s_3 * t27 - c_3 * domega_e_5_t_y;
  a[3] = s_1 * t30 - c_1 * t29;
  const Scalar U_4_zx = t18 + t6 * omega_4_z;
  const Scalar t31 = (t4 * omega_r_3_y - t14) + U_4_zx;
  const Scalar t32 = t5 * (t7 + Scalar(2.0) * t8);
  const Scalar ddp_5_a_y = Scalar(0.0825) * t31 + Scalar(0.316) * t32 +
      Scalar(0.384) * (t15 + t10 * omega_4_z);
  const Scalar t33 = t1 * t1 + qd_2 * qd_2;
  const Scalar t34 = Scalar(0.316) * t33 - Scalar(0.0825) * (t16 + t4 * omega_3_z);
  const Scalar t35 = omega_4_z * omega_4_z;
  const Scalar t36 = t6 * t10;
  const Scalar t37 = omega_r_3_y * omega_r_3_y + omega_3_z * omega_3_z;
  const Scalar t38 = Scalar(0.0825) * t37 - Scalar(0.632) * t5 * (t3 - Scalar(0.5) * t2);
  const Scalar ddp_o_5_x = Scalar(0.0825) * (t35 + t10 * t10) - s_4 * t34 - c_4 * t38 -
      Scalar(0.384) * (t16 + t36);
  const Scalar ddp_5_x = s_5 * ddp_5_a_y + c_5 * ddp_o_5_x;
  const Scalar t39 = omega_r_6_y * omega_r_6_y + omega_6_z * omega_6_z;
  const Scalar t40 = Scalar(0.0825) * (t16 - t36) - s_4 * t38 + c_4 * t34 +
      Scalar(0.384) * (t35 + t6 * t6);
  const Scalar t41 = Scalar(0.088) * t39 + s_6 * t40 - c_6 * ddp_5_x;
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar U_7_yz = t22 - t21 * omega_7_z;
  const Scalar U_6_zx = domega_r_7_a_z + t11 * omega_6_z;
  const Scalar t42 = Scalar(0.088) * U_6_zx + s_5 * ddp_o_5_x - c_5 * ddp_5_a_y;
  const Scalar t43 = Scalar(0.2104) * U_7_yz + s_7 * t41 + c_7 * t42;
  const Scalar t44 = Scalar(0.2104) * (t20 - t12 * omega_7_z) - s_7 * t42 + c_7 * t41;
  const Scalar t45 = s_7 * t43 + c_7 * t44;
  const Scalar t46 = t21 * t21 + t12 * t12;
  const Scalar ddp_e_z = Scalar(0.088) * (domega_5_y - t11 * omega_r_6_y) - Scalar(0.2104) * t46 +
      s_6 * ddp_5_x + c_6 * t40;
  const Scalar t47 = s_6 * ddp_e_z - c_6 * t45;
  const Scalar t48 = s_7 * t44 - c_7 * t43;
  const Scalar t49 = s_5 * t48 - c_5 * t47;
  const Scalar t50 = s_6 * t45 + c_6 * ddp_e_z;
  const Scalar t51 = s_4 * t50 - c_4 * t49;
  const Scalar t52 = s_5 * t47 + c_5 * t48;
  const Scalar t53 = s_3 * t52 - c_3 * t51;
  const Scalar a_3_a_y = s_4 * t49 + c_4 * t50;
  a[2] = s_2 * t53 - c_2 * a_3_a_y;
  a[4] = -s_1 * t29 - c_1 * t30;
  const Scalar t54 = s_2 * a_3_a_y + c_2 * t53;
  const Scalar t55 = s_3 * t51 + c_3 * t52;
  a[0] = -s_1 * t55 - c_1 * t54;
  a[1] = c_1 * t55 - s_1 * t54;
}

}  // namespace panda

#endif  // FLATDYN_PANDA_HPP

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
// Every function is a template over its scalar: float, double, or any type that has + - * / and
// sin, cos where argument-dependent lookup finds them. Arguments are plain arrays:
//
//   double q[7] = {}, qd[7] = {}, qdd[7] = {}, tau[7];
//   panda::inverse_dynamics(q, qd, qdd, tau);
//
// Entries come in the order of the table. Units are SI; "rad or m" goes by the type of the joint.
// Every entry of an output is written, zeros too. All inputs are read before anything is written:
// an output may overlap an input, but outputs must not overlap each other. Nothing allocates,
// throws, or keeps state. In the code, names count from 1 as in the textbook: q_1 is q[0], s_1 its
// sine, c_1 its cosine, s_12 the sine of q_1 + q_2.

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

// tau = B(q) qdd + C(q, qd) qd + g(q) + friction (7.42).
//   q[7]    in   joint positions, rad or m
//   qd[7]   in   joint velocities, rad/s or m/s
//   qdd[7]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[7]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..6], qd[0..6], qdd[0..6]. Operations: 308 mul, 290 add, 12 sin/cos.
template <class Scalar>
inline void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    Scalar* tau) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5], qdd_7 = qdd[6];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = qd_2 * t1;
  const Scalar t3 = s_2 * qdd_1;
  const Scalar domega_2_x = t2 + t3;
  const Scalar U_2_zy = t2 + domega_2_x;
  const Scalar t4 = Scalar(0.316) * U_2_zy;
  const Scalar t5 = s_2 * qd_1;
  const Scalar t6 = t1 * t5;
  const Scalar U_2_xy = qdd_2 - t6;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 - Scalar(0.316) * U_2_xy;
  const Scalar t7 = s_3 * t4 - c_3 * ddp_o_3_x;
  const Scalar omega_r_3_y = s_3 * t5 + c_3 * qd_2;
  const Scalar t8 = omega_r_3_y * omega_r_3_y;
  const Scalar omega_3_z = qd_3 + t1;
  const Scalar t9 = omega_3_z * omega_3_z;
  const Scalar U_3_xx = t9 + t8;
  const Scalar t10 = t7 - Scalar(0.0825) * U_3_xx;
  const Scalar t11 = s_3 * qd_2 - c_3 * t5;
  const Scalar t12 = qd_3 * t11 - s_3 * domega_2_x - c_3 * qdd_2;
  const Scalar t13 = t11 * omega_3_z;
  const Scalar t14 = t12 + t13;
  const Scalar t15 = t5 * t5;
  const Scalar t16 = qd_2 * qd_2;
  const Scalar U_2_yy = t16 + t15;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.316) * U_2_yy;
  const Scalar ddp_o_4_z = ddp_o_3_y + Scalar(0.0825) * t14;
  const Scalar t17 = s_4 * ddp_o_4_z + c_4 * t10;
  const Scalar t18 = s_4 * t11 - c_4 * omega_3_z;
  const Scalar t19 = t18 * t18;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar t20 = omega_4_z * omega_4_z;
  const Scalar U_4_xx = t20 + t19;
  const Scalar domega_4_z = qdd_4 + t12;
  const Scalar t21 = s_4 * omega_3_z + c_4 * t11;
  const Scalar t22 = t21 * t18;
  const Scalar U_4_xy = domega_4_z + t22;
  const Scalar t23 = t17 + Scalar(0.0825) * U_4_xx - Scalar(0.384) * U_4_xy;
  const Scalar ddp_3_y = s_3 * ddp_o_3_x + c_3 * t4;
  const Scalar t24 = qd_2 * t5;
  const Scalar t25 = c_2 * qdd_1;
  const Scalar t26 = t24 - t25;
  const Scalar domega_3_z = qdd_3 - t26;
  const Scalar t27 = t11 * omega_r_3_y;
  const Scalar U_3_yx = domega_3_z + t27;
  const Scalar ddp_o_4_y = ddp_3_y + Scalar(0.0825) * U_3_yx;
  const Scalar t28 = qd_3 * omega_r_3_y + s_3 * qdd_2 - c_3 * domega_2_x;
  const Scalar t29 = qd_4 * t21 + s_4 * t28 - c_4 * domega_3_z;
  const Scalar t30 = t21 * omega_4_z;
  const Scalar t31 = t29 + t30;
  const Scalar domega_4_x = qd_4 * t18 - s_4 * domega_3_z - c_4 * t28;
  const Scalar t32 = t18 * omega_4_z;
  const Scalar U_4_zy = domega_4_x + t32;
  const Scalar ddp_o_5_z = ddp_o_4_y + Scalar(0.0825) * t31 + Scalar(0.384) * U_4_zy;
  const Scalar t33 = s_5 * ddp_o_5_z + c_5 * t23;
  const Scalar t34 = s_4 * t10 - c_4 * ddp_o_4_z;
  const Scalar U_4_yx = domega_4_z - t22;
  const Scalar t35 = t21 * t21;
  const Scalar U_4_yy = t20 + t35;
  const Scalar t36 = t34 + Scalar(0.0825) * U_4_yx + Scalar(0.384) * U_4_yy;
  const Scalar ddp_6_x = s_6 * t36 - c_6 * t33;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t21;
  const Scalar omega_5_z = qd_5 - t18;
  const Scalar omega_r_6_y = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t37 = omega_r_6_y * omega_r_6_y;
  const Scalar omega_r_5_y = s_5 * t21 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t38 = omega_6_z * omega_6_z;
  const Scalar U_6_xx = t38 + t37;
  const Scalar ddp_o_7_x = ddp_6_x + Scalar(0.088) * U_6_xx;
  const Scalar t39 = s_5 * t23 - c_5 * ddp_o_5_z;
  const Scalar t40 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar domega_5_x = qd_5 * omega_r_5_y + s_5 * domega_4_z + c_5 * domega_4_x;
  const Scalar domega_5_z = qdd_5 - t29;
  const Scalar t41 = qd_6 * t40 - s_6 * domega_5_x - c_6 * domega_5_z;
  const Scalar t42 = t40 * omega_6_z;
  const Scalar t43 = t41 + t42;
  const Scalar t44 = t39 + Scalar(0.088) * t43;
  const Scalar t45 = s_7 * t44 - c_7 * ddp_o_7_x;
  const Scalar t46 = s_7 * ddp_o_7_x + c_7 * t44;
  const Scalar t47 = s_7 * omega_6_z + c_7 * t40;
  const Scalar t48 = qd_6 * omega_r_6_y + s_6 * domega_5_z - c_6 * domega_5_x;
  const Scalar t49 = qd_5 * omega_r_5_x + s_5 * domega_4_x - c_5 * domega_4_z;
  const Scalar domega_6_z = qdd_6 - t49;
  const Scalar t50 = qd_7 * t47 + s_7 * t48 - c_7 * domega_6_z;
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar t51 = t47 * omega_7_z;
  const Scalar t52 = s_7 * t40 - c_7 * omega_6_z;
  const Scalar domega_7_x = qd_7 * t52 - s_7 * domega_6_z - c_7 * t48;
  const Scalar t53 = t52 * omega_7_z;
  const Scalar U_7_yz = domega_7_x - t53;
  const Scalar t54 = t52 * t52;
  const Scalar t55 = omega_7_z * omega_7_z;
  const Scalar U_7_xx = t55 + t54;
  const Scalar t56 = t47 * t47;
  const Scalar U_7_yy = t55 + t56;
  const Scalar U_7_xx_yy = U_7_xx - U_7_yy;
  const Scalar domega_7_z = qdd_7 + t41;
  const Scalar t57 = t47 * t52;
  const Scalar U_7_xy = domega_7_z + t57;
  const Scalar U_7_yx = domega_7_z - t57;
  const Scalar t58 = Scalar(0.002034439958661797) * t45 - Scalar(0.002573605371338203) * t46 -
      Scalar(0.004552547872941088) * U_7_xy - Scalar(0.0012555365982728983) * (t50 - t51) -
      Scalar(0.002131604094419858) * U_7_yx - Scalar(0.0009653051699191118) * U_7_yz +
      Scalar(0.000391391281684248) * U_7_xx_yy;
  tau[6] = -t58;
  const Scalar t59 = s_6 * t33 + c_6 * t36;
  const Scalar t60 = t40 * omega_r_6_y;
  const Scalar U_6_yx = domega_6_z + t60;
  const Scalar t61 = t59 - Scalar(0.088) * U_6_yx;
  const Scalar t62 = t50 + t51;
  const Scalar U_7_zy = domega_7_x + t53;
  const Scalar U_7_zz = t54 + t56;
  const Scalar U_7_yy_zz = U_7_yy - U_7_zz;
  const Scalar t63 = Scalar(0.002034439958661797) * t61 - Scalar(0.0009653051699191118) * U_7_yx -
      Scalar(0.000391391281684248) * t62 - Scalar(0.004552547872941088) * U_7_zy +
      Scalar(0.0012555365982728983) * U_7_yy_zz;
  const Scalar U_7_zz_xx = U_7_xx - U_7_zz;
  const Scalar t64 = Scalar(0.002573605371338203) * t61 + Scalar(0.0012555365982728983) * U_7_xy +
      Scalar(0.002131604094419858) * t62 + Scalar(0.000391391281684248) * U_7_zy +
      Scalar(0.0009653051699191118) * U_7_zz_xx;
  const Scalar t65 = Scalar(0.002573605371338203) * t62 - Scalar(0.002034439958661797) * U_7_zy;
  const Scalar t66 = omega_r_6_y * omega_6_z;
  const Scalar t67 = t40 * t40;
  const Scalar U_6_yy = t38 + t67;
  const Scalar U_6_xx_yy = U_6_xx - U_6_yy;
  const Scalar U_6_xy = domega_6_z - t60;
  const Scalar mu_6_z = Scalar(0.173804705569) * ddp_6_x + Scalar(0.231847552695) * t59 -
      Scalar(0.028934422545659894) * U_6_xy + Scalar(0.000093569097314605) * (t41 - t42) -
      Scalar(0.021522255370587554) * U_6_yx + Scalar(0.000103758917218685) * (t48 - t66) +
      Scalar(0.014748570382675316) * U_6_xx_yy + Scalar(0.088) * t65 - s_7 * t63 + c_7 * t64;
  tau[5] = -mu_6_z;
  const Scalar F_7_x = Scalar(0.002573605371338203) * U_7_xx +
      Scalar(0.002034439958661797) * U_7_xy;
  const Scalar F_7_y = Scalar(0.002573605371338203) * U_7_yx -
      Scalar(0.002034439958661797) * U_7_yy;
  const Scalar t68 = s_7 * F_7_x - c_7 * F_7_y;
  const Scalar t69 = t48 + t66;
  const Scalar U_6_zz = t37 + t67;
  const Scalar U_6_zz_xx = U_6_xx - U_6_zz;
  const Scalar t70 = Scalar(0.231847552695) * t39 - Scalar(0.000093569097314605) * U_6_xy +
      Scalar(0.021522255370587554) * t43 - Scalar(0.014748570382675316) * t69 +
      Scalar(0.000103758917218685) * U_6_zz_xx - t58 - Scalar(0.088) * t68;
  const Scalar U_6_yy_zz = U_6_yy - U_6_zz;
  const Scalar t71 = Scalar(0.173804705569) * t39 + Scalar(0.000103758917218685) * U_6_yx +
      Scalar(0.014748570382675316) * t43 - Scalar(0.028934422545659894) * t69 +
      Scalar(0.000093569097314605) * U_6_yy_zz - s_7 * t64 - c_7 * t63;
  const Scalar t72 = omega_r_5_x * omega_5_z;
  const Scalar t73 = omega_r_5_y * omega_5_z;
  const Scalar U_5_yz = domega_5_x - t73;
  const Scalar t74 = omega_r_5_y * omega_r_5_y;
  const Scalar t75 = omega_5_z * omega_5_z;
  const Scalar U_5_xx = t75 + t74;
  const Scalar t76 = omega_r_5_x * omega_r_5_x;
  const Scalar U_5_yy = t75 + t76;
  const Scalar U_5_xx_yy = U_5_xx - U_5_yy;
  const Scalar t77 = omega_r_5_x * omega_r_5_y;
  const Scalar U_5_xy = domega_5_z - t77;
  const Scalar U_5_yx = domega_5_z + t77;
  const Scalar t78 = Scalar(0.067870631425) * t33 - Scalar(0.014653732538) * t39 -
      Scalar(0.010045187828321245) * U_5_xy - Scalar(0.00216405205209813) * (t49 - t72) -
      Scalar(0.001451156065026714) * U_5_yx - Scalar(0.004600245517563106) * U_5_yz -
      Scalar(0.00151524447332703) * U_5_xx_yy + s_6 * t71 + c_6 * t70;
  tau[4] = -t78;
  const Scalar t79 = t49 + t72;
  const Scalar U_5_zy = domega_5_x + t73;
  const Scalar U_5_zz = t74 + t76;
  const Scalar U_5_yy_zz = U_5_yy - U_5_zz;
  const Scalar t80 = Scalar(0.067870631425) * t36 + Scalar(0.004600245517563106) * U_5_yx +
      Scalar(0.00151524447332703) * t79 + Scalar(0.010045187828321245) * U_5_zy +
      Scalar(0.00216405205209813) * U_5_yy_zz - s_6 * t70 + c_6 * t71;
  const Scalar U_5_zz_xx = U_5_xx - U_5_zz;
  const Scalar t81 = Scalar(0.014653732538) * t36 - Scalar(0.00216405205209813) * U_5_xy -
      Scalar(0.001451156065026714) * t79 - Scalar(0.00151524447332703) * U_5_zy +
      Scalar(0.004600245517563106) * U_5_zz_xx - mu_6_z;
  const Scalar f_6_y = Scalar(0.231847552695) * U_6_yx + Scalar(0.173804705569) * U_6_yy - t65;
  const Scalar f_6_x = Scalar(0.231847552695) * U_6_xx - Scalar(0.173804705569) * U_6_xy +
      s_7 * F_7_y + c_7 * F_7_x;
  const Scalar f_5_x = Scalar(0.014653732538) * U_5_xx - Scalar(0.067870631425) * U_5_xy -
      s_6 * f_6_y - c_6 * f_6_x;
  const Scalar f_5_y = Scalar(0.014653732538) * U_5_yx + Scalar(0.067870631425) * U_5_yy +
      Scalar(0.231847552695) * t43 - Scalar(0.173804705569) * t69 - t68;
  const Scalar f_u_5_t_x = s_5 * f_5_y + c_5 * f_5_x;
  const Scalar t82 = Scalar(0.014653732538) * t79 - Scalar(0.067870631425) * U_5_zy - s_6 * f_6_x +
      c_6 * f_6_y;
  const Scalar U_4_yz = domega_4_x - t32;
  const Scalar U_4_xx_yy = U_4_xx - U_4_yy;
  const Scalar t83 = Scalar(2.012523553603) * t17 - Scalar(0.55278027465) * t34 -
      Scalar(0.6972920750309718) * U_4_xy - Scalar(0.00164448757736927) * (t29 - t30) -
      Scalar(0.0510201361568155) * U_4_yx + Scalar(0.0039053550262761) * U_4_yz +
      Scalar(0.16284087268546085) * U_4_xx_yy + Scalar(0.0825) * t82 + Scalar(0.384) * f_u_5_t_x -
      s_5 * t80 - c_5 * t81;
  tau[3] = -t83;
  const Scalar t84 = s_5 * f_5_x - c_5 * f_5_y;
  const Scalar U_4_zz = t19 + t35;
  const Scalar U_4_yy_zz = U_4_yy - U_4_zz;
  const Scalar mu_4_x = Scalar(2.012523553603) * ddp_o_4_y - Scalar(0.0039053550262761) * U_4_yx +
      Scalar(0.16284087268546085) * t31 + Scalar(0.6972920750309718) * U_4_zy -
      Scalar(0.00164448757736927) * U_4_yy_zz + Scalar(0.384) * t84 - s_5 * t81 + c_5 * t80;
  const Scalar U_4_zz_xx = U_4_xx - U_4_zz;
  const Scalar mu_4_y = Scalar(0.55278027465) * ddp_o_4_y + Scalar(0.00164448757736927) * U_4_xy +
      Scalar(0.0510201361568155) * t31 + Scalar(0.16284087268546085) * U_4_zy -
      Scalar(0.0039053550262761) * U_4_zz_xx + t78 + Scalar(0.0825) * t84;
  const Scalar t85 = Scalar(0.55278027465) * t31 + Scalar(2.012523553603) * U_4_zy + t84;
  const Scalar t86 = omega_r_3_y * omega_3_z;
  const Scalar t87 = t11 * t11;
  const Scalar U_3_yy = t9 + t87;
  const Scalar U_3_xx_yy = U_3_xx - U_3_yy;
  const Scalar U_3_xy = domega_3_z - t27;
  const Scalar t88 = Scalar(0.028227094878) * t7 - Scalar(0.746857959872) * ddp_3_y -
      Scalar(0.022178148964878235) * U_3_xy - Scalar(0.004377257121839584) * (t12 - t13) -
      Scalar(0.061602421026527694) * U_3_yx + Scalar(0.005487648106562256) * (t28 - t86) -
      Scalar(0.000121912420950744) * U_3_xx_yy - Scalar(0.0825) * t85 + s_4 * mu_4_x + c_4 * mu_4_y;
  tau[2] = -t88;
  const Scalar t89 = t28 + t86;
  const Scalar U_3_zz = t8 + t87;
  const Scalar U_3_yy_zz = U_3_yy - U_3_zz;
  const Scalar mu_3_x = Scalar(0.028227094878) * ddp_o_3_y - Scalar(0.005487648106562256) * U_3_yx +
      Scalar(0.000121912420950744) * t14 + Scalar(0.022178148964878235) * t89 +
      Scalar(0.004377257121839584) * U_3_yy_zz + s_4 * mu_4_y - c_4 * mu_4_x;
  const Scalar f_4_x = Scalar(0.55278027465) * U_4_xx - Scalar(2.012523553603) * U_4_xy + f_u_5_t_x;
  const Scalar f_4_y = Scalar(0.55278027465) * U_4_yx + Scalar(2.012523553603) * U_4_yy - t82;
  const Scalar t90 = s_4 * f_4_x - c_4 * f_4_y;
  const Scalar U_3_zz_xx = U_3_xx - U_3_zz;
  const Scalar mu_3_y = Scalar(0.746857959872) * ddp_o_3_y + Scalar(0.004377257121839584) * U_3_xy +
      Scalar(0.061602421026527694) * t14 + Scalar(0.000121912420950744) * t89 +
      Scalar(0.005487648106562256) * U_3_zz_xx - t83 + Scalar(0.0825) * t90;
  const Scalar f_3_x = Scalar(0.746857959872) * U_3_xx + Scalar(0.028227094878) * U_3_xy -
      s_4 * f_4_y - c_4 * f_4_x;
  const Scalar f_3_y = Scalar(0.746857959872) * U_3_yx - Scalar(0.028227094878) * U_3_yy + t85;
  const Scalar f_u_3_t_x = s_3 * f_3_y + c_3 * f_3_x;
  const Scalar t91 = t1 * t1;
  const Scalar U_2_xx = t16 + t91;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  const Scalar U_2_yx = qdd_2 + t6;
  tau[1] = Scalar(0.01993386669246) * c_2 - Scalar(32.80954542685272) * s_2 -
      Scalar(0.01026110182100817) * t3 - Scalar(0.0007689361029464) * t25 +
      Scalar(1.032162061231881) * U_2_xy + Scalar(0.023077882494931805) * U_2_yx +
      Scalar(0.00398335888393552) * U_2_xx_yy - Scalar(0.316) * f_u_3_t_x + s_3 * mu_3_x -
      c_3 * mu_3_y;
  const Scalar t92 = s_3 * f_3_x - c_3 * f_3_y;
  const Scalar U_2_zx = t24 + t26;
  const Scalar U_2_zz = t91 + t15;
  const Scalar U_2_yy_zz = U_2_yy - U_2_zz;
  const Scalar mu_2_x = Scalar(0.01026110182100817) * U_2_yx -
      Scalar(0.00398335888393552) * U_2_zx - Scalar(1.032162061231881) * U_2_zy -
      Scalar(0.0007689361029464) * U_2_yy_zz + Scalar(0.316) * t92 + s_3 * mu_3_y + c_3 * mu_3_x;
  const Scalar U_2_zz_xx = U_2_xx - U_2_zz;
  const Scalar mu_2_y = Scalar(0.0007689361029464) * U_2_xy +
      Scalar(0.023077882494931805) * U_2_zx + Scalar(0.00398335888393552) * U_2_zy +
      Scalar(0.01026110182100817) * U_2_zz_xx + t88;
  tau[0] = Scalar(0.014259565994474374) * qdd_1 - s_2 * mu_2_x - c_2 * mu_2_y;
}

// inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[7]    in   joint positions, rad or m
//   qd[7]   in   joint velocities, rad/s or m/s
//   qdd[7]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[7]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..6], qd[0..6], qdd[0..6], h_e[0..5]. Operations: 366 mul, 326 add, 14 sin/cos.
template <class Scalar>
inline void inverse_dynamics_tip_force(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    const Scalar* h_e, Scalar* tau) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5], qdd_7 = qdd[6];
  const Scalar h_e_1 = h_e[0], h_e_2 = h_e[1], h_e_3 = h_e[2], h_e_4 = h_e[3], h_e_5 = h_e[4],
      h_e_6 = h_e[5];
  const Scalar s_1 = sin(q_1), c_1 = cos(q_1);
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = qd_2 * t1;
  const Scalar t3 = s_2 * qdd_1;
  const Scalar domega_2_x = t2 + t3;
  const Scalar U_2_zy = t2 + domega_2_x;
  const Scalar t4 = Scalar(0.316) * U_2_zy;
  const Scalar t5 = s_2 * qd_1;
  const Scalar t6 = t1 * t5;
  const Scalar U_2_xy = qdd_2 - t6;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 - Scalar(0.316) * U_2_xy;
  const Scalar t7 = s_3 * t4 - c_3 * ddp_o_3_x;
  const Scalar omega_r_3_y = s_3 * t5 + c_3 * qd_2;
  const Scalar t8 = omega_r_3_y * omega_r_3_y;
  const Scalar omega_3_z = qd_3 + t1;
  const Scalar t9 = omega_3_z * omega_3_z;
  const Scalar U_3_xx = t9 + t8;
  const Scalar t10 = t7 - Scalar(0.0825) * U_3_xx;
  const Scalar t11 = s_3 * qd_2 - c_3 * t5;
  const Scalar t12 = qd_3 * t11 - s_3 * domega_2_x - c_3 * qdd_2;
  const Scalar t13 = t11 * omega_3_z;
  const Scalar t14 = t12 + t13;
  const Scalar t15 = t5 * t5;
  const Scalar t16 = qd_2 * qd_2;
  const Scalar U_2_yy = t16 + t15;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.316) * U_2_yy;
  const Scalar ddp_o_4_z = ddp_o_3_y + Scalar(0.0825) * t14;
  const Scalar t17 = s_4 * ddp_o_4_z + c_4 * t10;
  const Scalar t18 = s_4 * t11 - c_4 * omega_3_z;
  const Scalar t19 = t18 * t18;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar t20 = omega_4_z * omega_4_z;
  const Scalar U_4_xx = t20 + t19;
  const Scalar domega_4_z = qdd_4 + t12;
  const Scalar t21 = s_4 * omega_3_z + c_4 * t11;
  const Scalar t22 = t21 * t18;
  const Scalar U_4_xy = domega_4_z + t22;
  const Scalar t23 = t17 + Scalar(0.0825) * U_4_xx - Scalar(0.384) * U_4_xy;
  const Scalar ddp_3_y = s_3 * ddp_o_3_x + c_3 * t4;
  const Scalar t24 = qd_2 * t5;
  const Scalar t25 = c_2 * qdd_1;
  const Scalar t26 = t24 - t25;
  const Scalar domega_3_z = qdd_3 - t26;
  const Scalar t27 = t11 * omega_r_3_y;
  const Scalar U_3_yx = domega_3_z + t27;
  const Scalar ddp_o_4_y = ddp_3_y + Scalar(0.0825) * U_3_yx;
  const Scalar t28 = qd_3 * omega_r_3_y + s_3 * qdd_2 - c_3 * domega_2_x;
  const Scalar t29 = qd_4 * t21 + s_4 * t28 - c_4 * domega_3_z;
  const Scalar t30 = t21 * omega_4_z;
  const Scalar t31 = t29 + t30;
  const Scalar domega_4_x = qd_4 * t18 - s_4 * domega_3_z - c_4 * t28;
  const Scalar t32 = t18 * omega_4_z;
  const Scalar U_4_zy = domega_4_x + t32;
  const Scalar ddp_o_5_z = ddp_o_4_y + Scalar(0.0825) * t31 + Scalar(0.384) * U_4_zy;
  const Scalar t33 = s_5 * ddp_o_5_z + c_5 * t23;
  const Scalar t34 = s_4 * t10 - c_4 * ddp_o_4_z;
  const Scalar U_4_yx = domega_4_z - t22;
  const Scalar t35 = t21 * t21;
  const Scalar U_4_yy = t20 + t35;
  const Scalar t36 = t34 + Scalar(0.0825) * U_4_yx + Scalar(0.384) * U_4_yy;
  const Scalar ddp_6_x = s_6 * t36 - c_6 * t33;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t21;
  const Scalar omega_5_z = qd_5 - t18;
  const Scalar omega_r_6_y = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t37 = omega_r_6_y * omega_r_6_y;
  const Scalar omega_r_5_y = s_5 * t21 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t38 = omega_6_z * omega_6_z;
  const Scalar U_6_xx = t38 + t37;
  const Scalar ddp_o_7_x = ddp_6_x + Scalar(0.088) * U_6_xx;
  const Scalar t39 = s_5 * t23 - c_5 * ddp_o_5_z;
  const Scalar t40 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar domega_5_x = qd_5 * omega_r_5_y + s_5 * domega_4_z + c_5 * domega_4_x;
  const Scalar domega_5_z = qdd_5 - t29;
  const Scalar t41 = qd_6 * t40 - s_6 * domega_5_x - c_6 * domega_5_z;
  const Scalar t42 = t40 * omega_6_z;
  const Scalar t43 = t41 + t42;
  const Scalar t44 = t39 + Scalar(0.088) * t43;
  const Scalar t45 = s_7 * t44 - c_7 * ddp_o_7_x;
  const Scalar t46 = s_7 * ddp_o_7_x + c_7 * t44;
  const Scalar t47 = s_7 * omega_6_z + c_7 * t40;
  const Scalar t48 = qd_6 * omega_r_6_y + s_6 * domega_5_z - c_6 * domega_5_x;
  const Scalar t49 = qd_5 * omega_r_5_x + s_5 * domega_4_x - c_5 * domega_4_z;
  const Scalar domega_6_z = qdd_6 - t49;
  const Scalar t50 = qd_7 * t47 + s_7 * t48 - c_7 * domega_6_z;
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar t51 = t47 * omega_7_z;
  const Scalar t52 = s_7 * t40 - c_7 * omega_6_z;
  const Scalar domega_7_x = qd_7 * t52 - s_7 * domega_6_z - c_7 * t48;
  const Scalar t53 = t52 * omega_7_z;
  const Scalar U_7_yz = domega_7_x - t53;
  const Scalar t54 = t52 * t52;
  const Scalar t55 = omega_7_z * omega_7_z;
  const Scalar U_7_xx = t55 + t54;
  const Scalar t56 = t47 * t47;
  const Scalar U_7_yy = t55 + t56;
  const Scalar U_7_xx_yy = U_7_xx - U_7_yy;
  const Scalar domega_7_z = qdd_7 + t41;
  const Scalar t57 = t47 * t52;
  const Scalar U_7_xy = domega_7_z + t57;
  const Scalar U_7_yx = domega_7_z - t57;
  const Scalar mu_e1_x = s_1 * h_e_5 + c_1 * h_e_4;
  const Scalar t58 = s_2 * h_e_6 - c_2 * mu_e1_x;
  const Scalar t59 = s_1 * h_e_4 - c_1 * h_e_5;
  const Scalar t60 = s_3 * t59 + c_3 * t58;
  const Scalar mu_e2_y = s_2 * mu_e1_x + c_2 * h_e_6;
  const Scalar mu_e4_x = s_4 * mu_e2_y - c_4 * t60;
  const Scalar mu_e3_y = s_3 * t58 - c_3 * t59;
  const Scalar mu_e5_x = s_5 * mu_e3_y + c_5 * mu_e4_x;
  const Scalar mu_e4_y = s_4 * t60 + c_4 * mu_e2_y;
  const Scalar mu_7_z = Scalar(0.002034439958661797) * t45 - Scalar(0.002573605371338203) * t46 -
      Scalar(0.004552547872941088) * U_7_xy - Scalar(0.0012555365982728983) * (t50 - t51) -
      Scalar(0.002131604094419858) * U_7_yx - Scalar(0.0009653051699191118) * U_7_yz +
      Scalar(0.000391391281684248) * U_7_xx_yy - s_6 * mu_e5_x + c_6 * mu_e4_y;
  tau[6] = -mu_7_z;
  const Scalar t61 = s_6 * t33 + c_6 * t36;
  const Scalar t62 = t40 * omega_r_6_y;
  const Scalar U_6_yx = domega_6_z + t62;
  const Scalar t63 = t61 - Scalar(0.088) * U_6_yx;
  const Scalar f_e1_x = s_1 * h_e_2 + c_1 * h_e_1;
  const Scalar t64 = s_2 * h_e_3 - c_2 * f_e1_x;
  const Scalar t65 = s_1 * h_e_1 - c_1 * h_e_2;
  const Scalar t66 = s_3 * t65 + c_3 * t64;
  const Scalar f_e2_y = s_2 * f_e1_x + c_2 * h_e_3;
  const Scalar f_e4_x = s_4 * f_e2_y - c_4 * t66;
  const Scalar f_e3_y = s_3 * t64 - c_3 * t65;
  const Scalar f_e5_x = s_5 * f_e3_y + c_5 * f_e4_x;
  const Scalar f_e4_y = s_4 * t66 + c_4 * f_e2_y;
  const Scalar f_e6_x = s_6 * f_e4_y + c_6 * f_e5_x;
  const Scalar t67 = s_5 * f_e4_x - c_5 * f_e3_y;
  const Scalar f_e7_y = s_7 * f_e6_x - c_7 * t67;
  const Scalar t68 = t50 + t51;
  const Scalar U_7_zy = domega_7_x + t53;
  const Scalar U_7_zz = t54 + t56;
  const Scalar U_7_yy_zz = U_7_yy - U_7_zz;
  const Scalar mu_e6_x = s_6 * mu_e4_y + c_6 * mu_e5_x;
  const Scalar t69 = s_5 * mu_e4_x - c_5 * mu_e3_y;
  const Scalar mu_7_x = Scalar(0.2104) * f_e7_y + Scalar(0.002034439958661797) * t63 -
      Scalar(0.0009653051699191118) * U_7_yx - Scalar(0.000391391281684248) * t68 -
      Scalar(0.004552547872941088) * U_7_zy + Scalar(0.0012555365982728983) * U_7_yy_zz +
      s_7 * t69 + c_7 * mu_e6_x;
  const Scalar f_e7_x = s_7 * t67 + c_7 * f_e6_x;
  const Scalar U_7_zz_xx = U_7_xx - U_7_zz;
  const Scalar mu_7_y = Scalar(0.2104) * f_e7_x - Scalar(0.002573605371338203) * t63 -
      Scalar(0.0012555365982728983) * U_7_xy - Scalar(0.002131604094419858) * t68 -
      Scalar(0.000391391281684248) * U_7_zy - Scalar(0.0009653051699191118) * U_7_zz_xx -
      s_7 * mu_e6_x + c_7 * t69;
  const Scalar t70 = Scalar(0.002573605371338203) * t68 - Scalar(0.002034439958661797) * U_7_zy +
      s_6 * f_e5_x - c_6 * f_e4_y;
  const Scalar t71 = omega_r_6_y * omega_6_z;
  const Scalar t72 = t40 * t40;
  const Scalar U_6_yy = t38 + t72;
  const Scalar U_6_xx_yy = U_6_xx - U_6_yy;
  const Scalar U_6_xy = domega_6_z - t62;
  const Scalar mu_6_z = Scalar(0.173804705569) * ddp_6_x + Scalar(0.231847552695) * t61 -
      Scalar(0.028934422545659894) * U_6_xy + Scalar(0.000093569097314605) * (t41 - t42) -
      Scalar(0.021522255370587554) * U_6_yx + Scalar(0.000103758917218685) * (t48 - t71) +
      Scalar(0.014748570382675316) * U_6_xx_yy + Scalar(0.088) * t70 - s_7 * mu_7_x - c_7 * mu_7_y;
  tau[5] = -mu_6_z;
  const Scalar f_7_x = f_e7_x - Scalar(0.002573605371338203) * U_7_xx -
      Scalar(0.002034439958661797) * U_7_xy;
  const Scalar f_7_y = f_e7_y - Scalar(0.002573605371338203) * U_7_yx +
      Scalar(0.002034439958661797) * U_7_yy;
  const Scalar t73 = s_7 * f_7_x - c_7 * f_7_y;
  const Scalar t74 = t48 + t71;
  const Scalar U_6_zz = t37 + t72;
  const Scalar U_6_zz_xx = U_6_xx - U_6_zz;
  const Scalar t75 = Scalar(0.231847552695) * t39 - Scalar(0.000093569097314605) * U_6_xy +
      Scalar(0.021522255370587554) * t43 - Scalar(0.014748570382675316) * t74 +
      Scalar(0.000103758917218685) * U_6_zz_xx - mu_7_z + Scalar(0.088) * t73;
  const Scalar U_6_yy_zz = U_6_yy - U_6_zz;
  const Scalar t76 = Scalar(0.173804705569) * t39 + Scalar(0.000103758917218685) * U_6_yx +
      Scalar(0.014748570382675316) * t43 - Scalar(0.028934422545659894) * t74 +
      Scalar(0.000093569097314605) * U_6_yy_zz + s_7 * mu_7_y - c_7 * mu_7_x;
  const Scalar t77 = omega_r_5_x * omega_5_z;
  const Scalar t78 = omega_r_5_y * omega_5_z;
  const Scalar U_5_yz = domega_5_x - t78;
  const Scalar t79 = omega_r_5_y * omega_r_5_y;
  const Scalar t80 = omega_5_z * omega_5_z;
  const Scalar U_5_xx = t80 + t79;
  const Scalar t81 = omega_r_5_x * omega_r_5_x;
  const Scalar U_5_yy = t80 + t81;
  const Scalar U_5_xx_yy = U_5_xx - U_5_yy;
  const Scalar t82 = omega_r_5_x * omega_r_5_y;
  const Scalar U_5_xy = domega_5_z - t82;
  const Scalar U_5_yx = domega_5_z + t82;
  const Scalar t83 = Scalar(0.067870631425) * t33 - Scalar(0.014653732538) * t39 -
      Scalar(0.010045187828321245) * U_5_xy - Scalar(0.00216405205209813) * (t49 - t77) -
      Scalar(0.001451156065026714) * U_5_yx - Scalar(0.004600245517563106) * U_5_yz -
      Scalar(0.00151524447332703) * U_5_xx_yy + s_6 * t76 + c_6 * t75;
  tau[4] = -t83;
  const Scalar t84 = t49 + t77;
  const Scalar U_5_zy = domega_5_x + t78;
  const Scalar U_5_zz = t79 + t81;
  const Scalar U_5_yy_zz = U_5_yy - U_5_zz;
  const Scalar t85 = Scalar(0.067870631425) * t36 + Scalar(0.004600245517563106) * U_5_yx +
      Scalar(0.00151524447332703) * t84 + Scalar(0.010045187828321245) * U_5_zy +
      Scalar(0.00216405205209813) * U_5_yy_zz - s_6 * t75 + c_6 * t76;
  const Scalar f_6_x = Scalar(0.231847552695) * U_6_xx - Scalar(0.173804705569) * U_6_xy -
      s_7 * f_7_y - c_7 * f_7_x;
  const Scalar f_6_y = Scalar(0.231847552695) * U_6_yx + Scalar(0.173804705569) * U_6_yy - t70;
  const Scalar f_5_x = Scalar(0.014653732538) * U_5_xx - Scalar(0.067870631425) * U_5_xy -
      s_6 * f_6_y - c_6 * f_6_x;
  const Scalar f_5_y = Scalar(0.014653732538) * U_5_yx + Scalar(0.067870631425) * U_5_yy +
      Scalar(0.231847552695) * t43 - Scalar(0.173804705569) * t74 + t73;
  const Scalar f_u_5_t_x = s_5 * f_5_y + c_5 * f_5_x;
  const Scalar U_5_zz_xx = U_5_xx - U_5_zz;
  const Scalar t86 = Scalar(0.014653732538) * t36 - Scalar(0.00216405205209813) * U_5_xy -
      Scalar(0.001451156065026714) * t84 - Scalar(0.00151524447332703) * U_5_zy +
      Scalar(0.004600245517563106) * U_5_zz_xx - mu_6_z;
  const Scalar t87 = Scalar(0.014653732538) * t84 - Scalar(0.067870631425) * U_5_zy - s_6 * f_6_x +
      c_6 * f_6_y;
  const Scalar U_4_yz = domega_4_x - t32;
  const Scalar U_4_xx_yy = U_4_xx - U_4_yy;
  const Scalar t88 = Scalar(2.012523553603) * t17 - Scalar(0.55278027465) * t34 -
      Scalar(0.6972920750309718) * U_4_xy - Scalar(0.00164448757736927) * (t29 - t30) -
      Scalar(0.0510201361568155) * U_4_yx + Scalar(0.0039053550262761) * U_4_yz +
      Scalar(0.16284087268546085) * U_4_xx_yy + Scalar(0.0825) * t87 + Scalar(0.384) * f_u_5_t_x -
      s_5 * t85 - c_5 * t86;
  tau[3] = -t88;
  const Scalar t89 = s_5 * f_5_x - c_5 * f_5_y;
  const Scalar U_4_zz = t19 + t35;
  const Scalar U_4_yy_zz = U_4_yy - U_4_zz;
  const Scalar mu_4_x = Scalar(2.012523553603) * ddp_o_4_y - Scalar(0.0039053550262761) * U_4_yx +
      Scalar(0.16284087268546085) * t31 + Scalar(0.6972920750309718) * U_4_zy -
      Scalar(0.00164448757736927) * U_4_yy_zz + Scalar(0.384) * t89 - s_5 * t86 + c_5 * t85;
  const Scalar U_4_zz_xx = U_4_xx - U_4_zz;
  const Scalar mu_4_y = Scalar(0.55278027465) * ddp_o_4_y + Scalar(0.00164448757736927) * U_4_xy +
      Scalar(0.0510201361568155) * t31 + Scalar(0.16284087268546085) * U_4_zy -
      Scalar(0.0039053550262761) * U_4_zz_xx + t83 + Scalar(0.0825) * t89;
  const Scalar t90 = Scalar(0.55278027465) * t31 + Scalar(2.012523553603) * U_4_zy + t89;
  const Scalar t91 = omega_r_3_y * omega_3_z;
  const Scalar t92 = t11 * t11;
  const Scalar U_3_yy = t9 + t92;
  const Scalar U_3_xx_yy = U_3_xx - U_3_yy;
  const Scalar U_3_xy = domega_3_z - t27;
  const Scalar t93 = Scalar(0.028227094878) * t7 - Scalar(0.746857959872) * ddp_3_y -
      Scalar(0.022178148964878235) * U_3_xy - Scalar(0.004377257121839584) * (t12 - t13) -
      Scalar(0.061602421026527694) * U_3_yx + Scalar(0.005487648106562256) * (t28 - t91) -
      Scalar(0.000121912420950744) * U_3_xx_yy - Scalar(0.0825) * t90 + s_4 * mu_4_x + c_4 * mu_4_y;
  tau[2] = -t93;
  const Scalar t94 = t28 + t91;
  const Scalar U_3_zz = t8 + t92;
  const Scalar U_3_yy_zz = U_3_yy - U_3_zz;
  const Scalar mu_3_x = Scalar(0.028227094878) * ddp_o_3_y - Scalar(0.005487648106562256) * U_3_yx +
      Scalar(0.000121912420950744) * t14 + Scalar(0.022178148964878235) * t94 +
      Scalar(0.004377257121839584) * U_3_yy_zz + s_4 * mu_4_y - c_4 * mu_4_x;
  const Scalar f_4_x = Scalar(0.55278027465) * U_4_xx - Scalar(2.012523553603) * U_4_xy + f_u_5_t_x;
  const Scalar f_4_y = Scalar(0.55278027465) * U_4_yx + Scalar(2.012523553603) * U_4_yy - t87;
  const Scalar f_3_x = Scalar(0.746857959872) * U_3_xx + Scalar(0.028227094878) * U_3_xy -
      s_4 * f_4_y - c_4 * f_4_x;
  const Scalar f_3_y = Scalar(0.746857959872) * U_3_yx - Scalar(0.028227094878) * U_3_yy + t90;
  const Scalar f_u_3_t_x = s_3 * f_3_y + c_3 * f_3_x;
  const Scalar t95 = s_4 * f_4_x - c_4 * f_4_y;
  const Scalar U_3_zz_xx = U_3_xx - U_3_zz;
  const Scalar mu_3_y = Scalar(0.746857959872) * ddp_o_3_y + Scalar(0.004377257121839584) * U_3_xy +
      Scalar(0.061602421026527694) * t14 + Scalar(0.000121912420950744) * t94 +
      Scalar(0.005487648106562256) * U_3_zz_xx - t88 + Scalar(0.0825) * t95;
  const Scalar t96 = t1 * t1;
  const Scalar U_2_xx = t16 + t96;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  const Scalar U_2_yx = qdd_2 + t6;
  tau[1] = Scalar(0.01993386669246) * c_2 - Scalar(32.80954542685272) * s_2 -
      Scalar(0.01026110182100817) * t3 - Scalar(0.0007689361029464) * t25 +
      Scalar(1.032162061231881) * U_2_xy + Scalar(0.023077882494931805) * U_2_yx +
      Scalar(0.00398335888393552) * U_2_xx_yy - Scalar(0.316) * f_u_3_t_x + s_3 * mu_3_x -
      c_3 * mu_3_y;
  const Scalar t97 = s_3 * f_3_x - c_3 * f_3_y;
  const Scalar U_2_zx = t24 + t26;
  const Scalar U_2_zz = t96 + t15;
  const Scalar U_2_yy_zz = U_2_yy - U_2_zz;
  const Scalar mu_2_x = Scalar(0.01026110182100817) * U_2_yx -
      Scalar(0.00398335888393552) * U_2_zx - Scalar(1.032162061231881) * U_2_zy -
      Scalar(0.0007689361029464) * U_2_yy_zz + Scalar(0.316) * t97 + s_3 * mu_3_y + c_3 * mu_3_x;
  const Scalar U_2_zz_xx = U_2_xx - U_2_zz;
  const Scalar mu_2_y = Scalar(0.0007689361029464) * U_2_xy +
      Scalar(0.023077882494931805) * U_2_zx + Scalar(0.00398335888393552) * U_2_zy +
      Scalar(0.01026110182100817) * U_2_zz_xx + t93;
  tau[0] = Scalar(0.014259565994474374) * qdd_1 - s_2 * mu_2_x - c_2 * mu_2_y;
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

// joint-space inertia matrix B(q) (7.32).
//   q[7]   in   joint positions, rad or m
//   B[49]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//               7 x 7, row by row: entry (i, j) is B[7 * i + j]
// Reads q[1..6]. Operations: 182 mul, 157 add, 12 sin/cos.
template <class Scalar>
inline void inertia_matrix(const Scalar* q, Scalar* B) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar Iu_7_t_yz = Scalar(0.0012555365982728983) * c_7 +
      Scalar(0.0009653051699191118) * s_7;
  B[41] = B[47] = -Iu_7_t_yz;
  const Scalar Iu_7_t_g = Scalar(0.00242094377852123) * c_7 - Scalar(0.000782782563368496) * s_7;
  const Scalar t1 = c_7 * Iu_7_t_g;
  const Scalar hu_7_t_x = Scalar(0.002573605371338203) * c_7 - Scalar(0.002034439958661797) * s_7;
  const Scalar t2 = Scalar(0.176) * hu_7_t_x;
  const Scalar t3 = t1 - t2 - Scalar(0.055009225789188536);
  B[40] = -t3;
  const Scalar mu_7_6_y = Scalar(0.088) * hu_7_t_x + Scalar(0.006684151967360946);
  const Scalar Iu_7_t_xz = Scalar(0.0009653051699191118) * c_7 -
      Scalar(0.0012555365982728983) * s_7;
  const Scalar mu_u_7_6_t_y = s_6 * Iu_7_t_xz + c_6 * mu_7_6_y;
  B[34] = B[46] = -mu_u_7_6_t_y;
  const Scalar hu_7_t_y = Scalar(0.002034439958661797) * c_7 + Scalar(0.002573605371338203) * s_7;
  const Scalar Ic_6_xz = Scalar(0.088) * hu_7_t_y - s_7 * Iu_7_t_g - Scalar(0.000287632364465563);
  const Scalar Ic_6_yz = Iu_7_t_yz + Scalar(0.000093569097314605);
  const Scalar t4 = s_6 * Ic_6_xz - c_6 * Ic_6_yz;
  B[33] = B[39] = -t4;
  const Scalar t5 = s_6 * mu_7_6_y - c_6 * Iu_7_t_xz;
  const Scalar t6 = c_6 * hu_7_t_y;
  const Scalar t7 = s_5 * hu_7_t_x - c_5 * t6;
  const Scalar t8 = s_6 * hu_7_t_y;
  const Scalar t9 = Scalar(0.384) * t7 + s_5 * t5 + c_5 * Iu_7_t_yz - Scalar(0.0825) * t8;
  B[27] = B[45] = -t9;
  const Scalar Iu_7_t_xx = t1 - Scalar(0.00242094377852123);
  const Scalar Ic_6_yy = t2 - Scalar(0.00528056308065248);
  const Scalar Iu_6_t_d = Iu_7_t_xx - Ic_6_yy;
  const Scalar Ic_6_xy = Iu_7_t_xz + Scalar(0.014748570382675316);
  const Scalar t10 = Scalar(2.0) * s_6 * Ic_6_xy - c_6 * Iu_6_t_d;
  const Scalar t11 = c_6 * t10;
  const Scalar Ic_5_zz = Iu_7_t_xx + t11 + Scalar(0.04498331431194894);
  B[32] = Ic_5_zz;
  const Scalar Iu_6_t_xz = s_6 * Ic_6_yz + c_6 * Ic_6_xz;
  const Scalar hc_6_x = hu_7_t_x + Scalar(0.231847552695);
  const Scalar hu_6_t_y = Scalar(0.173804705569) * c_6 - s_6 * hc_6_x;
  const Scalar t12 = t3 + Scalar(0.384) * hu_6_t_y;
  const Scalar hu_6_t_x = Scalar(0.173804705569) * s_6 + c_6 * hc_6_x;
  const Scalar mu_6_4_z = Scalar(0.0825) * hu_6_t_x - s_5 * Iu_6_t_xz + c_5 * t12;
  B[26] = B[38] = -mu_6_4_z;
  const Scalar t13 = c_5 * Iu_6_t_xz + s_5 * t12;
  const Scalar t14 = s_5 * hu_6_t_y;
  const Scalar t15 = Scalar(0.0825) * t14;
  const Scalar t16 = t4 + t15;
  const Scalar mu_6_3_z = t15 - s_4 * t13 - c_4 * t16;
  B[19] = B[37] = mu_6_3_z;
  const Scalar f_u_7_5_t_y = s_5 * t6 + c_5 * hu_7_t_x;
  const Scalar mu_7_4_x = Scalar(0.384) * f_u_7_5_t_y - s_5 * Iu_7_t_yz + c_5 * t5;
  const Scalar t17 = Scalar(0.0825) * f_u_7_5_t_y;
  const Scalar mu_7_4_y = mu_u_7_6_t_y - t17;
  const Scalar mu_7_3_z = t17 - s_4 * mu_7_4_x + c_4 * mu_7_4_y;
  B[20] = B[44] = -mu_7_3_z;
  const Scalar mu_u_7_4_t_x = s_4 * mu_7_4_y + c_4 * mu_7_4_x;
  const Scalar t18 = s_4 * t8 + c_4 * t7;
  const Scalar t19 = s_3 * f_u_7_5_t_y + c_3 * t18;
  const Scalar t20 = t9 - Scalar(0.0825) * (s_4 * t7 - c_4 * t8);
  B[13] = B[43] = Scalar(0.316) * t19 + s_3 * mu_u_7_4_t_x + c_3 * t20;
  const Scalar Ic_5_xz = Ic_6_xy - s_6 * t10 - Scalar(0.004600245517563106);
  const Scalar t21 = t4 + Scalar(0.00216405205209813);
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.014653732538);
  const Scalar hc_5_y = hu_7_t_y - Scalar(0.067870631425);
  const Scalar t22 = s_5 * hc_5_x - c_5 * hc_5_y;
  const Scalar B_45 = Scalar(0.384) * t22 - (s_5 * Ic_5_xz + c_5 * t21);
  B[25] = B[31] = B_45;
  const Scalar t23 = s_4 * t16 - c_4 * t13;
  const Scalar t24 = c_5 * hu_6_t_y;
  const Scalar t25 = s_4 * hu_6_t_x - c_4 * t24;
  const Scalar t26 = s_3 * t14 + c_3 * t25;
  const Scalar f_u_6_4_t_y = s_4 * t24 + c_4 * hu_6_t_x;
  const Scalar mu_6_3_y = mu_6_4_z - Scalar(0.0825) * f_u_6_4_t_y;
  B[12] = B[36] = s_3 * t23 - Scalar(0.316) * t26 + c_3 * mu_6_3_y;
  const Scalar t27 = s_3 * t18 - c_3 * f_u_7_5_t_y;
  const Scalar t28 = s_2 * (Scalar(0.316) * t27 + s_3 * t20 - c_3 * mu_u_7_4_t_x);
  B[6] = B[42] = t28 - c_2 * mu_7_3_z;
  const Scalar Iu_6_t_xx = Ic_6_yy - t11;
  const Scalar t29 = t3 + Scalar(0.04208100218189551);
  const Scalar Iu_5_t_d = Iu_6_t_xx + t29;
  const Scalar Ic_5_xy = Iu_6_t_xz - Scalar(0.00151524447332703);
  const Scalar t30 = Scalar(2.0) * s_5 * Ic_5_xy - c_5 * Iu_5_t_d;
  const Scalar t31 = c_5 * t30;
  const Scalar hu_5_t_x = s_5 * hc_5_y + c_5 * hc_5_x;
  const Scalar t32 = Scalar(0.165) * hu_5_t_x;
  const Scalar t33 = Scalar(0.768) * hu_6_t_y;
  const Scalar B_44 = Iu_6_t_xx + t31 - t33 - t32 + Scalar(0.7918443694347095);
  B[24] = B_44;
  const Scalar mu_5_4_x = Scalar(0.384) * hu_5_t_x + (s_5 * t21 - c_5 * Ic_5_xz);
  const Scalar t34 = Scalar(0.0825) * hu_5_t_x;
  const Scalar mu_5_4_y = Ic_5_zz - t34;
  const Scalar mu_5_3_z = t34 - s_4 * mu_5_4_x + c_4 * mu_5_4_y;
  B[18] = B[30] = mu_5_3_z;
  const Scalar t35 = s_3 * t25 - c_3 * t14;
  const Scalar t36 = s_2 * (Scalar(0.316) * t35 - s_3 * mu_6_3_y + c_3 * t23);
  B[5] = B[35] = c_2 * mu_6_3_z - t36;
  const Scalar t37 = Scalar(-0.0825) * t22;
  const Scalar t38 = Ic_5_xy - s_5 * t30 - t37 - Scalar(0.0039053550262761);
  const Scalar t39 = B_45 - Scalar(0.00164448757736927);
  const Scalar Iu_4_t_yz = s_4 * t38 - c_4 * t39;
  B[17] = B[23] = -Iu_4_t_yz;
  const Scalar mu_u_5_4_t_x = s_4 * mu_5_4_y + c_4 * mu_5_4_x;
  const Scalar t40 = B_45 + s_4 * t37;
  const Scalar t41 = c_4 * t22;
  const Scalar t42 = s_3 * hu_5_t_x + c_3 * t41;
  B[11] = B[29] = Scalar(-0.316) * t42 - s_3 * mu_u_5_4_t_x - c_3 * t40;
  const Scalar t43 = s_4 * t39 + c_4 * t38;
  const Scalar hc_4_x = hu_5_t_x - Scalar(0.55278027465);
  const Scalar hc_4_y = hu_6_t_y - Scalar(2.012523553603);
  const Scalar hu_4_t_x = s_4 * hc_4_y + c_4 * hc_4_x;
  const Scalar t44 = s_4 * hc_4_x - c_4 * hc_4_y;
  const Scalar t45 = Scalar(0.316) * t44 + (B_44 + Scalar(0.0825) * hu_4_t_x);
  B[10] = B[22] = -s_3 * t43 - c_3 * t45;
  const Scalar t46 = s_3 * t41 - c_3 * hu_5_t_x;
  const Scalar t47 = s_2 * (Scalar(0.316) * t46 + s_3 * t40 - c_3 * mu_u_5_4_t_x);
  B[4] = B[28] = c_2 * mu_5_3_z - t47;
  const Scalar Ic_4_xx = t29 + t31 + t33;
  const Scalar Ic_4_yy = Ic_5_zz - t32 - Scalar(0.6898040971210785);
  const Scalar Iu_4_t_d = Ic_4_xx + Ic_4_yy;
  const Scalar Ic_4_xy = Scalar(0.0825) * hu_6_t_y + mu_5_4_x - Scalar(0.16284087268546085);
  const Scalar t48 = Scalar(2.0) * s_4 * Ic_4_xy - c_4 * Iu_4_t_d;
  const Scalar t49 = c_4 * t48;
  const Scalar t50 = Scalar(0.165) * hu_4_t_x;
  const Scalar t51 = Ic_4_xx + t49 - t50 - Scalar(0.8246048032693);
  B[16] = -t51;
  B[3] = B[21] = s_2 * (c_3 * t43 - s_3 * t45) - c_2 * Iu_4_t_yz;
  const Scalar t52 = Ic_4_xy + Scalar(0.0825) * t44 - s_4 * t48 + Scalar(0.005487648106562256);
  const Scalar Ic_3_yz = Iu_4_t_yz - Scalar(0.004377257121839584);
  const Scalar hc_3_x = hu_4_t_x + Scalar(0.746857959872);
  const Scalar t53 = t22 + Scalar(0.028227094878);
  const Scalar t54 = s_3 * hc_3_x + c_3 * t53;
  const Scalar t55 = Scalar(0.316) * t54 + (s_3 * t52 - c_3 * Ic_3_yz);
  B[9] = B[15] = -t55;
  const Scalar Iu_4_t_xx = Ic_4_yy + t49;
  const Scalar t56 = B_44 + t50 - Scalar(0.7013999612162445);
  const Scalar Iu_3_t_d = Iu_4_t_xx - t56;
  const Scalar t57 = t37 + t43 - Scalar(0.000121912420950744);
  const Scalar t58 = Scalar(2.0) * s_3 * t57 - c_3 * Iu_3_t_d;
  const Scalar t59 = c_3 * t58;
  const Scalar t60 = Scalar(-0.632) * t44;
  B[8] = Iu_4_t_xx + t59 - t60 + Scalar(1.8182423259695848);
  const Scalar t61 = s_3 * t53 - c_3 * hc_3_x;
  const Scalar t62 = Scalar(0.316) * t61 - (s_3 * Ic_3_yz + c_3 * t52);
  B[2] = B[14] = -s_2 * t62 - c_2 * t51;
  B[1] = B[7] = -s_2 * (t57 - s_3 * t58 + Scalar(0.01026110182100817)) -
      c_2 * (t55 + Scalar(0.0007689361029464));
  const Scalar t63 = t56 - t59 - t60;
  const Scalar t64 = Scalar(2.0) * s_2 * (t62 + Scalar(0.00398335888393552)) +
      c_2 * (t51 + t63 + Scalar(1.7720865609797212));
  B[0] = t63 - c_2 * t64 + Scalar(1.8094240094691274);
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
template <class Scalar>
inline void christoffel(const Scalar* q, Scalar* c) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar Iu_7_t_xz = Scalar(0.0004826525849595559) * c_7 -
      Scalar(0.0006277682991364491) * s_7;
  c[167] = Scalar(-2.0) * Iu_7_t_xz;
  const Scalar t1 = Scalar(0.000391391281684248) * c_7 + Scalar(0.001210471889260615) * s_7;
  const Scalar dmu_6_7_y = t1 - Scalar(0.00008951535818111907);
  const Scalar t2 = Scalar(0.001210471889260615) * c_7 - Scalar(0.000391391281684248) * s_7;
  const Scalar t3 = t2 - Scalar(0.00011323863633888094);
  const Scalar hu_7_t_y = Scalar(0.0010172199793308985) * c_7 + Scalar(0.0012868026856691014) * s_7;
  const Scalar t4 = Scalar(0.088) * hu_7_t_y;
  const Scalar db_66_7r = t4 - c_7 * dmu_6_7_y - s_7 * t3;
  c[188] = db_66_7r;
  c[166] = -db_66_7r;
  const Scalar t5 = c_6 * hu_7_t_y;
  const Scalar t6 = Scalar(0.088) * t5;
  const Scalar Iu_7_t_yz = Scalar(0.0006277682991364491) * c_7 +
      Scalar(0.0004826525849595559) * s_7;
  const Scalar db_57_7 = s_6 * Iu_7_t_yz + t6;
  c[139] = Scalar(2.0) * db_57_7;
  const Scalar t7 = s_7 * t2 - t4 + Scalar(0.0001438161822327815);
  const Scalar Ic_6_yz = Iu_7_t_yz + Scalar(0.0000467845486573025);
  const Scalar t8 = c_6 * t7 - s_6 * Ic_6_yz;
  c[132] = Scalar(2.0) * t8;
  const Scalar dmu_5_7_x = Scalar(0.0006277682991364491) * c_6 + s_6 * t1;
  const Scalar dmu_5_7_y = Scalar(0.0004826525849595559) * c_6 + s_6 * t2;
  const Scalar db_55_7r = s_6 * (c_7 * dmu_5_7_x + s_7 * dmu_5_7_y) + c_6 * (t6 + db_57_7);
  c[182] = db_55_7r;
  const Scalar t9 = Scalar(0.384) * c_5;
  const Scalar v_4_6_x = Scalar(0.0825) * s_6 + c_6 * t9;
  const Scalar t10 = Scalar(0.0012868026856691014) * c_7 - Scalar(0.0010172199793308985) * s_7;
  const Scalar t11 = t10 * v_4_6_x + s_5 * t4 * (s_6 + Scalar(4.363636363636363));
  const Scalar t12 = s_5 * c_6;
  const Scalar t13 = c_7 * t12;
  const Scalar t14 = t13 - c_5 * s_7;
  const Scalar t15 = s_7 * t12;
  const Scalar w_4_7_y = t15 + c_5 * c_7;
  const Scalar t16 = Scalar(0.0006277682991364491) * t14 + Scalar(0.0004826525849595559) * w_4_7_y -
      t11;
  c[111] = Scalar(-2.0) * t16;
  const Scalar t17 = Scalar(0.088) * t10 + Scalar(0.003342075983680473);
  const Scalar t18 = c_6 * t17 + s_6 * Iu_7_t_xz;
  const Scalar v_4_6_y = Scalar(0.0825) * c_6 - s_6 * t9;
  const Scalar t19 = s_5 * t18 - hu_7_t_y * v_4_6_y;
  const Scalar v_o_4_7_y = Scalar(0.088) * c_5 - v_4_6_y;
  const Scalar t20 = s_5 * s_6;
  const Scalar t21 = hu_7_t_y * v_o_4_7_y + t14 * t3 - w_4_7_y * dmu_6_7_y - Iu_7_t_xz * t20;
  const Scalar c_6_25 = t19 - t21;
  c[164] = c_6_25;
  const Scalar t22 = c_6 * Iu_7_t_xz;
  const Scalar db_56_7r = t22 + s_6 * (c_7 * t3 - s_7 * dmu_6_7_y);
  const Scalar t23 = t22 - s_6 * t17;
  const Scalar c_6_5_7 = t23 + db_56_7r;
  c[165] = c_6_5_7;
  const Scalar t24 = c_7 * t2;
  const Scalar t25 = t24 - Scalar(0.001210471889260615);
  const Scalar t26 = Scalar(0.176) * t10;
  const Scalar Ic_6_yy = t26 - Scalar(0.00264028154032624);
  const Scalar t27 = t25 - Ic_6_yy;
  const Scalar Ic_6_xy = Iu_7_t_xz + Scalar(0.007374285191337658);
  const Scalar t28 = Scalar(2.0) * Ic_6_xy;
  const Scalar t29 = c_6 * t27 - s_6 * t28;
  const Scalar t30 = s_6 * t29;
  const Scalar t31 = c_6 * t28 + s_6 * t27;
  const Scalar db_55_6r = t30 + c_6 * t31;
  c[131] = db_55_6r;
  c[137] = -db_55_7r;
  const Scalar t32 = t10 + Scalar(0.1159237763475);
  const Scalar hu_6_t_x = Scalar(0.0869023527845) * s_6 + c_6 * t32;
  const Scalar t33 = s_5 * hu_6_t_x;
  const Scalar t34 = c_4 - Scalar(1.0);
  const Scalar v_o_3_5_z = Scalar(0.384) * s_4 + Scalar(0.0825) * t34;
  const Scalar t35 = v_o_3_5_z * t33;
  const Scalar t36 = s_4 * c_5;
  const Scalar t37 = c_4 * c_6 - s_6 * t36;
  const Scalar w_3_6_x = c_4 * s_6 + c_6 * t36;
  const Scalar t38 = t35 + t7 * t37 - Ic_6_yz * w_3_6_x;
  c[76] = Scalar(2.0) * t38;
  const Scalar t39 = c_6 * Ic_6_yz + s_6 * t7;
  const Scalar t40 = Scalar(0.0869023527845) * v_4_6_y - t32 * v_4_6_x;
  const Scalar t41 = t40 - s_5 * t39;
  c[104] = Scalar(-2.0) * t41;
  const Scalar t42 = Scalar(0.088) * s_4 + s_6 * v_o_3_5_z;
  const Scalar t43 = s_5 * t42;
  const Scalar t44 = s_4 * s_5;
  const Scalar w_3_7_x = c_7 * w_3_6_x + s_7 * t44;
  const Scalar t45 = c_7 * t44 - s_7 * w_3_6_x;
  const Scalar t46 = Iu_7_t_xz * t37;
  const Scalar t47 = t46 - hu_7_t_y * t43 + w_3_7_x * t3 + t45 * dmu_6_7_y;
  const Scalar t48 = hu_7_t_y * v_o_3_5_z * t20 + t46 - w_3_6_x * t17;
  const Scalar c_6_3_7 = t48 + t47;
  c[163] = c_6_3_7;
  c[110] = -t19 - t21;
  c[186] = -c_6_25;
  c[138] = db_56_7r - t23;
  c[187] = -c_6_5_7;
  c[154] = -db_55_6r;
  const Scalar dmu_4_7_x = Scalar(0.0012868026856691014) * v_o_4_7_y -
      Scalar(0.000391391281684248) * t14 - Scalar(0.001210471889260615) * w_4_7_y +
      Scalar(0.0006277682991364491) * t20;
  const Scalar t49 = Scalar(0.0010172199793308985) * v_o_4_7_y +
      Scalar(0.001210471889260615) * t14 - Scalar(0.000391391281684248) * w_4_7_y -
      Scalar(0.0004826525849595559) * t20;
  const Scalar t50 = Scalar(0.0012868026856691014) * t14 - Scalar(0.0010172199793308985) * w_4_7_y;
  const Scalar db_44_7r = t20 * (t11 - t16) - v_o_4_7_y * t50 - t14 * dmu_4_7_x + w_4_7_y * t49;
  c[177] = db_44_7r;
  const Scalar t51 = c_5 * v_o_3_5_z;
  const Scalar t52 = Scalar(0.088) * t37 - t51;
  const Scalar t53 = v_o_3_5_z * t13 + s_7 * t52;
  const Scalar t54 = Scalar(0.0012868026856691014) * t53 +
      Scalar(0.0010172199793308985) * (c_7 * t52 - v_o_3_5_z * t15);
  const Scalar db_37_7 = Scalar(0.0006277682991364491) * w_3_7_x -
      Scalar(0.0004826525849595559) * t45 + t54;
  c[83] = Scalar(2.0) * db_37_7;
  const Scalar t55 = s_3 * c_4;
  const Scalar t56 = c_3 * s_5;
  const Scalar w_2_5_x = t56 + c_5 * t55;
  const Scalar t57 = s_3 * s_4;
  const Scalar t58 = c_6 * w_2_5_x - s_6 * t57;
  const Scalar w_2_6_y = c_6 * t57 + s_6 * w_2_5_x;
  const Scalar t59 = Scalar(0.316) * c_4;
  const Scalar t60 = Scalar(0.0825) * s_4 - t59;
  const Scalar t61 = t60 - Scalar(0.384);
  const Scalar t62 = s_3 * (c_4 - Scalar(0.21484375) * s_4 + Scalar(0.8229166666666666));
  const Scalar v_2_5_y = t62 * t9 - t61 * t56;
  const Scalar hu_6_t_y = Scalar(0.0869023527845) * c_6 - s_6 * t32;
  const Scalar t63 = hu_6_t_y * v_2_5_y;
  const Scalar t64 = c_3 * c_5 - s_5 * t55;
  const Scalar t65 = t8 * t64;
  const Scalar db_25_6r = t63 + t65 - t29 * t58 + w_2_6_y * t31;
  const Scalar t66 = t24 - t26 - Scalar(0.027504612894594268);
  const Scalar t67 = t66 * w_2_5_x + t63 - t65;
  const Scalar c_5_17 = t67 - db_25_6r;
  c[128] = c_5_17;
  c[82] = t47 - t48;
  c[185] = -c_6_3_7;
  const Scalar t68 = s_6 * (s_5 * db_57_7 + t10 * v_o_4_7_y);
  const Scalar t69 = t68 + c_6 * t11 - t14 * dmu_5_7_x - w_4_7_y * dmu_5_7_y;
  const Scalar t70 = c_5 * t10 + hu_7_t_y * t12;
  const Scalar t71 = Scalar(0.384) * t70 - c_5 * t23 - s_5 * Iu_7_t_yz;
  const Scalar c_5_25 = t71 - t69;
  c[136] = c_5_25;
  const Scalar t72 = t32 * t51 - Ic_6_yz * t44 + t27 * t37 - t28 * w_3_6_x;
  const Scalar dmu_3_6_y = Scalar(0.0869023527845) * t51 - t7 * t44 - t27 * w_3_6_x - t28 * t37;
  const Scalar t73 = Scalar(0.0869023527845) * t37 - t32 * w_3_6_x;
  const Scalar db_33_6r = t44 * (t35 + t38) - t51 * t73 + w_3_6_x * t72 - t37 * dmu_3_6_y;
  c[73] = db_33_6r;
  c[108] = -db_44_7r;
  const Scalar t74 = s_2 * c_3;
  const Scalar t75 = c_2 * s_4 - c_4 * t74;
  const Scalar t76 = s_2 * s_3;
  const Scalar t77 = s_5 * t76;
  const Scalar w_1_5_x = c_5 * t75 + t77;
  const Scalar w_1_4_y = c_2 * c_4 + s_4 * t74;
  const Scalar w_1_6_x = c_6 * w_1_5_x + s_6 * w_1_4_y;
  const Scalar t78 = c_6 * w_1_4_y - s_6 * w_1_5_x;
  const Scalar v_o_1_4_y = Scalar(0.0825) * c_2 + Scalar(0.316) * t74;
  const Scalar v_o_1_5_z = v_o_1_4_y - Scalar(0.384) * t75 - Scalar(0.0825) * w_1_4_y;
  const Scalar t79 = c_5 * v_o_1_5_z + t61 * t77;
  const Scalar t80 = hu_6_t_y * t79;
  const Scalar w_1_5_y = c_5 * t76 - s_5 * t75;
  const Scalar t81 = t8 * w_1_5_y;
  const Scalar db_15_6r = t80 - t81 + t29 * w_1_6_x + t78 * t31;
  const Scalar t82 = t66 * w_1_5_x - t80 - t81;
  const Scalar c_5_16 = t82 + db_15_6r;
  c[127] = c_5_16;
  c[47] = -t67 - db_25_6r;
  c[151] = -c_5_17;
  const Scalar t83 = c_5 * t66 + s_5 * t8;
  const Scalar t84 = hu_6_t_y * t51;
  const Scalar t85 = s_4 * t83 + t84;
  const Scalar db_35_6r = t84 - t29 * w_3_6_x - t37 * t31 - t8 * t44;
  const Scalar c_5_18 = t85 - db_35_6r;
  c[129] = c_5_18;
  const Scalar t86 = c_6 * t54 + t37 * db_57_7 + t10 * t42 * t20 + w_3_7_x * dmu_5_7_x -
      t45 * dmu_5_7_y;
  const Scalar t87 = c_5 * Iu_7_t_yz - s_5 * t23;
  const Scalar t88 = c_5 * t5 - s_5 * t10;
  const Scalar t89 = s_4 * t87 - v_o_3_5_z * t88;
  const Scalar c_5_3_7 = t89 - t86;
  c[135] = c_5_3_7;
  c[109] = -t71 - t69;
  c[181] = -c_5_25;
  const Scalar df_3_7_z = Scalar(0.0012868026856691014) * w_3_7_x +
      Scalar(0.0010172199793308985) * t45;
  const Scalar t90 = Scalar(0.0006277682991364491) * t37 + Scalar(0.000391391281684248) * w_3_7_x -
      Scalar(0.001210471889260615) * t45 + Scalar(0.0012868026856691014) * t43;
  const Scalar t91 = Scalar(0.0004826525849595559) * t37 + Scalar(0.001210471889260615) * w_3_7_x +
      Scalar(0.000391391281684248) * t45 - Scalar(0.0010172199793308985) * t43;
  const Scalar db_33_7r = t37 * (t54 + db_37_7) + df_3_7_z * t43 + w_3_7_x * t90 - t45 * t91;
  c[173] = db_33_7r;
  const Scalar Ic_5_xz = Ic_6_xy + t30 - Scalar(0.002300122758781553);
  const Scalar t92 = c_5 * t61;
  const Scalar t93 = t76 * t92 - s_5 * v_o_1_5_z;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.007326866269);
  const Scalar hc_5_y = hu_7_t_y - Scalar(0.0339353157125);
  const Scalar t94 = hc_5_x * t93 + hc_5_y * t79;
  const Scalar t95 = t39 - Scalar(0.001082026026049065);
  const Scalar t96 = t94 + Ic_5_xz * w_1_5_y + t95 * w_1_5_x;
  c[14] = Scalar(2.0) * t96;
  const Scalar t97 = c_3 * t92 + Scalar(0.384) * s_5 * t62;
  const Scalar t98 = hc_5_x * t97 - hc_5_y * v_2_5_y;
  const Scalar t99 = t98 + Ic_5_xz * t64 + t95 * w_2_5_x;
  c[42] = Scalar(2.0) * t99;
  const Scalar hu_5_t_x = c_5 * hc_5_x + s_5 * hc_5_y;
  const Scalar db_45_5 = Scalar(0.384) * hu_5_t_x - c_5 * Ic_5_xz - s_5 * t95;
  c[98] = Scalar(2.0) * db_45_5;
  c[19] = db_15_6r - t82;
  c[150] = -c_5_16;
  c[145] = -db_33_6r;
  c[75] = -t85 - db_35_6r;
  c[152] = -c_5_18;
  c[81] = -t89 - t86;
  c[180] = -c_5_3_7;
  const Scalar t100 = c_6 * t29;
  const Scalar t101 = Scalar(0.384) * hu_6_t_y;
  const Scalar t102 = c_5 * t8;
  const Scalar t103 = t102 - s_5 * (t100 - t101 - s_6 * t31);
  const Scalar t104 = s_5 * (t66 + t101) - t102;
  c[103] = t104 + t103;
  const Scalar c_5_4_6 = t104 - t103;
  c[153] = c_5_4_6;
  c[79] = -db_33_7r;
  const Scalar t105 = Scalar(0.0825) * c_4 + Scalar(0.316) * s_4;
  const Scalar t106 = t105 - Scalar(0.0825);
  const Scalar t107 = t106 * t76;
  const Scalar t108 = c_6 * t93 + s_6 * t107;
  const Scalar t109 = c_6 * t107 - s_6 * t93;
  const Scalar t110 = Scalar(0.0869023527845) * t109 - t32 * t108;
  const Scalar t111 = t110 - t7 * t78 + Ic_6_yz * w_1_6_x;
  c[20] = Scalar(-2.0) * t111;
  const Scalar t112 = c_3 * t106;
  const Scalar t113 = c_6 * t97 + s_6 * t112;
  const Scalar t114 = c_6 * t112 - s_6 * t97;
  const Scalar t115 = Scalar(0.0869023527845) * t114 - t32 * t113;
  const Scalar t116 = t115 + t7 * w_2_6_y + Ic_6_yz * t58;
  c[48] = Scalar(-2.0) * t116;
  const Scalar v_o_1_7_y = Scalar(0.088) * w_1_5_y + t109;
  const Scalar t117 = c_7 * w_1_6_x - s_7 * w_1_5_y;
  const Scalar w_1_7_y = c_7 * w_1_5_y + s_7 * w_1_6_x;
  const Scalar t118 = Iu_7_t_xz * t78;
  const Scalar t119 = t118 + hu_7_t_y * v_o_1_7_y + t117 * t3 - w_1_7_y * dmu_6_7_y;
  const Scalar t120 = hu_7_t_y * t109 - t118 + w_1_6_x * t17;
  c[26] = t120 + t119;
  const Scalar c_7_16 = t120 - t119;
  c[183] = c_7_16;
  const Scalar t121 = Scalar(0.088) * t64 + t114;
  const Scalar w_2_7_x = c_7 * t58 - s_7 * t64;
  const Scalar t122 = c_7 * t64 + s_7 * t58;
  const Scalar t123 = Iu_7_t_xz * w_2_6_y;
  const Scalar db_26_7r = t123 - hu_7_t_y * t121 - w_2_7_x * t3 + t122 * dmu_6_7_y;
  const Scalar t124 = hu_7_t_y * t114 + t123 + t58 * t17;
  c[54] = t124 - db_26_7r;
  const Scalar c_7_17 = t124 + db_26_7r;
  c[184] = c_7_17;
  const Scalar t125 = s_5 * (Scalar(0.384) * t32 - t31) + c_5 * Ic_6_yz;
  const Scalar t126 = s_5 * (t29 - Scalar(0.033370503469248)) - c_5 * t7;
  const Scalar t127 = t44 * t41 + w_3_6_x * t125 + t37 * t126;
  const Scalar t128 = Scalar(0.0825) * hu_6_t_y;
  const Scalar t129 = s_5 * t128;
  const Scalar t130 = t39 - t129;
  const Scalar t131 = c_4 * t104 + s_4 * t130;
  const Scalar c_4_3_6 = t131 - t127;
  c[101] = c_4_3_6;
  const Scalar t132 = s_5 * (s_6 * t54 - t42 * t50);
  const Scalar t133 = t37 * t16 - w_3_7_x * dmu_4_7_x - t45 * t49 - t132;
  const Scalar t134 = Scalar(0.0825) * t70;
  const Scalar t135 = t18 - t134;
  const Scalar t136 = c_4 * t71 + s_4 * t135;
  c[80] = t136 + t133;
  const Scalar c_4_3_7 = t136 - t133;
  c[176] = c_4_3_7;
  c[130] = -c_5_4_6;
  const Scalar Iu_6_t_xx = Ic_6_yy + t100;
  const Scalar t137 = t66 + Scalar(0.021040501090947756);
  const Scalar Iu_5_t_d = Iu_6_t_xx + t137;
  const Scalar t138 = t8 + Scalar(0.000757622236663515);
  const Scalar t139 = Scalar(-2.0) * t138;
  const Scalar t140 = hc_5_x * t107 - t95 * w_1_4_y - Iu_5_t_d * w_1_5_y + t139 * w_1_5_x;
  const Scalar t141 = hc_5_y * t107 + Ic_5_xz * w_1_4_y + Iu_5_t_d * w_1_5_x + t139 * w_1_5_y;
  const Scalar t142 = t107 * (hc_5_x * w_1_5_x - hc_5_y * w_1_5_y);
  const Scalar c_1_11 = w_1_4_y * (t94 + t96) - t142 - w_1_5_x * t140 + w_1_5_y * t141;
  c[10] = c_1_11;
  const Scalar t143 = hc_5_x * t112 + t95 * t57 - Iu_5_t_d * t64 + t139 * w_2_5_x;
  const Scalar t144 = hc_5_y * t112 - Ic_5_xz * t57 + Iu_5_t_d * w_2_5_x + t139 * t64;
  const Scalar df_2_5_z = hc_5_x * w_2_5_x - hc_5_y * t64;
  const Scalar c_5_3 = t57 * (t98 + t99) + t112 * df_2_5_z + w_2_5_x * t143 - t64 * t144;
  c[114] = c_5_3;
  const Scalar t145 = s_5 * (Scalar(0.384) * t33 + c_6 * t125 - s_6 * t126);
  const Scalar c_4_19 = t145 - c_5 * (t40 + t41);
  c[102] = c_4_19;
  const Scalar t146 = t79 + Scalar(0.088) * t78;
  const Scalar t147 = c_7 * t108 + s_7 * t146;
  const Scalar t148 = Scalar(0.0012868026856691014) * t147 +
      Scalar(0.0010172199793308985) * (c_7 * t146 - s_7 * t108);
  const Scalar t149 = Scalar(0.0006277682991364491) * t117 +
      Scalar(0.0004826525849595559) * w_1_7_y + t148;
  c[27] = Scalar(2.0) * t149;
  const Scalar v_o_2_7_z = v_2_5_y + Scalar(0.088) * w_2_6_y;
  const Scalar t150 = c_7 * t113 - s_7 * v_o_2_7_z;
  const Scalar t151 = Scalar(0.0012868026856691014) * t150 -
      Scalar(0.0010172199793308985) * (c_7 * v_o_2_7_z + s_7 * t113);
  const Scalar db_27_7 = Scalar(0.0006277682991364491) * w_2_7_x +
      Scalar(0.0004826525849595559) * t122 + t151;
  c[55] = Scalar(2.0) * db_27_7;
  const Scalar t152 = c_5 * t95 - s_5 * Ic_5_xz;
  const Scalar t153 = c_5 * hc_5_y - s_5 * hc_5_x;
  const Scalar t154 = t153 * v_o_3_5_z;
  const Scalar t155 = s_4 * t152 - t154;
  c[70] = Scalar(2.0) * t155;
  const Scalar t156 = c_5 * t110 - w_1_5_y * t41 - t79 * t33 + w_1_6_x * t125 + t78 * t126;
  const Scalar t157 = c_5 * hu_6_t_y;
  const Scalar t158 = hu_6_t_x * t60 - t105 * t157;
  const Scalar t159 = t75 * t130 + w_1_4_y * t104 - t76 * t158;
  const Scalar c_4_1_6 = t159 - t156;
  c[99] = c_4_1_6;
  c[161] = -c_7_16;
  const Scalar t160 = c_4 * t157 - s_4 * hu_6_t_x;
  const Scalar t161 = hu_6_t_y * t56 + s_3 * t160;
  const Scalar t162 = t83 - Scalar(0.0825) * (hu_6_t_x * t34 + hu_6_t_y * t36) + hu_6_t_y * t9;
  const Scalar t163 = Scalar(0.316) * t161 + c_3 * t131 + s_3 * t162;
  const Scalar t164 = t44 * t115 + t64 * t38 + v_2_5_y * t73 - t58 * t72 - w_2_6_y * dmu_3_6_y;
  const Scalar c_3_2_6 = t163 - t164;
  c[72] = c_3_2_6;
  const Scalar t165 = c_4 * t130 - s_4 * t104;
  const Scalar db_26_4 = s_3 * t165 - c_3 * t158;
  const Scalar t166 = c_5 * t115 - t64 * t41 + v_2_5_y * t33 + t58 * t125 - w_2_6_y * t126;
  const Scalar c_4_2_6 = db_26_4 - t166;
  c[100] = c_4_2_6;
  c[162] = -c_7_17;
  c[74] = -t131 - t127;
  c[148] = -c_4_3_6;
  c[107] = -c_4_3_7;
  c[112] = -c_1_11;
  c[39] = -c_5_3;
  const Scalar t167 = c_5 * t139 + s_5 * Iu_5_t_d;
  const Scalar dmu_4_5_y = Scalar(0.0825) * hc_5_y - t167;
  const Scalar t168 = c_5 * Iu_5_t_d - s_5 * t139;
  const Scalar dmu_4_5_x = Scalar(0.0825) * hc_5_x + t168;
  const Scalar t169 = Scalar(-0.0825) * t153;
  const Scalar c_4_14 = t169 - c_5 * dmu_4_5_y + s_5 * dmu_4_5_x;
  c[97] = c_4_14;
  const Scalar t170 = t79 * (Scalar(0.0869023527845) * t78 - t32 * w_1_6_x);
  const Scalar t171 = t32 * t79 - Ic_6_yz * w_1_5_y - t27 * t78 + t28 * w_1_6_x;
  const Scalar t172 = Scalar(0.0869023527845) * t79 - t7 * w_1_5_y + t27 * w_1_6_x + t28 * t78;
  const Scalar c_1_16 = w_1_5_y * (t110 + t111) + t170 - w_1_6_x * t171 + t78 * t172;
  c[15] = c_1_16;
  const Scalar df_2_6_z = Scalar(0.0869023527845) * w_2_6_y + t32 * t58;
  const Scalar t173 = t32 * v_2_5_y + Ic_6_yz * t64 - t27 * w_2_6_y - t28 * t58;
  const Scalar dmu_2_6_y = Scalar(0.0869023527845) * v_2_5_y + t7 * t64 - t27 * t58 + t28 * w_2_6_y;
  const Scalar c_2_17 = t64 * (t115 + t116) + v_2_5_y * df_2_6_z + t58 * t173 + w_2_6_y * dmu_2_6_y;
  c[44] = c_2_17;
  c[149] = -c_4_19;
  const Scalar t174 = t37 * t148 + t78 * db_37_7 - v_o_1_7_y * df_3_7_z + t117 * t90 +
      w_1_7_y * t91;
  const Scalar t175 = s_6 * hu_7_t_y;
  const Scalar t176 = c_4 * t88 - s_4 * t175;
  const Scalar t177 = s_3 * t70 - c_3 * t176;
  const Scalar t178 = t87 - Scalar(0.384) * t88 + Scalar(0.0825) * (t34 * t175 + s_4 * t88);
  const Scalar t179 = s_2 * (Scalar(0.316) * t177 + c_3 * t178 + s_3 * t136);
  const Scalar c_7_4 = t174 + t179;
  c[171] = c_7_4;
  c[18] = -t159 - t156;
  c[146] = -c_4_1_6;
  const Scalar t180 = t148 * t20 - t78 * t16 + v_o_1_7_y * t50 + t117 * dmu_4_7_x - w_1_7_y * t49;
  const Scalar t181 = t60 * t175 - t105 * t88;
  const Scalar t182 = t75 * t135 + w_1_4_y * t71 - t76 * t181;
  c[24] = t182 - t180;
  const Scalar c_4_1_7 = t182 + t180;
  c[174] = c_4_1_7;
  const Scalar t183 = s_6 * t10;
  const Scalar t184 = c_6 * t148 + t78 * db_57_7 - v_o_1_7_y * t183 + t117 * dmu_5_7_x +
      w_1_7_y * dmu_5_7_y;
  const Scalar t185 = t10 * t93 + Iu_7_t_yz * w_1_5_x + w_1_5_y * t23 + t79 * t5;
  const Scalar c_5_22 = t185 - t184;
  c[133] = c_5_22;
  c[45] = -t163 - t164;
  c[144] = -c_3_2_6;
  const Scalar t186 = t37 * t151 - w_2_6_y * db_37_7 - t121 * df_3_7_z + w_2_7_x * t90 + t122 * t91;
  const Scalar t187 = c_3 * t70 + s_3 * t176;
  const Scalar t188 = Scalar(0.316) * t187 + c_3 * t136 - s_3 * t178;
  c[51] = t188 - t186;
  const Scalar c_3_2_7 = t188 + t186;
  c[172] = c_3_2_7;
  c[46] = -db_26_4 - t166;
  c[147] = -c_4_2_6;
  const Scalar t189 = t151 * t20 + w_2_6_y * t16 + t121 * t50 + w_2_7_x * dmu_4_7_x - t122 * t49;
  const Scalar t190 = c_4 * t135 - s_4 * t71;
  const Scalar t191 = s_3 * t190 - c_3 * t181;
  c[52] = t191 - t189;
  const Scalar c_4_2_7 = t191 + t189;
  c[175] = c_4_2_7;
  const Scalar t192 = c_6 * t151 - w_2_6_y * db_57_7 - t121 * t183 + w_2_7_x * dmu_5_7_x +
      t122 * dmu_5_7_y;
  const Scalar t193 = t10 * t97 + Iu_7_t_yz * w_2_5_x + t64 * t23 - v_2_5_y * t5;
  const Scalar c_5_23 = t193 - t192;
  c[134] = c_5_23;
  c[121] = -c_4_14;
  c[140] = -c_1_16;
  c[142] = -c_2_17;
  const Scalar t194 = v_o_1_7_y * (Scalar(0.0012868026856691014) * t117 -
      Scalar(0.0010172199793308985) * w_1_7_y);
  const Scalar t195 = Scalar(0.0006277682991364491) * t78 -
      Scalar(0.0012868026856691014) * v_o_1_7_y + Scalar(0.000391391281684248) * t117 +
      Scalar(0.001210471889260615) * w_1_7_y;
  const Scalar t196 = Scalar(0.0004826525849595559) * t78 +
      Scalar(0.0010172199793308985) * v_o_1_7_y + Scalar(0.001210471889260615) * t117 -
      Scalar(0.000391391281684248) * w_1_7_y;
  const Scalar db_11_7r = t78 * (t148 + t149) - t194 + t117 * t195 + w_1_7_y * t196;
  c[168] = db_11_7r;
  const Scalar dmu_2_7_x = Scalar(0.0006277682991364491) * w_2_6_y +
      Scalar(0.0012868026856691014) * t121 - Scalar(0.000391391281684248) * w_2_7_x -
      Scalar(0.001210471889260615) * t122;
  const Scalar dmu_2_7_y = Scalar(0.0004826525849595559) * w_2_6_y -
      Scalar(0.0010172199793308985) * t121 - Scalar(0.001210471889260615) * w_2_7_x +
      Scalar(0.000391391281684248) * t122;
  const Scalar df_2_7_z = Scalar(0.0012868026856691014) * w_2_7_x -
      Scalar(0.0010172199793308985) * t122;
  const Scalar db_22_7r = w_2_6_y * (t151 + db_27_7) + t121 * df_2_7_z + w_2_7_x * dmu_2_7_x +
      t122 * dmu_2_7_y;
  c[50] = db_22_7r;
  const Scalar mu_6_3_z = t129 + t165;
  const Scalar t197 = c_2 * t163 - s_2 * mu_6_3_z;
  const Scalar t198 = t64 * t110 + w_1_5_y * t116 - t79 * df_2_6_z + w_1_6_x * t173 -
      t78 * dmu_2_6_y;
  c[16] = t197 + t198;
  const Scalar c_2_1_6 = t197 - t198;
  c[141] = c_2_1_6;
  const Scalar t199 = w_2_6_y * t148 - t78 * db_27_7 + v_o_1_7_y * df_2_7_z + t117 * dmu_2_7_x +
      w_1_7_y * dmu_2_7_y;
  const Scalar mu_7_3_z = t134 + t190;
  const Scalar t200 = c_2 * t188 - s_2 * mu_7_3_z;
  const Scalar c_2_1_7 = t200 + t199;
  c[49] = c_2_1_7;
  const Scalar t201 = s_3 * (t131 + Scalar(0.316) * s_5 * hu_6_t_y);
  const Scalar t202 = s_2 * (c_3 * (Scalar(0.316) * t160 + t162) - t201);
  const Scalar t203 = t44 * t110 + w_1_5_y * t38 - t79 * t73 - w_1_6_x * t72 + t78 * dmu_3_6_y;
  const Scalar c_3_1_6 = t203 + t202;
  c[143] = c_3_1_6;
  c[23] = t179 - t174;
  c[77] = -c_7_4;
  const Scalar t204 = db_45_5 * w_1_4_y;
  const Scalar db_14_5r = t204 - t153 * t107 - w_1_5_x * dmu_4_5_x + w_1_5_y * dmu_4_5_y;
  const Scalar t205 = t25 - t100 + Scalar(0.02249165715597447);
  const Scalar t206 = Scalar(0.0825) * hu_5_t_x;
  const Scalar t207 = t205 - t206;
  const Scalar t208 = t153 * t105;
  const Scalar db_15_4 = t76 * t208 + t75 * t207 + t204;
  const Scalar c_4_1_5 = db_15_4 + db_14_5r;
  c[94] = c_4_1_5;
  c[105] = -c_4_1_7;
  c[25] = -t185 - t184;
  c[178] = -c_5_22;
  c[78] = -c_3_2_7;
  const Scalar t209 = c_4 * t207 - s_4 * db_45_5;
  const Scalar t210 = s_3 * t209 + c_3 * t208;
  const Scalar t211 = t153 * t112 + db_45_5 * t57 + w_2_5_x * dmu_4_5_x - t64 * dmu_4_5_y;
  const Scalar c_4_2_5 = t210 - t211;
  c[95] = c_4_2_5;
  c[106] = -c_4_2_7;
  c[53] = -t193 - t192;
  c[179] = -c_5_23;
  c[21] = -db_11_7r;
  c[170] = -db_22_7r;
  const Scalar t212 = t138 - s_5 * t168 - t169 + Scalar(0.00195267751313805);
  const Scalar t213 = Scalar(0.384) * t153 - t152;
  const Scalar t214 = t213 + Scalar(0.000822243788684635);
  const Scalar hc_4_x = hu_5_t_x - Scalar(0.276390137325);
  const Scalar hc_4_y = hu_6_t_y - Scalar(1.0062617768015);
  const Scalar t215 = hc_4_x * t60 - hc_4_y * t105;
  const Scalar t216 = t76 * t215;
  const Scalar t217 = t212 * w_1_4_y + t214 * t75 + t216;
  c[9] = Scalar(2.0) * t217;
  const Scalar t218 = c_4 * t212 + s_4 * t214;
  c[65] = Scalar(2.0) * t218;
  c[43] = -c_2_1_6;
  c[22] = t199 - t200;
  c[169] = -c_2_1_7;
  c[17] = t202 - t203;
  c[71] = -c_3_1_6;
  c[13] = db_14_5r - db_15_4;
  c[118] = -c_4_1_5;
  c[41] = -t210 - t211;
  c[119] = -c_4_2_5;
  const Scalar t219 = s_4 * t167 - c_4 * t95;
  const Scalar t220 = s_4 * t168 + c_4 * Ic_5_xz;
  const Scalar c_5_6 = s_4 * (c_5 * t219 + s_5 * t220) + c_4 * (t154 - t155);
  c[117] = c_5_6;
  const Scalar t221 = c_4 * db_45_5;
  const Scalar t222 = t221 + s_4 * t207;
  const Scalar t223 = t213 + s_4 * t169;
  const Scalar t224 = c_3 * hu_5_t_x + t153 * t55;
  const Scalar t225 = Scalar(0.316) * t224 + c_3 * t222 + s_3 * t223;
  const Scalar mu_5_3_z = t206 + t209;
  const Scalar t226 = c_2 * t225 - s_2 * mu_5_3_z;
  const Scalar t227 = t57 * t94 - w_1_4_y * t99 + t107 * df_2_5_z + w_1_5_x * t143 - w_1_5_y * t144;
  c[11] = t226 - t227;
  const Scalar c_2_1_5 = t226 + t227;
  c[113] = c_2_1_5;
  const Scalar t228 = s_3 * (Scalar(0.316) * hu_5_t_x + t222) - c_3 * (t223 + t153 * t59);
  const Scalar t229 = s_2 * t228;
  const Scalar t230 = c_4 * t94 + w_1_4_y * t155 - s_4 * hu_5_t_x * t107 - w_1_5_x * t219 +
      w_1_5_y * t220;
  c[12] = t230 - t229;
  const Scalar c_3_1_5 = t230 + t229;
  c[66] = c_3_1_5;
  const Scalar t231 = s_4 * (s_3 * t155 + hu_5_t_x * t112);
  const Scalar db_23_5r = t231 - c_4 * t98 + w_2_5_x * t219 - t64 * t220;
  const Scalar c_3_2_5 = t225 - db_23_5r;
  c[67] = c_3_2_5;
  const Scalar t232 = t221 - s_4 * (c_5 * dmu_4_5_x + s_5 * dmu_4_5_y);
  const Scalar c_4_3_5 = t222 + t232;
  c[96] = c_4_3_5;
  const Scalar t233 = c_5 * t168;
  const Scalar t234 = Scalar(0.768) * hu_6_t_y;
  const Scalar t235 = t137 - t233 + t234;
  const Scalar t236 = Scalar(0.165) * hu_5_t_x;
  const Scalar t237 = t205 - t236 - Scalar(0.34490204856053924);
  const Scalar t238 = t235 + t237;
  const Scalar Ic_4_xy = db_45_5 + t128 - Scalar(0.08142043634273043);
  const Scalar t239 = Scalar(2.0) * Ic_4_xy;
  const Scalar dmu_1_4_x = hc_4_x * v_o_1_4_y + t214 * t76 + t238 * w_1_4_y - t239 * t75;
  const Scalar t240 = hc_4_y * v_o_1_4_y - t212 * t76 - t238 * t75 - t239 * w_1_4_y;
  const Scalar t241 = v_o_1_4_y * (hc_4_x * t75 - hc_4_y * w_1_4_y);
  const Scalar c_4_1 = t76 * (t216 + t217) + t241 + t75 * dmu_1_4_x - w_1_4_y * t240;
  c[84] = c_4_1;
  c[68] = -c_5_6;
  const Scalar Iu_4_t_yz = c_4 * t214 - s_4 * t212;
  const Scalar t242 = c_3 * t215;
  const Scalar t243 = s_3 * Iu_4_t_yz + t242;
  c[37] = Scalar(2.0) * t243;
  c[38] = -c_2_1_5;
  c[115] = -c_3_1_5;
  c[40] = -t225 - db_23_5r;
  c[116] = -c_3_2_5;
  c[69] = t232 - t222;
  c[120] = -c_4_3_5;
  c[6] = -c_4_1;
  const Scalar t244 = c_4 * t239 + s_4 * t238;
  const Scalar dmu_3_4_y = Scalar(0.0825) * hc_4_y - t244;
  const Scalar t245 = c_4 * t238 - s_4 * t239;
  const Scalar dmu_3_4_x = Scalar(0.0825) * hc_4_x + t245;
  const Scalar t246 = c_4 * hc_4_y - s_4 * hc_4_x;
  const Scalar t247 = Scalar(-0.0825) * t246;
  const Scalar c_4_6 = t247 - c_4 * dmu_3_4_y + s_4 * dmu_3_4_x;
  c[89] = c_4_6;
  c[64] = -c_4_6;
  const Scalar t248 = t218 * t76;
  const Scalar t249 = t248 - t246 * v_o_1_4_y + t75 * dmu_3_4_x - w_1_4_y * dmu_3_4_y;
  const Scalar t250 = Iu_6_t_xx - t233 - t234 - t236 + Scalar(0.39592218471735474);
  const Scalar t251 = Scalar(-0.316) * t246;
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * hc_4_y;
  const Scalar t252 = t250 + Scalar(0.0825) * hu_4_t_x + t251;
  const Scalar t253 = t74 * t252 - t248;
  const Scalar c_3_7 = t253 - t249;
  c[62] = c_3_7;
  const Scalar t254 = Ic_4_xy + s_4 * t245 + t247 + Scalar(0.002743824053281128);
  const Scalar Ic_3_yz = Iu_4_t_yz - Scalar(0.002188628560919792);
  const Scalar hc_3_x = hu_4_t_x + Scalar(0.373428979936);
  const Scalar t255 = t153 - Scalar(0.014113547439);
  const Scalar t256 = Scalar(-0.316) * (c_3 * t255 - s_3 * hc_3_x);
  const Scalar t257 = c_3 * Ic_3_yz - s_3 * t254 - t256;
  const Scalar t258 = Scalar(2.0) * s_2;
  c[5] = t257 * t258;
  const Scalar t259 = c_3 * hc_3_x + s_3 * t255;
  const Scalar t260 = Scalar(0.316) * t259 + c_3 * t254 + s_3 * Ic_3_yz;
  c[33] = Scalar(-2.0) * t260;
  c[8] = -t253 - t249;
  c[87] = -c_3_7;
  const Scalar t261 = c_4 * t245;
  const Scalar t262 = Scalar(0.165) * hu_4_t_x;
  const Scalar t263 = t250 + t262 - Scalar(0.35069998060812224);
  const Scalar t264 = t237 - t263 - t261;
  const Scalar t265 = t169 + t218 + Scalar(0.000060956210475372);
  const Scalar t266 = Scalar(2.0) * t265;
  const Scalar t267 = c_3 * t264 + s_3 * t266;
  const Scalar t268 = s_3 * t267;
  const Scalar t269 = c_3 * t266 - s_3 * t264;
  const Scalar db_22_3r = t268 - c_3 * t269;
  c[32] = db_22_3r;
  const Scalar t270 = s_3 * (s_2 * t243 + hu_4_t_x * v_o_1_4_y);
  const Scalar t271 = s_3 * (Scalar(0.316) * hc_4_x + t244) - c_3 * t214;
  const Scalar t272 = s_3 * (Scalar(0.316) * hc_4_y + t245) + c_3 * t212;
  const Scalar t273 = t270 + t76 * t242 - t75 * t271 + w_1_4_y * t272;
  const Scalar t274 = c_3 * t218;
  const Scalar t275 = s_3 * t252 + t274;
  const Scalar t276 = c_2 * t275 - s_2 * Iu_4_t_yz;
  const Scalar c_2_7 = t276 - t273;
  c[34] = c_2_7;
  const Scalar t277 = t274 - s_3 * (t251 - c_4 * dmu_3_4_x - s_4 * dmu_3_4_y);
  c[36] = t275 - t277;
  const Scalar c_3_2_4 = t275 + t277;
  c[88] = c_3_2_4;
  c[58] = -db_22_3r;
  const Scalar t278 = s_3 * (c_4 * t271 + s_4 * t272 + Scalar(0.316) * s_3 * hu_4_t_x);
  const Scalar db_22_4r = t278 - c_3 * (t242 + t243);
  c[35] = db_22_4r;
  c[7] = -t276 - t273;
  c[85] = -c_2_7;
  c[63] = -c_3_2_4;
  c[86] = -db_22_4r;
  c[2] = Scalar(2.0) * (c_2 * (t265 - t268 - Scalar(0.005130550910504085)) -
      s_2 * (t257 - Scalar(0.0003844680514732)));
  const Scalar t279 = c_3 * t267;
  const Scalar t280 = c_2 * t260;
  const Scalar t281 = t280 + s_2 * (t279 + s_3 * t269);
  const Scalar t282 = t235 - t262 - t261 - Scalar(0.41230240163465);
  const Scalar t283 = t280 + s_2 * t282;
  c[4] = t283 - t281;
  const Scalar c_2_1_3 = t283 + t281;
  c[57] = c_2_1_3;
  const Scalar t284 = Scalar(0.632) * t246 - t263 - t282 - t279 - Scalar(0.8860432804898606);
  const Scalar t285 = t260 - Scalar(0.00199167944196776);
  const Scalar dmu_1_2_y = Scalar(2.0) * c_2 * t285 - s_2 * t284;
  const Scalar db_11_2r = s_2 * (c_2 * t284 + t285 * t258) - c_2 * dmu_1_2_y;
  c[28] = db_11_2r;
  const Scalar t286 = c_3 * (s_2 * t269 + c_2 * Ic_3_yz);
  const Scalar t287 = t286 - s_3 * (s_2 * t267 + c_2 * t254);
  const Scalar c_1_4 = s_2 * (t287 - c_2 * (t256 - t257));
  c[3] = c_1_4;
  c[31] = -c_2_1_3;
  c[1] = -db_11_2r;
  c[56] = -c_1_4;
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
// Reads q[1..6], qd[0..6]. Operations: 994 mul, 833 add, 12 sin/cos. Always zero: 1 of the 49
// entries of C.
template <class Scalar>
inline void coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar t1 = Scalar(0.000391391281684248) * c_7 + Scalar(0.001210471889260615) * s_7;
  const Scalar dmu_6_7_y = t1 - Scalar(0.00008951535818111907);
  const Scalar t2 = Scalar(0.001210471889260615) * c_7 - Scalar(0.000391391281684248) * s_7;
  const Scalar t3 = t2 - Scalar(0.00011323863633888094);
  const Scalar hu_7_t_y = Scalar(0.0010172199793308985) * c_7 + Scalar(0.0012868026856691014) * s_7;
  const Scalar t4 = Scalar(0.088) * hu_7_t_y;
  const Scalar db_66_7r = t4 - c_7 * dmu_6_7_y - s_7 * t3;
  C[40] = -qd_7 * db_66_7r;
  const Scalar t5 = c_7 * t2;
  const Scalar t6 = t5 - Scalar(0.001210471889260615);
  const Scalar t7 = Scalar(0.0012868026856691014) * c_7 - Scalar(0.0010172199793308985) * s_7;
  const Scalar t8 = Scalar(0.176) * t7;
  const Scalar Ic_6_yy = t8 - Scalar(0.00264028154032624);
  const Scalar t9 = t6 - Ic_6_yy;
  const Scalar Iu_7_t_xz = Scalar(0.0004826525849595559) * c_7 -
      Scalar(0.0006277682991364491) * s_7;
  const Scalar Ic_6_xy = Iu_7_t_xz + Scalar(0.007374285191337658);
  const Scalar t10 = Scalar(2.0) * Ic_6_xy;
  const Scalar t11 = c_6 * t9 - s_6 * t10;
  const Scalar t12 = s_6 * t11;
  const Scalar t13 = c_6 * t10 + s_6 * t9;
  const Scalar t14 = t12 + c_6 * t13;
  const Scalar dmu_5_7_x = Scalar(0.0006277682991364491) * c_6 + s_6 * t1;
  const Scalar dmu_5_7_y = Scalar(0.0004826525849595559) * c_6 + s_6 * t2;
  const Scalar t15 = c_6 * hu_7_t_y;
  const Scalar t16 = Scalar(0.088) * t15;
  const Scalar Iu_7_t_yz = Scalar(0.0006277682991364491) * c_7 +
      Scalar(0.0004826525849595559) * s_7;
  const Scalar db_57_7 = s_6 * Iu_7_t_yz + t16;
  const Scalar db_55_7r = s_6 * (c_7 * dmu_5_7_x + s_7 * dmu_5_7_y) + c_6 * (t16 + db_57_7);
  C[32] = qd_6 * t14 - qd_7 * db_55_7r;
  const Scalar t17 = c_6 * t11;
  const Scalar t18 = t7 + Scalar(0.1159237763475);
  const Scalar hu_6_t_y = Scalar(0.0869023527845) * c_6 - s_6 * t18;
  const Scalar t19 = Scalar(0.384) * hu_6_t_y;
  const Scalar t20 = s_7 * t2 - t4 + Scalar(0.0001438161822327815);
  const Scalar Ic_6_yz = Iu_7_t_yz + Scalar(0.0000467845486573025);
  const Scalar t21 = c_6 * t20 - s_6 * Ic_6_yz;
  const Scalar t22 = c_5 * t21;
  const Scalar t23 = t22 - s_5 * (t17 - t19 - s_6 * t13);
  const Scalar t24 = t5 - t8 - Scalar(0.027504612894594268);
  const Scalar t25 = s_5 * (t24 + t19) - t22;
  const Scalar t26 = t25 - t23;
  const Scalar t27 = c_5 * t24 + s_5 * t21;
  const Scalar t28 = c_4 - Scalar(1.0);
  const Scalar v_o_3_5_z = Scalar(0.384) * s_4 + Scalar(0.0825) * t28;
  const Scalar t29 = c_5 * v_o_3_5_z;
  const Scalar t30 = hu_6_t_y * t29;
  const Scalar t31 = s_4 * t27 + t30;
  const Scalar t32 = s_4 * c_5;
  const Scalar w_3_6_x = c_4 * s_6 + c_6 * t32;
  const Scalar t33 = c_4 * c_6 - s_6 * t32;
  const Scalar t34 = s_4 * s_5;
  const Scalar db_35_6r = t30 - t11 * w_3_6_x - t33 * t13 - t21 * t34;
  const Scalar t35 = t31 - db_35_6r;
  const Scalar t36 = s_2 * c_3;
  const Scalar t37 = c_2 * s_4 - c_4 * t36;
  const Scalar t38 = s_2 * s_3;
  const Scalar t39 = s_5 * t38;
  const Scalar w_1_5_x = c_5 * t37 + t39;
  const Scalar w_1_4_y = c_2 * c_4 + s_4 * t36;
  const Scalar w_1_6_x = c_6 * w_1_5_x + s_6 * w_1_4_y;
  const Scalar t40 = c_6 * w_1_4_y - s_6 * w_1_5_x;
  const Scalar v_o_1_4_y = Scalar(0.0825) * c_2 + Scalar(0.316) * t36;
  const Scalar v_o_1_5_z = v_o_1_4_y - Scalar(0.384) * t37 - Scalar(0.0825) * w_1_4_y;
  const Scalar t41 = Scalar(0.316) * c_4;
  const Scalar t42 = Scalar(0.0825) * s_4 - t41;
  const Scalar t43 = t42 - Scalar(0.384);
  const Scalar t44 = c_5 * v_o_1_5_z + t43 * t39;
  const Scalar t45 = hu_6_t_y * t44;
  const Scalar w_1_5_y = c_5 * t38 - s_5 * t37;
  const Scalar t46 = t21 * w_1_5_y;
  const Scalar db_15_6r = t45 - t46 + t11 * w_1_6_x + t40 * t13;
  const Scalar t47 = t24 * w_1_5_x - t45 - t46;
  const Scalar t48 = t47 + db_15_6r;
  const Scalar t49 = s_3 * c_4;
  const Scalar t50 = c_3 * s_5;
  const Scalar w_2_5_x = t50 + c_5 * t49;
  const Scalar t51 = s_3 * s_4;
  const Scalar t52 = c_6 * w_2_5_x - s_6 * t51;
  const Scalar w_2_6_y = c_6 * t51 + s_6 * w_2_5_x;
  const Scalar t53 = s_3 * (c_4 - Scalar(0.21484375) * s_4 + Scalar(0.8229166666666666));
  const Scalar t54 = Scalar(0.384) * c_5;
  const Scalar v_2_5_y = t53 * t54 - t43 * t50;
  const Scalar t55 = hu_6_t_y * v_2_5_y;
  const Scalar t56 = c_3 * c_5 - s_5 * t49;
  const Scalar t57 = t21 * t56;
  const Scalar db_25_6r = t55 + t57 - t11 * t52 + w_2_6_y * t13;
  const Scalar t58 = t24 * w_2_5_x + t55 - t57;
  const Scalar t59 = t58 - db_25_6r;
  const Scalar t60 = qd_2 * t59 + qd_3 * t35 + qd_1 * t48 - qd_4 * t26 + qd_5 * t14;
  const Scalar t61 = c_6 * Iu_7_t_xz;
  const Scalar db_56_7r = t61 + s_6 * (c_7 * t3 - s_7 * dmu_6_7_y);
  const Scalar t62 = Scalar(0.088) * t7 + Scalar(0.003342075983680473);
  const Scalar t63 = t61 - s_6 * t62;
  const Scalar t64 = t63 - db_56_7r;
  const Scalar t65 = Scalar(2.0) * qd_6;
  C[33] = t60 + t21 * t65 - qd_7 * t64;
  const Scalar t66 = c_5 * t43;
  const Scalar t67 = t38 * t66 - s_5 * v_o_1_5_z;
  const Scalar t68 = Scalar(0.0825) * c_4 + Scalar(0.316) * s_4;
  const Scalar t69 = t68 - Scalar(0.0825);
  const Scalar t70 = t69 * t38;
  const Scalar t71 = c_6 * t70 - s_6 * t67;
  const Scalar v_o_1_7_y = Scalar(0.088) * w_1_5_y + t71;
  const Scalar t72 = c_7 * w_1_6_x - s_7 * w_1_5_y;
  const Scalar w_1_7_y = c_7 * w_1_5_y + s_7 * w_1_6_x;
  const Scalar t73 = Iu_7_t_xz * t40;
  const Scalar t74 = t73 + hu_7_t_y * v_o_1_7_y + t72 * t3 - w_1_7_y * dmu_6_7_y;
  const Scalar t75 = hu_7_t_y * t71 - t73 + w_1_6_x * t62;
  const Scalar t76 = t75 - t74;
  const Scalar t77 = c_3 * t66 + Scalar(0.384) * s_5 * t53;
  const Scalar t78 = c_3 * t69;
  const Scalar t79 = c_6 * t78 - s_6 * t77;
  const Scalar t80 = Scalar(0.088) * t56 + t79;
  const Scalar w_2_7_x = c_7 * t52 - s_7 * t56;
  const Scalar t81 = c_7 * t56 + s_7 * t52;
  const Scalar t82 = Iu_7_t_xz * w_2_6_y;
  const Scalar db_26_7r = t82 - hu_7_t_y * t80 - w_2_7_x * t3 + t81 * dmu_6_7_y;
  const Scalar t83 = hu_7_t_y * t79 + t82 + t52 * t62;
  const Scalar t84 = t83 + db_26_7r;
  const Scalar t85 = Scalar(0.088) * s_4 + s_6 * v_o_3_5_z;
  const Scalar t86 = s_5 * t85;
  const Scalar w_3_7_x = c_7 * w_3_6_x + s_7 * t34;
  const Scalar t87 = c_7 * t34 - s_7 * w_3_6_x;
  const Scalar t88 = Iu_7_t_xz * t33;
  const Scalar t89 = t88 - hu_7_t_y * t86 + w_3_7_x * t3 + t87 * dmu_6_7_y;
  const Scalar t90 = s_5 * s_6;
  const Scalar t91 = hu_7_t_y * v_o_3_5_z * t90 + t88 - w_3_6_x * t62;
  const Scalar t92 = t91 + t89;
  const Scalar t93 = t63 + db_56_7r;
  const Scalar t94 = c_6 * t62 + s_6 * Iu_7_t_xz;
  const Scalar v_4_6_y = Scalar(0.0825) * c_6 - s_6 * t54;
  const Scalar t95 = s_5 * t94 - hu_7_t_y * v_4_6_y;
  const Scalar v_o_4_7_y = Scalar(0.088) * c_5 - v_4_6_y;
  const Scalar t96 = s_5 * c_6;
  const Scalar t97 = c_7 * t96;
  const Scalar t98 = t97 - c_5 * s_7;
  const Scalar t99 = s_7 * t96;
  const Scalar w_4_7_y = t99 + c_5 * c_7;
  const Scalar t100 = hu_7_t_y * v_o_4_7_y + t98 * t3 - w_4_7_y * dmu_6_7_y - Iu_7_t_xz * t90;
  const Scalar t101 = t95 - t100;
  const Scalar C_76 = qd_1 * t76 + qd_2 * t84 - qd_5 * t93 + qd_6 * db_66_7r - qd_3 * t92 -
      qd_4 * t101;
  C[47] = C_76;
  C[39] = qd_7 * t93 - t60;
  const Scalar Iu_6_t_xx = Ic_6_yy + t17;
  const Scalar t102 = t24 + Scalar(0.021040501090947756);
  const Scalar Iu_5_t_d = Iu_6_t_xx + t102;
  const Scalar t103 = t21 + Scalar(0.000757622236663515);
  const Scalar t104 = Scalar(-2.0) * t103;
  const Scalar t105 = c_5 * t104 + s_5 * Iu_5_t_d;
  const Scalar hc_5_y = hu_7_t_y - Scalar(0.0339353157125);
  const Scalar dmu_4_5_y = Scalar(0.0825) * hc_5_y - t105;
  const Scalar t106 = c_5 * Iu_5_t_d - s_5 * t104;
  const Scalar hu_6_t_x = Scalar(0.0869023527845) * s_6 + c_6 * t18;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.007326866269);
  const Scalar dmu_4_5_x = Scalar(0.0825) * hc_5_x + t106;
  const Scalar t107 = c_5 * hc_5_y - s_5 * hc_5_x;
  const Scalar t108 = Scalar(-0.0825) * t107;
  const Scalar t109 = t108 - c_5 * dmu_4_5_y + s_5 * dmu_4_5_x;
  const Scalar t110 = s_5 * (Scalar(0.384) * t18 - t13) + c_5 * Ic_6_yz;
  const Scalar t111 = s_5 * (t11 - Scalar(0.033370503469248)) - c_5 * t20;
  const Scalar t112 = s_5 * hu_6_t_x;
  const Scalar t113 = s_5 * (Scalar(0.384) * t112 + c_6 * t110 - s_6 * t111);
  const Scalar t114 = c_6 * Ic_6_yz + s_6 * t20;
  const Scalar v_4_6_x = Scalar(0.0825) * s_6 + c_6 * t54;
  const Scalar t115 = Scalar(0.0869023527845) * v_4_6_y - t18 * v_4_6_x;
  const Scalar t116 = t115 - s_5 * t114;
  const Scalar t117 = t113 - c_5 * (t115 + t116);
  const Scalar t118 = t7 * v_4_6_x + s_5 * t4 * (s_6 + Scalar(4.363636363636363));
  const Scalar t119 = Scalar(0.0006277682991364491) * t98 +
      Scalar(0.0004826525849595559) * w_4_7_y - t118;
  const Scalar dmu_4_7_x = Scalar(0.0012868026856691014) * v_o_4_7_y -
      Scalar(0.000391391281684248) * t98 - Scalar(0.001210471889260615) * w_4_7_y +
      Scalar(0.0006277682991364491) * t90;
  const Scalar t120 = Scalar(0.0010172199793308985) * v_o_4_7_y +
      Scalar(0.001210471889260615) * t98 - Scalar(0.000391391281684248) * w_4_7_y -
      Scalar(0.0004826525849595559) * t90;
  const Scalar t121 = Scalar(0.0012868026856691014) * t98 - Scalar(0.0010172199793308985) * w_4_7_y;
  const Scalar t122 = t90 * (t118 - t119) - v_o_4_7_y * t121 - t98 * dmu_4_7_x + w_4_7_y * t120;
  C[24] = qd_5 * t109 + qd_6 * t117 - qd_7 * t122;
  const Scalar t123 = c_6 * t67 + s_6 * t70;
  const Scalar t124 = Scalar(0.0869023527845) * t71 - t18 * t123;
  const Scalar t125 = c_5 * t124 - w_1_5_y * t116 - t44 * t112 + w_1_6_x * t110 + t40 * t111;
  const Scalar t126 = Scalar(0.0825) * hu_6_t_y;
  const Scalar t127 = s_5 * t126;
  const Scalar t128 = t114 - t127;
  const Scalar t129 = c_5 * hu_6_t_y;
  const Scalar t130 = hu_6_t_x * t42 - t68 * t129;
  const Scalar t131 = t37 * t128 + w_1_4_y * t25 - t38 * t130;
  const Scalar t132 = t131 - t125;
  const Scalar t133 = c_4 * t128 - s_4 * t25;
  const Scalar db_26_4 = s_3 * t133 - c_3 * t130;
  const Scalar t134 = c_6 * t77 + s_6 * t78;
  const Scalar t135 = Scalar(0.0869023527845) * t79 - t18 * t134;
  const Scalar t136 = c_5 * t135 - t56 * t116 + v_2_5_y * t112 + t52 * t110 - w_2_6_y * t111;
  const Scalar c_4_2_6 = db_26_4 - t136;
  const Scalar t137 = t34 * t116 + w_3_6_x * t110 + t33 * t111;
  const Scalar t138 = c_4 * t25 + s_4 * t128;
  const Scalar t139 = t138 - t137;
  const Scalar t140 = qd_3 * t139 + qd_4 * t117 + qd_1 * t132 + qd_2 * c_4_2_6;
  const Scalar t141 = t25 + t23;
  const Scalar t142 = t95 + t100;
  C[26] = t140 + qd_5 * t141 - t116 * t65 - qd_7 * t142;
  const Scalar t143 = Scalar(2.0) * qd_7;
  C[41] = -C_76 - Iu_7_t_xz * t143;
  const Scalar t144 = c_4 * t129 - s_4 * hu_6_t_x;
  const Scalar t145 = hu_6_t_y * t50 + s_3 * t144;
  const Scalar t146 = t27 - Scalar(0.0825) * (hu_6_t_x * t28 + hu_6_t_y * t32) + hu_6_t_y * t54;
  const Scalar t147 = Scalar(0.316) * t145 + c_3 * t138 + s_3 * t146;
  const Scalar mu_6_3_z = t127 + t133;
  const Scalar t148 = c_2 * t147 - s_2 * mu_6_3_z;
  const Scalar t149 = t135 + t20 * w_2_6_y + Ic_6_yz * t52;
  const Scalar df_2_6_z = Scalar(0.0869023527845) * w_2_6_y + t18 * t52;
  const Scalar t150 = t18 * v_2_5_y + Ic_6_yz * t56 - t9 * w_2_6_y - t10 * t52;
  const Scalar dmu_2_6_y = Scalar(0.0869023527845) * v_2_5_y + t20 * t56 - t9 * t52 + t10 * w_2_6_y;
  const Scalar t151 = t56 * t124 + w_1_5_y * t149 - t44 * df_2_6_z + w_1_6_x * t150 -
      t40 * dmu_2_6_y;
  const Scalar t152 = t148 + t151;
  const Scalar t153 = s_3 * (t138 + Scalar(0.316) * s_5 * hu_6_t_y);
  const Scalar t154 = s_2 * (c_3 * (Scalar(0.316) * t144 + t146) - t153);
  const Scalar t155 = v_o_3_5_z * t112;
  const Scalar t156 = t155 + t20 * t33 - Ic_6_yz * w_3_6_x;
  const Scalar t157 = t18 * t29 - Ic_6_yz * t34 + t9 * t33 - t10 * w_3_6_x;
  const Scalar dmu_3_6_y = Scalar(0.0869023527845) * t29 - t20 * t34 - t9 * w_3_6_x - t10 * t33;
  const Scalar t158 = Scalar(0.0869023527845) * t33 - t18 * w_3_6_x;
  const Scalar t159 = t34 * t124 + w_1_5_y * t156 - t44 * t158 - w_1_6_x * t157 + t40 * dmu_3_6_y;
  const Scalar t160 = t159 - t154;
  const Scalar t161 = t124 - t20 * t40 + Ic_6_yz * w_1_6_x;
  const Scalar t162 = t44 * (Scalar(0.0869023527845) * t40 - t18 * w_1_6_x);
  const Scalar t163 = t18 * t44 - Ic_6_yz * w_1_5_y - t9 * t40 + t10 * w_1_6_x;
  const Scalar t164 = Scalar(0.0869023527845) * t44 - t20 * w_1_5_y + t9 * w_1_6_x + t10 * t40;
  const Scalar t165 = w_1_5_y * (t124 + t161) + t162 - w_1_6_x * t163 + t40 * t164;
  const Scalar t166 = qd_1 * t165;
  const Scalar t167 = t131 + t125;
  const Scalar t168 = t75 + t74;
  const Scalar t169 = t47 - db_15_6r;
  C[5] = t166 + qd_2 * t152 - qd_3 * t160 - qd_4 * t167 - qd_5 * t169 - t161 * t65 + qd_7 * t168;
  const Scalar v_o_2_7_z = v_2_5_y + Scalar(0.088) * w_2_6_y;
  const Scalar t170 = c_7 * t134 - s_7 * v_o_2_7_z;
  const Scalar t171 = Scalar(0.0012868026856691014) * t170 -
      Scalar(0.0010172199793308985) * (c_7 * v_o_2_7_z + s_7 * t134);
  const Scalar t172 = s_6 * t7;
  const Scalar t173 = c_6 * t171 - w_2_6_y * db_57_7 - t80 * t172 + w_2_7_x * dmu_5_7_x +
      t81 * dmu_5_7_y;
  const Scalar t174 = t7 * t77 + Iu_7_t_yz * w_2_5_x + t56 * t63 - v_2_5_y * t15;
  const Scalar t175 = t174 - t173;
  const Scalar t176 = t44 + Scalar(0.088) * t40;
  const Scalar t177 = c_7 * t123 + s_7 * t176;
  const Scalar t178 = Scalar(0.0012868026856691014) * t177 +
      Scalar(0.0010172199793308985) * (c_7 * t176 - s_7 * t123);
  const Scalar t179 = c_6 * t178 + t40 * db_57_7 - v_o_1_7_y * t172 + t72 * dmu_5_7_x +
      w_1_7_y * dmu_5_7_y;
  const Scalar t180 = t7 * t67 + Iu_7_t_yz * w_1_5_x + w_1_5_y * t63 + t44 * t15;
  const Scalar t181 = t180 - t179;
  const Scalar t182 = Scalar(0.088) * t33 - t29;
  const Scalar t183 = v_o_3_5_z * t97 + s_7 * t182;
  const Scalar t184 = Scalar(0.0012868026856691014) * t183 +
      Scalar(0.0010172199793308985) * (c_7 * t182 - v_o_3_5_z * t99);
  const Scalar t185 = c_6 * t184 + t33 * db_57_7 + t7 * t85 * t90 + w_3_7_x * dmu_5_7_x -
      t87 * dmu_5_7_y;
  const Scalar t186 = c_5 * Iu_7_t_yz - s_5 * t63;
  const Scalar t187 = c_5 * t15 - s_5 * t7;
  const Scalar t188 = s_4 * t186 - v_o_3_5_z * t187;
  const Scalar t189 = t188 - t185;
  const Scalar t190 = s_6 * (s_5 * db_57_7 + t7 * v_o_4_7_y);
  const Scalar t191 = t190 + c_6 * t118 - t98 * dmu_5_7_x - w_4_7_y * dmu_5_7_y;
  const Scalar t192 = c_5 * t7 + hu_7_t_y * t96;
  const Scalar t193 = Scalar(0.384) * t192 - c_5 * t63 - s_5 * Iu_7_t_yz;
  const Scalar t194 = t193 - t191;
  const Scalar t195 = qd_2 * t175 + qd_3 * t189 + qd_1 * t181 + qd_4 * t194 - qd_5 * db_55_7r;
  C[34] = t195 - qd_6 * t64 + db_57_7 * t143;
  C[38] = qd_5 * t26 - t140 + qd_7 * t101;
  const Scalar t196 = Scalar(0.0006277682991364491) * t72 +
      Scalar(0.0004826525849595559) * w_1_7_y + t178;
  const Scalar t197 = v_o_1_7_y * (Scalar(0.0012868026856691014) * t72 -
      Scalar(0.0010172199793308985) * w_1_7_y);
  const Scalar t198 = Scalar(0.0006277682991364491) * t40 -
      Scalar(0.0012868026856691014) * v_o_1_7_y + Scalar(0.000391391281684248) * t72 +
      Scalar(0.001210471889260615) * w_1_7_y;
  const Scalar t199 = Scalar(0.0004826525849595559) * t40 +
      Scalar(0.0010172199793308985) * v_o_1_7_y + Scalar(0.001210471889260615) * t72 -
      Scalar(0.000391391281684248) * w_1_7_y;
  const Scalar t200 = t40 * (t178 + t196) - t197 + t72 * t198 + w_1_7_y * t199;
  const Scalar t201 = qd_1 * t200;
  const Scalar db_27_7 = Scalar(0.0006277682991364491) * w_2_7_x +
      Scalar(0.0004826525849595559) * t81 + t171;
  const Scalar dmu_2_7_x = Scalar(0.0006277682991364491) * w_2_6_y +
      Scalar(0.0012868026856691014) * t80 - Scalar(0.000391391281684248) * w_2_7_x -
      Scalar(0.001210471889260615) * t81;
  const Scalar dmu_2_7_y = Scalar(0.0004826525849595559) * w_2_6_y -
      Scalar(0.0010172199793308985) * t80 - Scalar(0.001210471889260615) * w_2_7_x +
      Scalar(0.000391391281684248) * t81;
  const Scalar df_2_7_z = Scalar(0.0012868026856691014) * w_2_7_x -
      Scalar(0.0010172199793308985) * t81;
  const Scalar t202 = w_2_6_y * t178 - t40 * db_27_7 + v_o_1_7_y * df_2_7_z + t72 * dmu_2_7_x +
      w_1_7_y * dmu_2_7_y;
  const Scalar t203 = Scalar(0.0825) * t192;
  const Scalar t204 = t94 - t203;
  const Scalar t205 = c_4 * t193 + s_4 * t204;
  const Scalar t206 = s_6 * hu_7_t_y;
  const Scalar t207 = c_4 * t187 - s_4 * t206;
  const Scalar t208 = c_3 * t192 + s_3 * t207;
  const Scalar t209 = t186 - Scalar(0.384) * t187 + Scalar(0.0825) * (t28 * t206 + s_4 * t187);
  const Scalar t210 = Scalar(0.316) * t208 + c_3 * t205 - s_3 * t209;
  const Scalar t211 = c_4 * t204 - s_4 * t193;
  const Scalar mu_7_3_z = t203 + t211;
  const Scalar t212 = c_2 * t210 - s_2 * mu_7_3_z;
  const Scalar t213 = t212 + t202;
  const Scalar df_3_7_z = Scalar(0.0012868026856691014) * w_3_7_x +
      Scalar(0.0010172199793308985) * t87;
  const Scalar t214 = Scalar(0.0006277682991364491) * t33 + Scalar(0.000391391281684248) * w_3_7_x -
      Scalar(0.001210471889260615) * t87 + Scalar(0.0012868026856691014) * t86;
  const Scalar t215 = Scalar(0.0004826525849595559) * t33 + Scalar(0.001210471889260615) * w_3_7_x +
      Scalar(0.000391391281684248) * t87 - Scalar(0.0010172199793308985) * t86;
  const Scalar db_37_7 = Scalar(0.0006277682991364491) * w_3_7_x -
      Scalar(0.0004826525849595559) * t87 + t184;
  const Scalar t216 = t33 * t178 + t40 * db_37_7 - v_o_1_7_y * df_3_7_z + t72 * t214 +
      w_1_7_y * t215;
  const Scalar t217 = s_3 * t192 - c_3 * t207;
  const Scalar t218 = s_2 * (Scalar(0.316) * t217 + c_3 * t209 + s_3 * t205);
  const Scalar t219 = t216 + t218;
  const Scalar t220 = t178 * t90 - t40 * t119 + v_o_1_7_y * t121 + t72 * dmu_4_7_x - w_1_7_y * t120;
  const Scalar t221 = t42 * t206 - t68 * t187;
  const Scalar t222 = t37 * t204 + w_1_4_y * t193 - t38 * t221;
  const Scalar t223 = t222 + t220;
  C[42] = t201 - qd_2 * t213 + qd_3 * t219 + qd_4 * t223 - qd_5 * t181 + qd_6 * t76;
  const Scalar t224 = t33 * t171 - w_2_6_y * db_37_7 - t80 * df_3_7_z + w_2_7_x * t214 + t81 * t215;
  const Scalar t225 = t210 + t224;
  const Scalar t226 = t33 * (t184 + db_37_7) + df_3_7_z * t86 + w_3_7_x * t214 - t87 * t215;
  const Scalar t227 = qd_1 * t219 + qd_2 * t225 + qd_3 * t226;
  const Scalar t228 = s_5 * (s_6 * t184 - t85 * t121);
  const Scalar t229 = t33 * t119 - w_3_7_x * dmu_4_7_x - t87 * t120 - t228;
  const Scalar t230 = t205 - t229;
  C[44] = t227 + qd_4 * t230 - qd_5 * t189 - qd_6 * t92;
  const Scalar t231 = t171 * t90 + w_2_6_y * t119 + t80 * t121 + w_2_7_x * dmu_4_7_x - t81 * t120;
  const Scalar t232 = s_3 * t211 - c_3 * t221;
  const Scalar t233 = t232 + t231;
  const Scalar t234 = qd_3 * t230 + qd_4 * t122 + qd_1 * t223 + qd_2 * t233;
  C[45] = t234 - qd_5 * t194 - qd_6 * t101;
  const Scalar t235 = t212 - t202;
  const Scalar t236 = t216 - t218;
  const Scalar t237 = t222 - t220;
  const Scalar t238 = t180 + t179;
  const Scalar t239 = t201 + qd_2 * t235 + qd_3 * t236 - qd_4 * t237 + qd_5 * t238 - qd_6 * t168 -
      t196 * t143;
  C[6] = -t239;
  const Scalar t240 = w_2_6_y * (t171 + db_27_7) + t80 * df_2_7_z + w_2_7_x * dmu_2_7_x +
      t81 * dmu_2_7_y;
  const Scalar t241 = qd_1 * t213 + qd_2 * t240;
  const Scalar t242 = t210 - t224;
  const Scalar t243 = t232 - t231;
  const Scalar t244 = t174 + t173;
  const Scalar t245 = t83 - db_26_7r;
  C[13] = t241 + qd_3 * t242 + qd_4 * t243 - qd_5 * t244 + qd_6 * t245 + db_27_7 * t143;
  const Scalar t246 = t205 + t229;
  const Scalar t247 = t188 + t185;
  const Scalar t248 = t91 - t89;
  const Scalar t249 = t227 - qd_4 * t246 + qd_5 * t247 + qd_6 * t248 - db_37_7 * t143;
  C[20] = -t249;
  const Scalar t250 = t193 + t191;
  C[27] = -t234 - qd_5 * t250 - qd_6 * t142 - t119 * t143;
  const Scalar t251 = t148 - t151;
  const Scalar t252 = t159 + t154;
  const Scalar t253 = t166 - qd_2 * t251 - qd_3 * t252 + qd_4 * t132 + qd_5 * t48 + qd_7 * t76;
  C[35] = -t253;
  const Scalar t254 = t56 * (t135 + t149) + v_2_5_y * df_2_6_z + t52 * t150 + w_2_6_y * dmu_2_6_y;
  const Scalar t255 = qd_1 * t251 - qd_2 * t254;
  const Scalar t256 = t34 * t135 + t56 * t156 + v_2_5_y * t158 - t52 * t157 - w_2_6_y * dmu_3_6_y;
  const Scalar t257 = t147 - t256;
  C[36] = t255 - qd_3 * t257 - qd_4 * c_4_2_6 - qd_5 * t59 - qd_7 * t84;
  const Scalar db_33_6r = t34 * (t155 + t156) - t29 * t158 + w_3_6_x * t157 - t33 * dmu_3_6_y;
  const Scalar t258 = qd_1 * t252 - qd_2 * t257 - qd_3 * db_33_6r;
  C[37] = t258 - qd_4 * t139 - qd_5 * t35 + qd_7 * t92;
  C[46] = -t195 - qd_6 * t93;
  const Scalar Ic_5_xz = Ic_6_xy + t12 - Scalar(0.002300122758781553);
  const Scalar hu_5_t_x = c_5 * hc_5_x + s_5 * hc_5_y;
  const Scalar t259 = t114 - Scalar(0.001082026026049065);
  const Scalar db_45_5 = Scalar(0.384) * hu_5_t_x - c_5 * Ic_5_xz - s_5 * t259;
  const Scalar t260 = c_4 * db_45_5;
  const Scalar t261 = t6 - t17 + Scalar(0.02249165715597447);
  const Scalar t262 = Scalar(0.0825) * hu_5_t_x;
  const Scalar t263 = t261 - t262;
  const Scalar t264 = t260 + s_4 * t263;
  const Scalar t265 = c_5 * t259 - s_5 * Ic_5_xz;
  const Scalar t266 = Scalar(0.384) * t107 - t265;
  const Scalar t267 = t266 + s_4 * t108;
  const Scalar t268 = c_3 * hu_5_t_x + t107 * t49;
  const Scalar t269 = Scalar(0.316) * t268 + c_3 * t264 + s_3 * t267;
  const Scalar t270 = c_4 * t263 - s_4 * db_45_5;
  const Scalar mu_5_3_z = t262 + t270;
  const Scalar t271 = c_2 * t269 - s_2 * mu_5_3_z;
  const Scalar t272 = hc_5_x * t78 + t259 * t51 - Iu_5_t_d * t56 + t104 * w_2_5_x;
  const Scalar t273 = hc_5_y * t78 - Ic_5_xz * t51 + Iu_5_t_d * w_2_5_x + t104 * t56;
  const Scalar t274 = hc_5_x * t77 - hc_5_y * v_2_5_y;
  const Scalar t275 = t274 + Ic_5_xz * t56 + t259 * w_2_5_x;
  const Scalar t276 = hc_5_x * t67 + hc_5_y * t44;
  const Scalar df_2_5_z = hc_5_x * w_2_5_x - hc_5_y * t56;
  const Scalar t277 = t51 * t276 - w_1_4_y * t275 + t70 * df_2_5_z + w_1_5_x * t272 -
      w_1_5_y * t273;
  const Scalar t278 = t271 - t277;
  const Scalar t279 = s_3 * (Scalar(0.316) * hu_5_t_x + t264) - c_3 * (t267 + t107 * t41);
  const Scalar t280 = s_2 * t279;
  const Scalar t281 = s_4 * t105 - c_4 * t259;
  const Scalar t282 = s_4 * t106 + c_4 * Ic_5_xz;
  const Scalar t283 = t107 * v_o_3_5_z;
  const Scalar t284 = s_4 * t265 - t283;
  const Scalar t285 = c_4 * t276 + w_1_4_y * t284 - s_4 * hu_5_t_x * t70 - w_1_5_x * t281 +
      w_1_5_y * t282;
  const Scalar t286 = t285 - t280;
  const Scalar t287 = db_45_5 * w_1_4_y;
  const Scalar db_14_5r = t287 - t107 * t70 - w_1_5_x * dmu_4_5_x + w_1_5_y * dmu_4_5_y;
  const Scalar t288 = t107 * t68;
  const Scalar db_15_4 = t38 * t288 + t37 * t263 + t287;
  const Scalar c_1_4_5 = db_15_4 - db_14_5r;
  const Scalar t289 = t276 + Ic_5_xz * w_1_5_y + t259 * w_1_5_x;
  const Scalar t290 = hc_5_x * t70 - t259 * w_1_4_y - Iu_5_t_d * w_1_5_y + t104 * w_1_5_x;
  const Scalar t291 = hc_5_y * t70 + Ic_5_xz * w_1_4_y + Iu_5_t_d * w_1_5_x + t104 * w_1_5_y;
  const Scalar t292 = t70 * (hc_5_x * w_1_5_x - hc_5_y * w_1_5_y);
  const Scalar t293 = w_1_4_y * (t276 + t289) - t292 - w_1_5_x * t290 + w_1_5_y * t291;
  const Scalar t294 = qd_1 * t293;
  const Scalar t295 = Scalar(2.0) * qd_5;
  C[4] = t294 + qd_2 * t278 + qd_3 * t286 - qd_4 * c_1_4_5 + t289 * t295 - qd_6 * t169 -
      qd_7 * t238;
  const Scalar t296 = t147 + t256;
  const Scalar c_2_4_6 = db_26_4 + t136;
  const Scalar t297 = t58 + db_25_6r;
  const Scalar t298 = t255 + qd_3 * t296 + qd_4 * c_2_4_6 + qd_5 * t297 + t149 * t65 - qd_7 * t245;
  C[12] = -t298;
  const Scalar t299 = t138 + t137;
  const Scalar t300 = t31 + db_35_6r;
  const Scalar t301 = t258 + qd_4 * t299 + qd_5 * t300 - t156 * t65 + qd_7 * t248;
  C[19] = -t301;
  const Scalar t302 = t241 - qd_3 * t225 - qd_4 * t233 + qd_5 * t175 - qd_6 * t84;
  C[43] = -t302;
  const Scalar t303 = t285 + t280;
  const Scalar t304 = s_4 * (s_3 * t284 + hu_5_t_x * t78);
  const Scalar db_23_5r = t304 - c_4 * t274 + w_2_5_x * t281 - t56 * t282;
  const Scalar t305 = t269 - db_23_5r;
  const Scalar t306 = s_4 * (c_5 * t281 + s_5 * t282) + c_4 * (t283 - t284);
  const Scalar t307 = qd_1 * t303 + qd_2 * t305 - qd_3 * t306;
  const Scalar t308 = t260 - s_4 * (c_5 * dmu_4_5_x + s_5 * dmu_4_5_y);
  const Scalar t309 = t264 - t308;
  C[18] = t307 - qd_4 * t309 + t284 * t295 - qd_6 * t300 - qd_7 * t247;
  const Scalar t310 = t264 + t308;
  const Scalar c_4_1_5 = db_15_4 + db_14_5r;
  const Scalar t311 = s_3 * t270 + c_3 * t288;
  const Scalar t312 = t107 * t78 + db_45_5 * t51 + w_2_5_x * dmu_4_5_x - t56 * dmu_4_5_y;
  const Scalar t313 = t311 - t312;
  const Scalar t314 = qd_3 * t310 + qd_4 * t109 + qd_1 * c_4_1_5 + qd_2 * t313;
  C[25] = t314 + db_45_5 * t295 + qd_6 * t141 - qd_7 * t250;
  const Scalar t315 = t271 + t277;
  const Scalar t316 = t294 - qd_2 * t315 + qd_3 * t303 + qd_4 * c_4_1_5 - qd_6 * t48 - qd_7 * t181;
  C[28] = -t316;
  const Scalar t317 = t51 * (t274 + t275) + t78 * df_2_5_z + w_2_5_x * t272 - t56 * t273;
  const Scalar t318 = qd_1 * t315 + qd_2 * t317;
  C[29] = t318 - qd_3 * t305 - qd_4 * t313 + qd_6 * t59 + qd_7 * t175;
  const Scalar t319 = t269 + db_23_5r;
  const Scalar t320 = t311 + t312;
  const Scalar t321 = t318 + qd_3 * t319 + qd_4 * t320 - t275 * t295 + qd_6 * t297 + qd_7 * t244;
  C[11] = -t321;
  C[30] = qd_6 * t35 - t307 - qd_4 * t310 + qd_7 * t189;
  C[31] = qd_7 * t194 - t314 - qd_6 * t26;
  const Scalar t322 = c_5 * t106;
  const Scalar t323 = Scalar(0.768) * hu_6_t_y;
  const Scalar t324 = t102 - t322 + t323;
  const Scalar t325 = Scalar(0.165) * hu_5_t_x;
  const Scalar t326 = t261 - t325 - Scalar(0.34490204856053924);
  const Scalar t327 = t324 + t326;
  const Scalar Ic_4_xy = db_45_5 + t126 - Scalar(0.08142043634273043);
  const Scalar t328 = Scalar(2.0) * Ic_4_xy;
  const Scalar t329 = c_4 * t328 + s_4 * t327;
  const Scalar hc_4_y = hu_6_t_y - Scalar(1.0062617768015);
  const Scalar dmu_3_4_y = Scalar(0.0825) * hc_4_y - t329;
  const Scalar t330 = c_4 * t327 - s_4 * t328;
  const Scalar hc_4_x = hu_5_t_x - Scalar(0.276390137325);
  const Scalar dmu_3_4_x = Scalar(0.0825) * hc_4_x + t330;
  const Scalar t331 = c_4 * hc_4_y - s_4 * hc_4_x;
  const Scalar t332 = Scalar(-0.0825) * t331;
  const Scalar t333 = t332 - c_4 * dmu_3_4_y + s_4 * dmu_3_4_x;
  C[16] = qd_6 * db_33_6r - qd_4 * t333 - qd_5 * t306 - qd_7 * t226;
  const Scalar t334 = t103 - s_5 * t106 - t108 + Scalar(0.00195267751313805);
  const Scalar t335 = t266 + Scalar(0.000822243788684635);
  const Scalar Iu_4_t_yz = c_4 * t335 - s_4 * t334;
  const Scalar t336 = hc_4_x * t42 - hc_4_y * t68;
  const Scalar t337 = c_3 * t336;
  const Scalar t338 = s_3 * Iu_4_t_yz + t337;
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * hc_4_y;
  const Scalar t339 = s_3 * (s_2 * t338 + hu_4_t_x * v_o_1_4_y);
  const Scalar t340 = s_3 * (Scalar(0.316) * hc_4_x + t329) - c_3 * t335;
  const Scalar t341 = s_3 * (Scalar(0.316) * hc_4_y + t330) + c_3 * t334;
  const Scalar t342 = t339 + t38 * t337 - t37 * t340 + w_1_4_y * t341;
  const Scalar t343 = c_4 * t334 + s_4 * t335;
  const Scalar t344 = c_3 * t343;
  const Scalar t345 = Iu_6_t_xx - t322 - t323 - t325 + Scalar(0.39592218471735474);
  const Scalar t346 = Scalar(-0.316) * t331;
  const Scalar t347 = t345 + Scalar(0.0825) * hu_4_t_x + t346;
  const Scalar t348 = s_3 * t347 + t344;
  const Scalar t349 = c_2 * t348 - s_2 * Iu_4_t_yz;
  const Scalar t350 = t349 - t342;
  const Scalar t351 = t343 * t38;
  const Scalar t352 = t351 - t331 * v_o_1_4_y + t37 * dmu_3_4_x - w_1_4_y * dmu_3_4_y;
  const Scalar t353 = t36 * t347 - t351;
  const Scalar t354 = t353 - t352;
  const Scalar t355 = t38 * t336;
  const Scalar t356 = t334 * w_1_4_y + t335 * t37 + t355;
  const Scalar dmu_1_4_x = hc_4_x * v_o_1_4_y + t335 * t38 + t327 * w_1_4_y - t328 * t37;
  const Scalar t357 = hc_4_y * v_o_1_4_y - t334 * t38 - t327 * t37 - t328 * w_1_4_y;
  const Scalar t358 = v_o_1_4_y * (hc_4_x * t37 - hc_4_y * w_1_4_y);
  const Scalar t359 = t38 * (t355 + t356) + t358 + t37 * dmu_1_4_x - w_1_4_y * t357;
  const Scalar t360 = qd_1 * t359;
  C[21] = t360 - qd_2 * t350 - qd_3 * t354 + qd_5 * c_4_1_5 + qd_6 * t132 - qd_7 * t223;
  const Scalar t361 = t349 + t342;
  const Scalar t362 = t353 + t352;
  const Scalar t363 = Scalar(2.0) * qd_4;
  const Scalar t364 = t360 + qd_2 * t361 + qd_3 * t362 - t356 * t363 + qd_5 * c_1_4_5 +
      qd_6 * t167 - qd_7 * t237;
  C[3] = -t364;
  const Scalar t365 = s_3 * (c_4 * t340 + s_4 * t341 + Scalar(0.316) * s_3 * hu_4_t_x);
  const Scalar db_22_4r = t365 - c_3 * (t337 + t338);
  const Scalar t366 = c_4 * t330;
  const Scalar t367 = Scalar(0.165) * hu_4_t_x;
  const Scalar t368 = t345 + t367 - Scalar(0.35069998060812224);
  const Scalar t369 = t326 - t368 - t366;
  const Scalar t370 = t108 + t343 + Scalar(0.000060956210475372);
  const Scalar t371 = Scalar(2.0) * t370;
  const Scalar t372 = c_3 * t369 + s_3 * t371;
  const Scalar t373 = s_3 * t372;
  const Scalar t374 = c_3 * t371 - s_3 * t369;
  const Scalar t375 = t373 - c_3 * t374;
  C[8] = qd_3 * t375 + qd_4 * db_22_4r - qd_5 * t317 + qd_6 * t254 + qd_7 * t240;
  const Scalar t376 = t344 - s_3 * (t346 - c_4 * dmu_3_4_x - s_4 * dmu_3_4_y);
  const Scalar t377 = t348 + t376;
  const Scalar t378 = qd_1 * t354 - qd_2 * t377 - qd_3 * t333;
  C[17] = t378 + t343 * t363 - qd_5 * t309 - qd_6 * t299 + qd_7 * t246;
  const Scalar t379 = qd_1 * t350 + qd_2 * db_22_4r;
  const Scalar t380 = t348 - t376;
  C[10] = t379 + qd_3 * t380 + t338 * t363 - qd_5 * t320 - qd_6 * c_2_4_6 + qd_7 * t243;
  C[23] = qd_5 * t310 - t378 + qd_6 * t139 - qd_7 * t230;
  const Scalar t381 = t379 - qd_3 * t377 - qd_5 * t313 - qd_6 * c_4_2_6 + qd_7 * t233;
  C[22] = -t381;
  const Scalar Ic_3_yz = Iu_4_t_yz - Scalar(0.002188628560919792);
  const Scalar t382 = c_3 * (s_2 * t374 + c_2 * Ic_3_yz);
  const Scalar t383 = Ic_4_xy + s_4 * t330 + t332 + Scalar(0.002743824053281128);
  const Scalar t384 = t382 - s_3 * (s_2 * t372 + c_2 * t383);
  const Scalar hc_3_x = hu_4_t_x + Scalar(0.373428979936);
  const Scalar t385 = t107 - Scalar(0.014113547439);
  const Scalar t386 = Scalar(-0.316) * (c_3 * t385 - s_3 * hc_3_x);
  const Scalar t387 = c_3 * Ic_3_yz - s_3 * t383 - t386;
  const Scalar t388 = s_2 * (t384 - c_2 * (t386 - t387));
  const Scalar t389 = qd_1 * t388;
  const Scalar t390 = c_3 * t372;
  const Scalar t391 = c_3 * hc_3_x + s_3 * t385;
  const Scalar t392 = Scalar(0.316) * t391 + c_3 * t383 + s_3 * Ic_3_yz;
  const Scalar t393 = c_2 * t392;
  const Scalar t394 = t393 + s_2 * (t390 + s_3 * t374);
  const Scalar t395 = t324 - t367 - t366 - Scalar(0.41230240163465);
  const Scalar t396 = t393 + s_2 * t395;
  const Scalar t397 = t396 - t394;
  const Scalar t398 = Scalar(2.0) * s_2;
  C[2] = t389 + qd_2 * t397 + qd_3 * t387 * t398 - qd_4 * t362 + qd_5 * t286 - qd_6 * t160 -
      qd_7 * t236;
  const Scalar t399 = Scalar(0.632) * t331 - t368 - t395 - t390 - Scalar(0.8860432804898606);
  const Scalar t400 = t392 - Scalar(0.00199167944196776);
  const Scalar dmu_1_2_y = Scalar(2.0) * c_2 * t400 - s_2 * t399;
  const Scalar t401 = s_2 * (c_2 * t399 + t400 * t398) - c_2 * dmu_1_2_y;
  const Scalar t402 = qd_1 * t401;
  const Scalar t403 = t396 + t394;
  C[7] = t402 - qd_3 * t403 + qd_4 * t350 - qd_5 * t315 - qd_6 * t251 + qd_7 * t213;
  const Scalar t404 = qd_1 * t403 - qd_2 * t375;
  C[15] = t404 - qd_4 * t377 + qd_5 * t305 + qd_6 * t257 - qd_7 * t225;
  const Scalar t405 = qd_2 * t401 - qd_3 * t388 + qd_4 * t359 - qd_5 * t293 - qd_6 * t165 +
      qd_7 * t200;
  C[0] = -t405;
  const Scalar t406 = qd_2 * (c_2 * (t370 - t373 - Scalar(0.005130550910504085)) -
      s_2 * (t387 - Scalar(0.0003844680514732)));
  const Scalar t407 = t402 - Scalar(2.0) * t406 - qd_3 * t397 + qd_4 * t361 - qd_5 * t278 -
      qd_6 * t152 + qd_7 * t235;
  C[1] = -t407;
  const Scalar t408 = t404 + Scalar(2.0) * qd_3 * t392 - qd_4 * t380 + qd_5 * t319 + qd_6 * t296 -
      qd_7 * t242;
  C[9] = -t408;
  const Scalar t409 = t389 - qd_2 * t403 - qd_4 * t354 - qd_5 * t303 + qd_6 * t252 + qd_7 * t219;
  C[14] = -t409;
  C[48] = Scalar(0.0);
}

// gravity torques g(q) (7.39).
//   q[7]  in   joint positions, rad or m
//   g[7]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..6]. Operations: 65 mul, 38 add, 12 sin/cos.
template <class Scalar>
inline void gravity(const Scalar* q, Scalar* g) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar t1 = Scalar(9.81) * s_4;
  const Scalar t2 = Scalar(9.81) * c_4;
  const Scalar t3 = s_2 * c_3;
  const Scalar t4 = c_2 * t1 - t2 * t3;
  const Scalar t5 = s_2 * s_3;
  const Scalar t6 = Scalar(9.81) * t5;
  const Scalar t7 = s_5 * t6 + c_5 * t4;
  const Scalar ddp_4_y = t1 * t3 + c_2 * t2;
  const Scalar t8 = s_6 * t7 - c_6 * ddp_4_y;
  const Scalar t9 = Scalar(-0.002034439958661797) * t8;
  const Scalar t10 = Scalar(-0.002573605371338203) * t8;
  const Scalar t11 = s_6 * ddp_4_y + c_6 * t7;
  const Scalar g_6 = Scalar(0.173804705569) * t11 - Scalar(0.231847552695) * t8 - s_7 * t9 +
      c_7 * t10;
  g[5] = g_6;
  const Scalar t12 = s_5 * t4 - c_5 * t6;
  const Scalar ddp_7_y = s_7 * t11 - c_7 * t12;
  const Scalar t13 = Scalar(0.002034439958661797) * (s_7 * t12 + c_7 * t11) +
      Scalar(0.002573605371338203) * ddp_7_y;
  g[6] = -t13;
  const Scalar t14 = Scalar(0.231847552695) * t12 - t13;
  const Scalar t15 = Scalar(0.173804705569) * t12 + s_7 * t10 + c_7 * t9;
  const Scalar t16 = Scalar(0.067870631425) * t7 - Scalar(0.014653732538) * t12 + s_6 * t15 +
      c_6 * t14;
  g[4] = -t16;
  const Scalar mu_5_x = Scalar(0.067870631425) * ddp_4_y + s_6 * t14 - c_6 * t15;
  const Scalar mu_5_y = Scalar(0.014653732538) * ddp_4_y - g_6;
  const Scalar t17 = Scalar(2.012523553603) * t4 + Scalar(0.55278027465) * ddp_4_y + s_5 * mu_5_x +
      c_5 * mu_5_y;
  g[3] = -t17;
  const Scalar mu_4_x = Scalar(19.74285606084543) * t5 + s_5 * mu_5_y - c_5 * mu_5_x;
  const Scalar mu_4_y = Scalar(5.4227744943165) * t5 + t16;
  const Scalar mu_3_z = Scalar(0.27690780075318) * t3 + Scalar(7.32667658634432) * t5 -
      s_4 * mu_4_x - c_4 * mu_4_y;
  g[2] = mu_3_z;
  const Scalar mu_3_x = Scalar(0.27690780075318) * c_2 + s_4 * mu_4_y - c_4 * mu_4_x;
  const Scalar mu_3_y = Scalar(7.32667658634432) * c_2 - t17;
  g[1] = Scalar(0.01993386669246) * c_2 - Scalar(32.80954542685272) * s_2 + s_3 * mu_3_x -
      c_3 * mu_3_y;
  const Scalar mu_u_3_t_x = s_3 * mu_3_y + c_3 * mu_3_x;
  g[0] = c_2 * mu_3_z - s_2 * mu_u_3_t_x;
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[7]   in   joint positions, rad or m
//   qd[7]  in   joint velocities, rad/s or m/s
//   n[7]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..6], qd[0..6]. Operations: 300 mul, 273 add, 12 sin/cos.
template <class Scalar>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
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
  const Scalar U_2_yy = t9 + t8;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.316) * U_2_yy;
  const Scalar ddp_o_4_z = ddp_o_3_y + Scalar(0.0825) * t7;
  const Scalar t10 = t3 * t1;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 + Scalar(0.316) * t10;
  const Scalar t11 = Scalar(0.632) * t4;
  const Scalar t12 = c_3 * ddp_o_3_x - s_3 * t11;
  const Scalar omega_r_3_y = s_3 * t1 + c_3 * qd_2;
  const Scalar t13 = omega_r_3_y * omega_r_3_y;
  const Scalar t14 = omega_3_z * omega_3_z;
  const Scalar U_3_xx = t14 + t13;
  const Scalar t15 = t12 + Scalar(0.0825) * U_3_xx;
  const Scalar ddp_4_x = s_4 * ddp_o_4_z - c_4 * t15;
  const Scalar t16 = s_4 * t2 - c_4 * omega_3_z;
  const Scalar t17 = t16 * t16;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar t18 = omega_4_z * omega_4_z;
  const Scalar U_4_xx = t18 + t17;
  const Scalar t19 = s_4 * omega_3_z + c_4 * t2;
  const Scalar t20 = t19 * t16;
  const Scalar t21 = t5 + t20;
  const Scalar ddp_o_5_x = ddp_4_x + Scalar(0.0825) * U_4_xx - Scalar(0.384) * t21;
  const Scalar t22 = qd_3 * omega_r_3_y - c_3 * t4;
  const Scalar t23 = qd_2 * t1;
  const Scalar domega_4_y = qd_4 * t19 + s_4 * t22 + c_4 * t23;
  const Scalar t24 = t19 * omega_4_z;
  const Scalar U_4_zx = domega_4_y + t24;
  const Scalar domega_4_x = qd_4 * t16 + s_4 * t23 - c_4 * t22;
  const Scalar t25 = t16 * omega_4_z;
  const Scalar U_4_zy = domega_4_x + t25;
  const Scalar ddp_3_y = s_3 * ddp_o_3_x + c_3 * t11;
  const Scalar t26 = t2 * omega_r_3_y;
  const Scalar t27 = t26 - t23;
  const Scalar ddp_o_4_y = ddp_3_y + Scalar(0.0825) * t27;
  const Scalar ddp_o_5_z = ddp_o_4_y + Scalar(0.0825) * U_4_zx + Scalar(0.384) * U_4_zy;
  const Scalar ddp_5_x = s_5 * ddp_o_5_z + c_5 * ddp_o_5_x;
  const Scalar ddp_4_y = s_4 * t15 + c_4 * ddp_o_4_z;
  const Scalar t28 = t5 - t20;
  const Scalar t29 = t19 * t19;
  const Scalar U_4_yy = t18 + t29;
  const Scalar ddp_o_5_y = ddp_4_y - Scalar(0.0825) * t28 - Scalar(0.384) * U_4_yy;
  const Scalar t30 = s_6 * ddp_5_x - c_6 * ddp_o_5_y;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t19;
  const Scalar omega_5_z = qd_5 - t16;
  const Scalar t31 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar omega_r_6_y = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t32 = t31 * omega_r_6_y;
  const Scalar domega_5_y = qd_5 * omega_r_5_x + s_5 * domega_4_x - c_5 * t5;
  const Scalar U_6_yx = domega_5_y - t32;
  const Scalar t33 = t30 + Scalar(0.088) * U_6_yx;
  const Scalar omega_r_5_y = s_5 * t19 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t34 = s_7 * omega_6_z + c_7 * t31;
  const Scalar domega_5_x = qd_5 * omega_r_5_y + s_5 * t5 + c_5 * domega_4_x;
  const Scalar t35 = qd_6 * omega_r_6_y - s_6 * domega_4_y - c_6 * domega_5_x;
  const Scalar domega_7_y = qd_7 * t34 + s_7 * t35 + c_7 * domega_5_y;
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar t36 = t34 * omega_7_z;
  const Scalar U_7_zx = domega_7_y + t36;
  const Scalar t37 = s_7 * t31 - c_7 * omega_6_z;
  const Scalar domega_7_x = qd_7 * t37 + s_7 * domega_5_y - c_7 * t35;
  const Scalar t38 = t37 * omega_7_z;
  const Scalar U_7_zy = domega_7_x + t38;
  const Scalar t39 = t34 * t34;
  const Scalar t40 = omega_7_z * omega_7_z;
  const Scalar U_7_yy = t40 + t39;
  const Scalar t41 = t37 * t37;
  const Scalar U_7_zz = t41 + t39;
  const Scalar U_7_yy_zz = U_7_yy - U_7_zz;
  const Scalar t42 = t34 * t37;
  const Scalar domega_6_y = qd_6 * t31 - s_6 * domega_5_x + c_6 * domega_4_y;
  const Scalar U_7_yx = domega_6_y - t42;
  const Scalar t43 = Scalar(0.002034439958661797) * t33 - Scalar(0.0009653051699191118) * U_7_yx -
      Scalar(0.000391391281684248) * U_7_zx - Scalar(0.004552547872941088) * U_7_zy +
      Scalar(0.0012555365982728983) * U_7_yy_zz;
  const Scalar U_7_xx = t40 + t41;
  const Scalar U_7_zz_xx = U_7_xx - U_7_zz;
  const Scalar U_7_xy = domega_6_y + t42;
  const Scalar t44 = Scalar(0.002573605371338203) * t33 + Scalar(0.0012555365982728983) * U_7_xy +
      Scalar(0.002131604094419858) * U_7_zx + Scalar(0.000391391281684248) * U_7_zy +
      Scalar(0.0009653051699191118) * U_7_zz_xx;
  const Scalar F_7_z = Scalar(0.002573605371338203) * U_7_zx -
      Scalar(0.002034439958661797) * U_7_zy;
  const Scalar ddp_6_x = s_6 * ddp_o_5_y + c_6 * ddp_5_x;
  const Scalar t45 = t31 * omega_6_z;
  const Scalar U_6_xz = domega_6_y - t45;
  const Scalar t46 = omega_r_6_y * omega_6_z;
  const Scalar t47 = omega_r_6_y * omega_r_6_y;
  const Scalar t48 = omega_6_z * omega_6_z;
  const Scalar U_6_xx = t48 + t47;
  const Scalar t49 = t31 * t31;
  const Scalar U_6_yy = t48 + t49;
  const Scalar U_6_xx_yy = U_6_xx - U_6_yy;
  const Scalar U_6_xy = domega_5_y + t32;
  const Scalar mu_6_z = Scalar(0.173804705569) * ddp_6_x - Scalar(0.231847552695) * t30 -
      Scalar(0.028934422545659894) * U_6_xy - Scalar(0.000093569097314605) * U_6_xz -
      Scalar(0.021522255370587554) * U_6_yx - Scalar(0.000103758917218685) * (t35 - t46) -
      Scalar(0.014748570382675316) * U_6_xx_yy - Scalar(0.088) * F_7_z + s_7 * t43 - c_7 * t44;
  n[5] = mu_6_z;
  const Scalar ddp_o_7_x = ddp_6_x - Scalar(0.088) * U_6_xx;
  const Scalar t50 = s_5 * ddp_o_5_x - c_5 * ddp_o_5_z;
  const Scalar U_6_zx = domega_6_y + t45;
  const Scalar t51 = t50 + Scalar(0.088) * U_6_zx;
  const Scalar ddp_7_x = s_7 * t51 + c_7 * ddp_o_7_x;
  const Scalar ddp_7_y = s_7 * ddp_o_7_x - c_7 * t51;
  const Scalar U_7_xz = domega_7_y - t36;
  const Scalar U_7_yz = domega_7_x - t38;
  const Scalar U_7_xx_yy = U_7_xx - U_7_yy;
  const Scalar N_7_z = Scalar(0.002034439958661797) * ddp_7_x +
      Scalar(0.002573605371338203) * ddp_7_y - Scalar(0.004552547872941088) * U_7_xy -
      Scalar(0.0012555365982728983) * U_7_xz - Scalar(0.002131604094419858) * U_7_yx -
      Scalar(0.0009653051699191118) * U_7_yz + Scalar(0.000391391281684248) * U_7_xx_yy;
  n[6] = -N_7_z;
  const Scalar F_7_x = Scalar(0.002573605371338203) * U_7_xx +
      Scalar(0.002034439958661797) * U_7_xy;
  const Scalar F_7_y = Scalar(0.002573605371338203) * U_7_yx -
      Scalar(0.002034439958661797) * U_7_yy;
  const Scalar t52 = s_7 * F_7_x - c_7 * F_7_y;
  const Scalar t53 = t35 + t46;
  const Scalar U_6_zz = t47 + t49;
  const Scalar U_6_zz_xx = U_6_xx - U_6_zz;
  const Scalar t54 = Scalar(0.231847552695) * t50 + Scalar(0.000093569097314605) * U_6_xy +
      Scalar(0.021522255370587554) * U_6_zx - Scalar(0.014748570382675316) * t53 +
      Scalar(0.000103758917218685) * U_6_zz_xx - N_7_z - Scalar(0.088) * t52;
  const Scalar U_6_yy_zz = U_6_yy - U_6_zz;
  const Scalar t55 = Scalar(0.173804705569) * t50 - Scalar(0.000103758917218685) * U_6_yx +
      Scalar(0.014748570382675316) * U_6_zx - Scalar(0.028934422545659894) * t53 +
      Scalar(0.000093569097314605) * U_6_yy_zz - s_7 * t44 - c_7 * t43;
  const Scalar t56 = omega_r_5_x * omega_5_z;
  const Scalar U_5_xz = domega_5_y - t56;
  const Scalar t57 = omega_r_5_y * omega_5_z;
  const Scalar U_5_yz = domega_5_x - t57;
  const Scalar t58 = omega_r_5_y * omega_r_5_y;
  const Scalar t59 = omega_5_z * omega_5_z;
  const Scalar U_5_xx = t59 + t58;
  const Scalar t60 = omega_r_5_x * omega_r_5_x;
  const Scalar U_5_yy = t59 + t60;
  const Scalar U_5_xx_yy = U_5_xx - U_5_yy;
  const Scalar t61 = omega_r_5_x * omega_r_5_y;
  const Scalar U_5_xy = domega_4_y + t61;
  const Scalar U_5_yx = domega_4_y - t61;
  const Scalar mu_5_z = Scalar(0.067870631425) * ddp_5_x - Scalar(0.014653732538) * t50 +
      Scalar(0.010045187828321245) * U_5_xy - Scalar(0.00216405205209813) * U_5_xz +
      Scalar(0.001451156065026714) * U_5_yx - Scalar(0.004600245517563106) * U_5_yz -
      Scalar(0.00151524447332703) * U_5_xx_yy + s_6 * t55 + c_6 * t54;
  n[4] = -mu_5_z;
  const Scalar U_5_zx = domega_5_y + t56;
  const Scalar U_5_zy = domega_5_x + t57;
  const Scalar U_5_zz = t58 + t60;
  const Scalar U_5_yy_zz = U_5_yy - U_5_zz;
  const Scalar mu_5_x = Scalar(0.067870631425) * ddp_o_5_y + Scalar(0.004600245517563106) * U_5_yx -
      Scalar(0.00151524447332703) * U_5_zx - Scalar(0.010045187828321245) * U_5_zy -
      Scalar(0.00216405205209813) * U_5_yy_zz + s_6 * t54 - c_6 * t55;
  const Scalar f_6_y = Scalar(0.231847552695) * U_6_yx - Scalar(0.173804705569) * U_6_yy + F_7_z;
  const Scalar f_6_x = Scalar(0.231847552695) * U_6_xx + Scalar(0.173804705569) * U_6_xy +
      s_7 * F_7_y + c_7 * F_7_x;
  const Scalar f_5_x = Scalar(0.014653732538) * U_5_xx + Scalar(0.067870631425) * U_5_xy +
      s_6 * f_6_y - c_6 * f_6_x;
  const Scalar f_5_y = Scalar(0.014653732538) * U_5_yx - Scalar(0.067870631425) * U_5_yy -
      Scalar(0.231847552695) * U_6_zx + Scalar(0.173804705569) * t53 + t52;
  const Scalar t62 = s_5 * f_5_y - c_5 * f_5_x;
  const Scalar U_5_zz_xx = U_5_xx - U_5_zz;
  const Scalar mu_5_y = Scalar(0.014653732538) * ddp_o_5_y - Scalar(0.00216405205209813) * U_5_xy +
      Scalar(0.001451156065026714) * U_5_zx + Scalar(0.00151524447332703) * U_5_zy -
      Scalar(0.004600245517563106) * U_5_zz_xx - mu_6_z;
  const Scalar f_5_z = Scalar(0.014653732538) * U_5_zx - Scalar(0.067870631425) * U_5_zy -
      s_6 * f_6_x - c_6 * f_6_y;
  const Scalar U_4_xz = domega_4_y - t24;
  const Scalar U_4_yz = domega_4_x - t25;
  const Scalar U_4_xx_yy = U_4_xx - U_4_yy;
  const Scalar mu_4_z = Scalar(2.012523553603) * ddp_4_x + Scalar(0.55278027465) * ddp_4_y -
      Scalar(0.6972920750309718) * t21 - Scalar(0.00164448757736927) * U_4_xz -
      Scalar(0.0510201361568155) * t28 + Scalar(0.0039053550262761) * U_4_yz +
      Scalar(0.16284087268546085) * U_4_xx_yy + Scalar(0.0825) * f_5_z - Scalar(0.384) * t62 +
      s_5 * mu_5_x + c_5 * mu_5_y;
  n[3] = -mu_4_z;
  const Scalar f_u_5_t_y = s_5 * f_5_x + c_5 * f_5_y;
  const Scalar U_4_zz = t17 + t29;
  const Scalar U_4_yy_zz = U_4_yy - U_4_zz;
  const Scalar mu_4_x = Scalar(2.012523553603) * ddp_o_4_y - Scalar(0.0039053550262761) * t28 +
      Scalar(0.16284087268546085) * U_4_zx + Scalar(0.6972920750309718) * U_4_zy -
      Scalar(0.00164448757736927) * U_4_yy_zz + Scalar(0.384) * f_u_5_t_y + s_5 * mu_5_y -
      c_5 * mu_5_x;
  const Scalar U_4_zz_xx = U_4_xx - U_4_zz;
  const Scalar mu_4_y = Scalar(0.55278027465) * ddp_o_4_y + Scalar(0.00164448757736927) * t21 +
      Scalar(0.0510201361568155) * U_4_zx + Scalar(0.16284087268546085) * U_4_zy -
      Scalar(0.0039053550262761) * U_4_zz_xx + mu_5_z + Scalar(0.0825) * f_u_5_t_y;
  const Scalar f_4_z = Scalar(0.55278027465) * U_4_zx + Scalar(2.012523553603) * U_4_zy + f_u_5_t_y;
  const Scalar t63 = omega_r_3_y * omega_3_z;
  const Scalar t64 = t2 * t2;
  const Scalar U_3_yy = t14 + t64;
  const Scalar U_3_xx_yy = U_3_xx - U_3_yy;
  const Scalar U_3_xy = t26 + t23;
  const Scalar n_3 = Scalar(0.028227094878) * t12 + Scalar(0.746857959872) * ddp_3_y -
      Scalar(0.022178148964878235) * U_3_xy + Scalar(0.004377257121839584) * (t5 - t6) +
      Scalar(0.061602421026527694) * t27 - Scalar(0.005487648106562256) * (t22 - t63) +
      Scalar(0.000121912420950744) * U_3_xx_yy + Scalar(0.0825) * f_4_z - s_4 * mu_4_x -
      c_4 * mu_4_y;
  n[2] = n_3;
  const Scalar t65 = t22 + t63;
  const Scalar U_3_zz = t13 + t64;
  const Scalar U_3_yy_zz = U_3_yy - U_3_zz;
  const Scalar mu_3_x = Scalar(0.028227094878) * ddp_o_3_y - Scalar(0.005487648106562256) * t27 +
      Scalar(0.000121912420950744) * t7 + Scalar(0.022178148964878235) * t65 +
      Scalar(0.004377257121839584) * U_3_yy_zz + s_4 * mu_4_y - c_4 * mu_4_x;
  const Scalar f_4_x = Scalar(0.55278027465) * U_4_xx - Scalar(2.012523553603) * t21 - t62;
  const Scalar t66 = Scalar(0.55278027465) * t28 + Scalar(2.012523553603) * U_4_yy - f_5_z;
  const Scalar f_3_x = Scalar(0.746857959872) * U_3_xx - Scalar(0.028227094878) * U_3_xy -
      s_4 * t66 - c_4 * f_4_x;
  const Scalar t67 = Scalar(0.746857959872) * t27 - Scalar(0.028227094878) * U_3_yy + f_4_z;
  const Scalar f_u_3_t_x = s_3 * t67 + c_3 * f_3_x;
  const Scalar f_u_4_t_y = s_4 * f_4_x - c_4 * t66;
  const Scalar U_3_zz_xx = U_3_xx - U_3_zz;
  const Scalar mu_3_y = Scalar(0.746857959872) * ddp_o_3_y - Scalar(0.004377257121839584) * U_3_xy +
      Scalar(0.061602421026527694) * t7 + Scalar(0.000121912420950744) * t65 +
      Scalar(0.005487648106562256) * U_3_zz_xx - mu_4_z + Scalar(0.0825) * f_u_4_t_y;
  const Scalar t68 = t3 * t3;
  const Scalar U_2_xx = t9 + t68;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  n[1] = Scalar(0.01993386669246) * c_2 - Scalar(32.80954542685272) * s_2 -
      Scalar(1.0090841787369491) * t10 + Scalar(0.00398335888393552) * U_2_xx_yy -
      Scalar(0.316) * f_u_3_t_x + s_3 * mu_3_x - c_3 * mu_3_y;
  const Scalar f_u_3_t_y = s_3 * f_3_x - c_3 * t67;
  const Scalar U_2_zz = t68 + t8;
  const Scalar U_2_yy_zz = U_2_yy - U_2_zz;
  const Scalar t69 = Scalar(0.01026110182100817) * t10 - Scalar(2.064324122463762) * t4 -
      Scalar(0.00796671776787104) * t23 - Scalar(0.0007689361029464) * U_2_yy_zz +
      Scalar(0.316) * f_u_3_t_y + s_3 * mu_3_y + c_3 * mu_3_x;
  const Scalar U_2_zz_xx = U_2_xx - U_2_zz;
  const Scalar t70 = Scalar(0.0007689361029464) * t10 - Scalar(0.00796671776787104) * t4 -
      Scalar(0.04615576498986361) * t23 - Scalar(0.01026110182100817) * U_2_zz_xx + n_3;
  n[0] = c_2 * t70 - s_2 * t69;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[7]    in   joint positions, rad or m
//   qd[7]   in   joint velocities, rad/s or m/s
//   tau[7]  in   joint torques or forces, N m or N
//   qdd[7]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns true, or false if the result means nothing: a pivot was not positive, or an input not a
// number.
// Reads q[1..6], qd[0..6], tau[0..6]. Operations: 610 mul, 538 add, 6 div, 12 sin/cos.
template <class Scalar>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau,
    Scalar* qdd) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  const Scalar tau_1 = tau[0], tau_2 = tau[1], tau_3 = tau[2], tau_4 = tau[3], tau_5 = tau[4],
      tau_6 = tau[5], tau_7 = tau[6];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar t1 = s_2 * qd_1;
  const Scalar t2 = c_3 * t1 - s_3 * qd_2;
  const Scalar t3 = c_2 * qd_1;
  const Scalar t4 = qd_2 * t3;
  const Scalar t5 = qd_3 * t2 + s_3 * t4;
  const Scalar omega_3_z = qd_3 + t3;
  const Scalar t6 = t2 * omega_3_z;
  const Scalar t7 = t5 + t6;
  const Scalar t8 = qd_2 * qd_2;
  const Scalar U_2_yy = t8 + t1 * t1;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.316) * U_2_yy;
  const Scalar ddp_o_4_z = ddp_o_3_y - Scalar(0.0825) * t7;
  const Scalar t9 = Scalar(0.632) * t4;
  const Scalar t10 = t3 * t1;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 + Scalar(0.316) * t10;
  const Scalar t11 = s_3 * t9 - c_3 * ddp_o_3_x;
  const Scalar omega_r_3_y = c_3 * qd_2 + s_3 * t1;
  const Scalar t12 = omega_r_3_y * omega_r_3_y;
  const Scalar t13 = omega_3_z * omega_3_z;
  const Scalar U_3_xx = t12 + t13;
  const Scalar t14 = t11 - Scalar(0.0825) * U_3_xx;
  const Scalar ddp_4_x = c_4 * t14 + s_4 * ddp_o_4_z;
  const Scalar t15 = c_4 * omega_3_z + s_4 * t2;
  const Scalar t16 = t15 * t15;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar t17 = omega_4_z * omega_4_z;
  const Scalar U_4_xx = t16 + t17;
  const Scalar t18 = c_4 * t2 - s_4 * omega_3_z;
  const Scalar t19 = t18 * t15;
  const Scalar t20 = t5 - t19;
  const Scalar ddp_o_5_x = ddp_4_x + Scalar(0.0825) * U_4_xx + Scalar(0.384) * t20;
  const Scalar t21 = qd_3 * omega_r_3_y - c_3 * t4;
  const Scalar t22 = qd_2 * t1;
  const Scalar domega_4_y = c_4 * t22 + s_4 * t21 - qd_4 * t18;
  const Scalar t23 = t18 * omega_4_z;
  const Scalar U_4_zx = domega_4_y - t23;
  const Scalar t24 = c_4 * t21 - s_4 * t22 + qd_4 * t15;
  const Scalar t25 = t15 * omega_4_z;
  const Scalar t26 = t24 + t25;
  const Scalar ddp_3_y = c_3 * t9 + s_3 * ddp_o_3_x;
  const Scalar t27 = t2 * omega_r_3_y;
  const Scalar t28 = t22 + t27;
  const Scalar ddp_o_4_y = ddp_3_y - Scalar(0.0825) * t28;
  const Scalar ddp_o_5_z = ddp_o_4_y + Scalar(0.0825) * U_4_zx - Scalar(0.384) * t26;
  const Scalar ddp_5_x = c_5 * ddp_o_5_x + s_5 * ddp_o_5_z;
  const Scalar ddp_4_y = c_4 * ddp_o_4_z - s_4 * t14;
  const Scalar t29 = t5 + t19;
  const Scalar t30 = t18 * t18;
  const Scalar U_4_yy = t17 + t30;
  const Scalar ddp_o_5_y = ddp_4_y + Scalar(0.0825) * t29 - Scalar(0.384) * U_4_yy;
  const Scalar ddp_6_x = c_6 * ddp_5_x + s_6 * ddp_o_5_y;
  const Scalar omega_r_5_x = c_5 * t18 + s_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 + t15;
  const Scalar omega_r_6_y = c_6 * omega_5_z + s_6 * omega_r_5_x;
  const Scalar t31 = omega_r_6_y * omega_r_6_y;
  const Scalar omega_r_5_y = c_5 * omega_4_z - s_5 * t18;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t32 = omega_6_z * omega_6_z;
  const Scalar U_6_xx = t31 + t32;
  const Scalar ddp_o_7_x = ddp_6_x - Scalar(0.088) * U_6_xx;
  const Scalar t33 = c_5 * ddp_o_5_z - s_5 * ddp_o_5_x;
  const Scalar t34 = c_5 * t24 + s_5 * t5 - qd_5 * omega_r_5_y;
  const Scalar t35 = c_6 * omega_r_5_x - s_6 * omega_5_z;
  const Scalar domega_6_y = c_6 * domega_4_y + s_6 * t34 - qd_6 * t35;
  const Scalar t36 = t35 * omega_6_z;
  const Scalar U_6_zx = domega_6_y - t36;
  const Scalar t37 = t33 - Scalar(0.088) * U_6_zx;
  const Scalar ddp_7_x = c_7 * ddp_o_7_x - s_7 * t37;
  const Scalar ddp_7_y = c_7 * t37 + s_7 * ddp_o_7_x;
  const Scalar t38 = c_6 * t34 - s_6 * domega_4_y + qd_6 * omega_r_6_y;
  const Scalar t39 = c_7 * t35 - s_7 * omega_6_z;
  const Scalar domega_5_y = c_5 * t5 - s_5 * t24 + qd_5 * omega_r_5_x;
  const Scalar domega_7_y = c_7 * domega_5_y + s_7 * t38 - qd_7 * t39;
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar t40 = t39 * omega_7_z;
  const Scalar U_7_xz = domega_7_y + t40;
  const Scalar t41 = c_7 * omega_6_z + s_7 * t35;
  const Scalar t42 = c_7 * t38 - s_7 * domega_5_y + qd_7 * t41;
  const Scalar t43 = t41 * omega_7_z;
  const Scalar t44 = t41 * t41;
  const Scalar t45 = omega_7_z * omega_7_z;
  const Scalar U_7_xx = t44 + t45;
  const Scalar t46 = t39 * t39;
  const Scalar U_7_yy = t45 + t46;
  const Scalar U_7_xx_yy = U_7_xx - U_7_yy;
  const Scalar t47 = t39 * t41;
  const Scalar U_7_xy = domega_6_y + t47;
  const Scalar U_7_yx = domega_6_y - t47;
  const Scalar N_7_z = Scalar(0.002034439958661797) * ddp_7_x +
      Scalar(0.002573605371338203) * ddp_7_y - Scalar(0.004552547872941088) * U_7_xy -
      Scalar(0.0012555365982728983) * U_7_xz - Scalar(0.002131604094419858) * U_7_yx +
      Scalar(0.0009653051699191118) * (t42 - t43) + Scalar(0.000391391281684248) * U_7_xx_yy;
  const Scalar y_7 = tau_7 + N_7_z;
  const Scalar Iu_7_t_yz = Scalar(0.0012555365982728983) * c_7 +
      Scalar(0.0009653051699191118) * s_7;
  const Scalar t48 = Scalar(149.60760989322966) * Iu_7_t_yz;
  const Scalar t49 = c_6 * ddp_o_5_y - s_6 * ddp_5_x;
  const Scalar t50 = t35 * omega_r_6_y;
  const Scalar U_6_yx = domega_5_y + t50;
  const Scalar t51 = t49 - Scalar(0.088) * U_6_yx;
  const Scalar U_7_zx = domega_7_y - t40;
  const Scalar t52 = t42 + t43;
  const Scalar U_7_zz = t44 + t46;
  const Scalar U_7_zz_xx = U_7_xx - U_7_zz;
  const Scalar t53 = Scalar(0.002573605371338203) * t51 - Scalar(0.0012555365982728983) * U_7_xy -
      Scalar(0.002131604094419858) * U_7_zx + Scalar(0.000391391281684248) * t52 -
      Scalar(0.0009653051699191118) * U_7_zz_xx;
  const Scalar U_7_yy_zz = U_7_yy - U_7_zz;
  const Scalar t54 = Scalar(0.002034439958661797) * t51 + Scalar(0.0009653051699191118) * U_7_yx +
      Scalar(0.000391391281684248) * U_7_zx - Scalar(0.004552547872941088) * t52 -
      Scalar(0.0012555365982728983) * U_7_yy_zz;
  const Scalar F_7_z = Scalar(0.002573605371338203) * U_7_zx + Scalar(0.002034439958661797) * t52;
  const Scalar U_6_xz = domega_6_y + t36;
  const Scalar t55 = omega_r_6_y * omega_6_z;
  const Scalar t56 = t35 * t35;
  const Scalar U_6_yy = t32 + t56;
  const Scalar U_6_xx_yy = U_6_xx - U_6_yy;
  const Scalar U_6_xy = domega_5_y - t50;
  const Scalar mu_6_z = Scalar(0.173804705569) * ddp_6_x + Scalar(0.231847552695) * t49 -
      Scalar(0.028934422545659894) * U_6_xy - Scalar(0.000093569097314605) * U_6_xz -
      Scalar(0.021522255370587554) * U_6_yx - Scalar(0.000103758917218685) * (t38 - t55) -
      Scalar(0.014748570382675316) * U_6_xx_yy - Scalar(0.088) * F_7_z + c_7 * t53 - s_7 * t54;
  const Scalar y_7_6 = tau_6 - mu_6_z + y_7 * t48;
  const Scalar Iu_7_t_g = Scalar(0.00242094377852123) * c_7 - Scalar(0.000782782563368496) * s_7;
  const Scalar hu_7_t_y = Scalar(0.002034439958661797) * c_7 + Scalar(0.002573605371338203) * s_7;
  const Scalar Ic_6_xz = Scalar(0.088) * hu_7_t_y - s_7 * Iu_7_t_g - Scalar(0.000287632364465563);
  const Scalar Ic_6_yz = Iu_7_t_yz + Scalar(0.000093569097314605);
  const Scalar t57 = c_6 * Ic_6_yz - s_6 * Ic_6_xz;
  const Scalar hu_7_t_x = Scalar(0.002573605371338203) * c_7 - Scalar(0.002034439958661797) * s_7;
  const Scalar mu_7_6_y = Scalar(0.088) * hu_7_t_x + Scalar(0.006684151967360946);
  const Scalar Iu_7_t_xz = Scalar(0.0009653051699191118) * c_7 -
      Scalar(0.0012555365982728983) * s_7;
  const Scalar mu_u_7_6_t_y = c_6 * mu_7_6_y + s_6 * Iu_7_t_xz;
  const Scalar t58 = t57 - mu_u_7_6_t_y * t48;
  const Scalar t59 = c_7 * Iu_7_t_g;
  const Scalar t60 = Scalar(0.176) * hu_7_t_x;
  const Scalar t61 = t59 - t60 - Scalar(0.055009225789188536);
  const Scalar t62 = t61 + Iu_7_t_yz * t48;
  const Scalar t63 = Scalar(1.0) / t62;
  const Scalar t64 = t58 * t63;
  const Scalar F_7_y = Scalar(0.002573605371338203) * U_7_yx -
      Scalar(0.002034439958661797) * U_7_yy;
  const Scalar F_7_x = Scalar(0.002573605371338203) * U_7_xx +
      Scalar(0.002034439958661797) * U_7_xy;
  const Scalar t65 = c_7 * F_7_y - s_7 * F_7_x;
  const Scalar t66 = t38 + t55;
  const Scalar U_6_zz = t31 + t56;
  const Scalar U_6_zz_xx = U_6_xx - U_6_zz;
  const Scalar t67 = Scalar(0.231847552695) * t33 - Scalar(0.000093569097314605) * U_6_xy -
      Scalar(0.021522255370587554) * U_6_zx + Scalar(0.014748570382675316) * t66 -
      Scalar(0.000103758917218685) * U_6_zz_xx + N_7_z - Scalar(0.088) * t65;
  const Scalar U_6_yy_zz = U_6_yy - U_6_zz;
  const Scalar t68 = Scalar(0.173804705569) * t33 + Scalar(0.000103758917218685) * U_6_yx -
      Scalar(0.014748570382675316) * U_6_zx + Scalar(0.028934422545659894) * t66 -
      Scalar(0.000093569097314605) * U_6_yy_zz - c_7 * t54 - s_7 * t53;
  const Scalar t69 = omega_r_5_x * omega_5_z;
  const Scalar U_5_xz = domega_5_y - t69;
  const Scalar t70 = omega_r_5_y * omega_5_z;
  const Scalar t71 = omega_r_5_y * omega_r_5_y;
  const Scalar t72 = omega_5_z * omega_5_z;
  const Scalar U_5_xx = t71 + t72;
  const Scalar t73 = omega_r_5_x * omega_r_5_x;
  const Scalar U_5_yy = t72 + t73;
  const Scalar U_5_xx_yy = U_5_xx - U_5_yy;
  const Scalar t74 = omega_r_5_x * omega_r_5_y;
  const Scalar U_5_xy = domega_4_y + t74;
  const Scalar U_5_yx = domega_4_y - t74;
  const Scalar mu_5_z = Scalar(0.067870631425) * ddp_5_x + Scalar(0.014653732538) * t33 +
      Scalar(0.010045187828321245) * U_5_xy - Scalar(0.00216405205209813) * U_5_xz +
      Scalar(0.001451156065026714) * U_5_yx + Scalar(0.004600245517563106) * (t34 + t70) -
      Scalar(0.00151524447332703) * U_5_xx_yy - c_6 * t67 - s_6 * t68;
  const Scalar t75 = Scalar(149.60760989322966) * mu_u_7_6_t_y;
  const Scalar y_6_5 = tau_5 + mu_5_z + y_7 * t75 + t64 * y_7_6;
  const Scalar Ic_6_xx = t59 + Scalar(0.03106602664007975);
  const Scalar Ic_6_yy = t60 + Scalar(0.028206407337948502);
  const Scalar Iu_6_t_d = Ic_6_xx - Ic_6_yy;
  const Scalar Ic_6_xy = Iu_7_t_xz + Scalar(0.014748570382675316);
  const Scalar t76 = c_6 * Iu_6_t_d - Scalar(2.0) * s_6 * Ic_6_xy;
  const Scalar Ic_5_xz = Ic_6_xy + s_6 * t76 - Scalar(0.004600245517563106);
  const Scalar t77 = t57 - Scalar(0.00216405205209813);
  const Scalar hc_6_x = hu_7_t_x + Scalar(0.231847552695);
  const Scalar hu_6_t_x = Scalar(0.173804705569) * s_6 + c_6 * hc_6_x;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.014653732538);
  const Scalar hc_5_y = hu_7_t_y - Scalar(0.067870631425);
  const Scalar t78 = c_5 * hc_5_y - s_5 * hc_5_x;
  const Scalar t79 = Scalar(0.384) * t78 - (c_5 * t77 - s_5 * Ic_5_xz);
  const Scalar Iu_6_t_xz = c_6 * Ic_6_xz + s_6 * Ic_6_yz;
  const Scalar hu_6_t_y = Scalar(0.173804705569) * c_6 - s_6 * hc_6_x;
  const Scalar t80 = t61 + Scalar(0.384) * hu_6_t_y;
  const Scalar mu_6_4_z = Scalar(0.0825) * hu_6_t_x - s_5 * Iu_6_t_xz + c_5 * t80;
  const Scalar t81 = c_6 * Iu_7_t_xz - s_6 * mu_7_6_y;
  const Scalar t82 = c_6 * hu_7_t_y;
  const Scalar t83 = c_5 * t82 - s_5 * hu_7_t_x;
  const Scalar t84 = s_6 * hu_7_t_y;
  const Scalar t85 = Scalar(0.384) * t83 + Scalar(0.0825) * t84 - c_5 * Iu_7_t_yz + s_5 * t81;
  const Scalar b_7_6_4 = mu_6_4_z - t85 * t48;
  const Scalar t86 = t79 - t85 * t75 + b_7_6_4 * t64;
  const Scalar t87 = c_6 * t76;
  const Scalar Ic_5_zz = Ic_6_xx - t87 + Scalar(0.011496343893347959);
  const Scalar b_6_5_5 = Ic_5_zz - mu_u_7_6_t_y * t75 + t58 * t64;
  const Scalar d_5 = Scalar(1.0) / b_6_5_5;
  const Scalar t88 = t86 * d_5;
  const Scalar U_5_zx = domega_5_y + t69;
  const Scalar t89 = t34 - t70;
  const Scalar U_5_zz = t71 + t73;
  const Scalar U_5_yy_zz = U_5_yy - U_5_zz;
  const Scalar mu_5_x = Scalar(0.067870631425) * ddp_o_5_y + Scalar(0.004600245517563106) * U_5_yx -
      Scalar(0.00151524447332703) * U_5_zx + Scalar(0.010045187828321245) * t89 -
      Scalar(0.00216405205209813) * U_5_yy_zz + c_6 * t68 - s_6 * t67;
  const Scalar f_6_x = Scalar(0.231847552695) * U_6_xx + Scalar(0.173804705569) * U_6_xy +
      c_7 * F_7_x + s_7 * F_7_y;
  const Scalar f_6_y = Scalar(0.231847552695) * U_6_yx - Scalar(0.173804705569) * U_6_yy + F_7_z;
  const Scalar f_5_x = Scalar(0.014653732538) * U_5_xx + Scalar(0.067870631425) * U_5_xy -
      c_6 * f_6_x + s_6 * f_6_y;
  const Scalar f_5_y = Scalar(0.014653732538) * U_5_yx - Scalar(0.067870631425) * U_5_yy -
      Scalar(0.231847552695) * U_6_zx + Scalar(0.173804705569) * t66 - t65;
  const Scalar t90 = c_5 * f_5_x - s_5 * f_5_y;
  const Scalar U_5_zz_xx = U_5_xx - U_5_zz;
  const Scalar mu_5_y = Scalar(0.014653732538) * ddp_o_5_y - Scalar(0.00216405205209813) * U_5_xy +
      Scalar(0.001451156065026714) * U_5_zx - Scalar(0.00151524447332703) * t89 -
      Scalar(0.004600245517563106) * U_5_zz_xx - mu_6_z;
  const Scalar f_5_z = Scalar(0.014653732538) * U_5_zx + Scalar(0.067870631425) * t89 -
      c_6 * f_6_y - s_6 * f_6_x;
  const Scalar U_4_xz = domega_4_y + t23;
  const Scalar U_4_xx_yy = U_4_xx - U_4_yy;
  const Scalar mu_4_z = Scalar(2.012523553603) * ddp_4_x + Scalar(0.55278027465) * ddp_4_y +
      Scalar(0.6972920750309718) * t20 - Scalar(0.00164448757736927) * U_4_xz +
      Scalar(0.0510201361568155) * t29 - Scalar(0.0039053550262761) * (t24 - t25) +
      Scalar(0.16284087268546085) * U_4_xx_yy + Scalar(0.0825) * f_5_z + Scalar(0.384) * t90 +
      c_5 * mu_5_y + s_5 * mu_5_x;
  const Scalar t91 = b_7_6_4 * t63;
  const Scalar t92 = Scalar(-149.60760989322966) * t85;
  const Scalar y_5_4 = tau_4 + mu_4_z + y_7 * t92 - t91 * y_7_6 + t88 * y_6_5;
  const Scalar Ic_5_xx = Ic_6_yy + t87 + Scalar(0.010045187828321245);
  const Scalar t93 = t61 - Scalar(0.001451156065026714);
  const Scalar Iu_5_t_d = Ic_5_xx + t93;
  const Scalar Ic_5_xy = Iu_6_t_xz - Scalar(0.00151524447332703);
  const Scalar t94 = c_5 * Iu_5_t_d - Scalar(2.0) * s_5 * Ic_5_xy;
  const Scalar t95 = Scalar(-0.0825) * t78;
  const Scalar t96 = Ic_5_xy + s_5 * t94 + t95 - Scalar(0.0039053550262761);
  const Scalar t97 = t79 + Scalar(0.00164448757736927);
  const Scalar Iu_4_t_yz = c_4 * t97 + s_4 * t96;
  const Scalar hu_5_t_x = c_5 * hc_5_x + s_5 * hc_5_y;
  const Scalar mu_5_4_x = Scalar(0.384) * hu_5_t_x - (c_5 * Ic_5_xz + s_5 * t77);
  const Scalar t98 = Scalar(0.0825) * hu_5_t_x;
  const Scalar mu_5_4_y = Ic_5_zz - t98;
  const Scalar mu_5_3_z = t98 + c_4 * mu_5_4_y - s_4 * mu_5_4_x;
  const Scalar t99 = s_5 * hu_6_t_y;
  const Scalar t100 = Scalar(0.0825) * t99;
  const Scalar t101 = t57 - t100;
  const Scalar t102 = c_5 * Iu_6_t_xz + s_5 * t80;
  const Scalar mu_6_3_z = t100 + c_4 * t101 - s_4 * t102;
  const Scalar f_u_7_5_t_y = c_5 * hu_7_t_x + s_5 * t82;
  const Scalar t103 = Scalar(0.0825) * f_u_7_5_t_y;
  const Scalar mu_7_4_y = mu_u_7_6_t_y - t103;
  const Scalar mu_7_4_x = Scalar(0.384) * f_u_7_5_t_y - c_5 * t81 - s_5 * Iu_7_t_yz;
  const Scalar mu_7_3_z = t103 + c_4 * mu_7_4_y - s_4 * mu_7_4_x;
  const Scalar b_7_6_3 = mu_6_3_z - mu_7_3_z * t48;
  const Scalar b_6_5_3 = mu_5_3_z - mu_7_3_z * t75 + b_7_6_3 * t64;
  const Scalar b_5_4_3 = Iu_4_t_yz + mu_7_3_z * t92 + b_7_6_3 * t91 - b_6_5_3 * t88;
  const Scalar t104 = c_5 * t94;
  const Scalar t105 = Scalar(0.165) * hu_5_t_x;
  const Scalar t106 = Scalar(0.768) * hu_6_t_y;
  const Scalar t107 = Ic_5_xx - t104 - t106 - t105 + Scalar(0.7483122111877872);
  const Scalar t108 = t107 + t85 * t92 + b_7_6_4 * t91 - t86 * t88;
  const Scalar t109 = Scalar(1.0) / t108;
  const Scalar t110 = b_5_4_3 * t109;
  const Scalar f_u_5_t_y = c_5 * f_5_y + s_5 * f_5_x;
  const Scalar U_4_zz = t16 + t30;
  const Scalar U_4_yy_zz = U_4_yy - U_4_zz;
  const Scalar mu_4_x = Scalar(2.012523553603) * ddp_o_4_y + Scalar(0.0039053550262761) * t29 +
      Scalar(0.16284087268546085) * U_4_zx - Scalar(0.6972920750309718) * t26 -
      Scalar(0.00164448757736927) * U_4_yy_zz + Scalar(0.384) * f_u_5_t_y - c_5 * mu_5_x +
      s_5 * mu_5_y;
  const Scalar U_4_zz_xx = U_4_xx - U_4_zz;
  const Scalar mu_4_y = Scalar(0.55278027465) * ddp_o_4_y - Scalar(0.00164448757736927) * t20 +
      Scalar(0.0510201361568155) * U_4_zx - Scalar(0.16284087268546085) * t26 -
      Scalar(0.0039053550262761) * U_4_zz_xx + mu_5_z + Scalar(0.0825) * f_u_5_t_y;
  const Scalar f_4_z = Scalar(0.55278027465) * U_4_zx - Scalar(2.012523553603) * t26 + f_u_5_t_y;
  const Scalar t111 = omega_r_3_y * omega_3_z;
  const Scalar t112 = t2 * t2;
  const Scalar U_3_yy = t13 + t112;
  const Scalar U_3_xx_yy = U_3_xx - U_3_yy;
  const Scalar U_3_xy = t22 - t27;
  const Scalar t113 = Scalar(0.028227094878) * t11 - Scalar(0.746857959872) * ddp_3_y +
      Scalar(0.022178148964878235) * U_3_xy + Scalar(0.004377257121839584) * (t5 - t6) +
      Scalar(0.061602421026527694) * t28 + Scalar(0.005487648106562256) * (t21 - t111) -
      Scalar(0.000121912420950744) * U_3_xx_yy - Scalar(0.0825) * f_4_z + c_4 * mu_4_y +
      s_4 * mu_4_x;
  const Scalar t114 = b_6_5_3 * d_5;
  const Scalar t115 = b_7_6_3 * t63;
  const Scalar t116 = Scalar(149.60760989322966) * mu_7_3_z;
  const Scalar y_4_3 = tau_3 + t113 + y_7 * t116 + t115 * y_7_6 - t114 * y_6_5 + t110 * y_5_4;
  const Scalar Ic_4_xx = t93 - t104 + t106 - Scalar(0.6972920750309718);
  const Scalar Ic_4_yy = Ic_5_zz - t105 + Scalar(0.0510201361568155);
  const Scalar Iu_4_t_d = Ic_4_xx + Ic_4_yy;
  const Scalar Ic_4_xy = Scalar(0.0825) * hu_6_t_y + mu_5_4_x - Scalar(0.16284087268546085);
  const Scalar t117 = c_4 * Iu_4_t_d - Scalar(2.0) * s_4 * Ic_4_xy;
  const Scalar hc_4_x = hu_5_t_x - Scalar(0.55278027465);
  const Scalar hc_4_y = hu_6_t_y - Scalar(2.012523553603);
  const Scalar t118 = c_4 * hc_4_y - s_4 * hc_4_x;
  const Scalar t119 = Ic_4_xy - Scalar(0.0825) * t118 + s_4 * t117 + Scalar(0.005487648106562256);
  const Scalar Ic_3_yz = Iu_4_t_yz - Scalar(0.004377257121839584);
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * hc_4_y;
  const Scalar hc_3_x = hu_4_t_x + Scalar(0.746857959872);
  const Scalar t120 = t78 - Scalar(0.028227094878);
  const Scalar t121 = c_3 * t120 - s_3 * hc_3_x;
  const Scalar t122 = Scalar(0.316) * t121 + (c_3 * Ic_3_yz - s_3 * t119);
  const Scalar t123 = c_4 * t96 - s_4 * t97;
  const Scalar mu_u_5_4_t_x = c_4 * mu_5_4_x + s_4 * mu_5_4_y;
  const Scalar t124 = t79 + s_4 * t95;
  const Scalar mu_u_7_4_t_x = c_4 * mu_7_4_x + s_4 * mu_7_4_y;
  const Scalar t125 = c_4 * t83 - s_4 * t84;
  const Scalar t126 = c_3 * t125 - s_3 * f_u_7_5_t_y;
  const Scalar t127 = t85 - Scalar(0.0825) * (c_4 * t84 + s_4 * t83);
  const Scalar t128 = Scalar(0.316) * t126 + c_3 * t127 - s_3 * mu_u_7_4_t_x;
  const Scalar t129 = c_4 * t102 + s_4 * t101;
  const Scalar t130 = c_5 * hu_6_t_y;
  const Scalar t131 = c_4 * t130 - s_4 * hu_6_t_x;
  const Scalar t132 = c_3 * t131 - s_3 * t99;
  const Scalar f_u_6_4_t_y = c_4 * hu_6_t_x + s_4 * t130;
  const Scalar mu_6_3_y = mu_6_4_z - Scalar(0.0825) * f_u_6_4_t_y;
  const Scalar t133 = Scalar(0.316) * t132 + c_3 * mu_6_3_y - s_3 * t129 - t128 * t48;
  const Scalar t134 = c_4 * t78;
  const Scalar t135 = c_3 * t134 - s_3 * hu_5_t_x;
  const Scalar t136 = Scalar(0.316) * t135 + c_3 * t124 - s_3 * mu_u_5_4_t_x - t128 * t75 +
      t133 * t64;
  const Scalar t137 = Scalar(0.316) * t118 - (t107 + Scalar(0.0825) * hu_4_t_x);
  const Scalar t138 = s_3 * t123 + t128 * t92 + t133 * t91 - t136 * t88 - c_3 * t137;
  const Scalar t139 = t122 - t128 * t116 + t133 * t115 - t136 * t114 - t138 * t110;
  const Scalar t140 = c_4 * t117;
  const Scalar t141 = Scalar(0.165) * hu_4_t_x;
  const Scalar t142 = Ic_4_xx - t140 - t141 - Scalar(0.08378056999140593);
  const Scalar t143 = t142 + mu_7_3_z * t116 - b_7_6_3 * t115 + b_6_5_3 * t114 + b_5_4_3 * t110;
  const Scalar t144 = Scalar(1.0) / t143;
  const Scalar t145 = t139 * t144;
  const Scalar t146 = t21 + t111;
  const Scalar U_3_zz = t12 + t112;
  const Scalar U_3_yy_zz = U_3_yy - U_3_zz;
  const Scalar mu_3_x = Scalar(0.028227094878) * ddp_o_3_y + Scalar(0.005487648106562256) * t28 -
      Scalar(0.000121912420950744) * t7 + Scalar(0.022178148964878235) * t146 +
      Scalar(0.004377257121839584) * U_3_yy_zz - c_4 * mu_4_x + s_4 * mu_4_y;
  const Scalar t147 = t138 * t109;
  const Scalar f_4_x = Scalar(0.55278027465) * U_4_xx + Scalar(2.012523553603) * t20 + t90;
  const Scalar t148 = Scalar(0.55278027465) * t29 - Scalar(2.012523553603) * U_4_yy + f_5_z;
  const Scalar f_3_x = Scalar(0.746857959872) * U_3_xx - Scalar(0.028227094878) * U_3_xy -
      c_4 * f_4_x + s_4 * t148;
  const Scalar t149 = Scalar(0.746857959872) * t28 + Scalar(0.028227094878) * U_3_yy - f_4_z;
  const Scalar f_u_3_t_x = c_3 * f_3_x - s_3 * t149;
  const Scalar f_u_4_t_y = c_4 * t148 + s_4 * f_4_x;
  const Scalar U_3_zz_xx = U_3_xx - U_3_zz;
  const Scalar mu_3_y = Scalar(0.746857959872) * ddp_o_3_y - Scalar(0.004377257121839584) * U_3_xy -
      Scalar(0.061602421026527694) * t7 + Scalar(0.000121912420950744) * t146 +
      Scalar(0.005487648106562256) * U_3_zz_xx - mu_4_z + Scalar(0.0825) * f_u_4_t_y;
  const Scalar t150 = t136 * d_5;
  const Scalar t151 = t133 * t63;
  const Scalar t152 = Scalar(-149.60760989322966) * t128;
  const Scalar U_2_xx = t3 * t3 + t8;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  const Scalar t153 = Scalar(0.01993386669246) * c_2 - Scalar(32.80954542685272) * s_2 - tau_2 -
      Scalar(1.0090841787369491) * t10 + Scalar(0.00398335888393552) * U_2_xx_yy -
      Scalar(0.316) * f_u_3_t_x - c_3 * mu_3_y + s_3 * mu_3_x + y_7 * t152 - t151 * y_7_6 +
      t150 * y_6_5 - t147 * y_5_4 - t145 * y_4_3;
  const Scalar Ic_3_xx = Ic_4_yy - t140 + Scalar(0.022178148964878235);
  const Scalar t154 = t107 + t141 + Scalar(0.061602421026527694);
  const Scalar Iu_3_t_d = Ic_3_xx - t154;
  const Scalar t155 = t95 - t123 + Scalar(0.000121912420950744);
  const Scalar t156 = c_3 * Iu_3_t_d + Scalar(2.0) * s_3 * t155;
  const Scalar t157 = c_3 * t156;
  const Scalar t158 = Scalar(-0.632) * t118;
  const Scalar t159 = Ic_3_xx - t157 + t158 + t128 * t152 + t133 * t151 - t136 * t150 -
      t138 * t147 + t139 * t145 + Scalar(1.0552399437268125);
  const Scalar t160 = Scalar(1.0) / t159;
  const Scalar t161 = s_2 * (t155 - s_3 * t156 - Scalar(0.01026110182100817));
  const Scalar t162 = c_3 * hc_3_x + s_3 * t120;
  const Scalar t163 = Scalar(0.316) * t162 + (c_3 * t119 + s_3 * Ic_3_yz);
  const Scalar t164 = s_2 * (c_3 * t123 + s_3 * t137);
  const Scalar t165 = c_3 * hu_5_t_x + s_3 * t134;
  const Scalar t166 = s_2 * (Scalar(0.316) * t165 + c_3 * mu_u_5_4_t_x + s_3 * t124);
  const Scalar t167 = c_3 * f_u_7_5_t_y + s_3 * t125;
  const Scalar t168 = s_2 * (Scalar(0.316) * t167 + c_3 * mu_u_7_4_t_x + s_3 * t127);
  const Scalar t169 = c_2 * mu_7_3_z + t168;
  const Scalar t170 = c_3 * t99 + s_3 * t131;
  const Scalar t171 = s_2 * (Scalar(0.316) * t170 + c_3 * t129 + s_3 * mu_6_3_y);
  const Scalar b_7_6_1 = c_2 * mu_6_3_z + t171 - t169 * t48;
  const Scalar t172 = c_2 * mu_5_3_z + t166 - t169 * t75 + b_7_6_1 * t64;
  const Scalar b_5_4_1 = c_2 * Iu_4_t_yz - t164 + t169 * t92 + b_7_6_1 * t91 - t172 * t88;
  const Scalar t173 = c_2 * t142 - s_2 * t163 + t169 * t116 - b_7_6_1 * t115 + t172 * t114 +
      b_5_4_1 * t110;
  const Scalar t174 = c_2 * (t122 - Scalar(0.0007689361029464)) + t161 + t169 * t152 +
      b_7_6_1 * t151 - t172 * t150 - b_5_4_1 * t147 - t173 * t145;
  const Scalar t175 = t174 * t160;
  const Scalar f_u_3_t_y = c_3 * t149 + s_3 * f_3_x;
  const Scalar t176 = qd_1 * qd_1;
  const Scalar U_2_yy_zz = U_2_yy - t176;
  const Scalar t177 = Scalar(0.01026110182100817) * t10 - Scalar(2.064324122463762) * t4 -
      Scalar(0.00796671776787104) * t22 - Scalar(0.0007689361029464) * U_2_yy_zz +
      Scalar(0.316) * f_u_3_t_y + c_3 * mu_3_x + s_3 * mu_3_y;
  const Scalar t178 = t173 * t144;
  const Scalar U_2_zz_xx = U_2_xx - t176;
  const Scalar t179 = Scalar(0.0007689361029464) * t10 - Scalar(0.00796671776787104) * t4 -
      Scalar(0.04615576498986361) * t22 - Scalar(0.01026110182100817) * U_2_zz_xx - t113;
  const Scalar t180 = b_5_4_1 * t109;
  const Scalar t181 = t172 * d_5;
  const Scalar t182 = b_7_6_1 * t63;
  const Scalar t183 = Scalar(-149.60760989322966) * t169;
  const Scalar y_2_1 = tau_1 - c_2 * t179 + s_2 * t177 - y_7 * t183 + t182 * y_7_6 - t181 * y_6_5 +
      t180 * y_5_4 - t178 * y_4_3 + t175 * t153;
  const Scalar t184 = t154 + t157 + t158 + Scalar(1.032162061231881);
  const Scalar t185 = c_2 * (t142 + t184 - Scalar(0.023077882494931805)) -
      Scalar(2.0) * s_2 * (t163 - Scalar(0.00398335888393552));
  const Scalar t186 = t184 - c_2 * t185 + t169 * t183 + b_7_6_1 * t182 - t172 * t181 -
      b_5_4_1 * t180 + t173 * t178 - t174 * t175 + Scalar(0.014259565994474374);
  const Scalar qdd_1 = (Scalar(1.0) / t186) * y_2_1;
  qdd[0] = qdd_1;
  const Scalar t187 = t160 * (t153 + t174 * qdd_1);
  qdd[1] = -t187;
  const Scalar t188 = t144 * ((y_4_3 + t139 * t187) + t173 * qdd_1);
  qdd[2] = -t188;
  const Scalar t189 = t109 * ((t138 * t187 - b_5_4_1 * qdd_1) - (y_5_4 - b_5_4_3 * t188));
  qdd[3] = -t189;
  const Scalar t190 = (y_6_5 - t86 * t189) - t172 * qdd_1;
  const Scalar qdd_5 = d_5 * (t190 + (b_6_5_3 * t188 + t136 * t187));
  qdd[4] = qdd_5;
  const Scalar t191 = (b_7_6_4 * t189 - b_7_6_3 * t188) - (y_7_6 - t58 * qdd_5);
  const Scalar qdd_6 = t63 * (t191 - (t133 * t187 - b_7_6_1 * qdd_1));
  qdd[5] = qdd_6;
  const Scalar t192 = (mu_7_3_z * t188 + t128 * t187) - (mu_u_7_6_t_y * qdd_5 + t85 * t189);
  qdd[6] = Scalar(149.60760989322966) * ((y_7 + Iu_7_t_yz * qdd_6) + t169 * qdd_1) -
      Scalar(149.60760989322966) * t192;
  bool positive = t186 > Scalar(0.0);
  positive &= t159 > Scalar(0.0);
  positive &= -t143 > Scalar(0.0);
  positive &= t108 > Scalar(0.0);
  positive &= b_6_5_5 > Scalar(0.0);
  positive &= -t62 > Scalar(0.0);
  return positive;
}

// kinetic energy of links and rotors (7.31).
//   q[7]   in  joint positions, rad or m
//   qd[7]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1..6], qd[0..6]. Operations: 133 mul, 94 add, 12 sin/cos.
template <class Scalar>
inline Scalar kinetic_energy(const Scalar* q, const Scalar* qd) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar t1 = s_2 * qd_1;
  const Scalar omega_r_3_y = s_3 * t1 + c_3 * qd_2;
  const Scalar t2 = Scalar(0.0825) * omega_r_3_y;
  const Scalar t3 = Scalar(0.316) * omega_r_3_y;
  const Scalar t4 = s_4 * t2 - c_4 * t3;
  const Scalar omega_4_z = omega_r_3_y - qd_4;
  const Scalar t5 = t4 - Scalar(0.384) * omega_4_z;
  const Scalar t6 = s_3 * qd_2 - c_3 * t1;
  const Scalar t7 = c_2 * qd_1;
  const Scalar omega_3_z = t7 + qd_3;
  const Scalar t8 = s_4 * omega_3_z + c_4 * t6;
  const Scalar t9 = s_4 * t6 - c_4 * omega_3_z;
  const Scalar t10 = Scalar(0.316) * t6 - Scalar(0.0825) * omega_3_z;
  const Scalar t11 = t10 + Scalar(0.384) * t8 - Scalar(0.0825) * t9;
  const Scalar t12 = s_5 * t11 + c_5 * t5;
  const Scalar v_r_4_y = s_4 * t3 + c_4 * t2;
  const Scalar v_o_5_y = v_r_4_y - Scalar(0.0825) * omega_4_z;
  const Scalar t13 = s_6 * v_o_5_y + c_6 * t12;
  const Scalar t14 = s_5 * t5 - c_5 * t11;
  const Scalar t15 = s_5 * omega_4_z + c_5 * t8;
  const Scalar t16 = t9 - qd_5;
  const Scalar t17 = s_6 * t15 + c_6 * t16;
  const Scalar t18 = t14 - Scalar(0.088) * t17;
  const Scalar t19 = s_7 * t18 + c_7 * t13;
  const Scalar t20 = s_7 * t13 - c_7 * t18;
  const Scalar omega_r_6_x = s_6 * t16 - c_6 * t15;
  const Scalar t21 = s_5 * t8 - c_5 * omega_4_z;
  const Scalar t22 = t21 + qd_6;
  const Scalar t23 = s_7 * t22 - c_7 * omega_r_6_x;
  const Scalar t24 = s_7 * omega_r_6_x + c_7 * t22;
  const Scalar t25 = t17 + qd_7;
  const Scalar t26 = Scalar(0.0009653051699191118) * t23 + Scalar(0.0012555365982728983) * t24 -
      Scalar(0.004068879917323594) * t19 - Scalar(0.005147210742676406) * t20 -
      Scalar(0.006684151967360946) * t25;
  const Scalar t27 = s_6 * t12 - c_6 * v_o_5_y;
  const Scalar t28 = t27 + Scalar(0.088) * t22;
  const Scalar t29 = t24 * (Scalar(0.005147210742676406) * t28 +
      Scalar(0.000391391281684248) * t23 - Scalar(0.0012555365982728983) * t25);
  const Scalar t30 = Scalar(0.004068879917323594) * t28 - Scalar(0.00242094377852123) * t23 -
      Scalar(0.000391391281684248) * t24 + Scalar(0.0009653051699191118) * t25;
  const Scalar L_6_z = Scalar(0.000103758917218685) * omega_r_6_x -
      Scalar(0.000093569097314605) * t17 - Scalar(0.347609411138) * t13 +
      Scalar(0.46369510539) * t27 + Scalar(0.05258828201066731) * t22;
  const Scalar t31 = t17 * (Scalar(0.46369510539) * t14 -
      Scalar(0.014748570382675316) * omega_r_6_x + Scalar(0.000093569097314605) * t22);
  const Scalar t32 = Scalar(0.347609411138) * t14 - Scalar(0.009543771269492195) * omega_r_6_x -
      Scalar(0.014748570382675316) * t17 - Scalar(0.000103758917218685) * t22;
  const Scalar t33 = Scalar(0.004600245517563106) * t15 + Scalar(0.00216405205209813) * t21 -
      Scalar(0.13574126285) * t12 + Scalar(0.029307465076) * t14 +
      Scalar(0.033018599263935515) * t16;
  const Scalar L_5_y = Scalar(0.029307465076) * v_o_5_y + Scalar(0.00151524447332703) * t15 +
      Scalar(0.00216405205209813) * t16;
  const Scalar L_5_x = Scalar(0.13574126285) * v_o_5_y - Scalar(0.030116287133882085) * t15 -
      Scalar(0.00151524447332703) * t21 - Scalar(0.004600245517563106) * t16;
  const Scalar t34 = Scalar(0.0039053550262761) * t8 + Scalar(0.00164448757736927) * t9 +
      Scalar(4.025047107206) * t4 + Scalar(1.1055605493) * v_r_4_y -
      Scalar(0.749763367252814) * omega_4_z;
  const Scalar t35 = t9 * (Scalar(1.1055605493) * t10 + Scalar(0.16284087268546085) * t8 +
      Scalar(0.00164448757736927) * omega_4_z);
  const Scalar t36 = Scalar(4.025047107206) * t10 + Scalar(0.647723094939183) * t8 -
      Scalar(0.16284087268546085) * t9 - Scalar(0.0039053550262761) * omega_4_z;
  const Scalar L_2_y = Scalar(0.0007689361029464) * qd_2 + Scalar(0.00398335888393552) * t1;
  const Scalar L_2_x = Scalar(0.01026110182100817) * qd_2 + Scalar(0.00398335888393552) * t7 -
      Scalar(1.0706865997634767) * t1;
  const Scalar t37 = qd_1 * (Scalar(0.03733744848940618) * qd_1 - (c_2 * L_2_y + s_2 * L_2_x));
  const Scalar t38 = omega_3_z * (Scalar(0.47750187874566624) * t6 +
      Scalar(0.022216781084735585) * omega_r_3_y - Scalar(0.13480070614822143) * omega_3_z);
  const Scalar t39 = omega_r_3_y *
      (Scalar(0.000121912420950744) * t6 + Scalar(0.004377257121839584) * omega_3_z);
  const Scalar t40 = t6 * (Scalar(0.01159586409516604) * t6 -
      Scalar(0.000121912420950744) * omega_r_3_y - Scalar(0.005487648106562256) * omega_3_z);
  const Scalar L_2_z = Scalar(1.1168423647533403) * qd_2 - Scalar(0.0007689361029464) * t7 -
      Scalar(0.01026110182100817) * t1;
  const Scalar t41 = t25 * t26 - t29 + t23 * t30 - t22 * L_6_z + t31 + omega_r_6_x * t32 -
      t16 * t33 - t21 * L_5_y + t15 * L_5_x + omega_4_z * t34 + t35 - t8 * t36 + t38 + t39 - t40 -
      qd_2 * L_2_z - t37;
  return Scalar(-0.5) * t41;
}

// potential energy of links and rotors (7.36).
//   q[7]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[1..6]. Operations: 21 mul, 20 add, 12 sin/cos.
template <class Scalar>
inline Scalar potential_energy(const Scalar* q) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar hu_7_t_x = Scalar(0.002573605371338203) * c_7 - Scalar(0.002034439958661797) * s_7;
  const Scalar hc_6_x = hu_7_t_x + Scalar(0.231847552695);
  const Scalar hu_6_t_x = Scalar(0.173804705569) * s_6 + c_6 * hc_6_x;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.014653732538);
  const Scalar hu_7_t_y = Scalar(0.002034439958661797) * c_7 + Scalar(0.002573605371338203) * s_7;
  const Scalar hc_5_y = hu_7_t_y - Scalar(0.067870631425);
  const Scalar hu_5_t_x = c_5 * hc_5_x + s_5 * hc_5_y;
  const Scalar hc_4_x = hu_5_t_x - Scalar(0.55278027465);
  const Scalar hu_6_t_y = Scalar(0.173804705569) * c_6 - s_6 * hc_6_x;
  const Scalar hc_4_y = hu_6_t_y - Scalar(2.012523553603);
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * hc_4_y;
  const Scalar hc_3_x = hu_4_t_x + Scalar(0.746857959872);
  const Scalar hu_5_t_y = c_5 * hc_5_y - s_5 * hc_5_x;
  const Scalar hc_3_y = hu_5_t_y - Scalar(0.028227094878);
  const Scalar hu_3_t_x = c_3 * hc_3_x + s_3 * hc_3_y;
  const Scalar hc_2_x = hu_3_t_x - Scalar(0.002031994566);
  const Scalar hu_4_t_y = c_4 * hc_4_y - s_4 * hc_4_x;
  const Scalar hc_2_y = hu_4_t_y - Scalar(3.344500043512);
  const Scalar hu_2_t_y = c_2 * hc_2_y + s_2 * hc_2_x;
  const Scalar hc_0_z = hu_2_t_y - Scalar(5.396538059926);
  return Scalar(-9.81) * hc_0_z;
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    1, 1, 1,
    1, 1, 1,
    1, 1, 1};

// pose of the tip (2.50).
//   q[7]  in   joint positions, rad or m
//   R[9]  out  rotation matrix of the frame in the base frame
//              3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]  out  position of the frame's origin in the base frame, m
// Reads q[0..6]. Operations: 86 mul, 45 add, 14 sin/cos.
template <class Scalar>
inline void forward_kinematics(const Scalar* q, Scalar* R, Scalar* p) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6];
  const Scalar s_1 = sin(q_1), c_1 = cos(q_1);
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar t1 = c_4 * s_6;
  const Scalar a_4_t_x = s_4 * c_6 + c_5 * t1;
  const Scalar t2 = s_3 * s_5;
  const Scalar t3 = s_6 * t2 - c_3 * a_4_t_x;
  const Scalar t4 = s_4 * s_6;
  const Scalar t5 = c_5 * t4 - c_4 * c_6;
  R[8] = s_2 * t3 + c_2 * t5;
  const Scalar n_7_t_y = Scalar(0.7071067811865476) * c_7 - Scalar(0.7071067811865476) * s_7;
  const Scalar t6 = s_5 * n_7_t_y;
  const Scalar n_7_t_x = Scalar(0.7071067811865476) * c_7 + Scalar(0.7071067811865476) * s_7;
  const Scalar t7 = c_5 * c_6;
  const Scalar t8 = t6 - n_7_t_x * t7;
  const Scalar t9 = n_7_t_x * t4 + c_4 * t8;
  const Scalar t10 = s_5 * n_7_t_x;
  const Scalar n_5_t_y = c_6 * t10 + c_5 * n_7_t_y;
  const Scalar t11 = s_3 * n_5_t_y + c_3 * t9;
  const Scalar t12 = s_4 * t8 - n_7_t_x * t1;
  R[6] = s_2 * t11 - c_2 * t12;
  const Scalar s_5_t_x = t10 + n_7_t_y * t7;
  const Scalar t13 = n_7_t_y * t4 - c_4 * s_5_t_x;
  const Scalar t14 = c_6 * t6 - c_5 * n_7_t_x;
  const Scalar t15 = s_3 * t14 + c_3 * t13;
  const Scalar s_4_t_y = s_4 * s_5_t_x + n_7_t_y * t1;
  R[7] = s_2 * t15 + c_2 * s_4_t_y;
  const Scalar a_2_t_x = s_2 * t5 - c_2 * t3;
  const Scalar t16 = c_3 * s_5;
  const Scalar a_3_t_y = s_3 * a_4_t_x + s_6 * t16;
  R[5] = s_1 * a_2_t_x + c_1 * a_3_t_y;
  const Scalar p_6u_t_x = Scalar(0.088) * c_6 + Scalar(0.2104) * s_6;
  const Scalar p_5_x = c_5 * p_6u_t_x - Scalar(0.0825);
  const Scalar p_5_y = Scalar(0.2104) * c_6 - Scalar(0.088) * s_6 - Scalar(0.384);
  const Scalar p_4_x = s_4 * p_5_y + c_4 * p_5_x + Scalar(0.0825);
  const Scalar t17 = t2 * p_6u_t_x - c_3 * p_4_x;
  const Scalar t18 = s_4 * p_5_x - c_4 * p_5_y + Scalar(0.316);
  p[2] = s_2 * t17 + c_2 * t18 + Scalar(0.333);
  R[2] = c_1 * a_2_t_x - s_1 * a_3_t_y;
  const Scalar t19 = s_2 * t12 + c_2 * t11;
  const Scalar t20 = s_3 * t9 - c_3 * n_5_t_y;
  R[0] = s_1 * t20 - c_1 * t19;
  const Scalar s_2_t_x = s_2 * s_4_t_y - c_2 * t15;
  const Scalar s_3_t_y = s_3 * t13 - c_3 * t14;
  R[1] = s_1 * s_3_t_y + c_1 * s_2_t_x;
  R[4] = s_1 * s_2_t_x - c_1 * s_3_t_y;
  const Scalar p_2u_t_x = s_2 * t18 - c_2 * t17;
  const Scalar p_3u_t_y = s_3 * p_4_x + t16 * p_6u_t_x;
  p[1] = s_1 * p_2u_t_x + c_1 * p_3u_t_y;
  R[3] = -s_1 * t19 - c_1 * t20;
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

// geometric Jacobian of the tip (7.14), (7.15).
//   q[7]   in   joint positions, rad or m
//   J[42]  out  geometric Jacobian in base axes: linear rows, then angular
//               6 x 7, row by row: entry (i, j) is J[7 * i + j]
// Reads q[0..5]. Operations: 121 mul, 67 add, 12 sin/cos. Always zero: 4 of the 42 entries of J.
template <class Scalar>
inline void jacobian(const Scalar* q, Scalar* J) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5];
  const Scalar s_1 = sin(q_1), c_1 = cos(q_1);
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  J[29] = c_1;
  J[37] = c_2;
  J[22] = -s_1;
  const Scalar R_20_y = c_1 * s_2;
  J[23] = R_20_y;
  const Scalar R_21_y = s_1 * s_2;
  J[30] = R_21_y;
  const Scalar t1 = s_2 * s_3;
  J[38] = -t1;
  const Scalar t2 = c_1 * c_2;
  const Scalar t3 = s_1 * c_3;
  const Scalar R_30_y = t3 + s_3 * t2;
  J[24] = R_30_y;
  const Scalar t4 = s_2 * c_3;
  const Scalar R_42_y = c_2 * c_4 + s_4 * t4;
  J[39] = R_42_y;
  const Scalar t5 = s_1 * s_3;
  const Scalar t6 = c_1 * c_3 - c_2 * t5;
  J[31] = -t6;
  const Scalar t7 = t5 - c_3 * t2;
  const Scalar R_40_y = c_4 * R_20_y + s_4 * t7;
  J[25] = R_40_y;
  const Scalar R_31_x = c_1 * s_3 + c_2 * t3;
  const Scalar R_41_y = c_4 * R_21_y - s_4 * R_31_x;
  J[32] = R_41_y;
  const Scalar t8 = c_2 * s_4 - c_4 * t4;
  const Scalar R_52_y = c_5 * t1 - s_5 * t8;
  J[40] = -R_52_y;
  const Scalar t9 = c_4 * t7 - s_4 * R_20_y;
  const Scalar R_50_y = c_5 * R_30_y - s_5 * t9;
  J[26] = R_50_y;
  const Scalar R_41_x = c_4 * R_31_x + s_4 * R_21_y;
  const Scalar t10 = c_5 * t6 - s_5 * R_41_x;
  J[33] = -t10;
  const Scalar R_52_x = c_5 * t8 + s_5 * t1;
  const Scalar t11 = c_6 * R_42_y - s_6 * R_52_x;
  J[41] = -t11;
  const Scalar R_50_x = c_5 * t9 + s_5 * R_30_y;
  const Scalar R_60_y = c_6 * R_40_y + s_6 * R_50_x;
  J[27] = -R_60_y;
  const Scalar t12 = c_5 * R_41_x + s_5 * t6;
  const Scalar R_61_y = c_6 * R_41_y - s_6 * t12;
  J[34] = -R_61_y;
  const Scalar p_6u_t_x = Scalar(0.088) * c_6 + Scalar(0.2104) * s_6;
  const Scalar p_5_x = c_5 * p_6u_t_x - Scalar(0.0825);
  const Scalar p_5_y = Scalar(0.2104) * c_6 - Scalar(0.088) * s_6 - Scalar(0.384);
  const Scalar p_4_x = c_4 * p_5_x + s_4 * p_5_y + Scalar(0.0825);
  const Scalar t13 = s_5 * p_6u_t_x;
  const Scalar t14 = c_3 * p_4_x - s_3 * t13;
  const Scalar t15 = c_4 * p_5_y - s_4 * p_5_x - Scalar(0.316);
  const Scalar p_2u_t_x = c_2 * t14 - s_2 * t15;
  const Scalar p_3u_t_y = c_3 * t13 + s_3 * p_4_x;
  const Scalar p_1u_t_x = c_1 * p_2u_t_x - s_1 * p_3u_t_y;
  J[7] = p_1u_t_x;
  const Scalar t16 = c_2 * t15 + s_2 * t14;
  J[1] = -c_1 * t16;
  J[8] = -s_1 * t16;
  const Scalar p_1u_t_y = c_1 * p_3u_t_y + s_1 * p_2u_t_x;
  J[0] = -p_1u_t_y;
  J[15] = -c_1 * p_1u_t_x - s_1 * p_1u_t_y;
  const Scalar t17 = p_1u_t_x - Scalar(0.316) * R_20_y;
  const Scalar t18 = Scalar(0.316) * c_2 + t16;
  J[9] = c_2 * t17 + R_20_y * t18;
  const Scalar r_3_y = p_1u_t_y - Scalar(0.316) * R_21_y;
  J[2] = -c_2 * r_3_y - R_21_y * t18;
  J[16] = s_2 * (c_1 * r_3_y - s_1 * t17);
  const Scalar r_4_y = r_3_y - Scalar(0.0825) * R_31_x;
  const Scalar t19 = t18 - Scalar(0.0825) * t4;
  J[3] = t6 * t19 + t1 * r_4_y;
  const Scalar t20 = t17 + Scalar(0.0825) * t7;
  J[10] = R_30_y * t19 - t1 * t20;
  J[17] = R_30_y * r_4_y + t6 * t20;
  const Scalar t21 = t20 - Scalar(0.0825) * t9 - Scalar(0.384) * R_40_y;
  const Scalar t22 = t19 - Scalar(0.0825) * t8 + Scalar(0.384) * R_42_y;
  J[11] = R_40_y * t22 + R_42_y * t21;
  const Scalar r_5_y = r_4_y + Scalar(0.0825) * R_41_x - Scalar(0.384) * R_41_y;
  J[18] = R_40_y * r_5_y - R_41_y * t21;
  J[5] = r_5_y * R_52_y + t22 * t10;
  J[19] = t21 * t10 + r_5_y * R_50_y;
  J[4] = -R_41_y * t22 - R_42_y * r_5_y;
  J[12] = t22 * R_50_y - t21 * R_52_y;
  const Scalar r_7_y = r_5_y - Scalar(0.088) * (c_6 * t12 + s_6 * R_41_y);
  const Scalar R_62_x = c_6 * R_52_x + s_6 * R_42_y;
  const Scalar t23 = t22 + Scalar(0.088) * R_62_x;
  J[6] = R_61_y * t23 + t11 * r_7_y;
  const Scalar R_60_x = c_6 * R_50_x - s_6 * R_40_y;
  const Scalar t24 = t21 + Scalar(0.088) * R_60_x;
  J[13] = -R_60_y * t23 - t11 * t24;
  J[20] = R_61_y * t24 - R_60_y * r_7_y;
  J[35] = Scalar(1.0);
  J[14] = J[21] = J[28] = J[36] = Scalar(0.0);
}

// (dJ/dt) qd of the tip.
//   q[7]   in   joint positions, rad or m
//   qd[7]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads q[0..6], qd[0..6]. Operations: 164 mul, 102 add, 14 sin/cos.
template <class Scalar>
inline void jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4], q_6 = q[5], q_7 = q[6];
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  const Scalar s_1 = sin(q_1), c_1 = cos(q_1);
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar s_6 = sin(q_6), c_6 = cos(q_6);
  const Scalar s_7 = sin(q_7), c_7 = cos(q_7);
  const Scalar t1 = s_2 * qd_1;
  const Scalar t2 = c_3 * t1;
  const Scalar t3 = s_3 * qd_2;
  const Scalar t4 = t3 - t2;
  const Scalar t5 = c_2 * qd_1;
  const Scalar omega_3_z = qd_3 + t5;
  const Scalar t6 = s_4 * omega_3_z + c_4 * t4;
  const Scalar t7 = s_3 * t1;
  const Scalar t8 = c_3 * qd_2;
  const Scalar omega_r_3_y = t7 + t8;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t6;
  const Scalar t9 = s_4 * t4 - c_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 - t9;
  const Scalar t10 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar omega_r_5_y = s_5 * t6 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t11 = s_7 * omega_6_z + c_7 * t10;
  const Scalar omega_r_6_y = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t12 = qd_3 * omega_r_3_y - t8 * t5;
  const Scalar t13 = qd_2 * t1;
  const Scalar domega_4_x = qd_4 * t9 + s_4 * t13 - c_4 * t12;
  const Scalar t14 = qd_3 * t4 - t3 * t5;
  const Scalar domega_5_x = qd_5 * omega_r_5_y + s_5 * t14 + c_5 * domega_4_x;
  const Scalar domega_4_y = qd_4 * t6 + s_4 * t12 + c_4 * t13;
  const Scalar t15 = qd_6 * omega_r_6_y - s_6 * domega_4_y - c_6 * domega_5_x;
  const Scalar domega_5_y = qd_5 * omega_r_5_x + s_5 * domega_4_x - c_5 * t14;
  const Scalar domega_7_y = qd_7 * t11 + s_7 * t15 + c_7 * domega_5_y;
  const Scalar t16 = s_7 * t10 - c_7 * omega_6_z;
  const Scalar domega_7_x = qd_7 * t16 + s_7 * domega_5_y - c_7 * t15;
  const Scalar t17 = s_7 * domega_7_y - c_7 * domega_7_x;
  const Scalar domega_6_y = qd_6 * t10 - s_6 * domega_5_x + c_6 * domega_4_y;
  const Scalar t18 = s_6 * domega_6_y + c_6 * t17;
  const Scalar domega_e_7_t_y = s_7 * domega_7_x + c_7 * domega_7_y;
  const Scalar domega_e_5_t_x = s_5 * domega_e_7_t_y - c_5 * t18;
  const Scalar t19 = s_6 * t17 - c_6 * domega_6_y;
  const Scalar domega_e_4_t_x = s_4 * t19 + c_4 * domega_e_5_t_x;
  const Scalar domega_e_5_t_y = s_5 * t18 + c_5 * domega_e_7_t_y;
  const Scalar domega_e_3_t_x = s_3 * domega_e_5_t_y + c_3 * domega_e_4_t_x;
  const Scalar domega_e_4_t_y = s_4 * domega_e_5_t_x - c_4 * t19;
  a[5] = s_2 * domega_e_3_t_x - c_2 * domega_e_4_t_y;
  const Scalar domega_e_2_t_x = s_2 * domega_e_4_t_y + c_2 * domega_e_3_t_x;
  const Scalar t20 = s_3 * domega_e_4_t_x - c_3 * domega_e_5_t_y;
  a[3] = s_1 * t20 - c_1 * domega_e_2_t_x;
  const Scalar U_4_zx = domega_4_y + t6 * omega_4_z;
  const Scalar t21 = (t4 * omega_r_3_y - t13) + U_4_zx;
  const Scalar U_4_zy = domega_4_x + t9 * omega_4_z;
  const Scalar t22 = t5 * (t7 + Scalar(2.0) * t8);
  const Scalar ddp_o_5_z = Scalar(0.384) * U_4_zy + Scalar(0.0825) * t21 + Scalar(0.316) * t22;
  const Scalar U_2_yy = qd_2 * qd_2 + t1 * t1;
  const Scalar ddp_o_4_z = Scalar(0.316) * U_2_yy - Scalar(0.0825) * (t14 + t4 * omega_3_z);
  const Scalar t23 = omega_4_z * omega_4_z;
  const Scalar U_4_xx = t23 + t9 * t9;
  const Scalar t24 = t6 * t9;
  const Scalar U_3_xx = omega_3_z * omega_3_z + omega_r_3_y * omega_r_3_y;
  const Scalar t25 = Scalar(0.0825) * U_3_xx - Scalar(0.632) * t5 * (t3 - Scalar(0.5) * t2);
  const Scalar ddp_o_5_x = Scalar(0.0825) * U_4_xx - Scalar(0.384) * (t14 + t24) - s_4 * ddp_o_4_z -
      c_4 * t25;
  const Scalar ddp_5_x = s_5 * ddp_o_5_z + c_5 * ddp_o_5_x;
  const Scalar U_6_xx = omega_6_z * omega_6_z + omega_r_6_y * omega_r_6_y;
  const Scalar U_4_yy = t23 + t6 * t6;
  const Scalar t26 = Scalar(0.0825) * (t14 - t24) + Scalar(0.384) * U_4_yy - s_4 * t25 +
      c_4 * ddp_o_4_z;
  const Scalar t27 = Scalar(0.088) * U_6_xx + s_6 * t26 - c_6 * ddp_5_x;
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar U_7_yz = domega_7_x - t16 * omega_7_z;
  const Scalar U_6_zx = domega_6_y + t10 * omega_6_z;
  const Scalar t28 = Scalar(0.088) * U_6_zx + s_5 * ddp_o_5_x - c_5 * ddp_o_5_z;
  const Scalar t29 = Scalar(0.2104) * U_7_yz + s_7 * t27 + c_7 * t28;
  const Scalar U_7_xz = domega_7_y - t11 * omega_7_z;
  const Scalar t30 = Scalar(0.2104) * U_7_xz - s_7 * t28 + c_7 * t27;
  const Scalar t31 = s_7 * t29 + c_7 * t30;
  const Scalar U_7_zz = t16 * t16 + t11 * t11;
  const Scalar U_6_yx = domega_5_y - t10 * omega_r_6_y;
  const Scalar ddp_e_z = Scalar(0.088) * U_6_yx - Scalar(0.2104) * U_7_zz + s_6 * ddp_5_x +
      c_6 * t26;
  const Scalar t32 = s_6 * ddp_e_z - c_6 * t31;
  const Scalar t33 = s_7 * t30 - c_7 * t29;
  const Scalar t34 = s_5 * t33 - c_5 * t32;
  const Scalar a_6_t_y = s_6 * t31 + c_6 * ddp_e_z;
  const Scalar t35 = s_4 * a_6_t_y - c_4 * t34;
  const Scalar t36 = s_5 * t32 + c_5 * t33;
  const Scalar t37 = s_3 * t36 - c_3 * t35;
  const Scalar a_4_t_y = s_4 * t34 + c_4 * a_6_t_y;
  a[2] = s_2 * t37 - c_2 * a_4_t_y;
  a[4] = -s_1 * domega_e_2_t_x - c_1 * t20;
  const Scalar t38 = s_2 * a_4_t_y + c_2 * t37;
  const Scalar t39 = s_3 * t35 + c_3 * t36;
  a[0] = -s_1 * t39 - c_1 * t38;
  a[1] = c_1 * t39 - s_1 * t38;
}

}  // namespace panda

#endif  // FLATDYN_PANDA_HPP

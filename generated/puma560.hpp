// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "puma560" as flat code: 6 joints.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Input: sha1:21594d7bc752bb8f34e288d8d5bb448830f0cffd
//
//   index  joint       moves link  type      unit  lower                upper
//   0      waist       link1       revolute  rad   -2.792526803190927   2.792526803190927
//   1      shoulder    link2       revolute  rad   -3.9269908169872414  0.7853981633974483
//   2      elbow       link3       revolute  rad   -0.7853981633974483  3.9269908169872414
//   3      wrist_roll  link4       revolute  rad   -1.9198621771937625  2.9670597283903604
//   4      wrist_bend  link5       revolute  rad   -1.7453292519943295  1.7453292519943295
//   5      flange      link6       revolute  rad   -4.642575810304916   4.642575810304916
//
// Gravity is (0, 0, -9.81) m/s^2 in the base frame. The tip belongs to link "link6".
//
// Every function is a template over its scalar: float, double, or any type that has + - * / and
// sin, cos where argument-dependent lookup finds them. Arguments are plain arrays:
//
//   double q[6] = {}, qd[6] = {}, qdd[6] = {}, tau[6];
//   puma560::inverse_dynamics(q, qd, qdd, tau);
//
// Entries come in the order of the table. Units are SI; "rad or m" goes by the type of the joint.
// Every entry of an output is written, zeros too. All inputs are read before anything is written:
// an output may overlap an input, but outputs must not overlap each other. Nothing allocates,
// throws, or keeps state. In the code, names count from 1 as in the textbook: q_1 is q[0], s_1 its
// sine, c_1 its cosine, s_12 the sine of q_1 + q_2.

#ifndef FLATDYN_PUMA560_HPP
#define FLATDYN_PUMA560_HPP

#include <cmath>

namespace puma560 {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 6;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {
    "waist", "shoulder", "elbow", "wrist_roll", "wrist_bend", "flange"};

// Smallest position, rad or m.
inline constexpr Real position_lower[joint_count] = {
    Real(-2.792526803190927), Real(-3.9269908169872414), Real(-0.7853981633974483),
    Real(-1.9198621771937625), Real(-1.7453292519943295), Real(-4.642575810304916)};

// Largest position, rad or m.
inline constexpr Real position_upper[joint_count] = {
    Real(2.792526803190927), Real(0.7853981633974483), Real(3.9269908169872414),
    Real(2.9670597283903604), Real(1.7453292519943295), Real(4.642575810304916)};

namespace detail {

// -1, 0 or 1, without a branch.
template <class Scalar>
inline Scalar sign(const Scalar& x) noexcept {
  return Scalar((x > Scalar(0.0)) - (x < Scalar(0.0)));
}

}  // namespace detail

// tau = B(q) qdd + C(q, qd) qd + g(q) + friction (7.42).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5], qd[0..5], qdd[0..5]. Operations: 193 mul, 157 add, 10 sin/cos.
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
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = s_2 * qd_1;
  const Scalar omega_r_3_x = s_3 * t1 + c_3 * t2;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t3 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar t4 = s_3 * t2 - c_3 * t1;
  const Scalar omega_4_z = qd_4 - t4;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t3;
  const Scalar omega_r_4_y = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar t5 = qd_2 * t2;
  const Scalar t6 = c_2 * qdd_1;
  const Scalar t7 = t5 - t6;
  const Scalar t8 = qd_2 * t1;
  const Scalar t9 = s_2 * qdd_1;
  const Scalar domega_2_x = t8 + t9;
  const Scalar t10 = qd_3 * t4 + s_3 * t7 - c_3 * domega_2_x;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar t11 = qd_4 * omega_r_4_y + s_4 * domega_3_z + c_4 * t10;
  const Scalar t12 = qd_3 * omega_r_3_x + s_3 * domega_2_x + c_3 * t7;
  const Scalar domega_4_z = qdd_4 - t12;
  const Scalar domega_6_z = qdd_6 - qd_5 * omega_r_5_x + s_5 * t11 + c_5 * domega_4_z;
  const Scalar t13 = Scalar(0.00004) * domega_6_z;
  tau[5] = Scalar(0.2158232532732) * qd_6 + Scalar(0.20582599086) * qdd_6 +
      Scalar(0.55443978) * detail::sign(qd_6) + t13;
  const Scalar t14 = omega_r_3_x * omega_3_z;
  const Scalar t15 = t12 + t14;
  const Scalar t16 = t4 * omega_3_z;
  const Scalar t17 = t10 + t16;
  const Scalar U_2_zx = t5 + t7;
  const Scalar t18 = t1 * t1;
  const Scalar t19 = t2 * t2;
  const Scalar U_2_zz = t18 + t19;
  const Scalar ddp_o_3_z = Scalar(0.4318) * U_2_zx + Scalar(0.1501) * U_2_zz;
  const Scalar ddp_o_4_z = ddp_o_3_z - Scalar(0.0203) * t15 + Scalar(0.4331) * t17;
  const Scalar t20 = t1 * t2;
  const Scalar U_2_yx = qdd_2 + t20;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.1501) * t9 - Scalar(0.4318) * U_2_yx;
  const Scalar t21 = qd_2 * qd_2;
  const Scalar U_2_xx = t21 + t18;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 + Scalar(0.1501) * t6 + Scalar(0.4318) * U_2_xx;
  const Scalar ddp_3_x = s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar t22 = t4 * t4;
  const Scalar t23 = omega_3_z * omega_3_z;
  const Scalar U_3_xx = t23 + t22;
  const Scalar t24 = omega_r_3_x * t4;
  const Scalar U_3_xy = domega_3_z + t24;
  const Scalar ddp_o_4_x = ddp_3_x - Scalar(0.0203) * U_3_xx - Scalar(0.4331) * U_3_xy;
  const Scalar ddp_4_x = s_4 * ddp_o_4_z + c_4 * ddp_o_4_x;
  const Scalar t25 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar U_3_yx = domega_3_z - t24;
  const Scalar U_3_yy = t23 + omega_r_3_x * omega_r_3_x;
  const Scalar t26 = s_5 * (t25 - Scalar(0.0203) * U_3_yx + Scalar(0.4331) * U_3_yy) -
      c_5 * ddp_4_x;
  const Scalar omega_r_5_y = s_5 * t3 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t27 = Scalar(0.00004) * omega_6_z;
  const Scalar t28 = s_6 * t27;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar omega_r_6_y = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t29 = c_6 * t27;
  const Scalar t30 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar t31 = omega_r_5_x * omega_r_5_y;
  const Scalar domega_5_z = qdd_5 - qd_4 * t3 - s_4 * t10 + c_4 * domega_3_z;
  const Scalar t32 = Scalar(0.00288) * t26 + Scalar(0.00064216) * domega_5_z -
      Scalar(0.00024216) * t31 + omega_r_6_y * t28 - t30 * t29;
  tau[4] = Scalar(0.4272830209354) * qd_5 + Scalar(0.181052127515) * qdd_5 + t32 +
      Scalar(0.85444524) * detail::sign(qd_5);
  const Scalar t33 = s_4 * ddp_o_4_x - c_4 * ddp_o_4_z;
  const Scalar domega_5_x = qd_5 * omega_r_5_y + s_5 * domega_4_z - c_5 * t11;
  const Scalar t34 = omega_r_5_y * omega_5_z;
  const Scalar t35 = Scalar(0.00288) * t33 + Scalar(0.00024216) * domega_5_x +
      Scalar(0.00064216) * t34 - t30 * t28 - omega_r_6_y * t29;
  const Scalar t36 = t13 - Scalar(0.0004) * omega_r_5_x * omega_5_z;
  const Scalar mu_4_z = Scalar(0.0016) * domega_4_z + s_5 * t35 + c_5 * t36 -
      Scalar(0.0003) * t3 * omega_r_4_y;
  tau[3] = Scalar(0.411645229697152) * qd_4 + Scalar(0.2023536943736) * qdd_4 + mu_4_z +
      Scalar(1.06831142) * detail::sign(qd_4);
  const Scalar t37 = Scalar(0.0003) * t11 + s_5 * t36 - c_5 * t35 +
      Scalar(0.0016) * omega_r_4_y * omega_4_z;
  const Scalar mu_4_y = t32 - Scalar(0.0013) * t3 * omega_4_z;
  const Scalar U_5_zy = domega_5_x + t34;
  const Scalar t38 = Scalar(0.00288) * U_5_zy;
  const Scalar U_5_yy = omega_5_z * omega_5_z + omega_r_5_x * omega_r_5_x;
  const Scalar t39 = Scalar(0.00288) * s_5;
  const Scalar U_5_xy = domega_5_z - t31;
  const Scalar t40 = Scalar(0.00288) * c_5;
  const Scalar t41 = U_5_yy * t39 - U_5_xy * t40;
  const Scalar t42 = s_4 * t38 + c_4 * t41;
  const Scalar f_u_5_t_y = U_5_xy * t39 + U_5_yy * t40;
  const Scalar U_3_xx_yy = U_3_xx - U_3_yy;
  const Scalar mu_3_z = Scalar(0.861795) * ddp_3_x + Scalar(0.025375) * t25 -
      Scalar(0.313105249) * domega_3_z - Scalar(0.299575024) * t24 -
      Scalar(0.004704) * (t12 - t14) - Scalar(0.0106736385) * U_3_xx_yy +
      Scalar(0.0203) * f_u_5_t_y + Scalar(0.4331) * t42 - s_4 * t37 - c_4 * mu_4_y;
  tau[2] = Scalar(3.9804259903722) * qd_3 + Scalar(0.86242563124731) * qdd_3 - mu_3_z +
      Scalar(6.36419655) * detail::sign(qd_3);
  const Scalar f_3_x = Scalar(0.025375) * U_3_xx + Scalar(0.861795) * U_3_xy - t42;
  const Scalar f_3_y = Scalar(0.025375) * U_3_yx - Scalar(0.861795) * U_3_yy - f_u_5_t_y;
  const Scalar t43 = s_3 * f_3_x - c_3 * f_3_y;
  const Scalar U_2_yy = t21 + t19;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  const Scalar t44 = Scalar(37.2347379) * c_2 - Scalar(1.024164) * s_2 -
      Scalar(9.496868641825) * qd_2 - Scalar(6.502360360025) * qdd_2 - Scalar(0.690314699) * t9 -
      Scalar(0.023751) * t6 - Scalar(1.601861202) * t20 - Scalar(0.0070992) * U_2_xx_yy + mu_3_z -
      Scalar(0.4318) * t43 - Scalar(10.6197775) * detail::sign(qd_2);
  tau[1] = -t44;
  const Scalar t45 = s_4 * t41 - c_4 * t38;
  const Scalar mu_3_x = Scalar(0.861795) * ddp_o_3_z + Scalar(0.299575024) * t10 -
      Scalar(0.0106736385) * t15 + Scalar(0.313105249) * t16 - Scalar(0.004704) * (t23 - t22) +
      Scalar(0.4331) * t45 - s_4 * mu_4_y + c_4 * t37;
  const Scalar mu_3_y = Scalar(0.025375) * ddp_o_3_z - Scalar(0.004704) * U_3_xy -
      Scalar(0.013530225) * t14 + Scalar(0.0106736385) * t17 + mu_4_z + Scalar(0.0203) * t45;
  const Scalar U_2_yy_zz = U_2_yy - U_2_zz;
  const Scalar mu_2_x = Scalar(1.748114002) * t8 - Scalar(1.601861202) * domega_2_x +
      Scalar(0.690314699) * U_2_yx + Scalar(0.0070992) * U_2_zx - Scalar(0.023751) * U_2_yy_zz +
      Scalar(0.1501) * t43 - s_3 * mu_3_y - c_3 * mu_3_x;
  const Scalar f_u_3_t_x = s_3 * f_3_y + c_3 * f_3_x;
  const Scalar U_2_zy = t8 + domega_2_x;
  const Scalar U_2_zz_xx = U_2_xx - U_2_zz;
  const Scalar U_2_xy = qdd_2 - t20;
  const Scalar mu_2_y = Scalar(3.349975204) * t5 - Scalar(0.023751) * U_2_xy +
      Scalar(0.0070992) * U_2_zy - Scalar(0.010956925) * t15 + Scalar(0.372123081) * t17 -
      Scalar(0.690314699) * U_2_zz_xx + Scalar(0.4318) * t45 + Scalar(0.1501) * f_u_3_t_x +
      s_3 * mu_3_x - c_3 * mu_3_y;
  tau[0] = Scalar(5.8018217679508) * qd_1 + Scalar(4.29424586937411) * qdd_1 +
      Scalar(25.9836065) * detail::sign(qd_1) + s_2 * mu_2_x - c_2 * mu_2_y;
}

// inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..5], qd[0..5], qdd[0..5], h_e[0..5]. Operations: 245 mul, 189 add, 12 sin/cos.
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
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = s_2 * qd_1;
  const Scalar omega_r_3_x = s_3 * t1 + c_3 * t2;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t3 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar t4 = s_3 * t2 - c_3 * t1;
  const Scalar omega_4_z = qd_4 - t4;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t3;
  const Scalar omega_r_4_y = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar t5 = qd_2 * t2;
  const Scalar t6 = c_2 * qdd_1;
  const Scalar t7 = t5 - t6;
  const Scalar t8 = qd_2 * t1;
  const Scalar t9 = s_2 * qdd_1;
  const Scalar domega_2_x = t8 + t9;
  const Scalar t10 = qd_3 * t4 + s_3 * t7 - c_3 * domega_2_x;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar t11 = qd_4 * omega_r_4_y + s_4 * domega_3_z + c_4 * t10;
  const Scalar t12 = qd_3 * omega_r_3_x + s_3 * domega_2_x + c_3 * t7;
  const Scalar domega_4_z = qdd_4 - t12;
  const Scalar domega_6_z = qdd_6 - qd_5 * omega_r_5_x + s_5 * t11 + c_5 * domega_4_z;
  const Scalar mu_e1_x = s_1 * h_e_5 + c_1 * h_e_4;
  const Scalar mu_e2_y = s_2 * mu_e1_x + c_2 * h_e_6;
  const Scalar t13 = s_2 * h_e_6 - c_2 * mu_e1_x;
  const Scalar t14 = s_3 * mu_e2_y + c_3 * t13;
  const Scalar t15 = s_1 * h_e_4 - c_1 * h_e_5;
  const Scalar t16 = s_4 * t15 + c_4 * t14;
  const Scalar t17 = s_3 * t13 - c_3 * mu_e2_y;
  const Scalar mu_6_z = Scalar(0.00004) * domega_6_z - s_5 * t16 - c_5 * t17;
  tau[5] = Scalar(0.2158232532732) * qd_6 + Scalar(0.20582599086) * qdd_6 + mu_6_z +
      Scalar(0.55443978) * detail::sign(qd_6);
  const Scalar mu_e5_x = s_5 * t17 - c_5 * t16;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar omega_r_6_y = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar omega_r_5_y = s_5 * t3 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t18 = Scalar(0.00004) * omega_6_z;
  const Scalar mu_e4_y = s_4 * t14 - c_4 * t15;
  const Scalar mu_6_x = omega_r_6_y * t18 + s_6 * mu_e4_y + c_6 * mu_e5_x;
  const Scalar t19 = (s_6 * omega_5_z - c_6 * omega_r_5_x) * t18;
  const Scalar t20 = t19 + s_6 * mu_e5_x - c_6 * mu_e4_y;
  const Scalar t21 = omega_r_3_x * omega_3_z;
  const Scalar t22 = t12 + t21;
  const Scalar t23 = t4 * omega_3_z;
  const Scalar t24 = t10 + t23;
  const Scalar U_2_zx = t5 + t7;
  const Scalar t25 = t1 * t1;
  const Scalar t26 = t2 * t2;
  const Scalar U_2_zz = t25 + t26;
  const Scalar ddp_o_3_z = Scalar(0.4318) * U_2_zx + Scalar(0.1501) * U_2_zz;
  const Scalar ddp_o_4_z = ddp_o_3_z - Scalar(0.0203) * t22 + Scalar(0.4331) * t24;
  const Scalar t27 = t1 * t2;
  const Scalar U_2_yx = qdd_2 + t27;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.1501) * t9 - Scalar(0.4318) * U_2_yx;
  const Scalar t28 = qd_2 * qd_2;
  const Scalar U_2_xx = t28 + t25;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 + Scalar(0.1501) * t6 + Scalar(0.4318) * U_2_xx;
  const Scalar ddp_3_x = s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar t29 = t4 * t4;
  const Scalar t30 = omega_3_z * omega_3_z;
  const Scalar U_3_xx = t30 + t29;
  const Scalar t31 = omega_r_3_x * t4;
  const Scalar U_3_xy = domega_3_z + t31;
  const Scalar ddp_o_4_x = ddp_3_x - Scalar(0.0203) * U_3_xx - Scalar(0.4331) * U_3_xy;
  const Scalar ddp_4_x = s_4 * ddp_o_4_z + c_4 * ddp_o_4_x;
  const Scalar t32 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar U_3_yx = domega_3_z - t31;
  const Scalar U_3_yy = t30 + omega_r_3_x * omega_r_3_x;
  const Scalar t33 = s_5 * (t32 - Scalar(0.0203) * U_3_yx + Scalar(0.4331) * U_3_yy) -
      c_5 * ddp_4_x;
  const Scalar t34 = omega_r_5_x * omega_r_5_y;
  const Scalar domega_5_z = qdd_5 - qd_4 * t3 - s_4 * t10 + c_4 * domega_3_z;
  const Scalar t35 = Scalar(0.00288) * t33 + Scalar(0.00064216) * domega_5_z -
      Scalar(0.00024216) * t34 + s_6 * mu_6_x - c_6 * t20;
  tau[4] = Scalar(0.4272830209354) * qd_5 + Scalar(0.181052127515) * qdd_5 + t35 +
      Scalar(0.85444524) * detail::sign(qd_5);
  const Scalar t36 = s_4 * ddp_o_4_x - c_4 * ddp_o_4_z;
  const Scalar domega_5_x = qd_5 * omega_r_5_y + s_5 * domega_4_z - c_5 * t11;
  const Scalar t37 = omega_r_5_y * omega_5_z;
  const Scalar t38 = Scalar(0.00288) * t36 + Scalar(0.00024216) * domega_5_x +
      Scalar(0.00064216) * t37 - s_6 * t20 - c_6 * mu_6_x;
  const Scalar t39 = mu_6_z - Scalar(0.0004) * omega_r_5_x * omega_5_z;
  const Scalar mu_4_z = Scalar(0.0016) * domega_4_z + s_5 * t38 + c_5 * t39 -
      Scalar(0.0003) * t3 * omega_r_4_y;
  tau[3] = Scalar(0.411645229697152) * qd_4 + Scalar(0.2023536943736) * qdd_4 + mu_4_z +
      Scalar(1.06831142) * detail::sign(qd_4);
  const Scalar f_e1_x = s_1 * h_e_2 + c_1 * h_e_1;
  const Scalar f_e2_y = s_2 * f_e1_x + c_2 * h_e_3;
  const Scalar t40 = s_2 * h_e_3 - c_2 * f_e1_x;
  const Scalar t41 = s_3 * f_e2_y + c_3 * t40;
  const Scalar t42 = s_1 * h_e_1 - c_1 * h_e_2;
  const Scalar t43 = s_4 * t42 + c_4 * t41;
  const Scalar t44 = s_3 * t40 - c_3 * f_e2_y;
  const Scalar f_e5_x = s_5 * t44 - c_5 * t43;
  const Scalar f_e4_y = s_4 * t41 - c_4 * t42;
  const Scalar t45 = s_6 * f_e5_x - c_6 * f_e4_y;
  const Scalar f_e6_x = s_6 * f_e4_y + c_6 * f_e5_x;
  const Scalar U_5_xy = domega_5_z - t34;
  const Scalar f_5_x = Scalar(0.00288) * U_5_xy + s_6 * t45 + c_6 * f_e6_x;
  const Scalar U_5_yy = omega_5_z * omega_5_z + omega_r_5_x * omega_r_5_x;
  const Scalar t46 = Scalar(0.00288) * U_5_yy + s_5 * t43 + c_5 * t44;
  const Scalar t47 = s_5 * t46 - c_5 * f_5_x;
  const Scalar U_5_zy = domega_5_x + t37;
  const Scalar f_5_z = Scalar(0.00288) * U_5_zy + s_6 * f_e6_x - c_6 * t45;
  const Scalar t48 = s_4 * f_5_z + c_4 * t47;
  const Scalar t49 = Scalar(0.0003) * t11 + s_5 * t39 - c_5 * t38 +
      Scalar(0.0016) * omega_r_4_y * omega_4_z;
  const Scalar t50 = s_5 * f_5_x + c_5 * t46;
  const Scalar mu_4_y = t35 - Scalar(0.0013) * t3 * omega_4_z;
  const Scalar U_3_xx_yy = U_3_xx - U_3_yy;
  const Scalar mu_3_z = Scalar(0.861795) * ddp_3_x + Scalar(0.025375) * t32 -
      Scalar(0.313105249) * domega_3_z - Scalar(0.299575024) * t31 -
      Scalar(0.004704) * (t12 - t21) - Scalar(0.0106736385) * U_3_xx_yy + Scalar(0.0203) * t50 +
      Scalar(0.4331) * t48 - s_4 * t49 - c_4 * mu_4_y;
  tau[2] = Scalar(3.9804259903722) * qd_3 + Scalar(0.86242563124731) * qdd_3 - mu_3_z +
      Scalar(6.36419655) * detail::sign(qd_3);
  const Scalar f_3_x = Scalar(0.025375) * U_3_xx + Scalar(0.861795) * U_3_xy - t48;
  const Scalar f_3_y = Scalar(0.025375) * U_3_yx - Scalar(0.861795) * U_3_yy - t50;
  const Scalar t51 = s_3 * f_3_x - c_3 * f_3_y;
  const Scalar U_2_yy = t28 + t26;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  const Scalar t52 = Scalar(37.2347379) * c_2 - Scalar(1.024164) * s_2 -
      Scalar(9.496868641825) * qd_2 - Scalar(6.502360360025) * qdd_2 - Scalar(0.690314699) * t9 -
      Scalar(0.023751) * t6 - Scalar(1.601861202) * t27 - Scalar(0.0070992) * U_2_xx_yy + mu_3_z -
      Scalar(0.4318) * t51 - Scalar(10.6197775) * detail::sign(qd_2);
  tau[1] = -t52;
  const Scalar t53 = s_4 * t47 - c_4 * f_5_z;
  const Scalar mu_3_y = Scalar(0.025375) * ddp_o_3_z - Scalar(0.004704) * U_3_xy -
      Scalar(0.013530225) * t21 + Scalar(0.0106736385) * t24 + mu_4_z + Scalar(0.0203) * t53;
  const Scalar mu_3_x = Scalar(0.861795) * ddp_o_3_z + Scalar(0.299575024) * t10 -
      Scalar(0.0106736385) * t22 + Scalar(0.313105249) * t23 - Scalar(0.004704) * (t30 - t29) +
      Scalar(0.4331) * t53 - s_4 * mu_4_y + c_4 * t49;
  const Scalar U_2_yy_zz = U_2_yy - U_2_zz;
  const Scalar mu_2_x = Scalar(1.748114002) * t8 - Scalar(1.601861202) * domega_2_x +
      Scalar(0.690314699) * U_2_yx + Scalar(0.0070992) * U_2_zx - Scalar(0.023751) * U_2_yy_zz +
      Scalar(0.1501) * t51 - s_3 * mu_3_y - c_3 * mu_3_x;
  const Scalar f_u_3_t_x = s_3 * f_3_y + c_3 * f_3_x;
  const Scalar U_2_zy = t8 + domega_2_x;
  const Scalar U_2_zz_xx = U_2_xx - U_2_zz;
  const Scalar U_2_xy = qdd_2 - t27;
  const Scalar mu_2_y = Scalar(3.349975204) * t5 - Scalar(0.023751) * U_2_xy +
      Scalar(0.0070992) * U_2_zy - Scalar(0.010956925) * t22 + Scalar(0.372123081) * t24 -
      Scalar(0.690314699) * U_2_zz_xx + Scalar(0.4318) * t53 + Scalar(0.1501) * f_u_3_t_x +
      s_3 * mu_3_x - c_3 * mu_3_y;
  tau[0] = Scalar(5.8018217679508) * qd_1 + Scalar(4.29424586937411) * qdd_1 +
      Scalar(25.9836065) * detail::sign(qd_1) + s_2 * mu_2_x - c_2 * mu_2_y;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[36] = {
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 0, 1,
    1, 1, 1, 0, 1, 0,
    1, 1, 1, 1, 0, 1};

// joint-space inertia matrix B(q) (7.32).
//   q[6]   in   joint positions, rad or m
//   B[36]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//               6 x 6, row by row: entry (i, j) is B[6 * i + j]
// Reads q[1..4]. Operations: 83 mul, 68 add, 8 sin/cos. Always zero: 4 of the 36 entries of B.
template <class Scalar>
inline void inertia_matrix(const Scalar* q, Scalar* B) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  B[23] = B[33] = Scalar(0.00004) * c_5;
  const Scalar t1 = s_4 * s_5;
  B[11] = B[17] = B[31] = B[32] = Scalar(0.00004) * t1;
  const Scalar t2 = Scalar(0.00020216) * c_5;
  const Scalar t3 = t2 + Scalar(0.001247328);
  const Scalar t4 = t3 * t1;
  B[15] = B[20] = -t4;
  const Scalar t5 = Scalar(0.001247328) * c_5 + Scalar(0.00064216);
  const Scalar t6 = Scalar(0.000058464) * s_5 - c_4 * t5;
  B[16] = B[26] = -t6;
  const Scalar t7 = c_5 * t2;
  const Scalar Ic_4_zz = t7 - Scalar(0.00184216);
  B[21] = Scalar(0.2023536943736) - Ic_4_zz;
  const Scalar t8 = Scalar(0.001243584) * t1;
  B[9] = B[19] = -t4 - s_3 * t8;
  const Scalar t9 = s_3 * c_5;
  const Scalar f_u_5_3_t_y = c_3 * s_5 + c_4 * t9;
  B[10] = B[25] = Scalar(0.001243584) * f_u_5_3_t_y - t6;
  const Scalar t10 = c_4 * s_5;
  const Scalar mu_u_6_3_t_x = t9 + c_3 * t10;
  B[5] = B[30] = Scalar(0.00004) * (c_2 * (c_3 * c_5 - s_3 * t10) - s_2 * mu_u_6_3_t_x);
  const Scalar t11 = c_5 * (s_4 - Scalar(0.04701250578971746) * c_3 *
      (Scalar(7.394088669950739) * c_4 + s_4));
  const Scalar t12 = s_4 * t5;
  const Scalar mu_5_2_y = Scalar(0.001243584) * t11 + s_3 * (Scalar(0.000432288) * s_5 + t12);
  const Scalar mu_5_2_x = Scalar(0.000432288) * f_u_5_3_t_y + c_3 * t12 +
      Scalar(0.000058464) * s_4 * t9;
  B[4] = B[24] = c_2 * mu_5_2_y + s_2 * mu_5_2_x;
  const Scalar Iu_5_t_xx = t7 - Scalar(0.00020216);
  const Scalar Iu_4_t_d = Iu_5_t_xx - Scalar(0.0001);
  const Scalar t13 = c_4 * Iu_4_t_d;
  const Scalar t14 = c_4 * t13;
  const Scalar t15 = Scalar(0.000116928) * t10;
  const Scalar t16 = Scalar(0.002494656) * c_5;
  const Scalar Ic_3_zz = Iu_5_t_xx - t14 + t16 - t15 + Scalar(0.313647409);
  const Scalar hc_3_x = Scalar(0.00288) * t10 - Scalar(0.025375);
  const Scalar hc_3_y = Scalar(0.00288) * c_5 + Scalar(0.861795);
  const Scalar hu_3_t_x = c_3 * hc_3_x + s_3 * hc_3_y;
  const Scalar t17 = Scalar(0.8636) * hu_3_t_x;
  B[7] = Ic_3_zz + t17 + Scalar(6.502360360025);
  B[14] = Ic_3_zz + Scalar(0.86242563124731);
  B[8] = B[13] = Ic_3_zz + Scalar(0.4318) * hu_3_t_x;
  const Scalar mu_4_3_y = Ic_4_zz + Scalar(0.000058464) * t10;
  const Scalar t18 = Scalar(0.000432288) * t1 - mu_4_3_y;
  const Scalar t19 = t10 * t3;
  const Scalar mu_4_2_y = Scalar(0.001243584) * t10 + c_3 * t18 + s_3 * t19;
  B[3] = B[18] = c_2 * mu_4_2_y - s_2 * (s_3 * t18 - c_3 * t19);
  const Scalar Ic_3_xz = Scalar(0.000058464) * t1 + s_4 * t13;
  const Scalar Ic_3_yz = t4 + Scalar(0.004704);
  const Scalar Iu_3_t_yz = c_3 * Ic_3_yz + s_3 * Ic_3_xz;
  const Scalar t20 = c_3 * hc_3_y - s_3 * hc_3_x;
  const Scalar t21 = Scalar(0.1501) * t20 + Iu_3_t_yz;
  const Scalar mu_3_2_x = Scalar(0.1501) * hu_3_t_x - (c_3 * Ic_3_xz - s_3 * Ic_3_yz);
  B[2] = B[12] = s_2 * mu_3_2_x - c_2 * t21;
  const Scalar Ic_2_xz = mu_3_2_x + t8 + Scalar(0.690314699);
  B[1] = B[6] = s_2 * Ic_2_xz - c_2 * (t21 - Scalar(0.023751));
  const Scalar Ic_3_xx = t14 + t16 + Scalar(0.0001);
  const Scalar Ic_3_yy = Ic_4_zz + t15 + Scalar(0.300117184);
  const Scalar Iu_3_t_d = Ic_3_xx + Ic_3_yy;
  const Scalar Ic_3_xy = Scalar(0.000058464) * c_5 - t19 + Scalar(0.0106736385);
  const Scalar Iu_3_t_g = c_3 * Iu_3_t_d + Scalar(2.0) * s_3 * Ic_3_xy;
  const Scalar t22 = c_3 * Iu_3_t_g;
  const Scalar t23 = s_2 * (Ic_3_xy - Scalar(0.4318) * t20 - s_3 * Iu_3_t_g + Scalar(0.0070992));
  const Scalar t24 = c_2 * (Iu_3_t_d - Scalar(2.0) * t22 + t17 + Scalar(1.601861202)) -
      Scalar(2.0) * t23;
  B[0] = Scalar(0.000864576) * t1 - Ic_3_yy + t22 + c_2 * t24 + Scalar(2.99250185137411);
  B[22] = B[27] = B[29] = B[34] = Scalar(0.0);
  B[28] = Scalar(0.181694287515);
  B[35] = Scalar(0.20586599086);
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[126] = {
    0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 1, 1, 0,
    1, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 1, 1, 0,
    1, 1, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 1, 1, 0,
    1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1, 0, 1, 1, 1, 0, 1, 0,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0,
    0, 1, 0, 1, 0, 0, 1, 1, 1, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[6]    in   joint positions, rad or m
//   c[126]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//                c_ijk = c_ikj is c[21 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads q[1..4]. Operations: 211 mul, 130 add, 8 sin/cos. Always zero: 40 of the 126 entries of c.
template <class Scalar>
inline void christoffel(const Scalar* q, Scalar* c) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  c[102] = Scalar(0.00002) * s_5;
  c[82] = c[118] = Scalar(-0.00002) * s_5;
  const Scalar t1 = Scalar(0.00020216) * s_5;
  const Scalar db_44_5r = c_5 * t1;
  c[76] = db_44_5r;
  const Scalar t2 = s_4 * c_5;
  c[40] = c[61] = c[116] = c[117] = Scalar(0.00002) * t2;
  const Scalar t3 = c_4 * s_5;
  const Scalar db_26_4 = Scalar(0.00002) * t3;
  c[39] = c[60] = c[112] = c[113] = db_26_4;
  c[79] = c[80] = Scalar(-0.00002) * t3;
  c[100] = c[101] = Scalar(-0.00002) * t2;
  const Scalar t4 = Scalar(0.000058464) * c_5;
  const Scalar v_3_5_y = Scalar(0.001247328) * t3 + t4;
  c[56] = -v_3_5_y;
  c[93] = -db_44_5r;
  const Scalar hc_3_x = Scalar(0.00144) * t3 - Scalar(0.0126875);
  const Scalar hc_3_y = Scalar(0.00144) * c_5 + Scalar(0.4308975);
  const Scalar c_3_3 = Scalar(0.8636) * s_3 * hc_3_x - Scalar(0.8636) * c_3 * hc_3_y;
  c[44] = c_3_3;
  const Scalar w_1_3_x = s_2 * c_3 + c_2 * s_3;
  const Scalar t5 = s_4 * s_5;
  const Scalar t6 = t5 * w_1_3_x;
  c[18] = c[111] = Scalar(0.00002) * t6;
  const Scalar t7 = c_5 * w_1_3_x;
  const Scalar t8 = s_2 * s_3 - c_2 * c_3;
  const Scalar db_16_3 = Scalar(0.00002) * t7 - t8 * db_26_4;
  c[57] = db_16_3;
  const Scalar t9 = Scalar(0.00010108) * c_5;
  const Scalar t10 = t9 + Scalar(0.000623664);
  const Scalar t11 = t3 * t10;
  c[51] = Scalar(-2.0) * t11;
  c[78] = Scalar(-0.00002) * t6;
  c[25] = c[26] = -c_3_3;
  const Scalar t12 = Scalar(0.000621792) * s_3;
  const Scalar v_o_2_4_x = t12 + Scalar(0.000623664);
  const Scalar v_o_2_4_y = Scalar(0.4318) * c_3 - Scalar(0.0203);
  const Scalar t13 = Scalar(694.4444444444445) * t3 * v_o_2_4_x - c_5 * v_o_2_4_y;
  const Scalar c_2_5_5 = Scalar(-0.00288) * t13;
  c[35] = c_2_5_5;
  const Scalar t14 = t10 * t5;
  const Scalar t15 = Scalar(2.0) * s_4;
  const Scalar db_33_5r = t14 * t15 + c_4 * v_3_5_y;
  c[89] = db_33_5r;
  c[17] = c[108] = -db_16_3;
  const Scalar t16 = s_2 * (s_3 * t3 - c_3 * c_5);
  const Scalar t17 = s_3 * c_5;
  const Scalar mu_u_6_3_t_x = t17 + c_3 * t3;
  const Scalar c_1_17 = Scalar(0.00002) * t16 - Scalar(0.00002) * c_2 * mu_u_6_3_t_x;
  c[16] = c[106] = c_1_17;
  const Scalar t18 = t9 + v_o_2_4_x;
  c[30] = Scalar(-2.0) * t3 * t18;
  const Scalar t19 = c_5 * t9;
  const Scalar Iu_4_t_d = t19 - Scalar(0.00015108);
  const Scalar t20 = c_4 * Iu_4_t_d;
  const Scalar t21 = Scalar(0.00144) * s_5;
  const Scalar t22 = t20 - v_o_2_4_y * t21;
  const Scalar db_22_4r = t22 * t15;
  c[28] = db_22_4r;
  c[54] = -db_33_5r;
  const Scalar t23 = s_5 * t8;
  const Scalar t24 = t23 - c_4 * t7;
  c[99] = Scalar(-0.00002) * t24;
  c[19] = c[115] = Scalar(0.00002) * t24;
  c[36] = -c_1_17;
  const Scalar t25 = s_4 * (s_5 * t1 - Scalar(0.00010108));
  const Scalar t26 = v_o_2_4_x * t2;
  const Scalar db_24_5r = t26 - t25;
  const Scalar db_25_4 = Scalar(0.00032108) * s_4 + t26;
  const Scalar c_4_2_5 = db_25_4 - db_24_5r;
  c[74] = c_4_2_5;
  const Scalar t27 = Scalar(0.000623664) * t2 - t25;
  const Scalar t28 = Scalar(0.000623664) * c_5 + Scalar(0.00032108);
  const Scalar t29 = s_4 * t28;
  const Scalar c_4_3_5 = t29 - t27;
  c[75] = c_4_3_5;
  const Scalar t30 = Scalar(0.4318) * c_2;
  const Scalar v_o_1_4_z = Scalar(0.4331) * w_1_3_x + Scalar(0.0203) * t8 + t30;
  const Scalar t31 = s_4 * v_o_1_4_z + Scalar(0.1501) * c_4 * t8;
  const Scalar c_1_5_5 = Scalar(0.000432288) * t7 - Scalar(0.00288) * s_5 * t31;
  c[14] = c_1_5_5;
  const Scalar dmu_3_4_x = Scalar(0.000029232) * s_5 + t20;
  const Scalar t32 = s_4 * dmu_3_4_x;
  c[50] = Scalar(2.0) * t32;
  const Scalar c_5_3 = t5 * t18 * t15 - c_4 * c_2_5_5;
  c[86] = c_5_3;
  c[65] = -db_22_4r;
  c[34] = -db_25_4 - db_24_5r;
  c[91] = -c_4_2_5;
  c[68] = Scalar(-2.0) * t32;
  c[55] = -t29 - t27;
  c[92] = -c_4_3_5;
  c[32] = -c_5_3;
  const Scalar t33 = Scalar(14.246141669964384) * t31 + s_4 * t7;
  c[9] = -t33 * t1;
  const Scalar Ic_4_zz = t19 - Scalar(0.00092108);
  const Scalar mu_4_3_y = Ic_4_zz + Scalar(0.000029232) * t3;
  const Scalar t34 = Scalar(0.000216144) * t5 - mu_4_3_y;
  const Scalar t35 = t11 * t8;
  const Scalar t36 = w_1_3_x * t34 + t35;
  const Scalar t37 = s_4 * w_1_3_x;
  const Scalar t38 = Scalar(0.000216144) * s_5;
  const Scalar t39 = w_1_3_x * t38;
  const Scalar t40 = Iu_4_t_d * t37 - t39;
  const Scalar t41 = s_4 * t40;
  const Scalar t42 = c_4 * w_1_3_x;
  const Scalar t43 = t35 + t41 - dmu_3_4_x * t42;
  const Scalar c_3_7 = t36 + t43;
  c[48] = c_3_7;
  const Scalar db_23_4r = t32 + s_4 * t22;
  const Scalar t44 = Scalar(0.000621792) * c_3;
  const Scalar t45 = t5 * t44;
  c[29] = db_23_4r - t45;
  const Scalar c_3_2_4 = db_23_4r + t45;
  c[49] = c_3_2_4;
  const Scalar t46 = Scalar(0.00144) * c_4;
  const Scalar t47 = s_4 * t5 * (t10 + t18) + t46 * (t13 + Scalar(347.22222222222223) * v_3_5_y);
  const Scalar t48 = c_4 * c_5 * t44 - s_5 * t12;
  c[33] = t48 - t47;
  const Scalar c_5_5 = t48 + t47;
  c[88] = c_5_5;
  const Scalar t49 = s_4 * t8;
  const Scalar t50 = Scalar(0.000216144) * t49 - v_o_1_4_z * t46;
  const Scalar t51 = t50 + Scalar(0.00010108) * t24;
  const Scalar t52 = t3 * w_1_3_x + c_5 * t8;
  const Scalar db_11_5r = Scalar(2.0) * t52 * t51 + c_1_5_5 * t37;
  c[10] = db_11_5r;
  c[8] = t43 - t36;
  c[66] = -c_3_7;
  const Scalar t53 = Scalar(0.00010108) * s_5;
  const Scalar t54 = c_5 * t51 + t52 * t53;
  const Scalar t55 = Scalar(0.00032108) * t42 - c_5 * t50;
  c[13] = t55 - t54;
  const Scalar c_4_1_5 = t55 + t54;
  c[90] = c_4_1_5;
  c[67] = -c_3_2_4;
  c[53] = -c_5_5;
  const Scalar dmu_1_4_y = Iu_4_t_d * t42 - t9 * t23;
  const Scalar t56 = w_1_3_x * (c_4 * (t39 - t40) - s_4 * dmu_1_4_y);
  const Scalar db_11_4r = t56 + t8 * (t33 * t53 + t31 * t21);
  c[6] = db_11_4r;
  c[84] = -db_11_5r;
  const Scalar Ic_3_yz = t14 + Scalar(0.002352);
  const Scalar t57 = w_1_3_x * (Scalar(0.1501) * hc_3_y + Ic_3_yz) -
      t8 * (Scalar(0.1501) * hc_3_x - t32);
  c[5] = Scalar(2.0) * t57;
  const Scalar mu_4_2_y = t3 * (s_3 * t10 + Scalar(0.000621792)) + c_3 * t34;
  const Scalar t58 = s_2 * mu_4_2_y + c_2 * (s_3 * t34 - c_3 * t11);
  const Scalar t59 = c_4 * (w_1_3_x * t22 - t23 * t18) - t41;
  const Scalar c_2_1_4 = t58 - t59;
  c[27] = c_2_1_4;
  c[73] = -c_4_1_5;
  const Scalar Iu_3_t_d = Scalar(0.001247328) * c_5 + Ic_4_zz +
      c_4 * (Scalar(0.000058464) * s_5 + t20) + Scalar(0.150108592);
  const Scalar t60 = Scalar(2.0) * t11 - t4 - Scalar(0.0106736385);
  const Scalar t61 = t8 * (t60 * t8 - Iu_3_t_d * w_1_3_x - hc_3_y * t30);
  const Scalar t62 = w_1_3_x * (t60 * w_1_3_x + Iu_3_t_d * t8 + hc_3_x * t30);
  const Scalar df_1_3_z = hc_3_y * t8 + hc_3_x * w_1_3_x;
  const Scalar c_1_4 = t61 - t62 - t30 * df_1_3_z;
  c[3] = c_1_4;
  c[63] = -db_11_4r;
  const Scalar t63 = Scalar(0.1738073182028717) * c_3_3 - s_3 * t32 - c_3 * Ic_3_yz;
  const Scalar hu_3_t_x = s_3 * hc_3_y + c_3 * hc_3_x;
  const Scalar mu_3_2_x = Scalar(0.1501) * hu_3_t_x + s_3 * Ic_3_yz - c_3 * t32;
  const Scalar t64 = s_2 * t63 - c_2 * mu_3_2_x;
  c[4] = t57 - t64;
  const Scalar c_2_1_3 = t57 + t64;
  c[24] = c_2_1_3;
  c[7] = -t58 - t59;
  c[64] = -c_2_1_4;
  const Scalar t65 = t5 * t51 - Scalar(0.5) * c_4 * c_1_5_5;
  const Scalar t66 = t65 - s_4 * (t52 * t18 - Scalar(0.00144) * w_1_3_x * t13);
  const Scalar t67 = Scalar(0.000029232) * s_4;
  const Scalar t68 = Scalar(0.000216144) * c_4 + t67;
  const Scalar t69 = t38 + t29;
  const Scalar mu_5_2_y = c_5 * (Scalar(0.000621792) * s_4 - c_3 * t68) + s_3 * t69;
  const Scalar mu_5_2_x = c_3 * t69 + t68 * t17;
  const Scalar t70 = s_2 * mu_5_2_y - c_2 * mu_5_2_x;
  const Scalar c_2_11 = t70 - t66;
  c[31] = c_2_11;
  const Scalar t71 = t65 - s_4 * (t10 * t52 - Scalar(0.5) * w_1_3_x * v_3_5_y);
  const Scalar t72 = Scalar(0.000216144) * t24 + t49 * t28 - t7 * t67;
  const Scalar c_3_11 = t72 - t71;
  c[52] = c_3_11;
  const Scalar Ic_2_xz = Scalar(0.000621792) * t5 + mu_3_2_x + Scalar(0.3451573495);
  c[2] = Scalar(-2.0) * (s_2 * (t63 + Scalar(0.0118755)) - c_2 * Ic_2_xz);
  c[42] = -c_1_4;
  c[43] = -c_2_1_3;
  c[11] = -t70 - t66;
  c[85] = -c_2_11;
  c[12] = -t72 - t71;
  c[87] = -c_3_11;
  const Scalar t73 = Scalar(-2.0) * (s_3 * t60 - c_3 * Iu_3_t_d);
  const Scalar t74 = Scalar(0.8636) * hu_3_t_x + Iu_3_t_d - c_3 * t73 + Scalar(0.800930601);
  const Scalar t75 = t60 - c_3_3 + s_3 * t73 - Scalar(0.0070992);
  const Scalar t76 = c_2 * (s_2 * t74 - c_2 * t75);
  const Scalar c_2_1 = t76 + s_2 * (s_2 * t75 + c_2 * t74);
  c[21] = c_2_1;
  c[1] = -c_2_1;
  c[0] = c[15] = c[20] = c[22] = c[23] = c[37] = c[38] = c[41] = Scalar(0.0);
  c[45] = c[46] = c[47] = c[58] = c[59] = c[62] = c[69] = c[70] = Scalar(0.0);
  c[71] = c[72] = c[77] = c[81] = c[83] = c[94] = c[95] = c[96] = Scalar(0.0);
  c[97] = c[98] = c[103] = c[104] = c[105] = c[107] = c[109] = c[110] = Scalar(0.0);
  c[114] = c[119] = c[120] = c[121] = c[122] = c[123] = c[124] = c[125] = Scalar(0.0);
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
// Reads q[1..4], qd[0..5]. Operations: 296 mul, 218 add, 8 sin/cos. Always zero: 2 of the 36
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
  const Scalar t1 = Scalar(0.00020216) * s_5;
  C[21] = c_5 * qd_5 * t1;
  const Scalar w_1_3_x = s_2 * c_3 + c_2 * s_3;
  const Scalar t2 = c_5 * w_1_3_x;
  const Scalar t3 = s_2 * s_3 - c_2 * c_3;
  const Scalar t4 = c_4 * s_5;
  const Scalar t5 = Scalar(0.00002) * t4;
  const Scalar t6 = Scalar(0.00002) * t2 - t3 * t5;
  const Scalar t7 = qd_1 * t6;
  const Scalar t8 = s_4 * c_5;
  const Scalar t9 = Scalar(0.00002) * qd_5;
  const Scalar t10 = t8 * t9 + qd_4 * t5;
  C[17] = t10 + t7;
  C[32] = t10 - t7;
  const Scalar t11 = s_4 * s_5;
  const Scalar t12 = t11 * w_1_3_x;
  const Scalar t13 = Scalar(0.00002) * qd_1 * t12;
  const Scalar t14 = Scalar(0.00002) * qd_2 + Scalar(0.00002) * qd_3;
  const Scalar t15 = t4 * t14;
  const Scalar t16 = s_5 * t9;
  C[33] = t15 - t16 + t13;
  const Scalar t17 = s_2 * (s_3 * t4 - c_3 * c_5);
  const Scalar t18 = s_3 * c_5;
  const Scalar mu_u_6_3_t_x = t18 + c_3 * t4;
  const Scalar t19 = Scalar(0.00002) * t17 - Scalar(0.00002) * c_2 * mu_u_6_3_t_x;
  const Scalar t20 = qd_1 * t19;
  C[11] = t10 - t20;
  C[23] = -t15 - t16 - t13;
  C[31] = t10 + t20;
  const Scalar t21 = c_4 * w_1_3_x;
  const Scalar t22 = s_5 * t3;
  const Scalar t23 = t22 - c_5 * t21;
  const Scalar t24 = qd_5 * t23 + qd_4 * t12;
  C[5] = C[30] = Scalar(0.00002) * t24 - qd_3 * t6 + qd_2 * t19;
  const Scalar C_56 = Scalar(0.00002) * (s_5 * qd_4 - qd_1 * t23) - t8 * t14;
  C[29] = C_56;
  const Scalar t25 = Scalar(0.000621792) * s_3;
  const Scalar v_o_2_4_x = t25 + Scalar(0.000623664);
  const Scalar t26 = Scalar(0.000621792) * c_3;
  const Scalar v_o_2_4_y = t26 - Scalar(0.000029232);
  const Scalar t27 = t4 * v_o_2_4_x - c_5 * v_o_2_4_y;
  const Scalar t28 = Scalar(0.00010108) * c_5;
  const Scalar t29 = t28 + v_o_2_4_x;
  const Scalar t30 = s_4 * t11 * t29 + c_4 * t27;
  const Scalar t31 = Scalar(2.0) * qd_5;
  const Scalar t32 = c_5 * t28;
  const Scalar Iu_4_t_d = t32 - Scalar(0.00015108);
  const Scalar t33 = c_4 * Iu_4_t_d;
  const Scalar t34 = t33 - s_5 * v_o_2_4_y;
  const Scalar t35 = s_4 * t34;
  const Scalar t36 = Scalar(2.0) * qd_4;
  const Scalar hc_3_x = Scalar(0.00144) * t4 - Scalar(0.0126875);
  const Scalar hc_3_y = Scalar(0.00144) * c_5 + Scalar(0.4308975);
  const Scalar t37 = Scalar(0.8636) * s_3 * hc_3_x - Scalar(0.8636) * c_3 * hc_3_y;
  const Scalar t38 = qd_3 * t37;
  C[7] = t35 * t36 - t30 * t31 - t38;
  const Scalar dmu_3_4_x = Scalar(0.000029232) * s_5 + t33;
  const Scalar t39 = s_4 * dmu_3_4_x;
  const Scalar t40 = t28 + Scalar(0.000623664);
  const Scalar t41 = t40 * t11;
  const Scalar t42 = Scalar(0.000058464) * c_5;
  const Scalar v_3_5_y = Scalar(0.001247328) * t4 + t42;
  const Scalar db_33_5r = Scalar(2.0) * s_4 * t41 + c_4 * v_3_5_y;
  C[14] = t39 * t36 - qd_5 * db_33_5r;
  C[34] = -C_56;
  const Scalar Ic_4_zz = t32 - Scalar(0.00092108);
  const Scalar mu_4_3_y = Ic_4_zz + Scalar(0.000029232) * t4;
  const Scalar t43 = Scalar(0.000216144) * t11 - mu_4_3_y;
  const Scalar t44 = t4 * t40;
  const Scalar t45 = t44 * t3;
  const Scalar t46 = w_1_3_x * t43 + t45;
  const Scalar t47 = s_4 * w_1_3_x;
  const Scalar t48 = Scalar(0.000216144) * s_5;
  const Scalar t49 = w_1_3_x * t48;
  const Scalar t50 = Iu_4_t_d * t47 - t49;
  const Scalar t51 = s_4 * t50;
  const Scalar t52 = t45 + t51 - dmu_3_4_x * t21;
  const Scalar t53 = t46 + t52;
  const Scalar db_23_4r = t39 + t35;
  const Scalar t54 = t11 * t26;
  const Scalar c_3_2_4 = db_23_4r + t54;
  const Scalar t55 = Scalar(2.0) * qd_3;
  const Scalar t56 = Scalar(0.00002) * qd_6;
  const Scalar t57 = t4 * t56;
  const Scalar t58 = t57 + qd_1 * t53 + t39 * t55 + qd_2 * c_3_2_4;
  const Scalar t59 = s_4 * (s_5 * t1 - Scalar(0.00010108));
  const Scalar t60 = Scalar(0.000623664) * t8;
  const Scalar db_34_5r = t60 - t59;
  const Scalar t61 = Scalar(0.00032108) * s_4;
  const Scalar db_35_4 = t61 + t60;
  const Scalar c_3_4_5 = db_35_4 + db_34_5r;
  C[15] = t58 - qd_5 * c_3_4_5 - t44 * t36;
  const Scalar t62 = Scalar(0.4318) * c_2;
  const Scalar v_o_1_4_z = Scalar(0.4331) * w_1_3_x + Scalar(0.0203) * t3 + t62;
  const Scalar t63 = Scalar(0.000216144) * s_4 * t3 - Scalar(0.00144) * c_4 * v_o_1_4_z;
  const Scalar t64 = t63 + Scalar(0.00010108) * t23;
  const Scalar t65 = t4 * w_1_3_x + c_5 * t3;
  const Scalar t66 = Scalar(0.00010108) * s_5;
  const Scalar t67 = c_5 * t64 + t65 * t66;
  const Scalar t68 = Scalar(0.00032108) * t21 - c_5 * t63;
  const Scalar t69 = t68 + t67;
  const Scalar c_4_3_5 = db_35_4 - db_34_5r;
  const Scalar t70 = v_o_2_4_x * t8;
  const Scalar db_24_5r = t70 - t59;
  const Scalar db_25_4 = t70 + t61;
  const Scalar c_4_2_5 = db_25_4 - db_24_5r;
  const Scalar t71 = t1 * (Scalar(0.09893153937475267) * qd_6 - c_5 * qd_4);
  const Scalar C_54 = t71 - qd_3 * c_4_3_5 - qd_2 * c_4_2_5 + qd_1 * t69;
  C[27] = C_54;
  C[20] = qd_5 * c_4_3_5 - t58;
  C[22] = -C_54;
  const Scalar dmu_1_4_y = Iu_4_t_d * t21 - t28 * t22;
  const Scalar t72 = w_1_3_x * (c_4 * (t49 - t50) - s_4 * dmu_1_4_y);
  const Scalar t73 = s_4 * v_o_1_4_z + Scalar(0.1501) * c_4 * t3;
  const Scalar t74 = w_1_3_x * t8;
  const Scalar t75 = Scalar(14.246141669964384) * t73 + t74;
  const Scalar t76 = s_5 * t73;
  const Scalar t77 = t72 + t3 * (Scalar(0.00144) * t76 + t75 * t66);
  const Scalar t78 = t12 * t56 + qd_1 * t77;
  const Scalar mu_4_2_y = t4 * (s_3 * t40 + Scalar(0.000621792)) + c_3 * t43;
  const Scalar t79 = s_2 * mu_4_2_y + c_2 * (s_3 * t43 - c_3 * t44);
  const Scalar t80 = c_4 * (w_1_3_x * t34 - t22 * t29) - t51;
  const Scalar t81 = t79 + t80;
  const Scalar t82 = t68 - t67;
  const Scalar t83 = t46 - t52;
  C[3] = t78 + qd_5 * t82 - qd_4 * t75 * t1 - qd_3 * t83 - qd_2 * t81;
  const Scalar t84 = Scalar(0.00288) * t76 - Scalar(0.000432288) * t2;
  const Scalar t85 = t11 * t64 + Scalar(0.5) * c_4 * t84;
  const Scalar t86 = t85 - s_4 * (t40 * t65 - Scalar(0.5) * w_1_3_x * v_3_5_y);
  const Scalar t87 = Scalar(0.000216144) * t23 - Scalar(0.000029232) * t74 + t3 * db_35_4;
  const Scalar t88 = t87 + t86;
  const Scalar t89 = t85 - s_4 * (t65 * t29 - w_1_3_x * t27);
  const Scalar mu_5_2_x = c_3 * (t48 + db_35_4) +
      Scalar(0.000029232) * (Scalar(7.394088669950739) * c_4 + s_4) * t18;
  const Scalar t90 = c_4 * c_5 * t26 - s_5 * t25;
  const Scalar t91 = Scalar(0.3476146364057434) * t90 +
      Scalar(0.000029232) * t8 * (c_3 - Scalar(21.27093596059113)) - s_3 * db_35_4;
  const Scalar t92 = s_2 * t91 + c_2 * mu_5_2_x;
  const Scalar t93 = t92 - t89;
  const Scalar t94 = Scalar(2.0) * t65 * t64 - t84 * t47;
  const Scalar t95 = t23 * t56 + qd_1 * t94;
  C[4] = t95 - qd_5 * t84 + qd_4 * t82 - qd_3 * t88 + qd_2 * t93;
  const Scalar t96 = t79 - t80;
  const Scalar t97 = Scalar(2.0) * qd_2;
  const Scalar t98 = t35 * t97 + t57 + qd_1 * t96;
  const Scalar t99 = db_23_4r - t54;
  const Scalar c_2_4_5 = db_25_4 + db_24_5r;
  C[9] = t98 - qd_5 * c_2_4_5 - t4 * t29 * t36 + qd_3 * t99;
  const Scalar Iu_3_t_d = Scalar(0.001247328) * c_5 + Ic_4_zz +
      c_4 * (Scalar(0.000058464) * s_5 + t33) + Scalar(0.150108592);
  const Scalar t100 = Scalar(2.0) * t44 - t42 - Scalar(0.0106736385);
  const Scalar t101 = t3 * (t100 * t3 - Iu_3_t_d * w_1_3_x - hc_3_y * t62);
  const Scalar t102 = w_1_3_x * (t100 * w_1_3_x + Iu_3_t_d * t3 + hc_3_x * t62);
  const Scalar df_1_3_z = hc_3_y * t3 + hc_3_x * w_1_3_x;
  const Scalar t103 = t101 - t102 - t62 * df_1_3_z;
  const Scalar t104 = qd_6 * t6 - qd_1 * t103;
  const Scalar t105 = t87 - t86;
  const Scalar Ic_3_yz = t41 + Scalar(0.002352);
  const Scalar t106 = Scalar(0.1738073182028717) * t37 - s_3 * t39 - c_3 * Ic_3_yz;
  const Scalar hu_3_t_x = s_3 * hc_3_y + c_3 * hc_3_x;
  const Scalar mu_3_2_x = Scalar(0.1501) * hu_3_t_x + s_3 * Ic_3_yz - c_3 * t39;
  const Scalar t107 = s_2 * t106 - c_2 * mu_3_2_x;
  const Scalar t108 = w_1_3_x * (Scalar(0.1501) * hc_3_y + Ic_3_yz) -
      t3 * (Scalar(0.1501) * hc_3_x - t39);
  const Scalar t109 = t108 + t107;
  C[12] = t104 + qd_5 * t105 + qd_4 * t53 - qd_2 * t109;
  const Scalar t110 = qd_2 * t37 - qd_1 * t109;
  const Scalar t111 = t30 + Scalar(0.5) * db_33_5r;
  const Scalar t112 = t90 + t111;
  C[13] = t110 - qd_5 * t112 + qd_4 * c_3_2_4;
  const Scalar t113 = t8 * t56;
  const Scalar t114 = t113 + qd_1 * t105 - qd_3 * db_33_5r - qd_2 * t112;
  C[16] = t114 - qd_5 * v_3_5_y - qd_4 * c_3_4_5;
  C[18] = -t78 - qd_5 * t69 - qd_3 * t53 - qd_2 * t96;
  C[19] = qd_5 * c_4_2_5 - t98 - qd_3 * c_3_2_4;
  const Scalar t115 = t92 + t89;
  C[24] = qd_4 * t69 - t95 - qd_3 * t105 + qd_2 * t115;
  const Scalar t116 = t30 * t97 - t113 + qd_1 * t115;
  C[25] = t116 - qd_4 * c_4_2_5 + qd_3 * t112;
  const Scalar t117 = t108 - t107;
  const Scalar t118 = t104 + qd_5 * t88 + qd_4 * t83 - t108 * t55 - qd_2 * t117;
  C[2] = -t118;
  const Scalar t119 = t90 - t111;
  C[8] = qd_5 * t119 - t38 - t110 + qd_4 * t99;
  C[10] = qd_3 * t119 - t116 - t27 * t31 - qd_4 * c_2_4_5;
  C[26] = -t114 - qd_4 * c_4_3_5;
  const Scalar t120 = Scalar(-2.0) * (s_3 * t100 - c_3 * Iu_3_t_d);
  const Scalar t121 = Scalar(0.8636) * hu_3_t_x + Iu_3_t_d - c_3 * t120 + Scalar(0.800930601);
  const Scalar t122 = t100 - t37 + s_3 * t120 - Scalar(0.0070992);
  const Scalar t123 = c_2 * (s_2 * t121 - c_2 * t122);
  const Scalar t124 = t123 + s_2 * (s_2 * t122 + c_2 * t121);
  C[0] = qd_5 * t94 + qd_4 * t77 + qd_3 * t103 - qd_2 * t124;
  const Scalar t125 = qd_6 * t19 - qd_1 * t124;
  const Scalar Ic_2_xz = Scalar(0.000621792) * t11 + mu_3_2_x + Scalar(0.3451573495);
  const Scalar t126 = (s_2 * (t106 + Scalar(0.0118755)) - c_2 * Ic_2_xz) * t97;
  C[1] = t125 + qd_5 * t93 - qd_4 * t81 + qd_3 * t117 - t126;
  C[6] = qd_4 * t96 - t125 - qd_5 * t115 + qd_3 * t109;
  C[28] = C[35] = Scalar(0.0);
}

// gravity torques g(q) (7.39).
//   q[6]  in   joint positions, rad or m
//   g[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..4]. Operations: 25 mul, 11 add, 8 sin/cos. Always zero: g[5].
template <class Scalar>
inline void gravity(const Scalar* q, Scalar* g) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar s_4 = sin(q_4), c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar t1 = Scalar(0.0282528) * c_2;
  const Scalar t2 = Scalar(0.0282528) * s_2;
  const Scalar ddp_3_x = s_3 * t1 + c_3 * t2;
  const Scalar t3 = s_4 * s_5;
  const Scalar mu_u_5_a_z = ddp_3_x * t3;
  g[3] = mu_u_5_a_z;
  const Scalar t4 = s_3 * t2 - c_3 * t1;
  const Scalar N_5_z = s_5 * t4 - c_4 * c_5 * ddp_3_x;
  g[4] = N_5_z;
  const Scalar t5 = c_4 * N_5_z - ddp_3_x * (s_4 * s_4 * c_5 + Scalar(299.234375));
  const Scalar t6 = Scalar(8.81076388888889) * t4 - t5;
  g[2] = -t6;
  const Scalar t7 = t4 * t3;
  const Scalar mu_u_3_t_y = s_3 * t7 + c_3 * mu_u_5_a_z;
  g[0] = c_2 * mu_u_3_t_y - s_2 * (s_3 * mu_u_5_a_z - c_3 * t7);
  g[1] = Scalar(1.024164) * s_2 - Scalar(37.2347379) * c_2 - t6;
  g[5] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   n[6]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5], qd[0..5]. Operations: 172 mul, 121 add, 10 sin/cos.
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
  const Scalar t1 = qd_1 * (s_2 * c_3 + c_2 * s_3);
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_r_4_y = c_4 * omega_3_z + s_4 * t1;
  const Scalar t2 = qd_1 * (c_2 * c_3 - s_2 * s_3);
  const Scalar t3 = omega_3_z * t2;
  const Scalar t4 = c_4 * t3 - qd_4 * omega_r_4_y;
  const Scalar t5 = c_4 * t1 - s_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 + t2;
  const Scalar omega_r_5_x = c_5 * t5 + s_5 * omega_4_z;
  const Scalar t6 = omega_3_z * t1;
  const Scalar domega_5_y = c_5 * t6 + s_5 * t4 + qd_5 * omega_r_5_x;
  const Scalar t7 = Scalar(0.00004) * domega_5_y;
  n[5] = Scalar(0.2158232532732) * qd_6 + Scalar(0.55443978) * detail::sign(qd_6) - t7;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar t8 = c_6 * omega_r_5_x - s_6 * omega_5_z;
  const Scalar omega_r_6_y = c_6 * omega_5_z + s_6 * omega_r_5_x;
  const Scalar omega_r_5_y = c_5 * omega_4_z - s_5 * t5;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t9 = Scalar(0.00004) * omega_6_z;
  const Scalar t10 = t9 * (c_6 * t8 + s_6 * omega_r_6_y);
  const Scalar t11 = c_2 * qd_1;
  const Scalar t12 = qd_2 * qd_2;
  const Scalar U_2_xx = t11 * t11 + t12;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 + Scalar(0.4318) * U_2_xx;
  const Scalar t13 = s_2 * qd_1;
  const Scalar t14 = t11 * t13;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.4318) * t14;
  const Scalar ddp_3_x = c_3 * ddp_o_3_x + s_3 * ddp_o_3_y;
  const Scalar t15 = t2 * t2;
  const Scalar t16 = omega_3_z * omega_3_z;
  const Scalar U_3_xx = t15 + t16;
  const Scalar t17 = t2 * t1;
  const Scalar ddp_o_4_x = ddp_3_x - Scalar(0.0203) * U_3_xx + Scalar(0.4331) * t17;
  const Scalar t18 = qd_2 * t13;
  const Scalar t19 = qd_1 * qd_1;
  const Scalar ddp_o_3_z = Scalar(0.1501) * t19 + Scalar(0.8636) * t18;
  const Scalar ddp_o_4_z = ddp_o_3_z - Scalar(0.0406) * t6 - Scalar(0.8662) * t3;
  const Scalar ddp_4_x = c_4 * ddp_o_4_x + s_4 * ddp_o_4_z;
  const Scalar t20 = c_3 * ddp_o_3_y - s_3 * ddp_o_3_x;
  const Scalar U_3_yy = t16 + t1 * t1;
  const Scalar t21 = c_5 * ddp_4_x + s_5 * (t20 - Scalar(0.4331) * U_3_yy + Scalar(0.0203) * t17);
  const Scalar t22 = omega_r_5_x * omega_r_5_y;
  const Scalar t23 = s_4 * t3 + qd_4 * t5;
  const Scalar t24 = Scalar(0.00064216) * t23 - Scalar(0.00288) * t21 - Scalar(0.00024216) * t22 +
      t10;
  n[4] = Scalar(0.4272830209354) * qd_5 + t24 + Scalar(0.85444524) * detail::sign(qd_5);
  const Scalar t25 = (c_6 * omega_r_6_y - s_6 * t8) * t9;
  const Scalar t26 = c_4 * ddp_o_4_z - s_4 * ddp_o_4_x;
  const Scalar domega_5_x = c_5 * t4 - s_5 * t6 + qd_5 * omega_r_5_y;
  const Scalar t27 = omega_r_5_y * omega_5_z;
  const Scalar t28 = Scalar(0.00288) * t26 - Scalar(0.00024216) * domega_5_x -
      Scalar(0.00064216) * t27 + t25;
  const Scalar mu_5_y = t7 + Scalar(0.0004) * omega_r_5_x * omega_5_z;
  const Scalar mu_4_z = Scalar(0.0016) * t6 - Scalar(0.0003) * t5 * omega_r_4_y + c_5 * mu_5_y +
      s_5 * t28;
  n[3] = Scalar(0.411645229697152) * qd_4 - mu_4_z + Scalar(1.06831142) * detail::sign(qd_4);
  const Scalar t29 = Scalar(0.0003) * t4 - Scalar(0.0016) * omega_r_4_y * omega_4_z - c_5 * t28 +
      s_5 * mu_5_y;
  const Scalar t30 = t24 + Scalar(0.0013) * t5 * omega_4_z;
  const Scalar t31 = t23 - t22;
  const Scalar t32 = Scalar(0.00288) * c_5;
  const Scalar U_5_yy = omega_r_5_x * omega_r_5_x + omega_5_z * omega_5_z;
  const Scalar t33 = Scalar(0.00288) * s_5;
  const Scalar t34 = t31 * t32 - U_5_yy * t33;
  const Scalar U_5_zy = domega_5_x + t27;
  const Scalar t35 = Scalar(0.00288) * U_5_zy;
  const Scalar t36 = c_4 * t34 - s_4 * t35;
  const Scalar t37 = U_5_yy * t32 + t31 * t33;
  const Scalar U_3_xx_yy = U_3_xx - U_3_yy;
  const Scalar mu_3_z = Scalar(0.861795) * ddp_3_x - Scalar(0.025375) * t20 +
      Scalar(0.299575024) * t17 - Scalar(0.0106736385) * U_3_xx_yy + Scalar(0.0203) * t37 -
      Scalar(0.4331) * t36 - c_4 * t30 + s_4 * t29;
  n[2] = Scalar(3.9804259903722) * qd_3 - mu_3_z + Scalar(6.36419655) * detail::sign(qd_3);
  const Scalar t38 = Scalar(0.025375) * U_3_xx - Scalar(0.861795) * t17 + t36;
  const Scalar t39 = Scalar(0.861795) * U_3_yy - Scalar(0.025375) * t17 + t37;
  const Scalar t40 = c_3 * t39 + s_3 * t38;
  const Scalar U_2_yy = t12 + t13 * t13;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  const Scalar t41 = Scalar(37.2347379) * c_2 - Scalar(1.024164) * s_2 -
      Scalar(9.496868641825) * qd_2 - Scalar(1.601861202) * t14 - Scalar(0.0070992) * U_2_xx_yy +
      mu_3_z - Scalar(0.4318) * t40 - Scalar(10.6197775) * detail::sign(qd_2);
  n[1] = -t41;
  const Scalar t42 = c_4 * t35 + s_4 * t34;
  const Scalar mu_3_x = Scalar(0.861795) * ddp_o_3_z - Scalar(0.021347277) * t6 -
      Scalar(0.612680273) * t3 + Scalar(0.004704) * (t15 - t16) - Scalar(0.4331) * t42 - c_4 * t29 -
      s_4 * t30;
  const Scalar mu_3_y = Scalar(0.025375) * ddp_o_3_z + Scalar(0.004704) * t17 -
      Scalar(0.013530225) * t6 - Scalar(0.021347277) * t3 - mu_4_z - Scalar(0.0203) * t42;
  const Scalar t43 = c_3 * t38 - s_3 * t39;
  const Scalar t44 = qd_2 * t11;
  const Scalar mu_2_y = Scalar(0.023751) * t14 + Scalar(3.349975204) * t18 -
      Scalar(0.02191385) * t6 - Scalar(0.744246162) * t3 - Scalar(0.690314699) * (U_2_xx - t19) -
      Scalar(0.4318) * t42 + Scalar(0.1501) * t43 + Scalar(0.0141984) * t44 - c_3 * mu_3_y +
      s_3 * mu_3_x;
  const Scalar mu_2_x = Scalar(0.690314699) * t14 + Scalar(0.0141984) * t18 -
      Scalar(0.023751) * (U_2_yy - t19) + Scalar(0.1501) * t40 - c_3 * mu_3_x - s_3 * mu_3_y +
      Scalar(0.1462528) * t44;
  n[0] = Scalar(5.8018217679508) * qd_1 + Scalar(25.9836065) * detail::sign(qd_1) - c_2 * mu_2_y +
      s_2 * mu_2_x;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   tau[6]  in   joint torques or forces, N m or N
//   qdd[6]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns true, or false if the result means nothing: a pivot was not positive, or an input not a
// number.
// Reads q[1..5], qd[0..5], tau[0..5]. Operations: 322 mul, 241 add, 4 div, 10 sin/cos.
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
  const Scalar t1 = qd_1 * (s_2 * c_3 + c_2 * s_3);
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t2 = c_4 * t1 - s_4 * omega_3_z;
  const Scalar t3 = qd_1 * (c_2 * c_3 - s_2 * s_3);
  const Scalar omega_4_z = qd_4 + t3;
  const Scalar omega_r_5_x = c_5 * t2 + s_5 * omega_4_z;
  const Scalar omega_r_4_y = c_4 * omega_3_z + s_4 * t1;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar omega_r_6_y = c_6 * omega_5_z + s_6 * omega_r_5_x;
  const Scalar t4 = c_6 * omega_r_5_x - s_6 * omega_5_z;
  const Scalar omega_r_5_y = c_5 * omega_4_z - s_5 * t2;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t5 = Scalar(0.00004) * omega_6_z;
  const Scalar t6 = (c_6 * omega_r_6_y - s_6 * t4) * t5;
  const Scalar t7 = c_2 * qd_1;
  const Scalar t8 = qd_2 * qd_2;
  const Scalar U_2_xx = t7 * t7 + t8;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 + Scalar(0.4318) * U_2_xx;
  const Scalar t9 = s_2 * qd_1;
  const Scalar t10 = t7 * t9;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.4318) * t10;
  const Scalar ddp_3_x = c_3 * ddp_o_3_x + s_3 * ddp_o_3_y;
  const Scalar t11 = t3 * t3;
  const Scalar t12 = omega_3_z * omega_3_z;
  const Scalar U_3_xx = t11 + t12;
  const Scalar t13 = t3 * t1;
  const Scalar ddp_o_4_x = ddp_3_x - Scalar(0.0203) * U_3_xx + Scalar(0.4331) * t13;
  const Scalar t14 = omega_3_z * t1;
  const Scalar t15 = omega_3_z * t3;
  const Scalar t16 = qd_2 * t9;
  const Scalar t17 = qd_1 * qd_1;
  const Scalar ddp_o_3_z = Scalar(0.1501) * t17 + Scalar(0.8636) * t16;
  const Scalar ddp_o_4_z = ddp_o_3_z - Scalar(0.0406) * t14 - Scalar(0.8662) * t15;
  const Scalar t18 = c_4 * ddp_o_4_z - s_4 * ddp_o_4_x;
  const Scalar t19 = Scalar(0.00288) * t18 - Scalar(0.00088432) * omega_r_5_y * omega_5_z + t6;
  const Scalar t20 = c_4 * t15 - qd_4 * omega_r_4_y;
  const Scalar domega_5_y = c_5 * t14 + s_5 * t20 + qd_5 * omega_r_5_x;
  const Scalar t21 = Scalar(0.00020216) * domega_5_y - Scalar(0.00064216) * omega_r_5_x * omega_5_z;
  const Scalar mu_4_x = Scalar(0.00238432) * omega_r_4_y * omega_4_z + c_5 * t19 + s_5 * t21;
  const Scalar y_6 = tau_6 - Scalar(0.2158232532732) * qd_6 + Scalar(0.00004) * domega_5_y -
      Scalar(0.55443978) * detail::sign(qd_6);
  const Scalar t22 = s_4 * (mu_4_x + Scalar(0.00019430115597482132) * s_5 * y_6);
  const Scalar t23 = t5 * (c_6 * t4 + s_6 * omega_r_6_y);
  const Scalar ddp_4_x = c_4 * ddp_o_4_x + s_4 * ddp_o_4_z;
  const Scalar t24 = c_3 * ddp_o_3_y - s_3 * ddp_o_3_x;
  const Scalar U_3_yy = t12 + t1 * t1;
  const Scalar t25 = c_5 * ddp_4_x + s_5 * (t24 - Scalar(0.4331) * U_3_yy + Scalar(0.0203) * t13);
  const Scalar t26 = omega_r_5_x * omega_r_5_y;
  const Scalar t27 = s_4 * t15 + qd_4 * t2;
  const Scalar t28 = Scalar(0.00064216) * t27 - Scalar(0.00288) * t25 - Scalar(0.00024216) * t26 +
      t23;
  const Scalar t29 = Scalar(0.00054216) * t27 - t28 - Scalar(0.00184216) * t2 * omega_4_z;
  const Scalar t30 = t27 - t26;
  const Scalar t31 = Scalar(0.00288) * c_5;
  const Scalar U_5_yy = omega_r_5_x * omega_r_5_x + omega_5_z * omega_5_z;
  const Scalar t32 = Scalar(0.00288) * s_5;
  const Scalar t33 = t30 * t31 - U_5_yy * t32;
  const Scalar U_5_zy = c_5 * t20 - s_5 * t14 + omega_r_5_y * (qd_5 + omega_5_z);
  const Scalar t34 = Scalar(0.00288) * U_5_zy;
  const Scalar t35 = c_4 * t33 - s_4 * t34;
  const Scalar t36 = U_5_yy * t31 + t30 * t32;
  const Scalar U_3_xx_yy = U_3_xx - U_3_yy;
  const Scalar t37 = Scalar(0.861795) * ddp_3_x - Scalar(0.025375) * t24 +
      Scalar(0.300117184) * t13 - Scalar(0.0106736385) * U_3_xx_yy + Scalar(0.0203) * t36 -
      Scalar(0.4331) * t35 + c_4 * t29 - t22;
  const Scalar mu_4_z = Scalar(0.00184216) * t14 - Scalar(0.00054216) * t2 * omega_r_4_y -
      c_5 * t21 + s_5 * t19;
  const Scalar t38 = Scalar(0.00019430115597482132) * c_5;
  const Scalar y_6_4 = tau_4 - Scalar(0.411645229697152) * qd_4 + mu_4_z -
      Scalar(1.06831142) * detail::sign(qd_4) - y_6 * t38;
  const Scalar t39 = Scalar(0.00020216) * c_5;
  const Scalar t40 = t39 + Scalar(0.001247328);
  const Scalar t41 = s_4 * s_5;
  const Scalar t42 = t40 * t41;
  const Scalar t43 = Scalar(7.772046238992852e-09) * t41;
  const Scalar b_6_4_3 = t42 + c_5 * t43;
  const Scalar b_6_4_4 = Scalar(0.00020216777204623898) * c_5 * c_5 - Scalar(0.2041958543736);
  const Scalar d_4 = Scalar(1.0) / b_6_4_4;
  const Scalar t44 = b_6_4_3 * d_4;
  const Scalar y_5 = tau_5 - Scalar(0.4272830209354) * qd_5 - t28 -
      Scalar(0.85444524) * detail::sign(qd_5);
  const Scalar t45 = Scalar(0.001247328) * c_5 + Scalar(0.00064216);
  const Scalar t46 = Scalar(0.000058464) * s_5;
  const Scalar t47 = t46 - c_4 * t45;
  const Scalar t48 = Scalar(5.5037503582353615) * t47;
  const Scalar y_4_3 = tau_3 - Scalar(3.9804259903722) * qd_3 -
      Scalar(6.36419655) * detail::sign(qd_3) + t37 + y_5 * t48 - t44 * y_6_4;
  const Scalar t49 = c_5 * t39;
  const Scalar Iu_5_t_xx = t49 - Scalar(0.00020216);
  const Scalar Iu_4_t_d = Iu_5_t_xx - Scalar(0.0001);
  const Scalar t50 = c_4 * Iu_4_t_d;
  const Scalar t51 = c_4 * t50;
  const Scalar t52 = c_4 * s_5;
  const Scalar t53 = Scalar(0.000116928) * t52;
  const Scalar t54 = Scalar(0.002494656) * c_5;
  const Scalar t55 = Iu_5_t_xx - t53 - t51 + t54 - t41 * t43 + Scalar(0.313647409);
  const Scalar b_4_3_3 = t55 - t47 * t48 + b_6_4_3 * t44 + Scalar(0.86242563124731);
  const Scalar d_3 = Scalar(1.0) / b_4_3_3;
  const Scalar t56 = Scalar(0.001243584) * t41;
  const Scalar b_6_4_2 = b_6_4_3 + s_3 * t56;
  const Scalar f_u_5_3_t_y = c_3 * t32 + s_3 * c_4 * t31;
  const Scalar t57 = t47 - Scalar(0.4318) * f_u_5_3_t_y;
  const Scalar hc_3_x = Scalar(0.00288) * t52 - Scalar(0.025375);
  const Scalar hc_3_y = t31 + Scalar(0.861795);
  const Scalar hu_3_t_x = c_3 * hc_3_x + s_3 * hc_3_y;
  const Scalar b_4_3_2 = Scalar(0.4318) * hu_3_t_x + t55 - t57 * t48 + b_6_4_2 * t44;
  const Scalar t58 = b_4_3_2 * d_3;
  const Scalar t59 = b_6_4_2 * d_4;
  const Scalar t60 = Scalar(0.025375) * U_3_xx - Scalar(0.861795) * t13 + t35;
  const Scalar t61 = Scalar(0.861795) * U_3_yy - Scalar(0.025375) * t13 + t36;
  const Scalar t62 = c_3 * t61 + s_3 * t60;
  const Scalar t63 = Scalar(5.5037503582353615) * t57;
  const Scalar U_2_yy = t8 + t9 * t9;
  const Scalar U_2_xx_yy = U_2_xx - U_2_yy;
  const Scalar y_3_2 = Scalar(37.2347379) * c_2 - Scalar(1.024164) * s_2 -
      Scalar(9.496868641825) * qd_2 + tau_2 - Scalar(1.601861202) * t10 -
      Scalar(0.0070992) * U_2_xx_yy - Scalar(0.4318) * t62 -
      Scalar(10.6197775) * detail::sign(qd_2) + t37 + y_5 * t63 - t59 * y_6_4 - t58 * y_4_3;
  const Scalar t64 = s_4 * (t50 + t46);
  const Scalar Ic_3_yz = t42 + Scalar(0.004704);
  const Scalar t65 = c_3 * hc_3_y - s_3 * hc_3_x;
  const Scalar t66 = Scalar(0.1501) * t65 + c_3 * Ic_3_yz + s_3 * t64;
  const Scalar mu_3_2_x = Scalar(0.1501) * hu_3_t_x - c_3 * t64 + s_3 * Ic_3_yz;
  const Scalar Ic_4_zz = t49 - Scalar(0.00184216);
  const Scalar t67 = Ic_4_zz + Scalar(0.000058464) * t52 - Scalar(0.000432288) * t41;
  const Scalar t68 = c_2 * (c_3 * t67 - t52 * (s_3 * t40 + Scalar(0.001243584)));
  const Scalar t69 = t52 * t40;
  const Scalar t70 = Scalar(0.00004) * c_3;
  const Scalar t71 = Scalar(0.00004) * s_3;
  const Scalar mu_u_6_3_t_x = t52 * t70 + c_5 * t71;
  const Scalar t72 = c_2 * (c_5 * t70 - t52 * t71) - s_2 * mu_u_6_3_t_x;
  const Scalar t73 = t68 - s_2 * (c_3 * t69 + s_3 * t67) + t72 * t38;
  const Scalar t74 = c_5 * (s_4 - Scalar(0.04701250578971746) * c_3 *
      (Scalar(7.394088669950739) * c_4 + s_4));
  const Scalar mu_5_2_y = s_3 * (Scalar(0.000432288) * s_5 + s_4 * t45) + Scalar(0.001243584) * t74;
  const Scalar t75 = Scalar(0.000058464) * c_5;
  const Scalar mu_5_2_x = Scalar(0.1501) * f_u_5_3_t_y + s_4 * (s_3 * t75 + c_3 * t45);
  const Scalar mu_u_5_2_t_y = c_2 * mu_5_2_y + s_2 * mu_5_2_x;
  const Scalar t76 = Scalar(-0.00019430115597482132) * t41 * t72;
  const Scalar b_4_3_1 = c_2 * t66 - s_2 * mu_3_2_x - t76 - mu_u_5_2_t_y * t48 - t73 * t44;
  const Scalar Ic_2_xz = mu_3_2_x + t56 + Scalar(0.690314699);
  const Scalar t77 = t76 - c_2 * (t66 - Scalar(0.023751)) + s_2 * Ic_2_xz + mu_u_5_2_t_y * t63 +
      t73 * t59 + b_4_3_1 * t58;
  const Scalar t78 = Scalar(0.8636) * hu_3_t_x;
  const Scalar b_3_2_2 = t78 + t55 - t57 * t63 + b_6_4_2 * t59 - b_4_3_2 * t58 +
      Scalar(6.502360360025);
  const Scalar d_2 = Scalar(1.0) / b_3_2_2;
  const Scalar t79 = t77 * d_2;
  const Scalar t80 = c_4 * t34 + s_4 * t33;
  const Scalar mu_3_x = Scalar(0.861795) * ddp_o_3_z - Scalar(0.021347277) * t14 -
      Scalar(0.613764593) * t15 + Scalar(0.004704) * (t11 - t12) - Scalar(0.4331) * t80 +
      c_4 * mu_4_x + s_4 * t29;
  const Scalar mu_3_y = Scalar(0.025375) * ddp_o_3_z + Scalar(0.004704) * t13 -
      Scalar(0.013530225) * t14 - Scalar(0.021347277) * t15 - mu_4_z - Scalar(0.0203) * t80;
  const Scalar t81 = c_3 * t60 - s_3 * t61;
  const Scalar t82 = qd_2 * t7;
  const Scalar mu_2_y = Scalar(0.023751) * t10 + Scalar(3.349975204) * t16 -
      Scalar(0.02191385) * t14 - Scalar(0.744246162) * t15 - Scalar(0.690314699) * (U_2_xx - t17) -
      Scalar(0.4318) * t80 + Scalar(0.1501) * t81 + Scalar(0.0141984) * t82 - c_3 * mu_3_y +
      s_3 * mu_3_x;
  const Scalar mu_2_x = Scalar(0.690314699) * t10 + Scalar(0.0141984) * t16 -
      Scalar(0.023751) * (U_2_yy - t17) + Scalar(0.1501) * t62 - c_3 * mu_3_x - s_3 * mu_3_y +
      Scalar(0.1462528) * t82;
  const Scalar t83 = b_4_3_1 * d_3;
  const Scalar t84 = t73 * d_4;
  const Scalar t85 = Scalar(5.5037503582353615) * mu_u_5_2_t_y;
  const Scalar t86 = Scalar(-4.857528899370533) * t72;
  const Scalar y_2_1 = tau_1 - Scalar(5.8018217679508) * qd_1 -
      Scalar(25.9836065) * detail::sign(qd_1) + c_2 * mu_2_y - s_2 * mu_2_x + y_6 * t86 -
      y_5 * t85 - t84 * y_6_4 + t83 * y_4_3 - t79 * y_3_2;
  const Scalar Ic_3_yy = Ic_4_zz + t53 + Scalar(0.300117184);
  const Scalar Iu_3_t_d = Ic_3_yy + t51 + t54 + Scalar(0.0001);
  const Scalar t87 = t69 - t75 - Scalar(0.0106736385);
  const Scalar Iu_3_t_g = c_3 * Iu_3_t_d - Scalar(2.0) * s_3 * t87;
  const Scalar t88 = c_3 * Iu_3_t_g;
  const Scalar t89 = s_2 * (t87 + Scalar(0.4318) * t65 + s_3 * Iu_3_t_g - Scalar(0.0070992));
  const Scalar t90 = c_2 * (Iu_3_t_d - Scalar(2.0) * t88 + t78 + Scalar(1.601861202)) +
      Scalar(2.0) * t89;
  const Scalar t91 = Ic_3_yy - Scalar(0.000864576) * t41 - t88 - c_2 * t90 - t72 * t86 +
      mu_u_5_2_t_y * t85 - t73 * t84 + b_4_3_1 * t83 + t77 * t79 - Scalar(2.99250185137411);
  const Scalar t92 = (Scalar(1.0) / t91) * y_2_1;
  qdd[0] = -t92;
  const Scalar qdd_2 = d_2 * (y_3_2 + t77 * t92);
  qdd[1] = qdd_2;
  const Scalar qdd_3 = d_3 * (y_4_3 - b_4_3_2 * qdd_2 - b_4_3_1 * t92);
  qdd[2] = qdd_3;
  const Scalar t93 = t57 * qdd_2 + mu_u_5_2_t_y * t92;
  qdd[4] = Scalar(5.5037503582353615) * t93 + Scalar(5.5037503582353615) * (y_5 + t47 * qdd_3);
  const Scalar t94 = d_4 * (y_6_4 + b_6_4_2 * qdd_2 - t73 * t92 + b_6_4_3 * qdd_3);
  qdd[3] = -t94;
  const Scalar t95 = c_5 * t94 - t41 * (qdd_2 + qdd_3);
  qdd[5] = Scalar(0.00019430115597482132) * t95 + Scalar(4.857528899370533) * (y_6 + t72 * t92);
  bool positive = -t91 > Scalar(0.0);
  positive &= b_3_2_2 > Scalar(0.0);
  positive &= b_4_3_3 > Scalar(0.0);
  positive &= -b_6_4_4 > Scalar(0.0);
  return positive;
}

// kinetic energy of links and rotors (7.31).
//   q[6]   in  joint positions, rad or m
//   qd[6]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1..4], qd[0..5]. Operations: 78 mul, 49 add, 8 sin/cos.
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
  const Scalar t1 = s_2 * qd_1;
  const Scalar v_o_3_y = Scalar(0.4318) * qd_2 + Scalar(0.1501) * t1;
  const Scalar t2 = c_2 * qd_1;
  const Scalar t3 = c_3 * t2;
  const Scalar v_r_3_x = Scalar(0.1501) * t3 - s_3 * v_o_3_y;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar v_o_4_x = v_r_3_x - Scalar(0.4331) * omega_3_z;
  const Scalar t4 = s_3 * t2;
  const Scalar omega_r_3_x = t4 + c_3 * t1;
  const Scalar t5 = s_3 * t1 - t3;
  const Scalar v_o_4_z = Scalar(0.4318) * t2 + Scalar(0.4331) * omega_r_3_x + Scalar(0.0203) * t5;
  const Scalar v_r_3_y = Scalar(0.1501) * t4 + c_3 * v_o_3_y;
  const Scalar v_o_4_y = v_r_3_y - Scalar(0.0203) * omega_3_z;
  const Scalar t6 = s_5 * v_o_4_y + c_5 * (s_4 * v_o_4_z - c_4 * v_o_4_x);
  const Scalar omega_5_z = qd_5 + s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar t7 = omega_5_z * (Scalar(0.00576) * t6 + Scalar(0.00064216) * omega_5_z);
  const Scalar v_r_4_y = s_4 * v_o_4_x + c_4 * v_o_4_z;
  const Scalar t8 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar t9 = t5 - qd_4;
  const Scalar t10 = s_5 * t9 + c_5 * t8;
  const Scalar L_5_x = Scalar(0.00576) * v_r_4_y - Scalar(0.00024216) * t10;
  const Scalar omega_6_z = qd_6 + s_5 * t8 - c_5 * t9;
  const Scalar t11 = Scalar(0.004704) * t5 - Scalar(1.72359) * v_r_3_x - Scalar(0.05075) * v_r_3_y +
      Scalar(0.313105249) * omega_3_z;
  const Scalar L_3_y = Scalar(0.02191385) * t2 + Scalar(0.0106736385) * omega_r_3_x +
      Scalar(0.004704) * omega_3_z;
  const Scalar L_3_x = Scalar(0.744246162) * t2 + Scalar(0.299575024) * omega_r_3_x +
      Scalar(0.0106736385) * t5;
  const Scalar L_2_y = Scalar(0.023751) * qd_2 - Scalar(0.0070992) * t1;
  const Scalar L_2_x = Scalar(0.690314699) * qd_2 - Scalar(0.0070992) * t2 -
      Scalar(1.601861202) * t1;
  const Scalar t12 = qd_1 * (Scalar(4.29424586937411) * qd_1 + c_2 * L_2_y + s_2 * L_2_x);
  const Scalar t13 = qd_2 * (Scalar(6.502360360025) * qd_2 + Scalar(0.023751) * t2 +
      Scalar(0.690314699) * t1);
  const Scalar T_2 = Scalar(0.20582599086) * qd_6 * qd_6 + Scalar(0.00004) * omega_6_z * omega_6_z +
      Scalar(0.181052127515) * qd_5 * qd_5 + t7 - t10 * L_5_x +
      Scalar(0.2023536943736) * qd_4 * qd_4 + Scalar(0.0016) * t9 * t9 + Scalar(0.0003) * t8 * t8 +
      Scalar(0.86242563124731) * qd_3 * qd_3 + omega_3_z * t11 + t5 * L_3_y + omega_r_3_x * L_3_x +
      t13 + t12;
  return Scalar(0.5) * T_2;
}

// potential energy of links and rotors (7.36).
//   q[6]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[1..4]. Operations: 10 mul, 7 add, 7 sin/cos.
template <class Scalar>
inline Scalar potential_energy(const Scalar* q) noexcept {
  using std::cos;
  using std::sin;
  const Scalar q_2 = q[1], q_3 = q[2], q_4 = q[3], q_5 = q[4];
  const Scalar s_2 = sin(q_2), c_2 = cos(q_2);
  const Scalar s_3 = sin(q_3), c_3 = cos(q_3);
  const Scalar c_4 = cos(q_4);
  const Scalar s_5 = sin(q_5), c_5 = cos(q_5);
  const Scalar hc_3_x = Scalar(0.00288) * c_4 * s_5 - Scalar(0.025375);
  const Scalar hc_3_y = Scalar(0.00288) * c_5 + Scalar(0.861795);
  const Scalar hu_3_t_y = c_3 * hc_3_y - s_3 * hc_3_x;
  const Scalar hc_2_y = hu_3_t_y - Scalar(0.1044);
  const Scalar hu_3_t_x = c_3 * hc_3_x + s_3 * hc_3_y;
  const Scalar hc_2_x = hu_3_t_x + Scalar(3.79559);
  const Scalar hu_2_t_y = c_2 * hc_2_y - s_2 * hc_2_x;
  return Scalar(9.81) * hu_2_t_y;
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
// Reads q[0..5]. Operations: 60 mul, 29 add, 12 sin/cos.
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
  const Scalar p_3_x = Scalar(0.0203) * c_3 - Scalar(0.4331) * s_3 - Scalar(0.4318);
  const Scalar p_3u_t_y = Scalar(0.4331) * c_3 + Scalar(0.0203) * s_3;
  p[2] = s_2 * p_3_x + c_2 * p_3u_t_y;
  const Scalar t1 = s_2 * p_3u_t_y - c_2 * p_3_x;
  p[1] = Scalar(0.1501) * c_1 + s_1 * t1;
  const Scalar t2 = c_3 * s_5;
  const Scalar a_3_t_x = s_3 * c_5 + c_4 * t2;
  const Scalar t3 = s_3 * s_5;
  const Scalar t4 = c_4 * t3 - c_3 * c_5;
  R[8] = -s_2 * a_3_t_x - c_2 * t4;
  p[0] = c_1 * t1 - Scalar(0.1501) * s_1;
  const Scalar t5 = c_4 * c_5;
  const Scalar t6 = s_4 * s_6;
  const Scalar t7 = t6 - c_6 * t5;
  const Scalar t8 = c_6 * t3 + c_3 * t7;
  const Scalar t9 = s_3 * t7 - c_6 * t2;
  R[6] = s_2 * t8 + c_2 * t9;
  const Scalar t10 = s_4 * c_6;
  const Scalar s_4_t_x = t10 + s_6 * t5;
  const Scalar t11 = s_6 * t3 - c_3 * s_4_t_x;
  const Scalar s_3_t_y = s_3 * s_4_t_x + s_6 * t2;
  R[7] = c_2 * s_3_t_y - s_2 * t11;
  const Scalar t12 = s_2 * t4 - c_2 * a_3_t_x;
  const Scalar t13 = s_4 * s_5;
  R[2] = -s_1 * t13 - c_1 * t12;
  R[5] = c_1 * t13 - s_1 * t12;
  const Scalar n_2_t_x = s_2 * t9 - c_2 * t8;
  const Scalar n_4_t_y = c_5 * t10 + c_4 * s_6;
  R[3] = s_1 * n_2_t_x + c_1 * n_4_t_y;
  const Scalar t14 = s_2 * s_3_t_y + c_2 * t11;
  const Scalar t15 = c_5 * t6 - c_4 * c_6;
  R[1] = s_1 * t15 + c_1 * t14;
  R[4] = s_1 * t14 - c_1 * t15;
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

// geometric Jacobian of the tip (7.14), (7.15).
//   q[6]   in   joint positions, rad or m
//   J[36]  out  geometric Jacobian in base axes: linear rows, then angular
//               6 x 6, row by row: entry (i, j) is J[6 * i + j]
// Reads q[0..4]. Operations: 66 mul, 30 add, 10 sin/cos. Always zero: 6 of the 36 entries of J.
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
  J[25] = J[26] = c_1;
  J[19] = J[20] = -s_1;
  const Scalar R_32_y = c_2 * c_3 - s_2 * s_3;
  J[33] = R_32_y;
  const Scalar R_32_x = c_2 * s_3 + s_2 * c_3;
  const Scalar R_30_y = c_1 * R_32_x;
  J[21] = R_30_y;
  const Scalar R_31_y = s_1 * R_32_x;
  J[27] = R_31_y;
  J[34] = s_4 * R_32_x;
  const Scalar p_3u_t_y = Scalar(0.4331) * c_3 + Scalar(0.0203) * s_3;
  const Scalar p_3_x = Scalar(0.0203) * c_3 - Scalar(0.4331) * s_3 - Scalar(0.4318);
  const Scalar p_2u_t_y = c_2 * p_3u_t_y + s_2 * p_3_x;
  J[1] = c_1 * p_2u_t_y;
  J[7] = s_1 * p_2u_t_y;
  const Scalar t1 = c_2 * p_3_x - s_2 * p_3u_t_y;
  const Scalar J_P3_z = Scalar(0.4318) * c_2 + t1;
  J[14] = J_P3_z;
  const Scalar t2 = s_1 * s_4;
  const Scalar t3 = c_1 * c_4;
  const Scalar R_41_y = t3 - R_32_y * t2;
  J[28] = R_41_y;
  const Scalar R_52_y = c_5 * R_32_y - c_4 * s_5 * R_32_x;
  J[35] = R_52_y;
  const Scalar r_3_z = Scalar(0.4318) * s_2 + p_2u_t_y;
  J[2] = c_1 * r_3_z;
  J[8] = s_1 * r_3_z;
  const Scalar t4 = c_1 * s_4;
  const Scalar t5 = s_1 * c_4;
  const Scalar t6 = t5 + R_32_y * t4;
  J[22] = -t6;
  const Scalar t7 = Scalar(0.1501) * s_1 + c_1 * t1;
  J[6] = -t7;
  const Scalar p_1u_t_y = Scalar(0.1501) * c_1 - s_1 * t1;
  J[0] = -p_1u_t_y;
  const Scalar R_40_x = t2 - R_32_y * t3;
  const Scalar R_50_y = c_5 * R_30_y - s_5 * R_40_x;
  J[23] = R_50_y;
  const Scalar R_51_y = c_5 * R_31_y + s_5 * (t4 + R_32_y * t5);
  J[29] = R_51_y;
  J[13] = c_1 * t7 - s_1 * p_1u_t_y;
  const Scalar t8 = J_P3_z - Scalar(0.0203) * R_32_y + Scalar(0.4331) * R_32_x;
  J[16] = t8 * (c_1 * R_41_y + s_1 * t6);
  const Scalar r_4_z = r_3_z - Scalar(0.4331) * R_32_y - Scalar(0.0203) * R_32_x;
  const Scalar t9 = R_32_x * r_4_z + R_32_y * t8;
  J[3] = s_1 * t9;
  const Scalar t10 = s_4 * t8;
  J[4] = R_31_y * t10 + r_4_z * R_41_y;
  const Scalar t11 = t8 * R_52_y;
  J[5] = s_1 * t11 + r_4_z * R_51_y;
  J[9] = -c_1 * t9;
  J[10] = r_4_z * t6 - R_30_y * t10;
  J[11] = -c_1 * t11 - r_4_z * R_50_y;
  J[17] = t8 * (c_1 * R_51_y - s_1 * R_50_y);
  J[30] = Scalar(1.0);
  J[12] = J[15] = J[18] = J[24] = J[31] = J[32] = Scalar(0.0);
}

// (dJ/dt) qd of the tip.
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads q[0..5], qd[0..5]. Operations: 120 mul, 63 add, 12 sin/cos.
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
  const Scalar t1 = s_2 * c_3;
  const Scalar t2 = qd_1 * (t1 + c_2 * s_3);
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_r_4_y = c_4 * omega_3_z + s_4 * t2;
  const Scalar t3 = s_2 * s_3;
  const Scalar t4 = qd_1 * (c_2 * c_3 - t3);
  const Scalar t5 = omega_3_z * t4;
  const Scalar t6 = c_4 * t5 - qd_4 * omega_r_4_y;
  const Scalar t7 = c_4 * t2 - s_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 + t4;
  const Scalar omega_r_5_y = c_5 * omega_4_z - s_5 * t7;
  const Scalar t8 = omega_3_z * t2;
  const Scalar domega_5_x = c_5 * t6 - s_5 * t8 + qd_5 * omega_r_5_y;
  const Scalar omega_r_5_x = c_5 * t7 + s_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar omega_r_6_y = c_6 * omega_5_z + s_6 * omega_r_5_x;
  const Scalar t9 = s_4 * t5 + qd_4 * t7;
  const Scalar t10 = c_6 * domega_5_x - s_6 * t9 - qd_6 * omega_r_6_y;
  const Scalar t11 = qd_6 * (c_6 * omega_r_5_x - s_6 * omega_5_z);
  const Scalar t12 = c_6 * t9 + s_6 * domega_5_x + t11;
  const Scalar t13 = c_6 * t10 + s_6 * t12;
  const Scalar domega_5_y = c_5 * t8 + s_5 * t6 + qd_5 * omega_r_5_x;
  const Scalar domega_e_5_t_x = c_5 * t13 + s_5 * domega_5_y;
  const Scalar domega_e_6_t_y = c_6 * t12 - s_6 * t10;
  const Scalar domega_e_4_t_x = c_4 * domega_e_5_t_x + s_4 * domega_e_6_t_y;
  const Scalar domega_e_5_t_y = c_5 * domega_5_y - s_5 * t13;
  const Scalar t14 = c_3 * domega_e_5_t_y - s_3 * domega_e_4_t_x;
  const Scalar domega_e_3_t_x = c_3 * domega_e_4_t_x + s_3 * domega_e_5_t_y;
  a[5] = s_2 * domega_e_3_t_x - c_2 * t14;
  const Scalar t15 = omega_3_z * omega_3_z;
  const Scalar U_3_xx = t4 * t4 + t15;
  const Scalar t16 = c_2 * qd_1;
  const Scalar U_2_xx = t16 * t16 + qd_2 * qd_2;
  const Scalar t17 = qd_1 * t16;
  const Scalar t18 = c_3 * U_2_xx - t3 * t17;
  const Scalar t19 = t4 * t2;
  const Scalar t20 = Scalar(0.0203) * U_3_xx - Scalar(0.4318) * t18 - Scalar(0.4331) * t19;
  const Scalar t21 = qd_1 * (qd_1 + Scalar(5.753497668221186) * s_2 * qd_2);
  const Scalar t22 = Scalar(0.1501) * t21 - Scalar(0.0406) * t8 - Scalar(0.8662) * t5;
  const Scalar t23 = c_4 * t20 - s_4 * t22;
  const Scalar U_3_yy = t15 + t2 * t2;
  const Scalar t24 = t1 * t17 + s_3 * U_2_xx;
  const Scalar ddp_o_4_y = Scalar(0.4331) * U_3_yy - Scalar(0.0203) * t19 + Scalar(0.4318) * t24;
  const Scalar t25 = c_5 * t23 + s_5 * ddp_o_4_y;
  const Scalar t26 = c_4 * t22 + s_4 * t20;
  const Scalar t27 = c_6 * t25 - s_6 * t26;
  const Scalar t28 = c_6 * t26 + s_6 * t25;
  const Scalar t29 = c_6 * t27 + s_6 * t28;
  const Scalar t30 = c_5 * ddp_o_4_y - s_5 * t23;
  const Scalar t31 = c_5 * t29 - s_5 * t30;
  const Scalar t32 = c_6 * t28 - s_6 * t27;
  const Scalar t33 = c_4 * t31 + s_4 * t32;
  const Scalar a_5_t_y = c_5 * t30 + s_5 * t29;
  const Scalar a_3_t_y = c_3 * a_5_t_y + s_3 * t33;
  const Scalar t34 = c_3 * t33 - s_3 * a_5_t_y;
  a[2] = -c_2 * a_3_t_y - s_2 * t34;
  const Scalar t35 = c_2 * domega_e_3_t_x + s_2 * t14;
  const Scalar t36 = c_4 * domega_e_6_t_y - s_4 * domega_e_5_t_x;
  a[4] = c_1 * t36 - s_1 * t35;
  const Scalar t37 = c_2 * t34 - s_2 * a_3_t_y;
  const Scalar t38 = c_4 * t32 - s_4 * t31;
  a[0] = c_1 * t37 + s_1 * t38;
  a[3] = -c_1 * t35 - s_1 * t36;
  a[1] = s_1 * t37 - c_1 * t38;
}

}  // namespace puma560

#endif  // FLATDYN_PUMA560_HPP

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
// Every function is a template over its scalar: float, double, or any type that is made from a
// double, has + - * / (also - of one), comparisons, and sin, cos where argument-dependent lookup
// finds them (or an argument that knows them, see LibrarySinCos). Arguments are plain arrays:
//
//   double q[6] = {}, qd[6] = {}, qdd[6] = {}, tau[6];
//   puma560::inverse_dynamics(q, qd, qdd, tau);
//
// Entries come in the order of the table. Units are SI; "rad or m" goes by the type of the joint.
// Every entry of an output is written, zeros too. All inputs are read before anything is written:
// an output may overlap an input, but outputs must not overlap each other. Nothing allocates,
// throws, or keeps state. In the code, names count from 1 as in the textbook: q_1 is q[0], s_1 its
// sine, c_1 its cosine. Of link i: omega_i and domega_i are its angular velocity and acceleration,
// ddp_i the acceleration of its frame's origin less gravity, f_i and mu_i the force and moment that
// it gets from the link before, hc_i and hu_i the first moment of all that its joint carries (in
// gravity() times the size of gravity); t1, t2, ... are parts of sums.

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
// Reads q[1..4], qd[0..5], qdd[0..5]. Operations: 174 mul, 154 add, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = s_2 * qd_1;
  const Scalar t3 = s_3 * t1 + c_3 * t2;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t4 = t3 * omega_3_z;
  const Scalar t5 = s_2 * qdd_1;
  const Scalar t6 = c_2 * qdd_1;
  const Scalar t7 = s_3 * t5 - c_3 * t6;
  const Scalar t8 = t7 + t4;
  const Scalar t9 = t4 + t8;
  const Scalar t10 = s_3 * t2 - c_3 * t1;
  const Scalar t11 = t10 * omega_3_z;
  const Scalar t12 = -s_3 * t6 - c_3 * t5 + t11;
  const Scalar t13 = t11 + t12;
  const Scalar t14 = qd_2 * t2;
  const Scalar t15 = Scalar(2.0) * t14 - t6;
  const Scalar t16 = qd_1 * qd_1;
  const Scalar t17 = Scalar(0.3476146364057434) * t16 + t15;
  const Scalar ddp_o_4_z = Scalar(0.04701250578971746) * t9 - Scalar(1.0030106530801297) * t13 -
      t17;
  const Scalar t18 = t1 * t2;
  const Scalar U_2_yx = t18 + qdd_2;
  const Scalar t19 = Scalar(22.71885132005558) * c_2 - Scalar(0.3476146364057434) * t5 - U_2_yx;
  const Scalar t20 = t2 * t2;
  const Scalar t21 = qd_2 * qd_2;
  const Scalar t22 = t21 - t20 + t16;
  const Scalar t23 = Scalar(0.3476146364057434) * t6 + Scalar(22.71885132005558) * s_2 + t22;
  const Scalar t24 = s_3 * t19 + c_3 * t23;
  const Scalar t25 = t3 * t3;
  const Scalar t26 = omega_3_z * omega_3_z;
  const Scalar t27 = t16 - t25 + t26;
  const Scalar t28 = t3 * t10;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar Uz_o_4_x = t28 + domega_3_z;
  const Scalar ddp_o_4_x = Scalar(0.04701250578971746) * t27 +
      Scalar(1.0030106530801297) * Uz_o_4_x - t24;
  const Scalar ddp_4_x = s_4 * ddp_o_4_z + c_4 * ddp_o_4_x;
  const Scalar t29 = s_3 * t23 - c_3 * t19;
  const Scalar U_3_yx = domega_3_z - t28;
  const Scalar Uz_o_4_y = t25 + t26;
  const Scalar ddp_4_a_z = Scalar(0.04701250578971746) * U_3_yx -
      Scalar(1.0030106530801297) * Uz_o_4_y - t29;
  const Scalar t30 = s_5 * ddp_4_a_z - c_5 * ddp_4_x;
  const Scalar t31 = s_4 * omega_3_z - c_4 * t3;
  const Scalar omega_4_z = qd_4 - t10;
  const Scalar omega_r_6_a_z = s_5 * t31 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t32 = Scalar(0.00004) * omega_6_z;
  const Scalar t33 = s_5 * omega_4_z - c_5 * t31;
  const Scalar t34 = t31 * omega_4_z;
  const Scalar domega_5_z = qdd_5 - t34 - s_4 * t13 + c_4 * Uz_o_4_x;
  const Scalar t35 = t33 * omega_r_6_a_z;
  const Scalar mu_5_z = t33 * t32 - Scalar(0.00024216) * t35 + Scalar(0.00064216) * domega_5_z -
      Scalar(0.001243584) * t30;
  tau[4] = mu_5_z + Scalar(0.85444524) * detail::sign(qd_5) + Scalar(0.4272830209354) * qd_5 +
      Scalar(0.181052127515) * qdd_5;
  const Scalar omega_r_4_y = s_4 * t3 + c_4 * omega_3_z;
  const Scalar t36 = omega_r_4_y * omega_4_z;
  const Scalar t37 = t36 + s_4 * Uz_o_4_x + c_4 * t13;
  const Scalar U_4_zy = t36 + t37;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar t38 = t33 * omega_5_z;
  const Scalar domega_4_z = qdd_4 - t8;
  const Scalar t39 = t31 * omega_r_4_y;
  const Scalar t40 = domega_4_z - t39;
  const Scalar domega_6_z = qdd_6 - t38 + s_5 * U_4_zy + c_5 * t40;
  const Scalar t41 = Scalar(0.00004) * domega_6_z;
  tau[5] = t41 + Scalar(0.2158232532732) * qd_6 + Scalar(0.55443978) * detail::sign(qd_6) +
      Scalar(0.20582599086) * qdd_6;
  const Scalar mu_5_y = Scalar(0.0004) * t38 - t41;
  const Scalar t42 = omega_r_6_a_z * omega_5_z;
  const Scalar t43 = t42 + s_5 * t40 - c_5 * U_4_zy;
  const Scalar t44 = s_4 * ddp_o_4_x - c_4 * ddp_o_4_z;
  const Scalar t45 = omega_5_z * t32 - Scalar(0.00024216) * t43 - Scalar(0.00064216) * t42 +
      Scalar(0.001243584) * t44;
  const Scalar mu_4_z = Scalar(-0.0003) * t39 - c_5 * mu_5_y + Scalar(0.0016) * domega_4_z -
      s_5 * t45;
  tau[3] = mu_4_z + Scalar(0.411645229697152) * qd_4 + Scalar(1.06831142) * detail::sign(qd_4) +
      Scalar(0.2023536943736) * qdd_4;
  const Scalar mu_4_x = Scalar(0.0003) * t37 - s_5 * mu_5_y + Scalar(0.0016) * t36 + c_5 * t45;
  const Scalar Uz_o_6_z = t42 + t43;
  const Scalar t46 = Scalar(0.23306405) * t44 - Scalar(0.001243584) * Uz_o_6_z;
  const Scalar Uz_o_6_y = t33 * t33 + omega_5_z * omega_5_z;
  const Scalar t47 = Scalar(0.001243584) * s_5;
  const Scalar Uz_o_6_x = domega_5_z - t35;
  const Scalar t48 = Scalar(0.001243584) * c_5;
  const Scalar f_4_x = Uz_o_6_x * t48 - Uz_o_6_y * t47 + Scalar(0.23306405) * ddp_4_x;
  const Scalar f_u_4_t_x = s_4 * t46 + c_4 * f_4_x;
  const Scalar t49 = Scalar(0.0013) * t34 - mu_5_z;
  const Scalar f_4_z = -Uz_o_6_x * t47 - Uz_o_6_y * t48 + Scalar(0.23306405) * ddp_4_a_z;
  const Scalar t50 = s_4 * mu_4_x - Scalar(0.000316274) * (t27 - Uz_o_4_y) - c_4 * t49 +
      Scalar(0.004704) * t7 + Scalar(0.065620624) * t28 + Scalar(0.04701250578971746) * f_4_z +
      Scalar(0.078120624) * domega_3_z - Scalar(0.138357356) * t24 +
      Scalar(1.0030106530801297) * f_u_4_t_x;
  tau[2] = t50 + Scalar(6.36419655) * detail::sign(qd_3) + Scalar(3.9804259903722) * qd_3 +
      Scalar(0.86242563124731) * qdd_3;
  const Scalar f_3_x = Scalar(0.138357356) * Uz_o_4_x + f_u_4_t_x - Scalar(1.405871712) * t24;
  const Scalar f_3_y = Scalar(0.138357356) * Uz_o_4_y - f_4_z + Scalar(1.405871712) * t29;
  const Scalar f_u_3_t_y = s_3 * f_3_x + c_3 * f_3_y;
  const Scalar t51 = t20 + t21;
  tau[1] = Scalar(0.0070992) * (t22 - t51) - Scalar(0.03707456) * t18 + Scalar(0.023751) * t6 +
      Scalar(1.024164) * s_2 + Scalar(0.12059664) * t5 + t50 +
      Scalar(10.6197775) * detail::sign(qd_2) + Scalar(9.496868641825) * qd_2 + f_u_3_t_y +
      Scalar(4.863424598025) * qdd_2;
  const Scalar f_u_4_t_y = s_4 * f_4_x - c_4 * t46;
  const Scalar U_3_yy_zz = t16 - Uz_o_4_y;
  const Scalar t52 = Scalar(0.000316274) * t9 + s_4 * t49 + c_4 * mu_4_x +
      Scalar(0.004704) * U_3_yy_zz + Scalar(0.078120624) * t11 + Scalar(0.065620624) * t12 +
      Scalar(0.138357356) * t17 - Scalar(1.0030106530801297) * f_u_4_t_y;
  const Scalar mu_3_y = Scalar(0.000316274) * t13 - mu_4_z + Scalar(0.0125) * t4 +
      Scalar(0.004704) * Uz_o_4_x + Scalar(0.04701250578971746) * f_u_4_t_y;
  const Scalar U_2_yy_zz = t16 - t51;
  const Scalar t53 = qd_2 * t1;
  const Scalar t54 = t53 + t5;
  const Scalar t55 = Scalar(0.0070992) * t15 + s_3 * mu_3_y + Scalar(0.03707456) * t54 +
      Scalar(0.023751) * U_2_yy_zz + Scalar(0.10917824) * t53 + Scalar(0.12059664) * U_2_yx -
      c_3 * t52 + Scalar(0.3476146364057434) * f_u_3_t_y;
  const Scalar t56 = s_3 * f_3_y - c_3 * f_3_x;
  const Scalar t57 = Scalar(-0.0070992) * (t53 + t54) - c_3 * mu_3_y +
      Scalar(0.023751) * (qdd_2 - t18) - Scalar(0.07210368) * t14 - Scalar(0.138357356) * t13 -
      Scalar(0.12059664) * (t16 - t22) - s_3 * t52 + f_u_4_t_y + Scalar(0.3476146364057434) * t56 -
      Scalar(1.405871712) * t17;
  tau[0] = s_2 * t55 + Scalar(5.8018217679508) * qd_1 + Scalar(2.4567526589410393) * qdd_1 +
      Scalar(25.9836065) * detail::sign(qd_1) + c_2 * t57;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..5], qd[0..5], qdd[0..5], h_e[0..5]. Operations: 239 mul, 190 add, 12 sin/cos.
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
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t4 = t3 * omega_3_z;
  const Scalar t5 = c_2 * qdd_1;
  const Scalar t6 = s_2 * qdd_1;
  const Scalar t7 = -s_3 * t5 - c_3 * t6 + t4;
  const Scalar t8 = t4 + t7;
  const Scalar t9 = s_3 * t2 + c_3 * t1;
  const Scalar omega_r_4_y = s_4 * t9 + c_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 - t3;
  const Scalar t10 = omega_r_4_y * omega_4_z;
  const Scalar t11 = t9 * t3;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar Uz_o_4_x = t11 + domega_3_z;
  const Scalar t12 = t10 + s_4 * Uz_o_4_x + c_4 * t8;
  const Scalar U_4_zy = t10 + t12;
  const Scalar t13 = s_4 * omega_3_z - c_4 * t9;
  const Scalar t14 = s_5 * omega_4_z - c_5 * t13;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar t15 = t14 * omega_5_z;
  const Scalar t16 = t9 * omega_3_z;
  const Scalar t17 = s_3 * t6 - c_3 * t5;
  const Scalar t18 = t17 + t16;
  const Scalar domega_4_z = qdd_4 - t18;
  const Scalar t19 = t13 * omega_r_4_y;
  const Scalar t20 = domega_4_z - t19;
  const Scalar domega_6_z = qdd_6 - t15 + s_5 * U_4_zy + c_5 * t20;
  const Scalar mu_e1_x = s_1 * h_e_5 + c_1 * h_e_4;
  const Scalar t21 = s_2 * mu_e1_x + c_2 * h_e_6;
  const Scalar t22 = s_2 * h_e_6 - c_2 * mu_e1_x;
  const Scalar t23 = s_3 * t21 + c_3 * t22;
  const Scalar t24 = s_1 * h_e_4 - c_1 * h_e_5;
  const Scalar t25 = s_4 * t24 + c_4 * t23;
  const Scalar t26 = s_3 * t22 - c_3 * t21;
  const Scalar mu_6_z = Scalar(0.00004) * domega_6_z - s_5 * t25 - c_5 * t26;
  tau[5] = Scalar(0.2158232532732) * qd_6 + Scalar(0.55443978) * detail::sign(qd_6) +
      Scalar(0.20582599086) * qdd_6 + mu_6_z;
  const Scalar mu_e5_x = s_5 * t26 - c_5 * t25;
  const Scalar omega_r_6_y = s_6 * t14 + c_6 * omega_5_z;
  const Scalar omega_r_6_a_z = s_5 * t13 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t27 = Scalar(0.00004) * omega_6_z;
  const Scalar mu_e4_y = s_4 * t23 - c_4 * t24;
  const Scalar mu_6_x = omega_r_6_y * t27 + s_6 * mu_e4_y + c_6 * mu_e5_x;
  const Scalar t28 = (s_6 * omega_5_z - c_6 * t14) * t27;
  const Scalar t29 = t28 + s_6 * mu_e5_x - c_6 * mu_e4_y;
  const Scalar t30 = t16 + t18;
  const Scalar t31 = qd_2 * t1;
  const Scalar t32 = Scalar(2.0) * t31 - t5;
  const Scalar t33 = qd_1 * qd_1;
  const Scalar t34 = Scalar(0.1501) * t33 + Scalar(0.4318) * t32;
  const Scalar ddp_o_4_z = Scalar(0.0203) * t30 - Scalar(0.4331) * t8 - t34;
  const Scalar t35 = t2 * t1;
  const Scalar U_2_yx = t35 + qdd_2;
  const Scalar t36 = Scalar(9.81) * c_2 - Scalar(0.1501) * t6 - Scalar(0.4318) * U_2_yx;
  const Scalar t37 = t1 * t1;
  const Scalar t38 = qd_2 * qd_2;
  const Scalar t39 = t38 - t37 + t33;
  const Scalar t40 = Scalar(0.1501) * t5 + Scalar(9.81) * s_2 + Scalar(0.4318) * t39;
  const Scalar t41 = s_3 * t36 + c_3 * t40;
  const Scalar t42 = t9 * t9;
  const Scalar t43 = omega_3_z * omega_3_z;
  const Scalar t44 = t33 - t42 + t43;
  const Scalar ddp_o_4_x = Scalar(0.0203) * t44 + Scalar(0.4331) * Uz_o_4_x - t41;
  const Scalar ddp_4_x = s_4 * ddp_o_4_z + c_4 * ddp_o_4_x;
  const Scalar t45 = s_3 * t40 - c_3 * t36;
  const Scalar U_3_yx = domega_3_z - t11;
  const Scalar Uz_o_4_y = t42 + t43;
  const Scalar ddp_4_a_z = Scalar(0.0203) * U_3_yx - Scalar(0.4331) * Uz_o_4_y - t45;
  const Scalar t46 = s_5 * ddp_4_a_z - c_5 * ddp_4_x;
  const Scalar t47 = t13 * omega_4_z;
  const Scalar domega_5_z = qdd_5 - t47 - s_4 * t8 + c_4 * Uz_o_4_x;
  const Scalar t48 = t14 * omega_r_6_a_z;
  const Scalar mu_5_z = Scalar(0.00064216) * domega_5_z - Scalar(0.00024216) * t48 -
      Scalar(0.00288) * t46 + s_6 * mu_6_x - c_6 * t29;
  tau[4] = Scalar(0.85444524) * detail::sign(qd_5) + Scalar(0.4272830209354) * qd_5 +
      Scalar(0.181052127515) * qdd_5 + mu_5_z;
  const Scalar t49 = omega_r_6_a_z * omega_5_z;
  const Scalar t50 = t49 + s_5 * t20 - c_5 * U_4_zy;
  const Scalar t51 = s_4 * ddp_o_4_x - c_4 * ddp_o_4_z;
  const Scalar t52 = Scalar(-0.00024216) * t50 - Scalar(0.00064216) * t49 + Scalar(0.00288) * t51 +
      s_6 * t29 + c_6 * mu_6_x;
  const Scalar mu_5_y = Scalar(0.0004) * t15 - mu_6_z;
  const Scalar mu_4_z = Scalar(0.0016) * domega_4_z - Scalar(0.0003) * t19 - s_5 * t52 -
      c_5 * mu_5_y;
  tau[3] = Scalar(0.411645229697152) * qd_4 + Scalar(1.06831142) * detail::sign(qd_4) +
      Scalar(0.2023536943736) * qdd_4 + mu_4_z;
  const Scalar f_e1_x = s_1 * h_e_2 + c_1 * h_e_1;
  const Scalar t53 = s_2 * f_e1_x + c_2 * h_e_3;
  const Scalar t54 = s_2 * h_e_3 - c_2 * f_e1_x;
  const Scalar t55 = s_3 * t53 + c_3 * t54;
  const Scalar t56 = s_1 * h_e_1 - c_1 * h_e_2;
  const Scalar t57 = s_4 * t56 + c_4 * t55;
  const Scalar t58 = s_3 * t54 - c_3 * t53;
  const Scalar f_e5_x = s_5 * t58 - c_5 * t57;
  const Scalar f_e4_y = s_4 * t55 - c_4 * t56;
  const Scalar t59 = s_6 * f_e5_x - c_6 * f_e4_y;
  const Scalar f_e6_x = s_6 * f_e4_y + c_6 * f_e5_x;
  const Scalar Uz_o_6_x = domega_5_z - t48;
  const Scalar f_5_x = Scalar(0.00288) * Uz_o_6_x + s_6 * t59 + c_6 * f_e6_x;
  const Scalar Uz_o_6_y = t14 * t14 + omega_5_z * omega_5_z;
  const Scalar t60 = Scalar(0.00288) * Uz_o_6_y + s_5 * t57 + c_5 * t58;
  const Scalar t61 = s_5 * t60 - c_5 * f_5_x;
  const Scalar Uz_o_6_z = t49 + t50;
  const Scalar f_5_z = Scalar(0.00288) * Uz_o_6_z + s_6 * f_e6_x - c_6 * t59;
  const Scalar t62 = s_4 * f_5_z + c_4 * t61;
  const Scalar mu_4_x = Scalar(0.0003) * t12 + Scalar(0.0016) * t10 - s_5 * mu_5_y + c_5 * t52;
  const Scalar t63 = s_5 * f_5_x + c_5 * t60;
  const Scalar t64 = Scalar(0.0013) * t47 - mu_5_z;
  const Scalar t65 = Scalar(0.004704) * t17 - Scalar(0.025375) * t45 - Scalar(0.0203) * t63 +
      Scalar(0.0106736385) * (t44 - Uz_o_4_y) + Scalar(0.299575024) * t11 +
      Scalar(0.313105249) * domega_3_z - Scalar(0.861795) * t41 - Scalar(0.4331) * t62 +
      s_4 * mu_4_x - c_4 * t64;
  tau[2] = Scalar(6.36419655) * detail::sign(qd_3) + Scalar(3.9804259903722) * qd_3 +
      Scalar(0.86242563124731) * qdd_3 + t65;
  const Scalar f_3_x = Scalar(0.025375) * t44 + Scalar(0.861795) * Uz_o_4_x - t62;
  const Scalar t66 = Scalar(0.025375) * U_3_yx - Scalar(0.861795) * Uz_o_4_y - t63;
  const Scalar t67 = s_3 * f_3_x - c_3 * t66;
  const Scalar t68 = t37 + t38;
  const Scalar t69 = Scalar(-0.0070992) * (t39 - t68) - Scalar(0.023751) * t5 -
      Scalar(1.024164) * s_2 - Scalar(0.690314699) * t6 - Scalar(1.601861202) * t35 -
      Scalar(0.4318) * t67 - t65 - Scalar(10.6197775) * detail::sign(qd_2) +
      Scalar(37.2347379) * c_2 - Scalar(9.496868641825) * qd_2 - Scalar(6.502360360025) * qdd_2;
  tau[1] = -t69;
  const Scalar t70 = s_4 * t61 - c_4 * f_5_z;
  const Scalar mu_3_y = Scalar(0.013530225) * t16 + Scalar(0.004704) * Uz_o_4_x -
      Scalar(0.0106736385) * t8 - Scalar(0.025375) * t34 - Scalar(0.0203) * t70 - mu_4_z;
  const Scalar U_3_yy_zz = t33 - Uz_o_4_y;
  const Scalar t71 = Scalar(0.004704) * U_3_yy_zz - Scalar(0.0106736385) * t30 +
      Scalar(0.313105249) * t4 + Scalar(0.299575024) * t7 + Scalar(0.861795) * t34 +
      Scalar(0.4331) * t70 + s_4 * t64 + c_4 * mu_4_x;
  const Scalar U_2_yy_zz = t33 - t68;
  const Scalar t72 = qd_2 * t2;
  const Scalar t73 = t72 + t6;
  const Scalar t74 = Scalar(0.0070992) * t32 + Scalar(0.023751) * U_2_yy_zz + Scalar(0.1501) * t67 +
      Scalar(0.690314699) * U_2_yx + s_3 * mu_3_y + Scalar(1.748114002) * t72 -
      Scalar(1.601861202) * t73 - c_3 * t71;
  const Scalar f_u_3_t_x = s_3 * t66 + c_3 * f_3_x;
  const Scalar t75 = Scalar(0.010956925) * t30 - Scalar(0.0070992) * (t72 + t73) +
      Scalar(0.023751) * (qdd_2 - t35) - Scalar(0.1501) * f_u_3_t_x - Scalar(0.372123081) * t8 -
      Scalar(0.4318) * t70 - c_3 * mu_3_y - Scalar(0.690314699) * (t33 - t39) - s_3 * t71 -
      Scalar(3.349975204) * t31;
  tau[0] = Scalar(5.8018217679508) * qd_1 + Scalar(25.9836065) * detail::sign(qd_1) + s_2 * t74 +
      c_2 * t75 + Scalar(4.29424586937411) * qdd_1;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[36] = {
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 0, 1,
    1, 1, 1, 0, 1, 0,
    1, 1, 1, 1, 0, 1};

// Joint-space inertia matrix B(q) (7.32).
//   q[6]   in   joint positions, rad or m
//   B[36]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//               6 x 6, row by row: entry (i, j) is B[6 * i + j]
// Reads q[1..4]. Operations: 81 mul, 68 add, 8 sin/cos. Always zero: 4 of the 36 entries of B.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inertia_matrix(const Scalar* q, Scalar* B, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
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
  const Scalar mu_u_4_4_a_y = t7 - Scalar(0.00184216);
  B[21] = Scalar(0.2023536943736) - mu_u_4_4_a_y;
  const Scalar t8 = Scalar(0.001243584) * t1;
  B[9] = B[19] = -s_3 * t8 - t4;
  const Scalar t9 = s_3 * c_5;
  const Scalar f_u_5_3_t_y = c_3 * s_5 + c_4 * t9;
  B[10] = B[25] = Scalar(0.001243584) * f_u_5_3_t_y - t6;
  const Scalar t10 = c_4 * s_5;
  const Scalar mu_u_6_3_t_x = t9 + c_3 * t10;
  B[5] = B[30] = Scalar(0.00004) * (c_2 * (c_3 * c_5 - s_3 * t10) - s_2 * mu_u_6_3_t_x);
  const Scalar t11 = c_5 * (s_4 - Scalar(0.04701250578971746) * c_3 *
      (s_4 + Scalar(7.394088669950739) * c_4));
  const Scalar t12 = s_4 * t5;
  const Scalar t13 = s_2 * (Scalar(0.000058464) * s_4 * t9 + Scalar(0.000432288) * f_u_5_3_t_y +
      c_3 * t12);
  B[4] = B[24] = t13 + c_2 * (Scalar(0.001243584) * t11 + s_3 * (Scalar(0.000432288) * s_5 + t12));
  const Scalar Iu_5_t_xx = t7 - Scalar(0.00020216);
  const Scalar Iu_4_t_d = Iu_5_t_xx - Scalar(0.0001);
  const Scalar t14 = c_4 * Iu_4_t_d;
  const Scalar t15 = c_4 * t14;
  const Scalar t16 = Scalar(0.000116928) * t10;
  const Scalar t17 = Scalar(0.002494656) * c_5;
  const Scalar Ic_3_zz = -t16 - t15 + Iu_5_t_xx + t17 + Scalar(0.313647409);
  const Scalar hc_3_x = Scalar(0.000432288) * t10 - Scalar(0.0038087875);
  const Scalar f_3_3_x = Scalar(0.000432288) * c_5 + Scalar(0.1293554295);
  const Scalar hu_3_t_x = c_3 * hc_3_x + s_3 * f_3_3_x;
  const Scalar t18 = Scalar(5.753497668221186) * hu_3_t_x;
  B[7] = Ic_3_zz + t18 + Scalar(6.502360360025);
  B[14] = Ic_3_zz + Scalar(0.86242563124731);
  B[8] = B[13] = Ic_3_zz + Scalar(2.876748834110593) * hu_3_t_x;
  const Scalar mu_4_3_y = Scalar(0.000058464) * t10 + mu_u_4_4_a_y;
  const Scalar t19 = Scalar(0.000432288) * t1 - mu_4_3_y;
  const Scalar t20 = t10 * t3;
  const Scalar t21 = c_2 * (s_3 * t20 + Scalar(0.001243584) * t10 + c_3 * t19);
  B[3] = B[18] = t21 - s_2 * (s_3 * t19 - c_3 * t20);
  const Scalar Ic_3_xz = Scalar(0.000058464) * t1 + s_4 * t14;
  const Scalar Ic_3_yz = t4 + Scalar(0.004704);
  const Scalar Iu_3_t_yz = s_3 * Ic_3_xz + c_3 * Ic_3_yz;
  const Scalar t22 = c_3 * f_3_3_x - s_3 * hc_3_x;
  const Scalar t23 = Iu_3_t_yz + t22;
  const Scalar t24 = hu_3_t_x - (c_3 * Ic_3_xz - s_3 * Ic_3_yz);
  B[2] = B[12] = s_2 * t24 - c_2 * t23;
  B[1] = B[6] = s_2 * (t8 + t24 + Scalar(0.690314699)) - c_2 * (t23 - Scalar(0.023751));
  const Scalar Ic_3_xx = t15 + Scalar(0.0001) + t17;
  const Scalar t25 = t16 + mu_u_4_4_a_y + Scalar(0.300117184);
  const Scalar Iu_3_t_d = Ic_3_xx + t25;
  const Scalar t26 = Scalar(0.000058464) * c_5 - t20 + Scalar(0.0106736385);
  const Scalar Iu_3_t_g = Scalar(2.0) * s_3 * t26 + c_3 * Iu_3_t_d;
  const Scalar t27 = c_3 * Iu_3_t_g;
  const Scalar t28 = s_2 * (Scalar(0.0070992) + t26 - s_3 * Iu_3_t_g -
      Scalar(2.876748834110593) * t22);
  const Scalar t29 = c_2 * (Iu_3_t_d - Scalar(2.0) * t27 + t18 + Scalar(1.601861202)) -
      Scalar(2.0) * t28;
  B[0] = Scalar(0.000864576) * t1 + t27 - t25 + c_2 * t29 + Scalar(2.99250185137411);
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
// Reads q[1..4]. Operations: 193 mul, 128 add, 8 sin/cos. Always zero: 40 of the 126 entries of c.
template <class Scalar, class SinCos = LibrarySinCos>
inline void christoffel(const Scalar* q, Scalar* c, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  c[102] = Scalar(0.00002) * s_5;
  c[82] = c[118] = Scalar(-0.00002) * s_5;
  const Scalar t1 = Scalar(0.00020216) * c_5;
  const Scalar db_44_5r = s_5 * t1;
  c[76] = db_44_5r;
  const Scalar t2 = s_4 * c_5;
  c[40] = c[61] = c[116] = c[117] = Scalar(0.00002) * t2;
  const Scalar t3 = c_4 * s_5;
  const Scalar db_26_4 = Scalar(0.00002) * t3;
  c[39] = c[60] = c[112] = c[113] = db_26_4;
  c[79] = c[80] = Scalar(-0.00002) * t3;
  c[100] = c[101] = Scalar(-0.00002) * t2;
  const Scalar t4 = Scalar(0.000058464) * c_5;
  const Scalar v_3_6_a_z = t4 + Scalar(0.001247328) * t3;
  c[56] = -v_3_6_a_z;
  c[93] = -db_44_5r;
  const Scalar v_1_3_y = s_2 * c_3 + c_2 * s_3;
  const Scalar t5 = s_4 * s_5;
  const Scalar t6 = t5 * v_1_3_y;
  c[18] = c[111] = Scalar(0.00002) * t6;
  const Scalar t7 = c_5 * v_1_3_y;
  const Scalar t8 = s_2 * s_3 - c_2 * c_3;
  const Scalar c_3_1_6 = Scalar(0.00002) * t7 - t8 * db_26_4;
  c[57] = c_3_1_6;
  const Scalar t9 = Scalar(0.00010108) * c_5;
  const Scalar t10 = t9 + Scalar(0.000623664);
  const Scalar t11 = t3 * t10;
  c[51] = Scalar(-2.0) * t11;
  c[78] = Scalar(-0.00002) * t6;
  const Scalar hc_3_x = Scalar(0.000216144) * t3 - Scalar(0.00190439375);
  const Scalar t12 = Scalar(0.000216144) * c_5;
  const Scalar f_3_3_x = t12 + Scalar(0.06467771475);
  const Scalar t13 = s_3 * hc_3_x - c_3 * f_3_3_x;
  const Scalar db_22_3r = Scalar(-5.753497668221186) * t13;
  c[25] = c[26] = db_22_3r;
  c[44] = Scalar(5.753497668221186) * t13;
  const Scalar t14 = Scalar(0.000621792) * s_3;
  const Scalar v_o_2_4_x = t14 + Scalar(0.000623664);
  const Scalar t15 = Scalar(0.000621792) * c_3;
  const Scalar v_o_2_4_y = t15 - Scalar(0.000029232);
  const Scalar t16 = t3 * v_o_2_4_x - c_5 * v_o_2_4_y;
  const Scalar c_2_5_5 = Scalar(-2.0) * t16;
  c[35] = c_2_5_5;
  const Scalar t17 = t10 * t5;
  const Scalar t18 = Scalar(2.0) * s_4;
  const Scalar c_5_3_3 = t17 * t18 + c_4 * v_3_6_a_z;
  c[89] = c_5_3_3;
  c[17] = c[108] = -c_3_1_6;
  const Scalar t19 = s_2 * (s_3 * t3 - c_3 * c_5);
  const Scalar mu_u_6_3_t_x = c_3 * t3 + s_3 * c_5;
  const Scalar c_1_2_6 = Scalar(0.00002) * t19 - Scalar(0.00002) * c_2 * mu_u_6_3_t_x;
  c[16] = c[106] = c_1_2_6;
  const Scalar t20 = t9 + v_o_2_4_x;
  c[30] = Scalar(-2.0) * t3 * t20;
  const Scalar t21 = c_5 * t9;
  const Scalar Iu_4_t_d = t21 - Scalar(0.00015108);
  const Scalar t22 = c_4 * Iu_4_t_d;
  const Scalar t23 = t22 - s_5 * v_o_2_4_y;
  const Scalar db_22_4r = t23 * t18;
  c[28] = db_22_4r;
  c[54] = -c_5_3_3;
  const Scalar t24 = c_4 * v_1_3_y;
  const Scalar t25 = s_5 * t8;
  const Scalar t26 = t25 - c_5 * t24;
  c[99] = Scalar(-0.00002) * t26;
  c[19] = c[115] = Scalar(0.00002) * t26;
  c[36] = -c_1_2_6;
  const Scalar t27 = s_4 * (c_5 * t1 - Scalar(0.00010108));
  const Scalar t28 = v_o_2_4_x * t2;
  const Scalar t29 = t27 + t28;
  const Scalar t30 = Scalar(0.00032108) * s_4;
  const Scalar t31 = t30 + t28;
  const Scalar c_4_2_5 = t31 - t29;
  c[74] = c_4_2_5;
  const Scalar t32 = Scalar(0.000623664) * t2;
  const Scalar t33 = t27 + t32;
  const Scalar t34 = t30 + t32;
  const Scalar c_4_3_5 = t34 - t33;
  c[75] = c_4_3_5;
  const Scalar dmu_3_4_x = Scalar(0.000029232) * s_5 + t22;
  const Scalar t35 = s_4 * dmu_3_4_x;
  c[50] = Scalar(2.0) * t35;
  const Scalar c_5_2_2 = t5 * t20 * t18 - c_4 * c_2_5_5;
  c[86] = c_5_2_2;
  c[65] = -db_22_4r;
  c[34] = -t31 - t29;
  c[91] = -c_4_2_5;
  c[68] = Scalar(-2.0) * t35;
  c[55] = -t34 - t33;
  c[92] = -c_4_3_5;
  const Scalar t36 = Scalar(2.876748834110593) * c_2;
  const Scalar v_o_1_4_z = Scalar(0.13524317121918722) * t8 + Scalar(2.8854097268487675) * v_1_3_y +
      t36;
  const Scalar t37 = c_4 * t8 + s_4 * v_o_1_4_z;
  const Scalar t38 = s_5 * t37 - t7;
  const Scalar c_1_5_5 = Scalar(-0.000432288) * t38;
  c[14] = c_1_5_5;
  c[32] = -c_5_2_2;
  const Scalar t39 = Scalar(0.000216144) * s_5;
  const Scalar t40 = t37 * t39;
  const Scalar t41 = t9 * t6 + t40;
  c[9] = Scalar(-2.0) * t41;
  const Scalar t42 = s_4 * Iu_4_t_d;
  const Scalar t43 = s_4 * v_1_3_y;
  const Scalar t44 = t42 * t43;
  const Scalar t45 = t11 * t8;
  const Scalar t46 = Scalar(0.000216144) * t6;
  const Scalar t47 = t44 - dmu_3_4_x * t24 - t46 + t45;
  const Scalar mu_u_4_4_a_y = t21 - Scalar(0.00092108);
  const Scalar t48 = Scalar(0.000029232) * t3 - Scalar(0.000216144) * t5 + mu_u_4_4_a_y;
  const Scalar t49 = v_1_3_y * t48 - t45;
  c[8] = t47 + t49;
  const Scalar c_4_1_3 = t49 - t47;
  c[66] = c_4_1_3;
  const Scalar db_23_4r = t35 + s_4 * t23;
  const Scalar t50 = t5 * t15;
  c[29] = db_23_4r - t50;
  const Scalar c_3_2_4 = db_23_4r + t50;
  c[49] = c_3_2_4;
  c[48] = -c_4_1_3;
  const Scalar t51 = s_4 * t8 - c_4 * v_o_1_4_z;
  const Scalar t52 = Scalar(0.00010108) * t26 + Scalar(0.000216144) * t51;
  const Scalar t53 = t3 * v_1_3_y + c_5 * t8;
  const Scalar t54 = Scalar(0.00010108) * s_5 * t53 + c_5 * t52;
  const Scalar t55 = Scalar(0.00032108) * t24 - t12 * t51;
  c[13] = t55 - t54;
  const Scalar c_5_1_4 = t55 + t54;
  c[90] = c_5_1_4;
  c[67] = -c_3_2_4;
  const Scalar t56 = Scalar(0.5) * c_5_2_2 + Scalar(0.5) * c_5_3_3;
  const Scalar t57 = c_4 * c_5 * t15 - s_5 * t14;
  c[33] = t57 - t56;
  const Scalar c_5_2_3 = t57 + t56;
  c[88] = c_5_2_3;
  const Scalar t58 = s_4 * (Iu_4_t_d * t24 - t9 * t25);
  const Scalar t59 = v_1_3_y * (t24 * (Scalar(0.000432288) * s_5 - t42) - t58);
  const Scalar db_11_4r = t59 + t8 * (t40 + t41);
  c[6] = db_11_4r;
  const Scalar db_11_5r = t43 * c_1_5_5 + Scalar(2.0) * t53 * t52;
  c[10] = db_11_5r;
  const Scalar Ic_3_yz = t17 + Scalar(0.002352);
  const Scalar db_13_3 = v_1_3_y * (Ic_3_yz + f_3_3_x) - t8 * (hc_3_x - t35);
  c[5] = Scalar(2.0) * db_13_3;
  const Scalar t60 = t46 - t44 + c_4 * (v_1_3_y * t23 - t25 * t20);
  const Scalar t61 = s_2 * (t3 * (s_3 * t10 + Scalar(0.000621792)) - c_3 * t48);
  const Scalar t62 = t61 - c_2 * (c_3 * t11 + s_3 * t48);
  const Scalar c_2_1_4 = t62 - t60;
  c[27] = c_2_1_4;
  c[73] = -c_5_1_4;
  c[53] = -c_5_2_3;
  const Scalar Iu_3_t_d = c_4 * (Scalar(0.000058464) * s_5 + t22) + Scalar(0.001247328) * c_5 +
      mu_u_4_4_a_y + Scalar(0.150108592);
  const Scalar t63 = Scalar(2.0) * t11 - t4 - Scalar(0.0106736385);
  const Scalar t64 = t8 * (t63 * t8 - Iu_3_t_d * v_1_3_y - f_3_3_x * t36);
  const Scalar t65 = v_1_3_y * (hc_3_x * t36 + t63 * v_1_3_y + Iu_3_t_d * t8);
  const Scalar c_1_1_3 = t64 - t65 - t36 * (hc_3_x * v_1_3_y + f_3_3_x * t8);
  c[3] = c_1_1_3;
  c[84] = -db_11_5r;
  c[63] = -db_11_4r;
  const Scalar t66 = -s_3 * t35 - c_3 * Ic_3_yz + t13;
  const Scalar hu_3_t_x = c_3 * hc_3_x + s_3 * f_3_3_x;
  const Scalar t67 = s_3 * Ic_3_yz - c_3 * t35 + hu_3_t_x;
  const Scalar t68 = s_2 * t66 - c_2 * t67;
  c[4] = db_13_3 - t68;
  const Scalar c_2_1_3 = db_13_3 + t68;
  c[24] = c_2_1_3;
  c[7] = -t60 - t62;
  c[64] = -c_2_1_4;
  const Scalar t69 = Scalar(0.000216144) * c_4;
  const Scalar t70 = t5 * t52 + t38 * t69;
  const Scalar t71 = t70 - s_4 * (t53 * t20 - v_1_3_y * t16);
  const Scalar t72 = t39 + t34;
  const Scalar t73 = Scalar(0.000029232) * s_4 + t69;
  const Scalar t74 = c_5 * t73;
  const Scalar t75 = s_2 * (Scalar(0.000621792) * t2 - c_3 * t74 + s_3 * t72);
  const Scalar t76 = t75 - c_2 * (s_3 * t74 + c_3 * t72);
  const Scalar c_2_1_5 = t76 - t71;
  c[31] = c_2_1_5;
  const Scalar t77 = t70 - s_4 * (t10 * t53 - Scalar(0.5) * v_1_3_y * v_3_6_a_z);
  const Scalar t78 = t8 * t72 - t7 * t73;
  const Scalar c_3_1_5 = t78 - t77;
  c[52] = c_3_1_5;
  const Scalar t79 = s_2 * (Scalar(0.0118755) + t66) -
      c_2 * (Scalar(0.000621792) * t5 + t67 + Scalar(0.3451573495));
  c[2] = Scalar(-2.0) * t79;
  c[42] = -c_1_1_3;
  c[43] = -c_2_1_3;
  c[11] = -t76 - t71;
  c[85] = -c_2_1_5;
  c[12] = -t78 - t77;
  c[87] = -c_3_1_5;
  const Scalar t80 = Scalar(-2.0) * (s_3 * t63 - c_3 * Iu_3_t_d);
  const Scalar t81 = Iu_3_t_d - c_3 * t80 + Scalar(5.753497668221186) * hu_3_t_x +
      Scalar(0.800930601);
  const Scalar t82 = t63 - Scalar(0.0070992) + s_3 * t80 + db_22_3r;
  const Scalar t83 = c_2 * (s_2 * t81 - c_2 * t82);
  const Scalar c_2_1_1 = t83 + s_2 * (s_2 * t82 + c_2 * t81);
  c[21] = c_2_1_1;
  c[1] = -c_2_1_1;
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
// Reads q[1..4], qd[0..5]. Operations: 286 mul, 217 add, 8 sin/cos. Always zero: 2 of the 36
// entries of C.
template <class Scalar, class SinCos = LibrarySinCos>
inline void coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar t1 = Scalar(0.00020216) * s_5;
  C[21] = c_5 * qd_5 * t1;
  const Scalar v_1_3_y = s_2 * c_3 + c_2 * s_3;
  const Scalar t2 = c_5 * v_1_3_y;
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
  const Scalar t12 = t11 * v_1_3_y;
  const Scalar t13 = Scalar(0.00002) * qd_1 * t12;
  const Scalar t14 = Scalar(0.00002) * qd_2 + Scalar(0.00002) * qd_3;
  const Scalar t15 = t4 * t14;
  const Scalar t16 = s_5 * t9;
  C[33] = t13 + t15 - t16;
  const Scalar t17 = s_2 * (s_3 * t4 - c_3 * c_5);
  const Scalar mu_u_6_3_t_x = c_3 * t4 + s_3 * c_5;
  const Scalar t18 = Scalar(0.00002) * t17 - Scalar(0.00002) * c_2 * mu_u_6_3_t_x;
  const Scalar t19 = qd_1 * t18;
  C[11] = t10 - t19;
  C[23] = -t13 - t15 - t16;
  C[31] = t10 + t19;
  const Scalar t20 = c_4 * v_1_3_y;
  const Scalar t21 = s_5 * t3;
  const Scalar t22 = t21 - c_5 * t20;
  const Scalar t23 = qd_5 * t22 + qd_4 * t12;
  C[5] = C[30] = Scalar(0.00002) * t23 - qd_3 * t6 + qd_2 * t18;
  const Scalar C_56 = Scalar(0.00002) * (s_5 * qd_4 - qd_1 * t22) - t8 * t14;
  C[29] = C_56;
  const Scalar t24 = Scalar(0.000621792) * s_3;
  const Scalar v_o_2_4_x = t24 + Scalar(0.000623664);
  const Scalar t25 = Scalar(0.000621792) * c_3;
  const Scalar v_o_2_4_y = t25 - Scalar(0.000029232);
  const Scalar t26 = t4 * v_o_2_4_x - c_5 * v_o_2_4_y;
  const Scalar t27 = Scalar(0.00010108) * c_5;
  const Scalar t28 = t27 + v_o_2_4_x;
  const Scalar t29 = s_4 * t11 * t28 + c_4 * t26;
  const Scalar t30 = Scalar(2.0) * qd_5;
  const Scalar t31 = c_5 * t27;
  const Scalar Iu_4_t_d = t31 - Scalar(0.00015108);
  const Scalar t32 = c_4 * Iu_4_t_d;
  const Scalar t33 = t32 - s_5 * v_o_2_4_y;
  const Scalar t34 = s_4 * t33;
  const Scalar t35 = Scalar(2.0) * qd_4;
  const Scalar hc_3_x = Scalar(0.000216144) * t4 - Scalar(0.00190439375);
  const Scalar t36 = Scalar(0.000216144) * c_5;
  const Scalar f_3_3_x = t36 + Scalar(0.06467771475);
  const Scalar t37 = Scalar(5.753497668221186) * s_3 * hc_3_x -
      Scalar(5.753497668221186) * c_3 * f_3_3_x;
  const Scalar t38 = qd_3 * t37;
  C[7] = t34 * t35 - t29 * t30 - t38;
  const Scalar dmu_3_4_x = Scalar(0.000029232) * s_5 + t32;
  const Scalar t39 = s_4 * dmu_3_4_x;
  const Scalar t40 = t27 + Scalar(0.000623664);
  const Scalar t41 = t40 * t11;
  const Scalar t42 = Scalar(0.000058464) * c_5;
  const Scalar v_3_6_a_z = t42 + Scalar(0.001247328) * t4;
  const Scalar c_5_3_3 = Scalar(2.0) * s_4 * t41 + c_4 * v_3_6_a_z;
  C[14] = t39 * t35 - qd_5 * c_5_3_3;
  C[34] = -C_56;
  const Scalar t43 = s_4 * Iu_4_t_d;
  const Scalar t44 = s_4 * v_1_3_y;
  const Scalar t45 = t43 * t44;
  const Scalar t46 = t4 * t40;
  const Scalar t47 = t46 * t3;
  const Scalar t48 = Scalar(0.000216144) * t12;
  const Scalar t49 = t45 - dmu_3_4_x * t20 - t48 + t47;
  const Scalar mu_u_4_4_a_y = t31 - Scalar(0.00092108);
  const Scalar t50 = Scalar(0.000029232) * t4 - Scalar(0.000216144) * t11 + mu_u_4_4_a_y;
  const Scalar t51 = v_1_3_y * t50 - t47;
  const Scalar t52 = t51 - t49;
  const Scalar db_23_4r = t39 + t34;
  const Scalar t53 = t11 * t25;
  const Scalar c_3_2_4 = db_23_4r + t53;
  const Scalar t54 = Scalar(2.0) * qd_3;
  const Scalar t55 = Scalar(0.00002) * qd_6;
  const Scalar t56 = t4 * t55;
  const Scalar t57 = t56 + t39 * t54 + qd_2 * c_3_2_4 - qd_1 * t52;
  const Scalar t58 = s_4 * (s_5 * t1 - Scalar(0.00010108));
  const Scalar t59 = Scalar(0.000623664) * t8;
  const Scalar t60 = t59 - t58;
  const Scalar t61 = Scalar(0.00032108) * s_4;
  const Scalar t62 = t61 + t59;
  const Scalar t63 = t62 + t60;
  C[15] = -qd_5 * t63 - t46 * t35 + t57;
  const Scalar t64 = Scalar(2.876748834110593) * c_2;
  const Scalar v_o_1_4_z = Scalar(0.13524317121918722) * t3 + Scalar(2.8854097268487675) * v_1_3_y +
      t64;
  const Scalar t65 = s_4 * t3 - c_4 * v_o_1_4_z;
  const Scalar t66 = Scalar(0.00010108) * t22 + Scalar(0.000216144) * t65;
  const Scalar t67 = t4 * v_1_3_y + c_5 * t3;
  const Scalar t68 = Scalar(0.00010108) * s_5 * t67 + c_5 * t66;
  const Scalar t69 = Scalar(0.00032108) * t20 - t36 * t65;
  const Scalar t70 = t69 + t68;
  const Scalar c_4_3_5 = t62 - t60;
  const Scalar t71 = v_o_2_4_x * t8;
  const Scalar t72 = t71 - t58;
  const Scalar t73 = t61 + t71;
  const Scalar c_4_2_5 = t73 - t72;
  const Scalar t74 = t1 * (Scalar(0.09893153937475267) * qd_6 - c_5 * qd_4);
  const Scalar C_54 = t74 - qd_3 * c_4_3_5 - qd_2 * c_4_2_5 + qd_1 * t70;
  C[27] = C_54;
  C[20] = qd_5 * c_4_3_5 - t57;
  C[22] = -C_54;
  const Scalar t75 = c_4 * t3 + s_4 * v_o_1_4_z;
  const Scalar t76 = Scalar(0.000216144) * s_5;
  const Scalar t77 = t75 * t76;
  const Scalar t78 = t27 * t12 + t77;
  const Scalar t79 = s_4 * (Iu_4_t_d * t20 - t27 * t21);
  const Scalar t80 = v_1_3_y * (t20 * (Scalar(0.000432288) * s_5 - t43) - t79);
  const Scalar db_11_4r = t80 + t3 * (t77 + t78);
  const Scalar t81 = t12 * t55 + qd_1 * db_11_4r;
  const Scalar t82 = t48 - t45 + c_4 * (v_1_3_y * t33 - t21 * t28);
  const Scalar t83 = s_2 * (t4 * (s_3 * t40 + Scalar(0.000621792)) - c_3 * t50);
  const Scalar t84 = t83 - c_2 * (c_3 * t46 + s_3 * t50);
  const Scalar t85 = t82 + t84;
  const Scalar t86 = t69 - t68;
  const Scalar t87 = t49 + t51;
  C[3] = t81 + qd_5 * t86 - t78 * t35 + qd_3 * t87 - qd_2 * t85;
  const Scalar t88 = s_5 * t75 - t2;
  const Scalar t89 = Scalar(-0.000432288) * t88;
  const Scalar t90 = t44 * t89 + Scalar(2.0) * t67 * t66;
  const Scalar t91 = t22 * t55 + qd_1 * t90;
  const Scalar t92 = Scalar(0.000216144) * c_4;
  const Scalar t93 = t11 * t66 + t88 * t92;
  const Scalar t94 = t93 - s_4 * (t40 * t67 - Scalar(0.5) * v_1_3_y * v_3_6_a_z);
  const Scalar t95 = t76 + t62;
  const Scalar t96 = Scalar(0.000029232) * s_4 + t92;
  const Scalar t97 = t3 * t95 - t2 * t96;
  const Scalar t98 = t97 + t94;
  const Scalar t99 = t93 - s_4 * (t67 * t28 - v_1_3_y * t26);
  const Scalar t100 = c_5 * t96;
  const Scalar t101 = s_2 * (Scalar(0.000621792) * t8 - c_3 * t100 + s_3 * t95);
  const Scalar t102 = t101 - c_2 * (s_3 * t100 + c_3 * t95);
  const Scalar t103 = t102 + t99;
  C[4] = t91 + qd_4 * t86 - qd_3 * t98 - qd_2 * t103 + qd_5 * t89;
  const Scalar t104 = t84 - t82;
  const Scalar t105 = Scalar(2.0) * qd_2;
  const Scalar t106 = t56 + t34 * t105 + qd_1 * t104;
  const Scalar t107 = db_23_4r - t53;
  const Scalar t108 = t73 + t72;
  C[9] = qd_3 * t107 - qd_5 * t108 + t106 - t4 * t28 * t35;
  const Scalar Iu_3_t_d = c_4 * (Scalar(0.000058464) * s_5 + t32) + Scalar(0.001247328) * c_5 +
      mu_u_4_4_a_y + Scalar(0.150108592);
  const Scalar t109 = Scalar(2.0) * t46 - t42 - Scalar(0.0106736385);
  const Scalar t110 = t3 * (t109 * t3 - Iu_3_t_d * v_1_3_y - f_3_3_x * t64);
  const Scalar t111 = v_1_3_y * (hc_3_x * t64 + t109 * v_1_3_y + Iu_3_t_d * t3);
  const Scalar t112 = t110 - t111 - t64 * (hc_3_x * v_1_3_y + f_3_3_x * t3);
  const Scalar t113 = qd_6 * t6 - qd_1 * t112;
  const Scalar t114 = t97 - t94;
  const Scalar Ic_3_yz = t41 + Scalar(0.002352);
  const Scalar t115 = -s_3 * t39 - c_3 * Ic_3_yz + Scalar(0.1738073182028717) * t37;
  const Scalar hu_3_t_x = c_3 * hc_3_x + s_3 * f_3_3_x;
  const Scalar t116 = s_3 * Ic_3_yz - c_3 * t39 + hu_3_t_x;
  const Scalar t117 = s_2 * t115 - c_2 * t116;
  const Scalar db_13_3 = v_1_3_y * (Ic_3_yz + f_3_3_x) - t3 * (hc_3_x - t39);
  const Scalar c_2_1_3 = db_13_3 + t117;
  C[12] = qd_5 * t114 - qd_4 * t52 - qd_2 * c_2_1_3 + t113;
  const Scalar t118 = qd_2 * t37 - qd_1 * c_2_1_3;
  const Scalar t119 = t29 + Scalar(0.5) * c_5_3_3;
  const Scalar t120 = c_4 * c_5 * t25 - s_5 * t24;
  const Scalar t121 = t120 + t119;
  C[13] = qd_4 * c_3_2_4 - qd_5 * t121 + t118;
  const Scalar t122 = t8 * t55;
  const Scalar t123 = t122 + qd_1 * t114 - qd_3 * c_5_3_3 - qd_2 * t121;
  C[16] = -qd_5 * v_3_6_a_z - qd_4 * t63 + t123;
  C[18] = -t81 - qd_5 * t70 + qd_3 * t52 - qd_2 * t104;
  C[19] = qd_5 * c_4_2_5 - qd_3 * c_3_2_4 - t106;
  const Scalar t124 = t102 - t99;
  C[24] = qd_4 * t70 - t91 - qd_3 * t114 - qd_2 * t124;
  const Scalar t125 = -t122 - qd_1 * t124 + t29 * t105;
  C[25] = qd_3 * t121 - qd_4 * c_4_2_5 + t125;
  const Scalar c_1_2_3 = db_13_3 - t117;
  const Scalar t126 = qd_5 * t98 - qd_4 * t87 - qd_2 * c_1_2_3 + t113 - db_13_3 * t54;
  C[2] = -t126;
  const Scalar t127 = t120 - t119;
  C[8] = qd_4 * t107 + qd_5 * t127 - t38 - t118;
  C[10] = qd_3 * t127 - qd_4 * t108 - t125 - t26 * t30;
  C[26] = -qd_4 * c_4_3_5 - t123;
  const Scalar t128 = Scalar(-2.0) * (s_3 * t109 - c_3 * Iu_3_t_d);
  const Scalar t129 = Iu_3_t_d - c_3 * t128 + Scalar(5.753497668221186) * hu_3_t_x +
      Scalar(0.800930601);
  const Scalar t130 = t109 - Scalar(0.0070992) + s_3 * t128 - t37;
  const Scalar t131 = c_2 * (s_2 * t129 - c_2 * t130);
  const Scalar t132 = t131 + s_2 * (s_2 * t130 + c_2 * t129);
  C[0] = qd_4 * db_11_4r + qd_5 * t90 + qd_3 * t112 - qd_2 * t132;
  const Scalar t133 = qd_6 * t18 - qd_1 * t132;
  const Scalar t134 = s_2 * (Scalar(0.0118755) + t115) -
      c_2 * (Scalar(0.000621792) * t11 + t116 + Scalar(0.3451573495));
  C[1] = -qd_5 * t103 - qd_4 * t85 + qd_3 * c_1_2_3 + t133 - t134 * t105;
  C[6] = qd_5 * t124 + qd_4 * t104 + qd_3 * c_2_1_3 - t133;
  C[28] = C[35] = Scalar(0.0);
}

// Gravity torques g(q) (7.39).
//   q[6]  in   joint positions, rad or m
//   g[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..4]. Operations: 20 mul, 11 add, 8 sin/cos. Always zero: g[0], g[5].
template <class Scalar, class SinCos = LibrarySinCos>
inline void gravity(const Scalar* q, Scalar* g, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar g_3_x = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = Scalar(0.0282528) * s_5;
  g[3] = s_4 * t1 * g_3_x;
  const Scalar t2 = Scalar(0.0282528) * c_5;
  g[4] = t1 * (s_2 * s_3 - c_2 * c_3) - c_4 * t2 * g_3_x;
  const Scalar hc_3_x = c_4 * t1 - Scalar(0.24892875);
  const Scalar t3 = t2 + Scalar(8.45420895);
  const Scalar t4 = s_3 * hc_3_x - c_3 * t3;
  const Scalar hu_3_t_x = c_3 * hc_3_x + s_3 * t3;
  g[2] = s_2 * t4 - c_2 * hu_3_t_x;
  const Scalar hc_2_x = hu_3_t_x + Scalar(37.2347379);
  g[1] = s_2 * (Scalar(1.024164) + t4) - c_2 * hc_2_x;
  g[0] = g[5] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   n[6]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..4], qd[0..5]. Operations: 155 mul, 123 add, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = s_2 * qd_1;
  const Scalar t3 = s_3 * t1 + c_3 * t2;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_r_4_y = s_4 * t3 + c_4 * omega_3_z;
  const Scalar t4 = s_3 * t2 - c_3 * t1;
  const Scalar omega_4_z = qd_4 - t4;
  const Scalar t5 = omega_r_4_y * omega_4_z;
  const Scalar t6 = t4 * omega_3_z;
  const Scalar t7 = Scalar(-2.0) * t6;
  const Scalar t8 = t3 * t4;
  const Scalar t9 = s_4 * t8 + t5 - c_4 * t7;
  const Scalar U_4_zy = t5 + t9;
  const Scalar t10 = s_4 * omega_3_z - c_4 * t3;
  const Scalar t11 = s_5 * omega_4_z - c_5 * t10;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar t12 = t11 * omega_5_z;
  const Scalar t13 = t10 * omega_r_4_y;
  const Scalar t14 = t3 * omega_3_z;
  const Scalar U_4_xy = t13 + t14;
  const Scalar domega_5_y = t12 - s_5 * U_4_zy + c_5 * U_4_xy;
  const Scalar t15 = Scalar(0.00004) * domega_5_y;
  n[5] = Scalar(0.2158232532732) * qd_6 - t15 + Scalar(0.55443978) * detail::sign(qd_6);
  const Scalar t16 = t2 * t2;
  const Scalar t17 = qd_2 * qd_2;
  const Scalar t18 = qd_1 * qd_1;
  const Scalar t19 = t17 - t16 + t18;
  const Scalar t20 = Scalar(22.71885132005558) * s_2 + t19;
  const Scalar t21 = t2 * t1;
  const Scalar t22 = Scalar(22.71885132005558) * c_2 - t21;
  const Scalar t23 = s_3 * t22 + c_3 * t20;
  const Scalar t24 = t3 * t3;
  const Scalar t25 = omega_3_z * omega_3_z;
  const Scalar t26 = t18 - t24 + t25;
  const Scalar t27 = Scalar(0.04701250578971746) * t26 + Scalar(1.0030106530801297) * t8 - t23;
  const Scalar t28 = qd_2 * t2;
  const Scalar t29 = Scalar(0.3476146364057434) * t18 + Scalar(2.0) * t28;
  const Scalar t30 = t29 - Scalar(0.09402501157943492) * t14 + Scalar(2.0060213061602594) * t6;
  const Scalar t31 = s_4 * t30 - c_4 * t27;
  const Scalar t32 = s_3 * t20 - c_3 * t22;
  const Scalar Uz_o_4_y = t24 + t25;
  const Scalar t33 = Scalar(0.04701250578971746) * t8 + Scalar(1.0030106530801297) * Uz_o_4_y + t32;
  const Scalar t34 = s_5 * t33 - c_5 * t31;
  const Scalar omega_r_6_a_z = s_5 * t10 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t35 = Scalar(0.00004) * omega_6_z;
  const Scalar t36 = t11 * omega_r_6_a_z;
  const Scalar t37 = t10 * omega_4_z;
  const Scalar t38 = t37 - c_4 * t8 - s_4 * t7;
  const Scalar t39 = Scalar(0.00024216) * t36 - t11 * t35 + Scalar(0.00064216) * t38 -
      Scalar(0.001243584) * t34;
  n[4] = Scalar(0.85444524) * detail::sign(qd_5) - t39 + Scalar(0.4272830209354) * qd_5;
  const Scalar mu_5_y = t15 + Scalar(0.0004) * t12;
  const Scalar t40 = omega_r_6_a_z * omega_5_z;
  const Scalar t41 = t40 - s_5 * U_4_xy - c_5 * U_4_zy;
  const Scalar t42 = s_4 * t27 + c_4 * t30;
  const Scalar t43 = omega_5_z * t35 - Scalar(0.00024216) * t41 - Scalar(0.00064216) * t40 +
      Scalar(0.001243584) * t42;
  const Scalar mu_u_4_a_y = Scalar(0.0003) * t13 + c_5 * mu_5_y + Scalar(0.0016) * t14 + s_5 * t43;
  n[3] = Scalar(0.411645229697152) * qd_4 - mu_u_4_a_y + Scalar(1.06831142) * detail::sign(qd_4);
  const Scalar mu_4_x = Scalar(0.0003) * t9 - s_5 * mu_5_y + Scalar(0.0016) * t5 + c_5 * t43;
  const Scalar Uz_o_6_z = t40 + t41;
  const Scalar t44 = Scalar(0.23306405) * t42 - Scalar(0.001243584) * Uz_o_6_z;
  const Scalar Uz_o_6_y = t11 * t11 + omega_5_z * omega_5_z;
  const Scalar t45 = Scalar(0.001243584) * s_5;
  const Scalar U_5_xy = t36 + t38;
  const Scalar t46 = Scalar(0.001243584) * c_5;
  const Scalar t47 = Uz_o_6_y * t45 + U_5_xy * t46 + Scalar(0.23306405) * t31;
  const Scalar t48 = s_4 * t44 - c_4 * t47;
  const Scalar t49 = Scalar(0.0013) * t37 + t39;
  const Scalar t50 = Uz_o_6_y * t46 - U_5_xy * t45 + Scalar(0.23306405) * t33;
  const Scalar t51 = Scalar(0.000316274) * (t26 - Uz_o_4_y) - s_4 * mu_4_x + c_4 * t49 -
      Scalar(0.065620624) * t8 + Scalar(0.04701250578971746) * t50 + Scalar(0.138357356) * t23 -
      Scalar(1.0030106530801297) * t48;
  n[2] = Scalar(6.36419655) * detail::sign(qd_3) - t51 + Scalar(3.9804259903722) * qd_3;
  const Scalar t52 = Scalar(-0.138357356) * t8 - t48 + Scalar(1.405871712) * t23;
  const Scalar f_3_y = Scalar(0.138357356) * Uz_o_4_y + t50 + Scalar(1.405871712) * t32;
  const Scalar t53 = s_3 * t52 - c_3 * f_3_y;
  const Scalar t54 = t16 + t17;
  n[1] = Scalar(0.0070992) * (t19 - t54) - Scalar(0.03707456) * t21 + Scalar(1.024164) * s_2 - t51 +
      Scalar(10.6197775) * detail::sign(qd_2) + Scalar(9.496868641825) * qd_2 - t53;
  const Scalar t55 = s_4 * t47 + c_4 * t44;
  const Scalar U_3_yy_zz = t18 - Uz_o_4_y;
  const Scalar mu_3_x = Scalar(0.000632548) * t14 + s_4 * t49 + c_4 * mu_4_x +
      Scalar(0.004704) * U_3_yy_zz + Scalar(0.138357356) * t29 + Scalar(0.143741248) * t6 +
      Scalar(1.0030106530801297) * t55;
  const Scalar t56 = Scalar(0.000632548) * t6 + Scalar(0.004704) * t8 + mu_u_4_a_y +
      Scalar(0.0125) * t14 - Scalar(0.04701250578971746) * t55;
  const Scalar U_2_yy_zz = t18 - t54;
  const Scalar t57 = qd_2 * t1;
  const Scalar t58 = Scalar(0.0141984) * t28 + s_3 * t56 + Scalar(0.023751) * U_2_yy_zz +
      Scalar(0.12059664) * t21 + Scalar(0.1462528) * t57 - c_3 * mu_3_x -
      Scalar(0.3476146364057434) * t53;
  const Scalar t59 = s_3 * f_3_y + c_3 * t52;
  const Scalar mu_2_y = Scalar(0.023751) * t21 + Scalar(0.0141984) * t57 + c_3 * t56 +
      Scalar(0.07210368) * t28 + Scalar(0.12059664) * (t18 - t19) + Scalar(0.276714712) * t6 +
      s_3 * mu_3_x + t55 - Scalar(0.3476146364057434) * t59 + Scalar(1.405871712) * t29;
  n[0] = s_2 * t58 - c_2 * mu_2_y + Scalar(5.8018217679508) * qd_1 +
      Scalar(25.9836065) * detail::sign(qd_1);
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   tau[6]  in   joint torques or forces, N m or N
//   qdd[6]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[1..4], qd[0..5], tau[0..5]. Operations: 303 mul, 241 add, 4 div, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar tau_1 = tau[0], tau_2 = tau[1], tau_3 = tau[2], tau_4 = tau[3], tau_5 = tau[4],
      tau_6 = tau[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar t1 = qd_1 * (c_2 * s_3 + s_2 * c_3);
  const Scalar t2 = c_4 * t1;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t3 = s_4 * omega_3_z;
  const Scalar t4 = t3 - t2;
  const Scalar t5 = qd_1 * (s_2 * s_3 - c_2 * c_3);
  const Scalar omega_4_z = qd_4 - t5;
  const Scalar omega_r_6_a_z = s_5 * t4 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t6 = Scalar(0.00004) * omega_6_z;
  const Scalar t7 = s_4 * t1;
  const Scalar t8 = c_4 * omega_3_z;
  const Scalar omega_r_4_y = t7 + t8;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar t9 = s_2 * qd_1;
  const Scalar t10 = t9 * t9;
  const Scalar t11 = qd_2 * qd_2;
  const Scalar t12 = qd_1 * qd_1;
  const Scalar t13 = t11 - t10 + t12;
  const Scalar t14 = Scalar(65.3564290473018) * s_2 + Scalar(2.876748834110593) * t13;
  const Scalar t15 = c_2 * qd_1;
  const Scalar t16 = t9 * t15;
  const Scalar t17 = Scalar(65.3564290473018) * c_2 - Scalar(2.876748834110593) * t16;
  const Scalar t18 = s_3 * t17 + c_3 * t14;
  const Scalar t19 = t1 * t1;
  const Scalar t20 = omega_3_z * omega_3_z;
  const Scalar t21 = t12 - t19 + t20;
  const Scalar t22 = t1 * t5;
  const Scalar t23 = Scalar(0.13524317121918722) * t21 + Scalar(2.8854097268487675) * t22 - t18;
  const Scalar t24 = omega_3_z * t1;
  const Scalar t25 = omega_3_z * t5;
  const Scalar t26 = qd_2 * t9;
  const Scalar t27 = t12 + Scalar(5.753497668221186) * t26;
  const Scalar t28 = t27 - Scalar(0.27048634243837444) * t24 + Scalar(5.770819453697535) * t25;
  const Scalar t29 = s_4 * t23 + c_4 * t28;
  const Scalar t30 = omega_r_6_a_z * omega_5_z;
  const Scalar t31 = omega_5_z * t6 - Scalar(0.00088432) * t30 + Scalar(0.000432288) * t29;
  const Scalar t32 = s_5 * omega_4_z - c_5 * t4;
  const Scalar t33 = t32 * omega_5_z;
  const Scalar t34 = omega_r_4_y * omega_4_z;
  const Scalar t35 = t5 * (t7 + Scalar(2.0) * t8) + Scalar(2.0) * t34;
  const Scalar t36 = t4 * omega_r_4_y;
  const Scalar U_4_xy = t36 + t24;
  const Scalar domega_5_y = t33 + c_5 * U_4_xy - s_5 * t35;
  const Scalar mu_5_y = Scalar(0.00064216) * t33 - Scalar(0.00020216) * domega_5_y;
  const Scalar mu_4_x = Scalar(0.00238432) * t34 - s_5 * mu_5_y + c_5 * t31;
  const Scalar t37 = s_3 * t14 - c_3 * t17;
  const Scalar Uz_o_4_y = t19 + t20;
  const Scalar t38 = s_5 * (Scalar(0.13524317121918722) * t22 +
      Scalar(2.8854097268487675) * Uz_o_4_y + t37);
  const Scalar t39 = t38 - c_5 * (s_4 * t28 - c_4 * t23);
  const Scalar t40 = t32 * omega_r_6_a_z;
  const Scalar t41 = t4 * omega_4_z;
  const Scalar t42 = t41 + t5 * (Scalar(2.0) * t3 - t2);
  const Scalar t43 = Scalar(0.00024216) * t40 - t32 * t6 + Scalar(0.00064216) * t42 -
      Scalar(0.000432288) * t39;
  const Scalar t44 = Scalar(0.00184216) * t41 - Scalar(0.00054216) * t42 + t43;
  const Scalar Uz_o_6_y = t32 * t32 + omega_5_z * omega_5_z;
  const Scalar t45 = Scalar(0.000432288) * s_5;
  const Scalar U_5_xy = t40 + t42;
  const Scalar t46 = Scalar(0.000432288) * c_5;
  const Scalar t47 = t45 * Uz_o_6_y + t46 * U_5_xy;
  const Scalar Uz_o_6_z = Scalar(2.0) * t30 - s_5 * U_4_xy - c_5 * t35;
  const Scalar t48 = Scalar(0.000432288) * Uz_o_6_z;
  const Scalar t49 = c_4 * t47 + s_4 * t48;
  const Scalar t50 = t45 * U_5_xy - t46 * Uz_o_6_y;
  const Scalar t51 = c_4 * t44 - Scalar(0.13524317121918722) * t50 - s_4 * mu_4_x +
      Scalar(2.8854097268487675) * t49 + Scalar(0.0038087875) * t37 -
      Scalar(0.0106736385) * (t21 - Uz_o_4_y) - Scalar(0.300117184) * t22 +
      Scalar(0.1293554295) * t18;
  const Scalar t52 = Scalar(0.2158232532732) * qd_6 - Scalar(0.00004) * domega_5_y +
      Scalar(0.55443978) * detail::sign(qd_6) - tau_6;
  const Scalar t53 = s_4 * s_5;
  const Scalar t54 = Scalar(0.00019430115597482132) * t53;
  const Scalar t55 = t54 * t52 + t51;
  const Scalar mu_u_4_a_y = Scalar(0.00054216) * t36 + c_5 * mu_5_y + Scalar(0.00184216) * t24 +
      s_5 * t31;
  const Scalar t56 = Scalar(0.00019430115597482132) * c_5;
  const Scalar t57 = -t56 * t52 - mu_u_4_a_y + Scalar(0.411645229697152) * qd_4 +
      Scalar(1.06831142) * detail::sign(qd_4) - tau_4;
  const Scalar t58 = Scalar(0.00020216) * c_5;
  const Scalar t59 = t58 + Scalar(0.001247328);
  const Scalar t60 = t59 * t53;
  const Scalar t61 = Scalar(7.772046238992852e-09) * t53;
  const Scalar t62 = c_5 * t61 + t60;
  const Scalar t63 = Scalar(0.00020216777204623898) * c_5 * c_5 - Scalar(0.2041958543736);
  const Scalar t64 = Scalar(1.0) / t63;
  const Scalar t65 = t62 * t64;
  const Scalar t66 = Scalar(0.85444524) * detail::sign(qd_5) - t43 +
      Scalar(0.4272830209354) * qd_5 - tau_5;
  const Scalar t67 = Scalar(0.001247328) * c_5 + Scalar(0.00064216);
  const Scalar t68 = Scalar(0.000058464) * s_5 - c_4 * t67;
  const Scalar t69 = Scalar(5.5037503582353615) * t68;
  const Scalar t70 = t69 * t66 - t65 * t57 + Scalar(6.36419655) * detail::sign(qd_3) - t55 +
      Scalar(3.9804259903722) * qd_3 - tau_3;
  const Scalar t71 = c_5 * t58;
  const Scalar Iu_5_t_xx = t71 - Scalar(0.00020216);
  const Scalar Iu_4_t_d = Iu_5_t_xx - Scalar(0.0001);
  const Scalar t72 = c_4 * Iu_4_t_d;
  const Scalar t73 = c_4 * t72;
  const Scalar t74 = c_4 * s_5;
  const Scalar t75 = Scalar(0.000116928) * t74;
  const Scalar t76 = Scalar(0.002494656) * c_5;
  const Scalar Ic_3_zz = -t75 - t73 + Iu_5_t_xx + t76 + Scalar(0.313647409);
  const Scalar t77 = Ic_3_zz - t53 * t61;
  const Scalar b_4_3_3 = t62 * t65 - t68 * t69 + t77 + Scalar(0.86242563124731);
  const Scalar d_3 = Scalar(1.0) / b_4_3_3;
  const Scalar t78 = Scalar(0.001243584) * t53;
  const Scalar t79 = s_3 * t78 + t62;
  const Scalar f_u_5_3_t_y = s_3 * c_4 * t46 + c_3 * t45;
  const Scalar t80 = t68 - Scalar(2.876748834110593) * f_u_5_3_t_y;
  const Scalar f_3_3_x = t46 + Scalar(0.1293554295);
  const Scalar hc_3_x = Scalar(0.000432288) * t74 - Scalar(0.0038087875);
  const Scalar hu_3_t_x = c_3 * hc_3_x + s_3 * f_3_3_x;
  const Scalar b_4_3_2 = t79 * t65 - t80 * t69 + Scalar(2.876748834110593) * hu_3_t_x + t77;
  const Scalar t81 = b_4_3_2 * d_3;
  const Scalar t82 = Scalar(0.0038087875) * t21 - t49 + Scalar(0.1293554295) * t22;
  const Scalar t83 = Scalar(0.0038087875) * t22 - t50 + Scalar(0.1293554295) * Uz_o_4_y;
  const Scalar t84 = s_3 * t82 + c_3 * t83;
  const Scalar t85 = t79 * t64;
  const Scalar t86 = Scalar(5.5037503582353615) * t80;
  const Scalar t87 = t10 + t11;
  const Scalar t88 = t85 * t57 - t86 * t66 - Scalar(0.0070992) * (t13 - t87) -
      Scalar(1.024164) * s_2 - Scalar(1.601861202) * t16 - Scalar(2.876748834110593) * t84 + t55 -
      Scalar(10.6197775) * detail::sign(qd_2) + tau_2 + t81 * t70 + Scalar(37.2347379) * c_2 -
      Scalar(9.496868641825) * qd_2;
  const Scalar Ic_3_xz = Scalar(0.000058464) * t53 + s_4 * t72;
  const Scalar Ic_3_yz = t60 + Scalar(0.004704);
  const Scalar t89 = (s_3 * Ic_3_yz - c_3 * Ic_3_xz) + hu_3_t_x;
  const Scalar Iu_3_t_yz = s_3 * Ic_3_xz + c_3 * Ic_3_yz;
  const Scalar t90 = s_3 * hc_3_x - c_3 * f_3_3_x;
  const Scalar t91 = t90 - Iu_3_t_yz;
  const Scalar mu_u_4_4_a_y = t71 - Scalar(0.00184216);
  const Scalar mu_4_3_y = Scalar(0.000058464) * t74 + mu_u_4_4_a_y;
  const Scalar t92 = Scalar(0.000432288) * t53 - mu_4_3_y;
  const Scalar t93 = t74 * t59;
  const Scalar t94 = c_2 * (s_3 * t93 + Scalar(0.001243584) * t74 + c_3 * t92);
  const Scalar t95 = Scalar(0.00004) * s_3;
  const Scalar t96 = Scalar(0.00004) * c_3;
  const Scalar mu_u_6_3_t_x = t74 * t96 + c_5 * t95;
  const Scalar t97 = s_2 * mu_u_6_3_t_x + c_2 * (t74 * t95 - c_5 * t96);
  const Scalar b_6_4_1 = t97 * t56 + s_2 * (c_3 * t93 - s_3 * t92) + t94;
  const Scalar t98 = s_4 * t67;
  const Scalar t99 = c_5 * (s_4 - Scalar(0.04701250578971746) * c_3 *
      (s_4 + Scalar(7.394088669950739) * c_4));
  const Scalar t100 = Scalar(0.000058464) * c_5;
  const Scalar t101 = s_2 * (s_3 * s_4 * t100 + f_u_5_3_t_y + c_3 * t98);
  const Scalar mu_u_5_2_a_z = t101 + c_2 * (s_3 * (t45 + t98) + Scalar(0.001243584) * t99);
  const Scalar t102 = t97 * t54;
  const Scalar t103 = -t102 - mu_u_5_2_a_z * t69 + b_6_4_1 * t65 - s_2 * t89 - c_2 * t91;
  const Scalar t104 = s_2 * (t78 + t89 + Scalar(0.690314699));
  const Scalar t105 = t102 - b_6_4_1 * t85 + mu_u_5_2_a_z * t86 + t103 * t81 +
      c_2 * (Scalar(0.023751) + t91) + t104;
  const Scalar t106 = Scalar(5.753497668221186) * hu_3_t_x;
  const Scalar b_3_2_2 = t79 * t85 - t80 * t86 - b_4_3_2 * t81 + t77 + t106 +
      Scalar(6.502360360025);
  const Scalar d_2 = Scalar(1.0) / b_3_2_2;
  const Scalar t107 = t105 * d_2;
  const Scalar t108 = s_4 * t47 - c_4 * t48;
  const Scalar U_3_yy_zz = t12 - Uz_o_4_y;
  const Scalar t109 = s_4 * t44 + c_4 * mu_4_x + Scalar(2.8854097268487675) * t108 +
      Scalar(0.004704) * U_3_yy_zz - Scalar(0.021347277) * t24 + Scalar(0.1293554295) * t27 +
      Scalar(0.613764593) * t25;
  const Scalar t110 = Scalar(0.13524317121918722) * t108 - Scalar(0.004704) * t22 - mu_u_4_a_y -
      Scalar(0.013530225) * t24 + Scalar(0.0038087875) * t27 + Scalar(0.021347277) * t25;
  const Scalar t111 = qd_2 * t15;
  const Scalar mu_2_y = Scalar(2.876748834110593) * t108 + Scalar(0.023751) * t16 +
      Scalar(0.0141984) * t111 - Scalar(0.02191385) * t24 + c_3 * (t82 - t110) +
      Scalar(0.744246162) * t25 - s_3 * (t83 - t109) + Scalar(0.690314699) * (t12 - t13) +
      Scalar(3.349975204) * t26;
  const Scalar t112 = t103 * d_3;
  const Scalar U_2_yy_zz = t12 - t87;
  const Scalar t113 = Scalar(0.0141984) * t26 - s_3 * t110 + Scalar(0.023751) * U_2_yy_zz +
      Scalar(0.1462528) * t111 + t84 + Scalar(0.690314699) * t16 - c_3 * t109;
  const Scalar t114 = b_6_4_1 * t64;
  const Scalar t115 = Scalar(5.5037503582353615) * mu_u_5_2_a_z;
  const Scalar t116 = Scalar(-4.857528899370533) * t97;
  const Scalar t117 = -t116 * t52 - t115 * t66 + t114 * t57 + t112 * t70 + t107 * t88 + s_2 * t113 -
      tau_1 + Scalar(5.8018217679508) * qd_1 + Scalar(25.9836065) * detail::sign(qd_1) -
      c_2 * mu_2_y;
  const Scalar Ic_3_xx = t73 + Scalar(0.0001) + t76;
  const Scalar t118 = t75 + mu_u_4_4_a_y + Scalar(0.300117184);
  const Scalar Iu_3_t_d = Ic_3_xx + t118;
  const Scalar t119 = t93 - t100 - Scalar(0.0106736385);
  const Scalar t120 = Scalar(2.0) * s_3 * t119 - c_3 * Iu_3_t_d;
  const Scalar t121 = s_2 * (t119 - Scalar(0.0070992) - s_3 * t120 -
      Scalar(2.876748834110593) * t90);
  const Scalar t122 = c_3 * t120;
  const Scalar t123 = Scalar(2.0) * t121 +
      c_2 * (Iu_3_t_d + Scalar(2.0) * t122 + t106 + Scalar(1.601861202));
  const Scalar b_2_1_1 = t97 * t116 - mu_u_5_2_a_z * t115 + b_6_4_1 * t114 +
      Scalar(0.000864576) * t53 - t103 * t112 - t105 * t107 - t122 - t118 + c_2 * t123 +
      Scalar(2.99250185137411);
  const Scalar d_1 = Scalar(1.0) / b_2_1_1;
  const Scalar t124 = d_1 * t117;
  qdd[0] = -t124;
  const Scalar qdd_2 = d_2 * (t105 * t124 + t88);
  qdd[1] = qdd_2;
  const Scalar t125 = d_3 * ((t103 * t124 + b_4_3_2 * qdd_2) + t70);
  qdd[2] = -t125;
  const Scalar t126 = t80 * qdd_2 - t68 * t125;
  qdd[4] = Scalar(5.5037503582353615) * t126 -
      Scalar(5.5037503582353615) * (t66 - mu_u_5_2_a_z * t124);
  const Scalar qdd_4 = t64 * ((t62 * t125 + t57) - (t79 * qdd_2 + b_6_4_1 * t124));
  qdd[3] = qdd_4;
  const Scalar t127 = t53 * (qdd_2 - t125) + c_5 * qdd_4;
  qdd[5] = Scalar(-0.00019430115597482132) * t127 - Scalar(4.857528899370533) * (t97 * t124 + t52);
  bool positive = b_2_1_1 > Scalar(0.0);
  positive &= b_3_2_2 > Scalar(0.0);
  positive &= b_4_3_3 > Scalar(0.0);
  positive &= -t63 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[6]   in  joint positions, rad or m
//   qd[6]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1..4], qd[0..5]. Operations: 75 mul, 49 add, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar kinetic_energy(const Scalar* q, const Scalar* qd,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar t1 = s_2 * qd_1;
  const Scalar v_o_3_y = t1 + Scalar(2.876748834110593) * qd_2;
  const Scalar t2 = c_2 * qd_1;
  const Scalar t3 = c_3 * t2;
  const Scalar t4 = t3 - s_3 * v_o_3_y;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t5 = t4 - Scalar(2.8854097268487675) * omega_3_z;
  const Scalar t6 = s_3 * t2;
  const Scalar t7 = t6 + c_3 * t1;
  const Scalar t8 = s_3 * t1 - t3;
  const Scalar v_o_4_z = Scalar(0.13524317121918722) * t8 + Scalar(2.876748834110593) * t2 +
      Scalar(2.8854097268487675) * t7;
  const Scalar v_r_3_y = t6 + c_3 * v_o_3_y;
  const Scalar v_o_4_y = v_r_3_y - Scalar(0.13524317121918722) * omega_3_z;
  const Scalar t9 = s_5 * v_o_4_y + c_5 * (s_4 * v_o_4_z - c_4 * t5);
  const Scalar omega_5_z = s_4 * t7 + qd_5 + c_4 * omega_3_z;
  const Scalar t10 = omega_5_z * (Scalar(0.00064216) * omega_5_z + Scalar(0.000864576) * t9);
  const Scalar v_r_4_y = c_4 * v_o_4_z + s_4 * t5;
  const Scalar t11 = s_4 * omega_3_z - c_4 * t7;
  const Scalar t12 = t8 - qd_4;
  const Scalar t13 = s_5 * t12 + c_5 * t11;
  const Scalar t14 = t13 * (Scalar(0.000864576) * v_r_4_y - Scalar(0.00024216) * t13);
  const Scalar omega_6_z = qd_6 + s_5 * t11 - c_5 * t12;
  const Scalar t15 = Scalar(0.004704) * t8 - Scalar(0.007617575) * v_r_3_y -
      Scalar(0.258710859) * t4 + Scalar(0.313105249) * omega_3_z;
  const Scalar L_3_y = Scalar(0.0106736385) * t7 + Scalar(0.004704) * omega_3_z +
      Scalar(0.02191385) * t2;
  const Scalar t16 = t7 * (Scalar(0.0106736385) * t8 + Scalar(0.299575024) * t7 +
      Scalar(0.744246162) * t2);
  const Scalar t17 = s_2 * (Scalar(0.690314699) * qd_2 - Scalar(0.0070992) * t2 -
      Scalar(1.601861202) * t1);
  const Scalar t18 = c_2 * (Scalar(0.023751) * qd_2 - Scalar(0.0070992) * t1) + t17 +
      Scalar(4.29424586937411) * qd_1;
  const Scalar t19 = qd_2 * (Scalar(0.023751) * t2 + Scalar(0.690314699) * t1 +
      Scalar(6.502360360025) * qd_2);
  const Scalar T_2 = Scalar(0.00004) * omega_6_z * omega_6_z + Scalar(0.0003) * t11 * t11 +
      Scalar(0.0016) * t12 * t12 + t10 - t14 + t8 * L_3_y + Scalar(0.20582599086) * qd_6 * qd_6 +
      Scalar(0.181052127515) * qd_5 * qd_5 + Scalar(0.2023536943736) * qd_4 * qd_4 + t16 +
      Scalar(0.86242563124731) * qd_3 * qd_3 + omega_3_z * t15 + t19 + qd_1 * t18;
  return Scalar(0.5) * T_2;
}

// Potential energy of links and rotors (7.36).
//   q[6]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[1..4]. Operations: 10 mul, 7 add, 7 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar potential_energy(const Scalar* q, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], c_4 = cosine[3],
      s_5 = sine[4], c_5 = cosine[4];
  const Scalar hc_3_x = Scalar(0.00288) * c_4 * s_5 - Scalar(0.025375);
  const Scalar t1 = Scalar(0.00288) * c_5 + Scalar(0.861795);
  const Scalar hu_3_t_x = c_3 * hc_3_x + s_3 * t1;
  const Scalar hc_2_x = hu_3_t_x + Scalar(3.79559);
  const Scalar hu_2_a_z = c_2 * ((c_3 * t1 - s_3 * hc_3_x) - Scalar(0.1044)) - s_2 * hc_2_x;
  return Scalar(9.81) * hu_2_a_z;
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
// Reads q[0..5]. Operations: 60 mul, 29 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void forward_kinematics(const Scalar* q, Scalar* R, Scalar* p,
    const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = Scalar(0.0203) * c_3 - Scalar(0.4331) * s_3 - Scalar(0.4318);
  const Scalar t2 = Scalar(0.0203) * s_3 + Scalar(0.4331) * c_3;
  p[2] = c_2 * t2 + s_2 * t1;
  const Scalar t3 = s_2 * t2 - c_2 * t1;
  p[1] = Scalar(0.1501) * c_1 + s_1 * t3;
  const Scalar t4 = c_3 * s_5;
  const Scalar a_3_t_x = s_3 * c_5 + c_4 * t4;
  const Scalar t5 = s_3 * s_5;
  const Scalar t6 = c_4 * t5 - c_3 * c_5;
  R[8] = -s_2 * a_3_t_x - c_2 * t6;
  p[0] = c_1 * t3 - Scalar(0.1501) * s_1;
  const Scalar t7 = c_4 * c_5;
  const Scalar t8 = s_4 * s_6;
  const Scalar t9 = t8 - c_6 * t7;
  const Scalar t10 = c_6 * t5 + c_3 * t9;
  const Scalar t11 = s_3 * t9 - c_6 * t4;
  R[6] = s_2 * t10 + c_2 * t11;
  const Scalar t12 = s_4 * c_6;
  const Scalar t13 = t12 + s_6 * t7;
  const Scalar t14 = s_6 * t5 - c_3 * t13;
  const Scalar t15 = s_3 * t13 + s_6 * t4;
  R[7] = c_2 * t15 - s_2 * t14;
  const Scalar t16 = s_2 * t6 - c_2 * a_3_t_x;
  const Scalar t17 = s_4 * s_5;
  R[2] = -s_1 * t17 - c_1 * t16;
  R[5] = c_1 * t17 - s_1 * t16;
  const Scalar n_2_t_x = s_2 * t11 - c_2 * t10;
  const Scalar n_4_t_y = c_5 * t12 + c_4 * s_6;
  R[3] = s_1 * n_2_t_x + c_1 * n_4_t_y;
  const Scalar t18 = s_2 * t15 + c_2 * t14;
  const Scalar t19 = c_5 * t8 - c_4 * c_6;
  R[1] = s_1 * t19 + c_1 * t18;
  R[4] = s_1 * t18 - c_1 * t19;
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
// Reads q[0..4]. Operations: 66 mul, 30 add, 10 sin/cos. Always zero: 6 of the 36 entries of J.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian(const Scalar* q, Scalar* J, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  J[25] = J[26] = c_1;
  J[19] = J[20] = -s_1;
  const Scalar z_4_z = c_2 * c_3 - s_2 * s_3;
  J[33] = z_4_z;
  const Scalar t1 = c_2 * s_3 + s_2 * c_3;
  const Scalar z_4_x = c_1 * t1;
  J[21] = z_4_x;
  const Scalar z_4_y = s_1 * t1;
  J[27] = z_4_y;
  J[34] = s_4 * t1;
  const Scalar t2 = Scalar(0.0203) * s_3 + Scalar(0.4331) * c_3;
  const Scalar t3 = Scalar(0.0203) * c_3 - Scalar(0.4331) * s_3 - Scalar(0.4318);
  const Scalar p_2u_a_z = c_2 * t2 + s_2 * t3;
  J[1] = c_1 * p_2u_a_z;
  J[7] = s_1 * p_2u_a_z;
  const Scalar t4 = c_2 * t3 - s_2 * t2;
  const Scalar J_P3_z = Scalar(0.4318) * c_2 + t4;
  J[14] = J_P3_z;
  const Scalar t5 = s_1 * s_4;
  const Scalar t6 = c_1 * c_4;
  const Scalar R_41_y = t6 - z_4_z * t5;
  J[28] = R_41_y;
  const Scalar z_6_z = c_5 * z_4_z - c_4 * s_5 * t1;
  J[35] = z_6_z;
  const Scalar r_3_z = Scalar(0.4318) * s_2 + p_2u_a_z;
  J[2] = c_1 * r_3_z;
  J[8] = s_1 * r_3_z;
  const Scalar t7 = c_1 * s_4;
  const Scalar t8 = s_1 * c_4;
  const Scalar t9 = t8 + z_4_z * t7;
  J[22] = -t9;
  const Scalar t10 = Scalar(0.1501) * s_1 + c_1 * t4;
  J[6] = -t10;
  const Scalar p_1u_t_y = Scalar(0.1501) * c_1 - s_1 * t4;
  J[0] = -p_1u_t_y;
  const Scalar z_6_x = c_5 * z_4_x - s_5 * (t5 - z_4_z * t6);
  J[23] = z_6_x;
  const Scalar z_6_y = c_5 * z_4_y + s_5 * (t7 + z_4_z * t8);
  J[29] = z_6_y;
  J[13] = c_1 * t10 - s_1 * p_1u_t_y;
  const Scalar t11 = Scalar(0.4331) * t1 - Scalar(0.0203) * z_4_z + J_P3_z;
  J[16] = t11 * (c_1 * R_41_y + s_1 * t9);
  const Scalar r_4_z = Scalar(-0.0203) * t1 - Scalar(0.4331) * z_4_z + r_3_z;
  const Scalar t12 = t1 * r_4_z + z_4_z * t11;
  J[3] = s_1 * t12;
  const Scalar t13 = s_4 * t11;
  J[4] = z_4_y * t13 + r_4_z * R_41_y;
  const Scalar t14 = t11 * z_6_z;
  J[5] = s_1 * t14 + r_4_z * z_6_y;
  J[9] = -c_1 * t12;
  J[10] = r_4_z * t9 - z_4_x * t13;
  J[11] = -c_1 * t14 - r_4_z * z_6_x;
  J[17] = t11 * (c_1 * z_6_y - s_1 * z_6_x);
  J[30] = Scalar(1.0);
  J[12] = J[15] = J[18] = J[24] = J[31] = J[32] = Scalar(0.0);
}

// (dJ/dt) qd of the tip.
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads q[0..5], qd[0..5]. Operations: 125 mul, 70 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = c_2 * qd_1;
  const Scalar t2 = s_2 * qd_1;
  const Scalar t3 = s_3 * t1 + c_3 * t2;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t4 = s_4 * omega_3_z - c_4 * t3;
  const Scalar t5 = s_3 * t2 - c_3 * t1;
  const Scalar omega_4_z = qd_4 - t5;
  const Scalar t6 = s_5 * omega_4_z - c_5 * t4;
  const Scalar omega_r_4_y = s_4 * t3 + c_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar omega_r_6_a_z = s_5 * t4 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t7 = (s_6 * omega_5_z - c_6 * t6) * omega_6_z;
  const Scalar t8 = t3 * omega_3_z;
  const Scalar U_4_xy = t4 * omega_r_4_y + t8;
  const Scalar t9 = t5 * omega_3_z;
  const Scalar t10 = Scalar(-2.0) * t9;
  const Scalar t11 = t3 * t5;
  const Scalar t12 = s_4 * t11 - c_4 * t10 + Scalar(2.0) * omega_r_4_y * omega_4_z;
  const Scalar Uz_o_6_z = Scalar(2.0) * omega_r_6_a_z * omega_5_z - s_5 * U_4_xy - c_5 * t12;
  const Scalar U_5_xy = t6 * omega_r_6_a_z - c_4 * t11 + t4 * omega_4_z - s_4 * t10;
  const Scalar t13 = c_6 * U_5_xy + t7 - s_6 * Uz_o_6_z;
  const Scalar omega_r_6_y = s_6 * t6 + c_6 * omega_5_z;
  const Scalar t14 = omega_r_6_y * omega_6_z - s_6 * U_5_xy - c_6 * Uz_o_6_z;
  const Scalar t15 = s_6 * t13 + c_6 * t14;
  const Scalar domega_5_y = t6 * omega_5_z + c_5 * U_4_xy - s_5 * t12;
  const Scalar t16 = s_5 * domega_5_y - c_5 * t15;
  const Scalar t17 = s_6 * t14 - c_6 * t13;
  const Scalar t18 = s_4 * t17 + c_4 * t16;
  const Scalar domega_e_5_t_y = s_5 * t15 + c_5 * domega_5_y;
  const Scalar t19 = s_3 * domega_e_5_t_y + c_3 * t18;
  const Scalar t20 = s_3 * t18 - c_3 * domega_e_5_t_y;
  a[5] = s_2 * t19 + c_2 * t20;
  const Scalar t21 = t3 * t3;
  const Scalar t22 = omega_3_z * omega_3_z;
  const Scalar t23 = qd_1 * qd_1;
  const Scalar t24 = qd_2 * qd_2 - t2 * t2 + t23;
  const Scalar t25 = Scalar(0.4318) * c_3;
  const Scalar t26 = t2 * t1;
  const Scalar t27 = Scalar(0.4318) * s_3;
  const Scalar t28 = Scalar(0.0203) * (t23 - t21 + t22) + Scalar(0.4331) * t11 + t26 * t27 -
      t24 * t25;
  const Scalar t29 = Scalar(0.1501) * t23 - Scalar(0.0406) * t8 + Scalar(0.8662) * t9 +
      Scalar(0.8636) * qd_2 * t2;
  const Scalar t30 = s_4 * t29 - c_4 * t28;
  const Scalar Uz_o_4_y = t21 + t22;
  const Scalar t31 = Scalar(0.0203) * t11 + t26 * t25 + t24 * t27 + Scalar(0.4331) * Uz_o_4_y;
  const Scalar t32 = s_5 * t31 - c_5 * t30;
  const Scalar t33 = s_4 * t28 + c_4 * t29;
  const Scalar t34 = s_6 * t32 + c_6 * t33;
  const Scalar t35 = s_6 * t33 - c_6 * t32;
  const Scalar t36 = s_6 * t34 - c_6 * t35;
  const Scalar t37 = s_5 * t30 + c_5 * t31;
  const Scalar t38 = s_5 * t37 - c_5 * t36;
  const Scalar t39 = s_6 * t35 + c_6 * t34;
  const Scalar t40 = s_4 * t39 - c_4 * t38;
  const Scalar t41 = s_5 * t36 + c_5 * t37;
  const Scalar t42 = s_3 * t41 - c_3 * t40;
  const Scalar t43 = s_3 * t40 + c_3 * t41;
  a[2] = s_2 * t42 - c_2 * t43;
  const Scalar t44 = s_2 * t20 - c_2 * t19;
  const Scalar t45 = s_4 * t16 - c_4 * t17;
  a[3] = s_1 * t45 + c_1 * t44;
  a[4] = s_1 * t44 - c_1 * t45;
  const Scalar t46 = s_2 * t43 + c_2 * t42;
  const Scalar t47 = s_4 * t38 + c_4 * t39;
  a[0] = s_1 * t47 - c_1 * t46;
  a[1] = -s_1 * t46 - c_1 * t47;
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

}  // namespace puma560

#endif  // FLATDYN_PUMA560_HPP

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

#ifndef FLATDYN_PUMA560_HPP_84074528
#define FLATDYN_PUMA560_HPP_84074528

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
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..4], qd[0..5], qdd[0..5]. Operations: 166 mul, 137 add, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = s_2_3 * qd_1;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t2 = omega_3_z * t1;
  const Scalar t3 = s_2 * s_3 - c_2 * c_3;
  const Scalar t4 = t3 * qdd_1;
  const Scalar t5 = t4 + t2;
  const Scalar t6 = t2 + t5;
  const Scalar t7 = t3 * qd_1;
  const Scalar t8 = omega_3_z * t7;
  const Scalar t9 = t8 - s_2_3 * qdd_1;
  const Scalar t10 = t8 + t9;
  const Scalar t11 = Scalar(2.0) * qd_1;
  const Scalar t12 = qd_1 * qd_1;
  const Scalar t13 = Scalar(0.3476146364057434) * t12 - c_2 * qdd_1 + s_2 * qd_2 * t11;
  const Scalar ddp_o_4_z = Scalar(0.04701250578971746) * t6 - Scalar(1.0030106530801297) * t10 -
      t13;
  const Scalar t14 = t1 * t1;
  const Scalar t15 = omega_3_z * omega_3_z;
  const Scalar t16 = t12 - t14 + t15;
  const Scalar t17 = t7 * t1;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar Uz_o_4_x = t17 + domega_3_z;
  const Scalar t18 = qd_2 * qd_2;
  const Scalar t19 = Scalar(0.3476146364057434) * qdd_1 + s_2 * qdd_2 + c_2 * (t18 + t12);
  const Scalar t20 = s_2 * t18 - c_2 * qdd_2 + Scalar(22.71885132005558);
  const Scalar t21 = s_2_3 * t20 - t3 * t19;
  const Scalar ddp_o_4_x = Scalar(0.04701250578971746) * t16 +
      Scalar(1.0030106530801297) * Uz_o_4_x - t21;
  const Scalar ddp_4_x = s_4 * ddp_o_4_z + c_4 * ddp_o_4_x;
  const Scalar U_3_yx = domega_3_z - t17;
  const Scalar Uz_o_4_y = t14 + t15;
  const Scalar ddp_3_y = s_2_3 * t19 + t3 * t20;
  const Scalar ddp_4_a_z = Scalar(0.04701250578971746) * U_3_yx -
      Scalar(1.0030106530801297) * Uz_o_4_y - ddp_3_y;
  const Scalar t22 = s_5 * ddp_4_a_z - c_5 * ddp_4_x;
  const Scalar t23 = s_4 * omega_3_z - c_4 * t1;
  const Scalar omega_4_z = qd_4 - t7;
  const Scalar omega_r_6_a_z = s_5 * t23 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t24 = Scalar(0.00004) * omega_6_z;
  const Scalar t25 = s_5 * omega_4_z - c_5 * t23;
  const Scalar t26 = t23 * omega_4_z;
  const Scalar domega_5_z = qdd_5 - t26 - s_4 * t10 + c_4 * Uz_o_4_x;
  const Scalar t27 = t25 * omega_r_6_a_z;
  const Scalar mu_5_z = t25 * t24 - Scalar(0.00024216) * t27 + Scalar(0.00064216) * domega_5_z -
      Scalar(0.001243584) * t22;
  tau[4] = mu_5_z + Scalar(0.85444524) * detail::sign(qd_5) + Scalar(0.4272830209354) * qd_5 +
      Scalar(0.181052127515) * qdd_5;
  const Scalar omega_r_4_y = s_4 * t1 + c_4 * omega_3_z;
  const Scalar t28 = omega_r_4_y * omega_4_z;
  const Scalar t29 = t28 + s_4 * Uz_o_4_x + c_4 * t10;
  const Scalar U_4_zy = t28 + t29;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar t30 = t25 * omega_5_z;
  const Scalar domega_4_z = qdd_4 - t5;
  const Scalar t31 = t23 * omega_r_4_y;
  const Scalar t32 = domega_4_z - t31;
  const Scalar domega_6_z = qdd_6 - t30 + s_5 * U_4_zy + c_5 * t32;
  const Scalar t33 = Scalar(0.00004) * domega_6_z;
  tau[5] = t33 + Scalar(0.2158232532732) * qd_6 + Scalar(0.55443978) * detail::sign(qd_6) +
      Scalar(0.20582599086) * qdd_6;
  const Scalar mu_5_y = Scalar(0.0004) * t30 - t33;
  const Scalar t34 = omega_r_6_a_z * omega_5_z;
  const Scalar t35 = t34 + s_5 * t32 - c_5 * U_4_zy;
  const Scalar t36 = s_4 * ddp_o_4_x - c_4 * ddp_o_4_z;
  const Scalar t37 = omega_5_z * t24 - Scalar(0.00024216) * t35 - Scalar(0.00064216) * t34 +
      Scalar(0.001243584) * t36;
  const Scalar mu_4_z = Scalar(-0.0003) * t31 - c_5 * mu_5_y + Scalar(0.0016) * domega_4_z -
      s_5 * t37;
  tau[3] = mu_4_z + Scalar(0.411645229697152) * qd_4 + Scalar(1.06831142) * detail::sign(qd_4) +
      Scalar(0.2023536943736) * qdd_4;
  const Scalar mu_4_x = Scalar(0.0003) * t29 - s_5 * mu_5_y + Scalar(0.0016) * t28 + c_5 * t37;
  const Scalar Uz_o_6_z = t34 + t35;
  const Scalar t38 = Scalar(0.23306405) * t36 - Scalar(0.001243584) * Uz_o_6_z;
  const Scalar Uz_o_6_y = t25 * t25 + omega_5_z * omega_5_z;
  const Scalar Uz_o_6_x = domega_5_z - t27;
  const Scalar f_4_x = Scalar(0.23306405) * ddp_4_x -
      Scalar(0.001243584) * (s_5 * Uz_o_6_y - c_5 * Uz_o_6_x);
  const Scalar f_u_4_t_x = s_4 * t38 + c_4 * f_4_x;
  const Scalar t39 = Scalar(0.0013) * t26 - mu_5_z;
  const Scalar f_4_z = Scalar(0.23306405) * ddp_4_a_z -
      Scalar(0.001243584) * (s_5 * Uz_o_6_x + c_5 * Uz_o_6_y);
  const Scalar t40 = s_4 * mu_4_x - Scalar(0.000316274) * (t16 - Uz_o_4_y) - c_4 * t39 +
      Scalar(0.004704) * t4 + Scalar(0.065620624) * t17 + Scalar(0.04701250578971746) * f_4_z +
      Scalar(0.078120624) * domega_3_z - Scalar(0.138357356) * t21 +
      Scalar(1.0030106530801297) * f_u_4_t_x;
  const Scalar f_3_x = Scalar(0.138357356) * Uz_o_4_x + f_u_4_t_x - Scalar(1.405871712) * t21;
  const Scalar f_3_y = Scalar(0.138357356) * Uz_o_4_y - f_4_z + Scalar(1.405871712) * ddp_3_y;
  const Scalar I_t2_g = Scalar(0.0141984) * s_2 + Scalar(0.03707456) * c_2;
  const Scalar I_2_xy = s_2 * I_t2_g - Scalar(0.0070992);
  const Scalar t41 = Scalar(0.023751) * c_2 + Scalar(0.12059664) * s_2;
  tau[1] = Scalar(1.024164) * s_2 - t12 * I_2_xy + qdd_1 * t41 + t40 +
      Scalar(10.6197775) * detail::sign(qd_2) + Scalar(9.496868641825) * qd_2 + s_3 * f_3_x +
      c_3 * f_3_y + Scalar(4.863424598025) * qdd_2;
  tau[2] = t40 + Scalar(6.36419655) * detail::sign(qd_3) + Scalar(3.9804259903722) * qd_3 +
      Scalar(0.86242563124731) * qdd_3;
  const Scalar t42 = s_2_3 * f_3_y + t3 * f_3_x;
  const Scalar f_u_4_t_y = s_4 * f_4_x - c_4 * t38;
  const Scalar U_3_yy_zz = t12 - Uz_o_4_y;
  const Scalar t43 = Scalar(0.000316274) * t6 + s_4 * t39 + c_4 * mu_4_x +
      Scalar(0.004704) * U_3_yy_zz + Scalar(0.078120624) * t8 + Scalar(0.065620624) * t9 +
      Scalar(0.138357356) * t13 - Scalar(1.0030106530801297) * f_u_4_t_y;
  const Scalar t44 = c_2 * (Scalar(0.138357356) * t10 - f_u_4_t_y + Scalar(1.405871712) * t13);
  const Scalar mu_3_y = Scalar(0.000316274) * t10 - mu_4_z + Scalar(0.0125) * t2 +
      Scalar(0.004704) * Uz_o_4_x + Scalar(0.04701250578971746) * f_u_4_t_y;
  const Scalar t45 = t11 * (qd_2 * I_2_xy + Scalar(2.9009108839754));
  const Scalar t46 = qdd_1 * (c_2 * I_t2_g - Scalar(2.493827218941039));
  const Scalar t47 = t18 * (Scalar(0.12059664) * c_2 - Scalar(0.023751) * s_2);
  tau[0] = t3 * mu_3_y + t47 + qdd_2 * t41 - s_2_3 * t43 + Scalar(0.3476146364057434) * t42 - t44 +
      Scalar(25.9836065) * detail::sign(qd_1) + t45 - t46;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..5], qd[0..5], qdd[0..5], h_e[0..5]. Operations: 223 mul, 169 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics_tip_force(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    const Scalar* h_e, Scalar* tau, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
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
  const Scalar t1 = s_2 * s_3 - c_2 * c_3;
  const Scalar t2 = t1 * qd_1;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t3 = omega_3_z * t2;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t4 = t3 - s_2_3 * qdd_1;
  const Scalar t5 = t3 + t4;
  const Scalar t6 = s_2_3 * qd_1;
  const Scalar omega_r_4_y = s_4 * t6 + c_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 - t2;
  const Scalar t7 = omega_r_4_y * omega_4_z;
  const Scalar t8 = t2 * t6;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar Uz_o_4_x = t8 + domega_3_z;
  const Scalar t9 = t7 + s_4 * Uz_o_4_x + c_4 * t5;
  const Scalar U_4_zy = t7 + t9;
  const Scalar t10 = s_4 * omega_3_z - c_4 * t6;
  const Scalar t11 = s_5 * omega_4_z - c_5 * t10;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar t12 = t11 * omega_5_z;
  const Scalar t13 = omega_3_z * t6;
  const Scalar t14 = t1 * qdd_1;
  const Scalar t15 = t14 + t13;
  const Scalar domega_4_z = qdd_4 - t15;
  const Scalar t16 = t10 * omega_r_4_y;
  const Scalar t17 = domega_4_z - t16;
  const Scalar domega_6_z = qdd_6 - t12 + s_5 * U_4_zy + c_5 * t17;
  const Scalar mu_e1_x = s_1 * h_e_5 + c_1 * h_e_4;
  const Scalar t18 = s_2_3 * h_e_6 + t1 * mu_e1_x;
  const Scalar t19 = s_1 * h_e_4 - c_1 * h_e_5;
  const Scalar t20 = s_4 * t19 + c_4 * t18;
  const Scalar mu_e4_a_z = s_2_3 * mu_e1_x - t1 * h_e_6;
  const Scalar mu_6_z = Scalar(0.00004) * domega_6_z - s_5 * t20 + c_5 * mu_e4_a_z;
  tau[5] = Scalar(0.2158232532732) * qd_6 + Scalar(0.55443978) * detail::sign(qd_6) +
      Scalar(0.20582599086) * qdd_6 + mu_6_z;
  const Scalar omega_r_6_y = s_6 * t11 + c_6 * omega_5_z;
  const Scalar omega_r_6_a_z = s_5 * t10 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t21 = Scalar(0.00004) * omega_6_z;
  const Scalar t22 = s_5 * mu_e4_a_z + c_5 * t20;
  const Scalar mu_e4_y = s_4 * t18 - c_4 * t19;
  const Scalar mu_6_x = omega_r_6_y * t21 + s_6 * mu_e4_y - c_6 * t22;
  const Scalar t23 = (s_6 * omega_5_z - c_6 * t11) * t21;
  const Scalar t24 = t23 - s_6 * t22 - c_6 * mu_e4_y;
  const Scalar t25 = t13 + t15;
  const Scalar t26 = Scalar(0.4318) * c_2;
  const Scalar t27 = qd_1 * qd_1;
  const Scalar t28 = Scalar(0.1501) * t27 - qdd_1 * t26 + Scalar(0.8636) * s_2 * qd_1 * qd_2;
  const Scalar ddp_o_4_z = Scalar(0.0203) * t25 - Scalar(0.4331) * t5 - t28;
  const Scalar t29 = qd_2 * qd_2;
  const Scalar t30 = Scalar(0.1501) * qdd_1 + Scalar(0.4318) * (s_2 * qdd_2 + c_2 * (t29 + t27));
  const Scalar t31 = Scalar(0.4318) * (s_2 * t29 - c_2 * qdd_2) + Scalar(9.81);
  const Scalar t32 = s_2_3 * t31 - t1 * t30;
  const Scalar t33 = t6 * t6;
  const Scalar t34 = omega_3_z * omega_3_z;
  const Scalar t35 = t27 - t33 + t34;
  const Scalar ddp_o_4_x = Scalar(0.0203) * t35 + Scalar(0.4331) * Uz_o_4_x - t32;
  const Scalar ddp_4_x = s_4 * ddp_o_4_z + c_4 * ddp_o_4_x;
  const Scalar ddp_3_y = s_2_3 * t30 + t1 * t31;
  const Scalar U_3_yx = domega_3_z - t8;
  const Scalar Uz_o_4_y = t33 + t34;
  const Scalar ddp_4_a_z = Scalar(0.0203) * U_3_yx - Scalar(0.4331) * Uz_o_4_y - ddp_3_y;
  const Scalar t36 = s_5 * ddp_4_a_z - c_5 * ddp_4_x;
  const Scalar t37 = t10 * omega_4_z;
  const Scalar domega_5_z = qdd_5 - t37 - s_4 * t5 + c_4 * Uz_o_4_x;
  const Scalar t38 = t11 * omega_r_6_a_z;
  const Scalar mu_5_z = Scalar(0.00064216) * domega_5_z - Scalar(0.00024216) * t38 -
      Scalar(0.00288) * t36 + s_6 * mu_6_x - c_6 * t24;
  tau[4] = Scalar(0.85444524) * detail::sign(qd_5) + Scalar(0.4272830209354) * qd_5 +
      Scalar(0.181052127515) * qdd_5 + mu_5_z;
  const Scalar t39 = omega_r_6_a_z * omega_5_z;
  const Scalar t40 = t39 + s_5 * t17 - c_5 * U_4_zy;
  const Scalar t41 = s_4 * ddp_o_4_x - c_4 * ddp_o_4_z;
  const Scalar t42 = Scalar(-0.00024216) * t40 - Scalar(0.00064216) * t39 + Scalar(0.00288) * t41 +
      s_6 * t24 + c_6 * mu_6_x;
  const Scalar mu_5_y = Scalar(0.0004) * t12 - mu_6_z;
  const Scalar mu_4_z = Scalar(0.0016) * domega_4_z - Scalar(0.0003) * t16 - s_5 * t42 -
      c_5 * mu_5_y;
  tau[3] = Scalar(0.411645229697152) * qd_4 + Scalar(1.06831142) * detail::sign(qd_4) +
      Scalar(0.2023536943736) * qdd_4 + mu_4_z;
  const Scalar f_e1_x = s_1 * h_e_2 + c_1 * h_e_1;
  const Scalar t43 = s_2_3 * h_e_3 + t1 * f_e1_x;
  const Scalar t44 = s_1 * h_e_1 - c_1 * h_e_2;
  const Scalar t45 = s_4 * t44 + c_4 * t43;
  const Scalar f_e4_a_z = s_2_3 * f_e1_x - t1 * h_e_3;
  const Scalar t46 = s_5 * f_e4_a_z + c_5 * t45;
  const Scalar f_e4_y = s_4 * t43 - c_4 * t44;
  const Scalar f_e6_y = s_6 * t46 + c_6 * f_e4_y;
  const Scalar f_e6_x = s_6 * f_e4_y - c_6 * t46;
  const Scalar Uz_o_6_x = domega_5_z - t38;
  const Scalar f_5_x = Scalar(0.00288) * Uz_o_6_x - s_6 * f_e6_y + c_6 * f_e6_x;
  const Scalar Uz_o_6_y = t11 * t11 + omega_5_z * omega_5_z;
  const Scalar t47 = Scalar(0.00288) * Uz_o_6_y + s_5 * t45 - c_5 * f_e4_a_z;
  const Scalar f_4_x = c_5 * f_5_x - s_5 * t47 + Scalar(1.25) * ddp_4_x;
  const Scalar Uz_o_6_z = t39 + t40;
  const Scalar t48 = Scalar(-0.00288) * Uz_o_6_z - s_6 * f_e6_x - c_6 * f_e6_y + Scalar(1.25) * t41;
  const Scalar f_u_4_t_x = s_4 * t48 + c_4 * f_4_x;
  const Scalar mu_4_x = Scalar(0.0003) * t9 + Scalar(0.0016) * t7 - s_5 * mu_5_y + c_5 * t42;
  const Scalar t49 = Scalar(0.0013) * t37 - mu_5_z;
  const Scalar f_4_z = -s_5 * f_5_x - c_5 * t47 + Scalar(1.25) * ddp_4_a_z;
  const Scalar t50 = Scalar(0.004704) * t14 - Scalar(0.000316274) * (t35 - Uz_o_4_y) +
      Scalar(0.065620624) * t8 + Scalar(0.0203) * f_4_z + Scalar(0.078120624) * domega_3_z -
      Scalar(0.32042) * t32 + Scalar(0.4331) * f_u_4_t_x + s_4 * mu_4_x - c_4 * t49;
  tau[2] = Scalar(6.36419655) * detail::sign(qd_3) + Scalar(3.9804259903722) * qd_3 +
      Scalar(0.86242563124731) * qdd_3 + t50;
  const Scalar f_3_x = Scalar(0.32042) * Uz_o_4_x + f_u_4_t_x - Scalar(7.540157480314961) * t32;
  const Scalar f_3_y = Scalar(0.32042) * Uz_o_4_y - f_4_z + Scalar(7.540157480314961) * ddp_3_y;
  const Scalar t51 = s_2_3 * f_3_y + t1 * f_3_x;
  const Scalar f_u_4_t_y = s_4 * f_4_x - c_4 * t48;
  const Scalar t52 = t26 * (Scalar(0.32042) * t5 - f_u_4_t_y + Scalar(7.540157480314961) * t28);
  const Scalar U_3_yy_zz = t27 - Uz_o_4_y;
  const Scalar t53 = Scalar(0.000316274) * t25 + Scalar(0.004704) * U_3_yy_zz +
      Scalar(0.078120624) * t3 + Scalar(0.065620624) * t4 + Scalar(0.32042) * t28 -
      Scalar(0.4331) * f_u_4_t_y + s_4 * t49 + c_4 * mu_4_x;
  const Scalar mu_3_y = Scalar(0.000316274) * t5 + Scalar(0.0125) * t13 +
      Scalar(0.004704) * Uz_o_4_x + Scalar(0.0203) * f_u_4_t_y - mu_4_z;
  const Scalar I_t2_g = Scalar(0.0141984) * s_2 + Scalar(0.03707456) * c_2;
  const Scalar I_2_xy = s_2 * I_t2_g - Scalar(0.0070992);
  const Scalar t54 = qd_1 * (qd_2 * I_2_xy + Scalar(2.9009108839754));
  const Scalar t55 = qdd_1 * (c_2 * I_t2_g - Scalar(2.493827218941039));
  const Scalar t56 = t29 * (Scalar(0.12059664) * c_2 - Scalar(0.023751) * s_2);
  const Scalar t57 = Scalar(0.023751) * c_2 + Scalar(0.12059664) * s_2;
  tau[0] = t56 + qdd_2 * t57 + t1 * mu_3_y + Scalar(0.1501) * t51 - t52 - s_2_3 * t53 +
      Scalar(25.9836065) * detail::sign(qd_1) + Scalar(2.0) * t54 - t55;
  const Scalar t58 = s_3 * f_3_x + c_3 * f_3_y;
  tau[1] = Scalar(1.024164) * s_2 - t27 * I_2_xy + qdd_1 * t57 + t50 +
      Scalar(10.6197775) * detail::sign(qd_2) + Scalar(9.496868641825) * qd_2 +
      Scalar(0.4318) * t58 + Scalar(4.863424598025) * qdd_2;
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
// Reads q[1..4]. Operations: 66 mul, 55 add, 8 sin/cos. Always zero: 4 of the 36 entries of B.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inertia_matrix(const Scalar* q, Scalar* B, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar mu_u_6_5_a_z = Scalar(0.00004) * c_5;
  B[23] = B[33] = mu_u_6_5_a_z;
  const Scalar t1 = s_4 * s_5;
  B[11] = B[17] = B[31] = B[32] = Scalar(0.00004) * t1;
  const Scalar t2 = Scalar(0.00020216) * c_5;
  const Scalar t3 = t2 + Scalar(0.001247328);
  const Scalar t4 = t3 * t1;
  B[15] = B[20] = -t4;
  const Scalar t5 = Scalar(0.001247328) * c_5 + Scalar(0.00064216);
  const Scalar t6 = Scalar(0.000058464) * s_5;
  const Scalar t7 = t6 - c_4 * t5;
  B[16] = B[26] = -t7;
  const Scalar t8 = c_5 * t2;
  const Scalar mu_u_4_4_a_y = t8 - Scalar(0.00184216);
  B[21] = Scalar(0.2023536943736) - mu_u_4_4_a_y;
  B[9] = B[19] = Scalar(-0.001243584) * s_3 * t1 - t4;
  B[10] = B[25] = Scalar(0.001243584) * (s_3 * c_4 * c_5 + c_3 * s_5) - t7;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t9 = c_4 * s_5;
  const Scalar t10 = s_2 * s_3 - c_2 * c_3;
  B[5] = B[30] = Scalar(-0.00004) * s_2_3 * t9 - t10 * mu_u_6_5_a_z;
  const Scalar t11 = t10 * (Scalar(0.000058464) * t9 - Scalar(0.000432288) * t1 + mu_u_4_4_a_y);
  B[3] = B[18] = t9 * (Scalar(0.001243584) * c_2 + s_2_3 * t3) + t11;
  const Scalar t12 = Scalar(0.000432288) * c_5;
  const Scalar t13 = t12 * (c_4 * t10 +
      Scalar(2.876748834110593) * s_4 * (Scalar(0.04701250578971746) * t10 + c_2));
  B[4] = B[24] = t13 + s_2_3 * (Scalar(0.000432288) * s_5 + s_4 * t5);
  const Scalar Iu_5_t_xx = t8 - Scalar(0.00020216);
  const Scalar Iu_4_t_d = Iu_5_t_xx - Scalar(0.0001);
  const Scalar t14 = c_4 * Iu_4_t_d;
  const Scalar t15 = c_4 * t14;
  const Scalar t16 = Scalar(0.000116928) * t9;
  const Scalar t17 = Scalar(0.002494656) * c_5;
  const Scalar Ic_3_zz = -t16 - t15 + Iu_5_t_xx + t17 + Scalar(0.313647409);
  const Scalar f_3_3_x = t12 + Scalar(0.1293554295);
  const Scalar hc_3_x = Scalar(0.000432288) * t9 - Scalar(0.0038087875);
  const Scalar t18 = c_3 * hc_3_x + s_3 * f_3_3_x;
  B[7] = Ic_3_zz + Scalar(5.753497668221186) * t18 + Scalar(6.502360360025);
  B[14] = Ic_3_zz + Scalar(0.86242563124731);
  B[8] = B[13] = Ic_3_zz + Scalar(2.876748834110593) * t18;
  const Scalar Ic_3_yz = t4 + Scalar(0.004704);
  const Scalar B_13 = s_2_3 * (hc_3_x - s_4 * (t6 + t14)) + t10 * (Ic_3_yz + f_3_3_x);
  B[2] = B[12] = B_13;
  B[1] = B[6] = Scalar(0.023751) * c_2 + B_13 +
      Scalar(0.001243584) * s_2 * (t1 + Scalar(555.1009815179352));
  const Scalar Ic_3_xx = t15 + Scalar(0.0001) + t17;
  const Scalar Iu_3_t_d = t16 + mu_u_4_4_a_y + Ic_3_xx + Scalar(0.300117184);
  const Scalar t19 = s_2_3 * (Scalar(0.000058464) * c_5 - t9 * t3 + Scalar(0.0106736385));
  const Scalar Iu_3_t_g = Scalar(2.0) * t19 - t10 * Iu_3_t_d;
  const Scalar hu_3_t_x = s_2_3 * f_3_3_x - t10 * hc_3_x;
  const Scalar t20 = c_2 * (Scalar(5.753497668221186) * hu_3_t_x - Scalar(0.0141984) * s_2 +
      Scalar(1.601861202) * c_2);
  B[0] = Scalar(0.000864576) * t1 + Ic_3_xx + t10 * Iu_3_t_g + t20 + Scalar(2.99250185137411);
  B[22] = B[27] = B[29] = B[34] = Scalar(0.0);
  B[28] = Scalar(0.181694287515);
  B[35] = Scalar(0.20586599086);
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[126] = {
    0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 1, 1, 0,
    1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 1, 1, 0,
    1, 0, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 1, 1, 0,
    1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1, 0, 1, 1, 1, 0, 1, 0,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0,
    0, 1, 0, 1, 0, 0, 1, 1, 1, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[6]    in   joint positions, rad or m
//   c[126]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//                c_ijk = c_ikj is c[21 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads q[1..4]. Operations: 165 mul, 107 add, 8 sin/cos. Always zero: 42 of the 126 entries of c.
template <class Scalar, class SinCos = LibrarySinCos>
inline void christoffel(const Scalar* q, Scalar* c, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
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
  const Scalar v_3_6_a_z = Scalar(0.000058464) * c_5 + Scalar(0.001247328) * t3;
  c[56] = -v_3_6_a_z;
  c[93] = -db_44_5r;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t4 = s_4 * s_5;
  const Scalar t5 = s_2_3 * t4;
  c[18] = c[111] = Scalar(0.00002) * t5;
  const Scalar t6 = c_5 * s_2_3;
  const Scalar t7 = s_2 * s_3 - c_2 * c_3;
  const Scalar mu_u_6_3_t_x = Scalar(0.00002) * t6 - t7 * db_26_4;
  c[36] = c[57] = mu_u_6_3_t_x;
  const Scalar t8 = Scalar(0.00010108) * c_5;
  const Scalar t9 = t8 + Scalar(0.000623664);
  const Scalar t10 = t3 * t9;
  c[51] = Scalar(-2.0) * t10;
  c[78] = Scalar(-0.00002) * t5;
  const Scalar t11 = t9 * t4;
  const Scalar t12 = Scalar(2.0) * s_4;
  const Scalar c_5_3_3 = t11 * t12 + c_4 * v_3_6_a_z;
  c[89] = c_5_3_3;
  c[16] = c[17] = c[106] = c[108] = -mu_u_6_3_t_x;
  const Scalar t13 = Scalar(0.000621792) * s_2;
  const Scalar v_2_3_y = s_2_3 * t13 - Scalar(0.000621792) * c_2 * t7;
  const Scalar t14 = Scalar(0.000216144) * c_5;
  const Scalar f_3_3_x = t14 + Scalar(0.06467771475);
  const Scalar v_2_3_x = s_2 * t7 + c_2 * s_2_3;
  const Scalar hc_3_x = Scalar(0.000216144) * t3 - Scalar(0.00190439375);
  const Scalar c_2_3_3 = Scalar(9253.090532237768) * f_3_3_x * v_2_3_y -
      Scalar(5.753497668221186) * hc_3_x * v_2_3_x;
  c[25] = c[26] = c_2_3_3;
  const Scalar t15 = c_5 * t8;
  const Scalar Iu_4_t_d = t15 - Scalar(0.00015108);
  const Scalar t16 = c_4 * Iu_4_t_d;
  const Scalar dmu_3_4_x = Scalar(0.000029232) * s_5 + t16;
  const Scalar db_33_4r = dmu_3_4_x * t12;
  c[50] = db_33_4r;
  c[54] = -c_5_3_3;
  const Scalar t17 = c_4 * s_2_3;
  const Scalar t18 = s_5 * t7;
  const Scalar t19 = t18 - c_5 * t17;
  c[99] = Scalar(-0.00002) * t19;
  c[19] = c[115] = Scalar(0.00002) * t19;
  const Scalar t20 = s_4 * (s_5 * t1 - Scalar(0.00010108));
  const Scalar t21 = Scalar(0.000623664) * t2;
  const Scalar t22 = t21 - t20;
  const Scalar t23 = Scalar(0.00032108) * s_4;
  const Scalar t24 = t23 + t21;
  const Scalar c_4_3_5 = t24 - t22;
  c[75] = c_4_3_5;
  c[44] = -c_2_3_3;
  c[68] = -db_33_4r;
  c[55] = -t24 - t22;
  c[92] = -c_4_3_5;
  const Scalar t25 = s_4 * t7;
  const Scalar Ic_3_yz = t11 + Scalar(0.002352);
  const Scalar hu_3_t_x = s_2_3 * f_3_3_x - t7 * hc_3_x;
  const Scalar db_13_3 = dmu_3_4_x * t25 + s_2_3 * Ic_3_yz + hu_3_t_x;
  const Scalar c_1_3_3 = Scalar(2.0) * db_13_3;
  c[4] = c[5] = c_1_3_3;
  const Scalar v_o_2_4_y = v_2_3_y - Scalar(0.000029232);
  const Scalar t26 = t16 - s_5 * v_o_2_4_y;
  const Scalar db_22_4r = t26 * t12;
  c[28] = db_22_4r;
  const Scalar t27 = Scalar(2.876748834110593) * c_2;
  const Scalar t28 = Scalar(0.13524317121918722) * t7 + Scalar(2.8854097268487675) * s_2_3 + t27;
  const Scalar t29 = c_4 * t7 + s_4 * t28;
  const Scalar t30 = s_5 * t29;
  const Scalar t31 = t30 - t6;
  const Scalar c_1_5_5 = Scalar(-0.000432288) * t31;
  c[14] = c_1_5_5;
  const Scalar t32 = s_2_3 * t2;
  const Scalar t33 = t32 + Scalar(2.138345864661654) * t29;
  c[9] = -t33 * t1;
  const Scalar t34 = s_4 * Iu_4_t_d;
  const Scalar t35 = s_4 * s_2_3;
  const Scalar t36 = t34 * t35;
  const Scalar t37 = Scalar(0.000216144) * t5;
  const Scalar t38 = t7 * t10;
  const Scalar t39 = dmu_3_4_x * t17 - t36 + t37 - t38;
  const Scalar mu_u_4_4_a_y = t15 - Scalar(0.00092108);
  const Scalar mu_4_3_y = Scalar(0.000029232) * t3 + mu_u_4_4_a_y;
  const Scalar t40 = -t37 - t38 + s_2_3 * mu_4_3_y;
  c[8] = t40 - t39;
  const Scalar c_4_1_3 = t39 + t40;
  c[66] = c_4_1_3;
  const Scalar t41 = Scalar(0.000621792) * v_2_3_x;
  const Scalar v_o_2_4_x = t41 + Scalar(0.000623664);
  const Scalar t42 = t3 * v_o_2_4_x - c_5 * v_o_2_4_y;
  const Scalar c_2_5_5 = Scalar(-2.0) * t42;
  c[35] = c_2_5_5;
  const Scalar t43 = t8 + v_o_2_4_x;
  c[30] = Scalar(-2.0) * t3 * t43;
  c[48] = -c_4_1_3;
  const Scalar t44 = t25 - c_4 * t28;
  const Scalar t45 = Scalar(0.00010108) * t19 + Scalar(0.000216144) * t44;
  const Scalar t46 = s_2_3 * t3 + c_5 * t7;
  const Scalar t47 = Scalar(0.00010108) * s_5;
  const Scalar t48 = t46 * t47 + c_5 * t45;
  const Scalar db_15_4 = Scalar(0.00032108) * t17 - t14 * t44;
  c[13] = db_15_4 - t48;
  const Scalar c_5_1_4 = db_15_4 + t48;
  c[90] = c_5_1_4;
  c[65] = -db_22_4r;
  const Scalar t49 = v_o_2_4_x * t2;
  const Scalar t50 = t23 + t49;
  const Scalar t51 = t49 - t20;
  const Scalar c_4_2_5 = t50 - t51;
  c[74] = c_4_2_5;
  c[2] = c_1_3_3 - Scalar(0.023751) * s_2 +
      Scalar(0.001243584) * c_2 * (t4 + Scalar(555.1009815179352));
  const Scalar t52 = s_4 * (Iu_4_t_d * t17 - t8 * t18);
  const Scalar t53 = s_2_3 * (t17 * (Scalar(0.000432288) * s_5 - t34) - t52);
  const Scalar db_11_4r = t53 + t7 * (Scalar(0.000216144) * t30 + t33 * t47);
  c[6] = db_11_4r;
  const Scalar db_11_5r = t35 * c_1_5_5 + Scalar(2.0) * t46 * t45;
  c[10] = db_11_5r;
  c[73] = -c_5_1_4;
  const Scalar db_23_4r = s_4 * dmu_3_4_x + s_4 * t26;
  const Scalar t54 = t4 * v_2_3_y;
  c[29] = db_23_4r - t54;
  const Scalar c_3_2_4 = db_23_4r + t54;
  c[49] = c_3_2_4;
  c[34] = -t50 - t51;
  c[91] = -c_4_2_5;
  c[84] = -db_11_5r;
  const Scalar c_5_2_2 = t4 * t43 * t12 - c_4 * c_2_5_5;
  c[86] = c_5_2_2;
  c[63] = -db_11_4r;
  const Scalar t55 = t4 * t45 + Scalar(0.000216144) * c_4 * t31;
  const Scalar t56 = t55 - s_4 * (t9 * t46 - Scalar(0.5) * s_2_3 * v_3_6_a_z);
  const Scalar t57 = Scalar(0.000216144) * t19 - Scalar(0.000029232) * t32 + t7 * t24;
  const Scalar c_3_1_5 = t57 - t56;
  c[52] = c_3_1_5;
  c[67] = -c_3_2_4;
  const Scalar Iu_3_t_d = c_4 * (Scalar(0.000058464) * s_5 + t16) + Scalar(0.001247328) * c_5 +
      mu_u_4_4_a_y + Scalar(0.150108592);
  const Scalar t58 = Scalar(0.000029232) * c_5 - t10 + Scalar(0.00533681925);
  const Scalar t59 = Scalar(2.0) * t58;
  const Scalar Iu_3_t_g = s_2_3 * t59 - t7 * Iu_3_t_d;
  const Scalar t60 = s_2 * (Scalar(2.876748834110593) * hu_3_t_x - Scalar(0.0070992) * s_2 +
      Scalar(0.800930601) * c_2);
  const Scalar t61 = (s_2_3 * hc_3_x + t7 * f_3_3_x) * t27;
  const Scalar t62 = Scalar(0.0035496) + t58 + t61 - s_2_3 * Iu_3_t_g + t60;
  c[21] = Scalar(2.0) * t62;
  c[1] = Scalar(-2.0) * t62;
  const Scalar t63 = t7 * (t7 * t59 + s_2_3 * Iu_3_t_d + f_3_3_x * t27);
  const Scalar c_3_1_1 = t61 - s_2_3 * (Iu_3_t_g - hc_3_x * t27) + t63;
  c[42] = c_3_1_1;
  c[32] = -c_5_2_2;
  const Scalar t64 = t37 - t36 + c_4 * (s_2_3 * t26 - t18 * t43);
  const Scalar t65 = t40 - t3 * t13;
  c[7] = t65 - t64;
  const Scalar c_4_1_2 = t64 + t65;
  c[64] = c_4_1_2;
  c[12] = -t57 - t56;
  c[87] = -c_3_1_5;
  c[3] = -c_3_1_1;
  c[27] = -c_4_1_2;
  const Scalar t66 = t55 - s_4 * (t46 * t43 - s_2_3 * t42);
  const Scalar t67 = t13 * t2 + t57;
  const Scalar c_2_1_5 = t67 - t66;
  c[31] = c_2_1_5;
  const Scalar t68 = Scalar(0.5) * c_5_2_2 + Scalar(0.5) * c_5_3_3;
  const Scalar t69 = c_4 * c_5 * v_2_3_y - s_5 * t41;
  c[33] = t69 - t68;
  const Scalar c_5_2_3 = t69 + t68;
  c[88] = c_5_2_3;
  c[11] = -t67 - t66;
  c[85] = -c_2_1_5;
  c[53] = -c_5_2_3;
  c[0] = c[15] = c[20] = c[22] = c[23] = c[24] = c[37] = c[38] = Scalar(0.0);
  c[41] = c[43] = c[45] = c[46] = c[47] = c[58] = c[59] = c[62] = Scalar(0.0);
  c[69] = c[70] = c[71] = c[72] = c[77] = c[81] = c[83] = c[94] = Scalar(0.0);
  c[95] = c[96] = c[97] = c[98] = c[103] = c[104] = c[105] = c[107] = Scalar(0.0);
  c[109] = c[110] = c[114] = c[119] = c[120] = c[121] = c[122] = c[123] = Scalar(0.0);
  c[124] = c[125] = Scalar(0.0);
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
// Reads q[1..4], qd[0..5]. Operations: 256 mul, 190 add, 8 sin/cos. Always zero: 2 of the 36
// entries of C.
template <class Scalar, class SinCos = LibrarySinCos>
inline void coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar t1 = Scalar(0.00020216) * s_5;
  C[21] = c_5 * qd_5 * t1;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t2 = c_5 * s_2_3;
  const Scalar t3 = s_2 * s_3 - c_2 * c_3;
  const Scalar t4 = c_4 * s_5;
  const Scalar t5 = t3 * t4;
  const Scalar mu_u_6_3_t_x = Scalar(0.00002) * t2 - Scalar(0.00002) * t5;
  const Scalar t6 = qd_1 * mu_u_6_3_t_x;
  const Scalar t7 = s_4 * c_5;
  const Scalar t8 = Scalar(0.00002) * (qd_5 * t7 + qd_4 * t4);
  C[11] = C[17] = t6 + t8;
  C[31] = C[32] = t8 - t6;
  const Scalar t9 = c_4 * s_2_3;
  const Scalar t10 = s_5 * t3;
  const Scalar t11 = t10 - c_5 * t9;
  const Scalar t12 = s_4 * s_5;
  const Scalar t13 = s_2_3 * t12;
  const Scalar t14 = qd_2 + qd_3;
  C[5] = C[30] = Scalar(0.00002) * (qd_5 * t11 + qd_4 * t13) - mu_u_6_3_t_x * t14;
  const Scalar t15 = Scalar(0.00010108) * c_5;
  const Scalar t16 = t15 + Scalar(0.000623664);
  const Scalar t17 = t16 * t12;
  const Scalar t18 = Scalar(2.0) * s_4;
  const Scalar t19 = Scalar(0.000029232) * c_5;
  const Scalar v_3_6_a_z = t19 + Scalar(0.000623664) * t4;
  const Scalar t20 = Scalar(2.0) * c_4;
  const Scalar c_5_3_3 = t17 * t18 + v_3_6_a_z * t20;
  const Scalar t21 = c_5 * t15;
  const Scalar Iu_4_t_d = t21 - Scalar(0.00015108);
  const Scalar t22 = c_4 * Iu_4_t_d;
  const Scalar t23 = Scalar(0.000029232) * s_5;
  const Scalar dmu_3_4_x = t23 + t22;
  const Scalar t24 = qd_4 * t18;
  C[14] = dmu_3_4_x * t24 - qd_5 * c_5_3_3;
  const Scalar t25 = s_4 * s_2_3;
  const Scalar t26 = qd_1 * t25 + c_4 * t14;
  const Scalar t27 = Scalar(0.00002) * s_5;
  C[23] = -(qd_5 + t26) * t27;
  const Scalar C_56 = Scalar(0.00002) * (s_5 * qd_4 - qd_1 * t11) - Scalar(0.00002) * t7 * t14;
  C[29] = C_56;
  C[33] = -t27 * (qd_5 - t26);
  C[34] = -C_56;
  const Scalar v_2_3_x = s_2 * t3 + c_2 * s_2_3;
  const Scalar t28 = Scalar(0.000621792) * v_2_3_x;
  const Scalar v_o_2_4_x = t28 + Scalar(0.000623664);
  const Scalar t29 = v_o_2_4_x * t7;
  const Scalar t30 = Scalar(0.00032108) * s_4 + t29;
  const Scalar t31 = s_4 * (s_5 * t1 - Scalar(0.00010108));
  const Scalar t32 = t29 - t31;
  const Scalar c_4_2_5 = t30 - t32;
  const Scalar t33 = Scalar(21.27093596059113) * c_2;
  const Scalar t34 = t3 + Scalar(21.334975369458128) * s_2_3 + t33;
  const Scalar t35 = s_4 * t3;
  const Scalar t36 = Scalar(0.000216144) * t35 - Scalar(0.000029232) * c_4 * t34;
  const Scalar t37 = Scalar(0.00010108) * t11 + t36;
  const Scalar t38 = s_2_3 * t4;
  const Scalar t39 = t38 + c_5 * t3;
  const Scalar t40 = Scalar(0.00010108) * s_5;
  const Scalar t41 = t39 * t40 + c_5 * t37;
  const Scalar db_15_4 = Scalar(0.00032108) * t9 - c_5 * t36;
  const Scalar c_5_1_4 = db_15_4 + t41;
  const Scalar t42 = Scalar(0.000623664) * t7 - t31;
  const Scalar t43 = Scalar(0.000623664) * c_5 + Scalar(0.00032108);
  const Scalar t44 = s_4 * t43;
  const Scalar t45 = t42 - t44;
  const Scalar t46 = t1 * (Scalar(0.09893153937475267) * qd_6 - c_5 * qd_4);
  const Scalar C_54 = t46 + qd_3 * t45 - qd_2 * c_4_2_5 + qd_1 * c_5_1_4;
  C[27] = C_54;
  C[22] = -C_54;
  const Scalar t47 = Scalar(0.000216144) * t38 - s_4 * (Iu_4_t_d * t9 - t15 * t10);
  const Scalar t48 = Scalar(0.000216144) * s_5 - s_4 * Iu_4_t_d;
  const Scalar t49 = Scalar(7.394088669950739) * c_4 * t3 + s_4 * t34;
  const Scalar t50 = s_2_3 * t7;
  const Scalar t51 = t50 + Scalar(0.28919667590027703) * t49;
  const Scalar t52 = t3 * (t51 * t40 + t23 * t49);
  const Scalar db_11_4r = s_2_3 * (t47 + t9 * t48) + t52;
  const Scalar t53 = Scalar(0.00002) * qd_6;
  const Scalar t54 = t13 * t53 + qd_1 * db_11_4r;
  const Scalar t55 = Scalar(0.000621792) * s_2;
  const Scalar v_2_3_y = s_2_3 * t55 - Scalar(0.000621792) * c_2 * t3;
  const Scalar v_o_2_4_y = v_2_3_y - Scalar(0.000029232);
  const Scalar t56 = t22 - s_5 * v_o_2_4_y;
  const Scalar t57 = t15 + v_o_2_4_x;
  const Scalar t58 = t48 * t25;
  const Scalar t59 = t58 + t9 * t56 - t57 * t5;
  const Scalar t60 = t4 * t16;
  const Scalar t61 = t3 * t60;
  const Scalar mu_u_4_4_a_y = t21 - Scalar(0.00092108);
  const Scalar t62 = Scalar(0.000029232) * t4;
  const Scalar mu_4_3_y = t62 + mu_u_4_4_a_y;
  const Scalar t63 = (Scalar(0.000216144) * t13 + t61) - s_2_3 * mu_4_3_y;
  const Scalar t64 = t4 * t55 + t63;
  const Scalar t65 = t59 + t64;
  const Scalar c_1_4_5 = db_15_4 - t41;
  const Scalar t66 = -dmu_3_4_x * t9 - t58 + t61;
  const Scalar t67 = t63 - t66;
  C[3] = t54 + qd_5 * c_1_4_5 - qd_4 * t51 * t1 - qd_3 * t67 - qd_2 * t65;
  const Scalar t68 = Scalar(0.000058464) * s_5;
  const Scalar t69 = t68 * t49 - Scalar(0.000432288) * t2;
  const Scalar t70 = t12 * t37 + Scalar(0.5) * c_4 * t69;
  const Scalar t71 = s_4 * t16;
  const Scalar t72 = v_3_6_a_z * t25 + t70 - t39 * t71;
  const Scalar t73 = Scalar(0.000216144) * t11 - (Scalar(0.000029232) * t50 - t35 * t43);
  const Scalar t74 = t73 + t72;
  const Scalar t75 = s_4 * t57;
  const Scalar t76 = t4 * v_o_2_4_x - c_5 * v_o_2_4_y;
  const Scalar t77 = t76 * t25 + t70 - t39 * t75;
  const Scalar t78 = t55 * t7 + t73;
  const Scalar t79 = t78 + t77;
  const Scalar t80 = Scalar(2.0) * t39 * t37 - t69 * t25;
  const Scalar t81 = t11 * t53 + qd_1 * t80;
  C[4] = t81 + qd_4 * c_1_4_5 - qd_3 * t74 - qd_2 * t79 - qd_5 * t69;
  const Scalar t82 = t12 * t57 * t18 + t76 * t20;
  const Scalar f_3_3_x = t19 + Scalar(0.00874721925);
  const Scalar hc_3_x = t62 - Scalar(0.00025755625);
  const Scalar t83 = Scalar(68418.17186644772) * f_3_3_x * v_2_3_y -
      Scalar(42.54187192118226) * hc_3_x * v_2_3_x;
  const Scalar t84 = qd_3 * t83;
  C[7] = t56 * t24 - qd_5 * t82 + t84;
  const Scalar Iu_3_t_d = c_4 * (t68 + t22) + Scalar(0.001247328) * c_5 + mu_u_4_4_a_y +
      Scalar(0.150108592);
  const Scalar t85 = t19 - t60 + Scalar(0.00533681925);
  const Scalar t86 = Scalar(2.0) * t85;
  const Scalar Iu_3_t_g = s_2_3 * t86 - t3 * Iu_3_t_d;
  const Scalar t87 = t3 * (t3 * t86 + s_2_3 * Iu_3_t_d + f_3_3_x * t33);
  const Scalar t88 = (s_2_3 * hc_3_x + t3 * f_3_3_x) * t33;
  const Scalar t89 = t88 - s_2_3 * (Iu_3_t_g - hc_3_x * t33) + t87;
  const Scalar hu_3_t_x = s_2_3 * f_3_3_x - t3 * hc_3_x;
  const Scalar t90 = s_2 * (Scalar(21.27093596059113) * hu_3_t_x +
      (Scalar(0.800930601) * c_2 - Scalar(0.0070992) * s_2));
  const Scalar Iu_2_a_yz = Scalar(0.0035496) + t85 + t88 - s_2_3 * Iu_3_t_g + t90;
  const Scalar t91 = Scalar(2.0) * Iu_2_a_yz;
  C[0] = qd_4 * db_11_4r + qd_5 * t80 - qd_3 * t89 - qd_2 * t91;
  const Scalar t92 = t12 * (t71 + t75) + c_4 * (t76 + v_3_6_a_z);
  const Scalar t93 = c_4 * c_5 * v_2_3_y - s_5 * t28;
  const Scalar t94 = t93 - t92;
  const Scalar db_23_4r = s_4 * dmu_3_4_x + s_4 * t56;
  const Scalar t95 = t12 * v_2_3_y;
  const Scalar t96 = db_23_4r - t95;
  const Scalar t97 = qd_2 * t83;
  C[8] = qd_4 * t96 + qd_5 * t94 + t84 + t97;
  const Scalar t98 = t64 - t59;
  const Scalar t99 = t4 * t53;
  const Scalar t100 = qd_2 * t56 * t18 + (t99 + qd_1 * t98);
  const Scalar t101 = t30 + t32;
  const Scalar t102 = Scalar(2.0) * qd_4;
  C[9] = qd_3 * t96 - qd_5 * t101 + t100 - t4 * t57 * t102;
  const Scalar c_3_2_4 = db_23_4r + t95;
  const Scalar t103 = t66 + t63;
  const Scalar t104 = (qd_3 * dmu_3_4_x * t18 + qd_2 * c_3_2_4) + (t99 + qd_1 * t103);
  const Scalar t105 = t42 + t44;
  C[15] = -qd_5 * t105 - t60 * t102 + t104;
  C[18] = -t54 - qd_5 * c_5_1_4 - qd_3 * t103 - qd_2 * t98;
  const Scalar t106 = t73 - t72;
  const Scalar t107 = t78 - t77;
  C[24] = qd_4 * c_5_1_4 - t81 - qd_3 * t106 - qd_2 * t107;
  const Scalar t108 = qd_6 * mu_u_6_3_t_x;
  const Scalar t109 = t108 + qd_1 * t89;
  const Scalar Ic_3_yz = t17 + Scalar(0.002352);
  const Scalar db_13_3 = Scalar(2.0) * (dmu_3_4_x * t35 + s_2_3 * Ic_3_yz) +
      Scalar(14.788177339901479) * hu_3_t_x;
  const Scalar t110 = qd_3 * db_13_3;
  C[2] = -qd_5 * t74 - qd_4 * t67 + t110 - t109 + qd_2 * db_13_3;
  const Scalar t111 = t108 + qd_1 * t91;
  C[6] = qd_5 * t107 + qd_4 * t98 + t111;
  const Scalar t112 = t7 * t53;
  const Scalar t113 = (t112 + qd_1 * t107) - qd_2 * t82;
  const Scalar t114 = Scalar(2.0) * qd_5;
  C[10] = qd_3 * t94 - qd_4 * t101 + t113 - t76 * t114;
  C[12] = qd_5 * t106 + qd_4 * t103 + t109;
  const Scalar t115 = t93 + t92;
  C[13] = qd_4 * c_3_2_4 - qd_5 * t115 - t97;
  C[19] = qd_5 * c_4_2_5 - qd_3 * c_3_2_4 - t100;
  C[20] = -qd_5 * t45 - t104;
  const Scalar t116 = qd_2 * (Scalar(0.023751) * s_2 - db_13_3 -
      Scalar(0.001243584) * c_2 * (t12 + Scalar(555.1009815179352)));
  C[1] = -qd_5 * t79 - qd_4 * t65 + t110 - t116 - t111;
  C[25] = qd_3 * t115 - qd_4 * c_4_2_5 - t113;
  const Scalar t117 = (qd_3 * c_5_3_3 + qd_2 * t115) - (t112 + qd_1 * t106);
  C[26] = qd_4 * t45 + t117;
  C[16] = -v_3_6_a_z * t114 - qd_4 * t105 - t117;
  C[28] = C[35] = Scalar(0.0);
}

// Gravity torques g(q) (7.39).
//   q[6]  in   joint positions, rad or m
//   g[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..4]. Operations: 16 mul, 8 add, 8 sin/cos. Always zero: g[0], g[5].
template <class Scalar, class SinCos = LibrarySinCos>
inline void gravity(const Scalar* q, Scalar* g, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = Scalar(0.0282528) * s_5;
  g[3] = s_4 * s_2_3 * t1;
  const Scalar t2 = s_2 * s_3 - c_2 * c_3;
  const Scalar t3 = Scalar(0.0282528) * c_5;
  g[4] = t2 * t1 - c_4 * s_2_3 * t3;
  const Scalar hc_3_x = c_4 * t1 - Scalar(0.24892875);
  const Scalar hu_3_t_x = s_2_3 * (t3 + Scalar(8.45420895)) - t2 * hc_3_x;
  g[2] = -hu_3_t_x;
  g[1] = Scalar(1.024164) * s_2 - hu_3_t_x - Scalar(37.2347379) * c_2;
  g[0] = g[5] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   n[6]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..4], qd[0..5]. Operations: 146 mul, 110 add, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = s_2_3 * qd_1;
  const Scalar t2 = t1 * t1;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t3 = omega_3_z * omega_3_z;
  const Scalar t4 = qd_1 * qd_1;
  const Scalar t5 = t4 - t2 + t3;
  const Scalar t6 = qd_2 * qd_2;
  const Scalar t7 = s_2 * t6 + Scalar(22.71885132005558);
  const Scalar t8 = s_2 * s_3 - c_2 * c_3;
  const Scalar t9 = c_2 * (t6 + t4);
  const Scalar t10 = s_2_3 * t7 - t8 * t9;
  const Scalar t11 = t8 * qd_1;
  const Scalar t12 = t1 * t11;
  const Scalar t13 = Scalar(0.04701250578971746) * t5 + Scalar(1.0030106530801297) * t12 - t10;
  const Scalar t14 = omega_3_z * t1;
  const Scalar t15 = omega_3_z * t11;
  const Scalar t16 = Scalar(2.0) * qd_1;
  const Scalar t17 = Scalar(0.3476146364057434) * t4 + s_2 * qd_2 * t16;
  const Scalar t18 = t17 - Scalar(0.09402501157943492) * t14 + Scalar(2.0060213061602594) * t15;
  const Scalar t19 = s_4 * t18 - c_4 * t13;
  const Scalar Uz_o_4_y = t2 + t3;
  const Scalar t20 = s_2_3 * t9 + t8 * t7;
  const Scalar t21 = Scalar(0.04701250578971746) * t12 + Scalar(1.0030106530801297) * Uz_o_4_y +
      t20;
  const Scalar t22 = s_5 * t21 - c_5 * t19;
  const Scalar t23 = c_4 * t1;
  const Scalar t24 = s_4 * omega_3_z;
  const Scalar t25 = t24 - t23;
  const Scalar omega_4_z = qd_4 - t11;
  const Scalar omega_r_6_a_z = s_5 * t25 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t26 = Scalar(0.00004) * omega_6_z;
  const Scalar t27 = s_5 * omega_4_z - c_5 * t25;
  const Scalar t28 = t27 * omega_r_6_a_z;
  const Scalar t29 = t25 * omega_4_z;
  const Scalar t30 = t29 + t11 * (Scalar(2.0) * t24 - t23);
  const Scalar t31 = Scalar(0.00024216) * t28 - t27 * t26 + Scalar(0.00064216) * t30 -
      Scalar(0.001243584) * t22;
  n[4] = Scalar(0.85444524) * detail::sign(qd_5) - t31 + Scalar(0.4272830209354) * qd_5;
  const Scalar t32 = s_4 * t1;
  const Scalar t33 = c_4 * omega_3_z;
  const Scalar omega_r_4_y = t32 + t33;
  const Scalar t34 = omega_r_4_y * omega_4_z;
  const Scalar t35 = t34 + t11 * (t32 + Scalar(2.0) * t33);
  const Scalar U_4_zy = t34 + t35;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar t36 = t27 * omega_5_z;
  const Scalar t37 = t25 * omega_r_4_y;
  const Scalar U_4_xy = t37 + t14;
  const Scalar domega_5_y = t36 - s_5 * U_4_zy + c_5 * U_4_xy;
  const Scalar t38 = Scalar(0.00004) * domega_5_y;
  n[5] = Scalar(0.2158232532732) * qd_6 - t38 + Scalar(0.55443978) * detail::sign(qd_6);
  const Scalar mu_5_y = t38 + Scalar(0.0004) * t36;
  const Scalar t39 = omega_r_6_a_z * omega_5_z;
  const Scalar t40 = t39 - s_5 * U_4_xy - c_5 * U_4_zy;
  const Scalar t41 = s_4 * t13 + c_4 * t18;
  const Scalar t42 = omega_5_z * t26 - Scalar(0.00024216) * t40 - Scalar(0.00064216) * t39 +
      Scalar(0.001243584) * t41;
  const Scalar mu_u_4_a_y = Scalar(0.0003) * t37 + c_5 * mu_5_y + Scalar(0.0016) * t14 + s_5 * t42;
  n[3] = Scalar(0.411645229697152) * qd_4 - mu_u_4_a_y + Scalar(1.06831142) * detail::sign(qd_4);
  const Scalar mu_4_x = Scalar(0.0003) * t35 - s_5 * mu_5_y + Scalar(0.0016) * t34 + c_5 * t42;
  const Scalar Uz_o_6_z = t39 + t40;
  const Scalar t43 = Scalar(0.23306405) * t41 - Scalar(0.001243584) * Uz_o_6_z;
  const Scalar Uz_o_6_y = t27 * t27 + omega_5_z * omega_5_z;
  const Scalar U_5_xy = t28 + t30;
  const Scalar t44 = Scalar(0.001243584) * (c_5 * U_5_xy + s_5 * Uz_o_6_y) +
      Scalar(0.23306405) * t19;
  const Scalar t45 = s_4 * t43 - c_4 * t44;
  const Scalar t46 = Scalar(0.0013) * t29 + t31;
  const Scalar t47 = Scalar(0.23306405) * t21 -
      Scalar(0.001243584) * (s_5 * U_5_xy - c_5 * Uz_o_6_y);
  const Scalar t48 = Scalar(0.000316274) * (t5 - Uz_o_4_y) - s_4 * mu_4_x + c_4 * t46 -
      Scalar(0.065620624) * t12 + Scalar(0.04701250578971746) * t47 + Scalar(0.138357356) * t10 -
      Scalar(1.0030106530801297) * t45;
  const Scalar t49 = Scalar(-0.138357356) * t12 - t45 + Scalar(1.405871712) * t10;
  const Scalar f_3_y = Scalar(0.138357356) * Uz_o_4_y + t47 + Scalar(1.405871712) * t20;
  const Scalar I_t2_g = Scalar(0.0141984) * s_2 + Scalar(0.03707456) * c_2;
  const Scalar I_2_xy = s_2 * I_t2_g - Scalar(0.0070992);
  n[1] = Scalar(1.024164) * s_2 - t4 * I_2_xy - t48 + Scalar(10.6197775) * detail::sign(qd_2) +
      Scalar(9.496868641825) * qd_2 - s_3 * t49 + c_3 * f_3_y;
  n[2] = Scalar(6.36419655) * detail::sign(qd_3) - t48 + Scalar(3.9804259903722) * qd_3;
  const Scalar t50 = s_2_3 * f_3_y - t8 * t49;
  const Scalar t51 = s_4 * t44 + c_4 * t43;
  const Scalar U_3_yy_zz = t4 - Uz_o_4_y;
  const Scalar mu_3_x = Scalar(0.000632548) * t14 + s_4 * t46 + c_4 * mu_4_x +
      Scalar(0.004704) * U_3_yy_zz + Scalar(0.138357356) * t17 + Scalar(0.143741248) * t15 +
      Scalar(1.0030106530801297) * t51;
  const Scalar t52 = c_2 * (Scalar(0.276714712) * t15 + t51 + Scalar(1.405871712) * t17);
  const Scalar t53 = Scalar(0.000632548) * t15 + Scalar(0.004704) * t12 + mu_u_4_a_y +
      Scalar(0.0125) * t14 - Scalar(0.04701250578971746) * t51;
  const Scalar t54 = t16 * (qd_2 * I_2_xy + Scalar(2.9009108839754));
  const Scalar t55 = t6 * (Scalar(0.12059664) * c_2 - Scalar(0.023751) * s_2);
  n[0] = t8 * t53 + t55 - s_2_3 * mu_3_x + Scalar(0.3476146364057434) * t50 - t52 +
      Scalar(25.9836065) * detail::sign(qd_1) + t54;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   tau[6]  in   joint torques or forces, N m or N
//   qdd[6]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[1..4], qd[0..5], tau[0..5]. Operations: 274 mul, 211 add, 4 div, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  const Scalar tau_1 = tau[0], tau_2 = tau[1], tau_3 = tau[2], tau_4 = tau[3], tau_5 = tau[4],
      tau_6 = tau[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = s_2_3 * qd_1;
  const Scalar t2 = c_4 * t1;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t3 = s_4 * omega_3_z;
  const Scalar t4 = t3 - t2;
  const Scalar t5 = s_2 * s_3 - c_2 * c_3;
  const Scalar t6 = t5 * qd_1;
  const Scalar omega_4_z = qd_4 - t6;
  const Scalar omega_r_6_a_z = s_5 * t4 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t7 = Scalar(0.00004) * omega_6_z;
  const Scalar t8 = s_4 * t1;
  const Scalar t9 = c_4 * omega_3_z;
  const Scalar omega_r_4_y = t8 + t9;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar t10 = t1 * t1;
  const Scalar t11 = omega_3_z * omega_3_z;
  const Scalar t12 = qd_1 * qd_1;
  const Scalar t13 = t12 - t10 + t11;
  const Scalar t14 = qd_2 * qd_2;
  const Scalar t15 = Scalar(2.876748834110593) * s_2 * t14 + Scalar(65.3564290473018);
  const Scalar t16 = Scalar(2.876748834110593) * c_2;
  const Scalar t17 = (t14 + t12) * t16;
  const Scalar t18 = s_2_3 * t15 - t5 * t17;
  const Scalar t19 = t1 * t6;
  const Scalar t20 = Scalar(0.13524317121918722) * t13 + Scalar(2.8854097268487675) * t19 - t18;
  const Scalar t21 = omega_3_z * t1;
  const Scalar t22 = omega_3_z * t6;
  const Scalar t23 = t12 + Scalar(5.753497668221186) * s_2 * qd_1 * qd_2;
  const Scalar t24 = t23 - Scalar(0.27048634243837444) * t21 + Scalar(5.770819453697535) * t22;
  const Scalar t25 = s_4 * t20 + c_4 * t24;
  const Scalar t26 = omega_r_6_a_z * omega_5_z;
  const Scalar t27 = omega_5_z * t7 - Scalar(0.00088432) * t26 + Scalar(0.000432288) * t25;
  const Scalar t28 = s_5 * omega_4_z - c_5 * t4;
  const Scalar t29 = t28 * omega_5_z;
  const Scalar t30 = omega_r_4_y * omega_4_z;
  const Scalar t31 = t6 * (t8 + Scalar(2.0) * t9) + Scalar(2.0) * t30;
  const Scalar t32 = t4 * omega_r_4_y;
  const Scalar U_4_xy = t32 + t21;
  const Scalar domega_5_y = t29 + c_5 * U_4_xy - s_5 * t31;
  const Scalar mu_5_y = Scalar(0.00064216) * t29 - Scalar(0.00020216) * domega_5_y;
  const Scalar mu_4_x = Scalar(0.00238432) * t30 - s_5 * mu_5_y + c_5 * t27;
  const Scalar t33 = Scalar(0.2158232532732) * qd_6 - Scalar(0.00004) * domega_5_y +
      Scalar(0.55443978) * detail::sign(qd_6) - tau_6;
  const Scalar t34 = s_4 * (mu_4_x - Scalar(0.00019430115597482132) * s_5 * t33);
  const Scalar Uz_o_6_y = t28 * t28 + omega_5_z * omega_5_z;
  const Scalar t35 = Scalar(0.000432288) * s_5;
  const Scalar t36 = t28 * omega_r_6_a_z;
  const Scalar t37 = t4 * omega_4_z;
  const Scalar t38 = t37 + t6 * (Scalar(2.0) * t3 - t2);
  const Scalar U_5_xy = t36 + t38;
  const Scalar t39 = Scalar(0.000432288) * c_5;
  const Scalar t40 = t35 * Uz_o_6_y + t39 * U_5_xy;
  const Scalar Uz_o_6_z = Scalar(2.0) * t26 - s_5 * U_4_xy - c_5 * t31;
  const Scalar t41 = Scalar(0.000432288) * Uz_o_6_z;
  const Scalar t42 = c_4 * t40 + s_4 * t41;
  const Scalar Uz_o_4_y = t10 + t11;
  const Scalar t43 = s_2_3 * t17 + t5 * t15;
  const Scalar t44 = s_5 * (Scalar(0.13524317121918722) * t19 +
      Scalar(2.8854097268487675) * Uz_o_4_y + t43);
  const Scalar t45 = t44 - c_5 * (s_4 * t24 - c_4 * t20);
  const Scalar t46 = Scalar(0.00024216) * t36 - t28 * t7 + Scalar(0.00064216) * t38 -
      Scalar(0.000432288) * t45;
  const Scalar t47 = Scalar(0.00184216) * t37 - Scalar(0.00054216) * t38 + t46;
  const Scalar t48 = t35 * U_5_xy - t39 * Uz_o_6_y;
  const Scalar t49 = c_4 * t47 - Scalar(0.13524317121918722) * t48 - t34 +
      Scalar(2.8854097268487675) * t42 + Scalar(0.0038087875) * t43 -
      Scalar(0.0106736385) * (t13 - Uz_o_4_y) - Scalar(0.300117184) * t19 +
      Scalar(0.1293554295) * t18;
  const Scalar mu_u_4_a_y = Scalar(0.00054216) * t32 + c_5 * mu_5_y + Scalar(0.00184216) * t21 +
      s_5 * t27;
  const Scalar t50 = Scalar(0.00019430115597482132) * c_5;
  const Scalar t51 = -t50 * t33 - mu_u_4_a_y + Scalar(0.411645229697152) * qd_4 +
      Scalar(1.06831142) * detail::sign(qd_4) - tau_4;
  const Scalar t52 = Scalar(0.00020216) * c_5;
  const Scalar t53 = t52 + Scalar(0.001247328);
  const Scalar t54 = s_4 * s_5;
  const Scalar t55 = t53 * t54;
  const Scalar t56 = Scalar(7.772046238992852e-09) * t54;
  const Scalar t57 = c_5 * t56 + t55;
  const Scalar t58 = Scalar(0.00020216777204623898) * c_5 * c_5 - Scalar(0.2041958543736);
  const Scalar t59 = Scalar(1.0) / t58;
  const Scalar t60 = t57 * t59;
  const Scalar t61 = Scalar(0.85444524) * detail::sign(qd_5) - t46 +
      Scalar(0.4272830209354) * qd_5 - tau_5;
  const Scalar t62 = Scalar(0.001247328) * c_5 + Scalar(0.00064216);
  const Scalar t63 = Scalar(0.000058464) * s_5 - c_4 * t62;
  const Scalar t64 = Scalar(5.5037503582353615) * t63;
  const Scalar t65 = t64 * t61 - t60 * t51 + Scalar(6.36419655) * detail::sign(qd_3) - t49 +
      Scalar(3.9804259903722) * qd_3 - tau_3;
  const Scalar t66 = c_5 * t52;
  const Scalar Iu_5_t_xx = t66 - Scalar(0.00020216);
  const Scalar Iu_4_t_d = Iu_5_t_xx - Scalar(0.0001);
  const Scalar t67 = c_4 * Iu_4_t_d;
  const Scalar t68 = c_4 * t67;
  const Scalar t69 = c_4 * s_5;
  const Scalar t70 = Scalar(0.000116928) * t69;
  const Scalar t71 = Scalar(0.002494656) * c_5;
  const Scalar t72 = -t54 * t56 - t70 - t68 + Iu_5_t_xx + t71 + Scalar(0.313647409);
  const Scalar b_4_3_3 = t57 * t60 - t63 * t64 + t72 + Scalar(0.86242563124731);
  const Scalar d_3 = Scalar(1.0) / b_4_3_3;
  const Scalar t73 = Scalar(0.001243584) * s_3 * t54 + t57;
  const Scalar t74 = t63 - Scalar(0.001243584) * (s_3 * c_4 * c_5 + c_3 * s_5);
  const Scalar f_3_3_x = t39 + Scalar(0.1293554295);
  const Scalar hc_3_x = Scalar(0.000432288) * t69 - Scalar(0.0038087875);
  const Scalar t75 = c_3 * hc_3_x + s_3 * f_3_3_x;
  const Scalar b_4_3_2 = t73 * t60 - t74 * t64 + t72 + Scalar(2.876748834110593) * t75;
  const Scalar t76 = b_4_3_2 * d_3;
  const Scalar t77 = Scalar(0.0038087875) * t13 - t42 + Scalar(0.1293554295) * t19;
  const Scalar t78 = Scalar(0.0038087875) * t19 - t48 + Scalar(0.1293554295) * Uz_o_4_y;
  const Scalar t79 = s_3 * t77 + c_3 * t78;
  const Scalar t80 = t73 * t59;
  const Scalar t81 = Scalar(5.5037503582353615) * t74;
  const Scalar t82 = Scalar(1.601861202) * c_2 - Scalar(0.0141984) * s_2;
  const Scalar t83 = Scalar(0.0070992) + s_2 * t82;
  const Scalar t84 = t80 * t51 - t81 * t61 - Scalar(1.024164) * s_2 + t49 -
      Scalar(2.876748834110593) * t79 - t12 * t83 - Scalar(10.6197775) * detail::sign(qd_2) +
      tau_2 + t76 * t65 + Scalar(37.2347379) * c_2 - Scalar(9.496868641825) * qd_2;
  const Scalar Ic_3_xz = Scalar(0.000058464) * t54 + s_4 * t67;
  const Scalar Ic_3_yz = t55 + Scalar(0.004704);
  const Scalar t85 = Scalar(0.00004) * s_2_3 * t69 + Scalar(0.00004) * c_5 * t5;
  const Scalar t86 = Scalar(0.00019430115597482132) * t54 * t85 + s_2_3 * (hc_3_x - Ic_3_xz) +
      t5 * (Ic_3_yz + f_3_3_x);
  const Scalar t87 = t39 * (c_4 * t5 +
      Scalar(2.876748834110593) * s_4 * (Scalar(0.04701250578971746) * t5 + c_2));
  const Scalar t88 = t87 + s_2_3 * (t35 + s_4 * t62);
  const Scalar mu_u_4_4_a_y = t66 - Scalar(0.00184216);
  const Scalar t89 = t5 * (Scalar(0.000058464) * t69 - Scalar(0.000432288) * t54 + mu_u_4_4_a_y);
  const Scalar b_6_4_1 = t85 * t50 + t69 * (Scalar(0.001243584) * c_2 + s_2_3 * t53) + t89;
  const Scalar t90 = t88 * t64 - b_6_4_1 * t60 + t86;
  const Scalar b_3_2_1 = t88 * t81 - b_6_4_1 * t80 + Scalar(0.023751) * c_2 - t90 * t76 + t86 +
      Scalar(0.001243584) * s_2 * (t54 + Scalar(555.1009815179352));
  const Scalar b_3_2_2 = t73 * t80 - t74 * t81 - b_4_3_2 * t76 + t72 +
      Scalar(5.753497668221186) * t75 + Scalar(6.502360360025);
  const Scalar d_2 = Scalar(1.0) / b_3_2_2;
  const Scalar t91 = b_3_2_1 * d_2;
  const Scalar t92 = t90 * d_3;
  const Scalar t93 = s_4 * t40 - c_4 * t41;
  const Scalar U_3_yy_zz = t12 - Uz_o_4_y;
  const Scalar t94 = s_4 * t47 + c_4 * mu_4_x + Scalar(2.8854097268487675) * t93 +
      Scalar(0.004704) * U_3_yy_zz - Scalar(0.021347277) * t21 - t78 + Scalar(0.1293554295) * t23 +
      Scalar(0.613764593) * t22;
  const Scalar t95 = Scalar(0.13524317121918722) * t93 - Scalar(0.004704) * t19 - mu_u_4_a_y -
      Scalar(0.013530225) * t21 + Scalar(0.0038087875) * t23 + Scalar(0.021347277) * t22 - t77;
  const Scalar t96 = b_6_4_1 * t59;
  const Scalar t97 = t16 * (Scalar(0.007617575) * t21 - t93 - Scalar(0.258710859) * t22);
  const Scalar t98 = Scalar(5.5037503582353615) * t88;
  const Scalar t99 = Scalar(-4.857528899370533) * t85;
  const Scalar t100 = qd_1 * (qd_2 * t83 - Scalar(2.9009108839754));
  const Scalar t101 = t14 * (Scalar(0.690314699) * c_2 - Scalar(0.023751) * s_2);
  const Scalar t102 = -t99 * t33 - t98 * t61 + t96 * t51 - t5 * t95 - t92 * t65 + t91 * t84 + t97 +
      t101 - s_2_3 * t94 - tau_1 + Scalar(25.9836065) * detail::sign(qd_1) - Scalar(2.0) * t100;
  const Scalar Ic_3_xx = t68 + Scalar(0.0001) + t71;
  const Scalar Iu_3_t_d = t70 + mu_u_4_4_a_y + Ic_3_xx + Scalar(0.300117184);
  const Scalar t103 = s_2_3 * (Scalar(0.000058464) * c_5 - t69 * t53 + Scalar(0.0106736385));
  const Scalar Iu_3_t_g = Scalar(2.0) * t103 - t5 * Iu_3_t_d;
  const Scalar hu_3_t_x = s_2_3 * f_3_3_x - t5 * hc_3_x;
  const Scalar t104 = c_2 * (Scalar(5.753497668221186) * hu_3_t_x + t82);
  const Scalar b_2_1_1 = t85 * t99 - t88 * t98 + b_6_4_1 * t96 + Scalar(0.000864576) * t54 +
      Ic_3_xx - t90 * t92 - b_3_2_1 * t91 + t5 * Iu_3_t_g + t104 + Scalar(2.99250185137411);
  const Scalar t105 = t102 / b_2_1_1;
  qdd[0] = -t105;
  const Scalar qdd_2 = d_2 * (b_3_2_1 * t105 + t84);
  qdd[1] = qdd_2;
  const Scalar t106 = d_3 * (b_4_3_2 * qdd_2 - t90 * t105 + t65);
  qdd[2] = -t106;
  const Scalar qdd_4 = t59 * (t57 * t106 - t73 * qdd_2 - b_6_4_1 * t105 + t51);
  qdd[3] = qdd_4;
  const Scalar t107 = t74 * qdd_2 - t63 * t106;
  qdd[4] = Scalar(5.5037503582353615) * t107 - Scalar(5.5037503582353615) * (t61 - t88 * t105);
  const Scalar t108 = t54 * (qdd_2 - t106) + c_5 * qdd_4;
  qdd[5] = Scalar(-0.00019430115597482132) * t108 - Scalar(4.857528899370533) * (t85 * t105 + t33);
  bool positive = b_2_1_1 > Scalar(0.0);
  positive &= b_3_2_2 > Scalar(0.0);
  positive &= b_4_3_3 > Scalar(0.0);
  positive &= -t58 > Scalar(0.0);
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
  static_assert(detail::Interface::checked<Scalar>());
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
  const Scalar omega_4_z = qd_4 - t8;
  const Scalar t12 = s_5 * omega_4_z - c_5 * t11;
  const Scalar t13 = t12 * (Scalar(0.00024216) * t12 + Scalar(0.000864576) * v_r_4_y);
  const Scalar omega_6_z = qd_6 + s_5 * t11 + c_5 * omega_4_z;
  const Scalar t14 = Scalar(0.004704) * t8 - Scalar(0.007617575) * v_r_3_y -
      Scalar(0.258710859) * t4 + Scalar(0.313105249) * omega_3_z;
  const Scalar L_3_y = Scalar(0.0106736385) * t7 + Scalar(0.004704) * omega_3_z +
      Scalar(0.02191385) * t2;
  const Scalar t15 = t7 * (Scalar(0.0106736385) * t8 + Scalar(0.299575024) * t7 +
      Scalar(0.744246162) * t2);
  const Scalar t16 = s_2 * (Scalar(0.690314699) * qd_2 - Scalar(0.0070992) * t2 -
      Scalar(1.601861202) * t1);
  const Scalar t17 = c_2 * (Scalar(0.023751) * qd_2 - Scalar(0.0070992) * t1) + t16 +
      Scalar(4.29424586937411) * qd_1;
  const Scalar t18 = qd_2 * (Scalar(0.023751) * t2 + Scalar(0.690314699) * t1 +
      Scalar(6.502360360025) * qd_2);
  const Scalar T_2 = Scalar(0.00004) * omega_6_z * omega_6_z + Scalar(0.0003) * t11 * t11 +
      Scalar(0.0016) * omega_4_z * omega_4_z + t10 + t13 + t8 * L_3_y +
      Scalar(0.20582599086) * qd_6 * qd_6 + Scalar(0.181052127515) * qd_5 * qd_5 +
      Scalar(0.2023536943736) * qd_4 * qd_4 + t15 + Scalar(0.86242563124731) * qd_3 * qd_3 +
      omega_3_z * t14 + t18 + qd_1 * t17;
  return Scalar(0.5) * T_2;
}

// Potential energy of links and rotors (7.36).
//   q[6]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[1..4]. Operations: 10 mul, 7 add, 7 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar potential_energy(const Scalar* q, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
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
  static_assert(detail::Interface::checked<Scalar>());
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
  static_assert(detail::Interface::checked<Scalar>());
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
// Reads q[0..5], qd[0..5]. Operations: 119 mul, 65 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = c_2 * s_3;
  const Scalar t2 = qd_1 * (t1 + s_2 * c_3);
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t3 = s_4 * omega_3_z;
  const Scalar t4 = t3 - c_4 * t2;
  const Scalar t5 = c_2 * c_3;
  const Scalar t6 = qd_1 * (s_2 * s_3 - t5);
  const Scalar omega_4_z = qd_4 - t6;
  const Scalar t7 = s_5 * omega_4_z - c_5 * t4;
  const Scalar t8 = c_4 * omega_3_z;
  const Scalar omega_r_4_y = s_4 * t2 + t8;
  const Scalar omega_5_z = qd_5 + omega_r_4_y;
  const Scalar t9 = qd_6 * (s_6 * omega_5_z - c_6 * t7);
  const Scalar omega_r_6_a_z = s_5 * t4 + c_5 * omega_4_z;
  const Scalar t10 = t8 * t6 + qd_4 * omega_r_4_y;
  const Scalar t11 = omega_3_z * t2;
  const Scalar t12 = qd_5 * omega_r_6_a_z - s_5 * t11 - c_5 * t10;
  const Scalar t13 = t3 * t6 + qd_4 * t4;
  const Scalar t14 = t9 - s_6 * t12 + c_6 * t13;
  const Scalar omega_r_6_y = s_6 * t7 + c_6 * omega_5_z;
  const Scalar t15 = qd_6 * omega_r_6_y - s_6 * t13 - c_6 * t12;
  const Scalar t16 = s_6 * t14 + c_6 * t15;
  const Scalar domega_q_5_y = c_5 * t11 + qd_5 * t7 - s_5 * t10;
  const Scalar t17 = s_5 * domega_q_5_y - c_5 * t16;
  const Scalar domega_e_6_t_y = s_6 * t15 - c_6 * t14;
  const Scalar t18 = s_4 * domega_e_6_t_y + c_4 * t17;
  const Scalar domega_e_5_t_y = s_5 * t16 + c_5 * domega_q_5_y;
  const Scalar t19 = s_3 * domega_e_5_t_y + c_3 * t18;
  const Scalar t20 = s_3 * t18 - c_3 * domega_e_5_t_y;
  a[5] = s_2 * t19 + c_2 * t20;
  const Scalar t21 = omega_3_z * (Scalar(0.04687139228815516) * t2 - t6);
  const Scalar t22 = s_2 * qd_1;
  const Scalar t23 = qd_1 * qd_1;
  const Scalar t24 = Scalar(0.1501) * t23 + Scalar(0.8636) * qd_2 * t22 - Scalar(0.8662) * t21;
  const Scalar t25 = t2 * t2;
  const Scalar t26 = omega_3_z * omega_3_z;
  const Scalar t27 = qd_2 * qd_2 - t22 * t22 + t23;
  const Scalar t28 = qd_1 * t22;
  const Scalar t29 = t1 * t28 - c_3 * t27;
  const Scalar t30 = t2 * t6;
  const Scalar t31 = Scalar(0.0203) * (t23 - t25 + t26) + Scalar(0.4331) * t30 +
      Scalar(0.4318) * t29;
  const Scalar t32 = s_4 * t24 - c_4 * t31;
  const Scalar Uz_o_4_y = t25 + t26;
  const Scalar t33 = t5 * t28 + s_3 * t27;
  const Scalar t34 = Scalar(0.0203) * t30 + Scalar(0.4318) * t33 + Scalar(0.4331) * Uz_o_4_y;
  const Scalar t35 = s_5 * t34 - c_5 * t32;
  const Scalar t36 = s_4 * t31 + c_4 * t24;
  const Scalar t37 = s_6 * t35 + c_6 * t36;
  const Scalar t38 = s_6 * t36 - c_6 * t35;
  const Scalar t39 = s_6 * t37 - c_6 * t38;
  const Scalar t40 = s_5 * t32 + c_5 * t34;
  const Scalar t41 = s_5 * t40 - c_5 * t39;
  const Scalar t42 = s_6 * t38 + c_6 * t37;
  const Scalar t43 = s_4 * t42 - c_4 * t41;
  const Scalar t44 = s_5 * t39 + c_5 * t40;
  const Scalar t45 = s_3 * t44 - c_3 * t43;
  const Scalar t46 = s_3 * t43 + c_3 * t44;
  a[2] = s_2 * t45 - c_2 * t46;
  const Scalar t47 = s_2 * t20 - c_2 * t19;
  const Scalar t48 = s_4 * t17 - c_4 * domega_e_6_t_y;
  a[3] = s_1 * t48 + c_1 * t47;
  a[4] = s_1 * t47 - c_1 * t48;
  const Scalar t49 = s_2 * t46 + c_2 * t45;
  const Scalar t50 = s_4 * t41 + c_4 * t42;
  a[0] = s_1 * t50 - c_1 * t49;
  a[1] = -s_1 * t49 - c_1 * t50;
}

// The functions by type, with the shapes of their arguments: what adapters such as
// flatdyn/eigen.hpp are given.
namespace functions {

struct inverse_dynamics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], const Scalar (&qd)[6], const Scalar (&qdd)[6],
      Scalar (&tau)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::puma560::inverse_dynamics(of...); }
};

struct inverse_dynamics_tip_force {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], const Scalar (&qd)[6], const Scalar (&qdd)[6],
      const Scalar (&h_e)[6], Scalar (&tau)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept {
    return ::puma560::inverse_dynamics_tip_force(of...);
  }
};

struct inertia_matrix {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], Scalar (&B)[6][6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::puma560::inertia_matrix(of...); }
};

struct christoffel {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], Scalar (&c)[6][21]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::puma560::christoffel(of...); }
};

struct coriolis_matrix {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], const Scalar (&qd)[6], Scalar (&C)[6][6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::puma560::coriolis_matrix(of...); }
};

struct gravity {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], Scalar (&g)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::puma560::gravity(of...); }
};

struct bias {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], const Scalar (&qd)[6], Scalar (&n)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::puma560::bias(of...); }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[6], const Scalar (&qd)[6], const Scalar (&tau)[6],
      Scalar (&qdd)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::puma560::forward_dynamics(of...); }
};

struct kinetic_energy {
  template <class Scalar>
  using Shape = Scalar(const Scalar (&q)[6], const Scalar (&qd)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::puma560::kinetic_energy(of...); }
};

struct potential_energy {
  template <class Scalar>
  using Shape = Scalar(const Scalar (&q)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::puma560::potential_energy(of...); }
};

struct forward_kinematics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], Scalar (&R)[3][3], Scalar (&p)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::puma560::forward_kinematics(of...); }
};

struct jacobian {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], Scalar (&J)[6][6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::puma560::jacobian(of...); }
};

struct jacobian_dot_qd {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], const Scalar (&qd)[6], Scalar (&a)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::puma560::jacobian_dot_qd(of...); }
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

}  // namespace puma560

#endif  // FLATDYN_PUMA560_HPP_84074528

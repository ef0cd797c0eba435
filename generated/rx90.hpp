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
// sine, c_1 its cosine, s_2_3 the sine of the angle by which parallel joints 2 and 3 together turn.
// Of link i: omega_i and domega_i are its angular velocity and acceleration, ddp_i the acceleration
// of its frame's origin less gravity, f_i and mu_i the force and moment that it gets from the link
// before, hc_i and hu_i the first moment of all that its joint carries (in gravity() times the size
// of gravity); t1, t2, ... are parts of sums.

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
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5], qd[0..5], qdd[0..5]. Operations: 213 mul, 198 add, 10 sin/cos.
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
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = s_2_3 * qd_1;
  const Scalar t2 = s_2 * s_3 - c_2 * c_3;
  const Scalar t3 = t2 * qd_1;
  const Scalar t4 = t1 * t3;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar t5 = t4 + domega_3_z;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t6 = s_2_3 * qdd_1;
  const Scalar t7 = Scalar(2.0) * omega_3_z * t3 - t6;
  const Scalar t8 = s_4 * t5 + c_4 * t7;
  const Scalar omega_r_5_a_z = s_4 * t1 + c_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 - t3;
  const Scalar t9 = t8 + Scalar(2.0) * omega_r_5_a_z * omega_4_z;
  const Scalar t10 = omega_3_z * t1;
  const Scalar t11 = t2 * qdd_1;
  const Scalar t12 = t11 + t10;
  const Scalar domega_4_z = qdd_4 - t12;
  const Scalar t13 = s_4 * omega_3_z - c_4 * t1;
  const Scalar t14 = t13 * omega_r_5_a_z;
  const Scalar Uz_o_5_x = domega_4_z - t14;
  const Scalar Uz_5_x = c_5 * Uz_o_5_x + s_5 * t9;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t13;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t15 = omega_r_5_x * omega_5_z;
  const Scalar domega_5_y = Uz_5_x - t15;
  const Scalar domega_6_z = qdd_6 + domega_5_y;
  const Scalar t16 = t15 + domega_6_z;
  const Scalar t17 = Scalar(0.0009944) * c_6 - Scalar(0.000534) * s_6;
  const Scalar t18 = s_5 * Uz_o_5_x - c_5 * t9;
  const Scalar omega_r_5_y = s_5 * t13 + c_5 * omega_4_z;
  const Scalar t19 = Scalar(2.0) * omega_5_z;
  const Scalar U_5_zy = t18 + omega_r_5_y * t19;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t20 = U_5_zy - t19 * omega_6_z;
  const Scalar I_t6_g = Scalar(0.0002546) * c_6 - Scalar(0.000512) * s_6;
  const Scalar I_6_xy = s_6 * I_t6_g + Scalar(0.000256);
  const Scalar t21 = omega_6_z * omega_6_z;
  const Scalar t22 = omega_5_z * omega_5_z;
  const Scalar t23 = t22 + t21;
  const Scalar t24 = omega_r_5_x * omega_r_5_x;
  const Scalar t25 = t24 + t22;
  const Scalar I_6_xz = Scalar(0.000534) * c_6 + Scalar(0.0009944) * s_6;
  const Scalar t26 = s_4 * t7 - c_4 * t5;
  const Scalar t27 = t13 * omega_4_z;
  const Scalar t28 = t27 + t26;
  const Scalar domega_5_z = qdd_5 - t28;
  const Scalar t29 = omega_r_5_x * omega_r_5_y;
  const Scalar t30 = domega_5_z - t29;
  const Scalar U_6_zx = t30 + Scalar(2.0) * omega_r_5_x * omega_6_z;
  const Scalar t31 = c_6 * I_t6_g;
  const Scalar t32 = t31 - Scalar(0.0007896);
  const Scalar t33 = Scalar(2.0) * qd_1;
  const Scalar t34 = s_2 * qd_2 * t33 - c_2 * qdd_1;
  const Scalar t35 = t7 - t34;
  const Scalar t36 = qd_2 * qd_2;
  const Scalar t37 = qd_1 * qd_1;
  const Scalar t38 = s_2 * qdd_2 + c_2 * (t36 + t37);
  const Scalar t39 = s_2 * t36 - c_2 * qdd_2 - Scalar(21.8);
  const Scalar t40 = s_2_3 * t39 - t2 * t38;
  const Scalar t41 = t5 + t40;
  const Scalar t42 = s_4 * t35 - c_4 * t41;
  const Scalar t43 = t1 * t1;
  const Scalar t44 = omega_3_z * omega_3_z;
  const Scalar t45 = t43 + t44;
  const Scalar ddp_3_y = s_2_3 * t38 + t2 * t39;
  const Scalar t46 = t45 - ddp_3_y;
  const Scalar t47 = s_5 * t42 + c_5 * t46;
  const Scalar t48 = Scalar(0.00315) * c_6 + Scalar(0.00504) * s_6;
  const Scalar U_5_yx = t29 + domega_5_z;
  const Scalar t49 = s_5 * t46 - c_5 * t42;
  const Scalar t50 = t13 * t13;
  const Scalar t51 = omega_4_z * omega_4_z;
  const Scalar Uz_o_5_y = t51 + t50;
  const Scalar t52 = Uz_o_5_y - t24 + t22;
  const Scalar mu_5_z = I_6_xz * (t25 - t23) - Scalar(0.0007639) * t18 - t20 * I_6_xy + t16 * t17 +
      Scalar(0.0016163) * Uz_5_x - Scalar(0.0010857) * (t52 - t25) - U_6_zx * t32 +
      Scalar(0.0029421) * U_5_yx + t47 * (t48 - Scalar(0.009135)) + Scalar(0.0123285) * t30 +
      Scalar(0.014265) * t49;
  tau[4] = mu_5_z;
  const Scalar t53 = t15 - domega_6_z;
  const Scalar I_6_xx = t31 + Scalar(0.000535);
  const Scalar t54 = t24 + t21;
  const Scalar mr_6_y = Scalar(0.00504) * c_6 - Scalar(0.00315) * s_6;
  const Scalar t55 = s_4 * t41 + c_4 * t35;
  const Scalar t56 = I_6_xy * (t23 - t54) - t53 * t32 - t16 * I_6_xx - U_5_zy * I_6_xz - t30 * t17 -
      mr_6_y * t49 + t48 * t55;
  tau[5] = -t56;
  const Scalar U_5_zx = t15 - domega_5_y;
  const Scalar t57 = Scalar(0.0007639) * (Uz_o_5_y - t52) + Scalar(0.0016163) * t30 +
      Scalar(0.0010857) * U_5_zy - Scalar(0.0029421) * U_5_zx + Scalar(0.009135) * t55 - t56;
  const Scalar U_6_yy_zz = t25 - t54;
  const Scalar U_5_yy_zz = Uz_o_5_y - t25;
  const Scalar t58 = U_6_zx * I_6_xy + Scalar(0.0007639) * U_5_yx + t17 * U_6_yy_zz + t53 * I_6_xz +
      Scalar(0.0010857) * U_5_zx - Scalar(0.0016163) * U_5_yy_zz - t20 * I_6_xx + mr_6_y * t47 +
      Scalar(0.014265) * t55 - Scalar(0.0123285) * U_5_zy;
  const Scalar t59 = t51 - t50 + t45;
  const Scalar U_4_yx = domega_4_z + t14;
  const Scalar tau_4 = Scalar(0.0009736) * (t59 - Uz_o_5_y) + Scalar(0.0110896) * t8 +
      Scalar(0.0123968) * U_4_yx + c_5 * t57 - s_5 * t58 + Scalar(0.0523608) * t26 +
      Scalar(0.0316473) * Uz_o_5_x - Scalar(0.05238) * t55 - Scalar(0.096525) * t42;
  tau[3] = tau_4;
  const Scalar t60 = mr_6_y * t16 - t48 * t23 + Scalar(0.009135) * t52 + Scalar(0.014265) * t30;
  const Scalar f_5_y = Scalar(0.009135) * U_5_yx + mr_6_y * t20 - t48 * U_6_zx -
      Scalar(0.014265) * t25;
  const Scalar f_4_x = -s_5 * f_5_y - c_5 * t60 + Scalar(0.05238) * t59 -
      Scalar(0.096525) * Uz_o_5_x + Scalar(1.72386) * t42;
  const Scalar t61 = mr_6_y * t54 - t48 * t53 + Scalar(0.009135) * U_5_zx +
      Scalar(0.05238) * U_4_yx + Scalar(0.014265) * U_5_zy + Scalar(0.096525) * Uz_o_5_y -
      Scalar(1.72386) * t55;
  const Scalar f_u_4_t_x = s_4 * t61 + c_4 * f_4_x;
  const Scalar t62 = t27 + t28;
  const Scalar U_4_yy_zz = t45 - Uz_o_5_y;
  const Scalar t63 = Scalar(0.0009736) * t62 + Scalar(0.0110896) * U_4_yx + s_5 * t57 + c_5 * t58 +
      Scalar(0.0316473) * t9 - Scalar(0.0523608) * U_4_yy_zz + Scalar(0.096525) * t46;
  const Scalar mu_4_y = Scalar(0.0009736) * t9 + Scalar(0.0123968) * t62 +
      Scalar(0.0110896) * (t45 - t59) + Scalar(0.0523608) * Uz_o_5_x - mu_5_z -
      Scalar(0.05238) * t46;
  const Scalar t64 = t37 - t43 + t44;
  const Scalar U_3_yx = domega_3_z - t4;
  const Scalar tau_3 = Scalar(0.016137) * t6 + Scalar(0.0408384) * t11 -
      Scalar(0.026176) * (t64 - t45) + Scalar(0.0741175) * U_3_yx - c_4 * mu_4_y +
      Scalar(0.2414744) * t5 + Scalar(0.123525) * ddp_3_y + s_4 * t63 - f_u_4_t_x;
  tau[2] = tau_3;
  const Scalar t65 = s_4 * f_4_x - c_4 * t61;
  const Scalar U_3_zx = t10 + t12;
  const Scalar f_3_z = Scalar(0.123525) * U_3_zx - t65 + Scalar(7.18587) * t34;
  const Scalar U_3_yy_zz = t37 - t45;
  const Scalar mu_3_x = Scalar(0.016137) * U_3_yx - Scalar(0.026176) * U_3_zx -
      Scalar(0.0408384) * U_3_yy_zz - s_4 * mu_4_y - c_4 * t63 - Scalar(0.2414744) * t7 - t65;
  const Scalar t66 = Scalar(0.026176) * t7 + Scalar(0.016137) * (t37 - t64) +
      Scalar(0.0408384) * t5 + Scalar(0.0741175) * U_3_zx + Scalar(0.123525) * t34 - tau_4;
  const Scalar I_t2_g = Scalar(0.5095078) * c_2 - Scalar(0.1369896) * s_2;
  const Scalar I_2_xy = Scalar(0.0684948) + s_2 * I_t2_g;
  const Scalar t67 = qd_2 * (qd_2 * (Scalar(0.0444376) * s_2 + Scalar(0.1098692) * c_2) -
      t33 * I_2_xy);
  const Scalar t68 = qdd_1 * (c_2 * I_t2_g - Scalar(0.883057));
  const Scalar I_2_yz = Scalar(0.0444376) * c_2 - Scalar(0.1098692) * s_2;
  const Scalar t69 = -qdd_2 * I_2_yz - t2 * t66 + t67 + t68 - s_2_3 * mu_3_x + c_2 * f_3_z;
  tau[0] = -t69;
  const Scalar t70 = Scalar(0.123525) * t64 - f_u_4_t_x + Scalar(7.18587) * t40;
  const Scalar f_3_y = c_5 * f_5_y - s_5 * t60 + Scalar(0.123525) * U_3_yx + Scalar(0.05238) * t62 -
      Scalar(0.096525) * t9 - Scalar(1.72386) * t46 + Scalar(7.18587) * ddp_3_y;
  const Scalar t71 = c_2 * (s_2_3 * t70 + t2 * f_3_y);
  const Scalar t72 = s_2 * (Scalar(4.102542) + s_2_3 * f_3_y - t2 * t70);
  const Scalar t73 = Scalar(0.355289) * qdd_2 - qdd_1 * I_2_yz + t37 * I_2_xy - tau_3 + t71 - t72;
  tau[1] = -t73;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..5], qd[0..5], qdd[0..5], h_e[0..5]. Operations: 274 mul, 227 add, 12 sin/cos.
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
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = s_2_3 * qd_1;
  const Scalar t2 = s_2 * s_3 - c_2 * c_3;
  const Scalar t3 = t2 * qd_1;
  const Scalar t4 = t1 * t3;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar t5 = t4 + domega_3_z;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t6 = s_2_3 * qdd_1;
  const Scalar t7 = Scalar(2.0) * omega_3_z * t3 - t6;
  const Scalar t8 = s_4 * t5 + c_4 * t7;
  const Scalar omega_r_5_a_z = s_4 * t1 + c_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 - t3;
  const Scalar t9 = t8 + Scalar(2.0) * omega_r_5_a_z * omega_4_z;
  const Scalar t10 = omega_3_z * t1;
  const Scalar t11 = t2 * qdd_1;
  const Scalar t12 = t11 + t10;
  const Scalar domega_4_z = qdd_4 - t12;
  const Scalar t13 = s_4 * omega_3_z - c_4 * t1;
  const Scalar t14 = t13 * omega_r_5_a_z;
  const Scalar Uz_o_5_x = domega_4_z - t14;
  const Scalar t15 = s_5 * Uz_o_5_x - c_5 * t9;
  const Scalar omega_r_5_y = s_5 * t13 + c_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar U_5_zy = t15 + Scalar(2.0) * omega_r_5_y * omega_5_z;
  const Scalar t16 = s_4 * t7 - c_4 * t5;
  const Scalar t17 = t13 * omega_4_z;
  const Scalar t18 = t17 + t16;
  const Scalar domega_5_z = qdd_5 - t18;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t13;
  const Scalar t19 = omega_r_5_x * omega_r_5_y;
  const Scalar t20 = domega_5_z - t19;
  const Scalar t21 = s_6 * U_5_zy + c_6 * t20;
  const Scalar t22 = s_6 * t20 - c_6 * U_5_zy;
  const Scalar Uz_5_x = c_5 * Uz_o_5_x + s_5 * t9;
  const Scalar t23 = omega_r_5_x * omega_5_z;
  const Scalar domega_5_y = Uz_5_x - t23;
  const Scalar domega_6_z = qdd_6 + domega_5_y;
  const Scalar t24 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar t25 = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar t26 = t24 * t25;
  const Scalar t27 = domega_6_z - t26;
  const Scalar U_6_yx = t26 + domega_6_z;
  const Scalar t28 = Scalar(0.45) * c_2;
  const Scalar t29 = Scalar(0.9) * s_2 * qd_1 * qd_2 - qdd_1 * t28;
  const Scalar t30 = Scalar(0.45) * t7 - t29;
  const Scalar t31 = qd_2 * qd_2;
  const Scalar t32 = Scalar(0.45) * (s_2 * t31 - c_2 * qdd_2) - Scalar(9.81);
  const Scalar t33 = qd_1 * qd_1;
  const Scalar t34 = Scalar(0.45) * s_2 * qdd_2 + (t31 + t33) * t28;
  const Scalar t35 = s_2_3 * t32 - t2 * t34;
  const Scalar t36 = Scalar(0.45) * t5 + t35;
  const Scalar t37 = s_4 * t30 - c_4 * t36;
  const Scalar t38 = t1 * t1;
  const Scalar t39 = omega_3_z * omega_3_z;
  const Scalar t40 = t38 + t39;
  const Scalar ddp_3_y = s_2_3 * t34 + t2 * t32;
  const Scalar t41 = Scalar(0.45) * t40 - ddp_3_y;
  const Scalar t42 = s_5 * t41 - c_5 * t37;
  const Scalar t43 = s_4 * t36 + c_4 * t30;
  const Scalar t44 = s_6 * t43 - c_6 * t42;
  const Scalar t45 = s_6 * t42 + c_6 * t43;
  const Scalar t46 = t24 * t24;
  const Scalar t47 = omega_r_5_x * omega_r_5_x;
  const Scalar t48 = omega_5_z * omega_5_z;
  const Scalar t49 = t47 + t48;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t50 = omega_6_z * omega_6_z;
  const Scalar t51 = t49 - t46 + t50;
  const Scalar t52 = t46 + t50;
  const Scalar mu_e1_x = s_1 * h_e_5 + c_1 * h_e_4;
  const Scalar mu_e3_x = s_2_3 * h_e_6 - t2 * mu_e1_x;
  const Scalar t53 = s_1 * h_e_4 - c_1 * h_e_5;
  const Scalar t54 = s_4 * t53 - c_4 * mu_e3_x;
  const Scalar t55 = s_2_3 * mu_e1_x + t2 * h_e_6;
  const Scalar mu_6_z = Scalar(0.0007896) * t27 - Scalar(0.000256) * (t51 - t52) -
      Scalar(0.000534) * t22 + Scalar(0.000535) * U_6_yx + Scalar(0.0009944) * t21 -
      Scalar(0.0112) * t44 - Scalar(0.007) * t45 + s_5 * t54 - c_5 * t55;
  tau[5] = mu_6_z;
  const Scalar t56 = Scalar(2.0) * omega_6_z;
  const Scalar U_6_zx = t21 - t24 * t56;
  const Scalar t57 = t22 + t25 * t56;
  const Scalar U_6_yy_zz = t49 - t52;
  const Scalar t58 = s_5 * t37 + c_5 * t41;
  const Scalar t59 = s_5 * t55 + c_5 * t54;
  const Scalar t60 = s_4 * mu_e3_x + c_4 * t53;
  const Scalar t61 = Scalar(0.000256) * U_6_zx - Scalar(0.000534) * U_6_yx +
      Scalar(0.0007896) * t57 + Scalar(0.0009944) * U_6_yy_zz + Scalar(0.0112) * t58 + s_6 * t60 +
      c_6 * t59;
  const Scalar t62 = Scalar(0.000256) * t57 + Scalar(0.000535) * U_6_zx +
      Scalar(0.000534) * (t49 - t51) + Scalar(0.0009944) * t27 + Scalar(0.007) * t58 - s_6 * t59 +
      c_6 * t60;
  const Scalar U_5_yx = t19 + domega_5_z;
  const Scalar t63 = t13 * t13;
  const Scalar t64 = omega_4_z * omega_4_z;
  const Scalar Uz_o_5_y = t64 + t63;
  const Scalar t65 = Uz_o_5_y - t47 + t48;
  const Scalar mu_5_z = Scalar(0.0016163) * Uz_5_x - Scalar(0.0007639) * t15 -
      Scalar(0.0010857) * (t65 - t49) + Scalar(0.0029421) * U_5_yx - Scalar(0.0203) * t58 +
      Scalar(0.0123285) * t20 + Scalar(0.0317) * t42 + s_6 * t61 + c_6 * t62;
  tau[4] = mu_5_z;
  const Scalar U_5_zx = t23 - domega_5_y;
  const Scalar U_5_yy_zz = Uz_o_5_y - t49;
  const Scalar t66 = Scalar(0.0007639) * U_5_yx + Scalar(0.0010857) * U_5_zx -
      Scalar(0.0016163) * U_5_yy_zz + Scalar(0.0317) * t43 - Scalar(0.0123285) * U_5_zy -
      s_6 * t62 + c_6 * t61;
  const Scalar t67 = Scalar(0.0007639) * (Uz_o_5_y - t65) + Scalar(0.0016163) * t20 +
      Scalar(0.0010857) * U_5_zy - Scalar(0.0029421) * U_5_zx + Scalar(0.0203) * t43 + mu_6_z;
  const Scalar t68 = t64 - t63 + t40;
  const Scalar U_4_yx = domega_4_z + t14;
  const Scalar tau_4 = Scalar(0.0009736) * (t68 - Uz_o_5_y) + Scalar(0.0110896) * t8 +
      Scalar(0.0123968) * U_4_yx + Scalar(0.0523608) * t16 + Scalar(0.0316473) * Uz_o_5_x -
      Scalar(0.1164) * t43 - Scalar(0.2145) * t37 - s_5 * t66 + c_5 * t67;
  tau[3] = tau_4;
  const Scalar f_e1_x = s_1 * h_e_2 + c_1 * h_e_1;
  const Scalar f_e3_x = s_2_3 * h_e_3 - t2 * f_e1_x;
  const Scalar t69 = s_1 * h_e_1 - c_1 * h_e_2;
  const Scalar t70 = s_4 * t69 - c_4 * f_e3_x;
  const Scalar t71 = s_2_3 * f_e1_x + t2 * h_e_3;
  const Scalar t72 = s_5 * t71 + c_5 * t70;
  const Scalar t73 = s_4 * f_e3_x + c_4 * t69;
  const Scalar t74 = Scalar(0.007) * U_6_yx + Scalar(0.0112) * t52 - s_6 * t72 + c_6 * t73;
  const Scalar f_6_x = Scalar(0.007) * t51 - Scalar(0.0112) * t27 - s_6 * t73 - c_6 * t72;
  const Scalar t75 = Scalar(0.0203) * t65 + Scalar(0.0317) * t20 - s_6 * t74 - c_6 * f_6_x;
  const Scalar f_5_y = Scalar(0.0203) * U_5_yx - Scalar(0.007) * U_6_zx - Scalar(0.0317) * t49 -
      Scalar(0.0112) * t57 + s_5 * t70 - c_5 * t71;
  const Scalar f_4_x = Scalar(0.1164) * t68 - Scalar(0.2145) * Uz_o_5_x - s_5 * f_5_y - c_5 * t75 +
      Scalar(8.512888888888888) * t37;
  const Scalar t76 = Scalar(0.0203) * U_5_zx + Scalar(0.0317) * U_5_zy + Scalar(0.1164) * U_4_yx +
      Scalar(0.2145) * Uz_o_5_y - s_6 * f_6_x + c_6 * t74 - Scalar(8.512888888888888) * t43;
  const Scalar f_u_4_t_x = s_4 * t76 + c_4 * f_4_x;
  const Scalar t77 = t17 + t18;
  const Scalar U_4_yy_zz = t40 - Uz_o_5_y;
  const Scalar t78 = Scalar(0.0009736) * t77 + Scalar(0.0110896) * U_4_yx + Scalar(0.0316473) * t9 -
      Scalar(0.0523608) * U_4_yy_zz + Scalar(0.2145) * t41 + s_5 * t67 + c_5 * t66;
  const Scalar mu_4_y = Scalar(0.0009736) * t9 + Scalar(0.0123968) * t77 +
      Scalar(0.0110896) * (t40 - t68) + Scalar(0.0523608) * Uz_o_5_x - Scalar(0.1164) * t41 -
      mu_5_z;
  const Scalar t79 = t33 - t38 + t39;
  const Scalar U_3_yx = domega_3_z - t4;
  const Scalar tau_3 = Scalar(0.016137) * t6 + Scalar(0.0408384) * t11 -
      Scalar(0.026176) * (t79 - t40) + Scalar(0.0741175) * U_3_yx + Scalar(0.2414744) * t5 +
      Scalar(0.2745) * ddp_3_y + s_4 * t78 - c_4 * mu_4_y - Scalar(0.45) * f_u_4_t_x;
  tau[2] = tau_3;
  const Scalar t80 = s_4 * f_4_x - c_4 * t76;
  const Scalar U_3_zx = t10 + t12;
  const Scalar f_3_z = Scalar(0.2745) * U_3_zx - t80 + Scalar(35.48577777777778) * t29;
  const Scalar U_3_yy_zz = t33 - t40;
  const Scalar mu_3_x = Scalar(0.016137) * U_3_yx - Scalar(0.026176) * U_3_zx -
      Scalar(0.0408384) * U_3_yy_zz - Scalar(0.2414744) * t7 - s_4 * mu_4_y - c_4 * t78 -
      Scalar(0.45) * t80;
  const Scalar t81 = Scalar(0.026176) * t7 + Scalar(0.016137) * (t33 - t79) +
      Scalar(0.0408384) * t5 + Scalar(0.0741175) * U_3_zx + Scalar(0.2745) * t29 - tau_4;
  const Scalar I_t2_g = Scalar(0.5095078) * c_2 - Scalar(0.1369896) * s_2;
  const Scalar I_2_xy = Scalar(0.0684948) + s_2 * I_t2_g;
  const Scalar t82 = qd_2 * (Scalar(0.0444376) * s_2 + Scalar(0.1098692) * c_2) -
      Scalar(2.0) * qd_1 * I_2_xy;
  const Scalar t83 = qdd_1 * (c_2 * I_t2_g - Scalar(0.883057));
  const Scalar I_2_yz = Scalar(0.0444376) * c_2 - Scalar(0.1098692) * s_2;
  const Scalar t84 = qd_2 * t82 - qdd_2 * I_2_yz - t2 * t81 + t83 - s_2_3 * mu_3_x + t28 * f_3_z;
  tau[0] = -t84;
  const Scalar t85 = Scalar(0.2745) * t79 - f_u_4_t_x + Scalar(35.48577777777778) * t35;
  const Scalar f_3_y = Scalar(0.1164) * t77 + Scalar(0.2745) * U_3_yx - Scalar(0.2145) * t9 -
      s_5 * t75 + c_5 * f_5_y - Scalar(8.512888888888888) * t41 +
      Scalar(35.48577777777778) * ddp_3_y;
  const Scalar t86 = s_2 * (Scalar(9.11676) + s_2_3 * f_3_y - t2 * t85);
  const Scalar t87 = c_2 * (s_2_3 * t85 + t2 * f_3_y) - t86;
  const Scalar t88 = Scalar(0.355289) * qdd_2 - qdd_1 * I_2_yz + t33 * I_2_xy - tau_3 +
      Scalar(0.45) * t87;
  tau[1] = -t88;
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
// Reads q[1..5]. Operations: 106 mul, 93 add, 10 sin/cos.
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
  const Scalar hu_6_t_y = Scalar(0.00504) * c_6 - Scalar(0.00315) * s_6;
  const Scalar t4 = c_5 * hu_6_t_y;
  const Scalar f_u_6_6_a_z = Scalar(0.00315) * c_6 + Scalar(0.00504) * s_6;
  const Scalar t5 = s_4 * f_u_6_6_a_z - c_4 * t4;
  const Scalar t6 = Scalar(0.0013246) * s_5 - c_5 * Iu_6_t_xz;
  const Scalar t7 = -s_4 * t6 - c_4 * Iu_6_a_xy + t5;
  B[17] = B[32] = -t7;
  const Scalar Iu_5_a_xz = c_5 * t2 + s_5 * Ic_5_yz;
  const Scalar t8 = f_u_6_6_a_z - Scalar(0.009135);
  const Scalar hu_5_t_y = Scalar(0.014265) * c_5 - s_5 * t8;
  const Scalar t9 = mu_u_5_5_a_y - hu_5_t_y;
  const Scalar mu_5_3_z = s_4 * Iu_5_a_xz - c_4 * t9;
  B[16] = B[26] = mu_5_3_z;
  const Scalar Iu_6_t_xx = t1 - Scalar(0.0002546);
  const Scalar Iu_5_t_d = Iu_6_t_xx + Scalar(0.0088514);
  const Scalar Ic_5_xy = Iu_6_t_xz + Scalar(0.0010857);
  const Scalar t10 = Scalar(2.0) * s_5 * Ic_5_xy - c_5 * Iu_5_t_d;
  const Scalar t11 = c_5 * t10;
  const Scalar Ic_4_zz = Iu_6_t_xx + t11 + Scalar(0.0571622);
  B[21] = Ic_4_zz;
  const Scalar f_u_6_4_a_z = s_4 * t4 + c_4 * f_u_6_6_a_z;
  const Scalar mu_6_3_x = s_4 * Iu_6_a_xy - c_4 * t6 + f_u_6_4_a_z;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t12 = s_2 * s_3 - c_2 * c_3;
  B[5] = B[30] = s_2_3 * mu_6_3_x - t12 * mu_u_6_5_t_y - c_2 * f_u_6_4_a_z;
  const Scalar t13 = c_4 * hu_5_t_y;
  const Scalar t14 = c_5 * t8 + Scalar(0.014265) * s_5;
  const Scalar t15 = s_2 * (t12 * t13 + s_2_3 * t14);
  B[10] = B[25] = -t15 - c_2 * (s_2_3 * t13 - t12 * t14) + mu_5_3_z;
  const Scalar t16 = s_5 * hu_6_t_y;
  const Scalar t17 = s_2 * (s_2_3 * t16 - t12 * t5);
  B[11] = B[31] = c_2 * (s_2_3 * t5 + t12 * t16) - t7 - t17;
  const Scalar t18 = s_2_3 * (c_4 * Iu_5_a_xz + s_4 * t9);
  B[4] = B[24] = t12 * t3 - c_2 * s_4 * hu_5_t_y - t18;
  const Scalar Ic_4_xz = Ic_5_xy - s_5 * t10 - Scalar(0.0110896);
  const Scalar t19 = t3 + Scalar(0.0523608);
  const Scalar t20 = t14 + Scalar(0.05238);
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.096525);
  const Scalar t21 = s_4 * t20 - c_4 * hc_4_y;
  const Scalar t22 = (s_4 * Ic_4_xz + c_4 * t19) + t21;
  B[15] = B[20] = -t22;
  B[9] = B[19] = t21 * (s_2 * t12 + c_2 * s_2_3) - t22;
  const Scalar t23 = t11 + Scalar(0.0088514);
  const Scalar t24 = mu_u_5_5_a_y + Scalar(0.0323686);
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0009736);
  const Scalar t25 = Scalar(2.0) * s_4 * Ic_4_xy + c_4 * (t23 - t24);
  const Scalar t26 = c_4 * t25;
  const Scalar t27 = Scalar(2.0) * hu_5_t_y;
  const Scalar t28 = t23 - t26 - t27 - Scalar(2.0842173);
  B[14] = -t28;
  const Scalar f_u_4_4_a_z = c_4 * t20 + s_4 * hc_4_y;
  const Scalar mu_4_3_x = f_u_4_4_a_z - (s_4 * t19 - c_4 * Ic_4_xz);
  B[3] = B[18] = s_2_3 * mu_4_3_x - c_2 * f_u_4_4_a_z - t12 * Ic_4_zz;
  const Scalar t29 = f_u_4_4_a_z - Scalar(0.123525);
  const Scalar hc_3_y = hu_5_t_y + Scalar(1.72386);
  const Scalar t30 = c_2 * (s_2_3 * hc_3_y - t12 * t29);
  const Scalar t31 = t30 + s_2 * (s_2_3 * t29 + t12 * hc_3_y);
  B[7] = -t28 - Scalar(2.0) * t31 + Scalar(8.554441);
  B[8] = B[13] = -t31 - t28;
  const Scalar t32 = s_2_3 * (Ic_4_xy - s_4 * t25 - Scalar(0.016137)) -
      t12 * (Scalar(0.0408384) + t22);
  B[2] = B[12] = -t32;
  B[1] = B[6] = Scalar(0.0444376) * c_2 - t32 - s_2 * (t21 + Scalar(0.1098692));
  const Scalar t33 = t26 - t27 + t24;
  const Scalar Ic_3_xy = Scalar(0.026176) + mu_4_3_x;
  const Scalar t34 = t12 * (Scalar(2.0) * s_2_3 * Ic_3_xy -
      t12 * (Ic_4_zz + t33 - Scalar(1.9359823)));
  const Scalar t35 = c_2 * (Scalar(0.1369896) * s_2 + Scalar(8.4002222) * c_2);
  B[0] = -t33 - t34 - Scalar(2.0) * t30 + Scalar(2.8931568) + t35;
  B[35] = Scalar(0.0013246);
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[126] = {
    0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 0, 1, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[6]    in   joint positions, rad or m
//   c[126]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//                c_ijk = c_ikj is c[21 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads q[1..5]. Operations: 295 mul, 252 add, 10 sin/cos. Always zero: 23 of the 126 entries of c.
template <class Scalar, class SinCos = LibrarySinCos>
inline void christoffel(const Scalar* q, Scalar* c, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar Ic_6_xz = Scalar(0.000267) * c_6 + Scalar(0.0004972) * s_6;
  c[104] = Scalar(-2.0) * Ic_6_xz;
  const Scalar Iu_6_a_xy = Scalar(0.0004972) * c_6 - Scalar(0.000267) * s_6;
  const Scalar t1 = s_5 * Iu_6_a_xy;
  c[83] = Scalar(2.0) * t1;
  const Scalar I_t6_g = Scalar(0.0001273) * c_6 - Scalar(0.000256) * s_6;
  const Scalar Ic_6_xy = s_6 * I_t6_g + Scalar(0.000128);
  const Scalar dI_6_yy = Scalar(2.0) * Ic_6_xy;
  c[103] = dI_6_yy;
  c[119] = Scalar(-2.0) * Ic_6_xy;
  const Scalar t2 = s_4 * c_5;
  const Scalar t3 = Iu_6_a_xy * t2 + c_4 * Ic_6_xz;
  const Scalar mr_6_y = Scalar(0.00252) * c_6 - Scalar(0.001575) * s_6;
  const Scalar f_u_6_6_a_z = Scalar(0.001575) * c_6 + Scalar(0.00252) * s_6;
  const Scalar t4 = c_4 * c_5;
  const Scalar t5 = s_4 * mr_6_y + f_u_6_6_a_z * t4;
  const Scalar t6 = t3 + t5;
  c[62] = Scalar(-2.0) * t6;
  const Scalar s_2_3 = c_2 * s_3 + s_2 * c_3;
  const Scalar t7 = c_2 * c_3 - s_2 * s_3;
  const Scalar t8 = s_2_3 * t4 + s_5 * t7;
  const Scalar t9 = s_4 * s_2_3;
  const Scalar v_1_4_a_y = c_2 - s_2_3;
  const Scalar t10 = c_4 * mr_6_y - f_u_6_6_a_z * t2;
  const Scalar t11 = v_1_4_a_y * t10;
  const Scalar t12 = Ic_6_xz * t9 - Iu_6_a_xy * t8 + t11;
  c[20] = Scalar(-2.0) * t12;
  const Scalar t13 = Ic_6_xy + Scalar(0.00038195);
  const Scalar Ic_5_yz = Iu_6_a_xy + Scalar(0.00080815);
  const Scalar Iu_5_a_xz = c_5 * t13 + s_5 * Ic_5_yz;
  c[77] = Scalar(-2.0) * Iu_5_a_xz;
  const Scalar t14 = c_4 * s_5;
  const Scalar t15 = c_5 * t7 - s_2_3 * t14;
  const Scalar t16 = Ic_6_xz * t15;
  const Scalar t17 = s_4 * s_5;
  const Scalar t18 = mr_6_y * v_1_4_a_y * t17;
  const Scalar t19 = Scalar(0.0006623) * t8 - t16 - t18;
  const Scalar t20 = c_6 * I_t6_g;
  const Scalar Ic_6_xx = t20 - Scalar(0.0001273);
  const Scalar dI_6_xy = t20 + Ic_6_xx;
  const Scalar db_15_6r = t9 * dI_6_yy - t16 - t8 * dI_6_xy + t18;
  const Scalar c_5_1_6 = t19 + db_15_6r;
  c[99] = c_5_1_6;
  const Scalar t21 = c_5 * Ic_6_xz;
  const Scalar dmu_4_6_y = s_5 * dI_6_xy + t21;
  const Scalar t22 = Scalar(0.0006623) * s_5 - t21;
  const Scalar c_5_4_6 = t22 - dmu_4_6_y;
  c[102] = c_5_4_6;
  const Scalar Iu_5_t_d = Ic_6_xx + Scalar(0.0044257);
  const Scalar Ic_5_xy = Ic_6_xz + Scalar(0.00054285);
  const Scalar t23 = Scalar(2.0) * Ic_5_xy;
  const Scalar t24 = c_5 * Iu_5_t_d - s_5 * t23;
  const Scalar t25 = s_5 * t24;
  const Scalar dmu_4_5_y = c_5 * t23 + s_5 * Iu_5_t_d;
  const Scalar db_44_5r = t25 + c_5 * dmu_4_5_y;
  c[76] = db_44_5r;
  const Scalar t26 = c_5 * Iu_6_a_xy;
  const Scalar t27 = t26 - s_5 * dI_6_yy;
  const Scalar db_44_6r = s_5 * (t26 + t27);
  c[81] = db_44_6r;
  const Scalar t28 = f_u_6_6_a_z - Scalar(0.0045675);
  const Scalar t29 = c_5 * t28 + Scalar(0.0071325) * s_5;
  const Scalar t30 = s_4 * t29;
  const Scalar t31 = v_1_4_a_y * t30;
  const Scalar t32 = t13 * t15 + Ic_5_yz * t8 - t31;
  c[14] = Scalar(-2.0) * t32;
  c[19] = db_15_6r - t19;
  c[115] = -c_5_1_6;
  c[82] = -dmu_4_6_y - t22;
  c[118] = -c_5_4_6;
  c[93] = -db_44_5r;
  c[114] = -db_44_6r;
  const Scalar t33 = c_5 * Ic_5_yz - s_5 * t13;
  const Scalar t34 = s_4 * t33;
  const Scalar t35 = t34 - c_4 * t29;
  c[56] = Scalar(2.0) * t35;
  const Scalar t36 = Iu_5_a_xz * t9;
  const Scalar hu_5_t_y = Scalar(0.0071325) * c_5 - s_5 * t28;
  const Scalar t37 = c_4 * v_1_4_a_y;
  const Scalar t38 = hu_5_t_y * t37;
  const Scalar mu_u_5_5_a_y = t20 - Scalar(0.0080301);
  const Scalar t39 = c_4 * s_2_3 * mu_u_5_5_a_y - t36 + t38;
  const Scalar t40 = t36 - t24 * t8 - t15 * dmu_4_5_y + t38;
  const Scalar c_4_1_5 = t39 - t40;
  c[73] = c_4_1_5;
  const Scalar t41 = mr_6_y * t4 - s_4 * f_u_6_6_a_z;
  const Scalar t42 = v_1_4_a_y * t41;
  const Scalar t43 = t9 * dmu_4_6_y - t8 * t27 - t15 * t1 + t42;
  const Scalar t44 = t42 - s_2_3 * (c_4 * Iu_6_a_xy + s_4 * t22);
  const Scalar c_4_1_6 = t44 - t43;
  c[78] = c_4_1_6;
  const Scalar t45 = t37 * (Scalar(0.0071325) * t15 - t28 * t8);
  const Scalar dmu_1_5_x = -Ic_5_yz * t9 - t23 * t8 + t28 * t37 + Iu_5_t_d * t15;
  const Scalar t46 = t13 * t9 - t23 * t15 - Iu_5_t_d * t8 + Scalar(0.0071325) * t37;
  const Scalar c_5_1_1 = t45 - t8 * dmu_1_5_x + t15 * t46 - t9 * (t31 - t32);
  c[84] = c_5_1_1;
  const Scalar t47 = s_5 * v_1_4_a_y;
  const Scalar t48 = s_4 * (f_u_6_6_a_z * t47 - s_2_3 * dI_6_xy);
  const Scalar t49 = t8 * (Iu_6_a_xy * t15 - t8 * dI_6_yy + t48);
  const Scalar t50 = s_4 * (s_2_3 * db_15_6r + (f_u_6_6_a_z * t8 + mr_6_y * t9) * t47);
  const Scalar db_11_6r = t49 + t50 - t15 * (t11 + t12);
  c[15] = db_11_6r;
  c[13] = -t39 - t40;
  c[90] = -c_4_1_5;
  c[18] = -t44 - t43;
  c[111] = -c_4_1_6;
  const Scalar v_2_3_x = c_2 * s_2_3 - s_2 * t7;
  const Scalar v_o_2_4_x = v_2_3_x - Scalar(1.0);
  const Scalar v_2_3_y = c_2 * t7 + s_2 * s_2_3;
  const Scalar t51 = c_5 * v_2_3_y - v_o_2_4_x * t14;
  const Scalar t52 = mr_6_y * t51;
  const Scalar t53 = s_5 * Ic_6_xz;
  const Scalar mu_u_6_5_t_y = Scalar(0.0006623) * c_5 + t53;
  const Scalar t54 = s_4 * mu_u_6_5_t_y;
  const Scalar t55 = t52 - t54;
  const Scalar t56 = c_4 * dI_6_yy - s_4 * (t53 - c_5 * dI_6_xy);
  const Scalar t57 = t52 - t56;
  const Scalar c_5_2_6 = t55 - t57;
  c[100] = c_5_2_6;
  const Scalar t58 = c_4 * dmu_4_6_y + t2 * t27;
  const Scalar t59 = c_4 * f_u_6_6_a_z;
  const Scalar f_u_6_4_a_z = t59 + mr_6_y * t2;
  const Scalar t60 = t58 - t17 * t1 + f_u_6_4_a_z;
  const Scalar t61 = s_4 * Iu_6_a_xy;
  const Scalar t62 = c_4 * t22 - t61;
  const Scalar t63 = t62 - f_u_6_4_a_z;
  c[60] = t63 - t60;
  const Scalar c_6_3_4 = t63 + t60;
  c[113] = c_6_3_4;
  const Scalar t64 = mr_6_y * t14;
  const Scalar dmu_3_6_y = t64 - t56;
  const Scalar db_36_5 = t54 - t64;
  c[61] = db_36_5 - dmu_3_6_y;
  const Scalar c_6_3_5 = db_36_5 + dmu_3_6_y;
  c[117] = c_6_3_5;
  const Scalar t65 = t29 + Scalar(0.02619);
  const Scalar hc_4_y = mr_6_y + Scalar(0.0482625);
  const Scalar f_u_4_4_a_z = c_4 * t65 + s_4 * hc_4_y;
  const Scalar df_2_3_x = f_u_4_4_a_z - Scalar(0.0617625);
  const Scalar hc_3_y = hu_5_t_y + Scalar(0.86193);
  const Scalar t66 = df_2_3_x * v_2_3_x - hc_3_y * v_2_3_y;
  c[44] = Scalar(-2.0) * t66;
  c[25] = c[26] = Scalar(2.0) * t66;
  c[10] = -c_5_1_1;
  const Scalar v_2_5_x = s_5 * v_2_3_y + v_o_2_4_x * t4;
  const Scalar t67 = Scalar(0.0071325) * t51 - t28 * v_2_5_x;
  const Scalar t68 = t67 - t34;
  c[35] = Scalar(-2.0) * t68;
  const Scalar t69 = s_4 * v_o_2_4_x;
  const Scalar t70 = f_u_6_6_a_z * v_2_5_x + mr_6_y * t69;
  const Scalar t71 = t3 - t70;
  c[41] = Scalar(-2.0) * t71;
  c[105] = -db_11_6r;
  c[40] = -t55 - t57;
  c[116] = -c_5_2_6;
  c[80] = -c_6_3_4;
  c[101] = -c_6_3_5;
  const Scalar t72 = c_5 * t24;
  const Scalar t73 = mu_u_5_5_a_y + Scalar(0.0161843);
  const Scalar Iu_4_t_d = t72 - Scalar(0.0044257) + t73;
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0004868);
  const Scalar t74 = Scalar(2.0) * Ic_4_xy;
  const Scalar t75 = c_4 * Iu_4_t_d - s_4 * t74;
  const Scalar t76 = s_4 * t75;
  const Scalar t77 = c_4 * t74 + s_4 * Iu_4_t_d;
  const Scalar db_33_4r = t76 + c_4 * t77;
  c[49] = c[50] = db_33_4r;
  const Scalar t78 = c_4 * dI_6_xy - t2 * dI_6_yy;
  const Scalar t79 = t78 - s_5 * (t61 - t59);
  const Scalar t80 = c_4 * dmu_3_6_y - s_4 * (c_5 * t79 - s_5 * t6);
  const Scalar c_6_3_3 = t80 + s_5 * (c_4 * t10 + s_4 * t5);
  c[110] = c_6_3_3;
  const Scalar Ic_4_xz = Ic_5_xy + t25 - Scalar(0.0055448);
  const Scalar t81 = t33 - Scalar(0.0261804);
  const Scalar t82 = c_4 * Ic_4_xz + s_4 * t81;
  const Scalar t83 = t82 - f_u_4_4_a_z * v_o_2_4_x;
  c[30] = Scalar(-2.0) * t83;
  const Scalar mu_4_3_x = t82 + f_u_4_4_a_z;
  c[51] = Scalar(-2.0) * mu_4_3_x;
  const Scalar t84 = c_4 * Iu_5_a_xz;
  const Scalar t85 = t84 + s_4 * mu_u_5_5_a_y;
  const Scalar t86 = s_4 * hu_5_t_y;
  const Scalar db_35_4 = t85 - t86;
  const Scalar t87 = s_2_3 * t33 + t7 * db_35_4;
  const Scalar t88 = c_4 * Ic_5_yz - s_4 * dmu_4_5_y;
  const Scalar t89 = t88 - s_4 * t28;
  const Scalar t90 = c_4 * t13 + s_4 * t24;
  const Scalar t91 = t90 + Scalar(0.0071325) * s_4;
  const Scalar t92 = t35 * t9 - t8 * t89 - t15 * t91;
  const Scalar c_3_1_5 = t87 + t92;
  c[52] = c_3_1_5;
  const Scalar t93 = t9 * dmu_3_6_y + t8 * t79 + t15 * t6;
  const Scalar t94 = s_2_3 * mu_u_6_5_t_y + t7 * t63;
  const Scalar c_3_1_6 = t94 - t93;
  c[57] = c_3_1_6;
  const Scalar t95 = t84 + s_4 * (t72 - s_5 * dmu_4_5_y);
  const Scalar t96 = hu_5_t_y * t69;
  const Scalar t97 = t96 - t95;
  const Scalar db_25_4 = t85 + t96;
  c[34] = db_25_4 + t97;
  const Scalar c_5_2_4 = db_25_4 - t97;
  c[91] = c_5_2_4;
  const Scalar t98 = f_u_6_6_a_z * t51 - Iu_6_a_xy * t17;
  const Scalar t99 = t58 - c_5 * t70 + s_5 * t98;
  const Scalar t100 = t62 + v_o_2_4_x * f_u_6_4_a_z;
  c[39] = t100 - t99;
  const Scalar c_6_2_4 = t100 + t99;
  c[112] = c_6_2_4;
  const Scalar t101 = t95 + t86;
  c[55] = db_35_4 - t101;
  const Scalar c_5_3_4 = db_35_4 + t101;
  c[92] = c_5_3_4;
  const Scalar t102 = t77 - hc_4_y * v_2_3_y;
  const Scalar t103 = t75 + t65 * v_2_3_y;
  const Scalar t104 = c_4 * hc_4_y - s_4 * t65;
  const Scalar t105 = t104 * v_2_3_y;
  const Scalar c_4_2_2 = t105 - c_4 * t102 - s_4 * t103;
  c[65] = c_4_2_2;
  c[67] = c[68] = -db_33_4r;
  const Scalar t106 = t88 + t28 * t69;
  const Scalar t107 = Scalar(0.0071325) * t69 - t90;
  const Scalar t108 = t30 * t69 - c_4 * t67;
  const Scalar c_2_2_5 = t108 - c_4 * t68 + s_4 * (c_5 * t106 + s_5 * t107);
  c[32] = c_2_2_5;
  c[59] = -c_6_3_3;
  const Scalar t109 = c_4 * t81 - s_4 * Ic_4_xz;
  const Scalar t110 = t104 * v_1_4_a_y;
  const Scalar t111 = t110 - s_2_3 * t109;
  c[9] = Scalar(-2.0) * t111;
  const Scalar t112 = t87 - s_2 * t86;
  const Scalar t113 = t68 * t9 + t8 * t106 - t15 * t107;
  const Scalar c_2_1_5 = t112 - t113;
  c[31] = c_2_1_5;
  const Scalar t114 = t78 + t98;
  const Scalar t115 = t9 * t57 + t8 * t114 + t15 * t71;
  const Scalar t116 = t94 - s_2 * f_u_6_4_a_z;
  const Scalar c_2_1_6 = t116 - t115;
  c[36] = c_2_1_6;
  c[12] = t92 - t87;
  c[87] = -c_3_1_5;
  c[17] = -t94 - t93;
  c[108] = -c_3_1_6;
  const Scalar t117 = t51 * t10 - t70 * t17;
  const Scalar t118 = t117 + t80;
  const Scalar db_26_3 = s_5 * mr_6_y * v_2_3_x - v_2_3_y * t41;
  c[38] = db_26_3 - t118;
  const Scalar c_6_2_3 = db_26_3 + t118;
  c[109] = c_6_2_3;
  c[74] = -c_5_2_4;
  c[79] = -c_6_2_4;
  c[75] = -c_5_3_4;
  c[28] = -c_4_2_2;
  c[86] = -c_2_2_5;
  const Scalar t119 = c_4 * t35 + s_4 * (c_5 * t89 - s_5 * t91);
  const Scalar c_5_3_3 = t29 - t119;
  c[89] = c_5_3_3;
  const Scalar c_6_2_2 = t117 + c_4 * t57 - s_4 * (c_5 * t114 - s_5 * t71);
  c[107] = c_6_2_2;
  c[11] = -t112 - t113;
  c[85] = -c_2_1_5;
  c[16] = -t116 - t115;
  c[106] = -c_2_1_6;
  c[58] = -c_6_2_3;
  c[54] = -c_5_3_3;
  c[37] = -c_6_2_2;
  const Scalar t120 = t7 * (Ic_4_xy + t76 - Scalar(0.0080685)) +
      s_2_3 * (t109 - Scalar(0.0204192) + t104);
  c[4] = c[5] = Scalar(-2.0) * t120;
  const Scalar t121 = c_4 * t75;
  const Scalar t122 = t7 * mu_4_3_x;
  const Scalar t123 = s_2_3 * (t121 - s_4 * t77) + t122;
  const Scalar Ic_4_zz = Ic_6_xx - t72 + Scalar(0.0285811);
  const Scalar t124 = t122 - s_2_3 * Ic_4_zz;
  c[8] = t124 - t123;
  const Scalar c_4_1_3 = t123 + t124;
  c[66] = c_4_1_3;
  c[29] = -t105 - (t105 - db_33_4r);
  const Scalar t125 = t108 + t119;
  const Scalar t126 = t29 * v_2_3_x - c_4 * hu_5_t_y * v_2_3_y;
  c[33] = t126 + t125;
  const Scalar c_5_2_3 = t126 - t125;
  c[88] = c_5_2_3;
  const Scalar t127 = c_4 * (t7 * t81 - s_2_3 * t77);
  const Scalar t128 = s_2_3 * (t127 - s_4 * (t7 * Ic_4_xz + s_2_3 * t75));
  const Scalar c_4_1_1 = t7 * (t110 + t111) - t128;
  c[63] = c_4_1_1;
  const Scalar Iu_2_a_xz = Scalar(0.0222188) * s_2 + t120 - c_2 * (t104 - Scalar(0.0549346));
  c[2] = Scalar(-2.0) * Iu_2_a_xz;
  const Scalar t129 = s_2_3 * (c_4 * t103 - s_4 * t102) + t7 * t83;
  const Scalar t130 = s_2 * f_u_4_4_a_z + t124;
  c[7] = t130 - t129;
  const Scalar c_4_1_2 = t130 + t129;
  c[64] = c_4_1_2;
  c[48] = -c_4_1_3;
  c[53] = -c_5_2_3;
  c[6] = -c_4_1_1;
  c[27] = -c_4_1_2;
  const Scalar Ic_3_xy = Scalar(0.013088) + mu_4_3_x;
  const Scalar t131 = Scalar(2.0) * Ic_3_xy;
  const Scalar Iu_3_t_d = Scalar(2.0) * hu_5_t_y + t121 - t73 - Ic_4_zz + Scalar(0.96799115);
  const Scalar t132 = t7 * Iu_3_t_d - s_2_3 * t131;
  const Scalar t133 = c_2 * (t7 * hc_3_y - s_2_3 * df_2_3_x);
  const Scalar t134 = Scalar(0.0684948) * s_2 - t7 * df_2_3_x - s_2_3 * hc_3_y +
      Scalar(4.2001111) * c_2;
  const Scalar Ic_2_xy = Ic_3_xy + Scalar(0.0342474) + s_2_3 * t132 - t133 - s_2 * t134;
  c[1] = Scalar(2.0) * Ic_2_xy;
  c[21] = Scalar(-2.0) * Ic_2_xy;
  const Scalar t135 = t7 * (c_2 * hc_3_y - t7 * t131 - s_2_3 * Iu_3_t_d);
  const Scalar c_3_1_1 = t133 - s_2_3 * (c_2 * df_2_3_x + t132) + t135;
  c[42] = c_3_1_1;
  c[3] = -c_3_1_1;
  c[0] = c[22] = c[23] = c[24] = c[43] = c[45] = c[46] = c[47] = Scalar(0.0);
  c[69] = c[70] = c[71] = c[72] = c[94] = c[95] = c[96] = c[97] = Scalar(0.0);
  c[98] = c[120] = c[121] = c[122] = c[123] = c[124] = c[125] = Scalar(0.0);
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
// Reads q[1..5], qd[0..5]. Operations: 423 mul, 372 add, 10 sin/cos. Always zero: 1 of the 36
// entries of C.
template <class Scalar, class SinCos = LibrarySinCos>
inline void coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar I_t6_g = Scalar(0.0001273) * c_6 - Scalar(0.000256) * s_6;
  const Scalar Ic_6_xy = s_6 * I_t6_g + Scalar(0.000128);
  const Scalar t1 = Scalar(2.0) * Ic_6_xy;
  C[28] = qd_6 * t1;
  const Scalar Iu_6_a_xy = Scalar(0.0004972) * c_6 - Scalar(0.000267) * s_6;
  const Scalar t2 = c_5 * Iu_6_a_xy;
  const Scalar t3 = s_5 * t1 - t2;
  const Scalar t4 = s_5 * (t2 - t3);
  const Scalar t5 = c_6 * I_t6_g;
  const Scalar Ic_6_xx = t5 - Scalar(0.0001273);
  const Scalar Iu_5_t_d = Ic_6_xx + Scalar(0.0044257);
  const Scalar Ic_6_xz = Scalar(0.000267) * c_6 + Scalar(0.0004972) * s_6;
  const Scalar Ic_5_xy = Ic_6_xz + Scalar(0.00054285);
  const Scalar t6 = Scalar(2.0) * Ic_5_xy;
  const Scalar t7 = s_5 * t6 - c_5 * Iu_5_t_d;
  const Scalar t8 = s_5 * t7;
  const Scalar dmu_4_5_y = c_5 * t6 + s_5 * Iu_5_t_d;
  const Scalar t9 = t8 - c_5 * dmu_4_5_y;
  C[21] = qd_6 * t4 - qd_5 * t9;
  const Scalar dI_6_xy = t5 + Ic_6_xx;
  const Scalar t10 = s_5 * Ic_6_xz;
  const Scalar t11 = s_4 * (t10 - c_5 * dI_6_xy) - c_4 * t1;
  const Scalar mr_6_y = Scalar(0.00252) * c_6 - Scalar(0.001575) * s_6;
  const Scalar t12 = c_4 * s_5;
  const Scalar t13 = mr_6_y * t12;
  const Scalar dmu_3_6_y = t11 + t13;
  const Scalar mu_u_6_5_t_y = Scalar(0.0006623) * c_5 + t10;
  const Scalar t14 = s_4 * mu_u_6_5_t_y;
  const Scalar db_36_5 = t14 - t13;
  const Scalar c_6_3_5 = db_36_5 + dmu_3_6_y;
  const Scalar t15 = s_2 * s_3 - c_2 * c_3;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar v_2_3_x = s_2 * t15 + c_2 * s_2_3;
  const Scalar v_o_2_4_x = v_2_3_x - Scalar(1.0);
  const Scalar v_2_3_y = s_2 * s_2_3 - c_2 * t15;
  const Scalar t16 = v_o_2_4_x * t12 - c_5 * v_2_3_y;
  const Scalar t17 = mr_6_y * t16;
  const Scalar t18 = t14 + t17;
  const Scalar t19 = t17 - t11;
  const Scalar t20 = t18 - t19;
  const Scalar t21 = c_5 * Ic_6_xz;
  const Scalar dmu_4_6_y = s_5 * dI_6_xy + t21;
  const Scalar t22 = Scalar(0.0006623) * s_5 - t21;
  const Scalar c_5_4_6 = t22 - dmu_4_6_y;
  const Scalar t23 = s_2_3 * t12 + c_5 * t15;
  const Scalar t24 = Ic_6_xz * t23;
  const Scalar t25 = c_4 * c_5;
  const Scalar t26 = s_5 * t15 - s_2_3 * t25;
  const Scalar v_1_4_a_y = c_2 - s_2_3;
  const Scalar t27 = s_4 * s_5;
  const Scalar t28 = mr_6_y * v_1_4_a_y * t27;
  const Scalar t29 = Scalar(0.0006623) * t26 - t24 + t28;
  const Scalar t30 = s_4 * s_2_3;
  const Scalar db_15_6r = t24 + t26 * dI_6_xy + t30 * t1 + t28;
  const Scalar t31 = t29 - db_15_6r;
  const Scalar C_65 = -qd_4 * c_5_4_6 - qd_5 * t1 + qd_3 * c_6_3_5 + qd_2 * t20 + qd_1 * t31;
  C[34] = C_65;
  const Scalar t32 = Scalar(2.0) * qd_6;
  C[29] = -Ic_6_xz * t32 - C_65;
  const Scalar t33 = Ic_6_xy + Scalar(0.00038195);
  const Scalar Ic_5_yz = Iu_6_a_xy + Scalar(0.00080815);
  const Scalar Iu_5_a_xz = c_5 * t33 + s_5 * Ic_5_yz;
  const Scalar t34 = c_4 * Iu_5_a_xz;
  const Scalar mu_u_5_5_a_y = t5 - Scalar(0.0080301);
  const Scalar t35 = t34 + s_4 * mu_u_5_5_a_y;
  const Scalar f_u_6_6_a_z = Scalar(0.001575) * c_6 + Scalar(0.00252) * s_6;
  const Scalar t36 = f_u_6_6_a_z - Scalar(0.0045675);
  const Scalar hu_5_t_y = Scalar(0.0071325) * c_5 - s_5 * t36;
  const Scalar t37 = s_4 * hu_5_t_y;
  const Scalar db_35_4 = t35 - t37;
  const Scalar t38 = s_5 * t33 - c_5 * Ic_5_yz;
  const Scalar t39 = s_2_3 * t38 + t15 * db_35_4;
  const Scalar t40 = s_2 * t37 + t39;
  const Scalar v_2_5_x = s_5 * v_2_3_y + v_o_2_4_x * t25;
  const Scalar t41 = t36 * v_2_5_x + Scalar(0.0071325) * t16;
  const Scalar t42 = s_4 * t38;
  const Scalar t43 = t41 - t42;
  const Scalar t44 = s_4 * t7 - c_4 * t33;
  const Scalar t45 = s_4 * v_o_2_4_x;
  const Scalar t46 = t44 + Scalar(0.0071325) * t45;
  const Scalar t47 = s_4 * dmu_4_5_y - c_4 * Ic_5_yz;
  const Scalar t48 = t47 - t36 * t45;
  const Scalar t49 = t23 * t46 + t26 * t48 - t43 * t30;
  const Scalar t50 = t40 - t49;
  const Scalar t51 = Scalar(0.0071325) * s_4 - t44;
  const Scalar t52 = t47 + s_4 * t36;
  const Scalar t53 = c_5 * t36 + Scalar(0.0071325) * s_5;
  const Scalar t54 = t42 + c_4 * t53;
  const Scalar t55 = t23 * t51 - t26 * t52 - t54 * t30;
  const Scalar t56 = t39 + t55;
  const Scalar t57 = s_4 * t53;
  const Scalar t58 = v_1_4_a_y * t57;
  const Scalar t59 = t33 * t23 + Ic_5_yz * t26 + t58;
  const Scalar t60 = c_4 * v_1_4_a_y;
  const Scalar t61 = t33 * t30 + t6 * t23 + Iu_5_t_d * t26 + Scalar(0.0071325) * t60;
  const Scalar dmu_1_5_x = t6 * t26 - Ic_5_yz * t30 - Iu_5_t_d * t23 + t36 * t60;
  const Scalar t62 = t60 * (Scalar(0.0071325) * t23 - t36 * t26);
  const Scalar t63 = t30 * (t58 + t59) + t23 * t61 - t26 * dmu_1_5_x + t62;
  const Scalar t64 = qd_1 * t63;
  const Scalar t65 = Iu_5_a_xz * t30;
  const Scalar t66 = hu_5_t_y * t60;
  const Scalar t67 = t65 - c_4 * s_2_3 * mu_u_5_5_a_y - t66;
  const Scalar t68 = t65 + t23 * dmu_4_5_y - t7 * t26 + t66;
  const Scalar t69 = t67 - t68;
  const Scalar t70 = t29 + db_15_6r;
  const Scalar t71 = Scalar(2.0) * qd_5;
  C[4] = qd_6 * t70 + t59 * t71 + qd_4 * t69 + qd_3 * t56 + qd_2 * t50 + t64;
  const Scalar t72 = mr_6_y * t45 + f_u_6_6_a_z * v_2_5_x;
  const Scalar t73 = s_4 * c_5;
  const Scalar t74 = Iu_6_a_xy * t73 + c_4 * Ic_6_xz;
  const Scalar t75 = t74 - t72;
  const Scalar t76 = Iu_6_a_xy * t27 + f_u_6_6_a_z * t16;
  const Scalar t77 = t73 * t1 - c_4 * dI_6_xy;
  const Scalar t78 = t77 + t76;
  const Scalar t79 = t30 * t19 - t26 * t78 + t23 * t75;
  const Scalar t80 = s_4 * Iu_6_a_xy;
  const Scalar t81 = t80 - c_4 * t22;
  const Scalar t82 = c_4 * f_u_6_6_a_z;
  const Scalar f_u_6_4_a_z = mr_6_y * t73 + t82;
  const Scalar t83 = t81 + f_u_6_4_a_z;
  const Scalar t84 = s_2_3 * mu_u_6_5_t_y + t15 * t83;
  const Scalar t85 = t84 - s_2 * f_u_6_4_a_z;
  const Scalar t86 = t85 - t79;
  const Scalar t87 = t77 + s_5 * (t80 - t82);
  const Scalar t88 = f_u_6_6_a_z * t25 + s_4 * mr_6_y;
  const Scalar t89 = t74 + t88;
  const Scalar t90 = -t26 * t87 - t30 * dmu_3_6_y + t23 * t89;
  const Scalar t91 = t84 - t90;
  const Scalar t92 = s_5 * v_1_4_a_y;
  const Scalar t93 = s_4 * (s_2_3 * db_15_6r + (mr_6_y * t30 - f_u_6_6_a_z * t26) * t92);
  const Scalar t94 = s_4 * (s_2_3 * dI_6_xy - f_u_6_6_a_z * t92);
  const Scalar t95 = t26 * (Iu_6_a_xy * t23 - t26 * t1 + t94);
  const Scalar t96 = f_u_6_6_a_z * t73 - c_4 * mr_6_y;
  const Scalar t97 = v_1_4_a_y * t96;
  const Scalar t98 = -Iu_6_a_xy * t26 - Ic_6_xz * t30 + t97;
  const Scalar db_11_6r = t93 + t95 - t23 * (t97 + t98);
  const Scalar t99 = qd_1 * db_11_6r;
  const Scalar t100 = s_5 * Iu_6_a_xy;
  const Scalar t101 = s_4 * f_u_6_6_a_z - mr_6_y * t25;
  const Scalar t102 = v_1_4_a_y * t101;
  const Scalar t103 = t26 * t3 - t23 * t100 - t30 * dmu_4_6_y + t102;
  const Scalar t104 = s_2_3 * (s_4 * t22 + c_4 * Iu_6_a_xy) + t102;
  const Scalar t105 = t104 + t103;
  C[5] = qd_5 * t70 + qd_4 * t105 - qd_3 * t91 + t99 + t98 * t32 - qd_2 * t86;
  const Scalar t106 = t73 * t3 - c_4 * dmu_4_6_y;
  const Scalar t107 = t106 + s_5 * t76 + c_5 * t72;
  const Scalar t108 = t81 - v_o_2_4_x * f_u_6_4_a_z;
  const Scalar t109 = t108 + t107;
  const Scalar t110 = -t27 * t100 - t106 + f_u_6_4_a_z;
  const Scalar t111 = t83 - t110;
  const Scalar t112 = t104 - t103;
  const Scalar t113 = qd_4 * t4 - qd_1 * t112 + qd_3 * t111 + qd_2 * t109;
  const Scalar t114 = dmu_4_6_y + t22;
  C[23] = t100 * t32 - qd_5 * t114 + t113;
  const Scalar t115 = c_5 * t7;
  const Scalar t116 = t34 - s_4 * (t115 + s_5 * dmu_4_5_y);
  const Scalar t117 = hu_5_t_y * t45;
  const Scalar t118 = t117 - t116;
  const Scalar db_25_4 = t35 + t117;
  const Scalar c_5_2_4 = db_25_4 - t118;
  const Scalar t119 = t116 + t37;
  const Scalar c_5_3_4 = db_35_4 + t119;
  const Scalar t120 = t67 + t68;
  const Scalar t121 = qd_4 * t9 + qd_2 * c_5_2_4 + qd_1 * t120 + qd_3 * c_5_3_4;
  C[27] = qd_6 * c_5_4_6 + t121;
  const Scalar t122 = t72 * t27 - t16 * t96;
  const Scalar t123 = t122 - s_4 * (s_5 * t75 + c_5 * t78) + c_4 * t19;
  const Scalar t124 = t57 * t45 + c_4 * t41;
  const Scalar t125 = t124 + s_4 * (s_5 * t46 - c_5 * t48) + c_4 * t43;
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0004868);
  const Scalar t126 = Scalar(2.0) * Ic_4_xy;
  const Scalar t127 = mu_u_5_5_a_y + Scalar(0.0161843);
  const Scalar Iu_4_t_d = -t115 - Scalar(0.0044257) + t127;
  const Scalar t128 = s_4 * t126 - c_4 * Iu_4_t_d;
  const Scalar t129 = t53 + Scalar(0.02619);
  const Scalar t130 = t128 - t129 * v_2_3_y;
  const Scalar t131 = c_4 * t126 + s_4 * Iu_4_t_d;
  const Scalar hc_4_y = mr_6_y + Scalar(0.0482625);
  const Scalar t132 = t131 - hc_4_y * v_2_3_y;
  const Scalar t133 = s_4 * t129 - c_4 * hc_4_y;
  const Scalar t134 = t133 * v_2_3_y;
  const Scalar c_4_2_2 = s_4 * t130 - c_4 * t132 - t134;
  const Scalar f_u_4_4_a_z = c_4 * t129 + s_4 * hc_4_y;
  const Scalar df_2_3_x = f_u_4_4_a_z - Scalar(0.0617625);
  const Scalar hc_3_y = hu_5_t_y + Scalar(0.86193);
  const Scalar t135 = Scalar(-2.0) * (hc_3_y * v_2_3_y - df_2_3_x * v_2_3_x);
  C[7] = qd_6 * t123 + qd_5 * t125 - qd_4 * c_4_2_2 + qd_3 * t135;
  C[22] = -qd_6 * t114 - Iu_5_a_xz * t71 - t121;
  const Scalar t136 = t40 + t49;
  const Scalar t137 = t39 - t55;
  const Scalar t138 = qd_6 * t31 + t64 - qd_4 * t120 - qd_3 * t137 - qd_2 * t136;
  C[24] = -t138;
  const Scalar t139 = t85 + t79;
  const Scalar t140 = t84 + t90;
  const Scalar t141 = t99 - qd_5 * t31 - qd_4 * t112 + qd_3 * t140 + qd_2 * t139;
  C[30] = -t141;
  const Scalar t142 = c_4 * dmu_3_6_y + s_4 * (c_5 * t87 + s_5 * t89);
  const Scalar t143 = t122 - t142;
  const Scalar db_26_3 = v_2_3_y * t101 + s_5 * mr_6_y * v_2_3_x;
  const Scalar c_6_2_3 = db_26_3 - t143;
  const Scalar c_6_3_3 = t142 + s_5 * (s_4 * t88 - c_4 * t96);
  const Scalar t144 = qd_3 * c_6_3_3 - qd_1 * t140 + qd_2 * c_6_2_3;
  C[32] = qd_5 * c_6_3_5 - qd_4 * t111 + t144;
  C[33] = -qd_5 * c_5_4_6 - t113;
  const Scalar t145 = s_4 * (s_5 * t51 + c_5 * t52) + c_4 * t54;
  const Scalar t146 = t124 - t145;
  const Scalar t147 = c_4 * hu_5_t_y * v_2_3_y - t53 * v_2_3_x;
  const Scalar t148 = t147 - t146;
  const Scalar t149 = s_4 * t128;
  const Scalar t150 = t149 - c_4 * t131;
  const Scalar t151 = t134 + (t134 - t150);
  const Scalar c_2_3_6 = db_26_3 + t143;
  const Scalar t152 = qd_2 + qd_3;
  C[8] = qd_6 * c_2_3_6 - qd_5 * t148 + qd_4 * t151 + t152 * t135;
  const Scalar t153 = qd_2 * t125 - qd_1 * t136;
  const Scalar c_2_4_5 = db_25_4 + t118;
  const Scalar t154 = t18 + t19;
  C[10] = qd_6 * t154 + qd_4 * c_2_4_5 - qd_3 * t148 + t153 + t43 * t71;
  const Scalar t155 = qd_2 * t123 + qd_1 * t139;
  const Scalar t156 = t108 - t107;
  C[11] = qd_5 * t154 + t155 - t75 * t32 - qd_4 * t156 + qd_3 * c_2_3_6;
  const Scalar t157 = t53 + t145;
  const Scalar t158 = qd_4 * t150;
  C[14] = -qd_6 * c_6_3_3 - qd_5 * t157 - t158;
  const Scalar c_3_5_6 = db_36_5 - dmu_3_6_y;
  const Scalar t159 = t83 + t110;
  C[17] = qd_5 * c_3_5_6 - qd_4 * t159 - t144 - t89 * t32;
  const Scalar Ic_4_xz = Ic_5_xy - t8 - Scalar(0.0055448);
  const Scalar t160 = t38 + Scalar(0.0261804);
  const Scalar t161 = s_4 * t160 - c_4 * Ic_4_xz;
  const Scalar t162 = t161 + f_u_4_4_a_z * v_o_2_4_x;
  const Scalar t163 = s_2_3 * (s_4 * t132 + c_4 * t130) - t15 * t162;
  const Scalar mu_4_3_x = f_u_4_4_a_z - t161;
  const Scalar t164 = t15 * mu_4_3_x;
  const Scalar Ic_4_zz = Ic_6_xx + t115 + Scalar(0.0285811);
  const Scalar t165 = s_2_3 * Ic_4_zz + t164;
  const Scalar t166 = t165 - s_2 * f_u_4_4_a_z;
  const Scalar t167 = t166 - t163;
  const Scalar t168 = s_4 * (t15 * Ic_4_xz + s_2_3 * t128);
  const Scalar t169 = s_2_3 * (t168 - c_4 * (s_2_3 * t131 - t15 * t160));
  const Scalar t170 = s_4 * Ic_4_xz + c_4 * t160;
  const Scalar t171 = t133 * v_1_4_a_y;
  const Scalar t172 = s_2_3 * t170 - t171;
  const Scalar t173 = t169 - t15 * (t171 - t172);
  const Scalar t174 = qd_1 * t173;
  const Scalar t175 = c_4 * t128;
  const Scalar t176 = s_2_3 * (t175 + s_4 * t131) + t164;
  const Scalar t177 = t165 - t176;
  const Scalar t178 = Scalar(2.0) * qd_4;
  C[3] = qd_6 * t105 + qd_5 * t69 + t174 - t172 * t178 - qd_3 * t177 - qd_2 * t167;
  const Scalar t179 = t147 + t146;
  C[13] = qd_5 * t179 - qd_6 * c_6_2_3 - t158 - qd_2 * t135;
  const Scalar t180 = t176 + t165;
  const Scalar t181 = t150 * t152 - qd_1 * t180;
  C[20] = qd_6 * t111 - qd_5 * c_5_3_4 + t181;
  C[25] = qd_4 * c_5_2_4 - qd_6 * t20 - qd_3 * t179 - t153;
  const Scalar t182 = qd_3 * t157 - qd_2 * t179 + qd_1 * t137;
  C[26] = qd_4 * c_5_3_4 - qd_6 * c_6_3_5 + t182;
  C[31] = qd_5 * t20 - t155 - qd_4 * t109 + qd_3 * c_6_2_3;
  const Scalar c_3_4_5 = db_35_4 - t119;
  C[15] = qd_5 * c_3_4_5 - qd_6 * t159 - t181 - mu_4_3_x * t178;
  C[16] = qd_6 * c_3_5_6 - t54 * t71 + qd_4 * c_3_4_5 - t182;
  const Scalar t183 = t166 + t163;
  const Scalar t184 = qd_6 * t112 + qd_5 * t120 + t174 + qd_3 * t180 + qd_2 * t183;
  C[18] = -t184;
  const Scalar t185 = qd_2 * c_4_2_2 - qd_1 * t183;
  C[19] = qd_6 * t109 - qd_5 * c_5_2_4 + qd_3 * t150 + t185;
  const Scalar Ic_3_xy = Scalar(0.013088) + mu_4_3_x;
  const Scalar t186 = Scalar(2.0) * Ic_3_xy;
  const Scalar Iu_3_t_d = Scalar(2.0) * hu_5_t_y - t175 - t127 - Ic_4_zz + Scalar(0.96799115);
  const Scalar t187 = s_2_3 * t186 + t15 * Iu_3_t_d;
  const Scalar t188 = t15 * (s_2_3 * Iu_3_t_d - t15 * t186 - c_2 * hc_3_y);
  const Scalar t189 = c_2 * (s_2_3 * df_2_3_x + t15 * hc_3_y);
  const Scalar t190 = t189 - s_2_3 * (t187 - c_2 * df_2_3_x) - t188;
  const Scalar t191 = Scalar(0.0684948) * s_2 + t15 * df_2_3_x - s_2_3 * hc_3_y +
      Scalar(4.2001111) * c_2;
  const Scalar Ic_2_xy = Ic_3_xy + Scalar(0.0342474) + t189 - s_2_3 * t187 - s_2 * t191;
  const Scalar t192 = Scalar(2.0) * Ic_2_xy;
  C[0] = qd_6 * db_11_6r + qd_5 * t63 + qd_4 * t173 + qd_3 * t190 + qd_2 * t192;
  const Scalar t193 = t15 * (Ic_4_xy - t149 - Scalar(0.0080685)) +
      s_2_3 * (t170 + Scalar(0.0204192) + t133);
  const Scalar Iu_2_a_xz = Scalar(0.0222188) * s_2 - t193 + c_2 * (t133 + Scalar(0.0549346));
  const Scalar t194 = qd_3 * t193 - qd_2 * Iu_2_a_xz + qd_1 * Ic_2_xy;
  C[1] = qd_5 * t50 - qd_6 * t86 - qd_4 * t167 + Scalar(2.0) * t194;
  const Scalar t195 = qd_1 * t190;
  C[2] = qd_5 * t56 - qd_6 * t91 - qd_4 * t177 + Scalar(2.0) * t193 * t152 + t195;
  C[6] = qd_6 * t139 - qd_5 * t136 + qd_4 * t183 - qd_1 * t192;
  const Scalar t196 = qd_6 * t156 - qd_5 * c_2_4_5 - qd_3 * t151 + t185 - t162 * t178;
  C[9] = -t196;
  C[12] = qd_6 * t140 - qd_5 * t137 + qd_4 * t180 - t195;
  C[35] = Scalar(0.0);
}

// Gravity torques g(q) (7.39).
//   q[6]  in   joint positions, rad or m
//   g[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5]. Operations: 29 mul, 19 add, 10 sin/cos. Always zero: g[0].
template <class Scalar, class SinCos = LibrarySinCos>
inline void gravity(const Scalar* q, Scalar* g, const SinCos& sin_cos = {}) noexcept {
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar t1 = Scalar(0.06867) * c_6 + Scalar(0.109872) * s_6;
  const Scalar t2 = t1 - Scalar(0.199143);
  const Scalar hu_5_t_y = Scalar(0.310977) * c_5 - s_5 * t2;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t3 = c_4 * s_2_3;
  const Scalar t4 = Scalar(0.310977) * s_5 + c_5 * t2;
  const Scalar t5 = s_2 * s_3 - c_2 * c_3;
  g[4] = t5 * t4 - hu_5_t_y * t3;
  const Scalar hu_6_t_y = Scalar(0.109872) * c_6 - Scalar(0.06867) * s_6;
  g[5] = hu_6_t_y * (s_5 * t5 - c_5 * t3) + s_4 * s_2_3 * t1;
  const Scalar t6 = t4 + Scalar(1.141884);
  const Scalar hc_4_y = hu_6_t_y + Scalar(2.104245);
  g[3] = s_2_3 * (s_4 * t6 - c_4 * hc_4_y);
  const Scalar hc_3_y = hu_5_t_y + Scalar(37.580148);
  const Scalar t7 = s_2_3 * hc_3_y - t5 * (c_4 * t6 + s_4 * hc_4_y - Scalar(2.692845));
  g[2] = -t7;
  g[1] = Scalar(4.102542) * s_2 - t7 + Scalar(194.232114) * c_2;
  g[0] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   n[6]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..5], qd[0..5]. Operations: 195 mul, 173 add, 10 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5];
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = s_2_3 * qd_1;
  const Scalar t2 = c_4 * t1;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t3 = s_4 * omega_3_z;
  const Scalar t4 = t3 - t2;
  const Scalar t5 = s_2 * s_3 - c_2 * c_3;
  const Scalar t6 = t5 * qd_1;
  const Scalar omega_4_z = qd_4 - t6;
  const Scalar omega_r_5_y = s_5 * t4 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t7 = omega_6_z * omega_6_z;
  const Scalar t8 = s_4 * t1;
  const Scalar t9 = c_4 * omega_3_z;
  const Scalar omega_r_5_a_z = t8 + t9;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t10 = omega_5_z * omega_5_z;
  const Scalar t11 = t10 + t7;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t4;
  const Scalar t12 = omega_r_5_x * omega_r_5_x;
  const Scalar t13 = t12 + t10;
  const Scalar I_6_xz = Scalar(0.000534) * c_6 + Scalar(0.0009944) * s_6;
  const Scalar t14 = t4 * omega_r_5_a_z;
  const Scalar t15 = omega_3_z * t1;
  const Scalar U_4_xy = t14 + t15;
  const Scalar t16 = (t8 + Scalar(2.0) * t9) * t6;
  const Scalar t17 = t16 + Scalar(2.0) * omega_r_5_a_z * omega_4_z;
  const Scalar t18 = s_5 * U_4_xy + c_5 * t17;
  const Scalar t19 = Scalar(2.0) * omega_5_z;
  const Scalar t20 = t18 - omega_r_5_y * t19;
  const Scalar t21 = t20 + t19 * omega_6_z;
  const Scalar I_t6_g = Scalar(0.0002546) * c_6 - Scalar(0.000512) * s_6;
  const Scalar I_6_xy = s_6 * I_t6_g + Scalar(0.000256);
  const Scalar t22 = omega_r_5_x * omega_r_5_y;
  const Scalar t23 = t4 * omega_4_z;
  const Scalar t24 = (Scalar(2.0) * t3 - t2) * t6;
  const Scalar t25 = t23 + t24;
  const Scalar t26 = t22 + t25;
  const Scalar t27 = t26 - Scalar(2.0) * omega_r_5_x * omega_6_z;
  const Scalar t28 = c_6 * I_t6_g;
  const Scalar t29 = t28 - Scalar(0.0007896);
  const Scalar t30 = s_2 * qd_2;
  const Scalar t31 = qd_2 * t30 - Scalar(21.8);
  const Scalar t32 = qd_1 * qd_1;
  const Scalar t33 = c_2 * (qd_2 * qd_2 + t32);
  const Scalar t34 = s_2_3 * t31 - t5 * t33;
  const Scalar t35 = t1 * t6;
  const Scalar t36 = t35 + t34;
  const Scalar t37 = omega_3_z * t6;
  const Scalar t38 = qd_1 * t30;
  const Scalar t39 = Scalar(2.0) * t37 - Scalar(2.0) * t38;
  const Scalar t40 = s_4 * t39 - c_4 * t36;
  const Scalar t41 = t1 * t1;
  const Scalar t42 = omega_3_z * omega_3_z;
  const Scalar t43 = t41 + t42;
  const Scalar t44 = s_2_3 * t33 + t5 * t31;
  const Scalar t45 = t43 - t44;
  const Scalar t46 = s_5 * t40 + c_5 * t45;
  const Scalar t47 = Scalar(0.00315) * c_6 + Scalar(0.00504) * s_6;
  const Scalar t48 = t47 - Scalar(0.009135);
  const Scalar t49 = s_5 * t45 - c_5 * t40;
  const Scalar t50 = t4 * t4;
  const Scalar t51 = omega_4_z * omega_4_z;
  const Scalar Uz_o_5_y = t51 + t50;
  const Scalar t52 = Uz_o_5_y - t12 + t10;
  const Scalar t53 = s_5 * t17 - c_5 * U_4_xy;
  const Scalar t54 = Scalar(0.0009944) * c_6 - Scalar(0.000534) * s_6;
  const Scalar t55 = t25 - t22;
  const Scalar n_5 = Scalar(0.0007639) * t18 + I_6_xz * (t13 - t11) + t21 * I_6_xy -
      Scalar(0.0029421) * t55 - Scalar(0.0010857) * (t52 - t13) + t27 * t29 +
      t53 * (t54 + Scalar(0.0016163)) + t46 * t48 - Scalar(0.0123285) * t26 +
      Scalar(0.014265) * t49;
  n[4] = n_5;
  const Scalar t56 = t12 + t7;
  const Scalar t57 = t53 - omega_r_5_x * t19;
  const Scalar mr_6_y = Scalar(0.00504) * c_6 - Scalar(0.00315) * s_6;
  const Scalar I_6_xx = t28 + Scalar(0.000535);
  const Scalar t58 = s_4 * t36 + c_4 * t39;
  const Scalar t59 = I_6_xy * (t11 - t56) - t53 * I_6_xx + t20 * I_6_xz + t26 * t54 + t57 * t29 -
      mr_6_y * t49 + t47 * t58;
  n[5] = -t59;
  const Scalar t60 = Scalar(0.0007639) * (Uz_o_5_y - t52) - Scalar(0.0016163) * t26 -
      Scalar(0.0010857) * t20 + Scalar(0.0029421) * t57 + Scalar(0.009135) * t58 - t59;
  const Scalar U_6_yy_zz = t13 - t56;
  const Scalar U_5_yy_zz = Uz_o_5_y - t13;
  const Scalar t61 = t54 * U_6_yy_zz - t27 * I_6_xy - Scalar(0.0007639) * t55 -
      Scalar(0.0016163) * U_5_yy_zz + t21 * I_6_xx - t57 * (I_6_xz + Scalar(0.0010857)) +
      mr_6_y * t46 + Scalar(0.014265) * t58 + Scalar(0.0123285) * t20;
  const Scalar t62 = t51 - t50 + t43;
  const Scalar t63 = t14 - t15;
  const Scalar mu_4_z = Scalar(0.0009736) * (t62 - Uz_o_5_y) + Scalar(0.0123968) * t63 +
      Scalar(0.0110896) * t16 + c_5 * t60 - Scalar(0.0316473) * U_4_xy - s_5 * t61 +
      Scalar(0.0523608) * t24 - Scalar(0.096525) * t40 - Scalar(0.05238) * t58;
  n[3] = mu_4_z;
  const Scalar t64 = Scalar(0.009135) * t55 + mr_6_y * t21 - t47 * t27 + Scalar(0.014265) * t13;
  const Scalar t65 = mr_6_y * t53 - t47 * t11 + Scalar(0.009135) * t52 - Scalar(0.014265) * t26;
  const Scalar f_4_x = s_5 * t64 - c_5 * t65 + Scalar(0.05238) * t62 + Scalar(0.096525) * U_4_xy;
  const Scalar t66 = mr_6_y * t56 + t57 * t48 + Scalar(0.05238) * t63 - Scalar(0.014265) * t20 +
      Scalar(0.096525) * Uz_o_5_y;
  const Scalar f_u_4_t_x = s_4 * t66 + c_4 * f_4_x;
  const Scalar t67 = t23 + t25;
  const Scalar U_4_yy_zz = t43 - Uz_o_5_y;
  const Scalar t68 = Scalar(0.0009736) * t67 + Scalar(0.0110896) * t63 + s_5 * t60 + c_5 * t61 +
      Scalar(0.0316473) * t17 - Scalar(0.0523608) * U_4_yy_zz + Scalar(0.096525) * t45;
  const Scalar t69 = n_5 - Scalar(0.0009736) * t17 - Scalar(0.0123968) * t67 -
      Scalar(0.0110896) * (t43 - t62) + Scalar(0.0523608) * U_4_xy + Scalar(0.05238) * t45;
  const Scalar t70 = t32 - t41 + t42;
  const Scalar n_3 = c_4 * t69 - Scalar(0.026176) * (t70 - t43) - f_u_4_t_x +
      Scalar(0.123525) * t44 + s_4 * t68 + Scalar(1.8912169) * t35 + Scalar(1.72386) * t34;
  n[2] = n_3;
  const Scalar f_u_4_t_y = s_4 * f_4_x - c_4 * t66;
  const Scalar t71 = c_2 * (Scalar(0.24705) * t15 - f_u_4_t_y - Scalar(3.44772) * t37);
  const Scalar U_3_yy_zz = t32 - t43;
  const Scalar t72 = Scalar(0.016137) * t35 + Scalar(0.052352) * t15 +
      Scalar(0.0408384) * U_3_yy_zz + f_u_4_t_y - s_4 * t69 + c_4 * t68 - Scalar(3.44772) * t38 +
      Scalar(3.9306688) * t37;
  const Scalar t73 = Scalar(0.0408384) * t35 + Scalar(0.052352) * t37 +
      Scalar(0.016137) * (t32 - t70) + Scalar(0.148235) * t15 + Scalar(0.24705) * t38 - mu_4_z;
  const Scalar t74 = s_2 * (Scalar(0.1369896) * s_2 + Scalar(8.4002222) * c_2) - Scalar(0.0684948);
  const Scalar t75 = qd_2 * (Scalar(0.0444376) * s_2 + Scalar(0.1098692) * c_2) +
      Scalar(2.0) * qd_1 * t74;
  n[0] = t5 * t73 - t71 - s_2_3 * t72 - qd_2 * t75;
  const Scalar t76 = Scalar(0.123525) * t70 - f_u_4_t_x + Scalar(1.72386) * t35;
  const Scalar t77 = s_5 * t65 + c_5 * t64 + Scalar(0.123525) * t35 - Scalar(0.05238) * t67 +
      Scalar(0.096525) * t17 + Scalar(1.72386) * t43;
  const Scalar t78 = s_2 * (t5 * t76 - Scalar(4.102542) + s_2_3 * t77);
  const Scalar t79 = c_2 * (s_2_3 * t76 - t5 * t77 - Scalar(194.232114));
  n[1] = n_3 - t78 + t32 * t74 - t79;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   tau[6]  in   joint torques or forces, N m or N
//   qdd[6]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[1..5], qd[0..5], tau[0..5]. Operations: 364 mul, 289 add, 5 div, 10 sin/cos.
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
  const Scalar Iu_6_t_g = Scalar(0.0002546) * c_6 - Scalar(0.000512) * s_6;
  const Scalar t1 = c_6 * Iu_6_t_g;
  const Scalar Iu_6_t_xx = t1 - Scalar(0.0002546);
  const Scalar Iu_5_t_d = Iu_6_t_xx + Scalar(0.0088514);
  const Scalar Iu_6_t_xz = Scalar(0.000534) * c_6 + Scalar(0.0009944) * s_6;
  const Scalar Ic_5_xy = Iu_6_t_xz + Scalar(0.0010857);
  const Scalar t2 = Scalar(2.0) * s_5 * Ic_5_xy - c_5 * Iu_5_t_d;
  const Scalar Iu_5_t_xy = Ic_5_xy - s_5 * t2;
  const Scalar Ic_4_xz = Iu_5_t_xy - Scalar(0.0110896);
  const Scalar Iu_6_t_xy = s_6 * Iu_6_t_g + Scalar(0.000256);
  const Scalar t3 = Iu_6_t_xy + Scalar(0.0007639);
  const Scalar Iu_6_a_xy = Scalar(0.0009944) * c_6 - Scalar(0.000534) * s_6;
  const Scalar Ic_5_yz = Iu_6_a_xy + Scalar(0.0016163);
  const Scalar t4 = s_5 * t3 - c_5 * Ic_5_yz;
  const Scalar t5 = t4 + Scalar(0.0523608);
  const Scalar t6 = s_4 * Ic_4_xz + c_4 * t5;
  const Scalar f_u_6_6_a_z = Scalar(0.00315) * c_6 + Scalar(0.00504) * s_6;
  const Scalar t7 = f_u_6_6_a_z - Scalar(0.009135);
  const Scalar t8 = c_5 * t7 + Scalar(0.014265) * s_5;
  const Scalar t9 = t8 + Scalar(0.05238);
  const Scalar hu_6_t_y = Scalar(0.00504) * c_6 - Scalar(0.00315) * s_6;
  const Scalar hc_4_y = hu_6_t_y + Scalar(0.096525);
  const Scalar t10 = s_4 * t9 - c_4 * hc_4_y;
  const Scalar t11 = t6 + t10;
  const Scalar Iu_5_a_xz = c_5 * t3 + s_5 * Ic_5_yz;
  const Scalar hu_5_t_y = Scalar(0.014265) * c_5 - s_5 * t7;
  const Scalar mu_u_5_5_a_y = t1 - Scalar(0.0160602);
  const Scalar t12 = mu_u_5_5_a_y - hu_5_t_y;
  const Scalar t13 = s_4 * Iu_5_a_xz - c_4 * t12;
  const Scalar t14 = c_5 * hu_6_t_y;
  const Scalar t15 = s_4 * f_u_6_6_a_z - c_4 * t14;
  const Scalar t16 = Scalar(0.0013246) * s_5 - c_5 * Iu_6_t_xz;
  const Scalar t17 = -s_4 * t16 - c_4 * Iu_6_a_xy + t15;
  const Scalar t18 = Scalar(754.9448890231013) * Iu_6_a_xy;
  const Scalar t19 = t17 * t18 + t13;
  const Scalar mu_u_6_5_t_y = Scalar(0.0013246) * c_5 + s_5 * Iu_6_t_xz;
  const Scalar t20 = mu_u_6_5_t_y * t18 + t4;
  const Scalar t21 = Iu_6_a_xy * t18 + mu_u_5_5_a_y;
  const Scalar t22 = Scalar(1.0) / t21;
  const Scalar t23 = t20 * t22;
  const Scalar t24 = Scalar(754.9448890231013) * mu_u_6_5_t_y;
  const Scalar t25 = t19 * t23 - t17 * t24 + t11;
  const Scalar t26 = c_5 * t2;
  const Scalar Iu_5_t_yy = Iu_6_t_xx + t26;
  const Scalar Ic_4_zz = Iu_5_t_yy + Scalar(0.0571622);
  const Scalar b_5_4_4 = t20 * t23 - mu_u_6_5_t_y * t24 + Ic_4_zz;
  const Scalar d_4 = Scalar(1.0) / b_5_4_4;
  const Scalar t27 = t25 * d_4;
  const Scalar t28 = t26 + Scalar(0.0088514);
  const Scalar t29 = mu_u_5_5_a_y + Scalar(0.0323686);
  const Scalar Ic_4_xy = Iu_5_a_xz - Scalar(0.0009736);
  const Scalar t30 = Scalar(2.0) * s_4 * Ic_4_xy + c_4 * (t28 - t29);
  const Scalar t31 = c_4 * t30;
  const Scalar t32 = t28 - t31;
  const Scalar t33 = Scalar(2.0) * hu_5_t_y;
  const Scalar t34 = t32 - t33 - Scalar(2.0842173);
  const Scalar t35 = t19 * t22;
  const Scalar t36 = Scalar(-754.9448890231013) * t17;
  const Scalar t37 = -t19 * t35 - t17 * t36 + t25 * t27 + t34;
  const Scalar t38 = Scalar(1.0) / t37;
  const Scalar t39 = s_2 * s_3 - c_2 * c_3;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t40 = s_5 * hu_6_t_y;
  const Scalar t41 = s_2 * (s_2_3 * t40 - t39 * t15);
  const Scalar t42 = t17 + t41 - c_2 * (s_2_3 * t15 + t39 * t40);
  const Scalar t43 = c_4 * hu_5_t_y;
  const Scalar t44 = s_2 * (t39 * t43 + s_2_3 * t8);
  const Scalar t45 = c_2 * (s_2_3 * t43 - t39 * t8);
  const Scalar t46 = t42 * t18 - t44 - t45 + t13;
  const Scalar t47 = t10 * (s_2 * t39 + c_2 * s_2_3);
  const Scalar t48 = t46 * t23 - t42 * t24 - t47 + t11;
  const Scalar f_u_4_4_a_z = c_4 * t9 + s_4 * hc_4_y;
  const Scalar t49 = f_u_4_4_a_z - Scalar(0.123525);
  const Scalar hc_3_y = hu_5_t_y + Scalar(1.72386);
  const Scalar t50 = s_2_3 * hc_3_y - t39 * t49;
  const Scalar t51 = c_2 * t50;
  const Scalar t52 = s_2_3 * t49 + t39 * hc_3_y;
  const Scalar t53 = t51 + s_2 * t52;
  const Scalar t54 = -t42 * t36 - t46 * t35 + t48 * t27 + t53 + t34;
  const Scalar t55 = t54 * t38;
  const Scalar t56 = t48 * d_4;
  const Scalar t57 = t46 * t22;
  const Scalar t58 = Scalar(-754.9448890231013) * t42;
  const Scalar t59 = -t46 * t57 - t42 * t58 + t48 * t56 + t34 + Scalar(2.0) * t53 - t54 * t55 -
      Scalar(8.554441);
  const Scalar t60 = Scalar(1.0) / t59;
  const Scalar Iu_4_t_xy = Ic_4_xy - s_4 * t30;
  const Scalar t61 = Iu_4_t_xy - Scalar(0.016137);
  const Scalar t62 = Scalar(0.0408384) + t11;
  const Scalar t63 = s_2_3 * t61 - t39 * t62;
  const Scalar t64 = s_4 * t5 - c_4 * Ic_4_xz;
  const Scalar mu_4_3_x = f_u_4_4_a_z - t64;
  const Scalar t65 = s_2_3 * (c_4 * Iu_5_a_xz + s_4 * t12);
  const Scalar f_u_6_4_a_z = s_4 * t14 + c_4 * f_u_6_6_a_z;
  const Scalar mu_6_3_x = s_4 * Iu_6_a_xy - c_4 * t16 + f_u_6_4_a_z;
  const Scalar t66 = t39 * mu_u_6_5_t_y + c_2 * f_u_6_4_a_z - s_2_3 * mu_6_3_x;
  const Scalar b_6_5_1 = t39 * t4 + t66 * t18 - c_2 * s_4 * hu_5_t_y - t65;
  const Scalar t67 = b_6_5_1 * t23 - t66 * t24 + c_2 * f_u_4_4_a_z - s_2_3 * mu_4_3_x +
      t39 * Ic_4_zz;
  const Scalar t68 = -b_6_5_1 * t35 - t66 * t36 + t63 + t67 * t27;
  const Scalar t69 = t10 + Scalar(0.1098692);
  const Scalar b_3_2_1 = b_6_5_1 * t57 + t66 * t58 + Scalar(0.0444376) * c_2 - t63 - s_2 * t69 +
      t68 * t55 - t67 * t56;
  const Scalar t70 = b_3_2_1 * t60;
  const Scalar t71 = t68 * t38;
  const Scalar t72 = t31 + t29;
  const Scalar t73 = t72 - t33;
  const Scalar Ic_3_xy = Scalar(0.026176) + mu_4_3_x;
  const Scalar t74 = Scalar(2.0) * s_2_3 * Ic_3_xy - t39 * (Ic_4_zz + t73 - Scalar(1.9359823));
  const Scalar t75 = t67 * d_4;
  const Scalar t76 = b_6_5_1 * t22;
  const Scalar t77 = Scalar(-754.9448890231013) * t66;
  const Scalar t78 = Scalar(0.1369896) * s_2 + Scalar(8.4002222) * c_2;
  const Scalar t79 = -b_3_2_1 * t70 - t68 * t71 - b_6_5_1 * t76 - t66 * t77 + t73 + t67 * t75 +
      t39 * t74 + Scalar(2.0) * t51 - Scalar(2.8931568) - c_2 * t78;
  const Scalar t80 = t72 - t32;
  const Scalar Iu_4_x = Ic_4_zz + t80;
  const Scalar t81 = s_2_3 * qd_1;
  const Scalar t82 = Scalar(2.0) * qd_1;
  const Scalar beta_4_f = qd_4 - t39 * t82;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t83 = Scalar(2.0) * omega_3_z;
  const Scalar t84 = qd_4 * ((t81 * Iu_4_x + t64 * beta_4_f) + Iu_4_t_xy * t83);
  const Scalar t85 = Iu_5_t_yy + t28;
  const Scalar t86 = t39 * qd_1;
  const Scalar omega_4_z = qd_4 - t86;
  const Scalar t87 = s_4 * t81;
  const Scalar omega_r_5_a_z = t87 + c_4 * omega_3_z;
  const Scalar t88 = Scalar(2.0) * omega_r_5_a_z;
  const Scalar beta_5_f = qd_5 + t88;
  const Scalar t89 = Scalar(2.0) * Iu_5_t_xy;
  const Scalar t90 = c_4 * t81;
  const Scalar t91 = s_4 * omega_3_z - t90;
  const Scalar t92 = qd_5 * ((omega_4_z * (t85 + mu_u_5_5_a_y) - t4 * beta_5_f) - t91 * t89);
  const Scalar omega_r_5_y = s_5 * t91 + c_5 * omega_4_z;
  const Scalar t93 = Scalar(2.0) * omega_r_5_y;
  const Scalar beta_6_f = qd_6 + t93;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar Iu_6_d = t1 + Iu_6_t_xx;
  const Scalar Iu_6_y = Iu_6_d + Scalar(0.0013246);
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t91;
  const Scalar t94 = Scalar(2.0) * Iu_6_t_xy;
  const Scalar t95 = omega_r_5_x * t94 + (omega_5_z * Iu_6_y - Iu_6_a_xy * beta_6_f);
  const Scalar t96 = c_5 * qd_6;
  const Scalar t97 = t95 * t96 + t92;
  const Scalar t98 = Scalar(2.0) * (f_u_6_6_a_z * omega_r_5_x + hu_6_t_y * omega_5_z);
  const Scalar t99 = s_5 * qd_6;
  const Scalar t100 = f_u_6_6_a_z * beta_6_f;
  const Scalar t101 = qd_5 * beta_5_f;
  const Scalar f_a_5_x = t98 * t99 + t100 * t96 + t8 * t101;
  const Scalar t102 = qd_5 * (hu_5_t_y * omega_4_z + t8 * t91);
  const Scalar t103 = hu_6_t_y * qd_6 * beta_6_f + Scalar(2.0) * t102;
  const Scalar t104 = qd_4 * beta_4_f;
  const Scalar f_a_4_x = c_4 * f_a_5_x + s_4 * t103 + f_u_4_4_a_z * t104;
  const Scalar t105 = qd_6 * ((omega_r_5_x * (Iu_6_d - Scalar(0.0013246)) + Iu_6_t_xz * beta_6_f) -
      omega_5_z * t94);
  const Scalar t106 = c_4 * t105 - s_4 * t97 - t84 + f_a_4_x;
  const Scalar t107 = s_2_3 * omega_3_z * Iu_4_x + t39 * (t6 * t81 - t64 * t83);
  const Scalar t108 = qd_5 * ((Iu_5_a_xz * beta_5_f + t91 * (mu_u_5_5_a_y - t85)) -
      omega_4_z * t89);
  const Scalar t109 = t95 * t99 + t108;
  const Scalar t110 = t86 * (t87 + c_4 * t83) + omega_4_z * t88;
  const Scalar U_4_xy = t91 * omega_r_5_a_z + omega_3_z * t81;
  const Scalar U_5_zy = omega_5_z * t93 - s_5 * U_4_xy - c_5 * t110;
  const Scalar t111 = qd_1 * qd_1;
  const Scalar t112 = qd_2 * qd_2;
  const Scalar t113 = s_2 * t112 - Scalar(21.8);
  const Scalar t114 = c_2 * (t112 + t111);
  const Scalar t115 = t39 * t114 - s_2_3 * (t39 * t111 + t113);
  const Scalar t116 = (t39 * omega_3_z - s_2 * qd_2) * t82;
  const Scalar t117 = s_4 * t116 + c_4 * t115;
  const Scalar t118 = t81 * t81;
  const Scalar t119 = omega_3_z * omega_3_z;
  const Scalar t120 = -s_2_3 * t114 - t39 * t113 + (t118 + t119);
  const Scalar t121 = hu_6_t_y * (s_5 * t120 - c_5 * t117);
  const Scalar t122 = omega_r_5_x * omega_5_z;
  const Scalar t123 = t122 + c_5 * U_4_xy - s_5 * t110;
  const Scalar t124 = t91 * omega_4_z;
  const Scalar domega_4_y = t124 - t86 * (t90 - s_4 * t83);
  const Scalar U_5_xy = omega_r_5_x * omega_r_5_y + domega_4_y;
  const Scalar t125 = Iu_6_t_xy * (omega_5_z * omega_5_z - omega_r_5_x * omega_r_5_x);
  const Scalar t126 = f_u_6_6_a_z * (s_4 * t115 - c_4 * t116);
  const Scalar y_6 = t125 - t122 * Iu_6_d + Iu_6_a_xy * U_5_xy - Iu_6_t_xz * U_5_zy +
      Scalar(0.0013246) * t123 - t121 - t126 + tau_6;
  const Scalar t127 = Iu_5_t_xy * (omega_4_z * omega_4_z - t91 * t91);
  const Scalar t128 = t105 - t4 * U_4_xy - Iu_5_a_xz * t110 + t127 + t124 * t85 + hu_5_t_y * t117 -
      t8 * t120 - mu_u_5_5_a_y * domega_4_y - t18 * y_6 + tau_5;
  const Scalar y_5_4 = t109 + Iu_4_t_xy * (t119 - t118) + qd_1 * t107 - t23 * t128 - t10 * t115 +
      f_u_4_4_a_z * t116 + tau_4 - t24 * y_6;
  const Scalar Iu_3_t_xy = Ic_3_xy - s_2_3 * t74;
  const Scalar y_4_3 = t106 + tau_3 + t35 * t128 + Iu_3_t_xy * t111 + t52 * t114 + t27 * y_5_4 -
      t36 * y_6 - t50 * t113;
  const Scalar Ic_2_xy = Scalar(0.0684948) + Iu_3_t_xy + c_2 * t52 - s_2 * (t78 - t50);
  const Scalar t129 = qd_4 * (t10 * omega_3_z - f_u_4_4_a_z * t81);
  const Scalar t130 = t98 * t96 - t99 * t100 + hu_5_t_y * t101 - Scalar(2.0) * t129;
  const Scalar beta_3_f = qd_3 + Scalar(2.0) * qd_2;
  const Scalar t131 = qd_3 * beta_3_f;
  const Scalar f_a_3_x = s_2_3 * t130 - t39 * f_a_4_x + t50 * t131;
  const Scalar t132 = c_2 * ((s_2_3 * f_a_4_x + t39 * t130 + t52 * t131) + Scalar(194.232114));
  const Scalar t133 = t106 + tau_2 + t57 * t128 + Scalar(21.8) * t50 + t56 * y_5_4 +
      s_2 * (f_a_3_x - Scalar(4.102542)) - t55 * y_4_3 - t58 * y_6 + Ic_2_xy * t111 - t132;
  const Scalar t134 = t82 * (Iu_3_t_xy * qd_3 + Ic_2_xy * qd_2);
  const Scalar Iu_4_y = Ic_4_zz - t80;
  const Scalar t135 = qd_4 * (Scalar(2.0) * Iu_4_t_xy * t81 + (t6 * beta_4_f + omega_3_z * Iu_4_y));
  const Scalar t136 = s_4 * f_a_5_x - c_4 * t103 + t10 * t104;
  const Scalar t137 = s_2_3 * (s_4 * t105 + c_4 * t97 + t136 + t135);
  const Scalar t138 = t39 * t61 + s_2_3 * t62;
  const Scalar Iu_2_a_xz = Scalar(0.0444376) * s_2 - t138 + c_2 * t69;
  const Scalar t139 = c_2 * (t136 + t52 * qd_3 * t82);
  const Scalar y_2_1 = Iu_2_a_xz * t112 - t39 * t109 - t138 * t131 + t137 - t71 * y_4_3 +
      t70 * t133 + tau_1 + t76 * t128 - t139 + t75 * y_5_4 - t77 * y_6 - t134;
  const Scalar t140 = (Scalar(1.0) / t79) * y_2_1;
  qdd[0] = -t140;
  const Scalar t141 = t60 * (b_3_2_1 * t140 + t133);
  qdd[1] = -t141;
  const Scalar t142 = t38 * (y_4_3 - (t68 * t140 + t54 * t141));
  qdd[2] = -t142;
  const Scalar qdd_4 = d_4 * ((y_5_4 - t25 * t142) - (t67 * t140 + t48 * t141));
  qdd[3] = qdd_4;
  const Scalar t143 = (b_6_5_1 * t140 + t46 * t141) + t128;
  const Scalar t144 = t22 * ((t19 * t142 + t20 * qdd_4) + t143);
  qdd[4] = -t144;
  const Scalar t145 = (t42 * t141 + t17 * t142) - (y_6 - t66 * t140);
  qdd[5] = Scalar(-754.9448890231013) * (mu_u_6_5_t_y * qdd_4 - Iu_6_a_xy * t144) -
      Scalar(754.9448890231013) * t145;
  bool positive = -t79 > Scalar(0.0);
  positive &= -t59 > Scalar(0.0);
  positive &= -t37 > Scalar(0.0);
  positive &= b_5_4_4 > Scalar(0.0);
  positive &= -t21 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[6]   in  joint positions, rad or m
//   qd[6]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1..5], qd[0..5]. Operations: 106 mul, 76 add, 10 sin/cos.
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
  const Scalar v_r_4_a_y = t1 - omega_r_3_x;
  const Scalar t3 = s_3 * qd_2;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t4 = omega_3_z - t3;
  const Scalar v_r_4_x = s_4 * v_r_4_a_y - c_4 * t4;
  const Scalar t5 = c_3 * qd_2;
  const Scalar v_r_5_x = s_5 * t5 + c_5 * v_r_4_x;
  const Scalar v_r_4_y = s_4 * t4 + c_4 * v_r_4_a_y;
  const Scalar v_r_6_x = s_6 * v_r_4_y + c_6 * v_r_5_x;
  const Scalar t6 = s_6 * v_r_5_x - c_6 * v_r_4_y;
  const Scalar t7 = s_4 * omega_3_z - c_4 * omega_r_3_x;
  const Scalar t8 = s_3 * t2 - c_3 * t1;
  const Scalar omega_4_z = qd_4 - t8;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t7;
  const Scalar omega_r_5_a_z = s_4 * omega_r_3_x + c_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t9 = s_6 * omega_5_z - c_6 * omega_r_5_x;
  const Scalar t10 = s_6 * omega_r_5_x + c_6 * omega_5_z;
  const Scalar omega_r_5_y = s_5 * t7 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t11 = Scalar(0.000534) * t9 - Scalar(0.0009944) * t10 -
      Scalar(0.0013246) * omega_6_z - Scalar(0.0063) * t6 + Scalar(0.01008) * v_r_6_x;
  const Scalar t12 = s_5 * v_r_4_x - c_5 * t5;
  const Scalar t13 = t10 * (Scalar(0.000256) * t9 + Scalar(0.0009944) * omega_6_z +
      Scalar(0.0063) * t12);
  const Scalar t14 = Scalar(0.0002546) * t9 + Scalar(0.000256) * t10 -
      Scalar(0.000534) * omega_6_z + Scalar(0.01008) * t12;
  const Scalar t15 = Scalar(0.0007639) * omega_r_5_x - Scalar(0.0016163) * omega_r_5_y +
      Scalar(0.01827) * t12 + Scalar(0.02853) * v_r_5_x - Scalar(0.0158056) * omega_5_z;
  const Scalar L_5_y = Scalar(0.0010857) * omega_r_5_x + Scalar(0.0016163) * omega_5_z +
      Scalar(0.01827) * v_r_4_y;
  const Scalar t16 = Scalar(0.0007639) * omega_5_z - Scalar(0.0010857) * omega_r_5_y -
      Scalar(0.0099214) * omega_r_5_x + Scalar(0.02853) * v_r_4_y;
  const Scalar t17 = Scalar(0.0110896) * t7 - Scalar(0.0523608) * omega_r_5_a_z +
      Scalar(0.0469862) * omega_4_z - Scalar(0.10476) * v_r_4_y - Scalar(0.19305) * v_r_4_x;
  const Scalar L_4_y = Scalar(0.0009736) * t7 + Scalar(0.10476) * t5 +
      Scalar(0.0523608) * omega_4_z;
  const Scalar L_4_x = Scalar(0.0009736) * omega_r_5_a_z - Scalar(0.0110896) * omega_4_z -
      Scalar(0.0221926) * t7 + Scalar(0.19305) * t5;
  const Scalar L_3_z = Scalar(0.016137) * omega_r_3_x + Scalar(0.0408384) * t8 +
      Scalar(0.24705) * t5 - Scalar(3.44772) * t3 + Scalar(2.0518487) * omega_3_z;
  const Scalar L_3_y = Scalar(0.026176) * omega_r_3_x - Scalar(0.0408384) * omega_3_z +
      Scalar(0.24705) * t1;
  const Scalar t18 = Scalar(0.026176) * t8 - Scalar(0.016137) * omega_3_z -
      Scalar(1.9036137) * omega_r_3_x + Scalar(3.44772) * t1;
  const Scalar L_2_y = Scalar(0.0444376) * qd_2 + Scalar(0.0684948) * t2;
  const Scalar t19 = t2 * (Scalar(0.1098692) * qd_2 - Scalar(0.0684948) * t1 +
      Scalar(8.4002222) * t2);
  const Scalar L_2_z = Scalar(0.0444376) * t1 - Scalar(0.1098692) * t2 + Scalar(8.554441) * qd_2;
  const Scalar t20 = -t13 - t9 * t14 + omega_6_z * t11 - omega_r_5_y * L_5_y + omega_r_5_x * t16 -
      t1 * L_2_y + omega_5_z * t15 + omega_r_5_a_z * L_4_y + t7 * L_4_x + t8 * L_3_y -
      omega_4_z * t17 + omega_r_3_x * t18 - omega_3_z * L_3_z + t19 - qd_2 * L_2_z -
      Scalar(9.3573967) * qd_1 * qd_1;
  return Scalar(-0.5) * t20;
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
// Reads q[0..5], qd[0..5]. Operations: 116 mul, 59 add, 12 sin/cos.
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
  const Scalar t3 = qd_1 * (t1 + t2);
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t4 = s_4 * omega_3_z;
  const Scalar t5 = t4 - c_4 * t3;
  const Scalar t6 = s_2 * s_3 - c_2 * c_3;
  const Scalar t7 = qd_1 * t6;
  const Scalar omega_4_z = qd_4 - t7;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t5;
  const Scalar t8 = c_4 * omega_3_z;
  const Scalar omega_r_5_a_z = s_4 * t3 + t8;
  const Scalar omega_5_z = qd_5 + omega_r_5_a_z;
  const Scalar t9 = qd_6 * (s_6 * omega_5_z - c_6 * omega_r_5_x);
  const Scalar omega_r_5_y = s_5 * t5 + c_5 * omega_4_z;
  const Scalar t10 = t8 * t7 + qd_4 * omega_r_5_a_z;
  const Scalar t11 = omega_3_z * t3;
  const Scalar domega_q_5_x = qd_5 * omega_r_5_y - s_5 * t11 - c_5 * t10;
  const Scalar t12 = t4 * t7 + qd_4 * t5;
  const Scalar t13 = t9 - s_6 * domega_q_5_x + c_6 * t12;
  const Scalar t14 = qd_6 * (s_6 * omega_r_5_x + c_6 * omega_5_z);
  const Scalar t15 = t14 - s_6 * t12 - c_6 * domega_q_5_x;
  const Scalar t16 = s_6 * t13 + c_6 * t15;
  const Scalar t17 = c_5 * t11 + qd_5 * omega_r_5_x - s_5 * t10;
  const Scalar domega_e_5_t_x = s_5 * t17 - c_5 * t16;
  const Scalar domega_e_6_a_z = s_6 * t15 - c_6 * t13;
  const Scalar domega_e_4_t_x = s_4 * domega_e_6_a_z + c_4 * domega_e_5_t_x;
  const Scalar t18 = s_5 * t16 + c_5 * t17;
  const Scalar domega_e_3_t_x = s_3 * t18 + c_3 * domega_e_4_t_x;
  const Scalar t19 = s_3 * domega_e_4_t_x - c_3 * t18;
  a[5] = s_2 * domega_e_3_t_x + c_2 * t19;
  const Scalar t20 = qd_1 * qd_1;
  const Scalar t21 = qd_2 * qd_2 - (s_2 * s_2 - Scalar(1.0)) * t20;
  const Scalar t22 = s_2 * t20 * t1 - c_3 * t21;
  const Scalar ddp_o_4_x = Scalar(0.45) * t22 - Scalar(0.45) * t3 * t7;
  const Scalar t23 = (t6 * omega_3_z - s_2 * qd_2) * Scalar(0.9) * qd_1;
  const Scalar ddp_4_x = c_4 * ddp_o_4_x + s_4 * t23;
  const Scalar t24 = t3 * t3 - s_3 * t21 + omega_3_z * omega_3_z;
  const Scalar t25 = Scalar(0.45) * t24 - Scalar(0.45) * c_2 * t20 * t2;
  const Scalar t26 = s_5 * t25 - c_5 * ddp_4_x;
  const Scalar t27 = s_4 * ddp_o_4_x - c_4 * t23;
  const Scalar t28 = s_6 * t26 - c_6 * t27;
  const Scalar t29 = s_6 * t27 + c_6 * t26;
  const Scalar t30 = s_6 * t28 + c_6 * t29;
  const Scalar t31 = s_5 * ddp_4_x + c_5 * t25;
  const Scalar a_5_t_x = s_5 * t31 - c_5 * t30;
  const Scalar t32 = s_6 * t29 - c_6 * t28;
  const Scalar a_4_t_x = s_4 * t32 + c_4 * a_5_t_x;
  const Scalar t33 = s_5 * t30 + c_5 * t31;
  const Scalar a_3_t_x = s_3 * t33 + c_3 * a_4_t_x;
  const Scalar t34 = s_3 * a_4_t_x - c_3 * t33;
  a[2] = s_2 * a_3_t_x + c_2 * t34;
  const Scalar t35 = s_2 * t19 - c_2 * domega_e_3_t_x;
  const Scalar t36 = s_4 * domega_e_5_t_x - c_4 * domega_e_6_a_z;
  a[3] = -s_1 * t36 - c_1 * t35;
  a[4] = c_1 * t36 - s_1 * t35;
  const Scalar t37 = s_2 * t34 - c_2 * a_3_t_x;
  const Scalar t38 = s_4 * a_5_t_x - c_4 * t32;
  a[0] = -s_1 * t38 - c_1 * t37;
  a[1] = c_1 * t38 - s_1 * t37;
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

}  // namespace rx90

#endif  // FLATDYN_RX90_HPP

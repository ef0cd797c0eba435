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
// Reads q[1..4], qd[0..5], qdd[0..5]. Operations: 155 mul, 118 add, 8 sin/cos.
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
  const Scalar t1 = c_2 * s_3 + s_2 * c_3;
  const Scalar t2 = s_2 * s_3 - c_2 * c_3;
  const Scalar t3 = s_4 * t1 + c_4 * t2;
  const Scalar t4 = qd_1 * t3;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar t5 = omega_4_z * t4;
  const Scalar t6 = s_4 * t2 - c_4 * t1;
  const Scalar t7 = qdd_1 * t6 + Scalar(2.0) * t5;
  const Scalar t8 = qd_1 * qd_1;
  const Scalar t9 = t8 * t6;
  const Scalar t10 = t3 * t9;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar domega_4_z = qdd_4 + domega_3_z;
  const Scalar Uz_o_5_x = domega_4_z - t10;
  const Scalar Uz_5_x = s_5 * t7 + c_5 * Uz_o_5_x;
  const Scalar t11 = qd_1 * t6;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t11;
  const Scalar omega_5_z = qd_5 + t4;
  const Scalar t12 = omega_r_5_x * omega_5_z;
  const Scalar domega_5_y = Uz_5_x - t12;
  const Scalar domega_6_z = qdd_6 + domega_5_y;
  const Scalar N_6_z = Scalar(0.0001321171875) * domega_6_z;
  tau[5] = N_6_z;
  const Scalar t13 = s_2 * t8;
  const Scalar t14 = qd_2 * qd_2 - s_2 * t13 + t8;
  const Scalar ddp_o_3_x = t14 + Scalar(23.08235294117647) * s_2;
  const Scalar t15 = c_2 * t13;
  const Scalar U_2_yx = t15 + qdd_2;
  const Scalar ddp_o_3_y = Scalar(23.08235294117647) * c_2 - U_2_yx;
  const Scalar t16 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t17 = t8 * t1;
  const Scalar t18 = t2 * t17;
  const Scalar U_3_yx = domega_3_z - t18;
  const Scalar t19 = qdd_1 * t1;
  const Scalar t20 = Scalar(0.25682352941176473) * t19 + Scalar(0.9229411764705883) * U_3_yx + t16;
  const Scalar ddp_3_x = s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar t21 = t8 - t1 * t17 + omega_3_z * omega_3_z;
  const Scalar t22 = qdd_1 * t2;
  const Scalar t23 = Scalar(0.25682352941176473) * t22 - Scalar(0.9229411764705883) * t21 - ddp_3_x;
  const Scalar t24 = s_4 * t20 + c_4 * t23;
  const Scalar ddp_o_5_x = Scalar(0.22270588235294117) * Uz_o_5_x - t24;
  const Scalar t25 = qd_1 * omega_3_z;
  const Scalar t26 = t1 * t25;
  const Scalar t27 = t22 + t26;
  const Scalar U_3_zx = t26 + t27;
  const Scalar t28 = qd_1 * qd_2;
  const Scalar t29 = s_2 * t28;
  const Scalar t30 = t29 - c_2 * qdd_1;
  const Scalar t31 = Scalar(0.25682352941176473) * t8 + t29 + t30 +
      Scalar(0.9229411764705883) * U_3_zx;
  const Scalar t32 = Scalar(0.22270588235294117) * t7 - t31;
  const Scalar ddp_5_x = s_5 * t32 + c_5 * ddp_o_5_x;
  const Scalar omega_r_5_y = s_5 * t11 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t33 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar t34 = omega_4_z * t11;
  const Scalar t35 = qdd_1 * t3;
  const Scalar t36 = t34 - t35;
  const Scalar domega_5_z = qdd_5 - t36;
  const Scalar t37 = omega_r_5_x * omega_r_5_y;
  const Scalar mu_5_z = Scalar(0.000035853228) * Uz_5_x + omega_r_5_x * t33 -
      Scalar(0.0016432000421699) * t37 + Scalar(0.0038374000421699) * domega_5_z -
      Scalar(0.0149450629075) * ddp_5_x;
  tau[4] = mu_5_z;
  const Scalar t38 = omega_5_z * omega_5_z + omega_r_5_x * omega_r_5_x;
  const Scalar t39 = Scalar(0.0149450629075) * t38 +
      Scalar(0.28794534274300054) * (s_5 * ddp_o_5_x - c_5 * t32);
  const Scalar t40 = domega_5_z - t37;
  const Scalar t41 = Scalar(0.0149450629075) * t40 - Scalar(0.28794534274300054) * ddp_5_x;
  const Scalar t42 = s_5 * t39 - c_5 * t41;
  const Scalar t43 = Scalar(-0.000035853228) * t40 - N_6_z + Scalar(0.0038374000421699) * t12 +
      Scalar(0.0016432000421699) * domega_5_y;
  const Scalar t44 = s_4 * t23 - c_4 * t20;
  const Scalar Uz_o_5_y = t6 * t9 + omega_4_z * omega_4_z;
  const Scalar ddp_o_5_y = Scalar(0.22270588235294117) * Uz_o_5_y + t44;
  const Scalar U_5_yy_zz = Uz_o_5_y - t38;
  const Scalar t45 = omega_r_5_y * omega_5_z;
  const Scalar t46 = Scalar(0.000035853228) * U_5_yy_zz - omega_5_z * t33 +
      Scalar(0.0054806000843398) * t45 - Scalar(0.0149450629075) * ddp_o_5_y;
  const Scalar tau_4 = Scalar(0.000035853228) * t35 - Scalar(0.0017106935695699) * t10 - c_5 * t43 +
      Scalar(0.0039048935695699) * domega_4_z + s_5 * t46 + Scalar(0.22270588235294117) * t42;
  tau[3] = tau_4;
  const Scalar t47 = Scalar(0.4462748022139784) * t24 - t42;
  const Scalar U_5_zy = s_5 * Uz_o_5_x - c_5 * t7 + Scalar(2.0) * t45;
  const Scalar t48 = Scalar(0.28794534274300054) * ddp_o_5_y - Scalar(0.0149450629075) * U_5_zy +
      Scalar(0.4462748022139784) * t44;
  const Scalar t49 = s_4 * t47 - c_4 * t48;
  const Scalar t50 = Scalar(0.047511847575) * t19 - Scalar(0.0575445715) * t18 +
      Scalar(0.0534495715) * domega_3_z - tau_4 - Scalar(0.9229411764705883) * t49;
  tau[2] = -t50;
  const Scalar t51 = s_4 * t48 + c_4 * t47;
  const Scalar f_3_x = Scalar(0.918932105043021) * ddp_3_x - t51;
  const Scalar t52 = c_3 * (t49 + Scalar(0.918932105043021) * t16);
  const Scalar t53 = Scalar(0.26021797085) * t15 - Scalar(0.16073527663193116) * s_2 * qdd_1 +
      Scalar(0.24511057085) * qdd_2 + t50 + s_3 * f_3_x - t52;
  tau[1] = -t53;
  const Scalar t54 = s_5 * t41 + c_5 * t39;
  const Scalar U_4_yy_zz = t8 - Uz_o_5_y;
  const Scalar t55 = Scalar(0.000035853228) * U_4_yy_zz + Scalar(0.0056155871391398) * t5 -
      s_5 * t43 - c_5 * t46 - Scalar(0.22270588235294117) * t54;
  const Scalar t56 = Scalar(0.4462748022139784) * t31 + t54;
  const Scalar t57 = Scalar(-0.000035853228) * Uz_o_5_x - Scalar(0.0017106935695699) * t36 +
      Scalar(0.0039048935695699) * t34 - mu_5_z;
  const Scalar mu_3_y = c_4 * t57 + Scalar(0.0534495715) * t26 + Scalar(0.0575445715) * t27 +
      Scalar(0.047511847575) * (t8 - t21) - s_4 * t55 - Scalar(0.25682352941176473) * t51 -
      Scalar(0.9229411764705883) * t56;
  const Scalar t58 = Scalar(0.004095) * t2 * t25 + s_4 * t57 + Scalar(0.047511847575) * U_3_yx +
      c_4 * t55 - Scalar(0.25682352941176473) * t49;
  const Scalar mu_2_x = Scalar(0.0151074) * c_2 * t28 + Scalar(0.16073527663193116) * U_2_yx -
      c_3 * t58 - s_3 * mu_3_y;
  const Scalar t59 = Scalar(0.16073527663193116) * (t8 - t14) + s_3 * t58 +
      Scalar(0.673821534193021) * t29 + Scalar(0.658714134193021) * t30 - c_3 * mu_3_y + t56;
  tau[0] = Scalar(0.1252186854919588) * qdd_1 + s_2 * mu_2_x - c_2 * t59;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..5], qd[0..5], qdd[0..5], h_e[0..5]. Operations: 222 mul, 156 add, 12 sin/cos.
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
  const Scalar t1 = c_2 * s_3 + s_2 * c_3;
  const Scalar t2 = s_2 * s_3 - c_2 * c_3;
  const Scalar t3 = s_4 * t1 + c_4 * t2;
  const Scalar t4 = qd_1 * t3;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar t5 = omega_4_z * t4;
  const Scalar t6 = s_4 * t2 - c_4 * t1;
  const Scalar t7 = qdd_1 * t6 + Scalar(2.0) * t5;
  const Scalar t8 = qd_1 * qd_1;
  const Scalar t9 = t8 * t6;
  const Scalar t10 = t3 * t9;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar domega_4_z = qdd_4 + domega_3_z;
  const Scalar Uz_o_5_x = domega_4_z - t10;
  const Scalar Uz_5_x = s_5 * t7 + c_5 * Uz_o_5_x;
  const Scalar t11 = qd_1 * t6;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t11;
  const Scalar omega_5_z = qd_5 + t4;
  const Scalar t12 = omega_r_5_x * omega_5_z;
  const Scalar domega_5_y = Uz_5_x - t12;
  const Scalar domega_6_z = qdd_6 + domega_5_y;
  const Scalar mu_e1_x = s_1 * h_e_5 + c_1 * h_e_4;
  const Scalar mu_e2_x = s_2 * h_e_6 + c_2 * mu_e1_x;
  const Scalar t13 = s_2 * mu_e1_x - c_2 * h_e_6;
  const Scalar t14 = s_3 * mu_e2_x + c_3 * t13;
  const Scalar t15 = s_3 * t13 - c_3 * mu_e2_x;
  const Scalar t16 = s_4 * t14 + c_4 * t15;
  const Scalar t17 = s_1 * h_e_4 - c_1 * h_e_5;
  const Scalar tau_6 = Scalar(0.0001321171875) * domega_6_z + s_5 * t16 + c_5 * t17;
  tau[5] = tau_6;
  const Scalar f_e1_x = s_1 * h_e_2 + c_1 * h_e_1;
  const Scalar f_e2_x = s_2 * h_e_3 + c_2 * f_e1_x;
  const Scalar t18 = s_2 * f_e1_x - c_2 * h_e_3;
  const Scalar t19 = s_3 * f_e2_x + c_3 * t18;
  const Scalar t20 = s_3 * t18 - c_3 * f_e2_x;
  const Scalar t21 = s_4 * t19 + c_4 * t20;
  const Scalar t22 = s_1 * h_e_1 - c_1 * h_e_2;
  const Scalar f_e5_x = s_5 * t22 - c_5 * t21;
  const Scalar f_e4_y = s_4 * t20 - c_4 * t19;
  const Scalar t23 = s_6 * f_e5_x - c_6 * f_e4_y;
  const Scalar mu_e5_x = s_5 * t17 - c_5 * t16;
  const Scalar omega_r_5_y = s_5 * t11 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t24 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar t25 = (s_6 * omega_r_5_x + c_6 * omega_5_z) * t24;
  const Scalar mu_e4_y = s_4 * t15 - c_4 * t14;
  const Scalar t26 = Scalar(0.0823) * t23 - t25 + s_6 * mu_e4_y + c_6 * mu_e5_x;
  const Scalar f_e6_x = s_6 * f_e4_y + c_6 * f_e5_x;
  const Scalar t27 = (s_6 * omega_5_z - c_6 * omega_r_5_x) * t24;
  const Scalar mu_6_y = t27 + Scalar(0.0823) * f_e6_x - s_6 * mu_e5_x + c_6 * mu_e4_y;
  const Scalar t28 = s_2 * t8;
  const Scalar t29 = qd_2 * qd_2 - s_2 * t28 + t8;
  const Scalar ddp_o_3_x = Scalar(9.81) * s_2 + Scalar(0.425) * t29;
  const Scalar t30 = c_2 * t28;
  const Scalar U_2_yx = t30 + qdd_2;
  const Scalar ddp_o_3_y = Scalar(9.81) * c_2 - Scalar(0.425) * U_2_yx;
  const Scalar t31 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t32 = t8 * t1;
  const Scalar t33 = t2 * t32;
  const Scalar U_3_yx = domega_3_z - t33;
  const Scalar t34 = qdd_1 * t1;
  const Scalar t35 = Scalar(0.10915) * t34 + Scalar(0.39225) * U_3_yx + t31;
  const Scalar ddp_3_x = s_3 * ddp_o_3_y + c_3 * ddp_o_3_x;
  const Scalar t36 = t8 - t1 * t32 + omega_3_z * omega_3_z;
  const Scalar t37 = qdd_1 * t2;
  const Scalar t38 = Scalar(0.10915) * t37 - Scalar(0.39225) * t36 - ddp_3_x;
  const Scalar t39 = s_4 * t35 + c_4 * t38;
  const Scalar ddp_o_5_x = Scalar(0.09465) * Uz_o_5_x - t39;
  const Scalar t40 = qd_1 * omega_3_z;
  const Scalar t41 = t1 * t40;
  const Scalar t42 = t37 + t41;
  const Scalar U_3_zx = t41 + t42;
  const Scalar t43 = qd_1 * qd_2;
  const Scalar t44 = s_2 * t43;
  const Scalar t45 = t44 - c_2 * qdd_1;
  const Scalar U_2_zx = t44 + t45;
  const Scalar t46 = Scalar(0.10915) * t8 + Scalar(0.425) * U_2_zx + Scalar(0.39225) * U_3_zx;
  const Scalar t47 = Scalar(0.09465) * t7 - t46;
  const Scalar ddp_5_x = s_5 * t47 + c_5 * ddp_o_5_x;
  const Scalar t48 = omega_4_z * t11;
  const Scalar t49 = qdd_1 * t3;
  const Scalar t50 = t48 - t49;
  const Scalar domega_5_z = qdd_5 - t50;
  const Scalar t51 = omega_r_5_x * omega_r_5_y;
  const Scalar mu_5_z = Scalar(0.000035853228) * Uz_5_x - Scalar(0.0016432000421699) * t51 +
      Scalar(0.0038374000421699) * domega_5_z - Scalar(0.0351648539) * ddp_5_x - s_6 * t26 -
      c_6 * mu_6_y;
  tau[4] = mu_5_z;
  const Scalar t52 = domega_5_z - t51;
  const Scalar t53 = Scalar(0.0351648539) * t52 - s_6 * t23 - c_6 * f_e6_x -
      Scalar(1.5941610670892763) * ddp_5_x;
  const Scalar t54 = s_5 * ddp_o_5_x - c_5 * t47;
  const Scalar t55 = omega_5_z * omega_5_z + omega_r_5_x * omega_r_5_x;
  const Scalar t56 = Scalar(0.0351648539) * t55 - s_5 * t21 - c_5 * t22 +
      Scalar(1.5941610670892763) * t54;
  const Scalar t57 = s_5 * t56 - c_5 * t53;
  const Scalar t58 = s_4 * t38 - c_4 * t35;
  const Scalar Uz_o_5_y = t6 * t9 + omega_4_z * omega_4_z;
  const Scalar ddp_o_5_y = Scalar(0.09465) * Uz_o_5_y + t58;
  const Scalar U_5_yy_zz = Uz_o_5_y - t55;
  const Scalar t59 = omega_r_5_y * omega_5_z;
  const Scalar mu_5_x = Scalar(0.000035853228) * U_5_yy_zz + Scalar(0.0054806000843398) * t59 -
      Scalar(0.0351648539) * ddp_o_5_y - s_6 * mu_6_y + c_6 * t26;
  const Scalar t60 = Scalar(0.0038374000421699) * t12 - Scalar(0.000035853228) * t52 +
      Scalar(0.0016432000421699) * domega_5_y - tau_6;
  const Scalar tau_4 = Scalar(0.000035853228) * t49 - Scalar(0.0017106935695699) * t10 +
      Scalar(0.0039048935695699) * domega_4_z + Scalar(0.09465) * t57 + s_5 * mu_5_x - c_5 * t60;
  tau[3] = tau_4;
  const Scalar t61 = Scalar(2.4707255485895) * t39 - t57;
  const Scalar U_5_zy = s_5 * Uz_o_5_x - c_5 * t7 + Scalar(2.0) * t59;
  const Scalar t62 = s_6 * f_e6_x - Scalar(0.0351648539) * U_5_zy - c_6 * t23 +
      Scalar(2.4707255485895) * t58 + Scalar(1.5941610670892763) * ddp_o_5_y;
  const Scalar t63 = s_4 * t61 - c_4 * t62;
  const Scalar t64 = Scalar(0.047511847575) * t34 - Scalar(0.0575445715) * t33 +
      Scalar(0.0534495715) * domega_3_z - tau_4 - Scalar(0.39225) * t63;
  tau[2] = -t64;
  const Scalar t65 = s_4 * t62 + c_4 * t61;
  const Scalar f_3_x = Scalar(5.087513384321224) * ddp_3_x - t65;
  const Scalar f_u_3_t_y = s_3 * f_3_x - c_3 * (Scalar(5.087513384321224) * t31 + t63);
  const Scalar t66 = Scalar(0.26021797085) * t30 - Scalar(0.16073527663193116) * s_2 * qdd_1 +
      Scalar(0.24511057085) * qdd_2 + t64 + Scalar(0.425) * f_u_3_t_y;
  tau[1] = -t66;
  const Scalar t67 = s_5 * t53 + c_5 * t56;
  const Scalar U_4_yy_zz = t8 - Uz_o_5_y;
  const Scalar t68 = Scalar(0.000035853228) * U_4_yy_zz + Scalar(0.0056155871391398) * t5 -
      Scalar(0.09465) * t67 - s_5 * t60 - c_5 * mu_5_x;
  const Scalar t69 = Scalar(2.4707255485895) * t46 + t67;
  const Scalar t70 = Scalar(-0.000035853228) * Uz_o_5_x - Scalar(0.0017106935695699) * t50 +
      Scalar(0.0039048935695699) * t48 - mu_5_z;
  const Scalar mu_3_y = Scalar(0.0534495715) * t41 + Scalar(0.0575445715) * t42 +
      Scalar(0.047511847575) * (t8 - t36) - Scalar(0.10915) * t65 - s_4 * t68 + c_4 * t70 -
      Scalar(0.39225) * t69;
  const Scalar t71 = Scalar(0.004095) * t2 * t40 + Scalar(0.047511847575) * U_3_yx -
      Scalar(0.10915) * t63 + s_4 * t70 + c_4 * t68;
  const Scalar mu_2_x = Scalar(0.0151074) * c_2 * t43 + Scalar(0.16073527663193116) * U_2_yx -
      c_3 * t71 - s_3 * mu_3_y;
  const Scalar t72 = Scalar(0.16073527663193116) * (t8 - t29) + Scalar(0.673821534193021) * t44 +
      Scalar(0.658714134193021) * t45 + s_3 * t71 + Scalar(0.425) * t69 - c_3 * mu_3_y;
  tau[0] = Scalar(0.1252186854919588) * qdd_1 + s_2 * mu_2_x - c_2 * t72;
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
// Reads q[1..4]. Operations: 75 mul, 66 add, 8 sin/cos. Always zero: 2 of the 36 entries of B.
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
  const Scalar t7 = Scalar(0.0149450629075) * s_5;
  const Scalar hu_4_t_x = Scalar(0.064127121625) * s_4 - c_4 * t7;
  const Scalar t8 = t4 + Scalar(0.9229411764705883) * hu_4_t_x;
  B[15] = B[20] = -t8;
  const Scalar t9 = Scalar(1.8458823529411765) * hu_4_t_x;
  const Scalar t10 = t4 + t9 - Scalar(0.57197413724375);
  B[14] = -t10;
  const Scalar f_3_3_x = s_4 * t7 + Scalar(0.064127121625) * c_4;
  const Scalar t11 = s_3 * f_3_3_x;
  B[9] = B[19] = -t11 - t8 - c_3 * hu_4_t_x;
  const Scalar t12 = s_5 * (s_2 * (s_3 * s_4 - c_3 * c_4) - c_2 * t5);
  B[5] = B[30] = Scalar(0.0001321171875) * t12;
  const Scalar t13 = Scalar(0.003838243803185) * c_5 + Scalar(0.0038374000421699);
  const Scalar t14 = Scalar(0.003292500193635) * s_5;
  const Scalar t15 = c_4 * t13 - t14 * (s_4 - Scalar(4.189343395921486));
  const Scalar mu_5_3_x = c_4 * t14 + s_4 * t13;
  const Scalar mu_u_5_3_t_x = c_3 * mu_5_3_x + s_3 * t15;
  B[4] = B[24] = s_2 * mu_u_5_3_t_x - c_2 * (c_3 * t15 - s_3 * mu_5_3_x + t7);
  const Scalar hc_3_x = hu_4_t_x - Scalar(0.677642004375);
  const Scalar hu_3_t_x = t11 + c_3 * hc_3_x;
  B[8] = B[13] = -hu_3_t_x - t10;
  const Scalar t16 = Scalar(2.0) * hu_3_t_x;
  B[7] = -t10 - t16 + Scalar(1.40804167915);
  const Scalar Ic_4_yz = Scalar(0.003292500193635) * c_5 - Scalar(0.000035853228);
  const Scalar t17 = s_4 * s_5;
  const Scalar Ic_3_yz = t2 * t17 + c_4 * Ic_4_yz + Scalar(0.25682352941176473) * f_3_3_x;
  const Scalar t18 = s_3 * Ic_3_yz;
  const Scalar t19 = s_4 * Ic_4_yz - c_4 * s_5 * t2 + Scalar(0.25682352941176473) * hu_4_t_x;
  const Scalar t20 = c_3 * Ic_3_yz;
  const Scalar mu_u_4_3_t_y = t20 - s_3 * t19;
  B[3] = B[18] = c_2 * mu_u_4_3_t_y - s_2 * (t18 + c_3 * t19);
  const Scalar t21 = t19 - t1 - Scalar(0.12652256366625);
  const Scalar t22 = c_2 * (s_3 * t21 - t20);
  const Scalar t23 = t18 + c_3 * t21;
  B[2] = B[12] = -t22 - s_2 * t23;
  B[1] = B[6] = -t22 - s_2 * (t23 - t6 - Scalar(0.349300285625));
  const Scalar Iu_5_t_xx = t3 - Scalar(0.0015110828546699);
  const Scalar Iu_4_t_d = Iu_5_t_xx + Scalar(0.01215478073165);
  const Scalar Iu_4_t_g = Scalar(0.00658500038727) * t17 + c_4 * Iu_4_t_d;
  const Scalar t24 = c_4 * Iu_4_t_g;
  const Scalar t25 = Scalar(0.00767648760637) * c_5;
  const Scalar Ic_3_xx = t24 + t25 - Scalar(0.01215478073165);
  const Scalar Ic_3_yy = Iu_5_t_xx - t24 + t25 - t9 + Scalar(0.56787913724375);
  const Scalar Iu_3_t_d = Ic_3_xx - Ic_3_yy;
  const Scalar t26 = t14 - s_4 * Iu_4_t_g + Scalar(0.9229411764705883) * f_3_3_x;
  const Scalar Iu_3_t_g = Scalar(2.0) * s_3 * t26 + c_3 * Iu_3_t_d;
  const Scalar t27 = s_2 * (t26 + c_3 * f_3_3_x - s_3 * (Iu_3_t_g + hc_3_x));
  const Scalar t28 = c_3 * Iu_3_t_g;
  const Scalar Iu_3_t_xx = t28 + Ic_3_yy;
  const Scalar t29 = Scalar(2.0) * t27 -
      c_2 * (Ic_3_xx - t28 - Iu_3_t_xx - t16 + Scalar(1.39293427915));
  B[0] = Scalar(0.1879281038293699) + Iu_3_t_xx - c_2 * t29;
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
// Reads q[1..4]. Operations: 172 mul, 117 add, 8 sin/cos. Always zero: 45 of the 126 entries of c.
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
  const Scalar t1 = c_5 * s_5;
  c[74] = c[75] = c[76] = Scalar(0.0015110828546699) * t1;
  c[91] = c[92] = c[93] = Scalar(-0.0015110828546699) * t1;
  const Scalar t2 = Scalar(0.00075554142733495) * s_5;
  const Scalar dmu_3_5_y = t2 + Scalar(0.0068967069711375) * c_4;
  const Scalar t3 = Scalar(2.0) * c_5;
  const Scalar db_33_5r = t3 * dmu_3_5_y;
  c[54] = c[55] = db_33_5r;
  const Scalar t4 = s_4 - Scalar(0.23870089068696182);
  c[56] = Scalar(-0.013793413942275) * s_5 * t4;
  const Scalar t5 = Scalar(0.00747253145375) * s_5;
  const Scalar f_3_3_x = s_4 * t5 + Scalar(0.0320635608125) * c_4;
  const Scalar c_4_3_3 = Scalar(1.8458823529411765) * f_3_3_x;
  c[68] = c_4_3_3;
  c[50] = c[51] = Scalar(-1.8458823529411765) * f_3_3_x;
  c[89] = -db_33_5r;
  const Scalar t6 = c_3 + Scalar(0.9229411764705883);
  const Scalar t7 = s_3 * c_4;
  const Scalar t8 = t7 + s_4 * t6;
  const Scalar t9 = Scalar(0.0149450629075) * s_5;
  const Scalar t10 = s_3 * s_4;
  const Scalar t11 = c_4 * t6 - t10;
  const Scalar c_4_2_2 = t8 * t9 + Scalar(0.064127121625) * t11;
  c[65] = c_4_2_2;
  const Scalar t12 = t2 + Scalar(0.00747253145375) * t11;
  const Scalar db_22_5r = t12 * t3;
  c[32] = c[34] = db_22_5r;
  const Scalar t13 = t10 - c_3 * c_4;
  const Scalar c_1_2_6 = c_5_2_6 * (s_2 * (t7 + c_3 * s_4) + c_2 * t13);
  c[16] = c[106] = c_1_2_6;
  const Scalar hu_4_t_x = Scalar(0.0320635608125) * s_4 - c_4 * t5;
  const Scalar hc_3_x = hu_4_t_x - Scalar(0.3388210021875);
  const Scalar t14 = Scalar(2.0) * s_3;
  const Scalar t15 = c_3 * f_3_3_x;
  const Scalar c_2_3_3 = hc_3_x * t14 - Scalar(2.0) * t15;
  c[25] = c[26] = c_2_3_3;
  c[28] = c[30] = -c_4_2_2;
  c[86] = -db_22_5r;
  const Scalar t16 = s_2 * s_3 - c_2 * c_3;
  const Scalar w_1_3_x = s_2 * c_3 + c_2 * s_3;
  const Scalar t17 = s_4 * t16 - c_4 * w_1_3_x;
  const Scalar t18 = c_5 * t17;
  c[99] = Scalar(-0.00006605859375) * t18;
  c[19] = c[115] = Scalar(0.00006605859375) * t18;
  const Scalar t19 = s_4 * w_1_3_x + c_4 * t16;
  const Scalar t20 = s_5 * t19;
  c[57] = c[78] = Scalar(-0.00006605859375) * t20;
  c[17] = c[18] = c[108] = c[111] = Scalar(0.00006605859375) * t20;
  c[36] = -c_1_2_6;
  const Scalar t21 = t8 - Scalar(0.22030688087520184);
  c[35] = -t9 * t21;
  c[44] = -c_2_3_3;
  const Scalar t22 = Scalar(0.9229411764705883) * f_3_3_x + Scalar(0.5) * c_4_2_2;
  const Scalar f_u_4_3_t_x = t15 - s_3 * hu_4_t_x;
  const Scalar c_3_2_4 = f_u_4_3_t_x - t22;
  c[49] = c_3_2_4;
  const Scalar db_23_5r = c_5 * dmu_3_5_y + c_5 * t12;
  const Scalar t23 = Scalar(0.00747253145375) * c_5;
  const Scalar t24 = t23 * t13;
  c[33] = db_23_5r - t24;
  const Scalar c_3_2_5 = t24 + db_23_5r;
  c[53] = c_3_2_5;
  const Scalar Ic_4_yz = Scalar(0.0016462500968175) * c_5 - Scalar(0.000017926614);
  const Scalar t25 = Scalar(0.00075554142733495) * c_5;
  const Scalar t26 = c_4 * s_5;
  const Scalar t27 = s_4 * Ic_4_yz - t25 * t26 + Scalar(0.25682352941176473) * hu_4_t_x;
  const Scalar t28 = Scalar(0.0068967069711375) * c_5 - t27 + Scalar(0.063261281833125);
  const Scalar t29 = s_4 * s_5;
  const Scalar Ic_3_yz = t25 * t29 + c_4 * Ic_4_yz + Scalar(0.25682352941176473) * f_3_3_x;
  const Scalar t30 = Ic_3_yz * w_1_3_x;
  const Scalar t31 = t30 + t28 * t16;
  c[5] = Scalar(-2.0) * t31;
  const Scalar t32 = t25 + Scalar(0.0019191219015925);
  const Scalar t33 = t17 * (Ic_4_yz + Scalar(0.008234676853375)) - t20 * t32;
  c[9] = Scalar(2.0) * t33;
  const Scalar t34 = t30 - t27 * t16;
  c[8] = t33 - t34;
  const Scalar c_3_1_4 = t33 + t34;
  c[48] = c_3_1_4;
  const Scalar t35 = Scalar(-0.0016462500968175) * t20;
  const Scalar t36 = Scalar(0.0019191219015925) * c_5 + Scalar(0.00191870002108495);
  const Scalar t37 = t17 * t36 - t35;
  const Scalar t38 = Scalar(-0.0019191219015925) * t17;
  const Scalar t39 = t35 - t38 * (c_5 + Scalar(0.7873824239179353) * (c_5 * c_5 - Scalar(0.5)));
  const Scalar c_4_1_5 = t37 - t39;
  c[73] = c_4_1_5;
  c[29] = -f_u_4_3_t_x - t22;
  c[67] = -c_3_2_4;
  c[88] = -c_3_2_5;
  const Scalar v_o_1_4_z = c_2 - Scalar(0.9229411764705883) * t16;
  const Scalar Iu_5_t_xx = c_5 * t25 - Scalar(0.00075554142733495);
  const Scalar Iu_4_t_d = Iu_5_t_xx + Scalar(0.006077390365825);
  const Scalar t40 = t17 * (t5 * (Scalar(0.4406137617504037) * t17 + v_o_1_4_z) + Iu_4_t_d * t19);
  const Scalar t41 = t19 * (Iu_4_t_d * t17 - Scalar(0.003292500193635) * t20 +
      Scalar(0.0320635608125) * v_o_1_4_z);
  const Scalar c_1_1_4 = t40 + t41 + v_o_1_4_z * (t5 * t17 + Scalar(0.0320635608125) * t19);
  c[6] = c_1_1_4;
  const Scalar v_o_1_5_z = Scalar(0.22270588235294117) * t17 + v_o_1_4_z;
  const Scalar t42 = Scalar(0.0019191219015925) * t20 + t23 * v_o_1_5_z;
  const Scalar t43 = t42 - Scalar(0.000017926614) * t18;
  c[14] = Scalar(-2.0) * t43;
  const Scalar t44 = c_3 * Ic_3_yz;
  const Scalar mu_u_4_3_t_y = t44 - s_3 * t27;
  const Scalar t45 = s_3 * Ic_3_yz;
  const Scalar t46 = s_2 * mu_u_4_3_t_y + c_2 * (t45 + c_3 * t27);
  c[7] = t33 - t46;
  const Scalar c_2_1_4 = t33 + t46;
  c[27] = c_2_1_4;
  const Scalar t47 = t32 * t18;
  const Scalar t48 = s_5 * (t17 * t12 - Scalar(0.00747253145375) * t19 * t21) - t47;
  const Scalar mu_5_3_x = Scalar(0.0016462500968175) * t26 + s_4 * t36;
  const Scalar t49 = Scalar(0.0016462500968175) * s_5 * (s_4 - Scalar(4.189343395921486)) -
      c_4 * t36;
  const Scalar t50 = s_2 * (-s_3 * mu_5_3_x - c_3 * t49 + t5);
  const Scalar db_15_2 = t50 - c_2 * (s_3 * t49 - c_3 * mu_5_3_x);
  c[11] = db_15_2 + t48;
  const Scalar c_5_1_2 = db_15_2 - t48;
  c[85] = c_5_1_2;
  c[66] = -c_3_1_4;
  const Scalar t51 = t47 - s_5 * (t17 * dmu_3_5_y - Scalar(0.0068967069711375) * t19 * t4);
  const Scalar t52 = t16 * mu_5_3_x + w_1_3_x * t49;
  const Scalar c_3_1_5 = t52 - t51;
  c[52] = c_3_1_5;
  c[13] = -t37 - t39;
  c[90] = -c_4_1_5;
  c[63] = -c_1_1_4;
  const Scalar Iu_3_t_yz = t44 + s_3 * t28;
  const Scalar t53 = s_2 * Iu_3_t_yz;
  const Scalar t54 = t45 - c_3 * t28;
  const Scalar t55 = t53 + c_2 * t54;
  const Scalar c_3_1_2 = t31 - t55;
  c[43] = c_3_1_2;
  c[64] = -c_2_1_4;
  c[31] = -c_5_1_2;
  c[12] = -t52 - t51;
  c[87] = -c_3_1_5;
  c[2] = Scalar(-2.0) * (t53 + c_2 * (t54 - t23 - Scalar(0.1746501428125)));
  const Scalar t56 = c_5 * (Scalar(0.000017926614) * t19 - t17 * t2);
  const Scalar t57 = t17 * (s_5 * (t17 * t32 - t38) - t56);
  const Scalar c_5_1_1 = t57 + t19 * (t42 + t43);
  c[84] = c_5_1_1;
  c[4] = -t31 - t55;
  c[24] = -c_3_1_2;
  const Scalar Iu_4_t_g = Scalar(0.00658500038727) * t29 + Scalar(2.0) * c_4 * Iu_4_t_d;
  const Scalar t58 = s_4 * Iu_4_t_g - dI_4_xx - c_4_3_3;
  const Scalar t59 = Iu_5_t_xx - c_4 * Iu_4_t_g - Scalar(1.8458823529411765) * hu_4_t_x +
      Scalar(0.2900169589877);
  const Scalar t60 = t16 * (t58 * t16 + c_2 * f_3_3_x + t59 * w_1_3_x);
  const Scalar t61 = w_1_3_x * (t58 * w_1_3_x - t59 * t16 - c_2 * hc_3_x);
  const Scalar c_1_1_3 = t60 - t61 + c_2 * (f_3_3_x * t16 + hc_3_x * w_1_3_x);
  c[3] = c_1_1_3;
  c[10] = -c_5_1_1;
  c[42] = -c_1_1_3;
  const Scalar t62 = s_3 * t58 + c_3 * t59;
  const Scalar t63 = t59 + Scalar(2.0) * (s_3 * f_3_3_x + c_3 * (hc_3_x - t62)) -
      Scalar(0.696467139575);
  const Scalar t64 = t58 + c_2_3_3 - t14 * t62;
  const Scalar t65 = c_2 * (c_2 * t64 + s_2 * t63);
  const Scalar db_11_2r = t65 - s_2 * (s_2 * t64 - c_2 * t63);
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
// Reads q[1..4], qd[0..5]. Operations: 252 mul, 196 add, 8 sin/cos. Always zero: 2 of the 36
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
  const Scalar t3 = Scalar(0.00747253145375) * s_5;
  const Scalar f_3_3_x = s_4 * t3 + Scalar(0.0320635608125) * c_4;
  const Scalar t4 = Scalar(1.8458823529411765) * f_3_3_x;
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
  const Scalar t14 = s_3 * s_4;
  const Scalar t15 = t14 - c_3 * c_4;
  const Scalar t16 = s_3 * c_4;
  const Scalar t17 = c_2 * t15 + s_2 * (t16 + c_3 * s_4);
  const Scalar t18 = t17 * t11;
  const Scalar t19 = qd_1 * t18;
  C[11] = -t19 - t13;
  const Scalar t20 = c_4 * w_1_3_x + s_4 * t9;
  const Scalar t21 = c_5 * t20;
  const Scalar t22 = Scalar(-0.00006605859375) * t21;
  const Scalar t23 = qd_3 + qd_4;
  const Scalar t24 = qd_2 + t23;
  const Scalar C_65 = qd_1 * t22 - t11 * t24;
  C[34] = C_65;
  C[31] = t19 - t13;
  const Scalar t25 = s_5 * t10;
  C[5] = C[30] = qd_2 * t18 - Scalar(0.00006605859375) * (qd_5 * t21 + t25 * t23);
  C[29] = -C_65;
  const Scalar hu_4_t_x = Scalar(0.0320635608125) * s_4 - c_4 * t3;
  const Scalar hc_3_x = hu_4_t_x - Scalar(0.3388210021875);
  const Scalar t26 = c_3 * f_3_3_x;
  const Scalar t27 = t26 - s_3 * hc_3_x;
  const Scalar t28 = c_3 + Scalar(0.9229411764705883);
  const Scalar t29 = t16 + s_4 * t28;
  const Scalar t30 = t14 - c_4 * t28;
  const Scalar t31 = Scalar(0.0320635608125) * t30 - t3 * t29;
  const Scalar t32 = qd_4 * t31;
  const Scalar t33 = Scalar(0.00747253145375) * t30 - t5;
  const Scalar t34 = t33 * t6;
  C[7] = -qd_5 * t34 - Scalar(2.0) * (qd_3 * t27 - t32);
  const Scalar t35 = Scalar(-0.0016462500968175) * t25;
  const Scalar t36 = Scalar(0.0019191219015925) * c_5 + Scalar(0.00191870002108495);
  const Scalar t37 = t20 * t36 - t35;
  const Scalar t38 = Scalar(0.0019191219015925) * t21 + t35 +
      Scalar(0.0015110828546699) * t20 * (c_5 * c_5 - Scalar(0.5));
  const Scalar t39 = t37 - t38;
  const Scalar t40 = qd_6 * t11;
  const Scalar C_54 = t40 - t2 * t24 + qd_1 * t39;
  C[27] = C_54;
  const Scalar v_o_1_4_z = c_2 + Scalar(0.9229411764705883) * t9;
  const Scalar t41 = Scalar(0.00075554142733495) * c_5;
  const Scalar Iu_5_t_xx = c_5 * t41 - Scalar(0.00075554142733495);
  const Scalar Iu_4_t_d = Iu_5_t_xx + Scalar(0.006077390365825);
  const Scalar t42 = Scalar(0.003292500193635) * s_5;
  const Scalar t43 = t20 * (t3 * v_o_1_4_z - t42 * t20 - Iu_4_t_d * t10);
  const Scalar t44 = t10 * (Scalar(0.003292500193635) * t25 - Iu_4_t_d * t20 +
      Scalar(0.0320635608125) * v_o_1_4_z);
  const Scalar t45 = t43 + v_o_1_4_z * (t3 * t20 + Scalar(0.0320635608125) * t10) + t44;
  const Scalar t46 = t10 * t40;
  const Scalar t47 = t46 + qd_1 * t45;
  const Scalar t48 = Scalar(0.00075554142733495) * t1;
  const Scalar Ic_4_yz = Scalar(0.0016462500968175) * c_5 - Scalar(0.000017926614);
  const Scalar Ic_3_yz = s_4 * t48 + c_4 * Ic_4_yz + Scalar(0.25682352941176473) * f_3_3_x;
  const Scalar t49 = s_3 * Ic_3_yz;
  const Scalar t50 = s_4 * Ic_4_yz - c_4 * t48 + Scalar(0.25682352941176473) * hu_4_t_x;
  const Scalar t51 = c_3 * Ic_3_yz;
  const Scalar mu_u_4_3_t_y = t51 - s_3 * t50;
  const Scalar t52 = c_2 * (t49 + c_3 * t50) + s_2 * mu_u_4_3_t_y;
  const Scalar t53 = t41 + Scalar(0.0019191219015925);
  const Scalar t54 = t25 * t53 - t20 * (Ic_4_yz + Scalar(0.008234676853375));
  const Scalar t55 = t54 + t52;
  const Scalar t56 = Ic_3_yz * w_1_3_x;
  const Scalar t57 = t56 + t50 * t9;
  const Scalar t58 = t54 + t57;
  C[18] = -qd_5 * t39 - qd_2 * t55 - qd_3 * t58 + t47;
  const Scalar t59 = t54 - t52;
  const Scalar t60 = t54 - t57;
  const Scalar t61 = t37 + t38;
  const Scalar t62 = -qd_5 * t61 - qd_2 * t59 - qd_3 * t60 - Scalar(2.0) * qd_4 * t54 + t47;
  C[3] = -t62;
  const Scalar t63 = Scalar(2.0) * qd_2;
  const Scalar t64 = qd_1 * t55 + t31 * t63;
  const Scalar t65 = Scalar(0.9229411764705883) * f_3_3_x;
  const Scalar t66 = t65 - t31;
  const Scalar f_u_4_3_t_x = t26 - s_3 * hu_4_t_x;
  const Scalar t67 = f_u_4_3_t_x + t66;
  C[9] = t64 + Scalar(2.0) * (t32 - c_5 * qd_5 * t33) - qd_3 * t67;
  const Scalar c_3_2_4 = f_u_4_3_t_x - t66;
  const Scalar t68 = qd_1 * t58 + qd_2 * c_3_2_4 - qd_3 * t4;
  C[15] = t68 - t8;
  C[20] = C_44 - t68;
  C[22] = qd_5 * t42 - C_54;
  const Scalar t69 = Scalar(0.0068967069711375) * c_5 - t50 + Scalar(0.063261281833125);
  const Scalar Iu_3_t_yz = t51 + s_3 * t69;
  const Scalar t70 = s_2 * Iu_3_t_yz;
  const Scalar t71 = c_3 * t69 - t49;
  const Scalar t72 = t70 - c_2 * t71;
  const Scalar t73 = t69 * t9 - t56;
  const Scalar t74 = t73 + t72;
  const Scalar t75 = qd_1 * t74 - t27 * t63;
  const Scalar t76 = c_5 * (t33 - dmu_3_5_y);
  const Scalar t77 = Scalar(0.00747253145375) * c_5;
  const Scalar t78 = t77 * t15;
  const Scalar t79 = t78 + t76;
  const Scalar t80 = Scalar(2.0) * qd_3;
  C[8] = -qd_5 * t79 - qd_4 * t67 + t75 - t27 * t80;
  C[19] = C_44 - t64 - qd_3 * c_3_2_4;
  const Scalar t81 = Scalar(-0.00747253145375) * t10;
  const Scalar t82 = t29 - Scalar(0.22030688087520184);
  const Scalar t83 = t53 * t21;
  const Scalar t84 = t83 - s_5 * (t82 * t81 - t20 * t33);
  const Scalar t85 = Scalar(0.0016462500968175) * s_5;
  const Scalar mu_5_3_x = c_4 * t85 + s_4 * t36;
  const Scalar t86 = c_4 * t36 - s_4 * t85 + Scalar(0.0068967069711375) * s_5;
  const Scalar mu_u_5_3_t_x = c_3 * mu_5_3_x + s_3 * t86;
  const Scalar db_15_2 = c_2 * mu_u_5_3_t_x + s_2 * (c_3 * t86 - s_3 * mu_5_3_x + t3);
  const Scalar c_5_1_2 = db_15_2 - t84;
  const Scalar t87 = t40 + qd_1 * c_5_1_2 + qd_2 * t34;
  const Scalar t88 = t78 - t76;
  const Scalar t89 = qd_4 * t2;
  C[25] = -t89 - qd_3 * t88 + t87;
  const Scalar t90 = Scalar(0.9229411764705883) * s_4 - Scalar(0.22030688087520184);
  const Scalar t91 = t83 - s_5 * (t90 * t81 + t20 * dmu_3_5_y);
  const Scalar t92 = t9 * mu_5_3_x + w_1_3_x * t86;
  const Scalar t93 = t92 - t91;
  const Scalar t94 = t40 + qd_1 * t93 - qd_2 * t88 - qd_3 * t7;
  C[26] = t94 - t89;
  const Scalar t95 = qd_5 * Scalar(0.0149450629075) * s_5;
  C[10] = -qd_3 * t79 - qd_4 * t34 - t82 * t95 - t87;
  C[13] = qd_5 * t88 + qd_4 * c_3_2_4 - t75;
  C[16] = qd_4 * t7 - t90 * t95 - t94;
  const Scalar v_o_1_5_z = v_o_1_4_z - Scalar(0.22270588235294117) * t20;
  const Scalar t96 = Scalar(0.00747253145375) *
      (c_5 * v_o_1_5_z - Scalar(0.25682352941176473) * t25);
  const Scalar t97 = Scalar(0.000017926614) * t21 + t96;
  const Scalar t98 = c_5 * (Scalar(0.000017926614) * t10 - t20 * t5);
  const Scalar t99 = t20 * (t98 - s_5 * t20 * (Scalar(0.0019191219015925) + t53));
  const Scalar t100 = t99 + t10 * (t96 + t97);
  const Scalar t101 = qd_6 * t22 + qd_1 * t100;
  const Scalar c_1_2_5 = db_15_2 + t84;
  const Scalar t102 = t92 + t91;
  C[4] = qd_4 * t61 + t101 + qd_3 * t102 + qd_2 * c_1_2_5 - Scalar(2.0) * qd_5 * t97;
  const Scalar Iu_4_t_g = s_4 * t42 + c_4 * Iu_4_t_d;
  const Scalar t103 = s_4 * Iu_4_t_g - t85 - t65;
  const Scalar t104 = Scalar(-2.0) * t103;
  const Scalar t105 = Iu_5_t_xx - Scalar(2.0) * c_4 * Iu_4_t_g -
      Scalar(1.8458823529411765) * hu_4_t_x + Scalar(0.2900169589877);
  const Scalar dmu_1_3_x = t104 * w_1_3_x + c_2 * hc_3_x - t105 * t9;
  const Scalar t106 = t9 * (c_2 * f_3_3_x + t104 * t9 + t105 * w_1_3_x);
  const Scalar c_3_1_1 = c_2 * (f_3_3_x * t9 - hc_3_x * w_1_3_x) - w_1_3_x * dmu_1_3_x + t106;
  const Scalar t107 = t46 + qd_1 * c_3_1_1;
  C[12] = qd_4 * t58 - qd_5 * t93 - qd_2 * t74 + t107;
  C[24] = qd_4 * t39 - t101 + qd_3 * t93 + qd_2 * c_5_1_2;
  const Scalar t108 = t73 - t72;
  const Scalar t109 = -qd_5 * t102 - qd_4 * t60 - qd_2 * t108 - t73 * t80 + t107;
  C[2] = -t109;
  const Scalar t110 = c_3 * t105 - s_3 * t104;
  const Scalar t111 = t105 + Scalar(2.0) * (s_3 * f_3_3_x + c_3 * (hc_3_x - t110)) -
      Scalar(0.696467139575);
  const Scalar t112 = Scalar(-2.0) * (t103 - t27 - s_3 * t110);
  const Scalar t113 = s_2 * (s_2 * t112 + c_2 * t111);
  const Scalar t114 = t113 - c_2 * (c_2 * t112 - s_2 * t111);
  C[0] = qd_5 * t100 - qd_4 * t45 - qd_3 * c_3_1_1 + qd_2 * t114;
  const Scalar t115 = t17 * t40 + qd_1 * t114;
  const Scalar t116 = (c_2 * (t77 + t71 + Scalar(0.1746501428125)) - t70) * t63;
  C[1] = qd_4 * t59 + qd_5 * c_1_2_5 + qd_3 * t108 + t116 + t115;
  C[6] = qd_4 * t55 - qd_5 * c_5_1_2 + qd_3 * t74 - t115;
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
// Reads q[1..4], qd[0..5]. Operations: 132 mul, 94 add, 8 sin/cos.
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
  const Scalar t3 = c_3 * t1 - s_3 * t2;
  const Scalar omega_r_3_x = c_3 * t2 + s_3 * t1;
  const Scalar t4 = c_4 * t3 - s_4 * omega_r_3_x;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar t5 = t4 * omega_4_z;
  const Scalar t6 = Scalar(-2.0) * t5;
  const Scalar t7 = c_4 * omega_r_3_x + s_4 * t3;
  const Scalar t8 = t7 * t4;
  const Scalar t9 = c_5 * t8 - s_5 * t6;
  const Scalar omega_r_5_x = c_5 * t7 + s_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 - t4;
  const Scalar t10 = omega_r_5_x * omega_5_z;
  const Scalar N_6_z = Scalar(-0.0001321171875) * (t9 + t10);
  n[5] = N_6_z;
  const Scalar t11 = qd_1 * qd_1;
  const Scalar t12 = t11 - t2 * t2 + qd_2 * qd_2;
  const Scalar ddp_o_3_x = t12 + Scalar(23.08235294117647) * s_2;
  const Scalar t13 = t2 * t1;
  const Scalar ddp_o_3_y = Scalar(23.08235294117647) * c_2 - t13;
  const Scalar ddp_3_x = c_3 * ddp_o_3_x + s_3 * ddp_o_3_y;
  const Scalar t14 = t11 - omega_r_3_x * omega_r_3_x + omega_3_z * omega_3_z;
  const Scalar ddp_o_4_x = Scalar(0.9229411764705883) * t14 + ddp_3_x;
  const Scalar t15 = c_3 * ddp_o_3_y - s_3 * ddp_o_3_x;
  const Scalar t16 = omega_r_3_x * t3;
  const Scalar t17 = t15 - Scalar(0.9229411764705883) * t16;
  const Scalar t18 = s_4 * t17 + c_4 * ddp_o_4_x;
  const Scalar t19 = t18 - Scalar(0.22270588235294117) * t8;
  const Scalar t20 = omega_r_3_x * omega_3_z;
  const Scalar t21 = qd_2 * t2;
  const Scalar t22 = Scalar(0.25682352941176473) * t11 + Scalar(2.0) * t21 +
      Scalar(1.8458823529411765) * t20;
  const Scalar t23 = Scalar(0.44541176470588234) * t5 + t22;
  const Scalar t24 = c_5 * t19 - s_5 * t23;
  const Scalar omega_r_5_y = c_5 * omega_4_z - s_5 * t7;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t25 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar t26 = omega_r_5_x * omega_r_5_y;
  const Scalar t27 = t7 * omega_4_z;
  const Scalar t28 = Scalar(0.000035853228) * t9 - omega_r_5_x * t25 +
      Scalar(0.0016432000421699) * t26 - Scalar(0.0038374000421699) * t27 +
      Scalar(0.0149450629075) * t24;
  n[4] = -t28;
  const Scalar t29 = t27 - t26;
  const Scalar t30 = Scalar(0.0149450629075) * t29 - Scalar(0.28794534274300054) * t24;
  const Scalar t31 = omega_r_5_x * omega_r_5_x + omega_5_z * omega_5_z;
  const Scalar t32 = Scalar(0.0149450629075) * t31 +
      Scalar(0.28794534274300054) * (c_5 * t23 + s_5 * t19);
  const Scalar t33 = c_5 * t30 - s_5 * t32;
  const Scalar t34 = Scalar(-0.000035853228) * t29 - N_6_z + Scalar(0.0021942) * t10;
  const Scalar t35 = c_4 * t17 - s_4 * ddp_o_4_x;
  const Scalar Uz_o_5_y = t7 * t7 + omega_4_z * omega_4_z;
  const Scalar ddp_o_5_y = Scalar(0.22270588235294117) * Uz_o_5_y + t35;
  const Scalar U_5_yy_zz = Uz_o_5_y - t31;
  const Scalar t36 = omega_r_5_y * omega_5_z;
  const Scalar t37 = s_5 * t8 + c_5 * t6 - t36;
  const Scalar t38 = Scalar(0.000035853228) * U_5_yy_zz - omega_5_z * t25 +
      Scalar(0.0038374000421699) * t36 - Scalar(0.0016432000421699) * t37 -
      Scalar(0.0149450629075) * ddp_o_5_y;
  const Scalar t39 = Scalar(0.0000674935274) * t8 + c_5 * t34 - s_5 * t38 +
      Scalar(0.22270588235294117) * t33;
  n[3] = -t39;
  const Scalar t40 = Scalar(0.4462748022139784) * t18 - t33;
  const Scalar U_5_zy = t36 - t37;
  const Scalar t41 = Scalar(0.28794534274300054) * ddp_o_5_y - Scalar(0.0149450629075) * U_5_zy +
      Scalar(0.4462748022139784) * t35;
  const Scalar t42 = c_4 * t41 + s_4 * t40;
  const Scalar t43 = Scalar(0.0575445715) * t16 + t39 + Scalar(0.9229411764705883) * t42;
  n[2] = -t43;
  const Scalar t44 = c_3 * (t42 + Scalar(0.918932105043021) * t15);
  const Scalar f_u_4_t_x = c_4 * t40 - s_4 * t41;
  const Scalar f_3_x = f_u_4_t_x + Scalar(0.918932105043021) * ddp_3_x;
  n[1] = Scalar(-0.26021797085) * t13 - t43 - t44 - s_3 * f_3_x;
  const Scalar t45 = c_5 * t32 + s_5 * t30;
  const Scalar U_4_yy_zz = t11 - Uz_o_5_y;
  const Scalar t46 = Scalar(0.0023291870548) * t5 - Scalar(0.000035853228) * U_4_yy_zz + s_5 * t34 +
      c_5 * t38 + Scalar(0.22270588235294117) * t45;
  const Scalar t47 = t45 + Scalar(0.4462748022139784) * t22;
  const Scalar mu_4_y = Scalar(0.000035853228) * t8 - Scalar(0.0021942) * t27 + t28;
  const Scalar mu_3_y = c_4 * mu_4_y + Scalar(0.110994143) * t20 + s_4 * t46 +
      Scalar(0.047511847575) * (t11 - t14) + Scalar(0.25682352941176473) * f_u_4_t_x -
      Scalar(0.9229411764705883) * t47;
  const Scalar t48 = Scalar(0.047511847575) * t16 - Scalar(0.004095) * t3 * omega_3_z +
      s_4 * mu_4_y - c_4 * t46 + Scalar(0.25682352941176473) * t42;
  const Scalar t49 = Scalar(0.16073527663193116) * (t11 - t12) + s_3 * t48 - c_3 * mu_3_y +
      Scalar(1.332535668386042) * t21 + t47;
  const Scalar mu_2_x = Scalar(0.0151074) * qd_2 * t1 + Scalar(0.16073527663193116) * t13 -
      c_3 * t48 - s_3 * mu_3_y;
  n[0] = s_2 * mu_2_x - c_2 * t49;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   tau[6]  in   joint torques or forces, N m or N
//   qdd[6]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[1..4], qd[0..5], tau[0..5]. Operations: 275 mul, 218 add, 4 div, 8 sin/cos.
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
  const Scalar t1 = qd_1 * qd_1;
  const Scalar t2 = s_2 * t1;
  const Scalar t3 = qd_2 * qd_2 - s_2 * t2 + t1;
  const Scalar ddp_o_3_x = t3 + Scalar(23.08235294117647) * s_2;
  const Scalar t4 = c_2 * t2;
  const Scalar ddp_o_3_y = Scalar(23.08235294117647) * c_2 - t4;
  const Scalar t5 = s_3 * ddp_o_3_x - c_3 * ddp_o_3_y;
  const Scalar t6 = c_2 * s_3 + s_2 * c_3;
  const Scalar t7 = t1 * t6;
  const Scalar t8 = s_2 * s_3 - c_2 * c_3;
  const Scalar t9 = t8 * t7;
  const Scalar t10 = t5 - Scalar(0.9229411764705883) * t9;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t11 = t1 - t6 * t7 + omega_3_z * omega_3_z;
  const Scalar ddp_o_4_x = s_3 * ddp_o_3_y + c_3 * ddp_o_3_x + Scalar(0.9229411764705883) * t11;
  const Scalar t12 = s_4 * t10 - c_4 * ddp_o_4_x;
  const Scalar t13 = qd_1 * t8;
  const Scalar t14 = qd_1 * t6;
  const Scalar t15 = s_4 * t13 - c_4 * t14;
  const Scalar t16 = s_4 * t14 + c_4 * t13;
  const Scalar t17 = t15 * t16;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar t18 = t16 * omega_4_z;
  const Scalar t19 = omega_3_z * t14;
  const Scalar t20 = qd_1 * qd_2;
  const Scalar t21 = s_2 * t20;
  const Scalar t22 = Scalar(0.25682352941176473) * t1 + Scalar(2.0) * t21 +
      Scalar(1.8458823529411765) * t19;
  const Scalar t23 = s_5 * (t22 - Scalar(0.44541176470588234) * t18) +
      c_5 * (Scalar(0.22270588235294117) * t17 + t12);
  const Scalar t24 = s_5 * t15;
  const Scalar t25 = c_5 * omega_4_z;
  const Scalar omega_r_5_y = t24 + t25;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t26 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar t27 = c_5 * t15;
  const Scalar t28 = s_5 * omega_4_z;
  const Scalar omega_r_5_x = t28 - t27;
  const Scalar t29 = t16 * (Scalar(2.0) * t28 - t27);
  const Scalar t30 = omega_r_5_x * omega_r_5_y;
  const Scalar t31 = t15 * omega_4_z;
  const Scalar t32 = Scalar(0.000035853228) * t29 + omega_r_5_x * t26 -
      Scalar(0.0016432000421699) * t30 - Scalar(0.0038374000421699) * t31 +
      Scalar(0.0149450629075) * t23;
  const Scalar t33 = t32 - tau_5;
  const Scalar t34 = Scalar(0.8580028554367816) * c_5;
  const Scalar omega_5_z = qd_5 + t16;
  const Scalar t35 = omega_5_z * omega_5_z + omega_r_5_x * omega_r_5_x;
  const Scalar Uz_o_5_y = t15 * t15 + omega_4_z * omega_4_z;
  const Scalar U_5_yy_zz = Uz_o_5_y - t35;
  const Scalar ddp_o_5_y = Scalar(0.22270588235294117) * Uz_o_5_y - c_4 * t10 - s_4 * ddp_o_4_x;
  const Scalar t36 = omega_r_5_y * omega_5_z;
  const Scalar t37 = omega_5_z * t26 - Scalar(0.000035853228) * U_5_yy_zz -
      Scalar(0.0054806000843398) * t36 + Scalar(0.0149450629075) * ddp_o_5_y;
  const Scalar t38 = Scalar(0.0149450629075) * s_5;
  const Scalar t39 = t30 + t31;
  const Scalar t40 = Scalar(0.0149450629075) * c_5;
  const Scalar t41 = t38 * t35 + t40 * t39;
  const Scalar t42 = omega_r_5_x * omega_5_z;
  const Scalar t43 = t42 - t29;
  const Scalar t44 = Scalar(0.000035853228) * t39 + Scalar(0.0038374000421699) * t42 -
      Scalar(0.0015110828546699) * t43;
  const Scalar t45 = c_5 * t44 + Scalar(0.0159921807738199) * t17 -
      Scalar(0.22270588235294117) * t41 + s_5 * t37 + Scalar(0.064127121625) * t12;
  const Scalar t46 = Scalar(0.0001321171875) * t43 + tau_6;
  const Scalar t47 = c_5 * t46;
  const Scalar t48 = t45 - t34 * t33 - t47 + tau_4;
  const Scalar t49 = Scalar(0.0015110828546699) * c_5;
  const Scalar t50 = c_5 * t49;
  const Scalar t51 = t50 - Scalar(0.0181863807738199);
  const Scalar hu_4_t_x = Scalar(0.064127121625) * s_4 - c_4 * t38;
  const Scalar t52 = c_5 * c_5;
  const Scalar t53 = Scalar(0.0001321171875) * t52;
  const Scalar t54 = t53 + (t51 + Scalar(0.9229411764705883) * hu_4_t_x);
  const Scalar t55 = Scalar(0.013793413942275) * c_5;
  const Scalar t56 = Scalar(0.003292500193635) * c_5;
  const Scalar t57 = t56 - s_4 * t55;
  const Scalar t58 = t57 * t34 + t54;
  const Scalar t59 = Scalar(0.002957091755164986) * t52 + t51;
  const Scalar t60 = Scalar(1.0) / t59;
  const Scalar t61 = t58 * t60;
  const Scalar t62 = Scalar(0.064127121625) * t17 - t41;
  const Scalar t63 = t16 * (t24 + Scalar(2.0) * t25);
  const Scalar f_4_y = Scalar(0.0149450629075) * t63 - Scalar(0.029890125815) * t36 +
      Scalar(0.064127121625) * Uz_o_5_y;
  const Scalar t64 = s_4 * t62 - c_4 * f_4_y;
  const Scalar t65 = t47 + (Scalar(0.9229411764705883) * t64 - t45 - Scalar(0.56787913724375) * t9 +
      Scalar(0.677642004375) * t5);
  const Scalar t66 = Scalar(260.5931070544678) * t57;
  const Scalar t67 = tau_3 - t65 - t66 * t33 - t61 * t48;
  const Scalar t68 = Scalar(1.8458823529411765) * hu_4_t_x;
  const Scalar t69 = t53 + (t51 + t68 - Scalar(0.57197413724375));
  const Scalar t70 = t57 * t66 - t58 * t61 + t69;
  const Scalar t71 = Scalar(1.0) / t70;
  const Scalar t72 = s_3 * c_4 + c_3 * s_4;
  const Scalar mu_u_5_2_a_y = t57 - t40 * t72;
  const Scalar f_3_3_x = s_4 * t38 + Scalar(0.064127121625) * c_4;
  const Scalar t73 = s_3 * f_3_3_x;
  const Scalar t74 = mu_u_5_2_a_y * t34 + t73 + t54 + c_3 * hu_4_t_x;
  const Scalar hc_3_x = hu_4_t_x - Scalar(0.677642004375);
  const Scalar hu_3_t_x = t73 + c_3 * hc_3_x;
  const Scalar t75 = mu_u_5_2_a_y * t66 - t74 * t61 + hu_3_t_x + t69;
  const Scalar t76 = t75 * t71;
  const Scalar t77 = t74 * t60;
  const Scalar t78 = c_4 * t62 + s_4 * f_4_y;
  const Scalar f_3_x = Scalar(0.677642004375) * t11 - t78;
  const Scalar t79 = c_3 * (Scalar(0.677642004375) * t9 - t64);
  const Scalar t80 = Scalar(260.5931070544678) * mu_u_5_2_a_y;
  const Scalar y_3_2 = t79 - Scalar(1.39293427915) * t4 + tau_2 - t65 + s_3 * f_3_x +
      Scalar(38.1586437) * c_2 - t80 * t33 - t76 * t67 - t77 * t48;
  const Scalar t81 = Scalar(2.0) * hu_3_t_x;
  const Scalar t82 = mu_u_5_2_a_y * t80 - t74 * t77 + t81 + t69 - t75 * t76 - Scalar(1.40804167915);
  const Scalar t83 = Scalar(1.0) / t82;
  const Scalar Ic_4_yz = t56 - Scalar(0.000035853228);
  const Scalar t84 = c_4 * s_5;
  const Scalar t85 = (s_4 * Ic_4_yz - t49 * t84) + Scalar(0.25682352941176473) * hu_4_t_x;
  const Scalar t86 = t85 - t55 - Scalar(0.12652256366625);
  const Scalar t87 = s_4 * s_5;
  const Scalar Ic_3_yz = t49 * t87 + c_4 * Ic_4_yz + Scalar(0.25682352941176473) * f_3_3_x;
  const Scalar t88 = c_3 * Ic_3_yz;
  const Scalar t89 = Scalar(0.0001321171875) * s_5;
  const Scalar t90 = s_2 * (s_3 * s_4 - c_3 * c_4) * t89;
  const Scalar t91 = t90 - c_2 * t72 * t89;
  const Scalar t92 = c_5 * t91;
  const Scalar t93 = t92 + c_2 * (s_3 * t86 - t88);
  const Scalar t94 = Scalar(0.003838243803185) * c_5 + Scalar(0.0038374000421699);
  const Scalar t95 = c_4 * t94 - Scalar(0.003292500193635) * t87 + Scalar(0.013793413942275) * s_5;
  const Scalar mu_5_3_x = Scalar(0.003292500193635) * t84 + s_4 * t94;
  const Scalar mu_u_5_3_t_x = c_3 * mu_5_3_x + s_3 * t95;
  const Scalar t96 = s_2 * mu_u_5_3_t_x - c_2 * (c_3 * t95 - s_3 * mu_5_3_x + t38);
  const Scalar t97 = s_3 * Ic_3_yz;
  const Scalar t98 = s_2 * (t97 + c_3 * t85);
  const Scalar mu_u_4_3_t_y = t88 - s_3 * t85;
  const Scalar b_5_4_1 = t96 * t34 - t92 - t98 + c_2 * mu_u_4_3_t_y;
  const Scalar t99 = t97 + c_3 * t86;
  const Scalar t100 = b_5_4_1 * t61 - t96 * t66 + t93 + s_2 * t99;
  const Scalar t101 = s_2 * (t99 - t40 - Scalar(0.349300285625));
  const Scalar t102 = b_5_4_1 * t77 - t96 * t80 + t93 - t100 * t76 + t101;
  const Scalar t103 = t102 * t83;
  const Scalar t104 = t100 * t71;
  const Scalar t105 = Scalar(0.000035853228) * t17 + Scalar(0.0021942) * t31 - t32;
  const Scalar t106 = t38 * t39 - t40 * t35;
  const Scalar U_4_yy_zz = t1 - Uz_o_5_y;
  const Scalar mu_4_x = s_5 * t44 - Scalar(0.000035853228) * U_4_yy_zz -
      Scalar(0.22270588235294117) * t106 - Scalar(0.0341785615476398) * t18 - c_5 * t37 +
      Scalar(0.064127121625) * t22;
  const Scalar t107 = t106 + Scalar(0.12825424325) * t18;
  const Scalar t108 = Scalar(0.25682352941176473) * t78 - c_4 * t105 - s_4 * mu_4_x -
      Scalar(0.9229411764705883) * t107 + Scalar(0.12652256366625) * (t1 - t11) +
      Scalar(1.1398532744875) * t19 + Scalar(1.35528400875) * t21;
  const Scalar t109 = Scalar(0.004095) * omega_3_z * t13 + s_4 * t105 -
      Scalar(0.25682352941176473) * t64 + Scalar(0.12652256366625) * t9 - c_4 * mu_4_x;
  const Scalar mu_2_x = Scalar(0.0151074) * c_2 * t20 - c_3 * t109 + Scalar(0.349300285625) * t4 +
      s_3 * t108;
  const Scalar t110 = s_3 * t109 - t107 + Scalar(0.349300285625) * (t1 - t3) +
      Scalar(1.35528400875) * t19 + c_3 * t108 + Scalar(2.8009759583) * t21;
  const Scalar t111 = b_5_4_1 * t60;
  const Scalar t112 = Scalar(-260.5931070544678) * t96;
  const Scalar t113 = Scalar(-7569.03790432263) * t91;
  const Scalar y_2_1 = t113 * t46 - t104 * t67 - s_2 * mu_2_x + tau_1 - t103 * y_3_2 + t111 * t48 -
      t112 * t33 + c_2 * t110;
  const Scalar Iu_5_t_xx = t50 - Scalar(0.0015110828546699);
  const Scalar Iu_4_t_d = Iu_5_t_xx + Scalar(0.01215478073165);
  const Scalar Iu_4_t_g = Scalar(0.00658500038727) * t87 + c_4 * Iu_4_t_d;
  const Scalar t114 = c_4 * Iu_4_t_g;
  const Scalar t115 = Scalar(0.00767648760637) * c_5;
  const Scalar Ic_3_xx = t114 + t115 - Scalar(0.01215478073165);
  const Scalar Ic_3_yy = Iu_5_t_xx - t114 + t115 - t68 + Scalar(0.56787913724375);
  const Scalar Iu_3_t_d = Ic_3_xx - Ic_3_yy;
  const Scalar t116 = Scalar(0.003292500193635) * s_5 - s_4 * Iu_4_t_g +
      Scalar(0.9229411764705883) * f_3_3_x;
  const Scalar Iu_3_t_g = Scalar(2.0) * s_3 * t116 + c_3 * Iu_3_t_d;
  const Scalar t117 = s_2 * (t116 + c_3 * f_3_3_x - s_3 * (Iu_3_t_g + hc_3_x));
  const Scalar t118 = c_3 * Iu_3_t_g;
  const Scalar Iu_3_t_xx = t118 + Ic_3_yy;
  const Scalar t119 = Scalar(2.0) * t117 -
      c_2 * (Ic_3_xx - t118 - Iu_3_t_xx - t81 + Scalar(1.39293427915));
  const Scalar b_2_1_1 = t91 * t113 + b_5_4_1 * t111 + t100 * t104 + t96 * t112 + t102 * t103 +
      Scalar(0.1879281038293699) + Iu_3_t_xx - c_2 * t119;
  const Scalar d_1 = Scalar(1.0) / b_2_1_1;
  const Scalar qdd_1 = d_1 * y_2_1;
  qdd[0] = qdd_1;
  const Scalar t120 = t83 * (t102 * qdd_1 + y_3_2);
  qdd[1] = -t120;
  const Scalar t121 = t71 * (t67 + (t100 * qdd_1 - t75 * t120));
  qdd[2] = -t121;
  const Scalar t122 = t60 * ((t48 - t58 * t121) - (b_5_4_1 * qdd_1 + t74 * t120));
  qdd[3] = -t122;
  qdd[5] = c_5 * (t120 + t121) + c_5 * t122 + Scalar(7569.03790432263) * (t46 - t91 * qdd_1);
  const Scalar t123 = (mu_u_5_2_a_y * t120 + t57 * t121) + (t96 * qdd_1 + t33);
  qdd[4] = -t34 * t122 - Scalar(260.5931070544678) * t123;
  bool positive = b_2_1_1 > Scalar(0.0);
  positive &= -t82 > Scalar(0.0);
  positive &= -t70 > Scalar(0.0);
  positive &= -t59 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[6]   in  joint positions, rad or m
//   qd[6]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1..4], qd[0..5]. Operations: 64 mul, 42 add, 8 sin/cos.
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
  const Scalar t4 = Scalar(0.25682352941176473) * omega_r_3_x +
      Scalar(0.9229411764705883) * omega_3_z + t3;
  const Scalar t5 = s_3 * t2 - c_3 * t1;
  const Scalar t6 = Scalar(0.25682352941176473) * t5 + s_3 * qd_2;
  const Scalar t7 = c_4 * t6 + s_4 * t4;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar t8 = s_4 * t5 - c_4 * omega_r_3_x;
  const Scalar v_o_4_z = t1 - Scalar(0.9229411764705883) * t5;
  const Scalar v_o_5_z = Scalar(0.22270588235294117) * t8 + v_o_4_z;
  const Scalar v_r_5_x = s_5 * v_o_5_z - c_5 * (t7 - Scalar(0.22270588235294117) * omega_4_z);
  const Scalar omega_r_5_y = s_5 * t8 + c_5 * omega_4_z;
  const Scalar t9 = Scalar(0.000035853228) * omega_r_5_y;
  const Scalar t10 = s_4 * omega_r_3_x + c_4 * t5;
  const Scalar t11 = t10 + qd_5;
  const Scalar t12 = t11 * (-t9 - Scalar(0.0038374000421699) * t11 +
      Scalar(0.029890125815) * v_r_5_x);
  const Scalar omega_6_z = omega_r_5_y + qd_6;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t8;
  const Scalar t13 = omega_r_5_x *
      (Scalar(0.029890125815) * (s_4 * t6 - c_4 * t4) - Scalar(0.0016432000421699) * omega_r_5_x);
  const Scalar t14 = Scalar(-0.000035853228) * t10;
  const Scalar t15 = omega_4_z * (t14 - Scalar(0.01654318073165) * omega_4_z +
      Scalar(0.12825424325) * t7);
  const Scalar t16 = t8 * (Scalar(0.01434898073165) * t8 + Scalar(0.12825424325) * v_o_4_z);
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
// Reads q[0..5], qd[0..5]. Operations: 126 mul, 69 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a,
    const SinCos& sin_cos = {}) noexcept {
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
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
  const Scalar omega_r_5_y = s_5 * t4 + c_5 * omega_4_z;
  const Scalar t5 = omega_r_5_x * omega_r_5_y + t4 * omega_4_z;
  const Scalar t6 = s_4 * omega_r_3_x + c_4 * t3;
  const Scalar omega_5_z = qd_5 + t6;
  const Scalar t7 = t6 * omega_4_z;
  const Scalar t8 = Scalar(-2.0) * t7;
  const Scalar t9 = t4 * t6;
  const Scalar U_5_zy = c_5 * t8 - s_5 * t9 + Scalar(2.0) * omega_r_5_y * omega_5_z;
  const Scalar t10 = s_6 * t5 + c_6 * U_5_zy;
  const Scalar t11 = qd_1 * qd_1;
  const Scalar t12 = t11 - omega_r_3_x * omega_r_3_x + omega_3_z * omega_3_z;
  const Scalar t13 = qd_2 * qd_2 - t1 * t1 + t11;
  const Scalar t14 = Scalar(0.425) * c_3;
  const Scalar t15 = t1 * t2;
  const Scalar t16 = Scalar(0.425) * s_3;
  const Scalar ddp_o_4_x = t13 * t14 - t15 * t16 + Scalar(0.39225) * t12;
  const Scalar t17 = t15 * t14 - Scalar(0.39225) * omega_r_3_x * t3 + t13 * t16;
  const Scalar t18 = Scalar(0.09465) * t9 + s_4 * t17 - c_4 * ddp_o_4_x;
  const Scalar t19 = Scalar(0.10915) * t11 - Scalar(0.1893) * t7 +
      Scalar(0.7845) * omega_r_3_x * omega_3_z + Scalar(0.85) * qd_2 * t1;
  const Scalar t20 = s_5 * t19 + c_5 * t18;
  const Scalar Uz_o_5_y = t4 * t4 + omega_4_z * omega_4_z;
  const Scalar ddp_o_5_y = Scalar(0.09465) * Uz_o_5_y - c_4 * t17 - s_4 * ddp_o_4_x;
  const Scalar t21 = Scalar(0.0823) * t10 - s_6 * t20 - c_6 * ddp_o_5_y;
  const Scalar t22 = s_6 * U_5_zy - c_6 * t5;
  const Scalar t23 = Scalar(0.0823) * t22 - s_6 * ddp_o_5_y + c_6 * t20;
  const Scalar t24 = s_6 * t21 - c_6 * t23;
  const Scalar t25 = omega_5_z * omega_5_z + omega_r_5_x * omega_r_5_x;
  const Scalar t26 = Scalar(0.0823) * t25 - s_5 * t18 + c_5 * t19;
  const Scalar t27 = s_5 * t26 + c_5 * t24;
  const Scalar a_6_a_z = s_6 * t23 + c_6 * t21;
  const Scalar t28 = s_4 * t27 - c_4 * a_6_a_z;
  const Scalar t29 = s_4 * a_6_a_z + c_4 * t27;
  const Scalar t30 = s_3 * t28 - c_3 * t29;
  const Scalar t31 = s_3 * t29 + c_3 * t28;
  a[2] = c_2 * t31 - s_2 * t30;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t32 = t22 - (s_6 * omega_5_z - c_6 * omega_r_5_x) * omega_6_z;
  const Scalar domega_6_x = t10 - (s_6 * omega_r_5_x + c_6 * omega_5_z) * omega_6_z;
  const Scalar domega_e_6_t_x = s_6 * t32 + c_6 * domega_6_x;
  const Scalar t33 = c_5 * t9 + omega_r_5_x * omega_5_z + s_5 * t8;
  const Scalar domega_e_5_t_x = s_5 * t33 + c_5 * domega_e_6_t_x;
  const Scalar t34 = s_6 * domega_6_x - c_6 * t32;
  const Scalar t35 = s_4 * domega_e_5_t_x + c_4 * t34;
  const Scalar t36 = s_4 * t34 - c_4 * domega_e_5_t_x;
  const Scalar t37 = s_3 * t35 + c_3 * t36;
  const Scalar t38 = s_3 * t36 - c_3 * t35;
  a[5] = -s_2 * t37 - c_2 * t38;
  const Scalar t39 = s_2 * t31 + c_2 * t30;
  const Scalar t40 = s_5 * t24 - c_5 * t26;
  a[0] = s_1 * t40 - c_1 * t39;
  const Scalar domega_e_2_t_x = s_2 * t38 - c_2 * t37;
  const Scalar t41 = s_5 * domega_e_6_t_x - c_5 * t33;
  a[3] = s_1 * t41 + c_1 * domega_e_2_t_x;
  a[4] = s_1 * domega_e_2_t_x - c_1 * t41;
  a[1] = -s_1 * t39 - c_1 * t40;
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

}  // namespace ur5

#endif  // FLATDYN_UR5_HPP

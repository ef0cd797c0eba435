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

#ifndef FLATDYN_UR5_HPP_A0C298B1
#define FLATDYN_UR5_HPP_A0C298B1

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
// Reads q[1..4], qd[0..5], qdd[0..5]. Operations: 141 mul, 102 add, 8 sin/cos.
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
  const Scalar t1 = s_2 * s_3 - c_2 * c_3;
  const Scalar t2 = s_4 * s_2_3 + c_4 * t1;
  const Scalar t3 = t2 * qd_1;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar t4 = omega_4_z * t3;
  const Scalar t5 = s_4 * t1 - c_4 * s_2_3;
  const Scalar t6 = t5 * qdd_1 + Scalar(2.0) * t4;
  const Scalar t7 = Scalar(0.5) * t1 * qdd_1 + s_2_3 * qd_1 * omega_3_z;
  const Scalar t8 = Scalar(2.0) * s_2 * qd_1 * qd_2 - c_2 * qdd_1;
  const Scalar t9 = qd_1 * qd_1;
  const Scalar t10 = Scalar(0.25682352941176473) * t9 + t8 + Scalar(1.8458823529411765) * t7;
  const Scalar t11 = Scalar(0.22270588235294117) * t6 - t10;
  const Scalar t12 = t5 * qd_1;
  const Scalar t13 = t12 * t3;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar domega_4_z = qdd_4 + domega_3_z;
  const Scalar Uz_o_5_x = domega_4_z - t13;
  const Scalar t14 = omega_3_z * omega_3_z;
  const Scalar t15 = qd_2 * qd_2;
  const Scalar t16 = s_2 * t15 - c_2 * qdd_2 + Scalar(23.08235294117647);
  const Scalar t17 = Scalar(0.9229411764705883) * (s_2_3 * t14 + t1 * domega_3_z) + t16;
  const Scalar t18 = s_2_3 * domega_3_z;
  const Scalar t19 = s_2 * qdd_2;
  const Scalar ddp_o_3_x = t19 + c_2 * (t15 + t9);
  const Scalar ddp_o_4_x = Scalar(0.25682352941176473) * qdd_1 + ddp_o_3_x +
      Scalar(0.9229411764705883) * (t18 - t1 * (t9 + t14));
  const Scalar t20 = t2 * ddp_o_4_x + t5 * t17;
  const Scalar ddp_o_5_x = Scalar(0.22270588235294117) * Uz_o_5_x - t20;
  const Scalar ddp_5_x = s_5 * t11 + c_5 * ddp_o_5_x;
  const Scalar omega_r_5_y = s_5 * t12 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t21 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t12;
  const Scalar Uz_5_x = s_5 * t6 + c_5 * Uz_o_5_x;
  const Scalar t22 = omega_4_z * t12;
  const Scalar t23 = t2 * qdd_1;
  const Scalar domega_4_y = t22 - t23;
  const Scalar domega_5_z = qdd_5 - domega_4_y;
  const Scalar t24 = omega_r_5_x * omega_r_5_y;
  const Scalar mu_5_z = Scalar(0.000035853228) * Uz_5_x + omega_r_5_x * t21 -
      Scalar(0.0016432000421699) * t24 + Scalar(0.0038374000421699) * domega_5_z -
      Scalar(0.0149450629075) * ddp_5_x;
  tau[4] = mu_5_z;
  const Scalar omega_5_z = qd_5 + t3;
  const Scalar t25 = omega_r_5_x * omega_5_z;
  const Scalar domega_5_y = Uz_5_x - t25;
  const Scalar domega_6_z = qdd_6 + domega_5_y;
  const Scalar N_6_z = Scalar(0.0001321171875) * domega_6_z;
  tau[5] = N_6_z;
  const Scalar t26 = domega_5_z - t24;
  const Scalar t27 = Scalar(-0.000035853228) * t26 - N_6_z + Scalar(0.0038374000421699) * t25 +
      Scalar(0.0016432000421699) * domega_5_y;
  const Scalar t28 = omega_5_z * omega_5_z + omega_r_5_x * omega_r_5_x;
  const Scalar t29 = Scalar(0.0149450629075) * t28 +
      Scalar(0.28794534274300054) * (s_5 * ddp_o_5_x - c_5 * t11);
  const Scalar t30 = Scalar(0.0149450629075) * t26 - Scalar(0.28794534274300054) * ddp_5_x;
  const Scalar t31 = s_5 * t29 - c_5 * t30;
  const Scalar Uz_o_5_y = t12 * t12 + omega_4_z * omega_4_z;
  const Scalar U_5_yy_zz = Uz_o_5_y - t28;
  const Scalar t32 = omega_r_5_y * omega_5_z;
  const Scalar t33 = t5 * ddp_o_4_x - t2 * t17;
  const Scalar ddp_o_5_y = Scalar(0.22270588235294117) * Uz_o_5_y + t33;
  const Scalar t34 = Scalar(0.000035853228) * U_5_yy_zz - omega_5_z * t21 +
      Scalar(0.0054806000843398) * t32 - Scalar(0.0149450629075) * ddp_o_5_y;
  const Scalar tau_4 = Scalar(0.000035853228) * t23 - Scalar(0.0017106935695699) * t13 - c_5 * t27 +
      Scalar(0.0039048935695699) * domega_4_z + s_5 * t34 + Scalar(0.22270588235294117) * t31;
  tau[3] = tau_4;
  const Scalar t35 = Scalar(0.4462748022139784) * t20 - t31;
  const Scalar U_5_zy = s_5 * Uz_o_5_x - c_5 * t6 + Scalar(2.0) * t32;
  const Scalar t36 = Scalar(0.28794534274300054) * ddp_o_5_y - Scalar(0.0149450629075) * U_5_zy +
      Scalar(0.4462748022139784) * t33;
  const Scalar t37 = s_4 * t35 - c_4 * t36;
  const Scalar t38 = s_2_3 * (qdd_1 - Scalar(1.211162571801966) * t1 * t9);
  const Scalar t39 = Scalar(0.047511847575) * t38 + Scalar(0.0534495715) * domega_3_z - tau_4 -
      Scalar(0.9229411764705883) * t37;
  tau[2] = -t39;
  const Scalar t40 = s_5 * t30 + c_5 * t29;
  const Scalar t41 = t40 + Scalar(0.4462748022139784) * t10;
  const Scalar t42 = t18 - t1 * (t14 + Scalar(19.425495399093375) * t41);
  const Scalar f_u_4_t_x = t5 * t36 + t2 * t35;
  const Scalar U_4_yy_zz = t9 - Uz_o_5_y;
  const Scalar t43 = Scalar(0.000035853228) * U_4_yy_zz + Scalar(0.0056155871391398) * t4 -
      s_5 * t27 - c_5 * t34 - Scalar(0.22270588235294117) * t40;
  const Scalar t44 = c_2 * (Scalar(0.16073527663193116) * t15 - Scalar(0.658714134193021) * t8 -
      t41);
  const Scalar t45 = t2 * (Scalar(-0.000035853228) * Uz_o_5_x -
      Scalar(0.0017106935695699) * domega_4_y + Scalar(0.0039048935695699) * t22 - mu_5_z);
  tau[0] = -t45 - Scalar(0.115089143) * t1 * t7 + Scalar(0.1252186854919588) * qdd_1 +
      Scalar(0.16073527663193116) * t19 + t5 * t43 + Scalar(0.25682352941176473) * f_u_4_t_x -
      Scalar(0.047511847575) * t42 + t44;
  const Scalar t46 = Scalar(0.16073527663193116) * qdd_1 - Scalar(0.26021797085) * c_2 * t9 +
      Scalar(0.918932105043021) * ddp_o_3_x + f_u_4_t_x;
  const Scalar t47 = c_2 * (t5 * t35 - t2 * t36 + Scalar(0.918932105043021) * t16);
  tau[1] = s_2 * t46 - Scalar(0.24511057085) * qdd_2 - t39 - t47;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   qdd[6]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..5], qd[0..5], qdd[0..5], h_e[0..5]. Operations: 194 mul, 133 add, 12 sin/cos.
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
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = s_2 * s_3 - c_2 * c_3;
  const Scalar t2 = s_4 * s_2_3 + c_4 * t1;
  const Scalar t3 = t2 * qd_1;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar t4 = omega_4_z * t3;
  const Scalar t5 = s_4 * t1 - c_4 * s_2_3;
  const Scalar t6 = t5 * qdd_1 + Scalar(2.0) * t4;
  const Scalar t7 = t5 * qd_1;
  const Scalar t8 = t7 * t3;
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar domega_4_z = qdd_4 + domega_3_z;
  const Scalar Uz_o_5_x = domega_4_z - t8;
  const Scalar Uz_5_x = s_5 * t6 + c_5 * Uz_o_5_x;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t7;
  const Scalar omega_5_z = qd_5 + t3;
  const Scalar t9 = omega_r_5_x * omega_5_z;
  const Scalar domega_5_y = Uz_5_x - t9;
  const Scalar domega_6_z = qdd_6 + domega_5_y;
  const Scalar mu_e1_x = s_1 * h_e_5 + c_1 * h_e_4;
  const Scalar t10 = t5 * h_e_6 + t2 * mu_e1_x;
  const Scalar t11 = s_1 * h_e_4 - c_1 * h_e_5;
  const Scalar tau_6 = Scalar(0.0001321171875) * domega_6_z + s_5 * t10 + c_5 * t11;
  tau[5] = tau_6;
  const Scalar f_e1_x = s_1 * h_e_2 + c_1 * h_e_1;
  const Scalar t12 = t5 * h_e_3 + t2 * f_e1_x;
  const Scalar t13 = s_1 * h_e_1 - c_1 * h_e_2;
  const Scalar f_e5_x = s_5 * t13 - c_5 * t12;
  const Scalar f_e4_y = t5 * f_e1_x - t2 * h_e_3;
  const Scalar t14 = s_6 * f_e5_x - c_6 * f_e4_y;
  const Scalar omega_r_5_y = s_5 * t7 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t15 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar t16 = (s_6 * omega_r_5_x + c_6 * omega_5_z) * t15;
  const Scalar mu_e5_x = s_5 * t11 - c_5 * t10;
  const Scalar mu_e4_y = t5 * mu_e1_x - t2 * h_e_6;
  const Scalar t17 = Scalar(0.0823) * t14 - t16 + s_6 * mu_e4_y + c_6 * mu_e5_x;
  const Scalar f_e6_x = s_6 * f_e4_y + c_6 * f_e5_x;
  const Scalar t18 = (s_6 * omega_5_z - c_6 * omega_r_5_x) * t15;
  const Scalar mu_6_y = t18 + Scalar(0.0823) * f_e6_x - s_6 * mu_e5_x + c_6 * mu_e4_y;
  const Scalar t19 = Scalar(0.5) * t1 * qdd_1 + s_2_3 * qd_1 * omega_3_z;
  const Scalar t20 = Scalar(0.425) * c_2;
  const Scalar t21 = Scalar(0.85) * s_2 * qd_1 * qd_2 - qdd_1 * t20;
  const Scalar t22 = qd_1 * qd_1;
  const Scalar t23 = Scalar(0.10915) * t22 + t21 + Scalar(0.7845) * t19;
  const Scalar t24 = Scalar(0.09465) * t6 - t23;
  const Scalar t25 = omega_3_z * omega_3_z;
  const Scalar t26 = qd_2 * qd_2;
  const Scalar t27 = Scalar(0.425) * (s_2 * t26 - c_2 * qdd_2) + Scalar(9.81);
  const Scalar t28 = Scalar(0.39225) * (s_2_3 * t25 + t1 * domega_3_z) + t27;
  const Scalar t29 = s_2_3 * domega_3_z;
  const Scalar t30 = s_2 * qdd_2;
  const Scalar ddp_o_3_x = Scalar(0.425) * t30 + (t26 + t22) * t20;
  const Scalar ddp_o_4_x = Scalar(0.10915) * qdd_1 + ddp_o_3_x +
      Scalar(0.39225) * (t29 - t1 * (t22 + t25));
  const Scalar t31 = t2 * ddp_o_4_x + t5 * t28;
  const Scalar ddp_o_5_x = Scalar(0.09465) * Uz_o_5_x - t31;
  const Scalar ddp_5_x = s_5 * t24 + c_5 * ddp_o_5_x;
  const Scalar t32 = omega_4_z * t7;
  const Scalar t33 = t2 * qdd_1;
  const Scalar domega_4_y = t32 - t33;
  const Scalar domega_5_z = qdd_5 - domega_4_y;
  const Scalar t34 = omega_r_5_x * omega_r_5_y;
  const Scalar mu_5_z = Scalar(0.000035853228) * Uz_5_x - Scalar(0.0016432000421699) * t34 +
      Scalar(0.0038374000421699) * domega_5_z - Scalar(0.0351648539) * ddp_5_x - s_6 * t17 -
      c_6 * mu_6_y;
  tau[4] = mu_5_z;
  const Scalar t35 = domega_5_z - t34;
  const Scalar t36 = Scalar(0.0351648539) * t35 - s_6 * t14 - c_6 * f_e6_x -
      Scalar(1.5941610670892763) * ddp_5_x;
  const Scalar t37 = s_5 * ddp_o_5_x - c_5 * t24;
  const Scalar t38 = omega_5_z * omega_5_z + omega_r_5_x * omega_r_5_x;
  const Scalar t39 = Scalar(0.0351648539) * t38 - s_5 * t12 - c_5 * t13 +
      Scalar(1.5941610670892763) * t37;
  const Scalar t40 = s_5 * t39 - c_5 * t36;
  const Scalar Uz_o_5_y = t7 * t7 + omega_4_z * omega_4_z;
  const Scalar U_5_yy_zz = Uz_o_5_y - t38;
  const Scalar t41 = omega_r_5_y * omega_5_z;
  const Scalar t42 = t5 * ddp_o_4_x - t2 * t28;
  const Scalar ddp_o_5_y = Scalar(0.09465) * Uz_o_5_y + t42;
  const Scalar mu_5_x = Scalar(0.000035853228) * U_5_yy_zz + Scalar(0.0054806000843398) * t41 -
      Scalar(0.0351648539) * ddp_o_5_y - s_6 * mu_6_y + c_6 * t17;
  const Scalar t43 = Scalar(0.0038374000421699) * t9 - Scalar(0.000035853228) * t35 +
      Scalar(0.0016432000421699) * domega_5_y - tau_6;
  const Scalar tau_4 = Scalar(0.000035853228) * t33 - Scalar(0.0017106935695699) * t8 +
      Scalar(0.0039048935695699) * domega_4_z + Scalar(0.09465) * t40 + s_5 * mu_5_x - c_5 * t43;
  tau[3] = tau_4;
  const Scalar t44 = Scalar(2.4707255485895) * t31 - t40;
  const Scalar U_5_zy = s_5 * Uz_o_5_x - c_5 * t6 + Scalar(2.0) * t41;
  const Scalar t45 = s_6 * f_e6_x - Scalar(0.0351648539) * U_5_zy - c_6 * t14 +
      Scalar(2.4707255485895) * t42 + Scalar(1.5941610670892763) * ddp_o_5_y;
  const Scalar t46 = s_4 * t44 - c_4 * t45;
  const Scalar t47 = s_2_3 * (qdd_1 - Scalar(1.211162571801966) * t1 * t22);
  const Scalar t48 = Scalar(0.047511847575) * t47 + Scalar(0.0534495715) * domega_3_z - tau_4 -
      Scalar(0.39225) * t46;
  tau[2] = -t48;
  const Scalar t49 = s_5 * t36 + c_5 * t39;
  const Scalar t50 = Scalar(2.4707255485895) * t23 + t49;
  const Scalar t51 = t30 + c_2 * (t26 -
      Scalar(2.6440990982534) * (Scalar(5.087513384321224) * t21 + t50));
  const Scalar t52 = t29 - t1 * (t25 + Scalar(8.255835544614685) * t50);
  const Scalar f_u_4_t_x = t5 * t45 + t2 * t44;
  const Scalar U_4_yy_zz = t22 - Uz_o_5_y;
  const Scalar t53 = Scalar(0.000035853228) * U_4_yy_zz + Scalar(0.0056155871391398) * t4 -
      Scalar(0.09465) * t49 - s_5 * t43 - c_5 * mu_5_x;
  const Scalar t54 = t2 * (Scalar(-0.000035853228) * Uz_o_5_x -
      Scalar(0.0017106935695699) * domega_4_y + Scalar(0.0039048935695699) * t32 - mu_5_z);
  tau[0] = Scalar(0.1252186854919588) * qdd_1 - Scalar(0.115089143) * t1 * t19 +
      Scalar(0.10915) * f_u_4_t_x + Scalar(0.6122775784705883) * c_2 * t21 + t5 * t53 - t54 +
      Scalar(0.16073527663193116) * t51 - Scalar(0.047511847575) * t52;
  const Scalar f_3_x = Scalar(5.087513384321224) * ddp_o_3_x + f_u_4_t_x;
  const Scalar t55 = c_2 * (t5 * t44 - t2 * t45 + Scalar(5.087513384321224) * t27);
  const Scalar t56 = s_2 * (qdd_1 - Scalar(1.6189225931148576) * c_2 * t22);
  const Scalar t57 = Scalar(0.24511057085) * qdd_2 - Scalar(0.16073527663193116) * t56 + t48 -
      Scalar(0.425) * (s_2 * f_3_x - t55);
  tau[1] = -t57;
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
// Reads q[1..4]. Operations: 60 mul, 43 add, 8 sin/cos. Always zero: 2 of the 36 entries of B.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inertia_matrix(const Scalar* q, Scalar* B, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  B[22] = B[27] = Scalar(-0.003292500193635) * c_5;
  B[11] = B[17] = B[23] = B[31] = B[32] = B[33] = Scalar(0.0001321171875) * c_5;
  const Scalar B_35 = Scalar(0.013793413942275) * c_5 * (s_4 - Scalar(0.23870089068696182));
  B[16] = B[26] = B_35;
  const Scalar t1 = Scalar(0.0015110828546699) * c_5;
  const Scalar t2 = c_5 * t1;
  const Scalar t3 = t2 - Scalar(0.0181863807738199);
  B[21] = -t3;
  const Scalar t4 = s_4 - Scalar(0.23305369910246615) * c_4 * s_5;
  const Scalar t5 = t3 + Scalar(0.1183711221525) * t4 - Scalar(0.57197413724375);
  B[14] = -t5;
  const Scalar t6 = t3 + Scalar(0.05918556107625) * t4;
  B[15] = B[20] = -t6;
  const Scalar t7 = s_2 * s_3 - c_2 * c_3;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t8 = s_4 * t7 - c_4 * s_2_3;
  const Scalar t9 = s_5 * t8;
  B[5] = B[30] = Scalar(0.0001321171875) * t9;
  const Scalar t10 = s_4 * s_2_3 + c_4 * t7;
  const Scalar t11 = s_5 * (Scalar(1.0834926704907584) * c_2 - t7);
  B[4] = B[24] = Scalar(0.003838243803185) * t10 * (c_5 + Scalar(0.9997801700313045)) -
      Scalar(0.003292500193635) * t9 - Scalar(0.013793413942275) * t11;
  B[10] = B[25] = B_35 + Scalar(0.0149450629075) * c_5 * (s_2 * t10 - c_2 * t8);
  const Scalar Ic_4_yz = Scalar(0.003292500193635) * c_5 - Scalar(0.000035853228);
  const Scalar t12 = Scalar(0.0149450629075) * t9 + Scalar(0.064127121625) * t10;
  const Scalar t13 = (t1 * t9 + t10 * Ic_4_yz) + Scalar(0.25682352941176473) * t12;
  B[3] = B[18] = -t13;
  const Scalar t14 = Scalar(0.064127121625) * t8 - Scalar(0.0149450629075) * s_5 * t10;
  const Scalar t15 = c_2 * (Scalar(0.677642004375) * t7 - t14);
  const Scalar t16 = t7 * (t7 - Scalar(3.2504845342625623) * t14);
  const Scalar Iu_5_t_xx = t2 - Scalar(0.0015110828546699);
  const Scalar Iu_4_t_d = Iu_5_t_xx + Scalar(0.01215478073165);
  const Scalar t17 = t10 * (Scalar(0.00658500038727) * t9 + t10 * Iu_4_t_d);
  B[0] = Iu_5_t_xx + Scalar(0.00767648760637) * c_5 - t17 + Scalar(0.1879281038293699) +
      Scalar(0.56787913724375) * t16 - Scalar(2.0) * t15 + Scalar(1.39293427915) * c_2 * c_2;
  B[9] = B[19] = c_2 * t14 - s_2 * t12 - t6;
  const Scalar t18 = t13 - Scalar(0.013793413942275) * s_2_3 * (c_5 + Scalar(9.172679381315092));
  B[2] = B[12] = -t18;
  B[1] = B[6] = Scalar(0.0149450629075) * s_2 * (c_5 + Scalar(23.37228607112171)) - t18;
  const Scalar f_3_3_x = Scalar(0.677642004375) * s_2_3 - t12;
  const Scalar t19 = t15 - s_2 * f_3_3_x;
  B[7] = -t5 - Scalar(2.0) * t19 + Scalar(1.40804167915);
  B[8] = B[13] = -t19 - t5;
  B[29] = B[34] = Scalar(0.0);
  B[35] = Scalar(0.0001321171875);
  B[28] = Scalar(0.0038374000421699);
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[126] = {
    0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 1, 1, 1, 1, 0,
    1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 1, 0,
    1, 0, 1, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 1, 0,
    1, 0, 1, 0, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0, 0, 0, 1, 0,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0,
    0, 1, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[6]    in   joint positions, rad or m
//   c[126]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//                c_ijk = c_ikj is c[21 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads q[1..4]. Operations: 121 mul, 76 add, 8 sin/cos. Always zero: 51 of the 126 entries of c.
template <class Scalar, class SinCos = LibrarySinCos>
inline void christoffel(const Scalar* q, Scalar* c, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  c[77] = Scalar(0.003292500193635) * s_5;
  c[100] = c[101] = c[102] = Scalar(0.00006605859375) * s_5;
  c[40] = c[61] = c[82] = c[116] = c[117] = c[118] = Scalar(-0.00006605859375) * s_5;
  const Scalar t1 = Scalar(0.0015110828546699) * c_5;
  const Scalar db_44_5r = s_5 * t1;
  c[74] = c[75] = c[76] = db_44_5r;
  c[91] = c[92] = c[93] = -db_44_5r;
  const Scalar s_2_3 = c_2 * s_3 + s_2 * c_3;
  const Scalar t2 = c_2 * c_3 - s_2 * s_3;
  const Scalar t3 = c_4 * s_2_3 + s_4 * t2;
  const Scalar t4 = c_5 * t3;
  c[19] = c[115] = Scalar(-0.00006605859375) * t4;
  c[99] = Scalar(0.00006605859375) * t4;
  const Scalar t5 = c_4 * t2 - s_4 * s_2_3;
  const Scalar t6 = s_5 * t5;
  c[16] = c[17] = c[18] = c[106] = c[108] = c[111] = Scalar(-0.00006605859375) * t6;
  c[36] = c[57] = c[78] = Scalar(0.00006605859375) * t6;
  const Scalar t7 = Scalar(0.029592780538125) * t3 - Scalar(0.0068967069711375) * t6;
  const Scalar Ic_4_yz = c_5 - Scalar(0.01088936245753631);
  const Scalar t8 = Scalar(0.003292500193635) * t3 * Ic_4_yz - t6 * t1 +
      Scalar(0.5565328234544296) * t7;
  c[7] = c[8] = c[9] = -t8;
  const Scalar t9 = t2 * t3 - s_2_3 * t5;
  const Scalar t10 = Scalar(0.013793413942275) * s_5;
  const Scalar t11 = t2 * t5 + s_2_3 * t3;
  const Scalar c_4_3_3 = t9 * t10 + Scalar(0.05918556107625) * t11;
  c[68] = c_4_3_3;
  const Scalar t12 = Scalar(1.0834926704907584) * s_2;
  const Scalar v_o_2_4_x = s_2_3 + t12;
  const Scalar t13 = Scalar(1.0834926704907584) * c_2;
  const Scalar t14 = t2 + t13;
  const Scalar t15 = t5 * v_o_2_4_x - t3 * t14;
  const Scalar t16 = t5 * t14 + t3 * v_o_2_4_x;
  const Scalar c_4_2_2 = Scalar(0.05918556107625) * t16 - t15 * t10;
  c[65] = c_4_2_2;
  const Scalar t17 = Scalar(0.00075554142733495) * s_5;
  const Scalar t18 = t17 + Scalar(0.0068967069711375) * t16;
  const Scalar t19 = Scalar(2.0) * c_5;
  const Scalar db_22_5r = t18 * t19;
  c[32] = c[34] = db_22_5r;
  const Scalar t20 = t17 + Scalar(0.0068967069711375) * t11;
  const Scalar db_33_5r = t19 * t20;
  c[54] = c[55] = db_33_5r;
  const Scalar t21 = Scalar(0.23870089068696182) + t15;
  c[35] = t10 * t21;
  const Scalar t22 = Scalar(-0.0016462500968175) * t6;
  const Scalar t23 = Scalar(0.0019191219015925) * t3 * (c_5 + Scalar(0.9997801700313045)) - t22;
  const Scalar t24 = Scalar(0.00075554142733495) + Scalar(0.0019191219015925) * c_5;
  const Scalar t25 = t22 + t3 * (t24 - Scalar(0.0015110828546699) * s_5 * s_5);
  c[13] = t23 + t25;
  const Scalar c_5_1_4 = t23 - t25;
  c[90] = c_5_1_4;
  const Scalar t26 = t8 - Scalar(0.013793413942275) * t2 * (c_5 + Scalar(9.172679381315092));
  c[4] = c[5] = -t26;
  const Scalar t27 = s_5 * t3;
  const Scalar t28 = Scalar(0.0068967069711375) * t27 + Scalar(0.029592780538125) * t5;
  const Scalar f_3_3_x = Scalar(2.1669853409815167) * t28 + Scalar(0.677642004375) * s_2_3;
  const Scalar t29 = c_2 * f_3_3_x;
  const Scalar t30 = Scalar(0.312711854371875) * t2 - t7;
  const Scalar c_3_2_2 = t29 - Scalar(2.1669853409815167) * s_2 * t30;
  c[44] = c_3_2_2;
  c[50] = c[51] = -c_4_3_3;
  const Scalar t31 = s_5 * t17;
  const Scalar t32 = t31 - Scalar(0.006077390365825);
  const Scalar t33 = Scalar(0.003292500193635) * t27 - t5 * t32;
  const Scalar t34 = Scalar(0.0068967069711375) * s_5;
  const Scalar t35 = t5 * (Scalar(0.003292500193635) * t6 + t3 * t32 +
      Scalar(0.029592780538125) * t14);
  const Scalar c_4_1_1 = t35 - t3 * (t33 - t14 * t34) + t28 * t14;
  c[63] = c_4_1_1;
  c[28] = c[30] = -c_4_2_2;
  c[86] = -db_22_5r;
  c[89] = -db_33_5r;
  const Scalar t36 = Scalar(0.0019191219015925) * t6 +
      Scalar(0.0068967069711375) * c_5 * (Scalar(0.2413001912045889) * t3 - t14);
  const Scalar t37 = t36 - Scalar(0.000017926614) * t4;
  c[14] = Scalar(2.0) * t37;
  const Scalar t38 = t9 - Scalar(0.23870089068696182);
  c[56] = -t10 * t38;
  c[73] = -c_5_1_4;
  const Scalar t39 = t2 * (t28 + Scalar(0.283939568621875) * s_2_3);
  const Scalar t40 = Scalar(0.0016462500968175) * s_5 - t3 * t33 - s_2_3 * t7 + t39;
  const Scalar c_3_1_1 = Scalar(2.0) * t40 + t29;
  c[42] = c_3_1_1;
  c[2] = Scalar(0.0149450629075) * c_2 * (c_5 + Scalar(23.37228607112171)) - t26;
  c[25] = c[26] = -c_3_2_2;
  c[6] = -c_4_1_1;
  const Scalar t41 = Scalar(0.5) * c_4_3_3 + Scalar(0.5) * c_4_2_2;
  const Scalar t42 = t28 * t13 + t7 * t12;
  const Scalar c_3_2_4 = t42 - t41;
  c[49] = c_3_2_4;
  const Scalar t43 = c_5 * t20 + c_5 * t18;
  const Scalar t44 = Scalar(-0.00747253145375) * c_5 * (c_2 * t5 + s_2 * t3);
  c[33] = t43 - t44;
  const Scalar c_3_2_5 = t44 + t43;
  c[53] = c_3_2_5;
  const Scalar dI_2_xx = c_3_1_1 +
      Scalar(1.39293427915) * s_2 * (Scalar(1.5556981929570004) * t30 + c_2);
  c[21] = dI_2_xx;
  c[3] = -c_3_1_1;
  const Scalar t45 = Scalar(-0.00075554142733495) * t27;
  const Scalar t46 = t3 * (c_5 * (Scalar(0.000017926614) * t5 + t45) +
      t45 * (c_5 + Scalar(5.080123556856152)));
  const Scalar c_5_1_1 = t5 * (t36 + t37) - t46;
  c[84] = c_5_1_1;
  c[29] = -t42 - t41;
  c[67] = -c_3_2_4;
  c[88] = -c_3_2_5;
  c[1] = -dI_2_xx;
  c[10] = -c_5_1_1;
  const Scalar t47 = Scalar(-0.0068967069711375) * t5;
  const Scalar t48 = t3 * (t31 - t24);
  const Scalar t49 = s_5 * (t21 * t47 - t3 * t18) - t48;
  const Scalar t50 = t23 + s_2_3 * t34;
  const Scalar t51 = t50 + Scalar(0.00747253145375) * s_2 * s_5;
  c[11] = t51 + t49;
  const Scalar c_5_1_2 = t51 - t49;
  c[85] = c_5_1_2;
  const Scalar t52 = t48 + s_5 * (t38 * t47 + t3 * t20);
  c[12] = t50 - t52;
  const Scalar c_5_1_3 = t50 + t52;
  c[87] = c_5_1_3;
  c[31] = -c_5_1_2;
  c[52] = -c_5_1_3;
  c[0] = c[15] = c[20] = c[22] = c[23] = c[24] = c[27] = c[37] = Scalar(0.0);
  c[38] = c[39] = c[41] = c[43] = c[45] = c[46] = c[47] = c[48] = Scalar(0.0);
  c[58] = c[59] = c[60] = c[62] = c[64] = c[66] = c[69] = c[70] = Scalar(0.0);
  c[71] = c[72] = c[79] = c[80] = c[81] = c[83] = c[94] = c[95] = Scalar(0.0);
  c[96] = c[97] = c[98] = c[103] = c[104] = c[105] = c[107] = c[109] = Scalar(0.0);
  c[110] = c[112] = c[113] = c[114] = c[119] = c[120] = c[121] = c[122] = Scalar(0.0);
  c[123] = c[124] = c[125] = Scalar(0.0);
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
// Reads q[1..4], qd[0..5]. Operations: 189 mul, 138 add, 8 sin/cos. Always zero: 2 of the 36
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
  const Scalar t1 = s_5 * qd_5;
  const Scalar C_44 = Scalar(0.0015110828546699) * c_5 * t1;
  C[21] = C_44;
  const Scalar t2 = s_2 * s_3 - c_2 * c_3;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t3 = s_4 * t2 - c_4 * s_2_3;
  const Scalar t4 = c_5 * t3;
  const Scalar t5 = qd_2 + qd_3;
  const Scalar t6 = qd_4 + t5;
  const Scalar C_56 = Scalar(0.00006605859375) * s_5 * t6 - Scalar(0.00006605859375) * qd_1 * t4;
  C[29] = C_56;
  const Scalar t7 = s_4 * s_2_3 + c_4 * t2;
  const Scalar t8 = s_5 * t7;
  C[5] = C[30] = Scalar(0.00006605859375) * (qd_5 * t4 + t8 * t6);
  const Scalar t9 = qd_1 * t8;
  C[11] = C[17] = C[23] = Scalar(-0.00006605859375) * (t9 + t1);
  C[31] = C[32] = C[33] = Scalar(-0.00006605859375) * (t1 - t9);
  C[34] = -C_56;
  const Scalar t10 = Scalar(-0.0019191219015925) * t4;
  const Scalar t11 = Scalar(-0.0016462500968175) * t8;
  const Scalar t12 = -t10 - t11 + Scalar(0.00191870002108495) * t3;
  const Scalar t13 = t10 - t11 - Scalar(0.0015110828546699) * t3 * (c_5 * c_5 - Scalar(0.5));
  const Scalar t14 = t12 + t13;
  const Scalar t15 = Scalar(0.0015110828546699) * s_5;
  const Scalar t16 = c_5 * t15;
  const Scalar t17 = Scalar(0.00006605859375) * qd_6;
  const Scalar t18 = s_5 * t17;
  const Scalar C_54 = t18 - t6 * t16 - qd_1 * t14;
  C[27] = C_54;
  const Scalar t19 = Scalar(1.0834926704907584) * c_2;
  const Scalar t20 = t2 - t19;
  const Scalar v_o_2_4_x = Scalar(1.0834926704907584) * s_2 + s_2_3;
  const Scalar t21 = t3 * t20 + t7 * v_o_2_4_x;
  const Scalar t22 = Scalar(0.013793413942275) * s_5;
  const Scalar t23 = t3 * v_o_2_4_x - t7 * t20;
  const Scalar t24 = Scalar(0.05918556107625) * t23 - t21 * t22;
  const Scalar t25 = Scalar(0.013793413942275) * t23 - t15;
  const Scalar t26 = c_5 * t25;
  const Scalar t27 = qd_4 * t24 - qd_5 * t26;
  const Scalar t28 = s_5 * t3;
  const Scalar t29 = Scalar(0.0068967069711375) * t28 + Scalar(0.029592780538125) * t7;
  const Scalar f_3_3_x = Scalar(0.677642004375) * s_2_3 - Scalar(2.1669853409815167) * t29;
  const Scalar t30 = c_2 * f_3_3_x;
  const Scalar t31 = Scalar(0.0320635608125) * t3 - Scalar(0.00747253145375) * t8;
  const Scalar t32 = s_2 * (Scalar(0.677642004375) * t2 - Scalar(2.0) * t31);
  const Scalar t33 = t30 + t32;
  C[7] = t27 - qd_3 * t33;
  const Scalar t34 = s_2_3 * t3 - t2 * t7;
  const Scalar t35 = Scalar(0.013793413942275) * t34 - t15;
  const Scalar t36 = c_5 * t35;
  const Scalar t37 = s_2_3 * t7 + t2 * t3;
  const Scalar t38 = Scalar(0.05918556107625) * t34 - t37 * t22;
  const Scalar t39 = qd_5 * t36 - qd_4 * t38;
  C[14] = -t39;
  C[22] = Scalar(0.003292500193635) * t1 - C_54;
  const Scalar t40 = Scalar(0.00075554142733495) * c_5;
  const Scalar Iu_4_t_d = c_5 * t40 + Scalar(0.00532184893849005);
  const Scalar t41 = Scalar(0.003292500193635) * t28 + t7 * Iu_4_t_d;
  const Scalar t42 = Scalar(0.0068967069711375) * s_5;
  const Scalar t43 = t7 * (Scalar(0.003292500193635) * t8 - t3 * Iu_4_t_d +
      Scalar(0.029592780538125) * t20);
  const Scalar t44 = t29 * t20 - t3 * (t41 - t20 * t42) + t43;
  const Scalar t45 = t8 * t17;
  const Scalar t46 = t45 - qd_1 * t44;
  const Scalar t47 = t12 - t13;
  const Scalar Ic_4_yz = Scalar(0.0016462500968175) * c_5 - Scalar(0.000017926614);
  const Scalar t48 = t3 * Ic_4_yz - t8 * t40 + Scalar(0.25682352941176473) * t31;
  C[3] = Scalar(2.0) * t48 * t6 - qd_5 * t47 + t46;
  const Scalar t49 = Scalar(0.5) * t24 + Scalar(0.5) * t38;
  const Scalar t50 = s_2 * t31 + t29 * t19;
  const Scalar t51 = t50 + t49;
  const Scalar t52 = qd_2 * t24;
  C[9] = t27 + qd_3 * t51 + t52;
  C[18] = qd_5 * t14 - t46;
  const Scalar t53 = t50 - t49;
  C[19] = C_44 - t52 + qd_3 * t53;
  const Scalar t54 = Scalar(0.0019191219015925) * t8 +
      Scalar(0.0068967069711375) * c_5 * (Scalar(0.2413001912045889) * t3 - t20);
  const Scalar t55 = t54 - Scalar(0.000017926614) * t4;
  const Scalar t56 = t40 + Scalar(0.0019191219015925);
  const Scalar t57 = t28 * (Scalar(0.0019191219015925) + t56) -
      c_5 * (Scalar(0.000017926614) * t7 - Scalar(0.00075554142733495) * t28);
  const Scalar t58 = t3 * t57 + t7 * (t54 + t55);
  const Scalar t59 = t2 * (Scalar(0.283939568621875) * s_2_3 - t29);
  const Scalar t60 = Scalar(0.0016462500968175) * s_5 - t3 * t41 +
      Scalar(0.9229411764705883) * s_2_3 * t31 - t59;
  const Scalar c_3_1_1 = Scalar(2.0) * t60 + t30;
  const Scalar t61 = c_3_1_1 - t32 + Scalar(1.39293427915) * c_2 * s_2;
  C[0] = -qd_5 * t58 - qd_4 * t44 - qd_3 * c_3_1_1 - qd_2 * t61;
  const Scalar t62 = t45 - qd_1 * t61;
  const Scalar t63 = Scalar(-0.5) * t3;
  const Scalar t64 = t21 - Scalar(0.23870089068696182);
  const Scalar t65 = Scalar(-0.0068967069711375) * t7;
  const Scalar t66 = t4 * t56;
  const Scalar t67 = s_5 * (t25 * t63 + t64 * t65) - t66;
  const Scalar t68 = t12 - s_2_3 * t42;
  const Scalar t69 = t68 - Scalar(0.00747253145375) * s_2 * s_5;
  const Scalar t70 = t69 - t67;
  const Scalar t71 = t48 - Scalar(0.0068967069711375) * t2 * (c_5 + Scalar(9.172679381315092));
  const Scalar t72 = qd_2 * (t71 +
      Scalar(0.00747253145375) * c_2 * (c_5 + Scalar(23.37228607112171)));
  const Scalar t73 = qd_4 * t48;
  C[1] = Scalar(2.0) * (t73 + qd_3 * t71 + t72) - qd_5 * t70 + t62;
  const Scalar t74 = t37 - Scalar(0.23870089068696182);
  const Scalar t75 = t66 - s_5 * (t63 * t35 + t74 * t65);
  const Scalar t76 = t68 + t75;
  const Scalar t77 = t45 - qd_1 * c_3_1_1;
  C[2] = Scalar(2.0) * (t73 + t71 * t5) - qd_5 * t76 + t77;
  const Scalar t78 = t4 * t17 - qd_1 * t58;
  C[4] = t78 - qd_4 * t47 - qd_3 * t76 - Scalar(2.0) * qd_5 * t55 - qd_2 * t70;
  const Scalar t79 = Scalar(-0.5) * c_5 * (t25 + t35);
  const Scalar t80 = Scalar(-0.00747253145375) * c_5 * (s_2 * t3 + c_2 * t7);
  const Scalar t81 = t80 + t79;
  C[8] = qd_5 * t81 + qd_4 * t51 - t33 * t5;
  const Scalar t82 = t80 - t79;
  C[13] = -qd_5 * t82 - qd_4 * t53 + qd_2 * t33;
  const Scalar t83 = qd_3 * t38 - qd_2 * t53;
  C[15] = t83 - t39;
  C[20] = C_44 - t83;
  const Scalar t84 = t69 + t67;
  C[6] = qd_5 * t84 - t62;
  const Scalar t85 = t68 - t75;
  C[12] = qd_5 * t85 - t77;
  C[24] = -qd_4 * t14 - t78 - qd_3 * t85 - qd_2 * t84;
  const Scalar t86 = t18 + qd_2 * t26 - qd_1 * t84;
  const Scalar t87 = qd_4 * t16;
  C[25] = qd_3 * t82 - t87 + t86;
  const Scalar t88 = t18 - qd_1 * t85 + qd_3 * t36 + qd_2 * t82;
  C[26] = t88 - t87;
  const Scalar t89 = Scalar(0.013793413942275) * t1;
  C[10] = qd_3 * t81 - t64 * t89 - qd_4 * t26 - t86;
  C[16] = -t74 * t89 - qd_4 * t36 - t88;
  C[28] = C[35] = Scalar(0.0);
}

// Gravity torques g(q) (7.39).
//   q[6]  in   joint positions, rad or m
//   g[6]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..4]. Operations: 15 mul, 7 add, 8 sin/cos. Always zero: g[0], g[5].
template <class Scalar, class SinCos = LibrarySinCos>
inline void gravity(const Scalar* q, Scalar* g, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar c_2_3 = c_2 * c_3 - s_2 * s_3;
  const Scalar s_2_3 = c_2 * s_3 + s_2 * c_3;
  const Scalar c_2_3_4 = c_4 * c_2_3 - s_4 * s_2_3;
  const Scalar s_2_3_4 = c_4 * s_2_3 + s_4 * c_2_3;
  const Scalar hu_4_t_x = Scalar(1.48020485445) * s_2_3_4 - Scalar(0.344967216759) * s_5 * c_2_3_4;
  g[3] = hu_4_t_x;
  g[4] = Scalar(-0.344967216759) * c_5 * s_2_3_4;
  const Scalar t1 = Scalar(15.64157191275) * c_2_3 - hu_4_t_x;
  g[2] = -t1;
  g[1] = -t1 - Scalar(38.1586437) * c_2;
  g[0] = g[5] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[6]   in   joint positions, rad or m
//   qd[6]  in   joint velocities, rad/s or m/s
//   n[6]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..4], qd[0..5]. Operations: 120 mul, 79 add, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4];
  const Scalar t1 = s_2 * s_3 - c_2 * c_3;
  const Scalar s_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t2 = s_4 * t1 - c_4 * s_2_3;
  const Scalar t3 = t2 * qd_1;
  const Scalar t4 = c_5 * t3;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar t5 = s_5 * omega_4_z;
  const Scalar omega_r_5_x = t5 - t4;
  const Scalar t6 = s_4 * s_2_3 + c_4 * t1;
  const Scalar t7 = t6 * qd_1;
  const Scalar omega_5_z = qd_5 + t7;
  const Scalar t8 = omega_r_5_x * omega_5_z;
  const Scalar t9 = (Scalar(2.0) * t5 - t4) * t7;
  const Scalar t10 = t8 - t9;
  n[5] = Scalar(-0.0001321171875) * t10;
  const Scalar t11 = s_2_3 * omega_3_z;
  const Scalar t12 = qd_2 * qd_2;
  const Scalar ddp_o_3_y = s_2 * t12 + Scalar(23.08235294117647);
  const Scalar ddp_o_4_y = Scalar(0.9229411764705883) * omega_3_z * t11 + ddp_o_3_y;
  const Scalar t13 = omega_3_z * omega_3_z;
  const Scalar t14 = qd_1 * qd_1;
  const Scalar t15 = t12 + t14;
  const Scalar t16 = Scalar(0.9229411764705883) * t1 * (t14 + t13) - c_2 * t15;
  const Scalar t17 = t2 * ddp_o_4_y - t6 * t16;
  const Scalar t18 = t3 * t7;
  const Scalar t19 = Scalar(0.22270588235294117) * t18 + t17;
  const Scalar t20 = omega_4_z * t7;
  const Scalar t21 = qd_1 * t11;
  const Scalar t22 = qd_1 * s_2 * qd_2;
  const Scalar t23 = Scalar(0.25682352941176473) * t14 + Scalar(2.0) * t22 +
      Scalar(1.8458823529411765) * t21;
  const Scalar t24 = t23 - Scalar(0.44541176470588234) * t20;
  const Scalar t25 = s_5 * t24 + c_5 * t19;
  const Scalar t26 = s_5 * t3;
  const Scalar t27 = c_5 * omega_4_z;
  const Scalar omega_r_5_y = t26 + t27;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t28 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar t29 = omega_r_5_x * omega_r_5_y;
  const Scalar t30 = omega_4_z * t3;
  const Scalar mu_5_z = Scalar(0.000035853228) * t9 + omega_r_5_x * t28 -
      Scalar(0.0016432000421699) * t29 - Scalar(0.0038374000421699) * t30 +
      Scalar(0.0149450629075) * t25;
  n[4] = mu_5_z;
  const Scalar t31 = omega_5_z * omega_5_z + omega_r_5_x * omega_r_5_x;
  const Scalar t32 = Scalar(0.0149450629075) * t31 -
      Scalar(0.28794534274300054) * (s_5 * t19 - c_5 * t24);
  const Scalar t33 = t29 + t30;
  const Scalar t34 = Scalar(0.0149450629075) * t33 - Scalar(0.28794534274300054) * t25;
  const Scalar t35 = s_5 * t32 + c_5 * t34;
  const Scalar Uz_o_5_y = t3 * t3 + omega_4_z * omega_4_z;
  const Scalar U_5_yy_zz = Uz_o_5_y - t31;
  const Scalar t36 = omega_r_5_y * omega_5_z;
  const Scalar domega_5_x = t36 - t7 * (t26 + Scalar(2.0) * t27);
  const Scalar t37 = t2 * t16 + t6 * ddp_o_4_y;
  const Scalar ddp_o_5_y = Scalar(0.22270588235294117) * Uz_o_5_y - t37;
  const Scalar t38 = Scalar(0.000035853228) * U_5_yy_zz - omega_5_z * t28 +
      Scalar(0.0038374000421699) * t36 + Scalar(0.0016432000421699) * domega_5_x -
      Scalar(0.0149450629075) * ddp_o_5_y;
  const Scalar t39 = Scalar(0.000035853228) * t33 + Scalar(0.0001321171875) * t10 +
      Scalar(0.0021942) * t8;
  const Scalar t40 = Scalar(0.0000674935274) * t18 + c_5 * t39 - s_5 * t38 -
      Scalar(0.22270588235294117) * t35;
  n[3] = -t40;
  const Scalar t41 = Scalar(0.4462748022139784) * t17 - t35;
  const Scalar U_5_zy = t36 + domega_5_x;
  const Scalar t42 = Scalar(0.0149450629075) * U_5_zy - Scalar(0.28794534274300054) * ddp_o_5_y +
      Scalar(0.4462748022139784) * t37;
  const Scalar t43 = s_4 * t41 + c_4 * t42;
  const Scalar t44 = t40 - Scalar(0.0575445715) * t1 * s_2_3 * t14 -
      Scalar(0.9229411764705883) * t43;
  n[2] = -t44;
  const Scalar t45 = t2 * t42 - t6 * t41;
  const Scalar t46 = s_5 * t34 - c_5 * t32;
  const Scalar t47 = Scalar(0.4462748022139784) * t23 - t46;
  const Scalar t48 = t1 * (t13 - Scalar(2.422325143603932) * t21 +
      Scalar(19.425495399093375) * t47);
  const Scalar t49 = c_2 * (Scalar(0.16073527663193116) * t12 - Scalar(1.317428268386042) * t22 -
      t47);
  const Scalar U_4_yy_zz = t14 - Uz_o_5_y;
  const Scalar t50 = Scalar(0.000035853228) * U_4_yy_zz + Scalar(0.0023291870548) * t20 -
      s_5 * t39 - c_5 * t38 + Scalar(0.22270588235294117) * t46;
  const Scalar t51 = t6 * (Scalar(0.000035853228) * t18 + Scalar(0.0021942) * t30 - mu_5_z);
  n[0] = t2 * t50 - t51 - Scalar(0.25682352941176473) * t45 + Scalar(0.047511847575) * t48 + t49;
  const Scalar t52 = s_2 * (t45 + Scalar(0.26021797085) * c_2 *
      (t14 - Scalar(3.531393708287465) * t15));
  const Scalar f_3_y = t2 * t41 + t6 * t42 + Scalar(0.918932105043021) * ddp_o_3_y;
  n[1] = -t44 - t52 - c_2 * f_3_y;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[6]    in   joint positions, rad or m
//   qd[6]   in   joint velocities, rad/s or m/s
//   tau[6]  in   joint torques or forces, N m or N
//   qdd[6]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[1..4], qd[0..5], tau[0..5]. Operations: 235 mul, 167 add, 4 div, 8 sin/cos.
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
  const Scalar s_2_3 = c_2 * s_3 + s_2 * c_3;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t1 = s_2_3 * omega_3_z;
  const Scalar t2 = qd_2 * qd_2;
  const Scalar ddp_o_3_y = s_2 * t2 + Scalar(23.08235294117647);
  const Scalar ddp_o_4_y = Scalar(0.9229411764705883) * omega_3_z * t1 + ddp_o_3_y;
  const Scalar t3 = c_2 * c_3 - s_2 * s_3;
  const Scalar t4 = c_4 * s_2_3 + s_4 * t3;
  const Scalar t5 = c_4 * t3 - s_4 * s_2_3;
  const Scalar t6 = omega_3_z * omega_3_z;
  const Scalar t7 = qd_1 * qd_1;
  const Scalar t8 = c_2 * (t7 + t2);
  const Scalar t9 = t8 + Scalar(0.9229411764705883) * t3 * (t7 + t6);
  const Scalar t10 = t5 * t9 + t4 * ddp_o_4_y;
  const Scalar t11 = t4 * qd_1;
  const Scalar t12 = t5 * qd_1;
  const Scalar t13 = t11 * t12;
  const Scalar t14 = t10 - Scalar(0.22270588235294117) * t13;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar t15 = omega_4_z * t12;
  const Scalar t16 = qd_1 * t1;
  const Scalar t17 = qd_1 * s_2 * qd_2;
  const Scalar t18 = Scalar(0.25682352941176473) * t7 + Scalar(2.0) * t17 +
      Scalar(1.8458823529411765) * t16;
  const Scalar t19 = Scalar(0.44541176470588234) * t15 + t18;
  const Scalar t20 = c_5 * t14 - s_5 * t19;
  const Scalar t21 = c_5 * t11;
  const Scalar t22 = s_5 * omega_4_z;
  const Scalar omega_r_5_x = t21 + t22;
  const Scalar t23 = s_5 * t11;
  const Scalar t24 = c_5 * omega_4_z;
  const Scalar omega_r_5_y = t24 - t23;
  const Scalar t25 = omega_r_5_x * omega_r_5_y;
  const Scalar t26 = omega_4_z * t11;
  const Scalar t27 = t26 - t25;
  const Scalar t28 = Scalar(0.0149450629075) * t27 - Scalar(0.28794534274300054) * t20;
  const Scalar omega_5_z = qd_5 - t12;
  const Scalar t29 = omega_r_5_x * omega_r_5_x + omega_5_z * omega_5_z;
  const Scalar t30 = Scalar(0.0149450629075) * t29 +
      Scalar(0.28794534274300054) * (c_5 * t19 + s_5 * t14);
  const Scalar t31 = c_5 * t28 - s_5 * t30;
  const Scalar t32 = Scalar(0.4462748022139784) * t10 - t31;
  const Scalar t33 = omega_r_5_y * omega_5_z;
  const Scalar t34 = t12 * (t24 - Scalar(0.5) * t23) + t33;
  const Scalar Uz_o_5_y = t11 * t11 + omega_4_z * omega_4_z;
  const Scalar t35 = t5 * ddp_o_4_y - t4 * t9;
  const Scalar t36 = Scalar(0.064127121625) * Uz_o_5_y - Scalar(0.029890125815) * t34 +
      Scalar(0.734220144956979) * t35;
  const Scalar t37 = s_4 * t32 + c_4 * t36;
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar t38 = Scalar(0.0001321171875) * omega_6_z;
  const Scalar t39 = Scalar(0.000035853228) * t29 + omega_5_z * t38 +
      Scalar(0.003292500193635) * Uz_o_5_y - Scalar(0.0054806000843398) * t33 +
      Scalar(0.0149450629075) * t35;
  const Scalar t40 = omega_r_5_x * omega_5_z;
  const Scalar t41 = (t21 + Scalar(2.0) * t22) * t12;
  const Scalar t42 = Scalar(0.0001321171875) * (t40 + t41) + tau_6;
  const Scalar t43 = Scalar(-0.000035853228) * t27 - Scalar(0.0015110828546699) * t41 +
      Scalar(0.0023263171875) * t40 - t42;
  const Scalar t44 = Scalar(0.0017106935695699) * t13 + s_5 * t39 +
      Scalar(0.22270588235294117) * t31 + c_5 * t43;
  const Scalar t45 = Scalar(0.0575445715) * t3 * s_2_3 * t7 + t44 +
      Scalar(0.9229411764705883) * t37;
  const Scalar t46 = Scalar(0.000035853228) * t41 - omega_r_5_x * t38 +
      Scalar(0.0016432000421699) * t25 - Scalar(0.0038374000421699) * t26 +
      Scalar(0.0149450629075) * t20;
  const Scalar t47 = t46 + tau_5;
  const Scalar t48 = Scalar(0.8580028554367816) * c_5;
  const Scalar y_5_4 = t44 + t48 * t47 + tau_4;
  const Scalar t49 = s_4 - Scalar(0.23305369910246615) * c_4 * s_5;
  const Scalar t50 = c_5 * c_5;
  const Scalar t51 = Scalar(0.0016432000421699) * t50;
  const Scalar t52 = t51 - Scalar(0.0181863807738199) + Scalar(0.05918556107625) * t49;
  const Scalar t53 = s_4 - Scalar(0.23870089068696182);
  const Scalar t54 = t50 * t53;
  const Scalar t55 = t52 - Scalar(0.011834788548693463) * t54;
  const Scalar t56 = Scalar(0.004468174609834886) * t50 - Scalar(0.0181863807738199);
  const Scalar t57 = Scalar(1.0) / t56;
  const Scalar t58 = t55 * t57;
  const Scalar t59 = Scalar(3.594468596105858) * c_5 * t53;
  const Scalar t60 = tau_3 + t45 - t59 * t47 - t58 * y_5_4;
  const Scalar t61 = s_5 * t4;
  const Scalar t62 = Scalar(0.0149450629075) * t61 + Scalar(0.064127121625) * t5;
  const Scalar f_3_3_x = t62 + Scalar(0.677642004375) * s_2_3;
  const Scalar t63 = Scalar(0.064127121625) * t4 - Scalar(0.0149450629075) * s_5 * t5;
  const Scalar t64 = c_2 * (Scalar(0.677642004375) * t3 - t63);
  const Scalar t65 = s_2 * f_3_3_x + t64;
  const Scalar t66 = Scalar(0.9229411764705883) * t53;
  const Scalar t67 = c_2 * t4 - s_2 * t5 + t66;
  const Scalar t68 = t50 * t67;
  const Scalar t69 = c_2 * t63 - Scalar(0.012822906649317328) * t68 - s_2 * t62 + t52;
  const Scalar t70 = t51 + Scalar(0.1183711221525) * t49 - Scalar(0.5901605180175699);
  const Scalar t71 = Scalar(0.053719559287835256) * t67 * t54 - t69 * t58 - t65 + t70;
  const Scalar t72 = Scalar(0.04957999324859619) * t53 * t54 - t55 * t58 + t70;
  const Scalar t73 = Scalar(1.0) / t72;
  const Scalar t74 = t71 * t73;
  const Scalar t75 = t5 * t32 - t4 * t36;
  const Scalar f_3_x = Scalar(0.918932105043021) * t8 + t75;
  const Scalar t76 = Scalar(0.26021797085) * s_2 * t7 + t4 * t32 + t5 * t36 +
      Scalar(0.918932105043021) * ddp_o_3_y;
  const Scalar t77 = t69 * t57;
  const Scalar t78 = Scalar(3.8945803781899033) * c_5 * t67;
  const Scalar t79 = tau_2 + t45 - s_2 * f_3_x - t78 * t47 + c_2 * t76 - t77 * y_5_4 - t74 * t60;
  const Scalar t80 = Scalar(0.058204748750363244) * t67 * t68 - t69 * t77 + t70 -
      Scalar(2.0) * t65 - t71 * t74 - Scalar(1.40804167915);
  const Scalar t81 = Scalar(1.0) / t80;
  const Scalar Ic_4_yz = Scalar(0.003292500193635) * c_5 - Scalar(0.000035853228);
  const Scalar t82 = Scalar(0.0016432000421699) * c_5 * t61 + t5 * Ic_4_yz +
      Scalar(0.25682352941176473) * t62;
  const Scalar t83 = s_5 * (Scalar(1.0834926704907584) * c_2 + t3);
  const Scalar t84 = Scalar(0.003292500193635) * t61 -
      Scalar(0.003838243803185) * t5 * (c_5 + Scalar(0.9997801700313045)) -
      Scalar(0.013793413942275) * t83;
  const Scalar t85 = t84 * t48 + t82;
  const Scalar t86 = t82 + Scalar(0.013793413942275) * s_2_3 * (c_5 + Scalar(9.172679381315092));
  const Scalar t87 = -t84 * t59 - t85 * t58 + t86;
  const Scalar t88 = Scalar(0.0149450629075) * c_5;
  const Scalar t89 = -t84 * t78 - t85 * t77 + t86 - t87 * t74 +
      s_2 * (t88 + Scalar(0.349300285625));
  const Scalar t90 = t89 * t81;
  const Scalar t91 = t87 * t73;
  const Scalar t92 = t85 * t57;
  const Scalar t93 = c_5 * t30 + s_5 * t28;
  const Scalar t94 = t93 + Scalar(0.4462748022139784) * t18;
  const Scalar t95 = t3 * (t6 - Scalar(2.422325143603932) * t16 + Scalar(19.425495399093375) * t94);
  const Scalar t96 = c_2 * (Scalar(0.16073527663193116) * t2 - Scalar(1.317428268386042) * t17 -
      t94);
  const Scalar U_4_yy_zz = t7 - Uz_o_5_y;
  const Scalar t97 = Scalar(0.0056155871391398) * t15 - Scalar(0.000035853228) * U_4_yy_zz -
      c_5 * t39 + Scalar(0.22270588235294117) * t93 + s_5 * t43;
  const Scalar t98 = t5 * (Scalar(0.0021942) * t26 - Scalar(0.000035853228) * t13 - t46);
  const Scalar t99 = Scalar(-260.5931070544678) * t84;
  const Scalar t100 = Scalar(0.25682352941176473) * t75 - t98 - t91 * t60 -
      Scalar(0.047511847575) * t95 + t4 * t97 - tau_1 - t92 * y_5_4 - t90 * t79 + t96 - t99 * t47;
  const Scalar t101 = t3 * (t3 - Scalar(3.2504845342625623) * t63);
  const Scalar Ic_4_xx = Scalar(0.0015110828546699) * t50 + Scalar(0.0127704043495801);
  const Scalar Iu_4_t_d = Ic_4_xx - Scalar(0.0021267064726);
  const Scalar t102 = t5 * (Scalar(0.00658500038727) * t61 + t5 * Iu_4_t_d);
  const Scalar b_2_1_1 = Scalar(0.00767648760637) * c_5 - Scalar(0.0001321171875) * t61 * t61 -
      t102 + Ic_4_xx + t85 * t92 + t87 * t91 + t84 * t99 + t89 * t90 + Scalar(0.1736466166251199) +
      Scalar(0.56787913724375) * t101 + Scalar(2.0) * t64 + Scalar(1.39293427915) * c_2 * c_2;
  const Scalar t103 = t100 / b_2_1_1;
  qdd[0] = -t103;
  const Scalar t104 = t81 * (t89 * t103 + t79);
  qdd[1] = -t104;
  const Scalar t105 = t73 * (t87 * t103 - t71 * t104 + t60);
  qdd[2] = -t105;
  const Scalar t106 = t57 * (t85 * t103 - t69 * t104 - t55 * t105 + y_5_4);
  qdd[3] = -t106;
  const Scalar t107 = t84 * t103 + t88 * (t67 * t104 + t66 * t105) + t47;
  qdd[4] = Scalar(260.5931070544678) * t107 - t48 * t106;
  qdd[5] = c_5 * (t104 + t105) - t61 * t103 + c_5 * t106 + Scalar(7569.03790432263) * t42;
  bool positive = b_2_1_1 > Scalar(0.0);
  positive &= -t80 > Scalar(0.0);
  positive &= -t72 > Scalar(0.0);
  positive &= -t56 > Scalar(0.0);
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
  static_assert(detail::Interface::checked<Scalar>());
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
  const Scalar omega_5_z = qd_5 + t10;
  const Scalar t11 = omega_5_z * (-t9 - Scalar(0.0038374000421699) * omega_5_z +
      Scalar(0.029890125815) * v_r_5_x);
  const Scalar omega_6_z = qd_6 + omega_r_5_y;
  const Scalar omega_r_5_x = s_5 * omega_4_z - c_5 * t8;
  const Scalar t12 = omega_r_5_x *
      (Scalar(0.029890125815) * (s_4 * t6 - c_4 * t4) - Scalar(0.0016432000421699) * omega_r_5_x);
  const Scalar t13 = Scalar(-0.000035853228) * t10;
  const Scalar t14 = omega_4_z * (t13 - Scalar(0.01654318073165) * omega_4_z +
      Scalar(0.12825424325) * t7);
  const Scalar t15 = t8 * (Scalar(0.01434898073165) * t8 + Scalar(0.12825424325) * v_o_4_z);
  const Scalar L_3_z = Scalar(0.12652256366625) * omega_r_3_x +
      Scalar(0.57197413724375) * omega_3_z + Scalar(1.35528400875) * t3;
  const Scalar t16 = omega_r_3_x *
      (Scalar(0.56787913724375) * omega_r_3_x - Scalar(0.12652256366625) * omega_3_z);
  const Scalar L_2_x = Scalar(0.349300285625) * qd_2 - Scalar(1.39293427915) * t2;
  const Scalar L_2_z = Scalar(0.349300285625) * t2 + Scalar(1.40804167915) * qd_2;
  const Scalar T_2 = omega_5_z * t9 - omega_4_z * t13 +
      Scalar(0.0001321171875) * omega_6_z * omega_6_z - t11 - t12 + t15 - t14 - t16 -
      Scalar(1.35528400875) * t1 * t5 + t2 * L_2_x + omega_3_z * L_3_z + qd_2 * L_2_z +
      Scalar(2.1327493394493) * qd_1 * qd_1;
  return Scalar(0.5) * T_2;
}

// Potential energy of links and rotors (7.36).
//   q[6]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[1..4]. Operations: 12 mul, 8 add, 7 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar potential_energy(const Scalar* q, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
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
  static_assert(detail::Interface::checked<Scalar>());
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
  static_assert(detail::Interface::checked<Scalar>());
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
// Reads q[0..5], qd[0..5]. Operations: 133 mul, 70 add, 12 sin/cos.
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
  const Scalar t1 = c_2 * c_3;
  const Scalar t2 = s_2 * s_3 - t1;
  const Scalar t3 = c_2 * s_3;
  const Scalar t4 = t3 + s_2 * c_3;
  const Scalar t5 = s_4 * t2 - c_4 * t4;
  const Scalar t6 = qd_1 * t5;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar omega_4_z = qd_4 + omega_3_z;
  const Scalar t7 = s_5 * omega_4_z;
  const Scalar omega_r_5_x = t7 - c_5 * t6;
  const Scalar t8 = s_4 * t4 + c_4 * t2;
  const Scalar t9 = qd_1 * t8;
  const Scalar omega_5_z = qd_5 + t9;
  const Scalar t10 = qd_6 * (s_6 * omega_5_z - c_6 * omega_r_5_x);
  const Scalar t11 = s_5 * t6;
  const Scalar t12 = c_5 * omega_4_z;
  const Scalar omega_r_5_y = t11 + t12;
  const Scalar domega_q_5_x = qd_5 * omega_r_5_y - t12 * t9;
  const Scalar t13 = omega_4_z * t6;
  const Scalar t14 = c_6 * t13 + t10 - s_6 * domega_q_5_x;
  const Scalar t15 = qd_6 * (s_6 * omega_r_5_x + c_6 * omega_5_z);
  const Scalar t16 = t15 - s_6 * t13 - c_6 * domega_q_5_x;
  const Scalar t17 = s_6 * t14 + c_6 * t16;
  const Scalar t18 = qd_5 * omega_r_5_x - t7 * t9;
  const Scalar domega_e_5_t_x = s_5 * t18 - c_5 * t17;
  const Scalar domega_e_6_a_z = s_6 * t16 - c_6 * t14;
  const Scalar t19 = s_4 * domega_e_5_t_x - c_4 * domega_e_6_a_z;
  const Scalar domega_e_4_t_x = s_4 * domega_e_6_a_z + c_4 * domega_e_5_t_x;
  const Scalar t20 = s_3 * t19 - c_3 * domega_e_4_t_x;
  const Scalar t21 = s_3 * domega_e_4_t_x + c_3 * t19;
  a[5] = c_2 * t21 - s_2 * t20;
  const Scalar t22 = omega_r_5_x * omega_r_5_y + t13;
  const Scalar U_5_zy = Scalar(2.0) * omega_r_5_y * omega_5_z - t9 * (t11 + Scalar(2.0) * t12);
  const Scalar t23 = s_6 * t22 + c_6 * U_5_zy;
  const Scalar t24 = Scalar(4.144215530903328) *
      (t4 * omega_3_z + Scalar(1.0834926704907584) * s_2 * qd_2) - t8 * omega_4_z;
  const Scalar t25 = qd_1 * qd_1;
  const Scalar t26 = Scalar(0.10915) * t25 + Scalar(0.1893) * qd_1 * t24;
  const Scalar t27 = s_2 * t25;
  const Scalar t28 = qd_2 * qd_2 - s_2 * t27 + t25;
  const Scalar t29 = t25 * t4;
  const Scalar t30 = Scalar(0.425) * (t27 * t1 + s_3 * t28) - Scalar(0.39225) * t2 * t29;
  const Scalar t31 = t25 - t4 * t29 + omega_3_z * omega_3_z;
  const Scalar ddp_o_4_x = Scalar(0.39225) * t31 - Scalar(0.425) * (t27 * t3 - c_3 * t28);
  const Scalar t32 = t25 * t5;
  const Scalar t33 = Scalar(0.09465) * t8 * t32 + s_4 * t30 - c_4 * ddp_o_4_x;
  const Scalar t34 = s_5 * t26 + c_5 * t33;
  const Scalar Uz_o_5_y = t5 * t32 + omega_4_z * omega_4_z;
  const Scalar ddp_o_5_y = Scalar(0.09465) * Uz_o_5_y - c_4 * t30 - s_4 * ddp_o_4_x;
  const Scalar t35 = Scalar(0.0823) * t23 - s_6 * t34 - c_6 * ddp_o_5_y;
  const Scalar t36 = s_6 * U_5_zy - c_6 * t22;
  const Scalar t37 = Scalar(0.0823) * t36 - s_6 * ddp_o_5_y + c_6 * t34;
  const Scalar t38 = s_6 * t35 - c_6 * t37;
  const Scalar t39 = omega_5_z * omega_5_z + omega_r_5_x * omega_r_5_x;
  const Scalar t40 = Scalar(0.0823) * t39 - s_5 * t33 + c_5 * t26;
  const Scalar t41 = s_5 * t40 + c_5 * t38;
  const Scalar a_6_a_z = s_6 * t37 + c_6 * t35;
  const Scalar t42 = s_4 * t41 - c_4 * a_6_a_z;
  const Scalar t43 = s_4 * a_6_a_z + c_4 * t41;
  const Scalar t44 = s_3 * t42 - c_3 * t43;
  const Scalar t45 = s_3 * t43 + c_3 * t42;
  a[2] = c_2 * t45 - s_2 * t44;
  const Scalar t46 = s_2 * t45 + c_2 * t44;
  const Scalar t47 = s_5 * t38 - c_5 * t40;
  a[0] = s_1 * t47 - c_1 * t46;
  const Scalar t48 = s_2 * t21 + c_2 * t20;
  const Scalar domega_e_2_a_y = s_5 * t17 + c_5 * t18;
  a[3] = -s_1 * domega_e_2_a_y - c_1 * t48;
  a[4] = c_1 * domega_e_2_a_y - s_1 * t48;
  a[1] = -s_1 * t46 - c_1 * t47;
}

// The functions by type, with the shapes of their arguments: what adapters such as
// flatdyn/eigen.hpp are given.
namespace functions {

struct inverse_dynamics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], const Scalar (&qd)[6], const Scalar (&qdd)[6],
      Scalar (&tau)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::ur5::inverse_dynamics(of...); }
};

struct inverse_dynamics_tip_force {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], const Scalar (&qd)[6], const Scalar (&qdd)[6],
      const Scalar (&h_e)[6], Scalar (&tau)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::ur5::inverse_dynamics_tip_force(of...); }
};

struct inertia_matrix {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], Scalar (&B)[6][6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::ur5::inertia_matrix(of...); }
};

struct christoffel {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], Scalar (&c)[6][21]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::ur5::christoffel(of...); }
};

struct coriolis_matrix {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], const Scalar (&qd)[6], Scalar (&C)[6][6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::ur5::coriolis_matrix(of...); }
};

struct gravity {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], Scalar (&g)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::ur5::gravity(of...); }
};

struct bias {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], const Scalar (&qd)[6], Scalar (&n)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::ur5::bias(of...); }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[6], const Scalar (&qd)[6], const Scalar (&tau)[6],
      Scalar (&qdd)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::ur5::forward_dynamics(of...); }
};

struct kinetic_energy {
  template <class Scalar>
  using Shape = Scalar(const Scalar (&q)[6], const Scalar (&qd)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::ur5::kinetic_energy(of...); }
};

struct potential_energy {
  template <class Scalar>
  using Shape = Scalar(const Scalar (&q)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::ur5::potential_energy(of...); }
};

struct forward_kinematics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], Scalar (&R)[3][3], Scalar (&p)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::ur5::forward_kinematics(of...); }
};

struct jacobian {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], Scalar (&J)[6][6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::ur5::jacobian(of...); }
};

struct jacobian_dot_qd {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[6], const Scalar (&qd)[6], Scalar (&a)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::ur5::jacobian_dot_qd(of...); }
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

}  // namespace ur5

#endif  // FLATDYN_UR5_HPP_A0C298B1

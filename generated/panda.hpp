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

#ifndef FLATDYN_PANDA_HPP_118E1594
#define FLATDYN_PANDA_HPP_118E1594

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
//   q[7]    in   joint positions, rad or m
//   qd[7]   in   joint velocities, rad/s or m/s
//   qdd[7]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[7]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..6], qd[0..6], qdd[0..6]. Operations: 273 mul, 256 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5], qdd_7 = qdd[6];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5],
      s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = s_2 * qd_1;
  const Scalar t2 = c_2 * qd_1;
  const Scalar t3 = t1 * t2;
  const Scalar Uz_o_3_x = qdd_2 - t3;
  const Scalar t4 = s_2 * qdd_1;
  const Scalar Uz_o_3_z = t4 + Scalar(2.0) * qd_2 * t2;
  const Scalar t5 = c_3 * Uz_o_3_z;
  const Scalar t6 = s_3 * Uz_o_3_x - t5;
  const Scalar omega_r_3_y = s_3 * t1 + c_3 * qd_2;
  const Scalar omega_3_z = qd_3 + t2;
  const Scalar t7 = t6 + Scalar(2.0) * omega_r_3_y * omega_3_z;
  const Scalar t8 = qd_2 * t1;
  const Scalar t9 = c_2 * qdd_1;
  const Scalar t10 = t8 - t9;
  const Scalar domega_3_z = qdd_3 - t10;
  const Scalar t11 = s_3 * qd_2 - c_3 * t1;
  const Scalar t12 = t11 * omega_r_3_y;
  const Scalar Uz_o_4_x = domega_3_z - t12;
  const Scalar t13 = s_4 * Uz_o_4_x + c_4 * t7;
  const Scalar t14 = s_4 * t11 - c_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar t15 = t13 - Scalar(2.0) * t14 * omega_4_z;
  const Scalar t16 = s_3 * Uz_o_3_z;
  const Scalar Uz_3_x = c_3 * Uz_o_3_x + t16;
  const Scalar t17 = t11 * omega_3_z;
  const Scalar domega_3_y = Uz_3_x - t17;
  const Scalar domega_4_z = qdd_4 - domega_3_y;
  const Scalar t18 = c_4 * t11 + s_4 * omega_3_z;
  const Scalar t19 = t18 * t14;
  const Scalar t20 = t19 + domega_4_z;
  const Scalar t21 = s_5 * t20 - c_5 * t15;
  const Scalar omega_r_6_a_z = s_5 * t18 + c_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 - t14;
  const Scalar Uz_o_6_z = t21 + Scalar(2.0) * omega_r_6_a_z * omega_5_z;
  const Scalar t22 = s_4 * t7 - c_4 * Uz_o_4_x;
  const Scalar t23 = t18 * omega_4_z;
  const Scalar t24 = t23 + t22;
  const Scalar domega_5_z = qdd_5 - t24;
  const Scalar t25 = s_5 * omega_4_z - c_5 * t18;
  const Scalar t26 = t25 * omega_r_6_a_z;
  const Scalar Uz_o_6_x = domega_5_z - t26;
  const Scalar t27 = s_6 * Uz_o_6_x - c_6 * Uz_o_6_z;
  const Scalar omega_r_6_y = s_6 * t25 + c_6 * omega_5_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t28 = Scalar(2.0) * omega_6_z;
  const Scalar t29 = t27 + omega_r_6_y * t28;
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar t30 = t29 + t28 * omega_7_z;
  const Scalar mr_7_y = Scalar(0.0006428830269371278) * c_7 + Scalar(0.0008132592973428722) * s_7;
  const Scalar t31 = c_5 * t20 + s_5 * t15;
  const Scalar t32 = t25 * omega_5_z;
  const Scalar domega_r_6_z = t31 - t32;
  const Scalar domega_6_z = qdd_6 + domega_r_6_z;
  const Scalar t33 = s_6 * omega_5_z - c_6 * t25;
  const Scalar t34 = t33 * omega_r_6_y;
  const Scalar Uz_o_7_x = domega_6_z - t34;
  const Scalar t35 = Uz_o_7_x - Scalar(2.0) * t33 * omega_7_z;
  const Scalar mr_7_x = Scalar(0.0008132592973428722) * c_7 - Scalar(0.0006428830269371278) * s_7;
  const Scalar U_6_yx = t34 + domega_6_z;
  const Scalar t36 = t23 + t24;
  const Scalar t37 = Scalar(31.044303797468356) * s_2 - Uz_o_3_x;
  const Scalar ddp_3_y = t5 + s_3 * t37;
  const Scalar U_3_yx = t12 + domega_3_z;
  const Scalar ddp_o_4_y = Scalar(0.2610759493670886) * U_3_yx + ddp_3_y;
  const Scalar t38 = Scalar(0.2610759493670886) * t36 + ddp_o_4_y -
      Scalar(1.2151898734177216) * t15;
  const Scalar t39 = t17 - domega_3_y;
  const Scalar t40 = t1 * t1;
  const Scalar t41 = qd_2 * qd_2;
  const Scalar Uz_o_3_y = t40 + t41;
  const Scalar ddp_3_a_z = Scalar(31.044303797468356) * c_2 - Uz_o_3_y;
  const Scalar t42 = Scalar(0.2610759493670886) * t39 + ddp_3_a_z;
  const Scalar t43 = t11 * t11;
  const Scalar t44 = omega_3_z * omega_3_z;
  const Scalar t45 = t44 - t43;
  const Scalar t46 = Uz_o_3_y + t45;
  const Scalar ddp_3_x = t16 - c_3 * t37;
  const Scalar t47 = Scalar(0.2610759493670886) * t46 - ddp_3_x;
  const Scalar t48 = s_4 * t42 - c_4 * t47;
  const Scalar t49 = t18 * t18;
  const Scalar t50 = omega_4_z * omega_4_z;
  const Scalar t51 = t50 - t49;
  const Scalar Uz_o_4_y = t43 + t44;
  const Scalar t52 = Uz_o_4_y + t51;
  const Scalar ddp_o_5_x = Scalar(0.2610759493670886) * t52 - Scalar(1.2151898734177216) * t20 +
      t48;
  const Scalar ddp_5_x = s_5 * t38 + c_5 * ddp_o_5_x;
  const Scalar t53 = s_4 * t47 + c_4 * t42;
  const Scalar U_4_yx = domega_4_z - t19;
  const Scalar t54 = t50 + t49;
  const Scalar t55 = Scalar(0.2610759493670886) * U_4_yx + Scalar(1.2151898734177216) * t54 - t53;
  const Scalar ddp_o_7_y = Scalar(0.27848101265822783) * U_6_yx - s_6 * ddp_5_x - c_6 * t55;
  const Scalar f_u_7_a_y = mr_7_x * t35 - mr_7_y * t30 + Scalar(0.26308374115809) * ddp_o_7_y;
  const Scalar Uz_6_x = s_6 * Uz_o_6_z + c_6 * Uz_o_6_x;
  const Scalar t56 = t33 * omega_6_z;
  const Scalar domega_6_y = Uz_6_x - t56;
  const Scalar domega_7_z = qdd_7 - domega_6_y;
  const Scalar t57 = t56 - domega_7_z;
  const Scalar t58 = Scalar(0.0012555365982728983) * c_7 + Scalar(0.0009653051699191118) * s_7;
  const Scalar I_t7_g = Scalar(0.00242094377852123) * c_7 - Scalar(0.000782782563368496) * s_7;
  const Scalar I_7_xy = Scalar(0.000391391281684248) + s_7 * I_t7_g;
  const Scalar t59 = c_7 * I_t7_g;
  const Scalar t60 = t59 - Scalar(0.004552547872941088);
  const Scalar t61 = s_6 * t55 - c_6 * ddp_5_x;
  const Scalar t62 = omega_7_z * omega_7_z;
  const Scalar t63 = omega_6_z * omega_6_z;
  const Scalar t64 = t63 + t62;
  const Scalar t65 = t33 * t33;
  const Scalar Uz_o_7_y = t65 + t63;
  const Scalar t66 = Scalar(0.0009653051699191118) * c_7 - Scalar(0.0012555365982728983) * s_7;
  const Scalar t67 = t63 - t65;
  const Scalar t68 = t25 * t25;
  const Scalar t69 = omega_5_z * omega_5_z;
  const Scalar Uz_o_6_y = t68 + t69;
  const Scalar t70 = Uz_o_6_y + t67;
  const Scalar mu_6_z = Scalar(0.000093569097314605) * Uz_6_x - Scalar(0.000103758917218685) * t27 +
      mr_7_x * ddp_o_7_y + Scalar(0.001119670733427555) * U_6_yx + t66 * (Uz_o_7_y - t64) +
      t57 * t58 + t30 * I_7_xy - t35 * t60 - Scalar(0.014748570382675316) * (t70 - Uz_o_7_y) +
      Scalar(0.028934422545659894) * Uz_o_7_x - Scalar(0.054922286959804) * t61 +
      Scalar(0.27848101265822783) * f_u_7_a_y;
  tau[5] = mu_6_z;
  const Scalar t71 = t56 + domega_7_z;
  const Scalar I_7_xx = t59 + Scalar(0.002131604094419858);
  const Scalar t72 = t56 - domega_6_y;
  const Scalar ddp_6_a_z = s_5 * ddp_o_5_x - c_5 * t38;
  const Scalar ddp_o_7_z = Scalar(0.27848101265822783) * t72 + ddp_6_a_z;
  const Scalar t73 = Scalar(0.27848101265822783) * t70 + t61;
  const Scalar t74 = t65 + t62;
  const Scalar t75 = -mr_7_y * t73 - mr_7_x * ddp_o_7_z + I_7_xy * (t64 - t74) + t29 * t66 +
      Uz_o_7_x * t58 + t57 * I_7_xx + t71 * t60;
  tau[6] = -t75;
  const Scalar F_7_y = mr_7_x * t71 - mr_7_y * t74 + Scalar(0.26308374115809) * ddp_o_7_z;
  const Scalar t76 = Scalar(0.000103758917218685) * t67 - Scalar(0.000093569097314605) * Uz_o_7_x +
      Scalar(0.001119670733427555) * t72 - t75 - Scalar(0.014748570382675316) * t29 +
      Scalar(0.27848101265822783) * F_7_y;
  const Scalar U_7_yy_zz = Uz_o_7_y - t74;
  const Scalar U_6_yy_zz = Uz_o_6_y - Uz_o_7_y;
  const Scalar t77 = Scalar(0.000103758917218685) * U_6_yx -
      Scalar(0.000093569097314605) * U_6_yy_zz + mr_7_y * ddp_o_7_y + t58 * U_7_yy_zz + t71 * t66 -
      t35 * I_7_xy - t30 * I_7_xx + Scalar(0.014748570382675316) * t72 -
      Scalar(0.028934422545659894) * t29 + Scalar(0.054922286959804) * ddp_6_a_z;
  const Scalar U_5_yx = t26 + domega_5_z;
  const Scalar t78 = t69 - t68;
  const Scalar t79 = t54 + t78;
  const Scalar t80 = Scalar(0.00216405205209813) * t31 - Scalar(0.001451156065026714) * U_5_yx -
      Scalar(0.00151524447332703) * (t79 - Uz_o_6_y) - Scalar(0.004600245517563106) * t21 -
      Scalar(0.004630579482008) * ddp_6_a_z - Scalar(0.010045187828321245) * Uz_o_6_x +
      Scalar(0.0214471195303) * ddp_5_x + s_6 * t77 + c_6 * t76;
  tau[4] = -t80;
  const Scalar f_6_y = Scalar(0.054922286959804) * Uz_o_7_y + f_u_7_a_y;
  const Scalar f_6_x = mr_7_y * t57 - mr_7_x * t64 + Scalar(0.054922286959804) * Uz_o_7_x -
      Scalar(0.26308374115809) * t73;
  const Scalar f_5_x = Scalar(0.004630579482008) * t79 - Scalar(0.0214471195303) * Uz_o_6_x -
      s_6 * f_6_y + c_6 * f_6_x + Scalar(0.4059881025443391) * ddp_5_x;
  const Scalar t81 = Scalar(0.004630579482008) * U_5_yx + Scalar(0.0214471195303) * Uz_o_6_y -
      Scalar(0.054922286959804) * t29 + Scalar(0.4059881025443391) * ddp_6_a_z + F_7_y;
  const Scalar f_u_5_t_x = s_5 * t81 + c_5 * f_5_x;
  const Scalar t82 = t32 - domega_r_6_z;
  const Scalar U_5_yy_zz = t54 - Uz_o_6_y;
  const Scalar t83 = Scalar(0.00151524447332703) * t82 - Scalar(0.00216405205209813) * U_5_yy_zz +
      Scalar(0.004600245517563106) * U_5_yx + Scalar(0.010045187828321245) * Uz_o_6_z +
      Scalar(0.0214471195303) * t55 + c_6 * t77 - s_6 * t76;
  const Scalar f_5_z = Scalar(0.004630579482008) * t82 - Scalar(0.0214471195303) * Uz_o_6_z +
      s_6 * f_6_x + c_6 * f_6_y - Scalar(0.4059881025443391) * t55;
  const Scalar t84 = Scalar(-0.00216405205209813) * Uz_o_6_x - Scalar(0.001451156065026714) * t82 -
      Scalar(0.00151524447332703) * Uz_o_6_z + Scalar(0.004600245517563106) * t78 +
      Scalar(0.004630579482008) * t55 + mu_6_z;
  const Scalar tau_4 = Scalar(0.00164448757736927) * t22 + Scalar(0.0039053550262761) * t13 +
      Scalar(0.0054157634981905) * U_4_yx + Scalar(0.04942675278013915) * (t52 - t54) +
      Scalar(0.17709188611756838) * t48 + s_5 * t83 + c_5 * t84 -
      Scalar(0.29071723622709367) * t20 - Scalar(0.2610759493670886) * f_5_z -
      Scalar(1.2151898734177216) * f_u_5_t_x;
  tau[3] = tau_4;
  const Scalar t85 = s_5 * f_5_x - c_5 * t81;
  const Scalar U_4_yy_zz = Uz_o_4_y - t54;
  const Scalar mu_4_x = Scalar(0.0039053550262761) * U_4_yx -
      Scalar(0.00164448757736927) * U_4_yy_zz + Scalar(0.04942675278013915) * t36 +
      Scalar(0.17709188611756838) * ddp_o_4_y + s_5 * t84 - c_5 * t83 -
      Scalar(0.29071723622709367) * t15 - Scalar(1.2151898734177216) * t85;
  const Scalar t86 = Scalar(0.0039053550262761) * t51 - Scalar(0.00164448757736927) * t20 -
      Scalar(0.0054157634981905) * t36 - Scalar(0.04942675278013915) * t15 - t80 -
      Scalar(0.2610759493670886) * t85;
  const Scalar t87 = Scalar(0.17709188611756838) * t15 + Scalar(0.23490692527912765) * ddp_o_4_y +
      t85;
  const Scalar mu_u_3_a_y = Scalar(0.000013360662912304) * U_3_yx -
      Scalar(0.000121912420950744) * (t46 - Uz_o_4_y) + Scalar(0.004377257121839584) * Uz_3_x +
      Scalar(0.005487648106562256) * t6 + Scalar(0.008919761981448) * ddp_3_x -
      Scalar(0.022178148964878235) * Uz_o_4_x - Scalar(0.2610759493670886) * t87 - c_4 * t86 -
      s_4 * mu_4_x;
  tau[2] = -mu_u_3_a_y;
  const Scalar f_4_x = Scalar(0.17709188611756838) * t20 + Scalar(0.23490692527912765) * t48 +
      f_u_5_t_x;
  const Scalar f_4_y = Scalar(0.17709188611756838) * t54 + Scalar(0.23490692527912765) * t53 +
      f_5_z;
  const Scalar f_u_4_t_y = s_4 * f_4_x + c_4 * f_4_y;
  const Scalar t88 = Scalar(0.000121912420950744) * t7 - Scalar(0.000013360662912304) * t39 +
      Scalar(0.005487648106562256) * t45 + Scalar(0.013297019103287584) * Uz_o_4_x -
      Scalar(0.15288324476823525) * ddp_3_x + Scalar(0.2610759493670886) * f_u_4_t_y + s_4 * f_4_y -
      c_4 * f_4_x + tau_4;
  const Scalar t89 = Scalar(0.000121912420950744) * t39 - Scalar(0.005487648106562256) * U_3_yx +
      Scalar(0.27690780075318) * c_2 - Scalar(0.013297019103287584) * (Uz_o_3_y - Uz_o_4_y) +
      Scalar(0.022178148964878235) * t7 - Scalar(0.15288324476823525) * ddp_3_y - s_4 * t86 - t87 +
      c_4 * mu_4_x;
  const Scalar U_2_yx = t3 + qdd_2;
  const Scalar t90 = qd_1 * qd_1;
  tau[1] = Scalar(0.01993386669246) * c_2 - Scalar(0.0007689361029464) * t9 -
      Scalar(0.00796671776787104) * t40 + Scalar(0.00398335888393552) * t90 -
      Scalar(0.01026110182100817) * t4 - Scalar(0.024699952517911183) * Uz_o_3_x +
      Scalar(0.023077882494931805) * U_2_yx - c_3 * t88 + s_3 * t89;
  const Scalar t91 = t8 + t10;
  const Scalar mu_2_x = Scalar(-0.0007689361029464) * (Uz_o_3_y - t90) -
      Scalar(0.00398335888393552) * t91 + Scalar(0.01026110182100817) * U_2_yx +
      Scalar(0.024699952517911183) * Uz_o_3_z + s_3 * t88 + c_3 * t89;
  const Scalar mu_2_y = Scalar(0.0007689361029464) * Uz_o_3_x +
      Scalar(0.00398335888393552) * Uz_o_3_z + Scalar(0.01026110182100817) * (t41 - t40) +
      Scalar(0.023077882494931805) * t91 + mu_u_3_a_y;
  tau[0] = Scalar(0.014259565994474374) * qdd_1 - c_2 * mu_2_y - s_2 * mu_2_x;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[7]    in   joint positions, rad or m
//   qd[7]   in   joint velocities, rad/s or m/s
//   qdd[7]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[7]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..6], qd[0..6], qdd[0..6], h_e[0..5]. Operations: 353 mul, 298 add, 14 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics_tip_force(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    const Scalar* h_e, Scalar* tau, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
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
  const Scalar t1 = s_2 * qd_1;
  const Scalar t2 = c_2 * qd_1;
  const Scalar t3 = t1 * t2;
  const Scalar Uz_o_3_x = qdd_2 - t3;
  const Scalar t4 = s_2 * qdd_1;
  const Scalar Uz_o_3_z = t4 + Scalar(2.0) * qd_2 * t2;
  const Scalar t5 = c_3 * Uz_o_3_z;
  const Scalar t6 = s_3 * Uz_o_3_x - t5;
  const Scalar omega_r_3_y = s_3 * t1 + c_3 * qd_2;
  const Scalar omega_3_z = qd_3 + t2;
  const Scalar t7 = t6 + Scalar(2.0) * omega_r_3_y * omega_3_z;
  const Scalar t8 = qd_2 * t1;
  const Scalar t9 = c_2 * qdd_1;
  const Scalar t10 = t8 - t9;
  const Scalar domega_3_z = qdd_3 - t10;
  const Scalar t11 = s_3 * qd_2 - c_3 * t1;
  const Scalar t12 = t11 * omega_r_3_y;
  const Scalar Uz_o_4_x = domega_3_z - t12;
  const Scalar t13 = s_4 * Uz_o_4_x + c_4 * t7;
  const Scalar t14 = s_4 * t11 - c_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar t15 = t13 - Scalar(2.0) * t14 * omega_4_z;
  const Scalar t16 = s_3 * Uz_o_3_z;
  const Scalar Uz_3_x = c_3 * Uz_o_3_x + t16;
  const Scalar t17 = t11 * omega_3_z;
  const Scalar domega_3_y = Uz_3_x - t17;
  const Scalar domega_4_z = qdd_4 - domega_3_y;
  const Scalar t18 = c_4 * t11 + s_4 * omega_3_z;
  const Scalar t19 = t18 * t14;
  const Scalar t20 = t19 + domega_4_z;
  const Scalar t21 = s_5 * t20 - c_5 * t15;
  const Scalar omega_r_6_a_z = s_5 * t18 + c_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 - t14;
  const Scalar Uz_o_6_z = t21 + Scalar(2.0) * omega_r_6_a_z * omega_5_z;
  const Scalar t22 = s_4 * t7 - c_4 * Uz_o_4_x;
  const Scalar t23 = t18 * omega_4_z;
  const Scalar t24 = t23 + t22;
  const Scalar domega_5_z = qdd_5 - t24;
  const Scalar t25 = s_5 * omega_4_z - c_5 * t18;
  const Scalar t26 = t25 * omega_r_6_a_z;
  const Scalar Uz_o_6_x = domega_5_z - t26;
  const Scalar Uz_6_x = s_6 * Uz_o_6_z + c_6 * Uz_o_6_x;
  const Scalar t27 = s_6 * omega_5_z - c_6 * t25;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t28 = t27 * omega_6_z;
  const Scalar domega_6_y = Uz_6_x - t28;
  const Scalar t29 = t28 - domega_6_y;
  const Scalar t30 = t17 - domega_3_y;
  const Scalar t31 = t1 * t1;
  const Scalar t32 = qd_2 * qd_2;
  const Scalar Uz_o_3_y = t31 + t32;
  const Scalar ddp_3_a_z = Scalar(9.81) * c_2 - Scalar(0.316) * Uz_o_3_y;
  const Scalar t33 = Scalar(0.0825) * t30 + ddp_3_a_z;
  const Scalar t34 = t11 * t11;
  const Scalar t35 = omega_3_z * omega_3_z;
  const Scalar t36 = t35 - t34;
  const Scalar t37 = Uz_o_3_y + t36;
  const Scalar t38 = Scalar(9.81) * s_2 - Scalar(0.316) * Uz_o_3_x;
  const Scalar ddp_3_x = Scalar(0.316) * t16 - c_3 * t38;
  const Scalar t39 = Scalar(0.0825) * t37 - ddp_3_x;
  const Scalar t40 = s_4 * t33 - c_4 * t39;
  const Scalar t41 = t18 * t18;
  const Scalar t42 = omega_4_z * omega_4_z;
  const Scalar t43 = t42 - t41;
  const Scalar Uz_o_4_y = t34 + t35;
  const Scalar t44 = Uz_o_4_y + t43;
  const Scalar ddp_o_5_x = Scalar(0.0825) * t44 + t40 - Scalar(0.384) * t20;
  const Scalar t45 = t23 + t24;
  const Scalar ddp_3_y = Scalar(0.316) * t5 + s_3 * t38;
  const Scalar U_3_yx = t12 + domega_3_z;
  const Scalar ddp_o_4_y = Scalar(0.0825) * U_3_yx + ddp_3_y;
  const Scalar t46 = Scalar(0.0825) * t45 + ddp_o_4_y - Scalar(0.384) * t15;
  const Scalar ddp_6_a_z = s_5 * ddp_o_5_x - c_5 * t46;
  const Scalar ddp_o_7_z = Scalar(0.088) * t29 + ddp_6_a_z;
  const Scalar ddp_5_x = c_5 * ddp_o_5_x + s_5 * t46;
  const Scalar t47 = s_4 * t39 + c_4 * t33;
  const Scalar U_4_yx = domega_4_z - t19;
  const Scalar t48 = t42 + t41;
  const Scalar t49 = Scalar(0.0825) * U_4_yx + Scalar(0.384) * t48 - t47;
  const Scalar t50 = s_6 * t49 - c_6 * ddp_5_x;
  const Scalar t51 = t27 * t27;
  const Scalar t52 = omega_6_z * omega_6_z;
  const Scalar t53 = t52 - t51;
  const Scalar t54 = t25 * t25;
  const Scalar t55 = omega_5_z * omega_5_z;
  const Scalar Uz_o_6_y = t54 + t55;
  const Scalar t56 = Uz_o_6_y + t53;
  const Scalar t57 = Scalar(0.088) * t56 + t50;
  const Scalar t58 = s_7 * ddp_o_7_z - c_7 * t57;
  const Scalar ddp_7_y = s_7 * t57 + c_7 * ddp_o_7_z;
  const Scalar t59 = s_6 * Uz_o_6_x - c_6 * Uz_o_6_z;
  const Scalar omega_r_6_y = s_6 * t25 + c_6 * omega_5_z;
  const Scalar t60 = t59 + Scalar(2.0) * omega_r_6_y * omega_6_z;
  const Scalar t61 = c_5 * t20 + s_5 * t15;
  const Scalar t62 = t25 * omega_5_z;
  const Scalar domega_r_6_z = t61 - t62;
  const Scalar domega_6_z = qdd_6 + domega_r_6_z;
  const Scalar t63 = t27 * omega_r_6_y;
  const Scalar Uz_o_7_x = domega_6_z - t63;
  const Scalar t64 = s_7 * t60 - c_7 * Uz_o_7_x;
  const Scalar t65 = s_7 * Uz_o_7_x + c_7 * t60;
  const Scalar domega_7_z = qdd_7 - domega_6_y;
  const Scalar t66 = s_7 * omega_6_z + c_7 * t27;
  const Scalar t67 = s_7 * t27 - c_7 * omega_6_z;
  const Scalar t68 = t66 * t67;
  const Scalar t69 = t68 + domega_7_z;
  const Scalar U_7_yx = domega_7_z - t68;
  const Scalar t70 = t66 * t66;
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar t71 = omega_7_z * omega_7_z;
  const Scalar t72 = t71 - t70;
  const Scalar Uz_o_7_y = t51 + t52;
  const Scalar t73 = Uz_o_7_y + t72;
  const Scalar t74 = t71 + t70;
  const Scalar mu_e1_x = s_1 * h_e_5 + c_1 * h_e_4;
  const Scalar t75 = s_2 * h_e_6 - c_2 * mu_e1_x;
  const Scalar t76 = s_1 * h_e_4 - c_1 * h_e_5;
  const Scalar t77 = s_3 * t76 + c_3 * t75;
  const Scalar mu_e3_a_z = s_2 * mu_e1_x + c_2 * h_e_6;
  const Scalar mu_e4_x = s_4 * mu_e3_a_z - c_4 * t77;
  const Scalar mu_e3_y = s_3 * t75 - c_3 * t76;
  const Scalar mu_e5_x = s_5 * mu_e3_y + c_5 * mu_e4_x;
  const Scalar mu_e4_y = s_4 * t77 + c_4 * mu_e3_a_z;
  const Scalar tau_7 = Scalar(0.002573605371338203) * ddp_7_y - Scalar(0.002034439958661797) * t58 -
      Scalar(0.000391391281684248) * (t73 - t74) + Scalar(0.0012555365982728983) * t64 -
      Scalar(0.0009653051699191118) * t65 + Scalar(0.002131604094419858) * U_7_yx +
      Scalar(0.004552547872941088) * t69 + s_6 * mu_e5_x - c_6 * mu_e4_y;
  tau[6] = tau_7;
  const Scalar t78 = Scalar(2.0) * omega_7_z;
  const Scalar t79 = t64 + t66 * t78;
  const Scalar t80 = t65 - t67 * t78;
  const Scalar U_6_yx = t63 + domega_6_z;
  const Scalar ddp_o_7_y = Scalar(0.088) * U_6_yx - c_6 * t49 - s_6 * ddp_5_x;
  const Scalar f_e1_x = s_1 * h_e_2 + c_1 * h_e_1;
  const Scalar t81 = s_2 * h_e_3 - c_2 * f_e1_x;
  const Scalar t82 = s_1 * h_e_1 - c_1 * h_e_2;
  const Scalar t83 = s_3 * t82 + c_3 * t81;
  const Scalar f_e3_a_z = s_2 * f_e1_x + c_2 * h_e_3;
  const Scalar f_e4_x = s_4 * f_e3_a_z - c_4 * t83;
  const Scalar f_e3_y = s_3 * t81 - c_3 * t82;
  const Scalar f_e5_x = s_5 * f_e3_y + c_5 * f_e4_x;
  const Scalar f_e4_y = s_4 * t83 + c_4 * f_e3_a_z;
  const Scalar f_e6_x = s_6 * f_e4_y + c_6 * f_e5_x;
  const Scalar t84 = s_5 * f_e4_x - c_5 * f_e3_y;
  const Scalar t85 = s_7 * f_e6_x - c_7 * t84;
  const Scalar U_7_yy_zz = Uz_o_7_y - t74;
  const Scalar mu_e6_x = s_6 * mu_e4_y + c_6 * mu_e5_x;
  const Scalar t86 = s_5 * mu_e4_x - c_5 * mu_e3_y;
  const Scalar mu_7_x = Scalar(-0.000391391281684248) * t79 -
      Scalar(0.002034439958661797) * ddp_o_7_y - Scalar(0.0009653051699191118) * U_7_yx -
      Scalar(0.0012555365982728983) * U_7_yy_zz + Scalar(0.004552547872941088) * t80 +
      Scalar(0.2104) * t85 + s_7 * t86 + c_7 * mu_e6_x;
  const Scalar f_e7_x = s_7 * t84 + c_7 * f_e6_x;
  const Scalar mu_7_y = Scalar(0.000391391281684248) * t80 - Scalar(0.0009653051699191118) * t72 +
      Scalar(0.002573605371338203) * ddp_o_7_y - Scalar(0.0012555365982728983) * t69 -
      Scalar(0.002131604094419858) * t79 + Scalar(0.2104) * f_e7_x - s_7 * mu_e6_x + c_7 * t86;
  const Scalar t87 = Scalar(0.002034439958661797) * t80 + Scalar(0.002573605371338203) * t79 +
      s_6 * f_e5_x - c_6 * f_e4_y - Scalar(2.634631280625) * ddp_o_7_y;
  const Scalar mu_6_z = Scalar(0.000093569097314605) * Uz_6_x - Scalar(0.000103758917218685) * t59 +
      Scalar(0.001119670733427555) * U_6_yx - Scalar(0.014748570382675316) * (t56 - Uz_o_7_y) +
      Scalar(0.028934422545659894) * Uz_o_7_x - Scalar(0.173804705569) * t50 - Scalar(0.088) * t87 +
      s_7 * mu_7_x + c_7 * mu_7_y;
  tau[5] = mu_6_z;
  const Scalar f_7_x = Scalar(-0.002573605371338203) * t73 - Scalar(0.002034439958661797) * t69 +
      f_e7_x + Scalar(2.634631280625) * t58;
  const Scalar t88 = Scalar(0.002034439958661797) * t74 - Scalar(0.002573605371338203) * U_7_yx +
      t85 - Scalar(2.634631280625) * ddp_7_y;
  const Scalar t89 = s_7 * f_7_x - c_7 * t88;
  const Scalar t90 = Scalar(0.000103758917218685) * t53 - Scalar(0.000093569097314605) * Uz_o_7_x +
      Scalar(0.001119670733427555) * t29 - Scalar(0.014748570382675316) * t60 +
      Scalar(0.088) * t89 + tau_7;
  const Scalar U_6_yy_zz = Uz_o_6_y - Uz_o_7_y;
  const Scalar t91 = Scalar(0.000103758917218685) * U_6_yx -
      Scalar(0.000093569097314605) * U_6_yy_zz + Scalar(0.014748570382675316) * t29 -
      Scalar(0.028934422545659894) * t60 + Scalar(0.173804705569) * ddp_6_a_z + s_7 * mu_7_y -
      c_7 * mu_7_x;
  const Scalar U_5_yx = t26 + domega_5_z;
  const Scalar t92 = t55 - t54;
  const Scalar t93 = t48 + t92;
  const Scalar t94 = Scalar(0.00216405205209813) * t61 - Scalar(0.001451156065026714) * U_5_yx -
      Scalar(0.00151524447332703) * (t93 - Uz_o_6_y) - Scalar(0.004600245517563106) * t21 -
      Scalar(0.014653732538) * ddp_6_a_z - Scalar(0.010045187828321245) * Uz_o_6_x +
      Scalar(0.067870631425) * ddp_5_x + s_6 * t91 + c_6 * t90;
  tau[4] = -t94;
  const Scalar f_6_x = Scalar(0.173804705569) * Uz_o_7_x + s_7 * t88 + c_7 * f_7_x;
  const Scalar f_6_y = Scalar(0.173804705569) * Uz_o_7_y - t87;
  const Scalar f_5_x = Scalar(0.014653732538) * t93 - Scalar(0.067870631425) * Uz_o_6_x -
      s_6 * f_6_y + c_6 * f_6_x + Scalar(4.065735684829545) * ddp_5_x;
  const Scalar t95 = Scalar(0.014653732538) * U_5_yx + Scalar(0.067870631425) * Uz_o_6_y -
      Scalar(0.173804705569) * t60 + Scalar(4.065735684829545) * ddp_6_a_z + t89;
  const Scalar f_u_5_t_x = s_5 * t95 + c_5 * f_5_x;
  const Scalar t96 = t62 - domega_r_6_z;
  const Scalar U_5_yy_zz = t48 - Uz_o_6_y;
  const Scalar t97 = Scalar(0.00151524447332703) * t96 - Scalar(0.00216405205209813) * U_5_yy_zz +
      Scalar(0.004600245517563106) * U_5_yx + Scalar(0.010045187828321245) * Uz_o_6_z +
      Scalar(0.067870631425) * t49 - s_6 * t90 + c_6 * t91;
  const Scalar f_5_z = Scalar(0.014653732538) * t96 - Scalar(0.067870631425) * Uz_o_6_z +
      s_6 * f_6_x + c_6 * f_6_y - Scalar(4.065735684829545) * t49;
  const Scalar t98 = Scalar(-0.00216405205209813) * Uz_o_6_x - Scalar(0.001451156065026714) * t96 -
      Scalar(0.00151524447332703) * Uz_o_6_z + Scalar(0.004600245517563106) * t92 +
      Scalar(0.014653732538) * t49 + mu_6_z;
  const Scalar tau_4 = Scalar(0.00164448757736927) * t22 + Scalar(0.0039053550262761) * t13 +
      Scalar(0.0054157634981905) * U_4_yx + Scalar(0.04942675278013915) * (t44 - t48) +
      Scalar(0.5604173611315455) * t40 - Scalar(0.29071723622709367) * t20 -
      Scalar(0.0825) * f_5_z + s_5 * t97 + c_5 * t98 - Scalar(0.384) * f_u_5_t_x;
  tau[3] = tau_4;
  const Scalar t99 = s_5 * f_5_x - c_5 * t95;
  const Scalar U_4_yy_zz = Uz_o_4_y - t48;
  const Scalar mu_4_x = Scalar(0.0039053550262761) * U_4_yx -
      Scalar(0.00164448757736927) * U_4_yy_zz + Scalar(0.04942675278013915) * t45 +
      Scalar(0.5604173611315455) * ddp_o_4_y + s_5 * t98 - c_5 * t97 -
      Scalar(0.29071723622709367) * t15 - Scalar(0.384) * t99;
  const Scalar t100 = Scalar(0.0039053550262761) * t43 - Scalar(0.00164448757736927) * t20 -
      Scalar(0.0054157634981905) * t45 - Scalar(0.04942675278013915) * t15 - Scalar(0.0825) * t99 -
      t94;
  const Scalar t101 = Scalar(2.352456790569697) * ddp_o_4_y + Scalar(0.5604173611315455) * t15 +
      t99;
  const Scalar mu_u_3_a_y = Scalar(0.000013360662912304) * U_3_yx -
      Scalar(0.000121912420950744) * (t37 - Uz_o_4_y) + Scalar(0.004377257121839584) * Uz_3_x +
      Scalar(0.005487648106562256) * t6 + Scalar(0.028227094878) * ddp_3_x -
      Scalar(0.022178148964878235) * Uz_o_4_x - Scalar(0.0825) * t101 - c_4 * t100 - s_4 * mu_4_x;
  tau[2] = -mu_u_3_a_y;
  const Scalar f_4_x = Scalar(0.5604173611315455) * t20 + Scalar(2.352456790569697) * t40 +
      f_u_5_t_x;
  const Scalar f_4_y = Scalar(0.5604173611315455) * t48 + Scalar(2.352456790569697) * t47 + f_5_z;
  const Scalar t102 = Scalar(0.028227094878) * Uz_o_4_x - Scalar(1.531037141165631) * ddp_3_x +
      s_4 * f_4_y - c_4 * f_4_x;
  const Scalar t103 = Scalar(0.028227094878) * Uz_o_4_y - Scalar(1.531037141165631) * ddp_3_y -
      t101;
  const Scalar t104 = s_3 * t103 - c_3 * t102;
  const Scalar f_u_4_t_y = s_4 * f_4_x + c_4 * f_4_y;
  const Scalar t105 = Scalar(0.000121912420950744) * t7 - Scalar(0.000013360662912304) * t30 +
      Scalar(0.005487648106562256) * t36 + Scalar(0.004377257121839584) * Uz_o_4_x +
      Scalar(0.0825) * f_u_4_t_y + tau_4;
  const Scalar U_3_yy_zz = Uz_o_3_y - Uz_o_4_y;
  const Scalar t106 = Scalar(0.005487648106562256) * U_3_yx - Scalar(0.000121912420950744) * t30 +
      Scalar(0.004377257121839584) * U_3_yy_zz - Scalar(0.028227094878) * ddp_3_a_z -
      Scalar(0.022178148964878235) * t7 + s_4 * t100 - c_4 * mu_4_x;
  const Scalar U_2_yx = t3 + qdd_2;
  const Scalar t107 = qd_1 * qd_1;
  tau[1] = Scalar(0.01993386669246) * c_2 - Scalar(0.0007689361029464) * t9 -
      Scalar(0.00796671776787104) * t31 + Scalar(0.00398335888393552) * t107 -
      Scalar(0.01026110182100817) * t4 - Scalar(0.024699952517911183) * Uz_o_3_x +
      Scalar(0.023077882494931805) * U_2_yx - s_3 * t106 + Scalar(0.316) * t104 - c_3 * t105;
  const Scalar t108 = s_3 * t102 + c_3 * t103;
  const Scalar t109 = t8 + t10;
  const Scalar mu_2_x = Scalar(-0.0007689361029464) * (Uz_o_3_y - t107) -
      Scalar(0.00398335888393552) * t109 + Scalar(0.01026110182100817) * U_2_yx +
      Scalar(0.024699952517911183) * Uz_o_3_z - c_3 * t106 + Scalar(0.316) * t108 + s_3 * t105;
  const Scalar mu_2_y = Scalar(0.0007689361029464) * Uz_o_3_x +
      Scalar(0.00398335888393552) * Uz_o_3_z + Scalar(0.01026110182100817) * (t32 - t31) +
      Scalar(0.023077882494931805) * t109 + mu_u_3_a_y;
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
// Reads q[1..6]. Operations: 157 mul, 147 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inertia_matrix(const Scalar* q, Scalar* B, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
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
  const Scalar hu_7_t_x = Scalar(0.0008132592973428722) * c_7 - Scalar(0.0006428830269371278) * s_7;
  const Scalar t2 = Scalar(0.5569620253164557) * hu_7_t_x;
  const Scalar t3 = t1 - t2 - Scalar(0.055009225789188536);
  B[40] = -t3;
  const Scalar t4 = Scalar(0.27848101265822783) * hu_7_t_x + Scalar(0.006684151967360946);
  const Scalar Iu_7_a_xz = Scalar(0.0009653051699191118) * c_7 -
      Scalar(0.0012555365982728983) * s_7;
  const Scalar t5 = s_6 * Iu_7_a_xz + c_6 * t4;
  B[34] = B[46] = -t5;
  const Scalar hu_7_t_y = Scalar(0.0006428830269371278) * c_7 + Scalar(0.0008132592973428722) * s_7;
  const Scalar t6 = Scalar(0.27848101265822783) * hu_7_t_y - Scalar(0.000287632364465563) -
      s_7 * Iu_7_t_g;
  const Scalar Ic_6_yz = Scalar(0.000093569097314605) + Iu_7_a_xy;
  const Scalar t7 = s_6 * t6 - c_6 * Ic_6_yz;
  B[33] = B[39] = -t7;
  const Scalar t8 = s_6 * t4 - c_6 * Iu_7_a_xz;
  const Scalar t9 = c_6 * hu_7_t_y;
  const Scalar t10 = s_5 * hu_7_t_x - c_5 * t9;
  const Scalar t11 = s_6 * hu_7_t_y;
  const Scalar t12 = Scalar(1.2151898734177216) * t10 - Scalar(0.2610759493670886) * t11 +
      c_5 * Iu_7_a_xy + s_5 * t8;
  B[27] = B[45] = -t12;
  const Scalar Iu_7_t_xx = t1 - Scalar(0.00242094377852123);
  const Scalar Ic_6_yy = t2 - Scalar(0.00528056308065248);
  const Scalar Iu_6_t_d = Iu_7_t_xx - Ic_6_yy;
  const Scalar Ic_6_xy = Iu_7_a_xz + Scalar(0.014748570382675316);
  const Scalar t13 = Scalar(2.0) * s_6 * Ic_6_xy - c_6 * Iu_6_t_d;
  const Scalar t14 = c_6 * t13;
  const Scalar Ic_5_zz = t1 + t14 + Scalar(0.04256237053342771);
  B[32] = Ic_5_zz;
  const Scalar Iu_6_a_xz = s_6 * Ic_6_yz + c_6 * t6;
  const Scalar hc_6_x = hu_7_t_x + Scalar(0.07326382665162);
  const Scalar f_u_6_6_t_x = Scalar(0.054922286959804) * c_6 - s_6 * hc_6_x;
  const Scalar t15 = t3 + Scalar(1.2151898734177216) * f_u_6_6_t_x;
  const Scalar hu_6_t_x = Scalar(0.054922286959804) * s_6 + c_6 * hc_6_x;
  const Scalar mu_u_6_4_a_y = Scalar(0.2610759493670886) * hu_6_t_x - s_5 * Iu_6_a_xz + c_5 * t15;
  B[26] = B[38] = -mu_u_6_4_a_y;
  const Scalar t16 = c_5 * Iu_6_a_xz + s_5 * t15;
  const Scalar t17 = Scalar(0.2610759493670886) * f_u_6_6_t_x;
  const Scalar t18 = s_5 * t17;
  const Scalar t19 = t7 + t18;
  const Scalar mu_6_3_z = t18 - c_4 * t19 - s_4 * t16;
  B[19] = B[37] = mu_6_3_z;
  const Scalar f_u_7_5_a_z = s_5 * t9 + c_5 * hu_7_t_x;
  const Scalar mu_7_4_x = Scalar(1.2151898734177216) * f_u_7_5_a_z - s_5 * Iu_7_a_xy + c_5 * t8;
  const Scalar t20 = Scalar(0.2610759493670886) * f_u_7_5_a_z;
  const Scalar t21 = t5 - t20;
  const Scalar mu_u_7_3_a_y = t20 - s_4 * mu_7_4_x + c_4 * t21;
  B[20] = B[44] = -mu_u_7_3_a_y;
  const Scalar Ic_5_xz = Iu_7_a_xz - s_6 * t13 + Scalar(0.01014832486511221);
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.004630579482008);
  const Scalar f_5_5_x = hu_7_t_y - Scalar(0.0214471195303);
  const Scalar t22 = s_5 * hc_5_x - c_5 * f_5_5_x;
  const Scalar t23 = t7 + Scalar(0.00216405205209813);
  const Scalar B_45 = -c_5 * t23 - s_5 * Ic_5_xz + Scalar(1.2151898734177216) * t22;
  B[25] = B[31] = B_45;
  const Scalar t24 = f_u_7_5_a_z + s_4 * t21 + c_4 * mu_7_4_x;
  const Scalar t25 = s_4 * t10 - c_4 * t11;
  const Scalar t26 = s_4 * t11 - Scalar(0.2610759493670886) * t25 + c_4 * t10 + t12;
  B[13] = B[43] = c_3 * t26 + s_3 * t24;
  const Scalar t27 = s_4 * t19 - c_4 * t16 - s_5 * f_u_6_6_t_x;
  const Scalar t28 = c_5 * f_u_6_6_t_x;
  const Scalar f_u_6_4_t_y = s_4 * t28 + c_4 * hu_6_t_x;
  const Scalar t29 = c_4 * t28 - Scalar(0.2610759493670886) * f_u_6_4_t_y - s_4 * hu_6_t_x +
      mu_u_6_4_a_y;
  B[12] = B[36] = s_3 * t27 + c_3 * t29;
  const Scalar hu_5_t_x = s_5 * f_5_5_x + c_5 * hc_5_x;
  const Scalar t30 = s_5 * t23 - c_5 * Ic_5_xz + Scalar(1.2151898734177216) * hu_5_t_x;
  const Scalar t31 = Scalar(0.2610759493670886) * hu_5_t_x;
  const Scalar mu_5_4_y = Ic_5_zz - t31;
  const Scalar mu_5_3_z = t31 - s_4 * t30 + c_4 * mu_5_4_y;
  B[18] = B[30] = mu_5_3_z;
  B[6] = B[42] = s_2 * (s_3 * t26 - c_3 * t24) - c_2 * mu_u_7_3_a_y;
  const Scalar Iu_6_t_xx = Ic_6_yy - t14;
  const Scalar t32 = t3 + Scalar(0.04208100218189551);
  const Scalar Iu_5_t_d = Iu_6_t_xx + t32;
  const Scalar Ic_5_xy = Iu_6_a_xz - Scalar(0.00151524447332703);
  const Scalar t33 = Scalar(2.0) * s_5 * Ic_5_xy - c_5 * Iu_5_t_d;
  const Scalar t34 = c_5 * t33;
  const Scalar t35 = Scalar(0.5221518987341772) * hu_5_t_x;
  const Scalar t36 = Scalar(2.430379746835443) * f_u_6_6_t_x;
  const Scalar B_44 = Iu_6_t_xx - t35 + t34 - t36 + Scalar(0.7918443694347095);
  B[24] = B_44;
  B[5] = B[35] = c_2 * mu_6_3_z - s_2 * (c_3 * t27 - s_3 * t29);
  const Scalar t37 = hu_5_t_x + s_4 * mu_5_4_y + c_4 * t30;
  const Scalar t38 = B_45 + t22 * (c_4 - Scalar(0.2610759493670886) * s_4);
  B[11] = B[29] = -c_3 * t38 - s_3 * t37;
  const Scalar t39 = Scalar(-0.2610759493670886) * t22;
  const Scalar t40 = Iu_6_a_xz - Scalar(0.00542059949960313) - t39 - s_5 * t33;
  const Scalar t41 = B_45 - Scalar(0.00164448757736927);
  const Scalar Iu_4_a_xy = s_4 * t40 - c_4 * t41;
  B[17] = B[23] = -Iu_4_a_xy;
  B[4] = B[28] = c_2 * mu_5_3_z - s_2 * (s_3 * t38 - c_3 * t37);
  const Scalar t42 = c_4 * t40 + s_4 * t41;
  const Scalar hc_4_x = hu_5_t_x - Scalar(0.1746785667894);
  const Scalar f_4_4_x = f_u_6_6_t_x - Scalar(0.635957442938548);
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * f_4_4_x;
  const Scalar t43 = s_4 * hc_4_x - c_4 * f_4_4_x;
  const Scalar t44 = Scalar(0.2610759493670886) * hu_4_t_x + t43 + B_44;
  B[10] = B[22] = -s_3 * t42 - c_3 * t44;
  const Scalar t45 = t34 + t32 + t36;
  const Scalar Ic_4_yy = Ic_5_zz - t35 - Scalar(0.6898040971210785);
  const Scalar t46 = t17 + t30 - Scalar(0.16284087268546085);
  const Scalar t47 = Scalar(2.0) * s_4 * t46 - c_4 * (t45 + Ic_4_yy);
  const Scalar t48 = c_4 * t47;
  const Scalar t49 = Scalar(0.5221518987341772) * hu_4_t_x;
  const Scalar t50 = t45 - t49 + t48 - Scalar(0.8246048032693);
  B[16] = -t50;
  B[3] = B[21] = s_2 * (c_3 * t42 - s_3 * t44) - c_2 * Iu_4_a_xy;
  const Scalar t51 = Scalar(0.2610759493670886) * t43 + t46 + Scalar(0.24149476342611426) +
      hu_4_t_x - s_4 * t47;
  const Scalar t52 = Scalar(0.013297019103287584) + t22 - Iu_4_a_xy;
  const Scalar t53 = c_3 * t52 + s_3 * t51;
  B[9] = B[15] = -t53;
  const Scalar Iu_4_t_xx = t48 + Ic_4_yy;
  const Scalar t54 = t49 + B_44 - Scalar(0.7013999612162445);
  const Scalar Iu_3_t_d = Iu_4_t_xx - t54;
  const Scalar t55 = t39 - Scalar(0.000121912420950744) + t42;
  const Scalar t56 = Scalar(2.0) * s_3 * t55 - c_3 * Iu_3_t_d;
  const Scalar t57 = c_3 * t56;
  const Scalar t58 = Scalar(-2.0) * t43;
  B[8] = Iu_4_t_xx + t57 - t58 + Scalar(1.8182423259695848);
  const Scalar t59 = s_3 * t52 - c_3 * t51;
  B[2] = B[14] = -s_2 * t59 - c_2 * t50;
  B[1] = B[7] = -s_2 * (Scalar(0.01026110182100817) + t55 - s_3 * t56) -
      c_2 * (Scalar(0.0007689361029464) + t53);
  const Scalar t60 = -t57 - t58 + t54;
  const Scalar t61 = Scalar(2.0) * s_2 * (Scalar(0.00398335888393552) + t59) +
      c_2 * (t50 + t60 + Scalar(1.7720865609797212));
  B[0] = t60 - c_2 * t61 + Scalar(1.8094240094691274);
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
// Reads q[1..6]. Operations: 698 mul, 594 add, 12 sin/cos. Always zero: 28 of the 196 entries of c.
template <class Scalar, class SinCos = LibrarySinCos>
inline void christoffel(const Scalar* q, Scalar* c, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5],
      s_7 = sine[6], c_7 = cosine[6];
  const Scalar Iu_7_a_xz = Scalar(0.0004826525849595559) * c_7 -
      Scalar(0.0006277682991364491) * s_7;
  c[167] = Scalar(-2.0) * Iu_7_a_xz;
  const Scalar mr_7_y = Scalar(0.0003214415134685639) * c_7 + Scalar(0.0004066296486714361) * s_7;
  const Scalar t1 = c_6 * mr_7_y;
  const Scalar t2 = Scalar(0.27848101265822783) * t1;
  const Scalar Iu_7_a_xy = Scalar(0.0006277682991364491) * c_7 +
      Scalar(0.0004826525849595559) * s_7;
  const Scalar t3 = s_6 * Iu_7_a_xy;
  const Scalar db_57_7 = t2 + t3;
  c[139] = Scalar(2.0) * db_57_7;
  const Scalar I_t7_g = Scalar(0.001210471889260615) * c_7 - Scalar(0.000391391281684248) * s_7;
  const Scalar Ic_7_xy = Scalar(0.000195695640842124) + s_7 * I_t7_g;
  const Scalar t4 = Scalar(2.0) * Ic_7_xy;
  const Scalar t5 = Scalar(0.27848101265822783) * mr_7_y;
  const Scalar t6 = t5 - t4;
  const Scalar c_7_6_6 = t5 + t6;
  c[188] = c_7_6_6;
  c[166] = -c_7_6_6;
  const Scalar t7 = Scalar(1.2151898734177216) * c_5;
  const Scalar t8 = Scalar(0.2610759493670886) * s_6 + c_6 * t7;
  const Scalar mr_7_x = Scalar(0.0004066296486714361) * c_7 - Scalar(0.0003214415134685639) * s_7;
  const Scalar t9 = mr_7_x * t8 + s_5 * t5 * (s_6 + Scalar(4.363636363636363));
  const Scalar t10 = s_5 * c_6;
  const Scalar t11 = t9 - Iu_7_a_xy * t10 - c_5 * Iu_7_a_xz;
  c[111] = Scalar(2.0) * t11;
  const Scalar t12 = Scalar(-0.0000518794586093425) - t5 + Ic_7_xy;
  const Scalar Ic_6_yz = Scalar(0.0000467845486573025) + Iu_7_a_xy;
  const Scalar Iu_6_a_xz = s_6 * Ic_6_yz - c_6 * t12;
  c[132] = Scalar(-2.0) * Iu_6_a_xz;
  const Scalar t13 = c_7 * I_t7_g;
  const Scalar Ic_7_xx = t13 - Scalar(0.001210471889260615);
  const Scalar t14 = Scalar(0.5569620253164557) * mr_7_x;
  const Scalar Ic_6_yy = t14 - Scalar(0.00264028154032624);
  const Scalar Iu_6_t_d = Ic_7_xx - Ic_6_yy;
  const Scalar Ic_6_xy = Iu_7_a_xz + Scalar(0.007374285191337658);
  const Scalar t15 = Scalar(2.0) * Ic_6_xy;
  const Scalar t16 = s_6 * t15 - c_6 * Iu_6_t_d;
  const Scalar t17 = s_6 * t16;
  const Scalar dmu_5_6_y = s_6 * Iu_6_t_d + c_6 * t15;
  const Scalar c_6_5_5 = t17 - c_6 * dmu_5_6_y;
  c[154] = c_6_5_5;
  const Scalar t18 = c_6 * Iu_7_a_xy + s_6 * t4;
  const Scalar c_7_5_5 = c_6 * (t2 + db_57_7) + s_6 * t18;
  c[182] = c_7_5_5;
  const Scalar hc_6_x = mr_7_x + Scalar(0.03663191332581);
  const Scalar hu_6_t_x = Scalar(0.027461143479902) * s_6 + c_6 * hc_6_x;
  const Scalar t19 = s_5 * hu_6_t_x;
  const Scalar t20 = c_4 - Scalar(1.0);
  const Scalar v_o_3_5_z = Scalar(0.2610759493670886) * t20 + Scalar(1.2151898734177216) * s_4;
  const Scalar t21 = v_o_3_5_z * t19;
  const Scalar t22 = s_4 * c_5;
  const Scalar t23 = s_6 * t22 - c_4 * c_6;
  const Scalar w_3_6_x = c_6 * t22 + c_4 * s_6;
  const Scalar t24 = Ic_6_yz * w_3_6_x + t12 * t23 - t21;
  c[76] = Scalar(-2.0) * t24;
  const Scalar t25 = c_5 * v_o_3_5_z;
  const Scalar t26 = mr_7_x * t10;
  const Scalar t27 = mr_7_y * (Scalar(0.27848101265822783) * t23 + t25) - v_o_3_5_z * t26;
  const Scalar t28 = s_4 * s_5;
  const Scalar t29 = t27 - Iu_7_a_xy * w_3_6_x + Iu_7_a_xz * t28;
  c[83] = Scalar(-2.0) * t29;
  const Scalar t30 = Scalar(0.27848101265822783) * mr_7_x;
  const Scalar t31 = t30 + Scalar(0.003342075983680473);
  const Scalar t32 = s_6 * Iu_7_a_xz + c_6 * t31;
  const Scalar t33 = Scalar(0.2610759493670886) * c_6 - s_6 * t7;
  const Scalar t34 = mr_7_y * t33 - s_5 * t32;
  const Scalar v_o_4_7_y = Scalar(0.27848101265822783) * c_5 - t33;
  const Scalar t35 = s_5 * s_6;
  const Scalar t36 = Iu_7_a_xz * t35 - mr_7_y * v_o_4_7_y;
  const Scalar dI_7_xy = t13 + Ic_7_xx;
  const Scalar t37 = t30 - dI_7_xy;
  const Scalar t38 = t36 + t10 * t37 - c_5 * t6;
  c[110] = t34 + t38;
  const Scalar c_7_4_6 = t34 - t38;
  c[186] = c_7_4_6;
  const Scalar t39 = c_6 * Iu_7_a_xz;
  const Scalar db_56_7r = t39 - s_6 * t37;
  const Scalar t40 = s_6 * t31 - t39;
  c[138] = db_56_7r + t40;
  const Scalar c_7_5_6 = t40 - db_56_7r;
  c[187] = c_7_5_6;
  c[131] = -c_6_5_5;
  c[137] = -c_7_5_5;
  const Scalar t41 = s_6 * t12 + c_6 * Ic_6_yz;
  const Scalar t42 = Scalar(0.027461143479902) * t33 - hc_6_x * t8;
  const Scalar t43 = t42 - s_5 * t41;
  c[104] = Scalar(-2.0) * t43;
  const Scalar t44 = s_3 * c_4;
  const Scalar t45 = s_5 * t44 - c_3 * c_5;
  const Scalar t46 = Iu_6_a_xz * t45;
  const Scalar t47 = c_4 - Scalar(0.2610759493670886) * s_4;
  const Scalar t48 = t47 + Scalar(1.2151898734177216);
  const Scalar t49 = s_5 * t48;
  const Scalar v_o_2_5_z = s_3 + Scalar(1.2151898734177216) * s_3 *
      (c_4 - Scalar(0.21484375) * s_4);
  const Scalar v_2_6_a_z = c_3 * t49 + c_5 * v_o_2_5_z;
  const Scalar f_u_6_6_t_x = Scalar(0.027461143479902) * c_6 - s_6 * hc_6_x;
  const Scalar t50 = f_u_6_6_t_x * v_2_6_a_z;
  const Scalar t51 = t13 - t14 - Scalar(0.027504612894594268);
  const Scalar w_2_5_x = c_5 * t44 + c_3 * s_5;
  const Scalar db_26_5 = t46 - t50 - t51 * w_2_5_x;
  const Scalar t52 = s_3 * s_4;
  const Scalar w_2_7_a_z = s_6 * w_2_5_x + c_6 * t52;
  const Scalar t53 = s_6 * t52 - c_6 * w_2_5_x;
  const Scalar t54 = t46 + w_2_7_a_z * dmu_5_6_y - t16 * t53 + t50;
  c[47] = db_26_5 - t54;
  const Scalar c_6_2_5 = db_26_5 + t54;
  c[151] = c_6_2_5;
  const Scalar t55 = Scalar(0.27848101265822783) * s_4 + s_6 * v_o_3_5_z;
  const Scalar t56 = s_5 * t55;
  const Scalar t57 = Iu_7_a_xz * t23;
  const Scalar t58 = mr_7_y * t56 + t57;
  const Scalar t59 = t58 + w_3_6_x * t37 + t28 * t6;
  const Scalar t60 = t57 - mr_7_y * v_o_3_5_z * t35 + w_3_6_x * t31;
  c[82] = t60 - t59;
  const Scalar c_7_3_6 = t59 + t60;
  c[185] = c_7_3_6;
  c[164] = -c_7_4_6;
  c[165] = -c_7_5_6;
  const Scalar t61 = -t12 * t28 - Iu_6_t_d * w_3_6_x + t15 * t23 + Scalar(0.027461143479902) * t25;
  const Scalar t62 = Ic_6_yz * t28 + Iu_6_t_d * t23 + t15 * w_3_6_x - hc_6_x * t25;
  const Scalar t63 = Scalar(0.027461143479902) * t23 + hc_6_x * w_3_6_x;
  const Scalar db_33_6r = t23 * t61 - w_3_6_x * t62 + t28 * (t21 - t24) + t25 * t63;
  c[73] = db_33_6r;
  const Scalar t64 = t58 - w_3_6_x * dI_7_xy - t28 * t4;
  const Scalar t65 = mr_7_x * t56 - Iu_7_a_xy * t23 + w_3_6_x * t4 - t28 * dI_7_xy;
  const Scalar df_3_7_z = mr_7_y * t28 + mr_7_x * w_3_6_x;
  const Scalar c_7_3_3 = df_3_7_z * t56 + t23 * (t27 + t29) + w_3_6_x * t65 + t28 * t64;
  c[173] = c_7_3_3;
  const Scalar t66 = s_2 * c_3;
  const Scalar t67 = c_4 * t66 - c_2 * s_4;
  const Scalar t68 = s_2 * s_3;
  const Scalar w_1_5_x = s_5 * t68 - c_5 * t67;
  const Scalar w_1_4_y = s_4 * t66 + c_2 * c_4;
  const Scalar t69 = s_6 * w_1_5_x - c_6 * w_1_4_y;
  const Scalar w_1_6_x = s_6 * w_1_4_y + c_6 * w_1_5_x;
  const Scalar w_1_5_y = s_5 * t67 + c_5 * t68;
  const Scalar t70 = Iu_6_a_xz * w_1_5_y;
  const Scalar v_o_1_4_y = Scalar(0.2610759493670886) * c_2 + t66;
  const Scalar v_1_5_a_y = v_o_1_4_y - Scalar(0.2610759493670886) * w_1_4_y +
      Scalar(1.2151898734177216) * t67;
  const Scalar t71 = t68 * t49 - c_5 * v_1_5_a_y;
  const Scalar t72 = f_u_6_6_t_x * t71;
  const Scalar db_15_6r = t70 - t69 * dmu_5_6_y - t16 * w_1_6_x - t72;
  const Scalar t73 = t70 + t51 * w_1_5_x + t72;
  const Scalar c_5_1_6 = t73 + db_15_6r;
  c[127] = c_5_1_6;
  c[128] = -c_6_2_5;
  const Scalar t74 = c_5 * Iu_7_a_xy + s_5 * t40;
  const Scalar t75 = s_5 * mr_7_x - c_5 * t1;
  const Scalar t76 = v_o_3_5_z * t75 + s_4 * t74;
  const Scalar dmu_5_7_y = t39 + s_6 * dI_7_xy;
  const Scalar t77 = mr_7_x * t55 * t35 - t23 * db_57_7 - c_6 * t27 + w_3_6_x * t18 -
      t28 * dmu_5_7_y;
  const Scalar c_5_3_7 = t76 - t77;
  c[135] = c_5_3_7;
  c[163] = -c_7_3_6;
  c[79] = -c_7_3_3;
  const Scalar Ic_5_xz = Ic_6_xy - Scalar(0.002300122758781553) - t17;
  const Scalar f_5_5_x = mr_7_y - Scalar(0.01072355976515);
  const Scalar t78 = c_5 * t48;
  const Scalar v_1_5_x = t68 * t78 + s_5 * v_1_5_a_y;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.002315289741004);
  const Scalar t79 = f_5_5_x * t71 + hc_5_x * v_1_5_x;
  const Scalar t80 = t41 - Scalar(0.001082026026049065);
  const Scalar t81 = -t80 * w_1_5_x - Ic_5_xz * w_1_5_y + t79;
  c[14] = Scalar(-2.0) * t81;
  const Scalar t82 = s_5 * v_o_2_5_z - c_3 * t78;
  const Scalar t83 = f_5_5_x * v_2_6_a_z - hc_5_x * t82;
  const Scalar t84 = Ic_5_xz * t45 - t80 * w_2_5_x + t83;
  c[42] = Scalar(-2.0) * t84;
  const Scalar t85 = Scalar(0.2610759493670886) * c_4 + s_4;
  const Scalar t86 = t85 - Scalar(0.2610759493670886);
  const Scalar t87 = c_3 * t86;
  const Scalar t88 = s_6 * t87 + c_6 * t82;
  const Scalar t89 = s_6 * t82 - c_6 * t87;
  const Scalar t90 = Scalar(0.027461143479902) * t89 + hc_6_x * t88;
  const Scalar t91 = Ic_6_yz * t53 - t12 * w_2_7_a_z + t90;
  c[48] = Scalar(2.0) * t91;
  const Scalar v_o_2_7_z = Scalar(0.27848101265822783) * w_2_7_a_z + v_2_6_a_z;
  const Scalar t92 = mr_7_y * v_o_2_7_z - mr_7_x * t88;
  const Scalar t93 = t92 + Iu_7_a_xy * t53 + Iu_7_a_xz * t45;
  c[55] = Scalar(-2.0) * t93;
  const Scalar hu_5_t_x = s_5 * f_5_5_x + c_5 * hc_5_x;
  const Scalar t94 = -s_5 * t80 - c_5 * Ic_5_xz + Scalar(1.2151898734177216) * hu_5_t_x;
  c[98] = Scalar(2.0) * t94;
  c[19] = db_15_6r - t73;
  c[150] = -c_5_1_6;
  c[145] = -db_33_6r;
  const Scalar t95 = s_5 * Iu_6_a_xz - c_5 * t51;
  const Scalar t96 = f_u_6_6_t_x * t25;
  const Scalar t97 = t96 - s_4 * t95;
  const Scalar t98 = Iu_6_a_xz * t28 + t23 * dmu_5_6_y + t16 * w_3_6_x + t96;
  const Scalar c_5_3_6 = t97 - t98;
  c[129] = c_5_3_6;
  c[81] = -t77 - t76;
  c[180] = -c_5_3_7;
  const Scalar t99 = c_6 * t16;
  const Scalar t100 = Scalar(1.2151898734177216) * f_u_6_6_t_x;
  const Scalar t101 = c_5 * Iu_6_a_xz;
  const Scalar t102 = t101 - s_5 * (t99 + s_6 * dmu_5_6_y + t100);
  const Scalar t103 = t101 + s_5 * (t51 + t100);
  c[103] = t103 - t102;
  const Scalar c_6_4_5 = t102 + t103;
  c[153] = c_6_4_5;
  const Scalar t104 = mr_7_x * v_o_4_7_y;
  const Scalar t105 = s_6 * (t104 + s_5 * db_57_7);
  const Scalar t106 = c_5 * dmu_5_7_y - t105 - c_6 * (t9 - s_5 * t18);
  const Scalar f_u_7_5_a_z = mr_7_y * t10 + c_5 * mr_7_x;
  const Scalar t107 = Scalar(1.2151898734177216) * f_u_7_5_a_z - s_5 * Iu_7_a_xy + c_5 * t40;
  const Scalar c_5_4_7 = t107 + t106;
  c[136] = c_5_4_7;
  const Scalar t108 = t104 + s_5 * (t3 - c_6 * t4) - c_5 * dI_7_xy;
  const Scalar t109 = s_5 * (c_6 * t108 - s_6 * (t9 + t11));
  const Scalar t110 = t36 - t10 * dI_7_xy + c_5 * t4;
  const Scalar t111 = t26 - c_5 * mr_7_y;
  const Scalar db_44_7r = v_o_4_7_y * t111 + c_5 * t110 + t109;
  c[108] = db_44_7r;
  const Scalar t112 = t86 * t68;
  const Scalar t113 = s_6 * t112 - c_6 * v_1_5_x;
  const Scalar t114 = c_6 * t112 + s_6 * v_1_5_x;
  const Scalar t115 = Scalar(0.027461143479902) * t114 - hc_6_x * t113;
  const Scalar t116 = Ic_6_yz * w_1_6_x + t12 * t69 + t115;
  c[20] = Scalar(-2.0) * t116;
  const Scalar t117 = mr_7_y * (Scalar(0.27848101265822783) * t69 + t71) - mr_7_x * t113;
  const Scalar t118 = t117 - Iu_7_a_xy * w_1_6_x - Iu_7_a_xz * w_1_5_y;
  c[27] = Scalar(-2.0) * t118;
  const Scalar t119 = Scalar(0.2610759493670886) * f_u_7_5_a_z;
  const Scalar t120 = t32 - t119;
  const Scalar t121 = s_4 * t107 - c_4 * t120;
  const Scalar t122 = s_6 * mr_7_y;
  const Scalar t123 = t85 * t75 - t47 * t122;
  const Scalar t124 = c_3 * t123 + s_3 * t121;
  const Scalar t125 = Scalar(0.27848101265822783) * t45 + t89;
  const Scalar t126 = t125 * t111 + t92 * t35 + w_2_7_a_z * t11 + t53 * t108 + t45 * t110;
  const Scalar c_4_2_7 = t124 + t126;
  c[106] = c_4_2_7;
  const Scalar t127 = mr_7_x * t125;
  const Scalar t128 = s_6 * t127 - w_2_7_a_z * db_57_7 - c_6 * t92 - t53 * t18 - t45 * dmu_5_7_y;
  const Scalar db_27_5 = v_2_6_a_z * t1 - Iu_7_a_xy * w_2_5_x - mr_7_x * t82 - t45 * t40;
  c[53] = db_27_5 - t128;
  const Scalar c_7_2_5 = t128 + db_27_5;
  c[179] = c_7_2_5;
  const Scalar t129 = Iu_7_a_xz * w_2_7_a_z;
  const Scalar t130 = t129 + mr_7_y * t125;
  const Scalar t131 = t130 - t53 * t37 + t45 * t6;
  const Scalar t132 = mr_7_y * t89 - t129 + t53 * t31;
  const Scalar c_6_2_7 = t132 - t131;
  c[162] = c_6_2_7;
  const Scalar t133 = c_5 * t12 + s_5 * (t16 + Scalar(0.033370503469248));
  const Scalar t134 = c_5 * Ic_6_yz + s_5 * (Scalar(1.2151898734177216) * hc_6_x - dmu_5_6_y);
  const Scalar t135 = t23 * t133 + t43 * t28 + w_3_6_x * t134;
  const Scalar t136 = Scalar(0.2610759493670886) * f_u_6_6_t_x;
  const Scalar t137 = s_5 * t136;
  const Scalar t138 = t41 - t137;
  const Scalar t139 = s_4 * t138 + c_4 * t103;
  const Scalar c_4_3_6 = t139 - t135;
  c[101] = c_4_3_6;
  const Scalar t140 = s_5 * (s_6 * t27 + s_4 * t110);
  const Scalar t141 = t56 * t111 + t23 * t11 - w_3_6_x * t108 + t140;
  const Scalar t142 = s_4 * t120 + c_4 * t107;
  c[80] = t141 + t142;
  const Scalar c_7_3_4 = t142 - t141;
  c[176] = c_7_3_4;
  c[75] = -t97 - t98;
  c[152] = -c_5_3_6;
  c[130] = -c_6_4_5;
  c[109] = t106 - t107;
  c[181] = -c_5_4_7;
  const Scalar Iu_6_t_xx = Ic_6_yy - t99;
  const Scalar t143 = t51 + Scalar(0.021040501090947756);
  const Scalar Iu_5_t_d = Iu_6_t_xx + t143;
  const Scalar Ic_5_xy = Iu_6_a_xz - Scalar(0.000757622236663515);
  const Scalar t144 = Scalar(2.0) * Ic_5_xy;
  const Scalar t145 = t144 * w_1_5_y + Ic_5_xz * w_1_4_y + f_5_5_x * t112 + Iu_5_t_d * w_1_5_x;
  const Scalar t146 = t144 * w_1_5_x - t80 * w_1_4_y + hc_5_x * t112 - Iu_5_t_d * w_1_5_y;
  const Scalar t147 = t112 * (f_5_5_x * w_1_5_y - hc_5_x * w_1_5_x);
  const Scalar c_1_1_5 = t147 + w_1_5_y * t145 - w_1_5_x * t146 - w_1_4_y * (t79 + t81);
  c[10] = c_1_1_5;
  const Scalar t148 = t144 * t45 + Ic_5_xz * t52 - f_5_5_x * t87 - Iu_5_t_d * w_2_5_x;
  const Scalar t149 = t80 * t52 + t144 * w_2_5_x + Iu_5_t_d * t45 + hc_5_x * t87;
  const Scalar df_2_5_z = f_5_5_x * t45 + hc_5_x * w_2_5_x;
  const Scalar db_22_5r = t45 * t148 - t87 * df_2_5_z - w_2_5_x * t149 + t52 * (t83 + t84);
  c[39] = db_22_5r;
  const Scalar t150 = Iu_6_t_d * t53 - t12 * t45 + t15 * w_2_7_a_z +
      Scalar(0.027461143479902) * v_2_6_a_z;
  const Scalar dmu_2_6_x = -Ic_6_yz * t45 - Iu_6_t_d * w_2_7_a_z + t15 * t53 + hc_6_x * v_2_6_a_z;
  const Scalar df_2_6_z = Scalar(0.027461143479902) * w_2_7_a_z - hc_6_x * t53;
  const Scalar c_2_2_6 = w_2_7_a_z * t150 - t53 * dmu_2_6_x + v_2_6_a_z * df_2_6_z +
      t45 * (t90 + t91);
  c[44] = c_2_2_6;
  const Scalar t151 = s_5 * (Scalar(1.2151898734177216) * t19 + s_6 * t133 + c_6 * t134);
  const Scalar c_6_4_4 = c_5 * (t42 + t43) - t151;
  c[149] = c_6_4_4;
  const Scalar t152 = t130 + t53 * dI_7_xy - t45 * t4;
  const Scalar dmu_2_7_x = Iu_7_a_xy * w_2_7_a_z - t127 + t53 * t4 + t45 * dI_7_xy;
  const Scalar df_2_7_z = mr_7_y * t45 - mr_7_x * t53;
  const Scalar c_7_2_2 = t125 * df_2_7_z + w_2_7_a_z * (t92 + t93) + t53 * dmu_2_7_x + t45 * t152;
  c[170] = c_7_2_2;
  c[177] = -db_44_7r;
  const Scalar t153 = s_5 * Ic_5_xz - c_5 * t80;
  const Scalar t154 = s_5 * hc_5_x - c_5 * f_5_5_x;
  const Scalar t155 = t154 * v_o_3_5_z;
  const Scalar t156 = t155 - s_4 * t153;
  c[70] = Scalar(2.0) * t156;
  const Scalar t157 = t69 * t133 - w_1_5_y * t43 + w_1_6_x * t134 + t71 * t19 + c_5 * t115;
  const Scalar t158 = c_5 * f_u_6_6_t_x;
  const Scalar t159 = t85 * t158 + hu_6_t_x * t47;
  const Scalar t160 = t68 * t159 - t67 * t138 + w_1_4_y * t103;
  const Scalar c_4_1_6 = t160 - t157;
  c[99] = c_4_1_6;
  const Scalar v_1_7_a_z = Scalar(0.27848101265822783) * w_1_5_y + t114;
  const Scalar t161 = v_1_7_a_z * t111 - t117 * t35 - t69 * t11 + w_1_6_x * t108 + w_1_5_y * t110;
  const Scalar t162 = w_1_4_y * t107 - t68 * t123 - t67 * t120;
  c[24] = t162 - t161;
  const Scalar c_7_1_4 = t162 + t161;
  c[174] = c_7_1_4;
  const Scalar t163 = mr_7_x * v_1_7_a_z;
  const Scalar t164 = s_6 * t163 + t69 * db_57_7 + c_6 * t117 - w_1_6_x * t18 - w_1_5_y * dmu_5_7_y;
  const Scalar db_17_5 = t71 * t1 - Iu_7_a_xy * w_1_5_x + mr_7_x * v_1_5_x + w_1_5_y * t40;
  c[25] = t164 + db_17_5;
  const Scalar c_7_1_5 = db_17_5 - t164;
  c[178] = c_7_1_5;
  const Scalar t165 = Iu_7_a_xz * t69;
  const Scalar t166 = t165 - mr_7_y * v_1_7_a_z;
  const Scalar t167 = t166 + w_1_6_x * t37 - w_1_5_y * t6;
  const Scalar t168 = mr_7_y * t114 + t165 + w_1_6_x * t31;
  c[26] = t168 - t167;
  const Scalar c_7_1_6 = t168 + t167;
  c[183] = c_7_1_6;
  const Scalar t169 = f_u_7_5_a_z + t142;
  const Scalar t170 = s_4 * t75 - t20 * t122;
  const Scalar t171 = c_4 + Scalar(1.2151898734177216);
  const Scalar t172 = s_4 * t122 - Scalar(0.2610759493670886) * t170 + t171 * t75 + t74;
  const Scalar t173 = c_3 * t169 - s_3 * t172;
  const Scalar t174 = t125 * df_3_7_z + w_2_7_a_z * t29 + t23 * t92 - t53 * t65 + t45 * t64;
  c[51] = t173 - t174;
  const Scalar c_7_2_3 = t173 + t174;
  c[172] = c_7_2_3;
  const Scalar t175 = s_4 * t103 - c_4 * t138;
  const Scalar t176 = s_3 * t175 - c_3 * t159;
  const Scalar t177 = w_2_7_a_z * t133 - t53 * t134 + v_2_6_a_z * t19 + t45 * t43 - c_5 * t90;
  c[46] = t176 - t177;
  const Scalar c_6_2_4 = t176 + t177;
  c[147] = c_6_2_4;
  c[52] = t126 - t124;
  c[175] = -c_4_2_7;
  c[134] = -c_7_2_5;
  c[54] = -t132 - t131;
  c[184] = -c_6_2_7;
  c[74] = -t139 - t135;
  c[148] = -c_4_3_6;
  c[107] = -c_7_3_4;
  c[112] = -c_1_1_5;
  const Scalar t178 = s_5 * t144 - c_5 * Iu_5_t_d;
  const Scalar t179 = Scalar(0.2610759493670886) * hc_5_x - t178;
  const Scalar t180 = c_5 * t144 + s_5 * Iu_5_t_d;
  const Scalar dmu_4_5_y = Scalar(0.2610759493670886) * f_5_5_x - t180;
  const Scalar t181 = Scalar(-0.2610759493670886) * t154;
  const Scalar c_5_4_4 = t181 - s_5 * t179 + c_5 * dmu_4_5_y;
  c[121] = c_5_4_4;
  const Scalar t182 = t12 * w_1_5_y - Iu_6_t_d * w_1_6_x + t15 * t69 +
      Scalar(0.027461143479902) * t71;
  const Scalar t183 = Iu_6_t_d * t69 - Ic_6_yz * w_1_5_y + t15 * w_1_6_x - hc_6_x * t71;
  const Scalar t184 = t71 * (Scalar(0.027461143479902) * t69 + hc_6_x * w_1_6_x);
  const Scalar c_1_1_6 = t69 * t182 - w_1_6_x * t183 + t184 + w_1_5_y * (t115 + t116);
  c[15] = c_1_1_6;
  c[142] = -c_2_2_6;
  c[102] = -c_6_4_4;
  const Scalar t185 = w_1_5_y * (t166 - w_1_6_x * dI_7_xy + w_1_5_y * t4);
  const Scalar t186 = w_1_6_x * (-t163 - Iu_7_a_xy * t69 + w_1_6_x * t4 + w_1_5_y * dI_7_xy);
  const Scalar t187 = v_1_7_a_z * (mr_7_y * w_1_5_y - mr_7_x * w_1_6_x);
  const Scalar c_7_1_1 = t187 + t69 * (t117 + t118) + t186 - t185;
  c[168] = c_7_1_1;
  c[50] = -c_7_2_2;
  const Scalar t188 = s_2 * (s_3 * t169 + c_3 * t172);
  const Scalar t189 = v_1_7_a_z * df_3_7_z - t23 * t117 - t69 * t29 - w_1_6_x * t65 + w_1_5_y * t64;
  c[23] = t189 + t188;
  const Scalar c_3_1_7 = t189 - t188;
  c[77] = c_3_1_7;
  c[18] = -t160 - t157;
  c[146] = -c_4_1_6;
  c[105] = -c_7_1_4;
  c[133] = -c_7_1_5;
  c[161] = -c_7_1_6;
  c[114] = -db_22_5r;
  const Scalar t190 = t139 + s_5 * f_u_6_6_t_x;
  const Scalar t191 = f_u_6_6_t_x * t22 + hu_6_t_x * t20;
  const Scalar t192 = Scalar(0.2610759493670886) * t191 + t95 + s_4 * hu_6_t_x - t158 * t171;
  const Scalar t193 = c_3 * t190 - s_3 * t192;
  const Scalar t194 = w_2_7_a_z * t61 + t53 * t62 - t45 * t24 + v_2_6_a_z * t63 + t90 * t28;
  const Scalar c_3_2_6 = t193 + t194;
  c[72] = c_3_2_6;
  c[78] = -c_7_2_3;
  c[100] = -c_6_2_4;
  c[97] = -c_5_4_4;
  c[140] = -c_1_1_6;
  c[21] = -c_7_1_1;
  const Scalar mu_u_7_3_a_y = t119 - t121;
  const Scalar t195 = s_2 * mu_u_7_3_a_y - c_2 * t173;
  const Scalar t196 = v_1_7_a_z * df_2_7_z - w_2_7_a_z * t117 - t69 * t93 + w_1_6_x * dmu_2_7_x +
      w_1_5_y * t152;
  c[22] = t196 + t195;
  const Scalar c_7_1_2 = t195 - t196;
  c[169] = c_7_1_2;
  const Scalar t197 = s_2 * (s_3 * t190 + c_3 * t192);
  const Scalar t198 = t69 * t61 - w_1_6_x * t62 + w_1_5_y * t24 - t115 * t28 + t71 * t63;
  c[17] = t198 - t197;
  const Scalar c_3_1_6 = t197 + t198;
  c[71] = c_3_1_6;
  c[171] = -c_3_1_7;
  const Scalar t199 = t94 * w_1_4_y;
  const Scalar db_14_5r = w_1_5_y * dmu_4_5_y - w_1_5_x * t179 + t154 * t112 + t199;
  const Scalar Ic_5_zz = Ic_7_xx + t99 + Scalar(0.02249165715597447);
  const Scalar t200 = Scalar(0.2610759493670886) * hu_5_t_x;
  const Scalar mu_5_4_y = Ic_5_zz - t200;
  const Scalar t201 = t154 * t85;
  const Scalar t202 = -t67 * mu_5_4_y - t68 * t201 + t199;
  const Scalar c_4_1_5 = t202 + db_14_5r;
  c[94] = c_4_1_5;
  c[45] = t194 - t193;
  c[144] = -c_3_2_6;
  const Scalar t203 = s_4 * t94 - c_4 * mu_5_4_y;
  const Scalar t204 = c_3 * t201 + s_3 * t203;
  const Scalar t205 = t45 * dmu_4_5_y + t94 * t52 - t154 * t87 + w_2_5_x * t179;
  c[41] = t204 - t205;
  const Scalar c_5_2_4 = t204 + t205;
  c[119] = c_5_2_4;
  const Scalar t206 = Ic_5_xy - Scalar(0.00195267751313805) - t181 - s_5 * t178;
  const Scalar t207 = Scalar(1.2151898734177216) * t154 - t153;
  const Scalar t208 = t207 - Scalar(0.000822243788684635);
  const Scalar hc_4_x = hu_5_t_x - Scalar(0.0873392833947);
  const Scalar f_4_4_x = f_u_6_6_t_x - Scalar(0.317978721469274);
  const Scalar t209 = hc_4_x * t47 + f_4_4_x * t85;
  const Scalar t210 = t68 * t209;
  const Scalar t211 = t208 * t67 - t206 * w_1_4_y - t210;
  c[9] = Scalar(2.0) * t211;
  const Scalar t212 = c_4 * t206 + s_4 * t208;
  c[65] = Scalar(-2.0) * t212;
  const Scalar mu_6_3_z = t137 - t175;
  const Scalar t213 = s_2 * mu_6_3_z - c_2 * t193;
  const Scalar t214 = t69 * t150 + w_1_6_x * dmu_2_6_x + t71 * df_2_6_z - w_1_5_y * t91 -
      t45 * t115;
  const Scalar c_2_1_6 = t213 + t214;
  c[43] = c_2_1_6;
  c[49] = -c_7_1_2;
  c[143] = -c_3_1_6;
  c[13] = db_14_5r - t202;
  c[118] = -c_4_1_5;
  c[95] = -c_5_2_4;
  const Scalar t215 = c_4 * Ic_5_xz - s_4 * t178;
  const Scalar t216 = c_4 * t80 - s_4 * t180;
  const Scalar db_33_5r = c_4 * (t155 + t156) - s_4 * (s_5 * t215 - c_5 * t216);
  c[68] = db_33_5r;
  c[16] = t214 - t213;
  c[141] = -c_2_1_6;
  const Scalar t217 = c_4 * t94;
  const Scalar t218 = s_4 * mu_5_4_y + t217;
  const Scalar t219 = hu_5_t_x + t218;
  const Scalar t220 = t207 + t154 * t47;
  const Scalar t221 = s_2 * (c_3 * t220 + s_3 * t219);
  const Scalar t222 = w_1_5_y * t215 - s_4 * hu_5_t_x * t112 + w_1_5_x * t216 + w_1_4_y * t156 -
      c_4 * t79;
  c[12] = t222 - t221;
  const Scalar c_3_1_5 = t222 + t221;
  c[66] = c_3_1_5;
  const Scalar t223 = s_4 * (hu_5_t_x * t87 + s_3 * t156);
  const Scalar t224 = t45 * t215 - w_2_5_x * t216 + t223 + c_4 * t83;
  const Scalar t225 = s_3 * t220 - c_3 * t219;
  c[40] = t225 - t224;
  const Scalar c_5_2_3 = t224 + t225;
  c[116] = c_5_2_3;
  const Scalar t226 = t217 - s_4 * (s_5 * dmu_4_5_y + c_5 * t179);
  const Scalar c_4_3_5 = t218 + t226;
  c[96] = c_4_3_5;
  const Scalar t227 = c_5 * t178;
  const Scalar t228 = Scalar(2.430379746835443) * f_u_6_6_t_x;
  const Scalar t229 = t227 + t143 + t228;
  const Scalar t230 = Scalar(0.5221518987341772) * hu_5_t_x;
  const Scalar Ic_4_yy = Ic_5_zz - t230 - Scalar(0.34490204856053924);
  const Scalar t231 = t229 + Ic_4_yy;
  const Scalar t232 = t136 + t94 - Scalar(0.08142043634273043);
  const Scalar t233 = Scalar(2.0) * t232;
  const Scalar t234 = t233 * w_1_4_y - t206 * t68 - t231 * t67 - f_4_4_x * v_o_1_4_y;
  const Scalar t235 = hc_4_x * v_o_1_4_y - t208 * t68 + t233 * t67 + t231 * w_1_4_y;
  const Scalar t236 = v_o_1_4_y * (hc_4_x * t67 + f_4_4_x * w_1_4_y);
  const Scalar c_4_1_1 = -t236 - t68 * (t210 - t211) + w_1_4_y * t234 - t67 * t235;
  c[84] = c_4_1_1;
  c[117] = -db_33_5r;
  const Scalar Iu_4_a_xy = s_4 * t206 - c_4 * t208;
  const Scalar t237 = c_3 * t209;
  const Scalar t238 = s_3 * Iu_4_a_xy - t237;
  c[37] = Scalar(2.0) * t238;
  const Scalar mu_5_3_z = t200 - t203;
  const Scalar t239 = s_2 * mu_5_3_z + c_2 * t225;
  const Scalar t240 = t112 * df_2_5_z + w_1_5_y * t148 + w_1_5_x * t149 - t52 * t79 + w_1_4_y * t84;
  const Scalar c_2_1_5 = t239 - t240;
  c[38] = c_2_1_5;
  c[115] = -c_3_1_5;
  c[67] = -c_5_2_3;
  c[69] = t226 - t218;
  c[120] = -c_4_3_5;
  c[6] = -c_4_1_1;
  const Scalar t241 = s_4 * t233 - c_4 * t231;
  const Scalar t242 = Scalar(0.2610759493670886) * hc_4_x - t241;
  const Scalar t243 = c_4 * t233 + s_4 * t231;
  const Scalar dmu_3_4_y = Scalar(0.2610759493670886) * f_4_4_x - t243;
  const Scalar t244 = s_4 * hc_4_x - c_4 * f_4_4_x;
  const Scalar t245 = Scalar(-0.2610759493670886) * t244;
  const Scalar db_33_4r = t245 - s_4 * t242 + c_4 * dmu_3_4_y;
  c[64] = db_33_4r;
  c[11] = -t239 - t240;
  c[113] = -c_2_1_5;
  c[89] = -db_33_4r;
  const Scalar t246 = t212 * t68;
  const Scalar t247 = t246 - t244 * v_o_1_4_y + w_1_4_y * dmu_3_4_y + t67 * t242;
  const Scalar t248 = Iu_6_t_xx - t230 + t227 - t228 + Scalar(0.39592218471735474);
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * f_4_4_x;
  const Scalar t249 = Scalar(0.2610759493670886) * hu_4_t_x + t244 + t248;
  const Scalar t250 = t246 + t66 * t249;
  const Scalar c_3_1_4 = t250 + t247;
  c[62] = c_3_1_4;
  c[8] = t247 - t250;
  c[87] = -c_3_1_4;
  const Scalar t251 = c_4 * t241;
  const Scalar t252 = Scalar(0.5221518987341772) * hu_4_t_x;
  const Scalar t253 = t252 + t248 - Scalar(0.35069998060812224);
  const Scalar Iu_3_t_d = t251 + Ic_4_yy - t253;
  const Scalar t254 = t181 - Scalar(0.000060956210475372) + t212;
  const Scalar t255 = Scalar(2.0) * t254;
  const Scalar t256 = s_3 * t255 - c_3 * Iu_3_t_d;
  const Scalar t257 = s_3 * t256;
  const Scalar dmu_2_3_y = c_3 * t255 + s_3 * Iu_3_t_d;
  const Scalar c_3_2_2 = t257 - c_3 * dmu_2_3_y;
  c[58] = c_3_2_2;
  const Scalar t258 = Scalar(0.002743824053281128) - t245 + t232 - s_4 * t241;
  const Scalar Ic_3_yz = Iu_4_a_xy - Scalar(0.002188628560919792);
  const Scalar hc_3_x = Scalar(0.118003557659776) + hu_4_t_x;
  const Scalar t259 = Scalar(0.004459880990724) + t154;
  const Scalar t260 = c_3 * t259 + s_3 * hc_3_x;
  const Scalar t261 = t260 - c_3 * Ic_3_yz + s_3 * t258;
  const Scalar t262 = Scalar(2.0) * s_2;
  c[5] = -t261 * t262;
  const Scalar t263 = s_3 * (t259 - Ic_3_yz) - c_3 * (t258 + hc_3_x);
  c[33] = Scalar(2.0) * t263;
  const Scalar t264 = c_3 * t206 - s_3 * (f_4_4_x - t241);
  const Scalar t265 = c_3 * t208 + s_3 * (hc_4_x + t243);
  const Scalar t266 = s_3 * (hu_4_t_x * v_o_1_4_y + s_2 * t238);
  const Scalar db_12_4r = t68 * t237 - t67 * t265 - t266 + w_1_4_y * t264;
  const Scalar t267 = c_3 * t212;
  const Scalar t268 = t267 - s_3 * t249;
  const Scalar db_14_2 = s_2 * Iu_4_a_xy + c_2 * t268;
  c[7] = db_14_2 + db_12_4r;
  const Scalar c_4_1_2 = db_14_2 - db_12_4r;
  c[85] = c_4_1_2;
  const Scalar t269 = t267 + s_3 * (t244 - s_4 * dmu_3_4_y - c_4 * t242);
  const Scalar c_3_2_4 = t268 + t269;
  c[63] = c_3_2_4;
  c[32] = -c_3_2_2;
  const Scalar t270 = s_3 * (s_3 * hu_4_t_x - s_4 * t264 + c_4 * t265);
  const Scalar db_22_4r = c_3 * (t237 - t238) + t270;
  c[35] = db_22_4r;
  c[34] = -c_4_1_2;
  c[36] = t269 - t268;
  c[88] = -c_3_2_4;
  c[86] = -db_22_4r;
  c[2] = Scalar(2.0) * (s_2 * (Scalar(0.0003844680514732) + t261) -
      c_2 * (Scalar(0.005130550910504085) + t254 - t257));
  const Scalar t271 = c_3 * t256;
  const Scalar t272 = c_2 * t263;
  const Scalar t273 = t272 + s_2 * (t271 + s_3 * dmu_2_3_y);
  const Scalar t274 = t229 - t252 + t251 - Scalar(0.41230240163465);
  const Scalar db_13_2 = s_2 * t274 - t272;
  c[4] = db_13_2 + t273;
  const Scalar c_3_1_2 = db_13_2 - t273;
  c[57] = c_3_1_2;
  const Scalar t275 = Scalar(2.0) * t244 + t274 - t271 + t253 + Scalar(0.8860432804898606);
  const Scalar t276 = Scalar(0.00199167944196776) + t263;
  const Scalar t277 = c_2 * (s_2 * t275 - Scalar(2.0) * c_2 * t276);
  const Scalar c_1_1_2 = t277 + s_2 * (t276 * t262 + c_2 * t275);
  c[1] = c_1_1_2;
  const Scalar t278 = s_3 * (c_2 * t258 - s_2 * t256);
  const Scalar t279 = s_2 * (t278 - c_3 * (c_2 * Ic_3_yz - s_2 * dmu_2_3_y));
  const Scalar c_3_1_1 = c_2 * s_2 * (t260 + t261) + t279;
  c[56] = c_3_1_1;
  c[31] = -c_3_1_2;
  c[28] = -c_1_1_2;
  c[3] = -c_3_1_1;
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
// Reads q[1..6], qd[0..6]. Operations: 745 mul, 639 add, 12 sin/cos. Always zero: 1 of the 49
// entries of C.
template <class Scalar, class SinCos = LibrarySinCos>
inline void coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
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
  const Scalar I_t7_g = Scalar(0.001210471889260615) * c_7 - Scalar(0.000391391281684248) * s_7;
  const Scalar t8 = c_7 * I_t7_g;
  const Scalar omega_r_6_a_z = c_5 * omega_4_z - s_5 * t4;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar I_7_xy = Scalar(0.000195695640842124) + s_7 * I_t7_g;
  const Scalar t9 = omega_6_z * I_7_xy;
  const Scalar t10 = t9 - t7 * t8;
  const Scalar omega_r_6_y = c_6 * omega_5_z + s_6 * t5;
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar t11 = Scalar(0.0004826525849595559) * c_7 - Scalar(0.0006277682991364491) * s_7;
  const Scalar t12 = omega_7_z * t11;
  const Scalar L_7_x = t10 - t12;
  const Scalar t13 = -t10 - t12 + Scalar(0.002131604094419858) * t7;
  const Scalar t14 = Scalar(-2.0) * t7;
  const Scalar mr_7_x = Scalar(0.0004066296486714361) * c_7 - Scalar(0.0003214415134685639) * s_7;
  const Scalar mr_7_y = Scalar(0.0003214415134685639) * c_7 + Scalar(0.0004066296486714361) * s_7;
  const Scalar t15 = Scalar(2.0) * mr_7_y;
  const Scalar t16 = mr_7_x * t14 + omega_6_z * t15;
  const Scalar t17 = t9 - t7 * (t8 - Scalar(0.001210471889260615));
  const Scalar C_67 = L_7_x - Scalar(0.27848101265822783) * t16 + t13 + Scalar(2.0) * t17;
  C[41] = C_67;
  const Scalar t18 = mr_7_y * omega_7_z;
  const Scalar t19 = Scalar(0.5569620253164557) * t18;
  const Scalar t20 = omega_7_z * I_7_xy;
  const Scalar Iu_7_a_xy = Scalar(0.0006277682991364491) * c_7 +
      Scalar(0.0004826525849595559) * s_7;
  const Scalar Ic_6_yz = Scalar(0.0000467845486573025) + Iu_7_a_xy;
  const Scalar t21 = t7 * Ic_6_yz;
  const Scalar t22 = Scalar(0.000103758917218685) * omega_r_6_y - t19 + Scalar(2.0) * (t20 - t21);
  const Scalar t23 = Scalar(0.0000518794586093425) + Scalar(0.27848101265822783) * mr_7_y;
  const Scalar t24 = I_7_xy - t23;
  const Scalar C_66 = Scalar(2.0) * (t21 + omega_r_6_y * t24) + t22;
  C[40] = C_66;
  const Scalar t25 = Scalar(0.5569620253164557) * mr_7_y;
  const Scalar t26 = L_7_x - omega_6_z * t25 - t13;
  const Scalar t27 = Scalar(0.27848101265822783) * mr_7_x;
  const Scalar t28 = t27 + Scalar(0.003342075983680473);
  C[47] = -t26 - Scalar(2.0) * (omega_r_6_y * t11 + t7 * t28);
  const Scalar t29 = t7 * I_7_xy + omega_6_z * t8;
  const Scalar t30 = omega_7_z * Iu_7_a_xy;
  const Scalar t31 = -t29 - t30 + Scalar(0.001210471889260615) * omega_6_z;
  const Scalar t32 = t30 - t29 + Scalar(0.003342075983680473) * omega_6_z;
  const Scalar t33 = Scalar(2.0) * t29 - t31 + t32;
  const Scalar mu_u_qd7_6_t_y = c_6 * t19 + s_6 * t33;
  C[34] = mu_u_qd7_6_t_y;
  const Scalar t34 = Scalar(0.5569620253164557) * mr_7_x;
  const Scalar kappa_7_6_x = omega_6_z * t34 + t31 + t32;
  const Scalar t35 = Scalar(2.0) * (t7 * Iu_7_a_xy + omega_6_z * t11) - omega_r_6_y * t25;
  const Scalar t36 = c_6 * t35 - s_6 * kappa_7_6_x;
  const Scalar t37 = c_6 * t11 - s_6 * t28;
  C[46] = Scalar(2.0) * (t5 * Iu_7_a_xy + omega_r_6_a_z * t37) - t36;
  const Scalar t38 = mr_7_x * omega_7_z;
  const Scalar t39 = Scalar(2.0) * c_6 * t38 - s_6 * t16;
  const Scalar t40 = Scalar(2.0) * s_5;
  const Scalar t41 = c_5 * t39 + t40 * t18;
  const Scalar t42 = c_6 * t33 - s_6 * t19;
  const Scalar t43 = Scalar(2.0) * s_6;
  const Scalar t44 = c_6 * t16 + t43 * t38;
  const Scalar dtau_qd4_7 = Scalar(0.2610759493670886) * t44 + Scalar(1.2151898734177216) * t41 +
      c_5 * C_67 - s_5 * t42;
  C[27] = dtau_qd4_7;
  const Scalar t45 = t11 + Scalar(0.007374285191337658);
  const Scalar t46 = t7 * t45;
  const Scalar t47 = (omega_r_6_y - omega_7_z) * t27 - t46;
  const Scalar t48 = omega_6_z * Ic_6_yz;
  const Scalar t49 = Scalar(0.003342075983680473) * omega_7_z - t48 - t47;
  const Scalar t50 = Scalar(2.0) * omega_7_z * (t8 - Scalar(0.0006052359446303075)) - t48 + t47 +
      Scalar(0.021522255370587554) * omega_r_6_y;
  const Scalar t51 = t49 - t50;
  const Scalar t52 = Scalar(0.007374285191337658) * omega_r_6_y;
  const Scalar t53 = omega_6_z * t23;
  const Scalar t54 = t53 - L_7_x + Scalar(0.004771885634746098) * t7 - t52;
  const Scalar t55 = -t53 - t13 - t52 + Scalar(0.026294141005333654) * t7;
  const Scalar t56 = t54 + t55;
  const Scalar t57 = c_6 * t56 - s_6 * t51;
  const Scalar t58 = t8 - t34 - Scalar(0.027504612894594268);
  const Scalar t59 = t5 * t58;
  const Scalar t60 = c_6 * t24 - s_6 * Ic_6_yz;
  C[39] = t57 + Scalar(2.0) * (t59 - omega_r_6_a_z * t60);
  const Scalar Ic_6_xx = t8 + Scalar(0.004771885634746098);
  const Scalar t61 = t49 + t50 + Scalar(2.0) * (t46 + omega_r_6_y * Ic_6_xx);
  const Scalar Ic_6_yy = t34 + Scalar(0.003342075983680473);
  const Scalar t62 = t54 - t55 - Scalar(2.0) * (t7 * Ic_6_yy + omega_r_6_y * t45);
  const Scalar t63 = c_6 * t62 - s_6 * t61;
  C[33] = -t63;
  const Scalar t64 = s_6 * t35 + c_6 * kappa_7_6_x;
  const Scalar t65 = Scalar(0.5221518987341772) * omega_4_z;
  const Scalar t66 = c_6 * mr_7_y;
  const Scalar t67 = c_5 * t66 - s_5 * mr_7_x;
  const Scalar t68 = s_6 * mr_7_y;
  const Scalar t69 = t65 * (t67 - Scalar(4.654545454545454) * t68) + c_5 * t26 + s_5 * t64;
  const Scalar f_u_7_4k_a_z = s_5 * t66 + c_5 * mr_7_x;
  const Scalar mu_7_4_x = Scalar(1.2151898734177216) * f_u_7_4k_a_z - s_5 * Iu_7_a_xy - c_5 * t37;
  const Scalar t70 = Scalar(0.2610759493670886) * f_u_7_4k_a_z;
  const Scalar t71 = s_6 * t11 - t70 + c_6 * t28;
  C[45] = Scalar(2.0) * (t6 * mu_7_4_x - t4 * t71) - t69;
  const Scalar t72 = c_6 * t51 + s_6 * t56;
  const Scalar hc_6_x = mr_7_x + Scalar(0.03663191332581);
  const Scalar f_u_6_5k_t_x = Scalar(0.027461143479902) * c_6 - s_6 * hc_6_x;
  const Scalar t73 = f_u_6_5k_t_x * t65;
  const Scalar t74 = t22 + t73;
  const Scalar t75 = Scalar(2.430379746835443) * omega_4_z;
  const Scalar hu_6_t_x = Scalar(0.027461143479902) * s_6 + c_6 * hc_6_x;
  const Scalar t76 = c_5 * t74 + s_5 * t72 - hu_6_t_x * t75;
  const Scalar t77 = t58 + Scalar(1.2151898734177216) * f_u_6_5k_t_x;
  const Scalar t78 = s_5 * t77 - c_5 * t60;
  const Scalar t79 = c_6 * Ic_6_yz + s_6 * t24;
  const Scalar t80 = s_5 * f_u_6_5k_t_x;
  const Scalar t81 = Scalar(0.2610759493670886) * t80;
  const Scalar t82 = t79 - t81;
  C[38] = t76 - Scalar(2.0) * (t6 * t78 - t4 * t82);
  const Scalar t83 = c_6 * t61 + s_6 * t62;
  const Scalar t84 = mr_7_x * omega_6_z;
  const Scalar t85 = t84 + mr_7_y * t7;
  const Scalar P_6_y = t85 + Scalar(0.03663191332581) * omega_6_z;
  const Scalar t86 = Scalar(2.0) * P_6_y - t7 * t15;
  const Scalar P_6_x = Scalar(0.027461143479902) * omega_6_z - t18;
  const Scalar df_qd6_6_y = Scalar(2.0) * P_6_x - omega_r_6_y * t15;
  const Scalar t87 = c_6 * t86 + s_6 * df_qd6_6_y;
  const Scalar f_u_qd6_6_a_y = Scalar(0.054922286959804) * omega_r_6_y - hc_6_x * t14;
  const Scalar t88 = c_5 * t87 + s_5 * f_u_qd6_6_a_y;
  const Scalar t89 = c_6 * df_qd6_6_y - s_6 * t86;
  const Scalar t90 = Scalar(0.2610759493670886) * t89 - c_5 * C_66 + s_5 * t83 -
      Scalar(1.2151898734177216) * t88;
  C[26] = -t90;
  const Scalar t91 = Scalar(2.0) * c_5 * t18 - s_5 * t39;
  const Scalar t92 = Scalar(0.2610759493670886) * t91;
  const Scalar t93 = mu_u_qd7_6_t_y - t92;
  const Scalar t94 = Scalar(1.2151898734177216) * t91 - c_5 * t42 - s_5 * C_67;
  const Scalar dtau_qd3_7 = t92 + c_4 * t93 - s_4 * t94;
  C[20] = dtau_qd3_7;
  const Scalar t95 = Scalar(2.0) * (omega_r_6_y * t23 + t20) + Scalar(2.0) * omega_6_z * t45;
  const Scalar t96 = Scalar(0.000093569097314605) * t7 - t19 + t35 +
      Scalar(0.014748570382675316) * omega_6_z;
  const Scalar t97 = Scalar(0.0000518794586093425) * t7 + Scalar(0.27848101265822783) * (t84 + t85);
  const Scalar t98 = Scalar(0.0000467845486573025) * omega_r_6_y;
  const Scalar t99 = t98 - t97 + Scalar(0.004771885634746098) * omega_6_z - t32;
  const Scalar t100 = t43 * t99 + c_6 * (t95 + t96);
  const Scalar t101 = Scalar(0.004600245517563106) * omega_r_6_a_z - c_6 * t100;
  const Scalar t102 = Scalar(0.00216405205209813) * t5;
  const Scalar t103 = t102 + t101 + t95;
  const Scalar Iu_6_t_d = Ic_6_xx - Ic_6_yy;
  const Scalar t104 = c_6 * Iu_6_t_d - t45 * t43;
  const Scalar t105 = t11 + s_6 * t104 + Scalar(0.005074162432556105);
  const Scalar t106 = t79 - Scalar(0.001082026026049065);
  const Scalar t107 = t103 + Scalar(2.0) * (t5 * t106 + omega_r_6_a_z * t105);
  C[32] = -t107;
  const Scalar t108 = Scalar(0.000757622236663515) * t5;
  const Scalar t109 = Scalar(0.001082026026049065) * omega_5_z;
  const Scalar t110 = Scalar(0.001451156065026714) * omega_r_6_a_z - t108 + t109 - t99 + s_6 * t100;
  const Scalar t111 = t98 + t97 - t108 + t31 - t109 + Scalar(0.026294141005333654) * omega_6_z;
  const Scalar t112 = c_6 * t104;
  const Scalar Ic_5_xx = Ic_6_yy + t112 + Scalar(0.015058143566941042);
  const Scalar t113 = t60 + Scalar(0.000757622236663515);
  const Scalar t114 = t111 - t110 - Scalar(2.0) * (t5 * t113 + omega_r_6_a_z * Ic_5_xx);
  const Scalar t115 = Scalar(0.000757622236663515) * omega_r_6_a_z;
  const Scalar t116 = Scalar(0.002300122758781553) * omega_5_z;
  const Scalar t117 = t116 - t115 + c_6 * t54 - s_6 * t49 + Scalar(0.015058143566941042) * t5;
  const Scalar dI_5_yz = -t115 - t116 + Scalar(0.016509299631967757) * t5 - c_6 * t55 - s_6 * t50;
  const Scalar t118 = t117 - dI_5_yz + Scalar(2.0) * (t59 - omega_r_6_a_z * t113);
  const Scalar t119 = Scalar(0.01072355976515) * omega_5_z - c_6 * P_6_x + s_6 * P_6_y;
  const Scalar t120 = Scalar(2.0) * omega_r_6_a_z;
  const Scalar t121 = f_u_6_5k_t_x * t120 + Scalar(2.0) * t119;
  const Scalar t122 = t38 + Scalar(0.002315289741004) * omega_5_z + Scalar(0.027461143479902) * t7 -
      Scalar(0.03663191332581) * omega_r_6_y;
  const Scalar t123 = Scalar(2.0) * t5;
  const Scalar df_qd5_5_x = Scalar(2.0) * t122 - f_u_6_5k_t_x * t123;
  const Scalar f_u_qd5_5_t_x = c_5 * df_qd5_5_x + s_5 * t121;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.002315289741004);
  const Scalar f_5_5_x = mr_7_y - Scalar(0.01072355976515);
  const Scalar t124 = hc_5_x * t123 - f_5_5_x * t120;
  const Scalar dtau_qd4_5 = Scalar(0.2610759493670886) * t124 + c_5 * t118 - s_5 * t114 -
      Scalar(1.2151898734177216) * f_u_qd5_5_t_x;
  C[25] = dtau_qd4_5;
  const Scalar t125 = Scalar(2.430379746835443) * t4 - Scalar(0.5221518987341772) * t6;
  const Scalar t126 = -t65 * f_u_7_4k_a_z - t125 * t68 - s_5 * t26 + c_5 * t64;
  const Scalar t127 = -t125 * t67 - t75 * f_u_7_4k_a_z + t36;
  const Scalar t128 = c_4 * t67 - s_4 * t68;
  const Scalar t129 = Scalar(0.5221518987341772) * omega_3_z;
  const Scalar kappa_u_7_2k_a_y = c_4 * t127 - t129 * t128 - s_4 * t126;
  const Scalar t130 = c_4 * mu_7_4_x + s_4 * t71;
  const Scalar t131 = c_4 * t68 + s_4 * t67;
  const Scalar t132 = Scalar(0.2610759493670886) * (t68 - t131) + Scalar(1.2151898734177216) * t67 -
      c_5 * Iu_7_a_xy + s_5 * t37;
  C[44] = Scalar(2.0) * (omega_r_3_y * t130 - t2 * t132) - kappa_u_7_2k_a_y;
  const Scalar t133 = s_5 * t74 - c_5 * t72 + hu_6_t_x * t125;
  const Scalar t134 = t57 - f_u_6_5k_t_x * (c_5 * t125 + s_5 * t75);
  const Scalar t135 = c_5 * f_u_6_5k_t_x;
  const Scalar t136 = c_4 * t135 - s_4 * hu_6_t_x;
  const Scalar kappa_6_3_z = c_4 * t134 - t129 * t136 + s_4 * t133;
  const Scalar t137 = s_4 * t82 + c_4 * t78;
  const Scalar f_u_6_3k_t_y = c_4 * hu_6_t_x + s_4 * t135;
  const Scalar mu_6_3_y = s_5 * t60 + Scalar(0.2610759493670886) * (hu_6_t_x - f_u_6_3k_t_y) +
      c_5 * t77;
  C[37] = kappa_6_3_z - Scalar(2.0) * (omega_r_3_y * t137 - t2 * mu_6_3_y);
  const Scalar t138 = c_5 * f_u_qd6_6_a_y - s_5 * t87;
  const Scalar t139 = Scalar(-0.2610759493670886) * t138;
  const Scalar t140 = t63 - t139;
  const Scalar t141 = -s_5 * C_66 - c_5 * t83 + Scalar(1.2151898734177216) * t138;
  const Scalar t142 = t139 + c_4 * t140 + s_4 * t141;
  C[19] = -t142;
  const Scalar t143 = omega_r_3_y * f_u_7_4k_a_z + omega_3_z * t131;
  const Scalar t144 = Scalar(0.5221518987341772) * t143 - c_4 * t126 - s_4 * t127;
  const Scalar t145 = Scalar(0.5221518987341772) * omega_r_3_y;
  const Scalar t146 = t145 * t128 + t69;
  const Scalar t147 = c_3 * f_u_7_4k_a_z + s_3 * t128;
  const Scalar mu_u_7_2k_a_y = t70 + c_4 * t71 - s_4 * mu_7_4_x;
  const Scalar t148 = c_2 * (t147 + c_3 * t130 + s_3 * t132) - s_2 * mu_u_7_2k_a_y;
  const Scalar t149 = qd_1 * t148 - qd_2 * t131;
  C[43] = c_3 * t146 - Scalar(2.0) * t149 - s_3 * t144;
  const Scalar t150 = t110 + t111;
  const Scalar kappa_5_5_y = t117 + dI_5_yz;
  const Scalar t151 = c_5 * f_5_5_x - s_5 * hc_5_x;
  const Scalar t152 = c_5 * kappa_5_5_y - t151 * t65 - s_5 * t150;
  const Scalar hu_5_t_x = s_5 * f_5_5_x + c_5 * hc_5_x;
  const Scalar t153 = -s_5 * t106 - c_5 * t105 + Scalar(1.2151898734177216) * hu_5_t_x;
  const Scalar Ic_5_zz = t8 - t112 + Scalar(0.021281185266713853);
  const Scalar t154 = Scalar(0.2610759493670886) * hu_5_t_x;
  const Scalar mu_5_4_y = Ic_5_zz - t154;
  C[31] = -t152 - Scalar(2.0) * (t6 * t153 - t4 * mu_5_4_y);
  const Scalar t155 = c_5 * t121 - s_5 * df_qd5_5_x;
  const Scalar t156 = Scalar(-0.2610759493670886) * t155;
  const Scalar t157 = t107 + t156;
  const Scalar t158 = c_5 * t114 + s_5 * t118 + Scalar(1.2151898734177216) * t155;
  const Scalar C_35 = t156 - c_4 * t157 + s_4 * t158;
  C[18] = C_35;
  const Scalar t159 = omega_r_3_y * t80 + omega_3_z * f_u_6_3k_t_y;
  const Scalar t160 = Scalar(0.5221518987341772) * t159 + c_4 * t133 - s_4 * t134;
  const Scalar t161 = t145 * t136 + t76;
  const Scalar t162 = c_3 * t80 + s_3 * t136;
  const Scalar mu_6_3_z = t81 + c_4 * t82 - s_4 * t78;
  const Scalar t163 = c_2 * (t162 + c_3 * t137 + s_3 * mu_6_3_y) - s_2 * mu_6_3_z;
  const Scalar t164 = qd_1 * t163 - qd_2 * f_u_6_3k_t_y;
  C[36] = s_3 * t160 - c_3 * t161 + Scalar(2.0) * t164;
  const Scalar t165 = t138 - s_4 * t140 + c_4 * t141;
  const Scalar t166 = c_4 * t89 - s_4 * t88;
  const Scalar t167 = Scalar(-0.2610759493670886) * t166 - c_4 * t88 - s_4 * t89 + t90;
  C[12] = c_3 * t167 - s_3 * t165;
  const Scalar t168 = t91 + c_4 * t94 + s_4 * t93;
  const Scalar f_u_qd7_3_a_y = c_4 * t44 + s_4 * t41;
  const Scalar t169 = c_4 * t41 - Scalar(0.2610759493670886) * f_u_qd7_3_a_y - s_4 * t44 +
      dtau_qd4_7;
  C[13] = -c_3 * t169 - s_3 * t168;
  const Scalar t170 = Scalar(2.0) * t1;
  const Scalar t171 = s_2 * (t170 * t131 + c_3 * t144 + s_3 * t146);
  const Scalar t172 = qd_2 * t147 - t1 * (c_3 * t128 - s_3 * f_u_7_4k_a_z);
  const Scalar kappa_7_2_y = Scalar(2.0) * t172 + kappa_u_7_2k_a_y;
  C[42] = t171 - c_2 * kappa_7_2_y;
  C[6] = c_2 * dtau_qd3_7 - s_2 * (s_3 * t169 - c_3 * t168);
  const Scalar t173 = t151 * t125;
  const Scalar t174 = hu_5_t_x * t75;
  const Scalar t175 = t103 + t173 + t174;
  const Scalar t176 = t151 * t129 + t175;
  const Scalar t177 = c_5 * t150 - hu_5_t_x * t65 + s_5 * kappa_5_5_y;
  const Scalar t178 = s_4 * t177 + c_4 * t176;
  const Scalar t179 = c_4 * t153 + s_4 * mu_5_4_y;
  const Scalar t180 = c_5 * t106 - s_5 * t105;
  const Scalar t181 = Scalar(-0.2610759493670886) * t151;
  const Scalar t182 = t180 - t181 * (s_4 - Scalar(4.654545454545454));
  C[30] = -t178 - Scalar(2.0) * (omega_r_3_y * t179 + t2 * t182);
  const Scalar t183 = hu_5_t_x * t145 - c_4 * t177 + s_4 * t176;
  const Scalar t184 = c_4 * t151;
  const Scalar t185 = t152 - t145 * t184;
  const Scalar t186 = s_3 * t184 + c_3 * hu_5_t_x;
  const Scalar mu_5_3_z = t154 + c_4 * mu_5_4_y - s_4 * t153;
  const Scalar t187 = c_2 * (t186 + c_3 * t179 - s_3 * t182) - s_2 * mu_5_3_z;
  const Scalar t188 = s_4 * t151;
  const Scalar t189 = qd_1 * t187 - qd_2 * t188;
  C[29] = c_3 * t185 + Scalar(2.0) * t189 + s_3 * t183;
  const Scalar t190 = s_2 * (t170 * f_u_6_3k_t_y + c_3 * t160 + s_3 * t161);
  const Scalar t191 = qd_2 * t162 - t1 * (c_3 * t136 - s_3 * t80);
  C[35] = c_2 * (Scalar(2.0) * t191 + kappa_6_3_z) - t190;
  const Scalar t192 = Scalar(0.00151524447332703) * omega_5_z;
  const Scalar t193 = t192 + t101 + t96;
  const Scalar t194 = t102 - t192 + t22;
  const Scalar t195 = Scalar(0.001082026026049065) * omega_r_6_a_z;
  const Scalar t196 = Scalar(0.002300122758781553) * t5;
  const Scalar t197 = -t195 - t196 + Scalar(0.015058143566941042) * omega_5_z - c_6 * t50 +
      s_6 * t55;
  const Scalar t198 = c_5 * (t193 - t194) - t40 * t197;
  const Scalar t199 = Scalar(0.0039053550262761) * t6 + c_5 * t198;
  const Scalar t200 = c_5 * t119 - s_5 * t122;
  const Scalar t201 = Scalar(-0.5221518987341772) * t200;
  const Scalar t202 = Scalar(0.002315289741004) * omega_r_6_a_z + Scalar(0.01072355976515) * t5 -
      c_6 * P_6_y - s_6 * P_6_x;
  const Scalar t203 = Scalar(2.430379746835443) * t202 - t73;
  const Scalar t204 = Scalar(-0.00164448757736927) * t4;
  const Scalar t205 = t193 - t204 - t199 - t201 - t174 - t203;
  const Scalar t206 = t113 * t40 + c_5 * (t58 + Ic_5_xx);
  const Scalar t207 = t181 - Scalar(0.00195267751313805);
  const Scalar t208 = t113 - t207 - s_5 * t206;
  const Scalar t209 = Scalar(0.000822243788684635) + Scalar(1.2151898734177216) * t151;
  const Scalar t210 = t180 - t209;
  const Scalar dtaud_4_4 = Scalar(2.0) * (t6 * t208 + t4 * t210) + t205;
  C[24] = dtaud_4_4;
  const Scalar t211 = s_4 * t157 + t155 + c_4 * t158;
  const Scalar t212 = c_4 * t124 - s_4 * f_u_qd5_5_t_x;
  const Scalar t213 = Scalar(-0.2610759493670886) * t212 - s_4 * t124 - c_4 * f_u_qd5_5_t_x +
      dtau_qd4_5;
  C[11] = s_3 * t211 - c_3 * t213;
  C[5] = s_2 * (s_3 * t167 + c_3 * t165) - c_2 * t142;
  const Scalar P_u5_a_z = s_5 * t119 + c_5 * t122;
  const Scalar t214 = Scalar(-0.5) * t125;
  const Scalar t215 = hu_5_t_x * t214 - Scalar(0.2610759493670886) * P_u5_a_z +
      Scalar(0.08142043634273043) * t4;
  const Scalar t216 = omega_4_z * t209;
  const Scalar t217 = t216 - t197 - s_5 * t198 + Scalar(0.0510201361568155) * t6 - t215;
  const Scalar t218 = t196 - t195 - c_6 * t49 - s_6 * t54 +
      Scalar(0.016509299631967757) * omega_5_z - t216 - t215;
  const Scalar t219 = c_5 * t206;
  const Scalar t220 = Scalar(2.430379746835443) * f_u_6_5k_t_x;
  const Scalar t221 = t58 - t219 + t220 - Scalar(0.3238615474695915);
  const Scalar t222 = Scalar(0.2610759493670886) * f_u_6_5k_t_x + t153 -
      Scalar(0.08142043634273043);
  const Scalar t223 = t218 - t217 + Scalar(2.0) * (t4 * t222 + t6 * t221);
  const Scalar t224 = Scalar(1.2151898734177216) * P_u5_a_z - f_u_6_5k_t_x * t214 +
      Scalar(0.08142043634273043) * t6;
  const Scalar t225 = omega_4_z * t207;
  const Scalar t226 = s_5 * t110 - t225 - c_5 * dI_5_yz - t224 + Scalar(0.374881683626407) * t4;
  const Scalar t227 = t225 + c_5 * t117 - s_5 * t111 - t224 + Scalar(0.3238615474695915) * t4;
  const Scalar t228 = Scalar(0.5221518987341772) * hu_5_t_x;
  const Scalar Ic_4_yy = Ic_5_zz - t228;
  const Scalar t229 = Scalar(2.0) * (t6 * t222 - t4 * Ic_4_yy) + t227 - t226;
  const Scalar hc_4_x = hu_5_t_x - Scalar(0.0873392833947);
  const Scalar f_4_4_x = f_u_6_5k_t_x - Scalar(0.317978721469274);
  const Scalar t230 = t4 * hc_4_x + t6 * f_4_4_x;
  const Scalar dtau_qd3_4 = Scalar(0.5221518987341772) * t230 - c_4 * t229 - s_4 * t223;
  C[17] = dtau_qd3_4;
  C[4] = c_2 * C_35 - s_2 * (s_3 * t213 + c_3 * t211);
  const Scalar t231 = t218 + t217;
  const Scalar t232 = t227 + t226;
  const Scalar t233 = c_4 * f_4_4_x - s_4 * hc_4_x;
  const Scalar t234 = s_4 * t231 - t233 * t129 + c_4 * t232;
  const Scalar t235 = c_4 * t208 - s_4 * t210;
  const Scalar t236 = Ic_5_xx - t228 - t219 - t220 + Scalar(0.374881683626407);
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * f_4_4_x;
  const Scalar t237 = Scalar(0.2610759493670886) * hu_4_t_x + t236;
  C[23] = t234 + Scalar(2.0) * (omega_r_3_y * t235 - t2 * t237);
  const Scalar t238 = s_2 * (t170 * t188 - s_3 * t185 + c_3 * t183);
  const Scalar t239 = qd_2 * t186 - t1 * (c_3 * t184 - s_3 * hu_5_t_x);
  C[28] = -c_2 * (t178 - Scalar(2.0) * t239) - t238;
  const Scalar kappa_4_3_x = c_4 * t231 + hu_4_t_x * t129 - s_4 * t232;
  const Scalar t240 = t205 + t233 * t145;
  const Scalar t241 = s_4 * t208 + c_4 * t210;
  const Scalar t242 = s_2 * t241 - c_2 * (s_3 * (t233 - t237) - c_3 * t235);
  const Scalar t243 = qd_1 * t242 + qd_2 * hu_4_t_x;
  C[22] = s_3 * kappa_4_3_x - c_3 * t240 - Scalar(2.0) * t243;
  const Scalar t244 = t200 + Scalar(0.317978721469274) * omega_4_z;
  const Scalar t245 = Scalar(-2.0) * t151;
  const Scalar t246 = Scalar(2.0) * t244 - t6 * t245;
  const Scalar t247 = t202 + Scalar(0.0873392833947) * omega_4_z;
  const Scalar df_qd4_4_x = Scalar(2.0) * t247 - t4 * t245;
  const Scalar t248 = c_4 * t246 - s_4 * df_qd4_4_x;
  const Scalar t249 = dtaud_4_4 - Scalar(0.2610759493670886) * t248 - c_4 * df_qd4_4_x - s_4 * t246;
  const Scalar t250 = c_4 * t223 - s_4 * t229 + Scalar(2.0) * t230;
  C[10] = -c_3 * t249 - s_3 * t250;
  const Scalar t251 = Scalar(0.16284087268546085) * omega_4_z;
  const Scalar t252 = t194 + t199 - t173 - t203 - t251;
  const Scalar t253 = t204 - t201 - t175 + t251;
  const Scalar t254 = Scalar(0.000822243788684635) * t6 -
      Scalar(1.2151898734177216) * (t200 - omega_4_z * f_u_6_5k_t_x);
  const Scalar t255 = Scalar(0.00195267751313805) * t4 -
      Scalar(0.2610759493670886) * (t202 - omega_4_z * hu_5_t_x);
  const Scalar t256 = t255 - c_5 * t110 - s_5 * dI_5_yz - t254 +
      Scalar(0.3238615474695915) * omega_4_z;
  const Scalar t257 = Scalar(2.0) * s_4;
  const Scalar t258 = c_4 * (t252 - t253) - t257 * t256;
  const Scalar t259 = c_4 * t258;
  const Scalar t260 = c_4 * t244 - s_4 * t247;
  const Scalar t261 = Scalar(-0.004377257121839584) * t2;
  const Scalar t262 = Scalar(0.005487648106562256) * omega_r_3_y - t261 -
      Scalar(0.5221518987341772) * (omega_3_z * t151 + t260) + t252 - t259;
  const Scalar t263 = c_4 * (Ic_4_yy + t221) - t222 * t257;
  const Scalar t264 = Scalar(0.2610759493670886) * t233 - Scalar(0.002743824053281128);
  const Scalar t265 = t222 - t264 + s_4 * t263;
  const Scalar t266 = Scalar(0.002188628560919792) + t241;
  const Scalar dtaud_3_3 = t262 - Scalar(2.0) * (t2 * t266 + omega_r_3_y * t265);
  C[16] = dtaud_3_3;
  const Scalar kappa_4_2_x = s_3 * t240 + c_3 * kappa_4_3_x + hu_4_t_x * t170;
  const Scalar t267 = Scalar(-2.0) * t233;
  C[21] = c_2 * (t234 + t2 * t267) - s_2 * kappa_4_2_x;
  C[3] = c_2 * dtau_qd3_4 - s_2 * (s_3 * t249 - c_3 * t250);
  const Scalar t268 = c_4 * t247 + s_4 * t244;
  const Scalar t269 = Scalar(0.000060956210475372) * t2 +
      Scalar(0.2610759493670886) * (t268 + omega_r_3_y * hu_4_t_x);
  const Scalar t270 = Scalar(0.002188628560919792) * omega_3_z;
  const Scalar t271 = t270 + Scalar(0.061602421026527694) * omega_r_3_y + t269 + t256 + s_4 * t258;
  const Scalar t272 = t270 - t255 + s_5 * t117 + c_5 * t111 - t254 - t269 +
      Scalar(0.374881683626407) * omega_4_z;
  const Scalar t273 = t272 - t271;
  const Scalar t274 = omega_3_z * t264;
  const Scalar t275 = Scalar(0.000060956210475372) + t181;
  const Scalar t276 = omega_r_3_y * t275;
  const Scalar t277 = t276 + Scalar(0.06740035307411071) * t2 + t274 - s_4 * t217 - c_4 * t226;
  const Scalar t278 = Scalar(0.00579793204758302) * t2 + t276 - t274 + s_4 * t218 + c_4 * t227;
  const Scalar t279 = t278 + t277;
  const Scalar t280 = c_3 * t265 - s_3 * t266;
  const Scalar hc_3_x = Scalar(0.118003557659776) + hu_4_t_x;
  const Scalar t281 = t151 - Scalar(0.004459880990724);
  const Scalar t282 = s_3 * t281 + c_3 * hc_3_x;
  const Scalar t283 = c_4 * t263;
  const Scalar t284 = Scalar(0.5221518987341772) * hu_4_t_x;
  const Scalar t285 = s_2 * (-t284 - Scalar(0.06740035307411071) - t283 + t221);
  const Scalar t286 = Scalar(2.0) * qd_1;
  const Scalar t287 = t286 * (c_2 * (t282 + t280) + t285);
  C[15] = c_3 * t279 + t287 - s_3 * t273;
  const Scalar t288 = Scalar(0.004459880990724) * omega_3_z + t260;
  const Scalar Ic_3_xx = Scalar(0.00579793204758302) + Ic_4_yy - t283;
  const Scalar t289 = t275 + t235;
  const Scalar t290 = t288 - t2 * t289 - omega_r_3_y * (t233 - Ic_3_xx);
  const Scalar t291 = t272 + t271 + Scalar(2.0) * t290;
  const Scalar t292 = -P_u5_a_z - Scalar(0.0873392833947) * t6 + Scalar(0.317978721469274) * t4;
  const Scalar P_3_y = Scalar(0.118003557659776) * omega_3_z + t292;
  const Scalar t293 = t284 + t236;
  const Scalar t294 = omega_r_3_y * t289 + P_3_y + t2 * (t233 - t293);
  const Scalar t295 = t278 - t277 + Scalar(2.0) * t294;
  C[9] = s_3 * t291 - c_3 * t295;
  const Scalar t296 = c_3 * t281 - s_3 * hc_3_x;
  const Scalar t297 = t1 * t296;
  const Scalar t298 = qd_2 * t282;
  const Scalar t299 = t262 - Scalar(2.0) * (t297 - t298);
  C[14] = c_2 * t299 + s_2 * (s_3 * t279 + c_3 * t273);
  C[2] = c_2 * dtaud_3_3 - s_2 * (s_3 * t295 + c_3 * t291);
  const Scalar t300 = Scalar(2.0) * (omega_3_z * t275 + omega_r_3_y * t264) + t253 + t259;
  const Scalar t301 = Scalar(0.000121912420950744) * omega_3_z - t261 +
      Scalar(0.5221518987341772) * t260 - t240;
  const Scalar t302 = Scalar(0.002743824053281128) * t2 +
      Scalar(0.2610759493670886) * (omega_3_z * hu_4_t_x + t292);
  const Scalar t303 = Scalar(0.002188628560919792) * omega_r_3_y;
  const Scalar t304 = Scalar(0.00579793204758302) * omega_3_z - t303 - t302 - c_4 * t217 +
      s_4 * t226;
  const Scalar t305 = Scalar(2.0) * s_3;
  const Scalar t306 = c_3 * (t301 + t300) - t305 * t304;
  const Scalar t307 = Scalar(0.01026110182100817) * t3 - c_3 * t306;
  const Scalar Iu_3_t_d = Ic_3_xx - t293;
  const Scalar t308 = t289 * t305 + c_3 * Iu_3_t_d;
  const Scalar t309 = t296 - Scalar(0.0003844680514732);
  const Scalar t310 = s_2 * (t309 - c_3 * t266 - s_3 * t265);
  const Scalar t311 = qd_1 * (c_2 * (t289 - Scalar(0.005130550910504085) - s_3 * t308) - t310);
  const Scalar t312 = Scalar(0.004459880990724) * t2 + Scalar(0.118003557659776) * omega_r_3_y +
      t268;
  const Scalar t313 = Scalar(0.0007689361029464) * t1;
  C[8] = t300 - t313 + t307 - Scalar(2.0) * (t312 - t298 - t311);
  const Scalar t314 = t282 - Scalar(0.00199167944196776);
  const Scalar t315 = t1 * t314;
  const Scalar t316 = qd_2 * t309;
  const Scalar t317 = Scalar(0.023077882494931805) * t3 + t315 - t304 - t316 - s_3 * t306;
  const Scalar t318 = t280 + t314;
  const Scalar t319 = c_2 * (c_3 * t308 + t293 + t267 + Scalar(0.5353432998817383)) - s_2 * t318;
  const Scalar t320 = Scalar(0.06740035307411071) * omega_3_z - t303 + c_4 * t218 + t302 + t315 +
      t316 - s_4 * t227;
  const Scalar t321 = qd_1 * (Scalar(0.00199167944196776) * c_2 + s_2 * t233);
  const Scalar t322 = t321 - c_3 * P_3_y + s_3 * t288;
  const Scalar t323 = Scalar(0.005130550910504085) * qd_2;
  const Scalar dI_2_yz = t323 - c_3 * t277 + Scalar(0.5584211823766702) * t1 - t322 - s_3 * t271;
  const Scalar t324 = c_3 * t278 - t323 + Scalar(0.5353432998817383) * t1 - t322 - s_3 * t272;
  const Scalar t325 = c_2 * (t286 * (c_2 * t318 + t285) + t324 - dI_2_yz);
  C[1] = t325 - s_2 * (t320 - t317 - t319 * t286);
  C[7] = s_2 * (t320 + t317) - c_2 * (t324 + dI_2_yz);
  const Scalar t326 = Scalar(0.00398335888393552) * qd_2;
  const Scalar t327 = t301 - t326 + t307 + Scalar(2.0) * (t297 + t312);
  const Scalar dI_u2_t_d = t326 - t313 - t327 - t299;
  const Scalar t328 = Scalar(0.005130550910504085) * t1 - Scalar(0.0003844680514732) * t3 -
      c_3 * (t288 + t271) - s_3 * (P_3_y - t277) - qd_2 * (t233 - Scalar(0.5353432998817383));
  C[0] = -t327 - c_2 * (c_2 * dI_u2_t_d - Scalar(2.0) * s_2 * t328);
  C[48] = Scalar(0.0);
}

// Gravity torques g(q) (7.39).
//   q[7]  in   joint positions, rad or m
//   g[7]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[1..6]. Operations: 43 mul, 29 add, 12 sin/cos. Always zero: g[0].
template <class Scalar, class SinCos = LibrarySinCos>
inline void gravity(const Scalar* q, Scalar* g, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
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
// Reads q[1..6], qd[0..6]. Operations: 267 mul, 239 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5],
      s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = s_2 * qd_1;
  const Scalar t2 = s_3 * t1;
  const Scalar omega_r_3_y = t2 + c_3 * qd_2;
  const Scalar t3 = c_2 * qd_1;
  const Scalar omega_3_z = qd_3 + t3;
  const Scalar t4 = Scalar(2.0) * qd_2;
  const Scalar t5 = c_3 * t4;
  const Scalar t6 = (t2 + t5) * t3;
  const Scalar t7 = Scalar(2.0) * omega_r_3_y * omega_3_z - t6;
  const Scalar t8 = c_3 * t1;
  const Scalar t9 = s_3 * qd_2 - t8;
  const Scalar t10 = t9 * omega_r_3_y;
  const Scalar t11 = qd_2 * t1;
  const Scalar U_3_xy = t10 + t11;
  const Scalar t12 = c_4 * U_3_xy + s_4 * t7;
  const Scalar t13 = c_4 * t9 + s_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar t14 = t13 * omega_4_z;
  const Scalar t15 = t14 + t12;
  const Scalar t16 = t14 + t15;
  const Scalar t17 = s_4 * U_3_xy - c_4 * t7;
  const Scalar t18 = s_4 * t9 - c_4 * omega_3_z;
  const Scalar t19 = t17 + Scalar(2.0) * t18 * omega_4_z;
  const Scalar t20 = t10 - t11;
  const Scalar t21 = t1 * t3;
  const Scalar t22 = t21 + Scalar(31.044303797468356) * s_2;
  const Scalar ddp_3_y = t5 * t3 + s_3 * t22;
  const Scalar t23 = Scalar(0.2610759493670886) * t20 + ddp_3_y;
  const Scalar t24 = Scalar(0.2610759493670886) * t16 + t23 + Scalar(1.2151898734177216) * t19;
  const Scalar t25 = t9 * omega_3_z;
  const Scalar t26 = s_3 * t4;
  const Scalar t27 = (t8 - t26) * t3;
  const Scalar t28 = t25 + t27;
  const Scalar t29 = t25 + t28;
  const Scalar t30 = t1 * t1;
  const Scalar t31 = qd_2 * qd_2;
  const Scalar Uz_o_3_y = t30 + t31;
  const Scalar ddp_3_a_z = Scalar(31.044303797468356) * c_2 - Uz_o_3_y;
  const Scalar t32 = Scalar(0.2610759493670886) * t29 + ddp_3_a_z;
  const Scalar t33 = t9 * t9;
  const Scalar t34 = omega_3_z * omega_3_z;
  const Scalar t35 = t34 - t33;
  const Scalar t36 = Uz_o_3_y + t35;
  const Scalar t37 = t26 * t3 - c_3 * t22;
  const Scalar t38 = Scalar(0.2610759493670886) * t36 - t37;
  const Scalar t39 = s_4 * t32 - c_4 * t38;
  const Scalar t40 = t13 * t13;
  const Scalar t41 = omega_4_z * omega_4_z;
  const Scalar t42 = t41 - t40;
  const Scalar Uz_o_4_y = t33 + t34;
  const Scalar t43 = Uz_o_4_y + t42;
  const Scalar t44 = t13 * t18;
  const Scalar t45 = t28 + t44;
  const Scalar ddp_o_5_x = Scalar(0.2610759493670886) * t43 - Scalar(1.2151898734177216) * t45 +
      t39;
  const Scalar ddp_5_x = s_5 * t24 + c_5 * ddp_o_5_x;
  const Scalar t46 = s_4 * t38 + c_4 * t32;
  const Scalar t47 = t28 - t44;
  const Scalar t48 = t41 + t40;
  const Scalar t49 = Scalar(0.2610759493670886) * t47 + Scalar(1.2151898734177216) * t48 - t46;
  const Scalar t50 = s_6 * t49 - c_6 * ddp_5_x;
  const Scalar t51 = s_5 * omega_4_z - c_5 * t13;
  const Scalar omega_5_z = qd_5 - t18;
  const Scalar t52 = s_6 * omega_5_z - c_6 * t51;
  const Scalar t53 = t52 * t52;
  const Scalar omega_r_6_a_z = s_5 * t13 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t54 = omega_6_z * omega_6_z;
  const Scalar t55 = t54 - t53;
  const Scalar t56 = t51 * t51;
  const Scalar t57 = omega_5_z * omega_5_z;
  const Scalar Uz_o_6_y = t56 + t57;
  const Scalar t58 = Uz_o_6_y + t55;
  const Scalar t59 = Scalar(0.27848101265822783) * t58 + t50;
  const Scalar mr_7_y = Scalar(0.0006428830269371278) * c_7 + Scalar(0.0008132592973428722) * s_7;
  const Scalar t60 = s_5 * t45 + c_5 * t19;
  const Scalar t61 = t60 + Scalar(2.0) * omega_r_6_a_z * omega_5_z;
  const Scalar t62 = t51 * omega_r_6_a_z;
  const Scalar t63 = t62 + t15;
  const Scalar t64 = s_6 * t61 - c_6 * t63;
  const Scalar t65 = Scalar(2.0) * omega_6_z;
  const Scalar t66 = t64 - t52 * t65;
  const Scalar ddp_6_a_z = s_5 * ddp_o_5_x - c_5 * t24;
  const Scalar ddp_o_7_z = ddp_6_a_z - Scalar(0.27848101265822783) * t66;
  const Scalar mr_7_x = Scalar(0.0008132592973428722) * c_7 - Scalar(0.0006428830269371278) * s_7;
  const Scalar t67 = s_6 * t63 + c_6 * t61;
  const Scalar omega_r_6_y = s_6 * t51 + c_6 * omega_5_z;
  const Scalar t68 = t67 - omega_r_6_y * t65;
  const Scalar t69 = Scalar(0.0009653051699191118) * c_7 - Scalar(0.0012555365982728983) * s_7;
  const Scalar I_t7_g = Scalar(0.00242094377852123) * c_7 - Scalar(0.000782782563368496) * s_7;
  const Scalar t70 = c_7 * I_t7_g;
  const Scalar t71 = t70 - Scalar(0.004552547872941088);
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar t72 = omega_7_z * omega_7_z;
  const Scalar t73 = t54 + t72;
  const Scalar t74 = t53 + t72;
  const Scalar I_7_xy = Scalar(0.000391391281684248) + s_7 * I_t7_g;
  const Scalar I_7_xx = t70 + Scalar(0.002131604094419858);
  const Scalar t75 = s_5 * t19 - c_5 * t45;
  const Scalar t76 = t51 * omega_5_z;
  const Scalar t77 = t76 + t75;
  const Scalar t78 = t52 * omega_r_6_y;
  const Scalar t79 = t78 + t77;
  const Scalar t80 = Scalar(0.0012555365982728983) * c_7 + Scalar(0.0009653051699191118) * s_7;
  const Scalar t81 = -mr_7_y * t59 - mr_7_x * ddp_o_7_z + I_7_xy * (t73 - t74) - t68 * t69 -
      t79 * t80 + t64 * I_7_xx - t66 * t71;
  n[6] = -t81;
  const Scalar t82 = t68 - t65 * omega_7_z;
  const Scalar t83 = t77 - t78;
  const Scalar t84 = Scalar(0.27848101265822783) * t83 + s_6 * ddp_5_x + c_6 * t49;
  const Scalar t85 = t79 + Scalar(2.0) * t52 * omega_7_z;
  const Scalar t86 = mr_7_x * t85 - mr_7_y * t82 + Scalar(0.26308374115809) * t84;
  const Scalar Uz_o_7_y = t53 + t54;
  const Scalar n_6 = Scalar(0.000103758917218685) * t67 - mr_7_x * t84 -
      Scalar(0.001119670733427555) * t83 + t69 * (Uz_o_7_y - t73) +
      t64 * (Scalar(0.000093569097314605) + t80) - t82 * I_7_xy + t85 * t71 -
      Scalar(0.028934422545659894) * t79 - Scalar(0.014748570382675316) * (t58 - Uz_o_7_y) -
      Scalar(0.054922286959804) * t50 - Scalar(0.27848101265822783) * t86;
  n[5] = n_6;
  const Scalar F_7_y = -mr_7_y * t74 - mr_7_x * t66 + Scalar(0.26308374115809) * ddp_o_7_z;
  const Scalar t87 = Scalar(0.000103758917218685) * t55 + Scalar(0.000093569097314605) * t79 -
      Scalar(0.001119670733427555) * t66 - t81 + Scalar(0.014748570382675316) * t68 +
      Scalar(0.27848101265822783) * F_7_y;
  const Scalar U_7_yy_zz = Uz_o_7_y - t74;
  const Scalar U_6_yy_zz = Uz_o_6_y - Uz_o_7_y;
  const Scalar t88 = Scalar(-0.000103758917218685) * t83 -
      Scalar(0.000093569097314605) * U_6_yy_zz - mr_7_y * t84 + t80 * U_7_yy_zz + t85 * I_7_xy +
      t82 * I_7_xx - t66 * (t69 + Scalar(0.014748570382675316)) +
      Scalar(0.054922286959804) * ddp_6_a_z + Scalar(0.028934422545659894) * t68;
  const Scalar t89 = t57 - t56;
  const Scalar t90 = t48 + t89;
  const Scalar t91 = t15 - t62;
  const Scalar n_5 = Scalar(0.00216405205209813) * t75 - Scalar(0.001451156065026714) * t91 +
      Scalar(0.00151524447332703) * (t90 - Uz_o_6_y) + Scalar(0.004600245517563106) * t60 -
      Scalar(0.010045187828321245) * t63 + Scalar(0.004630579482008) * ddp_6_a_z -
      Scalar(0.0214471195303) * ddp_5_x - s_6 * t88 - c_6 * t87;
  n[4] = n_5;
  const Scalar f_6_y = Scalar(0.054922286959804) * Uz_o_7_y - t86;
  const Scalar t92 = mr_7_x * t73 - mr_7_y * t64 + Scalar(0.054922286959804) * t79 +
      Scalar(0.26308374115809) * t59;
  const Scalar f_5_x = Scalar(0.004630579482008) * t90 + Scalar(0.0214471195303) * t63 -
      s_6 * f_6_y - c_6 * t92 + Scalar(0.4059881025443391) * ddp_5_x;
  const Scalar t93 = Scalar(0.004630579482008) * t91 - Scalar(0.0214471195303) * Uz_o_6_y -
      Scalar(0.054922286959804) * t68 - Scalar(0.4059881025443391) * ddp_6_a_z - F_7_y;
  const Scalar t94 = s_5 * t93 - c_5 * f_5_x;
  const Scalar t95 = t76 + t77;
  const Scalar U_5_yy_zz = t48 - Uz_o_6_y;
  const Scalar t96 = Scalar(0.004600245517563106) * t91 - Scalar(0.00151524447332703) * t95 +
      Scalar(0.00216405205209813) * U_5_yy_zz - Scalar(0.010045187828321245) * t61 -
      Scalar(0.0214471195303) * t49 - c_6 * t88 + s_6 * t87;
  const Scalar f_5_z = Scalar(0.004630579482008) * t95 - Scalar(0.0214471195303) * t61 - s_6 * t92 +
      c_6 * f_6_y - Scalar(0.4059881025443391) * t49;
  const Scalar t97 = Scalar(0.00216405205209813) * t63 - Scalar(0.001451156065026714) * t95 -
      Scalar(0.00151524447332703) * t61 + Scalar(0.004600245517563106) * t89 +
      Scalar(0.004630579482008) * t49 + n_6;
  const Scalar mu_4_z = Scalar(0.00164448757736927) * t12 - Scalar(0.0039053550262761) * t17 +
      Scalar(0.0054157634981905) * t47 + Scalar(0.04942675278013915) * (t43 - t48) - s_5 * t96 +
      Scalar(0.17709188611756838) * t39 + c_5 * t97 - Scalar(0.29071723622709367) * t45 -
      Scalar(0.2610759493670886) * f_5_z + Scalar(1.2151898734177216) * t94;
  n[3] = mu_4_z;
  const Scalar f_u_5_t_y = s_5 * f_5_x + c_5 * t93;
  const Scalar U_4_yy_zz = Uz_o_4_y - t48;
  const Scalar t98 = Scalar(0.0039053550262761) * t47 - Scalar(0.00164448757736927) * U_4_yy_zz +
      Scalar(0.04942675278013915) * t16 + c_5 * t96 + Scalar(0.17709188611756838) * t23 +
      s_5 * t97 + Scalar(0.29071723622709367) * t19 - Scalar(1.2151898734177216) * f_u_5_t_y;
  const Scalar t99 = Scalar(0.0039053550262761) * t42 - Scalar(0.00164448757736927) * t45 -
      Scalar(0.0054157634981905) * t16 + Scalar(0.04942675278013915) * t19 + n_5 -
      Scalar(0.2610759493670886) * f_u_5_t_y;
  const Scalar t100 = Scalar(0.17709188611756838) * t19 - Scalar(0.23490692527912765) * t23 -
      f_u_5_t_y;
  const Scalar mu_3_z = Scalar(0.000121912420950744) * (t36 - Uz_o_4_y) -
      Scalar(0.000013360662912304) * t20 + Scalar(0.004377257121839584) * t27 +
      Scalar(0.005487648106562256) * t6 - Scalar(0.022178148964878235) * U_3_xy -
      Scalar(0.008919761981448) * t37 + c_4 * t99 - Scalar(0.2610759493670886) * t100 + s_4 * t98;
  n[2] = mu_3_z;
  const Scalar t101 = Scalar(0.17709188611756838) * t45 + Scalar(0.23490692527912765) * t39 - t94;
  const Scalar f_4_y = Scalar(0.17709188611756838) * t48 + Scalar(0.23490692527912765) * t46 +
      f_5_z;
  const Scalar t102 = s_4 * t101 + c_4 * f_4_y;
  const Scalar t103 = Scalar(0.000121912420950744) * t7 - Scalar(0.000013360662912304) * t29 +
      Scalar(0.005487648106562256) * t35 - Scalar(0.013297019103287584) * U_3_xy -
      Scalar(0.15288324476823525) * t37 + Scalar(0.2610759493670886) * t102 + s_4 * f_4_y -
      c_4 * t101 + mu_4_z;
  const Scalar t104 = Scalar(0.000121912420950744) * t29 - Scalar(0.005487648106562256) * t20 +
      Scalar(0.27690780075318) * c_2 - Scalar(0.013297019103287584) * (Uz_o_3_y - Uz_o_4_y) +
      Scalar(0.022178148964878235) * t7 - Scalar(0.15288324476823525) * ddp_3_y - s_4 * t99 + t100 +
      c_4 * t98;
  const Scalar t105 = qd_1 * qd_1;
  n[1] = Scalar(0.01993386669246) * c_2 - Scalar(0.00796671776787104) * t30 +
      Scalar(0.00398335888393552) * t105 + Scalar(0.04777783501284299) * t21 - c_3 * t103 +
      s_3 * t104;
  const Scalar t106 = qd_2 * t3;
  const Scalar t107 = Scalar(0.0007689361029464) * (Uz_o_3_y - t105) +
      Scalar(0.00796671776787104) * t11 - Scalar(0.01026110182100817) * t21 -
      Scalar(0.04939990503582237) * t106 - s_3 * t103 - c_3 * t104;
  const Scalar t108 = Scalar(0.00796671776787104) * t106 - Scalar(0.0007689361029464) * t21 +
      Scalar(0.01026110182100817) * (t31 - t30) + Scalar(0.04615576498986361) * t11 - mu_3_z;
  n[0] = s_2 * t107 - c_2 * t108;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[7]    in   joint positions, rad or m
//   qd[7]   in   joint velocities, rad/s or m/s
//   tau[7]  in   joint torques or forces, N m or N
//   qdd[7]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[1..6], qd[0..6], tau[0..6]. Operations: 537 mul, 452 add, 6 div, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  const Scalar tau_1 = tau[0], tau_2 = tau[1], tau_3 = tau[2], tau_4 = tau[3], tau_5 = tau[4],
      tau_6 = tau[5], tau_7 = tau[6];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5],
      s_7 = sine[6], c_7 = cosine[6];
  const Scalar Iu_7_t_g = Scalar(0.00242094377852123) * c_7 - Scalar(0.000782782563368496) * s_7;
  const Scalar t1 = c_7 * Iu_7_t_g;
  const Scalar Iu_7_t_xx = t1 - Scalar(0.00242094377852123);
  const Scalar hu_7_t_x = Scalar(0.0008132592973428722) * c_7 - Scalar(0.0006428830269371278) * s_7;
  const Scalar t2 = Scalar(0.5569620253164557) * hu_7_t_x;
  const Scalar Ic_6_yy = t2 - Scalar(0.00528056308065248);
  const Scalar Iu_6_t_d = Iu_7_t_xx - Ic_6_yy;
  const Scalar Iu_7_a_xz = Scalar(0.0009653051699191118) * c_7 -
      Scalar(0.0012555365982728983) * s_7;
  const Scalar Ic_6_xy = Iu_7_a_xz + Scalar(0.014748570382675316);
  const Scalar t3 = Scalar(2.0) * s_6;
  const Scalar t4 = Ic_6_xy * t3 - c_6 * Iu_6_t_d;
  const Scalar t5 = c_6 * t4;
  const Scalar Iu_6_t_xx = Ic_6_yy - t5;
  const Scalar t6 = t1 - t2 - Scalar(0.055009225789188536);
  const Scalar t7 = t6 + Scalar(0.04208100218189551);
  const Scalar Iu_5_t_d = Iu_6_t_xx + t7;
  const Scalar t8 = s_7 * Iu_7_t_g;
  const Scalar hu_7_t_y = Scalar(0.0006428830269371278) * c_7 + Scalar(0.0008132592973428722) * s_7;
  const Scalar t9 = Scalar(0.27848101265822783) * hu_7_t_y - Scalar(0.000287632364465563) - t8;
  const Scalar Iu_7_a_xy = Scalar(0.0012555365982728983) * c_7 +
      Scalar(0.0009653051699191118) * s_7;
  const Scalar Ic_6_yz = Scalar(0.000093569097314605) + Iu_7_a_xy;
  const Scalar Iu_6_a_xz = s_6 * Ic_6_yz + c_6 * t9;
  const Scalar Ic_5_xy = Iu_6_a_xz - Scalar(0.00151524447332703);
  const Scalar t10 = Scalar(2.0) * s_5 * Ic_5_xy - c_5 * Iu_5_t_d;
  const Scalar t11 = c_5 * t10;
  const Scalar t12 = t11 + t7;
  const Scalar hc_6_x = hu_7_t_x + Scalar(0.07326382665162);
  const Scalar f_u_6_6_t_x = Scalar(0.054922286959804) * c_6 - s_6 * hc_6_x;
  const Scalar t13 = Scalar(2.430379746835443) * f_u_6_6_t_x;
  const Scalar t14 = t12 + t13;
  const Scalar Iu_6_t_yy = Iu_7_t_xx + t5;
  const Scalar hu_6_t_x = Scalar(0.054922286959804) * s_6 + c_6 * hc_6_x;
  const Scalar hc_5_x = hu_6_t_x - Scalar(0.004630579482008);
  const Scalar f_5_5_x = hu_7_t_y - Scalar(0.0214471195303);
  const Scalar hu_5_t_x = s_5 * f_5_5_x + c_5 * hc_5_x;
  const Scalar t15 = Scalar(0.5221518987341772) * hu_5_t_x;
  const Scalar Ic_4_yy = Iu_6_t_yy - t15 - Scalar(0.6448207828091296);
  const Scalar Iu_6_t_xy = Ic_6_xy - s_6 * t4;
  const Scalar Ic_5_xz = Iu_6_t_xy - Scalar(0.004600245517563106);
  const Scalar t16 = s_6 * t9 - c_6 * Ic_6_yz;
  const Scalar t17 = t16 + Scalar(0.00216405205209813);
  const Scalar t18 = s_5 * t17 - c_5 * Ic_5_xz;
  const Scalar t19 = t18 + Scalar(1.2151898734177216) * hu_5_t_x;
  const Scalar t20 = Scalar(0.2610759493670886) * f_u_6_6_t_x;
  const Scalar t21 = t20 + t19 - Scalar(0.16284087268546085);
  const Scalar t22 = Scalar(2.0) * s_4 * t21 - c_4 * (t14 + Ic_4_yy);
  const Scalar t23 = c_4 * t22;
  const Scalar Iu_4_t_xx = t23 + Ic_4_yy;
  const Scalar Iu_5_t_yy = Iu_6_t_xx + t11;
  const Scalar t24 = Iu_5_t_yy - t15 - t13 + Scalar(0.7918443694347095);
  const Scalar hc_4_x = hu_5_t_x - Scalar(0.1746785667894);
  const Scalar f_4_4_x = f_u_6_6_t_x - Scalar(0.635957442938548);
  const Scalar hu_4_t_x = c_4 * hc_4_x + s_4 * f_4_4_x;
  const Scalar t25 = Scalar(0.5221518987341772) * hu_4_t_x;
  const Scalar t26 = t25 + t24 - Scalar(0.7013999612162445);
  const Scalar Iu_3_t_d = Iu_4_t_xx - t26;
  const Scalar Iu_5_t_xy = Ic_5_xy - s_5 * t10;
  const Scalar t27 = s_5 * hc_5_x - c_5 * f_5_5_x;
  const Scalar t28 = Scalar(-0.2610759493670886) * t27;
  const Scalar t29 = Scalar(-0.0039053550262761) - t28 + Iu_5_t_xy;
  const Scalar t30 = c_5 * t17 + s_5 * Ic_5_xz;
  const Scalar t31 = Scalar(1.2151898734177216) * t27 - t30;
  const Scalar t32 = t31 - Scalar(0.00164448757736927);
  const Scalar t33 = c_4 * t29 + s_4 * t32;
  const Scalar t34 = t28 - Scalar(0.000121912420950744) + t33;
  const Scalar t35 = Scalar(2.0) * s_3 * t34 - c_3 * Iu_3_t_d;
  const Scalar t36 = c_3 * t35;
  const Scalar t37 = t26 - t36;
  const Scalar t38 = s_4 * hc_4_x - c_4 * f_4_4_x;
  const Scalar t39 = Scalar(-2.0) * t38;
  const Scalar t40 = t37 - t39;
  const Scalar t41 = t14 + t23;
  const Scalar t42 = t41 - t25 - Scalar(0.8246048032693);
  const Scalar t43 = t21 - s_4 * t22;
  const Scalar t44 = Scalar(0.005487648106562256) + Scalar(0.2610759493670886) * t38 + t43;
  const Scalar Iu_4_a_xy = s_4 * t29 - c_4 * t32;
  const Scalar Ic_3_yz = Iu_4_a_xy - Scalar(0.004377257121839584);
  const Scalar hc_3_x = Scalar(0.236007115319552) + hu_4_t_x;
  const Scalar t45 = Scalar(0.008919761981448) + t27;
  const Scalar t46 = s_3 * t45 - c_3 * hc_3_x;
  const Scalar t47 = t46 - s_3 * Ic_3_yz - c_3 * t44;
  const Scalar t48 = Scalar(0.00398335888393552) + t47;
  const Scalar t49 = Scalar(2.0) * s_2 * t48 + c_2 * (t42 + t40 + Scalar(1.7720865609797212));
  const Scalar t50 = (t48 - s_2 * t49) * qd_1;
  const Scalar Iu_3_t_yy = Iu_4_t_xx + t36;
  const Scalar t51 = t37 - Iu_3_t_yy;
  const Scalar t52 = s_2 * (t42 + t51);
  const Scalar t53 = qd_1 * (t50 - qd_3 * t52);
  const Scalar t54 = s_3 * t44 - c_3 * Ic_3_yz;
  const Scalar t55 = s_2 * qd_1;
  const Scalar t56 = Scalar(2.0) * qd_2;
  const Scalar t57 = qd_1 * (qd_2 * t52 + c_2 * (t54 * t55 - t47 * t56));
  const Scalar Iu_4_d = t41 + Iu_4_t_xx;
  const Scalar t58 = c_3 * t55;
  const Scalar t59 = s_3 * qd_2 - t58;
  const Scalar t60 = Scalar(2.0) * t43;
  const Scalar t61 = c_2 * qd_1;
  const Scalar omega_3_z = qd_3 + t61;
  const Scalar t62 = s_3 * t55;
  const Scalar omega_r_3_y = t62 + c_3 * qd_2;
  const Scalar t63 = Scalar(2.0) * omega_r_3_y;
  const Scalar beta_4_f = qd_4 - t63;
  const Scalar t64 = qd_4 * (t33 * beta_4_f + t59 * (t24 - Iu_4_d) + omega_3_z * t60);
  const Scalar t65 = c_4 * t59 + s_4 * omega_3_z;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar t66 = s_5 * omega_4_z - c_5 * t65;
  const Scalar t67 = s_4 * t59 - c_4 * omega_3_z;
  const Scalar omega_5_z = qd_5 - t67;
  const Scalar omega_r_6_y = s_6 * t66 + c_6 * omega_5_z;
  const Scalar t68 = Scalar(2.0) * omega_r_6_y;
  const Scalar beta_7_f = qd_7 - t68;
  const Scalar t69 = hu_7_t_x * beta_7_f;
  const Scalar t70 = s_6 * omega_5_z - c_6 * t66;
  const Scalar omega_r_6_a_z = s_5 * t65 + c_5 * omega_4_z;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t71 = hu_7_t_y * omega_6_z + hu_7_t_x * t70;
  const Scalar t72 = Scalar(2.0) * omega_r_6_a_z;
  const Scalar beta_6_f = qd_6 + t72;
  const Scalar t73 = qd_6 * beta_6_f;
  const Scalar t74 = hu_6_t_x * t73 - qd_7 * (t3 * t71 - c_6 * t69);
  const Scalar t75 = qd_6 * (hu_6_t_x * t66 + f_u_6_6_t_x * omega_5_z);
  const Scalar f_p_6_a_y = hu_7_t_y * qd_7 * beta_7_f + Scalar(2.0) * t75;
  const Scalar t76 = Scalar(-2.0) * t67;
  const Scalar beta_5_f = qd_5 + t76;
  const Scalar t77 = qd_5 * beta_5_f;
  const Scalar t78 = t27 * t77 + s_5 * t74 - c_5 * f_p_6_a_y;
  const Scalar Iu_7_t_xy = Scalar(0.000391391281684248) + t8;
  const Scalar t79 = Scalar(2.0) * Iu_7_t_xy;
  const Scalar Iu_7_d = t1 + Iu_7_t_xx;
  const Scalar Iu_7_y = Iu_7_d + Scalar(0.006684151967360946);
  const Scalar t80 = Iu_7_a_xy * beta_7_f - t70 * t79 + omega_6_z * Iu_7_y;
  const Scalar t81 = Scalar(0.27848101265822783) * beta_7_f;
  const Scalar t82 = s_6 * hu_7_t_y;
  const Scalar Iu_6_d = Iu_6_t_xx - Iu_6_t_yy;
  const Scalar t83 = Scalar(2.0) * Iu_6_t_xy;
  const Scalar t84 = qd_6 * (-t16 * beta_6_f - t66 * t83 + omega_5_z * (t6 - Iu_6_d));
  const Scalar t85 = qd_7 * (t82 * t81 - c_6 * t80) + t84;
  const Scalar t86 = Iu_5_t_yy + t12;
  const Scalar Ic_5_zz = Iu_6_t_yy + Scalar(0.04498331431194894);
  const Scalar Iu_5_y = Ic_5_zz - t86;
  const Scalar t87 = Scalar(2.0) * Iu_5_t_xy;
  const Scalar t88 = qd_5 * (t30 * beta_5_f + t65 * t87 + omega_4_z * Iu_5_y);
  const Scalar t89 = omega_6_z * t79 - Iu_7_a_xz * beta_7_f +
      t70 * (Iu_7_d - Scalar(0.006684151967360946));
  const Scalar t90 = qd_7 * (Scalar(0.5569620253164557) * t71 - t89);
  const Scalar t91 = -s_5 * t90 - c_5 * t85 - t88 + Scalar(1.2151898734177216) * t78;
  const Scalar t92 = c_6 * hu_7_t_y;
  const Scalar t93 = qd_6 * (Iu_6_a_xz * beta_6_f + t66 * (Iu_6_d + t6) - omega_5_z * t83);
  const Scalar t94 = t93 - qd_7 * (t92 * t81 + s_6 * t80);
  const Scalar t95 = t94 - Scalar(0.2610759493670886) * t78;
  const Scalar t96 = t78 + Scalar(2.0) * qd_4 * (t38 * omega_3_z + hu_4_t_x * t59);
  const Scalar t97 = c_4 * t95 + Scalar(0.2610759493670886) * t96 - s_4 * t91 + t64;
  const Scalar t98 = t34 - s_3 * t35;
  const Scalar t99 = t55 * t55;
  const Scalar t100 = qd_2 * qd_2;
  const Scalar t101 = c_3 * t56;
  const Scalar t102 = omega_3_z * t63 - t61 * (t62 + t101);
  const Scalar t103 = t65 * omega_4_z;
  const Scalar t104 = t59 * omega_r_3_y;
  const Scalar t105 = qd_2 * t55;
  const Scalar U_3_xy = t104 + t105;
  const Scalar t106 = c_4 * U_3_xy + t103 + s_4 * t102;
  const Scalar t107 = t104 - t105 + t103 + t106;
  const Scalar t108 = c_4 * t102 - s_4 * U_3_xy + omega_4_z * t76;
  const Scalar t109 = s_2 * (qd_1 * t61 + Scalar(31.044303797468356));
  const Scalar t110 = Scalar(-0.2610759493670886) * t107 - t61 * t101 - s_3 * t109 +
      Scalar(1.2151898734177216) * t108;
  const Scalar t111 = t65 * t65;
  const Scalar t112 = omega_4_z * omega_4_z;
  const Scalar t113 = t112 - t111;
  const Scalar t114 = t59 * t59;
  const Scalar t115 = omega_3_z * omega_3_z;
  const Scalar Uz_o_4_y = t114 + t115;
  const Scalar t116 = t59 * omega_3_z;
  const Scalar t117 = s_3 * t56;
  const Scalar domega_r_4_z = t116 + t61 * (t58 - t117);
  const Scalar Uz_o_3_y = t99 + t100;
  const Scalar t118 = Scalar(0.2610759493670886) * (t116 + domega_r_4_z) - Uz_o_3_y +
      Scalar(31.044303797468356) * c_2;
  const Scalar t119 = t115 - t114;
  const Scalar t120 = Scalar(0.2610759493670886) * (Uz_o_3_y + t119) - t61 * t117 + c_3 * t109;
  const Scalar t121 = t65 * t67;
  const Scalar t122 = domega_r_4_z + t121;
  const Scalar ddp_o_5_x = Scalar(0.2610759493670886) * (Uz_o_4_y + t113) - c_4 * t120 -
      Scalar(1.2151898734177216) * t122 + s_4 * t118;
  const Scalar t123 = s_5 * t110 - c_5 * ddp_o_5_x;
  const Scalar t124 = omega_6_z * omega_6_z - t70 * t70;
  const Scalar t125 = t66 * t66;
  const Scalar t126 = omega_5_z * omega_5_z;
  const Scalar Uz_o_6_y = t125 + t126;
  const Scalar U_4_yx = domega_r_4_z - t121;
  const Scalar t127 = Scalar(0.2610759493670886) * U_4_yx - s_4 * t120 +
      Scalar(1.2151898734177216) * (t112 + t111) - c_4 * t118;
  const Scalar t128 = hu_7_t_y * (Scalar(0.27848101265822783) * (Uz_o_6_y + t124) + s_6 * t127 +
      c_6 * t123);
  const Scalar Uz_o_6_z = s_5 * t122 + omega_5_z * t72 - c_5 * t108;
  const Scalar t129 = t70 * omega_6_z;
  const Scalar U_5_xy = t66 * omega_r_6_a_z + t106;
  const Scalar domega_r_7_z = t129 - s_6 * Uz_o_6_z + c_6 * U_5_xy;
  const Scalar t130 = hu_7_t_x * (Scalar(0.27848101265822783) * (t129 + domega_r_7_z) +
      s_5 * ddp_o_5_x + c_5 * t110);
  const Scalar t131 = Iu_7_a_xz * (-s_6 * U_5_xy - c_6 * Uz_o_6_z + omega_6_z * t68);
  const Scalar t132 = t66 * omega_5_z;
  const Scalar t133 = t132 - c_5 * t122 - s_5 * t108;
  const Scalar t134 = Iu_7_a_xy * (t70 * omega_r_6_y + t133);
  const Scalar t135 = t128 + t130 - t129 * Iu_7_d + t134 - t131 - Iu_7_t_xy * t124 +
      Scalar(0.006684151967360946) * domega_r_7_z - tau_7;
  const Scalar t136 = Scalar(149.60760989322966) * Iu_7_a_xy;
  const Scalar t137 = -t16 * U_5_xy - Iu_6_a_xz * Uz_o_6_z + t90 - t132 * Iu_6_d +
      Iu_6_t_xy * (t126 - t125) - t136 * t135 - t6 * t133 + f_u_6_6_t_x * t123 + hu_6_t_x * t127 +
      tau_6;
  const Scalar t138 = Scalar(0.27848101265822783) * hu_7_t_x + Scalar(0.006684151967360946);
  const Scalar t139 = s_6 * Iu_7_a_xz + c_6 * t138;
  const Scalar t140 = t139 * t136 + t16;
  const Scalar t141 = Iu_7_a_xy * t136 + t6;
  const Scalar t142 = Scalar(1.0) / t141;
  const Scalar t143 = t140 * t142;
  const Scalar t144 = Scalar(149.60760989322966) * t139;
  const Scalar t145 = t30 * t122 - t143 * t137 + t18 * t108 + t94 + Iu_5_t_xy * t113 +
      Ic_5_zz * t106 + t103 * t86 + t27 * ddp_o_5_x + hu_5_t_x * t110 - t144 * t135 + tau_5;
  const Scalar t146 = t6 + Scalar(1.2151898734177216) * f_u_6_6_t_x;
  const Scalar mu_u_6_4_a_y = Scalar(0.2610759493670886) * hu_6_t_x - s_5 * Iu_6_a_xz + c_5 * t146;
  const Scalar t147 = s_6 * t138 - c_6 * Iu_7_a_xz;
  const Scalar t148 = s_5 * hu_7_t_x - c_5 * t92;
  const Scalar t149 = Scalar(1.2151898734177216) * t148 - Scalar(0.2610759493670886) * t82 +
      c_5 * Iu_7_a_xy + s_5 * t147;
  const Scalar t150 = t149 * t136 + mu_u_6_4_a_y;
  const Scalar t151 = t150 * t143 - t149 * t144 + t31;
  const Scalar b_6_5_5 = t140 * t143 - t139 * t144 + Ic_5_zz;
  const Scalar d_5 = Scalar(1.0) / b_6_5_5;
  const Scalar t152 = t151 * d_5;
  const Scalar t153 = hu_5_t_x * t77 + s_5 * f_p_6_a_y + c_5 * t74;
  const Scalar Iu_5_x = Ic_5_zz + t86;
  const Scalar t154 = qd_5 * (t18 * beta_5_f + t65 * Iu_5_x + omega_4_z * t87);
  const Scalar t155 = qd_7 * (s_6 * t69 + Scalar(2.0) * c_6 * t71);
  const Scalar t156 = qd_5 * (t27 * omega_4_z - hu_5_t_x * t65);
  const Scalar t157 = f_u_6_6_t_x * t73 - t155 - Scalar(2.0) * t156;
  const Scalar mu_4_z = s_5 * t85 - c_5 * t90 - Scalar(0.2610759493670886) * t157 + t154 +
      Scalar(1.2151898734177216) * t153;
  const Scalar t158 = t150 * t142;
  const Scalar t159 = Scalar(-149.60760989322966) * t149;
  const Scalar t160 = Iu_4_a_xy * U_3_xy - t33 * t102 + mu_4_z - t159 * t135 - t116 * Iu_4_d +
      t43 * t119 - tau_4 + t152 * t145 + t158 * t137 + t38 * t120 + hu_4_t_x * t118 +
      t24 * domega_r_4_z;
  const Scalar t161 = Scalar(0.2610759493670886) * hu_5_t_x;
  const Scalar mu_5_4_y = Ic_5_zz - t161;
  const Scalar mu_5_3_z = t161 - s_4 * t19 + c_4 * mu_5_4_y;
  const Scalar t162 = c_5 * Iu_6_a_xz + s_5 * t146;
  const Scalar t163 = s_5 * t20;
  const Scalar t164 = t16 + t163;
  const Scalar mu_6_3_z = t163 - c_4 * t164 - s_4 * t162;
  const Scalar f_u_7_5_a_z = s_5 * t92 + c_5 * hu_7_t_x;
  const Scalar mu_7_4_x = Scalar(1.2151898734177216) * f_u_7_5_a_z - s_5 * Iu_7_a_xy + c_5 * t147;
  const Scalar t165 = Scalar(0.2610759493670886) * f_u_7_5_a_z;
  const Scalar t166 = t139 - t165;
  const Scalar mu_u_7_3_a_y = t165 - s_4 * mu_7_4_x + c_4 * t166;
  const Scalar b_7_6_3 = mu_6_3_z - mu_u_7_3_a_y * t136;
  const Scalar b_6_5_3 = -b_7_6_3 * t143 - mu_u_7_3_a_y * t144 + mu_5_3_z;
  const Scalar t167 = Iu_4_a_xy - mu_u_7_3_a_y * t159 + b_7_6_3 * t158 + b_6_5_3 * t152;
  const Scalar t168 = t149 * t159 - t151 * t152 + t150 * t158 + t24;
  const Scalar t169 = Scalar(1.0) / t168;
  const Scalar t170 = t167 * t169;
  const Scalar t171 = b_6_5_3 * d_5;
  const Scalar t172 = b_7_6_3 * t142;
  const Scalar t173 = Scalar(149.60760989322966) * mu_u_7_3_a_y;
  const Scalar t174 = c_3 * t45 + s_3 * hc_3_x;
  const Scalar t175 = t98 * (t100 - t99) - t170 * t160 - t173 * t135 + t97 + tau_3 - t171 * t145 +
      t172 * t137 - t174 * t109 - t57;
  const Scalar t176 = t174 + t54;
  const Scalar t177 = hu_5_t_x + s_4 * mu_5_4_y + c_4 * t19;
  const Scalar t178 = t31 + t27 * (c_4 - Scalar(0.2610759493670886) * s_4);
  const Scalar t179 = f_u_7_5_a_z + s_4 * t166 + c_4 * mu_7_4_x;
  const Scalar t180 = s_4 * t148 - c_4 * t82;
  const Scalar t181 = s_4 * t82 - Scalar(0.2610759493670886) * t180 + c_4 * t148 + t149;
  const Scalar t182 = c_3 * t181 + s_3 * t179;
  const Scalar t183 = s_4 * t164 - c_4 * t162 - s_5 * f_u_6_6_t_x;
  const Scalar t184 = c_5 * f_u_6_6_t_x;
  const Scalar f_u_6_4_t_y = s_4 * t184 + c_4 * hu_6_t_x;
  const Scalar t185 = c_4 * t184 - Scalar(0.2610759493670886) * f_u_6_4_t_y - s_4 * hu_6_t_x +
      mu_u_6_4_a_y;
  const Scalar b_7_6_2 = t182 * t136 + s_3 * t183 + c_3 * t185;
  const Scalar t186 = b_7_6_2 * t143 - t182 * t144 + c_3 * t178 + s_3 * t177;
  const Scalar t187 = Scalar(0.2610759493670886) * hu_4_t_x + t38 + t24;
  const Scalar t188 = -t182 * t159 - s_3 * t33 + t186 * t152 - b_7_6_2 * t158 - c_3 * t187;
  const Scalar t189 = -t182 * t173 - t188 * t170 - t186 * t171 - b_7_6_2 * t172 + t176;
  const Scalar t190 = mu_u_7_3_a_y * t173 + t167 * t170 - b_7_6_3 * t172 + b_6_5_3 * t171 + t42;
  const Scalar t191 = Scalar(1.0) / t190;
  const Scalar t192 = t189 * t191;
  const Scalar beta_3_f = qd_3 + Scalar(2.0) * t61;
  const Scalar t193 = qd_3 * (t98 * t56 + t47 * beta_3_f);
  const Scalar t194 = qd_4 * (Iu_4_a_xy * beta_4_f + t59 * t60 + omega_3_z * (t24 + Iu_4_d));
  const Scalar t195 = s_4 * t95 + c_4 * t91 + t96 + t194;
  const Scalar t196 = t188 * t169;
  const Scalar t197 = qd_4 * beta_4_f;
  const Scalar t198 = s_4 * t153 - c_4 * t157 + t38 * t197;
  const Scalar t199 = s_4 * t157 + c_4 * t153 + mu_4_z - Scalar(0.2610759493670886) * t198 +
      hu_4_t_x * t197;
  const Scalar t200 = t186 * d_5;
  const Scalar t201 = b_7_6_2 * t142;
  const Scalar t202 = Scalar(149.60760989322966) * t182;
  const Scalar hu_2_t_x = s_2 * (t38 + Scalar(1.056862013749792)) -
      c_2 * (Scalar(0.000642110282856) + t46);
  const Scalar y_3_2 = t202 * t135 + c_3 * t199 + tau_2 - t192 * t175 + t201 * t137 - s_3 * t195 -
      t193 + Scalar(31.044303797468356) * hu_2_t_x + t196 * t160 + t200 * t145 - t53;
  const Scalar t203 = b_7_6_2 * t201 - t182 * t202 - t186 * t200 + t189 * t192 + Iu_3_t_yy - t39 -
      t188 * t196 + Scalar(1.8182423259695848);
  const Scalar t204 = Scalar(1.0) / t203;
  const Scalar t205 = s_2 * (s_3 * t178 - c_3 * t177);
  const Scalar t206 = s_2 * (s_3 * t181 - c_3 * t179) - c_2 * mu_u_7_3_a_y;
  const Scalar t207 = s_2 * (c_3 * t183 - s_3 * t185);
  const Scalar b_7_6_1 = t206 * t136 - t207 + c_2 * mu_6_3_z;
  const Scalar t208 = b_7_6_1 * t143 - t206 * t144 + t205 - c_2 * mu_5_3_z;
  const Scalar t209 = s_2 * (c_3 * t33 - s_3 * t187);
  const Scalar t210 = -t206 * t159 - c_2 * Iu_4_a_xy + t208 * t152 - b_7_6_1 * t158 + t209;
  const Scalar t211 = t206 * t173 + t210 * t170 + b_7_6_1 * t172 + t208 * t171 - s_2 * t47 -
      c_2 * t42;
  const Scalar t212 = Scalar(0.01026110182100817) + t98;
  const Scalar t213 = Scalar(0.0007689361029464) + t176;
  const Scalar t214 = t206 * t202 + t208 * t200 - b_7_6_1 * t201 + t211 * t192 + t210 * t196 +
      s_2 * t212 + c_2 * t213;
  const Scalar t215 = t214 * t204;
  const Scalar t216 = qd_2 * (Scalar(2.0) * t50 - (s_2 * t213 - c_2 * t212) * qd_2);
  const Scalar t217 = t211 * t191;
  const Scalar t218 = Scalar(-2.0) * t98 * t55 - t176 * beta_3_f + qd_2 * (t42 - t51);
  const Scalar t219 = s_2 * (s_3 * t199 + c_3 * t195 - qd_3 * t218);
  const Scalar t220 = t210 * t169;
  const Scalar t221 = t208 * d_5;
  const Scalar t222 = b_7_6_1 * t142;
  const Scalar t223 = Scalar(-149.60760989322966) * t206;
  const Scalar t224 = tau_1 - t223 * t135 + t222 * t137 + c_2 * t97 + t215 * y_3_2 + t217 * t175 +
      t220 * t160 + t221 * t145 + t219 + t216;
  const Scalar t225 = t206 * t223 - t208 * t221 + b_7_6_1 * t222 - t214 * t215 - t210 * t220 +
      t211 * t217 + t40 - c_2 * t49 + Scalar(1.8094240094691274);
  const Scalar qdd_1 = t224 / t225;
  qdd[0] = qdd_1;
  const Scalar qdd_2 = t204 * (t214 * qdd_1 + y_3_2);
  qdd[1] = qdd_2;
  const Scalar t226 = t191 * (t189 * qdd_2 - t211 * qdd_1 + t175);
  qdd[2] = -t226;
  const Scalar t227 = t169 * (t167 * t226 + t210 * qdd_1 + t160 + t188 * qdd_2);
  qdd[3] = -t227;
  const Scalar t228 = t208 * qdd_1 + t186 * qdd_2 + b_6_5_3 * t226 + t151 * t227 + t145;
  const Scalar qdd_5 = d_5 * t228;
  qdd[4] = qdd_5;
  const Scalar t229 = t140 * qdd_5 + b_7_6_3 * t226 - b_7_6_1 * qdd_1 - b_7_6_2 * qdd_2 -
      t150 * t227 + t137;
  const Scalar t230 = t142 * t229;
  qdd[5] = -t230;
  const Scalar t231 = t182 * qdd_2 + t149 * t227 + mu_u_7_3_a_y * t226 - t139 * qdd_5;
  qdd[6] = Scalar(-149.60760989322966) * t231 -
      Scalar(149.60760989322966) * (t206 * qdd_1 + Iu_7_a_xy * t230 + t135);
  bool positive = t225 > Scalar(0.0);
  positive &= t203 > Scalar(0.0);
  positive &= -t190 > Scalar(0.0);
  positive &= t168 > Scalar(0.0);
  positive &= b_6_5_5 > Scalar(0.0);
  positive &= -t141 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[7]   in  joint positions, rad or m
//   qd[7]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1..6], qd[0..6]. Operations: 128 mul, 94 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar kinetic_energy(const Scalar* q, const Scalar* qd,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_4 = sine[3],
      c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5],
      s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = s_2 * qd_1;
  const Scalar omega_r_3_y = s_3 * t1 + c_3 * qd_2;
  const Scalar t2 = c_4 * omega_r_3_y;
  const Scalar t3 = s_4 * omega_r_3_y;
  const Scalar t4 = Scalar(3.83030303030303) * t2 - t3;
  const Scalar omega_4_z = qd_4 - omega_r_3_y;
  const Scalar t5 = t4 - Scalar(4.654545454545454) * omega_4_z;
  const Scalar t6 = c_3 * t1 - s_3 * qd_2;
  const Scalar t7 = c_2 * qd_1;
  const Scalar omega_3_z = qd_3 + t7;
  const Scalar t8 = c_4 * t6 - s_4 * omega_3_z;
  const Scalar t9 = s_4 * t6 + c_4 * omega_3_z;
  const Scalar t10 = omega_3_z + Scalar(3.83030303030303) * t6;
  const Scalar t11 = t10 - t9 + Scalar(4.654545454545454) * t8;
  const Scalar t12 = c_5 * t5 + s_5 * t11;
  const Scalar t13 = t2 + Scalar(3.83030303030303) * t3;
  const Scalar t14 = omega_4_z + t13;
  const Scalar t15 = c_6 * t12 - s_6 * t14;
  const Scalar t16 = c_5 * t8 + s_5 * omega_4_z;
  const Scalar omega_5_z = qd_5 + t9;
  const Scalar omega_r_6_y = c_6 * omega_5_z + s_6 * t16;
  const Scalar t17 = c_5 * t11 - s_5 * t5;
  const Scalar t18 = Scalar(1.0666666666666667) * omega_r_6_y + t17;
  const Scalar t19 = c_7 * t15 - s_7 * t18;
  const Scalar t20 = c_7 * t18 + s_7 * t15;
  const Scalar t21 = c_6 * t16 - s_6 * omega_5_z;
  const Scalar omega_r_6_a_z = c_5 * omega_4_z - s_5 * t8;
  const Scalar omega_6_z = qd_6 + omega_r_6_a_z;
  const Scalar t22 = c_7 * t21 - s_7 * omega_6_z;
  const Scalar t23 = c_7 * omega_6_z + s_7 * t21;
  const Scalar omega_7_z = qd_7 - omega_r_6_y;
  const Scalar t24 = Scalar(0.0009653051699191118) * t22 - Scalar(0.0012555365982728983) * t23 -
      Scalar(0.0003356825931791965) * t19 - Scalar(0.0004246448862708035) * t20 +
      Scalar(0.006684151967360946) * omega_7_z;
  const Scalar t25 = c_6 * t14 + s_6 * t12;
  const Scalar t26 = t25 - Scalar(1.0666666666666667) * omega_6_z;
  const Scalar t27 = Scalar(0.000391391281684248) * t23 + Scalar(0.0003356825931791965) * t26 -
      Scalar(0.0009653051699191118) * omega_7_z - Scalar(0.00242094377852123) * t22;
  const Scalar t28 = t23 * (Scalar(0.000391391281684248) * t22 +
      Scalar(0.0004246448862708035) * t26 + Scalar(0.0012555365982728983) * omega_7_z);
  const Scalar t29 = Scalar(0.000103758917218685) * t21 +
      Scalar(0.000093569097314605) * omega_r_6_y + Scalar(0.05258828201066731) * omega_6_z +
      Scalar(0.028677776418885) * t15 - Scalar(0.038254846194675) * t25;
  const Scalar t30 = Scalar(0.014748570382675316) * omega_r_6_y -
      Scalar(0.000103758917218685) * omega_6_z - Scalar(0.009543771269492195) * t21 +
      Scalar(0.028677776418885) * t17;
  const Scalar t31 = omega_r_6_y *
      (Scalar(0.000093569097314605) * omega_6_z - Scalar(0.014748570382675316) * t21 +
      Scalar(0.038254846194675) * t17);
  const Scalar L_5_z = Scalar(0.004600245517563106) * t16 -
      Scalar(0.00216405205209813) * omega_r_6_a_z - Scalar(0.00241786586877) * t17 -
      Scalar(0.011198654185125) * t12 + Scalar(0.033018599263935515) * omega_5_z;
  const Scalar t32 = Scalar(0.004600245517563106) * omega_5_z -
      Scalar(0.00151524447332703) * omega_r_6_a_z + Scalar(0.011198654185125) * t14 +
      Scalar(0.030116287133882085) * t16;
  const Scalar t33 = omega_r_6_a_z *
      (Scalar(-0.00151524447332703) * t16 - Scalar(0.00216405205209813) * omega_5_z +
      Scalar(0.00241786586877) * t14);
  const Scalar t34 = Scalar(-0.0039053550262761) * omega_4_z - Scalar(0.16284087268546085) * t9 +
      Scalar(0.332066386344495) * t10 + Scalar(0.647723094939183) * t8;
  const Scalar t35 = t9 * (Scalar(0.00164448757736927) * omega_4_z +
      Scalar(0.09120874531725) * t10 + Scalar(0.16284087268546085) * t8);
  const Scalar t36 = Scalar(0.00164448757736927) * t9 + Scalar(0.0039053550262761) * t8 -
      Scalar(0.09120874531725) * t13 + Scalar(0.332066386344495) * t4 -
      Scalar(0.749763367252814) * omega_4_z;
  const Scalar L_2_x = Scalar(0.00398335888393552) * t7 + Scalar(0.01026110182100817) * qd_2 -
      Scalar(1.0706865997634767) * t1;
  const Scalar L_2_y = Scalar(0.0007689361029464) * qd_2 + Scalar(0.00398335888393552) * t1;
  const Scalar t37 = qd_1 * (Scalar(0.03733744848940618) * qd_1 - (c_2 * L_2_y + s_2 * L_2_x));
  const Scalar t38 = t6 * (Scalar(0.000121912420950744) * omega_r_3_y +
      Scalar(0.01159586409516604) * t6 + Scalar(0.005487648106562256) * omega_3_z);
  const Scalar t39 = omega_r_3_y *
      (Scalar(0.000121912420950744) * t6 - Scalar(0.004377257121839584) * omega_3_z);
  const Scalar t40 = omega_3_z * (Scalar(0.13480070614822143) * omega_3_z -
      Scalar(0.022216781084735585) * omega_r_3_y + Scalar(0.47750187874566624) * t6);
  const Scalar L_2_z = Scalar(-0.0007689361029464) * t7 - Scalar(0.01026110182100817) * t1 +
      Scalar(1.1168423647533403) * qd_2;
  const Scalar t41 = t39 - t22 * t27 - t28 + t38 + t33 + omega_7_z * t24 + t16 * t32 +
      omega_5_z * L_5_z - t35 - t21 * t30 + t31 + omega_6_z * t29 + t37 + t40 + qd_2 * L_2_z +
      t8 * t34 - omega_4_z * t36;
  return Scalar(0.5) * t41;
}

// Potential energy of links and rotors (7.36).
//   q[7]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[1..6]. Operations: 21 mul, 20 add, 12 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar potential_energy(const Scalar* q, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
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
  static_assert(detail::Interface::checked<Scalar>());
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
  static_assert(detail::Interface::checked<Scalar>());
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
  const Scalar z_4_x = s_3 * t2 + t3;
  J[24] = z_4_x;
  const Scalar t4 = s_1 * s_3;
  const Scalar J_54 = c_2 * t4 - c_1 * c_3;
  J[31] = J_54;
  const Scalar t5 = s_2 * c_3;
  const Scalar R_42_y = s_4 * t5 + c_2 * c_4;
  J[39] = R_42_y;
  const Scalar t6 = c_3 * t2 - t4;
  const Scalar t7 = s_4 * t6 - c_4 * z_3_x;
  J[25] = -t7;
  const Scalar R_31_x = c_2 * t3 + c_1 * s_3;
  const Scalar t8 = s_4 * R_31_x - c_4 * z_3_y;
  J[32] = -t8;
  const Scalar t9 = c_4 * t5 - c_2 * s_4;
  const Scalar R_52_y = s_5 * t9 + c_5 * t1;
  J[40] = -R_52_y;
  const Scalar t10 = s_4 * z_3_x + c_4 * t6;
  const Scalar z_6_x = s_5 * t10 + c_5 * z_4_x;
  J[26] = z_6_x;
  const Scalar R_41_x = s_4 * z_3_y + c_4 * R_31_x;
  const Scalar J_56 = s_5 * R_41_x + c_5 * J_54;
  J[33] = J_56;
  const Scalar R_52_x = s_5 * t1 - c_5 * t9;
  const Scalar J_67 = s_6 * R_52_x - c_6 * R_42_y;
  J[41] = J_67;
  const Scalar p_6u_t_x = Scalar(0.088) * c_6 + Scalar(0.2104) * s_6;
  const Scalar p_5_x = c_5 * p_6u_t_x - Scalar(0.0825);
  const Scalar t11 = Scalar(0.2104) * c_6 - Scalar(0.088) * s_6 - Scalar(0.384);
  const Scalar p_4_x = c_4 * p_5_x + Scalar(0.0825) + s_4 * t11;
  const Scalar t12 = s_5 * p_6u_t_x;
  const Scalar t13 = s_3 * t12 - c_3 * p_4_x;
  const Scalar t14 = s_4 * p_5_x - c_4 * t11 + Scalar(0.316);
  const Scalar t15 = s_2 * t13 + c_2 * t14;
  J[1] = c_1 * t15;
  J[8] = s_1 * t15;
  const Scalar t16 = s_5 * z_4_x - c_5 * t10;
  const Scalar R_60_y = s_6 * t16 - c_6 * t7;
  J[27] = -R_60_y;
  const Scalar t17 = s_5 * J_54 - c_5 * R_41_x;
  const Scalar R_61_y = s_6 * t17 - c_6 * t8;
  J[34] = -R_61_y;
  const Scalar p_2u_t_x = s_2 * t14 - c_2 * t13;
  const Scalar p_3u_t_y = c_3 * t12 + s_3 * p_4_x;
  const Scalar t18 = s_1 * p_3u_t_y - c_1 * p_2u_t_x;
  J[7] = -t18;
  const Scalar p_1u_t_y = s_1 * p_2u_t_x + c_1 * p_3u_t_y;
  J[0] = -p_1u_t_y;
  J[15] = c_1 * t18 - s_1 * p_1u_t_y;
  const Scalar t19 = Scalar(0.316) * z_3_x + t18;
  const Scalar t20 = Scalar(0.316) * c_2 - t15;
  J[9] = z_3_x * t20 - c_2 * t19;
  const Scalar r_3_y = p_1u_t_y - Scalar(0.316) * z_3_y;
  J[2] = -z_3_y * t20 - c_2 * r_3_y;
  J[16] = s_2 * (s_1 * t19 + c_1 * r_3_y);
  const Scalar r_4_y = r_3_y - Scalar(0.0825) * R_31_x;
  const Scalar t21 = t20 - Scalar(0.0825) * t5;
  J[3] = t1 * r_4_y - J_54 * t21;
  const Scalar t22 = Scalar(0.0825) * t6 + t19;
  J[10] = t1 * t22 + z_4_x * t21;
  J[17] = J_54 * t22 + z_4_x * r_4_y;
  const Scalar t23 = Scalar(-0.0825) * t10 - Scalar(0.384) * t7 + t22;
  const Scalar t24 = Scalar(0.0825) * t9 + Scalar(0.384) * R_42_y + t21;
  J[12] = t23 * R_52_y + t24 * z_6_x;
  const Scalar r_5_y = Scalar(0.0825) * R_41_x + Scalar(0.384) * t8 + r_4_y;
  J[19] = r_5_y * z_6_x + t23 * J_56;
  J[4] = t8 * t24 - R_42_y * r_5_y;
  J[11] = -R_42_y * t23 - t7 * t24;
  J[18] = -t8 * t23 - t7 * r_5_y;
  J[5] = r_5_y * R_52_y - t24 * J_56;
  const Scalar r_7_y = Scalar(0.088) * (s_6 * t8 + c_6 * t17) + r_5_y;
  const Scalar R_62_x = s_6 * R_42_y + c_6 * R_52_x;
  const Scalar t25 = Scalar(0.088) * R_62_x + t24;
  J[6] = R_61_y * t25 - J_67 * r_7_y;
  const Scalar t26 = t23 - Scalar(0.088) * (s_6 * t7 + c_6 * t16);
  J[13] = -J_67 * t26 - R_60_y * t25;
  J[20] = -R_61_y * t26 - R_60_y * r_7_y;
  J[35] = Scalar(1.0);
  J[14] = J[21] = J[28] = J[36] = Scalar(0.0);
}

// (dJ/dt) qd of the tip.
//   q[7]   in   joint positions, rad or m
//   qd[7]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads q[0..6], qd[0..6]. Operations: 186 mul, 121 add, 14 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
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
  const Scalar t12 = qd_7 * (s_7 * omega_6_z + c_7 * t11);
  const Scalar omega_r_6_y = s_6 * t9 + c_6 * omega_5_z;
  const Scalar t13 = t8 * t5 - qd_3 * omega_r_3_y;
  const Scalar t14 = qd_2 * t1;
  const Scalar t15 = s_4 * t14 + c_4 * t13 + qd_4 * t10;
  const Scalar domega_q_3_y = t3 * t5 - qd_3 * t4;
  const Scalar t16 = qd_5 * omega_r_6_a_z - s_5 * domega_q_3_y + c_5 * t15;
  const Scalar t17 = c_4 * t14 - s_4 * t13 + qd_4 * t6;
  const Scalar t18 = qd_6 * omega_r_6_y - s_6 * t17 - c_6 * t16;
  const Scalar domega_q_5_y = c_5 * domega_q_3_y + qd_5 * t9 + s_5 * t15;
  const Scalar t19 = t12 + s_7 * t18 + c_7 * domega_q_5_y;
  const Scalar t20 = qd_7 * (s_7 * t11 - c_7 * omega_6_z);
  const Scalar t21 = t20 + s_7 * domega_q_5_y - c_7 * t18;
  const Scalar t22 = s_7 * t19 - c_7 * t21;
  const Scalar domega_f_7_a_z = qd_6 * t11 - s_6 * t16 + c_6 * t17;
  const Scalar t23 = s_6 * domega_f_7_a_z + c_6 * t22;
  const Scalar domega_e_6_a_y = s_7 * t21 + c_7 * t19;
  const Scalar t24 = s_5 * domega_e_6_a_y - c_5 * t23;
  const Scalar t25 = s_6 * t22 - c_6 * domega_f_7_a_z;
  const Scalar t26 = s_4 * t25 + c_4 * t24;
  const Scalar domega_e_5_t_y = s_5 * t23 + c_5 * domega_e_6_a_y;
  const Scalar t27 = s_3 * domega_e_5_t_y + c_3 * t26;
  const Scalar domega_e_3_a_y = s_4 * t24 - c_4 * t25;
  a[5] = s_2 * t27 - c_2 * domega_e_3_a_y;
  const Scalar t28 = s_2 * domega_e_3_a_y + c_2 * t27;
  const Scalar t29 = s_3 * t26 - c_3 * domega_e_5_t_y;
  a[3] = s_1 * t29 - c_1 * t28;
  const Scalar t30 = t6 * omega_4_z;
  const Scalar t31 = t5 * (t7 + Scalar(2.0) * t8);
  const Scalar t32 = Scalar(2.0) * omega_r_3_y * omega_3_z - t31;
  const Scalar t33 = t4 * omega_r_3_y;
  const Scalar U_3_xy = t33 + t14;
  const Scalar t34 = c_4 * U_3_xy + t30 + s_4 * t32;
  const Scalar t35 = (t33 - t14) + (t30 + t34);
  const Scalar t36 = s_4 * U_3_xy - c_4 * t32 + Scalar(2.0) * t10 * omega_4_z;
  const Scalar t37 = Scalar(0.316) * t31 + Scalar(0.0825) * t35 + Scalar(0.384) * t36;
  const Scalar t38 = t4 * omega_3_z;
  const Scalar t39 = t5 * (Scalar(2.0) * t3 - t2);
  const Scalar domega_r_4_z = t38 - t39;
  const Scalar Uz_o_3_y = t1 * t1 + qd_2 * qd_2;
  const Scalar t40 = Scalar(0.316) * Uz_o_3_y - Scalar(0.0825) * (t38 + domega_r_4_z);
  const Scalar t41 = t6 * t6;
  const Scalar t42 = omega_4_z * omega_4_z;
  const Scalar t43 = t4 * t4;
  const Scalar t44 = omega_3_z * omega_3_z;
  const Scalar t45 = t43 + t44 + t42 - t41;
  const Scalar t46 = t6 * t10;
  const Scalar t47 = domega_r_4_z + t46;
  const Scalar t48 = Scalar(0.316) * t39 - Scalar(0.0825) * (Uz_o_3_y - t43 + t44);
  const Scalar ddp_o_5_x = Scalar(0.0825) * t45 - s_4 * t40 + c_4 * t48 - Scalar(0.384) * t47;
  const Scalar ddp_5_x = c_5 * ddp_o_5_x + s_5 * t37;
  const Scalar t49 = t11 * t11;
  const Scalar t50 = omega_6_z * omega_6_z;
  const Scalar t51 = t9 * t9 - t49 + t50 + omega_5_z * omega_5_z;
  const Scalar U_4_yx = domega_r_4_z - t46;
  const Scalar t52 = Scalar(0.0825) * U_4_yx + s_4 * t48 + c_4 * t40 + Scalar(0.384) * (t42 + t41);
  const Scalar t53 = Scalar(0.088) * t51 + s_6 * t52 - c_6 * ddp_5_x;
  const Scalar t54 = t11 * omega_r_6_y;
  const Scalar t55 = t9 * omega_5_z - c_5 * t47 + s_5 * t36;
  const Scalar t56 = t54 + t55;
  const Scalar t57 = Scalar(2.0) * omega_6_z;
  const Scalar U_5_xy = t9 * omega_r_6_a_z + t34;
  const Scalar Uz_o_6_z = s_5 * t47 + Scalar(2.0) * omega_r_6_a_z * omega_5_z + c_5 * t36;
  const Scalar t58 = -s_6 * U_5_xy - c_6 * Uz_o_6_z + omega_r_6_y * t57;
  const Scalar t59 = s_7 * t56 - c_7 * t58;
  const Scalar t60 = c_6 * U_5_xy - s_6 * Uz_o_6_z + t11 * t57;
  const Scalar t61 = Scalar(0.088) * t60 + s_5 * ddp_o_5_x - c_5 * t37;
  const Scalar t62 = s_7 * t53 + c_7 * t61 + Scalar(0.2104) * t59;
  const Scalar t63 = c_7 * t56 + s_7 * t58;
  const Scalar t64 = c_7 * t53 - s_7 * t61 + Scalar(0.2104) * t63;
  const Scalar t65 = s_7 * t62 + c_7 * t64;
  const Scalar Uz_o_7_y = t49 + t50;
  const Scalar t66 = Scalar(0.088) * (t55 - t54) - Scalar(0.2104) * Uz_o_7_y + s_6 * ddp_5_x +
      c_6 * t52;
  const Scalar a_6_t_x = s_6 * t66 - c_6 * t65;
  const Scalar t67 = s_7 * t64 - c_7 * t62;
  const Scalar t68 = s_5 * t67 - c_5 * a_6_t_x;
  const Scalar t69 = c_6 * t66 + s_6 * t65;
  const Scalar a_4_t_x = s_4 * t69 - c_4 * t68;
  const Scalar t70 = s_5 * a_6_t_x + c_5 * t67;
  const Scalar t71 = s_3 * t70 - c_3 * a_4_t_x;
  const Scalar t72 = s_4 * t68 + c_4 * t69;
  a[2] = s_2 * t71 - c_2 * t72;
  a[4] = -s_1 * t28 - c_1 * t29;
  const Scalar t73 = s_2 * t72 + c_2 * t71;
  const Scalar t74 = s_3 * a_4_t_x + c_3 * t70;
  a[0] = -s_1 * t74 - c_1 * t73;
  a[1] = c_1 * t74 - s_1 * t73;
}

// The functions by type, with the shapes of their arguments: what adapters such as
// flatdyn/eigen.hpp are given.
namespace functions {

struct inverse_dynamics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[7], const Scalar (&qd)[7], const Scalar (&qdd)[7],
      Scalar (&tau)[7]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::panda::inverse_dynamics(of...); }
};

struct inverse_dynamics_tip_force {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[7], const Scalar (&qd)[7], const Scalar (&qdd)[7],
      const Scalar (&h_e)[6], Scalar (&tau)[7]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::panda::inverse_dynamics_tip_force(of...); }
};

struct inertia_matrix {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[7], Scalar (&B)[7][7]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::panda::inertia_matrix(of...); }
};

struct christoffel {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[7], Scalar (&c)[7][28]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::panda::christoffel(of...); }
};

struct coriolis_matrix {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[7], const Scalar (&qd)[7], Scalar (&C)[7][7]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::panda::coriolis_matrix(of...); }
};

struct gravity {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[7], Scalar (&g)[7]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::panda::gravity(of...); }
};

struct bias {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[7], const Scalar (&qd)[7], Scalar (&n)[7]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::panda::bias(of...); }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[7], const Scalar (&qd)[7], const Scalar (&tau)[7],
      Scalar (&qdd)[7]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::panda::forward_dynamics(of...); }
};

struct kinetic_energy {
  template <class Scalar>
  using Shape = Scalar(const Scalar (&q)[7], const Scalar (&qd)[7]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::panda::kinetic_energy(of...); }
};

struct potential_energy {
  template <class Scalar>
  using Shape = Scalar(const Scalar (&q)[7]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::panda::potential_energy(of...); }
};

struct forward_kinematics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[7], Scalar (&R)[3][3], Scalar (&p)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::panda::forward_kinematics(of...); }
};

struct jacobian {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[7], Scalar (&J)[6][7]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::panda::jacobian(of...); }
};

struct jacobian_dot_qd {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[7], const Scalar (&qd)[7], Scalar (&a)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::panda::jacobian_dot_qd(of...); }
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

}  // namespace panda

#endif  // FLATDYN_PANDA_HPP_118E1594

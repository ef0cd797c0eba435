// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "quadruped12" as flat code: 12 joints.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Input: sha1:e2173ac6ded93ccd954eacf2a9e9318d33ff076c
//
//   index  joint   moves link    type      unit  lower  upper  speed  effort
//   0      FL_HAA  FL_SHOULDER   revolute  rad   -1.2   1.2    30     2.7
//   1      FL_HFE  FL_UPPER_LEG  revolute  rad   -1.7   1.7    30     2.7
//   2      FL_KFE  FL_LOWER_LEG  revolute  rad   -3.4   3.4    30     2.7
//   3      FR_HAA  FR_SHOULDER   revolute  rad   -1.2   1.2    30     2.7
//   4      FR_HFE  FR_UPPER_LEG  revolute  rad   -1.7   1.7    30     2.7
//   5      FR_KFE  FR_LOWER_LEG  revolute  rad   -3.4   3.4    30     2.7
//   6      HL_HAA  HL_SHOULDER   revolute  rad   -1.2   1.2    30     2.7
//   7      HL_HFE  HL_UPPER_LEG  revolute  rad   -1.7   1.7    30     2.7
//   8      HL_KFE  HL_LOWER_LEG  revolute  rad   -3.4   3.4    30     2.7
//   9      HR_HAA  HR_SHOULDER   revolute  rad   -1.2   1.2    30     2.7
//   10     HR_HFE  HR_UPPER_LEG  revolute  rad   -1.7   1.7    30     2.7
//   11     HR_KFE  HR_LOWER_LEG  revolute  rad   -3.4   3.4    30     2.7
//
// Gravity is (0, 0, -9.81) m/s^2 in the base frame. The tip belongs to link "HR_FOOT". Links
// without a joint of their own, part of those that carry them: FL_FOOT, FR_FOOT, HL_FOOT, HR_FOOT.
//
// Every function is a template over its scalar: float, double, or any type that is made from a
// double, has + - * / (also - of one), comparisons, and sin, cos where argument-dependent lookup
// finds them (or an argument that knows them, see LibrarySinCos). Arguments are plain arrays:
//
//   double q[12] = {}, qd[12] = {}, qdd[12] = {}, tau[12];
//   quadruped12::inverse_dynamics(q, qd, qdd, tau);
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

#ifndef FLATDYN_QUADRUPED12_HPP_21DA106A
#define FLATDYN_QUADRUPED12_HPP_21DA106A

#include <cmath>

namespace quadruped12 {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 12;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {
    "FL_HAA", "FL_HFE", "FL_KFE", "FR_HAA", "FR_HFE", "FR_KFE", "HL_HAA", "HL_HFE", "HL_KFE",
    "HR_HAA", "HR_HFE", "HR_KFE"};

// Smallest position, rad or m.
inline constexpr Real position_lower[joint_count] = {
    Real(-1.2), Real(-1.7), Real(-3.4), Real(-1.2), Real(-1.7), Real(-3.4), Real(-1.2), Real(-1.7),
    Real(-3.4), Real(-1.2), Real(-1.7), Real(-3.4)};

// Largest position, rad or m.
inline constexpr Real position_upper[joint_count] = {
    Real(1.2), Real(1.7), Real(3.4), Real(1.2), Real(1.7), Real(3.4), Real(1.2), Real(1.7),
    Real(3.4), Real(1.2), Real(1.7), Real(3.4)};

// Largest speed, rad/s or m/s.
inline constexpr Real velocity_limit[joint_count] = {
    Real(30.0), Real(30.0), Real(30.0), Real(30.0), Real(30.0), Real(30.0), Real(30.0), Real(30.0),
    Real(30.0), Real(30.0), Real(30.0), Real(30.0)};

// Largest torque or force, N m or N.
inline constexpr Real effort_limit[joint_count] = {
    Real(2.7), Real(2.7), Real(2.7), Real(2.7), Real(2.7), Real(2.7), Real(2.7), Real(2.7),
    Real(2.7), Real(2.7), Real(2.7), Real(2.7)};

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
//   q[12]    in   joint positions, rad or m
//   qd[12]   in   joint velocities, rad/s or m/s
//   qdd[12]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[12]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11], qd[0..11], qdd[0..11]. Operations: 272 mul, 168 add, 24 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5], qdd_7 = qdd[6], qdd_8 = qdd[7], qdd_9 = qdd[8], qdd_10 = qdd[9],
      qdd_11 = qdd[10], qdd_12 = qdd[11];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6], s_8 = sine[7],
      c_8 = cosine[7], s_9 = sine[8], c_9 = cosine[8], s_10 = sine[9], c_10 = cosine[9],
      s_11 = sine[10], c_11 = cosine[10], s_12 = sine[11], c_12 = cosine[11];
  const Scalar t1 = qd_1 * qd_1;
  const Scalar t2 = qd_2 * qd_2;
  const Scalar c_2_3 = c_2 * s_3 + s_2 * c_3;
  const Scalar t3 = c_2_3 * (s_2 * qdd_2 + c_2 * (t1 + t2) + Scalar(61.3125) * c_1);
  const Scalar t4 = c_2 * c_3 - s_2 * s_3;
  const Scalar t5 = t4 * (c_2 * qdd_2 - s_2 * t2) + t3;
  const Scalar t6 = c_2_3 * (qdd_1 + Scalar(2.3310271737123758) * t4 * t1);
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar N_3_z = Scalar(0.00023148988883634047) * t6 +
      Scalar(0.0005426192213171668) * domega_3_z + Scalar(0.000615720268358608) * t5;
  tau[2] = N_3_z;
  const Scalar t7 = qd_4 * qd_4;
  const Scalar t8 = qd_5 * qd_5;
  const Scalar c_5_6 = c_5 * s_6 + s_5 * c_6;
  const Scalar t9 = c_5_6 * (s_5 * qdd_5 + c_5 * (t7 + t8) + Scalar(61.3125) * c_4);
  const Scalar t10 = c_5 * c_6 - s_5 * s_6;
  const Scalar t11 = t10 * (c_5 * qdd_5 - s_5 * t8) + t9;
  const Scalar t12 = c_5_6 * (qdd_4 - Scalar(2.3310271737123758) * t10 * t7);
  const Scalar domega_6_z = qdd_5 + qdd_6;
  const Scalar N_6_z = Scalar(0.0005426192213171668) * domega_6_z -
      Scalar(0.00023148988883634047) * t12 + Scalar(0.000615720268358608) * t11;
  tau[5] = N_6_z;
  const Scalar t13 = qd_7 * qd_7;
  const Scalar t14 = qd_8 * qd_8;
  const Scalar c_8_9 = c_8 * s_9 + s_8 * c_9;
  const Scalar t15 = c_8_9 * (s_8 * qdd_8 + c_8 * (t13 + t14) + Scalar(61.3125) * c_7);
  const Scalar t16 = c_8 * c_9 - s_8 * s_9;
  const Scalar t17 = t16 * (c_8 * qdd_8 - s_8 * t14) + t15;
  const Scalar t18 = c_8_9 * (qdd_7 + Scalar(2.3310271737123758) * t16 * t13);
  const Scalar domega_9_z = qdd_8 + qdd_9;
  const Scalar N_9_z = Scalar(0.00023148988883634047) * t18 +
      Scalar(0.0005426192213171668) * domega_9_z + Scalar(0.000615720268358608) * t17;
  tau[8] = N_9_z;
  const Scalar t19 = qd_10 * qd_10;
  const Scalar t20 = qd_11 * qd_11;
  const Scalar c_11_12 = c_11 * s_12 + s_11 * c_12;
  const Scalar t21 = c_11_12 * (s_11 * qdd_11 + c_11 * (t19 + t20) + Scalar(61.3125) * c_10);
  const Scalar t22 = c_11 * c_12 - s_11 * s_12;
  const Scalar t23 = t22 * (c_11 * qdd_11 - s_11 * t20) + t21;
  const Scalar t24 = c_11_12 * (qdd_10 - Scalar(2.3310271737123758) * t22 * t19);
  const Scalar domega_12_z = qdd_11 + qdd_12;
  const Scalar N_12_z = Scalar(0.0005426192213171668) * domega_12_z -
      Scalar(0.00023148988883634047) * t24 + Scalar(0.000615720268358608) * t23;
  tau[11] = N_12_z;
  const Scalar omega_12_z = qd_11 + qd_12;
  const Scalar t25 = c_11_12 * omega_12_z;
  const Scalar t26 = c_11 * (t22 * domega_12_z - omega_12_z * t25);
  const Scalar t27 = omega_12_z * omega_12_z;
  const Scalar t28 = c_11_12 * domega_12_z;
  const Scalar t29 = t26 + s_11 * (t22 * (t19 + t27) + t28);
  const Scalar I_t11_g = Scalar(3.21970574695491e-07) * c_11 + Scalar(0.0022644781431582876) * s_11;
  const Scalar t30 = c_11 * I_t11_g - Scalar(1.609852873477455e-07);
  const Scalar mr_11_y = c_11 + Scalar(8659.923823660012) * s_11;
  const Scalar I_11_yz = Scalar(6.823068516838894e-08) * c_11 +
      Scalar(0.0007940924716883453) * s_11;
  tau[10] = Scalar(0.000615720268358608) * t29 - qdd_10 * I_11_yz + t19 * t30 +
      Scalar(0.0022955781994879005) * qdd_11 + N_12_z +
      Scalar(0.000020065123418265) * c_10 * mr_11_y;
  const Scalar omega_9_z = qd_8 + qd_9;
  const Scalar t31 = c_8_9 * omega_9_z;
  const Scalar t32 = c_8 * (t16 * domega_9_z - omega_9_z * t31);
  const Scalar t33 = omega_9_z * omega_9_z;
  const Scalar t34 = c_8_9 * domega_9_z;
  const Scalar t35 = t32 + s_8 * (t16 * (t13 + t33) + t34);
  const Scalar t36 = Scalar(3.21970574695491e-07) * c_8 - Scalar(0.0022644781431582876) * s_8;
  const Scalar I_8_xy = c_8 * t36 - Scalar(1.609852873477455e-07);
  const Scalar t37 = c_7 * (c_8 - Scalar(8659.923823660012) * s_8);
  const Scalar I_8_yz = Scalar(6.823068516838894e-08) * c_8 - Scalar(0.0007940924716883453) * s_8;
  tau[7] = Scalar(0.000615720268358608) * t35 - qdd_7 * I_8_yz - t13 * I_8_xy +
      Scalar(0.0022955781994879005) * qdd_8 + N_9_z - Scalar(0.000020065123418265) * t37;
  const Scalar t38 = qd_7 * t31;
  const Scalar t39 = t33 + Scalar(2.6598149554338075) * c_8 * qdd_7 -
      Scalar(4.6620543474247516) * t38 - Scalar(5.319629910867615) * s_8 * qd_7 * qd_8 +
      Scalar(163.07990445503535) * s_7;
  const Scalar t40 = qd_8 * (Scalar(6.823068516838894e-08) * s_8 +
      Scalar(0.0007940924716883453) * c_8) + Scalar(2.0) * qd_7 * I_8_xy;
  const Scalar t41 = c_8 * (Scalar(0.000615720268358608) * t16 * qdd_7 -
      Scalar(0.001231440536717216) * t38);
  const Scalar t42 = qdd_7 * (Scalar(0.0005396092213171668) * c_8_9 * c_8_9 - s_8 * t36 -
      Scalar(0.0031799702681776175));
  const Scalar mr_8_x = Scalar(0.00011547445686160344) * s_8 + c_8;
  tau[6] = t41 - qdd_8 * I_8_yz + Scalar(0.00023148988883634047) * (t34 + t16 * t39) + qd_8 * t40 +
      Scalar(0.08509272390476785) * c_7 - t42 + Scalar(0.1737624403145115) * s_7 * mr_8_x;
  const Scalar omega_6_z = qd_5 + qd_6;
  const Scalar t43 = c_5_6 * omega_6_z;
  const Scalar t44 = c_5 * (t10 * domega_6_z - omega_6_z * t43);
  const Scalar t45 = omega_6_z * omega_6_z;
  const Scalar t46 = c_5_6 * domega_6_z;
  const Scalar t47 = t44 + s_5 * (t10 * (t7 + t45) + t46);
  const Scalar I_t5_g = Scalar(3.21970574695491e-07) * c_5 + Scalar(0.0022644781431582876) * s_5;
  const Scalar t48 = c_5 * I_t5_g - Scalar(1.609852873477455e-07);
  const Scalar mr_5_y = c_5 + Scalar(8659.923823660012) * s_5;
  const Scalar I_5_yz = Scalar(6.823068516838894e-08) * c_5 + Scalar(0.0007940924716883453) * s_5;
  tau[4] = Scalar(0.000615720268358608) * t47 - qdd_4 * I_5_yz + t7 * t48 +
      Scalar(0.0022955781994879005) * qdd_5 + N_6_z + Scalar(0.000020065123418265) * c_4 * mr_5_y;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t49 = c_2_3 * omega_3_z;
  const Scalar t50 = c_2 * (t4 * domega_3_z - omega_3_z * t49);
  const Scalar t51 = omega_3_z * omega_3_z;
  const Scalar t52 = c_2_3 * domega_3_z;
  const Scalar t53 = t50 + s_2 * (t4 * (t1 + t51) + t52);
  const Scalar t54 = Scalar(3.21970574695491e-07) * c_2 - Scalar(0.0022644781431582876) * s_2;
  const Scalar I_2_xy = c_2 * t54 - Scalar(1.609852873477455e-07);
  const Scalar t55 = c_1 * (c_2 - Scalar(8659.923823660012) * s_2);
  const Scalar I_2_yz = Scalar(6.823068516838894e-08) * c_2 - Scalar(0.0007940924716883453) * s_2;
  tau[1] = Scalar(0.000615720268358608) * t53 - qdd_1 * I_2_yz - t1 * I_2_xy +
      Scalar(0.0022955781994879005) * qdd_2 + N_3_z - Scalar(0.000020065123418265) * t55;
  const Scalar t56 = qd_1 * t49;
  const Scalar t57 = t51 + Scalar(2.6598149554338075) * c_2 * qdd_1 -
      Scalar(4.6620543474247516) * t56 - Scalar(5.319629910867615) * s_2 * qd_1 * qd_2 +
      Scalar(163.07990445503535) * s_1;
  const Scalar t58 = qd_2 * (Scalar(6.823068516838894e-08) * s_2 +
      Scalar(0.0007940924716883453) * c_2) + Scalar(2.0) * qd_1 * I_2_xy;
  const Scalar t59 = c_2 * (Scalar(0.000615720268358608) * t4 * qdd_1 -
      Scalar(0.001231440536717216) * t56);
  const Scalar t60 = qdd_1 * (Scalar(0.0005396092213171668) * c_2_3 * c_2_3 - s_2 * t54 -
      Scalar(0.0031799702681776175));
  const Scalar mr_2_x = Scalar(0.00011547445686160344) * s_2 + c_2;
  tau[0] = t59 - qdd_2 * I_2_yz + Scalar(0.00023148988883634047) * (t52 + t4 * t57) + qd_2 * t58 +
      Scalar(0.08509272390476785) * c_1 - t60 + Scalar(0.1737624403145115) * s_1 * mr_2_x;
  const Scalar t61 = qd_10 * t25;
  const Scalar t62 = Scalar(2.6598149554338075) * c_11 * qdd_10 - t27 -
      Scalar(4.6620543474247516) * t61 - Scalar(5.319629910867615) * s_11 * qd_10 * qd_11 +
      Scalar(163.07990445503535) * s_10;
  const Scalar I_11_xz = Scalar(0.0007940924716883453) * c_11 -
      Scalar(6.823068516838894e-08) * s_11;
  const Scalar t63 = qd_11 * (qd_11 * I_11_xz + Scalar(2.0) * qd_10 * t30);
  const Scalar t64 = c_11 * (Scalar(0.000615720268358608) * t22 * qdd_10 -
      Scalar(0.001231440536717216) * t61);
  const Scalar t65 = qdd_10 * (Scalar(0.0005396092213171668) * c_11_12 * c_11_12 + s_11 * I_t11_g -
      Scalar(0.0031799702681776175));
  const Scalar mr_11_x = c_11 - Scalar(0.00011547445686160344) * s_11;
  const Scalar t66 = qdd_11 * I_11_yz - t64 + Scalar(0.00023148988883634047) * (t28 - t22 * t62) +
      t63 + Scalar(0.08509272390476785) * c_10 + t65 - Scalar(0.1737624403145115) * s_10 * mr_11_x;
  tau[9] = -t66;
  const Scalar t67 = qd_4 * t43;
  const Scalar t68 = Scalar(2.6598149554338075) * c_5 * qdd_4 - t45 -
      Scalar(4.6620543474247516) * t67 - Scalar(5.319629910867615) * s_5 * qd_4 * qd_5 +
      Scalar(163.07990445503535) * s_4;
  const Scalar I_5_xz = Scalar(0.0007940924716883453) * c_5 - Scalar(6.823068516838894e-08) * s_5;
  const Scalar t69 = qd_5 * (qd_5 * I_5_xz + Scalar(2.0) * qd_4 * t48);
  const Scalar t70 = c_5 * (Scalar(0.000615720268358608) * t10 * qdd_4 -
      Scalar(0.001231440536717216) * t67);
  const Scalar t71 = qdd_4 * (Scalar(0.0005396092213171668) * c_5_6 * c_5_6 + s_5 * I_t5_g -
      Scalar(0.0031799702681776175));
  const Scalar mr_5_x = c_5 - Scalar(0.00011547445686160344) * s_5;
  const Scalar t72 = qdd_5 * I_5_yz - t70 + Scalar(0.00023148988883634047) * (t46 - t10 * t68) +
      t69 + Scalar(0.08509272390476785) * c_4 + t71 - Scalar(0.1737624403145115) * s_4 * mr_5_x;
  tau[3] = -t72;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[12]    in   joint positions, rad or m
//   qd[12]   in   joint velocities, rad/s or m/s
//   qdd[12]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]   in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[12]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11], qd[0..11], qdd[0..11], h_e[0..5]. Operations: 295 mul, 188 add, 24 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics_tip_force(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    const Scalar* h_e, Scalar* tau, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1], qdd_3 = qdd[2], qdd_4 = qdd[3], qdd_5 = qdd[4],
      qdd_6 = qdd[5], qdd_7 = qdd[6], qdd_8 = qdd[7], qdd_9 = qdd[8], qdd_10 = qdd[9],
      qdd_11 = qdd[10], qdd_12 = qdd[11];
  const Scalar h_e_1 = h_e[0], h_e_2 = h_e[1], h_e_3 = h_e[2], h_e_4 = h_e[3], h_e_5 = h_e[4],
      h_e_6 = h_e[5];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6], s_8 = sine[7],
      c_8 = cosine[7], s_9 = sine[8], c_9 = cosine[8], s_10 = sine[9], c_10 = cosine[9],
      s_11 = sine[10], c_11 = cosine[10], s_12 = sine[11], c_12 = cosine[11];
  const Scalar t1 = qd_2 * qd_2;
  const Scalar t2 = qd_1 * qd_1;
  const Scalar t3 = s_2 * qdd_2 + c_2 * (t1 + t2);
  const Scalar t4 = s_2 * s_3 - c_2 * c_3;
  const Scalar t5 = Scalar(0.006131963366925577) * qdd_1 - Scalar(0.014293773236512354) * t4 * t2 +
      Scalar(0.0163098878695209) * t3 + c_1;
  const Scalar c_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t6 = t4 * (s_2 * t1 - c_2 * qdd_2);
  const Scalar domega_3_z = qdd_2 + qdd_3;
  const Scalar N_3_z = Scalar(0.0005426192213171668) * domega_3_z +
      Scalar(0.000615720268358608) * t6 + Scalar(0.037751348953737156) * c_2_3 * t5;
  tau[2] = N_3_z;
  const Scalar t7 = qd_5 * qd_5;
  const Scalar t8 = qd_4 * qd_4;
  const Scalar t9 = s_5 * qdd_5 + c_5 * (t7 + t8);
  const Scalar t10 = s_5 * s_6 - c_5 * c_6;
  const Scalar t11 = Scalar(-0.006131963366925577) * qdd_4 -
      Scalar(0.014293773236512354) * t10 * t8 + Scalar(0.0163098878695209) * t9 + c_4;
  const Scalar c_5_6 = s_5 * c_6 + c_5 * s_6;
  const Scalar t12 = t10 * (s_5 * t7 - c_5 * qdd_5);
  const Scalar domega_6_z = qdd_5 + qdd_6;
  const Scalar N_6_z = Scalar(0.0005426192213171668) * domega_6_z +
      Scalar(0.000615720268358608) * t12 + Scalar(0.037751348953737156) * c_5_6 * t11;
  tau[5] = N_6_z;
  const Scalar t13 = qd_8 * qd_8;
  const Scalar t14 = qd_7 * qd_7;
  const Scalar t15 = s_8 * qdd_8 + c_8 * (t13 + t14);
  const Scalar t16 = s_8 * s_9 - c_8 * c_9;
  const Scalar t17 = Scalar(0.006131963366925577) * qdd_7 -
      Scalar(0.014293773236512354) * t16 * t14 + Scalar(0.0163098878695209) * t15 + c_7;
  const Scalar c_8_9 = s_8 * c_9 + c_8 * s_9;
  const Scalar t18 = t16 * (s_8 * t13 - c_8 * qdd_8);
  const Scalar domega_9_z = qdd_8 + qdd_9;
  const Scalar N_9_z = Scalar(0.0005426192213171668) * domega_9_z +
      Scalar(0.000615720268358608) * t18 + Scalar(0.037751348953737156) * c_8_9 * t17;
  tau[8] = N_9_z;
  const Scalar t19 = s_11 * s_12 - c_11 * c_12;
  const Scalar t20 = qd_10 * qd_10;
  const Scalar t21 = t19 * t20;
  const Scalar c_11_12 = s_11 * c_12 + c_11 * s_12;
  const Scalar t22 = c_11_12 * t21;
  const Scalar domega_12_z = qdd_11 + qdd_12;
  const Scalar t23 = domega_12_z - t22;
  const Scalar U_12_yx = t22 + domega_12_z;
  const Scalar t24 = qd_11 * qd_11;
  const Scalar t25 = s_11 * qdd_11 + c_11 * (t24 + t20);
  const Scalar t26 = c_11_12 * (Scalar(2.6598149554338075) * t25 - qdd_10 +
      Scalar(163.07990445503535) * c_10);
  const Scalar t27 = s_10 * h_e_2 - c_10 * h_e_3;
  const Scalar t28 = t19 * h_e_1 - c_11_12 * t27;
  const Scalar t29 = t19 * (s_11 * t24 - c_11 * qdd_11);
  const Scalar mu_12_z = Scalar(1.505e-06) * U_12_yx + Scalar(0.000615720268358608) * t29 +
      Scalar(0.0005411142213171667) * t23 + Scalar(0.00023148988883634047) * t26 +
      Scalar(0.16) * t28 + s_10 * h_e_6 + c_10 * h_e_5;
  tau[11] = mu_12_z;
  const Scalar omega_9_z = qd_8 + qd_9;
  const Scalar t30 = c_8_9 * omega_9_z;
  const Scalar t31 = c_8_9 * domega_9_z;
  const Scalar t32 = omega_9_z * omega_9_z;
  const Scalar t33 = s_8 * (t31 - t16 * (t14 + t32));
  const Scalar t34 = t33 - c_8 * (omega_9_z * t30 + t16 * domega_9_z);
  const Scalar t35 = Scalar(3.21970574695491e-07) * c_8 - Scalar(0.0022644781431582876) * s_8;
  const Scalar I_8_xy = c_8 * t35 - Scalar(1.609852873477455e-07);
  const Scalar I_8_yz = Scalar(6.823068516838894e-08) * c_8 - Scalar(0.0007940924716883453) * s_8;
  const Scalar t36 = c_7 * (c_8 - Scalar(8659.923823660012) * s_8);
  tau[7] = Scalar(0.000615720268358608) * t34 - qdd_7 * I_8_yz - t14 * I_8_xy +
      Scalar(0.0022955781994879005) * qdd_8 + N_9_z - Scalar(0.000020065123418265) * t36;
  const Scalar t37 = qd_7 * t30;
  const Scalar t38 = t32 + Scalar(2.6598149554338075) * c_8 * qdd_7 -
      Scalar(4.6620543474247516) * t37 - Scalar(5.319629910867615) * s_8 * qd_7 * qd_8 +
      Scalar(163.07990445503535) * s_7;
  const Scalar t39 = c_8 * (Scalar(0.5) * t16 * qdd_7 + t37);
  const Scalar t40 = qd_8 * (Scalar(6.823068516838894e-08) * s_8 +
      Scalar(0.0007940924716883453) * c_8) + Scalar(2.0) * qd_7 * I_8_xy;
  const Scalar t41 = qdd_7 * (s_8 * t35 - Scalar(0.0005396092213171668) * c_8_9 * c_8_9 +
      Scalar(0.0031799702681776175));
  const Scalar mr_8_x = Scalar(0.00011547445686160344) * s_8 + c_8;
  tau[6] = -qdd_8 * I_8_yz - Scalar(0.001231440536717216) * t39 +
      Scalar(0.00023148988883634047) * (t31 - t16 * t38) + qd_8 * t40 +
      Scalar(0.08509272390476785) * c_7 + t41 + Scalar(0.1737624403145115) * s_7 * mr_8_x;
  const Scalar omega_6_z = qd_5 + qd_6;
  const Scalar t42 = c_5_6 * omega_6_z;
  const Scalar t43 = c_5_6 * domega_6_z;
  const Scalar t44 = omega_6_z * omega_6_z;
  const Scalar t45 = s_5 * (t43 - t10 * (t8 + t44));
  const Scalar t46 = t45 - c_5 * (omega_6_z * t42 + t10 * domega_6_z);
  const Scalar I_t5_g = Scalar(3.21970574695491e-07) * c_5 + Scalar(0.0022644781431582876) * s_5;
  const Scalar t47 = c_5 * I_t5_g - Scalar(1.609852873477455e-07);
  const Scalar I_5_yz = Scalar(6.823068516838894e-08) * c_5 + Scalar(0.0007940924716883453) * s_5;
  const Scalar mr_5_y = c_5 + Scalar(8659.923823660012) * s_5;
  tau[4] = Scalar(0.000615720268358608) * t46 - qdd_4 * I_5_yz + t8 * t47 +
      Scalar(0.0022955781994879005) * qdd_5 + N_6_z + Scalar(0.000020065123418265) * c_4 * mr_5_y;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t48 = c_2_3 * omega_3_z;
  const Scalar t49 = c_2_3 * domega_3_z;
  const Scalar t50 = omega_3_z * omega_3_z;
  const Scalar t51 = s_2 * (t49 - t4 * (t2 + t50));
  const Scalar t52 = t51 - c_2 * (omega_3_z * t48 + t4 * domega_3_z);
  const Scalar t53 = Scalar(3.21970574695491e-07) * c_2 - Scalar(0.0022644781431582876) * s_2;
  const Scalar I_2_xy = c_2 * t53 - Scalar(1.609852873477455e-07);
  const Scalar I_2_yz = Scalar(6.823068516838894e-08) * c_2 - Scalar(0.0007940924716883453) * s_2;
  const Scalar t54 = c_1 * (c_2 - Scalar(8659.923823660012) * s_2);
  tau[1] = Scalar(0.000615720268358608) * t52 - qdd_1 * I_2_yz - t2 * I_2_xy +
      Scalar(0.0022955781994879005) * qdd_2 + N_3_z - Scalar(0.000020065123418265) * t54;
  const Scalar t55 = qd_1 * t48;
  const Scalar t56 = t50 + Scalar(2.6598149554338075) * c_2 * qdd_1 -
      Scalar(4.6620543474247516) * t55 - Scalar(5.319629910867615) * s_2 * qd_1 * qd_2 +
      Scalar(163.07990445503535) * s_1;
  const Scalar t57 = c_2 * (Scalar(0.5) * t4 * qdd_1 + t55);
  const Scalar t58 = qd_2 * (Scalar(6.823068516838894e-08) * s_2 +
      Scalar(0.0007940924716883453) * c_2) + Scalar(2.0) * qd_1 * I_2_xy;
  const Scalar t59 = qdd_1 * (s_2 * t53 - Scalar(0.0005396092213171668) * c_2_3 * c_2_3 +
      Scalar(0.0031799702681776175));
  const Scalar mr_2_x = Scalar(0.00011547445686160344) * s_2 + c_2;
  tau[0] = -qdd_2 * I_2_yz - Scalar(0.001231440536717216) * t57 +
      Scalar(0.00023148988883634047) * (t49 - t4 * t56) + qd_2 * t58 +
      Scalar(0.08509272390476785) * c_1 + t59 + Scalar(0.1737624403145115) * s_1 * mr_2_x;
  const Scalar omega_12_z = qd_11 + qd_12;
  const Scalar t60 = t19 * t21 + omega_12_z * omega_12_z;
  const Scalar t61 = t19 * t27 + c_11_12 * h_e_1;
  const Scalar t62 = c_12 * (Scalar(0.0038482516772413) * t23 + t28) -
      s_12 * (Scalar(0.0038482516772413) * t60 + t61);
  const Scalar I_t11_g = Scalar(3.21970574695491e-07) * c_11 + Scalar(0.0022644781431582876) * s_11;
  const Scalar t63 = c_11 * I_t11_g - Scalar(1.609852873477455e-07);
  const Scalar I_11_yz = Scalar(6.823068516838894e-08) * c_11 +
      Scalar(0.0007940924716883453) * s_11;
  const Scalar mr_11_y = c_11 + Scalar(8659.923823660012) * s_11;
  tau[10] = t20 * t63 - qdd_10 * I_11_yz + Scalar(0.0022955781994879005) * qdd_11 +
      Scalar(0.000020065123418265) * c_10 * mr_11_y + Scalar(0.16) * t62 + mu_12_z;
  const Scalar t64 = qd_4 * t42;
  const Scalar t65 = Scalar(2.6598149554338075) * c_5 * qdd_4 - t44 -
      Scalar(4.6620543474247516) * t64 - Scalar(5.319629910867615) * s_5 * qd_4 * qd_5 +
      Scalar(163.07990445503535) * s_4;
  const Scalar t66 = c_5 * (Scalar(0.5) * t10 * qdd_4 + t64);
  const Scalar I_5_xz = Scalar(0.0007940924716883453) * c_5 - Scalar(6.823068516838894e-08) * s_5;
  const Scalar t67 = qd_5 * (qd_5 * I_5_xz + Scalar(2.0) * qd_4 * t47);
  const Scalar t68 = qdd_4 * (Scalar(0.0005396092213171668) * c_5_6 * c_5_6 + s_5 * I_t5_g -
      Scalar(0.0031799702681776175));
  const Scalar mr_5_x = c_5 - Scalar(0.00011547445686160344) * s_5;
  const Scalar t69 = qdd_5 * I_5_yz + Scalar(0.001231440536717216) * t66 +
      Scalar(0.00023148988883634047) * (t43 + t10 * t65) + t67 + Scalar(0.08509272390476785) * c_4 +
      t68 - Scalar(0.1737624403145115) * s_4 * mr_5_x;
  tau[3] = -t69;
  const Scalar U_12_yy_zz = t20 - t60;
  const Scalar t70 = Scalar(2.0) * qd_10;
  const Scalar t71 = t19 * qdd_10 + c_11_12 * omega_12_z * t70;
  const Scalar t72 = s_10 * h_e_5 - c_10 * h_e_6;
  const Scalar f_e10_y = s_10 * h_e_3 + c_10 * h_e_2;
  const Scalar mu_12_x = Scalar(0.00023148988883634047) * U_12_yy_zz -
      Scalar(0.001231440536717216) * s_11 * qd_10 * qd_11 +
      Scalar(0.000615720268358608) * c_11 * qdd_10 - Scalar(0.0005411142213171667) * t71 +
      Scalar(0.037751348953737156) * s_10 - Scalar(0.05945) * t61 + Scalar(0.16) * f_e10_y -
      t19 * h_e_4 + c_11_12 * t72;
  const Scalar t73 = t19 * (t72 - Scalar(3.01e-06) * qd_10 * omega_12_z);
  const Scalar t74 = c_11_12 * (Scalar(1.505e-06) * qdd_10 + h_e_4);
  const Scalar mu_12_y = Scalar(0.00023148988883634047) * t23 + Scalar(0.05945) * t28 - t74 - t73;
  const Scalar f_12_z = f_e10_y - Scalar(0.0038482516772413) * t71;
  const Scalar I_11_xz = Scalar(0.0007940924716883453) * c_11 -
      Scalar(6.823068516838894e-08) * s_11;
  const Scalar t75 = qd_11 * (qd_11 * I_11_xz + t70 * t63);
  const Scalar t76 = qdd_10 * (s_11 * I_t11_g - Scalar(0.0026388560468604506));
  const Scalar mr_11_x = c_11 - Scalar(0.00011547445686160344) * s_11;
  const Scalar t77 = qdd_11 * I_11_yz + t75 + t76 + Scalar(0.08509272390476785) * c_10 -
      Scalar(0.1737624403145115) * s_10 * mr_11_x - Scalar(0.16) * c_11 * f_12_z + t19 * mu_12_x +
      c_11_12 * mu_12_y;
  tau[9] = -t77;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[144] = {
    1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1};

// Joint-space inertia matrix B(q) (7.32).
//   q[12]   in   joint positions, rad or m
//   B[144]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//                12 x 12, row by row: entry (i, j) is B[12 * i + j]
// Reads q[1..2], q[4..5], q[7..8], q[10..11]. Operations: 66 mul, 40 add, 16 sin/cos. Always zero:
// 108 of the 144 entries of B.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inertia_matrix(const Scalar* q, Scalar* B, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 4, 5, 7, 8, 10, 11>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_5 = sine[4],
      c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5], s_8 = sine[7], c_8 = cosine[7],
      s_9 = sine[8], c_9 = cosine[8], s_11 = sine[10], c_11 = cosine[10], s_12 = sine[11],
      c_12 = cosine[11];
  B[130] = Scalar(0.001231440536717216) * c_12 + Scalar(0.002838197420805067);
  B[91] = Scalar(0.001231440536717216) * c_9 + Scalar(0.002838197420805067);
  B[52] = Scalar(0.001231440536717216) * c_6 + Scalar(0.002838197420805067);
  B[13] = Scalar(0.001231440536717216) * c_3 + Scalar(0.002838197420805067);
  B[14] = B[25] = Scalar(0.000615720268358608) * c_3 + Scalar(0.0005426192213171668);
  B[53] = B[64] = Scalar(0.000615720268358608) * c_6 + Scalar(0.0005426192213171668);
  B[92] = B[103] = Scalar(0.000615720268358608) * c_9 + Scalar(0.0005426192213171668);
  B[131] = B[142] = Scalar(0.000615720268358608) * c_12 + Scalar(0.0005426192213171668);
  const Scalar c_8_9 = s_8 * c_9 + c_8 * s_9;
  const Scalar mu_u_9_8_a_z = Scalar(0.00023148988883634047) * c_8_9;
  B[80] = B[102] = mu_u_9_8_a_z;
  const Scalar c_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar mu_u_3_2_a_z = Scalar(0.00023148988883634047) * c_2_3;
  B[2] = B[24] = mu_u_3_2_a_z;
  const Scalar c_5_6 = s_5 * c_6 + c_5 * s_6;
  B[41] = B[63] = Scalar(-0.00023148988883634047) * c_5_6;
  const Scalar c_11_12 = s_11 * c_12 + c_11 * s_12;
  B[119] = B[141] = Scalar(-0.00023148988883634047) * c_11_12;
  B[118] = B[129] = Scalar(-6.823068516838894e-08) * c_11 -
      Scalar(0.00023148988883634047) * c_11_12 - Scalar(0.0007940924716883453) * s_11;
  const Scalar t1 = c_11 * (s_11 * s_12 - c_11 * c_12);
  const Scalar I_t11_g = Scalar(3.21970574695491e-07) * c_11 + Scalar(0.0022644781431582876) * s_11;
  B[117] = Scalar(-0.0005396092213171668) * c_11_12 * c_11_12 - Scalar(0.001231440536717216) * t1 -
      s_11 * I_t11_g + Scalar(0.0031799702681776175);
  B[79] = B[90] = mu_u_9_8_a_z - Scalar(6.823068516838894e-08) * c_8 +
      Scalar(0.0007940924716883453) * s_8;
  const Scalar t2 = c_8 * (s_8 * s_9 - c_8 * c_9);
  const Scalar t3 = s_8 * (Scalar(3.21970574695491e-07) * c_8 -
      Scalar(0.0022644781431582876) * s_8);
  B[78] = Scalar(-0.0005396092213171668) * c_8_9 * c_8_9 - Scalar(0.001231440536717216) * t2 + t3 +
      Scalar(0.0031799702681776175);
  B[40] = B[51] = Scalar(-6.823068516838894e-08) * c_5 - Scalar(0.00023148988883634047) * c_5_6 -
      Scalar(0.0007940924716883453) * s_5;
  const Scalar t4 = c_5 * (s_5 * s_6 - c_5 * c_6);
  const Scalar I_t5_g = Scalar(3.21970574695491e-07) * c_5 + Scalar(0.0022644781431582876) * s_5;
  B[39] = Scalar(-0.0005396092213171668) * c_5_6 * c_5_6 - Scalar(0.001231440536717216) * t4 -
      s_5 * I_t5_g + Scalar(0.0031799702681776175);
  B[1] = B[12] = mu_u_3_2_a_z - Scalar(6.823068516838894e-08) * c_2 +
      Scalar(0.0007940924716883453) * s_2;
  const Scalar t5 = c_2 * (s_2 * s_3 - c_2 * c_3);
  const Scalar t6 = s_2 * (Scalar(3.21970574695491e-07) * c_2 -
      Scalar(0.0022644781431582876) * s_2);
  B[0] = Scalar(-0.0005396092213171668) * c_2_3 * c_2_3 - Scalar(0.001231440536717216) * t5 + t6 +
      Scalar(0.0031799702681776175);
  B[3] = B[4] = B[5] = B[6] = B[7] = B[8] = B[9] = B[10] = Scalar(0.0);
  B[11] = B[15] = B[16] = B[17] = B[18] = B[19] = B[20] = B[21] = Scalar(0.0);
  B[22] = B[23] = B[27] = B[28] = B[29] = B[30] = B[31] = B[32] = Scalar(0.0);
  B[33] = B[34] = B[35] = B[36] = B[37] = B[38] = B[42] = B[43] = Scalar(0.0);
  B[44] = B[45] = B[46] = B[47] = B[48] = B[49] = B[50] = B[54] = Scalar(0.0);
  B[55] = B[56] = B[57] = B[58] = B[59] = B[60] = B[61] = B[62] = Scalar(0.0);
  B[66] = B[67] = B[68] = B[69] = B[70] = B[71] = B[72] = B[73] = Scalar(0.0);
  B[74] = B[75] = B[76] = B[77] = B[81] = B[82] = B[83] = B[84] = Scalar(0.0);
  B[85] = B[86] = B[87] = B[88] = B[89] = B[93] = B[94] = B[95] = Scalar(0.0);
  B[96] = B[97] = B[98] = B[99] = B[100] = B[101] = B[105] = B[106] = Scalar(0.0);
  B[107] = B[108] = B[109] = B[110] = B[111] = B[112] = B[113] = B[114] = Scalar(0.0);
  B[115] = B[116] = B[120] = B[121] = B[122] = B[123] = B[124] = B[125] = Scalar(0.0);
  B[126] = B[127] = B[128] = B[132] = B[133] = B[134] = B[135] = B[136] = Scalar(0.0);
  B[137] = B[138] = B[139] = B[140] = Scalar(0.0);
  B[26] = B[65] = B[104] = B[143] = Scalar(0.0005426192213171668);
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[936] = {
    0, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0,
        0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0,
        0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[12]   in   joint positions, rad or m
//   c[936]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//                c_ijk = c_ikj is c[78 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads q[1..2], q[4..5], q[7..8], q[10..11]. Operations: 74 mul, 40 add, 16 sin/cos. Always zero:
// 896 of the 936 entries of c.
template <class Scalar, class SinCos = LibrarySinCos>
inline void christoffel(const Scalar* q, Scalar* c, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 4, 5, 7, 8, 10, 11>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_5 = sine[4],
      c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5], s_8 = sine[7], c_8 = cosine[7],
      s_9 = sine[8], c_9 = cosine[8], s_11 = sine[10], c_11 = cosine[10], s_12 = sine[11],
      c_12 = cosine[11];
  const Scalar t1 = c_2 * c_3 - s_2 * s_3;
  c[4] = c[5] = Scalar(0.00023148988883634047) * t1;
  const Scalar t2 = c_5 * c_6 - s_5 * s_6;
  const Scalar c_4_6_6 = Scalar(-0.00023148988883634047) * t2;
  c[253] = c[254] = c_4_6_6;
  const Scalar t3 = c_8 * c_9 - s_8 * s_9;
  c[511] = c[512] = Scalar(0.00023148988883634047) * t3;
  const Scalar t4 = c_11 * c_12 - s_11 * s_12;
  const Scalar c_10_12_12 = Scalar(-0.00023148988883634047) * t4;
  c[778] = c[779] = c_10_12_12;
  const Scalar dmu_10_12_y = Scalar(0.000615720268358608) * c_11 +
      Scalar(0.0005396092213171668) * t4;
  const Scalar c_11_12 = c_11 * s_12 + s_11 * c_12;
  const Scalar c_12_10_10 = c_11_12 * dmu_10_12_y;
  c[912] = c_12_10_10;
  const Scalar dmu_7_9_y = Scalar(0.000615720268358608) * c_8 + Scalar(0.0005396092213171668) * t3;
  const Scalar c_8_9 = c_8 * s_9 + s_8 * c_9;
  const Scalar c_9_7_7 = c_8_9 * dmu_7_9_y;
  c[651] = c_9_7_7;
  const Scalar dmu_4_6_y = Scalar(0.000615720268358608) * c_5 + Scalar(0.0005396092213171668) * t2;
  const Scalar c_5_6 = c_5 * s_6 + s_5 * c_6;
  const Scalar c_6_4_4 = c_5_6 * dmu_4_6_y;
  c[399] = c_6_4_4;
  const Scalar dmu_1_3_y = Scalar(0.000615720268358608) * c_2 + Scalar(0.0005396092213171668) * t1;
  const Scalar c_2_3 = c_2 * s_3 + s_2 * c_3;
  const Scalar c_3_1_1 = c_2_3 * dmu_1_3_y;
  c[156] = c_3_1_1;
  c[2] = Scalar(6.823068516838894e-08) * s_2 - Scalar(-0.00023148988883634047) * t1 +
      Scalar(0.0007940924716883453) * c_2;
  c[503] = Scalar(6.823068516838894e-08) * s_8 - Scalar(-0.00023148988883634047) * t3 +
      Scalar(0.0007940924716883453) * c_8;
  const Scalar t5 = s_11 * t4;
  const Scalar I_t11_g = c_11 + Scalar(7033.183530202893) * s_11;
  const Scalar dI_11_xx = c_12_10_10 - Scalar(1.609852873477455e-07) +
      Scalar(0.000615720268358608) * t5 + Scalar(3.21970574695491e-07) * c_11 * I_t11_g;
  c[834] = dI_11_xx;
  const Scalar t6 = s_8 * t3;
  const Scalar t7 = c_8 * (c_8 - Scalar(7033.183530202893) * s_8);
  const Scalar dI_8_xx = Scalar(1.609852873477455e-07) + c_9_7_7 +
      Scalar(0.000615720268358608) * t6 - Scalar(3.21970574695491e-07) * t7;
  c[573] = dI_8_xx;
  const Scalar t8 = s_5 * t2;
  const Scalar I_t5_g = c_5 + Scalar(7033.183530202893) * s_5;
  const Scalar dI_5_xx = c_6_4_4 - Scalar(1.609852873477455e-07) +
      Scalar(0.000615720268358608) * t8 + Scalar(3.21970574695491e-07) * c_5 * I_t5_g;
  c[321] = dI_5_xx;
  const Scalar t9 = s_2 * t1;
  const Scalar t10 = c_2 * (c_2 - Scalar(7033.183530202893) * s_2);
  const Scalar dI_2_xx = Scalar(1.609852873477455e-07) + c_3_1_1 +
      Scalar(0.000615720268358608) * t9 - Scalar(3.21970574695491e-07) * t10;
  c[78] = dI_2_xx;
  c[3] = -c_3_1_1;
  const Scalar t11 = t9 - c_2 * c_2_3;
  c[158] = Scalar(-0.000615720268358608) * t11;
  c[82] = c[83] = Scalar(0.000615720268358608) * t11;
  c[248] = Scalar(6.823068516838894e-08) * s_5 + c_4_6_6 - Scalar(0.0007940924716883453) * c_5;
  c[252] = -c_6_4_4;
  const Scalar t12 = t8 - c_5 * c_5_6;
  c[404] = Scalar(-0.000615720268358608) * t12;
  c[331] = c[332] = Scalar(0.000615720268358608) * t12;
  c[510] = -c_9_7_7;
  const Scalar t13 = t6 - c_8 * c_8_9;
  c[659] = Scalar(-0.000615720268358608) * t13;
  c[589] = c[590] = Scalar(0.000615720268358608) * t13;
  c[767] = Scalar(6.823068516838894e-08) * s_11 + c_10_12_12 - Scalar(0.0007940924716883453) * c_11;
  c[777] = -c_12_10_10;
  const Scalar t14 = t5 - c_11 * c_11_12;
  c[923] = Scalar(-0.000615720268358608) * t14;
  c[856] = c[857] = Scalar(0.000615720268358608) * t14;
  c[766] = -dI_11_xx;
  c[502] = -dI_8_xx;
  c[247] = -dI_5_xx;
  c[1] = -dI_2_xx;
  c[0] = c[6] = c[7] = c[8] = c[9] = c[10] = c[11] = c[12] = Scalar(0.0);
  c[13] = c[14] = c[15] = c[16] = c[17] = c[18] = c[19] = c[20] = Scalar(0.0);
  c[21] = c[22] = c[23] = c[24] = c[25] = c[26] = c[27] = c[28] = Scalar(0.0);
  c[29] = c[30] = c[31] = c[32] = c[33] = c[34] = c[35] = c[36] = Scalar(0.0);
  c[37] = c[38] = c[39] = c[40] = c[41] = c[42] = c[43] = c[44] = Scalar(0.0);
  c[45] = c[46] = c[47] = c[48] = c[49] = c[50] = c[51] = c[52] = Scalar(0.0);
  c[53] = c[54] = c[55] = c[56] = c[57] = c[58] = c[59] = c[60] = Scalar(0.0);
  c[61] = c[62] = c[63] = c[64] = c[65] = c[66] = c[67] = c[68] = Scalar(0.0);
  c[69] = c[70] = c[71] = c[72] = c[73] = c[74] = c[75] = c[76] = Scalar(0.0);
  c[77] = c[79] = c[80] = c[81] = c[84] = c[85] = c[86] = c[87] = Scalar(0.0);
  c[88] = c[89] = c[90] = c[91] = c[92] = c[93] = c[94] = c[95] = Scalar(0.0);
  c[96] = c[97] = c[98] = c[99] = c[100] = c[101] = c[102] = c[103] = Scalar(0.0);
  c[104] = c[105] = c[106] = c[107] = c[108] = c[109] = c[110] = c[111] = Scalar(0.0);
  c[112] = c[113] = c[114] = c[115] = c[116] = c[117] = c[118] = c[119] = Scalar(0.0);
  c[120] = c[121] = c[122] = c[123] = c[124] = c[125] = c[126] = c[127] = Scalar(0.0);
  c[128] = c[129] = c[130] = c[131] = c[132] = c[133] = c[134] = c[135] = Scalar(0.0);
  c[136] = c[137] = c[138] = c[139] = c[140] = c[141] = c[142] = c[143] = Scalar(0.0);
  c[144] = c[145] = c[146] = c[147] = c[148] = c[149] = c[150] = c[151] = Scalar(0.0);
  c[152] = c[153] = c[154] = c[155] = c[157] = c[159] = c[160] = c[161] = Scalar(0.0);
  c[162] = c[163] = c[164] = c[165] = c[166] = c[167] = c[168] = c[169] = Scalar(0.0);
  c[170] = c[171] = c[172] = c[173] = c[174] = c[175] = c[176] = c[177] = Scalar(0.0);
  c[178] = c[179] = c[180] = c[181] = c[182] = c[183] = c[184] = c[185] = Scalar(0.0);
  c[186] = c[187] = c[188] = c[189] = c[190] = c[191] = c[192] = c[193] = Scalar(0.0);
  c[194] = c[195] = c[196] = c[197] = c[198] = c[199] = c[200] = c[201] = Scalar(0.0);
  c[202] = c[203] = c[204] = c[205] = c[206] = c[207] = c[208] = c[209] = Scalar(0.0);
  c[210] = c[211] = c[212] = c[213] = c[214] = c[215] = c[216] = c[217] = Scalar(0.0);
  c[218] = c[219] = c[220] = c[221] = c[222] = c[223] = c[224] = c[225] = Scalar(0.0);
  c[226] = c[227] = c[228] = c[229] = c[230] = c[231] = c[232] = c[233] = Scalar(0.0);
  c[234] = c[235] = c[236] = c[237] = c[238] = c[239] = c[240] = c[241] = Scalar(0.0);
  c[242] = c[243] = c[244] = c[245] = c[246] = c[249] = c[250] = c[251] = Scalar(0.0);
  c[255] = c[256] = c[257] = c[258] = c[259] = c[260] = c[261] = c[262] = Scalar(0.0);
  c[263] = c[264] = c[265] = c[266] = c[267] = c[268] = c[269] = c[270] = Scalar(0.0);
  c[271] = c[272] = c[273] = c[274] = c[275] = c[276] = c[277] = c[278] = Scalar(0.0);
  c[279] = c[280] = c[281] = c[282] = c[283] = c[284] = c[285] = c[286] = Scalar(0.0);
  c[287] = c[288] = c[289] = c[290] = c[291] = c[292] = c[293] = c[294] = Scalar(0.0);
  c[295] = c[296] = c[297] = c[298] = c[299] = c[300] = c[301] = c[302] = Scalar(0.0);
  c[303] = c[304] = c[305] = c[306] = c[307] = c[308] = c[309] = c[310] = Scalar(0.0);
  c[311] = c[312] = c[313] = c[314] = c[315] = c[316] = c[317] = c[318] = Scalar(0.0);
  c[319] = c[320] = c[322] = c[323] = c[324] = c[325] = c[326] = c[327] = Scalar(0.0);
  c[328] = c[329] = c[330] = c[333] = c[334] = c[335] = c[336] = c[337] = Scalar(0.0);
  c[338] = c[339] = c[340] = c[341] = c[342] = c[343] = c[344] = c[345] = Scalar(0.0);
  c[346] = c[347] = c[348] = c[349] = c[350] = c[351] = c[352] = c[353] = Scalar(0.0);
  c[354] = c[355] = c[356] = c[357] = c[358] = c[359] = c[360] = c[361] = Scalar(0.0);
  c[362] = c[363] = c[364] = c[365] = c[366] = c[367] = c[368] = c[369] = Scalar(0.0);
  c[370] = c[371] = c[372] = c[373] = c[374] = c[375] = c[376] = c[377] = Scalar(0.0);
  c[378] = c[379] = c[380] = c[381] = c[382] = c[383] = c[384] = c[385] = Scalar(0.0);
  c[386] = c[387] = c[388] = c[389] = c[390] = c[391] = c[392] = c[393] = Scalar(0.0);
  c[394] = c[395] = c[396] = c[397] = c[398] = c[400] = c[401] = c[402] = Scalar(0.0);
  c[403] = c[405] = c[406] = c[407] = c[408] = c[409] = c[410] = c[411] = Scalar(0.0);
  c[412] = c[413] = c[414] = c[415] = c[416] = c[417] = c[418] = c[419] = Scalar(0.0);
  c[420] = c[421] = c[422] = c[423] = c[424] = c[425] = c[426] = c[427] = Scalar(0.0);
  c[428] = c[429] = c[430] = c[431] = c[432] = c[433] = c[434] = c[435] = Scalar(0.0);
  c[436] = c[437] = c[438] = c[439] = c[440] = c[441] = c[442] = c[443] = Scalar(0.0);
  c[444] = c[445] = c[446] = c[447] = c[448] = c[449] = c[450] = c[451] = Scalar(0.0);
  c[452] = c[453] = c[454] = c[455] = c[456] = c[457] = c[458] = c[459] = Scalar(0.0);
  c[460] = c[461] = c[462] = c[463] = c[464] = c[465] = c[466] = c[467] = Scalar(0.0);
  c[468] = c[469] = c[470] = c[471] = c[472] = c[473] = c[474] = c[475] = Scalar(0.0);
  c[476] = c[477] = c[478] = c[479] = c[480] = c[481] = c[482] = c[483] = Scalar(0.0);
  c[484] = c[485] = c[486] = c[487] = c[488] = c[489] = c[490] = c[491] = Scalar(0.0);
  c[492] = c[493] = c[494] = c[495] = c[496] = c[497] = c[498] = c[499] = Scalar(0.0);
  c[500] = c[501] = c[504] = c[505] = c[506] = c[507] = c[508] = c[509] = Scalar(0.0);
  c[513] = c[514] = c[515] = c[516] = c[517] = c[518] = c[519] = c[520] = Scalar(0.0);
  c[521] = c[522] = c[523] = c[524] = c[525] = c[526] = c[527] = c[528] = Scalar(0.0);
  c[529] = c[530] = c[531] = c[532] = c[533] = c[534] = c[535] = c[536] = Scalar(0.0);
  c[537] = c[538] = c[539] = c[540] = c[541] = c[542] = c[543] = c[544] = Scalar(0.0);
  c[545] = c[546] = c[547] = c[548] = c[549] = c[550] = c[551] = c[552] = Scalar(0.0);
  c[553] = c[554] = c[555] = c[556] = c[557] = c[558] = c[559] = c[560] = Scalar(0.0);
  c[561] = c[562] = c[563] = c[564] = c[565] = c[566] = c[567] = c[568] = Scalar(0.0);
  c[569] = c[570] = c[571] = c[572] = c[574] = c[575] = c[576] = c[577] = Scalar(0.0);
  c[578] = c[579] = c[580] = c[581] = c[582] = c[583] = c[584] = c[585] = Scalar(0.0);
  c[586] = c[587] = c[588] = c[591] = c[592] = c[593] = c[594] = c[595] = Scalar(0.0);
  c[596] = c[597] = c[598] = c[599] = c[600] = c[601] = c[602] = c[603] = Scalar(0.0);
  c[604] = c[605] = c[606] = c[607] = c[608] = c[609] = c[610] = c[611] = Scalar(0.0);
  c[612] = c[613] = c[614] = c[615] = c[616] = c[617] = c[618] = c[619] = Scalar(0.0);
  c[620] = c[621] = c[622] = c[623] = c[624] = c[625] = c[626] = c[627] = Scalar(0.0);
  c[628] = c[629] = c[630] = c[631] = c[632] = c[633] = c[634] = c[635] = Scalar(0.0);
  c[636] = c[637] = c[638] = c[639] = c[640] = c[641] = c[642] = c[643] = Scalar(0.0);
  c[644] = c[645] = c[646] = c[647] = c[648] = c[649] = c[650] = c[652] = Scalar(0.0);
  c[653] = c[654] = c[655] = c[656] = c[657] = c[658] = c[660] = c[661] = Scalar(0.0);
  c[662] = c[663] = c[664] = c[665] = c[666] = c[667] = c[668] = c[669] = Scalar(0.0);
  c[670] = c[671] = c[672] = c[673] = c[674] = c[675] = c[676] = c[677] = Scalar(0.0);
  c[678] = c[679] = c[680] = c[681] = c[682] = c[683] = c[684] = c[685] = Scalar(0.0);
  c[686] = c[687] = c[688] = c[689] = c[690] = c[691] = c[692] = c[693] = Scalar(0.0);
  c[694] = c[695] = c[696] = c[697] = c[698] = c[699] = c[700] = c[701] = Scalar(0.0);
  c[702] = c[703] = c[704] = c[705] = c[706] = c[707] = c[708] = c[709] = Scalar(0.0);
  c[710] = c[711] = c[712] = c[713] = c[714] = c[715] = c[716] = c[717] = Scalar(0.0);
  c[718] = c[719] = c[720] = c[721] = c[722] = c[723] = c[724] = c[725] = Scalar(0.0);
  c[726] = c[727] = c[728] = c[729] = c[730] = c[731] = c[732] = c[733] = Scalar(0.0);
  c[734] = c[735] = c[736] = c[737] = c[738] = c[739] = c[740] = c[741] = Scalar(0.0);
  c[742] = c[743] = c[744] = c[745] = c[746] = c[747] = c[748] = c[749] = Scalar(0.0);
  c[750] = c[751] = c[752] = c[753] = c[754] = c[755] = c[756] = c[757] = Scalar(0.0);
  c[758] = c[759] = c[760] = c[761] = c[762] = c[763] = c[764] = c[765] = Scalar(0.0);
  c[768] = c[769] = c[770] = c[771] = c[772] = c[773] = c[774] = c[775] = Scalar(0.0);
  c[776] = c[780] = c[781] = c[782] = c[783] = c[784] = c[785] = c[786] = Scalar(0.0);
  c[787] = c[788] = c[789] = c[790] = c[791] = c[792] = c[793] = c[794] = Scalar(0.0);
  c[795] = c[796] = c[797] = c[798] = c[799] = c[800] = c[801] = c[802] = Scalar(0.0);
  c[803] = c[804] = c[805] = c[806] = c[807] = c[808] = c[809] = c[810] = Scalar(0.0);
  c[811] = c[812] = c[813] = c[814] = c[815] = c[816] = c[817] = c[818] = Scalar(0.0);
  c[819] = c[820] = c[821] = c[822] = c[823] = c[824] = c[825] = c[826] = Scalar(0.0);
  c[827] = c[828] = c[829] = c[830] = c[831] = c[832] = c[833] = c[835] = Scalar(0.0);
  c[836] = c[837] = c[838] = c[839] = c[840] = c[841] = c[842] = c[843] = Scalar(0.0);
  c[844] = c[845] = c[846] = c[847] = c[848] = c[849] = c[850] = c[851] = Scalar(0.0);
  c[852] = c[853] = c[854] = c[855] = c[858] = c[859] = c[860] = c[861] = Scalar(0.0);
  c[862] = c[863] = c[864] = c[865] = c[866] = c[867] = c[868] = c[869] = Scalar(0.0);
  c[870] = c[871] = c[872] = c[873] = c[874] = c[875] = c[876] = c[877] = Scalar(0.0);
  c[878] = c[879] = c[880] = c[881] = c[882] = c[883] = c[884] = c[885] = Scalar(0.0);
  c[886] = c[887] = c[888] = c[889] = c[890] = c[891] = c[892] = c[893] = Scalar(0.0);
  c[894] = c[895] = c[896] = c[897] = c[898] = c[899] = c[900] = c[901] = Scalar(0.0);
  c[902] = c[903] = c[904] = c[905] = c[906] = c[907] = c[908] = c[909] = Scalar(0.0);
  c[910] = c[911] = c[913] = c[914] = c[915] = c[916] = c[917] = c[918] = Scalar(0.0);
  c[919] = c[920] = c[921] = c[922] = c[924] = c[925] = c[926] = c[927] = Scalar(0.0);
  c[928] = c[929] = c[930] = c[931] = c[932] = c[933] = c[934] = c[935] = Scalar(0.0);
}

// The entries of C in coriolis_matrix that are not always zero.
inline constexpr bool coriolis_matrix_nonzero[144] = {
    1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 1, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0};

// C(q, qd) from the Christoffel symbols (7.44).
//   q[12]   in   joint positions, rad or m
//   qd[12]  in   joint velocities, rad/s or m/s
//   C[144]  out  c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric
//                12 x 12, row by row: entry (i, j) is C[12 * i + j]
// Reads q[1..2], q[4..5], q[7..8], q[10..11], qd[0..11]. Operations: 108 mul, 60 add, 16 sin/cos.
// Always zero: 112 of the 144 entries of C.
template <class Scalar, class SinCos = LibrarySinCos>
inline void coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 4, 5, 7, 8, 10, 11>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_5 = sine[4],
      c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5], s_8 = sine[7], c_8 = cosine[7],
      s_9 = sine[8], c_9 = cosine[8], s_11 = sine[10], c_11 = cosine[10], s_12 = sine[11],
      c_12 = cosine[11];
  const Scalar t1 = c_2 * c_3 - s_2 * s_3;
  const Scalar t2 = Scalar(0.000615720268358608) * c_2;
  const Scalar dmu_1_3_y = Scalar(0.0005396092213171668) * t1 + t2;
  const Scalar c_2_3 = c_2 * s_3 + s_2 * c_3;
  const Scalar t3 = c_2_3 * dmu_1_3_y;
  const Scalar C_3_1 = qd_1 * t3;
  C[24] = C_3_1;
  const Scalar t4 = c_5 * c_6 - s_5 * s_6;
  const Scalar t5 = Scalar(0.000615720268358608) * c_5;
  const Scalar dmu_4_6_y = Scalar(0.0005396092213171668) * t4 + t5;
  const Scalar c_5_6 = c_5 * s_6 + s_5 * c_6;
  const Scalar t6 = c_5_6 * dmu_4_6_y;
  const Scalar C_6_4 = qd_4 * t6;
  C[63] = C_6_4;
  const Scalar t7 = c_8 * c_9 - s_8 * s_9;
  const Scalar t8 = Scalar(0.000615720268358608) * c_8;
  const Scalar dmu_7_9_y = Scalar(0.0005396092213171668) * t7 + t8;
  const Scalar c_8_9 = c_8 * s_9 + s_8 * c_9;
  const Scalar t9 = c_8_9 * dmu_7_9_y;
  const Scalar C_9_7 = qd_7 * t9;
  C[102] = C_9_7;
  const Scalar t10 = c_11 * c_12 - s_11 * s_12;
  const Scalar t11 = Scalar(0.000615720268358608) * c_11;
  const Scalar dmu_10_12_y = Scalar(0.0005396092213171668) * t10 + t11;
  const Scalar c_11_12 = c_11 * s_12 + s_11 * c_12;
  const Scalar t12 = c_11_12 * dmu_10_12_y;
  const Scalar C_12_10 = qd_10 * t12;
  C[141] = C_12_10;
  const Scalar t13 = Scalar(-0.000615720268358608) * s_2 * t1;
  const Scalar t14 = Scalar(1.609852873477455e-07) + t3 - t13 -
      Scalar(3.21970574695491e-07) * c_2 * (c_2 - Scalar(7033.183530202893) * s_2);
  const Scalar C_2_1 = qd_1 * t14;
  C[12] = C_2_1;
  const Scalar t15 = t13 + c_2_3 * t2;
  C[25] = qd_2 * t15;
  const Scalar t16 = Scalar(-0.000615720268358608) * s_5 * t4;
  const Scalar I_t5_g = c_5 + Scalar(7033.183530202893) * s_5;
  const Scalar t17 = t6 - Scalar(1.609852873477455e-07) - t16 +
      Scalar(3.21970574695491e-07) * c_5 * I_t5_g;
  const Scalar C_5_4 = qd_4 * t17;
  C[51] = C_5_4;
  const Scalar t18 = t16 + c_5_6 * t5;
  C[64] = qd_5 * t18;
  const Scalar t19 = Scalar(-0.000615720268358608) * s_8 * t7;
  const Scalar t20 = Scalar(1.609852873477455e-07) + t9 - t19 -
      Scalar(3.21970574695491e-07) * c_8 * (c_8 - Scalar(7033.183530202893) * s_8);
  const Scalar C_8_7 = qd_7 * t20;
  C[90] = C_8_7;
  const Scalar t21 = t19 + c_8_9 * t8;
  C[103] = qd_8 * t21;
  const Scalar t22 = Scalar(-0.000615720268358608) * s_11 * t10;
  const Scalar I_t11_g = c_11 + Scalar(7033.183530202893) * s_11;
  const Scalar t23 = t12 - Scalar(1.609852873477455e-07) - t22 +
      Scalar(3.21970574695491e-07) * c_11 * I_t11_g;
  const Scalar C_11_10 = qd_10 * t23;
  C[129] = C_11_10;
  const Scalar t24 = t22 + c_11_12 * t11;
  C[142] = qd_11 * t24;
  const Scalar t25 = Scalar(-0.00023148988883634047) * t1;
  const Scalar t26 = qd_2 + qd_3;
  C[2] = -t25 * t26 - C_3_1;
  C[13] = -qd_3 * t15;
  C[14] = -t15 * t26;
  const Scalar t27 = Scalar(-0.00023148988883634047) * t4;
  const Scalar t28 = qd_5 + qd_6;
  C[41] = t27 * t28 - C_6_4;
  C[52] = -qd_6 * t18;
  C[53] = -t18 * t28;
  const Scalar t29 = Scalar(-0.00023148988883634047) * t7;
  const Scalar t30 = qd_8 + qd_9;
  C[80] = -t29 * t30 - C_9_7;
  C[91] = -qd_9 * t21;
  C[92] = -t21 * t30;
  const Scalar t31 = Scalar(-0.00023148988883634047) * t10;
  const Scalar t32 = qd_11 + qd_12;
  C[119] = t31 * t32 - C_12_10;
  C[130] = -qd_12 * t24;
  C[131] = -t24 * t32;
  C[0] = -qd_3 * t3 - qd_2 * t14;
  C[39] = -qd_6 * t6 - qd_5 * t17;
  C[78] = -qd_9 * t9 - qd_8 * t20;
  C[117] = -qd_12 * t12 - qd_11 * t23;
  const Scalar db_12_2 = Scalar(0.00008592284601731775) * s_2 + Scalar(0.2915150276442773) * t1 +
      c_2;
  C[1] = -qd_3 * t25 - (C_2_1 - Scalar(0.0007940924716883453) * qd_2 * db_12_2);
  const Scalar Ic_5_xz = Scalar(0.2915150276442773) * t4 - Scalar(0.00008592284601731775) * s_5 +
      c_5;
  C[40] = qd_6 * t27 - (Scalar(0.0007940924716883453) * qd_5 * Ic_5_xz + C_5_4);
  const Scalar db_78_8 = Scalar(0.00008592284601731775) * s_8 + Scalar(0.2915150276442773) * t7 +
      c_8;
  C[79] = -qd_9 * t29 - (C_8_7 - Scalar(0.0007940924716883453) * qd_8 * db_78_8);
  const Scalar Ic_11_xz = Scalar(0.2915150276442773) * t10 - Scalar(0.00008592284601731775) * s_11 +
      c_11;
  C[118] = qd_12 * t31 - (Scalar(0.0007940924716883453) * qd_11 * Ic_11_xz + C_11_10);
  C[3] = C[4] = C[5] = C[6] = C[7] = C[8] = C[9] = C[10] = Scalar(0.0);
  C[11] = C[15] = C[16] = C[17] = C[18] = C[19] = C[20] = C[21] = Scalar(0.0);
  C[22] = C[23] = C[26] = C[27] = C[28] = C[29] = C[30] = C[31] = Scalar(0.0);
  C[32] = C[33] = C[34] = C[35] = C[36] = C[37] = C[38] = C[42] = Scalar(0.0);
  C[43] = C[44] = C[45] = C[46] = C[47] = C[48] = C[49] = C[50] = Scalar(0.0);
  C[54] = C[55] = C[56] = C[57] = C[58] = C[59] = C[60] = C[61] = Scalar(0.0);
  C[62] = C[65] = C[66] = C[67] = C[68] = C[69] = C[70] = C[71] = Scalar(0.0);
  C[72] = C[73] = C[74] = C[75] = C[76] = C[77] = C[81] = C[82] = Scalar(0.0);
  C[83] = C[84] = C[85] = C[86] = C[87] = C[88] = C[89] = C[93] = Scalar(0.0);
  C[94] = C[95] = C[96] = C[97] = C[98] = C[99] = C[100] = C[101] = Scalar(0.0);
  C[104] = C[105] = C[106] = C[107] = C[108] = C[109] = C[110] = C[111] = Scalar(0.0);
  C[112] = C[113] = C[114] = C[115] = C[116] = C[120] = C[121] = C[122] = Scalar(0.0);
  C[123] = C[124] = C[125] = C[126] = C[127] = C[128] = C[132] = C[133] = Scalar(0.0);
  C[134] = C[135] = C[136] = C[137] = C[138] = C[139] = C[140] = C[143] = Scalar(0.0);
}

// Gravity torques g(q) (7.39).
//   q[12]  in   joint positions, rad or m
//   g[12]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11]. Operations: 52 mul, 24 add, 24 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void gravity(const Scalar* q, Scalar* g, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6], s_8 = sine[7],
      c_8 = cosine[7], s_9 = sine[8], c_9 = cosine[8], s_10 = sine[9], c_10 = cosine[9],
      s_11 = sine[10], c_11 = cosine[10], s_12 = sine[11], c_12 = cosine[11];
  const Scalar t1 = Scalar(0.037751348953737156) * s_3;
  const Scalar t2 = Scalar(0.037751348953737156) * c_3;
  g[2] = c_1 * c_2 * t1 + c_1 * s_2 * t2;
  const Scalar t3 = Scalar(0.037751348953737156) * s_6;
  const Scalar t4 = Scalar(0.037751348953737156) * c_6;
  g[5] = c_4 * c_5 * t3 + c_4 * s_5 * t4;
  const Scalar t5 = Scalar(0.037751348953737156) * s_9;
  const Scalar t6 = Scalar(0.037751348953737156) * c_9;
  g[8] = c_7 * c_8 * t5 + c_7 * s_8 * t6;
  const Scalar t7 = Scalar(0.037751348953737156) * s_12;
  const Scalar t8 = Scalar(0.037751348953737156) * c_12;
  g[11] = c_10 * c_11 * t7 + c_10 * s_11 * t8;
  const Scalar hc_2_y = t2 + Scalar(0.1737624403145115);
  const Scalar t9 = t1 - Scalar(0.000020065123418265);
  const Scalar hu_2_t_y = c_2 * t9 + s_2 * hc_2_y;
  g[1] = c_1 * hu_2_t_y;
  const Scalar hc_5_y = t4 + Scalar(0.1737624403145115);
  const Scalar t10 = Scalar(0.000020065123418265) + t3;
  const Scalar hu_5_t_y = c_5 * t10 + s_5 * hc_5_y;
  g[4] = c_4 * hu_5_t_y;
  const Scalar hc_8_y = t6 + Scalar(0.1737624403145115);
  const Scalar t11 = t5 - Scalar(0.000020065123418265);
  const Scalar hu_8_t_y = c_8 * t11 + s_8 * hc_8_y;
  g[7] = c_7 * hu_8_t_y;
  const Scalar hc_11_y = t8 + Scalar(0.1737624403145115);
  const Scalar t12 = Scalar(0.000020065123418265) + t7;
  const Scalar hu_11_t_y = c_11 * t12 + s_11 * hc_11_y;
  g[10] = c_10 * hu_11_t_y;
  g[6] = Scalar(0.08509272390476785) * c_7 - s_7 * (s_8 * t11 - c_8 * hc_8_y);
  g[0] = Scalar(0.08509272390476785) * c_1 - s_1 * (s_2 * t9 - c_2 * hc_2_y);
  g[9] = Scalar(-0.08509272390476785) * c_10 - s_10 * (s_11 * t12 - c_11 * hc_11_y);
  g[3] = Scalar(-0.08509272390476785) * c_4 - s_4 * (s_5 * t10 - c_5 * hc_5_y);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[12]   in   joint positions, rad or m
//   qd[12]  in   joint velocities, rad/s or m/s
//   n[12]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..11], qd[0..11]. Operations: 192 mul, 100 add, 24 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6], s_8 = sine[7],
      c_8 = cosine[7], s_9 = sine[8], c_9 = cosine[8], s_10 = sine[9], c_10 = cosine[9],
      s_11 = sine[10], c_11 = cosine[10], s_12 = sine[11], c_12 = cosine[11];
  const Scalar c_8_9 = s_8 * c_9 + c_8 * s_9;
  const Scalar t1 = s_8 * s_9 - c_8 * c_9;
  const Scalar t2 = c_8_9 * t1;
  const Scalar omega_9_z = qd_8 + qd_9;
  const Scalar t3 = qd_7 * omega_9_z;
  const Scalar t4 = qd_8 * Scalar(2.0) * qd_7;
  const Scalar t5 = Scalar(61.3125) * s_7;
  const Scalar t6 = Scalar(-0.000615720268358608) * t1;
  const Scalar t7 = (s_8 * t4 - t5) * t6;
  const Scalar I_8_xy = c_8 * (Scalar(3.21970574695491e-07) * c_8 -
      Scalar(0.0022644781431582876) * s_8) - Scalar(1.609852873477455e-07);
  const Scalar t8 = omega_9_z * omega_9_z;
  const Scalar t9 = qd_8 * qd_8;
  const Scalar t10 = t9 * (Scalar(6.823068516838894e-08) * s_8 +
      Scalar(0.0007940924716883453) * c_8);
  const Scalar mr_8_x = Scalar(3.2725991304e-07) * s_8 + Scalar(0.002834045917464) * c_8;
  n[6] = Scalar(0.0010792184426343335) * t2 * t3 - Scalar(0.00023148988883634047) * t1 * t8 -
      Scalar(0.001231440536717216) * c_8 * c_8_9 * t3 + t10 - t7 + t4 * I_8_xy +
      Scalar(0.08509272390476785) * c_7 + mr_8_x * t5;
  const Scalar c_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t11 = s_2 * s_3 - c_2 * c_3;
  const Scalar t12 = c_2_3 * t11;
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t13 = qd_1 * omega_3_z;
  const Scalar t14 = qd_2 * Scalar(2.0) * qd_1;
  const Scalar t15 = Scalar(61.3125) * s_1;
  const Scalar t16 = Scalar(-0.000615720268358608) * t11;
  const Scalar t17 = (s_2 * t14 - t15) * t16;
  const Scalar I_2_xy = c_2 * (Scalar(3.21970574695491e-07) * c_2 -
      Scalar(0.0022644781431582876) * s_2) - Scalar(1.609852873477455e-07);
  const Scalar t18 = omega_3_z * omega_3_z;
  const Scalar t19 = qd_2 * qd_2;
  const Scalar t20 = t19 * (Scalar(6.823068516838894e-08) * s_2 +
      Scalar(0.0007940924716883453) * c_2);
  const Scalar mr_2_x = Scalar(3.2725991304e-07) * s_2 + Scalar(0.002834045917464) * c_2;
  n[0] = Scalar(0.0010792184426343335) * t12 * t13 - Scalar(0.00023148988883634047) * t11 * t18 -
      Scalar(0.001231440536717216) * c_2 * c_2_3 * t13 + t20 - t17 + t14 * I_2_xy +
      Scalar(0.08509272390476785) * c_1 + mr_2_x * t15;
  const Scalar c_11_12 = s_11 * c_12 + c_11 * s_12;
  const Scalar t21 = s_11 * s_12 - c_11 * c_12;
  const Scalar t22 = c_11_12 * t21;
  const Scalar omega_12_z = qd_11 + qd_12;
  const Scalar t23 = qd_10 * omega_12_z;
  const Scalar t24 = qd_11 * Scalar(2.0) * qd_10;
  const Scalar t25 = Scalar(61.3125) * s_10;
  const Scalar t26 = Scalar(-0.000615720268358608) * t21;
  const Scalar t27 = (s_11 * t24 - t25) * t26;
  const Scalar I_t11_g = Scalar(3.21970574695491e-07) * c_11 + Scalar(0.0022644781431582876) * s_11;
  const Scalar t28 = c_11 * I_t11_g - Scalar(1.609852873477455e-07);
  const Scalar t29 = omega_12_z * omega_12_z;
  const Scalar I_11_xz = Scalar(0.0007940924716883453) * c_11 -
      Scalar(6.823068516838894e-08) * s_11;
  const Scalar t30 = qd_11 * qd_11;
  const Scalar mr_11_x = Scalar(0.002834045917464) * c_11 - Scalar(3.2725991304e-07) * s_11;
  const Scalar t31 = Scalar(0.001231440536717216) * c_11 * c_11_12 * t23 -
      Scalar(0.00023148988883634047) * t21 * t29 - Scalar(0.0010792184426343335) * t22 * t23 +
      t30 * I_11_xz + t27 + t24 * t28 + Scalar(0.08509272390476785) * c_10 - mr_11_x * t25;
  n[9] = -t31;
  const Scalar c_5_6 = s_5 * c_6 + c_5 * s_6;
  const Scalar t32 = s_5 * s_6 - c_5 * c_6;
  const Scalar t33 = c_5_6 * t32;
  const Scalar omega_6_z = qd_5 + qd_6;
  const Scalar t34 = qd_4 * omega_6_z;
  const Scalar t35 = qd_5 * Scalar(2.0) * qd_4;
  const Scalar t36 = Scalar(61.3125) * s_4;
  const Scalar t37 = Scalar(-0.000615720268358608) * t32;
  const Scalar t38 = (s_5 * t35 - t36) * t37;
  const Scalar I_t5_g = Scalar(3.21970574695491e-07) * c_5 + Scalar(0.0022644781431582876) * s_5;
  const Scalar t39 = c_5 * I_t5_g - Scalar(1.609852873477455e-07);
  const Scalar t40 = omega_6_z * omega_6_z;
  const Scalar I_5_xz = Scalar(0.0007940924716883453) * c_5 - Scalar(6.823068516838894e-08) * s_5;
  const Scalar t41 = qd_5 * qd_5;
  const Scalar mr_5_x = Scalar(0.002834045917464) * c_5 - Scalar(3.2725991304e-07) * s_5;
  const Scalar t42 = Scalar(0.001231440536717216) * c_5 * c_5_6 * t34 -
      Scalar(0.00023148988883634047) * t32 * t40 - Scalar(0.0010792184426343335) * t33 * t34 +
      t41 * I_5_xz + t38 + t35 * t39 + Scalar(0.08509272390476785) * c_4 - mr_5_x * t36;
  n[3] = -t42;
  const Scalar t43 = s_2 * t16;
  const Scalar t44 = qd_1 * qd_1;
  const Scalar t45 = Scalar(61.3125) * c_1;
  const Scalar t46 = Scalar(0.000615720268358608) * c_2_3;
  const Scalar t47 = (c_2 * (t19 + t44) + t45) * t46;
  const Scalar t48 = Scalar(0.0005396092213171668) * t44 * t12 + t19 * t43 - t47;
  n[2] = -t48;
  const Scalar t49 = s_5 * t37;
  const Scalar t50 = qd_4 * qd_4;
  const Scalar t51 = Scalar(61.3125) * c_4;
  const Scalar t52 = Scalar(0.000615720268358608) * c_5_6;
  const Scalar t53 = (c_5 * (t41 + t50) + t51) * t52;
  const Scalar t54 = Scalar(0.0005396092213171668) * t50 * t33 + t41 * t49 - t53;
  n[5] = -t54;
  const Scalar t55 = s_8 * t6;
  const Scalar t56 = qd_7 * qd_7;
  const Scalar t57 = Scalar(61.3125) * c_7;
  const Scalar t58 = Scalar(0.000615720268358608) * c_8_9;
  const Scalar t59 = (c_8 * (t9 + t56) + t57) * t58;
  const Scalar t60 = Scalar(0.0005396092213171668) * t56 * t2 + t9 * t55 - t59;
  n[8] = -t60;
  const Scalar t61 = s_11 * t26;
  const Scalar t62 = qd_10 * qd_10;
  const Scalar t63 = Scalar(61.3125) * c_10;
  const Scalar t64 = Scalar(0.000615720268358608) * c_11_12;
  const Scalar t65 = (c_11 * (t30 + t62) + t63) * t64;
  const Scalar t66 = Scalar(0.0005396092213171668) * t62 * t22 + t30 * t61 - t65;
  n[11] = -t66;
  const Scalar mr_11_y = Scalar(3.2725991304e-07) * c_11 + Scalar(0.002834045917464) * s_11;
  const Scalar t67 = c_11 * t29 * t64 - (t62 + t29) * t61 - t62 * t28 + t66 - mr_11_y * t63;
  n[10] = -t67;
  const Scalar t68 = (Scalar(3.2725991304e-07) * c_8 - Scalar(0.002834045917464) * s_8) * t57;
  const Scalar t69 = c_8 * t8 * t58 - (t56 + t8) * t55 + t56 * I_8_xy + t60 + t68;
  n[7] = -t69;
  const Scalar mr_5_y = Scalar(3.2725991304e-07) * c_5 + Scalar(0.002834045917464) * s_5;
  const Scalar t70 = c_5 * t40 * t52 - (t50 + t40) * t49 - t50 * t39 + t54 - mr_5_y * t51;
  n[4] = -t70;
  const Scalar t71 = (Scalar(3.2725991304e-07) * c_2 - Scalar(0.002834045917464) * s_2) * t45;
  const Scalar t72 = c_2 * t18 * t46 - (t44 + t18) * t43 + t44 * I_2_xy + t48 + t71;
  n[1] = -t72;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[12]    in   joint positions, rad or m
//   qd[12]   in   joint velocities, rad/s or m/s
//   tau[12]  in   joint torques or forces, N m or N
//   qdd[12]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[0..11], qd[0..11], tau[0..11]. Operations: 276 mul, 184 add, 8 div, 24 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11];
  const Scalar tau_1 = tau[0], tau_2 = tau[1], tau_3 = tau[2], tau_4 = tau[3], tau_5 = tau[4],
      tau_6 = tau[5], tau_7 = tau[6], tau_8 = tau[7], tau_9 = tau[8], tau_10 = tau[9],
      tau_11 = tau[10], tau_12 = tau[11];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6], s_8 = sine[7],
      c_8 = cosine[7], s_9 = sine[8], c_9 = cosine[8], s_10 = sine[9], c_10 = cosine[9],
      s_11 = sine[10], c_11 = cosine[10], s_12 = sine[11], c_12 = cosine[11];
  const Scalar c_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t1 = s_2 * s_3 - c_2 * c_3;
  const Scalar t2 = c_2_3 * t1;
  const Scalar t3 = Scalar(-0.0005396092213171668) * t2;
  const Scalar t4 = qd_1 * qd_1;
  const Scalar t5 = Scalar(-0.000615720268358608) * t1;
  const Scalar t6 = s_2 * t5;
  const Scalar t7 = qd_2 * qd_2;
  const Scalar t8 = Scalar(0.000615720268358608) * c_2_3;
  const Scalar t9 = Scalar(61.3125) * c_1;
  const Scalar t10 = t8 * (c_2 * (t7 + t4) + t9);
  const Scalar t11 = t6 * t7 - t3 * t4 - t10 + tau_3;
  const Scalar mu_3_2_z = Scalar(0.000615720268358608) * c_3 + Scalar(0.0005426192213171668);
  const Scalar t12 = Scalar(1842.912968642313) * mu_3_2_z;
  const Scalar t13 = c_2 * t8;
  const Scalar t14 = Scalar(3.21970574695491e-07) * c_2 - Scalar(0.0022644781431582876) * s_2;
  const Scalar Iu_2_a_yz = Scalar(1.609852873477455e-07) + t6 + t13 + t3 - c_2 * t14;
  const Scalar hu_2_a_z = Scalar(3.2725991304e-07) * c_2 - t8 - Scalar(0.002834045917464) * s_2;
  const Scalar t15 = Scalar(2.0) * qd_2;
  const Scalar beta_3_f = qd_3 + t15;
  const Scalar t16 = qd_3 * beta_3_f;
  const Scalar y_3_2 = t13 * t16 - t6 * t16 - Iu_2_a_yz * t4 + hu_2_a_z * t9 + tau_2 - t12 * t11;
  const Scalar t17 = Scalar(0.4266157182460592) * c_2_3;
  const Scalar t18 = Scalar(6.823068516838894e-08) * c_2 - Scalar(0.00023148988883634047) * c_2_3 +
      mu_3_2_z * t17 - Scalar(0.0007940924716883453) * s_2;
  const Scalar b_3_2_2 = Scalar(0.001231440536717216) * c_3 - mu_3_2_z * t12 +
      Scalar(0.002838197420805067);
  const Scalar d_2 = Scalar(1.0) / b_3_2_2;
  const Scalar t19 = t18 * d_2;
  const Scalar hc_2_x = Scalar(3.2725991304e-07) * s_2 + t5 + Scalar(0.002834045917464) * c_2;
  const Scalar t20 = Scalar(-0.00023148988883634047) * t1;
  const Scalar t21 = (Scalar(6.823068516838894e-08) * s_2 + t20 +
      Scalar(0.0007940924716883453) * c_2) * t7;
  const Scalar t22 = qd_1 * qd_3;
  const Scalar t23 = Scalar(0.001231440536717216) * c_2;
  const Scalar t24 = t20 * t16 + t21 - c_2_3 * t23 * t22 +
      Scalar(0.0010792184426343335) * t2 * t22 - Iu_2_a_yz * qd_1 * t15 +
      Scalar(0.08509272390476785) * c_1 + Scalar(61.3125) * s_1 * hc_2_x - t19 * y_3_2 + t17 * t11 -
      tau_1;
  const Scalar t25 = t18 * t19 + Scalar(0.0006383664465097825) * c_2_3 * c_2_3 + t1 * t23 -
      s_2 * t14 - Scalar(0.0031799702681776175);
  const Scalar qdd_1 = t24 / t25;
  qdd[0] = qdd_1;
  const Scalar c_8_9 = s_8 * c_9 + c_8 * s_9;
  const Scalar t26 = s_8 * s_9 - c_8 * c_9;
  const Scalar t27 = c_8_9 * t26;
  const Scalar t28 = Scalar(-0.0005396092213171668) * t27;
  const Scalar t29 = qd_7 * qd_7;
  const Scalar t30 = Scalar(-0.000615720268358608) * t26;
  const Scalar t31 = s_8 * t30;
  const Scalar t32 = qd_8 * qd_8;
  const Scalar t33 = Scalar(0.000615720268358608) * c_8_9;
  const Scalar t34 = Scalar(61.3125) * c_7;
  const Scalar t35 = t33 * (c_8 * (t32 + t29) + t34);
  const Scalar t36 = t31 * t32 - t28 * t29 - t35 + tau_9;
  const Scalar mu_9_8_z = Scalar(0.000615720268358608) * c_9 + Scalar(0.0005426192213171668);
  const Scalar t37 = Scalar(1842.912968642313) * mu_9_8_z;
  const Scalar t38 = c_8 * t33;
  const Scalar t39 = Scalar(3.21970574695491e-07) * c_8 - Scalar(0.0022644781431582876) * s_8;
  const Scalar Iu_8_a_yz = Scalar(1.609852873477455e-07) + t31 + t38 + t28 - c_8 * t39;
  const Scalar hu_8_a_z = Scalar(3.2725991304e-07) * c_8 - t33 - Scalar(0.002834045917464) * s_8;
  const Scalar t40 = Scalar(2.0) * qd_8;
  const Scalar beta_9_f = qd_9 + t40;
  const Scalar t41 = qd_9 * beta_9_f;
  const Scalar y_9_8 = t38 * t41 - t31 * t41 - Iu_8_a_yz * t29 + hu_8_a_z * t34 + tau_8 - t37 * t36;
  const Scalar t42 = Scalar(0.4266157182460592) * c_8_9;
  const Scalar t43 = Scalar(6.823068516838894e-08) * c_8 - Scalar(0.00023148988883634047) * c_8_9 +
      mu_9_8_z * t42 - Scalar(0.0007940924716883453) * s_8;
  const Scalar b_9_8_8 = Scalar(0.001231440536717216) * c_9 - mu_9_8_z * t37 +
      Scalar(0.002838197420805067);
  const Scalar d_8 = Scalar(1.0) / b_9_8_8;
  const Scalar t44 = t43 * d_8;
  const Scalar hc_8_x = Scalar(3.2725991304e-07) * s_8 + t30 + Scalar(0.002834045917464) * c_8;
  const Scalar t45 = Scalar(-0.00023148988883634047) * t26;
  const Scalar t46 = (Scalar(6.823068516838894e-08) * s_8 + t45 +
      Scalar(0.0007940924716883453) * c_8) * t32;
  const Scalar t47 = qd_7 * qd_9;
  const Scalar t48 = Scalar(0.001231440536717216) * c_8;
  const Scalar t49 = t45 * t41 + t46 - c_8_9 * t48 * t47 +
      Scalar(0.0010792184426343335) * t27 * t47 - Iu_8_a_yz * qd_7 * t40 +
      Scalar(0.08509272390476785) * c_7 + Scalar(61.3125) * s_7 * hc_8_x - t44 * y_9_8 + t42 * t36 -
      tau_7;
  const Scalar t50 = t43 * t44 + Scalar(0.0006383664465097825) * c_8_9 * c_8_9 + t26 * t48 -
      s_8 * t39 - Scalar(0.0031799702681776175);
  const Scalar qdd_7 = t49 / t50;
  qdd[6] = qdd_7;
  const Scalar c_5_6 = s_5 * c_6 + c_5 * s_6;
  const Scalar t51 = s_5 * s_6 - c_5 * c_6;
  const Scalar t52 = c_5_6 * t51;
  const Scalar t53 = Scalar(-0.0005396092213171668) * t52;
  const Scalar t54 = qd_4 * qd_4;
  const Scalar t55 = Scalar(-0.000615720268358608) * t51;
  const Scalar t56 = s_5 * t55;
  const Scalar t57 = qd_5 * qd_5;
  const Scalar t58 = Scalar(0.000615720268358608) * c_5_6;
  const Scalar t59 = Scalar(61.3125) * c_4;
  const Scalar t60 = t58 * (c_5 * (t57 + t54) + t59);
  const Scalar t61 = t56 * t57 - t53 * t54 - t60 + tau_6;
  const Scalar mu_6_5_z = Scalar(0.000615720268358608) * c_6 + Scalar(0.0005426192213171668);
  const Scalar t62 = Scalar(1842.912968642313) * mu_6_5_z;
  const Scalar t63 = c_5 * t58;
  const Scalar I_t5_g = Scalar(3.21970574695491e-07) * c_5 + Scalar(0.0022644781431582876) * s_5;
  const Scalar Iu_5_a_yz = t56 - Scalar(1.609852873477455e-07) + t63 + t53 + c_5 * I_t5_g;
  const Scalar hc_5_y = Scalar(3.2725991304e-07) * c_5 + t58 + Scalar(0.002834045917464) * s_5;
  const Scalar t64 = Scalar(2.0) * qd_5;
  const Scalar beta_6_f = qd_6 + t64;
  const Scalar t65 = qd_6 * beta_6_f;
  const Scalar y_6_5 = t63 * t65 - t56 * t65 - Iu_5_a_yz * t54 - hc_5_y * t59 + tau_5 - t62 * t61;
  const Scalar t66 = Scalar(0.4266157182460592) * c_5_6;
  const Scalar t67 = Scalar(6.823068516838894e-08) * c_5 + Scalar(0.00023148988883634047) * c_5_6 -
      mu_6_5_z * t66 + Scalar(0.0007940924716883453) * s_5;
  const Scalar b_6_5_5 = Scalar(0.001231440536717216) * c_6 - mu_6_5_z * t62 +
      Scalar(0.002838197420805067);
  const Scalar d_5 = Scalar(1.0) / b_6_5_5;
  const Scalar t68 = t67 * d_5;
  const Scalar hc_5_x = t55 - Scalar(3.2725991304e-07) * s_5 + Scalar(0.002834045917464) * c_5;
  const Scalar t69 = Scalar(-0.00023148988883634047) * t51;
  const Scalar Ic_5_xz = t69 - Scalar(6.823068516838894e-08) * s_5 +
      Scalar(0.0007940924716883453) * c_5;
  const Scalar t70 = qd_4 * qd_6;
  const Scalar t71 = Scalar(0.001231440536717216) * c_5;
  const Scalar y_5_4 = t69 * t65 + Ic_5_xz * t57 + c_5_6 * t71 * t70 -
      Scalar(0.0010792184426343335) * t52 * t70 + Iu_5_a_yz * qd_4 * t64 +
      Scalar(0.08509272390476785) * c_4 - Scalar(61.3125) * s_4 * hc_5_x + t68 * y_6_5 + t66 * t61 +
      tau_4;
  const Scalar t72 = t67 * t68 + Scalar(0.0006383664465097825) * c_5_6 * c_5_6 + t51 * t71 +
      s_5 * I_t5_g - Scalar(0.0031799702681776175);
  const Scalar t73 = y_5_4 / t72;
  qdd[3] = -t73;
  const Scalar c_11_12 = s_11 * c_12 + c_11 * s_12;
  const Scalar t74 = s_11 * s_12 - c_11 * c_12;
  const Scalar t75 = c_11_12 * t74;
  const Scalar t76 = Scalar(-0.0005396092213171668) * t75;
  const Scalar t77 = qd_10 * qd_10;
  const Scalar t78 = Scalar(-0.000615720268358608) * t74;
  const Scalar t79 = s_11 * t78;
  const Scalar t80 = qd_11 * qd_11;
  const Scalar t81 = Scalar(0.000615720268358608) * c_11_12;
  const Scalar t82 = Scalar(61.3125) * c_10;
  const Scalar t83 = t81 * (c_11 * (t80 + t77) + t82);
  const Scalar t84 = t79 * t80 - t76 * t77 - t83 + tau_12;
  const Scalar mu_12_11_z = Scalar(0.000615720268358608) * c_12 + Scalar(0.0005426192213171668);
  const Scalar t85 = Scalar(1842.912968642313) * mu_12_11_z;
  const Scalar t86 = c_11 * t81;
  const Scalar I_t11_g = Scalar(3.21970574695491e-07) * c_11 + Scalar(0.0022644781431582876) * s_11;
  const Scalar Iu_11_a_yz = t79 - Scalar(1.609852873477455e-07) + t86 + t76 + c_11 * I_t11_g;
  const Scalar hc_11_y = Scalar(3.2725991304e-07) * c_11 + t81 + Scalar(0.002834045917464) * s_11;
  const Scalar t87 = Scalar(2.0) * qd_11;
  const Scalar beta_12_f = qd_12 + t87;
  const Scalar t88 = qd_12 * beta_12_f;
  const Scalar y_12_11 = t86 * t88 - t79 * t88 - Iu_11_a_yz * t77 - hc_11_y * t82 + tau_11 -
      t85 * t84;
  const Scalar t89 = Scalar(0.4266157182460592) * c_11_12;
  const Scalar t90 = Scalar(6.823068516838894e-08) * c_11 +
      Scalar(0.00023148988883634047) * c_11_12 - mu_12_11_z * t89 +
      Scalar(0.0007940924716883453) * s_11;
  const Scalar b_12_11_11 = Scalar(0.001231440536717216) * c_12 - mu_12_11_z * t85 +
      Scalar(0.002838197420805067);
  const Scalar d_11 = Scalar(1.0) / b_12_11_11;
  const Scalar t91 = t90 * d_11;
  const Scalar hc_11_x = t78 - Scalar(3.2725991304e-07) * s_11 + Scalar(0.002834045917464) * c_11;
  const Scalar t92 = Scalar(-0.00023148988883634047) * t74;
  const Scalar Ic_11_xz = t92 - Scalar(6.823068516838894e-08) * s_11 +
      Scalar(0.0007940924716883453) * c_11;
  const Scalar t93 = qd_10 * qd_12;
  const Scalar t94 = Scalar(0.001231440536717216) * c_11;
  const Scalar y_11_10 = t92 * t88 + Ic_11_xz * t80 + c_11_12 * t94 * t93 -
      Scalar(0.0010792184426343335) * t75 * t93 + Iu_11_a_yz * qd_10 * t87 +
      Scalar(0.08509272390476785) * c_10 - Scalar(61.3125) * s_10 * hc_11_x + t91 * y_12_11 +
      t89 * t84 + tau_10;
  const Scalar t95 = t90 * t91 + Scalar(0.0006383664465097825) * c_11_12 * c_11_12 + t74 * t94 +
      s_11 * I_t11_g - Scalar(0.0031799702681776175);
  const Scalar t96 = y_11_10 / t95;
  qdd[9] = -t96;
  const Scalar qdd_2 = t19 * qdd_1 + d_2 * y_3_2;
  qdd[1] = qdd_2;
  const Scalar qdd_8 = t44 * qdd_7 + d_8 * y_9_8;
  qdd[7] = qdd_8;
  const Scalar t97 = t68 * t73 - d_5 * y_6_5;
  qdd[4] = -t97;
  const Scalar t98 = t91 * t96 - d_11 * y_12_11;
  qdd[10] = -t98;
  qdd[2] = -t17 * qdd_1 - t12 * qdd_2 + Scalar(1842.912968642313) * t11;
  qdd[5] = t62 * t97 - t66 * t73 + Scalar(1842.912968642313) * t61;
  qdd[8] = -t42 * qdd_7 - t37 * qdd_8 + Scalar(1842.912968642313) * t36;
  qdd[11] = t85 * t98 - t89 * t96 + Scalar(1842.912968642313) * t84;
  bool positive = -t25 > Scalar(0.0);
  positive &= b_3_2_2 > Scalar(0.0);
  positive &= -t72 > Scalar(0.0);
  positive &= b_6_5_5 > Scalar(0.0);
  positive &= -t50 > Scalar(0.0);
  positive &= b_9_8_8 > Scalar(0.0);
  positive &= -t95 > Scalar(0.0);
  positive &= b_12_11_11 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[12]   in  joint positions, rad or m
//   qd[12]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads q[1..2], q[4..5], q[7..8], q[10..11], qd[0..11]. Operations: 110 mul, 67 add, 16 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar kinetic_energy(const Scalar* q, const Scalar* qd,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1], qd_3 = qd[2], qd_4 = qd[3], qd_5 = qd[4], qd_6 = qd[5],
      qd_7 = qd[6], qd_8 = qd[7], qd_9 = qd[8], qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<1, 2, 4, 5, 7, 8, 10, 11>(), sine, cosine);
  const Scalar s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2], c_3 = cosine[2], s_5 = sine[4],
      c_5 = cosine[4], s_6 = sine[5], c_6 = cosine[5], s_8 = sine[7], c_8 = cosine[7],
      s_9 = sine[8], c_9 = cosine[8], s_11 = sine[10], c_11 = cosine[10], s_12 = sine[11],
      c_12 = cosine[11];
  const Scalar t1 = s_11 * s_12 - c_11 * c_12;
  const Scalar I_t11_g = Scalar(3.21970574695491e-07) * c_11 + Scalar(0.0022644781431582876) * s_11;
  const Scalar t2 = Scalar(0.001231440536717216) * t1 * (c_11 - Scalar(0.4381934857818318) * t1) +
      (s_11 * I_t11_g - Scalar(0.0022644781431582876));
  const Scalar I_11_yz = Scalar(6.823068516838894e-08) * c_11 +
      Scalar(0.0007940924716883453) * s_11;
  const Scalar t3 = qd_10 * (qd_11 * I_11_yz + qd_10 * t2);
  const Scalar t4 = s_8 * s_9 - c_8 * c_9;
  const Scalar I_8_yy = s_8 * (Scalar(3.21970574695491e-07) * c_8 -
      Scalar(0.0022644781431582876) * s_8) + Scalar(0.0022644781431582876);
  const Scalar t5 = qd_7 * (I_8_yy -
      Scalar(0.001231440536717216) * t4 * (c_8 - Scalar(0.4381934857818318) * t4));
  const Scalar I_8_yz = Scalar(6.823068516838894e-08) * c_8 - Scalar(0.0007940924716883453) * s_8;
  const Scalar t6 = qd_7 * (qd_8 * I_8_yz - t5);
  const Scalar t7 = s_5 * s_6 - c_5 * c_6;
  const Scalar I_t5_g = Scalar(3.21970574695491e-07) * c_5 + Scalar(0.0022644781431582876) * s_5;
  const Scalar t8 = Scalar(0.001231440536717216) * t7 * (c_5 - Scalar(0.4381934857818318) * t7) +
      (s_5 * I_t5_g - Scalar(0.0022644781431582876));
  const Scalar I_5_yz = Scalar(6.823068516838894e-08) * c_5 + Scalar(0.0007940924716883453) * s_5;
  const Scalar t9 = qd_4 * (qd_5 * I_5_yz + qd_4 * t8);
  const Scalar t10 = s_2 * s_3 - c_2 * c_3;
  const Scalar I_2_yy = s_2 * (Scalar(3.21970574695491e-07) * c_2 -
      Scalar(0.0022644781431582876) * s_2) + Scalar(0.0022644781431582876);
  const Scalar t11 = qd_1 * (I_2_yy -
      Scalar(0.001231440536717216) * t10 * (c_2 - Scalar(0.4381934857818318) * t10));
  const Scalar I_2_yz = Scalar(6.823068516838894e-08) * c_2 - Scalar(0.0007940924716883453) * s_2;
  const Scalar t12 = qd_1 * (qd_2 * I_2_yz - t11);
  const Scalar c_11_12 = s_11 * c_12 + c_11 * s_12;
  const Scalar t13 = qd_11 * (c_11 * t1 - s_11 * c_11_12);
  const Scalar omega_12_z = qd_11 + qd_12;
  const Scalar t14 = omega_12_z * (Scalar(0.0005426192213171668) * omega_12_z -
      Scalar(0.00046297977767268094) * c_11_12 * qd_10 - Scalar(0.001231440536717216) * t13);
  const Scalar c_8_9 = s_8 * c_9 + c_8 * s_9;
  const Scalar t15 = qd_8 * (c_8 * t4 - s_8 * c_8_9);
  const Scalar omega_9_z = qd_8 + qd_9;
  const Scalar t16 = omega_9_z * (Scalar(0.00046297977767268094) * c_8_9 * qd_7 +
      Scalar(0.0005426192213171668) * omega_9_z - Scalar(0.001231440536717216) * t15);
  const Scalar c_5_6 = s_5 * c_6 + c_5 * s_6;
  const Scalar t17 = qd_5 * (c_5 * t7 - s_5 * c_5_6);
  const Scalar omega_6_z = qd_5 + qd_6;
  const Scalar t18 = omega_6_z * (Scalar(0.0005426192213171668) * omega_6_z -
      Scalar(0.00046297977767268094) * c_5_6 * qd_4 - Scalar(0.001231440536717216) * t17);
  const Scalar c_2_3 = s_2 * c_3 + c_2 * s_3;
  const Scalar t19 = qd_2 * (c_2 * t10 - s_2 * c_2_3);
  const Scalar omega_3_z = qd_2 + qd_3;
  const Scalar t20 = omega_3_z * (Scalar(0.00046297977767268094) * c_2_3 * qd_1 +
      Scalar(0.0005426192213171668) * omega_3_z - Scalar(0.001231440536717216) * t19);
  const Scalar L_11_z = Scalar(0.0022955781994879005) * qd_11 - qd_10 * I_11_yz;
  const Scalar L_8_z = Scalar(0.0022955781994879005) * qd_8 - qd_7 * I_8_yz;
  const Scalar L_5_z = Scalar(0.0022955781994879005) * qd_5 - qd_4 * I_5_yz;
  const Scalar L_2_z = Scalar(0.0022955781994879005) * qd_2 - qd_1 * I_2_yz;
  const Scalar t21 = qd_4 * qd_4 + qd_1 * qd_1 + qd_10 * qd_10 + qd_7 * qd_7;
  const Scalar T_2 = Scalar(0.00037588290370216287) * t21 + t14 + t16 + t18 + t20 + qd_11 * L_11_z +
      qd_8 * L_8_z + qd_5 * L_5_z + qd_2 * L_2_z - t3 - t6 - t9 - t12;
  return Scalar(0.5) * T_2;
}

// Potential energy of links and rotors (7.36).
//   q[12]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[0..11]. Operations: 22 mul, 19 add, 24 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar potential_energy(const Scalar* q, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6], s_8 = sine[7],
      c_8 = cosine[7], s_9 = sine[8], c_9 = cosine[8], s_10 = sine[9], c_10 = cosine[9],
      s_11 = sine[10], c_11 = cosine[10], s_12 = sine[11], c_12 = cosine[11];
  const Scalar hc_11_y = Scalar(0.0038482516772413) * c_12 + Scalar(0.01771278698415);
  const Scalar t1 = c_10 * (c_11 * hc_11_y -
      s_11 * (Scalar(2.0453744565e-06) + Scalar(0.0038482516772413) * s_12));
  const Scalar hc_8_y = Scalar(0.0038482516772413) * c_9 + Scalar(0.01771278698415);
  const Scalar t2 = c_7 * (c_8 * hc_8_y -
      s_8 * (Scalar(0.0038482516772413) * s_9 - Scalar(2.0453744565e-06)));
  const Scalar hc_5_y = Scalar(0.0038482516772413) * c_6 + Scalar(0.01771278698415);
  const Scalar t3 = c_4 * (c_5 * hc_5_y -
      s_5 * (Scalar(2.0453744565e-06) + Scalar(0.0038482516772413) * s_6));
  const Scalar hc_2_y = Scalar(0.0038482516772413) * c_3 + Scalar(0.01771278698415);
  const Scalar t4 = c_1 * (c_2 * hc_2_y -
      s_2 * (Scalar(0.0038482516772413) * s_3 - Scalar(2.0453744565e-06)));
  const Scalar t5 = (s_7 - s_10) + (s_1 - s_4);
  return Scalar(9.81) * (Scalar(0.0086740799087429) * t5 - t1 - t2 - t3 - t4);
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    1, 0, 1,
    1, 1, 1,
    1, 1, 1};

// Pose of the tip (2.50).
//   q[12]  in   joint positions, rad or m
//   R[9]   out  rotation matrix of the frame in the base frame
//               3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]   out  position of the frame's origin in the base frame, m
// Reads q[9..11]. Operations: 17 mul, 9 add, 6 sin/cos. Always zero: 1 of the 9 entries of R.
template <class Scalar, class SinCos = LibrarySinCos>
inline void forward_kinematics(const Scalar* q, Scalar* R, Scalar* p,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<9, 10, 11>(), sine, cosine);
  const Scalar s_10 = sine[9], c_10 = cosine[9], s_11 = sine[10], c_11 = cosine[10],
      s_12 = sine[11], c_12 = cosine[11];
  R[4] = c_10;
  R[7] = s_10;
  const Scalar t1 = c_11 * s_12;
  const Scalar n_11_t_x = t1 + s_11 * c_12;
  R[2] = n_11_t_x;
  const Scalar t2 = s_11 * s_12;
  const Scalar n_11_a_z = c_11 * c_12 - t2;
  R[0] = n_11_a_z;
  R[3] = s_10 * n_11_t_x;
  R[8] = c_10 * n_11_a_z;
  R[6] = -c_10 * n_11_t_x;
  R[5] = -s_10 * n_11_a_z;
  const Scalar p_12_y = Scalar(0.16) * c_12 + Scalar(0.16);
  const Scalar p_11u_t_y = Scalar(0.16) * t1 + s_11 * p_12_y;
  p[0] = -p_11u_t_y - Scalar(0.1946);
  const Scalar t3 = Scalar(0.16) * t2 - c_11 * p_12_y;
  p[2] = c_10 * t3 - Scalar(0.05945) * s_10;
  p[1] = -(Scalar(0.05945) * c_10 + s_10 * t3) - Scalar(0.0875);
  R[1] = Scalar(0.0);
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[72] = {
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1};

// Geometric Jacobian of the tip (7.14), (7.15).
//   q[12]  in   joint positions, rad or m
//   J[72]  out  geometric Jacobian in base axes: linear rows, then angular
//               6 x 12, row by row: entry (i, j) is J[12 * i + j]
// Reads q[9..11]. Operations: 21 mul, 10 add, 6 sin/cos. Always zero: 59 of the 72 entries of J.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian(const Scalar* q, Scalar* J, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<9, 10, 11>(), sine, cosine);
  const Scalar s_10 = sine[9], c_10 = cosine[9], s_11 = sine[10], c_11 = cosine[10],
      s_12 = sine[11], c_12 = cosine[11];
  J[58] = J[59] = c_10;
  J[70] = J[71] = s_10;
  const Scalar p_12_y = Scalar(0.16) * c_12 + Scalar(0.16);
  const Scalar t1 = Scalar(0.16) * c_11;
  const Scalar t2 = s_12 * t1 + s_11 * p_12_y;
  J[34] = c_10 * t2;
  const Scalar t3 = Scalar(0.16) * s_11;
  const Scalar t4 = s_12 * t3 - c_11 * p_12_y;
  const Scalar J_P10_y = Scalar(0.05945) * s_10 - c_10 * t4;
  J[21] = J_P10_y;
  J[22] = -s_10 * t2;
  const Scalar t5 = t3 - t2;
  J[23] = s_10 * t5;
  const Scalar t6 = Scalar(0.05945) * c_10 + s_10 * t4;
  J[33] = -t6;
  J[35] = -c_10 * t5;
  J[10] = s_10 * t6 - c_10 * J_P10_y;
  J[11] = s_10 * (t6 + s_10 * t1) - c_10 * (J_P10_y - c_10 * t1);
  J[0] = J[1] = J[2] = J[3] = J[4] = J[5] = J[6] = J[7] = Scalar(0.0);
  J[8] = J[9] = J[12] = J[13] = J[14] = J[15] = J[16] = J[17] = Scalar(0.0);
  J[18] = J[19] = J[20] = J[24] = J[25] = J[26] = J[27] = J[28] = Scalar(0.0);
  J[29] = J[30] = J[31] = J[32] = J[36] = J[37] = J[38] = J[39] = Scalar(0.0);
  J[40] = J[41] = J[42] = J[43] = J[44] = J[46] = J[47] = J[48] = Scalar(0.0);
  J[49] = J[50] = J[51] = J[52] = J[53] = J[54] = J[55] = J[56] = Scalar(0.0);
  J[57] = J[60] = J[61] = J[62] = J[63] = J[64] = J[65] = J[66] = Scalar(0.0);
  J[67] = J[68] = J[69] = Scalar(0.0);
  J[45] = Scalar(1.0);
}

// (dJ/dt) qd of the tip.
//   q[12]   in   joint positions, rad or m
//   qd[12]  in   joint velocities, rad/s or m/s
//   a[6]    out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads q[9..11], qd[9..11]. Operations: 51 mul, 21 add, 6 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_10 = qd[9], qd_11 = qd[10], qd_12 = qd[11];
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<9, 10, 11>(), sine, cosine);
  const Scalar s_10 = sine[9], c_10 = cosine[9], s_11 = sine[10], c_11 = cosine[10],
      s_12 = sine[11], c_12 = cosine[11];
  const Scalar t1 = c_11 * s_12 + s_11 * c_12;
  const Scalar omega_12_z = qd_11 + qd_12;
  const Scalar t2 = qd_10 * omega_12_z;
  const Scalar t3 = t1 * t2;
  const Scalar t4 = s_11 * s_12;
  const Scalar t5 = c_11 * c_12;
  const Scalar t6 = t4 - t5;
  const Scalar t7 = t6 * t2;
  const Scalar t8 = s_12 * t3 - c_12 * t7;
  const Scalar t9 = s_12 * t7 + c_12 * t3;
  a[3] = s_11 * t8 - c_11 * t9;
  const Scalar t10 = s_11 * t9 + c_11 * t8;
  a[5] = c_10 * t10;
  a[4] = -s_10 * t10;
  const Scalar t11 = qd_10 * qd_10;
  const Scalar t12 = t11 * (t6 * t6 - c_11 * t4) + omega_12_z * omega_12_z;
  const Scalar t13 = c_11 * c_11 * t11 + qd_11 * qd_11;
  const Scalar t14 = Scalar(0.16) * c_12 * t13 + Scalar(0.16) * t12;
  const Scalar t15 = s_11 * t11 * t5 + s_12 * t13;
  const Scalar t16 = Scalar(0.16) * t15 - Scalar(0.16) * t11 * t6 * t1;
  const Scalar t17 = s_12 * t16 + c_12 * t14;
  const Scalar t18 = s_12 * t14 - c_12 * t16;
  a[0] = s_11 * t17 + c_11 * t18;
  const Scalar t19 = s_11 * t18 - c_11 * t17;
  const Scalar t20 = Scalar(0.05945) * t11 - Scalar(0.32) * (s_11 * qd_10 * qd_11 + t3);
  a[1] = s_10 * t19 + c_10 * t20;
  a[2] = s_10 * t20 - c_10 * t19;
}

// The functions by type, with the shapes of their arguments: what adapters such as
// flatdyn/eigen.hpp are given.
namespace functions {

struct inverse_dynamics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[12], const Scalar (&qd)[12], const Scalar (&qdd)[12],
      Scalar (&tau)[12]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::quadruped12::inverse_dynamics(of...); }
};

struct inverse_dynamics_tip_force {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[12], const Scalar (&qd)[12], const Scalar (&qdd)[12],
      const Scalar (&h_e)[6], Scalar (&tau)[12]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept {
    return ::quadruped12::inverse_dynamics_tip_force(of...);
  }
};

struct inertia_matrix {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[12], Scalar (&B)[12][12]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::quadruped12::inertia_matrix(of...); }
};

struct christoffel {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[12], Scalar (&c)[12][78]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::quadruped12::christoffel(of...); }
};

struct coriolis_matrix {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[12], const Scalar (&qd)[12], Scalar (&C)[12][12]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::quadruped12::coriolis_matrix(of...); }
};

struct gravity {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[12], Scalar (&g)[12]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::quadruped12::gravity(of...); }
};

struct bias {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[12], const Scalar (&qd)[12], Scalar (&n)[12]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::quadruped12::bias(of...); }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[12], const Scalar (&qd)[12], const Scalar (&tau)[12],
      Scalar (&qdd)[12]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::quadruped12::forward_dynamics(of...); }
};

struct kinetic_energy {
  template <class Scalar>
  using Shape = Scalar(const Scalar (&q)[12], const Scalar (&qd)[12]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::quadruped12::kinetic_energy(of...); }
};

struct potential_energy {
  template <class Scalar>
  using Shape = Scalar(const Scalar (&q)[12]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::quadruped12::potential_energy(of...); }
};

struct forward_kinematics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[12], Scalar (&R)[3][3], Scalar (&p)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::quadruped12::forward_kinematics(of...); }
};

struct jacobian {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[12], Scalar (&J)[6][12]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::quadruped12::jacobian(of...); }
};

struct jacobian_dot_qd {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[12], const Scalar (&qd)[12], Scalar (&a)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::quadruped12::jacobian_dot_qd(of...); }
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

}  // namespace quadruped12

#endif  // FLATDYN_QUADRUPED12_HPP_21DA106A

// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "andrews_squeezer" as flat code: 7 joints, 1 of them independent.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Input: sha1:72fbf573832cb7b54aa7054d30f9cfa576d70314
//
//   q  qd  joint    moves link  type      unit
//   0  0   beta     K1          revolute  rad
//   1  -   Theta    K2          revolute  rad
//   2  -   gamma    K3          revolute  rad
//   3  -   delta    K5          revolute  rad
//   4  -   Phi      K4          revolute  rad
//   5  -   epsilon  K7          revolute  rad
//   6  -   Omega    K6          revolute  rad
//
// Gravity is (0, 0, 0) m/s^2 in the base frame. The tip belongs to link "K3". Closed loops make
// Theta, gamma, delta, Phi, epsilon, Omega follow from the other joints: q has the positions of all
// of them, qd, qdd and tau are those of the others. Functions hold where q closes the loops. Names
// with lk belong to loop k: R_lk, p_lk and r_lk to the way from its carrier to its two ends, Phi_lk
// to its closure's derivative by q, inv_lk is the reciprocal of the determinant that its joints are
// found with, and regular_lk is positive unless the loop is singular. A_i_j is how joint i moves
// with the joint of qd[j - 1], drift how it accelerates if that one does not.
//
// Every function is a template over its scalar: float, double, or any type that is made from a
// double, has + - * / (also - of one), comparisons, and sin, cos where argument-dependent lookup
// finds them (or an argument that knows them, see LibrarySinCos). Arguments are plain arrays:
//
//   double q[7] = {}, qd[1] = {}, qdd[1] = {}, tau[1];
//   const bool result = andrews_squeezer::inverse_dynamics(q, qd, qdd, tau);
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

#ifndef FLATDYN_ANDREWS_SQUEEZER_HPP_78710CB4
#define FLATDYN_ANDREWS_SQUEEZER_HPP_78710CB4

#include <cmath>

namespace andrews_squeezer {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 1;
inline constexpr int position_count = 7;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {"beta"};

// The joints of q.
inline constexpr const char* position_names[position_count] = {
    "beta", "Theta", "gamma", "delta", "Phi", "epsilon", "Omega"};

// The entries of q that qd, qdd and tau belong to.
inline constexpr int independent_positions[joint_count] = {0};

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
//   qd[1]   in   joint velocities, rad/s or m/s
//   qdd[1]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[1]  out  joint torques, N m (forces, N, for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..6], qd[0], qdd[0]. Operations: 142 mul, 77 add, 3 div, 14 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar qdd_1 = qdd[0];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = Scalar(0.7) * s_1;
  const Scalar t2 = Scalar(0.7) * c_1;
  const Scalar R_l1a21_x = c_2 * t1 + s_2 * t2;
  const Scalar t3 = Scalar(0.875) * s_3;
  const Scalar t4 = s_2 * t1 - c_2 * t2;
  const Scalar t5 = Scalar(0.875) * c_3;
  const Scalar t6 = R_l1a21_x * t3 - t4 * t5;
  const Scalar t7 = Scalar(1.0) / t6;
  const Scalar t8 = Scalar(0.175) * s_1;
  const Scalar t9 = R_l1a21_x - t8;
  const Scalar t10 = Scalar(0.175) * c_1;
  const Scalar t11 = t10 + t4;
  const Scalar t12 = t7 * (t9 * t3 - t11 * t5);
  const Scalar t13 = t12 - Scalar(1.0);
  const Scalar t14 = t13 * t13;
  const Scalar t15 = qd_1 * qd_1;
  const Scalar t16 = (t8 - R_l1a21_x * t14) * t15;
  const Scalar t17 = t4 * t9 - R_l1a21_x * t11;
  const Scalar t18 = t7 * t17;
  const Scalar t19 = t18 * t15 * t18;
  const Scalar t20 = t5 * t19 + t16;
  const Scalar t21 = (t10 + t4 * t14) * t15;
  const Scalar t22 = t21 - t3 * t19;
  const Scalar t23 = t7 * (t5 * t20 - t3 * t22);
  const Scalar t24 = t16 + t4 * t23;
  const Scalar t25 = t11 - t4 * t12;
  const Scalar t26 = Scalar(0.5) * s_6;
  const Scalar t27 = Scalar(0.5) * c_6;
  const Scalar R_l3b71_x = c_7 * t26 + s_7 * t27;
  const Scalar t28 = t9 - R_l1a21_x * t12;
  const Scalar t29 = s_7 * t26 - c_7 * t27;
  const Scalar t30 = R_l3b71_x * t25 - t29 * t28;
  const Scalar J_l3b6_y = s_6 - t29;
  const Scalar J_l3b6_x = c_6 - R_l3b71_x;
  const Scalar t31 = J_l3b6_y * t28 - J_l3b6_x * t25;
  const Scalar t32 = t30 - t31;
  const Scalar t33 = t32 * t32;
  const Scalar t34 = t30 * t30;
  const Scalar t35 = R_l3b71_x * J_l3b6_y - t29 * J_l3b6_x;
  const Scalar t36 = Scalar(1.0) / t35;
  const Scalar t37 = t36 * t15;
  const Scalar t38 = t36 * t37;
  const Scalar t39 = t24 - t38 * (R_l3b71_x * t33 - c_6 * t34);
  const Scalar t40 = t21 + R_l1a21_x * t23;
  const Scalar t41 = t40 + (t29 * t33 - s_6 * t34) * t38;
  const Scalar t42 = (R_l3b71_x * t39 - t29 * t41) - t30 * qdd_1;
  const Scalar t43 = t36 * (c_7 * t34 * t37 + s_7 * t42);
  const Scalar t44 = t36 * t42;
  const Scalar t45 = t44 + t36 * (t31 * qdd_1 - J_l3b6_y * t41 + J_l3b6_x * t39);
  const Scalar t46 = Scalar(8.03380146e-07) * t45 - Scalar(1.635096e-06) * t43;
  const Scalar t47 = s_7 * t45 - c_7 * t33 * t38;
  const Scalar t48 = t31 * t46 - t30 *
      (t46 - Scalar(1.635096e-06) * t47 + Scalar(0.00003981529833) * t44);
  const Scalar t49 = Scalar(0.5) * s_4;
  const Scalar t50 = Scalar(0.5) * c_4;
  const Scalar t51 = s_5 * t49 - c_5 * t50;
  const Scalar R_l2b51_x = c_5 * t49 + s_5 * t50;
  const Scalar t52 = t51 * t25 + R_l2b51_x * t28;
  const Scalar J_l2b4_y = R_l2b51_x + c_4;
  const Scalar t53 = t51 + s_4;
  const Scalar t54 = J_l2b4_y * t28 + t53 * t25;
  const Scalar t55 = t52 - t54;
  const Scalar t56 = t55 * t55;
  const Scalar t57 = t52 * t52;
  const Scalar t58 = t51 * J_l2b4_y - R_l2b51_x * t53;
  const Scalar t59 = Scalar(1.0) / t58;
  const Scalar t60 = t59 * t15;
  const Scalar t61 = t59 * t60;
  const Scalar t62 = t24 - t61 * (s_4 * t57 + t51 * t56);
  const Scalar t63 = t40 - (c_4 * t57 + R_l2b51_x * t56) * t61;
  const Scalar t64 = (t51 * t62 + R_l2b51_x * t63) - t52 * qdd_1;
  const Scalar t65 = t59 * (c_5 * t57 * t60 + s_5 * t64);
  const Scalar t66 = t59 * t64;
  const Scalar t67 = t66 + t59 * (t54 * qdd_1 - J_l2b4_y * t63 - t53 * t62);
  const Scalar t68 = Scalar(8.03380146e-07) * t67 + Scalar(1.635096e-06) * t65;
  const Scalar t69 = c_5 * t56 * t61 - s_5 * t67;
  const Scalar t70 = t54 * t68 - t52 *
      (t68 - Scalar(1.635096e-06) * t69 + Scalar(0.000066455736) * t66);
  const Scalar t71 = qdd_1 * t13 + t23;
  const Scalar t72 = s_2 * t15;
  const Scalar t73 = t14 * t72 + c_2 * t71;
  const Scalar t74 = t13 * (Scalar(2.93825e-07) * (t72 + c_2 * qdd_1) + Scalar(9.237125e-07) * t71);
  const Scalar t75 = t7 * t18 * (t17 * qdd_1 + R_l1a21_x * t20 - t4 * t22);
  tau[0] = Scalar(2.93825e-07) * t73 + Scalar(2.4094568e-06) * qdd_1 + t74 +
      Scalar(0.000016170147425) * t75 + t36 * t48 + t59 * t70;
  const Scalar regular_l1 = t6 * t6 - Scalar(3.7515625e-13);
  const Scalar regular_l2 = t58 * t58 - Scalar(6.25e-13);
  const Scalar regular_l3 = t35 * t35 - Scalar(6.25e-13);
  bool positive = regular_l1 > Scalar(0.0);
  positive &= regular_l2 > Scalar(0.0);
  positive &= regular_l3 > Scalar(0.0);
  return positive;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[7]    in   joint positions, rad or m
//   qd[1]   in   joint velocities, rad/s or m/s
//   qdd[1]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[1]  out  joint torques, N m (forces, N, for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..6], qd[0], qdd[0], h_e[0..1], h_e[5]. Operations: 152 mul, 82 add, 3 div, 14 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool inverse_dynamics_tip_force(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    const Scalar* h_e, Scalar* tau, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar qdd_1 = qdd[0];
  const Scalar h_e_1 = h_e[0], h_e_2 = h_e[1], h_e_6 = h_e[5];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = Scalar(0.028) * s_1;
  const Scalar t2 = Scalar(0.028) * c_1;
  const Scalar R_l1a21_x = c_2 * t1 + s_2 * t2;
  const Scalar t3 = Scalar(0.035) * s_3;
  const Scalar t4 = s_2 * t1 - c_2 * t2;
  const Scalar t5 = Scalar(0.035) * c_3;
  const Scalar t6 = R_l1a21_x * t3 - t4 * t5;
  const Scalar t7 = Scalar(1.0) / t6;
  const Scalar t8 = Scalar(0.007) * s_1;
  const Scalar t9 = R_l1a21_x - t8;
  const Scalar t10 = Scalar(0.007) * c_1;
  const Scalar t11 = t10 + t4;
  const Scalar t12 = t7 * (t9 * t3 - t11 * t5);
  const Scalar t13 = t12 - Scalar(1.0);
  const Scalar t14 = t13 * t13;
  const Scalar t15 = qd_1 * qd_1;
  const Scalar t16 = (t8 - R_l1a21_x * t14) * t15;
  const Scalar t17 = t4 * t9 - R_l1a21_x * t11;
  const Scalar t18 = t7 * t17;
  const Scalar t19 = t18 * t15 * t18;
  const Scalar t20 = t5 * t19 + t16;
  const Scalar t21 = (t10 + t4 * t14) * t15;
  const Scalar t22 = t21 - t3 * t19;
  const Scalar t23 = t7 * (t5 * t20 - t3 * t22);
  const Scalar t24 = t16 + t4 * t23;
  const Scalar t25 = t11 - t4 * t12;
  const Scalar t26 = Scalar(0.02) * s_6;
  const Scalar t27 = Scalar(0.02) * c_6;
  const Scalar R_l3b71_x = c_7 * t26 + s_7 * t27;
  const Scalar t28 = t9 - R_l1a21_x * t12;
  const Scalar t29 = s_7 * t26 - c_7 * t27;
  const Scalar t30 = R_l3b71_x * t25 - t29 * t28;
  const Scalar t31 = Scalar(0.04) * s_6;
  const Scalar t32 = t29 - t31;
  const Scalar t33 = Scalar(0.04) * c_6;
  const Scalar t34 = R_l3b71_x - t33;
  const Scalar t35 = t32 * t28 - t34 * t25;
  const Scalar t36 = t30 + t35;
  const Scalar t37 = t36 * t36;
  const Scalar t38 = t30 * t30;
  const Scalar t39 = R_l3b71_x * t32 - t29 * t34;
  const Scalar t40 = Scalar(1.0) / t39;
  const Scalar t41 = t40 * t15;
  const Scalar t42 = t40 * t41;
  const Scalar t43 = t24 - t42 * (R_l3b71_x * t37 - t33 * t38);
  const Scalar t44 = t21 + R_l1a21_x * t23;
  const Scalar t45 = t44 + (t29 * t37 - t31 * t38) * t42;
  const Scalar t46 = (R_l3b71_x * t43 - t29 * t45) - t30 * qdd_1;
  const Scalar t47 = t40 * (s_7 * t46 - c_7 * t38 * t41);
  const Scalar t48 = t40 * t46;
  const Scalar t49 = t40 * (t35 * qdd_1 - t32 * t45 + t34 * t43) - t48;
  const Scalar t50 = Scalar(8.03380146e-07) * t49 + Scalar(1.635096e-06) * t47;
  const Scalar t51 = s_7 * t49 - c_7 * t37 * t42;
  const Scalar t52 = t35 * t50 - t30 *
      (Scalar(1.635096e-06) * t51 - t50 + Scalar(0.00003981529833) * t48);
  const Scalar t53 = Scalar(0.02) * s_4;
  const Scalar t54 = Scalar(0.02) * c_4;
  const Scalar t55 = s_5 * t53 - c_5 * t54;
  const Scalar R_l2b51_x = c_5 * t53 + s_5 * t54;
  const Scalar t56 = t55 * t25 + R_l2b51_x * t28;
  const Scalar t57 = Scalar(0.04) * c_4;
  const Scalar J_l2b4_y = R_l2b51_x + t57;
  const Scalar t58 = Scalar(0.04) * s_4;
  const Scalar t59 = t55 + t58;
  const Scalar t60 = J_l2b4_y * t28 + t59 * t25;
  const Scalar t61 = t56 - t60;
  const Scalar t62 = t61 * t61;
  const Scalar t63 = t56 * t56;
  const Scalar t64 = t55 * J_l2b4_y - R_l2b51_x * t59;
  const Scalar t65 = Scalar(1.0) / t64;
  const Scalar t66 = t65 * t15;
  const Scalar t67 = t65 * t66;
  const Scalar t68 = t24 - t67 * (t58 * t63 + t55 * t62);
  const Scalar t69 = t44 - (t57 * t63 + R_l2b51_x * t62) * t67;
  const Scalar t70 = (t55 * t68 + R_l2b51_x * t69) - t56 * qdd_1;
  const Scalar t71 = t65 * (c_5 * t63 * t66 + s_5 * t70);
  const Scalar t72 = t65 * t70;
  const Scalar t73 = t72 + t65 * (t60 * qdd_1 - J_l2b4_y * t69 - t59 * t68);
  const Scalar t74 = Scalar(8.03380146e-07) * t73 + Scalar(1.635096e-06) * t71;
  const Scalar t75 = c_5 * t62 * t67 - s_5 * t73;
  const Scalar t76 = t60 * t74 - t56 *
      (t74 - Scalar(1.635096e-06) * t75 + Scalar(0.000066455736) * t72);
  const Scalar t77 = qdd_1 * t13 + t23;
  const Scalar t78 = s_2 * t15;
  const Scalar t79 = t14 * t78 + c_2 * t77;
  const Scalar t80 = t13 * (Scalar(2.93825e-07) * (t78 + c_2 * qdd_1) + Scalar(9.237125e-07) * t77);
  const Scalar t81 = t7 * (t17 * qdd_1 + R_l1a21_x * t20 - t4 * t22);
  const Scalar f_e3_x = s_3 * h_e_2 + c_3 * h_e_1;
  const Scalar t82 = s_3 * h_e_1 - c_3 * h_e_2;
  const Scalar mu_3_z = Scalar(0.018) * f_e3_x - Scalar(0.000016170147425) * t81 -
      Scalar(0.02) * t82 + h_e_6;
  tau[0] = Scalar(2.93825e-07) * t79 + Scalar(2.4094568e-06) * qdd_1 + t80 + t40 * t52 + t65 * t76 -
      t18 * mu_3_z;
  const Scalar regular_l1 = t6 * t6 - Scalar(9.604e-19);
  const Scalar regular_l2 = t64 * t64 - Scalar(1.6e-18);
  const Scalar regular_l3 = t39 * t39 - Scalar(1.6e-18);
  bool positive = regular_l1 > Scalar(0.0);
  positive &= regular_l2 > Scalar(0.0);
  positive &= regular_l3 > Scalar(0.0);
  return positive;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[1] = {
    1};

// Joint-space inertia matrix B(q) (7.32).
//   q[7]  in   joint positions, rad or m
//   B[1]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//              1 x 1, row by row: entry (i, j) is B[1 * i + j]
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..6]. Operations: 73 mul, 43 add, 3 div, 14 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool inertia_matrix(const Scalar* q, Scalar* B, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = Scalar(0.7) * c_1;
  const Scalar t2 = Scalar(0.7) * s_1;
  const Scalar t3 = c_2 * t1 - s_2 * t2;
  const Scalar t4 = Scalar(0.875) * c_3;
  const Scalar R_l1a21_x = s_2 * t1 + c_2 * t2;
  const Scalar t5 = Scalar(0.875) * s_3;
  const Scalar t6 = t3 * t4 + R_l1a21_x * t5;
  const Scalar t7 = Scalar(1.0) / t6;
  const Scalar p_l1ae_x = Scalar(0.175) * c_1 - t3;
  const Scalar p_l1ae_y = Scalar(0.175) * s_1 - R_l1a21_x;
  const Scalar t8 = p_l1ae_x * t4 + p_l1ae_y * t5;
  const Scalar t9 = t7 * t8;
  const Scalar G_1r2_1 = p_l1ae_y - R_l1a21_x * t9;
  const Scalar t10 = Scalar(0.5) * c_4;
  const Scalar t11 = Scalar(0.5) * s_4;
  const Scalar R_l2b51_x = s_5 * t10 + c_5 * t11;
  const Scalar t12 = p_l1ae_x - t3 * t9;
  const Scalar t13 = c_5 * t10 - s_5 * t11;
  const Scalar t14 = R_l2b51_x * G_1r2_1 + t13 * t12;
  const Scalar Ic_4_zz = Scalar(3.270192e-06) * s_5 + Scalar(0.000067259116146);
  const Scalar t15 = s_4 - t13;
  const Scalar J_l2b4_y = R_l2b51_x + c_4;
  const Scalar t16 = t15 * t12 - J_l2b4_y * G_1r2_1;
  const Scalar mu_5_4_z = Scalar(8.03380146e-07) + Scalar(1.635096e-06) * s_5;
  const Scalar t17 = t14 * (mu_5_4_z * t16 + Ic_4_zz * t14);
  const Scalar t18 = R_l2b51_x * t15 + t13 * J_l2b4_y;
  const Scalar t19 = Scalar(1.0) / t18;
  const Scalar t20 = t19 * t19 * (t16 * (Scalar(8.03380146e-07) * t16 + mu_5_4_z * t14) + t17);
  const Scalar t21 = Scalar(0.5) * c_6;
  const Scalar t22 = Scalar(0.5) * s_6;
  const Scalar t23 = c_7 * t21 - s_7 * t22;
  const Scalar R_l3b71_x = s_7 * t21 + c_7 * t22;
  const Scalar t24 = t23 * G_1r2_1 - R_l3b71_x * t12;
  const Scalar J_l3b6_x = c_6 - R_l3b71_x;
  const Scalar J_l3b6_y = t23 + s_6;
  const Scalar G_1_7n = J_l3b6_x * t12 + J_l3b6_y * G_1r2_1;
  const Scalar t25 = Scalar(1.635096e-06) * s_7 - Scalar(8.03380146e-07);
  const Scalar t26 = t24 * ((Scalar(3.270192e-06) * s_7 - Scalar(0.000040618678476)) * t24 -
      t25 * G_1_7n);
  const Scalar t27 = t23 * J_l3b6_x + R_l3b71_x * J_l3b6_y;
  const Scalar t28 = Scalar(1.0) / t27;
  const Scalar t29 = t28 * t28 * (t26 - G_1_7n * (Scalar(8.03380146e-07) * G_1_7n + t25 * t24));
  const Scalar t30 = Scalar(5.8765e-07) * c_2;
  const Scalar t31 = t8 * (Scalar(9.237125e-07) * t9 - t30 + Scalar(1.847425e-06));
  const Scalar t32 = R_l1a21_x * p_l1ae_x - t3 * p_l1ae_y;
  const Scalar t33 = t7 * (t31 + Scalar(0.000016170147425) * t7 * t32 * t32);
  B[0] = Scalar(3.3331693e-06) - t30 + t33 + t20 - t29;
  const Scalar regular_l1 = t6 * t6 - Scalar(3.7515625e-13);
  const Scalar regular_l2 = t18 * t18 - Scalar(6.25e-13);
  const Scalar regular_l3 = t27 * t27 - Scalar(6.25e-13);
  bool positive = regular_l1 > Scalar(0.0);
  positive &= regular_l2 > Scalar(0.0);
  positive &= regular_l3 > Scalar(0.0);
  return positive;
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[1] = {
    1};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[7]  in   joint positions, rad or m
//   c[1]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//              c_ijk = c_ikj is c[1 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..6]. Operations: 125 mul, 66 add, 3 div, 14 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool christoffel(const Scalar* q, Scalar* c, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = Scalar(0.7) * s_1;
  const Scalar t2 = Scalar(0.7) * c_1;
  const Scalar R_l1a21_x = c_2 * t1 + s_2 * t2;
  const Scalar t3 = Scalar(0.875) * s_3;
  const Scalar t4 = s_2 * t1 - c_2 * t2;
  const Scalar t5 = Scalar(0.875) * c_3;
  const Scalar t6 = R_l1a21_x * t3 - t4 * t5;
  const Scalar t7 = Scalar(1.0) / t6;
  const Scalar t8 = Scalar(0.175) * s_1;
  const Scalar t9 = R_l1a21_x - t8;
  const Scalar t10 = Scalar(0.175) * c_1;
  const Scalar t11 = t10 + t4;
  const Scalar t12 = t9 * t3 - t11 * t5;
  const Scalar t13 = t7 * t12;
  const Scalar t14 = t13 - Scalar(1.0);
  const Scalar t15 = t14 * t14;
  const Scalar t16 = t8 - R_l1a21_x * t15;
  const Scalar t17 = t7 * (t4 * t9 - R_l1a21_x * t11);
  const Scalar t18 = t17 * t17;
  const Scalar H_1_1r1_2 = t5 * t18 + t16;
  const Scalar t19 = t10 + t4 * t15;
  const Scalar H_1_1r1_1 = t19 - t3 * t18;
  const Scalar t20 = t5 * H_1_1r1_2 - t3 * H_1_1r1_1;
  const Scalar t21 = t7 * t20;
  const Scalar t22 = t19 + R_l1a21_x * t21;
  const Scalar t23 = t11 - t4 * t13;
  const Scalar t24 = Scalar(0.5) * s_6;
  const Scalar t25 = Scalar(0.5) * c_6;
  const Scalar R_l3b71_x = c_7 * t24 + s_7 * t25;
  const Scalar t26 = t9 - R_l1a21_x * t13;
  const Scalar t27 = s_7 * t24 - c_7 * t25;
  const Scalar t28 = R_l3b71_x * t23 - t27 * t26;
  const Scalar J_l3b6_y = s_6 - t27;
  const Scalar J_l3b6_x = c_6 - R_l3b71_x;
  const Scalar t29 = J_l3b6_y * t26 - J_l3b6_x * t23;
  const Scalar t30 = t28 - t29;
  const Scalar t31 = t30 * t30;
  const Scalar t32 = t28 * t28;
  const Scalar t33 = R_l3b71_x * J_l3b6_y - t27 * J_l3b6_x;
  const Scalar t34 = Scalar(1.0) / t33;
  const Scalar t35 = t34 * t34;
  const Scalar H_1_1r3_1 = t22 + (t27 * t31 - s_6 * t32) * t35;
  const Scalar t36 = t16 + t4 * t21;
  const Scalar H_1_1r3_2 = t36 - t35 * (R_l3b71_x * t31 - c_6 * t32);
  const Scalar t37 = Scalar(8.17548e-07) * s_7 - Scalar(4.01690073e-07);
  const Scalar t38 = (Scalar(4.01690073e-07) * t29 + t37 * t28) *
      (J_l3b6_y * H_1_1r3_1 - J_l3b6_x * H_1_1r3_2);
  const Scalar t39 = t37 * t29 - (Scalar(1.635096e-06) * s_7 - Scalar(0.000020309339238)) * t28;
  const Scalar t40 = t35 * (t38 + t39 * (R_l3b71_x * H_1_1r3_2 - t27 * H_1_1r3_1));
  const Scalar t41 = Scalar(0.5) * s_4;
  const Scalar t42 = Scalar(0.5) * c_4;
  const Scalar t43 = s_5 * t41 - c_5 * t42;
  const Scalar R_l2b51_x = c_5 * t41 + s_5 * t42;
  const Scalar t44 = t43 * t23 + R_l2b51_x * t26;
  const Scalar J_l2b4_y = R_l2b51_x + c_4;
  const Scalar t45 = t43 + s_4;
  const Scalar t46 = J_l2b4_y * t26 + t45 * t23;
  const Scalar t47 = t44 - t46;
  const Scalar t48 = t47 * t47;
  const Scalar t49 = t44 * t44;
  const Scalar t50 = t43 * J_l2b4_y - R_l2b51_x * t45;
  const Scalar t51 = Scalar(1.0) / t50;
  const Scalar t52 = t51 * t51;
  const Scalar H_1_1r2_1 = t22 - (c_4 * t49 + R_l2b51_x * t48) * t52;
  const Scalar H_1_1r2_2 = t36 - t52 * (s_4 * t49 + t43 * t48);
  const Scalar H_1_1_5n = J_l2b4_y * H_1_1r2_1 + t45 * H_1_1r2_2;
  const Scalar mu_5_4_z = Scalar(4.01690073e-07) + Scalar(8.17548e-07) * s_5;
  const Scalar Ic_4_zz = Scalar(1.635096e-06) * s_5 + Scalar(0.000033629558073);
  const Scalar t53 = (mu_5_4_z * t46 - Ic_4_zz * t44) * (t43 * H_1_1r2_2 + R_l2b51_x * H_1_1r2_1);
  const Scalar t54 = t40 + t52 * ((Scalar(4.01690073e-07) * t46 - mu_5_4_z * t44) * H_1_1_5n - t53);
  const Scalar H_1_1_3n = R_l1a21_x * H_1_1r1_2 - t4 * H_1_1r1_1;
  const Scalar t55 = (Scalar(2.93825e-07) * c_2 + Scalar(9.237125e-07) * t14) * t20;
  const Scalar t56 = Scalar(2.93825e-07) * s_2 * t12 * t14 + t55 +
      Scalar(0.000016170147425) * t17 * H_1_1_3n;
  const Scalar t57 = c_5 * t51 * t44 * t46 * t47 * t52;
  const Scalar t58 = t57 - c_7 * t34 * t28 * t29 * t30 * t35;
  c[0] = t7 * t56 - Scalar(1.635096e-06) * t58 - Scalar(2.0) * t54;
  const Scalar regular_l1 = t6 * t6 - Scalar(3.7515625e-13);
  const Scalar regular_l2 = t50 * t50 - Scalar(6.25e-13);
  const Scalar regular_l3 = t33 * t33 - Scalar(6.25e-13);
  bool positive = regular_l1 > Scalar(0.0);
  positive &= regular_l2 > Scalar(0.0);
  positive &= regular_l3 > Scalar(0.0);
  return positive;
}

// The entries of C in coriolis_matrix that are not always zero.
inline constexpr bool coriolis_matrix_nonzero[1] = {
    1};

// C(q, qd) from the Christoffel symbols (7.44).
//   q[7]   in   joint positions, rad or m
//   qd[1]  in   joint velocities, rad/s or m/s
//   C[1]   out  c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric
//               1 x 1, row by row: entry (i, j) is C[1 * i + j]
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..6], qd[0]. Operations: 126 mul, 66 add, 3 div, 14 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = Scalar(0.7) * s_1;
  const Scalar t2 = Scalar(0.7) * c_1;
  const Scalar R_l1a21_x = c_2 * t1 + s_2 * t2;
  const Scalar t3 = Scalar(0.875) * s_3;
  const Scalar t4 = s_2 * t1 - c_2 * t2;
  const Scalar t5 = Scalar(0.875) * c_3;
  const Scalar t6 = R_l1a21_x * t3 - t4 * t5;
  const Scalar t7 = Scalar(1.0) / t6;
  const Scalar t8 = Scalar(0.175) * s_1;
  const Scalar t9 = R_l1a21_x - t8;
  const Scalar t10 = Scalar(0.175) * c_1;
  const Scalar t11 = t10 + t4;
  const Scalar t12 = t9 * t3 - t11 * t5;
  const Scalar t13 = t7 * t12;
  const Scalar t14 = t13 - Scalar(1.0);
  const Scalar t15 = t14 * t14;
  const Scalar t16 = t8 - R_l1a21_x * t15;
  const Scalar t17 = t7 * (t4 * t9 - R_l1a21_x * t11);
  const Scalar t18 = t17 * t17;
  const Scalar H_1_1r1_2 = t5 * t18 + t16;
  const Scalar t19 = t10 + t4 * t15;
  const Scalar H_1_1r1_1 = t19 - t3 * t18;
  const Scalar t20 = t5 * H_1_1r1_2 - t3 * H_1_1r1_1;
  const Scalar t21 = t7 * t20;
  const Scalar t22 = t19 + R_l1a21_x * t21;
  const Scalar t23 = t11 - t4 * t13;
  const Scalar t24 = Scalar(0.5) * s_6;
  const Scalar t25 = Scalar(0.5) * c_6;
  const Scalar R_l3b71_x = c_7 * t24 + s_7 * t25;
  const Scalar t26 = t9 - R_l1a21_x * t13;
  const Scalar t27 = s_7 * t24 - c_7 * t25;
  const Scalar t28 = R_l3b71_x * t23 - t27 * t26;
  const Scalar J_l3b6_y = s_6 - t27;
  const Scalar J_l3b6_x = c_6 - R_l3b71_x;
  const Scalar t29 = J_l3b6_y * t26 - J_l3b6_x * t23;
  const Scalar t30 = t28 - t29;
  const Scalar t31 = t30 * t30;
  const Scalar t32 = t28 * t28;
  const Scalar t33 = R_l3b71_x * J_l3b6_y - t27 * J_l3b6_x;
  const Scalar t34 = Scalar(1.0) / t33;
  const Scalar t35 = t34 * t34;
  const Scalar H_1_1r3_1 = t22 + (t27 * t31 - s_6 * t32) * t35;
  const Scalar t36 = t16 + t4 * t21;
  const Scalar H_1_1r3_2 = t36 - t35 * (R_l3b71_x * t31 - c_6 * t32);
  const Scalar t37 = Scalar(8.17548e-07) * s_7 - Scalar(4.01690073e-07);
  const Scalar t38 = (Scalar(4.01690073e-07) * t29 + t37 * t28) *
      (J_l3b6_y * H_1_1r3_1 - J_l3b6_x * H_1_1r3_2);
  const Scalar t39 = t37 * t29 - (Scalar(1.635096e-06) * s_7 - Scalar(0.000020309339238)) * t28;
  const Scalar t40 = t35 * (t38 + t39 * (R_l3b71_x * H_1_1r3_2 - t27 * H_1_1r3_1));
  const Scalar t41 = Scalar(0.5) * s_4;
  const Scalar t42 = Scalar(0.5) * c_4;
  const Scalar t43 = s_5 * t41 - c_5 * t42;
  const Scalar R_l2b51_x = c_5 * t41 + s_5 * t42;
  const Scalar t44 = t43 * t23 + R_l2b51_x * t26;
  const Scalar J_l2b4_y = R_l2b51_x + c_4;
  const Scalar t45 = t43 + s_4;
  const Scalar t46 = J_l2b4_y * t26 + t45 * t23;
  const Scalar t47 = t44 - t46;
  const Scalar t48 = t47 * t47;
  const Scalar t49 = t44 * t44;
  const Scalar t50 = t43 * J_l2b4_y - R_l2b51_x * t45;
  const Scalar t51 = Scalar(1.0) / t50;
  const Scalar t52 = t51 * t51;
  const Scalar H_1_1r2_1 = t22 - (c_4 * t49 + R_l2b51_x * t48) * t52;
  const Scalar H_1_1r2_2 = t36 - t52 * (s_4 * t49 + t43 * t48);
  const Scalar H_1_1_5n = J_l2b4_y * H_1_1r2_1 + t45 * H_1_1r2_2;
  const Scalar mu_5_4_z = Scalar(4.01690073e-07) + Scalar(8.17548e-07) * s_5;
  const Scalar Ic_4_zz = Scalar(1.635096e-06) * s_5 + Scalar(0.000033629558073);
  const Scalar t53 = (mu_5_4_z * t46 - Ic_4_zz * t44) * (t43 * H_1_1r2_2 + R_l2b51_x * H_1_1r2_1);
  const Scalar t54 = t40 + t52 * ((Scalar(4.01690073e-07) * t46 - mu_5_4_z * t44) * H_1_1_5n - t53);
  const Scalar H_1_1_3n = R_l1a21_x * H_1_1r1_2 - t4 * H_1_1r1_1;
  const Scalar t55 = (Scalar(2.93825e-07) * c_2 + Scalar(9.237125e-07) * t14) * t20;
  const Scalar t56 = Scalar(2.93825e-07) * s_2 * t12 * t14 + t55 +
      Scalar(0.000016170147425) * t17 * H_1_1_3n;
  const Scalar t57 = c_5 * t51 * t44 * t46 * t47 * t52;
  const Scalar t58 = t57 - c_7 * t34 * t28 * t29 * t30 * t35;
  C[0] = -qd_1 * (Scalar(1.635096e-06) * t58 - t7 * t56 + Scalar(2.0) * t54);
  const Scalar regular_l1 = t6 * t6 - Scalar(3.7515625e-13);
  const Scalar regular_l2 = t50 * t50 - Scalar(6.25e-13);
  const Scalar regular_l3 = t33 * t33 - Scalar(6.25e-13);
  bool positive = regular_l1 > Scalar(0.0);
  positive &= regular_l2 > Scalar(0.0);
  positive &= regular_l3 > Scalar(0.0);
  return positive;
}

// Gravity torques g(q) (7.39).
//   q[7]  in   joint positions, rad or m
//   g[1]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads nothing. Operations: 0 mul, 0 add. Always zero: g[0].
template <class Scalar>
inline void gravity(const Scalar* /* q */, Scalar* g) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  g[0] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[7]   in   joint positions, rad or m
//   qd[1]  in   joint velocities, rad/s or m/s
//   n[1]   out  joint torques, N m (forces, N, for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..6], qd[0]. Operations: 134 mul, 69 add, 3 div, 14 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = Scalar(0.7) * c_1;
  const Scalar t2 = Scalar(0.7) * s_1;
  const Scalar t3 = c_2 * t1 - s_2 * t2;
  const Scalar t4 = Scalar(0.875) * c_3;
  const Scalar R_l1a21_x = s_2 * t1 + c_2 * t2;
  const Scalar t5 = Scalar(0.875) * s_3;
  const Scalar t6 = t3 * t4 + R_l1a21_x * t5;
  const Scalar t7 = Scalar(1.0) / t6;
  const Scalar t8 = Scalar(0.175) * c_1;
  const Scalar t9 = t3 - t8;
  const Scalar t10 = Scalar(0.175) * s_1;
  const Scalar t11 = R_l1a21_x - t10;
  const Scalar t12 = t7 * (t9 * t4 + t11 * t5);
  const Scalar t13 = t12 - Scalar(1.0);
  const Scalar t14 = t13 * t13;
  const Scalar t15 = qd_1 * qd_1;
  const Scalar t16 = (t8 - t3 * t14) * t15;
  const Scalar t17 = t7 * (R_l1a21_x * t9 - t3 * t11);
  const Scalar t18 = t17 * t17 * t15;
  const Scalar t19 = t5 * t18 - t16;
  const Scalar t20 = (t10 - R_l1a21_x * t14) * t15;
  const Scalar t21 = t4 * t18 + t20;
  const Scalar t22 = t7 * (t5 * t19 + t4 * t21);
  const Scalar t23 = t16 + R_l1a21_x * t22;
  const Scalar t24 = t11 - R_l1a21_x * t12;
  const Scalar R_l2b51_x = c_4 * s_5 + s_4 * c_5;
  const Scalar t25 = Scalar(0.5) * R_l2b51_x;
  const Scalar t26 = t9 - t3 * t12;
  const Scalar t27 = Scalar(-0.5) * (c_4 * c_5 - s_4 * s_5);
  const Scalar t28 = t25 * t24 - t27 * t26;
  const Scalar t29 = t27 + s_4;
  const Scalar J_l2b4_y = t25 + c_4;
  const Scalar t30 = t29 * t26 - J_l2b4_y * t24;
  const Scalar t31 = t28 + t30;
  const Scalar t32 = t31 * t31;
  const Scalar t33 = t28 * t28;
  const Scalar t34 = t29 * t25 - t27 * J_l2b4_y;
  const Scalar t35 = Scalar(1.0) / t34;
  const Scalar t36 = t35 * t15;
  const Scalar t37 = t35 * t36;
  const Scalar t38 = t23 - (c_4 * t33 + t25 * t32) * t37;
  const Scalar t39 = t20 - t3 * t22;
  const Scalar t40 = t39 - t37 * (s_4 * t33 + t27 * t32);
  const Scalar t41 = t25 * t38 + t27 * t40;
  const Scalar t42 = t35 * (s_5 * t41 - c_5 * t33 * t36);
  const Scalar t43 = t35 * t41;
  const Scalar t44 = t43 - t35 * (t29 * t40 + J_l2b4_y * t38);
  const Scalar t45 = Scalar(8.03380146e-07) * t44 + Scalar(1.635096e-06) * t42;
  const Scalar t46 = c_5 * t32 * t37 + s_5 * t44;
  const Scalar t47 = t30 * t45 + t28 *
      (t45 + Scalar(1.635096e-06) * t46 + Scalar(0.000066455736) * t43);
  const Scalar t48 = Scalar(-0.5) * (c_6 * c_7 - s_6 * s_7);
  const Scalar R_l3b71_x = c_6 * s_7 + s_6 * c_7;
  const Scalar t49 = Scalar(0.5) * R_l3b71_x;
  const Scalar t50 = t48 * t24 + t49 * t26;
  const Scalar J_l3b6_x = c_6 - t49;
  const Scalar J_l3b6_y = s_6 - t48;
  const Scalar t51 = J_l3b6_x * t26 + J_l3b6_y * t24;
  const Scalar t52 = t50 + t51;
  const Scalar t53 = t52 * t52;
  const Scalar t54 = t50 * t50;
  const Scalar t55 = J_l3b6_x * t48 - t49 * J_l3b6_y;
  const Scalar t56 = Scalar(1.0) / t55;
  const Scalar t57 = t56 * t15;
  const Scalar t58 = t56 * t57;
  const Scalar t59 = t23 - (s_6 * t54 - t48 * t53) * t58;
  const Scalar t60 = t39 + t58 * (c_6 * t54 - t49 * t53);
  const Scalar t61 = t48 * t59 - t49 * t60;
  const Scalar t62 = t56 * (c_7 * t54 * t57 + s_7 * t61);
  const Scalar t63 = t56 * t61;
  const Scalar t64 = t63 - t56 * (J_l3b6_x * t60 - J_l3b6_y * t59);
  const Scalar t65 = Scalar(8.03380146e-07) * t64 - Scalar(1.635096e-06) * t62;
  const Scalar t66 = c_7 * t53 * t58 - s_7 * t64;
  const Scalar t67 = t51 * t65 + t50 *
      (t65 + Scalar(1.635096e-06) * t66 + Scalar(0.00003981529833) * t63);
  const Scalar t68 = s_2 * t15;
  const Scalar t69 = c_2 * t22 + t14 * t68;
  const Scalar t70 = t13 * (Scalar(2.93825e-07) * t68 + Scalar(9.237125e-07) * t22);
  const Scalar t71 = t7 * t17 * (t3 * t19 - R_l1a21_x * t21);
  n[0] = Scalar(2.93825e-07) * t69 + t70 - Scalar(0.000016170147425) * t71 - t35 * t47 - t56 * t67;
  const Scalar regular_l1 = t6 * t6 - Scalar(3.7515625e-13);
  const Scalar regular_l2 = t34 * t34 - Scalar(6.25e-13);
  const Scalar regular_l3 = t55 * t55 - Scalar(6.25e-13);
  bool positive = regular_l1 > Scalar(0.0);
  positive &= regular_l2 > Scalar(0.0);
  positive &= regular_l3 > Scalar(0.0);
  return positive;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[7]    in   joint positions, rad or m
//   qd[1]   in   joint velocities, rad/s or m/s
//   tau[1]  in   joint torques or forces, N m or N
//   qdd[1]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular, or a pivot of B is not positive or not a number.
// Reads q[0..6], qd[0], tau[0]. Operations: 159 mul, 87 add, 4 div, 14 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar tau_1 = tau[0];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = Scalar(0.7) * c_1;
  const Scalar t2 = Scalar(0.7) * s_1;
  const Scalar t3 = c_2 * t1 - s_2 * t2;
  const Scalar t4 = Scalar(0.875) * c_3;
  const Scalar R_l1a21_x = s_2 * t1 + c_2 * t2;
  const Scalar t5 = Scalar(0.875) * s_3;
  const Scalar t6 = t3 * t4 + R_l1a21_x * t5;
  const Scalar t7 = Scalar(1.0) / t6;
  const Scalar t8 = Scalar(0.175) * c_1;
  const Scalar t9 = t3 - t8;
  const Scalar t10 = Scalar(0.175) * s_1;
  const Scalar t11 = R_l1a21_x - t10;
  const Scalar t12 = t9 * t4 + t11 * t5;
  const Scalar t13 = t7 * t12;
  const Scalar t14 = t13 - Scalar(1.0);
  const Scalar t15 = t14 * t14;
  const Scalar t16 = qd_1 * qd_1;
  const Scalar t17 = (t8 - t3 * t15) * t16;
  const Scalar t18 = R_l1a21_x * t9 - t3 * t11;
  const Scalar t19 = t7 * t18;
  const Scalar t20 = t19 * t19 * t16;
  const Scalar t21 = t5 * t20 - t17;
  const Scalar t22 = (t10 - R_l1a21_x * t15) * t16;
  const Scalar t23 = t4 * t20 + t22;
  const Scalar t24 = t7 * (t5 * t21 + t4 * t23);
  const Scalar t25 = t17 + R_l1a21_x * t24;
  const Scalar t26 = t11 - R_l1a21_x * t13;
  const Scalar R_l2b51_x = c_4 * s_5 + s_4 * c_5;
  const Scalar t27 = Scalar(0.5) * R_l2b51_x;
  const Scalar t28 = t9 - t3 * t13;
  const Scalar t29 = Scalar(-0.5) * (c_4 * c_5 - s_4 * s_5);
  const Scalar t30 = t27 * t26 - t29 * t28;
  const Scalar t31 = t29 + s_4;
  const Scalar J_l2b4_y = t27 + c_4;
  const Scalar t32 = t31 * t28 - J_l2b4_y * t26;
  const Scalar t33 = t30 + t32;
  const Scalar t34 = t33 * t33;
  const Scalar t35 = t30 * t30;
  const Scalar t36 = t31 * t27 - t29 * J_l2b4_y;
  const Scalar t37 = Scalar(1.0) / t36;
  const Scalar t38 = t37 * t37;
  const Scalar t39 = t38 * t16;
  const Scalar t40 = t25 - (c_4 * t35 + t27 * t34) * t39;
  const Scalar t41 = t22 - t3 * t24;
  const Scalar t42 = t41 - t39 * (s_4 * t35 + t29 * t34);
  const Scalar t43 = t27 * t40 + t29 * t42;
  const Scalar t44 = t37 * (s_5 * t43 - c_5 * t37 * t16 * t35);
  const Scalar t45 = t37 * t43;
  const Scalar t46 = t45 - t37 * (t31 * t42 + J_l2b4_y * t40);
  const Scalar t47 = Scalar(8.03380146e-07) * t46 + Scalar(1.635096e-06) * t44;
  const Scalar t48 = c_5 * t34 * t39 + s_5 * t46;
  const Scalar t49 = t32 * t47 + t30 *
      (t47 + Scalar(1.635096e-06) * t48 + Scalar(0.000066455736) * t45);
  const Scalar t50 = Scalar(-0.5) * (c_6 * c_7 - s_6 * s_7);
  const Scalar R_l3b71_x = c_6 * s_7 + s_6 * c_7;
  const Scalar t51 = Scalar(0.5) * R_l3b71_x;
  const Scalar t52 = t50 * t26 + t51 * t28;
  const Scalar J_l3b6_x = c_6 - t51;
  const Scalar J_l3b6_y = s_6 - t50;
  const Scalar t53 = J_l3b6_x * t28 + J_l3b6_y * t26;
  const Scalar t54 = t52 + t53;
  const Scalar t55 = t54 * t54;
  const Scalar t56 = t52 * t52;
  const Scalar t57 = J_l3b6_x * t50 - t51 * J_l3b6_y;
  const Scalar t58 = Scalar(1.0) / t57;
  const Scalar t59 = t58 * t58;
  const Scalar t60 = t59 * t16;
  const Scalar t61 = t25 - (s_6 * t56 - t50 * t55) * t60;
  const Scalar t62 = t41 + t60 * (c_6 * t56 - t51 * t55);
  const Scalar t63 = t50 * t61 - t51 * t62;
  const Scalar t64 = t58 * (c_7 * t58 * t16 * t56 + s_7 * t63);
  const Scalar t65 = t58 * t63;
  const Scalar t66 = t65 - t58 * (J_l3b6_x * t62 - J_l3b6_y * t61);
  const Scalar t67 = Scalar(8.03380146e-07) * t66 - Scalar(1.635096e-06) * t64;
  const Scalar t68 = c_7 * t55 * t60 - s_7 * t66;
  const Scalar t69 = t53 * t67 + t52 *
      (t67 + Scalar(1.635096e-06) * t68 + Scalar(0.00003981529833) * t65);
  const Scalar t70 = s_2 * t16;
  const Scalar t71 = c_2 * t24 + t15 * t70;
  const Scalar t72 = t14 * (Scalar(2.93825e-07) * t70 + Scalar(9.237125e-07) * t24);
  const Scalar t73 = Scalar(-0.000016170147425) * t19;
  const Scalar t74 = t7 * t73 * (t3 * t21 - R_l1a21_x * t23);
  const Scalar t75 = Scalar(-2.93825e-07) * t71 - t72 - t74 + t37 * t49 + t58 * t69 + tau_1;
  const Scalar Ic_4_zz = Scalar(3.270192e-06) * s_5 + Scalar(0.000067259116146);
  const Scalar mu_5_4_z = Scalar(8.03380146e-07) + Scalar(1.635096e-06) * s_5;
  const Scalar t76 = t30 * (mu_5_4_z * t32 + Ic_4_zz * t30);
  const Scalar t77 = (t32 * (Scalar(8.03380146e-07) * t32 + mu_5_4_z * t30) + t76) * t38;
  const Scalar t78 = Scalar(1.635096e-06) * s_7 - Scalar(8.03380146e-07);
  const Scalar t79 = t52 * (t78 * t53 +
      (Scalar(3.270192e-06) * s_7 - Scalar(0.000040618678476)) * t52);
  const Scalar t80 = (t79 - t53 * (Scalar(8.03380146e-07) * t53 - t78 * t52)) * t59;
  const Scalar t81 = Scalar(5.8765e-07) * c_2;
  const Scalar t82 = t7 * (t18 * t73 -
      t12 * (t81 + Scalar(9.237125e-07) * t13 - Scalar(1.847425e-06)));
  const Scalar t83 = t81 - Scalar(3.3331693e-06) + t82 - t77 + t80;
  qdd[0] = -t75 / t83;
  const Scalar regular_l1 = t6 * t6 - Scalar(3.7515625e-13);
  const Scalar regular_l2 = t36 * t36 - Scalar(6.25e-13);
  const Scalar regular_l3 = t57 * t57 - Scalar(6.25e-13);
  bool positive = -t83 > Scalar(0.0);
  positive &= regular_l1 > Scalar(0.0);
  positive &= regular_l2 > Scalar(0.0);
  positive &= regular_l3 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[7]   in   joint positions, rad or m
//   qd[1]  in   joint velocities, rad/s or m/s
//   T[1]   out  kinetic energy, J
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..6], qd[0]. Operations: 73 mul, 38 add, 3 div, 14 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool kinetic_energy(const Scalar* q, const Scalar* qd, Scalar* T,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = Scalar(0.7) * c_1;
  const Scalar t2 = Scalar(0.7) * s_1;
  const Scalar t3 = c_2 * t1 - s_2 * t2;
  const Scalar t4 = Scalar(0.875) * c_3;
  const Scalar R_l1a21_x = s_2 * t1 + c_2 * t2;
  const Scalar t5 = Scalar(0.875) * s_3;
  const Scalar t6 = t3 * t4 + R_l1a21_x * t5;
  const Scalar t7 = Scalar(1.0) / t6;
  const Scalar p_l1ae_x = Scalar(0.175) * c_1 - t3;
  const Scalar p_l1ae_y = Scalar(0.175) * s_1 - R_l1a21_x;
  const Scalar t8 = t7 * (p_l1ae_x * t4 + p_l1ae_y * t5);
  const Scalar G_1r2_1 = p_l1ae_y - R_l1a21_x * t8;
  const Scalar t9 = Scalar(0.5) * c_4;
  const Scalar t10 = Scalar(0.5) * s_4;
  const Scalar R_l2b51_x = s_5 * t9 + c_5 * t10;
  const Scalar t11 = p_l1ae_x - t3 * t8;
  const Scalar t12 = c_5 * t9 - s_5 * t10;
  const Scalar t13 = R_l2b51_x * G_1r2_1 + t12 * t11;
  const Scalar t14 = s_4 - t12;
  const Scalar J_l2b4_y = R_l2b51_x + c_4;
  const Scalar t15 = t13 + t14 * t11 - J_l2b4_y * G_1r2_1;
  const Scalar t16 = R_l2b51_x * t14 + t12 * J_l2b4_y;
  const Scalar t17 = Scalar(1.0) / t16;
  const Scalar t18 = t17 * t17;
  const Scalar t19 = t15 * (Scalar(0.24566757731656122) * t15 + s_5 * t13) * t18;
  const Scalar t20 = Scalar(0.5) * c_6;
  const Scalar t21 = Scalar(0.5) * s_6;
  const Scalar t22 = c_7 * t20 - s_7 * t21;
  const Scalar R_l3b71_x = s_7 * t20 + c_7 * t21;
  const Scalar t23 = t22 * G_1r2_1 - R_l3b71_x * t11;
  const Scalar J_l3b6_x = c_6 - R_l3b71_x;
  const Scalar J_l3b6_y = t22 + s_6;
  const Scalar t24 = t23 - J_l3b6_x * t11 - J_l3b6_y * G_1r2_1;
  const Scalar t25 = t22 * J_l3b6_x + R_l3b71_x * J_l3b6_y;
  const Scalar t26 = Scalar(1.0) / t25;
  const Scalar t27 = t26 * t26;
  const Scalar t28 = t19 + t24 * (Scalar(0.24566757731656122) * t24 - s_7 * t23) * t27;
  const Scalar t29 = t7 * (R_l1a21_x * p_l1ae_x - t3 * p_l1ae_y);
  const Scalar t30 = Scalar(0.06051585448461966) + Scalar(0.08213405743932298) * t28 +
      Scalar(0.4061290032534085) * t29 * t29 + t23 * t23 * t27 +
      Scalar(1.6691005414350237) * t13 * t13 * t18;
  const Scalar omega_2_z = qd_1 + qd_1 * t8;
  const Scalar L_2_z = omega_2_z - Scalar(0.6361827949713791) * c_2 * qd_1;
  T[0] = Scalar(4.6185625e-07) * omega_2_z * L_2_z + Scalar(0.000019907649165) * qd_1 * qd_1 * t30;
  const Scalar regular_l1 = t6 * t6 - Scalar(3.7515625e-13);
  const Scalar regular_l2 = t16 * t16 - Scalar(6.25e-13);
  const Scalar regular_l3 = t25 * t25 - Scalar(6.25e-13);
  bool positive = regular_l1 > Scalar(0.0);
  positive &= regular_l2 > Scalar(0.0);
  positive &= regular_l3 > Scalar(0.0);
  return positive;
}

// Potential energy of links and rotors (7.36).
//   q[7]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads nothing. Operations: 0 mul, 0 add.
template <class Scalar>
inline Scalar potential_energy(const Scalar* /* q */) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  return Scalar(0.0);
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    1, 1, 0,
    1, 1, 0,
    0, 0, 1};

// Pose of the tip (2.50).
//   q[7]  in   joint positions, rad or m
//   R[9]  out  rotation matrix of the frame in the base frame
//              3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]  out  position of the frame's origin in the base frame, m
// Reads q[2]. Operations: 4 mul, 4 add, 2 sin/cos. Always zero: 4 of the 9 entries of R. Always
// zero: p[2].
template <class Scalar, class SinCos = LibrarySinCos>
inline void forward_kinematics(const Scalar* q, Scalar* R, Scalar* p,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<2>(), sine, cosine);
  const Scalar s_3 = sine[2], c_3 = cosine[2];
  R[0] = R[4] = c_3;
  R[3] = s_3;
  R[1] = -s_3;
  const Scalar p_3u_t_x = Scalar(0.02) * c_3 + Scalar(0.018) * s_3;
  p[0] = p_3u_t_x - Scalar(0.03635);
  p[1] = Scalar(0.03273) - (Scalar(0.018) * c_3 - Scalar(0.02) * s_3);
  R[8] = Scalar(1.0);
  R[2] = R[5] = R[6] = R[7] = p[2] = Scalar(0.0);
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[6] = {
    1,
    1,
    0,
    0,
    0,
    1};

// Geometric Jacobian of the tip (7.14), (7.15).
//   q[7]  in   joint positions, rad or m
//   J[6]  out  geometric Jacobian in base axes: linear rows, then angular
//              6 x 1, row by row: entry (i, j) is J[1 * i + j]
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..2]. Operations: 21 mul, 9 add, 1 div, 6 sin/cos. Always zero: 3 of the 6 entries of J.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool jacobian(const Scalar* q, Scalar* J, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t1 = Scalar(0.028) * R_l1a21_x;
  const Scalar p_l1ae_y = Scalar(0.007) * s_1 - t1;
  const Scalar t2 = s_1 * s_2 - c_1 * c_2;
  const Scalar t3 = Scalar(-0.028) * t2;
  const Scalar p_l1ae_x = Scalar(0.007) * c_1 - t3;
  const Scalar t4 = Scalar(0.00098) * s_3 * R_l1a21_x - Scalar(0.00098) * c_3 * t2;
  const Scalar t5 = (t3 * p_l1ae_y - p_l1ae_x * t1) / t4;
  J[5] = -t5;
  const Scalar J_P3_x = Scalar(0.018) * c_3 - Scalar(0.02) * s_3;
  J[0] = -J_P3_x * t5;
  const Scalar r_3_x = Scalar(0.02) * c_3 + Scalar(0.018) * s_3;
  J[1] = -r_3_x * t5;
  J[2] = J[3] = J[4] = Scalar(0.0);
  const Scalar regular_l1 = t4 * t4 - Scalar(9.604e-19);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// (dJ/dt) qd of the tip.
//   q[7]   in   joint positions, rad or m
//   qd[1]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..2], qd[0]. Operations: 41 mul, 18 add, 1 div, 6 sin/cos. Always zero: a[2], a[3],
// a[4].
template <class Scalar, class SinCos = LibrarySinCos>
inline bool jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2];
  const Scalar t1 = Scalar(0.028) * c_1;
  const Scalar t2 = Scalar(0.028) * s_1;
  const Scalar t3 = c_2 * t1 - s_2 * t2;
  const Scalar t4 = Scalar(0.035) * c_3;
  const Scalar R_l1a21_x = s_2 * t1 + c_2 * t2;
  const Scalar t5 = Scalar(0.035) * s_3;
  const Scalar t6 = t3 * t4 + R_l1a21_x * t5;
  const Scalar t7 = Scalar(1.0) / t6;
  const Scalar t8 = qd_1 * t7;
  const Scalar t9 = Scalar(0.007) * c_1;
  const Scalar t10 = t3 - t9;
  const Scalar t11 = Scalar(0.007) * s_1;
  const Scalar t12 = R_l1a21_x - t11;
  const Scalar omega_l2_z = qd_1 - Scalar(0.035) * (c_3 * t10 + s_3 * t12) * t8;
  const Scalar t13 = omega_l2_z * omega_l2_z;
  const Scalar t14 = (R_l1a21_x * t10 - t3 * t12) * t8;
  const Scalar t15 = t14 * t14;
  const Scalar t16 = qd_1 * qd_1;
  const Scalar t17 = t3 * (t9 * t16 - t5 * t15 - t3 * t13);
  const Scalar driftr1_2 = t11 * t16 + t4 * t15 - R_l1a21_x * t13;
  const Scalar drift_3n = t17 + R_l1a21_x * driftr1_2;
  const Scalar t18 = t7 * drift_3n;
  a[5] = -t18;
  const Scalar t19 = Scalar(0.018) * t15 - Scalar(0.02) * t18;
  const Scalar t20 = Scalar(0.02) * t15 + Scalar(0.018) * t18;
  a[1] = c_3 * t19 - s_3 * t20;
  a[0] = -c_3 * t20 - s_3 * t19;
  a[2] = a[3] = a[4] = Scalar(0.0);
  const Scalar regular_l1 = t6 * t6 - Scalar(9.604e-19);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// Phi(q): what lies between the points where the loops are closed.
//   q[7]    in   joint positions, rad or m
//   phi[6]  out  loop by loop, m: what lies between the points that meet; 0 if closed
// Reads q[0..6]. Operations: 26 mul, 22 add, 14 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void loop_closure(const Scalar* q, Scalar* phi, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6];
  const Scalar p_l1ae_x = Scalar(0.007) * c_1 - Scalar(0.028) * (c_1 * c_2 - s_1 * s_2);
  phi[0] = Scalar(0.035) * s_3 - p_l1ae_x - Scalar(0.03635);
  const Scalar R_l1a21_x = c_1 * s_2 + s_1 * c_2;
  const Scalar p_l1ae_y = Scalar(0.007) * s_1 - Scalar(0.028) * R_l1a21_x;
  phi[1] = Scalar(-0.035) * c_3 - p_l1ae_y + Scalar(0.03273);
  const Scalar t1 = p_l1ae_x + Scalar(0.06934);
  const Scalar R_l2b51_x = c_4 * s_5 + s_4 * c_5;
  phi[2] = Scalar(0.02) * R_l2b51_x + Scalar(0.04) * c_4 - t1;
  const Scalar t2 = Scalar(0.00227) + p_l1ae_y;
  phi[3] = Scalar(0.04) * s_4 - Scalar(0.02) * (c_4 * c_5 - s_4 * s_5) - t2;
  phi[4] = Scalar(0.02) * (c_6 * c_7 - s_6 * s_7) + Scalar(0.04) * s_6 - t1;
  const Scalar R_l3b71_x = c_6 * s_7 + s_6 * c_7;
  phi[5] = Scalar(0.02) * R_l3b71_x - Scalar(0.04) * c_6 - t2;
}

// The entries of phi_q in loop_jacobian that are not always zero.
inline constexpr bool loop_jacobian_nonzero[42] = {
    1, 1, 1, 0, 0, 0, 0,
    1, 1, 1, 0, 0, 0, 0,
    1, 1, 0, 1, 1, 0, 0,
    1, 1, 0, 1, 1, 0, 0,
    1, 1, 0, 0, 0, 1, 1,
    1, 1, 0, 0, 0, 1, 1};

// Phi_q, the derivative of loop_closure.
//   q[7]       in   joint positions, rad or m
//   phi_q[42]  out  row i, column k: of phi[i] by q[k]
//                   6 x 7, row by row: entry (i, j) is phi_q[7 * i + j]
// Reads q[0..6]. Operations: 28 mul, 12 add, 14 sin/cos. Always zero: 20 of the 42 entries of
// phi_q.
template <class Scalar, class SinCos = LibrarySinCos>
inline void loop_jacobian(const Scalar* q, Scalar* phi_q, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6];
  phi_q[9] = Scalar(0.035) * s_3;
  phi_q[2] = Scalar(0.035) * c_3;
  const Scalar Phi_l12_2 = Scalar(-0.028) * (s_1 * s_2 - c_1 * c_2);
  phi_q[8] = phi_q[22] = phi_q[36] = Phi_l12_2;
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  phi_q[1] = phi_q[15] = phi_q[29] = Scalar(-0.028) * R_l1a21_x;
  const Scalar R_l2b51_x = s_4 * c_5 + c_4 * s_5;
  const Scalar phi_q_45 = Scalar(0.02) * R_l2b51_x;
  phi_q[25] = phi_q_45;
  const Scalar J_l2b5_x = Scalar(-0.02) * (s_4 * s_5 - c_4 * c_5);
  phi_q[18] = J_l2b5_x;
  const Scalar phi_q_67 = Scalar(-0.02) * (s_6 * s_7 - c_6 * c_7);
  phi_q[41] = phi_q_67;
  const Scalar R_l3b71_x = s_6 * c_7 + c_6 * s_7;
  phi_q[34] = Scalar(-0.02) * R_l3b71_x;
  phi_q[0] = phi_q[14] = phi_q[28] = Scalar(0.007) * s_1 - Scalar(0.028) * R_l1a21_x;
  phi_q[24] = phi_q_45 + Scalar(0.04) * c_4;
  phi_q[33] = Scalar(0.04) * c_6 - Scalar(0.02) * R_l3b71_x;
  phi_q[40] = phi_q_67 + Scalar(0.04) * s_6;
  phi_q[7] = phi_q[21] = phi_q[35] = Phi_l12_2 - Scalar(0.007) * c_1;
  phi_q[17] = J_l2b5_x - Scalar(0.04) * s_4;
  phi_q[3] = phi_q[4] = phi_q[5] = phi_q[6] = phi_q[10] = phi_q[11] = phi_q[12] = phi_q[13] =
      Scalar(0.0);
  phi_q[16] = phi_q[19] = phi_q[20] = phi_q[23] = phi_q[26] = phi_q[27] = phi_q[30] = phi_q[31] =
      Scalar(0.0);
  phi_q[32] = phi_q[37] = phi_q[38] = phi_q[39] = Scalar(0.0);
}

// Newton's step of the dependent joints towards closed loops.
//   q[7]   in   joint positions, rad or m
//   dq[7]  out  to be added to q, again and again; 0 for independent joints, which stay
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..6]. Operations: 55 mul, 42 add, 3 div, 14 sin/cos. Always zero: dq[0].
template <class Scalar, class SinCos = LibrarySinCos>
inline bool loop_step(const Scalar* q, Scalar* dq, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6];
  const Scalar t1 = Scalar(0.028) * c_1;
  const Scalar t2 = Scalar(0.028) * s_1;
  const Scalar t3 = c_2 * t1 - s_2 * t2;
  const Scalar p_l1ae_x = Scalar(0.007) * c_1 - t3;
  const Scalar t4 = Scalar(0.035) * s_3;
  const Scalar t5 = p_l1ae_x - t4 + Scalar(0.03635);
  const Scalar R_l1a21_x = s_2 * t1 + c_2 * t2;
  const Scalar p_l1ae_y = Scalar(0.007) * s_1 - R_l1a21_x;
  const Scalar t6 = Scalar(0.035) * c_3;
  const Scalar t7 = p_l1ae_y + t6 - Scalar(0.03273);
  const Scalar t8 = t3 * t6 + R_l1a21_x * t4;
  const Scalar t9 = Scalar(1.0) / t8;
  dq[2] = t9 * (t3 * t5 + R_l1a21_x * t7);
  const Scalar t10 = t9 * (t4 * t5 - t6 * t7);
  dq[1] = -t10;
  const Scalar t11 = p_l1ae_x - R_l1a21_x * t10;
  const Scalar t12 = Scalar(0.02) * c_4;
  const Scalar t13 = Scalar(0.02) * s_4;
  const Scalar R_l2b51_x = s_5 * t12 + c_5 * t13;
  const Scalar p_l2b5_x = Scalar(0.04) * c_4 - Scalar(0.06934);
  const Scalar p_l2be_x = R_l2b51_x + p_l2b5_x;
  const Scalar t14 = p_l2be_x - t11;
  const Scalar t15 = p_l1ae_y + t3 * t10;
  const Scalar t16 = c_5 * t12 - s_5 * t13;
  const Scalar p_l2b5_y = Scalar(0.04) * s_4 - Scalar(0.00227);
  const Scalar p_l2be_y = p_l2b5_y - t16;
  const Scalar t17 = p_l2be_y - t15;
  const Scalar t18 = Scalar(0.00227) + p_l2be_y;
  const Scalar J_l2b4_y = p_l2be_x + Scalar(0.06934);
  const Scalar t19 = R_l2b51_x * t18 + t16 * J_l2b4_y;
  const Scalar t20 = Scalar(1.0) / t19;
  dq[3] = t20 * (R_l2b51_x * t14 - t16 * t17);
  const Scalar t21 = Scalar(0.02) * c_6;
  const Scalar t22 = Scalar(0.02) * s_6;
  const Scalar R_l3b71_x = s_7 * t21 + c_7 * t22;
  const Scalar t23 = (Scalar(0.00227) + Scalar(0.04) * c_6) - R_l3b71_x;
  const Scalar t24 = t23 + t15;
  const Scalar J_l3b6_x = t23 - Scalar(0.00227);
  const Scalar t25 = c_7 * t21 - s_7 * t22;
  const Scalar p_l3b7_x = Scalar(0.04) * s_6 - Scalar(0.06934);
  const Scalar p_l3be_x = t25 + p_l3b7_x;
  const Scalar t26 = p_l3be_x - t11;
  const Scalar J_l3b6_y = p_l3be_x + Scalar(0.06934);
  const Scalar t27 = t25 * J_l3b6_x + R_l3b71_x * J_l3b6_y;
  const Scalar t28 = Scalar(1.0) / t27;
  dq[6] = t28 * (J_l3b6_x * t24 + J_l3b6_y * t26);
  dq[4] = -t20 * (t18 * t17 + J_l2b4_y * t14);
  dq[5] = -t28 * (t25 * t26 - R_l3b71_x * t24);
  dq[0] = Scalar(0.0);
  const Scalar regular_l1 = t8 * t8 - Scalar(9.604e-19);
  const Scalar regular_l2 = t19 * t19 - Scalar(1.6e-18);
  const Scalar regular_l3 = t27 * t27 - Scalar(1.6e-18);
  bool positive = regular_l1 > Scalar(0.0);
  positive &= regular_l2 > Scalar(0.0);
  positive &= regular_l3 > Scalar(0.0);
  return positive;
}

// Rates and accelerations of all joints of q, from those of the independent ones.
//   q[7]              in   joint positions, rad or m
//   qd[1]             in   joint velocities, rad/s or m/s
//   qdd[1]            in   joint accelerations, rad/s^2 or m/s^2
//   rates[7]          out  dq/dt of every entry of q
//   accelerations[7]  out  its derivative
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..6], qd[0], qdd[0]. Operations: 113 mul, 55 add, 3 div, 14 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool loop_motion(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* rates,
    Scalar* accelerations, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar qdd_1 = qdd[0];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3, 4, 5, 6>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3], s_5 = sine[4], c_5 = cosine[4],
      s_6 = sine[5], c_6 = cosine[5], s_7 = sine[6], c_7 = cosine[6];
  rates[0] = qd_1;
  accelerations[0] = qdd_1;
  const Scalar t1 = Scalar(0.028) * c_1;
  const Scalar t2 = Scalar(0.028) * s_1;
  const Scalar t3 = c_2 * t1 - s_2 * t2;
  const Scalar t4 = Scalar(0.035) * c_3;
  const Scalar R_l1a21_x = s_2 * t1 + c_2 * t2;
  const Scalar t5 = Scalar(0.035) * s_3;
  const Scalar t6 = t3 * t4 + R_l1a21_x * t5;
  const Scalar t7 = Scalar(1.0) / t6;
  const Scalar t8 = Scalar(0.007) * c_1;
  const Scalar t9 = t3 - t8;
  const Scalar t10 = Scalar(0.007) * s_1;
  const Scalar t11 = R_l1a21_x - t10;
  const Scalar t12 = t9 * t4 + t11 * t5;
  const Scalar t13 = t7 * t12;
  const Scalar t14 = t13 * qd_1;
  rates[1] = -t14;
  const Scalar t15 = R_l1a21_x * t9 - t3 * t11;
  const Scalar t16 = t7 * t15;
  rates[2] = -qd_1 * t16;
  const Scalar t17 = t9 - t3 * t13;
  const Scalar t18 = Scalar(0.02) * c_4;
  const Scalar t19 = Scalar(0.02) * s_4;
  const Scalar t20 = c_5 * t18 - s_5 * t19;
  const Scalar t21 = Scalar(0.04) * s_4 - t20;
  const Scalar t22 = t11 - R_l1a21_x * t13;
  const Scalar R_l2b51_x = s_5 * t18 + c_5 * t19;
  const Scalar J_l2b4_y = R_l2b51_x + Scalar(0.04) * c_4;
  const Scalar t23 = t21 * t17 - J_l2b4_y * t22;
  const Scalar t24 = R_l2b51_x * t21 + t20 * J_l2b4_y;
  const Scalar t25 = Scalar(1.0) / t24;
  const Scalar t26 = t25 * t23 * qd_1;
  rates[4] = -t26;
  const Scalar t27 = Scalar(0.02) * c_6;
  const Scalar t28 = Scalar(0.02) * s_6;
  const Scalar t29 = c_7 * t27 - s_7 * t28;
  const Scalar R_l3b71_x = s_7 * t27 + c_7 * t28;
  const Scalar t30 = t29 * t22 - R_l3b71_x * t17;
  const Scalar J_l3b6_x = Scalar(0.04) * c_6 - R_l3b71_x;
  const Scalar J_l3b6_y = t29 + Scalar(0.04) * s_6;
  const Scalar t31 = t29 * J_l3b6_x + R_l3b71_x * J_l3b6_y;
  const Scalar t32 = Scalar(1.0) / t31;
  const Scalar t33 = t32 * t30;
  const Scalar rates_6 = qd_1 * t33;
  rates[5] = rates_6;
  const Scalar t34 = J_l3b6_x * t17 + J_l3b6_y * t22;
  const Scalar t35 = t32 * t34 * qd_1;
  rates[6] = -t35;
  const Scalar t36 = R_l2b51_x * t22 + t20 * t17;
  const Scalar t37 = t25 * t36;
  const Scalar t38 = qd_1 * t37;
  rates[3] = -t38;
  const Scalar omega_l2_z = qd_1 - t14;
  const Scalar t39 = omega_l2_z * omega_l2_z;
  const Scalar t40 = qd_1 * qd_1;
  const Scalar t41 = t8 * t40 - t3 * t39;
  const Scalar t42 = t16 * t16 * t40;
  const Scalar t43 = t41 - t5 * t42;
  const Scalar t44 = t10 * t40 - R_l1a21_x * t39;
  const Scalar t45 = t4 * t42 + t44;
  const Scalar t46 = t5 * t43 - t4 * t45;
  accelerations[1] = t7 * (t46 - t12 * qdd_1);
  accelerations[2] = -t7 * (t15 * qdd_1 + (t3 * t43 + R_l1a21_x * t45));
  const Scalar t47 = t7 * t46;
  const Scalar t48 = t41 - R_l1a21_x * t47;
  const Scalar t49 = t38 + t26;
  const Scalar t50 = t49 * t49;
  const Scalar t51 = Scalar(0.04) * t40;
  const Scalar t52 = t37 * t37 * t51;
  const Scalar t53 = t48 - c_4 * t52 - R_l2b51_x * t50;
  const Scalar t54 = t44 + t3 * t47;
  const Scalar t55 = t54 - s_4 * t52 + t20 * t50;
  accelerations[3] = t25 * ((R_l2b51_x * t53 - t20 * t55) - t36 * qdd_1);
  accelerations[4] = -t25 * (t23 * qdd_1 + t21 * t55 + J_l2b4_y * t53);
  const Scalar t56 = rates_6 - t35;
  const Scalar t57 = t56 * t56;
  const Scalar t58 = t51 * t33 * t33;
  const Scalar t59 = c_6 * t58 + t54 - R_l3b71_x * t57;
  const Scalar t60 = t48 - s_6 * t58 - t29 * t57;
  accelerations[6] = -t32 * (t34 * qdd_1 + J_l3b6_x * t59 - J_l3b6_y * t60);
  accelerations[5] = -t32 * ((t29 * t60 + R_l3b71_x * t59) - t30 * qdd_1);
  const Scalar regular_l1 = t6 * t6 - Scalar(9.604e-19);
  const Scalar regular_l2 = t24 * t24 - Scalar(1.6e-18);
  const Scalar regular_l3 = t31 * t31 - Scalar(1.6e-18);
  bool positive = regular_l1 > Scalar(0.0);
  positive &= regular_l2 > Scalar(0.0);
  positive &= regular_l3 > Scalar(0.0);
  return positive;
}

// The functions by type, with the shapes of their arguments: what adapters such as
// flatdyn/eigen.hpp are given.
namespace functions {

struct inverse_dynamics {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[7], const Scalar (&qd)[1], const Scalar (&qdd)[1],
      Scalar (&tau)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::andrews_squeezer::inverse_dynamics(of...); }
};

struct inverse_dynamics_tip_force {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[7], const Scalar (&qd)[1], const Scalar (&qdd)[1],
      const Scalar (&h_e)[6], Scalar (&tau)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept {
    return ::andrews_squeezer::inverse_dynamics_tip_force(of...);
  }
};

struct inertia_matrix {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[7], Scalar (&B)[1][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::andrews_squeezer::inertia_matrix(of...); }
};

struct christoffel {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[7], Scalar (&c)[1][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::andrews_squeezer::christoffel(of...); }
};

struct coriolis_matrix {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[7], const Scalar (&qd)[1], Scalar (&C)[1][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::andrews_squeezer::coriolis_matrix(of...); }
};

struct gravity {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[7], Scalar (&g)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::andrews_squeezer::gravity(of...); }
};

struct bias {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[7], const Scalar (&qd)[1], Scalar (&n)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::andrews_squeezer::bias(of...); }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[7], const Scalar (&qd)[1], const Scalar (&tau)[1],
      Scalar (&qdd)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::andrews_squeezer::forward_dynamics(of...); }
};

struct kinetic_energy {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[7], const Scalar (&qd)[1], Scalar (&T)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::andrews_squeezer::kinetic_energy(of...); }
};

struct potential_energy {
  template <class Scalar>
  using Shape = Scalar(const Scalar (&q)[7]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::andrews_squeezer::potential_energy(of...); }
};

struct forward_kinematics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[7], Scalar (&R)[3][3], Scalar (&p)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept {
    return ::andrews_squeezer::forward_kinematics(of...);
  }
};

struct jacobian {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[7], Scalar (&J)[6][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::andrews_squeezer::jacobian(of...); }
};

struct jacobian_dot_qd {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[7], const Scalar (&qd)[1], Scalar (&a)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::andrews_squeezer::jacobian_dot_qd(of...); }
};

struct loop_closure {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[7], Scalar (&phi)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::andrews_squeezer::loop_closure(of...); }
};

struct loop_jacobian {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[7], Scalar (&phi_q)[6][7]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::andrews_squeezer::loop_jacobian(of...); }
};

struct loop_step {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[7], Scalar (&dq)[7]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::andrews_squeezer::loop_step(of...); }
};

struct loop_motion {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[7], const Scalar (&qd)[1], const Scalar (&qdd)[1],
      Scalar (&rates)[7], Scalar (&accelerations)[7]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::andrews_squeezer::loop_motion(of...); }
};

}  // namespace functions

// Moves the dependent joints of q until the loops are closed, by Newton's method with halved steps
// where a full one does not lessen the gap. Returns false, and leaves q as it was, where the gap is
// larger than `tolerance` (m) after `most_steps`: the loops cannot be closed from there, or are
// singular. Which of several ways to close them is found depends on where q is.
template <class Scalar>
inline bool close_loops(Scalar* q, Scalar tolerance, int most_steps = 20) noexcept {
  Scalar here[position_count], next[position_count], dq[position_count], phi[6];
  const auto gap_at = [&](const Scalar* position) {
    loop_closure(position, phi);
    Scalar sum = Scalar(0.0);
    for (const Scalar& entry : phi) sum = sum + entry * entry;
    return sum;
  };
  for (int k = 0; k < position_count; ++k) here[k] = q[k];
  Scalar gap = gap_at(here);
  for (int step = 0; step < most_steps && gap > tolerance * tolerance; ++step) {
    if (!loop_step(here, dq)) return false;
    Scalar next_gap = gap, size = Scalar(1.0);
    for (int halving = 0; halving < 20 && !(next_gap < gap); ++halving, size = size * Scalar(0.5)) {
      for (int k = 0; k < position_count; ++k) next[k] = here[k] + size * dq[k];
      next_gap = gap_at(next);
    }
    if (!(next_gap < gap)) return false;
    for (int k = 0; k < position_count; ++k) here[k] = next[k];
    gap = next_gap;
  }
  if (!(gap <= tolerance * tolerance)) return false;
  for (int k = 0; k < position_count; ++k) q[k] = here[k];
  return true;
}

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

}  // namespace andrews_squeezer

#endif  // FLATDYN_ANDREWS_SQUEEZER_HPP_78710CB4

// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "five_bar" as flat code: 4 joints, 2 of them independent.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Input: sha1:37dcea398acd14ac33e08ac2b4c502b8e0d55653
//
//   q  qd  joint        moves link   type      unit
//   0  0   left         left_crank   revolute  rad
//   1  -   left_elbow   left_rod     revolute  rad
//   2  1   right        right_crank  revolute  rad
//   3  -   right_elbow  right_rod    revolute  rad
//
// Gravity is (0, 0, 0) m/s^2 in the base frame. The tip belongs to link "left_rod". Closed loops
// make left_elbow, right_elbow follow from the other joints: q has the positions of all of them,
// qd, qdd and tau are those of the others. Functions hold where q closes the loops. Names with lk
// belong to loop k: R_lk, p_lk and r_lk to the way from its carrier to its two ends, Phi_lk to its
// closure's derivative by q, inv_lk is the reciprocal of the determinant that its joints are found
// with, and regular_lk is positive unless the loop is singular. A_i_j is how joint i moves with the
// joint of qd[j - 1], drift how it accelerates if that one does not.
//
// Every function is a template over its scalar: float, double, or any type that is made from a
// double, has + - * / (also - of one), comparisons, and sin, cos where argument-dependent lookup
// finds them (or an argument that knows them, see LibrarySinCos). Arguments are plain arrays:
//
//   double q[4] = {}, qd[2] = {}, qdd[2] = {}, tau[2];
//   const bool result = five_bar::inverse_dynamics(q, qd, qdd, tau);
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

#ifndef FLATDYN_FIVE_BAR_HPP_E15D8AA1
#define FLATDYN_FIVE_BAR_HPP_E15D8AA1

#include <cmath>

namespace five_bar {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 2;
inline constexpr int position_count = 4;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {"left", "right"};

// The joints of q.
inline constexpr const char* position_names[position_count] = {
    "left", "left_elbow", "right", "right_elbow"};

// The entries of q that qd, qdd and tau belong to.
inline constexpr int independent_positions[joint_count] = {0, 2};

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
//   q[4]    in   joint positions, rad or m
//   qd[2]   in   joint velocities, rad/s or m/s
//   qdd[2]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..3], qd[0..1], qdd[0..1]. Operations: 69 mul, 43 add, 1 div, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  const Scalar t1 = c_2 + Scalar(1.0);
  const Scalar p_l1ae_y = c_1 * s_2 + s_1 * t1;
  const Scalar J_l1a2_x = s_1 - p_l1ae_y;
  const Scalar t2 = s_3 * s_4 - c_3 * c_4;
  const Scalar t3 = s_1 * s_2 - c_1 * t1;
  const Scalar Phi_l12_2 = c_1 + t3;
  const Scalar t4 = s_3 * c_4 + c_3 * s_4;
  const Scalar t5 = J_l1a2_x * t2 + Phi_l12_2 * t4;
  const Scalar t6 = Scalar(1.0) / t5;
  const Scalar J_l1b3_y = c_3 - t2;
  const Scalar p_l1be_y = s_3 + t4;
  const Scalar t7 = t6 * (J_l1a2_x * J_l1b3_y - Phi_l12_2 * p_l1be_y) + Scalar(1.0);
  const Scalar t8 = p_l1ae_y * Phi_l12_2 + t3 * J_l1a2_x;
  const Scalar t9 = t6 * t8;
  const Scalar t10 = qd_1 * t9 + qd_2 * t7;
  const Scalar t11 = t10 * t10;
  const Scalar t12 = t6 * (p_l1ae_y * t2 - t3 * t4) + Scalar(1.0);
  const Scalar t13 = t4 * J_l1b3_y + t2 * p_l1be_y;
  const Scalar t14 = t6 * t13;
  const Scalar t15 = qd_2 * t14 - qd_1 * t12;
  const Scalar t16 = t15 * t15;
  const Scalar t17 = qd_2 * qd_2;
  const Scalar t18 = qd_1 * qd_1;
  const Scalar t19 = s_3 * t17 - s_1 * t18 + t4 * t11 + J_l1a2_x * t16;
  const Scalar driftr1_1 = c_1 * t18 - c_3 * t17 + t2 * t11 - Phi_l12_2 * t16;
  const Scalar t20 = t6 * (t4 * t19 - t13 * qdd_2 + t2 * driftr1_1);
  const Scalar t21 = qdd_1 * t12 + t20;
  const Scalar t22 = s_2 * t16 - c_2 * t21;
  const Scalar t23 = t6 * (J_l1a2_x * t19 - t8 * qdd_1 - Phi_l12_2 * driftr1_1);
  const Scalar t24 = qdd_2 * t7 - t23;
  const Scalar t25 = Scalar(0.00018225) * (s_4 * t17 + c_4 * qdd_2) + Scalar(0.0001215) * t24;
  const Scalar t26 = Scalar(0.00058725) * (s_2 * t18 + c_2 * qdd_1) + Scalar(0.0005265) * t21;
  tau[0] = Scalar(0.000891) * qdd_1 + t9 * t25 - Scalar(0.00058725) * t22 + t12 * t26;
  const Scalar t27 = s_4 * t11 - c_4 * t24;
  tau[1] = Scalar(0.000486) * qdd_2 - Scalar(0.00018225) * t27 + t7 * t25 - t14 * t26;
  const Scalar regular_l1 = t5 * t5 - Scalar(1e-12);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[4]    in   joint positions, rad or m
//   qd[2]   in   joint velocities, rad/s or m/s
//   qdd[2]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..3], qd[0..1], qdd[0..1], h_e[0..1], h_e[5]. Operations: 85 mul, 54 add, 1 div, 8
// sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool inverse_dynamics_tip_force(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    const Scalar* h_e, Scalar* tau, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1];
  const Scalar h_e_1 = h_e[0], h_e_2 = h_e[1], h_e_6 = h_e[5];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  const Scalar t1 = Scalar(0.09) * c_3;
  const Scalar p_l1b4_x = t1 + Scalar(0.118);
  const Scalar p_l1be_x = Scalar(0.09) * (c_3 * c_4 - s_3 * s_4) + p_l1b4_x;
  const Scalar t2 = p_l1b4_x - p_l1be_x;
  const Scalar t3 = Scalar(0.09) * c_1;
  const Scalar t4 = Scalar(0.09) * s_1;
  const Scalar R_l1a21_x = s_2 * t3 + c_2 * t4;
  const Scalar t5 = c_2 * t3 - s_2 * t4;
  const Scalar t6 = Scalar(0.09) * s_3;
  const Scalar R_l1b41_x = s_4 * t1 + c_4 * t6;
  const Scalar t7 = t5 * R_l1b41_x + R_l1a21_x * t2;
  const Scalar t8 = Scalar(1.0) / t7;
  const Scalar p_l1ae_x = t5 + t3;
  const Scalar p_l1ae_y = R_l1a21_x + t4;
  const Scalar t9 = t8 * (p_l1ae_x * R_l1b41_x + p_l1ae_y * t2) - Scalar(1.0);
  const Scalar p_l1be_y = R_l1b41_x + t6;
  const Scalar J_l1b3_y = p_l1be_x - Scalar(0.118);
  const Scalar t10 = R_l1b41_x * J_l1b3_y + p_l1be_y * t2;
  const Scalar t11 = t8 * t10;
  const Scalar t12 = qd_1 * t9 - qd_2 * t11;
  const Scalar t13 = t12 * t12;
  const Scalar t14 = qd_1 * qd_1;
  const Scalar t15 = t8 * (t5 * p_l1be_y - R_l1a21_x * J_l1b3_y) - Scalar(1.0);
  const Scalar t16 = R_l1a21_x * p_l1ae_x - t5 * p_l1ae_y;
  const Scalar t17 = t8 * t16;
  const Scalar t18 = qd_1 * t17 + qd_2 * t15;
  const Scalar t19 = t18 * t18;
  const Scalar r_l1b3_x = p_l1b4_x - Scalar(0.118);
  const Scalar t20 = qd_2 * qd_2;
  const Scalar t21 = (t3 * t14 + t5 * t13) - r_l1b3_x * t20 + t2 * t19;
  const Scalar t22 = (t4 * t14 + R_l1a21_x * t13) - (t6 * t20 + R_l1b41_x * t19);
  const Scalar t23 = t8 * ((R_l1a21_x * t22 + t5 * t21) - t16 * qdd_1);
  const Scalar domega_4_z = t23 - qdd_2 * t15;
  const Scalar t24 = c_4 * domega_4_z - s_4 * t19;
  const Scalar N_4_z = Scalar(0.00018225) * (c_4 * qdd_2 + s_4 * t20) +
      Scalar(0.0001215) * domega_4_z;
  const Scalar t25 = t8 * ((t2 * t21 - R_l1b41_x * t22) - t10 * qdd_2);
  const Scalar t26 = qdd_1 * t9 + t25;
  const Scalar t27 = c_1 * h_e_2 - s_1 * h_e_1;
  const Scalar f_e1_x = c_1 * h_e_1 + s_1 * h_e_2;
  const Scalar t28 = c_2 * t27 - s_2 * f_e1_x;
  const Scalar t29 = c_2 * qdd_1 + s_2 * t14;
  const Scalar mu_2_z = Scalar(0.00058725) * t29 - Scalar(0.0005265) * t26 + Scalar(0.09) * t28 +
      h_e_6;
  tau[1] = Scalar(0.000486) * qdd_2 + Scalar(0.00018225) * t24 - t15 * N_4_z + t11 * mu_2_z;
  const Scalar t30 = s_2 * (Scalar(0.006525) * t13 - c_2 * f_e1_x - s_2 * t27);
  const Scalar t31 = c_2 * (t28 - Scalar(0.006525) * t26) - t30;
  tau[0] = Scalar(0.000891) * qdd_1 - t17 * N_4_z + Scalar(0.09) * t31 - t9 * mu_2_z;
  const Scalar regular_l1 = t7 * t7 - Scalar(6.561e-17);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[4] = {
    1, 1,
    1, 1};

// Joint-space inertia matrix B(q) (7.32).
//   q[4]  in   joint positions, rad or m
//   B[4]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//              2 x 2, row by row: entry (i, j) is B[2 * i + j]
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..3]. Operations: 38 mul, 28 add, 1 div, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool inertia_matrix(const Scalar* q, Scalar* B, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  const Scalar t1 = c_2 + Scalar(1.0);
  const Scalar p_l1ae_y = c_1 * s_2 + s_1 * t1;
  const Scalar J_l1a2_x = s_1 - p_l1ae_y;
  const Scalar t2 = s_3 * s_4 - c_3 * c_4;
  const Scalar t3 = s_1 * s_2 - c_1 * t1;
  const Scalar Phi_l12_2 = c_1 + t3;
  const Scalar t4 = s_3 * c_4 + c_3 * s_4;
  const Scalar t5 = J_l1a2_x * t2 + Phi_l12_2 * t4;
  const Scalar t6 = Scalar(1.0) / t5;
  const Scalar t7 = Scalar(0.0005265) * t6;
  const Scalar t8 = p_l1ae_y * t2 - t3 * t4;
  const Scalar mu_2_1_z = Scalar(0.00058725) * c_2 + Scalar(0.0005265);
  const Scalar b_1_2h = t8 * t7 + mu_2_1_z;
  const Scalar J_l1b3_y = c_3 - t2;
  const Scalar p_l1be_y = s_3 + t4;
  const Scalar t9 = t4 * J_l1b3_y + t2 * p_l1be_y;
  const Scalar t10 = Scalar(0.0001215) * t6;
  const Scalar t11 = J_l1a2_x * J_l1b3_y - Phi_l12_2 * p_l1be_y;
  const Scalar mu_4_3_z = Scalar(0.0001215) + Scalar(0.00018225) * c_4;
  const Scalar b_2_4h = mu_4_3_z + t11 * t10;
  const Scalar t12 = p_l1ae_y * Phi_l12_2 + t3 * J_l1a2_x;
  B[1] = B[2] = -t6 * (t9 * b_1_2h - t12 * b_2_4h);
  const Scalar t13 = t6 * (t12 * t12 * t10 + t8 * (mu_2_1_z + b_1_2h));
  B[0] = Scalar(0.0011745) * c_2 + t13 + Scalar(0.0014175);
  const Scalar t14 = t6 * (t9 * t9 * t7 + t11 * (mu_4_3_z + b_2_4h));
  B[3] = Scalar(0.0003645) * c_4 + t14 + Scalar(0.0006075);
  const Scalar regular_l1 = t5 * t5 - Scalar(1e-12);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[6] = {
    1, 1, 1,
    1, 1, 1};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[4]  in   joint positions, rad or m
//   c[6]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//              c_ijk = c_ikj is c[3 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..3]. Operations: 92 mul, 60 add, 1 div, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool christoffel(const Scalar* q, Scalar* c, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  const Scalar p_l1ae_y = s_1 * c_2 + c_1 * s_2 + s_1;
  const Scalar J_l1a2_x = s_1 - p_l1ae_y;
  const Scalar p_l1b4_x = c_3 + Scalar(1.3111111111111111);
  const Scalar p_l1be_x = c_3 * c_4 - s_3 * s_4 + p_l1b4_x;
  const Scalar t1 = p_l1b4_x - p_l1be_x;
  const Scalar p_l1ae_x = c_1 * c_2 - s_1 * s_2 + c_1;
  const Scalar Phi_l12_2 = c_1 - p_l1ae_x;
  const Scalar p_l1be_y = s_3 * c_4 + c_3 * s_4 + s_3;
  const Scalar J_l1b4_x = s_3 - p_l1be_y;
  const Scalar t2 = J_l1a2_x * t1 - Phi_l12_2 * J_l1b4_x;
  const Scalar t3 = Scalar(1.0) / t2;
  const Scalar t4 = t3 * t3;
  const Scalar t5 = p_l1ae_y * Phi_l12_2 - p_l1ae_x * J_l1a2_x;
  const Scalar t6 = t5 * t4;
  const Scalar t7 = t5 * t6;
  const Scalar t8 = p_l1ae_y * t1 - p_l1ae_x * J_l1b4_x;
  const Scalar t9 = t3 * t8;
  const Scalar omega_l2_z = t9 + Scalar(1.0);
  const Scalar t10 = J_l1a2_x * omega_l2_z;
  const Scalar H_1_1r1_2 = J_l1b4_x * t7 + s_1 - omega_l2_z * t10;
  const Scalar t11 = Phi_l12_2 * omega_l2_z;
  const Scalar H_1_1r1_1 = c_1 + t1 * t7 - omega_l2_z * t11;
  const Scalar H_1_1_4n = J_l1a2_x * H_1_1r1_2 + Phi_l12_2 * H_1_1r1_1;
  const Scalar J_l1b3_y = p_l1be_x - Scalar(1.3111111111111111);
  const Scalar t12 = J_l1a2_x * J_l1b3_y - Phi_l12_2 * p_l1be_y;
  const Scalar t13 = t3 * t12;
  const Scalar b_2_4h = Scalar(0.0001215) * t13 + Scalar(0.0001215) + Scalar(0.00018225) * c_4;
  const Scalar t14 = t3 * b_2_4h;
  const Scalar H_1_1_2n = J_l1b4_x * H_1_1r1_2 + t1 * H_1_1r1_1;
  const Scalar t15 = J_l1b3_y * J_l1b4_x - p_l1be_y * t1;
  const Scalar t16 = t15 * t4;
  const Scalar t17 = Scalar(-0.0005265) * t16;
  const Scalar t18 = Scalar(0.00018225) * s_4;
  const Scalar t19 = t3 * t15;
  const Scalar t20 = Scalar(0.00058725) * s_2;
  const Scalar t21 = t20 * t19;
  c[3] = H_1_1_4n * t14 - t7 * t18 + t21 - H_1_1_2n * t17;
  const Scalar omega_l4_z = t13 + Scalar(1.0);
  const Scalar t22 = J_l1b4_x * omega_l4_z;
  const Scalar t23 = t3 * t5;
  const Scalar t24 = t23 * t22 - t10 * t19;
  const Scalar t25 = t1 * omega_l4_z;
  const Scalar t26 = t25 * t23 - t11 * t19;
  const Scalar t27 = J_l1a2_x * t24 + Phi_l12_2 * t26;
  const Scalar t28 = J_l1b4_x * t24 + t1 * t26;
  const Scalar t29 = t12 * t18;
  const Scalar t30 = t18 * t23;
  c[4] = -t6 * t29 - t30 + t14 * t27 - t17 * t28;
  const Scalar t31 = t15 * t16;
  const Scalar t32 = s_3 + J_l1a2_x * t31 - omega_l4_z * t22;
  const Scalar t33 = c_3 + Phi_l12_2 * t31 - omega_l4_z * t25;
  const Scalar t34 = J_l1a2_x * t32 + Phi_l12_2 * t33;
  const Scalar t35 = Scalar(-0.0001215) * t6;
  const Scalar t36 = J_l1b4_x * t32 + t1 * t33;
  const Scalar b_1_2h = Scalar(0.00058725) * c_2 + Scalar(0.0005265) * t9 + Scalar(0.0005265);
  const Scalar t37 = t3 * b_1_2h;
  c[2] = t30 + t35 * t34 - t20 * t31 - t37 * t36;
  const Scalar t38 = t8 * t20;
  const Scalar t39 = H_1_1_4n * t35 + t8 * t4 * t38 + t9 * t20 - H_1_1_2n * t37;
  c[0] = -t39;
  c[1] = -t35 * t27 - t21 - t38 * t16 + t37 * t28;
  const Scalar t40 = t12 * t4 * t29 + t13 * t18 + t14 * t34 - t17 * t36;
  c[5] = -t40;
  const Scalar regular_l1 = t2 * t2 - Scalar(1e-12);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// The entries of C in coriolis_matrix that are not always zero.
inline constexpr bool coriolis_matrix_nonzero[4] = {
    1, 1,
    1, 1};

// C(q, qd) from the Christoffel symbols (7.44).
//   q[4]   in   joint positions, rad or m
//   qd[2]  in   joint velocities, rad/s or m/s
//   C[4]   out  c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric
//               2 x 2, row by row: entry (i, j) is C[2 * i + j]
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..3], qd[0..1]. Operations: 105 mul, 53 add, 1 div, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  const Scalar t1 = c_2 + Scalar(1.0);
  const Scalar p_l1ae_y = c_1 * s_2 + s_1 * t1;
  const Scalar J_l1a2_x = s_1 - p_l1ae_y;
  const Scalar t2 = s_3 * s_4 - c_3 * c_4;
  const Scalar t3 = s_1 * s_2 - c_1 * t1;
  const Scalar Phi_l12_2 = c_1 + t3;
  const Scalar t4 = s_3 * c_4 + c_3 * s_4;
  const Scalar t5 = J_l1a2_x * t2 + Phi_l12_2 * t4;
  const Scalar t6 = Scalar(1.0) / t5;
  const Scalar J_l1b3_y = c_3 - t2;
  const Scalar p_l1be_y = s_3 + t4;
  const Scalar t7 = J_l1a2_x * J_l1b3_y - Phi_l12_2 * p_l1be_y;
  const Scalar t8 = t6 * t7 + Scalar(1.0);
  const Scalar t9 = t4 * t8;
  const Scalar t10 = p_l1ae_y * Phi_l12_2 + t3 * J_l1a2_x;
  const Scalar t11 = p_l1ae_y * t2 - t3 * t4;
  const Scalar omega_l2_z = t6 * t11 + Scalar(1.0);
  const Scalar t12 = t4 * J_l1b3_y + t2 * p_l1be_y;
  const Scalar t13 = t12 * omega_l2_z;
  const Scalar t14 = t10 * t9 - J_l1a2_x * t13;
  const Scalar t15 = t2 * t8;
  const Scalar t16 = Phi_l12_2 * t13 + t10 * t15;
  const Scalar t17 = J_l1a2_x * t14 - Phi_l12_2 * t16;
  const Scalar t18 = t6 * t10;
  const Scalar t19 = Scalar(-0.0001215) * t18;
  const Scalar t20 = t4 * t14 + t2 * t16;
  const Scalar b_1_2h = Scalar(0.00058725) * c_2 + Scalar(0.0005265) * omega_l2_z;
  const Scalar t21 = Scalar(0.00058725) * s_2;
  const Scalar t22 = t21 * t13 + t6 * (t19 * t17 + b_1_2h * t20);
  const Scalar t23 = omega_l2_z * omega_l2_z;
  const Scalar t24 = t18 * t18;
  const Scalar H_1_1r1_2 = s_1 - t4 * t24 - J_l1a2_x * t23;
  const Scalar H_1_1r1_1 = c_1 + t2 * t24 - Phi_l12_2 * t23;
  const Scalar H_1_1_4n = J_l1a2_x * H_1_1r1_2 + Phi_l12_2 * H_1_1r1_1;
  const Scalar t25 = t4 * H_1_1r1_2 - t2 * H_1_1r1_1;
  const Scalar t26 = qd_1 * (H_1_1_4n * t19 + t11 * omega_l2_z * t21 + b_1_2h * t25);
  C[0] = t6 * (qd_2 * t22 - t26);
  const Scalar t27 = t6 * t12;
  const Scalar t28 = t27 * t27;
  const Scalar t29 = s_3 + J_l1a2_x * t28 + t8 * t9;
  const Scalar t30 = c_3 + Phi_l12_2 * t28 - t8 * t15;
  const Scalar t31 = J_l1a2_x * t29 + Phi_l12_2 * t30;
  const Scalar t32 = t6 * (Scalar(4.833333333333333) * s_2 * t12 * t12 + t10 * t31);
  const Scalar t33 = t4 * t29 - t2 * t30;
  const Scalar t34 = s_4 * t10;
  const Scalar t35 = qd_2 * (Scalar(0.00018225) * t34 - Scalar(0.0001215) * t32 + b_1_2h * t33);
  C[1] = t6 * (t35 + qd_1 * t22);
  const Scalar b_2_4h = Scalar(0.00018225) * c_4 + Scalar(0.0001215) * t8;
  const Scalar t36 = Scalar(-0.0005265) * t27;
  const Scalar t37 = Scalar(-0.00018225) * t8;
  const Scalar t38 = t34 * t37 - t6 * (b_2_4h * t17 - t20 * t36);
  const Scalar t39 = t6 * (t12 * t25 - Scalar(0.34615384615384615) * t10 * t34);
  const Scalar t40 = qd_1 * (b_2_4h * H_1_1_4n - t12 * t21 + Scalar(0.0005265) * t39);
  C[2] = t6 * (qd_2 * t38 + t40);
  const Scalar t41 = qd_2 * (b_2_4h * t31 - s_4 * t7 * t37 - t36 * t33);
  C[3] = -t6 * (t41 - qd_1 * t38);
  const Scalar regular_l1 = t5 * t5 - Scalar(1e-12);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// Gravity torques g(q) (7.39).
//   q[4]  in   joint positions, rad or m
//   g[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads nothing. Operations: 0 mul, 0 add. Always zero: g[0], g[1].
template <class Scalar>
inline void gravity(const Scalar* /* q */, Scalar* g) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  g[0] = g[1] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[4]   in   joint positions, rad or m
//   qd[2]  in   joint velocities, rad/s or m/s
//   n[2]   out  joint torques, N m (forces, N, for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..3], qd[0..1]. Operations: 63 mul, 35 add, 1 div, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  const Scalar t1 = c_2 + Scalar(1.0);
  const Scalar p_l1ae_y = c_1 * s_2 + s_1 * t1;
  const Scalar J_l1a2_x = s_1 - p_l1ae_y;
  const Scalar t2 = s_3 * s_4 - c_3 * c_4;
  const Scalar t3 = s_1 * s_2 - c_1 * t1;
  const Scalar Phi_l12_2 = c_1 + t3;
  const Scalar t4 = s_3 * c_4 + c_3 * s_4;
  const Scalar t5 = J_l1a2_x * t2 + Phi_l12_2 * t4;
  const Scalar t6 = Scalar(1.0) / t5;
  const Scalar J_l1b3_y = c_3 - t2;
  const Scalar p_l1be_y = s_3 + t4;
  const Scalar t7 = t6 * (J_l1a2_x * J_l1b3_y - Phi_l12_2 * p_l1be_y) + Scalar(1.0);
  const Scalar t8 = p_l1ae_y * Phi_l12_2 + t3 * J_l1a2_x;
  const Scalar t9 = qd_1 * t6 * t8 + qd_2 * t7;
  const Scalar t10 = t9 * t9;
  const Scalar t11 = t6 * (p_l1ae_y * t2 - t3 * t4) + Scalar(1.0);
  const Scalar t12 = t4 * J_l1b3_y + t2 * p_l1be_y;
  const Scalar t13 = qd_2 * t6 * t12 - qd_1 * t11;
  const Scalar t14 = t13 * t13;
  const Scalar t15 = qd_2 * qd_2;
  const Scalar t16 = qd_1 * qd_1;
  const Scalar t17 = s_3 * t15 - s_1 * t16 + t4 * t10 + J_l1a2_x * t14;
  const Scalar driftr1_1 = c_1 * t16 - c_3 * t15 + t2 * t10 - Phi_l12_2 * t14;
  const Scalar t18 = J_l1a2_x * t17 - Phi_l12_2 * driftr1_1;
  const Scalar t19 = Scalar(0.00018225) * s_4;
  const Scalar t20 = t15 * t19 - Scalar(0.0001215) * t6 * t18;
  const Scalar t21 = t4 * t17 + t2 * driftr1_1;
  const Scalar t22 = t6 * (t8 * t20 + Scalar(0.00058725) * c_2 * t21);
  const Scalar t23 = Scalar(0.00058725) * s_2;
  const Scalar t24 = t16 * t23 + Scalar(0.0005265) * t6 * t21;
  n[0] = t11 * t24 - t14 * t23 + t22;
  const Scalar t25 = t6 * (Scalar(0.00018225) * c_4 * t18 + t12 * t24);
  n[1] = t7 * t20 - t10 * t19 - t25;
  const Scalar regular_l1 = t5 * t5 - Scalar(1e-12);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[4]    in   joint positions, rad or m
//   qd[2]   in   joint velocities, rad/s or m/s
//   tau[2]  in   joint torques or forces, N m or N
//   qdd[2]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular, or a pivot of B is not positive or not a number.
// Reads q[0..3], qd[0..1], tau[0..1]. Operations: 84 mul, 53 add, 3 div, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar tau_1 = tau[0], tau_2 = tau[1];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  const Scalar t1 = c_2 + Scalar(1.0);
  const Scalar p_l1ae_y = c_1 * s_2 + s_1 * t1;
  const Scalar J_l1a2_x = s_1 - p_l1ae_y;
  const Scalar t2 = s_3 * s_4 - c_3 * c_4;
  const Scalar t3 = s_1 * s_2 - c_1 * t1;
  const Scalar Phi_l12_2 = c_1 + t3;
  const Scalar t4 = s_3 * c_4 + c_3 * s_4;
  const Scalar t5 = J_l1a2_x * t2 + Phi_l12_2 * t4;
  const Scalar t6 = Scalar(1.0) / t5;
  const Scalar J_l1b3_y = c_3 - t2;
  const Scalar p_l1be_y = s_3 + t4;
  const Scalar t7 = J_l1a2_x * J_l1b3_y - Phi_l12_2 * p_l1be_y;
  const Scalar t8 = t6 * t7 + Scalar(1.0);
  const Scalar t9 = p_l1ae_y * Phi_l12_2 + t3 * J_l1a2_x;
  const Scalar t10 = t6 * t9 * qd_1 + qd_2 * t8;
  const Scalar t11 = t10 * t10;
  const Scalar t12 = p_l1ae_y * t2 - t3 * t4;
  const Scalar t13 = t6 * t12 + Scalar(1.0);
  const Scalar t14 = t4 * J_l1b3_y + t2 * p_l1be_y;
  const Scalar t15 = t6 * t14 * qd_2 - qd_1 * t13;
  const Scalar t16 = t15 * t15;
  const Scalar t17 = qd_2 * qd_2;
  const Scalar t18 = qd_1 * qd_1;
  const Scalar t19 = s_3 * t17 - s_1 * t18 + t4 * t11 + J_l1a2_x * t16;
  const Scalar driftr1_1 = c_1 * t18 - c_3 * t17 + t2 * t11 - Phi_l12_2 * t16;
  const Scalar t20 = t4 * t19 + t2 * driftr1_1;
  const Scalar t21 = Scalar(0.0005265) * t6;
  const Scalar t22 = Scalar(0.00058725) * s_2;
  const Scalar t23 = t18 * t22 + t21 * t20;
  const Scalar t24 = J_l1a2_x * t19 - Phi_l12_2 * driftr1_1;
  const Scalar t25 = Scalar(0.00018225) * c_4;
  const Scalar t26 = t6 * (t25 * t24 + t14 * t23);
  const Scalar t27 = Scalar(0.0001215) * t6;
  const Scalar t28 = Scalar(0.00018225) * s_4;
  const Scalar t29 = t17 * t28 - t27 * t24;
  const Scalar t30 = t11 * t28 - t8 * t29 + t26 + tau_2;
  const Scalar mu_4_3_z = Scalar(0.0001215) + t25;
  const Scalar b_2_4h = mu_4_3_z + t7 * t27;
  const Scalar t31 = t6 * (t14 * t14 * t21 + t7 * (mu_4_3_z + b_2_4h));
  const Scalar b_2_2q = Scalar(0.0003645) * c_4 + t31 + Scalar(0.0006075);
  const Scalar d_2 = Scalar(1.0) / b_2_2q;
  const Scalar t32 = Scalar(0.00058725) * c_2;
  const Scalar mu_2_1_z = t32 + Scalar(0.0005265);
  const Scalar b_1_2h = t12 * t21 + mu_2_1_z;
  const Scalar t33 = t14 * b_1_2h - t9 * b_2_4h;
  const Scalar t34 = t33 * d_2;
  const Scalar t35 = t6 * (t9 * t29 + t32 * t20 - t34 * t30);
  const Scalar t36 = t6 * (Scalar(0.0001215) * t9 * t9 - t33 * t34);
  const Scalar b_2_1_1 = Scalar(0.0011745) * c_2 + t6 * (t36 + t12 * (mu_2_1_z + b_1_2h)) +
      Scalar(0.0014175);
  const Scalar qdd_1 = (t16 * t22 - t13 * t23 + tau_1 - t35) / b_2_1_1;
  qdd[0] = qdd_1;
  qdd[1] = d_2 * (t6 * t33 * qdd_1 + t30);
  const Scalar regular_l1 = t5 * t5 - Scalar(1e-12);
  bool positive = b_2_1_1 > Scalar(0.0);
  positive &= b_2_2q > Scalar(0.0);
  positive &= regular_l1 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[4]   in   joint positions, rad or m
//   qd[2]  in   joint velocities, rad/s or m/s
//   T[1]   out  kinetic energy, J
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..3], qd[0..1]. Operations: 38 mul, 24 add, 1 div, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool kinetic_energy(const Scalar* q, const Scalar* qd, Scalar* T,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  const Scalar t1 = c_2 + Scalar(1.0);
  const Scalar p_l1ae_y = c_1 * s_2 + s_1 * t1;
  const Scalar J_l1a2_x = s_1 - p_l1ae_y;
  const Scalar t2 = s_3 * s_4 - c_3 * c_4;
  const Scalar J_l1b3_y = c_3 - t2;
  const Scalar t3 = s_1 * s_2 - c_1 * t1;
  const Scalar Phi_l12_2 = c_1 + t3;
  const Scalar t4 = s_3 * c_4 + c_3 * s_4;
  const Scalar p_l1be_y = s_3 + t4;
  const Scalar t5 = qd_2 * (J_l1a2_x * J_l1b3_y - Phi_l12_2 * p_l1be_y);
  const Scalar t6 = J_l1a2_x * t2 + Phi_l12_2 * t4;
  const Scalar t7 = Scalar(1.0) / t6;
  const Scalar omega_4_z = qd_2 + t7 * (t5 + qd_1 * (p_l1ae_y * Phi_l12_2 + t3 * J_l1a2_x));
  const Scalar L_4_z = Scalar(0.0001215) * omega_4_z + Scalar(0.0003645) * c_4 * qd_2;
  const Scalar t8 = qd_2 * (t4 * J_l1b3_y + t2 * p_l1be_y);
  const Scalar omega_2_z = qd_1 - t7 * (t8 - qd_1 * (p_l1ae_y * t2 - t3 * t4));
  const Scalar L_2_z = Scalar(0.0005265) * omega_2_z + Scalar(0.0011745) * c_2 * qd_1;
  const Scalar T_2 = omega_4_z * L_4_z + Scalar(0.000486) * qd_2 * qd_2 +
      Scalar(0.000891) * qd_1 * qd_1 + omega_2_z * L_2_z;
  T[0] = Scalar(0.5) * T_2;
  const Scalar regular_l1 = t6 * t6 - Scalar(1e-12);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// Potential energy of links and rotors (7.36).
//   q[4]  in  joint positions, rad or m
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
//   q[4]  in   joint positions, rad or m
//   R[9]  out  rotation matrix of the frame in the base frame
//              3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]  out  position of the frame's origin in the base frame, m
// Reads q[0..1]. Operations: 9 mul, 5 add, 4 sin/cos. Always zero: 4 of the 9 entries of R. Always
// zero: p[2].
template <class Scalar, class SinCos = LibrarySinCos>
inline void forward_kinematics(const Scalar* q, Scalar* R, Scalar* p,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = s_1 * s_2;
  R[0] = R[4] = c_1 * c_2 - t1;
  const Scalar t2 = c_1 * s_2;
  const Scalar n_1_t_y = t2 + s_1 * c_2;
  R[3] = n_1_t_y;
  R[1] = -n_1_t_y;
  const Scalar p_2_x = Scalar(0.09) * c_2 + Scalar(0.09);
  p[1] = Scalar(0.09) * t2 + s_1 * p_2_x;
  p[0] = c_1 * p_2_x - Scalar(0.09) * t1;
  R[8] = Scalar(1.0);
  R[2] = R[5] = R[6] = R[7] = p[2] = Scalar(0.0);
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[12] = {
    1, 1,
    1, 1,
    0, 0,
    0, 0,
    0, 0,
    1, 1};

// Geometric Jacobian of the tip (7.14), (7.15).
//   q[4]   in   joint positions, rad or m
//   J[12]  out  geometric Jacobian in base axes: linear rows, then angular
//               6 x 2, row by row: entry (i, j) is J[2 * i + j]
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..3]. Operations: 31 mul, 20 add, 1 div, 8 sin/cos. Always zero: 6 of the 12 entries of
// J.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool jacobian(const Scalar* q, Scalar* J, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  const Scalar R_l1b41_x = c_3 * s_4 + s_3 * c_4;
  const Scalar t1 = Scalar(0.0081) * R_l1b41_x;
  const Scalar t2 = c_1 * c_2 - s_1 * s_2;
  const Scalar t3 = Scalar(0.0081) * c_3;
  const Scalar t4 = c_4 * t3 - Scalar(0.0081) * s_3 * s_4;
  const Scalar R_21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t5 = t2 * t1 - R_21_x * t4;
  const Scalar t6 = Scalar(1.0) / t5;
  const Scalar J_l1b3_y = t3 + t4;
  const Scalar p_l1be_y = s_3 + R_l1b41_x;
  const Scalar t7 = t6 * (t4 * p_l1be_y - R_l1b41_x * J_l1b3_y);
  J[11] = -t7;
  const Scalar p_l1ae_x = c_1 + t2;
  const Scalar p_l1ae_y = s_1 + R_21_x;
  const Scalar t8 = t6 * (p_l1ae_x * t1 - p_l1ae_y * t4);
  const Scalar p_2_x = Scalar(0.09) * c_2 + Scalar(0.09);
  const Scalar t9 = Scalar(0.09) * s_1;
  const Scalar t10 = c_1 * p_2_x - s_2 * t9;
  const Scalar t11 = Scalar(0.09) * c_1;
  const Scalar t12 = t10 - t11;
  J[2] = t10 - t12 * t8;
  J[10] = Scalar(1.0) - t8;
  const Scalar p_1u_t_y = s_2 * t11 + s_1 * p_2_x;
  const Scalar J_P2_x = t9 - p_1u_t_y;
  J[1] = -J_P2_x * t7;
  J[3] = -t12 * t7;
  J[0] = -p_1u_t_y - J_P2_x * t8;
  J[4] = J[5] = J[6] = J[7] = J[8] = J[9] = Scalar(0.0);
  const Scalar regular_l1 = t5 * t5 - Scalar(6.561e-17);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// (dJ/dt) qd of the tip.
//   q[4]   in   joint positions, rad or m
//   qd[2]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..3], qd[0..1]. Operations: 60 mul, 31 add, 1 div, 8 sin/cos. Always zero: a[2], a[3],
// a[4].
template <class Scalar, class SinCos = LibrarySinCos>
inline bool jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  const Scalar t1 = Scalar(0.09) * c_1;
  const Scalar t2 = Scalar(0.09) * s_1;
  const Scalar t3 = c_2 * t1 - s_2 * t2;
  const Scalar p_l1ae_x = t3 + t1;
  const Scalar R_l1a21_x = s_2 * t1 + c_2 * t2;
  const Scalar p_l1ae_y = R_l1a21_x + t2;
  const Scalar t4 = qd_1 * (R_l1a21_x * p_l1ae_x - t3 * p_l1ae_y);
  const Scalar t5 = Scalar(0.09) * c_3;
  const Scalar t6 = Scalar(0.09) * s_3;
  const Scalar R_l1b41_x = s_4 * t5 + c_4 * t6;
  const Scalar p_l1be_y = R_l1b41_x + t6;
  const Scalar t7 = c_3 * c_4 - s_3 * s_4;
  const Scalar t8 = Scalar(-0.09) * t7;
  const Scalar J_l1b3_y = t5 - t8;
  const Scalar t9 = t3 * R_l1b41_x + R_l1a21_x * t8;
  const Scalar t10 = Scalar(1.0) / t9;
  const Scalar omega_l4_z = qd_2 - t10 * (t4 + qd_2 * (t3 * p_l1be_y - R_l1a21_x * J_l1b3_y));
  const Scalar t11 = omega_l4_z * omega_l4_z;
  const Scalar t12 = qd_1 * qd_1;
  const Scalar t13 = qd_2 * qd_2;
  const Scalar t14 = c_1 * t12 - c_3 * t13 - t7 * t11;
  const Scalar t15 = qd_1 * (p_l1ae_x * R_l1b41_x + p_l1ae_y * t8);
  const Scalar omega_l2_z = qd_1 - t10 * (t15 - qd_2 * (p_l1be_y * t8 + R_l1b41_x * J_l1b3_y));
  const Scalar t16 = omega_l2_z * omega_l2_z;
  const Scalar t17 = s_1 * t12 - s_3 * t13;
  const Scalar t18 = R_l1b41_x * (Scalar(0.09) * t17 + R_l1a21_x * t16 - R_l1b41_x * t11);
  const Scalar t19 = t10 * (t8 * (Scalar(0.09) * t14 + t3 * t16) - t18);
  a[5] = -t19;
  const Scalar t20 = Scalar(0.09) * t12;
  const Scalar t21 = Scalar(0.09) * t19 - s_2 * t20;
  const Scalar t22 = c_2 * t20 + Scalar(0.09) * t16;
  const Scalar t23 = c_2 * t22 - s_2 * t21;
  const Scalar t24 = s_2 * t22 + c_2 * t21;
  a[0] = s_1 * t24 - c_1 * t23;
  a[1] = -c_1 * t24 - s_1 * t23;
  a[2] = a[3] = a[4] = Scalar(0.0);
  const Scalar regular_l1 = t9 * t9 - Scalar(6.561e-17);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// Phi(q): what lies between the points where the loops are closed.
//   q[4]    in   joint positions, rad or m
//   phi[2]  out  loop by loop, m: what lies between the points that meet; 0 if closed
// Reads q[0..3]. Operations: 10 mul, 9 add, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void loop_closure(const Scalar* q, Scalar* phi, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  const Scalar t1 = c_2 + Scalar(1.0);
  const Scalar t2 = c_4 + Scalar(1.0);
  const Scalar t3 = s_1 * s_2 - s_3 * s_4 - c_1 * t1 + c_3 * t2;
  phi[0] = Scalar(0.118) + Scalar(0.09) * t3;
  const Scalar t4 = c_1 * s_2 - c_3 * s_4 + s_1 * t1 - s_3 * t2;
  phi[1] = Scalar(-0.09) * t4;
}

// The entries of phi_q in loop_jacobian that are not always zero.
inline constexpr bool loop_jacobian_nonzero[8] = {
    1, 1, 1, 1,
    1, 1, 1, 1};

// Phi_q, the derivative of loop_closure.
//   q[4]      in   joint positions, rad or m
//   phi_q[8]  out  row i, column k: of phi[i] by q[k]
//                  2 x 4, row by row: entry (i, j) is phi_q[4 * i + j]
// Reads q[0..3]. Operations: 16 mul, 8 add, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void loop_jacobian(const Scalar* q, Scalar* phi_q, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar phi_q_12 = Scalar(0.09) * R_l1a21_x;
  phi_q[1] = phi_q_12;
  const Scalar t1 = s_1 * s_2 - c_1 * c_2;
  phi_q[5] = Scalar(0.09) * t1;
  const Scalar phi_q_24 = Scalar(-0.09) * (s_3 * s_4 - c_3 * c_4);
  phi_q[7] = phi_q_24;
  const Scalar R_l1b41_x = s_3 * c_4 + c_3 * s_4;
  phi_q[3] = Scalar(-0.09) * R_l1b41_x;
  phi_q[0] = phi_q_12 + Scalar(0.09) * s_1;
  phi_q[2] = Scalar(-0.09) * (s_3 + R_l1b41_x);
  phi_q[6] = phi_q_24 + Scalar(0.09) * c_3;
  phi_q[4] = Scalar(-0.09) * (c_1 - t1);
}

// Newton's step of the dependent joints towards closed loops.
//   q[4]   in   joint positions, rad or m
//   dq[4]  out  to be added to q, again and again; 0 for independent joints, which stay
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..3]. Operations: 20 mul, 15 add, 1 div, 8 sin/cos. Always zero: dq[0], dq[2].
template <class Scalar, class SinCos = LibrarySinCos>
inline bool loop_step(const Scalar* q, Scalar* dq, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  const Scalar t1 = c_1 * c_2 - s_1 * s_2;
  const Scalar t2 = c_3 * c_4 - s_3 * s_4;
  const Scalar t3 = Scalar(0.0081) * (c_3 - (c_1 + t1 - t2)) + Scalar(0.01062);
  const Scalar R_l1a21_x = c_1 * s_2 + s_1 * c_2;
  const Scalar R_l1b41_x = c_3 * s_4 + s_3 * c_4;
  const Scalar t4 = (R_l1a21_x - R_l1b41_x) + (s_1 - s_3);
  const Scalar t5 = Scalar(0.0081) * R_l1b41_x;
  const Scalar t6 = Scalar(0.0081) * R_l1a21_x;
  const Scalar t7 = t1 * t5 - t2 * t6;
  const Scalar t8 = Scalar(1.0) / t7;
  dq[1] = t8 * (t2 * t3 - t4 * t5);
  dq[3] = t8 * (t1 * t3 - t4 * t6);
  dq[0] = dq[2] = Scalar(0.0);
  const Scalar regular_l1 = t7 * t7 - Scalar(6.561e-17);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// Rates and accelerations of all joints of q, from those of the independent ones.
//   q[4]              in   joint positions, rad or m
//   qd[2]             in   joint velocities, rad/s or m/s
//   qdd[2]            in   joint accelerations, rad/s^2 or m/s^2
//   rates[4]          out  dq/dt of every entry of q
//   accelerations[4]  out  its derivative
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..3], qd[0..1], qdd[0..1]. Operations: 54 mul, 30 add, 1 div, 8 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool loop_motion(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* rates,
    Scalar* accelerations, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1, 2, 3>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1], s_3 = sine[2],
      c_3 = cosine[2], s_4 = sine[3], c_4 = cosine[3];
  rates[0] = qd_1;
  rates[2] = qd_2;
  accelerations[0] = qdd_1;
  accelerations[2] = qdd_2;
  const Scalar t1 = Scalar(0.09) * c_1;
  const Scalar t2 = Scalar(0.09) * s_1;
  const Scalar t3 = c_2 * t1 - s_2 * t2;
  const Scalar p_l1ae_x = t3 + t1;
  const Scalar t4 = Scalar(0.09) * c_3;
  const Scalar t5 = Scalar(0.09) * s_3;
  const Scalar R_l1b41_x = s_4 * t4 + c_4 * t5;
  const Scalar R_l1a21_x = s_2 * t1 + c_2 * t2;
  const Scalar p_l1ae_y = R_l1a21_x + t2;
  const Scalar t6 = c_3 * c_4 - s_3 * s_4;
  const Scalar t7 = Scalar(-0.09) * t6;
  const Scalar t8 = p_l1ae_x * R_l1b41_x + p_l1ae_y * t7;
  const Scalar p_l1be_y = R_l1b41_x + t5;
  const Scalar J_l1b3_y = t4 - t7;
  const Scalar t9 = p_l1be_y * t7 + R_l1b41_x * J_l1b3_y;
  const Scalar t10 = t3 * R_l1b41_x + R_l1a21_x * t7;
  const Scalar t11 = Scalar(1.0) / t10;
  const Scalar t12 = t11 * (t8 * qd_1 - t9 * qd_2);
  rates[1] = -t12;
  const Scalar t13 = R_l1a21_x * p_l1ae_x - t3 * p_l1ae_y;
  const Scalar t14 = t3 * p_l1be_y - R_l1a21_x * J_l1b3_y;
  const Scalar t15 = t11 * (t13 * qd_1 + t14 * qd_2);
  rates[3] = -t15;
  const Scalar omega_l4_z = qd_2 - t15;
  const Scalar t16 = omega_l4_z * omega_l4_z;
  const Scalar t17 = qd_1 * qd_1;
  const Scalar t18 = qd_2 * qd_2;
  const Scalar t19 = c_1 * t17 - c_3 * t18 - t6 * t16;
  const Scalar omega_l2_z = qd_1 - t12;
  const Scalar t20 = omega_l2_z * omega_l2_z;
  const Scalar t21 = Scalar(0.09) * t19 + t3 * t20;
  const Scalar t22 = s_1 * t17 - s_3 * t18;
  const Scalar t23 = Scalar(0.09) * t22 + R_l1a21_x * t20 - R_l1b41_x * t16;
  const Scalar t24 = -t13 * qdd_1 - t14 * qdd_2 + t3 * t21 + R_l1a21_x * t23;
  accelerations[3] = t11 * t24;
  const Scalar t25 = t8 * qdd_1 - t9 * qdd_2 + t7 * t21 - R_l1b41_x * t23;
  accelerations[1] = -t11 * t25;
  const Scalar regular_l1 = t10 * t10 - Scalar(6.561e-17);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// The functions by type, with the shapes of their arguments: what adapters such as
// flatdyn/eigen.hpp are given.
namespace functions {

struct inverse_dynamics {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[4], const Scalar (&qd)[2], const Scalar (&qdd)[2],
      Scalar (&tau)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::inverse_dynamics(of...); }
};

struct inverse_dynamics_tip_force {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[4], const Scalar (&qd)[2], const Scalar (&qdd)[2],
      const Scalar (&h_e)[6], Scalar (&tau)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept {
    return ::five_bar::inverse_dynamics_tip_force(of...);
  }
};

struct inertia_matrix {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[4], Scalar (&B)[2][2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::inertia_matrix(of...); }
};

struct christoffel {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[4], Scalar (&c)[2][3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::christoffel(of...); }
};

struct coriolis_matrix {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[4], const Scalar (&qd)[2], Scalar (&C)[2][2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::coriolis_matrix(of...); }
};

struct gravity {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[4], Scalar (&g)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::gravity(of...); }
};

struct bias {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[4], const Scalar (&qd)[2], Scalar (&n)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::bias(of...); }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[4], const Scalar (&qd)[2], const Scalar (&tau)[2],
      Scalar (&qdd)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::forward_dynamics(of...); }
};

struct kinetic_energy {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[4], const Scalar (&qd)[2], Scalar (&T)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::kinetic_energy(of...); }
};

struct potential_energy {
  template <class Scalar>
  using Shape = Scalar(const Scalar (&q)[4]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::potential_energy(of...); }
};

struct forward_kinematics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[4], Scalar (&R)[3][3], Scalar (&p)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::forward_kinematics(of...); }
};

struct jacobian {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[4], Scalar (&J)[6][2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::jacobian(of...); }
};

struct jacobian_dot_qd {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[4], const Scalar (&qd)[2], Scalar (&a)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::jacobian_dot_qd(of...); }
};

struct loop_closure {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[4], Scalar (&phi)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::loop_closure(of...); }
};

struct loop_jacobian {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[4], Scalar (&phi_q)[2][4]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::loop_jacobian(of...); }
};

struct loop_step {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[4], Scalar (&dq)[4]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::loop_step(of...); }
};

struct loop_motion {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[4], const Scalar (&qd)[2], const Scalar (&qdd)[2],
      Scalar (&rates)[4], Scalar (&accelerations)[4]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::five_bar::loop_motion(of...); }
};

}  // namespace functions

// Moves the dependent joints of q until the loops are closed, by Newton's method with halved steps
// where a full one does not lessen the gap. Returns false, and leaves q as it was, where the gap is
// larger than `tolerance` (m) after `most_steps`: the loops cannot be closed from there, or are
// singular. Which of several ways to close them is found depends on where q is.
template <class Scalar>
inline bool close_loops(Scalar* q, Scalar tolerance, int most_steps = 20) noexcept {
  Scalar here[position_count], next[position_count], dq[position_count], phi[2];
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

}  // namespace five_bar

#endif  // FLATDYN_FIVE_BAR_HPP_E15D8AA1

// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "slider_crank" as flat code: 3 joints, 1 of them independent.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Input: sha1:f6bd304ca84354b5223c16e31aeadf566eaff92e
//
//   q  qd  joint    moves link  type       unit
//   0  0   theta_1  crank       revolute   rad
//   1  -   theta_2  rod         revolute   rad
//   2  -   x        slider      prismatic  m
//
// Gravity is (0, 0, 0) m/s^2 in the base frame. The tip belongs to link "slider". Closed loops make
// theta_2, x follow from the other joints: q has the positions of all of them, qd, qdd and tau are
// those of the others. Functions hold where q closes the loops. Names with lk belong to loop k:
// R_lk, p_lk and r_lk to the way from its carrier to its two ends, Phi_lk to its closure's
// derivative by q, inv_lk is the reciprocal of the determinant that its joints are found with, and
// regular_lk is positive unless the loop is singular. A_i_j is how joint i moves with the joint of
// qd[j - 1], drift how it accelerates if that one does not.
//
// Every function is a template over its scalar: float, double, or any type that is made from a
// double, has + - * / (also - of one), comparisons, and sin, cos where argument-dependent lookup
// finds them (or an argument that knows them, see LibrarySinCos). Arguments are plain arrays:
//
//   double q[3] = {}, qd[1] = {}, qdd[1] = {}, tau[1];
//   const bool result = slider_crank::inverse_dynamics(q, qd, qdd, tau);
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

#ifndef FLATDYN_SLIDER_CRANK_HPP_EFB864B6
#define FLATDYN_SLIDER_CRANK_HPP_EFB864B6

#include <cmath>

namespace slider_crank {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 1;
inline constexpr int position_count = 3;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {"theta_1"};

// The joints of q.
inline constexpr const char* position_names[position_count] = {"theta_1", "theta_2", "x"};

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
//   q[3]    in   joint positions, rad or m
//   qd[1]   in   joint velocities, rad/s or m/s
//   qdd[1]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[1]  out  joint torques, N m (forces, N, for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..1], qd[0], qdd[0]. Operations: 38 mul, 18 add, 1 div, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar qdd_1 = qdd[0];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = s_1 * s_2 - c_1 * c_2;
  const Scalar t2 = Scalar(-0.3) * t1;
  const Scalar t3 = Scalar(0.15) * c_1;
  const Scalar p_l1ae_x = t3 + t2;
  const Scalar t4 = Scalar(3.3333333333333335) / t1;
  const Scalar t5 = p_l1ae_x * t4 + Scalar(1.0);
  const Scalar t6 = qd_1 * qd_1;
  const Scalar t7 = t5 * t5 * t6;
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t8 = Scalar(0.3) * R_l1a21_x;
  const Scalar t9 = Scalar(0.15) * s_1;
  const Scalar driftr1_2 = t9 * t6 + t8 * t7;
  const Scalar t10 = t4 * driftr1_2 - qdd_1 * t5;
  const Scalar t11 = s_2 * t7 + c_2 * t10;
  const Scalar t12 = t8 * driftr1_2 + t2 * (t3 * t6 + t2 * t7);
  const Scalar p_l1ae_y = t9 + t8;
  const Scalar t13 = t2 * p_l1ae_y - p_l1ae_x * t8;
  const Scalar t14 = t4 * t4 * t13 * (t13 * qdd_1 + t12);
  const Scalar t15 = t5 * (Scalar(0.0079337659) * t10 -
      Scalar(0.00339984) * (s_2 * t6 + c_2 * qdd_1));
  tau[0] = Scalar(0.00815184) * qdd_1 - Scalar(0.00339984) * t11 + Scalar(0.075552) * t14 - t15;
  const Scalar regular_l1 = Scalar(0.09) * t1 * t1 - Scalar(9e-14);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[3]    in   joint positions, rad or m
//   qd[1]   in   joint velocities, rad/s or m/s
//   qdd[1]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[1]  out  joint torques, N m (forces, N, for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..1], qd[0], qdd[0], h_e[0]. Operations: 38 mul, 19 add, 1 div, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool inverse_dynamics_tip_force(const Scalar* q, const Scalar* qd, const Scalar* qdd,
    const Scalar* h_e, Scalar* tau, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar qdd_1 = qdd[0];
  const Scalar h_e_1 = h_e[0];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = s_1 * s_2 - c_1 * c_2;
  const Scalar t2 = Scalar(-0.3) * t1;
  const Scalar t3 = Scalar(0.15) * c_1;
  const Scalar p_l1ae_x = t3 + t2;
  const Scalar t4 = Scalar(3.3333333333333335) / t1;
  const Scalar t5 = p_l1ae_x * t4 + Scalar(1.0);
  const Scalar t6 = qd_1 * qd_1;
  const Scalar t7 = t5 * t5 * t6;
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t8 = Scalar(0.3) * R_l1a21_x;
  const Scalar t9 = Scalar(0.15) * s_1;
  const Scalar driftr1_2 = t9 * t6 + t8 * t7;
  const Scalar t10 = t8 * driftr1_2 + t2 * (t3 * t6 + t2 * t7);
  const Scalar p_l1ae_y = t9 + t8;
  const Scalar t11 = t2 * p_l1ae_y - p_l1ae_x * t8;
  const Scalar f_3_z = Scalar(0.075552) * t4 * (t11 * qdd_1 + t10) + h_e_1;
  const Scalar t12 = t4 * driftr1_2 - qdd_1 * t5;
  const Scalar t13 = s_2 * t7 + c_2 * t12;
  const Scalar t14 = t5 * (Scalar(0.0079337659) * t12 -
      Scalar(0.00339984) * (s_2 * t6 + c_2 * qdd_1));
  tau[0] = Scalar(0.00815184) * qdd_1 - Scalar(0.00339984) * t13 - t14 + t4 * t11 * f_3_z;
  const Scalar regular_l1 = Scalar(0.09) * t1 * t1 - Scalar(9e-14);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[1] = {
    1};

// Joint-space inertia matrix B(q) (7.32).
//   q[3]  in   joint positions, rad or m
//   B[1]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//              1 x 1, row by row: entry (i, j) is B[1 * i + j]
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..1]. Operations: 21 mul, 12 add, 1 div, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool inertia_matrix(const Scalar* q, Scalar* B, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t1 = Scalar(0.3) * R_l1a21_x;
  const Scalar p_l1ae_y = Scalar(0.15) * s_1 + t1;
  const Scalar t2 = s_1 * s_2 - c_1 * c_2;
  const Scalar t3 = Scalar(-0.3) * t2;
  const Scalar p_l1ae_x = Scalar(0.15) * c_1 + t3;
  const Scalar t4 = Scalar(3.3333333333333335) / t2;
  const Scalar t5 = t4 * (t3 * p_l1ae_y - p_l1ae_x * t1);
  const Scalar t6 = p_l1ae_x * t4;
  const Scalar mu_2_1_z = Scalar(0.00339984) * c_2 + Scalar(0.0079337659);
  const Scalar b_1_2h = mu_2_1_z + Scalar(0.0079337659) * t6;
  B[0] = Scalar(0.00679968) * c_2 + Scalar(0.075552) * t5 * t5 + t6 * b_1_2h + mu_2_1_z * t6 +
      Scalar(0.0160856059);
  const Scalar regular_l1 = Scalar(0.09) * t2 * t2 - Scalar(9e-14);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[1] = {
    1};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[3]  in   joint positions, rad or m
//   c[1]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//              c_ijk = c_ikj is c[1 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..1]. Operations: 28 mul, 13 add, 1 div, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool christoffel(const Scalar* q, Scalar* c, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = s_1 * s_2 - c_1 * c_2;
  const Scalar t2 = Scalar(-0.3) * t1;
  const Scalar t3 = Scalar(0.15) * c_1;
  const Scalar p_l1ae_x = t3 + t2;
  const Scalar t4 = Scalar(3.3333333333333335) / t1;
  const Scalar t5 = p_l1ae_x * t4 + Scalar(1.0);
  const Scalar t6 = t5 * t5;
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t7 = Scalar(0.3) * R_l1a21_x;
  const Scalar t8 = Scalar(0.15) * s_1;
  const Scalar H_1_1r1_2 = t8 + t7 * t6;
  const Scalar H_1_1r1_1 = t3 + t2 * t6;
  const Scalar p_l1ae_y = t8 + t7;
  const Scalar t9 = t2 * p_l1ae_y - p_l1ae_x * t7;
  const Scalar t10 = t4 * t9 * (t7 * H_1_1r1_2 + t2 * H_1_1r1_1);
  const Scalar b_1_2h = Scalar(0.00339984) * c_2 + Scalar(0.0079337659) * t5;
  const Scalar t11 = (Scalar(0.075552) * t10 - b_1_2h * H_1_1r1_2) -
      Scalar(0.00339984) * s_2 * p_l1ae_x * t5;
  c[0] = t4 * t11;
  const Scalar regular_l1 = Scalar(0.09) * t1 * t1 - Scalar(9e-14);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// The entries of C in coriolis_matrix that are not always zero.
inline constexpr bool coriolis_matrix_nonzero[1] = {
    1};

// C(q, qd) from the Christoffel symbols (7.44).
//   q[3]   in   joint positions, rad or m
//   qd[1]  in   joint velocities, rad/s or m/s
//   C[1]   out  c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric
//               1 x 1, row by row: entry (i, j) is C[1 * i + j]
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..1], qd[0]. Operations: 29 mul, 13 add, 1 div, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool coriolis_matrix(const Scalar* q, const Scalar* qd, Scalar* C,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = s_1 * s_2 - c_1 * c_2;
  const Scalar t2 = Scalar(-0.3) * t1;
  const Scalar t3 = Scalar(0.15) * c_1;
  const Scalar p_l1ae_x = t3 + t2;
  const Scalar t4 = Scalar(3.3333333333333335) / t1;
  const Scalar t5 = p_l1ae_x * t4 + Scalar(1.0);
  const Scalar t6 = t5 * t5;
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t7 = Scalar(0.3) * R_l1a21_x;
  const Scalar t8 = Scalar(0.15) * s_1;
  const Scalar H_1_1r1_2 = t8 + t7 * t6;
  const Scalar H_1_1r1_1 = t3 + t2 * t6;
  const Scalar p_l1ae_y = t8 + t7;
  const Scalar t9 = t2 * p_l1ae_y - p_l1ae_x * t7;
  const Scalar t10 = t4 * t9 * (t7 * H_1_1r1_2 + t2 * H_1_1r1_1);
  const Scalar b_1_2h = Scalar(0.00339984) * c_2 + Scalar(0.0079337659) * t5;
  const Scalar t11 = (Scalar(0.075552) * t10 - b_1_2h * H_1_1r1_2) -
      Scalar(0.00339984) * s_2 * p_l1ae_x * t5;
  C[0] = qd_1 * t4 * t11;
  const Scalar regular_l1 = Scalar(0.09) * t1 * t1 - Scalar(9e-14);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// Gravity torques g(q) (7.39).
//   q[3]  in   joint positions, rad or m
//   g[1]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads nothing. Operations: 0 mul, 0 add. Always zero: g[0].
template <class Scalar>
inline void gravity(const Scalar* /* q */, Scalar* g) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  g[0] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[3]   in   joint positions, rad or m
//   qd[1]  in   joint velocities, rad/s or m/s
//   n[1]   out  joint torques, N m (forces, N, for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..1], qd[0]. Operations: 31 mul, 13 add, 1 div, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool bias(const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = s_1 * s_2 - c_1 * c_2;
  const Scalar t2 = Scalar(-0.3) * t1;
  const Scalar p_l1ae_x = Scalar(0.15) * c_1 + t2;
  const Scalar t3 = Scalar(3.3333333333333335) / t1;
  const Scalar t4 = p_l1ae_x * t3 + Scalar(1.0);
  const Scalar t5 = t4 * Scalar(-2.0) * t4;
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t6 = s_1 - R_l1a21_x * t5;
  const Scalar t7 = R_l1a21_x * t6 - t1 * (c_1 + t1 * t5);
  const Scalar t8 = Scalar(0.3) * R_l1a21_x;
  const Scalar p_l1ae_y = Scalar(0.15) * s_1 + t8;
  const Scalar t9 = t3 * (t2 * p_l1ae_y - p_l1ae_x * t8) * t7;
  const Scalar t10 = t4 * (Scalar(2.856852632871358) * s_2 * p_l1ae_x + t6);
  const Scalar t11 = (t9 - Scalar(0.15) * c_2 * t6) - Scalar(0.35003555608499226) * t10;
  n[0] = Scalar(0.00339984) * qd_1 * qd_1 * t3 * t11;
  const Scalar regular_l1 = Scalar(0.09) * t1 * t1 - Scalar(9e-14);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[3]    in   joint positions, rad or m
//   qd[1]   in   joint velocities, rad/s or m/s
//   tau[1]  in   joint torques or forces, N m or N
//   qdd[1]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular, or a pivot of B is not positive or not a number.
// Reads q[0..1], qd[0], tau[0]. Operations: 39 mul, 22 add, 2 div, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar tau_1 = tau[0];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = s_1 * s_2 - c_1 * c_2;
  const Scalar t2 = Scalar(-0.3) * t1;
  const Scalar t3 = Scalar(0.15) * c_1;
  const Scalar p_l1ae_x = t3 + t2;
  const Scalar t4 = Scalar(3.3333333333333335) / t1;
  const Scalar t5 = p_l1ae_x * t4;
  const Scalar omega_l2_z = qd_1 + t5 * qd_1;
  const Scalar t6 = omega_l2_z * omega_l2_z;
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t7 = Scalar(0.3) * R_l1a21_x;
  const Scalar t8 = Scalar(0.15) * s_1;
  const Scalar t9 = qd_1 * qd_1;
  const Scalar driftr1_2 = t8 * t9 + t7 * t6;
  const Scalar driftr1_1 = t3 * t9 + t2 * t6;
  const Scalar p_l1ae_y = t8 + t7;
  const Scalar t10 = t4 * (t2 * p_l1ae_y - p_l1ae_x * t7);
  const Scalar t11 = Scalar(0.075552) * t10;
  const Scalar t12 = t4 * t11 * (t7 * driftr1_2 + t2 * driftr1_1);
  const Scalar t13 = t4 * driftr1_2;
  const Scalar t14 = Scalar(0.00339984) * s_2;
  const Scalar t15 = t9 * t14 - Scalar(0.0079337659) * t13;
  const Scalar t16 = Scalar(0.00339984) * c_2;
  const Scalar t17 = -t6 * t14 - t16 * t13 + t15 + t12 + t5 * t15 - tau_1;
  const Scalar mu_2_1_z = t16 + Scalar(0.0079337659);
  const Scalar b_1_2h = mu_2_1_z + Scalar(0.0079337659) * t5;
  const Scalar b_1_1q = Scalar(0.00679968) * c_2 + t10 * t11 + t5 * b_1_2h + mu_2_1_z * t5 +
      Scalar(0.0160856059);
  qdd[0] = -t17 / b_1_1q;
  const Scalar regular_l1 = Scalar(0.09) * t1 * t1 - Scalar(9e-14);
  bool positive = b_1_1q > Scalar(0.0);
  positive &= regular_l1 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[3]   in   joint positions, rad or m
//   qd[1]  in   joint velocities, rad/s or m/s
//   T[1]   out  kinetic energy, J
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..1], qd[0]. Operations: 24 mul, 10 add, 1 div, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool kinetic_energy(const Scalar* q, const Scalar* qd, Scalar* T,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t1 = Scalar(0.3) * R_l1a21_x;
  const Scalar p_l1ae_y = Scalar(0.15) * s_1 + t1;
  const Scalar t2 = s_1 * s_2 - c_1 * c_2;
  const Scalar t3 = Scalar(-0.3) * t2;
  const Scalar p_l1ae_x = Scalar(0.15) * c_1 + t3;
  const Scalar t4 = qd_1 * (Scalar(3.3333333333333335) / t2);
  const Scalar t5 = (t3 * p_l1ae_y - p_l1ae_x * t1) * t4;
  const Scalar omega_2_z = qd_1 + p_l1ae_x * t4;
  const Scalar L_2_z = Scalar(0.00679968) * c_2 * qd_1 + Scalar(0.0079337659) * omega_2_z;
  T[0] = Scalar(0.037776) * t5 * t5 + Scalar(0.00407592) * qd_1 * qd_1 +
      Scalar(0.5) * omega_2_z * L_2_z;
  const Scalar regular_l1 = Scalar(0.09) * t2 * t2 - Scalar(9e-14);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// Potential energy of links and rotors (7.36).
//   q[3]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads nothing. Operations: 0 mul, 0 add.
template <class Scalar>
inline Scalar potential_energy(const Scalar* /* q */) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  return Scalar(0.0);
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    1, 0, 0,
    0, 1, 0,
    0, 0, 1};

// Pose of the tip (2.50).
//   q[3]  in   joint positions, rad or m
//   R[9]  out  rotation matrix of the frame in the base frame
//              3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]  out  position of the frame's origin in the base frame, m
// Reads q[2]. Operations: 0 mul, 0 add. Always zero: 6 of the 9 entries of R. Always zero: p[1],
// p[2].
template <class Scalar>
inline void forward_kinematics(const Scalar* q, Scalar* R, Scalar* p) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar q_3 = q[2];
  p[0] = q_3;
  R[0] = R[4] = R[8] = Scalar(1.0);
  R[1] = R[2] = R[3] = R[5] = R[6] = R[7] = p[1] = p[2] = Scalar(0.0);
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[6] = {
    1,
    0,
    0,
    0,
    0,
    0};

// Geometric Jacobian of the tip (7.14), (7.15).
//   q[3]  in   joint positions, rad or m
//   J[6]  out  geometric Jacobian in base axes: linear rows, then angular
//              6 x 1, row by row: entry (i, j) is J[1 * i + j]
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..1]. Operations: 12 mul, 6 add, 1 div, 4 sin/cos. Always zero: 5 of the 6 entries of J.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool jacobian(const Scalar* q, Scalar* J, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = c_1 * c_2 - s_1 * s_2;
  const Scalar p_l1ae_x = c_1 + Scalar(2.0) * t1;
  const Scalar R_l1a21_x = c_1 * s_2 + s_1 * c_2;
  const Scalar p_l1ae_y = s_1 + Scalar(2.0) * R_l1a21_x;
  J[0] = Scalar(0.045) * (Scalar(3.3333333333333335) / t1) * (R_l1a21_x * p_l1ae_x - t1 * p_l1ae_y);
  J[1] = J[2] = J[3] = J[4] = J[5] = Scalar(0.0);
  const Scalar regular_l1 = Scalar(0.09) * t1 * t1 - Scalar(9e-14);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// (dJ/dt) qd of the tip.
//   q[3]   in   joint positions, rad or m
//   qd[1]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..1], qd[0]. Operations: 21 mul, 8 add, 1 div, 4 sin/cos. Always zero: a[1], a[2], a[3],
// a[4], a[5].
template <class Scalar, class SinCos = LibrarySinCos>
inline bool jacobian_dot_qd(const Scalar* q, const Scalar* qd, Scalar* a,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar t1 = s_1 * s_2 - c_1 * c_2;
  const Scalar t2 = Scalar(-0.3) * t1;
  const Scalar t3 = Scalar(0.15) * c_1;
  const Scalar p_l1ae_x = t3 + t2;
  const Scalar t4 = Scalar(3.3333333333333335) / t1;
  const Scalar omega_l2_z = qd_1 + qd_1 * p_l1ae_x * t4;
  const Scalar t5 = omega_l2_z * omega_l2_z;
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t6 = Scalar(0.3) * R_l1a21_x;
  const Scalar t7 = qd_1 * qd_1;
  const Scalar driftr1_2 = Scalar(0.15) * s_1 * t7 + t5 * t6;
  const Scalar driftr1_1 = t3 * t7 + t2 * t5;
  a[0] = t4 * (t6 * driftr1_2 + t2 * driftr1_1);
  a[1] = a[2] = a[3] = a[4] = a[5] = Scalar(0.0);
  const Scalar regular_l1 = Scalar(0.09) * t1 * t1 - Scalar(9e-14);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// Phi(q): what lies between the points where the loops are closed.
//   q[3]    in   joint positions, rad or m
//   phi[2]  out  loop by loop, m: what lies between the points that meet; 0 if closed
// Reads q[0..2]. Operations: 8 mul, 5 add, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void loop_closure(const Scalar* q, Scalar* phi, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar q_3 = q[2];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar R_l1a21_x = c_1 * s_2 + s_1 * c_2;
  const Scalar p_l1ae_y = Scalar(0.15) * s_1 + Scalar(0.3) * R_l1a21_x;
  phi[1] = -p_l1ae_y;
  const Scalar R_l1a20_x = c_1 * c_2 - s_1 * s_2;
  const Scalar p_l1ae_x = Scalar(0.15) * c_1 + Scalar(0.3) * R_l1a20_x;
  phi[0] = q_3 - p_l1ae_x;
}

// The entries of phi_q in loop_jacobian that are not always zero.
inline constexpr bool loop_jacobian_nonzero[6] = {
    1, 1, 1,
    1, 1, 0};

// Phi_q, the derivative of loop_closure.
//   q[3]      in   joint positions, rad or m
//   phi_q[6]  out  row i, column k: of phi[i] by q[k]
//                  2 x 3, row by row: entry (i, j) is phi_q[3 * i + j]
// Reads q[0..1]. Operations: 8 mul, 4 add, 4 sin/cos. Always zero: 1 of the 6 entries of phi_q.
template <class Scalar, class SinCos = LibrarySinCos>
inline void loop_jacobian(const Scalar* q, Scalar* phi_q, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar R_l1a21_x = c_1 * s_2 + s_1 * c_2;
  const Scalar phi_q_12 = Scalar(0.3) * R_l1a21_x;
  phi_q[1] = phi_q_12;
  const Scalar Phi_l12_2 = Scalar(-0.3) * (c_1 * c_2 - s_1 * s_2);
  phi_q[4] = Phi_l12_2;
  phi_q[0] = Scalar(0.15) * s_1 + phi_q_12;
  phi_q[3] = Phi_l12_2 - Scalar(0.15) * c_1;
  phi_q[2] = Scalar(1.0);
  phi_q[5] = Scalar(0.0);
}

// Newton's step of the dependent joints towards closed loops.
//   q[3]   in   joint positions, rad or m
//   dq[3]  out  to be added to q, again and again; 0 for independent joints, which stay
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..2]. Operations: 14 mul, 7 add, 1 div, 4 sin/cos. Always zero: dq[0].
template <class Scalar, class SinCos = LibrarySinCos>
inline bool loop_step(const Scalar* q, Scalar* dq, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar q_3 = q[2];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t1 = Scalar(0.3) * R_l1a21_x;
  const Scalar p_l1ae_y = Scalar(0.15) * s_1 + t1;
  const Scalar t2 = s_1 * s_2 - c_1 * c_2;
  const Scalar t3 = Scalar(3.3333333333333335) / t2;
  dq[1] = p_l1ae_y * t3;
  const Scalar t4 = Scalar(-0.3) * t2;
  dq[2] = -t3 * (t1 * p_l1ae_y + t4 * (Scalar(0.15) * c_1 + t4 - q_3));
  dq[0] = Scalar(0.0);
  const Scalar regular_l1 = Scalar(0.09) * t2 * t2 - Scalar(9e-14);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// Rates and accelerations of all joints of q, from those of the independent ones.
//   q[3]              in   joint positions, rad or m
//   qd[1]             in   joint velocities, rad/s or m/s
//   qdd[1]            in   joint accelerations, rad/s^2 or m/s^2
//   rates[3]          out  dq/dt of every entry of q
//   accelerations[3]  out  its derivative
// Returns false if the result means nothing, because a closed loop is within 1e-6 of being
// singular.
// Reads q[0..1], qd[0], qdd[0]. Operations: 27 mul, 12 add, 1 div, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool loop_motion(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* rates,
    Scalar* accelerations, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar qdd_1 = qdd[0];
  Scalar sine[position_count], cosine[position_count];
  sin_cos(q, Joints<0, 1>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0], s_2 = sine[1], c_2 = cosine[1];
  rates[0] = qd_1;
  accelerations[0] = qdd_1;
  const Scalar t1 = s_1 * s_2 - c_1 * c_2;
  const Scalar t2 = Scalar(-0.3) * t1;
  const Scalar t3 = Scalar(0.15) * c_1;
  const Scalar p_l1ae_x = t3 + t2;
  const Scalar t4 = Scalar(3.3333333333333335) / t1;
  const Scalar t5 = t4 * qd_1;
  const Scalar qd_2 = p_l1ae_x * t5;
  rates[1] = qd_2;
  const Scalar R_l1a21_x = s_1 * c_2 + c_1 * s_2;
  const Scalar t6 = Scalar(0.3) * R_l1a21_x;
  const Scalar t7 = Scalar(0.15) * s_1;
  const Scalar p_l1ae_y = t7 + t6;
  const Scalar t8 = t2 * p_l1ae_y - p_l1ae_x * t6;
  rates[2] = t8 * t5;
  const Scalar omega_l2_z = qd_1 + qd_2;
  const Scalar t9 = omega_l2_z * omega_l2_z;
  const Scalar t10 = qd_1 * qd_1;
  const Scalar driftr1_2 = t7 * t10 + t6 * t9;
  accelerations[1] = -t4 * (driftr1_2 - p_l1ae_x * qdd_1);
  const Scalar t11 = t6 * driftr1_2 + t2 * (t3 * t10 + t2 * t9);
  accelerations[2] = t4 * (t8 * qdd_1 + t11);
  const Scalar regular_l1 = Scalar(0.09) * t1 * t1 - Scalar(9e-14);
  bool positive = regular_l1 > Scalar(0.0);
  return positive;
}

// The functions by type, with the shapes of their arguments: what adapters such as
// flatdyn/eigen.hpp are given.
namespace functions {

struct inverse_dynamics {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[3], const Scalar (&qd)[1], const Scalar (&qdd)[1],
      Scalar (&tau)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::inverse_dynamics(of...); }
};

struct inverse_dynamics_tip_force {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[3], const Scalar (&qd)[1], const Scalar (&qdd)[1],
      const Scalar (&h_e)[6], Scalar (&tau)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept {
    return ::slider_crank::inverse_dynamics_tip_force(of...);
  }
};

struct inertia_matrix {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[3], Scalar (&B)[1][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::inertia_matrix(of...); }
};

struct christoffel {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[3], Scalar (&c)[1][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::christoffel(of...); }
};

struct coriolis_matrix {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[3], const Scalar (&qd)[1], Scalar (&C)[1][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::coriolis_matrix(of...); }
};

struct gravity {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[3], Scalar (&g)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::gravity(of...); }
};

struct bias {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[3], const Scalar (&qd)[1], Scalar (&n)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::bias(of...); }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[3], const Scalar (&qd)[1], const Scalar (&tau)[1],
      Scalar (&qdd)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::forward_dynamics(of...); }
};

struct kinetic_energy {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[3], const Scalar (&qd)[1], Scalar (&T)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::kinetic_energy(of...); }
};

struct potential_energy {
  template <class Scalar>
  using Shape = Scalar(const Scalar (&q)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::potential_energy(of...); }
};

struct forward_kinematics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[3], Scalar (&R)[3][3], Scalar (&p)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::forward_kinematics(of...); }
};

struct jacobian {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[3], Scalar (&J)[6][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::jacobian(of...); }
};

struct jacobian_dot_qd {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[3], const Scalar (&qd)[1], Scalar (&a)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::jacobian_dot_qd(of...); }
};

struct loop_closure {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[3], Scalar (&phi)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::loop_closure(of...); }
};

struct loop_jacobian {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[3], Scalar (&phi_q)[2][3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::loop_jacobian(of...); }
};

struct loop_step {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[3], Scalar (&dq)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::loop_step(of...); }
};

struct loop_motion {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[3], const Scalar (&qd)[1], const Scalar (&qdd)[1],
      Scalar (&rates)[3], Scalar (&accelerations)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::slider_crank::loop_motion(of...); }
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

}  // namespace slider_crank

#endif  // FLATDYN_SLIDER_CRANK_HPP_EFB864B6

// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "cartesian_2" as flat code: 2 joints.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Input: sha1:8c80a6d4e2911959b52effae71ae8265e8d373a7
//
//   index  joint  moves link  type       unit
//   0      d_1    link1       prismatic  m
//   1      d_2    link2       prismatic  m
//
// Gravity is (0, 0, -g) m/s^2 in the base frame. The tip belongs to link "link2".
//
// Every function is a template over its scalar: float, double, or any type that is made from a
// double, has + - * / (also - of one), comparisons, and sin, cos where argument-dependent lookup
// finds them (or an argument that knows them, see LibrarySinCos). Arguments are plain arrays:
//
//   cartesian_2::Parameters<> parameters = {};  // then set its members
//   double q[2] = {}, qd[2] = {}, qdd[2] = {}, tau[2];
//   cartesian_2::inverse_dynamics(parameters, q, qd, qdd, tau);
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

#ifndef FLATDYN_CARTESIAN_2_HPP_F3D6E501
#define FLATDYN_CARTESIAN_2_HPP_F3D6E501

#include <cmath>

namespace cartesian_2 {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 2;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {"d_1", "d_2"};

// What the robot file leaves open: an argument of every function. Units as in the file.
template <class Scalar = Real>
struct Parameters {
  Scalar g;  // m/s^2
  Scalar m_l1;  // kg
  Scalar m_m1;  // kg
  Scalar I_m1;  // kg m^2
  Scalar k_r1;
  Scalar m_l2;  // kg
  Scalar m_m2;  // kg
  Scalar I_m2;  // kg m^2
  Scalar k_r2;
};

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

// tau = B(q) qdd + C(q, qd) qd + g(q) + friction (7.42).
//   q[2]    in   joint positions, rad or m
//   qd[2]   in   joint velocities, rad/s or m/s
//   qdd[2]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads qdd[0..1], parameters.g, parameters.m_l1, parameters.I_m1, parameters.k_r1,
// parameters.m_l2, parameters.m_m2, parameters.I_m2, parameters.k_r2. Operations: 7 mul, 5 add.
template <class Scalar>
inline void inverse_dynamics(const Parameters<Scalar>& parameters, const Scalar* /* q */,
    const Scalar* /* qd */, const Scalar* qdd, Scalar* tau) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1];
  const Scalar g = parameters.g, m_l1 = parameters.m_l1, I_m1 = parameters.I_m1,
      k_r1 = parameters.k_r1, m_l2 = parameters.m_l2, m_m2 = parameters.m_m2,
      I_m2 = parameters.I_m2, k_r2 = parameters.k_r2;
  tau[1] = qdd_2 * (m_l2 + I_m2 * k_r2 * k_r2);
  const Scalar m_1 = m_l1 + m_m2;
  const Scalar ddp_s_1_z = g + qdd_1;
  tau[0] = I_m1 * k_r1 * k_r1 * qdd_1 + ddp_s_1_z * (m_l2 + m_1);
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[2]    in   joint positions, rad or m
//   qd[2]   in   joint velocities, rad/s or m/s
//   qdd[2]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads qdd[0..1], h_e[0], h_e[2], parameters.g, parameters.m_l1, parameters.I_m1, parameters.k_r1,
// parameters.m_l2, parameters.m_m2, parameters.I_m2, parameters.k_r2. Operations: 7 mul, 7 add.
template <class Scalar>
inline void inverse_dynamics_tip_force(const Parameters<Scalar>& parameters, const Scalar* /* q */,
    const Scalar* /* qd */, const Scalar* qdd, const Scalar* h_e, Scalar* tau) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qdd_1 = qdd[0], qdd_2 = qdd[1];
  const Scalar h_e_1 = h_e[0], h_e_3 = h_e[2];
  const Scalar g = parameters.g, m_l1 = parameters.m_l1, I_m1 = parameters.I_m1,
      k_r1 = parameters.k_r1, m_l2 = parameters.m_l2, m_m2 = parameters.m_m2,
      I_m2 = parameters.I_m2, k_r2 = parameters.k_r2;
  const Scalar m_1 = m_l1 + m_m2;
  const Scalar ddp_s_1_z = g + qdd_1;
  tau[0] = h_e_3 + I_m1 * k_r1 * k_r1 * qdd_1 + ddp_s_1_z * (m_l2 + m_1);
  tau[1] = h_e_1 + qdd_2 * (m_l2 + I_m2 * k_r2 * k_r2);
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[4] = {
    1, 0,
    0, 1};

// Joint-space inertia matrix B(q) (7.32).
//   q[2]  in   joint positions, rad or m
//   B[4]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//              2 x 2, row by row: entry (i, j) is B[2 * i + j]
// Reads parameters.m_l1, parameters.I_m1, parameters.k_r1, parameters.m_l2, parameters.m_m2,
// parameters.I_m2, parameters.k_r2. Operations: 4 mul, 4 add. Always zero: 2 of the 4 entries of B.
template <class Scalar>
inline void inertia_matrix(const Parameters<Scalar>& parameters, const Scalar* /* q */,
    Scalar* B) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar m_l1 = parameters.m_l1, I_m1 = parameters.I_m1, k_r1 = parameters.k_r1,
      m_l2 = parameters.m_l2, m_m2 = parameters.m_m2, I_m2 = parameters.I_m2,
      k_r2 = parameters.k_r2;
  const Scalar mc_1 = m_l1 + m_l2 + m_m2;
  B[0] = mc_1 + I_m1 * k_r1 * k_r1;
  B[3] = m_l2 + I_m2 * k_r2 * k_r2;
  B[1] = B[2] = Scalar(0.0);
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[6] = {
    0, 0, 0,
    0, 0, 0};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[2]  in   joint positions, rad or m
//   c[6]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//              c_ijk = c_ikj is c[3 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads nothing. Operations: 0 mul, 0 add. Always zero: 6 of the 6 entries of c.
template <class Scalar>
inline void christoffel(const Parameters<Scalar>& /* parameters */, const Scalar* /* q */,
    Scalar* c) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  c[0] = c[1] = c[2] = c[3] = c[4] = c[5] = Scalar(0.0);
}

// The entries of C in coriolis_matrix that are not always zero.
inline constexpr bool coriolis_matrix_nonzero[4] = {
    0, 0,
    0, 0};

// C(q, qd) from the Christoffel symbols (7.44).
//   q[2]   in   joint positions, rad or m
//   qd[2]  in   joint velocities, rad/s or m/s
//   C[4]   out  c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric
//               2 x 2, row by row: entry (i, j) is C[2 * i + j]
// Reads nothing. Operations: 0 mul, 0 add. Always zero: 4 of the 4 entries of C.
template <class Scalar>
inline void coriolis_matrix(const Parameters<Scalar>& /* parameters */, const Scalar* /* q */,
    const Scalar* /* qd */, Scalar* C) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  C[0] = C[1] = C[2] = C[3] = Scalar(0.0);
}

// Gravity torques g(q) (7.39).
//   q[2]  in   joint positions, rad or m
//   g[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads parameters.g, parameters.m_l1, parameters.m_l2, parameters.m_m2. Operations: 1 mul, 2 add.
// Always zero: g[1].
template <class Scalar>
inline void gravity(const Parameters<Scalar>& parameters, const Scalar* /* q */,
    Scalar* g) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar g_2 = parameters.g, m_l1 = parameters.m_l1, m_l2 = parameters.m_l2,
      m_m2 = parameters.m_m2;
  const Scalar mc_1 = m_l1 + m_l2 + m_m2;
  g[0] = g_2 * mc_1;
  g[1] = Scalar(0.0);
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[2]   in   joint positions, rad or m
//   qd[2]  in   joint velocities, rad/s or m/s
//   n[2]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads parameters.g, parameters.m_l1, parameters.m_l2, parameters.m_m2. Operations: 1 mul, 2 add.
// Always zero: n[1].
template <class Scalar>
inline void bias(const Parameters<Scalar>& parameters, const Scalar* /* q */,
    const Scalar* /* qd */, Scalar* n) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar g = parameters.g, m_l1 = parameters.m_l1, m_l2 = parameters.m_l2,
      m_m2 = parameters.m_m2;
  const Scalar m_1 = m_l1 + m_m2;
  n[0] = g * (m_l2 + m_1);
  n[1] = Scalar(0.0);
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[2]    in   joint positions, rad or m
//   qd[2]   in   joint velocities, rad/s or m/s
//   tau[2]  in   joint torques or forces, N m or N
//   qdd[2]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads tau[0..1], parameters.g, parameters.m_l1, parameters.I_m1, parameters.k_r1,
// parameters.m_l2, parameters.m_m2, parameters.I_m2, parameters.k_r2. Operations: 5 mul, 5 add, 2
// div.
template <class Scalar>
inline bool forward_dynamics(const Parameters<Scalar>& parameters, const Scalar* /* q */,
    const Scalar* /* qd */, const Scalar* tau, Scalar* qdd) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar tau_1 = tau[0], tau_2 = tau[1];
  const Scalar g = parameters.g, m_l1 = parameters.m_l1, I_m1 = parameters.I_m1,
      k_r1 = parameters.k_r1, m_l2 = parameters.m_l2, m_m2 = parameters.m_m2,
      I_m2 = parameters.I_m2, k_r2 = parameters.k_r2;
  const Scalar b_2_2 = m_l2 + I_m2 * k_r2 * k_r2;
  qdd[1] = tau_2 / b_2_2;
  const Scalar m_1 = m_l1 + m_m2;
  const Scalar mc_1 = m_l2 + m_1;
  const Scalar b_1_1 = mc_1 + I_m1 * k_r1 * k_r1;
  qdd[0] = (tau_1 - g * mc_1) / b_1_1;
  bool positive = b_1_1 > Scalar(0.0);
  positive &= b_2_2 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[2]   in  joint positions, rad or m
//   qd[2]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads qd[0..1], parameters.m_l1, parameters.I_m1, parameters.k_r1, parameters.m_l2,
// parameters.m_m2, parameters.I_m2, parameters.k_r2. Operations: 10 mul, 5 add.
template <class Scalar>
inline Scalar kinetic_energy(const Parameters<Scalar>& parameters, const Scalar* /* q */,
    const Scalar* qd) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0], qd_2 = qd[1];
  const Scalar m_l1 = parameters.m_l1, I_m1 = parameters.I_m1, k_r1 = parameters.k_r1,
      m_l2 = parameters.m_l2, m_m2 = parameters.m_m2, I_m2 = parameters.I_m2,
      k_r2 = parameters.k_r2;
  const Scalar t1 = qd_2 * qd_2;
  const Scalar t2 = qd_1 * qd_1;
  const Scalar v_v_2 = t1 + t2;
  const Scalar m_1 = m_l1 + m_m2;
  const Scalar t3 = t2 * (m_1 + I_m1 * k_r1 * k_r1);
  const Scalar T_2 = I_m2 * k_r2 * k_r2 * t1 + m_l2 * v_v_2 + t3;
  return Scalar(0.5) * T_2;
}

// Potential energy of links and rotors (7.36).
//   q[2]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[0], parameters.g, parameters.m_l1, parameters.m_l2, parameters.m_m2. Operations: 2 mul, 2
// add.
template <class Scalar>
inline Scalar potential_energy(const Parameters<Scalar>& parameters, const Scalar* q) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar q_1 = q[0];
  const Scalar g = parameters.g, m_l1 = parameters.m_l1, m_l2 = parameters.m_l2,
      m_m2 = parameters.m_m2;
  const Scalar mc_1 = m_l1 + m_l2 + m_m2;
  return g * q_1 * mc_1;
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    0, 0, 1,
    1, 0, 0,
    0, 1, 0};

// Pose of the tip (2.50).
//   q[2]  in   joint positions, rad or m
//   R[9]  out  rotation matrix of the frame in the base frame
//              3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]  out  position of the frame's origin in the base frame, m
// Reads q[0..1]. Operations: 0 mul, 0 add. Always zero: 6 of the 9 entries of R. Always zero: p[1].
template <class Scalar>
inline void forward_kinematics(const Parameters<Scalar>& /* parameters */, const Scalar* q,
    Scalar* R, Scalar* p) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar q_1 = q[0], q_2 = q[1];
  p[2] = q_1;
  p[0] = q_2;
  R[2] = Scalar(1.0);
  R[0] = R[1] = R[4] = R[5] = R[6] = R[8] = p[1] = Scalar(0.0);
  R[3] = R[7] = Scalar(-1.0);
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[12] = {
    0, 1,
    0, 0,
    1, 0,
    0, 0,
    0, 0,
    0, 0};

// Geometric Jacobian of the tip (7.14), (7.15).
//   q[2]   in   joint positions, rad or m
//   J[12]  out  geometric Jacobian in base axes: linear rows, then angular
//               6 x 2, row by row: entry (i, j) is J[2 * i + j]
// Reads nothing. Operations: 0 mul, 0 add. Always zero: 10 of the 12 entries of J.
template <class Scalar>
inline void jacobian(const Parameters<Scalar>& /* parameters */, const Scalar* /* q */,
    Scalar* J) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  J[1] = J[4] = Scalar(1.0);
  J[0] = J[2] = J[3] = J[5] = J[6] = J[7] = J[8] = J[9] = Scalar(0.0);
  J[10] = J[11] = Scalar(0.0);
}

// (dJ/dt) qd of the tip.
//   q[2]   in   joint positions, rad or m
//   qd[2]  in   joint velocities, rad/s or m/s
//   a[6]   out  (dJ/dt) qd in base axes: linear m/s^2, then angular rad/s^2
// Reads nothing. Operations: 0 mul, 0 add. Always zero: a[0], a[1], a[2], a[3], a[4], a[5].
template <class Scalar>
inline void jacobian_dot_qd(const Parameters<Scalar>& /* parameters */, const Scalar* /* q */,
    const Scalar* /* qd */, Scalar* a) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  a[0] = a[1] = a[2] = a[3] = a[4] = a[5] = Scalar(0.0);
}

// The functions by type, with the shapes of their arguments: what adapters such as
// flatdyn/eigen.hpp are given.
namespace functions {

struct inverse_dynamics {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], const Scalar (&qd)[2],
      const Scalar (&qdd)[2], Scalar (&tau)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::cartesian_2::inverse_dynamics(of...); }
};

struct inverse_dynamics_tip_force {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], const Scalar (&qd)[2],
      const Scalar (&qdd)[2], const Scalar (&h_e)[6], Scalar (&tau)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept {
    return ::cartesian_2::inverse_dynamics_tip_force(of...);
  }
};

struct inertia_matrix {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], Scalar (&B)[2][2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::cartesian_2::inertia_matrix(of...); }
};

struct christoffel {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], Scalar (&c)[2][3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::cartesian_2::christoffel(of...); }
};

struct coriolis_matrix {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], const Scalar (&qd)[2],
      Scalar (&C)[2][2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::cartesian_2::coriolis_matrix(of...); }
};

struct gravity {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], Scalar (&g)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::cartesian_2::gravity(of...); }
};

struct bias {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], const Scalar (&qd)[2],
      Scalar (&n)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::cartesian_2::bias(of...); }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[2], const Scalar (&qd)[2],
      const Scalar (&tau)[2], Scalar (&qdd)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::cartesian_2::forward_dynamics(of...); }
};

struct kinetic_energy {
  template <class Scalar>
  using Shape = Scalar(const Parameters<Scalar>&, const Scalar (&q)[2], const Scalar (&qd)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::cartesian_2::kinetic_energy(of...); }
};

struct potential_energy {
  template <class Scalar>
  using Shape = Scalar(const Parameters<Scalar>&, const Scalar (&q)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::cartesian_2::potential_energy(of...); }
};

struct forward_kinematics {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], Scalar (&R)[3][3],
      Scalar (&p)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::cartesian_2::forward_kinematics(of...); }
};

struct jacobian {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], Scalar (&J)[6][2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::cartesian_2::jacobian(of...); }
};

struct jacobian_dot_qd {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[2], const Scalar (&qd)[2],
      Scalar (&a)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::cartesian_2::jacobian_dot_qd(of...); }
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

}  // namespace cartesian_2

#endif  // FLATDYN_CARTESIAN_2_HPP_F3D6E501

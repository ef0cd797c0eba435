// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "pendulum_motor" as flat code: 1 joint.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Input: sha1:590ca7faf02658234a2643ca52068cc6bca5b179
//
//   index  joint  moves link  type      unit
//   0      theta  pendulum    revolute  rad
//
// Gravity is (g, 0, 0) m/s^2 in the base frame. The tip belongs to link "pendulum".
//
// Every function is a template over its scalar: float, double, or any type that is made from a
// double, has + - * / (also - of one), comparisons, and sin, cos where argument-dependent lookup
// finds them (or an argument that knows them, see LibrarySinCos). Arguments are plain arrays:
//
//   pendulum_motor::Parameters<> parameters = {};  // then set its members
//   double q[1] = {}, qd[1] = {}, qdd[1] = {}, tau[1];
//   pendulum_motor::inverse_dynamics(parameters, q, qd, qdd, tau);
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

#ifndef FLATDYN_PENDULUM_MOTOR_HPP_E5F76919
#define FLATDYN_PENDULUM_MOTOR_HPP_E5F76919

#include <cmath>

namespace pendulum_motor {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 1;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {"theta"};

// What the robot file leaves open: an argument of every function. Units as in the file.
template <class Scalar = Real>
struct Parameters {
  Scalar g;  // m/s^2
  Scalar m;  // kg
  Scalar l;  // m
  Scalar I;  // kg m^2
  Scalar F;  // N m s/rad or N s/m
  Scalar F_m;
  Scalar k_r;
  Scalar I_m;  // kg m^2
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
//   q[1]    in   joint positions, rad or m
//   qd[1]   in   joint velocities, rad/s or m/s
//   qdd[1]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[1]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0], qd[0], qdd[0], parameters.g, parameters.m, parameters.l, parameters.I, parameters.F,
// parameters.F_m, parameters.k_r, parameters.I_m. Operations: 8 mul, 4 add, 1 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics(const Parameters<Scalar>& parameters, const Scalar* q,
    const Scalar* qd, const Scalar* qdd, Scalar* tau, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar qdd_1 = qdd[0];
  const Scalar g = parameters.g, m = parameters.m, l = parameters.l, I = parameters.I,
      F = parameters.F, F_m = parameters.F_m, k_r = parameters.k_r, I_m = parameters.I_m;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0>(), sine, cosine);
  const Scalar s_1 = sine[0];
  const Scalar t1 = k_r * k_r;
  const Scalar F_v1 = F + F_m * t1;
  const Scalar t2 = g * m * l * s_1;
  tau[0] = t2 + qd_1 * F_v1 + qdd_1 * (I + I_m * t1);
}

// Inverse dynamics with a force h_e that the tip exerts on the environment (7.42).
//   q[1]    in   joint positions, rad or m
//   qd[1]   in   joint velocities, rad/s or m/s
//   qdd[1]  in   joint accelerations, rad/s^2 or m/s^2
//   h_e[6]  in   force (N), then moment (N m), that the tip exerts on its environment, base frame
//   tau[1]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0], qd[0], qdd[0], h_e[5], parameters.g, parameters.m, parameters.l, parameters.I,
// parameters.F, parameters.F_m, parameters.k_r, parameters.I_m. Operations: 8 mul, 5 add, 1
// sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void inverse_dynamics_tip_force(const Parameters<Scalar>& parameters, const Scalar* q,
    const Scalar* qd, const Scalar* qdd, const Scalar* h_e, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar qdd_1 = qdd[0];
  const Scalar h_e_6 = h_e[5];
  const Scalar g = parameters.g, m = parameters.m, l = parameters.l, I = parameters.I,
      F = parameters.F, F_m = parameters.F_m, k_r = parameters.k_r, I_m = parameters.I_m;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0>(), sine, cosine);
  const Scalar s_1 = sine[0];
  const Scalar t1 = k_r * k_r;
  const Scalar F_v1 = F + F_m * t1;
  const Scalar t2 = g * m * l * s_1;
  tau[0] = t2 + qd_1 * F_v1 + h_e_6 + qdd_1 * (I + I_m * t1);
}

// The entries of B in inertia_matrix that are not always zero.
inline constexpr bool inertia_matrix_nonzero[1] = {
    1};

// Joint-space inertia matrix B(q) (7.32).
//   q[1]  in   joint positions, rad or m
//   B[1]  out  inertia matrix, symmetric, kg m^2 (kg for prismatic joints)
//              1 x 1, row by row: entry (i, j) is B[1 * i + j]
// Reads parameters.I, parameters.k_r, parameters.I_m. Operations: 2 mul, 1 add.
template <class Scalar>
inline void inertia_matrix(const Parameters<Scalar>& parameters, const Scalar* /* q */,
    Scalar* B) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar I = parameters.I, k_r = parameters.k_r, I_m = parameters.I_m;
  B[0] = I + k_r * k_r * I_m;
}

// The entries of c in christoffel that are not always zero.
inline constexpr bool christoffel_nonzero[1] = {
    0};

// Christoffel symbols of the first kind c_ijk(q) (7.45).
//   q[1]  in   joint positions, rad or m
//   c[1]  out  Christoffel symbols c_ijk = c_ikj, j <= k
//              c_ijk = c_ikj is c[1 * i + k * (k + 1) / 2 + j] for j <= k, counted from 0
// Reads nothing. Operations: 0 mul, 0 add. Always zero: 1 of the 1 entries of c.
template <class Scalar>
inline void christoffel(const Parameters<Scalar>& /* parameters */, const Scalar* /* q */,
    Scalar* c) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  c[0] = Scalar(0.0);
}

// The entries of C in coriolis_matrix that are not always zero.
inline constexpr bool coriolis_matrix_nonzero[1] = {
    0};

// C(q, qd) from the Christoffel symbols (7.44).
//   q[1]   in   joint positions, rad or m
//   qd[1]  in   joint velocities, rad/s or m/s
//   C[1]   out  c_ij = sum_k c_ijk qd_k, so that dB/dt - 2 C is skew-symmetric
//               1 x 1, row by row: entry (i, j) is C[1 * i + j]
// Reads nothing. Operations: 0 mul, 0 add. Always zero: 1 of the 1 entries of C.
template <class Scalar>
inline void coriolis_matrix(const Parameters<Scalar>& /* parameters */, const Scalar* /* q */,
    const Scalar* /* qd */, Scalar* C) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  C[0] = Scalar(0.0);
}

// Gravity torques g(q) (7.39).
//   q[1]  in   joint positions, rad or m
//   g[1]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0], parameters.g, parameters.m, parameters.l. Operations: 3 mul, 0 add, 1 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void gravity(const Parameters<Scalar>& parameters, const Scalar* q, Scalar* g,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar g_2 = parameters.g, m = parameters.m, l = parameters.l;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0>(), sine, cosine);
  const Scalar s_1 = sine[0];
  g[0] = g_2 * m * l * s_1;
}

// C(q, qd) qd + g(q) + friction (7.116).
//   q[1]   in   joint positions, rad or m
//   qd[1]  in   joint velocities, rad/s or m/s
//   n[1]   out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0], qd[0], parameters.g, parameters.m, parameters.l, parameters.F, parameters.F_m,
// parameters.k_r. Operations: 6 mul, 2 add, 1 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline void bias(const Parameters<Scalar>& parameters, const Scalar* q, const Scalar* qd, Scalar* n,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar g = parameters.g, m = parameters.m, l = parameters.l, F = parameters.F,
      F_m = parameters.F_m, k_r = parameters.k_r;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0>(), sine, cosine);
  const Scalar s_1 = sine[0];
  const Scalar F_v1 = F + F_m * k_r * k_r;
  n[0] = g * m * l * s_1 + qd_1 * F_v1;
}

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[1]    in   joint positions, rad or m
//   qd[1]   in   joint velocities, rad/s or m/s
//   tau[1]  in   joint torques or forces, N m or N
//   qdd[1]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[0], qd[0], tau[0], parameters.g, parameters.m, parameters.l, parameters.I, parameters.F,
// parameters.F_m, parameters.k_r, parameters.I_m. Operations: 7 mul, 4 add, 1 div, 1 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline bool forward_dynamics(const Parameters<Scalar>& parameters, const Scalar* q,
    const Scalar* qd, const Scalar* tau, Scalar* qdd, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar tau_1 = tau[0];
  const Scalar g = parameters.g, m = parameters.m, l = parameters.l, I = parameters.I,
      F = parameters.F, F_m = parameters.F_m, k_r = parameters.k_r, I_m = parameters.I_m;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0>(), sine, cosine);
  const Scalar s_1 = sine[0];
  const Scalar t1 = k_r * k_r;
  const Scalar F_v1 = F + F_m * t1;
  const Scalar b_1_1 = I + I_m * t1;
  qdd[0] = (-g * m * l * s_1 - qd_1 * F_v1 + tau_1) / b_1_1;
  bool positive = b_1_1 > Scalar(0.0);
  return positive;
}

// Kinetic energy of links and rotors (7.31).
//   q[1]   in  joint positions, rad or m
//   qd[1]  in  joint velocities, rad/s or m/s
// Returns T: kinetic energy, J.
// Reads qd[0], parameters.I, parameters.k_r, parameters.I_m. Operations: 5 mul, 1 add.
template <class Scalar>
inline Scalar kinetic_energy(const Parameters<Scalar>& parameters, const Scalar* /* q */,
    const Scalar* qd) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar qd_1 = qd[0];
  const Scalar I = parameters.I, k_r = parameters.k_r, I_m = parameters.I_m;
  return Scalar(0.5) * qd_1 * qd_1 * (I + k_r * k_r * I_m);
}

// Potential energy of links and rotors (7.36).
//   q[1]  in  joint positions, rad or m
// Returns U: potential energy, J; zero at the base frame's origin.
// Reads q[0], parameters.g, parameters.m, parameters.l. Operations: 3 mul, 0 add, 1 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
inline Scalar potential_energy(const Parameters<Scalar>& parameters, const Scalar* q,
    const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  const Scalar g = parameters.g, m = parameters.m, l = parameters.l;
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0>(), sine, cosine);
  const Scalar c_1 = cosine[0];
  return -g * m * l * c_1;
}

// The entries of R in forward_kinematics that are not always zero.
inline constexpr bool forward_kinematics_R_nonzero[9] = {
    1, 1, 0,
    1, 1, 0,
    0, 0, 1};

// Pose of the tip (2.50).
//   q[1]  in   joint positions, rad or m
//   R[9]  out  rotation matrix of the frame in the base frame
//              3 x 3, row by row: entry (i, j) is R[3 * i + j]
//   p[3]  out  position of the frame's origin in the base frame, m
// Reads q[0]. Operations: 0 mul, 0 add, 2 sin/cos. Always zero: 4 of the 9 entries of R. Always
// zero: p[0], p[1], p[2].
template <class Scalar, class SinCos = LibrarySinCos>
inline void forward_kinematics(const Parameters<Scalar>& /* parameters */, const Scalar* q,
    Scalar* R, Scalar* p, const SinCos& sin_cos = {}) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  Scalar sine[joint_count], cosine[joint_count];
  sin_cos(q, Joints<0>(), sine, cosine);
  const Scalar s_1 = sine[0], c_1 = cosine[0];
  R[0] = R[4] = c_1;
  R[3] = s_1;
  R[1] = -s_1;
  R[8] = Scalar(1.0);
  R[2] = R[5] = R[6] = R[7] = p[0] = p[1] = p[2] = Scalar(0.0);
}

// The entries of J in jacobian that are not always zero.
inline constexpr bool jacobian_nonzero[6] = {
    0,
    0,
    0,
    0,
    0,
    1};

// Geometric Jacobian of the tip (7.14), (7.15).
//   q[1]  in   joint positions, rad or m
//   J[6]  out  geometric Jacobian in base axes: linear rows, then angular
//              6 x 1, row by row: entry (i, j) is J[1 * i + j]
// Reads nothing. Operations: 0 mul, 0 add. Always zero: 5 of the 6 entries of J.
template <class Scalar>
inline void jacobian(const Parameters<Scalar>& /* parameters */, const Scalar* /* q */,
    Scalar* J) noexcept {
  static_assert(detail::Interface::checked<Scalar>());
  J[5] = Scalar(1.0);
  J[0] = J[1] = J[2] = J[3] = J[4] = Scalar(0.0);
}

// (dJ/dt) qd of the tip.
//   q[1]   in   joint positions, rad or m
//   qd[1]  in   joint velocities, rad/s or m/s
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
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[1], const Scalar (&qd)[1],
      const Scalar (&qdd)[1], Scalar (&tau)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::pendulum_motor::inverse_dynamics(of...); }
};

struct inverse_dynamics_tip_force {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[1], const Scalar (&qd)[1],
      const Scalar (&qdd)[1], const Scalar (&h_e)[6], Scalar (&tau)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept {
    return ::pendulum_motor::inverse_dynamics_tip_force(of...);
  }
};

struct inertia_matrix {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[1], Scalar (&B)[1][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::pendulum_motor::inertia_matrix(of...); }
};

struct christoffel {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[1], Scalar (&c)[1][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::pendulum_motor::christoffel(of...); }
};

struct coriolis_matrix {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[1], const Scalar (&qd)[1],
      Scalar (&C)[1][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::pendulum_motor::coriolis_matrix(of...); }
};

struct gravity {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[1], Scalar (&g)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::pendulum_motor::gravity(of...); }
};

struct bias {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[1], const Scalar (&qd)[1],
      Scalar (&n)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::pendulum_motor::bias(of...); }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Parameters<Scalar>&, const Scalar (&q)[1], const Scalar (&qd)[1],
      const Scalar (&tau)[1], Scalar (&qdd)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::pendulum_motor::forward_dynamics(of...); }
};

struct kinetic_energy {
  template <class Scalar>
  using Shape = Scalar(const Parameters<Scalar>&, const Scalar (&q)[1], const Scalar (&qd)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::pendulum_motor::kinetic_energy(of...); }
};

struct potential_energy {
  template <class Scalar>
  using Shape = Scalar(const Parameters<Scalar>&, const Scalar (&q)[1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::pendulum_motor::potential_energy(of...); }
};

struct forward_kinematics {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[1], Scalar (&R)[3][3],
      Scalar (&p)[3]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::pendulum_motor::forward_kinematics(of...); }
};

struct jacobian {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[1], Scalar (&J)[6][1]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::pendulum_motor::jacobian(of...); }
};

struct jacobian_dot_qd {
  template <class Scalar>
  using Shape = void(const Parameters<Scalar>&, const Scalar (&q)[1], const Scalar (&qd)[1],
      Scalar (&a)[6]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::pendulum_motor::jacobian_dot_qd(of...); }
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

}  // namespace pendulum_motor

#endif  // FLATDYN_PENDULUM_MOTOR_HPP_E5F76919

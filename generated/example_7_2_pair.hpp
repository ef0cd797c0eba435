// SPDX-License-Identifier: BSD-3-Clause
//
// The dynamics of robot "planar_2r_example_7_2" as flat code: 2 joints.
// Made by flatdyn 0.1.0 from its robot file; to change it, make it again.
// Options: --functions inverse_dynamics,gravity,forward_dynamics --stages inverse_dynamics,gravity --scalar double,float --form pair --namespace example_7_2_pair --name example_7_2_pair
// Input: sha1:165e0b51c5e87befb79f7319ecd88c0e78014339
//
//   index  joint    moves link  type      unit
//   0      theta_1  link1       revolute  rad
//   1      theta_2  link2       revolute  rad
//
// Gravity is (0, -9.81, 0) m/s^2 in the base frame. The tip belongs to link "link2".
//
// Every function is a template over its scalar, defined in example_7_2_pair.cpp and compiled there
// for double and float, with sines and cosines from LibrarySinCos or GivenSinCos: the list is at
// the end. Whatever else is called does not link. Arguments are plain arrays:
//
//   double q[2] = {}, qd[2] = {}, qdd[2] = {}, tau[2];
//   example_7_2_pair::inverse_dynamics(q, qd, qdd, tau);
//
// Entries come in the order of the table. Units are SI; "rad or m" goes by the type of the joint.
// Every entry of an output is written, zeros too. All inputs are read before anything is written:
// inputs may share memory with each other and with outputs, but outputs must not overlap each
// other. Nothing allocates, throws, or keeps state.

#ifndef FLATDYN_EXAMPLE_7_2_PAIR_HPP_BA8597B1
#define FLATDYN_EXAMPLE_7_2_PAIR_HPP_BA8597B1

#include <cmath>

namespace example_7_2_pair {

// The scalar that the tool was asked for: that of the constants, and of Parameters by default.
using Real = double;

inline constexpr int joint_count = 2;

// As the robot file names them.
inline constexpr const char* joint_names[joint_count] = {"theta_1", "theta_2"};

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
//   q[2]    in   joint positions, rad or m
//   qd[2]   in   joint velocities, rad/s or m/s
//   qdd[2]  in   joint accelerations, rad/s^2 or m/s^2
//   tau[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..1], qd[0..1], qdd[0..1]. Operations: 14 mul, 13 add, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
void inverse_dynamics(const Scalar* q, const Scalar* qd, const Scalar* qdd, Scalar* tau,
    const SinCos& sin_cos = {}) noexcept;

// Gravity torques g(q) (7.39).
//   q[2]  in   joint positions, rad or m
//   g[2]  out  joint torques, N m (forces, N, for prismatic joints)
// Reads q[0..1]. Operations: 4 mul, 2 add, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
void gravity(const Scalar* q, Scalar* g, const SinCos& sin_cos = {}) noexcept;

// qdd from B(q) qdd = tau - bias(q, qd) (7.115).
//   q[2]    in   joint positions, rad or m
//   qd[2]   in   joint velocities, rad/s or m/s
//   tau[2]  in   joint torques or forces, N m or N
//   qdd[2]  out  joint accelerations, rad/s^2 (m/s^2 for prismatic joints)
// Returns false if the result means nothing, because a pivot of B is not positive or not a number.
// Reads q[0..1], qd[0..1], tau[0..1]. Operations: 16 mul, 12 add, 1 div, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
bool forward_dynamics(const Scalar* q, const Scalar* qd, const Scalar* tau, Scalar* qdd,
    const SinCos& sin_cos = {}) noexcept;

// Several functions at the same positions, or at the same positions and velocities: what two of
// them need is computed once, by at(), and by with() what depends on velocities, too.
//
//   const auto here = example_7_2_pair::at(q);
//   here.gravity(g);
//   const auto moving = here.with(qd);
//   moving.inverse_dynamics(qdd, tau);
//
// The results are those of the functions above but for roundings.

// The robot at given positions and velocities.
template <class Scalar>
struct Motion {
  // tau = B(q) qdd + C(q, qd) qd + g(q) + friction (7.42).
  void inverse_dynamics(const Scalar* qdd, Scalar* tau) const noexcept;

  // What these share.
  Scalar v1, v2, c_1, c_2;
};

// The robot at given positions.
template <class Scalar>
struct Configuration {
  // Gravity torques g(q) (7.39).
  void gravity(Scalar* g) const noexcept;
  // What depends on velocities, too, and is needed more than once.
  Motion<Scalar> with(const Scalar* qd) const noexcept;

  // What these share.
  Scalar c_1, s_1, c_2, s_2;
};

// What depends on positions only and is needed more than once.
//   q[2]  in  joint positions, rad or m
// Reads q[0..1]. Operations: 0 mul, 0 add, 4 sin/cos.
template <class Scalar, class SinCos = LibrarySinCos>
Configuration<Scalar> at(const Scalar* q, const SinCos& sin_cos = {}) noexcept;

// The functions by type, with the shapes of their arguments: what adapters such as
// flatdyn/eigen.hpp are given.
namespace functions {

struct inverse_dynamics {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[2], const Scalar (&qd)[2], const Scalar (&qdd)[2],
      Scalar (&tau)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::example_7_2_pair::inverse_dynamics(of...); }
  template <class Scalar, class... Of>
  auto operator()(const Motion<Scalar>& stage, Of&&... of) const noexcept {
    return stage.inverse_dynamics(of...);
  }
};

struct gravity {
  template <class Scalar>
  using Shape = void(const Scalar (&q)[2], Scalar (&g)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::example_7_2_pair::gravity(of...); }
  template <class Scalar, class... Of>
  auto operator()(const Configuration<Scalar>& stage, Of&&... of) const noexcept {
    return stage.gravity(of...);
  }
};

struct forward_dynamics {
  template <class Scalar>
  using Shape = bool(const Scalar (&q)[2], const Scalar (&qd)[2], const Scalar (&tau)[2],
      Scalar (&qdd)[2]);
  template <class... Of>
  auto operator()(Of&&... of) const noexcept { return ::example_7_2_pair::forward_dynamics(of...); }
};

}  // namespace functions

// Whether example_7_2_pair.cpp was compiled so that it rounds every operation as it is written, to
// nearest: compilers fuse products into sums unless they are given -ffp-contract=off, and
// -ffast-math or x87 registers change more. What certificates say of rounding errors holds if this
// is true.
template <class Scalar = Real>
bool rounding_is_as_written() noexcept;

// What example_7_2_pair.cpp is compiled for.
extern template void inverse_dynamics(const double* q, const double* qd, const double* qdd,
    double* tau, const LibrarySinCos& sin_cos);
extern template void inverse_dynamics(const double* q, const double* qd, const double* qdd,
    double* tau, const GivenSinCos<double>& sin_cos);
extern template void inverse_dynamics(const float* q, const float* qd, const float* qdd, float* tau,
    const LibrarySinCos& sin_cos);
extern template void inverse_dynamics(const float* q, const float* qd, const float* qdd, float* tau,
    const GivenSinCos<float>& sin_cos);
extern template void gravity(const double* q, double* g, const LibrarySinCos& sin_cos);
extern template void gravity(const double* q, double* g, const GivenSinCos<double>& sin_cos);
extern template void gravity(const float* q, float* g, const LibrarySinCos& sin_cos);
extern template void gravity(const float* q, float* g, const GivenSinCos<float>& sin_cos);
extern template bool forward_dynamics(const double* q, const double* qd, const double* tau,
    double* qdd, const LibrarySinCos& sin_cos);
extern template bool forward_dynamics(const double* q, const double* qd, const double* tau,
    double* qdd, const GivenSinCos<double>& sin_cos);
extern template bool forward_dynamics(const float* q, const float* qd, const float* tau, float* qdd,
    const LibrarySinCos& sin_cos);
extern template bool forward_dynamics(const float* q, const float* qd, const float* tau, float* qdd,
    const GivenSinCos<float>& sin_cos);
extern template Configuration<double> at(const double* q, const LibrarySinCos& sin_cos);
extern template Configuration<double> at(const double* q, const GivenSinCos<double>& sin_cos);
extern template Configuration<float> at(const float* q, const LibrarySinCos& sin_cos);
extern template Configuration<float> at(const float* q, const GivenSinCos<float>& sin_cos);
extern template struct Configuration<double>;
extern template struct Motion<double>;
extern template struct Configuration<float>;
extern template struct Motion<float>;
extern template bool rounding_is_as_written<double>();
extern template bool rounding_is_as_written<float>();

}  // namespace example_7_2_pair

#endif  // FLATDYN_EXAMPLE_7_2_PAIR_HPP_BA8597B1

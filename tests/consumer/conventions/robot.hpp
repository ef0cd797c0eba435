// SPDX-License-Identifier: BSD-3-Clause
// The satellite's functions in every convention, and what the conventions mean, written out once more.
#pragma once

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>

#include "satellite_featherstone.hpp"
#include "satellite_mixed.hpp"
#include "satellite_mujoco.hpp"
#include "satellite_pinocchio.hpp"
#include "satellite_pose.hpp"

constexpr int kSize = satellite::velocity_count, kJointPositions = satellite::position_count,
              kPositions = 7 + kJointPositions;
constexpr std::size_t kBall = 1, kBallVelocity = 7;  // first entries of the ball's quaternion, and of its velocity

template <class S>
using Vector = std::array<S, kSize>;
template <class S>
using Pose = std::array<S, kPositions>;
template <class S>
using Matrix = std::array<S, kSize * kSize>;
template <class S>
using Three = std::array<S, 3>;
template <class S>
using Quaternion = std::array<S, 4>;  // w, x, y, z

enum class Axes { base, world };

struct Meaning {
  const char* name;
  bool scalar_first;
  Axes linear, angular;
  bool angular_first;
};

// The functions of a convention.
#define FLATDYN_CONVENTION(NAME, ...)                                                        \
  struct NAME {                                                                              \
    static constexpr Meaning meaning = {#NAME, __VA_ARGS__};                                 \
    struct Functions {                                                                       \
      satellite::NAME::functions::inverse_dynamics inverse_dynamics;                         \
      satellite::NAME::functions::inverse_dynamics_tip_force inverse_dynamics_tip_force;     \
      satellite::NAME::functions::inertia_matrix inertia_matrix;                             \
      satellite::NAME::functions::coriolis_matrix coriolis_matrix;                           \
      satellite::NAME::functions::gravity gravity;                                           \
      satellite::NAME::functions::bias bias;                                                 \
      satellite::NAME::functions::forward_dynamics forward_dynamics;                         \
      satellite::NAME::functions::kinetic_energy kinetic_energy;                             \
      satellite::NAME::functions::forward_kinematics forward_kinematics;                     \
      satellite::NAME::functions::jacobian jacobian;                                         \
      satellite::NAME::functions::jacobian_dot_qd jacobian_dot_qd;                           \
      satellite::NAME::functions::centroidal_momentum_matrix centroidal_momentum_matrix;     \
      satellite::NAME::functions::centroidal_bias centroidal_bias;                           \
      satellite::NAME::functions::inverse_dynamics_floating inverse_dynamics_floating;       \
      satellite::NAME::functions::centre_of_mass centre_of_mass;                             \
      satellite::NAME::functions::constrained_forward_dynamics constrained_forward_dynamics; \
      satellite::NAME::functions::contact_inverse_dynamics contact_inverse_dynamics;         \
      satellite::NAME::functions::contact_impact contact_impact;                             \
      satellite::NAME::functions::contact_jacobian contact_jacobian;                         \
      satellite::NAME::functions::contact_bias contact_bias;                                 \
    };                                                                                       \
    static constexpr Functions of = {};                                                      \
    template <class S>                                                                       \
    static void integrated_in_place(Pose<S>& q, const Vector<S>& v, S dt) {                  \
      satellite::NAME::integrate(q.data(), v.data(), dt, q.data());                          \
    }                                                                                        \
    template <class S>                                                                       \
    static Pose<S> integrated(const Pose<S>& q, const Vector<S>& v, S dt) {                  \
      Pose<S> next;                                                                          \
      satellite::NAME::integrate(q.data(), v.data(), dt, next.data());                       \
      return next;                                                                           \
    }                                                                                        \
    template <class S>                                                                       \
    static Vector<S> difference(const Pose<S>& from, const Pose<S>& to) {                    \
      Vector<S> v;                                                                           \
      satellite::NAME::difference(from.data(), to.data(), v.data());                         \
      return v;                                                                              \
    }                                                                                        \
  }
FLATDYN_CONVENTION(pose, true, Axes::base, Axes::base, false);
FLATDYN_CONVENTION(pinocchio, false, Axes::base, Axes::base, false);
FLATDYN_CONVENTION(mujoco, true, Axes::world, Axes::base, false);
FLATDYN_CONVENTION(mixed, true, Axes::world, Axes::world, false);
FLATDYN_CONVENTION(featherstone, true, Axes::base, Axes::base, true);

template <class S>
Quaternion<S> product(const Quaternion<S>& a, const Quaternion<S>& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3], a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
}

// e x e*, for e of unit length; `sense` -1: e* x e.
template <class S>
Three<S> turned(const Quaternion<S>& e, const Three<S>& x, int sense = 1) {
  const S s = S(double(sense));
  const Quaternion<S> a = {e[0], s * e[1], s * e[2], s * e[3]}, b = {e[0], -a[1], -a[2], -a[3]};
  const Quaternion<S> result = product(product(a, {S(0.0), x[0], x[1], x[2]}), b);
  return {result[1], result[2], result[3]};
}

template <class S>
Three<S> cross(const Three<S>& a, const Three<S>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class S>
Three<S> sum(const Three<S>& a, const Three<S>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

// The base's entries of flatdyn: a vector with two parts in base axes.
template <class S>
Three<S> part(const Vector<S>& x, std::size_t first) {
  return {x[first], x[first + 1], x[first + 2]};
}

// Linear and angular part in base axes, as the convention writes them.
template <class S>
Vector<S> written(const Meaning& meaning, const Quaternion<S>& e, Three<S> linear, Three<S> angular,
                  const Vector<S>& joints) {
  if (meaning.linear == Axes::world) linear = turned(e, linear);
  if (meaning.angular == Axes::world) angular = turned(e, angular);
  Vector<S> result = joints;
  const std::size_t at = meaning.angular_first ? 3 : 0;
  for (std::size_t k = 0; k < 3; ++k) {
    result[at + k] = linear[k];
    result[3 - at + k] = angular[k];
  }
  return result;
}

// A state of the robot in flatdyn's own numbers.
template <class S>
struct State {
  Three<S> p;
  Quaternion<S> e;
  std::array<S, kJointPositions> q;
  Vector<S> v, a;
};

// Entry k of a quaternion, where the convention writes it.
inline std::size_t place_of(const Meaning& meaning, std::size_t k) { return meaning.scalar_first ? k : (k + 3) % 4; }

// The quaternion whose entries are from `first` on.
template <class S, std::size_t n>
Quaternion<S> quaternion_in(const Meaning& meaning, const std::array<S, n>& q, std::size_t first) {
  Quaternion<S> e;
  for (std::size_t k = 0; k < 4; ++k) e[k] = q[first + place_of(meaning, k)];
  return e;
}
template <class S, std::size_t n>
void write_quaternion(const Meaning& meaning, const Quaternion<S>& e, std::array<S, n>& q, std::size_t first) {
  for (std::size_t k = 0; k < 4; ++k) q[first + place_of(meaning, k)] = e[k];
}

template <class S>
Pose<S> pose_in(const Meaning& meaning, const State<S>& s) {
  Pose<S> q = {s.p[0], s.p[1], s.p[2]};
  for (std::size_t k = 0; k < s.q.size(); ++k) q[7 + k] = s.q[k];
  write_quaternion(meaning, s.e, q, 3);
  write_quaternion(meaning, quaternion_in({"", true, Axes::base, Axes::base, false}, s.q, kBall), q, 7 + kBall);
  return q;
}

template <class S>
Vector<S> velocity_in(const Meaning& meaning, const State<S>& s) {
  return written(meaning, s.e, part(s.v, 0), part(s.v, 3), s.v);
}

// The derivatives of the entries of velocity_in().
template <class S>
Vector<S> acceleration_in(const Meaning& meaning, const State<S>& s) {
  Three<S> linear = part(s.a, 0);
  if (meaning.linear == Axes::world) linear = sum(linear, cross(part(s.v, 3), part(s.v, 0)));
  return written(meaning, s.e, linear, part(s.a, 3), s.a);
}

template <class S>
Vector<S> force_in(const Meaning& meaning, const State<S>& s, const Vector<S>& tau) {
  return written(meaning, s.e, part(tau, 0), part(tau, 3), tau);
}

template <class S>
S dot(const Vector<S>& a, const Vector<S>& b) {
  S result = S(0.0);
  for (std::size_t k = 0; k < a.size(); ++k) result = result + a[k] * b[k];
  return result;
}

template <class S>
Vector<S> times(const Matrix<S>& matrix, const Vector<S>& x) {
  Vector<S> result;
  for (std::size_t i = 0; i < x.size(); ++i) {
    result[i] = S(0.0);
    for (std::size_t k = 0; k < x.size(); ++k) result[i] = result[i] + matrix[kSize * i + k] * x[k];
  }
  return result;
}

// Counts what holds, and says what does not.
struct Checks {
  int held = 0, failed = 0;

  void expect(bool holds, const Meaning& meaning, const char* what) {
    ++(holds ? held : failed);
    if (!holds) std::printf("%s: %s\n", meaning.name, what);
  }
};

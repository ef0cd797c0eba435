// SPDX-License-Identifier: BSD-3-Clause
// A number with its derivative along one direction: evaluated over it, the reference is differentiated by the chain
// rule.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <type_traits>

#include "flatdyn/reference/robot.hpp"

namespace flatdyn::reference {

template <class S>
struct Tangent {
  S value = S(0), slope = S(0);

  Tangent() = default;
  template <class Constant, class = std::enable_if_t<std::is_arithmetic_v<Constant>>>
  Tangent(Constant v) : value(static_cast<S>(v)) {}  // NOLINT(google-explicit-constructor): Eigen makes its own
  explicit Tangent(const S& v, const S& along = S(0)) : value(v), slope(along) {}

  Tangent& operator+=(const Tangent& b) { return *this = *this + b; }
  Tangent& operator-=(const Tangent& b) { return *this = *this - b; }
  Tangent& operator*=(const Tangent& b) { return *this = *this * b; }
  Tangent operator-() const { return Tangent(-value, -slope); }

  friend Tangent operator+(const Tangent& a, const Tangent& b) { return Tangent(a.value + b.value, a.slope + b.slope); }
  friend Tangent operator-(const Tangent& a, const Tangent& b) { return Tangent(a.value - b.value, a.slope - b.slope); }
  friend Tangent operator*(const Tangent& a, const Tangent& b) {
    return Tangent(a.value * b.value, a.slope * b.value + a.value * b.slope);
  }
  friend Tangent operator/(const Tangent& a, const Tangent& b) {
    const S quotient = a.value / b.value;
    return Tangent(quotient, (a.slope - quotient * b.slope) / b.value);
  }
  friend bool operator<(const Tangent& a, const Tangent& b) { return a.value < b.value; }
  friend bool operator>(const Tangent& a, const Tangent& b) { return a.value > b.value; }

  friend Tangent sin(const Tangent& a) {
    using std::cos;
    using std::sin;
    return Tangent(sin(a.value), cos(a.value) * a.slope);
  }
  friend Tangent cos(const Tangent& a) {
    using std::cos;
    using std::sin;
    return Tangent(cos(a.value), -sin(a.value) * a.slope);
  }
  friend Tangent tanh(const Tangent& a) {
    using std::tanh;
    const S t = tanh(a.value);
    return Tangent(t, (S(1) - t * t) * a.slope);
  }
};

// The same loop over tangents, with all of its numbers constant.
template <class S>
Loop<Tangent<S>> with_tangents(const Loop<S>& loop) {
  using T = Tangent<S>;
  Loop<T> result;
  for (std::size_t k = 0; k < 2; ++k) {
    result.links[k] = loop.links[k];
    result.points[k] = loop.points[k].template cast<T>();
    result.across[k] = loop.across[k].template cast<T>();
  }
  result.carrier = loop.carrier;
  result.axes = loop.axes.template cast<T>();
  result.axis = loop.axis.template cast<T>();
  result.rows = loop.rows;
  result.dependent = loop.dependent;
  return result;
}

// The same robot over tangents, with all of its numbers constant.
template <class S>
Robot<Tangent<S>> with_tangents(const Robot<S>& robot) {
  using T = Tangent<S>;
  const auto vector = [](const Vector3<S>& v) { return Vector3<T>(T(v[0]), T(v[1]), T(v[2])); };
  const auto matrix = [](const Matrix3<S>& m) {
    Matrix3<T> result;
    for (Eigen::Index i = 0; i < 9; ++i) result(i / 3, i % 3) = T(m(i / 3, i % 3));
    return result;
  };
  Robot<T> result;
  for (const Link<S>& link : robot.links) {
    result.links.emplace_back();
    for (const Inertial<S>& body : link.inertials) {
      result.links.back().inertials.push_back({T(body.mass), vector(body.r_C), matrix(body.inertia)});
    }
  }
  for (const Joint<S>& a : robot.joints) {
    result.joints.push_back({a.type,
                             a.parent,
                             a.child,
                             a.index,
                             matrix(a.R_0),
                             matrix(a.R_1),
                             vector(a.p_0),
                             vector(a.p_1),
                             vector(a.axis),
                             T(a.viscous),
                             T(a.coulomb),
                             T(a.armature),
                             {a.rotor.carrier, T(a.rotor.gear_ratio), T(a.rotor.inertia), vector(a.rotor.axis)},
                             T(a.stiffness),
                             T(a.spring_q_0),
                             matrix(a.orientation),
                             {T(a.dry.speed), T(a.dry.offset), T(a.dry.excess), T(a.dry.stribeck_speed),
                              T(a.dry.asymmetry), T(a.dry.load)}});
  }
  result.root = robot.root;
  result.gravity = vector(robot.gravity);
  result.tip = robot.tip;
  result.R_tip = matrix(robot.R_tip);
  result.p_tip = vector(robot.p_tip);
  result.coupling = robot.coupling.template cast<T>();
  result.independent = robot.independent;
  for (const Loop<S>& loop : robot.loops) result.loops.push_back(with_tangents(loop));
  result.floating_base = robot.floating_base;
  result.base_armature = T(robot.base_armature);
  result.base_viscous = T(robot.base_viscous);
  result.base_coulomb = T(robot.base_coulomb);
  return result;
}

}  // namespace flatdyn::reference

namespace Eigen {

template <class S>
struct NumTraits<flatdyn::reference::Tangent<S>> : GenericNumTraits<S> {
  using Real = flatdyn::reference::Tangent<S>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum { RequireInitialization = 1 };
};

}  // namespace Eigen

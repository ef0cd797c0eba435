// SPDX-License-Identifier: GPL-2.0-or-later
// The numbers, directions and poses of a robot as read, over a field. Real numbers are as written, to 100 digits; over
// a prime field, irrational ones are replaced by the rational ones of the mechanism.
#pragma once

#include "flatdyn/reference/mpfr_real.hpp"
#include "graph/arithmetic.hpp"
#include "robot/model/body_poses.hpp"
#include "robot/model/rational_rotation.hpp"

namespace flatdyn {

using reference::Digits100;

// Numbers of a robot over a prime field.
template <class Arithmetic>
class RationalNumbers {
 public:
  using F = typename Arithmetic::Scalar;

  RationalNumbers(const Robot& robot, Arithmetic& arithmetic) : map_(robot.symbols, arithmetic) {}

  F number(const Number& a) const { return map_(rationalised(a)); }
  JointPoint<F> angle(const Number& a) const {
    const PlanarRotation turn = planar_rotation(a);
    return {map_(turn.c), map_(turn.s), F(0)};
  }
  Vector3<F> unit(const Vec3& axis) const {
    const Vec3 u = flatdyn::unit(axis);
    return {map_(u[0]), map_(u[1]), map_(u[2])};
  }

 private:
  NumberMap<Arithmetic> map_;
};

// Numbers of a robot as they are, without those of rational_rotation.hpp. Free symbols have the values that the
// arithmetic gives them.
class RealNumbers {
 public:
  using F = Digits100;

  RealNumbers(const Robot& robot, RealArithmetic<F>& arithmetic) : map_(robot.symbols, arithmetic) {}

  F number(const Number& a) const {
    constexpr int kDigits = 100;
    if (has_symbols(a)) return map_(rationalised(a));
    return is_rational(a) ? map_(a) : F(to_decimal(a, kDigits));
  }
  JointPoint<F> angle(const Number& a) const {
    const F value = number(a);
    return {cos(value), sin(value), F(0)};
  }
  Vector3<F> unit(const Vec3& axis) const {
    const Vector3<F> along = {number(axis[0]), number(axis[1]), number(axis[2])};
    return scaled(F(1 / sqrt(dot(along, along))), along);
  }

 private:
  NumberMap<RealArithmetic<F>> map_;
};

template <class F>
Pose3<F> identity_pose() {
  const F zero = F(0), one = F(1);
  return {{{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}}, {zero, zero, zero}};
}

template <class A, class B>
Pose3<Product<A, B>> composed(const Pose3<A>& a, const Pose3<B>& b) {
  const Vector3<Product<A, B>> step = times(a.R, b.p);
  return {times(a.R, b.R), {a.p[0] + step[0], a.p[1] + step[1], a.p[2] + step[2]}};
}

template <class Numbers, class F = typename Numbers::F>
Vector3<F> vector_over(const Numbers& numbers, const Vec3& v) {
  return {numbers.number(v[0]), numbers.number(v[1]), numbers.number(v[2])};
}

template <class Numbers, class F = typename Numbers::F>
Matrix3<F> matrix_over(const Numbers& numbers, const Mat3& m) {
  return {vector_over(numbers, m[0]), vector_over(numbers, m[1]), vector_over(numbers, m[2])};
}

// The rotation about coordinate axis `k`.
template <class F>
Matrix3<F> rotation_about(std::size_t k, const JointPoint<F>& angle) {
  Matrix3<F> R = identity_pose<F>().R;
  const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
  R[i][i] = R[j][j] = angle.c;
  R[i][j] = -angle.s;
  R[j][i] = angle.s;
  return R;
}

// The rotation about a unit vector, by Rodrigues' formula: a aᵀ + c (1 - a aᵀ) + s S(a).
template <class F>
Matrix3<F> rotation_about(const Vector3<F>& a, const JointPoint<F>& angle) {
  Matrix3<F> R = {Vector3<F>{angle.c, -angle.s * a[2], angle.s * a[1]},
                  Vector3<F>{angle.s * a[2], angle.c, -angle.s * a[0]},
                  Vector3<F>{-angle.s * a[1], angle.s * a[0], angle.c}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) R[i][j] += a[i] * a[j] * (F(1) - angle.c);
  }
  return R;
}

template <class Numbers, class F = typename Numbers::F>
Pose3<F> pose_over(const Numbers& numbers, const Pose& written) {
  Pose3<F> pose = identity_pose<F>();
  for (const Displacement& step : written.displacements) {
    Pose3<F> moved = identity_pose<F>();
    if (step.kind == Displacement::Kind::translation) {
      moved.p = vector_over(numbers, step.translation);
    } else {
      const std::size_t axis = step.kind == Displacement::Kind::rotation_x   ? 0
                               : step.kind == Displacement::Kind::rotation_y ? 1
                                                                             : 2;
      moved.R = rotation_about(axis, numbers.angle(step.angle));
    }
    pose = composed(pose, moved);
  }
  return pose;
}

// The link that carries a joint's motor.
inline int carrier_of(const Joint& joint) { return joint.motor->carrier >= 0 ? joint.motor->carrier : joint.parent; }

}  // namespace flatdyn

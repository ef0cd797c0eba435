// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/rational_rotation.hpp"

#include <cln/cln.h>

#include "robot/model/exact_sign.hpp"

namespace flatdyn {
namespace {

cln::cl_F to_float(const Number& a) {
  constexpr std::uintptr_t kGuardDigits = 20;
  const auto format = cln::float_format(kRationalDigits + kGuardDigits);
  const long saved = GiNaC::Digits;
  GiNaC::Digits = static_cast<long>(kRationalDigits + kGuardDigits);
  const GiNaC::ex value = a.evalf();
  GiNaC::Digits = saved;
  return cln::cl_float(cln::the<cln::cl_R>(GiNaC::ex_to<GiNaC::numeric>(value).to_cl_N()), format);
}

// The simplest rational that equals `value` to kRationalDigits digits, found by continued fractions: it has half as
// many digits as a decimal would need. The numbers of long chains multiply; short ones keep exact arithmetic fast.
Number rational_near(const cln::cl_F& value) {
  if (cln::zerop(value)) return 0;
  const cln::cl_F rounded = cln::cl_float(value, cln::float_format(static_cast<std::uintptr_t>(kRationalDigits)));
  return GiNaC::numeric(cln::cl_N(cln::rationalize(rounded)));
}

bool is_numeric_expression(const Number& a) { return !has_symbols(a); }

// The rotation (1 - t^2, 2 t)/(1 + t^2): exactly on the unit circle for any rational t.
PlanarRotation from_half_tangent(const Number& t) {
  const Number norm = 1 + t * t;
  return {(1 - t * t) / norm, 2 * t / norm};
}

// The rotation by quarter · pi/2.
PlanarRotation quarter_rotation(const cln::cl_I& quarter) {
  static const PlanarRotation kTurns[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  return kTurns[cln::cl_I_to_int(cln::mod(quarter, 4))];
}

// Finds the exact root of a rational square; returns whether it is one.
bool rational_root(const Number& square, Number& root) {
  if (!is_rational(square)) return false;
  cln::cl_RA result;
  const cln::cl_RA value = cln::the<cln::cl_RA>(GiNaC::ex_to<GiNaC::numeric>(square).to_cl_N());
  if (value < 0 || !cln::sqrtp(value, &result)) return false;
  root = GiNaC::numeric(cln::cl_N(result));
  return true;
}

bool is_residue(const Number& a, const Number& whole) {
  static const Number kPart = GiNaC::pow(GiNaC::numeric(10), -kResidueDigits);
  if (!is_rational(a) || !is_rational(whole)) return false;
  return GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(a)) < GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(kPart * whole));
}

// The numeric coefficient of a term of an expanded sum.
Number coefficient_of(const Number& term) {
  if (GiNaC::is_a<GiNaC::mul>(term)) return GiNaC::ex_to<GiNaC::mul>(term).op(term.nops() - 1);
  return 1;
}

}  // namespace

Number snap_residue_to_zero(const Number& a, const Number& whole) {
  if (is_rational(a)) return is_residue(a, whole) ? Number(0) : a;
  const Number sum = a.expand();
  if (!GiNaC::is_a<GiNaC::add>(sum)) return is_residue(coefficient_of(sum), 1) ? Number(0) : a;
  Number result = 0;
  for (const Number& term : sum) {
    if (is_rational(term) ? !is_residue(term, whole) : !is_residue(coefficient_of(term), 1)) result += term;
  }
  return result;
}

Vec3 snap_residue_to_zero(const Vec3& a, const Number& whole) {
  return {snap_residue_to_zero(a[0], whole), snap_residue_to_zero(a[1], whole), snap_residue_to_zero(a[2], whole)};
}

Number rationalised(const Number& a) {
  if (is_rational(a)) return a;
  if (is_numeric_expression(a)) return rational_near(to_float(a));
  if (GiNaC::is_a<GiNaC::symbol>(a)) return a;
  struct Visit : GiNaC::map_function {
    GiNaC::ex operator()(const GiNaC::ex& e) override { return rationalised(e); }
  } visit;
  return a.map(visit).expand();
}

Vec3 rationalised(const Vec3& a) { return {rationalised(a[0]), rationalised(a[1]), rationalised(a[2])}; }

PlanarRotation planar_rotation(const Number& angle) {
  if (has_symbols(angle)) return {GiNaC::cos(angle), GiNaC::sin(angle)};
  const Number turns = (2 * angle / GiNaC::Pi).expand();
  if (turns.info(GiNaC::info_flags::integer)) {
    return quarter_rotation(cln::the<cln::cl_I>(GiNaC::ex_to<GiNaC::numeric>(turns).to_cl_N()));
  }
  // The nearest quarter turn is exact; the remaining angle is below pi/4, so its half tangent is below 1/2.
  const cln::cl_F value = to_float(angle);
  const cln::cl_F half_pi = cln::pi(value) / 2;
  const cln::cl_I quarter = cln::round1(value / half_pi);
  const cln::cl_F rest = value - half_pi * cln::cl_float(quarter, value);
  return quarter_rotation(quarter) * from_half_tangent(rational_near(cln::tan(rest / 2)));
}

PlanarRotation direction_of(const Number& x, const Number& y) {
  Number norm;
  if (rational_root((x * x + y * y).expand(), norm)) return {x / norm, y / norm};
  const cln::cl_F fx = to_float(x), fy = to_float(y);
  const cln::cl_F angle = cln::atan(fx, fy);  // CLN's order: atan(x, y) is the phase of x + iy
  const cln::cl_F half_pi = cln::pi(angle) / 2;
  const cln::cl_I quarter = cln::round1(angle / half_pi);
  const cln::cl_F rest = angle - half_pi * cln::cl_float(quarter, angle);
  return quarter_rotation(quarter) * from_half_tangent(rational_near(cln::tan(rest / 2)));
}

PlanarRotation snap_residue_to_zero(const PlanarRotation& a) {
  const auto sign = [](const Number& x) { return x.info(GiNaC::info_flags::negative) ? -1 : 1; };
  if (is_residue(a.c, a.s)) return {0, sign(a.s)};
  if (is_residue(a.s, a.c)) return {sign(a.c), 0};
  return a;
}

PlanarRotation operator*(const PlanarRotation& a, const PlanarRotation& b) {
  return {(a.c * b.c - a.s * b.s).expand(), (a.s * b.c + a.c * b.s).expand()};
}

PlanarRotation inverse(const PlanarRotation& a) { return {a.c, -a.s}; }

bool is_quarter_turn(const PlanarRotation& a) { return vanishes(a.c) || vanishes(a.s); }

Mat3 rotation_x(const PlanarRotation& a) { return {Vec3{1, 0, 0}, Vec3{0, a.c, -a.s}, Vec3{0, a.s, a.c}}; }

Mat3 rotation_y(const PlanarRotation& a) { return {Vec3{a.c, 0, a.s}, Vec3{0, 1, 0}, Vec3{-a.s, 0, a.c}}; }

Mat3 rotation_z(const PlanarRotation& a) { return {Vec3{a.c, -a.s, 0}, Vec3{a.s, a.c, 0}, Vec3{0, 0, 1}}; }

Mat3 exact_rotation(const Displacement& displacement) {
  switch (displacement.kind) {
    case Displacement::Kind::rotation_x:
      return rotation_x(planar_rotation(displacement.angle));
    case Displacement::Kind::rotation_y:
      return rotation_y(planar_rotation(displacement.angle));
    case Displacement::Kind::rotation_z:
      return rotation_z(planar_rotation(displacement.angle));
    case Displacement::Kind::translation:
      break;
  }
  return identity_matrix();
}

Mat3 exact_rotation(const Pose& pose) {
  Mat3 R = identity_matrix();
  for (const Displacement& displacement : pose.displacements) R = expanded(R * exact_rotation(displacement));
  return R;
}

namespace {

// The rotation matrix of the quaternion (w; v), which need not be normalised: rational entries, exactly orthonormal.
Mat3 from_quaternion(const Number& w, const Vec3& v) {
  const Number norm = w * w + dot(v, v);
  const Mat3 S = skew(v);
  const Mat3 S2 = S * S;
  Mat3 R = identity_matrix();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) R[i][j] += 2 * (w * S[i][j] + S2[i][j]) / norm;
  }
  return R;
}

// The rotation of z onto the axis ±x, ±y or ±z, positive if `positive`.
Mat3 signed_permutation(int axis, bool positive) {
  const PlanarRotation turn{0, positive ? 1 : -1};
  if (axis == 0) return rotation_y(turn);
  if (axis == 1) return rotation_x(inverse(turn));
  return positive ? identity_matrix() : rotation_x({-1, 0});
}

}  // namespace

Vec3 unit(const Vec3& axis) {
  const Number square = dot(axis, axis).expand();
  Number norm;
  if (rational_root(square, norm)) return rationalised(Number(1 / norm) * axis);
  const cln::cl_F length = cln::sqrt(to_float(square));
  Vec3 result;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = vanishes(axis[k]) ? Number(0) : rational_near(to_float(axis[k]) / length);
  }
  return result;
}

Mat3 rotation_onto(const Vec3& axis) {
  for (int k = 0; k < 3; ++k) {
    const auto at = [&axis, k](int offset) { return axis[static_cast<std::size_t>((k + offset) % 3)]; };
    if (vanishes(at(1)) && vanishes(at(2))) return signed_permutation(k, is_positive(at(0)));
  }
  // The quaternion half-way between z and the axis, (1 + u_z; z x u); from the opposite side if u points down.
  Vec3 u = unit(axis);
  const bool down = u[2].info(GiNaC::info_flags::negative);
  if (down) u = {u[0], -u[1], -u[2]};
  const Mat3 R = from_quaternion(1 + u[2], {-u[1], u[0], 0});
  return down ? rotation_x({-1, 0}) * R : R;
}

namespace {

// (x, y) as a rotation, if its length is 1 up to rounding residues.
PlanarRotation on_circle(const Number& x, const Number& y) {
  const PlanarRotation found = snap_residue_to_zero(PlanarRotation{x, y});
  if (has_symbols(x) || has_symbols(y) || vanishes(found.c * found.c + found.s * found.s - 1)) return found;
  return direction_of(x, y);
}

}  // namespace

ZxzAngles zxz_angles(const Mat3& R) {
  const Vec3 axis = snap_residue_to_zero(Vec3{R[0][2], R[1][2], R[2][2]}, 1);
  const Number &x = axis[0], &y = axis[1], &z = axis[2];  // Rz(beta) Rx(alpha) z = (s_b s_a, -c_b s_a, c_a)
  ZxzAngles angles;
  if (vanishes(x)) {
    // beta = 0, which also serves parallel axes.
    angles.alpha = on_circle(z, -y);
    angles.theta = on_circle(R[0][0], -R[0][1]);
    return angles;
  }
  if (vanishes(y)) {
    angles.beta = {0, 1};
    angles.alpha = on_circle(z, x);
    angles.theta = on_circle(R[1][0], -R[1][1]);
    return angles;
  }
  if (has_symbols(x) || has_symbols(y) || has_symbols(z)) {
    throw Failure(FailureKind::unsupported,
                  "a symbolic angle makes two neighbouring joint axes skew in general position",
                  "keep angles numeric, or let only one of alpha and theta be a symbol");
  }
  angles.beta = direction_of(-y, x);
  const Number sin_alpha = (angles.beta.s * x - angles.beta.c * y).expand();
  angles.alpha = snap_residue_to_zero(direction_of(z, sin_alpha));
  angles.theta = snap_residue_to_zero(direction_of(R[2][1], R[2][0]));  // s_a (s_t, c_t), s_a > 0
  return angles;
}

}  // namespace flatdyn

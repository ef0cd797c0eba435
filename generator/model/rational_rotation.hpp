// SPDX-License-Identifier: GPL-2.0-or-later
// Rotations whose entries are rational and which are exactly orthonormal (design decision 2): quarter turns as they
// are, every other angle replaced by one within kRotationTolerance whose half-angle tangent is rational.
#pragma once

#include "model/mechanism.hpp"

namespace flatdyn {

// Digits to which an irrational constant is replaced by a rational one.
inline constexpr int kRationalDigits = 44;

// The simplest rational number that agrees with `a` to kRationalDigits digits; irrational subexpressions (Pi, roots)
// are replaced in place, free symbols stay.
Number rationalised(const Number& a);
Vec3 rationalised(const Vec3& a);

// (cos, sin) of an angle: exact for quarter turns, rational for other numbers, cos(x) and sin(x) of a symbolic x.
PlanarRotation planar_rotation(const Number& angle);

// (x, y)/|(x, y)|: exact if the norm is rational. Both numeric, not both zero.
PlanarRotation direction_of(const Number& x, const Number& y);

PlanarRotation operator*(const PlanarRotation& a, const PlanarRotation& b);  // sum of the angles
PlanarRotation inverse(const PlanarRotation& a);
bool is_quarter_turn(const PlanarRotation& a);

Mat3 rotation_x(const PlanarRotation& a);
Mat3 rotation_y(const PlanarRotation& a);
Mat3 rotation_z(const PlanarRotation& a);

// A rotation that takes z to the direction of `axis` (not zero), by the shortest way. Signed permutation for an axis
// along x, y or z. A symbolic axis must be along one of them.
Mat3 rotation_onto(const Vec3& axis);

// axis / |axis|, rational.
Vec3 unit(const Vec3& axis);

// R = Rz(beta) Rx(alpha) Rz(theta). Where axes are parallel, beta = 0; signs are chosen so that as many of the three
// as possible are the identity.
struct ZxzAngles {
  PlanarRotation beta, alpha, theta;
};
ZxzAngles zxz_angles(const Mat3& R);

}  // namespace flatdyn

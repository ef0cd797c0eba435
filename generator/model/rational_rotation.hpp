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

// Numbers that cancel in the robot leave a rest where irrational ones among them have been replaced, each by another:
// of these angles 0.3 + 0.2 - 0.5 is some 1e-58. What is so much smaller than a number that it may be the rest of is
// zero.
inline constexpr int kRestDigits = 40;

// `a`, or 0 if it may be a rest of `whole`; of an expression in free symbols, terms are left out whose coefficients may
// be rests of 1.
Number snap_residue_to_zero(const Number& a, const Number& whole);
Vec3 snap_residue_to_zero(const Vec3& a, const Number& whole);

// (cos, sin) of an angle: exact for quarter turns, rational for other numbers, cos(x) and sin(x) of a symbolic x.
PlanarRotation planar_rotation(const Number& angle);

// (x, y)/|(x, y)|: exact if the norm is rational. Both numeric, not both zero.
PlanarRotation direction_of(const Number& x, const Number& y);

// The same, a quarter turn if it is one but for a rest.
PlanarRotation snap_residue_to_zero(const PlanarRotation& a);

PlanarRotation operator*(const PlanarRotation& a, const PlanarRotation& b);  // sum of the angles
PlanarRotation inverse(const PlanarRotation& a);
bool is_quarter_turn(const PlanarRotation& a);

Mat3 rotation_x(const PlanarRotation& a);
Mat3 rotation_y(const PlanarRotation& a);
Mat3 rotation_z(const PlanarRotation& a);

// Of a displacement, the identity for a translation; of a pose, without what it translates.
Mat3 exact_rotation(const Displacement& displacement);
Mat3 exact_rotation(const Pose& pose);

// A rotation that takes z to the direction of `axis` (not zero), by the shortest way. Signed permutation for an axis
// along x, y or z. A symbolic axis must be along one of them.
Mat3 rotation_onto(const Vec3& axis);

// axis / |axis|, rational.
Vec3 unit(const Vec3& axis);

// R = Rz(beta) Rx(alpha) Rz(theta). Where axes are parallel, beta = 0; signs are chosen so that as many of the three
// as possible are the identity. Rests of 0 and 1 in R are these, so that axes are parallel or at right angles if the
// robot's are.
struct ZxzAngles {
  PlanarRotation beta, alpha, theta;
};
ZxzAngles zxz_angles(const Mat3& R);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Rotations with rational entries that are exactly orthonormal (design decision 2): quarter turns are kept, and every
// other angle is replaced by one within kRotationTolerance whose half-angle tangent is rational.
#pragma once

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The number of digits to which a rational constant agrees with the irrational one that it replaces.
inline constexpr int kRationalDigits = 44;

// The simplest rational number that agrees with `a` to kRationalDigits digits; irrational subexpressions (Pi, roots)
// are replaced in place, free symbols stay.
Number rationalised(const Number& a);
Vec3 rationalised(const Vec3& a);

// Numbers that cancel in the robot leave a residue where irrational ones among them have been replaced one by one: 0.3
// + 0.2 - 0.5 of such angles is about 1e-58. A number this many digits smaller than the one that it may be a residue of
// is zero.
inline constexpr int kResidueDigits = 40;

// `a`, or 0 if it may be a residue of `whole`. In an expression in free symbols, terms are left out whose coefficients
// may be residues of 1.
Number snap_residue_to_zero(const Number& a, const Number& whole);
Vec3 snap_residue_to_zero(const Vec3& a, const Number& whole);

// (cos, sin) of an angle: exact for quarter turns, rational for other numbers, cos(x) and sin(x) for a symbolic x.
PlanarRotation planar_rotation(const Number& angle);

// (x, y)/|(x, y)|: exact if the norm is rational. Both must be numeric and not both zero.
PlanarRotation direction_of(const Number& x, const Number& y);

// The rotation `a`, or the quarter turn that it equals up to a residue.
PlanarRotation snap_residue_to_zero(const PlanarRotation& a);

PlanarRotation operator*(const PlanarRotation& a, const PlanarRotation& b);  // the sum of the angles
PlanarRotation inverse(const PlanarRotation& a);
bool is_quarter_turn(const PlanarRotation& a);

Mat3 rotation_x(const PlanarRotation& a);
Mat3 rotation_y(const PlanarRotation& a);
Mat3 rotation_z(const PlanarRotation& a);

// The exact rotation of a displacement, which is the identity for a translation; the rotation of a pose, without its
// translations.
Mat3 exact_rotation(const Displacement& displacement);
Mat3 exact_rotation(const Pose& pose);

// The rotation by the smallest angle that takes z to the direction of `axis` (not zero); a signed permutation for an
// axis along x, y or z. A symbolic axis must be along one of them.
Mat3 rotation_onto(const Vec3& axis);

// The unit vector axis / |axis|, rational.
Vec3 unit(const Vec3& axis);

// R = Rz(beta) Rx(alpha) Rz(theta). For parallel axes beta = 0; signs are chosen so that as many of the three as
// possible are the identity. Entries of R that are 0 or 1 up to a residue count as 0 or 1, so that axes are parallel or
// perpendicular if the robot's are.
struct ZxzAngles {
  PlanarRotation beta, alpha, theta;
};
// The angles of a rotation matrix. Throws Failure(unsupported) if a symbolic angle makes two joint axes skew in general
// position.
ZxzAngles zxz_angles(const Mat3& R);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Rates and accelerations of the tip's Euler angles, from its angular velocity: φ̇ = T(φ)^-1 ω, (3.64).
//
// The columns of T are the axes that the angles turn about: z, then the line of nodes, then the axis a that the last
// angle does not change, which is a column of R: its third for ZYZ, its first for roll, pitch and yaw. So with a = (u,
// v, w) and s² = u² + v², T = [z, (-v, u, 0) / s, a] follows from R, and the angles need not be computed.
#pragma once

#include "derivation/dynamics/derivation_context.hpp"
#include "graph/task.hpp"

namespace flatdyn {

class EulerRates {
 public:
  // Throws Failure(unsupported) if s is zero at every position.
  EulerRates(DerivationContext& context, Orientation orientation);

  // s, with rounding errors in the last place of 1: the angles are singular where it is zero.
  const Number& divisor() const { return s_; }

  // (φ̇, θ̇, ψ̇) for an angular velocity in base axes.
  Vec3 of(const Vec3& omega) const;

  // (φ̈, θ̈, ψ̈) = T^-1 (α - Ṫ T^-1 ω), for an angular velocity and acceleration in base axes.
  Vec3 changes(const Vec3& omega, const Vec3& alpha) const;

 private:
  Derivation& derivation_;
  Number w_, s_, s2_;
  Number along_x_, along_y_;    // u / s², v / s²
  Number across_x_, across_y_;  // u / s, v / s
};

// The meaning of the angles in words, and the condition under which they have rates: "phi", "theta", "psi" and "ZYZ" or
// "roll, pitch and yaw".
std::string describe_angles(Orientation orientation);

// Throws Failure(unsupported): the tip has no position with rates of these angles.
[[noreturn]] void fail_without_angles(Orientation orientation);

}  // namespace flatdyn

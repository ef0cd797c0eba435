// SPDX-License-Identifier: GPL-2.0-or-later
// The dynamics of a robot some of whose links touch something that does not move: B a + n = τ + Jᵀ f with J a + J̇ v =
// 0, where J is the Jacobian of all contacts and f their forces on the robot. With B = Lᵀ D L and Y = L^-T Jᵀ, the
// matrix that is inverted is M = J B^-1 Jᵀ = Yᵀ D^-1 Y, plus λ² 1 if the scene says a damping λ.
#pragma once

#include <string>
#include <vector>

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

// Choices in which contacts are points of links in metres, whose axes are those that the functions about them compute.
Choices at_the_contacts(Choices choices, const Mechanism& mechanism);

// The position of each contact from the base frame's origin, base axes, m.
std::vector<Vec3> contact_positions(DerivationContext& context);

// The Jacobian of all contacts by the entries of q̇: velocities, and rotations of surfaces, in base axes.
Rows contact_jacobian(DerivationContext& context);

// J̇ q̇ of the same rows.
std::vector<Number> contact_drift(DerivationContext& context);

// The rows of the contacts in words: "left_foot (x, y, z), right_foot (x, y, z, rx, ry, rz)".
std::string contact_text(const std::vector<Contact>& contacts);

// How many times as large, relative to its scale, a pivot of M has to be as one of B. A pivot that just passes is right
// to some hundredths, and so are forces and accelerations (docs/contacts.md): a tenth, as of B, would be too little
// where a robot is meant to stand.
inline constexpr int kContactMargin = 32;

class ContactSpace {
 public:
  // The contacts must be independent of each other (contact_rank.hpp), or damped.
  explicit ContactSpace(DerivationContext& context);

  // The forces f = -M^-1 (J B^-1 b + drift), by row: what the contacts exert so that their acceleration B^-1 (b + Jᵀ f)
  // is -drift. Also of impulses, with b = B v and without drift.
  struct Solution {
    std::vector<Number> forces, motion;  // motion = B^-1 (b + Jᵀ f)
  };
  Solution accelerations(std::vector<Number> b, const std::vector<Number>& drift) const;

  // The derivatives of these: of the motion P by b and -Q by the drift, of the forces -Qᵀ and -Λ. P and Λ = M^-1 are
  // symmetric.
  struct Sensitivities {
    Rows P, Q, Lambda;
  };
  Sensitivities sensitivities() const;

  // The velocity after an impact, from that before it, and the impulses that stop the contacts.
  Solution after_impact(const std::vector<Number>& velocity) const;

  // The number m / Σ_k M_kk / d_k of M = Lᵀ D L, which is 1 if no row depends on another, and 0 if one follows from
  // others.
  Number condition() const;

  // The pivots of M and of B.
  Conditions conditions() const;

 private:
  std::size_t size() const { return J_.size(); }
  std::vector<Number> named(std::vector<Number> values, const std::string& name) const;
  Rows solved_transposed_rows() const;
  Rows divided_by_pivots() const;
  Rows mobility() const;
  std::vector<Number> sizes() const;
  std::vector<Number> with_forces(std::vector<Number> y, const std::vector<Number>& forces) const;

  DerivationContext& context_;
  Factorisation B_;
  Rows J_, Y_, Z_, mobility_;
  Factorisation factors_;
};

}  // namespace flatdyn

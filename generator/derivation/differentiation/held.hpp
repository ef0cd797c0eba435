// SPDX-License-Identifier: GPL-2.0-or-later
// Derivatives of the accelerations a and forces f of a robot whose contacts hold (derivation/dynamics/contacts.hpp),
//   B a + n = τ + Jᵀ f,   J a + b = 0 (or -λ² f, with a damping λ),
// from those of inverse dynamics and of the contacts at the solution: along each direction of an argument,
//   ∂a = P r - Q s,   ∂f = -Qᵀ r - Λ s,   r = ∂τ - ∂(B a + n) + ∂(Jᵀ) f,   s = ∂J a + ∂b.
#pragma once

#include "derivation/differentiation/derivative_outputs.hpp"

namespace flatdyn {

struct HeldMotion {
  const Function& solution;  // outputs a, f, P, Q, Λ (derive_held_motion_and_sensitivities)
  const Function& torques;   // the derivatives of inverse dynamics by q and by velocities
  const Function& contacts;  // outputs J and b, in this order
  const Tangents& tangents;  // of the arguments of the solution
};

// The derivatives of a, then of f, as nodes of the function, which is over the graph of the solution. The robot has no
// free symbols, and its floating base, if it has one, neither armature nor viscous friction: gravity and the base's
// velocity then act as an acceleration of the base, which has no part in f beyond gravity's.
struct HeldDerivatives {
  Function function;
  JacobianColumns columns;
};
HeldDerivatives held_derivatives(const Mechanism& mechanism, const HeldMotion& held);

}  // namespace flatdyn

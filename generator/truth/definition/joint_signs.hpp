// SPDX-License-Identifier: GPL-2.0-or-later
// The signs of the rates of all bodies' joints, for coordinates that an Arithmetic draws. A Graph takes sgn(2 q̇) for
// sgn(q̇), so the signs are evaluated from a Graph of the derived rates. That these rates are right is checked
// elsewhere, by the proofs of B, C and viscous friction.
#pragma once

#include <utility>
#include <vector>

#include "derivation/dynamics/derivation_context.hpp"
#include "robot/model/joint_points.hpp"

namespace flatdyn {

// By body: the sign of its joint's rate, from the inputs of this kind.
template <class Arithmetic, class F = typename Arithmetic::Scalar>
std::vector<F> joint_signs(const Mechanism& mechanism, Arithmetic& arithmetic, InputKind kind) {
  Derivation derivation(DerivationContext::parameters(mechanism));
  std::vector<NodeId> signs;
  for (const Number& rate : joint_motion(mechanism, derivation, kind)) {
    signs.push_back(derivation.node(derivation.sign(rate, "sgn")));
  }
  return values_of(std::move(derivation.graph()), signs, arithmetic);
}

}  // namespace flatdyn

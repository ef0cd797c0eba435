// SPDX-License-Identifier: GPL-2.0-or-later
// The signs of the rates of all bodies' joints, for coordinates that an Arithmetic draws. A Graph takes sgn(2 q̇) for
// sgn(q̇), so the signs are evaluated from a Graph of the derived rates. That these rates are right is checked
// elsewhere, by the proofs of B, C and viscous friction. Where friction is smooth, they are tanh((rate + φ)/v_0).
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
  std::vector<NodeId> nodes;
  for (const Number& rate : joint_motion(mechanism, derivation, kind)) {
    const bool is_smooth = mechanism.bodies[nodes.size()].dry.is_smooth();
    nodes.push_back(derivation.node(is_smooth ? rate : derivation.sign(rate, "sgn")));
  }
  std::vector<F> values = values_of(std::move(derivation.graph()), nodes, arithmetic);
  const NumberMap<Arithmetic> number(mechanism.symbols, arithmetic);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const DryFriction& dry = mechanism.bodies[k].dry;
    if (dry.is_smooth()) values[k] = tanh_in(arithmetic, (values[k] + number(dry.offset)) / number(dry.speed));
  }
  return values;
}

}  // namespace flatdyn

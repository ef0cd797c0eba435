// SPDX-License-Identifier: GPL-2.0-or-later
// The signs of the rates of all bodies' joints, for coordinates as an Arithmetic draws them. sgn(2 q̇) is sgn(q̇) to a
// Graph, so they are taken from one: that of the rates as they are derived. That these are the rates is seen elsewhere,
// in all that is proven of B, C and viscous friction.
#pragma once

#include <utility>
#include <vector>

#include "model/joint_points.hpp"
#include "symbolic/dynamics/workbench.hpp"

namespace flatdyn {

template <class Arithmetic, class F = typename Arithmetic::Scalar>
std::vector<F> joint_signs(const Mechanism& mechanism, Arithmetic& arithmetic, InputKind kind) {
  Derivation derivation(Workbench::parameters(mechanism));
  std::vector<NodeId> signs;
  for (const Number& rate : joint_motion(mechanism, derivation, kind)) {
    signs.push_back(derivation.node(derivation.sign(rate, "sgn")));
  }
  return values_of(std::move(derivation.graph()), signs, arithmetic);
}

}  // namespace flatdyn

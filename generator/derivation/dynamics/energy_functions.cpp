// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/energy_functions.hpp"

#include "derivation/dynamics/energy.hpp"

namespace flatdyn {

Function derive_kinetic_energy(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    const NodeId T = context.node(kinetic_energy(context.frames));
    return finished(context, {scalar_output("T", T, "kinetic energy, J")});
  });
}

Function derive_potential_energy(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    const NodeId U = context.node(potential_energy(context.frames));
    const std::string zero = context.mechanism.has_springs() ? "; for masses zero" : "; zero";
    const std::string above = context.mechanism.floating_base ? "; the base's own place p adds -m g_0^T p to it" : "";
    return finished(context,
                    {scalar_output("U", U, "potential energy, J" + zero + " at the base frame's origin" + above)});
  });
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/dynamics/energy_functions.hpp"

#include "symbolic/dynamics/energy.hpp"

namespace flatdyn {

Function derive_kinetic_energy(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](Workbench& bench) {
    const NodeId T = bench.node(kinetic_energy(bench.frames));
    return finished(bench, {scalar_output("T", T, "kinetic energy, J")});
  });
}

Function derive_potential_energy(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](Workbench& bench) {
    const NodeId U = bench.node(potential_energy(bench.frames));
    return finished(bench, {scalar_output("U", U, "potential energy, J; zero at the base frame's origin")});
  });
}

}  // namespace flatdyn

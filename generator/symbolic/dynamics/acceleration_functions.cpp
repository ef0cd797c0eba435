// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/dynamics/acceleration_functions.hpp"

#include "symbolic/dynamics/accelerations.hpp"
#include "symbolic/dynamics/articulated.hpp"
#include "symbolic/dynamics/composite.hpp"
#include "symbolic/dynamics/composite_bias.hpp"

namespace flatdyn {

namespace {

Function finished_accelerations(Workbench& bench, const std::vector<Number>& qdd, Conditions conditions) {
  const std::vector<NodeId> entries = bench.nodes(qdd);
  return finished(bench, {vector_output("qdd", entries, "joint accelerations, rad/s^2 (m/s^2 for prismatic joints)")},
                  std::move(conditions));
}

}  // namespace

Function derive_forward_dynamics(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](Workbench& bench) {
    const Factorisation B(bench.frames, bench.inertia());
    return finished_accelerations(bench, accelerations(bench, B), conditions_of(bench, B));
  });
}

// Forward dynamics without the diagonal entries b_kk, beside which a pivot could be seen to be lost.
std::optional<Function> derive_forward_dynamics_by_articulated_bodies(const Mechanism& mechanism,
                                                                      const Choices& choices) {
  if (!has_articulated_form(mechanism) || choices.guards_pivots) return std::nullopt;
  return derived(mechanism, choices, [](Workbench& bench) {
    const Motion motion{bench.joint_motion(InputKind::qd), bench.joint_drift(), bench.mechanism.gravity, true};
    const std::vector<Number> tau = bench.all(InputKind::tau);
    const ArticulatedSolution solution = articulated_accelerations(bench.frames, motion, tau);
    return finished_accelerations(bench, solution.qdd, {bench.nodes(solution.pivots), {}});
  });
}

// The bias is computed from the composite bodies that B is made from.
std::optional<Function> derive_forward_dynamics_by_composite_bodies(const Mechanism& mechanism,
                                                                    const Choices& choices) {
  if (mechanism.has_prismatic_joint() || mechanism.has_loops()) return std::nullopt;
  return derived(mechanism, choices, [](Workbench& bench) {
    const Factorisation B(bench.frames, bench.inertia());
    const Motion motion{bench.joint_motion(InputKind::qd), bench.joint_drift(), bench.mechanism.gravity, true};
    const std::vector<Number> bias =
        bench.at_coordinates(composite_bias_torques(bench.frames, motion, composites(bench.frames)));
    return finished_accelerations(bench, accelerations(bench, B, bias), conditions_of(bench, B));
  });
}

}  // namespace flatdyn

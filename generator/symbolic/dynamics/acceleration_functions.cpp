// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/dynamics/acceleration_functions.hpp"

#include "symbolic/dynamics/accelerations.hpp"
#include "symbolic/dynamics/articulated.hpp"
#include "symbolic/dynamics/composite.hpp"
#include "symbolic/dynamics/composite_bias.hpp"

namespace flatdyn {

namespace {

Function finished_accelerations(DerivationContext& context, const std::vector<Number>& qdd, Conditions conditions) {
  const std::vector<NodeId> entries = context.nodes(qdd);
  return finished(context, {vector_output("qdd", entries, "joint accelerations, rad/s^2 (m/s^2 for prismatic joints)")},
                  std::move(conditions));
}

}  // namespace

Function derive_forward_dynamics(const Mechanism& mechanism, const Choices& choices) {
  return derived(mechanism, choices, [](DerivationContext& context) {
    const Factorisation B(context.frames, context.inertia());
    return finished_accelerations(context, accelerations(context, B), conditions_of(context, B));
  });
}

// Forward dynamics without the diagonal entries b_kk, beside which a pivot could be seen to be lost.
std::optional<Function> derive_forward_dynamics_by_articulated_bodies(const Mechanism& mechanism,
                                                                      const Choices& choices) {
  if (!has_articulated_form(mechanism) || choices.guard.compares) return std::nullopt;
  return derived(mechanism, choices, [](DerivationContext& context) {
    const Motion motion{context.joint_motion(InputKind::qd), context.joint_drift(), context.gravity(), true};
    const std::vector<Number> tau = context.all(InputKind::tau);
    const ArticulatedSolution solution = articulated_accelerations(context.frames, motion, tau);
    return finished_accelerations(context, solution.qdd, conditions_of(context, solution.pivots));
  });
}

// The bias is computed from the composite bodies that B is made from.
std::optional<Function> derive_forward_dynamics_by_composite_bodies(const Mechanism& mechanism,
                                                                    const Choices& choices) {
  if (mechanism.has_prismatic_joint() || mechanism.has_loops()) return std::nullopt;
  return derived(mechanism, choices, [](DerivationContext& context) {
    const Factorisation B(context.frames, context.inertia());
    const Motion motion{context.joint_motion(InputKind::qd), context.joint_drift(), context.gravity(), true};
    const std::vector<Number> bias =
        context.at_coordinates(composite_bias_torques(context.frames, motion, composites(context.frames)));
    return finished_accelerations(context, accelerations(context, B, bias), conditions_of(context, B));
  });
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/loop_functions.hpp"

#include <algorithm>
#include <utility>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/loop_closure.hpp"

namespace flatdyn {
namespace {

ClosedLoops loops_of(DerivationContext& context) {
  if (context.mechanism.has_loops()) return {context.mechanism, context.derivation};
  throw Failure(FailureKind::unsupported, "the robot has no loops that have to be closed",
                "its joints are independent, or follow others linearly: q is all that there is to know");
}

// G times the independent joints' entries, for every entry of q: G q̇_a are the rates, G q̈_a the accelerations without
// drift.
std::vector<Number> along(const Rows& G, DerivationContext& context, InputKind kind) {
  const std::vector<Number> all = context.all(kind);
  const std::vector<Number> independent(all.begin() + context.mechanism.base_bodies(), all.end());
  std::vector<Number> result;
  for (const std::vector<Number>& row : G) result.push_back(sum_of(row, independent));
  return result;
}

}  // namespace

Function derive_loop_closure(const Mechanism& mechanism) {
  DerivationContext context(mechanism);
  const std::vector<NodeId> phi = context.nodes(loops_of(context).closure());
  return finished(context,
                  {vector_output("phi", phi,
                                 aligns_axes(context.mechanism)
                                     ? "loop by loop: m between points that meet, cosines where axes do; 0 if closed"
                                     : "loop by loop, m: what lies between the points that meet; 0 if closed")});
}

Function derive_loop_jacobian(const Mechanism& mechanism) {
  DerivationContext context(mechanism);
  const Rows J = loops_of(context).jacobian();
  return finished(context, {matrix_output("phi_q", static_cast<int>(J.size()), context.mechanism.position_count(),
                                          context.nodes(J), "row i, column k: of phi[i] by q[k]")});
}

Function derive_loop_step(const Mechanism& mechanism) {
  DerivationContext context(mechanism);
  const std::vector<NodeId> step = context.nodes(loops_of(context).step());
  return finished(
      context, {vector_output("dq", step, "to be added to q, again and again; 0 for independent joints, which stay")});
}

Function derive_loop_motion(const Mechanism& mechanism) {
  DerivationContext context(mechanism);
  const Rows G = loops_of(context).motion();
  const std::vector<Number> rates = along(G, context, InputKind::qd),
                            drift = loops_of(context).drift(context.joint_motion(InputKind::qd),
                                                            context.joint_motion(InputKind::qd), "drift");
  std::vector<Number> accelerations = along(G, context, InputKind::qdd);
  for (std::size_t k = 0; k < accelerations.size(); ++k) accelerations[k] += drift[k];
  return finished(context, {vector_output("rates", context.nodes(rates), "dq/dt of every entry of q"),
                            vector_output("accelerations", context.nodes(accelerations), "its derivative")});
}

LoopRates derive_loop_rates(const Mechanism& mechanism, const Choices& choices) {
  const Mechanism described = chosen(mechanism, choices);
  DerivationContext context(described, axes_of(choices));
  LoopRates rates;
  rates.G = context.nodes(loops_of(context).motion());
  rates.conditions = loops_of(context).conditions();
  rates.graph = std::move(context.derivation.graph());
  return rates;
}

void require_loop(Function& function, NodeId value, NodeId scale) {
  const auto of_loops = function.validity_conditions.end() - function.loop_conditions;
  if (std::find(of_loops, function.validity_conditions.end(), value) != function.validity_conditions.end()) return;
  Conditions conditions{std::move(function.validity_conditions), std::move(function.pivot_scales)};
  conditions.append({{value}, {scale}});
  function.validity_conditions = std::move(conditions.validity_conditions);
  function.pivot_scales = std::move(conditions.pivot_scales);
  ++function.loop_conditions;
}

}  // namespace flatdyn

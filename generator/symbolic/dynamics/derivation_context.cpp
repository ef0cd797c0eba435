// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/dynamics/derivation_context.hpp"

#include <utility>

#include "symbolic/loops/loops.hpp"

namespace flatdyn {

std::vector<GiNaC::symbol> DerivationContext::parameters(const Mechanism& mechanism) {
  std::vector<GiNaC::symbol> result;
  for (const FreeSymbol& symbol : mechanism.symbols) result.push_back(symbol.symbol);
  return result;
}

std::vector<NodeId> DerivationContext::nodes(const std::vector<Number>& values) {
  std::vector<NodeId> result;
  for (const Number& value : values) result.push_back(node(value));
  return result;
}

std::vector<NodeId> DerivationContext::nodes(const Rows& rows) {
  std::vector<NodeId> result;
  for (const std::vector<Number>& row : rows) {
    for (const Number& value : row) result.push_back(node(value));
  }
  return result;
}

Output vector_output(const std::string& name, std::vector<NodeId> entries, const std::string& meaning) {
  const int rows = static_cast<int>(entries.size());
  return {name, Layout::vector, rows, 1, std::move(entries), meaning};
}

Output torque_output(const std::string& name, std::vector<NodeId> entries) {
  return vector_output(name, std::move(entries), "joint torques, N m (forces, N, for prismatic joints)");
}

Output matrix_output(const std::string& name, int rows, int cols, std::vector<NodeId> entries,
                     const std::string& meaning) {
  return {name, Layout::matrix, rows, cols, std::move(entries), meaning};
}

Output scalar_output(const std::string& name, NodeId entry, const std::string& meaning) {
  return {name, Layout::scalar, 1, 1, {entry}, meaning};
}

namespace {

// The conditions of the loops that the outputs depend on: their entries contain the reciprocals of these loops'
// determinants.
std::vector<NodeId> loop_conditions(const Mechanism& mechanism, Derivation& derivation,
                                    const std::vector<Output>& outputs) {
  std::vector<NodeId> entries, result;
  for (const Output& output : outputs) entries.insert(entries.end(), output.entries.begin(), output.entries.end());
  const auto conditions = ClosedLoops(mechanism, derivation).conditions();
  const std::vector<bool> used = reachable_from(derivation.graph(), entries);
  for (const ClosedLoops::Condition& condition : conditions) {
    if (used[static_cast<std::size_t>(condition.reciprocal)]) result.push_back(condition.validity_conditions);
  }
  return result;
}

}  // namespace

void Conditions::append(const Conditions& more) {
  validity_conditions.insert(validity_conditions.end(), more.validity_conditions.begin(),
                             more.validity_conditions.end());
  pivot_scales.insert(pivot_scales.end(), more.pivot_scales.begin(), more.pivot_scales.end());
}

Conditions conditions_of(DerivationContext& context, const Factorisation& B) {
  Conditions conditions{context.nodes(B.pivots()), {}};
  if (context.guards_pivots) conditions.pivot_scales = context.nodes(B.pivot_scales());
  return conditions;
}

Function finished(const Mechanism& mechanism, Derivation& derivation, std::vector<Output> outputs,
                  Conditions conditions) {
  Function function;
  if (mechanism.has_loops()) {
    const std::vector<NodeId> loops = loop_conditions(mechanism, derivation, outputs);
    function.loop_conditions = static_cast<int>(loops.size());
    conditions.validity_conditions.insert(conditions.validity_conditions.end(), loops.begin(), loops.end());
  }
  function.graph = std::move(derivation.graph());
  function.outputs = std::move(outputs);
  function.validity_conditions = std::move(conditions.validity_conditions);
  function.pivot_scales = std::move(conditions.pivot_scales);
  return function;
}

Function derived(const Mechanism& mechanism, const Choices& choices,
                 const std::function<Function(DerivationContext&)>& derive) {
  const Mechanism described = chosen(mechanism, choices);
  DerivationContext context(described, axes_of(choices));
  context.guards_pivots = choices.guards_pivots;
  return derive(context);
}

Choices at_the_tip(Choices choices, const LinkFrame& tip) {
  if (tip.body >= 0) choices.joints[static_cast<std::size_t>(tip.body)].axes = Axes::turning;
  choices.length_unit = 1;
  return choices;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/dynamics/derivation_context.hpp"

#include <fmt/format.h>

#include <utility>

#include "derivation/loops/loops.hpp"
#include "robot/model/rounded_up.hpp"

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
Conditions loop_conditions(const Mechanism& mechanism, Derivation& derivation, const std::vector<Output>& outputs) {
  Conditions result;
  std::vector<NodeId> entries;
  for (const Output& output : outputs) entries.insert(entries.end(), output.entries.begin(), output.entries.end());
  const auto conditions = ClosedLoops(mechanism, derivation).conditions();
  const std::vector<bool> used = reachable_from(derivation.graph(), entries);
  for (const ClosedLoops::Condition& condition : conditions) {
    if (used[static_cast<std::size_t>(condition.reciprocal)]) result.append({{condition.value}, {condition.scale}});
  }
  return result;
}

Number rounded_number(double bound) {
  constexpr int kDigits = 2;
  return exact_decimal(fmt::format("{}", rounded_up(bound, kDigits)));
}

// The size of b_kk's terms: its bound, plus b_kk if b_kk may exceed it; b_kk alone if it is a number or has no bound.
Number size_of(const std::vector<DiagonalBound>& bounds, std::size_t k, const Number& diagonal) {
  if (is_rational(diagonal) || bounds.empty() || !(bounds[k].largest > 0)) return diagonal;
  const Number largest = rounded_number(bounds[k].largest);
  return bounds[k].holds_everywhere ? largest : diagonal + largest;
}

// By entry of q̇, the sizes of the terms whose sums are on the diagonal of B.
std::vector<Number> sizes_of_diagonal(DerivationContext& context, const std::vector<Number>& diagonal) {
  const std::vector<DiagonalBound>& bounds = context.guard.diagonals;
  std::vector<Number> sizes = diagonal;
  if (!context.mechanism.has_loops()) {
    for (std::size_t k = 0; k < sizes.size(); ++k) sizes[k] = size_of(bounds, k, diagonal[k]);
    return sizes;
  }
  if (bounds.empty()) return sizes;
  const auto base = static_cast<std::size_t>(context.mechanism.base_bodies());
  for (std::size_t k = 0; k < base; ++k) sizes[k] = size_of(bounds, k, diagonal[k]);
  std::vector<Number> of_tree;
  for (std::size_t k = base; k < bounds.size(); ++k) {
    of_tree.push_back(bounds[k].largest > 0 ? rounded_number(bounds[k].largest) : 0);
  }
  const auto of_loops = ClosedLoops(context.mechanism, context.derivation).sizes_of_inertia(of_tree);
  for (std::size_t a = 0; a < of_loops.size(); ++a) sizes[base + a] += of_loops[a];
  return sizes;
}

}  // namespace

void Conditions::append(const Conditions& more) {
  for (std::size_t k = pivot_scales.size(); !more.pivot_scales.empty() && k < validity_conditions.size(); ++k) {
    pivot_scales.push_back(validity_conditions[k]);
  }
  validity_conditions.insert(validity_conditions.end(), more.validity_conditions.begin(),
                             more.validity_conditions.end());
  pivot_scales.insert(pivot_scales.end(), more.pivot_scales.begin(), more.pivot_scales.end());
}

Conditions conditions_of(DerivationContext& context, const std::vector<Number>& pivots) {
  const Number largest = exact_decimal(kLargestPivot);
  Conditions conditions{context.nodes(pivots), {}};
  for (std::size_t k = 0; k < pivots.size(); ++k) {
    if (is_bounded(context.derivation.graph(), conditions.validity_conditions[k])) continue;
    conditions.validity_conditions.push_back(context.node(largest - pivots[k]));
  }
  return conditions;
}

Conditions conditions_of(DerivationContext& context, const Factorisation& B) {
  if (!context.guard.compares) return conditions_of(context, B.pivots());
  const std::vector<Number> sizes = sizes_of_diagonal(context, B.diagonal());
  return {context.nodes(B.pivots()), context.nodes(B.pivot_scales(sizes))};
}

Conditions conditions_of_base(DerivationContext& context, const Factorisation& inertia,
                              const std::vector<Number>& diagonal, std::size_t first) {
  if (!context.guard.compares) return conditions_of(context, inertia.pivots());
  std::vector<Number> sizes;
  for (std::size_t k = 0; k < diagonal.size(); ++k) {
    sizes.push_back(size_of(context.guard.diagonals, first + k, diagonal[k]));
  }
  return {context.nodes(inertia.pivots()), context.nodes(inertia.pivot_scales(sizes))};
}

Function finished(const Mechanism& mechanism, Derivation& derivation, std::vector<Output> outputs,
                  Conditions conditions) {
  Function function;
  if (mechanism.has_loops()) {
    const Conditions loops = loop_conditions(mechanism, derivation, outputs);
    function.loop_conditions = static_cast<int>(loops.validity_conditions.size());
    conditions.append(loops);
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
  context.guard = choices.guard;
  return derive(context);
}

Choices at_the_tip(Choices choices, const LinkFrame& tip) {
  if (tip.body >= 0) choices.joints[static_cast<std::size_t>(tip.body)].axes = Axes::turning;
  choices.length_unit = 1;
  return choices;
}

}  // namespace flatdyn

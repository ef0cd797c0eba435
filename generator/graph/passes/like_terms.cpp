// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/like_terms.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "graph/passes/draft.hpp"
#include "graph/passes/share_products.hpp"

namespace flatdyn {
namespace {

int sum_cost(const std::vector<Term>& terms, const Rational& constant) {
  int total = static_cast<int>(terms.size()) + (constant.is_zero() ? 0 : 1) - 1;
  for (const Term& term : terms) total += term.coefficient.is_unit() ? 0 : 1;
  return std::max(total, 0);
}

// The cost of the sum `cross` with its term k, which is the sum `dot`, expanded.
int merged_cost(const Node& cross, std::size_t k, const Node& dot) {
  const Rational& factor = cross.terms[k].coefficient;
  int total = -1;
  const auto add = [&total](bool is_sign) { total += is_sign ? 1 : 2; };
  auto inner = dot.terms.begin();
  const auto add_before = [&](NodeId node) {
    for (; inner != dot.terms.end() && inner->node < node; ++inner) {
      add(factor.has_reciprocal_size_of(inner->coefficient));
    }
  };
  for (std::size_t j = 0; j < cross.terms.size(); ++j) {
    const Term& term = cross.terms[j];
    if (j == k) continue;
    add_before(term.node);
    if (inner == dot.terms.end() || inner->node != term.node) {
      add(term.coefficient.is_unit());
    } else if (const Rational both = term.coefficient + factor * inner++->coefficient; !both.is_zero()) {
      add(both.is_unit());
    }
  }
  add_before(std::numeric_limits<NodeId>::max());
  const bool has_constant = dot.value.is_zero() ? !cross.value.is_zero() : cross.value != -(factor * dot.value);
  return std::max(total + (has_constant ? 1 : 0), 0);
}

// The sum `cross` with its term k, which is the sum `dot`, expanded.
Node merged(const Node& cross, std::size_t k, const Node& dot) {
  Node result = cross;
  const Rational factor = cross.terms[k].coefficient;
  result.terms.erase(result.terms.begin() + static_cast<std::ptrdiff_t>(k));
  result.value += factor * dot.value;
  for (const Term& term : dot.terms) {
    const auto place = std::lower_bound(result.terms.begin(), result.terms.end(), term.node,
                                        [](const Term& a, NodeId node) { return a.node < node; });
    if (place == result.terms.end() || place->node != term.node) {
      result.terms.insert(place, {factor * term.coefficient, term.node});
    } else if ((place->coefficient += factor * term.coefficient).is_zero()) {
      result.terms.erase(place);
    }
  }
  return result;
}

// Merges operands of the node where that pays. Operands have been processed already, as ids are a topological order.
void merge_operands(Draft& draft, NodeId id, std::vector<int>& uses, Merging merging) {
  for (std::size_t k = 0; k < draft.at(id).terms.size();) {
    const NodeId operand = draft.at(id).terms[k].node;
    const Node& dot = draft.at(operand);
    if (dot.op != Op::sum) {
      ++k;
      continue;
    }
    const Node& cross = draft.at(id);
    const bool only_use = uses[static_cast<std::size_t>(operand)] == 1;
    const int before = sum_cost(cross.terms, cross.value) + (only_use ? sum_cost(dot.terms, dot.value) : 0);
    const int after = merged_cost(cross, k, dot);
    const bool may_be_equal = only_use || merging == Merging::where_it_costs_nothing;
    if (may_be_equal ? after > before : after >= before) {
      ++k;
      continue;
    }
    --uses[static_cast<std::size_t>(operand)];
    for (const Term& term : dot.terms) uses[static_cast<std::size_t>(term.node)] += only_use ? 0 : 1;
    draft.at(id) = merged(cross, k, dot);
    k = 0;
  }
}

}  // namespace

Function with_merged_sums(const Function& function, Merging merging) {
  const Function flat = unfolded(function);
  Draft draft(flat);
  std::vector<int> uses = draft.use_counts();
  for (NodeId id = 0; id < flat.graph.size(); ++id) {
    if (draft.at(id).op == Op::sum) merge_operands(draft, id, uses, merging);
  }
  return unfolded(draft.finish());
}

Function like_terms(const Function& function) {
  return cheaper(function, with_shared_products(with_merged_sums(function)));
}

}  // namespace flatdyn

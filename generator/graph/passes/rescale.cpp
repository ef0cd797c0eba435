// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/rescale.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "graph/passes/coefficients.hpp"
#include "graph/passes/draft.hpp"
#include "graph/passes/share_products.hpp"

namespace flatdyn {
namespace {

std::size_t at(NodeId id) { return static_cast<std::size_t>(id); }

struct Use {  // a use by term `term` of a sum
  NodeId sum;
  std::size_t term;
};

// By node: the terms whose product it is a factor of, and whether every use is such a term, to the first power.
struct Uses {
  explicit Uses(const Draft& draft) : terms(draft.nodes.size()), is_free(draft.nodes.size(), true) {
    for (const NodeId root : roots(draft.source)) pin(draft, root);
    for (std::size_t id = 0; id < draft.nodes.size(); ++id) {
      const Node& node = draft.nodes[id];
      if (node.op == Op::sum) add_terms(draft, static_cast<NodeId>(id));
      if (node.op == Op::sum || node.op == Op::product) continue;
      for (const NodeId operand : node.operands) pin(draft, operand);
    }
  }

  std::vector<std::vector<Use>> terms;
  std::vector<bool> is_free;

 private:
  void pin(const Draft& draft, NodeId id) {
    is_free[at(id)] = false;
    if (draft.at(id).op != Op::product) return;
    for (const NodeId factor : draft.at(id).operands) is_free[at(factor)] = false;
  }

  void add_terms(const Draft& draft, NodeId id) {
    const Node& node = draft.at(id);
    for (std::size_t k = 0; k < node.terms.size(); ++k) {
      const NodeId operand = node.terms[k].node;
      const std::vector<NodeId>& factors = draft.at(operand).operands;
      terms[at(operand)].push_back({id, k});
      if (draft.at(operand).op != Op::product) continue;
      for (std::size_t j = 0; j < factors.size(); ++j) {
        if (j > 0 && factors[j] == factors[j - 1]) {
          is_free[at(factors[j])] = false;
        } else {
          terms[at(factors[j])].push_back({id, k});
        }
      }
    }
  }
};

int multiplications(const Draft& draft, const Node& sum, const std::vector<Use>& uses, const Rational& factor) {
  int total = 0;
  for (const Term& term : sum.terms) total += !term.coefficient.has_size_of(factor);
  for (const Use& use : uses) total += !draft.at(use.sum).terms[use.term].coefficient.has_reciprocal_size_of(factor);
  return total;
}

// The divisors of the sum that make one of its coefficients 1.
std::vector<Rational> candidates(const Draft& draft, const Node& sum, const std::vector<Use>& uses) {
  constexpr std::size_t kMost = 12;
  std::vector<Rational> result;
  const auto add = [&result](const Rational& factor) {
    if (result.size() < kMost && std::find(result.begin(), result.end(), factor) == result.end()) {
      result.push_back(factor);
    }
  };
  for (const Term& term : sum.terms) add(abs(term.coefficient));
  for (const Use& use : uses) add(1 / abs(draft.at(use.sum).terms[use.term].coefficient));
  return result;
}

// Whether a coefficient gets far larger than those that are there.
bool is_extreme(const Draft& draft, const Node& sum, const std::vector<Use>& uses, const Rational& factor) {
  const int by = exponent_of(factor);
  return std::any_of(sum.terms.begin(), sum.terms.end(),
                     [&](const Term& term) { return exponent_of(term.coefficient) - by > kLargestExponent; }) ||
         std::any_of(uses.begin(), uses.end(), [&](const Use& use) {
           return exponent_of(draft.at(use.sum).terms[use.term].coefficient) + by > kLargestExponent;
         });
}

bool rescale_node(Draft& draft, NodeId id, const std::vector<Use>& uses) {
  Node& sum = draft.at(id);
  Rational best = 1;
  int fewest = multiplications(draft, sum, uses, best);
  for (const Rational& factor : candidates(draft, sum, uses)) {
    const int count = multiplications(draft, sum, uses, factor);
    if (count >= fewest || is_extreme(draft, sum, uses, factor)) continue;
    fewest = count;
    best = factor;
  }
  if (best == 1) return false;
  for (Term& term : sum.terms) term.coefficient /= best;
  sum.value /= best;
  for (const Use& use : uses) draft.at(use.sum).terms[use.term].coefficient *= best;
  return true;
}

}  // namespace

Function rescale(const Function& function) {
  constexpr int kSweeps = 3;  // the factor of one sum may allow a better one for another
  const Function flat = unfolded(function);
  Draft draft(flat);
  const Uses uses(draft);
  bool changed = true;
  for (int sweep = 0; sweep < kSweeps && changed; ++sweep) {
    changed = false;
    for (NodeId id = 0; id < flat.graph.size(); ++id) {
      const Node& node = draft.at(id);
      if (node.op != Op::sum || is_scaled(node) || !uses.is_free[at(id)]) continue;
      if (rescale_node(draft, id, uses.terms[at(id)])) changed = true;
    }
  }
  return cheaper(function, with_shared_products(draft.finish()));
}

}  // namespace flatdyn

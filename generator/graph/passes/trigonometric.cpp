// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/trigonometric.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "graph/passes/polynomials.hpp"
#include "graph/passes/share_sums.hpp"

namespace flatdyn {
namespace {

struct SinCos {
  NodeId sin, cos;
};

// The sines and cosines of the angles that have both in the function, by the angle's node.
std::map<NodeId, SinCos> sines_and_cosines(const Graph& graph) {
  std::map<NodeId, SinCos> result;
  for (NodeId id = 0; id < graph.size(); ++id) {
    const Node& node = graph[id];
    if (node.op != Op::sin && node.op != Op::cos) continue;
    const auto [it, is_new] = result.emplace(node.operands[0], SinCos{-1, -1});
    (node.op == Op::sin ? it->second.sin : it->second.cos) = id;
  }
  std::erase_if(result, [](const auto& entry) { return entry.second.sin < 0 || entry.second.cos < 0; });
  return result;
}

// By node: whether a term of any sum has its square as a factor.
std::vector<bool> squared_nodes(const Polynomials& p) {
  std::vector<bool> squared(p.draft.nodes.size(), false);
  for (const Polynomial& polynomial : p.polynomials) {
    for (const PolynomialTerm& term : polynomial.terms) {
      const std::span<const NodeId> factors = p.monomials[term.monomial];
      for (std::size_t k = 1; k < factors.size(); ++k) {
        if (factors[k] == factors[k - 1]) squared[static_cast<std::size_t>(factors[k])] = true;
      }
    }
  }
  return squared;
}

// The place where a square is replaced.
enum class Where { same_sum, anywhere };

bool any_square(const Polynomials& p, const Polynomial& polynomial, MonomialId square) {
  return std::any_of(polynomial.terms.begin(), polynomial.terms.end(),
                     [&](const PolynomialTerm& term) { return p.monomials.divides(square, term.monomial); });
}

// Replaces x² by 1 - y² in sums that have both squares; or, if y²·cofactor is computed anyway, in any sum. Returns
// whether it replaced any.
bool eliminate(Polynomials& p, NodeId x, NodeId y, Where where) {
  const MonomialId square = p.monomials.id({x, x}), other = p.monomials.id({y, y});
  bool changed = false;
  for (Polynomial& polynomial : p.polynomials) {
    if (!any_square(p, polynomial, square)) continue;
    const bool has_both = any_square(p, polynomial, other);
    std::map<MonomialId, Rational> sum;
    for (const PolynomialTerm& term : polynomial.terms) {
      if (!p.monomials.divides(square, term.monomial)) {
        sum[term.monomial] += term.coefficient;
        continue;
      }
      const MonomialId cofactor = p.monomials.quotient(term.monomial, square);
      const MonomialId replacement = p.monomials.product(cofactor, other);
      const bool replaces = has_both || (where == Where::anywhere && p.uses_of(replacement) > 0);
      sum[replaces ? cofactor : term.monomial] += term.coefficient;
      if (replaces) sum[replacement] -= term.coefficient;
      changed = changed || replaces;
    }
    polynomial.terms.clear();
    for (const auto& [monomial, coefficient] : sum) {
      if (!coefficient.is_zero()) polynomial.terms.push_back({coefficient, monomial});
    }
  }
  return changed;
}

}  // namespace

Function trigonometric(const Function& function) {
  const Function flat = unfolded(function);
  const Polynomials start(flat);
  const std::vector<bool> squared = squared_nodes(start);
  std::map<NodeId, SinCos> pairs = sines_and_cosines(flat.graph);
  std::erase_if(pairs, [&squared](const auto& entry) {
    return !squared[static_cast<std::size_t>(entry.second.sin)] && !squared[static_cast<std::size_t>(entry.second.cos)];
  });
  if (pairs.empty()) return function;
  Function best = function;
  for (const Where where : {Where::same_sum, Where::anywhere}) {
    for (const bool keep_cosine : {true, false}) {
      Polynomials p(start);
      bool changed = false;
      for (const auto& [angle, pair] : pairs) {
        const NodeId gone = keep_cosine ? pair.sin : pair.cos, kept = keep_cosine ? pair.cos : pair.sin;
        if (eliminate(p, gone, kept, where)) changed = true;
      }
      if (changed) best = cheaper(std::move(best), with_shared_sums(p.finish()));
    }
  }
  return best;
}

}  // namespace flatdyn

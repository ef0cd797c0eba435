// SPDX-License-Identifier: GPL-2.0-or-later
#include "passes/polynomials.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace flatdyn {

MonomialId MonomialTable::id(std::vector<NodeId> factors) {
  const auto [it, is_new] = ids_.emplace(std::move(factors), size());
  if (is_new) factors_.push_back(it->first);
  return it->second;
}

MonomialId MonomialTable::product(MonomialId a, MonomialId b) {
  std::vector<NodeId> result;
  std::merge((*this)[a].begin(), (*this)[a].end(), (*this)[b].begin(), (*this)[b].end(), std::back_inserter(result));
  return id(std::move(result));
}

MonomialId MonomialTable::common(MonomialId a, MonomialId b) {
  const auto &x = (*this)[a], &y = (*this)[b];
  std::vector<NodeId> result;
  std::set_intersection(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(result));
  return id(std::move(result));
}

MonomialId MonomialTable::quotient(MonomialId a, MonomialId b) {
  const auto &x = (*this)[a], &y = (*this)[b];
  std::vector<NodeId> result;
  std::set_difference(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(result));
  return id(std::move(result));
}

bool MonomialTable::divides(MonomialId divisor, MonomialId a) const {
  const auto &x = (*this)[a], &y = (*this)[divisor];
  return std::includes(x.begin(), x.end(), y.begin(), y.end());
}

Polynomials::Polynomials(const Function& flat) : draft(flat) {
  const NodeId count = static_cast<NodeId>(draft.nodes.size());
  const auto use_as_node = [this](NodeId id) {
    if (draft.at(id).op == Op::product) ++uses_of(monomial_of(id));
  };
  for (const NodeId root : roots(draft.source)) use_as_node(root);
  for (NodeId id = 0; id < count; ++id) {
    const Node& node = draft.at(id);
    for (const NodeId operand : node.operands) use_as_node(operand);
    if (node.op != Op::sum) continue;
    Polynomial polynomial = {id, {}};
    for (const Term& term : node.terms) {
      polynomial.terms.push_back({term.coefficient, monomial_of(term.node)});
      ++uses_of(polynomial.terms.back().monomial);
    }
    if (!node.value.is_zero()) polynomial.terms.push_back({node.value, monomials.id({})});
    polynomials.push_back(std::move(polynomial));
  }
}

MonomialId Polynomials::monomial_of(NodeId node) {
  return monomials.id(draft.at(node).op == Op::product ? draft.at(node).operands : std::vector<NodeId>{node});
}

int& Polynomials::uses_of(MonomialId id) {
  if (uses.size() <= static_cast<std::size_t>(id)) uses.resize(static_cast<std::size_t>(id) + 1, 0);
  return uses[static_cast<std::size_t>(id)];
}

Function Polynomials::finish() {
  std::vector<NodeId> node_of(static_cast<std::size_t>(monomials.size()), -1);
  for (const Polynomial& polynomial : polynomials) {
    Rational constant = 0;
    std::vector<Term> terms;
    for (const PolynomialTerm& term : polynomial.terms) {
      const auto& factors = monomials[term.monomial];
      if (factors.empty()) {
        constant += term.coefficient;
        continue;
      }
      NodeId& node = node_of[static_cast<std::size_t>(term.monomial)];
      if (node < 0) node = factors.size() == 1 ? factors[0] : draft.add_product(factors);
      terms.push_back({term.coefficient, node});
    }
    draft.at(polynomial.node) = Node{Op::sum, constant, {}, std::move(terms), {}};
  }
  return draft.finish();
}

}  // namespace flatdyn

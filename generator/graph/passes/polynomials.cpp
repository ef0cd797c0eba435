// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/polynomials.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace flatdyn {

MonomialId MonomialTable::id(std::span<const NodeId> factors) {
  std::uint64_t hash = factors.size();
  for (const NodeId factor : factors) hash = mixed_bits(hash ^ static_cast<std::uint64_t>(factor));
  const MonomialId next = size();
  const MonomialId found =
      index_.find_or_add(hash, next, [&](MonomialId k) { return std::ranges::equal((*this)[k], factors); });
  if (found == next) {
    factors_.insert(factors_.end(), factors.begin(), factors.end());
    ends_.push_back(factors_.size());
  }
  return found;
}

MonomialTable::Split MonomialTable::split(MonomialId a, MonomialId b) {
  const auto x = (*this)[a], y = (*this)[b];
  for (std::vector<NodeId>& part : scratch_) part.clear();
  auto& [common, first, second] = scratch_;
  auto i = x.begin(), j = y.begin();
  while (i != x.end() && j != y.end()) {
    if (*i == *j) {
      common.push_back(*i);
      ++i, ++j;
    } else if (*i < *j) {
      first.push_back(*i++);
    } else {
      second.push_back(*j++);
    }
  }
  if (common.empty()) return {id({}), a, b};
  first.insert(first.end(), i, x.end());
  second.insert(second.end(), j, y.end());
  return {id(common), id(first), id(second)};
}

MonomialId MonomialTable::product(MonomialId a, MonomialId b) {
  const auto x = (*this)[a], y = (*this)[b];
  std::vector<NodeId> result;
  std::merge(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(result));
  return id(result);
}

MonomialId MonomialTable::quotient(MonomialId a, MonomialId b) {
  const auto x = (*this)[a], y = (*this)[b];
  std::vector<NodeId> result;
  std::set_difference(x.begin(), x.end(), y.begin(), y.end(), std::back_inserter(result));
  return id(result);
}

bool MonomialTable::divides(MonomialId divisor, MonomialId a) const {
  const auto x = (*this)[a], y = (*this)[divisor];
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
  if (draft.at(node).op == Op::product) return monomials.id(draft.at(node).operands);
  return monomials.id(std::span(&node, 1));
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
      const auto factors = monomials[term.monomial];
      if (factors.empty()) {
        constant += term.coefficient;
        continue;
      }
      NodeId& node = node_of[static_cast<std::size_t>(term.monomial)];
      if (node < 0) node = factors.size() == 1 ? factors[0] : draft.add_product({factors.begin(), factors.end()});
      terms.push_back({term.coefficient, node});
    }
    draft.at(polynomial.node) = Node{Op::sum, constant, {}, std::move(terms), {}};
  }
  return draft.finish();
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/expressions.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "code/lower/magnitudes.hpp"

namespace flatdyn {

using code::Expression;

NodeExpressions::NodeExpressions(const Graph& graph, const VariableNames& names, std::vector<bool> is_fused,
                                 const ReadInPlace* in_place, const GivenOperands* given)
    : graph_(graph),
      names_(names),
      is_fused_(std::move(is_fused)),
      magnitudes_(typical_magnitudes(graph)),
      in_place_(in_place),
      given_(given) {}

Expression NodeExpressions::definition(NodeId id) const {
  const Node& node = graph_[id];
  switch (node.op) {
    case Op::constant:
      return code::Literal{node.value};
    case Op::sum:
      if (const std::optional<NodeId> dot = negated_sum(node)) return sum(*dot, true);
      return sum(id, false);
    case Op::product:
      return code::Product{operands(id)};
    case Op::quotient:
      return code::Quotient{operands(id)};
    case Op::sign:
      return code::Call{code::Operation::sign, {use(node.operands[0])}};
    case Op::sqrt:
      return code::Call{code::Operation::sqrt, {use(node.operands[0])}};
    case Op::tanh:
      break;  // expanded
    case Op::sin:
    case Op::cos:
    case Op::input:
      break;  // always a variable
  }
  return use(id);
}

Expression NodeExpressions::use(NodeId id) const {
  const std::string& name = names_[static_cast<std::size_t>(id)];
  if (!name.empty()) return code::Variable{name};
  if (in_place_ != nullptr) {
    if (const auto read = in_place_->find(id); read != in_place_->end()) return read->second;
  }
  return definition(id);
}

// The sum that `node` negates, if it is written inline: its signs are changed instead.
std::optional<NodeId> NodeExpressions::negated_sum(const Node& node) const {
  if (!is_negation(node)) return std::nullopt;
  const NodeId dot = node.terms[0].node;
  const bool written_out = names_[static_cast<std::size_t>(dot)].empty() && graph_[dot].op == Op::sum;
  return written_out ? std::optional(dot) : std::nullopt;
}

Expression NodeExpressions::operand(NodeId user, NodeId id) const {
  if (given_ != nullptr) {
    const auto given = given_->operands.find({user, id});
    if (given != given_->operands.end()) return code::Variable{given->second};
  }
  return use(id);
}

std::vector<Expression> NodeExpressions::operands(NodeId id) const {
  std::vector<Expression> list;
  for (const NodeId each : graph_[id].operands) list.push_back(operand(id, each));
  return list;
}

namespace {

// The terms in the order of the graph, except that inputs are sorted by kind and index: q_1 + q_2, whichever was
// created first.
std::vector<Term> readable_order(const Graph& graph, std::vector<Term> terms) {
  std::vector<std::size_t> slots;
  std::vector<Term> inputs;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    if (graph[terms[k].node].op != Op::input) continue;
    slots.push_back(k);
    inputs.push_back(terms[k]);
  }
  std::sort(inputs.begin(), inputs.end(), [&graph](const Term& a, const Term& b) {
    const Input& x = graph[a.node].input;
    const Input& y = graph[b.node].input;
    return std::tie(x.kind, x.index) < std::tie(y.kind, y.index);
  });
  for (std::size_t k = 0; k < slots.size(); ++k) terms[slots[k]] = inputs[k];
  return terms;
}

}  // namespace

// The variable in place of a coefficient; empty if there is no such variable.
std::string NodeExpressions::coefficient_of(NodeId user, NodeId id) const {
  if (given_ == nullptr) return "";
  const auto given = given_->coefficients.find({user, id});
  return given == given_->coefficients.end() ? "" : given->second;
}

// The summands of a sum, with signs changed if it is `negated`.
std::vector<NodeExpressions::Summand> NodeExpressions::summands(NodeId id, bool negated) const {
  const Node& node = graph_[id];
  const auto size_of = [](const Rational& coefficient, double magnitude) {
    constexpr double kLeast = 1e-300;
    return std::ilogb(std::max(std::abs(coefficient.truncated()) * magnitude, kLeast));
  };
  std::vector<Summand> result;
  for (const Term& term : readable_order(graph_, node.terms)) {
    result.push_back({negated ? Rational(-term.coefficient) : term.coefficient, term.node,
                      size_of(term.coefficient, magnitudes_[static_cast<std::size_t>(term.node)]),
                      coefficient_of(id, term.node)});
  }
  if (node.value != 0) {
    result.push_back(
        {negated ? Rational(-node.value) : node.value, -1, size_of(node.value, 1), coefficient_of(id, -1)});
  }
  return result;
}

// Puts small terms first, so that few rounding errors are those of large sums (Higham, Accuracy and Stability of
// Numerical Algorithms, 4.2); terms within a factor of two are in a readable order. The first two may be swapped so
// that a positive one comes first and signs become subtractions: b - a, not -a + b.
std::vector<NodeExpressions::Summand> NodeExpressions::small_first(std::vector<Summand> items) {
  if (items.empty()) return items;
  std::stable_sort(items.begin(), items.end(), [](const Summand& a, const Summand& b) { return a.size < b.size; });
  const int reach = items[items.size() > 1 ? 1 : 0].size;
  const auto leader = std::find_if(items.begin(), items.end(),
                                   [reach](const Summand& item) { return item.coefficient > 0 && item.size <= reach; });
  if (leader != items.end()) std::rotate(items.begin(), leader, leader + 1);
  return items;
}

std::vector<Term> NodeExpressions::terms_in_order(NodeId id) const {
  std::vector<Term> terms;
  for (const Summand& each : small_first(summands(id, false))) terms.push_back({each.coefficient, each.node});
  return terms;
}

Expression NodeExpressions::sum(NodeId id, bool negated) const {
  std::vector<Summand> items = summands(id, negated);
  return is_fused_.empty() ? plain_sum(id, small_first(std::move(items))) : fused_sum(id, std::move(items));
}

// Whether fused multiply-adds can take the summand: a fused product, or a multiple of a number.
bool NodeExpressions::is_multiplied_in_sums(const Summand& item) const {
  if (item.is_constant()) return false;
  return abs(item.coefficient) != 1 || is_fused_[static_cast<std::size_t>(item.node)];
}

// The sum of the plain summands, or the smallest product if there are no plain ones, to which the others are added:
// fma(a, b, fma(c, d, x - y)).
Expression NodeExpressions::fused_sum(NodeId user, std::vector<Summand> items) const {
  const auto products = std::stable_partition(items.begin(), items.end(),
                                              [this](const Summand& item) { return !is_multiplied_in_sums(item); });
  const std::vector<Summand> plain = small_first({items.begin(), products});
  std::vector<Summand> rest = small_first({products, items.end()});
  if (rest.empty()) return plain_sum(user, plain);
  const bool has_start = !plain.empty();
  Expression result = plain_sum(user, has_start ? plain : std::vector<Summand>{rest.front()});
  for (std::size_t k = has_start ? 0 : 1; k < rest.size(); ++k) result = fused(rest[k], std::move(result));
  return result;
}

// A fused multiply-add of a product and a sum: "fma(-a * b, c, sum)". It takes the last factor as the second one.
Expression NodeExpressions::fused(const Summand& product, Expression sum) const {
  constexpr auto kFused = code::Operation::multiply_add;
  if (abs(product.coefficient) != 1) {
    return code::Call{kFused, {code::Literal{product.coefficient}, use(product.node), std::move(sum)}};
  }
  std::vector<NodeId> factors = graph_[product.node].operands;
  const bool is_negative = product.coefficient < 0;
  const auto is_atom = [this](NodeId id) { return code::is_atom(use(id)); };
  if (is_negative && factors.size() == 2 && !is_atom(factors[0]) && is_atom(factors[1]))
    std::swap(factors[0], factors[1]);
  const NodeId last = factors.back();
  factors.pop_back();
  code::Product others;
  for (const NodeId each : factors) others.operands.push_back(operand(product.node, each));
  Expression first = others;
  if (is_negative) {
    first = code::Negation{{std::move(others)}};
  } else if (factors.size() == 1) {
    first = use(factors[0]);
  }
  return code::Call{kFused, {std::move(first), use(last), std::move(sum)}};
}

// The summand without its sign.
Expression NodeExpressions::magnitude(NodeId user, const Summand& item) const {
  if (item.is_plain()) return operand(user, item.node);
  Expression size = code::Literal{abs(item.coefficient)};
  if (!item.by_name.empty()) size = code::Variable{item.by_name};
  if (item.is_constant()) return size;
  return code::Product{{std::move(size), operand(user, item.node)}};
}

// A constant or a coefficient that is negative stands as it is where no operator is before it.
code::Addend NodeExpressions::first_addend(NodeId user, const Summand& item) const {
  const bool has_sign_apart = item.is_plain() || !item.by_name.empty();
  if (item.coefficient > 0 || has_sign_apart) return {item.coefficient < 0, magnitude(user, item)};
  if (item.is_constant()) return {false, code::Literal{item.coefficient}};
  return {false, code::Product{{code::Literal{item.coefficient}, operand(user, item.node)}}};
}

Expression NodeExpressions::plain_sum(NodeId user, const std::vector<Summand>& items) const {
  code::Sum sum{{first_addend(user, items.front())}};
  if (items.size() == 1 && !sum.addends[0].is_negative) return sum.addends[0].value;
  for (std::size_t k = 1; k < items.size(); ++k) {
    sum.addends.push_back({items[k].coefficient < 0, magnitude(user, items[k])});
  }
  return sum;
}

}  // namespace flatdyn

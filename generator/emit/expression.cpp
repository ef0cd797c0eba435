// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/expression.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace flatdyn {

namespace {

bool starts_with_minus(const std::string& code) { return code.front() == '-'; }

}  // namespace

bool has_fused(const std::string& code) { return code.find("fma(") != std::string::npos; }

ExpressionPrinter::Text ExpressionPrinter::define(NodeId id) const {
  const Node& node = graph_[id];
  switch (node.op) {
    case Op::constant: {
      const std::string code = dialect_.literal(node.value);
      return {code, starts_with_minus(code) ? Binding::sum : Binding::atom};
    }
    case Op::sum:
      if (const std::optional<NodeId> dot = negated_sum(node)) return sum(*dot, true);
      return sum(id, false);
    case Op::product:
      return product(id);
    case Op::quotient:
      return quotient(id);
    case Op::sign:
      return {dialect_.sign(use(node.operands[0])), Binding::atom};
    case Op::sqrt:
      return {dialect_.sqrt(use(node.operands[0])), Binding::atom};
    case Op::sin:
    case Op::cos:
    case Op::input:
      break;  // always a variable
  }
  return reference(id);
}

// The sum that `node` negates, if it is written inline: its signs are changed instead.
std::optional<NodeId> ExpressionPrinter::negated_sum(const Node& node) const {
  if (!is_negation(node)) return std::nullopt;
  const NodeId dot = node.terms[0].node;
  const bool written_out = names_[static_cast<std::size_t>(dot)].empty() && graph_[dot].op == Op::sum;
  return written_out ? std::optional(dot) : std::nullopt;
}

ExpressionPrinter::Text ExpressionPrinter::reference(NodeId id) const {
  const std::string& name = names_[static_cast<std::size_t>(id)];
  return name.empty() ? define(id) : Text{name, Binding::atom};
}

std::string ExpressionPrinter::operand(NodeId user, NodeId id, Binding at_least) const {
  if (given_ != nullptr) {
    const auto given = given_->operands.find({user, id});
    if (given != given_->operands.end()) return given->second;
  }
  const Text text = reference(id);
  return text.binding < at_least ? "(" + text.code + ")" : text.code;
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

// The variable in place of a coefficient; empty: there is none.
std::string ExpressionPrinter::coefficient_of(NodeId user, NodeId id) const {
  if (given_ == nullptr) return "";
  const auto given = given_->coefficients.find({user, id});
  return given == given_->coefficients.end() ? "" : given->second;
}

// The summands of a sum, with signs changed if it is `negated`.
std::vector<ExpressionPrinter::Summand> ExpressionPrinter::summands(NodeId id, bool negated) const {
  const Node& node = graph_[id];
  const auto size_of = [](const Rational& coefficient, double magnitude) {
    constexpr double kLeast = 1e-300;
    return std::ilogb(std::max(std::abs(coefficient.truncated()) * magnitude, kLeast));
  };
  std::vector<Summand> result;
  for (const Term& term : readable_order(graph_, node.terms)) {
    const std::string by_name = coefficient_of(id, term.node);
    const bool plain = abs(term.coefficient) == 1 && by_name.empty();
    result.push_back({negated ? Rational(-term.coefficient) : term.coefficient,
                      operand(id, term.node, plain ? Binding::quotient : Binding::product),
                      plain ? Binding::atom : Binding::product,
                      size_of(term.coefficient, magnitudes_[static_cast<std::size_t>(term.node)]), term.node, by_name});
  }
  if (node.value != 0) {
    result.push_back({negated ? Rational(-node.value) : node.value, "", Binding::atom, size_of(node.value, 1), -1,
                      coefficient_of(id, -1)});
  }
  return result;
}

// Puts small terms first, so that few rounding errors are those of large sums (Higham, Accuracy and Stability of
// Numerical Algorithms, 4.2); terms within a factor of two are in a readable order. The first two may be swapped so
// that a positive one comes first and signs become subtractions: b - a, not -a + b.
std::vector<ExpressionPrinter::Summand> ExpressionPrinter::small_first(std::vector<Summand> items) {
  if (items.empty()) return items;
  std::stable_sort(items.begin(), items.end(), [](const Summand& a, const Summand& b) { return a.size < b.size; });
  const int reach = items[items.size() > 1 ? 1 : 0].size;
  const auto leader = std::find_if(items.begin(), items.end(),
                                   [reach](const Summand& item) { return item.coefficient > 0 && item.size <= reach; });
  if (leader != items.end()) std::rotate(items.begin(), leader, leader + 1);
  return items;
}

std::vector<Term> ExpressionPrinter::terms_in_order(NodeId id) const {
  std::vector<Term> terms;
  for (const Summand& each : small_first(summands(id, false))) terms.push_back({each.coefficient, each.node});
  return terms;
}

ExpressionPrinter::Text ExpressionPrinter::sum(NodeId id, bool negated) const {
  std::vector<Summand> items = summands(id, negated);
  return is_fused_.empty() ? plain_sum(small_first(std::move(items))) : fused_sum(std::move(items));
}

// Whether fused multiply-adds can take the summand: a fused product, or a multiple of a number.
bool ExpressionPrinter::is_multiplied_in_sums(const Summand& item) const {
  if (item.factor.empty()) return false;
  return abs(item.coefficient) != 1 || is_fused_[static_cast<std::size_t>(item.node)];
}

// The sum of the plain summands, or the smallest product if there are none, to which the others are added:
// fma(a, b, fma(c, d, x - y)).
ExpressionPrinter::Text ExpressionPrinter::fused_sum(std::vector<Summand> items) const {
  const auto products = std::stable_partition(items.begin(), items.end(),
                                              [this](const Summand& item) { return !is_multiplied_in_sums(item); });
  const std::vector<Summand> plain = small_first({items.begin(), products});
  std::vector<Summand> rest = small_first({products, items.end()});
  if (rest.empty()) return plain_sum(plain);
  const bool has_start = !plain.empty();
  Text text = plain_sum(has_start ? plain : std::vector<Summand>{rest.front()});
  for (std::size_t k = has_start ? 0 : 1; k < rest.size(); ++k) text = {fused(rest[k], text.code), Binding::atom};
  return text;
}

// A fused multiply-add of a product and a sum: "fma(-a * b, c, sum)". It takes the last factor as the second one.
std::string ExpressionPrinter::fused(const Summand& product, const std::string& sum) const {
  if (abs(product.coefficient) != 1) {
    return dialect_.fused(dialect_.literal(product.coefficient), reference(product.node).code, sum);
  }
  std::vector<NodeId> factors = graph_[product.node].operands;
  const bool is_negative = product.coefficient < 0;
  const auto is_atom = [this](NodeId id) { return reference(id).binding == Binding::atom; };
  if (is_negative && factors.size() == 2 && !is_atom(factors[0]) && is_atom(factors[1]))
    std::swap(factors[0], factors[1]);
  const NodeId last = factors.back();
  factors.pop_back();
  std::string first = factors.size() == 1 && !is_negative ? reference(factors[0]).code
                                                          : operand(product.node, factors[0], Binding::product);
  for (std::size_t k = 1; k < factors.size(); ++k) first += " * " + operand(product.node, factors[k], Binding::product);
  return dialect_.fused((is_negative ? "-" : "") + first, reference(last).code, sum);
}

// The coefficient without its sign.
std::string ExpressionPrinter::size_text(const Summand& item) const {
  return item.by_name.empty() ? dialect_.literal(abs(item.coefficient)) : item.by_name;
}

ExpressionPrinter::Text ExpressionPrinter::plain_sum(const std::vector<Summand>& items) const {
  const auto magnitude = [this](const Summand& item) {
    if (item.factor.empty()) return size_text(item);
    return item.binding == Binding::atom ? item.factor : size_text(item) + " * " + item.factor;
  };
  const Summand& first = items.front();
  const bool has_sign_apart = (first.binding == Binding::atom && !first.factor.empty()) || !first.by_name.empty();
  const bool leading_minus = first.coefficient < 0 && has_sign_apart;
  std::string code = magnitude(first);
  if (leading_minus) {
    code = "-" + code;
  } else if (first.coefficient < 0) {
    code = dialect_.literal(first.coefficient) + (first.factor.empty() ? "" : " * " + first.factor);
  }
  for (std::size_t k = 1; k < items.size(); ++k) {
    code += (items[k].coefficient < 0 ? " - " : " + ") + magnitude(items[k]);
  }
  const bool single = items.size() == 1 && !starts_with_minus(code);
  return {code, single ? first.binding : Binding::sum};
}

ExpressionPrinter::Text ExpressionPrinter::product(NodeId id) const {
  const std::vector<NodeId>& factors = graph_[id].operands;
  std::string code = operand(id, factors[0], Binding::product);
  for (std::size_t k = 1; k < factors.size(); ++k) code += " * " + operand(id, factors[k], Binding::product);
  return {code, Binding::product};
}

ExpressionPrinter::Text ExpressionPrinter::quotient(NodeId id) const {
  const std::vector<NodeId>& parts = graph_[id].operands;
  return {operand(id, parts[0], Binding::product) + " / " + operand(id, parts[1], Binding::atom), Binding::quotient};
}

}  // namespace flatdyn

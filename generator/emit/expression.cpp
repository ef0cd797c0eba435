// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/expression.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace flatdyn {

namespace {

bool starts_with_minus(const std::string& code) { return code.front() == '-'; }

}  // namespace

ExpressionPrinter::Text ExpressionPrinter::define(NodeId id) const {
  const Node& node = graph_[id];
  switch (node.op) {
    case Op::constant: {
      const std::string code = dialect_.literal(node.value);
      return {code, starts_with_minus(code) ? Binding::sum : Binding::atom};
    }
    case Op::sum:
      if (const Node* dot = negated_sum(node)) return sum(*dot, true);
      return sum(node, false);
    case Op::product:
      return product(node);
    case Op::quotient:
      return quotient(node);
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

// The sum that `node` negates, if it is written inline: its signs are changed instead. Otherwise nullptr.
const Node* ExpressionPrinter::negated_sum(const Node& node) const {
  if (!is_scaled(node) || node.terms[0].coefficient != -1) return nullptr;
  const NodeId dot = node.terms[0].node;
  const bool written_out = names_[static_cast<std::size_t>(dot)].empty() && graph_[dot].op == Op::sum;
  return written_out ? &graph_[dot] : nullptr;
}

ExpressionPrinter::Text ExpressionPrinter::reference(NodeId id) const {
  const std::string& name = names_[static_cast<std::size_t>(id)];
  return name.empty() ? define(id) : Text{name, Binding::atom};
}

std::string ExpressionPrinter::operand(NodeId id, Binding at_least) const {
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

// The summands of a sum, with signs changed if it is `negated`.
std::vector<ExpressionPrinter::Summand> ExpressionPrinter::summands(const Node& node, bool negated) const {
  const auto size_of = [](const Rational& coefficient, double magnitude) {
    constexpr double kLeast = 1e-300;
    return std::ilogb(std::max(std::abs(coefficient.convert_to<double>()) * magnitude, kLeast));
  };
  std::vector<Summand> result;
  for (const Term& term : readable_order(graph_, node.terms)) {
    const bool plain = abs(term.coefficient) == 1;
    result.push_back({negated ? Rational(-term.coefficient) : term.coefficient,
                      operand(term.node, plain ? Binding::quotient : Binding::product),
                      plain ? Binding::atom : Binding::product,
                      size_of(term.coefficient, magnitudes_[static_cast<std::size_t>(term.node)])});
  }
  if (node.value != 0) {
    result.push_back({negated ? Rational(-node.value) : node.value, "", Binding::atom, size_of(node.value, 1)});
  }
  return result;
}

// Puts small terms first, so that few rounding errors are those of large sums (Higham, Accuracy and Stability of
// Numerical Algorithms, 4.2); terms within a factor of two are in a readable order. The first two may be swapped so
// that a positive one comes first and signs become subtractions: b - a, not -a + b.
std::vector<ExpressionPrinter::Summand> ExpressionPrinter::small_first(std::vector<Summand> items) {
  std::stable_sort(items.begin(), items.end(), [](const Summand& a, const Summand& b) { return a.size < b.size; });
  const int reach = items[items.size() > 1 ? 1 : 0].size;
  const auto leader = std::find_if(items.begin(), items.end(),
                                   [reach](const Summand& item) { return item.coefficient > 0 && item.size <= reach; });
  if (leader != items.end()) std::rotate(items.begin(), leader, leader + 1);
  return items;
}

ExpressionPrinter::Text ExpressionPrinter::sum(const Node& node, bool negated) const {
  const std::vector<Summand> items = small_first(summands(node, negated));
  const auto magnitude = [this](const Summand& item) {
    if (item.factor.empty()) return dialect_.literal(abs(item.coefficient));
    return item.binding == Binding::atom ? item.factor : dialect_.literal(abs(item.coefficient)) + " * " + item.factor;
  };
  const Summand& first = items.front();
  const bool leading_minus = first.coefficient < 0 && first.binding == Binding::atom && !first.factor.empty();
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

ExpressionPrinter::Text ExpressionPrinter::product(const Node& node) const {
  std::string code = operand(node.operands[0], Binding::product);
  for (std::size_t k = 1; k < node.operands.size(); ++k) code += " * " + operand(node.operands[k], Binding::product);
  return {code, Binding::product};
}

ExpressionPrinter::Text ExpressionPrinter::quotient(const Node& node) const {
  return {operand(node.operands[0], Binding::product) + " / " + operand(node.operands[1], Binding::atom),
          Binding::quotient};
}

}  // namespace flatdyn

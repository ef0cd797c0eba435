// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/readback/straight_line.hpp"

#include <algorithm>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {

int StraightLine::make(const Operation& operation) {
  const Key key{operation.step,       operation.a,           operation.b,       operation.value,
                operation.input.kind, operation.input.index, operation.is_exact};
  const auto [found, is_new] = index_.emplace(key, size());
  return is_new ? append(operation) : found->second;
}

int StraightLine::append(const Operation& operation) {
  operations_.push_back(operation);
  return size() - 1;
}

int StraightLine::constant(double value) { return make({Step::constant, -1, -1, value}); }
int StraightLine::input(Input input) { return make({Step::input, -1, -1, 0, input}); }
int StraightLine::sine(int joint, int angle) { return make({Step::sine, angle, -1, 0, {InputKind::q, joint}}); }
int StraightLine::cosine(int joint, int angle) { return make({Step::cosine, angle, -1, 0, {InputKind::q, joint}}); }
int StraightLine::negate(int a) { return make({Step::negate, a}); }
int StraightLine::add(int a, int b) { return make({Step::add, a, b}); }
int StraightLine::subtract(int a, int b) { return make({Step::subtract, a, b}); }
int StraightLine::multiply(int a, int b) { return make({Step::multiply, a, b}); }
int StraightLine::fused(int a, int b, int c) { return add(make({Step::multiply, a, b, 0, {}, true}), c); }
int StraightLine::divide(int a, int b) { return make({Step::divide, a, b}); }
int StraightLine::sign(int a) { return make({Step::sign, a}); }
int StraightLine::sqrt(int a) { return make({Step::sqrt, a}); }

StraightLine with_constants_unshared(const StraightLine& lines, const std::function<bool(double)>& is_unshared) {
  StraightLine result;
  std::vector<int> image;
  const auto of = [&](int k) {
    if (k < 0) return k;
    const bool is_new = lines[k].step == Step::constant && is_unshared(lines[k].value);
    return is_new ? result.append(lines[k]) : image[static_cast<std::size_t>(k)];
  };
  for (int k = 0; k < lines.size(); ++k) {
    Operation operation = lines[k];
    operation.a = of(operation.a);
    operation.b = of(operation.b);
    image.push_back(result.append(operation));
  }
  for (const std::vector<int>& entries : lines.outputs) {
    result.outputs.emplace_back();
    for (const int entry : entries) result.outputs.back().push_back(of(entry));
  }
  for (const int condition : lines.validity_conditions) result.validity_conditions.push_back(of(condition));
  return result;
}

namespace {

[[noreturn]] void refuse(const char* what) {
  throw Failure(FailureKind::bug, std::string("emitted text cannot be read back: ") + what);
}

// Throws if a node grows too large. Repeated squaring doubles powers, and the digits of constants, with every line, so
// that a few lines may exceed any memory. Genuine code has small powers and constants of some thousand bits.
void refuse_growth(const Node& node) {
  constexpr std::size_t kMostFactors = 10'000;
  constexpr std::size_t kMostBits = 1'000'000;
  if (node.operands.size() > kMostFactors) refuse("a power too high");
  if (node.value.bits() > kMostBits) refuse("a constant too long");
  for (const Term& term : node.terms) {
    if (term.coefficient.bits() > kMostBits) refuse("a coefficient too long");
  }
}

NodeId quotient(NodeId a, NodeId b, Graph& graph) {
  if (graph.is_zero(b)) refuse("a division by zero");
  return graph.quotient(a, b);
}

NodeId node_of(const Operation& operation, const std::vector<NodeId>& nodes, Graph& graph) {
  const auto node = [&nodes](int k) { return nodes[static_cast<std::size_t>(k)]; };
  const auto angle = [&] { return operation.a < 0 ? graph.input(operation.input) : node(operation.a); };
  switch (operation.step) {
    case Step::constant:
      return graph.constant(Rational(operation.value));
    case Step::input:
      return graph.input(operation.input);
    case Step::sine:
      return graph.sin(angle());
    case Step::cosine:
      return graph.cos(angle());
    case Step::negate:
      return graph.sum({{-1, node(operation.a)}});
    case Step::add:
      return graph.sum({{1, node(operation.a)}, {1, node(operation.b)}});
    case Step::subtract:
      return graph.sum({{1, node(operation.a)}, {-1, node(operation.b)}});
    case Step::multiply:
      return graph.product({node(operation.a), node(operation.b)});
    case Step::divide:
      return quotient(node(operation.a), node(operation.b), graph);
    case Step::sqrt:
      return graph.sqrt(node(operation.a));
    case Step::sign:
      break;
  }
  return graph.sign(node(operation.a));
}

// The scale of a condition: s in s + x - s, s - x - s, or -s + x + s.
int scale_of(const StraightLine& lines, int condition) {
  const Operation& last = lines[condition];
  const bool adds = last.step == Step::add;
  if (adds || last.step == Step::subtract) {
    const Operation& first = lines[last.a];
    const bool is_sum = first.step == Step::add || first.step == Step::subtract;
    const bool is_below = is_sum && lines[first.a].step == Step::negate;
    if (is_sum && !adds && first.a == last.b) return first.a;
    if (is_below && adds && lines[first.a].a == last.b) return first.a;
  }
  refuse("a condition without its scale");
}

}  // namespace

Function graph_of(const StraightLine& lines, const Function& like) {
  Function result = like;
  result.graph = Graph();
  std::vector<NodeId> nodes;
  for (int k = 0; k < lines.size(); ++k) {
    nodes.push_back(node_of(lines[k], nodes, result.graph));
    refuse_growth(result.graph[nodes.back()]);
  }
  for (std::size_t o = 0; o < lines.outputs.size(); ++o) {
    for (std::size_t e = 0; e < lines.outputs[o].size(); ++e) {
      const int written = lines.outputs[o][e];
      result.outputs[o].entries[e] = written < 0 ? result.graph.constant(0) : nodes[static_cast<std::size_t>(written)];
    }
  }
  result.validity_conditions.clear();
  for (const int condition : lines.validity_conditions)
    result.validity_conditions.push_back(nodes[static_cast<std::size_t>(condition)]);
  result.pivot_scales.clear();
  for (std::size_t k = 0; k < std::min(like.pivot_scales.size(), lines.validity_conditions.size()); ++k) {
    const int condition = lines.validity_conditions[k];
    const int from = has_scale(like, k) ? scale_of(lines, condition) : condition;
    result.pivot_scales.push_back(nodes[static_cast<std::size_t>(from)]);
  }
  return result;
}

}  // namespace flatdyn

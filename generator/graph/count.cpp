// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/count.hpp"

#include <fmt/format.h>

#include "graph/rational_tanh.hpp"

namespace flatdyn {
namespace {

bool is_sign(const Rational& coefficient) { return coefficient == 1 || coefficient == -1; }

void add_node(const Node& node, OperationCount& count) {
  switch (node.op) {
    case Op::sum:
      count.additions += static_cast<int>(node.terms.size()) + (node.value.is_zero() ? 0 : 1) - 1;
      for (const Term& term : node.terms) count.multiplications += is_sign(term.coefficient) ? 0 : 1;
      break;
    case Op::product:
      count.multiplications += static_cast<int>(node.operands.size()) - 1;
      break;
    case Op::quotient:
    case Op::sqrt:
      ++count.divisions;
      break;
    case Op::sin:
    case Op::cos:
      ++count.trigonometric;
      break;
    case Op::tanh:
      count.additions += TanhConstants::kAdditions;
      count.multiplications += TanhConstants::kMultiplications;
      count.divisions += TanhConstants::kDivisions;
      break;
    case Op::constant:
    case Op::input:
    case Op::sign:
      break;
  }
}

}  // namespace

OperationCount count_operations(const Function& function) {
  const std::vector<bool> alive = reachable_from(function.graph, roots(function));
  OperationCount count;
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    if (alive[static_cast<std::size_t>(id)]) add_node(function.graph[id], count);
  }
  return count;
}

int count_written_entries(const Function& function) {
  int entries = 0;
  for (const Output& output : function.outputs) {
    for (std::size_t e = 0; e < output.entries.size(); ++e) entries += output.leaves_out(e) ? 0 : 1;
  }
  return entries;
}

int count_written_zeros(const Function& function) {
  int zeros = 0;
  for (const Output& output : function.outputs) {
    for (std::size_t e = 0; e < output.entries.size(); ++e) {
      zeros += function.graph.is_zero(output.entries[e]) && !output.leaves_out(e) ? 1 : 0;
    }
  }
  return zeros;
}

std::string to_string(const OperationCount& count) {
  std::string text = fmt::format("{} mul, {} add", count.multiplications, count.additions);
  if (count.fused > 0) text += fmt::format(", {} fma", count.fused);
  if (count.divisions > 0) text += fmt::format(", {} div", count.divisions);
  if (count.trigonometric > 0) text += fmt::format(", {} sin/cos", count.trigonometric);
  return text;
}

}  // namespace flatdyn

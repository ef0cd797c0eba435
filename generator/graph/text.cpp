// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace flatdyn {
namespace {

std::string node_name(NodeId id) { return fmt::format("%{}", id); }

std::string signed_term(const Rational& coefficient, const std::string& operand, bool is_first) {
  const Rational size = coefficient < 0 ? Rational(-coefficient) : coefficient;
  std::string text = coefficient < 0 ? "-" : is_first ? "" : "+";
  if (!is_first) text = " " + text + " ";
  if (operand.empty()) return text + size.str();
  return text + (size == 1 ? "" : size.str() + " ") + operand;
}

std::string sum_text(const Node& node) {
  std::string text;
  for (const Term& term : node.terms) text += signed_term(term.coefficient, node_name(term.node), text.empty());
  if (!node.value.is_zero()) text += signed_term(node.value, "", text.empty());
  return text;
}

std::string product_text(const Node& node) {
  std::vector<std::string> factors;
  for (const NodeId operand : node.operands) factors.push_back(node_name(operand));
  return fmt::format("{}", fmt::join(factors, " * "));
}

std::string operation_text(const Node& node) {
  switch (node.op) {
    case Op::constant:
      return node.value.str();
    case Op::input:
      return fmt::format("{}[{}]", argument_row(node.input.kind).name, node.input.index);
    case Op::sum:
      return sum_text(node);
    case Op::product:
      return product_text(node);
    case Op::quotient:
      return node_name(node.operands[0]) + " / " + node_name(node.operands[1]);
    case Op::sin:
      return "sin " + node_name(node.operands[0]);
    case Op::cos:
      return "cos " + node_name(node.operands[0]);
    case Op::sign:
      return "sign " + node_name(node.operands[0]);
    case Op::sqrt:
      return "sqrt " + node_name(node.operands[0]);
    case Op::tanh:
      return "tanh " + node_name(node.operands[0]);
  }
  return "";
}

std::string with_comment(const std::string& line, const std::string& comment) {
  constexpr std::size_t kColumn = 40;
  if (comment.empty()) return line + "\n";
  return line + std::string(line.size() < kColumn ? kColumn - line.size() : 1, ' ') + "; " + comment + "\n";
}

const char* name_of_layout(Layout layout) {
  switch (layout) {
    case Layout::scalar:
      return "scalar";
    case Layout::vector:
      return "vector";
    case Layout::matrix:
      return "matrix";
    case Layout::fields:
      return "fields";
    case Layout::christoffel:
      return "christoffel";
  }
  return "";
}

const char* name_of_orientation(Orientation orientation) {
  switch (orientation) {
    case Orientation::angular_velocity:
      return "angular_velocity";
    case Orientation::zyz:
      return "zyz";
    case Orientation::rpy:
      return "rpy";
  }
  return "";
}

std::string heading(const Function& function) {
  std::string text = fmt::format("function {}\n", function.name);
  const auto line = [&text](const char* key, const std::string& value) {
    if (!value.empty()) text += fmt::format("  {}: {}\n", key, value);
  };
  std::vector<std::string> inputs;
  for (const InputKind kind : function.inputs) inputs.emplace_back(argument_row(kind).name);
  line("summary", function.summary);
  line("equation", function.equation);
  line("inputs", fmt::format("{}", fmt::join(inputs, " ")));
  line("base_parameters", function.base_parameters == 0 ? "" : std::to_string(function.base_parameters));
  line("own", function.own.length == 0 ? "" : fmt::format("{} {}", function.own.length, function.own.meaning));
  line("at_rest", function.at_rest ? "yes" : "");
  if (!function.task.empty()) {
    line("task", fmt::format("{} {} {}", name_of_orientation(function.task.orientation), function.task.damping.str(),
                             fmt::join(function.task.rows, " ")));
  }
  return text;
}

std::string output_text(const Output& output) {
  std::vector<std::string> entries;
  for (std::size_t k = 0; k < output.entries.size(); ++k) {
    entries.push_back(output.leaves_out(k) ? "-" : node_name(output.entries[k]));
  }
  const std::string line = fmt::format("  {} {} {} {}: {}", output.name, name_of_layout(output.layout), output.rows,
                                       output.cols, fmt::join(entries, " "));
  return with_comment(line, output.meaning);
}

std::string condition_text(const Function& function, std::size_t k) {
  std::string text = "  " + node_name(function.validity_conditions[k]);
  if (k < function.pivot_scales.size()) text += " pivot of " + node_name(function.pivot_scales[k]);
  const std::size_t loops = function.validity_conditions.size() - static_cast<std::size_t>(function.loop_conditions);
  if (k >= loops) text += " loop";
  return text + "\n";
}

}  // namespace

std::string to_text(const Function& function) {
  std::string text = heading(function) + "nodes:\n";
  for (NodeId id = 0; id < function.graph.size(); ++id) {
    const std::string* name = function.graph.name(id);
    const std::string line = fmt::format("  {} = {}", node_name(id), operation_text(function.graph[id]));
    text += with_comment(line, name == nullptr ? "" : *name);
  }
  text += "outputs:\n";
  for (const Output& output : function.outputs) text += output_text(output);
  if (!function.validity_conditions.empty()) text += "conditions:\n";
  for (std::size_t k = 0; k < function.validity_conditions.size(); ++k) text += condition_text(function, k);
  return text;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/planning/function_bytes.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

namespace flatdyn {

using nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Input, kind, index)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OwnArgument, length, meaning)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OperationCount, additions, multiplications, fused, divisions, trigonometric)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PassRecord, pass, before, after, round, seconds)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Output, name, layout, rows, cols, entries, meaning, left_out, quantity)

namespace {

// Numbers that fit into a word as such, others in digits.
json number_json(const Rational& value) {
  if (denominator(value) == 1 && value.bits() < 60) return std::stoll(value.str());
  return value.str();
}

Rational number_of(const json& value) {
  return value.is_number() ? Rational(value.get<std::int64_t>()) : Rational(value.get<std::string>());
}

// A node as an array: its operation, and what that uses.
json node_json(const Node& node) {
  json row = {node.op};
  if (node.op == Op::input) row.push_back(node.input);
  if (node.op == Op::constant || node.op == Op::sum) row.push_back(number_json(node.value));
  for (const Term& term : node.terms) {
    row.push_back(number_json(term.coefficient));
    row.push_back(term.node);
  }
  for (const NodeId operand : node.operands) row.push_back(operand);
  return row;
}

Node node_of(const json& row) {
  Node node;
  node.op = row.at(0).get<Op>();
  std::size_t next = 1;
  if (node.op == Op::input) node.input = row.at(next++).get<Input>();
  if (node.op == Op::constant || node.op == Op::sum) node.value = number_of(row.at(next++));
  while (next < row.size()) {
    if (node.op == Op::sum) {
      node.terms.push_back({number_of(row.at(next)), row.at(next + 1).get<NodeId>()});
      next += 2;
    } else {
      node.operands.push_back(row.at(next++).get<NodeId>());
    }
  }
  return node;
}

json graph_json(const Graph& graph) {
  json nodes = json::array(), names = json::array();
  for (NodeId id = 0; id < graph.size(); ++id) {
    nodes.push_back(node_json(graph[id]));
    if (const std::string* name = graph.name(id)) names.push_back({id, *name});
  }
  return {{"nodes", nodes}, {"names", names}};
}

Graph graph_of(const json& value) {
  Graph graph;
  std::vector<NodeId> same;
  for (const json& row : value.at("nodes")) {
    same.push_back(graph.copy(node_of(row), same));
    if (same.back() != graph.size() - 1) throw std::runtime_error("a node that is there twice");
  }
  for (const json& row : value.at("names")) graph.set_name(row.at(0).get<NodeId>(), row.at(1).get<std::string>());
  return graph;
}

json task_json(const Task& task) {
  return {{"rows", task.rows}, {"orientation", task.orientation}, {"damping", number_json(task.damping)}};
}

Task task_of(const json& value) {
  return {value.at("rows").get<std::vector<int>>(), value.at("orientation").get<Orientation>(),
          number_of(value.at("damping"))};
}

json function_json(const Function& function) {
  return {{"name", function.name},
          {"summary", function.summary},
          {"equation", function.equation},
          {"formulation", function.formulation},
          {"inputs", function.inputs},
          {"base_parameters", function.base_parameters},
          {"own", function.own},
          {"at_rest", function.at_rest},
          {"task", task_json(function.task)},
          {"graph", graph_json(function.graph)},
          {"outputs", function.outputs},
          {"validity_conditions", function.validity_conditions},
          {"pivot_scales", function.pivot_scales},
          {"proven_pivot_share", function.proven_pivot_share},
          {"loop_conditions", function.loop_conditions},
          {"inverted", function.inverted}};
}

Function function_of(const json& value) {
  Function function;
  value.at("name").get_to(function.name);
  value.at("summary").get_to(function.summary);
  value.at("equation").get_to(function.equation);
  value.at("formulation").get_to(function.formulation);
  value.at("inputs").get_to(function.inputs);
  value.at("base_parameters").get_to(function.base_parameters);
  value.at("own").get_to(function.own);
  value.at("at_rest").get_to(function.at_rest);
  function.task = task_of(value.at("task"));
  function.graph = graph_of(value.at("graph"));
  value.at("outputs").get_to(function.outputs);
  value.at("validity_conditions").get_to(function.validity_conditions);
  value.at("pivot_scales").get_to(function.pivot_scales);
  value.at("proven_pivot_share").get_to(function.proven_pivot_share);
  value.at("loop_conditions").get_to(function.loop_conditions);
  value.at("inverted").get_to(function.inverted);
  return function;
}

}  // namespace

std::string to_bytes(const OptimisedFunction& made) {
  const json value = {
      {"function", function_json(made.function)}, {"derived", function_json(made.derived)}, {"passes", made.passes}};
  std::string bytes;
  json::to_cbor(value, bytes);
  return bytes;
}

OptimisedFunction from_bytes(const std::string& bytes) {
  const json value = json::from_cbor(bytes);
  OptimisedFunction made;
  made.function = function_of(value.at("function"));
  made.derived = function_of(value.at("derived"));
  value.at("passes").get_to(made.passes);
  return made;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/names.hpp"

#include <algorithm>
#include <map>

#include "code/lower/arguments.hpp"
#include "robot/model/identifiers.hpp"

namespace flatdyn {

namespace {

// The name of c_ijk in row i and packed column k (k + 1) / 2 + j: "c_3_1_2".
std::string name_of_christoffel(const Output& output, int entry) {
  int k = 0, j = entry % output.cols;
  while (j > k) j -= ++k;
  return output.name + "_" + std::to_string(entry / output.cols + 1) + "_" + std::to_string(j + 1) + "_" +
         std::to_string(k + 1);
}

// The name of the entry that a node is stored in, counted from 1: "tau_1", "B_12".
std::string name_of_entry(const Output& output, int entry) {
  if (output.layout == Layout::scalar) return output.name;
  if (output.layout == Layout::fields) return "";
  if (output.layout == Layout::christoffel) return name_of_christoffel(output, entry);
  if (output.layout == Layout::vector || output.cols == 0) return output.name + "_" + std::to_string(entry + 1);
  const std::string separator = output.rows > 9 || output.cols > 9 ? "_" : "";
  return output.name + "_" + std::to_string(entry / output.cols + 1) + separator +
         std::to_string(entry % output.cols + 1);
}

// By id: the names of nodes that are stored in outputs.
std::map<NodeId, std::string> names_of_entries(const Function& function) {
  std::map<NodeId, std::string> names;
  for (const Output& output : function.outputs) {
    for (std::size_t e = 0; e < output.entries.size(); ++e) {
      names.emplace(output.entries[e], name_of_entry(output, static_cast<int>(e)));
    }
  }
  return names;
}

std::string wanted_name(const Graph& graph, NodeId id, const std::map<NodeId, std::string>& entries) {
  if (const std::string* given = graph.name(id)) return *given;
  const Node& node = graph[id];
  if (is_of_computed_angle(graph, id)) {
    const std::string* angle = graph.name(node.operands[0]);
    return angle == nullptr ? "" : (node.op == Op::sin ? "sin_" : "cos_") + *angle;
  }
  if (node.op == Op::sin || node.op == Op::cos) {
    return (node.op == Op::sin ? "s_" : "c_") + std::to_string(graph[angle_of(graph, id).node].input.index + 1);
  }
  const auto entry = entries.find(id);
  return entry == entries.end() ? "" : entry->second;
}

}  // namespace

std::string NameTable::unique(const std::string& wanted) {
  const std::string valid = cpp_identifier(wanted);
  std::string name = valid;
  const std::string separator = valid.back() == '_' ? "" : "_";  // two underscores in a row are reserved
  for (int k = 2; !taken_.insert(name).second; ++k) name = valid + separator + std::to_string(k);
  return name;
}

std::string NameTable::temporary() {
  std::string name;
  do {
    name = "t" + std::to_string(++temporaries_);
  } while (!taken_.insert(name).second);
  return name;
}

VariableNames name_variables(const Function& function, const Schedule& schedule,
                             const std::vector<std::string>& parameters, const std::vector<std::string>& stored,
                             NameTable& names) {
  const Graph& graph = function.graph;
  VariableNames result(schedule.is_variable.size());
  for (NodeId id = 0; id < graph.size(); ++id) {
    const auto k = static_cast<std::size_t>(id);
    if (!schedule.is_variable[k] || graph[id].op != Op::input) continue;
    const Input& input = graph[id].input;
    result[k] = input.kind == InputKind::stored ? stored.at(static_cast<std::size_t>(input.index))
                                                : names.unique(variable_of_input(input, parameters));
  }
  const std::map<NodeId, std::string> entries = names_of_entries(function);
  for (const Statement& statement : schedule.statements) {
    if (!statement.targets.empty()) continue;
    const std::string wanted = wanted_name(graph, statement.node, entries);
    result[static_cast<std::size_t>(statement.node)] = wanted.empty() ? names.temporary() : names.unique(wanted);
  }
  return result;
}

}  // namespace flatdyn

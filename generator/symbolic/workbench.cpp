// SPDX-License-Identifier: GPL-2.0-or-later
#include "symbolic/workbench.hpp"

#include <utility>

namespace flatdyn {

std::vector<GiNaC::symbol> Workbench::parameters(const Mechanism& mechanism) {
  std::vector<GiNaC::symbol> result;
  for (const FreeSymbol& symbol : mechanism.symbols) result.push_back(symbol.symbol);
  return result;
}

std::vector<NodeId> Workbench::nodes(const std::vector<Number>& values) {
  std::vector<NodeId> result;
  for (const Number& value : values) result.push_back(node(value));
  return result;
}

std::vector<NodeId> Workbench::nodes(const std::vector<std::vector<Number>>& rows) {
  std::vector<NodeId> result;
  for (const std::vector<Number>& row : rows) {
    for (const Number& value : row) result.push_back(node(value));
  }
  return result;
}

Output vector_output(const std::string& name, std::vector<NodeId> entries, const std::string& meaning) {
  const int rows = static_cast<int>(entries.size());
  return {name, Layout::vector, rows, 1, std::move(entries), meaning};
}

Output matrix_output(const std::string& name, int rows, int cols, std::vector<NodeId> entries,
                     const std::string& meaning) {
  return {name, Layout::matrix, rows, cols, std::move(entries), meaning};
}

Output scalar_output(const std::string& name, NodeId entry, const std::string& meaning) {
  return {name, Layout::scalar, 1, 1, {entry}, meaning};
}

Function finished(Derivation& derivation, std::vector<InputKind> inputs, std::vector<Output> outputs,
                  std::vector<NodeId> positive) {
  Function function;
  function.inputs = std::move(inputs);
  function.graph = std::move(derivation.graph());
  function.outputs = std::move(outputs);
  function.positive = std::move(positive);
  return function;
}

}  // namespace flatdyn

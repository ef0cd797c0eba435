// SPDX-License-Identifier: GPL-2.0-or-later
#include "verify/eval.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "emit/arguments.hpp"
#include "verify/values.hpp"

namespace flatdyn {
namespace {

// Where each input is found: a column, or nowhere.
class Columns {
 public:
  Columns(const Mechanism& mechanism, const CsvTable& table) : mechanism_(mechanism) {
    for (std::size_t k = 0; k < table.columns.size(); ++k) index_[table.columns[k]] = k;
  }

  std::vector<std::string> names_of(const Input& input) const {
    const auto k = static_cast<std::size_t>(input.index);
    if (input.kind == InputKind::parameter) return {mechanism_.symbols[k].name};
    const std::string stem = input_argument(input.kind, mechanism_.size()).name;
    std::vector<std::string> names = {stem + std::to_string(input.index + 1)};
    if (input.kind != InputKind::h_e) names.push_back(stem + "_" + mechanism_.bodies[k].joint);
    return names;
  }

  std::optional<std::size_t> find(const Input& input) const {
    for (const std::string& name : names_of(input)) {
      const auto found = index_.find(name);
      if (found != index_.end()) return found->second;
    }
    return std::nullopt;
  }

 private:
  const Mechanism& mechanism_;
  std::map<std::string, std::size_t> index_;
};

std::vector<std::string> output_columns(const Output& output) {
  if (output.layout == Layout::scalar) return {output.name};
  std::vector<std::string> names;
  for (int i = 1; i <= output.rows; ++i) {
    if (output.layout == Layout::vector) {
      names.push_back(fmt::format("{}_{}", output.name, i));
    } else if (output.layout == Layout::matrix) {
      for (int j = 1; j <= output.cols; ++j) names.push_back(fmt::format("{}_{}_{}", output.name, i, j));
    } else {
      for (int k = 1; k <= output.rows; ++k) {
        for (int j = 1; j <= k; ++j) names.push_back(fmt::format("{}_{}_{}_{}", output.name, i, j, k));
      }
    }
  }
  return names;
}

// All inputs that a function is documented to take: the reference reads them even where the graph does not.
std::vector<Input> inputs_of(const Mechanism& mechanism, const Function& function, bool all) {
  if (!all) return inputs_read(function);
  std::vector<Input> inputs;
  for (const InputKind kind : function.inputs) {
    const int length = input_argument(kind, mechanism.size()).length;
    for (int i = 0; i < length; ++i) inputs.push_back({kind, i});
  }
  for (std::size_t k = 0; k < mechanism.symbols.size(); ++k) inputs.push_back({InputKind::parameter, static_cast<int>(k)});
  return inputs;
}

using Row = std::map<std::pair<InputKind, int>, Number>;

template <class S>
std::vector<S> from_graph(const Function& function, const Row& row) {
  RealArithmetic<S> arithmetic([&row](const Input& input) { return to_scalar<S>(row.at({input.kind, input.index}), {}); });
  const std::vector<S> all = evaluate(function, arithmetic);
  std::vector<S> result;
  for (const Output& output : function.outputs) {
    for (const NodeId id : output.entries) result.push_back(all[static_cast<std::size_t>(id)]);
  }
  return result;
}

}  // namespace

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "verify/eval.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "emit/arguments.hpp"
#include "graph/arithmetic.hpp"
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
  for (std::size_t k = 0; k < mechanism.symbols.size(); ++k)
    inputs.push_back({InputKind::parameter, static_cast<int>(k)});
  return inputs;
}

using Row = std::map<std::pair<InputKind, int>, Number>;

template <class S>
std::vector<S> from_graph(const Function& function, const Row& row) {
  RealArithmetic<S> arithmetic([&row](const Input& input) {
    return to_scalar<S>(row.at({input.kind, input.index}), {});
  });
  const std::vector<S> all = evaluate(function, arithmetic);
  std::vector<S> result;
  for (const Output& output : function.outputs) {
    for (const NodeId id : output.entries) result.push_back(all[static_cast<std::size_t>(id)]);
  }
  return result;
}

// One line of the table as exact numbers; inputs without a column are 0 (they are not read).
Row row_of(const Columns& columns, const std::vector<Input>& inputs, const std::vector<std::string>& entries) {
  Row row;
  for (const Input& input : inputs) {
    const auto column = columns.find(input);
    row[{input.kind, input.index}] = column ? exact_decimal(entries[*column]) : Number(0);
  }
  return row;
}

std::vector<double> doubles_of(const Row& row, InputKind kind, std::size_t length) {
  std::vector<double> values(length, 0.0);
  for (std::size_t i = 0; i < length; ++i) {
    const auto found = row.find({kind, static_cast<int>(i)});
    if (found != row.end()) values[i] = to_scalar<double>(found->second, {});
  }
  return values;
}

template <class S>
std::vector<S> from_reference(const Robot& robot, const Mechanism& mechanism, const Function& function,
                              const Row& row) {
  SymbolValues values;
  for (std::size_t k = 0; k < mechanism.symbols.size(); ++k)
    values.push_back(row.at({InputKind::parameter, static_cast<int>(k)}));
  const auto n = static_cast<std::size_t>(mechanism.size());
  const State state{doubles_of(row, InputKind::q, n),   doubles_of(row, InputKind::qd, n),
                    doubles_of(row, InputKind::qdd, n), doubles_of(row, InputKind::tau, n),
                    doubles_of(row, InputKind::h_e, 6), {}};
  const auto result = reference_values<S>(function, reference_robot<S>(robot, values), state);
  if (!result) throw Failure(ExitCode::usage, "the reference does not know function \"" + function.name + "\"");
  return *result;
}

std::string text_of(double value, int) { return fmt::format("{}", value); }
std::string text_of(const Real50& value, int digits) { return value.str(digits); }

template <class S>
std::vector<std::string> evaluated(const Robot& robot, const Mechanism& mechanism, const Function& function,
                                   const Row& row, const EvalOptions& options) {
  const std::vector<S> values =
      options.reference ? from_reference<S>(robot, mechanism, function, row) : from_graph<S>(function, row);
  std::vector<std::string> texts;
  for (const S& value : values) texts.push_back(text_of(value, options.digits));
  return texts;
}

}  // namespace

CsvTable evaluate_table(const Robot& robot, const Mechanism& mechanism, const Function& function,
                        const CsvTable& states, const std::string& file, const EvalOptions& options,
                        Diagnostics& diagnostics) {
  const Columns columns(mechanism, states);
  const std::vector<Input> inputs = inputs_of(mechanism, function, options.reference);
  for (const Input& input : inputs) {
    if (!columns.find(input)) {
      diagnostics.error({file, 1}, fmt::format("column {} is missing; {} reads it",
                                               fmt::join(columns.names_of(input), " or "), function.name));
    }
  }
  if (diagnostics.has_errors()) return {};
  CsvTable result = states;
  for (const Output& output : function.outputs) {
    for (const std::string& name : output_columns(output)) result.columns.push_back(name);
  }
  constexpr int kDoubleDigits = 17;
  for (std::vector<std::string>& entries : result.rows) {
    const Row row = row_of(columns, inputs, entries);
    const std::vector<std::string> values = options.digits > kDoubleDigits
                                                ? evaluated<Real50>(robot, mechanism, function, row, options)
                                                : evaluated<double>(robot, mechanism, function, row, options);
    entries.insert(entries.end(), values.begin(), values.end());
  }
  return result;
}

std::string to_text(const CsvTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
  for (const auto& row : table.rows) text += fmt::format("{}\n", fmt::join(row, ","));
  return text;
}

}  // namespace flatdyn

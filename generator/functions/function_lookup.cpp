// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/diagnostics.hpp"
#include "functions/derivative_names.hpp"
#include "functions/derivative_rows.hpp"
#include "functions/function_table.hpp"
#include "graph/function_name.hpp"

namespace flatdyn {

std::vector<InputKind> FunctionRow::inputs_for(const Mechanism& mechanism) const {
  std::vector<InputKind> result;
  for (const InputKind kind : inputs) {
    if (kind == InputKind::g_b && !mechanism.has_base_gravity()) continue;
    result.push_back(with_base(kind, mechanism.has_quasi_velocities()));
  }
  return result;
}

std::vector<OutputRow> FunctionRow::outputs_for(const Mechanism& mechanism) const {
  std::vector<OutputRow> result;
  for (const OutputRow& output : outputs) {
    const bool is_there = mechanism.floating_base || !output.of_floating_base,
               has_entries = output.rows != Extent::positions || mechanism.position_count() > 0;
    if (is_there && has_entries) result.push_back(output);
  }
  return result;
}

const FunctionRow* find_row(const std::string& name) {
  const std::vector<FunctionRow>& rows = function_table();
  static const DerivativeRows derivatives(rows);
  const FunctionName parts = parts_of_name(name);
  if (parts.derivative != Derivative::none) return derivatives.find(parts.derivative, parts.stem);
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&parts](const FunctionRow& row) { return parts.stem == row.name; });
  return found == rows.end() ? nullptr : &*found;
}

bool has_derivatives(const std::string& function) {
  return find_row(prefix_of(Derivative::jacobian) + ":" + function) != nullptr || find_row(function) == nullptr;
}

std::string functions_of_links() {
  std::vector<std::string> names;
  for (const FunctionRow& row : function_table()) {
    if (row.derivation.of_link != nullptr) names.emplace_back(row.name);
  }
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("{} and {}", fmt::join(names, ", "), last);
}

const FunctionRow& row_of(const Function& function) {
  const FunctionRow* row = find_row(function.name);
  if (row == nullptr) throw Failure(FailureKind::bug, "no row for function \"" + function.name + "\"");
  return *row;
}

}  // namespace flatdyn

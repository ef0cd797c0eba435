// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/checks.hpp"

namespace flatdyn {
namespace {

// Checks the entries that are written, run by run.
void add_finite(const Function& function, const std::vector<std::string>& outputs, code::Statements& statements) {
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    const Output& output = function.outputs[k];
    for (std::size_t first = 0, end = 0; first < output.entries.size(); first = end + 1) {
      end = first;
      while (end < output.entries.size() && !output.leaves_out(end)) ++end;
      if (end > first + 1) statements.emplace_back(code::CheckFinite{outputs[k], first, end});
      if (end != first + 1) continue;
      statements.emplace_back(code::Check{false, code::Finite{{outputs[k], static_cast<int>(first)}}});
    }
  }
}

}  // namespace

std::vector<CheckedPivot> pivots_to_check(const Function& function) {
  std::vector<CheckedPivot> pivots;
  for (std::size_t k = 0; k < function.validity_conditions.size(); ++k) {
    if (always_holds(function, k)) continue;
    pivots.push_back({function.validity_conditions[k], {}});
    if (has_scale(function, k)) pivots.back().scale = function.pivot_scales[k];
  }
  return pivots;
}

code::Expression checked(const CheckedPivot& pivot, const NodeExpressions& expressions) {
  code::Expression value = expressions.use(pivot.value);
  if (!pivot.scale) return value;
  code::Expression scale = expressions.use(*pivot.scale);
  code::Addend share = code::without_sign(std::move(value));
  share.value = code::Product{{code::Literal{kPivotSignificance}, std::move(share.value)}};
  code::Sum sum{{code::without_sign(scale), std::move(share)}};
  return code::Call{code::Operation::excess, {std::move(sum), std::move(scale)}};
}

code::Statements checks_of(const Function& function, const std::vector<std::string>& outputs,
                           const NodeExpressions& expressions) {
  code::Statements statements;
  for (const CheckedPivot& pivot : pivots_to_check(function)) {
    statements.emplace_back(code::Check{statements.empty(), code::Positive{checked(pivot, expressions)}});
  }
  if (statements.empty()) statements.emplace_back(code::Check{true, code::Always{}});
  add_finite(function, outputs, statements);
  statements.emplace_back(code::Return{});
  return statements;
}

code::Statements checks_of_parts(const Function& function, const std::vector<std::string>& outputs,
                                 const std::string& pivots, std::size_t length) {
  code::Statements statements = {code::Check{true, code::Always{}}, code::CheckPositive{pivots, length}};
  add_finite(function, outputs, statements);
  statements.emplace_back(code::Return{});
  return statements;
}

}  // namespace flatdyn

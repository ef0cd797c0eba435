// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/validity.hpp"

#include <fmt/format.h>

#include "emit/writer.hpp"

namespace flatdyn {

std::vector<CheckedPivot> pivots_to_check(const Function& function) {
  std::vector<CheckedPivot> pivots;
  for (std::size_t k = 0; k < function.validity_conditions.size(); ++k) {
    if (always_holds(function, k)) continue;
    pivots.push_back({function.validity_conditions[k], {}});
    if (has_scale(function, k)) pivots.back().scale = function.pivot_scales[k];
  }
  return pivots;
}

std::string ValidityText::checked(const CheckedPivot& pivot) const {
  const std::string value = printer_.use(pivot.value);
  if (!pivot.scale) return value;
  const auto unsigned_text = [](const std::string& text) { return text[0] == '-' ? text.substr(1) : text; };
  const std::string scale = printer_.use(*pivot.scale);
  const std::string sum = fmt::format("{} {} {} * {}", scale, value[0] == '-' ? '-' : '+',
                                      dialect_.literal(kPivotSignificance), unsigned_text(value));
  return dialect_.excess(sum, scale);
}

std::string ValidityText::statements(const Function& function, const std::vector<std::string>& output_names) const {
  std::string text;
  for (const CheckedPivot& pivot : pivots_to_check(function)) {
    const std::string check = fmt::format("{} > {}", checked(pivot), dialect_.literal(0));
    text +=
        text.empty() ? defined_as(check) : code_line(dialect_.conditions_continue() + check + ";", kStatementIndent);
  }
  if (text.empty()) text = defined_as(dialect_.always());
  return text + finite(function, output_names);
}

std::string ValidityText::statements_of_parts(const Function& function, const std::vector<std::string>& output_names,
                                              const std::string& pivots, std::size_t length) const {
  return defined_as(dialect_.always()) + dialect_.all_positive(pivots, length) + finite(function, output_names);
}

std::string ValidityText::defined_as(const std::string& first) const {
  return code_line(dialect_.conditions_begin() + first + ";", kStatementIndent);
}

// Checks the entries that are written, run by run.
std::string ValidityText::finite(const Function& function, const std::vector<std::string>& output_names) const {
  std::string text;
  for (std::size_t k = 0; k < function.outputs.size(); ++k) {
    const Output& output = function.outputs[k];
    for (std::size_t first = 0, end = 0; first < output.entries.size(); first = end + 1) {
      end = first;
      while (end < output.entries.size() && !output.leaves_out(end)) ++end;
      if (end > first) text += finite_run(output_names[k], first, end);
    }
  }
  return text + code_line(fmt::format("return {};", kValid), kStatementIndent);
}

// Zero times x is zero if x is finite, and else not a number, which compares false.
std::string ValidityText::finite_run(const std::string& output, std::size_t first, std::size_t end) const {
  const bool is_single = end == first + 1;
  const std::string entry = is_single ? std::to_string(first) : kCounter;
  const std::string check = fmt::format("{} * {}[{}] < {}", dialect_.literal(0), output, entry, dialect_.literal(1));
  if (is_single) return code_line(dialect_.conditions_continue() + check + ";", kStatementIndent);
  return dialect_.check_loop(first, end, check);
}

}  // namespace flatdyn

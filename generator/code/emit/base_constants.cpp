// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/base_constants.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "code/emit/joints.hpp"
#include "code/emit/writer.hpp"
#include "derivation/notation/combination_text.hpp"
#include "functions/function_table.hpp"

namespace flatdyn {
namespace {

std::string meaning(const Mechanism& mechanism, ParameterFrames frames) {
  const std::string text =
      "Base parameters pi_b: the fewest that the torques depend on, as combinations of parameters in ";
  const char* const names =
      " Each pi_b has the name of the parameter in canonical frames that it keeps (flatdyn inspect --base-parameters "
      "--frames "
      "canonical).";
  return text + frames_text(mechanism, frames) + "." + (has_names_of_file(mechanism, frames) ? names : "") +
         " Numbers here are rounded.";
}

std::vector<std::string> comment_of(const Mechanism& mechanism, const BaseParameters& base, ParameterFrames frames) {
  std::vector<std::string> lines = wrapped_words(meaning(mechanism, frames), kCommentWidth);
  const Combinations combinations(mechanism, base, frames);
  for (int k = 0; k < base.size(); ++k) {
    const std::string text = fmt::format("pi_b[{}] = {}", k, combinations.text(k));
    for (const std::string& line : wrapped_words(comment_text(text), kCommentWidth - 4)) {
      const bool begins = line.rfind("pi_b[", 0) == 0;
      lines.push_back((begins ? "  " : "      ") + line);
    }
  }
  return lines;
}

}  // namespace

bool uses_base_parameters(const Function& function) {
  const FunctionRow* row = find_row(function.name);
  return function.base_parameters > 0 || (row != nullptr && row->traits.uses_base_parameters);
}

BaseConstants base_constants(const Mechanism& mechanism, const std::vector<std::string>& names,
                             ParameterFrames frames) {
  const BaseParameters base = base_parameters(mechanism);
  BaseConstants constants{comment_of(mechanism, base, frames), base.size(), {}};
  if (base.size() == 0) return constants;
  std::vector<code::TableEntry> kept, values;
  for (const int index : base.columns) kept.emplace_back(parameter_name(index, mechanism.base_bodies()));
  for (const Number& value : base_values(mechanism, base)) {
    if (const auto rational = rational_of(value)) values.emplace_back(*rational);
  }
  const bool all_known = values.size() == kept.size();
  constants.tables.push_back({code::Table::Type::text, names[1], names[0], std::move(kept)});
  if (all_known) constants.tables.push_back({code::Table::Type::real, names[2], names[0], std::move(values)});
  return constants;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/base_constants.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "emit/joints.hpp"
#include "emit/writer.hpp"
#include "functions/function_table.hpp"
#include "symbolic/notation/combination_text.hpp"

namespace flatdyn {
namespace {

constexpr const char* kMeaning =
    "Base parameters pi_b: the fewest that the torques depend on. Link 1 is moved by the first joint, and so on; m2 is "
    "its mass, m2lx its first moment, I2xx its inertia, all of the link with the motors that it carries, about the "
    "origin of its frame, which flatdyn inspect describes (z on the joint's axis); Im2 is the rotor inertia, Fv2 and "
    "Fs2 are the friction of the second joint. Numbers here are rounded.";

std::vector<std::string> comment_of(const BaseParameters& base) {
  std::vector<std::string> lines = wrapped_words(kMeaning, kCommentWidth);
  for (int k = 0; k < base.size(); ++k) {
    const std::string text = fmt::format("pi_b[{}] = {}", k, combination_text(base, k));
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
                             const Dialect& dialect) {
  const BaseParameters base = base_parameters(mechanism);
  BaseConstants constants{comment_of(base), base.size(), {}};
  if (base.size() == 0) return constants;
  std::vector<std::string> kept, values;
  for (const int index : base.columns) kept.push_back(dialect.text(parameter_name(index)));
  for (const Number& value : base_values(mechanism, base)) {
    if (const auto rational = rational_of(value)) values.push_back(dialect.real_literal(*rational));
  }
  const bool all_known = values.size() == kept.size();
  constants.arrays.push_back({"const char*", names[1], names[0], std::move(kept)});
  if (all_known) constants.arrays.push_back({kReal, names[2], names[0], std::move(values)});
  return constants;
}

}  // namespace flatdyn

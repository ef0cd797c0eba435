// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/arguments.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace flatdyn {

namespace {

int length_of(ArgumentLength length, const JointCounts& counts, int base_parameters) {
  switch (length) {
    case ArgumentLength::positions:
      return counts.positions;
    case ArgumentLength::velocities:
      return counts.joints;
    case ArgumentLength::wrench:
      return kWrenchLength;
    case ArgumentLength::vector:
      return kVectorLength;
    case ArgumentLength::base_parameters:
      return base_parameters;
    case ArgumentLength::symbols:
    case ArgumentLength::none:
      break;
  }
  throw std::logic_error("parameters and stored values are no array arguments");
}

}  // namespace

InputArgument input_argument(InputKind kind, JointCounts counts, int base_parameters) {
  const ArgumentRow& row = argument_row(kind);
  const bool has_another = counts.has_base() && row.meaning_with_base != nullptr;
  std::string meaning = has_another ? row.meaning_with_base : row.meaning;
  if (counts.spherical) meaning += row.of_spherical_joints;
  return {row.name, length_of(row.length, counts, base_parameters), std::move(meaning)};
}

InputArgument input_argument(InputKind kind, JointCounts counts, const Function& function) {
  InputArgument argument = input_argument(kind, counts, function.base_parameters);
  const std::size_t colon = function.name.find(':');
  if (colon == std::string::npos) return argument;
  const std::string tip = "the tip";
  if (const std::size_t at = argument.meaning.find(tip); at != std::string::npos) {
    argument.meaning.replace(at, tip.size(), fmt::format("link \"{}\"", function.name.substr(colon + 1)));
  }
  return argument;
}

std::string variable_of_input(const Input& input, const std::vector<std::string>& parameters) {
  if (input.kind == InputKind::parameter) return parameters.at(static_cast<std::size_t>(input.index));
  return fmt::format("{}_{}", input_argument(input.kind, 0).name, input.index + 1);
}

bool returns_value(const Function& function) {
  return function.validity_conditions.empty() && function.outputs.size() == 1 &&
         function.outputs[0].layout == Layout::scalar;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/arguments.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "graph/function_name.hpp"

namespace flatdyn {

namespace {

// `own`: the length of an argument whose length depends on the function.
int length_of(ArgumentLength length, const JointCounts& counts, int own) {
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
    case ArgumentLength::own:
      return own;
    case ArgumentLength::one:
      return 1;
    case ArgumentLength::symbols:
    case ArgumentLength::none:
      break;
  }
  throw std::logic_error("parameters and stored values are no array arguments");
}

}  // namespace

InputArgument input_argument(InputKind kind, JointCounts counts, int own) {
  const ArgumentRow& row = argument_row(kind);
  const bool has_another = counts.has_base() && row.meaning_with_base != nullptr;
  std::string meaning = has_another ? row.meaning_with_base : row.meaning;
  if (counts.spherical) meaning += row.of_spherical_joints;
  return {row.name, length_of(row.length, counts, own), std::move(meaning)};
}

InputArgument input_argument(InputKind kind, JointCounts counts, const Function& function) {
  const ArgumentLength length = argument_row(kind).length;
  InputArgument argument = input_argument(kind, counts, own_length(function, length));
  if (length == ArgumentLength::own) argument.meaning = function.own.meaning;
  const std::optional<std::string> link = parts_of_name(function.name).link;
  if (!link) return argument;
  const std::string tip = "the tip";
  if (const std::size_t at = argument.meaning.find(tip); at != std::string::npos) {
    argument.meaning.replace(at, tip.size(), fmt::format("link \"{}\"", *link));
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

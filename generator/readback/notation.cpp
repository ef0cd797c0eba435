// SPDX-License-Identifier: GPL-2.0-or-later
#include "readback/notation.hpp"

#include <charconv>

#include "readback/scan.hpp"

namespace flatdyn {
namespace {

bool is_cpp_scalar(const std::string& scalar) { return scalar == "Scalar"; }
constexpr const char* kLanesOf = "lanes ";

bool is_lanes_scalar(const std::string& scalar) { return scalar.starts_with(kLanesOf); }
bool is_javascript_scalar(const std::string& scalar) { return scalar == "number"; }

}  // namespace

EmittedNotation notation_of(const std::string& scalar) {
  EmittedNotation notation;
  notation.scalar = scalar;
  notation.constants = "double";
  if (is_cpp_scalar(scalar)) {
    notation.is_cpp = true;
  } else if (is_javascript_scalar(scalar)) {
    notation.condition = notation.counter = "let";
    notation.and_also = "&&=";
    notation.names_types = false;
    notation.has_math_object = true;
  } else {
    notation.has_lanes = is_lanes_scalar(scalar);
    notation.constants = notation.has_lanes ? scalar.substr(std::string(kLanesOf).size()) : scalar;
    notation.has_c_functions = true;
  }
  return notation;
}

void name_lanes(const std::string& type, EmittedNotation& notation) {
  notation.scalar = type;
  notation.condition = notation.verdict = type + "_mask";
}

void note_count(const std::string& name, const std::string& value, ScannedText& found) {
  int number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error != std::errc() || end != value.data() + value.size()) return;
  for (const auto& [kind, in_c] :
       {std::pair("joint_count", "_JOINT_COUNT"), std::pair("position_count", "_POSITION_COUNT"),
        std::pair("angle_count", "_ANGLE_COUNT"), std::pair("velocity_count", "_VELOCITY_COUNT")}) {
    if (name == kind || name.ends_with(in_c)) found.counts[kind] = {name, number};
  }
}

ScannedText scan(const std::vector<Token>& tokens, const std::string& scalar) {
  if (is_cpp_scalar(scalar)) return scan_cpp(tokens);
  if (is_javascript_scalar(scalar)) return scan_javascript(tokens);
  return is_lanes_scalar(scalar) ? scan_c(tokens, scalar.substr(std::string(kLanesOf).size())) : scan_c(tokens, scalar);
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "readback/notation.hpp"

#include <charconv>

#include "readback/scan.hpp"

namespace flatdyn {
namespace {

bool is_cpp_scalar(const std::string& scalar) { return scalar == "Scalar"; }
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
    notation.constants = scalar;
    notation.has_c_functions = true;
  }
  return notation;
}

void note_count(const std::string& name, const std::string& value, ScannedText& found) {
  int number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error != std::errc() || end != value.data() + value.size()) return;
  for (const auto& [kind, in_c] :
       {std::pair("joint_count", "_JOINT_COUNT"), std::pair("position_count", "_POSITION_COUNT"),
        std::pair("angle_count", "_ANGLE_COUNT")}) {
    if (name == kind || name.ends_with(in_c)) found.counts[kind] = {name, number};
  }
}

ScannedText scan(const std::vector<Token>& tokens, const std::string& scalar) {
  if (is_cpp_scalar(scalar)) return scan_cpp(tokens);
  return is_javascript_scalar(scalar) ? scan_javascript(tokens) : scan_c(tokens, scalar);
}

}  // namespace flatdyn

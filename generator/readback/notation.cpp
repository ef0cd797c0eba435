// SPDX-License-Identifier: GPL-2.0-or-later
#include "readback/notation.hpp"

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
    notation.wraps_literals = true;
    notation.passes_by_name = false;
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

ScannedText scan(const std::vector<Token>& tokens, const std::string& scalar) {
  if (is_cpp_scalar(scalar)) return scan_cpp(tokens);
  return is_javascript_scalar(scalar) ? scan_javascript(tokens) : scan_c(tokens, scalar);
}

}  // namespace flatdyn

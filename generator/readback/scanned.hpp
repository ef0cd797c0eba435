// SPDX-License-Identifier: GPL-2.0-or-later
// What stands in emitted text outside of functions.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "readback/emitted_text.hpp"

namespace flatdyn {

struct Scanned {
  std::vector<WrittenFunction> functions;                  // the robot's, in their order
  std::map<std::string, WrittenFunction> parts;            // that only these call, by name
  std::map<std::string, std::vector<std::string>> fields;  // of structs, by name
};

// Whether a function of the text is none of the robot's own formulas: rounding_is_as_written, and close_loops, which
// calls the robot's in a loop.
inline bool is_no_formula(const std::string& name) {
  return name.ends_with("rounding_is_as_written") || name.ends_with("close_loops");
}

// Of a C header and its source. Throws Failure(bug) where the text is none of the emitter's.
Scanned scanned_c(const std::vector<Token>& tokens, const std::string& scalar);

// Of a JavaScript module. It says of no parameter whether it is an output, and of no function what it returns.
Scanned scanned_javascript(const std::vector<Token>& tokens);

}  // namespace flatdyn

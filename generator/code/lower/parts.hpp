// SPDX-License-Identifier: GPL-2.0-or-later
// Division of a function that is too long into a sequence of shorter ones. Compile time grows at least with the square
// of a function's length, and coding standards limit it. Values that one part makes and a later one needs are kept in
// an array, whose places are reused when the value is no longer needed.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "code/lower/scope.hpp"
#include "code/statement.hpp"

namespace flatdyn {

// The array of the values that parts keep.
inline constexpr const char* kKept = "kept";

struct LongBody {
  std::string name;                                 // the function's name
  code::Statements statements;                      // each defines one constant, or stores a value
  std::map<std::string, code::Expression> sources;  // by variable: from where every part can read it for itself
  std::vector<code::Argument> arguments;            // the arguments that parts may have, in order
  int most_lines = 0;  // limit of lines per part, including its first line and its closing brace
  const TextLength& length;
};

struct Parts {
  std::vector<code::Part> definitions;  // those that others call come before them
  code::Statements calls;               // by the function, in order
  int kept = 0;                         // length of the array of kept values, an argument of the parts
};

// Divides the body into parts with as many statements as fit, at least one. There are at most `most_calls` calls:
// further ones are gathered in functions that only call.
Parts in_parts(const LongBody& body, int most_calls);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Division of a function that is too long into a sequence of shorter ones. Compile time grows at least with the square
// of a function's length, and coding standards limit it. Values that one part makes and a later one needs are kept in
// an array, whose places are reused when the value is no longer needed.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "emit/expression.hpp"

namespace flatdyn {

// A statement that is not divided.
struct PartStep {
  std::string code;                    // indented lines; for a variable only its value: "c_2 * qd_1"
  std::optional<NodeId> makes;         // the variable
  std::vector<NodeId> needs;           // variables
  std::vector<std::string> arguments;  // names of the arguments that it reads or writes
};

struct PartArgument {
  std::string name;      // "q"
  std::string declared;  // "const Scalar* q"
  std::string passed;    // "q"
};

// A variable that every part can read for itself.
struct PartSource {
  std::string text;      // "sine[2]"
  std::string argument;  // "sine"
};

struct LongBody {
  std::string name;  // the function's name
  std::vector<PartStep> steps;
  const VariableNames& variables;
  std::map<NodeId, PartSource> sources;
  std::vector<PartArgument> arguments;  // the arguments that parts may have, in order
  int most_lines = 0;                   // limit of lines per part, including its first line and its closing brace
  const Dialect& dialect;
};

struct Parts {
  std::string definitions;         // function templates for namespace detail, or functions for the C file
  std::vector<std::string> calls;  // statements, in order
  int kept = 0;                    // length of the array "kept", an argument of the parts
};

// Divides the body into parts with as many steps as fit, at least one. There are at most `most_calls` calls: further
// ones are gathered in functions that only call.
Parts in_parts(const LongBody& body, int most_calls);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// A function that is too long, as a sequence of shorter ones. Compilers take time that grows with the square of a
// function's length and more, and coding standards limit it. Values that one part makes and a later one needs are kept
// in an array, whose places are used again once nobody needs the value.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "emit/expression.hpp"

namespace flatdyn {

// A statement that stays whole.
struct PartStep {
  std::string code;                    // indented lines; of a variable its value only: "c_2 * qd_1"
  std::optional<NodeId> makes;         // the variable
  std::vector<NodeId> needs;           // variables
  std::vector<std::string> arguments;  // names of those that it reads or writes
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
  std::string name;  // of the function
  std::vector<PartStep> steps;
  const VariableNames& variables;
  std::map<NodeId, PartSource> sources;
  std::vector<PartArgument> arguments;  // that parts may have, in their order
  int most_lines = 0;                   // of a part, from its first line to its closing brace
  Dialect dialect = {};
};

struct Parts {
  std::string definitions;         // function templates for namespace detail, or functions of the C file
  std::vector<std::string> calls;  // statements, in order
  int kept = 0;                    // length of the array "kept", an argument of the parts
};

// Parts with as many steps as there is room for, at least one. There are at most `most_calls` calls: more are gathered
// in functions that only call.
Parts in_parts(const LongBody& body, int most_calls);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// One Function → the text of one C++ function template.
#pragma once

#include <string>
#include <vector>

#include "emit/header_scope.hpp"
#include "graph/function.hpp"

namespace flatdyn {

struct ArrayArgument {
  std::string name;
  std::size_t length = 0;
};

struct FunctionText {
  std::string name;
  std::string returns;                  // "void", "bool", "Scalar"
  std::vector<std::string> parameters;  // "const Scalar* q", …
  std::vector<ArrayArgument> inputs;    // in the order of the parameters, after the robot's own
  std::vector<ArrayArgument> outputs;   // empty for a function that returns its value
  std::vector<std::string> arguments;   // lines that document them
  std::string reads;                    // "q[1..6]"
  std::string result;                   // what is returned; empty for void
  std::string body;                     // indented lines
  std::string parts;                    // templates for namespace detail that a long body calls; else empty
  bool uses_sign = false;
  bool uses_trigonometry = false;  // then it has SinCos as a template parameter, and is passed one
};

FunctionText function_text(const Function& function, const std::string& name, const HeaderScope& scope);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// One Function → the text of one C++ function template, of one or two C functions, or of one JavaScript function.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "emit/header_scope.hpp"
#include "graph/function.hpp"

namespace flatdyn {

struct ArrayArgument {
  std::string name;
  std::size_t length = 0;
};

// In C, a function that takes sines and cosines: the one that is called without them calls it.
struct GivenText {
  std::string name;                     // "panda_gravity_given"
  std::vector<std::string> parameters;  // of its definition
  std::vector<std::string> declared;    // of its declaration
  std::vector<std::string> arguments;   // that a call has
  std::string of, joints;               // whose sines and cosines it takes: "q", "1..6"
  std::string body;                     // indented lines
};

// In C++, a template with its arguments put in.
struct Instance {
  std::string returns;                  // "Configuration<double>"
  std::vector<std::string> parameters;  // "const double* q", …
};

struct FunctionText {
  std::string name;
  std::string returns;                  // "void", "bool", "Scalar"
  std::vector<std::string> parameters;  // "const Scalar* q", …
  std::vector<std::string> declared;    // of its declaration, where that stands apart; in C without "restrict"
  std::vector<ArrayArgument> inputs;    // in the order of the parameters, after the robot's own
  std::vector<ArrayArgument> outputs;   // empty for a function that returns its value
  std::vector<std::string> arguments;   // lines that document them
  std::string reads;                    // "q[1..6]"
  std::string result;                   // what is returned; empty for void
  std::string body;                     // indented lines
  std::string parts;                    // functions for nobody else that a long body calls; else empty
  std::optional<GivenText> given;       // in C, where sines or cosines are needed
  std::vector<Instance> compiled;       // C++ in header and source: what the source is compiled for; else empty
  bool uses_sign = false, uses_sqrt = false;
  bool uses_trigonometry = false;  // then it has SinCos as a template parameter, and is passed one
};

inline bool is_declared_apart(const FunctionText& text) { return !text.declared.empty(); }

// `given_name`: in C, of the function that takes sines and cosines, if there is one.
FunctionText function_text(const Function& function, const std::string& name, const HeaderScope& scope,
                           const std::string& given_name = "");

}  // namespace flatdyn

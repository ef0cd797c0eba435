// SPDX-License-Identifier: GPL-2.0-or-later
// Conversion of a Function to its text: a function, or a function template.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "code/emit/header_scope.hpp"
#include "code/lower/body.hpp"
#include "graph/function.hpp"

namespace flatdyn {

struct ArrayArgument {
  std::string name;
  std::size_t length = 0;
};

// In C, the variant of a function that takes sines and cosines; the other variant calls it.
struct SinCosVariant {
  std::string name;                     // "panda_gravity_given"
  std::vector<std::string> parameters;  // parameters of the definition
  std::vector<std::string> declared;    // parameters of the declaration
  std::vector<std::string> arguments;   // arguments of a call
  std::string of, joints;               // the positions and the joints whose sines and cosines it takes: "q", "1..6"
  std::string body;                     // indented lines
};

// In C++, an instantiated template.
struct Instance {
  std::string returns;                  // "Configuration<double>"
  std::vector<std::string> parameters;  // "const double* q", …
};

// An argument of a function, before a language declares it.
struct Argument {
  enum class Kind { parameters, input, output } kind;
  std::string name;
  bool is_used;  // read or written
  std::size_t length = 0;
  bool is_number = false;  // an output that is not one of several entries, by a pointer
};

// A function whose body is written and whose parameters are not.
struct UndeclaredFunction {
  const FunctionBody& body;
  const HeaderScope& scope;
  std::vector<Argument> arguments;   // in order
  std::string sin_cos_variant_name;  // the name of the variant that takes sines and cosines, where languages have it
};

struct FunctionText {
  std::string name;
  std::string returns;                           // "void", "bool", "Scalar"
  std::vector<std::string> parameters;           // "const Scalar* q", …
  std::vector<std::string> declared;             // parameters of a separate declaration; in C without "restrict"
  std::vector<ArrayArgument> inputs;             // in the order of the parameters, after the robot's own parameters
  std::vector<ArrayArgument> outputs;            // empty for a function that returns its value
  std::vector<std::string> arguments;            // lines of documentation
  std::string reads;                             // "q[1..6]"
  std::string result;                            // the value returned; empty for void
  std::string body;                              // indented lines
  std::string parts;                             // functions that only a long body calls; else empty
  std::optional<SinCosVariant> sin_cos_variant;  // in C, if sines or cosines are needed
  std::vector<Instance> compiled;  // for C++ in header and source: the instantiations in the source; else empty
  bool uses_sign = false, uses_sqrt = false, uses_excess = false, uses_fma = false, uses_limbs = false,
       uses_zeros = false;
  bool uses_trigonometry = false;  // in C++ it then has a template parameter SinCos and an argument of that type
  bool computes_sines = false;     // whether it asks for sines and cosines of angles that it computes
};

// Whether a kernel can be launched over arrays of its results: its outputs have entries.
bool can_be_launched(const FunctionText& text);

// `sin_cos_variant_name`: see UndeclaredFunction.
FunctionText function_text(const Function& function, const std::string& name, const HeaderScope& scope,
                           const std::string& sin_cos_variant_name = "");

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// What the languages of emitted code differ in, and the only place that knows. Names of variables, the order of
// statements and the shape of expressions are common to them, so that all forms compute the same bits.
#pragma once

#include <string>
#include <vector>

#include "graph/rational.hpp"

namespace flatdyn {

enum class Language { cpp, c, javascript };

// An array of constants at file or namespace scope.
struct ConstantArray {
  std::string type;    // "const char*", "bool"; kReal: numbers
  std::string name;    // as it is emitted
  std::string length;  // "joint_count", "49"
  std::vector<std::string> entries;
  int row = 0;  // entries per line; 0: as many as there is room for
};

inline constexpr const char* kReal = "Real";

class Dialect {
 public:
  // C++: templates over Scalar, in the robot's namespace; constants of type Real.
  Dialect() = default;
  // C99 in one scalar, "double" or "float"; `name_space`: of the C++ form, "a::b", here the prefix a_b_.
  static Dialect c(const std::string& scalar, const std::string& name_space);
  // GNU C: of as many states as a SIMD register has lanes, in vectors of that scalar. A robot's own numbers are spread
  // over the lanes.
  static Dialect c_lanes(const std::string& scalar, const std::string& name_space);
  // Names of a module's own; numbers are doubles.
  static Dialect javascript();

  bool is_cpp() const { return language_ == Language::cpp; }
  bool is_c() const { return language_ == Language::c; }
  bool is_javascript() const { return language_ == Language::javascript; }
  bool is_lanes() const { return is_c() && scalar_ != number_; }

  // The type of variables: "Scalar", "float"; "number", which JavaScript's comments say.
  const std::string& scalar() const { return scalar_; }
  // Of the numbers in them: "float" also where `scalar` is a vector of floats.
  const std::string& number() const { return number_; }
  // What is known outside of its function: "gravity", "panda_gravity", of lanes "panda_lanes_gravity".
  std::string global(const std::string& name) const { return prefix_ + (is_lanes() ? kLanes : "") + name; }
  // What is known outside of its file, or from another one.
  std::string exported(const std::string& name) const { return prefix_ + name; }
  // A count: "joint_count", "PANDA_JOINT_COUNT".
  std::string count_name(const std::string& name) const;
  // Words that variables must differ from beside those of C++.
  std::vector<std::string> reserved() const;

  // "Scalar(0.0825)", "0.0825f". Throws Failure(input) if the scalar is too small for it.
  std::string literal(const Rational& value) const;
  // In an array of constants: "Real(0.0825)", "0.0825f"; and "Real(-HUGE_VAL)", "-HUGE_VALF".
  std::string real_literal(const Rational& value) const;
  std::string infinity(bool negative) const;
  // A constant of text, quoted.
  std::string text(const std::string& value) const;
  // "sinf": of <math.h>, where a form for each scalar has a name of its own.
  std::string library(const std::string& function) const;

  // "detail::sign(x)", "panda_sign(x)", "Math.sign(x)".
  std::string sign(const std::string& of) const;
  // "detail::sqrt(x)", "sqrtf(x)", "Math.sqrt(x)".
  std::string sqrt(const std::string& of) const;
  // A free symbol of the robot: "parameters.m_1", "parameters->m_1".
  std::string parameter(const std::string& member) const;

  // Arguments of functions. In C, definitions say `restrict` of outputs; declarations, which C++ reads too, do not.
  // Inputs may be one array.
  std::string input(const std::string& name) const;                          // "const Scalar* q"
  std::string output(const std::string& name, bool restricts = true) const;  // "Scalar* tau"
  std::string parameters_argument() const;                                   // "const Parameters<Scalar>& parameters"
  std::string number_output(const std::string& name) const;                  // "Scalar& result", an array of one in C
  std::string number_definition(const std::string& name) const;              // "result", "result[1]"
  std::string number_use(const std::string& name) const;                     // "result", "result[0]"

  // Local variables: what stands before the first one, "const Scalar ", "const "; and arrays that are filled later, or
  // such a number: "Scalar ", and "kept[7]", in JavaScript "kept = new Float64Array(7)".
  std::string constant() const;
  std::string arrays() const;
  std::string array(const std::string& name, std::size_t length) const;
  std::string condition_type() const;       // "bool"
  std::string always() const;               // "true"
  std::string conditions_begin() const;     // "bool positive = "
  std::string conditions_continue() const;  // "positive &= "

  // A function that only others of the same file call: what stands before its parameters, and behind.
  std::string part_begin(const std::string& name) const;
  std::string function_end() const;  // ") noexcept {"
  // "detail::f_part_1(" where the robot's own functions call it.
  std::string part_call(const std::string& name) const;

  // Lines; names are as they are emitted. In C a definition goes to the .c file, and a declaration to the header.
  std::string count_definition(const std::string& name, int value) const;
  std::string definition(const ConstantArray& array) const;
  std::string declaration(const ConstantArray& array) const;
  // for … positive &= pivots[k] > 0;
  std::string all_positive(const std::string& array, std::size_t length) const;

 private:
  static constexpr const char* kLanes = "lanes_";

  std::string spread(const std::string& number) const;
  std::string pointer(const std::string& type, const std::string& name) const;
  std::string type_of(const ConstantArray& array) const;

  Language language_ = Language::cpp;
  std::string scalar_ = "Scalar", number_ = "Scalar";
  std::string prefix_;
};

}  // namespace flatdyn

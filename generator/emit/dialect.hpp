// SPDX-License-Identifier: GPL-2.0-or-later
// The differences between the languages of emitted code; no other file knows them. Names of variables, the order of
// statements and the shape of expressions are common to all, so that all forms compute the same bits.
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
  int row = 0;  // entries per line; 0: as many as fit
};

inline constexpr const char* kReal = "Real";

class Dialect {
 public:
  // C++: templates over Scalar, in the robot's namespace; constants have type Real.
  Dialect() = default;
  // C99 in one scalar, "double" or "float". `name_space`: that of the C++ form, "a::b", which becomes the prefix a_b_.
  static Dialect c(const std::string& scalar, const std::string& name_space);
  // GNU C with vectors of that scalar, one state per lane of a SIMD register. The robot's own numbers are broadcast to
  // the lanes.
  static Dialect c_lanes(const std::string& scalar, const std::string& name_space);
  // JavaScript: names are local to the module; numbers are doubles.
  static Dialect javascript();

  bool is_cpp() const { return language_ == Language::cpp; }
  bool is_c() const { return language_ == Language::c; }
  bool is_javascript() const { return language_ == Language::javascript; }
  bool is_lanes() const { return is_c() && scalar_ != number_; }

  // The type of variables: "Scalar", "float"; "number", which appears in JavaScript's comments.
  const std::string& scalar() const { return scalar_; }
  // The type of the numbers in variables: "float" also if `scalar` is a vector of floats.
  const std::string& number() const { return number_; }
  // A name at file or namespace scope: "gravity", "panda_gravity", for lanes "panda_lanes_gravity".
  std::string global(const std::string& name) const { return prefix_ + (is_lanes() ? kLanes : "") + name; }
  // A name that other files use.
  std::string exported(const std::string& name) const { return prefix_ + name; }
  // The name of a count: "joint_count", "PANDA_JOINT_COUNT".
  std::string count_name(const std::string& name) const;
  // Reserved words that variables must avoid beside those of C++.
  std::vector<std::string> reserved() const;

  // A literal: "Scalar(0.0825)", "0.0825f". Throws Failure(input) if the scalar's range is too small for it.
  std::string literal(const Rational& value) const;
  // A literal in an array of constants: "Real(0.0825)", "0.0825f"; and "Real(-HUGE_VAL)", "-HUGE_VALF".
  std::string real_literal(const Rational& value) const;
  std::string infinity(bool negative) const;
  // A quoted string constant.
  std::string text(const std::string& value) const;
  // The name of a function of <math.h>, such as "sinf", where each scalar has its own.
  std::string library(const std::string& function) const;

  // A call of the sign: "detail::sign(x)", "panda_sign(x)", "Math.sign(x)".
  std::string sign(const std::string& of) const;
  // A call of the square root: "detail::sqrt(x)", "sqrtf(x)", "Math.sqrt(x)".
  std::string sqrt(const std::string& of) const;
  // The value of a free symbol of the robot: "parameters.m_1", "parameters->m_1".
  std::string parameter(const std::string& member) const;

  // Declarations of function arguments. In C, definitions declare outputs `restrict`; declarations, which C++ reads
  // too, do not. Inputs are never `restrict`: one array may serve as several of them.
  std::string input(const std::string& name) const;                          // "const Scalar* q"
  std::string output(const std::string& name, bool restricts = true) const;  // "Scalar* tau"
  std::string parameters_argument() const;                                   // "const Parameters<Scalar>& parameters"
  std::string number_output(const std::string& name) const;                  // "Scalar& result", an array of one in C
  std::string number_definition(const std::string& name) const;              // "result", "result[1]"
  std::string number_use(const std::string& name) const;                     // "result", "result[0]"

  // Declarations of local variables: the beginning, "const Scalar ", "const "; and an array, or a single number, that
  // is filled later: "Scalar ", and "kept[7]", in JavaScript "kept = new Float64Array(7)".
  std::string constant() const;
  std::string arrays() const;
  std::string array(const std::string& name, std::size_t length) const;
  std::string condition_type() const;       // "bool"
  std::string always() const;               // "true"
  std::string conditions_begin() const;     // "bool positive = "
  std::string conditions_continue() const;  // "positive &= "

  // The beginning of a function that only functions of the same file call, up to its parameters, and the text after
  // them.
  std::string part_begin(const std::string& name) const;
  std::string function_end() const;  // ") noexcept {"
  // The beginning of a call of a part by the robot's functions: "detail::f_part_1(".
  std::string part_call(const std::string& name) const;

  // Definitions and declarations as lines; names are as emitted. In C, definitions go to the .c file and declarations
  // to the header.
  std::string count_definition(const std::string& name, int value) const;
  std::string definition(const ConstantArray& array) const;
  std::string declaration(const ConstantArray& array) const;
  // A loop of checks: for … positive &= pivots[k] > 0;
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

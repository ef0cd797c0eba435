// SPDX-License-Identifier: GPL-2.0-or-later
// The differences between the languages of emitted text, as far as reading its functions is concerned.
#pragma once

#include <string>

namespace flatdyn {

// The variable that says whether a result means something.
inline constexpr const char* kValid = "valid";

struct EmittedNotation {
  std::string scalar;              // the type of variables: "Scalar", "float"; "number" in JavaScript
  std::string constants;           // the type to which constants are rounded: "double", "float"
  std::string condition = "bool";  // begins the definition of kValid,
  const char* and_also = "&=";     // and this its continuation
  std::string verdict = "bool";    // the type that a function returns it as
  const char* counter = "int";     // the type of a loop's counter
  bool names_types = true;         // "const Scalar x"; parameters tell inputs from outputs
  bool is_cpp = false;             // "Scalar(0.0825)", detail::sign(x), sin_cos(…), parameters.m1
  bool has_c_functions = false;    // arm_sines_and_cosines(…), arm_sign(x), sqrtf(x), and parameters->m1
  bool has_math_object = false;    // Math.sin(q[2]); no array has a type
  bool has_lanes = false;          // arm_lanes_all(0.0825), arm_lanes_sign(x), arm_lanes_all(parameters->m1)
};

// The notation of the language in which variables have this type. "lanes double": vectors of doubles in C, whose type
// the text names.
EmittedNotation notation_of(const std::string& scalar);

// Completes the notation of vectors by the name of their type.
void name_lanes(const std::string& type, EmittedNotation& notation);

}  // namespace flatdyn

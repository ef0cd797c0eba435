// SPDX-License-Identifier: GPL-2.0-or-later
// The differences between the languages of emitted text, as far as reading its functions is concerned.
#pragma once

#include <string>

namespace flatdyn {

// The variable that says whether a result means something, and its name where every entry is checked to be finite, too.
inline constexpr const char *kPivotsChecked = "positive", *kAllChecked = "valid";

struct EmittedNotation {
  std::string scalar;              // the type of variables: "Scalar", "float"; "number" in JavaScript
  std::string constants;           // the type to which constants are rounded: "double", "float"
  const char* condition = "bool";  // begins the definition of kAllChecked,
  const char* and_also = "&=";     // and this its continuation
  const char* counter = "int";     // the type of a loop's counter
  bool names_types = true;         // "const Scalar x"; parameters tell inputs from outputs
  bool is_cpp = false;             // "Scalar(0.0825)", detail::sign(x), sin_cos(…), parameters.m1
  bool has_c_functions = false;    // arm_sines_and_cosines(…), arm_sign(x), sqrtf(x), and parameters->m1
  bool has_math_object = false;    // Math.sin(q[2]); no array has a type
};

// The notation of the language in which variables have this type.
EmittedNotation notation_of(const std::string& scalar);

}  // namespace flatdyn

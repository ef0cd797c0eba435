// SPDX-License-Identifier: GPL-2.0-or-later
// The text of a function in another convention: it converts its arguments, calls the function, converts the results.
#pragma once

#include <string>
#include <vector>

#include "code/conventions/convention.hpp"
#include "code/emit/function_text.hpp"
#include "code/languages/cpp/shapes.hpp"

namespace flatdyn {

// The robot's code that adaptors call.
struct AdaptedCode {
  const Mechanism& mechanism;
  const Convention& convention;
  std::string name_space;  // "quadruped12"
  const std::vector<Function>& functions;
  const std::vector<FunctionText>& texts;  // by function
};

struct Adaptor {
  std::vector<std::string> comment;
  std::string template_parameters;  // "class Scalar, class SinCos = DefaultSinCos"
  std::string signature;            // "static inline void bias(…) noexcept {", without newline
  std::string body;                 // indented lines, without the last newline
  ShapedFunction shape;
};

// The adaptor of a function that the convention has (code/conventions/coverage.hpp).
Adaptor adaptor(const AdaptedCode& code, std::size_t function);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The text of a function in another convention: it converts its arguments, calls the function, converts the results.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "conventions/convention.hpp"
#include "emit/function_text.hpp"
#include "emit/languages/cpp_shapes.hpp"

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

// The adaptor of a function; nullopt if it has none (why_not() says why).
std::optional<Adaptor> adaptor(const AdaptedCode& code, std::size_t function);

// Why a function has no adaptor; empty if it has one.
std::string why_not(const AdaptedCode& code, std::size_t function);

// The meaning of q, v and tau: axes, order and units.
std::string meaning_of_pose(const Convention& convention);
std::string meaning_of_velocity(const Convention& convention);
std::string meaning_of_force(const Convention& convention);

}  // namespace flatdyn

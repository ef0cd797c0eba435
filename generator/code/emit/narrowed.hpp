// SPDX-License-Identifier: GPL-2.0-or-later
// Constants that are lost or lose digits in float, whose normal numbers range from 1.2e-38 to 3.4e38.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// A constant and its absolute value in float: 0, infinity, or a subnormal number, which has fewer digits.
struct NarrowedConstant {
  double value = 0;
  float becomes = 0;
  std::string function;  // the first function that has it
};

// The narrowed constants of all functions, each once: first those that become infinite, then those that become 0.
std::vector<NarrowedConstant> narrowed_constants(const std::vector<Function>& functions);

// Warns of these constants, if there are any.
void warn_of_narrowed(const std::vector<NarrowedConstant>& constants, const Place& place, Diagnostics& findings);

}  // namespace flatdyn

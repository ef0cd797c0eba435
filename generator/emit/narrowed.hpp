// SPDX-License-Identifier: GPL-2.0-or-later
// Constants that are good in double and not in float, whose numbers reach from 1.2e-38 to 3.4e38.
#pragma once

#include <string>
#include <vector>

#include "diagnostics/diagnostics.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// What float makes of a constant, without its sign: 0, infinity, or a subnormal number, which has fewer digits.
struct NarrowedConstant {
  double value = 0;
  float becomes = 0;
  std::string function;  // the first one that has it
};

// Of all that is written of the functions; each once, infinite ones first and then those that become 0.
std::vector<NarrowedConstant> narrowed_constants(const std::vector<Function>& functions);

// Warns of them, if there are any.
void warn_of_narrowed(const std::vector<NarrowedConstant>& constants, const Place& place, Diagnostics& findings);

}  // namespace flatdyn

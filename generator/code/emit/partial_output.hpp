// SPDX-License-Identifier: GPL-2.0-or-later
// The text about which entries are written, for functions of which a scene leaves some out.
#pragma once

#include <string>
#include <vector>

#include "code/emit/function_text.hpp"

namespace flatdyn {

// Lines for the head of the header. `inputs_come_first`: whether they say that all inputs are read before anything is
// written, which matters if an output may overlap an input.
std::vector<std::string> partial_output_rule(const std::vector<Function>& functions, bool inputs_come_first);

// " Written: tau[0..2], and nothing else of tau." for each output with entries left out; `outputs`: the function's
// output arrays.
std::string partial_output_text(const Function& function, const std::vector<ArrayArgument>& outputs);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The text about which entries are written, for functions of which a scene leaves some out.
#pragma once

#include <string>
#include <vector>

#include "emit/function_text.hpp"

namespace flatdyn {

// Lines for the head of the header. In C and JavaScript no output overlaps an input, so the order of reading does not
// matter.
std::vector<std::string> writing_rule(const std::vector<Function>& functions, bool in_c);

// " Written: tau[0..2], and nothing else of tau." for each output with entries left out; `outputs`: the function's
// output arrays.
std::string written_text(const Function& function, const std::vector<ArrayArgument>& outputs);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// What a header says of the entries that are written, where a scene leaves some out.
#pragma once

#include <string>
#include <vector>

#include "emit/function_text.hpp"

namespace flatdyn {

// Lines for the head of the header. In C and JavaScript no output overlaps an input, so nothing depends on what is
// read first.
std::vector<std::string> writing_rule(const std::vector<Function>& functions, bool in_c);

// " Written: tau[0..2], and nothing else of tau." of each output of which entries are left out; `outputs`: its arrays.
std::string written_text(const Function& function, const std::vector<ArrayArgument>& outputs);

}  // namespace flatdyn

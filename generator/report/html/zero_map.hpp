// SPDX-License-Identifier: GPL-2.0-or-later
// A picture of a matrix's structural zeros.
#pragma once

#include <string>

#include "graph/function.hpp"

namespace flatdyn {

// SVG with a square per entry, filled unless the entry is always zero, in the colours of the page around it. `label` is
// escaped.
std::string zero_map(const Function& function, const Output& output, const std::string& label);

// The number of entries that are not always zero.
int nonzero_entries(const Function& function, const Output& output);

}  // namespace flatdyn

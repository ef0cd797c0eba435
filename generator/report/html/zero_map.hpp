// SPDX-License-Identifier: GPL-2.0-or-later
// Which entries of a matrix are always zero, as a picture.
#pragma once

#include <string>

#include "graph/function.hpp"

namespace flatdyn {

// SVG with a square per entry, filled where it is not always zero; in the colours of the page that it stands in.
// `label` is escaped.
std::string zero_map(const Function& function, const Output& output, const std::string& label);

// Entries that are not always zero.
int nonzero_entries(const Function& function, const Output& output);

}  // namespace flatdyn

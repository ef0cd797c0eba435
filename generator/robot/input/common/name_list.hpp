// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

// "gravity, bias" → "gravity", "bias": blanks around a name do not count. Throws std::invalid_argument where there is
// nothing between two commas, before the first or behind the last one.
std::vector<std::string> names_in(const std::string& list);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Hints for misspelt names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flatdyn {

// "did you mean \"gravity\"?" if one of the names is close to what was written, else the list of what is known:
// "known keys: a, b, c" (`plural` is "keys").
std::string hint_for_unknown(std::string_view written, const std::vector<std::string>& known, std::string_view plural);

}  // namespace flatdyn

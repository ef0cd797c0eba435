// SPDX-License-Identifier: GPL-2.0-or-later
// Hints for misspelt names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flatdyn {

// "did you mean \"gravity\"?" if a known name is close to `written`, else the list of known names, "known keys: a, b,
// c" (with `plural` = "keys").
std::string hint_for_unknown(std::string_view written, const std::vector<std::string>& known, std::string_view plural);

// The same for names that people shorten: the shortest one that begins with `written` comes first.
std::string hint_for_abbreviated(std::string_view written, const std::vector<std::string>& known,
                                 std::string_view plural);

}  // namespace flatdyn

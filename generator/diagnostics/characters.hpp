// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace flatdyn {

// Whether the character is one of 0 to 9, whatever the locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace flatdyn

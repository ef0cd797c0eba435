// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string_view>

namespace flatdyn {

// Whether the character is one of 0 to 9, whatever the locale.
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The text without blanks, tabs and line breaks at its beginning and end.
constexpr std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

}  // namespace flatdyn

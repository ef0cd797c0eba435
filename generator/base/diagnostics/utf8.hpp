// SPDX-License-Identifier: GPL-2.0-or-later
// Text in UTF-8, as JSON and C++ comments need it, from files that may have other encodings.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace flatdyn {

// The first character of a text in UTF-8.
struct Utf8Character {
  std::optional<char32_t> code;  // nullopt if no character begins there
  std::size_t length = 1;        // bytes to skip
};
Utf8Character first_character(std::string_view text);  // text: not empty

// Whether the whole text is valid UTF-8.
bool is_utf8(std::string_view text);

// Whether the bytes are UTF-16: they have its byte order mark, or one of the first two is 0, which is at the beginning
// of no other text.
bool is_utf16(std::string_view bytes);

// The text in UTF-8, without a byte order mark, of bytes for which is_utf16() holds; nullopt if it is damaged.
std::optional<std::string> utf8_of_utf16(std::string_view bytes);

// The same of bytes in ISO 8859-1, each of which is a character.
std::string utf8_of_latin1(std::string_view bytes);

}  // namespace flatdyn

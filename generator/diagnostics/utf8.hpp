// SPDX-License-Identifier: GPL-2.0-or-later
// Names go into JSON and C++ comments, which are UTF-8; files come in other encodings, too.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace flatdyn {

// The first character of a text in UTF-8.
struct Utf8Character {
  std::optional<char32_t> code;  // nullopt if no character begins there
  std::size_t length = 1;        // bytes to go on after
};
Utf8Character first_character(std::string_view text);  // of a text that is not empty

bool is_utf8(std::string_view text);

// Whether bytes are UTF-16: by their byte order mark, or as one of the first two is 0, which no other text begins with.
bool is_utf16(std::string_view bytes);

// The text of bytes for which is_utf16() holds, in UTF-8 and without a byte order mark; nullopt if it is damaged.
std::optional<std::string> utf8_of_utf16(std::string_view bytes);

// The same of bytes in ISO 8859-1, each of which is a character.
std::string utf8_of_latin1(std::string_view bytes);

}  // namespace flatdyn

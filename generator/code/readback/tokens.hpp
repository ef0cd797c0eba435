// SPDX-License-Identifier: GPL-2.0-or-later
// The tokens of emitted text: names, numbers, strings, operators as compilers divide them, and preprocessor directives.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace flatdyn {

struct Token {
  std::string text;  // of a directive: its lines as one, without comment and without blanks that mean nothing
  int line = 0;      // from 1

  bool is_directive() const { return text.front() == '#'; }
};

// The tokens without comments. Whatever is no token of emitted text becomes a token that no grammar knows. A comment
// that a compiler would continue on a line of code does, too.
std::vector<Token> tokens_of(const std::string& text);

// The text of a token in double quotes, with its escapes resolved; nullopt if it is not well formed.
std::optional<std::string> unquoted(const std::string& token);

}  // namespace flatdyn

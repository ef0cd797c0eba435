// SPDX-License-Identifier: GPL-2.0-or-later
// The tokens of emitted text: names, numbers, and operators of one to three characters.
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

struct Token {
  std::string text;
  int line = 0;  // from 1
};

// The tokens without comments and preprocessor directives.
std::vector<Token> tokens_of(const std::string& text);

}  // namespace flatdyn

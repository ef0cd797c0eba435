// SPDX-License-Identifier: GPL-2.0-or-later
// A position among the tokens of emitted text, in C++ or C, that a scanner moves.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "code/readback/tokens.hpp"

namespace flatdyn {

class TokenCursor {
 public:
  explicit TokenCursor(const std::vector<Token>& tokens) : tokens_(tokens) {}

 protected:
  bool at_end() const { return at_ >= tokens_.size(); }
  bool is(const char* text) const { return !at_end() && tokens_[at_].text == text; }
  // The text of the token this far ahead or, if negative, behind.
  const std::string& word(std::ptrdiff_t ahead = 0) const;

  // Moves past the next `end` that is not within braces.
  void skip_past(const char* end);
  // Moves from an opening brace past its counterpart.
  void skip_block();
  void skip_to(const char* text);

  // Throws Failure(bug) with the current line.
  [[noreturn]] void fail(const std::string& what) const;

  const std::vector<Token>& tokens_;
  std::size_t at_ = 0;
};

}  // namespace flatdyn

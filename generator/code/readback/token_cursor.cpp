// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/readback/token_cursor.hpp"

#include <algorithm>

#include "code/readback/unreadable_text.hpp"

namespace flatdyn {

const std::string& TokenCursor::word(std::ptrdiff_t ahead) const {
  const std::size_t k = at_ + static_cast<std::size_t>(ahead);  // wraps around before the first token
  if (k >= tokens_.size()) fail("it ends here");
  return tokens_[k].text;
}

void TokenCursor::skip_past(const char* end) {
  while (word() != end) {
    if (is("{")) {
      skip_block();
    } else {
      ++at_;
    }
  }
  ++at_;
}

void TokenCursor::skip_block() {
  int depth = 0;
  do {
    depth += word() == "{" ? 1 : word() == "}" ? -1 : 0;
    ++at_;
  } while (depth > 0);
}

void TokenCursor::skip_to(const char* text) {
  while (word() != text) ++at_;
}

void TokenCursor::fail(const std::string& what) const {
  const int line = tokens_.empty() ? 0 : tokens_[std::min(at_, tokens_.size() - 1)].line;
  throw UnreadableText(line, what);
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "readback/tokens.hpp"

#include <algorithm>
#include <cctype>

namespace flatdyn {
namespace {

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

class Lexer {
 public:
  explicit Lexer(const std::string& text) : text_(text) {}

  std::vector<Token> run() {
    while (skip_blanks(), at_ < text_.size()) take(length_of_next());
    return std::move(tokens_);
  }

 private:
  bool starts_with(const char* begin) const { return text_.compare(at_, std::string(begin).size(), begin) == 0; }

  void skip_to(const char* end) {
    const std::size_t found = text_.find(end, at_);
    const std::size_t next = found == std::string::npos ? text_.size() : found + std::string(end).size();
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                         text_.begin() + static_cast<std::ptrdiff_t>(next), '\n'));
    at_ = next;
  }

  void skip_blanks() {
    while (at_ < text_.size()) {
      if (starts_with("//") || text_[at_] == '#' || text_[at_] == '\n') {
        skip_to("\n");
      } else if (starts_with("/*")) {
        skip_to("*/");
      } else if (text_[at_] == ' ') {
        ++at_;
      } else {
        return;
      }
    }
  }

  std::size_t length_of_next() const {
    std::size_t end = at_;
    const bool is_number = std::isdigit(static_cast<unsigned char>(text_[at_])) != 0;
    while (end < text_.size() && (is_of_word(text_[end]) || (is_number && is_of_number(end)))) ++end;
    if (end > at_) return end - at_;
    if (text_[at_] == '"') return length_of_string();
    if (starts_with("&&=")) return 3;
    return starts_with("::") || starts_with("&=") ? 2 : 1;
  }

  std::size_t length_of_string() const {
    std::size_t end = at_ + 1;
    while (end < text_.size() && text_[end] != '"') end += text_[end] == '\\' ? 2 : 1;
    return std::min(end + 1, text_.size()) - at_;
  }

  // Whether character k is part of a number like "1.5e-07": a point, or a sign after an e.
  bool is_of_number(std::size_t k) const {
    return text_[k] == '.' || ((text_[k] == '-' || text_[k] == '+') && text_[k - 1] == 'e');
  }

  void take(std::size_t length) {
    tokens_.push_back({text_.substr(at_, length), line_});
    at_ += length;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens_of(const std::string& text) { return Lexer(text).run(); }

}  // namespace flatdyn

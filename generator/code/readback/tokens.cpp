// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/readback/tokens.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace flatdyn {
namespace {

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// The operators of more than one character, the longest first. >> is not among them: it may close two templates.
constexpr auto kOperators = std::to_array<std::string_view>(
    {"...", "&&=", "||=", "<<=", "::", "->", "++", "--", "<=", ">=", "==", "!=", "&&", "||", "&=", "|=",
     "^=",  "+=",  "-=",  "*=",  "/=", "%=", "=>", "<<", "??", "<%", "%>", "<:", ":>", "%:", "/*", "*/"});

// Bytes that end a comment in JavaScript, in addition to a line's end: a carriage return and Unicode's separators.
bool ends_comment_early(std::string_view comment) {
  return comment.find('\r') != std::string_view::npos || comment.find("\xE2\x80\xA8") != std::string_view::npos ||
         comment.find("\xE2\x80\xA9") != std::string_view::npos;
}

// Whether a compiler reads the next line as part of this one. It may pass over blanks behind the backslash.
bool goes_on(std::string_view line) {
  while (line.ends_with(' ') || line.ends_with('\t')) line.remove_suffix(1);
  return line.ends_with("\\") || line.ends_with("?\?/");
}

class Lexer {
 public:
  explicit Lexer(const std::string& text) : text_(text) {}

  std::vector<Token> run() {
    while (skip_blanks(), at_ < text_.size()) {
      if (text_[at_] == '#') {
        directive();
      } else {
        take(length_of_next());
      }
    }
    return std::move(tokens_);
  }

 private:
  bool starts_with(std::string_view begin) const { return text_.compare(at_, begin.size(), begin) == 0; }

  std::size_t end_of_line() const { return std::min(text_.find('\n', at_), text_.size()); }

  void skip_to(std::size_t next) {
    line_ += static_cast<int>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                                         text_.begin() + static_cast<std::ptrdiff_t>(next), '\n'));
    at_ = next;
  }

  void skip_blanks() {
    while (at_ < text_.size()) {
      if (starts_with("//")) {
        line_comment();
      } else if (starts_with("/*")) {
        block_comment();
      } else if (text_[at_] == ' ' || text_[at_] == '\n') {
        skip_to(at_ + 1);
      } else {
        return;
      }
    }
  }

  // A compiler ends a comment by "*/" even where a line that goes on divides it.
  void block_comment() {
    const std::size_t end = text_.find("*/", at_ + 2);
    const std::size_t behind = end == std::string::npos ? text_.size() : end + 2;
    for (std::size_t line = text_.find('\n', at_); line < behind; line = text_.find('\n', line + 1)) {
      std::string_view before = std::string_view(text_).substr(at_, line - at_);
      if (!goes_on(before)) continue;
      before.remove_suffix(before.size() - before.find_last_not_of("\\?/ \t") - 1);
      if (before.ends_with('*')) refuse("a comment that ends on two lines");
    }
    skip_to(behind);
  }

  void line_comment() {
    const std::size_t end = end_of_line();
    const std::string_view comment = std::string_view(text_).substr(at_, end - at_);
    if (ends_comment_early(comment)) refuse("a comment that ends early");
    skip_to(std::min(end + 1, text_.size()));
    if (!goes_on(comment)) return;
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    if (!starts_with("//") && at_ < text_.size() && text_[at_] != '\n') refuse("a comment that goes on");
  }

  // Takes a line that begins with #, and those that it goes on with, as one line.
  void directive() {
    const std::size_t last_end = at_ == 0 ? std::string::npos : text_.rfind('\n', at_ - 1);
    const std::size_t begin = last_end == std::string::npos ? 0 : last_end + 1;
    const bool is_first = text_.find_first_not_of(' ', begin) == at_;
    const int number = line_;
    std::string line = taken_line();
    while (line.ends_with('\\') && at_ < text_.size()) {
      line.pop_back();
      while (line.ends_with(' ')) line.pop_back();
      skip_to(at_ + 1);
      while (at_ < text_.size() && text_[at_] == ' ') ++at_;
      line += " " + taken_line();
    }
    if (const std::size_t comment = line.find("//"); comment != std::string::npos && !goes_on(line)) {
      line.resize(comment);
    }
    while (line.ends_with(' ')) line.pop_back();
    tokens_.push_back({is_first ? line : "# within a line", number});
  }

  // Takes the rest of the line, without its end.
  std::string taken_line() {
    const std::size_t end = end_of_line();
    std::string line = text_.substr(at_, end - at_);
    skip_to(end);
    return line;
  }

  // Adds a token that no grammar knows.
  void refuse(const char* what) { tokens_.push_back({std::string("# ") + what, line_}); }

  std::size_t length_of_next() const {
    std::size_t end = at_;
    const bool is_number = is_digit(text_[at_]);
    while (end < text_.size() && (is_of_word(text_[end]) || (is_number && is_of_number(end)))) ++end;
    if (end > at_) return end - at_;
    if (text_[at_] == '"' || text_[at_] == '\'') return length_of_string();
    for (const std::string_view each : kOperators) {
      if (starts_with(each)) return each.size();
    }
    return 1;
  }

  std::size_t length_of_string() const {
    std::size_t end = at_ + 1;
    while (end < text_.size() && text_[end] != text_[at_] && text_[end] != '\n') end += text_[end] == '\\' ? 2 : 1;
    return std::min(end + 1, text_.size()) - at_;
  }

  // Whether character k is part of a number like "1.5e-07" or "0x1p-3": a point, or a sign after an e or a p.
  bool is_of_number(std::size_t k) const {
    const bool is_hexadecimal = starts_with("0x");
    const bool is_sign = text_[k] == '-' || text_[k] == '+';
    return text_[k] == '.' || (is_sign && text_[k - 1] == (is_hexadecimal ? 'p' : 'e'));
  }

  void take(std::size_t length) {
    tokens_.push_back({text_.substr(at_, length), line_});
    skip_to(at_ + length);
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<Token> tokens_;
};

int digit_of(char c) {
  if (is_digit(c)) return c - '0';
  return c >= 'a' && c <= 'f' ? c - 'a' + 10 : 99;
}

// Reads so many digits to this base at `at`, and moves behind them; -1: there are others.
int code_at(std::string_view text, std::size_t& at, int digits, int base) {
  int value = 0;
  for (int k = 0; k < digits; ++k, ++at) {
    if (at >= text.size() || digit_of(text[at]) >= base) return -1;
    value = base * value + digit_of(text[at]);
  }
  return value;
}

// Appends a character in UTF-8.
void append_character(int code, std::string& text) {
  const auto append = [&text](int byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (code < 0x80) return append(code);
  if (code >= 0x10000) append(0xF0 | (code >> 18));
  if (code >= 0x10000) append(0x80 | ((code >> 12) & 0x3F));
  if (code >= 0x800 && code < 0x10000) append(0xE0 | (code >> 12));
  append(code < 0x800 ? 0xC0 | (code >> 6) : 0x80 | ((code >> 6) & 0x3F));
  append(0x80 | (code & 0x3F));
}

// Reads \uxxxx of JSON after its u, or two of them that make one character; false if they are not a character.
bool read_character(std::string_view from, std::size_t& at, std::string& text) {
  int code = code_at(from, at, 4, 16);
  if (code >= 0xD800 && code < 0xDC00 && from.substr(at, 2) == "\\u") {
    at += 2;
    const int low = code_at(from, at, 4, 16);
    code = low >= 0xDC00 && low < 0xE000 ? 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00) : -1;
  }
  if (code < 0) return false;
  append_character(code, text);
  return true;
}

// Reads \u{x…} of Rust after its opening brace.
bool read_braced_character(std::string_view from, std::size_t& at, std::string& text) {
  const std::size_t end = from.find('}', at);
  constexpr std::size_t kMostDigits = 6;
  if (end == std::string_view::npos || end == at || end - at > kMostDigits) return false;
  const int code = code_at(from, at, static_cast<int>(end - at), 16);
  ++at;
  if (code < 0 || code > 0x10FFFF) return false;
  append_character(code, text);
  return true;
}

// Reads an escape after its backslash: \ooo of C, or what JSON and Rust have; false if it is not an escape.
bool read_escape(std::string_view from, std::size_t& at, std::string& text) {
  constexpr std::string_view kLetters = "bfnrt", kMeanings = "\b\f\n\r\t";
  const char c = at < from.size() ? from[at] : 'x';
  if (c >= '0' && c <= '3') {
    const int byte = code_at(from, at, 3, 8);
    text += static_cast<char>(static_cast<unsigned char>(byte));
    return byte >= 0;
  }
  ++at;
  if (c == 'u' && from.substr(at, 1) == "{") return read_braced_character(from, ++at, text);
  if (c == 'u') return read_character(from, at, text);
  const std::size_t letter = kLetters.find(c);
  text += letter == std::string_view::npos ? c : kMeanings[letter];
  return letter != std::string_view::npos || c == '"' || c == '\\' || c == '?' || c == '/';
}

}  // namespace

std::vector<Token> tokens_of(const std::string& text) { return Lexer(text).run(); }

std::optional<std::string> unquoted(const std::string& token) {
  if (token.size() < 2 || token.front() != '"' || token.back() != '"') return std::nullopt;
  const std::string_view inner = std::string_view(token).substr(1, token.size() - 2);
  std::string text;
  for (std::size_t at = 0; at < inner.size();) {
    if (inner[at] != '\\') {
      text += inner[at++];
    } else if (!read_escape(inner, ++at, text)) {
      return std::nullopt;
    }
  }
  return text;
}

}  // namespace flatdyn

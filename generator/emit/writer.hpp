// SPDX-License-Identifier: GPL-2.0-or-later
// Lines of code and comments, broken where people would break them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace flatdyn {

constexpr std::size_t kLineWidth = 100;
constexpr std::size_t kCommentWidth = kLineWidth - 3;  // without "// "

constexpr std::size_t kStatementIndent = 2;

// A statement with this indent, newline at the end. Too long, it is broken after operators, the outermost first.
std::string code_line(const std::string& statement, std::size_t indent);

// begin + items joined by ", " + end, broken between items (a list in braces starts on its own line
// then); newline at the end.
std::string list_line(const std::string& begin, const std::vector<std::string>& items, const std::string& end,
                      std::size_t indent);

// The words of `text` in lines of at most `width` characters.
std::vector<std::string> wrapped_words(const std::string& text, std::size_t width);

// "…" as a C++ string constant, whatever the bytes of `text`.
std::string quoted(const std::string& text);

// "…" as a string of JavaScript, in ASCII, whatever the bytes of `text`; also within a script element of a page.
std::string javascript_string(const std::string& text);

// `text` with every `from` replaced.
std::string with_replaced(std::string text, const std::string& from, const std::string& to);

// `text` as it may stand in a // comment: no control characters, and no backslash that would join two lines.
std::string comment_text(const std::string& text);

}  // namespace flatdyn

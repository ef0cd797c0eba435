// SPDX-License-Identifier: GPL-2.0-or-later
// Lines of code and comments, broken as a person would break them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace flatdyn {

constexpr std::size_t kLineWidth = 100;
constexpr std::size_t kCommentWidth = kLineWidth - 3;  // for "// "

constexpr std::size_t kStatementIndent = 2;

// A statement with this indent, newline at the end. A long one is broken after operators, the outermost first.
std::string code_line(const std::string& statement, std::size_t indent);

// begin + items joined by ", " + end, broken between items if it is long (a list in braces then starts on its own
// line); newline at the end.
std::string list_line(const std::string& begin, const std::vector<std::string>& items, const std::string& end,
                      std::size_t indent);

// The words of `text` in lines of at most `width` characters.
std::vector<std::string> wrapped_words(const std::string& text, std::size_t width);

// `text` as a C++ string literal, whatever its bytes.
std::string quoted(const std::string& text);

// `text` as a JavaScript string in ASCII, whatever its bytes; also safe within a script element of a page.
std::string javascript_string(const std::string& text);

// `text` with every `from` replaced.
std::string with_replaced(std::string text, const std::string& from, const std::string& to);

// `text` made safe for a // comment: no control characters, and no backslash that would join two lines.
std::string comment_text(const std::string& text);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/writer.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <string_view>

namespace flatdyn {

namespace {

constexpr std::size_t kContinuationIndent = 4;

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

// The position at which to break `text` so that its first line has at most `width` characters: a space after an
// operator, of an outermost sum if possible, as late as possible, but not in the first third. npos if there is no such
// position.
std::size_t break_position(std::string_view text, std::size_t width) {
  std::size_t best = std::string_view::npos;
  int best_rank = 0;
  int depth = 0;
  for (std::size_t k = 1; k < text.size() && (k <= width || best == std::string_view::npos); ++k) {
    const char before = text[k - 1];
    if (before == '(') ++depth;
    if (before == ')') --depth;
    if (text[k] != ' ' || std::string_view("+-*/=").find(before) == std::string_view::npos) continue;
    const bool early = k < width / 3;
    const int rank = 2 * depth + (before == '+' || before == '-' ? 0 : 1) + (early ? 100 : 0);
    if (best == std::string_view::npos || rank <= best_rank) {
      best = k;
      best_rank = rank;
    }
  }
  return best;
}

}  // namespace

std::string code_line(const std::string& statement, std::size_t indent) {
  std::string result;
  std::string_view rest = statement;
  std::size_t margin = indent;
  while (margin + rest.size() > kLineWidth) {
    const std::size_t position = break_position(rest, kLineWidth - margin);
    if (position == std::string_view::npos) break;
    result.append(margin, ' ').append(rest.substr(0, position)) += '\n';
    rest.remove_prefix(position + 1);
    margin = indent + kContinuationIndent;
  }
  result.append(margin, ' ').append(rest) += '\n';
  return result;
}

std::string list_line(const std::string& begin, const std::vector<std::string>& items, const std::string& end,
                      std::size_t indent) {
  std::string result;
  std::string line = std::string(indent, ' ') + begin;
  std::size_t length = line.size() + end.size();
  for (const std::string& item : items) length += item.size() + 2;
  bool starts_line = true;
  if (length > kLineWidth + 2 && !begin.empty() && begin.back() == '{') {
    result = line + '\n';
    line = std::string(indent + kContinuationIndent, ' ');
  }
  for (std::size_t k = 0; k < items.size(); ++k) {
    const bool last = k + 1 == items.size();
    const std::string item = items[k] + (last ? end : ",");
    if (!starts_line && line.size() + 1 + item.size() > kLineWidth) {
      result += line + '\n';
      line = std::string(indent + kContinuationIndent, ' ') + item;
    } else {
      line += (starts_line ? "" : " ") + item;
    }
    starts_line = false;
  }
  return result + line + (items.empty() ? end : "") + '\n';
}

std::vector<std::string> wrapped_words(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  std::string word;
  while (words >> word) {
    if (!lines.empty() && lines.back().size() + 1 + word.size() <= width) {
      lines.back() += ' ' + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\' || c == '?') {
      result += '\\';  // so that no trigraph can arise
      result += c;
    } else if (is_control(c)) {
      result += fmt::format("\\{:03o}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      result += c;
    }
  }
  return result + '"';
}

std::string with_replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::string javascript_string(const std::string& text) {
  using nlohmann::json;
  return with_replaced(json(text).dump(-1, ' ', true, json::error_handler_t::replace), "<", "\\u003c");
}

std::string comment_text(const std::string& text) {
  std::string result = text;
  for (char& c : result) {
    if (is_control(c)) c = ' ';
    if (c == '\\') c = '/';
  }
  // Unicode's line and paragraph separators end a comment in JavaScript.
  for (const char* separator : {"\xE2\x80\xA8", "\xE2\x80\xA9"}) result = with_replaced(result, separator, " ");
  return result;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/diagnostics/wrap.hpp"

#include <algorithm>
#include <sstream>

#include "base/diagnostics/table.hpp"

namespace flatdyn {
namespace {

std::size_t hanging_indent(const std::string& line) {
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t gap = line.rfind("  ");
  return gap == std::string::npos || gap < begin ? begin : text_width(line.substr(0, gap + 2));
}

std::string wrapped_line(const std::string& line, std::size_t width) {
  const std::size_t indent = hanging_indent(line), begin = std::min(line.find_first_not_of(' '), line.size());
  std::string text, current = line.substr(0, begin);
  std::istringstream words(line.substr(begin));
  for (std::string word; std::getline(words, word, ' ');) {
    const bool is_first = current.find_first_not_of(' ') == std::string::npos;
    if (!is_first && text_width(current) + 1 + text_width(word) > width) {
      text += current + "\n";
      current = std::string(indent, ' ') + word;
    } else {
      current += (is_first ? "" : " ") + word;
    }
  }
  return text + current;
}

}  // namespace

std::string wrapped(const std::string& text, std::size_t width) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    result += (text_width(line) > width ? wrapped_line(line, width) : line) + "\n";
  }
  if (!text.ends_with('\n') && !result.empty()) result.pop_back();
  return result;
}

}  // namespace flatdyn

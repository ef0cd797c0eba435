// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/diagnostics/table.hpp"

#include <algorithm>
#include <utility>

namespace flatdyn {

std::size_t text_width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

void add_row(std::vector<std::vector<std::string>>& rows, std::vector<std::string> cells,
             const std::vector<std::string>& last_cell) {
  for (const std::string& line : last_cell) {
    rows.push_back(cells);
    rows.back().push_back(line);
    cells.assign(cells.size(), "");
  }
}

std::vector<std::string> aligned_lines(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], text_width(row[k]));
  }
  std::vector<std::string> lines;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      line += row[k];
      if (k + 1 < row.size()) line.append(widths[k] - text_width(row[k]) + 2, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string aligned_table(const std::vector<std::vector<std::string>>& rows) {
  std::string text;
  for (const std::string& line : aligned_lines(rows)) text += line + "\n";
  return text;
}

}  // namespace flatdyn

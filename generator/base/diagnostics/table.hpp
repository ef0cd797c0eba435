// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

// The number of characters, not bytes: names may be any UTF-8.
std::size_t text_width(const std::string& text);

// Appends a row whose last cell has several lines, each a row of the table.
void add_row(std::vector<std::vector<std::string>>& rows, std::vector<std::string> cells,
             const std::vector<std::string>& last_cell);

// Rows of text with aligned columns, two blanks between them; the first row is the heading.
std::vector<std::string> aligned_lines(const std::vector<std::vector<std::string>>& rows);

// The aligned lines as one text, each with a line break.
std::string aligned_table(const std::vector<std::vector<std::string>>& rows);

}  // namespace flatdyn

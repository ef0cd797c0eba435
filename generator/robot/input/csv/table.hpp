// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/input/csv/heading.hpp"
#include "robot/input/csv/text.hpp"

namespace flatdyn {

// A table with a heading line; decimals kept as text, so that no digit is lost.
struct CsvTable {
  std::vector<std::string> columns;  // as the heading has them
  std::vector<std::vector<std::string>> rows;
  std::vector<int> lines;  // of each row in the file
  int heading_line = 1;
  DecimalMarks marks{','};

  // The heading of file `file`, which diagnostics name. The table must outlive the heading.
  CsvHeading heading(const std::string& file, const Mechanism& mechanism, Diagnostics& diagnostics) const;
};

// Text of columns, separated by commas, semicolons or tabs; blanks and quotation marks around entries, empty lines and
// lines that begin with # are left out. Wrong column counts and text that is not UTF-8 go to `diagnostics`, with their
// line. Throws Failure(io) for a missing file.
CsvTable read_csv(const std::filesystem::path& path, Diagnostics& diagnostics);

// Entries of these columns get a decimal point. Those that are no finite decimals go to `diagnostics`, and so do
// entries of `heading`'s fixed texts that change.
void check_entries(CsvTable& table, const std::vector<CsvSource>& sources, const CsvHeading& heading,
                   const std::string& file, Diagnostics& diagnostics);

// The times of the rows, s. What is no time goes to `diagnostics`.
std::vector<double> times_of(CsvTable& table, const CsvTime& time, const std::string& file, Diagnostics& diagnostics);

// An entry in SI, exactly.
Number exact_value(const CsvTable& table, std::size_t row, const CsvSource& source);

}  // namespace flatdyn

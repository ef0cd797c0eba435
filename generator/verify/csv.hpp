// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnostics/diagnostics.hpp"
#include "model/mechanism.hpp"

namespace flatdyn {

// A table with a heading line; decimals kept as text, so that no digit is lost.
struct CsvTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<int> lines;  // of each row in the file
};

// Comma-separated; blanks around entries, empty lines and lines that begin with # are skipped. Wrong column counts and
// entries that are no finite decimals go to `diagnostics`, with their line. Throws Failure(io) for a missing file.
CsvTable read_csv(const std::filesystem::path& path, Diagnostics& diagnostics);

// Where each joint's number is: in the column "q1" or "q_JOINT", if `stem` is "q". What is missing goes to
// `diagnostics`.
std::vector<std::size_t> joint_columns(const CsvTable& table, const std::string& stem, const Mechanism& mechanism,
                                       const std::string& file, Diagnostics& diagnostics);

}  // namespace flatdyn

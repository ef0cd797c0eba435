// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace flatdyn::testing {

// The numbers of a CSV file below its heading.
inline std::vector<std::vector<double>> numbers_of(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(csv);
  std::string line, entry;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    rows.emplace_back();
    std::istringstream entries(line);
    while (std::getline(entries, entry, ',')) rows.back().push_back(std::stod(entry));
  }
  return rows;
}

}  // namespace flatdyn::testing

// SPDX-License-Identifier: GPL-2.0-or-later
#include "verify/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

namespace flatdyn {
namespace {

constexpr std::size_t kMostMessages = 20;

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string> entries_of(const std::string& line) {
  std::vector<std::string> entries;
  std::istringstream parts(line);
  for (std::string part; std::getline(parts, part, ',');) entries.push_back(trimmed(part));
  if (!line.empty() && line.back() == ',') entries.emplace_back();
  return entries;
}

bool is_decimal(const std::string& text) {
  try {
    exact_decimal(text);
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

void check_heading(const CsvTable& table, const Place& place, Diagnostics& diagnostics) {
  std::set<std::string> seen;
  for (const std::string& column : table.columns) {
    if (column.empty()) diagnostics.error(place, "a column has no name");
    if (!seen.insert(column).second) diagnostics.error(place, fmt::format("column \"{}\" is there twice", column));
  }
}

void check_row(const CsvTable& table, const std::vector<std::string>& row, const Place& place,
               Diagnostics& diagnostics) {
  if (row.size() != table.columns.size()) {
    diagnostics.error(place,
                      fmt::format("{} entries, but the heading has {} columns", row.size(), table.columns.size()));
    return;
  }
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (!is_decimal(row[k])) {
      diagnostics.error(place, fmt::format("column \"{}\": \"{}\" is not a finite number", table.columns[k], row[k]));
    }
  }
}

}  // namespace

CsvTable read_csv(const std::filesystem::path& path, Diagnostics& diagnostics) {
  std::ifstream file(path);
  if (!file) throw Failure(ExitCode::io, fmt::format("{}: cannot be read", path.string()));
  CsvTable table;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
    const Place place{path.string(), number};
    if (table.columns.empty()) {
      table.columns = entries_of(line);
      check_heading(table, place, diagnostics);
      continue;
    }
    table.rows.push_back(entries_of(line));
    table.lines.push_back(number);
    check_row(table, table.rows.back(), place, diagnostics);
    if (diagnostics.all().size() >= kMostMessages) break;
  }
  if (table.rows.empty()) {
    diagnostics.error({path.string(), 0}, "no states in the file",
                      "a heading such as q1,q2,qd1,qd2 and a line for each state");
  }
  return table;
}

std::vector<std::size_t> joint_columns(const CsvTable& table, const std::string& stem, const Mechanism& mechanism,
                                       const std::string& file, Diagnostics& diagnostics) {
  std::vector<std::size_t> at;
  for (int i = 0; i < mechanism.size(); ++i) {
    const std::string number = fmt::format("{}{}", stem, i + 1);
    const std::string name = fmt::format("{}_{}", stem, mechanism.joints()[static_cast<std::size_t>(i)].joint);
    const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                    [&](const std::string& column) { return column == number || column == name; });
    if (found == table.columns.end()) {
      diagnostics.error({file, 1}, fmt::format("there is no column {} or {}", number, name),
                        fmt::format("the heading names every joint: {0}1,{0}2,… or {0}_JOINT,…", stem));
    }
    at.push_back(static_cast<std::size_t>(found - table.columns.begin()));
  }
  return at;
}

}  // namespace flatdyn

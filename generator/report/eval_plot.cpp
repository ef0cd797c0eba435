// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/eval_plot.hpp"

#include <algorithm>

#include "model/number.hpp"
#include "report/time_table.hpp"

namespace flatdyn {
namespace {

// "B_1" of "B_1_2", "tau" of "tau_3".
std::string stem_of(const std::string& column) { return column.substr(0, column.find_last_of('_')); }

bool is_time(const std::string& column) { return column == "t" || column == "time"; }

TimeTable numbers_of(const CsvTable& table, std::size_t first) {
  const auto time = std::find_if(table.columns.begin(), table.columns.end(), is_time) - table.columns.begin();
  const auto time_column = static_cast<std::size_t>(time);
  const bool has_time = time_column < table.columns.size();
  TimeTable result{{has_time ? "t" : "state"}, {}};
  result.columns.insert(result.columns.end(), table.columns.begin() + static_cast<std::ptrdiff_t>(first),
                        table.columns.end());
  const auto number = [](const std::string& text) { return nearest_double(exact_decimal(text)); };
  for (const std::vector<std::string>& row : table.rows) {
    std::vector<double>& numbers = result.rows.emplace_back();
    numbers.push_back(has_time ? number(row[time_column]) : static_cast<double>(result.rows.size()));
    for (std::size_t k = first; k < row.size(); ++k) numbers.push_back(number(row[k]));
  }
  return result;
}

}  // namespace

std::string eval_plot(const std::string& title, const CsvTable& table, std::size_t first, PictureFormat format) {
  const TimeTable numbers = numbers_of(table, first);
  std::vector<PanelColumns> panels;
  for (std::size_t k = 1; k < numbers.columns.size(); ++k) {
    const std::string stem = stem_of(numbers.columns[k]);
    if (panels.empty() || panels.back().title != stem) panels.push_back({stem, stem, {}, {}});
    panels.back().columns.push_back(k);
    panels.back().names.push_back(numbers.columns[k]);
  }
  return time_plot(title, numbers, panels, format);
}

}  // namespace flatdyn

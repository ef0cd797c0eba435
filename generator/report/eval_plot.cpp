// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/eval_plot.hpp"

#include "report/plot/time_table.hpp"
#include "robot/model/number.hpp"

namespace flatdyn {
namespace {

// The stem of a column's name: "B_1" for "B_1_2", "tau" for "tau_3".
std::string stem_of(const std::string& column) { return column.substr(0, column.find_last_of('_')); }

TimeTable numbers_of(const CsvTable& table, std::size_t first, const std::vector<double>& times) {
  TimeTable result{{times.empty() ? "state" : "t"}, {}};
  result.columns.insert(result.columns.end(), table.columns.begin() + static_cast<std::ptrdiff_t>(first),
                        table.columns.end());
  const auto number = [](const std::string& text) { return nearest_double(exact_decimal(text)); };
  for (const std::vector<std::string>& row : table.rows) {
    std::vector<double>& numbers = result.rows.emplace_back();
    const std::size_t count = result.rows.size();
    numbers.push_back(times.empty() ? static_cast<double>(count) : times[count - 1]);
    for (std::size_t k = first; k < row.size(); ++k) numbers.push_back(number(row[k]));
  }
  return result;
}

}  // namespace

std::string eval_plot(const std::string& title, const CsvTable& table, std::size_t first,
                      const std::vector<double>& times, PictureFormat format) {
  const TimeTable numbers = numbers_of(table, first, times);
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

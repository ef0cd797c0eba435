// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/plot/time_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace flatdyn {
namespace {

constexpr std::size_t kMostPoints = 2000;

// The rows to draw: all of them, or the first of each group and those where the column is least and greatest in it.
std::vector<std::size_t> drawn_rows(const std::vector<double>& values) {
  std::vector<std::size_t> rows;
  const std::size_t step = std::max<std::size_t>(1, 3 * values.size() / kMostPoints);
  for (std::size_t begin = 0; begin < values.size(); begin += step) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = values.begin() + static_cast<std::ptrdiff_t>(std::min(begin + step, values.size()));
    const auto [least, greatest] = std::minmax_element(first, last);
    std::vector<std::size_t> of_group = {begin};
    for (const auto at : {least, greatest}) of_group.push_back(static_cast<std::size_t>(at - values.begin()));
    std::sort(of_group.begin(), of_group.end());
    rows.insert(rows.end(), of_group.begin(), std::unique(of_group.begin(), of_group.end()));
  }
  if (rows.empty() || rows.back() + 1 != values.size()) rows.push_back(values.size() - 1);
  return rows;
}

Series drawn_series(const TimeTable& table, std::size_t column, const std::string& name) {
  Series series{name, {}, {}};
  const std::vector<double> times = table.column(0), values = table.column(column);
  for (const std::size_t row : drawn_rows(values)) {
    series.x.push_back(times[row]);
    series.y.push_back(values[row]);
  }
  return series;
}

}  // namespace

std::vector<double> TimeTable::column(std::size_t index) const {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const std::vector<double>& row : rows) values.push_back(row[index]);
  return values;
}

std::string csv_text(const TimeTable& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.columns, ","));
  for (const std::vector<double>& row : table.rows) {
    // Adding 0.0 avoids negative zeros.
    for (std::size_t k = 0; k < row.size(); ++k) {
      fmt::format_to(std::back_inserter(text), "{}{}", k == 0 ? "" : ",", row[k] + 0.0);
    }
    text += '\n';
  }
  return text;
}

std::string time_plot(const std::string& title, const TimeTable& table, const std::vector<PanelColumns>& panels,
                      PictureFormat format) {
  std::vector<Panel> drawn;
  for (const PanelColumns& panel : panels) {
    drawn.push_back({panel.title, "", panel.y_label, {}});
    for (std::size_t k = 0; k < panel.columns.size(); ++k) {
      drawn.back().series.push_back(drawn_series(table, panel.columns[k], panel.names[k]));
    }
  }
  drawn.back().x_label = table.columns.front() == "t" ? "t in s" : table.columns.front();
  return plot(title, drawn, format);
}

PictureFormat picture_format(const std::string& file) {
  return std::filesystem::path(file).extension() == ".png" ? PictureFormat::png : PictureFormat::svg;
}

std::string unit_of(const Mechanism& mechanism, const std::string& turning, const std::string& sliding) {
  const auto slides = [](const Body& body) { return body.prismatic; };
  const auto count = std::count_if(mechanism.joints().begin(), mechanism.joints().end(), slides);
  if (count == 0) return turning;
  return count == mechanism.size() ? sliding : turning + ", " + sliding;
}

std::string unit_of_positions(const Mechanism& mechanism) {
  const bool is_mixed = mechanism.has_loops() && mechanism.has_prismatic_joint();
  return is_mixed ? "rad, m" : unit_of(mechanism, "rad", "m");
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Time histories: named columns of numbers, the first one time, as CSV and as pictures.
#pragma once

#include <string>
#include <vector>

#include "report/plot/plot.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

struct TimeTable {
  std::vector<std::string> columns;       // "t" or its substitute first
  std::vector<std::vector<double>> rows;  // by increasing time in s

  std::vector<double> column(std::size_t index) const;
};

// The table as CSV. Every number is the shortest text that reads back exactly.
std::string csv_text(const TimeTable& table);

// The curves of one panel: columns of the table, and their names in the key.
struct PanelColumns {
  std::string title, y_label;
  std::vector<std::size_t> columns;
  std::vector<std::string> names;
};

// Panels over time below each other. For long tables every n-th row is drawn, and the extremes between. Throws
// Failure(io) if there is no gnuplot.
std::string time_plot(const std::string& title, const TimeTable& table, const std::vector<PanelColumns>& panels,
                      PictureFormat format);

// The format by the file's extension, .svg or .png.
PictureFormat picture_format(const std::string& file);

// The unit of a quantity: that of revolute joints, that of prismatic ones, or both if the robot has both kinds.
std::string unit_of(const Mechanism& mechanism, const std::string& turning, const std::string& sliding);
// The unit of q: dependent joints of closed loops may be prismatic when the independent ones are revolute.
std::string unit_of_positions(const Mechanism& mechanism);

}  // namespace flatdyn

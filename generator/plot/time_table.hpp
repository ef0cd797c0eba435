// SPDX-License-Identifier: GPL-2.0-or-later
// Time histories: columns of numbers with names, the first one time, as CSV and as pictures.
#pragma once

#include <string>
#include <vector>

#include "model/mechanism.hpp"
#include "plot/plot.hpp"

namespace flatdyn {

struct TimeTable {
  std::vector<std::string> columns;       // "t" first, or what stands for it
  std::vector<std::vector<double>> rows;  // by time, s

  std::vector<double> column(std::size_t index) const;
};

// Every number as short as it can be read back exactly.
std::string csv_text(const TimeTable& table);

// Curves of one panel: columns of the table and the names that they go by in the key.
struct PanelColumns {
  std::string title, y_label;
  std::vector<std::size_t> columns;
  std::vector<std::string> names;
};

// Panels over time below each other. Of long tables every n-th row is drawn, and the extremes between.
std::string time_plot(const std::string& title, const TimeTable& table, const std::vector<PanelColumns>& panels,
                      PictureFormat format);

// By the file's extension: .svg or .png.
PictureFormat picture_format(const std::string& file);

// "rad", "m", or both for a robot that has both kinds of joints.
std::string unit_of(const Mechanism& mechanism, const std::string& turning, const std::string& sliding);
// Of q: dependent joints of closed loops may slide where the independent ones turn.
std::string unit_of_positions(const Mechanism& mechanism);

}  // namespace flatdyn

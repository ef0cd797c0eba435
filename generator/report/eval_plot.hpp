// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "report/plot/plot.hpp"
#include "robot/input/csv/table.hpp"

namespace flatdyn {

// A picture of the results of `eval`: the columns from `first` on, over `times` (s, one per row) or, if there are none,
// over the rows' numbers. One panel per vector, or per row of a matrix. Returns the bytes.
std::string eval_plot(const std::string& title, const CsvTable& table, std::size_t first,
                      const std::vector<double>& times, PictureFormat format);

}  // namespace flatdyn

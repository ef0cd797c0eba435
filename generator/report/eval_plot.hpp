// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "input/csv/table.hpp"
#include "plot/plot.hpp"

namespace flatdyn {

// What `eval` has computed: the columns from `first` on, over `times` (s; of each row), or over the rows' numbers if
// there are none. One panel per vector, or per row of a matrix.
std::string eval_plot(const std::string& title, const CsvTable& table, std::size_t first,
                      const std::vector<double>& times, PictureFormat format);

}  // namespace flatdyn

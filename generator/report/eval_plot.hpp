// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "report/plot.hpp"
#include "verify/csv.hpp"

namespace flatdyn {

// What `eval` has computed: the columns from `first` on, over the column t or time, else over the rows' numbers. One
// panel per vector, or per row of a matrix.
std::string eval_plot(const std::string& title, const CsvTable& table, std::size_t first, PictureFormat format);

}  // namespace flatdyn

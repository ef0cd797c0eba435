// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "laboratory/bench/bench.hpp"

namespace flatdyn {

// Plots time against error, a panel per robot and function. Returns SVG.
std::string bench_plot(const std::vector<BenchReport>& reports);

}  // namespace flatdyn

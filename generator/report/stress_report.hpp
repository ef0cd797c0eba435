// SPDX-License-Identifier: GPL-2.0-or-later
// The results of `flatdyn stress`, for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "laboratory/stress/stress.hpp"

namespace flatdyn {

std::string stress_text(const StressReport& report);
nlohmann::ordered_json stress_json(const StressReport& report);
// Error against condition number, and the distribution of errors, as SVG. Throws Failure(io) if there is no gnuplot.
std::string stress_plot(const StressReport& report);
// A line for each empty panel: a scalar whose errors are all zero has no place on logarithmic axes.
std::string left_out_of_plot(const StressReport& report);
// A state as a table for `flatdyn eval`.
std::string state_csv(const StressReport& report, const StressRow& row, const State& state);

}  // namespace flatdyn

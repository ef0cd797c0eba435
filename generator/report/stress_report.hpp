// SPDX-License-Identifier: GPL-2.0-or-later
// What `flatdyn stress` found, for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "stress/stress.hpp"

namespace flatdyn {

std::string stress_text(const StressReport& report);
nlohmann::ordered_json stress_json(const StressReport& report);
// Error against condition, and how often errors are how large, as SVG. Throws Failure(io) where there is no gnuplot.
std::string stress_plot(const StressReport& report);
// What is empty in it, a line each: a scalar in which every error is zero has no place on its axes.
std::string left_out_of_plot(const StressReport& report);
// A state as a table for `flatdyn eval`.
std::string state_csv(const StressReport& report, const StressRow& row, const State& state);

}  // namespace flatdyn

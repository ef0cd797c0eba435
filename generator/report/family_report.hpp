// SPDX-License-Identifier: GPL-2.0-or-later
// The results of `flatdyn stress --family`, for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "laboratory/stress/families.hpp"

namespace flatdyn {

std::string family_text(const FamilyReport& report);
nlohmann::ordered_json family_json(const FamilyReport& report);
// Errors over the extreme quantity, as SVG. Throws Failure(io) if there is no gnuplot.
std::string family_plot(const FamilyReport& report);

}  // namespace flatdyn

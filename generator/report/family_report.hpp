// SPDX-License-Identifier: GPL-2.0-or-later
// What `flatdyn stress --family` found, for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "stress/families.hpp"

namespace flatdyn {

std::string family_text(const FamilyReport& report);
nlohmann::ordered_json family_json(const FamilyReport& report);
// Errors over what goes to the extreme, as SVG. Throws Failure(io) where there is no gnuplot.
std::string family_plot(const FamilyReport& report);

}  // namespace flatdyn

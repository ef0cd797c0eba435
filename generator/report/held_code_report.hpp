// SPDX-License-Identifier: GPL-2.0-or-later
// The findings of `flatdyn verify --header`, as messages, as a table and as JSON.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "base/diagnostics/diagnostics.hpp"
#include "proof/verify/held_code.hpp"

namespace flatdyn {

// The file and the line in it of a line of the held text.
using PlaceOfLine = std::function<Place(int line)>;

// Adds an error for each statement that is not the robot's, and for each function that is missing or too many.
void add_findings(const HeldReport& report, const PlaceOfLine& place, const std::string& robot, Diagnostics& findings);

// A table of the functions, and whether they are the robot's. `name`: the header's.
std::string to_text(const HeldReport& report, const std::string& name);
nlohmann::ordered_json to_json(const HeldReport& report, const PlaceOfLine& place, const std::string& version);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The results of an identification, for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "identify/identification.hpp"

namespace flatdyn {

// Sentences on results that are hardly right, each with a possible reason.
std::vector<std::string> plausibility_warnings(const TorqueModel& model, const Identification& found);

std::string describe_identification(const TorqueEquations& equations, const Identification& found);
nlohmann::ordered_json identification_json(const TorqueEquations& equations, const Identification& found);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The results of an identification, for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "derivation/parameters/parameter_frames.hpp"
#include "laboratory/identify/identification.hpp"

namespace flatdyn {

// Sentences on results that are hardly right, each with a possible reason.
std::vector<std::string> plausibility_warnings(const TorqueModel& model, const Identification& found);

// Sentences on what the search for unknowns in which the torques are not linear did not find.
std::vector<std::string> search_warnings(const NonlinearUnknowns& unknowns, const TorqueModel& model);

// A sentence on joints whose temperatures hardly change, so that friction at another one is not told.
std::vector<std::string> temperature_warnings(const TorqueEquations& equations, const Estimate& estimate);

// Base parameters are written as combinations of parameters in `frames`.
std::string describe_identification(const TorqueEquations& equations, const Identification& found,
                                    ParameterFrames frames);
nlohmann::ordered_json identification_json(const TorqueEquations& equations, const Identification& found,
                                           ParameterFrames frames);

}  // namespace flatdyn

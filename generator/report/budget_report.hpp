// SPDX-License-Identifier: GPL-2.0-or-later
// The savings of an error budget, and the errors accepted for them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "functions/load/loaded_robot.hpp"
#include "proof/verify/torque_deviation.hpp"

namespace flatdyn {

// A table of the proven bounds beside the largest deviations found.
std::string describe_abbreviation(const LoadedRobot& model, const TorqueDeviation& seen);
nlohmann::ordered_json abbreviation_json(const LoadedRobot& model, const TorqueDeviation& seen);

// The text of `verify`, with that table below the functions.
std::string to_text(const AbbreviationReport& report, const LoadedRobot& model);
nlohmann::ordered_json to_json(const AbbreviationReport& report, const LoadedRobot& model);

}  // namespace flatdyn

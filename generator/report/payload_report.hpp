// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "laboratory/identify/payload.hpp"

namespace flatdyn {

// Throws Failure(input) if the logs determine nothing of the payload.
void require_told(const LoadedRobot& robot, const FittedPayload& found);

// Sentences on estimates that no payload explains, on logs that a floating base can hardly have, and on a mass that is
// not determined; none for others. `hint`: a possible reason of a negative mass.
std::vector<std::string> plausibility_warnings(const LoadedRobot& robot, const FittedPayload& found,
                                               const std::string& hint);

std::string describe_payload(const LoadedRobot& robot, const FittedPayload& found);
nlohmann::ordered_json payload_json(const LoadedRobot& robot, const FittedPayload& found);

// TOML over the robot file: `warning_texts` as comments, `settings` (lines that repeat the options that shaped the
// model), and [payload] on the tip's link.
std::string payload_robot_text(const LoadedRobot& robot, const PayloadEstimate& payload,
                               const std::filesystem::path& file, const std::vector<std::string>& settings,
                               const std::vector<std::string>& warning_texts);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "identify/payload.hpp"

namespace flatdyn {

std::string describe_payload(const Model& robot, const PayloadEstimate& payload);
nlohmann::ordered_json payload_json(const Model& robot, const PayloadEstimate& payload);

// TOML over the robot file: `settings` (lines that repeat the options that shaped the model) and [payload] on the tip's
// link.
std::string payload_robot_text(const Model& robot, const PayloadEstimate& payload, const std::filesystem::path& file,
                               const std::vector<std::string>& settings);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "laboratory/identify/drive_gains.hpp"

namespace flatdyn {

// Sentences on gains that can hardly be right; none for others.
std::vector<std::string> gain_warnings(const LoadedRobot& robot, const DriveGains& found);

std::string describe_drive_gains(const LoadedRobot& robot, const DriveGains& found);
nlohmann::ordered_json drive_gains_json(const LoadedRobot& robot, const DriveGains& found);

// A scene with [current_to_torque] of all joints whose gain the logs tell: `warning_texts` as comments.
std::string gains_scene_text(const LoadedRobot& robot, const DriveGains& found,
                             const std::vector<std::string>& warning_texts);

}  // namespace flatdyn

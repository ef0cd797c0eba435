// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "laboratory/stress/random_robots.hpp"

namespace flatdyn {

std::string random_robots_text(const RandomRobotsReport& report);
nlohmann::ordered_json random_robots_json(const RandomRobotsReport& report);

}  // namespace flatdyn

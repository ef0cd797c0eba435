// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "laboratory/bench/gpu.hpp"

namespace flatdyn {

// The device, a row per robot, function, layout and scalar, and what could not be compiled or run.
std::string gpu_text(const GpuReport& report);
nlohmann::ordered_json gpu_json(const GpuReport& report);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "laboratory/bench/growth.hpp"

namespace flatdyn {

// A table per shape and function, with the fitted exponents.
std::string growth_text(const GrowthReport& report);
nlohmann::ordered_json growth_json(const GrowthReport& report);

// Operations, time of a call, generation, compilation and compiler memory over the number of joints, as SVG.
std::string growth_plot(const GrowthReport& report);

}  // namespace flatdyn

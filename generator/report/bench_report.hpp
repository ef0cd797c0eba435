// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "laboratory/bench/bench.hpp"

namespace flatdyn {

// A table per function, with its variants sorted by time.
std::string bench_text(const BenchReport& report);
nlohmann::ordered_json bench_json(const BenchReport& report);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Times and numbers of operations in JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "graph/count.hpp"
#include "laboratory/bench/statistics.hpp"

namespace flatdyn {

inline nlohmann::ordered_json quartiles_json(const Quartiles& time) {
  return {{"low", time.low}, {"median", time.median}, {"high", time.high}};
}

inline nlohmann::ordered_json operations_json(const OperationCount& count) {
  return {{"mul", count.multiplications},
          {"add", count.additions},
          {"div", count.divisions},
          {"sincos", count.trigonometric}};
}

}  // namespace flatdyn

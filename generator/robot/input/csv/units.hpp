// SPDX-License-Identifier: GPL-2.0-or-later
// Units that stand in the headings of CSV files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/model/number.hpp"

namespace flatdyn {

// The quantity that a column measures.
enum class CsvDimension {
  none,  // nothing that is known: no unit is
  time,
  angle,
  angle_rate,
  angle_acceleration,
  length,
  length_rate,
  length_acceleration,
  force,
  moment,
  current,
  temperature  // in °C: others do not differ by a factor alone
};

// The factor that converts a number in this unit to SI: deg is pi/180, exactly. Written as people do: "deg/s^2",
// "°/s²", "N m", "Nm", "N*m". nullopt if it is not a unit of the dimension.
std::optional<Number> unit_factor(const std::string& unit, CsvDimension dimension);

// The units of the dimension, SI first.
std::vector<std::string> known_units(CsvDimension dimension);

}  // namespace flatdyn

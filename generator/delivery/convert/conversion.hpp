// SPDX-License-Identifier: GPL-2.0-or-later
// Robot → the text of a robot file that says the same.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

struct Conversion {
  std::string text;
  std::vector<std::string> rounded;  // the places whose numbers are no finite decimals, and were rounded
};

// Errors say what the format cannot say; the text is then of no use.
Conversion urdf_of(const Robot& robot, Diagnostics& diagnostics);
Conversion toml_of(const Robot& robot, Diagnostics& diagnostics);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The robots of robots/ as models.
#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include "functions/load/load_robot.hpp"

namespace flatdyn::testing {

inline LoadedRobot model_of(const std::string& file) {
  return load_robot(std::filesystem::path(FLATDYN_SOURCE_DIR) / "robots" / file, {});
}

// The text of a robot file, for changes.
inline std::string text_of_robot(const std::string& file) {
  std::ifstream stream(std::filesystem::path(FLATDYN_SOURCE_DIR) / "robots" / file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace flatdyn::testing

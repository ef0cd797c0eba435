// SPDX-License-Identifier: GPL-2.0-or-later
// A robot as a person writes it, as a model.
#pragma once

#include <fstream>
#include <string>

#include "load/load_robot.hpp"
#include "system/temporary_folder.hpp"

namespace flatdyn::testing {

inline LoadedRobot model_of_toml(const std::string& text) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "robot.toml";
  std::ofstream(file) << text;
  return load_robot(file, {});
}

}  // namespace flatdyn::testing

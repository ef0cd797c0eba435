// SPDX-License-Identifier: GPL-2.0-or-later
// A robot as a person writes it, as a model.
#pragma once

#include <fstream>
#include <string>

#include "base/system/temporary_folder.hpp"
#include "functions/load/load_robot.hpp"

namespace flatdyn::testing {

inline LoadedRobot model_of_text(const std::string& text, const std::string& name) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / name;
  std::ofstream(file) << text;
  return load_robot(file, {});
}

inline LoadedRobot model_of_toml(const std::string& text) { return model_of_text(text, "robot.toml"); }
inline LoadedRobot model_of_urdf(const std::string& text) { return model_of_text(text, "robot.urdf"); }

}  // namespace flatdyn::testing

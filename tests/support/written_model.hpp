// SPDX-License-Identifier: GPL-2.0-or-later
// A robot as a person writes it, read.
#pragma once

#include <fstream>
#include <string>

#include "diagnostics/temporary_folder.hpp"
#include "pipeline.hpp"

namespace flatdyn::testing {

inline Model model_of_toml(const std::string& text) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "robot.toml";
  std::ofstream(file) << text;
  return read_model(file, {});
}

}  // namespace flatdyn::testing

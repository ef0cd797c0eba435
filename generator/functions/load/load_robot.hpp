// SPDX-License-Identifier: GPL-2.0-or-later
// Robot file → Robot → Mechanism: the stages before the derivation.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "functions/load/bad_input.hpp"
#include "functions/load/loaded_robot.hpp"
#include "robot/input/common/read_options.hpp"

namespace flatdyn {

struct LoadOptions {
  ReadOptions read;
  bool warnings_are_errors = false;
  std::vector<std::string> functions;  // empty: those of the scene; without one: default_function_names
  bool skip_error_budget = false;      // ignores the scene's error budget
};

// Reads the robot and makes it canonical. Throws BadInput, which carries the diagnostics, for errors in the input.
LoadedRobot load_robot(const std::filesystem::path& path, const LoadOptions& options);

// The functions that the command line asks for, else those of the scene; empty if neither asks for any.
std::vector<std::string> functions_asked_for(const std::vector<std::string>& on_command_line, const Scene& scene);

}  // namespace flatdyn

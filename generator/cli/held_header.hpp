// SPDX-License-Identifier: GPL-2.0-or-later
// `flatdyn verify --header`: code that a user holds, compared with what its robot has.
#pragma once

#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "pipeline/generation.hpp"

namespace flatdyn {

// The options on the command line, which count more than those of a stamp.
struct OptionsGiven : RobotArguments {
  std::vector<std::string> functions;

  // Writes those that are given over others.
  void replace_in(RobotArguments& stamped) const;
};

// The options of `generate` with which code was written: those of its stamp, such as {"--language=c", "--fma"}, and
// those given. Throws CLI::ParseError or Failure(usage) if `generate` has no such options.
GenerationOptions options_of_stamp(const std::vector<std::string>& stamp, const OptionsGiven& given);

// Compares the code, and prints what differs.
ExitCode verify_header(const std::string& header, const OptionsGiven& given);

}  // namespace flatdyn

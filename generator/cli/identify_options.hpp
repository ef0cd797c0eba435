// SPDX-License-Identifier: GPL-2.0-or-later
// The arguments of `flatdyn identify`, and the checks of those that cannot be together.
#pragma once

#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "laboratory/identify/identification.hpp"

namespace flatdyn {

struct IdentifyArguments : RobotArguments {
  std::vector<std::string> logs, parts;
  std::string output, part;
  std::string parameters;
  std::string frames = "file";
  StreamOptions stream;
  IdentificationOptions identification;
  FurtherParameters further;
  std::string friction = "coulomb", estimator = "ls";
  bool delay = false, gravity_direction = false;
  bool robust = false;
  std::vector<std::string> validation;
  std::string plot, validation_plot, covariance, signals, module;

  // The file that is read first.
  const std::string& source() const { return logs.empty() ? parts.front() : logs.front(); }
};

void add_identify_options(CLI::App& command, IdentifyArguments& arguments);

// Sets what words of the arguments stand for, and refuses options that exclude each other: Failure(usage).
void settle(IdentifyArguments& arguments);
// Refuses options that this robot has no use for, by Failure(usage) or Failure(unsupported).
void check_options_for(const Mechanism& mechanism, const IdentifyArguments& arguments);
// Refuses laws of friction where no friction is identified: Failure(usage).
void require_friction(const Mechanism& mechanism, const IdentifyArguments& arguments);
// Refuses outputs that would replace an input or each other: Failure(usage).
void check_files(const IdentifyArguments& arguments, const Robot& robot);

}  // namespace flatdyn

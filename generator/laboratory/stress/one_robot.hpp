// SPDX-License-Identifier: GPL-2.0-or-later
// One random robot: from its file to its functions and their text, and their errors against the reference.
#pragma once

#include <filesystem>
#include <memory>

#include "code/readback/straight_line.hpp"
#include "functions/deviation/expected.hpp"
#include "laboratory/stress/random_robots.hpp"

namespace flatdyn {

// A robot read from a file of its own, with functions in random formulations, and their text read back.
class OneRobot {
 public:
  // `seed` selects formulations and states. Throws BadInput if the file is refused; functions that the robot cannot
  // have are left out.
  OneRobot(const PlainRobot& robot, unsigned seed, bool is_usual, const RandomRobotsOptions& options,
           const std::filesystem::path& folder);

  const LoadedRobot& model() const { return model_; }
  const std::vector<Function>& functions() const { return functions_; }
  const std::vector<State>& states() const { return states_; }
  const std::string& name_space() const { return name_space_; }
  const std::string& header() const { return header_; }

  // The values of function k: its text executed in double.
  std::vector<double> executed(std::size_t k, const State& state) const;
  // The scaled error of values of function k; infinite where the function reports that it has no value.
  double error(std::size_t k, const State& state, const std::vector<double>& values) const;

 private:
  LoadedRobot model_;
  std::string name_space_, header_;
  std::vector<Function> functions_;
  std::vector<StraightLine> lines_;
  std::vector<State> states_;
  std::unique_ptr<ExpectedValues> reference_;
  std::vector<Expected> expected_;
};

// Checks the text as executed and the witness; returns a fault if there is one, and adds to the report's worst errors.
std::optional<RandomRobotFault> fault_of(const OneRobot& robot, const RandomRobotsOptions& options,
                                         RandomRobotsReport& report);

// Checks values of one function against the bound; returns a fault if the error is above it, and records the worst
// error.
std::optional<RandomRobotFault> fault_of(const OneRobot& robot, std::size_t function, const State& state,
                                         const std::vector<double>& values, RandomRobotFault::How how,
                                         const RandomRobotsOptions& options, RandomRobotsReport& report);

}  // namespace flatdyn

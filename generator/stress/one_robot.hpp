// SPDX-License-Identifier: GPL-2.0-or-later
// One random robot: from its file to its functions and their text, and what they come to against the reference.
#pragma once

#include <filesystem>
#include <memory>

#include "readback/straight_line.hpp"
#include "reference/expected.hpp"
#include "stress/random_robots.hpp"

namespace flatdyn {

// A robot as read from a file of its own, with functions in some form, and their text read back.
class OneRobot {
 public:
  // `seed` draws forms and states. Throws BadInput if the file is refused; functions that the robot cannot have are
  // left out.
  OneRobot(const PlainRobot& robot, unsigned seed, bool is_usual, const RandomRobotsOptions& options,
           const std::filesystem::path& folder);

  const LoadedRobot& model() const { return model_; }
  const std::vector<Function>& functions() const { return functions_; }
  const std::vector<State>& states() const { return states_; }
  const std::string& name_space() const { return name_space_; }
  const std::string& header() const { return header_; }

  // Of function k, from its text carried out in double.
  std::vector<double> carried_out(std::size_t k, const State& state) const;
  // Of values of function k: the scaled error; infinite where the function does not hold.
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

// What is wrong with it, from its text carried out and from the witness; adds to the report's worst errors.
std::optional<RandomRobotFault> fault_of(const OneRobot& robot, const RandomRobotsOptions& options,
                                         RandomRobotsReport& report);

// What is wrong with values of one function, if their error is above the bound; remembers the worst.
std::optional<RandomRobotFault> fault_of(const OneRobot& robot, std::size_t function, const State& state,
                                         const std::vector<double>& values, RandomRobotFault::How how,
                                         const RandomRobotsOptions& options, RandomRobotsReport& report);

}  // namespace flatdyn

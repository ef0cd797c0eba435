// SPDX-License-Identifier: GPL-2.0-or-later
// Random robots, from file to emitted code, compared with the recursive reference; failing robots are simplified as far
// as possible.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "functions/load/loaded_robot.hpp"
#include "graph/function.hpp"
#include "laboratory/stress/plain_robot.hpp"
#include "robot/model/states.hpp"

namespace flatdyn {

// The name of this family, in addition to those of family_table().
inline constexpr const char* kRandomFamily = "random";

// The values of a robot's functions at a state: entries of all outputs, one vector per function.
struct RandomRobotValues {
  const LoadedRobot& model;
  const std::vector<Function>& functions;
  const State& state;
  std::vector<std::vector<double>> values;
};

struct RandomRobotsOptions {
  int robots = 1000;
  unsigned seed = 1;  // seed of the first robot; each next robot has the next seed
  std::vector<std::string> functions = {"inverse_dynamics", "inertia_matrix", "gravity", "forward_dynamics"};
  int states = 2;            // random states per robot
  double bound = 64;         // largest scaled error allowed
  int compiled_one_in = 10;  // one in so many robots is compiled; the text of the others is read back and executed
  // One in so many robots gets the functions that `generate` writes; the others random formulations
  int usual_one_in = 200;

  // A faulty pass, for tests of this check.
  std::function<Function(const Function&)> corrupt;
  // An independent check of the values: returns the largest scaled error. Called for every state.
  std::function<double(const RandomRobotValues&)> witness;
};

// A wrong result, and how it was found.
struct RandomRobotFault {
  enum class How { text, compiled, witness };
  How how = How::text;
  std::string function;  // empty for the witness, which checks all functions
  double error = 0;      // scaled error

  // Whether the other fault is of the same function and found in the same way. A robot without masses, for example, has
  // other faults that do not matter.
  bool is_like(const RandomRobotFault& other) const { return how == other.how && function == other.function; }
};

// "forward_dynamics, compiled: scaled error 1e+15"
std::string to_string(const RandomRobotFault& fault);

// A robot with a wrong result.
struct RandomRobotFailure {
  unsigned seed = 0;
  RandomRobotFault first, last;  // the faults of the robot as drawn, and of the smallest one
  PlainRobot drawn, smallest;
  std::string file;  // the smallest robot as TOML, with comments
};

struct RandomRobotsReport {
  RandomRobotsOptions options;
  int robots = 0, joints = 0;               // number of robots, and of all their joints
  int chains = 0, compiled = 0, usual = 0;  // robots of each kind
  std::vector<double> worst;                // largest scaled error, one per function of the options
  double worst_witnessed = 0;
  std::vector<RandomRobotFailure> failures;
  bool passed() const { return failures.empty(); }
};

// Checks random robots. Stops after some failures, since simplifying each takes time. Throws Failure(io) if there is no
// compiler.
RandomRobotsReport stress_random_robots(const RandomRobotsOptions& options, Progress& progress);

}  // namespace flatdyn

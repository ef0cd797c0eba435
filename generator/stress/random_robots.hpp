// SPDX-License-Identifier: GPL-2.0-or-later
// Random robots, from file to emitted code, against the recursive reference; what differs is made as small as it can
// be.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/progress.hpp"
#include "graph/function.hpp"
#include "load/loaded_robot.hpp"
#include "model/states.hpp"
#include "stress/plain_robot.hpp"

namespace flatdyn {

// As a name beside those of family_table().
inline constexpr const char* kRandomFamily = "random";

// What a robot's functions come to at a state: entries of all outputs, by function.
struct RandomRobotValues {
  const LoadedRobot& model;
  const std::vector<Function>& functions;
  const State& state;
  std::vector<std::vector<double>> values;
};

struct RandomRobotsOptions {
  int robots = 1000;
  unsigned seed = 1;  // of the first; the next has the next
  std::vector<std::string> functions = {"inverse_dynamics", "inertia_matrix", "gravity", "forward_dynamics"};
  int states = 2;            // random ones, of each
  double bound = 64;         // largest scaled error allowed
  int compiled_one_in = 10;  // robots whose text is compiled, too; of the others it is read back and carried out
  int usual_one_in = 200;    // robots that get the functions that `generate` writes; the others are derived in some way

  // For tests of all this: what a pass with a mistake would make of a function.
  std::function<Function(const Function&)> spoil;
  // Somebody else who knows what the values have to be: returns the largest scaled error. Called for every state.
  std::function<double(const RandomRobotValues&)> witness;
};

// One result that is not what it has to be, and how it was found.
struct RandomRobotFault {
  enum class How { text, compiled, witness };
  How how = How::text;
  std::string function;  // empty for the witness, who looks at all of them
  double error = 0;      // scaled

  // Of the same function, found in the same way: what else a robot without masses has wrong with it is another story.
  bool is_like(const RandomRobotFault& other) const { return how == other.how && function == other.function; }
};

// "forward_dynamics, compiled: scaled error 1e+15"
std::string to_string(const RandomRobotFault& fault);

// A robot of which something is not what it has to be.
struct RandomRobotFailure {
  unsigned seed = 0;
  RandomRobotFault first, last;  // what was found of the robot as drawn, and of the smallest
  PlainRobot drawn, smallest;
  std::string file;  // of the smallest, as TOML, saying what it is
};

struct RandomRobotsReport {
  RandomRobotsOptions options;
  int robots = 0, joints = 0;               // that were looked at; in all
  int chains = 0, compiled = 0, usual = 0;  // robots of the kind
  std::vector<double> worst;                // scaled error, by function of the options
  double worst_witnessed = 0;
  std::vector<RandomRobotFailure> failures;
  bool passed() const { return failures.empty(); }
};

// Stops after some failures: each takes time to be made small. Throws Failure(io) if there is no compiler.
RandomRobotsReport stress_random_robots(const RandomRobotsOptions& options, Progress& progress);

}  // namespace flatdyn

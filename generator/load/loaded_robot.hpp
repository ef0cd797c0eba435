// SPDX-License-Identifier: GPL-2.0-or-later
// A robot as read from its file and as made canonical, with what its scene leaves of it.
#pragma once

#include <optional>
#include <string>

#include "diagnostics/diagnostics.hpp"
#include "model/mechanism.hpp"
#include "model/robot.hpp"
#include "scene/abbreviate.hpp"

namespace flatdyn {

struct LoadedRobot {
  Robot robot;
  Mechanism mechanism;
  std::optional<Abbreviation> abbreviation;  // if the scene has an error budget
  Diagnostics diagnostics;                   // warnings and notes, for whoever reports
  std::string input_hash;  // of the texts of the robot file, of one that it names, and of the scene file
};

// The mechanism that functions are derived from: the robot's, or as much of it as the error budget leaves.
const Mechanism& effective_mechanism(const LoadedRobot& model);

// The same robot without the restrictions that its scene puts on functions: they have all entries, hold at any speed,
// and know no error budget.
LoadedRobot without_scene_restrictions(LoadedRobot model);

// Throws Failure(unsupported) if the robot has free symbols. what: the thing that needs their values, "a simulation".
void require_numbers(const Robot& robot, const std::string& what);

// Throws Failure(unsupported) for robots with closed loops that are no linear couplings. `what`: "simulate".
void refuse_loops(const LoadedRobot& model, const std::string& what);

}  // namespace flatdyn

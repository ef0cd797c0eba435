// SPDX-License-Identifier: GPL-2.0-or-later
// A robot as read from its file, its canonical form, and the model that its scene leaves.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics/diagnostics.hpp"
#include "functions/scene/abbreviate.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

struct LoadedRobot {
  Robot robot;
  Mechanism mechanism;
  std::optional<Abbreviation> abbreviation;  // if the scene has an error budget
  Diagnostics diagnostics;                   // warnings and notes, to be printed by the caller
  std::string input_hash;  // the hash of the texts of the robot file, of a file that it names, and of the scene file
};

// The mechanism that functions are derived from: the robot's, or its abbreviation if there is an error budget.
const Mechanism& effective_mechanism(const LoadedRobot& model);

// The same robot without the restrictions that its scene puts on functions: they have all entries, hold at any speed,
// and use no error budget.
LoadedRobot without_scene_restrictions(LoadedRobot model);

// Throws Failure(unsupported) if the robot has free symbols. `what`: the task that needs their values, "a simulation".
void require_numbers(const Robot& robot, const std::string& what);

// Throws Failure(unsupported) for robots with closed loops that are not linear couplings. `what`: "simulate".
void refuse_loops(const LoadedRobot& model, const std::string& what);
// The same for robots with spherical joints.
void refuse_spherical_joints(const LoadedRobot& model, const std::string& what);
// The same for robots with a floating base.
void refuse_floating_base(const LoadedRobot& model, const std::string& what);

// Throws Failure(unsupported) if a joint has a spring, naming `what` does not support it. remedy: another one,
// "--springs estimates them; ".
void refuse_springs(const LoadedRobot& model, const std::string& what, const std::string& remedy = "");

}  // namespace flatdyn

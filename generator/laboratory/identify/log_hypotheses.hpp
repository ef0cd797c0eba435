// SPDX-License-Identifier: GPL-2.0-or-later
// Ways in which a log may be other than it says, or a robot other than its file, each as a fit to the rows of a sample.
#pragma once

#include <string>

#include "functions/load/loaded_robot.hpp"
#include "laboratory/identify/row_sample.hpp"

namespace flatdyn {

struct LogHypothesis {
  std::function<HypothesisFit()> fit;
  std::function<std::string(const HypothesisFit&)> text;  // such as: joint "elbow": its torques look exchanged
  bool is_gain = false;                                   // of one joint's torques, or a change of their sign
};

// All that there are for the robot and are not in the law of friction, simple ones first. Model, robot and sample live
// as long as the result.
std::vector<LogHypothesis> log_hypotheses(const LoadedRobot& robot, const RowSample& sample, FrictionLaw law);

// Torques of the equations `first` up to `end` that are late by an unknown time, s. Rows for which the log has no
// torques at that time count like the others.
Hypothesis delay_hypothesis(const RowSample& sample, int first, int end);

// Whether gravity is separate from the motion, and looked for: with a floating base, it is part of the acceleration.
bool has_own_gravity(const Mechanism& mechanism);

}  // namespace flatdyn

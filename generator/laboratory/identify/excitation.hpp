// SPDX-License-Identifier: GPL-2.0-or-later
// A motion that determines the base parameters well: noise gives them small standard deviations, and its stacked
// regressor has a small condition number (Swevers et al., 1997) when columns are divided by their lengths in random
// motions. The motion keeps all limits of the robot. Where there are logs of other motions already, theirs and its own
// regressor are stacked.
#pragma once

#include <functional>
#include <optional>

#include "base/diagnostics/progress.hpp"
#include "laboratory/identify/planned_motion.hpp"

namespace flatdyn {

struct ExcitationOptions {
  double duration = 20;    // s
  double rate = 100;       // samples per second of the motion that is planned, checked and written
  int harmonics = 5;       // harmonics in every joint's series
  double margin = 0.9;     // share of every limit that is used
  unsigned seed = 1;       // seed of the random starts
  int evaluations = 3000;  // evaluations of the criterion; the search ends earlier if it stops improving
  // The time in s after which the search ends, for slow computers. None: no limit.
  std::optional<double> time = 30;
  // The information of logs (LoggedInformation::root); the motion then gives the parameters small standard deviations
  // together with them. Empty: nothing.
  Eigen::MatrixXd logged{};
};

struct Excitation {
  PlannedMotion start;               // random start, within the limits too
  PlannedMotion motion;              // the result of the search
  std::optional<Conditioning> logs;  // of the logs alone, if there are any
  int evaluations = 0;               // evaluations used
  bool out_of_time = false;
};

// A motion that starts and ends at rest in the middle of the position limits. Throws Failure(unsupported) if no torque
// depends on a parameter, or if the torques that the file allows cannot hold the robot in that posture; Failure(usage)
// if the samples are too few to show the motion, or more than 500,000.
// stop: asked before every evaluation; once it returns true, the best motion so far is planned and returned.
Excitation make_excitation(
    const MotionEquations& equations, const ExcitationOptions& options, Progress& progress,
    const std::function<bool()>& stop = [] { return false; });

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// A motion from which the base parameters can be told well: the standard deviations that noise gives them are small,
// and the condition number of its stacked regressor (Swevers et al., 1997), with columns divided by their lengths in
// random motions; and no limit of the robot is passed.
#pragma once

#include <functional>
#include <optional>

#include "diagnostics/progress.hpp"
#include "identify/planned_motion.hpp"
#include "identify/torque_model.hpp"

namespace flatdyn {

struct ExcitationOptions {
  double duration = 20;    // s
  double rate = 100;       // samples per second of the motion that is planned, checked and written
  int harmonics = 5;       // of every joint's series
  double margin = 0.9;     // the part of every limit that is used
  unsigned seed = 1;       // of the random starts
  int evaluations = 3000;  // of the criterion; the search ends before that where it gets no better
  // s; ends the search before that on a slow computer. None: it never does.
  std::optional<double> time = 30;
};

struct Excitation {
  PlannedMotion start;   // random, within the limits too
  PlannedMotion motion;  // what the search made of it
  int evaluations = 0;   // used
  bool out_of_time = false;
};

// From the middle of the position limits and back there. Throws Failure(unsupported) for a robot that nothing can be
// learnt of, and for one that cannot hold itself in that posture with the torques that the file allows; Failure(usage)
// where the samples are too few to show the motion, or more than 500,000.
// stop: asked before every evaluation; once it is true, what was found until then is planned and returned.
Excitation make_excitation(
    const TorqueModel& model, const ExcitationOptions& options, Progress& progress,
    const std::function<bool()>& stop = [] { return false; });

}  // namespace flatdyn

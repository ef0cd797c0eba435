// SPDX-License-Identifier: GPL-2.0-or-later
// A motion from which the base parameters can be told apart well: the condition number of its stacked regressor, with
// columns of unit length, is small (Swevers et al., 1997), and no limit of the robot is passed.
#pragma once

#include <optional>
#include <vector>

#include "diagnostics/progress.hpp"
#include "identify/conditioning.hpp"
#include "identify/fourier_trajectory.hpp"
#include "identify/motion_limits.hpp"
#include "identify/torque_model.hpp"

namespace flatdyn {

struct ExcitationOptions {
  double duration = 20;    // s
  double rate = 100;       // samples per second of the motion that is planned, checked and written
  int harmonics = 5;       // of every joint's series
  double margin = 0.9;     // the part of every limit that is used
  unsigned seed = 1;       // of the random starts
  int evaluations = 3000;  // of the condition number; what ends the search
  // s; ends the search before that on a slow computer. None: it never does.
  std::optional<double> time = 30;
};

// A motion, sampled as it is written.
struct PlannedMotion {
  FourierTrajectory trajectory;
  std::vector<FourierMotion> samples;
  std::vector<std::vector<double>> torques;  // Y_b π_b of the file, per sample
  std::vector<LimitUse> use;                 // per joint, of the whole limits
  Conditioning conditioning;                 // of all samples

  double time(std::size_t sample) const {
    return trajectory.duration() * static_cast<double>(sample) / static_cast<double>(samples.size() - 1);
  }
};

struct Excitation {
  PlannedMotion start;   // random, within the limits too
  PlannedMotion motion;  // what the search made of it
  int evaluations = 0;   // used
  bool out_of_time = false;
};

// From the middle of the position limits and back there. Throws Failure(unsupported) for a robot that nothing can be
// learnt of, and for one that cannot hold itself in that posture with the torques that the file allows; Failure(usage)
// where the samples are too few to show the motion.
Excitation make_excitation(const TorqueModel& model, const ExcitationOptions& options, Progress& progress);

}  // namespace flatdyn

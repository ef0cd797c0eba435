// SPDX-License-Identifier: GPL-2.0-or-later
// Motions that are repeated within a log or in another log. What the model lacks, such as the ripple of gears, is then
// repeated with them: it does not average out, and tells itself from noise by that.
#pragma once

#include <vector>

#include "laboratory/identify/observations.hpp"

namespace flatdyn {

// A motion that takes `period` rows.
struct RepeatedMotion {
  int log = 0;  // the first one that shows it
  double period = 0;
  bool begins_anew = false;  // after its period, within a log
  double count = 0;          // how often it is logged; a part of it counts as a part
};

struct Repetition {
  std::vector<RepeatedMotion> motions;
  std::vector<std::size_t> motion_of;  // by instant, index into `motions`
  std::vector<double> phase_of;        // by instant: rows since the motion began

  bool any() const;  // whether a motion is logged more than once
};

// Logs whose positions and rates come back to within a tenth of how far they vary, all the time.
Repetition repetition_of(const Observations& observations);

}  // namespace flatdyn

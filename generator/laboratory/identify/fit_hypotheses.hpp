// SPDX-License-Identifier: GPL-2.0-or-later
// Reasons for a model that does not fit a log: each is tried on a sample of the log's rows, and the one that leaves
// least is named.
#pragma once

#include <optional>
#include <string>

#include "laboratory/identify/fit_quality.hpp"
#include "laboratory/identify/friction_law.hpp"
#include "laboratory/identify/torque_model.hpp"

namespace flatdyn {

struct FitHypothesis {
  std::string text;      // such as: joint "elbow": its torques look 1.2 times too large
  double explained = 0;  // share of what the noise does not explain of the weighted squares, 0 … 1
};

// The hypothesis that explains most, if it explains half or more: torques or positions with the other sign, exchanged
// between joints, or shifted by a constant; joints exchanged; torques too large or too late, all or those of one joint;
// gravity from another direction, or not in the torques; friction and rotors that the model lacks, or friction that is
// larger near rest. Gains that explain equally much are all named. In a sound log, less than 60 % is chance. Masses
// that only gravity shows, and that come out as good as zero, say that gravity is not in the torques, too: that
// explains 0. Of a fit that shows nothing suspicious only gravity that is not in the torques is looked for, because
// masses whose centres are on the axes explain that, too. Otherwise the search takes a second or two.
std::optional<FitHypothesis> best_hypothesis(const TorqueModel& model, const LoadedRobot& robot,
                                             const Measurement& measurement, const std::vector<JointFit>& fits,
                                             FrictionLaw law = FrictionLaw::coulomb);

}  // namespace flatdyn

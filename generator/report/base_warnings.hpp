// SPDX-License-Identifier: GPL-2.0-or-later
// Doubts about what a log says of a floating base.
#pragma once

#include <string>
#include <vector>

#include "laboratory/identify/measurement.hpp"

namespace flatdyn {

// Sentences on a specific force of the base, m/s², that is not that of a robot that something carries, or on a force on
// the base, N and N m, that is zero although something does. Equations of that force are the first six of the
// observations where these are of torques; a sensor at the wrist has none of them. None for a robot with a fixed base.
std::vector<std::string> base_warnings(const Mechanism& mechanism, const Observations& observations,
                                       bool are_of_torques = true);

// A question that belongs behind the words that a model does not fit: whether the inertial measurement unit that
// measures the base's motion is where it is assumed to be. Empty where no unit does.
std::string imu_question(const std::vector<MeasuredLog>& logs);

}  // namespace flatdyn

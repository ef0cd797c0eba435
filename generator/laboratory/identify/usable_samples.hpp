// SPDX-License-Identifier: GPL-2.0-or-later
// Whether a measurement has samples from which parameters can be determined, and why not.
#pragma once

#include <string>

#include "laboratory/identify/measurement.hpp"

namespace flatdyn {

// Throws Failure(input) unless some samples can be used. Warns if gaps in time, each of which costs a window of the
// filter, take most samples. log: the file that messages name.
void check_used_samples(const Measurement& measurement, const std::string& log, Diagnostics& found);

// The same, and throws Failure(input) unless some joint, or a floating base, moves. The measurement is one of torques.
void check_samples(const Measurement& measurement, const Mechanism& mechanism, const std::string& log,
                   Diagnostics& found);

}  // namespace flatdyn

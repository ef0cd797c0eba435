// SPDX-License-Identifier: GPL-2.0-or-later
// States at the extremes of the number range.
#pragma once

#include <vector>

#include "robot/model/mechanism.hpp"
#include "robot/model/states.hpp"

namespace flatdyn {

// Random states whose coordinates are drawn independently: angles at multiples of pi/2, tiny, or up to 1e8 rad; speeds
// zero, denormal, or up to 1e6; accelerations, torques and forces alike. The first three states are all zero, all tiny,
// all large. They have no free symbols and no base parameters.
std::vector<State> extreme_states(const Mechanism& mechanism, int count, unsigned seed);

}  // namespace flatdyn

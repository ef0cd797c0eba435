// SPDX-License-Identifier: GPL-2.0-or-later
// States at the edge of what numbers can be.
#pragma once

#include <vector>

#include "model/mechanism.hpp"
#include "model/states.hpp"

namespace flatdyn {

// Every coordinate drawn for itself: angles at multiples of pi/2, tiny, or up to 1e8 rad; speeds zero, denormal, up to
// 1e6; accelerations, torques and forces alike. The first three are all zero, all tiny, all large. No free symbols, no
// base parameters.
std::vector<State> extreme_states(const Mechanism& mechanism, int count, unsigned seed);

}  // namespace flatdyn

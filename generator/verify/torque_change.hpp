// SPDX-License-Identifier: GPL-2.0-or-later
// How far the torques of two models of one robot are apart.
#pragma once

#include <vector>

#include "model/mechanism.hpp"

namespace flatdyn {

// By joint, N m or N: the largest difference of inverse dynamics at random states within the limits of `a`, every other
// one of them at the limits of velocity and acceleration. `at_rest`: q̇ = 0. The limits must be there.
std::vector<double> largest_torque_change(const Mechanism& a, const Mechanism& b, bool at_rest, int states);

}  // namespace flatdyn

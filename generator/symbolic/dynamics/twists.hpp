// SPDX-License-Identifier: GPL-2.0-or-later
// What a unit rate of one joint does to the bodies behind it: columns of the geometric Jacobians (7.18), (7.19), each
// in the frame of the body that moves.
#pragma once

#include <map>
#include <vector>

#include "symbolic/dynamics/newton_euler.hpp"

namespace flatdyn {

// Angular velocity and velocity of a frame's origin, in that frame, for a unit rate of a joint: rad/s and m/s per
// rad/s, or m/s per m/s.
struct Twist {
  Vec3 omega = zero_vector(), v = zero_vector();
};

// unit_twists[k][i]: joint i's unit motion in frame k, for every i from the base to k; absent for others.
std::vector<std::map<int, Twist>> unit_twists(Frames& frames);

// What joint i's motion makes of a wrench: its power for a unit rate.
Number power(const Twist& twist, const Wrench& wrench);

}  // namespace flatdyn

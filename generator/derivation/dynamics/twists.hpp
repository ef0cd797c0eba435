// SPDX-License-Identifier: GPL-2.0-or-later
// The motion of bodies by a unit rate of one joint: columns of the geometric Jacobians (7.18), (7.19), each in the
// frame of the body that moves.
#pragma once

#include <map>
#include <vector>

#include "derivation/dynamics/newton_euler.hpp"

namespace flatdyn {

// The angular velocity and the velocity of a frame's origin, in that frame, for a unit rate of a joint: rad/s and m/s
// per rad/s, or m/s per m/s.
struct Twist {
  Vec3 omega = zero_vector(), v = zero_vector();
};

// unit_twists[k][i]: joint i's unit motion in frame k, for every i from the base to k; absent for others.
std::vector<std::map<int, Twist>> unit_twists(Frames& frames);

// The power of a wrench at joint i's unit rate: the torque that balances it.
Number power(const Twist& twist, const Wrench& wrench);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The angles whose sines and cosines a robot's functions need: the entries of q, and those multiples of them by which
// coupled joints turn and which do not follow by the addition theorems.
#pragma once

#include <vector>

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The multiples of coordinates by which revolute joints turn and that are not small whole numbers, each once by entry
// of q and size.
std::vector<CoordinateMultiple> further_angles(const Mechanism& mechanism);

// The number of last places by which the angle of a joint is off, at most, when a coordinate is rounded in its last
// place: the largest of these multiples, 1 if there are none.
double largest_angle_factor(const Mechanism& mechanism);

// The factor of each angle in the position of body i's joint, -2 to 2: first the entries of q, then mechanism.angles.
// The mechanism must have coupled joints.
std::vector<Number> angle_factors(const Mechanism& mechanism, int i);

}  // namespace flatdyn

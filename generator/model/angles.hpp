// SPDX-License-Identifier: GPL-2.0-or-later
// The angles whose sines and cosines a robot's functions ask for: the entries of q, and multiples of them by which
// coupled joints turn, where those do not follow by the addition theorems.
#pragma once

#include <vector>

#include "model/mechanism.hpp"

namespace flatdyn {

// Of the joints that turn, whose factors are no small whole numbers: each multiple once, by position and size.
std::vector<CoordinateMultiple> further_angles(const Mechanism& mechanism);

// How many last places of a coordinate one of the joints' angles is off by where the coordinate is rounded: the largest
// of these multiples, 1 if there are none.
double largest_turn(const Mechanism& mechanism);

// By how many times each angle the joint of body i turns, -2 to 2: those of the entries of q, then
// those of mechanism.angles. For a mechanism with coupled joints.
std::vector<Number> turns_of(const Mechanism& mechanism, int i);

}  // namespace flatdyn

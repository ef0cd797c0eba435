// SPDX-License-Identifier: GPL-2.0-or-later
// Robot → Robot: numbers of the canonical mechanism that cancel but for dust. Bodies of a few links, and frames that
// lie along none of the file's, have first moments, products of inertia and distances that sum up to 1e-17 where zero
// is meant.
#pragma once

#include "model/mechanism.hpp"

namespace flatdyn {

// What is smaller than `part` of what it stands beside is dust: a distance from one joint's frame to the next beside
// the robot's size (snap_dust.hpp), a first moment beside the body's mass times that size, a product of inertia beside
// the smaller moment about its two axes, both about the origin of the body's frame. The joint's origin is moved, or the
// heaviest inertial of the body, by what is missing to zero. Each such change is recorded in `snaps`. Returns the
// mechanism of the robot as it is then. 0 leaves all as it is.
Mechanism snap_cancelled(const Number& part, Robot& robot);

}  // namespace flatdyn

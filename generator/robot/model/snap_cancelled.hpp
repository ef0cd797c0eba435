// SPDX-License-Identifier: GPL-2.0-or-later
// Robot → Robot: snaps to zero those numbers of the canonical mechanism that cancel up to dust. Bodies of several
// links, and frames that are aligned with none of the file's, have first moments, products of inertia and distances
// that sum up to 1e-17 where zero is meant.
#pragma once

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Dust is a number smaller than `part` of a reference: for a distance from one joint's frame to the next, the robot's
// size (snap_dust.hpp); for a first moment, the body's mass times that size; for a product of inertia, the smaller
// moment about its two axes; moments are about the origin of the body's frame. The joint's origin, or the heaviest
// inertial of the body, is changed by the amount missing to zero, and each change is recorded in `snaps`. Returns the
// mechanism of the changed robot. If `part` is 0, nothing changes.
Mechanism snap_cancelled(const Number& part, Robot& robot);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The directions in which joint torques accelerate the tip, decided exactly.
#pragma once

#include <vector>

#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

struct TipDirections {
  std::vector<int> rows;  // ascending: 0 to 2 are x, y, z of the base frame, 3 to 5 the rotation about them
  int rank = 0;           // how many of them are independent at almost every position
};

// The rows are those of the scene's task, which is not in Euler angles, or else the directions out of x, y, z in which
// joints accelerate the tip's origin, even if only along a curve. With a floating base they are those in which joints
// do so while nothing holds the base: an arm of one hinge has a curve. B and J are the functions inertia_matrix and
// jacobian of the mechanism. Throws Failure(unsupported) if the task's rows depend on each other everywhere, if there
// are no rows, or if some forces or moments on a floating base move no inertia.
TipDirections tip_directions(const Mechanism& mechanism, const Function& B, const Function& J);

}  // namespace flatdyn

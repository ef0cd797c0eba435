// SPDX-License-Identifier: GPL-2.0-or-later
// Friction at each coordinate, in doubles.
#pragma once

#include <vector>

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// By entry of q̇: F_v in N m s/rad or N s/m, F_s in N m or N, summed over all joints that follow the coordinate by a
// factor a: Σ a² F_v and Σ |a| F_s.
struct JointFriction {
  std::vector<double> viscous, coulomb;
};

// Throws Failure(unsupported) if a joint that follows several coordinates, or one that a closed loop moves, has
// friction: it does not belong to a single coordinate.
JointFriction joint_friction(const Mechanism& mechanism);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Friction as each coordinate feels it, in doubles.
#pragma once

#include <vector>

#include "model/mechanism.hpp"

namespace flatdyn {

// By entry of q̇: F_v in N m s/rad or N s/m, F_s in N m or N; of all joints that follow it: Σ a² F_v and Σ |a| F_s.
struct JointFriction {
  std::vector<double> viscous, coulomb;
};

// Throws Failure(unsupported) if a joint that follows several coordinates, or a closed loop, has friction: no
// coordinate has it alone.
JointFriction joint_friction(const Mechanism& mechanism);

}  // namespace flatdyn

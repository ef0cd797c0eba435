// SPDX-License-Identifier: GPL-2.0-or-later
// Friction at each coordinate, in doubles.
#pragma once

#include <cstddef>
#include <vector>

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The smooth dry friction of a joint that follows a coordinate by a factor, with the numbers of DryFriction.
struct SmoothFriction {
  std::size_t coordinate = 0;
  double factor = 1, coulomb = 0;
  double speed = 0, offset = 0, excess = 0, stribeck_speed = 0, asymmetry = 0;

  // At the coordinate, N m or N, for its rate.
  double torque(double rate) const;
};

// By entry of q̇: F_v in N m s/rad or N s/m, F_s sgn(q̇) in N m or N, summed over all joints that follow the coordinate
// by a factor a: Σ a² F_v and Σ |a| F_s; and smooth friction, joint by joint.
struct JointFriction {
  std::vector<double> viscous, coulomb;
  std::vector<SmoothFriction> smooth;

  bool is_smooth_at(std::size_t coordinate) const;
  double smooth_torque(std::size_t coordinate, double rate) const;
};

// Throws Failure(unsupported) if a joint that follows several coordinates, or one that a closed loop moves, has
// friction: it does not belong to a single coordinate. So it does for friction that has a sign, and is another one at
// other speeds or in the other direction, and for load_friction.
JointFriction joint_friction(const Mechanism& mechanism);

}  // namespace flatdyn

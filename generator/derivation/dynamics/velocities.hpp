// SPDX-License-Identifier: GPL-2.0-or-later
// The velocities of a mechanism's bodies, from the base outwards, (7.82), (7.83) in link frames.
#pragma once

#include <vector>

#include "derivation/kernel/frames.hpp"

namespace flatdyn {

// A body's angular velocity, and the velocity of its frame's origin, in its own frame: rad/s, m/s.
struct Velocity {
  Vec3 omega = zero_vector(), v = zero_vector();
};

// The velocities of all bodies, from the rates of all bodies' joints. Of the bodies that are the motion of a floating
// base, and of those of a spherical joint, only the last one has the whole motion.
std::vector<Velocity> link_velocities(Frames& frames, const std::vector<Number>& rates);

}  // namespace flatdyn

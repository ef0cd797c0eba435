// SPDX-License-Identifier: GPL-2.0-or-later
// The statements of integrate() and difference() for the joints' entries of q and v.
#pragma once

#include <string>
#include <vector>

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The entries of q that are a floating base's: position, quaternion.
inline int pose_entries(const Mechanism& mechanism) { return mechanism.floating_base ? 7 : 0; }

// The constant of the robot's header that is the number of entries of v.
inline std::string count_of_velocities(const Mechanism& mechanism) {
  return mechanism.floating_base ? "velocity_count" : "joint_count";
}

// "q_next[7] = q[7] + v[6] * dt;" for joints of one axis, and a call for each spherical one. Joints that closed loops
// move stay where they are.
std::vector<std::string> integrate_joints(const Mechanism& mechanism);
// "v[6] = q_1[7] - q_0[7];", …
std::vector<std::string> difference_joints(const Mechanism& mechanism);

}  // namespace flatdyn

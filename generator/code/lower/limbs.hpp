// SPDX-License-Identifier: GPL-2.0-or-later
// Limbs: subtrees of joints that hang on the same link and have the same types of joints in the same tree, such as the
// legs of a quadruped.
#pragma once

#include <vector>

#include "robot/model/mechanism.hpp"

namespace flatdyn {

struct Limbs {
  std::vector<std::vector<int>> joints;  // by limb: the entries of q, in the same order in each
  int base_velocities = 0;               // the entries of v before those of joints

  int count() const { return static_cast<int>(joints.size()); }
  // The lanes of a vector with a number of each limb: a power of two. The last limb fills those that are left.
  int lanes() const;
};

// The sets of limbs of a robot, from the base outwards; limbs have none of their own. Empty for robots with coupled
// joints or closed loops.
std::vector<Limbs> limbs_of(const Mechanism& mechanism);

}  // namespace flatdyn

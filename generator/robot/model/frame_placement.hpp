// SPDX-License-Identifier: GPL-2.0-or-later
// The freedom that raw frames leave, phase about z and place of the origin on the axis, used so that constant
// transforms become modified Denavit–Hartenberg ones with as few numbers as possible.
#pragma once

#include <vector>

#include "robot/model/raw_tree.hpp"

namespace flatdyn {

// The pose of a body's final frame in its raw frame: turned by `phase` about z, then shifted by `shift`.
struct Placement {
  PlanarRotation phase;
  Vec3 shift = zero_vector();
};

// By body. They are chosen from the base outwards, so that that of a body's parent is known.
std::vector<Placement> frame_placements(const RawTree& tree);

// The displacement of body i's final origin (at q = 0) in its parent's final frame, m.
Vec3 displacement(const RawTree& tree, const std::vector<Placement>& placements, std::size_t i);

}  // namespace flatdyn

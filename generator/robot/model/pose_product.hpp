// SPDX-License-Identifier: GPL-2.0-or-later
// Products and inverses of poses that stay products of elementary displacements, so that no angle is rounded.
#pragma once

#include <vector>

#include "robot/model/parts.hpp"

namespace flatdyn {

using Displacements = std::vector<Displacement>;

// Neighbours of one kind become one displacement, and those that move nothing are left out.
Displacements product(const Displacements& a, const Displacements& b);
Displacements inverse(const Displacements& a);

// The rotations alone: their product is the rotation of the pose.
Displacements rotations_in(const Displacements& a);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The centre of a spherical linkage, where all of its axes meet: on the axis along which a loop is closed it is the
// point that no joint moves. A loop that is cut there has equations of its axes' directions only.
#pragma once

#include <array>
#include <optional>

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Such a point on each end's axis, if there are any, in the frames of the ends' bodies: where the axis of the last
// joint before an end goes through it. Whether the other joints leave it alone, and whether the two meet, is not looked
// at.
std::optional<std::array<Vec3, 2>> spherical_centres(const Mechanism& tree, const LoopClosure& loop);

}  // namespace flatdyn

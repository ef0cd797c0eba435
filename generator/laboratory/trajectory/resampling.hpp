// SPDX-License-Identifier: GPL-2.0-or-later
// A trajectory at even times.
#pragma once

#include "laboratory/trajectory/trajectory.hpp"

namespace flatdyn {

// The trajectory at the ends of this many equal intervals of its duration: the first and the last sample are the
// trajectory's own, and those between are interpolated() (interpolation.hpp), so that q̇ and q̈ are the derivatives of
// one curve. h_e is interpolated linearly. No sample has the other side of a jump.
Trajectory resampled(const Trajectory& trajectory, int intervals);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <limits>

namespace flatdyn {

// A limit that is not there.
inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Equivalent inertial parameters with as many zeros as possible: what a link's motion about its own joint cannot tell
// from its parent's is moved to the parent (Gautier and Khalil, 1990). Exact; the mechanism's torques, B, C and g stay
// the same. The parameters are no longer those of a real body.
#pragma once

#include "model/mechanism.hpp"

namespace flatdyn {

// Which entry the transverse inertia that can be moved (a, a, 0) is chosen to cancel in a revolute joint's link.
enum class Grouping {
  none,      // parameters as they are
  i_yy,      // Î_yy = 0, the textbook choice
  i_xx,      // Î_xx = 0
  sigma_zz,  // (Î_xx + Î_yy - Î_zz)/2 = 0: the pseudo-inertia's z entry
};

inline constexpr Grouping kGroupings[] = {Grouping::i_yy, Grouping::i_xx, Grouping::sigma_zz};

Mechanism regrouped(const Mechanism& mechanism, Grouping grouping);

}  // namespace flatdyn

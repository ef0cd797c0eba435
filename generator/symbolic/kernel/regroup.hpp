// SPDX-License-Identifier: GPL-2.0-or-later
// Equivalent inertial parameters with as many zeros as possible: what a link's motion about its own joint cannot tell
// from its parent's is moved to the parent (Gautier and Khalil, 1990). Exact; the mechanism's torques, B, C and g stay
// the same. The parameters are no longer those of a real body.
#pragma once

#include <vector>

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

// How much of the mass that can be moved is moved: all of it, or as much as cancels an entry of the parent's first
// moment. A mass costs a force, a first moment costs a force and a moment.
enum class Balance { no, x, y };

inline constexpr Balance kBalances[] = {Balance::no, Balance::x, Balance::y};

struct JointGrouping {
  Grouping grouping = Grouping::none;
  Balance balance = Balance::no;
};

// Whether masses of the body at that displacement from its parent can balance an entry of the parent's first moment.
// Not at an arm that is next to nothing: what is left where rational rotations should cancel, 1e-41 m, would do
// exactly, by masses of 1e41 kg that no double brings back together.
bool can_balance(const Vec3& p, Balance balance);

// One grouping for each joint.
Mechanism regrouped(const Mechanism& mechanism, const std::vector<JointGrouping>& groupings);

Mechanism regrouped(const Mechanism& mechanism, Grouping grouping);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Equivalent inertial parameters with as many zeros as possible: the part of a link's parameters that has the same
// effect if it is fixed to the parent is moved there (Gautier and Khalil, 1990). The result is exact: torques, B, C and
// g stay the same, but the parameters are no longer those of a real body.
#pragma once

#include <vector>

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The entry of a revolute joint's link that the movable transverse inertia (a, a, 0) is chosen to cancel.
enum class Grouping {
  none,      // parameters unchanged
  i_yy,      // Î_yy = 0, the textbook choice
  i_xx,      // Î_xx = 0
  sigma_zz,  // (Î_xx + Î_yy - Î_zz)/2 = 0: the pseudo-inertia's z entry
};

inline constexpr Grouping kGroupings[] = {Grouping::i_yy, Grouping::i_xx, Grouping::sigma_zz};

// How much of the movable mass is moved: all of it, or as much as cancels an entry of the parent's first moment. A mass
// costs a force, a first moment costs a force and a moment.
enum class Balance { no, x, y };

inline constexpr Balance kBalances[] = {Balance::no, Balance::x, Balance::y};

struct JointGrouping {
  Grouping grouping = Grouping::none;
  Balance balance = Balance::no;
};

// Whether masses of the body at that displacement from its parent can balance an entry of the parent's first moment.
// They cannot if the moment arm is almost zero: a rounding residue of 1e-41 m, where rational rotations should cancel,
// would require masses of 1e41 kg, which do not cancel again in doubles.
bool can_balance(const Vec3& p, Balance balance);

// The mechanism with its parameters regrouped, by one grouping for each joint.
Mechanism regrouped(const Mechanism& mechanism, const std::vector<JointGrouping>& groupings);

Mechanism regrouped(const Mechanism& mechanism, Grouping grouping);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The smallest fraction of B's diagonal that a factorisation leaves: the inertia at a joint if all joints beyond it
// move freely.
#pragma once

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The smallest D_k / b_kk of B = Lᵀ D L, over the joints and over positions: random ones, and each joint at 0 or a
// quarter turn. 0 if B is singular there to the last place of a double. 1 for robots with free symbols, whose values
// are unknown, and with closed loops, which have conditions of their own.
double smallest_pivot_ratio(const Mechanism& mechanism);

}  // namespace flatdyn

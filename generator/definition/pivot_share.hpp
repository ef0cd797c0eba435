// SPDX-License-Identifier: GPL-2.0-or-later
// How much of B's diagonal a factorisation leaves: what a joint feels if all joints beyond it give way.
#pragma once

#include "model/mechanism.hpp"

namespace flatdyn {

// min D_k / b_kk of B = Lᵀ D L, over the joints and some positions: random ones, and each joint at 0 or a quarter turn;
// 0 if B is singular there to the last place of a double. 1 for robots with free symbols, whose numbers are not known,
// and with closed loops, which have conditions of their own.
double smallest_pivot_share(const Mechanism& mechanism);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Whether contacts hold a robot in more ways than it can move.
#pragma once

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Throws Failure(unsupported) if a row of the contacts' Jacobian follows from those before it at almost every position,
// so that J B^-1 Jᵀ has no inverse; the first one is named.
void require_independent(const Mechanism& mechanism);

// Throws Failure(unsupported) if the contacts' forces cannot have every moment on a floating base, because their points
// are on one line at almost every position.
void require_support(const Mechanism& mechanism);

}  // namespace flatdyn

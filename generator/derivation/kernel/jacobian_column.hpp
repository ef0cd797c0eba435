// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "robot/model/number.hpp"

namespace flatdyn {

// One column of a geometric Jacobian: J_Pi and J_Oi of (7.18), (7.19).
struct JacobianColumn {
  Vec3 linear = zero_vector(), angular = zero_vector();
};

}  // namespace flatdyn

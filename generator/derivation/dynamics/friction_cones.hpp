// SPDX-License-Identifier: GPL-2.0-or-later
// The conditions of dry friction at the scene's contacts as rows for a quadratic program: A f <= 0, with the forces f
// of all contacts in base axes as everywhere (contact_functions.hpp). A contact's own axes t_1, t_2, n, in which its
// rows are numbers (robot/model/friction_cone.hpp), are those of its link or, against gravity,
//   n = -g_b / |g_b|,   t_1 = H e_x,   t_2 = H e_y,
// with the mirror H that takes e_z to n or to -n, whichever is farther away, so that there is always one.
#pragma once

#include "derivation/dynamics/derivation_context.hpp"

namespace flatdyn {

// Throws Failure(unsupported) where a normal is against gravity, and there is none or, with a fixed base, it is along
// no axis of the base.
Function derive_friction_cones(const Mechanism& mechanism, const Choices& choices);

}  // namespace flatdyn

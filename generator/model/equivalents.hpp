// SPDX-License-Identifier: GPL-2.0-or-later
// Mechanisms that move, weigh and feel the same, described otherwise: what can be chosen freely when functions are
// derived. Torques, inertia matrix, Christoffel symbols and energies are the same functions of q, q̇ and q̈.
#pragma once

#include "model/mechanism.hpp"

namespace flatdyn {

// The frame of body i moved along its own axis, by `rise` (m). A prismatic joint's frame has no such freedom: its
// origin is the axis's at q = 0. Throws Failure(bug) for one.
Mechanism with_frame_raised(const Mechanism& mechanism, int i, const Number& rise);

// Lengths in units of `unit` (m), masses in units of 1/unit² (kg): energies and torques keep their numbers, and so do
// moments of inertia. Poses of links, and the tip, are left as they are. No joint may be prismatic: its
// position is a length.
Mechanism in_length_unit(const Mechanism& mechanism, const Number& unit);

}  // namespace flatdyn

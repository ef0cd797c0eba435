// SPDX-License-Identifier: GPL-2.0-or-later
// Equivalent mechanisms: the choices that are free when functions are derived. Torques, inertia matrix, Christoffel
// symbols and energies are the same functions of q, q̇ and q̈.
#pragma once

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The mechanism with the frame of body i shifted along its own axis by `axial_shift` (m). A prismatic joint's frame has
// no such freedom, as its origin is on the axis at q = 0: throws Failure(bug) for one.
Mechanism with_frame_shifted(const Mechanism& mechanism, int i, const Number& axial_shift);

// The mechanism with lengths in units of `unit` (m) and masses in units of 1/unit² (kg): energies, torques and moments
// of inertia keep their numbers. Poses of links and of the tip are left as they are. No joint may be prismatic, as its
// position is a length.
Mechanism in_length_unit(const Mechanism& mechanism, const Number& unit);

}  // namespace flatdyn

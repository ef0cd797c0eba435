// SPDX-License-Identifier: GPL-2.0-or-later
// What must hold of a robot before anything is derived from it. All findings have the place in the file.
#pragma once

#include "diagnostics/diagnostics.hpp"
#include "model/robot.hpp"

namespace flatdyn {

// Links and joints are one tree with names of their own; sets robot.root. False if it is none: then nothing that
// walks the tree may be called.
bool validate_tree(Robot& robot, Diagnostics& diagnostics);

// Axes, masses, inertias, friction, motors, limits. Numeric values are decided exactly; symbolic ones are
// not checked. Limits that say nothing (a speed or effort of 0, lower = upper = 0) are taken away, and that is noted.
// Where there are errors already, values may be missing that could not be read: nothing is said of their absence.
// payloads: where the inertias of payloads stand, which are among their links'.
void validate_values(Robot& robot, const std::vector<Place>& payloads, Diagnostics& diagnostics);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Checks of a robot before anything is derived from it. All findings have the place in the file.
#pragma once

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// Checks that links and joints form one tree with unique names; sets robot.root. Returns false if they do not; then no
// function that walks the tree may be called.
bool validate_tree(Robot& robot, Diagnostics& diagnostics);

// Checks axes, masses, inertias, friction, motors and limits. Numeric values are decided exactly; symbolic ones are not
// checked. Limits that say nothing (a speed or effort of 0, lower = upper = 0) are removed, and that is noted. If there
// are errors already, missing values are not reported, as they may have been unreadable. payloads: the places of the
// payloads' inertias, which are among their links'.
void validate_values(Robot& robot, const std::vector<Place>& payloads, Diagnostics& diagnostics);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Facts about a header's robot, in addition to the table of joints.
#pragma once

#include <string>

#include "robot/model/mechanism.hpp"

namespace flatdyn {

// The meaning of the base's entries in v, a, tau and g_b. For robots with a floating base.
std::string floating_base_text(const Mechanism& mechanism);
// Which entries are those of spherical joints, and what they are.
std::string spherical_joints_text(const Mechanism& mechanism);

// Text for a comment: gravity, the tip, links that were merged, joints that follow others; then `scene`, what a scene
// has changed.
std::string facts_of(const Mechanism& mechanism, const std::string& scene);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Facts about a header's robot, beside the table of joints.
#pragma once

#include <string>

#include "model/mechanism.hpp"

namespace flatdyn {

// Text for a comment: gravity, the tip, links that were merged, joints that follow others; then `scene`, what a scene
// has changed.
std::string facts_of(const Mechanism& mechanism, const std::string& scene);

}  // namespace flatdyn

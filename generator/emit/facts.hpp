// SPDX-License-Identifier: GPL-2.0-or-later
// What a header tells of its robot, beside the table of joints.
#pragma once

#include <string>

#include "model/mechanism.hpp"

namespace flatdyn {

// Gravity, the tip, links that were merged, joints that follow others; then `scene`, what a scene has changed. Fit for
// a comment.
std::string facts_of(const Mechanism& mechanism, const std::string& scene);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "input/urdf/values.hpp"

namespace flatdyn {

// What changes the dynamics and is not read: loops, constraints, springs, templates. Refused, never skipped.
void refuse_unread_dynamics(const tinyxml2::XMLElement& root, const UrdfValues& values, const Robot& robot);

}  // namespace flatdyn

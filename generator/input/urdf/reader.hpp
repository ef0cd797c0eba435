// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <tinyxml2.h>

#include <string>

#include "input/common/context.hpp"

namespace flatdyn {

// Reads a URDF file, by its outermost element, into `robot`: links, joints, nothing checked but what is needed to read
// on. `file` names it in diagnostics.
void read_urdf(const tinyxml2::XMLElement& root, const std::string& file, ReadContext& context, Robot& robot);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "robot/input/common/context.hpp"

namespace flatdyn {

// Reads the text of a URDF file into `robot`: links, joints, nothing checked but what is needed to read on. `file`
// names it in diagnostics.
void read_urdf(const std::string& text, const std::string& file, ReadContext& context, Robot& robot);

}  // namespace flatdyn

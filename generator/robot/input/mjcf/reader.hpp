// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "robot/input/common/context.hpp"

namespace flatdyn {

// Reads the text of an MJCF file, one of MuJoCo, into `robot`. `file` names it in diagnostics, and files that it
// includes are looked for beside it.
void read_mjcf(const std::string& text, const std::string& file, ReadContext& context, Robot& robot);

}  // namespace flatdyn

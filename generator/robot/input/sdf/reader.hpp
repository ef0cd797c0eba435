// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "robot/input/common/context.hpp"

namespace flatdyn {

// Reads the text of an SDF, 1.4 to 1.11, into `robot`: one model, with those that are nested in it. `file` is used in
// messages, and where files that it includes are looked for.
void read_sdf(const std::string& text, const std::string& file, ReadContext& context, Robot& robot);

}  // namespace flatdyn

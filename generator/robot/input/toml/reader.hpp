// SPDX-License-Identifier: GPL-2.0-or-later
// TOML robot files (docs/robot-format/toml.md): DH tables or placed links, or what is written over another robot file.
#pragma once

#include <string>

#include "robot/input/toml/parts.hpp"

namespace flatdyn {

// Reads the text of a TOML file (and of the robot file that it names) into `robot`; nothing checked but what is needed
// to read on. `file` names it in diagnostics, and its folder is where that robot file is looked for.
Attachments read_toml(const std::string& text, const std::string& file, ReadContext& context, Robot& robot);

}  // namespace flatdyn

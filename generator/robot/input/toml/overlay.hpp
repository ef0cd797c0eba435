// SPDX-License-Identifier: GPL-2.0-or-later
// A TOML file over another robot file: what it gives replaces what that file says of links and joints.
#pragma once

#include "robot/input/toml/parts.hpp"

namespace flatdyn {

// True if the file names another one: `robot = "arm.toml"` or `urdf = "arm.urdf"`.
bool is_overlay(const TomlTable& table);

// Reads that robot file into `robot`, then the [[link]] and [[joint]] tables over it. `file` is the TOML file that
// `table` is of: the other's path is relative to it. Returns what the other file attaches to the robot.
Attachments read_overlay(TomlTable& table, const std::string& file, ReadContext& context, Robot& robot,
                         MotorCarriers& carriers);

}  // namespace flatdyn

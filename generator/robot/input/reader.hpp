// SPDX-License-Identifier: GPL-2.0-or-later
// Robot file → Robot. The stage before anything is derived: what is wrong with the input is said here.
#pragma once

#include <filesystem>
#include <optional>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/input/common/read_options.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// Reads a URDF, SDF or MJCF (tinyxml2), a xacro template, or a TOML (toml++) file, as its extension and its outermost
// element say, or, from stdin ("-"), as its content does; checks it (validate.hpp) and orders nothing. All findings
// go to `diagnostics`; nullopt if any of them is an error.
std::optional<Robot> read_robot(const std::filesystem::path& path, const ReadOptions& options,
                                Diagnostics& diagnostics);

}  // namespace flatdyn

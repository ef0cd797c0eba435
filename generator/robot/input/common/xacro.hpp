// SPDX-License-Identifier: GPL-2.0-or-later
// Templates of URDF files, for the program xacro of ROS.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robot/input/common/file_node.hpp"

namespace flatdyn {

bool is_xacro(const std::filesystem::path& path);  // by its extension, .xacro

// The output of `xacro FILE NAME:=VALUE…`. Throws Failure(io) if there is no xacro on the PATH; nullopt and a
// diagnostic with xacro's own message if it fails.
std::optional<std::string> expanded_by_xacro(const std::string& file, const std::vector<std::string>& arguments,
                                             Diagnostics& diagnostics);

// An error for a document that is a template still: elements of xacro, also the old ones without a prefix, and ${} in
// the names of links and joints. True if it is one.
bool refuse_template(const FileNode& root, Diagnostics& diagnostics);

}  // namespace flatdyn

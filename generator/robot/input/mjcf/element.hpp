// SPDX-License-Identifier: GPL-2.0-or-later
// An MJCF file as a tree of elements, with what <include> brings in at its place.
#pragma once

#include <optional>

#include "robot/input/common/context.hpp"
#include "robot/input/common/xml_document.hpp"

namespace flatdyn {

inline const XmlForm kMjcfForm = {".xml", "an MJCF file is one <mujoco> ... </mujoco>"};

// The tree of a file, without the elements and attributes that --ignore names, which are noted. Included files are
// added to the robot's files.
FileNode mjcf_tree(const FileNode& root, ReadContext& context, Robot& robot);

// The tree of another file, whose includes are relative to it; nullopt, and an error, if it is not an MJCF file.
std::optional<FileNode> mjcf_tree_of_file(const std::string& file, ReadContext& context, Robot& robot);

}  // namespace flatdyn

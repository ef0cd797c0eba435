// SPDX-License-Identifier: GPL-2.0-or-later
// The files of an SDF: the one that is read, and those that it includes.
#pragma once

#include <optional>
#include <string>

#include "robot/input/sdf/tree.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// The outermost element <sdf> of a text that was read; nullptr and an error if there is none, or one of another
// version.
const SdfFile* parse_sdf(const std::string& text, const std::string& file, ReadContext& context, SdfTree& tree);

// The <sdf> of the file that an <include> names; nullptr and an error if it cannot be read. `stack`: the files that are
// being read, from the outermost.
const SdfFile* include_sdf(const FileNode& include, const SdfValues& values, const std::vector<std::string>& stack,
                           SdfTree& tree, Robot& robot);

}  // namespace flatdyn

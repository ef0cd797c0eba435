// SPDX-License-Identifier: GPL-2.0-or-later
// <replicate> and <attach> in the tree of elements: copies of elements, and models of other files.
#pragma once

#include "robot/input/mjcf/values.hpp"

namespace flatdyn {

// In the end, a <replicate> holds a <copy> for each copy, whose elements have names of their own; an <attach> is a
// <frame> with the other model's elements, their classes are <attached_default>s of the root, and what acts on them is
// in the root's sections. What cannot be copied or attached is refused.
void expand_mjcf(FileNode& root, const std::string& file, ReadContext& context, Robot& robot);

}  // namespace flatdyn

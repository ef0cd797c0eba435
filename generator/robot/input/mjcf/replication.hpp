// SPDX-License-Identifier: GPL-2.0-or-later
// Copies of elements: <replicate>.
#pragma once

#include "robot/input/mjcf/element.hpp"

namespace flatdyn {

// Puts the copies into a <replicate>, and into the sections of the root copies of what acts on them. Copies of names
// have suffixes, as in MuJoCo: the number of the copy, with as many digits as the count has. elements: how many
// elements have been copied so far.
void replicate_mjcf(FileNode& replicate, FileNode& root, Diagnostics& diagnostics, std::size_t& elements);

}  // namespace flatdyn

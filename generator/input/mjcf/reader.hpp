// SPDX-License-Identifier: GPL-2.0-or-later
// Robots from XML files: URDF, or MuJoCo's MJCF.
#pragma once

#include "input/common/context.hpp"

namespace flatdyn {

// Reads the text of an XML file into `robot`, as its outermost element says: <robot> or <mujoco>. `file` names it in
// diagnostics.
void read_xml(const std::string& text, const std::string& file, ReadContext& context, Robot& robot);

}  // namespace flatdyn

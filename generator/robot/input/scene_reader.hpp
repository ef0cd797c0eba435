// SPDX-License-Identifier: GPL-2.0-or-later
// Scene files (docs/scene-format.md) → Scene.
#pragma once

#include "robot/input/common/context.hpp"
#include "robot/model/scene.hpp"

namespace flatdyn {

// Names of joints, links and functions are checked where they are looked up, later.
Scene read_scene(const std::string& file, ReadContext& context);

}  // namespace flatdyn

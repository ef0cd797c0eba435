// SPDX-License-Identifier: GPL-2.0-or-later
// Applies a scene to a robot that was read. Held joints: robot/input/toml/held_joints.hpp.
#pragma once

#include "base/diagnostics/diagnostics.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// Adds what `file` says to `scene`, where `scene` says nothing of it itself: the command line goes before the file.
void add_scene(Scene file, Scene& scene);

// Limits and friction.
void apply_to_joints(const Scene& scene, Diagnostics& diagnostics, Robot& robot);

}  // namespace flatdyn

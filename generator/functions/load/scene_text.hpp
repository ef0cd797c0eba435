// SPDX-License-Identifier: GPL-2.0-or-later
// The settings of a scene, for people, for the stamp of a header and for its documentation.
#pragma once

#include <string>
#include <vector>

#include "functions/load/loaded_robot.hpp"

namespace flatdyn {

// One text per key, by content and never by path: "gravity = [0, 0, 0]", "locked.elbow = pi/2", "static = true".
// --gravity and --fix are included. Empty if nothing is set.
std::vector<std::string> scene_items(const LoadedRobot& model);

// The settings of a scene file as one text, "Scene: gravity = [0, 0, 0]; static = true"; empty without such a file.
std::string scene_stamp(const LoadedRobot& model);

// Sentences for the header: "Joint elbow is held at pi/2 rad. Friction is left out." Empty if there is nothing to say.
std::string scene_facts(const LoadedRobot& model);

}  // namespace flatdyn

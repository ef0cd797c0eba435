// SPDX-License-Identifier: GPL-2.0-or-later
// What a person checks first of a robot, in the frames of its file: total mass, reach, and of each link its length, its
// mass and where its centre of mass is.
#pragma once

#include <array>
#include <nlohmann/json.hpp>

#include "load/loaded_robot.hpp"

namespace flatdyn {

// A link that a joint moves, with all that is fixed to it, rotors too. Its frame is the file's.
struct LinkInFile {
  int body = 0;                   // of the mechanism
  std::vector<std::string> with;  // names of links fixed to it
  InertialParameters inertia;     // in the link's frame, about its origin
  std::optional<double> length;   // m, from its joint to the farthest joint on it, or to the tip
};

// In the order of the mechanism's bodies.
std::vector<LinkInFile> links_in_file(const LoadedRobot& model);

// How far the tip can be from the first joint that moves it: no farther than links and strokes are long together.
struct Reach {
  std::string first_joint;
  double links = 0;                    // m
  std::vector<std::string> without;    // joints that slide, and have no limits
  std::array<double, 3> at_zero = {};  // where the tip is at q = 0, base frame, m
};
// Nothing for a robot with free symbols or closed loops, or whose tip does not move.
std::optional<Reach> reach_of(const LoadedRobot& model);

std::string describe_links(const LoadedRobot& model);
// To be added to model_json() of report/describe.hpp.
nlohmann::ordered_json links_json(const LoadedRobot& model);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The data that a person checks first, in the frames of the robot file: total mass, reach, and each link's length, mass
// and centre of mass.
#pragma once

#include <array>
#include <nlohmann/json.hpp>

#include "functions/load/loaded_robot.hpp"

namespace flatdyn {

// A link that a joint moves, with everything fixed to it, rotors included. Its frame is the file's.
struct LinkInFile {
  int body = 0;                   // index of the mechanism's body
  std::vector<std::string> with;  // links fixed to it
  InertialParameters inertia;     // in the link's frame, about its origin
  std::optional<double> length;   // m, from its joint to the farthest joint on it, or to the tip
};

// The links in the order of the mechanism's bodies.
std::vector<LinkInFile> links_in_file(const LoadedRobot& model);

// An upper bound of the distance of the tip from the first joint that moves it: the sum of links' lengths and strokes.
struct Reach {
  std::string first_joint;
  double links = 0;                    // m
  std::vector<std::string> without;    // prismatic joints without limits
  std::array<double, 3> at_zero = {};  // the tip at q = 0, base frame, m
};
// None for a robot with free symbols or closed loops, or whose tip does not move.
std::optional<Reach> reach_of(const LoadedRobot& model);

std::string describe_links(const LoadedRobot& model);
// Links for model_json() of report/describe.hpp.
nlohmann::ordered_json links_json(const LoadedRobot& model);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Small robots as TOML, whose joints are given keys of their own, such as springs or friction.
#pragma once

#include <string>

namespace flatdyn::testing {

// A planar four-bar linkage with a crank and a coupler.
inline std::string four_bar_with(const std::string& crank, const std::string& coupler) {
  return R"(name = "four_bar"
gravity = [0, -9.81, 0]
[[link]]
joint = "crank"
mass = 1
com = [0.1, 0, 0]
)" + crank +
         R"(
[[link]]
joint = "coupler"
xyz = [0.2, 0, 0]
mass = 1
com = [0.25, 0, 0]
)" + coupler +
         R"(
[[link]]
joint = "rocker"
parent = "base"
xyz = [0.5, 0, 0]
mass = 1
com = [0.2, 0, 0]
[[loop]]
links = ["link2", "link3"]
from = [0.5, 0, 0]
to = [0.4, 0, 0]
dependent = ["coupler", "rocker"]
)";
}

// A floating body with a hinged wing. `rest`: more links.
inline std::string bird_with(const std::string& wing, const std::string& rest = "") {
  return R"(name = "bird"
[base]
motion = "floating"
mass = 1.5
com = [0.01, 0.02, -0.03]
inertia = { xx = 0.02, yy = 0.03, zz = 0.04, xy = 0.001 }
inertia_about = "com"
[[link]]
joint = "wing"
xyz = [0.1, 0.2, 0]
mass = 0.3
com = [0.2, 0.1, 0]
inertia = { xx = 0.003, yy = 0.004, zz = 0.005 }
inertia_about = "com"
)" + wing +
         rest;
}

}  // namespace flatdyn::testing

// SPDX-License-Identifier: GPL-2.0-or-later
// Masses and moments of inertia of geoms: exact, with Pi.
#pragma once

#include "robot/input/mjcf/values.hpp"

namespace flatdyn {

// A solid about its centre, along its own axes, which are its principal ones.
struct MjcfSolid {
  Number volume = 0;      // m^3
  Vec3 gyration_squared;  // moments of inertia per mass, m^2
};

// A solid of a type of geom that has a volume of its own ("sphere", "capsule", "cylinder", "ellipsoid", "box"), with
// its half lengths; as many as mjcf_size_count() says.
MjcfSolid mjcf_solid(const std::string& type, const std::vector<Number>& sizes);

// 0 of other types.
std::size_t mjcf_size_count(const std::string& type);

}  // namespace flatdyn

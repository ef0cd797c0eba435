// SPDX-License-Identifier: GPL-2.0-or-later
// Inertia of bodies from their geoms.
#pragma once

#include "robot/input/mjcf/meshes.hpp"
#include "robot/input/mjcf/model.hpp"

namespace flatdyn {

// The bodies that a body's geoms are, one for each that has a mass.
std::vector<Inertial> inertials_of_geoms(const MjcfBody& body, const std::string& name, const MjcfModel& model,
                                         MjcfMeshes& meshes);

}  // namespace flatdyn

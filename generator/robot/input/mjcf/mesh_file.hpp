// SPDX-License-Identifier: GPL-2.0-or-later
// Mesh files.
#pragma once

#include "robot/input/common/context.hpp"
#include "robot/input/mjcf/mesh_builder.hpp"

namespace flatdyn {

// The mesh of an .stl (binary or ASCII) or .obj file, or nullopt and an error. Quadrilaterals are cut along the shorter
// diagonal; other kinds of files and of faces are refused. Throws Failure(io) if the file cannot be read. spot: where
// the file is named.
std::optional<TriangleMesh> read_mesh_file(const std::string& path, const Spot& spot, Diagnostics& diagnostics);

}  // namespace flatdyn

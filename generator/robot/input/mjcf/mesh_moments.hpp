// SPDX-License-Identifier: GPL-2.0-or-later
// Volume, centre and moments of inertia of what a surface of triangles encloses.
#pragma once

#include "robot/input/mjcf/mesh_builder.hpp"

namespace flatdyn {

// How MuJoCo computes them. exact: the pyramids over the triangles count with their signs. legacy: they all count as
// positive, over the surface's centroid and then over the centre of mass, which counts what is hidden from these twice.
// convex: what the convex hull encloses. shell: the mass is that of the surface alone.
enum class MeshVolume { exact, legacy, convex, shell };

struct MeshMoments {
  Number volume;  // m^3; of a shell its area, m^2
  Vec3 centre;    // m
  Mat3 tensor;    // of the density 1, about the centre, m^5; of a shell m^4
};

// In exact numbers where the surface is closed and its pyramids have the same sign, else, and of shells, to 50 digits.
MeshMoments mesh_moments(const TriangleMesh& mesh, MeshVolume volume);

// Whether neighbours turn the same way: no two triangles have an edge in the same direction.
bool has_one_orientation(const TriangleMesh& mesh);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The convex hull of points, decided exactly.
#pragma once

#include "robot/input/mjcf/mesh_builder.hpp"

namespace flatdyn {

// The mesh's points with the triangles of their convex hull, counterclockwise seen from outside; none if all points are
// in one plane. By quickhull: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, ACM Trans. Math. Software 22 (1996) 469-483.
TriangleMesh convex_hull(const TriangleMesh& mesh);

}  // namespace flatdyn

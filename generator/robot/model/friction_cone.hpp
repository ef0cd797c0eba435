// SPDX-License-Identifier: GPL-2.0-or-later
// Linear conditions under which dry friction holds a contact: row · w <= 0 for each row, with the wrench w = (force,
// moment) on the robot, N and N m, in the contact's own axes, whose z is the normal, out of the ground. A pyramid with
// four sides inside the cone of friction stands for the cone, so that what it allows never slides.
#pragma once

#include <array>
#include <vector>

#include "robot/model/scene.hpp"

namespace flatdyn {

using ConeRow = std::array<Number, 6>;

// The four rows of a point: |f_x| + |f_y| <= μ f_z.
std::vector<ConeRow> point_cone(const Number& friction);

// The rows of a rectangle about the contact's point, m, all of whose corners hold with |f_x|, |f_y| <= μ/√2 f_z each:
// 16 rows, for sliding, for tilting (the centre of pressure stays inside), and for turning on the spot. Caron, Pham and
// Nakamura, Stability of surface contacts for humanoid robots, ICRA 2015, (15) to (20).
std::vector<ConeRow> surface_cone(const Number& friction, const Number& half_length, const Number& half_width);

// The rows of a contact of a scene; empty without friction.
std::vector<ConeRow> cone_of(const SceneContact& contact);

}  // namespace flatdyn

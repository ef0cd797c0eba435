// SPDX-License-Identifier: GPL-2.0-or-later
// The directions of the tip that a task is about, and the Jacobian of their rates.
#pragma once

#include <string>
#include <vector>

#include "graph/task.hpp"
#include "symbolic/dynamics/workbench.hpp"

namespace flatdyn {

// Rows of the Jacobian that make up the task, rising: 0 to 2 the velocity along x, y, z, 3 to 5 the rotation about
// them, or the rates of Euler angles. Those that the scene names; else all that are independent at almost every
// position, the first ones where there is a choice (x and y of an arm in the plane). Throws Failure(unsupported) if
// those named depend on each other everywhere.
std::vector<int> task_rows(const Mechanism& mechanism);

// Those of x, y, z along which joints move the tip, also where they do so in one fixed way, as along a curve.
std::vector<int> moved_directions(const Mechanism& mechanism);

// "x, y, z, rx, ry, rz", those of a task; with Euler angles "x, y, z, phi, theta, psi".
std::string task_text(const std::vector<int>& rows, Orientation orientation = Orientation::angular_velocity);

// By row of `rows`, by joint: of the geometric Jacobian, or of the analytical one, (3.62).
Rows task_jacobian(Workbench& bench, const std::vector<int>& rows, Orientation orientation);

// J̇ q̇ of the same rows.
std::vector<Number> task_drift(Workbench& bench, const std::vector<int>& rows, Orientation orientation);

}  // namespace flatdyn

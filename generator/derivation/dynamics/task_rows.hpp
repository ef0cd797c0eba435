// SPDX-License-Identifier: GPL-2.0-or-later
// The directions of the tip that form the task, and the Jacobian of their rates.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "derivation/dynamics/derivation_context.hpp"
#include "graph/task.hpp"

namespace flatdyn {

// The rows of the Jacobian that form the task, ascending: 0 to 2 are the velocity along x, y, z, 3 to 5 the rotation
// about them, or the rates of Euler angles. They are the rows that the scene names; else all that are independent at
// almost every position, the first ones where there is a choice (x and y of a planar arm). Throws Failure(unsupported)
// if the rows named depend on each other everywhere.
std::vector<int> task_rows(const Mechanism& mechanism);

// The rows of a task in words: "x, y, z, rx, ry, rz"; with Euler angles "x, y, z, phi, theta, psi".
std::string task_text(const std::vector<int>& rows, Orientation orientation = Orientation::angular_velocity);

// The task's Jacobian, by row of `rows` and by joint: the geometric one, or the analytical one, (3.62).
Rows task_jacobian(DerivationContext& context, const std::vector<int>& rows, Orientation orientation);

// The sine of ZYZ angles' θ, or the cosine of pitch: the Jacobian of a task with such angles divides by it.
std::optional<Number> divisor_of_angles(DerivationContext& context, const std::vector<int>& rows,
                                        Orientation orientation);

// J̇ q̇ of the same rows.
std::vector<Number> task_drift(DerivationContext& context, const std::vector<int>& rows, Orientation orientation);

}  // namespace flatdyn

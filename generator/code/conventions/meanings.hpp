// SPDX-License-Identifier: GPL-2.0-or-later
// The meanings of arguments and results in a convention: axes, order, units.
#pragma once

#include <string>

#include "code/conventions/convention.hpp"
#include "code/lower/arguments.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// "base: position (world axes, m), quaternion (w, x, y, z); joints: rad or m", and the same for v and tau.
std::string meaning_of_pose(const Convention& convention, JointCounts counts);
std::string meaning_of_velocity(const Convention& convention, JointCounts counts);
std::string meaning_of_force(const Convention& convention, JointCounts counts);

// The meaning of an argument other than g_b, which conventions do not have.
std::string meaning_of_input(InputKind kind, const Convention& convention, JointCounts counts,
                             const Function& function);
// The meaning of a result of a robot with a floating base.
std::string meaning_of_output(const Output& output, const Convention& convention, JointCounts counts);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The functions that conventions have, and what they ask of a function to convert it.
#pragma once

#include <string>
#include <vector>

#include "code/conventions/convention.hpp"
#include "graph/function.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// Throws Failure(unsupported) for a robot with neither a floating base nor spherical joints.
void check_conventions_apply(const Mechanism& mechanism);

// Whether the only output is B, or C.
bool is_of_inertia(const Function& function);
bool is_coriolis(const Function& function);

// Whether the output depends on the acceleration of the base's origin, and on its velocity only through that.
bool depends_on_acceleration(const Output& output);

// Whether the convention has the quaternions of the robot's spherical joints in another order than (w, x, y, z).
bool has_other_quaternions(const Convention& convention, const Mechanism& mechanism);

// Friction of a floating base by the velocity of its origin that flatdyn's functions cannot compute here: viscous
// friction where they are given no velocity of the origin, and Coulomb friction along the axes of the world.
struct FrictionOfOrigin {
  Number viscous = 0, coulomb = 0;  // N s/m, N

  bool is_zero() const { return vanishes(viscous) && vanishes(coulomb); }
};
FrictionOfOrigin friction_of_origin(const Mechanism& mechanism, const Convention& convention);

// Whether it has a part in the function's results.
bool is_rubbed(const Function& function, const Mechanism& mechanism, const Convention& convention);

// Why the function, one of `all` that are emitted, is not there in a convention; empty if it is.
std::string why_not(const Function& adapted, const std::vector<Function>& all, const Convention& convention,
                    const Mechanism& mechanism);

}  // namespace flatdyn

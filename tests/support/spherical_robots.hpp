// SPDX-License-Identifier: GPL-2.0-or-later
// Parts of robots with spherical joints.
#pragma once

namespace flatdyn::testing {

// A base that floats.
inline constexpr const char* kTrunk = R"([base]
name = "trunk"
motion = "floating"
mass = 5
com = [0.02, 0.01, 0]
inertia = { xx = 0.1, yy = 0.3, zz = 0.35, xz = 0.02 }
inertia_about = "com"
)";

// Two bodies that hang from another one.
inline constexpr const char* kHanging = R"(
[[link]]
name = "bob"
joint = "ball"
type = "spherical"
xyz = [0.1, 0.2, 0]
mass = 1.5
com = [0, 0, -0.4]
inertia = { xx = 0.02, yy = 0.03, zz = 0.01 }
inertia_about = "com"
viscous = 0.01
[[link]]
joint = "knee"
xyz = [0, 0.1, -0.8]
rpy = [0.4, 0, 0]
mass = 0.5
com = [0.1, 0, 0.2]
inertia = { xx = 0.02, yy = 0.03, zz = 0.01 }
inertia_about = "com"
motor = { gear_ratio = 20, inertia = 1e-4, carrier = "bob" }
)";

}  // namespace flatdyn::testing

// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace flatdyn::testing {

// Two links with friction and limits.
inline constexpr const char* kFrictionalArm = R"(name = "rubbing_arm"
gravity = [0, "-9.81", 0]
dh = "standard"

[[link]]
joint = "a"
a = 1
mass = 1
com = [-0.5, 0, 0]
inertia = { zz = 0.1 }
inertia_about = "com"
coulomb = 2
viscous = 0.1
limits = { lower = -3, upper = 0.5, velocity = 5, effort = 30 }

[[link]]
joint = "b"
a = 0.8
mass = 0.7
com = [-0.4, 0, 0]
inertia = { zz = 0.05 }
inertia_about = "com"
coulomb = 0.5
viscous = 0.05
limits = { lower = -1, upper = 1, velocity = 5, effort = 10 }
)";

}  // namespace flatdyn::testing

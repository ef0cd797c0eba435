// SPDX-License-Identifier: GPL-2.0-or-later
// Closed loops in space whose cut is an axis on an axis.
#pragma once

#include <string>

namespace flatdyn::testing {

// Crank, rod, bar, and a rocker on a tilted post; between bar and rocker is a ball joint.
inline const std::string kBarToRocker = R"(name = "bar_to_rocker"
gravity = [0.5, -1, -9.81]
[[link]]
name = "crank"
joint = "q1"
axis = [0, 0, 1]
mass = 1.2
com = [0.1, 0.02, 0.01]
inertia = { xx = 0.01, yy = 0.02, zz = 0.02, xy = 0.003 }
inertia_about = "com"
viscous = 0.2
[[link]]
name = "rod"
joint = "q2"
axis = [0.2, 1, 0]
xyz = [0.2, 0, 0.1]
mass = 0.9
com = [0.2, 0, 0.05]
inertia = { xx = 0.006, yy = 0.008, zz = 0.007, xz = 0.001 }
inertia_about = "com"
[[link]]
name = "bar"
joint = "q3"
axis = [0, 0.3, 1]
xyz = [0.4, 0.1, 0]
mass = 0.8
com = [0.1, 0.03, 0]
inertia = { xx = 0.005, yy = 0.007, zz = 0.006 }
inertia_about = "com"
[[link]]
name = "post"
joint = "bolt"
type = "fixed"
parent = "base"
xyz = [0.5, -0.2, 0.1]
rpy = [0.3, 0.2, 0]
)";

// Seven revolute joints, cut at the rocker's hinge: the ball is three of them.
inline const std::string kCutAtHinge = kBarToRocker + R"([[link]]
joint = "b1"
parent = "bar"
axis = [1, 0, 0]
xyz = [0.35, 0, 0.05]
[[link]]
joint = "b2"
axis = [0, 1, 0]
[[link]]
name = "rocker"
joint = "b3"
axis = [0, 0, 1]
mass = 0.7
com = [0.1, 0.02, 0.03]
inertia = { xx = 0.003, yy = 0.004, zz = 0.005 }
inertia_about = "com"
[[loop]]
links = ["rocker", "post"]
from = [0.3, 0.1, 0]
from_axis = [0, 0, 1]
to_axis = [0, 0, 2]
dependent = ["q2", "q3", "b1", "b2", "b3"]
[assembly]
q1 = 0.5
)";

// The same rocker, its frame at its hinge, cut at the ball.
inline const std::string kCutAtBall = kBarToRocker + R"([[link]]
name = "rocker"
joint = "q7"
parent = "post"
mass = 0.7
com = [-0.2, -0.08, 0.03]
inertia = { xx = 0.003, yy = 0.004, zz = 0.005 }
inertia_about = "com"
[[loop]]
links = ["bar", "rocker"]
from = [0.35, 0, 0.05]
to = [-0.3, -0.1, 0]
dependent = ["q2", "q3", "q7"]
)";

// On a table that turns: two ways from it, with a slide in each, to the hinge that is cut.
inline const std::string kCylinders = R"(name = "cylinders"
gravity = [0.3, 0.2, -9.81]
[[link]]
name = "table"
joint = "turn"
axis = [0, 0.3, 1]
mass = 2
com = [0.1, 0.1, 0]
inertia = { zz = 0.2 }
inertia_about = "com"
[[link]]
name = "crank"
joint = "a1"
axis = [1, 0.2, 0]
xyz = [0.1, 0.1, 0.2]
mass = 1
com = [0.1, 0.02, 0]
inertia = { xx = 0.01, yy = 0.02, zz = 0.02, xy = 0.003 }
inertia_about = "com"
viscous = 0.2
[[link]]
name = "sleeve"
joint = "a2"
axis = [0, 1, 0.5]
xyz = [0, 0.3, 0.1]
[[link]]
name = "rod"
joint = "a3"
type = "prismatic"
axis = [0, 1, 0.5]
mass = 0.5
com = [0.2, 0.05, 0.01]
inertia = { xx = 0.004, yy = 0.006, zz = 0.005, xz = 0.001 }
inertia_about = "com"
coulomb = 0.1
[[link]]
name = "lever"
joint = "b1"
parent = "table"
axis = [0, 0, 1]
xyz = [0.5, -0.1, 0.1]
mass = 0.7
com = [0.2, 0, 0]
[[link]]
name = "collar"
joint = "b2"
type = "prismatic"
axis = [0, 0, 1]
[[link]]
name = "fork"
joint = "b3"
axis = [1, 0.4, 0]
xyz = [0.3, 0, 0.1]
mass = 0.4
com = [0.1, 0.02, -0.03]
[[loop]]
links = ["rod", "fork"]
from = [0.3, 0.1, 0]
to = [0.2, 0, 0.1]
from_axis = [2, 1, 2]
to_axis = [0, 1, 3]
dependent = ["a2", "a3", "b1", "b2", "b3"]
)";

// All axes go through one point; the loop is cut away from it.
inline const std::string kSphericalFourBar = R"(name = "spherical"
gravity = [0.5, -1, -9.81]
[[link]]
name = "crank"
joint = "q1"
axis = [0, 0, 1]
xyz = [0.1, 0.2, 0.3]
mass = 1.2
com = [0.1, 0.02, 0.01]
[[link]]
name = "coupler"
joint = "q2"
axis = [0.5, 0, 1]
mass = 0.9
com = [0.2, 0, 0.05]
inertia = { xx = 0.006, yy = 0.008, zz = 0.007, xz = 0.001 }
inertia_about = "com"
[[link]]
name = "rocker"
joint = "q3"
parent = "base"
axis = [0.6, 0, 1]
xyz = [0.7, 0.2, 1.3]
mass = 0.8
com = [0.1, 0.03, 0]
inertia = { xx = 0.005, yy = 0.007, zz = 0.006 }
inertia_about = "com"
[[loop]]
links = ["coupler", "rocker"]
from = [0.0, 0.5, 1]
to = [-0.6, 0.3, -0.3]
from_axis = [0, 0.5, 1]
to_axis = [0, 0.3, 0.7]
dependent = ["q2", "q3"]
[assembly]
q1 = 0.5
q2 = 1.0
q3 = 1.0
)";

// Beyond a coupler and a link called last: three more hinges, and the one that is cut.
inline const std::string kHingeOfCarried = R"([[link]]
name = "u1"
joint = "u1"
parent = "coupler"
axis = [1, 0.3, 0]
xyz = [0.3, 0, 0.05]
mass = 0.3
com = [0.05, 0.02, 0.03]
inertia = { xx = 0.004, yy = 0.0052, zz = 0.0062, xy = 0.0001, xz = 0.0003, yz = -0.0004 }
inertia_about = "com"
[[link]]
name = "u2"
joint = "u2"
axis = [0, 1, 0.4]
xyz = [0.1, 0.05, 0]
mass = 0.25
com = [0.04, 0.01, 0.03]
inertia = { xx = 0.003, yy = 0.0042, zz = 0.0052, xy = 0.0001, xz = 0.0003, yz = -0.0004 }
inertia_about = "com"
[[link]]
name = "u3"
joint = "u3"
parent = "last"
axis = [0.2, 1, 0]
xyz = [0.3, 0, 0.02]
mass = 0.28
com = [0.05, -0.01, 0.03]
inertia = { xx = 0.003, yy = 0.0043, zz = 0.0053, xy = 0.0001, xz = 0.0002, yz = -0.0004 }
inertia_about = "com"
[[loop]]
links = ["u2", "u3"]
from = [0.1, 0.02, 0.03]
to = [0.15, 0, 0.05]
from_axis = [1, 1, 0]
to_axis = [1, 0, 0.5]
dependent = ["t2", "t3", "u1", "u2", "u3"]
)";

}  // namespace flatdyn::testing

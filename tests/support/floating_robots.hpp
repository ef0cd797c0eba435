// SPDX-License-Identifier: GPL-2.0-or-later
// Small robots with a floating base, as TOML.
#pragma once

#include <string>

namespace flatdyn::testing {

// A body with an arm of a turn and a slide, a rotor on each, friction, and a branch.
inline constexpr const char* kSatellite = R"(name = "satellite"
[base]
name = "bus"
motion = "floating"
mass = 20
com = [0.1, -0.2, 0.05]
inertia = { xx = 2, yy = 3, zz = 2.5, xy = 0.1, xz = -0.2, yz = 0.3 }
inertia_about = "com"
[[link]]
joint = "shoulder"
xyz = [0.4, 0.1, 0.2]
rpy = [0.3, "pi/2", 0]
mass = 3
com = [0.2, 0.1, 0]
inertia = { xx = 0.03, yy = 0.04, zz = 0.05, xy = 0.002 }
inertia_about = "com"
viscous = 0.3
motor = { mass = 0.4, inertia = 1e-3, inertia_transverse = 2e-3, gear_ratio = 40, axis = [0, 1, 0], position = [0.1, 0, 0] }
[[link]]
joint = "rail"
type = "prismatic"
axis = [1, 1, 0]
xyz = [0.4, 0, 0]
mass = 2
com = [0.2, 0, 0.05]
inertia = { xx = 0.01, yy = 0.02, zz = 0.02 }
inertia_about = "com"
coulomb = 0.2
motor = { mass = 0.1, inertia = 1e-4, gear_ratio = 20 }
[[link]]
joint = "panel"
parent = "bus"
xyz = [-0.5, 0, 0]
rpy = ["pi/2", 0, 0]
mass = 1
com = [0, 0.3, 0.1]
inertia = { xx = 0.04, yy = 0.03, zz = 0.02 }
inertia_about = "com"
armature = 0.01
)";

// The same with armature and friction of the base itself.
inline std::string heavy_satellite() {
  std::string text = kSatellite;
  const std::string motion = "motion = \"floating\"\n";
  text.insert(text.find(motion) + motion.size(), "armature = 1.5\nviscous = 0.7\ncoulomb = 0.4\n");
  return text;
}

// A knee that follows joints of two branches, with friction, a rotor and a constant part, and a slide that follows a
// turn.
inline constexpr const char* kLander = R"(name = "lander"
[base]
name = "hull"
motion = "floating"
mass = 12
com = [0.1, -0.1, 0.05]
inertia = { xx = 1, yy = 1.5, zz = 1.2, xy = 0.1, yz = 0.2 }
inertia_about = "com"
[[link]]
name = "thigh"
joint = "hip"
xyz = [0.3, 0.1, -0.2]
rpy = ["pi/2", 0, 0.4]
mass = 2
com = [0.1, 0.02, 0]
inertia = { xx = 0.02, yy = 0.03, zz = 0.03, xz = 0.003 }
inertia_about = "com"
viscous = 0.2
motor = { mass = 0.3, inertia = 1e-3, gear_ratio = 30, carrier = "hull" }
[[link]]
name = "shin"
joint = "knee"
position = "0.3 - 2*hip + mast/2"
xyz = [0.3, 0, 0]
mass = 1
com = [0.1, 0, 0.01]
inertia = { xx = 0.01, yy = 0.02, zz = 0.02 }
inertia_about = "com"
viscous = 0.1
coulomb = 0.05
[[link]]
name = "antenna"
joint = "mast"
parent = "hull"
axis = [1, 0, 0]
xyz = [0, 0.3, 0]
mass = 0.4
com = [0, 0.1, 0.1]
inertia = { xx = 0.004, yy = 0.003, zz = 0.002 }
inertia_about = "com"
armature = 0.01
stiffness = 3
[[link]]
name = "tip"
joint = "slide"
type = "prismatic"
position = "mast/10"
axis = [1, 0, 1]
xyz = [0.2, 0, 0.1]
mass = 0.2
com = [0, 0.02, 0.01]
inertia = { xx = 0.001, yy = 0.002, zz = 0.002 }
inertia_about = "com"
)";

inline constexpr const char* kDrone = R"(name = "drone"
[base]
motion = "floating"
mass = 1.5
com = [0.01, 0.02, -0.03]
inertia = { xx = 0.02, yy = 0.03, zz = 0.04, xy = 0.001 }
inertia_about = "com"
)";

}  // namespace flatdyn::testing

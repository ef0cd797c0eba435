// SPDX-License-Identifier: GPL-2.0-or-later
// How other programs write the state of a robot with a floating base or spherical joints.
#pragma once

#include <string>
#include <vector>

#include "code/emit/generated_file.hpp"

namespace flatdyn {

// In every convention q is position and quaternion of the base, then joints; a is the derivative of the entries of v,
// and v^T tau is power. So the axes and the order of the base's entries in v say all. Spherical joints have a
// quaternion in q, and angular velocity and moment in the child's axes.
struct Convention {
  const char* name;       // as in --convention, and the namespace: "mujoco"
  const char* whose;      // "MuJoCo"
  bool scalar_first;      // whether quaternions are (w, x, y, z), else (x, y, z, w)
  bool linear_in_world;   // whether velocity of and force on the base are in world axes, else in base axes
  bool angular_in_world;  // whether its angular velocity and moment are
  bool angular_first;     // whether these two come first

  // Whether v, a and tau are as in flatdyn's functions.
  bool is_plain() const { return !linear_in_world && !angular_in_world && !angular_first; }
};

const std::vector<Convention>& conventions();

// The names of all conventions, in order.
std::vector<std::string> convention_names();

// The functions of a robot in a convention, over those of its code.
struct ConventionHeader {
  GeneratedFile file;                 // "quadruped12_mujoco.hpp"
  std::vector<std::string> left_out;  // a sentence per function that has no adaptor
};

// Throws Failure(bug) if there is no convention of this name.
const Convention& convention_of(const std::string& name);

}  // namespace flatdyn

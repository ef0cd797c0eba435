// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "input/urdf/values.hpp"

namespace flatdyn {

// Rotor inertias and gear ratios of a URDF's joints: <drake:rotor_inertia>, <drake:gear_ratio> in a <joint> or in the
// <actuator> of its <transmission>, <mechanicalReduction> there, and the attribute `armature` of <dynamics>. A rotor
// inertia adds gear_ratio^2 · rotor_inertia to b_ii only (Joint::armature); without one, gear ratios have no effect.
void read_urdf_actuators(const tinyxml2::XMLElement& root, const UrdfValues& values, Robot& robot);

}  // namespace flatdyn

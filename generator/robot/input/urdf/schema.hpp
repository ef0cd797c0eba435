// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "robot/input/common/schema.hpp"

namespace flatdyn {

// The elements of URDF that hold others; those that hold values are in entries.hpp.
const Schema& urdf_schema();

// The elements that the numbers of a rotor stand in, with blanks between them.
extern const char* const kUrdfRotorNames;

}  // namespace flatdyn

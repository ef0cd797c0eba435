// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "robot/input/common/schema.hpp"

namespace flatdyn {

// The elements of SDF that are read, and what may stand in them.
const Schema& sdf_schema();

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "robot/input/common/schema.hpp"

namespace flatdyn {

// The elements of MJCF: what changes the dynamics, and what has nothing to do with it. Sections that have nothing to do
// with dynamics have no rows.
const Schema& mjcf_schema();

}  // namespace flatdyn

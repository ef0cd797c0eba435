// SPDX-License-Identifier: GPL-2.0-or-later
// Equalities: a joint that follows another one, closed chains, bodies that are welded to the world.
#pragma once

#include "input/mjcf/model.hpp"

namespace flatdyn {

void read_mjcf_equalities(const MjcfModel& model);

}  // namespace flatdyn

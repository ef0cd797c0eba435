// SPDX-License-Identifier: GPL-2.0-or-later
// Equalities: joints that follow others, by themselves or through tendons, closed chains, bodies that are welded to the
// world. Tendons and actuators are read before.
#pragma once

#include "robot/input/mjcf/model.hpp"

namespace flatdyn {

void read_mjcf_equalities(MjcfModel& model);

}  // namespace flatdyn

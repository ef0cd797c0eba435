// SPDX-License-Identifier: GPL-2.0-or-later
// Which way closed loops are assembled: elbow up or down.
#pragma once

#include "diagnostics/diagnostics.hpp"
#include "model/mechanism.hpp"
#include "model/robot.hpp"

namespace flatdyn {

// Names of joints that are none, or whose positions are not entries of q, are errors.
void check_assembly(const Robot& robot, Diagnostics& diagnostics);

// By entry of q, rad or m, near positions at which the loops are closed: the robot file's [assembly], else 0.
std::vector<double> assembled_positions(const Robot& robot, const Mechanism& mechanism);

}  // namespace flatdyn

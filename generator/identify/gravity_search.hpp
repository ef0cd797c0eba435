// SPDX-License-Identifier: GPL-2.0-or-later
// The direction of gravity that fits a log best, whatever the masses are.
#pragma once

#include <Eigen/Core>

#include "identify/row_sample.hpp"
#include "load/loaded_robot.hpp"

namespace flatdyn {

struct GravityFit {
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // g_0 in the base frame, as long as the robot file's, m/s²
  double angle = 0;                                   // from the robot file's, rad
  double cost = 0;                                    // RowSample's
};

// Tries directions about the robot file's, then all around, and finer ones about the best. All 13 parameters of each
// joint are free: with another direction, other combinations of them act. For open chains.
GravityFit gravity_direction(const TorqueModel& model, const LoadedRobot& robot, const RowSample& rows);

}  // namespace flatdyn

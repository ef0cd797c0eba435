// SPDX-License-Identifier: GPL-2.0-or-later
// The direction of gravity that fits a log best, whatever the masses are.
#pragma once

#include <Eigen/Core>

#include "functions/load/loaded_robot.hpp"
#include "laboratory/identify/row_sample.hpp"

namespace flatdyn {

struct GravityFit {
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // g_0 in the base frame, as long as the robot file's, m/s²
  double angle = 0;                                   // from the robot file's, rad
  double cost = 0;                                    // of the sample's rows
  // The space in which rows determine gravity: 3 × 0 … 3, columns of unit length, across each other. Across it,
  // gravity is the robot file's.
  Eigen::Matrix3Xd told = Eigen::Matrix3Xd::Identity(3, 3);
};

// Seeks from the robot file's direction, and from the best one of all around. All 13 parameters of each joint are free:
// with another direction, other combinations of them act. The component along axes that all joints
// share is left as it is, since no torque depends on it, and so is one that turns the direction in a way that noise
// hides (a standard deviation above 0.25 rad). For open chains.
GravityFit gravity_direction(const LoadedRobot& robot, const RowSample& sample);

// The cost without gravity. For open chains.
double cost_without_gravity(const LoadedRobot& robot, const RowSample& sample);

// How gravity changes when its direction turns within the space `told`: 3 × 0 … 2, m/s² per rad.
Eigen::Matrix3Xd turns_of_gravity(const Eigen::Vector3d& gravity, const Eigen::Matrix3Xd& told);

// Gravity turned by angles, rad, along turns_of_gravity(); its length, and its component across `told`, stay.
Eigen::Vector3d turned_gravity(const Eigen::Vector3d& gravity, const Eigen::Matrix3Xd& told,
                               const Eigen::VectorXd& angles);

// The directions orthogonal to the columns of `told`, of unit length.
std::vector<Eigen::Vector3d> untold_directions(const Eigen::Matrix3Xd& told);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// How the torques change with gravity: columns of the equations by which gravity's direction is estimated with all
// other parameters.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "flatdyn/reference/newton_euler.hpp"
#include "functions/load/loaded_robot.hpp"
#include "laboratory/identify/torque_model.hpp"

namespace flatdyn {

// π, 13 n numbers: the robot file's, changed at the kept places so that it has the base parameters `pi_b`.
Eigen::VectorXd whole_parameters(const TorqueModel& model, const LoadedRobot& robot, const Eigen::VectorXd& pi_b);

class GravityColumns {
 public:
  // pi: 13 n numbers. slopes: how g_0 changes by each unknown, such as m/s² per rad.
  GravityColumns(const TorqueModel& model, const LoadedRobot& robot, const Eigen::VectorXd& pi,
                 std::vector<Eigen::Vector3d> slopes);

  int size() const { return static_cast<int>(slopes_.size()); }
  const std::vector<Eigen::Vector3d>& slopes() const { return slopes_; }
  // The change of the joints' torques by each unknown, n × size(), N m or N, at q.
  Eigen::MatrixXd at(const Eigen::VectorXd& q) const;

 private:
  std::vector<Eigen::Vector3d> slopes_;
  int joints_;
  std::vector<std::vector<reference::Robot<double>>> units_;  // by unknown: bodies with one parameter, in that gravity
  std::vector<double> values_;                                // of these parameters
};

}  // namespace flatdyn

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
  // pi: 13 n numbers. slopes: by column, how g_0 changes by an unknown, such as m/s² per rad.
  GravityColumns(const TorqueModel& model, const LoadedRobot& robot, const Eigen::VectorXd& pi,
                 Eigen::Matrix3Xd slopes);

  int size() const { return static_cast<int>(slopes_.cols()); }
  const Eigen::Matrix3Xd& slopes() const { return slopes_; }
  // The change of the joints' torques by each unknown, n × size(), N m or N, at q.
  Eigen::MatrixXd at(const Eigen::VectorXd& q) const;

 private:
  Eigen::Matrix3Xd slopes_;
  int joints_;
  std::vector<std::vector<reference::Robot<double>>> units_;  // by unknown: bodies with one parameter, in that gravity
  std::vector<double> values_;                                // of these parameters
};

}  // namespace flatdyn

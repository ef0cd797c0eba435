// SPDX-License-Identifier: GPL-2.0-or-later
// Positions of all joints of a robot with closed loops, along motions given by the independent joints.
#pragma once

#include <optional>
#include <span>

#include "flatdyn/reference/robot.hpp"
#include "functions/load/loaded_robot.hpp"
#include "laboratory/trajectory/trajectory.hpp"

namespace flatdyn {

class ClosedPositions {
 public:
  // Starts at the robot's assembly. Throws Failure(unsupported) for a robot with loops and free symbols, Failure(input)
  // where the loops cannot be closed near it.
  explicit ClosedPositions(const LoadedRobot& model);

  // Positions q of all joints, rad or m, for those of the independent joints (n numbers; the result may be q_a itself
  // if there are no loops). The dependent joints follow continuously from the previous call, so that the loops keep
  // their assembly; valid until the next call. Throws Failure(input) if the loops become singular or cannot be closed
  // on the way.
  std::span<const double> of(std::span<const double> q_a);
  // The positions at a point of a motion, whose time is then named in messages.
  std::span<const double> at(const TrajectoryPoint& point);
  // For functions that report a singularity at the positions given last. Throws Failure(input).
  [[noreturn]] void refuse_singular() const;

 private:
  bool close(const Eigen::VectorXd& q_a);
  std::string place_text(const Eigen::VectorXd& q_a) const;

  std::vector<int> independent_;  // indices into q of the independent joints, and the names of these
  std::vector<std::string> joints_;
  std::optional<reference::Robot<double>> robot_;  // with loops
  double tolerance_ = 0;                           // m
  Eigen::VectorXd q_;
  std::optional<double> time_;  // s
};

// The positions of all joints by point of a motion; those of the trajectory itself if there are no loops. Throws like
// ClosedPositions.
std::vector<std::vector<double>> positions_along(const LoadedRobot& model, const Trajectory& trajectory);

}  // namespace flatdyn

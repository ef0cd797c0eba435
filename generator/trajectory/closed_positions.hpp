// SPDX-License-Identifier: GPL-2.0-or-later
// Positions of all joints of a robot with closed loops, along motions that are given by the independent ones.
#pragma once

#include <optional>
#include <span>

#include "flatdyn/reference/robot.hpp"
#include "load/loaded_robot.hpp"
#include "trajectory/trajectory.hpp"

namespace flatdyn {

class ClosedPositions {
 public:
  // Starts at the robot's assembly. Throws Failure(unsupported) for a robot with loops and free symbols, Failure(input)
  // where the loops cannot be closed near it.
  explicit ClosedPositions(const LoadedRobot& model);

  // q, rad or m, for that of the independent joints (n numbers, which it may be itself where there are no loops). The
  // dependent ones follow continuously from where they were the last time, so that the loops stay assembled as they
  // are; valid until the next call. Throws Failure(input) where that leads to a position in which the loops are
  // singular or cannot be closed.
  std::span<const double> of(std::span<const double> q_a);
  // The same at a point of a motion, whose time messages then name.
  std::span<const double> at(const TrajectoryPoint& point);
  // For functions that say so of the positions given last.
  [[noreturn]] void refuse_singular() const;

 private:
  bool close(const Eigen::VectorXd& q_a);
  std::string place_text(const Eigen::VectorXd& q_a) const;

  std::vector<int> independent_;  // entries of q, and their joints' names
  std::vector<std::string> joints_;
  std::optional<reference::Robot<double>> robot_;  // with loops
  double tolerance_ = 0;                           // m
  Eigen::VectorXd q_;
  std::optional<double> time_;  // s
};

// Along a motion, by point; those of the trajectory itself where there are no loops. Throws as ClosedPositions does.
std::vector<std::vector<double>> positions_along(const LoadedRobot& model, const Trajectory& trajectory);

}  // namespace flatdyn

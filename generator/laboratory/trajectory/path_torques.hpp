// SPDX-License-Identifier: GPL-2.0-or-later
// The torques of a motion along its path at another pace, 7.7. With s the time of the given motion and s(t) the new
// law, q̇ = q' ṡ and q̈ = q' s̈ + q'' ṡ², where q', q'' are the rates and accelerations given, and
//   τ = m s̈ + a ṡ² + b ṡ + d,
// m = B q', a = B q'' + C(q, q') q' (7.125), b = F_v q', d = g + k (q - q_0) + F_s sgn(q') + Jᵀ h_e: gravity, springs,
// Coulomb friction and the tip's force do not depend on the pace; viscous friction is proportional to it.
#pragma once

#include <vector>

#include "base/diagnostics/progress.hpp"
#include "functions/load/loaded_robot.hpp"
#include "graph/tape.hpp"
#include "laboratory/trajectory/closed_positions.hpp"
#include "laboratory/trajectory/trajectory.hpp"
#include "robot/model/joint_friction.hpp"

namespace flatdyn {

// The coefficients by point, n numbers each, in N m or N times s², s or 1.
struct PathCoefficients {
  std::size_t joints = 0;
  std::vector<double> m, a, b, d;
  std::vector<double> a_before;  // a with the q'' before the point, where q'' jumps

  std::size_t points() const { return d.size() / joints; }
};

class PathTorques {
 public:
  // Throws Failure(unsupported) for a robot with free symbols or smooth friction.
  PathTorques(const LoadedRobot& model, bool tip_force, Progress& progress);

  // The coefficients at each point. Not thread-safe.
  PathCoefficients coefficients(const Trajectory& trajectory);
  // The torques of the motion at its own pace by point, N m or N.
  std::vector<std::vector<double>> torques(const Trajectory& trajectory);

 private:
  void run(const TrajectoryPoint& point);
  void refuse_smooth_friction() const;

  std::size_t n_;
  ClosedPositions closed_;
  std::vector<Tape> tapes_;              // inverse dynamics, B, g; J
  std::vector<double> tau_, B_, g_, J_;  // results
  JointFriction friction_;
};

}  // namespace flatdyn

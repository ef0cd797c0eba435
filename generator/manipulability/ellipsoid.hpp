// SPDX-License-Identifier: GPL-2.0-or-later
// The dynamic manipulability ellipsoid, 7.9: which accelerations of the tip the joint torques of one norm can make of
// an arm that stands still.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/progress.hpp"
#include "graph/tape.hpp"
#include "load/loaded_robot.hpp"

namespace flatdyn {

// The ellipsoid (7.148) in the d directions of the task, base axes; accelerations in m/s^2 (rad/s^2). It has r axes:
// fewer than d, and so is flat, where the tip moves on a surface or along a curve.
struct Ellipsoid {
  Eigen::VectorXd centre;   // d: −J B^-1 g, where gravity moves it to
  Eigen::MatrixXd axes;     // d × r: unit vectors by column, the longest axis first
  Eigen::VectorXd lengths;  // r: of the half axes; 0 along directions that the tip cannot move along here
  // √det of the inverse of the core of (7.148), the product of the lengths. Of an arm that is not redundant it is
  // √det(J Jᵀ), the measure (3.56), divided by det B (Problem 7.12).
  double measure = 0;
};

// Half axes by column, the longer first, of the ellipse that a parallel projection makes of an ellipsoid. onto: 2 × d.
Eigen::Matrix2d shadow(const Ellipsoid& ellipsoid, const Eigen::MatrixXd& onto);

// Of the lines between points that follow each other.
double length_of(const std::vector<Eigen::Vector3d>& skeleton);

// What the norm of joint torques is.
enum class TorqueNorm {
  plain,   // √(τᵀ τ), (7.142)
  limits,  // each torque as a part of its joint's effort limit
};

class Manipulability {
 public:
  // The task is the scene's, else those of x, y, z that the tip can move along. Throws Failure(unsupported) where the
  // robot has free symbols, or has no effort limits though they are asked for.
  // radius: of the torques' sphere, N m, or of their parts of the limits.
  Manipulability(const LoadedRobot& model, TorqueNorm norm, double radius, Progress& progress);

  const std::vector<int>& task() const { return task_; }

  // At q, rad or m. Throws Failure(input) where B is not positive definite.
  Ellipsoid at(const std::vector<double>& q);
  // Origins of the frames from the base to the tip, m.
  std::vector<Eigen::Vector3d> skeleton(const std::vector<double>& q);

 private:
  std::vector<double> values(Tape& tape, const std::vector<double>& q) const;

  std::vector<int> task_;
  Eigen::Index rank_;
  Eigen::VectorXd torque_unit_;  // by joint
  std::optional<Tape> inertia_, gravity_, jacobian_;
  std::vector<Tape> frames_;  // of the links on the way to the tip
};

}  // namespace flatdyn

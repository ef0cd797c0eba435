// SPDX-License-Identifier: GPL-2.0-or-later
// Where the tip is, how it moves, and joint positions that take it to a place. Base axes, SI.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <stdexcept>

#include "flatdyn/reference/kinematics.hpp"
#include "flatdyn/reference/tangent.hpp"
#include "model/robot.hpp"

namespace flatdyn {

// No joint positions, or no joint rates, do what is wanted of the tip.
class Unreachable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct TipGoal {
  Eigen::Vector3d p;                 // of the tip's origin, m
  std::optional<Eigen::Matrix3d> R;  // if the orientation matters, too
};

// The exact kinematics of the robot file, tip frame and held joints included.
class TipKinematics {
 public:
  // Throws Failure(unsupported) for a robot with free symbols.
  explicit TipKinematics(const Robot& robot);

  int joints() const { return robot_.size(); }
  reference::Pose<double> pose(const Eigen::VectorXd& q) const { return reference::tip_pose(robot_, q); }
  // Rows of the geometric Jacobian (7.14): the first three, or all six.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& q, int rows) const;
  // Its derivative along q̇.
  Eigen::MatrixXd jacobian_rate(const Eigen::VectorXd& q, const Eigen::VectorXd& qd, int rows) const;
  // What is left to go: position, m; with an orientation also the turn that is missing, rad. 3 or 6 numbers.
  Eigen::VectorXd missing(const TipGoal& goal, const Eigen::VectorXd& q) const;

  const reference::Robot<double>& robot() const { return robot_; }

 private:
  reference::Robot<double> robot_;
  reference::Robot<reference::Tangent<double>> with_slopes_;
};

// Damped least squares (Levenberg and Marquardt) from a guess: the damping goes to zero with the error, so that the
// result is exact where it exists. Throws Unreachable.
Eigen::VectorXd inverse_kinematics(const TipKinematics& tip, const TipGoal& goal, const Eigen::VectorXd& guess);

// Which of the two postures of a planar arm: down, if the second link is turned counterclockwise against the first,
// seen against the first joint's axis. With that axis towards the viewer and a tip to the right, the elbow is then
// below.
enum class Elbow { down, up };

// Two revolute joints with parallel axes: the closed form (2.91)–(2.96).
class TwoLinkArm {
 public:
  // nullopt for any other robot.
  static std::optional<TwoLinkArm> of(const TipKinematics& tip);

  // q with both angles in (−π, π]. Throws Unreachable.
  Eigen::VectorXd positions(const Eigen::Vector3d& p, Elbow elbow) const;
  Elbow elbow_of(const Eigen::VectorXd& q) const;

 private:
  Eigen::Vector2d in_plane(const Eigen::Vector3d& p) const;

  Eigen::Vector3d origin_, x_, y_, z_;  // of the first axis, and axes of which z is along it
  double height_ = 0;                   // of the tip's plane along z
  double a_1_ = 0, a_2_ = 0;            // lengths of the links
  double phi_1_ = 0, phi_2_ = 0;        // their angles where q = 0
  double sense_ = 1;                    // −1 if the second axis points the other way
};

}  // namespace flatdyn

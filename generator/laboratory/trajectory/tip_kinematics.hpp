// SPDX-License-Identifier: GPL-2.0-or-later
// The tip's place and motion, and joint positions that take it to a place. Base axes, SI.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <stdexcept>

#include "flatdyn/reference/kinematics.hpp"
#include "flatdyn/reference/tangent.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// No joint positions, or no joint rates, give the tip the wanted place or motion.
class Unreachable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct TipGoal {
  Eigen::Vector3d p;                 // origin of the tip frame, m
  std::optional<Eigen::Matrix3d> R;  // orientation, if it matters
};

// The exact kinematics of the robot file, with the tip frame and held joints.
class TipKinematics {
 public:
  // Throws Failure(unsupported) for a robot with free symbols. The base is fixed.
  explicit TipKinematics(const Robot& robot);

  // Entries of q̇. q has four of a spherical joint, its quaternion (w, x, y, z) of any length; q̇ has three, the angular
  // velocity in the child's axes.
  int joints() const { return robot_.size(); }
  reference::Pose<double> pose(const Eigen::VectorXd& q) const;
  // The first three rows of the geometric Jacobian (7.14), or all six.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& q, int rows) const;
  // q after a small motion, by entries of q̇: a sum, or for a spherical joint the turn R ← R exp(S(step)).
  Eigen::VectorXd moved(const Eigen::VectorXd& q, const Eigen::VectorXd& step) const;
  // The derivative of the Jacobian along q̇; not for spherical joints.
  Eigen::MatrixXd jacobian_rate(const Eigen::VectorXd& q, const Eigen::VectorXd& qd, int rows) const;
  // The remaining displacement to the goal: position, m; with an orientation also the rotation vector, rad. 3 or 6
  // numbers.
  Eigen::VectorXd missing(const TipGoal& goal, const Eigen::VectorXd& q) const;

  const reference::Robot<double>& robot() const { return robot_; }

 private:
  reference::Robot<double> robot_;
  reference::Robot<reference::Tangent<double>> with_slopes_;
};

// Damped least squares (Levenberg and Marquardt) from a guess, rad or m. The damping goes to zero with the error, so an
// existing solution is found exactly. Throws Unreachable.
Eigen::VectorXd inverse_kinematics(const TipKinematics& tip, const TipGoal& goal, const Eigen::VectorXd& guess);

// The two postures of a planar arm. `down`: the second link is turned counterclockwise against the first, seen against
// the first joint's axis. With that axis towards the viewer and the tip to the right, the elbow is below.
enum class Elbow { down, up };

// Inverse kinematics of two revolute joints with parallel axes: the closed form (2.91)–(2.96).
class TwoLinkArm {
 public:
  // nullopt for any other robot.
  static std::optional<TwoLinkArm> of(const TipKinematics& tip);

  // q with both angles in (−π, π]. Throws Unreachable.
  Eigen::VectorXd positions(const Eigen::Vector3d& p, Elbow elbow) const;
  Elbow elbow_of(const Eigen::VectorXd& q) const;

 private:
  Eigen::Vector2d in_plane(const Eigen::Vector3d& p) const;

  Eigen::Vector3d origin_, x_, y_, z_;  // point of the first axis, and base vectors with z along it
  double height_ = 0;                   // height of the tip's plane along z
  double a_1_ = 0, a_2_ = 0;            // lengths of the links
  double phi_1_ = 0, phi_2_ = 0;        // the links' angles at q = 0
  double sense_ = 1;                    // −1 if the second axis points the other way
};

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The dynamic manipulability ellipsoid, 7.9: the accelerations of the tip that joint torques of bounded norm can
// produce while the arm stands still, by all torques or, as in the textbook, by those of least joint accelerations.
//
// With a floating base nothing holds the base, which is at rest, and only the joints' torques act on the robot; the
// base's accelerations follow from the joints'. The tip's acceleration is that for an observer at rest, in base axes.
// So the textbook's J and B become the generalised Jacobian J* and the inertia matrix B* of the joints (Y. Umetani, K.
// Yoshida, "Resolved motion rate control of space manipulators with generalized Jacobian matrix", IEEE Transactions on
// Robotics and Automation 5(3), 1989), and "least accelerations" are those of the joints.
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "functions/load/loaded_robot.hpp"
#include "graph/tape.hpp"

namespace flatdyn {

// The ellipsoid in the d directions of the task, base axes; accelerations in m/s^2 (rad/s^2). It has r axes; r
// < d, a flat ellipsoid, if the tip moves on a surface or along a curve.
struct Ellipsoid {
  Eigen::VectorXd centre;   // d: −J B^-1 g, the shift by gravity and springs; with a floating base g_b, as all parts
                            // fall alike, and the shift by springs
  Eigen::MatrixXd axes;     // d × r: unit vectors as columns, the longest axis first
  Eigen::VectorXd lengths;  // r: lengths of the half axes; 0 along directions in which the tip cannot move here
  // The product of the lengths: √det of the inverse of the core of (7.148), or √det(J B^-2 Jᵀ) for all torques. For an
  // arm without redundancy it is √det(J Jᵀ), the measure (3.56), divided by det B (Problem 7.12).
  double measure = 0;
};

// The half axes, as columns, of the ellipse that a parallel projection makes of an ellipsoid, the longer one first.
// onto: 2 × d.
Eigen::Matrix2d projected_axes(const Ellipsoid& ellipsoid, const Eigen::MatrixXd& onto);

// The summed length, m, of the lines between consecutive points.
double length_of(const std::vector<Eigen::Vector3d>& skeleton);

// The norm of joint torques. A spherical joint has three, the moment's components in the child's axes.
enum class TorqueNorm {
  plain,   // √(τᵀ τ), (7.142)
  limits,  // each torque as a share of its joint's effort limit
};

// The torques whose accelerations an ellipsoid has. They differ for redundant arms only.
enum class TorqueSet {
  least_accelerations,  // those that need joint accelerations of least norm, q̈ = J† v̇ (7.145): the ellipsoid (7.148)
  all,                  // any τ: v̇ = J B^-1 (τ − g). It contains the other ellipsoid.
};

// The torques of bounded norm.
struct TorqueBall {
  TorqueNorm norm = TorqueNorm::plain;
  double radius = 1;  // N m, or a share of the limits
  TorqueSet set = TorqueSet::least_accelerations;
};

class Manipulability {
 public:
  // The task is the scene's, or else the directions out of x, y, z along which the joints move the tip. Throws
  // Failure(unsupported) if the robot has free symbols, or lacks the effort limits asked for; see tip_directions, too.
  Manipulability(const LoadedRobot& model, const TorqueBall& torques, Progress& progress);

  const std::vector<int>& task() const { return task_; }

  // The ellipsoid at q, rad or m, or unit quaternions. g_b: gravity in the axes of a floating base, m/s²; a fixed base
  // has that of the robot. Throws Failure(input) if B is not positive definite.
  Ellipsoid at(const std::vector<double>& q, const Eigen::Vector3d& g_b = Eigen::Vector3d::Zero());
  // The origins of the frames from the base to the tip at q, in the base frame, m.
  std::vector<Eigen::Vector3d> skeleton(const std::vector<double>& q);

 private:
  std::vector<double> values(Tape& tape, const std::vector<double>& q) const;
  Ellipsoid of_least_accelerations(const Eigen::MatrixXd& J, const Eigen::MatrixXd& B) const;
  Ellipsoid of_all_torques(const Eigen::MatrixXd& J, const Eigen::LLT<Eigen::MatrixXd>& B) const;

  std::vector<int> task_;
  Eigen::Index rank_ = 0, base_;  // base_: entries of a floating base before those of the joints
  TorqueSet set_;
  Eigen::VectorXd torque_unit_;  // unit of torque by entry of the joints
  std::optional<Tape> inertia_, jacobian_;
  std::optional<Tape> torques_at_rest_;  // those of gravity and springs; with a floating base of springs, if there are
  std::vector<Tape> frames_;             // frames of the links on the way to the tip
};

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The equations of motion (7.42) in numbers, evaluated fast for a simulation.
#pragma once

#include <Eigen/Dense>
#include <optional>

#include "base/diagnostics/progress.hpp"
#include "functions/load/loaded_robot.hpp"
#include "graph/tape.hpp"
#include "laboratory/trajectory/closed_positions.hpp"
#include "robot/model/joint_friction.hpp"

namespace flatdyn {

// B(q) and n(q, q̇) = C q̇ + F_v q̇ + k (q - q_0) + g, with smooth dry friction: all of B q̈ + n = τ except friction that
// jumps at rest, which is no function of the state.
struct MotionTerms {
  Eigen::MatrixXd B;  // n × n, kg m^2 (kg for prismatic joints)
  Eigen::VectorXd n;  // n, N m (N)
};

class JointDynamics {
 public:
  // The dynamics of the whole model: an error budget, entries left out and "static" of a scene are ignored. Throws
  // Failure(unsupported) if the robot has free symbols.
  JointDynamics(const LoadedRobot& model, Progress& progress);

  const Mechanism& mechanism() const { return model_.mechanism; }
  Eigen::Index joints() const { return viscous_.size(); }      // entries of q̇
  const Eigen::VectorXd& viscous() const { return viscous_; }  // F_v, N m s (N s/m)
  const Eigen::VectorXd& coulomb() const { return coulomb_; }  // F_s of friction that jumps, N m (N)
  // F_v q̇ and smooth dry friction, which n has.
  Eigen::VectorXd smooth_friction(const Eigen::VectorXd& qd) const;
  // The armature of a floating base, added to the first six entries of B's diagonal, kg and kg m^2.
  double base_armature() const { return base_armature_; }

  // Turns a floating base: gravity has the direction that it has in axes of this orientation, until the next call.
  void turn_base(const Eigen::Quaterniond& orientation);
  // Turns the spherical joints, until the next call: w of their quaternions, in order, whose x, y and z are in q.
  void turn_spherical_joints(const double* w);

  // B and n at q in rad or m, qd in rad/s or m/s; n numbers each, those of the independent joints if loops are closed.
  // With a floating base six numbers come first; those of q are not read, and those of qd are the base's twist. The
  // three of a spherical joint are x, y, z of its quaternion, and the angular velocity in the child's axes.
  // Throws Failure(input) if the loops cannot be closed.
  const MotionTerms& at(const double* q, const double* qd);
  const MotionTerms& last() const { return result_; }  // the last result of at()
  const Eigen::VectorXd& gravity(const double* q);     // N m (N)
  double potential_energy(const double* q);            // J; with a floating base in its frame's origin
  // The positions of all joints that are not coupled, dependent ones included, with unit quaternions (w, x, y, z) of
  // spherical joints. Valid until the next call of any of these functions.
  std::span<const double> positions(const double* q);

 private:
  TapeInputs inputs(const double* q, const double* qd);
  void place_spherical_joints(const double* q);

  LoadedRobot model_;  // without friction that jumps
  ClosedPositions closed_;
  JointFriction friction_;
  Eigen::VectorXd viscous_, coulomb_;
  double base_armature_ = 0;
  std::optional<Tape> terms_, gravity_, potential_;
  std::vector<double> entries_;
  MotionTerms result_;
  Eigen::VectorXd g_;
  std::vector<double> w_, positions_;       // with spherical joints: w of their quaternions, and q with these
  Eigen::Vector3d gravity_in_world_, g_b_;  // m/s^2; with a floating base
};

}  // namespace flatdyn

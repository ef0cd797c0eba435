// SPDX-License-Identifier: GPL-2.0-or-later
// What the search for an exciting motion makes small: standard deviations of the parameters and, with less weight, the
// condition number, at a few samples, as a smooth function of free coefficients, with its gradient. Columns are divided
// by the lengths that they have in random motions which use the limits: at unit length, a joint could stand nearly
// still, and its columns would look as good as before.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identify/fourier_trajectory.hpp"
#include "identify/motion_limits.hpp"
#include "identify/torque_model.hpp"

namespace flatdyn {

class ExcitationObjective {
 public:
  // `limits`: what the motion may use, about the middle of the positions. Samples lie between the ends, where nothing
  // moves.
  ExcitationObjective(const TorqueModel& model, std::vector<JointLimits> limits, double duration, int harmonics);

  // From now on by the columns' lengths in these motions, of size() coefficients each: root mean squares.
  void scale_by(const std::vector<std::vector<double>>& motions);
  const Eigen::VectorXd& lengths() const { return lengths_; }
  // What torques beyond their limits cost from now on; at first 1.
  void weigh_torques(double weight) { torque_weight_ = weight; }
  // Multiplies each joint's limit of torque by a factor up to 1, but leaves half of what rest does not need.
  void lower_torques(const std::vector<double>& factors);

  // Free coefficients: of every joint a_1, b_1, a_2, …, in units that reach a limit at about 1.
  int size() const { return model_.joints() * terms(); }

  // excitation_cost(), and a penalty for torques beyond their limits. `gradient` of size() or null.
  double operator()(const double* x, double* gradient) const;
  // excitation_cost() of this motion, without the penalty.
  double cost(const FourierTrajectory& trajectory) const;

  // The series that the coefficients stand for. A joint whose limits of position, speed and acceleration these would
  // exceed is scaled down, smoothly, to about the limit.
  FourierTrajectory trajectory(const double* x) const;
  // Those that stand for about this motion, which keeps the limits.
  std::vector<double> coefficients(const FourierTrajectory& trajectory) const;

 private:
  struct Motion;
  int terms() const { return static_cast<int>(basis_[0].cols()); }
  int samples() const { return static_cast<int>(basis_[0].rows()); }
  double time(int sample) const { return duration_ * (sample + 0.5) / samples(); }
  Eigen::VectorXd torques_at_rest() const;
  Motion motion(const double* x) const;
  Eigen::VectorXd state(const Motion& motion, int derivative, int sample) const;
  Eigen::MatrixXd regressor(const Motion& motion) const;
  double torque_penalty(const Eigen::MatrixXd& regressor, Eigen::MatrixXd* slope) const;
  void by_motion(const Motion& motion, const Eigen::MatrixXd& regressor, const Eigen::MatrixXd& slope,
                 Eigen::MatrixXd* by) const;
  void by_coefficients(const Motion& motion, const Eigen::MatrixXd* by, double* gradient) const;

  const TorqueModel& model_;
  std::vector<JointLimits> limits_;
  std::vector<double> rest_;
  std::vector<double> least_torques_;  // limits are not lowered further
  double duration_;
  Eigen::MatrixXd units_;     // terms × joints: a coefficient of 1 is this amplitude of speed
  Eigen::MatrixXd basis_[3];  // samples × terms: q, q̇ and q̈ of each term
  Eigen::VectorXd lengths_;
  double torque_weight_ = 1;
};

}  // namespace flatdyn

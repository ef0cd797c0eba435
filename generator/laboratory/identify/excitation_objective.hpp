// SPDX-License-Identifier: GPL-2.0-or-later
// The objective of the search for an exciting motion: the parameters' standard deviations and, with less weight, the
// condition number, at a few samples, as a smooth function of free coefficients, with its gradient. Columns are divided
// by their lengths in random motions that use the limits: at unit length, the columns of a joint that stands nearly
// still would look as good as any.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "laboratory/identify/fourier_trajectory.hpp"
#include "laboratory/identify/motion_equations.hpp"
#include "laboratory/identify/motion_limits.hpp"

namespace flatdyn {

class ExcitationObjective {
 public:
  // `limits`: the limits of the motion by coordinate, about the middle of the positions. Samples lie between the ends,
  // where nothing moves.
  ExcitationObjective(const MotionEquations& equations, std::vector<JointLimits> limits, double duration,
                      int harmonics);

  // Sets the columns' lengths to their root mean squares in these motions, of size() coefficients each.
  void scale_by(const std::vector<std::vector<double>>& motions);
  const Eigen::VectorXd& lengths() const { return lengths_; }
  // Adds rows to every motion's regressor, for columns that are not divided by lengths: what is known without it, as
  // much of it as the criterion's samples are of all samples.
  void add_known(const Eigen::MatrixXd& rows) { known_ = rows; }
  // Sets the weight of torques beyond their limits; 1 at first.
  void weigh_torques(double weight) { torque_weight_ = weight; }
  // Multiplies each coordinate's torque limit by a factor up to 1, but leaves half of what is not needed at rest.
  void lower_torques(const std::vector<double>& factors);

  // The number of free coefficients: a_1, b_1, a_2, … of every coordinate, in units that reach a limit at about 1.
  int size() const { return equations_.coordinates() * terms(); }
  // The number of samples of the criterion.
  int samples() const { return static_cast<int>(basis_[0].rows()); }

  // excitation_cost() plus a penalty for torques beyond their limits. `gradient`: size() numbers or null.
  double operator()(const double* x, double* gradient) const;
  // excitation_cost() of this motion, without the penalty.
  double cost(const FourierTrajectory& trajectory) const;

  // The series of these coefficients. A coordinate that would exceed its limits of position, speed and acceleration is
  // scaled down, smoothly, to about the limit.
  FourierTrajectory trajectory(const double* x) const;
  // Coefficients that give about this motion, which must keep the limits.
  std::vector<double> coefficients(const FourierTrajectory& trajectory) const;

 private:
  struct Motion;
  int terms() const { return static_cast<int>(basis_[0].cols()); }
  double time(int sample) const { return duration_ * (sample + 0.5) / samples(); }
  Eigen::VectorXd torques_at_rest() const;
  Motion motion(const double* x) const;
  Eigen::VectorXd state(const Motion& motion, int derivative, int sample) const;
  Eigen::MatrixXd regressor(const Motion& motion) const;
  Eigen::MatrixXd with_known(const Eigen::MatrixXd& regressor) const;
  // slope, by_torque: null, or what the penalty adds to its slope by the regressor, and that by each torque.
  double torque_penalty(const Motion& motion, const Eigen::MatrixXd& regressor, Eigen::MatrixXd* slope,
                        Eigen::VectorXd* by_torque) const;
  void add_springs_to(Eigen::VectorXd& tau, const Motion& motion, int k) const;
  // Adds what the penalty changes by q through the springs.
  void add_springs(const Eigen::VectorXd& by_torque, Eigen::MatrixXd& by_position) const;
  void by_motion(const Motion& motion, const Eigen::MatrixXd& regressor, const Eigen::MatrixXd& slope,
                 Eigen::MatrixXd* by) const;
  void by_coefficients(const Motion& motion, const Eigen::MatrixXd* by, double* gradient) const;

  const MotionEquations& equations_;
  std::vector<JointLimits> limits_;
  std::vector<double> rest_;
  std::vector<double> least_torques_;  // limits are not lowered below these
  double duration_;
  Eigen::MatrixXd units_;     // terms × coordinates: a coefficient of 1 is this amplitude of speed
  Eigen::MatrixXd basis_[3];  // samples × terms: q, q̇ and q̈ of each term
  Eigen::VectorXd lengths_;
  Eigen::MatrixXd known_;  // rows below every regressor
  double torque_weight_ = 1;
};

}  // namespace flatdyn

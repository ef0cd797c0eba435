// SPDX-License-Identifier: GPL-2.0-or-later
// The information of measured motion on the base parameters: for every joint, the triangular factor of its rows of Ȳ
// π_b = τ̄, (7.84). Logs of any length and number, or parts of them, become one such object.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identify/motion_stream.hpp"
#include "identify/torque_model.hpp"
#include "identify/triangular_factor.hpp"

namespace flatdyn {

// |Y_i π_b - τ_i|² summed over the samples is |R (π_b restricted to `columns`, -1)|².
struct JointObservations {
  std::vector<int> columns;  // columns of Y_b that row i has, ascending
  Eigen::MatrixXd R;         // (columns + 1)², upper triangular
  long rows = 0;             // samples folded
  double correlation = 1;    // correlation of the noise, SampleFilter::correlation()

  Eigen::MatrixXd A() const { return R.leftCols(R.cols() - 1); }
  Eigen::VectorXd b() const { return R.col(R.cols() - 1); }
  // The entries of π_b that joint i depends on.
  Eigen::VectorXd restricted(const Eigen::VectorXd& pi_b) const { return pi_b(columns); }
  // The root mean square of Y_i π_b - τ_i over the samples, N m or N.
  double rms_residual(const Eigen::VectorXd& pi_b) const;
  double rms_torque() const;
};

struct Observations {
  int parameters = 0;  // b
  std::vector<JointObservations> joints;

  void set_correlation(double correlation);  // sets it for all joints
};

// Folds motion as it arrives, in 2 (columns)² operations per row.
class ObservationFolder {
 public:
  explicit ObservationFolder(const TorqueModel& model);

  void add(const MeasuredMotion& motion);
  Observations observations();

 private:
  const TorqueModel& model_;
  std::vector<TriangularFactor> factors_;
  std::vector<double> y_, tip_;
};

// Joins observations of the same model.
Observations joined(const Observations& a, const Observations& b);

}  // namespace flatdyn

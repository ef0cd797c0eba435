// SPDX-License-Identifier: GPL-2.0-or-later
// What measured motion says about the base parameters: for every joint the triangular factor of its rows of
// Ȳ π_b = τ̄, (7.84). Logs of any length and number, or of parts of them, become one such object.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "identify/motion_stream.hpp"
#include "identify/torque_model.hpp"
#include "identify/triangular_factor.hpp"

namespace flatdyn {

// |Y_i π_b - τ_i|² summed over the samples is |R (π_b restricted to `columns`, -1)|².
struct JointObservations {
  std::vector<int> columns;  // of Y_b that row i has, ascending
  Eigen::MatrixXd R;         // (columns + 1)², upper triangular
  long rows = 0;             // samples folded
  double correlation = 1;    // of the noise in them: SampleFilter::correlation()

  Eigen::MatrixXd A() const { return R.leftCols(R.cols() - 1); }
  Eigen::VectorXd b() const { return R.col(R.cols() - 1); }
  // Of all π_b those that joint i has.
  Eigen::VectorXd restricted(const Eigen::VectorXd& pi_b) const { return pi_b(columns); }
  // Y_i π_b - τ_i, root mean square over the samples, N m or N.
  double rms_residual(const Eigen::VectorXd& pi_b) const;
  double rms_torque() const;
};

struct Observations {
  int parameters = 0;  // b
  std::vector<JointObservations> joints;

  void set_correlation(double correlation);  // of all joints
};

// Folds motion as it comes: 2 (columns)² operations a row.
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

// Both together. They must come from the same model.
Observations joined(const Observations& a, const Observations& b);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/noise_scores.hpp"

#include <cmath>

namespace flatdyn {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// The sums over rows of an equation times their weight and all that noise of their torque is correlated with.
MatrixXd covariance_of_torques(const NoiseStructure& structure, const MatrixXd& rows, Index equation,
                               const ResidualNoise& noise) {
  MatrixXd correlated = MatrixXd::Zero(rows.rows(), rows.cols());
  for (std::size_t k = 0; k < structure.kinds().size(); ++k) {
    const double variance = noise.torques(equation, static_cast<Index>(k));
    if (variance > 0) correlated += variance * structure.correlated(rows, equation, structure.kinds()[k]);
  }
  return rows.transpose() * correlated;
}

std::vector<VectorXd> acceleration_correlations(const std::vector<NoiseShape>& shapes, Index joint) {
  std::vector<VectorXd> result;
  for (const NoiseShape& shape : shapes) result.push_back(shape.acceleration[static_cast<std::size_t>(joint)]);
  return result;
}

}  // namespace

MatrixXd score_covariance(const NoiseStructure& structure, const VectorXd& values, const VectorXd& weights,
                          const ResidualNoise& noise, const AccelerationRows& acceleration_rows) {
  const Observations& observations = structure.observations();
  const VectorXd& ratios = structure.row_ratios();
  const std::vector<MatrixXd> B = inertias(observations, values, acceleration_rows);
  const Index joints = noise.acceleration.size(), size = observations.parameters;
  const auto instants = static_cast<Index>(observations.instants.size());
  MatrixXd result = MatrixXd::Zero(size, size);
  std::vector<MatrixXd> of_joints(static_cast<std::size_t>(joints), MatrixXd::Zero(instants, size));
  for (Index i = 0; i < weights.size(); ++i) {
    const JointObservations& joint = observations.joints[static_cast<std::size_t>(i)];
    const MatrixXd rows = structure.rows_of(i);
    result(joint.columns, joint.columns) +=
        ratios[i] * weights[i] * weights[i] * covariance_of_torques(structure, rows, i, noise);
    for (Index t = 0; t < rows.rows() && joints > 0; ++t) {
      const EquationInstant& instant = observations.instants[static_cast<std::size_t>(t)];
      const Index place = i - instant.first;
      if (place < 0 || place >= B[static_cast<std::size_t>(t)].rows()) continue;
      for (Index j = 0; j < joints; ++j) {
        const double gain = std::sqrt(ratios[i]) * weights[i] * B[static_cast<std::size_t>(t)](place, j);
        of_joints[static_cast<std::size_t>(j)](t, joint.columns) += gain * rows.row(t);
      }
    }
  }
  for (Index j = 0; j < joints; ++j) {
    const MatrixXd& rows = of_joints[static_cast<std::size_t>(j)];
    result += noise.acceleration[j] * rows.transpose() *
              structure.correlated(rows, acceleration_correlations(observations.shapes, j));
  }
  return result;
}

std::vector<MatrixXd> false_information(const NoiseStructure& structure, const VectorXd& weights,
                                        const AccelerationRows& rows) {
  const Observations& observations = structure.observations();
  std::vector<MatrixXd> result;
  if (!rows) return result;
  const VectorXd& ratios = structure.row_ratios();
  for (const EquationInstant& instant : observations.instants) {
    const NoiseShape& shape = observations.shapes[static_cast<std::size_t>(instant.log)];
    const std::vector<MatrixXd> of_joints = rows(instant);
    const Index all = of_joints.empty() ? 0 : of_joints.front().cols();
    result.resize(of_joints.size(), MatrixXd::Zero(all, all));
    for (std::size_t i = 0; i < instant.used.size(); ++i) {
      const auto row = static_cast<Index>(i), equation = instant.first + row;
      if (instant.used[i] == 0) continue;
      std::vector<int> columns = observations.joints[static_cast<std::size_t>(equation)].columns;
      if (all > observations.parameters) columns.push_back(observations.parameters);
      const double weight = weights[equation] * ratios[equation];
      for (std::size_t j = 0; j < of_joints.size(); ++j) {
        const VectorXd gains = of_joints[j](row, columns);
        result[j](columns, columns) += shape.acceleration[j][0] * weight * gains * gains.transpose();
      }
    }
  }
  return result;
}

}  // namespace flatdyn

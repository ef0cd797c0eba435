// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/huber.hpp"

#include <algorithm>
#include <cmath>

#include "laboratory/identify/residual_noise.hpp"

namespace flatdyn {
namespace {

// The standard deviation of each equation's residuals, from their median.
Eigen::VectorXd robust_deviations(const Eigen::MatrixXd& left) {
  constexpr double kNormal = 1.4826;  // standard deviation of a normal number whose magnitude has median 1
  Eigen::VectorXd deviations = Eigen::VectorXd::Zero(left.cols());
  for (Eigen::Index i = 0; i < left.cols(); ++i) {
    std::vector<double> sizes;
    for (const double residual : left.col(i)) {
      if (!std::isnan(residual)) sizes.push_back(std::abs(residual));
    }
    if (!sizes.empty()) deviations[i] = kNormal * median(std::move(sizes));
  }
  return deviations;
}

}  // namespace

RowWeight huber_weights(const EquationModel& equations, const Measurement& measurement, const Eigen::VectorXd& values) {
  constexpr double kFull = 1.345;
  // Instants have the weights of the fit before, which changes their residuals' sizes but not their signs: the median
  // is among those that count in full.
  const Eigen::VectorXd deviations = robust_deviations(residuals(measurement.observations, values));
  return [&equations, values, deviations](const FilteredEquations& each, int equation) {
    const std::vector<int>& columns = equations.columns()[static_cast<std::size_t>(equation)];
    const double* entries = each.entries;
    for (int i = 0; i < equation; ++i) entries += equations.columns()[static_cast<std::size_t>(i)].size();
    double residual = each.right[equation];
    for (std::size_t k = 0; k < columns.size(); ++k) residual -= entries[k] * values[columns[k]];
    const double full = kFull * deviations[equation], size = std::abs(residual);
    return size > full ? full / size : 1.0;
  };
}

}  // namespace flatdyn

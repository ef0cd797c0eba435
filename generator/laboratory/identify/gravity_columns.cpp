// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/gravity_columns.hpp"

#include "truth/reference/regressor_by_columns.hpp"

namespace flatdyn {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd whole_parameters(const TorqueModel& model, const LoadedRobot& robot, const VectorXd& pi_b) {
  const std::vector<Number> of_file = dynamic_parameters(robot.mechanism);
  VectorXd pi(static_cast<Index>(of_file.size()));
  for (std::size_t k = 0; k < of_file.size(); ++k) pi[static_cast<Index>(k)] = nearest_double(of_file[k]);
  for (int k = 0; k < model.parameters(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    pi[model.base().columns[at]] += pi_b[k] - model.file_values()[at];
  }
  return pi;
}

// Only masses and first moments have a weight.
GravityColumns::GravityColumns(const TorqueModel& model, const LoadedRobot& robot, const VectorXd& pi,
                               Eigen::Matrix3Xd slopes)
    : slopes_(std::move(slopes)), joints_(model.equations()), units_(static_cast<std::size_t>(slopes_.cols())) {
  const RegressorReference<double> reference(model.mechanism(), reference_robot<double>(robot.robot, {}), {},
                                             RegressorColumns::all);
  for (std::size_t k = 0; k < reference.units().size(); ++k) {
    const int index = reference.indices()[k];
    const double value = pi[index];
    if (parameter_of(index) > Parameter::mlz || value == 0) continue;
    values_.push_back(value);
    for (std::size_t s = 0; s < units_.size(); ++s) {
      units_[s].push_back(reference.units()[k]);
      units_[s].back().gravity = slopes_.col(static_cast<Index>(s));
    }
  }
}

MatrixXd GravityColumns::at(const VectorXd& q) const {
  const VectorXd rest = VectorXd::Zero(joints_);
  MatrixXd columns = MatrixXd::Zero(joints_, size());
  for (std::size_t s = 0; s < units_.size(); ++s) {
    for (std::size_t k = 0; k < values_.size(); ++k) {
      columns.col(static_cast<Index>(s)) +=
          values_[k] * reference::inverse_dynamics<double>(units_[s][k], q, rest, rest);
    }
  }
  return columns;
}

}  // namespace flatdyn

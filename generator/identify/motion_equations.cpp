// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/motion_equations.hpp"

#include <Eigen/QR>
#include <set>

#include "identify/base_coordinates.hpp"
#include "identify/base_motion.hpp"

namespace flatdyn {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MotionEquations::MotionEquations(const TorqueModel& model, bool has_base_force)
    : model_(model),
      first_equation_(has_base_force ? 0 : model.first_joint()),
      gravity_(base_sensors(model.mechanism(), "").gravity),
      all_(model.equations(), model.parameters()) {
  std::set<int> columns;
  for (int i = first_equation_; i < model.equations(); ++i) {
    columns.insert(model.columns_of(i).begin(), model.columns_of(i).end());
  }
  columns_.assign(columns.begin(), columns.end());
  const Eigen::Map<const VectorXd> values(model.file_values().data(), model.parameters());
  file_values_ = values(columns_);
}

void MotionEquations::evaluate(const double* q, const double* qd, const double* qdd) const {
  const int base = model_.first_joint();
  if (base == 0) return model_.regressor(q, qd, qdd, all_.data());
  const BaseState state = base_state(q, qd, qdd);
  VectorXd rates = Eigen::Map<const VectorXd>(qd, coordinates());
  VectorXd accelerations = Eigen::Map<const VectorXd>(qdd, coordinates());
  rates.head(base) << Eigen::Vector3d::Zero(), state.twist.tail<3>();
  accelerations.head(base) << state.specific_force(gravity_), state.twist_rates.tail<3>();
  model_.regressor(q + base, rates.data(), accelerations.data(), all_.data());
}

MotionEquations::RowByRow MotionEquations::regressor(const double* q, const double* qd, const double* qdd) const {
  evaluate(q, qd, qdd);
  return all_(Eigen::lastN(equations()), columns_);
}

VectorXd MotionEquations::torques(const double* q, const double* qd, const double* qdd) const {
  evaluate(q, qd, qdd);
  VectorXd torques = all_ * Eigen::Map<const VectorXd>(model_.file_values().data(), model_.parameters());
  model_.add_springs(q + model_.first_joint(), torques.data());
  return torques;
}

// The other columns come first: what is left of the triangular factor behind them is free of them.
MatrixXd MotionEquations::information_on_columns(const MatrixXd& root) const {
  const Index others = root.cols() - parameters();
  if (root.size() == 0 || others == 0) return root;
  std::vector<int> order;
  for (int k = 0; k < root.cols(); ++k) {
    if (std::find(columns_.begin(), columns_.end(), k) == columns_.end()) order.push_back(k);
  }
  order.insert(order.end(), columns_.begin(), columns_.end());
  MatrixXd ordered = MatrixXd::Zero(std::max(root.rows(), root.cols()), root.cols());
  ordered.topRows(root.rows()) = root(Eigen::all, order);
  const MatrixXd R = Eigen::HouseholderQR<MatrixXd>(ordered).matrixQR().triangularView<Eigen::Upper>();
  return R.block(others, others, parameters(), parameters());
}

}  // namespace flatdyn

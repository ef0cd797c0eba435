// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/motion_equations.hpp"

#include <Eigen/QR>
#include <set>

#include "laboratory/identify/base_motion.hpp"

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

PlannedState MotionEquations::state(const double* q, const double* qd, const double* qdd) const {
  const Mechanism& mechanism = model_.mechanism();
  PlannedState state{VectorXd(mechanism.position_count()), Eigen::Map<const VectorXd>(qd, coordinates()),
                     Eigen::Map<const VectorXd>(qdd, coordinates())};
  for (int i = model_.first_joint(); i < coordinates(); ++i) state.q[mechanism.position_of(i)] = q[i];
  for (const int first : mechanism.spherical) {
    const TurnState turned = turn_state(q + first, qd + first, qdd + first);
    const Eigen::Quaterniond& turn = turned.turn;
    state.q.segment<4>(mechanism.quaternion_of(first)) << turn.w(), turn.x(), turn.y(), turn.z();
    state.v.segment<3>(first) = turned.velocity;
    state.a.segment<3>(first) = turned.acceleration;
  }
  if (model_.first_joint() == 0) return state;
  state.base = base_state(q, qd, qdd);
  state.v.head<6>() = state.base.twist;
  state.a.head<6>() = state.base.twist_rates;
  return state;
}

VectorXd MotionEquations::evaluate(const double* q, const double* qd, const double* qdd) const {
  if (!model_.mechanism().has_quasi_velocities()) {
    model_.regressor(q, qd, qdd, all_.data());
    return Eigen::Map<const VectorXd>(q, model_.mechanism().position_count());
  }
  PlannedState at = state(q, qd, qdd);
  if (model_.first_joint() > 0) {
    at.v.head<3>().setZero();
    at.a.head<3>() = at.base.specific_force(gravity_);
  }
  model_.regressor(at.q.data(), at.v.data(), at.a.data(), all_.data());
  return at.q;
}

MotionEquations::RowByRow MotionEquations::regressor(const double* q, const double* qd, const double* qdd) const {
  evaluate(q, qd, qdd);
  return all_(Eigen::lastN(equations()), columns_);
}

VectorXd MotionEquations::torques(const double* q, const double* qd, const double* qdd) const {
  const VectorXd positions = evaluate(q, qd, qdd);
  VectorXd torques = all_ * Eigen::Map<const VectorXd>(model_.file_values().data(), model_.parameters());
  model_.add_springs(positions.data(), torques.data());
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

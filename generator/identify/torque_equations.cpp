// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/torque_equations.hpp"

#include <algorithm>

namespace flatdyn {

TorqueEquations::TorqueEquations(const TorqueModel& model, bool offsets)
    : EquationModel(model.parameters() + (offsets ? model.joints() : 0)),
      model_(model),
      offsets_(offsets),
      y_(static_cast<std::size_t>(model.joints() * model.parameters())) {
  const bool is_open = !model.mechanism().has_loops() && !model.mechanism().is_coupled();
  int entry = 0;
  for (int i = 0; i < model.joints(); ++i) {
    columns_.push_back(model.columns_of(i));
    has_friction_.push_back(false);
    for (const int column : columns_.back()) {
      const int index = model.base().columns[static_cast<std::size_t>(column)];
      const Parameter parameter = parameter_of(index);
      const bool is_coulomb = parameter == Parameter::Fs;
      if (is_coulomb || parameter == Parameter::Fv) {
        has_friction_.back() = true;
        const auto law = is_coulomb ? FrictionEntry::Law::coulomb : FrictionEntry::Law::viscous;
        // With loops or coupled joints, an equation also has the friction of joints whose speeds are functions of
        // others.
        if (is_open) friction_.push_back({entry, i, law});
      }
      ++entry;
    }
    if (!offsets) continue;
    columns_.back().push_back(model.parameters() + i);
    ++entry;
  }
}

Eigen::VectorXd TorqueEquations::file_values() const {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(parameters());
  std::copy(model_.file_values().begin(), model_.file_values().end(), values.begin());
  return values;
}

AccelerationRows TorqueEquations::acceleration_rows() const {
  return [this](const EquationInstant& instant) {
    std::vector<Eigen::MatrixXd> rows = model_.acceleration_rows(instant.q.data());
    if (!offsets_) return rows;
    for (Eigen::MatrixXd& each : rows) {
      each.conservativeResize(Eigen::NoChange, parameters());
      each.rightCols(model_.joints()).setZero();
    }
    return rows;
  };
}

void TorqueEquations::evaluate(const MeasuredMotion& motion, double* entries, double* known) const {
  model_.regressor(motion.q, motion.qd, motion.qdd, y_.data());
  const double* row = y_.data();
  for (const std::vector<int>& columns : columns_) {
    for (const int column : columns) *entries++ = column < model_.parameters() ? row[column] : 1;
    row += model_.parameters();
  }
  if (motion.h_e != nullptr) {
    model_.tip_torque(motion.q, motion.h_e, known);
  } else {
    std::fill(known, known + model_.joints(), 0.0);
  }
}

}  // namespace flatdyn

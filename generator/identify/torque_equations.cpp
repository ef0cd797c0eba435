// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/torque_equations.hpp"

#include <algorithm>

namespace flatdyn {

TorqueEquations::TorqueEquations(const TorqueModel& model)
    : EquationModel(model.parameters()),
      model_(model),
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
  }
}

void TorqueEquations::evaluate(const MeasuredMotion& motion, double* entries, double* known) const {
  model_.regressor(motion.q, motion.qd, motion.qdd, y_.data());
  const double* row = y_.data();
  for (const std::vector<int>& columns : columns_) {
    for (const int column : columns) *entries++ = row[column];
    row += model_.parameters();
  }
  if (motion.h_e != nullptr) {
    model_.tip_torque(motion.q, motion.h_e, known);
  } else {
    std::fill(known, known + model_.joints(), 0.0);
  }
}

}  // namespace flatdyn

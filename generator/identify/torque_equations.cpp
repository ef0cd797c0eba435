// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/torque_equations.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "identify/simulated_motion.hpp"

namespace flatdyn {

TorqueEquations::TorqueEquations(const TorqueModel& model, FurtherParameters further)
    : model_(model), further_(std::move(further)), y_(static_cast<std::size_t>(model.joints() * model.parameters())) {
  for (const int index : model.base().columns) names_.push_back(parameter_name(index));
  for (int i = 0; i < model.joints(); ++i) add_joint(i);
  // Offsets are behind all others, in columns and in each equation.
  if (further_.offsets) {
    std::vector<FrictionEntry> shifted;
    int before = 0;
    for (int i = 0; i < model.joints(); ++i) {
      for (FrictionEntry each : friction_) {
        if (each.joint == i) shifted.push_back({each.entry + before, i, each.law, each.speed});
      }
      columns_[static_cast<std::size_t>(i)].push_back(static_cast<int>(names_.size()));
      names_.push_back(fmt::format("offset{}", i + 1));
      ++before;
    }
    friction_ = std::move(shifted);
  }
  parameters_ = static_cast<int>(names_.size());
}

void TorqueEquations::add_joint(int joint) {
  // With loops or coupled joints, an equation also has the friction of joints whose speeds are functions of others.
  const bool is_open = !model_.mechanism().has_loops() && !model_.mechanism().is_coupled();
  columns_.push_back(model_.columns_of(joint));
  has_friction_.push_back(false);
  const double speed = further_.speeds.empty() ? 1 : further_.speeds[static_cast<std::size_t>(joint)];
  bool has_coulomb = false;
  for (const int column : model_.columns_of(joint)) {
    const Parameter parameter = parameter_of(model_.base().columns[static_cast<std::size_t>(column)]);
    const bool is_coulomb = parameter == Parameter::Fs;
    if (is_coulomb || parameter == Parameter::Fv) {
      has_friction_.back() = true;
      has_coulomb = has_coulomb || is_coulomb;
      FrictionEntry::Law law = is_coulomb ? FrictionEntry::Law::coulomb : FrictionEntry::Law::viscous;
      if (is_coulomb && further_.law == FrictionLaw::smooth && further_.dictionary.empty()) {
        law = FrictionEntry::Law::smooth;
      }
      if (is_open) friction_.push_back({entry_, joint, law, speed});
    }
    ++entry_;
  }
  if (!has_coulomb || !is_open) return;
  const std::string number = std::to_string(joint + 1);
  const auto law = further_.law == FrictionLaw::smooth ? FrictionEntry::Law::smooth : FrictionEntry::Law::stribeck;
  if (!further_.dictionary.empty()) {
    for (const double each : further_.dictionary[static_cast<std::size_t>(joint)]) {
      add_further(joint, law, each, fmt::format("F{}({})", number, each));
    }
  } else if (further_.law == FrictionLaw::asymmetric) {
    add_further(joint, FrictionEntry::Law::asymmetry, 1, "Fa" + number);
  } else if (further_.law == FrictionLaw::stribeck) {
    add_further(joint, law, speed, "Fb" + number);
  }
}

void TorqueEquations::add_further(int joint, FrictionEntry::Law law, double speed, const std::string& name) {
  friction_.push_back({entry_++, joint, law, speed});
  columns_.back().push_back(static_cast<int>(names_.size()));
  names_.push_back(name);
}

Eigen::VectorXd TorqueEquations::file_values() const {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(parameters());
  std::copy(model_.file_values().begin(), model_.file_values().end(), values.begin());
  return values;
}

AccelerationRows TorqueEquations::acceleration_rows() const {
  return [this](const EquationInstant& instant) {
    std::vector<Eigen::MatrixXd> rows = model_.acceleration_rows(instant.q.data());
    const int more = parameters() - model_.parameters();
    if (more == 0) return rows;
    for (Eigen::MatrixXd& each : rows) {
      each.conservativeResize(Eigen::NoChange, parameters());
      each.rightCols(more).setZero();
    }
    return rows;
  };
}

std::unique_ptr<Instrument> TorqueEquations::instrument() const {
  if (instrument_values_.size() == 0) return nullptr;
  return std::make_unique<SimulatedMotion>(*this, instrument_values_);
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

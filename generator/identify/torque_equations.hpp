// SPDX-License-Identifier: GPL-2.0-or-later
// Y_b(q, q̇, q̈) π_b + J_eᵀ h_e = τ, (7.81), with one equation per joint.
#pragma once

#include "identify/equation_model.hpp"
#include "identify/torque_model.hpp"

namespace flatdyn {

class TorqueEquations : public EquationModel {
 public:
  explicit TorqueEquations(const TorqueModel& model);

  void evaluate(const MeasuredMotion& motion, double* entries, double* known) const override;
  int measured(const LogLayout& layout) const override { return layout.tau(); }

 private:
  const TorqueModel& model_;
  mutable std::vector<double> y_;
};

}  // namespace flatdyn

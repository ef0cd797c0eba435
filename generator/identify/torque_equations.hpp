// SPDX-License-Identifier: GPL-2.0-or-later
// Y_b(q, q̇, q̈) π_b + J_eᵀ h_e = τ, (7.81), with one equation per joint; on request, a constant offset of each joint's
// torques is one more parameter: behind π_b, in the order of the joints.
#pragma once

#include "identify/equation_model.hpp"
#include "identify/residual_noise.hpp"
#include "identify/torque_model.hpp"

namespace flatdyn {

class TorqueEquations : public EquationModel {
 public:
  explicit TorqueEquations(const TorqueModel& model, bool offsets = false);

  const TorqueModel& model() const { return model_; }
  bool has_offsets() const { return offsets_; }
  // The file's π_b, and offsets of 0.
  Eigen::VectorXd file_values() const;
  AccelerationRows acceleration_rows() const;

  void evaluate(const MeasuredMotion& motion, double* entries, double* known) const override;
  int measured(const LogLayout& layout) const override { return layout.tau(); }

 private:
  const TorqueModel& model_;
  bool offsets_;
  mutable std::vector<double> y_;
};

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The equations of the joint torques in π_b, and in parameters that come behind it.
#pragma once

#include <string>
#include <vector>

#include "identify/equation_model.hpp"
#include "identify/friction_law.hpp"
#include "identify/residual_noise.hpp"
#include "identify/torque_model.hpp"

namespace flatdyn {

// Parameters beside π_b, which come behind it.
struct FurtherParameters {
  FrictionLaw law = FrictionLaw::coulomb;
  std::vector<double> speeds{};  // v by joint, rad/s or m/s, for laws that have it
  bool offsets = false;          // a constant in each joint's torques
  // By joint: columns exp(-(q̇/v)²) sgn q̇, or tanh(q̇/v), for many v, instead of the law; to find v by.
  std::vector<std::vector<double>> dictionary{};
};

// Y_b(q, q̇, q̈) π_b + J_eᵀ h_e = τ, (7.81), with one equation per joint. Behind π_b come the law's further parameter of
// each joint that has friction (F_a or F_b), or the dictionary's, and then the offsets.
class TorqueEquations : public EquationModel {
 public:
  explicit TorqueEquations(const TorqueModel& model, FurtherParameters further = {});

  const TorqueModel& model() const { return model_; }
  const FurtherParameters& further() const { return further_; }
  // The names of all parameters: "I1zz", …, "Fa1", …, "offset1", …
  const std::vector<std::string>& names() const { return names_; }
  // The file's π_b, and zeros behind it.
  Eigen::VectorXd file_values() const;
  AccelerationRows acceleration_rows() const;

  // Gives the equations the simulated motion of a model with these parameters as instrument.
  void set_instrument(Eigen::VectorXd values) { instrument_values_ = std::move(values); }
  std::unique_ptr<Instrument> instrument() const override;

  void evaluate(const MeasuredMotion& motion, double* entries, double* known) const override;
  int measured(const LogLayout& layout) const override { return layout.tau(); }

 private:
  void add_joint(int joint);
  void add_further(int joint, FrictionEntry::Law law, double speed, const std::string& name);

  const TorqueModel& model_;
  FurtherParameters further_;
  std::vector<std::string> names_;
  Eigen::VectorXd instrument_values_;  // empty: no instrument
  int entry_ = 0;                      // entries so far
  mutable std::vector<double> y_;
};

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// From the measurement of a robot's motion to its parameters, and to a verdict on both.
#pragma once

#include <optional>

#include "laboratory/identify/fit_hypotheses.hpp"
#include "laboratory/identify/nonlinear_search.hpp"
#include "laboratory/identify/physical_parameters.hpp"
#include "laboratory/identify/residual_lines.hpp"
#include "laboratory/identify/torque_equations.hpp"

namespace flatdyn {

struct IdentificationOptions {
  EstimateOptions estimate;
  ParameterSet set = ParameterSet::given;
  bool sequential = false;                   // also the textbook's joint-by-joint procedure
  std::optional<Estimate> other_estimate{};  // instead of least squares
};

// The results of one run.
// Ripple of an equation's torques.
struct FastRipple {
  int equation = 0;
  ResidualLine line{};
};

struct Identification {
  Measurement measurement;
  Estimate estimate;  // π_b, and then the offsets of the torques, where they are estimated
  std::optional<Eigen::VectorXd> joint_by_joint;
  PhysicalParameters physical;
  std::vector<JointFit> fits;                // by joint
  std::optional<FitHypothesis> hypothesis;   // a reason for a model that does not fit
  std::optional<Measurement> validation{};   // of other logs, which had no part in the estimate
  std::vector<JointFit> validation_fits{};   // by joint
  NonlinearUnknowns unknowns{};              // those that were searched
  std::vector<FastRipple> fast_ripples{};    // that the filter takes away
  std::vector<std::string> warning_texts{};  // sentences on results that are hardly right
  int corrections = 0;                       // the last values of the estimate: they have become small, and stay

  // The equations that the parameters come from, and whether they are so few that residuals tell nothing: a fit with
  // little more equations than parameters leaves none of its noise.
  long equations() const;
  bool is_starved() const {
    return static_cast<double>(equations()) < kEnough * static_cast<double>(estimate.values.size());
  }
  static constexpr double kEnough = 5;  // equations per parameter

  // The physical parameters' π_b, and behind it the further parameters that fit the log best with these links.
  Eigen::VectorXd physical_values() const;
};

// Estimates the parameters of the equations.
Estimate estimate_of(const TorqueEquations& equations, const Measurement& measurement, EstimateOptions options);

Identification identification(const LoadedRobot& robot, const TorqueEquations& equations, Measurement measurement,
                              const IdentificationOptions& options, Progress& progress);

// The first equation that is reported: those of a floating base's force have no rows where no log has that force.
int first_equation(const TorqueModel& model, const Observations& observations);

// Judges the parameters by other logs.
void validate(Identification& found, const TorqueEquations& equations, Measurement validation);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/identification.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace flatdyn {
namespace {

// The estimate of π_b alone, whatever the offsets are.
Estimate without_offsets(const Estimate& estimate, int parameters) {
  if (estimate.values.size() == parameters) return estimate;
  Estimate result = estimate;
  result.values = estimate.values.head(parameters);
  result.standard_deviations = estimate.standard_deviations.head(parameters);
  result.root_information = root_information_of_first(estimate, parameters);
  return result;
}

// The same rows without the columns of the last parameters, which count as 0.
Observations with_first(const Observations& observations, int parameters) {
  Observations result = observations;
  result.parameters = parameters;
  for (JointObservations& joint : result.joints) {
    const auto kept = std::lower_bound(joint.columns.begin(), joint.columns.end(), parameters) - joint.columns.begin();
    const Eigen::VectorXd b = joint.b();
    joint.columns.resize(static_cast<std::size_t>(kept));
    joint.R.conservativeResize(Eigen::NoChange, kept + 1);
    joint.R.col(kept) = b;
  }
  return result;
}

}  // namespace

Estimate estimate_of(const TorqueEquations& equations, const Measurement& measurement, EstimateOptions options) {
  options.acceleration_rows = equations.acceleration_rows();
  return estimate(measurement.observations, equations.file_values(), options);
}

long Identification::equations() const {
  long count = 0;
  for (const JointObservations& joint : measurement.observations.joints) count += joint.rows;
  return count;
}

// Where an offset and a mass cannot be told apart, links may have another mass: the offset then is another one, too.
// Corrections stay: they hold for small steps alone, and nothing that is written has them.
Eigen::VectorXd Identification::physical_values() const {
  Eigen::VectorXd values = estimate.values;
  const Eigen::Index parameters = physical.pi_b.size(), further = values.size() - parameters - corrections;
  const Eigen::VectorXd change = physical.pi_b - values.head(parameters);
  values.head(parameters) = physical.pi_b;
  const Eigen::MatrixXd& root = estimate.root_information;
  if (further == 0 || root.rows() == 0 || root.cols() != values.size()) return values;
  values.segment(parameters, further) -=
      root.middleCols(parameters, further).completeOrthogonalDecomposition().solve(root.leftCols(parameters) * change);
  return values;
}

namespace {

std::vector<FastRipple> fast_ripples_of(const TorqueModel& model, const Measurement& measurement) {
  std::vector<double> bands, sampled;
  for (const MeasuredLog& log : measurement.logs) {
    bands.push_back(log.filter.band);
    sampled.push_back(1 / log.filter.dt);
  }
  std::vector<FastRipple> found;
  for (int i = model.first_joint(); i < model.equations(); ++i) {
    const Body& body = model.mechanism().joint(i);
    if (body.spherical != 0) continue;
    const int position = model.mechanism().position_of(i);
    const auto line = fast_ripple(measurement.observations, i, position, body.prismatic, bands, sampled);
    if (line) found.push_back({i, *line});
  }
  return found;
}

}  // namespace

Identification identification(const LoadedRobot& robot, const TorqueEquations& equations, Measurement measurement,
                              const IdentificationOptions& options, Progress& progress) {
  const TorqueModel& model = equations.model();
  Identification found;
  found.measurement = std::move(measurement);
  found.corrections = equations.corrections();
  progress.step("estimating");
  found.estimate =
      options.other_estimate ? *options.other_estimate : estimate_of(equations, found.measurement, options.estimate);
  if (options.sequential) {
    // The tip's own row shows too little of what is common to all joints.
    const int parameters = equations.parameters() - equations.corrections();
    found.joint_by_joint = estimate_joint_by_joint(with_first(found.measurement.observations, parameters),
                                                   equations.file_values().head(parameters), model.first_of_joint());
  }
  progress.step("finding links that a body can have");
  // Friction and rotors that the estimate leaves out are left out of the robot that it is applied to, too.
  const bool inertial_only = options.set == ParameterSet::inertial;
  found.physical = physical_parameters(inertial_only ? model.mechanism() : robot.mechanism, model.base(),
                                       without_offsets(found.estimate, model.parameters()));
  found.fits = fit_quality(found.measurement.observations, found.measurement.logs, found.estimate.values,
                           equations.acceleration_rows());
  found.fast_ripples = fast_ripples_of(model, found.measurement);
  // Readings that were lost are a reason, and would be taken for others.
  if (found.measurement.count.lost > 0 || found.is_starved()) return found;
  progress.step("looking for a reason why the model may not fit");
  found.hypothesis = best_hypothesis(model, robot, found.measurement, found.fits, equations.further().law);
  return found;
}

int first_equation(const TorqueModel& model, const Observations& observations) {
  const auto first = observations.joints.begin(), end = first + model.first_joint();
  const bool has_base_force = std::any_of(first, end, [](const JointObservations& each) { return each.rows > 0; });
  return has_base_force ? 0 : model.first_joint();
}

void validate(Identification& found, const TorqueEquations& equations, Measurement validation) {
  found.validation_fits =
      fit_quality(validation.observations, validation.logs, found.estimate.values, equations.acceleration_rows());
  found.validation = std::move(validation);
}

}  // namespace flatdyn

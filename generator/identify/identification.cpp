// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/identification.hpp"

#include <algorithm>

#include "identify/gravity_search.hpp"
#include "identify/row_sample.hpp"

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

RowSample row_sample(const TorqueEquations& equations, const Measurement& measurement) {
  const Estimate found = estimate_of(equations, measurement, {});
  return {equations.model(), measurement,
          fit_quality(measurement.observations, measurement.logs, found.values, equations.acceleration_rows())};
}

}  // namespace

Estimate estimate_of(const TorqueEquations& equations, const Measurement& measurement, EstimateOptions options) {
  options.acceleration_rows = equations.acceleration_rows();
  return estimate(measurement.observations, equations.file_values(), options);
}

Eigen::VectorXd Identification::physical_values() const {
  Eigen::VectorXd values = estimate.values;
  values.head(physical.pi_b.size()) = physical.pi_b;
  return values;
}

Identification identification(const LoadedRobot& robot, const TorqueEquations& equations, Measurement measurement,
                              const IdentificationOptions& options, Progress& progress) {
  const TorqueModel& model = equations.model();
  Identification found;
  found.measurement = std::move(measurement);
  progress.step("estimating");
  found.estimate =
      options.other_estimate ? *options.other_estimate : estimate_of(equations, found.measurement, options.estimate);
  if (options.sequential) {
    found.joint_by_joint = estimate_joint_by_joint(found.measurement.observations, equations.file_values());
  }
  progress.step("finding links that a body can have");
  // Friction and rotors that the estimate leaves out are left out of the robot that it is applied to, too.
  const bool inertial_only = options.set == ParameterSet::inertial;
  found.physical = physical_parameters(inertial_only ? model.mechanism() : robot.mechanism, model.base(),
                                       without_offsets(found.estimate, model.parameters()));
  found.fits = fit_quality(found.measurement.observations, found.measurement.logs, found.estimate.values,
                           equations.acceleration_rows());
  const auto is_suspicious = [](const JointFit& fit) { return fit.is_suspicious(); };
  if (std::any_of(found.fits.begin(), found.fits.end(), is_suspicious)) {
    progress.step("looking for a reason why the model does not fit");
    found.hypothesis = best_hypothesis(model, robot, found.measurement, found.fits);
  }
  return found;
}

void validate(Identification& found, const TorqueEquations& equations, Measurement validation) {
  found.validation_fits =
      fit_quality(validation.observations, validation.logs, found.estimate.values, equations.acceleration_rows());
  found.validation = std::move(validation);
}

double remaining_delay(const TorqueEquations& equations, const Measurement& measurement) {
  double delay = 0;
  row_sample(equations, measurement).cost_with_delay(delay);
  return delay;
}

Eigen::Vector3d best_gravity(const LoadedRobot& robot, const TorqueEquations& equations,
                             const Measurement& measurement) {
  return gravity_direction(equations.model(), robot, row_sample(equations, measurement)).gravity;
}

}  // namespace flatdyn

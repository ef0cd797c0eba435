// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "report/identification_report.hpp"

namespace flatdyn {
namespace {

// Reports joints whose torque the model hardly explains, unless that is noise of a joint that barely moves. Such a
// joint gets little weight, so the others' residuals do not show it.
void warn_of_joints(const TorqueModel& model, const Identification& found, std::vector<std::string>& warning_texts) {
  constexpr double kHalf = 0.5, kNoise = 0.05;  // share of the joint's torque, squared; share of the largest torque
  const std::vector<JointObservations>& joints = found.measurement.observations.joints;
  const auto& bodies = model.mechanism().joints();
  double largest = 0;
  for (const JointObservations& joint : joints) largest = std::max(largest, joint.rms_torque());
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const double torque = joints[i].rms_torque(), residual = joints[i].rms_residual(found.estimate.values);
    if (residual * residual < kHalf * torque * torque || residual < kNoise * largest) continue;
    warning_texts.push_back(fmt::format(
        "joint \"{}\": the model leaves {:.3g} of {:.3g} {} (rms); units, signs or delays of the log, or the robot's "
        "geometry, can hardly be right",
        bodies[i].joint, residual, torque, torque_unit(bodies[i])));
  }
}

// Reports base parameters of implausible size, caused by wrong units or by directions that are hardly determined but
// not damped.
void warn_of_sizes(const TorqueModel& model, const Estimate& estimate, std::vector<std::string>& warning_texts) {
  constexpr double kMuch = 100;
  double largest = 0;
  for (const double value : model.file_values()) largest = std::max(largest, std::abs(value));
  std::vector<std::string> names;
  for (int k = 0; k < model.parameters(); ++k) {
    const bool is_odd = std::abs(estimate.values(k)) > kMuch * largest;
    if (is_odd) names.push_back(parameter_name(model.base().columns[static_cast<std::size_t>(k)]));
  }
  if (names.empty() || largest == 0) return;
  warning_texts.push_back(fmt::format(
      "{}: more than {} times all that the robot file has, which can hardly be right: units of the log or of the file "
      "are wrong, or the motion tells too little (--damping leaves more of it near the file's values)",
      fmt::join(names, ", "), kMuch));
}

void warn_of_links(const TorqueModel& model, const Identification& found, std::vector<std::string>& warning_texts) {
  constexpr double kMuch = 10;                       // standard deviations
  constexpr double kLarger = 1.5, kRounding = 1e-6;  // factor on the residual; share of the torque
  const auto& bodies = model.mechanism().joints();
  const PhysicalParameters& physical = found.physical;
  if (physical.largest_misfit > kMuch) {
    warning_texts.push_back(fmt::format(
        "the nearest links are {:.2g} standard deviations from pi_b, more than noise of the torques explains: noise in "
        "q, which no interval has in it, or motion, torques, units or geometry that cannot be right",
        physical.largest_misfit));
  }
  if (!physical.converged) warning_texts.emplace_back("the search for the nearest links did not converge");
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const JointObservations& joint = found.measurement.observations.joints[i];
    const double residual = joint.rms_residual(found.estimate.values), of_links = joint.rms_residual(physical.pi_b);
    if (of_links < std::max(kLarger * residual, kRounding * joint.rms_torque())) continue;
    warning_texts.push_back(fmt::format("joint \"{}\": the links leave {:.3g} {} (rms), where pi_b leaves {:.3g}",
                                        bodies[i].joint, of_links, torque_unit(bodies[i]), residual));
  }
}

}  // namespace

std::vector<std::string> plausibility_warnings(const TorqueModel& model, const Identification& found) {
  std::vector<std::string> warning_texts;
  warn_of_joints(model, found, warning_texts);
  warn_of_sizes(model, found.estimate, warning_texts);
  warn_of_links(model, found, warning_texts);
  return warning_texts;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/identification_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "diagnostics/table.hpp"
#include "report/numbers.hpp"
#include "symbolic/combination_text.hpp"

namespace flatdyn {
namespace {

// Of a damped direction those parameters that make up nearly all of it, largest first.
std::vector<int> main_parameters(const DampedDirection& direction) {
  constexpr double kShown = 0.2;
  std::vector<int> indices;
  for (Eigen::Index k = 0; k < direction.components.size(); ++k) {
    if (std::abs(direction.components(k)) > kShown) indices.push_back(static_cast<int>(k));
  }
  std::stable_sort(indices.begin(), indices.end(),
                   [&](int a, int b) { return std::abs(direction.components(a)) > std::abs(direction.components(b)); });
  return indices;
}

std::string data_text(const Measurement& measurement) {
  const auto& [layout, dt, jitter, band, half, decimate] = measurement.plan;
  std::string text = fmt::format("{} samples, {} used", measurement.count.lines, measurement.count.used);
  if (band > 0) text += fmt::format("; zero-phase filter, band {:.4g} Hz, every sample of {}", band, decimate);
  if (measurement.count.gaps > 0) text += fmt::format("; {} gaps in time", measurement.count.gaps);
  return text + "\n";
}

std::string torque_table(const TorqueModel& model, const Identification& found) {
  std::vector<std::vector<std::string>> rows = {{"joint", "torque (rms)", "residual (rms)", "explained", "sigma"}};
  for (int i = 0; i < model.joints(); ++i) {
    const JointObservations& joint = found.measurement.observations.joints[static_cast<std::size_t>(i)];
    const double torque = joint.rms_torque(), residual = joint.rms_residual(found.estimate.values);
    const double part = torque > 0 ? residual / torque : 0;
    rows.push_back({model.mechanism().joints()[static_cast<std::size_t>(i)].joint, fmt::format("{:.4g}", torque),
                    fmt::format("{:.3g}", residual), fmt::format("{:.4g} %", 100 * (1 - part * part)),
                    fmt::format("{:.3g}", found.estimate.torque_deviations(i))});
  }
  return aligned_table(rows);
}

std::string parameter_table(const TorqueModel& model, const Identification& found) {
  std::vector<std::vector<std::string>> rows = {{"pi_b", "value", "std dev", "relative", "file", "combination"}};
  if (found.joint_by_joint) rows.front().insert(rows.front().begin() + 4, "joint by joint");
  for (int k = 0; k < model.parameters(); ++k) {
    const double value = found.estimate.values(k), deviation = found.estimate.standard_deviations(k);
    std::vector<std::string> row = {
        parameter_name(model.base().columns[static_cast<std::size_t>(k)]),
        fmt::format("{:.6g}", value),
        deviation_text(deviation),
        value != 0 && std::isfinite(deviation) ? fmt::format("{:.2g} %", 100 * deviation / std::abs(value)) : "",
        fmt::format("{:.6g}", model.file_values()[static_cast<std::size_t>(k)]),
        combination_text(model.base(), k)};
    if (found.joint_by_joint) row.insert(row.begin() + 4, fmt::format("{:.6g}", (*found.joint_by_joint)(k)));
    rows.push_back(std::move(row));
  }
  return aligned_table(rows);
}

std::string damped_text(const TorqueModel& model, const Estimate& estimate) {
  if (estimate.damped.empty()) return "";
  std::string text =
      "\ndirections that this motion does not tell; along them nothing leaves the robot file's values (damped least\n"
      "squares), but their parameters may lie in others, too. Relative singular value and parameters of each:\n";
  for (const DampedDirection& direction : estimate.damped) {
    text += fmt::format("  {:8.1e} ", direction.relative_singular_value);
    for (const int k : main_parameters(direction)) {
      text += " " + parameter_name(model.base().columns[static_cast<std::size_t>(k)]);
    }
    text += "\n";
  }
  return text;
}

// Base parameters beyond all sizes: of wrong units, or of directions that are hardly told, but too well to be damped.
std::string odd_text(const TorqueModel& model, const Estimate& estimate) {
  constexpr double kMuch = 1000;
  const std::vector<double>& file = model.file_values();
  double largest = 0;
  for (const double value : file) largest = std::max(largest, std::abs(value));
  std::vector<std::string> names;
  for (int k = 0; k < model.parameters(); ++k) {
    const bool is_odd = std::abs(estimate.values(k)) > kMuch * largest;
    if (is_odd) names.push_back(parameter_name(model.base().columns[static_cast<std::size_t>(k)]));
  }
  if (names.empty() || largest == 0) return "";
  return fmt::format(
      "\n{}: more than {} times all that the robot file has, which can hardly be right: units of the log or of the\n"
      "file are wrong, or the motion tells too little (--damping leaves more of it near the file's values)\n",
      fmt::join(names, ", "), kMuch);
}

std::string physical_text(const PhysicalParameters& physical) {
  constexpr double kMuch = 10;  // standard deviations
  return fmt::format("\nnearest links that a body can have: {:.2g} standard deviations from pi_b at most{}\n",
                     physical.largest_misfit, physical.converged ? "" : "; the search did not converge") +
         (physical.converged && physical.largest_misfit > kMuch
              ? "that is more than noise explains: motion, torques, units or geometry cannot be right\n"
              : "") +
         fmt::format(
             "divergence from the file's links: {:.2g} (0: the same; a link that is twice as heavy counts 1.2)\n",
             physical.divergence);
}

}  // namespace

std::string describe_identification(const TorqueModel& model, const Identification& found) {
  const Estimate& estimate = found.estimate;
  return data_text(found.measurement) + "\n" + torque_table(model, found) + "\n" + parameter_table(model, found) +
         fmt::format("\ncondition number {:.4g} (columns scaled to unit norm); weights {} after {} iterations\n",
                     estimate.condition(), estimate.converged ? "stable" : "not stable", estimate.iterations) +
         damped_text(model, estimate) + odd_text(model, estimate) + physical_text(found.physical);
}

nlohmann::ordered_json identification_json(const TorqueModel& model, const Identification& found) {
  const Estimate& estimate = found.estimate;
  nlohmann::ordered_json json = {{"samples", found.measurement.count.lines},
                                 {"used", found.measurement.count.used},
                                 {"gaps", found.measurement.count.gaps},
                                 {"filter_band", found.measurement.plan.band},
                                 {"decimation", found.measurement.plan.decimate}};
  for (int i = 0; i < model.joints(); ++i) {
    const JointObservations& joint = found.measurement.observations.joints[static_cast<std::size_t>(i)];
    json["joints"].push_back({{"name", model.mechanism().joints()[static_cast<std::size_t>(i)].joint},
                              {"rms_torque", joint.rms_torque()},
                              {"rms_residual", joint.rms_residual(estimate.values)},
                              {"sigma", estimate.torque_deviations(i)}});
  }
  for (int k = 0; k < model.parameters(); ++k) {
    json["base_parameters"].push_back({{"kept", parameter_name(model.base().columns[static_cast<std::size_t>(k)])},
                                       {"combination", combination_text(model.base(), k, kJsonDigits)},
                                       {"value", estimate.values(k)},
                                       {"standard_deviation", estimate.standard_deviations(k)},
                                       {"file", model.file_values()[static_cast<std::size_t>(k)]}});
    if (found.joint_by_joint) json["base_parameters"].back()["joint_by_joint"] = (*found.joint_by_joint)(k);
  }
  json["singular_values"] = list(estimate.singular_values);
  json["condition_number"] = estimate.condition();
  json["weights"] = {{"stable", estimate.converged}, {"iterations", estimate.iterations}};
  json["physical"] = {{"pi", found.physical.pi},
                      {"largest_misfit", found.physical.largest_misfit},
                      {"divergence", found.physical.divergence},
                      {"converged", found.physical.converged}};
  json["damped"] = nlohmann::ordered_json::array();
  for (const DampedDirection& direction : estimate.damped) {
    json["damped"].push_back(
        {{"relative_singular_value", direction.relative_singular_value}, {"components", list(direction.components)}});
  }
  return json;
}

}  // namespace flatdyn

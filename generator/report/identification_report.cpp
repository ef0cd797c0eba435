// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/identification_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "diagnostics/table.hpp"
#include "report/combination_table.hpp"
#include "report/numbers.hpp"

namespace flatdyn {
namespace {

// The parameters that make up nearly all of a unit direction, largest first.
std::string main_parameters(const TorqueModel& model, const Eigen::VectorXd& components) {
  constexpr double kShown = 0.2;
  std::vector<int> indices;
  for (Eigen::Index k = 0; k < components.size(); ++k) {
    if (std::abs(components(k)) > kShown) indices.push_back(static_cast<int>(k));
  }
  std::stable_sort(indices.begin(), indices.end(),
                   [&](int a, int b) { return std::abs(components(a)) > std::abs(components(b)); });
  std::string names;
  for (const int k : indices) names += " " + parameter_name(model.base().columns[static_cast<std::size_t>(k)]);
  return names;
}

std::string filter_text(const SampleFilter& filter) {
  if (filter.band == 0) return "no filter";
  return fmt::format("zero-phase filter, band {:.4g} Hz, every sample of {}", filter.band, filter.decimate);
}

std::string data_text(const Measurement& measurement) {
  std::string text = fmt::format("{} samples, {} used", measurement.count.lines, measurement.count.used);
  const std::vector<SampleFilter> filters = measurement.filters();
  const bool is_one = filters.size() == 1;
  for (const SampleFilter& filter : filters) {
    if (!is_one || filter.band > 0) text += (is_one ? "; " : "; of some logs ") + filter_text(filter);
  }
  if (measurement.count.interpolated > 0) {
    text += fmt::format("; {} dropped samples interpolated", measurement.count.interpolated);
  }
  if (measurement.count.gaps > 0) text += fmt::format("; {} gaps in time", measurement.count.gaps);
  return text + "\n";
}

std::string torque_table(const TorqueModel& model, const Identification& found) {
  std::vector<std::vector<std::string>> rows = {{"joint", "torque (rms)", "residual (rms)", "explained", "sigma",
                                                 "residual of the links (rms)", "rests below", "used"}};
  const std::vector<double> rest_speeds = found.measurement.rest_speeds();
  for (int i = 0; i < model.joints(); ++i) {
    const JointObservations& joint = found.measurement.observations.joints[static_cast<std::size_t>(i)];
    const double torque = joint.rms_torque(), residual = joint.rms_residual(found.estimate.values);
    const double part = torque > 0 ? residual / torque : 0;
    rows.push_back({model.mechanism().joints()[static_cast<std::size_t>(i)].joint, fmt::format("{:.4g}", torque),
                    fmt::format("{:.3g}", residual), fmt::format("{:.4g} %", 100 * (1 - part * part)),
                    fmt::format("{:.3g}", found.estimate.torque_deviations(i)),
                    fmt::format("{:.3g}", joint.rms_residual(found.physical.pi_b)),
                    fmt::format("{:.2g}", rest_speeds[static_cast<std::size_t>(i)]),
                    fmt::format("{:.3g} %", 100.0 * static_cast<double>(joint.rows) /
                                                static_cast<double>(found.measurement.count.used))});
  }
  return aligned_table(rows);
}

std::string parameter_table(const TorqueModel& model, const Identification& found) {
  std::vector<std::string> heading = {"pi_b", "value", "std dev", "relative", "file"};
  if (found.joint_by_joint) heading.insert(heading.begin() + 4, "joint by joint");
  std::vector<CombinationRow> rows;
  for (int k = 0; k < model.parameters(); ++k) {
    const double value = found.estimate.values(k), deviation = found.estimate.standard_deviations(k);
    std::vector<std::string> cells = {
        parameter_name(model.base().columns[static_cast<std::size_t>(k)]), fmt::format("{:.6g}", value),
        deviation_text(deviation),
        value != 0 && std::isfinite(deviation) ? fmt::format("{:.2g} %", 100 * deviation / std::abs(value)) : "",
        fmt::format("{:.6g}", model.file_values()[static_cast<std::size_t>(k)])};
    if (found.joint_by_joint) cells.insert(cells.begin() + 4, fmt::format("{:.6g}", (*found.joint_by_joint)(k)));
    rows.push_back({k, std::move(cells)});
  }
  const Combinations combinations(model.mechanism(), model.base(), found.frames);
  return combination_table(heading, rows, combinations) + note_on_frames(model.mechanism(), found.frames) +
         note_on_names(model.mechanism(), found.frames);
}

std::string untold_text(const TorqueModel& model, const Estimate& estimate) {
  std::string text;
  if (!estimate.damped.empty()) {
    text +=
        "\ndirections that this motion does not tell; along them nothing leaves the robot file's values (damped least\n"
        "squares), but their parameters may lie in others, too. Relative singular value and parameters of each:\n";
  }
  for (const auto& [singular_value, components] : estimate.damped) {
    text += fmt::format("  {:8.1e} {}\n", singular_value, main_parameters(model, components));
  }
  if (!estimate.hidden.empty()) {
    text +=
        "\ndirections that noise hides: it could make more of them than the robot file has of anything; along them\n"
        "values stay near the file's. Standard deviation without that, and parameters of each:\n";
  }
  for (const auto& [deviation, components] : estimate.hidden) {
    text += fmt::format("  {:8.1e} {}\n", deviation, main_parameters(model, components));
  }
  return text;
}

std::string conditioning_text(const Estimate& estimate) {
  constexpr Eigen::Index kInALine = 10;
  std::string text = fmt::format("\ncondition number {:.4g}; weights {} after {} iterations\n", estimate.condition(),
                                 estimate.converged ? "stable" : "not stable", estimate.iterations);
  text += "singular values (rows weighted, columns scaled to unit norm):";
  for (Eigen::Index k = 0; k < estimate.singular_values.size(); ++k) {
    text += fmt::format("{}{:.3g}", k % kInALine == 0 ? "\n  " : " ", estimate.singular_values(k));
  }
  return text + "\n";
}

std::string physical_text(const PhysicalParameters& physical) {
  return fmt::format(
      "\nnearest links that a body can have: {:.2g} standard deviations from pi_b at most{}\n"
      "divergence from the file's links: {:.2g} (0: the same; a link that is twice as heavy counts 1.2)\n",
      physical.largest_misfit, physical.converged ? "" : "; the search did not converge", physical.divergence);
}

nlohmann::ordered_json base_parameters_json(const TorqueModel& model, const Identification& found) {
  const Combinations canonical(model.mechanism(), model.base(), ParameterFrames::canonical);
  const Combinations in_file(model.mechanism(), model.base(), found.frames);
  nlohmann::ordered_json json;
  for (int k = 0; k < model.parameters(); ++k) {
    json.push_back({{"kept", parameter_name(model.base().columns[static_cast<std::size_t>(k)])},
                    {"combination", canonical.text(k, kJsonDigits)},
                    {"value", found.estimate.values(k)},
                    {"standard_deviation", found.estimate.standard_deviations(k)},
                    {"file", model.file_values()[static_cast<std::size_t>(k)]}});
    if (found.frames == ParameterFrames::file) json.back()["file_combination"] = in_file.text(k, kJsonDigits);
    if (found.joint_by_joint) json.back()["joint_by_joint"] = (*found.joint_by_joint)(k);
  }
  return json;
}

}  // namespace

std::string describe_identification(const TorqueModel& model, const Identification& found) {
  const Estimate& estimate = found.estimate;
  return data_text(found.measurement) + "\n" + torque_table(model, found) + "\n" + parameter_table(model, found) +
         conditioning_text(estimate) + untold_text(model, estimate) + physical_text(found.physical);
}

nlohmann::ordered_json identification_json(const TorqueModel& model, const Identification& found) {
  const Estimate& estimate = found.estimate;
  nlohmann::ordered_json json = {{"samples", found.measurement.count.lines},
                                 {"used", found.measurement.count.used},
                                 {"gaps", found.measurement.count.gaps},
                                 {"interpolated", found.measurement.count.interpolated}};
  for (const MeasuredLog& log : found.measurement.logs) {
    json["logs"].push_back({{"name", log.identity.name},
                            {"filter_band", log.filter.band},
                            {"decimation", log.filter.decimate},
                            {"rest_speed", log.rest_speed}});
  }
  for (int i = 0; i < model.joints(); ++i) {
    const JointObservations& joint = found.measurement.observations.joints[static_cast<std::size_t>(i)];
    json["joints"].push_back({{"name", model.mechanism().joints()[static_cast<std::size_t>(i)].joint},
                              {"rms_torque", joint.rms_torque()},
                              {"rms_residual", joint.rms_residual(estimate.values)},
                              {"sigma", estimate.torque_deviations(i)},
                              {"rms_residual_of_links", joint.rms_residual(found.physical.pi_b)},
                              {"rows", joint.rows}});
  }
  json["frames"] = name_of(found.frames);
  json["base_parameters"] = base_parameters_json(model, found);
  json["singular_values"] = list(estimate.singular_values);
  json["condition_number"] = estimate.condition();
  json["weights"] = {{"stable", estimate.converged}, {"iterations", estimate.iterations}};
  json["physical"] = {{"pi", found.physical.pi},
                      {"largest_misfit", found.physical.largest_misfit},
                      {"divergence", found.physical.divergence},
                      {"converged", found.physical.converged}};
  json["doubts"] = found.warning_texts;
  json["damped"] = json["hidden"] = nlohmann::ordered_json::array();
  for (const auto& [singular_value, components] : estimate.damped) {
    json["damped"].push_back({{"relative_singular_value", singular_value}, {"components", list(components)}});
  }
  for (const auto& [deviation, components] : estimate.hidden) {
    json["hidden"].push_back({{"standard_deviation", deviation}, {"components", list(components)}});
  }
  return json;
}

}  // namespace flatdyn

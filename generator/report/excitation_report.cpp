// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/excitation_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "diagnostics/table.hpp"
#include "plot/time_table.hpp"
#include "symbolic/notation/combination_text.hpp"

namespace flatdyn {
namespace {

// The number of parameters of the weakest direction that are shown.
constexpr std::size_t kWeakestShown = 5;
constexpr std::size_t kPointsPerCurve = 500;

std::string percent(double fraction) { return fmt::format("{:.0f} %", 100 * fraction); }

std::string most_used(const LimitUse& use) {
  const std::pair<double, const char*> kinds[] = {
      {use.position, "position"}, {use.speed, "speed"}, {use.acceleration, "acceleration"}, {use.torque, "torque"}};
  return std::max_element(std::begin(kinds), std::end(kinds),
                          [](const auto& a, const auto& b) { return a.first < b.first; })
      ->second;
}

std::string use_table(const Mechanism& mechanism, const std::vector<LimitUse>& use) {
  std::vector<std::vector<std::string>> rows = {{"joint", "position", "speed", "acceleration", "torque", "most used"}};
  for (std::size_t i = 0; i < use.size(); ++i) {
    const Body& body = mechanism.joints()[i];
    rows.push_back({body.joint, percent(use[i].position), percent(use[i].speed), percent(use[i].acceleration),
                    body.limits.effort ? percent(use[i].torque) : "-", most_used(use[i])});
  }
  return aligned_table(rows);
}

// Indices into π_b, those with the largest weight in the weakest direction first.
std::vector<int> weakest_first(const Eigen::VectorXd& weakest) {
  std::vector<int> order(static_cast<std::size_t>(weakest.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return std::abs(weakest(a)) > std::abs(weakest(b)); });
  order.resize(std::min(order.size(), kWeakestShown));
  return order;
}

// The sign that makes the largest entry of a direction positive; a direction has no sign of its own.
double sign_of(const Eigen::VectorXd& direction) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  return std::copysign(1, direction(largest));
}

std::string weakest_table(const BaseParameters& base, const Eigen::VectorXd& weakest) {
  std::vector<std::vector<std::string>> rows = {{"pi_b", "part", "combination"}};
  for (const int k : weakest_first(weakest)) {
    rows.push_back(
        {std::to_string(k), fmt::format("{:+.2f}", sign_of(weakest) * weakest(k)), combination_text(base, k)});
  }
  return aligned_table(rows);
}

// Ratios of the parameters' standard deviations after the planned motion to those before, in ascending order; 0 for
// parameters that were open.
Eigen::VectorXd ratios_of_deviations(const Excitation& excitation, const Conditioning& before) {
  Eigen::VectorXd ratios = excitation.motion.conditioning.standard_deviations.cwiseQuotient(before.standard_deviations);
  for (double& ratio : ratios) ratio = std::isfinite(ratio) ? ratio : 0;
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

std::string ratios_text(const std::string& what, const Eigen::VectorXd& ratios) {
  return fmt::format("\nstandard deviations of the parameters, {}: {:.2g} the median, {:.2g} the largest\n", what,
                     ratios(ratios.size() / 2), ratios(ratios.size() - 1));
}

nlohmann::ordered_json ratios_json(const Eigen::VectorXd& ratios) {
  return {{"median", ratios(ratios.size() / 2)}, {"largest", ratios(ratios.size() - 1)}};
}

void append(std::string& line, const std::vector<double>& values) {
  // Adding 0.0 avoids negative zeros.
  for (const double value : values) line += fmt::format(",{}", value + 0.0);
}

Panel motion_panel(const Mechanism& mechanism, const std::string& title, const std::string& label,
                   const std::vector<double>& times) {
  Panel panel{title, "t in s", label, {}};
  for (const Body& body : mechanism.joints()) panel.series.push_back({body.joint, times, {}});
  return panel;
}

}  // namespace

std::string describe_excitation(const TorqueModel& model, const Excitation& excitation,
                                const std::optional<LoggedInformation>& logged) {
  const PlannedMotion& motion = excitation.motion;
  std::string text =
      fmt::format("{} base parameters, {} samples, {} evaluations{}\n\n", model.parameters(), motion.samples.size(),
                  excitation.evaluations, excitation.out_of_time ? " (ended by --time)" : "");
  const Conditioning &before = excitation.start.conditioning, &after = motion.conditioning;
  text += aligned_table(
      {{"condition number", "random start", "found"},
       {"columns by their lengths in random motions", fmt::format("{:.4g}", before.relative),
        fmt::format("{:.4g}", after.relative)},
       {"columns of unit length", fmt::format("{:.4g}", before.scaled), fmt::format("{:.4g}", after.scaled)},
       {"unscaled", fmt::format("{:.4g}", before.unscaled), fmt::format("{:.4g}", after.unscaled)}});
  text += ratios_text("found to random", ratios_of_deviations(excitation, before));
  if (logged) {
    text += ratios_text("found to the logs alone", ratios_of_deviations(excitation, *excitation.logs)) +
            fmt::format("{:.6g} s of logs count beside every motion\n", logged->seconds);
  }
  text += "\nlargest part of each limit that is used:\n" + use_table(model.mechanism(), motion.use);
  return text + "\nthe motion shows least, of all combinations of the parameters:\n" +
         weakest_table(model.base(), after.weakest);
}

nlohmann::ordered_json excitation_json(const TorqueModel& model, const Excitation& excitation,
                                       const std::optional<LoggedInformation>& logged) {
  const auto numbers = [](const PlannedMotion& motion) {
    return nlohmann::ordered_json{{"relative", motion.conditioning.relative},
                                  {"scaled", motion.conditioning.scaled},
                                  {"unscaled", motion.conditioning.unscaled}};
  };
  const PlannedMotion& motion = excitation.motion;
  const Eigen::VectorXd to_start = ratios_of_deviations(excitation, excitation.start.conditioning);
  nlohmann::ordered_json json = {{"robot", model.mechanism().name},
                                 {"base_parameters", model.parameters()},
                                 {"samples", motion.samples.size()},
                                 {"evaluations", excitation.evaluations},
                                 {"out_of_time", excitation.out_of_time},
                                 {"condition_number", numbers(motion)},
                                 {"condition_number_of_start", numbers(excitation.start)},
                                 {"standard_deviations_to_start", ratios_json(to_start)}};
  if (logged) {
    const Eigen::VectorXd to_logs = ratios_of_deviations(excitation, *excitation.logs);
    json["logs"] = {{"seconds", logged->seconds}, {"standard_deviations_to_logs", ratios_json(to_logs)}};
  }
  for (std::size_t i = 0; i < motion.use.size(); ++i) {
    const LimitUse& use = motion.use[i];
    json["limits_used"].push_back({{"joint", model.mechanism().joints()[i].joint},
                                   {"position", use.position},
                                   {"speed", use.speed},
                                   {"acceleration", use.acceleration},
                                   {"torque", use.torque}});
  }
  const Eigen::VectorXd& weakest = motion.conditioning.weakest;
  for (const int k : weakest_first(weakest)) {
    json["weakest"].push_back(
        {{"pi_b", k}, {"combination", combination_text(model.base(), k)}, {"part", sign_of(weakest) * weakest(k)}});
  }
  for (const FourierSeries& series : motion.trajectory.series()) {
    json["series"].push_back({{"a", series.a}, {"b", series.b}});
  }
  return json;
}

std::string excitation_csv(const PlannedMotion& motion) {
  std::string text = "t";
  for (const char* name : {"q", "qd", "qdd", "tau"}) {
    for (int i = 1; i <= motion.trajectory.joints(); ++i) text += fmt::format(",{}{}", name, i);
  }
  text += "\n";
  for (std::size_t k = 0; k < motion.samples.size(); ++k) {
    std::string line = fmt::format("{}", motion.time(k));
    append(line, motion.samples[k].q);
    append(line, motion.samples[k].qd);
    append(line, motion.samples[k].qdd);
    append(line, motion.torques[k]);
    text += line + "\n";
  }
  return text;
}

std::string excitation_plot(const Mechanism& mechanism, const PlannedMotion& motion) {
  const std::size_t step = std::max<std::size_t>(1, (motion.samples.size() - 1) / kPointsPerCurve);
  std::vector<double> times;
  for (std::size_t k = 0; k < motion.samples.size(); k += step) times.push_back(motion.time(k));
  std::vector<Panel> panels = {
      motion_panel(mechanism, "positions", "q in " + unit_of(mechanism, "rad", "m"), times),
      motion_panel(mechanism, "speeds", "dq/dt in " + unit_of(mechanism, "rad/s", "m/s"), times),
      motion_panel(mechanism, "expected torques", "tau in " + unit_of(mechanism, "N m", "N"), times)};
  for (std::size_t i = 0; i < mechanism.joints().size(); ++i) {
    for (std::size_t k = 0; k < motion.samples.size(); k += step) {
      panels[0].series[i].y.push_back(motion.samples[k].q[i]);
      panels[1].series[i].y.push_back(motion.samples[k].qd[i]);
      panels[2].series[i].y.push_back(motion.torques[k][i]);
    }
  }
  return svg_plot(mechanism.name + ": exciting motion", panels);
}

}  // namespace flatdyn

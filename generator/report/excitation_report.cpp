// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/excitation_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/diagnostics/table.hpp"
#include "laboratory/identify/base_coordinates.hpp"
#include "report/combination_table.hpp"
#include "report/plot/time_table.hpp"
#include "robot/input/csv/names.hpp"

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

// The joint's name, or that of a coordinate of a floating base.
std::string coordinate_name(const Mechanism& mechanism, int coordinate) {
  static const char* const kOfBase[] = {"base_x", "base_y", "base_z", "base_roll", "base_pitch", "base_yaw"};
  return coordinate < mechanism.base_bodies() ? kOfBase[coordinate] : mechanism.joint(coordinate).joint;
}

std::string use_table(const Mechanism& mechanism, const std::vector<LimitUse>& use) {
  std::vector<std::vector<std::string>> rows = {{"joint", "position", "speed", "acceleration", "torque", "most used"}};
  for (std::size_t i = 0; i < use.size(); ++i) {
    const auto coordinate = static_cast<int>(i);
    rows.push_back({coordinate_name(mechanism, coordinate), percent(use[i].position), percent(use[i].speed),
                    percent(use[i].acceleration),
                    mechanism.joint(coordinate).limits.effort ? percent(use[i].torque) : "-", most_used(use[i])});
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

std::string weakest_table(const MotionEquations& equations, const Eigen::VectorXd& weakest, ParameterFrames frames) {
  const TorqueModel& model = equations.model();
  std::vector<CombinationRow> rows;
  for (const int k : weakest_first(weakest)) {
    const int column = equations.columns()[static_cast<std::size_t>(k)];
    rows.push_back({column, {std::to_string(column), fmt::format("{:+.2f}", sign_of(weakest) * weakest(k))}});
  }
  const Combinations combinations(model.mechanism(), model.base(), frames);
  return combination_table({"pi_b", "part"}, rows, combinations) + note_on_frames(model.mechanism(), frames);
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

template <class Numbers>
void append(std::string& line, const Numbers& values) {
  // Adding 0.0 avoids negative zeros.
  for (const double value : values) line += fmt::format(",{}", value + 0.0);
}

Panel motion_panel(const Mechanism& mechanism, const std::string& title, const std::string& label,
                   const std::vector<double>& times) {
  Panel panel{title, "t in s", label, {}};
  for (const Body& body : mechanism.joints()) panel.series.push_back({body.joint, times, {}});
  return panel;
}

void add_base_panels(const std::vector<double>& times, std::vector<Panel>& panels) {
  const auto add = [&](const char* title, const char* label, std::initializer_list<const char*> names) {
    Panel panel{title, "t in s", label, {}};
    for (const char* name : names) panel.series.push_back({name, times, {}});
    panels.push_back(std::move(panel));
  };
  add("base: position", "p in m", {"x", "y", "z"});
  add("base: orientation", "angle in rad", {"roll", "pitch", "yaw"});
  add("base: expected force", "f in N", {"f_x", "f_y", "f_z"});
  add("base: expected moment", "n in N m", {"n_x", "n_y", "n_z"});
}

}  // namespace

std::string describe_excitation(const MotionEquations& equations, const Excitation& excitation,
                                const std::optional<LoggedInformation>& logged, ParameterFrames frames) {
  const TorqueModel& model = equations.model();
  const PlannedMotion& motion = excitation.motion;
  std::string text =
      fmt::format("{} base parameters{}, {} samples, {} evaluations{}\n\n", equations.parameters(),
                  equations.parameters() < model.parameters()
                      ? fmt::format(" of {} ({} need the force on the base)", model.parameters(),
                                    model.parameters() - equations.parameters())
                      : "",
                  motion.samples.size(), excitation.evaluations, excitation.out_of_time ? " (ended by --time)" : "");
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
         weakest_table(equations, after.weakest, frames);
}

nlohmann::ordered_json excitation_json(const MotionEquations& equations, const Excitation& excitation,
                                       const std::optional<LoggedInformation>& logged, ParameterFrames frames) {
  const TorqueModel& model = equations.model();
  const auto numbers = [](const PlannedMotion& motion) {
    return nlohmann::ordered_json{{"relative", motion.conditioning.relative},
                                  {"scaled", motion.conditioning.scaled},
                                  {"unscaled", motion.conditioning.unscaled}};
  };
  const PlannedMotion& motion = excitation.motion;
  const Eigen::VectorXd to_start = ratios_of_deviations(excitation, excitation.start.conditioning);
  nlohmann::ordered_json json = {{"robot", model.mechanism().name},
                                 {"base_parameters", equations.parameters()},
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
    json["limits_used"].push_back({{"joint", coordinate_name(model.mechanism(), static_cast<int>(i))},
                                   {"position", use.position},
                                   {"speed", use.speed},
                                   {"acceleration", use.acceleration},
                                   {"torque", use.torque}});
  }
  const Eigen::VectorXd& weakest = motion.conditioning.weakest;
  const Combinations canonical(model.mechanism(), model.base(), ParameterFrames::canonical);
  const Combinations in_file(model.mechanism(), model.base(), frames);
  json["frames"] = name_of(frames);
  for (const int k : weakest_first(weakest)) {
    const int column = equations.columns()[static_cast<std::size_t>(k)];
    json["weakest"].push_back(
        {{"pi_b", column}, {"combination", canonical.text(column)}, {"part", sign_of(weakest) * weakest(k)}});
    if (frames == ParameterFrames::file) json["weakest"].back()["file_combination"] = in_file.text(column);
  }
  for (const FourierSeries& series : motion.trajectory.series()) {
    json["series"].push_back({{"a", series.a}, {"b", series.b}});
  }
  return json;
}

std::string excitation_csv(const MotionEquations& equations, const PlannedMotion& motion) {
  const Mechanism& mechanism = equations.model().mechanism();
  const int base = mechanism.base_bodies();
  std::string text = "t";
  for (int i = 0; i < length_of(CsvQuantity::pose, mechanism); ++i) {
    text += "," + base_name_of(CsvQuantity::pose, i, mechanism);
  }
  for (int i = 1; i <= mechanism.position_count(); ++i) text += fmt::format(",q{}", i);
  for (const CsvQuantity quantity : {CsvQuantity::qd, CsvQuantity::qdd, CsvQuantity::tau}) {
    for (int i = 0; i < equations.coordinates(); ++i) {
      const std::string of_base = base_name_of(quantity, i, mechanism);
      text += "," + (of_base.empty() ? fmt::format("{}{}", stem_of(quantity), i + 1) : of_base);
    }
  }
  text += "\n";
  for (std::size_t k = 0; k < motion.samples.size(); ++k) {
    const FourierMotion& sample = motion.samples[k];
    const PlannedState state = equations.state(sample.q.data(), sample.qd.data(), sample.qdd.data());
    const auto& [place, turn, twist, twist_rates] = state.base;
    std::string line = fmt::format("{}", motion.time(k));
    if (base > 0) append(line, std::array{place.x(), place.y(), place.z(), turn.w(), turn.x(), turn.y(), turn.z()});
    append(line, state.q);
    append(line, state.v);
    append(line, state.a);
    append(line, motion.torques[k]);
    text += line + "\n";
  }
  return text;
}

std::string excitation_plot(const MotionEquations& equations, const PlannedMotion& motion) {
  const Mechanism& mechanism = equations.model().mechanism();
  const std::size_t step = std::max<std::size_t>(1, (motion.samples.size() - 1) / kPointsPerCurve);
  std::vector<double> times;
  for (std::size_t k = 0; k < motion.samples.size(); k += step) times.push_back(motion.time(k));
  std::vector<Panel> panels = {
      motion_panel(mechanism, "positions", "q in " + unit_of(mechanism, "rad", "m"), times),
      motion_panel(mechanism, "speeds", "dq/dt in " + unit_of(mechanism, "rad/s", "m/s"), times),
      motion_panel(mechanism, "expected torques", "tau in " + unit_of(mechanism, "N m", "N"), times)};
  const auto base = static_cast<std::size_t>(mechanism.base_bodies());
  if (base > 0) add_base_panels(times, panels);
  for (std::size_t k = 0; k < motion.samples.size(); k += step) {
    const FourierMotion& sample = motion.samples[k];
    for (std::size_t i = base; i < sample.q.size(); ++i) {
      panels[0].series[i - base].y.push_back(sample.q[i]);
      panels[1].series[i - base].y.push_back(sample.qd[i]);
      panels[2].series[i - base].y.push_back(motion.torques[k][i]);
    }
    for (std::size_t i = 0; i < base; ++i) {
      panels[3 + i / 3].series[i % 3].y.push_back(sample.q[i]);
      panels[5 + i / 3].series[i % 3].y.push_back(motion.torques[k][i]);
    }
  }
  return svg_plot(mechanism.name + ": exciting motion", panels);
}

}  // namespace flatdyn

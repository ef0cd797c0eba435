// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/simulation_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/plot.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kPointsPerCurve = 600;
constexpr std::size_t kEventsShown = 8;

using Member = Eigen::VectorXd SimulationRow::*;

void append(fmt::memory_buffer& text, double value) { fmt::format_to(std::back_inserter(text), ",{}", value + 0.0); }

std::string label(const Mechanism& mechanism, const MotionEvent& event) {
  return fmt::format("{} {}", mechanism.bodies[static_cast<std::size_t>(event.joint)].joint, to_string(event.kind));
}

// Rows that a picture shows.
std::vector<std::size_t> drawn(const SimulatedMotion& motion) {
  const std::size_t step = std::max<std::size_t>(1, motion.rows.size() / kPointsPerCurve);
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < motion.rows.size(); k += step) rows.push_back(k);
  return rows;
}

template <class Value>
Series series(const std::string& name, const SimulatedMotion& motion, const Value& value) {
  Series curve{name, {}, {}};
  for (const std::size_t k : drawn(motion)) {
    curve.x.push_back(motion.rows[k].time);
    curve.y.push_back(value(motion.rows[k]));
  }
  return curve;
}

Panel joint_panel(const std::string& title, const std::string& unit, const Mechanism& mechanism,
                  const SimulatedMotion& motion, Member member) {
  Panel panel{title, "t in s", unit, {}};
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    panel.series.push_back(series(mechanism.bodies[i].joint, motion, [&](const SimulationRow& row) {
      return (row.*member)(static_cast<Eigen::Index>(i));
    }));
  }
  return panel;
}

}  // namespace

std::string simulation_csv(const SimulatedMotion& motion) {
  static constexpr std::pair<const char*, Member> kColumns[] = {{"q", &SimulationRow::q},
                                                                {"qd", &SimulationRow::qd},
                                                                {"qdd", &SimulationRow::qdd},
                                                                {"tau", &SimulationRow::tau},
                                                                {"friction", &SimulationRow::friction}};
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "time");
  for (const auto& [name, member] : kColumns) {
    for (Eigen::Index i = 1; i <= motion.rows.front().q.size(); ++i) fmt::format_to(out, ",{}{}", name, i);
  }
  fmt::format_to(out, ",kinetic,potential,work,dissipated\n");
  for (const SimulationRow& row : motion.rows) {
    fmt::format_to(out, "{}", row.time);
    for (const auto& [name, member] : kColumns) {
      for (const double value : row.*member) append(text, value);
    }
    for (const double value : {row.kinetic, row.potential, row.work, row.dissipated}) append(text, value);
    text.push_back('\n');
  }
  return fmt::to_string(text);
}

std::string events_csv(const Mechanism& mechanism, const SimulatedMotion& motion) {
  std::string text = "time,joint,event\n";
  for (const MotionEvent& event : motion.events) {
    text += fmt::format("{},{},{}\n", event.time, mechanism.bodies[static_cast<std::size_t>(event.joint)].joint,
                        to_string(event.kind));
  }
  return text;
}

std::string simulation_plot(const Mechanism& mechanism, const SimulatedMotion& motion) {
  Panel energies{"energies", "t in s", "J", {}};
  static constexpr std::pair<const char*, double SimulationRow::*> kEnergies[] = {
      {"kinetic", &SimulationRow::kinetic},
      {"potential", &SimulationRow::potential},
      {"work of the torques", &SimulationRow::work},
      {"dissipated", &SimulationRow::dissipated}};
  for (const auto& [name, member] : kEnergies) {
    energies.series.push_back(
        series(name, motion, [member = member](const SimulationRow& row) { return row.*member; }));
  }
  return svg_plot(mechanism.name + ": simulated motion",
                  {joint_panel("positions", "q in rad, m", mechanism, motion, &SimulationRow::q),
                   joint_panel("speeds", "dq/dt in rad/s, m/s", mechanism, motion, &SimulationRow::qd),
                   joint_panel("torques", "tau in N m, N", mechanism, motion, &SimulationRow::tau), energies});
}

std::string describe_simulation(const Mechanism& mechanism, const SimulatedMotion& motion, double seconds) {
  std::string text = fmt::format("{} s of motion, {} rows; {} steps, {} evaluations of B and n, {:.3f} s\n", motion.end,
                                 motion.rows.size(), motion.steps, motion.evaluations, seconds);
  text += fmt::format("energies add up within {:.2g} J\n", energy_error(motion));
  if (motion.at_limit) text += fmt::format("ended: {}\n", label(mechanism, motion.events.back()));
  if (motion.events.empty()) return text;
  text += fmt::format("{} events{}:\n", motion.events.size(),
                      motion.events.size() > kEventsShown ? fmt::format(", the first {} of them", kEventsShown) : "");
  for (std::size_t k = 0; k < std::min(kEventsShown, motion.events.size()); ++k) {
    text += fmt::format("  t = {:.6f} s: {}\n", motion.events[k].time, label(mechanism, motion.events[k]));
  }
  return text;
}

nlohmann::ordered_json simulation_json(const Mechanism& mechanism, const SimulatedMotion& motion, double seconds) {
  nlohmann::ordered_json json = {{"robot", mechanism.name},
                                 {"end", motion.end},
                                 {"rows", motion.rows.size()},
                                 {"steps", motion.steps},
                                 {"evaluations", motion.evaluations},
                                 {"seconds", seconds},
                                 {"energy_error", energy_error(motion)},
                                 {"ended_at_limit", motion.at_limit},
                                 {"interrupted", motion.interrupted},
                                 {"events", nlohmann::ordered_json::array()}};
  for (const MotionEvent& event : motion.events) {
    json["events"].push_back({{"time", event.time},
                              {"joint", mechanism.bodies[static_cast<std::size_t>(event.joint)].joint},
                              {"event", to_string(event.kind)}});
  }
  return json;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/simulation_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace flatdyn {
namespace {

constexpr std::size_t kEventsShown = 8;

// The columns with one number per joint, in the order of the table.
constexpr std::pair<const char*, Eigen::VectorXd SimulationRow::*> kByJoint[] = {
    {"q", &SimulationRow::q},
    {"qd", &SimulationRow::qd},
    {"qdd", &SimulationRow::qdd},
    {"tau", &SimulationRow::tau},
    {"friction", &SimulationRow::friction}};
constexpr std::pair<const char*, double SimulationRow::*> kEnergies[] = {{"kinetic", &SimulationRow::kinetic},
                                                                         {"potential", &SimulationRow::potential},
                                                                         {"work", &SimulationRow::work},
                                                                         {"dissipated", &SimulationRow::dissipated}};

std::string label(const Mechanism& mechanism, const MotionEvent& event) {
  return fmt::format("{} {}", mechanism.joints()[static_cast<std::size_t>(event.joint)].joint, to_string(event.kind));
}

}  // namespace

TimeTable simulation_table(const SimulatedMotion& motion) {
  TimeTable table{{"t"}, {}};
  for (const auto& [name, member] : kByJoint) {
    for (Eigen::Index i = 1; i <= (motion.rows.front().*member).size(); ++i)
      table.columns.push_back(fmt::format("{}{}", name, i));
  }
  for (const auto& [name, member] : kEnergies) table.columns.emplace_back(name);
  for (const SimulationRow& row : motion.rows) {
    std::vector<double>& numbers = table.rows.emplace_back();
    numbers.reserve(table.columns.size());
    numbers.push_back(row.time);
    for (const auto& [name, member] : kByJoint)
      numbers.insert(numbers.end(), (row.*member).begin(), (row.*member).end());
    for (const auto& [name, member] : kEnergies) numbers.push_back(row.*member);
  }
  return table;
}

std::string events_csv(const Mechanism& mechanism, const SimulatedMotion& motion) {
  std::string text = "t,joint,event\n";
  for (const MotionEvent& event : motion.events) {
    text += fmt::format("{},{},{}\n", event.time, mechanism.joints()[static_cast<std::size_t>(event.joint)].joint,
                        to_string(event.kind));
  }
  return text;
}

std::string simulation_plot(const Mechanism& mechanism, const TimeTable& table, PictureFormat format) {
  const std::size_t n = mechanism.joints().size(), m = static_cast<std::size_t>(mechanism.position_count());
  std::vector<std::string> joints, positions;
  for (const Body& body : mechanism.joints()) joints.push_back(body.joint);
  for (int p = 0; p < mechanism.position_count(); ++p) positions.push_back(mechanism.joint_at(p).joint);
  const auto columns = [](std::size_t first, std::size_t count) {
    std::vector<std::size_t> all(count);
    std::iota(all.begin(), all.end(), first);
    return all;
  };
  const std::vector<PanelColumns> panels = {
      {"positions", "q in " + unit_of_positions(mechanism), columns(1, m), positions},
      {"speeds", "dq/dt in " + unit_of(mechanism, "rad/s", "m/s"), columns(1 + m, n), joints},
      {"torques", "tau in " + unit_of(mechanism, "N m", "N"), columns(1 + m + 2 * n, n), joints},
      {"energies",
       "J",
       columns(1 + m + 4 * n, std::size(kEnergies)),
       {"kinetic", "potential", "work of the torques", "dissipated"}}};
  return time_plot(mechanism.name + ": simulated motion", table, panels, format);
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
                              {"joint", mechanism.joints()[static_cast<std::size_t>(event.joint)].joint},
                              {"event", to_string(event.kind)}});
  }
  return json;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/simulation_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "robot/input/csv/names.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kEventsShown = 8;

// The columns with one number per joint, in the order of the table. Those of a floating base have names of their own;
// no friction acts on it.
struct ColumnsByJoint {
  const char* name;
  Eigen::VectorXd SimulationRow::*values;
  CsvQuantity quantity;
  bool is_of_base;
};
constexpr ColumnsByJoint kByJoint[] = {{"q", &SimulationRow::q, CsvQuantity::q, false},
                                       {"qd", &SimulationRow::qd, CsvQuantity::qd, true},
                                       {"qdd", &SimulationRow::qdd, CsvQuantity::qdd, true},
                                       {"tau", &SimulationRow::tau, CsvQuantity::tau, true},
                                       {"friction", &SimulationRow::friction, CsvQuantity::tau, false}};
constexpr const char* kPose[] = {"base_x", "base_y", "base_z", "base_qw", "base_qx", "base_qy", "base_qz"};
constexpr const char* kBase[] = {"base_gx",
                                 "base_gy",
                                 "base_gz",
                                 "momentum_x",
                                 "momentum_y",
                                 "momentum_z",
                                 "angular_momentum_x",
                                 "angular_momentum_y",
                                 "angular_momentum_z"};
constexpr std::pair<const char*, double SimulationRow::*> kEnergies[] = {{"kinetic", &SimulationRow::kinetic},
                                                                         {"potential", &SimulationRow::potential},
                                                                         {"work", &SimulationRow::work},
                                                                         {"dissipated", &SimulationRow::dissipated}};

std::string label(const Mechanism& mechanism, const MotionEvent& event) {
  return fmt::format("{} {}", mechanism.joint(event.joint).joint, to_string(event.kind));
}

// The first entry that has a column: friction of a floating base has none.
Eigen::Index first_entry(const ColumnsByJoint& columns, const Mechanism& mechanism) {
  return columns.values == &SimulationRow::friction ? mechanism.base_bodies() : 0;
}

std::vector<std::string> columns_of_motion(const Mechanism& mechanism, const SimulationRow& row) {
  std::vector<std::string> names = {"t"};
  if (row.base) names.insert(names.end(), std::begin(kPose), std::end(kPose));
  for (const ColumnsByJoint& columns : kByJoint) {
    for (Eigen::Index i = first_entry(columns, mechanism); i < (row.*columns.values).size(); ++i) {
      const std::string of_base =
          columns.is_of_base ? base_name_of(columns.quantity, static_cast<int>(i), mechanism) : "";
      names.push_back(of_base.empty() ? fmt::format("{}{}", columns.name, i + 1) : of_base);
    }
  }
  for (const auto& [name, member] : kEnergies) names.emplace_back(name);
  if (row.base) names.insert(names.end(), std::begin(kBase), std::end(kBase));
  return names;
}

template <class Values>
void append_all(const Values& values, std::vector<double>& numbers) {
  numbers.insert(numbers.end(), values.begin(), values.end());
}

std::vector<double> numbers_of_row(const Mechanism& mechanism, const SimulationRow& row) {
  std::vector<double> numbers = {row.time};
  if (row.base) append_all(row.base->pose.position, numbers);
  if (row.base) append_all(row.base->pose.orientation, numbers);
  for (const ColumnsByJoint& columns : kByJoint) {
    const Eigen::VectorXd& values = row.*columns.values;
    numbers.insert(numbers.end(), values.begin() + first_entry(columns, mechanism), values.end());
  }
  for (const auto& [name, member] : kEnergies) numbers.push_back(row.*member);
  if (!row.base) return numbers;
  for (const auto& each : {row.base->gravity, row.base->momentum.linear, row.base->momentum.angular}) {
    append_all(each, numbers);
  }
  return numbers;
}

}  // namespace

TimeTable simulation_table(const Mechanism& mechanism, const SimulatedMotion& motion) {
  TimeTable table{columns_of_motion(mechanism, motion.rows.front()), {}};
  for (const SimulationRow& row : motion.rows) table.rows.push_back(numbers_of_row(mechanism, row));
  return table;
}

std::string events_csv(const Mechanism& mechanism, const SimulatedMotion& motion) {
  std::string text = "t,joint,event\n";
  for (const MotionEvent& event : motion.events) {
    text += fmt::format("{},{},{}\n", event.time, mechanism.joint(event.joint).joint, to_string(event.kind));
  }
  return text;
}

std::string simulation_plot(const Mechanism& mechanism, const TimeTable& table, PictureFormat format) {
  const std::size_t n = mechanism.joints().size(), m = static_cast<std::size_t>(mechanism.position_count());
  const auto place = [&table](const std::string& name) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), name);
    return static_cast<std::size_t>(found - table.columns.begin());
  };
  const auto of_joints = [&](const char* stem) {
    return place(fmt::format("{}{}", stem, mechanism.base_bodies() + 1));
  };
  const std::vector<std::string> joints = mechanism.joint_names(), positions = mechanism.position_names();
  const auto columns = [](std::size_t first, std::size_t count) {
    std::vector<std::size_t> all(count);
    std::iota(all.begin(), all.end(), first);
    return all;
  };
  std::vector<PanelColumns> panels;
  if (mechanism.floating_base) {
    panels.push_back({"base", "position in m", columns(place("base_x"), 3), {"x", "y", "z"}});
    panels.push_back({"orientation", "quaternion", columns(place("base_qw"), 4), {"w", "x", "y", "z"}});
  }
  if (n > 0) {
    panels.push_back({"positions", "q in " + unit_of_positions(mechanism), columns(place("q1"), m), positions});
    panels.push_back({"speeds", "dq/dt in " + unit_of(mechanism, "rad/s", "m/s"), columns(of_joints("qd"), n), joints});
    panels.push_back({"torques", "tau in " + unit_of(mechanism, "N m", "N"), columns(of_joints("tau"), n), joints});
  }
  panels.push_back({"energies",
                    "J",
                    columns(place("kinetic"), std::size(kEnergies)),
                    {"kinetic", "potential", "work of the torques", "dissipated"}});
  return time_plot(mechanism.name + ": simulated motion", table, panels, format);
}

std::string describe_simulation(const Mechanism& mechanism, const SimulatedMotion& motion, double seconds) {
  std::string text = fmt::format("{} s of motion, {} rows; {} steps, {} evaluations of B and n, {:.3f} s\n", motion.end,
                                 motion.rows.size(), motion.steps, motion.evaluations, seconds);
  text += fmt::format("energies add up within {:.2g} J\n", energy_error(motion));
  if (mechanism.floating_base) {
    const Momentum error = momentum_error(motion);
    text += fmt::format(
        "momentum adds up within {:.2g} kg m/s, its moment about the centre of mass within {:.2g} kg m^2/s\n",
        error.linear.maxCoeff(), error.angular.maxCoeff());
  }
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
  if (mechanism.floating_base) {
    const Momentum error = momentum_error(motion);
    json["momentum_error"] = error.linear.maxCoeff();
    json["angular_momentum_error"] = error.angular.maxCoeff();
  }
  for (const MotionEvent& event : motion.events) {
    json["events"].push_back(
        {{"time", event.time}, {"joint", mechanism.joint(event.joint).joint}, {"event", to_string(event.kind)}});
  }
  return json;
}

}  // namespace flatdyn

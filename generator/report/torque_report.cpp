// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/torque_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "report/fields.hpp"

namespace flatdyn {
namespace {

// A group of contributions that are shown together.
struct TermGroup {
  const char* name;
  const char* key;  // key in JSON
  std::vector<TermKind> kinds;
};

const std::vector<TermGroup>& groups() {
  static const std::vector<TermGroup> all = {{"own inertia", "own_inertia", {TermKind::own_inertia}},
                                             {"coupling", "coupling", {TermKind::coupling}},
                                             {"centrifugal", "centrifugal", {TermKind::centrifugal}},
                                             {"Coriolis", "coriolis", {TermKind::coriolis}},
                                             {"gravity", "gravity", {TermKind::gravity}},
                                             {"friction", "friction", {TermKind::viscous, TermKind::coulomb}},
                                             {"springs", "springs", {TermKind::spring}},
                                             {"tip force", "tip_force", {TermKind::tip_force}}};
  return all;
}

bool belongs(const TermGroup& group, TermKind kind) {
  return std::find(group.kinds.begin(), group.kinds.end(), kind) != group.kinds.end();
}

bool occurs(const TermGroup& group, const TorqueHistory& history) {
  return std::any_of(history.terms.begin(), history.terms.end(),
                     [&group](const TorqueTerm& term) { return belongs(group, term.kind); });
}

bool occurs(const TermGroup& group, const TorqueHistory& history, int joint) {
  return std::any_of(history.terms.begin(), history.terms.end(),
                     [&](const TorqueTerm& term) { return term.joint == joint && belongs(group, term.kind); });
}

std::vector<double> sum_of(const TermGroup& group, const TorqueHistory& history, int joint) {
  std::vector<double> sums(history.values.size(), 0);
  for (std::size_t k = 0; k < history.terms.size(); ++k) {
    if (history.terms[k].joint != joint || !belongs(group, history.terms[k].kind)) continue;
    for (std::size_t p = 0; p < sums.size(); ++p) sums[p] += history.values[p][k];
  }
  return sums;
}

std::vector<double> torques_of(const TorqueHistory& history, int joint) {
  std::vector<double> values;
  for (const std::vector<double>& tau : history.tau) values.push_back(tau[static_cast<std::size_t>(joint)]);
  return values;
}

// The index of the largest magnitude.
std::size_t peak(const std::vector<double>& values) {
  return static_cast<std::size_t>(
      std::max_element(values.begin(), values.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      values.begin());
}

// The largest torque of a joint along the trajectory, and the largest of each group of contributions by itself.
struct JointPeak {
  std::string joint, unit;
  double torque, time;                       // N m or N, s
  std::vector<std::optional<double>> parts;  // by group
};

std::vector<JointPeak> peaks_of(const Mechanism& mechanism, const Trajectory& trajectory,
                                const TorqueHistory& history) {
  std::vector<JointPeak> peaks;
  for (int i = 0; i < mechanism.size(); ++i) {
    const Body& body = mechanism.joints()[static_cast<std::size_t>(i)];
    const std::vector<double> tau = torques_of(history, i);
    const std::size_t at = peak(tau);
    JointPeak& each =
        peaks.emplace_back(JointPeak{body.joint, torque_unit(body), tau[at], trajectory.points[at].time, {}});
    for (const TermGroup& group : groups()) {
      const std::vector<double> sums = sum_of(group, history, i);
      each.parts.push_back(occurs(group, history, i) ? std::optional(sums[peak(sums)]) : std::nullopt);
    }
  }
  return peaks;
}

ReportFields<JointPeak> peak_fields(const TorqueHistory& history) {
  using Json = nlohmann::ordered_json;
  ReportFields<JointPeak> fields = {{"joint", "joint", &JointPeak::joint},
                                    {"unit", "unit", &JointPeak::unit},
                                    {"torque", "torque", &JointPeak::torque, "{:.4g}"},
                                    {"at", "at", &JointPeak::time, "{:.4g} s"}};
  for (std::size_t k = 0; k < groups().size(); ++k) {
    if (!occurs(groups()[k], history)) continue;
    fields.push_back({groups()[k].name, "", [k](auto& each) { return each.parts[k].value_or(0); }, "{:.4g}"});
    fields.push_back({"", std::string("contributions.") + groups()[k].key,
                      [k](auto& each) { return each.parts[k] ? Json(*each.parts[k]) : Json(); }});
  }
  return fields;
}

std::string term_label(const TorqueTerm& term) {
  std::string text = term.kind == TermKind::coriolis ? "Coriolis" : name_of(term.kind);
  if (term.kind == TermKind::coulomb) text = "Coulomb";
  if (term.kind == TermKind::tip_force) text = "tip force";
  if (term.j >= 0) text += fmt::format(" {}", term.j + 1);
  if (term.k >= 0) text += fmt::format(" {}", term.k + 1);
  return text;
}

constexpr std::size_t kMostCurves = 7;  // the number of colours

// Columns of the table for a joint's contributions; if there are many terms, sums of each kind are appended to the
// table and used instead.
PanelColumns contributions(const Body& body, int joint, const TorqueHistory& history, std::size_t first_term,
                           TimeTable& table) {
  PanelColumns panel{"torque of " + body.joint, std::string("tau in ") + torque_unit(body), {}, {}};
  for (std::size_t k = 0; k < history.terms.size(); ++k) {
    if (history.terms[k].joint != joint) continue;
    panel.columns.push_back(first_term + k);
    panel.names.push_back(term_label(history.terms[k]));
  }
  if (panel.columns.size() <= kMostCurves) return panel;
  panel.columns.clear();
  panel.names.clear();
  for (const TermGroup& group : groups()) {
    if (!occurs(group, history, joint)) continue;
    panel.columns.push_back(table.columns.size());
    panel.names.emplace_back(group.name);
    table.columns.emplace_back(group.name);
    const std::vector<double> sums = sum_of(group, history, joint);
    for (std::size_t p = 0; p < sums.size(); ++p) table.rows[p].push_back(sums[p]);
  }
  return panel;
}

PanelColumns of_all_joints(const Mechanism& mechanism, const std::string& title, const std::string& label,
                           std::size_t first) {
  PanelColumns panel{title, label, {}, {}};
  for (std::size_t i = 0; i < mechanism.joints().size(); ++i) {
    panel.columns.push_back(first + i);
    panel.names.push_back(mechanism.joints()[i].joint);
  }
  return panel;
}

PanelColumns of_all_positions(const Mechanism& mechanism) {
  PanelColumns panel{"positions", "q in " + unit_of_positions(mechanism), {}, {}};
  for (int p = 0; p < mechanism.position_count(); ++p) {
    panel.columns.push_back(static_cast<std::size_t>(1 + p));
    panel.names.push_back(mechanism.joint_at(p).joint);
  }
  return panel;
}

}  // namespace

TimeTable trajectory_table(const Trajectory& trajectory, const ByPoint& q, const ByPoint& tau) {
  TimeTable table{{"t"}, {}};
  const auto add_columns = [&table](const char* stem, std::size_t count) {
    for (std::size_t i = 1; i <= count; ++i) table.columns.push_back(fmt::format("{}{}", stem, i));
  };
  const std::size_t n = trajectory.points.front().q.size();
  add_columns("q", q.front().size());
  for (const char* stem : {"qd", "qdd"}) add_columns(stem, n);
  add_columns("h_e", trajectory.points.front().h_e.size());
  add_columns("tau", n);
  for (std::size_t p = 0; p < trajectory.points.size(); ++p) {
    const TrajectoryPoint& point = trajectory.points[p];
    std::vector<double>& row = table.rows.emplace_back(1, point.time);
    for (const auto* part : {&q[p], &point.qd, &point.qdd, &point.h_e, &tau[p]}) {
      row.insert(row.end(), part->begin(), part->end());
    }
  }
  return table;
}

TimeTable torque_table(const Trajectory& trajectory, const ByPoint& q, const TorqueHistory& history) {
  TimeTable table = trajectory_table(trajectory, q, history.tau);
  for (const TorqueTerm& term : history.terms) table.columns.push_back(term.name());
  for (std::size_t p = 0; p < table.rows.size(); ++p) {
    table.rows[p].insert(table.rows[p].end(), history.values[p].begin(), history.values[p].end());
  }
  return table;
}

std::string describe_torques(const Mechanism& mechanism, const Trajectory& trajectory, const TorqueHistory& history) {
  return fmt::format("{:.6g} s, {} samples; largest torques, and largest of each contribution by itself:\n\n{}",
                     trajectory.duration(), trajectory.points.size(),
                     table_of(peak_fields(history), peaks_of(mechanism, trajectory, history)));
}

nlohmann::ordered_json torques_json(const Mechanism& mechanism, const Trajectory& trajectory,
                                    const TorqueHistory& history) {
  return {{"robot", mechanism.name},
          {"duration", trajectory.duration()},
          {"samples", trajectory.points.size()},
          {"disagreement", history.disagreement},
          {"joints", objects_of(peak_fields(history), peaks_of(mechanism, trajectory, history))}};
}

std::vector<PanelColumns> motion_panels(const Mechanism& mechanism, bool tip_force) {
  const std::size_t n = mechanism.joints().size(), m = static_cast<std::size_t>(mechanism.position_count());
  const std::size_t torques = 1 + m + 2 * n + (tip_force ? 6 : 0);
  return {of_all_positions(mechanism),
          of_all_joints(mechanism, "rates", "dq/dt in " + unit_of(mechanism, "rad/s", "m/s"), 1 + m),
          of_all_joints(mechanism, "accelerations", "in " + unit_of(mechanism, "rad/s^2", "m/s^2"), 1 + m + n),
          of_all_joints(mechanism, "torques", "tau in " + unit_of(mechanism, "N m", "N"), torques)};
}

std::string torque_plot(const Mechanism& mechanism, const Trajectory& trajectory, const ByPoint& q,
                        const TorqueHistory& history, PictureFormat format) {
  TimeTable table = torque_table(trajectory, q, history);
  const std::size_t first_term = table.columns.size() - history.terms.size();
  std::vector<PanelColumns> panels = motion_panels(mechanism, trajectory.has_tip_force());
  for (int i = 0; i < mechanism.size(); ++i) {
    panels.push_back(contributions(mechanism.joints()[static_cast<std::size_t>(i)], i, history, first_term, table));
  }
  return time_plot(mechanism.name + ": torques along the trajectory", table, panels, format);
}

}  // namespace flatdyn

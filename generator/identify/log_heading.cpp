// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>

#include "identify/log_layout.hpp"

namespace flatdyn {
namespace {

enum class Quantity { time, q, tau, qd, qdd, h_e };

struct Unit {
  const char* name;
  double factor;
};

constexpr double kDegree = std::numbers::pi / 180;

// SI first. Powers of time by the quantity: a rate in deg/s, an acceleration in deg/s^2.
std::vector<Unit> units_of(Quantity quantity, bool prismatic, int index) {
  static const std::vector<Unit> times = {{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}};
  static const std::vector<Unit> forces = {{"N", 1}, {"kN", 1e3}};
  static const std::vector<Unit> moments = {{"N m", 1}, {"Nm", 1}, {"N*m", 1}, {"mNm", 1e-3}, {"Nmm", 1e-3}};
  static const std::map<Quantity, std::vector<Unit>> lengths = {
      {Quantity::q, {{"m", 1}, {"mm", 1e-3}}},
      {Quantity::qd, {{"m/s", 1}, {"mm/s", 1e-3}}},
      {Quantity::qdd, {{"m/s^2", 1}, {"m/s2", 1}, {"mm/s^2", 1e-3}, {"mm/s2", 1e-3}}}};
  static const std::map<Quantity, std::vector<Unit>> angles = {
      {Quantity::q, {{"rad", 1}, {"deg", kDegree}}},
      {Quantity::qd, {{"rad/s", 1}, {"deg/s", kDegree}}},
      {Quantity::qdd, {{"rad/s^2", 1}, {"rad/s2", 1}, {"deg/s^2", kDegree}, {"deg/s2", kDegree}}}};
  constexpr int kFirstMoment = 3;
  switch (quantity) {
    case Quantity::time:
      return times;
    case Quantity::tau:
      return prismatic ? forces : moments;
    case Quantity::h_e:
      return index < kFirstMoment ? forces : moments;
    default:
      return prismatic ? lengths.at(quantity) : angles.at(quantity);
  }
}

struct Meaning {
  Quantity quantity;
  int index;
};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\"");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

// "q1 [deg]" → "q1", "deg"; also with round brackets.
std::pair<std::string, std::string> split_unit(const std::string& text) {
  const auto open = text.find_last_of("[(");
  if (open == std::string::npos || (text.back() != ']' && text.back() != ')')) return {text, ""};
  return {trimmed(text.substr(0, open)), trimmed(text.substr(open + 1, text.size() - open - 2))};
}

const Body& body_with(const Mechanism& mechanism, Quantity quantity, int index) {
  const int body = quantity == Quantity::q ? mechanism.body_at(index) : mechanism.body_of(index);
  return mechanism.bodies[static_cast<std::size_t>(body)];
}

// Names of everything that is read.
std::map<std::string, Meaning> known_names(const Mechanism& mechanism) {
  std::map<std::string, Meaning> names = {{"t", {Quantity::time, 0}}, {"time", {Quantity::time, 0}}};
  static constexpr std::pair<const char*, Quantity> kStems[] = {
      {"q", Quantity::q}, {"tau", Quantity::tau}, {"qd", Quantity::qd}, {"qdd", Quantity::qdd}};
  for (const auto& [stem, quantity] : kStems) {
    const int count = quantity == Quantity::q ? mechanism.position_count() : mechanism.size();
    for (int i = 0; i < count; ++i) {
      names[stem + std::to_string(i + 1)] = {quantity, i};
      names[stem + ("_" + std::to_string(i + 1))] = {quantity, i};  // as `flatdyn eval` writes it
    }
    for (int i = 0; i < count; ++i) names[stem + ("_" + body_with(mechanism, quantity, i).joint)] = {quantity, i};
  }
  static constexpr const char* kForces[] = {"fx", "fy", "fz", "mx", "my", "mz"};
  for (int k = 0; k < LogLayout::kWrench; ++k) {
    names["h_e" + std::to_string(k + 1)] = {Quantity::h_e, k};
    names[kForces[k]] = {Quantity::h_e, k};
  }
  return names;
}

struct NamedColumn {
  std::string written, unit;
  std::optional<Meaning> meaning;
};

std::vector<NamedColumn> named_columns(const std::string& line, const Mechanism& mechanism) {
  const std::map<std::string, Meaning> names = known_names(mechanism);
  std::vector<NamedColumn> columns;
  std::size_t begin = 0;
  while (begin <= line.size()) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    const auto [name, unit] = split_unit(trimmed(line.substr(begin, end - begin)));
    const auto found = names.find(name);
    columns.push_back({name, unit, found == names.end() ? std::nullopt : std::optional(found->second)});
    begin = end + 1;
  }
  return columns;
}

// "q7", "tau_7"; asked of names that no joint of the robot has.
bool is_of_a_joint(const std::string& name) {
  for (const std::string stem : {"q", "tau", "qd", "qdd"}) {
    if (name.compare(0, stem.size(), stem) != 0) continue;
    const std::size_t number = stem.size() + (name.size() > stem.size() && name[stem.size()] == '_' ? 1 : 0);
    if (number < name.size() && name.find_first_not_of("0123456789", number) == std::string::npos) return true;
  }
  return false;
}

// The first ten names, and how many there are besides.
std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 10;
  std::vector<std::string> shown(names.begin(), names.begin() + static_cast<long>(std::min(kMost, names.size())));
  for (std::string& name : shown) {
    if (name.empty()) name = "(no name)";
  }
  const std::string more = names.size() > kMost ? fmt::format(" and {} more", names.size() - kMost) : "";
  return fmt::format("{}{}", fmt::join(shown, ", "), more);
}

class HeadingReader {
 public:
  HeadingReader(const Place& place, const Mechanism& mechanism, bool torques, Diagnostics& diagnostics)
      : place_(place), mechanism_(mechanism), torques_(torques), diagnostics_(diagnostics) {}

  LogHeading read(const std::string& line) {
    if (has_other_separators(line)) return {};
    const std::vector<NamedColumn> columns = named_columns(line, mechanism_);
    for (const NamedColumn& column : columns) count(column);
    LogHeading heading;
    heading.layout.joints = mechanism_.size();
    heading.layout.positions = mechanism_.position_count();
    for (int i = 0; i < mechanism_.size(); ++i) heading.layout.position_of.push_back(mechanism_.position_of(i));
    require_all(Quantity::time, "time", "t", 1);
    require_all(Quantity::q, "positions", "q", mechanism_.position_count());
    heading.layout.has_torques = torques_;
    if (torques_) require_all(Quantity::tau, "torques", "tau", mechanism_.size());
    heading.layout.has_rates = all_or_none(Quantity::qd, "qd", mechanism_.size());
    heading.layout.has_accelerations = all_or_none(Quantity::qdd, "qdd", mechanism_.size());
    heading.layout.has_tip_force = all_or_none(Quantity::h_e, "h_e", LogLayout::kWrench);
    for (const NamedColumn& column : columns) heading.columns.push_back(placed(column, heading.layout));
    note_unused();
    return heading;
  }

 private:
  // Said by itself: that no column is there would say nothing more.
  bool has_other_separators(const std::string& line) {
    if (line.find(',') != std::string::npos) return false;
    const bool semicolons = line.find(';') != std::string::npos;
    if (!semicolons && line.find('\t') == std::string::npos) return false;
    diagnostics_.error(place_, fmt::format("columns are separated by {}", semicolons ? "semicolons" : "tabs"),
                       "write the log with commas between columns, and points in numbers");
    return true;
  }

  void count(const NamedColumn& column) {
    if (!column.meaning) {
      (is_of_a_joint(column.written) ? of_other_joints_ : unused_).push_back(column.written);
    } else if (++seen_[column.meaning->quantity][column.meaning->index] == 2) {
      diagnostics_.error(place_, fmt::format("column \"{}\" is there twice", column.written),
                         "a joint is named once, by its number or by its name");
    }
  }

  std::vector<std::string> missing(Quantity quantity, const std::string& stem, int length) {
    std::vector<std::string> names;
    for (int k = 0; k < length; ++k) {
      if (seen_[quantity].count(k) == 0) names.push_back(length == 1 ? stem : stem + std::to_string(k + 1));
    }
    return names;
  }

  void require_all(Quantity quantity, const std::string& what, const std::string& stem, int length) {
    const std::vector<std::string> names = missing(quantity, stem, length);
    if (names.empty()) return;
    diagnostics_.error(place_, fmt::format("no column for the {}: {}", what, fmt::join(names, ", ")),
                       "columns t, q1, ..., tau1, ..., or q_JOINT, tau_JOINT; flatdyn inspect lists the joints");
  }

  bool all_or_none(Quantity quantity, const std::string& stem, int length) {
    const std::vector<std::string> names = missing(quantity, stem, length);
    if (!names.empty() && static_cast<int>(names.size()) < length) {
      diagnostics_.error(place_, fmt::format("no column for {}", fmt::join(names, ", ")),
                         fmt::format("give all {} columns of {}, or none", length, stem));
    }
    return names.empty();
  }

  LogColumn placed(const NamedColumn& column, const LogLayout& layout) {
    if (!column.meaning) return {column.written, -1, 1};
    const auto [quantity, index] = *column.meaning;
    const int first[] = {LogLayout::time(), LogLayout::q(), layout.tau(), layout.qd(), layout.qdd(), layout.h_e()};
    const bool left_out = (quantity == Quantity::tau && !layout.has_torques) ||
                          (quantity == Quantity::qd && !layout.has_rates) ||
                          (quantity == Quantity::qdd && !layout.has_accelerations) ||
                          (quantity == Quantity::h_e && !layout.has_tip_force);
    return {column.written, left_out ? -1 : first[static_cast<int>(quantity)] + index, factor(column)};
  }

  double factor(const NamedColumn& column) {
    if (column.unit.empty()) return 1;
    const auto [quantity, index] = *column.meaning;
    const bool of_joint = quantity != Quantity::time && quantity != Quantity::h_e;
    const bool prismatic = of_joint && body_with(mechanism_, quantity, index).prismatic;
    const std::vector<Unit> units = units_of(quantity, prismatic, index);
    std::vector<std::string> names;
    for (const Unit& unit : units) {
      if (column.unit == unit.name) return unit.factor;
      names.emplace_back(unit.name);
    }
    diagnostics_.error(place_, fmt::format("column \"{}\": unknown unit \"{}\"", column.written, column.unit),
                       fmt::format("known units: {}", fmt::join(names, ", ")));
    return 1;
  }

  void note_unused() {
    if (!unused_.empty()) diagnostics_.note(place_, "columns that are not used: " + some_of(unused_));
    if (of_other_joints_.empty()) return;
    diagnostics_.warning(place_,
                         fmt::format("columns of joints that the robot does not have (it has {}) are not used: {}",
                                     mechanism_.position_count(), some_of(of_other_joints_)),
                         "is this the log of this robot, without joints that --fix holds?");
  }

  Place place_;
  const Mechanism& mechanism_;
  bool torques_;
  Diagnostics& diagnostics_;
  std::map<Quantity, std::map<int, int>> seen_;
  std::vector<std::string> unused_, of_other_joints_;
};

}  // namespace

LogHeading read_heading(const std::string& line, const Place& place, const Mechanism& mechanism, bool torques,
                        Diagnostics& diagnostics) {
  return HeadingReader(place, mechanism, torques, diagnostics).read(line);
}

}  // namespace flatdyn

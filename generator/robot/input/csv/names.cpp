// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/csv/names.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "base/diagnostics/characters.hpp"
#include "robot/input/csv/text.hpp"

namespace flatdyn {
namespace {

constexpr int kWrench = 6;
constexpr const char* kStepLength = "h";

// The columns of a floating base, by quantity.
const std::map<CsvQuantity, std::vector<std::string>>& base_columns() {
  static const std::map<CsvQuantity, std::vector<std::string>> names = {
      {CsvQuantity::qd, {"base_vx", "base_vy", "base_vz", "base_wx", "base_wy", "base_wz"}},
      {CsvQuantity::qdd, {"base_dvx", "base_dvy", "base_dvz", "base_dwx", "base_dwy", "base_dwz"}},
      {CsvQuantity::tau, {"base_fx", "base_fy", "base_fz", "base_nx", "base_ny", "base_nz"}},
      {CsvQuantity::g_b, {"base_gx", "base_gy", "base_gz"}},
      {CsvQuantity::pose, {"base_x", "base_y", "base_z", "base_qw", "base_qx", "base_qy", "base_qz"}},
      {CsvQuantity::imu, {"imu_ax", "imu_ay", "imu_az", "imu_wx", "imu_wy", "imu_wz"}}};
  return names;
}

// Longer ones first: "qd_r1" begins with "qd", too.
constexpr std::pair<const char*, CsvQuantity> kStems[] = {{"qd_end", CsvQuantity::qd_end},
                                                          {"qdd_r", CsvQuantity::qdd_r},
                                                          {"qd_r", CsvQuantity::qd_r},
                                                          {"qdd", CsvQuantity::qdd},
                                                          {"qd", CsvQuantity::qd},
                                                          {"tau", CsvQuantity::tau},
                                                          {"h_e", CsvQuantity::h_e},
                                                          {"pi_b", CsvQuantity::pi_b},
                                                          {"q", CsvQuantity::q},
                                                          {"temperature", CsvQuantity::temperature},
                                                          {"ddq", CsvQuantity::qdd},
                                                          {"dq", CsvQuantity::qd},
                                                          {"weights", CsvQuantity::weights},
                                                          {"direction", CsvQuantity::direction}};

// Messages use these words.
std::optional<CsvQuantity> quantity_of_word(const std::string& word) {
  static const std::map<std::string, CsvQuantity> words = {{"position", CsvQuantity::q},
                                                           {"positions", CsvQuantity::q},
                                                           {"velocity", CsvQuantity::qd},
                                                           {"velocities", CsvQuantity::qd},
                                                           {"acceleration", CsvQuantity::qdd},
                                                           {"accelerations", CsvQuantity::qdd},
                                                           {"effort", CsvQuantity::tau},
                                                           {"efforts", CsvQuantity::tau},
                                                           {"torque", CsvQuantity::tau},
                                                           {"torques", CsvQuantity::tau},
                                                           {"name", CsvQuantity::joint_name},
                                                           {"q", CsvQuantity::q},
                                                           {"qd", CsvQuantity::qd},
                                                           {"qdd", CsvQuantity::qdd},
                                                           {"tau", CsvQuantity::tau},
                                                           {"temperature", CsvQuantity::temperature}};
  const auto found = words.find(word);
  return found == words.end() ? std::nullopt : std::optional(found->second);
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

std::optional<int> number_of(std::string_view digits) {
  constexpr std::size_t kMostDigits = 6;
  int number = 0;
  if (!is_digits(digits) || digits.size() > kMostDigits) return std::nullopt;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

// "q1 [deg]" → "q1", "deg"; also with round brackets. A number in brackets is not a unit: q[0].
std::pair<std::string, std::string> split_unit(const std::string& text) {
  const auto open = text.find_last_of("[(");
  if (open == std::string::npos || (text.back() != ']' && text.back() != ')')) return {text, ""};
  const std::string unit(trimmed(std::string_view(text).substr(open + 1, text.size() - open - 2)));
  if (is_digits(unit)) return {text, ""};
  return {std::string(trimmed(std::string_view(text).substr(0, open))), unit};
}

// "position[2]", "position.2", "position2", "position_2" → "position", 2.
struct Numbered {
  std::string base;
  int number = 0;
};

std::optional<Numbered> numbered(const std::string& name) {
  std::size_t end = name.size(), skipped = 0;
  if (end > 0 && (name.back() == ']' || name.back() == ')')) skipped = 1;
  end -= skipped;
  const auto last = name.find_last_not_of("0123456789", end == 0 ? 0 : end - 1);
  const std::size_t begin = end == 0 || last == std::string::npos ? 0 : last + 1;
  if (begin == 0 || begin >= end) return std::nullopt;
  const std::optional<int> number = number_of(std::string_view(name).substr(begin, end - begin));
  if (!number) return std::nullopt;
  const char before = name[begin - 1];
  if (skipped > 0 && before != '[' && before != '(') return std::nullopt;
  const bool is_mark = skipped > 0 || before == '_' || before == '.' || before == '/';
  return Numbered{name.substr(0, begin - (is_mark ? 1 : 0)), *number};
}

bool is_separator(char c) { return c == '/' || c == '.'; }

// "/joint_states/position" → "/joint_states/", "position".
std::pair<std::string, std::string> split_path(const std::string& path) {
  const auto last = path.find_last_of("/.");
  if (last == std::string::npos) return {"", path};
  return {path.substr(0, last + 1), path.substr(last + 1)};
}

// `ending` stands at the end, by itself or behind a separator.
bool ends_with_part(const std::string& path, const std::string& ending) {
  if (path.size() < ending.size() || path.compare(path.size() - ending.size(), ending.size(), ending) != 0)
    return false;
  return path.size() == ending.size() || is_separator(path[path.size() - ending.size() - 1]);
}

bool read_symbol(CsvName& column, const Mechanism& mechanism) {
  for (std::size_t k = 0; k < mechanism.symbols.size(); ++k) {
    if (mechanism.symbols[k].name != column.name) continue;
    column.quantity = CsvQuantity::symbol;
    column.entry = static_cast<int>(k);
    return true;
  }
  return false;
}

bool read_step_length(CsvName& column) {
  if (column.name != kStepLength) return false;
  column.quantity = CsvQuantity::h;
  column.entry = 0;
  return true;
}

bool read_time(CsvName& column) {
  std::string path = lower_case(column.name);
  std::replace(path.begin(), path.end(), '/', '.');
  const auto is = [&](CsvQuantity quantity, CsvStyle style) {
    column.quantity = quantity;
    column.style = style;
    return true;
  };
  if (column.name == "t" || path == "time") return is(CsvQuantity::time, CsvStyle::named);
  if (path == "__time") return is(CsvQuantity::time, CsvStyle::plot);
  if (path == "timestamp") return is(CsvQuantity::time, CsvStyle::timestamp);
  if (path == "%time") return is(CsvQuantity::time, CsvStyle::message_bag);
  if (ends_with_part(path, "header.stamp")) return is(CsvQuantity::time, CsvStyle::message);
  for (const char* name : {"stamp.secs", "stamp.sec"}) {
    if (path == "secs" || ends_with_part(path, name)) return is(CsvQuantity::seconds, CsvStyle::message);
  }
  for (const char* name : {"stamp.nsecs", "stamp.nsec", "stamp.nanosec"}) {
    if (path == "nsecs" || ends_with_part(path, name)) return is(CsvQuantity::nanoseconds, CsvStyle::message);
  }
  return false;
}

bool read_wrench(CsvName& column) {
  static constexpr std::array<const char*, kWrench> kForces = {"fx", "fy", "fz", "mx", "my", "mz"};
  const auto found = std::find(kForces.begin(), kForces.end(), column.name);
  if (found == kForces.end()) return false;
  column.quantity = CsvQuantity::h_e;
  column.entry = static_cast<int>(found - kForces.begin());
  return true;
}

bool read_base(CsvName& column, const Mechanism& mechanism) {
  if (!mechanism.floating_base) return false;
  for (const auto& [quantity, names] : base_columns()) {
    const auto found = std::find(names.begin(), names.end(), column.name);
    if (found == names.end()) continue;
    column.quantity = quantity;
    column.entry = static_cast<int>(found - names.begin());
    return true;
  }
  return false;
}

// q_elbow.
bool read_joint(CsvName& column, const Mechanism& mechanism) {
  for (const auto& [stem, quantity] : kStems) {
    const std::string beginning = std::string(stem) + "_";
    if (!is_of_joints(quantity) || column.name.compare(0, beginning.size(), beginning) != 0) continue;
    column.entry = entry_of_joint(quantity, column.name.substr(beginning.size()), mechanism);
    if (!column.entry) continue;
    column.quantity = quantity;
    return true;
  }
  return false;
}

// q1, q_1, q[1].
bool read_number(CsvName& column) {
  const std::optional<Numbered> split = numbered(column.name);
  if (!split) return false;
  for (const auto& [stem, quantity] : kStems) {
    if (split->base != stem) continue;
    column.quantity = quantity;
    column.number = split->number;
    return true;
  }
  return false;
}

// /joint_states/elbow/position. Of two joints of which one's name ends with the other's, the longer one.
bool read_message(CsvName& column, const Mechanism& mechanism) {
  const auto [path, word] = split_path(column.name);
  const std::optional<CsvQuantity> quantity = quantity_of_word(word);
  if (path.empty() || !quantity || !is_of_joints(*quantity)) return false;
  const std::string joint_path = path.substr(0, path.size() - 1);
  std::size_t longest = 0;
  for (int k = 0; k < length_of(*quantity, mechanism); ++k) {
    const std::string joint = entry_name_of(*quantity, k, mechanism);
    if (joint.size() <= longest || !ends_with_part(joint_path, joint)) continue;
    longest = joint.size();
    column.entry = k;
  }
  if (!column.entry) return false;
  column.quantity = quantity;
  column.style = CsvStyle::message;
  return true;
}

// field.position0, position[0], /joint_states/position[0].
bool read_array(CsvName& column) {
  const std::optional<Numbered> split = numbered(column.name);
  if (!split) return false;
  const auto [prefix, word] = split_path(split->base);
  const std::optional<CsvQuantity> quantity = quantity_of_word(word);
  if (!quantity) return false;
  column.quantity = quantity;
  column.style = CsvStyle::array;
  column.number = split->number;
  column.prefix = prefix;
  return true;
}

}  // namespace

int length_of(CsvQuantity quantity, const Mechanism& mechanism) {
  switch (quantity) {
    case CsvQuantity::q:
      return mechanism.position_count();
    case CsvQuantity::h_e:
      return kWrench;
    case CsvQuantity::g_b:
    case CsvQuantity::pose:
    case CsvQuantity::imu:
      return mechanism.floating_base ? static_cast<int>(base_columns().at(quantity).size()) : 0;
    case CsvQuantity::h:
      return 1;
    case CsvQuantity::symbol:
      return static_cast<int>(mechanism.symbols.size());
    default:
      return is_of_joints(quantity) ? mechanism.size() : 0;
  }
}

const Body& joint_of(CsvQuantity quantity, int entry, const Mechanism& mechanism) {
  return quantity == CsvQuantity::q ? mechanism.joint_at(entry) : mechanism.joint(entry);
}

std::string entry_name_of(CsvQuantity quantity, int entry, const Mechanism& mechanism) {
  return quantity == CsvQuantity::q ? mechanism.position_name(entry) : mechanism.joint(entry).joint;
}

bool is_of_joints(CsvQuantity quantity) {
  switch (quantity) {
    case CsvQuantity::q:
    case CsvQuantity::qd:
    case CsvQuantity::qdd:
    case CsvQuantity::tau:
    case CsvQuantity::qd_r:
    case CsvQuantity::qdd_r:
    case CsvQuantity::qd_end:
    case CsvQuantity::temperature:
      return true;
    default:
      return false;
  }
}

std::string base_name_of(CsvQuantity quantity, int entry, const Mechanism& mechanism) {
  if (quantity == CsvQuantity::h) return kStepLength;
  const auto found = base_columns().find(quantity);
  const bool is_of_base = mechanism.floating_base && found != base_columns().end();
  if (!is_of_base || entry >= static_cast<int>(found->second.size())) return "";
  return found->second[static_cast<std::size_t>(entry)];
}

std::string stem_of(CsvQuantity quantity) {
  const auto* found =
      std::find_if(std::begin(kStems), std::end(kStems), [&](const auto& each) { return each.second == quantity; });
  return found == std::end(kStems) ? "" : found->first;
}

CsvQuantity quantity_of(InputKind kind) {
  const InputKind in_state = argument_row(kind).in_state;
  if (in_state == InputKind::parameter) return CsvQuantity::symbol;
  if (in_state == InputKind::g_b) return CsvQuantity::g_b;
  if (in_state == InputKind::h) return CsvQuantity::h;
  const std::string stem = argument_row(in_state).name;
  const auto* found =
      std::find_if(std::begin(kStems), std::end(kStems), [&](const auto& each) { return each.first == stem; });
  return found == std::end(kStems) ? CsvQuantity::q : found->second;
}

std::string column_name(const Input& input, const Mechanism& mechanism) {
  if (input.kind == InputKind::parameter) return mechanism.symbols[static_cast<std::size_t>(input.index)].name;
  const CsvQuantity quantity = quantity_of(input.kind);
  const std::string of_base = base_name_of(quantity, input.index, mechanism);
  return of_base.empty() ? stem_of(quantity) + std::to_string(input.index + 1) : of_base;
}

std::optional<int> entry_of_joint(CsvQuantity quantity, const std::string& joint, const Mechanism& mechanism) {
  for (int k = 0; k < length_of(quantity, mechanism); ++k) {
    if (entry_name_of(quantity, k, mechanism) == joint) return k;
  }
  return std::nullopt;
}

CsvName read_csv_name(const std::string& entry, const Mechanism& mechanism) {
  CsvName column;
  std::tie(column.name, column.unit) = split_unit(entry);
  if (read_symbol(column, mechanism) || read_step_length(column) || read_time(column) || read_wrench(column) ||
      read_base(column, mechanism) || read_joint(column, mechanism) || read_number(column) ||
      read_message(column, mechanism)) {
    return column;
  }
  read_array(column);
  return column;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/csv/heading.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "robot/input/csv/units.hpp"

namespace flatdyn {
namespace {

CsvDimension dimension_of(CsvQuantity quantity, int entry, const Mechanism& mechanism) {
  constexpr int kFirstMoment = 3, kFirstOfQuaternion = 3, kFirstOfGyroscope = 3;
  const bool slides = is_of_joints(quantity) && joint_of(quantity, entry, mechanism).prismatic;
  switch (quantity) {
    case CsvQuantity::time:
      return CsvDimension::time;
    case CsvQuantity::q:
      if (mechanism.is_of_quaternion(entry)) return CsvDimension::none;
      return slides ? CsvDimension::length : CsvDimension::angle;
    case CsvQuantity::qd:
    case CsvQuantity::qd_r:
    case CsvQuantity::qd_end:
      return slides ? CsvDimension::length_rate : CsvDimension::angle_rate;
    case CsvQuantity::qdd:
    case CsvQuantity::qdd_r:
      return slides ? CsvDimension::length_acceleration : CsvDimension::angle_acceleration;
    case CsvQuantity::tau:
      return slides ? CsvDimension::force : CsvDimension::moment;
    case CsvQuantity::temperature:
      return CsvDimension::temperature;
    case CsvQuantity::h_e:
      return entry < kFirstMoment ? CsvDimension::force : CsvDimension::moment;
    case CsvQuantity::g_b:
      return CsvDimension::length_acceleration;
    case CsvQuantity::pose:
      return entry < kFirstOfQuaternion ? CsvDimension::length : CsvDimension::none;
    case CsvQuantity::imu:
      return entry < kFirstOfGyroscope ? CsvDimension::length_acceleration : CsvDimension::angle_rate;
    default:
      return CsvDimension::none;
  }
}

std::string set_of_columns(const std::string& stem, int first, int length) {
  return length == 1 ? fmt::format("{}{}", stem, first)
                     : fmt::format("{0}{1} to {0}{2}", stem, first, first + length - 1);
}

std::vector<CsvSource> all_of(const std::vector<std::optional<CsvSource>>& found) {
  std::vector<CsvSource> sources;
  for (const std::optional<CsvSource>& each : found) sources.push_back(*each);
  return sources;
}

}  // namespace

std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 10;
  std::vector<std::string> shown(names.begin(), names.begin() + static_cast<long>(std::min(kMost, names.size())));
  for (std::string& name : shown) {
    if (name.empty()) name = "(no name)";
  }
  const std::string more = names.size() > kMost ? fmt::format(" and {} more", names.size() - kMost) : "";
  return fmt::format("{}{}", fmt::join(shown, ", "), more);
}

CsvHeading::CsvHeading(const std::vector<std::string>& entries, std::vector<std::string> first_row, Place place,
                       const Mechanism& mechanism, Diagnostics& diagnostics)
    : first_row_(std::move(first_row)), place_(std::move(place)), mechanism_(mechanism), diagnostics_(diagnostics) {
  for (const std::string& entry : entries) columns_.push_back(read_csv_name(entry, mechanism));
}

std::string CsvHeading::first_text(std::size_t column) const {
  return column < first_row_.size() ? first_row_[column] : "";
}

std::string CsvHeading::names_of(const std::vector<std::size_t>& columns) const {
  std::vector<std::string> names;
  for (const std::size_t column : columns) names.push_back(columns_[column].name);
  return some_of(names);
}

// A quantity may be written in several styles; the columns of the first style that the file has are its columns.
std::vector<std::size_t> CsvHeading::columns_of(CsvQuantity quantity) const {
  std::optional<CsvStyle> first;
  for (const CsvName& column : columns_) {
    if (column.quantity == quantity && (!first || column.style < *first)) first = column.style;
  }
  std::vector<std::size_t> columns;
  for (std::size_t c = 0; first && c < columns_.size(); ++c) {
    if (columns_[c].quantity == quantity && columns_[c].style == *first) columns.push_back(c);
  }
  return columns;
}

void CsvHeading::allow_unused(CsvQuantity quantity) {
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    if (columns_[c].quantity == quantity) used_.insert(c);
  }
}

std::vector<std::optional<CsvSource>> CsvHeading::find(CsvQuantity quantity) {
  return find(quantity, length_of(quantity, mechanism_));
}

std::vector<std::optional<CsvSource>> CsvHeading::find(CsvQuantity quantity, int length) {
  std::vector<std::optional<CsvSource>> found(static_cast<std::size_t>(length));
  for (const auto& [column, entry] : entries_of(quantity, length)) {
    std::optional<CsvSource>& source = found[static_cast<std::size_t>(entry)];
    used_.insert(column);
    if (!source) {
      source = source_of(column, quantity, entry);
      continue;
    }
    const std::string &first = name(source->column), &second = name(column);
    diagnostics_.error(place_,
                       first == second ? fmt::format("column \"{}\" is there twice", second)
                                       : fmt::format("columns \"{}\" and \"{}\" are the same quantity", first, second),
                       mechanism_.floating_base && is_of_joints(quantity)
                           ? "leave one of them out; numbers count the base's six entries first, so that joints "
                             "begin with 7: name columns by joint"
                           : "leave one of them out: a joint is named once, by its number or by its name");
    wrong_.insert(quantity);
  }
  if (length > 1 && !found.back()) warn_of_numbering(quantity, length);
  return found;
}

CsvHeading::Entries CsvHeading::entries_of(CsvQuantity quantity, int length) {
  Entries entries;
  std::vector<std::size_t> numbered;
  for (const std::size_t column : columns_of(quantity)) {
    if (columns_[column].entry) {
      entries[column] = *columns_[column].entry;
    } else {
      numbered.push_back(column);
    }
  }
  if (has_joint_names(numbered)) {
    place_by_joint_names(quantity, numbered, entries);
  } else {
    place_numbered(quantity, numbered, length, entries);
  }
  return entries;
}

void CsvHeading::place_numbered(CsvQuantity quantity, const std::vector<std::size_t>& columns, int length,
                                Entries& entries) {
  if (columns.empty()) return;
  if (!is_counted_well(quantity, columns, length)) {
    wrong_.insert(quantity);
    used_.insert(columns.begin(), columns.end());
    return;
  }
  const bool from_zero =
      std::any_of(columns.begin(), columns.end(), [&](std::size_t column) { return columns_[column].number == 0; });
  if (from_zero) count_from_zero(columns);
  for (const std::size_t column : columns) {
    const int entry = *columns_[column].number - (from_zero ? 0 : 1);
    if (entry < length) {
      entries[column] = entry;
    } else {
      leave_out(quantity, column, length);
    }
  }
  const bool is_array = columns_[columns.front()].style == CsvStyle::array;
  if (is_array && length > 1) in_file_order_.insert(in_file_order_.end(), columns.begin(), columns.end());
}

// A set is clear if it is all of the robot's, counted from 0 or from 1. It may lack some or have more only if nothing
// in the file is counted from 0: else it may be counted from either.
bool CsvHeading::is_counted_well(CsvQuantity quantity, const std::vector<std::size_t>& columns, int length) {
  std::set<int> numbers;
  for (const std::size_t column : columns) numbers.insert(*columns_[column].number);
  const bool is_contiguous = *numbers.rbegin() - *numbers.begin() + 1 == static_cast<int>(numbers.size());
  const bool has_all = is_contiguous && static_cast<int>(numbers.size()) == length;
  if (has_all && *numbers.begin() <= 1) return true;
  const auto is_zero = [style = columns_[columns.front()].style](const CsvName& each) {
    return each.quantity && is_of_joints(*each.quantity) && each.style == style && each.number == 0;
  };
  const auto zero = std::find_if(columns_.begin(), columns_.end(), is_zero);
  const bool has_zero = *numbers.begin() == 0;
  if (!has_zero && (zero == columns_.end() || !is_of_joints(quantity))) return true;
  const std::string why =
      has_zero ? fmt::format("the robot has {}", length) : fmt::format("and {} is counted from 0", zero->name);
  const std::string stem = stem_of(quantity);
  const std::string first =
      is_of_joints(quantity) && length > 0 ? entry_name_of(quantity, 0, mechanism_) : std::string("JOINT");
  diagnostics_.error(
      place_,
      fmt::format("columns {} are neither {} nor {}, {}", names_of(columns), set_of_columns(stem, 0, length),
                  set_of_columns(stem, 1, length), why),
      fmt::format("give all of one set and no more, or name columns by joint, {}_{}: else it is not clear "
                  "which column is which joint's",
                  stem, first));
  return false;
}

// q1 to q5 of six joints: the first five, or the last five of a set from q0 to q5 whose first column is missing.
void CsvHeading::warn_of_numbering(CsvQuantity quantity, int length) {
  std::set<int> numbers;
  for (const std::size_t column : columns_of(quantity)) {
    if (!columns_[column].number || joint_name_of(column)) return;
    numbers.insert(*columns_[column].number);
  }
  const bool is_all_but_one = static_cast<int>(numbers.size()) == length - 1;
  if (!is_all_but_one || *numbers.begin() != 1 || *numbers.rbegin() != length - 1) return;
  perhaps_from_zero_.push_back(set_of_columns(stem_of(quantity), 1, length - 1));
}

void CsvHeading::count_from_zero(const std::vector<std::size_t>& columns) {
  const auto by_number = [&](std::size_t a, std::size_t b) { return *columns_[a].number < *columns_[b].number; };
  const std::string first = name(*std::min_element(columns.begin(), columns.end(), by_number));
  const std::string last = name(*std::max_element(columns.begin(), columns.end(), by_number));
  const std::string set = first == last ? first : fmt::format("{} to {}", first, last);
  if (std::find(from_zero_.begin(), from_zero_.end(), set) == from_zero_.end()) from_zero_.push_back(set);
}

// Where loops are closed, rates and torques are fewer than positions: columns of all joints would be taken for others.
void CsvHeading::leave_out(CsvQuantity quantity, std::size_t column, int length) {
  used_.insert(column);
  if (!mechanism_.has_loops() || quantity == CsvQuantity::q || !is_of_joints(quantity)) {
    of_other_joints_.push_back(column);
    return;
  }
  const std::string stem = stem_of(quantity);
  diagnostics_.error(place_,
                     fmt::format("column {}: {} has {} entries, of the independent joints", name(column), stem, length),
                     fmt::format("name columns by joint, the first one {}_{}", stem, mechanism_.joint(0).joint));
  wrong_.insert(quantity);
}

std::optional<std::size_t> CsvHeading::joint_name_of(std::size_t column) const {
  const CsvName& entry = columns_[column];
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const CsvName& other = columns_[c];
    if (other.quantity == CsvQuantity::joint_name && other.prefix == entry.prefix && other.number == entry.number) {
      return c;
    }
  }
  return std::nullopt;
}

bool CsvHeading::has_joint_names(const std::vector<std::size_t>& columns) const {
  return std::any_of(columns.begin(), columns.end(), [&](std::size_t column) {
    return columns_[column].style == CsvStyle::array && joint_name_of(column).has_value();
  });
}

// Messages have an order of their own, and may have joints that the robot does not have.
void CsvHeading::place_by_joint_names(CsvQuantity quantity, const std::vector<std::size_t>& columns, Entries& entries) {
  for (const std::size_t column : columns) {
    const std::optional<std::size_t> name_column = joint_name_of(column);
    if (!name_column) {
      diagnostics_.error(place_, fmt::format("no column tells which joint \"{}\" belongs to", name(column)),
                         "other entries of the array have one: add it, or leave all of them out");
      wrong_.insert(quantity);
      continue;
    }
    const std::string joint = first_text(*name_column);
    fixed_texts_[*name_column] = joint;
    if (const std::optional<int> entry = entry_of_joint(quantity, joint, mechanism_)) entries[column] = *entry;
  }
}

CsvSource CsvHeading::source_of(std::size_t column, CsvQuantity quantity, int entry) {
  const CsvName& written = columns_[column];
  if (written.unit.empty()) return {column};
  const CsvDimension dimension = dimension_of(quantity, entry, mechanism_);
  if (const std::optional<Number> factor = unit_factor(written.unit, dimension)) return {column, *factor};
  const bool may_be_current = quantity == CsvQuantity::tau && !mechanism_.is_of_base(entry);
  const std::optional<Number> amperes = unit_factor(written.unit, CsvDimension::current);
  if (may_be_current && amperes) return source_of_current(column, entry, *amperes);
  std::vector<std::string> known = known_units(dimension);
  if (may_be_current) known.push_back(known_units(CsvDimension::current).front());
  diagnostics_.error(place_, fmt::format("column \"{}\": unknown unit \"{}\"", written.name, written.unit),
                     known.empty() ? "leave the unit out: it has the robot file's"
                                   : fmt::format("known units: {}", fmt::join(known, ", ")));
  wrong_.insert(quantity);
  return {column};
}

CsvSource CsvHeading::source_of_current(std::size_t column, int entry, const Number& amperes) {
  const Body& body = joint_of(CsvQuantity::tau, entry, mechanism_);
  if (body.current_to_torque) return {column, amperes * *body.current_to_torque, true};
  diagnostics_.error(place_,
                     fmt::format("column \"{}\" is a current, but the robot has no gain of the drive of joint \"{}\"",
                                 columns_[column].name, body.joint),
                     fmt::format("give current_to_torque, {}/A, in the robot file or under [current_to_torque] of a "
                                 "scene; flatdyn payload --known-mass estimates it",
                                 torque_unit(body)));
  wrong_.insert(CsvQuantity::tau);
  return {column};
}

// "tau2", and "base_fx" of a floating base.
std::string CsvHeading::number_name(CsvQuantity quantity, int entry) const {
  const std::string of_base = base_name_of(quantity, entry, mechanism_);
  return of_base.empty() ? fmt::format("{}{}", stem_of(quantity), entry + 1) : of_base;
}

CsvHeading::Sources CsvHeading::part_of(CsvQuantity quantity, CsvEntries entries) {
  if (found_.count(quantity) == 0) found_[quantity] = find(quantity);
  const Sources& all = found_[quantity];
  const auto first = all.begin() + entries.first;
  return {first, entries.count ? first + *entries.count : all.end()};
}

bool CsvHeading::is_missing_some(CsvQuantity quantity, const Sources& found, int first, const std::string& message,
                                 const std::string& hint) {
  if (wrong_.count(quantity) > 0) return true;
  std::vector<std::string> missing;
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (!found[k]) missing.push_back(number_name(quantity, first + static_cast<int>(k)));
  }
  if (missing.empty()) return false;
  diagnostics_.error(place_, fmt::format("{}{}", message, fmt::join(missing, ", ")), hint);
  return true;
}

std::vector<CsvSource> CsvHeading::require(CsvQuantity quantity, const std::string& what, CsvEntries entries) {
  const Sources found = part_of(quantity, entries);
  const std::string hint =
      mechanism_.floating_base && is_of_joints(quantity) && quantity != CsvQuantity::q
          ? fmt::format(
                "columns {0}_JOINT; numbers count the base's six entries first, so that {0}7 is of the first "
                "joint; flatdyn inspect lists the joints",
                stem_of(quantity))
          : "columns t, q1, ..., tau1, ..., or q_JOINT, tau_JOINT; flatdyn inspect lists the joints";
  if (is_missing_some(quantity, found, entries.first, fmt::format("no column for the {}: ", what), hint)) return {};
  return all_of(found);
}

std::vector<CsvSource> CsvHeading::all_or_none(CsvQuantity quantity, CsvEntries entries) {
  const Sources found = part_of(quantity, entries);
  const bool is_any =
      std::any_of(found.begin(), found.end(), [](const std::optional<CsvSource>& each) { return each.has_value(); });
  if (!is_any) return {};
  const int last = entries.first + static_cast<int>(found.size()) - 1;
  const std::string of_base = base_name_of(quantity, entries.first, mechanism_);
  const std::string hint =
      of_base.empty() ? fmt::format("give all {} columns of {}, or none", found.size(), stem_of(quantity))
                      : fmt::format("give all {} columns from {} to {}, or none{}", found.size(), of_base,
                                    number_name(quantity, last),
                                    is_of_joints(quantity) ? "; numbers count the base's six entries first" : "");
  if (is_missing_some(quantity, found, entries.first, "no column for ", hint)) return {};
  return all_of(found);
}

void CsvHeading::finish() {
  if (!from_zero_.empty()) {
    diagnostics_.note(place_, fmt::format("columns counted from 0: {}", fmt::join(from_zero_, ", ")), {},
                      "headings with columns counted from 0");
  }
  if (!perhaps_from_zero_.empty() && !diagnostics_.has_errors()) {
    diagnostics_.warning(place_,
                         fmt::format("{}: the last joint has no column; is the set counted from 0, and its 0 missing? "
                                     "It is counted from 1 here",
                                     fmt::join(perhaps_from_zero_, ", ")),
                         "give a column to each joint, or name columns by joint");
  }
  if (!in_file_order_.empty()) {
    const std::vector<std::string> joints = mechanism_.joint_names();
    diagnostics_.warning(place_,
                         fmt::format("no column tells which joints {} belong to: they are taken in the robot's order",
                                     names_of(in_file_order_)),
                         fmt::format("a message has an order of its own; name columns by joint, or log the message's "
                                     "names, too. The robot's order: {}",
                                     some_of(joints)));
  }
  std::vector<std::size_t> unused;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    if (used_.count(c) == 0 && fixed_texts_.count(c) == 0) unused.push_back(c);
  }
  if (!unused.empty()) {
    const bool is_of_base = std::any_of(unused.begin(), unused.end(), [&](std::size_t c) {
      return columns_[c].name.starts_with("base_") || columns_[c].name.starts_with("imu_");
    });
    diagnostics_.note(
        place_, "columns that are not used: " + names_of(unused),
        is_of_base && !mechanism_.floating_base ? "columns of a floating base: --base floating lets the base move" : "",
        "headings with columns that are not used");
  }
  if (of_other_joints_.empty()) return;
  diagnostics_.warning(place_,
                       fmt::format("columns of joints that the robot does not have (it has {}) are not used: {}",
                                   mechanism_.position_count(), names_of(of_other_joints_)),
                       "is this the log of this robot, without joints that --fix holds?");
}

}  // namespace flatdyn

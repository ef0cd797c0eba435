// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/coordinate_limits.hpp"

#include <algorithm>

#include "robot/model/exact_sign.hpp"
#include "robot/model/rational_rotation.hpp"

namespace flatdyn {

namespace {

Value scaled(const Value& limit, const Number& factor) { return {(limit.number * factor).expand(), limit.place}; }

void take_lower(std::optional<Value>& limit, const std::optional<Value>& other) {
  if (other && (!limit || is_below(other->number, limit->number))) limit = other;
}

void take_higher(std::optional<Value>& limit, const std::optional<Value>& other) {
  if (other && (!limit || is_below(limit->number, other->number))) limit = other;
}

// Applies the limits of a joint that follows one coordinate alone to that coordinate.
void tighten(const Limits& joint, const LinearPosition& position, Limits& limits) {
  const Number factor = position.factors.begin()->second;
  const bool turns_back = is_negative(factor);
  const Number size = absolute(factor);
  const auto at_coordinate = [&](const std::optional<Value>& limit) -> std::optional<Value> {
    if (!limit) return std::nullopt;
    return Value{rationalised((limit->number - position.offset) / factor), limit->place};
  };
  const auto rate_of = [&](const std::optional<Value>& limit) -> std::optional<Value> {
    return limit ? std::optional(scaled(*limit, 1 / size)) : std::nullopt;
  };
  take_higher(limits.lower, at_coordinate(turns_back ? joint.upper : joint.lower));
  take_lower(limits.upper, at_coordinate(turns_back ? joint.lower : joint.upper));
  take_lower(limits.velocity, rate_of(joint.velocity));
  take_lower(limits.acceleration, rate_of(joint.acceleration));
}

void check_coordinate_range(const Robot& robot, int owner, const Limits& limits, Diagnostics& diagnostics) {
  if (!limits.lower || !limits.upper) return;
  if (!is_below(limits.upper->number, limits.lower->number)) return;
  diagnostics.error(limits.lower->place,
                    "joint \"" + robot.joints[static_cast<std::size_t>(owner)].name +
                        "\" and those that follow it have limits that leave it no position: above " +
                        to_decimal(limits.lower->number, 6) + " and below " + to_decimal(limits.upper->number, 6) +
                        " (line " + std::to_string(limits.upper->place.line) + ")",
                    "correct the limits, or the multipliers and offsets");
}

// Notes that limits of joints that follow several coordinates are not used.
void note_idle_limits(const Joint& joint, Diagnostics& diagnostics) {
  const Limits& limits = joint.limits;
  if (!limits.lower && !limits.upper && !limits.velocity && !limits.acceleration) return;
  diagnostics.note(
      joint.place,
      "joint \"" + joint.name + "\" follows several coordinates: its limits bound none of them alone, and are not used",
      "nothing to do, unless you rely on them", "joints that follow several coordinates, whose limits are not used");
}

// The rank of the factors, by elimination: the number of coordinates that the joints' positions determine.
std::size_t independent_coordinates(const std::vector<LinearPosition>& positions, const std::vector<int>& owners) {
  std::vector<std::map<int, Number>> rows;
  for (const LinearPosition& position : positions) rows.push_back(position.factors);
  std::size_t rank = 0;
  for (const int owner : owners) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                                    [owner](const auto& row) { return row.contains(owner); });
    if (pivot == rows.end()) continue;
    std::swap(rows[rank], *pivot);
    for (std::size_t r = rank + 1; r < rows.size(); ++r) {
      if (!rows[r].contains(owner)) continue;
      const Number factor = rows[r].at(owner) / rows[rank].at(owner);
      for (const auto& [column, entry] : rows[rank]) rows[r][column] -= factor * entry;
      std::erase_if(rows[r], [](const auto& entry) { return vanishes(entry.second); });
    }
    ++rank;
  }
  return rank;
}

}  // namespace

Limits coordinate_limits(const Robot& robot, const std::vector<LinearPosition>& positions, int owner) {
  Limits limits;
  for (const int joint : moving_joints(robot)) {
    const LinearPosition& position = positions[static_cast<std::size_t>(joint)];
    if (position.factors.size() != 1 || position.factors.begin()->first != owner) continue;
    const Joint& follower = robot.joints[static_cast<std::size_t>(joint)];
    tighten(follower.limits, position, limits);
    if (joint != owner || !follower.limits.effort) continue;
    limits.effort = scaled(*follower.limits.effort, absolute(position.factors.begin()->second));
  }
  return limits;
}

void check_coordinates(const Robot& robot, Diagnostics& diagnostics) {
  if (!has_coupled_joints(robot)) return;
  const std::vector<LinearPosition> positions = joint_positions(robot);
  const std::vector<int> owners = joints_with_coordinates(robot);
  for (const int owner : owners)
    check_coordinate_range(robot, owner, coordinate_limits(robot, positions, owner), diagnostics);
  for (std::size_t j = 0; j < positions.size(); ++j) {
    if (positions[j].factors.size() > 1) note_idle_limits(robot.joints[j], diagnostics);
  }
  if (independent_coordinates(positions, owners) == owners.size()) return;
  const auto coupled = std::find_if(owners.begin(), owners.end(), [&](int owner) {
    return robot.joints[static_cast<std::size_t>(owner)].coupled.has_value();
  });
  const Joint& joint = robot.joints[static_cast<std::size_t>(*coupled)];
  diagnostics.error(joint.coupled->place,
                    "the joints' positions do not tell their coordinates apart: some could move without any joint",
                    "let joint \"" + joint.name + "\" move by itself, or follow without naming itself");
}

}  // namespace flatdyn

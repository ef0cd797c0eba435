// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/coupling.hpp"

#include <algorithm>

#include "diagnostics/nearest.hpp"
#include "model/rational_rotation.hpp"

namespace flatdyn {

namespace {

int find_joint(const Robot& robot, const std::string& name) {
  const auto found = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&name](const Joint& joint) { return joint.name == name; });
  return found == robot.joints.end() ? -1 : static_cast<int>(found - robot.joints.begin());
}

bool has_own_coordinate(const Joint& joint) {
  if (joint.type == JointType::fixed) return false;
  return !joint.coupled || std::any_of(joint.coupled->terms.begin(), joint.coupled->terms.end(),
                                       [&joint](const Coupled::Term& term) { return term.joint.name == joint.name; });
}

// Follows the names from joint to joint until coordinates are reached.
class Follower {
 public:
  explicit Follower(const Robot& robot) : robot_(robot) {}

  LinearPosition position(int joint) {
    const Joint& follower = robot_.joints[static_cast<std::size_t>(joint)];
    if (follower.type == JointType::fixed) return {{}, follower.held ? follower.held->position : Number(0)};
    if (!follower.coupled) return {{{joint, 1}}, 0};
    LinearPosition result{{}, follower.coupled->offset};
    way_.push_back(joint);
    for (const Coupled::Term& term : follower.coupled->terms) add(term, result);
    way_.pop_back();
    std::erase_if(result.factors, [](const auto& factor) { return vanishes(factor.second); });
    return result;
  }

  const Reference* stranger() const { return stranger_; }     // the first name that is no joint's
  const std::vector<int>& circle() const { return circle_; }  // joints that follow each other

 private:
  void add(const Coupled::Term& term, LinearPosition& result) {
    const int leader = find_joint(robot_, term.joint.name);
    if (leader < 0) {
      if (stranger_ == nullptr) stranger_ = &term.joint;
      return;
    }
    LinearPosition leading{{{leader, 1}}, 0};
    if (!has_own_coordinate(robot_.joints[static_cast<std::size_t>(leader)])) {
      const auto before = std::find(way_.begin(), way_.end(), leader);
      if (before != way_.end()) {
        circle_.assign(before, way_.end());
        return;
      }
      leading = position(leader);
    }
    for (const auto& [joint, factor] : leading.factors) result.factors[joint] += term.factor * factor;
    result.offset += term.factor * leading.offset;
  }

  const Robot& robot_;
  std::vector<int> way_, circle_;
  const Reference* stranger_ = nullptr;
};

void report_stranger(const Robot& robot, const Joint& joint, const Reference& stranger, Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (const Joint& each : robot.joints) known.push_back(each.name);
  diagnostics.error(joint.coupled->place,
                    "joint \"" + joint.name + "\" follows joint \"" + stranger.name + "\", which does not exist",
                    hint_for_unknown(stranger.name, known, "joints"));
}

void report_circle(const Robot& robot, const Joint& joint, const std::vector<int>& circle, Diagnostics& diagnostics) {
  std::string names;
  for (const int each : circle) names += "\"" + robot.joints[static_cast<std::size_t>(each)].name + "\" -> ";
  diagnostics.error(joint.coupled->place, "joints follow each other: " + names + "\"" + joint.name + "\"",
                    "let one of them move by itself");
}

Value scaled(const Value& limit, const Number& factor) { return {(limit.number * factor).expand(), limit.place}; }

void take_lower(std::optional<Value>& limit, const std::optional<Value>& other) {
  if (other && (!limit || nearest_double(other->number) < nearest_double(limit->number))) limit = other;
}

void take_higher(std::optional<Value>& limit, const std::optional<Value>& other) {
  if (other && (!limit || nearest_double(other->number) > nearest_double(limit->number))) limit = other;
}

// A limit of a joint that follows one coordinate alone is one of that coordinate, too.
void tighten(const Limits& joint, const LinearPosition& position, Limits& limits) {
  const Number factor = position.factors.begin()->second;
  const bool turns_back = nearest_double(factor) < 0;
  const Number size = turns_back ? Number(-factor) : factor;
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

void check_range(const Robot& robot, int owner, Diagnostics& diagnostics) {
  const Limits limits = coordinate_limits(robot, owner);
  if (!limits.lower || !limits.upper) return;
  if (nearest_double(limits.lower->number) <= nearest_double(limits.upper->number)) return;
  diagnostics.error(limits.lower->place,
                    "joint \"" + robot.joints[static_cast<std::size_t>(owner)].name +
                        "\" and those that follow it have limits that leave it no position: above " +
                        to_decimal(limits.lower->number, 6) + " and below " + to_decimal(limits.upper->number, 6) +
                        " (line " + std::to_string(limits.upper->place.line) + ")",
                    "correct the limits, or the multipliers and offsets");
}

// By elimination: how many of the coordinates the joints' positions tell apart.
std::size_t independent_coordinates(const Robot& robot, const std::vector<int>& owners) {
  std::vector<std::map<int, Number>> rows;
  for (const int joint : moving_joints(robot)) rows.push_back(position_of(robot, joint).factors);
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

bool validate_couplings(const Robot& robot, Diagnostics& diagnostics) {
  bool valid = true;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    if (!joint.coupled || joint.type == JointType::fixed) continue;
    Follower follower(robot);
    follower.position(static_cast<int>(j));
    const std::vector<int>& circle = follower.circle();
    if (follower.stranger() != nullptr) {
      report_stranger(robot, joint, *follower.stranger(), diagnostics);
    } else if (!circle.empty()) {  // said once, of the first of its joints
      if (*std::min_element(circle.begin(), circle.end()) == static_cast<int>(j)) {
        report_circle(robot, joint, circle, diagnostics);
      }
    } else {
      continue;
    }
    valid = false;
  }
  return valid;
}

void refuse_fractions(const Robot& robot, Diagnostics& diagnostics) {
  constexpr int kMostTurns = 64;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    if (!joint.coupled || joint.type == JointType::fixed || joint.type == JointType::prismatic) continue;
    for (const auto& [owner, factor] : position_of(robot, static_cast<int>(j)).factors) {
      const bool is_whole = factor.info(GiNaC::info_flags::integer);
      if (is_whole && GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(factor)) <= kMostTurns) continue;
      diagnostics.unsupported(
          joint.coupled->place,
          "joint \"" + joint.name + "\" turns by " + to_decimal(factor, 6) + " times the coordinate of \"" +
              robot.joints[static_cast<std::size_t>(owner)].name +
              "\": of joints that turn, only whole multiples up to 64 are supported yet",
          "let the joint that turns least have the coordinate, or hold this one: --fix " + joint.name);
    }
  }
}

std::vector<int> joints_with_coordinates(const Robot& robot) {
  std::vector<int> joints = moving_joints(robot);
  std::erase_if(joints, [&](int j) { return !has_own_coordinate(robot.joints[static_cast<std::size_t>(j)]); });
  return joints;
}

bool has_coupled_joints(const Robot& robot) {
  return std::any_of(robot.joints.begin(), robot.joints.end(),
                     [](const Joint& joint) { return joint.coupled && joint.type != JointType::fixed; });
}

LinearPosition position_of(const Robot& robot, int joint) {
  LinearPosition position = Follower(robot).position(joint);
  for (auto& [coordinate, factor] : position.factors) factor = rationalised(factor);
  return position;
}

Limits coordinate_limits(const Robot& robot, int owner) {
  Limits limits;
  for (const int joint : moving_joints(robot)) {
    const LinearPosition position = position_of(robot, joint);
    if (position.factors.size() != 1 || position.factors.begin()->first != owner) continue;
    const Joint& follower = robot.joints[static_cast<std::size_t>(joint)];
    tighten(follower.limits, position, limits);
    if (joint != owner || !follower.limits.effort) continue;
    const Number factor = position.factors.begin()->second;
    limits.effort = scaled(*follower.limits.effort, nearest_double(factor) < 0 ? Number(-factor) : factor);
  }
  return limits;
}

void check_coordinates(const Robot& robot, Diagnostics& diagnostics) {
  if (!has_coupled_joints(robot)) return;
  const std::vector<int> owners = joints_with_coordinates(robot);
  for (const int owner : owners) check_range(robot, owner, diagnostics);
  for (const int j : moving_joints(robot)) {
    const Joint& joint = robot.joints[static_cast<std::size_t>(j)];
    const Limits& limits = joint.limits;
    if (position_of(robot, j).factors.size() < 2) continue;
    if (!limits.lower && !limits.upper && !limits.velocity && !limits.acceleration) continue;
    diagnostics.note(joint.place,
                     "joint \"" + joint.name +
                         "\" follows several coordinates: its limits bound none of them alone, "
                         "and are not used",
                     "nothing to do, unless you rely on them");
  }
  if (independent_coordinates(robot, owners) == owners.size()) return;
  const auto coupled = std::find_if(owners.begin(), owners.end(), [&](int owner) {
    return robot.joints[static_cast<std::size_t>(owner)].coupled.has_value();
  });
  const Joint& joint = robot.joints[static_cast<std::size_t>(*coupled)];
  diagnostics.error(joint.coupled->place,
                    "the joints' positions do not tell their coordinates apart: some could move without any joint",
                    "let joint \"" + joint.name + "\" move by itself, or follow without naming itself");
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/coupling.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/diagnostics/nearest.hpp"
#include "robot/model/rational_rotation.hpp"

namespace flatdyn {

namespace {

bool has_own_coordinate(const Joint& joint) {
  return joint.type != JointType::fixed && (!joint.coupled || !vanishes(own_factor(joint.name, *joint.coupled)));
}

// Follows the names from joint to joint until it reaches coordinates, each joint once.
class CouplingResolver {
 public:
  struct UnknownLeader {
    int follower;
    const Reference* name;  // a name that no joint has
  };

  explicit CouplingResolver(const Robot& robot) : robot_(robot), known_(robot.joints.size()) {
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      joint_of_name_.emplace(robot.joints[j].name, static_cast<int>(j));
    }
  }

  const LinearPosition& position(int joint) {
    std::optional<LinearPosition>& known = known_[static_cast<std::size_t>(joint)];
    if (!known) known = found(joint);
    return *known;
  }

  const std::vector<UnknownLeader>& unknown_leaders() const { return unknown_leaders_; }
  const std::vector<std::vector<int>>& circles() const { return circles_; }  // cycles of joints that follow each other

 private:
  LinearPosition found(int joint) {
    const Joint& follower = robot_.joints[static_cast<std::size_t>(joint)];
    if (follower.type == JointType::fixed) return {{}, follower.held ? follower.held->position : Number(0)};
    if (!follower.coupled) return {{{joint, 1}}, 0};
    LinearPosition result{{}, follower.coupled->offset};
    path_.push_back(joint);
    for (const Coupled::Term& term : follower.coupled->terms) add(joint, term, result);
    path_.pop_back();
    std::erase_if(result.factors, [](const auto& factor) { return vanishes(factor.second); });
    for (auto& [coordinate, factor] : result.factors) factor = rationalised(factor);
    return result;
  }

  void add(int follower, const Coupled::Term& term, LinearPosition& result) {
    const auto leader = joint_of_name_.find(term.joint.name);
    if (leader == joint_of_name_.end()) {
      unknown_leaders_.push_back({follower, &term.joint});
      return;
    }
    if (has_own_coordinate(robot_.joints[static_cast<std::size_t>(leader->second)])) {
      result.factors[leader->second] += term.factor;
      return;
    }
    if (const auto before = std::find(path_.begin(), path_.end(), leader->second); before != path_.end()) {
      circles_.emplace_back(before, path_.end());
      return;
    }
    const LinearPosition& leading = position(leader->second);
    for (const auto& [joint, factor] : leading.factors) result.factors[joint] += term.factor * factor;
    result.offset += term.factor * leading.offset;
  }

  const Robot& robot_;
  std::map<std::string, int> joint_of_name_;
  std::vector<std::optional<LinearPosition>> known_;
  std::vector<int> path_;
  std::vector<UnknownLeader> unknown_leaders_;
  std::vector<std::vector<int>> circles_;
};

void report_unknown_leader(const Robot& robot, const CouplingResolver::UnknownLeader& unknown_leader,
                           Diagnostics& diagnostics) {
  const Joint& joint = robot.joints[static_cast<std::size_t>(unknown_leader.follower)];
  std::vector<std::string> known;
  for (const Joint& each : robot.joints) {
    if (!each.is_tendon) known.push_back(each.name);
  }
  const std::string what = joint.is_tendon ? "tendon \"" + joint.name + "\" runs over joint \""
                                           : "joint \"" + joint.name + "\" follows joint \"";
  diagnostics.error(joint.coupled->place, what + unknown_leader.name->name + "\", which does not exist",
                    hint_for_unknown(unknown_leader.name->name, known, "joints"));
}

void report_circle(const Robot& robot, const std::vector<int>& circle, Diagnostics& diagnostics) {
  const Joint& first = robot.joints[static_cast<std::size_t>(circle.front())];
  std::string names;
  for (const int each : circle) names += "\"" + robot.joints[static_cast<std::size_t>(each)].name + "\" -> ";
  diagnostics.error(first.coupled->place, "joints follow each other: " + names + "\"" + first.name + "\"",
                    "let one of them move by itself");
}

}  // namespace

Number own_factor(const std::string& joint, const Coupled& coupled) {
  Number sum = 0;
  for (const Coupled::Term& term : coupled.terms) sum += term.joint.name == joint ? term.factor : Number(0);
  return sum;
}

bool validate_couplings(const Robot& robot, Diagnostics& diagnostics) {
  CouplingResolver resolver(robot);
  for (std::size_t j = 0; j < robot.joints.size(); ++j) resolver.position(static_cast<int>(j));
  for (const CouplingResolver::UnknownLeader& unknown_leader : resolver.unknown_leaders())
    report_unknown_leader(robot, unknown_leader, diagnostics);
  for (const std::vector<int>& circle : resolver.circles()) report_circle(robot, circle, diagnostics);
  return resolver.unknown_leaders().empty() && resolver.circles().empty();
}

void refuse_factors(const Robot& robot, Diagnostics& diagnostics) {
  constexpr double kLargest = 1e30;  // as for numbers in files
  constexpr double kMostTurns = 1e6;
  const std::vector<LinearPosition> positions = joint_positions(robot);
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    if (!joint.coupled || joint.type == JointType::fixed) continue;
    const bool slides = joint.type == JointType::prismatic;
    for (const auto& [owner, factor] : positions[j].factors) {
      if (std::abs(nearest_double(factor)) <= (slides ? kLargest : kMostTurns)) continue;
      diagnostics.unsupported(joint.coupled->place,
                              "joint \"" + joint.name + "\" moves by " + to_decimal(factor, 6) +
                                  " times the coordinate of \"" + robot.joints[static_cast<std::size_t>(owner)].name +
                                  (slides ? "\": numbers go up to 1e30" : "\": joints turn by up to 1e6 times another"),
                              slides ? "check the factors" : "check the factors; angles are in rad");
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

std::vector<LinearPosition> joint_positions(const Robot& robot) {
  CouplingResolver resolver(robot);
  std::vector<LinearPosition> positions;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) positions.push_back(resolver.position(static_cast<int>(j)));
  return positions;
}

}  // namespace flatdyn

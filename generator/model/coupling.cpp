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

}  // namespace flatdyn

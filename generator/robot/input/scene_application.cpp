// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/scene_application.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/robot_builder.hpp"
#include "robot/input/common/units.hpp"
#include "robot/model/exact_sign.hpp"

namespace flatdyn {

namespace {

struct LimitMember {
  const char* name;
  std::optional<Value> Limits::*value;
  int outwards;     // the sign of a difference that allows more
  bool has_angles;  // of a joint that turns
};
constexpr std::array<LimitMember, 5> kLimitMembers = {{{"lower", &Limits::lower, -1, true},
                                                       {"upper", &Limits::upper, 1, true},
                                                       {"velocity", &Limits::velocity, 1, true},
                                                       {"acceleration", &Limits::acceleration, 1, true},
                                                       {"effort", &Limits::effort, 1, false}}};

// A limit of 0 says that nobody gave it.
bool is_wider(const Value& scene, const std::optional<Value>& robot, int outwards) {
  return robot && !vanishes(robot->number) && is_positive(outwards * (scene.number - robot->number));
}

void replace_limits(const SceneLimits& wanted, const Units& units, Joint& joint, Diagnostics& diagnostics) {
  const bool slides = (joint.held ? joint.held->type : joint.type) == JointType::prismatic;
  for (const LimitMember& member : kLimitMembers) {
    std::optional<Value> limit = wanted.limits.*(member.value);
    if (limit && member.has_angles && !slides) {
      const Spot spot{limit->place, fmt::format("limits, {}, {}", joint.name, member.name)};
      limit->number = in_radians(limit->number, units, spot, diagnostics);
    }
    std::optional<Value>& old = joint.limits.*(member.value);
    if (!limit) continue;
    if (is_wider(*limit, old, member.outwards)) {
      diagnostics.warning(limit->place,
                          fmt::format("limits, {}, {}: {} allows more than the robot's {}", joint.name, member.name,
                                      to_decimal(limit->number, 6), to_decimal(old->number, 6)),
                          "a scene's limits are for motions that stay within the robot's");
    }
    old = limit;
  }
}

// The joint that a table of the scene names; nullptr and an error if there is none.
Joint* joint_of_table(const std::string& table, const Reference& wanted, Diagnostics& diagnostics, Robot& robot) {
  Joint* found = joint_in(robot, wanted.name);
  if (found != nullptr || robot.joints.empty()) return found;  // the robot file could not be read: said there
  std::vector<std::string> known;
  for (const Joint& joint : robot.joints) known.push_back(joint.name);
  diagnostics.error(wanted.place, table + ": there is no joint \"" + wanted.name + "\"",
                    hint_for_unknown(wanted.name, known, "joints"));
  return nullptr;
}

}  // namespace

void add_scene(Scene file, Scene& scene) {
  const Scene first = scene;
  scene = std::move(file);
  if (first.gravity) scene.gravity = first.gravity;
  if (first.error_budget) scene.error_budget = first.error_budget;
  std::vector<JointPosition> locked = first.locked;
  for (const JointPosition& lock : scene.locked) {
    const bool is_said = std::any_of(locked.begin(), locked.end(),
                                     [&lock](const JointPosition& before) { return before.joint == lock.joint; });
    if (!is_said) locked.push_back(lock);
  }
  scene.locked = std::move(locked);
  std::vector<SceneFrame> frames = first.frames;
  for (const SceneFrame& frame : scene.frames) {
    const bool is_said = std::any_of(frames.begin(), frames.end(),
                                     [&frame](const SceneFrame& before) { return before.name == frame.name; });
    if (!is_said || frame.name.empty()) frames.push_back(frame);
  }
  scene.frames = std::move(frames);
}

// At rest its tanh would be that of a number, which proofs do not know from the one that is subtracted.
void refuse_offset_at_rest(const Joint& joint, Diagnostics& diagnostics) {
  const DryFrictionLaw& law = joint.law;
  if (!law.offset || !law.speed || has_symbols(law.offset->number) || has_symbols(law.speed->number)) return;
  diagnostics.unsupported(law.offset->place,
                          "joint \"" + joint.name + "\": coulomb_offset is not supported in a scene at rest",
                          "leave it out: at rest there is no friction, with and without it");
}

void apply_to_joints(const Scene& scene, Diagnostics& diagnostics, Robot& robot) {
  const Units units{scene.degrees, false, true};
  for (const SceneLimits& wanted : scene.limits) {
    Joint* joint = joint_of_table("limits", wanted.joint, diagnostics, robot);
    if (joint != nullptr) replace_limits(wanted, units, *joint, diagnostics);
  }
  for (const SceneGain& wanted : scene.gains) {
    Joint* joint = joint_of_table("current_to_torque", wanted.joint, diagnostics, robot);
    if (joint != nullptr) joint->current_to_torque = wanted.current_to_torque;
  }
  for (Joint& joint : robot.joints) {
    if (scene.friction && scene.at_rest) refuse_offset_at_rest(joint, diagnostics);
    if (!scene.friction) {
      joint.viscous.number = joint.coulomb.number = 0;
      joint.law = {};
    }
    if (!scene.springs) joint.stiffness.number = 0;
  }
  if (!scene.friction) robot.base_joint.viscous.number = robot.base_joint.coulomb.number = 0;
}

}  // namespace flatdyn

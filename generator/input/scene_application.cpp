// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/scene_application.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "diagnostics/nearest.hpp"
#include "model/exact_sign.hpp"

namespace flatdyn {

namespace {

struct LimitMember {
  const char* name;
  std::optional<Value> Limits::*value;
  int outwards;  // the sign of a difference that allows more
};
constexpr std::array<LimitMember, 5> kLimitMembers = {{{"lower", &Limits::lower, -1},
                                                       {"upper", &Limits::upper, 1},
                                                       {"velocity", &Limits::velocity, 1},
                                                       {"acceleration", &Limits::acceleration, 1},
                                                       {"effort", &Limits::effort, 1}}};

// A limit of 0 says that nobody gave it.
bool is_wider(const Value& scene, const std::optional<Value>& robot, int outwards) {
  return robot && !vanishes(robot->number) && is_positive(outwards * (scene.number - robot->number));
}

void replace_limits(const SceneLimits& wanted, Joint& joint, Diagnostics& diagnostics) {
  for (const LimitMember& member : kLimitMembers) {
    const std::optional<Value>& limit = wanted.limits.*(member.value);
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

void apply_limits(const SceneLimits& wanted, Diagnostics& diagnostics, Robot& robot) {
  std::vector<std::string> known;
  for (Joint& joint : robot.joints) {
    known.push_back(joint.name);
    if (joint.name == wanted.joint.name) return replace_limits(wanted, joint, diagnostics);
  }
  if (robot.joints.empty()) return;  // the robot file could not be read: said there
  diagnostics.error(wanted.joint.place, "limits: there is no joint \"" + wanted.joint.name + "\"",
                    hint_for_unknown(wanted.joint.name, known, "joints"));
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
}

void apply_to_joints(const Scene& scene, Diagnostics& diagnostics, Robot& robot) {
  for (const SceneLimits& wanted : scene.limits) apply_limits(wanted, diagnostics, robot);
  for (Joint& joint : robot.joints) {
    if (!scene.friction) joint.viscous.number = joint.coulomb.number = 0;
    if (!scene.springs) joint.stiffness.number = 0;
  }
  if (!scene.friction) robot.base_joint.viscous.number = robot.base_joint.coulomb.number = 0;
}

}  // namespace flatdyn

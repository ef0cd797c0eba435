// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/load/loaded_robot.hpp"

#include <fmt/format.h>

#include "functions/load/bad_input.hpp"

namespace flatdyn {

const Mechanism& effective_mechanism(const LoadedRobot& model) {
  return model.abbreviation ? model.abbreviation->mechanism : model.mechanism;
}

LoadedRobot without_scene_restrictions(LoadedRobot model) {
  Scene& scene = model.robot.scene;
  scene.at_rest = false;
  scene.functions.clear();
  scene.outputs.clear();
  scene.error_budget.reset();
  model.abbreviation.reset();
  return model;
}

void require_numbers(const Robot& robot, const std::string& what) {
  if (robot.symbols.empty()) return;
  throw Failure(FailureKind::unsupported,
                fmt::format("{}: the robot has free symbols ({}, ...): {} needs numbers", robot.file,
                            robot.symbols.front().name, what),
                "write numbers for its lengths and masses; rough masses and inertias do");
}

void refuse_loops(const LoadedRobot& model, const std::string& what) {
  if (!model.mechanism.has_loops()) return;
  throw Failure(FailureKind::unsupported, what + ": robots with closed loops are not supported yet",
                "inspect, generate, verify, stress, eval, simulate, torques, scale and identify know them; so do all "
                "commands where "
                "loops are parallelograms");
}

void refuse_spherical_joints(const LoadedRobot& model, const std::string& what) {
  for (const Joint& joint : model.robot.joints) {
    if (joint.type != JointType::spherical) continue;
    Diagnostics found;
    found.unsupported(
        joint.place,
        fmt::format("{}: spherical joints are not supported yet, and joint \"{}\" is one", what, joint.name),
        "all commands but torques and scale know them, bench without --gpu; eval has the torques of a motion that its "
        "columns say");
    throw BadInput(FailureKind::unsupported, std::move(found));
  }
}

void refuse_floating_base(const LoadedRobot& model, const std::string& what) {
  if (!model.mechanism.floating_base) return;
  Diagnostics found;
  found.unsupported(model.robot.links[static_cast<std::size_t>(model.robot.root)].place,
                    what + ": robots with a floating base are not supported yet",
                    "all commands but torques and scale know them; eval has the torques of a motion that its columns "
                    "say; "
                    "--base fixed holds the base still");
  throw BadInput(FailureKind::unsupported, std::move(found));
}

void refuse_springs(const LoadedRobot& model, const std::string& what, const std::string& remedy) {
  for (const Body& body : model.mechanism.bodies) {
    if (vanishes(body.stiffness)) continue;
    throw Failure(
        FailureKind::unsupported,
        fmt::format("{}: springs are not supported yet, and {} \"{}\" has one", what,
                    body.is_tendon ? "tendon" : "joint", body.joint),
        remedy + "a scene with springs = false leaves them out: measured torques must then be without theirs");
  }
}

}  // namespace flatdyn

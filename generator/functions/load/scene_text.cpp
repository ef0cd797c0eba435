// SPDX-License-Identifier: GPL-2.0-or-later
#include "functions/load/scene_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "derivation/dynamics/task_rows.hpp"
#include "derivation/notation/number_text.hpp"
#include "functions/scene/abbreviate.hpp"
#include "robot/model/field_mechanism.hpp"
#include "robot/model/rounded_up.hpp"

namespace flatdyn {
namespace {

std::vector<std::string> names_of(const std::vector<Reference>& references) {
  std::vector<std::string> names;
  for (const Reference& reference : references) names.push_back(reference.name);
  return names;
}

// The sentence for the header: "Left out for an error budget: I3xy, m7lx. Within the limits this changes …".
std::string abbreviation_fact(const Abbreviation& abbreviation) {
  if (abbreviation.dropped.empty()) return "The error budget allows to leave out nothing.";
  std::vector<std::string> bounds;
  for (const double bound : abbreviation.bound) bounds.push_back(fmt::format("{:.3g}", rounded_up(bound, 3)));
  const bool floats = abbreviation.mechanism.floating_base;
  return fmt::format(
      "Left out for an error budget, of the base parameters: {}. Within the limits of velocity and "
      "acceleration this changes {} by at most {} N m ({}).",
      fmt::join(names_of_dropped(abbreviation), ", "),
      floats ? "force and moment on the base, and the joints' torques," : "the joints' torques",
      fmt::join(bounds, ", "), floats ? "N for forces" : "N for prismatic joints");
}

class SceneText {
 public:
  explicit SceneText(const Mechanism& mechanism) : number_(mechanism, 17) {}

  std::vector<std::string> items(const Scene& scene) {
    degrees_ = scene.degrees;
    if (degrees_) add("angles", "deg");
    if (scene.gravity) add("gravity", list(*scene.gravity));
    for (const JointPosition& lock : scene.locked) add("locked." + lock.joint, position_text(lock));
    if (scene.payload) add_payload(*scene.payload);
    if (scene.at_rest) add("static", "true");
    if (!scene.friction) add("friction", "false");
    if (!scene.springs) add("springs", "false");
    add_task(scene.task);
    if (scene.error_budget) add("error_budget", scene.error_budget->written);
    for (const SceneLimits& limits : scene.limits) add_limits(limits);
    if (scene.base_limits) add_base_limits(*scene.base_limits);
    for (const SceneFrame& frame : scene.frames) add_frame(frame);
    for (const SceneContact& contact : scene.contacts) add_contact(contact);
    if (scene.contact_damping != 0) add("contact_damping", number_(to_number(scene.contact_damping)));
    if (!scene.functions.empty()) {
      add("functions", fmt::format("[{}]", fmt::join(names_of(scene.functions), ", ")));
    }
    for (const SceneOutputs& outputs : scene.outputs) {
      add("outputs." + outputs.function.name, fmt::format("[{}]", fmt::join(names_of(outputs.entries), ", ")));
    }
    return std::move(items_);
  }

 private:
  void add(const std::string& key, const std::string& value) { items_.push_back(key + " = " + value); }

  // Options give positions in rad even if the scene is in degrees.
  std::string position_text(const JointPosition& lock) const {
    const bool is_of_option = lock.place.file.empty() && !lock.in_degrees && !vanishes(lock.position);
    return lock.written + (degrees_ && is_of_option ? " (rad, m)" : "");
  }

  Number in_unit_of_angles(const Number& angle) const {
    constexpr int kHalfTurn = 180;
    return degrees_ ? Number((angle * kHalfTurn / GiNaC::Pi).expand()) : angle;
  }

  std::string list(const Vec3& v) const {
    return fmt::format("[{}, {}, {}]", number_(v[0]), number_(v[1]), number_(v[2]));
  }

  void add_task(const Task& task) {
    if (!task.empty()) add("task", fmt::format("[{}]", task_text(task.rows, task.orientation)));
    if (task.has_angles()) add("orientation", task.orientation == Orientation::zyz ? "zyz" : "rpy");
    if (task.is_damped()) add("damping", number_(GiNaC::numeric(task.damping.str().c_str())));
  }

  void add_payload(const ScenePayload& payload) {
    if (payload.link) add("payload.link", payload.link->name);
    const Inertial& body = payload.inertial;
    add("payload.mass", number_(body.mass.number));
    add("payload.com", list(body.centre_of_mass));
    const Mat3& I = body.tensor;
    const bool about_com = body.about == Inertial::About::centre_of_mass;
    add("payload.inertia", fmt::format("{{xx = {}, yy = {}, zz = {}, xy = {}, xz = {}, yz = {}}} about {}",
                                       number_(I[0][0]), number_(I[1][1]), number_(I[2][2]), number_(I[0][1]),
                                       number_(I[0][2]), number_(I[1][2]), about_com ? "com" : "origin"));
  }

  void add_frame(const SceneFrame& frame) {
    if (frame.place.file.empty()) return;  // of --frame
    add("frame." + frame.name,
        fmt::format("on link {} at {}, rpy {}", frame.link.name, list(frame.xyz), list(frame.rpy)));
  }

  void add_contact(const SceneContact& contact) {
    add("contact." + contact.name, fmt::format("{} of link {} at {}", contact.is_surface ? "surface" : "point",
                                               contact.link.name, list(contact.position)));
    if (!contact.friction) return;
    const std::string name = "contact." + contact.name + ".";
    add(name + "friction", number_(*contact.friction));
    if (contact.is_surface)
      add(name + "size", fmt::format("[{}, {}]", number_(contact.size[0]), number_(contact.size[1])));
    if (!contact.is_surface) add(name + "normal", contact.is_against_gravity ? "against gravity" : "z of the link");
  }

  void add_base_limits(const BaseLimits& limits) {
    const auto add_one = [&](const char* key, const std::optional<Value>& value) {
      if (value) add(std::string("base_limits.") + key, number_(value->number));
    };
    const auto add_angle = [&](const char* key, const std::optional<Value>& value) {
      if (value) add(std::string("base_limits.") + key, number_(in_unit_of_angles(value->number)));
    };
    add_one("displacement", limits.linear.upper);
    add_angle("turn", limits.angular.upper);
    add_one("linear_velocity", limits.linear.velocity);
    add_angle("angular_velocity", limits.angular.velocity);
    add_one("linear_acceleration", limits.linear.acceleration);
    add_angle("angular_acceleration", limits.angular.acceleration);
    add_one("force", limits.linear.effort);
    add_one("moment", limits.angular.effort);
  }

  void add_limits(const SceneLimits& limits) {
    const auto add_one = [&](const char* key, const std::optional<Value>& value) {
      if (value) add("limits." + limits.joint.name + "." + key, number_(value->number));
    };
    add_one("lower", limits.limits.lower);
    add_one("upper", limits.limits.upper);
    add_one("velocity", limits.limits.velocity);
    add_one("acceleration", limits.limits.acceleration);
    add_one("effort", limits.limits.effort);
  }

  NumberText number_;
  bool degrees_ = false;
  std::vector<std::string> items_;
};

}  // namespace

std::vector<std::string> scene_items(const LoadedRobot& model) {
  return SceneText(model.mechanism).items(model.robot.scene);
}

std::string scene_stamp(const LoadedRobot& model) {
  if (model.robot.scene.file.empty()) return "";
  return fmt::format("Scene: {}", fmt::join(scene_items(model), "; "));
}

std::string scene_facts(const LoadedRobot& model) {
  std::vector<std::string> facts;
  for (const Joint& joint : model.robot.joints) {
    if (!joint.held) continue;
    const char* unit = joint.held->type == JointType::prismatic ? "m" : "rad";
    facts.push_back(fmt::format("Joint \"{}\" is held at {} {}.", joint.name,
                                NumberText(model.mechanism, 17)(joint.held->position), unit));
  }
  const Scene& scene = model.robot.scene;
  if (scene.payload) facts.emplace_back("A payload is part of the link that carries it.");
  if (!scene.friction) facts.emplace_back("Friction is left out.");
  if (!scene.springs) facts.emplace_back("Springs are left out.");
  if (scene.at_rest) facts.emplace_back("The robot is at rest: functions hold where all joint velocities are 0.");
  if (model.abbreviation) facts.push_back(abbreviation_fact(*model.abbreviation));
  return fmt::format("{}", fmt::join(facts, " "));
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/urdf_actuators.hpp"

#include <map>
#include <string>
#include <vector>

namespace flatdyn {

namespace {

using tinyxml2::XMLElement;

// What is said about the rotor of one joint, wherever it is said.
struct Reflected {
  std::optional<Value> armature;
  std::optional<Value> rotor_inertia;
  std::optional<Value> gear_ratio;
  const XMLElement* reduction = nullptr;
  std::optional<Place> coupled;  // a transmission that ties this joint to others
};

using ReflectedByJoint = std::map<std::string, Reflected>;

std::vector<const XMLElement*> children_of(const XMLElement& parent, const char* name) {
  std::vector<const XMLElement*> children;
  for (const XMLElement* e = parent.FirstChildElement(name); e != nullptr; e = e->NextSiblingElement(name)) {
    children.push_back(e);
  }
  return children;
}

std::optional<Value> value_of_child(const XMLElement& parent, const char* name, const UrdfValues& values,
                                    const std::string& what) {
  const XMLElement* child = parent.FirstChildElement(name);
  if (child == nullptr) return std::nullopt;
  return values.required_number(*child, "value", what + ", " + name);
}

void read_drake_tags(const XMLElement& parent, const UrdfValues& values, const std::string& what,
                     Reflected& reflected) {
  if (auto inertia = value_of_child(parent, "drake:rotor_inertia", values, what)) reflected.rotor_inertia = inertia;
  if (auto ratio = value_of_child(parent, "drake:gear_ratio", values, what)) reflected.gear_ratio = ratio;
}

void read_joint(const XMLElement& element, const UrdfValues& values, ReflectedByJoint& all) {
  const char* name = element.Attribute("name");
  if (name == nullptr) return;  // said by the joint's reader
  Reflected& reflected = all[name];
  const std::string what = "joint \"" + std::string(name) + "\"";
  read_drake_tags(element, values, what, reflected);
  for (const XMLElement* actuator : children_of(element, "actuator")) {
    read_drake_tags(*actuator, values, what, reflected);
  }
  if (const XMLElement* dynamics = element.FirstChildElement("dynamics")) {
    reflected.armature = values.number(*dynamics, "armature", what + ", dynamics");
  }
}

// <mechanicalReduction> stands in the actuator, in the joint, or (older files) in the transmission itself.
const XMLElement* reduction_of(const XMLElement& transmission) {
  for (const char* holder : {"actuator", "joint"}) {
    for (const XMLElement* element : children_of(transmission, holder)) {
      if (const XMLElement* reduction = element->FirstChildElement("mechanicalReduction")) return reduction;
    }
  }
  return transmission.FirstChildElement("mechanicalReduction");
}

bool is_simple(const XMLElement& transmission) {
  if (children_of(transmission, "joint").size() != 1 || children_of(transmission, "actuator").size() > 1) return false;
  const XMLElement* element = transmission.FirstChildElement("type");
  const char* type = element != nullptr ? element->GetText() : transmission.Attribute("type");
  return type == nullptr || std::string_view(type).find("SimpleTransmission") != std::string_view::npos;
}

void read_transmission(const XMLElement& element, const UrdfValues& values, ReflectedByJoint& all) {
  const bool simple = is_simple(element);
  for (const XMLElement* joint : children_of(element, "joint")) {
    const char* name = joint->Attribute("name");
    if (name == nullptr) continue;
    Reflected& reflected = all[name];
    const std::string what = "transmission of joint \"" + std::string(name) + "\"";
    for (const XMLElement* actuator : children_of(element, "actuator")) {
      read_drake_tags(*actuator, values, what, reflected);
    }
    if (!simple) reflected.coupled = values.place(element);
    if (const XMLElement* reduction = reduction_of(element)) reflected.reduction = reduction;
  }
}

// A reduction counts only if there is a rotor inertia that it multiplies: only then it must be a number.
Number gear_ratio_of(const Reflected& reflected, const UrdfValues& values, const std::string& what) {
  if (reflected.gear_ratio) return reflected.gear_ratio->number;
  if (reflected.reduction == nullptr) return 1;
  return values.number_of_text(*reflected.reduction, what + ", mechanicalReduction");
}

// A gear alone moves nothing: people expect the motor's inertia to count, and it does only if it is given.
void note_idle_reduction(const Reflected& reflected, const UrdfValues& values, const std::string& what) {
  if (reflected.reduction == nullptr || reflected.reduction->GetText() == nullptr) return;
  const std::string ratio = reflected.reduction->GetText();
  if (ratio == "1" || ratio == "1.0") return;
  values.context().diagnostics.note(values.place(*reflected.reduction),
                                    what + ": mechanicalReduction " + ratio + " has no effect without a rotor inertia",
                                    "give one: <drake:rotor_inertia value=...>, or <dynamics armature=...>");
}

void set_armature(Joint& joint, const Reflected& reflected, const UrdfValues& values) {
  Diagnostics& diagnostics = values.context().diagnostics;
  const std::string what = "joint \"" + joint.name + "\"";
  if (reflected.armature) joint.armature = *reflected.armature;
  if (!reflected.rotor_inertia) {
    if (!reflected.armature) note_idle_reduction(reflected, values, what);
    return;
  }
  const Place& place = reflected.rotor_inertia->place;
  if (reflected.coupled) {
    diagnostics.unsupported(place,
                            what + " has a rotor inertia and a transmission that couples joints (line " +
                                std::to_string(reflected.coupled->line) + "): not supported yet",
                            "give each motor to one joint, or write the reflected inertia as <dynamics armature=...>");
    return;
  }
  if (reflected.armature) {
    diagnostics.error(place,
                      what + " has both a rotor inertia and an armature (line " +
                          std::to_string(reflected.armature->place.line) + "): they are the same thing twice",
                      "delete one of them; armature = gear_ratio^2 * rotor_inertia");
    return;
  }
  const Number ratio = gear_ratio_of(reflected, values, what);
  joint.armature = {ratio * ratio * reflected.rotor_inertia->number, place};
}

}  // namespace

void read_urdf_actuators(const XMLElement& root, const UrdfValues& values, Robot& robot) {
  ReflectedByJoint all;
  for (const XMLElement* element : children_of(root, "joint")) read_joint(*element, values, all);
  for (const XMLElement* element : children_of(root, "transmission")) read_transmission(*element, values, all);
  for (Joint& joint : robot.joints) {
    if (const auto found = all.find(joint.name); found != all.end()) {
      set_armature(joint, found->second, values);
    }
  }
}

}  // namespace flatdyn

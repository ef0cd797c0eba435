// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/urdf_actuators.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "diagnostics/nearest.hpp"

namespace flatdyn {

namespace {

using tinyxml2::XMLElement;

// What is said about the rotor of one joint, wherever it is said.
struct Reflected {
  std::optional<Value> armature;
  std::optional<Value> rotor_inertia;
  std::optional<Value> gear_ratio;
  std::vector<const XMLElement*> reductions;
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

// Two rotors may drive one joint, but then nobody knows whether they are two, or one that is written twice.
void set_once(std::optional<Value>& value, const std::optional<Value>& given, const char* tag, const std::string& joint,
              Diagnostics& diagnostics) {
  if (!given) return;
  if (value) {
    diagnostics.error(given->place,
                      "joint \"" + joint + "\" has two <" + tag + "> (the first is in line " +
                          std::to_string(value->place.line) + ")",
                      "keep one; of two rotors, write the sum of their inertias");
    return;
  }
  value = given;
}

void read_drake_tags(const XMLElement& parent, const UrdfValues& values, const std::string& what,
                     const std::string& joint, Reflected& reflected) {
  constexpr const char* kInertia = "drake:rotor_inertia";
  constexpr const char* kRatio = "drake:gear_ratio";
  Diagnostics& diagnostics = values.context().diagnostics;
  set_once(reflected.rotor_inertia, value_of_child(parent, kInertia, values, what), kInertia, joint, diagnostics);
  set_once(reflected.gear_ratio, value_of_child(parent, kRatio, values, what), kRatio, joint, diagnostics);
}

void read_joint(const XMLElement& element, const UrdfValues& values, ReflectedByJoint& all) {
  const char* name = element.Attribute("name");
  if (name == nullptr) return;  // said by the joint's reader
  Reflected& reflected = all[name];
  const std::string what = "joint \"" + std::string(name) + "\"";
  read_drake_tags(element, values, what, name, reflected);
  for (const XMLElement* actuator : children_of(element, "actuator")) {
    read_drake_tags(*actuator, values, what, name, reflected);
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
    if (!simple) reflected.coupled = values.place(element);
    for (const XMLElement* actuator : children_of(element, "actuator")) {
      // Each of several motors drives each of several joints: one of them shows that it is so.
      if (!simple && reflected.rotor_inertia) break;
      read_drake_tags(*actuator, values, what, name, reflected);
    }
    if (const XMLElement* reduction = reduction_of(element)) reflected.reductions.push_back(reduction);
  }
}

// A reduction counts only if there is a rotor inertia that it multiplies: only then it must be a number.
Number gear_ratio_of(const Reflected& reflected, const UrdfValues& values, const std::string& what) {
  if (reflected.gear_ratio) return reflected.gear_ratio->number;
  if (reflected.reductions.empty()) return 1;
  const XMLElement& reduction = *reflected.reductions.front();
  if (reflected.reductions.size() > 1) {
    values.context().diagnostics.error(values.place(*reflected.reductions[1]),
                                       what +
                                           " has a rotor inertia and two <mechanicalReduction> (the first is in line " +
                                           std::to_string(reduction.GetLineNum()) + ")",
                                       "say which one is the rotor's: <drake:gear_ratio value=...>");
  }
  return values.number_of_text(reduction, what + ", mechanicalReduction");
}

// A gear alone moves nothing: people expect the motor's inertia to count, and it does only if it is given.
void note_idle_reduction(const Reflected& reflected, const UrdfValues& values, const std::string& what) {
  if (reflected.reductions.empty() || reflected.reductions.back()->GetText() == nullptr) return;
  const std::string ratio = reflected.reductions.back()->GetText();
  if (ratio == "1" || ratio == "1.0") return;
  values.context().diagnostics.note(values.place(*reflected.reductions.back()),
                                    what + ": mechanicalReduction " + ratio + " has no effect without a rotor inertia",
                                    "give one: <drake:rotor_inertia value=...>, or <dynamics armature=...>",
                                    "gear ratios without a rotor inertia, which have no effect");
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
  values.context().rotor_joints.insert(joint.name);
}

void report_rotors_of_nobody(const ReflectedByJoint& all, const UrdfValues& values, const Robot& robot) {
  std::vector<std::string> known;
  for (const Joint& joint : robot.joints) known.push_back(joint.name);
  for (const auto& [name, reflected] : all) {
    if (!reflected.rotor_inertia || std::find(known.begin(), known.end(), name) != known.end()) continue;
    values.context().diagnostics.error(reflected.rotor_inertia->place,
                                       "there is no joint \"" + name + "\" for this rotor inertia",
                                       hint_for_unknown(name, known, "joints"));
  }
}

}  // namespace

void read_urdf_actuators(const XMLElement& root, const UrdfValues& values, Robot& robot) {
  ReflectedByJoint all;
  for (const XMLElement* element : children_of(root, "joint")) read_joint(*element, values, all);
  for (const XMLElement* element : children_of(root, "transmission")) read_transmission(*element, values, all);
  report_rotors_of_nobody(all, values, robot);
  for (Joint& joint : robot.joints) {
    if (const auto found = all.find(joint.name); found != all.end()) {
      set_armature(joint, found->second, values);
    }
  }
}

}  // namespace flatdyn

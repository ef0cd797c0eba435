// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/urdf/actuators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "diagnostics/nearest.hpp"
#include "input/urdf/children.hpp"

namespace flatdyn {

namespace {

using tinyxml2::XMLElement;

// What is said about the rotor of one joint, wherever it is said.
struct Reflected {
  std::optional<Value> armature;
  std::optional<Value> rotor_inertia;
  std::string tag;  // of the rotor inertia
  std::optional<Value> gear_ratio;
  std::vector<const XMLElement*> reductions;
  std::optional<Place> coupling;  // a transmission that ties this joint to others
  std::optional<Place> rotor_of_coupling;
};

using ReflectedByJoint = std::map<std::string, Reflected>;

// The names that programs have for the two numbers; Drake's have its namespace.
constexpr std::array<const char*, 3> kRotorInertias = {"drake:rotor_inertia", "rotor_inertia", "motorInertia"};
constexpr std::array<const char*, 2> kGearRatios = {"drake:gear_ratio", "gear_ratio"};

// Two rotors may drive one joint, but then nobody knows whether they are two, or one that is written twice.
void set_once(std::optional<Value>& value, const XMLElement& element, const UrdfValues& values, const std::string& what,
              const std::string& joint) {
  const std::string tag = element.Name();
  const Value given = values.required_number(element, "value", what + ", " + tag);
  if (value) {
    values.context().diagnostics.error(given.place,
                                       "joint \"" + joint + "\" has a second rotor, by <" + tag +
                                           "> (the first is in line " + std::to_string(value->place.line) + ")",
                                       "keep one; of two rotors, write the sum of their inertias");
    return;
  }
  value = given;
}

void read_rotor(const XMLElement& parent, const UrdfValues& values, const std::string& what, const std::string& joint,
                Reflected& reflected) {
  for (const char* tag : kRotorInertias) {
    const XMLElement* element = parent.FirstChildElement(tag);
    if (element == nullptr) continue;
    if (!reflected.rotor_inertia) reflected.tag = tag;
    set_once(reflected.rotor_inertia, *element, values, what, joint);
  }
  for (const char* tag : kGearRatios) {
    const XMLElement* element = parent.FirstChildElement(tag);
    if (element != nullptr) set_once(reflected.gear_ratio, *element, values, what, joint);
  }
}

// The first rotor inertia in an actuator, a joint or a transmission; nullptr if there is none.
const XMLElement* rotor_in(const XMLElement& holder) {
  for (const char* tag : kRotorInertias) {
    if (const XMLElement* element = holder.FirstChildElement(tag)) return element;
  }
  return nullptr;
}

void read_joint(const XMLElement& element, const UrdfValues& values, ReflectedByJoint& all) {
  const char* name = element.Attribute("name");
  if (name == nullptr) return;  // said by the joint's reader
  Reflected& reflected = all[name];
  const std::string what = "joint \"" + std::string(name) + "\"";
  read_rotor(element, values, what, name, reflected);
  for (const XMLElement* actuator : elements_in(element, "actuator")) {
    read_rotor(*actuator, values, what, name, reflected);
  }
  reflected.armature = values.dynamics(element, "armature", what);
}

using Elements = std::vector<const XMLElement*>;

// <mechanicalReduction> stands in the actuator, in the joint, or (older files) in the transmission itself.
Elements reductions_of(const XMLElement& transmission, const Elements& actuators) {
  Elements holders = actuators;
  for (const XMLElement* joint : elements_in(transmission, "joint")) holders.push_back(joint);
  holders.push_back(&transmission);
  Elements reductions;
  for (const XMLElement* holder : holders) {
    if (const XMLElement* reduction = holder->FirstChildElement("mechanicalReduction")) reductions.push_back(reduction);
  }
  return reductions;
}

bool is_simple(const XMLElement& transmission) {
  if (elements_in(transmission, "joint").size() != 1) return false;
  const XMLElement* element = transmission.FirstChildElement("type");
  const char* type = element != nullptr ? element->GetText() : transmission.Attribute("type");
  return type == nullptr || std::string_view(type).find("SimpleTransmission") != std::string_view::npos;
}

// Those that have a rotor, if any has one: the others' gears are none of it. Two are an error.
Elements actuators_of(const XMLElement& transmission, const std::string& joint, const UrdfValues& values) {
  const Elements all = elements_in(transmission, "actuator");
  Elements with_rotor;
  std::copy_if(all.begin(), all.end(), std::back_inserter(with_rotor),
               [](const XMLElement* actuator) { return rotor_in(*actuator) != nullptr; });
  if (with_rotor.empty()) return all;
  if (with_rotor.size() > 1) {
    values.context().diagnostics.error(
        values.place(*with_rotor[1]),
        "joint \"" + joint + "\" is driven by two actuators with a rotor each (the first is in line " +
            std::to_string(with_rotor[0]->GetLineNum()) + ")",
        "keep one, or write the sum of gear_ratio^2 * rotor_inertia of both as <dynamics armature=...>");
  }
  return {with_rotor.front()};
}

// Each of several motors drives each of several joints: one of them shows that it is so.
void read_coupling(const XMLElement& transmission, const UrdfValues& values, ReflectedByJoint& all) {
  const Elements joints = elements_in(transmission, "joint");
  Elements holders = elements_in(transmission, "actuator");
  holders.insert(holders.end(), joints.begin(), joints.end());
  holders.push_back(&transmission);
  const auto rotor =
      std::find_if(holders.begin(), holders.end(), [](const XMLElement* e) { return rotor_in(*e) != nullptr; });
  for (const XMLElement* joint : joints) {
    const char* name = joint->Attribute("name");
    if (name == nullptr) continue;
    Reflected& reflected = all[name];
    reflected.coupling = values.place(transmission);
    if (rotor != holders.end()) reflected.rotor_of_coupling = values.place(*rotor_in(**rotor));
  }
}

void read_transmission(const XMLElement& element, const UrdfValues& values, ReflectedByJoint& all) {
  if (!is_simple(element)) {
    read_coupling(element, values, all);
    return;
  }
  const XMLElement& joint = *element.FirstChildElement("joint");
  const char* name = joint.Attribute("name");
  if (name == nullptr) return;
  Reflected& reflected = all[name];
  const Elements actuators = actuators_of(element, name, values);
  Elements holders = actuators;
  holders.insert(holders.end(), {&joint, &element});
  for (const XMLElement* holder : holders) {
    read_rotor(*holder, values, "transmission of joint \"" + std::string(name) + "\"", name, reflected);
  }
  const Elements reductions = reductions_of(element, actuators);
  reflected.reductions.insert(reflected.reductions.end(), reductions.begin(), reductions.end());
}

// A reduction counts only if there is a rotor inertia that it multiplies: only then it must be a number.
Value gear_ratio_of(const Reflected& reflected, const UrdfValues& values, const std::string& what) {
  if (reflected.gear_ratio) return *reflected.gear_ratio;
  if (reflected.reductions.empty()) return {1, reflected.rotor_inertia->place};
  const XMLElement& first = *reflected.reductions.front();
  const Value ratio = values.required_number(first, "value", what + ", mechanicalReduction");
  for (const XMLElement* other : reflected.reductions) {
    const Value another = other == &first ? ratio : values.required_number(*other, "value", what);
    if (another.number.is_equal(ratio.number)) continue;
    values.context().diagnostics.error(another.place,
                                       what +
                                           " has a rotor inertia and two <mechanicalReduction> (the first is in line " +
                                           std::to_string(first.GetLineNum()) + ")",
                                       "say which one is the rotor's: <drake:gear_ratio value=...>");
  }
  return ratio;
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

std::optional<Place> place_of_rotor(const Reflected& reflected) {
  return reflected.rotor_inertia ? reflected.rotor_inertia->place : reflected.rotor_of_coupling;
}

void note_armature(const Joint& joint, const std::string& tag, Diagnostics& diagnostics) {
  if (joint.type == JointType::fixed) return;
  diagnostics.note(
      joint.armature.place,
      fmt::format("joint \"{}\": <{}> counts as armature, {:.6g} {}", joint.name, tag,
                  nearest_double(joint.armature.number), joint.type == JointType::prismatic ? "kg" : "kg m^2"),
      "armature = gear_ratio^2 * rotor_inertia", "rotor inertias counted as armature");
}

void set_armature(Joint& joint, const Reflected& reflected, const UrdfValues& values) {
  Diagnostics& diagnostics = values.context().diagnostics;
  const std::string what = "joint \"" + joint.name + "\"";
  if (reflected.armature) joint.armature = *reflected.armature;
  const std::optional<Place> rotor = place_of_rotor(reflected);
  if (!rotor) {
    if (!reflected.armature) note_idle_reduction(reflected, values, what);
    return;
  }
  if (reflected.coupling) {
    diagnostics.unsupported(*rotor,
                            what + " has a rotor inertia and a transmission that couples joints (line " +
                                std::to_string(reflected.coupling->line) + "): not supported yet",
                            "give each motor to one joint, or write the reflected inertia as <dynamics armature=...>");
    return;
  }
  if (reflected.armature) {
    diagnostics.error(*rotor,
                      what + " has both a rotor inertia and an armature (line " +
                          std::to_string(reflected.armature->place.line) + "): they are the same thing twice",
                      "delete one of them; armature = gear_ratio^2 * rotor_inertia");
    return;
  }
  const std::size_t before = diagnostics.all().size();
  const Value ratio = gear_ratio_of(reflected, values, what);
  if (diagnostics.all().size() > before) return;
  if (vanishes(ratio.number) && !vanishes(reflected.rotor_inertia->number)) {
    diagnostics.error(ratio.place, what + ": the gear ratio of its rotor is zero",
                      "it is motor speed / joint speed; 1 if direct");
    return;
  }
  joint.armature = {ratio.number * ratio.number * reflected.rotor_inertia->number, *rotor};
  values.context().rotor_joints.insert(joint.name);
  if (!has_namespace(reflected.tag)) note_armature(joint, reflected.tag, diagnostics);
}

void report_rotors_of_nobody(const ReflectedByJoint& all, const UrdfValues& values, const Robot& robot) {
  std::vector<std::string> known;
  for (const Joint& joint : robot.joints) known.push_back(joint.name);
  for (const auto& [name, reflected] : all) {
    const std::optional<Place> rotor = place_of_rotor(reflected);
    if (!rotor || std::find(known.begin(), known.end(), name) != known.end()) continue;
    values.context().diagnostics.error(*rotor, "there is no joint \"" + name + "\" for this rotor inertia",
                                       hint_for_unknown(name, known, "joints"));
  }
}

}  // namespace

void read_urdf_actuators(const XMLElement& root, const UrdfValues& values, Robot& robot) {
  ReflectedByJoint all;
  for (const XMLElement* element : elements_in(root, "joint")) read_joint(*element, values, all);
  for (const XMLElement* element : elements_in(root, "transmission")) read_transmission(*element, values, all);
  report_rotors_of_nobody(all, values, robot);
  for (Joint& joint : robot.joints) {
    if (const auto found = all.find(joint.name); found != all.end()) {
      set_armature(joint, found->second, values);
    }
  }
}

}  // namespace flatdyn

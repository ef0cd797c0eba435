// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/actuators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/spelling.hpp"
#include "robot/input/common/words.hpp"
#include "robot/input/urdf/children.hpp"

namespace flatdyn {

namespace {

// The numbers of the rotor of one joint, wherever they stand.
struct Reflected {
  std::optional<Value> armature;
  std::optional<Value> rotor_inertia;
  std::string tag;  // of the rotor inertia
  std::optional<Value> gear_ratio;
  std::vector<FileText> reductions;
  std::optional<Place> coupling;  // a transmission that ties this joint to others
  std::optional<Place> rotor_of_coupling;
};

using ReflectedByJoint = std::map<std::string, Reflected>;

// The names that programs have for the two numbers; Drake's have its namespace.
constexpr std::array<const char*, 3> kRotorInertias = {"drake:rotor_inertia", "rotor_inertia", "motorInertia"};
constexpr std::array<const char*, 2> kGearRatios = {"drake:gear_ratio", "gear_ratio"};
constexpr std::array<const char*, 3> kReductions = {"mechanicalReduction", "mechanical_reduction", "reduction"};

// The value of this name in an actuator, a joint or a transmission: of a child or, less usual, of an attribute.
std::optional<FileText> rotor_text(const FileNode& holder, const char* tag, const UrdfValues& values,
                                   const std::string& what) {
  const std::string where = what + ", " + tag;
  if (const FileNode* element = holder.child(tag)) {
    const std::optional<FileText> text = values.text(*element, "value", where);
    return text ? *text : FileText{"", {element->place, where}};
  }
  if (!holder.has(tag)) return std::nullopt;
  values.context().diagnostics.note(holder.place, where + " is read from the attribute of <" + holder.name + ">",
                                    std::string("write an element: <") + tag + ">...</" + tag + ">",
                                    "values read from unusual places");
  return FileText{holder.value(tag), {holder.place, where}};
}

// Two rotors may drive one joint, but then nobody knows whether they are two, or one that is written twice.
void set_once(std::optional<Value>& value, const FileText& text, const UrdfValues& values, const std::string& tag,
              const std::string& joint) {
  const Value given = value_in(text, values.context().diagnostics);
  if (value) {
    values.context().diagnostics.error(given.place,
                                       "joint \"" + joint + "\" has a second rotor, by <" + tag +
                                           "> (the first is in line " + std::to_string(value->place.line) + ")",
                                       "keep one; of two rotors, write the sum of their inertias");
    return;
  }
  value = given;
}

void read_rotor(const FileNode& parent, const UrdfValues& values, const std::string& what, const std::string& joint,
                Reflected& reflected) {
  for (const char* tag : kRotorInertias) {
    const std::optional<FileText> text = rotor_text(parent, tag, values, what);
    if (!text) continue;
    if (!reflected.rotor_inertia) reflected.tag = tag;
    set_once(reflected.rotor_inertia, *text, values, tag, joint);
  }
  for (const char* tag : kGearRatios) {
    const std::optional<FileText> text = rotor_text(parent, tag, values, what);
    if (text) set_once(reflected.gear_ratio, *text, values, tag, joint);
  }
}

void read_reductions(const FileNode& holder, const UrdfValues& values, const std::string& what, Reflected& reflected) {
  for (const char* tag : kReductions) {
    if (const std::optional<FileText> text = rotor_text(holder, tag, values, what))
      reflected.reductions.push_back(*text);
  }
}

// The first rotor inertia in an actuator, a joint or a transmission.
std::optional<Place> place_of_rotor_in(const FileNode& holder) {
  for (const char* tag : kRotorInertias) {
    if (const FileNode* element = holder.child(tag)) return element->place;
    if (holder.has(tag)) return holder.place;
  }
  return std::nullopt;
}

using Elements = std::vector<const FileNode*>;

void read_joint(const FileNode& element, const UrdfValues& values, ReflectedByJoint& all) {
  if (!element.has("name")) return;  // said by the joint's reader
  const std::string name = element.value("name");
  Reflected& reflected = all[name];
  const std::string what = "joint \"" + name + "\"";
  Elements holders = element.elements("actuator");
  holders.insert(holders.begin(), &element);
  for (const FileNode* holder : holders) {
    read_rotor(*holder, values, what, name, reflected);
    read_reductions(*holder, values, what, reflected);
  }
  reflected.armature = values.dynamics(element, "armature", what);
}

bool is_simple(const FileNode& transmission) {
  if (transmission.elements("joint").size() != 1) return false;
  const FileNode* element = transmission.child("type");
  if (element == nullptr) element = transmission.child("plugin");  // of ros2_control
  const std::string type = element != nullptr ? element->text : transmission.value("type");
  return type.empty() || type.find("SimpleTransmission") != std::string::npos;
}

// The actuators that have a rotor, if any has one: the gears of the others do not act on it. Two rotors are an error.
Elements actuators_of(const FileNode& transmission, const std::string& joint, const UrdfValues& values) {
  const Elements all = transmission.elements("actuator");
  Elements with_rotor;
  std::copy_if(all.begin(), all.end(), std::back_inserter(with_rotor),
               [&](const FileNode* actuator) { return place_of_rotor_in(*actuator).has_value(); });
  if (with_rotor.empty()) return all;
  if (with_rotor.size() > 1) {
    values.context().diagnostics.error(
        with_rotor[1]->place,
        "joint \"" + joint + "\" is driven by two actuators with a rotor each (the first is in line " +
            std::to_string(with_rotor[0]->place.line) + ")",
        "keep one, or write the sum of gear_ratio^2 * rotor_inertia of both as <dynamics armature=...>");
  }
  return {with_rotor.front()};
}

// The actuators, the joints, and the transmission itself.
Elements parts_of(const FileNode& transmission, Elements actuators) {
  const Elements joints = transmission.elements("joint");
  actuators.insert(actuators.end(), joints.begin(), joints.end());
  actuators.push_back(&transmission);
  return actuators;
}

std::optional<Place> first_rotor_of(const FileNode& transmission) {
  for (const FileNode* part : parts_of(transmission, transmission.elements("actuator"))) {
    if (const std::optional<Place> rotor = place_of_rotor_in(*part)) return rotor;
  }
  return std::nullopt;
}

// The name of the joint that a transmission drives, which stands in its text in some files; "" if there is none.
std::string name_of_driven(const FileNode& joint) {
  return joint.has("name") ? joint.value("name") : trimmed_text_of(joint);
}

// Each of several motors drives each of several joints: one of them shows that it is so.
void read_coupling(const FileNode& transmission, ReflectedByJoint& all) {
  const std::optional<Place> rotor = first_rotor_of(transmission);
  for (const FileNode* joint : transmission.elements("joint")) {
    Reflected& reflected = all[name_of_driven(*joint)];
    reflected.coupling = transmission.place;
    if (rotor) reflected.rotor_of_coupling = rotor;
  }
}

void refuse_rotor_of_no_joint(const FileNode& transmission, const UrdfValues& values) {
  const std::optional<Place> rotor = first_rotor_of(transmission);
  if (!rotor) return;
  values.context().diagnostics.error(*rotor, name_in_messages(transmission) + " has a rotor inertia and names no joint",
                                     "write <joint name=\"...\"/> in it");
}

void read_transmission(const FileNode& element, const UrdfValues& values, ReflectedByJoint& all) {
  const Elements joints = element.elements("joint");
  const bool is_nameless =
      std::any_of(joints.begin(), joints.end(), [](const FileNode* each) { return name_of_driven(*each).empty(); });
  if (joints.empty() || is_nameless) {
    refuse_rotor_of_no_joint(element, values);
    return;
  }
  if (!is_simple(element)) {
    read_coupling(element, all);
    return;
  }
  const std::string joint = name_of_driven(*joints.front()), what = "transmission of joint \"" + joint + "\"";
  Reflected& reflected = all[joint];
  for (const FileNode* part : parts_of(element, actuators_of(element, joint, values))) {
    read_rotor(*part, values, what, joint, reflected);
    read_reductions(*part, values, what, reflected);
  }
}

// A reduction counts only if there is a rotor inertia that it multiplies: only then it must be a number.
Value gear_ratio_of(const Reflected& reflected, const UrdfValues& values, const std::string& what) {
  if (reflected.gear_ratio) return *reflected.gear_ratio;
  if (reflected.reductions.empty()) return {1, reflected.rotor_inertia->place};
  Diagnostics& diagnostics = values.context().diagnostics;
  const FileText& first = reflected.reductions.front();
  const Value ratio = value_in(first, diagnostics);
  for (const FileText& other : reflected.reductions) {
    const Value another = &other == &first ? ratio : value_in(other, diagnostics);
    if (another.number.is_equal(ratio.number)) continue;
    diagnostics.error(another.place,
                      what + " has a rotor inertia and two <mechanicalReduction> (the first is in line " +
                          std::to_string(first.spot.place.line) + ")",
                      "say which one is the rotor's: <drake:gear_ratio value=...>");
  }
  return ratio;
}

// A gear alone moves nothing: people expect the motor's inertia to count, and it does only if it is given.
void note_idle_reduction(const Reflected& reflected, const UrdfValues& values, const std::string& what) {
  if (reflected.reductions.empty() || are_equivalent_texts(reflected.reductions.back().text, "1")) return;
  const FileText& ratio = reflected.reductions.back();
  values.context().diagnostics.note(
      ratio.spot.place, what + ": mechanicalReduction " + ratio.text + " has no effect without a rotor inertia",
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

std::vector<const FileNode*> urdf_transmissions(const FileNode& root) {
  Elements transmissions = root.elements("transmission");
  for (const FileNode* control : root.elements("ros2_control")) {
    const Elements more = control->elements("transmission");
    transmissions.insert(transmissions.end(), more.begin(), more.end());
  }
  return transmissions;
}

void read_urdf_actuators(const FileNode& root, const UrdfValues& values, Robot& robot) {
  ReflectedByJoint all;
  for (const FileNode* element : root.elements("joint")) read_joint(*element, values, all);
  for (const FileNode* element : urdf_transmissions(root)) read_transmission(*element, values, all);
  report_rotors_of_nobody(all, values, robot);
  for (Joint& joint : robot.joints) {
    if (const auto found = all.find(joint.name); found != all.end()) {
      set_armature(joint, found->second, values);
    }
  }
}

}  // namespace flatdyn

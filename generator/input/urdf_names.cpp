// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/urdf_names.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/nearest.hpp"

namespace flatdyn {

namespace {

using tinyxml2::XMLAttribute;
using tinyxml2::XMLElement;
using Names = std::vector<std::string>;

struct Attributes {
  Names read;
  Names of_others;  // other programs read them, and real files have them: left out, with a note
};

const std::map<std::string_view, Attributes> kAttributes = {
    {"origin", {{"xyz", "rpy", "quat_xyzw", "quat_wxyz"}, {}}},
    {"axis", {{"xyz"}, {}}},
    {"parent", {{"link"}, {}}},
    {"child", {{"link"}, {}}},
    {"mass", {{"value"}, {}}},
    {"inertia", {{"ixx", "iyy", "izz", "ixy", "ixz", "iyz"}, {}}},
    {"mimic", {{"joint", "multiplier", "offset"}, {}}},
    {"drake:mimic", {{"joint", "multiplier", "offset"}, {}}},
    {"limit", {{"lower", "upper", "velocity", "effort", "acceleration"}, {"deceleration", "jerk"}}},
    {"dynamics",
     {{"damping", "friction", "armature", "spring_stiffness", "spring_reference"},
      {"D", "K", "mu_coulomb", "mu_viscous"}}},
};

const Names kOfRobot = {"link",     "joint",      "transmission",    "loop",
                        "coupling", "constraint", "loop_constraint", "joint_constraint"};
const Names kOfLink = {"inertial"};
const Names kOfInertial = {"origin", "mass", "inertia"};
const Names kOfJoint = {"origin", "axis", "parent", "child", "limit", "dynamics", "mimic"};
const Names kOfActuator = {"drake:rotor_inertia", "drake:gear_ratio", "mechanicalReduction"};
const Names kOnceInJoint = {"drake:rotor_inertia", "drake:gear_ratio"};

bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool has_namespace(std::string_view name) { return name.find(':') != std::string_view::npos; }

std::string joined(const Names& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

class NameChecker {
 public:
  explicit NameChecker(const UrdfValues& values) : values_(values), diagnostics_(values.context().diagnostics) {}

  void check_robot(const XMLElement& root) {
    check_spelling(root, "robot", kOfRobot);
    for (const XMLElement* e = root.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
      const std::string_view name = e->Name();
      if (name == "link") check_link(*e);
      if (name == "joint") check_joint(*e);
      if (name == "transmission") check_transmission(*e);
    }
  }

 private:
  static std::string what(const XMLElement& element) {
    const char* name = element.Attribute("name");
    return std::string(element.Name()) + " \"" + (name == nullptr ? "" : name) + "\"";
  }

  void check_link(const XMLElement& element) {
    check_spelling(element, what(element), kOfLink);
    check_once(element, what(element), kOfLink);
    if (const XMLElement* inertial = element.FirstChildElement("inertial")) {
      check_children(*inertial, what(element) + ", inertial", kOfInertial);
    }
  }

  void check_joint(const XMLElement& element) {
    check_children(element, what(element), kOfJoint);
    check_once(element, what(element), kOnceInJoint);
  }

  void check_transmission(const XMLElement& element) {
    for (const XMLElement* e = element.FirstChildElement("actuator"); e != nullptr;
         e = e->NextSiblingElement("actuator"))
      check_once(*e, what(element) + ", actuator", kOfActuator);
  }

  // The children that are read, by their names: spelt right, there once, with attributes that are known.
  void check_children(const XMLElement& parent, const std::string& what, const Names& names) {
    check_spelling(parent, what, names);
    check_once(parent, what, names);
    for (const std::string& name : names) {
      const XMLElement* child = parent.FirstChildElement(name.c_str());
      if (child != nullptr) check_attributes(*child, what + ", " + name);
    }
  }

  void check_spelling(const XMLElement& parent, const std::string& what, const Names& names) {
    for (const XMLElement* e = parent.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
      const std::string_view name = e->Name();
      if (contains(names, name) || has_namespace(name)) continue;
      const std::string hint = hint_for_unknown(name, names, "elements");
      if (!hint.starts_with("did you mean")) continue;  // no misspelling: an element of some other program
      diagnostics_.error(values_.place(*e), what + ": unknown element <" + std::string(name) + ">", hint);
    }
  }

  void check_once(const XMLElement& parent, const std::string& what, const Names& names) {
    for (const std::string& name : names) {
      const XMLElement* first = parent.FirstChildElement(name.c_str());
      const XMLElement* second = first == nullptr ? nullptr : first->NextSiblingElement(name.c_str());
      if (second == nullptr) continue;
      diagnostics_.error(values_.place(*second), what + " has two <" + name + "> elements", "keep one");
    }
  }

  void check_attributes(const XMLElement& element, const std::string& what) {
    const auto found = kAttributes.find(element.Name());
    if (found == kAttributes.end()) return;
    const Attributes& known = found->second;
    Names left_out;
    for (const XMLAttribute* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
      const std::string_view name = a->Name();
      if (contains(known.read, name) || has_namespace(name)) continue;
      if (contains(known.of_others, name)) {
        left_out.emplace_back(name);
        continue;
      }
      diagnostics_.error(values_.place(element), what + ": unknown attribute \"" + std::string(name) + "\"",
                         hint_for_unknown(name, known.read, "attributes"));
    }
    // Said once per file: where there is one such joint, all are so.
    if (left_out.empty() || !noted_.insert(element.Name()).second) return;
    diagnostics_.note(values_.place(element), what + ": left out here and in all joints: " + joined(left_out),
                      "what is read: " + joined(known.read));
  }

  const UrdfValues& values_;
  Diagnostics& diagnostics_;
  std::set<std::string_view> noted_;
};

}  // namespace

void check_urdf_names(const XMLElement& root, const UrdfValues& values) { NameChecker(values).check_robot(root); }

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/urdf/names.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/nearest.hpp"
#include "input/urdf/unknown.hpp"

namespace flatdyn {

namespace {

using tinyxml2::XMLElement;
using Names = std::vector<std::string>;

const Names kOfRobot = {"link",     "joint",      "transmission",    "loop",
                        "coupling", "constraint", "loop_constraint", "joint_constraint"};
const Names kOfLink = {"inertial"};
const Names kOfInertial = {"origin", "mass", "inertia"};
const Names kOfEveryJoint = {"origin", "parent", "child"};
const Names kOfJoint = {"origin", "axis",     "parent",           "child",
                        "limit",  "dynamics", "joint_properties", "mimic"};  // of one that moves
const Names kOfRotor = {"drake:rotor_inertia", "drake:gear_ratio", "rotor_inertia",
                        "motorInertia",        "gear_ratio",       "mechanicalReduction"};

bool contains(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

class NameChecker {
 public:
  explicit NameChecker(const UrdfValues& values)
      : values_(values), diagnostics_(values.context().diagnostics), unknown_(values) {}

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
    unknown_.check_misplaced(element, what(element), kOfLink);
    if (const XMLElement* inertial = element.FirstChildElement("inertial")) {
      check_children(*inertial, what(element) + ", inertial", kOfInertial);
      unknown_.check_misplaced(*inertial, what(element) + ", inertial", kOfInertial);
    }
  }

  // Of a joint that does not move, what it would move by does not matter.
  void check_joint(const XMLElement& element) {
    const char* type = element.Attribute("type");
    const bool is_fixed = type != nullptr && std::string_view(type) == "fixed";
    check_children(element, what(element), is_fixed ? kOfEveryJoint : kOfJoint);
    if (is_fixed) return;
    unknown_.check_misplaced(element, what(element), kOfJoint);
    check_children(element, what(element), kOfRotor);
  }

  void check_transmission(const XMLElement& element) {
    for (const XMLElement* e = element.FirstChildElement("actuator"); e != nullptr;
         e = e->NextSiblingElement("actuator"))
      check_children(*e, what(element) + ", actuator", kOfRotor);
  }

  // The children that are read, by their names: spelt right, there once, with attributes that are known.
  void check_children(const XMLElement& parent, const std::string& what, const Names& names) {
    check_spelling(parent, what, names);
    check_once(parent, what, names);
    for (const std::string& name : names) {
      const XMLElement* child = parent.FirstChildElement(name.c_str());
      if (child != nullptr) unknown_.check(*child, what + ", " + name);
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

  const UrdfValues& values_;
  Diagnostics& diagnostics_;
  UnknownEntries unknown_;
};

}  // namespace

void check_urdf_names(const XMLElement& root, const UrdfValues& values) { NameChecker(values).check_robot(root); }

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/names.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/spelling.hpp"
#include "robot/input/common/words.hpp"
#include "robot/input/urdf/actuators.hpp"
#include "robot/input/urdf/children.hpp"
#include "robot/input/urdf/schema.hpp"
#include "robot/input/urdf/unknown.hpp"
#include "robot/input/urdf/unread.hpp"

namespace flatdyn {

namespace {

using Names = std::vector<std::string>;

const Names kOfJoint = {"origin", "axis", "parent", "child", "limit", "dynamics", "joint_properties", "mimic"};

const Names& names_of_rotor() {
  static const Names kNames = words_of(kUrdfRotorNames);
  return kNames;
}

bool is_reduction(std::string_view name) { return words_of_name(name).back() == "reduction"; }

// Whether an element or attribute is the inertia of a rotor.
bool holds_rotor(const FileNode& element) {
  const auto is_rotor = [](const std::string& name) {
    const std::vector<std::string> words = words_of_name(name);
    return words == Names{"rotor", "inertia"} || words == Names{"motor", "inertia"};
  };
  if (is_rotor(element.name)) return true;
  for (const FileAttribute& a : element.attributes) {
    if (is_rotor(a.name)) return true;
  }
  return std::any_of(element.children.begin(), element.children.end(), holds_rotor);
}

class NameChecker {
 public:
  explicit NameChecker(const UrdfValues& values)
      : values_(values),
        diagnostics_(values.context().diagnostics),
        unknown_(values.context().diagnostics),
        unread_(values) {}

  void check_robot(const FileNode& root) {
    has_rotor_ = holds_rotor(root);
    for (const FileNode& element : root.children) {
      const std::string& name = element.name;
      if (name == "link") check_link(element);
      if (name == "joint") check_joint(element);
    }
    unread_.check(root, "robot");
    for (const FileNode* transmission : urdf_transmissions(root)) check_transmission(*transmission);
  }

 private:
  static std::string what(const FileNode& element) { return element.name + " \"" + element.value("name") + "\""; }

  void check_link(const FileNode& element) {
    const std::string link = what(element);
    unread_.check(element, link);
    check_once(element, link, {"inertial"});
    unknown_.check_misplaced(element, link);
    for (const char* tag : {"visual", "collision"}) {
      for (const FileNode* shape : element.elements(tag)) unread_.check_bodies_in(*shape, link);
    }
    for (const FileNode* contact : element.elements("contact")) {
      if (const FileNode* scaling = contact->child("inertia_scaling")) unread_.note(*scaling, link);
    }
    const FileNode* inertial = element.child("inertial");
    if (inertial == nullptr) return;
    unread_.check(*inertial, link + ", inertial");
    check_values(*inertial, link + ", inertial", urdf_schema().find("inertial")->children.read());
    unknown_.check_misplaced(*inertial, link + ", inertial");
  }

  // For a joint that does not move, the numbers of its motion do not matter.
  void check_joint(const FileNode& element) {
    const std::string joint = what(element);
    if (element.value("type") == "fixed") {
      unread_.check_spelling(element, joint);
      check_values(element, joint, urdf_schema().find("joint", "fixed")->children.read());
      return;
    }
    const bool moves = !is_held(element.value("name"), values_.context());
    moves ? unread_.check(element, joint) : unread_.check_still(element, joint);
    check_values(element, joint, kOfJoint);
    check_values(element, joint, names_of_rotor());
    unknown_.check_misplaced(element, joint);
    check_attributes_of_rotor(element, joint);
    for (const FileNode* actuator : element.elements("actuator")) check_part(*actuator, joint + ", actuator");
  }

  void check_transmission(const FileNode& element) {
    unread_.check(element, what(element));
    check_attributes_of_rotor(element, what(element));
    check_values(element, what(element), names_of_rotor());
    for (const FileNode* actuator : element.elements("actuator")) check_part(*actuator, what(element) + ", actuator");
    for (const FileNode* joint : element.elements("joint")) check_part(*joint, what(element) + ", joint");
  }

  void check_part(const FileNode& part, const std::string& what) {
    unread_.check(part, what, "transmission");
    check_attributes_of_rotor(part, what);
    check_values(part, what, names_of_rotor());
  }

  // A number of a rotor may stand in an attribute, under the name that an element has.
  void check_attributes_of_rotor(const FileNode& part, const std::string& what) {
    for (const FileAttribute& a : part.attributes) {
      const std::string name = a.name;
      if (std::find(names_of_rotor().begin(), names_of_rotor().end(), name) != names_of_rotor().end()) continue;
      const std::string hint = hint_for_unknown(name, names_of_rotor(), "attributes");
      if (!is_rotor_name(name) && !hint.starts_with("did you mean")) continue;
      diagnostics_.error(part.place, what + ": unknown attribute \"" + name + "\"", hint);
    }
  }

  // The children that are read, by their names: there once, with attributes that are known.
  void check_values(const FileNode& parent, const std::string& what, const Names& names) {
    check_once(parent, what, names);
    for (const std::string& name : names) {
      const FileNode* child = parent.child(name);
      if (child != nullptr) unknown_.check(*child, what + ", " + name);
    }
  }

  void check_once(const FileNode& parent, const std::string& what, const Names& names) {
    for (const std::string& name : names) {
      // Without a rotor's inertia, gears are not read.
      if (has_rotor_ || !is_reduction(name)) refuse_second(parent, what, name, values_);
    }
  }

  const UrdfValues& values_;
  Diagnostics& diagnostics_;
  bool has_rotor_ = false;
  UnknownEntries unknown_;
  UnreadElements unread_;
};

}  // namespace

void check_urdf_names(const FileNode& root, const UrdfValues& values) { NameChecker(values).check_robot(root); }

}  // namespace flatdyn

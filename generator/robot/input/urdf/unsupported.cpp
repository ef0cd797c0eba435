// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/unsupported.hpp"

#include <algorithm>

#include "robot/input/common/spelling.hpp"
#include "robot/input/common/words.hpp"
#include "robot/input/urdf/children.hpp"

namespace flatdyn {

namespace {

constexpr const char* kJointHint = "supported joints: revolute, continuous, prismatic, fixed, in a tree";
constexpr const char* kConstraintHint = "supported: <loop> of type revolute or spherical, <coupling>, <mimic>";
constexpr const char* kForceHint = "delete it, or add its forces to what the generated code returns";
constexpr const char* kArmatureHint = "write the reflected inertia as <dynamics armature=\"...\"/> of the joint";

// The hint for a constraint or force element; nullptr for all other elements.
const char* hint_instead_of(std::string_view name) {
  if (!is_force_or_constraint_name(name)) return nullptr;
  if (name == "drake:joint") return kJointHint;
  return name.find("constraint") != std::string_view::npos ? kConstraintHint : kForceHint;
}

class Refuser {
 public:
  Refuser(const UrdfValues& values, const Robot& robot)
      : values_(values), diagnostics_(values.context().diagnostics), robot_(robot) {}

  void check(const FileNode& element) {
    const std::string& name = element.name;
    if (const char* hint = hint_instead_of(name)) {
      refuse_unsupported(element, "", hint, values_);
    } else if (name == "ros2_control") {
      for (const FileNode* joint : element.elements("joint")) check_controlled(*joint);
    }
  }

 private:
  // Parameters go to drivers, which may need gear ratios; an inertia there is one that the joint feels.
  void check_controlled(const FileNode& joint) {
    if (is_at_rest(robot_, joint.value("name"))) return;
    for (const FileNode& element : joint.children) {
      const std::string& tag = element.name;
      if (tag != "param" && is_dynamics_name(tag) && tag.find("mimic") == std::string_view::npos) {
        refuse_unsupported(element, " in <ros2_control>", "write it in the joint itself, or delete it", values_);
      }
    }
    for (const FileNode& parameter : joint.children) {
      const std::string name = parameter.value("name");
      if (name.empty() || parameter.name != "param" || is_zero_text(value_of(parameter))) continue;
      const std::vector<std::string> words = words_of_name(name);
      const auto has = [&words](const char* word) {
        return std::find(words.begin(), words.end(), word) != words.end();
      };
      if (has("inertia") || has("armature") || (has("rotor") && has("mass"))) {
        refuse_unsupported(parameter, " in <ros2_control>", kArmatureHint, values_);
      } else if (is_dynamics_name(name) && !has("mimic")) {
        diagnostics_.note(
            parameter.place,
            "ros2_control, " + name_in_messages(joint) + ": " + name_in_messages(parameter) + " is not read",
            "friction and armature of a joint are read from its <dynamics>",
            "parameters of ros2_control that are not read");
      }
    }
  }

  const UrdfValues& values_;
  Diagnostics& diagnostics_;
  const Robot& robot_;
};

}  // namespace

void refuse_unsupported(const FileNode& element, const std::string& where, const char* hint, const UrdfValues& values) {
  const std::string name = element.value("name");
  values.context().diagnostics.unsupported(
      element.place,
      "<" + element.name + (name.empty() ? "" : " name=\"" + name + "\"") + ">" + where + " is not supported yet",
      hint);
}

bool is_at_rest(const Robot& robot, const std::string& joint) {
  return std::any_of(robot.joints.begin(), robot.joints.end(),
                     [&](const Joint& each) { return each.name == joint && each.type == JointType::fixed; });
}

void refuse_unread_dynamics(const FileNode& root, const UrdfValues& values, const Robot& robot) {
  Refuser refuser(values, robot);
  for (const FileNode& element : root.children) refuser.check(element);
}

}  // namespace flatdyn

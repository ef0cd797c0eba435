// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/urdf/unsupported.hpp"

#include <algorithm>
#include <string_view>

namespace flatdyn {

namespace {

using tinyxml2::XMLElement;

constexpr const char* kJointHint = "supported joints: revolute, continuous, prismatic, fixed, in a tree";
constexpr const char* kLoopHint =
    "write it as <loop name=\"...\" type=\"revolute\"> with <predecessor link=\"...\">, <successor link=\"...\">, an "
    "<origin> "
    "in each, and <axis>";
constexpr const char* kConstraintHint = "supported: <loop> of type revolute or spherical, <coupling>, <mimic>";
constexpr const char* kForceHint = "delete it, or add its forces to what the generated code returns";

// What to do instead of a constraint or force element; nullptr for all other elements.
const char* hint_instead_of(std::string_view name) {
  const auto has = [name](std::string_view part) { return name.find(part) != std::string_view::npos; };
  if (name == "loop_joint") return kLoopHint;
  if (name == "force_element") return kForceHint;
  if (!name.starts_with("drake:")) return nullptr;
  if (name == "drake:joint") return kJointHint;
  if (has("constraint")) return kConstraintHint;
  return has("spring") || has("bushing") ? kForceHint : nullptr;
}

class Refuser {
 public:
  Refuser(const UrdfValues& values, const Robot& robot)
      : values_(values), diagnostics_(values.context().diagnostics), robot_(robot) {}

  void check(const XMLElement& element) {
    const std::string_view name = element.Name();
    if (const char* hint = hint_instead_of(name)) {
      refuse(element, "", hint);
    } else if (name == "joint") {
      check_spring(element);
    } else if (name == "gazebo") {
      check_gazebo(element);
    }
  }

 private:
  void refuse(const XMLElement& element, const std::string& where, const char* hint) {
    const char* name = element.Attribute("name");
    diagnostics_.unsupported(values_.place(element),
                             "<" + std::string(element.Name()) +
                                 (name == nullptr ? "" : " name=\"" + std::string(name) + "\"") + ">" + where +
                                 " is not supported yet",
                             hint);
  }

  // A spring at a joint that does not move does nothing.
  bool is_at_rest(const char* name) const {
    return name != nullptr && std::any_of(robot_.joints.begin(), robot_.joints.end(), [&](const Joint& joint) {
             return joint.name == name && joint.type == JointType::fixed;
           });
  }

  void refuse_spring(const Place& place, const std::string& what, const Number& stiffness) {
    if (vanishes(stiffness)) return;
    diagnostics_.unsupported(place, what + ": springs are not supported yet",
                             "delete it, or add its torque to what the generated code returns");
  }

  void check_spring(const XMLElement& joint) {
    const char* name = joint.Attribute("name");
    if (is_at_rest(name)) return;
    const std::string what = "joint \"" + std::string(name == nullptr ? "" : name) + "\"";
    for (const char* key : {"spring_stiffness", "stiffness"}) {
      if (const auto stiffness = values_.dynamics(joint, key, what)) {
        refuse_spring(stiffness->place, what + ", dynamics, " + key, stiffness->number);
      }
    }
  }

  // Joints there close chains that a URDF cannot say, and add links; springs stand there for lack of a place in URDF.
  void check_gazebo(const XMLElement& gazebo) {
    for (const XMLElement* e = gazebo.FirstChildElement("joint"); e != nullptr; e = e->NextSiblingElement("joint")) {
      const bool joins = e->FirstChildElement("parent") != nullptr || e->FirstChildElement("child") != nullptr;
      if (joins) refuse(*e, " in <gazebo>", kLoopHint);
    }
    const XMLElement* spring = gazebo.FirstChildElement("springStiffness");
    const char* joint = gazebo.Attribute("reference");
    if (spring == nullptr || is_at_rest(joint)) return;
    const std::string what = "gazebo \"" + std::string(joint == nullptr ? "" : joint) + "\", springStiffness";
    refuse_spring(values_.place(*spring), what, values_.number_of_text(*spring, what));
  }

  const UrdfValues& values_;
  Diagnostics& diagnostics_;
  const Robot& robot_;
};

}  // namespace

void refuse_unread_dynamics(const XMLElement& root, const UrdfValues& values, const Robot& robot) {
  Refuser refuser(values, robot);
  for (const XMLElement* e = root.FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) refuser.check(*e);
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/simulators.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/spelling.hpp"
#include "robot/input/common/words.hpp"
#include "robot/input/common/xml_elements.hpp"
#include "robot/input/urdf/children.hpp"
#include "robot/input/urdf/springs.hpp"
#include "robot/input/urdf/unsupported.hpp"

namespace flatdyn {

namespace {

using tinyxml2::XMLElement;

constexpr const char* kSimulatorHint =
    "gravity is given by --gravity or in TOML; damping, friction and armature in <dynamics>; masses in <inertial>";

template <std::size_t n>
bool is_one_of(std::string_view name, const std::array<std::string_view, n>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_false(const std::string& text) { return text == "0" || folded_name(text) == "false"; }

bool says_true(const std::string& text) { return text == "1" || folded_name(text) == "true"; }

std::string attribute_of(const XMLElement& element, const char* name) {
  return element.Attribute(name) == nullptr ? "" : element.Attribute(name);
}

class SimulatorChecker {
 public:
  SimulatorChecker(const UrdfValues& values, const Robot& robot)
      : values_(values), diagnostics_(values.context().diagnostics), robot_(robot) {}

  void check_gazebo(const XMLElement& gazebo) {
    const std::string reference = attribute_of(gazebo, "reference");
    const bool is_of_joint = std::any_of(robot_.joints.begin(), robot_.joints.end(),
                                         [&reference](const Joint& joint) { return joint.name == reference; });
    const std::string what = "gazebo" + (reference.empty() ? "" : " \"" + reference + "\"");
    const bool is_unknown = !reference.empty() && !is_of_joint;
    if (is_unknown) refuse_springs_of(reference, gazebo, what);
    check_parts(gazebo, what, is_at_rest(robot_, gazebo.Attribute("reference")), is_of_joint || is_unknown);
  }

  void check_mujoco(const XMLElement& mujoco) {
    for (const XMLElement* option : elements_in(mujoco, "option")) {
      const std::string gravity = attribute_of(*option, "gravity");
      if (!gravity.empty() && !are_equivalent_texts(gravity, "0 0 -9.81"))
        note(*option, "mujoco, option gravity", gravity);
    }
    for (const XMLElement* compiler : elements_in(mujoco, "compiler")) check_compiler(*compiler);
    for (const XMLElement* defaults : elements_in(mujoco, "default")) check_defaults(*defaults);
    for (const char* tag : {"worldbody", "tendon"}) {
      const XMLElement* element = mujoco.FirstChildElement(tag);
      if (element != nullptr && element->FirstChildElement() != nullptr)
        note(*element, "mujoco, " + named(*element), "");
    }
  }

 private:
  void refuse_spring(const XMLElement& element, const std::string& what, const std::string& value) {
    if (is_zero_text(value)) return;
    diagnostics_.unsupported(values_.place(element), what + ": springs are not read here",
                             "write <springStiffness> and <springReference> in <gazebo reference=\"JOINT\">");
  }

  // Refuses springs among the children of an element whose reference names no joint.
  void refuse_springs_of(const std::string& reference, const XMLElement& gazebo, const std::string& what) {
    std::vector<std::string> joints;
    for (const Joint& joint : robot_.joints) joints.push_back(joint.name);
    for (const XMLElement* part : elements_in(gazebo)) {
      if (spring_word_of(part->Name()) != SpringWord::stiffness || is_zero_text(value_of(*part))) continue;
      diagnostics_.error(values_.place(*part),
                         what + ", " + part->Name() + ": there is no joint \"" + reference + "\" for this spring",
                         hint_for_unknown(reference, joints, "joints"));
    }
  }

  void note(const XMLElement& element, const std::string& what, const std::string& value) {
    diagnostics_.note(values_.place(element), what + (value.empty() ? "" : " (" + value + ")") + " is not read",
                      kSimulatorHint, "settings of simulators that are not read");
  }

  // Elements about contact, sight or measurement, or that are read elsewhere, are left aside.
  // `reads_springs`: springs among the children are read by springs.hpp.
  void check_parts(const XMLElement& holder, const std::string& what, bool is_still, bool reads_springs = false) {
    static constexpr auto kAside = std::to_array<std::string_view>(
        {"plugin", "sensor", "visual", "collision", "surface", "material", "physics", "mimic"});
    for (const XMLElement* part : elements_in(holder)) {
      if (is_one_of(part->Name(), kAside)) continue;
      const SpringWord spring = spring_word_of(part->Name());
      if (spring == SpringWord::none) check_part(*part, what + ", " + part->Name(), is_still);
      if (spring == SpringWord::stiffness && !is_still && !reads_springs) {
        refuse_spring(*part, what + ", " + part->Name(), value_of(*part));
      }
    }
  }

  void check_part(const XMLElement& part, const std::string& what, bool is_still) {
    static constexpr auto kLoops = std::to_array<std::string_view>(
        {"loop", "loopjoint", "loopconstraint", "jointconstraint", "constraint", "coupling", "mimicjoint"});
    const std::string name = joined_name(part.Name());
    const bool joins = part.FirstChildElement("parent") != nullptr || part.FirstChildElement("child") != nullptr;
    const bool is_model = name == "mujoco" && part.FirstChildElement("equality") != nullptr;
    if ((name == "joint" && joins) || is_one_of(name, kLoops) || is_model) {
      refuse_unsupported(part, " in <gazebo>", kLoopHint, values_);
    } else if (name == "mujoco") {
      check_mujoco(part);
    } else if (part.FirstChildElement() == nullptr) {
      check_number(part, name, what, is_still);
    } else {
      check_parts(part, what, is_still);
    }
    if (name == "dynamics") check_dynamics(part, what, is_still);
  }

  void check_number(const XMLElement& part, const std::string& name, const std::string& what, bool is_still) {
    static constexpr auto kOfJoints =
        std::to_array<std::string_view>({"dampingfactor", "damping", "friction", "armature", "velocitydecay"});
    static constexpr auto kOfBodies =
        std::to_array<std::string_view>({"mass", "velocitydecay", "linear", "angular", "ixx", "iyy", "izz"});
    const std::string value = value_of(part);
    const bool turns_off = (name == "turngravityoff" && says_true(value)) || (name == "gravity" && is_false(value));
    const bool is_number = (!is_still && is_one_of(name, kOfJoints)) || is_one_of(name, kOfBodies);
    if (turns_off || (is_number && !is_zero_text(value))) note(part, what, value);
  }

  // Values as attributes, as URDF has them.
  void check_dynamics(const XMLElement& dynamics, const std::string& what, bool is_still) {
    if (is_still) return;
    for (const char* key : {"spring_stiffness", "stiffness"}) {
      if (dynamics.Attribute(key) != nullptr) refuse_spring(dynamics, what + ", " + key, attribute_of(dynamics, key));
    }
    for (const char* key : {"damping", "friction", "armature"}) {
      const std::string value = attribute_of(dynamics, key);
      if (!is_zero_text(value)) note(dynamics, what + ", " + key, value);
    }
  }

  void check_compiler(const XMLElement& compiler) {
    for (const char* key : {"settotalmass", "boundmass", "boundinertia"}) {
      const std::string value = attribute_of(compiler, key);
      if (!is_zero_text(value) && !value.starts_with('-'))
        note(compiler, std::string("mujoco, compiler ") + key, value);
    }
    for (const char* key : {"inertiafromgeom", "balanceinertia"}) {
      const std::string value = attribute_of(compiler, key);
      if (says_true(value)) note(compiler, std::string("mujoco, compiler ") + key, value);
    }
  }

  // Defaults of joints, also in classes within classes.
  void check_defaults(const XMLElement& defaults) {
    for (const XMLElement* joint : elements_in(defaults, "joint")) {
      for (const char* key : {"armature", "damping", "frictionloss", "stiffness"}) {
        const std::string value = attribute_of(*joint, key);
        if (!is_zero_text(value)) note(*joint, std::string("mujoco, default joint ") + key, value);
      }
    }
    for (const XMLElement* nested : elements_in(defaults, "default")) check_defaults(*nested);
  }

  const UrdfValues& values_;
  Diagnostics& diagnostics_;
  const Robot& robot_;
};

}  // namespace

void check_urdf_simulators(const XMLElement& root, const UrdfValues& values, const Robot& robot) {
  SimulatorChecker checker(values, robot);
  for (const XMLElement* gazebo : elements_in(root, "gazebo")) checker.check_gazebo(*gazebo);
  for (const XMLElement* mujoco : elements_in(root, "mujoco")) checker.check_mujoco(*mujoco);
}

}  // namespace flatdyn

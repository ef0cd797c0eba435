// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/simulators.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/spelling.hpp"
#include "robot/input/common/words.hpp"
#include "robot/input/urdf/children.hpp"
#include "robot/input/urdf/springs.hpp"
#include "robot/input/urdf/unsupported.hpp"

namespace flatdyn {

namespace {

constexpr const char* kSimulatorHint =
    "gravity is given by --gravity or in TOML; damping, friction and armature in <dynamics>; masses in <inertial>";

template <std::size_t n>
bool is_one_of(std::string_view name, const std::array<std::string_view, n>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_false(const std::string& text) { return text == "0" || folded_name(text) == "false"; }

bool says_true(const std::string& text) { return text == "1" || folded_name(text) == "true"; }

class SimulatorChecker {
 public:
  SimulatorChecker(const UrdfValues& values, const Robot& robot)
      : values_(values), diagnostics_(values.context().diagnostics), robot_(robot) {}

  void check_gazebo(const FileNode& gazebo) {
    const std::string reference = gazebo.value("reference");
    const bool is_of_joint = std::any_of(robot_.joints.begin(), robot_.joints.end(),
                                         [&reference](const Joint& joint) { return joint.name == reference; });
    const std::string what = "gazebo" + (reference.empty() ? "" : " \"" + reference + "\"");
    const bool is_unknown = !reference.empty() && !is_of_joint;
    if (is_unknown) refuse_springs_of(reference, gazebo, what);
    check_parts(gazebo, what, is_at_rest(robot_, reference), is_of_joint || is_unknown);
  }

  void check_mujoco(const FileNode& mujoco) {
    for (const FileNode* option : mujoco.elements("option")) {
      const std::string gravity = option->value("gravity");
      if (!gravity.empty() && !are_equivalent_texts(gravity, "0 0 -9.81"))
        note(*option, "mujoco, option gravity", gravity);
    }
    for (const FileNode* compiler : mujoco.elements("compiler")) check_compiler(*compiler);
    for (const FileNode* defaults : mujoco.elements("default")) check_defaults(*defaults);
    for (const char* tag : {"worldbody", "tendon"}) {
      const FileNode* element = mujoco.child(tag);
      if (element != nullptr && !element->children.empty()) note(*element, "mujoco, " + name_in_messages(*element), "");
    }
  }

 private:
  void refuse_spring(const FileNode& element, const std::string& what, const std::string& value) {
    if (is_zero_text(value)) return;
    diagnostics_.unsupported(element.place, what + ": springs are not read here",
                             "write <springStiffness> and <springReference> in <gazebo reference=\"JOINT\">");
  }

  // Refuses springs among the children of an element whose reference names no joint.
  void refuse_springs_of(const std::string& reference, const FileNode& gazebo, const std::string& what) {
    std::vector<std::string> joints;
    for (const Joint& joint : robot_.joints) joints.push_back(joint.name);
    for (const FileNode& part : gazebo.children) {
      if (spring_word_of(part.name) != SpringWord::stiffness || is_zero_text(value_of(part))) continue;
      diagnostics_.error(part.place,
                         what + ", " + part.name + ": there is no joint \"" + reference + "\" for this spring",
                         hint_for_unknown(reference, joints, "joints"));
    }
  }

  void note(const FileNode& element, const std::string& what, const std::string& value) {
    diagnostics_.note(element.place, what + (value.empty() ? "" : " (" + value + ")") + " is not read", kSimulatorHint,
                      "settings of simulators that are not read");
  }

  // Elements about contact, sight or measurement, or that are read elsewhere, are left aside.
  // `reads_springs`: springs among the children are read by springs.hpp.
  void check_parts(const FileNode& holder, const std::string& what, bool is_still, bool reads_springs = false) {
    static constexpr auto kAside = std::to_array<std::string_view>(
        {"plugin", "sensor", "visual", "collision", "surface", "material", "physics", "mimic"});
    for (const FileNode& part : holder.children) {
      if (is_one_of(part.name, kAside)) continue;
      const SpringWord spring = spring_word_of(part.name);
      if (spring == SpringWord::none) check_part(part, what + ", " + part.name, is_still);
      if (spring == SpringWord::stiffness && !is_still && !reads_springs) {
        refuse_spring(part, what + ", " + part.name, value_of(part));
      }
    }
  }

  void check_part(const FileNode& part, const std::string& what, bool is_still) {
    static constexpr auto kLoops = std::to_array<std::string_view>(
        {"loop", "loopjoint", "loopconstraint", "jointconstraint", "constraint", "coupling", "mimicjoint"});
    const std::string name = joined_name(part.name);
    const bool joins = part.child("parent") != nullptr || part.child("child") != nullptr;
    const bool is_model = name == "mujoco" && part.child("equality") != nullptr;
    if ((name == "joint" && joins) || is_one_of(name, kLoops) || is_model) {
      refuse_unsupported(part, " in <gazebo>", kLoopHint, values_);
    } else if (name == "mujoco") {
      check_mujoco(part);
    } else if (part.children.empty()) {
      check_number(part, name, what, is_still);
    } else {
      check_parts(part, what, is_still);
    }
    if (name == "dynamics") check_dynamics(part, what, is_still);
  }

  void check_number(const FileNode& part, const std::string& name, const std::string& what, bool is_still) {
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
  void check_dynamics(const FileNode& dynamics, const std::string& what, bool is_still) {
    if (is_still) return;
    for (const char* key : {"spring_stiffness", "stiffness"}) {
      if (dynamics.has(key)) refuse_spring(dynamics, what + ", " + key, dynamics.value(key));
    }
    for (const char* key : {"damping", "friction", "armature"}) {
      const std::string value = dynamics.value(key);
      if (!is_zero_text(value)) note(dynamics, what + ", " + key, value);
    }
  }

  void check_compiler(const FileNode& compiler) {
    for (const char* key : {"settotalmass", "boundmass", "boundinertia"}) {
      const std::string value = compiler.value(key);
      if (!is_zero_text(value) && !value.starts_with('-'))
        note(compiler, std::string("mujoco, compiler ") + key, value);
    }
    for (const char* key : {"inertiafromgeom", "balanceinertia"}) {
      const std::string value = compiler.value(key);
      if (says_true(value)) note(compiler, std::string("mujoco, compiler ") + key, value);
    }
  }

  // Defaults of joints, also in classes within classes.
  void check_defaults(const FileNode& defaults) {
    for (const FileNode* joint : defaults.elements("joint")) {
      for (const char* key : {"armature", "damping", "frictionloss", "stiffness"}) {
        const std::string value = joint->value(key);
        if (!is_zero_text(value)) note(*joint, std::string("mujoco, default joint ") + key, value);
      }
    }
    for (const FileNode* nested : defaults.elements("default")) check_defaults(*nested);
  }

  const UrdfValues& values_;
  Diagnostics& diagnostics_;
  const Robot& robot_;
};

}  // namespace

void check_urdf_simulators(const FileNode& root, const UrdfValues& values, const Robot& robot) {
  SimulatorChecker checker(values, robot);
  for (const FileNode* gazebo : root.elements("gazebo")) checker.check_gazebo(*gazebo);
  for (const FileNode* mujoco : root.elements("mujoco")) checker.check_mujoco(*mujoco);
}

}  // namespace flatdyn

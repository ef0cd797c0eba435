// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/unread.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "robot/input/common/spelling.hpp"
#include "robot/input/common/words.hpp"
#include "robot/input/urdf/schema.hpp"

namespace flatdyn {

namespace {

using NameList = std::vector<std::string>;

bool is_in_list(const NameList& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string tag_of(const FileNode& element) { return "<" + element.name + ">"; }

bool is_all_zero(const std::string& text) { return words_of(text).empty() || is_zero_text(text); }

// Whether there is nothing in an element but its name, or zeros.
bool is_nothing(const FileNode& element) {
  for (const FileAttribute& a : element.attributes) {
    if (!is_all_zero(a.text)) return false;
  }
  return is_all_zero(element.text) && std::all_of(element.children.begin(), element.children.end(), is_nothing);
}

// Elements by which programs other than URDF's say where a body or its centre of mass is.
const char* form_in_urdf(std::string_view name) {
  static const std::map<std::string, const char*, std::less<>> kForms = {
      {"pose", "write <origin xyz=\"...\" rpy=\"...\"/>"},
      {"com", "write <origin xyz=\"...\"/> in <inertial>"},
      {"cog", "write <origin xyz=\"...\"/> in <inertial>"},
      {"centerofmass", "write <origin xyz=\"...\"/> in <inertial>"},
      {"centreofmass", "write <origin xyz=\"...\"/> in <inertial>"},
      {"centerofgravity", "write <origin xyz=\"...\"/> in <inertial>"},
      {"centreofgravity", "write <origin xyz=\"...\"/> in <inertial>"}};
  const auto found = kForms.find(joined_name(name));
  return found == kForms.end() ? nullptr : found->second;
}

bool brings_in_files(std::string_view name) {
  const std::string folded = folded_name(name);
  return folded == "include" || folded == "import";
}

// A link or joint that is there already is named, not defined: <group><link name="arm"/></group>.
bool is_reference(const FileNode& element, const FileNode& robot) {
  if ((element.name != "link" && element.name != "joint") || !element.children.empty()) return false;
  if (!element.has("name")) return true;
  const std::vector<const FileNode*> all = robot.elements(element.name);
  return std::any_of(all.begin(), all.end(), [&element](const FileNode* each) {
    return each->has("name") && each->value("name") == element.value("name");
  });
}

// The first element below this one that would change the robot; nullptr if there is none.
const FileNode* body_below(const FileNode& element, const NameList& tags, const FileNode& robot) {
  for (const FileNode& child : element.children) {
    if (is_in_list(tags, child.name) && !is_reference(child, robot)) return &child;
    if (const FileNode* found = body_below(child, tags, robot)) return found;
  }
  return nullptr;
}

// How Gazebo's switches of a link stand where they change nothing.
std::optional<bool> usual_state(std::string_view name) {
  static const std::map<std::string, bool, std::less<>> kSwitches = {
      {"gravity", true}, {"kinematic", false}, {"turngravityoff", false}, {"static", false}};
  const auto found = kSwitches.find(joined_name(name));
  return found == kSwitches.end() ? std::nullopt : std::optional(found->second);
}

bool says(const std::string& text, bool state) {
  const std::string word = folded_name(single_word(text));
  return state ? word == "true" || word == "1" : word == "false" || word == "0";
}

}  // namespace

std::string parent_of_element(std::string_view name) {
  static const std::map<std::string, const char*, std::less<>> kHomes = {{"mass", "inertial"},
                                                                         {"inertia", "inertial"},
                                                                         {"inertial", "link"},
                                                                         {"axis", "joint"},
                                                                         {"limit", "joint"},
                                                                         {"dynamics", "joint"},
                                                                         {"joint_properties", "joint"},
                                                                         {"mimic", "joint"},
                                                                         {"parent", "joint"},
                                                                         {"child", "joint"},
                                                                         {"origin", "inertial> or <joint"},
                                                                         {"link", "robot"},
                                                                         {"joint", "robot"},
                                                                         {"transmission", "robot"},
                                                                         {"loop", "robot"},
                                                                         {"loop_joint", "robot"},
                                                                         {"coupling", "robot"},
                                                                         {"constraint", "robot"},
                                                                         {"loop_constraint", "robot"},
                                                                         {"joint_constraint", "robot"},
                                                                         {"rotor_inertia", "actuator"},
                                                                         {"motorInertia", "actuator"},
                                                                         {"gear_ratio", "actuator"},
                                                                         {"mechanicalReduction", "actuator"},
                                                                         {"actuator", "transmission"}};
  const auto found = kHomes.find(name);
  return found == kHomes.end() ? "" : found->second;
}

UnreadElements::UnreadElements(const UrdfValues& values)
    : UnknownNames(urdf_schema(), {"URDF", "docs/robot-format/urdf.md", false, true}, values.context().diagnostics),
      values_(values) {}

bool UnreadElements::says_nothing(const FileNode& element) const { return !moves_ || is_nothing(element); }

bool UnreadElements::refuse_words_of_sdf(const FileNode& element, const std::string& what) {
  const char* form = form_in_urdf(element.name);
  if (form == nullptr || is_nothing(element)) return false;
  diagnostics().error(element.place, what + ": " + tag_of(element) + " is not read from a URDF", form);
  return true;
}

bool UnreadElements::refuse_place(const FileNode& element, const std::string& what) {
  const std::string of_element = parent_of_element(element.name), of_value = element_of_value(element.name);
  const std::string& home = of_element.empty() && values_.holds_values(element) ? of_value : of_element;
  if (home.empty()) return false;
  if ((of_element.empty() || known_urdf_element(element.name) != nullptr) && is_nothing(element)) return true;
  diagnostics().error(element.place, what + ": " + tag_of(element) + " has no effect here",
                      "it is read from <" + home + ">: write it there, or delete it");
  return true;
}

bool UnreadElements::refuse_contents(const FileNode& element, const std::string& what) {
  static const NameList kBodies = {"link",  "joint", "inertial", "mass",       "inertia",       "dynamics",
                                   "mimic", "loop",  "coupling", "loop_joint", "rotor_inertia", "motorInertia"};
  const FileNode* body = body_below(element, kBodies, values_.root());
  if (body == nullptr) return false;
  diagnostics().error(body->place, what + ": <" + body->name + "> in " + tag_of(element) + " is not read",
                      "write it where URDF has it: links and joints stand directly in <robot>");
  return true;
}

// True of a switch of Gazebo in a link, whether or not it is refused.
bool UnreadElements::check_switch(const FileNode& element, const std::string& what) {
  const std::optional<bool> usual = usual_state(element.name);
  if (!usual || !values_.is_in(element, "link")) return false;
  const std::string text = value_of(element);
  if (says(text, *usual) || words_of(text).empty()) return true;
  const bool is_known = says(text, !*usual);
  const std::string said = what + ": " + tag_of(element) + " is \"" + single_word(text) + "\"";
  if (!is_known) {
    diagnostics().error(element.place, said + ", neither true nor false", "write 1 or 0, or delete it");
  } else if (joined_name(element.name).find("gravity") != std::string::npos) {
    diagnostics().unsupported(element.place, said + ": links on which gravity does not act are not supported",
                              "delete it; for robots whose weight is balanced, --gravity off leaves out all of it");
  } else {
    diagnostics().unsupported(element.place, said + ", so no force moves it", "delete it, or fix its joint");
  }
  return true;
}

bool UnreadElements::refuse_files(const FileNode& element, const std::string& what) {
  if (!brings_in_files(element.name)) return false;
  diagnostics().error(element.place, what + ": " + tag_of(element) + " is not read, nor the file that it names",
                      "put in the file that it names; xacro does that for <xacro:include>");
  return true;
}

// Forces and constraints are refused by unsupported.hpp.
bool UnreadElements::refuse_by_format(const FileNode& element, const std::string& what) {
  return (values_.is_in(element, "robot") && is_force_or_constraint_name(element.name)) ||
         check_switch(element, what) || refuse_files(element, what) || refuse_words_of_sdf(element, what) ||
         refuse_place(element, what) || (!is_refused_by_name(element) && refuse_contents(element, what));
}

void UnreadElements::check_still(const FileNode& element, const std::string& what) {
  moves_ = false;
  check(element, what);
  moves_ = true;
}

void UnreadElements::check_spelling(const FileNode& fixed_joint, const std::string& what) {
  const SchemaNames& names = schema().find("joint", "fixed")->children;
  for (const FileNode& child : fixed_joint.children) {
    if (names.know(child.name) || refuse_spelling(child, what, names)) continue;
    refuse_words_of_sdf(child, what);
  }
}

void UnreadElements::check_bodies_in(const FileNode& element, const std::string& what) {
  static const NameList kBodies = {"inertial", "mass", "inertia", "dynamics"};
  const FileNode* body = body_below(element, kBodies, values_.root());
  if (body == nullptr || is_nothing(*body)) return;
  diagnostics().error(body->place, what + ": <" + body->name + "> in " + tag_of(element) + " has no effect",
                      "write it in <" + parent_of_element(body->name) + ">, or delete it");
}

}  // namespace flatdyn

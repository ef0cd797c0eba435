// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/mimics.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/coupling.hpp"
#include "robot/input/common/references.hpp"
#include "robot/input/common/robot_builder.hpp"
#include "robot/input/common/spelling.hpp"
#include "robot/input/common/words.hpp"
#include "robot/input/urdf/children.hpp"

namespace flatdyn {

namespace {

constexpr const char* kMimicHint =
    "write <mimic joint=\"...\" multiplier=\"...\" offset=\"...\"/> in the joint that follows";

// One element says this of one follower.
struct MimicWords {
  std::string what;  // who says it
  Place place;
  std::string leader;
  std::optional<FileText> multiplier, offset;  // nullopt where they are left out
};

bool says_mimic(const std::string& text) { return folded_name(text).find("mimic") != std::string::npos; }

// By its name or file, or by what it has instead of <mimicJoint>: <mimic_joint>, <follow joint="...">.
bool is_called_mimic(const FileNode& plugin) {
  return says_mimic(plugin.value("name")) || says_mimic(plugin.value("filename")) ||
         std::any_of(plugin.children.begin(), plugin.children.end(), [](const FileNode& child) {
           const std::string name = joined_name(child.name);
           return name.find("mimic") != std::string::npos || (name.starts_with("follow") && child.has("joint"));
         });
}

const std::vector<std::string> kNumbersOfMimics = {"multiplier", "offset"};

// A name that may be meant for one of the numbers by which a joint follows: "multipler", "Offset", "ratio".
bool may_be_number_of_mimic(std::string_view name) {
  if (std::find(kNumbersOfMimics.begin(), kNumbersOfMimics.end(), name) != kNumbersOfMimics.end()) return false;
  const std::string joined = joined_name(name);
  for (const char* other : {"multiplier", "offset", "ratio", "gearratio", "factor", "scale", "gain", "coefficient"}) {
    if (joined == other) return true;
  }
  return hint_for_unknown(name, kNumbersOfMimics, "names").starts_with("did you mean");
}

class MimicReader {
 public:
  MimicReader(const std::set<std::string>& floating, const UrdfValues& values, Robot& robot)
      : floating_(floating), values_(values), diagnostics_(values.context().diagnostics), robot_(robot) {}

  void read(const FileNode& root) {
    std::size_t j = 0;
    for (const FileNode* joint : root.elements("joint")) read_joint(*joint, robot_.joints[j++]);
    for (const FileNode& element : root.children) {
      const std::string& name = element.name;
      if (name == "gazebo") read_gazebo(element);
      if (name == "plugin") read_plugin(element);
      if (name == "mujoco") read_mujoco(element);
    }
    for (const FileNode* control : root.elements("ros2_control")) {
      for (const FileNode* joint : control->elements("joint")) read_controlled(*joint);
    }
  }

 private:
  // Drake writes its own tag where other readers of the file are not to see the coupling.
  void read_joint(const FileNode& element, Joint& joint) {
    for (const char* tag : {"mimic", "drake:mimic"}) {
      const FileNode* mimic = element.child(tag);
      if (mimic == nullptr) continue;
      if (joint.type == JointType::fixed) {
        note_still(joint, {"joint \"" + joint.name + "\", " + tag, mimic->place, "", {}, {}});
        continue;
      }
      const std::string where = "joint \"" + joint.name + "\", " + tag;
      const std::string leader = values_.required_text(*mimic, "joint", where);
      if (!leader.empty())
        follow(joint, {where, mimic->place, leader, values_.text(*mimic, "multiplier", where),
                       values_.text(*mimic, "offset", where)});
    }
  }

  bool is_refused_as_floating(const std::string& joint, const MimicWords& words) {
    if (floating_.count(joint) == 0) return false;
    diagnostics_.unsupported(words.place, words.what + ": joint \"" + joint + "\" floats: it has no single position",
                             "name joints of one axis, or delete the mimic");
    return true;
  }

  // A joint that an option holds is one that is meant to stand still.
  void note_still(const Joint& joint, const MimicWords& words) {
    if (joint.held || is_refused_as_floating(joint.name, words)) return;
    diagnostics_.note(words.place, words.what + ": joint \"" + joint.name + "\" is fixed: it stays still",
                      "give it the type by which it moves, or delete the mimic", "mimics of joints that are fixed");
  }

  // The text of a child.
  std::optional<FileText> child(const FileNode& parent, const char* name, const std::string& where) const {
    const FileNode* element = parent.child(name);
    if (element == nullptr) return {};
    for (const FileNode* other : parent.elements(name)) check_same(*element, *other, where + ", " + name);
    refuse_other_attributes(*element, where + ", " + name, {}, values_);
    return FileText{element->text, {element->place, where + ", " + name}};
  }

  void check_same(const FileNode& first, const FileNode& other, const std::string& what) const {
    const std::string text = trimmed_text_of(first), another = trimmed_text_of(other);
    if (are_equivalent_texts(text, another)) return;
    diagnostics_.error(other.place, what + " is given twice, as " + text + " and as " + another,
                       "keep the one that is right");
  }

  std::optional<Number> number_of(const std::optional<FileText>& number, int if_left_out) {
    return number ? decimal_in(*number, diagnostics_) : Number(if_left_out);
  }

  void follow(Joint& joint, const MimicWords& words) {
    const std::optional<Number> factor = number_of(words.multiplier, 1);
    std::optional<Number> offset = number_of(words.offset, 0);
    if (!factor || !offset) return;
    if (joint.type != JointType::prismatic && words.offset) {
      offset = values_.angle_of(*offset, single_word(words.offset->text), words.offset->spot);
    }
    if (is_refused_as_floating(words.leader, words)) return;
    if (words.leader == joint.name) {
      diagnostics_.error(words.place, words.what + ": \"" + joint.name + "\" mimics itself",
                         "name the joint that it follows");
    } else if (vanishes(*factor)) {
      diagnostics_.error(words.place, words.what + ": \"" + joint.name + "\" mimics by a multiplier of 0",
                         "make it type=\"fixed\" if it does not move");
    } else {
      couple_joint(joint, {{{{words.leader, words.place}, *factor}}, *offset, words.place}, words.what, diagnostics_);
    }
  }

  // A follower that is named; those that do not move have nothing to follow by.
  void follow_by_name(const std::string& follower, const MimicWords& words) {
    const int j = joint_called(follower, words.place, words.what, robot_, diagnostics_);
    if (j < 0 || joint_called(words.leader, words.place, words.what, robot_, diagnostics_) < 0) return;
    Joint& joint = robot_.joints[static_cast<std::size_t>(j)];
    if (joint.type == JointType::fixed) {
      note_still(joint, words);
    } else {
      follow(joint, words);
    }
  }

  void read_gazebo(const FileNode& gazebo) {
    for (const FileNode* plugin : gazebo.elements("plugin")) read_plugin(*plugin);
    const FileNode* axis = gazebo.child("axis");
    const FileNode* mimic = axis != nullptr ? axis->child("mimic") : gazebo.child("mimic");
    if (mimic != nullptr) refuse_form(*mimic, "mimic in <gazebo>");
    for (const FileNode* model : gazebo.elements("model")) read_gazebo(*model);
  }

  void read_plugin(const FileNode& plugin) {
    const std::string what = name_in_messages(plugin) + " in <gazebo>";
    const std::vector<const FileNode*> followers = plugin.elements("mimicJoint");
    const FileNode* leader = plugin.child("joint");
    if (leader == nullptr) leader = plugin.child("jointName");
    if (followers.size() == 1 && followers[0]->children.empty() && leader != nullptr) {
      check_words_of_plugin(plugin, what);
      follow_by_name(trimmed_text_of(*followers[0]),
                     {what, followers[0]->place, trimmed_text_of(*leader), child(plugin, "multiplier", what),
                      child(plugin, "offset", what)});
    } else if (!followers.empty() || (is_called_mimic(plugin) && !plugin.children.empty())) {
      refuse_form(plugin, what);
    }
  }

  void check_words_of_plugin(const FileNode& plugin, const std::string& what) {
    for (const FileNode& child : plugin.children) {
      const std::string& name = child.name;
      if (may_be_number_of_mimic(name)) {
        diagnostics_.error(child.place, what + ": unknown element <" + name + ">",
                           hint_for_unknown(name, kNumbersOfMimics, "elements"));
      }
      if (name == "joint" || name == "jointName" || name == "mimicJoint") {
        refuse_other_attributes(child, what + ", " + name, {}, values_);
      }
    }
  }

  void refuse_form(const FileNode& element, const std::string& what) {
    diagnostics_.unsupported(element.place, what + ": it lets joints follow others in a form that is not known",
                             kMimicHint);
  }

  // <param name="mimic">leader</param>. The attribute `mimic` says whether <mimic> in the joint counts.
  void read_controlled(const FileNode& element) {
    const std::string follower = element.value("name");
    const std::string what = "ros2_control, joint \"" + follower + "\"";
    std::map<std::string, const FileNode*> parameters;
    for (const FileNode* parameter : element.elements("param")) {
      if (!parameter->has("name")) continue;
      const std::string name = parameter->value("name");
      const FileNode* first = parameters.emplace(name, parameter).first->second;
      if (is_word_of_mimic(name)) check_same(*first, *parameter, what + ", " + name);
    }
    check_parameters(parameters, what);
    for (const char* tag : {"mimic", "drake:mimic"}) {
      if (const FileNode* mimic = element.child(tag)) refuse_form(*mimic, what + ", <mimic>");
    }
    const auto number = [&](const char* name) {
      const auto found = parameters.find(name);
      return found == parameters.end() ? std::optional<FileText>()
                                       : FileText{found->second->text, {found->second->place, what + ", " + name}};
    };
    if (const auto mimic = parameters.find("mimic"); mimic != parameters.end()) {
      follow_by_name(follower, {what + ", mimic", mimic->second->place, trimmed_text_of(*mimic->second),
                                number("multiplier"), number("offset")});
    }
    note_mark(element, follower, what);
  }

  static bool is_word_of_mimic(std::string_view name) {
    return name == "mimic" || name == "multiplier" || name == "offset";
  }

  // Names that may be meant for those that are read; drivers have parameters called offset and ratio of their own.
  void check_parameters(const std::map<std::string, const FileNode*>& parameters, const std::string& what) {
    const bool mimics = parameters.contains("mimic");
    for (const auto& [name, parameter] : parameters) {
      if (is_word_of_mimic(name)) continue;
      const std::string hint = hint_for_unknown(name, {"mimic", "multiplier", "offset"}, "parameters");
      const bool is_mimic = joined_name(name).starts_with("mimic") || hint == "did you mean \"mimic\"?";
      if (!is_mimic && !(mimics && may_be_number_of_mimic(name))) continue;
      diagnostics_.error(parameter->place, what + ": unknown parameter \"" + name + "\"", hint);
    }
  }

  void note_mark(const FileNode& element, const std::string& follower, const std::string& what) {
    const std::string mark = element.value("mimic");
    const Joint* joint = joint_in(robot_, follower);
    if (mark.empty() || joint == nullptr || joint->type == JointType::fixed) return;
    if (mark == "true" && !joint->coupled) {
      diagnostics_.error(element.place, what + ": mimic=\"true\", and nothing says which joint it follows", kMimicHint);
    } else if (mark == "false" && joint->coupled) {
      diagnostics_.note(element.place,
                        what + ": mimic=\"false\" is left out: the joint follows \"" +
                            joint->coupled->terms.front().joint.name + "\"",
                        "delete what couples the joint if it moves by itself", "marks of ros2_control left out");
    }
  }

  void read_mujoco(const FileNode& mujoco) {
    for (const FileNode* equality : mujoco.elements("equality")) {
      for (const FileNode* joint : equality->elements("joint")) {
        if (joint->value("active") != "false") read_equality(*joint);
      }
    }
  }

  // joint1 = a0 + a1 joint2 + a2 joint2² + ..., of positions that are 0 where the model starts.
  void read_equality(const FileNode& element) {
    const std::string what = "mujoco, equality, " + name_in_messages(element);
    const Place place = element.place;
    refuse_other_attributes(element, what,
                            {"name", "class", "active", "joint1", "joint2", "polycoef", "solref", "solimp"}, values_);
    const std::string follower = values_.required_text(element, "joint1", what);
    if (!element.has("joint2")) {
      diagnostics_.unsupported(place, what + ": it holds \"" + follower + "\" still, which is not supported here",
                               "make the joint type=\"fixed\", or give the option --fix " + follower);
      return;
    }
    std::istringstream stream(element.value("polycoef"));
    std::vector<std::string> coefficients = {"0", "1"};
    std::string word;
    for (std::size_t k = 0; stream >> word; ++k) {
      if (k >= coefficients.size()) coefficients.emplace_back();
      coefficients[k] = word;
    }
    const Spot spot{place, what + ", polycoef"};
    for (std::size_t k = 2; k < coefficients.size(); ++k) {
      const std::optional<Number> higher = checked_decimal(coefficients[k], spot, diagnostics_);
      if (!higher) return;
      if (vanishes(*higher)) continue;
      diagnostics_.unsupported(
          place, what + ": polycoef is not linear: joints that follow others by a curve are not supported yet",
          "write polycoef=\"A B 0 0 0\", or leave it out and the joint as it is");
      return;
    }
    follow_by_name(follower, {what, place, element.value("joint2"), FileText{coefficients[1], spot},
                              FileText{coefficients[0], spot}});
  }

  const std::set<std::string>& floating_;
  const UrdfValues& values_;
  Diagnostics& diagnostics_;
  Robot& robot_;
};

}  // namespace

void read_urdf_mimics(const FileNode& root, const std::set<std::string>& floating, const UrdfValues& values,
                      Robot& robot) {
  MimicReader(floating, values, robot).read(root);
}

}  // namespace flatdyn

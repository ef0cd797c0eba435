// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/urdf/mimics.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/coupling.hpp"
#include "robot/input/common/references.hpp"
#include "robot/input/common/spelling.hpp"
#include "robot/input/common/words.hpp"
#include "robot/input/common/xml_elements.hpp"
#include "robot/input/urdf/children.hpp"

namespace flatdyn {

namespace {

using tinyxml2::XMLElement;

constexpr const char* kMimicHint =
    "write <mimic joint=\"...\" multiplier=\"...\" offset=\"...\"/> in the joint that follows";

// A number, and where it stands; no text where it is left out.
struct MimicNumber {
  std::optional<std::string> text;
  Spot spot;
};

// One element says this of one follower.
struct MimicWords {
  std::string what;  // who says it
  Place place;
  std::string leader;
  MimicNumber multiplier, offset;
};

bool says_mimic(const char* text) { return text != nullptr && folded_name(text).find("mimic") != std::string::npos; }

// By its name or file, or by what it has instead of <mimicJoint>: <mimic_joint>, <follow joint="...">.
bool is_called_mimic(const XMLElement& plugin) {
  const std::vector<const XMLElement*> children = elements_in(plugin);
  return says_mimic(plugin.Attribute("name")) || says_mimic(plugin.Attribute("filename")) ||
         std::any_of(children.begin(), children.end(), [](const XMLElement* child) {
           const std::string name = joined_name(child->Name());
           return name.find("mimic") != std::string::npos ||
                  (name.starts_with("follow") && child->Attribute("joint") != nullptr);
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

  void read(const XMLElement& root) {
    std::size_t j = 0;
    for (const XMLElement* joint : elements_in(root, "joint")) read_joint(*joint, robot_.joints[j++]);
    for (const XMLElement* element : elements_in(root)) {
      const std::string_view name = element->Name();
      if (name == "gazebo") read_gazebo(*element);
      if (name == "plugin") read_plugin(*element);
      if (name == "mujoco") read_mujoco(*element);
    }
    for (const XMLElement* control : elements_in(root, "ros2_control")) {
      for (const XMLElement* joint : elements_in(*control, "joint")) read_controlled(*joint);
    }
  }

 private:
  // Drake writes its own tag where other readers of the file are not to see the coupling.
  void read_joint(const XMLElement& element, Joint& joint) {
    for (const char* tag : {"mimic", "drake:mimic"}) {
      const XMLElement* mimic = element.FirstChildElement(tag);
      if (mimic == nullptr) continue;
      if (joint.type == JointType::fixed) {
        note_still(joint, {"joint \"" + joint.name + "\", " + tag, values_.place(*mimic), "", {}, {}});
        continue;
      }
      const std::string where = "joint \"" + joint.name + "\", " + tag;
      const std::string leader = values_.required_text(*mimic, "joint", where);
      if (!leader.empty())
        follow(joint, {where, values_.place(*mimic), leader, attribute(*mimic, "multiplier", where),
                       attribute(*mimic, "offset", where)});
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

  MimicNumber attribute(const XMLElement& element, const char* name, const std::string& where) const {
    const std::optional<UrdfText> written = values_.text(element, name, where);
    return written ? MimicNumber{written->text, written->spot} : MimicNumber{};
  }

  // The text of a child.
  MimicNumber child(const XMLElement& parent, const char* name, const std::string& where) const {
    const XMLElement* element = parent.FirstChildElement(name);
    if (element == nullptr) return {};
    for (const XMLElement* other : elements_in(parent, name)) check_same(*element, *other, where + ", " + name);
    refuse_other_attributes(*element, where + ", " + name, {}, values_);
    return {element->GetText() == nullptr ? "" : element->GetText(), {values_.place(*element), where + ", " + name}};
  }

  void check_same(const XMLElement& first, const XMLElement& other, const std::string& what) const {
    const std::string text = trimmed_text_of(first), another = trimmed_text_of(other);
    if (are_equivalent_texts(text, another)) return;
    diagnostics_.error(values_.place(other), what + " is given twice, as " + text + " and as " + another,
                       "keep the one that is right");
  }

  std::optional<Number> number_of(const MimicNumber& number, int if_left_out) {
    if (!number.text) return if_left_out;
    return checked_decimal(single_word(*number.text), number.spot, diagnostics_);
  }

  void follow(Joint& joint, const MimicWords& words) {
    const std::optional<Number> factor = number_of(words.multiplier, 1);
    std::optional<Number> offset = number_of(words.offset, 0);
    if (!factor || !offset) return;
    if (joint.type != JointType::prismatic && words.offset.text) {
      offset = values_.angle_of(*offset, single_word(*words.offset.text), words.offset.spot);
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

  void read_gazebo(const XMLElement& gazebo) {
    for (const XMLElement* plugin : elements_in(gazebo, "plugin")) read_plugin(*plugin);
    const XMLElement* axis = gazebo.FirstChildElement("axis");
    const XMLElement* mimic = axis != nullptr ? axis->FirstChildElement("mimic") : gazebo.FirstChildElement("mimic");
    if (mimic != nullptr) refuse_form(*mimic, "mimic in <gazebo>");
    for (const XMLElement* model : elements_in(gazebo, "model")) read_gazebo(*model);
  }

  void read_plugin(const XMLElement& plugin) {
    const std::string what = named(plugin) + " in <gazebo>";
    const std::vector<const XMLElement*> followers = elements_in(plugin, "mimicJoint");
    const XMLElement* leader = plugin.FirstChildElement("joint");
    if (leader == nullptr) leader = plugin.FirstChildElement("jointName");
    if (followers.size() == 1 && followers[0]->FirstChildElement() == nullptr && leader != nullptr) {
      check_words_of_plugin(plugin, what);
      follow_by_name(trimmed_text_of(*followers[0]),
                     {what, values_.place(*followers[0]), trimmed_text_of(*leader), child(plugin, "multiplier", what),
                      child(plugin, "offset", what)});
    } else if (!followers.empty() || (is_called_mimic(plugin) && plugin.FirstChildElement() != nullptr)) {
      refuse_form(plugin, what);
    }
  }

  void check_words_of_plugin(const XMLElement& plugin, const std::string& what) {
    for (const XMLElement* child : elements_in(plugin)) {
      const std::string name = child->Name();
      if (may_be_number_of_mimic(name)) {
        diagnostics_.error(values_.place(*child), what + ": unknown element <" + name + ">",
                           hint_for_unknown(name, kNumbersOfMimics, "elements"));
      }
      if (name == "joint" || name == "jointName" || name == "mimicJoint") {
        refuse_other_attributes(*child, what + ", " + name, {}, values_);
      }
    }
  }

  void refuse_form(const XMLElement& element, const std::string& what) {
    diagnostics_.unsupported(values_.place(element),
                             what + ": it lets joints follow others in a form that is not known", kMimicHint);
  }

  // <param name="mimic">leader</param>. The attribute `mimic` says whether <mimic> in the joint counts.
  void read_controlled(const XMLElement& element) {
    const std::string follower = element.Attribute("name") == nullptr ? "" : element.Attribute("name");
    const std::string what = "ros2_control, joint \"" + follower + "\"";
    std::map<std::string, const XMLElement*> parameters;
    for (const XMLElement* parameter : elements_in(element, "param")) {
      const char* name = parameter->Attribute("name");
      if (name == nullptr) continue;
      const XMLElement* first = parameters.emplace(name, parameter).first->second;
      if (is_word_of_mimic(name)) check_same(*first, *parameter, what + ", " + name);
    }
    check_parameters(parameters, what);
    for (const char* tag : {"mimic", "drake:mimic"}) {
      if (const XMLElement* mimic = element.FirstChildElement(tag)) refuse_form(*mimic, what + ", <mimic>");
    }
    const auto number = [&](const char* name) {
      const auto found = parameters.find(name);
      return found == parameters.end()
                 ? MimicNumber()
                 : MimicNumber{found->second->GetText() == nullptr ? "" : found->second->GetText(),
                               {values_.place(*found->second), what + ", " + name}};
    };
    if (const auto mimic = parameters.find("mimic"); mimic != parameters.end()) {
      follow_by_name(follower, {what + ", mimic", values_.place(*mimic->second), trimmed_text_of(*mimic->second),
                                number("multiplier"), number("offset")});
    }
    note_mark(element, follower, what);
  }

  static bool is_word_of_mimic(std::string_view name) {
    return name == "mimic" || name == "multiplier" || name == "offset";
  }

  // Names that may be meant for those that are read; drivers have parameters called offset and ratio of their own.
  void check_parameters(const std::map<std::string, const XMLElement*>& parameters, const std::string& what) {
    const bool mimics = parameters.contains("mimic");
    for (const auto& [name, parameter] : parameters) {
      if (is_word_of_mimic(name)) continue;
      const std::string hint = hint_for_unknown(name, {"mimic", "multiplier", "offset"}, "parameters");
      const bool is_mimic = joined_name(name).starts_with("mimic") || hint == "did you mean \"mimic\"?";
      if (!is_mimic && !(mimics && may_be_number_of_mimic(name))) continue;
      diagnostics_.error(values_.place(*parameter), what + ": unknown parameter \"" + name + "\"", hint);
    }
  }

  void note_mark(const XMLElement& element, const std::string& follower, const std::string& what) {
    const char* mark = element.Attribute("mimic");
    const auto joint = std::find_if(robot_.joints.begin(), robot_.joints.end(),
                                    [&follower](const Joint& each) { return each.name == follower; });
    if (mark == nullptr || joint == robot_.joints.end() || joint->type == JointType::fixed) return;
    if (std::string_view(mark) == "true" && !joint->coupled) {
      diagnostics_.error(values_.place(element), what + ": mimic=\"true\", and nothing says which joint it follows",
                         kMimicHint);
    } else if (std::string_view(mark) == "false" && joint->coupled) {
      diagnostics_.note(values_.place(element),
                        what + ": mimic=\"false\" is left out: the joint follows \"" +
                            joint->coupled->terms.front().joint.name + "\"",
                        "delete what couples the joint if it moves by itself", "marks of ros2_control left out");
    }
  }

  void read_mujoco(const XMLElement& mujoco) {
    for (const XMLElement* equality : elements_in(mujoco, "equality")) {
      for (const XMLElement* joint : elements_in(*equality, "joint")) {
        const char* active = joint->Attribute("active");
        if (active == nullptr || std::string_view(active) != "false") read_equality(*joint);
      }
    }
  }

  // joint1 = a0 + a1 joint2 + a2 joint2² + ..., of positions that are 0 where the model starts.
  void read_equality(const XMLElement& element) {
    const std::string what = "mujoco, equality, " + named(element);
    const Place place = values_.place(element);
    refuse_other_attributes(element, what,
                            {"name", "class", "active", "joint1", "joint2", "polycoef", "solref", "solimp"}, values_);
    const std::string follower = values_.required_text(element, "joint1", what);
    const char* leader = element.Attribute("joint2");
    if (leader == nullptr) {
      diagnostics_.unsupported(place, what + ": it holds \"" + follower + "\" still, which is not supported here",
                               "make the joint type=\"fixed\", or give the option --fix " + follower);
      return;
    }
    std::istringstream stream(element.Attribute("polycoef") == nullptr ? "" : element.Attribute("polycoef"));
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
    follow_by_name(follower, {what, place, leader, {coefficients[1].c_str(), spot}, {coefficients[0].c_str(), spot}});
  }

  const std::set<std::string>& floating_;
  const UrdfValues& values_;
  Diagnostics& diagnostics_;
  Robot& robot_;
};

}  // namespace

void read_urdf_mimics(const XMLElement& root, const std::set<std::string>& floating, const UrdfValues& values,
                      Robot& robot) {
  MimicReader(floating, values, robot).read(root);
}

}  // namespace flatdyn

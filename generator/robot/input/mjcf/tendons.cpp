// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/tendons.hpp"

#include <algorithm>

#include "robot/input/mjcf/joints.hpp"
#include "robot/input/mjcf/names.hpp"
#include "robot/model/tendon.hpp"

namespace flatdyn {

namespace {

class TendonReader {
 public:
  explicit TendonReader(MjcfModel& model) : model_(model), values_(model.values) {}

  void read() {
    for (const FileNode* section : model_.root.elements("tendon")) {
      for (const FileNode& element : section->children) read_tendon(element);
    }
    for (const FileNode* section : model_.root.elements("deformable")) {
      for (const FileNode* flex : section->elements("flex")) {
        refuse_mjcf(flex->place, name_in_messages(*flex) + ": what bends is not supported", "flex", values_);
      }
    }
  }

 private:
  void read_tendon(const FileNode& element) {
    MjcfItem item = values_.item(element, kMainClass, "tendon");
    item.what = "tendon" + (element.value("name").empty() ? "" : " \"" + element.value("name") + "\"");
    const std::string name = element.value("name");
    const bool is_second = std::any_of(model_.tendons.begin(), model_.tendons.end(), [&name](const MjcfTendon& each) {
      return !name.empty() && each.length.name == name;
    });
    if (is_second) {
      model_.diagnostics().error(element.place, "two tendons are called \"" + name + "\"", "give one another name");
    }
    MjcfTendon tendon;
    tendon.is_fixed = element.name == "fixed";
    tendon.what = item.what;
    tendon.length.name = element.value("name");
    tendon.length.place = element.place;
    if (tendon.is_fixed) {
      read_length(item, tendon);
      read_forces(item, tendon);
    } else {
      refuse_pull(item);
    }
    tell_of_range(item);
    model_.tendons.push_back(std::move(tendon));
  }

  void tell_of_range(const MjcfItem& item) {
    const bool is_limited = mjcf_is_limited(item, "range", "limited", values_, model_.settings) ||
                            mjcf_is_limited(item, "actuatorfrcrange", "actuatorfrclimited", values_, model_.settings);
    if (!is_limited) return;
    model_.diagnostics().note(item.element->place, item.what + ": its range is not read", "limits are read of joints",
                              "limits of tendons that are not read");
  }

  // Lengths of spatial tendons are not linear in the positions.
  void refuse_pull(const MjcfItem& item) {
    for (const char* key : {"stiffness", "damping", "frictionloss", "armature"}) {
      const auto found = values_.numbers(item, key, 1, 3);
      const bool pulls = found && !std::all_of(found->numbers.begin(), found->numbers.end(),
                                               [](const Number& x) { return vanishes(x); });
      if (!pulls) continue;
      refuse_mjcf(found->spot.place, item.what + ": " + key + " of a spatial tendon is not supported", "tendon",
                  values_);
      return;
    }
  }

  // L = Σ coef · q
  void read_length(const MjcfItem& item, MjcfTendon& tendon) {
    Coupled length;
    length.place = item.element->place;
    for (const FileNode& path : item.element->children) {
      const FileAttribute* name = path.attribute("joint");
      const auto coefficient = values_.number(MjcfValues::plain(path), "coef");
      if (name == nullptr || !coefficient) {
        model_.diagnostics().error(path.place, item.what + ": a <joint> without joint and coef",
                                   "write <joint joint=\"NAME\" coef=\"NUMBER\"/>");
        continue;
      }
      const Joint* joint = joint_in(model_.robot, name->text);
      if (joint == nullptr) {
        const auto& names = model_.names_of_joints;  // one of a type that is not supported has been spoken of
        if (std::find(names.begin(), names.end(), name->text) == names.end()) {
          report_missing_name(*name, item.what, "joint", joint_names(model_.robot), model_.diagnostics());
        }
      } else if (joint->type == JointType::fixed) {
        model_.diagnostics().unsupported(name->place, item.what + ": \"" + name->text + "\" is a free joint",
                                         "a fixed tendon runs over hinges and slides");
      } else if (joint->type == JointType::spherical) {
        model_.diagnostics().error(name->place, item.what + ": \"" + name->text + "\" is a ball joint",
                                   "a fixed tendon runs over hinges and slides");
      } else {
        length.terms.push_back({{name->text, path.place}, coefficient->number});
      }
    }
    tendon.length.coupled = length;
  }

  void read_forces(const MjcfItem& item, MjcfTendon& tendon) {
    Joint& length = tendon.length;
    length.stiffness = mjcf_linear(item, "stiffness", values_);
    length.viscous = mjcf_linear(item, "damping", values_);
    length.coulomb = values_.number_or(item, "frictionloss", 0);
    length.armature = values_.number_or(item, "armature", 0);
    if (!vanishes(length.stiffness.number)) length.spring_reference = length_at_rest(item, tendon);
  }

  // The length that is written; where it is -1 or missing, that with all joints at their springref.
  Value length_at_rest(const MjcfItem& item, const MjcfTendon& tendon) {
    const auto found = values_.numbers(item, "springlength", 1, 2);
    const Place place = found ? found->spot.place : item.element->place;
    if (found && !vanishes(found->numbers.back() - found->numbers.front())) {
      refuse_mjcf(place, item.what + ": a springlength of two numbers, between which nothing pulls, is not supported",
                  "tendon", values_);
    }
    if (found && !vanishes(found->numbers.front() + 1)) return {found->numbers.front(), place};
    Number rest = 0;
    for (const Coupled::Term& term : tendon.length.coupled->terms) {
      const auto relaxed = model_.relaxed.find(term.joint.name);
      if (relaxed != model_.relaxed.end()) rest += term.factor * relaxed->second;
    }
    return {rest, place};
  }

  MjcfModel& model_;
  const MjcfValues& values_;
};

// Whether each joint is on the path from the world to the farthest one.
bool are_on_one_path(const std::vector<Coupled::Term>& terms, const Robot& robot) {
  std::vector<const Joint*> joints;
  for (const Coupled::Term& term : terms) {
    const auto found = std::find_if(robot.joints.begin(), robot.joints.end(),
                                    [&term](const Joint& joint) { return joint.name == term.joint.name; });
    if (found != robot.joints.end()) joints.push_back(&*found);
  }
  const auto is_before = [&robot](const Joint* first, const Joint* last) {
    while (last != nullptr && last != first) {
      const auto parent = std::find_if(robot.joints.begin(), robot.joints.end(),
                                       [last](const Joint& joint) { return joint.child == last->parent; });
      last = parent == robot.joints.end() ? nullptr : &*parent;
    }
    return last == first;
  };
  return std::all_of(joints.begin(), joints.end(), [&](const Joint* a) {
    return std::all_of(joints.begin(), joints.end(),
                       [&](const Joint* b) { return is_before(a, b) || is_before(b, a); });
  });
}

// MuJoCo's inertia matrix has no entries for joints on different branches.
void tell_of_branches(const MjcfTendon& tendon, const MjcfModel& model) {
  const Joint& length = tendon.length;
  if (vanishes(length.armature.number) || are_on_one_path(length.coupled->terms, model.robot)) return;
  model.diagnostics().note(length.armature.place,
                           tendon.what + ": its armature couples joints on different branches, which MuJoCo leaves out",
                           "here B has a c c' with all entries, as the kinetic energy of the armature has",
                           "tendons whose armature couples joints on different branches");
}

std::vector<std::string> tendon_names(const MjcfModel& model) {
  std::vector<std::string> names;
  for (const MjcfTendon& tendon : model.tendons) names.push_back(tendon.length.name);
  return names;
}

}  // namespace

void read_mjcf_tendons(MjcfModel& model) { TendonReader(model).read(); }

MjcfTendon* mjcf_tendon(const FileAttribute& name, const std::string& what, MjcfModel& model) {
  const auto found = std::find_if(model.tendons.begin(), model.tendons.end(),
                                  [&name](const MjcfTendon& tendon) { return tendon.length.name == name.text; });
  if (found != model.tendons.end()) return &*found;
  // With --ignore tendon, what names one is left over.
  const auto& ignored = model.values.context().options.ignored;
  if (std::find(ignored.begin(), ignored.end(), "tendon") == ignored.end()) {
    report_missing_name(name, what, "tendon", tendon_names(model), model.diagnostics());
  }
  return nullptr;
}

void add_mjcf_tendons(const MjcfModel& model) {
  for (const MjcfTendon& tendon : model.tendons) {
    if (!tendon.is_fixed || tendon.length.coupled->terms.empty()) continue;
    tell_of_branches(tendon, model);
    Joint length = tendon.length;
    length.name = unused_name(length.name.empty() ? "tendon" : length.name, joint_names(model.robot));
    add_tendon(std::move(length), model.robot);
  }
}

}  // namespace flatdyn

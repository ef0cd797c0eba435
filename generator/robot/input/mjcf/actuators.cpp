// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/actuators.hpp"

#include <algorithm>

#include "robot/input/mjcf/joints.hpp"
#include "robot/input/mjcf/names.hpp"
#include "robot/input/mjcf/tendons.hpp"

namespace flatdyn {

namespace {

Number smaller(const Number& a, const Number& b) { return nearest_double(a - b) < 0 ? a : b; }

// The efforts of a joint's actuators; nullopt of one without a limit.
using Efforts = std::vector<std::optional<Value>>;

class ActuatorReader {
 public:
  explicit ActuatorReader(MjcfModel& model) : model_(model), values_(model.values) {}

  void read() {
    for (const FileNode* section : model_.root.elements("actuator")) {
      for (const FileNode& actuator : section->children) read_actuator(actuator);
    }
    for (const auto& [joint, efforts] : efforts_) limit(joint, efforts);
  }

 private:
  void read_actuator(const FileNode& actuator) {
    const MjcfItem item = values_.item(actuator, kMainClass, "actuator");
    if (refuse_muscle(item)) return;
    const FileAttribute* joint = actuator.attribute("joint");
    if (joint == nullptr) joint = actuator.attribute("jointinparent");
    if (joint == nullptr) {
      if (const FileAttribute* tendon = actuator.attribute("tendon")) {
        read_on_tendon(item, *tendon);
      } else {
        tell_of_transmission(item);
      }
      return;
    }
    Joint* moved = joint_in(model_.robot, joint->text);
    if (moved == nullptr) {
      report_unknown(*joint, item);
      return;
    }
    if (moved->type == JointType::fixed) {
      if (is_free(*moved)) read_on_free_joint(item, *moved);
      return;
    }
    if (moved->type == JointType::spherical) {
      if (refuse_reflected(item, "a ball joint")) return;
      model_.diagnostics().note(item.element->place, item.what + ": it acts on a ball joint: it is not read",
                                "forces of actuators are read where they act on a joint with one axis",
                                "actuators that act on ball joints");
      return;
    }
    const Number gear = gear_of(item);
    if (vanishes(gear)) {
      model_.diagnostics().note(item.element->place, item.what + ": its gear is 0: it does nothing", "write its gear",
                                "actuators with a gear of 0");
      return;
    }
    moved->driven = true;
    add_reflected(item, gear, *moved);
    efforts_[joint->text].push_back(effort_of(item, gear));
  }

  bool is_free(const Joint& joint) const {
    const auto index = static_cast<int>(&joint - model_.robot.joints.data());
    return std::any_of(model_.bodies.begin(), model_.bodies.end(), [index](const MjcfBody& body) {
      return std::find(body.free_joints.begin(), body.free_joints.end(), index) != body.free_joints.end();
    });
  }

  // As MuJoCo does, what it reflects is added to all six entries of the base.
  void read_on_free_joint(const MjcfItem& item, Joint& joint) {
    add_reflected(item, gear_of(item), joint);
    model_.diagnostics().note(item.element->place, item.what + ": it acts on a free joint: its force is not read",
                              "its armature and damping, if any, are added to the six entries of the base",
                              "actuators that act on free joints");
  }

  // A joint that is held or of a type that is not supported has been spoken of.
  void report_unknown(const FileAttribute& joint, const MjcfItem& item) {
    const auto& names = model_.names_of_joints;
    if (std::find(names.begin(), names.end(), joint.text) != names.end()) return;
    report_missing_name(joint, item.what, "joint", joint_names(model_.robot), model_.diagnostics());
  }

  bool refuse_muscle(const MjcfItem& item) {
    const bool is_muscle = item.element->name == "muscle" || values_.text(item, "dyntype") == "muscle" ||
                           values_.text(item, "gaintype") == "muscle" || values_.text(item, "biastype") == "muscle";
    if (is_muscle) {
      refuse_mjcf(item.element->place, item.what + ": muscles are not supported", item.element->name, values_);
    }
    return is_muscle;
  }

  // Its force drives all joints that the tendon runs over, and is no torque of one of them.
  void read_on_tendon(const MjcfItem& item, const FileAttribute& name) {
    MjcfTendon* tendon = mjcf_tendon(name, item.what, model_);
    if (tendon == nullptr) return;
    if (!tendon->is_fixed) {
      if (refuse_reflected(item, "a spatial tendon")) return;
    } else {
      add_reflected(item, gear_of(item), tendon->length);
      for (const Coupled::Term& term : tendon->length.coupled->terms) {
        joint_in(model_.robot, term.joint.name)->driven = true;
        efforts_[term.joint.name].push_back(std::nullopt);  // more than those of the joint's own actuators
      }
    }
    model_.diagnostics().note(item.element->place,
                              item.what + " acts through " + tendon->what + ": its force and its limits are not read",
                              "its torques at the joints are the force times the gear and the tendon's coefficients",
                              "actuators that act through tendons");
  }

  void tell_of_transmission(const MjcfItem& item) {
    for (const char* other : {"site", "body", "slidersite", "cranksite"}) {
      if (item.element->attribute(other) == nullptr) continue;
      model_.diagnostics().note(item.element->place, item.what + ": it acts at a " + other + ": it is not read",
                                "forces of actuators are read where they act on a joint",
                                "actuators that do not act on a joint");
      return;
    }
    if (!values_.context().options.ignored.empty()) return;
    model_.diagnostics().error(item.element->place, item.what + " drives nothing", "write joint=\"...\"");
  }

  // An armature or damping of an actuator on a ball joint would act about the axis of its gear only; on a spatial
  // tendon, along it.
  bool refuse_reflected(const MjcfItem& item, const std::string& moved) {
    for (const char* key : {"armature", "damping"}) {
      const auto given = values_.numbers(item, key, 1, 3);
      if (!given || std::all_of(given->numbers.begin(), given->numbers.end(), vanishes)) continue;
      refuse_mjcf(given->spot.place, given->spot.what + " of an actuator on " + moved + " is not supported", key,
                  values_);
      return true;
    }
    return false;
  }

  Number gear_of(const MjcfItem& item) const {
    const auto gears = values_.numbers(item, "gear", 1, 6);
    return gears ? gears->numbers[0] : Number(1);
  }

  // Motors turn `gear` times as fast as their joint.
  void add_reflected(const MjcfItem& item, const Number& gear, Joint& joint) {
    const Number squared = gear * gear;
    if (const auto armature = values_.number(item, "armature")) joint.armature.number += squared * armature->number;
    const auto damping = values_.numbers(item, "damping", 1, 3);
    if (!damping) return;
    joint.viscous.number += squared * damping->numbers[0];
    for (std::size_t k = 1; k < damping->numbers.size(); ++k) {
      if (vanishes(damping->numbers[k])) continue;
      refuse_mjcf(damping->spot.place, damping->spot.what + ": damping that is not linear is not supported", "damping",
                  values_);
      return;
    }
  }

  std::optional<Value> effort_of(const MjcfItem& item, const Number& gear) {
    std::optional<Value> force = mjcf_effort(item, "forcerange", "forcelimited", values_, model_.settings);
    if (item.element->name == "motor") {  // its force is its control signal
      const auto told = mjcf_effort(item, "ctrlrange", "ctrllimited", values_, model_.settings);
      if (told) force = force ? Value{smaller(force->number, told->number), told->place} : *told;
    }
    if (force) force->number *= magnitude(gear);
    return force;
  }

  // Actuators of one joint add up; one without a limit leaves the joint without.
  void limit(const std::string& name, const Efforts& efforts) {
    Joint& joint = *joint_in(model_.robot, name);
    if (std::any_of(efforts.begin(), efforts.end(), [](const std::optional<Value>& each) { return !each; })) return;
    Value whole{0, efforts.front()->place};
    for (const std::optional<Value>& each : efforts) whole.number += each->number;
    std::optional<Value>& effort = joint.limits.effort;
    if (!effort || nearest_double(whole.number - effort->number) < 0) effort = whole;
  }

  MjcfModel& model_;
  const MjcfValues& values_;
  std::map<std::string, Efforts> efforts_;
};

}  // namespace

void read_mjcf_actuators(MjcfModel& model) { ActuatorReader(model).read(); }

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/sdf/mimic_plugins.hpp"

#include "robot/input/common/coupling.hpp"
#include "robot/input/common/robot_builder.hpp"
#include "robot/input/common/spelling.hpp"
#include "robot/input/sdf/joint_axis.hpp"

namespace flatdyn {

namespace {

bool is_called_mimic(const FileNode& plugin, const char* attribute) {
  return folded_name(plugin.value(attribute)).find("mimic") != std::string::npos;
}

class MimicPluginReader {
 public:
  MimicPluginReader(const SdfTree& tree, Diagnostics& diagnostics, Robot& robot)
      : tree_(tree), diagnostics_(diagnostics), robot_(robot) {}

  void read() {
    for (const SdfFrame& frame : tree_.frames) {
      const bool is_model = frame.kind == SdfFrame::Kind::model && frame.element != nullptr && frame.own_scope >= 0;
      if (!is_model || tree_.scopes[static_cast<std::size_t>(frame.own_scope)].is_static) continue;
      for (const FileNode* plugin : frame.element->elements("plugin")) read_plugin(*plugin, frame);
    }
  }

 private:
  void read_plugin(const FileNode& plugin, const SdfFrame& model) {
    const std::string what = name_of(model) + ", " + name_in_messages(plugin);
    const auto followers = plugin.elements("mimicJoint"), leaders = plugin.elements("joint");
    if (followers.size() == 1 && leaders.size() == 1) {
      follow(plugin, model, what);
    } else if (!followers.empty() || is_called_mimic(plugin, "name") || is_called_mimic(plugin, "filename")) {
      diagnostics_.unsupported(plugin.place, what + ": it lets joints follow others in a form that is not known",
                               "write <mimic joint=\"...\"> in the axis of the joint that follows");
    }
  }

  void follow(const FileNode& plugin, const SdfFrame& model, const std::string& what) {
    const SdfFrame* follower = joint_named(plugin, "mimicJoint", model, what);
    const SdfFrame* leader = joint_named(plugin, "joint", model, what);
    if (follower == nullptr || leader == nullptr) return;
    const SdfValues& values = *model.values;
    const Place place = plugin.place;
    const Number factor = values.number(plugin, "multiplier", what).value_or(Value{1, place}).number;
    const Number offset = values.number(plugin, "offset", what).value_or(Value{0, place}).number;
    const std::string name = name_of_axis(*follower, "axis");
    Joint* joint = joint_in(robot_, name);
    if (joint == nullptr || joint->type == JointType::fixed) return;
    couple_joint(*joint, Coupled{{{{name_of_axis(*leader, "axis"), place}, factor}}, offset, place}, what,
                 diagnostics_);
  }

  // nullptr, and an error, if the model has none of this name.
  const SdfFrame* joint_named(const FileNode& plugin, const char* tag, const SdfFrame& model, const std::string& what) {
    const std::optional<Reference> name = model.values->name(plugin, tag, what);
    if (!name) return nullptr;
    const int found = find_sdf_frame(tree_, model.own_scope, *name, what + ", " + tag, diagnostics_);
    if (found < 0) return nullptr;
    const SdfFrame& joint = tree_.frames[static_cast<std::size_t>(found)];
    if (joint.kind == SdfFrame::Kind::joint) return &joint;
    diagnostics_.error(name->place, what + ", " + tag + ": " + name_of(joint) + " is no joint", "name a joint");
    return nullptr;
  }

  const SdfTree& tree_;
  Diagnostics& diagnostics_;
  Robot& robot_;
};

}  // namespace

void read_sdf_mimic_plugins(const SdfTree& tree, Diagnostics& diagnostics, Robot& robot) {
  MimicPluginReader(tree, diagnostics, robot).read();
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/mjcf/floating.hpp"

#include <algorithm>

#include "input/common/floating_joints.hpp"
#include "input/common/held_position.hpp"

namespace flatdyn {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

BaseJoint base_joint_of(const Joint& free) { return {free.armature, free.viscous, free.coulomb}; }

// Puts in the positions at which joints that are left out are held, where others follow them.
class LeftOutJoints {
 public:
  explicit LeftOutJoints(const MjcfModel& model)
      : model_(model), before_(model.robot.joints), held_(model.values.context().held_joints) {}

  void put_in() const {
    for (Joint& joint : model_.robot.joints) {
      if (joint.coupled) put_in(*joint.coupled);
    }
  }
  void put_in(Coupled& coupled) const {
    std::erase_if(coupled.terms, [&](const Coupled::Term& term) {
      if (joint_in(model_.robot, term.joint.name) != nullptr) return false;
      const auto joint = std::find_if(before_.begin(), before_.end(),
                                      [&term](const Joint& each) { return each.name == term.joint.name; });
      const auto held = std::find_if(held_.begin(), held_.end(),
                                     [&term](const HeldJoint& each) { return each.joint == term.joint.name; });
      if (joint == before_.end() || held == held_.end()) return false;
      coupled.offset += term.factor * held_position(*held, joint->type, model_.values.context());
      return true;
    });
  }

 private:
  const MjcfModel& model_;
  std::vector<Joint> before_;
  std::vector<HeldJoint> held_;
};

}  // namespace

void take_mjcf_free_joints(MjcfModel& model) {
  std::vector<int> joints;
  for (const MjcfBody& body : model.bodies) {
    joints.insert(joints.end(), body.free_joints.begin(), body.free_joints.end());
  }
  if (model.values.context().options.floating_base.value_or(true)) {
    const BaseJoint base = joints.size() == 1 ? base_joint_of(model.robot.joints[at(joints.front())]) : BaseJoint{};
    const LeftOutJoints left_out(model);
    take_floating_joints(joints, model.values.context(), model.robot);
    left_out.put_in();
    for (MjcfTendon& tendon : model.tendons) {
      if (tendon.length.coupled) left_out.put_in(*tendon.length.coupled);
    }
    if (model.robot.floating_base) model.robot.base_joint = base;
    return;
  }
  // Held still by --base fixed, they are fixed joints.
  for (std::size_t k = 0; joints.size() > 1 && k < joints.size(); ++k) {
    const Joint& joint = model.robot.joints[at(joints[k])];
    model.diagnostics().note(joint.place,
                             "joint \"" + joint.name + "\" moves freely, and is held still by --base fixed",
                             "all free joints are", "free joints that --base fixed holds");
  }
}

}  // namespace flatdyn

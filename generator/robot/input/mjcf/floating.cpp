// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/floating.hpp"

#include "robot/input/common/floating_joints.hpp"

namespace flatdyn {

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

BaseJoint base_joint_of(const Joint& free) { return {free.armature, free.viscous, free.coulomb}; }

}  // namespace

void take_mjcf_free_joints(MjcfModel& model) {
  std::vector<int> joints;
  for (const MjcfBody& body : model.bodies) {
    joints.insert(joints.end(), body.free_joints.begin(), body.free_joints.end());
  }
  if (model.values.context().options.floating_base.value_or(true)) {
    const BaseJoint base = joints.size() == 1 ? base_joint_of(model.robot.joints[at(joints.front())]) : BaseJoint{};
    ReadContext& context = model.values.context();
    const std::vector<LeftOutJoint> left_out = take_floating_joints(joints, context, model.robot);
    for (MjcfTendon& tendon : model.tendons) {
      if (tendon.length.coupled) put_in_left_out(left_out, context, *tendon.length.coupled);
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

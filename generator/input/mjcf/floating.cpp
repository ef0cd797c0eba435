// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/mjcf/floating.hpp"

#include "input/urdf/floating.hpp"

namespace flatdyn {

void take_mjcf_free_joints(MjcfModel& model) {
  std::vector<int> joints;
  for (const MjcfBody& body : model.bodies) {
    joints.insert(joints.end(), body.free_joints.begin(), body.free_joints.end());
  }
  // Held still by --base fixed, they are fixed joints.
  if (model.values.context().options.floating_base.value_or(true))
    take_floating_joints(joints, model.diagnostics(), model.robot);
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/assembly.hpp"

#include <algorithm>

#include "base/diagnostics/nearest.hpp"

namespace flatdyn {

void check_assembly(const Robot& robot, Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (const Joint& joint : robot.joints) {
    if (joint.type != JointType::fixed && !joint.coupled) known.push_back(joint.name);
  }
  for (const JointPosition& position : robot.assembly) {
    const bool is_held = std::any_of(robot.joints.begin(), robot.joints.end(), [&position](const Joint& joint) {
      return joint.held && joint.name == position.joint;
    });
    if (is_held || std::find(known.begin(), known.end(), position.joint) != known.end()) continue;
    diagnostics.error(position.place, "assembly: no joint \"" + position.joint + "\" has a position of its own",
                      hint_for_unknown(position.joint, known, "joints"));
  }
}

std::vector<double> assembled_positions(const Robot& robot, const Mechanism& mechanism) {
  std::vector<double> positions;
  for (int p = 0; p < mechanism.position_count(); ++p) {
    const std::string& joint = mechanism.joint_at(p).joint;
    const auto given = std::find_if(robot.assembly.begin(), robot.assembly.end(),
                                    [&](const JointPosition& each) { return each.joint == joint; });
    positions.push_back(given == robot.assembly.end() ? 0 : nearest_double(given->position));
  }
  return positions;
}

}  // namespace flatdyn

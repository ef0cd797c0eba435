// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/references.hpp"

#include "base/diagnostics/nearest.hpp"

namespace flatdyn {

int joint_called(const std::string& name, const Place& place, const std::string& what, const Robot& robot,
                 Diagnostics& diagnostics) {
  std::vector<std::string> known;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    if (robot.joints[j].name == name) return static_cast<int>(j);
    known.push_back(robot.joints[j].name);
  }
  diagnostics.error(place, what + ": there is no joint \"" + name + "\"", hint_for_unknown(name, known, "joints"));
  return -1;
}

}  // namespace flatdyn

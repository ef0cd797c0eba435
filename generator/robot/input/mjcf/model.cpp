// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/model.hpp"

#include <algorithm>

#include "base/diagnostics/nearest.hpp"

namespace flatdyn {

std::string unused_name(const std::string& wanted, const std::vector<std::string>& taken) {
  std::string name = wanted;
  while (std::find(taken.begin(), taken.end(), name) != taken.end()) name += "_";
  return name;
}

std::string new_body_name(const std::string& wanted, const MjcfModel& model) {
  std::vector<std::string> taken = model.names_of_bodies;
  for (const Link& link : model.robot.links) taken.push_back(link.name);
  return unused_name(wanted, taken);
}

void report_missing_name(const FileAttribute& attribute, const std::string& what, const std::string& kind,
                         const std::vector<std::string>& known, Diagnostics& diagnostics) {
  diagnostics.error(attribute.place, what + ": there is no " + kind + " \"" + attribute.text + "\"",
                    known.empty() ? "check the name" : hint_for_unknown(attribute.text, known, "names"));
}

std::vector<std::string> joint_names(const Robot& robot) {
  std::vector<std::string> names;
  for (const Joint& joint : robot.joints) {
    if (joint.type != JointType::fixed) names.push_back(joint.name);
  }
  return names;
}

std::vector<std::string> body_names(const MjcfModel& model) {
  std::vector<std::string> names;
  for (const auto& [name, body] : model.body_of_name) names.push_back(name);
  return names;
}

}  // namespace flatdyn

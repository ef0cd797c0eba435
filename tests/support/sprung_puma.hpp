// SPDX-License-Identifier: GPL-2.0-or-later
// The Puma 560 with springs at two joints.
#pragma once

#include <string>

#include "support/robot_models.hpp"
#include "support/written_model.hpp"

namespace flatdyn::testing {

inline LoadedRobot sprung_puma() {
  std::string text = text_of_robot("puma560.toml");
  for (const char* joint : {"joint = \"shoulder\"\n", "joint = \"elbow\"\n"}) {
    text.insert(text.find(joint), "stiffness = 40\nspring_reference = 0.4\n");
  }
  return model_of_toml(text);
}

}  // namespace flatdyn::testing

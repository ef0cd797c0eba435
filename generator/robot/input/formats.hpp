// SPDX-License-Identifier: GPL-2.0-or-later
// The formats of robot files. Help is made of this list, and tests compare documents, CMake and packages with it.
#pragma once

#include <array>
#include <string>

namespace flatdyn {

inline constexpr std::array<const char*, 5> kRobotFormats = {"URDF", "SDF", "MJCF", "xacro", "TOML"};

// "URDF, SDF, MJCF, xacro or TOML"
inline std::string robot_formats_text() {
  std::string text;
  for (std::size_t k = 0; k < kRobotFormats.size(); ++k) {
    text += std::string(k == 0 ? "" : k + 1 < kRobotFormats.size() ? ", " : " or ") + kRobotFormats[k];
  }
  return text;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Files for readers that are given bytes.
#pragma once

#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/system/temporary_folder.hpp"

namespace flatdyn::testing {

inline void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

// The path of a file with these bytes. One file of this name is written again and again.
inline std::string file_of(std::string_view bytes, const char* name) {
  static const TemporaryFolder folder;
  const std::string path = (folder.path() / name).string();
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return path;
}

inline constexpr const char* kArm = R"(
[[link]]
mass = 1
com = [0.5, 0, 0]
[[link]]
xyz = [1, 0, 0]
mass = 1
com = [0.5, 0, 0]
inertia = { xx = 1, yy = 1, zz = 1 }
inertia_about = "com"
limits = { lower = -1, upper = 1, velocity = 5, effort = 10 }
)";

}  // namespace flatdyn::testing

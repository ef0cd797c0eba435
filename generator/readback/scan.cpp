// SPDX-License-Identifier: GPL-2.0-or-later
#include "readback/scan.hpp"

#include <charconv>

namespace flatdyn {

void note_count(const std::string& name, const std::string& value, ScannedText& found) {
  int number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error != std::errc() || end != value.data() + value.size()) return;
  for (const auto& [kind, in_c] :
       {std::pair("joint_count", "_JOINT_COUNT"), std::pair("position_count", "_POSITION_COUNT"),
        std::pair("angle_count", "_ANGLE_COUNT"), std::pair("velocity_count", "_VELOCITY_COUNT")}) {
    if (name == kind || name.ends_with(in_c)) found.counts[kind] = {name, number};
  }
}

}  // namespace flatdyn

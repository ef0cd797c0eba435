// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/readback/scan.hpp"

#include <charconv>
#include <string>

namespace flatdyn {

void note_count(const std::string& name, const std::string& value, ScannedText& found) {
  int number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error != std::errc() || end != value.data() + value.size()) return;
  for (const auto& [kind, capitals] :
       {std::pair("joint_count", "JOINT_COUNT"), std::pair("position_count", "POSITION_COUNT"),
        std::pair("angle_count", "ANGLE_COUNT"), std::pair("velocity_count", "VELOCITY_COUNT")}) {
    const bool is_prefixed = name.ends_with(std::string("_") + capitals);
    if (name == kind || name == capitals || is_prefixed) found.counts[kind] = {name, number};
  }
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "firmware/target.hpp"

#include "diagnostics/diagnostics.hpp"

namespace flatdyn {
namespace {

constexpr FirmwareTarget kTargets[] = {
    {"cortex-m4", "-mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard", "mps2-an386", "float"},
    {"cortex-m7", "-mcpu=cortex-m7 -mthumb -mfpu=fpv5-d16 -mfloat-abi=hard", "mps2-an500", "double"},
};

}  // namespace

const FirmwareTarget& firmware_target(const std::string& name) {
  for (const FirmwareTarget& target : kTargets) {
    if (name == target.name) return target;
  }
  throw Failure(ExitCode::usage, "unknown processor \"" + name + "\"", "use cortex-m4 or cortex-m7");
}

std::vector<std::string> firmware_target_names() {
  std::vector<std::string> names;
  for (const FirmwareTarget& target : kTargets) names.emplace_back(target.name);
  return names;
}

}  // namespace flatdyn

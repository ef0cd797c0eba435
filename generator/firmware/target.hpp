// SPDX-License-Identifier: GPL-2.0-or-later
// Processors that `flatdyn generate --firmware` writes a folder for, and the boards that qemu has of them.
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

struct FirmwareTarget {
  const char* name;     // "cortex-m4"
  const char* flags;    // of arm-none-eabi-gcc
  const char* machine;  // of qemu-system-arm
  const char* scalar;   // that its floating-point unit computes in
};

// Throws Failure(usage) for a name that is none.
const FirmwareTarget& firmware_target(const std::string& name);

std::vector<std::string> firmware_target_names();

}  // namespace flatdyn

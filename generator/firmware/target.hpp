// SPDX-License-Identifier: GPL-2.0-or-later
// Processors that `flatdyn generate --firmware` writes a folder for: how Debian's tools build for them, and what runs
// the result here.
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

struct FirmwareTarget {
  const char* name;            // "cortex-m4"
  const char* tools;           // "arm-none-eabi-": before gcc, objdump, nm, size
  const char* flags;           // of the compiler: which processor
  const char* link_flags;      // which start-up code, libraries and memory
  const char* emulator;        // the command that the program's name follows
  const char* branches;        // its conditional ones, as objdump names them: a regular expression
  const char* packages;        // of Debian, that all of these are in
  const char* scalar;          // that its floating-point unit computes in
  bool has_own_start = false;  // startup.c and target.ld are written, too
};

// Throws Failure(usage) for a name that is none.
const FirmwareTarget& firmware_target(const std::string& name);

std::vector<std::string> firmware_target_names();

}  // namespace flatdyn

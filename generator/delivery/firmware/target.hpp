// SPDX-License-Identifier: GPL-2.0-or-later
// Processors for which `flatdyn generate --firmware` writes a folder: how Debian's tools build for them, and how the
// result runs on this machine.
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

struct FirmwareTarget {
  const char* name;         // "cortex-m4"
  const char* tools;        // prefix of gcc, objdump, nm, size: "arm-none-eabi-"
  const char* flags;        // compiler flags for the processor
  const char* link_flags;   // start-up code, libraries and memory
  const char* emulator;     // command that runs a program named after it
  const char* branches;     // regular expression for its conditional branches in objdump's names
  const char* packages;     // Debian packages with all of these
  const char* scalar;       // scalar of its floating-point unit
  const char* soft_double;  // patterns, for sh, of the compiler's functions for double; nullptr if it has a unit for it
  bool has_own_start = false;  // startup.c and target.ld are written, too
};

// Whether the processor computes in this scalar by functions of its compiler, because it has no unit for it.
bool is_soft(const FirmwareTarget& target, const std::string& scalar);

// A sentence about such a processor, with what it costs; empty if it has a unit for the scalar.
std::string note_of_soft_scalar(const FirmwareTarget& target, const std::string& scalar);

// The target of this name. Throws Failure(usage) for an unknown name.
const FirmwareTarget& firmware_target(const std::string& name);

// The names of all targets.
std::vector<std::string> firmware_target_names();

}  // namespace flatdyn

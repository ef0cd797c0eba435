// SPDX-License-Identifier: GPL-2.0-or-later
// The exit codes for --help and manual pages; docs/exit-codes.md explains them.
#pragma once

#include <fmt/format.h>

#include <string>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {

// Exit codes of the program, documented in docs/exit-codes.md and in --help.
enum class ExitCode : int {
  ok = 0,
  bug = 1,
  usage = 2,
  input = 3,
  unsupported = 4,
  verification_failed = 5,
  io = 6,
  outdated = 7,
  interrupted = 130,  // by Ctrl-C, as shells count it
};

struct ExitCodeMeaning {
  ExitCode code;
  const char* meaning;
};

inline constexpr ExitCodeMeaning kExitCodes[] = {
    {ExitCode::ok, "ok"},
    {ExitCode::bug, "bug"},
    {ExitCode::usage, "usage"},
    {ExitCode::input, "input"},
    {ExitCode::unsupported, "unsupported"},
    {ExitCode::verification_failed, "verification failed"},
    {ExitCode::io, "I/O"},
    {ExitCode::outdated, "outputs out of date"},
    {ExitCode::interrupted, "interrupted"},
};

constexpr ExitCode exit_code_of(FailureKind kind) {
  switch (kind) {
    case FailureKind::bug:
      return ExitCode::bug;
    case FailureKind::usage:
      return ExitCode::usage;
    case FailureKind::input:
      return ExitCode::input;
    case FailureKind::unsupported:
      return ExitCode::unsupported;
    case FailureKind::verification_failed:
      return ExitCode::verification_failed;
    case FailureKind::io:
      return ExitCode::io;
    case FailureKind::outdated:
      return ExitCode::outdated;
    case FailureKind::interrupted:
      return ExitCode::interrupted;
  }
  return ExitCode::bug;
}

// All exit codes as text: "0 ok, 1 bug, …".
inline std::string exit_codes_text() {
  std::string text;
  for (const auto& [code, meaning] : kExitCodes) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", static_cast<int>(code), meaning);
  }
  return text;
}

}  // namespace flatdyn

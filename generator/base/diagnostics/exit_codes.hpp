// SPDX-License-Identifier: GPL-2.0-or-later
// The exit codes for --help and manual pages; docs/exit-codes.md explains them.
#pragma once

#include <fmt/format.h>

#include <string>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {

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

// All exit codes as text: "0 ok, 1 bug, …".
inline std::string exit_codes_text() {
  std::string text;
  for (const auto& [code, meaning] : kExitCodes) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", static_cast<int>(code), meaning);
  }
  return text;
}

}  // namespace flatdyn

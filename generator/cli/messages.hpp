// SPDX-License-Identifier: GPL-2.0-or-later
// The program's messages: results on stdout, findings and failures on stderr, in one style: "flatdyn: error: ..." or,
// at a place in a file, "FILE:LINE: error: ...", with a hint on the next line. docs/exit-codes.md shows them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/diagnostics/findings_text.hpp"
#include "cli/exit_codes.hpp"
#include "functions/load/bad_input.hpp"

namespace flatdyn {

// Prints to stderr after flushing stdout, so that both appear in order on a terminal.
void print_diagnostics(const Diagnostics& diagnostics, const OutputStyle& style);

// With --json, a run that Ctrl-C ends before it has a result prints an object of errors all the same.
void prepare_for_interruption(const OutputStyle& style);

// Prints to stdout after erasing the line of progress.
void print_result(const std::string& text);

// Prints a failure to stderr and, with --json, as an object of errors to stdout. Returns the exit code.
ExitCode report_failure(const Failure& failure, const OutputStyle& style);
ExitCode report_failure(const BadInput& bad, const OutputStyle& style);

}  // namespace flatdyn

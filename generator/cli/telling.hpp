// SPDX-License-Identifier: GPL-2.0-or-later
// The program's messages: results on stdout, findings and failures on stderr, in one style: "flatdyn: error: ..." or,
// at a place in a file, "FILE:LINE: error: ...", with a hint on the next line. docs/exit-codes.md shows them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "diagnostics/command_output.hpp"
#include "load/bad_input.hpp"

namespace flatdyn {

// Prints to stderr after flushing stdout, so that both appear in order on a terminal.
void print_diagnostics(const Diagnostics& diagnostics, const Manner& manner);

// With --json, a run that Ctrl-C ends before it has a result prints an object of errors all the same.
void prepare_for_interruption(const Manner& manner);

// Prints to stdout after erasing the line of progress.
void print_result(const std::string& text);

// Prints a failure to stderr and, with --json, as an object of errors to stdout. Returns the exit code.
ExitCode tell(const Failure& failure, const Manner& manner);
ExitCode tell(const BadInput& bad, const Manner& manner);

}  // namespace flatdyn

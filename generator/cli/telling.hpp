// SPDX-License-Identifier: GPL-2.0-or-later
// What the program says: results on stdout, findings and failures on stderr, in one style: "flatdyn: error: ..." or,
// at a place of a file, "FILE:LINE: error: ..."; a hint on the next line. docs/exit-codes.md shows them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "diagnostics/command_output.hpp"
#include "load/bad_input.hpp"

namespace flatdyn {

// On stderr, behind what waits for stdout, so that both come in order on a terminal.
void print_diagnostics(const Diagnostics& diagnostics, const Manner& manner);

// With --json, a run that Ctrl-C ends before it has a result prints an object of errors all the same.
void prepare_for_interruption(const Manner& manner);

// On stdout, after the line that says what the program is busy with is erased.
void print_result(const std::string& text);

// A failure on stderr and, with --json, as an object of errors on stdout. Return the exit code.
ExitCode tell(const Failure& failure, const Manner& manner);
ExitCode tell(const BadInput& bad, const Manner& manner);

}  // namespace flatdyn

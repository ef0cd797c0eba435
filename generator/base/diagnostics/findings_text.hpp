// SPDX-License-Identifier: GPL-2.0-or-later
// Findings as text for a terminal: a short block of notes, then warnings and errors.
#pragma once

#include <string>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {

// The amount and the form of output: the options --quiet, --verbose and --json.
struct OutputStyle {
  bool quiet = false;    // no notes, no progress, no tables if files are written
  bool verbose = false;  // every finding on its own, with its hint
  bool json = false;     // results and errors on stdout as JSON
};

// The findings as text: notes first, in at most ten lines, then all warnings and errors in their order. Notes, and
// warnings, of one kind share a line: "note: 12 limits of 0 taken as not given (arm.urdf:12, 25, 40, …)". Each line
// ends with a line break.
std::string findings_text(const Diagnostics& diagnostics, const OutputStyle& style);

}  // namespace flatdyn

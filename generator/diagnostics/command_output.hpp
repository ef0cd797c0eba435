// SPDX-License-Identifier: GPL-2.0-or-later
// Findings as a person reads them on a terminal: a short block of notes, then warnings and errors.
#pragma once

#include <string>

#include "diagnostics/diagnostics.hpp"

namespace flatdyn {

// How much is told, and how: the options --quiet, --verbose and --json.
struct Manner {
  bool quiet = false;    // no notes, no progress, no tables beside files that are written
  bool verbose = false;  // each finding by itself, with its hint
  bool json = false;     // results and errors on stdout as JSON
};

// Notes come first, in at most ten lines; warnings and errors follow in their order, all of them. Notes, and warnings,
// of one kind share a line: "note: 12 limits of 0 taken as not given (arm.urdf:12, 25, 40, …)". Each line is ended.
std::string told(const Diagnostics& diagnostics, const Manner& manner);

}  // namespace flatdyn

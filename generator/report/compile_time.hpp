// SPDX-License-Identifier: GPL-2.0-or-later
// The time that a compiler takes for emitted code, of which people should know before they include it in many files.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "code/emit/emit_options.hpp"
#include "code/lower/stages.hpp"
#include "functions/planning/optimised_function.hpp"

namespace flatdyn {

// Seconds of a processor for one function in one scalar, by g++ 12 at -O2 on a machine that compiles a file with
// <ginac/ginac.h>, <iostream> and <regex> in 0.8 s: 0.15 ms per operation and 0.4 ms per entry that is written.
// Measured with 19 functions each of three robots, 2 to 26 s (docs/benchmark.md, "Compile times").
double compile_seconds(const Function& function);

// A line for people, "compiling all of it takes some 8 s …"; nothing if it takes less than 3 s, or is not compiled.
std::string describe_compile_time(const std::vector<OptimisedFunction>& functions, const std::optional<Stages>& stages,
                                  const EmitOptions& options);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The size of emitted code as machine code. Straight-line code that is larger than the cache for instructions is read
// from a slower one in each call.
#pragma once

#include <string>
#include <vector>

#include "code/emit/emit_options.hpp"
#include "functions/planning/optimised_function.hpp"
#include "graph/count.hpp"

namespace flatdyn {

// Bytes of one function in one scalar, for given sines, by g++ 12 with the flags of `flatdyn bench` on x86-64: 9 per
// operation, 10 per entry that is written, and 2 per zero, which are stored some at a time. Functions take 0.74 to 1.22
// times as many (docs/benchmark.md, "Sizes").
int code_bytes(const OperationCount& operations, int written_entries, int written_zeros);
int code_bytes(const Function& function);

// A line for people that names functions larger than the cache for instructions of most processors, 32 KiB; nothing if
// none is, or where nothing is compiled. `has_limbs`: whether the robot has limbs that could be computed together.
std::string describe_code_size(const std::vector<OptimisedFunction>& functions, const EmitOptions& options,
                               bool has_limbs);

}  // namespace flatdyn

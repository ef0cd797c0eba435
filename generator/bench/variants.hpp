// SPDX-License-Identifier: GPL-2.0-or-later
// The ways in which one generated function is called.
#pragma once

#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

// One state per call; a member of a stage (emit/stages.hpp) that has been made; over SIMD lanes, all states by one
// call.
enum class Calling { single, staged, batch };

// Where the sines and cosines come from, the last argument of generated functions: the library, all joints' by one
// call over SIMD lanes, or the caller, so that the time is that of the rest.
enum class Trigonometry { library, together, given };

struct BenchVariant {
  const char* name;
  const char* scalar;  // "double" or "float"
  Calling calling;
  Trigonometry trigonometry;
  const char* budget = "";  // error budget that the function is abbreviated by; "": none
};

// One line each. The first one is what the others' times are compared with.
const std::vector<BenchVariant>& bench_variants();

bool needs_xsimd(const BenchVariant& variant);
// Whether the call does all of the work.
bool is_whole_call(const BenchVariant& variant);
// Whether there is something of this kind in the function, and whether the machine has what it needs.
bool is_made(const BenchVariant& variant, const Function& function, bool has_xsimd);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The ways in which one generated function is called.
#pragma once

#include <string>
#include <vector>

namespace flatdyn {

struct BenchVariant {
  const char* name;
  const char* scalar;  // "double" or "float"
  bool batch;          // over SIMD lanes, all states by one call
};

// One line each. The first one is what the others' times are compared with.
const std::vector<BenchVariant>& bench_variants();

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Rounding errors against 50 digits.
#pragma once

#include <vector>

#include "functions/deviation/expected.hpp"
#include "laboratory/bench/program.hpp"

namespace flatdyn {

struct BenchErrors {
  ErrorSummary scaled, absolute;
  std::size_t states = 0;
};

// The errors by case. `values`: as returned by BenchProgram::values at `wanted` states; for costly functions fewer are
// compared.
std::vector<BenchErrors> bench_errors(const BenchSubject& subject, const ExpectedValues& expected,
                                      const std::vector<BenchCase>& cases,
                                      const std::vector<std::vector<double>>& values, std::size_t wanted);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// A robot's generated functions in all variants (float and double, one state or SIMD lanes, every source of sines and
// cosines), compiled and called in this process.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/variants.hpp"
#include "graph/function.hpp"
#include "model/mechanism.hpp"
#include "model/states.hpp"
#include "system/shared_library.hpp"
#include "system/temporary_folder.hpp"

namespace flatdyn {

// One function in one variant.
struct StressCall {
  BenchVariant variant;
  bool (*entry)(const double* const* in, double* out) = nullptr;
};

// Those that do all of the work, or all but the sines and cosines.
std::vector<BenchVariant> stress_variants();

class StressProgram {
 public:
  // `like` says how many numbers a state has; `wanted`: names of variants, none: all. Throws as SharedLibrary does.
  StressProgram(const Mechanism& mechanism, const std::vector<Function>& functions, const State& like,
                const std::vector<std::string>& wanted);

  // Of functions[k], those in `scalar`; batches only where xsimd is installed.
  std::vector<StressCall> calls(std::size_t k, const std::string& scalar) const;
  bool has_xsimd() const { return has_xsimd_; }

 private:
  TemporaryFolder folder_;
  bool has_xsimd_;
  std::vector<std::vector<StressCall>> calls_;  // by function
  std::unique_ptr<SharedLibrary> library_;
};

// Entries of all outputs, in order, as doubles; false where the function returns false, and then nothing is said of
// `out`.
bool evaluate(const StressCall& call, const State& state, std::vector<double>& out);

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// A robot's generated functions in all variants (float and double, one state or SIMD lanes, every source of sines and
// cosines), compiled and called in this process.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/system/shared_library.hpp"
#include "base/system/temporary_folder.hpp"
#include "graph/function.hpp"
#include "laboratory/bench/variants.hpp"
#include "robot/model/mechanism.hpp"
#include "robot/model/states.hpp"

namespace flatdyn {

// A function in one variant.
struct StressCall {
  BenchVariant variant;
  bool (*entry)(const double* const* in, double* out) = nullptr;
};

// The variants that do all of the work, or all but the sines and cosines.
std::vector<BenchVariant> stress_variants();

class StressProgram {
 public:
  // `like`: a state with the sizes of all states; `wanted`: names of variants, empty for all. Throws as SharedLibrary
  // does.
  StressProgram(const Mechanism& mechanism, const std::vector<Function>& functions, const State& like,
                const std::vector<std::string>& wanted);

  // The calls of functions[k] in `scalar`; batches only if xsimd is installed.
  std::vector<StressCall> calls(std::size_t k, const std::string& scalar) const;
  bool has_xsimd() const { return has_xsimd_; }

 private:
  TemporaryFolder folder_;
  bool has_xsimd_;
  std::vector<std::vector<StressCall>> calls_;  // by function
  std::unique_ptr<SharedLibrary> library_;
};

// Writes the entries of all outputs, in order, as doubles. Returns false if the function does; then `out` is
// meaningless.
bool evaluate(const StressCall& call, const State& state, std::vector<double>& out);

}  // namespace flatdyn

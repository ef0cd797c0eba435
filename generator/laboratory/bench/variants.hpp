// SPDX-License-Identifier: GPL-2.0-or-later
// The ways in which one generated function is called.
#pragma once

#include <vector>

#include "graph/function.hpp"

namespace flatdyn {

// How a generated function is called: one state per call; as a member of a stage (code/lower/stages.hpp) that is
// already made; over SIMD lanes, with all states in one call; or in the CUDA form, compiled for the processor, with the
// states of a block one after the other (flatdyn/cuda_batch.cuh).
enum class CallMode { single, staged, batch, kernel };

// The source of sines and cosines, the last argument of generated functions: their own, which is the default; the
// library; the runtime's, which evaluates all joints' over SIMD lanes; or the caller, so that only the rest is timed.
enum class SinCosSource { own, library, together, given };

struct BenchVariant {
  const char* name;
  const char* scalar;  // "double" or "float"
  CallMode call_mode;
  SinCosSource trigonometry;
  const char* budget = "";  // error budget by which the function is abbreviated; "": none
  bool is_packed = false;   // a batch without the zeros and the mirrored entries of matrices
  bool fuses = false;       // whether the function is one with fused multiply-adds
  bool has_lanes = false;   // whether limbs alike are computed in the lanes of vectors
  bool is_native = false;   // whether the compiler tunes for this processor, without kTuning
};

// All variants. The times of the others are compared with the first one's.
const std::vector<BenchVariant>& bench_variants();

// Whether the call uses SIMD lanes.
bool needs_xsimd(const BenchVariant& variant);
// Whether the variant computes the bits of the plain C++ form with its own sines and cosines, for one state at a time;
// all variants of one scalar that do compute the same.
bool has_plain_bits(const BenchVariant& variant);
// Whether the call does the whole work.
bool is_whole_call(const BenchVariant& variant);
// Whether the function takes a source of sines and cosines: it asks for those of angles that it does not compute.
bool has_angles(const Function& function);
// Whether the variant applies to the function, and the machine has what it needs.
bool is_made(const BenchVariant& variant, const Function& function, bool has_xsimd);

}  // namespace flatdyn

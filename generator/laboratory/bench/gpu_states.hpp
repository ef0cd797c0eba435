// SPDX-License-Identifier: BSD-3-Clause
// The states of the benchmark on graphics processors, the same on the host and on the device, and exact in float. The
// benchmark's program has a copy of this file.
#pragma once

#include <cstddef>
#include <cstdint>

#ifdef __CUDACC__
#define FLATDYN_ON_BOTH __host__ __device__
#else
#define FLATDYN_ON_BOTH
#endif

// Entry `entry` of input `input` at a state: a multiple of 2^-22 in [-2, 2).
FLATDYN_ON_BOTH inline float number_at(std::size_t state, int input, int entry) {
  std::uint64_t x = state * 4096u + static_cast<std::uint64_t>(input) * 512u + static_cast<std::uint64_t>(entry);
  x = (x + 0x9e3779b97f4a7c15u) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  x ^= x >> 31;
  return static_cast<float>(static_cast<std::int32_t>(x >> 40) - 8388608) / 4194304.0f;
}

inline constexpr int reference_states = 64;

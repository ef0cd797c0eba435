// SPDX-License-Identifier: GPL-2.0-or-later
// The states of the benchmark on graphics processors, the same on the host and on the device, and exact in float.
#pragma once

#include <cstddef>
#include <cstdint>

#ifdef __CUDACC__
#define ANYWHERE __host__ __device__
#else
#define ANYWHERE
#endif

// Entry `entry` of input `input` at a state: a multiple of 2^-22 in [-2, 2).
ANYWHERE inline float number_at(std::size_t state, int input, int entry) {
  std::uint64_t x = state * 4096u + static_cast<std::uint64_t>(input) * 512u + static_cast<std::uint64_t>(entry);
  x = (x + 0x9e3779b97f4a7c15u) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  x ^= x >> 31;
  return static_cast<float>(static_cast<std::int32_t>(x >> 40) - 8388608) / 4194304.0f;
}

constexpr int reference_states = 64;

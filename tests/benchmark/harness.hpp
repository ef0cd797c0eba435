// SPDX-License-Identifier: GPL-2.0-or-later
// The states of all benchmarks, and the loops over them.
#pragma once

#include <benchmark/benchmark.h>

#include <cstddef>
#include <random>
#include <vector>

namespace flatdyn {

inline constexpr std::size_t kJoints = 7, kStates = 1024;

// States in two layouts: entry i of state k is at by_entry[i * kStates + k], and at of(k)[i].
class States {
 public:
  explicit States(unsigned seed) : by_entry(kJoints * kStates), by_state_(kJoints * kStates) {
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> uniform(-2.5, 2.5);
    for (std::size_t at = 0; at < by_entry.size(); ++at) {
      by_entry[at] = uniform(engine);
      by_state_[at % kStates * kJoints + at / kStates] = by_entry[at];
    }
  }
  const double* of(std::size_t k) const { return &by_state_[k * kJoints]; }

  std::vector<double> by_entry;

 private:
  std::vector<double> by_state_;
};

inline const States& q() {
  static const States states(1);
  return states;
}
inline const States& qd() {
  static const States states(2);
  return states;
}
inline const States& qdd() {
  static const States states(3);
  return states;
}

// Converts the results of function(entry) to another scalar: entry i of state k is at [k * kJoints + i].
template <class Scalar, class Function>
std::vector<Scalar> mapped(const States& states, Function function) {
  std::vector<Scalar> result;
  for (std::size_t k = 0; k < kStates; ++k) {
    for (std::size_t i = 0; i < kJoints; ++i) result.push_back(static_cast<Scalar>(function(states.of(k)[i])));
  }
  return result;
}

// Times call(k) for state after state.
template <class Call>
void run(benchmark::State& state, Call call) {
  std::size_t k = 0;
  for (auto _ : state) {
    call(k);
    k = (k + 1) % kStates;
  }
}

inline void add(const char* name, void (*function)(benchmark::State&)) { benchmark::RegisterBenchmark(name, function); }

// Adds the recursive reference and, if it is installed, Orocos KDL.
void add_peers();

}  // namespace flatdyn

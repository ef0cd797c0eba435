// SPDX-License-Identifier: GPL-2.0-or-later
// Time of one call for the Panda: generated code for one state at a time, with other sources of sines and cosines, in
// float and over SIMD lanes, beside the recursive reference and, if it is installed, Orocos KDL. Every call gets
// another state. scripts/bench runs it.
#include <cmath>

#include "benchmark/harness.hpp"
#include "flatdyn/batch.hpp"
#include "flatdyn/trigonometry.hpp"
#include "panda.hpp"

namespace flatdyn {
namespace {

template <std::size_t entries, class Scalar = double, class Call>
void run_generated(benchmark::State& state, Call call) {
  Scalar out[entries];
  run(state, [&](std::size_t k) {
    call(k, out);
    benchmark::DoNotOptimize(out);
    benchmark::ClobberMemory();
  });
}

// Times a batch; the result is the time per state.
template <std::size_t entries, class Call>
void run_batch(benchmark::State& state, Call call) {
  std::vector<double> result(entries * kStates);
  while (state.KeepRunningBatch(kStates)) {
    call(result.data());
    benchmark::DoNotOptimize(result.data());
    benchmark::ClobberMemory();
  }
}

void add_generated() {
  add("inverse_dynamics/flatdyn", [](benchmark::State& s) {
    run_generated<7>(
        s, [](std::size_t k, double* out) { panda::inverse_dynamics(q().of(k), qd().of(k), qdd().of(k), out); });
  });
  add("inertia_matrix/flatdyn", [](benchmark::State& s) {
    run_generated<49>(s, [](std::size_t k, double* out) { panda::inertia_matrix(q().of(k), out); });
  });
  add("gravity/flatdyn", [](benchmark::State& s) {
    run_generated<7>(s, [](std::size_t k, double* out) { panda::gravity(q().of(k), out); });
  });
  add("bias/flatdyn", [](benchmark::State& s) {
    run_generated<7>(s, [](std::size_t k, double* out) { panda::bias(q().of(k), qd().of(k), out); });
  });
  add("coriolis_matrix/flatdyn", [](benchmark::State& s) {
    run_generated<49>(s, [](std::size_t k, double* out) { panda::coriolis_matrix(q().of(k), qd().of(k), out); });
  });
  add("forward_dynamics/flatdyn", [](benchmark::State& s) {
    run_generated<7>(s, [](std::size_t k, double* out) {
      benchmark::DoNotOptimize(panda::forward_dynamics(q().of(k), qd().of(k), qdd().of(k), out));
    });
  });
}

void add_sources_of_sines() {
  add("inverse_dynamics/flatdyn_together", [](benchmark::State& s) {
    run_generated<7>(s, [](std::size_t k, double* out) {
      panda::inverse_dynamics(q().of(k), qd().of(k), qdd().of(k), out, TogetherSinCos());
    });
  });
  add("inverse_dynamics/flatdyn_given", [](benchmark::State& s) {
    const std::vector<double> sine = mapped<double>(q(), [](double x) { return std::sin(x); }),
                              cosine = mapped<double>(q(), [](double x) { return std::cos(x); });
    run_generated<7>(s, [&](std::size_t k, double* out) {
      panda::inverse_dynamics(q().of(k), qd().of(k), qdd().of(k), out,
                              panda::GivenSinCos<double>{&sine[k * kJoints], &cosine[k * kJoints]});
    });
  });
}

void add_float() {
  const auto same = [](double x) { return x; };
  static const std::vector<float> q_ = mapped<float>(q(), same), qd_ = mapped<float>(qd(), same),
                                  qdd_ = mapped<float>(qdd(), same);
  add("inverse_dynamics/flatdyn_float", [](benchmark::State& s) {
    run_generated<7, float>(s, [](std::size_t k, float* out) {
      const std::size_t at = k * kJoints;
      panda::inverse_dynamics(&q_[at], &qd_[at], &qdd_[at], out);
    });
  });
}

void add_batches() {
  add("inverse_dynamics/flatdyn_batch", [](benchmark::State& s) {
    run_batch<7>(s, [](double* out_) {
      for_each_state<double>(
          kStates, [](auto... of) { panda::inverse_dynamics(of...); }, in<7>(q().by_entry.data(), kStates),
          in<7>(qd().by_entry.data(), kStates), in<7>(qdd().by_entry.data(), kStates), out<7>(out_, kStates));
    });
  });
  add("inertia_matrix/flatdyn_batch", [](benchmark::State& s) {
    run_batch<49>(s, [](double* out_) {
      for_each_state<double>(
          kStates, [](auto... of) { panda::inertia_matrix(of...); }, in<7>(q().by_entry.data(), kStates),
          out<49>(out_, kStates));
    });
  });
  add("gravity/flatdyn_batch", [](benchmark::State& s) {
    run_batch<7>(s, [](double* out_) {
      for_each_state<double>(
          kStates, [](auto... of) { panda::gravity(of...); }, in<7>(q().by_entry.data(), kStates),
          out<7>(out_, kStates));
    });
  });
  add("forward_dynamics/flatdyn_batch", [](benchmark::State& s) {
    run_batch<7>(s, [](double* out_) {
      for_each_state<double>(
          kStates, [](auto... of) { return panda::forward_dynamics(of...); }, in<7>(q().by_entry.data(), kStates),
          in<7>(qd().by_entry.data(), kStates), in<7>(qdd().by_entry.data(), kStates), out<7>(out_, kStates));
    });
  });
}

}  // namespace
}  // namespace flatdyn

int main(int argc, char** argv) {
  flatdyn::add_generated();
  flatdyn::add_sources_of_sines();
  flatdyn::add_float();
  flatdyn::add_batches();
  flatdyn::add_peers();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

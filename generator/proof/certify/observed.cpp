// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/observed.hpp"

#include <algorithm>
#include <atomic>
#include <future>
#include <map>
#include <thread>
#include <tuple>

#include "proof/certify/input_limits.hpp"
#include "proof/certify/lanes.hpp"

namespace flatdyn {
namespace {

// The limits of entries of q̇, q̈, τ that operations read, as doubles, which threads can share.
using LimitOfInput = std::map<std::pair<InputKind, int>, double>;

LimitOfInput limits_of_inputs(const StraightLine& lines, const InputLimits& limits) {
  LimitOfInput result;
  for (int k = 0; k < lines.size(); ++k) {
    const Input& input = lines[k].input;
    if (lines[k].step == Step::input && input.kind != InputKind::q) result[{input.kind, input.index}] = limits(input);
  }
  return result;
}

double& entry(State& state, const std::pair<InputKind, int>& input) {
  return state.of(input.first)[static_cast<std::size_t>(input.second)];
}

// The state with an output's largest error so far; among equal ones, the first seen.
struct Worst {
  double error = 0;
  unsigned batch = 0;
  std::size_t lane = 0;
  State state;

  void take(const Worst& other) {
    if (std::tuple(-other.error, other.batch, other.lane) < std::tuple(-error, batch, lane)) *this = other;
  }
};

// The mutations by which states are searched: for a large expected error, which is a smooth function of the state;
// around that state, where only the roundings differ; and from the worst state so far.
constexpr StateMutation kAnywhere = {4, 0, 7}, kNearby = {0, 8, 37}, kFurther = {};

struct Comparison {
  StateSource source;
  LimitOfInput limits;
  const StraightLine& lines;
  const std::vector<int>& of;
  const Function& function;
  const std::vector<NodeId>& exact;
  const RoundingFormat& format;
  ObservedOptions options;

  // Draws states. In every second one all inputs but positions are at their limits, since errors are larger there.
  std::vector<State> drawn(unsigned seed) const {
    std::vector<State> states = source.draw(kLaneCount, seed);
    draw_own_arguments(states, {&function, 1}, seed);
    for (std::size_t k = 1; k < states.size(); k += 2) {
      for (const auto& [input, limit] : limits) {
        double& x = entry(states[k], input);
        x = std::copysign(limit, x);
      }
    }
    return states;
  }

  // Children of a state, each changed towards one of the states drawn.
  std::vector<State> children(const State& parent, const StateMutation& mutation, unsigned seed) const {
    constexpr unsigned kOfChildren = 0x6368696c;  // a separate stream of random numbers
    std::vector<State> states = drawn(seed);
    std::mt19937_64 random(seed + kOfChildren);
    for (State& state : states) {
      state = child(parent, state, random, mutation);
      for (const auto& [input, limit] : limits) {
        double& x = entry(state, input);
        x = std::clamp(x, -limit, limit);  // sums of coordinates are rounded
      }
    }
    return states;
  }
};

// Σ (x_k ∂y/∂x_k)² of an output y over all results before it. If their rounding errors were random, this would be the
// mean square of y's error in units of the last place.
template <class T>
Lanes<double> expected_squares(const StraightLine& lines, const std::vector<Lanes<T>>& values, int output) {
  const std::vector<Lanes<T>> by = derivatives(lines, values, output);
  Lanes<double> sum;
  for (std::size_t k = 0; k < by.size(); ++k) {
    for (std::size_t s = 0; s < kLaneCount; ++s) {
      const double term = static_cast<double>(by[k].of[s]) * static_cast<double>(values[k].of[s]);
      sum.of[s] += term * term;
    }
  }
  return sum;
}

// The state at which the errors of an output should be largest, found in this number of batches, a quarter of them
// drawn.
template <class T>
State expected_worst(const Comparison& comparison, std::size_t output, unsigned batches) {
  constexpr unsigned kOfOutput = 0x6f757470;  // separate streams of random numbers
  const unsigned first = comparison.options.seed + kOfOutput * static_cast<unsigned>(output + 1);
  State worst;
  double most = -1;
  for (unsigned k = 0; k < batches; ++k) {
    const unsigned seed = first + k;
    const Batch batch(4 * k < batches ? comparison.drawn(seed) : comparison.children(worst, kAnywhere, seed),
                      comparison.format, seed);
    const int result = comparison.of[output];
    const Lanes<double> squares =
        expected_squares(comparison.lines, executed<T>(comparison.lines, result, batch, 0), result);
    if (k == 0) worst = batch.states().front();  // in case all are NaN
    for (std::size_t s = 0; s < kLaneCount; ++s) {
      if (!(squares.of[s] > most)) continue;
      most = squares.of[s];
      worst = batch.states()[s];
    }
  }
  return worst;
}

template <class T, class Wide>
class Observer {
 public:
  explicit Observer(const Comparison& comparison) : comparison_(comparison), worst_(comparison.of.size()) {
    for (const int result : comparison.of) last_ = std::max(last_, result);
  }

  // Observes half of the states at random, then generations of children for each output in turn, all on all cores.
  std::vector<double> run() {
    if (worst_.empty()) return {};
    const auto count =
        static_cast<unsigned>((static_cast<std::size_t>(comparison_.options.states) + kLaneCount - 1) / kLaneCount);
    expect(std::clamp(count / (8 * static_cast<unsigned>(worst_.size())), 8u, 128u));
    const unsigned random = (count + 1) / 2, each = kBatches * static_cast<unsigned>(worst_.size());
    go_through(0, random, false);
    for (unsigned first = random; first < count; first += each) go_through(first, std::min(first + each, count), true);
    std::vector<double> largest;
    for (const Worst& worst : worst_) largest.push_back(worst.error);
    return largest;
  }

 private:
  static constexpr unsigned kBatches = 4;  // per output and generation

  // Runs `work` on all cores; each takes the next job when it is free.
  template <class Work>
  static auto on_all_cores(const Work& work) {
    std::vector<std::future<decltype(work())>> running;
    for (unsigned core = 0; core < std::max(1u, std::thread::hardware_concurrency()); ++core) {
      running.push_back(std::async(std::launch::async, work));
    }
    return running;
  }

  void expect(unsigned batches) {
    expected_.resize(worst_.size());
    std::atomic<std::size_t> next = 0;
    for (auto& each : on_all_cores([this, batches, &next] {
           for (std::size_t k = next++; k < expected_.size(); k = next++) {
             expected_[k] = expected_worst<T>(comparison_, k, batches);
           }
         })) {
      each.get();
    }
  }

  void go_through(unsigned first, unsigned last, bool is_search) {
    std::atomic<unsigned> next = first;
    std::vector<Worst> worst = worst_;
    for (auto& each : on_all_cores([this, last, is_search, &next] { return worst_of(next, last, is_search); })) {
      const std::vector<Worst> found = each.get();
      for (std::size_t k = 0; k < worst.size(); ++k) worst[k].take(found[k]);
    }
    worst_ = std::move(worst);
  }

  // The states of a batch: around the state with the largest expected error, and children of the worst, in turn.
  std::vector<State> states_of(unsigned batch, bool is_search) const {
    const unsigned seed = comparison_.options.seed + batch;
    const std::size_t output = batch % worst_.size();
    if (!is_search) return comparison_.drawn(seed);
    const bool is_near = batch / worst_.size() % 2 == 0 || !(worst_[output].error > 0);
    return is_near ? comparison_.children(expected_[output], kNearby, seed)
                   : comparison_.children(worst_[output].state, kFurther, seed);
  }

  std::vector<Worst> worst_of(std::atomic<unsigned>& next, unsigned last, bool is_search) const {
    std::vector<Worst> worst(worst_.size());
    LaneArithmetic<Wide> arithmetic;
    for (unsigned b = next++; b < last; b = next++) {
      const Batch batch(states_of(b, is_search), comparison_.format, comparison_.options.seed + b);
      arithmetic.take(batch);
      const std::vector<Lanes<T>> computed =
          executed<T>(comparison_.lines, last_, batch, comparison_.options.sine_error);
      const std::vector<Lanes<Wide>> exact = evaluate(comparison_.function, arithmetic);
      for (std::size_t k = 0; k < worst.size(); ++k) {
        const Lanes<T>& x = computed[static_cast<std::size_t>(comparison_.of[k])];
        const Lanes<Wide>& y = exact[static_cast<std::size_t>(comparison_.exact[k])];
        for (std::size_t s = 0; s < kLaneCount; ++s) {
          const auto error = static_cast<double>(std::abs(static_cast<Wide>(x.of[s]) - y.of[s]));
          if (error > worst[k].error) worst[k] = {error, b, s, batch.states()[s]};
        }
      }
    }
    return worst;
  }

  const Comparison& comparison_;
  int last_ = 0;                 // the last of the outputs' operations
  std::vector<Worst> worst_;     // by output
  std::vector<State> expected_;  // by output: the state where its errors should be large
};

}  // namespace

std::vector<double> observed_errors(const Mechanism& mechanism, const StraightLine& lines, const std::vector<int>& of,
                                    const Function& function, const std::vector<NodeId>& exact,
                                    const RoundingFormat& format, const ObservedOptions& options) {
  const Comparison comparison{StateSource(mechanism),
                              limits_of_inputs(lines, input_limits(mechanism)),
                              lines,
                              of,
                              function,
                              exact,
                              format,
                              options};
  return format.scalar == "float" ? Observer<float, double>(comparison).run()
                                  : Observer<double, long double>(comparison).run();
}

}  // namespace flatdyn

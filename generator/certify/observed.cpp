// SPDX-License-Identifier: GPL-2.0-or-later
#include "certify/observed.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <future>
#include <map>
#include <random>
#include <thread>
#include <unordered_map>

#include "certify/input_limits.hpp"
#include "graph/arithmetic.hpp"
#include "model/states.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kTogether = 64;  // states that go through an operation together

// A number for each of these states.
template <class T>
struct Lanes {
  std::array<T, kTogether> of{};

  template <class Operator>
  Lanes& by(const Lanes& other, Operator apply) {
    for (std::size_t k = 0; k < kTogether; ++k) of[k] = apply(of[k], other.of[k]);
    return *this;
  }
  Lanes& operator+=(const Lanes& b) {
    return by(b, [](T x, T y) { return x + y; });
  }
  Lanes& operator-=(const Lanes& b) {
    return by(b, [](T x, T y) { return x - y; });
  }
  Lanes& operator*=(const Lanes& b) {
    return by(b, [](T x, T y) { return x * y; });
  }
  Lanes& operator/=(const Lanes& b) {
    return by(b, [](T x, T y) { return x / y; });
  }
  friend Lanes operator*(Lanes a, const Lanes& b) { return a *= b; }
};

template <class T, class Function>
Lanes<T> mapped(Lanes<T> x, Function apply) {
  for (T& each : x.of) each = apply(each);
  return x;
}

template <class T>
Lanes<T> filled(T value) {
  Lanes<T> all;
  all.of.fill(value);
  return all;
}

// Of entries of q̇, q̈, τ that operations read, as numbers that threads can share.
using Limits = std::map<std::pair<InputKind, int>, double>;

Limits limits_of_inputs(const StraightLine& lines, const InputLimits& limits) {
  Limits result;
  for (int k = 0; k < lines.size(); ++k) {
    const Input& input = lines[k].input;
    if (lines[k].step == Step::input && input.kind != InputKind::q) result[{input.kind, input.index}] = limits(input);
  }
  return result;
}

// The numbers of these states, in the format's own values, so that both sides are given the same; never beyond a limit.
// Of every second state all but positions are at their limits: errors are largest there.
class Batch {
 public:
  Batch(const StateSource& source, const Limits& limits, const RoundingFormat& format, unsigned seed)
      : states_(source.draw(kTogether, seed)), limits_(limits), format_(format), seed_(seed) {}

  unsigned seed() const { return seed_; }

  template <class T>
  Lanes<T> input(const Input& input) const {
    Lanes<T> values;
    const auto limit = limits_.find({input.kind, input.index});
    for (std::size_t k = 0; k < kTogether; ++k) {
      const double drawn = states_[k].of(input.kind)[static_cast<std::size_t>(input.index)];
      const bool is_at_limit = limit != limits_.end() && k % 2 == 1;
      values.of[k] = static_cast<T>(format_.toward_zero(is_at_limit ? std::copysign(limit->second, drawn) : drawn));
    }
    return values;
  }

 private:
  std::vector<State> states_;
  const Limits& limits_;
  const RoundingFormat& format_;
  unsigned seed_;
};

// More by the error where the state's bit is set, else less.
template <class T>
Lanes<T> disturbed(Lanes<T> x, T error, std::uint64_t signs) {
  for (std::size_t k = 0; k < kTogether; ++k) x.of[k] += (signs >> k & 1) != 0 ? error : -error;
  return x;
}

template <class T>
Lanes<T> sine_or_cosine(const Lanes<T>& angle, bool is_cosine) {
  return mapped(angle, [is_cosine](T x) { return is_cosine ? std::cos(x) : std::sin(x); });
}

template <class T>
Lanes<T> sign(const Lanes<T>& x) {
  return mapped(x, [](T each) { return static_cast<T>((each > 0) - (each < 0)); });
}

template <class T>
Lanes<T> square_root(const Lanes<T>& x) {
  return mapped(x, [](T each) { return std::sqrt(each); });
}

// The text, operation by operation.
template <class T>
std::vector<Lanes<T>> executed(const StraightLine& lines, const Batch& batch, double sine_error) {
  std::mt19937_64 signs(batch.seed());
  std::vector<Lanes<T>> values;
  values.reserve(static_cast<std::size_t>(lines.size()));
  for (int k = 0; k < lines.size(); ++k) {
    const Operation& operation = lines[k];
    const auto a = [&] { return values[static_cast<std::size_t>(operation.a)]; };
    const auto b = [&]() -> const Lanes<T>& { return values[static_cast<std::size_t>(operation.b)]; };
    switch (operation.step) {
      case Step::constant:
        values.push_back(filled(static_cast<T>(operation.value)));
        break;
      case Step::input:
        values.push_back(batch.input<T>(operation.input));
        break;
      case Step::sine:
      case Step::cosine:
        values.push_back(
            sine_or_cosine(operation.a < 0 ? batch.input<T>(operation.input) : a(), operation.step == Step::cosine));
        if (sine_error > 0) values.back() = disturbed(values.back(), static_cast<T>(sine_error), signs());
        break;
      case Step::negate:
        values.push_back(mapped(a(), [](T x) { return -x; }));
        break;
      case Step::add:
        values.push_back(a() += b());
        break;
      case Step::subtract:
        values.push_back(a() -= b());
        break;
      case Step::multiply:
        values.push_back(a() *= b());
        break;
      case Step::divide:
        values.push_back(a() /= b());
        break;
      case Step::sign:
        values.push_back(sign(a()));
        break;
      case Step::sqrt:
        values.push_back(square_root(a()));
        break;
    }
  }
  return values;
}

// For evaluate(): constants are converted once.
template <class T>
class LaneArithmetic {
 public:
  using Scalar = Lanes<T>;

  void take(const Batch& batch) { batch_ = &batch; }
  const Scalar& constant(const Rational& value) {
    const auto known = constants_.find(&value);
    if (known != constants_.end()) return known->second;
    return constants_.emplace(&value, filled(to_real<T>(value))).first->second;
  }
  Scalar input(const Input& input) const { return batch_->input<T>(input); }
  Scalar divide(Scalar a, const Scalar& b) const { return a /= b; }
  Scalar sin(const Graph&, NodeId, const Scalar& angle) const { return sine_or_cosine(angle, false); }
  Scalar cos(const Graph&, NodeId, const Scalar& angle) const { return sine_or_cosine(angle, true); }
  Scalar sign(const Scalar& x) const { return flatdyn::sign(x); }
  Scalar sqrt(const Scalar& x) const { return square_root(x); }

 private:
  const Batch* batch_ = nullptr;
  std::unordered_map<const Rational*, Scalar> constants_;
};

struct Comparison {
  StateSource source;
  Limits limits;
  const StraightLine& lines;
  const std::vector<int>& of;
  const Function& function;
  const std::vector<NodeId>& exact;
  const RoundingFormat& format;
  ObservedOptions options;
};

// Batches are taken by whoever is free.
template <class T, class Wide>
std::vector<double> largest_errors(const Comparison& comparison, std::atomic<unsigned>& next, unsigned batches) {
  std::vector<double> largest(comparison.of.size(), 0);
  LaneArithmetic<Wide> arithmetic;
  for (unsigned b = next++; b < batches; b = next++) {
    const Batch batch(comparison.source, comparison.limits, comparison.format, comparison.options.seed + b);
    arithmetic.take(batch);
    const std::vector<Lanes<T>> computed = executed<T>(comparison.lines, batch, comparison.options.sine_error);
    const std::vector<Lanes<Wide>> exact = evaluate(comparison.function, arithmetic);
    for (std::size_t k = 0; k < largest.size(); ++k) {
      const Lanes<T>& x = computed[static_cast<std::size_t>(comparison.of[k])];
      const Lanes<Wide>& y = exact[static_cast<std::size_t>(comparison.exact[k])];
      for (std::size_t s = 0; s < kTogether; ++s) {
        largest[k] = std::max(largest[k], static_cast<double>(std::abs(static_cast<Wide>(x.of[s]) - y.of[s])));
      }
    }
  }
  return largest;
}

template <class T, class Wide>
std::vector<double> on_all_cores(const Comparison& comparison) {
  const auto batches =
      static_cast<unsigned>((static_cast<std::size_t>(comparison.options.states) + kTogether - 1) / kTogether);
  std::atomic<unsigned> next = 0;
  std::vector<std::future<std::vector<double>>> running;
  for (unsigned core = 0; core < std::max(1u, std::thread::hardware_concurrency()); ++core) {
    running.push_back(std::async(std::launch::async, [&comparison, &next, batches] {
      return largest_errors<T, Wide>(comparison, next, batches);
    }));
  }
  std::vector<double> largest(comparison.of.size(), 0);
  for (auto& each : running) {
    const std::vector<double> found = each.get();
    for (std::size_t k = 0; k < largest.size(); ++k) largest[k] = std::max(largest[k], found[k]);
  }
  return largest;
}

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
  return format.scalar == "float" ? on_all_cores<float, double>(comparison)
                                  : on_all_cores<double, long double>(comparison);
}

}  // namespace flatdyn

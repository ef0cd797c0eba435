// SPDX-License-Identifier: GPL-2.0-or-later
// Evaluation at many states at once, of a function as its text executes it and of its graph in a wider type.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <unordered_map>
#include <utility>
#include <vector>

#include "code/readback/execute.hpp"
#include "code/readback/straight_line.hpp"
#include "graph/arithmetic.hpp"
#include "proof/certify/rounding.hpp"
#include "robot/model/states.hpp"

namespace flatdyn {

inline constexpr std::size_t kLaneCount = 64;  // number of states evaluated together

// One number for each of these states.
template <class T>
struct Lanes {
  std::array<T, kLaneCount> of{};

  template <class Operator>
  Lanes& by(const Lanes& other, Operator apply) {
    for (std::size_t k = 0; k < kLaneCount; ++k) of[k] = apply(of[k], other.of[k]);
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
  friend Lanes operator+(Lanes a, const Lanes& b) { return a += b; }
  friend Lanes operator-(Lanes a, const Lanes& b) { return a -= b; }
  friend Lanes operator*(Lanes a, const Lanes& b) { return a *= b; }
  friend Lanes operator-(Lanes a) {
    for (T& each : a.of) each = -each;
    return a;
  }
};

// Applies a function to each number.
template <class T, class Function>
Lanes<T> mapped(Lanes<T> x, Function apply) {
  for (T& each : x.of) each = apply(each);
  return x;
}

// The same value in all lanes.
template <class T>
Lanes<T> filled(T value) {
  Lanes<T> all;
  all.of.fill(value);
  return all;
}

// kLaneCount states, rounded to the format, so that the text and the graph get the same numbers; rounding never exceeds
// a limit that is itself a number of the format.
class Batch {
 public:
  Batch(std::vector<State> states, const RoundingFormat& format, unsigned seed)
      : states_(std::move(states)), format_(format), seed_(seed) {}

  const std::vector<State>& states() const { return states_; }
  unsigned seed() const { return seed_; }

  template <class T>
  Lanes<T> input(const Input& input) const {
    Lanes<T> values;
    for (std::size_t k = 0; k < kLaneCount; ++k) {
      values.of[k] =
          static_cast<T>(format_.toward_zero(states_[k].of(input.kind)[static_cast<std::size_t>(input.index)]));
    }
    return values;
  }

 private:
  std::vector<State> states_;
  const RoundingFormat& format_;
  unsigned seed_;
};

// x plus the error where the state's bit of `signs` is set, minus the error elsewhere.
template <class T>
Lanes<T> perturbed(Lanes<T> x, T error, std::uint64_t signs) {
  for (std::size_t k = 0; k < kLaneCount; ++k) x.of[k] += (signs >> k & 1) != 0 ? error : -error;
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

// Arithmetic for execute() in which sines have an error of `sine_error`, at random upward or downward.
template <class T>
class TextArithmetic {
 public:
  using Scalar = Lanes<T>;

  TextArithmetic(const Batch& batch, double sine_error)
      : batch_(batch), sine_error_(sine_error), signs_(batch.seed()) {}

  Scalar constant(double value) const { return filled(static_cast<T>(value)); }
  Scalar input(const Input& input) const { return batch_.input<T>(input); }
  Scalar sine(const Input& position) { return sine(input(position)); }
  Scalar cosine(const Input& position) { return cosine(input(position)); }
  Scalar sine(const Scalar& angle) { return with_error(sine_or_cosine(angle, false)); }
  Scalar cosine(const Scalar& angle) { return with_error(sine_or_cosine(angle, true)); }
  Scalar divide(Scalar a, const Scalar& b) const { return a /= b; }
  Scalar sign(const Scalar& x) const { return flatdyn::sign(x); }
  Scalar sqrt(const Scalar& x) const { return square_root(x); }
  Scalar fused(const Scalar& a, const Scalar& b, Scalar c) const {
    for (std::size_t k = 0; k < kLaneCount; ++k) c.of[k] = std::fma(a.of[k], b.of[k], c.of[k]);
    return c;
  }

 private:
  Scalar with_error(const Scalar& x) {
    return sine_error_ > 0 ? perturbed(x, static_cast<T>(sine_error_), signs_()) : x;
  }

  const Batch& batch_;
  double sine_error_;
  std::mt19937_64 signs_;
};

// The results of the text's operations up to `last`.
template <class T>
std::vector<Lanes<T>> executed(const StraightLine& lines, int last, const Batch& batch, double sine_error) {
  TextArithmetic<T> arithmetic(batch, sine_error);
  std::vector<Lanes<T>> values;
  execute(lines, last + 1, arithmetic, values);
  return values;
}

// The derivatives of a result by the results of all operations before it, in the order of the text. Divisions, roots
// and signs have none.
template <class T>
std::vector<Lanes<T>> derivatives(const StraightLine& lines, const std::vector<Lanes<T>>& values, int result) {
  std::vector<Lanes<T>> by(static_cast<std::size_t>(result) + 1);
  by.back() = filled(T(1));
  const auto at = [](auto& of, int k) -> auto& { return of[static_cast<std::size_t>(k)]; };
  for (int k = result; k >= 0; --k) {
    const Operation& operation = lines[k];
    const Lanes<T>& by_k = at(by, k);
    switch (operation.step) {
      case Step::negate:
        at(by, operation.a) -= by_k;
        break;
      case Step::add:
        at(by, operation.a) += by_k;
        at(by, operation.b) += by_k;
        break;
      case Step::subtract:
        at(by, operation.a) += by_k;
        at(by, operation.b) -= by_k;
        break;
      case Step::multiply:
        at(by, operation.a) += by_k * at(values, operation.b);
        at(by, operation.b) += by_k * at(values, operation.a);
        break;
      default:
        break;
    }
  }
  return by;
}

// Arithmetic for evaluate() that converts each constant once.
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

}  // namespace flatdyn

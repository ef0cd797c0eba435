// SPDX-License-Identifier: GPL-2.0-or-later
// Arithmetic over real numbers for evaluate(): the built-in floating-point types, and any multiprecision type whose
// sin, cos, sqrt and tanh are found by ADL.
#pragma once

#include <cmath>
#include <functional>
#include <utility>

#include "graph/evaluate.hpp"

namespace flatdyn {

template <class T>
class RealArithmetic {
 public:
  using Scalar = T;

  // `value_of` gives the value of each input: joint coordinates in rad or m, and so on.
  explicit RealArithmetic(std::function<T(const Input&)> value_of) : value_of_(std::move(value_of)) {}

  T constant(const Rational& value) const { return to_real<T>(value); }
  T input(const Input& input) const { return value_of_(input); }
  T divide(const T& a, const T& b) const { return a / b; }
  T sin(const Graph&, NodeId, const T& angle) const {
    using std::sin;
    return sin(angle);
  }
  T cos(const Graph&, NodeId, const T& angle) const {
    using std::cos;
    return cos(angle);
  }
  T sign(const T& x) const { return x > 0 ? T(1) : x < 0 ? T(-1) : T(0); }
  T sqrt(const T& x) const {
    using std::sqrt;
    return sqrt(x);
  }
  T tanh(const T& x) const {
    using std::tanh;
    return tanh(x);
  }

 private:
  std::function<T(const Input&)> value_of_;
};

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// The rational function that stands for tanh in emitted code, and in exact arithmetic, which has no other one. It is
// within 2e-17 of tanh, relatively, and exactly odd; at 0 it is 0.
//
// x is clamped to |x| <= 20, where tanh rounds to 1. Half of it, f, is a multiple of the y at which tanh(y) is the 10th
// convergent of Lambert's continued fraction, y P(u) / (P(u) + u R(u)) with u = y². Twice, tanh is doubled by
// tanh(2 y) = 2 tanh(y) / (1 + tanh(y)²). At first that is done for numerator and denominator apart, with their
// difference N, so that f tanh(f)/f = f - f N/Q loses no digits near 0. This takes two divisions; more doublings of
// shorter polynomials, or fewer of longer ones, would take more operations.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>

#include "graph/rational.hpp"

namespace flatdyn {

struct TanhConstants {
  struct Fraction {
    std::int64_t numerator, denominator;
    operator Rational() const { return Rational(numerator, denominator); }
  };

  // In ascending powers of u.
  static constexpr std::array<Fraction, 5> kP = {{{1, 1}, {8, 57}, {7, 1615}, {4, 101745}, {1, 11904165}}};
  static constexpr std::array<Fraction, 5> kR = {{{1, 3}, {7, 285}, {1, 2261}, {2, 915705}, {1, 654729075}}};
  static constexpr std::int64_t kLimit = 5;  // that of x/4

  // The operations that it takes.
  static constexpr int kAdditions = 18, kMultiplications = 21, kDivisions = 2;
};

// The function at x, with the operations of an Arithmetic as evaluate() takes it.
template <class Arithmetic, class S = typename Arithmetic::Scalar>
S rational_tanh(Arithmetic& arithmetic, const S& x) {
  const auto constant = [&](const Rational& value) -> S { return arithmetic.constant(value); };
  const auto sum = [](S a, const S& b) {
    a += b;
    return a;
  };
  const auto polynomial = [&](const auto& coefficients, const S& u) {
    S value = constant(coefficients.back());
    for (std::size_t k = coefficients.size() - 1; k-- > 0;) value = sum(value * u, constant(coefficients[k]));
    return value;
  };
  const S quarter = constant(Rational(1, 4)) * x;
  const S above = arithmetic.sign(sum(quarter, constant(-TanhConstants::kLimit)));
  const S below = arithmetic.sign(sum(quarter, constant(TanhConstants::kLimit)));
  const S within = sum(below, constant(-1) * above), beyond = sum(below, above);
  const S f = sum(within * quarter, constant(TanhConstants::kLimit) * beyond);
  const S u = constant(Rational(1, 4)) * (f * f);
  const S P = polynomial(TanhConstants::kP, u), N = u * polynomial(TanhConstants::kR, u), Q = sum(P, N);
  const S N_2 = sum(N * Q, u * (P * P)), Q_2 = sum(P * Q, N_2);
  const S t = sum(f, constant(-1) * (f * arithmetic.divide(N_2, Q_2)));
  return constant(2) * arithmetic.divide(t, sum(constant(1), t * t));
}

// tanh as the arithmetic has it, or the rational function.
template <class Arithmetic, class S = typename Arithmetic::Scalar>
S tanh_in(Arithmetic& arithmetic, const S& x) {
  if constexpr (requires {
                  { arithmetic.tanh(x) } -> std::convertible_to<S>;
                }) {
    return arithmetic.tanh(x);
  } else {
    return rational_tanh(arithmetic, x);
  }
}

}  // namespace flatdyn

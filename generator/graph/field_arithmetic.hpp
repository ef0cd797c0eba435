// SPDX-License-Identifier: GPL-2.0-or-later
// Exact evaluation at random points over a field F, which decides whether two functions are the same. An angle's cosine
// and sine are a random rational point of the unit circle, c = (1 - t²) / (1 + t²), s = 2t / (1 + t²), so that c² + s²
// = 1 and the addition theorems hold exactly. Two different polynomials differ at such a point with overwhelming
// probability if the field is large.
//
// All random values depend on the seed and on *values* only, never on nodes, so the same seed gives the same inputs,
// sines and signs in any two graphs. sign is an odd random function; that sign(2x) = sign(x) is known to the Graph
// only.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "graph/evaluate.hpp"

namespace flatdyn {

// The finaliser of splitmix64: mixes two numbers into a hash.
inline std::uint64_t splitmix64(std::uint64_t seed, std::uint64_t value) {
  std::uint64_t z = seed + 0x9e3779b97f4a7c15ULL * (value + 1);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

// The operations that a field must offer in addition to + - * / == and construction from 0 and 1; specialise this
// struct:
template <class F>
struct FieldTraits;
//   static F from(const Rational&)
//   static F draw(std::uint64_t bits)            a random element from random bits
//   static std::uint64_t key(const F&)           a hash of the value
//   static bool is_negative(const F&)            true for exactly one of x and -x, if x is not 0
//   static F sqrt(const F&)                      always the same one of the two roots; throws std::domain_error for a
//                                                non-square

template <class F>
class FieldArithmetic {
 public:
  using Scalar = F;
  using Traits = FieldTraits<F>;
  struct CirclePoint {
    F c, s;
  };

  explicit FieldArithmetic(std::uint64_t seed) : seed_(seed) {}

  // The same point with joint velocities of 0.
  FieldArithmetic at_rest() const {
    FieldArithmetic result = *this;
    result.at_rest_ = true;
    return result;
  }

  // The same point with unit quaternions in the four entries of q from each of `quaternions` on.
  FieldArithmetic with_quaternions(const std::vector<int>& quaternions) const {
    FieldArithmetic result = *this;
    result.quaternions_ = quaternions;
    return result;
  }

  F constant(const Rational& value) const { return Traits::from(value); }

  F input(const Input& input) const {
    if (at_rest_ && is_velocity(input.kind)) return F(0);
    if (input.kind == InputKind::q) {
      for (const int first : quaternions_) {
        if (first <= input.index && input.index < first + 4) return quaternion_entry(first, input.index - first);
      }
    }
    return drawn_input(input);
  }

  F divide(const F& a, const F& b) const { return a / b; }
  F sin(const Graph& graph, NodeId angle, const F& value) const { return point(graph, angle, value).s; }
  F cos(const Graph& graph, NodeId angle, const F& value) const { return point(graph, angle, value).c; }
  F sign(const F& x) const {
    if (x == F(0)) return F(0);
    return Traits::is_negative(x) ? -drawn(-x, 1) : drawn(x, 1);
  }

  // The square root. Half of all elements have none (std::domain_error); another point must then be drawn.
  F sqrt(const F& x) const { return Traits::sqrt(x); }

  // The cosine and sine of an angle that is not a sum, such as an input.
  CirclePoint point(const F& angle) const {
    if (angle == F(0)) return {F(1), F(0)};
    if (Traits::is_negative(angle)) return conjugate(point(-angle));
    for (std::uint64_t attempt = 2;; ++attempt) {
      const F t = drawn(angle, attempt);
      const F n = F(1) + t * t;
      if (n == F(0)) continue;  // in some fields t² = -1 has a solution
      return {(F(1) - t * t) / n, (t + t) / n};
    }
  }

  // The cosine and sine of factor · angle: a whole multiple by the addition theorems, any other one is an angle of its
  // own.
  CirclePoint point_of_multiple(const Rational& factor, const F& angle) const {
    constexpr int kMost = 1000000;
    if (denominator(factor) != 1 || abs(factor) > kMost) return point(constant(factor) * angle);
    const CirclePoint turned = multiple(point(angle), abs(factor).numerator_modulo(~std::uint64_t{0}));
    return factor < 0 ? conjugate(turned) : turned;
  }

  static CirclePoint add(const CirclePoint& a, const CirclePoint& b) {
    return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s};
  }

 private:
  F drawn_input(const Input& input) const {
    const auto kind = static_cast<std::uint64_t>(input.kind);
    return Traits::draw(splitmix64(seed_, (kind << 32) + static_cast<std::uint64_t>(input.index)));
  }

  // A rational point of the unit sphere: (1 - t², 2 t_x, 2 t_y, 2 t_z) / (1 + t²).
  F quaternion_entry(int first, int entry) const {
    F square(0), own(0);
    for (int k = 1; k < 4; ++k) {
      const F t = drawn_input({InputKind::q, first + k});
      square += t * t;
      if (k == entry) own = t;
    }
    return (entry == 0 ? F(1) - square : own + own) / (F(1) + square);
  }

  F drawn(const F& value, std::uint64_t purpose) const {
    return Traits::draw(splitmix64(splitmix64(seed_, Traits::key(value)), purpose));
  }

  static CirclePoint conjugate(const CirclePoint& a) { return {a.c, -a.s}; }
  static CirclePoint multiple(CirclePoint a, std::uint64_t times) {
    CirclePoint total = {F(1), F(0)};
    for (; times > 0; times >>= 1) {
      if ((times & 1) != 0) total = add(total, a);
      a = add(a, a);
    }
    return total;
  }

  // The cosine and sine of any angle, as a sum of multiples of inputs, or a multiple of anything else. The result does
  // not depend on how sums of angles are nested.
  CirclePoint point(const Graph& graph, NodeId angle, const F& value) const {
    CirclePoint total = {F(1), F(0)};
    add_angles(graph, angle, Rational(1), value, total);
    return total;
  }

  void add_angles(const Graph& graph, NodeId angle, const Rational& factor, const F& value, CirclePoint& total) const {
    const Node& node = graph[angle];
    if (node.op == Op::sum) {
      // The values of the terms are unknown here. Only inputs, whose values are drawn, and sums of them are expanded.
      if (is_linear_in_inputs(graph, angle)) {
        for (const Term& term : node.terms) add_angles(graph, term.node, factor * term.coefficient, F(0), total);
        total = add(total, point(constant(factor * node.value)));
        return;
      }
      if (is_scaled(node)) {
        const Rational& coefficient = node.terms[0].coefficient;
        return add_angles(graph, node.terms[0].node, factor * coefficient, value / constant(coefficient), total);
      }
    }
    const F base = node.op == Op::input ? input(node.input) : value;
    total = add(total, point_of_multiple(factor, base));
  }

  // Whether the angle is a sum, possibly nested, of inputs.
  static bool is_linear_in_inputs(const Graph& graph, NodeId angle) {
    const Node& node = graph[angle];
    if (node.op == Op::input) return true;
    if (node.op != Op::sum) return false;
    for (const Term& term : node.terms) {
      if (!is_linear_in_inputs(graph, term.node)) return false;
    }
    return true;
  }

  std::uint64_t seed_;
  bool at_rest_ = false;
  std::vector<int> quaternions_;  // entries of q
};

template <>
struct FieldTraits<Rational> {
  static Rational from(const Rational& value) { return value; }
  static Rational draw(std::uint64_t bits) {
    return Rational(static_cast<std::int64_t>(bits % 2001) - 1000, static_cast<std::int64_t>((bits >> 32) % 97) + 1);
  }
  static std::uint64_t key(const Rational& value) {
    constexpr std::uint64_t kPrime = 0xffffffffffffffc5UL;
    return splitmix64(value.numerator_modulo(kPrime), value.denominator_modulo(kPrime));
  }
  static bool is_negative(const Rational& value) { return value < 0; }
  static Rational sqrt(const Rational& value) {
    const Rational::Integer above = numerator(value), below = denominator(value);
    if (value < 0) throw std::domain_error("no square of a rational number");
    const Rational::Integer a = ::sqrt(above), b = ::sqrt(below);
    if (a * a != above || b * b != below) throw std::domain_error("no square of a rational number");
    return Rational(a, b);
  }
};

using RationalArithmetic = FieldArithmetic<Rational>;

}  // namespace flatdyn

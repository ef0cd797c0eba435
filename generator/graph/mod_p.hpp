// SPDX-License-Identifier: GPL-2.0-or-later
// The prime field GF(P): exact evaluation in constant time per operation.
#pragma once

#include <cstdint>
#include <stdexcept>

#include "graph/field_arithmetic.hpp"

namespace flatdyn {

inline constexpr std::uint64_t kMersenne61 = (std::uint64_t{1} << 61) - 1;  // the usual choice of P
inline constexpr std::uint64_t kPrime61b = (std::uint64_t{1} << 61) - 31;   // another prime
inline constexpr std::uint64_t kPrime61c = (std::uint64_t{1} << 61) - 45;

// An element of GF(P), 0 <= value < P < 2^63.
template <std::uint64_t P>
class ModP {
 public:
  constexpr ModP() = default;
  constexpr explicit ModP(std::uint64_t value) : value_(value % P) {}

  // The element equal to an exact number. Throws std::domain_error if P divides the denominator.
  static ModP from(const Rational& value) {
    const ModP numerator(value.numerator_modulo(P));
    const ModP denominator(value.denominator_modulo(P));
    return denominator.value_ == 1 ? numerator : numerator / denominator;
  }

  constexpr std::uint64_t value() const { return value_; }

  constexpr ModP& operator+=(ModP b) {
    value_ += b.value_;
    if (value_ >= P) value_ -= P;
    return *this;
  }
  constexpr ModP& operator-=(ModP b) { return *this += -b; }
  constexpr ModP& operator*=(ModP b) {
    value_ = reduced(static_cast<Wide>(value_) * b.value_);
    return *this;
  }
  ModP& operator/=(ModP b) { return *this *= b.inverse(); }

  constexpr ModP operator-() const { return ModP(P - value_); }
  friend constexpr ModP operator+(ModP a, ModP b) { return a += b; }
  friend constexpr ModP operator-(ModP a, ModP b) { return a -= b; }
  friend constexpr ModP operator*(ModP a, ModP b) { return a *= b; }
  friend ModP operator/(ModP a, ModP b) { return a /= b; }
  friend constexpr bool operator==(ModP a, ModP b) = default;

  // The inverse, by Fermat's little theorem. Throws std::domain_error for 0.
  ModP inverse() const {
    if (value_ == 0) throw std::domain_error("GF(p): division by zero");
    return raised_to(P - 2);
  }

  ModP raised_to(std::uint64_t exponent) const {
    ModP result(1), power = *this;
    for (; exponent > 0; exponent >>= 1) {
      if ((exponent & 1) != 0) result *= power;
      power *= power;
    }
    return result;
  }

  bool is_square() const { return value_ == 0 || raised_to((P - 1) / 2).value_ == 1; }

  // The smaller of the two square roots, by Tonelli and Shanks (Cohen, A Course in Computational Algebraic Number
  // Theory, algorithm 1.5.1). Throws std::domain_error if there is none.
  ModP sqrt() const {
    if (value_ == 0) return *this;
    if (!is_square()) throw std::domain_error("GF(p): no square");
    std::uint64_t odd = P - 1;
    while (odd % 2 == 0) odd /= 2;
    ModP generator(2);
    while (generator.is_square()) generator += ModP(1);
    generator = generator.raised_to(odd);
    ModP root = raised_to((odd + 1) / 2), rest = raised_to(odd);  // root² = rest · *this; the order of rest is 2^k
    while (rest.value_ != 1) {
      ModP step = generator;
      while ((rest * step * step).order() >= rest.order()) step *= step;
      root *= step;
      rest *= step * step;
    }
    return root.value_ < P - root.value_ ? root : -root;
  }

 private:
  __extension__ using Wide = unsigned __int128;

  // A product modulo P. For P = 2^61 - c with small c, 2^61 may be replaced by c, which needs no division.
  static constexpr std::uint64_t reduced(Wide product) {
    constexpr std::uint64_t kPower = std::uint64_t{1} << 61, kMostRest = 64;
    if constexpr (P < kPower && kPower - P < kMostRest) {
      const auto fold = [](Wide value) { return (value & (kPower - 1)) + (value >> 61) * (kPower - P); };
      const auto value = static_cast<std::uint64_t>(fold(fold(product)));
      return value >= P ? value - P : value;
    } else {
      return static_cast<std::uint64_t>(product % P);
    }
  }

  // The k for which the order of this element, a root of unity, is 2^k.
  int order() const {
    int k = 0;
    for (ModP power = *this; power.value_ != 1; power *= power) ++k;
    return k;
  }

  std::uint64_t value_ = 0;
};

template <std::uint64_t P>
struct FieldTraits<ModP<P>> {
  static ModP<P> from(const Rational& value) { return ModP<P>::from(value); }
  static ModP<P> draw(std::uint64_t bits) { return ModP<P>(bits); }
  static std::uint64_t key(ModP<P> value) { return value.value(); }
  static bool is_negative(ModP<P> value) { return value.value() > P / 2; }
  static ModP<P> sqrt(ModP<P> value) { return value.sqrt(); }
};

template <std::uint64_t P = kMersenne61>
using ModPArithmetic = FieldArithmetic<ModP<P>>;

}  // namespace flatdyn

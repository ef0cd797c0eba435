// SPDX-License-Identifier: GPL-2.0-or-later
// Exact numbers: coefficients and constants.
#pragma once

#include <gmpxx.h>
#include <compare>
#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <utility>

namespace flatdyn {

// A rational number in lowest terms. Numerator and denominator are held inline while both fit into 63 bits, as almost
// all coefficients do; larger ones are GMP's, and copies share them. Division by zero throws std::overflow_error.
class Rational {
 public:
  using Integer = mpz_class;

  Rational() = default;
  template <std::integral T>
  Rational(T value) : Rational(from_word(value)) {}
  Rational(const Integer& value);
  template <std::floating_point T>
  explicit Rational(T value) : Rational(of_big(Big(value))) {}  // exactly this number
  Rational(const Integer& numerator, const Integer& denominator);
  template <std::integral T, std::integral U>
  Rational(T numerator, U denominator) : Rational(Rational(numerator) / Rational(denominator)) {}
  explicit Rational(const std::string& text);  // "-3", "22/7"

  Rational(const Rational& other) : numerator_(other.numerator_), denominator_(other.denominator_) {
    if (!is_inline()) retain();
  }
  Rational(Rational&& other) noexcept : numerator_(other.numerator_), denominator_(other.denominator_) {
    other.numerator_ = 0;
    other.denominator_ = 1;
  }
  Rational& operator=(const Rational& other) { return *this = Rational(other); }
  Rational& operator=(Rational&& other) noexcept {
    std::swap(numerator_, other.numerator_);
    std::swap(denominator_, other.denominator_);
    return *this;
  }
  ~Rational() {
    if (!is_inline()) release();
  }

  Rational& operator+=(const Rational& b);
  Rational& operator-=(const Rational& b) { return *this += -b; }
  Rational& operator*=(const Rational& b);
  Rational& operator/=(const Rational& b) { return *this *= b.reciprocal(); }

  Rational operator-() const;
  Rational reciprocal() const;

  friend Rational operator+(Rational a, const Rational& b) { return std::move(a += b); }
  friend Rational operator-(Rational a, const Rational& b) { return std::move(a -= b); }
  friend Rational operator*(Rational a, const Rational& b) { return std::move(a *= b); }
  friend Rational operator/(Rational a, const Rational& b) { return std::move(a /= b); }

  friend bool operator==(const Rational& a, const Rational& b) {
    if (a.denominator_ != b.denominator_) return false;  // 0 only if the number is not inline
    return a.numerator_ == b.numerator_ || (!a.is_inline() && a.big() == b.big());
  }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);

  int sign() const;
  bool is_zero() const { return numerator_ == 0; }                                             // a pointer is not 0
  bool is_unit() const { return denominator_ == 1 && (numerator_ == 1 || numerator_ == -1); }  // whether it is ±1
  bool has_size_of(const Rational& b) const;                                                   // |this| = |b|
  bool has_reciprocal_size_of(const Rational& b) const;                                        // |this · b| = 1
  std::string str() const;                                                                     // "-3", "22/7"
  std::size_t hash() const;
  std::size_t bits() const;  // of the numerator and the denominator together

  double truncated() const { return (is_inline() ? as_big() : big()).get_d(); }  // rounded towards zero

  friend Integer numerator(const Rational& value);
  friend Integer denominator(const Rational& value);
  friend Rational abs(const Rational& value) { return value.sign() < 0 ? -value : value; }

  // Numerator and denominator modulo a word, 0 <= result < modulus.
  std::uint64_t numerator_modulo(std::uint64_t modulus) const;
  std::uint64_t denominator_modulo(std::uint64_t modulus) const;

 private:
  using Big = mpq_class;
  __extension__ using Wide = __int128;
  struct Shared;  // a Big, how many numbers share it, and its hash

  static Rational of_big(Big value);

  template <std::integral T>
  static Rational from_word(T value) {
    if (std::in_range<std::int64_t>(value) && !std::cmp_equal(value, INT64_MIN)) {
      Rational result;
      result.numerator_ = static_cast<std::int64_t>(value);
      return result;
    }
    return Rational(std::is_signed_v<T> ? Integer(static_cast<long>(value))
                                        : Integer(static_cast<unsigned long>(value)));
  }

  bool is_inline() const { return denominator_ != 0; }
  Shared* shared() const { return reinterpret_cast<Shared*>(numerator_); }
  const Big& big() const;
  Big as_big() const;
  void retain() const;
  void release() const;
  // Makes this a / b, whose terms are the lowest; false if they do not fit inline.
  bool set(Wide a, Wide b);

  // Where the denominator is 0, the numerator is the address of a Shared.
  std::int64_t numerator_ = 0, denominator_ = 1;
};

// The T nearest to an exact number: a built-in type, or one that is made from mpz_srcptr.
template <class T>
T to_real(const Rational& value) {
  return T(numerator(value).get_mpz_t()) / T(denominator(value).get_mpz_t());
}
template <>
double to_real(const Rational& value);
template <>
float to_real(const Rational& value);
template <>
long double to_real(const Rational& value);

std::ostream& operator<<(std::ostream& stream, const Rational& value);

}  // namespace flatdyn

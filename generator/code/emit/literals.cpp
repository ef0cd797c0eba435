// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/literals.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {

namespace {

using Integer = Rational::Integer;

constexpr int kMantissaBits = std::numeric_limits<double>::digits;
constexpr int kSmallestExponent =
    std::numeric_limits<double>::min_exponent - kMantissaBits;  // exponent of a subnormal's last bit

int bits(const Integer& a) { return static_cast<int>(mpz_sizeinbase(a.get_mpz_t(), 2)); }

// a · 2^count, count >= 0.
Integer shifted(const Integer& a, int count) { return a << static_cast<mp_bitcnt_t>(count); }

// floor(log2(a / b)) for positive a and b.
int floor_log2(const Integer& a, const Integer& b) {
  const int estimate = bits(a) - bits(b);  // exact, or one too large
  const bool too_many = estimate >= 0 ? a < shifted(b, estimate) : shifted(a, -estimate) < b;
  return too_many ? estimate - 1 : estimate;
}

// a / b · 2^-exponent, rounded to an integer, half to even.
Integer rounded_quotient(Integer a, Integer b, int exponent) {
  if (exponent < 0) {
    a = shifted(a, -exponent);
  } else {
    b = shifted(b, exponent);
  }
  Integer quotient, remainder;
  mpz_fdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), a.get_mpz_t(), b.get_mpz_t());
  const int half = cmp(Integer(2 * remainder), b);
  const bool up = half > 0 || (half == 0 && mpz_odd_p(quotient.get_mpz_t()) != 0);
  return up ? Integer(quotient + 1) : quotient;
}

}  // namespace

double nearest_double(const Rational& value) {
  if (value == 0) return 0;
  const Integer a = abs(numerator(value));
  const Integer b = denominator(value);
  const int exponent = std::max(floor_log2(a, b) - (kMantissaBits - 1), kSmallestExponent);
  const double mantissa = rounded_quotient(a, b, exponent).get_d();  // exact: at most 2^53
  const double magnitude = std::ldexp(mantissa, exponent);
  if (std::isinf(magnitude) || magnitude < std::numeric_limits<double>::denorm_min()) {
    throw Failure(FailureKind::input,
                  "a constant of the model is out of the range of double, about 2^" + std::to_string(floor_log2(a, b)),
                  "write the robot in units that keep its numbers between 1e-300 and 1e300");
  }
  return value < 0 ? -magnitude : magnitude;
}

float float_of(const Rational& value) {
  const double exact = nearest_double(value);
  const auto rounded = static_cast<float>(exact);
  if (std::isinf(rounded)) {
    throw Failure(FailureKind::input,
                  "a constant of the code is " + decimal_literal(exact) + ", which is infinite in float",
                  "generate code in double, or write the robot in units in which masses, lengths and moments of "
                  "inertia are nearer to 1");
  }
  return rounded;
}

namespace {

// The shortest decimal of either type, always in floating-point form.
template <class T>
std::string shortest_decimal(T value) {
  constexpr T kSmallestFixed = T(1e-5);
  constexpr T kLargestFixed = T(1e15);
  const T magnitude = std::abs(value);
  const bool fixed = magnitude < kSmallestFixed ? !(magnitude > 0) : magnitude < kLargestFixed;
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                    fixed ? std::chars_format::fixed : std::chars_format::scientific);
  std::string text(buffer.data(), result.ptr);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

}  // namespace

std::string decimal_literal(double value) { return shortest_decimal(value); }

std::string float_literal(const Rational& value) { return shortest_decimal(float_of(value)) + "f"; }

}  // namespace flatdyn

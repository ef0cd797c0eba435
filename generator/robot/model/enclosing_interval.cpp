// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/enclosing_interval.hpp"

#include <array>
#include <utility>

namespace flatdyn {

EnclosingInterval EnclosingInterval::of(const Rational& value, long bits) {
  EnclosingInterval result(bits);
  mpq_t fraction;
  mpq_init(fraction);
  mpz_set(mpq_numref(fraction), numerator(value).get_mpz_t());
  mpz_set(mpq_denref(fraction), denominator(value).get_mpz_t());
  mpfr_set_q(result.low_.get(), fraction, MPFR_RNDD);
  mpfr_set_q(result.high_.get(), fraction, MPFR_RNDU);
  mpq_clear(fraction);
  return result;
}

EnclosingInterval EnclosingInterval::of_pi(long bits) {
  EnclosingInterval result(bits);
  mpfr_const_pi(result.low_.get(), MPFR_RNDD);
  mpfr_const_pi(result.high_.get(), MPFR_RNDU);
  return result;
}

int EnclosingInterval::sign() const {
  if (mpfr_nan_p(low_.get()) != 0 || mpfr_nan_p(high_.get()) != 0) return 0;
  if (mpfr_sgn(low_.get()) > 0) return 1;
  return mpfr_sgn(high_.get()) < 0 ? -1 : 0;
}

EnclosingInterval EnclosingInterval::operator+(const EnclosingInterval& b) const {
  EnclosingInterval result(bits());
  mpfr_add(result.low_.get(), low_.get(), b.low_.get(), MPFR_RNDD);
  mpfr_add(result.high_.get(), high_.get(), b.high_.get(), MPFR_RNDU);
  return result;
}

EnclosingInterval EnclosingInterval::operator*(const EnclosingInterval& b) const {
  const std::array<std::pair<mpfr_srcptr, mpfr_srcptr>, 4> ends = {{{low_.get(), b.low_.get()},
                                                                    {low_.get(), b.high_.get()},
                                                                    {high_.get(), b.low_.get()},
                                                                    {high_.get(), b.high_.get()}}};
  EnclosingInterval result(bits());
  WideFloat product(bits());
  mpfr_set_inf(result.low_.get(), 1);
  mpfr_set_inf(result.high_.get(), -1);
  for (const auto& [x, y] : ends) {
    mpfr_mul(product.get(), x, y, MPFR_RNDD);
    if (mpfr_nan_p(product.get()) != 0) mpfr_set_inf(product.get(), -1);
    mpfr_min(result.low_.get(), result.low_.get(), product.get(), MPFR_RNDD);
    mpfr_mul(product.get(), x, y, MPFR_RNDU);
    if (mpfr_nan_p(product.get()) != 0) mpfr_set_inf(product.get(), 1);
    mpfr_max(result.high_.get(), result.high_.get(), product.get(), MPFR_RNDU);
  }
  return result;
}

std::optional<EnclosingInterval> EnclosingInterval::reciprocal() const {
  if (sign() == 0) return std::nullopt;
  EnclosingInterval result(bits());
  mpfr_ui_div(result.low_.get(), 1, high_.get(), MPFR_RNDD);
  mpfr_ui_div(result.high_.get(), 1, low_.get(), MPFR_RNDU);
  return result;
}

std::optional<EnclosingInterval> EnclosingInterval::power(long exponent) const {
  if (exponent < 0) {
    const std::optional<EnclosingInterval> inverse = reciprocal();
    return inverse ? inverse->power(-exponent) : std::nullopt;
  }
  EnclosingInterval result = of(1, bits()), square = *this;
  for (long rest = exponent; rest > 0; rest /= 2) {
    if (rest % 2 == 1) result = result * square;
    if (rest > 1) square = square * square;
  }
  return result;
}

std::optional<EnclosingInterval> EnclosingInterval::root(unsigned long n) const {
  if (sign() < 0) return std::nullopt;
  EnclosingInterval result(bits());
  if (mpfr_sgn(low_.get()) <= 0) {
    mpfr_set_zero(result.low_.get(), 1);
  } else {
    mpfr_rootn_ui(result.low_.get(), low_.get(), n, MPFR_RNDD);
  }
  mpfr_rootn_ui(result.high_.get(), high_.get(), n, MPFR_RNDU);
  return result;
}

}  // namespace flatdyn

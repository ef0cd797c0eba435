// SPDX-License-Identifier: GPL-2.0-or-later
// Intervals that contain an exact number for certain: their ends are rounded outwards, to any number of bits.
#pragma once

#include <mpfr.h>

#include <optional>

#include "graph/rational.hpp"

namespace flatdyn {

// A float of MPFR.
class WideFloat {
 public:
  explicit WideFloat(long bits) { mpfr_init2(value_, bits); }
  WideFloat(const WideFloat& other) {
    mpfr_init2(value_, mpfr_get_prec(other.value_));
    mpfr_set(value_, other.value_, MPFR_RNDN);
  }
  WideFloat& operator=(WideFloat other) {
    mpfr_swap(value_, other.value_);
    return *this;
  }
  ~WideFloat() { mpfr_clear(value_); }

  mpfr_ptr get() { return value_; }
  mpfr_srcptr get() const { return value_; }

 private:
  mpfr_t value_;
};

class EnclosingInterval {
 public:
  explicit EnclosingInterval(long bits) : low_(bits), high_(bits) {}

  static EnclosingInterval of(const Rational& value, long bits);
  static EnclosingInterval of_pi(long bits);

  // -1 or 1 if the whole interval has that sign, else 0.
  int sign() const;

  EnclosingInterval operator+(const EnclosingInterval& b) const;
  EnclosingInterval operator*(const EnclosingInterval& b) const;
  std::optional<EnclosingInterval> reciprocal() const;           // nothing if 0 is in it
  std::optional<EnclosingInterval> power(long exponent) const;   // by an integer
  std::optional<EnclosingInterval> root(unsigned long n) const;  // of what is not negative; nothing if it is

 private:
  long bits() const { return mpfr_get_prec(low_.get()); }

  WideFloat low_, high_;
};

}  // namespace flatdyn

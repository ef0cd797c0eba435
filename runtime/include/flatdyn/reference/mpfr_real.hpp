// SPDX-License-Identifier: BSD-3-Clause
// A real number of MPFR with a fixed number of bits, over MPFR's C interface alone: general libraries of numbers take
// seconds to compile in every source that sees them. real50.hpp makes it a scalar of Eigen.
#pragma once

#include <mpfr.h>

#include <limits>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace flatdyn::reference {

// A binary floating-point number with kBits bits of mantissa and MPFR's range of exponents. Every operation gives the
// number nearest to the exact result, halves to even: + - * / sqrt, sines and cosines alike. Lives where it is
// declared, without memory of its own.
template <int kBits>
class MpfrReal {
 public:
  // While one is in scope, the numbers that its thread makes have `bits` bits, at most kBits, and copies are rounded to
  // them. So a function over 24 bits loses what it loses in float, but for what exceeds float's range of exponents.
  class Precision {
   public:
    explicit Precision(int bits) : outer_(bits_) { bits_ = bits < kBits ? bits : kBits; }
    ~Precision() { bits_ = outer_; }
    Precision(const Precision&) = delete;
    Precision& operator=(const Precision&) = delete;

   private:
    int outer_;
  };

  MpfrReal() : MpfrReal(MPFR_ZERO_KIND, 0) {}
  MpfrReal(const MpfrReal& other) { copy(other); }
  MpfrReal& operator=(const MpfrReal& other) {
    copy(other);
    return *this;
  }
  ~MpfrReal() = default;

  template <class T, std::enable_if_t<std::is_arithmetic_v<T>, int> = 0>
  MpfrReal(T value) : MpfrReal() {
    static_assert(std::is_floating_point_v<T> || sizeof(T) <= sizeof(long));
    if constexpr (std::is_same_v<T, long double>) {
      mpfr_set_ld(number_, value, MPFR_RNDN);
    } else if constexpr (std::is_floating_point_v<T>) {
      mpfr_set_d(number_, value, MPFR_RNDN);
    } else if constexpr (std::is_signed_v<T>) {
      mpfr_set_si(number_, value, MPFR_RNDN);
    } else {
      mpfr_set_ui(number_, value, MPFR_RNDN);
    }
  }
  template <int kOtherBits>
  explicit MpfrReal(const MpfrReal<kOtherBits>& other) : MpfrReal() {
    mpfr_set(number_, other.mpfr(), MPFR_RNDN);
  }
  explicit MpfrReal(mpz_srcptr integer) : MpfrReal() { mpfr_set_z(number_, integer, MPFR_RNDN); }
  // A decimal, as "-1.5e-3"; NaN for anything else.
  explicit MpfrReal(const char* decimal) : MpfrReal() {
    constexpr int kBase = 10;
    if (mpfr_set_str(number_, decimal, kBase, MPFR_RNDN) != 0) mpfr_set_nan(number_);
  }
  explicit MpfrReal(const std::string& decimal) : MpfrReal(decimal.c_str()) {}

  // The T nearest to this number.
  template <class T>
  T convert_to() const {
    if constexpr (std::is_same_v<T, double>) {
      return mpfr_get_d(number_, MPFR_RNDN);
    } else if constexpr (std::is_same_v<T, float>) {
      return mpfr_get_flt(number_, MPFR_RNDN);
    } else if constexpr (std::is_same_v<T, long double>) {
      return mpfr_get_ld(number_, MPFR_RNDN);
    } else {
      return T(*this);
    }
  }
  template <class T, std::enable_if_t<std::is_floating_point_v<T>, int> = 0>
  explicit operator T() const {
    return convert_to<T>();
  }

  // `digits` significant digits, without trailing zeros, as C's %g writes them.
  std::string str(int digits) const {
    std::vector<char> text(static_cast<std::size_t>(mpfr_snprintf(nullptr, 0, "%.*Rg", digits, number_)) + 1);
    mpfr_snprintf(text.data(), text.size(), "%.*Rg", digits, number_);
    return text.data();
  }
  friend std::ostream& operator<<(std::ostream& stream, const MpfrReal& x) {
    return stream << x.str(static_cast<int>(stream.precision()));
  }

  mpfr_srcptr mpfr() const { return number_; }

  MpfrReal& operator+=(const MpfrReal& b) { return set(mpfr_add(number_, number_, b.number_, MPFR_RNDN)); }
  MpfrReal& operator-=(const MpfrReal& b) { return set(mpfr_sub(number_, number_, b.number_, MPFR_RNDN)); }
  MpfrReal& operator*=(const MpfrReal& b) { return set(mpfr_mul(number_, number_, b.number_, MPFR_RNDN)); }
  MpfrReal& operator/=(const MpfrReal& b) { return set(mpfr_div(number_, number_, b.number_, MPFR_RNDN)); }

  MpfrReal operator-() const { return of(mpfr_neg, *this); }
  MpfrReal operator+() const { return *this; }
  friend MpfrReal operator+(const MpfrReal& a, const MpfrReal& b) { return of(mpfr_add, a, b); }
  friend MpfrReal operator-(const MpfrReal& a, const MpfrReal& b) { return of(mpfr_sub, a, b); }
  friend MpfrReal operator*(const MpfrReal& a, const MpfrReal& b) { return of(mpfr_mul, a, b); }
  friend MpfrReal operator/(const MpfrReal& a, const MpfrReal& b) { return of(mpfr_div, a, b); }

  // As IEEE 754 compares: NaN equals nothing.
  friend bool operator==(const MpfrReal& a, const MpfrReal& b) { return mpfr_equal_p(a.number_, b.number_) != 0; }
  friend bool operator!=(const MpfrReal& a, const MpfrReal& b) { return mpfr_equal_p(a.number_, b.number_) == 0; }
  friend bool operator<(const MpfrReal& a, const MpfrReal& b) { return mpfr_less_p(a.number_, b.number_) != 0; }
  friend bool operator>(const MpfrReal& a, const MpfrReal& b) { return mpfr_greater_p(a.number_, b.number_) != 0; }
  friend bool operator<=(const MpfrReal& a, const MpfrReal& b) { return mpfr_lessequal_p(a.number_, b.number_) != 0; }
  friend bool operator>=(const MpfrReal& a, const MpfrReal& b) {
    return mpfr_greaterequal_p(a.number_, b.number_) != 0;
  }

  friend MpfrReal abs(const MpfrReal& x) { return of(mpfr_abs, x); }
  friend MpfrReal sqrt(const MpfrReal& x) { return of(mpfr_sqrt, x); }
  friend MpfrReal sin(const MpfrReal& x) { return of(mpfr_sin, x); }
  friend MpfrReal tanh(const MpfrReal& x) { return of(mpfr_tanh, x); }
  friend MpfrReal cos(const MpfrReal& x) { return of(mpfr_cos, x); }
  friend MpfrReal acos(const MpfrReal& x) { return of(mpfr_acos, x); }
  friend MpfrReal exp(const MpfrReal& x) { return of(mpfr_exp, x); }
  friend MpfrReal atan2(const MpfrReal& y, const MpfrReal& x) { return of(mpfr_atan2, y, x); }
  friend MpfrReal copysign(const MpfrReal& x, const MpfrReal& sign) { return of(mpfr_copysign, x, sign); }
  friend MpfrReal floor(const MpfrReal& x) {
    MpfrReal result;
    mpfr_floor(result.number_, x.number_);
    return result;
  }
  friend bool isnan(const MpfrReal& x) { return mpfr_nan_p(x.number_) != 0; }
  friend bool isinf(const MpfrReal& x) { return mpfr_inf_p(x.number_) != 0; }
  friend bool isfinite(const MpfrReal& x) { return mpfr_number_p(x.number_) != 0; }

  // How many bits the numbers made now have.
  static int bits() { return bits_; }
  // 2^exponent.
  static MpfrReal power_of_two(mpfr_exp_t exponent) {
    MpfrReal result;
    mpfr_set_ui_2exp(result.number_, 1, exponent, MPFR_RNDN);
    return result;
  }
  static MpfrReal infinity() { return MpfrReal(MPFR_INF_KIND, 0); }
  static MpfrReal nan() { return MpfrReal(MPFR_NAN_KIND, 0); }

 private:
  static constexpr int kLimbs = (kBits + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS;

  MpfrReal(int kind, mpfr_exp_t exponent) { mpfr_custom_init_set(number_, kind, exponent, bits_, mantissa_); }

  void copy(const MpfrReal& other) {
    const mpfr_prec_t bits = mpfr_get_prec(other.number_);
    for (int k = 0; k < kLimbs; ++k) mantissa_[k] = other.mantissa_[k];
    mpfr_custom_init_set(number_, mpfr_custom_get_kind(other.number_), mpfr_custom_get_exp(other.number_), bits,
                         mantissa_);
    if (bits > bits_) mpfr_prec_round(number_, bits_, MPFR_RNDN);
  }
  MpfrReal& set(int /* whether MPFR rounded up or down */) { return *this; }

  template <class Function, class... Arguments>
  static MpfrReal of(Function function, const Arguments&... x) {
    MpfrReal result;
    function(result.number_, x.number_..., MPFR_RNDN);
    return result;
  }

  inline static thread_local int bits_ = kBits;  // of numbers made now

  mp_limb_t mantissa_[kLimbs];
  mpfr_t number_;
};

// 100 digits, and a guard digit's bits.
using Digits100 = MpfrReal<334>;

}  // namespace flatdyn::reference

template <int kBits>
struct std::numeric_limits<flatdyn::reference::MpfrReal<kBits>> : std::numeric_limits<double> {
  using Real = flatdyn::reference::MpfrReal<kBits>;
  static constexpr int digits = kBits;
  static constexpr int digits10 = static_cast<int>((kBits - 1) * 30103 / 100000);
  static constexpr int max_digits10 = static_cast<int>(kBits * 30103 / 100000) + 2;
  static constexpr bool is_iec559 = false;
  static constexpr bool has_denorm_loss = false;
  static constexpr std::float_denorm_style has_denorm = std::denorm_absent;
  static Real epsilon() { return Real::power_of_two(1 - Real::bits()); }
  static Real min() { return Real::power_of_two(mpfr_get_emin() - 1); }
  static Real max() { return Real::power_of_two(mpfr_get_emax() - 1) * (2 - epsilon()); }
  static Real lowest() { return -max(); }
  static Real infinity() { return Real::infinity(); }
  static Real quiet_NaN() { return Real::nan(); }
};

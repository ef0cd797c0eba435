// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/rational.hpp"

#include <atomic>
#include <bit>
#include <numeric>
#include <ostream>
#include <stdexcept>

#include "flatdyn/reference/mpfr_real.hpp"

namespace flatdyn {

using Integer = Rational::Integer;

static_assert(sizeof(std::int64_t) >= sizeof(void*) && sizeof(long) == sizeof(std::int64_t));

namespace {

bool fits(const mpz_t integer) { return mpz_fits_slong_p(integer) != 0 && mpz_get_si(integer) != INT64_MIN; }

std::size_t mixed_hash(std::size_t seed, std::size_t value) {
  return seed ^ (value + 0x9e3779b97f4a7c15ULL + (seed << 12) + (seed >> 4));
}

std::size_t hash_of_integer(const mpz_t integer) {
  std::size_t hash = static_cast<std::size_t>(mpz_sgn(integer) + 1);
  for (std::size_t k = 0; k < mpz_size(integer); ++k) {
    hash = mixed_hash(hash, static_cast<std::size_t>(mpz_getlimbn(integer, static_cast<mp_size_t>(k))));
  }
  return hash;
}

std::size_t hash_of_fraction(const mpq_t value) {
  return mixed_hash(hash_of_integer(mpq_numref(value)), hash_of_integer(mpq_denref(value)));
}

constexpr int kDecimal = 10;  // GMP would take a leading 0 for base 8

mpq_class lowest(mpq_class fraction) {
  if (fraction.get_den() == 0) throw std::overflow_error("division by zero");
  fraction.canonicalize();
  return fraction;
}

std::uint64_t size_of_word(std::int64_t word) { return static_cast<std::uint64_t>(word < 0 ? -word : word); }

}  // namespace

struct Rational::Shared {
  explicit Shared(Big number) : value(std::move(number)), hash(hash_of_fraction(value.get_mpq_t())) {}

  Big value;
  std::size_t hash;
  std::atomic<std::int64_t> owners = 1;
};

Rational::Rational(const Integer& value) : Rational(of_big(Big(value))) {}

Rational::Rational(const Integer& numerator, const Integer& denominator)
    : Rational(of_big(lowest(Big(numerator, denominator)))) {}

Rational::Rational(const std::string& text) : Rational(of_big(lowest(Big(text, kDecimal)))) {}

Rational Rational::of_big(Big value) {
  Rational result;
  mpq_srcptr fraction = value.get_mpq_t();
  if (fits(mpq_numref(fraction)) && fits(mpq_denref(fraction))) {
    result.numerator_ = mpz_get_si(mpq_numref(fraction));
    result.denominator_ = mpz_get_si(mpq_denref(fraction));
  } else {
    result.numerator_ = reinterpret_cast<std::int64_t>(new Shared(std::move(value)));
    result.denominator_ = 0;
  }
  return result;
}

const Rational::Big& Rational::big() const { return shared()->value; }

Rational::Big Rational::as_big() const {
  Big result;
  mpz_set_si(mpq_numref(result.get_mpq_t()), numerator_);
  mpz_set_si(mpq_denref(result.get_mpq_t()), denominator_);
  return result;
}

void Rational::retain() const { shared()->owners.fetch_add(1, std::memory_order_relaxed); }

void Rational::release() const {
  if (shared()->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) delete shared();
}

bool Rational::set(Wide a, Wide b) {
  if (a > INT64_MAX || a < -INT64_MAX || b > INT64_MAX) return false;
  numerator_ = static_cast<std::int64_t>(a);
  denominator_ = static_cast<std::int64_t>(b);
  return true;
}

// a/b + c/d with g = gcd(b, d): only g may have a divisor in common with the numerator (Knuth, TAOCP 2, 4.5.1).
Rational& Rational::operator+=(const Rational& other) {
  if (is_inline() && other.is_inline()) {
    const std::int64_t g = denominator_ == 1 ? 1 : std::gcd(denominator_, other.denominator_);
    const Wide sum = static_cast<Wide>(numerator_) * (other.denominator_ / g) +
                     static_cast<Wide>(other.numerator_) * (denominator_ / g);
    const std::int64_t h = g == 1 ? 1 : std::gcd(static_cast<std::int64_t>(sum % g), g);
    if (set(sum / h, static_cast<Wide>(denominator_ / g) * (other.denominator_ / h))) return *this;
  }
  Big sum = is_inline() ? as_big() : big();
  sum += other.is_inline() ? other.as_big() : other.big();
  return *this = of_big(std::move(sum));
}

Rational& Rational::operator*=(const Rational& other) {
  if (is_inline() && other.is_inline()) {
    const std::int64_t g = other.denominator_ == 1 ? 1 : std::gcd(numerator_, other.denominator_);
    const std::int64_t h = denominator_ == 1 ? 1 : std::gcd(other.numerator_, denominator_);
    if (set(static_cast<Wide>(numerator_ / g) * (other.numerator_ / h),
            static_cast<Wide>(denominator_ / h) * (other.denominator_ / g)))
      return *this;
  }
  if (other.is_unit()) return other.numerator_ < 0 ? *this = -*this : *this;
  if (is_unit()) return *this = numerator_ < 0 ? -other : other;
  Big product = is_inline() ? as_big() : big();
  product *= other.is_inline() ? other.as_big() : other.big();
  return *this = of_big(std::move(product));
}

Rational Rational::operator-() const {
  if (!is_inline()) return of_big(Big(-big()));
  Rational result;
  result.numerator_ = -numerator_;
  result.denominator_ = denominator_;
  return result;
}

Rational Rational::reciprocal() const {
  if (is_zero()) throw std::overflow_error("division by zero");
  if (!is_inline()) {
    Big inverse;
    mpq_inv(inverse.get_mpq_t(), big().get_mpq_t());
    return of_big(std::move(inverse));
  }
  Rational result;
  result.numerator_ = numerator_ < 0 ? -denominator_ : denominator_;
  result.denominator_ = numerator_ < 0 ? -numerator_ : numerator_;
  return result;
}

std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  if (a.is_inline() && b.is_inline()) {
    if (a.denominator_ == b.denominator_) return a.numerator_ <=> b.numerator_;
    const auto left = static_cast<Rational::Wide>(a.numerator_) * b.denominator_;
    const auto right = static_cast<Rational::Wide>(b.numerator_) * a.denominator_;
    return left < right ? std::strong_ordering::less : std::strong_ordering::greater;
  }
  if (a == b) return std::strong_ordering::equal;
  return cmp(a.is_inline() ? a.as_big() : a.big(), b.is_inline() ? b.as_big() : b.big()) <=> 0;
}

int Rational::sign() const {
  if (!is_inline()) return sgn(big());
  return (numerator_ > 0) - (numerator_ < 0);
}

bool Rational::has_size_of(const Rational& b) const {
  if (denominator_ != b.denominator_) return false;
  if (is_inline()) return numerator_ == b.numerator_ || numerator_ == -b.numerator_;
  mpq_srcptr x = big().get_mpq_t(), y = b.big().get_mpq_t();
  return mpz_cmpabs(mpq_numref(x), mpq_numref(y)) == 0 && mpz_cmp(mpq_denref(x), mpq_denref(y)) == 0;
}

bool Rational::has_reciprocal_size_of(const Rational& b) const {
  if (is_inline() != b.is_inline()) return false;
  if (is_inline()) {
    return size_of_word(numerator_) == size_of_word(b.denominator_) &&
           size_of_word(b.numerator_) == size_of_word(denominator_);
  }
  mpq_srcptr x = big().get_mpq_t(), y = b.big().get_mpq_t();
  return mpz_cmpabs(mpq_numref(x), mpq_denref(y)) == 0 && mpz_cmpabs(mpq_denref(x), mpq_numref(y)) == 0;
}

std::string Rational::str() const {
  if (!is_inline()) return big().get_str();
  const std::string above = std::to_string(numerator_);
  return denominator_ == 1 ? above : above + "/" + std::to_string(denominator_);
}

std::size_t Rational::hash() const {
  if (!is_inline()) return shared()->hash;
  return mixed_hash(static_cast<std::size_t>(numerator_), static_cast<std::size_t>(denominator_));
}

std::size_t Rational::bits() const {
  if (!is_inline())
    return mpz_sizeinbase(mpq_numref(big().get_mpq_t()), 2) + mpz_sizeinbase(mpq_denref(big().get_mpq_t()), 2);
  return static_cast<std::size_t>(std::bit_width(size_of_word(numerator_)) +
                                  std::bit_width(size_of_word(denominator_)));
}

Integer numerator(const Rational& value) {
  return value.is_inline() ? Integer(value.numerator_) : value.big().get_num();
}

Integer denominator(const Rational& value) {
  return value.is_inline() ? Integer(value.denominator_) : value.big().get_den();
}

std::uint64_t Rational::numerator_modulo(std::uint64_t modulus) const {
  if (!is_inline()) return mpz_fdiv_ui(mpq_numref(big().get_mpq_t()), modulus);
  const std::uint64_t size = size_of_word(numerator_) % modulus;
  return numerator_ < 0 && size > 0 ? modulus - size : size;
}

std::uint64_t Rational::denominator_modulo(std::uint64_t modulus) const {
  if (!is_inline()) return mpz_fdiv_ui(mpq_denref(big().get_mpq_t()), modulus);
  return static_cast<std::uint64_t>(denominator_) % modulus;
}

// Built-in numbers are rounded from 100 digits, since GMP's own conversion truncates.
template <>
double to_real(const Rational& value) {
  return to_real<reference::Digits100>(value).convert_to<double>();
}

template <>
float to_real(const Rational& value) {
  return to_real<reference::Digits100>(value).convert_to<float>();
}

template <>
long double to_real(const Rational& value) {
  return to_real<reference::Digits100>(value).convert_to<long double>();
}

std::ostream& operator<<(std::ostream& stream, const Rational& value) { return stream << value.str(); }

}  // namespace flatdyn

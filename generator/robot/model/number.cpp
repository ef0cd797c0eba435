// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/number.hpp"

#include <cln/cln.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "robot/model/exact_sign.hpp"

namespace flatdyn {

Vec3 zero_vector() { return {0, 0, 0}; }

Mat3 zero_matrix() { return {zero_vector(), zero_vector(), zero_vector()}; }

Mat3 identity_matrix() { return {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}; }

Vec3 operator+(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

Vec3 operator-(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vec3 operator*(const Number& a, const Vec3& b) { return {a * b[0], a * b[1], a * b[2]}; }

Number dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Mat3 operator+(const Mat3& a, const Mat3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

Vec3 operator*(const Mat3& a, const Vec3& b) { return {dot(a[0], b), dot(a[1], b), dot(a[2], b)}; }

Mat3 transpose(const Mat3& a) {
  Mat3 t;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) t[j][i] = a[i][j];
  }
  return t;
}

Mat3 operator-(const Mat3& a, const Mat3& b) {
  Mat3 m;
  for (std::size_t i = 0; i < 3; ++i) m[i] = a[i] - b[i];
  return m;
}

Mat3 operator*(const Mat3& a, const Mat3& b) {
  const Mat3 columns = transpose(b);
  Mat3 product;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) product[i][j] = dot(a[i], columns[j]);
  }
  return product;
}

Mat3 skew(const Vec3& a) { return {Vec3{0, -a[2], a[1]}, Vec3{a[2], 0, -a[0]}, Vec3{-a[1], a[0], 0}}; }

Mat3 inertia_between(const Vec3& a, const Vec3& b) {
  const Number both = 2 * dot(a, b);
  Mat3 m;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = (i == j ? both : Number(0)) - a[i] * b[j] - b[i] * a[j];
  }
  return m;
}

Mat3 steiner(const Number& m, const Vec3& r) {
  const Mat3 S = skew(r);
  Mat3 result = transpose(S) * S;
  for (Vec3& row : result) {
    for (Number& entry : row) entry = (m * entry).expand();
  }
  return result;
}

bool vanishes(const Number& a) {
  if (a.is_zero()) return true;
  const std::optional<int> sign = sign_of(a);
  return sign ? *sign == 0 : a.expand().is_zero();
}

Vec3 expanded(const Vec3& a) { return {a[0].expand(), a[1].expand(), a[2].expand()}; }

Mat3 expanded(const Mat3& a) { return {expanded(a[0]), expanded(a[1]), expanded(a[2])}; }

bool is_rational(const Number& a) { return GiNaC::is_a<GiNaC::numeric>(a) && a.info(GiNaC::info_flags::rational); }

bool has_symbols(const Number& a) {
  if (GiNaC::is_a<GiNaC::symbol>(a)) return true;
  return std::any_of(a.begin(), a.end(), has_symbols);
}

GiNaC::numeric magnitude(const Number& a) {
  return GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(is_rational(a) ? a : a.evalf()));
}

namespace {

// Takes the digits at `position`, which moves past them.
std::string take_digits(std::string_view text, std::size_t& position) {
  const std::size_t begin = position;
  while (position < text.size() && std::isdigit(static_cast<unsigned char>(text[position])) != 0) ++position;
  return std::string(text.substr(begin, position - begin));
}

// Takes the exponent at `position` ("e-3"), 0 if there is none. It is bounded, so that 1e999999999 cannot exhaust
// memory.
int take_exponent(std::string_view text, std::size_t& position) {
  if (position >= text.size() || (text[position] != 'e' && text[position] != 'E')) return 0;
  ++position;
  bool negative = false;
  if (position < text.size() && (text[position] == '+' || text[position] == '-')) negative = text[position++] == '-';
  const std::string digits = take_digits(text, position);
  if (digits.empty() || digits.size() > 4) throw std::invalid_argument("exponent missing or too large");
  const int exponent = std::stoi(digits);
  return negative ? -exponent : exponent;
}

}  // namespace

Number exact_decimal(std::string_view text) {
  constexpr int kLargestExponent = 400;  // beyond double's range in both directions
  std::size_t position = 0;
  bool negative = false;
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) negative = text[position++] == '-';
  std::string digits = take_digits(text, position);
  int exponent = 0;
  if (position < text.size() && text[position] == '.') {
    ++position;
    const std::string fraction = take_digits(text, position);
    digits += fraction;
    exponent -= static_cast<int>(fraction.size());
  }
  if (digits.empty()) throw std::invalid_argument("not a decimal number");
  exponent += take_exponent(text, position);
  if (position != text.size()) throw std::invalid_argument("not a decimal number");
  if (exponent > kLargestExponent || exponent < -2 * kLargestExponent) {
    throw std::invalid_argument("exponent too large");
  }
  const GiNaC::numeric mantissa(digits.c_str());
  const Number value = mantissa * GiNaC::pow(GiNaC::numeric(10), GiNaC::numeric(exponent));
  return negative ? -value : value;
}

namespace {

GiNaC::ex value_to(const Number& a, int digits) {
  const long saved = GiNaC::Digits;
  GiNaC::Digits = digits;
  const GiNaC::ex value = a.evalf();
  GiNaC::Digits = saved;
  return value;
}

bool have_same_digits(const GiNaC::ex& a, const GiNaC::ex& b, int digits) {
  if (!GiNaC::is_a<GiNaC::numeric>(a) || !GiNaC::is_a<GiNaC::numeric>(b)) return true;  // said by the caller
  const GiNaC::numeric difference = GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(a - b));
  return difference <= GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(b)) * GiNaC::pow(GiNaC::numeric(10), -digits);
}

// Where terms cancel, more digits are needed than are shown.
GiNaC::ex value_with_digits(const Number& a, int digits) {
  constexpr int kGuardDigits = 10, kMostDigits = 10000;
  int computed = digits + kGuardDigits;
  GiNaC::ex value = value_to(a, computed);
  if (GiNaC::is_a<GiNaC::numeric>(a)) return value;
  while (computed < kMostDigits) {
    computed *= 2;
    const GiNaC::ex closer = value_to(a, computed);
    if (have_same_digits(value, closer, digits + 2)) return value;
    if (vanishes(a)) return 0;
    value = closer;
  }
  return value;
}

}  // namespace

std::string to_decimal(const Number& a, int digits) {
  const GiNaC::ex value = value_with_digits(a, digits);
  if (!GiNaC::is_a<GiNaC::numeric>(value) || !GiNaC::ex_to<GiNaC::numeric>(value).is_real()) {
    std::ostringstream text;
    text << a;
    throw std::domain_error("not a real number: " + text.str());
  }
  // CLN prints a float with its own precision; an exponent is written as in C.
  const cln::cl_R real = cln::the<cln::cl_R>(GiNaC::ex_to<GiNaC::numeric>(value).to_cl_N());
  std::ostringstream text;
  cln::cl_print_flags flags;
  flags.default_float_format = cln::float_format(static_cast<std::uintptr_t>(digits));
  cln::print_real(text, flags, cln::cl_float(real, cln::float_format(static_cast<std::uintptr_t>(digits))));
  std::string decimal = text.str();
  std::replace(decimal.begin(), decimal.end(), 'L', 'e');
  return decimal;
}

double nearest_double(const Number& a) {
  constexpr int kMoreThanADouble = 40;
  // Not std::stod, which throws below the least normal double.
  return std::strtod(to_decimal(a, kMoreThanADouble).c_str(), nullptr);
}

}  // namespace flatdyn

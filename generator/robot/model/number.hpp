// SPDX-License-Identifier: GPL-2.0-or-later
// Exact numbers of the model: rationals, multiples of Pi, and expressions in free symbols. No doubles.
#pragma once

#include <ginac/ginac.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace flatdyn {

// An exact number: a rational, or an expression in Pi, sqrt(...) and the robot's free symbols.
using Number = GiNaC::ex;

using Vec3 = std::array<Number, 3>;
using Mat3 = std::array<std::array<Number, 3>, 3>;  // row-major: m[row][column]
using Rows = std::vector<std::vector<Number>>;      // a matrix whose size depends on the robot

Vec3 zero_vector();
Mat3 zero_matrix();
Mat3 identity_matrix();

Vec3 operator+(const Vec3& a, const Vec3& b);
Vec3 operator-(const Vec3& a, const Vec3& b);
Vec3 operator*(const Number& a, const Vec3& b);
Number dot(const Vec3& a, const Vec3& b);
Vec3 cross(const Vec3& a, const Vec3& b);
Mat3 operator+(const Mat3& a, const Mat3& b);
Mat3 operator-(const Mat3& a, const Mat3& b);
Mat3 operator*(const Mat3& a, const Mat3& b);
Vec3 operator*(const Mat3& a, const Vec3& b);
Mat3 transpose(const Mat3& a);
Mat3 skew(const Vec3& a);                      // S(a), so that S(a) b = a x b
Mat3 steiner(const Number& m, const Vec3& r);  // m S(r)^T S(r), (7.60)
// 2 (a·b) 1 - a b^T - b a^T: the change of an inertia tensor when its reference point moves. inertia_between(r, m r) is
// 2 steiner(m, r).
Mat3 inertia_between(const Vec3& a, const Vec3& b);

bool vanishes(const Number& a);  // whether a is exactly zero when expanded
Vec3 expanded(const Vec3& a);
Mat3 expanded(const Mat3& a);
bool is_rational(const Number& a);  // whether a is a plain rational number: no symbol, no Pi, no root
// Whether `a` contains free symbols.
bool has_symbols(const Number& a);
GiNaC::numeric magnitude(const Number& a);  // |a| of a number without symbols: exact if it is rational

// The exact rational of a decimal such as "-1.5e-3" (no double in between).
// Throws std::invalid_argument if the text is not a finite decimal.
Number exact_decimal(std::string_view text);

// The value to `digits` significant decimal digits, e.g. "1.5707963267948966". Symbols must have been substituted;
// throws std::domain_error if one is left.
std::string to_decimal(const Number& a, int digits);

// The nearest double, for measuring and showing. Throws std::domain_error if a symbol is left.
double nearest_double(const Number& a);

}  // namespace flatdyn

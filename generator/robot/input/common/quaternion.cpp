// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/quaternion.hpp"

#include <cmath>

namespace flatdyn {

namespace {

constexpr int kDigitsOfAngle = 80;

Number to_many_digits(const Number& angle) { return exact_decimal(to_decimal(angle, kDigitsOfAngle)); }

// Exact arguments, of which at most one is 0.
Number angle_between(const Number& sine, const Number& cosine) {
  if (sine.is_zero() && cosine.is_zero()) return 0;
  return to_many_digits(GiNaC::atan2(sine, cosine));
}

}  // namespace

Number squared_norm(const Quaternion& q) { return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]; }

Vec3 rpy_of(const Quaternion& q, const Number& tolerance) {
  const auto& [x, y, z, w] = q;
  const Number norm = squared_norm(q), sine = 2 * (w * y - x * z) / norm, cosine_squared = 1 - sine * sine;
  const bool is_quarter = magnitude(cosine_squared) <= magnitude(tolerance);
  const Number cosine = GiNaC::sqrt(cosine_squared);
  const Number pitch =
      cosine_squared.is_zero() ? to_many_digits(sine * GiNaC::Pi / 2) : to_many_digits(GiNaC::atan(sine / cosine));
  if (is_quarter) return {0, pitch, angle_between(2 * (w * z - x * y), w * w - x * x + y * y - z * z)};
  return {angle_between(2 * (w * x + y * z), w * w - x * x - y * y + z * z), pitch,
          angle_between(2 * (w * z + x * y), w * w + x * x - y * y - z * z)};
}

bool is_rotation(const Quaternion& q, const Vec3& rpy) {
  constexpr double kSame = 1e-9;  // of what 1 - cos(half the angle between them) is
  std::array<double, 3> c{}, s{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double half = nearest_double(rpy[i]) / 2;
    c[i] = std::cos(half);
    s[i] = std::sin(half);
  }
  const std::array<double, 4> other = {s[0] * c[1] * c[2] - c[0] * s[1] * s[2], c[0] * s[1] * c[2] + s[0] * c[1] * s[2],
                                       c[0] * c[1] * s[2] - s[0] * s[1] * c[2],
                                       c[0] * c[1] * c[2] + s[0] * s[1] * s[2]};
  double product = 0;
  for (std::size_t i = 0; i < 4; ++i) product += nearest_double(q[i]) * other[i];
  return std::abs(product) / std::sqrt(nearest_double(squared_norm(q))) > 1 - kSame;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/model/body.hpp"

#include <algorithm>
#include <array>

#include "robot/model/field_mechanism.hpp"
#include "robot/model/rational_rotation.hpp"
#include "robot/model/spherical_joint.hpp"

namespace flatdyn {

Mat3 joint_axes(const Body& joint) {
  const Mat3 axes = rotation_z(joint.beta) * rotation_x(joint.alpha);
  return expanded(joint.prismatic ? axes * rotation_z(joint.theta) : axes);
}

Mat3 constant_rotation(const Body& body) {
  const Mat3 R = expanded(rotation_z(body.beta) * rotation_x(body.alpha) * rotation_z(body.theta));
  return body.spherical == 1 ? with_columns_cycled(R) : R;
}

bool InertialParameters::is_zero() const {
  const auto all_vanish = [](const Vec3& v) { return std::all_of(v.begin(), v.end(), vanishes); };
  return vanishes(mass) && all_vanish(first_moment) && std::all_of(inertia.begin(), inertia.end(), all_vanish);
}

InertialParameters operator+(const InertialParameters& a, const InertialParameters& b) {
  return {(a.mass + b.mass).expand(), expanded(a.first_moment + b.first_moment), expanded(a.inertia + b.inertia)};
}

namespace {

using Integer = Rational::Integer;

// Numbers over one denominator, whose sums and products need no common divisors. Those of a long chain have thousands
// of digits.
template <std::size_t N>
struct Fractions {
  std::array<Integer, N> above;
  Integer below = 1;
};

template <std::size_t N>
Fractions<N> over_one_denominator(const std::array<Number, N>& numbers) {
  Fractions<N> result;
  std::array<Rational, N> values;
  for (std::size_t k = 0; k < N; ++k) {
    values[k] = to_rational(numbers[k]);
    result.below = lcm(result.below, denominator(values[k]));
  }
  for (std::size_t k = 0; k < N; ++k) {
    result.above[k] = numerator(values[k]) * (result.below / denominator(values[k]));
  }
  return result;
}

std::array<Number, 9> entries_of_matrix(const Mat3& m) {
  return {m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2]};
}

using IntegerVector = std::array<Integer, 3>;

Integer dot_of_integers(const Integer* a, const Integer* b) {
  return Integer(Integer(a[0] * b[0]) + Integer(a[1] * b[1]) + Integer(a[2] * b[2]));
}

// R I R^T for a symmetric I, both row by row.
std::array<Integer, 9> rotated(const std::array<Integer, 9>& R, const std::array<Integer, 9>& I) {
  std::array<Integer, 9> half, result;  // half = R I
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) half[3 * i + j] = dot_of_integers(&R[3 * i], &I[3 * j]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      result[3 * i + j] = result[3 * j + i] = dot_of_integers(&half[3 * i], &R[3 * j]);
    }
  }
  return result;
}

// 2 (a . b) 1 - a b^T - b a^T, entry (i, j).
Integer entry_between(const IntegerVector& a, const IntegerVector& b, std::size_t i, std::size_t j) {
  const Integer both = i == j ? Integer(2 * dot_of_integers(a.data(), b.data())) : Integer(0);
  return Integer(both - a[i] * b[j] - b[i] * a[j]);
}

bool are_rational(const InertialParameters& a, const Mat3& R, const Vec3& p) {
  const auto all = [](const Vec3& v) { return std::all_of(v.begin(), v.end(), is_rational); };
  const Mat3& I = a.inertia;
  const bool is_symmetric = I[0][1].is_equal(I[1][0]) && I[0][2].is_equal(I[2][0]) && I[1][2].is_equal(I[2][1]);
  return is_symmetric && is_rational(a.mass) && all(a.first_moment) && all(p) &&
         std::all_of(a.inertia.begin(), a.inertia.end(), all) && std::all_of(R.begin(), R.end(), all);
}

InertialParameters transformed_numbers(const InertialParameters& a, const Mat3& R, const Vec3& p) {
  const auto r = over_one_denominator(entries_of_matrix(R)), I = over_one_denominator(entries_of_matrix(a.inertia));
  const auto d = over_one_denominator(p), e = over_one_denominator(a.first_moment);
  const Rational mass = to_rational(a.mass);
  const Integer m = numerator(mass), below_m = denominator(mass);
  IntegerVector h;  // R times the first moment, over below_h
  for (std::size_t i = 0; i < 3; ++i) h[i] = dot_of_integers(&r.above[3 * i], e.above.data());
  const Integer below_h = r.below * e.below, below_mp = below_m * d.below;
  InertialParameters result{a.mass, {}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    result.first_moment[i] =
        to_number(Rational(Integer(h[i] * below_mp + m * d.above[i] * below_h), Integer(below_h * below_mp)));
  }
  const std::array<Integer, 9> turned = rotated(r.above, I.above);
  const Integer below_turned = r.below * r.below * I.below, below_between = d.below * below_h;
  const Integer below_steiner = below_mp * d.below;
  const Integer below = lcm(Integer(lcm(below_turned, below_between)), below_steiner);
  const Integer x = below / below_turned, y = below / below_between, z = below / below_steiner;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      // The inertia of a point mass is half of what lies between its displacement and itself.
      const Integer steiner_entry = m * entry_between(d.above, d.above, i, j) / 2;
      const Integer sum = turned[3 * i + j] * x + entry_between(d.above, h, i, j) * y + steiner_entry * z;
      result.inertia[i][j] = result.inertia[j][i] = to_number(Rational(sum, below));
    }
  }
  return result;
}

}  // namespace

InertialParameters transformed(const InertialParameters& a, const Mat3& R, const Vec3& p) {
  if (are_rational(a, R, p)) return transformed_numbers(a, R, p);
  const Vec3 h = R * a.first_moment;
  const Mat3 I = R * a.inertia * transpose(R);
  return {a.mass, expanded(h + a.mass * p), expanded(I + inertia_between(p, h) + steiner(a.mass, p))};
}

}  // namespace flatdyn

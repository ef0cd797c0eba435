// SPDX-License-Identifier: GPL-2.0-or-later
// The sines and cosines of generated code: how accurate they are, and what happens beyond their range. Compiled for any
// machine, and again with AVX2 (CMakeLists.txt).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "panda.hpp"

namespace flatdyn {
namespace {

using AllEight = panda::Joints<0, 1, 2, 3, 4, 5, 6, 7>;

constexpr long double kHalfPi = 1.57079632679489661923132169163975144L;

// A unit in the last place of a number near `value`.
template <class T>
long double ulp(long double value) {
  int exponent = 0;
  std::frexp(value, &exponent);
  exponent = std::max(exponent, std::numeric_limits<T>::min_exponent);
  return std::ldexp(1.0L, exponent - std::numeric_limits<T>::digits);
}

// The largest errors of sines and cosines so far, in units of their last places.
template <class T>
class Errors {
 public:
  void add(const T (&q)[8]) {
    T s[8], c[8];
    panda::PolynomialSinCos()(q, AllEight(), s, c);
    for (int k = 0; k < 8; ++k) {
      note(s[k], std::sin(static_cast<Exact>(q[k])));
      note(c[k], std::cos(static_cast<Exact>(q[k])));
    }
  }
  long double largest() const { return largest_; }

 private:
  // Many more digits than T has: the library's are right to less than a unit in their last place.
  using Exact = std::conditional_t<std::is_same_v<T, float>, double, long double>;

  void note(T computed, Exact exact) {
    largest_ = std::max(largest_, std::fabs(computed - static_cast<long double>(exact)) / ulp<T>(exact));
  }

  long double largest_ = 0;
};

class PolynomialSinesTest : public ::testing::Test {
 protected:
  void SetUp() override {
#ifdef __AVX2__
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) GTEST_SKIP() << "this machine has no AVX2";
#endif
    if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "long double is too short to compare with";
  }
};

// Angles of all sizes, those nearest to multiples of π/2, where digits cancel, and those between two of them.
template <class T>
long double largest_error(T limit, int steps) {
  std::mt19937 random(20261127);
  std::uniform_real_distribution<T> unit(-1, 1);
  Errors<T> errors;
  for (int k = 0; k < 20000; ++k) {
    T q[8];
    for (int i = 0; i < 8; ++i) q[i] = unit(random) * std::ldexp(limit, -3 * i);
    errors.add(q);
  }
  for (int n = 0; n < steps; ++n) {
    const T zero = static_cast<T>(n * kHalfPi), middle = static_cast<T>((n + 0.5L) * kHalfPi);
    errors.add({zero, std::nextafter(zero, T(0)), std::nextafter(zero, limit), -zero, middle,
                std::nextafter(middle, T(0)), std::nextafter(middle, limit), -middle});
  }
  return errors.largest();
}

TEST_F(PolynomialSinesTest, AreRightToLessThanAUnitInTheLastPlace) {
  const long double of_doubles = largest_error<double>(1e5, 63662);
  EXPECT_GT(of_doubles, 0.5);
  EXPECT_LT(of_doubles, 0.9);
  const long double of_floats = largest_error<float>(6400, 4074);
  EXPECT_GT(of_floats, 0.5);
  EXPECT_LT(of_floats, 0.86);
}

TEST_F(PolynomialSinesTest, AllFloatsOfTheRangeAreRight) {
  Errors<float> errors;
  const float limit = 6400;
  std::uint32_t last = 0;
  std::memcpy(&last, &limit, sizeof(last));
  for (std::uint32_t first = 0; first <= last; first += 8) {
    float q[8];
    for (std::uint32_t k = 0; k < 8; ++k) {
      const std::uint32_t bits = std::min(first + k, last);
      std::memcpy(q + k, &bits, sizeof(bits));
    }
    errors.add(q);
  }
  EXPECT_LT(errors.largest(), 0.86);
}

// Sines are odd and cosines even, bit by bit, so that angles above zero stand for those below.
TEST_F(PolynomialSinesTest, AreOddAndEven) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1e3);
  for (int k = 0; k < 1000; ++k) {
    const double x = unit(random), q[2] = {x, -x};
    double s[2], c[2];
    panda::PolynomialSinCos()(q, panda::Joints<0, 1>(), s, c);
    EXPECT_EQ(s[0], -s[1]) << x;
    EXPECT_EQ(c[0], c[1]) << x;
  }
}

TEST_F(PolynomialSinesTest, KeepTheSignOfAZeroInDouble) {
  const double q[2] = {-0.0, 0.0};
  double s[2], c[2];
  panda::PolynomialSinCos()(q, panda::Joints<0, 1>(), s, c);
  EXPECT_TRUE(std::signbit(s[0]));
  EXPECT_FALSE(std::signbit(s[1]));
}

template <template <int...> class Joints, int... joint, class T>
void expect_these(const T (&q)[10]) {
  T s[10], c[10];
  std::fill_n(s, 10, T(5));
  std::fill_n(c, 10, T(5));
  panda::PolynomialSinCos()(q, Joints<joint...>(), s, c);
  std::vector<bool> asked(10, false);
  for (const int i : {joint...}) asked[static_cast<std::size_t>(i)] = true;
  for (std::size_t i = 0; i < 10; ++i) {
    const T tolerance = std::numeric_limits<T>::epsilon();
    EXPECT_NEAR(s[i], asked[i] ? std::sin(q[i]) : T(5), tolerance) << "joint " << i << " of " << sizeof...(joint);
    EXPECT_NEAR(c[i], asked[i] ? std::cos(q[i]) : T(5), tolerance) << "joint " << i << " of " << sizeof...(joint);
  }
}

template <class T>
void expect_any_joints() {
  const T q[10] = {T(0.3), T(-9), T(1e3), T(0), T(2), T(-3), T(4), T(-5e3), T(6), T(7)};
  expect_these<panda::Joints, 0>(q);
  expect_these<panda::Joints, 9>(q);
  expect_these<panda::Joints, 3, 4>(q);
  expect_these<panda::Joints, 1, 2, 3>(q);
  expect_these<panda::Joints, 2, 9, 4, 0>(q);
  expect_these<panda::Joints, 0, 1, 2, 3, 4>(q);
  expect_these<panda::Joints, 0, 1, 3, 5, 6, 8, 9>(q);
  expect_these<panda::Joints, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9>(q);
}

TEST_F(PolynomialSinesTest, WriteTheJointsAskedForAndNoOthers) {
  expect_any_joints<double>();
  expect_any_joints<float>();
}

// Each angle by itself is within its range, or beyond and the library's; the others are not affected.
template <class T>
void expect_library_beyond(T limit) {
  const T infinity = std::numeric_limits<T>::infinity(), beyond = std::nextafter(limit, infinity);
  const T q[8] = {beyond, limit, -limit, -beyond, std::numeric_limits<T>::max(), infinity, T(0.5), T(NAN)};
  T s[8], c[8], alone, other;
  panda::PolynomialSinCos()(q, AllEight(), s, c);
  for (const int k : {0, 3, 4}) {
    EXPECT_EQ(s[k], std::sin(q[k])) << k;
    EXPECT_EQ(c[k], std::cos(q[k])) << k;
  }
  for (const int k : {1, 2, 6}) {
    panda::PolynomialSinCos()(q + k, panda::Joints<0>(), &alone, &other);
    EXPECT_EQ(s[k], alone) << k;
    EXPECT_EQ(c[k], other) << k;
  }
  for (const int k : {5, 7}) EXPECT_TRUE(std::isnan(s[k]) && std::isnan(c[k])) << k;
}

TEST_F(PolynomialSinesTest, LeaveLargeAnglesToTheLibrary) {
  expect_library_beyond<double>(1e5);
  expect_library_beyond<float>(6400);
}

TEST_F(PolynomialSinesTest, OtherScalarsHaveTheirOwn) {
  const long double q[2] = {0.3L, 1e6L};
  long double s[2], c[2];
  panda::PolynomialSinCos()(q, panda::Joints<0, 1>(), s, c);
  EXPECT_EQ(s[0], std::sin(q[0]));
  EXPECT_EQ(c[1], std::cos(q[1]));
}

}  // namespace
}  // namespace flatdyn

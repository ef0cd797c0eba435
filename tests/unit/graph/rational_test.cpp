// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/rational.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace flatdyn {
namespace {

using Exact = mpq_class;
using Integer = Rational::Integer;

constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();

// Numbers of all sizes around the largest that is held inline, from both sides, and small ones.
std::vector<Integer> integers() {
  std::vector<Integer> result = {0, 1, 2, 3, 12, 1000, kLargest, kLargest - 1, Integer(kLargest) + 1, Integer(1) << 90};
  std::mt19937_64 random(1);
  for (int k = 0; k < 12; ++k) result.emplace_back(random() >> (4 * k));
  const std::size_t count = result.size();
  for (std::size_t k = 0; k < count; ++k) result.push_back(-result[k]);
  return result;
}

Exact in_lowest_terms(Exact fraction) {
  fraction.canonicalize();
  return fraction;
}

struct Pair {
  Rational number;
  Exact exact;
};

std::vector<Pair> numbers() {
  std::vector<Pair> result;
  const std::vector<Integer> all = integers();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Integer& below = all[(7 * k + 3) % all.size()];
    result.push_back({Rational(all[k]), Exact(all[k])});
    if (below != 0) result.push_back({Rational(all[k], below), in_lowest_terms(Exact(all[k], below))});
  }
  return result;
}

void expect_same(const Rational& number, const Exact& exact) {
  EXPECT_EQ(number.str(), exact.get_str());
  EXPECT_EQ(number, Rational(exact.get_str()));
  EXPECT_EQ(number.hash(), Rational(exact.get_str()).hash()) << exact;
}

TEST(Rational, ComputesAsGmpDoesAcrossTheEdgeOfWords) {
  for (const Pair& a : numbers()) {
    expect_same(-a.number, -a.exact);
    expect_same(abs(a.number), abs(a.exact));
    if (!a.number.is_zero()) expect_same(a.number.reciprocal(), 1 / a.exact);
    for (const Pair& b : numbers()) {
      expect_same(a.number + b.number, a.exact + b.exact);
      expect_same(a.number - b.number, a.exact - b.exact);
      expect_same(a.number * b.number, a.exact * b.exact);
      if (!b.number.is_zero()) expect_same(a.number / b.number, a.exact / b.exact);
      EXPECT_EQ(a.number < b.number, a.exact < b.exact) << a.exact << " " << b.exact;
      EXPECT_EQ(a.number == b.number, a.exact == b.exact) << a.exact << " " << b.exact;
      EXPECT_EQ(a.number.has_size_of(b.number), abs(a.exact) == abs(b.exact)) << a.exact << " " << b.exact;
      EXPECT_EQ(a.number.has_reciprocal_size_of(b.number), abs(a.exact * b.exact) == 1) << a.exact << " " << b.exact;
    }
  }
}

TEST(Rational, HasRemainders) {
  for (const Pair& each : numbers()) {
    for (const std::uint64_t modulus : {std::uint64_t{7}, (std::uint64_t{1} << 61) - 1, ~std::uint64_t{0}}) {
      Integer above, below;
      mpz_mod(above.get_mpz_t(), each.exact.get_num_mpz_t(), Integer(modulus).get_mpz_t());
      mpz_mod(below.get_mpz_t(), each.exact.get_den_mpz_t(), Integer(modulus).get_mpz_t());
      EXPECT_EQ(each.number.numerator_modulo(modulus), above) << each.exact;
      EXPECT_EQ(each.number.denominator_modulo(modulus), below) << each.exact;
    }
  }
}

TEST(Rational, TakesIntegersOfAllTypesExactly) {
  EXPECT_EQ(Rational(std::numeric_limits<std::int64_t>::min()).str(), "-9223372036854775808");
  EXPECT_EQ(Rational(std::numeric_limits<std::uint64_t>::max()).str(), "18446744073709551615");
  EXPECT_EQ(Rational(-1).str(), "-1");
  EXPECT_EQ(Rational(6, -4).str(), "-3/2");
  EXPECT_EQ(Rational("010/4").str(), "5/2") << "no octal number";
  EXPECT_EQ(Rational(0.1).str(), "3602879701896397/36028797018963968");
  EXPECT_EQ(Rational(std::ldexp(1.0, 70)), Rational(Integer(1) << 70));
}

TEST(Rational, DividesByNothingButNumbersOtherThanZero) {
  EXPECT_THROW(Rational(1) / Rational(0), std::overflow_error);
  EXPECT_THROW(Rational(1, 0), std::overflow_error);
  EXPECT_THROW(Rational("1/0"), std::overflow_error);
  EXPECT_THROW(Rational(Integer(1), Integer(0)), std::overflow_error);
  EXPECT_THROW(Rational(0).reciprocal(), std::overflow_error);
}

TEST(Rational, CopiesOfLargeNumbersAreIndependent) {
  const Rational large(Integer(1) << 100);
  Rational copy = large, other = copy;
  copy += 1;
  EXPECT_EQ(large, Rational(Integer(1) << 100));
  EXPECT_EQ(other, large);
  EXPECT_EQ(copy - large, 1);
  other = std::move(copy);
  EXPECT_EQ(other, large + 1);
  const Rational& same = other;
  other -= same;
  EXPECT_TRUE(other.is_zero());
}

}  // namespace
}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/coefficients.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace flatdyn {
namespace {

// Small numbers; large ones; and multiples and fractions of the prime that fingerprints are taken modulo.
std::vector<Rational> coefficients() {
  const Rational prime(kMersenne61), large(Rational::Integer(1) << 100);
  std::vector<Rational> result;
  for (const Rational& unit : {Rational(1), prime, 1 / prime, large, prime * prime * large}) {
    for (const Rational& factor : {Rational(1), Rational(2), Rational(2, 3), Rational(3), Rational(4)}) {
      result.push_back(unit * factor);
      result.push_back(-unit * factor);
    }
  }
  return result;
}

TEST(CoefficientTable, NumbersEachValueOnce) {
  CoefficientTable table;
  for (const Rational& value : coefficients()) {
    const CoefficientId id = table.id(value);
    EXPECT_EQ(table[id], value);
    EXPECT_EQ(table.id(value), id);
    EXPECT_EQ(table.is_unit(id), abs(value) == 1);
    for (const Rational& other : coefficients()) {
      EXPECT_EQ(table.have_equal_sizes(id, table.id(other)), abs(value) == abs(other)) << value << " " << other;
    }
  }
}

TEST(CoefficientTable, NumbersEachRatioOnce) {
  CoefficientTable table;
  std::vector<std::pair<Rational, RatioId>> ratios;
  for (const Rational& above : coefficients()) {
    for (const Rational& below : coefficients()) {
      ratios.emplace_back(above / below, table.ratio(table.id(above), table.id(below)));
    }
  }
  for (std::size_t k = 0; k < ratios.size(); k += 17) {
    for (const auto& [ratio, id] : ratios) {
      ASSERT_EQ(ratios[k].first == ratio, ratios[k].second == id) << ratios[k].first << " " << ratio;
    }
  }
}

}  // namespace
}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Zeros in entries that follow one another are stored together, and every other one by itself.
#include "code/lower/zeros.hpp"

#include <gtest/gtest.h>

namespace flatdyn {
namespace {

// Zeros in these entries of B.
code::Store zeros_in(std::initializer_list<std::pair<int, int>> ranges) {
  code::Store store{{}, code::Literal{0}};
  for (const auto& [first, end] : ranges) {
    for (int k = first; k < end; ++k) store.places.emplace_back(code::Element{"B", k});
  }
  return store;
}

TEST(Zeros, AreStoredTogetherWhereFourFollowOneAnother) {
  code::Store store = zeros_in({{1, 5}, {6, 9}, {20, 28}});
  for (int k = 28; k < 32; ++k) store.places.emplace_back(code::Element{"C", k});
  const code::Statements statements = zeros_together(store);
  ASSERT_EQ(statements.size(), 4U);
  EXPECT_EQ(std::get<code::Store>(statements[0]).places.size(), 3U);
  const auto range = [&](std::size_t k) {
    const auto& zeros = std::get<code::StoreZeros>(statements[k]);
    return std::tuple(zeros.array, zeros.first, zeros.end);
  };
  EXPECT_EQ(range(1), std::tuple("B", 1U, 5U));
  EXPECT_EQ(range(2), std::tuple("B", 20U, 28U));
  EXPECT_EQ(range(3), std::tuple("C", 28U, 32U));
}

TEST(Zeros, LeaveNoStoreBehindThatStoresNothing) {
  const code::Statements statements = zeros_together(zeros_in({{0, 16}}));
  ASSERT_EQ(statements.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<code::StoreZeros>(statements[0]));
}

TEST(Zeros, AreStoredOneByOneWhereTheyAreFew) {
  const code::Statements statements = zeros_together(zeros_in({{0, 6}, {7, 11}, {12, 17}}));
  ASSERT_EQ(statements.size(), 1U);
  EXPECT_EQ(std::get<code::Store>(statements[0]).places.size(), 15U);
}

TEST(Zeros, OfFieldsAreStoredOneByOne) {
  code::Store store = zeros_in({});
  for (int k = 0; k < 20; ++k) store.places.emplace_back(code::Field{"stage", "x" + std::to_string(k)});
  EXPECT_EQ(zeros_together(store).size(), 1U);
}

}  // namespace
}  // namespace flatdyn

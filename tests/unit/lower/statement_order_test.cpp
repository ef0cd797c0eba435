// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/statement_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace flatdyn {
namespace {

// The largest number of values that statements have made and later ones read.
int most_live(const StatementUses& uses, const std::vector<int>& order) {
  std::vector<std::size_t> left;
  for (const std::vector<int>& users : uses.users) left.push_back(users.size());
  int live = 0, most = 0;
  for (const int k : order) {
    for (const int value : uses.needs[static_cast<std::size_t>(k)]) {
      const bool is_last = --left[static_cast<std::size_t>(value)] == 0;
      if (is_last && value < uses.statements()) --live;
    }
    if (uses.makes[static_cast<std::size_t>(k)]) ++live;
    most = std::max(most, live);
  }
  return most;
}

// `uses` of statements that need these statements; all but the last make a value.
StatementUses uses_among(const std::vector<std::vector<int>>& needs) {
  StatementUses uses;
  uses.needs = needs;
  uses.users.resize(needs.size());
  for (int k = 0; k < uses.statements(); ++k) {
    for (const int value : needs[static_cast<std::size_t>(k)]) uses.users[static_cast<std::size_t>(value)].push_back(k);
  }
  for (const std::vector<int>& users : uses.users) uses.makes.push_back(!users.empty());
  return uses;
}

// Statements 0 … n - 1 make values; n … 2n - 1 give them away one by one; the others sum them up.
StatementUses kept_for_later(int n) {
  std::vector<std::vector<int>> needs(static_cast<std::size_t>(n));
  for (int k = 0; k < n; ++k) needs.push_back({k});
  needs.push_back({0, 1});
  for (int k = 2; k < n; ++k) needs.push_back({k, 2 * n + k - 2});
  needs.push_back({3 * n - 2});
  return uses_among(needs);
}

std::vector<int> as_given(const StatementUses& uses) {
  std::vector<int> order;
  for (int k = 0; k < uses.statements(); ++k) order.push_back(k);
  return order;
}

TEST(StatementOrder, FinishesWhatIsBegun) {
  const StatementUses uses = kept_for_later(50);
  EXPECT_EQ(most_live(uses, as_given(uses)), 50);
  EXPECT_LE(most_live(uses, order_of_short_lives(uses)), 2);
}

TEST(StatementOrder, StaysWhereFewValuesAreLive) {
  const StatementUses uses = kept_for_later(40);
  EXPECT_EQ(order_of_short_lives(uses), as_given(uses));
}

TEST(StatementOrder, KeepsEveryStatementAfterItsNeeds) {
  const StatementUses uses = kept_for_later(60);
  std::vector<bool> is_made(uses.needs.size(), false);
  for (const int k : order_of_short_lives(uses)) {
    for (const int value : uses.needs[static_cast<std::size_t>(k)])
      EXPECT_TRUE(is_made[static_cast<std::size_t>(value)]);
    is_made[static_cast<std::size_t>(k)] = true;
  }
  EXPECT_EQ(std::count(is_made.begin(), is_made.end(), true), uses.statements());
}

}  // namespace
}  // namespace flatdyn

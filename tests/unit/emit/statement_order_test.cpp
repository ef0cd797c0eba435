// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/statement_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "emit/schedule.hpp"
#include "unit/emit/hand_made.hpp"

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

// Each value is used by a sum of all and by an output of its own: 0 1 2 3, then the outputs, then the chain of sums.
TEST(StatementOrder, FinishesWhatIsBegun) {
  const StatementUses uses = uses_among({{}, {}, {}, {}, {0}, {1}, {2}, {3}, {0, 1}, {8, 2}, {9, 3}, {10}});
  const std::vector<int> order = order_of_short_lives(uses);
  EXPECT_LE(most_live(uses, order), 2);
  EXPECT_EQ(most_live(uses, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}), 4);
}

TEST(StatementOrder, KeepsEveryStatementAfterItsNeeds) {
  const StatementUses uses = uses_among({{}, {0}, {0, 1}, {1}, {2, 3}, {0, 4}});
  std::vector<bool> is_made(uses.needs.size(), false);
  for (const int k : order_of_short_lives(uses)) {
    for (const int value : uses.needs[static_cast<std::size_t>(k)])
      EXPECT_TRUE(is_made[static_cast<std::size_t>(value)]);
    is_made[static_cast<std::size_t>(k)] = true;
  }
  EXPECT_EQ(std::count(is_made.begin(), is_made.end(), true), uses.statements());
}

// A value that is read after all statements dies nowhere, so the others come first.
TEST(StatementOrder, MakesWhatIsReadAtTheEndLast) {
  StatementUses uses = uses_among({{}, {}, {1}, {0, 2}});
  uses.makes[3] = true;
  uses.read_at_the_end = {0, 3};
  EXPECT_EQ(order_of_short_lives(uses), (std::vector<int>{1, 2, 0, 3}));
}

TEST(StatementOrder, LeavesFewValuesLiveInAFunction) {
  const Function function = testing::two_link_inverse_dynamics();
  const Schedule schedule = make_schedule(function);
  const auto is_sine = [&function](const Statement& statement) {
    const Op op = function.graph[statement.node].op;
    return op == Op::sin || op == Op::cos;
  };
  std::vector<Statement> statements = schedule.statements;
  std::erase_if(statements, is_sine);
  const StatementUses uses = uses_of(function, schedule, statements, {});
  std::vector<int> order;
  for (int k = 0; k < uses.statements(); ++k) order.push_back(k);
  EXPECT_LE(most_live(uses, order), 5);
}

}  // namespace
}  // namespace flatdyn

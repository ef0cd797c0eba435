// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/walk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flatdyn::code {
namespace {

using ::testing::ElementsAre;

// tau[2] = x * (q[0] + parameters.m)
Statement moment() {
  const Expression sum = Sum{{{false, Element{"q", 0}}, {true, Parameter{"m"}}}};
  return Store{{Element{"tau", 2}}, Product{{Variable{"x"}, sum}}};
}

TEST(Walk, FindsTheNamesOfAStatement) {
  const Names names = names_in(moment());
  EXPECT_THAT(names.variables, ElementsAre("x"));
  EXPECT_THAT(names.others, ElementsAre("q", kParameters, "tau"));
}

TEST(Walk, FindsOperationsWhereverTheyAre) {
  const Expression root = Call{Operation::sqrt, {Variable{"x"}}};
  const Statements statements = {moment(), Check{true, Positive{Sum{{{false, Variable{"y"}}, {true, root}}}}}};
  EXPECT_TRUE(uses(statements, Operation::sqrt));
  EXPECT_FALSE(uses(statements, Operation::sign));
  EXPECT_FALSE(uses({moment()}, Operation::sqrt));
}

TEST(Walk, TakesASignOff) {
  const Addend negative = without_sign(Sum{{{true, Variable{"x"}}}});
  EXPECT_TRUE(negative.is_negative);
  EXPECT_EQ(std::get<Variable>(negative.value).name, "x");
  EXPECT_FALSE(without_sign(Sum{{{true, Variable{"x"}}, {false, Variable{"y"}}}}).is_negative);
}

}  // namespace
}  // namespace flatdyn::code

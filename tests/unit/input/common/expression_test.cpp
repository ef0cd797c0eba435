// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/expression.hpp"

#include <gtest/gtest.h>

#include <map>

namespace flatdyn {
namespace {

class Expression : public ::testing::Test {
 protected:
  Number parse(const std::string& text) {
    return parse_expression(text, [this](std::string_view name, std::size_t column) -> Number {
      columns_[std::string(name)] = column;
      return symbol(std::string(name));
    });
  }

  GiNaC::symbol symbol(const std::string& name) {
    return symbols_.try_emplace(name, GiNaC::symbol(name)).first->second;
  }

  bool same(const std::string& text, const Number& value) { return vanishes(parse(text) - value); }

  std::size_t error_column(const std::string& text) {
    try {
      parse(text);
    } catch (const ExpressionError& error) {
      return error.column();
    }
    return 0;
  }

  std::map<std::string, GiNaC::symbol> symbols_;
  std::map<std::string, std::size_t> columns_;
};

TEST_F(Expression, DecimalsAreExact) {
  EXPECT_TRUE(same("0.1", Number(1) / 10));
  EXPECT_TRUE(same("-9.81", Number(-981) / 100));
  EXPECT_TRUE(same("1e-3", Number(1) / 1000));
  EXPECT_TRUE(same("2.5E2", 250));
  EXPECT_TRUE(same(" .5 ", Number(1) / 2));
  EXPECT_TRUE(same("0.1 + 0.2 - 0.3", 0));
}

TEST_F(Expression, BindsAsPeopleWrite) {
  EXPECT_TRUE(same("1 + 2*3", 7));
  EXPECT_TRUE(same("(1 + 2)*3", 9));
  EXPECT_TRUE(same("1 - 2 - 3", -4));
  EXPECT_TRUE(same("12/2/3", 2));
  EXPECT_TRUE(same("-2^2", -4));
  EXPECT_TRUE(same("2^-1", Number(1) / 2));
  EXPECT_TRUE(same("2^3^2", 512));
  EXPECT_TRUE(same("2*-3", -6));
  EXPECT_TRUE(same("--+2", 2));
}

TEST_F(Expression, KnowsPiAndRoots) {
  EXPECT_TRUE(same("pi/2", GiNaC::Pi / 2));
  EXPECT_TRUE(same("sqrt(2)/2 * sqrt(2)", 1));
  EXPECT_TRUE(same("sqrt(9/4)", Number(3) / 2));
  EXPECT_TRUE(same("sqrt(0)", 0));
}

TEST_F(Expression, EqualRootsLookEqual) {
  EXPECT_TRUE(same("sqrt(8) - 2*sqrt(2)", 0));
  EXPECT_TRUE(same("sqrt(6) - sqrt(2)*sqrt(3)", 0));
  EXPECT_TRUE(same("sqrt(1/2) - sqrt(2)/2", 0));
  EXPECT_TRUE(same("1/sqrt(2) - sqrt(0.5)", 0));
  EXPECT_TRUE(same("sqrt(10007)^2", 10007));  // a prime beyond those looked for
  EXPECT_TRUE(same("sqrt(5 + 2*sqrt(6)) - sqrt(2) - sqrt(3)", 0));
  EXPECT_TRUE(same("sqrt(sqrt(2) + sqrt(3) - sqrt(5 + 2*sqrt(6)))", 0));
  EXPECT_FALSE(same("sqrt(2) - 1.41421356237309504880168872420969807856967187537694", 0));
}

TEST_F(Expression, SymbolsArePassedOn) {
  EXPECT_TRUE(same("l_1 - a_1/2", symbol("l_1") - symbol("a_1") / 2));
  EXPECT_TRUE(same("2*m_p + 1e-3", 2 * symbol("m_p") + Number(1) / 1000));
  EXPECT_EQ(columns_["m_p"], 3U);
  EXPECT_TRUE(same("exp2*e", symbol("exp2") * symbol("e")));
}

TEST_F(Expression, SaysWhereItIsWrong) {
  EXPECT_EQ(error_column("2*"), 3U);
  EXPECT_EQ(error_column("2 kg"), 3U);
  EXPECT_EQ(error_column("2e"), 2U);
  EXPECT_EQ(error_column("(1"), 3U);
  EXPECT_EQ(error_column("1)"), 2U);
  EXPECT_EQ(error_column("1.2.3"), 1U);
  EXPECT_EQ(error_column("2 * cos(1)"), 5U);
  EXPECT_EQ(error_column(""), 1U);
  for (const std::string bad :
       {"2**3", "1/0", "0^-1", "sqrt(-1)", "sqrt(x)", "2^0.5", "2^x", "nan", "inf", "m$", "sqrt"}) {
    EXPECT_THROW(parse(bad), ExpressionError) << bad;
  }
}

TEST_F(Expression, IsBounded) {
  EXPECT_THROW(parse("((((((pi^1000)^1000)^1000)^1000)^1000)^1000)^1000"), ExpressionError);
  EXPECT_THROW(parse("1/((((((pi^1000)^1000)^1000)^1000)^1000)^1000)^1000"), ExpressionError);
  EXPECT_NO_THROW(parse(std::string(90, '(') + "1" + std::string(90, ')')));
  EXPECT_THROW(parse(std::string(20000, '(')), ExpressionError);
  EXPECT_THROW(parse(std::string(9000, '(')), ExpressionError);
  EXPECT_THROW(parse(std::string(9000, '-') + "1"), ExpressionError);
  EXPECT_THROW(parse("((9^999)^999)^999"), ExpressionError);
  EXPECT_THROW(parse("(a + b)^1000"), ExpressionError);
  EXPECT_THROW(parse("1e99999"), ExpressionError);
}

}  // namespace
}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
// Code as it is printed: parentheses, signs, and what languages write in a way of their own.
#include "code/emit/printer.hpp"

#include <gtest/gtest.h>

#include "code/languages/c/dialect.hpp"
#include "code/languages/cpp/dialect.hpp"
#include "code/languages/javascript/dialect.hpp"

namespace flatdyn {
namespace {

using code::Expression;

std::string printed(const Dialect& dialect, const Expression& expression) {
  const HeaderScope scope(dialect);
  return Printer(scope).text(expression);
}

std::string printed(const Dialect& dialect, const code::Statement& statement) {
  const HeaderScope scope(dialect);
  return Printer(scope).text(code::Statements{statement});
}

const CppDialect& cpp() {
  static const CppDialect dialect;
  return dialect;
}

const CDialect& floats_in_c() {
  static const CDialect dialect("float", "arm");
  return dialect;
}

const JavascriptDialect& javascript() {
  static const JavascriptDialect dialect;
  return dialect;
}

Expression variable(const char* name) { return code::Variable{name}; }
Expression half() { return code::Literal{Rational(-1, 2)}; }

TEST(Printer, KeepsTheOrderOfEvaluation) {
  const Expression sum = code::Sum{{{false, variable("a")}, {true, variable("b")}}};
  EXPECT_EQ(printed(cpp(), code::Product{{sum, variable("c")}}), "(a - b) * c");
  EXPECT_EQ(printed(cpp(), code::Sum{{{false, variable("c")}, {true, sum}}}), "c - (a - b)");
  EXPECT_EQ(printed(cpp(), code::Quotient{{sum, code::Product{{variable("a"), variable("b")}}}}), "(a - b) / (a * b)");
  EXPECT_EQ(printed(cpp(), code::Negation{{sum}}), "-(a - b)");
}

// A C compiler reads "a * -0.5f" correctly, but people should not have to.
TEST(Printer, NegativeConstantsNeverMeetASign) {
  EXPECT_EQ(printed(floats_in_c(), code::Product{{half(), variable("a")}}), "-0.5f * a");
  EXPECT_EQ(printed(floats_in_c(), code::Product{{variable("a"), half()}}), "a * (-0.5f)");
  EXPECT_EQ(printed(cpp(), code::Product{{variable("a"), half()}}), "a * Scalar(-0.5)");
  const Expression product = code::Product{{half(), variable("a")}};
  EXPECT_EQ(printed(floats_in_c(), code::Product{{variable("b"), product}}), "b * (-0.5f * a)");
}

// Compilers of JavaScript keep the order of sums, so that no function has to hide one.
TEST(Printer, WritesTheExcessOfASumAsLanguagesNeedIt) {
  const Expression scale = code::Sum{{{true, variable("b")}}};
  const Expression sum = code::Sum{{{true, variable("b")}, {false, variable("D")}}};
  const Expression excess = code::Call{code::Operation::excess, {sum, scale}};
  EXPECT_EQ(printed(cpp(), excess), "detail::Excess<Scalar>::of(-b + D, -b)");
  EXPECT_EQ(printed(floats_in_c(), excess), "arm_excess(-b + D, -b)");
  EXPECT_EQ(printed(javascript(), excess), "-b + D + b");
}

TEST(Printer, StoresEqualEntriesTogether) {
  const code::Store store{{code::Element{"B", 1}, code::Element{"B", 2}}, variable("b_12")};
  EXPECT_EQ(printed(cpp(), code::Statement(store)), "  B[1] = B[2] = b_12;\n");
}

TEST(Printer, StoresZerosTogether) {
  EXPECT_EQ(printed(cpp(), code::Statement(code::StoreZeros{"B", 3, 12})), "  detail::Zeros::store<9>(B + 3);\n");
  EXPECT_EQ(printed(cpp(), code::Statement(code::StoreZeros{"B", 0, 4})), "  detail::Zeros::store<4>(B);\n");
}

TEST(Printer, BeginsAndContinuesTheVerdict) {
  const code::Condition positive = code::Positive{variable("D")};
  EXPECT_EQ(printed(floats_in_c(), code::Statement(code::Check{true, positive})), "  bool valid = D > 0.0f;\n");
  EXPECT_EQ(printed(javascript(), code::Statement(code::Check{false, positive})), "  valid &&= D > 0.0;\n");
  EXPECT_EQ(printed(cpp(), code::Statement(code::CheckFinite{"tau", 0, 2})),
            "  for (int k = 0; k < 2; ++k) valid &= Scalar(0.0) * tau[k] < Scalar(1.0);\n");
}

TEST(Printer, DeclaresFusedOperationsWhereTheyAreUsed) {
  const Expression fused = code::Call{code::Operation::multiply_add, {variable("a"), variable("b"), variable("c")}};
  EXPECT_EQ(printed(cpp(), code::Statement(code::Define{{{"t1", fused}}})),
            "  constexpr detail::MultiplyAdd<Scalar> fma{};\n  const Scalar t1 = fma(a, b, c);\n");
  EXPECT_EQ(printed(floats_in_c(), code::Statement(code::Define{{{"t1", fused}}})),
            "  const float t1 = arm_fma(a, b, c);\n");
}

}  // namespace
}  // namespace flatdyn

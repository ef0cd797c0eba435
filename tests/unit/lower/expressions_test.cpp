// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/expressions.hpp"

#include <gtest/gtest.h>

#include "code/emit/printer.hpp"
#include "code/languages/cpp/dialect.hpp"
#include "unit/emit/hand_made.hpp"

namespace flatdyn {
namespace {

// a, b, c are q[0], q[1], q[2]; everything else is written out.
class Expressions : public ::testing::Test {
 protected:
  std::string text(NodeId id) { return printed(id, {}); }
  // The text with these products fused.
  std::string fused(NodeId id, const std::vector<NodeId>& products) {
    std::vector<bool> is_fused(static_cast<std::size_t>(build.graph.size()));
    for (const NodeId product : products) is_fused[static_cast<std::size_t>(product)] = true;
    return printed(id, is_fused);
  }
  NodeId negative(NodeId id) { return build.scaled("-1", id); }

  testing::Builder build;
  NodeId a = build.q(0), b = build.q(1), c = build.q(2);

 private:
  std::string printed(NodeId id, const std::vector<bool>& is_fused) {
    VariableNames names(static_cast<std::size_t>(build.graph.size()));
    names[static_cast<std::size_t>(a)] = "a";
    names[static_cast<std::size_t>(b)] = "b";
    names[static_cast<std::size_t>(c)] = "c";
    const CppDialect dialect;
    const HeaderScope scope(dialect);
    return Printer(scope).text(NodeExpressions(build.graph, names, is_fused).definition(id));
  }
};

TEST_F(Expressions, SubtractInsteadOfAddingANegative) {
  EXPECT_EQ(text(build.plus({a, negative(b)})), "a - b");
  EXPECT_EQ(text(build.plus({build.number("1"), negative(build.times({a, a}))})), "Scalar(1.0) - a * a");
  EXPECT_EQ(text(build.plus({a, build.scaled("-1/2", b)})), "a - Scalar(0.5) * b");
  EXPECT_EQ(text(build.plus({a, build.number("-2")})), "a - Scalar(2.0)");
}

TEST_F(Expressions, StartWithAPositiveTermIfThereIsOne) {
  EXPECT_EQ(text(build.plus({negative(a), b, negative(c)})), "b - a - c");
  EXPECT_EQ(text(build.plus({negative(a), build.number("1")})), "Scalar(1.0) - a");
}

TEST_F(Expressions, LeadingMinusWhenAllIsNegative) {
  EXPECT_EQ(text(negative(a)), "-a");
  EXPECT_EQ(text(negative(build.times({a, b}))), "-a * b");
  EXPECT_EQ(text(build.scaled("-1/2", a)), "Scalar(-0.5) * a");
  EXPECT_EQ(text(negative(build.plus({a, b}))), "-a - b");
}

TEST_F(Expressions, SumsAreInParenthesesWithinProducts) {
  EXPECT_EQ(text(build.times({a, build.plus({b, c})})), "a * (b + c)");
  EXPECT_EQ(text(build.scaled("2", build.plus({b, negative(c)}))), "Scalar(2.0) * (b - c)");
  EXPECT_EQ(text(build.plus({a, negative(build.plus({b, c}))})), "a - (b + c)");
}

TEST_F(Expressions, SmallTermsOfASumComeFirst) {
  EXPECT_EQ(text(build.plus({build.scaled("100", a), b, build.scaled("-1/100", c)})),
            "b - Scalar(0.01) * c + Scalar(100.0) * a");
  EXPECT_EQ(text(build.plus({build.scaled("-100", a), build.scaled("-1/100", b), build.number("1000")})),
            "Scalar(-0.01) * b - Scalar(100.0) * a + Scalar(1000.0)");
}

TEST_F(Expressions, FusedProductsAreAddedToTheRest) {
  const NodeId ab = build.times({a, b}), bc = build.times({b, c});
  EXPECT_EQ(fused(build.plus({ab, c}), {ab}), "fma(a, b, c)");
  EXPECT_EQ(fused(build.plus({negative(ab), negative(c)}), {ab}), "fma(-a, b, -c)");
  EXPECT_EQ(fused(build.plus({ab, bc}), {ab, bc}), "fma(b, c, a * b)");
  EXPECT_EQ(fused(build.plus({ab, bc, a, build.number("2")}), {ab, bc}), "fma(b, c, fma(a, b, a + Scalar(2.0)))");
  EXPECT_EQ(fused(build.plus({build.scaled("-3", a), build.scaled("1/2", bc), b}), {}),
            "fma(Scalar(-3.0), a, fma(Scalar(0.5), b * c, b))");
  EXPECT_EQ(fused(build.plus({ab, c}), {}), "c + a * b");
}

TEST_F(Expressions, FusedProductsOfSumsNeedNoParentheses) {
  const NodeId product = build.times({build.plus({a, b}), build.plus({b, c})});
  EXPECT_EQ(fused(build.plus({product, a}), {product}), "fma(a + b, b + c, a)");
  EXPECT_EQ(fused(build.plus({a, negative(product)}), {product}), "fma(-(a + b), b + c, a)");
  const NodeId cube = build.times({a, a, build.plus({b, c})});
  EXPECT_EQ(fused(build.plus({a, negative(cube)}), {cube}), "fma(-a * a, b + c, a)");
}

TEST_F(Expressions, PowersAreProducts) { EXPECT_EQ(text(build.times({a, a, a})), "a * a * a"); }

TEST_F(Expressions, QuotientsKeepTheirStructure) {
  const auto over = [this](NodeId x, NodeId y) { return build.graph.quotient(x, y); };
  EXPECT_EQ(text(over(a, b)), "a / b");
  EXPECT_EQ(text(over(build.times({a, b}), c)), "a * b / c");
  EXPECT_EQ(text(over(a, build.times({b, c}))), "a / (b * c)");
  EXPECT_EQ(text(over(build.plus({a, b}), build.plus({b, c}))), "(a + b) / (b + c)");
  EXPECT_EQ(text(over(over(a, b), c)), "(a / b) / c");
  EXPECT_EQ(text(over(a, over(b, c))), "a / (b / c)");
  EXPECT_EQ(text(build.times({a, over(b, c)})), "a * (b / c)");
  EXPECT_EQ(text(build.plus({a, negative(over(b, c))})), "a - b / c");
  EXPECT_EQ(text(negative(over(b, c))), "-b / c");
}

TEST_F(Expressions, FunctionsAndConstants) {
  EXPECT_EQ(text(build.graph.sign(a)), "detail::sign(a)");
  EXPECT_EQ(text(build.graph.sqrt(a)), "detail::sqrt(a)");
  EXPECT_EQ(text(build.number("-3/2")), "Scalar(-1.5)");
}

}  // namespace
}  // namespace flatdyn

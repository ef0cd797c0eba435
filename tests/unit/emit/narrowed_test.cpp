// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/narrowed.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace flatdyn {
namespace {

// The function tau = q Π (constant + qd), in which all constants are written.
Function with_constants(const std::string& name, const std::vector<Rational>& constants) {
  Function function;
  function.name = name;
  Graph& graph = function.graph;
  std::vector<NodeId> factors = {graph.input({InputKind::q, 0})};
  const NodeId rate = graph.input({InputKind::qd, 0});
  for (const Rational& constant : constants) factors.push_back(graph.sum({{1, rate}}, constant));
  function.outputs.push_back({"tau", Layout::vector, 1, 1, {graph.product(factors)}, ""});
  graph.scaled(Rational("1" + std::string(60, '0')), rate);  // an unused node, which is not written
  return function;
}

Rational tenth_to(std::size_t power) { return Rational("1/1" + std::string(power, '0')); }
Rational ten_to(std::size_t power) { return Rational("1" + std::string(power, '0')); }

TEST(Narrowed, NothingThatFloatHas) {
  const Rational subnormal{static_cast<double>(std::numeric_limits<float>::denorm_min())};  // exact in float
  EXPECT_TRUE(
      narrowed_constants({with_constants("f", {1, Rational("1/3"), tenth_to(37), ten_to(38), subnormal})}).empty());
  Diagnostics findings;
  warn_of_narrowed({}, {}, findings);
  EXPECT_FALSE(findings.has_warnings());
}

TEST(Narrowed, TheWorstFirstEachOnce) {
  const auto found = narrowed_constants({with_constants("f", {tenth_to(42), tenth_to(50)}),
                                         with_constants("g", {-tenth_to(50), -ten_to(40), tenth_to(60)})});
  ASSERT_EQ(found.size(), 4U);
  EXPECT_EQ(found[0].value, 1e40);
  EXPECT_EQ(found[0].becomes, std::numeric_limits<float>::infinity());
  EXPECT_EQ(found[0].function, "g");
  EXPECT_EQ(found[1].value, 1e-60);
  EXPECT_EQ(found[1].becomes, 0.0F);
  EXPECT_EQ(found[2].value, 1e-50);
  EXPECT_EQ(found[2].function, "f");
  EXPECT_EQ(found[3].value, 1e-42);
  EXPECT_GT(found[3].becomes, 0.0F);
}

TEST(Narrowed, AFewOfThemAreNamed) {
  std::vector<Rational> constants;
  for (std::size_t power = 50; power < 60; ++power) constants.push_back(tenth_to(power));
  Diagnostics findings;
  warn_of_narrowed(narrowed_constants({with_constants("f", constants)}), {"arm.urdf", 0}, findings);
  ASSERT_EQ(findings.all().size(), 1U);
  EXPECT_EQ(findings.all()[0].message,
            "float is too narrow for constants of the code: 1e-59 becomes 0 (f), 1e-58 becomes 0 (f), 1e-57 becomes 0 "
            "(f), 1e-56 becomes 0 (f), and 6 more");
}

}  // namespace
}  // namespace flatdyn

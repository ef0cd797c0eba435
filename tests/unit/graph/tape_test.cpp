// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/tape.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace flatdyn {
namespace {

class TapeTest : public ::testing::Test {
 protected:
  Function function;
  Graph& graph = function.graph;
  NodeId a = graph.input({InputKind::q, 0}), b = graph.input({InputKind::q, 1});

  std::vector<double> values(double x, double y) {
    const std::vector<double> q = {x, y};
    TapeInputs given;
    given[InputKind::q] = q;
    Tape tape(function);
    std::vector<double> results(tape.results());
    is_regular = tape.run(given, results);
    return results;
  }
  bool is_regular = false;
};

TEST_F(TapeTest, ComputesEveryOperation) {
  const NodeId y = graph.sum({{Rational(1, 4), graph.product({a, graph.sin(b), a})}, {-1, b}, {1, graph.cos(a)}}, 5);
  const NodeId z = graph.sum({{-3, graph.quotient(a, b)}, {2, graph.sign(graph.sum({{1, a}, {-1, b}}))}});
  function.outputs = {{"y", Layout::scalar, 1, 1, {y}, "anything"},
                      {"z", Layout::vector, 2, 1, {z, graph.constant(Rational(1, 8))}, "anything"}};
  EXPECT_EQ(values(2, 0.5),
            (std::vector<double>{4 * std::sin(0.5) / 4 - 0.5 + std::cos(2.0) + 5, -3 * 4.0 + 2, 0.125}));
  EXPECT_EQ(values(0.5, 0.5)[1], -3);
  function.outputs = {{"r", Layout::scalar, 1, 1, {graph.sqrt(a)}, "anything"}};
  EXPECT_EQ(values(2.25, 0), std::vector<double>{1.5});
}

TEST_F(TapeTest, SaysWhereAPivotIsNotPositive) {
  function.outputs = {{"y", Layout::scalar, 1, 1, {b}, "anything"}};
  function.validity_conditions = {a};
  values(1, 2);
  EXPECT_TRUE(is_regular);
  for (const double pivot : {0.0, -1.0, std::nan("")}) {
    values(pivot, 2);
    EXPECT_FALSE(is_regular);
  }
}

TEST_F(TapeTest, UsesOneInstructionPerTermAndFactor) {
  const NodeId sum = graph.sum({{2, a}, {1, b}});
  function.outputs = {{"y", Layout::scalar, 1, 1, {graph.product({sum, a, b})}, "anything"}};
  EXPECT_EQ(Tape(function).operations(), 3U);
}

}  // namespace
}  // namespace flatdyn

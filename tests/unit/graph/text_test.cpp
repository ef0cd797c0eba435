// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/text.hpp"

#include <gtest/gtest.h>

#include "unit/graph/function_text.hpp"

namespace flatdyn {
namespace {

// One node of each kind, a scaled node as an operand, an entry that nobody needs, a pivot and a loop.
Function one_of_each() {
  Function f;
  f.name = "example";
  f.summary = "one node of each kind";
  f.equation = "(7.42)";
  f.inputs = {InputKind::q, InputKind::qd_r, InputKind::pi_b};
  f.base_parameters = 3;
  f.at_rest = true;
  f.task = {{0, 2}, Orientation::zyz, Rational(1, 10)};
  Graph& g = f.graph;
  const NodeId q = g.input({InputKind::q, 1}), pi = g.input({InputKind::pi_b, 2});
  const NodeId s = g.sin(q), c = g.cos(q), sign = g.sign(pi), root = g.sqrt(pi);
  g.set_name(s, "s_2");
  const NodeId sum = g.sum({{Rational(1, 2), s}, {-1, c}}, Rational(-981, 100));
  const NodeId product = g.product({sum, sum, pi}), quotient = g.quotient(product, root);
  const NodeId kept = g.product_without_folding({g.scaled(3, sum), sign});
  f.outputs.push_back({"tau", Layout::vector, 3, 1, {quotient, g.constant(0), kept}, "joint torques, N m", {}});
  f.outputs.push_back({"B", Layout::matrix, 1, 2, {g.constant(0), g.constant(Rational(7, 3))}, "", {true, false}});
  f.validity_conditions = {root, product};
  f.pivot_scales = {pi};
  f.loop_conditions = 1;
  return f;
}

TEST(FunctionText, IsReadBackAsTheSameFunction) {
  const Function written = one_of_each();
  const Function read = testing::function_from_text(to_text(written));
  ASSERT_EQ(read.graph.size(), written.graph.size());
  for (NodeId id = 0; id < read.graph.size(); ++id) EXPECT_EQ(read.graph[id], written.graph[id]) << id;
  ASSERT_EQ(read.outputs.size(), 2u);
  EXPECT_EQ(read.outputs[0].entries, written.outputs[0].entries);
  EXPECT_EQ(read.outputs[1].left_out, written.outputs[1].left_out);
  EXPECT_EQ(read.validity_conditions, written.validity_conditions);
  EXPECT_EQ(read.task.rows, written.task.rows);
  EXPECT_EQ(to_text(read), to_text(written));
}

TEST(FunctionText, HasANodeALine) {
  const std::string text = to_text(one_of_each());
  EXPECT_NE(text.find("\n  %0 = q[1]\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n  %2 = sin %0                           ; s_2\n"), std::string::npos) << text;
  EXPECT_NE(text.find("conditions:\n  %5 pivot of %1\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace flatdyn

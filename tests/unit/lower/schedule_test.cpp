// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/lower/schedule.hpp"

#include <gtest/gtest.h>

#include "code/emit/function_text.hpp"
#include "code/languages/cpp/dialect.hpp"
#include "unit/emit/hand_made.hpp"

namespace flatdyn {
namespace {

class Schedules : public ::testing::Test {
 protected:
  // The body of a function with these outputs in a vector "y".
  std::string body(std::vector<NodeId> entries) {
    Function function;
    function.name = "f";
    function.inputs = {InputKind::q};
    function.graph = build.graph;
    const int rows = static_cast<int>(entries.size());
    function.outputs = {{"y", Layout::vector, rows, 1, std::move(entries), ""}};
    const CppDialect dialect;
    HeaderScope scope(dialect);
    scope.counts = 9;
    return function_text(function, "f", scope).body;
  }

  testing::Builder build;
};

TEST_F(Schedules, ShareWhatIsUsedTwiceAndInlineTheRest) {
  const NodeId shared = build.graph.quotient(build.q(0), build.q(1));
  EXPECT_EQ(body({build.plus({shared, build.q(2)}), build.times({shared, build.plus({build.q(2), build.q(3)})})}),
            "  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2], q_4 = q[3];\n"
            "  const Scalar t1 = q_1 / q_2;\n"
            "  y[0] = t1 + q_3;\n"
            "  y[1] = t1 * (q_3 + q_4);\n");
}

TEST_F(Schedules, AskForAllSinesAndCosinesFirstInOneCall) {
  EXPECT_EQ(body({build.times({build.graph.cos(build.q(0)), build.graph.cos(build.q(2))}), build.graph.sin(build.q(2)),
                  build.q(1)}),
            "  const Scalar q_2 = q[1];\n"
            "  Scalar sine[joint_count], cosine[joint_count];\n"
            "  sin_cos(q, Joints<0, 2>(), sine, cosine);\n"
            "  const Scalar c_1 = cosine[0], s_3 = sine[2], c_3 = cosine[2];\n"
            "  y[2] = q_2;\n"
            "  y[1] = s_3;\n"
            "  y[0] = c_1 * c_3;\n");
}

// All sines and cosines that can be computed at a time are, and those of angles that depend on them come later.
TEST_F(Schedules, ComputeSinesOfComputedAnglesInRounds) {
  Graph& graph = build.graph;
  const NodeId a = build.plus({build.q(0), build.q(1)}), b = build.plus({build.q(0), build.number("1")});
  const NodeId c = build.plus({build.q(1), graph.sin(a)});
  EXPECT_EQ(body({graph.cos(a), graph.sin(b), graph.sin(c), graph.cos(build.q(1))}),
            "  const Scalar q_1 = q[0], q_2 = q[1];\n"
            "  Scalar sine[joint_count], cosine[joint_count];\n"
            "  sin_cos(q, Joints<1>(), sine, cosine);\n"
            "  const Scalar c_2 = cosine[1];\n"
            "  y[3] = c_2;\n"
            "  const Scalar t1 = q_1 + q_2;\n"
            "  const Scalar t2 = q_1 + Scalar(1.0);\n"
            "  Scalar angle_1[2], sine_1[2], cosine_1[2];\n"
            "  angle_1[0] = t1;\n"
            "  angle_1[1] = t2;\n"
            "  DefaultSinCos()(angle_1, Joints<0, 1>(), sine_1, cosine_1);\n"
            "  const Scalar t3 = sine_1[0], t4 = cosine_1[0], t5 = sine_1[1];\n"
            "  y[0] = t4;\n"
            "  y[1] = t5;\n"
            "  const Scalar t6 = t3 + q_2;\n"
            "  Scalar angle_2[1], sine_2[1], cosine_2[1];\n"
            "  angle_2[0] = t6;\n"
            "  DefaultSinCos()(angle_2, Joints<0>(), sine_2, cosine_2);\n"
            "  const Scalar t7 = sine_2[0];\n"
            "  y[2] = t7;\n");
}

TEST_F(Schedules, StoreEqualEntriesTogetherAndZerosLast) {
  const NodeId zero = build.number("0");
  const NodeId shared = build.plus({build.q(0), build.number("1")});
  EXPECT_EQ(body({zero, shared, shared, zero}),
            "  const Scalar q_1 = q[0];\n"
            "  y[1] = y[2] = q_1 + Scalar(1.0);\n"
            "  y[0] = y[3] = Scalar(0.0);\n");
}

TEST_F(Schedules, WriteANegativeWhereItIsUsed) {
  const NodeId product = build.times({build.q(0), build.q(1)});
  EXPECT_EQ(body({build.scaled("-1", product), product}),
            "  const Scalar q_1 = q[0], q_2 = q[1];\n"
            "  const Scalar y_2 = q_1 * q_2;\n"
            "  y[1] = y_2;\n"
            "  y[0] = -y_2;\n");
}

TEST_F(Schedules, NameSumsEvenIfUsedOnce) {
  const NodeId named = build.named(build.plus({build.q(0), build.q(1)}), "omega_2_z");
  EXPECT_EQ(body({build.times({named, build.q(2)})}),
            "  const Scalar q_1 = q[0], q_2 = q[1], q_3 = q[2];\n"
            "  const Scalar omega_2_z = q_1 + q_2;\n"
            "  y[0] = omega_2_z * q_3;\n");
}

// Expressions stay readable: no line is longer than a hundred columns.
TEST_F(Schedules, SplitLongExpressions) {
  std::vector<NodeId> products;
  for (int k = 0; k < 30; ++k) {
    const NodeId difference =
        build.plus({build.q(k), build.scaled("-2", build.q(k + 1)), build.scaled("3/7", build.q(k + 2))});
    products.push_back(build.times({difference, build.q(k + 3), build.q(k + 4)}));
  }
  const std::string text = body({build.plus(products)});
  std::size_t longest = 0;
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    longest = std::max(longest, end - begin);
  }
  EXPECT_LE(longest, 100u) << text;
  EXPECT_GT(longest, 80u) << text;
}

TEST_F(Schedules, StatementsFollowWhatTheyUse) {
  const Function function = testing::two_link_inverse_dynamics();
  const Schedule schedule = make_schedule(function, std::vector<bool>(static_cast<std::size_t>(function.graph.size())));
  std::vector<bool> made(schedule.is_variable.size(), false);
  for (const Statement& statement : schedule.statements) {
    for (NodeId operand : operands_of(function.graph[statement.node])) {
      const auto k = static_cast<std::size_t>(operand);
      const bool needs_statement = schedule.is_variable[k] && function.graph[operand].op != Op::input;
      EXPECT_TRUE(made[k] || !needs_statement);
    }
    if (statement.targets.empty()) made[static_cast<std::size_t>(statement.node)] = true;
  }
}

}  // namespace
}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/graph.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace flatdyn {
namespace {

class GraphTest : public ::testing::Test {
 protected:
  Graph graph;
  NodeId a = graph.input({InputKind::q, 0}), b = graph.input({InputKind::q, 1}), c = graph.input({InputKind::q, 2});
  NodeId one = graph.constant(1), zero = graph.constant(0);

  NodeId minus(NodeId x) { return graph.scaled(-1, x); }
};

TEST_F(GraphTest, MakesANodeOnce) {
  EXPECT_EQ(graph.input({InputKind::q, 0}), a);
  EXPECT_NE(graph.input({InputKind::qd, 0}), a);
  EXPECT_EQ(graph.constant(Rational(2, 4)), graph.constant(Rational(1, 2)));
  EXPECT_EQ(graph.product({a, b}), graph.product({b, a}));
}

// The rest has the ids, names and normal form that it would have if nothing else had been made.
TEST_F(GraphTest, RemovesNodes) {
  const NodeId product = graph.product({a, c});
  const NodeId sum = graph.sum({{2, product}, {1, c}}, 5), sine = graph.sin(c);
  graph.set_name(product, "kept");
  graph.set_name(sine, "removed");
  graph.set_name(sum, "sum");
  std::vector<bool> kept(static_cast<std::size_t>(graph.size()), false);
  for (const NodeId id : {a, c, product, sum}) kept[static_cast<std::size_t>(id)] = true;
  const std::vector<NodeId> image = graph.remove_all_but(kept);
  EXPECT_EQ(graph.size(), 4);
  EXPECT_EQ(image[static_cast<std::size_t>(b)], -1);
  const NodeId new_a = image[static_cast<std::size_t>(a)], new_c = image[static_cast<std::size_t>(c)];
  const NodeId new_sum = image[static_cast<std::size_t>(sum)], new_product = graph.product({new_c, new_a});
  EXPECT_EQ(new_product, image[static_cast<std::size_t>(product)]);
  EXPECT_EQ(graph.sum({{1, new_c}, {2, new_product}}, 5), new_sum);
  EXPECT_EQ(graph.size(), 4);
  EXPECT_EQ(*graph.name(new_product), "kept");
  EXPECT_EQ(*graph.name(new_sum), "sum");
  EXPECT_EQ(graph.name(graph.sin(new_c)), nullptr);
}

TEST_F(GraphTest, CollectsLikeTerms) {
  EXPECT_EQ(graph.sum({{1, a}, {2, b}, {3, a}}), graph.sum({{4, a}, {2, b}}));
  EXPECT_EQ(graph.sum({{1, a}, {-1, a}}), zero);
  EXPECT_EQ(graph.sum({{1, a}}), a);
  EXPECT_EQ(graph.sum({}, 7), graph.constant(7));
}

TEST_F(GraphTest, FoldsConstantsAndScaledNodesIntoSums) {
  const NodeId sum = graph.sum({{3, one}, {2, graph.scaled(5, a)}}, 4);
  EXPECT_EQ(sum, graph.sum({{10, a}}, 7));
  EXPECT_EQ(graph.scaled(0, a), zero);
  EXPECT_EQ(graph.scaled(2, graph.scaled(Rational(1, 2), a)), a);
}

TEST_F(GraphTest, KeepsASumWithinASumAsANodeOfItsOwn) {
  const NodeId dot = graph.sum({{1, a}, {1, b}});
  const Node& cross = graph[graph.sum({{1, dot}, {1, c}})];
  ASSERT_EQ(cross.terms.size(), 2u);
  EXPECT_TRUE(cross.terms[0].node == dot || cross.terms[1].node == dot);
}

TEST_F(GraphTest, SharesSumsThatDifferBySign) {
  const NodeId difference = graph.sum({{1, a}, {-1, b}});
  EXPECT_EQ(graph.sum({{1, b}, {-1, a}}), minus(difference));
  EXPECT_EQ(graph.sum({{-2, a}}, 3), minus(graph.sum({{2, a}}, -3)));
}

TEST_F(GraphTest, PullsCoefficientsOutOfProducts) {
  const NodeId product = graph.product({graph.scaled(2, a), minus(b), graph.product({graph.constant(3), c})});
  EXPECT_EQ(product, graph.scaled(-6, graph.product({a, b, c})));
  EXPECT_EQ(graph[graph.product({a, graph.product({b, a})})].operands, (std::vector<NodeId>{a, a, b}));
}

TEST_F(GraphTest, KnowsZeroAndOneInProducts) {
  EXPECT_EQ(graph.product({a, zero, b}), zero);
  EXPECT_EQ(graph.product({one, a}), a);
  EXPECT_EQ(graph.product({}), one);
}

TEST_F(GraphTest, SimplifiesQuotients) {
  EXPECT_EQ(graph.quotient(a, graph.constant(4)), graph.scaled(Rational(1, 4), a));
  EXPECT_EQ(graph.quotient(zero, a), zero);
  EXPECT_EQ(graph.quotient(a, a), one);
  EXPECT_EQ(graph.quotient(graph.scaled(6, a), graph.scaled(-3, b)), graph.scaled(-2, graph.quotient(a, b)));
  EXPECT_EQ(graph.quotient(graph.constant(-3), graph.scaled(2, a)),
            minus(graph.quotient(graph.constant(Rational(3, 2)), a)));
  EXPECT_THROW(graph.quotient(a, zero), std::domain_error);
}

TEST_F(GraphTest, KnowsTheSymmetriesOfSinAndCos) {
  EXPECT_EQ(graph.sin(zero), zero);
  EXPECT_EQ(graph.cos(zero), one);
  EXPECT_EQ(graph.sin(minus(a)), minus(graph.sin(a)));
  EXPECT_EQ(graph.cos(minus(a)), graph.cos(a));
  EXPECT_EQ(graph.sin(graph.scaled(-2, a)), minus(graph.sin(graph.scaled(2, a))));
  EXPECT_EQ(graph.cos(graph.sum({{1, b}, {-1, a}})), graph.cos(graph.sum({{1, a}, {-1, b}})));
}

TEST_F(GraphTest, TakesSignsOfScaledNodes) {
  EXPECT_EQ(graph.sign(graph.constant(Rational(-1, 3))), graph.constant(-1));
  EXPECT_EQ(graph.sign(zero), zero);
  EXPECT_EQ(graph.sign(graph.scaled(5, a)), graph.sign(a));
  EXPECT_EQ(graph.sign(graph.scaled(-5, a)), minus(graph.sign(a)));
  EXPECT_EQ(graph.sign(graph.sign(a)), graph.sign(a));
}

TEST_F(GraphTest, KeepsSharedOperandsIfAskedTo) {
  const NodeId doubled = graph.scaled(2, a), ab = graph.product({a, b});
  const Node sum = graph[graph.sum_without_folding({{-1, doubled}, {1, b}})];
  EXPECT_TRUE(sum.op == Op::sum && (sum.terms[0].node == doubled || sum.terms[1].node == doubled ||
                                    graph[sum.terms[0].node].terms.size() == 2));
  EXPECT_EQ(graph.sum_without_folding({{3, doubled}, {1, b}}), graph.sum({{6, a}, {1, b}}));
  EXPECT_EQ(graph[graph.product_without_folding({ab, c})].operands, (std::vector<NodeId>{c, ab}));
  EXPECT_EQ(graph.product_without_folding({minus(a), b}), minus(ab));
}

TEST_F(GraphTest, KeepsTheFirstName) {
  const NodeId sum = graph.sum({{1, a}, {1, b}});
  graph.set_name(sum, "first");
  graph.set_name(sum, "second");
  graph.set_name(a, "q");
  ASSERT_NE(graph.name(sum), nullptr);
  EXPECT_EQ(*graph.name(sum), "first");
  EXPECT_EQ(graph.name(a), nullptr);
}

TEST_F(GraphTest, FindsWhatRootsReach) {
  const NodeId used = graph.sin(a), unused = graph.sin(b);
  const std::vector<bool> reached = reachable_from(graph, {graph.product({used, c})});
  const auto is_reached = [&](NodeId id) { return static_cast<bool>(reached[static_cast<std::size_t>(id)]); };
  EXPECT_TRUE(is_reached(used) && is_reached(a) && is_reached(c));
  EXPECT_FALSE(is_reached(unused) || is_reached(b));
}

}  // namespace
}  // namespace flatdyn

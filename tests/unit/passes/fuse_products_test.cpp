// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/passes/fuse_products.hpp"

#include <gtest/gtest.h>

namespace flatdyn {
namespace {

class FuseProducts : public ::testing::Test {
 protected:
  struct Builder {
    NodeId q(int i) { return graph.input({InputKind::q, i}); }
    NodeId times(std::vector<NodeId> factors) { return graph.product(std::move(factors)); }
    NodeId scaled(const char* exact, NodeId node) { return graph.scaled(Rational(std::string(exact)), node); }
    NodeId plus(const std::vector<NodeId>& nodes) {
      std::vector<Term> terms;
      for (const NodeId node : nodes) terms.push_back({1, node});
      return graph.sum(std::move(terms));
    }

    Graph graph;
  };

  Function function(std::vector<NodeId> entries) {
    Function result;
    result.graph = build.graph;
    const int rows = static_cast<int>(entries.size());
    result.outputs = {{"y", Layout::vector, rows, 1, std::move(entries), ""}};
    return result;
  }
  bool is_fused(const Function& of, NodeId id) { return products_to_fuse(of)[static_cast<std::size_t>(id)]; }
  static void expect_count(const Function& of, int multiplications, int additions, int fused) {
    const OperationCount count = operations_as_written(of, true);
    EXPECT_EQ(count.multiplications, multiplications);
    EXPECT_EQ(count.additions, additions);
    EXPECT_EQ(count.fused, fused);
  }

  Builder build;
  NodeId a = build.q(0), b = build.q(1), c = build.q(2), d = build.q(3), e = build.q(4);
};

TEST_F(FuseProducts, ASumStartsWithWhatIsNoProduct) {
  const Function of = function({build.plus({build.times({a, b}), build.times({c, d}), e})});
  expect_count(of, 0, 0, 2);
}

TEST_F(FuseProducts, ASumOfProductsStartsWithOneOfThem) {
  const Function of = function({build.plus({build.times({a, b}), build.times({c, d})})});
  expect_count(of, 1, 0, 1);
}

TEST_F(FuseProducts, NumbersAreFactors) {
  const Function of = function({build.plus({build.scaled("2", a), build.scaled("-1/3", build.times({b, c})), d})});
  expect_count(of, 1, 0, 2);
}

TEST_F(FuseProducts, AProductOfSeveralSumsIsMultipliedInEach) {
  const NodeId product = build.times({a, b});
  const Function of = function({build.plus({product, c}), build.plus({product, d})});
  EXPECT_TRUE(is_fused(of, product));
  expect_count(of, 0, 0, 2);
}

TEST_F(FuseProducts, AProductThatSeveralSumsStartWithIsComputedOnce) {
  const NodeId product = build.times({a, b});
  const Function of =
      function({build.plus({product, build.times({c, d})}), build.plus({product, build.times({d, e})})});
  EXPECT_FALSE(is_fused(of, product));
  expect_count(of, 1, 0, 2);
}

TEST_F(FuseProducts, AProductThatIsNeededElsewhereIsComputed) {
  const NodeId product = build.times({a, b});
  const Function of = function({build.plus({product, c}), product});
  EXPECT_FALSE(is_fused(of, product));
  expect_count(of, 1, 1, 0);
}

TEST_F(FuseProducts, AProductOfThreeFactorsIsMultipliedInOneSumOnly) {
  const NodeId product = build.times({a, b, c});
  const Function twice = function({build.plus({product, d}), build.plus({product, e})});
  EXPECT_FALSE(is_fused(twice, product));
  expect_count(twice, 2, 2, 0);
  expect_count(function({build.plus({product, d})}), 1, 0, 1);
}

}  // namespace
}  // namespace flatdyn

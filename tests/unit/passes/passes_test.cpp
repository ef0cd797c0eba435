// SPDX-License-Identifier: GPL-2.0-or-later
// Each pass on the smallest graph to which it applies. tests/property tests that values stay the same.
#include "graph/passes/passes.hpp"

#include <gtest/gtest.h>

#include "graph/mod_p.hpp"
#include "graph/passes/draft.hpp"
#include "graph/passes/like_terms.hpp"
#include "graph/passes/quotients.hpp"
#include "graph/passes/rescale.hpp"
#include "graph/passes/share_products.hpp"
#include "graph/passes/share_sums.hpp"
#include "graph/passes/trigonometric.hpp"
#include "graph/well_formed.hpp"

namespace flatdyn {
namespace {

class PassTest : public ::testing::Test {
 protected:
  Function function;
  Graph& graph = function.graph;
  NodeId a = input(0), b = input(1), c = input(2), d = input(3), x = input(4), y = input(5);

  NodeId input(int k) { return graph.input({InputKind::qd, k}); }
  NodeId mul(std::vector<NodeId> factors) { return graph.product(std::move(factors)); }

  // The count after a pass, which must not change a value.
  OperationCount after(Function (*pass)(const Function&), const std::vector<NodeId>& outputs) {
    function.inputs = {InputKind::q, InputKind::qd};
    function.outputs = {{"y", Layout::vector, static_cast<int>(outputs.size()), 1, outputs, "anything"}};
    const Function result = pass(function);
    EXPECT_EQ(check_well_formed(result), std::nullopt);
    ModPArithmetic<> arithmetic(1);
    const auto before_values = evaluate(function, arithmetic), after_values = evaluate(result, arithmetic);
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      EXPECT_EQ(before_values[static_cast<std::size_t>(outputs[k])],
                after_values[static_cast<std::size_t>(roots(result)[k])]);
    }
    return count_operations(result);
  }
  static OperationCount count(int multiplications, int additions) { return {additions, multiplications, 0, 0}; }
};

TEST_F(PassTest, DeadCodeGoesAndNamesStay) {
  const NodeId kept = graph.sum({{1, a}, {1, b}});
  graph.sum({{1, c}, {1, d}});
  graph.set_name(kept, "kept");
  EXPECT_EQ(after(without_dead_code, {kept}), count(0, 1));
  const Function result = without_dead_code(function);
  EXPECT_EQ(result.graph.size(), 3);
  EXPECT_EQ(*result.graph.name(roots(result)[0]), "kept");
}

TEST_F(PassTest, LikeTermsMergesASumUsedOnce) {
  const NodeId dot = graph.sum({{1, a}, {1, mul({b, c})}});
  EXPECT_EQ(after(like_terms, {graph.sum({{1, dot}, {-1, mul({b, c})}, {1, d}})}), count(0, 1));
}

TEST_F(PassTest, LikeTermsLooksIntoSharedSumsWhereTermsCancel) {
  const NodeId shared = graph.sum({{1, a}, {1, mul({b, c})}});
  EXPECT_EQ(after(like_terms, {shared, graph.sum({{1, shared}, {-1, a}})}), count(1, 1));
}

TEST_F(PassTest, ShareSumsFactorsWithinASum) {
  EXPECT_EQ(after(share_sums, {graph.sum({{1, mul({x, a})}, {1, mul({x, b})}, {-1, mul({x, c})}})}), count(1, 2));
}

TEST_F(PassTest, ShareSumsTakesOutACommonCoefficient) {
  EXPECT_EQ(after(share_sums, {graph.sum({{3, a}, {-3, b}, {3, c}, {1, d}})}), count(1, 3));
}

TEST_F(PassTest, ShareSumsSharesPartialSumsUpToSignAndFactor) {
  const NodeId first = graph.sum({{1, a}, {-2, b}, {1, c}});
  const NodeId second = graph.sum({{-3, a}, {6, b}, {1, d}});
  const NodeId third = graph.sum({{1, mul({x, a})}, {-2, mul({x, b})}, {1, y}});
  EXPECT_EQ(after(share_sums, {first, second, third}), count(3, 4));
}

TEST_F(PassTest, ShareSumsUsesASumThatIsThere) {
  const NodeId sum = graph.sum({{1, a}, {1, b}});
  EXPECT_EQ(after(share_sums, {sum, graph.sum({{1, a}, {1, b}, {1, c}})}), count(0, 2));
}

// c - (a - b + c) is b - a, which the inner sum contains, too.
TEST_F(PassTest, ShareSumsLooksIntoASumWhoseTermsCancel) {
  const NodeId sum = graph.sum({{1, a}, {-1, b}, {1, c}});
  EXPECT_EQ(after(share_sums, {sum, graph.sum({{1, c}, {-1, sum}})}), count(0, 2));
}

TEST_F(PassTest, QuotientsDivideAtOnceWhereAReciprocalIsUsedOnce) {
  const NodeId one = graph.constant(1), first = graph.quotient(one, a), second = graph.quotient(one, b);
  const OperationCount divided = after(quotients, {mul({first, x}), mul({second, x}), mul({second, y})});
  EXPECT_EQ(divided.multiplications, 2);
  EXPECT_EQ(divided.divisions, 2);
}

TEST_F(PassTest, ShareProductsSharesFactors) {
  EXPECT_EQ(after(share_products, {mul({a, b, x}), mul({a, b, y}), mul({a, b})}), count(3, 0));
  EXPECT_EQ(after(share_products, {mul({a, a, a, a, b})}), count(3, 0));
}

TEST_F(PassTest, ShareProductsSharesCoefficients) {
  const NodeId ab = mul({a, b});
  EXPECT_EQ(after(share_products, {graph.sum({{5, ab}, {1, x}}), graph.sum({{-5, ab}, {1, y}})}), count(2, 2));
  EXPECT_EQ(after(share_products, {graph.scaled(5, mul({a, x})), graph.scaled(5, mul({a, y}))}), count(3, 0));
}

TEST_F(PassTest, TrigonometricKnowsPythagoras) {
  const NodeId q = graph.input({InputKind::q, 0}), s = graph.sin(q), co = graph.cos(q);
  const NodeId sum = graph.sum({{2, mul({s, s, a})}, {2, mul({co, co, a})}, {1, b}});
  EXPECT_EQ(after(trigonometric, {sum}), count(1, 1));
}

TEST_F(PassTest, TrigonometricSharesWhatRotationsShare) {
  const NodeId q = graph.input({InputKind::q, 0}), s = graph.sin(q), co = graph.cos(q), sc = mul({s, co, c});
  // The moments of inertia (a, b, c = xx, yy, xy) rotated by q: their sum is invariant.
  const NodeId xx = graph.sum({{1, mul({co, co, a})}, {1, mul({s, s, b})}, {2, sc}});
  const NodeId yy = graph.sum({{1, mul({s, s, a})}, {1, mul({co, co, b})}, {-2, sc}});
  EXPECT_LT(after(trigonometric, {xx, yy}).arithmetic(), after(share_sums, {xx, yy}).arithmetic());
  // t = c (c (a - b) + 2 s c_xy), xx = b + t, yy = a - t
  EXPECT_EQ(after([](const Function& f) { return run_passes(f); }, {xx, yy}), (OperationCount{4, 4, 0, 2}));
}

TEST_F(PassTest, RescaleMovesAFactorToWhereItIsFree) {
  const NodeId sum = graph.sum({{4, a}, {4, b}});
  const NodeId first = graph.sum({{Rational(1, 4), sum}, {1, c}}), second = graph.sum({{Rational(1, 4), sum}, {1, d}});
  EXPECT_EQ(after(rescale, {first, second}), count(0, 3));
}

TEST_F(PassTest, TheTableNeverCostsAndRecordsWhatItDid) {
  const NodeId sum = graph.sum({{1, mul({x, a})}, {1, mul({x, b})}});
  after(without_dead_code, {sum, mul({sum, y})});
  std::vector<PassRecord> record;
  const Function result = run_passes(function, &record);
  EXPECT_EQ(count_operations(result), count(2, 1));
  ASSERT_GE(record.size(), pass_table().size());
  EXPECT_EQ(record[0].pass, pass_table()[0].name);
  EXPECT_EQ(record.front().before, count(3, 1));
  EXPECT_EQ(record.back().after, count(2, 1));
}

}  // namespace
}  // namespace flatdyn

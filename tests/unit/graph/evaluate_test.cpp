// SPDX-License-Identifier: GPL-2.0-or-later
#include "graph/evaluate.hpp"

#include <gmp.h>
#include <gtest/gtest.h>

#include <cmath>

#include "flatdyn/reference/real50.hpp"
#include "graph/arithmetic.hpp"
#include "graph/count.hpp"
#include "graph/mod_p.hpp"
#include "graph/well_formed.hpp"

namespace flatdyn {
namespace {

using reference::Real50;

class EvaluateTest : public ::testing::Test {
 protected:
  Function function;
  Graph& graph = function.graph;
  NodeId a = graph.input({InputKind::q, 0}), b = graph.input({InputKind::q, 1});

  void set_output(NodeId id) {
    function.inputs = {InputKind::q};
    function.outputs = {{"y", Layout::scalar, 1, 1, {id}, "anything"}};
  }
  template <class Arithmetic>
  typename Arithmetic::Scalar value(Arithmetic arithmetic) {
    return evaluate(function, arithmetic)[static_cast<std::size_t>(function.outputs[0].entries[0])];
  }
};

TEST_F(EvaluateTest, AgreesWithTheFormula) {
  set_output(graph.sum({{Rational(1, 3), graph.product({a, graph.sin(b)})}, {-2, graph.quotient(graph.cos(a), b)}}, 5));
  const auto formula = [](auto x, auto y) {
    using std::cos, std::sin;
    return x * sin(y) / 3 - 2 * cos(x) / y + 5;
  };
  const RealArithmetic<double> doubles([](const Input& i) { return i.index == 0 ? 0.7 : -1.25; });
  EXPECT_DOUBLE_EQ(value(doubles), formula(0.7, -1.25));
  const RealArithmetic<Real50> wide([](const Input& i) { return i.index == 0 ? Real50("0.7") : Real50("-1.25"); });
  EXPECT_LT(abs(value(wide) - formula(Real50("0.7"), Real50("-1.25"))), Real50("1e-47"));
}

TEST_F(EvaluateTest, TakesTheNearestDouble) {
  EXPECT_EQ(to_real<double>(Rational(1, 10)), 0.1);
  EXPECT_EQ(to_real<double>(Rational(2, 3)), 2.0 / 3.0);
  EXPECT_EQ(to_real<float>(Rational(-1, 3)), -1.0F / 3.0F);
}

TEST_F(EvaluateTest, KnowsTheAdditionTheorems) {
  const NodeId angle = graph.sum({{1, a}, {-2, b}});
  // sin(a - 2b) - sin a (c_b² - s_b²) + 2 cos a s_b c_b = 0
  const NodeId sa = graph.sin(a), ca = graph.cos(a), sb = graph.sin(b), cb = graph.cos(b);
  set_output(graph.sum({{1, graph.sin(angle)},
                        {-1, graph.product({sa, cb, cb})},
                        {1, graph.product({sa, sb, sb})},
                        {2, graph.product({ca, sb, cb})}}));
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    EXPECT_EQ(value(ModPArithmetic<kMersenne61>(seed)).value(), 0u);
    EXPECT_EQ(value(ModPArithmetic<kPrime61b>(seed)).value(), 0u);
    EXPECT_EQ(value(ModPArithmetic<kPrime61c>(seed)).value(), 0u);
  }
  EXPECT_EQ(value(RationalArithmetic(3)), 0);
}

TEST_F(EvaluateTest, SeesThatDifferentFunctionsDiffer) {
  set_output(graph.sum({{1, graph.product({graph.sin(a), graph.sin(a)})}, {1, graph.product({a, b})}}));
  EXPECT_NE(value(ModPArithmetic<>(1)).value(), 0u);
  EXPECT_NE(value(ModPArithmetic<>(1)), value(ModPArithmetic<>(2)));
}

TEST_F(EvaluateTest, HasAnOddSignThatDependsOnTheValueOnly) {
  const ModPArithmetic<> arithmetic(9);
  const ModP<kMersenne61> x(12345);
  EXPECT_EQ(arithmetic.sign(-x), -arithmetic.sign(x));
  EXPECT_EQ(arithmetic.sign(x - x), x - x);
}

TEST(ModP, IsAFieldOverAPrime) {
  for (const std::uint64_t p : {kMersenne61, kPrime61b, kPrime61c}) {
    mpz_t prime;
    mpz_init_set_ui(prime, p);
    EXPECT_GT(mpz_probab_prime_p(prime, 40), 0) << p;
    mpz_clear(prime);
  }
  using F = ModP<kMersenne61>;
  const F x(kMersenne61 - 7);
  EXPECT_EQ(x * x.inverse(), F(1));
  EXPECT_EQ(-x, F(7));
  EXPECT_EQ(F::from(Rational(-2, 3)) * F(3) + F(2), F(0));
  EXPECT_THROW(F(0).inverse(), std::domain_error);
}

template <std::uint64_t P>
void expect_roots() {
  using F = ModP<P>;
  int roots = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const F x(splitmix64(seed, P));
    if (x.is_square()) {
      EXPECT_EQ(x.sqrt() * x.sqrt(), x);
      ++roots;
    } else {
      EXPECT_THROW(x.sqrt(), std::domain_error);
    }
    EXPECT_TRUE((x * x).sqrt() == x || (x * x).sqrt() == -x);
  }
  EXPECT_GT(roots, 60);
  EXPECT_LT(roots, 140);
  EXPECT_EQ(F(0).sqrt(), F(0));
  EXPECT_EQ(F(1).sqrt(), F(1));
}

TEST(ModP, HasSquareRootsOfHalfItsNumbers) {
  expect_roots<kMersenne61>();
  expect_roots<kPrime61b>();
  expect_roots<kPrime61c>();
}

TEST_F(EvaluateTest, TakesSquareRoots) {
  const NodeId zero = graph.constant(0), one = graph.constant(1), four = graph.constant(4);
  EXPECT_EQ(graph.sqrt(zero), zero);
  EXPECT_EQ(graph.sqrt(one), one);
  EXPECT_NE(graph.sqrt(four), graph.constant(2)) << "the other root is as good in a field";
  set_output(graph.sqrt(four));
  EXPECT_EQ(value(RationalArithmetic(3)), 2);
  EXPECT_EQ(count_operations(function).divisions, 1);
  EXPECT_EQ(check_well_formed(function), std::nullopt);
  set_output(graph.sqrt(graph.constant(2)));
  EXPECT_THROW(value(RationalArithmetic(3)), std::domain_error);
}

TEST_F(EvaluateTest, CountsEachNodeOnce) {
  const NodeId sum = graph.sum({{1, a}, {-3, b}}, 2);                                 // 1 mul, 2 add
  const NodeId cube = graph.product({sum, sum, sum});                                 // 2 mul
  const NodeId both = graph.sum({{-1, cube}, {1, graph.sin(a)}, {1, graph.cos(a)}});  // 2 add, 2 sin/cos
  set_output(graph.scaled(-1, graph.quotient(both, sum)));                            // 1 div
  EXPECT_EQ(count_operations(function), (OperationCount{4, 3, 1, 2}));
  EXPECT_EQ(to_string(count_operations(function)), "3 mul, 4 add, 1 div, 2 sin/cos");
  EXPECT_EQ(check_well_formed(function), std::nullopt);
}

TEST_F(EvaluateTest, ComplainsAboutUndeclaredInputs) {
  set_output(graph.sin(graph.input({InputKind::qd, 0})));
  EXPECT_NE(check_well_formed(function), std::nullopt);
}

}  // namespace
}  // namespace flatdyn

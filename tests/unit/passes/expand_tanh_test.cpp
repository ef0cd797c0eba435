// SPDX-License-Identifier: GPL-2.0-or-later
// tanh in a graph: its normal form, and the operations that stand for it.
#include "graph/passes/expand_tanh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "flatdyn/reference/real50.hpp"
#include "graph/arithmetic.hpp"
#include "graph/count.hpp"
#include "graph/mod_p.hpp"
#include "graph/passes/passes.hpp"
#include "graph/well_formed.hpp"

namespace flatdyn {
namespace {

using reference::Real50;

class ExpandTanhTest : public ::testing::Test {
 protected:
  Function function;
  Graph& graph = function.graph;
  NodeId x = graph.input({InputKind::qd, 0}), y = graph.input({InputKind::qd, 1});

  void set_output(NodeId id) {
    function.inputs = {InputKind::qd};
    function.outputs = {{"y", Layout::scalar, 1, 1, {id}, "anything"}};
  }
  template <class Arithmetic>
  static typename Arithmetic::Scalar value(const Function& of, Arithmetic arithmetic) {
    return evaluate(of, arithmetic)[static_cast<std::size_t>(roots(of)[0])];
  }
  void expect_same_values_in_fields() const {
    const Function expanded = expand_tanh(function);
    EXPECT_FALSE(has_tanh(expanded));
    EXPECT_EQ(check_well_formed(expanded), std::nullopt);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      EXPECT_EQ(value(function, ModPArithmetic<kMersenne61>(seed)), value(expanded, ModPArithmetic<kMersenne61>(seed)));
      EXPECT_EQ(value(function, ModPArithmetic<kPrime61b>(seed)), value(expanded, ModPArithmetic<kPrime61b>(seed)));
    }
    EXPECT_EQ(value(function, RationalArithmetic(1)), value(expanded, RationalArithmetic(1)));
  }
};

TEST_F(ExpandTanhTest, IsOddAndZeroAtZero) {
  EXPECT_TRUE(graph.is_zero(graph.tanh(graph.constant(0))));
  EXPECT_EQ(graph.tanh(graph.scaled(-3, x)), graph.scaled(-1, graph.tanh(graph.scaled(3, x))));
  set_output(graph.sum({{1, graph.tanh(graph.scaled(-3, x))}, {1, graph.tanh(graph.scaled(3, x))}}));
  EXPECT_TRUE(graph.is_zero(roots(function)[0]));
}

// Factors, sums and quotients: signs of these have normal forms of their own.
TEST_F(ExpandTanhTest, LeavesEveryValueInFields) {
  const std::vector<NodeId> arguments = {x,
                                         graph.scaled(-100, x),
                                         graph.scaled(4, x),
                                         graph.scaled(Rational(100, 7), x),
                                         graph.sum({{4, x}, {6, y}}),
                                         graph.sum({{-10, x}, {20, y}}, 30),
                                         graph.product({x, x, y}),
                                         graph.quotient(x, y),
                                         graph.scaled(50, graph.sum({{1, x}, {1, y}}))};
  for (const NodeId argument : arguments) {
    SCOPED_TRACE(argument);
    set_output(graph.sum({{3, graph.tanh(argument)}, {1, y}}));
    expect_same_values_in_fields();
  }
}

TEST_F(ExpandTanhTest, ComesAfterAllOtherPasses) {
  set_output(graph.product({graph.tanh(graph.scaled(20, x)), y}));
  std::vector<PassRecord> record;
  const Function made = run_passes(function, &record);
  EXPECT_EQ(record.back().pass, last_pass().name);
  EXPECT_FALSE(has_tanh(made));
  EXPECT_EQ(value(function, ModPArithmetic<>(3)), value(made, ModPArithmetic<>(3)));
  EXPECT_LE(count_operations(made).arithmetic(), count_operations(function).arithmetic());
  EXPECT_EQ(count_operations(made).divisions, 2);
}

// The largest error in units of the last place of the result.
template <class S>
double worst_error(const Function& tanh_of_input, double largest) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> around(-25, 25), exponent(-largest, largest), small(-4, 2);
  const double eps = std::numeric_limits<S>::epsilon();
  double worst = 0;
  const auto test = [&](double at) {
    const S given = static_cast<S>(at);
    RealArithmetic<S> arithmetic([given](const Input&) { return given; });
    const S found = evaluate(tanh_of_input, arithmetic)[static_cast<std::size_t>(roots(tanh_of_input)[0])];
    const Real50 exact = tanh(Real50(given));
    const S nearest = std::abs(exact.template convert_to<S>());
    const S ulp = std::nextafter(nearest, std::numeric_limits<S>::infinity()) - nearest;
    ASSERT_TRUE(std::isfinite(found)) << at;
    ASSERT_LE(std::abs(found), S(1)) << at;
    worst = std::max(worst, (abs(Real50(found) - exact) / Real50(ulp)).template convert_to<double>());
  };
  for (int k = 0; k < 4000; ++k) {
    const double sign = k % 2 == 0 ? 1 : -1;
    test(around(random));
    test(sign * std::pow(10, exponent(random)));
    test(sign * std::pow(10, small(random)));
    test(sign * 20 * (1 + k * eps));
    test(sign * 20 * (1 - k * eps));
  }
  test(std::numeric_limits<S>::max());
  return worst;
}

TEST_F(ExpandTanhTest, IsAccurateAtAllMagnitudes) {
  set_output(graph.tanh(x));
  const Function expanded = expand_tanh(function);
  const double in_double = worst_error<double>(expanded, 300), in_float = worst_error<float>(expanded, 30);
  RecordProperty("ulps_in_double", std::to_string(in_double));
  RecordProperty("ulps_in_float", std::to_string(in_float));
  EXPECT_LT(in_double, 2.6);
  EXPECT_LT(in_float, 2.6);
  for (const double zero : {0.0, -0.0}) {
    EXPECT_EQ(value(expanded, RealArithmetic<double>([zero](const Input&) { return zero; })), 0);
  }
}

}  // namespace
}  // namespace flatdyn

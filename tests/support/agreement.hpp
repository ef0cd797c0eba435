// SPDX-License-Identifier: GPL-2.0-or-later
// A function's graph beside the reference, in 50 digits.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "functions/deviation/expected.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn::testing {

// Expects the function's values at these states to be the reference's, to 1e-35 of the size of their terms. The states
// have numbers for all of its arguments.
inline void expect_the_reference(const ExpectedValues& expected, const Mechanism& mechanism, const Function& function,
                                 const std::vector<State>& states) {
  constexpr double kMost = 1e-35;
  const Expected here = expected.of(function);
  GraphEvaluator<Real50> graph(function);
  for (const State& state : states) {
    const auto values = graph(with_unit_quaternions(mechanism, widened<Real50>(state)));
    const std::vector<Real50> right = here.exact(state);
    const std::vector<double> scale = here.scale(state);
    ASSERT_TRUE(values) << function.name;
    ASSERT_EQ(values->size(), right.size()) << function.name;
    for (std::size_t k = 0; k < right.size(); ++k) {
      const Real50 difference = abs((*values)[k] - right[k]);
      EXPECT_LE(difference.convert_to<double>(), kMost * std::max(1.0, scale[k])) << function.name << " " << k;
    }
  }
}

}  // namespace flatdyn::testing

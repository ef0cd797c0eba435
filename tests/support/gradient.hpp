// SPDX-License-Identifier: GPL-2.0-or-later
// A gradient beside central differences.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace flatdyn::testing {

// value(x, gradient): the value at x, and its gradient unless that is null.
template <class Function>
void expect_gradient(const Function& value, std::vector<double> x) {
  constexpr double kStep = 1e-5;
  std::vector<double> gradient(x.size());
  value(x.data(), gradient.data());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double here = x[k];
    x[k] = here + kStep;
    const double above = value(x.data(), nullptr);
    x[k] = here - kStep;
    const double below = value(x.data(), nullptr);
    x[k] = here;
    EXPECT_NEAR(gradient[k], (above - below) / (2 * kStep), 1e-4 * (1 + std::abs(gradient[k]))) << k;
  }
}

}  // namespace flatdyn::testing

// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/zero_phase.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace flatdyn {
namespace {

constexpr double kBand = 10, kStep = 1e-3;

template <class Signal>
double filtered(const ZeroPhaseKernel& kernel, int order, double time, const Signal& signal) {
  double sum = 0;
  for (int k = 0; k < kernel.length(); ++k) {
    sum += kernel.weights[order][static_cast<std::size_t>(k)] * signal(time + (k - kernel.half) * kStep);
  }
  return sum;
}

TEST(ZeroPhaseKernel, IsExactForParabolas) {
  const ZeroPhaseKernel kernel = zero_phase_kernel(kBand, kStep);
  const auto parabola = [](double t) { return 3 - 2 * t + 5 * t * t; };
  EXPECT_NEAR(filtered(kernel, 0, 0.7, parabola), parabola(0.7), 1e-11);
  EXPECT_NEAR(filtered(kernel, 1, 0.7, parabola), -2 + 7, 1e-10);
  EXPECT_NEAR(filtered(kernel, 2, 0.7, parabola), 10, 1e-7);
}

TEST(ZeroPhaseKernel, PassesAndDifferentiatesWhatIsSlowerThanTheBand) {
  const ZeroPhaseKernel kernel = zero_phase_kernel(kBand, kStep);
  for (const double frequency : {0.3, 2.0, 6.0, 10.0}) {
    const double w = 2 * std::numbers::pi * frequency;
    const auto wave = [w](double t) { return std::sin(w * t + 0.4); };
    EXPECT_NEAR(filtered(kernel, 0, 1, wave), wave(1), 1e-4) << frequency;
    EXPECT_NEAR(filtered(kernel, 1, 1, wave), w * std::cos(w + 0.4), 1e-4 * w) << frequency;
    EXPECT_NEAR(filtered(kernel, 2, 1, wave), -w * w * wave(1), 2e-4 * w * w) << frequency;
  }
}

TEST(ZeroPhaseKernel, LooksAheadAtValuesAndRates) {
  for (const double ahead : {0.0, 0.04, -0.02}) {
    ZeroPhaseKernel kernel = zero_phase_kernel(kBand, kStep);
    kernel.weights[0] = weights_ahead(kBand, kStep, ahead);
    kernel.weights[1] = rate_weights_ahead(kBand, kStep, ahead);
    for (const double frequency : {0.3, 2.0, 6.0}) {
      const double w = 2 * std::numbers::pi * frequency;
      const auto wave = [w](double t) { return std::sin(w * t + 0.4); };
      EXPECT_NEAR(filtered(kernel, 0, 1, wave), wave(1 + ahead), 5e-4) << frequency;
      EXPECT_NEAR(filtered(kernel, 1, 1, wave), w * std::cos(w * (1 + ahead) + 0.4), 5e-4 * w) << frequency;
    }
  }
}

TEST(ZeroPhaseKernel, StopsWhatIsFasterThanTwoBands) {
  const ZeroPhaseKernel kernel = zero_phase_kernel(kBand, kStep);
  for (const double frequency : {20.0, 35.0, 60.0, 200.0}) {
    const double w = 2 * std::numbers::pi * frequency;
    const auto wave = [w](double t) { return std::cos(w * t); };
    EXPECT_NEAR(filtered(kernel, 0, 0, wave), 0, 1e-4) << frequency;
    EXPECT_NEAR(filtered(kernel, 2, 0, wave), 0, 1e-4 * w * w) << frequency;
  }
}

TEST(ZeroPhaseKernel, IsSymmetric) {
  const ZeroPhaseKernel kernel = zero_phase_kernel(kBand, kStep);
  for (int k = 0; k < kernel.half; ++k) {
    const auto left = static_cast<std::size_t>(k), right = static_cast<std::size_t>(2 * kernel.half - k);
    EXPECT_NEAR(kernel.weights[0][left], kernel.weights[0][right], 1e-15);
    EXPECT_NEAR(kernel.weights[1][left], -kernel.weights[1][right], 1e-12);
  }
}

}  // namespace
}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/zero_phase.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flatdyn {
namespace {

// A value and its first two derivatives with respect to time.
struct Jet {
  double value = 0, first = 0, second = 0;
};

Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.first * b.value + a.value * b.first,
          a.second * b.value + 2 * a.first * b.first + a.value * b.second};
}

// sin(ω t)/(π t).
Jet sinc(double omega, double t) {
  const double pi = std::numbers::pi;
  const double x = omega * t;
  // Below this x the series is exact to the last digit; above it the quotients are accurate enough.
  constexpr double kSmall = 1e-2;
  if (std::abs(x) < kSmall) {
    const double xx = x * x;
    return {omega / pi * (1 - xx / 6 * (1 - xx / 20)), -omega * omega / pi * x / 3 * (1 - xx / 10),
            -omega * omega * omega / pi / 3 * (1 - 3 * xx / 10 * (1 - 5 * xx / 84))};
  }
  const double s = std::sin(x), c = std::cos(x);
  const double f = s / x, df = (c - f) / x, ddf = -f - 2 * df / x;
  return {omega / pi * f, omega * omega / pi * df, omega * omega * omega / pi * ddf};
}

// Nuttall's window with continuous first derivative and half-length `reach` in s.
Jet window(double reach, double t) {
  static constexpr double kCosines[] = {0.355768, 0.487396, 0.144232, 0.012604};
  Jet sum;
  for (int m = 0; m < 4; ++m) {
    const double rate = m * std::numbers::pi / reach;
    sum.value += kCosines[m] * std::cos(rate * t);
    sum.first -= kCosines[m] * rate * std::sin(rate * t);
    sum.second -= kCosines[m] * rate * rate * std::cos(rate * t);
  }
  return sum;
}

// Σ_k weights[k] (t_k)^power / power!
double moment(const std::vector<double>& weights, int half, double dt, int power) {
  double sum = 0;
  for (int k = -half; k <= half; ++k) {
    const double t = k * dt;
    sum += weights[static_cast<std::size_t>(k + half)] * (power == 0 ? 1 : power == 1 ? t : t * t / 2);
  }
  return sum;
}

void scale(std::vector<double>& weights, double factor) {
  for (double& weight : weights) weight *= factor;
}

void subtract(std::vector<double>& weights, double factor, const std::vector<double>& other) {
  for (std::size_t k = 0; k < weights.size(); ++k) weights[k] -= factor * other[k];
}

// Makes the kernel exact for 1, t and t²/2; sampling and the window's ends alone leave errors of 1e-4.
void make_exact_for_parabolas(ZeroPhaseKernel& kernel, double dt) {
  auto& [value, first, second] = kernel.weights;
  scale(value, 1 / moment(value, kernel.half, dt, 0));
  subtract(second, moment(second, kernel.half, dt, 0), value);
  scale(second, 1 / moment(second, kernel.half, dt, 2));
  subtract(value, moment(value, kernel.half, dt, 2), second);
  subtract(second, moment(second, kernel.half, dt, 0), value);
  scale(first, 1 / moment(first, kernel.half, dt, 1));
}

// The half-length of the window, s. The window's main lobe, 8/(2 reach) wide from zero to zero, fits into the
// transition from 1 to 2 bands with an eighth to spare.
double reach_of(double band) { return 4.5 / band; }

// The kernel, or a derivative of it, at the samples about the one that `ahead` is counted from.
std::vector<double> sampled_ahead(double band, double dt, double ahead, double Jet::*order) {
  const double reach = reach_of(band), omega = 2 * std::numbers::pi * 1.5 * band;
  const int half = zero_phase_half_window(band, dt);
  std::vector<double> weights;
  for (int k = -half; k <= half; ++k) {
    const double t = ahead - k * dt;
    weights.push_back(std::abs(t) < reach ? (sinc(omega, t) * window(reach, t)).*order * dt : 0);
  }
  return weights;
}

}  // namespace

int zero_phase_half_window(double band, double dt) {
  constexpr double kMost = 1e9;
  return static_cast<int>(std::min(std::ceil(reach_of(band) / dt) - 1, kMost));
}

ZeroPhaseKernel zero_phase_kernel(double band, double dt) {
  const double reach = reach_of(band);
  const double omega = 2 * std::numbers::pi * 1.5 * band;
  ZeroPhaseKernel kernel;
  kernel.half = zero_phase_half_window(band, dt);
  for (int k = -kernel.half; k <= kernel.half; ++k) {
    // The kernel is mirrored against the signal: y(t) = ∫ h(t - s) x(s) ds.
    const double t = -k * dt;
    const Jet h = sinc(omega, t) * window(reach, t);
    kernel.weights[0].push_back(h.value * dt);
    kernel.weights[1].push_back(h.first * dt);
    kernel.weights[2].push_back(h.second * dt);
  }
  make_exact_for_parabolas(kernel, dt);
  return kernel;
}

std::vector<double> weights_ahead(double band, double dt, double ahead) {
  std::vector<double> weights = sampled_ahead(band, dt, ahead, &Jet::value);
  scale(weights, 1 / moment(weights, zero_phase_half_window(band, dt), dt, 0));
  return weights;
}

std::vector<double> rate_weights_ahead(double band, double dt, double ahead) {
  const int half = zero_phase_half_window(band, dt);
  std::vector<double> weights = sampled_ahead(band, dt, ahead, &Jet::first);
  subtract(weights, moment(weights, half, dt, 0), weights_ahead(band, dt, ahead));
  scale(weights, 1 / moment(weights, half, dt, 1));
  return weights;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/stamp_weights.hpp"

#include <cmath>
#include <numbers>

namespace flatdyn {
namespace {

constexpr double kOfCubic = 3.0 / 128, kTurn = 2 * std::numbers::pi;

}  // namespace

double error_of_cubic(double step, double frequency) { return kOfCubic * std::pow(kTurn * frequency * step, 4); }

double step_of_cubic(double error, double frequency) { return std::pow(error / kOfCubic, 0.25) / (kTurn * frequency); }

std::vector<double> interpolation_weights(std::span<const double> times, double at) {
  std::vector<double> weights(times.size(), 1);
  for (std::size_t k = 0; k < times.size(); ++k) {
    for (std::size_t l = 0; l < times.size(); ++l) {
      if (l != k) weights[k] *= (at - times[l]) / (times[k] - times[l]);
    }
  }
  return weights;
}

std::vector<double> difference_weights(std::span<const double> times) {
  const double length = times.back() - times.front();
  std::vector<double> weights(times.size(), 1);
  double squares = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    for (std::size_t l = 0; l < times.size(); ++l) {
      if (l != k) weights[k] *= length / (times[k] - times[l]);
    }
    squares += weights[k] * weights[k];
  }
  const double norm = std::sqrt(squares);
  for (double& weight : weights) weight /= norm;
  return weights;
}

}  // namespace flatdyn

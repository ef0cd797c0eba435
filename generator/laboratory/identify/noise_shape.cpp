// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/noise_shape.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "laboratory/identify/zero_phase.hpp"

namespace flatdyn {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int kLags = 32, kRun = 64;

VectorXd vector_of_numbers(const std::vector<double>& weights) {
  return Eigen::Map<const VectorXd>(weights.data(), static_cast<Index>(weights.size()));
}

VectorXd autocorrelation(const VectorXd& kernel, Index lags, int step) {
  VectorXd result = VectorXd::Zero(lags);
  for (Index lag = 0; lag < lags; ++lag) {
    const Index shift = lag * step, common = kernel.size() - shift;
    if (common > 0) result[lag] = kernel.head(common).dot(kernel.tail(common));
  }
  return result;
}

// Autocorrelations at lags of `rows` strides of noise with this correlation time, in strides, behind a filter with such
// weights at every stride.
VectorXd coloured_autocorrelation(const VectorXd& weights, double correlation_time, Index rows) {
  const Index size = weights.size();
  const VectorXd white = autocorrelation(weights, size, 1);
  VectorXd result = VectorXd::Zero(kLags);
  for (Index lag = 0; lag < kLags; ++lag) {
    for (Index shift = -size + 1; shift < size; ++shift) {
      const Index distance = std::abs(lag * rows - shift);
      result[lag] += white[std::abs(shift)] * std::exp(-static_cast<double>(distance) / correlation_time);
    }
  }
  return result;
}

// `fine` at every sample, then `coarse` at every stride.
VectorXd cascaded(const VectorXd& fine, const VectorXd& coarse, int stride) {
  VectorXd result = VectorXd::Zero(fine.size() + (coarse.size() - 1) * stride);
  for (Index k = 0; k < coarse.size(); ++k) result.segment(k * stride, fine.size()) += coarse[k] * fine;
  return result;
}

}  // namespace

// White noise at every row has the density that the filtered noise has below the band if its power is the sum of the
// autocorrelation over all lags.
double NoiseShape::correlation() const {
  const double all = 2 * measured.sum() - measured[0];
  return std::max(1.0, all / measured[0]);
}

std::vector<int> differentiations(const StreamPlan& plan) {
  const LogLayout& layout = plan.layout();
  std::vector<int> orders = layout.base > 0 ? base_orders(layout) : std::vector<int>();
  orders.resize(static_cast<std::size_t>(layout.rates()), layout.has_accelerations ? 0 : layout.has_rates ? 1 : 2);
  if (layout.has_all_derivatives() && !plan.moves) std::fill(orders.begin(), orders.end(), kHeld);
  return orders;
}

NoiseShape noise_shape(const SampleFilter& filter, const std::vector<int>& differentiations) {
  if (filter.band == 0) {
    NoiseShape result{
        1, VectorXd::Unit(kLags, 0), {}, std::vector<VectorXd>(NoiseShape::kColours.size(), VectorXd::Zero(kLags))};
    for (const int order : differentiations) {
      result.acceleration.emplace_back(VectorXd::Zero(kLags));
      if (order != kHeld) result.acceleration.back()[0] = 1;
    }
    return result;
  }
  const int stride = filter.stride();
  const VectorXd narrow = vector_of_numbers(zero_phase_kernel(filter.band, filter.dt).weights[0]);
  const VectorXd coarse = vector_of_numbers(zero_phase_kernel(filter.band, filter.dt * stride).weights[0]);
  const ZeroPhaseKernel wide = zero_phase_kernel(filter.motion_band(), filter.dt);
  NoiseShape result{kRun, autocorrelation(narrow, kLags, filter.decimate), {}};
  std::map<int, VectorXd> by_order = {{kHeld, VectorXd::Zero(kLags)}};
  for (const int order : differentiations) {
    if (by_order.count(order) == 0) {
      by_order[order] =
          autocorrelation(cascaded(vector_of_numbers(wide.weights[order]), coarse, stride), kLags, filter.decimate);
    }
    result.acceleration.push_back(by_order[order]);
  }
  for (const double share : NoiseShape::kColours) {
    const double strides = 1 / (2 * std::numbers::pi * share * filter.band * filter.dt * stride);
    result.coloured.push_back(coloured_autocorrelation(coarse, strides, filter.decimate / stride));
  }
  return result;
}

}  // namespace flatdyn

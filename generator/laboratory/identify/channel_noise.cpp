// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/channel_noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "laboratory/identify/stamp_weights.hpp"

namespace flatdyn {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

namespace {

// The variance of white noise in a difference of an order, (2m over m), divided by that of the noise.
double growth_of(int order) {
  double growth = 1;
  for (int m = 1; m <= order; ++m) growth *= 2.0 * (2.0 * m - 1) / m;
  return growth;
}

}  // namespace

void StampDifferences::add(double time) {
  times_.push_back(time);
  if (times_.size() > kOrders + 1) times_.erase(times_.begin());
  for (int order = 1; order <= known(); ++order) {
    const std::size_t count = static_cast<std::size_t>(order) + 1;
    weights_[static_cast<std::size_t>(order)] = difference_weights({times_.end() - order - 1, count});
  }
}

void ChannelNoiseMeter::count(int order, double difference) {
  const auto at = static_cast<std::size_t>(order);
  block_.squares[at] += difference * difference;
  ++block_.counts[at];
}

void ChannelNoiseMeter::add(double value) {
  double difference = value;
  const int known = held_;
  for (int order = 0; order <= std::min(known, kOrders); ++order) {
    const auto at = static_cast<std::size_t>(order);
    const double next = difference - last_[at];
    last_[at] = difference;
    if (order > 0) count(order, difference);
    difference = next;
  }
  end_sample(known > 0 ? last_[1] : 0, known);
}

void ChannelNoiseMeter::add(double value, const StampDifferences& stamps) {
  const int known = held_;
  const double change = value - last_[0];
  std::copy_backward(last_.begin(), last_.end() - 1, last_.end());
  last_[0] = value;
  for (int order = 1; order <= std::min(known, kOrders); ++order) {
    const std::vector<double>& weights = stamps.weights(order);
    double difference = 0;
    for (int k = 0; k <= order; ++k) {
      difference += weights[static_cast<std::size_t>(order - k)] * last_[static_cast<std::size_t>(k)];
    }
    count(order, difference * std::sqrt(growth_of(order)));
  }
  end_sample(change, known);
}

// `known`: the samples before this one since the restart, up to the number of orders.
void ChannelNoiseMeter::end_sample(double change, int known) {
  constexpr int kSamplesPerBlock = 32;
  constexpr double kRounding = 1e-12;  // share of the value that text and doubles may change
  if (++block_.samples == kSamplesPerBlock) end_block();
  held_ = std::min(known + 1, kOrders + 1);
  if (known == 0) return;
  const double size = std::abs(change);
  if (size > kRounding * std::max(1.0, std::abs(last_[0])) && (step_ == 0 || size < step_)) step_ = size;
}

void ChannelNoiseMeter::end_block() {
  if (block_.counts[kOrders] > 0) blocks_.push_back(block_);
  block_ = {};
}

double ChannelNoiseMeter::Block::mean_square(int order) const {
  const auto at = static_cast<std::size_t>(order);
  return counts[at] > 0 ? squares[at] / static_cast<double>(counts[at]) : 0;
}

double ChannelNoiseMeter::mean_square(int order) const {
  constexpr double kMost = 0.9, kFar = 25;  // share of the blocks; times the mean square of most
  std::vector<double> sizes;
  for (const Block& each : blocks_) {
    if (each.mean_square(order) > 0) sizes.push_back(each.mean_square(order));
  }
  if (sizes.empty()) return block_.mean_square(order);
  const auto place = sizes.begin() + static_cast<std::ptrdiff_t>(kMost * static_cast<double>(sizes.size()));
  std::nth_element(sizes.begin(), place, sizes.end());
  const double largest = kFar * *place;
  Block all;
  for (const Block& each : blocks_) {
    if (each.mean_square(order) > largest) continue;
    all.squares[static_cast<std::size_t>(order)] += each.squares[static_cast<std::size_t>(order)];
    all.counts[static_cast<std::size_t>(order)] += each.counts[static_cast<std::size_t>(order)];
  }
  return all.mean_square(order);
}

ChannelNoise ChannelNoiseMeter::noise() const {
  ChannelNoise result{step_, 0};
  bool is_first = true;
  for (int order = kLowest; order <= kOrders; ++order) {
    if (blocks_.empty() && block_.counts[static_cast<std::size_t>(order)] == 0) continue;
    const double deviation = std::sqrt(mean_square(order) / growth_of(order));
    result.deviation = is_first ? deviation : std::min(result.deviation, deviation);
    is_first = false;
  }
  result.deviation = std::max(result.deviation, step_ / std::sqrt(12.0));
  return result;
}

namespace {

// The standard deviation of normal numbers, by the median of their magnitudes.
double deviation_by_median(const std::vector<double>& numbers) {
  constexpr double kNormal = 1.4826;  // standard deviation of a normal number whose magnitude has median 1
  std::vector<double> sizes;
  for (const double number : numbers) sizes.push_back(std::abs(number));
  return kNormal * median(std::move(sizes));
}

constexpr int kLowestOfRun = 3;

// The noise by the order of differences that has least, and by the least change.
ChannelNoise noise_of_run(const std::vector<double>& run, const std::vector<double>& deviations) {
  ChannelNoiseMeter meter;
  for (const double value : run) meter.add(value);
  const double step = meter.noise().step;
  const double least = deviations.empty() ? 0 : *std::min_element(deviations.begin(), deviations.end());
  return {step, std::max(least, step / std::sqrt(12.0))};
}

}  // namespace

ChannelNoise typical_noise(std::vector<double> run) {
  const std::vector<double> values = run;
  std::vector<double> deviations;
  for (int order = 1; order <= StampDifferences::kOrders && run.size() > 1; ++order) {
    for (std::size_t k = 0; k + 1 < run.size(); ++k) run[k] = run[k + 1] - run[k];
    run.pop_back();
    if (order >= kLowestOfRun) deviations.push_back(deviation_by_median(run) / std::sqrt(growth_of(order)));
  }
  return noise_of_run(values, deviations);
}

ChannelNoise typical_noise(const std::vector<double>& run, const std::vector<double>& times) {
  std::vector<std::vector<double>> differences(StampDifferences::kOrders + 1);
  StampDifferences stamps;
  for (std::size_t k = 0; k < run.size(); ++k) {
    stamps.add(times[k]);
    for (int order = kLowestOfRun; order <= stamps.known(); ++order) {
      const std::vector<double>& weights = stamps.weights(order);
      double difference = 0;
      for (std::size_t j = 0; j < weights.size(); ++j) difference += weights[j] * run[k + 1 + j - weights.size()];
      differences[static_cast<std::size_t>(order)].push_back(difference);
    }
  }
  std::vector<double> deviations;
  for (const std::vector<double>& each : differences) {
    if (!each.empty()) deviations.push_back(deviation_by_median(each));
  }
  return noise_of_run(run, deviations);
}

}  // namespace flatdyn

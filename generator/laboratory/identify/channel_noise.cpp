// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/channel_noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flatdyn {

void ChannelNoiseMeter::add(double value) {
  constexpr int kSamplesPerBlock = 32;
  constexpr double kRounding = 1e-12;  // share of the value that text and doubles may change
  double difference = value;
  const int known = held_;
  for (int order = 0; order <= std::min(known, kOrders); ++order) {
    const auto at = static_cast<std::size_t>(order);
    const double next = difference - last_[at];
    last_[at] = difference;
    if (order > 0) {
      block_.squares[at] += difference * difference;
      ++block_.counts[at];
    }
    difference = next;
  }
  if (++block_.samples == kSamplesPerBlock) end_block();
  held_ = std::min(known + 1, kOrders + 1);
  if (known == 0) return;
  const double change = std::abs(last_[1]);
  if (change > kRounding * std::max(1.0, std::abs(value)) && (step_ == 0 || change < step_)) step_ = change;
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
  double growth = 1;  // (2m over m)
  bool is_first = true;
  for (int order = 1; order <= kOrders; ++order) {
    growth *= 2.0 * (2.0 * order - 1) / order;
    if (order < kLowest || (blocks_.empty() && block_.counts[static_cast<std::size_t>(order)] == 0)) continue;
    const double deviation = std::sqrt(mean_square(order) / growth);
    result.deviation = is_first ? deviation : std::min(result.deviation, deviation);
    is_first = false;
  }
  result.deviation = std::max(result.deviation, step_ / std::sqrt(12.0));
  return result;
}

ChannelNoise typical_noise(std::vector<double> run) {
  constexpr int kLowest = 3, kOrders = 6;
  constexpr double kNormal = 1.4826;  // standard deviation of a normal number whose magnitude has median 1
  ChannelNoiseMeter meter;
  for (const double value : run) meter.add(value);
  const double step = meter.noise().step;
  double growth = 1, deviation = -1;
  for (int order = 1; order <= kOrders && run.size() > 1; ++order) {
    for (std::size_t k = 0; k + 1 < run.size(); ++k) run[k] = run[k + 1] - run[k];
    run.pop_back();
    growth *= 2.0 * (2.0 * order - 1) / order;
    if (order < kLowest) continue;
    std::vector<double> sizes;
    for (const double difference : run) sizes.push_back(std::abs(difference));
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    const double found = kNormal * *middle / std::sqrt(growth);
    deviation = deviation < 0 ? found : std::min(deviation, found);
  }
  return {step, std::max({deviation, step / std::sqrt(12.0), 0.0})};
}

}  // namespace flatdyn

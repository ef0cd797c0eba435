// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/channel_noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flatdyn {

void ChannelNoiseMeter::add(double value) {
  constexpr double kRounding = 1e-12;  // share of the value that text and doubles may change
  double difference = value;
  const int known = held_;
  for (int order = 0; order <= std::min(known, kOrders); ++order) {
    const auto at = static_cast<std::size_t>(order);
    const double next = difference - last_[at];
    last_[at] = difference;
    if (order > 0) {
      squares_[at] += difference * difference;
      ++counts_[at];
    }
    difference = next;
  }
  held_ = std::min(known + 1, kOrders + 1);
  if (known == 0) return;
  const double change = std::abs(last_[1]);
  if (change > kRounding * std::max(1.0, std::abs(value)) && (step_ == 0 || change < step_)) step_ = change;
}

ChannelNoise ChannelNoiseMeter::noise() const {
  ChannelNoise result{step_, 0};
  double growth = 1;  // (2m over m)
  bool is_first = true;
  for (int order = 1; order <= kOrders; ++order) {
    const auto at = static_cast<std::size_t>(order);
    growth *= 2.0 * (2.0 * order - 1) / order;
    if (order < kLowest || counts_[at] == 0) continue;
    const double deviation = std::sqrt(squares_[at] / static_cast<double>(counts_[at]) / growth);
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

// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/sample_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "laboratory/identify/channel_noise.hpp"
#include "laboratory/identify/stamp_weights.hpp"

namespace flatdyn {
namespace {

using Samples = std::vector<std::vector<double>>;

constexpr double kUneven = 0.02;  // jitter, divided by dt

bool repeats(const std::vector<double>& sample, const std::vector<double>& before) {
  return std::equal(sample.begin() + 1, sample.end(), before.begin() + 1);
}

// The number of lines over which readings stay the same, if nearly all changes are more than a line apart.
double lines_held(const Samples& samples) {
  constexpr double kMost = 0.8;  // share of the changes
  constexpr std::size_t kLeastChanges = 100;
  std::size_t changes = 0, long_ones = 0, last = 0;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    if (repeats(samples[k], samples[k - 1])) continue;
    ++changes;
    if (k - last > 1) ++long_ones;
    last = k;
  }
  if (changes < kLeastChanges || static_cast<double>(long_ones) < kMost * static_cast<double>(changes)) return 1;
  return static_cast<double>(last) / static_cast<double>(changes);
}

std::vector<double> steps_of(const Samples& samples) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < samples.size(); ++k) steps.push_back(samples[k][0] - samples[k - 1][0]);
  return steps;
}

bool is_no_gap(double step, double dt) { return step < 2 * dt; }

double jitter_of(const std::vector<double>& steps, double dt) {
  double sum = 0;
  int count = 0;
  for (const double step : steps) {
    if (!is_no_gap(step, dt)) continue;
    sum += (step - dt) * (step - dt);
    ++count;
  }
  return std::sqrt(sum / count) / dt;
}

double mean_of(const std::vector<double>& steps, double dt) {
  double sum = 0;
  int count = 0;
  for (const double step : steps) {
    if (!is_no_gap(step, dt)) continue;
    sum += step;
    ++count;
  }
  return sum / count;
}

double drift_of(const std::vector<double>& steps, double dt) {
  double largest = 0, sum = 0;
  int count = 0;
  for (const double step : steps) {
    if (!is_no_gap(step, dt)) continue;
    sum += step;
    if (++count * dt < 1) continue;
    largest = std::max(largest, std::abs(sum / count - dt) / dt);
    sum = 0;
    count = 0;
  }
  return largest;
}

// The median size of a channel's differences of fourth order, which a smooth motion does not have: at the stamps, or at
// even times.
double roughness(const Samples& samples, int channel, bool at_stamps, double dt) {
  constexpr std::size_t kNodes = 5;
  double times[kNodes] = {0, 1, 2, 3, 4};
  const std::vector<double> even = difference_weights(times);
  std::vector<double> sizes;
  for (std::size_t k = 0; k + kNodes <= samples.size(); ++k) {
    if (!is_no_gap((samples[k + kNodes - 1][0] - samples[k][0]) / (kNodes - 1), dt)) continue;
    for (std::size_t j = 0; j < kNodes; ++j) times[j] = samples[k + j][0];
    const std::vector<double> weights = at_stamps ? difference_weights(times) : even;
    double difference = 0;
    for (std::size_t j = 0; j < kNodes; ++j) {
      difference += weights[j] * samples[k + j][static_cast<std::size_t>(channel)];
    }
    sizes.push_back(std::abs(difference));
  }
  return sizes.empty() ? 0 : median(std::move(sizes));
}

// Whether positions are clearly smoother at the stamps than at even times. Channels that do not move tell nothing.
bool is_smoother_at_stamps(const LogLayout& layout, const Samples& samples, double dt) {
  constexpr double kClearly = 0.9;
  double product = 0;
  int count = 0;
  for (const int channel : layout.positions_of_all()) {
    const double stamped = roughness(samples, channel, true, dt), counted = roughness(samples, channel, false, dt);
    if (!(stamped > 0 && counted > 0)) continue;
    product += std::log(stamped / counted);
    ++count;
  }
  return count > 0 && product / count < std::log(kClearly);
}

}  // namespace

SampleClock sample_clock(const LogLayout& layout, const std::vector<std::vector<double>>& samples, ClockChoice choice) {
  SampleClock clock;
  clock.held = lines_held(samples);
  Samples distinct;
  for (const std::vector<double>& sample : samples) {
    if (!clock.leaves_out_repeats() || distinct.empty() || !repeats(sample, distinct.back()))
      distinct.push_back(sample);
  }
  const std::vector<double> steps = steps_of(distinct);
  clock.dt = median(steps);
  clock.jitter = jitter_of(steps, clock.dt);
  if (choice != ClockChoice::stamped && clock.jitter <= kUneven) return clock;
  const bool is_stamped = choice == ClockChoice::automatic ? is_smoother_at_stamps(layout, distinct, clock.dt)
                                                           : choice == ClockChoice::stamped;
  clock.kind = is_stamped ? SampleClock::Kind::stamped : SampleClock::Kind::counted;
  if (is_stamped) clock.dt = mean_of(steps, clock.dt);
  clock.drift = drift_of(steps, mean_of(steps, clock.dt));
  return clock;
}

std::string clock_text(const SampleClock& clock, double longest, double band) {
  std::string text;
  if (clock.leaves_out_repeats()) {
    text = fmt::format("all readings change at every {:.2g} lines only; lines that repeat the one before are left out",
                       clock.held);
  }
  if (clock.kind == SampleClock::Kind::even) return text;
  if (!text.empty()) text += "; ";
  text += fmt::format("time is not even: steps differ by {:.1f} % of {:.4g} s", 100 * clock.jitter, clock.dt);
  if (clock.drift > kUneven) text += fmt::format(", and their mean over a second by {:.1f} %", 100 * clock.drift);
  if (clock.kind == SampleClock::Kind::counted) {
    return text + "; samples count as taken evenly, whatever their stamps";
  }
  // The error of a cubic through four samples h apart, in the middle, for a sine of this frequency.
  const auto error = [band](double h) { return 3.0 / 128 * std::pow(2 * M_PI * band * h, 4); };
  return text + fmt::format(
                    "; samples are interpolated at their stamps by cubics onto steps of {:.4g} s. A signal at "
                    "the edge of the band is off by {:.1g} of its size then, and by {:.1g} where {:.2g} s are "
                    "bridged",
                    clock.dt, error(clock.dt), error(longest), longest);
}

bool RepeatFilter::is_repeat(const double* channels) {
  constexpr double kLongest = 1.5;  // times dt
  if (!clock_.leaves_out_repeats()) return false;
  const bool is_same = has_last_ && channels[0] - last_[0] < kLongest * clock_.dt &&
                       std::equal(last_.begin() + 1, last_.end(), channels + 1);
  if (is_same) return true;
  last_.assign(channels, channels + last_.size());
  has_last_ = true;
  return false;
}

}  // namespace flatdyn

// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/sample_clock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "laboratory/identify/channel_noise.hpp"
#include "laboratory/identify/stamp_weights.hpp"

namespace flatdyn {
namespace {

constexpr double kUneven = 0.02;  // jitter, divided by dt
constexpr double kPairs = 1.4;    // mean by median of the steps of samples that come in pairs, at least

bool repeats(const std::vector<double>& sample, const std::vector<double>& before) {
  return std::equal(sample.begin() + 1, sample.end(), before.begin() + 1);
}

// How many lines readings stay the same for, if nearly all changes are about as many lines apart, or a multiple of that
// where an update was missed; else 1. Readings that change now and then, as at rest, are not so regular.
double lines_held(const std::vector<SampleRun>& runs) {
  constexpr double kMost = 0.9;  // share of the changes
  constexpr std::size_t kLeastChanges = 100;
  constexpr int kMissed = 3;
  std::vector<double> intervals;
  for (const SampleRun& run : runs) {
    std::size_t last = 0;
    for (std::size_t k = 1; k < run.size(); ++k) {
      if (repeats(run[k], run[k - 1])) continue;
      if (last > 0) intervals.push_back(static_cast<double>(k - last));
      last = k;
    }
  }
  if (intervals.size() < kLeastChanges) return 1;
  const double usual = median(intervals);
  if (usual < 2) return 1;
  double regular = 0, sum = 0, updates = 0;
  for (const double interval : intervals) {
    const double times = std::clamp(std::round(interval / usual), 1.0, static_cast<double>(kMissed));
    if (std::abs(interval - times * usual) > 1) continue;
    ++regular;
    sum += interval;
    updates += times;
  }
  return regular < kMost * static_cast<double>(intervals.size()) ? 1 : sum / updates;
}

// The runs without lines that repeat the one before.
std::vector<SampleRun> without_repeats(const std::vector<SampleRun>& runs) {
  std::vector<SampleRun> distinct;
  for (const SampleRun& run : runs) {
    distinct.emplace_back();
    for (const std::vector<double>& sample : run) {
      if (distinct.back().empty() || !repeats(sample, distinct.back().back())) distinct.back().push_back(sample);
    }
  }
  return distinct;
}

// The times from one sample to the next, run by run.
std::vector<std::vector<double>> steps_of(const std::vector<SampleRun>& runs) {
  std::vector<std::vector<double>> steps;
  for (const SampleRun& run : runs) {
    steps.emplace_back();
    for (std::size_t k = 1; k < run.size(); ++k) steps.back().push_back(run[k][0] - run[k - 1][0]);
  }
  return steps;
}

std::vector<double> all_of(const std::vector<std::vector<double>>& lists) {
  std::vector<double> all;
  for (const std::vector<double>& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

bool is_no_gap(double step, double dt) { return step > 0 && step < 3 * dt; }

// The mean of the steps that are no gaps. Where samples come in pairs, half of the steps are near 0, and so may be
// their median, `dt`: what is a gap is judged by the mean of all but the longest steps.
double mean_of(const std::vector<double>& steps, double dt) {
  constexpr int kRounds = 3;
  constexpr double kMost = 0.99;  // share of the steps
  std::vector<double> most = steps;
  std::sort(most.begin(), most.end());
  most.resize(static_cast<std::size_t>(std::ceil(kMost * static_cast<double>(most.size()))));
  double sum = 0;
  for (const double step : most) sum += step;
  dt = std::max(dt, sum / static_cast<double>(most.size()));
  for (int round = 0; round < kRounds; ++round) {
    sum = 0;
    int count = 0;
    for (const double step : steps) {
      if (!is_no_gap(step, dt)) continue;
      sum += step;
      ++count;
    }
    dt = sum / std::max(count, 1);
  }
  return dt;
}

// How far steps are from whole numbers of dt, one at least, as a standard deviation divided by dt: samples that are
// missing make no jitter.
double jitter_of(const std::vector<double>& steps, double dt) {
  double sum = 0;
  for (const double step : steps) sum += std::pow(step / dt - std::max(1.0, std::round(step / dt)), 2);
  return std::sqrt(sum / static_cast<double>(steps.size()));
}

// How far the mean of the steps of a second is from dt, at most, divided by dt.
double drift_of(const std::vector<std::vector<double>>& runs, double dt) {
  double largest = 0;
  for (const std::vector<double>& steps : runs) {
    double sum = 0;
    int count = 0;
    for (const double step : steps) {
      if (!is_no_gap(step, dt)) continue;
      sum += step;
      if (++count * dt < 1) continue;
      largest = std::max(largest, std::abs(sum / count - dt) / dt);
      sum = 0;
      count = 0;
    }
  }
  return largest;
}

// The median size of a channel's differences of fourth order, which a smooth motion does not have: at the stamps, or at
// even times.
double roughness(const SampleRun& run, std::size_t channel, bool at_stamps, double dt) {
  constexpr std::size_t kNodes = 5;
  double times[kNodes] = {0, 1, 2, 3, 4};
  const std::vector<double> even = difference_weights(times);
  std::vector<double> sizes;
  for (std::size_t k = 0; k + kNodes <= run.size(); ++k) {
    bool is_whole = true;
    for (std::size_t j = 1; j < kNodes; ++j) is_whole &= is_no_gap(run[k + j][0] - run[k + j - 1][0], dt);
    if (!is_whole) continue;
    for (std::size_t j = 0; j < kNodes; ++j) times[j] = run[k + j][0];
    const std::vector<double> weights = at_stamps ? difference_weights(times) : even;
    double difference = 0;
    for (std::size_t j = 0; j < kNodes; ++j) difference += weights[j] * run[k + j][channel];
    sizes.push_back(std::abs(difference));
  }
  return sizes.empty() ? 0 : median(std::move(sizes));
}

// The run in which a channel moves most for its length; nullptr if it moves in none.
const SampleRun* liveliest(const std::vector<SampleRun>& runs, std::size_t channel) {
  const SampleRun* found = nullptr;
  double largest = 0;
  for (const SampleRun& run : runs) {
    if (run.empty()) continue;
    const auto [least, most] = std::minmax_element(
        run.begin(), run.end(), [channel](const auto& a, const auto& b) { return a[channel] < b[channel]; });
    const double size = ((*most)[channel] - (*least)[channel]) / static_cast<double>(run.size());
    if (size <= largest) continue;
    largest = size;
    found = &run;
  }
  return found;
}

// Whether the position that tells it most clearly is smoother at the stamps than at even times. Those that do not move
// tell nothing.
bool is_smoother_at_stamps(const LogLayout& layout, const std::vector<SampleRun>& runs, double dt) {
  constexpr double kClearly = 0.9;
  double clearest = 0;
  for (const int position : layout.positions_of_all()) {
    const auto channel = static_cast<std::size_t>(position);
    const SampleRun* const run = liveliest(runs, channel);
    if (run == nullptr) continue;
    const double stamped = roughness(*run, channel, true, dt), counted = roughness(*run, channel, false, dt);
    if (!(stamped > 0 && counted > 0)) continue;
    const double ratio = std::log(stamped / counted);
    if (std::abs(ratio) > std::abs(clearest)) clearest = ratio;
  }
  return clearest < std::log(kClearly);
}

}  // namespace

SampleClock sample_clock(const LogLayout& layout, const std::vector<SampleRun>& runs, ClockChoice choice) {
  SampleClock clock;
  clock.held = lines_held(runs);
  const std::vector<SampleRun> distinct = clock.leaves_out_repeats() ? without_repeats(runs) : runs;
  const std::vector<std::vector<double>> by_run = steps_of(distinct);
  const std::vector<double> steps = all_of(by_run);
  clock.dt = median(by_run.front());
  clock.jitter = jitter_of(steps, clock.dt);
  const double mean = mean_of(steps, clock.dt);
  const bool is_even = clock.jitter <= kUneven && mean < kPairs * clock.dt;
  if (choice != ClockChoice::stamped && is_even) return clock;
  clock.dt = mean;
  clock.drift = drift_of(by_run, mean);
  // Times of arrival do not drift away from those of samples.
  const bool is_stamped = choice == ClockChoice::automatic
                              ? clock.drift > kUneven || is_smoother_at_stamps(layout, distinct, clock.dt)
                              : choice == ClockChoice::stamped;
  clock.kind = is_stamped ? SampleClock::Kind::stamped : SampleClock::Kind::counted;
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
  return text + fmt::format(
                    "; samples are interpolated at their stamps by cubics onto steps of {:.4g} s. A signal at "
                    "the edge of the band is off by {:.1g} of its size then, and by {:.1g} where {:.2g} s are "
                    "bridged",
                    clock.dt, error_of_cubic(clock.dt, band), error_of_cubic(longest, band), longest);
}

bool RepeatFilter::is_repeat(const double* channels) {
  if (!clock_.leaves_out_repeats()) return false;
  const double since = channels[0] - last_[0];
  const bool is_same =
      has_last_ && since >= 0 && since < longest_ && std::equal(last_.begin() + 1, last_.end(), channels + 1);
  if (is_same) return true;
  last_.assign(channels, channels + last_.size());
  has_last_ = true;
  return false;
}

}  // namespace flatdyn

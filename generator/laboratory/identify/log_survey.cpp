// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/log_survey.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "laboratory/identify/log_reader.hpp"

namespace flatdyn {
namespace {

constexpr int kRuns = 64, kSamplesPerRun = 256;
constexpr double kLongestRepeat = 8;  // times dt

class Surveyor {
 public:
  Surveyor(const LogLayout& layout, const SampleClock& clock)
      : layout_(layout),
        clock_(clock),
        dt_(clock.dt),
        repeats_(clock, layout.channels(), kLongestRepeat * clock.dt),
        sample_(static_cast<std::size_t>(layout.channels())),
        all_(sample_.size()),
        runs_(sample_.size()),
        positions_(layout.positions_of_all()),
        bends_(positions_.size()) {
    result_.moves = !layout.has_rates || (layout.base > 0 && !layout.has_twist);
  }

  // Reads a run; returns false if the log ended before it did.
  bool read_run(LogReader& reader) {
    repeats_.restart();
    std::vector<std::vector<double>> run(sample_.size());
    restart();
    double last = 0;
    int count = 0;
    bool has_gap = false;
    for (; count < kSamplesPerRun && next(reader); ++count) {
      const bool is_gap = count > 0 && (sample_[0] <= last || sample_[0] - last > longest_step());
      has_gap |= is_gap;
      last = sample_[0];
      if (is_first_) first_time_ = last;
      is_first_ = false;
      if (is_gap) restart();
      stamps_.add(last);
      for (std::size_t c = 0; c < sample_.size(); ++c) {
        if (clock_.is_interpolated()) {
          all_[c].add(sample_[c], stamps_);
        } else {
          all_[c].add(sample_[c]);
        }
        run[c].push_back(sample_[c]);
      }
      result_.moves |= (layout_.has_rates && changes(layout_.qd(), layout_.joints)) ||
                       (layout_.has_twist && changes(layout_.twist(), LogLayout::kTwist));
    }
    const bool is_whole = count == kSamplesPerRun;
    result_.duration = std::max(result_.duration, last - first_time_);
    for (std::size_t i = 0; i < bends_.size() && !has_gap; ++i) {
      bends_[i].add(evenly(run, positions_[i]), lag());
    }
    if (!is_whole && !runs_.front().empty()) return is_whole;
    for (std::size_t c = 0; c < run.size(); ++c) {
      runs_[c].push_back(clock_.is_interpolated() ? typical_noise(run[c], run[0]) : typical_noise(run[c]));
    }
    return is_whole;
  }

  LogSurvey result() {
    for (std::size_t c = 0; c < all_.size(); ++c) {
      std::vector<ChannelNoise>& runs = runs_[c];
      const auto middle = runs.begin() + static_cast<std::ptrdiff_t>(runs.size() / 2);
      std::nth_element(runs.begin(), middle, runs.end(),
                       [](const ChannelNoise& a, const ChannelNoise& b) { return a.deviation < b.deviation; });
      result_.typical.push_back(*middle);
      result_.all.push_back(all_[c].noise());
    }
    for (std::size_t i = 0; i < bends_.size(); ++i) {
      const double noise = result_.all[static_cast<std::size_t>(positions_[i])].deviation;
      result_.ranges.push_back({positions_[i], std::max(0.0, bends_[i].largest - bends_[i].least),
                                bends_[i].acceleration_square(noise, lag() * dt_),
                                bends_[i].speed_square(noise, lag() * dt_)});
    }
    return result_;
  }

 private:
  // How a position changes: second differences of samples that are a lag apart.
  struct Bends {
    double least = std::numeric_limits<double>::infinity(), largest = -least;
    double squares = 0, steps = 0;
    long count = 0, steps_count = 0;

    void add(const std::vector<double>& run, int lag) {
      for (const double value : run) {
        least = std::min(least, value);
        largest = std::max(largest, value);
      }
      const auto step = static_cast<std::size_t>(lag);
      for (std::size_t k = step; k < run.size(); ++k) {
        const double change = run[k] - run[k - step];
        steps += change * change;
        ++steps_count;
      }
      for (std::size_t k = 2 * step; k < run.size(); ++k) {
        squares += std::pow(run[k] - 2 * run[k - step] + run[k - 2 * step], 2);
        ++count;
      }
    }
    double speed_square(double noise, double time) const {
      if (steps_count == 0) return 0;
      return std::max(0.0, steps / static_cast<double>(steps_count) - 2 * noise * noise) / (time * time);
    }
    double acceleration_square(double noise, double time) const {
      if (count == 0) return 0;
      return std::max(0.0, squares / static_cast<double>(count) - 6 * noise * noise) / std::pow(time, 4);
    }
  };

  void restart() {
    for (ChannelNoiseMeter& meter : all_) meter.restart();
    stamps_.restart();
  }

  // The next sample that does not repeat the one before.
  bool next(LogReader& reader) {
    while (reader.next(sample_.data())) {
      if (!repeats_.is_repeat(sample_.data())) return true;
    }
    return false;
  }

  double longest_step() const {
    constexpr double kEven = 1.5, kUneven = 3;  // times dt
    return (clock_.kind == SampleClock::Kind::even ? kEven : kUneven) * dt_;
  }

  // A channel of a run, dt apart.
  std::vector<double> evenly(const std::vector<std::vector<double>>& run, int channel) const {
    const std::vector<double>&times = run[0], &values = run[static_cast<std::size_t>(channel)];
    if (!clock_.is_interpolated() || times.size() < 2) return values;
    std::vector<double> even;
    std::size_t k = 1;
    for (double t = times.front(); t <= times.back(); t += dt_) {
      while (k + 1 < times.size() && times[k] < t) ++k;
      const double part = (t - times[k - 1]) / (times[k] - times[k - 1]);
      even.push_back(values[k - 1] + part * (values[k] - values[k - 1]));
    }
    return even;
  }

  bool changes(int first, int count) const {
    const auto rates = sample_.begin() + first;
    return std::any_of(rates, rates + count, [](double rate) { return rate != 0; });
  }

  int lag() const {
    constexpr double kTime = 0.1;  // s
    return std::clamp(static_cast<int>(std::lround(kTime / dt_)), 1, (kSamplesPerRun - 1) / 2);
  }

  const LogLayout& layout_;
  const SampleClock& clock_;
  double dt_;
  RepeatFilter repeats_;
  StampDifferences stamps_;
  std::vector<double> sample_;
  std::vector<ChannelNoiseMeter> all_;
  std::vector<std::vector<ChannelNoise>> runs_;
  std::vector<int> positions_;  // channels
  std::vector<Bends> bends_;    // of these
  bool is_first_ = true;
  double first_time_ = 0;
  LogSurvey result_;
};

}  // namespace

// A log that ends within the first runs is read whole; of a longer one, runs at even places of the file are.
LogSurvey survey(const std::filesystem::path& log, const LogHeading& heading, const SampleClock& clock) {
  Diagnostics unheard;
  LogReader reader(log, heading, unheard);
  Surveyor surveyor(heading.layout, clock);
  for (int run = 0; run < kRuns; ++run) {
    if (!surveyor.read_run(reader)) return surveyor.result();
  }
  for (int run = 1; run < kRuns; ++run) {
    reader.jump(static_cast<double>(run) / kRuns);
    surveyor.read_run(reader);
  }
  return surveyor.result();
}

}  // namespace flatdyn

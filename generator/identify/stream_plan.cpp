// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "identify/log_reader.hpp"
#include "identify/motion_stream.hpp"
#include "identify/position_check.hpp"
#include "identify/zero_phase.hpp"

namespace flatdyn {
namespace {

constexpr int kSurveyed = 8192;
constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

struct SurveyedSample {
  std::vector<double> channels;
  Place place;
};

std::vector<SurveyedSample> first_samples(LogReader& reader) {
  std::vector<SurveyedSample> samples;
  std::vector<double> channels(static_cast<std::size_t>(reader.layout().channels()));
  while (samples.size() < kSurveyed && reader.next(channels.data())) samples.push_back({channels, reader.place()});
  return samples;
}

std::vector<double> time_steps(const std::vector<SurveyedSample>& samples) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < samples.size(); ++k) {
    steps.push_back(samples[k].channels[0] - samples[k - 1].channels[0]);
  }
  return steps;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Of the steps that are no gaps, over dt.
double jitter_of(const std::vector<double>& steps, double dt) {
  double sum = 0;
  int count = 0;
  for (const double step : steps) {
    if (std::abs(step - dt) > dt / 2) continue;
    sum += (step - dt) * (step - dt);
    ++count;
  }
  return std::sqrt(sum / count) / dt;
}

class UnitChecks {
 public:
  UnitChecks(const Mechanism& mechanism, const LogLayout& layout, double dt, const std::vector<SurveyedSample>& samples,
             Diagnostics& diagnostics)
      : mechanism_(mechanism), layout_(layout), dt_(dt), samples_(samples), diagnostics_(diagnostics) {}

  void run() {
    check_positions();
    for (int i = 0; i < mechanism_.position_count(); ++i) {
      if (!mechanism_.joint_at(i).prismatic) check_speed(i);
    }
    for (int i = 0; i < mechanism_.size(); ++i) {
      if (layout_.has_rates) {
        check_derivative(LogLayout::q() + mechanism_.position_of(i), layout_.qd() + i, i, "q", "qd");
      }
      if (layout_.has_rates && layout_.has_accelerations) {
        check_derivative(layout_.qd() + i, layout_.qdd() + i, i, "qd", "qdd");
      }
    }
  }

 private:
  // Errors alone: what is a warning is said when the whole log is read.
  void check_positions() {
    PositionCheck positions(mechanism_);
    for (const SurveyedSample& sample : samples_) {
      Diagnostics found;
      if (positions.accepts(sample.channels.data(), sample.place, found)) continue;
      diagnostics_.add(found.all().back());
      return;
    }
  }

  // No robot's joint turns so fast, but many degrees pass in a second. Times that jitter make no speed.
  void check_speed(int i) {
    constexpr double kFastest = 100;
    const auto q = static_cast<std::size_t>(LogLayout::q() + i);
    for (std::size_t k = 1; k < samples_.size(); ++k) {
      const auto& before = samples_[k - 1].channels;
      const auto& after = samples_[k].channels;
      const double speed = std::abs(after[q] - before[q]) / std::max(after[0] - before[0], dt_ / 2);
      if (speed <= kFastest) continue;
      diagnostics_.warning(
          samples_[k].place,
          fmt::format("q{} changes by {:.3g} rad in {:.3g} s", i + 1, after[q] - before[q], after[0] - before[0]),
          fmt::format("are these degrees? Then write the column's heading as q{} [deg]; and an angle must not jump by "
                      "whole turns",
                      i + 1));
      return;
    }
  }

  // Slope of the differences of one channel over the mean of another: 1 if that is its derivative.
  void check_derivative(int channel, int rate, int i, const std::string& name, const std::string& rate_name) {
    double products = 0, squares = 0;
    for (std::size_t k = 1; k < samples_.size(); ++k) {
      const auto& before = samples_[k - 1].channels;
      const auto& after = samples_[k].channels;
      const auto c = static_cast<std::size_t>(channel), r = static_cast<std::size_t>(rate);
      const double expected = (after[r] + before[r]) / 2 * (after[0] - before[0]);
      products += (after[c] - before[c]) * expected;
      squares += expected * expected;
    }
    if (squares == 0) return;
    const double slope = products / squares;
    const auto near = [slope](double value) { return slope > value / 2 && slope < value * 2; };
    const std::string what =
        fmt::format("{0}{1} is not the rate of change of {2}{1}: {2}{1} changes {3:.3g} times as fast", rate_name,
                    i + 1, name, slope);
    const Place place = samples_.front().place;
    if (near(kDegreesPerRadian)) {
      diagnostics_.error(place, what, fmt::format("is {}{} in degrees? Write its unit into the heading", name, i + 1));
    } else if (near(1 / kDegreesPerRadian)) {
      diagnostics_.error(place, what,
                         fmt::format("is {}{} in degrees? Write its unit into the heading", rate_name, i + 1));
    } else if (!near(1)) {
      diagnostics_.warning(place, what, "check units, signs and delays of the columns");
    }
  }

  const Mechanism& mechanism_;
  const LogLayout& layout_;
  double dt_;
  const std::vector<SurveyedSample>& samples_;
  Diagnostics& diagnostics_;
};

void check_time(double dt, const Place& place, Diagnostics& diagnostics) {
  constexpr double kSlow = 1;
  if (dt < kSlow) return;
  diagnostics.warning(place, fmt::format("from one sample to the next, {:.6g} s pass", dt),
                      "are these milliseconds? Then write the column's heading as t [ms]");
}

void choose_filter(StreamPlan& plan, const StreamOptions& options, const Place& place, Diagnostics& diagnostics) {
  constexpr double kDefaultBand = 10, kUnevenTime = 0.02;
  const double rate = 1 / plan.dt;
  const bool derivatives_missing = !plan.layout().has_rates || !plan.layout().has_accelerations;
  if (options.band) {
    plan.band = *options.band;
  } else if (derivatives_missing) {
    plan.band = std::min(kDefaultBand, rate / 8);
  }
  if (plan.band * 3 >= rate) {
    diagnostics.error(place, fmt::format("a band of {} Hz is too wide for {:.6g} samples a second", plan.band, rate),
                      fmt::format("--band less than a third of the sampling rate, {:.4g} Hz", rate / 3));
    return;
  }
  const double samples_per_band = plan.band > 0 ? rate / (3 * plan.band) : 1;
  plan.decimate = options.decimate.value_or(std::max(1, static_cast<int>(samples_per_band)));
  if (plan.band > 0) plan.half_window = zero_phase_half_window(plan.band, plan.dt);
  if (plan.band > 0 && plan.jitter > kUnevenTime) {
    diagnostics.warning(
        place, fmt::format("time is not even: steps differ by {:.1f} % of {:.4g} s", 100 * plan.jitter, plan.dt),
        "the filter and the derivatives assume that it is");
  }
  if (plan.half_window >= kBlock / 2) {
    diagnostics.error(place,
                      fmt::format("a band of {} Hz needs a window of {} samples", plan.band, 2 * plan.half_window + 1),
                      "choose a wider --band, or thin out the log");
  }
}

}  // namespace

// Noise of power 1 at every sample is Σ w² after the filter, and of the same density below its edge. White noise at one
// sample of N has that density if it is of power 1/N.
double StreamPlan::correlation() const {
  if (band == 0) return 1;
  double power = 0;
  for (const double w : zero_phase_kernel(band, dt).weights[0]) power += w * w;
  return std::max(1.0, 1 / (decimate * power));
}

StreamPlan plan_stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamOptions& options,
                       Diagnostics& diagnostics) {
  LogReader reader(log, mechanism, options.torques, diagnostics);
  StreamPlan plan;
  if (diagnostics.has_errors()) return plan;
  plan.heading = reader.heading();
  const std::vector<SurveyedSample> samples = first_samples(reader);
  if (diagnostics.has_errors()) return plan;
  if (samples.size() < 2) {
    diagnostics.error(reader.place(), fmt::format("{} samples: too few for a motion", samples.size()),
                      "a line for each instant, below the heading");
    return plan;
  }
  const std::vector<double> steps = time_steps(samples);
  plan.dt = median(steps);
  plan.jitter = jitter_of(steps, plan.dt);
  UnitChecks(mechanism, plan.layout(), plan.dt, samples, diagnostics).run();
  check_time(plan.dt, {log.string(), 1}, diagnostics);
  choose_filter(plan, options, {log.string(), 1}, diagnostics);
  return plan;
}

}  // namespace flatdyn

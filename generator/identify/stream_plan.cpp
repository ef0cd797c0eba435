// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identify/log_reader.hpp"
#include "identify/motion_stream.hpp"
#include "identify/position_check.hpp"
#include "identify/rate_check.hpp"
#include "identify/zero_phase.hpp"
#include "input/csv/clock.hpp"

namespace flatdyn {
namespace {

constexpr int kSurveyed = 8192;

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

// The jitter of the steps that are not gaps, divided by dt.
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

// Reports a time between samples that is long for a log. If rates tell the unit, it is that one. Rates that agree with
// no unit, or are all zero, belong to poses, which may be any time apart. Otherwise the size of the steps decides.
void check_time(const RateCheck& rates, const StreamPlan& plan, const Place& place, Diagnostics& diagnostics) {
  const double dt = plan.filter.dt;
  if (dt < kFarApart) return;
  const char* const unit = plan.layout().has_rates ? rates.unit_of_times() : unit_by_size(dt);
  if (unit != nullptr) warn_of_time_unit(dt, unit, plan.heading.channel_names().front(), place, diagnostics);
}

// Reports only errors of positions and rates, before a long log is read; warnings follow when all of it is.
void check_units(const Mechanism& mechanism, const StreamPlan& plan, const std::vector<SurveyedSample>& samples,
                 const Place& heading, Diagnostics& diagnostics) {
  PositionCheck positions(mechanism, plan.heading);
  RateCheck rates(mechanism, plan.heading, plan.filter.dt);
  Diagnostics found;
  for (const SurveyedSample& sample : samples) {
    if (!positions.accepts(sample.channels.data(), sample.place, found)) break;
    rates.add(
        sample.channels.data(), [&] { return sample.place; }, found);
  }
  if (!found.has_errors()) rates.finish(samples.front().place, found);
  for (const Diagnostic& each : found.all()) {
    if (each.severity == Severity::error) diagnostics.add(each);
  }
  check_time(rates, plan, heading, diagnostics);
}

void choose_filter(StreamPlan& plan, const StreamOptions& options, const Place& place, Diagnostics& diagnostics) {
  constexpr double kDefaultBand = 10, kUnevenTime = 0.02;
  auto& [dt, band, decimate] = plan.filter;
  const double rate = 1 / dt;
  const bool derivatives_missing = !plan.layout().has_rates || !plan.layout().has_accelerations;
  if (options.band) {
    band = *options.band;
  } else if (derivatives_missing) {
    band = std::min(kDefaultBand, rate / 8);
  }
  if (band * 3 >= rate) {
    diagnostics.error(place, fmt::format("a band of {} Hz is too wide for {:.6g} samples a second", band, rate),
                      fmt::format("--band less than a third of the sampling rate, {:.4g} Hz", rate / 3));
    return;
  }
  const double samples_per_band = band > 0 ? rate / (3 * band) : 1;
  decimate = options.decimate.value_or(std::max(1, static_cast<int>(samples_per_band)));
  if (band > 0 && plan.jitter > kUnevenTime) {
    diagnostics.warning(place,
                        fmt::format("time is not even: steps differ by {:.1f} % of {:.4g} s", 100 * plan.jitter, dt),
                        "the filter and the derivatives assume that it is");
  }
  const int half_window = plan.filter.half_window();
  if (half_window >= kBlock / 2) {
    diagnostics.error(place, fmt::format("a band of {} Hz needs a window of {} samples", band, 2 * half_window + 1),
                      "choose a wider --band, or thin out the log");
  }
}

}  // namespace

int SampleFilter::half_window() const { return band > 0 ? zero_phase_half_window(band, dt) : 0; }

// The correlation of the filtered noise. Noise of power 1 at every sample has power Σ w² after the filter and keeps its
// density below the edge. White noise at every N-th sample has that density if its power is 1/N.
double SampleFilter::correlation() const {
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
  plan.filter.dt = median(steps);
  plan.jitter = jitter_of(steps, plan.filter.dt);
  check_units(mechanism, plan, samples, {log.string(), 1}, diagnostics);
  choose_filter(plan, options, {log.string(), 1}, diagnostics);
  return plan;
}

}  // namespace flatdyn

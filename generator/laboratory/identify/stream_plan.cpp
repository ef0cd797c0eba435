// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "laboratory/identify/even_samples.hpp"
#include "laboratory/identify/log_reader.hpp"
#include "laboratory/identify/log_survey.hpp"
#include "laboratory/identify/motion_stream.hpp"
#include "laboratory/identify/noise_shape.hpp"
#include "laboratory/identify/position_check.hpp"
#include "laboratory/identify/rate_check.hpp"
#include "laboratory/identify/zero_phase.hpp"
#include "robot/input/csv/clock.hpp"

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

// Reports a time between samples that is long for a log. If rates show the unit, it is that one. Rates that agree with
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
  RateCheck rates(mechanism, plan.heading, plan.filter.dt, plan.moves);
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

// Reports temperatures that no drive has in degrees Celsius.
void check_temperatures(const StreamPlan& plan, const SurveyedSample& first, Diagnostics& diagnostics) {
  constexpr double kColdest = -100, kHottest = 200;  // °C
  const LogLayout& layout = plan.layout();
  const std::vector<std::string> names = plan.heading.channel_names();
  for (int i = 0; i < layout.joints && layout.has_temperatures; ++i) {
    const auto at = static_cast<std::size_t>(layout.temperatures() + i);
    const double temperature = first.channels[at];
    if (temperature > kColdest && temperature < kHottest) continue;
    diagnostics.error(first.place, fmt::format("{} is {:.6g} degrees Celsius", names[at], temperature),
                      "take 273.15 off kelvins; a column of another unit is not a temperature");
    return;
  }
}

// Three rows per period of the band, of which each is a whole number of strides behind the one before it.
int default_decimation(double band, double rate) {
  constexpr double kRowsPerBand = 3;
  if (band == 0) return 1;
  const int stride = std::max(1, static_cast<int>(rate / (SampleFilter::kMotionsPerBand * band)));
  return stride * std::max(1, static_cast<int>(rate / (kRowsPerBand * band * stride)));
}

// The frequency of a sine whose acceleration and speed have the ratio that a joint's have, Hz: the median of all that
// move.
double typical_frequency(const LogSurvey& log) {
  std::vector<double> all;
  for (const PositionRange& each : log.ranges) {
    if (each.speed_square > 0 && each.acceleration_square > 0) {
      all.push_back(std::sqrt(each.acceleration_square / each.speed_square) / (2 * std::numbers::pi));
    }
  }
  if (all.empty()) return 0;
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

// The band where --band is not given, Hz. An encoder's noise grows in accelerations with the band's fifth power, and
// that of coarse steps is not white, so that nothing takes it off exactly. Where it would be a considerable share of a
// joint's acceleration, the band is so low that it is a small one, unless its edges then took too much of the log, or
// it cut the motion off. The share of a joint that moves little counts for nothing: it would take the band from the
// others.
double default_band(const StreamPlan& plan, const LogSurvey& log) {
  constexpr double kDefault = 10, kLeast = 1, kHighest = 0.125;  // Hz; Hz; of the sampling rate
  constexpr double kConsiderable = 2e-3, kSmall = 2e-4;          // shares of noise, squared
  constexpr double kMoves = 1000;                                // standard deviations of noise
  constexpr double kEdges = 40;                                  // periods of the band that a log has, at least
  constexpr double kTimesMotion = 6;                             // the motion's frequency
  const double dt = plan.filter.dt, band = std::min(kDefault, kHighest / dt);
  if (plan.layout().has_rates || log.duration <= 0) return band;
  const double power = noise_shape({dt, band, default_decimation(band, 1 / dt)}, {2}).acceleration[0][0];
  double share = 0;
  for (const PositionRange& each : log.ranges) {
    const double noise = log.all[static_cast<std::size_t>(each.channel)].deviation;
    if (each.size > kMoves * noise) share = std::max(share, power * noise * noise / each.acceleration_square);
  }
  if (!(share > kConsiderable)) return band;
  const double lowest = std::max({kLeast, kEdges / log.duration, kTimesMotion * typical_frequency(log)}),
               wanted = band * std::pow(kSmall / share, 0.2);
  return std::min(band, std::round(10 * std::max(wanted, lowest)) / 10);
}

// The first samples, and runs from all over the log: a robot often rests first.
std::vector<SampleRun> runs_of(const std::filesystem::path& log, const LogHeading& heading,
                               const std::vector<SurveyedSample>& first) {
  constexpr int kFurther = 16, kLength = 1024;
  std::vector<SampleRun> runs(1);
  for (const SurveyedSample& sample : first) runs.front().push_back(sample.channels);
  if (first.size() < kSurveyed) return runs;
  Diagnostics unheard;
  LogReader reader(log, heading, unheard);
  std::vector<double> channels(first.front().channels.size());
  for (int run = 1; run < kFurther; ++run) {
    reader.jump(static_cast<double>(run) / kFurther);
    runs.emplace_back();
    for (int k = 0; k < kLength && reader.next(channels.data()); ++k) runs.back().push_back(channels);
  }
  return runs;
}

void tell_of_clock(const StreamPlan& plan, const Place& place, Diagnostics& diagnostics) {
  const std::string text = clock_text(plan.clock, longest_bridge(plan.filter), plan.filter.band);
  if (text.empty()) return;
  if (plan.clock.kind == SampleClock::Kind::counted) {
    diagnostics.warning(place, text, "--resample stamps takes them at their stamps");
  } else {
    const char* const hint = plan.clock.is_interpolated() ? "--resample off takes samples as evenly apart" : "";
    diagnostics.note(place, text, hint, "clocks that are not even");
  }
}

void choose_filter(StreamPlan& plan, const StreamOptions& options, const LogSurvey& log, const Place& place,
                   Diagnostics& diagnostics) {
  auto& [dt, band, decimate] = plan.filter;
  const double rate = 1 / dt;
  const bool derivatives_missing = !plan.layout().has_all_derivatives();
  if (options.band) {
    band = *options.band;
  } else if (derivatives_missing) {
    band = default_band(plan, log);
  }
  if (band * 3 >= rate) {
    diagnostics.error(place, fmt::format("a band of {} Hz is too wide for {:.6g} samples a second", band, rate),
                      fmt::format("--band less than a third of the sampling rate, {:.4g} Hz", rate / 3));
    return;
  }
  decimate = options.decimate.value_or(default_decimation(band, rate));
  if (band > 0) tell_of_clock(plan, place, diagnostics);
  const int half_window = plan.filter.half_window();
  if (plan.lines_of(half_window) >= kBlock / 2) {
    diagnostics.error(
        place,
        fmt::format("a band of {} Hz needs a window of {} samples that are {:.4g} s apart", band, 2 * half_window + 1,
                    dt),
        fmt::format("is the unit of the column \"{}\" right? Otherwise choose a wider --band, or thin out the log",
                    plan.heading.channel_names().front()));
  }
}

double norm(const std::vector<double>& weights) {
  double squares = 0;
  for (const double w : weights) squares += w * w;
  return std::sqrt(squares);
}

// Below this speed a joint may stand still: five standard deviations of the noise in its filtered speed. The reading of
// an encoder that creeps is no white noise: steps that follow each other slower than the filter's edge pass it.
double rest_speed_of(const StreamPlan& plan, const LogSurvey& log, int position, int joint) {
  constexpr double kDeviations = 5;
  constexpr double kLeast = 2e-4;  // rad/s or m/s: nothing is told by so slow a motion
  const LogLayout& layout = plan.layout();
  const auto at = [](int channel) { return static_cast<std::size_t>(channel); };
  const double band = plan.filter.band;
  if (layout.has_rates) {
    const double noise = log.typical[at(layout.qd() + joint)].deviation;
    const double part = band > 0 ? norm(zero_phase_kernel(plan.filter.motion_band(), plan.filter.dt).weights[0]) : 1;
    return std::max(kDeviations * noise * part, kLeast);
  }
  const auto [step, deviation] = log.all[at(LogLayout::q() + position)];
  const double growth = norm(zero_phase_kernel(plan.filter.motion_band(), plan.filter.dt).weights[1]);
  return std::max({kDeviations * deviation * growth, plan.filter.motion_band() * step, kLeast});
}

void set_rest_speeds(StreamPlan& plan, const LogSurvey& log, const Mechanism& mechanism,
                     const std::vector<double>& given, const Place& place, Diagnostics& diagnostics) {
  const std::size_t n = mechanism.joints().size();
  if (given.size() > 1 && given.size() != n) {
    diagnostics.error(place, fmt::format("--rest-speed has {} numbers, and the robot has {} joints", given.size(), n),
                      "one number for all joints, or one for each");
    return;
  }
  const int base = mechanism.base_bodies();
  plan.rest_speed.assign(static_cast<std::size_t>(base), 0);
  for (std::size_t i = 0; i < n; ++i) {
    const auto joint = static_cast<int>(i);
    const int position = mechanism.position_of(base + joint), turns = plan.layout().spherical_of(base + joint) ? 2 : 1;
    double speed = log.moves ? turns * rest_speed_of(plan, log, position, joint) : 0;
    if (!given.empty()) speed = given.size() == 1 ? given.front() : given[i];
    plan.rest_speed.push_back(speed);
  }
}

}  // namespace

StreamPlan plan_stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamOptions& options,
                       Diagnostics& diagnostics) {
  LogReader reader(log, mechanism, {options.torques, options.temperatures}, diagnostics, options.rate.value_or(0));
  StreamPlan plan;
  if (diagnostics.has_errors()) return plan;
  plan.heading = reader.heading();
  plan.sensors = base_sensors(mechanism, options.imu);
  if (!options.imu.empty() && plan.layout().base_motion != BaseMotion::imu) {
    diagnostics.warning({log.string(), 1}, "--imu has no effect: the log has no columns imu_ax to imu_wz",
                        "leave --imu out, or log the measurement unit");
  }
  const std::vector<SurveyedSample> samples = first_samples(reader);
  if (diagnostics.has_errors()) return plan;
  if (samples.size() < 2) {
    diagnostics.error(reader.place(), fmt::format("{} samples: too few for a motion", samples.size()),
                      "a line for each instant, below the heading");
    return plan;
  }
  plan.clock = sample_clock(plan.layout(), runs_of(log, plan.heading, samples), options.clock);
  plan.filter.dt = plan.clock.dt;
  plan.delay = options.delay;
  plan.start = samples.front().channels.front();
  const Place heading{log.string(), 1};
  check_units(mechanism, plan, samples, heading, diagnostics);
  check_temperatures(plan, samples.front(), diagnostics);
  if (diagnostics.has_errors()) return plan;
  const LogSurvey found = survey(log, plan.heading, plan.clock);
  choose_filter(plan, options, found, heading, diagnostics);
  if (diagnostics.has_errors()) return plan;
  plan.moves = found.moves;
  set_rest_speeds(plan, found, mechanism, options.rest_speed, heading, diagnostics);
  const LogLayout& layout = plan.layout();
  plan.noise = found.all;
  if (layout.has_torques) {
    const auto first = found.typical.begin() + layout.tau();
    plan.tau_noise.assign(first, first + layout.rates());
  }
  return plan;
}

}  // namespace flatdyn

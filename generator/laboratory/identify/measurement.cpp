// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/identify/measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "robot/input/common/content_hash.hpp"

namespace flatdyn {
namespace {

LogIdentity identity_of(const std::filesystem::path& log) {
  constexpr std::size_t kBeginning = 65536;
  std::string beginning(kBeginning, '\0');
  std::ifstream file(log, std::ios::binary);
  file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(file.gcount()));
  return {log.filename().string(), std::filesystem::file_size(log), content_hash({beginning})};
}

struct PlannedLog {
  std::filesystem::path path;
  StreamPlan plan;
  LogIdentity identity;
};

// The logs in the order of their identities: a shell on another machine may list them in another order, and the share
// of each part depends on it.
std::vector<PlannedLog> planned_logs(const EquationModel& equations, const Mechanism& mechanism,
                                     const std::vector<std::filesystem::path>& logs, const StreamOptions& options,
                                     Diagnostics& diagnostics) {
  std::vector<PlannedLog> planned;
  for (const std::filesystem::path& log : logs) {
    StreamPlan plan = plan_stream(log, mechanism, options, diagnostics);
    if (!diagnostics.has_errors()) equations.require(plan.layout(), {log.string(), 1}, diagnostics);
    if (diagnostics.has_errors()) return planned;
    planned.push_back({log, std::move(plan), identity_of(log)});
  }
  std::stable_sort(planned.begin(), planned.end(),
                   [](const PlannedLog& a, const PlannedLog& b) { return a.identity < b.identity; });
  for (std::size_t k = 1; k < planned.size(); ++k) {
    if (planned[k].identity != planned[k - 1].identity) continue;
    diagnostics.error({planned[k].path.string(), 0},
                      fmt::format("the same log as {}, by name, size and beginning", planned[k - 1].path.string()),
                      "what is given twice would count as new data; a log of another motion needs another name");
  }
  return planned;
}

// The noise of a quaternion's four entries as that of the rotations that they describe: they contain the sine of half
// the angle.
ChannelNoise turning_noise(const StreamPlan& plan, int position) {
  double squares = 0;
  for (int k = 0; k < LogLayout::kQuaternion; ++k) squares += std::pow(plan.q_noise(position + k).deviation, 2);
  return {0, std::sqrt(squares)};
}

// By entry of q̈: the noise of the base's readings, and of the joint's position where that is differentiated twice.
std::vector<ChannelNoise> noise_of_motion(const StreamPlan& plan, const std::vector<int>& orders) {
  const LogLayout& layout = plan.layout();
  std::vector<ChannelNoise> result = base_noise(layout, plan.sensors, plan.noise);
  for (std::size_t i = result.size(); i < orders.size(); ++i) {
    const std::optional<std::size_t> spherical = layout.spherical_of(static_cast<int>(i));
    result.push_back(orders[i] != 2 ? ChannelNoise{}
                     : spherical    ? turning_noise(plan, layout.spherical_positions[*spherical])
                                    : plan.q_noise(layout.position_of[i]));
  }
  return result;
}

// Rows times the roots of their weights.
class WeightedRows {
 public:
  explicit WeightedRows(const EquationModel& model) : model_(model) {}

  // The result is valid as long as this object.
  FilteredEquations weighted(FilteredEquations rows, const RowWeight& weight) {
    entries_.assign(rows.entries, rows.entries + model_.entries());
    right_.assign(rows.right, rows.right + model_.equations());
    auto entry = entries_.begin();
    for (int i = 0; i < model_.equations(); ++i) {
      const double root = std::sqrt(weight(rows, i));
      right_[static_cast<std::size_t>(i)] *= root;
      const auto end = entry + static_cast<std::ptrdiff_t>(model_.columns()[static_cast<std::size_t>(i)].size());
      for (; entry != end; ++entry) *entry *= root;
    }
    rows.entries = entries_.data();
    rows.right = right_.data();
    return rows;
  }

 private:
  const EquationModel& model_;
  std::vector<double> entries_, right_;
};

// The variance that noise of positions has at most: little more than they show above the band, which is an estimate. A
// slow motion may have all noise of an encoder's steps in the band.
double most_of_noise(const ChannelNoise& noise, const SampleFilter& filter) {
  constexpr double kMore = 1.5;
  if (noise.deviation == 0 || filter.band == 0) return std::numeric_limits<double>::infinity();
  const double in_band = 1 / (2 * filter.band * filter.dt);
  return noise.deviation * noise.deviation * (noise.is_of_steps() ? std::max(kMore, in_band) : kMore);
}

}  // namespace

std::vector<SampleFilter> Measurement::filters() const {
  std::vector<SampleFilter> different;
  for (const MeasuredLog& log : logs) {
    if (std::find(different.begin(), different.end(), log.filter) == different.end()) different.push_back(log.filter);
  }
  return different;
}

std::vector<double> Measurement::rest_speeds() const {
  std::vector<double> largest;
  for (const MeasuredLog& log : logs) {
    largest.resize(log.rest_speed.size(), 0);
    for (std::size_t i = 0; i < largest.size(); ++i) largest[i] = std::max(largest[i], log.rest_speed[i]);
  }
  return largest;
}

void set_shapes(Measurement& measurement) {
  double correlation = 1;
  for (const MeasuredLog& log : measurement.logs) {
    NoiseShape shape = noise_shape(log.filter, log.differentiations);
    for (const ChannelNoise& each : log.tau_noise) {
      if (log.filter.band > 0) shape.measured_deviations.push_back(each.deviation);
    }
    for (const ChannelNoise& each : log.q_noise) {
      shape.acceleration_deviations.push_back(each.deviation);
      shape.most_of_accelerations.push_back(most_of_noise(each, log.filter));
    }
    measurement.observations.shapes.push_back(std::move(shape));
    correlation = std::max(correlation, measurement.observations.shapes.back().correlation());
  }
  measurement.observations.set_correlation(correlation);
}

Measurement measure(const EquationModel& equations, const Mechanism& mechanism,
                    const std::vector<std::filesystem::path>& logs, const StreamOptions& options, Progress& progress,
                    Diagnostics& diagnostics, const RowWeight& weight, const LogSink& also) {
  ObservationFolder folder(equations);
  InstantSample instants;
  Measurement result;
  std::vector<PlannedLog> planned = planned_logs(equations, mechanism, logs, options, diagnostics);
  if (diagnostics.has_errors()) return result;
  BlockPartition shares(options.part, options.parts);
  for (PlannedLog& log : planned) {
    progress.step("reading " + log.path.string());
    const StreamPlan& plan = log.plan;
    const std::vector<int> orders = differentiations(plan);
    const NoiseShape shape = noise_shape(plan.filter, orders);
    const auto sink = [&, at = static_cast<int>(result.logs.size())](const FilteredEquations& filtered) {
      if (!shares.owns(filtered.line)) return;
      if (also) also(filtered, at);
      WeightedRows rows(equations);
      const FilteredEquations each = weight ? rows.weighted(filtered, weight) : filtered;
      folder.add(each);
      instants.offer(each, equations, at, shape);
      ++result.count.used;
    };
    EquationFilter filter(plan, equations, sink);
    const StreamCount count = stream(log.path, mechanism, plan, shares, filter, diagnostics);
    if (diagnostics.has_errors()) return result;
    result.count.add(count);
    result.logs.push_back({std::move(log.identity), plan.filter, orders, plan.rest_speed, noise_of_motion(plan, orders),
                           plan.tau_noise, plan.layout().has_currents, plan.layout().has_mixed_currents,
                           plan.layout().has_tip_force});
  }
  result.observations = folder.observations();
  instants.move_to(result.observations);
  set_shapes(result);
  if (options.parts == 1) leave_out_short_motions(result.observations, result.count.used);
  return result;
}

Measurement joined(const std::vector<Measurement>& measurements) {
  Measurement result = measurements.front();
  for (std::size_t k = 1; k < measurements.size(); ++k) {
    result.observations = joined(result.observations, measurements[k].observations);
    result.count.add(measurements[k].count);
  }
  return result;
}

}  // namespace flatdyn

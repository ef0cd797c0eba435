// SPDX-License-Identifier: GPL-2.0-or-later
// From logs to a measurement: the observations, and how they were made.
#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/diagnostics/progress.hpp"
#include "laboratory/identify/observations.hpp"

namespace flatdyn {

// Identifies a log wherever it lies: without its folder, and without reading all of it.
struct LogIdentity {
  std::string name;  // name of the file
  std::uintmax_t bytes = 0;
  std::string beginning;  // hash of the first bytes

  auto operator<=>(const LogIdentity&) const = default;
};

struct MeasuredLog {
  LogIdentity identity;
  SampleFilter filter;
  std::vector<int> differentiations{};  // by entry of q̈, differentiations()
  std::vector<double> rest_speed{};     // by entry of q̇, StreamPlan::rest_speed
  // By entry of q̈: the noise of the readings that it is made of; zero if not known.
  std::vector<ChannelNoise> q_noise{};
  std::vector<ChannelNoise> tau_noise{};  // by entry of τ
  bool has_currents = false;              // LogLayout::has_currents
  bool has_mixed_currents = false;        // LogLayout::has_mixed_currents
  bool has_tip_force = false;             // LogLayout::has_tip_force

  auto operator<=>(const MeasuredLog&) const = default;
};

// Whether the log is one of poses, whose rates are all zero.
inline bool is_held(const MeasuredLog& log) {
  return !log.differentiations.empty() && log.differentiations.front() == kHeld;
}

struct Measurement {
  Observations observations;
  StreamCount count;
  std::vector<MeasuredLog> logs;  // in the order of their identities

  // The distinct filters, in the order of the logs.
  std::vector<SampleFilter> filters() const;
  // By entry of q̇: the largest of all logs.
  std::vector<double> rest_speeds() const;
};

// The weight of an equation's square in the fit.
using RowWeight = std::function<double(const FilteredEquations& equations, int equation)>;
// Receives the filtered equations of a log, given by its index.
using LogSink = std::function<void(const FilteredEquations& equations, int log)>;

// Reads logs of a robot's motion. `weight` may be null: all rows then count alike. Errors go into `diagnostics`, such
// as a log that is given twice; after an error the result is meaningless.
Measurement measure(const EquationModel& equations, const Mechanism& mechanism,
                    const std::vector<std::filesystem::path>& logs, const StreamOptions& options, Progress& progress,
                    Diagnostics& diagnostics, const RowWeight& weight = nullptr, const LogSink& also = nullptr);

// Sets the noise shapes and correlations of the observations, from the logs.
void set_shapes(Measurement& measurement);

// Joins at least one measurement, all made by the same model.
Measurement joined(const std::vector<Measurement>& measurements);

}  // namespace flatdyn

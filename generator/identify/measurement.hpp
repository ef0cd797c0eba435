// SPDX-License-Identifier: GPL-2.0-or-later
// From logs to a measurement: the observations, and some samples to plot.
#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "identify/observations.hpp"

namespace flatdyn {

// A sample of a log, SI; arrays have one number per joint.
struct MotionSample {
  int log = 0;  // index into Measurement::logs
  double time = 0;
  std::vector<double> q, qd, qdd, tau;  // tau without the effect of the tip force
};

// Keeps at most kMost samples, spread evenly over all that were offered: when there are more, every other one is
// dropped.
class ThinnedSamples {
 public:
  static constexpr std::size_t kMost = 512;

  void offer(const TorqueModel& model, const MeasuredMotion& motion, int log);
  const std::vector<MotionSample>& kept() const { return kept_; }

 private:
  long offered_ = 0, stride_ = 1;
  std::vector<MotionSample> kept_;
};

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

  auto operator<=>(const MeasuredLog&) const = default;
};

struct Measurement {
  Observations observations;
  std::vector<MotionSample> samples;  // in the order of the logs, then of time
  StreamCount count;
  std::vector<MeasuredLog> logs;  // in the order of their identities

  // The distinct filters, in the order of the logs.
  std::vector<SampleFilter> filters() const;
  // The correlation of the noise in the observations: the largest of all logs.
  double correlation() const;
};

// Errors go into `diagnostics`, such as a log that is given twice; after an error the result is meaningless.
Measurement measure(const TorqueModel& model, const std::vector<std::filesystem::path>& logs,
                    const StreamOptions& options, Progress& progress, Diagnostics& diagnostics);

// Joins at least one measurement, all made by the same model.
Measurement joined(const std::vector<Measurement>& measurements);

}  // namespace flatdyn

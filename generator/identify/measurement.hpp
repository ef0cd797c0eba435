// SPDX-License-Identifier: GPL-2.0-or-later
// Logs → what they say: the observations, and some of the samples to draw.
#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "identify/observations.hpp"

namespace flatdyn {

struct MotionSample {
  int log = 0;  // its place in Measurement::logs
  double time = 0;
  std::vector<double> q, qd, qdd, tau;  // tau without what the tip's force adds
};

// Samples spread evenly over all that were offered, at most kMost of them: when there are more, every other one goes.
class ThinnedSamples {
 public:
  static constexpr std::size_t kMost = 512;

  void offer(const TorqueModel& model, const MeasuredMotion& motion, int log);
  const std::vector<MotionSample>& kept() const { return kept_; }

 private:
  long offered_ = 0, stride_ = 1;
  std::vector<MotionSample> kept_;
};

// What tells a log from others, wherever it lies: without its folder, and without reading all of it.
struct LogIdentity {
  std::string name;  // of the file
  std::uintmax_t bytes = 0;
  std::string beginning;  // a hash of it

  auto operator<=>(const LogIdentity&) const = default;
};

struct MeasuredLog {
  LogIdentity identity;
  SampleFilter filter;

  auto operator<=>(const MeasuredLog&) const = default;
};

struct Measurement {
  Observations observations;
  std::vector<MotionSample> samples;  // by log, then by time
  StreamCount count;
  std::vector<MeasuredLog> logs;  // in the order of their identities

  // All that differ, in the order of the logs.
  std::vector<SampleFilter> filters() const;
  // Of the noise in the observations: that of the log where it is largest.
  double correlation() const;
};

// What is wrong goes into `diagnostics`, the same log twice among it; after an error the result means nothing.
Measurement measure(const TorqueModel& model, const std::vector<std::filesystem::path>& logs,
                    const StreamOptions& options, Progress& progress, Diagnostics& diagnostics);

// Several, made by the same model; at least one.
Measurement joined(const std::vector<Measurement>& measurements);

}  // namespace flatdyn

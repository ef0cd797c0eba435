// SPDX-License-Identifier: GPL-2.0-or-later
// From log to motion: q, q̇, q̈, τ (and the tip force) at the samples that are used. Signals that the log lacks are
// derived from those it has; then every signal passes the same zero-phase low-pass filter, and every N-th sample is
// used.
#pragma once

#include <compare>
#include <filesystem>
#include <functional>
#include <optional>

#include "identify/block_partition.hpp"
#include "identify/log_layout.hpp"

namespace flatdyn {

// A sample in SI units, valid during the call: arrays of n numbers; tau is null if the log has none; h_e has 6 numbers,
// null if the log has none.
struct MeasuredMotion {
  double time = 0;
  const double *q = nullptr, *qd = nullptr, *qdd = nullptr, *tau = nullptr, *h_e = nullptr;
};
using MotionSink = std::function<void(const MeasuredMotion&)>;

struct StreamOptions {
  // The edge of the filter's pass band, Hz. None: 10 Hz, or an eighth of the sampling rate if that is less, if
  // derivatives are missing; no filter if the log has them all.
  std::optional<double> band = std::nullopt;
  // Every N-th sample is used. None: all samples without a filter; with one, at a rate of three bands, so that filtered
  // noise is nearly white.
  std::optional<int> decimate = std::nullopt;
  // Whether the log must have torques. If false, they are not read.
  bool torques = true;
  // The part k of N, k = 1 … N, whose lines are used.
  int part = 1, parts = 1;
};

// The step from logged samples to those that are used.
struct SampleFilter {
  double dt = 0;     // median time between samples of the log, s
  double band = 0;   // edge of the pass band, Hz; 0: no filter
  int decimate = 1;  // every N-th sample is used

  // The number of samples that the filter loses at either end.
  int half_window() const;
  // The correlation of filtered white noise, at least 1: this many used samples tell as much as one sample of white
  // noise of the same size.
  double correlation() const;

  auto operator<=>(const SampleFilter&) const = default;
};

// The way to read a log, decided from its heading and its first lines.
struct StreamPlan {
  LogHeading heading;
  double jitter = 0;  // standard deviation of the time between samples, divided by dt
  SampleFilter filter;

  const LogLayout& layout() const { return heading.layout; }
};

// Counts of what was read, without the samples of other parts.
struct StreamCount {
  long lines = 0, used = 0, gaps = 0;
};

// Reads the first lines. Certain signs of wrong units are errors: positions far outside the joint limits, q̇ and q̈ in
// degrees. Uneven or long times between samples are a warning.
StreamPlan plan_stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamOptions& options,
                       Diagnostics& diagnostics);

// Passes all used samples of a part to `sink`, in order. A gap in time restarts the filter. Wrong units are detected
// over all samples read: by q against the joint limits, by speeds that no robot has, and by q̇ and q̈ against the
// change of q. They are errors, or warnings if they may be right. A position far outside the limits ends the reading.
StreamCount stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamPlan& plan,
                   BlockPartition& shares, const MotionSink& sink, Diagnostics& diagnostics);
// Passes all used samples of the log to `sink`.
StreamCount stream(const std::filesystem::path& log, const Mechanism& mechanism, const StreamPlan& plan,
                   const MotionSink& sink, Diagnostics& diagnostics);

}  // namespace flatdyn
